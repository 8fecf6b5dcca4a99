"""Runs the whole chain of packs/run on the small packs: times, instructions, plots,
tables and report.

Usage: check.py PACKS_PROGRAM
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile

from benchmarks.common.pages import contents
from benchmarks.common.small_svg import check_picture
from benchmarks.common.tables import ROOT

PAGE_NAME = "benchmarks.md"
PAGE = os.path.join(ROOT, "docs", PAGE_NAME)


def run(command, output=None):
    if output is None:
        return subprocess.run(command, check=True)
    with open(output, "w") as file:
        file.write("# compiler: any\n")
        file.flush()
        return subprocess.run(command, check=True, stdout=file)


def check(program):
    with tempfile.TemporaryDirectory() as results:
        copy = shutil.copy(PAGE, results)
        run([program, "--quick"], os.path.join(results, "times.csv"))
        module = [sys.executable, "-B", "-m"]
        run([*module, "benchmarks.packs.count_instructions", program, "--quick",
             "--algorithm", "munjiza_nbs"], os.path.join(results, "instructions.csv"))
        run([*module, "benchmarks.packs.report", results, "--docs", copy, "--images", results])
        written = {name: contents(os.path.join(results, name)) for name in (PAGE_NAME, "report.md")}
        for name in ("packs_elements.svg", "packs_spacing.svg"):
            check_picture(os.path.join(results, name))
    for name, text in written.items():
        if "Measured on: compiler any" not in text:
            sys.exit(f"the tables of {name} were not written anew")
        if re.search(r"\b(nan|inf)\b", text):
            sys.exit(f"a table of {name} holds what is not a number")


if __name__ == "__main__":
    check(*sys.argv[1:])

"""Runs the whole chain of packs/run on the small packs: times, instructions, plots and tables.

Usage: check.py PACKS_PROGRAM
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile

from benchmarks.common.tables import ROOT

PAGE = os.path.join(ROOT, "docs", "benchmarks.md")


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
        with open(copy) as file:
            text = file.read()
        for name in ("packs_elements.svg", "packs_spacing.svg"):
            if os.path.getsize(os.path.join(results, name)) < 10_000:
                sys.exit(f"{name} is all but empty")
    if "compiler any" not in text:
        sys.exit("the tables of the page were not written anew")
    if re.search(r"\b(nan|inf)\b", text):
        sys.exit("a table of the page holds what is not a number")


if __name__ == "__main__":
    check(*sys.argv[1:])

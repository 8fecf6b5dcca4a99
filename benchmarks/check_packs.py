"""Runs the whole chain of run_packs on the small packs: times, instructions, plots and tables.

Usage: check_packs.py PACKS_PROGRAM BENCHMARKS_FOLDER DOCS_PAGE
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile


def run(command, output=None):
    if output is None:
        return subprocess.run(command, check=True)
    with open(output, "w") as file:
        file.write("# compiler: any\n")
        file.flush()
        return subprocess.run(command, check=True, stdout=file)


def check(program, folder, page):
    with tempfile.TemporaryDirectory() as results:
        copy = shutil.copy(page, results)
        run([program, "--quick"], os.path.join(results, "packs_times.csv"))
        run([sys.executable, os.path.join(folder, "count_instructions.py"), program, "--quick",
             "--algorithm", "munjiza_nbs"], os.path.join(results, "packs_instructions.csv"))
        run([sys.executable, os.path.join(folder, "report_packs.py"), results, "--docs", copy,
             "--images", results])
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

"""Runs the chain of matrix/run on small scenes: times, plots, tables and report.

Usage: check.py MATRIX_PROGRAM
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

PAGE_NAME = "benchmarks_matrix.md"
PAGE = os.path.join(ROOT, "docs", PAGE_NAME)

SCENES = ["dense", "hexagonal_2d", "touching_fcc"]


def check(program):
    with tempfile.TemporaryDirectory() as results:
        copy = shutil.copy(PAGE, results)
        for scene in SCENES:
            with open(os.path.join(results, f"{scene}.csv"), "w") as file:
                file.write("# compiler: any\n")
                file.flush()
                subprocess.run([program, "--quick", "--scenes", scene], check=True, stdout=file)
        report = [sys.executable, "-B", "-m", "benchmarks.matrix.report", results, "--docs", copy]
        subprocess.run([*report, "--images", results], check=True)
        subprocess.run([*report, "--beside"], check=True)
        written = {name: contents(os.path.join(results, name)) for name in (PAGE_NAME, "report.md")}
        for name in ("matrix_scenes.svg", "matrix_scaling.svg", "matrix_threads.svg"):
            check_picture(os.path.join(results, name))
    for words in ("Measured on: compiler any", "`plain_grid`", *SCENES):
        for name, text in written.items():
            if words not in text:
                sys.exit(f"the tables of {name} were not written anew: no '{words}'")
    for name, text in written.items():
        if re.search(r"\b(nan|inf)\b", text):
            sys.exit(f"a table of {name} holds what is not a number")


if __name__ == "__main__":
    check(*sys.argv[1:])

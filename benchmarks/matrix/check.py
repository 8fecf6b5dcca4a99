"""Runs the chain of matrix/run on small scenes: times, plots and tables.

Usage: check.py MATRIX_PROGRAM
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile

from benchmarks.common.tables import ROOT

PAGE = os.path.join(ROOT, "docs", "benchmarks_matrix.md")

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
        with open(copy) as file:
            text = file.read()
        for name in ("matrix_scenes.svg", "matrix_scaling.svg", "matrix_threads.svg"):
            if os.path.getsize(os.path.join(results, name)) < 5_000:
                sys.exit(f"{name} is all but empty")
    for words in ("compiler any", "Measured on: compiler any", "`plain_grid`", *SCENES):
        if words not in text:
            sys.exit(f"the tables of the page were not written anew: no '{words}'")
    if re.search(r"\b(nan|inf)\b", text):
        sys.exit("a table of the page holds what is not a number")


if __name__ == "__main__":
    check(*sys.argv[1:])

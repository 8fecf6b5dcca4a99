"""Runs the chain of run_matrix on small scenes: times, plots and tables.

Usage: check_matrix.py MATRIX_PROGRAM BENCHMARKS_FOLDER DOCS_PAGE
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile

SCENES = ["dense", "hexagonal_2d", "touching_fcc"]


def check(program, folder, page):
    with tempfile.TemporaryDirectory() as results:
        copy = shutil.copy(page, results)
        for scene in SCENES:
            with open(os.path.join(results, f"{scene}.csv"), "w") as file:
                file.write("# compiler: any\n")
                file.flush()
                subprocess.run([program, "--quick", "--scenes", scene], check=True, stdout=file)
        report = [sys.executable, os.path.join(folder, "report_matrix.py"), results, "--docs", copy]
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

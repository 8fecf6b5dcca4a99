"""Checks that the pages and the reports of the benchmarks show what the committed tables give, and
that the pages are short.

Usage, in the project's folder: python3 -m benchmarks.check_pages
"""

import os
import sys

from benchmarks.common.pages import contents, generated_lines, results_of, section_of
from benchmarks.common.tables import ROOT
from benchmarks.matrix import report as matrix
from benchmarks.packs import report as packs
from benchmarks.python import report as python
from benchmarks.systems import report as systems

MOST_GENERATED_LINES = 70  # of a page; more of them belong into the report


def expected():
    """For each module of a report the files that it writes from the committed tables, with what
    belongs into them. The pages name their results by the links to the reports."""
    page = contents(matrix.PAGE)
    own, other = (results_of(section_of(page, name), "matrix") for name in ("machine", "beside"))
    yield f"benchmarks.matrix.report {own}", matrix.texts(own, matrix.PAGE, beside=False)
    yield f"benchmarks.matrix.report {other} --beside", matrix.texts(other, matrix.PAGE, beside=True)
    results = results_of(section_of(contents(packs.PAGE), "machine"), "packs")
    yield f"benchmarks.packs.report {results}", packs.texts(results, packs.PAGE)
    results = results_of(section_of(contents(systems.PAGE), "machine"), "systems")
    yield f"benchmarks.systems.report {results}", systems.texts(results, systems.PAGE)
    results = results_of(section_of(contents(python.PAGE), "machine"), "python")
    yield f"benchmarks.python.report {results}", python.texts(results, python.PAGE)


def faults():
    for command, texts in expected():
        for path, text in texts:
            if not os.path.exists(path) or contents(path) != text:
                yield (f"{os.path.relpath(path, ROOT)} is not what the committed tables give: run "
                       f"python3 -m {command.replace(ROOT + os.sep, '')}")
    for page in (matrix.PAGE, packs.PAGE, systems.PAGE, python.PAGE):
        lines = generated_lines(contents(page))
        if lines > MOST_GENERATED_LINES:
            yield (f"{os.path.relpath(page, ROOT)} has {lines} generated lines, more than "
                   f"{MOST_GENERATED_LINES}: show fewer of them, the report has room")


def main():
    found = list(faults())
    for fault in found:
        print(fault)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

"""Turns the tables of benchmarks/python/run into those of docs/benchmarks_python.md.

Usage: python3 -m benchmarks.python.report RESULTS_FOLDER
The page keeps its words: only what lies between its markers is written anew.
"""

import argparse
import os

from benchmarks.common.pages import contents, link, with_sections, wrapped, write
from benchmarks.common.tables import ROOT, read, table

PAGE = os.path.join(ROOT, "docs", "benchmarks_python.md")

# Task, elements, packages (None for each), least ratio to abut.
AIMS = [
    ("dense", 1_000_000, ("SciPy",), 10),
    ("dense", 1_000_000, ("vesin", "matscipy-neighbours"), 15),
    ("bidisperse", 100_000, None, 50),
    ("liquid, half ij", 97_336, None, 5),
    ("liquid, full ijdDS", 97_336, None, 3),
    ("dense", 10, None, 3),
]


def time_of(seconds):
    """A time with three digits and the unit that suits it."""
    for unit, factor in (("s", 1.0), ("ms", 1e3), ("µs", 1e6)):
        if seconds * factor >= 1.0 or unit == "µs":
            return f"{seconds * factor:.3g} {unit}"
    raise AssertionError("not reached")


def ratios(rows):
    """Of each task and number of elements the times of the packages as multiples of abut's."""
    cases = {}
    for row in rows:
        cases.setdefault((row["task"], row["elements"]), {})[row["package"]] = row
    return {
        case: {name: row["cpu_seconds"] / of["abut"]["cpu_seconds"] for name, row in of.items()}
        for case, of in cases.items()
    }


def peers(rows):
    packages = list(dict.fromkeys(row["package"] for row in rows))
    head = ["task", "elements", "pairs", "abut", *(f"{name}, ×" for name in packages[1:])]
    lines = []
    for (task, elements), of in ratios(rows).items():
        own = next(
            row for row in rows
            if (row["task"], row["elements"], row["package"]) == (task, elements, "abut")
        )
        others = [f"{of[name]:.1f}" if name in of else "–" for name in packages[1:]]
        lines.append(
            [task, f"{elements:,}", f"{own['pairs']:,}", time_of(own["cpu_seconds"]), *others]
        )
    return table(head, lines)


def aims(rows, over):
    found = ratios(rows)
    lines = []
    for task, elements, packages, least in AIMS:
        of = found.get((task, elements), {})
        names = packages or [name for name in of if name != "abut"]
        worst = min(((of[name], name) for name in names if name in of), default=None)
        what = f"{task}, {elements:,}: {', '.join(packages) if packages else 'each package'}"
        if worst:
            lines.append(
                [what, f"≥ {least}×", f"{worst[0]:.1f}× ({worst[1]})",
                 "met" if worst[0] >= least else "missed"]
            )
    for row in over:
        if row["elements"] == 10:
            taken = row["beyond"] * 1e6
            lines.append(["a call of 10 spheres beyond C++", "≤ 10 µs", f"{taken:.1f} µs",
                          "met" if taken <= 10 else "missed"])
        if row["elements"] == 1_000_000:
            share = row["beyond"] / row["in_library"]
            lines.append(["a call of 1,000,000 spheres beyond C++", "≤ 5 %", f"{share:.1%}",
                          "met" if share <= 0.05 else "missed"])
    return table(["aim", "", "measured", ""], lines)


def machine(header, results, page):
    where = "; ".join(f"{key} {value}" for key, value in header.items())
    return "\n".join([wrapped(f"Measured on: {where}."), link("The tables", results, page) + "."])


def texts(results, page):
    """Pairs of a file and what belongs there: the page alone, which shows all there is."""
    header, rows = read(os.path.join(results, "peers.csv"))
    _, over = read(os.path.join(results, "overhead.csv"))
    sections = [("machine", machine(header, results, page)), ("peers", peers(rows)),
                ("aims", aims(rows, over))]
    return [(page, with_sections(contents(page), sections))]


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("results")
    for path, text in texts(os.path.abspath(parser.parse_args(arguments).results), PAGE):
        write(path, text)


if __name__ == "__main__":
    main()

"""Turns the tables of systems/run into those of docs/benchmarks_systems.md.

Usage: report.py RESULTS_FOLDER [--docs FILE]
The page keeps its words: only what lies between its markers is written anew. A table that is not
in the folder is taken from the newest measurement of another machine, which the page names; one
that no machine has leaves its section as it is.
"""

import argparse
import glob
import os

from benchmarks.common.pages import contents, link, with_sections, wrapped, write
from benchmarks.common.tables import ROOT, plain, read, table

PAGE = os.path.join(ROOT, "docs", "benchmarks_systems.md")


# What the page leaves out, since a page has room for so many lines: it is in the tables' files.
SKINS_NOT_SHOWN = {0.02, 0.05, 0.2}
BOXES_NOT_SHOWN = {"gas_2d"}
TASKS_NOT_SHOWN = {"motion of the drum"}
NEIGHBORS_NOT_SHOWN = {"distance", "vector", "needs_rebuild() an element", "liquid: neighbors",
                       "liquid: shifts too", "gap; normal; point of a mesh",
                       "gap; normal; point of boxes", "gap; normal; point of images of a mesh",
                       "gap; normal; point of images of boxes"}

# What of a header tells when a table was measured.
WHEN = ("date", "commit")


def distinct(rows, *keys):
    return list(dict.fromkeys(tuple(row[k] for k in keys) for row in rows))


def boxes(rows):
    contestants = [c for (c,) in distinct(rows, "contestant")]
    head = ["boxes", "contact pairs", "`abut`, ns"]
    head += [f"`{c}`, ns (× abut)" for c in contestants[1:]]
    lines = []
    most = max(r["elements"] for r in rows)
    for scene, elements in distinct(rows, "scene", "elements"):
        if elements < most or scene in BOXES_NOT_SHOWN:
            continue
        of = {r["contestant"]: r for r in rows if (r["scene"], r["elements"]) == (scene, elements)}
        others = [f"{plain(of[c]['ns'], 0)} ({of[c]['times_abut']:.1f})" for c in contestants[1:]]
        lines.append([f"{scene}, {elements:,}", f"{of['abut']['contact_pairs']:,}",
                      plain(of["abut"]["ns"]), *others])
    return table(head, lines)


def periodic(rows):
    head = ["domain", "contact pairs", "ns", "to open space"]
    return table(head, [[r["case"], f"{r['contact_pairs']:,}", plain(r["ns_median"]),
                         f"{r['median_to_open']:.2f}"] for r in rows])


def cross_contacts(rows):
    contestants = [c for (c,) in distinct(rows, "contestant")]
    head = ["first against second", "contact pairs", "`abut`, ns"]
    head += [f"{c}, ns (× abut)" for c in contestants[1:]]
    lines = []
    for (case,) in distinct(rows, "case"):
        of = {r["contestant"]: r for r in rows if r["case"] == case}
        own = of["abut"]
        others = [f"{plain(of[c]['ns'], 0)} ({of[c]['times_abut']:.1f})" for c in contestants[1:]]
        lines.append([f"{case}: {own['first']:,} against {own['second']:,}",
                      f"{own['contact_pairs']:,}", plain(own["ns"]), *others])
    return table(head, lines)


def stepping(rows):
    head = ["skin", "length", "ns a step", "times faster", "history, ns", "detections", "reuses"]
    return table(head, [[r["skin"], r["length"], plain(r["ns_per_element_and_step"]),
                         plain(r["times_faster"], 2), plain(r["history_ns"]), r["detections"],
                         r["reuses"]] for r in rows if r["length"] not in SKINS_NOT_SHOWN])


def skin_reuse(rows):
    head = ["numbers", "elements", "candidates, contacts an element", "a reuse, ns",
            "needs_rebuild and a loop by hand, ns", "of that"]
    lines = []
    most = max(r["elements"] for r in rows)
    for r in rows:
        if r["elements"] < most:
            continue
        by_hand = r["check_ns"] + r["loop_ns"]
        lines.append([r["order"], f"{r['elements']:,}", f"{r['candidates']:.1f}, {r['contacts']:.1f}",
                      plain(r["reuse_ns"]), plain(by_hand), plain(r["reuse_ns"] / by_hand, 2)])
    return table(head, lines)


def neighbor_lists(rows):
    tasks = [t for (t,) in distinct(rows, "task")]
    head = ["skin", "neighbors of the half list", *[f"{t}, ns" for t in tasks]]
    lines = []
    for (skin,) in distinct(rows, "skin"):
        of = {r["task"]: r for r in rows if r["skin"] == skin}
        lines.append([skin, f"{of['half list']['found']:,}",
                      *[plain(of[t]["ns"] if t in of else None) for t in tasks]])
    return table(head, lines)


def pair_geometry(rows):
    head = ["of contacts and neighbors", "elements", "entries", "ns an entry"]
    rows = [r for r in rows if r["task"] not in NEIGHBORS_NOT_SHOWN]
    return table(head, [[r["task"], f"{r['elements']:,}", f"{r['entries']:,}",
                         plain(r["ns_median"])] for r in rows])


def liquid_loop(rows):
    sizes = distinct(rows, "atoms", "steps")
    head = ["loop"]
    for atoms, steps in sizes:
        head += [f"{atoms:,} atoms, {steps} steps, ms a step", "to the list by hand"]
    lines = []
    for (loop,) in distinct(rows, "loop"):
        of = {(r["atoms"], r["steps"]): r for r in rows if r["loop"] == loop}
        measured = [(plain(of[size]["ms_per_step"], 2), plain(of[size]["ratio"], 2))
                    for size in sizes]
        lines.append([loop, *[cell for cells in measured for cell in cells]])
    return table(head, lines)


def moving_walls(rows):
    head = ["in a step", "found", "ms", "to the contacts of the spheres"]
    return table(head, [[r["task"], f"{r['found']:,}", plain(r["ms_per_step"], 2),
                         f"{r['ratio']:.3f}"]
                        for r in rows if r["task"] not in TASKS_NOT_SHOWN])


SECTIONS = {
    "box_contacts": boxes,
    "periodic_cost": periodic,
    "cross_contacts": cross_contacts,
    "stepping": stepping,
    "skin_reuse": skin_reuse,
    "pair_geometry": pair_geometry,
    "moving_walls": moving_walls,
    "liquid_loop": liquid_loop,
    "neighbor_lists": neighbor_lists,
}


def tables_of(results):
    """For each table that there is its file: that of the folder, or else the newest one."""
    found = {}
    for name in SECTIONS:
        path = os.path.join(results, f"{name}.csv")
        others = sorted(glob.glob(os.path.join(ROOT, "benchmarks", "results", "*", "systems",
                                               f"{name}.csv")))
        if os.path.exists(path):
            found[name] = path
        elif others:
            found[name] = max(others, key=lambda other: read(other)[0].get("date", ""))
    return found


def machines(headers, results, page):
    """On what the tables were measured, each machine once, that of the folder first, with dates and
    commits and a link to its tables. `headers` gives the header of each file of a table."""
    found = {}
    for path, header in sorted(headers.items(), key=lambda of: os.path.dirname(of[0]) != results):
        machine = "; ".join(f"{key} {value}" for key, value in header.items() if key not in WHEN)
        days = found.setdefault((machine, os.path.dirname(path)), {})
        commits = days.setdefault(f"date {header.get('date', 'unknown')}", {})
        tables = commits.setdefault(f"commit {header.get('commit', 'unknown')}", [])
        tables.append(os.path.basename(path).removesuffix(".csv"))
    lines = []
    for (machine, folder), days in found.items():
        words = [", ".join([day, *(f"{commit} ({', '.join(of)})" for commit, of in commits.items())])
                 for day, commits in days.items()]
        lines += [wrapped("; ".join(filter(None, ["Measured on: " + machine, *words])) + "."),
                  link("The tables", folder, page) + "."]
    return "\n".join(lines)


def texts(results, page):
    """Pairs of a file and what belongs there: the page alone, which shows all there is."""
    headers, sections = {}, []
    for name, path in tables_of(os.path.abspath(results)).items():
        headers[path], rows = read(path)
        sections.append((name, SECTIONS[name](rows)))
    sections.append(("machine", machines(headers, os.path.abspath(results), page)))
    return [(page, with_sections(contents(page), sections))]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("results")
    parser.add_argument("--docs", default=PAGE)
    arguments = parser.parse_args()
    for path, text in texts(arguments.results, arguments.docs):
        write(path, text)


if __name__ == "__main__":
    main()

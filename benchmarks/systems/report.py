"""Turns the tables of systems/run into those of docs/benchmarks_systems.md.

Usage: report.py RESULTS_FOLDER [--docs FILE]
The page keeps its words: only what lies between its markers is written anew. A table that is not
there leaves its section as it is.
"""

import argparse
import os

from benchmarks.common.tables import ROOT, plain, read, rewrite_page, table


def distinct(rows, *keys):
    return list(dict.fromkeys(tuple(row[k] for k in keys) for row in rows))


def boxes(rows):
    contestants = [c for (c,) in distinct(rows, "contestant")]
    head = ["boxes", "contact pairs", "`abut`, ns"]
    head += [f"`{c}`, ns (× abut)" for c in contestants[1:]]
    lines = []
    for scene, elements in distinct(rows, "scene", "elements"):
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
                         r["reuses"]] for r in rows])


def neighbor_lists(rows):
    tasks = [t for (t,) in distinct(rows, "task")]
    head = ["skin", "neighbors of the half list", *[f"{t}, ns" for t in tasks]]
    lines = []
    for (skin,) in distinct(rows, "skin"):
        of = {r["task"]: r for r in rows if r["skin"] == skin}
        lines.append([skin, f"{of['half list']['found']:,}",
                      *[plain(of[t]["ns"] if t in of else None) for t in tasks]])
    return table(head, lines)


SECTIONS = {
    "box_contacts": boxes,
    "periodic_cost": periodic,
    "cross_contacts": cross_contacts,
    "stepping": stepping,
    "neighbor_lists": neighbor_lists,
}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("results")
    parser.add_argument("--docs", default=os.path.join(ROOT, "docs", "benchmarks_systems.md"))
    arguments = parser.parse_args()
    sections = []
    for name, body in SECTIONS.items():
        path = os.path.join(arguments.results, f"{name}.csv")
        if not os.path.exists(path):
            continue
        header, rows = read(path)
        machine = "; ".join(f"{k} {v}" for k, v in header.items()) + "."
        sections.append((name, f"{body(rows)}\n\nMeasured on: {machine}"))
    rewrite_page(arguments.docs, sections)


if __name__ == "__main__":
    main()

"""Turns the tables of packs/run into the plots and the short tables of docs/benchmarks.md, and into
the long report beside them.

Usage: report.py RESULTS_FOLDER [--docs FILE] [--images FOLDER]
Writes RESULTS_FOLDER/report.md. The page keeps its words: only what lies between its markers is
written anew. Without --images there are no plots.
"""

import argparse
import os

from benchmarks.common.pages import contents, link, with_sections, wrapped, write
from benchmarks.common.tables import ROOT, plain, table
from benchmarks.packs.data import (
    LOOSE_PACKS,
    ROMAN,
    Packs,
    book_integers,
    growth_beyond_n_log_n,
    slope,
)

PAGE = os.path.join(ROOT, "docs", "benchmarks.md")


def nanoseconds(row):
    return "–" if row is None else f"{row['ns_median']:,.1f} ({row['ns_minimum']:,.1f})"


def machine(packs):
    return wrapped("Measured on: " + "; ".join(f"{k} {v}" for k, v in packs.header.items()) + ".")


def times_by_elements(packs):
    cases = [(n, "along") for n in packs.sizes()] + [(packs.sizes()[-1], "shuffled")]
    head = ["pack I, N ="] + [f"{n:,}" + (" shuffled" if s == "shuffled" else "") for n, s in cases]
    rows = []
    for algorithm in packs.algorithms:
        found = [packs.one(pack=1, algorithm=algorithm, elements=n, numbering=s) for n, s in cases]
        rows.append([f"`{algorithm}`"] + [nanoseconds(r) for r in found])
    return table(head, rows)


def times_by_spacing(packs, algorithms=None):
    spacings = packs.spacings(2)
    head = ["S/D ="] + [f"{s}" for s in spacings]
    rows = []
    for pack in LOOSE_PACKS:
        for algorithm in algorithms or packs.algorithms:
            found = [packs.one(pack=pack, algorithm=algorithm, spacing=s) for s in spacings]
            values = [plain(r and r["ns_minimum"]) for r in found]
            rows.append([f"{ROMAN[pack]} `{algorithm}`"] + values)
    return table(head, rows)


def forms_and_phases(packs):
    n = packs.sizes()[-1]
    head = ["pack I, N = " + f"{n:,}", "count", "list as found", "list canonical"]
    head += ["gather", "search", "order", "tests", "exact"]
    rows = []
    for algorithm in packs.algorithms[1:]:
        forms = [packs.one(pack=1, elements=n, algorithm=algorithm, form=f) for f in
                 ("count", "as_found", "canonical")]
        last = forms[-1]
        if last is None:
            continue
        each = [last[k] / n for k in ("candidate_tests", "exact_decisions")]
        rows.append([f"`{algorithm}`"] + [plain(f["ns_minimum"]) for f in forms]
                    + [plain(last[k]) for k in ("gather_ns", "search_ns", "order_ns")]
                    + [plain(v, 2) for v in each])
    return table(head, rows)


def memory(packs):
    n = packs.sizes()[-1]
    cases = [("I, N = " + f"{n:,}", {"pack": 1, "elements": n})]
    cases += [(f"{ROMAN[p]}, S/D = 200", {"pack": p, "spacing": 200}) for p in LOOSE_PACKS]
    head = ["integers for each element (bytes held)"] + [name for name, _ in cases]
    rows = []
    for algorithm in packs.algorithms:
        cells = []
        for _, wanted in cases:
            found = packs.select(algorithm=algorithm, form="count", **wanted)
            if not found:
                cells.append("–")
                continue
            row = found[0]
            integers = book_integers(row)
            own = "≤ 2b + 2" if integers is None else plain(integers)
            held = "refused" if row["refusal"] else plain(row["peak_bytes"] / row["elements"], 0)
            cells.append(f"{own} ({held})")
        rows.append([f"`{algorithm}`"] + cells)
    return table(head, rows)


def instructions_by_elements(packs):
    sizes = packs.sizes()[:-1]
    rows = []
    for algorithm in packs.algorithms[1:]:
        counted = [packs.instructions_of(pack=1, elements=n, algorithm=algorithm) for n in sizes]
        rows.append([f"`{algorithm}`"] + [plain(c, 0) for c in counted])
    return table(["pack I, N ="] + [f"{n:,}" for n in sizes], rows)


def instructions_by_spacing(packs):
    spacings = packs.spacings(2)
    rows = []
    for pack in LOOSE_PACKS:
        counted = [packs.instructions_of(pack=pack, spacing=s, algorithm="munjiza_nbs")
                   for s in spacings]
        rows.append([f"pack {ROMAN[pack]}"] + [plain(c) for c in counted])
    return table(["S/D ="] + [f"{s}" for s in spacings], rows)


def verdict(condition):
    return "yes" if condition else "**no**"


def claim_of_speed(packs, small, large):
    nbs = {n: packs.one(pack=1, elements=n, algorithm="munjiza_nbs") for n in (small, large)}
    yield [f"`munjiza_nbs`, pack I, N = {large:,}: under 40 ns", f"{nanoseconds(nbs[large])} ns",
           verdict(nbs[large]["ns_minimum"] < 40)]
    exponent = slope(nbs[small], nbs[large])
    yield [f"`munjiza_nbs`, exponent of N between {small:,} and {large:,} at most 1.1",
           f"{exponent:.3f}", verdict(exponent <= 1.1)]


def claim_of_packing(packs):
    for pack in LOOSE_PACKS:
        loose = [s for s in packs.spacings(pack) if s >= 2]
        times = [packs.one(pack=pack, spacing=s, algorithm="munjiza_nbs") for s in loose]
        counts = [packs.instructions_of(pack=pack, spacing=s, algorithm="munjiza_nbs")
                  for s in loose]
        ratio = {k: max(r[k] for r in times) / min(r[k] for r in times)
                 for k in ("ns_median", "ns_minimum")}
        yield [f"`munjiza_nbs`, pack {ROMAN[pack]}, S/D = 2 to 200: constant within 20 %",
               f"largest / smallest time {ratio['ns_minimum']:.2f} "
               f"(of medians {ratio['ns_median']:.2f}, of instructions "
               f"{max(counts) / min(counts):.3f})",
               verdict(ratio["ns_minimum"] <= 1.2)]


def claim_of_n_log_n(packs, small, large):
    for algorithm in packs.algorithms[1:]:
        rows = [packs.one(pack=1, elements=n, algorithm=algorithm) for n in (small, large)]
        time = growth_beyond_n_log_n(*((r["elements"], r["ns_minimum"]) for r in rows))
        counts = [(n, packs.instructions_of(pack=1, elements=n, algorithm=algorithm))
                  for n in packs.sizes() if n >= small]
        counts = [c for c in counts if c[1] is not None]
        work = growth_beyond_n_log_n(counts[0], counts[-1]) if len(counts) > 1 else None
        tests = [r["candidate_tests"] / r["elements"] for r in rows]
        yield [f"`{algorithm}`: no worse than N log N, {small:,} to {large:,}",
               f"time / (N log N) grows by {time:.2f}, instructions (to 90,000) by "
               f"{plain(work, 2)}; tests for each element {tests[0]:.2f}, {tests[1]:.2f}",
               verdict(time <= 1.5 and (work or 0) <= 1.5)]


def claims(packs):
    small, large = packs.first_of_slope(), packs.sizes()[-1]
    rows = [*claim_of_speed(packs, small, large), *claim_of_packing(packs),
            *claim_of_n_log_n(packs, small, large)]
    return table(["required", "measured", "met"], rows)


def times_of_nbs_by_spacing(packs):
    return times_by_spacing(packs, ["munjiza_nbs"])


# Sections of the page.
SECTIONS = [
    ("claims", claims),
    ("times-by-elements", times_by_elements),
    ("times-by-spacing", times_of_nbs_by_spacing),
    ("memory", memory),
]

# The report, part by part: heading, words, table.
PARTS = [
    ("What was required, and what came out", "", claims),
    ("Times against the number of elements", "ns for each element and detection, count form: median "
     "(minimum).", times_by_elements),
    ("Instructions against the number of elements", "For each element.", instructions_by_elements),
    ("Times against the spacing", "N = 10,000, minima of the count form.", times_by_spacing),
    ("Instructions of `munjiza_nbs` against the spacing", "For each element.",
     instructions_by_spacing),
    ("Forms and phases", "The three forms of the call (minima), then the phases of the last (wall "
     "time), distances tested and exact decisions for each element.", forms_and_phases),
    ("Memory", "Integers of an algorithm's own arrays for each element by the book's formulas, and "
     "in brackets the bytes for each element that a counting detection holds at its peak.", memory),
]


def report(packs, path):
    page = link("the page of the packs", PAGE, path)
    parts = ["# The test problems of 1998: all tables of one machine",
             wrapped(f"What is measured and how is told on {page}; this report is written by "
                     "`benchmarks/packs/run` from the tables beside it."), machine(packs)]
    for heading, words, body in PARTS:
        parts += [f"## {heading}", *([wrapped(words)] if words else []), body(packs)]
    return "\n\n".join(parts) + "\n"


def texts(results, page):
    """Pairs of a file and what belongs there: the report and the page."""
    packs = Packs(results)
    path = os.path.join(results, "report.md")
    all_of_it = link("All tables of this run", path, page) + "."
    sections = [("machine", machine(packs) + "\n" + all_of_it)]
    sections += [(name, section(packs)) for name, section in SECTIONS]
    return [(path, report(packs, path)), (page, with_sections(contents(page), sections))]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("results")
    parser.add_argument("--docs", default=PAGE)
    parser.add_argument("--images", help="folder for the plots")
    arguments = parser.parse_args()

    for path, text in texts(arguments.results, arguments.docs):
        write(path, text)
    packs = Packs(arguments.results)
    if arguments.images:
        from benchmarks.packs import plot  # needs matplotlib

        plot.plot_all(packs, arguments.images)
    print(claims(packs))


if __name__ == "__main__":
    main()

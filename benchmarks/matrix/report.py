"""Turns the tables of matrix/run into the plots and the short tables of docs/benchmarks_matrix.md,
and into the long report beside them.

Usage: report.py RESULTS_FOLDER [--beside] [--docs FILE] [--images FOLDER]
Writes RESULTS_FOLDER/report.md. The page keeps its words: only what lies between its markers is
written anew. With --beside the tables are those of another machine, which the page shows in short,
beside its own. Without --images there are no plots.
"""

import argparse
import os

from benchmarks.common.pages import contents, link, with_sections, wrapped, write
from benchmarks.common.tables import ROOT, plain, table
from benchmarks.matrix import aims, claims
from benchmarks.matrix.claims import FORMS, elsewhere, order_ns
from benchmarks.matrix.data import DEFAULT, Matrix, median, ratio
from benchmarks.matrix.words import WHY_NOT, label, of_possible, power, short, times

PAGE = os.path.join(ROOT, "docs", "benchmarks_matrix.md")


def machine(matrix):
    """Headers of all tables; dates and commits may differ from scene to scene."""
    parts = []
    for key in matrix.headers[0]:
        values = list(dict.fromkeys(h.get(key, "–") for h in matrix.headers))
        parts.append(f"{key} {', '.join(values)}")
    copied = []
    for scene in matrix.scenes:
        row = matrix.row(scene, matrix.main_count(scene), "memcpy", task="copy")
        if median(row):
            copied.append(8 * (row["dimensions"] + 1) / median(row))
    if copied:
        copied.sort()
        parts.append(f"memcpy of the arrays {copied[len(copied) // 2]:.1f} GB/s")
    return wrapped("Measured on: " + "; ".join(parts) + ".")


def cell(row):
    if row is None:
        return "–"
    if row["verdict"] in WHY_NOT:
        return WHY_NOT[row["verdict"]]
    ns = median(row) if row["ns_median"] != "" else row["ns_first"]
    mark = {"wrong": " ✗", "unchecked": " ?"}.get(row["verdict"], "")
    return f"{ns:,.0f}{mark}" if ns >= 99.95 else f"{ns:,.1f}{mark}"


def times_at(matrix, count):
    contestants = [c for c in ["plain_grid"] + matrix.ours + matrix.packages
                   if any(matrix.row(s, count, c) is not None
                          and matrix.row(s, count, c)["verdict"] != "left_out"
                          for s in matrix.scenes)]
    rows = []
    for scene in matrix.scenes:
        rows.append([scene] + [cell(matrix.row(scene, count, c)) for c in contestants])
    return table([f"N = {power(count)}"] + [short(c) for c in contestants], rows)


def all_times(matrix):
    return "\n\n".join(times_at(matrix, count) for count in reversed(matrix.counts))


def summary(matrix):
    head = ["scene, N", "abut `auto`", "its choice", "aim", "plain grid", "grid / abut",
            "best package", "package / abut", "elsewhere", "elsewhere / abut"]
    rows = []
    for scene in matrix.scenes:
        count = matrix.main_count(scene)
        own = matrix.row(scene, count, DEFAULT)
        ours, grid = median(own), matrix.ns(scene, count, "plain_grid")
        package_ns, package = matrix.best(scene, count, matrix.packages)
        other, through_grid = elsewhere(matrix, scene)
        rows.append([label(matrix, scene), plain(ours), choice(own),
                     plain(aims.ns(scene, count), 0), plain(grid), times(ratio(grid, ours)),
                     f"{plain(package_ns, 0)} {short(package) if package else ''}".strip(),
                     times(ratio(package_ns, ours)), other, times(through_grid)])
    return table(head, rows)


def choice(row):
    return f"`{row['note'].split(':')[0]}`" if row is not None and row["note"] else "–"


def slopes(matrix):
    contestants = [DEFAULT, "plain_grid"] + [c for c in matrix.ours if c != DEFAULT]
    rows = [[scene] + [plain(matrix.slope(scene, c), 2) for c in contestants]
            for scene in matrix.scenes]
    return table(["exponent of N"] + [short(c) for c in contestants], rows)


def counters(matrix):
    head = ["scene, N", "pairs / N", "tests / (N + pairs)", "plain grid's", "bytes / N",
            *FORMS, "order, ns a pair", "first call"]
    rows = []
    for scene in matrix.scenes:
        count = matrix.main_count(scene)
        row, grid = matrix.row(scene, count, DEFAULT), matrix.row(scene, count, "plain_grid")
        if median(row) is None:
            continue
        tests = [None if median(r) is None else r["candidate_tests"] / (count + r["pairs"])
                 for r in (row, grid)]
        forms = [matrix.ns(scene, count, DEFAULT, task=t)
                 for t in FORMS]
        rows.append([label(matrix, scene), plain(row["pairs"] / count, 2), plain(tests[0], 2),
                     plain(tests[1], 2), plain(row["peak_bytes"] / count, 0),
                     *[plain(f) for f in forms], plain(order_ns(matrix, scene)),
                     plain(row["ns_first"])])
    return table(head, rows)


def threads(matrix):
    counts = [n for n in matrix.counts if n >= 1_000_000] or matrix.counts[-1:]
    rows = []
    for scene in matrix.scenes:
        for count in counts:
            found = [matrix.ns(scene, count, DEFAULT, threads=t) for t in matrix.threads]
            if any(f is not None for f in found[1:]):
                speedups = [speedup(matrix, scene, count, t) for t in matrix.threads[1:]]
                rows.append([label(matrix, scene, count)] + [plain(f) for f in found] + speedups)
    if not rows:
        return "No algorithm of these tables runs in more than one thread."
    head = ["scene, N"] + [f"{t} threads" if t > 1 else "1 thread" for t in matrix.threads]
    return table(head + [f"speedup of {t}" for t in matrix.threads[1:]], rows)


def speedup(matrix, scene, count, threads):
    """As words: of abut, and of the control loop where it was measured."""
    return of_possible(matrix.speedup(scene, count, threads),
                       matrix.possible_speedup(scene, count, threads))


def without_end(matrix):
    """An item for each scene: who did not end within the time limit, from which N on."""
    first = {}
    for r in matrix.rows:
        if r["verdict"] == "too_slow" and r["task"] == "list" and r["threads"] == 1:
            of_scene = first.setdefault(r["scene"], {})
            n = of_scene.setdefault(r["contestant"], r["elements"])
            of_scene[r["contestant"]] = min(n, r["elements"])
    for scene, contestants in first.items():
        at = {n: [short(c) for c in contestants if contestants[c] == n]
              for n in sorted(set(contestants.values()))}
        yield f"* {scene}: " + "; ".join(
            f"from {power(n)} on {', '.join(who)}" for n, who in at.items())


def refusals(matrix):
    """Wrong answers, crashes and refusals, each with its reason."""
    told = set()
    for r in matrix.rows:
        place = f"{r['scene']}, {power(r['elements'])}, {short(r['contestant'])}"
        if r["verdict"] == "wrong":
            yield (f"* {place} ({r['task']}): **wrong**, {r['missing']:,} pairs missing, "
                   f"{r['extra']:,} too many of {r['pairs']:,}")
        elif r["verdict"] in ("refused", "crashed") and r["task"] == "list" and r["threads"] == 1:
            if (r["scene"], r["contestant"]) not in told:
                yield f"* {place} (and more elements): {r['reason']}"
            told.add((r["scene"], r["contestant"]))


def findings(matrix):
    referees = list(dict.fromkeys(r["reference"] or "nobody" for r in matrix.rows))
    parts = [wrapped("Answers were compared with the pairs of: "
                     + ", ".join(short(r) for r in referees) + ".")]
    for heading, items in (("Wrong, crashed or refused:", list(refusals(matrix))),
                           ("No end within the time limit:", list(without_end(matrix)))):
        if items:
            parts.append(heading + "\n\n" + "\n".join(wrapped(item, "  ") for item in items))
    return "\n\n".join(parts)


# These differ from another scene in the range of sizes alone, or by a few elements; the report has
# them.
LIKE_ANOTHER = {"log_uniform_1000", "graded_1000", "dense_stray", "boulders", "polydisperse",
                "refined"}


def short_for_another(matrix):
    """The table of another machine, with the times of all N."""
    head = (["scene, N", "abut `auto`", "aim", "grid / abut", "best package", "package / abut"]
            + [f"at {power(n)}" for n in matrix.counts]
            + ["slope", "2 threads", "bytes / N", "first call / later"])
    rows = []
    for scene in (s for s in matrix.scenes if s not in LIKE_ANOTHER):
        count = matrix.main_count(scene)
        own = matrix.row(scene, count, DEFAULT)
        ours = median(own)
        package_ns, package = matrix.best(scene, count, matrix.packages)
        rows.append([label(matrix, scene), plain(ours), plain(aims.ns(scene, count), 0),
                     times(ratio(matrix.ns(scene, count, "plain_grid"), ours)),
                     f"{plain(package_ns, 0)} {short(package) if package else ''}".strip(),
                     times(ratio(package_ns, ours))]
                    + [plain(matrix.ns(scene, n, DEFAULT)) for n in matrix.counts]
                    + [plain(matrix.slope(scene, DEFAULT), 3), speedup(matrix, scene, count, 2),
                       plain(own["peak_bytes"] / count, 0),
                       times(ratio(own["ns_first"], ours))])
    return table(head, rows)


# The report, part by part: heading, words, table.
PARTS = [
    ("In short", "At 10⁶ elements (`one_giant`: 10⁵), in nanoseconds for each element.", summary),
    ("What is required", "", claims.long_table),
    ("Times", "Medians of lists as found, one thread, in nanoseconds for each element. *slow*: no "
     "end within the time limit; *no*: refused; both with more words under Findings. ✗: wrong; ?: "
     "there was nothing to compare with; –: not tried.", all_times),
    ("Exponents of N", "Of the total time, over all sizes from 10⁴ on that were timed.", slopes),
    ("Work, memory and forms", "abut `auto`, one thread. *tests* are distances evaluated, *bytes* "
     "the peak of abut's own buffers with the list. *count* stores nothing, *visit* hands the pairs "
     "to a function, *half_list* and *full_list* are neighbor lists in compressed rows. *order* is "
     "what canonical order adds to a list as found; *first call* meets fresh memory.", counters),
    ("Threads", "One thread on each core, bound to it; in nanoseconds for each element. Beside the "
     "speedup stands that of a loop of arithmetic, where it was measured: what the processors gave "
     "meanwhile.", threads),
    ("Findings", "", findings),
]


def report(matrix, path):
    page = link("the page of the matrix", PAGE, path)
    parts = ["# The matrix: all tables of one machine",
             wrapped(f"What is measured and how is told on {page}; this report is written by "
                     "`benchmarks/matrix/run` from the tables beside it."), machine(matrix)]
    for heading, words, body in PARTS:
        parts += [f"## {heading}", *([wrapped(words)] if words else []), body(matrix)]
    return "\n\n".join(parts) + "\n"


def texts(results, page, beside):
    """Pairs of a file and what belongs there: the report and the page."""
    matrix = Matrix(results)
    path = os.path.join(results, "report.md")
    all_of_it = link("All tables of this machine", path, page) + "."
    if beside:
        sections = [("beside", short_for_another(matrix) + "\n\n" + machine(matrix) + "\n"
                     + all_of_it)]
    else:
        sections = [("machine", machine(matrix) + "\n" + all_of_it), ("summary", summary(matrix)),
                    ("claims", claims.short_table(matrix))]
    return [(path, report(matrix, path)), (page, with_sections(contents(page), sections))]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("results")
    parser.add_argument("--beside", action="store_true")
    parser.add_argument("--docs", default=PAGE)
    parser.add_argument("--images", help="folder for the plots")
    arguments = parser.parse_args()

    for path, text in texts(arguments.results, arguments.docs, arguments.beside):
        write(path, text)
    matrix = Matrix(arguments.results)
    if arguments.images:
        from benchmarks.matrix import plot  # needs matplotlib

        plot.plot_all(matrix, arguments.images)
    print(summary(matrix))
    print()
    print(findings(matrix))


if __name__ == "__main__":
    main()

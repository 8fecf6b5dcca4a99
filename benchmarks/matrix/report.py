"""Turns the tables of matrix/run into the plots and tables of docs/benchmarks_matrix.md.

Usage: report.py RESULTS_FOLDER [--beside] [--docs FILE] [--images FOLDER]
The page keeps its words: only what lies between its markers is written anew. With --beside the
tables are those of another machine, which the page shows in short, beside its own.
"""

import argparse
import os

from benchmarks.matrix import aims
from benchmarks.matrix import plot
from benchmarks.matrix.data import DEFAULT, YARDSTICKS, Matrix, median, ratio
from benchmarks.common.tables import ROOT, plain, rewrite_page, table

FORMS = ["list", "canonical", "count", "visit", "half_list", "full_list"]
WHY_NOT = {"refused": "no", "too_slow": "slow", "crashed": "crash", "left_out": "–"}


def power(count):
    exponent = len(str(count)) - 1
    if count != 10**exponent:
        return f"{count:,}"
    return "10" + str(exponent).translate(str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹"))


def short(contestant):
    return f"`{contestant.removeprefix('abut_')}`"


def label(matrix, scene, count=None):
    count = matrix.main_count(scene) if count is None else count
    return f"{scene}, {power(count)}"


def times(value):
    return "–" if value is None else f"{value:,.2f}×" if value < 9.95 else f"{value:,.0f}×"


def verdict(condition):
    return "–" if condition is None else "yes" if condition else "**no**"


def at_least(value, wanted):
    return None if value is None else value >= wanted


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
    return "; ".join(parts) + "."


def cell(row):
    if row is None:
        return "–"
    if row["verdict"] in WHY_NOT:
        return WHY_NOT[row["verdict"]]
    ns = median(row) if row["ns_median"] != "" else row["ns_first"]
    mark = {"wrong": " ✗", "unchecked": " ?"}.get(row["verdict"], "")
    return f"{ns:,.0f}{mark}" if ns >= 99.95 else f"{ns:,.1f}{mark}"


def times_at(matrix, count):
    contestants = [c for c in YARDSTICKS[1:] + matrix.ours + matrix.packages
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
                     plain(aims.AIMS.get(scene), 0), plain(grid), times(ratio(grid, ours)),
                     f"{plain(package_ns, 0)} {short(package) if package else ''}".strip(),
                     times(ratio(package_ns, ours)), other, times(through_grid)])
    return table(head, rows)


def choice(row):
    return f"`{row['note'].split(':')[0]}`" if row is not None and row["note"] else "–"


def elsewhere(matrix, scene):
    """(library, how many times as fast as it we are), both measured against the plain grid."""
    count = matrix.main_count(scene)
    if scene not in aims.ELSEWHERE or count != aims.COUNT_ELSEWHERE:
        return "–", None
    library, seconds, grid_seconds = aims.ELSEWHERE[scene]
    against_grid = ratio(matrix.ns(scene, count, "plain_grid"), matrix.ns(scene, count, DEFAULT))
    return library, None if against_grid is None else seconds / grid_seconds * against_grid


def judged(name, wanted, measured, good):
    return [name, wanted, measured, verdict(good)]


def claims_of_scene(matrix, scene):
    count = matrix.main_count(scene)
    name = label(matrix, scene)
    row = matrix.row(scene, count, DEFAULT)
    ours = median(row)
    if ours is None:
        return
    if scene in aims.AIMS:
        wanted = aims.AIMS[scene]
        yield judged(name, f"≤ {wanted} ns", f"{ours:,.1f} ns", ours <= wanted)
    wanted = aims.AGAINST_GRID.get(scene, aims.AGAINST_GRID_ELSEWHERE)
    found = ratio(matrix.ns(scene, count, "plain_grid"), ours)
    if found is not None:
        yield judged(name, f"≥ {wanted}× the plain grid", times(found), found >= wanted)
    found = ratio(matrix.best(scene, count, matrix.packages)[0], ours)
    if found is not None:
        yield judged(name, f"≥ {aims.AGAINST_PACKAGES}× every package", times(found),
                     found >= aims.AGAINST_PACKAGES)
    library, found = elsewhere(matrix, scene)
    if found is not None:
        wanted = aims.AGAINST_ELSEWHERE[scene]
        yield judged(name, f"≥ {wanted}× {library}, through the grid", times(found),
                     found >= wanted)
    yield from claims_of_choice(matrix, scene, count, name, ours)
    yield from claims_of_counters(matrix, scene, row, name)


def claims_of_choice(matrix, scene, count, name, ours):
    best, by = matrix.best(scene, count, [c for c in matrix.ours if c != DEFAULT])
    if best is not None:
        found = ours / best
        yield judged(name, f"≤ {aims.MOST_BEHIND_BEST_CHOICE}× the best algorithm",
                     f"{found:.2f}× {short(by)}", found <= aims.MOST_BEHIND_BEST_CHOICE)


def claims_of_counters(matrix, scene, row, name):
    count, pairs = row["elements"], row["pairs"]
    most = aims.MOST_TESTS[scene not in aims.UNEQUAL_SIZES]
    tests = row["candidate_tests"] / (count + pairs)
    yield judged(name, f"≤ {most} tests × (N + pairs)", f"{tests:.2f}", tests <= most)
    most = aims.most_bytes(count, pairs)
    yield judged(name, f"≤ {most / 1e6:,.0f} MB", f"{row['peak_bytes'] / 1e6:,.0f} MB",
                 row["peak_bytes"] <= most)
    slope = matrix.slope(scene, DEFAULT)
    if slope is not None:
        yield judged(name, f"slope ≤ {aims.MOST_SLOPE}", f"{slope:.3f}", slope <= aims.MOST_SLOPE)
    order = order_ns(matrix, scene)
    if order is not None:
        yield judged(name, f"order ≤ {aims.MOST_FOR_ORDER} ns a pair", f"{order:.1f} ns",
                     order <= aims.MOST_FOR_ORDER)


def order_ns(matrix, scene):
    """What canonical order adds for each pair, or None."""
    count = matrix.main_count(scene)
    found, ordered = (matrix.row(scene, count, DEFAULT, task=t) for t in ("list", "canonical"))
    if median(found) is None or median(ordered) is None or found["pairs"] < count / 10:
        return None
    return (median(ordered) - median(found)) * count / found["pairs"]


def claims(matrix):
    rows = [claim for scene in matrix.scenes for claim in claims_of_scene(matrix, scene)]
    rows += list(claims_of_forms(matrix)) + list(claims_of_lattices(matrix)) + list(claims_of_threads(matrix))
    met = sum(row[-1] == "yes" for row in rows)
    return (f"{met} of {len(rows)} are met.\n\n"
            + table(["scene, N", "required", "measured", "met"], rows))


def claims_of_forms(matrix):
    if "dense" not in matrix.scenes:
        return
    count = matrix.main_count("dense")
    ns = {t: matrix.ns("dense", count, DEFAULT, task=t) for t in FORMS}
    if None in ns.values():
        return
    for task, of, most in (("count", "list", 1.0), ("visit", "list", 1.0),
                           ("full_list", "half_list", aims.MOST_OF_FULL_LIST)):
        found = ns[task] / ns[of]
        yield judged(label(matrix, "dense"), f"{task} ≤ {most}× {of}", times(found), found <= most)


def claims_of_lattices(matrix):
    """A lattice that touches against random elements, both for each pair."""
    dense = ns_for_each_pair(matrix, "dense")
    for scene in ("touching_cubic", "touching_fcc"):
        found = ratio(ns_for_each_pair(matrix, scene), dense)
        if found is not None:
            yield judged(label(matrix, scene), "≤ 3× dense, for each pair", times(found),
                         found <= 3)


def ns_for_each_pair(matrix, scene):
    if scene not in matrix.scenes:
        return None
    row = matrix.row(scene, matrix.main_count(scene), DEFAULT)
    return None if median(row) is None else median(row) * row["elements"] / max(row["pairs"], 1)


def claims_of_threads(matrix):
    for count in (1_000_000, 10_000_000):
        found = ratio(matrix.ns("dense", count, DEFAULT),
                      matrix.ns("dense", count, DEFAULT, threads=2))
        if found is not None:
            yield judged(f"dense, {power(count)}", f"two threads ≥ {aims.LEAST_SPEEDUP}×",
                         times(found), found >= aims.LEAST_SPEEDUP)


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
                rows.append([label(matrix, scene, count)] + [plain(f) for f in found]
                            + [times(ratio(found[0], f)) for f in found[1:]])
    if not rows:
        return "No algorithm of these tables runs in more than one thread."
    head = ["scene, N"] + [f"{t} threads" if t > 1 else "1 thread" for t in matrix.threads]
    return table(head + [f"speedup of {t}" for t in matrix.threads[1:]], rows)


def without_end(matrix):
    """A line for each scene: who did not end within the time limit, from which N on."""
    first = {}
    for r in matrix.rows:
        if r["verdict"] == "too_slow" and r["task"] == "list" and r["threads"] == 1:
            of_scene = first.setdefault(r["scene"], {})
            n = of_scene.setdefault(r["contestant"], r["elements"])
            of_scene[r["contestant"]] = min(n, r["elements"])
    for scene, contestants in first.items():
        at = {n: [short(c) for c in contestants if contestants[c] == n]
              for n in sorted(set(contestants.values()))}
        yield f"* {scene}: no end within the time limit: " + "; ".join(
            f"from {power(n)} on {', '.join(who)}" for n, who in at.items())


def findings(matrix):
    """Wrong answers, crashes, refusals and runs without end, each with its reason."""
    lines = []
    told = set()
    for r in matrix.rows:
        place = f"{r['scene']}, {power(r['elements'])}, {short(r['contestant'])}"
        if r["verdict"] == "wrong":
            lines.append(f"* {place} ({r['task']}): **wrong**, {r['missing']:,} pairs missing, "
                         f"{r['extra']:,} too many of {r['pairs']:,}")
        elif r["verdict"] in ("refused", "crashed") and r["task"] == "list" and r["threads"] == 1:
            if (r["scene"], r["contestant"]) not in told:
                lines.append(f"* {place} (and more elements): {r['reason']}")
            told.add((r["scene"], r["contestant"]))
    lines += without_end(matrix)
    referees = list(dict.fromkeys(r["reference"] or "nobody" for r in matrix.rows))
    lines.append("* Compared with the pairs of: " + ", ".join(short(r) for r in referees))
    return "\n".join(lines)


def beside(matrix):
    """What another machine gives, with the times of all N."""
    head = (["scene, N", "abut `auto`", "aim", "grid / abut", "best package", "package / abut"]
            + [f"at {power(n)}" for n in matrix.counts] + ["slope", "2 threads"])
    rows = []
    for scene in matrix.scenes:
        count = matrix.main_count(scene)
        ours = matrix.ns(scene, count, DEFAULT)
        package_ns, package = matrix.best(scene, count, matrix.packages)
        rows.append([label(matrix, scene), plain(ours), plain(aims.AIMS.get(scene), 0),
                     times(ratio(matrix.ns(scene, count, "plain_grid"), ours)),
                     f"{plain(package_ns, 0)} {short(package) if package else ''}".strip(),
                     times(ratio(package_ns, ours))]
                    + [plain(matrix.ns(scene, n, DEFAULT)) for n in matrix.counts]
                    + [plain(matrix.slope(scene, DEFAULT), 3),
                       times(ratio(ours, matrix.ns(scene, count, DEFAULT, threads=2)))])
    return table(head, rows) + "\n\nMeasured on: " + machine(matrix)


SECTIONS = [("machine", machine), ("summary", summary), ("claims", claims), ("times", all_times),
            ("slopes", slopes), ("counters", counters), ("threads", threads),
            ("findings", findings)]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("results")
    parser.add_argument("--beside", action="store_true")
    parser.add_argument("--docs", default=os.path.join(ROOT, "docs", "benchmarks_matrix.md"))
    parser.add_argument("--images", default=os.path.join(ROOT, "docs", "images"))
    arguments = parser.parse_args()

    matrix = Matrix(arguments.results)
    if arguments.beside:
        rewrite_page(arguments.docs, [("beside", beside(matrix))])
        return
    plot.plot_all(matrix, arguments.images)
    rewrite_page(arguments.docs, [(name, section(matrix)) for name, section in SECTIONS])
    print(summary(matrix))
    print()
    print(findings(matrix))


if __name__ == "__main__":
    main()

"""The requirements of the engine, and whether the tables show that they are met."""

import dataclasses

from benchmarks.common.tables import table
from benchmarks.matrix import aims
from benchmarks.matrix.data import DEFAULT, median, ratio
from benchmarks.matrix.words import label, of_possible, short, times, yes_or_no

# The kinds of claims, as the short table names them.
TIME = "ns for each element: at most the aim"
GRID = (f"at least as fast as the plain grid; dense, ordered: "
        f"{aims.AGAINST_GRID['dense']}× as fast")
PACKAGES = "as many times as fast as every package as aimed"
ELSEWHERE = "the same against the best elsewhere, through the grid"
CHOICE = f"`auto` at most {aims.MOST_BEHIND_BEST_CHOICE}× the best algorithm"
TESTS = (f"tests for each element and pair: at most {aims.MOST_TESTS[True]}; "
         f"unequal sizes: {aims.MOST_TESTS[False]}")
MEMORY = "bytes: at most 80 N, and 8 for each pair beyond 3 N"
SLOPE = f"exponent of N: at most {aims.MOST_SLOPE}"
ORDER = (f"canonical order: at most {aims.MOST_FOR_ORDER[False]} ns a pair; numbered along space: "
         f"{aims.MOST_FOR_ORDER[True]}")
FIRST = f"first call: at most {aims.MOST_OF_FIRST_CALL}× a later one"
FORM = (f"count, visit: no slower than list; half list: at most {aims.MOST_OF_CANONICAL}× "
        f"canonical; full list: at most {aims.MOST_OF_FULL_LIST}× half")
SPREAD = f"radii within 5 %: at most {aims.MOST_OF_SPREAD}× equal radii"
LATTICE = "lattices that touch: at most 3× dense, for each pair"
THREADS = f"two threads at least {aims.LEAST_SPEEDUP}× as fast"
KINDS = [TIME, GRID, PACKAGES, ELSEWHERE, CHOICE, TESTS, MEMORY, SLOPE, ORDER, FIRST, FORM, SPREAD,
         LATTICE, THREADS]

FORMS = ["list", "canonical", "count", "visit", "half_list", "full_list"]


@dataclasses.dataclass(frozen=True)
class Claim:
    kind: str
    place: str  # scene and N
    wanted: str
    measured: str
    met: bool


def elsewhere(matrix, scene):
    """(library, how many times as fast as it we are), both measured against the plain grid."""
    count = matrix.main_count(scene)
    if scene not in aims.ELSEWHERE or count != aims.COUNT_ELSEWHERE:
        return "–", None
    library, seconds, grid_seconds = aims.ELSEWHERE[scene]
    against_grid = ratio(matrix.ns(scene, count, "plain_grid"), matrix.ns(scene, count, DEFAULT))
    return library, None if against_grid is None else seconds / grid_seconds * against_grid


def order_ns(matrix, scene):
    """Nanoseconds that canonical order adds for each pair, or None."""
    count = matrix.main_count(scene)
    found, ordered = (matrix.row(scene, count, DEFAULT, task=t) for t in ("list", "canonical"))
    if median(found) is None or median(ordered) is None or found["pairs"] < count / 10:
        return None
    return (median(ordered) - median(found)) * count / found["pairs"]


def of_scene(matrix, scene):
    count = matrix.main_count(scene)
    row = matrix.row(scene, count, DEFAULT)
    ours = median(row)
    if ours is None:
        return
    for n in matrix.counts:
        yield from of_aims(matrix, scene, n)
    wanted = aims.AGAINST_GRID.get(scene, aims.AGAINST_GRID_ELSEWHERE)
    found = ratio(matrix.ns(scene, count, "plain_grid"), ours)
    if found is not None:
        yield Claim(GRID, label(matrix, scene), f"≥ {wanted}× the plain grid", times(found),
                    found >= wanted)
    yield from of_choice(matrix, scene, ours)
    yield from of_counters(matrix, scene, row)


def of_aims(matrix, scene, count):
    """Time, and how many times as fast as libraries: at the main count and where an aim is."""
    ours, place = matrix.ns(scene, count, DEFAULT), label(matrix, scene, count)
    is_main = count == matrix.main_count(scene)
    if ours is None or not (is_main or (scene, count) in aims.AIMS):
        return
    aim = aims.AIMS.get((scene, count))
    if aim:
        yield Claim(TIME, place, f"≤ {aim.ns} ns, {aims.BASE}: {aim.before}", f"{ours:,.1f} ns",
                    ours <= aim.ns)
    wanted = aims.against_libraries(scene, count)
    if wanted is None:
        return
    found = ratio(matrix.best(scene, count, matrix.packages)[0], ours)
    if found is not None:
        yield Claim(PACKAGES, place, f"≥ {wanted}× every package", times(found), found >= wanted)
    library, found = elsewhere(matrix, scene) if is_main else ("–", None)
    if found is not None:
        yield Claim(ELSEWHERE, place, f"≥ {wanted}× {library}, through the grid", times(found),
                    found >= wanted)


def of_choice(matrix, scene, ours):
    count = matrix.main_count(scene)
    best, by = matrix.best(scene, count, [c for c in matrix.ours if c != DEFAULT])
    if best is not None:
        found = ours / best
        yield Claim(CHOICE, label(matrix, scene),
                    f"≤ {aims.MOST_BEHIND_BEST_CHOICE}× the best algorithm",
                    f"{found:.2f}× {short(by)}", found <= aims.MOST_BEHIND_BEST_CHOICE)


def of_counters(matrix, scene, row):
    count, pairs, place = row["elements"], row["pairs"], label(matrix, scene)
    most = aims.MOST_TESTS[scene not in aims.UNEQUAL_SIZES]
    tests = row["candidate_tests"] / (count + pairs)
    yield Claim(TESTS, place, f"≤ {most} tests × (N + pairs)", f"{tests:.2f}", tests <= most)
    most = aims.most_bytes(count, pairs)
    yield Claim(MEMORY, place, f"≤ {most / 1e6:,.0f} MB", f"{row['peak_bytes'] / 1e6:,.0f} MB",
                row["peak_bytes"] <= most)
    slope = matrix.slope(scene, DEFAULT)
    if slope is not None:
        yield Claim(SLOPE, place, f"slope ≤ {aims.MOST_SLOPE}", f"{slope:.3f}",
                    slope <= aims.MOST_SLOPE)
    order = order_ns(matrix, scene)
    if order is not None:
        most = aims.MOST_FOR_ORDER[scene in aims.NUMBERED_ALONG_SPACE]
        yield Claim(ORDER, place, f"order ≤ {most} ns a pair", f"{order:.1f} ns", order <= most)
    first = row["ns_first"] / median(row)
    yield Claim(FIRST, place, f"first call ≤ {aims.MOST_OF_FIRST_CALL}× a later one", times(first),
                first <= aims.MOST_OF_FIRST_CALL)


def of_forms(matrix):
    if "dense" not in matrix.scenes:
        return
    count = matrix.main_count("dense")
    ns = {t: matrix.ns("dense", count, DEFAULT, task=t) for t in FORMS}
    if None in ns.values():
        return
    for task, of, most in (("count", "list", 1.0), ("visit", "list", 1.0),
                           ("half_list", "canonical", aims.MOST_OF_CANONICAL),
                           ("full_list", "half_list", aims.MOST_OF_FULL_LIST)):
        found = ns[task] / ns[of]
        yield Claim(FORM, label(matrix, "dense"), f"{task} ≤ {most}× {of}", times(found),
                    found <= most)


def of_spread(matrix):
    if not {"dense", "dense_spread"} <= set(matrix.scenes):
        return
    found = ratio(*(matrix.ns(s, matrix.main_count(s), DEFAULT) for s in ("dense_spread", "dense")))
    if found is not None:
        yield Claim(SPREAD, label(matrix, "dense_spread"), f"≤ {aims.MOST_OF_SPREAD}× dense",
                    times(found), found <= aims.MOST_OF_SPREAD)


def ns_for_each_pair(matrix, scene):
    if scene not in matrix.scenes:
        return None
    row = matrix.row(scene, matrix.main_count(scene), DEFAULT)
    return None if median(row) is None else median(row) * row["elements"] / max(row["pairs"], 1)


def of_lattices(matrix):
    """A lattice that touches against random elements, both for each pair."""
    dense = ns_for_each_pair(matrix, "dense")
    for scene in (s for s in matrix.scenes if s.startswith("touching")):
        found = ratio(ns_for_each_pair(matrix, scene), dense)
        if found is not None:
            yield Claim(LATTICE, label(matrix, scene), "≤ 3× dense, for each pair", times(found),
                        found <= 3)


def of_threads(matrix):
    for scene in matrix.scenes:
        for count in (1_000_000, 10_000_000):
            found = matrix.speedup(scene, count, 2)
            if found is not None:
                yield Claim(THREADS, label(matrix, scene, count),
                            f"two threads ≥ {aims.LEAST_SPEEDUP}×",
                            of_possible(found, matrix.possible_speedup(scene, count, 2)),
                            found >= aims.LEAST_SPEEDUP)


def all_claims(matrix):
    return ([claim for scene in matrix.scenes for claim in of_scene(matrix, scene)]
            + [*of_forms(matrix), *of_spread(matrix), *of_lattices(matrix), *of_threads(matrix)])


def met(claims):
    return f"{sum(c.met for c in claims)} of {len(claims)}"


def long_table(matrix):
    claims = all_claims(matrix)
    rows = [[c.place, c.wanted, c.measured, yes_or_no(c.met)] for c in claims]
    return f"{met(claims)} are met.\n\n" + table(["scene, N", "required", "measured", "met"], rows)


def briefly(matrix, claim):
    """What was measured and where; the number of elements only where it is not the main one."""
    scene, count = claim.place.split(", ")
    where = scene if claim.place == label(matrix, scene) else f"{scene} at {count}"
    return f"{where} {claim.measured.removesuffix(' ns')}"


def short_table(matrix):
    """A row for each kind of claim."""
    claims = all_claims(matrix)
    rows = []
    for kind in KINDS:
        of_kind = [c for c in claims if c.kind == kind]
        if of_kind:
            missed = [briefly(matrix, c) for c in of_kind if not c.met]
            rows.append([kind, met(of_kind), ", ".join(missed) or "–"])
    return f"{met(claims)} are met.\n\n" + table(["required", "met", "not met"], rows)

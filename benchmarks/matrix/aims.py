"""The aims of the engine, and the times that others were measured to need."""

import dataclasses

# What came before: the commit that ratios in pages are to, as `benchmarks/matrix/run --compare`
# measures them.
BASE = "b2415f0"


@dataclasses.dataclass(frozen=True)
class Aim:
    """What is wanted of a list as found, in one thread."""
    before: float  # ns for each element that BASE took on a quiet machine
    ns: float  # for each element, at most
    of_base: float  # of the time of BASE, in one run with it, at most
    libraries: float | None  # times as fast as the best library, at least


AIMS = {
    ("dense", 100_000): Aim(54, 30, 0.6, 15),
    ("dense", 1_000_000): Aim(58, 33, 0.6, 20),
    ("dense", 10_000_000): Aim(73, 40, 0.6, 15),
    ("ordered", 1_000_000): Aim(55, 33, 0.6, 12),
    ("gas", 1_000_000): Aim(62, 32, 0.6, 15),
    ("sparse", 1_000_000): Aim(38, 30, 0.8, 4),
    ("clusters", 1_000_000): Aim(101, 55, 0.55, 7),
    ("clusters_100", 1_000_000): Aim(200, 60, 0.3, 3.5),
    ("bidisperse", 1_000_000): Aim(100, 60, 0.65, 10),
    ("log_uniform", 1_000_000): Aim(80, 50, 0.65, 10),
    ("log_uniform_1000", 1_000_000): Aim(100, 70, 0.7, 10),
    ("graded", 1_000_000): Aim(114, 70, 0.65, 10),
    ("graded_1000", 1_000_000): Aim(77, 55, 0.7, 10),
    ("hexagonal_2d", 1_000_000): Aim(39, 20, 0.55, 25),
    ("touching_cubic_shuffled", 1_000_000): Aim(226, 80, 0.4, None),
    ("touching_fcc_shuffled", 1_000_000): Aim(304, 110, 0.4, None),
}

# Where no aim says how many times as fast as the best library.
AGAINST_LIBRARIES = {"touching_cubic": 8, "touching_fcc": 8, "one_giant": 8}

# Times as fast as the plain grid; on all other scenes: no slower.
AGAINST_GRID = {"dense": 4, "ordered": 4}
AGAINST_GRID_ELSEWHERE = 1

# Seconds of the fastest library, packaged or not, and of a plain grid, measured side by
# side for the same job on one Zen 3 core with g++ 12 -O3 -march=native. LAMMPS, which sorts before
# the clock runs, is left aside. Through the plain grid those in no package can be compared.
COUNT_ELSEWHERE = 1_000_000
ELSEWHERE = {
    "dense": ("ArborX", 0.94, 0.20),
    "ordered": ("TreeNSearch", 0.42, 0.13),
    "gas": ("TreeNSearch", 0.50, 0.21),
    "sparse": ("box pruning", 0.12, 0.23),
    "clusters": ("box pruning", 0.45, 0.98),
    "bidisperse": ("box pruning", 0.58, 1.28),
    "log_uniform": ("box pruning", 0.64, 0.27),
    "hexagonal_2d": ("ArborX", 0.58, 0.12),
    "graded": ("box pruning", 0.69, 250.0),
}

MOST_SLOPE = 1.1
MOST_BEHIND_BEST_CHOICE = 1.2  # of what auto takes
NUMBERED_ALONG_SPACE = {"ordered", "touching_cubic", "touching_fcc"}
MOST_FOR_ORDER = {False: 8, True: 4}  # ns for each pair; whether numbered along space
MOST_OF_CANONICAL = 1.2  # that a half list takes
MOST_OF_FULL_LIST = 1.8
MOST_OF_FIRST_CALL = 1.25  # of a later one
MOST_OF_SPREAD = 1.15  # of equal radii
MOST_TESTS = {True: 20, False: 150}  # for each element and pair; whether sizes are equal
UNEQUAL_SIZES = {"bidisperse", "log_uniform", "log_uniform_1000", "graded", "graded_1000",
                 "boulders", "one_giant"}
LEAST_SPEEDUP = 1.85  # two threads, 10^6 and 10^7


def ns(scene, count):
    aim = AIMS.get((scene, count))
    return aim.ns if aim else None


def against_libraries(scene, count):
    aim = AIMS.get((scene, count))
    return aim.libraries if aim else AGAINST_LIBRARIES.get(scene)


def most_bytes(elements, pairs):
    """80 for an element with three pairs, and 8 for each pair beyond."""
    return 80 * elements + 8 * max(0, pairs - 3 * elements)

"""The aims of the engine, and the times that others were measured to need."""

# ns for each element at the main count, as found.
AIMS = {"dense": 40, "ordered": 25, "gas": 50, "sparse": 50, "clusters": 60, "bidisperse": 80,
        "log_uniform": 80, "graded": 100, "hexagonal_2d": 25}

# Times as fast as the plain grid; on all other scenes: no slower.
AGAINST_GRID = {"dense": 4, "ordered": 4}
AGAINST_GRID_ELSEWHERE = 1

# Times as fast as every packaged contestant, everywhere.
AGAINST_PACKAGES = 8

# Seconds of the fastest library, packaged or not, and of a plain grid, measured side by
# side for the same job on one Zen 3 core with g++ 12 -O3 -march=native. LAMMPS, which sorts before
# the clock runs, is left aside. Through the plain grid those that are in no package can be compared.
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
AGAINST_ELSEWHERE = {scene: 4 for scene in ELSEWHERE} | {"sparse": 2}

MOST_SLOPE = 1.1
MOST_BEHIND_BEST_CHOICE = 1.2  # of what auto takes
MOST_FOR_ORDER = 12  # ns for each pair
MOST_OF_FULL_LIST = 1.8
MOST_TESTS = {True: 20, False: 150}  # for each element and pair; whether sizes are equal
UNEQUAL_SIZES = {"bidisperse", "log_uniform", "log_uniform_1000", "graded", "graded_1000",
                 "one_giant"}
LEAST_SPEEDUP = 1.7  # two threads, dense, 10^6 and 10^7


def most_bytes(elements, pairs):
    return 100 * elements + 16 * pairs + 64_000_000

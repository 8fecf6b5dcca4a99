"""Reads the tables that matrix/run writes, one for each scene."""

import glob
import math
import os

from benchmarks.common import tables

# In the order of the plots and tables; a scene that is missing here comes last.
SCENES = ["dense", "dense_spread", "dense_stray", "boulders", "ordered", "gas", "sph",
          "sph_lattice", "sparse", "clusters", "clusters_100", "clusters_30", "shell", "crowds",
          "bidisperse", "polydisperse", "log_uniform", "log_uniform_1000", "graded",
          "graded_1000", "graded_by_place", "refined", "hexagonal_2d", "touching_cubic",
          "touching_fcc", "touching_cubic_shuffled", "touching_fcc_shuffled", "one_giant"]

YARDSTICKS = ["memcpy", "control_loop", "plain_grid"]
DEFAULT = "abut_auto"


def is_abut(contestant):
    return contestant.startswith("abut_")


class Matrix:
    """All rows, and questions to them. Times are nanoseconds for one element."""

    def __init__(self, folder):
        self.headers, self.rows = [], []
        for path in sorted(glob.glob(os.path.join(folder, "*.csv"))):
            header, rows = tables.read(path)
            self.headers.append(header)
            self.rows += rows
        if not self.rows:
            raise SystemExit(f"{folder} holds no tables: run benchmarks/matrix/run")
        known = {name: place for place, name in enumerate(SCENES)}
        self.scenes = sorted({r["scene"] for r in self.rows},
                             key=lambda s: (known.get(s, len(known)), s))
        self.counts = sorted({r["elements"] for r in self.rows})
        self.contestants = list(dict.fromkeys(r["contestant"] for r in self.rows))
        self.threads = sorted({r["threads"] for r in self.rows})

    def row(self, scene, elements, contestant, task="list", threads=1):
        for r in self.rows:
            if (r["scene"], r["elements"], r["contestant"], r["task"], r["threads"]) == (
                    scene, elements, contestant, task, threads):
                return r
        return None

    def ns(self, *wanted, **more):
        """The median, or None where nothing was timed."""
        return median(self.row(*wanted, **more))

    def best(self, scene, elements, contestants):
        """(ns, contestant) of the fastest, (None, None) if nobody finished."""
        timed = [(self.ns(scene, elements, c), c) for c in contestants]
        return min((t for t in timed if t[0] is not None), default=(None, None))

    def speedup(self, scene, elements, threads, contestant=DEFAULT, task="list"):
        """How many times as fast as one thread so many are, or None."""
        return ratio(*(self.ns(scene, elements, contestant, task=task, threads=t)
                       for t in (1, threads)))

    def possible_speedup(self, scene, elements, threads):
        """The same of the control loop: what the processors gave meanwhile."""
        return self.speedup(scene, elements, threads, "control_loop", "control")

    @property
    def ours(self):
        return [c for c in self.contestants if is_abut(c)]

    @property
    def packages(self):
        return [c for c in self.contestants if not is_abut(c) and c not in YARDSTICKS]

    def main_count(self, scene):
        """The number of elements that a scene is judged at: 10^6, one giant 10^5."""
        wanted = 100_000 if scene == "one_giant" else 1_000_000
        below = [n for n in self.counts if n <= wanted]
        return below[-1] if below else self.counts[0]

    def slope(self, scene, contestant):
        """Exponent of the total time in N over all sizes from 10^4 on that were timed, by least
        squares, or None."""
        points = [(n, self.ns(scene, n, contestant)) for n in self.counts
                  if n >= min(10_000, self.counts[-1])]
        points = [(math.log(n), math.log(n * ns)) for n, ns in points if ns]
        if len(points) < 2:
            return None
        x_mean = sum(x for x, _ in points) / len(points)
        y_mean = sum(y for _, y in points) / len(points)
        return (sum((x - x_mean) * (y - y_mean) for x, y in points)
                / sum((x - x_mean) ** 2 for x, _ in points))


def median(row):
    if row is None or row["ns_median"] == "":
        return None
    return row["ns_median"]


def ratio(numerator, denominator):
    return None if numerator is None or not denominator else numerator / denominator

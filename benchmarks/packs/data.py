"""Reads the tables that packs/run writes."""

import math
import os

from benchmarks.common import tables

ROMAN = {1: "I", 2: "II", 3: "III", 4: "IV"}
LOOSE_PACKS = [2, 3, 4]


def read(path):
    if not os.path.exists(path):
        raise SystemExit(f"{path} is missing: run benchmarks/packs/run without skipping it")
    return tables.read(path)


class Packs:
    def __init__(self, folder):
        self.header, self.times = read(os.path.join(folder, "times.csv"))
        # In the order of the registry, direct_check first.
        self.algorithms = list(dict.fromkeys(row["algorithm"] for row in self.times))
        _, self.instructions = read(os.path.join(folder, "instructions.csv"))

    def select(self, rows=None, **wanted):
        wanted.setdefault("numbering", "along")
        rows = self.times if rows is None else rows
        return [r for r in rows if all(r[k] == v for k, v in wanted.items())]

    def one(self, **wanted):
        """The only row there is, or None; a refused one counts as none."""
        rows = [r for r in self.select(form=wanted.pop("form", "count"), **wanted)]
        return rows[0] if rows and rows[0]["refusal"] == "" else None

    def instructions_of(self, **wanted):
        """Instructions for each element, or None."""
        rows = self.select(self.instructions, **wanted)
        return rows[0]["instructions"] / rows[0]["elements"] if rows else None

    def sizes(self):
        return sorted({r["elements"] for r in self.select(pack=1)})

    def first_of_slope(self):
        """Growth is judged from 10^4 elements on, where fixed costs are gone."""
        return 10_000 if 10_000 in self.sizes() else self.sizes()[0]

    def spacings(self, pack):
        return sorted({r["spacing"] for r in self.select(pack=pack)})


def book_integers(row):
    """Integers for each element by the book's formulas, or None where it has only a bound."""
    n = row["elements"]
    return {
        "direct_check": 0.0,
        "screening_array": (row["cells_x"] * row["cells_y"] + n) / n,
        "sorting_array": 3.0,
        "munjiza_nbs": (2 * n + row["cells_y"] + 2 * row["cells_x"]) / n,
    }.get(row["algorithm"])


def slope(small, large):
    """Exponent of the total time in N between two rows."""
    total = [r["ns_minimum"] * r["elements"] for r in (small, large)]
    return math.log(total[1] / total[0]) / math.log(large["elements"] / small["elements"])


def growth_beyond_n_log_n(small, large):
    """(value of large / value of small) / (log N large / log N small); pairs (N, value)."""
    return (large[1] / small[1]) / (math.log(large[0]) / math.log(small[0]))

"""Numbers behind docs/derivations/plane.md: pairs at the reach, and just behind the last column
that an element looks at, in single precision as src/engine/plane/ and src/kernels/plane/ do."""

import math
import random
import struct
import sys

TURNS = 20000
SEED = 47
ERROR_OF_DISTANCE, ERROR_OF_PLACE = 4 * 2.0**-20, 2.0**-7
SLACK = 2.0**-20
MOST = 8191
ROW_MARGIN = 1 + 2.0**-6


def single(value):
    """The float beside a double."""
    return struct.unpack("f", struct.pack("f", value))[0]


def place(position, per_unit, count):
    return int(min(single(position * per_unit), count - 1))


class Plane:
    """A grid of random shape for radii up to `largest`, as PlaneGrid::over lays it."""

    def __init__(self, draw):
        self.largest = math.ldexp(draw.uniform(0.5, 1.0), -draw.randint(2, 19))
        self.margin = draw.choice((0.0, 0.3 * self.largest))
        longest = draw.choice((1 - 2.0**-50, 0.5, draw.uniform(0.5, 1), 4 * self.largest))
        self.extent = longest, draw.uniform(0.0, 1.0) * longest
        self.reach = 2 * self.largest + self.margin + ERROR_OF_DISTANCE
        wanted = draw.choice((3, 50, 1000, MOST))
        self.columns = max(1, int(min(wanted, 8 * longest / self.reach, MOST)))
        self.rows = max(1, int(min(self.extent[1] / (self.reach * ROW_MARGIN), MOST)))
        self.per_column = single(self.columns / longest) if self.columns > 1 else 0.0
        self.per_row = single(self.rows / self.extent[1]) if self.rows > 1 else 0.0
        self.widest = int(self.reach * self.per_column + ERROR_OF_PLACE) + 1

    def ahead(self, radius):
        """L(i) for a sphere of that radius, in single precision."""
        if self.columns == 1:
            return 1
        farthest = single(self.largest + self.margin + ERROR_OF_DISTANCE
                          + ERROR_OF_PLACE / self.per_column)
        columns = single(single(single(radius) + farthest) * self.per_column)
        return min(int(columns) + 1, self.widest)

    def column(self, x):
        return place(single(x), self.per_column, self.columns)

    def row(self, y):
        return place(single(y), self.per_row, self.rows)


def is_apart(plane, radius, x, other_x):
    """Whether the distance along the first axis alone makes the filter call two spheres apart, of
    which the second one is as large as the largest."""
    difference = single(single(x) - single(other_x))
    square = single(difference * difference)
    outer = single(single(single(single(radius) + single(plane.margin)) + SLACK)
                   + single(plane.largest))
    return not square <= single(outer * outer)


def hardest(draw, plane, x, distance):
    """A position about that far ahead, often beside the border of a column."""
    other = x + distance * (1 - draw.choice((0.0, 2.0**-53, 2.0**-30)))
    if draw.random() < 0.5 and plane.columns > 1:
        border = round(other * plane.per_column) / plane.per_column
        shift = border - other + draw.uniform(-1, 1) * 2.0**-25
        if 0 <= x + shift and abs(shift) < 0.5 / plane.per_column:
            return x + shift, other + shift
    return x, other


def check(draw):
    """Returns how far a pair at the reach was from being overlooked, in columns."""
    plane = Plane(draw)
    radius = draw.choice((plane.largest, 0.0, draw.uniform(0, plane.largest)))
    reach = radius + plane.largest + plane.margin
    x, other = hardest(draw, plane, draw.uniform(0, plane.extent[0]), reach)
    looked = plane.ahead(radius)
    spare = looked - (plane.column(min(other, plane.extent[0])) - plane.column(x))
    assert spare >= 0 or other > plane.extent[0], (plane.__dict__, radius, x, other)
    if plane.rows > 1:
        y = draw.uniform(0, plane.extent[1])
        behind = min(y + 2 * plane.largest + plane.margin, plane.extent[1])
        assert plane.row(behind) - plane.row(y) <= 1, (plane.__dict__, y)
    beyond = plane.column(x) + looked + 1
    if plane.columns > 1 and beyond < plane.columns:
        nearest = beyond / plane.per_column
        while plane.column(nearest) >= beyond:
            nearest -= math.ulp(nearest) * 2.0**20
        while plane.column(nearest) < beyond:
            nearest += 2.0**-27
        assert is_apart(plane, radius, x, nearest), (plane.__dict__, radius, x, nearest)
    return spare


def main():
    draw = random.Random(SEED)
    spares = [check(draw) for _ in range(TURNS)]
    closest = sum(spare == 0 for spare in spares)
    assert closest > TURNS // 20, "the pairs are too easy"
    print(f"seed {SEED}: {TURNS} pairs at the reach, {closest} of them in the last column looked at;"
          " none beyond it, and what lies beyond is apart")


if __name__ == "__main__":
    sys.exit(main())

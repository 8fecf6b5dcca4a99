"""Numbers behind docs/derivations/layer_coarse.md: coarse spheres and boxes placed beside others,
in the box of these and far beyond it, tested as src/kernels/layers/ does and decided in fractions
as the contract does; what is within reach must lie in the rows in which they look."""

import math
import random
from fractions import Fraction

from check_layer_sizes import ROOM, SLACK, SLACK_OF_REACH, own_reach
from check_tile_filter import root, single
from check_whole_numbers import units

SPHERES = 6000
BOXES = 6000
SEED = 37
END = 2 ** 31 - 2 ** 21


class Axis:
    """A coarse element on an axis of a grid, as coarse_in_layers tells where it is."""

    def __init__(self, x, lower, units_of_one):
        position = (x - lower) * units_of_one
        self.place = math.floor(min(max(position, 0.0), END))
        self.beyond = single(position - self.place)

    def difference(self, other):
        """To a whole position, as the kernel computes it."""
        return single(single(float(other - self.place)) - self.beyond)

    def position(self):
        return self.place + self.beyond


def grid_of(draw):
    """Bits of a cell, its size, and the lower corner of the others."""
    bits = draw.choice([16, 20, 22])
    cell = draw.uniform(0.5, 2.0)
    lower = draw.choice([0.0, draw.uniform(-1, 1), draw.uniform(-1e6, 1e6)])
    return bits, cell, lower, 2.0 ** bits / cell


def slack_of(size, margin):
    return single(SLACK + single(SLACK_OF_REACH * own_reach(size, margin)))


def is_in(lower, upper, number, shift):
    """Whether the pieces 2^shift wide between two ends hold a whole position."""
    return math.floor(lower / 2 ** shift) <= number >> shift <= math.floor(upper / 2 ** shift)


def check_sphere(draw):
    """Returns whether the pair was certain."""
    bits, cell, lower, units_of_one = grid_of(draw)
    small = cell * draw.uniform(0.05, 0.45)
    large = small * 2.0 ** draw.uniform(0, 18)
    margin = draw.choice([0.0, 0.1 * small])
    slack = slack_of(single(large * units_of_one), single(margin * units_of_one))
    length = large + small + margin + draw.uniform(-2, 2) * slack / units_of_one
    direction = [draw.uniform(-1.0, 1.0) for _ in range(3)]
    norm = math.sqrt(sum(d * d for d in direction))
    other = [lower + draw.uniform(0.0, 2.0 ** draw.uniform(0, 9)) * cell for _ in range(3)]
    coarse = [x + d / norm * length for x, d in zip(other, direction)]
    axes = [Axis(x, lower, units_of_one) for x in coarse]
    whole = [units(x, lower, units_of_one) for x in other]

    a, b, m = (single(x * units_of_one) for x in (large, small, margin))
    nearest = max(single(single(a + single(m - slack)) + b), 0.0)
    farthest = single(single(a + single(m + slack)) + b)
    square = 0.0
    for axis, q in zip(axes, whole):
        d = axis.difference(q)
        square = single(square + single(d * d))
    real = Fraction(large) + Fraction(small) + Fraction(margin)
    distance = root(sum((Fraction(p) - Fraction(q)) ** 2 for p, q in zip(coarse, other)))
    within = square < single(nearest * nearest)
    apart = not square <= single(farthest * farthest)
    if within and distance > real or apart and distance <= real:
        raise SystemExit(f"decided wrongly: {coarse} {other} {large} {small} {margin}")
    if distance <= real:
        reach = (a + b + (m + 8.0)) * ROOM
        left = reach * reach
        for axis, q, shift in zip(axes[::-1], whole[::-1], (bits, bits, bits - 2)):
            half = math.sqrt(max(left, 0.0))
            x = axis.position()
            if left < 0.0 or not is_in(x - half, x + half, q, shift):
                raise SystemExit(f"not looked at: {coarse} {other} {large} {small} {margin}")
            begin = (q >> shift) << shift
            left -= max(begin - x, x - (begin + 2 ** shift), 0.0) ** 2
    return within or apart


def check_box(draw):
    """The same of the ends of two boxes along an axis."""
    bits, cell, lower, units_of_one = grid_of(draw)
    small = cell * draw.uniform(0.05, 0.9)
    widest = small * 2.0 ** draw.uniform(0, 18)
    width = widest * draw.choice([1.0, 0.01])
    margin = draw.choice([0.0, 0.1 * small])
    slack = slack_of(single(0.5 * single(widest * units_of_one)), single(margin * units_of_one))
    other = lower + draw.uniform(0.0, 2.0 ** draw.uniform(0, 9)) * cell
    off = margin + draw.uniform(-2, 2) * slack / units_of_one
    coarse = draw.choice([other - width - off, other + small + off,
                          other - draw.uniform(0.0, 1.0) * width])
    axis = Axis(coarse, lower, units_of_one)
    q = units(other, lower, units_of_one)

    # Upper ends are the numbers that are given.
    upper, other_upper = coarse + width, other + small
    w, v, m = (single(x * units_of_one) for x in (upper - coarse, other_upper - other, margin))
    d = axis.difference(q)
    gap = max(single(d - w), single(single(0.0 - d) - v))
    real = max(Fraction(other) - Fraction(upper), Fraction(coarse) - Fraction(other_upper))
    within, apart = gap < single(m - slack), gap > single(m + slack)
    if within and real > Fraction(margin) or apart and real <= Fraction(margin):
        raise SystemExit(f"decided wrongly: {coarse} {width} {other} {small} {margin}")
    if real <= Fraction(margin):
        x = axis.position()
        more = abs(x) * (ROOM - 1.0)
        below, above = ((size + m + 8.0) * ROOM + more for size in (v, w))
        if not is_in(x - below, x + above, q, bits - 2):
            raise SystemExit(f"not looked at: {coarse} {width} {other} {small} {margin}")
    return within or apart


def main():
    draw = random.Random(SEED)
    spheres = sum(check_sphere(draw) for _ in range(SPHERES))
    boxes = sum(check_box(draw) for _ in range(BOXES))
    # A filter that decides nothing would never be wrong.
    if spheres < SPHERES // 4 or boxes < BOXES // 4:
        raise SystemExit(f"only {spheres} and {boxes} pairs were certain")
    print(f"seed {SEED}: {spheres} of {SPHERES} pairs of spheres and {boxes} of {BOXES} of boxes "
          "were certain, and right; all within reach were looked at")


if __name__ == "__main__":
    main()

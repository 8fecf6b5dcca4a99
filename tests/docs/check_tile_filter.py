"""Numbers behind docs/derivations/tile_filter.md: pairs made to hurt, decided in single precision
as src/kernels/ does and in fractions as the contract does; and cells of pairs beside faces."""

import math
import random
import struct
import sys
from fractions import Fraction

PAIRS = 5000
SEED = 20
UNIT = Fraction(1, 1 << 23)  # errors are told in this
BOUND_IN_TILE, BOUND_OF_VISITOR = Fraction(481, 100), Fraction(134, 10)  # sections 3 and 4
SLACK_IN_TILE, SLACK_OF_VISITOR = 8, 32  # filter_slack; 4 * relative_error, times the largest


def single(value):
    """The float beside a double. One operation on two floats, done in double and then rounded, is
    the operation of single precision: 53 bits are more than 2 * 24 + 1."""
    return struct.unpack("f", struct.pack("f", value))[0]


def next_single(value):
    """The float above a positive one."""
    bits, = struct.unpack("I", struct.pack("f", value))
    return struct.unpack("f", struct.pack("I", bits + 1))[0]


def root(square):
    """The root of a fraction, to 2^-90."""
    return Fraction(math.isqrt(square.numerator * (1 << 180) // square.denominator), 1 << 90)


def nearly_half_way(value, sign):
    """A double almost half a float's last place beside `value`, so that it is rounded farthest."""
    step = math.ldexp(1.0, math.frexp(value)[1] - 24)
    return single(value) + sign * 0.499999 * step


def filter_of(one, other, margin, equal):
    """(square, sum of radii, slack -> (farthest, nearest)) by the sequence of the kernels."""
    square = 0.0
    for p, q in zip(one[0], other[0]):
        difference = single(single(p) - single(q))
        square = single(square + single(difference * difference))
    reach = single(single(one[1]) + single(margin))
    if equal:
        reach = single(reach + single(other[1]))

    def bounds(slack):
        outer, inner = single(reach + slack), single(reach - slack)
        if not equal:
            outer, inner = single(outer + single(other[1])), single(inner + single(other[1]))
        inner = max(inner, 0.0)
        return single(outer * outer), single(inner * inner)
    return square, bounds


def random_pair(draw, largest, equal):
    """Two elements whose distance is about their reach; `largest` > 1 makes the first a visitor."""
    direction = [draw.choice([-1, 1]) * draw.uniform(0.9, 1.0) for _ in range(3)]
    length = sum(d * d for d in direction) ** 0.5
    visits = largest > 1
    margin = draw.choice([0.0, draw.uniform(0, 0.2)])
    small = nearly_half_way(draw.uniform(0.3, 0.39), draw.choice([-1, 1]))
    large = nearly_half_way(draw.uniform(0.3, 0.9) * largest, draw.choice([-1, 1]))
    radius = small if equal or not visits else large
    reach = radius + small + margin
    corner = [draw.uniform(0.0, 1.0) if visits else draw.uniform(1.0, 1.99) for _ in range(3)]
    # A little off, so that some pairs touch in the end, when their centers have been moved.
    reach += draw.uniform(-4, 4) * float(UNIT) * largest
    beyond = [x + d / length * reach for x, d in zip(corner, direction)]
    outwards = draw.choice([-1, 1])
    signs = [outwards if d > 0 else -outwards for d in direction]
    first, second = (beyond, corner) if visits else (corner, beyond)
    first = [nearly_half_way(x, s) for x, s in zip(first, signs)]
    second = [nearly_half_way(x, -s) for x, s in zip(second, signs)]
    return (first, radius), (second, small), margin


def worst_error(draw, largest, equal):
    """The largest error of a comparison, in units of 2^-23 times the largest number."""
    worst = Fraction(0)
    for _ in range(PAIRS):
        one, other, margin = random_pair(draw, largest, equal)
        scale = max([1.0, one[1]] + [abs(x) for x in one[0]]) if largest > 1 else 1.0
        square, bounds = filter_of(one, other, margin, equal)
        distance = root(sum((Fraction(p) - Fraction(q)) ** 2 for p, q in zip(one[0], other[0])))
        reach = Fraction(one[1]) + Fraction(other[1]) + Fraction(margin)
        slack = (SLACK_OF_VISITOR if largest > 1 else SLACK_IN_TILE) * float(UNIT) * scale
        farthest, nearest = bounds(slack)
        if square > farthest and distance <= reach or square < nearest and distance >= reach:
            raise SystemExit(f"decided wrongly: {one} {other} margin {margin}")
        # The computed distance and reach, and how far their difference is off.
        off = root(Fraction(square)) - root(Fraction(bounds(0.0)[0])) - distance + reach
        worst = max(worst, abs(off) / UNIT / Fraction(scale))
    return worst


def cells_apart(draw, margin):
    """How many of many pairs at most a reach apart fall two cells apart, by framed() of
    src/engine/tiles/sorted_tile.cpp."""
    lost = 0
    for _ in range(60000):
        count = draw.choice([2, 3, 18, 1000, 1023, 1024])
        size = draw.uniform(0.5, 1.0)
        reach = size / count / (1.0 + margin)
        per_unit = next_single(single(count / size))
        lower = draw.randrange(count) * (size / count) + draw.uniform(-2e-7, 2e-7)
        framed = [single(single(single(x) * per_unit) + 1.0) for x in (lower, lower + reach)]
        first, second = (int(min(max(q, 0.0), count + 1.0)) for q in framed)
        lost += second - first > 1
    return lost


def main():
    draw = random.Random(SEED)
    problems = []
    for name, largest, bound in [("in a tile", 1, BOUND_IN_TILE),
                                 ("visitors", 1 << 10, BOUND_OF_VISITOR)]:
        for equal in (False, True):
            worst = worst_error(draw, largest, equal)
            print(f"{name}, equal radii {equal}: off by {float(worst):.2f} of {float(bound)}")
            # Far below the bound, the pairs would be too tame to show a bound that is wrong.
            if not bound / 8 < worst <= bound:
                problems.append(f"{name}: {float(worst)}")
    without, having = cells_apart(draw, 0.0), cells_apart(draw, 2.0 ** -10)
    print(f"two cells apart: {without} pairs without the margin, {having} with it")
    if having or not without:
        problems.append("the margin of the cells")
    print(f"{len(problems)} problems, seed {SEED}")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())

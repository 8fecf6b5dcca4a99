"""Numbers behind docs/derivations/whole_numbers.md: pairs made to hurt, placed and decided as
src/device/bodies/ does and in fractions as the contract does; and cells of pairs beside faces."""

import math
import random
import sys
from fractions import Fraction

from check_tile_filter import root, single

PAIRS = 6000
SEED = 22
UNITS = 1 << 20
BOUND_IN_LEVEL = Fraction(301, 100)  # section 3, in units
BOUND_OF_COARSE = Fraction(306, 100)  # section 4, beside 0.45 2^-20 of the reach
BOUNDS_OF_BOXES = Fraction(-156, 100), Fraction(356, 100)  # section 9
SLACK, SLACK_OF_REACH = 4.0, 2.0 ** -20


def units(x, lower, units_of_one):
    """units_along of src/device/bodies/frame.hpp."""
    return math.floor((x - lower) * units_of_one)


def near_a_unit(x, lower, units_of_one, above):
    """A double beside x where the product is just above or just below a whole number."""
    whole = round((x - lower) * units_of_one)
    x = lower + whole / units_of_one
    aim = math.inf if above else -math.inf
    for _ in range(8):
        if (units(x, lower, units_of_one) >= whole) == above:
            return x
        x = math.nextafter(x, aim)
    return x


def nearly_half_way(value, sign):
    """A positive double almost half a float's last place beside a float."""
    step = math.ldexp(1.0, math.frexp(value)[1] - 24)
    return single(value) + sign * 0.499999 * step


def distance_squared(one, other):
    """Of whole numbers, in single precision."""
    square = 0.0
    for p, q in zip(one, other):
        difference = single(float(p - q))
        square = single(square + single(difference * difference))
    return square


def random_case(draw, coarse):
    """Two elements about a reach apart in a level: (lower, units_of_one, centers, radii, margin)."""
    cell = draw.uniform(0.5, 2.0)
    units_of_one = UNITS / cell
    lower = draw.choice([0.0, draw.uniform(-1, 1), draw.uniform(-1e6, 1e6)])
    widest = 2.0 ** draw.choice([2, 10, 20, 29.99])
    reach = cell / (1 + 2.0 ** -10) * (2.0 ** draw.uniform(0, 10) if coarse else 1.0)
    radii = [nearly_half_way(draw.uniform(0.3, 0.39) * reach * units_of_one, s) / units_of_one
             for s in (draw.choice([-1, 1]), draw.choice([-1, 1]))]
    margin = draw.choice([0.0, draw.uniform(0, 0.2)]) * reach
    length = sum(radii) + margin + draw.uniform(-4, 4) / units_of_one
    direction = [draw.uniform(0.9, 1.0) for _ in range(3)]
    norm = math.sqrt(sum(d * d for d in direction))
    outwards = draw.choice([False, True])
    first, second = [], []
    for d in direction:
        x = lower + draw.uniform(0.0, widest) * cell
        first.append(near_a_unit(x, lower, units_of_one, not outwards))
        second.append(near_a_unit(x + d / norm * length, lower, units_of_one, outwards))
    return lower, units_of_one, (first, second), radii, margin


def worst_error(draw, coarse):
    """The largest error of a comparison, in units; of coarse ones less what the reach is granted."""
    worst = Fraction(0)
    for _ in range(PAIRS):
        lower, units_of_one, centers, radii, margin = random_case(draw, coarse)
        one, other = ([units(x, lower, units_of_one) for x in c] for c in centers)
        square = distance_squared(one, other)
        floats = [single(r * units_of_one) for r in radii]
        if coarse:
            own = radii[0] + margin
            reach = single(single(own * units_of_one) + floats[1])
            slack = single(SLACK + single(SLACK_OF_REACH * single((own + radii[1]) * units_of_one)))
        else:
            reach = single(single(floats[0] + floats[1]) + single(margin * units_of_one))
            slack = SLACK
        distance = root(sum((Fraction(p) - Fraction(q)) ** 2 for p, q in zip(*centers)))
        real = Fraction(radii[0]) + Fraction(radii[1]) + Fraction(margin)
        farthest, nearest = single(reach + slack), single(reach - slack)
        apart = square > single(farthest * farthest)
        within = nearest > 0 and square < single(nearest * nearest)
        if apart and distance <= real or within and distance > real:
            raise SystemExit(f"decided wrongly: {centers} {radii} margin {margin}")
        scale = Fraction(units_of_one)
        off = abs(root(Fraction(square)) - Fraction(reach) - (distance - real) * scale)
        granted = Fraction(45, 100) * Fraction(SLACK_OF_REACH) * real * scale if coarse else 0
        worst = max(worst, off - granted)
    return worst


def errors_of_boxes(draw):
    """The least and the largest error of what BoxSizes::compare takes for two boxes, in units."""
    least = largest = Fraction(0)
    for _ in range(PAIRS):
        cell = draw.uniform(0.5, 2.0)
        units_of_one = UNITS / cell
        lower = draw.choice([0.0, draw.uniform(-1, 1), draw.uniform(-1e6, 1e6)])
        at = lower + draw.uniform(0.0, 2.0 ** draw.choice([2, 10, 20, 29.99])) * cell
        below = draw.choice([False, True])
        width, margin = (draw.randrange(1, UNITS // 3) for _ in range(2))
        # Just below whole numbers of units, what is floored loses most; just above them, least.
        off = draw.choice([0.001, 0.999])
        first = near_a_unit(at, lower, units_of_one, below)
        end = first + (width + off) / units_of_one
        margin = (margin + off) / units_of_one
        second = near_a_unit(end + margin + draw.uniform(-3, 3) / units_of_one, lower, units_of_one,
                             not below)
        told = (units(second, lower, units_of_one) - units(first, lower, units_of_one)
                - math.floor((end - first) * units_of_one) - math.floor(margin * units_of_one))
        real = (Fraction(second) - Fraction(end) - Fraction(margin)) * Fraction(units_of_one)
        least, largest = min(least, told - real), max(largest, told - real)
    return least, largest


def cells_apart(draw, margin):
    """How many of many pairs a reach apart fall two cells apart."""
    lost = 0
    for _ in range(60000):
        reach = draw.uniform(0.5, 2.0)
        cell = reach * (1.0 + margin)
        units_of_one = UNITS / cell
        lower = draw.uniform(-1, 1) * draw.choice([0, 1, 1e3])
        face = draw.randrange(1, 1 << draw.choice([2, 10, 20, 29])) * cell
        x = math.nextafter(lower + face, -math.inf)
        y = x + reach
        if Fraction(y) - Fraction(x) > Fraction(reach):
            y = math.nextafter(y, -math.inf)
        first, second = (units(at, lower, units_of_one) // UNITS for at in (x, y))
        lost += second - first > 1
    return lost


def main():
    draw = random.Random(SEED)
    problems = []
    for name, coarse, bound in [("in a level", False, BOUND_IN_LEVEL),
                                ("coarse elements", True, BOUND_OF_COARSE)]:
        worst = worst_error(draw, coarse)
        print(f"{name}: off by {float(worst):.2f} of {float(bound)} units")
        # Far below the bound, the pairs would be too tame to show a bound that is wrong.
        if not bound / 3 < worst <= bound:
            problems.append(f"{name}: {float(worst)}")
    errors = errors_of_boxes(draw)
    print("boxes: off by {:.2f} to {:.2f}, ".format(*map(float, errors))
          + "of {:.2f} to {:.2f} units".format(*map(float, BOUNDS_OF_BOXES)))
    for error, bound in zip(errors, BOUNDS_OF_BOXES):
        if not abs(bound) / 3 < abs(error) <= abs(bound):
            problems.append(f"boxes: {float(error)}")
    without, having = cells_apart(draw, 0.0), cells_apart(draw, 2.0 ** -10)
    print(f"two cells apart: {without} pairs without the margin, {having} with it")
    if having or not without:
        problems.append("the margin of the cells")
    print(f"{len(problems)} problems, seed {SEED}")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())

"""Numbers behind docs/derivations/layer_sizes.md: own reaches made to hurt; pairs of far elements
placed and decided as src/kernels/layers/ does and in fractions as the contract does; and small
systems, in which each pair within reach must lie in the rows where the larger element looks."""

import math
import random
import sys
from fractions import Fraction

from check_tile_filter import root, single
from check_whole_numbers import UNITS, distance_squared, near_a_unit, nearly_half_way, units

REACHES = 20000
PAIRS = 6000
SYSTEMS = 40
SEED = 31
SLACK, SLACK_OF_REACH, ROOM = 4.0, 2.0 ** -20, 1.0 + 2.0 ** -18
NEAR, MIDDLE = 2.0 ** 19, 2.0 ** 20


def own_reach(radius, margin):
    """layer_kernels.hpp; floats."""
    return single(single(radius + radius) + single(margin + 8.0))


def smallest_room(draw):
    """The least of h - s, in units, over radii of which the larger is the first as a float."""
    least = math.inf
    for _ in range(REACHES):
        size = 2.0 ** draw.uniform(-4, 19)
        radius, margin = (nearly_half_way(x, -1) for x in (size, draw.choice([1e-9, size, 1e5])))
        reach = own_reach(single(radius), single(margin))
        if reach >= MIDDLE:
            continue
        # The other one has the same float, from as far above it as rounding allows.
        other = nearly_half_way(single(radius), 1)
        if single(other) != single(radius):
            other = single(radius)
        real = Fraction(max(radius, other)) * 2 + Fraction(margin)
        least = min(least, float(math.floor(reach) - real))
    return least


def far_case(draw):
    """A far element and a smaller one about a reach apart."""
    cell = draw.uniform(0.5, 2.0)
    units_of_one = UNITS / cell
    lower = draw.choice([0.0, draw.uniform(-1, 1), draw.uniform(-1e6, 1e6)])
    size = draw.uniform(0.4, 2.0 ** draw.uniform(0, 8)) * cell
    radii = [nearly_half_way(r * units_of_one, draw.choice([-1, 1])) / units_of_one
             for r in (size, size * draw.choice([1.0, 0.5, 0.01]))]
    margin = draw.choice([0.0, 0.1 * size])
    length = sum(radii) + margin + draw.uniform(-2, 2) * (SLACK + SLACK_OF_REACH * 2 * size
                                                         * units_of_one) / units_of_one
    direction = [draw.uniform(0.9, 1.0) for _ in range(3)]
    norm = math.sqrt(sum(d * d for d in direction))
    outwards = draw.choice([False, True])
    one, other = [], []
    for d in direction:
        x = lower + draw.uniform(0.0, 1000.0) * cell
        one.append(near_a_unit(x, lower, units_of_one, not outwards))
        other.append(near_a_unit(x + d / norm * length, lower, units_of_one, outwards))
    return (lower, units_of_one), (one, other), radii, margin


def check_far_pairs(draw):
    """Returns how often a pair was certain, and the largest part of its slack that one took."""
    certain, worst = 0, Fraction(0)
    for _ in range(PAIRS):
        frame, centers, radii, margin = far_case(draw)
        one, other = ([units(x, *frame) for x in center] for center in centers)
        a, b, m = (single(x * frame[1]) for x in (*radii, margin))
        if b > a:
            a, b = b, a
        slack = single(SLACK + single(SLACK_OF_REACH * own_reach(a, m)))
        nearest = max(single(single(a + single(m - slack)) + b), 0.0)
        farthest = single(single(a + single(m + slack)) + b)
        square = distance_squared(one, other)
        distance = root(sum((Fraction(p) - Fraction(q)) ** 2 for p, q in zip(*centers)))
        real = sum(map(Fraction, radii)) + Fraction(margin)
        within = square < single(nearest * nearest)
        apart = not square <= single(farthest * farthest)
        if within and distance > real or apart and distance <= real:
            raise SystemExit(f"decided wrongly: {centers} {radii} {margin}")
        certain += within or apart
        off = root(Fraction(square)) - (distance + 0) * Fraction(frame[1])
        worst = max(worst, abs(off) / Fraction(slack))
    return certain, worst


def pieces(position, half, shift):
    return (position - half) >> shift, (position + half) >> shift


def looks(position, radius, margin, other):
    """Whether the rows in which an element looks hold another position."""
    reach = own_reach(radius, margin)
    cells = [q >> 20 for q in other]
    column = other[0] >> 18
    if reach < MIDDLE:
        half = int(reach)
        ranges = [pieces(q, half, 20) for q in position[1:]]
        if reach < NEAR and any(last - first > 1 for first, last in ranges):
            raise SystemExit("a near element cuts three rows")
        if any(not first - 0 <= c <= last for c, (first, last) in zip(cells[1:], ranges)):
            return False
        first, last = pieces(position[0], half, 18)
        return first <= column <= last
    far = reach * ROOM
    first, last = pieces(position[2], int(min(far, 2.0 ** 31)) + 1, 20)
    square = far * far - gap(position[2], cells[2]) ** 2
    if not first <= cells[2] <= last or square < 0.0:
        return False
    first, last = pieces(position[1], int(math.sqrt(square)) + 1, 20)
    if not first <= cells[1] <= last:
        return False
    if last - first >= 4:
        square = max(square - gap(position[1], cells[1]) ** 2, 0.0)
    first, last = pieces(position[0], int(math.sqrt(square)) + 1, 18)
    return first <= column <= last


def gap(position, cell):
    lower = cell << 20
    return float(max(lower - position, position - (lower + (1 << 20) - 1), 0))


def check_systems(draw):
    """Returns the number of pairs within reach, each of which the larger element looks at."""
    pairs = 0
    for _ in range(SYSTEMS):
        cell = draw.uniform(0.5, 2.0)
        units_of_one = UNITS / cell
        side = draw.choice([2.0, 6.0, 30.0]) * cell
        centers = [[draw.uniform(0.0, side) for _ in range(3)] for _ in range(60)]
        radii = [cell * 2.0 ** draw.uniform(-4, 4) for _ in centers]
        margin = draw.choice([0.0, 0.1, 1.0]) * cell
        stored = [[units(x, 0.0, units_of_one) for x in center] for center in centers]
        size = [single(r * units_of_one) for r in radii]
        for j in range(len(centers)):
            for i in range(j):
                square = sum((Fraction(p) - Fraction(q)) ** 2
                             for p, q in zip(centers[i], centers[j]))
                if square > (Fraction(radii[i]) + Fraction(radii[j]) + Fraction(margin)) ** 2:
                    continue
                pairs += 1
                large, small = (i, j) if (size[i], i) > (size[j], j) else (j, i)
                if not looks(stored[large], size[large], single(margin * units_of_one),
                             stored[small]):
                    raise SystemExit(f"not looked at: {centers[large]} {centers[small]}")
    return pairs


def main():
    print(f"seed {SEED}")
    draw = random.Random(SEED)
    room = smallest_room(draw)
    certain, worst = check_far_pairs(draw)
    pairs = check_systems(draw)
    print(f"own reach exceeds the reach by {room:.2f} units at least (6.8 are used)")
    print(f"far pairs: {certain} of {PAIRS} certain; distances off by {float(worst):.2f} of the slack")
    print(f"{pairs} pairs within reach, all looked at")
    if room < 6.8 or not PAIRS // 10 < certain < PAIRS or worst > 1 or pairs < 1000:
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())

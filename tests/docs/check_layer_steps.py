"""Numbers behind docs/derivations/layer_steps.md: elements at multiples of a power of two, placed and
decided as src/engine/layers/ does and in fractions as the contract does; pairs beside faces of cells
and columns; and sums of moves by lattice vectors."""

import math
import random
import sys
from fractions import Fraction

PAIRS = 20000
SEED = 31
CELL = 1 << 13  # units
FEWEST, MOST = 8, 1 << 24  # units of a step
END = (1 << 28) - (1 << 18)  # of positions
BOUND_OF_SQUARES = 1 << 30


class Grid:
    """LayerGrid::in_steps."""

    def __init__(self, reach, step, wide=1.0):
        cell = reach * (1 + 2.0 ** -10) * wide
        self.step = step
        self.units = min(math.floor(math.ldexp(step / cell, 13)), MOST)
        self.units_of_one = self.units / step
        self.fits = self.units >= FEWEST
        halvings = 1 if CELL > 1.5 * (reach * self.units_of_one) else 2
        self.shift = 13 - halvings
        self.columns = int((reach * self.units_of_one) / (1 << self.shift)) + 1

    def position(self, x, lower):
        return math.floor((x - lower) * self.units_of_one)


def largest_square(diameter, margin, step, units):
    """largest_square_within, and by how much its first estimate is off."""
    reach = Fraction(units) * (Fraction(diameter) + Fraction(margin)) / Fraction(step)
    rounded = units / step * (diameter + margin)
    square = estimate = int(rounded * rounded)
    while square > reach * reach:
        square -= 1
    while square + 1 <= reach * reach:
        square += 1
    return square, estimate - square


def random_reach(draw, step):
    """(diameter, margin): the root of a whole number of steps, or beside it, or anything."""
    steps = draw.choice([draw.uniform(0.001, 1.0), draw.uniform(1.0, 900.0),
                         math.sqrt(draw.randrange(1, 500)), float(draw.randrange(1, 900))])
    diameter = steps * step
    for _ in range(draw.randrange(3)):
        diameter = math.nextafter(diameter, draw.choice([-math.inf, math.inf]))
    margin = draw.choice([0.0, 0.0, math.ulp(diameter) / 2, diameter * draw.uniform(0.0, 0.3)])
    return diameter, margin


def decide_pairs(draw):
    """Each pair as fractions decide it; returns the largest square in a run, and how often the first
    estimate of the largest square was wrong."""
    largest, corrected = 0, 0
    for _ in range(PAIRS):
        step = 2.0 ** draw.choice([0, draw.randrange(-40, 40), draw.randrange(-800, 800)])
        diameter, margin = random_reach(draw, step)
        grid = Grid(diameter + margin, step, draw.choice([1.0, 1.0, draw.uniform(1.0, 4.0)]))
        if not grid.fits:
            continue
        square, off = largest_square(diameter, margin, step, grid.units)
        corrected += off != 0
        reach = Fraction(diameter) + Fraction(margin)
        most = math.floor(reach / Fraction(step))
        first = [draw.randrange(0, max(1, END // grid.units - 2 * most - 2)) for _ in range(3)]
        apart = [draw.randint(-most - 1, most + 1) for _ in range(3)]
        second = [m + d for m, d in zip(first, apart)]
        corner = draw.choice([0, draw.randrange(-2 ** 20, 2 ** 20), draw.choice([-1, 1]) * 2 ** 51])
        lower = corner * step
        places = [[grid.position((corner + m) * step, lower) for m in center]
                  for center in (first, second)]
        if places != [[m * grid.units for m in center] for center in (first, second)]:
            raise SystemExit(f"placed wrongly: {step} {grid.units} {first} {second}")
        whole = sum((p - q) ** 2 for p, q in zip(*places))
        within = sum(d * d for d in apart) * Fraction(step) ** 2 <= reach ** 2
        if (whole <= square) != within:
            raise SystemExit(f"decided wrongly: {step} {apart} reach {float(reach)}")
        if within and any(abs(p // CELL - q // CELL) > 1 for p, q in zip(*places)):
            raise SystemExit("two cells apart")
        if within and abs((places[0][0] >> grid.shift) - (places[1][0] >> grid.shift)) > grid.columns:
            raise SystemExit("more columns apart than a run has")
        farthest = ((grid.columns + 1) << grid.shift) - 1
        largest = max(largest, farthest ** 2 + 2 * (2 * CELL - 1) ** 2)
    return largest, corrected


def columns_short(draw):
    """How many pairs on one axis lie in more columns than a run with one column less has."""
    short = 0
    for _ in range(PAIRS):
        most = draw.randrange(1, 900)
        grid = Grid(float(most), 1.0)
        if not grid.fits:
            continue
        place = draw.randrange(0, 10000) * grid.units
        columns = (place + most * grid.units >> grid.shift) - (place >> grid.shift)
        short += columns > grid.columns - 1
    return short


def add_moves(draw):
    """Sums of moves by whole vectors below 2^48 steps, as floats and as fractions."""
    for _ in range(PAIRS):
        step = 2.0 ** draw.randrange(-60, 60)
        x = draw.randrange(-2 ** 45, 2 ** 45) * step
        total, exact = x, Fraction(x)
        for _ in range(3):
            vector = draw.randrange(-2 ** 20, 2 ** 20) * step
            cells = draw.randrange(-2 ** 25, 2 ** 25)
            total += cells * vector
            exact += cells * Fraction(vector)
        if Fraction(total) != exact:
            raise SystemExit(f"a sum was rounded: {total}")


def main():
    draw = random.Random(SEED)
    print(f"seed {SEED}")
    largest, corrected = decide_pairs(draw)
    print(f"largest square in a run 2^{math.log2(largest):.3f}, estimates corrected {corrected}")
    short = columns_short(draw)
    print(f"a run with one column less loses {short} of {PAIRS} pairs")
    add_moves(draw)
    if largest >= BOUND_OF_SQUARES or corrected == 0 or short == 0:
        return 1
    return 0


sys.exit(main())

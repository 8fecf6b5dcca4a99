"""How scenes/ was made: python3 make_scenes.py FOLDER. The tests read the stored files only."""

import math
import random
import struct
import sys
from pathlib import Path


def nudged(value, steps):
    """The double that many representable numbers away."""
    for _ in range(abs(steps)):
        value = math.nextafter(value, math.copysign(math.inf, steps))
    return value


def single(value):
    return struct.unpack("f", struct.pack("f", value))[0]


def planted(rng, dimensions, count):
    """Every other element lies at the reach of the one before, up to a few last bits."""
    elements = []
    while len(elements) < count:
        a = [rng.uniform(-3, 3) for _ in range(dimensions)]
        r, s = (rng.uniform(0.1, 0.4) for _ in range(2))
        direction = [rng.gauss(0, 1) for _ in range(dimensions)]
        length = math.hypot(*direction)
        b = [x + (r + s) * d / length for x, d in zip(a, direction)]
        axis = rng.randrange(dimensions)
        b[axis] = nudged(b[axis], rng.randint(-2, 2))
        elements += [a + [r], b + [s]]
    return elements


def planted_single(rng, count):
    """The same in float32, at 2 : 3 : 6, whose length is 7; half of them a last bit off."""
    elements = []
    while len(elements) < count:
        a = [rng.randint(-3000, 3000) / 1024 for _ in range(3)]
        legs = [2, 3, 6]
        rng.shuffle(legs)
        unit = rng.randint(20, 100) / 1024
        r = rng.randint(1, 6) * unit
        b = [single(x + leg * unit * (1 + 2.0**-22 * rng.choice([-1, 0, 0, 1])))
             for x, leg in zip(a, legs)]
        elements += [a + [r], b + [7 * unit - r]]
    return elements


def touching_lattice():
    """Neighbours 0.1 apart where neither 0.1 k nor 0.05 is a double; some touch, some do not."""
    return [[0.1 * i - 0.7, 0.1 * j + 1000.1, 0.05] for i in range(16) for j in range(16)]


def mixed_radii(rng):
    elements = [[rng.gauss(0, 2) for _ in range(3)] + [0.02 * 40 ** rng.random()]
                for _ in range(240)]
    # a right triangle of 3 : 4 : 5 whose long side is the reach, margin 1/8 included
    for k in range(20):
        x = rng.randint(-64, 64) / 16
        elements += [[x, 8.0 + k, -x, 1.0], [x + 1.5, 10.0 + k, -x, 1.375]]
    return elements


def swarm(rng):
    """Enough for several tiles of `rows`, on sixteenths, and a crowd of many sizes across the face
    between two of them."""
    box = (120, 30, 30)
    elements = [[0.0, 0.0, 0.0, 0.5], [float(length) for length in box] + [0.5]]
    elements += [[rng.randint(0, 16 * length) / 16 for length in box] + [rng.randint(7, 8) / 16]
                 for _ in range(900)]
    # touching at 2 : 3 : 6
    elements += [[x + 2 / 8, y + 3 / 8, z + 6 / 8, 7 / 8 - r] for x, y, z, r in elements[2:60]]
    for _ in range(260):
        place = [rng.gauss(0, 8) for _ in box]
        elements.append([(round(16 * length / 2 + x) / 16) for length, x in zip(box, place)]
                        + [2.0 ** rng.randint(-6, -1)])
    return elements


def scaled(elements, factor):
    return [[x * factor for x in element] for element in elements]


def integers(rng, count, span, radius):
    return [[float(rng.randint(lowest, highest))
             for lowest, highest in ((0, span), (0, span), (1, radius))] for _ in range(count)]


def write(folder, name, dimensions, precision, margin, elements):
    lines = [f"{dimensions} {precision} {margin.hex()} {len(elements)}"]
    lines += [" ".join(number.hex() for number in element) for element in elements]
    (folder / f"{name}.txt").write_text("\n".join(lines) + "\n")


def main():
    folder = Path(sys.argv[1])
    rng = random.Random(20040317)
    write(folder, "planted_2d", 2, "float64", 0.0, planted(rng, 2, 240))
    write(folder, "planted_3d", 3, "float64", 0.0, planted(rng, 3, 300))
    write(folder, "planted_3d_float32", 3, "float32", 0.0, planted_single(rng, 300))
    write(folder, "touching_lattice_2d", 2, "float64", 0.0, touching_lattice())
    write(folder, "mixed_radii_3d", 3, "float64", 0.125, mixed_radii(rng))
    # squares that vanish, and squares that overflow
    write(folder, "subnormal_2d", 2, "float64", 0.0, scaled(integers(rng, 120, 120, 6), 2.0**-1074))
    write(folder, "huge_3d", 3, "float64", 0.0, scaled(planted(rng, 3, 120), 2.0**1019))
    write(folder, "swarm_3d", 3, "float64", 0.0, swarm(random.Random(20261121)))


if __name__ == "__main__":
    main()

"""What tests share: an oracle in fractions, and a real packing."""

import os
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from hypothesis import settings

# The same examples in each run, and no files left behind.
settings.register_profile("fixed", derandomize=True, database=None, deadline=None)
settings.load_profile("fixed")

SOURCES = Path(os.environ.get("ABUT_SOURCES", Path(__file__).parents[2]))


def touching(x, r, margin=0.0):
    """All contact pairs in open space, decided in fractions."""
    x = [[Fraction(float(value)) for value in point] for point in np.asarray(x)]
    radius = [Fraction(float(value)) for value in np.broadcast_to(r, len(x))]
    return [
        (i, j)
        for i in range(len(x))
        for j in range(i + 1, len(x))
        if sum((a - b) ** 2 for a, b in zip(x[i], x[j], strict=True))
        <= (radius[i] + radius[j] + Fraction(margin)) ** 2
    ]


def tuples(pairs):
    """Rows of a table as a list of tuples of int."""
    return [tuple(row) for row in np.asarray(pairs).tolist()]


@pytest.fixture(scope="session")
def packing_file():
    """5,000 spheres that YADE settled."""
    return SOURCES / "examples" / "data" / "yade_settled_5000.csv"


@pytest.fixture(scope="session")
def packing(packing_file):
    """The packing as a structured array with fields x, y, z, radius."""
    return np.genfromtxt(packing_file, delimiter=",", names=True)


@pytest.fixture
def cloud():
    """Positions and radii of 300 spheres, many of which touch."""
    random = np.random.default_rng(1)
    return random.random((300, 3)), 0.03 + 0.05 * random.random(300)

"""Gaps, normals, points, distances and vectors: right, and the same bytes in every way."""

import pickle
from fractions import Fraction
from math import isqrt

import numpy as np
import pytest

import abut

NAMES = ("gap", "normal", "point", "distance", "vector")


def exact_vectors(c):
    """x_j + n A - x_i of each pair, in fractions."""
    columns = abut._elements.positions_of(c.elements)
    x = [[Fraction(float(one)) for one in point] for point in zip(*columns, strict=True)]
    cell = [[Fraction(one) for one in row] for row in c.domain.vectors.tolist()]
    dimensions = len(columns)
    return [
        [
            x[j][k] - x[i][k] + sum(int(n[m]) * cell[m][k] for m in range(3))
            for k in range(dimensions)
        ]
        for (i, j), n in zip(c.pairs.tolist(), c.shift.tolist(), strict=True)
    ]


def nearest_root(square):
    """The double nearest to the root of a fraction, by integers."""
    root = isqrt((square.numerator << 400) // square.denominator)
    return float(Fraction(root, 1 << 200))


def scenes():
    random = np.random.default_rng(4)
    x = random.random((150, 3))
    r = 0.03 + 0.06 * random.random(150)
    skewed = abut.Domain.lattice([[1, 0, 0], [0.25, 1, 0], [0, -0.3, 1]])
    yield "open", abut.contacts(x, r)
    yield "plane", abut.contacts(x[:, :2], r)
    yield "skewed", abut.contacts(x, r, domain=skewed)
    yield "sheared", abut.contacts(x[:, :2], r, domain=abut.Domain.lees_edwards((1, 1), 0.375))
    yield "float32", abut.contacts(x.astype(np.float32), r.astype(np.float32))
    yield "two sets", abut.find_contact_pairs(abut.spheres(x[:70], r[:70]), abut.points(x[70:]))


SCENES = dict(scenes())


@pytest.mark.parametrize("name", [name for name in SCENES if name != "two sets"])
def test_quantities_are_those_in_fractions(name):
    c = SCENES[name]
    vectors = exact_vectors(c)
    assert len(vectors) > 20
    assert c.vector.tolist() == [[float(one) for one in vector] for vector in vectors]
    distances = [nearest_root(sum(one * one for one in vector)) for vector in vectors]
    assert c.distance.tolist() == distances
    radii = abut._elements.radii_of(c.elements).astype(float)
    gaps = c.distance - (radii[c.i] + radii[c.j])
    assert np.allclose(c.gap, gaps, rtol=0, atol=1e-15)
    assert np.allclose(c.normal * c.distance[:, None], c.vector, rtol=0, atol=1e-15)
    x = np.stack(abut._elements.positions_of(c.elements), axis=1).astype(float)
    middle = x[c.i] + c.normal * (radii[c.i] + c.gap / 2)[:, None]
    assert np.allclose(c.point, middle, rtol=0, atol=1e-14)


@pytest.mark.parametrize("name", SCENES)
def test_all_ways_give_the_same_bytes(name):
    c = SCENES[name]
    expected = {quantity: getattr(c, quantity).tobytes() for quantity in NAMES}
    domain = c.domain
    shifts = c.shift if domain.is_periodic else None
    stored = abut.find_contact_pairs(c.elements, c.others, domain=domain, quantities=NAMES)
    together = abut.find_contact_pairs(c.elements, c.others, domain=domain, threads=2)
    rows = abut.build_neighbor_list(c.elements, c.others, domain=domain, quantities=NAMES)
    given = {"shifts": shifts, "domain": domain, "threads": 1}
    one = abut.measure(c.elements, c.pairs, NAMES, c.others, **given)
    measurer = abut.PairMeasurer(c.elements, c.others, domain=domain)
    again = measurer.measure(c.pairs, NAMES, shifts)
    for quantity, array in zip(NAMES, together.measure(*NAMES), strict=True):
        plural = quantity + "s"
        ways = (getattr(stored, quantity), array, *(getattr(g, plural) for g in (rows, one, again)))
        for way in ways:
            assert way.shape == getattr(c, quantity).shape
            assert way.tobytes() == expected[quantity]


def test_stored_quantities_are_views_and_measured_ones_are_kept():
    x = np.array([[0.0, 0.0], [1.0, 0.0]])
    c = abut.contacts(x, 0.5, quantities="normal")
    assert np.shares_memory(c.normal, c._results.normals)
    assert c.normal is c.normal
    assert c.gap is c.gap
    later = abut.contacts(x, 0.5, quantities=["vector"])
    x[1] = 5.0
    assert later.vector.tolist() == [[1.0, 0.0]]
    assert later.distance.tolist() == [50**0.5]
    for array in (c.gap, c.normal, later.vector, later.distance):
        with pytest.raises(ValueError, match="read-only"):
            array[:] = 0


def test_quantities_of_a_detector_outlive_its_next_call():
    detector = abut.Detector(quantities=("gap", "normal"))
    normal = detector.contacts([[0, 0], [1, 0]], 0.5).normal
    detector.contacts([[0, 0], [0, 1]], 0.5)
    assert normal.tolist() == [[1.0, 0.0]]


def test_pickled_contacts_keep_what_was_measured():
    x = np.array([[0.0, 0.0], [1.0, 0.0]])
    c = abut.contacts(x, 0.5, quantities="point")
    gap = c.gap
    x[1] = 9.0
    again = pickle.loads(pickle.dumps(c))
    assert again.gap.tolist() == gap.tolist()
    assert again.point.tolist() == [[0.5, 0.0]]
    assert again.distance.tolist() == [162**0.5]


def test_fabric():
    axis = np.arange(5.0)
    x = np.stack(np.meshgrid(axis, axis, axis), axis=-1).reshape(-1, 3)
    assert np.allclose(abut.contacts(x, 0.5).fabric(), np.eye(3) / 3)
    chain = abut.contacts(axis[:, None] * [0.6, 0.8], 0.5)
    assert np.allclose(chain.fabric(), [[0.36, 0.48], [0.48, 0.64]])
    same = abut.contacts([[0, 0], [0, 0], [1, 0]], [0.5, 0.0, 0.5])
    assert same.normal.tolist() == [[0.0, 0.0], [1.0, 0.0]]
    assert same.fabric().tolist() == [[1.0, 0.0], [0.0, 0.0]]
    assert np.isnan(abut.contacts([[0, 0], [9, 0]], 0.5).fabric()).all()


def test_nothing_to_measure():
    c = abut.contacts([[0, 0, 0], [9, 0, 0]], 0.5, quantities=NAMES)
    assert c.normal.shape == (0, 3)
    assert c.gap.shape == (0,)
    assert abut.measure(c.elements, [], "vector").vectors.shape == (0, 3)
    assert abut.measure(c.elements, [[0, 1]], ()) == abut.PairGeometry()


def test_wrong_requests():
    discs = abut.discs([[0, 0], [1, 0]], 0.5)
    cell = abut.Domain.periodic((4, None))
    with pytest.raises(abut.UsageError, match="'gaps' is not there; there are gap, normal, point"):
        abut.measure(discs, [[0, 1]], "gaps")
    with pytest.raises(abut.InputTypeError, match="quantities are names"):
        abut.contacts([[0, 0]], 1, quantities=(1, 2))
    with pytest.raises(abut.InputError, match=r"pairs have the shape \(M, 2\), not \(1, 3\)"):
        abut.measure(discs, [[0, 1, 2]], "gap")
    with pytest.raises(abut.InputError, match="2 image shifts for 1 pairs"):
        abut.measure(discs, [[0, 1]], "gap", shifts=np.zeros((2, 3), int), domain=cell)
    for pairs, options in (
        ([[0, 2]], {}),
        ([[0, 1]], {"domain": cell}),
        ([[0, 1]], {"domain": cell, "shifts": [[0, 1, 0]]}),
    ):
        with pytest.raises(abut.UsageError):
            abut.measure(discs, pairs, "gap", **options)
    with pytest.raises(abut.UsageError, match="quantities='normal'"):
        abut.build_neighbor_list(discs).normals  # noqa: B018

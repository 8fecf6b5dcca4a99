"""Contacts are those of the contract, whatever way they are asked for."""

import pickle

import numpy as np
import pytest
from conftest import SOURCES, touching, tuples
from hypothesis import given, settings
from hypothesis import strategies as st

import abut


def test_real_packing_has_the_contacts_that_yade_lists(packing):
    listed = np.loadtxt(
        SOURCES / "examples/data/yade_settled_5000.yade_contacts.csv", delimiter=",", skiprows=1
    )
    c = abut.contacts(packing)
    assert sorted(tuples(c.pairs)) == sorted((int(i), int(j)) for i, j in listed)
    assert len(c) == 10658
    assert (c.gap <= 0).all()


@pytest.mark.parametrize("dimensions", [2, 3])
@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_pairs_are_those_in_fractions(dimensions, dtype):
    random = np.random.default_rng(dimensions)
    x = random.random((120, dimensions)).astype(dtype)
    r = (0.05 * random.random(120)).astype(dtype)
    assert tuples(abut.contacts(x, r).pairs) == touching(x, r)
    assert tuples(abut.contacts(x, r, margin=0.03).pairs) == touching(x, r, 0.03)


# Coarse numbers, so that elements touch exactly, coincide and stand just apart.
COARSE = st.integers(-6, 6).map(lambda k: k / 4)


@settings(max_examples=200)
@given(st.lists(st.tuples(COARSE, COARSE, COARSE, st.integers(0, 6)), max_size=25))
def test_any_small_system_has_the_pairs_in_fractions(elements):
    table = np.array(elements, dtype=np.float64).reshape(-1, 4)
    x, r = table[:, :3], table[:, 3] / 8
    c = abut.contacts(x, r)
    assert tuples(c.pairs) == touching(x, r)
    assert (c.gap <= 0).all()
    for algorithm in abut.algorithms():
        same = abut.contacts(x, r, algorithm=algorithm.name)
        assert tuples(same.pairs) == tuples(c.pairs), algorithm.name


def test_cutoff_is_included_on_a_lattice_of_tenths():
    # 3 * 9 * 100 pairs at one spacing in real numbers; as doubles, 0.1 k are not equally spaced,
    # and those 2,100 pairs are within that are within in fractions.
    axis = 0.1 * np.arange(10)
    x = np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), axis=-1).reshape(-1, 3)
    n = abut.neighbors(x, 0.1)
    assert len(n.neighbors) == 2100
    rows = {(int(e), int(k)) for e, k in zip(n.elements, n.neighbors, strict=True)}
    along_x = [(i, i + 100) for i in range(900)]
    within = [(i, j) for i, j in along_x if touching(x[[i, j]], 0.05) == [(0, 1)]]
    assert {pair for pair in rows if pair[1] - pair[0] == 100} == set(within)


def test_answer_does_not_depend_on_options_of_cost(cloud):
    x, r = cloud
    c = abut.contacts(x, r)
    for options in ({"threads": 2}, {"simd": "scalar"}, {"algorithm": "munjiza_nbs"}):
        assert tuples(abut.contacts(x, r, **options).pairs) == tuples(c.pairs), options
    found = abut.contacts(x, r, order="as_found")
    assert sorted(tuples(found.pairs)) == tuples(c.pairs)
    assert abut.contacts(x, r, algorithm="direct_check").statistics.algorithm == "direct_check"


def test_periodic_pairs_carry_shifts():
    c = abut.contacts([[0.5, 5, 5], [9.5, 5, 5]], 0.5, domain=abut.Domain.periodic((10, 10, 10)))
    assert tuples(c.pairs) == [(0, 1)]
    assert tuples(c.shift) == [(-1, 0, 0)]
    assert c.gap.tolist() == [0.0]
    without = abut.contacts(
        [[0.5, 5, 5], [9.5, 5, 5]], 0.5, domain=abut.Domain.periodic((10, 10, 10)), shifts=False
    )
    with pytest.raises(abut.UsageError, match="shifts=True"):
        without.gap  # noqa: B018
    assert tuples(abut.contacts([[0, 0], [1, 0]], 0.5).shift) == [(0, 0, 0)]


def test_two_sets_pair_with_each_other_only():
    first = abut.spheres([[0, 0, 0], [0.1, 0, 0]], 0.5)
    second = abut.spheres(np.array([[1, 0, 0]], dtype=np.float32), np.float32(0.5))
    c = abut.find_contact_pairs(first, second)
    assert tuples(c.pairs) == [(0, 0), (1, 0)]
    assert c.gap.tolist() == [0.0, 1 - 0.1 - 1]
    assert c.others is second
    assert abut.count_contact_pairs(first, second).contact_pairs == 2
    assert c.to_scipy().shape == (2, 1)
    with pytest.raises(abut.UsageError, match="one set"):
        c.coordination()


def test_boxes():
    c = abut.find_contact_pairs(abut.boxes(([0, 1], [0, 1], [0, 1]), ([1, 2], [1, 2], [1, 2])))
    assert tuples(c.pairs) == [(0, 1)]
    flat = abut.rectangles(np.float32([[0, 0], [3, 0]]), [[1, 1], [4, 1]])
    assert flat.precision == "float64"
    assert len(abut.find_contact_pairs(flat)) == 0
    assert tuples(abut.find_contact_pairs(flat, margin=2).gap[:, None]) == [(2.0,)]


def test_elements_give_their_positions_and_radii(packing):
    elements = abut.spheres(packing)
    assert elements.positions.tolist() == [[*row] for row in packing[["x", "y", "z"]].tolist()]
    assert elements.radii.tolist() == packing["radius"].tolist()
    x = np.zeros((3, 2))
    discs = abut.discs(x, 0.5)
    assert np.shares_memory(discs.positions, x)
    assert discs.radii.tolist() == [0.5, 0.5, 0.5]
    with pytest.raises(ValueError, match="read-only"):
        discs.positions[:] = 1
    assert x.flags.writeable
    flat = abut.rectangles(([0, 2], [0, 2]), [[1, 2], [3, 4]])
    assert flat.positions.tolist() == [[0.5, 1.0], [2.5, 3.0]]
    assert flat.radii.tolist() == [0.0, 0.0]
    assert flat.lower.tolist() == [[0, 0], [2, 2]]
    assert flat.upper.tolist() == [[1, 2], [3, 4]]
    with pytest.raises(abut.UsageError, match="discs have positions and radii"):
        discs.lower  # noqa: B018


def test_rules():
    x = [[0, 0], [1, 0], [2, 0]]
    assert tuples(abut.contacts(x, 0.5, groups=[0, 0, 1]).pairs) == [(1, 2)]
    assert tuples(abut.contacts(x, 0.5, exclude=[[2, 1]]).pairs) == [(0, 1)]
    masks = abut.PairRule(categories=[1, 2, 1], accepts=[2, 1, 1])
    assert tuples(abut.contacts(x, 0.5, rule=masks).pairs) == [(0, 1)]
    two = abut.find_contact_pairs(
        abut.discs(x, 0.5), abut.discs(x, 0.5), groups=([0, 0, 0], [0, 0, 1])
    )
    assert tuples(two.pairs) == [(1, 2), (2, 2)]
    with pytest.raises(ValueError, match="groups has 2 numbers for 3"):
        abut.contacts(x, 0.5, groups=[0, 1])


def test_rows_coordination_clusters():
    c = abut.contacts([[0, 0], [1, 0], [2, 0], [9, 9]], 0.5)
    assert c.indptr.tolist() == [0, 1, 2, 2, 2]
    assert c.indices.tolist() == [1, 2]
    assert c.coordination().tolist() == [1, 2, 1, 0]
    assert c.clusters().tolist() == [0, 0, 0, 1]
    found = abut.contacts([[0, 0], [1, 0], [2, 0], [9, 9]], 0.5, order="as_found")
    assert found.indices.tolist() == [1, 2]


def test_rattlers_are_taken_away_until_none_is_left():
    # A tetrahedron of touching spheres with a chain of two hanging on it: the chain goes.
    x = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]]) / np.sqrt(8)
    x = np.vstack([x, x[0] * (1 + 1 / np.linalg.norm(x[0])), x[0] * (1 + 2 / np.linalg.norm(x[0]))])
    c = abut.contacts(x, 0.5, margin=1e-9)
    assert c.coordination().tolist() == [4, 3, 3, 3, 2, 1]
    assert c.rattlers(3).tolist() == [False] * 4 + [True] * 2
    assert c.rattlers().all()


def test_other_packages_get_their_forms(cloud):
    c = abut.contacts(*cloud)
    matrix = c.to_scipy(c.gap)
    assert matrix.shape == (300, 300)
    assert (matrix != matrix.T).nnz == 0
    assert matrix[int(c.i[0]), int(c.j[0])] == c.gap[0]
    frame = c.to_pandas()
    assert list(frame.columns) == ["i", "j", "gap"]
    assert len(frame) == len(c)


def test_pickled_contacts_are_the_same(cloud):
    x, r = cloud
    cell = abut.Domain.lees_edwards((1, 1, 1), 0.25)
    for c in (abut.contacts(x, r), abut.contacts((*x.T,), 0.05, domain=cell)):
        again = pickle.loads(pickle.dumps(c))
        assert tuples(again.pairs) == tuples(c.pairs)
        assert tuples(again.shift) == tuples(c.shift)
        assert again.gap.tolist() == c.gap.tolist()
        assert again.statistics == c.statistics
        assert again.domain == c.domain
        assert repr(again) == repr(c)


def test_pickled_contacts_know_that_no_pair_has_a_shift():
    c = abut.contacts([[0, 0]], 0.25, domain=abut.Domain.periodic((1, 1)))
    assert pickle.loads(pickle.dumps(c)).shift.shape == (0, 3)


def test_nothing_gives_nothing():
    for x in ([], np.zeros((0, 2)), (np.zeros(0),) * 3):
        c = abut.contacts(x, 0.5)
        assert len(c) == 0
        assert c.pairs.shape == (0, 2)
        assert c.gap.shape == c.coordination().shape == c.clusters().shape == (0,)
        assert c.indptr.tolist() == [0]
    assert abut.neighbors([], 1.0).offsets.tolist() == [0]

"""Functions of other packages give what these packages give, signs, shapes and types included."""

from collections import defaultdict

import numpy as np
import pytest
from ase import Atoms
from ase.neighborlist import neighbor_list, primitive_neighbor_list
from matscipy.neighbours import neighbour_list
from scipy.spatial import KDTree
from vesin import NeighborList

import abut
from abut.compat import ase, matscipy, scipy, vesin

LETTERS = "ijdDS"


def crystal(pbc, seed=1):
    """Atoms of three kinds in a skewed cell, some far outside of it."""
    random = np.random.default_rng(seed)
    cell = np.array([[6.0, 0.0, 0.0], [1.5, 5.0, 0.0], [-0.5, 0.75, 7.0]])
    places = random.uniform(-0.5, 1.5, (60, 3)) @ cell
    return Atoms(random.choice(["H", "C", "O"], 60), positions=places, cell=cell, pbc=pbc)


def same(ours, theirs):
    """Whether the neighbors are the same up to their order within an atom."""
    assert len(ours) == len(theirs) == 5
    for mine, other in zip(ours, theirs, strict=True):
        assert mine.dtype == other.dtype
        assert mine.shape == other.shape
    tables = []
    for i, j, d, D, S in (ours, theirs):
        order = np.lexsort((*S.T, j, i))
        tables.append([array[order] for array in (i, j, S, d, D)])
    for mine, other in zip(*tables, strict=True):
        assert np.allclose(mine, other, rtol=1e-13, atol=1e-13)
    assert (np.diff(ours[0].astype(np.int64)) >= 0).all()


PERIODIC = [True, False, [True, False, True]]
CUTOFFS = {
    "number": 2.5,
    "longer than the cell": 8.0,
    "radii": np.random.default_rng(2).uniform(0, 1.5, 60),
    "kinds": {("H", "H"): 1.1, ("C", "H"): 2.3, (6, 6): 3.1, ("O", "C"): 2.3},
}


@pytest.mark.parametrize("cutoff", CUTOFFS)
@pytest.mark.parametrize("pbc", PERIODIC, ids=str)
@pytest.mark.parametrize("itself", [False, True])
def test_ase(cutoff, pbc, itself):
    atoms, cutoff = crystal(pbc), CUTOFFS[cutoff]
    same(
        ase.neighbor_list(LETTERS, atoms, cutoff, self_interaction=itself),
        neighbor_list(LETTERS, atoms, cutoff, self_interaction=itself),
    )


@pytest.mark.parametrize("cutoff", CUTOFFS)
@pytest.mark.parametrize("itself", [False, True])
def test_letters_that_are_left_out_change_nothing(cutoff, itself):
    atoms, cutoff = crystal(True), CUTOFFS[cutoff]
    asked = [
        (lambda letters: ase.neighbor_list(letters, atoms, cutoff, itself)),
        (lambda letters: matscipy.neighbour_list(letters, atoms, cutoff)),
    ]
    if not np.ndim(cutoff) and not isinstance(cutoff, dict) and not itself:
        calculator = vesin.NeighborList(cutoff=cutoff, full_list=True)
        asked.append(
            lambda letters: calculator.compute(atoms.positions, atoms.cell.array, True, letters)
        )
    for answer in asked:
        everything = dict(zip(LETTERS, answer(LETTERS), strict=True))
        for letters in ("ij", "Dj", "Si", "dD"):
            for letter, array in zip(letters, answer(letters), strict=True):
                assert array.dtype == everything[letter].dtype
                assert np.array_equal(array, everything[letter]), letters


def test_primitive_ase():
    atoms = crystal(True)
    arguments = (atoms.pbc, atoms.cell.array, atoms.get_scaled_positions(), 3.0)
    ours = ase.primitive_neighbor_list(LETTERS, *arguments, use_scaled_positions=True)
    same(ours, primitive_neighbor_list(LETTERS, *arguments, use_scaled_positions=True))
    assert isinstance(ase.neighbor_list("i", atoms, 2.0), np.ndarray)
    assert isinstance(ase.neighbor_list("ij", atoms, 2.0), tuple)
    nothing = [Atoms(), 2.0]
    same(ase.neighbor_list(LETTERS, *nothing), neighbor_list(LETTERS, *nothing))
    with pytest.raises(ValueError, match="'q'"):
        ase.neighbor_list("q", atoms, 2.0)


@pytest.mark.parametrize("cutoff", CUTOFFS)
@pytest.mark.parametrize("pbc", PERIODIC, ids=str)
def test_matscipy(cutoff, pbc):
    atoms, cutoff = crystal(pbc), CUTOFFS[cutoff]
    same(
        matscipy.neighbour_list(LETTERS, atoms, cutoff), neighbour_list(LETTERS, atoms, cutoff)
    )


def test_matscipy_without_atoms():
    atoms = crystal([True, True, False])
    given = {
        "positions": atoms.positions,
        "cell": atoms.cell.array,
        "pbc": atoms.pbc,
        "numbers": atoms.numbers.astype(np.int32),
        "cell_origin": np.array([1.0, 2.0, 3.0]),
    }
    for cutoff in (2.5, defaultdict(lambda: 2.0)):
        same(
            matscipy.neighbour_list(LETTERS, cutoff=cutoff, **given),
            neighbour_list(LETTERS, cutoff=cutoff, **given),
        )
    positions = {"positions": atoms.positions, "cutoff": 2.5}
    same(matscipy.neighbour_list(LETTERS, **positions), neighbour_list(LETTERS, **positions))
    for wrong in ({}, {"cutoff": 1.0}, {"atoms": atoms, "cutoff": 1.0, "pbc": True}):
        with pytest.raises(ValueError):
            matscipy.neighbour_list("i", **wrong)


@pytest.mark.parametrize("pbc", PERIODIC, ids=str)
@pytest.mark.parametrize("dtype", [np.float64, np.float32])
def test_vesin_full(pbc, dtype):
    atoms = crystal(pbc)
    points, box = atoms.positions.astype(dtype), atoms.cell.array.astype(dtype)
    how = {"cutoff": 2.5, "full_list": True, "sorted": True}
    ours = vesin.NeighborList(**how).compute(points, box, pbc, LETTERS)
    theirs = NeighborList(**how).compute(points, box, pbc, LETTERS)
    if dtype == np.float64:
        same(ours, theirs)
    assert [array.dtype for array in ours] == [array.dtype for array in theirs]
    assert [array.shape for array in ours] == [array.shape for array in theirs]


@pytest.mark.parametrize("pbc", PERIODIC, ids=str)
def test_vesin_half(pbc):
    atoms = crystal(pbc)
    arguments = (atoms.positions, atoms.cell.array, pbc)
    tables = []
    for package in (vesin.NeighborList, NeighborList):
        pairs, S, D = package(cutoff=2.5, full_list=False).compute(*arguments, "PSD")
        assert pairs.dtype == np.uint64
        assert np.allclose(
            D, atoms.positions[pairs[:, 1]] - atoms.positions[pairs[:, 0]] + S @ atoms.cell.array
        )
        both = zip(pairs.tolist(), S.tolist(), strict=True)
        tables.append(
            sorted(
                min((i, j, *shift), (j, i, *(-n for n in shift))) for (i, j), shift in both
            )
        )
    assert tables[0] == tables[1]


def test_vesin_again_and_with_a_skin():
    atoms = crystal(True)
    calculator = vesin.NeighborList(cutoff=2.5, full_list=True, skin=0.5)
    kept = []
    for step in range(4):
        points = atoms.positions + 0.01 * step
        points[0] += 0.05 * step
        ours = calculator.compute(points, atoms.cell.array, True, LETTERS, copy=False)
        theirs = NeighborList(cutoff=2.5, full_list=True).compute(
            points, atoms.cell.array, True, LETTERS
        )
        same(ours, theirs)
        kept.append((ours, theirs))
    for ours, theirs in kept:
        same(ours, theirs)
    one = calculator.compute(points, atoms.cell.array, True, "i")
    assert type(one) is type(NeighborList(cutoff=1, full_list=True).compute(
        points, atoms.cell.array, True, "i"))
    for wrong in ((points[:, :2], atoms.cell.array), (points, np.eye(2))):
        with pytest.raises(ValueError):
            calculator.compute(*wrong, True)
    with pytest.raises(ValueError, match="q"):
        calculator.compute(points, atoms.cell.array, True, "q")


@pytest.mark.parametrize("dimensions", [2, 3])
def test_scipy(dimensions):
    random = np.random.default_rng(dimensions)
    x, y = random.random((200, dimensions)), random.random((3, 5, dimensions))
    tree = KDTree(x)
    assert scipy.query_pairs(x, 0.15) == tree.query_pairs(0.15)
    ours = scipy.query_pairs(x, 0.15, output_type="ndarray")
    theirs = tree.query_pairs(0.15, output_type="ndarray")
    assert ours.dtype == theirs.dtype
    assert sorted(ours.tolist()) == sorted(theirs.tolist())
    for r in (0.2, random.uniform(0, 0.3, (3, 5))):
        ours = scipy.query_ball_point(x, y, r)
        theirs = tree.query_ball_point(y, r, return_sorted=True)
        assert ours.shape == theirs.shape == (3, 5)
        assert ours.tolist() == theirs.tolist()
        lengths = scipy.query_ball_point(x, y, r, return_length=True)
        assert np.array_equal(lengths, tree.query_ball_point(y, r, return_length=True))
    assert scipy.query_ball_point(x, x[3], 0.2) == sorted(tree.query_ball_point(x[3], 0.2))


def test_scipy_distances():
    random = np.random.default_rng(4)
    x, y = random.random((50, 3)), random.random((40, 3))
    for kind in ("dok_matrix", "coo_matrix", "dict", "ndarray"):
        ours = scipy.sparse_distance_matrix(x, y, 0.3, output_type=kind)
        theirs = KDTree(x).sparse_distance_matrix(KDTree(y), 0.3, output_type=kind)
        assert type(ours) is type(theirs)
        if kind == "ndarray":
            assert ours.dtype == theirs.dtype
            ours, theirs = np.sort(ours), np.sort(theirs)
            assert np.allclose(ours["v"], theirs["v"], rtol=1e-14)
            assert ours["j"].tolist() == theirs["j"].tolist()
        elif kind == "dict":
            assert ours.keys() == theirs.keys()
            assert all(abs(ours[key] - theirs[key]) < 1e-14 for key in ours)
        else:
            assert ours.shape == theirs.shape
            assert abs(ours - theirs).max() < 1e-14
    with pytest.raises(abut.UsageError):
        scipy.query_pairs(x, 1.0, output_type="list")


def test_cutoffs_are_included():
    x = [[0.0, 0.0, 0.0], [3.0, 4.0, 0.0]]
    pair = Atoms("H2", positions=x)
    assert ase.neighbor_list("i", pair, 5.0).tolist() == [0, 1]
    assert ase.neighbor_list("i", pair, {("H", "H"): 5.0}).tolist() == [0, 1]
    assert ase.neighbor_list("i", pair, [2.0, 3.0]).tolist() == [0, 1]
    assert scipy.query_pairs(x, 5.0) == {(0, 1)}

"""Segments, triangles and tetrahedra against each other, beside an oracle in fractions."""

import itertools
import pickle
import threading
from fractions import Fraction

import numpy as np
import pytest
from conftest import tuples

import abut


def solution(columns, rhs):
    """Weights of independent columns that give `rhs`; None if there are none."""
    rows = [[column[k] for column in columns] + [rhs[k]] for k in range(len(rhs))]
    for k in range(len(columns)):
        pivot = next((row for row in rows[k:] if row[k] != 0), None)
        if pivot is None:
            return None
        rows.remove(pivot)
        rows.insert(k, pivot)
        for row in rows:
            if row is not pivot and row[k] != 0:
                factor = row[k] / pivot[k]
                row[:] = [a - factor * b for a, b in zip(row, pivot, strict=True)]
    if any(row[-1] != 0 for row in rows[len(columns) :]):
        return None
    return [row[-1] / row[k] for k, row in enumerate(rows[: len(columns)])]


def exact(x):
    return x if isinstance(x, Fraction) else Fraction(float(x))


def meet(a, b):
    """True if two convex hulls have a common point: means of their vertices, with weights >= 0 that
    add up to 1 for each, are equal. If any weights do so, those of some independent columns do."""
    columns = [[exact(x) for x in p] + [Fraction(1), Fraction(0)] for p in a]
    columns += [[-exact(x) for x in p] + [Fraction(0), Fraction(1)] for p in b]
    rhs = [Fraction(0)] * len(a[0]) + [Fraction(1)] * 2
    for size in range(2, len(rhs) + 1):
        for chosen in itertools.combinations(columns, size):
            weights = solution(chosen, rhs)
            if weights is not None and min(weights) >= 0:
                return True
    return False


def boxes_meet(a, b):
    return all(
        min(x) <= max(y) and min(y) <= max(x)
        for x, y in zip(np.transpose(a), np.transpose(b), strict=True)
    )


def expected(first, second=None, excluded=False):
    """All pairs of one set (vertices, cells), or of two."""
    others = first if second is None else second
    return [
        (i, j)
        for i, a in enumerate(first[1])
        for j, b in enumerate(others[1])
        if (second is not None or i < j)
        and not (excluded and set(a) & set(b))
        and boxes_meet(first[0][a], others[0][b])
        and meet(first[0][a], others[0][b])
    ]


def system(dimensions, corners, seed, kind=float, cells=14):
    """Vertices on a small lattice, so that many cells are flat and many touch; in one cell of two
    a vertex of another one."""
    random = np.random.default_rng(seed)
    vertices = random.integers(0, 4, (corners * cells, dimensions)).astype(kind)
    numbers = np.arange(corners * cells).reshape(cells, corners)
    numbers[1::2, 0] = numbers[0:-1:2, -1]
    vertices *= kind(0.1)  # not a number of float32 or float64, so that ties are rounded ones
    return vertices, numbers


@pytest.mark.parametrize("dimensions", [2, 3])
@pytest.mark.parametrize("corners", [1, 2, 3, 4])
def test_one_set(dimensions, corners):
    if corners > dimensions + 1:
        return
    given = system(dimensions, corners, 10 * dimensions + corners)
    simplices = abut.Simplices(*given)
    found = abut.find_simplex_contacts(simplices)
    wanted = expected(given)
    assert len(wanted) > 5
    assert tuples(found.pairs) == wanted
    assert found.statistics.contact_pairs == len(found) == len(wanted)
    apart = abut.find_simplex_contacts(simplices, shared_vertices="excluded", threads=2)
    assert tuples(apart.pairs) == expected(given, excluded=True)
    every = list(itertools.product(range(len(simplices)), repeat=2))
    touches = abut.touching(simplices, simplices, every)
    ordered = {(i, j) for (i, j), yes in zip(every, touches, strict=True) if yes and i < j}
    assert ordered == set(wanted)
    assert touches.dtype == bool and touches.reshape(14, 14).diagonal().all()


def test_two_sets():
    bodies, fibers = system(3, 4, 1, np.float32), system(3, 2, 2)
    found = abut.find_simplex_contacts(abut.Simplices(*bodies), abut.Simplices(*fibers))
    assert tuples(found.pairs) == expected(bodies, fibers)
    assert found.others is not None and len(found.others) == 14
    assert repr(found) == f"<abut.SimplexContacts: {len(found)} contacts of 14 and 14 simplices>"


def test_two_sets_that_share_vertices():
    vertices, cells = system(2, 3, 3)
    edges = np.ascontiguousarray(cells[:, :2])
    positions = np.asfortranarray(vertices)
    first = abut.Simplices(positions, cells)
    second = abut.Simplices(positions, edges)
    found = abut.find_simplex_contacts(first, second, shared_vertices="excluded")
    assert tuples(found.pairs) == expected((vertices, cells), (vertices, edges), excluded=True)
    copied = abut.Simplices(vertices.copy(), edges)
    with pytest.raises(abut.UsageError, match="same vertices"):
        abut.find_simplex_contacts(first, copied, shared_vertices="excluded")


@pytest.mark.parametrize("scale", [2.0**-1000, 2.0**900])
def test_sizes_at_both_ends(scale):
    vertices, cells = system(3, 3, 4, cells=12)
    found = abut.find_simplex_contacts(abut.Simplices(vertices * scale, cells))
    assert tuples(found.pairs) == expected((vertices, cells))


def test_one_place_off_a_tie():
    """A vertex beside an edge: on it, and the next number on either side."""
    fixed = [[0.0, 0.0], [3.0, 1.0], [3.0, -9.0]]
    for y in (np.nextafter(0.5, 0), 0.5, np.nextafter(0.5, 1)):
        a, b = np.array(fixed), np.array([[1.5, y], [1.5, 7.0], [2.0, 8.0]])
        simplices = abut.Simplices(np.vstack([a, b]), [[0, 1, 2], [3, 4, 5]])
        assert len(abut.find_simplex_contacts(simplices)) == meet(a, b) == (y <= 0.5)


@pytest.mark.parametrize("kind", [np.int32, np.uint32, np.int64, np.uint64, np.int16, np.uint8])
def test_types_of_cells(kind):
    vertices, cells = system(2, 3, 5)
    numbers = cells.astype(kind)
    simplices = abut.Simplices(vertices, numbers)
    assert tuples(abut.find_simplex_contacts(simplices).pairs) == expected((vertices, cells))
    assert np.shares_memory(simplices.cells, numbers) == (numbers.itemsize >= 4)
    assert not simplices.cells.flags.writeable
    mesh = abut.TriangleMesh(np.pad(vertices, ((0, 0), (0, 1))), numbers)
    assert len(mesh) == 14
    assert abut.fit_boxes(vertices, numbers).shape == "rectangle"


def test_positions_are_read_where_they_are():
    records = np.zeros(4, dtype=[("p", np.float64, 3), ("mass", np.float64)])
    records["p"] = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.25, 0.25, 5]]
    simplices = abut.Simplices(records["p"], [[0, 1, 2], [3, 3, 3]])
    assert len(abut.find_simplex_contacts(simplices)) == 0
    records["p"][3, 2] = 0
    assert len(abut.find_simplex_contacts(simplices)) == 1
    columns = tuple(np.ascontiguousarray(records["p"][:, k]) for k in range(3))
    assert len(abut.find_simplex_contacts(abut.Simplices(columns, [[0, 1, 2], [3, 3, 3]]))) == 1


def test_nothing():
    none = abut.Simplices(np.zeros((0, 3)), np.zeros((0, 4), dtype=int))
    assert len(abut.find_simplex_contacts(none)) == 0
    some = abut.Simplices(*system(3, 2, 6))
    assert len(abut.find_simplex_contacts(some, none)) == 0
    assert abut.touching(some, some, []).shape == (0,)
    assert repr(none) == "<abut.Simplices: 0 cells of 4 of 0 vertices in 3 dimensions>"


def test_what_is_kept():
    simplices = abut.Simplices(*system(2, 2, 7))
    found = abut.find_simplex_contacts(simplices)
    pairs, i = found.pairs, found.i
    again = pickle.loads(pickle.dumps(found))
    del found
    assert tuples(again.pairs) == tuples(pairs)
    assert again.i.tolist() == i.tolist() == pairs[:, 0].tolist()
    assert again.statistics.contact_pairs == len(pairs) and len(again.simplices) == 14
    with pytest.raises(ValueError, match="read-only"):
        pairs[0, 0] = 9
    assert again.j.tolist() == pairs[:, 1].tolist()


def test_options_and_threads():
    random = np.random.default_rng(8)
    vertices = random.random((9000, 3)) + np.repeat(random.random((3000, 3)) * 12, 3, axis=0)
    simplices = abut.Simplices(vertices, np.arange(9000).reshape(-1, 3))
    one = abut.find_simplex_contacts(simplices, threads=1, algorithm="munjiza_nbs")
    assert len(one) > 200
    results = []
    workers = [
        threading.Thread(target=lambda: results.append(abut.find_simplex_contacts(simplices)))
        for _ in range(3)
    ]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    assert all(np.array_equal(found.pairs, one.pairs) for found in results) and len(results) == 3
    groups = np.arange(3000) % 2
    differ = abut.find_simplex_contacts(simplices, groups=groups, order="as_found")
    assert len(differ) == np.count_nonzero(groups[one.i] != groups[one.j])
    some = abut.find_simplex_contacts(simplices, exclude=one.pairs[:7])
    assert len(some) == len(one) - 7
    with pytest.raises(abut.LimitError):
        abut.find_simplex_contacts(simplices, max_pairs=len(one) - 1)
    with pytest.raises(abut.Cancelled):
        abut.find_simplex_contacts(simplices, progress=lambda *_: False)


def test_periodic_domains():
    """All images of a skewed cell, moved in fractions."""
    vertices, cells = system(2, 3, 9, cells=12)
    vectors = [[0.7, 0.1], [-0.2, 0.8]]
    exactly = [[Fraction(x) for x in vector] for vector in vectors]
    domain = abut.Domain.lattice(vectors)
    places = [[Fraction(float(x)) for x in point] for point in vertices]

    def moved(number, n):
        return [
            [x + n[0] * exactly[0][k] + n[1] * exactly[1][k] for k, x in enumerate(places[v])]
            for v in cells[number]
        ]

    wanted = [
        (i, j, *n, 0)
        for i in range(12)
        for j in range(i, 12)
        for n in itertools.product(range(-2, 3), repeat=2)
        if (i < j or n > (0, 0))
        and boxes_meet(moved(i, (0, 0)), moved(j, n))
        and meet(moved(i, (0, 0)), moved(j, n))
    ]
    simplices = abut.Simplices(vertices, cells)
    found = abut.find_simplex_contacts(simplices, domain=domain)
    assert tuples(np.hstack([found.pairs, found.shift])) == wanted
    assert abut.touching(simplices, simplices, found.pairs, found.shift, domain).all()
    far = np.zeros((12, 3), dtype=int) + [9, 9, 0]
    same = np.repeat(np.arange(12), 2).reshape(-1, 2)
    assert not abut.touching(simplices, simplices, same, far, domain).any()
    again = pickle.loads(pickle.dumps(found))
    assert again.shift.tolist() == found.shift.tolist() and again.domain.is_periodic
    without = abut.find_simplex_contacts(simplices, domain=domain, shifts=False)
    assert tuples(without.pairs) == tuples(found.pairs)
    with pytest.raises(abut.UsageError, match="shifts=True"):
        without.shift  # noqa: B018
    assert not abut.find_simplex_contacts(simplices).shift.any()
    with pytest.raises(abut.UsageError, match="image shift x"):
        abut.touching(simplices, simplices, [[0, 0]], [[1, 0, 0]])
    with pytest.raises(abut.InputError, match="one for each"):
        abut.touching(simplices, simplices, [[0, 0]], [[0, 0, 0]] * 2)
    with pytest.raises(abut.UsageError, match="periodic"):
        abut.find_simplex_contacts(simplices, domain=domain, algorithm="munjiza_nbs")


def test_wrong_simplices():
    square = [[0, 0], [1, 0], [0, 1], [1, 1]]
    with pytest.raises(abut.UsageError, match="1 to 3"):
        abut.Simplices(square, [[0, 1, 2, 3]])
    with pytest.raises(abut.InputError, match="a row of vertex numbers"):
        abut.Simplices(square, [0, 1, 2])
    with pytest.raises(abut.InputTypeError, match="whole numbers"):
        abut.Simplices(square, [[0.0, 1.0]])
    with pytest.raises(abut.UsageError, match="boxes"):
        abut.Simplices(abut.rectangles([[0, 0]], [[1, 1]]), [[0]])
    for wrong in (-1, 4):
        simplices = abut.Simplices(square, [[0, 1], [1, wrong]])
        with pytest.raises(abut.InputError, match="cell 1"):
            abut.find_simplex_contacts(simplices)
        with pytest.raises(abut.InputError, match="cell 1"):
            abut.touching(simplices, simplices, [[0, 0], [0, 1]])
    with pytest.raises(abut.InputError, match="finite"):
        abut.find_simplex_contacts(abut.Simplices([[0, np.nan], [0, 0]], [[1, 0]]))


@pytest.mark.parametrize("dtype", [np.int32, np.int64])
def test_cells_that_are_not_aligned(dtype):
    square = [[0, 0], [1, 0], [0, 1], [1, 1]]
    for wrong in (-1, 3):
        cells = np.array([[0, 1], [1, wrong]], dtype=dtype)
        crooked = np.frombuffer(b"." + cells.tobytes(), dtype=dtype, offset=1).reshape(2, 2)
        assert not crooked.flags.aligned
        simplices = abut.Simplices(square, crooked)
        if wrong < 0:
            with pytest.raises(abut.InputError, match="vertex -1"):
                abut.find_simplex_contacts(simplices)
        else:
            assert abut.find_simplex_contacts(simplices).pairs.tolist() == [[0, 1]]


def test_wrong_calls():
    flat = abut.Simplices([[0, 0], [1, 0]], [[0, 1]])
    solid = abut.Simplices([[0, 0, 0], [1, 0, 0]], [[0, 1]])
    with pytest.raises(abut.UsageError, match="dimensions"):
        abut.find_simplex_contacts(flat, solid)
    with pytest.raises(abut.UsageError, match="dimensions"):
        abut.touching(flat, solid, [[0, 0]])
    for options in ({"margin": 0.5}, {"quantities": "gap"}, {"shared_vertices": "apart"}):
        with pytest.raises(abut.UsageError):
            abut.find_simplex_contacts(flat, **options)
    for wrong in (abut.points([[0, 0]]), [[0, 0]], None):
        with pytest.raises(abut.InputTypeError, match=r"Simplices\(vertices, cells\)"):
            abut.find_simplex_contacts(wrong)
    with pytest.raises(abut.InputTypeError, match="name"):
        abut.find_simplex_contacts(flat, shared_vertices=True)
    with pytest.raises(abut.UsageError, match="simplex 1"):
        abut.touching(flat, flat, [[0, 1]])
    with pytest.raises(abut.InputError, match=r"\(M, 2\)"):
        abut.touching(flat, flat, [0, 1])
    with pytest.raises(abut.InputError):
        abut.touching(flat, flat, [[0, -1]])

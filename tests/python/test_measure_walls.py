"""Quantities of contacts with walls: right, read-only, and the same bytes in every way."""

import gc
import pickle
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import abut

NAMES = ("gap", "normal", "point", "distance", "vector")
CELL = abut.Domain.periodic((1.0, 1.0, None))


def tetrahedra(count, random):
    """A mesh of the faces of tetrahedra."""
    corners = 0.7 * random.random((count, 1, 3)) + 0.5 * random.random((count, 4, 3))
    faces = np.array([[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]])
    triangles = faces + 4 * np.arange(count)[:, None, None]
    return abut.TriangleMesh(corners.reshape(-1, 3), triangles.reshape(-1, 3))


def scenes():
    random = np.random.default_rng(6)
    x, r = random.random((150, 3)), 0.02 + 0.05 * random.random(150)
    mesh = tetrahedra(12, random)
    lower = random.random((20, 3))
    boxes = abut.boxes(lower, lower + 0.2)
    flat = abut.rectangles(lower[:, :2], lower[:, :2] + 0.2)
    spheres = abut.spheres(x, r)
    yield "mesh", abut.find_mesh_contacts, spheres, mesh, abut.Domain.open()
    yield "boxes", abut.find_box_contacts, spheres, boxes, abut.Domain.open()
    yield "rectangles", abut.find_box_contacts, abut.discs(x[:, :2], r), flat, abut.Domain.open()
    yield "periodic mesh", abut.find_mesh_contacts, spheres, mesh, CELL
    yield "periodic boxes", abut.find_box_contacts, spheres, boxes, CELL


SCENES = {name: scene for name, *scene in scenes()}


def positions(elements):
    return np.asarray(elements.positions)


@pytest.mark.parametrize("name", SCENES)
def test_quantities_fit_together(name):
    find, spheres, wall, domain = SCENES[name]
    c = find(spheres, wall, domain=domain)
    assert len(c) > 25
    assert (c.shift != 0).any() == domain.is_periodic
    assert c.spheres is spheres
    assert c.domain == domain
    assert (c.boxes if "mesh" not in name else c.mesh) is wall
    x, r = positions(spheres)[c.sphere], spheres.radii[c.sphere]
    dimensions = spheres.dimensions
    assert c.normal.shape == c.point.shape == c.vector.shape == (len(c), dimensions)
    assert np.allclose(c.gap, c.distance - r, rtol=0, atol=1e-15)
    assert np.allclose(c.vector, c.distance[:, None] * c.normal, rtol=0, atol=1e-15)
    assert np.allclose(c.point, x + c.vector, rtol=0, atol=1e-15)
    assert np.allclose(np.linalg.norm(c.normal, axis=1), 1, rtol=0, atol=1e-14)
    assert (c.gap <= 0).all()


def exact_distance_to_box(x, lower, upper, shift, domain):
    """Distance of a point to a box, moved by its shift; in fractions, but for the last root."""
    square = Fraction(0)
    depth = None
    for axis, value in enumerate(x):
        move = sum(
            int(n) * Fraction(float(v[axis])) for n, v in zip(shift, domain.vectors, strict=True)
        )
        below = Fraction(float(lower[axis])) + move - Fraction(float(value))
        above = Fraction(float(value)) - Fraction(float(upper[axis])) - move
        square += max(below, above, Fraction(0)) ** 2
        depth = max(below, above) if depth is None else max(below, above, depth)
    return float(square) ** 0.5 if square else float(depth)


@pytest.mark.parametrize("name", ["boxes", "rectangles", "periodic boxes"])
def test_distances_to_boxes_are_those_in_fractions(name):
    find, spheres, boxes, domain = SCENES[name]
    c = find(spheres, boxes, domain=domain)
    expected = [
        exact_distance_to_box(positions(spheres)[s], boxes.lower[b], boxes.upper[b], n, domain)
        for s, b, n in zip(c.sphere, c.box, c.shift.tolist(), strict=True)
    ]
    assert (np.array(expected) < 0).any()
    assert np.allclose(c.distance, expected, rtol=4e-16, atol=0)


@pytest.mark.parametrize("name", ["mesh", "periodic mesh"])
def test_points_lie_on_the_features_that_contacts_name(name):
    find, spheres, mesh, domain = SCENES[name]
    c = find(spheres, mesh, domain=domain)
    assert set(c.kind.tolist()) == {1, 2, 3}
    for k in range(len(c)):
        corners = {1: mesh.triangles, 2: mesh.edges, 3: np.arange(len(mesh.vertices))[:, None]}
        places = mesh.vertices[corners[c.kind[k]][c.number[k]]] + c.shift[k] @ domain.vectors
        # Weights that are not negative and make the point of its corners: it lies among them.
        system = np.vstack([places.T, np.ones(len(places))])
        weights = np.linalg.lstsq(system, np.append(c.point[k], 1), rcond=None)[0]
        assert np.allclose(system @ weights, np.append(c.point[k], 1), rtol=0, atol=1e-12)
        assert (weights > -1e-12).all()


@pytest.mark.parametrize("name", SCENES)
def test_all_ways_give_the_same_bytes(name):
    find, spheres, wall, domain = SCENES[name]
    stored = find(spheres, wall, domain=domain, quantities=NAMES)
    c = find(spheres, wall, domain=domain, threads=1)
    one_by_one = {quantity: getattr(c, quantity) for quantity in NAMES}
    records = {"shifts": c.shift if domain.is_periodic else None, "domain": domain}
    ways = [
        find(spheres, wall, domain=domain, threads=2).measure(*NAMES),
        [getattr(stored, quantity) for quantity in NAMES],
    ]
    for geometry in (
        abut.measure(spheres, c, NAMES, wall, domain=domain),
        abut.measure(spheres, c.records.copy(), NAMES, wall, threads=1, **records),
    ):
        ways.append([getattr(geometry, f"{quantity}s") for quantity in NAMES])
    for way in ways:
        for quantity, array in zip(NAMES, way, strict=True):
            assert array.tobytes() == one_by_one[quantity].tobytes()
            assert array.shape == one_by_one[quantity].shape
    assert np.shares_memory(stored.gap, stored._results.gaps)


def test_arrays_are_read_only_and_outlive_their_list():
    find, spheres, mesh, _ = SCENES["mesh"]
    c = find(spheres, mesh, quantities="normal")
    arrays = [c.records, c.sphere, c.kind, c.number, c.shift, c.normal, c.gap, c.point]
    for array in arrays:
        with pytest.raises(ValueError, match="read-only"):
            array[:1] = 0
    expected = [array.copy() for array in arrays]
    assert c.gap is c.gap
    del c
    gc.collect()
    for _ in range(3):  # would write over memory that had been released
        find(spheres, mesh, quantities="normal")
    for array, values in zip(arrays, expected, strict=True):
        assert array.tobytes() == values.tobytes()


@pytest.mark.parametrize("name", SCENES)
def test_pickled_contacts_keep_what_was_measured(name):
    find, spheres, wall, domain = SCENES[name]
    c = find(spheres, wall, domain=domain, quantities="point")
    gap = c.gap
    again = pickle.loads(pickle.dumps(pickle.loads(pickle.dumps(c))))
    assert type(again) is type(c)
    assert again._results is None
    assert again.records.tobytes() == c.records.tobytes()
    assert again.gap.tobytes() == gap.tobytes()
    assert again.point.tobytes() == c.point.tobytes()
    assert again.shift.tolist() == c.shift.tolist()
    assert again.vector.tobytes() == c.vector.tobytes()
    assert again.statistics == c.statistics


def test_shifts_that_were_not_stored_stay_unknown():
    find, spheres, wall, _ = SCENES["periodic mesh"]
    c = find(spheres, wall, domain=CELL, shifts=False)
    for contacts in (c, pickle.loads(pickle.dumps(c))):
        with pytest.raises(abut.UsageError, match="shifts=True"):
            contacts.gap  # noqa: B018


def test_nothing_to_measure():
    mesh = SCENES["mesh"][2]
    for spheres in (abut.spheres([[9.0, 9.0, 9.0]], 0.5), abut.spheres([], 1.0)):
        c = abut.find_mesh_contacts(spheres, mesh, quantities=NAMES)
        assert c.normal.shape == c.point.shape == (0, 3)
        assert c.gap.shape == c.distance.shape == (0,)
        assert pickle.loads(pickle.dumps(c)).gap.shape == (0,)
    flat = abut.find_box_contacts(abut.discs([[9, 9]], 1), abut.rectangles([[0, 0]], [[1, 1]]))
    assert flat.vector.shape == (0, 2)


def test_contacts_are_pairs_that_come_with_their_shifts():
    random = np.random.default_rng(2)
    discs = abut.discs(random.random((60, 2)), 0.05)
    domain = abut.Domain.periodic((1, 1))
    c = abut.find_contact_pairs(discs, domain=domain)
    assert (c.shift != 0).any()
    assert abut.measure(discs, c, "gap", domain=domain).gaps.tobytes() == c.gap.tobytes()


coordinate = st.integers(-8, 8).map(lambda k: k / 4)


@given(st.lists(st.tuples(coordinate, coordinate, coordinate), min_size=1, max_size=20))
def test_a_floor_measures_heights(centers):
    floor = abut.TriangleMesh(
        [[-9, -9, 0], [9, -9, 0], [-9, 9, 0], [9, 9, 0]], [[0, 1, 2], [1, 2, 3]]
    )
    c = abut.find_mesh_contacts(abut.spheres(centers, 0.5), floor)
    heights = [z for _, _, z in centers]
    assert c.sphere.tolist() == [k for k, z in enumerate(heights) if abs(z) <= 0.5]
    assert c.gap.tolist() == [abs(z) - 0.5 for z in heights if abs(z) <= 0.5]
    assert c.normal[:, 2].tolist() == [float(np.sign(-z)) for z in heights if abs(z) <= 0.5]
    assert c.point.tolist() == [[x, y, 0.0] for x, y, z in centers if abs(z) <= 0.5]


def test_wrong_requests():
    _, spheres, mesh, _ = SCENES["mesh"]
    boxes = SCENES["boxes"][2]
    on_mesh = abut.find_mesh_contacts(spheres, mesh)
    on_boxes = abut.find_box_contacts(spheres, boxes)
    for contacts, wall in (
        (on_mesh, boxes),
        (on_boxes, mesh),
        (on_boxes, None),
        (on_boxes.records, mesh),
        (on_mesh.records, boxes),
        (on_mesh.records[None], mesh),
        ([(0, 1, 0)], mesh),
        ([[0, 1]], mesh),
        (on_mesh, "wall"),
    ):
        with pytest.raises(abut.InputTypeError):
            abut.measure(spheres, contacts, "gap", wall)
    for name, number, wall, records in (
        ("sphere", 150, mesh, on_mesh.records),
        ("kind", 0, mesh, on_mesh.records),
        ("kind", 4, mesh, on_mesh.records),
        ("number", 2**32 - 1, mesh, on_mesh.records),
        ("box", 20, boxes, on_boxes.records),
        ("sphere", 150, boxes, on_boxes.records),
    ):
        wrong = records.copy()
        wrong[name][3] = number
        with pytest.raises(abut.UsageError, match="a contact names"):
            abut.measure(spheres, wrong, "gap", wall)
    with pytest.raises(abut.UsageError, match="'gaps' is not there"):
        on_mesh.measure("gaps")
    with pytest.raises(abut.UsageError, match="shift"):
        abut.measure(spheres, on_mesh, "gap", mesh, domain=CELL)


def test_records_of_other_integers_are_converted_exactly():
    _, spheres, mesh, _ = SCENES["mesh"]
    c = abut.find_mesh_contacts(spheres, mesh)
    fields = [("number", ">i8"), ("sphere", "u2"), ("kind", "i4"), ("more", "f4")]
    wide = np.zeros(len(c), fields)
    for name in ("sphere", "kind", "number"):
        wide[name] = c.records[name]
    assert abut.measure(spheres, wide, "gap", mesh).gaps.tobytes() == c.gap.tobytes()
    wide["number"][0] = -1
    with pytest.raises(abut.InputError, match="number of contacts: -1"):
        abut.measure(spheres, wide, "gap", mesh)
    floats = c.records.astype([("sphere", "f8"), ("kind", "u4"), ("number", "u4")])
    with pytest.raises(abut.InputTypeError, match="whole numbers"):
        abut.measure(spheres, floats, "gap", mesh)

"""Meshes that move, and detectors that meet walls again and again."""

import pickle
import threading
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

import abut

VERTICES = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [0.5, 0.5, 1]])
TRIANGLES = [[0, 1, 2], [1, 2, 3], [0, 1, 4]]
SEAM = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], float)

small = st.floats(-4, 4, width=32)


def rounded(value):
    return Fraction(float(value))


def moved(rotation, vertex, translation):
    """((R_0 v_0 + R_1 v_1) + R_2 v_2) + t, each operation rounded once."""
    result = []
    for row, t in zip(rotation, translation, strict=True):
        products = [rounded(Fraction(a) * Fraction(b)) for a, b in zip(row, vertex, strict=True)]
        total = rounded(rounded(products[0] + products[1]) + products[2])
        result.append(float(total + Fraction(t)))
    return result


@given(arrays(float, (3, 3), elements=small), arrays(float, 3, elements=small))
def test_vertices_are_moved_as_stated(rotation, translation):
    mesh = abut.TriangleMesh(VERTICES / 3, TRIANGLES)
    motion = abut.Motion(rotation, translation)
    mesh.move(motion)
    expected = [
        moved(rotation.tolist(), v, translation.tolist()) for v in (VERTICES / 3).tolist()
    ]
    assert mesh.vertices.tolist() == expected
    assert mesh.rest_vertices.tolist() == (VERTICES / 3).tolist()
    assert mesh.motion == motion
    mesh.move(abut.Motion())
    assert mesh.vertices.tolist() == (VERTICES / 3).tolist()


def test_motions():
    still = abut.Motion()
    assert still.rotation.tolist() == np.eye(3).tolist()
    assert still.translation.tolist() == [0, 0, 0]
    turn = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1]], dtype=np.float32)
    motion = abut.Motion(turn, [1, 2, 3])
    turn[0, 0] = 9
    assert motion.rotation.tolist() == [[0, -1, 0], [1, 0, 0], [0, 0, 1]]
    assert motion != still
    assert motion == pickle.loads(pickle.dumps(motion)) != 1
    assert eval(repr(motion), {"Motion": abut.Motion}) == motion
    for array in (motion.rotation, motion.translation):
        with pytest.raises(ValueError, match="read-only"):
            array[:1] = 0
    with pytest.raises(TypeError):
        hash(motion)
    with pytest.raises(abut.InputError, match=r"a rotation has the shape \(3, 3\), not \(2, 2\)"):
        abut.Motion(np.eye(2))
    with pytest.raises(abut.InputError, match="a translation has the shape"):
        abut.Motion(translation=1.0)
    with pytest.raises(abut.InputTypeError):
        abut.Motion(np.eye(3) * 1j)


def test_arrays_stay_as_they_are_when_the_mesh_moves():
    mesh = abut.TriangleMesh(VERTICES, TRIANGLES)
    before, rest = mesh.vertices, mesh.rest_vertices
    assert mesh.vertices is before
    mesh.move(abut.Motion(translation=[0, 0, 1]))
    assert mesh.vertices[:, 2].tolist() == [1, 1, 1, 1, 2]
    mesh.deform(2 * VERTICES)
    assert mesh.vertices.tolist() == mesh.rest_vertices.tolist() == (2 * VERTICES).tolist()
    assert mesh.motion == abut.Motion()
    assert before.tolist() == rest.tolist() == VERTICES.tolist()
    for array in (mesh.vertices, mesh.rest_vertices):
        with pytest.raises(ValueError, match="read-only"):
            array[:1] = 0


def test_what_cannot_be_moved():
    mesh = abut.TriangleMesh(VERTICES, TRIANGLES)
    for wrong in (np.eye(3), None, (np.eye(3), np.zeros(3))):
        with pytest.raises(abut.InputTypeError, match="moved by a Motion"):
            mesh.move(wrong)
    for motion in (abut.Motion(translation=[0, np.nan, 0]), abut.Motion(1e308 * np.ones((3, 3)))):
        with pytest.raises(abut.InputError):
            mesh.move(motion)
    with pytest.raises(abut.InputError):
        mesh.deform(VERTICES + [np.inf, 0, 0])
    for vertices in (VERTICES[:-1], VERTICES[:, :2]):
        with pytest.raises(abut.UsageError, match="5 vertices"):
            mesh.deform(vertices)
    with pytest.raises(abut.InputTypeError):
        mesh.deform("vertices")
    assert mesh.vertices.tolist() == VERTICES.tolist()
    cell = abut.Domain.periodic((1, None, None))
    joined = abut.TriangleMesh.joined(VERTICES, TRIANGLES, cell)
    with pytest.raises(abut.UsageError):
        joined.move(abut.Motion())
    seam = abut.TriangleMesh.joined(SEAM, [[0, 1, 2], [3, 4, 5]])
    with pytest.raises(abut.InputError, match="was joined with vertex 1"):
        seam.deform(SEAM + np.arange(6)[:, None])


def meshes():
    still = abut.TriangleMesh(VERTICES, TRIANGLES)
    turned = abut.TriangleMesh(VERTICES, TRIANGLES)
    turned.move(abut.Motion([[0.6, -0.8, 0], [0.8, 0.6, 0], [0, 0, 1]], [0.1, 0, 0]))
    seam = abut.TriangleMesh.joined(SEAM, [[0, 1, 2], [5, 4, 3]])
    cell = abut.Domain.periodic((1, 1, None))
    periodic = abut.TriangleMesh.joined(VERTICES[:4], [[0, 1, 2], [1, 3, 2]], cell)
    return {"still": still, "turned": turned, "seam": seam, "periodic": periodic}


@pytest.mark.parametrize("name", meshes())
def test_meshes_pickle(name):
    mesh = meshes()[name]
    again = pickle.loads(pickle.dumps(mesh))
    assert again.domain == mesh.domain
    assert again.motion == mesh.motion
    for array in (
        *("vertices", "rest_vertices", "vertex_features", "triangles", "edges"),
        *("edges_of_triangles", "faces", "feature_shifts"),
    ):
        assert getattr(again, array).tolist() == getattr(mesh, array).tolist()


def same(found, expected):
    assert found.records.tobytes() == expected.records.tobytes()
    assert found.gap.tobytes() == expected.gap.tobytes()
    assert found.statistics.contact_pairs == len(expected)


def test_a_detector_finds_what_the_functions_find():
    random = np.random.default_rng(8)
    x = random.random((300, 3)) * [1, 1, 2] - [0, 0, 1]
    spheres = abut.spheres(x, 0.08)
    lower = random.random((15, 3)) - [0, 0, 0.5]
    boxes = abut.boxes(lower, lower + 0.25)
    detector = abut.Detector(quantities="gap", margin=0.01)
    mesh = abut.TriangleMesh(VERTICES, TRIANGLES)
    kept = []
    for step in range(6):
        c, s = np.cos(0.2 * step), np.sin(0.2 * step)
        mesh.move(abut.Motion([[c, 0, s], [0, 1, 0], [-s, 0, c]], [0, 0, 0.02 * step]))
        if step == 3:
            mesh.deform(1.01 * VERTICES)
        on_mesh = detector.find_mesh_contacts(spheres, mesh)
        same(on_mesh, abut.find_mesh_contacts(spheres, mesh, margin=0.01))
        on_boxes = detector.find_box_contacts(spheres, boxes, margin=0.0)
        same(on_boxes, abut.find_box_contacts(spheres, boxes))
        assert len(on_mesh) > 40
        assert len(on_boxes) > 40
        kept.append((on_mesh.records, on_mesh.records.copy(), on_mesh.gap, on_mesh.gap.copy()))
    del detector
    for records, record_values, gap, gap_values in kept:
        assert records.tobytes() == record_values.tobytes()
        assert gap.tobytes() == gap_values.tobytes()
    assert len({records.tobytes() for records, *_ in kept}) > 1


def test_a_detector_takes_domains_and_rules_to_walls():
    cell = abut.Domain.periodic((1, 1, None))
    floor = abut.TriangleMesh.joined(VERTICES[:4], TRIANGLES[:2], cell)
    spheres = abut.spheres([[0.0, 0.5, 0.25], [0.3, 0.3, 0.25]], 0.3)
    detector = abut.Detector(domain=cell)
    c = detector.find_mesh_contacts(spheres, floor)
    assert c.sphere.tolist() == [0, 1]
    assert c.domain == cell
    assert c.gap.tolist() == abut.find_mesh_contacts(spheres, floor, domain=cell).gap.tolist()
    denied = detector.find_mesh_contacts(spheres, floor, exclude=[[1, 0], [1, 1]])
    assert denied.sphere.tolist() == [0]
    with pytest.raises(abut.UsageError):
        detector.find_mesh_contacts(spheres, floor, domain=None)
    with pytest.raises(abut.InputTypeError, match="a TriangleMesh is needed"):
        detector.find_mesh_contacts(spheres, spheres)
    with pytest.raises(abut.InputTypeError):
        detector.find_box_contacts(spheres, floor)


def test_a_mesh_does_not_move_while_a_call_reads_it():
    mesh = abut.TriangleMesh(VERTICES, TRIANGLES)
    spheres = abut.spheres(np.random.default_rng(3).random((1000, 3)), 0.05)
    expected = abut.find_mesh_contacts(spheres, mesh).records.tobytes()

    def move(*_):
        mesh.move(abut.Motion(translation=[9, 9, 9]))

    def deform(*_):
        mesh.deform(9 * VERTICES)

    for change in (move, deform):
        for find in (abut.find_mesh_contacts, abut.Detector().find_mesh_contacts):
            with pytest.raises(abut.UsageError, match="reads this mesh"):
                find(spheres, mesh, progress=change)
        found = abut.find_mesh_contacts(spheres, mesh)
        with pytest.raises(abut.UsageError, match="reads this mesh"):
            abut.measure(spheres, found, "gap", mesh, progress=change)
        assert found.records.tobytes() == expected
    move()
    assert len(abut.find_mesh_contacts(spheres, mesh)) == 0


def test_threads_read_one_mesh():
    mesh = abut.TriangleMesh(VERTICES, TRIANGLES)
    spheres = abut.spheres(np.random.default_rng(3).random((1000, 3)), 0.05)
    expected = abut.find_mesh_contacts(spheres, mesh).records.tobytes()
    found = []

    def search():
        found.extend(abut.find_mesh_contacts(spheres, mesh).records.tobytes() for _ in range(20))

    threads = [threading.Thread(target=search) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == [expected] * 80
    mesh.move(abut.Motion())

"""Spheres against boxes and meshes."""

import numpy as np
import pytest
from conftest import tuples

import abut
from abut import FeatureKind

FLOOR = ([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [1, 3, 2]])


def test_boxes():
    spheres = abut.spheres([[0.5, 0.5, 1.25], [2, 2, 2], [-0.25, -0.25, 0.5]], 0.5)
    c = abut.find_box_contacts(spheres, abut.boxes([[0, 0, 0]], [[1, 1, 1]]))
    assert c.sphere.tolist() == [0, 2]
    assert c.box.tolist() == [0, 0]
    assert c.kind.tolist() == [FeatureKind.face, FeatureKind.edge]
    assert c.side.tolist() == [[0, 0, 1], [-1, -1, 0]]
    assert c.statistics.contact_pairs == len(c) == 2
    with pytest.raises(ValueError, match="read-only"):
        c.sphere[0] = 1
    flat = abut.find_box_contacts(abut.discs([[1, 1]], 0), abut.rectangles([[0, 0]], [[1, 1]]))
    assert flat.kind.tolist() == [FeatureKind.vertex]


def test_meshes():
    mesh = abut.TriangleMesh(*FLOOR)
    assert mesh.triangles.tolist() == [[0, 1, 2], [1, 2, 3]]
    assert mesh.vertices.shape == (4, 3)
    assert mesh.edges_of_triangles.shape == (2, 3)
    assert mesh.faces.tolist() == [0, 1]
    spheres = abut.spheres([[0.25, 0.25, 0.25], [0.75, 0.75, -0.5], [0, 0, 9]], 0.5)
    c = abut.find_mesh_contacts(spheres, mesh)
    assert [tuple(record) for record in c.records] == [
        (0, FeatureKind.face, 0),
        (1, FeatureKind.face, 1),
    ]
    assert c.number.tolist() == [0, 1]
    denied = abut.find_mesh_contacts(spheres, mesh, exclude=[[1, 1]])
    assert denied.sphere.tolist() == [0]
    assert len(abut.find_mesh_contacts(abut.spheres([], 1.0), mesh)) == 0


def test_periodic_meshes():
    cell = abut.Domain.periodic((1, 1, None))
    joined = abut.TriangleMesh.joined(*FLOOR, cell)
    assert joined.vertex_features.tolist() == [0, 0, 0, 0]
    c = abut.find_mesh_contacts(abut.spheres([[0, 0.5, 0.25]], 0.3), joined, domain=cell)
    assert len(c) == 1
    assert c.shift.shape == (1, 3)
    with pytest.raises(ValueError):
        abut.find_mesh_contacts(abut.spheres([[0, 0.5, 0.25]], 0.3), joined)
    without = abut.find_mesh_contacts(
        abut.spheres([[0, 0.5, 0.25]], 0.3), joined, domain=cell, shifts=False
    )
    with pytest.raises(abut.UsageError, match="shifts=True"):
        without.shift  # noqa: B018


def test_fitted_boxes():
    vertices = np.array([[0, 0, 0], [1, 0, 0], [0, 2, 0], [0, 0, 3]], dtype=np.float32)
    boxes = abut.fit_boxes(vertices, [[0, 1, 2, 3]])
    assert np.allclose(np.transpose(boxes._first), [[0, 0, 0]])
    assert np.allclose(np.transpose(boxes._second), [[1, 2, 3]])
    assert tuples(np.transpose(boxes._second) >= [[1, 2, 3]]) == [(True,) * 3]
    assert abut.fit_boxes(vertices[:, :2], [[0, 1], [0, 2]], 0.5).shape == "rectangle"


def test_wrong_walls():
    with pytest.raises(ValueError, match="4"):
        abut.TriangleMesh(FLOOR[0], [[0, 1, 4]])
    with pytest.raises(TypeError):
        abut.TriangleMesh(FLOOR[0], [[0.0, 1.0, 2.0]])
    with pytest.raises(ValueError):
        abut.TriangleMesh(FLOOR[0], [[0, 1]])
    with pytest.raises(ValueError):
        abut.TriangleMesh(FLOOR[0], [0, 1, 2])
    with pytest.raises(ValueError):
        abut.fit_boxes([[0, 0]], [[-1]])
    with pytest.raises(TypeError, match="TriangleMesh"):
        abut.find_mesh_contacts(abut.points([[0, 0, 0]]), FLOOR)
    with pytest.raises(ValueError):
        abut.find_box_contacts(abut.points([[0, 0, 0]]), abut.points([[0, 0, 0]]))


def test_a_mesh_joined_across_a_face_knows_its_domain_and_shifts():
    cell = abut.Domain.periodic((1, None, None))
    x = [[0, 0, 0], [0.5, 0, 0], [1, 0, 0], [0, 1, 0], [0.5, 1, 0], [1, 1, 0]]
    triangles = [[0, 1, 3], [1, 3, 4], [1, 2, 4], [2, 4, 5]]
    mesh = abut.TriangleMesh.joined(x, triangles, cell)
    assert mesh.domain == cell
    assert mesh.feature_shifts.shape == (4, 7, 3)
    assert {tuple(n) for n in mesh.feature_shifts.reshape(-1, 3).tolist()} == {(0, 0, 0), (1, 0, 0)}
    plain = abut.TriangleMesh(x, triangles)
    assert not plain.domain.is_periodic
    assert plain.feature_shifts.shape == (0, 7, 3)

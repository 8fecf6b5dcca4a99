"""Spheres against walls: boxes and meshes of triangles."""

from __future__ import annotations

from typing import Any, Unpack

from . import _abut
from ._detect import prepared
from ._domain import native_domain
from ._elements import Elements, require_elements
from ._errors import InputTypeError
from ._mesh import TriangleMesh
from ._options import Options, call_options
from ._wall_contacts import BoxContacts, MeshContacts


def find_box_contacts(
    spheres: Elements, boxes: Elements, **options: Unpack[Options]
) -> BoxContacts:
    """Finds the contacts of spheres and solid boxes, or of discs and rectangles.

    >>> import abut
    >>> c = abut.find_box_contacts(abut.spheres([[0.5, 0.5, 1.25]], 0.5),
    ...                            abut.boxes([[0, 0, 0]], [[1, 1, 1]]))
    >>> abut.FeatureKind(c.kind[0]).name, c.side
    ('face', array([[0, 0, 1]], dtype=int8))
    >>> c.gap, c.normal
    (array([-0.25]), array([[ 0.,  0., -1.]]))
    """
    results = _abut.find_box_contacts(*prepared(spheres, require_elements(boxes), options))
    return BoxContacts(results, spheres, boxes, options)


def require_mesh(given: Any) -> TriangleMesh:
    """The mesh given, or an error that says what is needed."""
    if isinstance(given, TriangleMesh):
        return given
    raise InputTypeError(f"a TriangleMesh is needed, not {type(given).__name__}")


def prepared_with_mesh(
    spheres: Elements, mesh: TriangleMesh, options: Options
) -> tuple[_abut.Elements, _abut.TriangleMesh, _abut.Domain, _abut.CallOptions]:
    """Arguments for the compiled module: spheres, mesh, domain, options."""
    wall = require_mesh(mesh)
    first = require_elements(spheres)
    domain = native_domain(options.get("domain"))
    native = call_options((len(first), len(wall)), **options)
    return first._native, wall._native, domain, native


def find_mesh_contacts(
    spheres: Elements, mesh: TriangleMesh, **options: Unpack[Options]
) -> MeshContacts:
    """Finds the contacts of spheres and a mesh: a plane is touched once, however it is divided.

    >>> import abut
    >>> mesh = abut.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [1, 2, 3]])
    >>> c = abut.find_mesh_contacts(abut.spheres([[0.5, 0.5, 0.25], [0, 0, 1]], 0.5), mesh)
    >>> c.sphere, abut.FeatureKind(c.kind[0]).name, mesh.edges[c.number[0]]
    (array([0], dtype=uint32), 'edge', array([1, 2], dtype=uint32))
    >>> c.gap, c.normal, c.point
    (array([-0.25]), array([[ 0.,  0., -1.]]), array([[0.5, 0.5, 0. ]]))
    """
    results = _abut.find_mesh_contacts(*prepared_with_mesh(spheres, mesh, options))
    return MeshContacts(results, spheres, mesh, options)

"""Spheres against walls: boxes and meshes of triangles."""

from __future__ import annotations

from enum import IntEnum
from functools import cached_property
from typing import Any, Unpack

import numpy as np
import numpy.typing as npt

from . import _abut
from ._arrays import number, whole_numbers
from ._detect import prepared
from ._domain import OPEN, Domain, native_domain
from ._elements import Elements, boxes, points, rectangles, require_elements
from ._errors import InputError, InputTypeError, UsageError
from ._options import Options, call_options
from ._statistics import Statistics


class FeatureKind(IntEnum):
    """Kind of the part of a body that a sphere touches."""

    interior = 0  #: Inside of a solid, without its boundary.
    face = 1  #: Face without its edges.
    edge = 2  #: Edge without its ends.
    vertex = 3  #: Point where edges end.


_BOX_CONTACT = np.dtype(
    {
        "names": ["sphere", "box", "kind", "side"],
        "formats": ["u4", "u4", "u4", ("i1", 3)],
        "offsets": [0, 4, 8, 12],
        "itemsize": 16,
    }
)
_MESH_CONTACT = np.dtype([("sphere", "u4"), ("kind", "u4"), ("number", "u4")])


class _WallContacts:
    """What contacts with boxes and with meshes have in common."""

    _dtype: np.dtype[Any]

    def __init__(self, results: Any, domain: Domain | None) -> None:
        self._results = results
        self._is_periodic = domain is not None and domain.is_periodic

    def __len__(self) -> int:
        return len(self._results)

    @cached_property
    def records(self) -> npt.NDArray[Any]:
        """Structured array of the contacts: a read-only view."""
        records: npt.NDArray[Any] = self._results.records.view(self._dtype)
        return records.reshape(-1)

    @property
    def sphere(self) -> npt.NDArray[np.uint32]:
        """Index of the sphere of each contact."""
        return self.records["sphere"]

    @property
    def kind(self) -> npt.NDArray[np.uint32]:
        """FeatureKind of the part that is touched, as a number."""
        return self.records["kind"]

    @cached_property
    def shift(self) -> npt.NDArray[np.int32]:
        """Image shift (M, 3) of the wall of each contact."""
        shifts: npt.NDArray[np.int32] = self._results.shifts
        if len(shifts) == len(self):
            return shifts
        if self._is_periodic:
            raise UsageError("image shifts were not stored; ask for them with shifts=True")
        return np.broadcast_to(np.int32(0), (len(self), 3))

    @cached_property
    def statistics(self) -> Statistics:
        """Work and cost of the detection."""
        return Statistics(**self._results.statistics)

    def __repr__(self) -> str:
        return f"<abut.{type(self).__name__}: {len(self):,} contacts>"


class BoxContacts(_WallContacts):
    """Contacts of spheres and boxes, ascending by sphere, box and image shift."""

    _dtype = _BOX_CONTACT

    @property
    def box(self) -> npt.NDArray[np.uint32]:
        """Index of the box of each contact."""
        return self.records["box"]

    @property
    def side(self) -> npt.NDArray[np.int8]:
        """Place (M, 3) of what is touched on each axis: -1 on the lower bound of the box, 1 on the
        upper one, 0 between them."""
        return self.records["side"]


class MeshContacts(_WallContacts):
    """Contacts of spheres and a mesh, ascending by sphere, kind, number and image shift."""

    _dtype = _MESH_CONTACT

    @property
    def number(self) -> npt.NDArray[np.uint32]:
        """Number of the triangle for a face, of the vertex for a vertex, and the place in `edges`
        of the mesh for an edge."""
        return self.records["number"]


def find_box_contacts(
    spheres: Elements, boxes: Elements, **options: Unpack[Options]
) -> BoxContacts:
    """Finds the contacts of spheres and solid boxes, or of discs and rectangles.

    >>> import abut
    >>> c = abut.find_box_contacts(abut.spheres([[0.5, 0.5, 1.25]], 0.5),
    ...                            abut.boxes([[0, 0, 0]], [[1, 1, 1]]))
    >>> abut.FeatureKind(c.kind[0]).name, c.side
    ('face', array([[0, 0, 1]], dtype=int8))
    """
    results = _abut.find_box_contacts(*prepared(spheres, boxes, options))
    return BoxContacts(results, options.get("domain"))


def _cells(given: Any) -> npt.NDArray[np.int64]:
    cells = whole_numbers(given, np.int64, "vertex numbers of cells")
    if cells.ndim != 2 or cells.shape[1] not in (1, 2, 3, 4, 6, 8):
        raise InputError(f"cells have a row of vertex numbers each, not the shape {cells.shape}")
    return cells


def fit_boxes(vertices: Any, cells: npt.ArrayLike, skin: float = 0.0) -> Elements:
    """Computes the smallest box around the vertices of each cell of a mesh.

    Parameters
    ----------
    vertices : array (V, 2) or (V, 3), or what else positions may be
    cells : array (N, K) of whole numbers
        Numbers of the vertices of each cell: segments, triangles, tetrahedra, ...
    skin : float
        The boxes are wider by so much on every side, and rounded outwards.

    >>> import abut
    >>> abut.fit_boxes([[0, 0, 0], [1, 0, 0], [0, 2, 0]], [[0, 1, 2]])
    <abut.Elements: 1 boxes in float64>
    """
    places = points(vertices)
    columns = _abut.fit_boxes(places._native, _cells(cells), number(skin, "the skin"))
    dimensions = places.dimensions
    made = boxes if dimensions == 3 else rectangles
    return made(tuple(columns[:dimensions]), tuple(columns[dimensions:]))


class TriangleMesh:
    """A surface of triangles, with its edges. It holds a copy of the vertices.

    Two triangles have a common edge if both name the same two vertices.

    Parameters
    ----------
    vertices : array (V, 3), or what else positions may be
    triangles : array (N, 3) of whole numbers

    >>> import abut
    >>> mesh = abut.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [1, 2, 3]])
    >>> mesh
    <abut.TriangleMesh: 2 triangles, 5 edges, 4 vertices>
    >>> mesh.edges[1]
    array([0, 2], dtype=uint32)
    """

    def __init__(self, vertices: Any, triangles: npt.ArrayLike) -> None:
        self._native = _abut.triangle_mesh(points(vertices)._native, _cells(triangles))
        self._domain = OPEN

    @staticmethod
    def joined(
        vertices: Any, triangles: npt.ArrayLike, domain: Domain | None = None
    ) -> TriangleMesh:
        """A mesh in which vertices at the same place are one, also across the faces of a periodic
        domain; such a mesh has contacts in that domain only."""
        mesh = TriangleMesh.__new__(TriangleMesh)
        mesh._native = _abut.joined_mesh(
            points(vertices)._native, _cells(triangles), native_domain(domain)
        )
        mesh._domain = OPEN if domain is None else domain
        return mesh

    def __len__(self) -> int:
        return len(self._native)

    @property
    def vertices(self) -> npt.NDArray[np.float64]:
        """Positions of the vertices."""
        return self._native.vertices

    @property
    def vertex_features(self) -> npt.NDArray[np.uint32]:
        """Number of the feature that each vertex is: its own, unless vertices were joined."""
        return self._native.vertex_features

    @property
    def triangles(self) -> npt.NDArray[np.uint32]:
        """Vertices of each triangle; ascending, unless vertices were joined."""
        return self._native.triangles

    @property
    def edges(self) -> npt.NDArray[np.uint32]:
        """Vertices of each edge."""
        return self._native.edges

    @property
    def edges_of_triangles(self) -> npt.NDArray[np.uint32]:
        """Edges of each triangle: of vertices a, b, c the numbers of the edges ab, ac, bc."""
        return self._native.edges_of_triangles

    @property
    def faces(self) -> npt.NDArray[np.uint32]:
        """Face of each triangle: the smallest number of the triangles that are the same face."""
        return self._native.faces

    @property
    def feature_shifts(self) -> npt.NDArray[np.int32]:
        """Lattice vectors (N, 7, 3) by which the parts of each triangle lie apart from their
        features: vertices a, b, c, edges ab, ac, bc, face; (0, 7, 3) unless vertices were joined
        across the faces of a domain."""
        return self._native.feature_shifts.reshape(-1, 7, 3)

    @property
    def domain(self) -> Domain:
        """Domain across whose faces vertices were joined."""
        return self._domain

    def __repr__(self) -> str:
        return (
            f"<abut.TriangleMesh: {len(self):,} triangles, {len(self.edges):,} edges, "
            f"{len(self.vertices):,} vertices>"
        )


def find_mesh_contacts(
    spheres: Elements, mesh: TriangleMesh, **options: Unpack[Options]
) -> MeshContacts:
    """Finds the contacts of spheres and a mesh: a plane is touched once, however it is divided.

    >>> import abut
    >>> mesh = abut.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [1, 2, 3]])
    >>> c = abut.find_mesh_contacts(abut.spheres([[0.5, 0.5, 0.25], [0, 0, 1]], 0.5), mesh)
    >>> c.sphere, abut.FeatureKind(c.kind[0]).name, mesh.edges[c.number[0]]
    (array([0], dtype=uint32), 'edge', array([1, 2], dtype=uint32))
    """
    if not isinstance(mesh, TriangleMesh):
        raise InputTypeError(f"a TriangleMesh is needed, not {type(mesh).__name__}")
    first = require_elements(spheres)
    domain = options.get("domain")
    native = call_options((len(first), len(mesh)), **options)
    results = _abut.find_mesh_contacts(first._native, mesh._native, native_domain(domain), native)
    return MeshContacts(results, domain)

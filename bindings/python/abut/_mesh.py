"""Surfaces of triangles, which may move."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from . import _abut
from ._arrays import numbers
from ._domain import OPEN, Domain, native_domain
from ._elements import points
from ._errors import InputError, InputTypeError
from ._fit_boxes import cells_of


class Motion:
    """A motion that moves a vertex v to R v + t. It is rigid if R is a rotation, which nothing asks
    for: the rounding of a rotation, a mirror or a stretch are all moved as they are given.

    Parameters
    ----------
    rotation : array (3, 3)
        R; the identity by default. What `scipy.spatial.transform.Rotation.as_matrix` returns.
    translation : array (3,)
        t, in the unit of the positions; zeros by default.

    Raises
    ------
    InputError, InputTypeError
        Another shape or type.

    >>> import abut
    >>> abut.Motion(translation=(0, 0, 1.5))
    Motion([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], [0.0, 0.0, 1.5])
    """

    __slots__ = ("_rotation", "_translation")

    def __init__(
        self, rotation: npt.ArrayLike | None = None, translation: npt.ArrayLike = (0.0, 0.0, 0.0)
    ) -> None:
        self._rotation = _kept(np.eye(3) if rotation is None else rotation, (3, 3), "a rotation")
        self._translation = _kept(translation, (3,), "a translation")

    @property
    def rotation(self) -> npt.NDArray[np.float64]:
        """R, (3, 3), read-only."""
        return self._rotation

    @property
    def translation(self) -> npt.NDArray[np.float64]:
        """t, (3,), read-only, in the unit of the positions."""
        return self._translation

    def __eq__(self, other: object) -> bool:
        return (
            isinstance(other, Motion)
            and np.array_equal(self.rotation, other.rotation)
            and np.array_equal(self.translation, other.translation)
        )

    __hash__ = None  # type: ignore[assignment]  # 0.0 and -0.0 are equal, their bytes are not

    def __repr__(self) -> str:
        return f"Motion({self.rotation.tolist()}, {self.translation.tolist()})"

    def __reduce__(self) -> Any:
        return Motion, (self.rotation, self.translation)


def _kept(given: npt.ArrayLike, shape: tuple[int, ...], what: str) -> npt.NDArray[np.float64]:
    """A copy that nobody changes."""
    array = numbers(given, what)
    if array.shape != shape:
        raise InputError(f"{what} has the shape {shape}, not {array.shape}")
    copy = np.array(array, dtype=np.float64)
    copy.flags.writeable = False
    return copy


class TriangleMesh:
    """A surface of triangles, with its edges. It holds a copy of the vertices.

    Two triangles have a common edge if both name the same two vertices. All arrays are read-only,
    outlive the mesh, and stay as they are when it moves.

    Parameters
    ----------
    vertices : array (V, 3), or what else positions may be
    triangles : array (N, 3) of whole numbers

    Raises
    ------
    InputError, InputTypeError
        A vertex that is not there or not finite, a wrong shape or type.

    >>> import abut
    >>> mesh = abut.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [1, 2, 3]])
    >>> mesh
    <abut.TriangleMesh: 2 triangles, 5 edges, 4 vertices>
    >>> mesh.edges[1]
    array([0, 2], dtype=uint32)
    """

    def __init__(self, vertices: Any, triangles: npt.ArrayLike) -> None:
        self._native = _abut.triangle_mesh(points(vertices)._native, cells_of(triangles))
        self._domain: Domain | None = None
        self._vertices: npt.NDArray[np.float64] | None = None

    @staticmethod
    def joined(
        vertices: Any, triangles: npt.ArrayLike, domain: Domain | None = None
    ) -> TriangleMesh:
        """A mesh in which vertices at the same place are one, also across the faces of a periodic
        domain; such a mesh has contacts in that domain only."""
        mesh = TriangleMesh.__new__(TriangleMesh)
        mesh._native = _abut.joined_mesh(
            points(vertices)._native, cells_of(triangles), native_domain(domain)
        )
        mesh._domain = OPEN if domain is None else domain
        mesh._vertices = None
        return mesh

    def move(self, motion: Motion) -> None:
        """Moves the mesh to where the motion takes it from its rest position, which is the one that
        it was made or last deformed with: errors of many steps do not add up.

        Each coordinate becomes ((R[k, 0] v[0] + R[k, 1] v[1]) + R[k, 2] v[2]) + t[k], each
        operation rounded once. Contacts are exactly those with these numbers, and features keep
        theirs.

        Parameters
        ----------
        motion : Motion

        Raises
        ------
        InputError
            The motion is not finite, or takes a vertex of a triangle beyond the numbers of float64.
        UsageError
            The mesh was joined across the faces of a domain, or is read by a call in another
            thread. Then nothing has changed.

        >>> import abut
        >>> mesh = abut.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
        >>> mesh.move(abut.Motion([[0, -1, 0], [1, 0, 0], [0, 0, 1]], [0, 0, 2]))
        >>> mesh.vertices[1], mesh.rest_vertices[1]
        (array([0., 1., 2.]), array([1., 0., 0.]))
        """
        if not isinstance(motion, Motion):
            raise InputTypeError(f"a mesh is moved by a Motion, not by {type(motion).__name__}")
        self._native.move(motion.rotation.tolist(), motion.translation.tolist())
        self._vertices = None

    def deform(self, vertices: Any) -> None:
        """Gives the mesh a new rest position; features keep their numbers.

        Parameters
        ----------
        vertices : array (V, 3), or what else positions may be
            As many as the mesh has.

        Raises
        ------
        InputError
            A vertex of a triangle is not finite, or vertices that were joined lie apart.
        UsageError
            Another number of vertices, and as `move`. Then nothing has changed.
        """
        self._native.deform(points(vertices)._native)
        self._vertices = None

    @property
    def motion(self) -> Motion:
        """Motion from the position at rest to that of `vertices`."""
        return Motion(*self._native.motion)

    def __len__(self) -> int:
        return len(self._native)

    @property
    def vertices(self) -> npt.NDArray[np.float64]:
        """Positions (V, 3) of the vertices: a copy, made once for each position of the mesh."""
        if self._vertices is None:
            self._vertices = self._native.vertices()
        return self._vertices

    @property
    def rest_vertices(self) -> npt.NDArray[np.float64]:
        """Positions (V, 3) of the vertices at rest: a copy."""
        return self._native.rest_vertices()

    @property
    def vertex_features(self) -> npt.NDArray[np.uint32]:
        """Number (V,) of the feature that each vertex is: its own, unless vertices were joined."""
        return self._native.vertex_features

    @property
    def triangles(self) -> npt.NDArray[np.uint32]:
        """Vertices (N, 3) of each triangle; ascending, unless vertices were joined."""
        return self._native.triangles

    @property
    def edges(self) -> npt.NDArray[np.uint32]:
        """Vertices (E, 2) of each edge."""
        return self._native.edges

    @property
    def edges_of_triangles(self) -> npt.NDArray[np.uint32]:
        """Edges (N, 3) of each triangle: of vertices a, b, c the numbers of the edges ab, ac, bc."""
        return self._native.edges_of_triangles

    @property
    def faces(self) -> npt.NDArray[np.uint32]:
        """Face (N,) of each triangle: the smallest number of the triangles that are the same
        face."""
        return self._native.faces

    @property
    def feature_shifts(self) -> npt.NDArray[np.int32]:
        """Lattice vectors (N, 7, 3) by which the parts of each triangle lie apart from their
        features: vertices a, b, c, edges ab, ac, bc, face; (0, 7, 3) unless vertices were joined
        across the faces of a domain."""
        return self._native.feature_shifts.reshape(-1, 7, 3)

    @property
    def domain(self) -> Domain:
        """Domain across whose faces vertices were joined; open if none were."""
        return OPEN if self._domain is None else self._domain

    def __repr__(self) -> str:
        return (
            f"<abut.TriangleMesh: {len(self):,} triangles, {len(self.edges):,} edges, "
            f"{len(self.vertex_features):,} vertices>"
        )

    def __reduce__(self) -> Any:
        return _made, (self.rest_vertices, self.triangles, self._domain, self.motion)


def _made(
    vertices: Any, triangles: npt.ArrayLike, domain: Domain | None, motion: Motion
) -> TriangleMesh:
    """A mesh that was pickled; `domain` is None if no vertices were joined."""
    if domain is None:
        mesh = TriangleMesh(vertices, triangles)
    else:
        mesh = TriangleMesh.joined(vertices, triangles, domain)
    if motion != Motion():
        mesh.move(motion)
    return mesh

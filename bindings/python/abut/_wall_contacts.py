"""Contacts of spheres with boxes and meshes, and what is asked of them."""

from __future__ import annotations

from enum import IntEnum
from functools import cached_property
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _abut
from ._arrays import whole_numbers
from ._domain import OPEN, Domain
from ._elements import Elements, require_elements
from ._errors import InputError, InputTypeError, UsageError
from ._geometry import QUANTITIES, Arrays, Measured
from ._mesh import TriangleMesh
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
    },
    align=True,
)
_MESH_CONTACT = np.dtype([("sphere", "u4"), ("kind", "u4"), ("number", "u4")], align=True)


class _WallContacts(Measured):
    """What contacts with boxes and with meshes have in common."""

    _dtype: np.dtype[Any]

    def __init__(self, results: Any, spheres: Elements, wall: Any, options: Options) -> None:
        self._results = results
        self._spheres = spheres
        self._wall = wall
        self._domain = options.get("domain") or OPEN
        self._threads = options.get("threads")
        self._measured: dict[str, npt.NDArray[np.float64]] = {}

    def __len__(self) -> int:
        return len(self.records)

    @cached_property
    def records(self) -> npt.NDArray[Any]:
        """Structured array of the contacts, (M,)."""
        records: npt.NDArray[Any] = self._results.records.view(self._dtype)
        return records.reshape(-1)

    @property
    def sphere(self) -> npt.NDArray[np.uint32]:
        """Index of the sphere of each contact, (M,)."""
        return self.records["sphere"]

    @property
    def kind(self) -> npt.NDArray[np.uint32]:
        """FeatureKind of the part that is touched, as a number, (M,)."""
        return self.records["kind"]

    @cached_property
    def shift(self) -> npt.NDArray[np.int32]:
        """Image shift (M, 3) of the wall of each contact."""
        if self._results is not None and len(self._results.shifts) == len(self):
            shifts: npt.NDArray[np.int32] = self._results.shifts
            return shifts
        if self._domain.is_periodic:
            raise UsageError("image shifts were not stored; ask for them with shifts=True")
        return np.broadcast_to(np.int32(0), (len(self), 3))

    @property
    def gap(self) -> npt.NDArray[np.float64]:
        """Distance to the wall less the radius, (M,), in the unit of the positions; <= 0 exactly
        where the sphere touches."""
        return self.measure("gap")[0]

    @property
    def normal(self) -> npt.NDArray[np.float64]:
        """Unit vector from the center to the nearest point of the wall, (M, dimensions): into the
        wall. 0 where a center lies on a mesh; of a center in a box that of the nearest face."""
        return self.measure("normal")[0]

    @property
    def point(self) -> npt.NDArray[np.float64]:
        """Point of the wall that is nearest to the center, (M, dimensions), beside the sphere,
        which is not moved by the image shift."""
        return self.measure("point")[0]

    @property
    def distance(self) -> npt.NDArray[np.float64]:
        """Distance of the center to the wall, (M,); of a center in a box minus its depth."""
        return self.measure("distance")[0]

    @property
    def vector(self) -> npt.NDArray[np.float64]:
        """Vector from the center to the point of the wall, (M, dimensions): distance times
        normal."""
        return self.measure("vector")[0]

    def _measure_now(self, names: list[str]) -> Arrays:
        shift = self.shift if self._domain.is_periodic else None
        options = call_options(quantities=names, threads=self._threads)
        return arrays_of_contacts(
            self._spheres, self._wall, self._domain._native, self.records, shift, options
        )

    @property
    def _dimensions(self) -> int:
        return self._spheres.dimensions

    @property
    def spheres(self) -> Elements:
        """The spheres or discs."""
        return self._spheres

    @property
    def domain(self) -> Domain:
        """The domain of the detection."""
        return self._domain

    @cached_property
    def statistics(self) -> Statistics:
        """Work and cost of the detection."""
        return Statistics(**self._results.statistics)

    def __repr__(self) -> str:
        return f"<abut.{type(self).__name__}: {len(self):,} contacts>"

    def __getstate__(self) -> dict[str, Any]:
        self._measured.update(self._stored(QUANTITIES))
        state = {**self.__dict__, "_results": None}
        for name in ("records", "shift", "statistics"):
            try:
                state[name] = getattr(self, name)
            except UsageError:  # shifts that were not stored stay unknown
                continue
        return state


class BoxContacts(_WallContacts):
    """Contacts of spheres and boxes, ascending by sphere, box and image shift.

    Arrays are read-only and outlive this object. `gap`, `normal`, `point`, `distance` and `vector`
    are measured when they are first asked for, from the caller's arrays; ask before these change,
    or name them as `quantities` of the detection.
    """

    _dtype = _BOX_CONTACT

    @property
    def boxes(self) -> Elements:
        """The boxes or rectangles."""
        boxes: Elements = self._wall
        return boxes

    @property
    def box(self) -> npt.NDArray[np.uint32]:
        """Index of the box of each contact, (M,)."""
        return self.records["box"]

    @property
    def side(self) -> npt.NDArray[np.int8]:
        """Place (M, 3) of what is touched on each axis: -1 on the lower bound of the box, 1 on the
        upper one, 0 between them."""
        return self.records["side"]


class MeshContacts(_WallContacts):
    """Contacts of spheres and a mesh, ascending by sphere, kind, number and image shift.

    Arrays are read-only and outlive this object. `gap`, `normal`, `point`, `distance` and `vector`
    are measured when they are first asked for, where spheres and mesh lie by then; ask before these
    move, or name them as `quantities` of the detection.
    """

    _dtype = _MESH_CONTACT

    @property
    def mesh(self) -> TriangleMesh:
        """The mesh."""
        mesh: TriangleMesh = self._wall
        return mesh

    @property
    def number(self) -> npt.NDArray[np.uint32]:
        """Number of the triangle for a face, of the vertex for a vertex, and the place in `edges`
        of the mesh for an edge, (M,)."""
        return self.records["number"]


def records_of(given: Any, wall: Any) -> npt.NDArray[Any]:
    """Contacts with a wall as a structured array that the module can read."""
    kind: type[_WallContacts] = MeshContacts if isinstance(wall, TriangleMesh) else BoxContacts
    if isinstance(given, kind):
        return given.records
    dtype = kind._dtype
    fields = dtype.names or ()
    array: npt.NDArray[Any] = given if isinstance(given, np.ndarray) else np.empty(0)
    if array.ndim != 1 or not set(fields) <= set(array.dtype.names or ()):
        raise InputTypeError(
            f"contacts with {'a mesh' if kind is MeshContacts else 'boxes'} are {kind.__name__}, "
            f"or an array (M,) of records with the fields {', '.join(fields)}"
        )
    records = np.zeros(len(array), dtype)
    for name in fields:
        numbers = whole_numbers(array[name], dtype[name].base.type, f"{name} of contacts")
        if numbers.shape != records[name].shape:
            raise InputError(f"{name} of contacts has the shape {numbers.shape}")
        records[name] = numbers
    return records


def table_of(records: npt.NDArray[Any]) -> npt.NDArray[np.uint8]:
    """The bytes of contacts, a row for each: the same memory."""
    return records.view(np.uint8).reshape(len(records), records.dtype.itemsize)


def arrays_of_contacts(
    spheres: Elements,
    wall: Any,
    domain: _abut.Domain,
    records: npt.NDArray[Any],
    shift: npt.NDArray[np.int32] | None,
    options: _abut.CallOptions,
) -> Arrays:
    """Measures contacts with a mesh or boxes, where these and the spheres lie by now."""
    table = table_of(records)
    if isinstance(wall, TriangleMesh):
        return _abut.measure_mesh_contacts(
            spheres._native, wall._native, domain, table, shift, options
        )
    boxes = require_elements(wall)._native
    return _abut.measure_box_contacts(spheres._native, boxes, domain, table, shift, options)

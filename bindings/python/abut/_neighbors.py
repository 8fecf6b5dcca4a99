"""Neighbor lists: the neighbors of each element in compressed rows."""

from __future__ import annotations

from functools import cached_property
from typing import Any, Unpack

import numpy as np
import numpy.typing as npt

from . import _abut
from ._arrays import number
from ._detect import prepared
from ._elements import Elements, as_points
from ._errors import UsageError
from ._geometry import shaped
from ._options import Options
from ._statistics import Statistics


class NeighborList:
    """The neighbors of each element: those of element e are neighbors[offsets[e]:offsets[e + 1]].

    Arrays are read-only views, which outlive the list.

    >>> import abut
    >>> n = abut.neighbors([[0, 0, 0], [1, 0, 0], [2, 0, 0]], 1.0, kind="full")
    >>> n
    <abut.NeighborList: 4 neighbors of 3 elements>
    >>> n[1]
    array([0, 2], dtype=uint32)
    """

    def __init__(self, results: _abut.NeighborResults, dimensions: int) -> None:
        self._results = results
        self._dimensions = dimensions

    def __len__(self) -> int:
        return len(self._results)

    def __getitem__(self, element: int) -> npt.NDArray[np.uint32]:
        return self.neighbors[self._row(element)]

    def _row(self, element: int) -> slice:
        if not -len(self) <= element < len(self):
            raise IndexError(f"element {element} of {len(self)}")
        element %= len(self)
        return slice(int(self.offsets[element]), int(self.offsets[element + 1]))

    @cached_property
    def offsets(self) -> npt.NDArray[np.uint64]:
        """Begin of the row of each element, and the end of the last: N + 1 numbers."""
        offsets = self._results.offsets
        return offsets if len(offsets) else np.zeros(1, np.uint64)

    @cached_property
    def neighbors(self) -> npt.NDArray[np.uint32]:
        """Neighbors of all elements, row after row, ascending in each."""
        return self._results.neighbors

    @cached_property
    def elements(self) -> npt.NDArray[np.uint32]:
        """The element that each neighbor is one of; made when it is first asked for."""
        elements: npt.NDArray[np.uint32] = self.elements_as(np.uint32)
        return elements

    def elements_as(self, dtype: npt.DTypeLike) -> npt.NDArray[Any]:
        """The element that each neighbor is one of, in a type of whole numbers."""
        counts = np.diff(self.offsets).astype(np.int64)
        return np.repeat(np.arange(len(self), dtype=dtype), counts)

    @cached_property
    def shifts(self) -> npt.NDArray[np.int32]:
        """Image shift of each neighbor, (M, 3)."""
        return self._stored(self._results.shifts, "image shifts", "shifts=True")

    @cached_property
    def gaps(self) -> npt.NDArray[np.float64]:
        """Distance of the surfaces for each neighbor, (M,)."""
        return self._quantity("gap", self._results.gaps)

    @cached_property
    def normals(self) -> npt.NDArray[np.float64]:
        """Unit vector from the element to each neighbor, (M, dimensions)."""
        return self._quantity("normal", self._results.normals)

    @cached_property
    def points(self) -> npt.NDArray[np.float64]:
        """Point of contact with each neighbor, (M, dimensions)."""
        return self._quantity("point", self._results.points)

    @cached_property
    def distances(self) -> npt.NDArray[np.float64]:
        """Distance of the centers for each neighbor, (M,): the nearest double, never above a
        cutoff."""
        return self._quantity("distance", self._results.distances)

    @cached_property
    def vectors(self) -> npt.NDArray[np.float64]:
        """Vector from the element to each neighbor, (M, dimensions), each component rounded
        once."""
        return self._quantity("vector", self._results.vectors)

    def _quantity(self, name: str, array: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
        stored = self._stored(array, f"{name}s", f"quantities={name!r}")
        return shaped(name, stored, self._dimensions)

    def _stored(self, array: npt.NDArray[Any], what: str, how: str) -> npt.NDArray[Any]:
        if len(array) != len(self.neighbors):
            raise UsageError(f"{what} were not stored; ask for them with {how}")
        return array

    @cached_property
    def statistics(self) -> Statistics:
        """Work and cost of the detection."""
        return Statistics(**self._results.statistics)

    def __repr__(self) -> str:
        return f"<abut.NeighborList: {len(self.neighbors):,} neighbors of {len(self):,} elements>"


def is_full(kind: str) -> bool:
    """Whether 'full' rather than 'half' is asked for."""
    if kind not in ("half", "full"):
        raise UsageError(f"kind is 'half' or 'full', not {kind!r}")
    return kind == "full"


def build_neighbor_list(
    elements: Elements,
    others: Elements | None = None,
    *,
    kind: str = "half",
    **options: Unpack[Options],
) -> NeighborList:
    """Builds the neighbor list of contact pairs, without a list of pairs in between.

    Parameters
    ----------
    elements, others : Elements
        With two sets there is one row for each of `elements`, with indices of `others`.
    kind : 'half' or 'full'
        Half: each pair (i, j) once, j is a neighbor of i. Full: i is a neighbor of j, too.
    **options
        Those of `contacts`; `quantities` names what the list holds of each neighbor.

    >>> import abut
    >>> abut.build_neighbor_list(abut.discs([[0, 0], [1, 0]], 0.5)).neighbors
    array([1], dtype=uint32)
    """
    first, second, domain, native = prepared(elements, others, options)
    return NeighborList(
        _abut.build_neighbor_list(first, second, domain, is_full(kind), native),
        elements.dimensions,
    )


def neighbors(
    x: Any,
    cutoff: float,
    *,
    kind: str = "half",
    **options: Unpack[Options],
) -> NeighborList:
    """Lists the neighbors of points within `cutoff` of each other, the cutoff included.

    Parameters
    ----------
    x : array (N, 2) or (N, 3), tuple of columns, list of points, table, or Elements of radius 0
        Positions.
    cutoff : float
        Largest distance, in the unit of the positions.
    kind, **options
        Those of `build_neighbor_list`; the margin is the cutoff.

    >>> import abut
    >>> n = abut.neighbors([[0, 0, 0], [3, 0, 0]], 2.0, domain=abut.Domain.periodic((4, 4, 4)),
    ...                    quantities="distance")
    >>> n.neighbors, n.shifts, n.distances
    (array([1], dtype=uint32), array([[-1,  0,  0]], dtype=int32), array([1.]))
    """
    elements = as_points(x)
    first, _, domain, native = prepared(elements, None, options)
    reach = number(cutoff, "the cutoff")
    return NeighborList(
        _abut.neighbors(first, reach, domain, is_full(kind), native), elements.dimensions
    )

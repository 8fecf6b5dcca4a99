"""Quantities of pairs and contacts that are there already."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from . import _abut
from ._arrays import whole_numbers
from ._contacts import Contacts
from ._domain import Domain, native_domain
from ._elements import Elements, require_elements
from ._errors import InputError
from ._geometry import Arrays, PairGeometry, geometry_of
from ._mesh import TriangleMesh
from ._options import QuantityNames, call_options
from ._progress import Progress
from ._wall_contacts import BoxContacts, MeshContacts, arrays_of_contacts, records_of


def _table(given: npt.ArrayLike, dtype: type[np.generic], columns: int, what: str) -> Any:
    table = whole_numbers(given, dtype, what)
    if table.size == 0 and table.ndim == 1:
        table = table.reshape(0, columns)
    if table.ndim != 2 or table.shape[1] != columns:
        raise InputError(f"{what} have the shape (M, {columns}), not {table.shape}")
    return table


def _pairs_and_shifts(pairs: Any, shifts: Any, others: Any = None) -> tuple[Any, Any]:
    """A table of pairs or an array of records, and a table of shifts or None."""
    if shifts is None and isinstance(pairs, (Contacts, BoxContacts, MeshContacts)):
        shifts = pairs.shift if pairs.domain.is_periodic else None
    if _are_of_walls(pairs, others):
        table = records_of(pairs, others)
    else:
        table = _table(pairs.pairs if isinstance(pairs, Contacts) else pairs, np.uint32, 2, "pairs")
    if shifts is None:
        return table, None
    moves = _table(shifts, np.int32, 3, "image shifts")
    if len(moves) != len(table):
        raise InputError(f"{len(moves)} image shifts for {len(table)} pairs; give one for each")
    return table, moves


def _are_of_walls(pairs: Any, others: Any) -> bool:
    if isinstance(others, TriangleMesh) or isinstance(pairs, (BoxContacts, MeshContacts)):
        return True
    return isinstance(pairs, np.ndarray) and pairs.dtype.names is not None


class PairMeasurer:
    """Elements that were read once, so that many tables of pairs can be measured.

    It copies the elements: what happens to the caller's arrays later does not matter. Several
    threads may measure at the same time.

    Parameters
    ----------
    elements, others : Elements
        With two sets, pairs name an element of the first and one of the second.
    domain : Domain
        Open space by default.
    threads, max_bytes, simd, progress
        As in `contacts`.

    >>> import abut
    >>> measurer = abut.PairMeasurer(abut.discs([[0, 0], [1, 0], [0, 2]], 0.5))
    >>> measurer.measure([[0, 1]], "gap").gaps, measurer.measure([[1, 2]], "vector").vectors
    (array([0.]), array([[-1.,  2.]]))
    """

    def __init__(
        self,
        elements: Elements,
        others: Elements | None = None,
        *,
        domain: Domain | None = None,
        threads: int | None = None,
        max_bytes: int | None = None,
        simd: str = "auto",
        progress: Progress | None = None,
    ) -> None:
        first = require_elements(elements)
        self._dimensions = first.dimensions
        self._native = _abut.PairMeasurer(
            first._native,
            None if others is None else require_elements(others)._native,
            native_domain(domain),
            call_options(threads=threads, max_bytes=max_bytes, simd=simd, progress=progress),
        )

    def measure(
        self, pairs: npt.ArrayLike, quantities: QuantityNames, shifts: npt.ArrayLike | None = None
    ) -> PairGeometry:
        """Measures pairs in the calling thread; see the function `measure`."""
        table, moves = _pairs_and_shifts(pairs, shifts)
        options = call_options(quantities=quantities)
        return geometry_of(self._native.measure(table, moves, options), self._dimensions)


def measure(
    elements: Elements,
    pairs: npt.ArrayLike | Contacts | BoxContacts | MeshContacts,
    quantities: QuantityNames,
    others: Elements | TriangleMesh | None = None,
    *,
    shifts: npt.ArrayLike | None = None,
    domain: Domain | None = None,
    threads: int | None = None,
    max_bytes: int | None = None,
    simd: str = "auto",
    progress: Progress | None = None,
) -> PairGeometry:
    """Measures quantities of any pairs, whether they touch or not, or of contacts with walls.

    Parameters
    ----------
    elements, others : Elements
        With two sets, pairs name an element of the first and one of the second. For contacts with
        walls the spheres or discs, and the boxes or the TriangleMesh, wherever both lie by now.
    pairs : array (M, 2) of whole numbers, or Contacts
        Contacts come with their shifts. For walls MeshContacts or BoxContacts, or structured
        arrays (M,) of their records, for example some of them.
    quantities : name or names of 'gap', 'normal', 'point', 'distance', 'vector'
        A normal is the unit vector from i to j, 0 where centers coincide; a point of contact is
        the middle of the overlap, beside element i; vectors go from center to center. All are in
        the unit of the positions. Of contacts with walls the normal, the distance and the vector go
        from the center to the point, which is the nearest of the feature or the box.
    shifts : array (M, 3) of whole numbers
        Image shift of each pair; a periodic domain needs them.
    domain : Domain
        Open space by default.
    threads, max_bytes, simd, progress
        As in `contacts`.

    Returns
    -------
    PairGeometry

    Raises
    ------
    InputError, InputTypeError
        Elements that are not valid, tables of a wrong shape or type.
    UsageError
        A pair or contact names an element, a box or a feature that is not there; shifts are
        missing, or not 0 on an axis that is not periodic.

    Examples
    --------
    >>> import abut
    >>> discs = abut.discs([[0, 0], [3, 4]], [1, 2])
    >>> g = abut.measure(discs, [[0, 1]], ("gap", "normal", "point"))
    >>> g.gaps, g.normals, g.points
    (array([2.]), array([[0.6, 0.8]]), array([[1.2, 1.6]]))
    >>> floor = abut.TriangleMesh([[0, 0, 0], [9, 0, 0], [0, 9, 0]], [[0, 1, 2]])
    >>> spheres = abut.spheres([[1, 1, 0.25], [1, 2, 0.5]], 0.5)
    >>> walls = abut.find_mesh_contacts(spheres, floor)
    >>> abut.measure(spheres, walls.records[1:], "point", floor).points
    array([[1., 2., 0.]])
    """
    first = require_elements(elements)
    options = call_options(
        quantities=quantities, threads=threads, max_bytes=max_bytes, simd=simd, progress=progress
    )
    space = native_domain(domain)
    table, moves = _pairs_and_shifts(pairs, shifts, others)
    if table.dtype.names is None:
        second = None if others is None else require_elements(others)._native
        arrays: Arrays = _abut.measure(first._native, second, space, table, moves, options)
    else:
        arrays = arrays_of_contacts(first, others, space, table, moves, options)
    return geometry_of(arrays, first.dimensions)

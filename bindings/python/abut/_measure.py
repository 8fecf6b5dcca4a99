"""Quantities of pairs: gaps, normals, points of contact, distances and vectors."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _abut
from ._arrays import whole_numbers
from ._domain import Domain, native_domain
from ._elements import Elements, require_elements
from ._errors import InputError
from ._options import QuantityNames, call_options
from ._progress import Progress

QUANTITIES = ("gap", "normal", "point", "distance", "vector")
#: Quantities that are points or vectors, with a number for each coordinate.
_VECTORS = ("normal", "point", "vector")


@dataclass(frozen=True)
class PairGeometry:
    """Quantities of pairs, in the order of the pairs; None where they were not asked for.

    Element i is the first of a pair, element j the second one, moved by its image shift. The bits
    are those of C++, on every machine and with any number of threads.
    """

    gaps: npt.NDArray[np.float64] | None = None  #: Distance - (r_i + r_j), (M,).
    normals: npt.NDArray[np.float64] | None = None  #: Unit vectors from i to j, (M, dimensions).
    points: npt.NDArray[np.float64] | None = None  #: Middles of the overlaps, (M, dimensions).
    distances: npt.NDArray[np.float64] | None = None  #: Distances of the centers, (M,).
    vectors: npt.NDArray[np.float64] | None = None  #: From center to center, (M, dimensions).


def shaped(name: str, array: npt.NDArray[np.float64], dimensions: int) -> npt.NDArray[np.float64]:
    """An array of a quantity, read-only; vectors in the plane without their third number, 0."""
    array.flags.writeable = False
    return array[:, :dimensions] if name in _VECTORS else array


def arrays_of_pairs(
    elements: Elements,
    others: Elements | None,
    domain: Domain,
    pairs: npt.NDArray[np.uint32],
    shifts: npt.NDArray[np.int32] | None,
    options: _abut.CallOptions,
) -> dict[str, npt.NDArray[np.float64]]:
    """Measures what the options say; arrays by the names of the quantities."""
    arrays = _abut.measure(
        elements._native,
        None if others is None else others._native,
        domain._native,
        pairs,
        shifts,
        options,
    )
    return {name: shaped(name, array, elements.dimensions) for name, array in arrays.items()}


def _table(given: npt.ArrayLike, dtype: type[np.generic], columns: int, what: str) -> Any:
    table = whole_numbers(given, dtype, what)
    if table.size == 0 and table.ndim == 1:
        table = table.reshape(0, columns)
    if table.ndim != 2 or table.shape[1] != columns:
        raise InputError(f"{what} have the shape (M, {columns}), not {table.shape}")
    return table


def _pairs_and_shifts(pairs: npt.ArrayLike, shifts: npt.ArrayLike | None) -> tuple[Any, Any]:
    table = _table(pairs, np.uint32, 2, "pairs")
    if shifts is None:
        return table, None
    moves = _table(shifts, np.int32, 3, "image shifts")
    if len(moves) != len(table):
        raise InputError(f"{len(moves)} image shifts for {len(table)} pairs; give one for each")
    return table, moves


def _geometry(arrays: dict[str, npt.NDArray[np.float64]], dimensions: int) -> PairGeometry:
    return PairGeometry(
        **{f"{name}s": shaped(name, array, dimensions) for name, array in arrays.items()}
    )


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
        return _geometry(self._native.measure(table, moves, options), self._dimensions)


def measure(
    elements: Elements,
    pairs: npt.ArrayLike,
    quantities: QuantityNames,
    others: Elements | None = None,
    *,
    shifts: npt.ArrayLike | None = None,
    domain: Domain | None = None,
    threads: int | None = None,
    max_bytes: int | None = None,
    simd: str = "auto",
    progress: Progress | None = None,
) -> PairGeometry:
    """Measures quantities of any pairs, whether they touch or not.

    Parameters
    ----------
    elements, others : Elements
        With two sets, pairs name an element of the first and one of the second.
    pairs : array (M, 2) of whole numbers
    quantities : name or names of 'gap', 'normal', 'point', 'distance', 'vector'
        A normal is the unit vector from i to j, 0 where centers coincide; a point of contact is
        the middle of the overlap, beside element i; vectors go from center to center. All are in
        the unit of the positions.
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
        A pair names an element that is not there; shifts are missing, or not 0 on an axis that is
        not periodic.

    Examples
    --------
    >>> import abut
    >>> discs = abut.discs([[0, 0], [3, 4]], [1, 2])
    >>> g = abut.measure(discs, [[0, 1]], ("gap", "normal", "point"))
    >>> g.gaps, g.normals, g.points
    (array([2.]), array([[0.6, 0.8]]), array([[1.2, 1.6]]))
    """
    first = require_elements(elements)
    table, moves = _pairs_and_shifts(pairs, shifts)
    arrays = _abut.measure(
        first._native,
        None if others is None else require_elements(others)._native,
        native_domain(domain),
        table,
        moves,
        call_options(
            quantities=quantities,
            threads=threads,
            max_bytes=max_bytes,
            simd=simd,
            progress=progress,
        ),
    )
    return _geometry(arrays, first.dimensions)

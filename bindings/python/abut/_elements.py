"""Elements: spheres, discs, boxes, rectangles and points in arrays of the caller."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from . import _abut
from ._arrays import Coordinates, Numbers, coordinates, number, of_one_type, radii, radius_column
from ._errors import InputError, InputTypeError, UsageError


class Elements:
    """Elements in arrays of the caller, which are kept alive and, where possible, not copied.

    Made by `spheres`, `discs`, `boxes`, `rectangles` and `points`. The arrays must not change
    while a detection runs.
    """

    __slots__ = ("_first", "_kind", "_native", "_second")

    def __init__(self, kind: str, first: Coordinates, second: Any, native: _abut.Elements) -> None:
        self._kind = kind
        self._first = first
        self._second = second
        self._native = native

    def __len__(self) -> int:
        return len(self._native)

    @property
    def dimensions(self) -> int:
        """Number of dimensions, 2 or 3."""
        return self._native.dimensions

    @property
    def shape(self) -> str:
        """'sphere', 'disc', 'box' or 'rectangle'."""
        return self._native.shape

    @property
    def precision(self) -> str:
        """'float32' or 'float64': the type of the arrays."""
        return self._native.precision

    @property
    def positions(self) -> npt.NDArray[np.floating[Any]]:
        """Centers (N, dimensions), of boxes the middles between their corners. A read-only view of
        the caller's array where that is a table."""
        table = _table_of(self._first)
        if self._kind == "boxes":
            table = table + (_table_of(self._second) - table) / 2
        return _read_only(table)

    @property
    def lower(self) -> npt.NDArray[np.floating[Any]]:
        """Lower corners of boxes, (N, dimensions), read-only."""
        return self._corners(self._first)

    @property
    def upper(self) -> npt.NDArray[np.floating[Any]]:
        """Upper corners of boxes, (N, dimensions), read-only."""
        return self._corners(self._second)

    def _corners(self, corners: Any) -> npt.NDArray[np.floating[Any]]:
        if self._kind != "boxes":
            raise UsageError(f"{self.shape}s have positions and radii, not corners")
        return _read_only(_table_of(corners))

    @property
    def radii(self) -> npt.NDArray[np.floating[Any]]:
        """Radius of each sphere or disc, (N,), read-only; 0 for boxes."""
        second = 0.0 if self._kind == "boxes" else self._second
        return np.broadcast_to(np.asarray(second), (len(self),))

    def __repr__(self) -> str:
        plural = {"box": "boxes"}.get(self.shape, self.shape + "s")
        return f"<abut.Elements: {len(self):,} {plural} in {self.precision}>"

    def __reduce__(self) -> Any:
        return _made, (self._kind, self._first, self._second)


def _made(kind: str, first: Any, second: Any) -> Elements:
    return _spheres(first, second) if kind == "spheres" else _boxes(first, second)


def _table_of(given: Coordinates) -> Numbers:
    return np.stack(given, axis=1) if isinstance(given, tuple) else given


def _read_only(table: Numbers) -> Numbers:
    view = table.view()
    view.flags.writeable = False
    return view


def _size(given: Coordinates) -> int:
    return len(given[0]) if isinstance(given, tuple) else len(given)


def _dimensions(given: Coordinates) -> int:
    return len(given) if isinstance(given, tuple) else int(given.shape[1])


def _alike(first: Coordinates, *others: Any) -> tuple[Any, ...]:
    """Arrays and tuples of arrays, all of one type of numbers."""
    groups = [given if isinstance(given, tuple) else (given,) for given in (first, *others)]
    arrays = of_one_type(*(array for group in groups for array in group))
    result, place = [], 0
    for given, group in zip((first, *others), groups, strict=True):
        part = arrays[place : place + len(group)]
        result.append(part if isinstance(given, tuple) else part[0])
        place += len(group)
    return tuple(result)


def _spheres(centers: Coordinates, radius: Numbers | float) -> Elements:
    if isinstance(radius, float):
        return Elements("spheres", centers, radius, _abut.spheres(centers, radius))
    if isinstance(centers, tuple) or centers.dtype != radius.dtype:
        centers, radius = _alike(centers, radius)
    return Elements("spheres", centers, radius, _abut.spheres_with_radii(centers, radius))


def _boxes(lower: Coordinates, upper: Coordinates) -> Elements:
    lower, upper = _alike(lower, upper)
    return Elements("boxes", lower, upper, _abut.boxes(lower, upper))


def round_elements(x: Any, r: Any) -> Elements:
    """Spheres or discs, by the number of coordinates; `x` may be a table with radii."""
    plain = _abut.plain_spheres(np.ndarray, x, r)
    if plain is not None:
        return Elements("spheres", x, r, plain)
    if r is None:
        r = radius_column(x)
        if r is None:
            raise InputTypeError(
                "radii are missing: give an array with one for each element, or one number for all"
            )
    centers = coordinates(x)
    return _spheres(centers, radii(r, _size(centers)))


def _of_dimensions(elements: Elements, dimensions: int, name: str, other: str) -> Elements:
    if elements.dimensions != dimensions:
        raise InputError(
            f"{name} have {dimensions} coordinates, not {elements.dimensions}; see {other}"
        )
    return elements


def spheres(centers: Any, radius: Any = None) -> Elements:
    """Spheres in three dimensions.

    Parameters
    ----------
    centers : array (N, 3), tuple of 3 arrays (N,), list of points, or table with columns x, y, z
        Positions of the centers.
    radius : array (N,) or number
        Radii, at least 0, in the unit of the positions. If it is left out, `centers` is a table
        with a column `radius` or `r`.

    Examples
    --------
    >>> import abut
    >>> abut.spheres([[0, 0, 0], [1, 0, 0]], 0.5)
    <abut.Elements: 2 spheres in float64>
    """
    return _of_dimensions(round_elements(centers, radius), 3, "spheres", "discs")


def discs(centers: Any, radius: Any = None) -> Elements:
    """Discs in the plane: what `spheres` makes, with positions of two coordinates.

    >>> import abut
    >>> abut.discs(([0.0, 1.0], [0.0, 0.0]), 0.5)
    <abut.Elements: 2 discs in float64>
    """
    return _of_dimensions(round_elements(centers, radius), 2, "discs", "spheres")


def points(positions: Any) -> Elements:
    """Points in two or three dimensions: spheres or discs of radius 0.

    >>> import abut
    >>> len(abut.points([[0, 0, 0], [1, 0, 0]]))
    2
    """
    return _spheres(coordinates(positions), 0.0)


def _corners(lower: Any, upper: Any) -> Elements:
    first, second = coordinates(lower, "lower corners"), coordinates(upper, "upper corners")
    if _size(first) != _size(second) or _dimensions(first) != _dimensions(second):
        raise InputError(
            f"{_size(first)} lower corners of {_dimensions(first)} coordinates and "
            f"{_size(second)} upper ones of {_dimensions(second)} do not make boxes"
        )
    return _boxes(first, second)


def boxes(lower: Any, upper: Any) -> Elements:
    """Closed axis-aligned boxes in three dimensions, by their lower and upper corners.

    >>> import abut
    >>> abut.boxes([[0, 0, 0]], [[1, 1, 1]])
    <abut.Elements: 1 boxes in float64>
    """
    return _of_dimensions(_corners(lower, upper), 3, "boxes", "rectangles")


def rectangles(lower: Any, upper: Any) -> Elements:
    """Closed axis-aligned rectangles, by their lower and upper corners.

    >>> import abut
    >>> abut.rectangles([[0, 0]], [[1, 1]]).dimensions
    2
    """
    return _of_dimensions(_corners(lower, upper), 2, "rectangles", "boxes")


def as_points(given: Any) -> Elements:
    """Points, unless elements are given."""
    return given if isinstance(given, Elements) else points(given)


def require_elements(given: Any) -> Elements:
    """The elements given, or an error that says how to make them."""
    if isinstance(given, Elements):
        return given
    raise InputTypeError(
        "elements are made by spheres, discs, boxes, rectangles or points; "
        f"{type(given).__name__} was given"
    )


def positions_of(elements: Elements) -> tuple[Numbers, ...]:
    """Columns of the centers; of boxes those of the lower corners."""
    first = elements._first
    if isinstance(first, tuple):
        return first
    return tuple(first[:, axis] for axis in range(first.shape[1]))


def radii_of(elements: Elements) -> Numbers:
    """Radius of each element; 0 for boxes."""
    if elements._kind != "spheres":
        return np.zeros(len(elements))
    return np.broadcast_to(np.asarray(elements._second), (len(elements),))

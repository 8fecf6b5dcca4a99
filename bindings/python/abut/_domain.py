"""The space that elements live in."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _abut
from ._arrays import number, numbers
from ._errors import InputError, InputTypeError, UsageError


class Domain:
    """The space that elements live in: open, or periodic along up to three lattice vectors.

    A domain has no origin: elements may lie anywhere, also many cells outside; only the vectors
    count. Lengths are in the unit of the positions. Use `Domain.open`, `Domain.periodic`,
    `Domain.lattice` and `Domain.lees_edwards` to make one.

    >>> import abut
    >>> abut.Domain.periodic((10, 10, None))
    Domain.lattice([[10.0, 0.0, 0.0], [0.0, 10.0, 0.0], [0.0, 0.0, 0.0]], periodic='xy')
    """

    __slots__ = ("_native",)

    def __init__(self, native: _abut.Domain) -> None:
        if not isinstance(native, _abut.Domain):
            raise InputTypeError(
                "a domain is made by Domain.open, Domain.periodic, Domain.lattice or "
                "Domain.lees_edwards"
            )
        self._native = native

    @staticmethod
    def open() -> Domain:
        """A domain that is unbounded on every axis."""
        return Domain(_abut.Domain.open())

    @staticmethod
    def periodic(lengths: Sequence[float | None] | npt.ArrayLike) -> Domain:
        """A periodic rectangle or block.

        Parameters
        ----------
        lengths : 2 or 3 numbers > 0
            None or infinity for an axis that is not periodic.
        """
        return Domain(_abut.Domain.of_lengths(*_lengths(lengths)))

    @staticmethod
    def lattice(vectors: npt.ArrayLike, periodic: Any = None) -> Domain:
        """A lattice of independent vectors in any order and orientation, however skewed.

        Parameters
        ----------
        vectors : array (2, 2) or (3, 3)
            A vector in each row.
        periodic : text such as 'xy', or a truth value for each vector
            Vectors that count, x for the first; all by default.
        """
        table = numbers(vectors, "lattice vectors")
        if table.shape not in ((2, 2), (3, 3)):
            raise InputError(f"lattice vectors have the shape (2, 2) or (3, 3), not {table.shape}")
        dimensions = len(table)
        axes = _axes(periodic, dimensions)
        padded = np.zeros((3, 3))
        padded[:dimensions, :dimensions] = table
        # What stands in rows that do not count is never read, so it need not be a number.
        padded[~np.array(axes)] = 0.0
        return Domain(_abut.Domain.of_vectors(dimensions, padded.tolist(), axes))

    @staticmethod
    def lees_edwards(lengths: Sequence[float | None] | npt.ArrayLike, shift: float) -> Domain:
        """A domain under Lees-Edwards shear at one instant.

        The image across y is moved by `shift` along x, which is taken as given and never wrapped,
        so that image shifts stay continuous through time.
        """
        return Domain(_abut.Domain.of_shear(*_lengths(lengths), number(shift, "the shift")))

    @property
    def dimensions(self) -> int:
        """Number of dimensions, 2 or 3; 0 for an open domain, which fits both."""
        return self._native.dimensions

    @property
    def is_periodic(self) -> bool:
        """True if some axis is periodic."""
        return self._native.is_periodic

    @property
    def periodic_axes(self) -> str:
        """Axes that are periodic, such as 'xy'; '' for an open domain."""
        return "".join(
            name for name, used in zip("xyz", self._native.periodic_axes, strict=True) if used
        )

    @property
    def vectors(self) -> npt.NDArray[np.float64]:
        """Lattice vectors, a row of three numbers each; zeros for axes that are not periodic."""
        return np.array(self._native.vectors)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Domain) and self._native == other._native

    def __hash__(self) -> int:
        return hash((self.dimensions, self.periodic_axes, self.vectors.tobytes()))

    def __repr__(self) -> str:
        if not self.is_periodic:
            return "Domain.open()"
        dimensions = self.dimensions
        vectors = self.vectors[:dimensions, :dimensions].tolist()
        return f"Domain.lattice({vectors}, periodic={self.periodic_axes!r})"

    def __reduce__(self) -> Any:
        dimensions = self.dimensions
        vectors = self.vectors[:dimensions, :dimensions]
        return _restored, (dimensions, vectors, self.periodic_axes)


def _restored(dimensions: int, vectors: npt.NDArray[np.float64], axes: str) -> Domain:
    if dimensions == 0:
        return Domain.open()
    if not axes:
        return Domain.periodic([None] * dimensions)
    return Domain.lattice(vectors, axes)


def _lengths(given: Any) -> tuple[int, list[float]]:
    if isinstance(given, (str, Domain)) or not hasattr(given, "__len__"):
        raise InputTypeError(f"lengths are 2 or 3 numbers, not {given!r}")
    if len(given) not in (2, 3):
        raise InputError(f"lengths are 2 or 3 numbers, not {len(given)}")
    lengths = [np.inf if one is None else number(one, "a length") for one in given]
    return len(lengths), [*lengths, 0.0][:3]


def _axes(given: Any, dimensions: int) -> list[bool]:
    names = "xyz"[:dimensions]
    if given is None:
        return [True] * dimensions + [False] * (3 - dimensions)
    if isinstance(given, str):
        if not set(given) <= set(names):
            raise UsageError(f"periodic names axes among '{names}', not '{given}'")
        return [name in given for name in "xyz"]
    axes = [bool(one) for one in np.broadcast_to(np.asarray(given), (dimensions,))]
    return [*axes, False][:3]


OPEN = Domain.open()


def native_domain(given: Any) -> _abut.Domain:
    """The domain for the compiled module; None is an open one."""
    if given is None:
        return OPEN._native
    if isinstance(given, Domain):
        return given._native
    raise InputTypeError(
        "a domain is made by Domain.periodic, Domain.lattice or Domain.lees_edwards; "
        f"{given!r} was given"
    )

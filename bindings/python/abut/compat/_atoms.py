"""Neighbors of atoms within cutoffs, as ASE and matscipy have them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import numpy.typing as npt

from .._domain import Domain
from .._elements import points, spheres
from .._errors import InputError
from .._neighbors import NeighborList, build_neighbor_list, neighbors

#: Quantities by the letters that other packages have for them.
QUANTITIES = {"d": "distance", "D": "vector"}


@dataclass(frozen=True)
class Neighbors:
    """Neighbors of all atoms, in the order of i, then j, then S."""

    i: npt.NDArray[Any]
    j: npt.NDArray[Any]
    S: npt.NDArray[np.int32] | None
    d: npt.NDArray[np.float64] | None
    D: npt.NDArray[np.float64] | None

    def chosen(self, which: npt.NDArray[Any]) -> Neighbors:
        """Those at the places `which`."""
        arrays = (None if one is None else one[which] for one in (self.S, self.d, self.D))
        return Neighbors(self.i[which], self.j[which], *arrays)

    def quantity(self, letter: str, dtypes: Mapping[str, Any]) -> npt.NDArray[Any]:
        """The array of a letter, in the type that the other package has."""
        if letter not in dtypes:
            raise InputError(f"quantity {letter!r} is not there; there are {', '.join(dtypes)}")
        return np.ascontiguousarray(getattr(self, letter), dtype=dtypes[letter])


def domain_of(cell: Any, pbc: Any) -> Domain:
    """The domain of a cell; what is not periodic is open, whatever its vector."""
    axes = [bool(one) for one in np.broadcast_to(np.asarray(pbc), (3,))]
    return Domain.lattice(np.asarray(cell, dtype=np.float64), axes) if any(axes) else Domain.open()


@dataclass(frozen=True)
class Request:
    """What is asked of a search."""

    domain: Domain
    quantities: str  #: Letters of the arrays wanted.
    index: npt.DTypeLike  #: Type of i and j.
    itself: bool = False  #: Whether each atom is a neighbor of itself.


def found(
    positions: Any, cutoff: Any, request: Request, numbers: npt.NDArray[Any] | None
) -> Neighbors:
    """All neighbors, each pair in both directions, within a cutoff of any form."""
    x = np.asarray(positions, dtype=np.float64).reshape(-1, 3)
    if isinstance(cutoff, Mapping) and numbers is not None:
        # Several lists are put into one order, for which their shifts are needed.
        wanted = replace(request, quantities=request.quantities + "S")
        return _within_cutoffs_of_kinds(x, cutoff, wanted, numbers)
    if isinstance(cutoff, Mapping):
        cutoff = max(cutoff.values())
    return _within(x, cutoff, request)


def _within(x: Any, cutoff: Any, request: Request) -> Neighbors:
    options: Any = {
        "kind": "full",
        "domain": request.domain,
        "shifts": "S" in request.quantities or request.itself,
        "quantities": [name for letter, name in QUANTITIES.items() if letter in request.quantities],
    }
    reach = np.asarray(cutoff, dtype=np.float64)
    if reach.ndim == 0:
        built = neighbors(points(x), float(reach), **options)
    else:
        built = build_neighbor_list(spheres(x, reach), **options)
    result = _of_list(built, request)
    is_wide = np.broadcast_to(reach, (len(x),)) > 0
    return _with_itself(result, is_wide) if request.itself else result


def _of_list(built: NeighborList, request: Request) -> Neighbors:
    return Neighbors(
        built.elements_as(request.index),
        built.neighbors.astype(request.index),
        built.shifts if "S" in request.quantities or request.itself else None,
        built.distances if "d" in request.quantities else None,
        built.vectors if "D" in request.quantities else None,
    )


def _with_itself(result: Neighbors, which: npt.NDArray[np.bool_]) -> Neighbors:
    """Adds each of these atoms as a neighbor of itself, at distance 0."""
    atoms = np.flatnonzero(which).astype(result.i.dtype)
    zeros = np.zeros((len(atoms), 3))
    added = Neighbors(
        atoms,
        atoms,
        zeros.astype(np.int32),
        None if result.d is None else zeros[:, 0],
        None if result.D is None else zeros,
    )
    return _joined([result, added])


def _joined(parts: list[Neighbors]) -> Neighbors:
    def all_of(letter: str) -> Any:
        arrays = [getattr(part, letter) for part in parts]
        return None if arrays[0] is None else np.concatenate(arrays)

    both = Neighbors(*(all_of(letter) for letter in "ijSdD"))
    assert both.S is not None
    return both.chosen(np.lexsort((*both.S.T[::-1], both.j, both.i)))


def _within_cutoffs_of_kinds(
    x: Any, cutoffs: Mapping[Any, float], request: Request, numbers: npt.NDArray[Any]
) -> Neighbors:
    """One search for each length, so that each is compared exactly."""
    by_kinds = {
        frozenset(map(_number_of(), kinds)): float(cutoff) for kinds, cutoff in cutoffs.items()
    }
    parts = []
    for cutoff in sorted(set(by_kinds.values())):
        part = _within(x, cutoff, request)
        wanted = np.zeros(len(part.i), dtype=bool)
        for kinds, own in by_kinds.items():
            if own == cutoff:
                a, b = min(kinds), max(kinds)
                first, second = numbers[part.i], numbers[part.j]
                wanted |= ((first == a) & (second == b)) | ((first == b) & (second == a))
        parts.append(part.chosen(np.flatnonzero(wanted)))
    if not parts:
        return _within(x[:0], 1.0, replace(request, domain=Domain.open(), itself=False))
    return _joined(parts)


def _number_of() -> Callable[[Any], int]:
    def number(kind: Any) -> int:
        if isinstance(kind, str):
            from ase.data import atomic_numbers

            return int(atomic_numbers[kind])
        return int(kind)

    return number


def answer(result: Neighbors, quantities: str, dtypes: Mapping[str, Any]) -> Any:
    """An array for one letter, a tuple of arrays for several."""
    arrays = tuple(result.quantity(letter, dtypes) for letter in quantities)
    return arrays[0] if len(arrays) == 1 else arrays

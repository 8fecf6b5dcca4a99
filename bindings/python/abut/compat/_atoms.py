"""Neighbors of atoms within cutoffs, as ASE and matscipy have them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
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

    i: npt.NDArray[np.int64]
    j: npt.NDArray[np.int64]
    S: npt.NDArray[np.int32]
    d: npt.NDArray[np.float64] | None
    D: npt.NDArray[np.float64] | None

    def chosen(self, which: npt.NDArray[Any]) -> Neighbors:
        """Those at the places `which`."""
        d = None if self.d is None else self.d[which]
        D = None if self.D is None else self.D[which]
        return Neighbors(self.i[which], self.j[which], self.S[which], d, D)

    def quantity(self, letter: str, dtypes: Mapping[str, Any]) -> npt.NDArray[Any]:
        """The array of a letter, in the type that the other package has."""
        if letter not in dtypes:
            raise InputError(f"quantity {letter!r} is not there; there are {', '.join(dtypes)}")
        return np.ascontiguousarray(getattr(self, letter), dtype=dtypes[letter])


def domain_of(cell: Any, pbc: Any) -> Domain:
    """The domain of a cell; what is not periodic is open, whatever its vector."""
    axes = [bool(one) for one in np.broadcast_to(np.asarray(pbc), (3,))]
    return Domain.lattice(np.asarray(cell, dtype=np.float64), axes) if any(axes) else Domain.open()


def found(
    positions: Any,
    cutoff: Any,
    domain: Domain,
    quantities: str,
    numbers: npt.NDArray[Any] | None,
    self_interaction: bool,
) -> Neighbors:
    """All neighbors, each pair in both directions, within a cutoff of any form."""
    x = np.asarray(positions, dtype=np.float64).reshape(-1, 3)
    if isinstance(cutoff, Mapping) and numbers is not None:
        return _within_cutoffs_of_kinds(x, cutoff, domain, quantities, numbers, self_interaction)
    if isinstance(cutoff, Mapping):
        cutoff = max(cutoff.values())
    return _within(x, cutoff, domain, quantities, self_interaction)


def _within(x: Any, cutoff: Any, domain: Domain, quantities: str, itself: bool) -> Neighbors:
    options: Any = {
        "kind": "full",
        "domain": domain,
        "shifts": True,
        "quantities": [name for letter, name in QUANTITIES.items() if letter in quantities],
    }
    reach = np.asarray(cutoff, dtype=np.float64)
    if reach.ndim == 0:
        built = neighbors(points(x), float(reach), **options)
    else:
        built = build_neighbor_list(spheres(x, reach), **options)
    result = _of_list(built, quantities)
    return _with_itself(result, np.broadcast_to(reach, (len(x),)) > 0) if itself else result


def _of_list(built: NeighborList, quantities: str) -> Neighbors:
    return Neighbors(
        built.elements,
        built.neighbors.astype(np.int64),
        built.shifts,
        built.distances if "d" in quantities else None,
        built.vectors if "D" in quantities else None,
    )


def _with_itself(result: Neighbors, which: npt.NDArray[np.bool_]) -> Neighbors:
    """Adds each of these atoms as a neighbor of itself, at distance 0."""
    atoms = np.flatnonzero(which)
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
    order = np.lexsort((both.S[:, 2], both.S[:, 1], both.S[:, 0], both.j, both.i))
    return both.chosen(order)


def _within_cutoffs_of_kinds(
    x: Any,
    cutoffs: Mapping[Any, float],
    domain: Domain,
    quantities: str,
    numbers: npt.NDArray[Any],
    itself: bool,
) -> Neighbors:
    """One search for each length, so that each is compared exactly."""
    by_kinds = {
        frozenset(map(_number_of(), kinds)): float(cutoff) for kinds, cutoff in cutoffs.items()
    }
    parts = []
    for cutoff in sorted(set(by_kinds.values())):
        part = _within(x, cutoff, domain, quantities, itself)
        wanted = np.zeros(len(part.i), dtype=bool)
        for kinds, own in by_kinds.items():
            if own == cutoff:
                a, b = min(kinds), max(kinds)
                first, second = numbers[part.i], numbers[part.j]
                wanted |= ((first == a) & (second == b)) | ((first == b) & (second == a))
        parts.append(part.chosen(np.flatnonzero(wanted)))
    if not parts:
        return _within(x[:0], 1.0, Domain.open(), quantities, False)
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

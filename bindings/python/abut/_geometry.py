"""Quantities of pairs and contacts: their arrays, and when they are measured."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

QUANTITIES = ("gap", "normal", "point", "distance", "vector")
#: Quantities that are points or vectors, with a number for each coordinate.
_VECTORS = ("normal", "point", "vector")

#: Arrays by the names of their quantities.
Arrays = Mapping[str, npt.NDArray[np.float64]]


@dataclass(frozen=True)
class PairGeometry:
    """Quantities of pairs or contacts, in their order; None where they were not asked for.

    Element i is the first of a pair, element j the second one, moved by its image shift. Of a
    contact with a wall the sphere is element i and the wall element j: distances and vectors go
    from the center to the nearest point of the wall, which is the point of contact. The bits are
    those of C++, on every machine and with any number of threads.
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


def all_shaped(arrays: Arrays, dimensions: int) -> dict[str, npt.NDArray[np.float64]]:
    """Arrays of quantities, read-only, by the names of the quantities."""
    return {name: shaped(name, array, dimensions) for name, array in arrays.items()}


def geometry_of(arrays: Arrays, dimensions: int) -> PairGeometry:
    """The arrays under the names that they have in C++."""
    return PairGeometry(
        **{f"{name}s": array for name, array in all_shaped(arrays, dimensions).items()}
    )


class Measured:
    """What has quantities that are measured when they are first asked for, and then kept."""

    _results: Any  #: What the module found, or None.
    _measured: dict[str, npt.NDArray[np.float64]]

    def __len__(self) -> int:
        raise NotImplementedError

    @property
    def _dimensions(self) -> int:
        raise NotImplementedError

    def _measure_now(self, names: list[str]) -> Arrays:
        raise NotImplementedError

    def measure(self, *quantities: str) -> tuple[npt.NDArray[np.float64], ...]:
        """Measures quantities, those together that are not known yet: cheaper than one by one.

        Parameters
        ----------
        *quantities : 'gap', 'normal', 'point', 'distance', 'vector'

        >>> import abut
        >>> gap, normal = abut.contacts([[0, 0], [0, 1]], 0.75).measure("gap", "normal")
        >>> gap, normal
        (array([-0.5]), array([[0., 1.]]))
        """
        known = self._measured
        wanted = [name for name in quantities if name not in known]
        if wanted:
            known.update(self._stored(wanted))
            wanted = [name for name in wanted if name not in known]
        if wanted:
            known.update(all_shaped(self._measure_now(wanted), self._dimensions))
        return tuple(known[name] for name in quantities)

    def _stored(self, names: tuple[str, ...] | list[str]) -> dict[str, npt.NDArray[np.float64]]:
        """Those of the quantities that the detection has left with its list."""
        if self._results is None:
            return {}
        arrays = {name: getattr(self._results, f"{name}s", np.empty(0)) for name in names}
        return all_shaped(
            {name: array for name, array in arrays.items() if 0 < len(self) == len(array)},
            self._dimensions,
        )

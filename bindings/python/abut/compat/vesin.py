"""`NeighborList` as `vesin` has it. The cutoff is included."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

from .._arrays import numbers
from .._detector import Detector
from .._elements import points as points_at
from .._errors import InputError, UsageError
from ._atoms import QUANTITIES, domain_of


class NeighborList:
    """A calculator of neighbor lists, which keeps its memory from call to call.

    Parameters
    ----------
    cutoff : float
    full_list : bool
        Whether each pair comes twice, as i-j and j-i.
    sorted : bool
        Pairs are always in the order of i, then j, then the shift.
    algorithm : str
        Has no meaning here.
    skin : float
        Pairs that are nearer than cutoff + skin are kept and serve while points move little.
    n_threads : int
        Number of threads; 0 for OpenMP's default.
    """

    def __init__(
        self,
        *,
        cutoff: float,
        full_list: bool,
        sorted: bool = False,
        algorithm: str = "auto",
        skin: float = 0.0,
        n_threads: int = 0,
    ) -> None:
        if algorithm.lower() not in ("auto", "brute_force", "cell_list"):
            raise UsageError(f"there is no algorithm '{algorithm}'")
        self.cutoff = float(cutoff)
        self.full_list = bool(full_list)
        self.sorted = bool(sorted)
        self.algorithm = algorithm.lower()
        self.skin = float(skin)
        self.n_threads = int(n_threads)
        self._detector = Detector(skin=self.skin or None, threads=self.n_threads)

    def compute(
        self,
        points: npt.ArrayLike,
        box: npt.ArrayLike,
        periodic: Any,
        quantities: str = "ij",
        copy: bool = True,
    ) -> tuple[npt.NDArray[Any], ...]:
        """Lists the neighbors of points in a box.

        Parameters
        ----------
        points : array (N, 3)
        box : array (3, 3)
        periodic : bool or three of them
        quantities : str
            Letters of the arrays wanted: i and j, indices; P, both, (M, 2); S, shift; d, distance;
            D, vector from i to j.
        copy : bool
            Arrays stay as they are in either case.

        >>> import numpy as np
        >>> calculator = NeighborList(cutoff=1.0, full_list=False)
        >>> calculator.compute([[0.0, 0, 0], [1, 0, 0]], np.eye(3), False, "Pd")
        (array([[0, 1]], dtype=uint64), array([1.]))
        """
        x = numbers(points, "points")
        if np.shape(box) != (3, 3):
            raise InputError(f"the box has the shape (3, 3), not {np.shape(box)}")
        if x.ndim != 2 or x.shape[1] != 3:
            raise InputError(f"points have the shape (N, 3), not {x.shape}")
        built = self._detector.build_neighbor_list(
            points_at(x),
            kind="full" if self.full_list else "half",
            margin=self.cutoff,
            domain=domain_of(box, periodic),
            shifts="S" in quantities,
            quantities=[name for letter, name in QUANTITIES.items() if letter in quantities],
        )
        make: dict[str, Callable[[], npt.NDArray[Any]]] = {
            "i": lambda: built.elements_as(np.uint64),
            "j": lambda: built.neighbors.astype(np.uint64),
            "P": lambda: np.stack([built.elements, built.neighbors], axis=1).astype(np.uint64),
            "S": lambda: built.shifts.copy(),
            "d": lambda: built.distances.astype(x.dtype),
            "D": lambda: built.vectors.astype(x.dtype, copy=False),
        }
        unknown = set(quantities) - set(make)
        if unknown:
            raise InputError(f"unexpected letters in quantities: {''.join(sorted(unknown))}")
        return tuple(make[letter]() for letter in quantities)

"""Elements along space."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from . import _abut
from ._elements import as_points
from ._options import call_options
from ._progress import Progress


def spatial_order(
    x: Any,
    *,
    threads: int | None = None,
    max_bytes: int | None = None,
    progress: Progress | None = None,
) -> npt.NDArray[np.uint32]:
    """Numbers of the elements in an order in which neighbors in space follow each other.

    Loops over contacts run faster where all arrays are in this order: `x = x[order]`,
    `mass = mass[order]`. The order is along a Hilbert curve, whose cells are 2^-21 of the width of
    all (2D: 2^-31); it is the same on every machine. In periodic domains wrap the positions first.

    Parameters
    ----------
    x : array (N, 2) or (N, 3), tuple of columns, list of points, table, or Elements
        Positions. Boxes lie where their lower corners are.
    threads, max_bytes, progress
        Those of `contacts`.

    Returns
    -------
    array (N,) of uint32

    Raises
    ------
    InputError
        For positions that are not finite; LimitError, Cancelled as `contacts` does.

    >>> import abut
    >>> abut.spatial_order([[5.0, 0.0], [1.0, 0.0], [4.0, 0.0], [2.0, 0.0]])
    array([1, 3, 2, 0], dtype=uint32)
    """
    options = call_options(threads=threads, max_bytes=max_bytes, progress=progress)
    order: npt.NDArray[np.uint32] = _abut.spatial_order(as_points(x)._native, options)
    return order

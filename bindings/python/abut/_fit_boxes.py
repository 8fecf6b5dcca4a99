"""Boxes around the cells of a mesh."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from . import _abut
from ._arrays import number, whole_numbers
from ._elements import Elements, boxes, points, rectangles
from ._errors import InputError


_KEPT = tuple(np.dtype(kind) for kind in (np.int32, np.uint32, np.int64, np.uint64))


def cells_of(given: Any) -> npt.NDArray[Any]:
    """Vertex numbers of cells, a row for each. Numbers of 32 or 64 bits, row after row, are read
    where they are."""
    kind = next((kept for kept in _KEPT if getattr(given, "dtype", None) == kept), _KEPT[2])
    cells = whole_numbers(given, kind.type, "vertex numbers of cells")
    if cells.ndim != 2 or cells.shape[1] not in (1, 2, 3, 4, 6, 8):
        raise InputError(f"cells have a row of vertex numbers each, not the shape {cells.shape}")
    return cells


def fit_boxes(vertices: Any, cells: npt.ArrayLike, skin: float = 0.0) -> Elements:
    """Computes the smallest box around the vertices of each cell of a mesh.

    Parameters
    ----------
    vertices : array (V, 2) or (V, 3), or what else positions may be
    cells : array (N, K) of whole numbers
        Numbers of the vertices of each cell: segments, triangles, tetrahedra, ...
    skin : float
        The boxes are wider by so much on every side, and rounded outwards.

    >>> import abut
    >>> abut.fit_boxes([[0, 0, 0], [1, 0, 0], [0, 2, 0]], [[0, 1, 2]])
    <abut.Elements: 1 boxes in float64>
    """
    places = points(vertices)
    columns = _abut.fit_boxes(places._native, cells_of(cells), number(skin, "the skin"))
    dimensions = places.dimensions
    made = boxes if dimensions == 3 else rectangles
    return made(tuple(columns[:dimensions]), tuple(columns[dimensions:]))

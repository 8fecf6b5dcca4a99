"""What `scipy.spatial.KDTree` answers within a distance, as functions of the data.

The distance is included, exactly. Positions have two or three coordinates.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from .._arrays import number
from .._elements import points, round_elements
from .._errors import UsageError
from .._neighbors import NeighborList, build_neighbor_list, neighbors


def query_pairs(data: Any, r: float, output_type: str = "set") -> Any:
    """Finds all pairs i < j of points within distance r, as `KDTree(data).query_pairs(r)`.

    Parameters
    ----------
    data : array (N, 2) or (N, 3)
    r : float
    output_type : 'set' or 'ndarray'
        A set of tuples, or an array (M, 2) in ascending order.

    >>> query_pairs([[0, 0], [1, 0], [3, 0]], 1.0)
    {(0, 1)}
    """
    _require(output_type, ("set", "ndarray"))
    built = neighbors(data, number(r, "r"))
    pairs = np.stack([built.elements, built.neighbors], axis=1).astype(np.intp)
    return pairs if output_type == "ndarray" else set(map(tuple, pairs.tolist()))


def query_ball_point(
    data: Any, x: Any, r: Any, return_length: bool = False, return_sorted: bool | None = None
) -> Any:
    """Finds all points of `data` within distance r of each point of `x`, as
    `KDTree(data).query_ball_point(x, r)`.

    Parameters
    ----------
    data : array (N, 2) or (N, 3)
    x : array (..., 2) or (..., 3)
    r : float or array of the shape of x without its last axis
    return_length : bool
        Whether only their numbers are returned.
    return_sorted
        Indices are always sorted.

    Returns
    -------
    An array of lists of indices, of the shape of x without its last axis; a list for one point.

    >>> query_ball_point([[0, 0], [1, 0], [3, 0]], [[0, 0], [3, 1]], [1.0, 0.5])
    array([list([0, 1]), list([])], dtype=object)
    """
    probes = np.asarray(x, dtype=np.float64)
    shape = probes.shape[:-1]
    table = probes.reshape(-1, probes.shape[-1])
    reach = np.broadcast_to(np.asarray(r, dtype=np.float64), shape).reshape(-1)
    built = build_neighbor_list(round_elements(table, reach), points(data))
    if return_length:
        lengths = np.diff(built.offsets).astype(np.intp).reshape(shape)
        return lengths if shape else int(lengths)
    lists = np.empty(len(table), dtype=object)
    lists[:] = [built[k].tolist() for k in range(len(table))]
    return lists.reshape(shape) if shape else lists[0]


def sparse_distance_matrix(
    data: Any, other: Any, max_distance: float, output_type: str = "dok_matrix"
) -> Any:
    """Computes the distances up to `max_distance` of the points of two sets, as
    `KDTree(data).sparse_distance_matrix(KDTree(other), max_distance)`.

    Parameters
    ----------
    data, other : arrays (N, 2 or 3), (M, 2 or 3)
    max_distance : float
    output_type : 'dok_matrix', 'coo_matrix', 'dict' or 'ndarray'
        The last is a structured array of i, j, v.

    >>> sparse_distance_matrix([[0, 0]], [[0, 2], [5, 5]], 3.0, output_type="dict")
    {(0, 0): 2.0}
    """
    _require(output_type, ("dok_matrix", "coo_matrix", "dict", "ndarray"))
    first, second = points(data), points(other)
    margin = number(max_distance, "max_distance")
    built = build_neighbor_list(first, second, margin=margin, quantities="distance")
    shape = (len(first), len(second))
    return _DISTANCES[output_type](built, shape)


def _records(built: NeighborList, shape: tuple[int, int]) -> npt.NDArray[Any]:
    dtype = [("i", np.intp), ("j", np.intp), ("v", np.float64)]
    records = np.empty(len(built.neighbors), dtype=dtype)
    records["i"], records["j"], records["v"] = built.elements, built.neighbors, built.distances
    return records


def _coo(built: NeighborList, shape: tuple[int, int]) -> Any:
    from scipy.sparse import coo_matrix

    return coo_matrix((built.distances, (built.elements, built.neighbors)), shape=shape)


def _dict(built: NeighborList, shape: tuple[int, int]) -> dict[tuple[int, int], float]:
    places = zip(built.elements.tolist(), built.neighbors.tolist(), strict=True)
    return dict(zip(places, built.distances.tolist(), strict=True))


_DISTANCES = {
    "dok_matrix": lambda built, shape: _coo(built, shape).todok(),
    "coo_matrix": _coo,
    "dict": _dict,
    "ndarray": _records,
}


def _require(output_type: str, known: tuple[str, ...]) -> None:
    if output_type not in known:
        raise UsageError(f"output_type is one of {', '.join(known)}, not {output_type!r}")

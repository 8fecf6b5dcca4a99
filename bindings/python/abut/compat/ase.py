"""`neighbor_list` and `primitive_neighbor_list` as `ase.neighborlist` has them.

Neighbors come in the order of i, then j, then S. The cutoff is included.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from . import _atoms

_DTYPES = {"i": np.int64, "j": np.int64, "d": np.float64, "D": np.float64, "S": np.int64}


def neighbor_list(
    quantities: str,
    a: Any,
    cutoff: Any,
    self_interaction: bool = False,
    max_nbins: float = 1e6,
) -> Any:
    """Lists the neighbors of the atoms of an `ase.Atoms`.

    Parameters
    ----------
    quantities : str
        Letters of the arrays wanted: i and j, indices of the atoms; d, distance; D, vector from i
        to j; S, number of cells between them.
    a : ase.Atoms
    cutoff : number, array (N,) or dictionary
        One for all; radii of the atoms, whose sums count; or lengths by kinds of atoms, such as
        {("C", "H"): 1.3}.
    self_interaction : bool
        Whether each atom is a neighbor of itself.
    max_nbins
        Has no meaning here.

    Returns
    -------
    An array for one letter, a tuple of arrays for several.
    """
    return primitive_neighbor_list(
        quantities, a.pbc, a.cell, a.positions, cutoff, a.numbers, self_interaction
    )


def primitive_neighbor_list(
    quantities: str,
    pbc: Any,
    cell: Any,
    positions: Any,
    cutoff: Any,
    numbers: Any = None,
    self_interaction: bool = False,
    use_scaled_positions: bool = False,
    max_nbins: float = 1e6,
) -> Any:
    """Lists the neighbors of positions in a cell; see `neighbor_list`.

    >>> import numpy as np
    >>> i, S, D = primitive_neighbor_list("iSD", [1, 0, 0], np.eye(3), [[0, 0, 0]], 1.0)
    >>> i, S[0], D[0]
    (array([0, 0]), array([-1,  0,  0]), array([-1.,  0.,  0.]))
    """
    if use_scaled_positions:
        positions = np.dot(positions, cell)
    kinds = None if numbers is None else np.asarray(numbers)
    domain = _atoms.domain_of(cell, pbc)
    request = _atoms.Request(domain, quantities, _DTYPES["i"], self_interaction)
    result = _atoms.found(positions, cutoff, request, kinds)
    return _atoms.answer(result, quantities, _DTYPES)

"""`neighbour_list` as `matscipy.neighbours` has it.

Neighbors come in the order of i, then j, then S. The cutoff is included.
"""

from __future__ import annotations

from collections import defaultdict
from typing import Any

import numpy as np

from .._errors import UsageError
from . import _atoms

_DTYPES = {"i": np.int32, "j": np.int32, "d": np.float64, "D": np.float64, "S": np.int32}


def neighbour_list(
    quantities: str,
    atoms: Any = None,
    cutoff: Any = None,
    positions: Any = None,
    cell: Any = None,
    pbc: Any = None,
    numbers: Any = None,
    cell_origin: Any = None,
) -> Any:
    """Lists the neighbors of the atoms of an `ase.Atoms`, or of positions in a cell.

    Parameters
    ----------
    quantities : str
        Letters of the arrays wanted: i and j, indices of the atoms; d, distance; D, vector from i
        to j; S, number of cells between them.
    atoms : ase.Atoms
        In place of positions, cell, pbc, numbers and cell_origin.
    cutoff : number, array (N,) or dictionary
        One for all; radii of the atoms, whose sums count; or lengths by kinds of atoms.
    positions : array (N, 3)
    cell : array (3, 3)
    pbc : three truth values; none is periodic by default
    numbers : array (N,)
        Kinds of the atoms.
    cell_origin
        Where the cell lies has no meaning to its neighbors.

    Returns
    -------
    An array for one letter, a tuple of arrays for several.

    >>> neighbour_list("ij", positions=[[0, 0, 0], [1, 0, 0]], cutoff=1.0)
    (array([0, 1], dtype=int32), array([1, 0], dtype=int32))
    """
    if cutoff is None:
        raise UsageError("a cutoff is needed")
    given = (positions, cell, pbc, numbers, cell_origin)
    if atoms is not None:
        if any(one is not None for one in given):
            raise UsageError("give either atoms, or positions, cell, pbc and numbers")
        positions, cell, pbc, numbers = atoms.positions, atoms.cell, atoms.pbc, atoms.numbers
    if positions is None:
        raise UsageError("give either atoms or positions")
    if isinstance(cutoff, defaultdict) and cutoff.default_factory is not None:
        cutoff = cutoff.default_factory()
    domain = _atoms.domain_of(cell, False if pbc is None else pbc)
    kinds = np.ones(len(positions), int) if numbers is None else np.asarray(numbers)
    request = _atoms.Request(domain, quantities, _DTYPES["i"])
    result = _atoms.found(positions, cutoff, request, kinds)
    return _atoms.answer(result, quantities, _DTYPES)

"""Segments, triangles and tetrahedra against each other."""

from __future__ import annotations

from functools import cached_property
from typing import Any, Unpack

import numpy as np
import numpy.typing as npt

from . import _abut
from ._arrays import whole_numbers
from ._domain import OPEN, Domain, native_domain
from ._elements import Elements, as_points
from ._errors import InputError, InputTypeError, UsageError
from ._fit_boxes import cells_of
from ._options import Options, call_options
from ._statistics import Statistics


class Simplices:
    """Segments, triangles or, in 3D, tetrahedra: the closed convex hulls of the vertices that each
    cell names. Vertices of a cell may coincide, lie on a line or in a plane.

    Positions, and vertex numbers of 32 or 64 bits that lie row after row, are read where they are,
    not copied; they must not change while a detection runs.

    Parameters
    ----------
    vertices : array (V, 2) or (V, 3), or what else positions may be
    cells : array (N, K) of whole numbers
        Numbers of the vertices of each cell: K is 2 for segments, 3 for triangles, 4 for
        tetrahedra, 1 for points.

    Raises
    ------
    InputError, InputTypeError
        A wrong shape or type.
    UsageError
        More vertices than a simplex has, or vertices that are boxes.

    >>> import abut
    >>> abut.Simplices([[0, 0], [1, 0], [0, 1], [1, 1]], [[0, 1, 2], [1, 2, 3]])
    <abut.Simplices: 2 cells of 3 of 4 vertices in 2 dimensions>
    """

    __slots__ = ("_cells", "_native", "_vertices")

    def __init__(self, vertices: Any, cells: npt.ArrayLike) -> None:
        self._vertices = as_points(vertices)
        self._cells = cells_of(cells)
        self._native = _abut.Simplices(self._vertices._native, self._cells)

    def __len__(self) -> int:
        return len(self._native)

    @property
    def dimensions(self) -> int:
        """Number of dimensions, 2 or 3."""
        return self._native.dimensions

    @property
    def vertices(self) -> Elements:
        """Vertices of all cells."""
        return self._vertices

    @property
    def cells(self) -> npt.NDArray[Any]:
        """Numbers (N, K) of the vertices of each cell, read-only."""
        view = self._cells.view()
        view.flags.writeable = False
        return view

    def __repr__(self) -> str:
        return (
            f"<abut.Simplices: {len(self):,} cells of {self._cells.shape[1]} of "
            f"{len(self._vertices):,} vertices in {self.dimensions} dimensions>"
        )

    def __reduce__(self) -> Any:
        return Simplices, (self._vertices, self._cells)


class SimplexContacts:
    """The pairs of simplices that have a point in common, each once.

    Arrays are read-only views of the memory that the detection filled. They may be kept: they
    outlive this object.
    """

    def __init__(
        self,
        results: _abut.PairResults,
        simplices: Simplices,
        others: Simplices | None,
        options: Options,
    ) -> None:
        self._results: _abut.PairResults | None = results
        self._simplices = simplices
        self._others = others
        self._domain = options.get("domain") or OPEN

    def __len__(self) -> int:
        return len(self.pairs)

    @cached_property
    def pairs(self) -> npt.NDArray[np.uint32]:
        """Table (M, 2) of the numbers of the two simplices of each pair."""
        return self._native().pairs

    @property
    def i(self) -> npt.NDArray[np.uint32]:
        """Number of the first simplex of each pair: a view of `pairs`."""
        return self.pairs[:, 0]

    @property
    def j(self) -> npt.NDArray[np.uint32]:
        """Number of the second simplex of each pair: a view of `pairs`."""
        return self.pairs[:, 1]

    @cached_property
    def shift(self) -> npt.NDArray[np.int32]:
        """Table (M, 3) of image shifts n: j, moved by n times the lattice vectors, touches i."""
        shifts = self._native().shifts
        if len(shifts) == len(self):
            return shifts
        if self._domain.is_periodic:
            raise UsageError("image shifts were not stored; ask for them with shifts=True")
        return np.broadcast_to(np.int32(0), (len(self), 3))

    @cached_property
    def statistics(self) -> Statistics:
        """Work and cost of the detection: `candidate_tests` pairs had boxes that touch, and
        filters left `exact_decisions` of them open."""
        return Statistics(**self._native().statistics)

    @property
    def simplices(self) -> Simplices:
        """The simplices of the only or the first set."""
        return self._simplices

    @property
    def others(self) -> Simplices | None:
        """The simplices of the second set, or None."""
        return self._others

    @property
    def domain(self) -> Domain:
        """The domain of the detection."""
        return self._domain

    def __repr__(self) -> str:
        text = f"<abut.SimplexContacts: {len(self):,} contacts of {len(self._simplices):,}"
        if self._others is not None:
            text += f" and {len(self._others):,}"
        return f"{text} simplices>"

    def _native(self) -> _abut.PairResults:
        if self._results is None:
            raise UsageError("contacts that were pickled no longer have this")
        return self._results

    def __getstate__(self) -> dict[str, Any]:
        state = {**self.__dict__, "_results": None}
        for name in ("pairs", "shift", "statistics"):
            try:
                state[name] = getattr(self, name)
            except UsageError:  # shifts that were not stored stay unknown
                continue
        return state


def _require_simplices(given: Any) -> Simplices:
    if isinstance(given, Simplices):
        return given
    raise InputTypeError(
        f"simplices are made by Simplices(vertices, cells); {type(given).__name__} was given"
    )


def find_simplex_contacts(
    simplices: Simplices,
    others: Simplices | None = None,
    *,
    shared_vertices: str = "touching",
    **options: Unpack[Options],
) -> SimplexContacts:
    """Finds the pairs of simplices, of one set or of two, that have a point in common, decided as
    with real numbers: touching counts, flat ones count as what they are, and so does one inside the
    other. How: docs/derivations/orientation.md.

    Parameters
    ----------
    simplices, others : Simplices
        With two sets, which may have cells of different kinds, i is of the first and j of the
        second.
    shared_vertices : 'touching' or 'excluded'
        Excluded: pairs that name the same vertex are none, as neighbors in a mesh are. Of two sets
        it needs the same vertices in both. Vertices of different numbers at one place differ, and
        so do a vertex and its image.
    **options
        As of `contacts`. There is no margin, and no quantities are measured. In a periodic `domain`
        each image that touches is a contact, with its `shift`.

    Returns
    -------
    SimplexContacts

    Raises
    ------
    InputError, InputTypeError
        A vertex number that is not there, a vertex of a cell that is not finite, a wrong type.
    UsageError
        A margin, quantities, sets of unequal dimensions, an algorithm that does not support
        periodic domains in one.
    LimitError
        More pairs or memory than allowed.
    KeyboardInterrupt
        Ctrl-C.

    Examples
    --------
    >>> import abut
    >>> bodies = abut.Simplices([[0, 0], [1, 0], [0, 1], [1, 1], [.5, .5], [3, 0], [3, 1]],
    ...                         [[0, 1, 2], [1, 2, 3], [4, 5, 6]])
    >>> abut.find_simplex_contacts(bodies).pairs.tolist()
    [[0, 1], [0, 2], [1, 2]]
    >>> abut.find_simplex_contacts(bodies, shared_vertices="excluded").pairs.tolist()
    [[0, 2], [1, 2]]
    """
    first = _require_simplices(simplices)
    second = None if others is None else _require_simplices(others)
    sizes = (len(first), None if second is None else len(second))
    results = _abut.find_simplex_contacts(
        first._native,
        None if second is None else second._native,
        native_domain(options.get("domain")),
        call_options(sizes, **options),
        _excludes_shared(shared_vertices),
    )
    return SimplexContacts(results, first, second, options)


def _excludes_shared(given: str) -> bool:
    if not isinstance(given, str):
        raise InputTypeError(f"shared_vertices is a name, not {given!r}")
    if given not in ("touching", "excluded"):
        raise UsageError(
            f"shared_vertices '{given}' is not there; there are 'touching' and 'excluded'"
        )
    return given == "excluded"


def touching(
    first: Simplices,
    second: Simplices,
    pairs: npt.ArrayLike,
    shifts: npt.ArrayLike | None = None,
    domain: Domain | None = None,
) -> npt.NDArray[np.bool_]:
    """Decides for pairs of simplices whether they have a point in common, as with real numbers; for
    programs that have candidates of their own.

    Parameters
    ----------
    first, second : Simplices
        The sets of i and of j; they may be the same.
    pairs : array (M, 2) of whole numbers
        i and j of each pair, which may be the same simplex.
    shifts : array (M, 3) of whole numbers
        Image shift of j of each pair, 0 on axes that are not periodic; zeros by default.
    domain : Domain
        Open space by default.

    Returns
    -------
    array (M,) of bool

    Raises
    ------
    InputError, InputTypeError
        A vertex number that is not there, a vertex that is not finite, a wrong shape or type.
    UsageError
        A simplex or an image that is not there, sets of unequal dimensions.

    Examples
    --------
    >>> import abut
    >>> grain = abut.Simplices([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 1, 2, 3]])
    >>> fibers = abut.Simplices([[-1, .25, .25], [1, .25, .25], [1, 1, 1]], [[0, 1], [1, 2]])
    >>> abut.touching(grain, fibers, [[0, 0], [0, 1]])
    array([ True, False])
    """
    a, b = _require_simplices(first), _require_simplices(second)
    table = _rows_of(pairs, np.uint32, "pairs", 2)
    moves = None if shifts is None else _rows_of(shifts, np.int32, "shifts", 3)
    if moves is not None and len(moves) != len(table):
        raise InputError(f"{len(moves)} shifts for {len(table)} pairs; give one for each")
    answers = _abut.touching(a._native, b._native, native_domain(domain), table, moves)
    return answers.view(np.bool_)


def _rows_of(
    given: npt.ArrayLike, kind: type[np.generic], what: str, width: int
) -> npt.NDArray[Any]:
    table = whole_numbers(given, kind, what)
    if table.size == 0:
        table = table.reshape(0, width)
    if table.ndim != 2 or table.shape[1] != width:
        raise InputError(f"{what} have the shape (M, {width}), not {table.shape}")
    return table

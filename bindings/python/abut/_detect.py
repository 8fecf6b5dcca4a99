"""One detection: contacts, pairs and counts."""

from __future__ import annotations

from typing import Any, Unpack

import numpy.typing as npt

from . import _abut
from ._contacts import Contacts
from ._domain import OPEN, Domain, native_domain
from ._elements import Elements, require_elements, round_elements
from ._options import Options, call_options
from ._progress import Progress
from ._rules import ExclusionList
from ._statistics import Statistics


# Options of a call that gives none: most calls are such, and small ones would notice.
_NONE: Options = {}
_NATIVE_NONE = call_options()
_AUTO, _CANONICAL = "auto", "canonical"


def contacts(
    x: Any,
    r: Any = None,
    *,
    domain: Domain | None = None,
    margin: float = 0.0,
    groups: npt.ArrayLike | None = None,
    exclude: npt.ArrayLike | ExclusionList | None = None,
    algorithm: str = _AUTO,
    order: str = _CANONICAL,
    shifts: bool | None = None,
    max_pairs: int | None = None,
    max_bytes: int | None = None,
    threads: int | None = None,
    progress: Progress | None = None,
    **others: Any,
) -> Contacts:
    """Finds which spheres (in 2D: discs) touch: all pairs with |x_i - x_j| <= r_i + r_j + margin.

    The comparison is made as with real numbers: no pair is missed, none comes twice, none is there
    by rounding. Touching counts.

    Parameters
    ----------
    x : array (N, 2) or (N, 3), tuple of columns, list of points, or table
        Positions. Arrays of float32 and float64 are read where they are, whatever their strides.
        A tuple always means columns (x, y[, z]), a list always points. A table (data frame, data
        set, mapping, structured array) has columns x, y[, z] and, if `r` is left out, radius or r.
    r : array (N,) or number
        Radii, at least 0, in the unit of the positions.
    domain : Domain
        Open space by default.
    margin : float
        Distance from touching up to which elements are contact pairs, too; at least 0.
    groups : array (N,) of whole numbers
        Elements of equal groups do not pair.
    exclude : array (K, 2) of whole numbers, or ExclusionList
        Pairs that are none.
    algorithm : str
        'auto', or a name of `algorithms`. All give the same pairs.
    order : 'canonical' or 'as_found'
        Canonical: ascending by (i, j, shift).
    shifts : bool
        Whether image shifts are stored; by default in periodic domains.
    max_pairs, max_bytes : int
        Limits on the number of pairs and on abut's own memory.
    threads : int
        Number of threads; OpenMP's default if it is left out. Any number gives the same bytes.
    progress : function, or class of bars
        Called with a phase, the elements treated in it and their number; False cancels. A class
        such as tqdm, or a `functools.partial` of it, draws a bar for each phase.
    **others
        `quantities`, `rule` and `simd`, as in `Options`.

    Returns
    -------
    Contacts

    Raises
    ------
    InputError, InputTypeError
        NaN, infinity, a negative radius (the text names the first bad element), a wrong shape or
        type.
    UsageError
        An option out of range.
    LimitError
        More pairs or memory than allowed.
    KeyboardInterrupt
        Ctrl-C.

    Examples
    --------
    >>> import abut
    >>> c = abut.contacts([[0, 0], [1, 0], [3, 0]], 0.5)
    >>> c.pairs
    array([[0, 1]], dtype=uint32)
    """
    elements = x if isinstance(x, Elements) and r is None else round_elements(x, r)
    if (
        (domain is None and groups is None and exclude is None and shifts is None)
        and (max_pairs is None and max_bytes is None and threads is None and progress is None)
        and (algorithm is _AUTO and order is _CANONICAL)
        and (type(margin) is float and margin == 0.0 and not others)
    ):
        results = _abut.find_contact_pairs(elements._native, None, OPEN._native, _NATIVE_NONE)
        return Contacts(results, elements, None, _NONE)
    native = native_domain(domain)
    options = call_options(
        (len(elements), None),
        domain,
        margin,
        groups,
        exclude,
        algorithm=algorithm,
        order=order,
        shifts=shifts,
        max_pairs=max_pairs,
        max_bytes=max_bytes,
        threads=threads,
        progress=progress,
        **others,
    )
    results = _abut.find_contact_pairs(elements._native, None, native, options)
    return Contacts(
        results, elements, None, {"domain": domain, "order": order, "threads": threads}
    )


def prepared(
    elements: Elements, others: Elements | None, options: Options
) -> tuple[Any, Any, _abut.Domain, _abut.CallOptions]:
    """Arguments for the compiled module: elements, others, domain, options."""
    first = require_elements(elements)
    second = None if others is None else require_elements(others)
    native = native_domain(options.get("domain"))
    sizes = (len(first), None if second is None else len(second))
    return (
        first._native,
        None if second is None else second._native,
        native,
        call_options(sizes, **options),
    )


def find_contact_pairs(
    elements: Elements, others: Elements | None = None, **options: Unpack[Options]
) -> Contacts:
    """Finds the contact pairs of elements of any shape, or of two sets of elements.

    With two sets, i is of `elements` and j of `others`; elements of one set never pair with each
    other. The options are those of `contacts`.

    >>> import abut
    >>> boxes = abut.boxes([[0, 0, 0], [1, 0, 0]], [[1, 1, 1], [2, 1, 1]])
    >>> abut.find_contact_pairs(boxes)
    <abut.Contacts: 1 contact pairs of 2 boxes, mean coordination 1>
    >>> probes = abut.points([[0.0, 0.0, 0.0]])
    >>> len(abut.find_contact_pairs(probes, abut.spheres([[0.5, 0.0, 0.0]], 0.5)))
    1
    """
    results = _abut.find_contact_pairs(*prepared(elements, others, options))
    return Contacts(results, elements, others, options)


def count_contact_pairs(
    elements: Elements, others: Elements | None = None, **options: Unpack[Options]
) -> Statistics:
    """Counts the contact pairs without storing them: `contact_pairs` of what it returns.

    >>> import abut
    >>> abut.count_contact_pairs(abut.discs([[0, 0], [1, 0]], 0.5)).contact_pairs
    1
    """
    return Statistics(**_abut.count_contact_pairs(*prepared(elements, others, options)))

"""Options that every detection takes, by name."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, TypedDict

import numpy.typing as npt

from . import _abut
from ._arrays import count, number
from ._domain import Domain
from ._errors import InputTypeError
from ._progress import Progress, progress_function
from ._rules import ExclusionList, PairRule, rule_of

#: One or more of 'gap', 'normal', 'point', 'distance', 'vector'.
QuantityNames = str | Iterable[str]


class Options(TypedDict, total=False):
    """Options of a detection; each may be left out."""

    domain: Domain | None  #: Open space if it is left out.
    margin: float  #: Distance from touching up to which elements are contact pairs, too.
    groups: npt.ArrayLike | tuple[npt.ArrayLike, npt.ArrayLike] | None  #: Equal ones do not pair.
    exclude: npt.ArrayLike | ExclusionList | None  #: Pairs that are none.
    rule: PairRule | None  #: In place of groups and exclude.
    algorithm: str  #: 'auto' or a name of `algorithms`.
    order: str  #: 'canonical' or 'as_found'.
    shifts: bool | None  #: Whether image shifts are stored; None: in periodic domains.
    quantities: QuantityNames  #: What lists hold of each contact, such as 'gap'.
    max_pairs: int | None  #: One pair more raises LimitError.
    max_bytes: int | None  #: Bound on the bytes of abut's own buffers.
    threads: int | None  #: None for OpenMP's default.
    simd: str  #: Instruction set, 'auto' or a name of `simd_levels`.
    progress: Progress | None  #: Called now and then, or a class of bars such as tqdm.


def call_options(
    sizes: tuple[int, int | None] = (0, None),
    domain: Domain | None = None,
    margin: float = 0.0,
    groups: Any = None,
    exclude: Any = None,
    rule: PairRule | None = None,
    algorithm: str = "auto",
    order: str = "canonical",
    shifts: bool | None = None,
    quantities: QuantityNames = (),
    max_pairs: int | None = None,
    max_bytes: int | None = None,
    threads: int | None = None,
    simd: str = "auto",
    progress: Progress | None = None,
) -> _abut.CallOptions:
    """Options for the compiled module, checked as far as types go."""
    for what, name in (("algorithm", algorithm), ("order", order), ("simd", simd)):
        if not isinstance(name, str):
            raise InputTypeError(f"{what} is a name, not {name!r}")
    if shifts is None:
        shifts = domain is not None and domain.is_periodic
    return _abut.CallOptions(
        number(margin, "the margin"),
        algorithm,
        order,
        bool(shifts),
        _quantities(quantities),
        rule_of(rule, groups, exclude, sizes),
        count(max_pairs, "max_pairs"),
        count(max_bytes, "max_bytes"),
        threads_of(threads),
        simd,
        progress_function(progress),
    )


def _quantities(given: QuantityNames) -> tuple[str, ...]:
    names = (given,) if isinstance(given, str) else given
    if names and not all(isinstance(name, str) for name in names):
        raise InputTypeError(f"quantities are names, not {given!r}")
    return tuple(names)


def threads_of(given: int | None) -> int | None:
    """A number of threads that the compiled module can read."""
    threads = count(given, "threads")
    return None if threads is None else min(threads, 2**31 - 1)

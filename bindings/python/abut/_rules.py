"""Rules that say which elements may pair."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from . import _abut
from ._abut import GroupTable
from ._arrays import whole_numbers
from ._errors import InputError, InputTypeError

__all__ = ["ExclusionList", "GroupTable", "PairRule"]


class ExclusionList:
    """Pairs that are never contact pairs, for example bonded neighbors.

    Parameters
    ----------
    pairs : array (K, 2) of whole numbers
        In any order, with either index first, and repeatedly. It is copied.
    elements : int
        Number of elements of the only or the first set.
    others : int, optional
        Number of elements of the second set. If it is given, the first index of a pair is of the
        first set.

    >>> import abut
    >>> bonds = abut.ExclusionList([[0, 1], [2, 1]], 3)
    >>> len(bonds), bonds.contains(1, 2), bonds.contains(0, 2)
    (2, True, False)
    """

    __slots__ = ("_native",)

    def __init__(self, pairs: npt.ArrayLike, elements: int, others: int | None = None) -> None:
        table = whole_numbers(pairs, np.uint32, "exclusions")
        if table.size == 0:
            table = table.reshape(0, 2)
        if table.ndim != 2 or table.shape[1] != 2:
            raise InputError(f"exclusions have the shape (K, 2), not {table.shape}")
        self._native = _abut.exclusions(table, elements, others)

    def __len__(self) -> int:
        return len(self._native)

    @property
    def is_of_two_sets(self) -> bool:
        """True if it was made for two sets."""
        return self._native.is_of_two_sets

    def contains(self, i: int, j: int) -> bool:
        """True if the pair is excluded."""
        return self._native.contains(i, j)


class PairRule:
    """A rule that says which elements may pair; all of its parts must allow a pair.

    Parameters
    ----------
    groups : array (N,) of whole numbers
        With a table, elements of groups that it allows may pair; without, those of different
        groups, as for the parts of a rigid body.
    categories, accepts : arrays (N,) of whole numbers, 64 bits
        Kinds that an element is of, and kinds that it may pair with, a bit each.
    other_groups, other_categories, other_accepts : arrays (M,)
        The same for the second of two sets.
    table : GroupTable
        Groups that may pair.
    exclude : ExclusionList
        Pairs that may not.

    >>> import abut
    >>> walls_do_not_touch = abut.PairRule(groups=[0, 0, 1], table=abut.GroupTable(2).deny(0, 0))
    >>> len(abut.contacts([[0, 0], [1, 0], [0, 1]], 0.5, rule=walls_do_not_touch))
    1
    """

    __slots__ = ("_native", "_table")

    def __init__(
        self,
        groups: npt.ArrayLike | None = None,
        *,
        categories: npt.ArrayLike | None = None,
        accepts: npt.ArrayLike | None = None,
        other_groups: npt.ArrayLike | None = None,
        other_categories: npt.ArrayLike | None = None,
        other_accepts: npt.ArrayLike | None = None,
        table: GroupTable | None = None,
        exclude: ExclusionList | None = None,
    ) -> None:
        if table is not None and not isinstance(table, GroupTable):
            raise InputTypeError(f"table is a GroupTable, not {type(table).__name__}")
        if exclude is not None and not isinstance(exclude, ExclusionList):
            raise InputTypeError(f"exclude is an ExclusionList, not {type(exclude).__name__}")
        self._native = _abut.rule(
            _traits(groups, categories, accepts),
            _traits(other_groups, other_categories, other_accepts),
            table,
            None if exclude is None else exclude._native,
        )


def _traits(groups: Any, categories: Any, accepts: Any) -> tuple[Any, Any, Any]:
    return (
        _property(groups, np.uint32, "groups"),
        _property(categories, np.uint64, "categories"),
        _property(accepts, np.uint64, "accepts"),
    )


def _property(given: Any, dtype: type[np.generic], what: str) -> Any:
    if given is None:
        return None
    array = whole_numbers(given, dtype, what)
    if array.ndim != 1:
        raise InputError(f"{what} have one axis, a number for each element, not {array.shape}")
    return array


def rule_of(rule: Any, groups: Any, exclude: Any, sizes: tuple[int, int | None]) -> Any:
    """The rule for the compiled module, from the three ways to say it; None if all may pair."""
    if rule is not None:
        if groups is not None or exclude is not None:
            raise InputTypeError("give either a rule, or groups and exclude")
        if not isinstance(rule, PairRule):
            raise InputTypeError(f"rule is a PairRule, not {type(rule).__name__}")
        return rule._native
    if groups is None and exclude is None:
        return None
    if exclude is not None and not isinstance(exclude, ExclusionList):
        exclude = ExclusionList(exclude, *sizes)
    first, second = groups if isinstance(groups, tuple) else (groups, None)
    return PairRule(first, other_groups=second, exclude=exclude)._native

"""Values of each contact, taken over from step to step."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from . import _abut
from ._arrays import whole_numbers
from ._contacts import Contacts
from ._errors import InputError, InputTypeError, UsageError
from ._options import threads_of


class History:
    """What the histories of contact pairs and of contacts with walls have in common."""

    _make_matcher: Any
    _names: tuple[str, ...]  #: What a lost contact has besides its value.

    def __init__(self, dtype: npt.DTypeLike = float) -> None:
        self._dtype = np.dtype(dtype)
        if self._dtype.hasobject or self._dtype.itemsize == 0:
            raise InputTypeError(f"values of a history have numbers of a fixed size, not {dtype}")
        self.clear()

    def clear(self) -> None:
        """Forgets all contacts."""
        self._matcher: Any = self._new_matcher()
        self._values = np.zeros(0, self._dtype)
        self._lost = self._lost_of(self._values)

    def _new_matcher(self) -> Any:
        return self._make_matcher(self._dtype.itemsize)

    def _room_for(self, count: int) -> npt.NDArray[Any]:
        return np.zeros(count, self._dtype)

    def _update(self, count: int, *step: Any) -> None:
        """Brings the history to a step of so many contacts. On an error nothing has changed."""
        values = self._room_for(count)
        self._matcher.update(*step)
        before, self._values = self._values, values
        self._matcher.carry(_bytes_of(before), _bytes_of(values))
        self._lost = self._lost_of(before)

    def _lost_of(self, before: npt.NDArray[Any]) -> npt.NDArray[Any]:
        places = self._matcher.lost_places()
        fields = [(name, np.uint64) for name in self._names]
        lost = np.zeros(len(places), [*fields, ("value", self._dtype)])
        for name, numbers in zip(self._names, self._matcher.lost(), strict=True):
            lost[name] = numbers
        lost["value"] = before[places]
        return lost

    @property
    def values(self) -> npt.NDArray[Any]:
        """Values of the contacts, one for each contact of the last update, in its order; writable."""
        return self._values

    @values.setter
    def values(self, values: npt.ArrayLike) -> None:
        # So that `history.values += 1` works; the array stays the same one.
        if np.shape(values) != self._values.shape:
            raise InputError(f"{len(self._values)} values are needed, not {np.shape(values)}")
        self._values[...] = values

    @property
    def kept(self) -> int:
        """Number of contacts that the previous step had, too."""
        kept: int = self._matcher.kept
        return kept

    @property
    def born(self) -> npt.NDArray[np.uint64]:
        """Positions in the list of the contacts that are new, ascending."""
        born: npt.NDArray[np.uint64] = self._matcher.born()
        return born

    @property
    def lost(self) -> npt.NDArray[Any]:
        """Contacts of the previous step that are no more: a structured array of what they were,
        and the value."""
        return self._lost

    def __len__(self) -> int:
        return len(self._values)

    def __repr__(self) -> str:
        return (
            f"<abut.{type(self).__name__}: {len(self):,} contacts, {self.kept:,} kept, "
            f"{len(self.born):,} new, {len(self.lost):,} lost>"
        )


class ContactHistory(History):
    """Values of the caller, one for each contact pair, taken over from step to step.

    A contact that persists keeps its value; a new one begins with zeros. A contact is a pair of
    elements and an image; it persists also where elements are renumbered, if they have ids, and
    where positions are wrapped into the cell, if elements move by less than half a cell in a step.

    Parameters
    ----------
    dtype : data type
        Type of a value: a number or a structured type.
    threads : int
        Number of threads; OpenMP's default if it is left out. Any number gives the same values.

    Examples
    --------
    >>> import abut
    >>> history = abut.ContactHistory([("slip", float, 2), ("steps", int)])
    >>> for x in ([[0, 0], [1, 0], [3, 0]], [[0, 0], [1, 0], [2, 0]], [[0, 0], [9, 0], [8, 0]]):
    ...     history.update(abut.contacts(x, 0.5))
    ...     history.values["steps"] += 1
    ...     print(history.values["steps"], history.kept, history.born)
    [1] 0 [0]
    [2 1] 1 [1]
    [2] 1 []
    >>> history.lost["first"], history.lost["value"]["steps"]
    (array([0], dtype=uint64), array([2]))
    """

    _names = ("first", "second")

    def __init__(self, dtype: npt.DTypeLike = float, *, threads: int | None = None) -> None:
        self._threads = threads_of(threads)
        super().__init__(dtype)

    def _new_matcher(self) -> Any:
        return _abut.PairHistory(self._dtype.itemsize, self._threads or 0)

    def _room_for(self, count: int) -> npt.NDArray[Any]:
        # Every value is written when the kept ones are carried.
        return np.empty(count, self._dtype)

    def update(self, contacts: Contacts, ids: npt.ArrayLike | None = None) -> None:
        """Brings the history to the contacts of this step. On an error nothing has changed.

        Parameters
        ----------
        contacts : Contacts
            In canonical order, of one set, in a periodic domain with shifts.
        ids : array (N,) of whole numbers
            Ids of the elements, all different. Without them an element is its index.
        """
        if not isinstance(contacts, Contacts):
            raise InputTypeError(f"contacts are needed, not {type(contacts).__name__}")
        if contacts.others is not None:
            raise UsageError("a history is of contacts within one set; these are of two")
        elements, domain = contacts.elements._native, contacts.domain._native
        self._update(len(contacts), contacts._native(), elements, domain, ids_of(ids))

    @property
    def flipped(self) -> npt.NDArray[np.uint64]:
        """Positions of kept contacts whose elements have changed roles: i was j. Values that point
        from one to the other must be turned around."""
        flipped: npt.NDArray[np.uint64] = self._matcher.flipped()
        return flipped


def ids_of(given: npt.ArrayLike | None) -> npt.NDArray[np.uint64] | None:
    """Ids of elements as the module reads them."""
    return None if given is None else whole_numbers(given, np.uint64, "ids")


def _bytes_of(values: npt.NDArray[Any]) -> npt.NDArray[np.uint8]:
    """The same memory as a table of bytes with a row for each value."""
    return values.view(np.uint8).reshape(len(values), values.dtype.itemsize)

"""Values of each contact with a wall, taken over from step to step."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from . import _abut
from ._errors import InputTypeError
from ._history import History, ids_of
from ._wall_contacts import BoxContacts, MeshContacts, table_of


class MeshContactHistory(History):
    """Values of the caller, one for each contact of spheres and a mesh, taken over from step to
    step.

    A contact that persists keeps its value; a new one begins with zeros. A contact is a sphere, a
    feature and an image. Where a sphere rolls on to the next feature, the value goes with it: to a
    contact that is new, of the same sphere, whose feature has a vertex in common with one that has
    vanished, if the directions to both are less than 60 degrees apart.

    Parameters
    ----------
    dtype : data type
        Type of a value: a number or a structured type.

    Examples
    --------
    >>> import abut
    >>> floor = abut.TriangleMesh(
    ...     [[0, 0, 0], [4, 0, 0], [0, 4, 0], [4, 4, 0]], [[0, 1, 2], [1, 2, 3]])
    >>> history = abut.MeshContactHistory(int)
    >>> for x in (1, 2, 3):
    ...     history.update(abut.find_mesh_contacts(abut.spheres([[x, 2, 0.5]], 0.5), floor))
    ...     history.values += 1
    >>> history.values, history.kept, history.passed_on
    (array([3]), 1, array([0], dtype=uint64))
    """

    _make_matcher = _abut.MeshHistory
    _names = ("sphere", "kind", "number")

    def update(
        self,
        contacts: MeshContacts,
        ids: npt.ArrayLike | None = None,
        which: npt.ArrayLike | None = None,
    ) -> None:
        """Brings the history to the contacts of this step. On an error nothing has changed.

        Parameters
        ----------
        contacts : MeshContacts
            In a periodic domain with shifts; spheres and mesh have not moved since.
        ids : array (N,) of whole numbers
            Ids of the spheres, all different. Without them a sphere is its index.
        which : array of positions in the list, ascending, or of M truth values
            The contacts that the history follows; all by default.

        Raises
        ------
        InputError, InputTypeError
            No contacts with a mesh; ids of another number than spheres, or twice the same.
        UsageError
            Shifts that were not stored; a mesh of more or fewer triangles, edges or vertices
            than the one before. Other triangles, as many, are not seen.
        """
        if not isinstance(contacts, MeshContacts):
            raise InputTypeError(f"contacts with a mesh are needed, not {type(contacts).__name__}")
        records, shift = _chosen(contacts, which)
        step = (contacts.spheres._native, contacts.mesh._native, contacts.domain._native)
        self._update(len(records), records, shift, *step, ids_of(ids))

    @property
    def passed_on(self) -> npt.NDArray[np.uint64]:
        """Positions in the list of the contacts that took over the value of another feature,
        ascending. A value that lies in the plane of contact must be turned with it."""
        passed_on: npt.NDArray[np.uint64] = self._matcher.passed_on()
        return passed_on


class BoxContactHistory(History):
    """Values of the caller, one for each contact of spheres and boxes, taken over from step to
    step.

    A contact is a sphere, a box and an image, and persists while both steps have it, whatever part
    of the box the sphere touches. Boxes are told by their indices.

    Parameters
    ----------
    dtype : data type
        Type of a value: a number or a structured type.

    >>> import abut
    >>> history = abut.BoxContactHistory(int)
    >>> for x in (0.5, 1.25, 9):
    ...     c = abut.find_box_contacts(abut.discs([[x, 1]], 0.5), abut.rectangles([[0, 0]], [[1, 1]]))
    ...     history.update(c)
    ...     history.values += 1
    >>> history.values, history.lost["box"], history.lost["value"]
    (array([], dtype=int64), array([0], dtype=uint64), array([2]))
    """

    _make_matcher = _abut.BoxHistory
    _names = ("sphere", "box")

    def update(
        self,
        contacts: BoxContacts,
        ids: npt.ArrayLike | None = None,
        which: npt.ArrayLike | None = None,
    ) -> None:
        """Brings the history to the contacts of this step; see `MeshContactHistory.update`."""
        if not isinstance(contacts, BoxContacts):
            raise InputTypeError(f"contacts with boxes are needed, not {type(contacts).__name__}")
        records, shift = _chosen(contacts, which)
        step = (contacts.spheres._native, contacts.domain._native)
        self._update(len(records), records, shift, *step, ids_of(ids))


def _chosen(contacts: MeshContacts | BoxContacts, which: npt.ArrayLike | None) -> tuple[Any, Any]:
    """Tables of the contacts that a history follows, and of their shifts."""
    records = contacts.records
    shift = contacts.shift if contacts.domain.is_periodic else None
    if which is not None:
        places = np.asarray(which)
        if places.size == 0:
            places = places.astype(np.int64)
        if places.ndim != 1 or places.dtype.kind not in "iub":
            raise InputTypeError("contacts are chosen by positions or truth values, on one axis")
        records = records[places]
        shift = None if shift is None else np.ascontiguousarray(shift[places])
    return table_of(records), shift

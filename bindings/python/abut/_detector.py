"""Detections again and again, for example once in each time step."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Unpack

import numpy as np
import numpy.typing as npt

from . import _abut
from ._arrays import number, whole_numbers
from ._contacts import Contacts
from ._detect import prepared
from ._elements import Elements, round_elements
from ._errors import InputTypeError
from ._mesh import TriangleMesh
from ._neighbors import NeighborList, is_full
from ._options import Options
from ._statistics import Statistics
from ._wall_contacts import BoxContacts, MeshContacts
from ._walls import prepared_with_mesh


@dataclass(frozen=True)
class SkinStatistics:
    """Statistics of a detector's skin since it was set."""

    detections: int  #: Calls that detected anew.
    reuses: int  #: Calls that tested candidate pairs of an earlier one.
    carried: int  #: Reuses after elements had come, gone or changed their indices.
    inserted: int  #: New elements that such reuses searched against all others.
    candidates: int  #: Candidate pairs kept now.
    survivors: int  #: Candidate pairs that were contact pairs in the last call.
    skin: float  #: Length with which the candidate pairs were found.
    approach: float  #: Upper bound on how much closer any two elements may have come since.


class Detector:
    """Detects contacts again and again and keeps its memory in between.

    With a skin it keeps pairs that nearly touch, too, and tests those again while elements move
    little. The results are those of the functions of the same names. Its memory serves again unless
    the last result, or one of its arrays, is still there; these may be kept as long as wanted.

    Parameters
    ----------
    skin : None, 'auto' or a length
        A skin never changes a result, only what it costs.
    **options
        Those of `contacts`; each call may give others.

    Examples
    --------
    >>> import abut
    >>> import numpy as np
    >>> detector = abut.Detector(skin=0.25)
    >>> x = np.array([[0.0, 0.0], [1.25, 0.0]])
    >>> for step in range(3):
    ...     print(len(detector.contacts(x, 0.5)))
    ...     x[1, 0] -= 0.125
    0
    0
    1
    >>> detector.skin_statistics.reuses
    1
    """

    def __init__(self, *, skin: float | str | None = None, **options: Unpack[Options]) -> None:
        self._detector = _abut.Detector()
        self._options = options
        self._skin: float | str | None = None
        if skin is not None:
            self.skin = skin

    @property
    def skin(self) -> float | str | None:
        """Skin of the next call: None, 'auto' or a length."""
        return self._skin

    @skin.setter
    def skin(self, skin: float | str | None) -> None:
        if isinstance(skin, str) and skin != "auto":
            raise InputTypeError(f"a skin is None, 'auto' or a length, not {skin!r}")
        length = None if skin is None or isinstance(skin, str) else number(skin, "the skin")
        self._detector.set_skin(length, skin == "auto")
        self._skin = skin

    def set_ids(self, ids: npt.ArrayLike | None) -> None:
        """Sets the ids of the elements for the calls that follow: one for each, all different.

        With a skin, ids let candidate pairs last while elements come, go and change places. They
        never change a result.
        """
        self._detector.set_ids(None if ids is None else whole_numbers(ids, np.uint64, "ids"))

    @property
    def skin_statistics(self) -> SkinStatistics:
        """Statistics of the calls since the skin was set."""
        return SkinStatistics(**self._detector.skin_statistics)

    def contacts(self, x: Any, r: Any = None, **options: Unpack[Options]) -> Contacts:
        """Finds which spheres or discs touch; see the function `contacts`."""
        elements = x if isinstance(x, Elements) and r is None else round_elements(x, r)
        return self.find_contact_pairs(elements, **options)

    def find_contact_pairs(
        self, elements: Elements, others: Elements | None = None, **options: Unpack[Options]
    ) -> Contacts:
        """Finds the contact pairs of elements of any shape, or of two sets."""
        options = {**self._options, **options}
        results = self._detector.find_contact_pairs(*prepared(elements, others, options))
        return Contacts(results, elements, others, options)

    def count_contact_pairs(
        self, elements: Elements, others: Elements | None = None, **options: Unpack[Options]
    ) -> Statistics:
        """Counts the contact pairs without storing them."""
        options = {**self._options, **options}
        return Statistics(
            **self._detector.count_contact_pairs(*prepared(elements, others, options))
        )

    def build_neighbor_list(
        self,
        elements: Elements,
        others: Elements | None = None,
        *,
        kind: str = "half",
        **options: Unpack[Options],
    ) -> NeighborList:
        """Builds the neighbor list of contact pairs; see the function of this name."""
        first, second, domain, native = prepared(elements, others, {**self._options, **options})
        return NeighborList(
            self._detector.build_neighbor_list(first, second, domain, is_full(kind), native),
            elements.dimensions,
        )

    def find_mesh_contacts(
        self, spheres: Elements, mesh: TriangleMesh, **options: Unpack[Options]
    ) -> MeshContacts:
        """Finds the contacts of spheres and a mesh; see the function of this name.

        In open space and without a rule, the detector keeps a grid of the triangles from call to
        call, also when the mesh is moved, and while it is deformed by little. One detector is meant
        for one mesh, or for several that take turns rarely. The list is a copy, which may be kept.
        """
        options = {**self._options, **options}
        results = self._detector.find_mesh_contacts(*prepared_with_mesh(spheres, mesh, options))
        return MeshContacts(results, spheres, mesh, options)

    def find_box_contacts(
        self, spheres: Elements, boxes: Elements, **options: Unpack[Options]
    ) -> BoxContacts:
        """Finds the contacts of spheres and boxes; see the function of this name. Each call
        searches anew."""
        options = {**self._options, **options}
        results = self._detector.find_box_contacts(*prepared(spheres, boxes, options))
        return BoxContacts(results, spheres, boxes, options)

    def __repr__(self) -> str:
        return f"<abut.Detector: skin {self.skin}, {self.skin_statistics.detections:,} detections>"

"""Contact pairs, and what is asked of them."""

from __future__ import annotations

import os
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _abut, _exports, _plot
from ._domain import OPEN, Domain
from ._elements import Elements
from ._errors import UsageError
from ._geometry import QUANTITIES, Arrays, Measured
from ._options import Options, call_options
from ._statistics import Statistics

if TYPE_CHECKING:
    import matplotlib.axes
    import networkx
    import pandas
    import scipy.sparse
    import xarray


class Contacts(Measured):
    """The contact pairs of one detection, each once.

    Arrays are read-only views of the memory that the detection filled. They may be kept: they
    outlive this object. `gap`, `normal`, `point`, `distance` and `vector` are measured when they
    are first asked for, from the caller's positions; ask before these change, or name them as
    `quantities` of the detection.

    >>> import abut
    >>> c = abut.contacts([[0, 0, 0], [1, 0, 0], [1.75, 0, 0]], 0.5)
    >>> c
    <abut.Contacts: 2 contact pairs of 3 spheres, mean coordination 1.333>
    >>> c.i, c.j
    (array([0, 1], dtype=uint32), array([1, 2], dtype=uint32))
    >>> c.gap
    array([ 0.  , -0.25])
    """

    def __init__(
        self,
        results: _abut.PairResults,
        elements: Elements,
        others: Elements | None,
        options: Options,
    ) -> None:
        self._results: _abut.PairResults | None = results
        self._pairs: npt.NDArray[np.uint32] | None = None
        self._elements = elements
        self._others = others
        self._domain = options.get("domain") or OPEN
        self._threads = options.get("threads")
        self._is_canonical = options.get("order", "canonical") == "canonical"
        self._measured: dict[str, npt.NDArray[np.float64]] = {}

    def __len__(self) -> int:
        return len(self.pairs) if self._results is None else len(self._results)

    @property
    def pairs(self) -> npt.NDArray[np.uint32]:
        """Table (M, 2) of the indices of the two elements of each pair."""
        # Not a cached_property, whose lock costs more than all else here.
        pairs = self._pairs
        if pairs is None:
            pairs = self._pairs = self._native().pairs
        return pairs

    @property
    def i(self) -> npt.NDArray[np.uint32]:
        """Index of the first element of each pair: a view of `pairs`."""
        return self.pairs[:, 0]

    @property
    def j(self) -> npt.NDArray[np.uint32]:
        """Index of the second element of each pair: a view of `pairs`."""
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

    @property
    def gap(self) -> npt.NDArray[np.float64]:
        """Distance of the surfaces of each pair, (M,), in the unit of the positions; <= 0 exactly
        where the elements touch."""
        return self.measure("gap")[0]

    @property
    def normal(self) -> npt.NDArray[np.float64]:
        """Unit vector from i to j, (M, dimensions); 0 where centers coincide."""
        return self.measure("normal")[0]

    @property
    def point(self) -> npt.NDArray[np.float64]:
        """Point of contact, (M, dimensions): the middle of the overlap, beside element i, which is
        not moved by the image shift."""
        return self.measure("point")[0]

    @property
    def distance(self) -> npt.NDArray[np.float64]:
        """Distance of the centers, (M,)."""
        return self.measure("distance")[0]

    @property
    def vector(self) -> npt.NDArray[np.float64]:
        """Vector from the center of i to that of j, moved by its image shift, (M, dimensions)."""
        return self.measure("vector")[0]

    @property
    def _dimensions(self) -> int:
        return self._elements.dimensions

    def _measure_now(self, names: list[str]) -> Arrays:
        return _abut.measure(
            self._elements._native,
            None if self._others is None else self._others._native,
            self._domain._native,
            self.pairs,
            np.ascontiguousarray(self.shift) if self._domain.is_periodic else None,
            call_options(quantities=names, threads=self._threads),
        )

    def fabric(self) -> npt.NDArray[np.float64]:
        """Fabric tensor (dimensions, dimensions): the mean of n n^T over all contacts with a
        normal n (M. Satake, Fabric tensor in granular materials, 1982). Its trace is 1; NaN if
        there is no such contact.

        >>> import abut
        >>> abut.contacts([[0, 0], [1, 0], [2, 0], [2, 1]], 0.5).fabric().round(3)
        array([[0.667, 0.   ],
               [0.   , 0.333]])
        """
        normals = self.normal
        count = np.count_nonzero(normals.any(axis=1))
        if count == 0:
            return np.full((self._elements.dimensions,) * 2, np.nan)
        return np.asarray(np.einsum("ki,kj->ij", normals, normals) / count)

    @cached_property
    def statistics(self) -> Statistics:
        """Work and cost of the detection."""
        return Statistics(**self._native().statistics)

    @property
    def elements(self) -> Elements:
        """The elements of the only or the first set."""
        return self._elements

    @property
    def others(self) -> Elements | None:
        """The elements of the second set, or None."""
        return self._others

    @property
    def domain(self) -> Domain:
        """The domain of the detection."""
        return self._domain

    @cached_property
    def _rows(self) -> tuple[npt.NDArray[np.int64], npt.NDArray[np.uint32]]:
        counts = np.bincount(self.i, minlength=len(self._elements))
        indptr = np.concatenate(([0], np.cumsum(counts)))
        if self._is_canonical:
            return indptr, self.j
        return indptr, self.j[np.argsort(self.i, kind="stable")]

    @property
    def indptr(self) -> npt.NDArray[np.int64]:
        """Compressed rows: the pairs of element e are indices[indptr[e]:indptr[e + 1]]."""
        return self._rows[0]

    @property
    def indices(self) -> npt.NDArray[np.uint32]:
        """Second elements of the pairs, row after row of first elements."""
        return self._rows[1]

    def _only_set(self, what: str) -> int:
        if self._others is not None:
            raise UsageError(f"{what} is of contacts within one set; these are of two")
        return len(self._elements)

    def coordination(self) -> npt.NDArray[np.int64]:
        """Number of contacts of each element. An image of itself counts twice.

        >>> import abut
        >>> abut.contacts([[0, 0], [1, 0], [2, 0]], 0.5).coordination()
        array([1, 2, 1])
        """
        count = self._only_set("the coordination number")
        return np.bincount(self.i, minlength=count) + np.bincount(self.j, minlength=count)

    def rattlers(self, needed: int | None = None) -> npt.NDArray[np.bool_]:
        """True for elements without support: those with fewer than `needed` contacts, when these
        are taken away those that then have fewer, and so on.

        Parameters
        ----------
        needed : int
            Contacts that hold an element; the number of dimensions + 1 by default.

        >>> import abut
        >>> abut.contacts([[0, 0], [1, 0], [2, 0]], 0.5).rattlers(2)
        array([ True,  True,  True])
        """
        count = self._only_set("a rattler")
        if needed is None:
            needed = self._elements.dimensions + 1
        return _abut.rattlers(self.pairs, count, needed).view(np.bool_)

    def clusters(self) -> npt.NDArray[np.int64]:
        """Number of the cluster of each element: elements joined by contacts are in one cluster.
        Clusters are numbered from 0 in the order of their smallest elements.

        >>> import abut
        >>> abut.contacts([[0, 0], [5, 0], [1, 0]], 0.5).clusters()
        array([0, 1, 0])
        """
        return _abut.clusters(self.pairs, self._only_set("a cluster")).view(np.int64)

    def to_scipy(self, values: npt.ArrayLike | None = None) -> scipy.sparse.csr_array:
        """Sparse matrix (N, N), symmetric; of two sets (N, M).

        Parameters
        ----------
        values : array (number of pairs,)
            Value of each pair; 1 by default. Values of several images of a pair are added up.
        """
        import scipy.sparse

        data = np.ones(len(self)) if values is None else np.asarray(values)
        partners = self._elements if self._others is None else self._others
        shape = (len(self._elements), len(partners))
        i, j = self.i.astype(np.int64), self.j.astype(np.int64)
        if self._others is None:
            i, j, data = np.append(i, j), np.append(j, i), np.append(data, data)
        return scipy.sparse.csr_array(scipy.sparse.coo_array((data, (i, j)), shape=shape))

    def to_pandas(self) -> pandas.DataFrame:
        """Data frame with columns i, j, in a periodic domain nx, ny, nz, and gap."""
        import pandas

        columns: dict[str, Any] = {"i": self.i, "j": self.j}
        if self._domain.is_periodic:
            columns |= {name: self.shift[:, k] for k, name in enumerate(("nx", "ny", "nz"))}
        return pandas.DataFrame(columns | {"gap": self.gap})

    def to_networkx(self) -> networkx.Graph:
        """Graph with a node for each element, which has its position as `pos`, and an edge with
        `gap` for each contact; in a periodic domain a MultiGraph, whose edges have `shift`, too.

        >>> import abut
        >>> abut.contacts([[0, 0], [1, 0], [2, 0]], 0.5).to_networkx().degree[1]
        2
        """
        return _exports.to_networkx(self)

    def to_xarray(self) -> xarray.Dataset:
        """Data set with i, j, gap, normal, point, in a periodic domain shift, along `contact`.

        >>> import abut
        >>> dict(abut.contacts([[0, 0], [1, 0]], 0.5).to_xarray().sizes)
        {'contact': 1, 'axis': 2}
        """
        return _exports.to_xarray(self)

    def to_freud(self) -> Any:
        """`freud.locality.NeighborList` with each contact in both directions, in float32 as freud
        has it; of two sets from the first, the query points, to the second."""
        return _exports.to_freud(self)

    def to_ovito(self) -> Any:
        """`ovito.data.DataCollection` with the elements as particles, the cell, and the contacts as
        bonds with a property Gap."""
        return _exports.to_ovito(self)

    def plot(self, ax: matplotlib.axes.Axes | None = None) -> matplotlib.axes.Axes:
        """Draws the elements and a line for each contact, from center to center, colored by the
        depth of the overlap; in three dimensions the centers only.

        Parameters
        ----------
        ax : matplotlib.axes.Axes
            Axes to draw on, in three dimensions with projection='3d'; new ones by default.

        Returns
        -------
        matplotlib.axes.Axes
        """
        return _plot.plot(self, ax)

    def _repr_html_(self) -> str:
        return _exports.as_html(self)

    def write(self, path: str | os.PathLike[str], format: str = "") -> None:
        """Writes the pairs with their gaps to a file, which appears whole or not at all.

        Parameters
        ----------
        path : str or path
        format : 'csv', 'json' or 'vtp'
            By the suffix of the path if it is left out. VTP is for ParaView.
        """
        _abut.write_contacts(
            os.fspath(path),
            format,
            self._elements._native,
            None if self._others is None else self._others._native,
            self._domain._native,
            self.pairs,
            np.ascontiguousarray(self.shift),
        )

    def __repr__(self) -> str:
        plural = {"box": "boxes"}.get(self._elements.shape, self._elements.shape + "s")
        text = f"<abut.Contacts: {len(self):,} contact pairs of {len(self._elements):,}"
        if self._others is not None:
            return f"{text} and {len(self._others):,} {plural}>"
        mean = 2 * len(self) / max(1, len(self._elements))
        return f"{text} {plural}, mean coordination {mean:.4g}>"

    def _native(self) -> _abut.PairResults:
        if self._results is None:
            raise UsageError("contacts that were pickled no longer have this")
        return self._results

    def __getstate__(self) -> dict[str, Any]:
        if self._results is not None:
            self._measured.update(self._stored(QUANTITIES))
        return {
            "_results": None,
            "_elements": self._elements,
            "_others": self._others,
            "_domain": self._domain,
            "_threads": self._threads,
            "_is_canonical": self._is_canonical,
            "_measured": self._measured,
            "_pairs": self.pairs,
            "statistics": self.statistics,
            **({"shift": self.shift} if self._has_shifts() else {}),
        }

    def _has_shifts(self) -> bool:
        is_there = self._results is not None and len(self._results.shifts) == len(self)
        return is_there or "shift" in self.__dict__ or not self._domain.is_periodic

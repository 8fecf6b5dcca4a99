"""Facts about the algorithms, for those who choose one."""

from __future__ import annotations

from dataclasses import dataclass

from . import _abut


@dataclass(frozen=True)
class AlgorithmInfo:
    """Facts about one algorithm."""

    name: str  #: As `algorithm=` takes it.
    idea: str  #: One line.
    time: str  #: Law of its cost.
    memory: str  #: Law of its own arrays, in integers.
    book_pages: str  #: Munjiza, The Combined Finite-Discrete Element Method, 2004.
    min_dimensions: int  #: Fewest dimensions of its elements.
    max_dimensions: int  #: Most dimensions of its elements.
    periodic: bool  #: True if it supports periodic domains.
    traceable: bool  #: True if its arrays can be shown.


def algorithms() -> list[AlgorithmInfo]:
    """Lists all algorithms that have a name, in the order of the book.

    >>> import abut
    >>> [algorithm.name for algorithm in abut.algorithms()][-1]
    'rows'
    """
    return [AlgorithmInfo(**facts) for facts in _abut.algorithms()]

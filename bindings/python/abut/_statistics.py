"""Work and cost of one detection."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Statistics:
    """Work and cost of one detection. Counts are deterministic, seconds are not."""

    algorithm: str  #: Algorithm that ran.
    reason: str  #: Why it was chosen.
    threads: int  #: Threads used.
    simd: str  #: Instruction set of the kernels.
    elements: int  #: Number of elements, of two sets together.
    dimensions: int  #: 2 or 3.
    contact_pairs: int  #: Number of contact pairs.
    candidate_tests: int  #: Distances evaluated.
    exact_decisions: int  #: Tests that the filter left open and that were settled exactly.
    list_insertions: int  #: Elements pushed on a list of a row, a cell or a layer.
    peak_bytes: int  #: Most bytes held at once in abut's own buffers.
    working_bytes: int  #: Most bytes without the pairs: elements, cells, heads, lists.
    gather_seconds: float  #: Reading and checking the caller's arrays.
    search_seconds: float  #: Mapping to cells, candidates, tests.
    order_seconds: float  #: Bringing the pairs into canonical order.
    measure_seconds: float  #: Measuring the quantities that were asked for.

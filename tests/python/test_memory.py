"""Arrays are views of what the detection filled, cannot be written, and outlive their list."""

import gc
import weakref

import numpy as np
import pytest
from conftest import tuples

import abut


def test_arrays_are_views_and_read_only(cloud):
    c = abut.contacts(*cloud)
    assert c.pairs is c.pairs
    assert c.i.dtype == np.uint32
    assert np.shares_memory(c.i, c.pairs)
    assert np.shares_memory(c.pairs, c._results.pairs)
    for array in (c.pairs, c.i, c.j, c.shift, c.gap):
        with pytest.raises(ValueError, match="read-only"):
            array[:1] = 0
    n = abut.neighbors(cloud[0], 0.1, quantities=("distance", "vector"), shifts=True)
    for array in (n.offsets, n.neighbors, n.shifts, n.distances, n.vectors):
        with pytest.raises(ValueError, match="read-only"):
            array[:1] = 0


def test_arrays_outlive_their_list(cloud):
    c = abut.contacts(*cloud)
    expected, pairs, i = tuples(c.pairs), c.pairs, c.i
    gone = weakref.ref(c)
    del c
    gc.collect()
    assert gone() is None
    for _ in range(3):  # would write over memory that had been released
        abut.contacts(*cloud)
    assert tuples(pairs) == expected
    assert i.tolist() == [first for first, _ in expected]


def test_elements_keep_the_arrays_of_the_caller():
    elements = abut.spheres(np.random.default_rng(1).random((1000, 3)), 0.1)
    gc.collect()
    again = abut.spheres(np.random.default_rng(1).random((1000, 3)), 0.1)
    assert tuples(abut.find_contact_pairs(elements).pairs) == tuples(
        abut.find_contact_pairs(again).pairs
    )

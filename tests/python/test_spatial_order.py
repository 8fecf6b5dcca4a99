"""Numbers of elements along space."""

import numpy as np
import pytest

import abut

POINTS = np.random.default_rng(5).uniform(0.0, 50.0, (5000, 3))


def steps(points):
    return np.linalg.norm(np.diff(points, axis=0), axis=1)


def test_neighbors_follow_each_other():
    order = abut.spatial_order(POINTS)
    assert order.dtype == np.uint32
    assert np.array_equal(np.sort(order), np.arange(5000))
    assert steps(POINTS[order]).mean() < 5.0 < 20.0 < steps(POINTS).mean()


def test_it_depends_on_positions_alone():
    order = abut.spatial_order(POINTS)
    for given in (
        abut.spheres(POINTS, 0.5),
        tuple(POINTS.T),
        np.asfortranarray(POINTS),
        abut.boxes(POINTS, POINTS + 1.0),
    ):
        assert np.array_equal(abut.spatial_order(given), order)
    assert np.array_equal(abut.spatial_order(POINTS, threads=3), order)
    single = POINTS.astype(np.float32)
    assert np.array_equal(abut.spatial_order(single), abut.spatial_order(single.astype(float)))


def test_none_and_one():
    assert abut.spatial_order(np.empty((0, 2))).shape == (0,)
    assert abut.spatial_order([[1.0, 2.0]]).tolist() == [0]


def test_refusals():
    with pytest.raises(abut.InputError, match="element 1"):
        abut.spatial_order([[0.0, 0.0], [np.nan, 0.0]])
    with pytest.raises(abut.LimitError):
        abut.spatial_order(POINTS, max_bytes=1000)
    with pytest.raises(abut.Cancelled):
        abut.spatial_order(POINTS, progress=lambda *_: False)

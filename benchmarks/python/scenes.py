"""Inputs that the packages are measured on, with fixed seeds."""

import numpy as np


def dense(size):
    """Equal spheres at random in a cube, some four contacts each."""
    x = np.random.default_rng(1).random((size, 3))
    return {"x": x, "r": np.full(size, 0.5 * size ** (-1 / 3)), "cell": None}


def bidisperse(size):
    """One large sphere to 99 small ones of a tenth of its radius."""
    scene = dense(size)
    scene["r"] = np.where(np.arange(size) % 100 == 0, 10, 1) * 0.3 * size ** (-1 / 3)
    return scene


def liquid(size):
    """Points of a liquid in a periodic cube, some 40 neighbors each."""
    random = np.random.default_rng(2)
    side = max(6, round(size ** (1 / 3)))  # a cell of nearly three cutoffs, or more
    axis = np.arange(side) + 0.5
    x = np.stack(np.meshgrid(axis, axis, axis), axis=-1).reshape(-1, 3)
    x += random.uniform(-0.3, 0.3, x.shape)
    return {"x": x, "cell": np.eye(3) * side, "cutoff": 2.1}

"""Domains are those of the library, and their texts make them again."""

import pickle

import numpy as np
import pytest

import abut
from abut import Domain

DOMAINS = {
    "open": Domain.open(),
    "block": Domain.periodic((1, 2, 3)),
    "slab": Domain.periodic((1, None, 3)),
    "wall": Domain.periodic((None, None)),
    "rectangle": Domain.periodic(np.array([1, 2])),
    "lattice": Domain.lattice([[1, 0, 0], [0.5, 1, 0], [0.1, 0.2, 1]]),
    "half lattice": Domain.lattice([[1, 0.5], [0, 1]], periodic="y"),
    "shear": Domain.lees_edwards((4, 5), 0.25),
}


@pytest.mark.parametrize("name", DOMAINS)
def test_domains_are_made_again(name):
    domain = DOMAINS[name]
    again = pickle.loads(pickle.dumps(domain))
    assert again == domain
    assert hash(again) == hash(domain)
    if domain.periodic_axes or name == "open":
        assert eval(repr(domain)) == domain
    assert all(domain != other for key, other in DOMAINS.items() if key != name)


def test_what_domains_say():
    assert DOMAINS["slab"].periodic_axes == "xz"
    assert DOMAINS["slab"].dimensions == 3
    assert DOMAINS["open"].dimensions == 0
    assert not DOMAINS["open"].is_periodic
    assert DOMAINS["shear"].vectors.tolist() == [[4, 0, 0], [0.25, 5, 0], [0, 0, 0]]
    assert Domain.lattice(np.eye(3), periodic=[1, 0, 1]).periodic_axes == "xz"
    assert Domain.lattice(np.eye(3), periodic=False) == Domain.periodic([None] * 3)


def test_wrong_domains():
    for wrong in ((1,), (1, 2, 3, 4), (1, 0), (1, np.nan), (1, -1)):
        with pytest.raises(ValueError):
            Domain.periodic(wrong)
    for wrong in ([[1, 0]], [[1, 0], [2, 0]], np.zeros((3, 3)), [[1, np.inf], [0, 1]]):
        with pytest.raises(ValueError):
            Domain.lattice(wrong)
    with pytest.raises(ValueError, match="periodic names axes among 'xy'"):
        Domain.lattice(np.eye(2), periodic="z")
    for wrong in (3, "xy", None):
        with pytest.raises(TypeError):
            Domain.periodic(wrong)
    with pytest.raises(abut.InputTypeError):
        Domain(3)

"""Neighbor lists are those of the pairs."""

import numpy as np
import pytest
from conftest import tuples

import abut


@pytest.mark.parametrize("domain", [None, abut.Domain.periodic((1, 1, 1))])
def test_half_and_full_lists(cloud, domain):
    x, _ = cloud
    half = abut.neighbors(x, 0.1, domain=domain)
    full = abut.neighbors(x, 0.1, domain=domain, kind="full", shifts=True)
    pairs = abut.contacts(x, 0.05, domain=domain).pairs
    rows = np.stack([half.elements, half.neighbors], axis=1)
    assert tuples(rows) == tuples(pairs)
    both = sorted(tuples(pairs) + tuples(pairs[:, ::-1]))
    assert tuples(np.stack([full.elements, full.neighbors], axis=1)) == both
    assert len(full) == len(x)
    assert full[3].tolist() == [j for i, j in both if i == 3]
    assert full[-1].tolist() == full[len(x) - 1].tolist()
    with pytest.raises(IndexError):
        full[len(x)]


def test_distances_and_vectors(cloud):
    x, _ = cloud
    cell = abut.Domain.periodic((1, 1, 1))
    n = abut.neighbors(x, 0.1, domain=cell, quantities=("distance", "vector"))
    there = x[n.neighbors] + n.shifts @ cell.vectors
    lengths = np.linalg.norm(there - x[n.elements], axis=1)
    assert np.allclose(n.distances, lengths)
    assert (n.distances <= 0.1).all()
    assert np.allclose(n.vectors, there - x[n.elements])
    bare = abut.neighbors(x, 0.1)
    how = {"distances": "quantities='distance'", "normals": "'normal'", "shifts": "shifts=True"}
    for name, text in how.items():
        with pytest.raises(abut.UsageError, match=text):
            getattr(bare, name)


def test_lists_of_contacts_and_of_two_sets(cloud):
    x, r = cloud
    elements = abut.spheres(x, r)
    n = abut.build_neighbor_list(elements)
    c = abut.find_contact_pairs(elements)
    assert n.offsets.tolist() == c.indptr.tolist()
    assert n.neighbors.tolist() == c.indices.tolist()
    two = abut.build_neighbor_list(abut.points(x[:5]), elements)
    assert len(two) == 5
    assert all(k in two[k] for k in range(5))


def test_wrong_lists(cloud):
    x, r = cloud
    with pytest.raises(ValueError, match="'half' or 'full'"):
        abut.neighbors(x, 0.1, kind="both")
    with pytest.raises(ValueError):
        abut.neighbors(abut.spheres(x, r), 0.1)
    with pytest.raises(ValueError):
        abut.neighbors(x, -0.1)
    with pytest.raises(TypeError):
        abut.neighbors(x, "far")

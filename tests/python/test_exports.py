"""Contacts in the forms of other packages, and as pictures."""

import matplotlib
import numpy as np
import pytest

import abut

matplotlib.use("Agg")

CELL = abut.Domain.lattice([[4, 0, 0], [1, 4, 0], [0, 0, 4]])


@pytest.fixture
def periodic():
    """Two spheres that touch across a face of a skewed cell, and one that touches its image."""
    return abut.contacts([[0, 0, 0], [3, 0, 0], [2, 2, 2]], [0.75, 0.5, 2.25], domain=CELL)


def test_networkx(cloud, periodic):
    import networkx

    c = abut.contacts(*cloud)
    graph = c.to_networkx()
    assert sorted(map(sorted, graph.edges)) == c.pairs.tolist()
    assert [graph.edges[edge]["gap"] for edge in c.pairs.tolist()] == c.gap.tolist()
    assert graph.nodes[7]["pos"] == tuple(cloud[0][7])
    parts = list(networkx.connected_components(graph))
    assert len(parts) == c.clusters().max() + 1
    images = periodic.to_networkx()
    assert images.number_of_edges() == len(periodic)
    assert {tuple(data["shift"]) for _, _, data in images.edges(data=True)} == set(
        map(tuple, periodic.shift.tolist())
    )
    with pytest.raises(abut.UsageError, match="one set"):
        abut.find_contact_pairs(c.elements, c.elements).to_networkx()


def test_xarray(periodic):
    data = periodic.to_xarray()
    assert dict(data.sizes) == {"contact": len(periodic), "axis": 3}
    for name in ("i", "j", "gap", "normal", "point", "shift"):
        assert data[name].values.tolist() == getattr(periodic, name).tolist(), name
    near = data.where(data["gap"] < 0, drop=True)
    assert near.sizes["contact"] == (periodic.gap < 0).sum()
    flat = abut.contacts([[0, 0], [1, 0]], 0.5).to_xarray()
    assert flat["normal"].sel(axis="x").values.tolist() == [1.0]
    assert "shift" not in flat


def test_freud(cloud):
    pytest.importorskip("freud", reason="freud is not among the requirements of the tests")
    c = abut.contacts(*cloud)
    listed = c.to_freud()
    expected = sorted([*map(tuple, c.pairs.tolist()), *((j, i) for i, j in c.pairs.tolist())])
    assert [tuple(pair) for pair in listed[:].tolist()] == expected
    assert np.allclose(listed.distances, np.linalg.norm(listed.vectors, axis=1), rtol=1e-6)
    first, second = np.array(expected).T
    assert np.allclose(listed.vectors, cloud[0][second] - cloud[0][first], atol=1e-6)
    assert listed.neighbor_counts.tolist() == c.coordination().tolist()
    two = abut.find_contact_pairs(abut.points([[0, 0]]), abut.discs([[1, 0], [5, 5]], 1)).to_freud()
    assert two.vectors.tolist() == [[1.0, 0.0, 0.0]]


def test_ovito(periodic):
    reason = "OVITO is not among the requirements of the tests"
    pytest.importorskip("ovito", reason=reason, exc_type=ImportError)
    data = periodic.to_ovito()
    assert np.asarray(data.particles.positions).tolist() == [[0, 0, 0], [3, 0, 0], [2, 2, 2]]
    assert np.asarray(data.particles["Radius"]).tolist() == [0.75, 0.5, 2.25]
    bonds = data.particles.bonds
    assert np.asarray(bonds.topology).tolist() == periodic.pairs.tolist()
    cell = np.asarray(data.cell)[:, :3]
    assert data.cell.pbc == (True, True, True)
    x = np.asarray(data.particles.positions)
    there = x[periodic.j] + np.asarray(bonds["Periodic Image"]) @ cell.T
    assert np.allclose(there - x[periodic.i], periodic.vector)


def test_plot_draws_elements_and_contacts(cloud, periodic):
    flat = abut.contacts(cloud[0][:, :2], cloud[1])
    axes = flat.plot()
    discs, lines = axes.collections
    assert len(discs.get_paths()) == 300
    segments = np.array(lines.get_segments())
    assert np.allclose(segments[:, 0], cloud[0][flat.i, :2])
    assert np.allclose(segments[:, 1], cloud[0][flat.j, :2])
    assert lines.get_array().tolist() == (-flat.gap).tolist()
    assert abut.contacts([[0, 0], [1, 0]], 0.5).plot(axes) is axes
    boxes = abut.find_contact_pairs(abut.rectangles([[0, 0], [1, 0]], [[1, 2], [3, 1]])).plot()
    assert boxes.collections[0].get_datalim(boxes.transData).bounds == (0, 0, 3, 2)
    two = abut.find_contact_pairs(abut.points([[0, 0]]), abut.discs([[1, 0]], 1)).plot()
    assert len(two.collections) == 3
    space = periodic.plot()
    assert space.name == "3d"
    space.figure.canvas.draw()


def test_html_shows_the_first_pairs(cloud):
    text = abut.contacts(*cloud)._repr_html_()
    assert "contact pairs of 300 spheres" in text
    assert text.count("<tr>") == 7
    assert "…" in text
    few = abut.contacts([[0, 0], [1, 0]], 0.5)._repr_html_()
    assert "<td>0</td><td>1</td>" in few
    assert "…" not in few

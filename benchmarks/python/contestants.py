"""How each package answers each task. An answer is the arrays i and j; contacts and half lists name
each pair once, full lists twice."""

import numpy as np

import abut


def _chosen(scene, i, j):
    """The pairs that touch, of those within the reach of the largest spheres."""
    x, r = scene["x"], scene["r"]
    d = x[i] - x[j]
    near = np.einsum("ij,ij->i", d, d) <= (r[i] + r[j]) ** 2
    return i[near], j[near]


def contacts_abut(scene):
    c = abut.contacts(scene["x"], scene["r"])
    return c.i, c.j


def contacts_scipy(scene):
    from scipy.spatial import cKDTree

    pairs = cKDTree(scene["x"]).query_pairs(2 * scene["r"].max(), output_type="ndarray")
    return _chosen(scene, pairs[:, 0], pairs[:, 1])


def contacts_vesin(scene):
    from vesin import NeighborList

    calculator = NeighborList(cutoff=2 * scene["r"].max(), full_list=False)
    i, j, d = calculator.compute(scene["x"], np.eye(3), False, "ijd")
    near = d <= scene["r"][i] + scene["r"][j]
    return i[near], j[near]


def contacts_matscipy(scene):
    from matscipy_neighbours import neighbour_list

    i, j = neighbour_list("ij", positions=scene["x"], cutoff=scene["r"], cell=np.eye(3), pbc=False)
    return i[i < j], j[i < j]


def contacts_ase(scene):
    from ase.neighborlist import primitive_neighbor_list

    i, j = primitive_neighbor_list("ij", [False] * 3, np.eye(3), scene["x"], scene["r"])
    return i[i < j], j[i < j]


def contacts_mdanalysis(scene):
    from MDAnalysis.lib.distances import self_capped_distance

    x = scene["x"].astype(np.float32)
    reach = 2 * scene["r"].max()
    # Left to itself it makes a table of all pairs; its grid takes 100 times as long as its tree.
    method = "pkdtree" if len(x) > 1000 else None
    pairs = self_capped_distance(x, reach, method=method, return_distances=False)
    return _chosen(scene, pairs[:, 0], pairs[:, 1])


def _freud_pairs(x, box, reach):
    import freud

    freud.parallel.set_num_threads(1)
    query = freud.locality.AABBQuery(box, x.astype(np.float32))
    found = query.query(query.points, {"r_max": reach, "exclude_ii": True}).toNeighborList()
    i, j = found[:].T
    return i[i < j], j[i < j]


def contacts_freud(scene):
    import freud

    # It has no open boxes; this one is so wide that no image is in reach.
    reach = 2 * scene["r"].max()
    box = freud.box.Box.cube(2.0 + 4.0 * reach)
    return _chosen(scene, *_freud_pairs(scene["x"] - 0.5, box, reach))


def half_abut(scene):
    cell, x = abut.Domain.lattice(scene["cell"]), abut.points(scene["x"])
    c = abut.find_contact_pairs(x, margin=scene["cutoff"], domain=cell, shifts=False)
    return c.i, c.j


def half_scipy(scene):
    from scipy.spatial import cKDTree

    x = np.mod(scene["x"], scene["cell"][0, 0])
    tree = cKDTree(x, boxsize=scene["cell"].diagonal())
    return tree.query_pairs(scene["cutoff"], output_type="ndarray").T


def half_vesin(scene):
    from vesin import NeighborList

    calculator = NeighborList(cutoff=scene["cutoff"], full_list=False)
    return calculator.compute(scene["x"], scene["cell"], True, "ij")


def half_mdanalysis(scene):
    from MDAnalysis.lib.distances import self_capped_distance

    box = np.append(scene["cell"].diagonal(), [90, 90, 90]).astype(np.float32)
    x = scene["x"].astype(np.float32)
    return self_capped_distance(x, scene["cutoff"], box=box, return_distances=False).T


def half_freud(scene):
    import freud

    side = scene["cell"][0, 0]
    return _freud_pairs(scene["x"] - side / 2, freud.box.Box.cube(side), scene["cutoff"])


def full_abut(scene):
    cell, wanted = abut.Domain.lattice(scene["cell"]), ("distance", "vector")
    n = abut.neighbors(scene["x"], scene["cutoff"], kind="full", domain=cell, quantities=wanted)
    return (n.elements, n.neighbors, n.distances, n.vectors, n.shifts)[:2]


def full_vesin(scene):
    from vesin import NeighborList

    calculator = NeighborList(cutoff=scene["cutoff"], full_list=True)
    return calculator.compute(scene["x"], scene["cell"], True, "ijdDS")[:2]


def full_matscipy(scene):
    from matscipy_neighbours import neighbour_list

    return neighbour_list(
        "ijdDS", positions=scene["x"], cell=scene["cell"], pbc=[True] * 3, cutoff=scene["cutoff"]
    )[:2]


def full_ase(scene):
    from ase.neighborlist import primitive_neighbor_list

    return primitive_neighbor_list(
        "ijdDS", [True] * 3, scene["cell"], scene["x"], scene["cutoff"]
    )[:2]


CONTACTS = {
    "abut": contacts_abut,
    "SciPy": contacts_scipy,
    "vesin": contacts_vesin,
    "matscipy-neighbours": contacts_matscipy,
    "ASE": contacts_ase,
    "MDAnalysis": contacts_mdanalysis,
    "freud": contacts_freud,
}
# With the largest cutoff for all, MDAnalysis and freud take minutes for 100,000 spheres.
MIXED = {name: CONTACTS[name] for name in ("abut", "SciPy", "vesin", "matscipy-neighbours")}
HALF = {
    "abut": half_abut,
    "SciPy": half_scipy,
    "vesin": half_vesin,
    "MDAnalysis": half_mdanalysis,
    "freud": half_freud,
}
FULL = {
    "abut": full_abut,
    "vesin": full_vesin,
    "matscipy-neighbours": full_matscipy,
    "ASE": full_ase,
}

"""Contacts in the forms of other packages."""

from __future__ import annotations

import html
from typing import TYPE_CHECKING, Any

import numpy as np

from ._errors import UsageError

if TYPE_CHECKING:
    import xarray

    from ._contacts import Contacts


def _require_one_set(contacts: Contacts, form: str) -> None:
    if contacts.others is not None:
        raise UsageError(f"{form} is of contacts within one set; these are of two")


def to_networkx(contacts: Contacts) -> Any:
    """A graph of the elements; in a periodic domain one with an edge for each image."""
    import networkx

    _require_one_set(contacts, "a graph")
    is_periodic = contacts.domain.is_periodic
    graph = networkx.MultiGraph() if is_periodic else networkx.Graph()
    places = contacts.elements.positions.tolist()
    graph.add_nodes_from((k, {"pos": tuple(place)}) for k, place in enumerate(places))
    facts: list[dict[str, Any]] = [{"gap": gap} for gap in contacts.gap.tolist()]
    if is_periodic:
        for fact, shift in zip(facts, contacts.shift.tolist(), strict=True):
            fact["shift"] = tuple(shift)
    edges = zip(contacts.i.tolist(), contacts.j.tolist(), facts, strict=True)
    graph.add_edges_from(edges)
    return graph


def to_xarray(contacts: Contacts) -> xarray.Dataset:
    """A data set with the dimension `contact`, and `axis` for vectors."""
    import xarray

    gap, normal, point = contacts.measure("gap", "normal", "point")
    fields: dict[str, Any] = {
        "i": ("contact", contacts.i, {"long_name": "index of the first element"}),
        "j": ("contact", contacts.j, {"long_name": "index of the second element"}),
        "gap": ("contact", gap, {"long_name": "distance of the surfaces"}),
        "normal": (("contact", "axis"), normal, {"long_name": "unit vector from i to j"}),
        "point": (("contact", "axis"), point, {"long_name": "middle of the overlap, beside i"}),
    }
    dimensions = contacts.elements.dimensions
    if contacts.domain.is_periodic:
        shift = contacts.shift[:, :dimensions]
        fields["shift"] = (("contact", "axis"), shift, {"long_name": "image shift of j"})
    return xarray.Dataset(fields, coords={"axis": list("xyz"[:dimensions])})


def to_freud(contacts: Contacts) -> Any:
    """A `freud.locality.NeighborList` with each pair in both directions; of two sets from the
    first, the query points, to the second."""
    import freud

    i, j, vector = contacts.i, contacts.j, contacts.vector
    if contacts.others is None:
        i, j = np.append(i, j), np.append(j, i)
        vector = np.concatenate([vector, -vector])
    order = np.lexsort((j, i))
    flat = np.zeros((len(i), 3), dtype=np.float32)
    flat[:, : vector.shape[1]] = vector[order]
    partners = contacts.elements if contacts.others is None else contacts.others
    return freud.locality.NeighborList.from_arrays(
        len(contacts.elements), len(partners), i[order], j[order], flat
    )


def to_ovito(contacts: Contacts) -> Any:
    """An `ovito.data.DataCollection` of the elements, with their contacts as bonds."""
    from ovito.data import DataCollection

    _require_one_set(contacts, "a data collection")
    elements, dimensions = contacts.elements, contacts.elements.dimensions
    places = np.zeros((len(elements), 3))
    places[:, :dimensions] = elements.positions
    data = DataCollection()
    particles = data.create_particles(count=len(elements))
    particles.create_property("Position", data=places)
    particles.create_property("Radius", data=elements.radii.astype(float))
    bonds = particles.create_bonds(count=len(contacts))
    bonds.create_property("Topology", data=contacts.pairs.astype(np.int64))
    bonds.create_property("Periodic Image", data=contacts.shift)
    bonds.create_property("Gap", data=contacts.gap)
    if contacts.domain.is_periodic:
        x, y, z = (name in contacts.domain.periodic_axes for name in "xyz")
        matrix = np.zeros((3, 4))
        matrix[:, :3] = contacts.domain.vectors.T
        data.create_cell(matrix, pbc=(x, y, z))
    return data


def as_html(contacts: Contacts, most: int = 5) -> str:
    """What notebooks show: the text of `repr`, and the first pairs."""
    title = html.escape(repr(contacts)[1:-1].removeprefix("abut."))
    shown = min(most, len(contacts))
    rows = [f"<tr><td>{i}</td><td>{j}</td></tr>" for i, j in contacts.pairs[:shown].tolist()]
    if len(contacts) > shown:
        rows.append("<tr><td>…</td><td>…</td></tr>")
    algorithm = html.escape(contacts.statistics.algorithm)
    return (
        f"<div><b>{title}</b>, found by <code>{algorithm}</code>"
        f"<table><thead><tr><th>i</th><th>j</th></tr></thead><tbody>{''.join(rows)}</tbody></table>"
        "</div>"
    )

"""Pictures of contacts, by Matplotlib."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np


if TYPE_CHECKING:
    import matplotlib.axes

    from ._contacts import Contacts


def plot(contacts: Contacts, ax: matplotlib.axes.Axes | None) -> matplotlib.axes.Axes:
    """Draws the elements, and a line for each contact from center to center."""
    is_flat = contacts.elements.dimensions == 2
    if ax is None:
        import matplotlib.pyplot as plt

        figure = plt.figure(layout="constrained")
        ax = figure.add_subplot() if is_flat else figure.add_subplot(projection="3d")
    (_plot_plane if is_flat else _plot_space)(contacts, ax)
    ax.set_aspect("equal")
    return ax


def _lines(contacts: Contacts) -> Any:
    """Both ends of each line: the center of i, and that of the image of j that it touches."""
    begin = contacts.elements.positions[contacts.i].astype(float)
    return np.stack([begin, begin + contacts.vector], axis=1)


def _depths(contacts: Contacts) -> Any:
    return np.maximum(-contacts.gap, 0.0)


def _plot_plane(contacts: Contacts, ax: Any) -> None:
    from matplotlib.collections import LineCollection, PatchCollection

    sets = [contacts.elements] if contacts.others is None else [contacts.elements, contacts.others]
    for elements in sets:
        shapes = PatchCollection(_outlines(elements), facecolor="0.92", edgecolor="0.6", zorder=1)
        ax.add_collection(shapes)
    lines = LineCollection(_lines(contacts), array=_depths(contacts), cmap="viridis", zorder=2)
    ax.add_collection(lines)
    ax.autoscale_view()


def _outlines(elements: Any) -> list[Any]:
    from matplotlib.patches import Circle, Rectangle

    middles = elements.positions
    if elements._kind == "spheres":
        return [Circle(*shape) for shape in zip(middles, elements.radii, strict=True)]
    second = elements._second
    upper = np.stack(second, axis=1) if isinstance(second, tuple) else second
    halves = upper - middles
    return [
        Rectangle(tuple(middle - half), 2 * half[0], 2 * half[1])
        for middle, half in zip(middles, halves, strict=True)
    ]


def _plot_space(contacts: Contacts, ax: Any) -> None:
    from mpl_toolkits.mplot3d.art3d import Line3DCollection

    lines = Line3DCollection(_lines(contacts), array=_depths(contacts), cmap="viridis")
    ax.add_collection3d(lines)
    sets = [contacts.elements] if contacts.others is None else [contacts.elements, contacts.others]
    for elements in sets:
        ax.scatter(*elements.positions.T, s=2, color="0.5")

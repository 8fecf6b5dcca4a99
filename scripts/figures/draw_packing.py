#!/usr/bin/env python3
"""Draws a slice through a packing with its contacts, from the tool's own output.

    abut contacts examples/data/yade_settled_5000.csv -o contacts.csv
    scripts/figures/draw_packing.py examples/data/yade_settled_5000.csv contacts.csv \
        docs/images/packing.png
"""

import sys

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import EllipseCollection, LineCollection
from PIL import Image

PLANE = 0.5  # y of the slice
HEIGHT = 0.72  # how much of the packing is shown, from its floor
PAPER, SPHERE, EDGE = "#fbfaf7", "#c9d6e2", "#8fa5b8"


def draw(elements, contacts, picture):
    x, y, z, radius = elements.T
    cut = (np.abs(y - PLANE) < radius) & (z < z.min() + HEIGHT)
    section = np.sqrt(np.maximum(radius**2 - (y - PLANE) ** 2, 0.0))

    first, second = contacts[:, 0].astype(int), contacts[:, 1].astype(int)
    shown = cut[first] & cut[second]
    first, second, overlap = first[shown], second[shown], -contacts[shown, 2]
    lines = np.stack([np.column_stack([x[first], z[first]]),
                      np.column_stack([x[second], z[second]])], axis=1)

    figure, axes = plt.subplots(figsize=(8, 6.2), dpi=110, facecolor=PAPER)
    axes.add_collection(EllipseCollection(
        2 * section[cut], 2 * section[cut], np.zeros(cut.sum()), units="x",
        offsets=np.column_stack([x[cut], z[cut]]), transOffset=axes.transData,
        facecolor=SPHERE, edgecolor=EDGE, linewidth=0.6))
    strength = np.sqrt(overlap / overlap.max())
    axes.add_collection(LineCollection(
        lines, linewidths=0.5 + 5.0 * strength, colors="#c2410c", capstyle="round"))
    axes.plot(x[cut], z[cut], ".", color="#1f2937", markersize=2.2)

    axes.set_aspect("equal")
    axes.set_xlim(x.min() - radius.max(), x.max() + radius.max())
    axes.set_ylim(z.min() - radius.max(), (z + section)[cut].max() + 0.01)
    axes.axis("off")
    figure.subplots_adjust(0.01, 0.01, 0.99, 0.99)
    figure.canvas.draw()
    pixels = Image.fromarray(np.asarray(figure.canvas.buffer_rgba())).convert("RGB")
    pixels.quantize(64).save(picture, optimize=True)  # a fifth of the bytes
    print(f"{cut.sum()} spheres are cut, {shown.sum()} contacts drawn")


def main():
    elements_file, contacts_file, picture = sys.argv[1:]
    draw(np.loadtxt(elements_file, delimiter=",", skiprows=1),
         np.loadtxt(contacts_file, delimiter=",", skiprows=1), picture)


if __name__ == "__main__":
    main()

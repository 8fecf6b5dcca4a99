"""Plots of ns for an element by scene and contestant, against N, and of threads:
docs/images/matrix_*.svg."""

import math
import os

from matplotlib.lines import Line2D

from benchmarks.common.plots import plt, save
from benchmarks.matrix.data import DEFAULT

# Okabe and Ito's colours, told apart by everybody; what is not named here stays grey.
STYLE = {
    "memcpy": ("#999999", "_"),
    "plain_grid": ("#000000", "s"),
    "abut_auto": ("#d55e00", "o"),
    "abut_rows": ("#d55e00", "*"),
    "cgal_box": ("#0072b2", "v"),
    "nanoflann": ("#56b4e9", "^"),
    "embree_morton": ("#009e73", "<"),
    "embree_sah": ("#00563f", ">"),
    "boost_rtree": ("#cc79a7", "D"),
    "bullet_dbvt": ("#e69f00", "P"),
    "fcl": ("#f0e442", "X"),
    "scipy_ckdtree": ("#8c6bb1", "h"),
}
OF_THE_BOOK = ("#7f7f7f", ".")
OF_THREADS = ["#d55e00", "#0072b2", "#009e73", "#cc79a7"]


def style(contestant):
    return STYLE.get(contestant, OF_THE_BOOK)


def name(contestant):
    return contestant.replace("abut_auto", "abut (auto)").replace("abut_", "abut, ")


def task_of(contestant):
    return "copy" if contestant == "memcpy" else "list"


def offsets(matrix):
    """Where in a column each contestant's mark stands, so that they do not hide one another."""
    packages = matrix.packages
    step = 0.6 / max(len(packages) - 1, 1)
    return {c: step * k - 0.3 for k, c in enumerate(packages)}


def plot_scenes(matrix, folder):
    """A column for each scene, a mark for each contestant."""
    figure, axes = plt.subplots(figsize=(9.5, 5))
    offset = offsets(matrix)
    labelled = set()
    for contestant in matrix.contestants:
        points = []
        for place, scene in enumerate(matrix.scenes):
            ns = matrix.ns(scene, matrix.main_count(scene), contestant, task=task_of(contestant))
            if ns:
                points.append((place + offset.get(contestant, 0.0), ns))
        if not points:
            continue
        color, marker = style(contestant)
        label = name(contestant) if color != OF_THE_BOOK[0] else "abut, of the book"
        axes.plot(*zip(*points), marker=marker, color=color, ls="none", zorder=3,
                  ms=8 if contestant in (DEFAULT, "plain_grid") else 5,
                  mec="black" if contestant == "fcl" else color, mew=2 if marker == "_" else 0.6,
                  label=None if label in labelled else label)
        labelled.add(label)
    count = max(matrix.main_count(scene) for scene in matrix.scenes)
    labels = [scene if matrix.main_count(scene) == count
              else f"{scene}\nN = {matrix.main_count(scene):,}" for scene in matrix.scenes]
    axes.set_xticks(range(len(labels)))
    axes.set_xticklabels(labels, rotation=35, ha="right")
    axes.set(yscale="log", ylabel="ns for each element", xlim=(-0.6, len(labels) - 0.4),
             title=f"All contact pairs of {count:,} elements, one thread")
    axes.legend(fontsize=8, loc="upper left", bbox_to_anchor=(1.0, 1.0))
    save(figure, folder, "matrix_scenes.svg")


def draw_line(axes, points, contestant):
    """How one contestant's time follows N: abut and the plain grid with marks, the others thin."""
    color, marker = style(contestant)
    strong = contestant in (DEFAULT, "plain_grid")
    axes.plot(*zip(*points), color=color, marker=marker if strong or len(points) == 1 else None,
              ms=4, lw=2.2 if strong else 1.1, label=name(contestant))


def plot_scaling(matrix, folder):
    """A panel for each scene: how the time for each element follows N."""
    columns = 5
    rows = math.ceil(len(matrix.scenes) / columns)
    figure, grid = plt.subplots(rows, columns, figsize=(10, 2.2 * rows), sharex=True, sharey=True,
                                squeeze=False)
    panels = [axes for line in grid for axes in line]
    # `rows` is what `auto` takes in nearly every case: its line would lie below that one.
    shown = [c for c in matrix.contestants
             if c not in ("memcpy", "control_loop", "abut_rows") and style(c) != OF_THE_BOOK]
    for axes, scene in zip(panels, matrix.scenes):
        for contestant in shown:
            points = [(n, matrix.ns(scene, n, contestant)) for n in matrix.counts]
            points = [p for p in points if p[1]]
            if points:
                draw_line(axes, points, contestant)
        axes.set_title(scene, fontsize=9)
        axes.set(xscale="log", yscale="log")
        axes.minorticks_off()
    for axes in panels[len(matrix.scenes):]:
        axes.set_visible(False)
    for line in grid:
        line[0].set_ylabel("ns for each element")
    for axes in grid[-1]:
        axes.set_xlabel("elements N")
    legend_of_lines(figure, shown)
    save(figure, folder, "matrix_scaling.svg")


def legend_of_lines(figure, contestants):
    handles = []
    for contestant in contestants:
        color, marker = style(contestant)
        strong = contestant in (DEFAULT, "plain_grid")
        handles.append(Line2D([], [], color=color, marker=marker if strong else None, ms=4,
                              lw=2.2 if strong else 1.1, label=name(contestant)))
    figure.tight_layout(rect=(0, 0.06, 1, 1))
    figure.legend(handles=handles, loc="lower center", ncol=6, fontsize=8)


def plot_threads(matrix, folder):
    """A row for each scene, a mark for each number of threads at its speedup; no marks if nothing
    runs in several."""
    count = matrix.counts[-1]
    figure, axes = plt.subplots(figsize=(5.5, 0.24 * len(matrix.scenes) + 1.2))
    for place, threads in enumerate(matrix.threads[1:]):
        points = []
        for row, scene in enumerate(matrix.scenes):
            one = matrix.ns(scene, count, DEFAULT)
            several = matrix.ns(scene, count, DEFAULT, threads=threads)
            if one and several:
                points.append((one / several, row))
        color = OF_THREADS[place % len(OF_THREADS)]
        axes.axvline(threads, color=color, lw=0.8, ls=":")
        if points:
            axes.plot(*zip(*points), marker="o", color=color, ls="none", ms=6, clip_on=False,
                      label=f"{threads} threads")
    title = f"abut (auto), N = {count:,}"
    if len(matrix.threads) == 2:
        title += f", {matrix.threads[1]} threads"
    axes.set_yticks(range(len(matrix.scenes)))
    axes.set_yticklabels(matrix.scenes)
    axes.invert_yaxis()
    axes.set(xlabel="times as fast as one thread (dotted: ideal)",
             xlim=(min(0.9, axes.get_xlim()[0]), 1.05 * max(matrix.threads[-1], 2)), title=title)
    if len(matrix.threads) > 2:
        axes.legend(fontsize=8, loc="lower left")
    save(figure, folder, "matrix_threads.svg")


def plot_all(matrix, folder):
    os.makedirs(folder, exist_ok=True)
    plot_scenes(matrix, folder)
    plot_scaling(matrix, folder)
    plot_threads(matrix, folder)

"""Plots of ns per element by scene and contestant, and against N and threads:
docs/images/matrix_*.svg."""

import math
import os

from benchmarks.matrix.data import DEFAULT, YARDSTICKS
from benchmarks.common.tables import plt, save

# Okabe and Ito's colours, told apart by everybody; what is not named here stays grey.
STYLE = {
    "memcpy": ("#999999", "_"),
    "plain_grid": ("#000000", "s"),
    "abut_auto": ("#d55e00", "o"),
    "abut_rows": ("#d55e00", "*"),
    "cgal_box": ("#0072b2", "v"),
    "nanoflann": ("#56b4e9", "^"),
    "embree_morton": ("#009e73", "<"),
    "embree_sah": ("#009e73", ">"),
    "boost_rtree": ("#cc79a7", "D"),
    "bullet_dbvt": ("#e69f00", "P"),
    "fcl": ("#f0e442", "X"),
    "scipy_ckdtree": ("#8c6bb1", "h"),
}
OF_THE_BOOK = ("#7f7f7f", ".")


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


def plot_scaling(matrix, folder):
    """A panel for each scene: how the time for each element follows N."""
    columns = 5
    rows = math.ceil(len(matrix.scenes) / columns)
    figure, grid = plt.subplots(rows, columns, figsize=(10, 2.2 * rows), sharex=True, sharey=True,
                                squeeze=False)
    panels = [axes for line in grid for axes in line]
    for axes, scene in zip(panels, matrix.scenes):
        for contestant in matrix.contestants:
            if contestant in YARDSTICKS[:1] or style(contestant) == OF_THE_BOOK:
                continue
            points = [(n, matrix.ns(scene, n, contestant)) for n in matrix.counts]
            points = [p for p in points if p[1]]
            if not points:
                continue
            color, marker = style(contestant)
            width = 2.2 if contestant in (DEFAULT, "plain_grid") else 1.0
            axes.plot(*zip(*points), color=color, marker=marker, ms=4, lw=width,
                      label=name(contestant))
        axes.set_title(scene, fontsize=9)
        axes.set(xscale="log", yscale="log")
        axes.minorticks_off()
    for axes in panels[len(matrix.scenes):]:
        axes.set_visible(False)
    for line in grid:
        line[0].set_ylabel("ns for each element")
    for axes in grid[-1]:
        axes.set_xlabel("elements N")
    by_label = {}
    for axes in panels[: len(matrix.scenes)]:
        for handle, text in zip(*axes.get_legend_handles_labels()):
            by_label.setdefault(text, handle)
    figure.tight_layout(rect=(0, 0.06, 1, 1))
    figure.legend(by_label.values(), by_label.keys(), loc="lower center", ncol=6, fontsize=8)
    save(figure, folder, "matrix_scaling.svg")


def plot_threads(matrix, folder):
    """Speedup by threads, a line for each scene; an empty plot if nothing runs in several."""
    figure, axes = plt.subplots(figsize=(5, 3.6))
    most = max(matrix.threads)
    axes.plot([1, most], [1, most], color="black", lw=0.8, ls=":", label="ideal")
    for place, scene in enumerate(matrix.scenes):
        count = matrix.counts[-1]
        one = matrix.ns(scene, count, DEFAULT)
        points = [(t, one / matrix.ns(scene, count, DEFAULT, threads=t)) for t in matrix.threads
                  if one and matrix.ns(scene, count, DEFAULT, threads=t)]
        if len(points) > 1:
            # Ten colours, then the same with another mark and line.
            marker, line = ("o", "-") if place < 10 else ("s", "--")
            axes.plot(*zip(*points), color=f"C{place % 10}", marker=marker, ls=line, ms=4, lw=1.2,
                      label=scene)
    axes.set(xlabel="threads, one on each core", ylabel="speedup",
             title=f"abut (auto), N = {matrix.counts[-1]:,}")
    axes.set_xticks(matrix.threads)
    axes.legend(fontsize=7, loc="upper left", bbox_to_anchor=(1.0, 1.0))
    save(figure, folder, "matrix_threads.svg")


def plot_all(matrix, folder):
    os.makedirs(folder, exist_ok=True)
    plot_scenes(matrix, folder)
    plot_scaling(matrix, folder)
    plot_threads(matrix, folder)

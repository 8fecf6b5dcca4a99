"""The style of the plots, and saving them. Needs matplotlib."""

import io
import os

import matplotlib

from benchmarks.common.small_svg import small

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

plt.rcParams.update(
    {
        "font.size": 9,
        "font.family": ["DejaVu Sans"],
        "axes.spines.top": False,
        "axes.spines.right": False,
        "axes.grid": True,
        "grid.color": "#e5e5e5",
        "svg.hashsalt": "abut",
        "svg.fonttype": "none",
        "legend.frameon": False,
    }
)


def save(figure, folder, name):
    """Writes a picture as SVG, without what matplotlib puts in and nobody needs."""
    drawn = io.BytesIO()
    figure.savefig(drawn, format="svg", metadata={"Date": None}, bbox_inches="tight",
                   facecolor="white")
    plt.close(figure)
    path = os.path.join(folder, name)
    with open(path, "w", encoding="utf-8") as file:
        file.write(small(drawn.getvalue()))
    print(path)

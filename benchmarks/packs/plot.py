"""Plots of time and memory against number of elements and spacing: docs/images/packs_*.svg."""

import os

from benchmarks.common.plots import plt, save
from benchmarks.packs.data import LOOSE_PACKS, ROMAN, book_integers

# Okabe and Ito's colours, told apart by everybody.
STYLE = {
    "direct_check": ("#7f7f7f", "x"),
    "binary_tree": ("#cc79a7", "^"),
    "screening_array": ("#e69f00", "s"),
    "sorting_array": ("#0072b2", "D"),
    "munjiza_nbs": ("#009e73", "o"),
}
OTHERS = ("#d55e00", "v")


def line(axes, algorithm, xs, ys, **more):
    color, marker = STYLE.get(algorithm, OTHERS)
    width = 2.2 if algorithm == "munjiza_nbs" else 1.3
    axes.plot(xs, ys, color=color, marker=marker, ms=4.5, lw=width, label=algorithm, **more)


def series(packs, value, key, **wanted):
    """For each algorithm the points that were not refused."""
    for algorithm in packs.algorithms:
        rows = packs.select(algorithm=algorithm, form="count", **wanted)
        rows = sorted((r for r in rows if r["refusal"] == ""), key=lambda r: r[key])
        if rows:
            yield algorithm, [r[key] for r in rows], [value(r) for r in rows]


def bytes_each(row):
    return row["peak_bytes"] / row["elements"]


def plot_against_elements(packs, folder):
    figure, (time, memory) = plt.subplots(1, 2, figsize=(9, 3.6), gridspec_kw={"wspace": 0.32})
    for algorithm, xs, ys in series(packs, lambda r: r["ns_minimum"], "elements", pack=1):
        line(time, algorithm, xs, ys)
    for algorithm in packs.algorithms:
        row = packs.one(pack=1, algorithm=algorithm, numbering="shuffled")
        if row:
            color, marker = STYLE.get(algorithm, OTHERS)
            time.plot(row["elements"], row["ns_minimum"], marker, color=color, mfc="white", ms=6)
    time.plot([], [], "o", color="black", mfc="white", label="numbers shuffled")
    time.axhline(40, color="black", lw=0.8, ls=":")
    time.text(1.01, 40, "40 ns", va="center", fontsize=8, transform=time.get_yaxis_transform())
    time.plot([100, 90_000], [6_700, 6_700], color="black", lw=0.8, ls="--")
    time.text(110_000, 6_700, "NBS in 1998", va="center", fontsize=8)
    time.set(xscale="log", yscale="log", xlabel="elements N", title="Pack I: time")
    time.set_ylim(15, 300_000)
    time.set_ylabel("ns for each element and detection")
    time.legend(fontsize=8, ncol=2, loc="upper left")
    for algorithm, xs, ys in series(packs, bytes_each, "elements", pack=1):
        line(memory, algorithm, xs, ys)
    memory.set(xscale="log", xlabel="elements N", title="Pack I: memory", ylim=(0, None))
    memory.set_ylabel("bytes for each element")
    save(figure, folder, "packs_elements.svg")


def plot_against_spacing(packs, folder):
    figure, axes = plt.subplots(2, 3, figsize=(9, 5.6), sharex=True, sharey="row")
    for column, pack in enumerate(LOOSE_PACKS):
        time, memory = axes[:, column]
        for algorithm, xs, ys in series(packs, lambda r: r["ns_minimum"], "spacing", pack=pack):
            line(time, algorithm, xs, ys)
        for algorithm, xs, ys in series(packs, bytes_each, "spacing", pack=pack):
            line(memory, algorithm, xs, ys)
        rows = packs.select(pack=pack, algorithm="munjiza_nbs", form="count")
        memory.plot(
            [r["spacing"] for r in rows],
            [4 * book_integers(r) for r in rows],
            color=STYLE["munjiza_nbs"][0],
            ls=":",
            label="lists of munjiza_nbs, by formula",
        )
        time.set(xscale="log", yscale="log", title=f"Pack {ROMAN[pack]}, N = 10,000")
        memory.set(xscale="log", yscale="log", xlabel="spacing S/D")
        memory.set_xticks([1, 2, 5, 10, 20, 50, 100, 200])
        memory.set_xticklabels(["1", "2", "5", "10", "20", "50", "100", "200"])
        memory.minorticks_off()
    axes[0, 0].set_ylabel("ns for each element and detection")
    axes[1, 0].set_ylabel("bytes for each element")
    handles, labels = axes[1, 0].get_legend_handles_labels()
    figure.tight_layout(rect=(0, 0.07, 1, 1))
    figure.legend(handles, labels, loc="lower center", ncol=6, fontsize=8)
    save(figure, folder, "packs_spacing.svg")


def plot_all(packs, folder):
    os.makedirs(folder, exist_ok=True)
    plot_against_elements(packs, folder)
    plot_against_spacing(packs, folder)

"""The figure of two layers, and of the five runs of an element in three vectors."""

from svg import ADJACENT, CENTRAL, FAINT, INK, MARKED, PAPER, Drawing

LAYERS_DRAWN = [  # (column, row) of the elements of two layers
    {1: (2.1, 0), 2: (9.3, 0), 3: (14.5, 0), 4: (1.2, 1), 5: (6.5, 1), 6: (8.2, 1), 7: (10.4, 1),
     8: (13.6, 1), 9: (0.6, 2), 10: (3.2, 2), 11: (5.3, 2), 12: (9.4, 2), 13: (12.6, 2)},
    {14: (3.4, 0), 15: (6.7, 0), 16: (12.4, 0), 17: (2.3, 1), 18: (5.5, 1), 19: (9.8, 1),
     20: (14.4, 1), 21: (1.1, 2), 22: (4.8, 2), 23: (7.4, 2), 24: (10.7, 2), 25: (13.5, 2)}]
PADDING = "·"


def runs_of_five():
    """The five runs of element 5, with four columns in a reach, as src/kernels/layers/ has them."""
    column, reach = 6, 4

    def run(layer, row, first):
        return [e for e, (c, r) in LAYERS_DRAWN[layer].items()
                if r == row and first <= int(c) <= column + reach and e != 5]

    return [run(0, 1, column), run(0, 2, column - reach)] + [
        run(1, row, column - reach) for row in (0, 1, 2)]


def layer_grids(d, fills):
    width, cell, top = 17, 68, 52
    for layer, left in [(0, 70), (1, 452)]:
        d.text(left + 8 * width, 24, ["layer z", "layer z + 1"][layer], 13)
        for row, name in enumerate(["y − 1", "y", "y + 1"]):
            y = top + (2 - row) * cell
            first, last = (6, 11) if (layer, row) == (0, 1) else (2, 11)
            if (layer, row) != (0, 0):
                run = [0, 1][row - 1] if layer == 0 else 2 + row
                d.rect(left + first * width, y, (last - first) * width, cell,
                       ADJACENT if run in (0, 2, 4) else MARKED, "none")
                d.text(left + (last - 1.4) * width, y + cell - 9, f"run {run}", 10)
            d.text(left - 8, y + cell / 2, name, 12, "end", FAINT)
        for k in range(17):
            d.line(left + k * width, top, left + k * width, top + 3 * cell, FAINT,
                   1 if k % 4 == 0 else 0.3)
        for k in range(4):
            d.line(left, top + k * cell, left + 16 * width, top + k * cell, FAINT, 1)
        for e, (column, row) in LAYERS_DRAWN[layer].items():
            x, y = left + column * width, top + (2.5 - row) * cell + 17 * (e % 3 - 1)
            d.circle(x, y, 9, fills.get(e, PAPER))
            d.text(x, y, e, 10)


def layer_filter():
    d = Drawing(800, 506, "Two layers sorted by row and column, and the three vectors of an element")
    runs = runs_of_five()
    fills = {e: ADJACENT if k % 2 == 0 else MARKED for k, run in enumerate(runs) for e in run}
    fills[5] = CENTRAL
    layer_grids(d, fills)

    def fill_of(e):
        return fills.get(e, "#e5e7eb" if e == PADDING else PAPER)

    order, width, left, y = [], 24, 28, 312
    for layer in LAYERS_DRAWN:
        for row in range(3):
            order += [e for e, (_, r) in layer.items() if r == row] + [PADDING]
    at = {}
    d.text(left, y - 14, "places: row by row, each with eight places of padding (·) behind it", 12,
           "start")
    for k, e in enumerate(order):
        at[e] = left + k * width
        d.rect(at[e], y, width, 24, fill_of(e))
        d.text(at[e] + width / 2, y + 12, e, 12)
    top = 412
    for (first, second), x in [(runs[0:2], 60), (runs[2:4], 306), ([runs[4], []], 552)]:
        lanes = first + second
        begin = order.index(lanes[-1]) + 1
        behind = (order[begin:order.index(PADDING, begin)] + [PADDING] * 8)[:8 - len(lanes)]
        for run, to in [(first, 0), (second, len(first))]:
            if run:
                d.arrow((at[run[0]] + at[run[-1]] + width) / 2, y + 26,
                        x + (to + len(run) / 2) * width, top - 3)
        for k, e in enumerate(lanes + behind):
            d.rect(x + k * width, top, width, 24, fill_of(e))
            d.text(x + (k + 0.5) * width, top + 12, e, 12, color=INK if e in lanes else FAINT)
    for x, text in [(60, "runs 0 and 1"), (306, "runs 2 and 3"), (552, "run 4")]:
        d.text(x + 4 * width, top + 40, text, 12)
    for k, line in enumerate(["Element 5 and its five runs; four columns are in a reach, K = 4.",
                              "Grey: what a vector reads behind its runs, out of reach along the row."]):
        d.text(28, 474 + 18 * k, line, 12, "start")
    return d

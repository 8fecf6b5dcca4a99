"""The figures of docs/algorithms/rows.md: tiles with their copies, and one block of cells."""

from svg import ADJACENT, CENTRAL, FAINT, INK, PAPER, Drawing, Grid

CELLS_PER_BLOCK = 3


def sorted_by_cell(cells):
    """Element numbers by row, then cell, then number."""
    return sorted(cells, key=lambda e: (cells[e][1], cells[e][0], e))


def blocks(cells, columns):
    """[(row, first cell, central elements, all candidates)] as src/kernels/tiles/tile_search-inl.hpp."""
    order = sorted_by_cell(cells)

    def run(row, first, last):
        return [e for e in order if cells[e][1] == row and first <= cells[e][0] <= last]

    found = []
    for row in sorted({y for _, y in cells.values()}):
        for first in range(1, columns + 1, CELLS_PER_BLOCK):
            last = min(first + CELLS_PER_BLOCK - 1, columns)
            central = run(row, first, last)
            if central:
                found.append((row, first, central,
                              run(row, first, last + 1) + run(row + 1, first - 1, last + 1)))
    return found


def rows_tiles():
    d = Drawing(760, 336, "Rows: tiles, and the copies that one of them gets")
    side, left, top = 88, 30, 44
    d.text(left + 1.5 * side, 22, "the box of the centres, cut into tiles", 13)
    for row in range(3):
        for column in range(3):
            d.rect(left + column * side, top + (2 - row) * side, side, side)
            d.text(left + (column + 1) * side - 12, top + (2 - row) * side + 12, 3 * row + column,
                   12, color=FAINT)
    d.rect(left + side, top + side, side, side, CENTRAL)
    band = 15
    d.rect(left + 2 * side, top + side, band, side, ADJACENT)
    d.rect(left + side, top + side - band, side, band, ADJACENT)
    d.rect(left + 2 * side, top + side - band, band, band, ADJACENT)
    d.rect(left + side - band, top + side - band, band, band, ADJACENT)
    d.text(left + 1.5 * side, top + 1.5 * side, "tile 4", 14)
    for dx, dy in [(48, 0), (0, -48), (48, -48), (-48, -48)]:
        d.arrow(left + 1.5 * side + dx * 1.32, top + 1.5 * side + dy * 1.32,
                left + 1.5 * side + dx * 0.62, top + 1.5 * side + dy * 0.62)
    left, top, side, own = 360, 58, 26, 6
    d.text(left + (own + 2) / 2 * side, 22, "tile 4, sorted by cell", 13)
    for row in range(own + 2):
        for column in range(own + 2):
            is_own = 1 <= row <= own and 1 <= column <= own
            copies = row == own + 1 or column == own + 1 and row >= 1
            d.rect(left + column * side, top + (own + 1 - row) * side, side, side,
                   CENTRAL if is_own else ADJACENT if copies else PAPER, FAINT, 0.8)
    d.rect(left + side, top + side, own * side, own * side, "none", INK, 1.8)
    for column, name in [(0, 0), (1, 1), (own, "k"), (own + 1, "k + 1")]:
        d.text(left + (column + 0.5) * side, top + (own + 2) * side + 12, name, 11, color=FAINT)
    x = 590
    for y, fill, lines in [(84, CENTRAL, ["own elements"]),
                           (120, ADJACENT, ["copies from the tiles", "after it: 5, 6, 7, 8"]),
                           (172, PAPER, ["empty: tiles 0 to 3", "get copies of *its*", "elements"])]:
        d.rect(x, y - 8, 16, 16, fill, FAINT)
        for k, line in enumerate(lines):
            d.text(x + 26, y + 17 * k, line.replace("*", ""), 12, "start")
    d.text(30, 322, "Cells drawn larger than they are: 18 and more along a side.", 11, "start", FAINT)
    return d


def rows_block(cells):
    d = Drawing(780, 396, "Rows: the runs of one block of three cells")
    grid = Grid(d, 40, 46, 34, 10, 4)
    row, first, central, candidates = next(b for b in blocks(cells, 10) if b[:2] == (6, 4))
    for column in range(first, first + CELLS_PER_BLOCK):
        grid.shade(column, row - 4, CENTRAL)
    grid.shade(first + CELLS_PER_BLOCK, row - 4, ADJACENT)
    for column in range(first - 1, first + CELLS_PER_BLOCK + 1):
        grid.shade(column, row - 3, ADJACENT)
    grid.lines()
    grid.elements({e: (x, y - 4) for e, (x, y) in cells.items()}, 9)
    for k in range(4):
        d.text(28, grid.center(1, k + 1)[1], k + 5, 11, color=FAINT)
    for column in range(1, 11):
        d.text(grid.center(column, 1)[0], 193, column, 11, color=FAINT)
    d.text(210, 22, "a block: cells 4 to 6 of row 6", 13)

    order, left, width = sorted_by_cell(cells), 130, 44
    d.text(left - 12, 244, "number", 13, "end")
    d.boxes(left, 232, order, width,
            fills=[CENTRAL if e in central else ADJACENT if e in candidates else PAPER
                   for e in order])
    for k, e in enumerate(order):
        d.text(left + (k + 0.5) * width, 267, f"{cells[e][0]},{cells[e][1]}", 11, color=FAINT)
    d.text(left - 12, 267, "cell", 11, "end", FAINT)
    d.text(left + 10 * width + 12, 244, "the tile: a run for each row", 12, "start")
    d.text(left - 12, 316, "buffer", 13, "end")
    d.boxes(left, 304, candidates, width,
            fills=[CENTRAL if e in central else ADJACENT for e in candidates])
    d.text(left + 10 * width + 12, 316, "what the block meets", 12, "start")
    runs = [(order.index(central[0]), 0, len(central)),
            (order.index(candidates[len(central)]), len(central), len(candidates) - len(central))]
    for source, target, count in runs:
        middle = count / 2
        d.arrow(left + (source + middle) * width, 276, left + (target + middle) * width, 301)
    for k, e in enumerate(central):
        y = 342 + 16 * k
        d.line(left + (k + 0.5) * width, 328, left + (k + 0.5) * width, y)
        d.arrow(left + (k + 0.5) * width, y, left + len(candidates) * width, y)
        d.text(left + len(candidates) * width + 8, y, f"element {e}: {len(candidates) - k - 1} tests",
               11, "start")
    return d

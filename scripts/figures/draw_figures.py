#!/usr/bin/env python3
"""Redraws the figures of the algorithm pages, from the book's example systems, and those of the
derivations:

    scripts/figures/draw_figures.py [folder]

Elements and cells are counted from 1, as in A. Munjiza, The Combined Finite-Discrete Element
Method, Wiley 2004, chapter 3. Each list is built here and compared with the book's numbers.
"""

import pathlib
import sys

import derivations
from rows_figures import blocks, rows_block, rows_tiles
from svg import ADJACENT, CENTRAL, FAINT, INK, MARKED, PAPER, Drawing, Grid, minus

IMAGES = pathlib.Path(__file__).resolve().parents[2] / "docs" / "images"

SCREENING = {1: (5, 7), 2: (5, 7), 3: (2, 7), 4: (5, 7), 5: (2, 7), 6: (5, 6), 7: (2, 7),
             8: (6, 6), 9: (2, 7)}
SORTING = {1: (4, 7), 2: (5, 8), 3: (4, 6), 4: (5, 7), 5: (4, 5), 6: (5, 6), 7: (3, 7), 8: (6, 6)}
NBS = {**SORTING, 9: (3, 6), 10: (4, 7)}


def lists(elements, key):
    """{key: elements}, each pushed in front."""
    heads = {}
    for element in elements:
        heads.setdefault(key(element), []).insert(0, element)
    return heads


def next_of(heads, count):
    """The array "next", for elements 1 to count."""
    following = [-1] * count
    for members in heads.values():
        for element, successor in zip(members, members[1:]):
            following[element - 1] = successor
    return following


def require(drawn, book):
    """The figure must say what the book says."""
    if drawn != book:
        raise SystemExit(f"drawn {drawn}, but the book has {book}")


def contact_mask():
    d = Drawing(640, 226, "The contact mask in 2D and 3D")
    flat = Grid(d, 40, 50, 44, 3, 3)
    for cell in [(1, 1), (2, 1), (3, 1), (1, 2)]:
        flat.shade(*cell, ADJACENT)
    flat.shade(2, 2, CENTRAL)
    flat.lines()
    d.text(106, 28, "2D: central cell and 4", 13)
    for left, caption, cells in [
            (250, "3D: its own layer, 4", [(1, 1), (2, 1), (3, 1), (1, 2)]),
            (452, "the layer below, 9", [(i, j) for i in (1, 2, 3) for j in (1, 2, 3)])]:
        grid = Grid(d, left, 50, 44, 3, 3)
        for cell in cells:
            grid.shade(*cell, ADJACENT)
        if left == 250:
            grid.shade(2, 2, CENTRAL)
        grid.lines()
        d.text(left + 66, 28, caption, 13)
    d.rect(40, 196, 14, 14, CENTRAL)
    d.text(60, 203, "central cell", 12, "start")
    d.rect(150, 196, 14, 14, ADJACENT)
    d.text(170, 203, "cells of the mask: half of the neighbours", 12, "start")
    return d


def direct_check():
    d = Drawing(640, 232, "Direct checking: every element against those that follow it")
    at = {1: (60, 70), 2: (118, 92), 3: (196, 60), 4: (92, 176), 5: (212, 166)}
    touching = {(1, 2)}
    for i in at:
        d.circle(*at[i], 32, "#eef3f8", FAINT)
    for i in at:
        for j in at:
            if i < j:
                hit = (i, j) in touching
                d.line(*at[i], *at[j], INK if hit else FAINT, 3 if hit else 0.9,
                       "" if hit else "4 3")
    for i in at:
        d.circle(*at[i], 10)
        d.text(*at[i], i, 12)
    left, top, side = 360, 44, 30
    d.text(left + 2.5 * side, 16, "j", 13)
    d.text(left - 30, top + 2.5 * side, "i", 13)
    for k in range(1, 6):
        d.text(left + (k - 0.5) * side, top - 11, k, 11, color=FAINT)
        d.text(left - 11, top + (k - 0.5) * side, k, 11, color=FAINT)
    for i in range(1, 6):
        for j in range(1, 6):
            fill = PAPER if j <= i else (CENTRAL if (i, j) in touching else ADJACENT)
            d.rect(left + (j - 1) * side, top + (i - 1) * side, side, side, fill, FAINT, 0.8)
    d.text(left + 2.5 * side, top + 5 * side + 20, "(N² − N) / 2 = 10 checks", 12)
    d.text(136, 218, "thick: the one pair that touches", 12)
    return d


def binary_tree():
    d = Drawing(800, 330, "Binary tree: occupied cells as leaves")
    cells = {1: (4, 4), 2: (1, 1), 3: (2, 3), 4: (3, 1), 5: (2, 3), 6: (1, 4), 7: (2, 3),
             8: (4, 1), 9: (2, 3)}
    heads = lists(cells, cells.get)
    require(next_of(heads, 9), [-1, -1, -1, -1, 3, -1, 5, -1, 7])
    grid = Grid(d, 34, 60, 44, 4, 4)
    for cell in heads:
        grid.shade(*cell, ADJACENT)
    grid.shade(2, 3, CENTRAL)
    grid.lines()
    d.line(122, 60, 122, 236, INK, 2.4)
    d.line(34, 148, 210, 148, INK, 1.6)
    grid.elements(cells)
    d.text(122, 36, "halvings: x, y, x, y", 13)

    def path_to(cell):
        """0 for left or lower, 1 for right or upper, x and y in turn."""
        x, y = cell[0] - 1, cell[1] - 1
        return f"{x >> 1}{y >> 1}{x & 1}{y & 1}"

    leaves = {path_to(cell): members for cell, members in heads.items()}
    at = {path: 310 + 76 * k for k, path in enumerate(sorted(leaves))}
    for length in (3, 2, 1, 0):
        for node in sorted({path[:length] for path in leaves}):
            children = [at[node + bit] for bit in "01" if node + bit in at]
            at[node] = sum(children) / len(children)
    for path, x in at.items():
        y = 40 + 52 * len(path)
        if path:
            above = at[path[:-1]]
            d.line(above, y - 52, x, y)
            d.circle((above + x) / 2, y - 26, 7, PAPER, "none")
            d.text((above + x) / 2, y - 26, path[-1], 10, color=FAINT)
    for path, x in at.items():
        y = 40 + 52 * len(path)
        if path in leaves:
            d.rect(x - 15, y - 12, 30, 24, CENTRAL if len(leaves[path]) > 1 else ADJACENT)
            d.text(x, y, leaves[path][0])
        else:
            d.circle(x, y, 7, MARKED)
    for level, name in enumerate(["x", "y", "x", "y", "HEAD"]):
        d.text(784, 40 + 52 * level, name, 12, "end", FAINT)
    d.chain(440, 300, "HEAD of cell (2,3)", heads[(2, 3)])
    return d


def screening_array():
    heads = lists(SCREENING, SCREENING.get)
    e = next_of(heads, 9)
    require(e, [-1, 1, -1, 2, 3, -1, 5, -1, 7])
    require({c: m[0] for c, m in heads.items()}, {(5, 7): 4, (5, 6): 6, (6, 6): 8, (2, 7): 9})
    d = Drawing(820, 490, "Screening array: a list for every cell")
    grid = Grid(d, 40, 46, 32, 10, 10)
    for cell in heads:
        grid.shade(*cell, ADJACENT)
    grid.lines()
    grid.numbers()
    grid.elements(SCREENING, 6.6, 10)
    d.text(200, 22, "the cells and their elements", 13)
    matrix = Grid(d, 452, 46, 32, 10, 10)
    for cell in heads:
        matrix.shade(*cell, ADJACENT)
    matrix.lines()
    matrix.numbers()
    for column in range(1, 11):
        for row in range(1, 11):
            head = heads.get((column, row), [-1])[0]
            d.text(*matrix.center(column, row), minus(head), 12, color=FAINT if head < 0 else INK)
    d.text(612, 22, "C: first element of each cell", 13)
    d.text(40, 418, "E", 13, "start")
    d.boxes(64, 406, e)
    for k in range(9):
        d.text(79 + 30 * k, 440, k + 1, 11, color=FAINT)
    d.text(64, 462, "E: the element that follows in the same cell", 12, "start")
    for k, cell in enumerate([(5, 7), (2, 7)]):
        d.chain(498, 420 + 36 * k, f"C[{cell[0]}][{cell[1]}]", heads[cell])
    return d


def sorting_array():
    before = [[SORTING[e][0] for e in range(1, 9)], [SORTING[e][1] for e in range(1, 9)],
              list(range(1, 9))]
    records = sorted(zip(*before))
    after = [list(row) for row in zip(*records)]
    require(after, [[3, 4, 4, 4, 5, 5, 5, 6], [7, 5, 6, 7, 6, 7, 8, 6], [7, 5, 3, 1, 6, 4, 2, 8]])
    d = Drawing(780, 400, "Sorting: cells as runs of equal keys")
    grid = Grid(d, 40, 46, 34, 6, 8)
    for cell in set(SORTING.values()):
        grid.shade(*cell, ADJACENT)
    grid.shade(5, 7, CENTRAL)
    grid.lines()
    grid.numbers("X", "Y")
    grid.elements(SORTING, 9)
    left, width = 350, 34
    for top, title, rows in [(46, "integerised", before), (176, "sorted by X, then Y", after)]:
        d.text(left, top - 14, title, 13, "start")
        for k, (name, row) in enumerate(zip("XYD", rows)):
            fills = [CENTRAL if (rows[0][p], rows[1][p]) == (5, 7) else
                     (MARKED if k == 2 else PAPER) for p in range(8)]
            d.text(left - 16, top + 24 * k + 12, name)
            d.boxes(left, top + 24 * k, row, width, fills=fills)
    d.text(left, 288, "binary search for cell (5,7)", 13, "start")
    for step, (kept, dropped) in enumerate([(range(4, 8), range(0, 4)), (range(4, 6), range(6, 8)),
                                           (range(5, 6), range(4, 5))]):
        y = 302 + 24 * step
        for p in list(kept) + list(dropped):
            d.rect(left + p * width, y, width, 18, CENTRAL if p in kept else PAPER, FAINT)
            d.text(left + (p + 0.5) * width, y + 9, f"{after[0][p]},{after[1][p]}", 11,
                   color=INK if p in kept else FAINT)
    d.text(left + 8 * width + 12, 359, "element 4", 12, "start")
    return d


def partition_sort():
    values = [3, 16, 7, 11, 2, 14, 5, 9, 4, 8, 12, 6, 13, 15, 1, 10]
    swaps, i, j = [], 0, len(values) - 1
    after = list(values)
    while True:
        while i <= j and after[i] < 8:
            i += 1
        while i <= j and after[j] >= 8:
            j -= 1
        if i >= j:
            break
        after[i], after[j] = after[j], after[i]
        swaps.append((i, j))
    require([(values[p], values[q]) for p, q in swaps], [(16, 1), (11, 6), (14, 4)])
    require(after, [3, 1, 7, 6, 2, 4, 5, 9, 14, 8, 12, 11, 13, 15, 16, 10])
    d = Drawing(640, 186, "Partition sort: the first split")
    left, width = 96, 32
    moved = {p for pair in swaps for p in pair}
    d.text(left - 12, 84, "before", 12, "end")
    d.boxes(left, 72, values, width, fills=[CENTRAL if p in moved else PAPER for p in range(16)])
    for level, (p, q) in enumerate(swaps):
        x1, x2, y = left + (p + 0.5) * width, left + (q + 0.5) * width, 24 + 16 * level
        d.line(x1, y, x2, y)
        d.arrow(x1, y, x1, 70)
        d.arrow(x2, y, x2, 70)
    d.text(left - 12, 134, "after", 12, "end")
    d.boxes(left, 122, after, width, fills=[ADJACENT if v < 8 else MARKED for v in after])
    d.text(left + 3.5 * width, 164, "below 8", 12)
    d.text(left + 11.5 * width, 164, "8 and above", 12)
    return d


def nbs_rows():
    rows = lists(NBS, lambda e: NBS[e][1])
    require([rows.get(r, [-1])[0] for r in range(1, 11)], [-1, -1, -1, -1, 5, 9, 10, 2, -1, -1])
    require(next_of(rows, 10), [-1, -1, -1, 1, -1, 3, 4, 6, 8, 7])
    d = Drawing(740, 404, "Munjiza-NBS: a list for every row")
    grid = Grid(d, 40, 46, 30, 10, 10)
    for row in rows:
        grid.shade_row(row, ADJACENT)
    grid.lines()
    grid.numbers("x", "y")
    grid.elements(NBS, 7.6, 10)
    d.text(190, 22, "stage 1: every element on the list of its row", 13)
    d.text(432, 22, "B", 13)
    for row in range(1, 11):
        y = grid.center(1, row)[1]
        members = rows.get(row, [])
        d.text(404, y, row, 11, color=FAINT)
        d.rect(418, y - 12, 30, 24, ADJACENT if members else PAPER)
        d.text(433, y, minus(members[0] if members else -1), color=INK if members else FAINT)
        if members:
            x = 448
            for element in members[1:]:
                d.arrow(x + 2, y, x + 24, y)
                d.rect(x + 25, y - 11, 26, 22)
                d.text(x + 38, y, element)
                x += 51
            d.arrow(x + 2, y, x + 24, y)
            d.text(x + 36, y, minus(-1), color=FAINT)
    d.text(418, 372, "boxes: B, the head of the row", 12, "start")
    d.text(418, 389, "arrows: Y, the element that follows", 12, "start")
    return d


def nbs_cells():
    def loaded(row):
        stored = lists(NBS, lambda e: NBS[e][1]).get(row, [])
        return lists(stored, lambda e: NBS[e][0])

    central, below = loaded(7), loaded(6)
    require({c: m[0] for c, m in central.items()}, {3: 7, 4: 1, 5: 4})
    require(central[4], [1, 10])
    require({c: m[0] for c, m in below.items()}, {3: 9, 4: 3, 5: 6, 6: 8})
    d = Drawing(740, 372, "Munjiza-NBS: the cells of two rows")
    grid = Grid(d, 40, 46, 34, 10, 4)
    low = Grid(d, 40, 46, 34, 10, 4)
    grid.shade_row(3, CENTRAL)
    grid.shade_row(2, ADJACENT)
    grid.lines()
    # Rows 5 to 8 of the system.
    low.elements({e: (c[0], c[1] - 4) for e, c in NBS.items()}, 9)
    for k in range(4):
        d.text(28, low.center(1, k + 1)[1], k + 5, 11, color=FAINT)
    for column in range(1, 11):
        d.text(low.center(column, 1)[0], 193, column, 11, color=FAINT)
    x, y = low.corner(3, 3)
    d.rect(x, y, 68, 34, "none", INK, 2.6)
    x, y = low.corner(3, 2)
    d.rect(x, y, 102, 34, "none", INK, 2.6)
    d.text(210, 22, "central row 7, the row below, and the mask of cell (4,7)", 13)
    for top, name, row, fill in [(222, "A[0]", central, CENTRAL), (300, "A[1]", below, ADJACENT)]:
        d.text(28, top + 12, name, 12)
        d.boxes(50, top, [row.get(c, [-1])[0] for c in range(1, 11)], 33,
                fills=[fill if c in row else PAPER for c in range(1, 11)])
        for c in range(1, 11):
            d.text(50 + 33 * (c - 0.5), top + 35, c, 11, color=FAINT)
    for k, (name, members) in enumerate([("A[0][3]", central[3]), ("A[0][4]", central[4]),
                                         ("A[1][3]", below[3]), ("A[1][4]", below[4]),
                                         ("A[1][5]", below[5])]):
        d.chain(520, 66 + 42 * k, name, members, CENTRAL if name[2] == "0" else ADJACENT)
    d.text(466, 276, "the lists that cell (4,7) looks at;", 12, "start")
    d.text(466, 294, "the arrows are the array X", 12, "start")
    return d


def rows_block_of_the_book():
    tests = sum(len(central) * len(candidates) - len(central) * (len(central) + 1) // 2
                for _, _, central, candidates in blocks(NBS, 10))
    require(tests, 31)  # as docs/algorithms/rows.md says
    return rows_block(NBS)


def nbs_3d():
    d = Drawing(700, 250, "Munjiza-NBS in 3D: five rows")
    grid = Grid(d, 60, 56, 50, 3, 2)
    grid.shade(2, 2, CENTRAL)
    for cell in [(1, 2), (1, 1), (2, 1), (3, 1)]:
        grid.shade(*cell, ADJACENT)
    grid.lines()
    d.text(135, 26, "rows seen from their end", 13)
    for column, name in enumerate(["iy − 1", "iy", "iy + 1"], 1):
        d.text(grid.center(column, 1)[0], 172, name, 12)
    for row, name in [(2, "iz"), (1, "iz − 1")]:
        d.text(52, grid.center(1, row)[1], name, 12, "end")
    for cell in [(1, 2), (1, 1), (2, 1), (3, 1)]:
        d.text(*grid.center(*cell), 1, 14)
    d.text(*grid.center(2, 2), 0, 14)
    left, width = 300, 36
    for top, name, fill, looked in [(70, "A[0]", CENTRAL, (4, 5)),
                                    (130, "A[1]", ADJACENT, (4, 5, 6))]:
        d.text(left - 8, top + 13, name, 13, "end")
        for c in range(1, 11):
            d.rect(left + (c - 1) * width, top, width, 26, fill if c in looked else PAPER,
                   line=2.4 if c in looked else 1)
        for c, label in [(4, "ix − 1"), (5, "ix"), (6, "ix + 1")]:
            d.text(left + (c - 0.5) * width, top + 38, label, 10)
    d.text(left + 5 * width, 26, "heads of the cells, central cell ix", 13)
    d.rect(60, 206, 14, 14, CENTRAL)
    d.text(80, 213, "set 0: the central row", 12, "start")
    d.rect(250, 206, 14, 14, ADJACENT)
    d.text(270, 213, "set 1: four rows merged (the mask holds three cells of each)", 12, "start")
    return d


FIGURES = [contact_mask, direct_check, binary_tree, screening_array, sorting_array, partition_sort,
           nbs_rows, nbs_cells, nbs_3d, rows_tiles, *derivations.FIGURES]

if __name__ == "__main__":
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else IMAGES
    for figure in FIGURES:
        figure().save(folder / f"{figure.__name__}.svg")
    rows_block_of_the_book().save(folder / "rows_block.svg")

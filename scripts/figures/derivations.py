"""The figures of docs/derivations/: one for each proof, of the quantities that it bounds."""

import math

from layer_figures import layer_filter
from svg import ADJACENT, CENTRAL, FAINT, INK, MARKED, PAPER, Drawing, Grid

RED = "#b91c1c"


def legend(d, x, y, entries):
    """Squares of colour and what they mean, in a row."""
    for fill, text in entries:
        d.rect(x, y - 7, 14, 14, fill)
        d.text(x + 20, y, text, 12, "start")
        x += 34 + 6.6 * len(text)


def measure(d, x1, x2, y, text, color=INK):
    """A length with its name, between two ticks."""
    d.line(x1, y, x2, y, color, 1.2)
    for x in (x1, x2):
        d.line(x, y - 5, x, y + 5, color, 1.2)
    d.text((x1 + x2) / 2, y - 11, text, 12, color=color)


def predicate_band():
    d = Drawing(720, 170, "The band of the filter around touching")
    left, middle, right, y = 40, 360, 680, 84
    band, abstain = 90, 152
    d.rect(left, y - 18, middle - abstain - left, 36, MARKED)
    d.rect(middle + abstain, y - 18, right - middle - abstain, 36, ADJACENT)
    for start in (middle - abstain, middle + band):
        d.rect(start, y - 18, abstain - band, 36, "#eef3f8")
    d.rect(middle - band, y - 18, 2 * band, 36, CENTRAL)
    d.text(124, y, "within reach", 13)
    d.text(596, y, "apart", 13)
    d.text(middle, y, "asks the exact stages", 13)
    d.line(middle, y - 30, middle, y - 14, INK, 1.6)
    d.line(middle, y + 14, middle, y + 30, INK, 1.6)
    d.text(middle, y - 42, "D = S: touching", 13)
    for x, text in [(middle - band, "−16 u"), (middle + band, "16 u"),
                    (middle - abstain, "−27.1 u"), (middle + abstain, "27.1 u")]:
        d.line(x, y + 18, x, y + 26, INK)
        d.text(x, y + 36, text, 12)
    d.text(middle, 146, "D²/S² − 1 in real numbers, not to scale; between 16 u and 27.1 u the rounding "
           "of the filter decides whether it answers", 12, color=FAINT)
    return d


def axis_of_cells(d, y, left, cell, count, title):
    d.text(left, y - 66, title, 13, "start")
    for k in range(count + 1):
        d.line(left + k * cell, y - 44, left + k * cell, y + 44, FAINT, 1)
    for k in range(count):
        d.text(left + (k + 0.5) * cell, y + 54, k, 11, color=FAINT)


def touching_discs(d, y, first, reach, fill):
    for x in (first, first + reach):
        d.circle(x, y, reach / 2, "none", INK, 1.2)
        d.circle(x, y, 3, INK)
    for cell_left, width in fill:
        d.rect(cell_left, y + 36, width, 8, CENTRAL, "none")


def cell_margin():
    d = Drawing(760, 336, "Cells as large as the reach, and a hair larger")
    reach = 84
    for y, cell, left, title, answer in [
            (100, 84, 40, "cells as large as the reach", "two cells apart: never tested"),
            (262, 92, 40, "cells a hair larger (drawn much too large)",
             "in adjacent cells: tested")]:
        axis_of_cells(d, y, left, cell, 4, title)
        first = left + cell - 2
        numbers = [0, 2] if cell == reach else [0, 1]
        touching_discs(d, y, first, reach,
                       [(left + number * cell, cell) for number in numbers])
        d.text(452, y - 34, f"cells {numbers[0]} and {numbers[1]}", 13, "start")
        d.text(452, y - 12, answer, 13, "start", RED if cell == reach else INK)
    d.text(452, 114, "the left center lies just below a face;", 12, "start")
    d.text(452, 132, "rounding puts the right one, a reach away,", 12, "start")
    d.text(452, 150, "on the next face", 12, "start")
    return d


def filter_circles(d, x, y):
    for radius, fill in [(104, ADJACENT), (88, CENTRAL), (58, MARKED)]:
        d.circle(x, y, radius, fill, INK if radius != 88 else "none", 1)
    d.circle(x, y, 73, "none", INK, 1.6)
    d.circle(x, y, 58, MARKED)
    d.circle(x, y, 3, INK)
    for radius, name in [(58, "n"), (73, "s"), (88, "f")]:
        d.text(x + radius - 8, y + 12, name, 12)
    d.line(x, y, x + 73, y, INK, 1)
    d.text(x, y - 26, "within reach", 12)
    d.text(x, y - 96, "apart", 12)


def tile_filter():
    d = Drawing(800, 310, "A tile with its frame, and the filter around one element")
    grid = Grid(d, 40, 52, 34, 6, 6)
    for k in range(1, 7):
        for cell in [(k, 1), (k, 6), (1, k), (6, k)]:
            grid.shade(*cell, "#eef3f8")
    for cell in [(3, 3), (4, 3), (2, 4), (3, 4), (4, 4)]:
        grid.shade(*cell, CENTRAL if cell == (3, 3) else ADJACENT)
    grid.lines()
    d.rect(74, 86, 136, 136, "none", INK, 2)
    own, copies = [(3.4, 3.3), (2.6, 4.4), (4.5, 4.6), (2.3, 2.6), (5.4, 2.4)], [(6.5, 3.5), (4.4, 6.4)]
    for column, row in own + copies:
        x, y = 40 + (column - 1) * 34, 52 + (7 - row) * 34
        d.circle(x, y, 6, PAPER if (column, row) in own else MARKED)
    d.text(142, 26, "cells of one tile, and their frame", 13)
    d.text(142, 276, "own elements in the tile, copies in the frame", 12)
    filter_circles(d, 430, 160)
    d.text(430, 26, "where the partner's center lies", 13)
    d.text(430, 284, "between n and f: decided exactly", 12)
    d.text(590, 96, "s: the reach, in real numbers", 12, "start")
    d.text(590, 122, "f = s + slack, n = s − slack,", 12, "start")
    d.text(590, 142, "in single precision", 12, "start")
    d.text(590, 176, "slack = 8 · 2⁻²³ of the tile's unit;", 12, "start")
    d.text(590, 196, "all errors together: 4.81 · 2⁻²³", 12, "start")
    d.text(590, 230, "not to scale", 12, "start", FAINT)
    return d


def periodic_predicate():
    d = Drawing(780, 232, "Large numbers that cancel: why the band is absolute")
    y, left, a, b, image = 112, 40, 640, 150, 668
    d.line(left, y, 730, y, FAINT, 1)
    d.line(left, y - 8, left, y + 8, INK)
    d.text(left, y + 20, "0", 12)
    d.circle(b, y, 5, CENTRAL)
    d.text(b, y + 22, "x_b", 13)
    d.circle(a, y, 5, CENTRAL)
    d.text(a - 2, y + 22, "x_a", 13, "end")
    d.circle(image, y, 5, ADJACENT)
    d.text(image - 4, y + 22, "x_b + n A", 13, "start")
    d.arrow(b, y - 26, image, y - 26)
    d.text((b + image) / 2, y - 38, "n A: many cells", 13)
    d.arrow(left, y - 62, a, y - 62)
    d.text((left + a) / 2, y - 74, "x_a: far from the origin", 13)
    measure(d, a, image, y + 60, "D")
    d.text(left, y + 52, "D is a small difference of large numbers. Each sum on the way", 12, "start")
    d.text(left, y + 70, "is rounded, by up to u times its own size.", 12, "start")
    d.text(left, y + 96, "So D is compared with S ± e, where e follows the sizes and not D.", 12,
           "start")
    return d


def parallelogram(x, y, a, b, i, j):
    """The image (i, j) of a cell with its lower left corner at x, y; y runs downwards."""
    x, y = x + i * a[0] + j * b[0], y - i * a[1] - j * b[1]
    return [(x, y), (x + a[0], y - a[1]), (x + a[0] + b[0], y - a[1] - b[1]),
            (x + b[0], y - b[1])]


def periodic_images():
    d = Drawing(780, 330, "A tilted cell, the orthogonal cell, and its ghosts")
    a, b, x, y = (150, 0), (62, 110), 250, 220
    for i in (-1, 0, 1):
        for j in (-1, 0, 1):
            d.polygon(parallelogram(x, y, a, b, i, j), "none", FAINT, 0.8)
    d.polygon(parallelogram(x, y, a, b, 0, 0), "none", INK, 1.2)
    d.rect(x - 28, y - 138, 206, 166, "#eef3f8", FAINT, 1)
    d.rect(x, y - 110, 150, 110, MARKED, INK, 2)
    d.polygon(parallelogram(x, y, a, b, 0, 0), "none", INK, 1.2)
    inside = [(24, 30), (70, 86), (132, 52), (96, 14), (40, 96)]
    for k, (u, v) in enumerate(inside):
        for i in (-2, -1, 0, 1, 2):
            for j in (-1, 0, 1):
                px, py = x + u + i * a[0] + j * b[0], y - v - j * b[1]
                own = (i, j) == (0, 0)
                near = x - 28 < px < x + 178 and y - 138 < py < y + 28
                if own or near:
                    d.circle(px, py, 8, CENTRAL if own else PAPER)
                    d.text(px, py, k, 10)
    d.rect(500, 1, 279, 328, PAPER, "none")
    d.text(x + 75, 296, "a", 13)
    d.arrow(x, 284, x + 150, 284)
    d.arrow(176, y, 176 + 62, y - 110)
    d.text(186, y - 62, "b", 13)
    d.text(540, 90, "orthogonal cell: every element once", 12, "start")
    d.rect(518, 83, 14, 14, MARKED)
    d.text(540, 116, "within reach of it: ghosts", 12, "start")
    d.rect(518, 109, 14, 14, "#eef3f8")
    d.text(540, 142, "element", 12, "start")
    d.circle(525, 142, 7, CENTRAL)
    d.text(540, 168, "ghost: its image", 12, "start")
    d.circle(525, 168, 7, PAPER)
    d.text(518, 204, "A pair is found between two elements,", 12, "start")
    d.text(518, 222, "or between an element and a ghost; of", 12, "start")
    d.text(518, 240, "its two descriptions one is reported.", 12, "start")
    return d


def skin():
    d = Drawing(840, 270, "Reach, skin and displacements")
    y, i, j = 140, 150, 420
    for x, moved, name in [(i, 34, "i"), (j, -30, "j")]:
        d.circle(x, y, 64, "none", FAINT, 1)
        d.circle(x, y, 3, FAINT)
        d.circle(x + moved, y, 64, "none", INK, 1.4)
        d.circle(x + moved, y, 3, INK)
        d.text(x + moved, y + 82, f"{name} now", 12)
        d.text(x, y - 78, f"{name} at its anchor", 12, color=FAINT)
    measure(d, i, i + 34, y - 20, "d_i")
    measure(d, j - 30, j, y - 20, "d_j")
    measure(d, i, j, 254, "|x⁰_i − x⁰_j|", FAINT)
    d.text(540, 60, "candidate:", 13, "start")
    d.text(540, 82, "|x⁰_i − x⁰_j| ≤ r_i + r_j + margin + skin", 12, "start")
    d.text(540, 116, "contact now:", 13, "start")
    d.text(540, 138, "|x_i − x_j| ≤ r_i + r_j + margin", 12, "start")
    d.text(540, 172, "no contact can be missed while", 13, "start")
    d.text(540, 194, "d_i + d_j ≤ skin", 12, "start")
    d.text(540, 216, "for the two largest displacements", 12, "start")
    return d


def triangle_regions(d):
    """The parts of the plane by the part of the triangle that is nearest."""
    p, q, r = (120, 220), (270, 200), (170, 90)
    d.rect(30, 44, 330, 250, MARKED, "none")
    for one, other, outwards in [(p, q, (13.2, 99)), (q, r, (110, -100)), (r, p, (-130, -50))]:
        length = (outwards[0] ** 2 + outwards[1] ** 2) ** 0.5
        far = [200 * c / length for c in outwards]
        d.polygon([one, other, (other[0] + far[0], other[1] + far[1]),
                   (one[0] + far[0], one[1] + far[1])], ADJACENT, FAINT, 0.8)
    d.polygon([p, q, r], CENTRAL, INK, 1.6)
    for (x, y), name, dx, dy in [(p, "p", -14, 12), (q, "q", 14, 10), (r, "r", 2, -16)]:
        d.circle(x, y, 4, INK)
        d.text(x + dx, y + dy, name, 13)
    d.text(186, 172, "face", 13)
    d.text(200, 258, "side pq", 12)
    d.text(278, 120, "side qr", 12)
    d.text(88, 140, "side rp", 12)


def triangle_predicate():
    d = Drawing(800, 340, "Nearest part of a triangle; features of a mesh that are contacts")
    triangle_regions(d)
    for frame in [(0, 0, 420, 44), (0, 294, 420, 46), (0, 0, 30, 340), (360, 0, 60, 340)]:
        d.rect(*frame, PAPER, "none")
    d.text(195, 24, "seen from above: which part is nearest", 13)
    legend(d, 90, 318, [(CENTRAL, "face"), (ADJACENT, "a side"), (MARKED, "a corner")])
    d.text(600, 24, "a surface, cut: where spheres touch it", 13)
    ground = [(430, 230), (520, 230), (660, 230), (740, 130)]
    for one, other in zip(ground, ground[1:]):
        d.line(*one, *other, INK, 2.4)
    for x, y in ground:
        d.circle(x, y, 4, INK)
    for x, y, feet in [(500, 178, [(500, 230)]), (634, 176, [(634, 230), (676.2, 209.7)])]:
        radius = 230 - y
        d.circle(x, y, radius, "none", INK, 1.2)
        d.circle(x, y, radius + 9, "none", FAINT, 1)
        for foot in feet:
            d.circle(*foot, 5, RED, RED)
    d.text(468, 108, "radius + margin", 12, color=FAINT)
    d.arrow(530, 272, 521, 238)
    d.text(440, 284, "This edge is within reach, but no minimum", 12, "start")
    d.text(440, 302, "of the distance: no contact beside the face.", 12, "start")
    d.text(696, 232, "in a corner,", 12, "start")
    d.text(696, 250, "each wall once", 12, "start")
    return d


def contact_geometry():
    d = Drawing(700, 290, "Normal, point of contact and gap of two spheres that overlap")
    y, i, j = 130, (230, 100), (420, 115)  # centre in x and radius
    ends = (j[0] - j[1], i[0] + i[1])
    d.circle(i[0], y, i[1], ADJACENT, INK, 1.2)
    d.circle(j[0], y, j[1], "none", INK, 1.2)
    d.line(i[0], y, j[0], y, FAINT, 1.2, "4 4")
    d.arrow(i[0], y, i[0] + 46, y)
    d.text(i[0] + 24, y - 14, "normal", 12)
    for x, name in [(i[0], "x_i"), (j[0], "x_j + n A")]:
        d.circle(x, y, 3.5, INK)
        d.text(x, y + 18, name, 12)
    middle = sum(ends) / 2
    d.circle(middle, y, 4, RED, RED)
    d.text(middle, y - 92, "point", 12, color=RED)
    d.line(middle, y - 84, middle, y - 7, RED, 1)
    for x in ends:
        d.line(x, y, x, y + 112, FAINT, 1, "3 3")
    measure(d, ends[0], ends[1], y + 116, "")
    d.text(ends[1] + 8, y + 116, "−gap", 12, "start")
    d.text(i[0] - 20, y + 136, "i, where it is given", 12, color=FAINT)
    d.text(j[0] + 20, y + 136, "j, moved by its image shift", 12, color=FAINT)
    return d


def turned(point, about, angle):
    """A point turned about another, against the clock as it is seen."""
    x, y = point[0] - about[0], point[1] - about[1]
    c, s = math.cos(angle), math.sin(angle)
    return about[0] + c * x + s * y, about[1] - s * x + c * y


def moving_walls():
    d = Drawing(760, 330, "A sphere beside a moved wall, and its center in the grid of the wall at rest")
    about, right, angle = (190, 160), (560, 160), 0.6
    rest = [(70, 210), (190, 235), (310, 205)]  # corners of the wall, cut
    center, reach = (250, 168), 62
    d.text(about[0], 22, "as it is: v = R m + t", 13)
    d.text(right[0], 22, "at rest: where the grid stands", 13)
    moved = [turned(corner, about, angle) for corner in rest]
    c = turned(center, about, angle)
    d.circle(*c, reach, "none", FAINT, 1)
    d.text(c[0], c[1] - reach - 10, "reach", 12, color=FAINT)
    shift = right[0] - about[0]
    back = [(x + shift, y) for x, y in rest]
    y = (center[0] + shift, center[1])
    side, left, top = 46, right[0] - 4 * 46, 44
    d.rect(left, top + 2 * side, 8 * side, 3 * side, ADJACENT, "none")
    for k in range(9):
        d.line(left + k * side, top, left + k * side, top + 5 * side, FAINT, 0.6)
    for k in range(6):
        d.line(left, top + k * side, left + 8 * side, top + k * side, FAINT, 0.6)
    for corners in (moved, back):
        for one, other in zip(corners, corners[1:]):
            d.line(*one, *other, INK, 2.4)
    d.circle(*c, 4, INK)
    d.text(c[0] + 14, c[1] - 6, "c", 13)
    d.circle(*y, reach + 5, "none", FAINT, 1)
    column, row = int((y[0] - left) // side), int((y[1] - top) // side)
    d.rect(left + column * side, top + row * side, side, side, "none", RED, 2)
    d.circle(*y, 4, RED, RED)
    d.text(y[0] + 44, y[1] - 8, "y = Rᵀ(c − t)", 12, "start", RED)
    d.arrow(left - 54, 250, left - 8, 250)
    d.text(right[0], 296, "blue: cells that name the wall; red: the one that y is looked up in", 12)
    d.text(right[0], 314, "the reach there is a hair longer, for all that is rounded", 12)
    return d


def orientation():
    d = Drawing(760, 260, "A line through two vertices that separates two triangles, and the points on it")
    y, left, right = 150, 40, 420
    d.line(left, y, right, y, RED, 1.6)
    d.polygon([(90, y), (230, y), (150, 62)], ADJACENT, INK, 1.4)
    d.polygon([(190, y), (360, 214), (250, 240)], CENTRAL, INK, 1.4)
    for x, name in [(90, "i"), (230, "j")]:
        d.circle(x, y, 5, RED, RED)
        d.text(x, y - 16, name, 13, color=RED)
    d.text(150, 108, "A", 15)
    d.text(262, 200, "B", 15)
    d.text(right - 4, y - 12, "orientation 0", 12, "end", RED)
    d.text(right - 4, 66, "1: all others of A", 12, "end", FAINT)
    d.text(60, 226, "−1: all others of B", 12, "start", FAINT)
    d.text(230, 22, "the line through i and j separates", 13)
    d.text(600, 22, "the points on it, one dimension lower", 13)
    shift = 430
    d.line(right + 50, y, 740, y, RED, 1.6)
    d.line(90 + shift, y - 7, 230 + shift, y - 7, ADJACENT, 8)
    for x in (90, 230):
        d.circle(x + shift, y, 5, INK)
    d.circle(190 + shift, y, 5, CENTRAL, INK, 1.4)
    d.text(160 + shift, y - 28, "[A ∩ H]", 13)
    d.text(190 + shift, y + 24, "[B ∩ H]", 13)
    d.text(600, y + 72, "these meet, so A and B touch", 12)
    return d


FIGURES = [predicate_band, cell_margin, tile_filter, layer_filter, periodic_predicate,
           periodic_images, skin, triangle_predicate, contact_geometry, moving_walls,
           orientation]

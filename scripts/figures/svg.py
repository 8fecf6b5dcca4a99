"""Just enough SVG for the figures of the pages: boxes, numbers, arrows, polygons, grids of cells."""

INK, FAINT, PAPER = "#1f2937", "#9ca3af", "#ffffff"
CENTRAL, ADJACENT, MARKED = "#fcd9a8", "#cfe3f7", "#d9ead3"
FONT = "Helvetica, Arial, 'DejaVu Sans', sans-serif"


class Drawing:
    """Collects shapes; y runs downwards. A paper of its own keeps it readable on any background."""

    def __init__(self, width, height, title):
        self.size = (width, height)
        self.parts = [
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" '
            f'width="{width}" height="{height}" font-family="{FONT}">',
            f"<title>{title}</title>",
            '<defs><marker id="tip" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="7" '
            f'markerHeight="7" orient="auto"><path d="M0,0.5 L8,4 L0,7.5 z" fill="{INK}"/>'
            "</marker></defs>",
            f'<rect width="{width}" height="{height}" rx="8" fill="{PAPER}"/>',
        ]

    def rect(self, x, y, width, height, fill="none", stroke=INK, line=1.0):
        self.parts.append(f'<rect x="{x:g}" y="{y:g}" width="{width:g}" height="{height:g}" '
                          f'fill="{fill}" stroke="{stroke}" stroke-width="{line:g}"/>')

    def circle(self, x, y, radius, fill=PAPER, stroke=INK, line=1.0):
        self.parts.append(f'<circle cx="{x:g}" cy="{y:g}" r="{radius:g}" fill="{fill}" '
                          f'stroke="{stroke}" stroke-width="{line:g}"/>')

    def polygon(self, points, fill="none", stroke=INK, line=1.0):
        corners = " ".join(f"{x:g},{y:g}" for x, y in points)
        self.parts.append(f'<polygon points="{corners}" fill="{fill}" stroke="{stroke}" '
                          f'stroke-width="{line:g}"/>')

    def line(self, x1, y1, x2, y2, stroke=INK, line=1.0, dash=""):
        dashes = f' stroke-dasharray="{dash}"' if dash else ""
        self.parts.append(f'<line x1="{x1:g}" y1="{y1:g}" x2="{x2:g}" y2="{y2:g}" '
                          f'stroke="{stroke}" stroke-width="{line:g}"{dashes}/>')

    def arrow(self, x1, y1, x2, y2):
        self.parts.append(f'<line x1="{x1:g}" y1="{y1:g}" x2="{x2:g}" y2="{y2:g}" '
                          f'stroke="{INK}" marker-end="url(#tip)"/>')

    def text(self, x, y, text, size=13, anchor="middle", color=INK, weight="normal"):
        """Centred on y too."""
        self.parts.append(f'<text x="{x:g}" y="{y + 0.35 * size:g}" font-size="{size:g}" '
                          f'text-anchor="{anchor}" fill="{color}" font-weight="{weight}">'
                          f"{text}</text>")

    def boxes(self, x, y, values, width=30, height=24, fills=None):
        """Numbers in a row of boxes, as the book draws arrays. Returns the end in x."""
        for k, value in enumerate(values):
            fill = fills[k] if fills else PAPER
            self.rect(x + k * width, y, width, height, fill)
            self.text(x + (k + 0.5) * width, y + height / 2, minus(value))
        return x + len(values) * width

    def chain(self, x, y, head, elements, fill=PAPER, step=50):
        """A list: its head, its elements one after the other, and the -1 that ends it."""
        self.text(x, y, head, anchor="end")
        for element in elements:
            self.arrow(x + 6, y, x + step - 24, y)
            self.rect(x + step - 23, y - 12, 26, 24, fill)
            self.text(x + step - 10, y, element)
            x += step
        self.arrow(x + 6, y, x + step - 24, y)
        self.text(x + step - 12, y, minus(-1), color=FAINT)

    def save(self, path):
        path.write_text("\n".join(self.parts) + "\n</svg>\n", encoding="utf-8")


def minus(value):
    """A number with a true minus sign."""
    return str(value).replace("-", "\N{MINUS SIGN}")


class Grid:
    """Cells counted from 1, row 1 at the bottom, as the book draws them."""

    def __init__(self, drawing, left, top, side, columns, rows):
        self.drawing, self.left, self.top = drawing, left, top
        self.side, self.columns, self.rows = side, columns, rows

    def corner(self, column, row):
        """Upper left corner of a cell."""
        return self.left + (column - 1) * self.side, self.top + (self.rows - row) * self.side

    def center(self, column, row):
        x, y = self.corner(column, row)
        return x + self.side / 2, y + self.side / 2

    def shade(self, column, row, fill):
        self.drawing.rect(*self.corner(column, row), self.side, self.side, fill, stroke="none")

    def shade_row(self, row, fill):
        for column in range(1, self.columns + 1):
            self.shade(column, row, fill)

    def lines(self):
        right = self.left + self.columns * self.side
        bottom = self.top + self.rows * self.side
        for column in range(self.columns + 1):
            x = self.left + column * self.side
            self.drawing.line(x, self.top, x, bottom, FAINT, 0.8)
        for row in range(self.rows + 1):
            y = self.top + row * self.side
            self.drawing.line(self.left, y, right, y, FAINT, 0.8)

    def numbers(self, across="i", up="j"):
        """Numbers of columns below and of rows on the left."""
        bottom = self.top + self.rows * self.side
        for column in range(1, self.columns + 1):
            self.drawing.text(self.center(column, 1)[0], bottom + 11, column, 11, color=FAINT)
        for row in range(1, self.rows + 1):
            self.drawing.text(self.left - 10, self.center(1, row)[1], row, 11, color=FAINT)
        self.drawing.text(self.left + self.columns * self.side + 10, bottom + 11, across, 12)
        self.drawing.text(self.left - 10, self.top - 9, up, 12)

    def elements(self, cells, radius=8.5, size=11):
        """Numbered discs; several in one cell share it."""
        spots = {1: [(0, 0)], 2: [(-0.22, 0.22), (0.22, -0.22)],
                 3: [(-0.25, 0.24), (0.25, 0.24), (0, -0.24)],
                 4: [(-0.25, -0.25), (0.25, -0.25), (-0.25, 0.25), (0.25, 0.25)]}
        members = {}
        for element, cell in cells.items():
            members.setdefault(cell, []).append(element)
        for cell, inside in members.items():
            x, y = self.center(*cell)
            for element, (dx, dy) in zip(inside, spots[len(inside)]):
                ex, ey = x + dx * self.side, y + dy * self.side
                self.drawing.circle(ex, ey, radius)
                self.drawing.text(ex, ey, element, size)

"""What the reports of the benchmarks share: reading tables, writing tables into pages, plots."""

import csv
import os
import re

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

plt.rcParams.update(
    {
        "font.size": 9,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "axes.grid": True,
        "grid.color": "#e5e5e5",
        "svg.hashsalt": "abut",
        "svg.fonttype": "none",
        "legend.frameon": False,
    }
)


def read(path):
    """Header lines as a dictionary, rows with numbers where the text is one."""
    header, lines = {}, []
    with open(path, newline="") as file:
        for line in file:
            if line.startswith("#"):
                key, value = line[1:].split(":", 1)
                header[key.strip()] = value.strip()
            else:
                lines.append(line)
    return header, [{k: number(v) for k, v in row.items()} for row in csv.DictReader(lines)]


def number(text):
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    return text


def table(head, rows):
    lines = [head, ["---"] + ["---:"] * (len(head) - 1), *rows]
    return "\n".join("| " + " | ".join(str(c) for c in row) + " |" for row in lines)


def plain(value, digits=1):
    return "–" if value is None else f"{value:,.{digits}f}"


def replace_section(text, name, body):
    pattern = rf"(<!-- {name} -->\n).*?(<!-- /{name} -->)"
    if not re.search(pattern, text, re.S):
        raise SystemExit(f"the page has no markers <!-- {name} --> ... <!-- /{name} -->")
    return re.sub(pattern, lambda m: m[1] + body + "\n" + m[2], text, flags=re.S)


def rewrite_page(path, sections):
    """Writes anew what lies between the markers of a page; its words stay."""
    with open(path) as file:
        text = file.read()
    for name, body in sections:
        text = replace_section(text, name, body)
    with open(path, "w") as file:
        file.write(text)


def save(figure, folder, name):
    path = os.path.join(folder, name)
    figure.savefig(path, metadata={"Date": None}, bbox_inches="tight", facecolor="white")
    plt.close(figure)
    print(path)

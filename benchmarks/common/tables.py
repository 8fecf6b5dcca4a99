"""Tables: read from CSV, written in Markdown."""

import csv
import os

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


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

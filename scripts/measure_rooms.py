#!/usr/bin/env python3
"""Counts the rooms of src, as a table of Markdown: files, lines, the median and the largest file, the
longest function, and which other rooms each includes. A room is a folder of src.
  scripts/measure_rooms.py [ROOT]"""

import re
import statistics
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import cpp_functions  # noqa: E402  (beside this script, wherever it is called from)

INCLUDE = re.compile(r'^#include "([^"]+)/[^"/]+"', re.MULTILINE)


def measured(folder, rooms):
    """Lines of each file, (lines, name) of the longest function, the rooms that are included."""
    lines, longest, below = {}, (0, ""), set()
    for path in sorted(folder.rglob("*.?pp")):
        text = path.read_text(encoding="utf-8")
        lines[path.relative_to(folder.parent).as_posix()] = text.count("\n")
        longest = max([longest] + [(length, name) for name, _, length in
                                   cpp_functions.functions(text)])
        below |= {name.split("/")[0] for name in INCLUDE.findall(text)}
    return lines, longest, below & rooms - {folder.name}


def row(name, lines, longest, below):
    largest = max(lines, key=lines.get)
    return (f"| `{name}` | {len(lines)} | {sum(lines.values()):,} | "
            f"{statistics.median(lines.values()):.0f} | {lines[largest]} `{Path(largest).name}` | "
            f"{longest[0]} `{longest[1]}` | {' '.join(sorted(below))} |")


def main():
    source = Path(sys.argv[1] if len(sys.argv) > 1 else ".") / "src"
    folders = sorted(path for path in source.iterdir() if path.is_dir())
    rooms = {folder.name for folder in folders}
    print("| room | files | lines | median | largest file | longest function | includes |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    all_lines, all_longest, arrows, both_ways = {}, (0, ""), {}, 0
    for folder in folders:
        lines, longest, below = measured(folder, rooms)
        print(row(folder.name, lines, longest, below))
        all_lines |= lines
        all_longest = max(all_longest, longest)
        arrows[folder.name] = below
        both_ways += sum(folder.name in arrows.get(other, ()) for other in below)
    print(row("src", all_lines, all_longest, ()))
    print(f"\n{sum(map(len, arrows.values()))} arrows, {both_ways} pairs with arrows both ways.")


if __name__ == "__main__":
    main()

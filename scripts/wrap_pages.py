#!/usr/bin/env python3
"""Wraps the prose of pages at 100 columns; tables, code, headings and pictures stay as they are.
  scripts/wrap_pages.py FILE.md...      rewrites each file where its prose was wrapped otherwise"""

import re
import sys
import textwrap
from pathlib import Path

COLUMNS = 100
ITEM = re.compile(r"(\s*)([*+-]|\d+[.)])\s+")
AS_IT_IS = re.compile(r"\s*(#|\||<|!\[|\[[^]]+\]: |---|===|\\|\$\$)|\s*$|.*(  |\\)$")


def wrapped(lines):
    """A paragraph or an item of a list, its lines joined and wrapped anew."""
    item = ITEM.match(lines[0])
    first = item[0] if item else re.match(r"\s*(> )?", lines[0])[0]
    later = " " * len(first) if item else first
    # Spaces inside `code` and in the texts of links are no places to break at.
    text = " ".join(line.strip().removeprefix("> ") for line in lines)
    if item:
        text = text[len(item[0].strip()) + 1:].strip()
    text = re.sub(r"`[^`]+`", lambda match: match[0].replace(" ", "\0"), text)
    rows = textwrap.wrap(text, COLUMNS, initial_indent=first, subsequent_indent=later,
                         break_long_words=False, break_on_hyphens=False)
    return [row.replace("\0", " ") for row in rows]


def wrapped_page(text):
    out, paragraph, in_code = [], [], False

    def flush():
        if paragraph:
            out.extend(wrapped(paragraph) if any(len(l) > COLUMNS for l in paragraph) else paragraph)
            paragraph.clear()

    for line in text.splitlines():
        fence = line.lstrip().startswith("```")
        if fence or in_code or AS_IT_IS.match(line):
            flush()
            out.append(line)
        elif ITEM.match(line):
            flush()
            paragraph.append(line)
        else:
            paragraph.append(line)
        in_code ^= fence
    flush()
    return "\n".join(out) + "\n"


def main():
    for name in sys.argv[1:]:
        file = Path(name)
        before = file.read_text(encoding="utf-8")
        after = wrapped_page(before)
        if after != before:
            file.write_text(after, encoding="utf-8")
            print(file)


if __name__ == "__main__":
    main()

"""Pages that programs write into: sections between markers, and links to the long reports."""

import os
import re
import textwrap

from benchmarks.common.tables import ROOT

COLUMNS = 100


def wrapped(text, indent=""):
    """A paragraph or an item of a list as it stands on a page."""
    return textwrap.fill(text, COLUMNS, subsequent_indent=indent, break_long_words=False,
                         break_on_hyphens=False)


def link(text, target, page):
    """A link from a page to a file."""
    return f"[{text}]({os.path.relpath(target, os.path.dirname(os.path.abspath(page)))})"


def section_of(text, name):
    """The lines between the markers of a section."""
    found = re.search(rf"<!-- {name} -->\n(.*?)<!-- /{name} -->", text, re.S)
    if not found:
        raise SystemExit(f"the page has no markers <!-- {name} --> ... <!-- /{name} -->")
    return found[1]


def with_sections(text, sections):
    """The text of a page with other sections; its own words stay."""
    for name, body in sections:
        section_of(text, name)
        text = re.sub(rf"(<!-- {name} -->\n).*?(<!-- /{name} -->)",
                      lambda m: m[1] + body + "\n" + m[2], text, flags=re.S)  # noqa: B023
    return text


def generated_lines(text):
    """How many lines of a page stand between markers."""
    return sum(body.count("\n") for _, body in
               re.findall(r"<!-- ([\w-]+) -->\n(.*?)<!-- /\1 -->", text, flags=re.S))


def contents(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def results_of(section, room):
    """The folder of results that a section of a page is made of: its link to them says so."""
    found = re.search(rf"\(\S*results/([^/]+)/{room}\b", section)
    if not found:
        raise SystemExit(f"a section of the page has no link to its results of {room}")
    return os.path.join(ROOT, "benchmarks", "results", found[1], room)

"""Makes the tables of docs/README.md, and of each other README.md, the navigation of the site."""

import os
import re

from pygments.lexers.special import TextLexer


def links_of(text):
    """The pages that a text links to, in order, each once."""
    found = re.findall(r"\]\(((?![a-z]+:)[^)#\s]+)\.md(?:#[^)\s]*)?\)", text)
    return list(dict.fromkeys(found))


def toctree(pages, caption):
    """A hidden list of pages: Sphinx takes the side bar from it."""
    head = "```{toctree}\n:hidden:\n:maxdepth: 1\n" + (f":caption: {caption}\n" if caption else "")
    return "\n" + head + "\n" + "\n".join(pages) + "\n```\n"


def of_sections(text):
    """A list for each section that holds a table, under the heading of the section."""
    result, listed = "", set()
    for section in re.split(r"^## ", text, flags=re.M)[1:]:
        heading, _, body = section.partition("\n")
        pages = [page for page in links_of(body) if page not in listed]
        listed.update(pages)
        if pages:
            result += toctree(pages, heading)
    return result


def of_folder(text):
    """The pages of the folder that a README.md describes."""
    pages = [page for page in links_of(text) if "/" not in page]
    return toctree(pages, "") if pages else ""


def to_index(docname, text):
    """The links to docs/README.md, which is the index of the site."""
    folder = os.path.dirname(docname)
    target = os.path.relpath("docs/README.md", folder or ".")
    index = os.path.relpath("index.md", folder or ".")
    return text.replace(f"]({target})", f"]({index})")


def add(app, docname, source):
    if docname == "index":
        source[0] += of_sections(source[0])
        return
    source[0] = to_index(docname, source[0])
    if docname.endswith("/README"):
        source[0] += of_folder(source[0])


def setup(app):
    app.connect("source-read", add)
    app.add_lexer("csv", TextLexer)
    return {"parallel_read_safe": False}

"""Shows the sources that pages link to as pages of their own, since a browser would only save them."""

import os
import pathlib

from docutils import nodes
from sphinx import addnodes

LANGUAGES = {".hpp": "cpp", ".cpp": "cpp", ".py": "python", ".cmake": "cmake", ".md": "markdown"}


def is_page(app, path):
    """Whether Sphinx makes a page of this file."""
    name = os.path.relpath(os.path.normpath(path), app.srcdir)
    return os.path.splitext(name)[0] in app.env.found_docs


def target_of(app, docname, node):
    """The file or folder of the project that a link means, relative to the root, if it is no page;
    or None."""
    target = node.get("reftarget", "").partition("#")[0]
    path = pathlib.Path(app.env.doc2path(docname)).parent / target
    goal = path.resolve()
    root = pathlib.Path(app.config.project_root)
    if not target or not goal.exists() or not goal.is_relative_to(root) or is_page(app, path):
        return None
    return goal.relative_to(root)


def redirect(app, doctree):
    """Turns links to sources and folders into links to their pages."""
    docname = app.env.docname
    links = list(doctree.findall(addnodes.download_reference))
    links += [node for node in doctree.findall(addnodes.pending_xref)
              if node.get("reftype") == "myst"]
    for node in links:
        source = target_of(app, docname, node)
        if source is None:
            continue
        app.env.abut_sources.add(source.as_posix())
        up = "../" * docname.count("/")
        link = nodes.reference("", "", *node.children, internal=True,
                               refuri=f"{up}source/{source.as_posix()}.html")
        node.replace_self(link)


def page_of(app, source):
    """Title and body of the page of one file, or of a folder."""
    path = pathlib.Path(app.config.project_root) / source
    if path.is_dir():
        names = sorted(entry.name + "/" * entry.is_dir() for entry in path.iterdir())
        body = "<ul>" + "".join(f"<li><code>{name}</code></li>" for name in names) + "</ul>"
    else:
        language = LANGUAGES.get(path.suffix, "text")
        body = app.builder.highlighter.highlight_block(
            path.read_text(encoding="utf-8"), language, linenos="inline")
    return {"title": source, "body": f"<h1><code>{source}</code></h1>{body}"}


def collect(app):
    for source in sorted(app.env.abut_sources):
        yield f"source/{source}", page_of(app, source), "page.html"


def prepare(app, env, docnames):
    env.abut_sources = set()


def setup(app):
    app.add_config_value("project_root", "", "html")
    app.connect("env-before-read-docs", prepare)
    app.connect("doctree-read", redirect, priority=400)
    app.connect("html-collect-pages", collect)
    return {"parallel_read_safe": False}

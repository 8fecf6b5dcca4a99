"""How Sphinx builds the site; docs/site/build_site.py calls it."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

project = "abut"
author = "the authors of abut"
extensions = ["myst_parser", "breathe", "navigation", "source_pages"]
root_doc = "index"
source_suffix = {".md": "markdown", ".rst": "restructuredtext"}
# The staged folder holds links to all of the project; these are its pages.
include_patterns = ["index.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "CHANGELOG.md", "SECURITY.md",
                    "docs/**",
                    "reference/*", "benchmarks/notes/*"]
exclude_patterns = ["docs/README.md", "docs/site", "docs/images", "src", "include", "tests", "cli",
                    "benchmarks/[!n]*", "examples", "scenes", "scripts", "cmake"]

# Links to headings as on a forge.
myst_heading_anchors = 4

breathe_default_project = "abut"
breathe_default_members = ("members",)
default_role = None
primary_domain = "cpp"
highlight_language = "text"
cpp_maximum_signature_line_length = 80

# Every name that the interface mentions must be known, but for those of others.
nitpicky = True
nitpick_ignore_regex = [
    (r"cpp:.*", r"std(::.*)?"),
    (r"cpp:.*", r"abut|(abut::)?detail(::.*)?"),
    # Names of parameters of templates.
    (r"cpp:.*", r"(T|X|Y|Z|R|Dim|Others|Struct|Points|Lower|Upper|Visitor|Contact|Cells|U)"),
]

html_theme = "furo"
html_title = "abut"
html_static_path = ["static"]
html_css_files = ["abut.css"]
html_show_sourcelink = False
html_copy_source = False
html_show_copyright = False
html_show_sphinx = False
pygments_style = "friendly"

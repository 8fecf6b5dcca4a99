"""The code blocks of the project's pages.

A fence names its language, and the language says what the tests do with the block:

  cpp          compiled; run when it is a whole program
  text output  what the whole program before it prints
  console      lines "$ command" are run, the lines below compared with what they print
  cmake        configured
  python       a session with prompts, run by tests/python; the blocks of a page are one session
  sh           not run; commands that are paths must exist
  text, csv    for the reader only
"""

import dataclasses
import pathlib
import re

LANGUAGES = {"cpp", "text output", "console", "cmake", "python", "sh", "text", "csv"}
TOP_PAGES = ("README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "CHANGELOG.md")


@dataclasses.dataclass(frozen=True)
class Block:
    page: pathlib.Path
    line: int  # of the opening fence, from 1
    language: str
    text: str

    def where(self):
        return f"{self.page}:{self.line}"


class PageError(Exception):
    """A page that cannot be read as pages of this project are."""


def pages(root):
    """All pages, in a fixed order."""
    found = [root / name for name in TOP_PAGES if (root / name).exists()]
    for folder in ("docs", "benchmarks/notes"):
        found += sorted((root / folder).rglob("*.md"))
    return found


def blocks_of(page):
    """The fenced blocks of one page, in order."""
    found, language, start, lines = [], None, 0, []
    for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), 1):
        fence = re.match(r"^\s*```(.*)$", line)
        if not fence:
            if language is not None:
                lines.append(line)
        elif language is None:
            language, start, lines = fence.group(1).strip(), number, []
            if language not in LANGUAGES:
                known = ", ".join(sorted(LANGUAGES))
                raise PageError(f"{page}:{number}: language '{language}'; there are {known}")
        else:
            found.append(Block(page, start, language, "\n".join(lines) + "\n"))
            language = None
    if language is not None:
        raise PageError(f"{page}:{start}: this block has no end")
    return found


def blocks(root, language):
    """All blocks of one language, those of one page together."""
    return [b for page in pages(root) for b in blocks_of(page) if b.language == language]

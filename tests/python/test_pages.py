"""The sessions of Python on the pages run and print what stands there."""

import doctest
import sys

import pytest
from conftest import SOURCES

sys.path.insert(0, str(SOURCES / "tests" / "docs"))
import blocks  # noqa: E402  (beside the other checks of pages)


def sessions():
    """Pages with blocks of Python, and these blocks."""
    for page in blocks.pages(SOURCES):
        found = [block for block in blocks.blocks_of(page) if block.language == "python"]
        if found:
            yield page.relative_to(SOURCES).as_posix(), found


SESSIONS = dict(sessions())


def test_there_are_pages():
    assert "docs/python.md" in SESSIONS


@pytest.mark.parametrize("page", SESSIONS)
def test_page(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MPLBACKEND", "Agg")
    (tmp_path / "examples").symlink_to(SOURCES / "examples")
    parser, runner, session = doctest.DocTestParser(), doctest.DocTestRunner(), {}
    for block in SESSIONS[page]:
        examples = parser.get_doctest(block.text, session, page, page, block.line)
        assert examples.examples, f"{block.where()}: no prompt"
        report = []
        runner.run(examples, out=report.append, clear_globs=False)
        session = examples.globs
        assert not report, "".join(report)
    pictures = [picture.name for picture in tmp_path.glob("*.png")]
    assert all((SOURCES / "docs" / "images" / name).is_file() for name in pictures)
    assert all(f"images/{name}" in (SOURCES / page).read_text() for name in pictures)

"""The annotations hold: of the package itself, and as a caller's type checker sees them."""

import os
from pathlib import Path

from conftest import SOURCES
from mypy import api

CALLER = """\
import abut

contacts = abut.contacts([[0.0, 0.0]], 0.5, margin=0.1)
reveal_type(contacts.gap)
reveal_type(abut.neighbors([[0.0, 0.0]], 1.0, kind="full", threads=1).neighbors)
reveal_type(abut.Detector(skin="auto").contacts([[0.0, 0.0]], 0.5).statistics.threads)
abut.contacts([[0.0, 0.0]], 0.5, margin="wide")
abut.neighbors([[0.0, 0.0]], 1.0, bound=3)
contacts.gaps
"""


def checked(tmp_path, *arguments):
    config = str(SOURCES / "pyproject.toml")
    options = ["--config-file", config, "--cache-dir", str(tmp_path / "cache")]
    return api.run([*options, *arguments])


def test_package(tmp_path, monkeypatch):
    monkeypatch.setenv("MYPYPATH", os.environ.get("PYTHONPATH", ""))
    output, errors, status = checked(tmp_path, "-p", "abut")
    assert (status, errors) == (0, ""), output


def test_caller(tmp_path, monkeypatch):
    monkeypatch.setenv("MYPYPATH", os.environ.get("PYTHONPATH", ""))
    (tmp_path / "caller.py").write_text(CALLER)
    output = checked(tmp_path, str(tmp_path / "caller.py"))[0]
    of_caller = [line.split(":", 1)[1] for line in output.splitlines() if "caller.py" in line]
    revealed = [line for line in of_caller if "Revealed type" in line]
    assert ["float64" in revealed[0], "32" in revealed[1], '"int' in revealed[2]] == [True] * 3
    wrong = [int(line.split(":")[0]) for line in of_caller if "error:" in line]
    assert wrong == [7, 8, 9], output


def test_package_says_that_it_is_typed():
    import abut

    assert (Path(abut.__file__).parent / "py.typed").is_file()
    assert (Path(abut.__file__).parent / "_abut.pyi").is_file()

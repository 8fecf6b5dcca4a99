"""Runs the tool ($ABUT) as its users do and looks at standard output, standard error, exit code."""

import os
import pathlib
import re
import subprocess

import pytest

DATA = pathlib.Path(__file__).resolve().parents[2] / "examples" / "data"
GOLDEN = pathlib.Path(__file__).resolve().parent / "golden"
BOOK_ALGORITHMS = ["direct_check", "binary_tree", "screening_array", "sorting_array", "munjiza_nbs"]
ALGORITHMS = [*BOOK_ALGORITHMS, "rows"]
DISCS = "x,y,radius\n0,0,1\n2,0,1\n5,0,1\n5,1.5,1\n"


def environment(**changes):
    """The caller's, without what changes the tool's manners."""
    kept = {k: v for k, v in os.environ.items() if k not in ("CI", "TERM", "NO_COLOR")}
    return {**kept, **changes}


@pytest.fixture
def abut():
    """abut(arguments..., stdin=bytes) -> CompletedProcess with text output."""

    def run(*arguments, stdin=b"", env=None, cwd=None, stdout=subprocess.PIPE):
        if isinstance(stdin, str):
            stdin = stdin.encode()
        done = subprocess.run(
            [os.environ["ABUT"], *map(str, arguments)],
            input=stdin, stdout=stdout, stderr=subprocess.PIPE,
            env=env or environment(), cwd=cwd, check=False, timeout=300)
        done.stdout = (done.stdout or b"").decode()
        done.stderr = done.stderr.decode()
        return done

    return run


@pytest.fixture
def fails(abut):
    """fails(code, arguments...): the exit code and one sentence on standard error, no output."""

    def run(code, *arguments, **keywords):
        done = abut(*arguments, **keywords)
        assert (done.returncode, done.stdout) == (code, ""), done.stderr
        sentences = [line for line in done.stderr.splitlines() if ": frame " not in line]
        assert len(sentences) == 1, done.stderr
        assert sentences[0].startswith("abut: "), done.stderr
        assert len(sentences[0]) < 400, done.stderr
        return sentences[0]

    return run


@pytest.fixture(scope="session")
def long_search(tmp_path_factory):
    """Arguments of a search that takes minutes."""
    path = tmp_path_factory.mktemp("scene") / "gas.csv"
    subprocess.run([os.environ["ABUT"], "generate", "gas", "--count", "300000", "-o", path, "-q"],
                   check=True, timeout=300)
    return ["contacts", str(path), "--algorithm", "direct_check"]


@pytest.fixture
def golden():
    """golden(name, text): as recorded; ABUT_RECORD_GOLDEN=1 records anew."""

    def check(name, text):
        path = GOLDEN / f"{name}.txt"
        if os.environ.get("ABUT_RECORD_GOLDEN"):
            path.write_text(text)
        assert text == path.read_text(), f"see {path.name}; ABUT_RECORD_GOLDEN=1 records anew"
        for line in text.splitlines():
            assert len(line) <= 100 and line == line.rstrip(), line

    return check


def without_measurements(text):
    """Times and memory differ from run to run or from version to version."""
    text = re.sub(r"\d+(\.\d+)? (ms|s)\b", "<time>", text)
    return re.sub(r"\d+(\.\d+)? (B|kB|MB|GB)\b", "<memory>", text)


def pairs_of_csv(text):
    """(i, j) of each line below the header, in order."""
    return [tuple(int(field) for field in line.split(",")[:2]) for line in text.splitlines()[1:]]

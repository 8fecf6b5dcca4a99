"""Data on standard output, talk on standard error; pipes and terminals."""

import os
import pty
import subprocess
import time

import pytest
from conftest import DATA, DISCS, environment, pairs_of_csv

YADE = str(DATA / "yade_settled_5000.csv")


def test_standard_input(abut):
    text = (DATA / "yade_settled_5000.csv").read_text()
    assert abut("contacts", "-", "--count", stdin=text).stdout == "10658\n"
    assert abut("info", "-", stdin=text).stdout.startswith("standard input\n")
    dump = (DATA / "lammps_pour.dump").read_text()
    assert abut("contacts", "-", "--count", "--periodic", "none", stdin=dump).stdout == "4158\n"


def test_pairs_take_standard_output(abut):
    done = abut("contacts", "-", "-o", "-", stdin=DISCS)
    assert pairs_of_csv(done.stdout) == [(0, 1), (2, 3)]
    assert "contact pairs    2" in done.stderr
    assert abut("contacts", "-", "-o", "-", "--count", stdin=DISCS).stderr == "2\n"


def test_quiet(abut, tmp_path):
    out = tmp_path / "out.csv"
    for arguments in (["-o", out], []):
        done = abut("contacts", "-", "-q", *arguments, stdin=DISCS)
        assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    assert pairs_of_csv(out.read_text()) == [(0, 1), (2, 3)]
    assert abut("contacts", "-", "-q", "--count", stdin=DISCS).stdout == "2\n"
    dump = DATA / "lammps_pour.dump"
    assert abut("contacts", dump, "-q", "--count", "--periodic", "none").stderr == ""


def test_output_beside_a_report(abut, tmp_path):
    out = tmp_path / "out.csv"
    assert abut("contacts", "-", "-o", out, "--count", stdin=DISCS).stdout == "2\n"
    assert out.read_text().startswith("i,j,gap\n0,1,0\n2,3,-0.5")


@pytest.mark.parametrize("arguments", [
    ["contacts", YADE, "-o", "-"], ["contacts", YADE], ["contacts", YADE, "--count"],
    ["generate", "gas", "--count", "200000"], ["--help"], ["algorithms"], ["info", YADE]])
def test_closed_pipe(arguments):
    """Like `| head -1`, with a reader that is gone at once."""
    read_end, write_end = os.pipe()
    os.close(read_end)
    done = subprocess.run([os.environ["ABUT"], *arguments], stdout=write_end,
                          stderr=subprocess.PIPE, env=environment(), check=False, timeout=300)
    os.close(write_end)
    assert (done.returncode, done.stderr) == (0, b"")


def test_closed_standard_streams(tmp_path):
    """A file that is written must not take the number of a standard stream that is closed."""
    out = tmp_path / "out.csv"
    shell = f"'{os.environ['ABUT']}' contacts '{YADE}' -o '{out}' >&- 2>&-"
    done = subprocess.run(["sh", "-c", shell], check=False, timeout=300, env=environment())
    assert done.returncode == 5
    assert len(pairs_of_csv(out.read_text())) == 10658


def test_scene_through_a_pipe(abut):
    for scene in ("gas", "pack_1", "two_far_clusters"):
        text = abut("generate", scene, "--count", "300", "--seed", "7").stdout
        assert text == abut("generate", scene, "--count", "300", "--seed", "7").stdout
        count = int(abut("contacts", "-", "--count", stdin=text).stdout)
        compared = abut("compare", scene, "--count", "300", "--seed", "7").stdout
        assert f" {count}  sha256:" in compared and "all the same pairs" in compared


@pytest.mark.parametrize("suffix", [".csv", ".dump", ".xyz"])
def test_generated_files_read_back(abut, tmp_path, suffix):
    path = tmp_path / f"gas{suffix}"
    done = abut("generate", "gas", "--count", "300", "-o", path)
    assert done.stdout == "" and "300 spheres" in done.stderr
    direct = abut("generate", "gas", "--count", "300").stdout
    assert abut("contacts", path, "--digest").stdout == abut(
        "contacts", "-", "--digest", stdin=direct).stdout


def test_one_radius_for_all(abut):
    assert abut("contacts", "-", "--count", "--radius", "5", stdin=DISCS).stdout == "6\n"
    points = "x,y\n0,0\n1,0\n"
    assert abut("contacts", "-", "--count", "--radius", "0.5", stdin=points).stdout == "1\n"


def test_format_names_the_side_it_can(abut, tmp_path):
    out = tmp_path / "pairs"
    assert abut("contacts", "-", "-o", out, "--format", "json", stdin=DISCS).returncode == 0
    assert out.read_text().startswith("{")
    assert abut("contacts", "-", "-o", out, "--format", "xyz", stdin=DISCS).returncode == 3
    assert abut("contacts", "-", "--count", "--format", "csv", stdin=DISCS).stdout == "2\n"


def test_compare_leaves_out_what_would_take_for_ever(abut):
    text = abut("compare", "gas", "--count", "50001").stdout
    assert "direct_check: left out above 50,000 elements" in text
    sparse = abut("compare", "sparse", "--count", "1000")
    assert sparse.returncode == 0
    assert "not run\n  screening_array would need" in sparse.stdout


def on_a_terminal(arguments, **changes):
    """Standard error of a long search on a terminal, stopped after a second of work."""
    controller, terminal = pty.openpty()
    process = subprocess.Popen([os.environ["ABUT"], *arguments], stdout=subprocess.PIPE,
                               stderr=terminal, env=environment(**changes))
    os.close(terminal)
    ticks = os.sysconf("SC_CLK_TCK")
    while process.poll() is None:
        with open(f"/proc/{process.pid}/stat") as file:
            if int(file.read().rpartition(")")[2].split()[11]) > ticks:
                break
        time.sleep(0.05)
    process.terminate()
    process.stdout.close()
    text = b""
    try:
        while block := os.read(controller, 4096):
            text += block
    except OSError:  # the terminal is closed
        pass
    os.close(controller)
    assert process.wait(timeout=60) == 130
    return text.decode()


@pytest.mark.parametrize("changes, arguments, has_bar", [
    ({"TERM": "xterm"}, [], True),
    ({"TERM": "xterm", "NO_COLOR": "1"}, [], True),
    ({"TERM": "dumb"}, [], False),
    ({"TERM": "xterm", "CI": "true"}, [], False),
    ({"TERM": "xterm"}, ["--quiet"], False),
    ({"TERM": "xterm"}, ["--progress", "none"], False)])
def test_bar(long_search, changes, arguments, has_bar):
    text = on_a_terminal([*long_search, *arguments], **changes)
    assert ("\rsearch " in text) == has_bar
    assert "\x1b" not in text, "no colours, no escape sequences"
    assert text.endswith("abut: interrupted\r\n")

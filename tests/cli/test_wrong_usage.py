"""Exit code 2: one sentence says which word was wrong, and nothing is written."""

import os
import subprocess

import pytest
from conftest import DATA, DISCS, environment

YADE = str(DATA / "yade_settled_5000.csv")


@pytest.mark.parametrize("arguments, told", [
    ([], "name a command"),
    (["--verbose"], "--version"),
    (["contact", YADE], "did you mean contacts?"),
    (["contacts", "--cout", YADE], "did you mean --count?"),
    (["neighbors", YADE, "--cutof", "1"], "did you mean --cutoff?"),
    (["contacts", YADE, "--digest=1", "--maxpairs=1"], "did you mean --max-pairs?"),
    (["contacts", YADE, "--algorithm", "muniza_nbs"], "did you mean munjiza_nbs?"),
    (["contacts", YADE, "--simd", "avx22"], "did you mean avx2?"),
    (["contacts", YADE, "--order", "canonicl"], "did you mean canonical?"),
    (["contacts", YADE, "--format", "lammps-dump"], "did you mean lammps_dump?"),
    (["generate", "dence", "--count", "5"], "did you mean dense?"),
    (["completion", "bahs"], "did you mean bash?"),
    (["contacts", YADE, "--with", "normal"], "--output"),
    (["contacts", YADE, "-o", "x.csv", "--with", "nromal"], "did you mean normal?"),
    (["contacts", YADE, "--columns", "x,z,radius"], "x and y among them"),
    (["contacts", str(DATA / "lammps_pour.dump"), "--columns", "x,y"], "leave out --columns"),
    (["contacts"], "FILE"),
    (["contacts", YADE, "--cube", "1,1,1"], "--cube"),
    (["contacts", YADE, "--algorithm", "grid"], "munjiza_nbs"),
    (["contacts", YADE, "--threads", "-1"], "--threads -1"),
    (["contacts", YADE, "--threads", "two"], "--threads two"),
    (["contacts", YADE, "--simd", "sse5"], "avx512"),
    (["contacts", YADE, "--order", "random"], "canonical or as_found"),
    (["contacts", YADE, "--margin", "-1"], "--margin -1"),
    (["contacts", YADE, "--margin", "nan"], "--margin nan"),
    (["contacts", YADE, "--margin", "inf"], "--margin inf"),
    (["contacts", YADE, "--margin", "1e999"], "--margin 1e999"),
    (["contacts", YADE, "--margin", "0,5"], "--margin 0,5"),
    (["contacts", YADE, "--margin"], "--margin"),
    (["contacts", YADE, "--radius", "-1"], "--radius -1"),
    (["contacts", YADE, "--frame", "last"], "--frame last"),
    (["contacts", YADE, "--max-pairs", "-1"], "--max-pairs -1"),
    (["contacts", YADE, "--max-memory", "0"], "--max-memory 0"),
    (["contacts", YADE, "--max-memory", "1T"], "--max-memory 1T"),
    (["contacts", YADE, "--max-memory", "99999999999G"], "--max-memory"),
    (["contacts", YADE, "--count", "--digest"], "exclude"),
    (["contacts", YADE, "--count", "--json"], "exclude"),
    (["contacts", YADE, "--json", "--digest"], "exclude"),
    (["contacts", YADE, "--ids"], "--output"),
    (["contacts", YADE, "--format", "pdf"], "pdf"),
    (["contacts", YADE, "-o", "x.pdf"], "pdf"),
    (["contacts", YADE, "-o", "x.csv.gz"], "csv, json and vtp"),
    (["contacts", YADE, "-o", "x.vtp", "--format", "json"], "OUT is named .vtp"),
    (["contacts", YADE, "-o", "x.csv", "--format", "vtp"], "OUT is named .csv"),
    (["neighbors", YADE, "--cutoff", "2.5", "-o", "n.vtp"], "--radius 0 --margin 2.5 -o n.vtp"),
    (["neighbors", YADE, "--cutoff", "2.5", "-o", "n.JSON"], "--radius 0 --margin 2.5 -o n.JSON"),
    (["neighbors", YADE, "--cutoff", "2.5", "-o", "n.csv.gz"], "name a file .csv"),
    (["generate", "gas", "--count", "1000000000000", "-o", "x.vtp"], "'vtp'"),
    (["contacts", YADE, "-o", YADE], "is read"),
    (["contacts", YADE, "-o", ""], "-o ''"),
    (["neighbors", YADE, "--cutoff", "1", "--output", ""], "-o ''"),
    (["generate", "gas", "--count", "5", "-o", ""], "-o ''"),
    (["contacts", YADE, "--format", ""], "--format ''"),
    (["contacts", ""], "FILE ''"),
    (["explain", "munjiza_nbs", ""], "FILE ''"),
    (["compare", ""], "FILE|SCENE ''"),
    (["nosuch", "--help"], "'nosuch'"),
    (["--help", "nosuch"], "'nosuch'"),
    (["nosuch", "-h", "contacts"], "'nosuch'"),
    (["--version", "nosuch"], "nosuch"),
    (["contacts", YADE, "--periodic", "x", "--box", "inf,1,1"], "--periodic names x"),
    (["contacts", YADE, "--box", "1,1,inf", "--periodic", "xyz"], "--periodic names z"),
    (["contacts", "-", "--box", "1,1", "--periodic", "z"], "--periodic names z"),
    (["contacts", "-", "--box", "1,1", "--periodic", "xz"], "--periodic names z"),
    (["contacts", YADE, "--periodic", "xy"], "--box"),
    (["contacts", YADE, "--periodic", "xyx"], "--periodic xyx"),
    (["contacts", YADE, "--periodic", ""], "none, or axes"),
    (["contacts", YADE, "--box", "1,1"], "lx,ly,lz"),
    (["contacts", YADE, "--box", "1,1,"], "--box"),
    (["contacts", YADE, "--box", "1,0,1"], "ly = 0"),
    (["contacts", YADE, "--box", "1,nan,1"], "ly = nan"),
    (["contacts", YADE, "--lattice", "1,0,0,1"], "4 numbers for spheres"),
    (["contacts", YADE, "--lattice", "1,0,0,0,1,0,1,1,0"], "dependent"),
    (["contacts", YADE, "--box", "1,1,1", "--lattice", "1,0,0,0,1,0,0,0,1"], "excludes"),
    (["contacts", YADE, "--box", "1,1,1", "--algorithm", "munjiza_nbs"], "direct_check"),
    (["explain", "munjiza_nbs", YADE, "--box", "1,1,1"], "'--box' is no option"),
    (["explain", "munjiza_nbs", YADE, "--periodic", "x"], "--periodic x"),
    (["explain", "munjiza_nbs", str(DATA / "lammps_pour.dump")], "--periodic none"),
    (["contacts", YADE, "--progress", "loud"], "auto, bar, log or none"),
    (["generate"], "--list"),
    (["generate", "gas"], "--count"),
    (["generate", "nothing", "--count", "5"], "abut generate --list"),
    (["generate", "gas", "--count", "-5"], "--count -5"),
    (["generate", "gas", "--count", "1.5"], "whole number such as 5000 or 1e6"),
    (["generate", "gas", "--count", "1e-1"], "--count 1e-1"),
    (["generate", "gas", "--count", "2e19"], "--count 2e19"),
    (["generate", "gas", "--count", "1e99999999999"], "--count 1e99"),
    (["generate", "gas", "--count", "e3"], "--count e3"),
    (["generate", "gas", "--count", "."], "--count ."),
    (["generate", "gas", "--count", "5", "--format", "pdf"], "pdf"),
    (["compare", "gas"], "--count"),
    (["compare", YADE, "--algorithms", "munjiza_nbs,fast"], "fast"),
    (["compare", YADE, "--algorithms", "auto"], "auto"),
    (["bench", "gas"], "--count"),
    (["bench", YADE, "--algorithms", "auto"], "auto"),
    (["bench", YADE, "--threads", "1,-2"], "--threads -2"),
    (["bench", YADE, "--threads", "1,,2"], "--threads"),
    (["bench", YADE, "--repetitions", "0"], "--repetitions 0"),
    (["explain", "munjiza_nbs"], "--book"),
    (["explain", "rows", "--book"], "no example of rows"),
    (["explain", "munjiza_nbs", YADE, "--book"], "--book"),
    (["explain", "auto", "--book"], "auto"),
])
def test_2_wrong_usage(fails, tmp_path, arguments, told):
    assert told in fails(2, *arguments, cwd=tmp_path, stdin=DISCS)
    assert list(tmp_path.iterdir()) == []


def test_0_help_of_a_command_whatever_else(abut):
    """Who asks for help need not know the options."""
    assert abut("contacts", "--nosuch", "--help").stdout == abut("contacts", "--help").stdout


@pytest.mark.parametrize("arguments", [["contacts", "INPUT"],
                                       ["neighbors", "INPUT", "--cutoff", "1"],
                                       ["contacts", "other.csv", "--against", "INPUT"],
                                       ["contacts", "other.csv", "--exclude", "INPUT"]])
@pytest.mark.parametrize("given", ["file.csv", "./file.csv", "link.csv", "hard.csv", "-",
                                   "/dev/stdin", "/proc/self/fd/0"])
@pytest.mark.parametrize("output", ["file.csv", "link.csv", "hard.csv", "../FOLDER/file.csv", "-",
                                    "/dev/stdout"])
def test_2_the_output_is_the_input(tmp_path, arguments, given, output):
    """By any name, through links, standard streams included: the input stays as it is."""
    path = tmp_path / "file.csv"
    path.write_text(DISCS)
    (tmp_path / "other.csv").write_text(DISCS)
    (tmp_path / "link.csv").symlink_to("file.csv")
    os.link(path, tmp_path / "hard.csv")
    words = [given if word == "INPUT" else word for word in arguments]
    with open(path) as source, open(path, "a") as target:
        done = subprocess.run(
            [os.environ["ABUT"], *words, "-q", "-o", output.replace("FOLDER", tmp_path.name)],
            cwd=tmp_path, stdin=source, stderr=subprocess.PIPE, env=environment(),
            stdout=target if output in ("-", "/dev/stdout") else subprocess.DEVNULL, check=False)
    assert done.returncode == 2 and b"is read" in done.stderr, done.stderr
    assert path.read_text() == DISCS and len(list(tmp_path.iterdir())) == 4


def test_0_what_is_both_read_and_written(tmp_path):
    """Devices and pipes may be both, and files that only look alike."""
    (tmp_path / "a.csv").write_text(DISCS)
    (tmp_path / "b.csv").write_text(DISCS)
    for words in (["a.csv", "-o", "b.csv"], ["/dev/null", "-o", "/dev/null"],
                  ["-", "-o", "-"], ["-", "-o", "/dev/stdout"]):
        done = subprocess.run([os.environ["ABUT"], "contacts", *words, "-q"], cwd=tmp_path,
                              input=DISCS.encode(), capture_output=True, env=environment(),
                              check=False)
        assert done.returncode == 0, done.stderr


def test_2_rows_has_nothing_to_explain(abut):
    done = abut("explain", "rows", "-", stdin=DISCS)
    assert (done.returncode, done.stdout) == (2, "") and "no arrays to show" in done.stderr

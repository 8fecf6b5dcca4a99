"""Texts that do not depend on the machine, as recorded in golden/."""

import re

import pytest
from conftest import BOOK_ALGORITHMS, DATA, DISCS, without_measurements


@pytest.mark.parametrize("algorithm", BOOK_ALGORITHMS)
def test_explain_book(abut, golden, algorithm):
    done = abut("explain", algorithm, "--book")
    assert (done.returncode, done.stderr) == (0, "")
    golden(f"explain_{algorithm}_book", done.stdout)


@pytest.mark.parametrize("algorithm", BOOK_ALGORITHMS)
def test_explain_file(abut, golden, algorithm):
    """Six spheres in three layers, numbered from 0."""
    spheres = "x,y,z,radius\n0,0,0,1\n2.5,0,0,1\n2,2,2.5,1\n9,9,5,1\n0,0,1,1\n4,0,0,1\n"
    done = abut("explain", algorithm, "-", stdin=spheres)
    assert (done.returncode, done.stderr) == (0, "")
    golden(f"explain_{algorithm}_file", done.stdout)


@pytest.mark.parametrize(
    "command", ["", "contacts", "neighbors", "info", "generate", "compare", "bench", "explain", "algorithms",
                "completion"])
def test_help(abut, golden, command):
    done = abut(*command.split(), "--help")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith(f"abut {command}".strip()), "an example comes first"
    golden(f"help_{command or 'abut'}", done.stdout)


def test_algorithms(abut, golden):
    golden("algorithms", abut("algorithms").stdout)


def test_scenes(abut):
    lines = abut("generate", "--list").stdout.splitlines()
    assert any(line.split()[:2] == ["dense", "3D"] for line in lines)
    assert all(re.match(r"\w+ +[23]D  \S", line) for line in lines)


@pytest.mark.parametrize("name, arguments", [
    ("csv", []), ("csv_margin", ["--margin", "1"]), ("json", ["--format", "json"])])
def test_pairs_of_four_discs(abut, golden, name, arguments):
    done = abut("contacts", "-", "-o", "-", "-q", *arguments, stdin=DISCS)
    assert (done.returncode, done.stderr) == (0, "")
    golden(f"discs_{name}", done.stdout)


@pytest.mark.parametrize("arguments, expected", [
    ([], "i,j,distance\n0,1,5\n"),
    (["--full"], "i,j,distance\n0,1,5\n1,0,5\n"),
    (["--half", "--box", "14,inf"],
     "i,j,nx,ny,nz,distance\n0,1,0,0,0,5\n0,2,-1,0,0,2.5\n1,2,-1,0,0,6.800735254367722\n")])
def test_neighbors_of_points(abut, arguments, expected):
    done = abut("neighbors", "-", "--cutoff", "8.5", "-o", "-", "-q", *arguments,
                stdin="x,y\n0,0\n3,4\n11.5,0\n")
    assert (done.returncode, done.stderr, done.stdout) == (0, "", expected)


def test_neighbors_summary_and_errors(abut):
    done = abut("neighbors", "-", "--cutoff", "5", stdin="x,y\n0,0\n3,4\n9,9\n")
    assert (done.returncode, done.stderr) == (0, "")
    assert "1 in a half list of 1 pair" in done.stdout and "2 of 3 have none" in done.stdout
    assert abut("neighbors", "-", stdin="x,y\n").returncode == 2
    bad = abut("neighbors", "-", "--cutoff", "-1", stdin="x,y\n")
    assert bad.returncode == 2 and "--cutoff" in bad.stderr
    boxes = abut("neighbors", "-", "--cutoff", "1", stdin=BOXES)
    assert boxes.returncode in (2, 3) and "boxes" in boxes.stderr


@pytest.mark.parametrize("name, arguments", [
    ("csv", []), ("json", ["--format", "json"])])
def test_pairs_of_periodic_discs(abut, golden, name, arguments):
    """In a box that two of them span, and one touches itself."""
    done = abut("contacts", "-", "-o", "-", "-q", "--box", "4,2", *arguments, stdin=DISCS)
    assert (done.returncode, done.stderr) == (0, "")
    golden(f"periodic_discs_{name}", done.stdout)


BOXES = "xmin,ymin,zmin,xmax,ymax,zmax\n0,0,0,1,1,1\n1,1,1,2,2,2\n1.5,1,0,3,1.25,1\n9,9,9,9,9,9\n"


def test_pairs_and_summary_of_boxes(abut, golden):
    done = abut("contacts", "-", "-o", "-", "-q", stdin=BOXES)
    assert (done.returncode, done.stdout) == (0, "i,j,gap\n0,1,0\n1,2,0\n")
    golden("summary_boxes", without_measurements(abut("contacts", "-", stdin=BOXES).stdout))
    periodic = abut("contacts", "-", "-o", "-", "-q", "--box", "9,9,9", stdin=BOXES)
    assert (periodic.returncode, periodic.stderr) == (0, "")
    assert periodic.stdout == ("i,j,nx,ny,nz,gap\n0,1,0,0,0,0\n0,3,-1,-1,-1,0\n1,2,0,0,0,0\n")


@pytest.mark.parametrize("name, arguments", [
    ("discs", ["-"]),
    ("periodic_discs", ["-", "--box", "4,2.5", "--periodic", "y"]),
    ("lammps_periodic", ["lammps_pour.dump"]),
    ("discs_margin", ["-", "--margin", "1"]),
    ("yade", ["yade_settled_5000.csv"]),
    ("lammps", ["lammps_pour.dump", "--periodic", "none"]),
    ("lammps_empty_frame", ["lammps_pour.dump", "--periodic", "none", "--frame", "0"])])
def test_summary(abut, golden, name, arguments):
    done = abut("contacts", *arguments, stdin=DISCS, cwd=DATA)
    assert done.returncode == 0
    golden(f"summary_{name}", without_measurements(done.stdout))


@pytest.mark.parametrize("name", ["yade_settled_5000.csv", "lammps_pour.dump"])
def test_info(abut, golden, name):
    golden(f"info_{name}", abut("info", name, cwd=DATA).stdout)


def test_compare(abut, golden):
    text = without_measurements(abut("compare", "-", stdin=DISCS).stdout)
    golden("compare_discs", re.sub(r"(?<=\S) {2,}", "  ", text))


def test_bench(abut, golden):
    """What is measured, in which order; what of several is the best is not told by its name."""
    text = abut("bench", "-", "--algorithms", "rows,direct_check", "--threads", "1,2",
                "--repetitions", "3", stdin=DISCS).stdout
    text = re.sub(r"^  \w+ +\d+(  (count|half list|full list))", r"  best\1", text, flags=re.M)
    text = re.sub(r"(canonical|as_found|count|list) +[-.,\d ]+$", r"\1 <numbers>", text,
                  flags=re.M)
    golden("bench_discs", re.sub(r"(?<=\S) {2,}", "  ", text))


@pytest.mark.parametrize("name, quantities", [
    ("csv", "point,normal,gap,distance,vector"), ("json", "normal")])
def test_pairs_with_quantities(abut, golden, name, quantities):
    done = abut("contacts", "-", "-o", "-", "-q", "--with", quantities, "--format", name,
                stdin=DISCS)
    assert (done.returncode, done.stderr) == (0, "")
    golden(f"discs_with_{name}", done.stdout)


def test_version(abut):
    header = (DATA.parents[1] / "include" / "abut" / "version.hpp").read_text()
    numbers = re.findall(r"#define ABUT_VERSION_\w+ (\d+)", header)
    assert abut("--version").stdout == f"abut {'.'.join(numbers)}\n"
    verbose = abut("--version", "--verbose").stdout
    assert verbose.startswith(f"abut {'.'.join(numbers)} (")
    assert re.search(r"^  Highway  .*\n  OpenMP  .*\n  SIMD levels here  scalar", verbose, re.M)

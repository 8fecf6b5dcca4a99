"""The packings of examples/data against what other programs say about them."""

import hashlib
import math
import shutil
import struct
import subprocess

import pytest
from conftest import ALGORITHMS, DATA, environment, pairs_of_csv

YADE = DATA / "yade_settled_5000.csv"
LAMMPS = DATA / "lammps_pour.dump"


def digest(pairs):
    packed = b"".join(struct.pack("<II", i, j) for i, j in sorted(pairs))
    return "sha256:" + hashlib.sha256(packed).hexdigest()


@pytest.mark.parametrize("algorithm", [*ALGORITHMS, "auto"])
def test_yades_own_contacts(abut, algorithm):
    known = pairs_of_csv((DATA / "yade_settled_5000.yade_contacts.csv").read_text())
    assert len(known) == len(set(known)) == 10658
    done = abut("contacts", YADE, "-o", "-", "--digest", "--algorithm", algorithm)
    found = pairs_of_csv(done.stdout)
    assert found == sorted(known)
    assert done.stderr == digest(known) + "\n"


@pytest.mark.parametrize("algorithm", ALGORITHMS)
def test_lammps_taken_as_open(abut, algorithm):
    done = abut("contacts", LAMMPS, "--periodic", "none", "--count", "--algorithm", algorithm)
    assert (done.returncode, done.stdout) == (0, "4158\n")


def lammps_atoms():
    """The atoms of the last frame, as LAMMPS names their columns."""
    text = LAMMPS.read_text()
    rows = text[text.rindex("ITEM: ATOMS"):].splitlines()
    return [dict(zip(rows[0].split()[2:], map(float, row.split()))) for row in rows[1:]]


def test_periodic_contacts_are_those_that_lammps_counts(abut):
    atoms = lammps_atoms()
    rows = [line.split(",") for line in
            abut("contacts", LAMMPS, "-o", "-", "-q").stdout.splitlines()]
    assert rows[0] == ["i", "j", "nx", "ny", "nz", "gap"] and len(rows) == 4402
    own = [0] * len(atoms)
    for i, j, *shift, gap in rows[1:]:
        i, j, (nx, ny, nz) = int(i), int(j), map(int, shift)
        own[i] += 1
        own[j] += 1
        a, b = atoms[i], atoms[j]
        distance = math.hypot(a["x"] - b["x"] - 20 * nx, a["y"] - b["y"] - 20 * ny, a["z"] - b["z"])
        assert abs(distance - a["radius"] - b["radius"] - float(gap)) < 1e-12 and nz == 0
    assert own == [round(atom["c_c"]) for atom in atoms]


def test_periodic_digest_can_be_recomputed(abut):
    rows = [tuple(map(int, line.split(",")[:5])) for line in
            abut("contacts", LAMMPS, "-o", "-", "-q").stdout.splitlines()[1:]]
    assert rows == sorted(rows)
    packed = b"".join(struct.pack("<IIiii", *row) for row in rows)
    for order in ("canonical", "as_found"):
        done = abut("contacts", LAMMPS, "--digest", "--order", order)
        assert done.stdout == f"sha256:{hashlib.sha256(packed).hexdigest()}\n"


@pytest.mark.parametrize("arguments", [
    ["--periodic", "xy"], ["--box", "20,20,inf"], ["--box", "20,20,1", "--periodic", "xy"],
    ["--lattice", "20,0,0,-60,20,0,0,0,0", "--periodic", "xy"]])
def test_the_same_domain_in_other_words(abut, arguments):
    assert abut("contacts", LAMMPS, "--count", *arguments).stdout == "4401\n"


def test_commands_for_open_space_refuse_a_periodic_box(fails, abut):
    assert "--periodic none" in fails(2, "explain", "munjiza_nbs", LAMMPS)
    assert "at most 1,000" in fails(4, "explain", "munjiza_nbs", LAMMPS, "--periodic", "none")
    assert "munjiza_nbs" in fails(2, "bench", LAMMPS, "--algorithms", "munjiza_nbs")
    done = abut("compare", LAMMPS)
    assert done.returncode == 0 and "munjiza_nbs: does not support periodic domains" in done.stdout


def test_bench_of_a_periodic_box(abut):
    """Also where elements touch images of themselves, which full lists hold twice."""
    done = abut("bench", LAMMPS, "--repetitions", "1", "--threads", "1")
    assert done.returncode == 0, done.stderr
    assert "periodic in x and y, 4,401 contact pairs" in done.stdout
    assert "direct_check" in done.stdout and "munjiza_nbs" not in done.stdout
    assert "all the same pairs" in done.stdout
    own = abut("bench", "-", "--box", "1,inf", "--repetitions", "1", "--threads", "1",
               stdin="x,y,radius\n0,0,1.1\n0,9,0.6\n")
    assert own.returncode == 0 and "all the same pairs" in own.stdout, own.stderr


def test_frames(abut, fails):
    first = abut("contacts", LAMMPS, "--periodic", "none", "--frame", "0", "--digest")
    assert first.stdout == digest([]) + "\n"
    assert first.stderr == f"abut: {LAMMPS}: frame 0, the first of 2\n"
    for frame in (["--frame", "-1"], ["--frame", "1"], []):
        last = abut("contacts", LAMMPS, "--periodic", "none", "--count", *frame)
        assert last.stdout == "4158\n"
        assert last.stderr == f"abut: {LAMMPS}: frame 1, the last of 2\n"
    assert "frame" in fails(3, "contacts", LAMMPS, "--periodic", "none", "--frame", "2")


def test_ids(abut, fails):
    done = abut("contacts", LAMMPS, "--periodic", "none", "-o", "-", "--ids", "-q")
    lines = done.stdout.splitlines()
    assert lines[0] == "i,j,id_i,id_j,gap"
    assert all(int(line.split(",")[2]) >= 1 for line in lines[1:]) and len(lines) == 4159
    assert "--ids" in fails(2, "contacts", YADE, "-o", "-", "--ids")


def test_as_found_order_has_the_same_digest(abut):
    order = ["--order", "as_found"]
    found = abut("contacts", YADE, "-o", "-", "-q", *order).stdout
    canonical = abut("contacts", YADE, "-o", "-", "-q").stdout
    assert found != canonical
    assert sorted(pairs_of_csv(found)) == pairs_of_csv(canonical)
    assert abut("contacts", YADE, "--digest", *order).stdout == abut(
        "contacts", YADE, "--digest").stdout


def test_no_locale_matters(abut, tmp_path):
    """Where the locale can be made, it writes 0,5 for 0.5."""
    if shutil.which("localedef"):
        subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", tmp_path / "de_DE.UTF-8"],
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
    german = environment(LC_ALL="de_DE.UTF-8", LOCPATH=str(tmp_path))
    plain = abut("contacts", YADE, "-o", "-", "-q").stdout
    assert abut("contacts", YADE, "-o", "-", "-q", env=german).stdout == plain
    summary = abut("contacts", YADE, "--margin", "0.01", env=german).stdout
    assert "17,395, touching or at most 0.01 apart" in summary

"""The packings of examples/data against what other programs say about them."""

import hashlib
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


def test_periodic_box_is_never_silently_open(fails, tmp_path):
    out = tmp_path / "contacts.csv"
    for command in (["contacts", LAMMPS, "-o", out], ["contacts", LAMMPS, "--count"],
                    ["compare", LAMMPS], ["explain", "munjiza_nbs", LAMMPS]):
        assert "--periodic none" in fails(2, *command)
    assert not out.exists()


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

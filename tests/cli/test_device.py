"""--device: the sentences where there is none, and the same output from a stand-in on the host."""

import json
import os
import subprocess

import pytest
from conftest import DATA, DISCS, environment, without_measurements

YADE = str(DATA / "yade_settled_5000.csv")
LAMMPS = str(DATA / "lammps_pour.dump")
STAND_IN = "gpu:0, stand-in on the host"


@pytest.fixture
def with_device():
    """with_device(arguments...): the tool whose only device is the host."""

    def run(*arguments, stdin=""):
        return subprocess.run([os.environ["ABUT_WITH_STAND_IN"], *arguments], input=stdin,
                              capture_output=True, text=True, env=environment(), check=False,
                              timeout=300)

    return run


def has_device(abut):
    return "Devices here      none" not in abut("--version", "--verbose").stdout


def test_2_wrong_usage(fails):
    for name in ("tpu", "GPU", "gpu:", "gpu:-1", "gpu:x", "gpu:1x", "gpu:99999999999", ""):
        told = fails(2, "contacts", YADE, "--device", name)
        assert "cpu, gpu or gpu:N" in told
    for option in (["--threads", "2"], ["--simd", "scalar"],
                   ["--algorithm", "sorting_array"]):
        told = fails(2, "contacts", YADE, "--device", "gpu", *option)
        assert f"{option[0]}" in told and "leave out" in told and "--device" in told


def test_processor_is_the_default(abut):
    plain = abut("contacts", YADE, "--digest").stdout
    assert abut("contacts", YADE, "--digest", "--device", "cpu", "--threads", "2").stdout == plain
    assert json.loads(abut("contacts", YADE, "--json").stdout)["device"] == "cpu"


def test_6_without_a_device(abut, fails):
    """Before the file is read, which is not there; the sentence says which of the three it is."""
    number = "99" if has_device(abut) else "0"
    for arguments in (["contacts", "nosuch.csv"], ["contacts", "nosuch.csv", "--count"],
                      ["neighbors", "nosuch.csv", "--cutoff", "1"], ["bench", "nosuch.csv"]):
        told = fails(6, *arguments, "--device", f"gpu:{number}")
        assert told.endswith("; leave out --device") and "abut::" not in told
        reasons = ("no driver of CUDA", "finds none", "the driver is of CUDA",
                   "this build of abut has no CUDA", "there is no device 99")
        assert sum(reason in told for reason in reasons) == 1, told


@pytest.mark.parametrize("file", [YADE, "-"])
@pytest.mark.parametrize("arguments", [
    ["--count"], ["--digest"], ["--digest", "--margin", "0.001"], ["--count", "--radius", "0.05"],
    ["-o", "-", "-q"], ["-o", "-", "-q", "--with", "normal,point,distance,vector"],
    ["-o", "-", "-q", "--format", "json"], ["--digest", "--order", "as_found"]])
def test_output_is_that_of_the_processor(abut, with_device, file, arguments):
    given = DISCS if file == "-" else ""
    expected = abut("contacts", file, *arguments, stdin=given)
    found = with_device("contacts", file, *arguments, "--device", "gpu", stdin=given)
    assert (expected.returncode, found.returncode) == (0, 0), found.stderr
    assert found.stdout == expected.stdout and len(found.stdout) > 1


@pytest.mark.parametrize("domain", [[], ["--periodic", "xy", "--box", "30,30"]])
@pytest.mark.parametrize("report", [["--count"], ["--digest"], ["-o", "-", "-q", "--with", "normal"]])
def test_boxes(abut, with_device, domain, report):
    rows = [f"{x},{y},{x + 1 + y % 3},{y + 1}" for x in range(0, 30, 2) for y in range(0, 30, 3)]
    given = "xmin,ymin,xmax,ymax\n" + "\n".join(rows) + "\n"
    arguments = ["contacts", "-", *domain, *report]
    expected = abut(*arguments, stdin=given)
    found = with_device(*arguments, "--device", "gpu", stdin=given)
    assert (expected.returncode, found.returncode) == (0, 0), expected.stderr + found.stderr
    assert found.stdout == expected.stdout and len(found.stdout) > 1


@pytest.mark.parametrize("file, domain", [
    (YADE, []), (LAMMPS, ["--periodic", "none"]), (LAMMPS, []),
    (LAMMPS, ["--lattice", "20,0,0,3,20,0,0,0,41"])])
@pytest.mark.parametrize("form", [[], ["--full"]])
def test_neighbors(abut, with_device, file, domain, form):
    cutoff = "0.1" if file == YADE else "1.1"
    arguments = ["neighbors", file, "--cutoff", cutoff, *domain, *form, "-o", "-", "-q"]
    expected = abut(*arguments)
    found = with_device(*arguments, "--device", "gpu")
    assert (expected.returncode, found.returncode) == (0, 0), found.stderr
    assert found.stdout == expected.stdout and found.stdout.count("\n") > 100


def test_neighbors_name_the_device(abut, with_device):
    arguments = ["neighbors", YADE, "--cutoff", "0.1"]
    expected = abut(*arguments).stdout
    found = with_device(*arguments, "--device", "gpu").stdout
    assert found == expected.replace("rows\n", f"rows, {STAND_IN}\n")


@pytest.mark.parametrize("arguments", [
    ["--count"], ["--digest"], ["--json"], ["--digest", "--periodic", "xz", "--box", "1,1,1"],
    ["--count", "--margin", "0.01"], ["-o", "-", "-q", "--with", "normal,point,distance,vector"],
    ["-o", "-", "-q", "--periodic", "xz", "--box", "1,1,1", "--with", "vector"]])
def test_two_sets(abut, with_device, tmp_path, arguments):
    """The even elements of a packing against the odd ones."""
    header, *rows = open(YADE).read().splitlines()
    files = [tmp_path / "even.csv", tmp_path / "odd.csv"]
    for file, start in zip(files, (0, 1)):
        file.write_text("\n".join([header, *rows[start::2]]) + "\n")
    command = ["contacts", str(files[0]), "--against", str(files[1]), *arguments]
    expected = abut(*command)
    found = with_device(*command, "--device", "gpu")
    assert (expected.returncode, found.returncode) == (0, 0), expected.stderr + found.stderr
    if "--json" in arguments:
        of_processor, of_device = json.loads(expected.stdout), json.loads(found.stdout)
        assert of_device["device"] == STAND_IN and of_device["sets"] == [2500, 2500]
        assert of_device["contact_pairs"] == of_processor["contact_pairs"] > 1000
    else:
        assert found.stdout == expected.stdout and len(found.stdout) > 1


@pytest.mark.parametrize("output", [[], ["-o", "-", "-q"]])
def test_neighbors_of_two_sets(abut, with_device, output):
    command = ["neighbors", YADE, "--against", YADE, "--cutoff", "0.1", *output]
    expected = abut(*command).stdout
    found = with_device(*command, "--device", "gpu").stdout
    assert found == expected.replace("rows\n", f"rows, {STAND_IN}\n") and len(found) > 100


def test_json_and_summary_name_the_device(abut, with_device):
    found = json.loads(with_device("contacts", YADE, "--device", "gpu", "--json").stdout)
    assert found["device"] == STAND_IN and found["contact_pairs"] == 10658
    assert found["algorithm"] == "rows" and found["peak_bytes"] > 5000 * 30
    summary = without_measurements(with_device("contacts", YADE, "--device", "gpu").stdout)
    expected = without_measurements(abut("contacts", YADE).stdout).splitlines()
    lines = summary.splitlines()
    assert lines[:-4] == expected[:-4] and len(lines) == len(expected)
    assert f"rows, {STAND_IN}: " in lines[-4]
    assert lines[-1].endswith("--device gpu:0 -o contacts.vtp")
    assert STAND_IN in with_device("--version", "--verbose").stdout


@pytest.mark.parametrize("arguments, code, told", [
    (["contacts", YADE, "--max-pairs", "10657"], 4, "10657"),
    (["contacts", YADE, "--max-memory", "1K"], 4, "bytes are needed"),
    (["contacts", "nosuch.csv"], 3, "nosuch.csv"),
    (["contacts", "-"], 3, "ymin")])
def test_what_a_device_refuses(with_device, arguments, code, told):
    done = with_device(*arguments, "--device", "gpu", stdin="xmin,ymin,xmax,ymax\n0,2,1,1\n")
    assert (done.returncode, done.stdout) == (code, "") and told in done.stderr


def test_a_device_that_is_not_there(with_device):
    done = with_device("contacts", YADE, "--device", "gpu:1")
    assert (done.returncode, done.stdout) == (6, "")
    assert done.stderr == "abut: there is no device 1, this machine has 1; leave out --device\n"


@pytest.mark.parametrize("domain", [
    [], ["--periodic", "none"], ["--periodic", "x"], ["--lattice", "20,0,0,3,20,0,0,0,41"]])
@pytest.mark.parametrize("report", [["--digest"], ["--count"], ["-o", "-", "-q", "--with", "vector"]])
def test_periodic_domains(abut, with_device, domain, report):
    arguments = ["contacts", LAMMPS, *domain, *report]
    expected = abut(*arguments)
    assert expected.returncode == 0, expected.stderr
    assert with_device(*arguments, "--device", "gpu:0").stdout == expected.stdout


GRAINS = "x,y,radius,mol\n0,0,1,5\n2,0,1,5\n4,0,1,6\n6,0,1,7\n8,0,1,7\n"


@pytest.mark.parametrize("rule, pairs", [
    (["--groups", "mol"], 2), (["--groups", "mol", "--deny", "5,6", "--deny", "7,7"], 2),
    (["--groups", "mol", "--deny", "5,5", "--exclude", "pairs.csv"], 2),
    (["--exclude", "pairs.csv"], 3)])
def test_rules(abut, with_device, tmp_path, rule, pairs):
    grains, bonds = tmp_path / "grains.csv", tmp_path / "pairs.csv"
    grains.write_text(GRAINS)
    bonds.write_text("i,j\n3,2\n")
    rule = [str(bonds) if word == "pairs.csv" else word for word in rule]
    for report in (["--count"], ["--digest"], ["-o", "-", "-q"]):
        for domain in ([], ["--box", "10,10", "--periodic", "xy"]):
            arguments = ["contacts", str(grains), *rule, *domain, *report]
            expected = abut(*arguments)
            found = with_device(*arguments, "--device", "gpu")
            assert (expected.returncode, found.returncode) == (0, 0), expected.stderr + found.stderr
            assert found.stdout == expected.stdout
    counted = with_device("contacts", str(grains), *rule, "--count", "--device", "gpu")
    assert int(counted.stdout) == pairs
    bench = json.loads(with_device("bench", str(grains), *rule, "--device", "gpu", "--threads", "1",
                                   "--repetitions", "1", "--json").stdout)
    assert bench["equal"] is True and all(run["contact_pairs"] == pairs for run in bench["runs"])


def test_nothing_at_all(with_device):
    for arguments in (["--count"], ["-o", "-", "-q"], []):
        done = with_device("contacts", "-", *arguments, "--device", "gpu", stdin="x,y,z,radius\n")
        assert done.returncode == 0, done.stderr


def test_bench(with_device):
    done = with_device("bench", YADE, "--device", "gpu", "--repetitions", "2", "--threads", "1",
                       "--json")
    found = json.loads(done.stdout)
    assert done.returncode == 0 and found["equal"] is True
    on_device = [run for run in found["runs"] if run["device"] == STAND_IN]
    assert [run["result"] for run in on_device] == ["canonical", "count"]
    assert {run["algorithm"] for run in found["runs"]} == {"rows"}
    assert {run["device"] for run in found["runs"]} == {"cpu", STAND_IN}
    digests = {run["digest"] for run in found["runs"] if run["digest"] is not None}
    assert len(digests) == 1 and on_device[0]["digest"] in digests
    assert all(run["contact_pairs"] == 10658 for run in found["runs"])
    table = with_device("bench", YADE, "--device", "gpu", "--repetitions", "1", "--threads", "1")
    rows = [line.split()[:3] for line in table.stdout.splitlines()]
    assert ["rows", "gpu:0", "canonical"] in rows and ["rows", "gpu:0", "count"] in rows

"""One row and more for each exit code of the design but for wrong usage and interrupts."""

import json
import os

import pytest
from conftest import DATA, DISCS, environment

YADE = str(DATA / "yade_settled_5000.csv")


@pytest.mark.parametrize("arguments", [
    ["contacts", YADE], ["contacts", YADE, "--count"], ["info", YADE], ["algorithms"],
    ["compare", YADE], ["--version"], ["--help"], ["generate", "--list"],
    ["generate", "gas", "--count", "0"]])
def test_0_done(abut, arguments):
    assert abut(*arguments).returncode == 0


@pytest.mark.parametrize("text", ["", "\n", "x,y,radius\n", "x,y,z,radius\n"])
def test_0_empty_input(abut, text):
    done = abut("contacts", "-", stdin=text)
    assert done.returncode == 0 and "contact pairs  0" in done.stdout
    assert abut("contacts", "-", "--count", stdin=text).stdout == "0\n"
    assert abut("compare", "-", stdin=text).returncode == 0
    assert abut("bench", "-", "--repetitions", "1", stdin=text).returncode == 0
    assert abut("explain", "munjiza_nbs", "-", stdin=text).returncode == 0


def test_0_an_input_without_a_line_is_warned_of(abut, tmp_path):
    """The program before it may have failed; a header says that there are no elements."""
    (tmp_path / "empty.csv").write_text("")
    for name, shown, text in (("-", "standard input", ""), ("-", "standard input", "\n \n"),
                              ("empty.csv", "empty.csv", ""), ("/dev/null", "/dev/null", "")):
        for more in ([], ["-q"]):
            done = abut("contacts", name, "--count", *more, stdin=text, cwd=tmp_path)
            assert (done.returncode, done.stdout) == (0, "0\n")
            assert done.stderr == (
                f"abut: {shown}: holds nothing, which is taken as no elements; if a program was to "
                "write it, see whether that failed\n")
    for command in (["info", "-"], ["neighbors", "-", "--cutoff", "1"], ["compare", "-"]):
        done = abut(*command)
        assert done.returncode == 0 and "holds nothing" in done.stderr
    for text in ("x,y,radius\n", "0\n\n", "LAMMPS\n0 atoms\n"):
        done = abut("contacts", "-", "--count", "--periodic", "none", stdin=text)
        assert (done.returncode, done.stdout, done.stderr) == (0, "0\n", "")


def test_0_the_next_command_reads_the_file_as_this_one_did(abut, tmp_path):
    (tmp_path / "discs.txt").write_text("0\n\n")
    told = abut("info", "discs.txt", "--format", "xyz", cwd=tmp_path).stdout
    assert told.splitlines()[-1].endswith("abut contacts discs.txt --format xyz")


@pytest.mark.parametrize("count", ["20", "2e1", "2E+1", "0.2e2", "200e-1", "20.", "020"])
def test_0_counts_are_whole_numbers_in_any_form(abut, count):
    assert len(abut("generate", "gas", "--count", count).stdout.splitlines()) == 21


def test_0_a_file_holds_what_its_name_says(abut, tmp_path):
    """csv is then the format of what is read."""
    (tmp_path / "discs.xyz").write_text(DISCS)
    for output, begin in (("o.vtp", "<?xml"), ("o.json", "{"), ("o.csv", "i,j,gap"),
                          ("o", "i,j,gap")):
        source = "discs.xyz" if output in ("o.vtp", "o.json") else "-"
        done = abut("contacts", source, "--format", "csv", "-o", output, "-q", cwd=tmp_path,
                    stdin=DISCS)
        assert (done.returncode, done.stderr) == (0, "")
        assert (tmp_path / output).read_text(errors="replace").startswith(begin)


def test_0_no_threads_are_as_many_as_pay(abut):
    assert abut("contacts", YADE, "--threads", "0", "--count").stdout == "10658\n"


def test_0_info_describes_what_a_detection_refuses(abut, fails):
    for text, told in (("1 2 3\n4 5 x\n", ["rows      2", "column 3  3 to 3 in 1 of 2 rows",
                                            "--columns x,y,radius"]),
                       ("a,y\n1,2\n", ["column a  1 to 1", "column x is missing"]),
                       ("x,y,radius\n1,2,3\n4,nan,-1\n7,8,2\n",
                        ["column x       1 to 7\n", "column y       2 to 8 in 2 of 3 rows",
                         "column radius  -1 to 3\n", "line 3, column 'y': 'nan'"]),
                       ("x,y,radius\n1,2,-3\n", ["column radius  -3 to -3", "negative"]),
                       ("x,y\n1,2\n", ["elements  1 disc", "radii     none", "--radius R"]),
                       ("2\n\nX 1 2 3\nX 1 2 3\n", ["2 spheres", "radii     none"])):
        fails(3, "contacts", "-", stdin=text)
        done = abut("info", "-", stdin=text)
        assert (done.returncode, done.stderr) == (0, "")
        assert all(word in done.stdout for word in told), done.stdout
        json.loads(abut("info", "-", "--json", stdin=text).stdout)


def test_0_next_command_names_the_columns(abut):
    done = abut("contacts", "-", "--columns", "x,y,radius", stdin="0 0 1\n1 1 1\n")
    assert "next             abut contacts - --columns x,y,radius -o contacts.vtp" in done.stdout


def test_3_boxes_have_no_neighbors(fails):
    told = fails(3, "neighbors", "-", "--cutoff", "1", stdin="xmin,xmax,ymin,ymax\n0,1,0,1\n")
    assert told.endswith("; leave it out, or ask for contacts within a margin")


def test_3_unreadable(fails, tmp_path):
    assert "nowhere.csv" in fails(3, "contacts", tmp_path / "nowhere.csv")
    fails(3, "contacts", tmp_path)


def test_4_limits(fails, abut, tmp_path):
    out = tmp_path / "out.csv"
    assert "10 contact pairs" in fails(4, "contacts", YADE, "--max-pairs", "10", "-o", out)
    fails(4, "contacts", YADE, "--max-pairs", "10", "--count")
    assert abut("contacts", YADE, "--max-pairs", "10658", "--count").stdout == "10658\n"
    assert "10240 bytes" in fails(4, "contacts", YADE, "--max-memory", "10K")
    sparse = abut("generate", "sparse", "--count", "1000").stdout
    sentence = fails(4, "contacts", "-", "--algorithm", "screening_array", stdin=sparse)
    assert "screening_array" in sentence and "bytes" in sentence and "rows" in sentence
    assert "1,000,000,000,000" in fails(4, "generate", "gas", "--count", "1000000000000")
    fails(4, "explain", "munjiza_nbs", YADE)
    done = abut("bench", YADE, "--max-memory", "10K")
    assert done.returncode == 4 and "no algorithm ran" in done.stderr
    assert "not run\n  rows: " in done.stdout and "first call" not in done.stdout
    assert not out.exists()


def test_5_cannot_write(fails, abut, tmp_path):
    fails(5, "contacts", YADE, "-o", "/dev/full")
    fails(5, "contacts", YADE, "-o", tmp_path / "nowhere" / "out.csv")
    fails(5, "generate", "gas", "--count", "9", "-o", tmp_path / "nowhere" / "out.csv")
    with open("/dev/full", "wb") as full:
        for command in (["contacts", YADE], ["contacts", YADE, "--count"],
                        ["contacts", YADE, "-o", "-"], ["algorithms"], ["--help"],
                        ["generate", "gas", "--count", "9"]):
            done = abut(*command, stdout=full)
            assert done.returncode == 5 and "standard output" in done.stderr


SIMD_LEVELS = ["scalar", "sse4", "avx2", "avx512", "neon"]


def test_6_simd_levels_that_cannot_run(abut, fails):
    """No processor has both the vectors of x86 and those of ARM, so some level always fails."""
    here = []
    for level in SIMD_LEVELS:
        done = abut("contacts", YADE, "--simd", level, "--digest")
        if done.returncode == 0:
            here.append((level, done.stdout))
            continue
        sentence = fails(6, "contacts", YADE, "--simd", level)
        assert level in sentence and "scalar" in sentence
        forced = abut("contacts", YADE, env=environment(ABUT_SIMD=level))
        assert forced.returncode == 6 and "ABUT_SIMD" in forced.stderr
    assert here[0][0] == "scalar" and 0 < len(here) < len(SIMD_LEVELS)
    assert len({digest for _, digest in here}) == 1, "the same pairs from every level"
    assert abut("contacts", YADE, env=environment(ABUT_SIMD="scalar")).returncode == 0


def test_7_different_pairs(abut):
    broken = environment(LD_PRELOAD=os.environ["WRONG_DIGEST"],
                         ASAN_OPTIONS="verify_asan_link_order=0")
    done = abut("compare", YADE, "--algorithms", "sorting_array,munjiza_nbs", env=broken)
    assert done.returncode == 7
    assert done.stderr.startswith("abut: sorting_array and munjiza_nbs found different pairs")
    assert "all the same" not in done.stdout
    json_form = abut("compare", YADE, "--json", env=broken)
    assert json_form.returncode == 7 and '"equal": false' in json_form.stdout


def test_7_different_pairs_in_bench(abut):
    broken = environment(LD_PRELOAD=os.environ["WRONG_DIGEST"],
                         ASAN_OPTIONS="verify_asan_link_order=0")
    arguments = ["bench", YADE, "--algorithms", "munjiza_nbs", "--repetitions", "1"]
    done = abut(*arguments, env=broken)
    assert done.returncode == 7 and "all the same" not in done.stdout
    assert done.stderr.startswith("abut: munjiza_nbs on 1 thread (canonical) and munjiza_nbs on 1 "
                                  "thread (as_found) found different pairs, 10,658 and 10,658")
    json_form = abut(*arguments, "--json", env=broken)
    assert json_form.returncode == 7 and '"equal": false' in json_form.stdout

"""One row and more for each exit code of the design."""

import array
import fcntl
import json
import os
import signal
import subprocess
import termios
import time

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


@pytest.mark.parametrize("kind", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_130_interrupted(long_search, tmp_path, kind):
    """In the midst of a search that would take minutes; the bar shows that it has begun."""
    with subprocess.Popen(
            [os.environ["ABUT"], *long_search, "-o", "out.csv", "--progress", "bar"],
            cwd=tmp_path, stderr=subprocess.PIPE, stdout=subprocess.PIPE,
            env=environment()) as process:
        seen = b""
        while b"search" not in seen:
            seen += os.read(process.stderr.fileno(), 1000)
        process.send_signal(kind)
        out, rest = process.communicate(timeout=60)
    assert process.returncode == 130 and out == b""
    assert rest.endswith(b"\rabut: interrupted\n"), "the bar is gone before the sentence"
    assert list(tmp_path.iterdir()) == []


def after_the_bar_shows(word, arguments, folder):
    """Exit code, standard output and the end of standard error, interrupted when the bar says so."""
    with subprocess.Popen([os.environ["ABUT"], *arguments, "--progress", "bar"], cwd=folder,
                          stderr=subprocess.PIPE, stdout=subprocess.PIPE,
                          env=environment()) as process:
        seen = b""
        while word not in seen:
            block = os.read(process.stderr.fileno(), 1000)
            assert block, "ended before it showed " + word.decode()
            seen += block
        process.send_signal(signal.SIGINT)
        out, rest = process.communicate(timeout=60)
    return process.returncode, out, rest[-18:]


@pytest.fixture(scope="module")
def coincident(tmp_path_factory):
    """All centres in one point: pairs without end."""
    path = tmp_path_factory.mktemp("coincident") / "points.csv"
    subprocess.run([os.environ["ABUT"], "generate", "coincident", "--count", "300000", "-o", path],
                   check=True, stderr=subprocess.DEVNULL)
    return path


@pytest.mark.parametrize("threads", ["1", "2"])
@pytest.mark.parametrize("options", [[], ["--algorithm", "munjiza_nbs"], ["--box", "100,100,100"]],
                         ids=["rows", "munjiza_nbs", "periodic"])
def test_130_where_all_work_lies_in_one_place(coincident, tmp_path, options, threads):
    arguments = ["contacts", coincident, "--count", *options, "--threads", threads]
    assert after_the_bar_shows(b"search", arguments, tmp_path) == (130, b"", b"abut: interrupted\n")


def test_130_while_a_scene_is_made(tmp_path):
    arguments = ["generate", "dense", "--count", "5000000", "-o", "out.csv"]
    with subprocess.Popen([os.environ["ABUT"], *arguments], cwd=tmp_path, stderr=subprocess.PIPE,
                          env=environment()) as process:
        while not handles(process.pid, signal.SIGINT):
            time.sleep(0.001)
        process.send_signal(signal.SIGINT)
        assert process.communicate(timeout=60) == (None, b"abut: interrupted\n")
    assert process.returncode == 130
    assert list(tmp_path.iterdir()) == []


def test_130_interrupts_a_measurement(long_search):
    """It is no algorithm that took too long."""
    arguments = ["bench", long_search[1], "--algorithms", "direct_check", "--progress", "bar"]
    with subprocess.Popen([os.environ["ABUT"], *arguments], stderr=subprocess.PIPE,
                          stdout=subprocess.PIPE, env=environment()) as process:
        seen = b""
        while b"search" not in seen:
            seen += os.read(process.stderr.fileno(), 1000)
        code, errors = after_one_interrupt(process)
        assert (code, process.stdout.read()) == (130, b"")
        assert errors.endswith(b"abut: interrupted\n")


def test_130_while_reading_standard_input():
    with subprocess.Popen([os.environ["ABUT"], "contacts", "-"], stdin=subprocess.PIPE,
                          stderr=subprocess.PIPE, stdout=subprocess.PIPE,
                          env=environment()) as process:
        process.stdin.write(DISCS.encode())
        process.stdin.flush()
        while "pipe" not in waits_in(process.pid):
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=60)
    assert (process.returncode, errors) == (130, b"abut: interrupted\n")


def wait_until_stalled(process):
    """Until the pipe on standard output is full and the process sleeps, writing more."""
    full = fcntl.fcntl(process.stdout, fcntl.F_GETPIPE_SZ)
    waiting = array.array("i", [0])
    while waiting[0] < full or not waits_in(process.pid):
        assert process.poll() is None
        fcntl.ioctl(process.stdout, termios.FIONREAD, waiting)
        time.sleep(0.01)


def after_one_interrupt(process):
    """Exit code and standard error."""
    process.send_signal(signal.SIGINT)
    try:
        return process.wait(timeout=60), process.stderr.read()
    finally:
        process.kill()


@pytest.mark.parametrize("arguments", [
    ["contacts", YADE, "-o", "-"], ["generate", "gas", "--count", "9000"],
    ["compare", YADE, "--json"]])
def test_130_while_a_pipe_stalls(arguments):
    """One Ctrl-C is enough where nobody reads on."""
    if arguments[0] == "compare":
        arguments = [*arguments, "--algorithms", ",".join(["rows"] * 500)]
    with subprocess.Popen([os.environ["ABUT"], *arguments], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, env=environment()) as process:
        wait_until_stalled(process)
        assert after_one_interrupt(process) == (130, b"abut: interrupted\n")


@pytest.mark.parametrize("arguments", [["contacts", "fifo"], ["contacts", YADE, "-o", "fifo"]])
def test_130_while_nobody_opens_the_other_end(tmp_path, arguments):
    os.mkfifo(tmp_path / "fifo")
    with subprocess.Popen([os.environ["ABUT"], *arguments], cwd=tmp_path, stderr=subprocess.PIPE,
                          env=environment()) as process:
        asleep = 0
        while asleep < 10:
            time.sleep(0.01)
            asleep = asleep + 1 if waits_in(process.pid) else 0
        assert after_one_interrupt(process) == (130, b"abut: interrupted\n")


def waits_in(pid):
    """What a process that sleeps waits for: descriptor 0 in system call read, as "pipe"."""
    with open(f"/proc/{pid}/stat") as file:
        state = file.read().rpartition(")")[2].split()[0]
    return "pipe" if state == "S" and handles(pid, signal.SIGINT) else ""


def handles(pid, kind):
    with open(f"/proc/{pid}/status") as file:
        caught = next(line for line in file if line.startswith("SigCgt"))
    return int(caught.split()[1], 16) >> (kind - 1) & 1


def test_2_rows_has_nothing_to_explain(abut):
    done = abut("explain", "rows", "-", stdin=DISCS)
    assert (done.returncode, done.stdout) == (2, "") and "no arrays to show" in done.stderr

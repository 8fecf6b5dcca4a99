"""Exit code 130: signals at any time, whatever the command waits for."""

import array
import fcntl
import os
import signal
import subprocess
import termios
import time

import pytest
from conftest import DATA, DISCS, environment

YADE = str(DATA / "yade_settled_5000.csv")


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
    ["compare", "discs.csv", "--json", "--algorithms", ",".join(["rows"] * 500)]])
def test_130_while_a_pipe_stalls(arguments, tmp_path):
    """One Ctrl-C is enough where nobody reads on.

    The pipe is full within the ten seconds after which progress is told, under sanitizers, too:
    what is searched 500 times is small.
    """
    (tmp_path / "discs.csv").write_text(DISCS)
    with subprocess.Popen([os.environ["ABUT"], *arguments], stdout=subprocess.PIPE, cwd=tmp_path,
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

"""Each system call of the output fails once, and signals come before each: the exit code is right, the
output is the old or the new one as a whole, and no temporary file and no open descriptor is left."""

import os
import random
import signal
import subprocess
import time

import pytest
from conftest import DATA, environment

YADE = str(DATA / "yade_settled_5000.csv")
OLD = "the old output\n"
MOST_CALLS = 60

COMMANDS = {
    "contacts": ["contacts", YADE, "--margin", "0.08", "-q", "-o", "out.csv"],
    "vtp": ["contacts", YADE, "-q", "-o", "out.vtp"],
    "neighbors": ["neighbors", YADE, "--cutoff", "0.1", "-q", "-o", "out.csv"],
    "generate": ["generate", "gas", "--count", "30000", "-q", "-o", "out.csv"],
}


def preloaded(folder, fault):
    return environment(LD_PRELOAD=os.environ["FAILING_CALLS"], ABUT_FAULT=fault,
                       ABUT_LEAKS=str(folder.parent / f"{folder.name}-leaks"),
                       ASAN_OPTIONS="verify_asan_link_order=0", OMP_NUM_THREADS="1")


def run(folder, arguments, fault=""):
    return subprocess.run([os.environ["ABUT"], *arguments], cwd=folder, capture_output=True,
                          env=preloaded(folder, fault), check=False, timeout=300)


def leaks(folder):
    return (folder.parent / f"{folder.name}-leaks").read_text()


@pytest.fixture(scope="session")
def results(tmp_path_factory):
    """What each command writes where nothing fails."""
    texts = {}
    for name, arguments in COMMANDS.items():
        folder = tmp_path_factory.mktemp(name)
        done = run(folder, arguments)
        assert (done.returncode, done.stdout, done.stderr) == (0, b"", b"")
        texts[name] = (folder / arguments[-1]).read_bytes()
    return texts


def outcome(folder, name, results, fault, old):
    """(exit code, whether the new output is there, standard error), after what must always hold."""
    out = folder / COMMANDS[name][-1]
    out.unlink(missing_ok=True)
    if old:
        out.write_text(OLD)
    done = run(folder, COMMANDS[name], fault)
    assert done.stdout == b""
    names = [path.name for path in folder.iterdir()]
    assert names in ([out.name], []), f"{fault}: {names}"
    is_new = out.exists() and out.read_bytes() == results[name]
    if not is_new:
        assert out.exists() == old and (not old or out.read_text() == OLD), fault
    if done.returncode >= 0:
        assert leaks(folder) == "", fault
        assert done.stderr.count(b"\n") <= 1, done.stderr
    return done.returncode, is_new, done.stderr.decode()


def every_call(folder, name, results, call, way, old=True):
    """The outcomes with the first, second, ... call failing, until so many are not made."""
    found = []
    for number in range(1, MOST_CALLS):
        result = outcome(folder, name, results, f"{call} {number} {way}", old)
        if result == (0, True, ""):
            break
        found.append(result)
    assert number < MOST_CALLS - 1, "calls without end"
    return found


@pytest.mark.parametrize("name", COMMANDS)
@pytest.mark.parametrize("old", [True, False])
def test_writing_fails(tmp_path, results, name, old):
    found = every_call(tmp_path, name, results, "write", "ENOSPC", old)
    assert len(found) >= 1
    for code, is_new, sentence in found:
        assert (code, is_new) == (5, False)
        assert sentence.startswith(f"abut: {COMMANDS[name][-1]}: cannot write to it ("), sentence


def test_many_writes_of_one_output(tmp_path, results):
    """A buffer is handed on while others are still to come."""
    assert len(every_call(tmp_path, "contacts", results, "write", "EDQUOT")) >= 3


@pytest.mark.parametrize("name", COMMANDS)
def test_syncing_fails(tmp_path, results, name):
    """First the file, then the folder: the file is there then, and that is no failure."""
    of_file, of_folder = every_call(tmp_path, name, results, "fsync", "EIO")
    assert of_file[:2] == (5, False) and "cannot write to it" in of_file[2]
    assert of_folder[:2] == (0, True)
    assert of_folder[2] == (f"abut: {COMMANDS[name][-1]}: is written, but its folder could not be "
                            "synced; should the machine stop now, write it again\n")
    assert every_call(tmp_path, name, results, "fsync", "EROFS") == [], "cannot be synced at all"


@pytest.mark.parametrize("name", COMMANDS)
def test_renaming_closing_and_opening_fail(tmp_path, results, name):
    (only,) = every_call(tmp_path, name, results, "rename", "EACCES")
    assert only[:2] == (5, False) and "cannot rename to it" in only[2]
    (only,) = every_call(tmp_path, name, results, "fchmod", "EIO")
    assert only[:2] == (5, False) and "cannot set the permissions of it" in only[2]
    codes = {"close": [], "open": []}
    for call, way in (("close", "ENOSPC"), ("open", "EMFILE")):
        for number in range(1, 6):
            code, is_new, sentence = outcome(tmp_path, name, results, f"{call} {number} {way}",
                                             True)
            assert (code == 0) == is_new and bool(sentence) == (code != 0)
            codes[call].append(code)
    reads = [] if name == "generate" else [3]
    assert [code for code in codes["open"] if code != 0] == [*reads, 5], "the folder may be closed"
    assert [code for code in codes["close"] if code != 0] == [5], "of the file that is written alone"


@pytest.mark.parametrize("name", COMMANDS)
def test_reading_fails(tmp_path, results, name):
    for code, is_new, sentence in every_call(tmp_path, name, results, "read", "EIO"):
        assert (code, is_new) == (3, False) and "cannot be read" in sentence


@pytest.mark.parametrize("name", ["contacts", "generate"])
@pytest.mark.parametrize("call, way", [("write", "EINTR"), ("write", "SHORT"), ("read", "EINTR"),
                                       ("fsync", "EINTR"), ("close", "EINTR"), ("open", "EINTR"),
                                       ("write", "SIGXFSZ"), ("write", "SIGPIPE")])
def test_what_only_delays(tmp_path, results, name, call, way):
    for number in range(1, 5):
        code, is_new, sentence = outcome(tmp_path, name, results, f"{call} {number} {way}", True)
        assert (code, is_new, sentence) == (0, True, "")


@pytest.mark.parametrize("name, kind", [("contacts", "SIGTERM"), ("contacts", "SIGHUP"),
                                        ("neighbors", "SIGHUP"), ("generate", "SIGINT")])
@pytest.mark.parametrize("call", ["open", "write", "fsync", "close", "rename"])
def test_a_signal_before_each_call(tmp_path, results, name, kind, call):
    found = every_call(tmp_path, name, results, call, kind)
    if call in ("write", "fsync"):
        assert found, "the signal comes in time"
    for code, is_new, sentence in found:
        assert (code, sentence) == (130, "abut: interrupted\n") and not is_new


@pytest.mark.parametrize("call", ["write", "fsync", "close", "rename"])
def test_the_same_signal_twice_ends_at_once(tmp_path, results, call):
    """Without a temporary."""
    for number in range(1, 4):
        code, is_new, _ = outcome(tmp_path, "contacts", results, f"{call} {number} TWICE", True)
        assert code in (-signal.SIGTERM, 0) and (code != 0 or is_new)


def test_the_limit_of_a_file(tmp_path):
    """SIGXFSZ would end the tool with the temporary left behind."""
    (tmp_path / "out.csv").write_text(OLD)
    arguments = " ".join(COMMANDS["contacts"])
    done = subprocess.run(["bash", "-c", f"ulimit -f 100; '{os.environ['ABUT']}' {arguments}"],
                          cwd=tmp_path, capture_output=True, env=environment(), check=False)
    assert done.returncode == 5 and b"out.csv: cannot write to it (File too large)" in done.stderr
    assert [path.name for path in tmp_path.iterdir()] == ["out.csv"]
    assert (tmp_path / "out.csv").read_text() == OLD


def catches(pid, kind):
    """Whether the process handles a signal by now."""
    try:
        with open(f"/proc/{pid}/status") as file:
            caught = next(line for line in file if line.startswith("SigCgt"))
    except (FileNotFoundError, StopIteration, ProcessLookupError):
        return False
    return bool(int(caught.split()[1], 16) >> (kind - 1) & 1)


def test_signals_at_random_times(tmp_path, results):
    """From the moment on that they are caught; the seed is fixed, the times are not."""
    draws = random.Random(20040101)
    out = tmp_path / "out.csv"
    for _ in range(40):
        out.write_text(OLD)
        name = draws.choice(["contacts", "neighbors", "generate"])
        kinds = draws.choices([signal.SIGTERM, signal.SIGINT, signal.SIGHUP], k=draws.randint(1, 2))
        pauses = [draws.uniform(0, 0.04) for _ in kinds]
        with subprocess.Popen([os.environ["ABUT"], *COMMANDS[name]], cwd=tmp_path,
                              stderr=subprocess.PIPE, env=environment()) as process:
            while process.poll() is None and not catches(process.pid, signal.SIGHUP):
                time.sleep(0.0005)
            for kind, pause in zip(kinds, pauses):
                time.sleep(pause)
                process.send_signal(kind)
            _, errors = process.communicate(timeout=60)
        what = (name, kinds, pauses, errors)
        assert [path.name for path in tmp_path.iterdir()] == ["out.csv"], what
        is_new = out.read_bytes() == results[name]
        assert is_new or out.read_text() == OLD, what
        if process.returncode == 0:
            assert is_new and errors == b"", what
        elif process.returncode == 130:
            assert errors == b"abut: interrupted\n", what
        else:
            assert kinds[0] == kinds[1] == -process.returncode, what

"""Each error of the library is an exception of Python's own kind, too; Ctrl-C arrives."""

import os
import pickle
import re
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from conftest import SOURCES

import abut
from abut import _errors

BUILT_IN = {
    "unexpected": RuntimeError,
    "wrong_usage": ValueError,
    "invalid_input": ValueError,
    "limit_exceeded": MemoryError,
    "output_failed": OSError,
    "unavailable": RuntimeError,
    "check_failed": AssertionError,
    "cancelled": KeyboardInterrupt,
}


def test_every_code_has_its_exception():
    header = (SOURCES / "include/abut/error.hpp").read_text()
    codes = dict(re.findall(r"^  (\w+) = (\d+),", header, re.MULTILINE))
    assert codes.keys() == BUILT_IN.keys()
    for name, code in codes.items():
        error = _errors.made(int(code), "a sentence")
        assert isinstance(error, abut.Error)
        assert isinstance(error, BUILT_IN[name])
        assert error.code == int(code)
        assert str(error) == "a sentence"
        assert type(pickle.loads(pickle.dumps(error))) is type(error)
    assert len({type(_errors.made(int(code), "")) for code in codes.values()}) == len(codes)


def test_wrong_usage():
    x = [[0, 0], [1, 0]]
    for options in (
        {"algorithm": "quick"},
        {"order": "random"},
        {"simd": "mmx"},
        {"margin": -1},
        {"margin": np.nan},
    ):
        with pytest.raises(abut.Error) as caught:
            abut.contacts(x, 0.5, **options)
        assert isinstance(caught.value, ValueError), options
    for options in (
        {"algorithm": 3},
        {"margin": "wide"},
        {"margin": [1, 2]},
        {"max_pairs": 1.5},
        {"progress": 3},
        {"threads": "two"},
        {"rule": 3},
    ):
        with pytest.raises(TypeError):
            abut.contacts(x, 0.5, **options)
    with pytest.raises(ValueError, match="max_pairs"):
        abut.contacts(x, 0.5, max_pairs=-1)


def test_limits_are_memory_errors_and_the_interpreter_lives(cloud):
    with pytest.raises(MemoryError) as caught:
        abut.contacts(*cloud, max_pairs=3)
    assert isinstance(caught.value, abut.LimitError)
    with pytest.raises(MemoryError):
        abut.contacts(*cloud, max_bytes=1000)
    assert len(abut.contacts(*cloud, max_pairs=10**6)) > 3


LITTLE_MEMORY = """
import resource
import numpy as np
import abut

x = np.random.default_rng(1).random((1_000_000, 3))
mesh = abut.TriangleMesh(x, np.arange(999_999).reshape(-1, 3))
detector = abut.Detector()
small = abut.contacts(x[:1000], 0.05).pairs.tobytes()
used = 1024 * int(open("/proc/self/status").read().split("VmSize:")[1].split()[0])
before = resource.getrlimit(resource.RLIMIT_AS)
resource.setrlimit(resource.RLIMIT_AS, (used + 2**21, before[1]))
for call in (
    lambda: abut.contacts(x, 0.01, threads=1),
    lambda: detector.contacts(x, 0.01, threads=1),
    lambda: abut.neighbors(x, 0.01, kind="full", threads=1),
    lambda: abut.find_mesh_contacts(abut.spheres(x, 0.001), mesh, threads=1),
    lambda: abut.measure(abut.points(x), np.zeros((1_000_000, 2), np.uint32), "gap", threads=1),
    lambda: mesh.vertices,
    lambda: mesh.move(abut.Motion()),
):
    try:
        call()
    except MemoryError:
        assert abut.contacts(x[:1000], 0.05, threads=1).pairs.tobytes() == small
    else:
        raise AssertionError("the memory was enough")
resource.setrlimit(resource.RLIMIT_AS, before)
print(len(detector.contacts(x, 0.01)) > 0, mesh.vertices.shape)
"""


def test_refused_allocations_are_memory_errors_and_the_interpreter_lives():
    child = subprocess.run(
        [sys.executable, "-c", LITTLE_MEMORY], capture_output=True, text=True, timeout=250
    )
    assert (child.returncode, child.stderr) == (0, "")
    assert child.stdout == "True (1000000, 3)\n"


def test_progress_is_told_and_may_cancel(cloud):
    told = []
    abut.contacts(*cloud, progress=lambda *now: told.append(now))
    assert told
    assert all(isinstance(phase, str) and done <= total for phase, done, total in told)
    with pytest.raises(abut.Cancelled):
        abut.contacts(*cloud, progress=lambda *now: False)
    with pytest.raises(ZeroDivisionError):
        abut.contacts(*cloud, progress=lambda *now: 1 // 0)


def long_detection():
    """All pairs of many coincident elements, counted: seconds of work."""
    return abut.count_contact_pairs(abut.discs(np.zeros((300_000, 2)), 0.5))


def test_ctrl_c_stops_a_detection():
    # Shells start what runs in the background with this signal ignored.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        threading.Timer(0.1, os.kill, (os.getpid(), signal.SIGINT)).start()
        with pytest.raises(KeyboardInterrupt):
            long_detection()
    finally:
        signal.signal(signal.SIGINT, before)


def test_other_threads_run_during_a_detection():
    ticks = []
    stop = threading.Event()

    def tick():
        while not stop.is_set():
            ticks.append(None)
            time.sleep(0.001)

    def cancel(*_):
        return len(ticks) < 5

    thread = threading.Thread(target=tick)
    thread.start()
    try:
        with pytest.raises(abut.Cancelled):
            abut.count_contact_pairs(abut.discs(np.zeros((300_000, 2)), 0.5), progress=cancel)
    finally:
        stop.set()
        thread.join()
    assert len(ticks) >= 5


def test_several_threads_detect_at_once(cloud):
    x, r = cloud
    expected = abut.contacts(x, r).pairs.tobytes()

    def bytes_of(seed):
        detector = abut.Detector(threads=1 + seed % 2)
        return {detector.contacts(x, r).pairs.tobytes() for _ in range(20)}

    with ThreadPoolExecutor(4) as pool:
        assert list(pool.map(bytes_of, range(8))) == [{expected}] * 8


def test_a_measurement_may_be_cancelled(cloud):
    elements = abut.spheres(*cloud)
    with pytest.raises(abut.Cancelled):
        abut.measure(elements, [[0, 1]], "gap", progress=lambda *now: False)


SUB_INTERPRETER = """
import sys
try:
    import _interpreters as interpreters
except ImportError:
    import _xxsubinterpreters as interpreters
with_main = sys.argv[1] == "after"
if with_main:
    import abut
try:
    wrong = interpreters.run_string(
        interpreters.create(), f"import sys; sys.path[:] = {sys.path}; import abut"
    )
except interpreters.RunFailedError as error:
    wrong = error
print(wrong)
import abut
print(len(abut.contacts([[0, 0], [1, 0]], 0.5)))
"""


@pytest.mark.parametrize("when", ["before", "after"])
def test_sub_interpreters_are_refused_and_the_main_one_lives(when):
    child = subprocess.run(
        [sys.executable, "-c", SUB_INTERPRETER, when], capture_output=True, text=True, check=True
    )
    refused, contacts = child.stdout.rsplit(maxsplit=1)
    assert "abut does not support sub-interpreters" in refused
    assert contacts == "1"


def test_a_forked_child_detects(cloud):
    expected = len(abut.contacts(*cloud, threads=2))
    child = os.fork()
    if child == 0:
        os._exit(0 if len(abut.contacts(*cloud, threads=2)) == expected else 1)
    assert os.waitpid(child, 0)[1] == 0

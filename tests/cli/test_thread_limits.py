"""Threads where the system grants few, or small ones: the same bytes, whatever it takes."""

import json
import os
import resource
import subprocess

import pytest
from conftest import environment

COUNTS = [1, 8, 100000]


@pytest.fixture(scope="module")
def scene(tmp_path_factory):
    path = tmp_path_factory.mktemp("limits") / "dense.csv"
    subprocess.run([os.environ["ABUT"], "generate", "dense", "--count", "20000", "-q", "-o", path],
                   check=True, timeout=60)
    return path


def run(*arguments, limits=(), env=None):
    def limit():
        for what, most in limits:
            resource.setrlimit(what, (most, most))

    return subprocess.run([os.environ["ABUT"], *map(str, arguments)], capture_output=True, text=True,
                          preexec_fn=limit, env=env or environment(), check=False, timeout=120)


def is_instrumented():
    """Sanitizers map terabytes: no limit of addresses holds for them."""
    return b"__asan_init" in open(os.environ["ABUT"], "rb").read()


def digest(scene, threads, limits=(), env=None):
    done = run("contacts", scene, "--digest", "-q", "--threads", threads, limits=limits, env=env)
    assert (done.returncode, done.stderr) == (0, "")
    return done.stdout


@pytest.mark.parametrize("threads", [2, 3, *COUNTS, 2147483647])
def test_any_number_of_threads(scene, threads):
    assert digest(scene, threads) == digest(scene, 1)
    told = json.loads(run("contacts", scene, "--json", "-q", "--threads", threads).stdout)
    assert 1 <= told["threads"] <= min(threads, 1024)


@pytest.mark.parametrize("threads", COUNTS)
@pytest.mark.parametrize("megabytes", [60, 400])
def test_few_addresses(scene, threads, megabytes):
    """As `ulimit -v`: what is refused to a thread must not be missing to the arrays."""
    limits = [] if is_instrumented() else [(resource.RLIMIT_AS, megabytes * 1024 * 1000)]
    assert digest(scene, threads, limits) == digest(scene, 1)


@pytest.mark.parametrize("threads", COUNTS)
@pytest.mark.parametrize("kilobytes", [64, 256])
def test_small_stacks(scene, threads, kilobytes):
    """As `ulimit -s`."""
    limits = [] if is_instrumented() else [(resource.RLIMIT_STACK, kilobytes * 1024)]
    assert digest(scene, threads, limits) == digest(scene, 1)


@pytest.mark.parametrize("settings", [
    {"OMP_NUM_THREADS": "8"}, {"OMP_NUM_THREADS": "100000"}, {"OMP_THREAD_LIMIT": "1"},
    {"OMP_PROC_BIND": "true"}, {"OMP_PROC_BIND": "spread", "OMP_PLACES": "cores"},
    {"OMP_PROC_BIND": "close", "OMP_PLACES": "threads"}, {"OMP_PROC_BIND": "master"},
    {"OMP_PLACES": "{0}"}, {"OMP_WAIT_POLICY": "active"}, {"OMP_WAIT_POLICY": "PASSIVE"},
    {"OMP_STACKSIZE": "16k"}, {"OMP_DYNAMIC": "true"}])
def test_what_openmp_is_told(scene, settings):
    expected = digest(scene, 1)
    env = environment(**settings)
    assert run("contacts", scene, "--digest", "-q", env=env).stdout == expected
    assert digest(scene, 3, env=env) == expected

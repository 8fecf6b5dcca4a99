"""Threads where the system grants few, or small ones: the same bytes, whatever it takes."""

import json
import os
import pathlib
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


NOBODY = 65534


def of_few_processes(most):
    """For a child before it becomes the tool: as `ulimit -u`, which binds no superuser."""
    def limit():
        if os.geteuid() == 0:
            os.setgroups([])
            os.setgid(NOBODY)
            os.setuid(NOBODY)
        resource.setrlimit(resource.RLIMIT_NPROC, (most, most))
    return limit


def start_with_few_processes(most, *arguments, stdin=None):
    # The leak sanitizer wants a process of its own.
    options = os.environ.get("ASAN_OPTIONS", "") + ":detect_leaks=0"
    return subprocess.run([os.environ["ABUT"], *arguments], stdin=stdin, capture_output=True,
                          text=True, preexec_fn=of_few_processes(most), check=False, timeout=120,
                          env=environment(ASAN_OPTIONS=options))


def run_with_few_processes(scene, most, *arguments):
    """On the file as standard input: a user who is nobody may not find it by its name."""
    with open(scene, "rb") as file:
        return start_with_few_processes(most, "contacts", "-", "-q", *arguments, stdin=file)


@pytest.fixture(scope="module")
def limit_of_processes():
    """The tool can be run where threads are limited, too."""
    try:
        start_with_few_processes(1, "--version")
    except (PermissionError, subprocess.SubprocessError) as error:
        pytest.skip(f"the superuser is bound by no limit of processes, and nobody else: {error}")


@pytest.mark.usefixtures("limit_of_processes")
@pytest.mark.parametrize("threads", ["8", "1000"])
@pytest.mark.parametrize("most", [1, 2, 4])
def test_few_processes(scene, most, threads):
    """Each thread counts as a process of the user's. Where the user has no others, `most` work."""
    done = run_with_few_processes(scene, most, "--digest", "--threads", threads)
    assert (done.returncode, done.stderr, done.stdout) == (0, "", digest(scene, 1))
    told = json.loads(run_with_few_processes(scene, most, "--json", "--threads", threads).stdout)
    assert 1 <= told["threads"] <= most
    assert most > 1 or told["threads"] == 1


def new_group_of_tasks():
    """A folder of the kernel's whose `pids.max` limits the tasks of a container."""
    for root in ("/sys/fs/cgroup/pids", "/sys/fs/cgroup"):  # version 1, version 2
        group = pathlib.Path(root) / f"abut-{os.getpid()}"
        try:
            group.mkdir()
        except OSError:
            continue
        if (group / "pids.max").exists():
            return group
        group.rmdir()
    return None


@pytest.fixture
def group_of_tasks():
    group = new_group_of_tasks()
    if group is None:
        pytest.skip("groups of tasks cannot be made here: that takes a superuser outside a container")
    yield group
    group.rmdir()


@pytest.mark.parametrize("threads", [None, "8", "1000"])
@pytest.mark.parametrize("most", [1, 2, 4])
def test_few_tasks_in_a_container(scene, group_of_tasks, most, threads):
    """As a container with a limit of processes; OMP_NUM_THREADS asks for more in the default call."""
    (group_of_tasks / "pids.max").write_text(str(most), encoding="ascii")
    options = os.environ.get("ASAN_OPTIONS", "") + ":detect_leaks=0"
    wanted = [] if threads is None else ["--threads", threads]

    def told(form):
        def enter():
            (group_of_tasks / "cgroup.procs").write_text(str(os.getpid()), encoding="ascii")

        done = subprocess.run([os.environ["ABUT"], "contacts", scene, "-q", form, *wanted],
                              capture_output=True, text=True, preexec_fn=enter, check=False,
                              timeout=120,
                              env=environment(ASAN_OPTIONS=options, OMP_NUM_THREADS="8"))
        assert (done.returncode, done.stderr) == (0, "")
        return done.stdout

    assert told("--digest") == digest(scene, 1)
    assert 1 <= json.loads(told("--json"))["threads"] <= most


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

"""A second library with its own OpenMP in the process does no harm, and takes none.

The wheels of scikit-learn bring a copy of OpenMP's runtime, as those of PyTorch do.
"""

import subprocess
import sys

import pytest

# Counts the runtimes, then lets both libraries work with two threads at the same time, again and
# again, and at last in a forked child.
PROGRAM = """\
import os
import threading
{imports}
import numpy as np
import threadpoolctl

runtimes = [one for one in threadpoolctl.threadpool_info() if one["user_api"] == "openmp"]
assert len({{one["filepath"] for one in runtimes}}) == 2, runtimes

random = np.random.default_rng(1)
x, centers = random.random((20_000, 3)), random.random((50, 3))

def pairs():
    return abut.contacts(x, 0.02, threads=2).pairs.tobytes()

def nearest():
    return pairwise_distances_argmin(x, centers).tobytes()

expected = {{pairs: pairs(), nearest: nearest()}}
found = {{pairs: [], nearest: []}}

def work(function):
    for _ in range(20):
        found[function].append(function())

threads = [threading.Thread(target=work, args=[one]) for one in (pairs, nearest, pairs, nearest)]
for thread in threads:
    thread.start()
for thread in threads:
    thread.join()
for function, answers in found.items():
    assert answers == [expected[function]] * 40, function.__name__

child = os.fork()
if child == 0:
    os._exit(0 if pairs() == expected[pairs] else 1)
assert os.waitpid(child, 0)[1] == 0
print("same", len(abut.contacts(x, 0.02)))
"""
ABUT, OTHER = "import abut", "from sklearn.metrics import pairwise_distances_argmin"


@pytest.mark.parametrize("imports", [(ABUT, OTHER), (OTHER, ABUT)], ids=["first", "second"])
def test_beside_another_openmp(imports):
    program = PROGRAM.format(imports="\n".join(imports))
    # Python 3.12 and later warn of each fork of a process with threads.
    command = [sys.executable, "-W", "ignore::DeprecationWarning", "-c", program]
    result = subprocess.run(command, capture_output=True, text=True, timeout=250)
    assert (result.returncode, result.stderr) == (0, "")
    assert result.stdout.startswith("same ")

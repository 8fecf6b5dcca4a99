"""Counts instructions with valgrind's callgrind: a figure without noise."""

import os
import re
import subprocess
import sys
import tempfile


def instructions(command, function, refused=None):
    """Instructions that a command executes within a function (a pattern of callgrind, such as
    abut::count_contact_pairs*) and in what it calls. None if its exit code is `refused`."""
    with tempfile.TemporaryDirectory() as folder:
        callgrind = ["valgrind", "--tool=callgrind",
                     "--callgrind-out-file=" + os.path.join(folder, "out"),
                     "--toggle-collect=" + function]
        # Without resolving of symbols in between, and in one thread unless the command says more.
        environment = {**os.environ, "LD_BIND_NOW": "1", "OMP_NUM_THREADS": "1"}
        done = subprocess.run([*callgrind, *command], capture_output=True, text=True,
                              env=environment)
    if refused is not None and done.returncode == refused:
        return None
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)} failed under valgrind:\n{done.stderr}")
    return int(re.search(r"Collected : (\d+)", done.stderr)[1])

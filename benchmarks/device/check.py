"""Checks the benchmarks of the device as far as that can be done without one.

Usage: check.py PROGRAM
The program says that there is no device, the contestants' pairs have the digest of abut, and a wrong
answer is not timed.
"""

import os
import subprocess
import sys

import numpy as np

from benchmarks.device import contestants

HIDDEN = {**os.environ, "CUDA_VISIBLE_DEVICES": "-1"}


def run(*command):
    return subprocess.run(command, capture_output=True, text=True, env=HIDDEN, check=False)


class Numbers:
    """An array as the contestants give it."""

    def __init__(self, *numbers):
        self.numbers = np.array(numbers, dtype=np.int64)

    def __len__(self):
        return len(self.numbers)

    def cpu(self):
        return self

    def numpy(self):
        return self.numbers


def faults(program):
    for part in "123456":
        done = run(program, "--part", part)
        if (done.returncode, done.stdout) != (6, "") or "device: no device" not in done.stderr:
            yield f"part {part} ends with {done.returncode}: {done.stderr}"
    if run(program, "--part", "7").returncode != 2:
        yield "part 7 is not refused"
    # The pairs (0, 1), (0, 2) and (1, 2) as little-endian numbers of 32 bits.
    expected = "sha256:72373165deffec74d858505d53012fbaf7c533a0434b8179030dea3b85939ca2"
    found = contestants.digest(np.array([2, 1, 0]), np.array([1, 0, 2]))
    if found != expected:
        yield f"the digest is {found}"

    def pairs(points, cutoff):
        return Numbers(2, 1, 0), Numbers(1, 0, 2)

    right = contestants.measured(pairs, None, 1.0, expected, lambda: None)
    if right[:2] != (3, "right") or right[3] is None:
        yield f"a right answer is {right}"
    wrong = contestants.measured(pairs, None, 1.0, "sha256:0", lambda: None)
    if wrong != (3, "WRONG", None, None):
        yield f"a wrong answer is {wrong}"


def main():
    found = list(faults(sys.argv[1]))
    for fault in found:
        print(fault)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

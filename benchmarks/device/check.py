"""Checks the benchmarks of the device as far as that can be done without one.

Usage: check.py PROGRAM
The program says that there is no device, the contestants' pairs have the digest of abut, a wrong
answer is not timed, and abut stands in the table with them.
"""

import os
import subprocess
import sys

import numpy as np

from benchmarks.device import contestants

HIDDEN = {**os.environ, "CUDA_VISIBLE_DEVICES": "-1"}


def run(*command):
    return subprocess.run(command, capture_output=True, text=True, env=HIDDEN, check=False)


def bench_run(result, device, median, digest):
    return {"result": result, "device": device, "contact_pairs": 3, "digest": digest,
            "ns_per_element": {"first": 2.0 * median, "median": median, "minimum": median}}


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
    yield from faults_of_rows(expected)


def faults_of_rows(digest):
    """A table of a thousand elements: of abut, and of one who takes five times as long."""
    told = {"elements": 1000, "runs": [
        {"result": "canonical", "not_run": "for some reason"},
        bench_run("canonical", "cpu", 80.0, digest), bench_run("canonical", "cpu", 40.0, digest),
        bench_run("as_found", "cpu", 1.0, digest), bench_run("canonical", "gpu:0", 2.0, digest)]}
    rows, seconds = contestants.rows_of_abut(told, "dense", digest)
    rows.append(contestants.row_of("other", "dense", 1000, (3, "right", 1e-3, 1e-5), seconds))
    expected = [
        ["abut::device", "dense", 1000, 3, "right", "0.0040", "0.0020", "2.0000", "0.5000", "1.00"],
        ["abut on the processor", "dense", 1000, 3, "right", "0.0800", "0.0400", "40.0000",
         "0.0250", "20.00"],
        ["other", "dense", 1000, 3, "right", "1.0000", "0.0100", "10.0000", "0.1000", "5.00"]]
    if rows != expected:
        yield f"the rows are {rows}"
    if any(len(row) != len(contestants.HEADING) for row in rows):
        yield "rows are not as long as their heading"
    told["runs"][-1]["digest"] = "sha256:0"
    told["runs"].append(bench_run("canonical", "gpu:0", 1.0, digest))
    rows, seconds = contestants.rows_of_abut(told, "dense", digest)
    if rows[0] != ["abut::device", "dense", 1000, 3, "WRONG"] + 5 * [""] or seconds is not None:
        yield f"the rows of a wrong answer are {rows}, {seconds} s"
    if rows[1][-1] != "":
        yield f"a ratio to a wrong answer is {rows[1][-1]}"


def main():
    found = list(faults(sys.argv[1]))
    for fault in found:
        print(fault)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

"""Runs the example examples/drum.cpp and checks what it claims: the energy ledger closes, the better
the shorter the step; the drum lifts the spheres to one side and none gets out; springs go on from
facet to facet.  check_drum.py PROGRAM"""

import re
import subprocess
import sys

RADIUS = 5.0  # of the drum


def run(program, steps, dt):
    result = subprocess.run([program, "200", str(steps), str(dt)], check=True, capture_output=True,
                            text=True)
    return result.stdout.splitlines()


def numbers(lines, name):
    """A number of each line that has it."""
    found = (re.search(rf"{name} ([-+.e\d]+)", line) for line in lines)
    return [float(match[1]) for match in found if match]


def check(condition, sentence):
    if not condition:
        sys.exit(f"drum: {sentence}")


def main():
    program = sys.argv[1]
    lines = run(program, 10000, 5e-4)
    print(*lines, sep="\n")
    fine = max(map(abs, numbers(lines, "ledger")))
    check(fine < 2e-3, f"the ledger is off by {fine}")
    coarse = max(map(abs, numbers(run(program, 5000, 1e-3), "ledger")))
    check(coarse > 2.0 * fine, f"the ledger shrinks from {coarse} to {fine} only")
    work = numbers(lines, "work")
    check(work == sorted(work) and work[-1] > 1000.0, f"the drum does the work {work}")
    check(numbers(lines, "farthest")[0] < RADIUS, "a sphere got out")
    check(numbers(lines, "mean")[0] > 0.5, "the drum does not lift the spheres")
    times = int(re.search(r"(\d+) times from facet", lines[-1])[1])
    check(times > 100, f"springs went on {times} times only")


if __name__ == "__main__":
    main()

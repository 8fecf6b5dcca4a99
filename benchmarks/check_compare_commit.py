"""Checks what benchmarks/compare_commit says of programs whose times are known, and of wrong
arguments.

Usage, in the project's folder: python3 -m benchmarks.check_compare_commit
"""

import os
import stat
import subprocess
import sys
import tempfile

from benchmarks.common.tables import ROOT

# Knows one scene. Takes the next one of its times in each run.
PROGRAM = """#!/bin/sh
[ "$2" != gas ] || {{ echo "matrix: no scene is called 'gas'; there is dense" >&2; exit 2; }}
cd "$(dirname "$0")"
run=$(cat runs 2>/dev/null || echo 0)
echo $((run + 1)) > runs
set -- {times}
shift $((run % $#))
echo case,task,ns_minimum,cpu_ns_minimum,pairs,contact_pairs
echo "open,list,$1,$1,{pairs},{pairs}"
"""


def build(folder, name, times, pairs=3):
    """A build folder with a program that takes these times."""
    programs = os.path.join(folder, name, "benchmarks")
    os.makedirs(programs)
    for program in ("matrix", "periodic_cost"):
        path = os.path.join(programs, program)
        with open(path, "w") as file:
            file.write(PROGRAM.format(times=" ".join(str(t) for t in times), pairs=pairs))
        os.chmod(path, os.stat(path).st_mode | stat.S_IXUSR)
    return os.path.join(folder, name)


def compare(*arguments):
    command = [sys.executable, "-B", os.path.join(ROOT, "benchmarks", "compare_commit"), *arguments]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return done.returncode, done.stdout


def of_builds(folder):
    """Arguments, expected exit code and words of what is printed."""
    usual = ["--scenes", "dense", "--counts", "1e3", "--threads", "1", "--rounds", "4"]

    def case(name, a, b, *more, pairs=3):
        return ["before", "--build-a", build(folder, name + "_a", a), "--build-b",
                build(folder, name + "_b", b, pairs), *usual, *more]

    yield case("same", [100, 110], [101, 109]), 0, "none of 2 cases is slower"
    yield case("slower", [100, 110], [110, 120]), 1, "2 of 2 cases are slower by more than 3 %"
    yield (case("slower_list", [100], [104], "--threads", "2"), 1,
           "in every round: dense, 1,000, list, 2 threads")
    yield case("a_little", [100], [102.9]), 0, "1.029   1.029   1.029\n"
    yield (case("noise", [100, 100, 100, 100], [110, 110, 110, 103]), 0,
           "1.100   1.030   1.100  ?")
    yield (case("new_scene", [100], [100], "--scenes", "gas,dense"), 0,
           "gas, 1,000: left out: matrix: no scene is called 'gas'\n")
    yield case("other", [100], [100], pairs=4), 2, "A finds 3 pairs and B 4"
    only = case("only", [100], [100], "--scenes", "gas")
    yield only, 2, "nothing was compared"
    yield ([*only[:2], os.path.join(folder, "nowhere"), *only[3:]], 2, "there is no program")
    base = case("base", [100], [61], "--counts", "1e6")
    yield ["b2415f0", *base[1:]], 0, "aim of dense, 1,000,000: 0.610, at most 0.6 of b2415f0: missed"


# Arguments that would start a build if they were let pass have one.
NOWHERE = ["main", "--build-a", "nowhere", "--build-b", "nowhere"]
WRONG = [
    ([], "COMMIT"),
    (["no_such_commit"], "no commit is called 'no_such_commit'"),
    ([*NOWHERE, "--scenes", "dense,dens"], "no scene of the matrix is called 'dens'"),
    ([*NOWHERE, "--counts", "1e3,none"], "'none' is not a number of 1 or more"),
    ([*NOWHERE, "--threads", "0"], "'0' is not a number of 1 or more"),
    ([*NOWHERE, "--rounds", "-1"], "'-1' is not a number of 1 or more"),
    ([*NOWHERE, "--present-scenes"], "leave out --build-a"),
]


def faults():
    with tempfile.TemporaryDirectory() as folder:
        cases = [*of_builds(folder), *((arguments, 2, words) for arguments, words in WRONG)]
        for arguments, code, words in cases:
            found, text = compare(*arguments)
            if found != code or words not in text:
                yield (f"compare_commit {' '.join(arguments)}: exit code {found}, wanted {code} and "
                       f"'{words}':\n{text}")


def main():
    found = list(faults())
    for fault in found:
        print(fault)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

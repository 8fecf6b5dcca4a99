"""Programs of two builds that take turns, so that both meet the same machine."""

import argparse
import csv
import dataclasses
import os
import statistics
import subprocess


class Refused(Exception):
    """What a program said that ended with an error, or that there is none."""

    def __init__(self, build, words):
        super().__init__(words)
        self.build = build


@dataclasses.dataclass(frozen=True)
class Run:
    ns: float  # for an element, the fastest of the repetitions
    pairs: str


@dataclasses.dataclass(frozen=True)
class Comparison:
    """The times of a case in two builds, a number for each round."""
    case: str
    a: list[Run]
    b: list[Run]

    @property
    def ratios(self):
        return [after.ns / before.ns for before, after in zip(self.a, self.b)]

    @property
    def medians(self):
        return [statistics.median(run.ns for run in runs) for runs in (self.a, self.b)]

    @property
    def pairs(self):
        """The numbers of pairs of A and B: where they differ the arrays did."""
        return self.a[0].pairs, self.b[0].pairs

    def line(self):
        a, b = self.medians
        return (f"{self.case:72} {a:9.1f} {b:9.1f} {statistics.median(self.ratios):7.3f} "
                f"{min(self.ratios):7.3f} {max(self.ratios):7.3f}")


HEADING = f"{'case':72} {'A, ns':>9} {'B, ns':>9} {'B / A':>7} {'from':>7} {'to':>7}"


def program(build, name):
    path = os.path.join(build, "benchmarks", name)
    if not os.access(path, os.X_OK) or os.path.isdir(path):
        raise Refused(build, f"there is no program {path}; build its target with "
                      "-DABUT_BUILD_BENCHMARKS=ON")
    return path


def table(build, command):
    """The rows of a program that writes CSV."""
    command = [program(build, command[0]), *command[1:]]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if done.returncode != 0:
        raise Refused(build, f"{' '.join(command)} ended with {done.returncode}:\n{done.stderr}")
    return list(csv.DictReader(done.stdout.splitlines()))


def by(threads):
    """The end of the name of a case."""
    return f", {threads} threads" if threads > 1 else ""


def runs_of_matrix(build, scene, count, threads, repetitions):
    """What abut does by itself, by case, of one round. Of one thread its processor time counts, of
    several the time of the clock."""
    rows = table(build, ["matrix", "--scenes", scene, "--counts", str(count), "--contestants",
                         "abut_auto", "--threads", str(threads), "--time-limit", "600",
                         "--repetitions", str(repetitions)])
    clock = "cpu_ns_minimum" if threads == 1 else "ns_minimum"
    return {f"{scene}, {count:,}, {row['task']}{by(threads)}": Run(float(row[clock]), row["pairs"])
            for row in rows if row[clock]}


def runs_of_cells(build, count, repetitions):
    rows = table(build, ["periodic_cost", "--count", str(count), "--repetitions",
                         str(repetitions)])
    return {f"periodic_cost, {count:,}, {row['case']}":
            Run(float(row["ns_minimum"]), row["contact_pairs"]) for row in rows}


def comparisons(builds, measure, rounds):
    """Of each case that both builds have. measure(BUILD) gives runs by case."""
    found = {}
    for number in range(rounds):
        # Who begins changes, so that neither is always the one that meets a cold machine.
        for side in (0, 1) if number % 2 == 0 else (1, 0):
            for case, run in measure(builds[side]).items():
                found.setdefault(case, ([], []))[side].append(run)
    return [Comparison(case, a, b) for case, (a, b) in found.items() if a and b]


def positive(text):
    try:
        number = int(float(text))
    except (ValueError, OverflowError):
        number = 0
    if number < 1:
        raise argparse.ArgumentTypeError(f"'{text}' is not a number of 1 or more")
    return number


def numbers_in(text):
    return [positive(number) for number in text.split(",")]

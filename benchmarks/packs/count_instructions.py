"""Counts the instructions of one detection (count form) of every case and every algorithm but
direct_check, with valgrind's callgrind: a figure without noise. Up to 100,000 elements.
CSV on stdout."""

import argparse
import concurrent.futures
import csv
import io
import os
import subprocess
import sys

from benchmarks.common.instructions import instructions

MOST_ELEMENTS = 100_000  # valgrind makes a program some fifty times slower
REFUSED = 4  # exit code: more memory would be needed than is allowed


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--quick", action="store_true", help="the small packs")
    parser.add_argument("--algorithm", help="this one alone; else all but direct_check")
    options = parser.parse_args()
    program = os.path.abspath(options.program)

    command = [program, "--quick", "list"] if options.quick else [program, "list"]
    cases = subprocess.run(command, capture_output=True, text=True, check=True)
    reader = csv.DictReader(io.StringIO(cases.stdout))
    rows = [
        row
        for row in reader
        if row["numbering"] == "along"
        and row["algorithm"] != "direct_check"
        and int(row["elements"]) <= MOST_ELEMENTS
        and options.algorithm in (None, row["algorithm"])
    ]

    def count(row):
        arguments = [row[k] for k in ("pack", "rows", "columns", "spacing", "algorithm")]
        return instructions([program, "once", *arguments], "abut::count_contact_pairs*", REFUSED)

    writer = csv.writer(sys.stdout, lineterminator="\n")
    writer.writerow([*reader.fieldnames, "instructions"])
    # Neighbours on the machine change times, not counts.
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for row, counted in zip(rows, pool.map(count, rows)):
            if counted is not None:
                writer.writerow([*row.values(), counted])


if __name__ == "__main__":
    main()

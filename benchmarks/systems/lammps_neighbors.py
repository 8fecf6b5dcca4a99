"""Neighbor lists of abut beside those of LAMMPS, of the same elements in open space.

Usage: lammps_neighbors.py PROGRAM [--lmp COMMAND] [--builds N] [OPTIONS OF neighbor_lists...]
PROGRAM is neighbor_lists; its table comes out with a line of LAMMPS for each skin. LAMMPS (Debian's
package lammps) builds a half list in each of N steps in which nothing moves, its atoms sorted in
space before the first; the time is what it reports for neighbor lists. It must find as many
neighbors: else exit code 7. Without LAMMPS, 5.
"""

import argparse
import csv
import os
import re
import shutil
import subprocess
import sys
import tempfile

SCRIPT = """\
units lj
atom_style atomic
boundary s s s
newton on
read_data {data}
pair_style zero {reach:.17g}
pair_coeff * *
neighbor {skin:.17g} bin
neigh_modify every 1 delay 0 check no one 20000 page 400000
fix 1 all nve
run {builds}
"""


def run(command, **options):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True, **options).stdout


def reported(pattern, text):
    found = re.search(pattern, text, re.M)
    if not found:
        raise SystemExit(f"lammps_neighbors: LAMMPS' log has no line like '{pattern}'")
    return float(found[1])


def build_in_lammps(lmp, folder, data, row, builds):
    """Neighbors found, and ns for each element and build."""
    skin, cutoff = float(row["skin"]), float(row["cutoff"])
    script = os.path.join(folder, "in.neighbors")
    with open(script, "w") as file:
        file.write(SCRIPT.format(data=data, reach=cutoff - skin, skin=skin, builds=builds))
    log = run([lmp, "-in", script, "-log", "none"], cwd=folder,
              env={**os.environ, "OMP_NUM_THREADS": "1"})
    seconds = reported(r"^Neigh\s*\|\s*([0-9.eE+-]+)", log)
    done = reported(r"^Neighbor list builds = ([0-9]+)", log)
    neighbors = int(reported(r"^Total # of neighbors = ([0-9]+)", log))
    return neighbors, seconds * 1e9 / done / int(row["elements"])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--lmp", default="lmp")
    parser.add_argument("--builds", type=int, default=10)
    arguments, options = parser.parse_known_args()
    if not shutil.which(arguments.lmp):
        print(f"lammps_neighbors: there is no '{arguments.lmp}'; it is in Debian's package lammps",
              file=sys.stderr)
        return 5

    different = 0
    with tempfile.TemporaryDirectory() as folder:
        data = os.path.join(folder, "elements.data")
        own = run([arguments.program, "--lammps", data, *options])
        rows = list(csv.DictReader(own.splitlines()))
        out = csv.DictWriter(sys.stdout, fieldnames=rows[0].keys(), lineterminator="\n")
        out.writeheader()
        for row in rows:
            out.writerow(row)
            if row["task"] != "half list":
                continue
            neighbors, ns = build_in_lammps(arguments.lmp, folder, data, row, arguments.builds)
            out.writerow({**row, "task": "LAMMPS half list", "found": neighbors, "ns": f"{ns:.1f}"})
            if neighbors != int(row["found"]):
                different += 1
                print(f"lammps_neighbors: LAMMPS finds {neighbors} neighbors at skin {row['skin']}, "
                      f"abut {row['found']}", file=sys.stderr)
    return 7 if different else 0


if __name__ == "__main__":
    sys.exit(main())

"""Checks the parts of systems/run on small systems, without a judgement of times.

Usage: check.py FOLDER_OF_PROGRAMS
Every program that was built writes its table; the report turns all into a copy of the page. LAMMPS
is played by a few lines of Python that read the data file and the input as LAMMPS would.
"""

import os
import shutil
import subprocess
import sys
import tempfile

from benchmarks.common.pages import contents, section_of
from benchmarks.common.tables import ROOT

PAGE = os.path.join(ROOT, "docs", "benchmarks_systems.md")

PROGRAMS = {
    "box_contacts": ["--counts", "500", "--repetitions", "1"],
    "periodic_cost": ["--count", "500", "--repetitions", "1"],
    "cross_contacts": ["--count", "500", "--repetitions", "1"],
    "skin_reuse": ["--counts", "500,50000", "--repetitions", "1"],
    "stepping": ["--count", "500", "--steps", "10"],
    "pair_geometry": ["--count", "500", "--atoms", "300", "--repetitions", "1"],
    "moving_walls": ["--count", "3000", "--triangles", "300", "--steps", "2"],
    "liquid_loop": ["--cells", "5", "--steps", "3"],
}

LAMMPS = """#!{python}
import itertools, sys
lines = [line.split() for line in open(sys.argv[2])]
value = {{line[0]: line[1:] for line in lines if line}}
data = open(value["read_data"][0]).read().split("Atoms # atomic")
count = int(data[0].split(" atoms")[0].split()[-1])
atoms = [tuple(map(float, line.split()[2:])) for line in data[1].split("\\n") if line]
assert len(atoms) == count, (len(atoms), count)
cutoff = float(value["pair_style"][1]) + float(value["neighbor"][0])
near = sum(sum((p - q) ** 2 for p, q in zip(a, b)) <= cutoff ** 2
           for a, b in itertools.combinations(atoms, 2))
builds = int(value["run"][0])
print("Neigh   | 0.5        | 0.5        | 0.5        |   0.0 | 50.00")
print(f"Total # of neighbors = {{near - {missing}}}")
print(f"Neighbor list builds = {{builds}}")
"""


def run(*command, code=0):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if done.returncode != code:
        raise SystemExit(f"{command}: exit code {done.returncode} instead of {code}\n{done.stderr}")
    return done.stdout


def written(path, text):
    with open(path, "w") as file:
        file.write(text)
    return path


def play_lammps(folder, missing):
    path = written(os.path.join(folder, f"lmp_{missing}"),
                   LAMMPS.format(python=sys.executable, missing=missing))
    os.chmod(path, 0o755)
    return path


def main(programs):
    module = (sys.executable, "-B", "-m")
    with tempfile.TemporaryDirectory() as folder:
        made = []
        for name, options in PROGRAMS.items():
            program = os.path.join(programs, name)
            if not os.path.exists(program):
                continue  # its contestants are not installed
            table = run(program, *options)
            made.append(name)
            written(os.path.join(folder, f"{name}.csv"), "# processor: any\n" + table)

        lists = ["benchmarks.systems.lammps_neighbors",
                 os.path.join(programs, "neighbor_lists"), "--builds", "3"]
        small = ["--count", "300", "--repetitions", "1"]
        table = run(*module, *lists, "--lmp", play_lammps(folder, 0), *small)
        if table.count("LAMMPS half list") != 3:
            raise SystemExit(f"not three lines of LAMMPS:\n{table}")
        run(*module, *lists, "--lmp", play_lammps(folder, 1), *small, code=7)
        run(*module, *lists, "--lmp", os.path.join(folder, "none"), *small, code=5)
        made.append("neighbor_lists")
        written(os.path.join(folder, "neighbor_lists.csv"), "# processor: any\n" + table)

        copy = shutil.copy(PAGE, folder)
        run(*module, "benchmarks.systems.report", folder, "--docs", copy)
        before, after = contents(PAGE), contents(copy)
        for name in made:
            if section_of(before, name) == section_of(after, name):
                raise SystemExit(f"the page does not show the new table {name}")
        if "Measured on: processor any" not in section_of(after, "machine"):
            raise SystemExit("the page does not name the new machine")
        print(f"tables of {', '.join(made)}")


if __name__ == "__main__":
    main(*sys.argv[1:])

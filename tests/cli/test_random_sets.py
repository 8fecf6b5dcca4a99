"""Random small systems, one set or two, with rules and boxes, against a check of all pairs in whole
numbers: coordinates, radii and boxes are whole, so that nothing here is rounded."""

import itertools
import random

import pytest
from conftest import pairs_of_csv

SYSTEMS = range(120)


class System:
    """What the random numbers of a seed make; `files` are written where they are asked for."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.dimensions = self.random.choice([2, 3])
        self.two = self.random.random() < 0.6
        self.sets = [self.elements() for _ in range(1 + self.two)]
        self.box = [self.random.choice([None, 6, 7, 9]) for _ in range(self.dimensions)]
        self.margin = self.random.choice([0, 1])
        self.rule = self.random.choice(["none", "groups", "deny", "exclude", "all"])
        has_table = self.rule in ("deny", "all")
        self.denied = [self.some_groups() for _ in range(3)] if has_table else []
        self.excluded = self.some_pairs() if self.rule in ("exclude", "all") else []

    def elements(self):
        """(coordinates, radius, group) of each."""
        count = self.random.choice([0, 1, 5, 12])
        return [([self.random.randrange(10) for _ in range(self.dimensions)],
                 self.random.randrange(3), self.random.randrange(4)) for _ in range(count)]

    def some_groups(self):
        return self.random.randrange(4), self.random.randrange(5)

    def some_pairs(self):
        first, second = self.sets[0], self.sets[-1]
        if not first or not second:
            return []
        return [(self.random.randrange(len(first)), self.random.randrange(len(second)))
                for _ in range(len(first) * len(second) // 3)]

    def allows(self, i, j):
        a, b = self.sets[0][i][2], self.sets[-1][j][2]
        excluded = set(self.excluded)
        if (i, j) in excluded or (not self.two and (j, i) in excluded):
            return False
        if self.denied:
            return (a, b) not in self.denied and (b, a) not in self.denied
        return a != b if self.rule == "groups" else True

    def shifts(self):
        axes = [range(-3, 4) if length else [0] for length in self.box]
        return itertools.product(*axes, *[[0]] * (3 - self.dimensions))

    def expected(self):
        """(i, j, shift) ascending."""
        pairs = []
        for (i, a), (j, b) in itertools.product(enumerate(self.sets[0]), enumerate(self.sets[-1])):
            for shift in self.shifts():
                if not self.two and (i > j or (i == j and shift <= (0, 0, 0))):
                    continue
                square = sum((x - y - n * (length or 0)) ** 2
                             for x, y, n, length in zip(a[0], b[0], shift, self.box))
                if square <= (a[1] + b[1] + self.margin) ** 2 and self.allows(i, j):
                    pairs.append((i, j, shift))
        return pairs

    def write(self, path, elements):
        """In a format of its own for each file."""
        axes = "xyz"[:self.dimensions]
        suffix = self.random.choice([".csv", ".dump", ".xyz"] if elements else [".csv"])
        rows = [[*point, radius, group] for point, radius, group in elements]
        if suffix == ".csv":
            lines = [[*axes, "radius", "g"], *rows]
        elif suffix == ".xyz":
            name = f"Properties=pos:R:{self.dimensions}:radius:R:1:g:I:1"
            lines = [[len(rows)], [name], *rows]
        else:
            lines = [["ITEM: TIMESTEP"], [0], ["ITEM: NUMBER OF ATOMS"], [len(rows)],
                     ["ITEM: BOX BOUNDS ff ff ff"], *[[0, 9]] * 3,
                     ["ITEM: ATOMS", *axes, "radius", "g"], *rows]
        separator = "," if suffix == ".csv" else " "
        text = "".join(separator.join(map(str, line)) + "\n" for line in lines)
        path = path.with_suffix(suffix)
        path.write_text(text)
        return path

    def arguments(self, folder):
        result = [self.write(folder / "first", self.sets[0]), "--margin", self.margin]
        if self.two:
            result += ["--against", self.write(folder / "second", self.sets[1])]
        if any(self.box):
            result += ["--box", ",".join(str(length or "inf") for length in self.box)]
        if self.rule in ("groups", "deny", "all"):
            result += ["--groups", "g"]
        for a, b in self.denied:
            result += ["--deny", f"{a},{b}"]
        if self.rule in ("exclude", "all"):
            text = "note,i,j\n" + "".join(f"kept,{i},{j}\n" for i, j in self.excluded)
            (folder / "excluded.csv").write_text(text)
            result += ["--exclude", folder / "excluded.csv"]
        return result


def triples_of_csv(text):
    header, *rows = text.splitlines()
    if header == "i,j,gap":
        return [(i, j, (0, 0, 0)) for i, j in pairs_of_csv(text)]
    assert header == "i,j,nx,ny,nz,gap"
    numbers = [[int(field) for field in row.split(",")[:5]] for row in rows]
    return [(i, j, tuple(shift)) for i, j, *shift in numbers]


@pytest.mark.parametrize("seed", SYSTEMS)
def test_pairs_are_those_of_a_check_of_all(abut, tmp_path, seed):
    system = System(seed)
    arguments = ["contacts", *system.arguments(tmp_path), "-q"]
    expected = system.expected()
    done = abut(*arguments, "-o", "-", "--algorithm", random.Random(seed).choice(
        ["rows", "direct_check", "auto"]))
    assert done.returncode == 0, done.stderr
    assert triples_of_csv(done.stdout) == expected, arguments
    assert abut(*arguments, "--count").stdout == f"{len(expected)}\n"


def test_the_systems_hold_what_they_should():
    """Pairs, of one set and of two, in boxes and without, with every rule; and pairs denied."""
    found = [(system, system.expected()) for system in map(System, SYSTEMS)]
    with_pairs = [system for system, pairs in found if len(pairs) >= 2]
    assert {(s.two, s.rule) for s in with_pairs} >= {
        (two, rule) for two in (False, True)
        for rule in ("none", "groups", "deny", "exclude", "all")}
    assert {any(s.box) for s in with_pairs} == {False, True}
    assert {s.dimensions for s in with_pairs} == {2, 3}
    for system, pairs in found:
        system.rule, system.denied, system.excluded = "none", [], []
    assert sum(len(pairs) < len(system.expected()) for system, pairs in found) > 30

"""Checks golden.txt against an independent brute force in integers, which rounds nothing:
  python3 check_golden.py FOLDER
That the digests are equal everywhere says little if they are wrong everywhere."""

import sys
from itertools import combinations
from pathlib import Path

SMALLEST_BIT = 1074  # every double is an integer times 2^-1074


def exact(word):
    numerator, denominator = float.fromhex(word).as_integer_ratio()
    return numerator * (2**SMALLEST_BIT // denominator)


def contact_pairs(lines):
    margin = exact(lines[0].split()[2])
    elements = [[exact(word) for word in line.split()] for line in lines[1:]]
    for (i, a), (j, b) in combinations(enumerate(elements), 2):
        reach = a[-1] + b[-1] + margin
        if sum((p - q) ** 2 for p, q in zip(a[:-1], b[:-1])) <= reach**2:
            yield i, j


def fnv(pairs):
    state = 0xCBF29CE484222325
    for pair in pairs:
        for byte in b"".join(number.to_bytes(4, "little") for number in pair):
            state = (state ^ byte) * 0x100000001B3 % 2**64
    return f"{state:016x}"


def main():
    folder = Path(sys.argv[1])
    golden = (folder / "golden.txt").read_text().splitlines()
    wrong = 0
    for file in sorted((folder / "scenes").iterdir()):
        pairs = sorted(contact_pairs(file.read_text().splitlines()))
        expected = f"{file.stem} pairs {len(pairs)} canonical {fnv(pairs)} gaps "
        if not any(line.startswith(expected) for line in golden):
            print(f"golden.txt has no line that begins with: {expected}")
            wrong += 1
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())

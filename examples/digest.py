"""Prints the digest of a list of pairs, as `abut contacts --digest` does for its own.

    digest.py < pairs.csv

Each line is i,j or, in a periodic domain, i,j,nx,ny,nz; a line that begins with a letter is a
heading. The order of the lines does not matter.
"""

import hashlib
import struct
import sys

pairs = sorted(tuple(map(int, line.split(","))) for line in sys.stdin if not line[0].isalpha())
bytes_of_pairs = (struct.pack(f"<2I{len(pair) - 2}i", *pair) for pair in pairs)
print("sha256:" + hashlib.sha256(b"".join(bytes_of_pairs)).hexdigest())

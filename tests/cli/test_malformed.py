"""Input that is not what it says: exit code 3, one sentence with the place, nothing written."""

import pytest

DUMP = """ITEM: TIMESTEP
0
ITEM: NUMBER OF ATOMS
2
ITEM: BOX BOUNDS ff ff ff
0 1
0 1
0 1
ITEM: ATOMS id x y z radius
1 0 0 0 0.5
2 1 0 0 0.5
"""

CASES = {
    "no header": ("1,2,3\n4,5,6\n", ""),
    "no y": ("x,z,radius\n1,2,3\n", "y"),
    "no radius": ("x,y\n1,2\n", "--radius|radius"),
    "x twice": ("x,x,y,radius\n1,2,3,4\n", "x"),
    "a word": ("x,y,radius\n1,2,3\n1,two,3\n", "line 3|two"),
    "NaN": ("x,y,radius\n1,nan,3\n", "nan"),
    "infinity": ("x,y,radius\n1,inf,3\n", "inf"),
    "too large": ("x,y,radius\n1,1e400,3\n", "1e400"),
    "negative radius": ("x,y,radius\n1,2,-3\n", "-3"),
    "decimal comma": ('x;y;radius\n1,5;2;3\n', ""),
    "hexadecimal": ("x,y,radius\n0x10,2,3\n", "0x10"),
    "too few columns": ("x,y,radius\n1,2\n", "line 2"),
    "too many columns": ("x,y,radius\n1,2,3,4\n", "line 2"),
    "empty field": ("x,y,radius\n1,,3\n", "line 2"),
    "a NUL byte": ("x,y,radius\n1,2,3\0\n", "line 2"),
    "open quote": ('x,y,radius\n1,2,"3\n', "line 2"),
    "binary": ("\x7fELF\2\1\1\0\0\0\0\0\n", ""),
    "UTF-16": (b"\xff\xfex\0,\0y\0", "UTF-16"),
    "gzip": (b"\x1f\x8b\x08\0\0\0\0\0", "gzip -dc FILE | abut contacts -"),
    "a line of 2 MiB": ("x,y,radius\n" + "1" * (2 << 20) + ",2,3\n", "line 2"),
    "dump, cut in its atoms": (DUMP[: DUMP.index("2 1 0")], "2"),
    "dump, cut in a number": (DUMP[:-6], ""),
    "dump, cut in its box": (DUMP[: DUMP.index("ITEM: ATOMS")], ""),
    "dump, more atoms than bytes": (DUMP.replace("\n2\n", "\n2000000000\n"), "2000000000"),
    "dump, count beyond 64 bits": (DUMP.replace("\n2\n", "\n99999999999999999999\n"), "9999"),
    "dump, negative count": (DUMP.replace("\n2\n", "\n-2\n"), "-2"),
    "dump, no radius": (DUMP.replace("radius", "mass"), "radius"),
    "dump, a word": (DUMP.replace("2 1 0 0", "2 one 0 0"), "one"),
    "xyz, cut": ("3\ncomment\nA 0 0 0 1\n", "3"),
    "xyz, absurd count": ("4000000000\ncomment\nA 0 0 0 1\n", "4000000000"),
}

# What is said of a table that no detection takes.
DESCRIBED = [
    *("no header", "no y", "no radius", "x twice", "dump, no radius", "a word", "NaN", "infinity"),
    *("too large", "negative radius", "decimal comma", "hexadecimal", "too few columns"),
    *("too many columns", "empty field", "open quote"),
]


@pytest.mark.parametrize("name", CASES)
def test_malformed(abut, fails, tmp_path, name):
    text, told = CASES[name]
    out = tmp_path / "out.csv"
    sentence = fails(3, "contacts", "-", "-o", out, stdin=text)
    assert "standard input" in sentence
    assert any(word in sentence for word in told.split("|")), sentence
    assert not out.exists()
    if name in DESCRIBED:
        assert abut("info", "-", stdin=text).returncode == 0
    else:
        fails(3, "info", "-", stdin=text)


def test_a_failed_run_leaves_the_old_file(fails, tmp_path):
    out = tmp_path / "out.csv"
    out.write_text("precious")
    fails(3, "contacts", "-", "-o", out, stdin="x,y,radius\n1,two,3\n")
    assert out.read_text() == "precious"
    assert [path.name for path in tmp_path.iterdir()] == ["out.csv"]

"""Names of files and columns, values and arguments that a terminal would obey: everything that is not
the tool's own text is shown, not sent."""

import json
import os
import subprocess
import unicodedata

import pytest
from conftest import DISCS, environment

# A colour, a second message, a bell, the title of the window, from right to left, no UTF-8, DEL.
HOSTILE = ["\x1b[31mred", "a\nabut: all is well", "\a\b\r", "\x1b]0;title\a", "\u202egnp.csv",
           "\udcff\udcfe", "\x7f\x9b31m", "\u2028\u200b\ufeff"]
EVERYTHING = "".join(HOSTILE)
SAMPLES = [HOSTILE[1], EVERYTHING]
GRAINS = "x,y,radius,NAME\n0,0,1,1\n2,0,1,2\n"
EMPTY_DUMP = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n{}\n"


def raw(text):
    """As bytes that subprocess hands on and files hold."""
    return os.fsencode(text)


def obeyed(data, lines=True):
    """Characters of an output that a terminal obeys, line ends left out."""
    text = data.decode("utf-8", errors="surrogateescape")
    return sorted({character for character in text
                   if unicodedata.category(character) in ("Cc", "Cf", "Cs", "Zl", "Zp")
                   and not (lines and character == "\n")})


@pytest.fixture
def run(tmp_path):
    """run(arguments..., stdin=text): the finished process, whose output nothing obeys and whose
    standard error is lines of the tool's own."""

    def call(*arguments, stdin="", env=None):
        done = subprocess.run(
            [os.environ["ABUT"], *map(raw, arguments)], input=raw(stdin), capture_output=True,
            env=env or environment(), cwd=tmp_path, check=False, timeout=300)
        for stream in (done.stdout, done.stderr):
            assert obeyed(stream) == [], stream
            assert all(len(line) < 3000 for line in stream.splitlines()), stream
        return done

    return call


def complains(done, code):
    lines = done.stderr.split(b"\n")
    assert done.returncode == code, done.stderr
    assert len(lines) == 2 and lines[0].startswith(b"abut: ") and lines[1] == b"", done.stderr
    assert len(lines[0]) < 1100 and b"abut: all is well" not in lines[0][:25], lines
    return lines[0].decode()


def write(folder, name, text):
    path = os.path.join(raw(str(folder)), raw(name))
    with open(path, "wb") as file:
        file.write(raw(text))
    return name


COMMANDS = [
    "contacts FILE", "contacts FILE -o OUT", "contacts FILE --count", "contacts FILE --json",
    "contacts FILE --against FILE", "contacts FILE --groups NAME", "contacts FILE --exclude PAIRS",
    "contacts FILE --groups NAME --deny 1,2 --deny 7,7", "contacts FILE -o OUT.vtp",
    "contacts FILE --groups NAME --deny 1,1 --deny 1,2 --deny 2,2 --deny 3,3",
    "neighbors FILE --cutoff 1", "neighbors FILE --cutoff 1 --against FILE --exclude PAIRS -o OUT",
    "info FILE", "info FILE --json", "compare FILE", "compare FILE --json",
    "bench FILE --repetitions 1 --groups NAME --exclude PAIRS", "bench FILE --json --repetitions 1",
    "explain munjiza_nbs FILE", "generate gas --count 5 -o OUT",
    "contacts FRAMES --radius 1", "info FRAMES --radius 1", "contacts DATA", "info DATA",
    "contacts NOTHING", "neighbors NOTHING --cutoff 1", "info NOTHING"]


@pytest.mark.parametrize("hostile", SAMPLES)
@pytest.mark.parametrize("command", COMMANDS)
def test_names_that_work(run, tmp_path, command, hostile):
    """Files that are there and columns that fit, under such names."""
    name = hostile
    files = {"FILE": name + ".csv", "PAIRS": name + "-pairs.csv", "FRAMES": name + ".xyz",
             "DATA": name + ".data", "NOTHING": name + "-nothing", "OUT": name + "-out.csv", "NAME": name,
             "OUT.vtp": name + ".vtp"}
    # A line of a table ends at a line feed, and a carriage return belongs there.
    column = name.replace("\n", " ").replace("\r", " ")
    files["NAME"] = column
    write(tmp_path, files["FILE"], GRAINS.replace("NAME", f'"{column}"'))
    write(tmp_path, files["PAIRS"], "i,j\n0,1\n")
    write(tmp_path, files["FRAMES"], "1\n\nX 0 0 0\n" * 2)
    write(tmp_path, files["DATA"], "#\n1 atoms\n0 9 xlo xhi\n\nAtoms # sphere\n\n1 1 1 1 0 0 1\n")
    write(tmp_path, files["NOTHING"], "")
    done = run(*[files.get(word, word) for word in command.split()])
    assert done.returncode == 0, done.stderr
    for line in done.stderr.split(b"\n")[:-1]:
        assert line.startswith(b"abut: "), done.stderr
    if "--json" in command and "contacts" not in command:
        found = json.loads(done.stdout)
        shown = found.get("file", found.get("input"))
        assert shown == "".join("\ufffd" if "\udc80" <= c <= "\udcff" else c
                                for c in files["FILE"])


@pytest.mark.parametrize("hostile", SAMPLES)
@pytest.mark.parametrize("arguments, code", [
    (["contacts", "TEXT"], 3), (["info", "TEXT"], 3), (["TEXT"], 2), (["TEXT", "--help"], 2),
    (["contacts", "-", "--TEXT"], 2), (["contacts", "-", "TEXT"], 2),
    (["contacts", "-", "--box", "TEXT"], 2), (["contacts", "-", "--lattice", "TEXT"], 2),
    (["contacts", "-", "--periodic", "TEXT"], 2), (["contacts", "-", "--format", "TEXT"], 2),
    (["contacts", "-", "--algorithm", "TEXT"], 2), (["contacts", "-", "--simd", "TEXT"], 2),
    (["contacts", "-", "--order", "TEXT"], 2), (["contacts", "-", "--threads", "TEXT"], 2),
    (["contacts", "-", "--margin", "TEXT"], 2), (["contacts", "-", "--radius", "TEXT"], 2),
    (["contacts", "-", "--frame", "TEXT"], 2), (["contacts", "-", "--max-pairs", "TEXT"], 2),
    (["contacts", "-", "--max-memory", "TEXT"], 2), (["contacts", "-", "--progress", "TEXT"], 2),
    (["contacts", "-", "--groups", "TEXT"], 3), (["contacts", "-", "--exclude", "TEXT"], 3),
    (["contacts", "-", "--groups", "x", "--deny", "TEXT"], 2),
    (["contacts", "-", "--against", "TEXT"], 3),
    (["contacts", "-", "-o", "TEXT.pdf"], 2), (["contacts", "-", "-o", "nowhere/TEXT.csv"], 5),
    (["contacts", "-", "-o", "TEXT/TEXT.csv"], 5), (["neighbors", "-", "--cutoff", "TEXT"], 2),
    (["neighbors", "-", "--cutoff", "1", "-o", "nowhere/TEXT.csv"], 5),
    (["generate", "TEXT", "--count", "1"], 2), (["generate", "gas", "--count", "TEXT"], 2),
    (["generate", "gas", "--count", "1", "--seed", "TEXT"], 2),
    (["generate", "gas", "--count", "1", "--format", "TEXT"], 2),
    (["generate", "gas", "--count", "1", "-o", "nowhere/TEXT.csv"], 5),
    (["compare", "TEXT"], 3), (["compare", "TEXT", "--count", "1"], 2),
    (["compare", "-", "--algorithms", "rows,TEXT"], 2), (["bench", "-", "--algorithms", "TEXT"], 2),
    (["bench", "-", "--threads", "1,TEXT"], 2), (["bench", "-", "--repetitions", "TEXT"], 2),
    (["bench", "gas", "--count", "9", "--groups", "TEXT"], 2),
    (["explain", "TEXT", "-"], 2), (["explain", "munjiza_nbs", "TEXT"], 3)])
def test_arguments_that_fail(run, arguments, code, hostile):
    done = run(*[word.replace("TEXT", hostile) for word in arguments], stdin=DISCS)
    complains(done, code)


@pytest.mark.parametrize("hostile", SAMPLES)
@pytest.mark.parametrize("text, arguments", [
    ("x,y,radius\n0,TEXT,1\n", []), ("x,y,radius\n0,0,TEXT\n", []), ("x,TEXT,radius\n", []),
    ("x,y,TEXT\n0,0,1\n", []), ("x,y,radius,TEXT\n0,0,1,TEXT\n", ["--groups", "mol"]),
    ("x,y,radius,mol\n0,0,1,TEXT\n", ["--groups", "mol"]), ("xmin,TEXT\n0,0\n", []),
    ("ITEM: TEXT\n", []), ("ITEM: TIMESTEP\nTEXT\n", []),
    (EMPTY_DUMP.format("TEXT"), []), (EMPTY_DUMP.format("1") + "ITEM: BOX BOUNDS TEXT\n", []),
    (EMPTY_DUMP.format("1") + "ITEM: BOX BOUNDS\n0 TEXT\n0 1\n0 1\n", []),
    (EMPTY_DUMP.format("1") + "ITEM: BOX BOUNDS\n0 1\n0 1\n0 1\nITEM: ATOMS x y TEXT\n0 0 1\n", []),
    (EMPTY_DUMP.format("1") + "ITEM: BOX BOUNDS\n0 1\n0 1\n0 1\n"
     "ITEM: ATOMS id x y radius\nTEXT 0 0 1\n", []),
    ("1\nLattice=\"TEXT\"\nX 0 0 0 1\n", []), ("1\nProperties=TEXT\nX 0 0 0 1\n", []),
    ("1\npbc=\"TEXT\"\nX 0 0 0 1\n", []), ("1\nTEXT=\"open pbc=\nX 0 0 0 1\n", []),
    ("1\nc\nX 0 TEXT 0 1\n", []), ("TEXT\nc\n", ["--format", "xyz"]),
    ("LAMMPS\nTEXT atoms\n", []), ("LAMMPS\n1 atoms\nAtoms # TEXT\n\n1 1 0 0 0\n", []),
    ("LAMMPS\n1 atoms\n0 TEXT xlo xhi\n", []),
    ("LAMMPS\n1 atoms\n\nAtoms # sphere\n\nTEXT 1 1 1 0 0 0\n", []),
    ("LAMMPS\n1 atoms\n\nAtoms # sphere\n\n1 1 1 TEXT 0 0 TEXT\n", []),
])
def test_contents_that_fail(run, text, arguments, hostile):
    text = text.replace("TEXT", hostile)
    complains(run("contacts", "-", *arguments, stdin=text), 3)


@pytest.mark.parametrize("hostile", SAMPLES)
@pytest.mark.parametrize("text", ["TEXT\n0,1\n", "i,TEXT\n0,1\n", "i,j\n0,TEXT\n", "i,j\nTEXT,0\n"])
def test_pairs_that_fail(run, tmp_path, text, hostile):
    write(tmp_path, "discs.csv", DISCS)
    complains(run("contacts", "discs.csv", "--exclude", "-", stdin=text.replace("TEXT", hostile)), 3)


def test_two_files_that_do_not_fit(run, tmp_path):
    flat = write(tmp_path, EVERYTHING + ".csv", "x,y,radius,id\n0,0,1,word\n")
    solid = write(tmp_path, EVERYTHING + "3.csv", "x,y,z,radius\n0,0,0,1\n")
    boxes = write(tmp_path, EVERYTHING + "4.csv", "xmin,ymin,xmax,ymax\n0,0,1,1\n")
    dump = write(tmp_path, EVERYTHING + ".dump", EMPTY_DUMP.format("0") +
                 "ITEM: BOX BOUNDS pp pp pp\n0 1\n0 1\n0 1\nITEM: ATOMS x y z radius\n")
    wide = write(tmp_path, EVERYTHING + "2.dump", EMPTY_DUMP.format("0") +
                 "ITEM: BOX BOUNDS pp pp pp\n0 2\n0 1\n0 1\nITEM: ATOMS x y z radius\n")
    broken = write(tmp_path, EVERYTHING + "3.dump", EMPTY_DUMP.format("0") +
                   "ITEM: BOX BOUNDS pp pp pp\n0 0\n0 1\n0 1\nITEM: ATOMS x y z radius\n")
    for code, *arguments in (
            (2, "contacts", flat, "--against", solid), (2, "contacts", flat, "--against", boxes),
            (2, "contacts", flat, "--against", flat, "--radius", "1"),
            (2, "contacts", flat, "--against", flat, "--frame", "3"),
            (2, "contacts", dump, "--against", wide), (2, "contacts", flat, "--ids", "-o", "out"),
            (2, "contacts", flat, "-o", flat), (2, "contacts", flat, "--periodic", "x"),
            (2, "contacts", flat, "--periodic", "z"), (2, "explain", "munjiza_nbs", dump),
            (3, "neighbors", boxes, "--cutoff", "1"), (3, "contacts", broken),
            (3, "contacts", flat, "--frame", "3"), (3, "contacts", dump, "--frame", "3")):
        complains(run(*arguments, "--progress", "none", "-q"), code)


def test_a_level_in_the_environment(run):
    level = environment(ABUT_SIMD=EVERYTHING)
    complains(run("contacts", "-", stdin=DISCS, env=level), 2)


@pytest.mark.parametrize("arguments", [["LONG"], ["contacts", "LONG"], ["contacts", "-", "--LONG"],
                                       ["contacts", "-", "--algorithm", "LONG"],
                                       ["contacts", "-", "--margin", "LONG"],
                                       ["generate", "LONG", "--count", "1"]])
def test_long_text_is_shortened(run, arguments):
    for letter in "x\n":
        done = run(*[word.replace("LONG", letter * 100_000) for word in arguments], stdin=DISCS)
        assert len(done.stderr) < 1100 and done.returncode in (2, 3)
        assert b"..." in done.stderr


@pytest.mark.parametrize("hostile", [*HOSTILE, "it's \\ $HOME", "it's \\\x1b"])
def test_proposed_commands_can_be_pasted(run, tmp_path, hostile):
    """The command that is proposed names the very file, in a shell that knows $'...'."""
    name = write(tmp_path, hostile + ".csv", DISCS)
    text = run("info", name).stdout.decode()
    command = text[text.rindex("next") + 4:].strip()
    assert command.startswith("abut contacts ")
    tool = f"abut() {{ '{os.environ['ABUT']}' \"$@\"; }}; {command} --count"
    done = subprocess.run(["bash", "-c", tool], capture_output=True, cwd=tmp_path, check=False,
                          timeout=300, env=environment())
    assert (done.returncode, done.stdout) == (0, b"2\n"), (command, done.stderr)

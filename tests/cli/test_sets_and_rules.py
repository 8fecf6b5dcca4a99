"""Two files against each other, and who may pair."""

import hashlib
import json
import re
import struct

import pytest
from conftest import DATA, pairs_of_csv, without_measurements

GRAINS = "id,x,y,radius,mol\n10,0,0,1,5\n11,2,0,1,5\n12,4,0,1,6\n13,9,9,1,7\n"
PROBES = "x,y,id\n3,0,70\n0.5,0.5,71\n-8,0,72\n"


@pytest.fixture
def folder(tmp_path):
    """Four grains in a row of touching pairs and three probes, the first on two grains."""
    (tmp_path / "grains.csv").write_text(GRAINS)
    (tmp_path / "probes.csv").write_text(PROBES)
    (tmp_path / "pairs.csv").write_text("j,i,why\n1,0,bond\n2,2,own images\n")
    return tmp_path


def run(abut, folder, arguments, **keywords):
    done = abut(*arguments.split(), cwd=folder, **keywords)
    assert done.returncode == 0, done.stderr
    return done


AGAINST = "contacts probes.csv --against grains.csv --radius 0"


def test_pairs_of_two_files(abut, folder):
    assert run(abut, folder, AGAINST + " -q -o -").stdout == (
        "i,j,gap\n0,1,0\n0,2,0\n1,0,-0.29289321881345243\n")
    assert run(abut, folder, AGAINST + " -q --ids -o -").stdout.splitlines()[:2] == [
        "i,j,id_i,id_j,gap", "0,1,70,11,0"]
    assert run(abut, folder, AGAINST + " --count").stdout == "3\n"
    turned = "contacts grains.csv --against probes.csv --radius 0 -q -o -"
    assert pairs_of_csv(run(abut, folder, turned).stdout) == [(0, 1), (1, 0), (2, 0)]
    # The grains keep the radii that they have; of the same file each pair has two orders.
    assert run(abut, folder, AGAINST + " --margin 0.6 --count").stdout == "4\n"
    itself = "contacts grains.csv --against grains.csv -q -o -"
    assert pairs_of_csv(run(abut, folder, itself).stdout) == [
        (0, 0), (0, 1), (1, 0), (1, 1), (1, 2), (2, 1), (2, 2), (3, 3)]


def test_digest_of_two_files(abut, folder):
    packed = struct.pack("<6I", 0, 1, 0, 2, 1, 0)
    for order in ("canonical", "as_found"):
        done = run(abut, folder, f"{AGAINST} --digest --threads 2 --order {order}")
        assert done.stdout == f"sha256:{hashlib.sha256(packed).hexdigest()}\n"


def test_summary_and_json_of_two_files(abut, folder, golden):
    text = run(abut, folder, AGAINST).stdout
    golden("summary_two_sets", without_measurements(text))
    command = re.search(r"next +abut (.*) -o contacts.vtp", text).group(1)
    assert run(abut, folder, command + " --count").stdout == "3\n", "the command that is proposed"
    found = json.loads(run(abut, folder, AGAINST + " --json").stdout)
    assert (found["elements"], found["sets"], found["contact_pairs"]) == (7, [3, 4], 3)
    written = json.loads(run(abut, folder, AGAINST + " -q --format json -o -").stdout)
    assert (written["elements"], written["sets"]) == (7, [3, 4])
    assert written["pairs"][0] == [0, 1, 0]
    run(abut, folder, AGAINST + " -q -o pairs.vtp")
    assert b'Name="set"' in (folder / "pairs.vtp").read_bytes()


def test_one_of_two_files_may_be_standard_input(abut, folder, fails):
    arguments = "contacts - --against grains.csv --radius 0 --count"
    assert run(abut, folder, arguments, stdin=PROBES).stdout == "3\n"
    arguments = "contacts grains.csv --against - --radius 0 --count"
    assert run(abut, folder, arguments, stdin=PROBES).stdout == "3\n"
    for arguments in ("contacts - --against -", "contacts - --exclude -",
                      "neighbors a.csv --cutoff 1 --against - --exclude -", "bench - --exclude -"):
        assert "standard input" in fails(2, *arguments.split(), cwd=folder)


@pytest.mark.parametrize("empty", ["", "x,y,z,radius\n", "x,y,radius\n", "xmin,ymin,xmax,ymax\n"])
@pytest.mark.parametrize("other", [GRAINS, "xmin,ymin,xmax,ymax\n0,0,1,1\n"])
def test_a_file_without_elements_goes_with_any(abut, tmp_path, empty, other):
    (tmp_path / "empty.csv").write_text(empty)
    (tmp_path / "other.csv").write_text(other)
    for files in ("empty.csv --against other.csv", "other.csv --against empty.csv",
                  "empty.csv --against empty.csv"):
        assert run(abut, tmp_path, f"contacts {files} --count").stdout == "0\n"
        assert "contact pairs  0" in run(abut, tmp_path, f"contacts {files}").stdout
        for suffix in ("csv", "json", "vtp"):
            run(abut, tmp_path, f"contacts {files} -q -o out.{suffix}")


@pytest.mark.parametrize("arguments, told", [
    ("grains.csv --against balls.csv", "grains.csv has 2 dimensions and balls.csv has 3"),
    ("grains.csv --against boxes.csv", "grains.csv holds discs and boxes.csv holds rectangles"),
    ("grains.csv --against grains.csv --radius 2", "--radius 2"),
    ("grains.csv --against grains.csv --frame 2", "--frame 2"),
    ("grains.csv --against ''", "--against"),
    ("grains.csv --against grains.csv -o grains.csv", "is read"),
    ("balls.csv --against grains.csv -o grains.csv", "is read"),
    ("grains.csv --exclude pairs.csv -o pairs.csv", "is read"),
    ("grains.csv --against grains.csv --against grains.csv", "--against"),
    ("balls.csv --against grains.csv --box 1,1", "balls.csv has 3 dimensions"),
    ("wide.dump --against narrow.dump",
     "wide.dump is periodic along (9, 0, 0) and narrow.dump is periodic along (8, 0, 0)"),
    ("wide.dump --against wall.dump", "wall.dump is open"),
    ("balls.csv --against wall.dump --ids -o x.csv", "balls.csv: the file gives"),
    ("grains.csv --deny 1,2", "--groups"),
    ("grains.csv --groups mol --deny 1", "--deny 1"),
    ("grains.csv --groups mol --deny 1,2,3", "--deny 1,2,3"),
    ("grains.csv --groups mol --deny 1,", "--deny 1,"),
    ("grains.csv --groups mol --deny 1,-2", "--deny 1,-2"),
    ("grains.csv --groups mol --deny 1,4294967296", "--deny 1,4294967296"),
    ("grains.csv --groups mol --deny 1,two", "--deny 1,two"),
    ("grains.csv --groups ''", "--groups"),
    ("grains.csv --exclude ''", "--exclude"),
])
def test_wrong_usage(fails, folder, arguments, told):
    (folder / "balls.csv").write_text("x,y,z,radius\n0,0,0,1\n")
    (folder / "boxes.csv").write_text("xmin,ymin,xmax,ymax\n0,0,1,1\n")
    dump = ("ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp ff ff\n0 9\n0 1\n"
            "0 1\nITEM: ATOMS id x y z radius\n1 0 0 0 1\n")
    (folder / "wide.dump").write_text(dump)
    (folder / "narrow.dump").write_text(dump.replace("0 9", "0 8"))
    (folder / "wall.dump").write_text(dump.replace("pp", "ff"))
    words = ["" if word == "''" else word for word in arguments.split()]
    before = sorted(path.name for path in folder.iterdir())
    assert told in fails(2, "contacts", *words, cwd=folder)
    assert sorted(path.name for path in folder.iterdir()) == before


def test_boxes_of_two_files(abut, folder):
    """The box of either file holds for both; options win."""
    dump = ("ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp ff ff\n0 9\n0 1\n"
            "0 1\nITEM: ATOMS id x y radius\n1 -5 0 0\n")
    (folder / "probe.dump").write_text(dump)
    (folder / "narrow.dump").write_text(dump.replace("0 9", "0 8"))
    first = "contacts probe.dump --against grains.csv -q -o -"
    second = "contacts grains.csv --against probe.dump -q -o -"
    assert run(abut, folder, first).stdout == "i,j,nx,ny,nz,gap\n0,2,-1,0,0,-1\n"
    assert run(abut, folder, second).stdout == "i,j,nx,ny,nz,gap\n2,0,1,0,0,-1\n"
    for more, count in (("--periodic none", 1), ("--box 1,inf", 55), ("--periodic x", None)):
        done = abut("contacts", "probe.dump", "--against", "narrow.dump", *more.split(),
                    "--count", "--margin", "27.5", cwd=folder)
        assert (done.stdout, done.returncode) == ((f"{count}\n", 0) if count else ("", 2))


def test_frames_of_two_files(abut, folder, fails):
    """A file of one frame is against every frame of the other."""
    frames = "".join(f"1\nframe\nX {x} 0 0 0.5\n" for x in (0, 3, 7))
    (folder / "moving.xyz").write_text(frames)
    (folder / "wall.csv").write_text("x,y,z,radius\n3.5,0,0,0.25\n")
    for files in ("moving.xyz --against wall.csv", "wall.csv --against moving.xyz"):
        counts = [run(abut, folder, f"contacts {files} --count --frame {k}").stdout
                  for k in (0, 1, 2, -2)]
        assert counts == ["0\n", "1\n", "0\n", "1\n"]
        assert "there is no frame 3" in fails(3, "contacts", *files.split(), "--frame", "3",
                                              cwd=folder)


def test_neighbors_of_two_files(abut, folder, fails):
    command = "neighbors probes.csv --against grains.csv --cutoff 1"
    assert run(abut, folder, command + " -q -o -").stdout == (
        "i,j,distance\n0,1,1\n0,2,1\n1,0,0.70710678118654757\n")
    text = run(abut, folder, command).stdout
    assert text.startswith("probes.csv: 3 discs, cutoff 1\nagainst grains.csv: 4 discs\n")
    assert "3 in a list of 3 pairs" in text and "1 of 3 have none" in text
    periodic = run(abut, folder, command + " --box 11,inf -q -o -").stdout
    assert periodic == ("i,j,nx,ny,nz,distance\n0,1,0,0,0,1\n0,2,0,0,0,1\n"
                        "1,0,0,0,0,0.70710678118654757\n2,1,-1,0,0,1\n2,2,-1,0,0,1\n")
    for kind in ("--full", "--half"):
        assert "--against" in fails(2, *command.split(), kind, cwd=folder)
    (folder / "balls.csv").write_text("x,y,z\n0,0,0\n")
    assert "dimensions" in fails(2, "neighbors", "probes.csv", "--against", "balls.csv",
                                 "--cutoff", "1", cwd=folder)


@pytest.mark.parametrize("arguments, pairs", [
    ("", [(0, 1), (1, 2)]),
    ("--groups mol", [(1, 2)]),
    ("--groups id", [(0, 1), (1, 2)]),
    ("--groups mol --deny 5,6", [(0, 1)]),
    ("--groups mol --deny 6,5", [(0, 1)]),
    ("--groups mol --deny 5,5 --deny 6,5", []),
    ("--groups mol --deny 8,4294967295", [(0, 1), (1, 2)]),
    ("--exclude pairs.csv", [(1, 2)]),
    ("--groups mol --exclude pairs.csv --deny 7,7", [(1, 2)]),
    ("--groups mol --deny 5,6 --exclude pairs.csv", []),
])
def test_rules(abut, folder, arguments, pairs):
    for command, flags in (("contacts", "-q -o -"), ("neighbors", "--cutoff 2 -q -o -")):
        done = run(abut, folder, f"{command} grains.csv {arguments} {flags}")
        assert pairs_of_csv(done.stdout) == pairs
    counted = run(abut, folder, f"contacts grains.csv {arguments} --count").stdout
    assert counted == f"{len(pairs)}\n"
    bench = json.loads(run(
        abut, folder, f"bench grains.csv {arguments} --json --repetitions 1 --threads 1").stdout)
    assert bench["equal"] is True
    assert {row["contact_pairs"] for row in bench["runs"]} == {len(pairs)}


def test_rules_of_two_files(abut, folder):
    """Groups of both files; i and j of excluded pairs each in its file."""
    (folder / "more.csv").write_text("mol,x,y,radius\n5,0,1,0\n6,4,1,0\n")
    command = "contacts grains.csv --against more.csv -q -o -"
    assert pairs_of_csv(run(abut, folder, command).stdout) == [(0, 0), (2, 1)]
    assert pairs_of_csv(run(abut, folder, command + " --groups mol").stdout) == []
    assert pairs_of_csv(run(abut, folder, command + " --groups mol --deny 5,5").stdout) == [(2, 1)]
    (folder / "pairs.csv").write_text("i,j\n2,1\n")
    assert pairs_of_csv(run(abut, folder, command + " --exclude pairs.csv").stdout) == [(0, 0)]


def test_summary_of_rules(abut, folder, golden):
    (folder / "pairs.csv").rename(folder / "no.csv")
    text = run(abut, folder, "contacts grains.csv --groups mol --deny 5,5 --exclude no.csv").stdout
    golden("summary_rules", without_measurements(text))
    command = re.search(r"next +abut (.*) -o contacts.vtp", text).group(1)
    assert run(abut, folder, command + " --count").stdout == "1\n", "the command that is proposed"
    text = run(abut, folder, "contacts grains.csv --groups mol").stdout
    assert "left out         pairs of one mol\n" in text
    text = run(abut, folder, "neighbors grains.csv --cutoff 2 --exclude no.csv").stdout
    assert "left out         2 pairs of no.csv\n" in text
    done = run(abut, folder, "contacts grains.csv --groups mol --deny 5,99 --deny 98,98 --count")
    assert done.stderr == "abut: --deny: no element is of mol 98 and 99\n"


def test_own_images_can_be_excluded(abut, folder):
    command = "contacts grains.csv --box 2,inf -q -o -"
    own = [(i, i) for i in range(4)]
    assert [p for p in pairs_of_csv(run(abut, folder, command).stdout) if p[0] == p[1]] == own
    left = pairs_of_csv(run(abut, folder, command + " --exclude pairs.csv").stdout)
    assert [p for p in left if p[0] == p[1]] == [(0, 0), (1, 1), (3, 3)]


@pytest.mark.parametrize("arguments, told", [
    ("grains.csv --groups molecule", ["grains.csv, line 1", "'molecule'", "'mol'"]),
    ("grains.csv --groups x", ["'0.5'"]),
    ("grains.csv --against probes.csv --radius 0 --groups mol", ["probes.csv, line 1", "'mol'"]),
    ("grains.csv --exclude nowhere.csv", ["nowhere.csv"]),
    ("grains.csv --exclude grains.csv", ["grains.csv, line 1", "column i is missing"]),
    ("grains.csv --exclude beyond.csv", ["beyond.csv, line 3", "'4'", "there are 4"]),
    ("probes.csv --radius 0 --against grains.csv --exclude beyond.csv", ["line 3", "'4'"]),
    ("grains.csv --exclude negative.csv", ["negative.csv, line 2", "'-1'"]),
])
def test_malformed_rules(fails, folder, arguments, told):
    (folder / "beyond.csv").write_text("i,j\n0,1\n0,4\n")
    (folder / "negative.csv").write_text("i,j\n-1,0\n")
    (folder / "grains.csv").write_text(GRAINS.replace("11,2,0", "11,0.5,0"))
    sentence = fails(3, "contacts", *arguments.split(), "-o", "out.csv", cwd=folder)
    assert all(word in sentence for word in told), sentence
    assert not (folder / "out.csv").exists()


def test_scenes_have_no_columns(abut, folder, fails):
    assert "--groups mol" in fails(2, "bench", "gas", "--count", "50", "--groups", "mol")
    (folder / "pairs.csv").write_text("i,j\n0,1\n")
    done = run(abut, folder, "bench gas --count 500 --exclude pairs.csv --repetitions 1")
    assert "(left out: 1 pair of pairs.csv)" in done.stdout


def test_what_another_program_found_can_be_taken_away(abut):
    done = abut("contacts", "yade_settled_5000.csv", "--exclude",
                "yade_settled_5000.yade_contacts.csv", "--count", cwd=DATA)
    assert (done.returncode, done.stdout) == (0, "0\n")


def test_types_of_a_dump(abut):
    everybody = abut("contacts", "lammps_pour.dump", "-q", "-o", "-", cwd=DATA).stdout
    text = (DATA / "lammps_pour.dump").read_text()
    lines = text[text.rindex("ITEM: ATOMS"):].splitlines()
    column = lines[0].split().index("c_c") - 2
    touched = [int(line.split()[column]) for line in lines[1:]]
    kept = [line for line in everybody.splitlines()[1:]
            if touched[int(line.split(",")[0])] != touched[int(line.split(",")[1])]]
    done = abut("contacts", "lammps_pour.dump", "--groups", "c_c", "-q", "-o", "-", cwd=DATA)
    assert done.stdout.splitlines()[1:] == kept and 0 < len(kept) < 4401


def test_info_names_what_can_be_groups(abut, folder):
    assert "groups    can be mol\n" in abut("info", "grains.csv", cwd=folder).stdout
    found = json.loads(abut("info", "lammps_pour.dump", "--json", cwd=DATA).stdout)
    assert found["group_columns"] == ["type", "c_c"]

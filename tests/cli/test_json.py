"""What programs read."""

import json

from conftest import ALGORITHMS, DATA, DISCS

YADE = DATA / "yade_settled_5000.csv"


def test_contacts(abut):
    found = json.loads(abut("contacts", YADE, "--json", "--algorithm", "sorting_array").stdout)
    assert list(found) == ["elements", "dimensions", "contact_pairs", "algorithm", "threads",
                           "seconds", "peak_bytes", "candidate_tests"]
    assert list(found["seconds"]) == ["read", "search", "write", "total"]
    assert (found["elements"], found["dimensions"], found["contact_pairs"]) == (5000, 3, 10658)
    assert (found["algorithm"], found["threads"]) == ("sorting_array", 1)
    assert found["candidate_tests"] >= 10658 and found["peak_bytes"] >= 5000 * 4
    seconds = found["seconds"]
    assert seconds["write"] == 0 and seconds["total"] == seconds["read"] + seconds["search"]


def test_direct_check_tests_every_pair(abut):
    found = json.loads(abut("contacts", YADE, "--json", "--algorithm", "direct_check").stdout)
    assert found["candidate_tests"] == 5000 * 4999 // 2


def test_file_of_contacts(abut, tmp_path):
    out = tmp_path / "contacts.json"
    assert abut("contacts", "-", "-o", out, stdin=DISCS).returncode == 0
    found = json.loads(out.read_text())
    assert found["pairs"] == [[0, 1, 0.0], [2, 3, -0.5]]


def test_hostile_file_name(abut, tmp_path):
    name = 'a "quoted" \\ \n\x01 \udcff name.csv'
    path = str(tmp_path / name)
    with open(path, "w") as file:
        file.write(DISCS)
    found = json.loads(abut("info", path, "--json").stdout)
    assert found["file"] == path.replace("\udcff", "\ufffd")
    assert (found["elements"], found["dimensions"], found["format"]) == (4, 2, "csv")
    assert found["center"] == {"min": [0, 0], "max": [5, 1.5]}
    assert found["radius"] == {"min": 1, "mean": 1, "max": 1}


def test_empty_file_info(abut):
    found = json.loads(abut("info", "-", "--json", stdin="x,y,z,radius\n").stdout)
    assert found["elements"] == 0 and found["radius"] is None


def test_lists(abut):
    rows = json.loads(abut("algorithms", "--json").stdout)["algorithms"]
    assert [row["name"] for row in rows] == ALGORITHMS
    assert len(json.loads(abut("generate", "--list", "--json").stdout)["scenes"]) >= 10


def test_compare(abut):
    found = json.loads(abut("compare", "gas", "--count", "500", "--json").stdout)
    assert found["equal"] is True and found["elements"] == 500
    assert [run["algorithm"] for run in found["runs"]] == ALGORITHMS
    assert len({run["digest"] for run in found["runs"]}) == 1

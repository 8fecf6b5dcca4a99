"""What programs read."""

import json

from conftest import ALGORITHMS, DATA, DISCS

YADE = DATA / "yade_settled_5000.csv"


def test_contacts(abut):
    found = json.loads(abut("contacts", YADE, "--json", "--algorithm", "sorting_array").stdout)
    assert list(found) == ["elements", "dimensions", "contact_pairs", "algorithm", "threads",
                           "device", "seconds", "peak_bytes", "candidate_tests"]
    assert list(found["seconds"]) == ["read", "search", "write", "total"]
    assert (found["elements"], found["dimensions"], found["contact_pairs"]) == (5000, 3, 10658)
    assert (found["algorithm"], found["threads"]) == ("sorting_array", 1)
    assert found["candidate_tests"] >= 10658 and found["peak_bytes"] >= 5000 * 4
    seconds = found["seconds"]
    assert seconds["write"] == 0 and seconds["total"] >= seconds["read"] + seconds["search"]


def test_direct_check_tests_every_pair(abut):
    found = json.loads(abut("contacts", YADE, "--json", "--algorithm", "direct_check").stdout)
    assert found["candidate_tests"] == 5000 * 4999 // 2


def test_file_of_contacts(abut, tmp_path):
    out = tmp_path / "contacts.json"
    assert abut("contacts", "-", "-o", out, stdin=DISCS).returncode == 0
    found = json.loads(out.read_text())
    assert found["pairs"] == [[0, 1, 0.0], [2, 3, -0.5]]


def test_hostile_file_name(abut, tmp_path):
    name = 'a "quoted" \\ \n\x01 \udcff \U000e0001 name.csv'
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


def bench(abut, *arguments, stdin=b""):
    return json.loads(abut("bench", *arguments, "--json", stdin=stdin).stdout)


def test_bench(abut):
    found = bench(abut, YADE, "--algorithms", "munjiza_nbs,rows", "--threads", "2,1,2",
                  "--repetitions", "2")
    assert list(found) == ["input", "elements", "dimensions", "build", "equal", "runs"]
    assert found["equal"] is True and (found["elements"], found["dimensions"]) == (5000, 3)
    assert found["build"].startswith("abut ")
    ran = [run for run in found["runs"] if "not_run" not in run]
    lists = [run for run in ran if run["result"] in ("canonical", "as_found")]
    assert [(run["algorithm"], run["threads"], run["result"]) for run in lists] == [
        ("munjiza_nbs", 1, "canonical"), ("munjiza_nbs", 1, "as_found"),
        ("rows", 2, "canonical"), ("rows", 2, "as_found"),
        ("rows", 1, "canonical"), ("rows", 1, "as_found")]
    assert [run["result"] for run in ran[len(lists):]] == ["count", "half list", "full list"]
    best = min(lists[::2], key=lambda run: run["ns_per_element"]["median"])
    for run in ran:
        time = run["ns_per_element"]
        assert list(time) == ["first", "median", "minimum"]
        assert time["first"] > 0 and time["median"] >= time["minimum"] > 0
        assert run["repetitions"] == 2 and run["contact_pairs"] == 10658
        assert run["candidate_tests_per_element"] >= 10658 / 5000
        assert run["peak_bytes_per_element"] >= 32
    assert {(run["algorithm"], run["threads"]) for run in ran[len(lists):]} == {
        (best["algorithm"], best["threads"])}
    digests = {run["digest"] for run in ran if run["result"] != "count"}
    assert len(digests) == 1 and ran[len(lists)]["digest"] is None
    assert [(run["algorithm"], run["threads_asked"], run["not_run"])
            for run in found["runs"] if "not_run" in run] == [
        ("munjiza_nbs", 1, "uses 1 thread here"), ("munjiza_nbs", 2, "uses 1 thread here"),
        ("rows", 2, "uses 2 threads here")]


def test_bench_chooses(abut):
    """Rows always; the others as far as they are fast and fit; names what is left out, and why."""
    found = bench(abut, "sparse", "--count", "60000", "--repetitions", "1")
    reasons = {run["algorithm"]: run["not_run"] for run in found["runs"] if "not_run" in run}
    assert reasons["direct_check"] == "takes longer than 0.5 s; ask for it with --algorithms"
    assert reasons["screening_array"].startswith("screening_array would need ")
    assert "rows" not in reasons and found["equal"] is True
    assert {run["algorithm"] for run in found["runs"]} == set(ALGORITHMS)


def test_bench_chooses_how_often(abut):
    runs = bench(abut, "-", "--algorithms", "direct_check", stdin=DISCS)["runs"]
    assert all(3 <= run["repetitions"] <= 1001 for run in runs)


def test_bench_of_nothing(abut):
    found = bench(abut, "-", "--repetitions", "1", stdin="x,y,z,radius\n")
    assert found["elements"] == 0 and found["equal"] is True
    for run in found["runs"]:
        assert run["contact_pairs"] == 0 and run["ns_per_element"]["first"] is None


def test_compare(abut):
    found = json.loads(abut("compare", "gas", "--count", "500", "--json").stdout)
    assert found["equal"] is True and found["elements"] == 500
    assert [run["algorithm"] for run in found["runs"]] == ALGORITHMS
    assert len({run["digest"] for run in found["runs"]}) == 1


def test_compare_says_why_an_algorithm_did_not_run(abut):
    """Two discs a billion cells apart, of which arrays of all cells would have to know."""
    found = json.loads(abut("compare", "-", "--json", stdin="x,y,radius\n0,0,1\n0,2e9,1\n").stdout)
    refused = {run["algorithm"]: run["not_run"] for run in found["runs"] if "not_run" in run}
    assert set(refused) == {"screening_array", "munjiza_nbs"} and found["equal"] is True
    for name, sentence in refused.items():
        assert sentence.startswith(f"{name} would need ") and "memory bound" in sentence

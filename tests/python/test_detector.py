"""A detector gives what the functions give, and never writes over arrays that were handed out."""

import threading

import numpy as np
import pytest
from conftest import tuples

import abut


def steps(count=12, size=400):
    """Positions that move a little in each step."""
    random = np.random.default_rng(3)
    x, v = random.random((size, 3)), 0.002 * random.standard_normal((size, 3))
    return [x + k * v for k in range(count)]


@pytest.mark.parametrize("skin", [None, 0.02, "auto"])
def test_results_are_those_of_the_functions(skin):
    detector = abut.Detector(skin=skin, margin=0.01)
    for x in steps():
        c = detector.contacts(x, 0.04)
        assert tuples(c.pairs) == tuples(abut.contacts(x, 0.04, margin=0.01).pairs)
        assert detector.count_contact_pairs(c.elements).contact_pairs == len(c)
        n = detector.build_neighbor_list(c.elements, kind="full")
        assert n.neighbors.tolist() == (
            abut.build_neighbor_list(c.elements, kind="full", margin=0.01).neighbors.tolist()
        )
    assert detector.skin == skin
    assert (detector.skin_statistics.reuses > 0) == (skin == 0.02) or skin == "auto"


@pytest.mark.parametrize("kept", ["contacts", "pairs", "i"])
def test_what_is_kept_stays_as_it_is(kept):
    detector = abut.Detector(threads=1)
    results = []
    for x in steps():
        c = detector.contacts(x, 0.04)
        results.append((c if kept == "contacts" else getattr(c, kept), tuples(c.pairs)))
        del c
    for result, expected in results:
        if kept == "i":
            assert result.tolist() == [i for i, _ in expected]
        else:
            assert tuples(result.pairs if kept == "contacts" else result) == expected


def test_kept_neighbor_lists_stay_as_they_are():
    detector = abut.Detector()
    elements = [abut.spheres(x, 0.04) for x in steps()]
    lists = [detector.build_neighbor_list(e, kind="full") for e in elements]
    for built, e in zip(lists, elements, strict=True):
        assert built.neighbors.tolist() == (
            abut.build_neighbor_list(e, kind="full").neighbors.tolist()
        )


def test_memory_serves_again_where_nothing_was_kept():
    detector = abut.Detector(threads=1)
    x = steps(1)[0]
    addresses = {detector.contacts(x, 0.04).pairs.ctypes.data for _ in range(20)}
    assert len(addresses) == 1
    kept = [detector.contacts(x, 0.04).pairs for _ in range(20)]
    assert len({array.ctypes.data for array in kept}) == 20


def test_ids_let_candidates_last_while_elements_change_places():
    detector = abut.Detector(skin=0.05)
    x = steps(1)[0]
    ids = np.arange(len(x))
    for turn in range(5):
        detector.set_ids(np.roll(ids, turn))
        moved = np.roll(x, turn, axis=0)
        c = detector.contacts(moved, 0.04)
        assert tuples(c.pairs) == tuples(abut.contacts(moved, 0.04).pairs)
    assert detector.skin_statistics.carried == 4
    with pytest.raises(ValueError, match="both have the id 1"):
        detector.set_ids([1, 1])
    with pytest.raises(ValueError):
        detector.contacts(x[:-1], 0.04)
    detector.set_ids(None)
    assert len(detector.contacts(x[:-1], 0.04)) > 0


def test_options_of_a_call_precede_those_of_the_detector():
    detector = abut.Detector(margin=0.5)
    x = [[0, 0], [2, 0]]
    assert len(detector.contacts(x, 0.5)) == 0
    assert len(detector.contacts(x, 0.5, margin=1)) == 1
    assert len(detector.contacts(x, 0.5, domain=abut.Domain.periodic((3, 3)))) == 1
    assert len(detector.find_contact_pairs(abut.points(x), abut.discs(x, 2))) == 4


def test_one_call_at_a_time():
    detector = abut.Detector()
    x = steps(1)[0]

    def again(*_):
        detector.contacts(x, 0.04)

    with pytest.raises(abut.UsageError, match="one call at a time"):
        detector.contacts(x, 0.04, progress=again)
    assert len(detector.contacts(x, 0.04)) > 0
    found = []
    threads = [
        threading.Thread(target=lambda: found.append(len(abut.Detector().contacts(x, 0.04))))
        for _ in range(4)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(set(found)) == 1


def test_a_detector_works_after_errors():
    detector = abut.Detector(skin=0.01)
    x = steps(1)[0]
    expected = tuples(detector.contacts(x, 0.04).pairs)
    for options in ({"max_pairs": 1}, {"progress": lambda *_: False}, {"margin": -1}):
        with pytest.raises(abut.Error):
            detector.contacts(x, 0.04, **options)
        assert tuples(detector.contacts(x, 0.04).pairs) == expected
    for skin in (-1.0, float("nan")):
        with pytest.raises(ValueError):
            detector.skin = skin
    for skin in ("thick", [1]):
        with pytest.raises(TypeError):
            detector.skin = skin
    assert detector.skin == 0.01


def test_arrays_outlive_the_detector():
    x = np.random.default_rng(7).random((500, 3))
    expected = abut.contacts(x, 0.05).pairs.copy()
    assert len(expected) > 50
    found = abut.Detector().contacts(x, 0.05).pairs
    again = [np.full_like(expected, 9) for _ in range(20)]  # takes memory that was given back
    assert np.array_equal(found, expected)
    assert len(again) == 20

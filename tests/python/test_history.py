"""Values follow their contacts."""

import numpy as np
import pytest

import abut


def test_values_follow_contacts_by_ids():
    random = np.random.default_rng(5)
    x, v = random.random((300, 3)), 0.004 * random.standard_normal((300, 3))
    ids = np.arange(300) * 7
    history = abut.ContactHistory([("age", np.int64), ("name", np.uint64, 2)])
    expected = {}
    for step in range(8):
        order = random.permutation(300)[: 300 - step]
        c = abut.contacts((x + step * v)[order], 0.05)
        history.update(c, ids[order])
        names = np.sort(ids[order][c.pairs], axis=1)
        now = {tuple(name): expected.get(tuple(name), 0) for name in names.tolist()}
        assert history.values["age"].tolist() == list(now.values())
        assert history.kept == sum(name in expected for name in now)
        assert history.born.tolist() == [k for k, name in enumerate(now) if name not in expected]
        lost = {tuple(sorted((int(a), int(b)))) for a, b, _ in history.lost}
        assert lost == set(expected) - set(now)
        ages = dict(zip(lost, [], strict=False)) | {
            tuple(sorted((int(a), int(b)))): int(value["age"]) for a, b, value in history.lost
        }
        assert ages == {name: expected[name] for name in lost}
        history.values["age"] += 1
        history.values["name"] = names
        expected = {name: age + 1 for name, age in now.items()}
    assert len(history) == len(c)
    history.clear()
    assert len(history) == 0


@pytest.mark.parametrize("threads", [1, 2, 7])
def test_any_number_of_threads_gives_the_same(threads):
    random = np.random.default_rng(11)
    x = random.random((900, 2))
    one, several = abut.ContactHistory(threads=1), abut.ContactHistory(threads=threads)
    for _ in range(5):
        c = abut.contacts(x, 0.03)
        for history in (one, several):
            history.update(c)
            history.values[history.born] = history.born + 1
        assert several.values.tolist() == one.values.tolist()
        assert several.born.tolist() == one.born.tolist()
        assert several.lost.tolist() == one.lost.tolist()
        x += 0.004 * random.standard_normal(x.shape)
    assert 0 < one.kept < len(one)


def test_threads_are_a_number():
    with pytest.raises(ValueError, match="threads"):
        abut.ContactHistory(threads=-1)
    with pytest.raises(TypeError, match="threads"):
        abut.ContactHistory(threads="many")


def test_plain_numbers_and_periodic_cells():
    cell = abut.Domain.periodic((10, 10))
    history = abut.ContactHistory()
    for place in (9.4, 9.9, 0.4):  # wrapped into the cell in the last step
        history.update(abut.contacts([[place, 5], [0.5, 5]], 1.0, domain=cell))
        history.values += 1.5
    assert history.values.tolist() == [4.5]
    assert history.kept == 1


def test_flipped_contacts():
    history = abut.ContactHistory(np.float32)
    x = np.array([[0.0, 0.0], [1.0, 0.0]])
    history.update(abut.contacts(x, 0.5), ids=[7, 8])
    assert history.flipped.tolist() == []
    history.update(abut.contacts(x[::-1], 0.5), ids=[8, 7])
    assert history.flipped.tolist() == [0]


def test_wrong_updates_change_nothing():
    c = abut.contacts([[0, 0], [1, 0], [0, 1]], 0.5)
    history = abut.ContactHistory(int)
    history.update(c)
    history.values[:] = [3, 4]
    found = abut.contacts([[0, 0], [1, 0], [0, 1]], 0.5, order="as_found", algorithm="munjiza_nbs")
    two = abut.find_contact_pairs(abut.discs([[0, 0]], 1), abut.discs([[0, 0]], 1))
    for wrong, ids in ((c, [1, 1, 2]), (c, [1, 2]), (two, None)):
        with pytest.raises(ValueError):
            history.update(wrong, ids)
        assert history.values.tolist() == [3, 4]
    with pytest.raises(TypeError):
        history.update(c.pairs)
    with pytest.raises(ValueError):
        history.values = [1, 2, 3]
    assert len(found) == 2
    for dtype in (object, "S0"):
        with pytest.raises(TypeError):
            abut.ContactHistory(dtype)

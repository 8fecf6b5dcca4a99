"""Values follow contacts with walls."""

import numpy as np
import pytest

import abut

FLOOR = ([[0, 0, 0], [4, 0, 0], [0, 4, 0], [4, 4, 0]], [[0, 1, 2], [1, 2, 3]])
CELL = abut.Domain.periodic((4, 4, None))


def test_values_follow_spheres_by_ids():
    random = np.random.default_rng(5)
    lower = random.random((30, 3))
    boxes = abut.boxes(lower, lower + 0.15)
    x, v = random.random((300, 3)), 0.004 * random.standard_normal((300, 3))
    ids = np.arange(300) * 7
    history = abut.BoxContactHistory([("age", np.int64), ("name", np.uint64, 2)])
    expected = {}
    for step in range(8):
        order = random.permutation(300)[: 300 - step]
        c = abut.find_box_contacts(abut.spheres((x + step * v)[order], 0.05), boxes)
        history.update(c, ids[order])
        names = [*zip(ids[order][c.sphere].tolist(), c.box.tolist(), strict=True)]
        now = {name: expected.get(name, 0) for name in names}
        assert len(now) > 30
        assert history.values["age"].tolist() == list(now.values())
        assert history.kept == sum(name in expected for name in now)
        assert history.born.tolist() == [k for k, name in enumerate(now) if name not in expected]
        lost = {(int(s), int(b)): int(value["age"]) for s, b, value in history.lost}
        assert lost == {name: age for name, age in expected.items() if name not in now}
        assert all(tuple(value["name"].tolist()) == (s, b) for s, b, value in history.lost)
        history.values["age"] += 1
        history.values["name"] = names
        expected = {name: age + 1 for name, age in now.items()}
    assert len(history) == len(c)
    history.clear()
    assert len(history) == len(history.lost) == 0


def roll(history, places, **options):
    """Lets a sphere stand at one place after the other."""
    mesh = options.pop("mesh", None) or abut.TriangleMesh(*FLOOR)
    for x in places:
        c = abut.find_mesh_contacts(abut.spheres([x], 0.5), mesh, **options)
        history.update(c)
        history.values += 1


def test_values_are_passed_on_along_a_floor():
    history = abut.MeshContactHistory(int)
    roll(history, [[1, 1, 0.5], [1.5, 1.5, 0.5]])
    assert history.passed_on.tolist() == []
    roll(history, [[2, 2, 0.5]])
    assert history.passed_on.tolist() == [0]
    assert (history.kept, history.born.tolist(), len(history.lost)) == (1, [], 0)
    roll(history, [[2.5, 2.5, 0.5]])
    assert history.values.tolist() == [4]
    roll(history, [[2.5, 2.5, 5]])
    assert history.lost.dtype.names == ("sphere", "kind", "number", "value")
    assert history.lost.tolist() == [(0, abut.FeatureKind.face, 1, 4)]
    assert repr(history) == "<abut.MeshContactHistory: 0 contacts, 0 kept, 0 new, 1 lost>"


def test_periodic_floors():
    floor = abut.TriangleMesh.joined(*FLOOR, CELL)
    history = abut.MeshContactHistory()
    roll(history, [[3.5, 2, 0.4], [3.9, 2, 0.4], [0.3, 2, 0.4]], mesh=floor, domain=CELL)
    assert history.values.tolist() == [3.0]
    boxes = abut.boxes([[0, 0, -1]], [[4, 4, 0]])
    history = abut.BoxContactHistory(int)
    for x in (3.0, 3.25, -0.75):
        history.update(abut.find_box_contacts(abut.spheres([[x, 2, 0.4]], 0.5), boxes, domain=CELL))
        history.values += 1
    assert history.values.tolist() == [3]
    without = abut.find_mesh_contacts(abut.spheres([[1, 2, 0.4]], 0.5), floor, domain=CELL,
                                      shifts=False)
    with pytest.raises(abut.UsageError, match="shifts=True"):
        abut.MeshContactHistory().update(without)


def test_a_history_of_some_contacts():
    spheres = abut.spheres([[1, 1, 0.25], [1, 2, 0.5], [2.5, 2.5, -0.5]], 0.5)
    c = abut.find_mesh_contacts(spheres, abut.TriangleMesh(*FLOOR))
    history = abut.MeshContactHistory(int)
    history.update(c)
    history.values[:] = [3, 4, 5]
    history.update(c, which=c.gap == 0)
    assert history.values.tolist() == [4, 5]
    assert history.lost["sphere"].tolist() == [0]
    history.update(c, which=[2])
    assert history.values.tolist() == [5]
    history.update(c, which=[])
    assert len(history) == 0
    for wrong in ([[0]], [0.5], "1"):
        with pytest.raises(abut.InputTypeError):
            history.update(c, which=wrong)
    with pytest.raises(IndexError):
        history.update(c, which=[3])
    with pytest.raises(abut.UsageError):
        history.update(c, which=[1, 0])


def test_wrong_updates_change_nothing():
    spheres = abut.spheres([[1, 1, 0.25], [2.5, 2.5, 0.5]], 0.5)
    c = abut.find_mesh_contacts(spheres, abut.TriangleMesh(*FLOOR))
    boxes = abut.boxes([[0, 0, -1]], [[4, 4, 0]])
    on_boxes = abut.find_box_contacts(spheres, boxes)
    other = abut.find_mesh_contacts(spheres, abut.TriangleMesh(FLOOR[0], [[0, 1, 2]]))
    history, of_boxes = abut.MeshContactHistory(int), abut.BoxContactHistory(int)
    history.update(c)
    of_boxes.update(on_boxes)
    history.values[:] = of_boxes.values[:] = [3, 4]
    for wrong, ids, error in (
        (c, [1, 1], abut.InputError),
        (c, [1], abut.InputError),
        (c, [0.5, 1.5], abut.InputTypeError),
        (other, None, abut.UsageError),
        (on_boxes, None, abut.InputTypeError),
        (c.records, None, abut.InputTypeError),
    ):
        with pytest.raises(error):
            history.update(wrong, ids)
        assert history.values.tolist() == [3, 4]
        assert history.kept == 0
    for wrong, ids in ((c, None), (on_boxes, [1, 1])):
        with pytest.raises(abut.Error):
            of_boxes.update(wrong, ids)
        assert of_boxes.values.tolist() == [3, 4]
    with pytest.raises(abut.InputError):
        history.values = [1, 2, 3]
    history.clear()
    history.update(other)
    with pytest.raises(abut.InputTypeError):
        abut.MeshContactHistory(object)

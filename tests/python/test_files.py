"""Files that are read and written are those of the tool."""

import json

import numpy as np
import pytest
from conftest import SOURCES, tuples

import abut


def test_the_packing_is_read(packing_file, packing):
    told = []
    s = abut.read(packing_file, progress=lambda *now: told.append(now))
    assert (s.format, s.frame, s.frame_count, len(s.elements)) == ("csv", 0, 1, 5000)
    assert s.domain == abut.Domain.open()
    assert s.ids is None
    assert len(abut.find_contact_pairs(s.elements)) == 10658
    assert np.array_equal(s.elements._first[0], packing["x"])
    assert told[0][0] == "read"


def test_elements_are_written_and_read_back(tmp_path):
    x = np.random.default_rng(1).random((20, 3)).astype(np.float32)
    for name in ("e.csv", "e.xyz", "e.lammpstrj"):
        abut.write(tmp_path / name, abut.spheres(x, 0.1))
        again = abut.read(tmp_path / name).elements
        assert np.array_equal(np.transpose(again._first), x.astype(np.float64)), name
    abut.write(tmp_path / "d.csv", abut.discs(x[::2, :2], 0.1))
    assert abut.read(tmp_path / "d.csv").elements.shape == "disc"


def test_boxes_domains_groups_and_frames(tmp_path):
    (tmp_path / "b.csv").write_text("xmin,ymin,xmax,ymax,part\n0,0,1,1,3\n1,1,2,2,4\n")
    s = abut.read(str(tmp_path / "b.csv"), groups="part")
    assert s.elements.shape == "rectangle"
    assert s.groups.tolist() == [3, 4]
    assert len(abut.find_contact_pairs(s.elements)) == 1
    frame = '1\nLattice="4 0 0 0 5 0 0 0 6" pbc="T F T" Properties=species:S:1:pos:R:3\nAr {} 0 0\n'
    (tmp_path / "t.xyz").write_text(frame.format(1) + frame.format(2))
    s = abut.read(tmp_path / "t.xyz", radius=0.5, frame=0)
    assert s.elements._first[0].tolist() == [1.0]
    assert (s.frame, s.frame_count) == (0, 2)
    assert s.domain == abut.Domain.periodic((4, None, 6))


@pytest.mark.parametrize("domain", [None, abut.Domain.periodic((1, 1, 1))])
def test_contacts_are_written(tmp_path, cloud, domain):
    c = abut.contacts(*cloud, domain=domain)
    c.write(tmp_path / "c.csv")
    table = np.genfromtxt(tmp_path / "c.csv", delimiter=",", names=True)
    assert table["i"].tolist() == c.i.tolist()
    assert table["gap"].tolist() == c.gap.tolist()
    assert ("nx" in table.dtype.names) == (domain is not None)
    c.write(tmp_path / "c.out", format="json")
    assert json.loads((tmp_path / "c.out").read_text())["contact_pairs"] == len(c)
    c.write(tmp_path / "c.vtp")
    assert (tmp_path / "c.vtp").read_bytes().startswith(b"<?xml")


def test_contacts_of_two_sets_and_boxes_are_written(tmp_path):
    c = abut.find_contact_pairs(
        abut.boxes([[0, 0, 0]], [[1, 1, 1]]), abut.boxes([[1, 0, 0]], [[2, 1, 1]])
    )
    c.write(tmp_path / "c.csv")
    assert (tmp_path / "c.csv").read_text().splitlines() == ["i,j,gap", "0,0,0"]


def test_wrong_files(tmp_path):
    with pytest.raises(FileNotFoundError):
        abut.read(tmp_path / "none.csv")
    (tmp_path / "bad.csv").write_text("x,y,radius\n0,zero,1\n")
    with pytest.raises(abut.InputError, match="line 2"):
        abut.read(tmp_path / "bad.csv")
    with pytest.raises(abut.UsageError, match="format"):
        abut.read(SOURCES / "README.md", format="markdown")
    c = abut.contacts([[0, 0], [1, 0]], 0.5)
    with pytest.raises(abut.UsageError):
        c.write(tmp_path / "c.doc")
    with pytest.raises(OSError) as caught:
        c.write(tmp_path / "none" / "c.csv")
    assert isinstance(caught.value, abut.OutputError)
    assert tuples(c.pairs) == [(0, 1)]

"""A class of progress bars is taken where a function is."""

import functools
import io

import numpy as np
import pytest
from tqdm import tqdm

import abut


class Bar(tqdm):
    """Bars that remember what became of them."""

    made: list["Bar"] = []

    def __init__(self, **options):
        super().__init__(file=io.StringIO(), **options)
        self.made.append(self)
        self.is_closed = False

    def close(self):
        super().close()
        self.is_closed = True


@pytest.mark.parametrize("progress", [Bar, functools.partial(Bar, leave=False)])
def test_bars_of_tqdm(cloud, progress):
    Bar.made.clear()
    assert len(abut.contacts(*cloud, progress=progress)) > 100
    assert Bar.made
    assert len({bar.desc for bar in Bar.made}) == len(Bar.made)
    assert all(bar.is_closed and 0 <= bar.n <= bar.total for bar in Bar.made)


def test_bars_while_a_file_is_read(packing_file):
    Bar.made.clear()
    abut.read(packing_file, progress=Bar)
    assert [bar.desc for bar in Bar.made] == ["read"]


def test_bars_are_closed_when_a_detection_fails():
    Bar.made.clear()
    with pytest.raises(MemoryError):
        abut.contacts(np.zeros((100, 2)), 1.0, max_pairs=3, progress=Bar)
    assert all(bar.is_closed for bar in Bar.made)


def test_what_is_no_progress():
    for wrong in (3, "tqdm", Bar(total=1)):
        with pytest.raises(abut.InputTypeError, match="progress is a function or a class of bars"):
            abut.contacts([[0, 0]], 1, progress=wrong)

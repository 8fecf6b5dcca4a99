"""What is taken as positions and radii, without a copy where that can be, and what is refused."""

import array
import sys

import numpy as np
import pandas
import polars
import pytest
import xarray
from conftest import tuples
from hypothesis import given
from hypothesis import strategies as st

import abut
from abut import _arrays


def views(x):
    """The same positions in many layouts."""
    wide = np.full((2 * len(x), 7), np.nan)
    wide[::2, 1::2] = x
    fields = np.zeros(len(x), dtype=[("x", "f8"), ("n", "i8"), ("y", "f8"), ("z", "f8")])
    for k, name in enumerate("xyz"):
        fields[name] = x[:, k]
    frozen = x.copy()
    frozen.flags.writeable = False
    return {
        "fortran": np.asfortranarray(x),
        "strided": wide[::2, 1::2],
        "backwards": x[::-1].copy()[::-1],
        "mirrored": x[:, ::-1].copy()[:, ::-1],
        "columns": tuple(x.T),
        "fields": fields,
        "read-only": frozen,
        "broadcast": np.broadcast_to(x, (1, *x.shape))[0],
    }


def test_layouts_are_read_where_they_are(cloud, monkeypatch):
    x, r = cloud
    expected = tuples(abut.contacts(x, r).pairs)
    for name, layout in views(x).items():
        elements = abut.spheres(layout, r)
        columns = abut._elements.positions_of(elements)
        base = layout if isinstance(layout, tuple) else (layout,)
        for k, column in enumerate(columns):
            own = layout["xyz"[k]] if name == "fields" else base[k % len(base)]
            assert np.shares_memory(column, own), name
        assert tuples(abut.find_contact_pairs(elements).pairs) == expected, name


def test_memory_maps_and_float32(tmp_path, cloud):
    x, r = cloud[0].astype(np.float32), cloud[1].astype(np.float32)
    np.save(tmp_path / "x.npy", x)
    mapped = np.load(tmp_path / "x.npy", mmap_mode="r")
    assert abut.spheres(mapped, r).precision == "float32"
    expected = abut.contacts(x.astype(np.float64), r.astype(np.float64))
    assert tuples(abut.contacts(mapped, r).pairs) == tuples(expected.pairs)
    assert abut.contacts(mapped, cloud[1]).elements.precision == "float64"


def test_unaligned_and_swapped_numbers_are_copied(cloud):
    x, r = cloud
    expected = tuples(abut.contacts(x, r).pairs)
    packed = np.zeros(len(x), dtype=[("tag", "u1"), ("p", "f8", 3)])
    packed["p"] = x
    assert not packed["p"].flags.aligned
    assert tuples(abut.contacts(packed["p"], r).pairs) == expected
    swapped = x.astype(x.dtype.newbyteorder())
    assert tuples(abut.contacts(swapped, r.astype(">f8")).pairs) == expected


class DeviceArray:
    """Speaks DLPack, and nothing else."""

    def __init__(self, array, device=1):
        self.array, self.device = array, device

    def __dlpack__(self, **how):
        return self.array.__dlpack__(**how)

    def __dlpack_device__(self):
        return (self.device, 0)


def test_dlpack(cloud):
    x, r = cloud
    elements = abut.spheres(DeviceArray(x), DeviceArray(r))
    assert np.shares_memory(elements._first, x)
    with pytest.raises(abut.InputTypeError, match="device"):
        abut.contacts(DeviceArray(x, device=2), r)


def test_tables_by_name(cloud):
    x, r = cloud
    expected = tuples(abut.contacts(x, r).pairs)
    frame = pandas.DataFrame({"id": np.arange(len(x)), "z": x[:, 2], "y": x[:, 1], "x": x[:, 0]})
    assert tuples(abut.contacts(frame, r).pairs) == expected
    assert tuples(abut.contacts(frame.assign(radius=r)).pairs) == expected
    table = {"x": x[:, 0], "y": x[:, 1], "z": x[:, 2], "r": r}
    assert tuples(abut.contacts(table).pairs) == expected
    series = (frame["x"], frame["y"], frame["z"])
    assert tuples(abut.contacts(series, r).pairs) == expected
    with pytest.raises(abut.InputError, match="no columns x and y, but a, b"):
        abut.contacts({"a": [1], "b": [2]}, 1)


def test_polars_and_xarray(cloud):
    x, r = cloud
    expected = tuples(abut.contacts(x, r).pairs)
    frame = polars.DataFrame({"x": x[:, 0], "y": x[:, 1], "z": x[:, 2], "radius": r})
    assert tuples(abut.contacts(frame).pairs) == expected
    assert np.shares_memory(abut.spheres(frame)._first[1], frame["y"].to_numpy())
    with pytest.raises(abut.InputTypeError, match=r"collect\(\)"):
        abut.contacts(frame.lazy())
    with pytest.raises(abut.InputError, match="element 2 has y = nan"):
        abut.contacts({"x": polars.Series([1, 2, 3]), "y": polars.Series([1, 2, None])}, r[:3])
    data = xarray.Dataset({name: ("sphere", x[:, k]) for k, name in enumerate("xyz")})
    for given in (data, data.set_coords(["x", "y"]), xarray.DataArray(x, dims=("sphere", "axis"))):
        assert tuples(abut.contacts(given, r).pairs) == expected
    assert np.shares_memory(abut.spheres(data, r)._first[0], data["x"].values)
    assert tuples(abut.contacts(data.assign(r=("sphere", r))).pairs) == expected


def test_columns_with_missing_numbers():
    kinds = {"x": pandas.array([1.0, None], dtype="Float64"), "y": pandas.array([0, 1])}
    with pytest.raises(abut.InputError, match="element 1 has x = nan"):
        abut.contacts(pandas.DataFrame(kinds), 1)
    column = np.ma.masked_array([1.0, 2.0], mask=[False, True])
    with pytest.raises(abut.InputError, match="positions x: 1 of 2 numbers are masked"):
        abut.contacts((column, [0, 0]), 1)
    with pytest.raises(abut.InputError, match="radii: 1 of 2 numbers are masked"):
        abut.contacts([[0, 0], [1, 0]], column)
    fields = np.ma.masked_all(2, dtype=[("x", "f8"), ("y", "f8")])
    with pytest.raises(abut.InputError, match="positions x: 2 of 2 numbers are masked"):
        abut.contacts(fields, 1)


@pytest.mark.parametrize("count", [2**32 - 1, 2**32, 2**40])
def test_more_elements_than_have_numbers_are_refused(count):
    # A view of one point, again and again: no memory.
    x = np.broadcast_to(np.zeros(3), (count, 3))
    for call in (abut.contacts, abut.neighbors):
        with pytest.raises(abut.LimitError, match=f"^{count} elements; .* at most 4294967294"):
            call(x, 0.5)


def test_other_objects_that_show_their_memory(cloud):
    x, r = cloud
    expected = tuples(abut.contacts(x, r).pairs)
    for given in (memoryview(x), tuple(array.array("d", one) for one in x.T)):
        assert tuples(abut.contacts(given, r).pairs) == expected
    records = np.rec.fromarrays([*x.T, r], names="x,y,z,radius")
    assert tuples(abut.contacts(records).pairs) == expected


def test_a_tuple_means_columns_and_a_list_points():
    assert len(abut.spheres(([0.0, 1.0], [0.0, 0.0], [0.0, 0.0]), 1)) == 2
    assert len(abut.spheres([(0.0, 1.0, 2.0), (0.0, 0.0, 0.0)], 1)) == 2


def test_whole_numbers_and_other_floats_are_exact():
    for dtype in (np.int8, np.uint16, np.int32, np.int64, np.uint64, np.float16, np.longdouble):
        x = np.array([[0, 0], [3, 4]], dtype=dtype)
        assert len(abut.contacts(x, np.array([2, 3]).astype(dtype))) == 1, dtype
    assert _arrays.numbers(np.float16([0.1]), "x") == np.float16(0.1)


@pytest.mark.parametrize(
    "value",
    [
        np.array([[2**53 + 1, 0]]),
        np.array([[2**64 - 1, 0]], dtype=np.uint64),
        np.array([[2**63 - 1, 0]], dtype=np.int64),
        np.array([[np.longdouble(1) + np.finfo(np.longdouble).eps, 0]]),
        np.array([[np.longdouble("1e400"), 0]]),
    ],
)
def test_numbers_that_no_double_equals_are_refused(value):
    with pytest.raises(abut.InputError, match="of element 0 has no float64 that equals it"):
        abut.contacts(value, 1)


@given(st.lists(st.integers(-(2**63), 2**63 - 1), min_size=1))
def test_whole_numbers_are_taken_exactly_or_not_at_all(values):
    try:
        taken = _arrays.numbers(np.array(values, dtype=np.int64), "x")
    except abut.InputError:
        assert any(int(float(value)) != value for value in values)
    else:
        assert [int(number) for number in taken] == values


WRONG = {
    "complex": (np.zeros((2, 3), complex), TypeError, "real numbers, not complex128"),
    "objects": (np.array([[None, 1], [1, 1]]), TypeError, "real numbers, not Python objects"),
    "text": ([["a", "b"]], TypeError, "real numbers, not text"),
    "truth": (np.ones((2, 2), bool), TypeError, "truth values"),
    "dates": (np.zeros((2, 2), "M8[s]"), TypeError, "datetime64"),
    "ragged": ([[1, 2], [1]], ValueError, "do not make an array"),
    "one axis": (np.zeros(4), ValueError, r"shape \(N, 2\) or \(N, 3\), .* not \(4,\)"),
    "transposed": (np.zeros((3, 5)), ValueError, "transpose"),
    "four columns": (np.zeros((5, 4)), ValueError, r"not \(5, 4\)"),
    "one column": ((np.zeros(4),), ValueError, "2 or 3 columns"),
    "columns of two axes": ((np.zeros((4, 1)),) * 3, ValueError, "one axis, not 2"),
    "unequal columns": ((np.zeros(4), np.zeros(3)), ValueError, "column y .* 3 numbers"),
    "nan": ([[0, 0], [np.nan, 0]], ValueError, "element 1"),
    "infinity": ([[0, 0], [0, -np.inf]], ValueError, "element 1"),
    "masked": (np.ma.masked_equal([[0.0, 1.0], [2.0, 3.0]], 2.0), ValueError, "1 of 4 .* masked"),
}


@pytest.mark.parametrize("name", WRONG)
def test_wrong_positions(name):
    x, kind, text = WRONG[name]
    with pytest.raises(kind, match=text) as caught:
        abut.contacts(x, 0.5)
    assert isinstance(caught.value, abut.Error)


def test_a_mask_that_masks_nothing_is_no_harm():
    x = np.ma.masked_array([[0.0, 0.0], [1.0, 0.0]], mask=False)
    assert len(abut.contacts(x, 0.5)) == 1


WRONG_RADII = {
    "negative": ([1, -1], ValueError, "element 1"),
    "too few": ([1], ValueError, "1 radii for 2 elements"),
    "two axes": ([[1, 1]], ValueError, "one axis"),
    "text": ("a", TypeError, "radii are real numbers"),
    "missing": (None, TypeError, "radii are missing"),
    "huge": (10**400, TypeError, "objects"),
    "inexact": (2**53 + 1, ValueError, "no float64"),
    "truth": (True, TypeError, "truth"),
}


@pytest.mark.parametrize("name", WRONG_RADII)
def test_wrong_radii(name):
    r, kind, text = WRONG_RADII[name]
    with pytest.raises(kind, match=text):
        abut.contacts([[0, 0], [1, 0]], r)


def test_dimensions_that_do_not_fit():
    with pytest.raises(abut.InputError, match="see discs"):
        abut.spheres([[0, 0]], 1)
    with pytest.raises(abut.InputTypeError, match="made by spheres"):
        abut.find_contact_pairs([[0, 0]])
    with pytest.raises(ValueError):
        abut.contacts([[0, 0]], 1, domain=abut.Domain.periodic((1, 1, 1)))
    with pytest.raises(abut.InputTypeError, match="Domain.periodic"):
        abut.contacts([[0, 0]], 1, domain=(1, 1))


def test_arrays_of_the_caller_are_released(cloud):
    x, r = cloud[0].copy(), cloud[1].copy()
    before = sys.getrefcount(x)
    c = abut.contacts(x, r)
    assert sys.getrefcount(x) > before
    del c
    assert sys.getrefcount(x) == before


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_arrays_of_real_numbers_are_no_whole_numbers(dtype):
    x = np.arange(9.0).reshape(3, 3)
    pair, ids = np.zeros((1, 2), dtype), np.arange(3, dtype=dtype)
    for call in (
        lambda: abut.TriangleMesh(x, np.zeros((1, 3), dtype)),
        lambda: abut.contacts(x, 0.5, groups=ids),
        lambda: abut.contacts(x, 0.5, exclude=pair),
        lambda: abut.measure(abut.spheres(x, 0.5), pair, "gap"),
        lambda: abut.Detector().set_ids(ids),
    ):
        with pytest.raises(abut.InputTypeError, match="are whole numbers; float"):
            call()

"""What callers give, as arrays that the library reads where they are.

Arrays of float32 and float64 are taken as they are, whatever their strides. All other types of
numbers are converted where that is exact, and refused where it is not.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from ._errors import InputError, InputTypeError

Numbers: TypeAlias = npt.NDArray[np.floating[Any]]
#: A table with a row for each element, or a tuple with an array for each coordinate.
Coordinates: TypeAlias = Numbers | tuple[Numbers, ...]

_AXES = ("x", "y", "z")
# The one object for each type in the order of bytes of this machine.
_FLOAT32, _FLOAT64 = np.dtype(np.float32), np.dtype(np.float64)


def numbers(given: Any, what: str) -> Numbers:
    """An array of float32 or float64 with the numbers given. No copy unless one is needed.

    >>> numbers([1, 2], "radii")
    array([1., 2.])
    >>> numbers([1j], "radii")
    Traceback (most recent call last):
        ...
    abut.InputTypeError: radii are real numbers, not complex128
    """
    if _is_taken_as_it_is(given):
        return given  # type: ignore[no-any-return]
    array = _array_of(given, what)
    if array.dtype.kind == "f" and array.dtype.itemsize in (4, 8):
        if array.dtype.isnative and array.flags.aligned:
            return array
        return array.astype(array.dtype.newbyteorder("="))
    return _converted(array, what)


def _is_taken_as_it_is(given: Any) -> bool:
    """The usual case, in one step: calls of a few microseconds notice."""
    return (
        type(given) is np.ndarray
        and (given.dtype is _FLOAT64 or given.dtype is _FLOAT32)
        and given.flags.aligned
    )


def _array_of(given: Any, what: str) -> npt.NDArray[Any]:
    if type(given) is np.ndarray:
        return given
    if isinstance(given, np.ma.MaskedArray):
        if np.ma.is_masked(given):
            count = int(np.ma.getmaskarray(given).sum())
            raise InputError(
                f"{what}: {count} of {given.size} numbers are masked, so nothing is known of them; "
                "take the elements that are not masked, or fill the others"
            )
        return np.asarray(given.data)
    if not isinstance(given, np.ndarray) and hasattr(given, "__dlpack_device__"):
        return _from_dlpack(given, what)
    try:
        return np.asarray(given)
    except ValueError as error:
        raise InputError(f"{what} do not make an array: {error}") from None


def _from_dlpack(given: Any, what: str) -> npt.NDArray[Any]:
    if int(given.__dlpack_device__()[0]) != 1:
        raise InputTypeError(f"{what} lie on a device; copy them to the host first")
    try:
        return np.from_dlpack(given)
    except (BufferError, RuntimeError, TypeError) as error:
        raise InputTypeError(f"{what} cannot be read: {error}") from None


def _converted(array: npt.NDArray[Any], what: str) -> Numbers:
    """Other types of numbers, as float64, or an error if that is not exact."""
    if array.dtype.kind == "f" and array.dtype.itemsize == 2:
        return array.astype(np.float32)
    if array.dtype.kind in "iu":
        return _exactly(array, what)
    if array.dtype.kind == "f":
        return _exactly(array, what)
    if array.size == 0 and array.dtype.kind == "O":
        return array.astype(np.float64)
    kind = {"O": "Python objects", "b": "truth values", "U": "text", "S": "bytes"}
    raise InputTypeError(f"{what} are real numbers, not {kind.get(array.dtype.kind, array.dtype)}")


def _exactly(array: npt.NDArray[Any], what: str) -> Numbers:
    with np.errstate(over="ignore"):
        result = array.astype(np.float64)
    if array.dtype.kind in "iu" and array.dtype.itemsize < 8:
        return result
    if array.dtype.kind in "iu":
        wrong = _differ_as_integers(array, result)
    else:
        wrong = (result.astype(array.dtype) != array) & (array == array)
    if wrong.any():
        place = tuple(int(k[0]) for k in np.nonzero(wrong)) if wrong.ndim else ()
        where = f" of element {place[0]}" if place else ""
        raise InputError(
            f"{what}: the number {array[place]}{where} has no float64 that equals it; "
            "round the numbers yourself"
        )
    return result


def _differ_as_integers(array: npt.NDArray[Any], result: Numbers) -> npt.NDArray[np.bool_]:
    """True where a whole number of 64 bits is not the float64 it was rounded to."""
    limit = 2.0 ** (63 if array.dtype.kind == "i" else 64)
    beyond = result >= limit
    back = np.where(beyond, 0.0, result).astype(array.dtype)
    differ: npt.NDArray[np.bool_] = beyond | (back != array)
    return differ


def coordinates(given: Any, what: str = "positions") -> Coordinates:
    """Positions as a table with 2 or 3 columns, or as a tuple of 2 or 3 columns."""
    if type(given) is np.ndarray and given.dtype.kind == "f":
        return _table(numbers(given, what), what)
    if isinstance(given, tuple):
        return _columns(given, what)
    named = columns_by_name(given)
    if named is not None:
        return _columns(_named(given, named, what), what)
    return _table(numbers(given, what), what)


def _table(array: Numbers, what: str) -> Numbers:
    if array.ndim == 2 and array.shape[1] in (2, 3):
        return array
    if array.size == 0 and array.ndim == 1:
        return array.reshape(0, 3)
    hint = ""
    if array.ndim == 2 and array.shape[0] in (2, 3):
        hint = "; with a row for each coordinate, give the transpose or tuple(...)"
    raise InputError(
        f"{what} have the shape (N, 2) or (N, 3), a row for each element, not {array.shape}{hint}"
    )


def _columns(given: tuple[Any, ...], what: str) -> tuple[Numbers, ...]:
    if len(given) not in (2, 3):
        raise InputError(
            f"a tuple of {what} has 2 or 3 columns (x, y and z), not {len(given)}; "
            "points of a few coordinates each go into a list"
        )
    columns = tuple(
        numbers(column, f"{what} {name}") for column, name in zip(given, _AXES, strict=False)
    )
    for name, column in zip(_AXES, columns, strict=False):
        if column.ndim != 1:
            raise InputError(f"column {name} of the {what} has one axis, not {column.ndim}")
        if len(column) != len(columns[0]):
            raise InputError(
                f"column {name} of the {what} has {len(column)} numbers, "
                f"but column x has {len(columns[0])}"
            )
    return of_one_type(*columns)


def columns_by_name(given: Any) -> list[str] | None:
    """Names of the columns of a table: a mapping, a data frame, a data set, a structured array."""
    if isinstance(given, np.ndarray):
        return list(given.dtype.names) if given.dtype.names else None
    if hasattr(given, "collect_schema") and not hasattr(given, "to_numpy"):
        raise InputTypeError("the table has not been computed yet; give what its collect() returns")
    if isinstance(given, Mapping):
        # Data sets name their coordinates among their variables only.
        return [str(name) for name in getattr(given, "variables", given)]
    names = getattr(given, "columns", None)
    if names is None or isinstance(given, (list, tuple)):
        return None
    return [str(name) for name in names]


def _named(table: Any, names: list[str], what: str) -> tuple[Any, ...]:
    if "x" not in names or "y" not in names:
        raise InputError(f"{what}: the table has no columns x and y, but {', '.join(names)}")
    return tuple(_column_array(table[name]) for name in _AXES if name in names)


def _column_array(column: Any) -> Any:
    """Columns of data frames and data sets show their arrays in one of these ways."""
    if isinstance(column, np.ndarray):
        return column
    to_numpy = getattr(column, "to_numpy", None)
    return to_numpy() if to_numpy is not None else column


def radius_column(given: Any) -> Any:
    """The column `radius` or `r` of a table, or None."""
    names = columns_by_name(given) or []
    return next((_column_array(given[name]) for name in ("radius", "r") if name in names), None)


def radii(given: Any, count: int) -> Numbers | float:
    """One radius for all elements, or an array with one for each.

    >>> radii(0.5, 3)
    0.5
    >>> radii([0.5, 0.25], 3)
    Traceback (most recent call last):
        ...
    abut.InputError: 2 radii for 3 elements; give one for each, or one number for all
    """
    if isinstance(given, (float, int)) and not isinstance(given, bool):
        return number(given, "the radius")
    array = numbers(given, "radii")
    if array.ndim == 0:
        return float(array)
    if array.ndim != 1:
        raise InputError(f"radii have one axis, a number for each element, not {array.shape}")
    if len(array) != count:
        raise InputError(
            f"{len(array)} radii for {count} elements; give one for each, or one number for all"
        )
    return array


def number(given: Any, what: str) -> float:
    """One real number as a float that equals it."""
    if type(given) is float:
        return given
    array = numbers(given, what)
    if array.ndim != 0:
        raise InputTypeError(f"{what} is one number, not an array of the shape {array.shape}")
    return float(array)


def of_one_type(*arrays: Numbers) -> tuple[Numbers, ...]:
    """The arrays; if float32 and float64 are mixed, the former as float64."""
    if all(array.dtype == arrays[0].dtype for array in arrays):
        return arrays
    return tuple(array.astype(np.float64, copy=False) for array in arrays)


def whole_numbers(given: Any, dtype: type[np.generic], what: str) -> npt.NDArray[Any]:
    """Whole numbers as an array of `dtype`, side by side; an error for one that does not fit."""
    array = _array_of(given, what)
    if array.dtype.kind not in "iu" and array.size > 0:
        raise InputTypeError(f"{what} are whole numbers; {array.dtype} was given")
    limits = np.iinfo(dtype)  # type: ignore[type-var]
    if array.size > 0 and array.dtype != dtype:
        least, most = int(array.min()), int(array.max())
        if least < limits.min or most > limits.max:
            wrong = least if least < limits.min else most
            raise InputError(f"{what}: {wrong} is not between {limits.min} and {limits.max}")
    return np.require(array, dtype=dtype, requirements=("C", "A"))


def count(given: Any, what: str) -> int | None:
    """A number of things, at least 0, or None."""
    if given is None:
        return None
    if isinstance(given, bool) or not isinstance(given, (int, np.integer)):
        raise InputTypeError(f"{what} is a whole number or None, not {given!r}")
    if not 0 <= given < 2**64:
        raise InputError(f"{what} is a number from 0 to 2**64 - 1, not {given}")
    return int(given)

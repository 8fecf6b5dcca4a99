"""Files of elements: reading and writing."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _abut
from ._arrays import number
from ._domain import Domain
from ._elements import Elements, boxes, discs, rectangles, require_elements, spheres
from ._progress import Progress, progress_function


@dataclass(frozen=True)
class Snapshot:
    """The elements of one frame of a file, in the order of the file."""

    elements: Elements  #: Spheres, discs, boxes or rectangles.
    domain: Domain  #: The box of the file, periodic on the axes that the file names.
    ids: npt.NDArray[np.int64] | None  #: The file's own numbers of the elements, if it has any.
    groups: npt.NDArray[np.uint32] | None  #: Of the column that was asked for.
    format: str  #: 'csv', 'lammps_data', 'lammps_dump' or 'xyz'.
    frame: int  #: The frame that was read, from 0.
    frame_count: int  #: Frames in the file.


def read(
    path: str | os.PathLike[str],
    *,
    format: str = "",
    radius: float | None = None,
    frame: int | None = None,
    groups: str = "",
    progress: Progress | None = None,
) -> Snapshot:
    """Reads one frame of a file: CSV, LAMMPS dump or data, XYZ or extended XYZ.

    Parameters
    ----------
    path : str or path
    format : str
        Name of the format; by suffix, then content, if it is left out.
    radius : float
        Radius for all elements, in place of those of the file.
    frame : int
        Frame, from 0, negative from the end; the last by default.
    groups : str
        Column whose whole numbers are read.
    progress : function, or class of bars such as tqdm
        Called with 'read', the bytes read and their number; False cancels.

    Raises
    ------
    InputError
        One sentence with file, line, column and value.
    OSError
        The file cannot be opened.
    """
    name = os.fspath(path)
    os.stat(name)  # raises what Python's users expect of a file that is not there
    fields = _abut.read(
        name,
        format,
        None if radius is None else number(radius, "the radius"),
        None if frame is None else int(frame),
        groups,
        progress_function(progress),
    )
    return Snapshot(
        _elements_of(fields),
        _domain_of(fields),
        fields["ids"] if len(fields["ids"]) else None,
        fields["groups"] if groups else None,
        fields["format"],
        fields["frame"],
        fields["frame_count"],
    )


def _elements_of(fields: dict[str, Any]) -> Elements:
    dimensions, columns = fields["dimensions"], tuple(fields["columns"])
    if fields["is_of_boxes"]:
        made = boxes if dimensions == 3 else rectangles
        return made(columns[:dimensions], columns[dimensions:])
    return (spheres if dimensions == 3 else discs)(columns, fields["radius"])


def _domain_of(fields: dict[str, Any]) -> Domain:
    dimensions, periodic = fields["dimensions"], fields["periodic"]
    if fields["box"] is None or not any(periodic[:dimensions]):
        return Domain.open()
    vectors = np.array(fields["box"])[:dimensions, :dimensions]
    return Domain.lattice(vectors, periodic[:dimensions])


def write(path: str | os.PathLike[str], elements: Elements, format: str = "") -> None:
    """Writes elements so that `read` gives the same bits back; the file appears whole or not at
    all.

    Parameters
    ----------
    path : str or path
    elements : Elements
        Spheres or discs.
    format : str
        'csv', 'lammps_dump' or 'xyz'; by the suffix of the path if it is left out.
    """
    _abut.write_elements(os.fspath(path), format, require_elements(elements)._native)

"""Reads the files of write_vtp_files with VTK's own reader and compares every number.

check_vtp.py WRITER DUMP: WRITER is the program, DUMP the file that spheres.vtp was made from.
"""

import math
import subprocess
import sys
import tempfile

from vtkmodules.vtkCommonCore import vtkFileOutputWindow, vtkOutputWindow
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader


def read(path):
    errors = []
    reader = vtkXMLPolyDataReader()
    reader.AddObserver("ErrorEvent", lambda *_: errors.append("error"))
    reader.AddObserver("WarningEvent", lambda *_: errors.append("warning"))
    reader.SetFileName(path)
    reader.Update()
    assert not errors, f"{path}: VTK's reader reports {errors}"
    assert reader.GetErrorCode() == 0, f"{path}: error code {reader.GetErrorCode()}"
    return reader.GetOutput()


def values(array):
    return [array.GetValue(k) for k in range(array.GetNumberOfValues())]


def lines_of(data):
    cells = data.GetLines()
    connectivity = values(cells.GetConnectivityArray())
    offsets = values(cells.GetOffsetsArray())
    assert offsets == list(range(0, len(connectivity) + 1, 2)), "lines have two ends each"
    return list(zip(connectivity[0::2], connectivity[1::2]))


def check(path, points, radii, ids, expected_lines=None):
    data = read(path)
    n = len(points)
    assert data.GetNumberOfPoints() == n, path
    assert data.GetNumberOfCells() == data.GetNumberOfLines(), path
    assert [data.GetPoint(k) for k in range(n)] == points, path
    if n:
        assert data.GetPoints().GetData().GetDataTypeAsString() == "double", path

    lines = lines_of(data)
    assert expected_lines is None or lines == expected_lines, (path, lines)
    coordination = [0] * n
    for i, j in lines:
        coordination[i] += 1
        coordination[j] += 1
    point_data = data.GetPointData()
    names = [point_data.GetArrayName(k) for k in range(point_data.GetNumberOfArrays())]
    assert names == ["radius", "coordination_number"] + (["id"] if ids else []), names
    assert values(point_data.GetArray("radius")) == radii, path
    assert values(point_data.GetArray("coordination_number")) == coordination, path
    assert not ids or values(point_data.GetArray("id")) == ids, path

    cell_data = data.GetCellData()
    assert cell_data.GetNumberOfArrays() == 1, path
    gaps = values(cell_data.GetArray("gap"))
    assert len(gaps) == len(lines), path
    for (i, j), gap in zip(lines, gaps):
        expected = math.dist(points[i], points[j]) - (radii[i] + radii[j])
        assert abs(gap - expected) < 1e-14 and gap <= 0, (path, i, j, gap, expected)
    return len(lines)


def check_quantities(data, points, radii):
    """Those of a line to an image are those to the point that the line ends in."""
    arrays = data.GetCellData()
    names = [arrays.GetArrayName(k) for k in range(arrays.GetNumberOfArrays())]
    assert names == ["gap", "normal", "point", "distance", "vector", "shift"], names
    tuples = {name: [arrays.GetArray(name).GetTuple(k) for k in range(data.GetNumberOfLines())]
              for name in names}
    for k, (i, j) in enumerate(lines_of(data)):
        distance = math.dist(points[i], points[j])
        vector = [b - a for a, b in zip(points[i], points[j])]
        middle = (radii[i] + distance - radii[j]) / 2
        point = [a + v / distance * middle for a, v in zip(points[i], vector)]
        for name, expected in (("distance", [distance]), ("vector", vector), ("point", point),
                               ("normal", [v / distance for v in vector])):
            assert math.dist(tuples[name][k], expected) < 1e-14, (name, k, tuples[name][k])


def check_periodic(path):
    """Discs in the cell (3, 0), (1, 9): lines to images end in points of their own."""
    data = read(path)
    points = [data.GetPoint(k) for k in range(data.GetNumberOfPoints())]
    radii = values(data.GetPointData().GetArray("radius"))
    images = values(data.GetPointData().GetArray("image"))
    assert images == [0] * 4 + [1] * (len(points) - 4), images
    check_quantities(data, points, radii)
    lines = lines_of(data)
    gaps = values(data.GetCellData().GetArray("gap"))
    shifts = values(data.GetCellData().GetArray("shift"))
    ends = []
    for (i, end), gap, n in zip(lines, gaps, zip(shifts[0::3], shifts[1::3], shifts[2::3])):
        assert abs(math.dist(points[i], points[end]) - radii[i] - radii[end] - gap) < 1e-14
        moved = (points[end][0] - 3 * n[0] - n[1], points[end][1] - 9 * n[1], 0)
        ends.append((i, points.index(moved), n))
        assert (end >= 4) == (n != (0, 0, 0)) and radii[end] == radii[points.index(moved)]
    # (2.5, 0) has an image at (-0.5, 0), and (9, 9) one at (2, 0).
    assert ends == [(0, 1, (0, 0, 0)), (0, 2, (-1, 0, 0)), (1, 2, (-1, 0, 0)), (1, 2, (0, 0, 0)),
                    (1, 3, (-2, -1, 0)), (2, 3, (-2, -1, 0))], ends
    assert len(points) == 4 + 4


def check_two_sets(path):
    """Two discs, then four of another set, then an image for each pair with a shift; box 3 by 9."""
    data = read(path)
    points = [data.GetPoint(k) for k in range(data.GetNumberOfPoints())]
    arrays = data.GetPointData()
    assert points[:6] == [(0.25, 8.5, 0), (1, 1, 0), (0, 0, 0), (1, 0, 0), (2.5, 0, 0), (9, 9, 0)]
    radii = values(arrays.GetArray("radius"))
    assert radii[:6] == [0.5, 0.125, 0.5, 0.75, 0.75, 0.25]
    assert values(arrays.GetArray("id"))[:6] == [7, 8, 1, 2, 3, 4]
    sets = values(arrays.GetArray("set"))
    assert sets[:6] == [0, 0, 1, 1, 1, 1] and set(sets[6:]) == {1}
    lines = lines_of(data)
    gaps = values(data.GetCellData().GetArray("gap"))
    shifts = values(data.GetCellData().GetArray("shift"))
    found = []
    for (i, end), gap, n in zip(lines, gaps, zip(shifts[0::3], shifts[1::3], shifts[2::3])):
        moved = (points[end][0] - 3 * n[0], points[end][1] - 9 * n[1], 0)
        found.append((i, points.index(moved), n))
        assert abs(math.dist(points[i], points[end]) - radii[i] - radii[end] - gap) < 1e-14
        assert (end >= 6) == (n != (0, 0, 0)) and i < 2
    expected = []
    for i in range(2):
        for j in range(2, 6):
            for nx in range(-5, 6):
                for ny in range(-2, 3):
                    image = (points[j][0] + 3 * nx, points[j][1] + 9 * ny, 0)
                    if math.dist(points[i], image) <= radii[i] + radii[j]:
                        expected.append((i, j, (nx, ny, 0)))
    assert found == expected and len(found) > 3, (found, expected)
    coordination = values(arrays.GetArray("coordination_number"))
    assert coordination[:6] == [sum(k in pair[:2] for pair in found) for k in range(6)]


def dump_rows(path):
    with open(path) as file:
        text = file.read()
    rows = text[text.rindex("ITEM: ATOMS"):].splitlines()
    columns = rows[0].split()[2:]
    return [dict(zip(columns, row.split())) for row in rows[1:]]


def main(writer, dump):
    # Reports of VTK that no observer of the reader sees would go to the terminal unnoticed.
    window = vtkFileOutputWindow()
    with tempfile.TemporaryDirectory() as folder:
        window.SetFileName(f"{folder}/vtk.log")
        vtkOutputWindow.SetInstance(window)
        subprocess.run([writer, folder], check=True)
        rows = dump_rows(dump)
        count = check(f"{folder}/spheres.vtp",
                      [tuple(float(row[axis]) for axis in "xyz") for row in rows],
                      [float(row["radius"]) for row in rows], [int(row["id"]) for row in rows])
        assert count == 4158, count
        check(f"{folder}/discs.vtp", [(0, 0, 0), (1, 0, 0), (2.5, 0, 0), (9, 9, 0)],
              [0.5, 0.75, 0.75, 0.25], None, [(0, 1), (1, 2)])
        check_periodic(f"{folder}/periodic.vtp")
        check_two_sets(f"{folder}/two_sets.vtp")
        check(f"{folder}/alone.vtp", [(1, 1, 1)], [1], None, [])
        check(f"{folder}/nothing.vtp", [], [], None, [])


if __name__ == "__main__":
    main(*sys.argv[1:])

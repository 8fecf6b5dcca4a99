"""Runs the example examples/dem.cpp and checks what it claims: momentum is conserved where there are
no walls, the energy ledger closes and shrinks as the square of the step, a restart goes on with the
same bits, and the frames are read by VTK.  check_dem.py PROGRAM"""

import pathlib
import re
import subprocess
import sys
import tempfile


def run(program, *arguments):
    result = subprocess.run([program, *map(str, arguments)], check=True, capture_output=True,
                            text=True)
    return result.stdout.splitlines()


def last(lines, name):
    """A number of the last line of output."""
    return float(re.search(rf"{name} ([-+.e\d]+)", lines[-1])[1])


def check(condition, sentence):
    if not condition:
        sys.exit(f"dem: {sentence}")


def check_ledger(program, what, time):
    """With half the step a quarter is left, give or take what single contacts do."""
    errors = [abs(last(run(program, what, 200, round(time / dt), dt), "ledger"))
              for dt in (1e-3, 5e-4, 2.5e-4)]
    print(f"{what}: ledger {errors}")
    check(errors[-1] < 1e-3, f"the ledger of {what} is off by {errors[-1]}")
    for coarse, fine in zip(errors, errors[1:]):
        check(coarse > 2.8 * fine, f"the ledger of {what} shrinks from {coarse} to {fine} only")


def check_frames(program):
    import vtk  # here, so that the rest is checked first
    with tempfile.TemporaryDirectory() as folder:
        run(program, "column", 100, 50, 1e-3, f"{folder}/frame")
        frames = sorted(pathlib.Path(folder).glob("*.vtp"))
        check(len(frames) == 5, f"{len(frames)} frames instead of 5")
        for frame in frames:
            reader = vtk.vtkXMLPolyDataReader()
            reader.SetFileName(str(frame))
            reader.Update()
            check(reader.GetOutput().GetNumberOfPoints() == 100, f"{frame.name} is not 100 points")


def main():
    program = sys.argv[1]
    drift = last(run(program, "fly", 300, 1000, 1e-3), "momentum")
    check(drift < 1e-12, f"momentum drifts by {drift}")
    check_ledger(program, "fly", 1.0)
    check_ledger(program, "settle", 3.0)
    lines = run(program, "restart", 300, 3000, 1e-3)
    check(lines == ["restart: the same bits"], str(lines))
    check_frames(program)


if __name__ == "__main__":
    main()

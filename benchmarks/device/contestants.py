"""Times other people's neighbor lists on a GPU beside abut, on the scenes of abut.

Usage, in the project's folder: python3 -m benchmarks.device.contestants TOOL [--elements N,M]
TOOL is abut, the tool, which makes the scenes, tells their digests, and measures abut on the device
and on the processor by `bench`, in the same run. Each contestant's pairs are brought into order and
their digest is compared with that of abut before anything is timed; one that differs is shown as
WRONG, with the pairs that it found. Each row has the time of a call for each element, elements a
second, and how many times as long as abut on the device the contestant takes. Packages that are not
installed, and what they fail with, are named on standard error. Elements are equal spheres, since
the contestants know one cutoff. Exit code 6 without a device, 7 where an answer of abut is wrong.
"""

import argparse
import csv
import hashlib
import importlib.metadata
import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path

SCENES = ("dense", "gas")
CALLS = 7
DIFFERENT_ANSWERS = 7
HEADING = ("contestant", "scene", "elements", "pairs", "answer", "first_ms", "median_ms",
           "ns_per_element", "billions_per_second", "times_as_long_as_abut")


def vesin_pairs(points, cutoff):
    import torch
    from vesin.torch import NeighborList

    box = torch.zeros((3, 3), dtype=points.dtype)
    search = NeighborList(cutoff=cutoff, full_list=False)
    return search.compute(points=points, box=box.to(points.device), periodic=False, quantities="ij")


def alchemi_pairs(points, cutoff):
    import torch
    from nvalchemiops.torch.neighbors import neighbor_list

    # Open space in a cell that holds all.
    length = float((points.max() - points.min()).item()) + 4.0 * cutoff
    cell = length * torch.eye(3, dtype=points.dtype, device=points.device).reshape(1, 3, 3)
    pbc = torch.zeros((1, 3), dtype=torch.bool, device=points.device)
    found = neighbor_list(points - points.min() + cutoff, cutoff, cell=cell, pbc=pbc,
                          half_fill=True, return_neighbor_list=True)
    return found[0][0], found[0][1]


# The name of a contestant, its function, and the distributions whose versions are told.
CONTESTANTS = (
    ("vesin", vesin_pairs, ("vesin", "vesin-torch", "torch")),
    ("ALCHEMI toolkit-ops", alchemi_pairs, ("nvalchemi-toolkit-ops", "warp-lang", "torch")),
)


def digest(first, second):
    """As `abut contacts --digest`: each pair once, smaller number first, ascending."""
    import numpy as np

    low = np.minimum(first, second).astype(np.uint64)
    high = np.maximum(first, second).astype(np.uint64)
    keys = np.sort(low << np.uint64(32) | high)
    pairs = np.empty((len(keys), 2), dtype="<u4")
    pairs[:, 0] = keys >> np.uint64(32)
    pairs[:, 1] = keys & np.uint64(0xFFFFFFFF)
    return "sha256:" + hashlib.sha256(pairs.tobytes()).hexdigest()


def versions(distributions):
    told = []
    for name in distributions:
        try:
            told.append(f"{name} {importlib.metadata.version(name)}")
        except importlib.metadata.PackageNotFoundError:
            continue
    return ", ".join(told)


def scene_of(tool, name, elements, folder):
    """The file of a scene, its points, the cutoff and the digest, by the tool."""
    import numpy as np

    path = str(Path(folder) / "scene.csv")
    subprocess.run([tool, "generate", name, "--count", str(elements), "-o", path, "-q"], check=True)
    told = subprocess.run([tool, "contacts", path, "--digest"], check=True, capture_output=True,
                          text=True)
    table = np.loadtxt(path, delimiter=",", skiprows=1)
    return path, table[:, :3], 2.0 * table[0, 3], told.stdout.strip()


def row_of(contestant, scene, elements, result, seconds_of_abut):
    """A row of the table; `result` is what `measured` returns."""
    pairs, answer, once, median = result
    row = [contestant, scene, elements, pairs, answer]
    if median is None:
        return row + [""] * (len(HEADING) - len(row))
    ratio = "" if seconds_of_abut is None else f"{median / seconds_of_abut:.2f}"
    return row + [f"{1e3 * once:.4f}", f"{1e3 * median:.4f}", f"{1e9 * median / elements:.4f}",
                  f"{1e-9 * elements / median:.4f}", ratio]


def rows_of_abut(told, scene, expected):
    """The rows of abut, the device first, of what `bench --json` told, and its seconds there.

    Of the processor the fastest list in canonical order counts.
    """
    elements = told["elements"]
    best = {}
    for run in told["runs"]:
        if run["result"] != "canonical" or "not_run" in run:
            continue
        where = "processor" if run["device"] == "cpu" else "device"
        first, median = (1e-9 * run["ns_per_element"][name] * elements
                         for name in ("first", "median"))
        if run["digest"] != expected:
            best[where] = (run["contact_pairs"], "WRONG", None, None)
        elif where not in best or (best[where][3] or 0.0) > median:
            best[where] = (run["contact_pairs"], "right", first, median)
    seconds = best.get("device", (None,) * 4)[3]
    names = (("device", "abut::device"), ("processor", "abut on the processor"))
    return [row_of(name, scene, elements, best[where], seconds)
            for where, name in names if where in best], seconds


def bench_of_abut(tool, path):
    """What the tool's bench measures on the device and the processor, list and all."""
    done = subprocess.run([tool, "bench", path, "--json", "--device", "gpu", "--algorithms", "rows",
                           "--repetitions", str(CALLS), "-q"],
                          check=False, capture_output=True, text=True)
    if not done.stdout:
        raise RuntimeError(done.stderr.strip())
    return json.loads(done.stdout)


def measured(function, points, cutoff, expected, wait):
    """Pairs, answer, seconds of the first call and the median of those after it."""
    begin = time.perf_counter()
    first, second = function(points, cutoff)
    wait()
    once = time.perf_counter() - begin
    found = digest(first.cpu().numpy(), second.cpu().numpy())
    if found != expected:
        return len(first), "WRONG", None, None
    seconds = []
    for _ in range(CALLS):
        begin = time.perf_counter()
        function(points, cutoff)
        wait()
        seconds.append(time.perf_counter() - begin)
    return len(first), "right", once, sorted(seconds)[CALLS // 2]


def rows_of_scene(tool, scene, elements, folder):
    import torch

    path, numbers, cutoff, expected = scene_of(tool, scene, elements, folder)
    of_abut, seconds = rows_of_abut(bench_of_abut(tool, path), scene, expected)
    yield from of_abut
    points = torch.tensor(numbers, dtype=torch.float64, device="cuda")
    for name, function, _ in CONTESTANTS:
        try:
            result = measured(function, points, cutoff, expected, torch.cuda.synchronize)
        except Exception as error:  # noqa: BLE001  (other people's, of any kind)
            print(f"{name}, {scene}, {elements}: left out: {error}", file=sys.stderr)
            continue
        yield row_of(name, scene, elements, result, seconds)


def rows(tool, sizes):
    with tempfile.TemporaryDirectory() as folder:
        for elements in sizes:
            for scene in SCENES:
                yield from rows_of_scene(tool, scene, elements, folder)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("tool")
    parser.add_argument("--elements", default="10000,100000,1000000")
    arguments = parser.parse_args()
    try:
        import torch

        has_device = torch.cuda.is_available()
    except ImportError:
        has_device = False
    if not has_device:
        print("benchmarks.device.contestants: no device can be used: PyTorch is not there or finds "
              "none", file=sys.stderr)
        return 6
    for name, _, distributions in CONTESTANTS:
        print(f"# {name}: {versions(distributions) or 'not installed'}")
    table = csv.writer(sys.stdout, lineterminator="\n")
    table.writerow(HEADING)
    all_right = True
    for row in rows(arguments.tool, [int(size) for size in arguments.elements.split(",")]):
        table.writerow(row)
        sys.stdout.flush()
        all_right &= not (row[0].startswith("abut") and row[4] == "WRONG")
    return 0 if all_right else DIFFERENT_ANSWERS


if __name__ == "__main__":
    sys.exit(main())

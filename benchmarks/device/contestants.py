"""Times other people's neighbor lists on a GPU, on the scenes of abut.

Usage, in the project's folder: python3 -m benchmarks.device.contestants TOOL [--elements N,M]
TOOL is abut, the tool, which makes the scenes and tells their digests. Each contestant's pairs are
brought into order and their digest is compared with that of abut before anything is timed; one that
differs is shown as WRONG, with the pairs that it found. Packages that are not installed, and what
they fail with, are named on standard error. Elements are equal spheres, since the contestants know
one cutoff. Exit code 6 without a device.
"""

import argparse
import csv
import hashlib
import importlib.metadata
import subprocess
import sys
import tempfile
import time
from pathlib import Path

SCENES = ("dense", "gas")
CALLS = 7


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
    """The points, the cutoff and the digest of a scene, by the tool."""
    import numpy as np

    path = str(Path(folder) / "scene.csv")
    subprocess.run([tool, "generate", name, "--count", str(elements), "-o", path, "-q"], check=True)
    told = subprocess.run([tool, "contacts", path, "--digest"], check=True, capture_output=True,
                          text=True)
    table = np.loadtxt(path, delimiter=",", skiprows=1)
    return table[:, :3], 2.0 * table[0, 3], told.stdout.strip()


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


def rows(tool, sizes):
    import torch

    with tempfile.TemporaryDirectory() as folder:
        for elements in sizes:
            for scene in SCENES:
                numbers, cutoff, expected = scene_of(tool, scene, elements, folder)
                points = torch.tensor(numbers, dtype=torch.float64, device="cuda")
                for name, function, _ in CONTESTANTS:
                    try:
                        pairs, answer, once, median = measured(
                            function, points, cutoff, expected, torch.cuda.synchronize)
                    except Exception as error:  # noqa: BLE001  (other people's, of any kind)
                        print(f"{name}, {scene}, {elements}: left out: {error}", file=sys.stderr)
                        continue
                    times = ["", ""] if once is None else [f"{1e3 * once:.4f}", f"{1e3 * median:.4f}"]
                    yield [name, scene, elements, pairs, answer, *times]


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
    table.writerow(["contestant", "scene", "elements", "pairs", "answer", "first_ms", "median_ms"])
    table.writerows(rows(arguments.tool, [int(size) for size in arguments.elements.split(",")]))
    return 0


if __name__ == "__main__":
    sys.exit(main())

"""SciPy's cKDTree at work for the contestant scipy_ckdtree: reads orders on stdin, answers on
stdout. The first order is the path of the scene: number of elements and dimensions as int64, then
the columns as float64. Each `run` builds the tree, finds all pairs within the largest reach and
keeps those that touch; the answer is wall and CPU seconds, pairs and candidates, or a refusal.
`pairs PATH` writes the last pairs as uint32."""

import sys
import time

import numpy as np
from scipy.spatial import cKDTree


def read_scene(path):
    with open(path, "rb") as file:
        count, dimensions = np.fromfile(file, dtype=np.int64, count=2)
        columns = np.fromfile(file, dtype=np.float64).reshape(dimensions + 1, count)
    return columns[:-1], columns[-1]


def contact_pairs(columns, radii):
    """Pairs (i, j), i < j, as uint32, and the number of candidates."""
    if radii.size == 0:
        return np.empty((0, 2), dtype=np.uint32), 0
    points = np.ascontiguousarray(columns.T)
    # Faster to build, and hardly slower to search, than the balanced tree.
    tree = cKDTree(points, balanced_tree=False, compact_nodes=False)
    reach = 2.0 * radii.max() * (1.0 + 1e-12)
    candidates = tree.query_pairs(reach, output_type="ndarray")
    first, second = candidates[:, 0], candidates[:, 1]
    difference = points[first] - points[second]
    distance_squared = difference[:, 0] * difference[:, 0]
    for axis in range(1, difference.shape[1]):
        distance_squared += difference[:, axis] * difference[:, axis]
    reach_of_pair = radii[first] + radii[second]
    hits = distance_squared <= reach_of_pair * reach_of_pair
    return candidates[hits].astype(np.uint32), len(candidates)


def main():
    columns, radii = read_scene(sys.stdin.readline().strip())
    pairs = None
    print("ready", flush=True)
    for order in sys.stdin:
        word, _, path = order.strip().partition(" ")
        if word == "pairs":
            pairs.tofile(path)
            print("written", flush=True)
            continue
        pairs = None
        wall, cpu = time.perf_counter(), time.thread_time()
        try:
            pairs, candidates = contact_pairs(columns, radii)
        except MemoryError:
            print("refused needs more memory than there is", flush=True)
            continue
        wall, cpu = time.perf_counter() - wall, time.thread_time() - cpu
        print("found", wall, cpu, len(pairs), candidates, flush=True)


if __name__ == "__main__":
    main()

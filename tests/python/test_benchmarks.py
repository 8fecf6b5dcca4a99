"""The benchmark of the package runs on small systems, and refuses a wrong answer."""

import importlib.util
import subprocess
import sys
from importlib.machinery import SourceFileLoader

import numpy as np
import pytest
from conftest import SOURCES

RUN = SOURCES / "benchmarks" / "python" / "run"


def loaded():
    loader = SourceFileLoader("benchmark_run", str(RUN))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
    loader.exec_module(module)
    return module


def test_run():
    command = [sys.executable, "-B", str(RUN), "--sizes", "30", "--repeats", "1"]
    printed = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    for task in ("dense", "bidisperse", "liquid, half ij", "liquid, full ijdDS"):
        packages = [line[31:51].strip() for line in printed.splitlines() if line.startswith(task)]
        assert packages[0] == "abut"
        assert "vesin" in packages
    assert "'in_library'" in printed


def test_another_pair_is_refused_unless_single_precision_explains_it():
    run = loaded()
    x = np.array([[0.0, 0, 0], [1, 0, 0], [2 + 1e-7, 0, 0]])
    scene = {"x": x, "r": np.full(3, 0.5), "cell": None}
    expected = run.of_pairs(np.array([0]), np.array([1]))
    more = (np.array([0, 1]), np.array([1, 2]))
    run.require_same("here", scene, "freud", more, expected)
    for package, found in (("SciPy", more), ("freud", (np.array([0, 0]), np.array([1, 2])))):
        with pytest.raises(SystemExit, match=f"{package} differs from abut in 1 pairs"):
            run.require_same("here", scene, package, found, expected)

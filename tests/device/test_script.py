"""scripts/test --device without a device, and with programs that stand for one and its tests."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[2] / "scripts/test"
NVIDIA_SMI = "echo 'NVIDIA X100, 580.1, 80000 MiB'"
TOOL = """case "$*" in
  *gpu:99*) exit 6 ;;
  *--digest*) echo sha256:0 ;;
  *--version*) echo abut 0.0.0 ;;
esac"""


def write_program(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(f"#!/bin/sh\n{text}\n")
    path.chmod(0o755)


class TestScript(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        for name in ("tests/device/on_device_test", "tests/device/after_failure"):
            write_program(self.folder / name, "exit 0")
        write_program(self.folder / "bin/abut", TOOL)
        write_program(self.folder / "path/compute-sanitizer", 'while [ "$1" != --tool ]; do shift; done\n'
                      'case $2 in memcheck) shift 4 ;; *) shift 2 ;; esac\n"$@"')

    def run_script(self, **changes):
        path = f"{self.folder}/path:/usr/bin:/bin"
        return subprocess.run(
            [SCRIPT, "--device", self.folder], capture_output=True, text=True, check=False,
            timeout=120, env={**os.environ, "PATH": path, "ABUT_DEVICE_RESULTS": str(self.folder),
                 **changes})

    def result(self):
        return (self.folder / "tests.txt").read_text()

    def test_no_driver(self):
        done = self.run_script(NVIDIA_SMI="no_such_program")
        self.assertEqual(done.returncode, 6)
        self.assertEqual(done.stdout, "")
        self.assertRegex(done.stderr, r"^test-device: no device: [^\n]*\n$")

    def test_no_device(self):
        write_program(self.folder / "path/nvidia-smi", "echo 'No devices were found'; exit 6")
        done = self.run_script()
        self.assertEqual(done.returncode, 6)
        self.assertIn("No devices were found", done.stderr)

    def test_all_passes(self):
        write_program(self.folder / "path/nvidia-smi", NVIDIA_SMI)
        done = self.run_script()
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("NVIDIA X100, 580.1, 80000 MiB", self.result())
        self.assertNotIn("FAILED", self.result())
        for kind in ("memcheck", "initcheck", "racecheck", "synccheck"):
            self.assertIn(f"compute-sanitizer, {kind}", self.result())

    def test_sanitizers_see_all_forms(self):
        write_program(self.folder / "path/nvidia-smi", NVIDIA_SMI)
        write_program(self.folder / "tests/device/on_device_test",
                      f'echo "$ABUT_SCENE_ELEMENTS $*" >> {self.folder}/calls')
        self.assertEqual(self.run_script().returncode, 0)
        calls = (self.folder / "calls").read_text().splitlines()
        self.assertEqual(len(calls), 2 + 2 * 4)
        for plain, others in zip(calls[2::2], calls[3::2]):
            self.assertRegex(plain, r"^1000 .*Scenes/FaceScenes\*")
            self.assertRegex(others, r"^500 .*FaceCalls\.\*:.*FaceRows\*:FaceRules\.\*:Scenes/FaceRows")

    def test_an_error_of_a_sanitizer(self):
        write_program(self.folder / "path/nvidia-smi", NVIDIA_SMI)
        for word in ("FaceScenes", "FaceRules"):
            write_program(self.folder / "path/compute-sanitizer",
                          f'case "$*" in *initcheck*{word}*) exit 9 ;; esac')
            self.assertEqual(self.run_script().returncode, 1)
            self.assertRegex(self.result(), "compute-sanitizer, initcheck +FAILED")
            self.assertEqual(self.result().count("FAILED"), 1)

    def test_a_failure_is_told_and_written(self):
        write_program(self.folder / "path/nvidia-smi", NVIDIA_SMI)
        write_program(self.folder / "tests/device/after_failure", "exit 1")
        done = self.run_script()
        self.assertEqual(done.returncode, 1)
        self.assertRegex(self.result(), "an earlier kernel that failed +FAILED")
        self.assertEqual(self.result().count("FAILED"), 1)

    def test_other_pairs_of_the_tool(self):
        write_program(self.folder / "path/nvidia-smi", NVIDIA_SMI)
        write_program(self.folder / "bin/abut", TOOL.replace("*--digest*) echo sha256:0 ;;",
                      "*--device*) echo sha256:1 ;; *--digest*) echo sha256:0 ;;"))
        self.assertEqual(self.run_script().returncode, 1)
        self.assertRegex(self.result(), "the tool +FAILED")


if __name__ == "__main__":
    sys.exit(unittest.main())

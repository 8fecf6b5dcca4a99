"""Configures an outside project with every cmake block of the pages, and builds it where that needs
no second copy of abut."""

import argparse
import pathlib
import subprocess
import sys
import tempfile

import blocks

PROJECT = """cmake_minimum_required(VERSION 3.25)
project(outside LANGUAGES CXX)
add_executable(mydem main.cpp)
"""

MAIN = """#include <abut/abut.hpp>
int main() { return abut::version().empty() ? 1 : 0; }
"""


def check(block, arguments, prefix):
    """One sentence about what is wrong, or None."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "CMakeLists.txt").write_text(PROJECT + block.text, encoding="utf-8")
        (folder / "main.cpp").write_text(MAIN, encoding="utf-8")
        (folder / "third_party").mkdir()
        (folder / "third_party" / "abut").symlink_to(pathlib.Path(arguments.root).resolve())
        configure = ["cmake", "-S", folder, "-B", folder / "build", "-G", "Ninja",
                     f"-DCMAKE_PREFIX_PATH={prefix}",
                     f"-DCMAKE_CXX_COMPILER={arguments.compiler}"]
        commands = [configure]
        if "add_subdirectory" not in block.text:
            commands.append(["cmake", "--build", folder / "build", "--target", "mydem"])
        for command in commands:
            done = subprocess.run(command, capture_output=True, text=True, check=False)
            if done.returncode != 0:
                return f"{block.where()}: {done.stdout}{done.stderr}"
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    for name in ("root", "build", "compiler"):
        parser.add_argument(f"--{name}", required=True)
    arguments = parser.parse_args()

    found = blocks.blocks(pathlib.Path(arguments.root), "cmake")
    with tempfile.TemporaryDirectory() as prefix:
        subprocess.run(["cmake", "--install", arguments.build, "--prefix", prefix], check=True,
                       stdout=subprocess.DEVNULL)
        problems = [p for p in (check(b, arguments, prefix) for b in found) if p]
    for problem in problems:
        print(problem)
    print(f"{len(found)} cmake blocks, {len(problems)} problems")
    return 1 if problems or not found else 0


if __name__ == "__main__":
    sys.exit(main())

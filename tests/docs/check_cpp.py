"""Compiles every C++ block of the pages; runs whole programs and compares what they print."""

import argparse
import pathlib
import subprocess
import sys
import tempfile

import blocks

# What a fragment may take for granted: names that every page uses alike.
PRELUDE = """#include <abut/abut.hpp>
#include <abut/trace.hpp>
#include <array>
#include <cstdio>
#include <string>
#include <vector>
namespace {
[[maybe_unused]] std::vector<double> x, y, z, radius;
[[maybe_unused]] abut::ElementView elements = abut::spheres(x, y, z, radius);
[[maybe_unused]] abut::Options options;
[[maybe_unused]] bool stop_requested = false;
}  // namespace
"""


def source_of(block):
    """A block as a whole file: programs as they are, fragments inside a function."""
    if "int main(" in block.text:
        return block.text
    lines = block.text.splitlines()
    includes = [line for line in lines if line.startswith("#include")]
    body = [line for line in lines if not line.startswith("#include")]
    return "\n".join(includes) + "\n" + PRELUDE + "void fragment() {\n" + "\n".join(body) + "\n}\n"


def compile_block(block, arguments, folder):
    """Returns the program, or None for a fragment; raises CalledProcessError."""
    source = folder / "block.cpp"
    source.write_text(source_of(block), encoding="utf-8")
    command = [arguments.compiler, "-std=c++20", "-Wall", "-Wextra", "-Wno-unused-variable",
               "-Werror", f"-I{arguments.include}"]
    if arguments.sanitize:
        command.append(f"-fsanitize={arguments.sanitize}")
    if "int main(" not in block.text:
        subprocess.run(command + ["-fsyntax-only", "-Wno-unused-function", source], check=True)
        return None
    program = folder / "block"
    library = pathlib.Path(arguments.library)
    subprocess.run(command + [source, library, f"-Wl,-rpath,{library.parent}", "-o", program],
                   check=True)
    return program


def check(block, expected, arguments):
    """One sentence about what is wrong, or None."""
    with tempfile.TemporaryDirectory() as folder:
        try:
            program = compile_block(block, arguments, pathlib.Path(folder))
        except subprocess.CalledProcessError:
            return f"{block.where()}: does not compile"
        if program is None:
            return None
        done = subprocess.run([program], capture_output=True, text=True, timeout=60, check=False)
        if done.returncode != 0:
            return f"{block.where()}: ends with {done.returncode}: {done.stderr}"
        if expected is not None and done.stdout != expected.text:
            return f"{block.where()}: prints\n{done.stdout}instead of\n{expected.text}"
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    for name in ("root", "include", "library", "compiler"):
        parser.add_argument(f"--{name}", required=True)
    parser.add_argument("--sanitize", default="", help="what the library was built with")
    arguments = parser.parse_args()

    problems, checked = [], 0
    for page in blocks.pages(pathlib.Path(arguments.root)):
        on_page = blocks.blocks_of(page)
        for block, following in zip(on_page, on_page[1:] + [None]):
            if block.language != "cpp":
                continue
            shows_output = following is not None and following.language == "text output"
            checked += 1
            problem = check(block, following if shows_output else None, arguments)
            if problem:
                problems.append(problem)
    for problem in problems:
        print(problem)
    print(f"{checked} C++ blocks, {len(problems)} problems")
    return 1 if problems or checked == 0 else 0


if __name__ == "__main__":
    sys.exit(main())

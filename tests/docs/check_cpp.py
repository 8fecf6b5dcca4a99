"""Compiles every C++ block of the pages; runs whole programs and compares what they print."""

import argparse
import functools
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


class Compiler:
    """Compiles blocks in a folder. Fragments share one header, which is compiled once."""

    def __init__(self, arguments, folder):
        self.folder = pathlib.Path(folder)
        self.library = pathlib.Path(arguments.library)
        self.command = [arguments.compiler, "-std=c++20", "-Wall", "-Wextra",
                        "-Wno-unused-variable", "-Werror", f"-I{arguments.include}"]
        if arguments.sanitize:
            self.command.append(f"-fsanitize={arguments.sanitize}")

    @functools.cached_property
    def prelude(self):
        """The header of all fragments."""
        header = self.folder / "prelude.hpp"
        header.write_text(PRELUDE, encoding="utf-8")
        self.run("-x", "c++-header", header, "-o", f"{header}.gch")
        return header

    def run(self, *arguments):
        subprocess.run(self.command + list(arguments), check=True)

    def compile(self, block):
        """Returns the program, or None for a fragment; raises CalledProcessError."""
        source = self.folder / "block.cpp"
        if "int main(" in block.text:
            source.write_text(block.text, encoding="utf-8")
            program = self.folder / "block"
            self.run(source, self.library, f"-Wl,-rpath,{self.library.parent}", "-o", program)
            return program
        source.write_text(function_of(block), encoding="utf-8")
        self.run("-include", self.prelude, "-fsyntax-only", "-Wno-unused-function", source)
        return None


def function_of(block):
    """A fragment inside a function, behind what it includes."""
    lines = block.text.splitlines()
    includes = [line for line in lines if line.startswith("#include")]
    body = [line for line in lines if not line.startswith("#include")]
    return "\n".join([*includes, "void fragment() {", *body, "}", ""])


def check(block, expected, compiler):
    """One sentence about what is wrong, or None."""
    try:
        program = compiler.compile(block)
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


def problems_of(page, compiler):
    """What is wrong with each C++ block of a page, None where nothing is."""
    on_page = blocks.blocks_of(page)
    for block, following in zip(on_page, on_page[1:] + [None]):
        if block.language == "cpp":
            shows_output = following is not None and following.language == "text output"
            yield check(block, following if shows_output else None, compiler)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    for name in ("root", "include", "library", "compiler"):
        parser.add_argument(f"--{name}", required=True)
    parser.add_argument("--sanitize", default="", help="what the library was built with")
    arguments = parser.parse_args()

    with tempfile.TemporaryDirectory() as folder:
        compiler = Compiler(arguments, folder)
        found = [problem for page in blocks.pages(pathlib.Path(arguments.root))
                 for problem in problems_of(page, compiler)]
    problems = [problem for problem in found if problem]
    for problem in problems:
        print(problem)
    print(f"{len(found)} C++ blocks, {len(problems)} problems")
    return 1 if problems or not found else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""Checks that the tree keeps its layout: who may include whom, sizes of files, forbidden words, one
page of docs an algorithm, clang-format where it is installed. Prints what is wrong, with file and
line; exit code 1 if anything is.  scripts/check_layout.py [ROOT]"""

import re
import shutil
import statistics
import subprocess
import sys
from pathlib import Path

# Whose headers each folder may include: ARCHITECTURE.md, "arrows point downwards only". Folders not
# named here (tests) may include all.
ROOMS_BELOW = {
    "base": "",
    "exact/numbers": "",
    "exact": "exact/numbers",
    "kernels": "base exact",
    "grid": "base exact kernels",
    "lattice": "base exact/numbers exact grid",
    "reference": "base exact grid lattice",
    "engine": "base exact/numbers exact kernels grid",
    "periodic": "base exact kernels grid lattice engine",
    "elements": "base exact kernels grid lattice",
    "lists": "base exact",
    "skin": "base exact kernels grid lattice elements lists",
    "algorithms": "base exact grid reference engine periodic",
    "detect": "base exact kernels grid reference engine periodic elements lists skin algorithms",
    "history": "base exact lattice elements detect",
    "walls": "base exact kernels lattice elements detect",
}
CORE = {"include/abut": set()} | {
    f"src/{room}": {"include/abut"} | {f"src/{other}" for other in below.split()}
    for room, below in ROOMS_BELOW.items()
}
MAY_INCLUDE = CORE | {
    "src/io": {"include/abut", "src/base"},
    "src/io/read": {"include/abut", "src/base", "src/io"},
    "src/io/write": {"include/abut", "src/base", "src/io"},
    "scenes": {"include/abut"},
    "cli": {"include/abut", "src/io", "src/io/read", "src/io/write", "scenes"},
    "benchmarks": {"include/abut", "src/io", "src/io/read", "src/io/write", "scenes"},
    "examples": {"include/abut"},
}
# What the core may include besides: headers of the standard library, which have no dot, and these.
SYSTEM_HEADERS = {"hwy/foreach_target.h", "hwy/highway.h", "hwy/targets.h", "omp.h", "pthread.h",
                  "sched.h", "signal.h", "sys/resource.h",
                  "sys/mman.h", "unistd.h", "xmmintrin.h"}

SOURCE_FOLDERS = ("include", "src", "scenes", "cli", "benchmarks", "examples", "tests", "bindings")
CPP = {".cpp", ".hpp", ".inl", ".h", ".cu", ".cuh"}
TEXT = CPP | {".py", ".md", ".cmake", ".txt", ".json", ".in", ".sh", ""}
MEDIAN_LINES, SOFT_LINES, HARD_LINES = 150, 400, 800
REFERENCE_LINES = 300  # an algorithm of the book is read beside the page

ANYWHERE = [
    (r"\b(TODO|FIXME|XXX)\b", "an open end; finish it or file an issue"),
    (r"(?<![\w.:/}>])/(home|root|work|tmp|Users|opt)/", "an absolute path of one machine"),
]
IN_CORE = [
    (r"\bstd::(cout|cerr|clog|printf|puts)\b|\b(f?printf|f?puts|putchar|perror)\s*\(", "prints"),
    (r"\b(exit|_Exit|quick_exit|abort|terminate)\s*\(", "ends the process"),
    (r"#include <(iostream|cstdio|fstream)>", "includes input or output"),
]


def folder_of(path, folders):
    """The longest of the folders that the path lies in."""
    inside = [folder for folder in folders if path.as_posix().startswith(folder + "/")]
    return max(inside, key=len, default=None)


def included_folder(root, file, name, quoted):
    """The folder of the project that an included name lies in, if any."""
    bases = [file.parent, root / "src", root / "cli", root] if quoted else [root / "include"]
    for base in bases:
        target = (base / name).resolve()
        if target.is_file() and target.is_relative_to(root):
            return folder_of(target.relative_to(root), MAY_INCLUDE) or "tests"
    return None


def wrong_includes(root, file, lines):
    folder = folder_of(file.relative_to(root), MAY_INCLUDE)
    if folder is None:
        return
    for number, line in enumerate(lines, 1):
        match = re.match(r'\s*#\s*include\s*([<"])([^>"]+)[>"]', line)
        if not match:
            continue
        quoted, name = match[1] == '"', match[2]
        target = included_folder(root, file, name, quoted)
        if target is None:
            if quoted or name.startswith("abut/"):
                yield number, f"includes {name}, which is not there"
            elif folder in CORE and ("." in name or "/" in name) and name not in SYSTEM_HEADERS:
                yield number, f"includes {name}; the core needs the standard library only"
        elif target != folder and target not in MAY_INCLUDE[folder]:
            yield number, f"includes {name}: {folder} may not look into {target}"


def wrong_words(root, file, lines):
    rules = list(ANYWHERE)
    if file.suffix in CPP and folder_of(file.relative_to(root), CORE) not in (None, "include/abut"):
        rules += IN_CORE
    for number, line in enumerate(lines, 1):
        for pattern, fault in rules:
            if re.search(pattern, line):
                yield number, fault
    # Headers named -inl are included once for each instruction set.
    if (file.suffix == ".hpp" and not file.stem.endswith("-inl") and "#pragma once" not in [line.strip() for line in lines]):
        yield 1, "a header without #pragma once"


def wrong_size(root, file, lines):
    limit = HARD_LINES
    if file.relative_to(root).as_posix().startswith("src/reference/"):
        limit = REFERENCE_LINES
    if len(lines) > limit:
        yield len(lines), f"{len(lines)} lines; the limit is {limit}: split it"


def wrong_tree(root, sizes):
    median = statistics.median(sizes.values())
    if median > MEDIAN_LINES:
        yield f"the median source file has {median} lines > {MEDIAN_LINES}"
    registry = root / "src/algorithms/registry.cpp"
    for name in re.findall(r"\{Algorithm::(\w+),", registry.read_text()):
        if not (root / f"docs/algorithms/{name}.md").is_file():
            yield f"docs/algorithms/{name}.md is missing: every algorithm has its page"
    formatter = shutil.which("clang-format-14")
    if formatter and (root / ".clang-format").is_file():
        command = [formatter, "--dry-run", "-Werror", *sizes]
        run = subprocess.run(command, capture_output=True, text=True)
        yield from [line for line in run.stderr.splitlines() if "error:" in line]


def check(root):
    """All faults of the tree, and its files beyond the soft limit."""
    files = [file for folder in SOURCE_FOLDERS for file in sorted((root / folder).rglob("*"))]
    files += [file for name in ("docs", "scripts", "cmake") for file in (root / name).rglob("*")]
    files += [file for file in root.iterdir() if file.name[0] != "."]
    faults, sizes = [], {}
    for file in files:
        if not file.is_file() or file.suffix not in TEXT or file.name == "check_layout.py":
            continue
        lines = file.read_text(encoding="utf-8", errors="replace").splitlines()
        found = [*wrong_includes(root, file, lines), *wrong_words(root, file, lines)]
        if file.suffix in CPP:
            sizes[str(file)] = len(lines)
            found += wrong_size(root, file, lines)
        faults += [f"{file.relative_to(root)}:{number}: {fault}" for number, fault in found]
    long_files = {file: lines for file, lines in sizes.items() if lines > SOFT_LINES}
    return faults + list(wrong_tree(root, sizes)), long_files


def main():
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent.parent).resolve()
    faults, long_files = check(root)
    for file, lines in long_files.items():
        print(f"note: {file} has {lines} lines; beyond {SOFT_LINES} a file wants splitting")
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

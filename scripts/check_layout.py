#!/usr/bin/env python3
"""Checks that the tree keeps its layout: who may include whom, sizes of files, functions, folders and
pages, names, rooms of tests, forbidden words, one page of docs an algorithm, clang-format where it is
installed. Prints what is wrong, with file and line; exit code 1 if anything is.
  scripts/check_layout.py [ROOT]"""

import re
import shutil
import statistics
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import cpp_functions  # noqa: E402  (beside this script, wherever it is called from)

# Whose headers each folder may include: ARCHITECTURE.md, "arrows point downwards only". Folders not
# named here (tests) may include all.
ROOMS_BELOW = {
    "base": "",
    "exact/numbers": "base",
    "exact": "base exact/numbers",
    "exact/features": "exact/numbers exact",
    "exact/simplices": "exact/numbers exact",
    "kernels": "base exact exact/features",
    "grid": "base exact kernels",
    "lattice": "base exact/numbers exact grid",
    "reference": "base exact grid lattice",
    "engine": "base exact/numbers exact kernels grid",
    "periodic": "base exact kernels grid lattice engine",
    "elements": "base exact kernels grid lattice",
    "lists": "base exact kernels",
    "geometry": "base exact kernels",
    "skin": "base exact kernels grid lattice elements lists",
    "algorithms": "base exact grid reference engine periodic",
    "detect": (
        "base exact kernels grid reference engine periodic elements lists geometry skin algorithms"),
    "history": "base exact lattice elements geometry detect walls",
    "walls/grid": "base exact kernels elements",
    "walls": "base exact/features exact kernels lattice elements lists geometry detect walls/grid",
    "simplices": "base exact exact/simplices elements lists detect walls",
    "device/bodies": "base exact/numbers exact lattice",
    "device": "base exact grid lattice elements device/bodies",
    "device/copies": "base device",
    "device/cuda": "base exact device/bodies device",
    "device/host": "base device",
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
    "bindings/python": {"include/abut", "src/io", "src/io/read", "src/io/write"},
}
# What the core may include besides: headers of the standard library, which have no dot, and these.
SYSTEM_HEADERS = {"hwy/foreach_target.h", "hwy/highway.h", "hwy/targets.h", "omp.h", "pthread.h",
                  "sched.h", "signal.h", "sys/resource.h",
                  "malloc.h", "sys/mman.h", "unistd.h", "windows.h", "xmmintrin.h"}
# CUDA's headers stand in this room only.
CUDA_ROOM, CUDA_HEADER = "src/device/cuda", re.compile(r"(cuda_runtime\w*\.h|cub/.*|thrust/.*)$")

SOURCE_FOLDERS = ("include", "src", "scenes", "cli", "benchmarks", "examples", "tests", "bindings")
CPP = {".cpp", ".hpp", ".inl", ".h", ".cu", ".cuh"}
TEXT = CPP | {".py", ".md", ".cmake", ".txt", ".json", ".in", ".sh", ""}
MEDIAN_LINES, SOFT_LINES, HARD_LINES = 150, 400, 800
REFERENCE_LINES = 300  # an algorithm of the book is read beside the page
FUNCTION_LINES = 40
FOLDER_FILES = 35
PAGE_LINES, PAGE_COLUMNS = 300, 100

# What breaks a rule today and is to be worked off: (file, how its fault begins) -> why. An entry
# that is no longer needed is a fault.
EXCEPTIONS = {
    ("src/engine/tiles/tiles.cpp", "scatter_locals has"): "one line over; splits with its periodic twin",
    ("src/kernels/element_kernels_simd.cpp", "arrange_in has"): "the vector loop with its tail",
    ("src/kernels/images/image_kernels_simd.cpp", "wrap_in has"): "the vector loop with its tail",
    ("src/reference/screening_array.cpp", "screening_array has"): "read beside the book's page",
    ("tests/engine/tiles/sorted_tile_test.cpp", "SortedTileOf.Cells"): "one tile checked against all cells",
    ("tests/history/history_test.cpp", "HistoryInSpace.Knows"): "twenty steps of one system",
    ("tests/io/read_lammps_data_test.cpp", "ReadLammpsData.Errors"): "a table of inputs",
    ("tests/kernels/tile_search_test.cpp", "made_tile has"): "the parts of one tile",
    ("tests/kernels/tile_search_test.cpp", "TileKernelsTest.Search"): "one line over",
    ("tests/lattice/lattices.hpp", "random_lattice has"): "a table of shapes",
    ("tests/periodic/images_slack_test.cpp", "ImagesSlack.Covers"): "two lines over",
    ("tests/periodic/move_boxes_test.cpp", "MovedBoxes.AreOff"): "three lines over",
    ("tests/properties/skin_soak_test.cpp", "Soak.TwoThousand"): "one loop of steps",
}

# What no file may hold. The first pattern only names the words that it looks for.
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
            elif folder == CUDA_ROOM and CUDA_HEADER.match(name):
                continue
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
    if file.suffix in CPP and file.stem.endswith("_test") and file.is_relative_to(root / "src"):
        yield 1, "named like a test; tests lie in tests/"


def wrong_size(root, file, lines):
    limit = HARD_LINES
    if file.relative_to(root).as_posix().startswith("src/reference/"):
        limit = REFERENCE_LINES
    if len(lines) > limit:
        yield len(lines), f"{len(lines)} lines; the limit is {limit}: split it"


def wrong_functions(lines):
    for name, first, length in cpp_functions.functions("\n".join(lines)):
        if length > FUNCTION_LINES:
            yield first, f"{name} has {length} lines; the limit is {FUNCTION_LINES}: split it"


def shown(line):
    """The line of a page as it is read: links without their targets."""
    return re.sub(r"\]\([^)\s]*\)", "]", line)


def wrong_page(name, lines):
    if name == "CHANGELOG.md" or name.startswith("benchmarks/results/"):
        limit = len(lines)  # one only grows, the others are generated
    else:
        limit = PAGE_LINES
    if len(lines) > limit:
        yield len(lines), f"the page has {len(lines)} lines; the limit is {limit}: split it"
    in_code = False
    for number, line in enumerate(lines, 1):
        in_code ^= line.lstrip().startswith("```")
        if in_code or line.lstrip().startswith(("|", "```")) or re.match(r"\[[^]]+\]: ", line):
            continue
        if len(shown(line)) > PAGE_COLUMNS:
            yield number, f"prose wraps at {PAGE_COLUMNS} columns; here are {len(shown(line))}"


def wrong_rooms(root):
    """Folders of src with too many files, and those without a folder of tests."""
    folders = [root / "src", *sorted(f for f in (root / "src").rglob("*") if f.is_dir())]
    for folder in folders:
        files = [file for file in folder.iterdir() if file.suffix in CPP]
        name = folder.relative_to(root).as_posix()
        if len(files) > FOLDER_FILES:
            yield f"{name} has {len(files)} files; the limit is {FOLDER_FILES}: split the room"
        room = name.split("/")[1] if "/" in name else None
        if files and room and not (root / "tests" / room).is_dir():
            yield f"tests/{room} is missing: each room of src has its tests"


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


def unexpected(name, found):
    """The faults of a file as lines of text, but for its exceptions; those that do not occur too."""
    for key in [key for key in EXCEPTIONS if key[0] == name]:
        excepted = [(number, fault) for number, fault in found if fault.startswith(key[1])]
        if not excepted:
            found.append((1, f"'{key[1]}' is no longer a fault: take it out of EXCEPTIONS"))
        found = [entry for entry in found if entry not in excepted]
    return [f"{name}:{number}: {fault}" for number, fault in found]


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
            found += [*wrong_size(root, file, lines), *wrong_functions(lines)]
        elif file.suffix == ".md":
            found += wrong_page(file.relative_to(root).as_posix(), lines)
        faults += unexpected(file.relative_to(root).as_posix(), found)
    long_files = {file: lines for file, lines in sizes.items() if lines > SOFT_LINES}
    return faults + [*wrong_rooms(root), *wrong_tree(root, sizes)], long_files


def main():
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent.parent).resolve()
    faults, long_files = check(root)
    for file, lines in long_files.items():
        print(f"note: {file} has {lines} lines; beyond {SOFT_LINES} a file wants splitting")
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

"""scripts/check_layout.py finds what is planted, and nothing where nothing is."""

import importlib.util
from pathlib import Path

import pytest

SCRIPT = Path(__file__).parents[2] / "scripts/check_layout.py"
spec = importlib.util.spec_from_file_location("check_layout", SCRIPT)
check_layout = importlib.util.module_from_spec(spec)
spec.loader.exec_module(check_layout)

ROOMS = ("exact", "grid", "reference", "algorithms", "io", "base")
SOUND = {
    "include/abut/pair.hpp": "#pragma once\n",
    "src/base/bits.hpp": "#pragma once\n\n#include <abut/pair.hpp>\n\n#include <bit>\n",
    "src/grid/map.hpp": '#pragma once\n\n#include "base/bits.hpp"\n',
    "src/reference/direct_check.cpp": '#include "grid/map.hpp"\n',
    "src/algorithms/registry.cpp": "    {{Algorithm::direct_check, 1}},\n",
    "src/io/snapshot.hpp": "#pragma once\n\n#include <unistd.h>\n",
    "docs/algorithms/direct_check.md": "# direct_check\n",
    **{f"tests/{room}/CMakeLists.txt": "" for room in ROOMS},
    "cli/main.cpp": '#include "io/snapshot.hpp"\n',
}

PLANTED = [
    ("src/base/up.cpp", '#include "grid/map.hpp"\n', "src/base may not look into src/grid"),
    ("src/grid/up.cpp", '#include "reference/up.hpp"\n', "which is not there"),
    ("include/abut/up.hpp", '#pragma once\n#include "../../src/base/bits.hpp"\n',
     "include/abut may not look into src/base"),
    ("src/io/up.cpp", '#include "grid/map.hpp"\n', "src/io may not look into src/grid"),
    ("cli/up.cpp", '#include "base/bits.hpp"\n', "cli may not look into src/base"),
    ("examples/up.cpp", '#include "io/snapshot.hpp"\n', "examples may not look into src/io"),
    ("src/algorithms/foreign.cpp", "#include <fmt/format.h>\n", "needs the standard library only"),
    ("src/reference/talk.cpp", "void f() { std::cout << 1; }\n", "prints"),
    ("src/base/talk.cpp", 'void f() { std::printf("1"); }\n', "prints"),
    ("src/grid/end.cpp", "void f() { std::exit(1); }\n", "ends the process"),
    ("src/algorithms/read.cpp", "#include <fstream>\n", "includes input or output"),
    ("src/base/bare.hpp", "struct Bare {};\n", "without #pragma once"),
    ("tests/open.cpp", "// TO" "DO: more\n", "an open end"),
    ("docs/where.md", "see /ho" "me/me/abut\n", "an absolute path"),
    ("src/base/long.cpp", "\n" * 801, "the limit is 800"),
    ("src/reference/long.cpp", "\n" * 301, "the limit is 300"),
    ("src/grid/cell_test.hpp", "#pragma once\n", "named like a test"),
    ("src/grid/f.cpp", "int f() {\n" + "  g();\n" * 39 + "}\n", "f has 41 lines; the limit is 40"),
    ("src/grid/in.cpp", "struct S {\n  S() : a{1} {\n" + "    { g(); }\n" * 40 + "  }\n};\n",
     "S has 42 lines"),
    ("tests/grid/f_test.cpp", "TEST(Grid, IsLong) {\n" + "  f([] {});\n" * 40 + "}\n",
     "Grid.IsLong has 42 lines"),
    ("docs/long.md", "a line\n" * 301, "the page has 301 lines; the limit is 300"),
    ("docs/wide.md", "word " * 20 + "z\n", "prose wraps at 100 columns; here are 101"),
    ("src/alone/room.cpp", "\n", "tests/alone is missing"),
    ("src/algorithms/registry.cpp", "{{Algorithm::direct_check,\n{{Algorithm::rows,\n",
     "docs/algorithms/rows.md is missing"),
]


@pytest.fixture
def tree(tmp_path):
    for name, text in SOUND.items():
        plant(tmp_path, name, text)
    return tmp_path


def plant(root, name, text):
    file = root / name
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text)


def test_a_sound_tree_has_no_faults(tree):
    assert check_layout.check(tree) == ([], {})


@pytest.mark.parametrize("name,text,fault", PLANTED, ids=[row[0] for row in PLANTED])
def test_a_planted_fault_is_found(tree, name, text, fault):
    plant(tree, name, text)
    faults, _ = check_layout.check(tree)
    assert len(faults) == 1, faults
    assert fault in faults[0]


def test_long_files_are_named_and_a_large_median_is_a_fault(tree):
    plant(tree, "src/io/long.cpp", "\n" * 401)
    faults, long_files = check_layout.check(tree)
    assert faults == []
    assert [Path(file).name for file in long_files] == ["long.cpp"]
    for number in range(10):
        plant(tree, f"src/io/long_{number}.cpp", "\n" * 151)
    faults, _ = check_layout.check(tree)
    assert ["median" in fault for fault in faults] == [True]


SOUND_LINES = [
    ("src/grid/f.cpp", "int f() {\n" + "  g();\n" * 38 + "}\n"),
    ("src/grid/n.cpp", "namespace n {\n" + "int a = f();\n" * 50 + "}\n"),
    ("src/grid/t.cpp", "const T table{\n" + "    {f(1), 2},\n" * 50 + "};\n"),
    ("src/grid/c.cpp", "// f() {\n" + "const char* s = \"g() {\";\n" * 50),
    ("docs/table.md", "| " + "word " * 30 + "|\n"),
    ("docs/code.md", "```text\n" + "word " * 30 + "\n```\n"),
    ("docs/link.md", "See [the page](" + "f/" * 50 + "g.md) of it.\n"),
]


@pytest.mark.parametrize("name,text", SOUND_LINES, ids=[row[0] for row in SOUND_LINES])
def test_what_is_within_the_rules_is_no_fault(tree, name, text):
    plant(tree, name, text)
    assert check_layout.check(tree) == ([], {})


def test_a_folder_with_too_many_files_is_a_fault(tree):
    for number in range(35):
        plant(tree, f"src/grid/part_{number}.cpp", "\n")
    faults, _ = check_layout.check(tree)
    assert ["src/grid has 36 files" in fault for fault in faults] == [True]


def test_an_exception_holds_until_it_is_not_needed(tree, monkeypatch):
    monkeypatch.setattr(check_layout, "EXCEPTIONS", {("src/grid/f.cpp", "f has"): "a reason"})
    plant(tree, "src/grid/f.cpp", "int f() {\n" + "  g();\n" * 39 + "}\n")
    assert check_layout.check(tree) == ([], {})
    plant(tree, "src/grid/f.cpp", "int f() {}\n")
    faults, _ = check_layout.check(tree)
    assert ["take it out of EXCEPTIONS" in fault for fault in faults] == [True]


def test_the_exit_code_tells(tree):
    import subprocess
    import sys

    command = [sys.executable, str(SCRIPT), str(tree)]
    assert subprocess.run(command).returncode == 0
    plant(tree, *PLANTED[0][:2])
    assert subprocess.run(command).returncode == 1

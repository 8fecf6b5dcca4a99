"""scripts/check_includes.py names the standard headers that a file lacks, and inserts them."""

import importlib.util
from pathlib import Path

import pytest

SCRIPT = Path(__file__).parents[2] / "scripts/check_includes.py"
spec = importlib.util.spec_from_file_location("check_includes", SCRIPT)
check_includes = importlib.util.module_from_spec(spec)
spec.loader.exec_module(check_includes)

LACKING = [
    ("std::vector<int> f();\n", {"vector"}),
    ("#include <vector>\nstd::vector<std::string> f();\n", {"string"}),
    ("int f() { return std::min(1, 2); }\n", {"algorithm"}),
    ("void f(std::chrono::seconds);\n", {"chrono"}),
    ("auto f() { return std::ranges::sort; }\n", {"algorithm"}),
    ("std::size_t f();\n", {"array"}),
]
COMPLETE = [
    "#include <vector>\nstd::vector<int> f();\n",
    "#include <span>\nstd::size_t f(std::span<int>);\n",
    "#include <cmath>\nint f() { return std::abs(1); }\n",
    "// std::vector\nconst char* text = \"std::vector\";\n",
    "#include <iostream>\nstd::ostream& f();\n",
]


@pytest.mark.parametrize("text,headers", LACKING)
def test_a_lacking_header_is_named(tmp_path, text, headers):
    file = tmp_path / "a.hpp"
    file.write_text(text)
    assert set(check_includes.missing_headers(file)) == headers


@pytest.mark.parametrize("text", COMPLETE)
def test_what_is_included_or_no_code_is_not_named(tmp_path, text):
    file = tmp_path / "a.hpp"
    file.write_text(text)
    assert check_includes.missing_headers(file) == {}


def test_a_source_has_what_its_own_header_includes(tmp_path):
    (tmp_path / "a.hpp").write_text("#include <vector>\n")
    source = tmp_path / "a.cpp"
    source.write_text('#include "a.hpp"\nstd::vector<int> f() { return {}; }\n')
    assert check_includes.missing_headers(source) == {}
    other = tmp_path / "b.cpp"
    other.write_text('#include "a.hpp"\nstd::vector<int> f() { return {}; }\n')
    assert set(check_includes.missing_headers(other)) == {"vector"}


def test_mending_sorts_into_the_block_of_standard_headers(tmp_path):
    file = tmp_path / "a.cpp"
    file.write_text('#include "b.hpp"\n\n#include <map>\n#include <vector>\n\n#if 1\n'
                    "#include <omp.h>\n#endif\nstd::string f();\n")
    check_includes.mend(file, check_includes.missing_headers(file))
    assert "#include <map>\n#include <string>\n#include <vector>\n\n#if 1" in file.read_text()


def test_mending_makes_a_block_behind_the_includes(tmp_path):
    file = tmp_path / "a.cpp"
    file.write_text('#include "b.hpp"\n\n#if 1\n#include <omp.h>\n#endif\nstd::string f();\n')
    check_includes.mend(file, check_includes.missing_headers(file))
    assert file.read_text().startswith('#include "b.hpp"\n\n#include <string>\n\n#if 1\n')

"""scripts/mutate tells faults that a test sees from others, and sound tables from others."""

import importlib.machinery
import importlib.util
import subprocess
from pathlib import Path

import pytest

SCRIPT = Path(__file__).parents[2] / "scripts/mutate"
loader = importlib.machinery.SourceFileLoader("mutate", str(SCRIPT))
loader.exec_module(mutate := importlib.util.module_from_spec(
    importlib.util.spec_from_loader("mutate", loader)))

# A project without a compiler: building copies a file, unless it says "broken".
PROJECT = """
cmake_minimum_required(VERSION 3.25)
project(tiny LANGUAGES NONE)
enable_testing()
add_custom_target(value.txt COMMAND ${CMAKE_COMMAND} -D IN=${CMAKE_SOURCE_DIR}/value.txt
  -D OUT=${CMAKE_BINARY_DIR}/value.txt -P ${CMAKE_SOURCE_DIR}/copy.cmake)
add_test(NAME value.is_right COMMAND ${CMAKE_COMMAND} -E compare_files
  ${CMAKE_SOURCE_DIR}/right.txt ${CMAKE_BINARY_DIR}/value.txt)
add_test(NAME value.is_there COMMAND ${CMAKE_COMMAND} -E cat ${CMAKE_BINARY_DIR}/value.txt)
add_test(NAME other.is_right COMMAND ${CMAKE_COMMAND} -E compare_files
  ${CMAKE_SOURCE_DIR}/right.txt ${CMAKE_BINARY_DIR}/other.txt)
add_test(NAME slow.is_right COMMAND ${CMAKE_COMMAND} -E compare_files
  ${CMAKE_SOURCE_DIR}/right.txt ${CMAKE_BINARY_DIR}/value.txt)
set_tests_properties(slow.is_right PROPERTIES LABELS full)
set_tests_properties(value.is_right value.is_there other.is_right PROPERTIES LABELS fast)
"""
COPY = """
file(READ ${IN} text)
if(text MATCHES broken)
  message(FATAL_ERROR "no")
endif()
file(WRITE ${OUT} "${text}")
"""
HEAD = "# Faults\n\nWords that stay.\n"


def entry(name="wrong", text="one", becomes="two", tests="value", file="value.txt"):
    return (f'[[fault]]\nname = "{name}"\nwhat = "something"\nfile = "{file}"\ntext = "{text}"\n'
            f'becomes = "{becomes}"\ntargets = ["value.txt"]\ntests = "{tests}"\n')


@pytest.fixture
def tree(tmp_path):
    """A function that makes the project with these entries."""
    def make(*entries, rows=()):
        files = {"CMakeLists.txt": PROJECT, "copy.cmake": COPY, "value.txt": "one and a half\n",
                 "right.txt": "one and a half\n", ".gitignore": "/build-*/\n",
                 "tests/mutation/part.toml": "".join(entries),
                 "docs/mutation.md": HEAD + "\n| fault |\n" + "".join(f"| `{r}` |\n" for r in rows)}
        for name, text in files.items():
            (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
            (tmp_path / name).write_text(text)
        subprocess.run(["git", "init", "-q", tmp_path], check=True)
        return tmp_path
    return make


PLANTED = [
    ([entry(text="three")], "occurs 0 times in value.txt"),
    ([entry(text="a")], "occurs 3 times in value.txt"),
    ([entry(becomes="one")], "the replacement is the text itself"),
    ([entry(file="other.txt")], "other.txt is not there"),
    ([entry(tests="(")], "missing )"),
    ([entry(), entry()], "wrong: two faults of that name"),
    ([entry("unshown")], "unshown: no row in docs/mutation.md"),
    ([], "docs/mutation.md has a row, the tables have no such fault"),
]


@pytest.mark.parametrize("entries,sentence", PLANTED)
def test_a_table_that_does_not_fit_is_told(tree, capsys, entries, sentence):
    root = tree(*entries or [entry("other")], rows=["wrong"])
    assert mutate.main(["--check"], root) == 1
    assert sentence in capsys.readouterr().out


def test_a_sound_table_is_told_too(tree, capsys):
    assert mutate.main(["--check"], tree(entry(), rows=["wrong"])) == 0
    assert capsys.readouterr().out == ""


@pytest.mark.parametrize("words", ['name = "wrong"\n', entry() + "more = 1\n"])
def test_an_entry_with_too_few_or_too_many_words_is_named(tree, capsys, words):
    root = tree("[[fault]]\n" * (words[0] != "[") + words)
    assert mutate.main(["--check"], root) == 1
    assert "part.toml: wrong: " in capsys.readouterr().err


def test_a_name_that_is_none_is_an_error(tree, capsys):
    assert mutate.main(["right"], tree(entry())) == 1
    assert "no fault is called right" in capsys.readouterr().err


def test_a_fault_that_a_test_sees_is_caught_and_undone(tree, capsys):
    root = tree(entry("first"), entry("second"))
    assert mutate.main([], root) == 0
    out = capsys.readouterr().out
    assert "first: caught by value.is_right" in out and "second: caught by value.is_right" in out
    assert (root / "value.txt").read_text() == "one and a half\n"
    assert (root / "build-mutate/tree/value.txt").read_text() == "one and a half\n"


@pytest.mark.parametrize("fault,outcome", [
    (entry(tests="is_there"), "wrong: SURVIVED"),
    (entry(becomes="broken"), "wrong: FAILED: wrong: does not build"),
])
def test_a_fault_that_no_test_sees_fails(tree, capsys, fault, outcome):
    root = tree(fault, entry("sound", tests="is_right"))
    assert mutate.main(["wrong"], root) == 1
    assert outcome in capsys.readouterr().out


@pytest.mark.parametrize("tests", ["is_elsewhere", "^other"])
def test_without_a_test_of_what_was_built_nothing_is_said(tree, capsys, tests):
    assert mutate.main([], tree(entry(tests=tests))) == 1
    said = capsys.readouterr()
    assert said.out == "" and f"wrong: value.txt has no test {tests}" in said.err


@pytest.mark.parametrize("tests,catchers", [("^slow", "slow.is_right"), ("is_right", "value.is_right")])
def test_full_tests_run_only_where_no_fast_one_is_named(tree, capsys, tests, catchers):
    assert mutate.main([], tree(entry(tests=tests))) == 0
    assert f"wrong: caught by {catchers} (" in capsys.readouterr().out


def test_repeated_tests_are_told_once():
    told = ("The following tests FAILED:\n\t  7 - A.B<std::integral_constant<int, 2>> (Failed)\n"
            "\t 18 - A.B<std::integral_constant<int, 3>> (SEGFAULT)\n\t111 - In/C.D/0 (Failed)\n"
            "\t112 - In/C.D/rows (Timeout) fast\n\t113 - io.e (Failed)   fast\nErrors while\n")
    assert mutate.failed_names(told) == ["A.B", "C.D", "io.e"]


def test_without_a_fault_all_tests_must_pass(tree, capsys):
    root = tree(entry())
    (root / "right.txt").write_text("another\n")
    assert mutate.main([], root) == 1
    assert "fails without any fault: value.is_right" in capsys.readouterr().err


def test_what_changed_is_copied_and_what_is_gone_removed(tree):
    root = tree(entry())
    copy = root / "build-mutate/tree"
    mutate.copy_tree(root, copy)
    before = (copy / "right.txt").stat().st_mtime_ns
    (root / "value.txt").write_text("one\n")
    (root / "copy.cmake").unlink()
    mutate.copy_tree(root, copy)
    assert (copy / "value.txt").read_text() == "one\n"
    assert not (copy / "copy.cmake").exists() and not (copy / "build-mutate").exists()
    assert (copy / "right.txt").stat().st_mtime_ns == before


def test_the_report_has_a_row_for_each_fault_that_was_caught(tree, capsys):
    root = tree(entry(), rows=["old"])
    assert mutate.main(["--report"], root) == 1
    assert "wrong: not caught yet" in capsys.readouterr().err
    mutate.main([], root)
    assert mutate.main(["--report"], root) == 0
    assert (root / "docs/mutation.md").read_text() == HEAD + (
        "\n| fault | what goes wrong (part) | caught by |\n| --- | --- | --- |\n"
        "| `wrong` | something (part) | `value.is_right` |\n")
    # A fault that has changed since has not been caught.
    (root / "tests/mutation/part.toml").write_text(entry(becomes="three"))
    assert mutate.main(["--report"], root) == 1

"""scripts/check_vocabulary.py knows the words of the record and the plain ones, and no others."""

import importlib.util
from pathlib import Path

import pytest

SCRIPT = Path(__file__).parents[2] / "scripts/check_vocabulary.py"
spec = importlib.util.spec_from_file_location("check_vocabulary", SCRIPT)
check_vocabulary = importlib.util.module_from_spec(spec)
spec.loader.exec_module(check_vocabulary)


@pytest.fixture
def tree(tmp_path):
    """A tree whose only type is SearchSet, of one recorded word and one plain one."""
    for folder in ("docs/adr", "scripts", "src/engine"):
        (tmp_path / folder).mkdir(parents=True)
    (tmp_path / "docs/adr/0002-vocabulary.md").write_text("| word | meaning |\n| set | many |\n")
    (tmp_path / "scripts/plain_words.txt").write_text("search\n")
    (tmp_path / "src/engine/search_set.hpp").write_text("struct SearchSet {};\n")
    return tmp_path


def test_known_words_are_good(tree):
    assert check_vocabulary.check(tree) == []


@pytest.mark.parametrize("name", ["SearchCrew", "CrewOfSets", "Crew"])
def test_unknown_word_is_a_fault(tree, name):
    (tree / "src/engine/crew.hpp").write_text(f"class {name} final {{}};\n")
    assert any("'crew'" in fault and name in fault for fault in check_vocabulary.check(tree)
               if "crew.hpp" in fault)


def test_plural_of_a_known_word_is_known(tree):
    (tree / "src/engine/sets.hpp").write_text("struct SearchSets {};\n")
    assert check_vocabulary.check(tree) == []


def test_plain_word_without_a_type_is_a_fault(tree):
    (tree / "scripts/plain_words.txt").write_text("search\nsnapshot\n")
    assert check_vocabulary.check(tree) == ["scripts/plain_words.txt: no type uses 'snapshot'"]


def test_plain_word_of_the_record_is_a_fault(tree):
    (tree / "scripts/plain_words.txt").write_text("search\nset\n")
    assert check_vocabulary.check(tree) == ["scripts/plain_words.txt: 'set' is in the record, too"]


def test_name_defined_twice_is_a_fault(tree):
    (tree / "src/engine/other.hpp").write_text("struct SearchSet {\n};\n")
    assert check_vocabulary.check(tree) == [
        "src/engine/other.hpp, src/engine/search_set.hpp: each defines a type SearchSet; "
        "give each its own name"]


def test_name_declared_elsewhere_is_none(tree):
    (tree / "src/engine/other.hpp").write_text("struct SearchSet;\n// class Crew {\n")
    assert check_vocabulary.check(tree) == []

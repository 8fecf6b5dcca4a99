#!/usr/bin/env python3
"""Fails for a word in a type name of src that is neither in the record of words (docs/adr/0002) nor
among the plain English ones (scripts/plain_words.txt), for a plain word that no type uses, and for
a type name that is defined in two files of src.
  scripts/check_vocabulary.py [ROOT]"""

import re
import sys
from pathlib import Path

PLAIN = "scripts/plain_words.txt"
TYPE = re.compile(
    r"\b(?:struct|class|enum class|enum|union)\s+(?:alignas\([^)]*\)\s+)?(?:\[\[\w+\]\]\s+)?"
    r"(?:ABUT_API\s+)?([A-Z]\w+)((?:\s+final)?\s*(?:\{|:[^:]))?")
WORD = re.compile(r"[A-Z][a-z0-9]*|[0-9]+[A-Za-z]*")




def types_of(root):
    """Each type name that src declares or defines, with the files that define it."""
    types = {}
    for file in sorted((root / "src").rglob("*.[ch]pp")):
        text = re.sub(r"//[^\n]*", "", file.read_text(encoding="utf-8"))
        for name, body in TYPE.findall(text):
            files = types.setdefault(name, [])
            place = file.relative_to(root).as_posix()
            if body and place not in files:
                files.append(place)
    return types


def words_of(name):
    return [word.lower() for word in WORD.findall(name)]


def recorded_words(root):
    """Words of the first column of the record's tables."""
    page = (root / "docs/adr/0002-vocabulary.md").read_text(encoding="utf-8")
    entries = re.findall(r"^\| ([^|]+) \|", page, re.MULTILINE)
    return {word for entry in entries for word in re.findall(r"[a-z]+", entry.lower())}


def singular(word):
    if word.endswith(("ches", "sses")):
        return word[:-2]
    if word.endswith("s") and not word.endswith(("ss", "us", "xis")):
        return word[:-1]
    return word


def faults_of_names(types, known):
    """Type names with unknown words, and those defined twice."""
    for name, files in sorted(types.items()):
        for word in words_of(name):
            if not {word, singular(word)} & known:
                yield (f"{', '.join(files)}: '{word}' of {name} is in no record of words; use a word "
                       "of docs/adr/0002-vocabulary.md or add it there")
        if len(files) > 1:
            yield f"{', '.join(files)}: each defines a type {name}; give each its own name"


def check(root):
    record = recorded_words(root)
    plain = set((root / PLAIN).read_text(encoding="utf-8").split())
    types = types_of(root)
    faults = list(faults_of_names(types, record | plain))
    used = {form for name in types for word in words_of(name) for form in (word, singular(word))}
    faults += [f"{PLAIN}: no type uses '{word}'" for word in sorted(plain - used)]
    faults += [f"{PLAIN}: '{word}' is in the record, too" for word in sorted(plain & record)]
    return faults


def main():
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parents[1]).resolve()
    faults = check(root)
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

"""Checks that the tables of public calls (public_calls.cpp and what it adds) have all that the library
exports and that may run out of memory: python3 check_public_calls.py LIBRARY TABLE... Prints what is
missing."""

import collections
import re
import subprocess
import sys

# These allocate nothing, or are inner parts that exported classes drag along.
NOTHING_ALLOCATED = re.compile(r"""
    .*::~\w+ | .*::operator= | .*::State::\w+ |
    abut::Detector::(options|set_options|skin|skin_statistics|take_neighbors|take_pairs) |
    abut::Error::Error | abut::ExclusionList::(contains|fill) | abut::GroupTable::(deny_all|set) |
    abut::detail::ContactMatcher::(accept|born|flipped|keeps_order|lost) |
    abut::detail::WallMatcher::(accept|before|born|lost|passed_on) |
    abut::detail::(allocate_pages|free_pages) |
    abut::(algorithms|available|name_of|simd_levels|version)
    """, re.VERBOSE)


def exported(library):
    """Of each function that is exported the number of its forms."""
    lines = subprocess.run(["nm", "-DC", "--defined-only", library], check=True,
                           capture_output=True, text=True).stdout.splitlines()
    forms = collections.defaultdict(set)
    for line in lines:
        kind, signature = line.split(" ", 2)[1:]
        name = re.split(r"[(\[]", signature)[0]
        moves = re.search(r"::(\w+)\(abut::(\w+::)*\1&&\)$", signature)
        if kind == "T" and name.startswith("abut::") and not moves:
            forms[name].add(signature)
    return {name: len(signatures) for name, signatures in forms.items()}


def main(library, *tables):
    rows = collections.Counter()
    for table in tables:
        with open(table) as file:
            rows.update(re.findall(r'"(abut::[\w:]+)"', file.read()))
    public = exported(library)
    wrong = [f"{name}: {rows[name]} rows for {forms} forms; add one to {tables[0]}"
             for name, forms in public.items()
             if rows[name] < forms and not NOTHING_ALLOCATED.fullmatch(name)]
    wrong += [f"{name} is in a table, but not exported" for name in rows if name not in public]
    print("\n".join(sorted(wrong)))
    return 1 if wrong or not public else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))

"""Completions and the manual page: made from the option tables, taken by their readers."""

import re
import shutil
import subprocess

import pytest

COMMANDS = ["contacts", "neighbors", "info", "generate", "compare", "bench", "explain",
            "algorithms", "completion"]

# What is typed, the word that is completed last, and what must and must not be offered.
CASES = [
    (["co"], {"contacts", "compare", "completion"}, {"bench"}),
    (["--vers"], {"--version"}, {"--verbose"}),
    (["contacts", "--al"], {"--algorithm"}, {"--against"}),
    (["contacts", "--algorithm", "m"], {"munjiza_nbs"}, {"rows"}),
    (["contacts", "--algorithm", "a"], {"auto"}, {"rows"}),
    (["contacts", "--order", ""], {"canonical", "as_found"}, set()),
    (["contacts", "pack"], {"packing.csv"}, {"other.csv"}),
    (["contacts", "packing.csv", "-o", "oth"], {"other.csv"}, {"packing.csv"}),
    (["explain", "bin"], {"binary_tree"}, set()),
    (["generate", "touching_f"], {"touching_fcc"}, {"dense"}),
    (["completion", ""], {"bash", "zsh", "fish", "man"}, set()),
]

BASH = """
source "$0"
COMP_WORDS=(abut "$@"); COMP_CWORD=$#
_abut
printf '%s\\n' "${COMPREPLY[@]}"
"""


def shell(name):
    found = shutil.which(name)
    if not found:
        pytest.skip(f"{name} is not installed")
    return found


@pytest.fixture
def folder(abut, tmp_path):
    for name in ("packing.csv", "other.csv"):
        (tmp_path / name).write_text("")
    return tmp_path


def check(offered, wanted, unwanted):
    assert wanted <= offered and not unwanted & offered, offered


@pytest.mark.parametrize("words, wanted, unwanted", CASES)
def test_bash(abut, folder, words, wanted, unwanted):
    script = folder / "script"
    script.write_text(abut("completion", "bash").stdout)
    done = subprocess.run([shell("bash"), "-c", BASH, script, *words], cwd=folder, check=True,
                          capture_output=True, text=True)
    assert done.stderr == ""
    check(set(done.stdout.split()), wanted, unwanted)


@pytest.mark.parametrize("words, wanted, unwanted", CASES)
def test_fish(abut, folder, words, wanted, unwanted):
    (folder / "script").write_text(abut("completion", "fish").stdout)
    line = " ".join(["abut", *words])
    done = subprocess.run([shell("fish"), "-c", f"source script; complete -C '{line}'"], cwd=folder,
                          check=True, capture_output=True, text=True)
    check({offer.split("\t")[0] for offer in done.stdout.splitlines()}, wanted, unwanted)


# `_arguments` and `_describe` of zsh in place of a terminal: what they are told.
ZSH = """
compdef() { }
_arguments() { print -rl -- "$@"; state=$wanted_state }
_describe() { print -rl -- "$commands[@]" }
source $1
wanted_state=command; words=(abut ''); _abut
for command in $commands_to_try; do wanted_state=rest; words=($command ''); _abut; done
"""


def test_zsh(abut, folder):
    script = folder / "_abut"
    script.write_text(abut("completion", "zsh").stdout)
    subprocess.run([shell("zsh"), "-n", script], check=True)
    program = f"commands_to_try=({' '.join(COMMANDS)})\n" + ZSH
    done = subprocess.run([shell("zsh"), "-f", "-c", program, "zsh", script], check=True,
                          capture_output=True, text=True)
    assert done.stderr == ""
    lines = done.stdout.splitlines()
    for command in COMMANDS:
        assert any(line.startswith(command + ":") for line in lines), command
    told = "\n".join(lines)
    assert re.search(r"^--order\[.*\]:canonical\|as_found:\(canonical as_found\)$", told, re.M)
    assert re.search(r"^:ALGORITHM:\(direct_check .*\)$", told, re.M)
    assert re.search(r"^:FILE:_files$", told, re.M)


def test_manual_page(abut, folder):
    """Every option of every help text stands in it, and troff has nothing to complain of."""
    page = folder / "abut.1"
    page.write_text(abut("completion", "man").stdout)
    done = subprocess.run([shell("man"), "--warnings", "-E", "UTF-8", "-l", page], check=True,
                          capture_output=True, env={"MANWIDTH": "100", "PATH": "/usr/bin:/bin"})
    assert done.stderr == b""
    shown = done.stdout.decode()
    for command in COMMANDS:
        for option in re.findall(r"^  (?:-\w, )?(--[\w-]+)", abut(command, "--help").stdout, re.M):
            assert option in shown, (command, option)

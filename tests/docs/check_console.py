"""Runs every console block of the pages and compares what it shows with what is printed.

The blocks of a page run one after the other in one empty folder that holds examples/data. Standard
output and standard error are shown together, as on a terminal. A command may fail only where the
next one is `echo $?`. A line `...` stands for any lines. Durations are masked, and what follows the
tuning of `rows`: bytes of memory and its candidate tests; so are all numbers of `bench`, and which
algorithm was the best.
"""

import argparse
import contextlib
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import blocks

MARK = "@@ next command @@"
COMMANDS = ("contacts", "neighbors", "info", "generate", "compare", "bench", "explain", "algorithms")


def commands_of(block):
    """[(command, shown lines)]; a command may go on with a backslash."""
    result, open_command = [], False
    for line in block.text.splitlines():
        if open_command:
            result[-1][0] += "\n" + line
        elif line.startswith("$ "):
            result.append([line[2:], []])
        elif not result:
            raise blocks.PageError(f"{block.where()}: a console block begins with '$ '")
        else:
            result[-1][1].append(line)
            continue
        open_command = line.endswith("\\")
    return result


def masked(line):
    """A line with durations, bytes, tests of `rows` masked, and runs of blanks as one."""
    line = re.sub(r'("(?:\w+_)?(?:read|search|write|total|seconds|gather|order)": ?)[-+.e\d]+',
                  r"\1<time>", line)
    line = re.sub(r"^( *\w+ +\d+ +(?:canonical|as_found) ).*", r"\1<work>", line)
    line = re.sub(r"^ *\w+ +\d+ +(count|half list|full list) .*", r"<best> \1 <work>", line)
    line = re.sub(r"\b\d+(\.\d+)?(e[-+]\d+)? ?(ns|µs|us|ms|s)\b", "<time>", line)
    line = re.sub(r"\b\d+(\.\d+)? [kMG]?B\b", "<bytes>", line)
    line = re.sub(r'("(?:peak_bytes|candidate_tests)": ?)\d+', r"\1<work>", line)
    line = re.sub(r"\b[\d,]+ (candidate tests)", r"<work> \1", line)
    line = re.sub(r"^( *rows .*<bytes>) +[\d,]+", r"\1 <work>", line)
    return re.sub(r"[ \t]+", " ", line).strip()


def matches(shown, printed):
    """Whether lines match, `...` standing for any lines."""
    if not shown:
        return not printed
    if shown[0] == "...":
        return any(matches(shown[1:], printed[k:]) for k in range(len(printed) + 1))
    return bool(printed) and shown[0] == printed[0] and matches(shown[1:], printed[1:])


def run(commands, folder, environment):
    """Runs the commands in one shell; returns [(exit code, printed lines)]."""
    script = "last=0\n"
    for command, _ in commands:
        script += f"(exit $last)\n{command}\nlast=$?\necho\necho '{MARK}' $last\n"
    done = subprocess.run(["bash", "-c", script], cwd=folder, env=environment, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          stdin=subprocess.DEVNULL, timeout=120, check=False)
    result, lines = [], []
    for line in done.stdout.splitlines():
        if line.startswith(MARK):
            while lines and not lines[-1]:
                lines.pop()
            result.append((int(line.split()[-1]), lines))
            lines = []
        else:
            lines.append(line)
    return result


def check(block, folder, environment):
    """Problems of one block."""
    commands = commands_of(block)
    results = run(commands, folder, environment)
    problems = []
    for k, ((command, shown), (code, printed)) in enumerate(zip(commands, results)):
        code_is_shown = k + 1 < len(commands) and commands[k + 1][0] == "echo $?"
        if code != 0 and not code_is_shown:
            problems.append(f"{block.where()}: `{command}` ends with {code}")
        while shown and not shown[-1]:
            shown.pop()
        if not matches([masked(s) for s in shown], [masked(p) for p in printed]):
            problems.append(f"{block.where()}: `{command}` prints\n" + "\n".join(printed) +
                            "\ninstead of\n" + "\n".join(shown))
    if len(results) != len(commands):
        problems.append(f"{block.where()}: only {len(results)} of {len(commands)} commands ran")
    return problems


def environment_with(tool):
    """What the commands of a page find: the tool, and no terminal."""
    folder = pathlib.Path(tool).resolve().parent
    return {**os.environ, "PATH": f"{folder}:/usr/bin:/bin", "COLUMNS": "100", "NO_COLOR": "1"}


@contextlib.contextmanager
def page_folder(root):
    """The folder that the commands of a page run in."""
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "examples").symlink_to(root / "examples")
        yield folder


def check_flags(root, environment):
    """Flags that the help texts know and docs/cli.md does not, or the other way round."""
    def help_of(*command):
        return subprocess.run(["abut", *command, "--help"], env=environment, text=True, check=True,
                              stdout=subprocess.PIPE).stdout

    texts = [help_of()] + [help_of(command) for command in COMMANDS]
    known = set(re.findall(r"--[a-z][-a-z]+", " ".join(texts)))
    told = set(re.findall(r"--[a-z][-a-z]+", (root / "docs" / "cli.md").read_text("utf-8")))
    return [f"docs/cli.md: {flag} is in a help text but not here" for flag in known - told] + \
           [f"docs/cli.md: {flag} is in no help text" for flag in told - known]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--root", required=True)
    parser.add_argument("--tool", required=True)
    arguments = parser.parse_args()
    root = pathlib.Path(arguments.root).resolve()
    environment = environment_with(arguments.tool)

    problems, checked = check_flags(root, environment), 0
    for page in blocks.pages(root):
        with page_folder(root) as folder:
            for block in blocks.blocks_of(page):
                if block.language == "console":
                    checked += 1
                    problems += check(block, folder, environment)
    for problem in problems:
        print(problem)
    print(f"{checked} console blocks, {len(problems)} problems")
    return 1 if problems or checked == 0 else 0


if __name__ == "__main__":
    sys.exit(main())

"""Runs every console block of the pages and compares what it shows with what is printed.

The blocks of a page run one after the other in one empty folder that holds examples/data. Standard
output and standard error are shown together, as on a terminal. A command may fail only where the
next one is `echo $?`. A line `...` stands for any lines. Durations and bytes of memory stand as `…`;
all else must be what the tool prints. record_console.py writes the pages so.
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


TIME = r"\b\d+(?:\.\d+)?(?:e[-+]\d+)? ?(?:ns|µs|us|ms|s)\b"
BYTES = r"\b\d+(?:\.\d+)? [kMG]?B\b"
JSON_TIME = r'(?<=")((?:\w+_)?(?:read|search|write|total|seconds|gather|order)": ?)[-+.e\d]+'
JSON_BYTES = r'(?<=")((?:peak|working)_bytes": ?)\d+'
PROGRESS = r"abut: \w+ after \d+:\d\d"  # a line every 10 seconds, on a machine that is busy
BENCH = (r"^( *\w+ +\d+ +(?:canonical|as_found|count|half list|full list))"
         r"((?: +[\d.,]+){3})( +[\d.,]+)( +[\d.,]+)$")


def dots(match):
    """The mark; as wide as what it hides where that is a cell of a table."""
    before, after = match.string[:match.start()], match.string[match.end():]
    in_table = before.endswith("  ") and (not after or after.startswith("  "))
    return "…".rjust(len(match[0])) if in_table else "…"


def dotted(numbers):
    """A mark for each of some numbers in columns."""
    return re.sub(r"[\d.,]+", lambda match: "…".rjust(len(match[0])), numbers)


def masked(line):
    """A line as pages show it: what differs from run to run or from machine to machine is `…`."""
    line = re.sub(BENCH, lambda m: m[1] + dotted(m[2]) + m[3] + dotted(m[4]), line)
    line = re.sub(JSON_TIME, r"\1…", line)
    line = re.sub(JSON_BYTES, r"\1…", line)
    return re.sub(f"{TIME}|{BYTES}", dots, line)


def comparable(line):
    """A masked line with runs of blanks as one, and without the name of the fastest algorithm."""
    line = re.sub(r"^ *\w+ +(\d+ +(?:count|half list|full list) )", r"<best> \1", masked(line))
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
        elif not re.match(PROGRESS, line):
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
        if any(masked(line) != line for line in shown):
            problems.append(f"{block.where()}: `{command}` shows a time or bytes of memory; run "
                            "tests/docs/record_console.py")
        if not matches([comparable(s) for s in shown], [comparable(p) for p in printed]):
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

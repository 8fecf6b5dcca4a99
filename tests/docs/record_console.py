"""Writes into the console blocks of the pages what their commands print now:

    tests/docs/record_console.py build/bin/abut docs/cli.md README.md

A command whose shown lines hold `...` keeps them; read the difference before you commit it.
"""

import pathlib
import sys

import blocks
import check_console

ROOT = pathlib.Path(__file__).resolve().parents[2]


def recorded(block, folder, environment):
    """The lines of the block with the output of now."""
    commands = check_console.commands_of(block)
    lines = []
    for (command, shown), (_, printed) in zip(
            commands, check_console.run(commands, folder, environment)):
        same = check_console.matches([check_console.masked(s) for s in shown],
                                     [check_console.masked(p) for p in printed])
        keep = same or "..." in shown
        lines += f"$ {command}".split("\n") + (shown if keep else [p.rstrip() for p in printed])
    return lines


def record(page, environment):
    text = page.read_text(encoding="utf-8").split("\n")
    with check_console.page_folder(ROOT) as folder:
        found = [(block, recorded(block, folder, environment))
                 for block in blocks.blocks_of(page) if block.language == "console"]
    for block, lines in reversed(found):
        text[block.line:block.line + block.text.count("\n")] = lines
    page.write_text("\n".join(text), encoding="utf-8")


def main():
    tool, *pages = sys.argv[1:]
    for page in pages:
        record(pathlib.Path(page), check_console.environment_with(tool))


if __name__ == "__main__":
    main()

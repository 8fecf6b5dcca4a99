"""Writes into the console blocks of all pages what their commands print now:

    tests/docs/record_console.py build/bin/abut [PAGE...]

Durations and bytes of memory become `…`. A command whose shown lines hold `...` keeps them, and is
named where they no longer fit. Read the difference before you commit it.
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
        now = [check_console.masked(line.rstrip()) for line in printed]
        same = check_console.matches([check_console.comparable(s) for s in shown],
                                     [check_console.comparable(p) for p in printed])
        if "..." in shown and not same:
            print(f"{block.where()}: `{command}` prints something else; mend it by hand")
        lines += f"$ {command}".split("\n") + (shown if "..." in shown else now)
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
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    tool, *pages = sys.argv[1:]
    for page in map(pathlib.Path, pages) if pages else blocks.pages(ROOT):
        record(page, check_console.environment_with(tool))


if __name__ == "__main__":
    main()

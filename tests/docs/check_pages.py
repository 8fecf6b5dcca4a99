"""Checks the pages themselves: lengths, links, paths and arrays named in the text, pictures."""

import argparse
import pathlib
import re
import sys

import blocks

LONGEST = {"README.md": 150, "ARCHITECTURE.md": 250}
LONGEST_OTHER = 300
LARGEST_PICTURE = 300_000
FOLDERS = ("include/", "src/", "cli/", "scenes/", "tests/", "benchmarks/", "examples/", "docs/",
           "scripts/", "cmake/")


def without_blocks(text):
    """The text between the code blocks, lines kept."""
    result, inside = [], False
    for line in text.splitlines():
        fence = re.match(r"^\s*```", line)
        result.append("" if inside or fence else line)
        inside = inside != bool(fence)
    return result


def without_tables_of_programs(text):
    """What somebody wrote: not what a report put between its markers."""
    return re.sub(r"<!-- (\w+) -->\n.*?<!-- /\1 -->", "", text, flags=re.S)


def anchors(page):
    """The anchors that the headings of a page make."""
    heads = [line.lstrip("# ") for line in without_blocks(page.read_text(encoding="utf-8"))
             if line.startswith("#")]
    return {re.sub(r"[^\w\- ]", "", head.lower()).replace(" ", "-") for head in heads}


def check_link(page, number, target):
    """One sentence about a link that leads nowhere, or None."""
    if re.match(r"^[a-z]+:", target):
        return None
    path, _, anchor = target.partition("#")
    goal = (page.parent / path).resolve() if path else page
    if not goal.exists():
        return f"{page}:{number}: link to {target}, which does not exist"
    if anchor and anchor not in anchors(goal):
        return f"{page}:{number}: no heading makes the anchor of {target}"
    return None


def named_paths(line):
    """Paths of the project written as code: `src/grid/`, `scripts/test --all`."""
    for code in re.findall(r"`([^`]+)`", line):
        word = code.split()[0].split("#")[0]
        if word.startswith(FOLDERS) and not re.search(r"[*<>{}$]", word):
            yield word


def exists(path):
    """Whether a file or a folder with files is there: git keeps no empty folders."""
    return path.is_file() or any(path.glob("*"))


def words_of_source(root):
    """All words of the sources."""
    return {word for path in (root / "src").rglob("*.?pp")
            for word in re.findall(r"\w+", path.read_text(encoding="utf-8"))}


def unknown_names(page, words):
    """Names in the tables of an algorithm's page that are no words of the sources."""
    for number, line in enumerate(without_blocks(page.read_text(encoding="utf-8")), 1):
        if line.startswith("|"):
            for code in re.findall(r"`([\w\[\]()]+)`", line):
                for name in re.findall(r"[A-Za-z]\w+", code):
                    if name not in words:
                        yield f"{page}:{number}: `{name}` is in no source"


def accidental_markup(page):
    """Lines of a paragraph that begin with a sign that makes them a quotation or a list."""
    lines = without_blocks(page.read_text(encoding="utf-8"))
    for number, (before, line) in enumerate(zip(lines, lines[1:]), 2):
        sign = re.match(r"\s*([>+]) ", line)
        if sign and before.strip() and not re.match(r"\s*[>+] ", before):
            yield f"{page}:{number}: a line of text begins with '{sign[1]}'"


def check_page(root, page):
    """Problems of one page."""
    text = page.read_text(encoding="utf-8")
    longest = LONGEST.get(str(page.relative_to(root)), LONGEST_OTHER)
    lines = without_tables_of_programs(text).count("\n")
    problems = [f"{page}: {lines} lines, more than {longest}"] if lines > longest else []
    problems += accidental_markup(page)
    for number, line in enumerate(without_blocks(text), 1):
        for target in re.findall(r"\]\(([^)\s]+)\)", line):
            problems.append(check_link(page, number, target))
        for path in named_paths(line):
            if not exists(root / path):
                problems.append(f"{page}:{number}: `{path}` does not exist")
    for block in blocks.blocks_of(page):
        if block.language != "sh":
            continue
        for command in block.text.splitlines():
            word = command.removeprefix("$ ").split(" ")[0]
            if word.startswith(FOLDERS) and not exists(root / word):
                problems.append(f"{block.where()}: {word} does not exist")
    return [p for p in problems if p]


def check_pictures(root):
    """Pictures are small, and each is shown somewhere."""
    shown = "".join(page.read_text(encoding="utf-8") for page in blocks.pages(root))
    problems = []
    for picture in sorted((root / "docs" / "images").glob("*.[sp][vn]g")):
        if picture.stat().st_size > LARGEST_PICTURE:
            problems.append(f"{picture}: {picture.stat().st_size} bytes")
        if f"images/{picture.name}" not in shown:
            problems.append(f"{picture}: no page shows it")
    return problems


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--root", required=True)
    root = pathlib.Path(parser.parse_args().root).resolve()
    pages = blocks.pages(root)
    problems = [p for page in pages for p in check_page(root, page)] + check_pictures(root)
    words = words_of_source(root)
    for page in sorted((root / "docs" / "algorithms").glob("*.md")):
        problems += unknown_names(page, words)
    example = (root / "examples" / "first_contacts.cpp").read_text(encoding="utf-8")
    if f"```cpp\n{example}```" not in (root / "README.md").read_text(encoding="utf-8"):
        problems.append("README.md: its program differs from examples/first_contacts.cpp")
    for problem in problems:
        print(problem)
    print(f"{len(pages)} pages, {len(problems)} problems")
    return 1 if problems or not pages else 0


if __name__ == "__main__":
    sys.exit(main())

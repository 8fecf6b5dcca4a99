"""Functions of a C++ file, found by their braces: good enough for formatted code."""

import re

NOT_CODE = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<!\w)\'(?:\\.|[^\'\\\n])+\'',
    re.DOTALL)
DIRECTIVE = re.compile(r"^[ \t]*#(?:.*\\\n)*.*$", re.MULTILINE)
# A member set in braces before the body of a constructor.
INITIALISER = re.compile(r"\)[\s\w]*:[^:;?]([^;]*[,\s])?\w+$")
NO_FUNCTION = re.compile(
    r"(if|for|while|switch|catch|do|else|namespace|class|struct|enum|union|extern|return|"
    r"template\s*<[^>]*>\s*(class|struct))\b")


def emptied(match):
    return "\n" * match[0].count("\n")


def without_comments(text):
    """The text without comments, literals' contents and directives; lines stay where they are."""
    return DIRECTIVE.sub(emptied, NOT_CODE.sub(emptied, text))


def blocks(text):
    """(what stands before the opening brace, its first line, the line of the closing brace)."""
    opened, head, head_line, line, nested = [], "", 1, 1, 0
    for character in without_comments(text):
        line += character == "\n"
        nested += (character in "([") - (character in ")]")
        if character == "{":
            opened.append((head, head_line, nested))
            head, nested = "", 0
        elif character == "}":
            before, first, nested = opened.pop() if opened else ("", line, 0)
            if INITIALISER.search(before):
                head, head_line = before + "()", first
            else:
                yield before, first, line
                head = ""
        elif character == ";" and nested == 0:
            head = ""
        else:
            if not head.strip() and not character.isspace():
                head_line = line
            head += character


def functions(text):
    """(name, first line, lines from the head to the closing brace) of each function."""
    for head, first, last in blocks(text):
        head = re.sub(r"^(public|private|protected)\s*:\s*", "", head.strip())
        match = re.search(r"(~?\w+|operator\W+)\s*\(", head)
        if match is None or NO_FUNCTION.match(head):
            continue
        name = match[1]
        test = re.match(r"(?:TYPED_)?TEST(?:_P|_F)?\s*\(\s*(\w+)\s*,\s*(\w+)", head)
        yield (f"{test[1]}.{test[2]}" if test else name), first, last - first + 1

"""Runs a program and compares what it prints with a file.

Usage: check_program_output.py PROGRAM EXPECTED [WORDS]
With WORDS one sentence that begins so is right, too: that of a machine which lacks something.
"""

import pathlib
import subprocess
import sys


def main():
    program, expected_file, *words = sys.argv[1:]
    done = subprocess.run([program], capture_output=True, text=True, timeout=60, check=False)
    expected = pathlib.Path(expected_file).read_text(encoding="utf-8")
    is_sentence = done.stdout.startswith(tuple(words)) and done.stdout.count("\n") == 1
    if done.returncode == 0 and (done.stdout == expected or is_sentence):
        return 0
    print(f"{program} ends with {done.returncode} and prints\n{done.stdout}{done.stderr}"
          f"instead of\n{expected}")
    return 1


if __name__ == "__main__":
    sys.exit(main())

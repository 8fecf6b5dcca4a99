"""Runs a program and compares what it prints with a file."""

import pathlib
import subprocess
import sys


def main():
    program, expected_file = sys.argv[1:]
    done = subprocess.run([program], capture_output=True, text=True, timeout=60, check=False)
    expected = pathlib.Path(expected_file).read_text(encoding="utf-8")
    if done.returncode == 0 and done.stdout == expected:
        return 0
    print(f"{program} ends with {done.returncode} and prints\n{done.stdout}{done.stderr}"
          f"instead of\n{expected}")
    return 1


if __name__ == "__main__":
    sys.exit(main())

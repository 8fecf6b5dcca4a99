"""Checks an installed tree. Prints what is wrong; exit code 1 if anything is.
  python3 check_installed.py PREFIX shared|static SOURCE BUILD [tool] [PROPERTY]...
PROPERTY: how the build hardens, see wrong_hardening; with `tool` also that the tool is there."""

import re
import subprocess
import sys
from pathlib import Path

# The standard library, Highway, a runtime of OpenMP, the sanitizers; abut's devices need abut.
ALLOWED_LIBRARIES = re.compile(
    r"lib(stdc\+\+|m|gcc_s|c|pthread|hwy|gomp|omp|abut)\.so|ld-linux|lib[a-z]*san\.so")
INNER = ("abut::base::", "abut::grid::", "abut::reference::", "abut::api::", "abut::io::",
         "abut::engine::", "abut::kernels::")


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def wrong_headers(prefix, source):
    for header in (source / "include/abut").rglob("*.hpp"):
        installed = prefix / header.relative_to(source)
        if not installed.is_file() or installed.read_bytes() != header.read_bytes():
            yield f"{installed} is not the header of that name"
    for header in (prefix / "include").rglob("*"):
        if header.is_file() and not (source / header.relative_to(prefix)).is_file():
            yield f"{header} is no public header"


def wrong_paths(prefix, folders):
    for file in prefix.rglob("*"):
        for folder in folders:
            # as a whole path: a clone in /abut is not meant by lib/cmake/abut
            path = rb"(?<![\w.}>/])" + re.escape(str(folder)).encode() + rb"\b"
            if file.is_file() and re.search(path, file.read_bytes()):
                yield f"{file} names {folder}: it cannot be moved or reproduced"


def wrong_library(prefix, kind, version):
    libraries = sorted(file for file in prefix.rglob("libabut*") if not file.is_symlink())
    suffix = "a" if kind == "static" else f"so.{version}"
    expected = [f"libabut.{suffix}", f"libabut_device.{suffix}"]
    if [file.name for file in libraries] != expected:
        yield f"installed are {libraries} where {expected} should be"
        return
    if kind == "static":
        return
    for library in libraries:
        yield from wrong_shared_library(library, version)


def wrong_shared_library(library, version):
    dynamic = output("readelf", "-d", str(library))
    soname = f"{library.name.split('.')[0]}.so.{version.rsplit('.', 1)[0]}"
    if f"[{soname}]" not in dynamic:
        yield f"the soname is not {soname}:\n{dynamic}"
    for needed in re.findall(r"NEEDED.*\[(.*)\]", dynamic):
        if not ALLOWED_LIBRARIES.match(needed):
            yield f"the library needs {needed}; it may link nothing but the standard library, Highway and OpenMP"
    for line in output("nm", "-DC", "--defined-only", str(library)).splitlines():
        symbol = re.sub(r"^(vtable|typeinfo|typeinfo name) for ", "", line.split(" ", 2)[2])
        # The name of a function template stands behind the type that it returns.
        name = re.split(r"[<(]", symbol)[0].split(" ")[-1]
        if name.startswith(("std::", "__odr_asan", "__asan", "__start", "__stop")):
            continue  # inline code of the standard library, marks of the sanitizers
        if not symbol.startswith("abut::") or symbol.startswith(INNER):
            yield f"the library exports {symbol}, which is not public (ABUT_API)"


def wrong_hardening(file, properties):
    """Which of the properties the installed file lacks: cmake/abut_hardening.cmake."""
    symbols = output("nm", "-u", str(file)) if file.suffix == ".a" else output(
        "readelf", "--dyn-syms", "-W", str(file))
    present = {
        "stack_protector": "__stack_chk_fail" in symbols,
        "fortify": re.search(r"(?<!__stack)_chk\b", symbols),
        "assertions": "__glibcxx_assert_fail" in symbols,
    }
    if file.suffix != ".a":
        dynamic = output("readelf", "-ldW", str(file))
        present |= {
            "relro": "GNU_RELRO" in dynamic,
            "now": re.search(r"\(FLAGS_1\).*\bNOW\b", dynamic),
            "pie": re.search(r"\(FLAGS_1\).*\bPIE\b", dynamic),
            "no_executable_stack": re.search(r"GNU_STACK.* RW ", dynamic),
        }
    for name in properties:
        if not present[name]:
            yield f"{file} is not hardened: {name} is missing"


def wrong_tool(prefix, version):
    said = output(str(prefix / "bin/abut"), "--version")
    if version not in said:
        yield f"the installed tool says '{said.strip()}', not version {version}"


def wrong_documents(prefix, source, has_tool):
    """The licence, and what the tool tells of itself."""
    told = {"share/doc/abut/LICENSE": (source / "LICENSE").read_text()}
    if has_tool:
        for reader, path in (("bash", "bash-completion/completions/abut"),
                             ("zsh", "zsh/site-functions/_abut"),
                             ("fish", "fish/vendor_completions.d/abut.fish"),
                             ("man", "man/man1/abut.1")):
            told["share/" + path] = output(str(prefix / "bin/abut"), "completion", reader)
    for name, text in told.items():
        if not (prefix / name).is_file() or (prefix / name).read_text() != text or not text:
            yield f"{prefix / name} is missing or not what it should be"


def main():
    prefix, kind = Path(sys.argv[1]), sys.argv[2]
    source, build = Path(sys.argv[3]), Path(sys.argv[4])
    header = (source / "include/abut/version.hpp").read_text()
    version = ".".join(re.findall(r"ABUT_VERSION_[A-Z]+ (\d+)", header))
    wrong = [*wrong_headers(prefix, source), *wrong_paths(prefix, (source, build)),
             *wrong_library(prefix, kind, version)]
    has_tool = "tool" in sys.argv[5:]
    wrong += wrong_documents(prefix, source, has_tool)
    properties = [word for word in sys.argv[5:] if word != "tool"]
    linked = ["no_executable_stack", *(name for name in properties if name in ("relro", "now"))]
    compiled = [name for name in properties if name == "stack_protector"]
    for library in {file.resolve() for file in prefix.rglob("libabut.*")}:
        wrong += wrong_hardening(library, compiled + ([] if kind == "static" else linked))
    if has_tool:
        wrong += wrong_tool(prefix, version)
        wrong += wrong_hardening(prefix / "bin/abut", {"no_executable_stack", *properties})
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())

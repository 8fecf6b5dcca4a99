"""The checkers of this folder find the faults they are there for."""

import argparse
import os
import pathlib
import tempfile
import unittest

import blocks
import check_console
import check_cpp
import check_pages


def page(folder, text):
    """A page with that text."""
    path = pathlib.Path(folder) / "README.md"
    path.write_text(text, encoding="utf-8")
    return path


class Checkers(unittest.TestCase):

    def setUp(self):
        self.holder = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.holder.name).resolve()
        self.addCleanup(self.holder.cleanup)

    def block(self, language, text):
        fenced = f"text\n\n```{language}\n{text}\n```\n"
        return blocks.blocks_of(page(self.folder, fenced))[0]

    def test_blocks_have_their_language_line_and_text(self):
        block = self.block("cpp", "int main() {}")
        self.assertEqual((block.language, block.line, block.text), ("cpp", 3, "int main() {}\n"))

    def test_unknown_languages_and_open_blocks_are_refused(self):
        for text in ("```\nx\n```\n", "```rust\nx\n```\n", "```cpp\nx\n"):
            with self.assertRaises(blocks.PageError):
                blocks.blocks_of(page(self.folder, text))

    def console(self, text):
        return check_console.check(self.block("console", text), self.folder, dict(os.environ))

    def test_console_output_is_compared(self):
        self.assertEqual(self.console("$ echo one; echo two >&2\none\ntwo"), [])
        self.assertEqual(len(self.console("$ echo one\ntwo")), 1)
        self.assertEqual(len(self.console("$ echo one")), 1)
        self.assertEqual(len(self.console("$ true\none")), 1)

    def test_dots_stand_for_any_lines(self):
        self.assertEqual(self.console("$ seq 9\n1\n...\n8\n9"), [])
        self.assertEqual(self.console("$ true\n..."), [])
        self.assertEqual(len(self.console("$ seq 9\n1\n...\n8")), 1)

    def test_exit_codes_must_be_shown(self):
        self.assertEqual(len(self.console("$ false")), 1)
        self.assertEqual(self.console("$ (exit 3)\n$ echo $?\n3"), [])
        self.assertEqual(len(self.console("$ (exit 3)\n$ echo $?\n4")), 1)

    def test_durations_and_bytes_are_masked_and_nothing_else(self):
        same = [("took 1.5 ms", "took 12 µs"), ('"search": 0.5}', '"search": 1e-05}'),
                ("work 12 candidate tests, 1.0 kB of", "work 12 candidate tests, 9.5 MB of"),
                ('"peak_bytes": 5, "candidate_tests": 7', '"peak_bytes": 6, "candidate_tests": 7'),
                (" rows  1 ms  1.5 MB  1,234  7", " rows  2 ms  2.5 kB  1,234  7"),
                (" rows  2  as_found  1,234  7.5  8  24.7  9",
                 " rows  2  as_found  34  8  1.5  24.7  10"),
                (" rows  2  half list  1  2  3  24.7  4",
                 " binary_tree  2  half list  5  6  7  24.7  8")]
        for one, other in same:
            self.assertEqual(check_console.comparable(one), check_console.comparable(other))
        for one, other in [("5 pairs", "6 pairs"), ("gap 0.5", "gap 0.6"), ("1.5 MiB", "2 MiB"),
                           ("work 12 candidate tests", "work 13 candidate tests"),
                           ('"candidate_tests": 7', '"candidate_tests": 8'),
                           (" rows 1 ms 2 MB 5 7", " rows 1 ms 2 MB 5 8"),
                           (" rows 1 ms 2 MB 5 7", " rows 1 ms 2 MB 6 7"),
                           (" rows 2 count 1 2 3 24.7 4", " rows 2 count 1 2 3 24.8 4"),
                           (" rows 2 canonical 1 2 3 4 5", " munjiza_nbs 2 canonical 1 2 3 4 5"),
                           (" rows 2 canonical 1 2 3 4 5", " rows 1 canonical 1 2 3 4 5"),
                           (" rows 2 half list 1 2 3 4 5", " rows 2 full list 1 2 3 4 5")]:
            self.assertNotEqual(check_console.comparable(one), check_console.comparable(other))

    def test_pages_show_marks_in_place_of_what_is_masked(self):
        for printed, shown in [("  time   1.5 ms: read 0.1 ms", "  time   …: read …"),
                               ("  rows     1.5 ms  12.5 kB  7", "  rows          …        …  7"),
                               ('{"read": 0.5, "peak_bytes": 7}', '{"read": …, "peak_bytes": …}'),
                               ("  rows  1  count   157  146  140  47.8  103",
                                "  rows  1  count     …    …    …  47.8    …")]:
            self.assertEqual(check_console.masked(printed), shown)
            self.assertEqual(check_console.masked(shown), shown)
            self.assertEqual(check_console.comparable(shown), check_console.comparable(printed))
        self.assertEqual(self.console("$ echo took 5 ms\ntook …"), [])
        self.assertEqual(len(self.console("$ echo took 5 ms\ntook 6 ms")), 1)

    def test_a_console_block_begins_with_a_command(self):
        with self.assertRaises(blocks.PageError):
            self.console("no command")

    def test_programs_are_compiled_and_compared(self):
        arguments = argparse.Namespace(compiler="c++", include=".", library="", sanitize="")
        compiler = check_cpp.Compiler(arguments, self.folder)
        broken = self.block("cpp", "int main() { return undeclared; }")
        self.assertIn("does not compile", check_cpp.check(broken, None, compiler))

    def test_links_paths_and_anchors(self):
        (self.folder / "docs").mkdir()
        (self.folder / "docs" / "a.md").write_text("# One head\n\n```text\n# none\n```\n")
        good = page(self.folder, "[a](docs/a.md#one-head) `docs/a.md` `docs/<name>.md` "
                                 "[web](https://example.org)\n")
        self.assertEqual(check_pages.check_page(self.folder, good), [])
        for text in ("[a](docs/b.md)", "[a](docs/a.md#none)", "`src/no_such_file.cpp`",
                     "```sh\nscripts/none\n```"):
            bad = page(self.folder, text + "\n")
            self.assertEqual(len(check_pages.check_page(self.folder, bad)), 1, text)

    def test_arrays_that_the_sources_do_not_have(self):
        table = page(self.folder, "| a | `row_head[central]`, `gone_` |\n\n`not_in_a_table`\n")
        self.assertEqual(len(list(check_pages.unknown_names(table, {"row_head", "central"}))), 1)
        self.assertEqual(list(check_pages.unknown_names(table, {"row_head", "central", "gone_"})),
                         [])

    def test_lines_that_become_quotations(self):
        good = page(self.folder, "> said\n> so\n\n+ one\n+ two\n")
        self.assertEqual(list(check_pages.accidental_markup(good)), [])
        for text in ("as a\n> b holds\n", "the sum a\n+ b\n"):
            self.assertEqual(len(list(check_pages.accidental_markup(page(self.folder, text)))), 1)

    def test_long_pages(self):
        self.assertEqual(check_pages.check_page(self.folder, page(self.folder, "x\n" * 150)), [])
        long = page(self.folder, "x\n" * 151)
        self.assertEqual(len(check_pages.check_page(self.folder, long)), 1)


if __name__ == "__main__":
    unittest.main()

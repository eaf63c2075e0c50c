#!/usr/bin/env python3
"""docs/tutorial.md tells the truth: its commands print what it shows, one after the other.

PROMENADE_WRITE_DOCS=1 writes what they print now into it; read the difference before you commit."""
import difflib
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

import tutorial

PROMENADE = os.environ["PROMENADE"]
DOCUMENT = pathlib.Path(os.environ["PROMENADE_SOURCE_DIR"], "docs/tutorial.md")
IN_A_WINDOW = "# in a window"
MOST_LINES = 40  # of a difference


class Reader:
    """Does what the tutorial says, in an empty folder with `promenade` in the PATH."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder, "afternoon")
        self.folder.mkdir()
        path = pathlib.Path(folder, "bin")
        path.mkdir()
        (path / "promenade").symlink_to(pathlib.Path(PROMENADE).resolve())
        self.environment = {k: v for k, v in os.environ.items() if "DISPLAY" not in k}
        self.environment |= {"PATH": f"{path}:{os.environ['PATH']}", "LC_ALL": "C.UTF-8"}

    def write(self, block):
        name = block.lines[0].removeprefix("# ")
        (self.folder / name).write_text("\n".join(block.lines) + "\n", encoding="utf-8")

    def run(self, command):
        done = subprocess.run(["bash", "-o", "pipefail", "-c", command.words], cwd=self.folder,
                              env=self.environment, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, encoding="utf-8", timeout=300)
        return done.stdout.splitlines(), done.returncode

    def page(self, block):
        name = block.lines[0].removeprefix("# ")
        return tutorial.words_of_page((self.folder / name).read_text(encoding="utf-8"))


def wrong_line(first, shown, printed):
    """What to say about an output that is not as shown; None where it is."""
    wrong = tutorial.first_wrong(shown, printed)
    if wrong is None:
        return None
    line = shown[wrong] if wrong < len(shown) else "(nothing more)"
    difference = list(difflib.unified_diff(shown, tutorial.renewed(shown, printed), "shown",
                                           "printed", n=1, lineterm=""))
    if len(difference) > MOST_LINES:
        difference[MOST_LINES:] = [f"({len(difference) - MOST_LINES} more lines)"]
    return "\n".join([f"{DOCUMENT}:{first + wrong + 1}: this is not what is printed: {line}",
                      *difference])


class Tutorial(unittest.TestCase):
    def setUp(self):
        self.maxDiff = None
        self.document = DOCUMENT.read_text(encoding="utf-8").splitlines()
        self.problems = []  # that no other output would mend
        self.differences = []
        self.changes = []  # (first, count, lines), in the order of the document

    def compare(self, first, shown, printed):
        difference = wrong_line(first, shown, printed)
        if difference:
            self.differences.append(difference)
            self.changes.append((first, len(shown), tutorial.renewed(shown, printed)))

    def run_commands(self, reader, block):
        if block.lines[0] == IN_A_WINDOW:
            return
        for command in tutorial.commands(block):
            if shutil.which(command.words.split()[0], path=reader.environment["PATH"]) is None:
                print(f"not installed, so left out: {command.words}")
                continue
            printed, code = reader.run(command)
            self.compare(command.first, command.shown, printed)
            refused = any(": error: " in line for line in printed)
            if (code != 0) != refused:
                self.problems.append(f"{DOCUMENT}:{command.first}: exit code {code}: "
                                     f"{command.words}")

    def read_page(self, reader, block):
        """A page has more than is quoted of it, before, between and after."""
        page = reader.page(block)
        shown = [tutorial.ANY_LINES]
        for line in block.lines[1:]:
            shown += [line, tutorial.ANY_LINES]
        wrong = tutorial.first_wrong(shown, page)
        if wrong is not None:
            self.differences.append(f"{DOCUMENT}:{block.first + 1 + (wrong + 1) // 2}: "
                                    f"the page does not say: {shown[wrong]}")
            quoted = tutorial.renewed(shown, page)
            self.changes.append((block.first + 1, len(block.lines) - 1,
                                 [line for line in quoted if line != tutorial.ANY_LINES]))

    def rewrite(self):
        for first, count, lines in reversed(self.changes):
            self.document[first:first + count] = lines
        DOCUMENT.write_text("\n".join(self.document) + "\n", encoding="utf-8")

    def test_every_command_prints_what_is_shown(self):
        do = {"toml": lambda reader, block: reader.write(block), "console": self.run_commands,
              "text": self.read_page}
        with tempfile.TemporaryDirectory() as folder:
            reader = Reader(folder)
            for block in tutorial.blocks(self.document):
                do[block.kind](reader, block)
        if os.environ.get("PROMENADE_WRITE_DOCS"):
            self.rewrite()
        else:
            self.problems += self.differences
        if self.problems:
            self.fail("\n\n".join(self.problems))


class Comparison(unittest.TestCase):
    def test_an_output_is_right_or_its_first_wrong_line_is_named(self):
        printed = ["a table", "x 1.25", "y 2.50", "z 3", "end"]
        for shown, wrong in (
                (printed, None), (["..."], None), (["a table", "...", "end"], None),
                (["...", "y 2…", "...", "end"], None), (["…"] * 5, None),
                (["a table", "x …5", "...", "z 3", "end"], None),
                ([], 0), (["a table"], 1), (["a", "..."], 0), (printed[1:], 0),
                (["a table", "...", "y 2.51", "...", "end"], 2),
                (["...", "z 3", "y 2.50", "..."], 2), (["...", "end", "end"], 2),
                (["...", "x.1.25", "..."], 1), (printed + ["more"], 5)):
            self.assertEqual(tutorial.first_wrong(shown, printed), wrong, shown)

    def test_a_shown_output_is_renewed_with_what_can_stay(self):
        printed = ["table of 3", "x 1.25", "y 2.50", "x,0.1347,kept", "end 9"]
        for shown, renewed in (
                (["table of …", "...", "end 8"], ["table of …", "...", "end 9"]),
                (["nothing like it"], printed),
                (["table of …", "x 1.24"], ["table of …", *printed[1:]]),
                (["...", "gone for good", "y 2.49", "..."], ["...", "y 2.50", "..."]),
                (["...", "x,0.12…,kept", "..."], ["...", "x,0.13…,kept", "..."]),
                (["...", "y 2.50"], printed)):
            self.assertEqual(tutorial.renewed(shown, printed), renewed, shown)

    def test_commands_of_a_block_are_told_from_what_they_print(self):
        document = ["words", "```console", "$ one \\", "    two", "1", "2", "$ three", "```"]
        (block,) = tutorial.blocks(document)
        first, second = tutorial.commands(block)
        self.assertEqual((first.words, first.first, first.shown), ("one two", 4, ["1", "2"]))
        self.assertEqual((second.words, second.first, second.shown), ("three", 7, []))
        with self.assertRaises(ValueError):
            tutorial.blocks(document[:-1])
        with self.assertRaises(ValueError):
            tutorial.commands(tutorial.Block("console", 0, ["an output"]))

    def test_a_wrong_line_is_named_by_its_place_in_the_document(self):
        self.assertIsNone(wrong_line(10, ["a", "b"], ["a", "b"]))
        self.assertIn("tutorial.md:12: this is not what is printed: c",
                      wrong_line(10, ["a", "c"], ["a", "b"]))


if __name__ == "__main__":
    unittest.main()

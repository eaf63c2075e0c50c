#!/usr/bin/env python3
"""The published studies, from the program alone: checked, simulated, and reported beside the paper."""
import contextlib
import csv
import json
import os
import pathlib
import sqlite3
import subprocess
import unittest

from program import ProgramTest

SOURCE = pathlib.Path(os.environ.get("PROMENADE_SOURCE_DIR", pathlib.Path(__file__).parents[2]))
NAMES = sorted(path.stem for path in (SOURCE / "configs" / "studies").glob("*.toml"))


class Published(ProgramTest):
    def checked(self, *arguments):
        result = self.call(*arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result

    def run_of(self, name, people="2"):
        """The report of simulated people, as JSON. The folder has no source tree."""
        self.checked("simulate", f"configs/studies/{name}.toml", "--participants", people, "--seed",
                     "1", "--db", f"{name}.db")
        self.checked("report", f"{name}.db", "--include-simulated", "--out", name)
        return json.loads((self.folder / name / "report.json").read_text())

    def test_there_are_seven(self):
        self.assertEqual(len(NAMES), 7, NAMES)

    def test_each_is_simulated_and_reported_beside_its_paper(self):
        for name in NAMES:
            with self.subTest(name):
                report = self.run_of(name)
                published = report["published"]
                self.assertTrue(name.startswith(published["study"]))
                design = [row for row in published["rows"] if row["kind"] == "design"]
                self.assertTrue(design)
                for row in design:
                    self.assertIsNotNone(row["run"], row)
                with (self.folder / name / "tables" / "published.csv").open(newline="") as file:
                    self.assertEqual(len(list(csv.DictReader(file))), len(published["rows"]))
                page = (self.folder / name / "report.html").read_text()
                self.assertIn("Printed / this run", page)
                self.assertIn("SIMULATED", page)

    def test_each_passes_check(self):
        for name in NAMES:
            with self.subTest(name):
                result = self.call("check", f"configs/studies/{name}.toml", "--json")
                self.assertEqual(result.returncode, 0, result.stderr)
                study = json.loads(result.stdout)["studies"][0]
                self.assertTrue(study["ok"])
                self.assertLess(study["minutes"], 120)

    def test_the_study_of_2018_says_whom_its_targets_favour_and_shows_the_printed_figures_first(self):
        report = self.run_of("oshita-2018", "3")
        self.assertTrue(any("this favours adjectives" in one for one in report["caveats"]))
        numbers = [figure["caption"].split("As Figure ")[1].split()[0]
                   for figure in report["figures"] if "As Figure " in figure["caption"]]
        self.assertEqual(numbers, ["7", "8", "9", "10", "11"][:len(numbers)])
        self.assertIn("As Figure 7 of [O]", report["figures"][0]["caption"])
        tests = [row for row in report["published"]["rows"] if row["kind"] == "test"]
        self.assertEqual(len(tests), 36)
        self.assertEqual({row["n"] for row in tests if row["target"] == "all"}, {15})
        with contextlib.closing(sqlite3.connect(self.folder / "oshita-2018.db")) as db:
            skipped = db.execute("SELECT count(*) FROM trial WHERE task = 'match' AND practice = 0 "
                                 "AND started_us = ended_us").fetchone()[0]
            right = db.execute("SELECT count(*) FROM trial WHERE task = 'guess' AND practice = 0 "
                               "AND d_final < threshold_m").fetchone()[0]
        self.assertEqual(skipped, right, "a right guess is a match at 0 s")

    def test_its_sliders_are_held_against_the_printed_clusters(self):
        rows = {row["what"]: row["run_words"]
                for row in self.run_of("oshita-2018", "1")["published"]["rows"]}
        features = json.loads(self.checked("model", "features", "builtin:B").stdout)
        pairs = json.loads(self.checked("model", "adjectives", "builtin:B").stdout)
        for what, found in (("features", features["printed"]["set_b"]),
                            ("adjectives", pairs["printed"]["set_b"])):
            self.assertTrue(rows[f"sliders of {what}"].startswith(
                f"adjusted Rand index {found['rand_index']:.2f}, over {found['count']} "), rows)

    def test_another_set_takes_one_line(self):
        for name, reference in (("normoyle-timed", None), ("oshita-questionnaire-b", "normal")):
            text = (SOURCE / "configs" / "studies" / f"{name}.toml").read_text()
            for old in ("builtin:N", "builtin:B"):
                text = text.replace(f'set = "{old}"', 'set = "builtin:A"')
            if reference:
                text = text.replace("neutral-normal", reference)
            self.write("mine.toml", text)
            self.checked("simulate", "mine.toml", "--participants", "1", "--seed", "1", "--db",
                         f"{name}-mine.db")

    def test_targets_that_are_kept_in_a_file_are_drawn_anew_for_another_set(self):
        text = (SOURCE / "configs" / "studies" / "oshita-2018.toml").read_text()
        targets = (SOURCE / "configs" / "studies" / "oshita-2018-targets.csv").read_text()
        self.write("oshita-2018-targets.csv", targets)
        self.write("mine.toml", text.replace('set = "builtin:B"', 'set = "builtin:A"'))
        result = self.checked("simulate", "mine.toml", "--participants", "1", "--seed", "1", "--db",
                              "mine.db")
        self.assertIn("drawn anew", result.stderr)

    def test_a_mistyped_name_is_answered_with_the_one_that_was_meant(self):
        text = (SOURCE / "configs" / "studies" / "normoyle-timed.toml").read_text()
        self.write("wrong.toml", text.replace('published = "normoyle-timed"',
                                              'published = "normoyle-time"'))
        result = self.call("check", "wrong.toml")
        self.assertEqual(result.returncode, 2)
        self.assertIn('did you mean "normoyle-timed"?', result.stderr)

    def test_the_tool_makes_the_same_report_again(self):
        tool = SOURCE / "tools" / "published"
        reports = []
        for folder in ("one", "two"):
            out = self.folder / folder
            subprocess.run([tool, "--out", out, "oshita-questionnaire-a"], check=True, timeout=300,
                           capture_output=True)
            reports.append({path.relative_to(out): path.read_bytes()
                            for path in out.rglob("*") if path.is_file()})
        self.assertTrue(reports[0])
        self.assertEqual(reports[0], reports[1])


if __name__ == "__main__":
    unittest.main()

#!/usr/bin/env python3
"""Reports of what is no study, and of studies in which there is little to compare: a clear
sentence in place of a number, never NaN, never a crash."""
import json
import re
import shutil
import sqlite3
import unittest

from program import ProgramTest

STUDY = """
[study]
name = "walks"
version = "1"
order = "williams"
[[interface]]
name = "labels"
[[interface]]
name = "weights"
[[task]]
name = "match"
kind = "match"
limit_s = 20
targets = [{ example = "happy" }, { example = "old" }]
[[task]]
name = "find"
kind = "find"
limit_s = 20
qualities = [{ name = "tired", en = "tired" }]
[[rating]]
item = "satisfaction"
question = "How satisfied are you?"
points = 7
"""
ONE_INTERFACE = STUDY.replace('[[interface]]\nname = "weights"\n', "")
SENTENCE = re.compile(r"^[^\n]+: error: [^\n]+[^\n.]\n$")
NO_NUMBER = re.compile(r"(?<![\w.])[-+−]?(nan|inf|infinity)(?![\w])", re.IGNORECASE)


def no_constant(name):
    raise ValueError(f"{name} in report.json")


class OddReports(ProgramTest):
    def people(self, count, study=STUDY, db="a.db"):
        self.write("walks.toml", study)
        done = self.call("simulate", "walks.toml", "--participants", str(count), "--seed", "3",
                         "--db", db)
        self.assertEqual(done.returncode, 0, done.stderr)

    def change(self, *statements, db="a.db"):
        connection = sqlite3.connect(self.folder / db)
        for sql in statements:
            connection.execute(sql)
        connection.commit()
        connection.execute("PRAGMA wal_checkpoint(TRUNCATE)")
        connection.close()

    def report(self, db="a.db"):
        return self.call("report", db, "--include-simulated", "--out", "out")

    def refused(self, words, db="a.db"):
        done = self.report(db)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertRegex(done.stderr, SENTENCE)
        self.assertRegex(done.stderr, words)
        self.assertFalse((self.folder / "out").exists())

    def written(self):
        """The report, without a number that is none in any of its texts."""
        done = self.report()
        self.assertEqual(done.returncode, 0, done.stderr)
        folder = self.folder / "out"
        texts = [path for path in folder.rglob("*")
                 if path.suffix in (".csv", ".json", ".html", ".svg", ".gp", ".dat", ".R")]
        self.assertGreater(len(texts), 3)
        for path in texts:
            found = NO_NUMBER.search(re.sub(r"data:[^\"')]*", "", path.read_text()))
            self.assertIsNone(found, f"{path.name}: {found and found.group()}")
        report = json.loads((folder / "report.json").read_text(), parse_constant=no_constant)
        return report, (folder / "report.html").read_text()

    def test_a_file_of_another_program_is_refused(self):
        self.write("a.db", "No database at all.\n" * 200)
        self.refused("database")
        self.write("empty.db", "")
        self.refused("database|empty|study", "empty.db")
        connection = sqlite3.connect(self.folder / "other.db")
        connection.execute("CREATE TABLE trial(uuid TEXT)")
        connection.commit()
        connection.close()
        self.refused("Promenade", "other.db")
        self.refused("no such|not there|exist|cannot", "missing.db")

    def test_a_file_of_a_newer_version_is_refused(self):
        self.people(2)
        self.change("PRAGMA user_version = 99")
        self.refused("newer")

    def test_half_a_file_is_refused_wherever_it_is_cut(self):
        self.people(3)
        self.change()
        whole = (self.folder / "a.db").read_bytes()
        for part in (0.03, 0.3, 0.5, 0.9):
            (self.folder / "a.db").write_bytes(whole[:int(len(whole) * part)])
            self.refused("damaged|database")

    def test_without_a_finished_session_there_is_nothing_to_report(self):
        self.people(2)
        self.change("UPDATE session SET outcome = 'stopped'")
        self.refused("no finished trial")
        self.change("UPDATE session SET outcome = 'finished'",
                    "UPDATE trial SET outcome = 'aborted'")
        self.refused("no finished trial")

    def test_simulated_people_alone_are_named_when_they_do_not_count(self):
        self.people(2)
        done = self.call("report", "a.db", "--out", "out")
        self.assertEqual(done.returncode, 2)
        self.assertIn("--include-simulated", done.stderr)

    def test_one_participant(self):
        self.people(1)
        report, _ = self.written()
        self.assertTrue(report["wilcoxon"])
        for row in report["wilcoxon"]:
            self.assertIsNone(row["hl_ci"])

    def test_two_participants(self):
        self.people(2)
        self.written()

    def test_one_interface(self):
        self.people(4, ONE_INTERFACE)
        report, page = self.written()
        self.assertEqual(report["wilcoxon"], [])
        self.assertRegex(page, "one interface|only interface|nothing to compare|no other|no pair")

    def test_all_equal(self):
        self.people(6)
        self.change("UPDATE trial SET d_first = 0.1, d_best = 0.05, d_final = 0.05, d_sum = 1, "
                    "clicks = 3, changes = 3, started_us = 0, ended_us = 5000000, "
                    "outcome = 'success'",
                    "UPDATE answer SET value = 4 WHERE item = 'satisfaction'")
        report, _ = self.written()
        for row in report["wilcoxon"]:
            if row["measure"] != "d_final":
                continue
            self.assertEqual(row["n_zero"], row["n"])
            self.assertEqual((row["hl"], row["p_exact_two"]), (0, 1))
            self.assertIsNone(row["p_asym_two"])
            self.assertIsNone(row["rank_biserial"])

    def test_all_timeouts(self):
        self.people(6)
        self.change("UPDATE trial SET outcome = 'timeout', first_below_us = NULL, "
                    "ended_us = started_us + 20000000 WHERE practice = 0")
        report, page = self.written()
        times = [row for row in report["wilcoxon"] if row["measure"] == "time_s"]
        self.assertTrue(times)
        for row in times:
            self.assertEqual(row["n_zero"], row["n"])
        self.assertIn("100", page)

    def test_nothing_rated(self):
        self.people(6)
        self.change("DELETE FROM answer")
        report, _ = self.written()
        self.assertNotIn("satisfaction", {row["measure"] for row in report["wilcoxon"]})

    def test_only_one_of_two_interfaces_was_worked_with(self):
        self.people(6)
        self.change("UPDATE trial SET outcome = 'skipped' WHERE interface = 'weights'")
        self.written()

    def test_infinities_in_the_file_are_missing(self):
        self.people(6)
        self.change("UPDATE trial SET d_final = 9e999, d_best = -9e999 WHERE interface = 'labels'")
        self.written()

    def test_values_that_nothing_measured(self):
        for size in ("1.7e308", "1e99"):
            self.people(6, db="a.db")
            self.change(f"UPDATE trial SET d_final = {size} WHERE interface = 'labels'",
                        f"UPDATE trial SET d_final = -{size} WHERE interface = 'weights'")
            self.written()

    def test_the_same_report_made_again_is_the_same(self):
        self.people(3)
        self.written()
        shutil.move(self.folder / "out", self.folder / "before")
        self.written()
        for path in sorted((self.folder / "before").rglob("*")):
            if path.is_file():
                again = self.folder / "out" / path.relative_to(self.folder / "before")
                self.assertEqual(path.read_bytes(), again.read_bytes(), path.name)


if __name__ == "__main__":
    unittest.main()

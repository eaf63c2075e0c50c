#!/usr/bin/env python3
"""analysis.R, of reports and exports: R comes to the same tests, and says when it does not."""
import csv
import os
import pathlib
import shutil
import sqlite3
import subprocess
import tempfile
import unittest

PROMENADE = os.environ["PROMENADE"]
CONFIGS = pathlib.Path(os.environ["PROMENADE_SOURCE_DIR"], "configs")


def run(*command, folder, **environment):
    return subprocess.run([*map(str, command)], cwd=folder, text=True, capture_output=True,
                          timeout=600, env={**os.environ, "LC_ALL": "C.UTF-8", **environment})


def rows_of(file):
    with file.open(newline="", encoding="utf-8") as opened:
        return list(csv.DictReader(opened))


def write_rows(file, rows):
    with file.open("w", newline="", encoding="utf-8") as opened:
        writer = csv.DictWriter(opened, rows[0], lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


class AnalysisInR(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        cls.simulate("demo", 9, "demo.db")
        cls.simulate("tour", 5, "tour.db")
        shutil.copy(cls.folder / "demo.db", cls.folder / "ties.db")
        with sqlite3.connect(cls.folder / "ties.db") as db:
            db.execute("UPDATE trial SET d_final = round(d_final, 2), clicks = clicks % 3, "
                       "ended_us = started_us + 10000000 * (1 + position % 3)")
            db.execute("UPDATE session SET station = CASE sequence / 2 % 2 WHEN 0 THEN 'T' ELSE "
                       "'north, \"lab\"' END")
        for name in ("demo", "tour", "ties"):
            cls.promenade("report", f"{name}.db", "--include-simulated", "--out", name)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    @classmethod
    def promenade(cls, *arguments):
        result = run(PROMENADE, *arguments, folder=cls.folder)
        assert result.returncode == 0, result.stderr
        return result

    @classmethod
    def simulate(cls, study, people, db):
        cls.promenade("simulate", CONFIGS / f"{study}.toml", "--participants", people, "--seed", 3,
                      "--db", db)

    def r(self, folder, **environment):
        return run("Rscript", self.folder / folder / "analysis.R", folder="/", **environment)

    def copy_of(self, folder, name):
        shutil.copytree(self.folder / folder, self.folder / name)
        return self.folder / name / "tables"

    def check_same(self, folder, **environment):
        result = self.r(folder, **environment)
        self.assertEqual(result.returncode, 0, result.stderr[-2000:])
        self.assertNotIn("introduced by coercion", result.stderr)
        count = len(rows_of(self.folder / folder / "tables" / "comparisons.csv"))
        self.assertIn(f"All {count} tests are the same in R", result.stdout)
        return result.stdout

    def test_r_comes_to_the_same_tests(self):
        for folder in ("demo", "tour"):
            with self.subTest(folder):
                self.check_same(folder)

    def test_also_with_ties_and_zeros(self):
        rows = rows_of(self.folder / "ties" / "tables" / "comparisons.csv")
        self.assertTrue(any(int(row["n_zero"]) > 0 for row in rows))
        self.assertTrue(any(row["W_plus"].endswith(".5") for row in rows), "a tie")
        self.check_same("ties")

    def test_also_where_people_write_commas(self):
        self.check_same("demo", LC_ALL="de_DE.UTF-8")

    def test_also_of_an_export(self):
        for name, more in (("plain", ()), ("public", ("--public",))):
            with self.subTest(name):
                self.promenade("export", "demo.db", "--include-simulated", "--out", name, *more)
                self.check_same(name)
                trials = rows_of(self.folder / name / "tables" / "trials.csv")
                self.assertEqual(len({row["trial"] for row in trials}), len(trials))
                self.assertEqual(any(row["station"] for row in trials), not more)

    def test_each_number_is_compared(self):
        for column in ("n", "n_zero", "W_plus", "W_minus", "p_exact_two", "p_asym_two", "p_holm",
                       "hl"):
            with self.subTest(column):
                tables = self.copy_of("demo", "wrong-" + column)
                rows = rows_of(tables / "comparisons.csv")
                at = next(i for i, row in enumerate(rows) if row["measure"] == "time_s")
                number = float(rows[at][column])
                # An estimate is compared on the scale of the largest difference.
                number = number * (1 + (1e-7 if column == "hl" else 3e-9)) if number else 1.0
                rows[at][column] = repr(number)
                write_rows(tables / "comparisons.csv", rows)
                result = self.r("wrong-" + column)
                self.assertNotEqual(result.returncode, 0)
                self.assertIn("time_s, match", result.stderr)
                self.assertIn(column, result.stderr)

    def test_a_changed_trial_is_seen(self):
        tables = self.copy_of("demo", "changed")
        rows = rows_of(tables / "trials.csv")
        for row in rows:
            if row["interface"] == "labels":
                row["time_s"] = "1000"
        write_rows(tables / "trials.csv", rows)
        self.assertNotEqual(self.r("changed").returncode, 0)

    def test_models_are_fitted_or_it_says_why_not(self):
        text = self.r("ties").stdout
        for title in ("d_final in match: ", "log time_s in find: ", "failures in match: ",
                      "satisfaction in find: "):
            self.assertIn(title, text)
        self.assertRegex(text, r"\nstation\S", "the station is a term")
        self.assertIn("left out, since all trials have the same: target", text)
        self.assertNotIn("could not be fitted", text)

    def test_without_lme4_it_names_the_package_and_goes_on(self):
        tables = self.copy_of("ties", "bare")
        script = tables.parent / "analysis.R"
        script.write_text("requireNamespace <- function(...) FALSE\n" + script.read_text())
        text = self.check_same("bare")
        self.assertIn('install.packages("lme4")', text)
        self.assertIn('install.packages("ordinal")', text)
        self.assertIn("participants as a fixed factor", text)
        self.assertNotIn("could not be fitted", text)

    def test_trials_carry_their_identifiers(self):
        with sqlite3.connect(self.folder / "demo.db") as db:
            known = set(db.execute("SELECT uuid, session, block FROM trial"))
        trials = rows_of(self.folder / "demo" / "tables" / "trials.csv")
        self.assertGreater(len(trials), 30)
        for row in trials:
            self.assertIn((row["trial"], row["session"], int(row["block"])), known)
            self.assertEqual(row["study_version"], "1")
            self.assertIn(row["previous_interface"], ("", "labels", "weights"))
            self.assertNotEqual(row["previous_interface"], row["interface"])


if __name__ == "__main__":
    unittest.main()

#!/usr/bin/env python3
"""A simulated cohort goes through the demo study to the report, as an analyst would see it."""
import csv
import hashlib
import json
import os
import pathlib
import shutil
import sqlite3
import subprocess
import tempfile
import unittest

PROMENADE = os.environ["PROMENADE"]
PEOPLE = 12


def promenade(*arguments, folder, **environment):
    return subprocess.run([PROMENADE, *map(str, arguments)], cwd=folder, text=True,
                          capture_output=True, timeout=600,
                          env={**os.environ, "LC_ALL": "C.UTF-8", **environment})


def german(folder):
    """The environment of a language with decimal commas, or None where it cannot be made."""
    made = shutil.which("localedef") and subprocess.run(
        ["localedef", "-i", "de_DE", "-f", "UTF-8", folder / "de_DE.UTF-8"], capture_output=True)
    if not made or made.returncode != 0:
        return None
    return {"LOCPATH": str(folder), "LC_ALL": "de_DE.UTF-8", "LANG": "de_DE.UTF-8"}


def content_of(file):
    """What a seed decides: everything but uuids, dates and the machine."""
    trials_sql = """
        SELECT code, sequence, seed, position, task, interface, target, started_us, ended_us,
               trial.outcome, d_first, d_best, d_final, clicks, changes
        FROM trial JOIN session ON trial.session = session.uuid
        JOIN participant ON session.participant = participant.uuid ORDER BY code, position"""
    samples_sql = "SELECT t_us, d, hex(weights) FROM sample ORDER BY t_us, d, 3"
    db = sqlite3.connect(f"file:{file}?mode=ro", uri=True)
    rows = db.execute(trials_sql).fetchall(), db.execute(samples_sql).fetchall()
    db.close()
    return rows


class Cohort(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        cls.simulation = promenade("simulate", "configs/demo.toml", "--participants", PEOPLE,
                                   "--seed", 7, "--db", "one.db", folder=cls.folder)
        cls.reporting = promenade("report", "one.db", "--out", "report", "--include-simulated",
                                  folder=cls.folder)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def report(self):
        return json.loads((self.folder / "report" / "report.json").read_text())

    def test_every_session_is_finished_and_marked_simulated(self):
        self.assertEqual(self.simulation.returncode, 0, self.simulation.stderr)
        with sqlite3.connect(self.folder / "one.db") as db:
            sessions = db.execute("SELECT outcome, simulated FROM session").fetchall()
        self.assertEqual(sessions, [("finished", 1)] * PEOPLE)

    def test_the_report_counts_every_participant_once(self):
        self.assertEqual(self.reporting.returncode, 0, self.reporting.stderr)
        rows = [row for row in self.report()["wilcoxon"]
                if row["measure"] == "d_final" and row.get("pooling") == "participants"]
        self.assertTrue(rows)
        for row in rows:
            self.assertEqual(row["n"], PEOPLE)
            self.assertTrue(0 <= row["p_exact_two"] <= 1)

    def test_the_report_holds_the_numbers_of_the_database(self):
        with sqlite3.connect(self.folder / "one.db") as db:
            pairs = db.execute(
                "SELECT a.d_final - b.d_final FROM trial a JOIN trial b USING (session, task, target)"
                " WHERE a.interface = 'labels' AND b.interface = 'weights' AND a.practice = 0"
                " AND b.practice = 0 AND a.task = 'match'").fetchall()
        differences = [d for (d,) in pairs if d is not None]
        row = next(r for r in self.report()["wilcoxon"]
                   if r["measure"] == "d_final" and r["task"] == "match" and r["target"] is not None)
        self.assertEqual((row["a"], row["b"]), ("labels", "weights"))
        ranks = sorted(abs(d) for d in differences if d != 0)
        rank = {size: ranks.index(size) + (ranks.count(size) + 1) / 2 for size in ranks}
        self.assertAlmostEqual(row["W_plus"], sum(rank[abs(d)] for d in differences if d > 0))
        self.assertEqual(row["n_zero"], sum(d == 0 for d in differences))

    def test_the_report_made_again_is_the_same_to_the_byte(self):
        promenade("report", "one.db", "--out", "again", "--include-simulated", folder=self.folder)
        files = sorted(p.relative_to(self.folder / "report")
                       for p in (self.folder / "report").rglob("*") if p.is_file())
        self.assertIn(pathlib.Path("report.html"), files)
        for file in files:
            first, second = [hashlib.sha256((self.folder / d / file).read_bytes()).hexdigest()
                             for d in ("report", "again")]
            self.assertEqual(first, second, file)

    def test_tables_are_csv_of_as_many_columns_everywhere(self):
        tables = list((self.folder / "report" / "tables").glob("*.csv"))
        self.assertTrue(tables)
        for table in tables:
            with table.open(newline="") as file:
                rows = list(csv.reader(file))
            self.assertEqual({len(row) for row in rows}, {len(rows[0])}, table)

    def test_numbers_have_points_where_people_write_commas(self):
        environment = german(self.folder)
        if environment is None:
            self.skipTest("no localedef, or no German to define (package locales)")
        promenade("report", "one.db", "--out", "deutsch", "--include-simulated",
                  folder=self.folder, **environment)
        with (self.folder / "deutsch" / "tables" / "values.csv").open(newline="") as file:
            values = [row["value"] for row in csv.DictReader(file)]
        self.assertTrue(any("." in value for value in values))
        for value in values:
            float(value or 0)

    def test_the_seed_alone_decides_the_content(self):
        promenade("simulate", "configs/demo.toml", "--participants", 4, "--seed", 7, "--db",
                  "two.db", "--jobs", 1, folder=self.folder)
        promenade("simulate", "configs/demo.toml", "--participants", 4, "--seed", 7, "--db",
                  "three.db", "--jobs", 2, folder=self.folder)
        self.assertEqual(content_of(self.folder / "two.db"), content_of(self.folder / "three.db"))

    def test_two_programs_at_once_share_one_database(self):
        command = [PROMENADE, "simulate", "configs/demo.toml", "--participants", "10", "--db",
                   "both.db", "--jobs", "1", "--seed"]
        runs = [subprocess.Popen([*command, seed], cwd=self.folder, stdout=subprocess.DEVNULL)
                for seed in ("1", "2")]
        self.assertEqual([run.wait(timeout=600) for run in runs], [0, 0])
        db = sqlite3.connect(f"file:{self.folder / 'both.db'}?mode=ro", uri=True)
        row = db.execute("SELECT count(*), count(DISTINCT participant), count(DISTINCT sequence), "
                         "max(sequence) FROM session WHERE outcome = 'finished'").fetchone()
        db.close()
        self.assertEqual(row, (20, 20, 20, 19))

    def test_without_the_flag_simulated_people_are_not_reported(self):
        result = promenade("report", "one.db", "--out", "none", folder=self.folder)
        self.assertEqual(result.returncode, 2)
        self.assertIn("simulated", result.stderr)
        self.assertFalse((self.folder / "none").exists())


if __name__ == "__main__":
    unittest.main()

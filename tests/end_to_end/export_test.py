#!/usr/bin/env python3
"""A simulated cohort goes through the demo study to CSV, as an analyst and a stranger see it."""
import csv
import hashlib
import json
import os
import pathlib
import re
import shutil
import sqlite3
import subprocess
import tempfile
import unittest

PROMENADE = os.environ["PROMENADE"]
PEOPLE = 5
TABLES = ("trial", "event", "sample", "session", "participant", "study")
QUESTIONNAIRES = "".join(f'\n[[questionnaire]]\ninstrument = "{name}"\nwhen = "{when}"\n'
                         for name, when in (("demographics", "start"), ("nasa-tlx", "block"),
                                            ("comment", "end")))


def promenade(*arguments, folder, **environment):
    return subprocess.run([PROMENADE, *map(str, arguments)], cwd=folder, text=True,
                          capture_output=True, timeout=600,
                          env={**os.environ, "LC_ALL": "C.UTF-8", **environment})


def german(folder):
    """The environment of a language with decimal commas, as far as it can be made here."""
    if shutil.which("localedef"):
        subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", folder / "de_DE.UTF-8"],
                       capture_output=True)
    return {"LOCPATH": str(folder), "LC_ALL": "de_DE.UTF-8", "LANG": "de_DE.UTF-8"}


def contents(folder):
    return {str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest()
            for path in folder.rglob("*") if path.is_file()}


def rows(file):
    with file.open(newline="", encoding="utf-8") as opened:
        return list(csv.DictReader(opened))


class Export(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        demo = pathlib.Path(os.environ["PROMENADE_SOURCE_DIR"], "configs", "demo.toml")
        (cls.folder / "study.toml").write_text(demo.read_text() + QUESTIONNAIRES)
        promenade("simulate", "study.toml", "--participants", PEOPLE, "--seed", 7, "--db",
                  "one.db", folder=cls.folder)
        with sqlite3.connect(cls.folder / "one.db") as db:
            db.execute("UPDATE session SET station = 'north-lab-17', "
                       "machine = '{\"program\":\"machine-of-kim\"}'")
            db.execute("UPDATE answer SET touched = 1, text = 'I am ' || substr(session, 1, 8) "
                       "WHERE instrument = 'comment'")
        cls.plain = promenade("export", "one.db", "--out", "plain", "--include-simulated",
                              folder=cls.folder)
        cls.public = promenade("export", "one.db", "--out", "public", "--public",
                               "--include-simulated", folder=cls.folder)
        cls.db = sqlite3.connect(f"file:{cls.folder / 'one.db'}?mode=ro", uri=True)

    @classmethod
    def tearDownClass(cls):
        cls.db.close()
        cls.temporary.cleanup()

    def table(self, name, folder="plain"):
        return rows(self.folder / folder / "data" / f"description-{name}_data.csv")

    def test_both_are_done(self):
        self.assertEqual(self.plain.returncode, 0, self.plain.stderr)
        self.assertEqual(self.public.returncode, 0, self.public.stderr)

    def test_every_table_has_the_rows_of_the_database(self):
        for table in TABLES:
            count, = self.db.execute(f"SELECT count(*) FROM {table}").fetchone()
            for folder in ("plain", "public"):
                self.assertEqual(len(self.table(table, folder)), count, (folder, table))
        count, = self.db.execute("SELECT count(*) FROM answer").fetchone()
        self.assertEqual(len(self.table("answer")), count)

    def test_numbers_read_back_as_the_same_doubles(self):
        stored = {row[0]: row[1:] for row in self.db.execute(
            "SELECT uuid, d_first, d_final, d_sum, path_m, started_us FROM trial")}
        for row in self.table("trial"):
            read = [row[name] for name in ("d_first", "d_final", "d_sum", "path_m", "started_us")]
            self.assertEqual([float(cell) if cell else None for cell in read],
                             list(stored[row["uuid"]]))

    def test_weights_have_the_names_of_the_motions_and_sum_to_one(self):
        samples = self.table("sample")
        names = [name for name in samples[0] if name.startswith("weight.")]
        self.assertEqual(len(names), 10)
        self.assertIn("weight.happy", names)
        for row in samples:
            self.assertAlmostEqual(sum(float(row[name]) for name in names), 1)

    def test_the_wide_table_has_the_means_of_the_database(self):
        people = rows(self.folder / "plain" / "people_wide.csv")
        self.assertEqual(len(people), PEOPLE)
        for row in people:
            mean, = self.db.execute(
                "SELECT avg(d_final) FROM trial JOIN session ON session.uuid = trial.session JOIN "
                "participant ON participant.uuid = session.participant WHERE practice = 0 AND "
                "task = 'match' AND interface = 'weights' AND code = ?",
                (row["participant_code"],)).fetchone()
            self.assertAlmostEqual(float(row["d_final.match.weights"]), mean, delta=1e-12)
            self.assertIn("satisfaction.match.labels", row)

    def test_the_wide_table_has_the_scores_of_questionnaires(self):
        for row in rows(self.folder / "plain" / "people_wide.csv"):
            mean, = self.db.execute(
                "SELECT avg(value) FROM answer JOIN session ON session.uuid = answer.session JOIN "
                "participant ON participant.uuid = session.participant WHERE instrument = "
                "'nasa-tlx' AND item NOT LIKE '%-%' AND interface = 'labels' AND code = ?",
                (row["participant_code"],)).fetchone()
            self.assertAlmostEqual(float(row["nasa-tlx.raw.labels"]), mean, delta=1e-9)
            self.assertIn("demographics.age", row)

    def test_the_codebook_has_questions_and_citations(self):
        items = {(row["instrument"], row["item"]): row
                 for row in rows(self.folder / "plain" / "codebook.csv") if row["instrument"]}
        self.assertIn("mentally demanding", items["nasa-tlx", "mental"]["question"])
        self.assertTrue(items["nasa-tlx", "mental"]["citation"])
        self.assertIn("non-binary", items["demographics", "gender"]["choices"])

    def test_small_cells_are_named_on_the_terminal_and_hidden_in_the_folder(self):
        shown = [row for row in self.table("answer", "public")
                 if row["instrument"] == "demographics"]
        self.assertEqual(shown, [], "five people of many kinds")
        self.assertIn("small cell", self.public.stderr)
        cells = (self.folder / "public" / "demographic_cells.csv").read_text().splitlines()
        self.assertEqual(len(cells), 2)
        self.assertTrue(cells[1].endswith(f",{PEOPLE}"), cells)

    def test_words_are_published_when_they_were_reviewed(self):
        comments = [row for row in self.table("answer") if row["instrument"] == "comment"]
        with (self.folder / "reviewed.csv").open("w", newline="") as file:
            writer = csv.DictWriter(file, comments[0])
            writer.writeheader()
            writer.writerow(comments[0])
        result = promenade("export", "one.db", "--out", "reviewed", "--public", "--reviewed",
                           "reviewed.csv", folder=self.folder)
        self.assertIn(f"{PEOPLE - 1} free answers are left empty", result.stderr)
        words = [row["text"] for row in self.table("answer", "reviewed")
                 if row["instrument"] == "comment" and row["text"]]
        self.assertEqual(words, [comments[0]["text"]])

    def test_made_again_it_is_the_same_to_the_byte(self):
        promenade("export", "one.db", "--out", "again", "--include-simulated", folder=self.folder,
                  TZ="Asia/Tokyo")
        self.assertEqual(contents(self.folder / "again"), contents(self.folder / "plain"))

    def test_it_is_the_same_where_people_write_commas(self):
        promenade("export", "one.db", "--out", "deutsch", "--include-simulated",
                  folder=self.folder, **german(self.folder))
        self.assertEqual(contents(self.folder / "deutsch"), contents(self.folder / "plain"))

    def test_it_is_a_dataset_of_psych_ds(self):
        for folder in ("plain", "public"):
            root = self.folder / folder
            description = json.loads((root / "dataset_description.json").read_text())
            self.assertEqual(description["@context"], "https://schema.org")
            self.assertEqual(description["@type"], "Dataset")
            self.assertTrue(description["name"] and description["description"])
            named = [variable["name"] for variable in description["variableMeasured"]]
            self.assertEqual(len(named), len(set(named)))
            for file in (root / "data").iterdir():
                self.assertRegex(file.name, r"^([a-z]+-[a-zA-Z0-9]+_)+data\.csv$")
                with file.open(newline="") as opened:
                    self.assertLessEqual(set(next(csv.reader(opened))), set(named), file)

    def test_nothing_of_the_original_survives_for_the_public(self):
        secrets = {"north-lab-17", "machine-of-kim"}
        for (name,) in self.db.execute("SELECT name FROM sqlite_schema WHERE type = 'table'"):
            for column, in self.db.execute("SELECT name FROM pragma_table_info(?)", (name,)):
                if column in ("uuid", "code") or column.endswith("_utc"):
                    secrets |= {value for (value,) in self.db.execute(
                        f'SELECT DISTINCT "{column}" FROM "{name}"') if value}
        secrets |= {text for (text,) in self.db.execute(
            "SELECT text FROM answer WHERE instrument = 'comment'")}
        secrets |= {str(seed) for (seed,) in self.db.execute("SELECT seed FROM session")}
        self.assertGreater(len(secrets), 5 * PEOPLE)
        for path in (self.folder / "public").rglob("*"):
            text = path.read_bytes().decode("utf-8", "replace") if path.is_file() else ""
            for secret in secrets:
                self.assertNotIn(secret, text + path.name, path)
            if path.suffix in (".csv", ".json", ".md"):
                self.assertIsNone(re.search(r"20\d\d-\d\d-\d\d", text), path)

    def test_the_plain_one_has_what_the_public_one_hides(self):
        text = (self.folder / "plain" / "data" / "description-session_data.csv").read_text()
        self.assertIn("north-lab-17", text)
        self.assertIn("machine-of-kim", text)

    def test_built_in_motions_may_be_given_away(self):
        for folder in ("plain", "public"):
            motions, = (self.folder / folder / "materials").iterdir()
            info = promenade("set", "info", motions, "--json", folder=self.folder)
            self.assertEqual(len(json.loads(info.stdout)["cycles"]), 10)

    def test_the_database_is_not_touched(self):
        before = hashlib.sha256((self.folder / "one.db").read_bytes()).hexdigest()
        promenade("export", "one.db", "--out", "untouched", "--public", folder=self.folder)
        self.assertEqual(hashlib.sha256((self.folder / "one.db").read_bytes()).hexdigest(), before)

    def test_wrong_files_are_named_and_nothing_is_written(self):
        (self.folder / "no.db").write_text("no database")
        shutil.copy(self.folder / "one.db", self.folder / "newer.db")
        with sqlite3.connect(self.folder / "newer.db") as db:
            db.execute("PRAGMA user_version = 99")
        for name in ("missing.db", "no.db", "newer.db"):
            result = promenade("export", name, "--out", "wrong", folder=self.folder)
            self.assertEqual(result.returncode, 2, name)
            self.assertIn(name, result.stderr)
        self.assertFalse((self.folder / "wrong").exists())

    def test_a_place_that_cannot_be_written_is_exit_code_1(self):
        (self.folder / "file").write_text("")
        result = promenade("export", "one.db", "--out", "file/out", folder=self.folder)
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn("cannot write", result.stderr)

    def test_a_review_needs_the_public(self):
        result = promenade("export", "one.db", "--out", "x", "--reviewed", "r.csv",
                           folder=self.folder)
        self.assertEqual(result.returncode, 2)


if __name__ == "__main__":
    unittest.main()

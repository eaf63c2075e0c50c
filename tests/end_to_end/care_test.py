#!/usr/bin/env python3
"""People who withdraw, stations that are joined, second copies, files of older versions, the page
for an ethics board: as experimenters call for them."""
import json
import os
import pathlib
import shutil
import sqlite3
import stat
import subprocess
import unittest

from program import PROMENADE, ProgramTest

ROOT = pathlib.Path(os.environ.get("PROMENADE_SOURCE_DIR", pathlib.Path(__file__).parents[2]))
STUDY = """
[study]
name = "small"
set = "builtin:A"
[[interface]]
name = "labels"
[[interface]]
name = "weights"
[[task]]
name = "copy"
kind = "match"
limit_s = 20
threshold = "auto"
targets = [{ example = "happy" }]
"""


def dump(file):
    """All rows but the receipts."""
    with sqlite3.connect(f"file:{file}?mode=ro", uri=True) as db:
        return [line for line in db.iterdump() if '"receipt"' not in line]


class Care(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("small.toml", STUDY)

    def simulate(self, db, people=2, seed=1, study="small.toml", **options):
        result = self.call("simulate", study, "--participants", str(people), "--seed", str(seed),
                           "--db", db, **options)
        self.assertEqual(result.returncode, 0, result.stderr)

    def json_of(self, *arguments, code=0):
        result = self.call(*arguments, "--json")
        self.assertEqual(result.returncode, code, result.stderr)
        return json.loads(result.stdout)

    def old_database(self, name="old.db"):
        with sqlite3.connect(self.folder / name) as db:
            db.executescript((ROOT / "tests/study/old/v1.sql").read_text())
        db.close()
        return name

    def bytes_of(self, pattern="*.db*"):
        return b"".join(p.read_bytes() for p in self.folder.glob(pattern) if p.is_file())

    def test_withdrawing_leaves_no_trace_of_the_code(self):
        self.simulate("a.db", 12)
        self.assertIn(b"S011", self.bytes_of())
        done = self.json_of("withdraw", "a.db", "S011")
        self.assertEqual(done["removed"]["session"], 1)
        self.assertNotIn(b"S011", self.bytes_of())
        self.assertEqual(self.json_of("withdraw", "a.db")["backups"], [])

    def test_an_unknown_code_is_an_input_error_with_the_one_that_was_meant(self):
        self.simulate("a.db")
        before = self.bytes_of()
        result = self.call("withdraw", "a.db", "S01")
        self.assertEqual(result.returncode, 2)
        self.assertIn("did you mean", result.stderr)
        self.assertEqual(self.bytes_of(), before)
        self.assertEqual(self.call("withdraw", "a.db", "").returncode, 2)

    def test_a_backup_out_of_reach_is_named_and_done_later(self):
        self.write("small.toml", STUDY + '[safety]\ncopy_to = "stick"\n')
        (self.folder / "stick").mkdir()
        self.simulate("a.db", 3)
        result = self.call("simulate", "small.toml", "--participants", "9", "--seed", "2", "--db",
                           "a.db", "--copy")
        self.assertEqual(result.returncode, 0, result.stderr)
        copy = self.folder / "stick" / "a-1.db"
        self.assertEqual(stat.S_IMODE(copy.stat().st_mode), 0o600)
        (self.folder / "stick").rename(self.folder / "away")
        result = self.call("withdraw", "a.db", "S011")
        self.assertEqual(result.returncode, 1)
        self.assertIn(str(copy), result.stderr)
        self.assertEqual(self.call("withdraw", "a.db").returncode, 1)
        (self.folder / "away").rename(self.folder / "stick")
        self.assertTrue(self.json_of("withdraw", "a.db")["backups"][0]["done"])
        self.assertNotIn(b"S011", copy.read_bytes())

    def test_merging_twice_is_merging_once(self):
        self.simulate("a.db", 2, 1)
        self.simulate("b.db", 3, 2)
        first = self.json_of("merge", "all.db", "a.db", "b.db")
        self.assertEqual(first["sessions"], 5)
        before = dump(self.folder / "all.db")
        self.assertEqual(self.json_of("merge", "all.db", "b.db", "a.db")["sessions"], 5)
        self.assertEqual(dump(self.folder / "all.db"), before)
        self.assertEqual(stat.S_IMODE((self.folder / "all.db").stat().st_mode), 0o600)
        report = self.call("report", "all.db", "--out", "r", "--include-simulated")
        self.assertEqual(report.returncode, 0, report.stderr)

    def test_conflicts_are_named_all_at_once_and_nothing_is_written(self):
        self.simulate("a.db", 2)
        shutil.copy(self.folder / "a.db", self.folder / "b.db")
        with sqlite3.connect(self.folder / "b.db") as db:
            db.execute("UPDATE trial SET d_final = 1")
        db.close()
        self.write("c.db", "no database at all" * 20)
        result = self.call("merge", "all.db", "a.db", "b.db")
        self.assertEqual(result.returncode, 2)
        self.assertEqual(result.stderr.count("b.db: error: its session"), 2)
        result = self.call("merge", "all.db", "a.db", "c.db", "d.db")
        self.assertEqual(result.returncode, 2)
        self.assertIn("c.db: error: is not a database", result.stderr)
        self.assertIn("d.db: error: does not exist", result.stderr)
        self.assertFalse(list(self.folder.glob("all.db*")))

    def test_who_withdrew_at_a_station_is_removed_from_the_whole(self):
        self.simulate("a.db", 12)
        shutil.copy(self.folder / "a.db", self.folder / "before.db")
        self.json_of("merge", "all.db", "a.db")
        self.json_of("withdraw", "a.db", "S011")
        self.assertEqual(self.json_of("merge", "all.db", "a.db")["removed"]["session"], 1)
        again = self.json_of("merge", "all.db", "before.db")
        self.assertEqual(again["inputs"][0]["withdrawn_sessions"], 1)
        self.assertNotIn(b"S011", self.bytes_of("all.db*"))

    def test_an_old_file_is_reported_as_it_is_and_copied_before_it_is_written(self):
        old = self.old_database()
        before = (self.folder / old).read_bytes()
        result = self.call("report", old, "--out", "r", "--include-simulated")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual((self.folder / old).read_bytes(), before)
        self.json_of("withdraw", old, "S002")
        with sqlite3.connect(self.folder / "old.db.v1.backup") as db:
            self.assertEqual(db.execute("PRAGMA user_version").fetchone(), (1,))
            self.assertEqual(db.execute("SELECT code FROM participant").fetchall(), [("S001",)])
        db.close()

    def test_a_disk_that_takes_no_more_leaves_everything_as_it_was(self):
        self.simulate("a.db", 2)
        before = self.bytes_of()
        limit = 'ulimit -f 16; trap "" XFSZ; exec "$0" merge all.db a.db'
        result = subprocess.run(["bash", "-c", limit, PROMENADE], cwd=self.folder, text=True,
                                capture_output=True, timeout=60)
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertEqual(self.bytes_of(), before)

    def test_the_page_for_a_board_names_every_column(self):
        self.simulate("a.db", 1)
        for page in ("board.html", "board.md"):
            result = self.call("check", "small.toml", "--ethics", page)
            self.assertEqual(result.returncode, 0, result.stderr)
        text = (self.folder / "board.html").read_text()
        with sqlite3.connect(self.folder / "a.db") as db:
            for table, column in db.execute("SELECT table_name, column_name FROM dictionary"):
                self.assertIn(f"<h3>{table}</h3>", text)
                self.assertIn(f"<td>{column}</td>", text)
        db.close()

    def test_no_page_is_written_for_a_broken_study_or_an_odd_name(self):
        self.write("bad.toml", STUDY.replace("limit_s", "limit"))
        self.assertEqual(self.call("check", "bad.toml", "--ethics", "b.html").returncode, 2)
        self.assertEqual(self.call("check", "small.toml", "--ethics", "b.pdf").returncode, 2)
        self.assertEqual(self.call("check", "small.toml", "bad.toml", "--ethics", "b.md").returncode, 2)
        self.assertFalse(list(self.folder.glob("b.*")))


if __name__ == "__main__":
    unittest.main()

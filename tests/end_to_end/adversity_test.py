#!/usr/bin/env python3
"""What a laboratory meets sooner or later: decimal commas, a clock that was set, two programs on
one file, a full disk, a disk that turned read-only, and a polite kill."""
import contextlib
import json
import os
import pathlib
import shutil
import signal
import sqlite3
import subprocess
import tempfile
import time
import unittest

PROMENADE = os.environ["PROMENADE"]
SOURCE = pathlib.Path(os.environ.get("PROMENADE_SOURCE_DIR", ".")).resolve()
DEMO = SOURCE / "configs" / "demo.toml"


def command(*arguments):
    return [PROMENADE, *map(str, arguments)]


def simulate(db, participants=3, seed=1):
    return command("simulate", DEMO, "--participants", participants, "--seed", seed, "--db", db)


def promenade(arguments, **environment):
    return subprocess.run(arguments, text=True, capture_output=True, timeout=600,
                          env={**os.environ, **environment})


def ask(db, sql):
    with contextlib.closing(sqlite3.connect(f"file:{db}?mode=ro", uri=True)) as database:
        return database.execute(sql).fetchall()


def mounted(folder, options):
    """A small file system in memory; False where this user may not mount."""
    return shutil.which("mount") is not None and subprocess.run(
        ["mount", "-t", "tmpfs", "-o", options, "tmpfs", folder],
        capture_output=True).returncode == 0


class Adversity(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="promenade_adversity_"))
        self.db = self.folder / "study.db"

    def tearDown(self):
        shutil.rmtree(self.folder, ignore_errors=True)

    def assert_sound(self, db=None):
        """The file opens, and what is stored follows from what was done."""
        db = db or self.db
        self.assertEqual(ask(db, "PRAGMA quick_check"), [("ok",)])
        audit = promenade(command("replay", db, "--audit", "--json"))
        self.assertEqual(audit.returncode, 0, audit.stderr)
        return json.loads(audit.stdout)

    def test_decimal_commas_change_nothing(self):
        made = shutil.which("localedef") and subprocess.run(
            ["localedef", "-i", "de_DE", "-f", "UTF-8", self.folder / "de_DE.UTF-8"],
            capture_output=True).returncode == 0
        if not made:
            self.skipTest("the locale de_DE.UTF-8 cannot be made")
        german = {"LOCPATH": str(self.folder), "LC_ALL": "de_DE.UTF-8", "LANG": "de_DE.UTF-8"}
        other = self.folder / "plain.db"
        self.assertEqual(promenade(simulate(self.db), **german).returncode, 0)
        self.assertEqual(promenade(simulate(other)).returncode, 0)
        sql = "SELECT kind, target, value, x, y, detail FROM event ORDER BY session IN (" \
              "SELECT uuid FROM session WHERE sequence = 0), t_us, seq"
        self.assertEqual(ask(self.db, sql), ask(other, sql))
        self.assertEqual(promenade(command("replay", self.db, "--audit"), **german).returncode, 0)

    def test_a_clock_that_was_set_back_is_no_matter(self):
        if shutil.which("faketime") is None:
            self.skipTest("faketime is not installed")
        process = subprocess.Popen(simulate(self.db, 5000), stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL)
        self.wait_for_rows()
        process.kill()
        process.wait()
        done = promenade(["faketime", "2020-01-01 10:00:00", *simulate(self.db, 1)])
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(ask(self.db, "SELECT count(*) FROM session WHERE outcome = 'running'"),
                         [(0,)])
        gaps = ask(self.db, "SELECT value FROM event WHERE kind = 'interrupted'")
        self.assertTrue(all(value >= 0 for (value,) in gaps), gaps)
        self.assert_sound()

    def test_two_programs_share_a_file(self):
        pair = [subprocess.Popen(simulate(self.db, 15, seed), stdout=subprocess.DEVNULL,
                                 stderr=subprocess.PIPE, text=True) for seed in (1, 2)]
        for process in pair:
            _, said = process.communicate(timeout=600)
            self.assertEqual(process.returncode, 0, said)
        self.assertEqual(ask(self.db, "SELECT count(*), count(DISTINCT sequence), "
                                      "count(DISTINCT participant) FROM session"), [(30, 30, 30)])
        self.assert_sound()

    def test_a_full_disk_ends_it_with_a_sentence_and_keeps_the_rest(self):
        disk = self.folder / "disk"
        disk.mkdir()
        if not mounted(disk, "size=8m"):
            self.skipTest("this user may not mount a small file system")
        try:
            db = disk / "study.db"
            done = promenade(simulate(db, 5000))
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertIn("full", done.stderr)
            self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
            trials = ask(db, "SELECT count(*) FROM trial WHERE outcome IS NOT NULL")
            self.assertGreater(trials[0][0], 100)
            self.assert_sound(db)
            subprocess.run(["mount", "-o", "remount,size=64m", disk], check=True)
            self.assertEqual(promenade(simulate(db, 1)).returncode, 0)
            self.assertEqual(ask(db, "SELECT count(*) FROM session WHERE outcome = 'running'"),
                             [(0,)])
            self.assert_sound(db)
        finally:
            subprocess.run(["umount", disk], check=True)

    def test_a_disk_that_turned_read_only_is_named(self):
        disk = self.folder / "disk"
        disk.mkdir()
        if not mounted(disk, "size=16m"):
            self.skipTest("this user may not mount a small file system")
        try:
            db = disk / "study.db"
            self.assertEqual(promenade(simulate(db, 1)).returncode, 0)
            subprocess.run(["mount", "-o", "remount,ro", disk], check=True)
            done = promenade(simulate(db, 1))
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertIn("study.db", done.stderr)
            self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
        finally:
            subprocess.run(["umount", disk], check=True)

    def test_a_polite_kill_leaves_whole_sessions(self):
        process = subprocess.Popen(simulate(self.db, 5000), stdout=subprocess.DEVNULL,
                                   stderr=subprocess.PIPE, text=True)
        self.wait_for_rows()
        process.send_signal(signal.SIGTERM)
        _, said = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 1)
        self.assertIn("stopped after", said)
        self.assertEqual(ask(self.db, "SELECT DISTINCT outcome FROM session"), [("finished",)])
        self.assert_sound()

    def wait_for_rows(self):
        for _ in range(600):
            try:
                if ask(self.db, "SELECT count(*) FROM trial")[0][0] > 20:
                    return
            except sqlite3.OperationalError:
                pass
            time.sleep(0.05)
        self.fail("nothing was stored")


if __name__ == "__main__":
    unittest.main()

#!/usr/bin/env python3
"""The display goes away in the middle of a trial: one sentence, and the session can go on."""
import contextlib
import os
import pathlib
import shutil
import sqlite3
import subprocess
import tempfile
import time
import unittest

from virtual_display import Display

PROMENADE = os.environ["PROMENADE"]
STUDY = """
[study]
name = "lost"
[[interface]]
name = "labels"
[[task]]
name = "copy"
kind = "match"
targets = [{ example = "proud" }]
"""


def ask(db, sql):
    with contextlib.closing(sqlite3.connect(f"file:{db}?mode=ro", uri=True)) as database:
        return database.execute(sql).fetchall()


@unittest.skipIf(shutil.which("Xvfb") is None, "Xvfb is not installed")
class DisplayLoss(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="promenade_display_"))
        self.db = self.folder / "lost.db"
        (self.folder / "lost.toml").write_text(STUDY)

    def tearDown(self):
        shutil.rmtree(self.folder, ignore_errors=True)

    def wait_for_trial(self, process):
        for _ in range(1200):
            self.assertIsNone(process.poll(), "it ended before the trial")
            with contextlib.suppress(sqlite3.OperationalError):
                if ask(self.db, "SELECT count(*) FROM trial") != [(0,)]:
                    return
            time.sleep(0.1)
        self.fail("no trial began")

    def test_it_says_so_and_keeps_the_session(self):
        display = Display()
        process = subprocess.Popen(
            [PROMENADE, "run", self.folder / "lost.toml", "--db", self.db, "--windowed",
             "--autopilot", "3"], env={**os.environ, "DISPLAY": display.name},
            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        self.wait_for_trial(process)
        display.close()
        _, said = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 1)
        self.assertIn("the display went away; the session until then is in", said)
        self.assertEqual(ask(self.db, "SELECT outcome FROM session"), [("running",)])
        audit = subprocess.run([PROMENADE, "replay", self.db, "--audit"], capture_output=True)
        self.assertEqual(audit.returncode, 0, audit.stdout)


if __name__ == "__main__":
    unittest.main()

#!/usr/bin/env python3
"""A session is watched from another process: it goes on, its program is killed, nothing is written."""
import hashlib
import json
import os
import shutil
import signal
import subprocess
import time
import unittest

from program import PROMENADE, ProgramTest
from virtual_display import Display

STUDY = """
[study]
name = "watched"
participants = 8
[[interface]]
name = "labels"
[[task]]
name = "copy"
kind = "match"
limit_s = 4
targets = [{ example = "proud" }, { example = "sad" }, { example = "happy" }]
"""


class Monitor(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("watched.toml", STUDY)

    def look(self):
        return json.loads(self.call("monitor", "x.db", "--once", "--json").stdout or "{}")

    def simulate(self, people):
        self.assertEqual(self.call("simulate", "watched.toml", "--participants", str(people), "--seed",
                                   "1", "--db", "x.db").returncode, 0)

    def test_an_idle_database_stays_as_it_is(self):
        self.simulate(3)
        before = hashlib.sha256((self.folder / "x.db").read_bytes()).hexdigest()
        seen = self.look()
        text = self.call("monitor", "x.db", "--once").stdout
        self.assertEqual(hashlib.sha256((self.folder / "x.db").read_bytes()).hexdigest(), before)
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["watched.toml", "x.db"])
        self.assertEqual(seen["planned"], 8)
        self.assertEqual(seen["finished_simulated"], 3)
        self.assertEqual([s["state"] for s in seen["sessions"]], ["ended"] * 3)
        self.assertIn("0 of 8 participants have finished, 3 simulated", text)

    def test_what_is_no_database_is_an_input_error(self):
        self.write("x.db", "no database\n" * 20)
        self.assertEqual(self.call("monitor", "x.db", "--once").returncode, 2)
        self.assertEqual(self.call("monitor", "none.db", "--once").returncode, 2)
        self.assertEqual(self.call("monitor", "x.db", "--json").returncode, 2)
        self.assertFalse((self.folder / "none.db").exists())

    def test_text_goes_on_until_it_is_stopped(self):
        watcher = subprocess.Popen([PROMENADE, "monitor", "x.db", "--text"], cwd=self.folder,
                                   stdout=subprocess.PIPE, text=True)
        self.assertIn("is not there yet", watcher.stdout.readline())
        self.simulate(1)
        while "1 simulated" not in watcher.stdout.readline():
            pass
        watcher.send_signal(signal.SIGINT)
        watcher.communicate(timeout=10)
        self.assertEqual(watcher.returncode, 0)

    def open_display(self):
        display = Display()
        self.addCleanup(display.close)
        return display.name

    def wait_for_trial(self, position):
        """The session as soon as it is in this trial or a later one, and one that it is in."""
        for _ in range(300):
            for session in self.look().get("sessions", []):
                if session["trial"] and session["trial"]["position"] >= position:
                    return session
            time.sleep(0.1)
        self.fail(f"trial {position} was not seen")

    @unittest.skipIf(shutil.which("Xvfb") is None, "Xvfb is not installed")
    def test_a_running_session_is_seen_going_on_and_interrupted(self):
        environment = {**os.environ, "DISPLAY": self.open_display()}
        session = subprocess.Popen(
            [PROMENADE, "run", "watched.toml", "--db", "x.db", "--windowed", "--autopilot", "3"],
            cwd=self.folder, env=environment, stdout=subprocess.DEVNULL)
        self.addCleanup(session.wait)
        self.addCleanup(session.kill)
        first = self.wait_for_trial(1)
        self.assertEqual(first["state"], "running")
        self.assertEqual(first["kind"], "simulated")
        self.assertLess(first["seconds_since_sign_of_life"], 10)
        self.assertGreater(first["minutes_left"], 0)
        later = self.wait_for_trial(first["trial"]["position"] + 1)
        self.assertGreater(later["trial"]["d"], 0)
        self.assertLessEqual(later["trial"]["d_best"], later["trial"]["d"])
        session.kill()
        session.wait()
        journal = (self.folder / "x.db-wal").read_bytes()
        after = self.look()["sessions"][0]
        self.assertEqual(after["state"], "interrupted")
        self.assertIn("start the program again to resume", after["doing"])
        self.assertEqual((self.folder / "x.db-wal").read_bytes(), journal)


if __name__ == "__main__":
    unittest.main()

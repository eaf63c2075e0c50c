#!/usr/bin/env python3
"""A running session is asked through the file beside its database, and its log answers."""
import datetime
import json
import os
import shutil
import sqlite3
import subprocess
import time
import unittest
import uuid

from program import PROMENADE, ProgramTest
from virtual_display import Display

STUDY = """
[study]
name = "asked"
[[interface]]
name = "labels"
[[task]]
name = "copy"
kind = "match"
limit_s = 60
targets = [{ example = "proud" }, { example = "sad" }, { example = "happy" }]
"""


@unittest.skipIf(shutil.which("Xvfb") is None, "Xvfb is not installed")
class Control(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("asked.toml", STUDY)
        self.control = self.folder / "x.db.control"

    def open_display(self):
        display = Display()
        self.addCleanup(display.close)
        return display.name

    def start(self):
        environment = {**os.environ, "DISPLAY": self.open_display()}
        # A quick reader: four seconds to the first task.
        session = subprocess.Popen(
            [PROMENADE, "run", "asked.toml", "--db", "x.db", "--windowed", "--autopilot", "41"],
            cwd=self.folder, env=environment, stdout=subprocess.DEVNULL)
        self.addCleanup(session.wait)
        self.addCleanup(session.kill)
        return session

    def rows(self, query, *values):
        try:
            log = sqlite3.connect(f"file:{self.folder / 'x.db'}?mode=ro", uri=True)
        except sqlite3.OperationalError:  # it is not there yet
            return []
        try:
            return log.execute(query, values).fetchall()
        except sqlite3.OperationalError:  # its tables are not
            return []
        finally:
            log.close()

    def wait_for(self, what, query, *values):
        for _ in range(600):
            found = self.rows(query, *values)
            if found:
                return found[0]
            time.sleep(0.05)
        self.fail(f"{what}: was not seen")

    def append(self, text):
        with open(self.control, "a", encoding="utf-8") as control:
            control.write(text)

    def ask(self, session, do, **more):
        """Its id, as soon as it was written."""
        now = datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ")
        request = {"id": str(uuid.uuid4()), "session": session, "do": do, "written_utc": now, **more}
        self.append(json.dumps(request) + "\n")
        return request["id"]

    def answer(self, request):
        """Kind and target of the event that answers."""
        return self.wait_for(
            "an answer", "SELECT kind, target FROM event WHERE actor = 'experimenter' "
            "AND json_extract(detail, '$.request') = ?", request)

    def test_a_session_does_what_it_is_asked_for(self):
        program = self.start()
        session, = self.wait_for(
            "the first task", "SELECT session FROM event WHERE target = 'instructions'")
        self.assertEqual(self.answer(self.ask(session, "pause")), ("pause", None))
        self.assertEqual(self.answer(self.ask(session, "note", text="the phone rang"))[0], "note")
        self.append("{ broken\n" + "\0" * 5000 + "\n")
        self.assertEqual(self.answer(self.ask(session, "skip", reason="noise", page=9999)),
                         ("request_refused", "skip"))
        self.assertEqual(self.answer(self.ask(session, "skip", reason="noise"))[0], "skip")
        self.assertEqual(self.answer(self.ask(session, "repeat", reason="noise")), ("repeat", "trial"))
        self.assertEqual(self.answer(self.ask(session, "stop", reason="enough"))[0], "stop")
        self.assertEqual(program.wait(timeout=20), 0)
        self.assertFalse(self.control.exists())
        self.assertEqual(self.rows("SELECT outcome FROM session"), [("stopped",)])
        self.assertEqual(self.rows("SELECT count(*) FROM trial WHERE outcome = 'skipped'"), [(1,)])
        audit = self.call("replay", "x.db", "--audit")
        self.assertEqual(audit.returncode, 0, audit.stdout + audit.stderr)


if __name__ == "__main__":
    unittest.main()

#!/usr/bin/env python3
"""An experimenter's morning: a study is made, changed, rehearsed, run, watched and reported on, all with
the mouse and the keyboard."""
import json
import pathlib
import sqlite3
import subprocess
import tempfile
import unittest

from desk import PROMENADE, Desk


class Morning(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.desk = Desk(self.temporary.name)
        self.study = pathlib.Path(self.temporary.name) / "studies" / "Walks of spring"

    def tearDown(self):
        self.desk.close()
        self.temporary.cleanup()

    def make(self):
        self.desk.write("new_name", "Walks of spring")
        self.desk.press("make")
        self.desk.click("study", "Walks of spring")  # which is chosen already: it opens

    def edit(self):
        before = (self.study / "study.toml").read_text().splitlines()
        self.desk.write(r"study\.participants", "4")
        self.desk.click("section", "tasks")
        self.desk.press(r"remove/task\[1\]")
        self.desk.press(r"item/task\[0\]")
        limit = r"task\[0\]\.limit_s"
        self.desk.scroll_to("type", limit, over=("type", r"task\[0\]\.name"))
        self.desk.write(limit, "3")
        self.desk.key("ctrl+s")
        text = self.desk.wait(lambda: (self.study / "study.toml").read_text())
        self.assertIn("participants = 4", text)
        self.assertRegex(text, r"(?m)^limit_s = 3 +# seconds; leave it out")
        self.assertNotIn('kind = "find"', text)
        lost = [line for line in before if line not in text.splitlines()]
        self.assertTrue(all("limit_s" in line or "find" in line or "qualities" in line or
                            line.startswith("#") or line in ("", "[[task]]") for line in lost), lost)

    def monitor(self):
        told = subprocess.run([PROMENADE, "monitor", self.study / "rehearsal.db", "--once", "--json"],
                              capture_output=True, text=True, timeout=60)
        sessions = json.loads(told.stdout)["sessions"] if told.returncode == 0 else []
        return [one for one in sessions if one["state"] == "running" and one["trial"]]

    def run_with_a_simulated_person(self):
        self.desk.go("rehearse")
        self.desk.press("one")
        seen = self.desk.wait(self.monitor, 60)[0]
        self.assertEqual(seen["kind"], "simulated")
        self.assertEqual(seen["trial"]["limit_s"], 3)
        self.desk.wait(lambda: self.desk.find("press", r"job\.close"), 200)
        database = sqlite3.connect(self.study / "rehearsal.db")
        self.assertEqual(database.execute("SELECT outcome, simulated FROM session").fetchall(),
                         [("finished", 1)])
        database.close()

    def rehearse_and_read_the_report(self):
        for _ in range(14):
            self.desk.click("less", "people")
        self.desk.press("many")
        page = self.study / "rehearsal-report" / "report.html"
        self.desk.wait(lambda: str(page) in self.desk.opened(), 120)
        self.assertIn("Walks of spring", page.read_text())

    def test_from_a_template_to_a_report(self):
        self.make()
        self.edit()
        self.run_with_a_simulated_person()
        self.rehearse_and_read_the_report()
        self.assertEqual(self.desk.close(), 0)


if __name__ == "__main__":
    unittest.main()

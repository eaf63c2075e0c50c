#!/usr/bin/env python3
"""From a design to a roster: targets by lot, lists, plans, minutes, codes and stations."""
import contextlib
import csv
import json
import os
import pathlib
import sqlite3
import unittest

from program import ProgramTest

STUDY = """[study]
name = "design"
seed = 5
participants = 14
most_minutes = {minutes}
[[interface]]
name = "labels"
[[interface]]
name = "weights"
[[task]]
name = "guess"
kind = "guess"
deal = "rotated"
targets = [{{ random = "weights", count = 4, draw = 20, name = "r" }}]
[[task]]
name = "match"
kind = "match"
start = "guess"
limit_s = 60
threshold = "auto"
[[task]]
name = "own"
kind = "match"
limit_s = 60
threshold = "auto"
targets = [{{ random = "weights", count = 1, per = "participant", name = "own" }}]
"""


class Design(ProgramTest):
    def study(self, minutes=60):
        return self.write("design.toml", STUDY.format(minutes=minutes))

    def document(self, *arguments):
        result = self.call(*arguments, "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads(result.stdout), result.stderr

    def test_check_judges_guesses_and_draws_and_tells_the_minutes(self):
        document, errors = self.document("check", self.study())
        study = document["studies"][0]
        self.assertTrue(0.5 < study["minutes"] < 60, study["minutes"])
        self.assertEqual(study["round"], 4)
        tasks = [(t["task"], t["target"], t["sequence"], t["start"]) for t in study["targets"]]
        self.assertIn(("guess", "r1", None, "average"), tasks)
        self.assertIn(("match", "r4", None, "guess"), tasks)
        self.assertEqual([t[2] for t in tasks if t[1] == "own1"], [0, 1, 2])
        for target in study["targets"]:
            for interface in target["interfaces"]:
                self.assertGreater(interface["d_start"], target["judged_by_m"])
        self.assertEqual(errors.count("a walk drawn for each participant is met by"), 1)
        self.assertIn("14 people are not balanced", errors)
        self.assertIn("12 or 16 are", errors)

    def test_check_warns_of_sessions_that_are_too_long(self):
        text = self.call("check", self.study(minutes=1))
        self.assertEqual(text.returncode, 0, text.stderr)
        self.assertRegex(text.stdout, r"about \d+ minutes")
        self.assertRegex(text.stderr, r"warning: a session takes about \d+ minutes")

    def test_a_plan_shows_lists_draws_and_counts(self):
        plan, _ = self.document("plan", self.study(), "--participants", "4")
        self.assertTrue(plan["balance"]["even"])
        self.assertEqual(plan["balance"]["lists"]["guess"], {"labels": [2, 2], "weights": [2, 2]})
        for sequence in plan["sequences"]:
            lists = sequence["lists"]["guess"]
            self.assertEqual(sorted(lists.values()), [1, 2])
            drawn = [t["weights"] for t in sequence["trials"] if t["task"] == "own"]
            self.assertEqual(drawn[0], drawn[1])
            self.assertAlmostEqual(sum(drawn[0].values()), 1, 9)
            dealt = {(t["interface"], t["target"]) for t in sequence["trials"]
                     if t["task"] == "guess"}
            self.assertEqual(len({target for _, target in dealt}), 4)
            self.assertEqual(len(dealt), 4)
            self.assertEqual(dealt, {(t["interface"], t["target"]) for t in sequence["trials"]
                                     if t["task"] == "match"})
        text = self.call("plan", self.study(), "--participants", "4").stdout
        self.assertIn("lists of guess", text)

    def test_targets_that_were_drawn_can_be_kept_in_a_file(self):
        study = self.study()
        result = self.call("model", "targets", study, "--save", "targets.csv")
        self.assertEqual(result.returncode, 0, result.stderr)
        text = (self.folder / study).read_text()
        drawn = '{ random = "weights", count = 4, draw = 20, name = "r" }'
        self.assertIn(drawn, text)
        fixed = self.write("fixed.toml", text.replace(drawn, '{ file = "targets.csv" }'))
        targets = [self.document("check", s)[0]["studies"][0]["targets"] for s in (study, fixed)]
        for one, two in zip(*targets):
            self.assertAlmostEqual(one["interfaces"][0]["d_start"],
                                   two["interfaces"][0]["d_start"], 12)

    def test_simulated_people_get_what_the_plan_says(self):
        result = self.call("simulate", self.study(), "--participants", "4", "--seed", "1", "--db",
                           "x.db")
        self.assertEqual(result.returncode, 0, result.stderr)
        with contextlib.closing(sqlite3.connect(self.folder / "x.db")) as db:
            counts = db.execute(
                "SELECT interface, target, count(*) FROM trial WHERE task = 'guess' GROUP BY 1, 2")
            self.assertEqual({count for _, _, count in counts}, {2})

    def roster(self, *arguments):
        return self.call("roster", self.study(), "--out", "roster.csv", *arguments)

    def rows(self):
        with open(self.folder / "roster.csv", newline="") as file:
            return list(csv.DictReader(file))

    def test_a_roster_is_dealt_marked_and_extended_and_loses_nothing(self):
        result = self.roster("--participants", "12", "--stations", "3", "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        stations = json.loads(result.stdout)["stations"]
        self.assertEqual([(s["people"], s["even"]) for s in stations], [(4, True)] * 3)
        first = self.rows()
        self.assertEqual([int(r["sequence"]) for r in first], list(range(12)))
        gone, late = first[4]["code"], first[7]["code"]
        self.assertEqual(self.roster("--no-show", gone.lower()).returncode, 0)
        self.assertEqual(self.roster("--replace", gone).returncode, 0)
        self.assertEqual(self.roster("--replace", late).returncode, 0)
        self.assertEqual(self.roster("--participants", "16", "--stations", "3").returncode, 0)
        rows = self.rows()
        self.assertEqual([r["code"] for r in rows[:12]], [r["code"] for r in first])
        self.assertEqual(rows[4]["state"], "replaced")
        self.assertEqual((rows[12]["replaces"], rows[12]["sequence"], rows[12]["station"]),
                         (gone, first[4]["sequence"], first[4]["station"]))
        self.assertEqual(len(rows), 12 + 2 + 4)

    def test_a_roster_refuses_what_it_does_not_have(self):
        self.assertEqual(self.roster().returncode, 2)
        self.assertEqual(self.roster("--no-show", "K7QX3").returncode, 2)
        self.assertFalse((self.folder / "roster.csv").exists())
        self.roster("--participants", "4", "--stations", "1")
        before = (self.folder / "roster.csv").read_bytes()
        code = self.rows()[0]["code"]
        typed = code[0] + code[2] + code[1] + code[3:]
        if typed == code:
            typed = ("2" if code[0] != "2" else "3") + code[1:]
        result = self.roster("--no-show", typed)
        self.assertEqual(result.returncode, 2)
        self.assertIn(f'did you mean "{code}"', result.stderr)
        self.assertEqual(self.roster("--participants", "2", "--stations", "1").returncode, 2)
        self.assertEqual(self.roster("--participants", "4", "--stations", "2").returncode, 2)
        self.assertEqual((self.folder / "roster.csv").read_bytes(), before)

    def test_a_broken_roster_is_refused_before_a_window_opens(self):
        self.write("roster.csv", "code,station,sequence,state,replaces\nAAAAA,1,0,boked,\n")
        result = self.call("run", self.study(), "--roster", "roster.csv", "--participant", "AAAAA",
                           "--db", "x.db")
        self.assertEqual(result.returncode, 2)
        self.assertIn("roster.csv:2:1: error", result.stderr)
        self.assertIn("did you mean \"booked\"", result.stderr)
        result = self.call("run", self.study(), "--roster", "roster.csv", "--db", "x.db")
        self.assertIn("roster.csv:2:1: error", result.stderr)
        self.assertFalse((self.folder / "x.db").exists())

    def test_a_roster_is_read_against_a_database_of_an_older_version(self):
        self.roster("--participants", "2", "--stations", "1")
        old = pathlib.Path(os.environ.get("PROMENADE_SOURCE_DIR", ".")) / "tests/study/old/v1.sql"
        with contextlib.closing(sqlite3.connect(self.folder / "old.db")) as database:
            database.executescript(old.read_text(encoding="utf-8"))
            code = self.rows()[0]["code"]
            database.execute("UPDATE participant SET code = ? WHERE code = 'S001'", (code,))
            database.commit()
        result = self.call("run", self.study(), "--roster", "roster.csv", "--participant", code,
                           "--autopilot", "1", "--db", "old.db")
        self.assertEqual(result.returncode, 2)
        self.assertIn("was already done by", result.stderr)
        result = self.roster("--done-in", "old.db")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual([row["state"] for row in self.rows()], ["done", "booked"])


if __name__ == "__main__":
    unittest.main()

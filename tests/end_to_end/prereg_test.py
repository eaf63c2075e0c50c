#!/usr/bin/env python3
"""A plan is registered, sealed by the study, and every report is held against it."""
import csv
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

PROMENADE = os.environ["PROMENADE"]
DEMO = pathlib.Path(os.environ["PROMENADE_SOURCE_DIR"], "configs", "demo.toml")
PLAN = """hypotheses = ["Labels are faster."]
participants = 6
stopping = "When six people have finished."

[[measure]]
name = "time_s"
task = "match"
"""


class Preregistration(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.folder = pathlib.Path(self.temporary.name)
        self.write("study.toml", DEMO.read_text())
        self.write("plan.toml", PLAN)

    def write(self, name, text):
        (self.folder / name).write_text(text)

    def promenade(self, *arguments, code=0):
        result = subprocess.run([PROMENADE, *map(str, arguments)], cwd=self.folder, text=True,
                                capture_output=True, timeout=600)
        self.assertEqual(result.returncode, code, result.stderr)
        return result.stderr

    def register(self, document="plan.md"):
        return self.promenade("prereg", "study.toml", "plan.toml", "--out", document)

    def seal(self, document="plan.md"):
        text = (self.folder / "study.toml").read_text()
        self.write("study.toml", text.replace("[study]\n", f'[study]\nprereg = "{document}"\n', 1))

    def simulate(self, people=6):
        self.promenade("simulate", "study.toml", "--participants", people, "--seed", 1, "--db",
                       "one.db")

    def report(self, document="plan.md"):
        self.promenade("report", "one.db", "--include-simulated", "--prereg", document, "--out",
                       "out")
        return json.loads((self.folder / "out" / "report.json").read_text())["prereg"]

    def test_what_was_sealed_and_done_has_no_deviation_but_that_nobody_was_real(self):
        self.assertIn('prereg = "plan.md"', self.register())
        self.seal()
        self.simulate()
        prereg = self.report()
        self.assertEqual(prereg["seal"], "sealed")
        self.assertEqual([one["found"] for one in prereg["deviations"]],
                         ["simulated participants are counted"])
        test, = prereg["tests"]
        self.assertEqual((test["measure"], test["n"], test["p_holm"]), ("time_s", 6, test["p"]))
        with (self.folder / "out" / "tables" / "prereg_tests.csv").open(newline="") as file:
            roles = [row["role"] for row in csv.DictReader(file)]
        self.assertEqual(roles.count("confirmatory"), 1)
        self.assertEqual(roles.count("exploratory"), prereg["exploratory"])

    def test_it_says_loudly_what_is_not_sealed(self):
        self.register()
        self.simulate(5)
        prereg = self.report()
        self.assertEqual(prereg["seal"], "none")
        found = " ".join(one["found"] for one in prereg["deviations"])
        self.assertIn("nothing is sealed", found)
        self.assertIn("5, too few", found)
        self.assertIn("never sealed", (self.folder / "out" / "report.html").read_text())

    def test_another_document_is_not_the_sealed_one(self):
        self.register()
        self.seal()
        self.simulate()
        self.write("plan.toml", PLAN.replace("time_s", "clicks"))
        self.register("other.html")
        self.assertEqual(self.report("other.html")["seal"], "other")

    def test_made_again_it_is_the_same_whether_it_is_sealed_or_not(self):
        self.register()
        before = (self.folder / "plan.md").read_bytes()
        self.seal()
        self.register()
        self.assertEqual((self.folder / "plan.md").read_bytes(), before)

    def test_a_packed_study_keeps_its_seal(self):
        self.register()
        self.seal()
        self.promenade("pack", "study.toml", "--out", "s.study")
        (self.folder / "plan.md").rename(self.folder / "kept.md")
        self.promenade("simulate", "s.study", "--participants", 6, "--seed", 1, "--db", "one.db")
        self.assertEqual(self.report("kept.md")["seal"], "sealed")

    def test_the_study_that_was_changed_since_is_warned_of(self):
        self.register()
        self.seal()
        text = (self.folder / "study.toml").read_text()
        self.write("study.toml", text.replace("limit_s = 45", "limit_s = 40"))
        said = self.promenade("check", "study.toml")
        self.assertIn("study.toml:", said)
        self.assertIn("was not written for this study as it stands now", said)

    def test_wrong_input_writes_nothing(self):
        self.write("plan.toml", PLAN.replace("time_s", "time").replace("match", "mach"))
        said = self.promenade("prereg", "study.toml", "plan.toml", "--out", "p.md", code=2)
        self.assertIn('plan.toml:6:8: error: the study has no measure "time"', said)
        self.assertIn('plan.toml:7:8: error: the study has no task "mach"; did you mean "match"?',
                      said)
        self.promenade("prereg", "study.toml", "no.toml", "--out", "p.md", code=2)
        self.promenade("prereg", "study.toml", "plan.toml", "--out", "p.txt", code=2)
        self.assertFalse((self.folder / "p.md").exists())

    def test_a_letter_is_no_preregistration(self):
        self.simulate(2)
        self.write("letter.md", "Dear reviewers")
        self.promenade("report", "one.db", "--include-simulated", "--prereg", "letter.md", "--out",
                       "out", code=2)
        self.assertFalse((self.folder / "out").exists())


if __name__ == "__main__":
    unittest.main()

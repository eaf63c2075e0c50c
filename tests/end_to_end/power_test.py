#!/usr/bin/env python3
"""How many people a study needs, as the command line tells it."""
import json
import unittest

from program import ProgramTest

STUDY = """
[study]
name = "walks"
version = "1"
order = "williams"
[[interface]]
name = "labels"
[[interface]]
name = "weights"
[[task]]
name = "match"
kind = "match"
limit_s = 20
targets = [{ example = "happy" }]
"""


class Power(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("walks.toml", STUDY)

    def power(self, *arguments):
        return self.call("power", "walks.toml", "--participants", "6,8", *arguments)

    def test_a_rehearsal_is_called_one_and_marks_what_is_not_balanced(self):
        done = self.call("power", "walks.toml", "--participants", "7,8", "--studies", "5")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("REHEARSAL", done.stdout)
        self.assertRegex(done.stderr, r"took [\d.]+ seconds of the processor")
        self.assertIn("7*", done.stdout)
        self.assertNotIn("8*", done.stdout)

    def test_sizes_that_can_find_nothing_are_named(self):
        few = self.call("power", "walks.toml", "--participants", "3,8", "--studies", "2")
        self.assertIn("With fewer than 6 people this test can find nothing", few.stdout)
        self.assertNotIn("With fewer than", self.power("--studies", "2").stdout)

    def test_json_does_not_depend_on_jobs(self):
        one = self.power("--studies", "8", "--json", "--jobs", "1", "--difficulty", "labels=3")
        two = self.power("--studies", "8", "--json", "--jobs", "2", "--difficulty", "labels=3")
        self.assertEqual(one.returncode, 0, one.stderr)
        self.assertEqual(one.stdout, two.stdout)
        power = json.loads(one.stdout)
        self.assertEqual(power["method"], "rehearsal")
        self.assertEqual([row["participants"] for row in power["tables"][0]["rows"]], [6, 8])

    def test_wrong_input_is_named(self):
        for wrong in (["--difficulty", "lables=2"], ["--difficulty", "labels=much"],
                      ["--task", "find"], ["--measure", "beauty"], ["--effect", "1"],
                      ["--from", "missing.db"], ["--alpha", "2"]):
            done = self.power(*wrong)
            self.assertEqual(done.returncode, 2, wrong)
            self.assertEqual(done.stdout, "")
            self.assertTrue(done.stderr)


if __name__ == "__main__":
    unittest.main()

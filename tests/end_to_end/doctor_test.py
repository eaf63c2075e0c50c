#!/usr/bin/env python3
"""The doctor on this machine, with and without a display: it says what, and leaves nothing."""
import json
import subprocess
import unittest

from program import PROMENADE, ProgramTest

TIDYING = 5  # of xvfb-run: it could not tidy up after itself


class Doctor(ProgramTest):
    def on_a_virtual_display(self, *arguments):
        return subprocess.run(["xvfb-run", "-a", "-s", "-screen 0 1280x720x24", PROMENADE, "doctor",
                               *arguments], cwd=self.folder, text=True, capture_output=True,
                              timeout=120)

    def test_without_a_display_it_says_so_and_checks_the_rest(self):
        result = self.call("doctor", "--json")
        self.assertEqual(result.returncode, 1)
        report = json.loads(result.stdout)
        self.assertFalse(report["fit"])
        self.assertEqual([check["name"] for check in report["checks"]],
                         ["display", "disk", "fonts", "clock"])
        self.assertIn("no display", report["checks"][0]["says"])
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_on_a_virtual_display_every_check_has_a_verdict(self):
        result = self.on_a_virtual_display("--json", "--seconds", "1.5")
        report = json.loads(result.stdout)
        # Whether frames come in time depends on what else runs here.
        self.assertIn(result.returncode, [0 if report["fit"] else 1, TIDYING], result.stderr)
        checks = {check["name"]: check for check in report["checks"]}
        self.assertEqual(list(checks), ["display", "renderer", "frames", "input", "disk", "fonts",
                                        "clock"])
        self.assertEqual(checks["renderer"]["verdict"], "warning", "llvmpipe is software")
        self.assertEqual(checks["display"]["figures"]["width"], 1280)
        self.assertEqual(checks["fonts"]["figures"]["missing"], [])
        for check in checks.values():
            self.assertIn(check["verdict"], ["ok", "warning", "failure"])
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_for_people_each_check_is_a_line(self):
        result = self.on_a_virtual_display("--seconds", "1")
        lines = result.stdout.splitlines()
        fit = "not fit" not in result.stderr
        self.assertEqual(len(lines), 8 if fit else 7, result.stdout)
        self.assertRegex(lines[0], r"^WARNING +display +1280 x 720 pixels")

    def test_wrong_options_are_input_errors(self):
        self.assertEqual(self.call("doctor", "--seconds", "0").returncode, 2)
        self.assertEqual(self.call("doctor", "study.toml").returncode, 2)


if __name__ == "__main__":
    unittest.main()

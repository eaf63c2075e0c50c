#!/usr/bin/env python3
"""The commands as their users call them: exit codes, places of errors, nothing left behind."""
import contextlib
import json
import os
import resource
import shutil
import signal
import sqlite3
import subprocess
import time
import unittest

from program import PROMENADE, ProgramTest

ALL = ["run", "check", "plan", "roster", "pack", "prereg", "amend", "withdraw", "simulate",
       "monitor", "report", "export", "replay", "merge", "power", "doctor", "set", "motion",
       "model", "graph", "stats"]


class Commands(ProgramTest):
    def left_behind(self):
        return sorted(p.name for p in self.folder.iterdir())

    def test_every_command_explains_itself(self):
        for command in ALL:
            result = self.call(command, "--help")
            self.assertEqual(result.returncode, 0, command)
            self.assertIn("Usage", result.stdout)

    def test_wrong_options_are_input_errors(self):
        self.assertEqual(self.call("check").returncode, 2)
        self.assertEqual(self.call("simulate", "configs/demo.toml", "--participants", "x")
                         .returncode, 2)
        result = self.call("simulate", "configs/demo.toml", "--participants", "1", "--seed", "-1",
                           "--db", "x.db")
        self.assertEqual(result.returncode, 2)
        self.assertIn("--seed", result.stderr)
        self.assertEqual(self.left_behind(), [])

    def test_a_mistyped_option_or_command_is_named_with_the_one_that_was_meant(self):
        for command, words in (
                (["report", "x.db", "--out", "r", "--exlude", "x.csv"],
                 'promenade report: error: there is no option --exlude; did you mean "--exclude"?'),
                (["repot", "x.db"], 'there is no command "repot"; did you mean "report"?'),
                (["set", "biuld", "x"], 'there is no command "biuld"; did you mean "build"?'),
                (["report", "x.db"], "promenade report: error: --out is required"),
                (["prereg", "a", "b", "c", "--out", "d.md"], '"c" is one word too many')):
            result = self.call(*command)
            self.assertEqual(result.returncode, 2, command)
            self.assertEqual(result.stdout, "")
            self.assertIn(words, result.stderr)
            self.assertIn("--help` lists", result.stderr)
        self.assertEqual(self.left_behind(), [])

    def test_the_embedded_demo_is_in_order(self):
        result = self.call("check", "configs/demo.toml")
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_a_broken_study_names_every_place_and_leaves_nothing(self):
        study = self.write("bad.toml", '[study]\nname = "x"\nsett = "builtin:A"\nseed = "one"\n')
        for command in (["check", study], ["run", study, "--db", "x.db"],
                        ["simulate", study, "--participants", "2", "--seed", "1", "--db", "x.db"]):
            result = self.call(*command)
            self.assertEqual(result.returncode, 2, command)
            self.assertRegex(result.stderr, r"bad\.toml:3:\d+: error: ")
            self.assertRegex(result.stderr, r"bad\.toml:4:\d+: error: ")
            self.assertIn("did you mean", result.stderr)
        self.assertEqual(self.left_behind(), ["bad.toml"])

    def test_missing_files_are_input_errors(self):
        for command in (["check", "none.toml"], ["report", "none.db", "--out", "r"],
                        ["stats", "none.json", "--json"], ["motion", "info", "none.bvh", "--json"],
                        ["set", "info", "none.set", "--json"],
                        ["set", "build", "none.toml", "--out", "s"]):
            result = self.call(*command)
            self.assertEqual(result.returncode, 2, command)
            self.assertIn("none", result.stderr)
        self.assertEqual(self.left_behind(), [])

    def test_running_without_a_display_is_refused_before_anything_is_written(self):
        result = self.call("run", "configs/demo.toml", "--db", "x.db")
        self.assertEqual(result.returncode, 1)
        self.assertIn("display", result.stderr)
        self.assertEqual(self.left_behind(), [])

    def test_output_that_cannot_be_written_is_an_error(self):
        with open("/dev/full", "w") as full:
            result = subprocess.run([PROMENADE, "set", "info", "builtin:A", "--json"], text=True,
                                    stdout=full, stderr=subprocess.PIPE, timeout=120)
        self.assertEqual(result.returncode, 1)
        self.assertIn("cannot write", result.stderr)

    def test_a_participant_code_is_checked_before_the_window(self):
        for code in ("", 41 * "x", "P\n1", b"P\xff"):
            result = self.call("run", "configs/demo.toml", "--db", "x.db", "--participant", code)
            self.assertEqual(result.returncode, 2, code)
            self.assertIn("--participant", result.stderr)
        self.assertEqual(self.left_behind(), [])

    def test_frames_of_positions_are_one_list(self):
        self.call("set", "export", "builtin:A", "--out", "out")
        capture = str(next((self.folder / "out").glob("*.bvh")))
        result = self.call("motion", "positions", "--frames", "0,5", capture, "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual([f["frame"] for f in json.loads(result.stdout)["frames"]], [0, 5])
        for frames in ("0,,1", "0,", "", ",", "x"):
            result = self.call("motion", "positions", capture, "--frames", frames)
            self.assertEqual(result.returncode, 2, frames)

    def test_a_wrong_word_among_frames_is_told_from_a_frame_that_is_not_there(self):
        self.call("set", "export", "builtin:A", "--out", "out")
        capture = str(next((self.folder / "out").glob("*.bvh")))
        result = self.call("motion", "positions", capture, "--frames", "0,x,99999999999,99999")
        self.assertEqual(result.returncode, 2)
        first, second, third = result.stderr.splitlines()
        self.assertIn("--frames: error: 'x' is no whole number", first)
        self.assertIn("has no frame '99999999999'; its frames are 0 to ", second)
        self.assertIn("has no frame '99999'; its frames are 0 to ", third)

    def test_a_capture_is_not_converted_onto_itself(self):
        self.call("set", "export", "builtin:A", "--out", "out")
        capture = next((self.folder / "out").glob("*.bvh"))
        before = capture.read_bytes()
        os.symlink(capture, self.folder / "link.bvh")
        for out in (str(capture), f"out/../out/{capture.name}", "link.bvh"):
            result = self.call("motion", "convert", str(capture), out)
            self.assertEqual(result.returncode, 2, out)
            self.assertIn("is the capture itself", result.stderr)
        self.assertEqual(capture.read_bytes(), before)

    def test_a_disk_that_refuses_is_left_as_it_was(self):
        def small_files():
            resource.setrlimit(resource.RLIMIT_FSIZE, (20_000, 20_000))

        for command in (["set", "export", "builtin:A", "--out", "new/deep"],
                        ["motion", "convert", "walk.bvh", "new/copy.bvh"],
                        ["simulate", "configs/demo.toml", "--participants", "1", "--seed", "1",
                         "--db", "x.db"]):
            self.call("set", "export", "builtin:A", "--out", "out")
            capture = next((self.folder / "out").glob("*.bvh"))
            capture.rename(self.folder / "walk.bvh")
            shutil.rmtree(self.folder / "out")
            result = self.call(*command, preexec_fn=small_files)
            self.assertEqual(result.returncode, 1, command)
            self.assertNotIn(".part", result.stderr)
            self.assertEqual(self.left_behind(), ["walk.bvh"], command)

    def test_what_a_map_cannot_have_is_not_quietly_made_less(self):
        result = self.call("model", "map", "builtin:A", "--components", "10", "--clusters", "11",
                           "--nearest", "11")
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertEqual(result.stderr.splitlines(),
                         ["--components: error: is 10, but builtin:A has only 9 components",
                          "--clusters: error: is 11, but builtin:A has only 10 cycles",
                          "--nearest: error: is 11, but builtin:A has only 10 cycles"])
        self.assertEqual(self.call("model", "map", "builtin:A", "--components", "9", "--clusters",
                                   "10", "--nearest", "10").returncode, 0)

    def test_a_database_that_is_cut_is_called_damaged(self):
        self.call("simulate", "configs/demo.toml", "--participants", "1", "--seed", "1", "--db",
                  "x.db")
        whole = (self.folder / "x.db").read_bytes()
        for size in (40, 100, 600, len(whole) // 2):
            (self.folder / "cut.db").write_bytes(whole[:size])
            result = self.call("report", "cut.db", "--out", "r", "--include-simulated")
            self.assertEqual(result.returncode, 2, size)
            self.assertIn("cut.db: error: is damaged", result.stderr)
        self.assertFalse((self.folder / "r").exists())

    def test_warnings_of_a_check_have_the_place_of_the_target(self):
        study = self.write("easy.toml", """[study]
name = "easy"
[[interface]]
name = "labels"
[[interface]]
name = "weights"
[[task]]
name = "copy"
kind = "match"
threshold = 0.01
targets = [{ example = "happy" },
  { name = "mixture", weights = { happy = 0.5, sad = 0.5 } }]
""")
        result = self.call("check", study, "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertRegex(result.stderr,
                         r'easy\.toml:12:3: warning: .*"mixture" seems out of reach')
        self.assertEqual(len([line for line in result.stderr.splitlines() if line]),
                         len([line for line in result.stderr.splitlines()
                              if line.startswith("easy.toml:1")]))

    def test_targets_without_a_threshold_are_judged_by_the_automatic_one(self):
        study = self.write("open.toml", """[study]
name = "open"
[[interface]]
name = "labels"
[[task]]
name = "copy"
kind = "match"
targets = [{ example = "happy" }]
""")
        target, = json.loads(self.call("check", study, "--json").stdout)["studies"][0]["targets"]
        shown = json.loads(self.call("model", "targets", study, "--json").stdout)["tasks"][0]
        self.assertIsNone(target["threshold_m"])
        self.assertEqual(target["judged_by_m"], shown["judged_by_m"])
        self.assertEqual(target["judged_by_m"], shown["automatic_threshold_m"])
        self.assertAlmostEqual(target["interfaces"][0]["share_below"], 0.1, delta=1e-12)

    def test_told_to_end_a_simulation_stops_between_participants(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            db = self.folder / f"{number}.db"
            running = subprocess.Popen(
                [PROMENADE, "simulate", "configs/demo.toml", "--participants", "100000", "--seed",
                 "1", "--db", db], cwd=self.folder, text=True, stderr=subprocess.PIPE,
                preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_DFL))  # nohup
            while running.poll() is None and not self.has_session(db):
                time.sleep(0.05)
            running.send_signal(number)
            said = running.communicate(timeout=120)[1]
            self.assertEqual(running.returncode, 1, said)
            self.assertIn("stopped after", said)

    def has_session(self, db):
        if not db.exists():
            return False
        try:
            with contextlib.closing(sqlite3.connect(f"file:{db}?mode=ro", uri=True)) as file:
                return file.execute("SELECT count(*) FROM session").fetchone()[0] > 0
        except sqlite3.OperationalError:
            return False

    def test_a_broken_capture_gives_place_and_reason(self):
        capture = self.write("cut.bvh", "HIERARCHY\nROOT Hips\n{\n  OFFSET 0 0 0\n")
        result = self.call("motion", "info", capture, "--json")
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr, r"cut\.bvh:\d+(:\d+)?: error: ")

    def test_every_builtin_set_is_described_and_exported(self):
        for name, walks in (("A", 10), ("B", 27), ("N", 55)):
            info = self.call("set", "info", f"builtin:{name}", "--json")
            self.assertEqual(info.returncode, 0, info.stderr)
            cycles = json.loads(info.stdout)["cycles"]
            self.assertEqual(len(cycles), walks)
            exported = self.call("set", "export", f"builtin:{name}", "--out", name)
            self.assertEqual(exported.returncode, 0, exported.stderr)
            self.assertEqual(sorted(p.stem for p in (self.folder / name).glob("*.bvh")),
                             sorted(c["name"] for c in cycles))

    def test_an_unknown_builtin_set_is_an_input_error_that_names_the_others(self):
        result = self.call("set", "info", "builtin:C", "--json")
        self.assertEqual(result.returncode, 2)
        self.assertIn("builtin:A", result.stderr)


if __name__ == "__main__":
    unittest.main()

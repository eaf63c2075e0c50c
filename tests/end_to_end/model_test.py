#!/usr/bin/env python3
"""The models from outside: what `promenade model` says agrees with what it exports."""
import contextlib
import json
import math
import sqlite3
import unittest

from program import ProgramTest


def unit(index, count=10):
    return ",".join("1" if i == index else "0" for i in range(count))


def farthest(a, b):
    return max(math.dist(p, q) for f, g in zip(a, b) for p, q in zip(f, g))


class Model(ProgramTest):
    def document(self, *arguments):
        result = self.call(*arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads(result.stdout)

    def test_a_unit_weight_gives_the_exported_cycle(self):
        names = [c["name"] for c in self.document("set", "info", "builtin:A", "--json")["cycles"]]
        self.assertEqual(self.call("set", "export", "builtin:A", "--out", "out").returncode, 0)
        for index in (0, 5):
            blend = self.document("model", "blend", "builtin:A", "--weights", unit(index), "--json")
            frames = ",".join(str(f) for f in range(blend["frames"]))
            path = f"out/{names[index]}.bvh"
            there = self.document("motion", "positions", path, "--frames", frames, "--json")
            self.assertEqual(blend["joints"], there["joints"])
            self.assertLess(farthest(blend["positions"],
                                     [f["positions"] for f in there["frames"]]), 1e-9)

    def test_keytimes_of_a_blend_are_blended(self):
        cycles = self.document("set", "info", "builtin:A", "--json")["cycles"]
        blend = self.document("model", "blend", "builtin:A", "--weights", "0.5,0,0,0,0,0,0,0.5,0,0")
        for k, time in enumerate(blend["keytimes"]):
            self.assertAlmostEqual(
                time, 0.5 * (cycles[0]["keytimes"][k] + cycles[7]["keytimes"][k]), delta=1e-12)

    def test_weights_must_fit_the_set(self):
        for wrong in ("1,0", unit(3) + ",1", "0.5" + unit(1)[1:], "a," + unit(0, 9)):
            result = self.call("model", "blend", "builtin:A", "--weights", wrong)
            self.assertEqual((result.returncode, result.stdout), (2, ""), wrong)
            self.assertIn("--weights", result.stderr)

    def test_the_map_gives_an_example_at_its_own_place(self):
        dots = self.document("model", "map", "builtin:A")["examples"]
        at = f"{dots[4]['x']!r},{dots[4]['y']!r}"
        point = self.document("model", "map", "builtin:A", "--at=" + at)["point"]
        self.assertAlmostEqual(point["weights"]["weights"][4], 1, delta=1e-9)
        for heuristic in ("zero", "closest", "weights"):
            self.assertAlmostEqual(sum(point[heuristic]["weights"]), 1, delta=1e-9)

    def test_there_are_51_features_of_each_cycle(self):
        features = self.document("model", "features", "builtin:A", "--json")
        self.assertEqual(len(set(features["features"])), 51)
        self.assertEqual({len(row["values"]) for row in features["rows"]}, {51})
        table = self.call("model", "features", "builtin:A", "--csv").stdout.splitlines()
        self.assertEqual(table[0].split(",")[1:], features["features"])
        self.assertEqual([float(v) for v in table[1].split(",")[1:]],
                         features["rows"][0]["values"])

    def test_ratings_become_primary_parameters(self):
        path = self.folder / "ratings.csv"
        rows = [f"{rater},{motion},{pair},{value}"
                for rater in "xy" for pair in ("slow-fast", "dull-quick", "sad-happy")
                for motion, value in (("a", -2), ("b", 0), ("c", 2))]
        path.write_text("rater,motion,pair,value\n" + "\n".join(rows) + "\n")
        found = self.document("model", "adjectives", str(path), "--clusters", "1")
        self.assertEqual(found["primary"], [[0, 0.5, 1]])
        self.assertEqual([p["fate"] for p in found["pairs"]], ["kept"] * 3)

    def test_targets_show_all_five_interfaces_and_agree_with_check(self):
        shown = self.document("model", "targets", "configs/demo.toml", "--json")
        self.assertEqual(shown, self.document("model", "targets", "configs/demo.toml", "--json"))
        self.assertTrue(shown["adjectives"]["simulated"])
        checked = self.document("check", "configs/demo.toml", "--json")["studies"][0]["targets"]
        for target in shown["tasks"][0]["targets"]:
            by_name = {row["interface"]: row for row in target["interfaces"]}
            self.assertEqual(sorted(by_name), ["adjectives", "features", "labels", "map",
                                               "weights"])
            self.assertEqual({n for n, row in by_name.items() if row["used"]},
                             {"labels", "weights"})
            for row in by_name.values():
                self.assertLessEqual(row["d_best"], row["d_start"])
                self.assertTrue(0 <= row["share_below"] <= 1)
            self.assertAlmostEqual(by_name["labels"]["d_best"], target["d_best_example"], 12)
            same = [t for t in checked if t["target"] == target["target"]][0]
            for row in same["interfaces"]:
                for key in ("d_start", "d_best", "share_below"):
                    self.assertEqual(row[key], by_name[row["name"]][key])
        self.assertAlmostEqual(shown["tasks"][0]["automatic_threshold_m"],
                               shown["tasks"][0]["threshold_m"], delta=1e-12)

    def test_targets_of_a_set_that_nobody_rated_have_predicted_adjectives(self):
        self.call("model", "raters", "builtin:A", "--out", "a.csv")
        study = self.write("s.toml", '[study]\nname = "s"\nset = "builtin:N"\n[[interface]]\n'
                           'name = "labels"\n[[task]]\nname = "t"\nkind = "match"\n'
                           'targets = [{ example = "bouncy" }]\n')
        names = [c["name"] for c in self.document("set", "info", "builtin:N", "--json")["cycles"]]
        study = self.write("s.toml", (self.folder / study).read_text().replace("bouncy", names[3]))
        found = self.document("model", "targets", study, "--predict", "a.csv", "--set", "builtin:A")
        again = self.document("model", "targets", study, "--predict", "builtin:A")
        self.assertTrue(found["adjectives"]["predicted"])
        self.assertTrue(found["adjectives"]["simulated"])
        rated = self.document("model", "adjectives", "builtin:A")
        self.assertEqual(found["controls"]["adjectives"], [c["name"] for c in rated["clusters"]])
        self.assertEqual(found["adjectives"]["left_out_error"],
                         rated["prediction"]["left_out_error"])
        self.assertEqual(found["missing"], [])
        self.assertEqual(found["tasks"], again["tasks"])
        self.assertEqual(self.call("model", "targets", study, "--predict", "a.csv").returncode, 2)

    def test_simulated_raters_write_the_ratings_of_the_default_model(self):
        model = self.document("model", "adjectives", "builtin:A")
        self.assertTrue(model["simulated"])
        self.assertEqual({c["name"] for c in model["clusters"]},
                         {"quickness", "clearness", "activeness", "largeness"})
        path = self.folder / "ratings.csv"
        made = self.call("model", "raters", "builtin:A", "--out", str(path))
        self.assertEqual(made.returncode, 0, made.stderr)
        self.assertEqual(len(path.read_text().splitlines()), 1 + 14 * 41 * 10)
        again = self.document("model", "adjectives", str(path), "--set", "builtin:A")
        self.assertTrue(again["simulated"])
        self.assertEqual(again["primary"], model["primary"])
        self.assertEqual(again["prediction"]["left_out"], model["prediction"]["left_out"])
        self.assertEqual(self.call("model", "raters", "mine").returncode, 2)

    def test_a_study_takes_its_adjectives_from_ratings(self):
        self.call("model", "raters", "builtin:A", "--out", "r.csv")
        study = self.write("s.toml", '[study]\nname = "s"\nratings = "r.csv"\n[[interface]]\n'
                           'name = "adjectives"\n[[task]]\nname = "t"\nkind = "find"\n'
                           'qualities = [{ name = "tired" }]\n')
        simulated = self.document("check", study, "--json")["studies"][0]
        self.assertTrue(any("simulated raters" in p["message"] for p in simulated["problems"]))
        people = (self.folder / "r.csv").read_text().replace("simulated-", "person-")
        self.write("r.csv", people)
        real = self.document("check", study, "--json")["studies"][0]
        self.assertEqual(real["problems"], [])
        self.assertNotEqual(real["sha256"], simulated["sha256"])
        self.write("r.csv", people + "person-01,nobody,slow-fast,1\n")
        refused = self.call("check", study)
        self.assertEqual(refused.returncode, 2)
        self.assertIn("r.csv:5742:", refused.stderr)

    def test_dropped_pairs_say_by_which_threshold(self):
        for pair in self.document("model", "adjectives", "builtin:A")["pairs"]:
            by = (["mu_star"] if pair["mu_star"] < 1.0 else [])
            by += ["sigma"] if pair["sigma"] > 0.85 else []
            self.assertEqual(pair["dropped_by"], by)
            self.assertEqual(pair["fate"] == "kept", not by)

    def test_adjectives_of_a_set_that_nobody_rated_are_predicted(self):
        found = self.document("model", "adjectives", "builtin:B", "--predict", "builtin:B")
        rows = found["prediction"]["rows"]
        self.assertEqual([r["name"] for r in rows], found["motions"])
        for c, error in enumerate(found["prediction"]["left_out_error"]):
            self.assertLess(error, found["prediction"]["error_of_the_mean"][c])
            # In the sample the fit is better than left out.
            squares = [(r["values"][c] - v) ** 2 for r, v in zip(rows, found["primary"][c])]
            self.assertLess(math.sqrt(sum(squares) / len(rows)), error)

    def test_ratings_come_from_a_database_too(self):
        path = str(self.folder / "rated.db")
        made = self.call("simulate", "configs/demo.toml", "--participants", "2", "--seed", "3",
                    "--db", path)
        self.assertEqual(made.returncode, 0, made.stderr)
        self.assertIn("holds no ratings", self.call("model", "adjectives", path).stderr)
        with contextlib.closing(sqlite3.connect(path)) as database, database:
            trials = database.execute("SELECT session, uuid FROM trial WHERE practice = 0 "
                                      "AND target = 'proud'").fetchall()
            for session, trial in trials:
                database.execute(
                    "INSERT INTO answer(session, trial, instrument, version, item, value, "
                    "declined, touched, t_us) VALUES (?, ?, 'rate', '1', 'slow-fast', 2, 0, 1, 0)",
                    (session, trial))
        self.assertEqual(self.call("model", "adjectives", path).returncode, 2)
        found = self.document("model", "adjectives", path, "--include-simulated")
        self.assertTrue(found["simulated"])
        self.assertEqual(found["raters"], 2)
        proud = found["motions"].index("proud")
        self.assertEqual(found["pairs"][0]["mean"][proud], 2)

    def test_pictures_are_written_whole_or_not_at_all(self):
        dots = "map.svg"
        strips = "strips.svg"
        made = self.call("model", "map", "builtin:A", "--picture", dots, "--heuristics", strips,
                    "--at=1,-1")
        self.assertEqual((made.returncode, made.stdout), (0, ""), made.stderr)
        for path in (dots, strips):
            self.assertIn("</svg>", (self.folder / path).read_text())
        self.assertIn("sneaky", (self.folder / dots).read_text())
        for wrong in (("--picture", dots + ".txt"), ("--heuristics", strips)):
            self.assertEqual(self.call("model", "map", "builtin:A", *wrong).returncode, 2)
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()),
                         ["map.svg", "strips.svg"])


if __name__ == "__main__":
    unittest.main()

#!/usr/bin/env python3
"""The models from outside: what `promenade model` says agrees with what it exports."""
import contextlib
import json
import math
import random
import sqlite3
import unittest

from program import ProgramTest


STUDY = """[study]
name = "s"
ratings = "{ratings}"
[[interface]]
name = "adjectives"
[[task]]
name = "t"
kind = "match"
limit_s = 20
targets = [{{ example = "old" }}]
"""


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
                for rater in "uvwxyz" for pair in ("slow-fast", "dull-quick", "sad-happy")
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

    def test_ratings_that_do_not_agree_make_no_sliders(self):
        draw = random.Random(5)
        rows = [f"{rater},{motion},{pair},{draw.randint(-2, 2)}"
                for rater in range(14) for motion in self.motions()
                for pair in ("slow-fast", "sad-happy", "old-young", "weak-strong", "dark-bright")]
        self.write("random.csv", "rater,motion,pair,value\n" + "\n".join(rows) + "\n")
        told = self.call("model", "adjectives", "random.csv", "--json")
        self.assertEqual(told.returncode, 0)
        found = json.loads(told.stdout)
        self.assertFalse(found["agrees"])
        self.assertIn("the ratings do not agree: 0 of 5 pairs are left", told.stderr)
        self.assertEqual(found["agreement"]["sentence"], told.stderr.strip().split(": ", 1)[1])
        self.assertLess(abs(found["agreement"]["alpha"]["ordinal"]), 0.2)
        for rater in found["by_rater"]:
            self.assertLess(abs(rater["correlation"]), 0.6)
        refused = self.call("model", "adjectives", "random.csv", "--out", "m.toml")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("do not agree", refused.stderr)
        self.assertFalse((self.folder / "m.toml").exists())
        study = self.write("s.toml", STUDY.format(ratings="random.csv"))
        refused = self.call("check", study)
        self.assertEqual(refused.returncode, 2)
        self.assertIn("s.toml:3:", refused.stderr)
        self.assertIn("do not agree", refused.stderr)

    def test_a_rater_who_answers_at_random_shows(self):
        self.call("model", "raters", "builtin:A", "--raters", "6", "--out", "r.csv")
        draw = random.Random(1)
        lines = (self.folder / "r.csv").read_text().splitlines()
        bad = [line.rsplit(",", 1)[0] + f",{draw.randint(-2, 2)}" if line.startswith("simulated-04")
               else line for line in lines]
        self.write("r.csv", "\n".join(bad) + "\n")
        raters = self.document("model", "adjectives", "r.csv")["by_rater"]
        worst = min(raters, key=lambda rater: rater["correlation"])
        self.assertEqual(worst["rater"], "simulated-04")
        self.assertLess(worst["correlation"], 0.2)
        self.assertTrue(all(r["correlation"] > 0.4 for r in raters if r is not worst))

    def test_a_model_file_keeps_what_was_chosen(self):
        made = self.call("model", "adjectives", "builtin:A", "--clusters", "3", "--names",
                         "haste,poise,size", "--names-ja", "速さ,確かさ,大きさ", "--out", "m.toml")
        self.assertEqual((made.returncode, made.stdout), (0, ""), made.stderr)
        self.assertIn("simulated raters", made.stderr)
        model = self.document("model", "adjectives", "m.toml", "--set", "builtin:A")
        self.assertEqual([c["name"] for c in model["clusters"]], ["haste", "poise", "size"])
        self.assertTrue(model["simulated"])
        table = self.document("model", "adjectives", "builtin:A", "--clusters", "3")
        self.assertEqual(model["primary"], table["primary"])
        self.call("model", "adjectives", "m.toml", "--out", "again.toml")
        self.assertEqual((self.folder / "again.toml").read_text(),
                         (self.folder / "m.toml").read_text())
        other = self.document("model", "adjectives", "m.toml", "--clusters", "4")
        self.assertNotIn("haste", [c["name"] for c in other["clusters"]])
        study = self.write("s.toml", STUDY.format(ratings="m.toml"))
        checked = self.call("check", study, "--json")
        self.assertEqual(checked.returncode, 0, checked.stderr)
        problems = json.loads(checked.stdout)["studies"][0]["problems"]
        self.assertTrue(any("simulated raters" in p["message"] for p in problems))
        run = self.call("simulate", study, "--participants", "1", "--seed", "1", "--db", "s.db")
        self.assertEqual(run.returncode, 0, run.stderr)
        with contextlib.closing(sqlite3.connect(self.folder / "s.db")) as database:
            touched = {row[0] for row in database.execute("SELECT DISTINCT target FROM event")}
        self.assertTrue(touched & {"haste", "poise", "size"})
        audit = self.call("replay", "s.db", "--audit")
        self.assertEqual(audit.returncode, 0, audit.stderr)
        page = self.call("report", "s.db", "--include-simulated", "--out", "page")
        self.assertEqual(page.returncode, 0, page.stderr)
        written = json.loads((self.folder / "page/report.json").read_text())
        self.assertTrue(written["adjectives"]["simulated"])
        self.assertIn("simulated raters (14 simulated raters", " ".join(written["methods"]))
        (self.folder / "m.toml").unlink()
        packed = self.call("replay", "s.db", "--audit")
        self.assertEqual(packed.returncode, 0, "the database holds the model")

    def test_names_are_refused_that_no_slider_can_have(self):
        for names, words in (("a,b", "2 names for 4 clusters"), ("a,a,b,c", "another slider"),
                             ("slow-fast,a,b,c", "pair of adjectives"), ("a/b,c,d,e", "\"/\"")):
            refused = self.call("model", "adjectives", "builtin:A", "--names", names, "--out",
                                "m.toml")
            self.assertEqual(refused.returncode, 2, names)
            self.assertIn(words, refused.stderr)
        refused = self.call("model", "adjectives", "builtin:A", "--out", "m.json")
        self.assertEqual(refused.returncode, 2)

    def test_clusters_are_held_against_the_printed_ones(self):
        adjectives = self.document("model", "adjectives", "builtin:A")
        for name in ("set_a", "set_b"):
            printed = adjectives["printed"][name]
            self.assertEqual(printed["count"], len(printed["pairs"]))
            self.assertEqual(printed["count"] + len(printed["not_printed"]),
                             len(adjectives["leaves"]))
            self.assertTrue(-0.5 < printed["rand_index"] <= 1)
        self.assertGreater(adjectives["printed"]["set_a"]["rand_index"], 0.3)
        features = self.document("model", "features", "builtin:B", "--clusters", "4")
        self.assertEqual(features["printed"]["set_b"]["count"], 50)
        self.assertEqual(features["printed"]["set_b"]["not_printed"],
                         ["sigma_com-velocity_left-right"])
        self.assertEqual(len(features["merges"]), 50)

    def test_dendrograms_are_drawn(self):
        for ending, beginning in (("svg", b"<?xml"), ("pdf", b"%PDF"), ("png", b"\x89PNG")):
            drawn = self.call("model", "adjectives", "builtin:A", "--picture", f"a.{ending}")
            self.assertEqual((drawn.returncode, drawn.stdout), (0, ""), drawn.stderr)
            self.assertTrue((self.folder / f"a.{ending}").read_bytes().startswith(beginning))
        picture = (self.folder / "a.svg").read_text()
        for words in ("Simulated raters", "quickness", "slow – fast", "Left out"):
            self.assertIn(words, picture)
        drawn = self.call("model", "features", "builtin:B", "--picture", "f.svg")
        self.assertEqual(drawn.returncode, 0, drawn.stderr)
        self.assertIn("v_step-length_front-back", (self.folder / "f.svg").read_text())
        self.assertEqual(self.call("model", "features", "builtin:B", "--picture",
                                   "f.gif").returncode, 2)

    def motions(self):
        return [c["name"] for c in self.document("set", "info", "builtin:A", "--json")["cycles"]]

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

#!/usr/bin/env python3
"""The models from outside: what `promenade model` says agrees with what it exports."""
import json
import math
import os
import pathlib
import subprocess
import tempfile
import unittest

PROMENADE = os.environ["PROMENADE"]


def call(*arguments):
    return subprocess.run([PROMENADE, *arguments], text=True, capture_output=True, timeout=120)


def document(*arguments):
    result = call(*arguments)
    assert result.returncode == 0, result.stderr
    return json.loads(result.stdout)


def unit(index, count=10):
    return ",".join("1" if i == index else "0" for i in range(count))


def farthest(a, b):
    return max(math.dist(p, q) for f, g in zip(a, b) for p, q in zip(f, g))


class Model(unittest.TestCase):
    def test_a_unit_weight_gives_the_exported_cycle(self):
        names = [c["name"] for c in document("set", "info", "builtin:A", "--json")["cycles"]]
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(call("set", "export", "builtin:A", "--out", folder).returncode, 0)
            for index in (0, 5):
                blend = document("model", "blend", "builtin:A", "--weights", unit(index), "--json")
                frames = ",".join(str(f) for f in range(blend["frames"]))
                path = str(pathlib.Path(folder) / (names[index] + ".bvh"))
                there = document("motion", "positions", path, "--frames", frames, "--json")
                self.assertEqual(blend["joints"], there["joints"])
                self.assertLess(farthest(blend["positions"],
                                         [f["positions"] for f in there["frames"]]), 1e-9)

    def test_keytimes_of_a_blend_are_blended(self):
        cycles = document("set", "info", "builtin:A", "--json")["cycles"]
        blend = document("model", "blend", "builtin:A", "--weights", "0.5,0,0,0,0,0,0,0.5,0,0")
        for k, time in enumerate(blend["keytimes"]):
            self.assertAlmostEqual(
                time, 0.5 * (cycles[0]["keytimes"][k] + cycles[7]["keytimes"][k]), delta=1e-12)

    def test_weights_must_fit_the_set(self):
        for wrong in ("1,0", unit(3) + ",1", "0.5" + unit(1)[1:], "a," + unit(0, 9)):
            result = call("model", "blend", "builtin:A", "--weights", wrong)
            self.assertEqual((result.returncode, result.stdout), (2, ""), wrong)
            self.assertIn("--weights", result.stderr)

    def test_the_map_gives_an_example_at_its_own_place(self):
        dots = document("model", "map", "builtin:A")["examples"]
        at = f"{dots[4]['x']!r},{dots[4]['y']!r}"
        point = document("model", "map", "builtin:A", "--at=" + at)["point"]
        self.assertAlmostEqual(point["weights"]["weights"][4], 1, delta=1e-9)
        for heuristic in ("zero", "closest", "weights"):
            self.assertAlmostEqual(sum(point[heuristic]["weights"]), 1, delta=1e-9)

    def test_there_are_51_features_of_each_cycle(self):
        features = document("model", "features", "builtin:A", "--json")
        self.assertEqual(len(set(features["features"])), 51)
        self.assertEqual({len(row["values"]) for row in features["rows"]}, {51})
        table = call("model", "features", "builtin:A", "--csv").stdout.splitlines()
        self.assertEqual(table[0].split(",")[1:], features["features"])
        self.assertEqual([float(v) for v in table[1].split(",")[1:]],
                         features["rows"][0]["values"])

    def test_ratings_become_primary_parameters(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "ratings.csv"
            rows = [f"{rater},{motion},{pair},{value}"
                    for rater in "xy" for pair in ("slow-fast", "dull-quick", "sad-happy")
                    for motion, value in (("a", -2), ("b", 0), ("c", 2))]
            path.write_text("rater,motion,pair,value\n" + "\n".join(rows) + "\n")
            found = document("model", "adjectives", str(path), "--clusters", "1")
            self.assertEqual(found["primary"], [[0, 0.5, 1]])
            self.assertEqual([p["fate"] for p in found["pairs"]], ["kept"] * 3)


if __name__ == "__main__":
    unittest.main()

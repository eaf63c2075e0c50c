#!/usr/bin/env python3
"""Motion graphs as people use them: build, walk, follow a path; and what they get wrong."""
import csv
import json
import math
import os
import subprocess
import tempfile
import unittest

PROMENADE = os.environ["PROMENADE"]


class Graph(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.own = tempfile.TemporaryDirectory()
        cls.folder = cls.own.name
        cls.graph = cls.file("b.graph")
        cls.built = cls.json("graph", "build", "builtin:B", "--rate", "30", "--out", cls.graph,
                             "--table", cls.file("b.csv"), "--pictures", cls.file("pictures"))

    @classmethod
    def tearDownClass(cls):
        cls.own.cleanup()

    @classmethod
    def file(cls, name):
        return os.path.join(cls.folder, name)

    @staticmethod
    def call(*words):
        return subprocess.run([PROMENADE, *words], capture_output=True, text=True, timeout=300,
                              check=False)

    @classmethod
    def json(cls, *words):
        done = cls.call(*words, "--json")
        assert done.returncode == 0, done.stderr
        return json.loads(done.stdout)

    def refused(self, *words):
        done = self.call(*words)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(done.stdout, "")
        return done.stderr

    @classmethod
    def positions(cls, name, frames):
        numbers = ",".join(map(str, range(frames)))
        document = cls.json("motion", "positions", name, "--frames", numbers)
        return [frame["positions"] for frame in document["frames"]]

    @staticmethod
    def largest_gap(poses):
        """The largest second difference of a joint's place."""
        return max(math.dist([a + c for a, c in zip(before, after)], [2 * b for b in now])
                   for one, two, three in zip(poses, poses[1:], poses[2:])
                   for before, now, after in zip(one, two, three))

    def test_every_transition_is_smooth_and_stands_still(self):
        with open(self.file("b.csv"), encoding="utf-8") as table:
            rows = list(csv.DictReader(table))
        used = [row for row in rows if not row["refused"]]
        self.assertEqual(len(used), self.built["transitions"])
        self.assertGreater(len(used), 100)
        self.assertEqual(len(rows) - len(used), self.built["refused"])
        for row in used:
            self.assertLess(float(row["slide_m"]), 0.005)
            self.assertLessEqual(float(row["rms_m"]), self.built["threshold_m"])
            self.assertLessEqual(float(row["gap_m"]), max(float(row["inside_gap_m"]), 0.0005))

    def test_has_pictures(self):
        for name in ("distances.svg", "graph.svg"):
            with open(os.path.join(self.file("pictures"), name), encoding="utf-8") as picture:
                self.assertTrue(picture.read().rstrip().endswith("</svg>"))

    def test_a_walk_is_as_smooth_as_the_walks_it_is_made_of(self):
        walk = self.json("graph", "walk", self.graph, "--seconds", "20", "--seed", "3", "--out",
                         self.file("walk.bvh"))
        self.assertGreater(walk["transitions"], 5)
        self.assertGreaterEqual(walk["seconds"], 20)
        with open(self.file("b.csv"), encoding="utf-8") as table:
            inside = max(float(row["inside_gap_m"]) for row in csv.DictReader(table))
        rounding = 1e-5  # poses of transitions are kept in single precision
        self.assertLess(self.largest_gap(self.positions(self.file("walk.bvh"), walk["frames"])),
                        inside + rounding)

    def test_styles_come_one_after_the_other(self):
        labels = sorted({take["label"] for take in self.built["takes"]}
                        - set(self.built["labels_lost"]))
        first, second = labels[0], labels[-1]
        walk = self.json("graph", "walk", self.graph, "--show", f"{first}=3,{second}=3", "--out",
                         self.file("two.bvh"), "--picture", self.file("two.svg"))
        self.assertEqual(walk["parts"][0]["label"], first)
        self.assertEqual(walk["parts"][-1]["label"], second)
        self.assertAlmostEqual(walk["seconds"], 6, delta=1)
        self.assertTrue(os.path.exists(self.file("two.svg")))

    def test_the_same_seed_is_the_same_walk(self):
        for name in ("one.bvh", "same.bvh", "other.bvh"):
            seed = "8" if name == "other.bvh" else "7"
            self.json("graph", "walk", self.graph, "--seed", seed, "--out", self.file(name))
        read = {name: open(self.file(name), "rb").read()
                for name in ("one.bvh", "same.bvh", "other.bvh")}
        self.assertEqual(read["one.bvh"], read["same.bvh"])
        self.assertNotEqual(read["one.bvh"], read["other.bvh"])

    def test_a_path_is_followed(self):
        with open(self.file("path.csv"), "w", encoding="utf-8") as path:
            path.write("x,z\n1,2\n4,6\n7,10\n")  # 10 m, not ahead
        walk = self.json("graph", "path", self.graph, "--path", self.file("path.csv"), "--out",
                         self.file("path.bvh"))
        self.assertAlmostEqual(walk["path_m"], 10)
        self.assertAlmostEqual(walk["walked_m"], 10, delta=0.3)
        self.assertLess(walk["rms_m"], 0.3)
        feet = self.positions(self.file("path.bvh"), walk["frames_on_path"])
        self.assertLess(math.dist(feet[0][0][::2], (1, 2)), 0.3)
        self.assertLess(math.dist(feet[-1][0][::2], (7, 10)), 0.6)

    def test_bad_input_is_refused_with_its_place(self):
        broken = self.file("broken.csv")
        with open(broken, "w", encoding="utf-8") as path:
            path.write("x,z,lable\n0,0,\n1,one,\n")
        out = self.file("never.bvh")
        self.assertIn("did you mean \"label\"?", self.refused(
            "graph", "path", self.graph, "--path", broken, "--out", out))
        with open(broken, "w", encoding="utf-8") as path:
            path.write("x,z,label\n0,0,\n0,3,cheerfull\n")
        self.assertIn("cheerfull", self.refused(
            "graph", "path", self.graph, "--path", broken, "--out", out))
        self.assertIn("cheerfull", self.refused(
            "graph", "walk", self.graph, "--show", "cheerfull=4", "--out", out))
        self.assertIn("happy=4,sad=4", self.refused(
            "graph", "walk", self.graph, "--show", "happy", "--out", out))
        self.assertIn("is not a motion graph", self.refused(
            "graph", "walk", broken, "--out", out))
        self.assertFalse(os.path.exists(out))

    def test_a_graph_without_a_walk_is_not_written(self):
        out = self.file("none.graph")
        said = self.refused("graph", "build", "builtin:A", "--threshold", "1e-9", "--labels", "sad",
                            "--window", "2", "--out", out)
        self.assertIn("raise the threshold", said)
        self.assertFalse(os.path.exists(out))
        self.assertIn("did you mean", self.refused(
            "graph", "build", "builtin:A", "--labels", "sadd", "--out", out))
        self.assertIn("as in sad,happy=0.04", self.refused(
            "graph", "build", "builtin:A", "--between", "sad=1", "--out", out))


if __name__ == "__main__":
    unittest.main()

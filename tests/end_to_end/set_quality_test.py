#!/usr/bin/env python3
"""Sets cut from real captures, judged from outside: the exported BVH files by forward
kinematics of the test's own. Needs ../shared/data beside the tree, or $PROMENADE_DATA."""
import math
import os
import pathlib
import unittest

from set_test import MotionTest, poses_of, read_bvh

DATA = pathlib.Path(os.environ.get("PROMENADE_DATA") or
                    pathlib.Path(os.environ["PROMENADE_SOURCE_DIR"]) / "../shared/data")


def minus(a, b):
    return [p - q for p, q in zip(a, b)]


def heel_of(ankle, toe, shape=None):
    """Behind the ankle and under it in the plane of the foot; its shape if none is given."""
    length = math.dist(ankle, toe)
    along = [d / length for d in minus(toe, ankle)]
    # down = along x across, across = along x Y, scaled to 1
    across = [-along[2], 0, along[0]]
    size = math.hypot(*across)
    across = [c / size for c in across]
    down = [along[1] * across[2] - along[2] * across[1],
            along[2] * across[0] - along[0] * across[2],
            along[0] * across[1] - along[1] * across[0]]
    if shape is None:
        foot = minus(toe, ankle)
        heel = [-0.25 * foot[0], foot[1], -0.25 * foot[2]]
        return (sum(h * a for h, a in zip(heel, along)), sum(h * d for h, d in zip(heel, down)))
    return [p + shape[0] * a + shape[1] * d for p, a, d in zip(ankle, along, down)]


class Walk:
    """One exported cycle, three times in a row over the ground."""

    def __init__(self, cycle, body, text):
        joints, frames, self.frame_time = read_bvh(text)
        index = {joint[0]: j for j, joint in enumerate(joints)}
        self.parts = {part: index[name] for part, name in body.items()}
        self.cycle = cycle
        places = [poses_of(joints, frame)[0] for frame in frames]
        self.steps = len(places) - 1
        travel = minus(places[-1][0], places[0][0])
        self.places = [[[c + turn * t for c, t in zip(p, travel)] for p in frame]
                       for turn in range(3) for frame in places[:-1]]

    def jump(self, frame):
        """How far any joint lies from where its motion of the frame before would bring it."""
        a, b, c = self.places[frame - 1:frame + 2]
        return max(math.dist(minus(c[j], b[j]), minus(b[j], a[j])) for j in self.parts.values())

    def stance(self, side):
        keys, seconds = self.cycle["keytimes"], self.cycle["seconds"]
        on, off = (keys[1], keys[4]) if side == "right" else (keys[3], keys[2] + seconds)
        return range(math.ceil((on + seconds) / self.frame_time),
                     math.floor((off + seconds) / self.frame_time) + 1)

    def foot(self, side, frame):
        return [self.places[frame][self.parts[f"{side}_{part}"]] for part in ("ankle", "toe")]

    def slide(self, side):
        stance = self.stance(side)
        flat = min(stance, key=lambda f: self.foot(side, f)[0][1])
        shape = heel_of(*self.foot(side, flat))
        points = [(*self.foot(side, f), heel_of(*self.foot(side, f), shape)) for f in stance]
        return sum(min(math.dist(p[::2], q[::2]) for p, q in zip(a, b))
                   for a, b in zip(points, points[1:]))

    def level(self, side):
        heights = sorted(self.foot(side, f)[1][1] for f in self.stance(side))
        return heights[len(heights) // 10]


@unittest.skipUnless(DATA.is_dir(), f"there are no captures in {DATA}; name them in PROMENADE_DATA")
class SetQuality(MotionTest):
    def walks_of(self, folder, files):
        recipe = self.write("r.toml", f'name = "x"\ncredit = "y"\nfolder = "{DATA / folder}"\n'
                            f'files = "{files}"\n')
        self.json_of("set", "build", recipe, "--out", "x.set", "--json")
        info = self.json_of("set", "info", "x.set", "--json")
        self.assertEqual(self.call("set", "export", "x.set", "--out", "out").returncode, 0)
        return [Walk(cycle, info["skeleton"]["body"],
                     (self.folder / "out" / f"{cycle['name']}.bvh").read_text())
                for cycle in info["cycles"]]

    def judge(self, walks):
        for walk in walks:
            with self.subTest(walk.cycle["name"]):
                seam = walk.jump(walk.steps)
                inside = max(walk.jump(f) for f in range(walk.steps + 1, 2 * walk.steps))
                self.assertLess(seam, inside)
                for side in ("left", "right"):
                    self.assertLess(walk.slide(side), 0.008)
                    toe = walk.parts[f"{side}_toe"]
                    lowest = min(frame[toe][1] for frame in walk.places)
                    self.assertGreater(lowest, walk.level(side) - 0.005)
                    self.assertGreater(lowest, 0)

    def test_thirty_takes_of_one_actor(self):
        walks = self.walks_of("bandai-namco-walk", "dataset-1_walk_{style}_*.bvh")
        self.assertGreaterEqual(len(walks), 28)
        self.judge(walks)

    def test_three_people_one_of_whom_turns(self):
        walks = self.walks_of("cmu", "*-walk*.bvh")
        self.assertEqual(len(walks), 3)
        self.judge(walks)

    def test_captures_in_two_files(self):
        walks = self.walks_of("cmu", "16_*.amc")
        self.assertEqual(len(walks), 2)
        self.judge(walks)

    def test_a_long_take_in_curves(self):
        walks = self.walks_of("100style", "*.bvh")
        self.assertEqual(len(walks), 1)
        self.judge(walks)


if __name__ == "__main__":
    unittest.main()

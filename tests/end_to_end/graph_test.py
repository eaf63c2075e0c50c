#!/usr/bin/env python3
"""Motion graphs: `promenade graph`."""
import json
import math
import unittest

from program import ProgramTest

HEAD = """HIERARCHY
ROOT Hips
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT %s
  {
    OFFSET 0 2 1
    CHANNELS 3 Zrotation Xrotation Yrotation
    JOINT Hand
    {
      OFFSET 3 0 0
      CHANNELS 3 Zrotation Xrotation Yrotation
      End Site
      {
        OFFSET 1 0 0
      }
    }
  }
}
MOTION
Frames: %d
Frame Time: %s
"""


def bvh(frames, joint="Chest", frame_time=0.01):
    """Of lines of twelve channels."""
    lines = (" ".join(repr(float(number)) for number in frame) for frame in frames)
    return HEAD % (joint, len(frames), frame_time) + "\n".join(lines) + "\n"


def wave(count):
    """Somebody who drifts, turns and waves."""
    return [[0.3 * f, 1 + 0.1 * math.sin(f), 0.2 * f, 0, 0, 5 * f,
             10 * math.sin(0.7 * f), 0, 0, 0, 20 * math.cos(0.9 * f), 0] for f in range(count)]


def turned(frames, degrees, x, z):
    """The same motion elsewhere: Y turns last, so its angle can be added only where it is alone."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return [[c * f[0] + s * f[2] + x, f[1], -s * f[0] + c * f[2] + z, f[3], f[4], f[5] + degrees,
             *f[6:]] for f in frames]


class Distance(ProgramTest):
    def distance(self, a, b, window, at):
        result = self.call("graph", "distance", a, b, "--window", str(window), "--at", at, "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads(result.stdout)

    def refused(self, *arguments):
        result = self.call("graph", "distance", *arguments, "--json")
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertEqual(result.stdout, "")
        return result.stderr

    def test_a_copy_elsewhere_is_laid_back(self):
        self.write("a.bvh", bvh(wave(20)))
        self.write("b.bvh", bvh(turned(wave(20)[7:], 130, 4, -2)))
        found = self.distance("a.bvh", "b.bvh", 5, "9,6")  # A_9..13 is B_2..6
        self.assertEqual(list(found), ["distance", "theta", "x0", "z0", "rms_m", "points", "window"])
        self.assertLess(found["distance"], 1e-20)
        self.assertAlmostEqual(found["theta"], math.radians(-130), delta=1e-12)
        c, s = math.cos(math.radians(-130)), math.sin(math.radians(-130))
        self.assertAlmostEqual(found["x0"], -(c * 4 + s * -2), delta=1e-12)
        self.assertAlmostEqual(found["z0"], -(-s * 4 + c * -2), delta=1e-12)
        self.assertEqual((found["points"], found["window"]), (15, 5))
        self.assertIsNone(found["rms_m"])  # nobody walks in it

    def test_a_step_up_is_its_height_in_every_point(self):
        frames = wave(8)
        self.write("a.bvh", bvh(frames))
        self.write("b.bvh", bvh([[f[0], f[1] + 0.5, *f[2:]] for f in frames]))
        found = self.distance("a.bvh", "b.bvh", 8, "0,7")
        self.assertAlmostEqual(found["distance"], 8 * 3 * 0.25, delta=1e-12)
        self.assertAlmostEqual(found["theta"], 0, delta=1e-12)

    def test_metres_are_those_of_the_figure(self):
        self.call("set", "export", "builtin:A", "--out", "walks")
        walk = sorted((self.folder / "walks").glob("*.bvh"))[0]
        found = self.distance(str(walk), str(walk), 10, "0,14")
        self.assertAlmostEqual(found["rms_m"], math.sqrt(found["distance"] / found["points"]),
                               delta=1e-12)
        self.assertGreater(found["rms_m"], 0.001)

    def test_a_sentence_is_for_people(self):
        self.write("a.bvh", bvh(wave(8)))
        result = self.call("graph", "distance", "a.bvh", "a.bvh", "--window", "3", "--at", "0,2")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("9 points", result.stdout)

    def test_all_differences_are_named_at_once(self):
        self.write("a.bvh", bvh(wave(8)))
        self.write("b.bvh", bvh(wave(4), "Cheast", 0.02))
        told = self.refused("a.bvh", "b.bvh", "--window", "5", "--at", "6,2")
        for part in ["b.bvh: error: joint 2 is \"Cheast\"", "did you mean \"Chest\"?", "0.02 s",
                     "a.bvh: error: has no window of 5 frames at i = 6; i can be 0 to 3",
                     "b.bvh: error: has 4 frames, too few for a window of 5"]:
            self.assertIn(part, told)

    def test_the_end_of_a_window_lies_in_the_take(self):
        self.write("a.bvh", bvh(wave(8)))
        for at in ["0,1", "0,8", "-1,4", "6,4"]:
            self.assertIn("can be", self.refused("a.bvh", "a.bvh", "--window", "3", "--at=" + at))
        for at in ["5,2", "0,7"]:
            self.distance("a.bvh", "a.bvh", 3, at)

    def test_what_is_no_pair_of_frames_is_refused(self):
        self.write("a.bvh", bvh(wave(8)))
        for at in ["", "1", "1,", ",1", "1,2,3", "a,b", "1.5,3", "99999999999,3"]:
            told = self.refused("a.bvh", "a.bvh", "--window", "3", "--at=" + at)
            self.assertIn("--at", told)
        for window in ["0", "-3", "x", "1e9"]:
            self.refused("a.bvh", "a.bvh", "--window=" + window, "--at", "0,2")

    def test_broken_files_are_told_of_both(self):
        self.write("a.bvh", "HIERARCHY\n")
        self.write("b.bvh", bvh(wave(3)).replace("0.6", "nan"))
        told = self.refused("a.bvh", "b.bvh", "--window", "3", "--at", "0,2")
        self.assertIn("a.bvh:", told)
        self.assertIn("b.bvh:", told)
        self.refused("a.bvh", "missing.bvh", "--window", "3", "--at", "0,2")

    def test_points_beyond_all_numbers_are_refused(self):
        frames = wave(4)
        frames[1][0] = 1e300
        self.write("a.bvh", bvh(frames))
        self.assertIn("too far", self.refused("a.bvh", "a.bvh", "--window", "3", "--at", "0,3"))


if __name__ == "__main__":
    unittest.main()

#!/usr/bin/env python3
"""`motion` and `set` as their users call them. What is exported is judged by a reader and
forward kinematics of the test's own: nothing of the program is believed."""
import hashlib
import json
import math
import unittest
from xml.etree import ElementTree

from program import ProgramTest

HIERARCHY = """HIERARCHY
ROOT Hips
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Yrotation Xrotation Zrotation
  JOINT LeftUpLeg
  {
    OFFSET 10 -5 0
    CHANNELS 3 Zrotation Xrotation Yrotation
    JOINT LeftLeg
    {
      OFFSET 0 -42 1
      CHANNELS 1 Xrotation
      End Site
      {
        OFFSET 0 -40 0
      }
    }
  }
  JOINT Spine
  {
    OFFSET 0 20 0
    CHANNELS 4 Zposition Zrotation Yrotation Xrotation
  }
}
"""
FRAMES = ["0 95 0 0 0 0 0 0 0 0 3 0 0 0",
          "1.5 96 -2 30 -10 5 20 -40 15 60 4 10 20 30",
          "-3 94.25 7e0 -170 80 95 -35 120 5 -10 -5 -90 45 1e1"]


def text_of(frames=FRAMES, count=None, frame_time="0.05", hierarchy=HIERARCHY):
    count = len(frames) if count is None else count
    return (f"{hierarchy}MOTION\nFrames: {count}\nFrame Time: {frame_time}\n"
            + "\n".join(frames) + "\n")


def read_bvh(text):
    """Joints as (name, parent, offset, channels), frames as lists of numbers, frame time."""
    words = iter(text.split())
    joints, open_joints, end_site = [], [], False
    for word in words:
        if word in ("ROOT", "JOINT"):
            joints.append([next(words), open_joints[-1] if open_joints else -1, None, []])
        elif word == "End":
            end_site = next(words) == "Site"
        elif word == "{":
            open_joints.append(None if end_site else len(joints) - 1)
        elif word == "}":
            end_site = open_joints.pop() is None and False
        elif word == "OFFSET":
            offset = [float(next(words)) for _ in range(3)]
            if not end_site:
                joints[-1][2] = offset
        elif word == "CHANNELS":
            joints[-1][3] = [next(words) for _ in range(int(next(words)))]
        elif word == "MOTION":
            break
    assert next(words) == "Frames:"
    count = int(next(words))
    assert (next(words), next(words)) == ("Frame", "Time:")
    frame_time = float(next(words))
    values = [float(word) for word in words]
    width = sum(len(joint[3]) for joint in joints)
    assert len(values) == count * width
    return joints, [values[f * width:(f + 1) * width] for f in range(count)], frame_time


def turn(axis, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return {"X": [[1, 0, 0], [0, c, -s], [0, s, c]],
            "Y": [[c, 0, s], [0, 1, 0], [-s, 0, c]],
            "Z": [[c, -s, 0], [s, c, 0], [0, 0, 1]]}[axis]


def times(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def turned(rotation, point):
    return [sum(rotation[i][k] * point[k] for k in range(3)) for i in range(3)]


def poses_of(joints, values):
    """World position and rotation matrix of every joint."""
    values = iter(values)
    places, turns = [], []
    for _, parent, offset, channels in joints:
        at, rotation = list(offset), [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
        for channel in channels:
            if channel.endswith("position"):
                at["XYZ".index(channel[0])] = next(values)
            else:
                rotation = times(rotation, turn(channel[0], next(values)))
        if parent >= 0:
            at = [b + a for b, a in zip(places[parent], turned(turns[parent], at))]
            rotation = times(turns[parent], rotation)
        places.append(at)
        turns.append(rotation)
    return places, turns


def positions_of(joints, values):
    return poses_of(joints, values)[0]


class MotionTest(ProgramTest):
    def json_of(self, *arguments):
        """What is on stdout, which must be one document and nothing else."""
        result = self.call(*arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads(result.stdout)

    def assert_same_places(self, a, b, tolerance):
        for p, q in zip(a, b, strict=True):
            self.assertLess(math.dist(p, q), tolerance)


class Motion(MotionTest):
    def test_info_tells_what_the_file_holds(self):
        info, = self.json_of("motion", "info", self.write("a.bvh", text_of()), "--json")
        self.assertEqual((info["file"], info["format"], info["frames"], info["frame_time"]),
                         ("a.bvh", "bvh", 3, 0.05))
        self.assertEqual([(j["name"], j["parent"]) for j in info["joints"]],
                         [("Hips", None), ("LeftUpLeg", "Hips"), ("LeftLeg", "LeftUpLeg"),
                          ("Spine", "Hips")])
        self.assertEqual(info["joints"][3]["channels"],
                         ["Zposition", "Zrotation", "Yrotation", "Xrotation"])

    def test_positions_are_those_of_other_forward_kinematics(self):
        text = text_of()
        result = self.json_of("motion", "positions", self.write("a.bvh", text), "--frames",
                              "2,0,1", "--json")
        joints, frames, _ = read_bvh(text)
        self.assertEqual(result["joints"], [joint[0] for joint in joints])
        self.assertEqual([f["frame"] for f in result["frames"]], [2, 0, 1])
        for frame in result["frames"]:
            self.assert_same_places(frame["positions"],
                                    positions_of(joints, frames[frame["frame"]]), 1e-9)

    def test_frames_that_are_not_there_are_all_named(self):
        result = self.call("motion", "positions", self.write("a.bvh", text_of()), "--frames",
                           "0,3,-1,x", "--json")
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        for word in ("'3'", "'-1'"):
            self.assertIn(f"a.bvh: error: has no frame {word}", result.stderr)
        self.assertIn("--frames: error: 'x' is no whole number", result.stderr)

    def test_convert_keeps_every_number(self):
        text = text_of()
        result = self.call("motion", "convert", self.write("a.bvh", text), "b.bvh")
        self.assertEqual((result.returncode, result.stdout), (0, ""), result.stderr)
        self.assertEqual(read_bvh((self.folder / "b.bvh").read_text()), read_bvh(text))

    def test_broken_files_are_refused_at_their_place(self):
        whole = text_of()
        table = {
            "cut": (whole[:len(whole) // 3], r"cut\.bvh:\d+:\d+: error: "),
            "short": (text_of(count=4), r"short\.bvh:\d+(:\d+)?: error: "),
            "narrow": (whole.replace("CHANNELS 1 X", "CHANNELS 2 X"), r"narrow\.bvh:14:7: error: "),
            "word": (whole.replace("-170", "-17o"), r"word\.bvh:31:14: error: "),
            "still": (text_of(frame_time="0"), r"still\.bvh:28:13: error: "),
            "empty": ("", r"empty\.bvh(:1(:1)?)?: error: ")}
        for name, (text, place) in table.items():
            self.write(f"{name}.bvh", text)
            for command in (["info", f"{name}.bvh", "--json"], ["convert", f"{name}.bvh", "o.bvh"],
                            ["positions", f"{name}.bvh", "--frames", "0"]):
                result = self.call("motion", *command)
                self.assertEqual((result.returncode, result.stdout), (2, ""), name)
                self.assertRegex(result.stderr, place)
        self.assertFalse((self.folder / "o.bvh").exists())

    def test_folders_and_missing_files_are_refused_together(self):
        (self.folder / "folder.bvh").mkdir()
        result = self.call("motion", "info", "folder.bvh", "none.bvh", "--json")
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertRegex(result.stderr, r"(?m)^folder\.bvh: error: ")
        self.assertRegex(result.stderr, r"(?m)^none\.bvh: error: ")

    def test_a_place_that_cannot_be_written_is_the_worlds_fault(self):
        self.write("file", "")
        result = self.call("motion", "convert", self.write("a.bvh", text_of()), "file/b.bvh")
        self.assertEqual((result.returncode, result.stdout), (1, ""))
        self.assertIn("cannot write file", result.stderr)


class Set(MotionTest):
    def setUp(self):
        super().setUp()
        self.info = self.json_of("set", "info", "builtin:A", "--json")
        self.assertEqual(self.call("set", "export", "builtin:A", "--out", "out").returncode, 0)
        body = self.info["skeleton"]["body"]
        self.walks = {}
        for cycle in self.info["cycles"]:
            text = (self.folder / "out" / f"{cycle['name']}.bvh").read_text()
            joints, frames, frame_time = read_bvh(text)
            index = {joint[0].replace("_", " "): j for j, joint in enumerate(joints)}
            parts = {part: index[name.replace("_", " ")] for part, name in body.items()}
            poses = [poses_of(joints, frame) for frame in frames]
            self.walks[cycle["name"]] = (cycle, parts, poses, frame_time)

    def test_the_closing_frame_is_the_first_one_cycle_further_on(self):
        for name, (cycle, _, poses, frame_time) in self.walks.items():
            (first, first_turns), (last, last_turns) = poses[0], poses[-1]
            ahead = last[0][2] - first[0][2]
            aside = last[0][0] - first[0][0]
            self.assertGreater(ahead, 0.5 * cycle["seconds"], name)
            self.assertLess(abs(aside), 0.02 * ahead, name)
            self.assertAlmostEqual((len(poses) - 1) * frame_time, cycle["seconds"], delta=1e-9)
            self.assert_same_places([[p[0] + aside, p[1], p[2] + ahead] for p in first], last, 1e-6)
            for a, b in zip(first_turns, last_turns):
                self.assert_same_places(a, b, 1e-6)

    def test_the_figure_faces_where_it_walks(self):
        for name, (_, parts, poses, _) in self.walks.items():
            left = sum(p[parts["left_hip"]][0] - p[parts["right_hip"]][0] for p, _ in poses)
            toes = sum(p[parts[s + "_toe"]][2] - p[parts[s + "_ankle"]][2]
                       for p, _ in poses for s in ("left", "right"))
            self.assertGreater(left, 0, name)
            self.assertGreater(toes, 0, name)

    def test_nothing_is_below_the_floor_and_every_foot_reaches_it(self):
        for name, (_, parts, poses, _) in self.walks.items():
            self.assertGreater(min(at[1] for p, _ in poses for at in p), -0.005, name)
            for side in ("left", "right"):
                self.assertLess(min(p[parts[side + "_toe"]][1] for p, _ in poses), 0.06, name)

    def test_standing_feet_stay_where_they_are(self):
        for name, (cycle, parts, poses, frame_time) in self.walks.items():
            _, right_on, left_off, left_on, end = cycle["keytimes"]
            for side, on, off in (("right", right_on, end),
                                  ("left", left_on, left_off + cycle["seconds"])):
                slid = self.slide(parts, poses, side, math.ceil(on / frame_time),
                                  math.floor(off / frame_time))
                self.assertLess(slid, 0.005, f"{name} {side}")

    def slide(self, parts, poses, side, first, last):
        """The path over ground of whichever of heel, ankle and toe moves least, metres.

        The heel is on the floor 5 cm behind the ankle when the foot is flat: in the middle
        of the stance.
        """
        steps = len(poses) - 1
        ankle, toe = parts[f"{side}_ankle"], parts[f"{side}_toe"]
        places, turns = poses[(first + last) // 2 % steps]
        heel = turned(list(zip(*turns[ankle])), [0, -places[ankle][1], -0.05])
        travel = [poses[-1][0][0][i] - poses[0][0][0][i] for i in range(3)]

        def ground(frame):
            places, turns = poses[frame % steps]
            heel_at = [a + b for a, b in zip(places[ankle], turned(turns[ankle], heel))]
            on = frame // steps
            return [(p[0] + on * travel[0], p[2] + on * travel[2])
                    for p in (heel_at, places[ankle], places[toe])]

        return sum(min(map(math.dist, ground(f), ground(f + 1))) for f in range(first, last))

    def test_build_refuses_a_recipe_at_its_places_and_writes_nothing(self):
        recipe = self.write("r.toml", 'name = "x"\ncredit = "y"\nfolder = "none"\nup = "z"\n')
        result = self.call("set", "build", recipe, "--out", "x.set", "--json")
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertRegex(result.stderr, r"r\.toml:3:10: error: there is no folder ")
        self.assertFalse((self.folder / "x.set").exists())

    def test_captures_built_and_looked_into_are_one_document_each(self):
        (self.folder / "takes").mkdir()
        name = self.info["cycles"][0]["name"]
        text = (self.folder / "out" / f"{name}.bvh").read_text()
        (self.folder / "takes" / "stroll_1.bvh").write_text(text)
        recipe = self.write("r.toml", 'name = "x"\ncredit = "y"\nfolder = "takes"\n'
                            'files = "{style}_*.bvh"\nunit_m = 1\n')
        report, = self.json_of("set", "build", recipe, "--out", "x.set", "--json")
        self.assertEqual((report["source"], report["name"]), ("stroll_1.bvh", "stroll_1"))
        info = self.json_of("set", "info", "x.set", "--json")
        # The same figures under the same names, and what planting the feet changed.
        cycle, = info["cycles"]
        self.assertEqual({key: report[key] for key in cycle}, cycle)
        self.assertEqual(set(report) - set(cycle),
                         {"ankles_moved_m", "pelvis_lowered_m", "speed_change_m_s"})
        self.assertEqual([c["name"] for c in info["cycles"]], ["stroll_1"])
        self.assertEqual(info["unit"], "m")

    def test_every_cycle_has_its_figures_and_its_picture(self):
        (self.folder / "takes" / "old").mkdir(parents=True)
        text = (self.folder / "out" / f"{self.info['cycles'][0]['name']}.bvh").read_text()
        (self.folder / "takes" / "old" / "<&>_1.bvh").write_text(text)
        recipe = self.write("r.toml", 'name = "x"\ncredit = "y"\nfolder = "takes"\n'
                            'files = "{style}/*_1.bvh"\nunit_m = 1\n')
        self.json_of("set", "build", recipe, "--out", "x.set", "--json", "--pictures", "pictures")
        root = ElementTree.parse(self.folder / "pictures" / "old_1.svg").getroot()
        self.assertIn("svg", root.tag)
        cycle, = self.json_of("set", "info", "x.set", "--json")["cycles"]
        self.assertEqual(cycle["source"], "old/<&>_1.bvh")
        self.assertEqual(cycle["source_sha256"], hashlib.sha256(text.encode()).hexdigest())
        self.assertLess(cycle["seam_velocity_jump_m_s"], cycle["inside_velocity_jump_m_s"])
        self.assertLess(max(cycle["stance_slide_left_m"], cycle["stance_slide_right_m"]), 0.008)
        self.assertLess(cycle["penetration_m"], 0.003)
        self.assertTrue(0 < cycle["double_support"] < 0.4)
        self.assertEqual([c["foot"] for c in cycle["contacts"]], ["right", "left"])
        self.assertEqual(cycle["contacts"][0]["on"], cycle["keytimes"][1])
        self.assertEqual(cycle["scale"], 1)

    def test_a_broken_set_file_is_refused(self):
        for text in ("", "PROMSET\n", "no set at all"):
            result = self.call("set", "info", self.write("x.set", text), "--json")
            self.assertEqual((result.returncode, result.stdout), (2, ""))
            self.assertRegex(result.stderr, r"x\.set(:\d+)*: error: ")


if __name__ == "__main__":
    unittest.main()

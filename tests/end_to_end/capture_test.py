#!/usr/bin/env python3
"""Captures as laboratories have them, through `promenade motion` and tools/convert-capture."""
import json
import os
import pathlib
import shutil
import struct
import subprocess
import unittest

from program import ProgramTest

SOURCE = pathlib.Path(os.environ["PROMENADE_SOURCE_DIR"])
CONVERT = str(SOURCE / "tools" / "convert-capture")

ASF = """:units
  length 0.45
  angle deg
:root
  order TX TY TZ RX RY RZ
:bonedata
  begin
    name up
    direction 0 1 0
    length 3
    axis 0 0 0 XYZ
    dof rz
  end
  begin
    name arm
    direction 1 0 0
    length 2
    axis 0 0 90 XYZ
  end
:hierarchy
  begin
    root up
    up arm
  end
"""
AMC = ":DEGREES\n1\nroot 1 2 3 0 0 0\nup 0\n2\nroot 1 2 3 0 0 0\nup 90\n"


class Captures(ProgramTest):
    def answer(self, *arguments):
        result = self.call("motion", *arguments, "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads(result.stdout)

    def positions(self, capture, frames, *more):
        answer = self.answer("positions", str(capture), "--frames", frames, *more)
        return answer["joints"], [frame["positions"] for frame in answer["frames"]]

    def assert_near(self, found, expected, most=1e-9):
        for a, b in zip(found, expected, strict=True):
            for p, q in zip(a, b, strict=True):
                self.assertAlmostEqual(p, q, delta=most)


class AsfAmc(Captures):
    def test_the_skeleton_of_the_same_name_is_found(self):
        self.write("7.asf", ASF)
        self.write("7_1.amc", AMC)
        self.write("8.asf", "broken")
        info = self.answer("info", "7_1.amc")[0]
        self.assertEqual([j["name"] for j in info["joints"]], ["root", "up", "arm"])
        self.assertEqual(info["joints"][1]["channels"], ["Zrotation"])
        self.assertEqual((info["frames"], info["format"]), (2, "asf/amc"))
        joints, frames = self.positions("7_1.amc", "0,1")
        self.assertEqual(joints, ["root", "up", "arm"])
        self.assert_near(frames[0], [[1, 2, 3], [1, 2, 3], [1, 5, 3]])
        self.assert_near(frames[1], [[1, 2, 3], [1, 2, 3], [-2, 2, 3]])

    def test_without_one_skeleton_it_is_asked_for(self):
        self.write("7_1.amc", AMC)
        self.write("with space.asf", ASF)
        self.positions("7_1.amc", "1")
        self.write("other.asf", ASF)
        result = self.call("motion", "info", "7_1.amc", "--json")
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertIn("--skeleton", result.stderr)
        self.positions("7_1.amc", "1", "--skeleton", "with space.asf")
        self.assertEqual(self.call("motion", "info", "other.asf").returncode, 2)

    def test_it_converts_to_bvh_with_every_joint_in_its_place(self):
        self.write("7.asf", ASF)
        self.write("7_1.amc", AMC)
        result = self.call("motion", "convert", "7_1.amc", "out.bvh", "--rate", "60")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(self.positions("out.bvh", "0,1")[0], ["root", "up", "arm"])
        self.assert_near(self.positions("out.bvh", "1")[1][0], self.positions("7_1.amc", "1")[1][0])
        self.assertAlmostEqual(self.answer("info", "out.bvh")[0]["frame_time"], 1 / 60)


def c3d_parameter(group, name, kind, sizes, payload, last=False):
    content = struct.pack("bB", kind, len(sizes)) + bytes(sizes) + payload + b"\0"
    step = 0 if last else 2 + len(content)
    return struct.pack("bb", len(name), group) + name + struct.pack("<H", step) + content


def c3d_text(frames, names, rate):
    """Floats on an Intel machine; None is a marker that was lost."""
    width = max(map(len, names))
    labels = b"".join(name.ljust(width).encode() for name in names)
    group = struct.pack("bb", 5, -1) + b"POINT" + struct.pack("<HB", 3, 0)
    parameters = (bytes([1, 80, 1, 84]) + group +
                  c3d_parameter(1, b"LABELS", -1, [width, len(names)], labels) +
                  c3d_parameter(1, b"RATE", 4, [], struct.pack("<f", rate)) +
                  c3d_parameter(1, b"SCALE", 4, [], struct.pack("<f", -1), last=True))
    header = bytes([2, 0x50]) + struct.pack("<5Hf2Hf", len(names), 0, 1, len(frames), 0, -1.0, 3,
                                            0, rate)
    rows = [struct.pack("<4f", *(point or (0, 0, 0)), 0 if point else -1)
            for frame in frames for point in frame]
    return header.ljust(512, b"\0") + parameters.ljust(512, b"\0") + b"".join(rows)


class OtherKinds(Captures):
    def test_are_answered_with_the_command_that_converts_them(self):
        for name in ("a walk.fbx", "WALK.C3D"):
            self.write(name, "x")
            result = self.call("motion", "info", name)
            self.assertEqual(result.returncode, 2)
            source = f"'{name}'" if " " in name else name
            target = source.replace(".fbx", ".bvh").replace(".C3D", ".bvh")
            self.assertIn(f"tools/convert-capture {source} {target}", result.stderr)

    def convert(self, source, target):
        return subprocess.run([CONVERT, source, target], cwd=self.folder, text=True,
                              capture_output=True, timeout=300)

    def test_markers_become_joints(self):
        frames = [[(1, 2, 3), (4, 5, 6)], [(1.5, 2, 3), None], [(2, 2, 3.25), (7, 8, 9)]]
        (self.folder / "m.c3d").write_bytes(c3d_text(frames, ["LASI", "R toe"], 100))
        done = self.convert("m.c3d", "m.bvh")
        self.assertEqual(done.returncode, 0, done.stderr)
        joints, places = self.positions("m.bvh", "0,1,2")
        self.assertEqual(joints, ["markers", "LASI", "R_toe"])
        self.assert_near(places[1][1:], [(1.5, 2, 3), (4, 5, 6)])
        self.assert_near(places[2][1:], [(2, 2, 3.25), (7, 8, 9)])
        self.assertAlmostEqual(self.answer("info", "m.bvh")[0]["frame_time"], 0.01)

    def test_broken_markers_are_refused(self):
        whole = c3d_text([[(1, 2, 3)]] * 3, ["a"], 100)
        for name, data in (("empty", b""), ("text", b"x" * 2000), ("short", whole[:-1]),
                           ("header", whole[:600]), ("still", c3d_text([], ["a"], 100))):
            (self.folder / "m.c3d").write_bytes(data)
            done = self.convert("m.c3d", "m.bvh")
            self.assertEqual(done.returncode, 1, name)
            self.assertIn("tools/convert-capture: m.c3d", done.stderr)
            self.assertNotIn("Traceback", done.stderr)
        self.assertEqual([p.name for p in self.folder.iterdir()], ["m.c3d"])

    def test_an_fbx_skeleton_comes_out_of_blender_where_it_was(self):
        if shutil.which("blender") is None:
            self.skipTest("Blender is not installed, so that no FBX file can be made or read.")
        made = subprocess.run(["blender", "--background", "--factory-startup", "--python",
                               SOURCE / "tests" / "end_to_end" / "make_fbx.py"], cwd=self.folder,
                              text=True, capture_output=True, timeout=300)
        self.assertTrue((self.folder / "made.fbx").exists(), made.stdout + made.stderr)
        done = self.convert("made.fbx", "out.bvh")
        self.assertEqual(done.returncode, 0, done.stderr)
        expected = json.loads((self.folder / "places.json").read_text())
        joints, places = self.positions("out.bvh", ",".join(map(str, range(len(expected)))))
        self.assertEqual(joints, ["Hips", "Leg", "Foot"])
        for found, wanted in zip(places, expected, strict=True):
            self.assert_near(found, wanted, 5e-6)  # Blender counts in single precision
        self.assertAlmostEqual(self.answer("info", "out.bvh")[0]["frame_time"], 1 / 30)

    def test_a_broken_fbx_file_is_refused(self):
        if shutil.which("blender") is None:
            self.skipTest("Blender is not installed, so that no FBX file can be read.")
        self.write("bad.fbx", "Kaydara FBX Binary  ")
        done = self.convert("bad.fbx", "out.bvh")
        self.assertEqual(done.returncode, 1)
        self.assertIn("tools/convert-capture: ", done.stderr)
        self.assertNotIn("Traceback", done.stderr)
        self.assertEqual([p.name for p in self.folder.iterdir()], ["bad.fbx"])


if __name__ == "__main__":
    unittest.main()

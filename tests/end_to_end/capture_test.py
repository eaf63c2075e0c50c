#!/usr/bin/env python3
"""Captures as laboratories have them, through `promenade motion` and tools/convert-capture."""
import json
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import unittest

from program import PROMENADE, ProgramTest

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


# A process begins with the memory of the one that it was forked from: a small one measures.
MEASURE = """
import resource, subprocess, sys
code = subprocess.run(sys.argv[1:], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode
print(code, 1024 * resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)
"""


def memory_of(arguments, folder):
    """Exit code and the most memory (bytes) that the program had at one time."""
    done = subprocess.run([sys.executable, "-c", MEASURE, PROMENADE, *arguments], cwd=folder,
                          text=True, capture_output=True, check=True)
    code, most = map(int, done.stdout.split())
    return code, most


class Memory(Captures):
    """Ten minutes at 240 frames a second, 31 joints: the same second again and again."""
    FRAMES, MOST = 144_000, 3

    def one_second(self, values, layout):
        rows = [[(37 * f * (c + 1)) % 3600 / 10 - 179.9875 for c in range(values)]
                for f in range(240)]
        return "".join(layout(row) for row in rows)

    def check(self, name, *arguments):
        size = (self.folder / name).stat().st_size
        code, most = memory_of(["motion", *arguments], self.folder)
        self.assertEqual(code, 0)
        self.assertLess(most, self.MOST * size, f"{most / size:.2f} times the file")

    def test_a_long_bvh_needs_at_most_three_times_its_size(self):
        joint = "{\nOFFSET 0 1 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n"
        head = "HIERARCHY\nROOT j\n" + joint.replace("3 Z", "6 Xposition Yposition Zposition Z")
        head += "".join(f"JOINT j{j}\n{joint}" for j in range(30)) + 31 * "}\n"
        second = self.one_second(96, lambda row: " ".join(f"{v:.4f}" for v in row) + "\n")
        with open(self.folder / "long.bvh", "w") as file:
            file.write(f"{head}MOTION\nFrames: {self.FRAMES}\nFrame Time: 0.0041667\n")
            for _ in range(self.FRAMES // 240):
                file.write(second)
        self.check("long.bvh", "info", "long.bvh", "--json")
        self.check("long.bvh", "positions", "long.bvh", "--frames", "0,143999")

    def test_a_long_amc_needs_at_most_three_times_its_size(self):
        bones = "".join(f"begin name b{b} direction 0 1 0 length 1\ndof rx ry rz\nend\n"
                        for b in range(30))
        tree = "root b0\n" + "".join(f"b{b} b{b + 1}\n" for b in range(29))
        self.write("1.asf", f":root\norder TX TY TZ RX RY RZ\n:bonedata\n{bones}:hierarchy\n"
                   f"begin\n{tree}end\n")

        def layout(row):
            words = [f"{v:.4f}" for v in row]
            lines = ["root " + " ".join(words[:6])]
            lines += [f"b{b} " + " ".join(words[6 + 3 * b:9 + 3 * b]) for b in range(30)]
            return "\n".join(lines) + "\n"

        frames = self.one_second(96, lambda row: layout(row) + "\0").split("\0")[:-1]
        with open(self.folder / "1_1.amc", "w") as file:
            file.write(":DEGREES\n")
            for f in range(self.FRAMES // 4):
                file.write(f"{f + 1}\n{frames[f % 240]}")
        self.check("1_1.amc", "positions", "1_1.amc", "--frames", "0,35999")

    def test_a_deep_tree_is_answered(self):
        joints = 100_000
        text = ("HIERARCHY\nROOT r\n{\nOFFSET 0 0 0\nCHANNELS 1 Zrotation\n" +
                "".join(f"JOINT j{j}\n{{\nOFFSET 0 1 0\n" for j in range(joints)) +
                (joints + 1) * "}\n" + "MOTION\nFrames: 1\nFrame Time: 0.01\n90\n")
        self.write("deep.bvh", text)
        joint, places = self.positions("deep.bvh", "0")
        self.assertEqual(len(joint), joints + 1)
        self.assert_near(places[0][-1:], [[-joints, 0, 0]], 1e-6)
        self.assertEqual(self.answer("info", "deep.bvh")[0]["hips"], None)


class Broken(Captures):
    """What nobody should give the program, and somebody will."""

    def assert_refused(self, name, says):
        for command in (["info", name], ["positions", name, "--frames", "0"],
                        ["convert", name, "out.bvh"]):
            result = self.call("motion", *command)
            self.assertEqual((result.returncode, result.stdout), (2, ""), command)
            self.assertRegex(result.stderr, f"{name}(:1:1)?: error: ")
            self.assertIn(says, result.stderr)
        self.assertFalse((self.folder / "out.bvh").exists())

    def test_files_that_are_no_text_are_refused_unread(self):
        with open(self.folder / "zeros.bvh", "wb") as file:
            file.truncate(1 << 32)
        (self.folder / "wide.bvh").write_bytes("HIERARCHY".encode("utf-16"))
        (self.folder / "folder.bvh").mkdir()
        os.mkfifo(self.folder / "pipe.bvh")
        for name, says in (("zeros", "not a text"), ("wide", "UTF-16"), ("folder", "folder"),
                           ("pipe", "pipe"), ("none", "No such file")):
            self.assert_refused(f"{name}.bvh", says)

    def test_a_converted_file_is_named_as_what_it_is(self):
        self.write("7.asf", ASF)
        self.write("7_1.amc", AMC)
        result = self.call("motion", "convert", "7_1.amc", "out.fbx")
        self.assertEqual(result.returncode, 2)
        self.assertIn("out.fbx", result.stderr)


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

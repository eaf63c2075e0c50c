"""Runs inside Blender, for tools/convert-capture: an FBX armature as BVH, metres, Y up.

Joints are written from where they are in the world at each frame, so that neither the
unit, the axes nor the rest pose of the file matter.
"""
import pathlib
import sys

import bpy
from mathutils import Matrix

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from plain_bvh import Joint, write_bvh  # noqa: E402

Y_UP = Matrix(((1, 0, 0, 0), (0, 0, 1, 0), (0, -1, 0, 0), (0, 0, 0, 1)))


def fail(message):
    print(f"fbx: {message}", flush=True)
    sys.exit(3)


def only_armature(source):
    for other in list(bpy.data.objects):
        bpy.data.objects.remove(other)
    try:
        bpy.ops.import_scene.fbx(filepath=source, ignore_leaf_bones=False)
    except RuntimeError as error:
        fail(f"Blender cannot read {source}: {str(error).strip().splitlines()[-1]}")
    armatures = [o for o in bpy.data.objects if o.type == "ARMATURE" and o.data.bones]
    if not armatures:
        fail(f"there is no skeleton in {source}")
    return max(armatures, key=lambda armature: len(armature.data.bones))


def frame_range():
    ranges = [action.frame_range for action in bpy.data.actions]
    if not ranges:
        fail("the skeleton does not move: there is no animation in the file")
    return round(min(r[0] for r in ranges)), round(max(r[1] for r in ranges))


def world_of(armature, bone):
    place, turn, _ = (Y_UP @ armature.matrix_world @ bone.matrix).decompose()
    return place, turn.to_matrix()


def main(source, target):
    armature = only_armature(source)
    bones = list(armature.pose.bones)  # parents first
    number = {bone.name: b for b, bone in enumerate(bones)}
    joints = [Joint(bone.name, number[bone.parent.name] if bone.parent else None, [], [])
              for bone in bones]
    scene = bpy.context.scene
    first, last = frame_range()
    for frame in range(first, last + 1):
        scene.frame_set(frame)
        world = [world_of(armature, bone) for bone in bones]
        for joint, (place, turn) in zip(joints, world):
            if joint.parent is not None:
                parent_place, parent_turn = world[joint.parent]
                back = parent_turn.transposed()
                place, turn = back @ (place - parent_place), back @ turn
            joint.places.append(tuple(place))
            joint.turns.append([tuple(row) for row in turn])
    write_bvh(target, joints, scene.render.fps_base / scene.render.fps)


main(*sys.argv[sys.argv.index("--") + 1:])

"""Runs inside Blender: writes made.fbx, and places.json with where its joints are (Y up)."""
import json, math, sys
import bpy
for other in list(bpy.data.objects):
    bpy.data.objects.remove(other)
data = bpy.data.armatures.new("a")
figure = bpy.data.objects.new("a", data)
bpy.context.collection.objects.link(figure)
bpy.context.view_layer.objects.active = figure
bpy.ops.object.mode_set(mode="EDIT")
chain = [("Hips", (0, 0, 0.9), (0, 0, 1.1)), ("Leg", (0.1, 0, 0.9), (0.1, 0.02, 0.5)),
         ("Foot", (0.1, 0.02, 0.5), (0.1, -0.1, 0.45))]
parent = None
for name, head, tail in chain:
    bone = data.edit_bones.new(name)
    bone.head, bone.tail, bone.parent = head, tail, parent
    parent = bone
bpy.ops.object.mode_set(mode="POSE")
scene = bpy.context.scene
scene.render.fps, scene.frame_start, scene.frame_end = 30, 1, 4
for frame in range(1, 5):
    for b, bone in enumerate(figure.pose.bones):
        bone.rotation_mode = "XYZ"
        bone.rotation_euler = [math.radians(10 * frame * (b + 1)), 0.1 * frame, -0.05 * frame]
        bone.keyframe_insert("rotation_euler", frame=frame)
    figure.pose.bones[0].location = (0.1 * frame, 0, 0.3)
    figure.pose.bones[0].keyframe_insert("location", frame=frame)
places = []
for frame in range(1, 5):
    scene.frame_set(frame)
    heads = [figure.matrix_world @ bone.head for bone in figure.pose.bones]
    places.append([[h.x, h.z, -h.y] for h in heads])
json.dump(places, open("places.json", "w"))
bpy.ops.export_scene.fbx(filepath="made.fbx", bake_anim_simplify_factor=0, add_leaf_bones=False)

"""Writes joints with their paths and turns as BVH, for tools/convert-capture."""
import math


class Joint:
    """One joint: its name, the index of its parent (or None), and for each frame where it
    is in its parent's frame, and its turn there as a 3 x 3 matrix (None: it never turns)."""

    def __init__(self, name, parent, places, turns=None):
        self.name, self.parent, self.places, self.turns = name, parent, places, turns

    def moves(self):
        first = self.places[0]
        size = max(map(abs, first)) + 1e-9
        return self.parent is None or any(
            abs(a - b) > 1e-5 * size for place in self.places for a, b in zip(place, first))


def zyx_angles(m):
    """Degrees about Z, Y, X, each from what the ones before leave."""
    z = math.atan2(m[1][0], m[0][0])
    c, s = math.cos(z), math.sin(z)
    row0 = [c * m[0][k] + s * m[1][k] for k in range(3)]
    row1 = [c * m[1][k] - s * m[0][k] for k in range(3)]
    y = math.atan2(-m[2][0], row0[0])
    x = math.atan2(-row1[2], row1[1])
    return [math.degrees(angle) for angle in (z, y, x)]


def text_of(numbers):
    return " ".join(f"{number:.9g}" for number in numbers)


def write_hierarchy(out, joints, joint, children, depth):
    stack = [(joint, depth, False)]
    while stack:
        j, depth, done = stack.pop()
        blank = "  " * min(depth, 40)
        if done:
            out.append(f"{blank}}}")
            continue
        own = joints[j]
        name = "_".join(own.name.split()) or f"joint_{j}"
        channels = ["Xposition", "Yposition", "Zposition"] if own.moves() else []
        channels += ["Zrotation", "Yrotation", "Xrotation"] if own.turns else []
        out.append(f"{blank}{'ROOT' if own.parent is None else 'JOINT'} {name}")
        out.append(f"{blank}{{")
        out.append(f"{blank}  OFFSET {text_of(own.places[0])}")
        out.append(f"{blank}  CHANNELS {' '.join([str(len(channels))] + channels)}")
        stack.append((j, depth, True))
        stack.extend((child, depth + 1, False) for child in reversed(children[j]))


def order_of(children, root):
    order, stack = [], [root]
    while stack:
        j = stack.pop()
        order.append(j)
        stack.extend(reversed(children[j]))
    return order


def write_bvh(path, joints, frame_time):
    children = [[] for _ in joints]
    roots = []
    for j, joint in enumerate(joints):
        (roots if joint.parent is None else children[joint.parent]).append(j)
    out, order = ["HIERARCHY"], []
    for root in roots:
        write_hierarchy(out, joints, root, children, 0)
        order += order_of(children, root)
    frames = len(joints[0].places)
    out += ["MOTION", f"Frames: {frames}", f"Frame Time: {frame_time:.12g}"]
    moving = [joint.moves() for joint in joints]
    with open(path, "w", encoding="utf-8", errors="replace") as file:
        file.write("\n".join(out) + "\n")
        for f in range(frames):
            row = []
            for j in order:
                row += joints[j].places[f] if moving[j] else []
                row += zyx_angles(joints[j].turns[f]) if joints[j].turns else []
            file.write(text_of(row) + "\n")

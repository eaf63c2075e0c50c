"""Reads the markers of a C3D file (www.c3d.org), for tools/convert-capture."""
import struct

from plain_bvh import Joint


class Trouble(Exception):
    """Why a file cannot be read."""


class Markers:
    def __init__(self, names, frames, rate):
        self.names, self.frames, self.rate = names, frames, rate

    def as_joints(self):
        still = [(0.0, 0.0, 0.0)] * len(self.frames)
        joints = [Joint("markers", None, still)]
        for m, name in enumerate(self.names):
            joints.append(Joint(name, 0, [frame[m] for frame in self.frames]))
        return joints


def dec_float(raw):
    """Four bytes of a DEC (VAX) machine."""
    value = struct.unpack("<f", raw[2:4] + raw[0:2])[0]
    return value / 4


class Reader:
    def __init__(self, data):
        if len(data) < 1024 or data[1] != 0x50:
            raise Trouble("is not a C3D file")
        self.data = data
        start = (data[0] - 1) * 512
        if data[0] < 1 or start + 4 > len(data):
            raise Trouble("has no parameters")
        processor = data[start + 3]
        if processor not in (84, 85, 86):
            raise Trouble(f"was written by an unknown kind of machine ({processor})")
        self.end = ">" if processor == 86 else "<"
        self.dec = processor == 85
        self.parameters = self.read_parameters(start + 4, start + 512 * data[start + 2])

    def real(self, at):
        raw = self.data[at:at + 4]
        return dec_float(raw) if self.dec else struct.unpack(self.end + "f", raw)[0]

    def whole(self, at):
        return struct.unpack_from(self.end + "h", self.data, at)[0]

    def read_parameters(self, at, last):
        groups, found = {}, {}
        while at + 2 < min(last, len(self.data)):
            length, group = struct.unpack_from("bb", self.data, at)
            if length == 0:
                break
            name = self.data[at + 2:at + 2 + abs(length)].decode("latin-1").upper()
            at += 2 + abs(length)
            step = struct.unpack_from(self.end + "H", self.data, at)[0]
            if group < 0:
                groups[-group] = name
            else:
                found[group, name] = self.read_value(at + 2)
            if step == 0:
                break
            at += step
        return {(groups.get(group), name): value for (group, name), value in found.items()}

    def read_value(self, at):
        kind, count = struct.unpack_from("bB", self.data, at)
        sizes = list(self.data[at + 2:at + 2 + count])
        at += 2 + count
        total = 1
        for size in sizes:
            total *= size
        if kind == -1:
            width = sizes[0] if sizes else 1
            return [self.data[at + i:at + i + width].decode("latin-1").strip()
                    for i in range(0, total, max(width, 1))]
        if kind == 1:
            return list(self.data[at:at + total])
        if kind == 2:
            return [self.whole(at + 2 * i) for i in range(total)]
        return [self.real(at + 4 * i) for i in range(total)]

    def first(self, name, otherwise):
        value = self.parameters.get(("POINT", name))
        return value[0] if value else otherwise

    def names(self, count):
        labels = []
        for suffix in ["", *map(str, range(2, 100))]:
            labels += self.parameters.get(("POINT", "LABELS" + suffix), [])
        labels = labels[:count] + [""] * (count - len(labels))
        return [label or f"marker_{i + 1}" for i, label in enumerate(labels)]


def read_points(reader, at, count, scale):
    """One frame: (x, y, z) of each marker, None where it was lost."""
    points = []
    for m in range(count):
        if scale < 0:
            place = at + 16 * m
            values = [reader.real(place + 4 * i) for i in range(4)]
            lost = values[3] < 0
        else:
            place = at + 8 * m
            values = [scale * reader.whole(place + 2 * i) for i in range(3)]
            lost = reader.whole(place + 6) < 0
        points.append(None if lost else tuple(values[:3]))
    return points


def filled(frames, count):
    """A lost marker stays where it was seen last, or where it will be seen first."""
    last = [next((frame[m] for frame in frames if frame[m]), (0.0, 0.0, 0.0))
            for m in range(count)]
    for frame in frames:
        for m in range(count):
            frame[m] = last[m] = frame[m] or last[m]
    return frames


def read_c3d(data):
    try:
        reader = Reader(data)
        unsigned = struct.unpack_from(reader.end + "255H", data, 2)
        count, analog, first, last = unsigned[0], unsigned[1], unsigned[2], unsigned[3]
        scale = reader.first("SCALE", reader.real(12))
        rate = reader.first("RATE", reader.real(20))
        start = (reader.first("DATA_START", unsigned[7]) & 0xffff) - 1
        size = (16 if scale < 0 else 8) * count + (4 if scale < 0 else 2) * analog
        frames = max(last - first + 1, 0)
        if count == 0 or frames == 0 or not rate > 0:
            raise Trouble("holds no markers over time")
        if start * 512 + frames * size > len(data):
            raise Trouble("ends before its last frame")
        rows = [read_points(reader, start * 512 + f * size, count, scale) for f in range(frames)]
        return Markers(reader.names(count), filled(rows, count), rate)
    except (struct.error, IndexError) as error:
        raise Trouble("ends within its parameters or frames") from error

#!/usr/bin/python3
"""Writes small bags for test_bag_source.cpp into the folder given: what a stereo pair, a depth
camera and a cloud look like in every format and compression. The messages and ROS 1's bags are
made by ROS's own Python packages; MCAP and CDR follow their published specifications."""
import os
import sqlite3
import struct
import sys

import lz4.frame
import rosbag
import zstandard
from genpy import Time
from sensor_msgs.msg import CameraInfo, CompressedImage, Image, PointCloud2, PointField
from std_msgs.msg import Float32

WIDTH, HEIGHT, FRAMES, FOCAL, BASELINE = 32, 24, 6, 400.0, 0.12


def stamp(frame, later=0.0):
    return Time.from_sec(1000.0 + 0.1 * frame + later)


def image(encoding, channels, value, when, itemsize=1):
    message = Image(height=HEIGHT, width=WIDTH, encoding=encoding)
    message.header.stamp = when
    message.header.frame_id = "camera"
    message.step = WIDTH * channels * itemsize + 4  # padded rows
    rows = []
    for y in range(HEIGHT):
        rows.append(b"".join(value(x, y) for x in range(WIDTH)) + b"\0" * 4)
    message.data = b"".join(rows)
    return message


def grey(frame, offset):
    return lambda x, y: bytes([(x + 2 * y + 10 * frame + offset) % 256])


def info(when, shift):
    message = CameraInfo(height=HEIGHT, width=WIDTH, distortion_model="plumb_bob")
    message.header.stamp = when
    message.D = [0.01, 0.0, 0.0, 0.0, 0.0]
    message.K = [FOCAL, 0, 16, 0, FOCAL, 12, 0, 0, 1]
    message.R = [1, 0, 0, 0, 1, 0, 0, 0, 1]
    message.P = [FOCAL, 0, 16, -FOCAL * shift, 0, FOCAL, 12, 0, 0, 0, 1, 0]
    return message


def stereo():
    for k in range(FRAMES):
        yield "/cam/left/camera_info", stamp(k), info(stamp(k), 0)
        yield "/cam/right/camera_info", stamp(k), info(stamp(k), BASELINE)
        yield "/cam/left/image_raw", stamp(k), image("mono8", 1, grey(k, 0), stamp(k))
        if k != 3:
            later = stamp(k, 0.001)
            yield "/cam/right/image_raw", stamp(k, 0.03), image("mono8", 1, grey(k, 100), later)


def depth(encoding="16UC1", pack=lambda k, x, y: struct.pack("<H", 2000 + k), itemsize=2):
    for k in range(FRAMES):
        yield "/d/camera_info", stamp(k), info(stamp(k), 0)
        pixels = image(encoding, 1, lambda x, y, k=k: pack(k, x, y), stamp(k), itemsize)
        yield "/d/depth/image_raw", stamp(k), pixels
        yield "/d/rgb/camera_info", stamp(k), info(stamp(k), 0)
        colour = image("rgb8", 3, lambda x, y: bytes([10, 20, 30]), stamp(k, 0.002))
        yield "/d/rgb/image_color", stamp(k), colour


def floats():
    def pack(k, x, y):
        return struct.pack("<f", float("nan") if x == 0 else 1.5)
    return depth("32FC1", pack, 4)


def realsense():
    yield "/device_0/sensor_0/option/Depth Units/value", stamp(0), Float32(0.0005)
    for topic, when, message in depth("mono16"):
        if message._type == "sensor_msgs/CameraInfo":
            message.P = [0.0] * 12
        yield topic, when, message


def cloud():
    for k in range(FRAMES):
        message = PointCloud2(height=3, width=4, point_step=28, row_step=28 * 4 + 8)
        message.header.stamp = stamp(k)
        message.header.frame_id = "velodyne"
        message.fields = [PointField("z", 0, 7, 1), PointField("y", 8, 8, 1),
                          PointField("rgb", 20, 7, 1), PointField("x", 16, 7, 1)]
        row = lambda y: b"".join(struct.pack("<f4xdf8x", 2.0 + k, 0.5 * y, 0.25 * x)
                                 for x in range(4)) + b"\0" * 8
        message.data = b"".join(row(y) for y in range(3))
        yield "/points", stamp(k), message


def several():
    yield from stereo()
    yield from cloud()


def with_cameras(change):
    """A stereo pair whose camera_info `change` has altered."""
    for topic, when, message in stereo():
        if message._type == "sensor_msgs/CameraInfo":
            change(message)
        yield topic, when, message


def fisheye():
    return with_cameras(lambda info: setattr(info, "distortion_model", "equidistant"))


def straight():
    """No coefficients at all, as ROS writes of pictures that are rectified already."""
    return with_cameras(lambda info: setattr(info, "D", []))


def focusless():
    return with_cameras(lambda info: setattr(info, "K", [0.0] * 9))


def direct():
    """A name that "rect" is a part of, but not a word."""
    for topic, when, message in stereo():
        yield "/direct" + topic, when, message


def silent():
    """Stamps that nobody set: the time of recording counts."""
    for topic, when, message in stereo():
        message.header.stamp = Time(0)
        yield topic, when, message


CONTENTS = {"stereo": stereo, "depth": depth, "floats": floats, "realsense": realsense,
            "cloud": cloud, "several": several, "silent": silent,
            "fisheye": fisheye, "straight": straight, "focusless": focusless, "direct": direct}


class Cdr:
    """ROS 2's serialisation of a ROS 1 message class."""
    NUMBERS = {"bool": "B", "uint8": "B", "int8": "b", "uint16": "H", "int16": "h", "uint32": "I",
               "int32": "i", "uint64": "Q", "int64": "q", "float32": "f", "float64": "d"}

    def __init__(self, message):
        self.out = bytearray()
        self.message(message)

    def bytes(self):
        return b"\0\1\0\0" + bytes(self.out)

    def number(self, code, value):
        size = struct.calcsize(code)
        self.out += b"\0" * (-len(self.out) % size) + struct.pack("<" + code, value)

    def message(self, message):
        for name, kind in zip(message.__slots__, message._slot_types):
            if message._type == "std_msgs/Header" and name == "seq":
                continue
            self.value(kind, getattr(message, name))

    def value(self, kind, value):
        if kind.endswith("]"):
            item, count = kind[:-1].split("[")
            if not count:
                self.number("I", len(value))
            if item == "uint8":
                self.out += bytes(value)
            else:
                for one in value:
                    self.value(item, one)
        elif kind == "string":
            text = value.encode() + b"\0"
            self.number("I", len(text))
            self.out += text
        elif kind == "time":
            self.number("i", value.secs)
            self.number("I", value.nsecs)
        elif kind in self.NUMBERS:
            self.number(self.NUMBERS[kind], value)
        else:
            self.message(value)


def type_of_ros2(message):
    return message._type.replace("/", "/msg/")


def write_ros1(path, content, compression):
    with rosbag.Bag(path, "w", compression=compression, chunk_threshold=2000) as bag:
        for topic, when, message in content():
            bag.write(topic, message, when)


def write_db3(path, content):
    base = sqlite3.connect(path)
    base.execute("CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT, type TEXT,"
                 " serialization_format TEXT, offered_qos_profiles TEXT)")
    base.execute("CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER,"
                 " timestamp INTEGER, data BLOB)")
    topics = {}
    for topic, when, message in content():
        if topic not in topics:
            topics[topic] = len(topics) + 1
            base.execute("INSERT INTO topics VALUES(?, ?, ?, 'cdr', '')",
                         (topics[topic], topic, type_of_ros2(message)))
        base.execute("INSERT INTO messages(topic_id, timestamp, data) VALUES(?, ?, ?)",
                     (topics[topic], when.to_nsec(), Cdr(message).bytes()))
    base.commit()
    base.close()


def record(op, content):
    return struct.pack("<BQ", op, len(content)) + content


def text(value):
    return struct.pack("<I", len(value)) + value.encode()


def write_mcap(path, content, compression, indexed=True):
    pack = {"": bytes, "lz4": lz4.frame.compress,
            "zstd": zstandard.ZstdCompressor().compress}[compression]
    out = bytearray(b"\x89MCAP0\r\n" + record(1, text("ros2") + text("test")))
    channels, chunk, index = {}, bytearray(), {}

    def flush():
        packed = pack(bytes(chunk))
        head = struct.pack("<QQQI", 0, 0, len(chunk), 0)
        out.extend(record(6, head + text(compression) + struct.pack("<Q", len(packed)) + packed))
        for channel, entries in index.items() if indexed else []:
            data = b"".join(struct.pack("<QQ", *entry) for entry in entries)
            out.extend(record(7, struct.pack("<HI", channel, len(data)) + data))
        chunk.clear()
        index.clear()

    for topic, when, message in content():
        if topic not in channels:
            number = channels[topic] = len(channels) + 1
            kind = type_of_ros2(message)
            chunk += record(3, struct.pack("<H", number) + text(kind) + text("ros2msg") + text(""))
            chunk += record(4, struct.pack("<HH", number, number) + text(topic) + text("cdr") +
                            struct.pack("<I", 0))
        index.setdefault(channels[topic], []).append((when.to_nsec(), len(chunk)))
        head = struct.pack("<HIQQ", channels[topic], 0, when.to_nsec(), when.to_nsec())
        chunk += record(5, head + Cdr(message).bytes())
        if len(chunk) > 3000:
            flush()
    flush()
    out += record(15, struct.pack("<I", 0)) + record(2, struct.pack("<QQI", 0, 0, 0))
    with open(path, "wb") as file:
        file.write(out + b"\x89MCAP0\r\n")


def main(folder):
    for name, content in CONTENTS.items():
        for compression in ("none", "bz2", "lz4"):
            write_ros1(os.path.join(folder, f"{name}-{compression}.bag"), content, compression)
        for compression in ("", "lz4", "zstd"):
            path = os.path.join(folder, f"{name}-{compression or 'none'}.mcap")
            write_mcap(path, content, compression)
        write_mcap(os.path.join(folder, f"{name}-unindexed.mcap"), content, "zstd", False)
        write_db3(os.path.join(folder, f"{name}-cdr.db3"), content)


main(sys.argv[1])

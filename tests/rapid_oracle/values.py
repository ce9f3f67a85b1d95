"""Values and their types. num is a float rounded to single precision, bool and string are Python's, records and arrays are lists.

A record carries no type of its own: RAPID takes components of named data alone, whose type is declared.
"""

import math
import struct

from lexer import Refused

RECORDS = {
    "pos": [("x", "num"), ("y", "num"), ("z", "num")],
    "orient": [("q1", "num"), ("q2", "num"), ("q3", "num"), ("q4", "num")],
    "pose": [("trans", "pos"), ("rot", "orient")],
    "confdata": [("cf1", "num"), ("cf4", "num"), ("cf6", "num"), ("cfx", "num")],
    "extjoint": [("eax_" + axis, "num") for axis in "abcdef"],
    "robtarget": [("trans", "pos"), ("rot", "orient"), ("robconf", "confdata"), ("extax", "extjoint")],
    "robjoint": [(f"rax_{axis}", "num") for axis in range(1, 7)],
    "jointtarget": [("robax", "robjoint"), ("extax", "extjoint")],
    "speeddata": [("v_tcp", "num"), ("v_ori", "num"), ("v_leax", "num"), ("v_reax", "num")],
    "zonedata": [("finep", "bool")]
    + [(name, "num") for name in ("pzone_tcp", "pzone_ori", "pzone_eax", "zone_ori", "zone_leax", "zone_reax")],
    "loaddata": [("mass", "num"), ("cog", "pos"), ("aom", "orient"), ("ix", "num"), ("iy", "num"), ("iz", "num")],
    "tooldata": [("robhold", "bool"), ("tframe", "pose"), ("tload", "loaddata")],
    "wobjdata": [("robhold", "bool"), ("ufprog", "bool"), ("ufmec", "string"), ("uframe", "pose"), ("oframe", "pose")],
}
ATOMIC = {"num": 0.0, "bool": False, "string": "", "switch": True, "dnum": 0.0}
ALIASES = {"errnum": "num", "intnum": "num", "dionum": "num", "clock": "num"}


def single(x):
    """The nearest value of single precision, as a controller holds a num."""
    return struct.unpack("f", struct.pack("f", x))[0]


def written(value):
    """A value as RAPID text. A num in the fewest digits that give the same value of single precision."""
    if isinstance(value, bool):
        return "TRUE" if value else "FALSE"
    if isinstance(value, str):
        return '"' + value.replace("\\", "\\\\").replace('"', '""') + '"'
    if isinstance(value, list):
        return "[" + ",".join(written(part) for part in value) + "]"
    for digits in range(1, 18):
        text = f"{value:.{digits}g}"
        if float(text) == value or (digits >= 6 and single(float(text)) == value):
            return text
    raise Refused(f"no number: {value}")


def copied(value):
    return [copied(part) for part in value] if isinstance(value, list) else value


def pos(value):
    return isinstance(value, list) and len(value) == 3 and all(isinstance(part, float) for part in value)


def orient(value):
    return isinstance(value, list) and len(value) == 4 and all(isinstance(part, float) for part in value)


def linked(a, b):
    """Orientation b seen in a, turned into a's own reference: the quaternion product."""
    return [
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
        a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
        a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
    ]


def turned(q, p):
    w = linked(linked(q, [0.0] + p), [q[0], -q[1], -q[2], -q[3]])
    return w[1:]


def unit(q):
    length = math.sqrt(sum(part * part for part in q))
    return [part / length for part in q]


def from_euler_zyx(z, y, x):
    """Turned about z, then about the new y, then about the new x, degrees."""
    half = [math.radians(angle) / 2 for angle in (z, y, x)]
    about_z = [math.cos(half[0]), 0.0, 0.0, math.sin(half[0])]
    about_y = [math.cos(half[1]), 0.0, math.sin(half[1]), 0.0]
    about_x = [math.cos(half[2]), math.sin(half[2]), 0.0, 0.0]
    return linked(linked(about_z, about_y), about_x)


def euler_zyx(q):
    w, x, y, z = unit(q)
    return {
        "z": math.degrees(math.atan2(2 * (x * y + w * z), 1 - 2 * (y * y + z * z))),
        "y": math.degrees(math.asin(max(-1.0, min(1.0, 2 * (w * y - x * z))))),
        "x": math.degrees(math.atan2(2 * (y * z + w * x), 1 - 2 * (x * x + y * y))),
    }

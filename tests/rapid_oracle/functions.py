"""RAPID's own functions of values. Each takes its required arguments in order and its optional ones by name, and gives one value.

Results are computed in double precision and rounded once, by the caller.
"""

import math

from values import euler_zyx, from_euler_zyx, linked, turned, unit, written


class Fault(Exception):
    """An error that RAPID's error handler sees, by the name of its error number."""


def decimals(value, places, how):
    scale = 10.0 ** int(places)
    return how(value * scale) / scale


def truncated(value, dec=0.0):
    return decimals(value, dec, math.trunc)


def rounded(value, dec=0.0):
    return decimals(value, dec, lambda x: math.copysign(math.floor(abs(x) + 0.5), x))


def root(value):
    if value < 0:
        raise Fault("err_argvalerr")
    return math.sqrt(value)


def relative(target, dx, dy, dz, rx=0.0, ry=0.0, rz=0.0):
    """Shifted and turned in the tool's own axes: about x, then the new y, then the new z."""
    trans, rot = target[0], target[1]
    shift = turned(rot, [dx, dy, dz])
    turn = linked(linked(from_euler_zyx(0, 0, rx), from_euler_zyx(0, ry, 0)), from_euler_zyx(rz, 0, 0))
    return [[a + b for a, b in zip(trans, shift)], linked(rot, turn)] + target[2:]


def offset(target, dx, dy, dz):
    return [[a + b for a, b in zip(target[0], (dx, dy, dz))]] + target[1:]


def pose_product(a, b):
    return [[p + q for p, q in zip(a[0], turned(a[1], b[0]))], linked(a[1], b[1])]


def pose_inverse(a):
    back = [a[1][0], -a[1][1], -a[1][2], -a[1][3]]
    return [[-part for part in turned(back, a[0])], back]


def pose_vector(a, p):
    return [s + t for s, t in zip(a[0], turned(a[1], p))]


def angle(q, x=None, y=None, z=None):
    wanted = "x" if x else "y" if y else "z"
    return euler_zyx(q)[wanted]


def length(v):
    return math.sqrt(sum(part * part for part in v))


def number_text(value, places, exp=None):
    places = int(places)
    if exp:
        mantissa, power = f"{value:.{places}E}".split("E")
        return f"{mantissa}E{int(power):+03d}"
    return f"{value:.{places}f}"


def value_text(value):
    """Six digits of a number at most."""
    if isinstance(value, list):
        return "[" + ",".join(f'"{part}"' if isinstance(part, str) else value_text(part) for part in value) + "]"
    if isinstance(value, float):
        return f"{value:.6G}"
    return value if isinstance(value, str) else written(value)


def part(text, first, count):
    first, count = int(first), int(count)
    if first < 1 or count < 0 or first - 1 + count > len(text):
        raise Fault("err_argvalerr")
    return text[first - 1 : first - 1 + count]


def find(text, first, wanted, notinset=None):
    """Where the first character of a set stands, one more than the length where none does."""
    for i in range(int(first) - 1, len(text)):
        if (text[i] in wanted) != bool(notinset):
            return float(i + 1)
    return float(len(text) + 1)


def match(text, first, wanted):
    i = text.find(wanted, int(first) - 1)
    return float(i + 1 if i >= 0 else len(text) + 1)


def changed(text, from_set, to_set):
    return "".join(to_set[from_set.index(c)] if c in from_set else c for c in text)


FUNCTIONS = {
    "abs": abs,
    "trunc": truncated,
    "round": rounded,
    "sqrt": root,
    "pow": lambda base, exponent: base**exponent,
    "exp": math.exp,
    "sin": lambda a: math.sin(math.radians(a)),
    "cos": lambda a: math.cos(math.radians(a)),
    "tan": lambda a: math.tan(math.radians(a)),
    "asin": lambda a: math.degrees(math.asin(a)),
    "acos": lambda a: math.degrees(math.acos(a)),
    "atan": lambda a: math.degrees(math.atan(a)),
    "atan2": lambda y, x: math.degrees(math.atan2(y, x)),
    "offs": offset,
    "reltool": relative,
    "posemult": pose_product,
    "poseinv": pose_inverse,
    "posevect": pose_vector,
    "orientzyx": lambda z, y, x: from_euler_zyx(z, y, x),
    "eulerzyx": angle,
    "norient": unit,
    "distance": lambda a, b: length([s - t for s, t in zip(a, b)]),
    "dotprod": lambda a, b: sum(s * t for s, t in zip(a, b)),
    "vectmagn": length,
    "numtostr": number_text,
    "valtostr": value_text,
    "strlen": lambda text: float(len(text)),
    "strpart": part,
    "strfind": find,
    "strmatch": match,
    "strmap": changed,
    "strmemb": lambda text, at, wanted: text[int(at) - 1] in wanted,
}


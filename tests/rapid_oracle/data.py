"""What names stand for while a program runs: data, places within data, the names of a routine that is being executed; and types."""

from lexer import Refused
from values import ATOMIC, copied, single

SPEEDS = (5, 10, 20, 30, 40, 50, 60, 80, 100, 150, 200, 300, 400, 500, 600, 800, 1000)
ZONES = ("fine", "z0", "z1", "z5", "z10", "z15", "z20", "z30", "z40", "z50")
ERRORS = ("err_divzero", "err_argvalerr", "err_refunkprc", "err_callproc", "err_outofbnd", "err_strtoolng")
IDENTITY = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0]]


class Cell:
    """One datum: what a name stands for."""

    __slots__ = ("kind", "type", "dims", "value", "name")

    def __init__(self, kind, type_of, dims, value, name=""):
        self.kind, self.type, self.dims, self.value, self.name = kind, type_of, dims, value, name


class Place:
    """A datum, an element or a component, to read and to write: what a VAR, PERS or INOUT parameter is bound to."""

    __slots__ = ("cell", "steps", "type", "dims")

    def __init__(self, cell, steps, type_of, dims):
        self.cell, self.steps, self.type, self.dims = cell, steps, type_of, dims

    def read(self):
        value = self.cell.value
        for step in self.steps:
            value = value[step]
        return value

    def write(self, value):
        if not self.steps:
            self.cell.value = value
            return
        holder = self.cell.value
        for step in self.steps[:-1]:
            holder = holder[step]
        holder[self.steps[-1]] = value


class Frame:
    def __init__(self, routine):
        self.routine, self.names, self.absent, self.handling = routine, {}, set(), False


class RapidError(Exception):
    """An error at a statement; the routine's handler may catch it."""

    def __init__(self, number):
        super().__init__(number)
        self.number = number


class Names:
    """Data and routines by name; values fitted to types. `value` and `num` come from the classes built on this one."""

    def predefined(self):
        def const(name, type_of, value):
            self.globals[name] = Cell("const", type_of, [], value, name)

        for speed in SPEEDS:
            const(f"v{speed}", "speeddata", [float(speed), 500.0, 5000.0, 1000.0])
        for zone in ZONES:
            size = 0.0 if zone == "fine" else float(zone[1:])
            const(zone, "zonedata", [zone == "fine", size] + [size] * 5)
        for at, name in enumerate(ERRORS):
            const(name, "errnum", float(100 + at))
        load = [0.001, [0.0, 0.0, 0.001], [1.0, 0.0, 0.0, 0.0], 0.0, 0.0, 0.0]
        self.globals["tool0"] = Cell("pers", "tooldata", [], [True, copied(IDENTITY), load], "tool0")
        self.globals["wobj0"] = Cell("pers", "wobjdata", [], [False, True, "", copied(IDENTITY), copied(IDENTITY)], "wobj0")
        const("pi", "num", single(3.141592653589793))

    def resolved(self, type_of):
        while type_of in self.aliases:
            type_of = self.aliases[type_of]
        return type_of

    def found(self, name, frame):
        if name in frame.names:
            return frame.names[name]
        if frame.routine is not None:
            own = self.locals[frame.routine.module.name]
            if name in own:
                return own[name]
        return self.globals[name]

    def fresh(self, type_of, dims=()):
        if dims:
            return [self.fresh(type_of, dims[1:]) for _ in range(dims[0])]
        type_of = self.resolved(type_of)
        if type_of in self.records:
            return [self.fresh(part) for _, part in self.records[type_of]]
        return ATOMIC[type_of]

    def fitted(self, value, type_of, dims=()):
        """The value as the type holds it: a copy, every num rounded. What does not fit is refused."""
        if dims:
            if not isinstance(value, list) or (dims[0] is not None and len(value) != dims[0]):
                raise Refused(f"an array of {dims} cannot hold {value}")
            return [self.fitted(part, type_of, dims[1:]) for part in value]
        type_of = self.resolved(type_of)
        if type_of in self.records:
            parts = self.records[type_of]
            if not isinstance(value, list) or len(value) != len(parts):
                raise Refused(f"no {type_of}: {value}")
            return [self.fitted(part, kind) for part, (_, kind) in zip(value, parts)]
        if type_of == "num" and isinstance(value, float):
            return self.num(value)
        if type_of == "dnum" and isinstance(value, float):
            return value
        if type_of in ("bool", "switch") and isinstance(value, bool):
            return value
        if type_of == "string" and isinstance(value, str):
            return value
        raise Refused(f"no {type_of}: {value!r}")

    def declared(self, declared, frame):
        dims = [int(self.value(dim, frame)) for dim in declared.dims]
        if declared.value is None:
            value = self.fresh(declared.type, dims)
        else:
            value = self.fitted(self.value(declared.value, frame), declared.type, dims)
        return Cell(declared.kind, declared.type, dims, value, declared.name)

    def place(self, path, frame):
        _, name, steps = path
        found = self.found(name, frame)
        if isinstance(found, Place):
            cell, taken, type_of, dims = found.cell, list(found.steps), found.type, list(found.dims)
        elif isinstance(found, Cell):
            cell, taken, type_of, dims = found, [], found.type, list(found.dims)
        else:
            raise Refused(f"{name} is no data")
        for how, what in steps:
            if how == "element":
                if len(what) != len(dims):
                    raise Refused(f"{name} has {len(dims)} dimensions")
                for expression, size in zip(what, dims):
                    at = self.value(expression, frame)
                    if at != int(at) or not 1 <= at <= size:
                        raise self.error("err_outofbnd")
                    taken.append(int(at) - 1)
                dims = []
            else:
                parts = [part for part, _ in self.records[self.resolved(type_of)]]
                at = parts.index(what)
                taken.append(at)
                type_of = self.records[self.resolved(type_of)][at][1]
        return Place(cell, taken, type_of, dims)

    def error(self, name):
        return RapidError(self.globals[name].value)

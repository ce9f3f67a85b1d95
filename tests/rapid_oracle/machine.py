"""Executes modules: data and routines by name, statements in order, motions recorded with what their arguments are worth.

Language alone: no arm, and a clock that whoever runs it sets. What a motion would do with its target is not asked here.

`faults` breaks the machine on purpose, so that a test can show what the comparison notices: "precedence", "for", "double", "inout", "test".
"""

import datetime

from functions import FUNCTIONS, Fault
from lexer import Refused
from parser import Parser
from values import ALIASES, ATOMIC, RECORDS, copied, linked, orient, pos, single

STEPS = 2_000_000  # statements of one run; a generated program needs some thousands
SPEEDS = (5, 10, 20, 30, 40, 50, 60, 80, 100, 150, 200, 300, 400, 500, 600, 800, 1000)
ZONES = ("fine", "z0", "z1", "z5", "z10", "z15", "z20", "z30", "z40", "z50")
MOTIONS = {"movel": (1, 5), "movej": (1, 5), "moveabsj": (1, 5), "movec": (2, 6)}
NOTHING = {"velset", "accset", "tpwrite", "tperase", "confl", "confj", "singarea", "waittime", "set", "reset", "stop", "confdata"}
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


class Handed(Exception):
    """An error that the routine hands on to its caller."""

    def __init__(self, number):
        super().__init__(number)
        self.number = number


class Goto(Exception):
    pass


class Returned(Exception):
    pass


class Retried(Exception):
    pass


class Next(Exception):
    pass


class Exited(Exception):
    pass


class Machine:
    def __init__(self, *texts, faults=()):
        self.faults = frozenset(faults)
        self.num = float if "double" in self.faults else single
        self.records, self.aliases = dict(RECORDS), dict(ALIASES)
        self.globals, self.locals = {}, {}
        self.motions, self.steps, self.errno = [], 0, 0.0
        self.now = datetime.datetime(2026, 2, 27, 22, 30)  # stands still until it is set
        self.predefined()
        modules = [module for text in texts for module in Parser(text, self.faults).modules()]
        for module in modules:
            self.records.update(module.records)
            self.aliases.update(module.aliases)
            own = self.locals[module.name] = {}
            for routine in module.routines:
                (own if routine.local else self.globals)[routine.name] = routine
        frames = []
        for module in modules:
            frame = Frame(None)
            frame.names = self.locals[module.name]
            frames.append((module, frame))
        # Data may be given by data that stands further below or in another module: what is not known yet is tried again.
        waiting = [(declared, frame) for module, frame in frames for declared in module.data]
        while waiting:
            later, why = [], None
            for declared, frame in waiting:
                try:
                    cell = self.declared(declared, frame)
                except KeyError as error:
                    later.append((declared, frame))
                    why = error
                    continue
                (frame.names if declared.local else self.globals)[declared.name] = cell
            if len(later) == len(waiting):
                raise Refused(f"unknown name {why}")
            waiting = later

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

    # names and types
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

    # values
    def value(self, expression, frame):
        how = expression[0]
        if how == "number":
            return self.num(expression[1])
        if how in ("string", "bool"):
            return expression[1]
        if how == "aggregate":
            return [self.value(part, frame) for part in expression[1]]
        if how == "path":
            if expression[1] == "errno" and not expression[2]:
                return self.errno
            return copied(self.place(expression, frame).read())
        if how == "not":
            return not self.truth(self.value(expression[1], frame))
        if how == "minus":
            value = self.value(expression[1], frame)
            return [-part for part in value] if pos(value) else -value
        if how == "binary":  # both sides always, also of AND and OR
            left, right = self.value(expression[2], frame), self.value(expression[3], frame)
            return self.rounded(self.binary(expression[1], left, right))
        return self.function(expression[1], expression[2], frame)

    def truth(self, value):
        if not isinstance(value, bool):
            raise Refused(f"no bool: {value!r}")
        return value

    def rounded(self, value):
        if isinstance(value, float):
            return self.num(value)
        return [self.rounded(part) for part in value] if isinstance(value, list) else value

    def binary(self, operator, a, b):
        if operator == "and":
            return self.truth(a) and self.truth(b)
        if operator == "or":
            return self.truth(a) or self.truth(b)
        if operator == "xor":
            return self.truth(a) != self.truth(b)
        if operator in ("=", "<>"):
            if type(a) is not type(b):
                raise Refused(f"{a!r} {operator} {b!r}")
            return (a == b) == (operator == "=")
        if operator == "+" and isinstance(a, str) and isinstance(b, str):
            return a + b
        if pos(a) or pos(b) or orient(a):
            return self.vector(operator, a, b)
        if type(a) is not float or type(b) is not float:
            raise Refused(f"{a!r} {operator} {b!r}")
        if operator == "+":
            return a + b
        if operator == "-":
            return a - b
        if operator == "*":
            return a * b
        if operator in ("/", "div", "mod"):
            if b == 0:
                raise self.error("err_divzero")
            if operator == "/":
                return a / b
            if a != int(a) or b != int(b):
                raise Refused(f"{a} {operator} {b}: not whole")
            # Nothing is said of the remainder of a negative number; programs here have none.
            quotient = int(a) // int(b) if a >= 0 and b > 0 else int(a / b)
            return float(quotient) if operator == "div" else a - quotient * b
        return {"<": a < b, "<=": a <= b, ">": a > b, ">=": a >= b}[operator]

    def vector(self, operator, a, b):
        if operator == "+" and pos(a) and pos(b):
            return [s + t for s, t in zip(a, b)]
        if operator == "-" and pos(a) and pos(b):
            return [s - t for s, t in zip(a, b)]
        if operator == "*" and pos(a) and type(b) is float:
            return [s * b for s in a]
        if operator == "*" and type(a) is float and pos(b):
            return [a * t for t in b]
        if operator == "*" and pos(a) and pos(b):
            return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
        if operator == "*" and orient(a) and orient(b):
            return linked(a, b)
        raise Refused(f"{a} {operator} {b}")

    def function(self, name, arguments, frame):
        if name == "present":
            return arguments[0][2][1] not in frame.absent
        if name == "dim":
            array = self.place(arguments[0][2], frame)
            return float(array.dims[int(self.value(arguments[1][2], frame)) - 1])
        if name in ("ispers", "isvar"):
            return self.place(arguments[0][2], frame).cell.kind == name[2:]
        if name == "strtoval":
            return self.from_text(arguments, frame)
        try:
            routine = self.found(name, frame)
        except KeyError:
            routine = None
        if routine is not None:
            return self.called(routine, arguments, frame)
        if name in ("cdate", "ctime"):
            return self.now.strftime("%Y-%m-%d" if name == "cdate" else "%H:%M:%S")
        if name not in FUNCTIONS:
            raise Refused(f"unknown function {name}")
        required = [self.value(what, frame) for how, _, what in arguments if how == "required"]
        optional = {}
        for how, key, what in arguments:
            if how == "optional":
                optional[key] = True if what is None else self.value(what, frame)
            elif how == "conditional" and what not in frame.absent:
                optional[key] = self.value(("path", what, []), frame)
        try:
            return self.rounded(FUNCTIONS[name](*required, **optional))
        except Fault as fault:
            raise self.error(str(fault)) from None

    def from_text(self, arguments, frame):
        text, target = self.value(arguments[0][2], frame), self.place(arguments[1][2], frame)
        try:
            parser = Parser(text)
            value = self.value(parser.expression(), frame)
            if parser.kind() != "end":
                return False
            target.write(self.fitted(value, target.type, target.dims))
        except (Refused, KeyError):
            return False
        return True

    # routines
    def called(self, routine, arguments, frame):
        inner = Frame(routine)
        required = [parameter for parameter in routine.parameters if not parameter.optional]
        by_name = {parameter.name: parameter for parameter in routine.parameters}
        given = {}
        for how, name, what in arguments:
            if how == "required":
                if not required:
                    raise Refused(f"too many arguments of {routine.name}")
                parameter = required.pop(0)
                if name is not None and name != parameter.name:
                    raise Refused(f"{routine.name} has {parameter.name} where {name} is given")
                given[parameter.name] = self.bound(parameter, what, frame)
            elif how == "conditional":
                if what not in frame.absent:
                    given[name] = self.bound(by_name[name], ("path", what, []), frame)
            elif what is None:
                given[name] = Cell("var", "switch", [], True)
            else:
                given[name] = self.bound(by_name[name], what, frame)
        if required:
            raise Refused(f"{routine.name} lacks {required[0].name}")
        for parameter in routine.parameters:
            if parameter.name in given:
                inner.names[parameter.name] = given[parameter.name]
            else:
                inner.absent.add(parameter.name)
        for declared in routine.data:
            inner.names[declared.name] = self.declared(declared, inner)
        try:
            self.run(routine.body, inner)
        except Returned as returned:
            return returned.args[0]
        except Handed as handed:
            raise RapidError(handed.number) from None
        except Goto as goto:
            raise Refused(f"no label {goto} in {routine.name}") from None
        if routine.kind == "func":
            raise Refused(f"{routine.name} ends without RETURN")
        return None

    def bound(self, parameter, expression, frame):
        if parameter.mode == "in" or "inout" in self.faults:
            value = self.value(expression, frame)
            dims = []
            level = value
            for _ in range(parameter.dims):
                dims.append(len(level))
                level = level[0]
            return Cell("var", parameter.type, dims, self.fitted(value, parameter.type, dims))
        if expression[0] != "path":
            raise Refused(f"{parameter.name} needs data")
        place = self.place(expression, frame)
        allowed = ("var", "pers") if parameter.mode == "inout" else (parameter.mode,)
        if place.cell.kind not in allowed or self.resolved(place.type) != self.resolved(parameter.type):
            raise Refused(f"{parameter.name} cannot be bound to {expression[1]}")
        return place

    def started(self, entry="main"):
        """Runs a procedure; returns the motions."""
        outside = Frame(None)
        try:
            self.called(self.globals[entry], [], outside)
        except Exited:
            pass
        return self.motions

    # statements
    def run(self, statements, frame):
        at = 0
        while at < len(statements):
            self.steps += 1
            if self.steps > STEPS:
                raise Refused("does not end")
            try:
                self.statement(statements[at], frame)
            except Goto as goto:
                for i, statement in enumerate(statements):
                    if statement[0] == "label" and statement[1] == goto.args[0]:
                        at = i
                        break
                else:
                    raise
            except RapidError as error:
                if self.recovered(error, frame):
                    continue
            at += 1

    def recovered(self, error, frame):
        """The routine's error handler. True where the statement is to be tried again, False to go on behind it."""
        routine = frame.routine
        if routine.handler is None or frame.handling:
            raise Handed(error.number)
        if routine.handles is not None and error.number not in [self.value(each, frame) for each in routine.handles]:
            raise Handed(error.number)
        self.errno, frame.handling = error.number, True
        try:
            self.run(routine.handler, frame)
        except Retried:
            return True
        except Next:
            return False
        finally:
            frame.handling = False
        raise Refused(f"the error handler of {routine.name} ends without an answer")

    def statement(self, statement, frame):
        getattr(self, "do_" + statement[0])(statement, frame)

    def do_label(self, statement, frame):
        pass

    def do_goto(self, statement, frame):
        raise Goto(statement[1])

    def do_return(self, statement, frame):
        value = None
        if statement[1] is not None:
            value = self.value(statement[1], frame)
            if frame.routine.type:
                value = self.fitted(value, frame.routine.type)
        raise Returned(value)

    def do_raise(self, statement, frame):
        number = self.errno if statement[1] is None else self.value(statement[1], frame)
        raise Handed(number) if frame.handling else RapidError(number)

    def do_exit(self, statement, frame):
        raise Exited

    def do_retry(self, statement, frame):
        raise Retried

    def do_trynext(self, statement, frame):
        raise Next

    def do_assign(self, statement, frame):
        place = self.place(statement[1], frame)
        if place.cell.kind in ("const", "loop"):
            raise Refused(f"{statement[1][1]} cannot be assigned")
        place.write(self.fitted(self.value(statement[2], frame), place.type, place.dims))

    def do_if(self, statement, frame):
        for condition, body in statement[1]:
            if self.truth(self.value(condition, frame)):
                self.run(body, frame)
                return
        self.run(statement[2], frame)

    def do_while(self, statement, frame):
        while self.truth(self.value(statement[1], frame)):
            self.steps += 1
            if self.steps > STEPS:
                raise Refused("does not end")
            self.run(statement[2], frame)

    def do_for(self, statement, frame):
        _, name, first, last, step, body, _ = statement
        i, last = self.value(first, frame), self.value(last, frame)
        step = (1.0 if i <= last else -1.0) if step is None else self.value(step, frame)
        hidden = frame.names.get(name)
        try:
            while i < last if step > 0 else i > last:
                frame.names[name] = Cell("loop", "num", [], i, name)
                self.run(body, frame)
                i = self.num(i + step)
            if i == last and "for" not in self.faults:
                frame.names[name] = Cell("loop", "num", [], i, name)
                self.run(body, frame)
        finally:
            frame.names.pop(name, None)
            if hidden is not None:
                frame.names[name] = hidden

    def do_test(self, statement, frame):
        _, value, cases, default, _ = statement
        value, taken = self.value(value, frame), False
        for values, body in cases:
            if taken or any(self.binary("=", value, self.value(each, frame)) for each in values):
                taken = True
                self.run(body, frame)
                if "test" not in self.faults:
                    return
        if not taken or "test" in self.faults:
            self.run(default, frame)

    def do_late(self, statement, frame):
        self.by_name(self.value(statement[1], frame), statement[2], frame)

    def by_name(self, name, arguments, frame):
        routine = self.globals.get(name.lower().split(":")[-1])
        if routine is None or isinstance(routine, Cell):
            raise self.error("err_refunkprc")
        self.called(routine, arguments, frame)

    def do_call(self, statement, frame):
        _, name, arguments, _ = statement
        try:
            routine = self.found(name, frame)
        except KeyError:
            routine = None
        if routine is not None:
            self.called(routine, arguments, frame)
        elif name in MOTIONS:
            self.motion(name, arguments, frame)
        elif name in ("incr", "decr", "clear", "add"):
            place = self.place(arguments[0][2], frame)
            by = self.value(arguments[1][2], frame) if name == "add" else {"incr": 1.0, "decr": -1.0, "clear": None}[name]
            place.write(self.fitted(0.0 if by is None else place.read() + by, place.type))
        elif name == "callbyvar":
            self.by_name(self.value(arguments[0][2], frame) + f"{self.value(arguments[1][2], frame):g}", [], frame)
        elif name == "bookerrno":
            self.place(arguments[0][2], frame).write(float(200 + self.steps % 1000))
        elif name not in NOTHING:
            raise Refused(f"line {statement[-1]}: unknown instruction {name}")

    def motion(self, name, arguments, frame):
        """Keeps the motion: its targets' values, and speed, zone, tool and work object, each as (name, value)."""
        targets, named = MOTIONS[name][0], []
        required = [what for how, _, what in arguments if how == "required"]
        type_of = "jointtarget" if name == "moveabsj" else "robtarget"
        places = [self.fitted(self.value(what, frame), type_of) for what in required[:targets]]
        for what, kind in zip(required[targets:], ("speeddata", "zonedata", "tooldata")):
            label = what[1] if what[0] == "path" and not what[2] else None
            named.append((label, self.fitted(self.value(what, frame), kind)))
        wobj = None
        for how, key, what in arguments:
            if how == "optional" and key == "wobj":
                wobj = (what[1], self.fitted(self.value(what, frame), "wobjdata"))
        self.motions.append((name, places, named, wobj))

"""Executes modules: data and routines by name, statements in order, motions recorded with what their arguments are worth.

Language alone: no arm, and a clock that whoever runs it sets. What a motion would do with its target is not asked here.

`faults` breaks the machine on purpose, so that a test can show what the comparison notices: "precedence", "for", "double", "inout", "test".
"""

import datetime

from data import Cell, Frame, RapidError
from expressions import Expressions
from lexer import Refused
from parser import Parser
from values import ALIASES, RECORDS, single

STEPS = 2_000_000  # statements of one run; a generated program needs some thousands
MOTIONS = {"movel": (1, 5), "movej": (1, 5), "moveabsj": (1, 5), "movec": (2, 6)}
NOTHING = {"velset", "accset", "tpwrite", "tperase", "confl", "confj", "singarea", "waittime", "stop"}


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


class Machine(Expressions):
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

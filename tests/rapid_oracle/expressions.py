"""Values of expressions, and the functions among them that look at data instead of values."""

from data import Names, RapidError
from functions import FUNCTIONS, Fault
from lexer import Refused
from parser import Parser
from values import copied, linked, orient, pos


class Expressions(Names):
    """`called` comes from the class built on this one."""

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

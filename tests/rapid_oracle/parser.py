"""Tokens to modules, after the syntax summary of ABB's RAPID kernel reference manual (3HAC16585-1). One method a production.

An expression and a statement are tuples whose first element says which. A statement's last element is its line.
"""

from dataclasses import dataclass, field

from lexer import RESERVED, Refused, tokens

RELATIONS = {"<", "<=", "=", ">", ">=", "<>"}
SECTIONS = {"backward", "error", "undo", "endproc", "endfunc", "endtrap"}


@dataclass
class Declared:
    kind: str  # var, pers, const
    type: str
    name: str
    dims: list
    value: object
    local: bool = False


@dataclass
class Parameter:
    mode: str  # in, var, pers, inout
    type: str
    name: str
    dims: int
    optional: bool


@dataclass
class Routine:
    kind: str  # proc, func, trap
    name: str
    type: str = ""
    parameters: list = field(default_factory=list)
    data: list = field(default_factory=list)
    body: list = field(default_factory=list)
    handler: object = None
    handles: object = None  # the error numbers of ERROR (..), None for all
    local: bool = False
    module: object = None


@dataclass
class Module:
    name: str
    records: dict = field(default_factory=dict)
    aliases: dict = field(default_factory=dict)
    data: list = field(default_factory=list)
    routines: list = field(default_factory=list)


class Parser:
    def __init__(self, text, faults=frozenset()):
        self.tokens, self.at, self.faults = tokens(text), 0, faults

    # tokens
    def word(self, ahead=0):
        kind, value, _ = self.tokens[min(self.at + ahead, len(self.tokens) - 1)]
        return value if kind in ("name", "sign") else None

    def kind(self, ahead=0):
        return self.tokens[min(self.at + ahead, len(self.tokens) - 1)][0]

    def line(self):
        return self.tokens[self.at][2]

    def takes(self, *words):
        if self.word() in words:
            self.at += 1
            return self.tokens[self.at - 1][1]
        return None

    def needs(self, *words):
        found = self.takes(*words)
        if found is None:
            raise Refused(f"line {self.line()}: {self.tokens[self.at][1]!r} where {' or '.join(words)} belongs")
        return found

    def identifier(self):
        if self.kind() != "name" or self.word() in RESERVED:
            raise Refused(f"line {self.line()}: {self.tokens[self.at][1]!r} where a name belongs")
        self.at += 1
        return self.tokens[self.at - 1][1]

    # modules
    def modules(self):
        found = []
        while self.kind() != "end":
            found.append(self.module())
        return found

    def module(self):
        self.needs("module")
        module = Module(self.identifier())
        if self.takes("("):
            while not self.takes(")"):
                self.at += 1
        while not self.takes("endmodule"):
            local = bool(self.takes("local"))
            if not local:
                self.takes("task")
            if self.takes("record"):
                name, parts = self.identifier(), []
                while not self.takes("endrecord"):
                    type_of = self.identifier()
                    parts.append((self.identifier(), type_of))
                    self.needs(";")
                module.records[name] = parts
            elif self.takes("alias"):
                type_of = self.identifier()
                module.aliases[self.identifier()] = type_of
                self.needs(";")
            elif self.word() in ("var", "pers", "const"):
                module.data.append(self.declaration(local))
            else:
                routine = self.routine(local)
                routine.module = module
                module.routines.append(routine)
        return module

    def declaration(self, local=False):
        kind = self.needs("var", "pers", "const")
        type_of, name, dims, value = self.identifier(), self.identifier(), [], None
        if self.takes("{"):
            dims.append(self.expression())
            while self.takes(","):
                dims.append(self.expression())
            self.needs("}")
        if self.takes(":="):
            value = self.expression()
        self.needs(";")
        return Declared(kind, type_of, name, dims, value, local)

    def routine(self, local):
        kind = self.needs("proc", "func", "trap")
        routine = Routine(kind, "", local=local)
        if kind == "func":
            routine.type = self.identifier()
        routine.name = self.identifier()
        if kind != "trap":
            self.needs("(")
            routine.parameters = self.parameters()
        while self.word() in ("var", "pers", "const"):
            routine.data.append(self.declaration())
        routine.body = self.statements(*SECTIONS)
        while not self.takes("end" + kind):
            section = self.needs("backward", "error", "undo")
            handles = None
            if section == "error" and self.takes("("):
                handles = [self.expression()]
                while self.takes(","):
                    handles.append(self.expression())
                self.needs(")")
            body = self.statements(*SECTIONS)
            if section == "error":
                routine.handler, routine.handles = body, handles
        return routine

    def parameters(self):
        found = []
        while not self.takes(")"):
            self.takes(",")
            optional = bool(self.takes("\\"))
            while True:
                mode = self.takes("var", "pers", "inout") or "in"
                type_of, name, dims = self.identifier(), self.identifier(), 0
                if self.takes("{"):
                    while not self.takes("}"):
                        self.takes(",")
                        self.needs("*")
                        dims += 1
                found.append(Parameter(mode, type_of, name, dims, optional))
                if not self.takes("|"):
                    break
        return found

    # statements
    def statements(self, *ends):
        found = []
        while self.word() not in ends:
            found.append(self.statement())
        return found

    def statement(self):
        line = self.line()
        if self.takes("if"):
            return self.if_statement(line)
        if self.takes("for"):
            name = self.identifier()
            self.needs("from")
            first = self.expression()
            self.needs("to")
            last = self.expression()
            step = self.expression() if self.takes("step") else None
            self.needs("do")
            body = self.statements("endfor")
            self.needs("endfor")
            return ("for", name, first, last, step, body, line)
        if self.takes("while"):
            condition = self.expression()
            self.needs("do")
            body = self.statements("endwhile")
            self.needs("endwhile")
            return ("while", condition, body, line)
        if self.takes("test"):
            return self.test_statement(line)
        if self.kind() == "name" and self.word(1) == ":":
            name = self.identifier()
            self.needs(":")
            return ("label", name, line)
        return self.simple_statement(line)

    def simple_statement(self, line):
        if self.takes("goto"):
            found = ("goto", self.identifier(), line)
        elif self.takes("return"):
            found = ("return", None if self.word() == ";" else self.expression(), line)
        elif self.takes("raise"):
            found = ("raise", None if self.word() == ";" else self.expression(), line)
        elif self.word() in ("exit", "retry", "trynext") and self.word(1) == ";":
            found = (self.takes("exit", "retry", "trynext"), line)
        elif self.takes("%"):
            name = self.expression()
            self.needs("%")
            found = ("late", name, self.arguments(";"), line)
        else:
            target = self.path()
            if self.takes(":="):
                found = ("assign", target, self.expression(), line)
            else:
                if target[2]:
                    raise Refused(f"line {line}: neither an assignment nor a call")
                found = ("call", target[1], self.arguments(";"), line)
        self.needs(";")
        return found

    def if_statement(self, line):
        branches, otherwise = [], []
        condition = self.expression()
        if not self.takes("then"):
            if self.takes("if"):
                return ("if", [(condition, [self.if_statement(line)])], [], line)
            return ("if", [(condition, [self.simple_statement(line)])], [], line)
        while True:
            branches.append((condition, self.statements("elseif", "else", "endif")))
            if not self.takes("elseif"):
                break
            condition = self.expression()
            self.needs("then")
        if self.takes("else"):
            otherwise = self.statements("endif")
        self.needs("endif")
        return ("if", branches, otherwise, line)

    def test_statement(self, line):
        value, cases, default = self.expression(), [], []
        while self.takes("case"):
            values = [self.expression()]
            while self.takes(","):
                values.append(self.expression())
            self.needs(":")
            cases.append((values, self.statements("case", "default", "endtest")))
        if self.takes("default"):
            self.needs(":")
            default = self.statements("endtest")
        self.needs("endtest")
        return ("test", value, cases, default, line)

    def arguments(self, end):
        """Of a procedure or a function: (how, name, expression), where how is required, optional or conditional."""
        found = []
        while self.word() != end:
            self.takes(",")
            if self.takes("\\"):
                name = self.identifier()
                if self.takes("?"):
                    found.append(("conditional", name, self.identifier()))
                else:
                    found.append(("optional", name, self.expression() if self.takes(":=") else None))
            else:
                name = None
                if self.kind() == "name" and self.word(1) == ":=":
                    name = self.identifier()
                    self.needs(":=")
                found.append(("required", name, self.expression()))
        return found

    # expressions, loosest first
    def expression(self):
        # NOT stands before the first logical term and negates the whole of it: NOT a AND b is NOT (a AND b).
        left = ("not", self.logical_term()) if self.takes("not") else self.logical_term()
        if "precedence" in self.faults:  # OR as tight as AND
            while self.word() in ("or", "xor", "and"):
                left = ("binary", self.takes("or", "xor", "and"), left, ("not", self.relation()) if self.takes("not") else self.relation())
            return left
        while self.word() in ("or", "xor"):
            operator = self.takes("or", "xor")
            # The summary has NOT at the beginning alone; programs write it after OR and AND too.
            right = ("not", self.logical_term()) if self.takes("not") else self.logical_term()
            left = ("binary", operator, left, right)
        return left

    def logical_term(self):
        left = self.relation()
        if "precedence" in self.faults:
            return left
        while self.takes("and"):
            right = ("not", self.relation()) if self.takes("not") else self.relation()
            left = ("binary", "and", left, right)
        return left

    def relation(self):
        left = self.simple_expression()
        if self.word() in RELATIONS:
            operator = self.takes(*RELATIONS)
            return ("binary", operator, left, self.simple_expression())
        return left

    def simple_expression(self):
        sign = self.takes("+", "-")
        left = self.term()
        if sign == "-":
            left = ("minus", left)
        while self.word() in ("+", "-"):
            operator = self.takes("+", "-")
            left = ("binary", operator, left, self.term())
        return left

    def term(self):
        left = self.primary()
        operators = ("*", "/", "div", "mod")
        while self.word() in operators:
            operator = self.takes(*operators)
            left = ("binary", operator, left, self.primary())
        return left

    def primary(self):
        kind, value, line = self.tokens[self.at]
        if kind == "number" or kind == "string":
            self.at += 1
            return (kind, value)
        if self.takes("("):
            inner = self.expression()
            self.needs(")")
            return inner
        if self.takes("["):
            parts = [self.expression()]
            while self.takes(","):
                parts.append(self.expression())
            self.needs("]")
            return ("aggregate", parts)
        if self.takes("-", "+") == "-":  # a sign after another operator, which the summary does not have but programs do
            return ("minus", self.primary())
        if value in ("true", "false") and kind == "name":
            self.at += 1
            return ("bool", value == "true")
        if kind == "name" and self.word(1) == "(":
            self.at += 2
            found = ("function", value, self.arguments(")"))
            self.needs(")")
            return found
        if kind == "name":
            return self.path()
        raise Refused(f"line {line}: {value!r} where a value belongs")

    def path(self):
        """Data, an element or a component: ("path", name, steps)."""
        name, steps = self.identifier(), []
        while True:
            if self.takes("{"):
                index = [self.expression()]
                while self.takes(","):
                    index.append(self.expression())
                self.needs("}")
                steps.append(("element", index))
            elif self.takes("."):
                steps.append(("component", self.identifier()))
            else:
                return ("path", name, steps)

"""Programs from a seed: valid, ending, with motions whose targets hang on what was calculated before.

Numbers are kept small by Fold, which takes whole multiples of a width away; every step of it is exact or rounded in one way alone, so that
two interpreters that round each operation to single precision agree to the last bit. What is not certain from ABB's manuals is not written:
remainders of negative numbers, halves to be rounded, the bounds of a FOR that its step leads away from, errors without a handler, and
whether the right side of AND and OR is evaluated where the left one has decided: a condition calls nothing that changes data.
"""

import random

from routines import HELPERS, LIBRARY, TURNS


class Program:
    def __init__(self, seed):
        self.random = random.Random(seed)
        self.counters, self.labels, self.loops = 0, 0, []
        self.condition = False  # whether a condition is being written

    def one(self, *choices):
        return self.random.choice(choices)

    def chance(self, share):
        return self.random.random() < share

    def whole(self, low=1, high=9):
        return str(self.random.randint(low, high))

    def literal(self):
        how = self.random.random()
        if how < 0.4:
            return self.whole(1, 30)
        if how < 0.9:
            return f"{self.random.uniform(0.06, 25):.{self.random.randint(1, 5)}f}"
        return self.one("1.5E1", "2E-1", "0x1F", ".75", "3.", "0b101")

    def fields(self):
        errors = self.random.sample(range(1, 90), 3)
        found = {f"c{i}": self.literal() for i in range(1, 7)}
        found |= {f"i{i}": self.whole(2, 9) for i in range(1, 4)}
        found |= {f"e{i}": errors[i - 1] for i in range(1, 4)}
        return found | {"width": self.one("60", "47.3", "55", "51.7"), "q": self.one("a", "b", "12", "3.5"), "dims": ""}

    # expressions
    def index(self, size):
        if self.loops and self.chance(0.2):
            return f"1+Trunc(Abs({self.loops[-1]})) MOD {size}"
        return f"1+Trunc(Abs({self.variable()})) MOD {size}" if self.chance(0.4) else self.whole(1, size)

    def variable(self):
        if self.loops and self.chance(0.3):
            return self.one(*self.loops)
        return self.one("a", "b", "c", "d", "keep")

    def element(self):
        return self.one(
            lambda: f"tab{{{self.index(4)}}}",
            lambda: f"grid{{{self.index(2)},{self.index(3)}}}",
            lambda: f"cube{{{self.index(2)},{self.whole(1, 2)},{self.index(2)}}}",
            lambda: f"piece.{self.one('wide', 'at.x', 'at.y', 'at.z')}",
            lambda: f"pieces{{{self.index(2)}}}.{self.one('wide', 'at.y')}",
            lambda: f"{self.one('p1', 'p2')}.{self.one('x', 'y', 'z')}",
        )()

    def number(self, depth=2):
        if depth <= 0 or self.chance(0.15):
            return self.one(self.literal, self.variable, self.variable, self.element)()
        return self.one(
            lambda: f"{self.number(depth - 1)}{self.one('+', '-', '*')}{self.number(depth - 1)}",
            lambda: f"{self.number(depth - 1)} + {self.number(depth - 1)}*{self.number(depth - 1)}",
            lambda: f"{self.number(depth - 1)}-{self.number(depth - 1)}-{self.number(depth - 1)}",
            lambda: f"({self.number(depth - 1)})*({self.number(depth - 1)})",
            lambda: f"({self.number(depth - 1)})/{self.literal()}",
            lambda: f"({self.positive(depth - 1)} {self.one('DIV', 'MOD')} {self.whole(2, 7)})",
            lambda: f"{self.literal()}+{self.positive(depth - 1)} MOD {self.whole(3, 9)}*{self.whole(2, 4)} DIV {self.whole(2, 3)}",
            lambda: f"(-{self.variable()}*{self.literal()}+{self.number(depth - 1)})",
            lambda: self.called(depth),
            lambda: self.called(depth),
        )()

    def positive(self, depth):
        return self.one(lambda: f"Trunc(Abs({self.number(depth)}))", lambda: self.whole(5, 99), lambda: "StrLen(s)")()

    def called(self, depth):
        inner = self.number(depth - 1)
        return self.one(
            lambda: f"Abs({inner})",
            lambda: f"Trunc({inner})",
            lambda: f"Round({inner}+0.123)",
            lambda: f"Sqrt(Abs({inner}))",
            lambda: f"Fold({inner})",
            lambda: f"{self.one('Sin', 'Cos')}({self.variable()})*{self.literal()}",
            lambda: f"ATan2({self.literal()},{self.variable()}+200)",
            lambda: f"Turn({inner}{self.one('', f'{chr(92)}by:={self.literal()}')}{self.one('', chr(92) + 'twice', chr(92) + 'thrice')})",
            lambda: f"Through({inner}{self.one('', f'{chr(92)}by:=1.5')}{self.one('', chr(92) + 'twice')})",
            lambda: f"Deep({self.whole(1, 6)})",
            lambda: f"Safe({inner},{self.one('0', self.literal(), 'a-a')})",
            lambda: "Total(tab)",
            lambda: f"Cells(grid,{self.variable()})",
            lambda: f"Foreign({self.variable()})" if self.library and not self.condition else f"Deep({self.whole(1, 4)})",
            lambda: f"Twist({inner})" if self.library else "Dim(grid,2)",
            lambda: f"Dim({self.one('tab,1', 'grid,1', 'grid,2', 'cube,3')})",
            lambda: "StrLen(s)",
            lambda: f'StrFind(s,1,"{self.one("b", "xc", "3T")}")',
            lambda: f'StrMatch("abcabc",{self.whole(1, 3)},"{self.one("c", "ca", "x")}")',
            lambda: f"VectMagn({self.one('p1', 'p2')})/10",
            lambda: "Distance(p1,p2)/10",
        )()

    def truth(self, depth=2):
        before, self.condition = self.condition, True
        found = self.bool(depth)
        self.condition = before
        return found

    def bool(self, depth):
        relation = self.one("<", "<=", ">", ">=", "=", "<>")
        simple = self.one(
            lambda: f"{self.number(1)}{relation}{self.number(1)}",
            lambda: f"{self.number(1)}{relation}{self.number(0)}",
            lambda: self.one("f", "g", "piece.used", "TRUE"),
            lambda: f"s{self.one('=', '<>')}{self.text()}",
            lambda: f"p1{self.one('=', '<>')}p2",
        )
        if depth <= 0:
            return simple()
        return self.one(
            simple,
            lambda: f"{self.truth(0)} {self.one('AND', 'OR', 'XOR')} {self.truth(0)}",
            lambda: f"{self.truth(0)} {self.one('OR', 'XOR')} {self.truth(0)} AND {self.truth(0)}",
            lambda: f"{self.truth(0)} AND {self.truth(0)} {self.one('OR', 'XOR')} {self.truth(0)}",
            lambda: f"NOT {self.truth(0)} {self.one('OR', 'XOR')} {self.truth(0)}",
            lambda: f"NOT {self.truth(0)} AND {self.truth(0)}",
            lambda: f"{self.truth(0)} OR NOT {self.truth(0)} AND {self.truth(0)}",
            lambda: f"({self.truth(depth - 1)}) AND (NOT {self.truth(0)})",
            lambda: f"NOT ({self.truth(depth - 1)})",
        )()

    def text(self):
        return self.one(
            lambda: f'"{self.one("a", "abc", "3", "b b", "x")}"',
            lambda: f"NumToStr({self.positive(1)},0)",
            lambda: f'StrPart("abcdefg",{self.index(5)},{self.whole(1, 3)})',
            lambda: f"ValToStr({self.one('f', 'g')})",
            lambda: f'"b"+NumToStr({self.whole(1, 3)},0)',
            lambda: f'StrMap("abcab","{self.one("ab", "bc")}","xy")',
        )()

    def place(self, depth=1):
        """Of type pos, some hundreds of millimetres long at most."""
        if depth <= 0:
            return self.one("p1", "p2", "piece.at", "corner")
        inner, other = self.place(depth - 1), self.place(depth - 1)
        return self.one(
            inner,
            f"{inner}+{other}",
            f"{inner}-{other}",
            f"{inner}+{other}*{self.one('0.5', '2', '1.25')}",
            f"{self.one('0.25', '1.5', 'Sin(a)')}*({inner})",
            f"({inner})*({other})*0.01",
            f"PoseVect(frame,{inner})",
            f"Bent({inner},{self.variable()}{self.one('', chr(92) + 'back')})",
            f"PoseVect(frame,[{self.whole(-20, 20)},{self.literal()},-{self.literal()}])",
        )

    # statements
    def block(self, depth, moves, least=1, most=4):
        lines = []
        for _ in range(self.random.randint(least, most)):
            lines += self.statement(depth, moves)
        return lines

    def indented(self, lines):
        return ["  " + line for line in lines]

    def assigned(self):
        target = self.one(self.variable, self.element)()
        while target in self.loops:
            target = self.variable()
        return [f"{target}:=Fold({self.number(3)});"]

    def statement(self, depth, moves):
        simple = [
            self.assigned,
            self.assigned,
            self.assigned,
            lambda: [f"{self.one('f', 'g', 'piece.used')}:={self.truth()};"],
            lambda: [f"s:={self.text()};"],
            lambda: [f"{self.one('p1', 'p2', 'piece.at')}:={self.place()};", "p1:=[Fold(p1.x),Fold(p1.y),Fold(p1.z)];"]
            + ["p2:=[Fold(p2.x),Fold(p2.y),Fold(p2.z)];", "piece.at:=[Fold(piece.at.x),Fold(piece.at.y),Fold(piece.at.z)];"],
            lambda: [f"{self.one('Incr', 'Decr')} {self.one('a', 'tab{2}', 'keep')};"],
            lambda: [f"Add {self.one('b', 'grid{1,2}', 'piece.wide')},{self.literal()};"],
            lambda: [self.one("Clear d;", "Clear tab{1};")],
            lambda: [f"Shift tab,{self.one('a', 'b', 'd')};"],
            lambda: [f"Walk {self.positive(1)},tab;"],
            lambda: [f"Swap {self.one('a', 'tab{3}', 'p1.x')},{self.one('b', 'grid{2,1}', 'piece.wide')};"],
            lambda: [f"Mark keep,{self.number(1)};", "keep:=Fold(keep);"],
            lambda: [f"Risky2 {self.one('a', 'tab{1}')};"],
            lambda: [f"Guarded {self.one('b', 'c', 'tab{4}')},tries;"],
            lambda: [f'%"late"+NumToStr({self.index(3)},0)%;'],
            lambda: [f'CallByVar "late",{self.index(3)};'],
            lambda: [f"IF {self.truth()} {self.assigned()[0]}"],
            lambda: [f"pieces{{{self.index(2)}}}:=piece;"],
            lambda: [f"tab:=[{self.literal()},Fold({self.variable()}),-{self.whole()},{self.element()}];"],
        ]
        nested = [self.if_block, self.for_block, self.while_block, self.test_block, self.label_block]
        if moves and self.chance(0.2):
            return self.motion()
        if depth > 0 and self.chance(0.45):
            return self.one(*nested)(depth - 1, moves)
        return self.one(*simple)()

    def if_block(self, depth, moves):
        lines = [f"IF {self.truth()} THEN"] + self.indented(self.block(depth, moves))
        for _ in range(self.random.randint(0, 2)):
            lines += [f"ELSEIF {self.truth()} THEN"] + self.indented(self.block(depth, moves))
        if self.chance(0.6):
            lines += ["ELSE"] + self.indented(self.block(depth, moves))
        return lines + ["ENDIF"]

    def for_block(self, depth, moves):
        name = self.one("i", "j", "n", "a")
        if name in self.loops:
            name = f"i{len(self.loops)}"
        bounds = self.one(
            f"1 TO {self.whole(1, 5)}",
            f"{self.whole(3, 5)} TO {self.whole(1, 3)}",
            f"1 TO {self.whole(3, 9)} STEP {self.one('2', '3', '2.5')}",
            f"{self.whole(5, 9)} TO 1 STEP -{self.one('2', '3', '1.5')}",
            "0 TO 1 STEP 0.25",
            f"1 TO 1+{self.positive(0)} MOD 4",
            "-2 TO 1",
        )
        self.loops.append(name)
        body = self.block(depth, moves and depth > 0)
        self.loops.pop()
        # A loop variable may hide data of the routine or the module; it is not assigned.
        body = [line for line in body if not (name == "a" and writes_a(line))] or [f"tab{{1}}:=Fold(tab{{1}}+{name});"]
        return [f"FOR {name} FROM {bounds} DO"] + self.indented(body) + ["ENDFOR"]

    def while_block(self, depth, moves):
        self.counters += 1
        name = f"k{self.counters}"
        condition = self.one(f"{name}<{self.whole(2, 5)}", f"{name}<4 AND {self.truth(0)}", f"({self.truth(1)}) AND {name}<3")
        body = self.block(depth, False)
        return [f"{name}:=0;", f"WHILE {condition} DO", f"  Incr {name};"] + self.indented(body) + ["ENDWHILE"]

    def test_block(self, depth, moves):
        if self.chance(0.75):
            subject, values = f"{self.positive(1)} MOD 5", self.random.sample(["0", "1", "2", "3", "4", "7"], 5)
        else:
            subject, values = "s", self.random.sample(['"a"', '"abc"', '"3"', '"b1"', '"b2"', '"TRUE"'], 5)
        lines = [f"TEST {subject}", f"CASE {values[0]}:"] + self.indented(self.block(depth, moves))
        lines += [f"CASE {values[1]},{values[2]}:"] + self.indented(self.block(depth, moves))
        if self.chance(0.5):
            lines += [f"CASE {values[3]}:"] + self.indented(self.block(depth, moves))
        if self.chance(0.7):
            lines += ["DEFAULT:"] + self.indented(self.block(depth, moves))
        return lines + ["ENDTEST"]

    def label_block(self, depth, moves):
        self.labels += 1
        label = f"on{self.labels}"
        if self.chance(0.5):
            skipped = self.block(depth, False, 1, 2)
            return [f"IF {self.truth(1)} GOTO {label};"] + skipped + [f"{label}:", self.assigned()[0]]
        self.counters += 1
        name = f"k{self.counters}"
        body = self.block(depth, False, 1, 2)
        return [f"{name}:=0;", f"{label}:", f"{name}:={name}+1;"] + body + [f"IF {name}<{self.whole(2, 4)} GOTO {label};"]

    def motion(self):
        speed = self.one("v100", "v200", "[150,500,5000,1000]", "fast")
        zone = self.one("fine", "z1", "z10", "fine")
        tool = self.one("tool0", "tGrip")
        wobj = self.one("", "\\WObj:=wobj0", "\\WObj:=wTable")
        x, y, z = (f"Fold({self.number(1)})" for _ in range(3))
        before = []
        if self.chance(0.12):
            self.joints(before)
            return before
        if self.chance(0.25):
            before.append(self.one(f"wTable.oframe.trans.x:={x}/3;", f"tGrip.tframe.trans.z:=Abs({y})/3;", f"wTable.uframe.rot:=OrientZYX({z}/20,0,0);"))
        target = self.one(
            f"Offs(base,{x},{y},{z})",
            f"Offs(spots{{{self.index(3)}}},{x},0,{z})",
            f"RelTool(base,{x}/2,{y},0\\Rx:=Fold({self.variable()})/8)",
            f"RelTool(Offs(base,0,{y},{z}),{x}/3,0,5\\Ry:={self.variable()}/9\\Rz:=d/6)",
            "here",
            "named",
            "placed",
            "near(p1)",
        )
        if target == "here":
            before += ["here:=base;", f"here.trans.y:=here.trans.y+{y};", f"corner:=[{x},0,{z}];", "here.trans:=here.trans+corner;"]
            before += [f"here.rot:=here.rot*OrientZYX(Fold({self.variable()})/7,b/9,{self.literal()});"]
        elif target == "placed":
            before += [f"frame:=[[{x},{y},{z}],OrientZYX({self.variable()}/6,0,Fold(c)/9)];", "here:=base;"]
            before += [f"moved:={self.one('PoseMult(frame,[p2,[1,0,0,0]])', 'PoseInv(frame)', 'frame')};"]
            before += ["here.trans:=here.trans+0.4*moved.trans;", "here.rot:=base.rot*moved.rot;"]
            before += [f"here.trans.z:=here.trans.z+EulerZYX({self.one(chr(92) + 'X', chr(92) + 'Y', chr(92) + 'Z')},frame.rot);"]
            target = "here"
        elif target == "named":
            before += [f"spots{{{self.index(3)}}}:=Offs(base,{x},{y},{z});"]
            target = f"spots{{{self.index(3)}}}"
        if self.chance(0.08):
            return before + [f"MoveC Offs(base,{x},40,0),Offs(base,0,{y}+90,{z}),{speed},{zone},{tool}{wobj};"]
        return before + [f"{self.one('MoveL', 'MoveL', 'MoveJ')} {target},{speed},{zone},{tool}{wobj};"]

    def joints(self, lines):
        lines.append("rest:=[[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];")
        for axis in range(1, 7):
            if self.chance(0.6):
                lines.append(f"rest.robax.rax_{axis}:=rest.robax.rax_{axis}+Fold({self.number(1)})/4;")
        lines.append("MoveAbsJ rest,v200,z10,tool0;")

    def modules(self):
        """The texts of the program's modules, main's first."""
        self.library = self.chance(0.5)
        fields = self.fields()
        body = self.block(2, True, 5, 9)
        for _ in range(3):
            body += self.assigned() + self.motion()
        for line in ["a:=Fold(a+Total(tab)+grid{1,1}+keep+tries);", "MoveL Offs(base,a,Fold(b+d+piece.wide),Fold(c)),v100,fine,tool0;"]:
            body.append(line)
        counters = [f"VAR num k{i};" for i in range(1, self.counters + 1)]
        x, y, z = self.whole(520, 560), self.whole(60, 140), self.whole(380, 430)
        rest = "[0,0,0,1],[9E9,9E9,9E9,9E9,9E9,9E9]]"
        down = "[0.70710678,0,0.70710678,0]"
        data = [
            "RECORD part",
            "  num wide;",
            "  pos at;",
            "  bool used;",
            "ENDRECORD",
            "ALIAS num level;",
            f"CONST robtarget base:=[[{x},{y},{z}],{down},{rest};",
            f"VAR robtarget spots{{3}}:=[base,[[{x},0,{z}],{down},{rest},[[500,{y},400],{down},{rest}];",
            "VAR robtarget here;",
            "VAR jointtarget rest;",
            f"PERS tooldata tGrip:=[TRUE,[[{self.whole(0, 9)},0,{self.literal()}],[1,0,0,0]],[1,[0,0,1],[1,0,0,0],0,0,0]];",
            f'PERS wobjdata wTable:=[FALSE,TRUE,"",[[{self.whole(-20, 20)},{self.literal()},0],[1,0,0,0]],[[0,0,-{self.whole()}],[1,0,0,0]]];',
            "VAR speeddata fast:=[300,500,5000,1000];",
            f"PERS num keep:={self.literal()};",
            f"VAR num a:={self.literal()};",
            f"VAR level b:={self.literal()};",
            f"VAR num c:=-{self.literal()};",
            "VAR num d;",
            "VAR num tries;",
            f"VAR num tab{{4}}:=[{self.literal()},{self.literal()},-{self.literal()},{self.literal()}];",
            f"VAR num grid{{2,3}}:=[[{self.literal()},2,3],[4,-{self.literal()},6]];",
            f"VAR num cube{{2,2,2}}:=[[[1,{self.literal()}],[3,4]],[[5,6],[{self.literal()},8]]];",
            f"VAR part piece:=[{self.literal()},[1,{self.literal()},3],FALSE];",
            "VAR part pieces{2};",
            f"VAR pos p1:=[{self.literal()},2,-{self.literal()}];",
            "VAR pos p2:=[4,5,6];",
            "VAR pos corner:=[7,-8,9.5];",
            "VAR pose frame:=[[1,2,3],[1,0,0,0]];",
            "VAR pose moved;",
            f"VAR bool f:={self.one('TRUE', 'FALSE')};",
            "VAR bool g;",
            'VAR string s:="abc";',
        ]
        twist = [
            "LOCAL FUNC num Twist(num x)",
            f"  RETURN Fold(x*{self.literal()}+{self.literal()});",
            "ENDFUNC",
        ]
        more = [
            "FUNC robtarget near(pos p)",
            "  VAR robtarget t;",
            "  t:=base;",
            "  t.trans:=t.trans+p;",
            "  RETURN t;",
            "ENDFUNC",
            "",
            "PROC Risky2(INOUT num r)",
            "  VAR num got;",
            "  got:=r;",
            f"  Risky got,{self.one('2', '15', 'r')};",
            "  r:=got;",
            "ERROR",
            "  got:=got/2;",
            "  TRYNEXT;",
            "ENDPROC",
        ]
        head = ["MODULE Program"] + self.indented(data) + self.indented(twist if self.library else [])
        main = ["", "  PROC main()"] + self.indented(self.indented(counters + body)) + ["  ENDPROC", ""]
        text = "\n".join(head + main + self.indented(more)) + HELPERS.format(**fields) + TURNS.format(**fields) + "ENDMODULE\n"
        return [text] + ([LIBRARY.format(**self.fields())] if self.library else [])


def writes_a(line):
    """Whether a statement writes a, or calls what binds it."""
    words = line.replace(";", " ").replace(",", " ").split()
    return line.startswith("a:=") or " a:=" in line or (words[0] in ("Incr", "Decr", "Add", "Shift", "Swap", "Walk", "Guarded", "Risky2") and "a" in words)


def program(seed):
    return Program(seed).modules()

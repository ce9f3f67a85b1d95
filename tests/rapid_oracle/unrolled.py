"""Motions as a module that calculates nothing: one routine, literal targets, tools and work objects declared with the values they had."""

from data import SPEEDS, ZONES
from values import written

SPELLED = {"movel": "MoveL", "movej": "MoveJ", "moveabsj": "MoveAbsJ", "movec": "MoveC"}
KNOWN = {f"v{speed}" for speed in SPEEDS} | set(ZONES)


def unrolled(motions, entry="main"):
    declared, lines = {}, []

    def datum(kind, prefix, name, value):
        if name in ("tool0", "wobj0"):
            return name
        text = f"PERS {kind} {{}}:={written(value)};"
        return declared.setdefault(text, f"{prefix}{len(declared) + 1}")

    for name, targets, (speed, zone, tool), wobj in motions:
        fields = [written(target) for target in targets]
        fields += [label if label in KNOWN else written(value) for label, value in (speed, zone)]
        line = f"    {SPELLED[name]} {','.join(fields)},{datum('tooldata', 'uTool', *tool)}"
        if wobj:
            line += "\\WObj:=" + datum("wobjdata", "uObj", *wobj)
        lines.append(line + ";")
    data = ["  " + text.format(name) for text, name in declared.items()]
    return "\n".join(["MODULE Unrolled", *data, f"  PROC {entry}()", *lines, "  ENDPROC", "ENDMODULE", ""])

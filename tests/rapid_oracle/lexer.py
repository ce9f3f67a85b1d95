"""Text to tokens. Names are compared without regard to case, so they are kept in lower case."""

import re

TOKEN = re.compile(
    r"""(?P<blank>\s+|!.*)
    |(?P<number>0[xX][0-9a-fA-F]+|0[oO][0-7]+|0[bB][01]+|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)
    |(?P<name>[^\W\d_]\w*)
    |(?P<string>"(?:[^"]|"")*")
    |(?P<sign>:=|<=|>=|<>|[-+*/<>=(){}\[\],;:.\\?%|])""",
    re.VERBOSE,
)
RESERVED = set(
    """alias and backward case connect const default div do else elseif endfor endfunc endif endmodule endproc endrecord endtest endtrap
    endwhile error exit false for from func goto if inout local mod module nostepin not noview or pers proc raise readonly record retry
    return step sysmodule test then to trap true trynext undo var viewonly while with xor""".split()
)
ESCAPE = re.compile(r'\\\\|\\[0-9A-Fa-f]{2}|""')


class Refused(Exception):
    """The text is no RAPID, or RAPID that this interpreter does not know."""


def number(text):
    if text[:2].lower() in ("0x", "0o", "0b"):
        return float(int(text, 0))
    return float(text)


def string(text):
    def meant(found):
        code = found.group()
        return '"' if code == '""' else "\\" if code == "\\\\" else chr(int(code[1:], 16))

    return ESCAPE.sub(meant, text[1:-1])


def tokens(text):
    """A list of (kind, value, line), ended by ("end", "", line)."""
    found, at, line = [], 0, 1
    header = re.match(r"\s*%%%.*?%%%", text, re.DOTALL)
    if header:
        at, line = header.end(), 1 + header.group().count("\n")
    while at < len(text):
        match = TOKEN.match(text, at)
        if not match:
            raise Refused(f"line {line}: {text[at : at + 20]!r}")
        kind, word = match.lastgroup, match.group()
        if kind == "name":
            found.append((kind, word.lower(), line))
        elif kind == "number":
            found.append((kind, number(word), line))
        elif kind == "string":
            found.append((kind, string(word), line))
        elif kind == "sign":
            found.append((kind, word, line))
        line += word.count("\n")
        at = match.end()
    found.append(("end", "", line))
    return found

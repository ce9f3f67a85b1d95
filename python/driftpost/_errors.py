"""The one exception of the package."""

from __future__ import annotations

from typing import NamedTuple


class Message(NamedTuple):
    """What driftpost says; codes stand in docs/MESSAGES.md."""

    code: str
    severity: str  # "note", "warning" or "error"
    text: str
    help: str | None
    file: str | None
    line: int | None  # from 1


class DriftpostError(ValueError):
    """Why there is no result.

    ``code`` is stable (``input::no-module``), ``file`` and ``line`` (from 1) say where, ``help`` what to do next; ``messages`` holds all
    that was said, warnings included.
    """

    def __init__(self, text: str, code: str = "run::failed", help: str | None = None, file: str | None = None,
                 line: int | None = None, messages: tuple[Message, ...] = ()):
        place = "" if file is None else f" ({file}:{line})"
        super().__init__(f"[{code}] {text}{place}")
        self.text, self.code, self.help, self.file, self.line = text, code, help, file, line
        self.messages = messages or (Message(code, "error", text, help, file, line),)

    def __reduce__(self):
        return type(self), (self.text, self.code, self.help, self.file, self.line, self.messages)

    @classmethod
    def _of(cls, messages: list[tuple]) -> "DriftpostError":
        everything = tuple(Message(*message) for message in messages)
        told = next((message for message in everything if message.severity == "error"), everything[0])
        return cls(told.text, told.code, told.help, told.file, told.line, everything)

"""Programs and tables as a caller gives them: paths, text, objects; what no file can hold is refused."""

from __future__ import annotations

import os
import re
import tempfile
from pathlib import Path

from . import _driftpost
from ._errors import DriftpostError, Message


def plain(name: str, text: str) -> str:
    """Text that a file and a command line can hold; ``name`` says in a refusal what it is."""
    try:
        text.encode("utf-8", "surrogateescape")
    except UnicodeEncodeError as error:
        raise DriftpostError(f"{name} holds half of a surrogate pair at character {error.start}: no file can", "option::usage") from None
    return text


def path_of(name: str, given) -> str:
    """A path as text; ``name`` says in a refusal whose it is."""
    if not isinstance(given, (str, os.PathLike)):
        raise DriftpostError(f"{name} is {type(given).__name__}, not a path", "option::usage")
    path = plain(name, os.fsdecode(given))
    if "\0" in path:
        raise DriftpostError(f"{name} {path!r} holds a zero character: no path can", "option::usage")
    return path


class Folder(tempfile.TemporaryDirectory):
    """A folder for what the command line reads and writes as files."""

    def __enter__(self) -> Folder:
        super().__enter__()
        return self

    def path(self, name: str) -> Path:
        return Path(self.name) / name

    def as_given(self, said):
        """The same with names as the caller gave them, in place of the files here: a text, or all texts of what JSON holds."""
        if isinstance(said, str):
            return re.sub(re.escape(self.name) + r"[/\\](?:[^/\\\s]+\.d[/\\])?", "", said)
        if isinstance(said, list):
            return [self.as_given(one) for one in said]
        if isinstance(said, dict):
            return {name: self.as_given(one) for name, one in said.items()}
        return said

    def error(self, error: DriftpostError) -> DriftpostError:
        """The same with names as the caller gave them."""
        return DriftpostError._of([Message(*map(self.as_given, one)) for one in error.messages])

    def table(self, given, name: str) -> str:
        """The path of a table: a path, CSV text, or whatever has ``__arrow_c_stream__``."""
        if hasattr(given, "__arrow_c_stream__"):
            text = _csv_of(given, name)
        elif isinstance(given, bytes):
            text = given.decode("utf-8", "surrogateescape")
        elif isinstance(given, str) and "\n" in given:
            text = given
        elif isinstance(given, (str, os.PathLike)):
            return path_of(name, given)
        else:
            raise DriftpostError(
                f"{name}: a table is a path, CSV text or an object with __arrow_c_stream__ (pandas, polars, pyarrow, DuckDB), not {type(given).__name__}",
                "option::usage")
        path = self.path(name)
        path.write_bytes(plain(name, text).encode("utf-8", "surrogateescape"))
        return str(path)

    def program(self, given, name: str) -> list[str]:
        """The paths of a program's files: those given, or text written to files."""
        if is_text(given):
            given = {name: given}
        if isinstance(given, dict):
            paths = []
            for place, text in texts_of(given):
                path = self.path(os.path.join(name + ".d", place))
                if not path.resolve().is_relative_to(Path(self.name).resolve()):
                    raise DriftpostError(f"{place} leads out of the program's folder", "input::unreadable")
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(text)
                paths.append(str(path))
            return paths
        return paths_of(given)


def is_text(given) -> bool:
    """Whether a program is given as its text: what has several lines is no path."""
    return isinstance(given, bytes) or (isinstance(given, str) and "\n" in given)


def texts_of(given: dict) -> list[tuple[str, bytes]]:
    """Names and bytes of a program's modules."""
    if not given:
        raise DriftpostError("the program has no modules", "input::no-modules")
    return [(place, _bytes_of(place, text)) for place, text in ((path_of("the name of a module", place), text) for place, text in given.items())]


def _bytes_of(place: str, text) -> bytes:
    if isinstance(text, bytes):
        return text
    if isinstance(text, str):
        return plain(place, text).encode("utf-8", "surrogateescape")
    raise DriftpostError(f"{place}: the text of a module is str or bytes, not {type(text).__name__}", "option::usage")


def paths_of(given) -> list[str]:
    """One path or several."""
    if isinstance(given, (str, os.PathLike)):
        return [path_of("the program", given)]
    if isinstance(given, list) and not given:
        raise DriftpostError("the program has no modules", "input::no-modules")
    if isinstance(given, (list, tuple)) and all(isinstance(path, (str, os.PathLike)) for path in given):
        return [path_of("the program", path) for path in given]
    raise DriftpostError(f"a program is a path, several, its text or a dict of texts, not {type(given).__name__}", "option::usage")


def _csv_of(table, name: str) -> str:
    try:
        return _driftpost.csv_of(table)
    except DriftpostError:
        raise
    except Exception as error:  # whatever another library's stream raises
        raise DriftpostError(f"{name}: its __arrow_c_stream__ gives no table: {error}", "table::type") from error

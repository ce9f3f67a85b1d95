"""What a caller gives, as the library takes it: paths, text, tables, options."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path

from . import _driftpost
from ._errors import DriftpostError
from ._robot import Robot

# Where results go is the caller's to say in Python, not an option's.
NOT_OPTIONS = {"all", "csv", "diff", "force", "help", "in_place", "joints_csv", "json", "output", "report", "settings",
               "show_settings", "quiet", "watch"}


class Folder(tempfile.TemporaryDirectory):
    """A folder for what the command line reads and writes as files."""

    def __enter__(self) -> Folder:
        super().__enter__()
        return self

    def path(self, name: str) -> Path:
        return Path(self.name) / name

    def table(self, given, name: str) -> str:
        """The path of a table: a path, CSV text, or whatever has ``__arrow_c_stream__``."""
        if hasattr(given, "__arrow_c_stream__"):
            text = _driftpost.csv_of(given)
        elif isinstance(given, bytes):
            text = given.decode("utf-8", "surrogateescape")
        elif isinstance(given, str) and "\n" in given:
            text = given
        elif isinstance(given, (str, os.PathLike)):
            return os.fspath(given)
        else:
            raise DriftpostError(
                f"a table is a path, CSV text or an object with __arrow_c_stream__ (pandas, polars, pyarrow, DuckDB), not {type(given).__name__}",
                "option::usage")
        path = self.path(name)
        path.write_bytes(text.encode("utf-8", "surrogateescape"))
        return str(path)

    def program(self, given, name: str) -> list[str]:
        """The paths of a program's files: those given, or text written to files."""
        if is_text(given):
            given = {name: given}
        if isinstance(given, dict):
            paths = []
            for place, text in given.items():
                path = self.path(os.path.join(name + ".d", place))
                if not path.resolve().is_relative_to(Path(self.name).resolve()):
                    raise DriftpostError(f"{place} leads out of the program's folder", "input::unreadable")
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(as_bytes(text))
                paths.append(str(path))
            return paths
        return paths_of(given)


def is_text(given) -> bool:
    """Whether a program is given as its text: what has several lines is no path."""
    return isinstance(given, bytes) or (isinstance(given, str) and "\n" in given)


def as_bytes(text) -> bytes:
    if isinstance(text, bytes):
        return text
    if isinstance(text, str):
        return text.encode("utf-8", "surrogateescape")
    raise DriftpostError(f"the text of a module is str or bytes, not {type(text).__name__}", "option::usage")


def paths_of(given) -> list[str]:
    """One path or several."""
    if isinstance(given, (str, os.PathLike)):
        return [os.fspath(given)]
    if given == []:
        raise DriftpostError("the program has no modules", "input::no-modules")
    if isinstance(given, (list, tuple)) and all(isinstance(path, (str, os.PathLike)) for path in given):
        return [os.fspath(path) for path in given]
    raise DriftpostError(f"a program is a path, several, its text or a dict of texts, not {type(given).__name__}", "option::usage")


def words(options: dict) -> list[str]:
    """Options as on the command line: ``tolerance_mm=0.02`` is ``--tolerance-mm=0.02``, a list repeats its option."""
    found = []
    for name, value in options.items():
        if name in NOT_OPTIONS or name.endswith("_out"):
            raise DriftpostError(f"{name} is no option here: what is made is in the result", "option::usage")
        option = "--" + name.replace("_", "-")
        for one in value if isinstance(value, list) else [value]:
            if isinstance(one, Robot):
                one = one._core.source
            if isinstance(one, tuple):
                one = ",".join(map(repr, one))
            if isinstance(one, bool):
                found += [option] if one else []
            elif one is not None:
                if not isinstance(one, (str, int, float, os.PathLike)):
                    raise DriftpostError(f"{name} is {type(one).__name__}, not a number, a text or a path", "option::usage")
                found.append(f"{option}={os.fspath(one) if isinstance(one, os.PathLike) else one}")
    return found

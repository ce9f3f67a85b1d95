"""Options as the command line takes them."""

from __future__ import annotations

import os

from ._errors import DriftpostError
from ._files import path_of
from ._robot import Robot

# Where results go is the caller's to say in Python, not an option's.
NOT_OPTIONS = {"all", "csv", "diff", "force", "help", "in_place", "joints_csv", "json", "output", "report", "settings",
               "show_settings", "quiet", "watch"}


def words(options: dict) -> list[str]:
    """Options as on the command line: ``tolerance_mm=0.02`` is ``--tolerance-mm=0.02``, a list repeats its option."""
    found = []
    for name, value in options.items():
        if name in NOT_OPTIONS or name.endswith("_out"):
            raise DriftpostError(f"{name} is no option here: what is made is in the result", "option::usage")
        option = "--" + name.replace("_", "-")
        # Joints and places are one value each, whatever holds them; only of texts a list is several.
        is_several = isinstance(value, list) and not all(isinstance(_plain(part), (int, float)) for part in value)
        for one in value if is_several else [value]:
            if isinstance(one, Robot):
                one = one._core.current_source()
            one = _plain(one)
            if isinstance(one, (tuple, list)):
                one = ",".join(str(_plain(part)) for part in one)
            if isinstance(one, bool):
                found += [option] if one else []
            elif one is not None:
                if not isinstance(one, (str, int, float, os.PathLike)):
                    raise DriftpostError(f"{name} is {type(one).__name__}, not a number, a text or a path", "option::usage")
                found.append(f"{option}={path_of(name, one) if isinstance(one, (str, os.PathLike)) else one}")
    return found


def _plain(value):
    """Numbers and arrays of numpy as Python's own."""
    return value.tolist() if hasattr(value, "tolist") else value


def numbers(name: str, values) -> tuple[float, ...]:
    """Numbers of an option, as floats."""
    try:
        return tuple(float(value) for value in values)
    except (TypeError, ValueError):
        raise DriftpostError(f"{name} is {values!r}: numbers are needed", "option::usage") from None

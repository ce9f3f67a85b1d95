"""A command of the command line, run in this process on files of a folder of its own."""

from __future__ import annotations

import json

from . import _driftpost
from ._errors import DriftpostError
from ._files import Folder


def command(folder: Folder, given: list[str], accepted: str | None = None) -> tuple[int, dict, str]:
    """Exit code, JSON and text of a command; a refusal with the code ``accepted`` has them, too."""
    data = folder.path("result.json")
    try:
        code, output, said = _driftpost.command([*given, f"--json={data}"], accepted)
    except DriftpostError as error:
        raise folder.error(error) from None
    if code == 2 and not (accepted and data.exists()):
        raise DriftpostError(said.strip() or output.strip() or "the command was refused")
    return code, folder.as_given(json.loads(data.read_text())), folder.as_given(output)

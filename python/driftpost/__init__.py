"""Drift compensation for ABB RAPID programs, and diagnosis of why a robot does not stand where its model says.

Options have the names that they have on the command line (``tolerance_mm`` is ``--tolerance-mm``); lengths are mm, angles degrees,
times minutes. A program is a path, a list of paths, a folder, its text, or a dict of name and text. A table is a path, CSV text, or
anything with ``__arrow_c_stream__``: pandas, polars, pyarrow, DuckDB. What cannot be done raises DriftpostError.
"""

from __future__ import annotations

import csv
import io
import json
import math
import re
from collections.abc import Callable
from dataclasses import dataclass, field

from . import _driftpost
from ._driftpost import Table, __version__
from ._command import command
from ._errors import DriftpostError, Message
from ._files import Folder, is_text, paths_of, texts_of
from ._inputs import numbers, words
from ._robot import Calibration, Robot

__all__ = ["Calibration", "Diagnosis", "DriftpostError", "Fit", "Message", "Plan", "Result", "Robot", "Simulation", "Table", "compensate",
           "diagnose", "fit", "plan", "simulate", "validate", "__version__"]


@dataclass(frozen=True)
class Result:
    """A compensated program."""

    files: dict[str, bytes]
    """All modules as a controller loads them, changed or not, by path."""
    diff: str
    """What changed, as a unified diff."""
    motions: Table
    """A row for each motion: file, line, status, form, reason, largest correction in mm and deg."""
    buckets: Table
    """A row for each bucket of warm-up time, minutes; none in the forms ramp and live."""
    summary: dict
    """What is left: worst_before_mm, worst_after_mm, worst_switch_jump_mm, rigid_shift_worst_mm."""
    messages: list[Message]
    """Warnings and notes."""
    _review: str = field(repr=False)

    @property
    def text(self) -> str:
        """The text of the one module; a program of several has ``files``."""
        if len(self.files) != 1:
            raise DriftpostError(f"the program has {len(self.files)} modules: take them from files", "option::usage")
        return _decoded(next(iter(self.files.values())))

    def report(self) -> str:
        """The review: every motion, and the verdict in the last lines."""
        return self._review


@dataclass(frozen=True)
class Diagnosis:
    """Why a robot does not stand where its model says."""

    verdict: str
    """``explained``, ``several``, ``ambiguous``, ... (docs/DIAGNOSIS.md)."""
    causes: Table
    """A row for each cause, ranked: effect, joint, posterior, size with its unit, rms_mm."""
    data: dict
    """All that ``driftpost diagnose --json`` writes."""
    residuals: Table
    """A row for each measured row: distances before and after, mm."""
    model: str | None
    """What was found as an identified model (TOML), for ``compensate(model=)`` and ``validate``; None where nothing can be made."""
    _text: str = field(repr=False)

    def report(self) -> str:
        """The report as people read it."""
        return self._text


@dataclass(frozen=True)
class Fit:
    """A deformation table of a robot of one's own."""

    table: Table
    """t_min, joint, dx_mm, ..., rz_deg: for ``compensate(deformation=)``."""
    model: str
    """The same as an identified model (TOML)."""
    data: dict
    """All that ``driftpost fit --json`` writes."""
    _text: str = field(repr=False)

    def report(self) -> str:
        """The report as people read it."""
        return self._text


@dataclass(frozen=True)
class Simulation:
    """Where the robot really stood."""

    within: bool
    """Nowhere further off than the tolerance (``tolerance_mm``, 0.006)."""
    passes: Table
    """A row for each pass: minute, distances before and after, mm."""
    data: dict
    """All that ``driftpost simulate --json`` writes."""
    _text: str = field(repr=False)

    def report(self) -> str:
        """The summary as people read it."""
        return self._text


@dataclass(frozen=True)
class Plan:
    """Which poses to measure."""

    poses: Table
    """A row for each pose, joints in degrees."""
    template: str
    """A sheet (CSV) to fill in with what is measured, for ``diagnose``."""
    rapid: str
    """A RAPID module that drives to the poses."""
    data: dict
    """All that ``driftpost plan --json`` writes."""


# Not given, where None stands for a model that a diagnosis has not made.
_NOT_GIVEN = object()


def compensate(program, *, robot="irb140", deformation=None, model=_NOT_GIVEN,
               progress: Callable[[int, int], object] | None = None, **options) -> Result:
    """Compensates a RAPID program for thermal drift; nothing is written to disk.

    robot: name, path or Robot. deformation: table; without it and without a model the reference paper's. model: path or text (TOML) of
    an identified model; None, as of a diagnosis that made none, is refused where there is no table. progress(done, files) is called after each changed module; what it raises ends the work. Other options as of
    ``driftpost compensate --help``: ``growth="two-stage:46"``, ``form="ramp"``, ``tolerance_mm=0.02``, ``start_joints=(0, 0, 0, 0, 30, 0)``.

    Raises DriftpostError where the program is refused, with code, file and line.
    """
    if "task" in options:
        raise DriftpostError("task is no option here: compensate the folder of each task with its own robot", "option::usage")
    if model is None and deformation is None:
        raise DriftpostError("model is None, and there is no deformation: nothing says how this robot deforms", "model::none",
                             "leave model out to correct by the reference paper's table, or give a model or a deformation")
    with Folder() as folder:
        options = _models(folder, robot, deformation, None if model is _NOT_GIVEN else model, options)
        if is_text(program):
            program = {"program.mod": program}
        given = texts_of(program) if isinstance(program, dict) else paths_of(program)
        if progress is not None and not callable(progress):
            raise DriftpostError(f"progress is {type(progress).__name__}, which cannot be called", "option::usage")
        try:
            files, diff, data, review, messages = _driftpost.compensate(given, words(options), progress)
        except DriftpostError as error:
            raise folder.error(error) from None
    data = json.loads(data)
    motions, buckets = data.pop("motions"), data.pop("buckets")
    data.pop("warnings", None)
    return Result(dict(files), _decoded(diff), _table(motions), _table(buckets), data, [Message(*m) for m in messages], review)


def simulate(program, original=None, *, robot=None, deformation=None, model=None, minutes=None, **options) -> Simulation:
    """Executes RAPID on the deformed robot, against what ``original`` meant.

    minutes: warm-up minutes, numbers or ``"0:180:1"``. Tools, frames, robot and start are read from an emitted module; options win.
    Other options as of ``driftpost simulate --help``.
    """
    with Folder() as folder:
        options = _models(folder, robot, deformation, model, options)
        if minutes is not None and not isinstance(minutes, str):
            minutes = ",".join(map(repr, numbers("minutes", minutes if hasattr(minutes, "__iter__") else [minutes])))
        given = ["simulate", *folder.program(program, "program.mod")]
        if original is not None:
            given += ["--original", *folder.program(original, "original.mod")]
        made = folder.path("passes.csv")
        code, data, text = command(folder, [*given, f"--csv={made}", *words({**options, "minutes": minutes})])
        return Simulation(code == 0, _csv_table(made.read_text()), data, text)


def diagnose(measurements, *, robot="irb140", tool=None, sigma_mm: float | None = None, **options) -> Diagnosis:
    """Which unmodelled effects explain measurements, and when that cannot be said.

    measurements: table with columns q1_deg..q6_deg, x_mm, y_mm, z_mm and others (docs/MEASURING.md). tool: place of the target in the
    flange's frame (x, y, z), mm. sigma_mm: noise of one coordinate.
    """
    with Folder() as folder:
        options = _models(folder, robot, None, None, options)
        model, rows = folder.path("model.toml"), folder.path("rows.csv")
        given = [folder.table(measurements, "measurements.csv"), f"--model-out={model}", f"--csv={rows}"]
        tool = tool if tool is None else numbers("tool", tool)
        asked = ["diagnose", *given, *words({**options, "tool": tool, "sigma_mm": sigma_mm})]
        _, data, text = command(folder, asked, accepted="model::none")
        found = model.read_text() if model.exists() else None
        return Diagnosis(data["verdict"], _table(data["causes"]), data, _csv_table(rows.read_text()), found, text)


def fit(touches, *, robot="irb140", tool=None, **options) -> Fit:
    """A deformation table from fixed points touched over a warm-up and one stop (docs/FIT.md).

    touches: table with fixed_id, t_min, q1_deg..q6_deg. tool: place of the tip in the flange's frame (x, y, z), mm.
    """
    with Folder() as folder:
        options = _models(folder, robot, None, None, options)
        table, model = folder.path("table.csv"), folder.path("model.toml")
        given = [folder.table(touches, "touches.csv"), f"--table-out={table}", f"--model-out={model}"]
        _, data, text = command(folder, ["fit", *given, *words({**options, "tool": tool if tool is None else numbers("tool", tool)})])
        return Fit(_csv_table(table.read_text()), model.read_text(), data, text)


def validate(measurements, model, *, robot="irb140", register: str = "base,tool", **options) -> dict:
    """An identified model on measurements that it has not seen: n, rms_mm, mean_mm, max_mm, and the same of the nominal robot.

    register: what of base and tool is fitted again, ``"base,tool"``, ``"base"`` or ``"none"``.
    """
    with Folder() as folder:
        options = _models(folder, robot, None, model, options)
        given = folder.table(measurements, "measurements.csv")
        return command(folder, ["validate", given, *words({**options, "register": register})])[1]


def plan(*, robot="irb140", **options) -> Plan:
    """Poses to measure, so that effects can be told apart; options as of ``driftpost plan --help`` (``n=60``, ``seed=1``)."""
    with Folder() as folder:
        options = _models(folder, robot, None, None, options)
        poses, sheet, module = folder.path("poses.csv"), folder.path("sheet.csv"), folder.path("Measure.mod")
        given = [f"--csv={poses}", f"--template-out={sheet}", f"--rapid-out={module}"]
        _, data, _ = command(folder, ["plan", *given, *words(options)])
        return Plan(_csv_table(poses.read_text()), sheet.read_text(), module.read_text(), data)


def _models(folder: Folder, robot, deformation, model, options: dict) -> dict:
    """The options with robot, table and model as files."""
    options = {"robot": robot, **options}
    if deformation is not None:
        options["deformation"] = folder.table(deformation, "deformation.csv")
    if model is not None:
        options["model"] = folder.table(model, "model.toml")
    return options


def _table(rows: list[dict]) -> Table:
    return Table.from_json(json.dumps(rows))


def _csv_table(text: str) -> Table:
    rows = list(csv.DictReader(io.StringIO(text)))
    kinds = {name: _kind(name, [row[name] for row in rows if row[name]]) for name in (rows[0] if rows else ())}
    return _table([{name: kinds[name](cell) if cell else None for name, cell in row.items()} for row in rows])


# As their file writes them: 007, 1e3 and 3_4 are names.
_NAMES = {"id", "pose_id", "target", "fixed_id"}


def _kind(name: str, cells: list[str]):
    """What makes the values of a column of its cells."""
    if all(re.fullmatch("-?(0|[1-9][0-9]*)", cell) for cell in cells):
        return int
    if name in _NAMES or not all(re.fullmatch("[+-]?([0-9.]+([eE][+-]?[0-9]+)?|nan|inf)", cell, re.IGNORECASE) for cell in cells):
        return str
    return lambda cell: value if math.isfinite(value := float(cell)) else None


def _decoded(text: bytes) -> str:
    """RAPID is UTF-8 or Latin-1."""
    try:
        return text.decode("utf-8")
    except UnicodeDecodeError:
        return text.decode("latin-1")

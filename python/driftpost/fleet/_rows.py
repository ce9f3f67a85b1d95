"""What one row becomes: a corrected program, a diagnosis, a comparison. No engine, no other row, no file but in a folder of its own."""

from __future__ import annotations

import csv
import hashlib
import io
import json
import math
import os
import re

import pyarrow as pa

from .. import compensate
from .._command import command
from .._errors import DriftpostError, Message
from .._files import Folder
from ._layout import BUCKETS, CAUSES, LENGTHS, MOTIONS, NUMBERS, WORDS

# Options whose value is a number, a word or a truth: a path would name a file of whichever worker the row is on.
OPTIONS = {"absolute_accuracy", "allow_non_nominal", "allow_other_robot", "base_fixed", "bucket_min", "clock", "core", "form", "gap_min",
           "growth", "hold_min", "home", "keep", "keep_moveabsj", "max_correction_deg", "max_correction_mm", "only", "path_tolerance_mm",
           "payload_kg", "self_test", "stale_min", "start_joints", "strict", "tau_cool", "temperature_c", "tolerance_mm", "tool", "until",
           "wobj"}
UNITS = {"mm", "m", "inch"}
TIME_BASES = {"cold_start", "first_row", "none"}


OF_THE_PAPER = Message("fleet::default-table", "warning", "the row has neither model nor deformation: the program is corrected by the reference paper's table, "
                       "which is that of one IRB 140", "give each robot a model or a table of its own", None, None)


def compensated(row: dict) -> dict:
    """The corrected program of a row of programs."""
    modules = [(module["name"], module["text"]) for module in row["modules"]]
    names = [name for name, _ in modules]
    if any(name is None or text is None for name, text in modules) or len(set(names)) < len(names):
        raise DriftpostError("modules have a name and a text, and no two the same name", "fleet::column")
    model = row["model"]
    found = sha256(model) if model is not None else None
    if row["model_hash"] not in (None, found):
        raise DriftpostError(f"model_hash is {row['model_hash']}, the model's is {found}", "fleet::model-hash",
                             "Take model and model_hash of the same row of a diagnosis.")
    with Folder() as folder:
        drift = {name: _text(name, row[name]) for name in ("model", "deformation") if row[name] is not None}
        result = compensate(dict(modules), robot=_robot(folder, row["robot"]), **drift, **_options(row["options"]))
    motions = pa.table(result.motions).to_pylist()
    buckets = pa.table(result.buckets).to_pylist()
    files = [{"name": name, "text": text} for name, text in sorted(result.files.items())]
    figures = ("worst_before_mm", "worst_after_mm", "worst_switch_jump_mm", "rigid_shift_worst_mm")
    return {"model_hash": found, "motions": [_only(MOTIONS, motion) for motion in motions],
            "buckets": [_only(BUCKETS, bucket) for bucket in buckets], "files": files,
            "result_hash": modules_hash(files), "messages": [message._asdict() for message in [*([] if drift else [OF_THE_PAPER]), *result.messages]],
            **{name: result.summary.get(name) for name in figures}}


def diagnosed(row: dict) -> dict:
    """The diagnosis of a set of measurements."""
    columns = _columns(row)
    with Folder() as folder:
        table, model = folder.path("measurements.csv"), folder.path("model.toml")
        table.write_text(_csv(row, columns))
        _, data, _ = command(folder, ["diagnose", str(table), f"--model-out={model}", *_known(folder, row, row, columns)], accepted="model::none")
        found = model.read_text() if model.exists() else None
    left = data.get("shrink") or {}
    return {"verdict": data["verdict"], "causes": [_only(CAUSES, cause) for cause in data["causes"]], "model": found,
            "model_hash": sha256(found) if found is not None else None,
            **{f"{name}_rms_mm": left.get(f"{name}_rms_mm") for name in ("before", "after", "floor")}}


def compared(row: dict) -> dict:
    """What has changed between two sets of measurements of one robot at the same poses."""
    before, after = ({name.removeprefix(f"{week}_"): value for name, value in row.items() if name.startswith(f"{week}_")}
                     for week in ("before", "after"))
    if before["set_id"] is None:
        raise DriftpostError("there is one set of this robot alone", "fleet::one-set", "It is compared when it has been measured again.")
    if before["unit"] != after["unit"]:
        raise DriftpostError(f"one set is in {before['unit']}, the other in {after['unit']}", "fleet::unit", "Write both in one unit.")
    earlier, later = _columns(before), _columns(after)
    columns = [name for name in earlier if name in later]
    with Folder() as folder:
        first, second = folder.path("before.csv"), folder.path("after.csv")
        first.write_text(_csv(before, columns))
        second.write_text(_csv(after, columns))
        _, data, _ = command(folder, ["compare-measurements", str(first), str(second), *_known(folder, row, after, columns)])
    noise = data["noise_rms_mm"]
    lengths = [math.hypot(*tool["by_mm"]) for tool in data["tools"]]
    return {"changed": data["changed"], "verdict": data["verdict"], "pairs": data["pairs"], "rms_mm": data["rms_mm"], "noise_rms_mm": noise,
            "ratio": data["rms_mm"] / noise if noise else None, "worst_mm": max((pose["mm"] for pose in data["worst"]), default=None),
            "tool_moved_mm": max(lengths, default=None), "base_moved_mm": math.hypot(*data["base"]["by_mm"]) if data.get("base") else None,
            "causes": [_only(CAUSES, cause) for cause in data["causes"]], "sensor_changed": before["sensor"] != after["sensor"],
            "model_changed": before["model_hash"] != after["model_hash"]}


def sha256(text: str) -> str:
    return hashlib.sha256(text.encode("utf-8", "surrogateescape")).hexdigest()


def modules_hash(modules: list[dict]) -> str:
    """SHA-256 of a program: of each module the lengths of name and text, name, text."""
    whole = hashlib.sha256()
    for module in modules:
        name, text = (module["name"] or "").encode(), module["text"] or b""
        whole.update(f"{len(name)} {len(text)} ".encode() + name + text)
    return whole.hexdigest()


def _robot(folder: Folder, robot: str) -> str:
    """A built-in robot's name, or the path of a robot file made of its text."""
    if "\n" in robot:
        path = folder.path("robot.toml")
        path.write_text(robot)
        return str(path)
    if not re.fullmatch(r"[A-Za-z0-9_-]+(\.\d+)?", robot):
        raise DriftpostError(f"robot is {robot!r}: the name of a built-in robot, or the text of a robot file, is needed", "fleet::robot",
                             "A path would mean another file on another worker.")
    if os.path.lexists(robot):
        raise DriftpostError(f"robot is {robot!r}, and a file of that name lies in this worker's folder", "fleet::robot",
                             "A path would mean another file on another worker: run it in a folder of its own.")
    return robot


def _text(name: str, text: str | None) -> str | None:
    """A table or a model, which is given by its text: one line is a path, and that is none of a worker's."""
    if text is not None and "\n" not in text:
        raise DriftpostError(f"{name} is one line: its whole text is needed, no path", "fleet::column")
    return text


def _options(text: str | None) -> dict:
    try:
        options = json.loads(text) if text else {}
    except ValueError as error:
        raise DriftpostError(f"options is no JSON: {error}", "fleet::options") from None
    if not isinstance(options, dict):
        raise DriftpostError("options is no JSON object of names and values", "fleet::options")
    if wrong := sorted(options.keys() - OPTIONS):
        raise DriftpostError(f"options holds {', '.join(wrong)}; there are {', '.join(sorted(OPTIONS))}", "fleet::options")
    return {name: tuple(value) if name in ("start_joints", "temperature_c") and isinstance(value, list) else value
            for name, value in options.items()}


def _columns(of: dict) -> list[str]:
    """The measured columns that a set has; all must be equally long."""
    for name, known, code in (("unit", UNITS, "fleet::unit"), ("time_base", TIME_BASES, "fleet::time-base")):
        if of[name] not in known:
            raise DriftpostError(f"{name} is {of[name]!r}; there are {', '.join(sorted(known))}", code)
    columns = [name for name in (*WORDS, *NUMBERS) if of[name] and not (name == "t_min" and of["time_base"] == "none")]
    lengths = {name: len(of[name]) for name in columns}
    if len(set(lengths.values())) > 1:
        raise DriftpostError("columns of one set differ in length: " + ", ".join(f"{name} {n}" for name, n in lengths.items()), "fleet::length")
    if not columns:
        raise DriftpostError("the set has no measured column", "fleet::length")
    return columns


def _csv(of: dict, columns: list[str]) -> str:
    """The set as a measurement file, every number with all its digits."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows(["" if cell is None else repr(cell) if isinstance(cell, float) else cell for cell in cells]
                     for cells in zip(*(of[name] for name in columns)))
    return text.getvalue()


def _known(folder: Folder, row: dict, of: dict, columns: list[str]) -> list[str]:
    """What is known of robot, tool, noise and units, as options."""
    layout = folder.path("columns.toml")
    named = "".join(f'{name}_mm = "{name}"\n' if name in LENGTHS else f'{name} = "{name}"\n' for name in columns)
    layout.write_text(f'length_unit = "{of["unit"]}"\n[columns]\n{named}')
    words = [f"--robot={_robot(folder, row['robot'])}", f"--columns={layout}"]
    if of["tool_mm"]:
        words.append("--tool=" + ",".join(map(repr, of["tool_mm"])))
    if of["sigma_mm"] is not None:
        words.append(f"--sigma-mm={of['sigma_mm']!r}")
    return words


def _only(kind: pa.ListType, found: dict) -> dict:
    return {field.name: found.get(field.name) for field in kind.value_type}

"""The Parquet layout of a fleet: which columns there are, of which type, and a sentence where a table has others."""

from __future__ import annotations

import pyarrow as pa
import pyarrow.compute as pc

from .._errors import DriftpostError

LAYOUT_VERSION = 1
"""Stands in every row. A reader refuses rows of another version, rather than guess what their columns mean."""

TEXT, REAL, WHOLE, TRUTH, TIME = pa.string(), pa.float64(), pa.int64(), pa.bool_(), pa.timestamp("us", tz="UTC")
MODULES = pa.list_(pa.struct([("name", TEXT), ("text", pa.binary())]))
MESSAGES = pa.list_(pa.struct([("code", TEXT), ("severity", TEXT), ("text", TEXT), ("file", TEXT), ("line", WHOLE)]))
CAUSES = pa.list_(pa.struct([("effect", TEXT), ("joint", WHOLE), ("joint_b", WHOLE), ("posterior", REAL), ("size", REAL), ("unit", TEXT),
                             ("rms_mm", REAL), ("slot", WHOLE)]))
MOTIONS = pa.list_(pa.struct([("file", TEXT), ("line", WHOLE), ("routine", TEXT), ("kind", TEXT), ("target", TEXT), ("status", TEXT),
                              ("form", TEXT), ("reason", TEXT), ("max_correction_mm", REAL), ("max_correction_deg", REAL)]))
BUCKETS = pa.list_(pa.struct([("index", WHOLE), ("from_min", REAL), ("to_min", REAL), ("at_min", REAL)]))

PROGRAMS = {"layout_version": WHOLE, "robot_serial": TEXT, "robot": TEXT, "program_name": TEXT, "modules": MODULES}
PROGRAMS_OPTIONAL = {"model": TEXT, "model_hash": TEXT, "deformation": TEXT, "options": TEXT}

SETS = {"layout_version": WHOLE, "robot_serial": TEXT, "robot": TEXT, "set_id": TEXT, "measured_at": TIME, "time_base": TEXT,
        "sensor": TEXT, "unit": TEXT}
LENGTHS = ["x", "y", "z", "length"]
"""Measured lengths, in the unit that the row names."""
NUMBERS = ["t_min", *(f"q{j}_deg" for j in range(1, 8)), *LENGTHS, "qw", "qx", "qy", "qz", *(f"dir{j}" for j in range(1, 8)),
           "payload_kg", *(f"temp_j{j}_c" for j in range(1, 8)), "temp_air_c"]
WORDS = ["id", "pose_id", "fixed_id", "target", "kind"]
SETS_OPTIONAL = {"model_hash": TEXT, "tool_mm": pa.list_(REAL), "sigma_mm": REAL, **{name: pa.list_(REAL) for name in NUMBERS},
                 **{name: pa.list_(TEXT) for name in WORDS}}


def _beside(prefix: str, columns: dict[str, pa.DataType]) -> dict[str, pa.DataType]:
    return {f"{prefix}_{name}": kind for name, kind in columns.items() if name not in ("layout_version", "robot_serial", "robot")}


PAIRS = {"layout_version": WHOLE, "robot_serial": TEXT, "robot": TEXT, **_beside("after", SETS)}
PAIRS_OPTIONAL = {**_beside("before", SETS), **_beside("before", SETS_OPTIONAL), **_beside("after", SETS_OPTIONAL)}
"""A robot that was measured once has nothing in the columns before."""

# What every row of results has: which row it is of, what it was made from, and how it ended.
_ENDED = {"layout_version": WHOLE, "key": TEXT, "driftpost_version": TEXT, "robot_serial": TEXT}
_STATUS = {"status": TEXT, "code": TEXT, "message": TEXT, "help": TEXT, "file": TEXT, "line": WHOLE, "messages": MESSAGES}

COMPENSATED = pa.schema({
    **_ENDED, "program_name": TEXT, "program_hash": TEXT, "model_hash": TEXT, **_STATUS, "worst_before_mm": REAL, "worst_after_mm": REAL,
    "worst_switch_jump_mm": REAL, "rigid_shift_worst_mm": REAL, "motions": MOTIONS, "buckets": BUCKETS, "result_hash": TEXT,
    "files": MODULES})
DIAGNOSED = pa.schema({
    **_ENDED, "set_id": TEXT, "measured_at": TIME, "time_base": TEXT, "sensor": TEXT, "measured_model_hash": TEXT, **_STATUS, "verdict": TEXT,
    "before_rms_mm": REAL, "after_rms_mm": REAL, "floor_rms_mm": REAL, "causes": CAUSES, "model": TEXT, "model_hash": TEXT})
WATCHED = pa.schema({
    **_ENDED, "before_set": TEXT, "after_set": TEXT, "before_at": TIME, "after_at": TIME, "sensor_changed": TRUTH, "model_changed": TRUTH,
    **_STATUS, "changed": TRUTH, "verdict": TEXT, "pairs": WHOLE, "rms_mm": REAL, "noise_rms_mm": REAL, "ratio": REAL, "worst_mm": REAL,
    "tool_moved_mm": REAL, "base_moved_mm": REAL, "causes": CAUSES})


def conform(table: pa.Table, required: dict[str, pa.DataType], optional: dict[str, pa.DataType], place: str) -> pa.Table:
    """The table with the layout's columns in the layout's types; optional ones that it has not are null, others are left out.

    Raises DriftpostError (``fleet::column``, ``fleet::type``, ``fleet::layout-version``), naming the column and the place.
    """
    check_schema(table.schema, required, optional, place)
    versions = set(pc.unique(table["layout_version"]).to_pylist())
    if wrong := sorted(map(str, versions - {LAYOUT_VERSION, None})):
        raise DriftpostError(f"{place}: column layout_version holds {', '.join(wrong)}; this driftpost reads layout {LAYOUT_VERSION}",
                             "fleet::layout-version", "Write the table anew as docs/FLEET.md has it, or take the driftpost of that layout.")
    columns = {}
    for name, kind in {**required, **optional}.items():
        if name not in table.column_names:
            columns[name] = pa.nulls(len(table), kind)
            continue
        column = table[name]
        if name in required and column.null_count:
            raise DriftpostError(f"{place}: column {name} has {column.null_count} rows without a value", "fleet::column")
        try:
            columns[name] = column.cast(kind)
        except (pa.ArrowInvalid, pa.ArrowNotImplementedError, pa.ArrowTypeError) as error:
            raise DriftpostError(f"{place}: column {name} holds {column.type}, {kind} is needed: {error}", "fleet::type") from None
    return pa.table(columns)


def check_schema(schema: pa.Schema, required: dict[str, pa.DataType], optional: dict[str, pa.DataType], place: str) -> None:
    """Raises DriftpostError where a column is missing, is there twice, or is of a kind that is not the layout's."""
    for name, kind in {**required, **optional}.items():
        found = schema.get_all_field_indices(name)
        if len(found) > 1:
            raise DriftpostError(f"{place}: column {name} is there {len(found)} times", "fleet::column")
        if not found:
            if name in required:
                raise DriftpostError(f"{place}: column {name} is missing; there are {', '.join(schema.names) or 'none'}", "fleet::column")
            continue
        held = schema.field(found[0]).type
        if not (pa.types.is_null(held) and name in optional) and not _alike(held, kind):
            raise DriftpostError(f"{place}: column {name} holds {held}, {kind} is needed", "fleet::type")


def _alike(held: pa.DataType, wanted: pa.DataType) -> bool:
    """Whether a cast only changes how a value is stored: never text to a number."""
    is_a = pa.types
    if is_a.is_dictionary(held):
        held = held.value_type
    if is_a.is_list(wanted):
        is_list = is_a.is_list(held) or is_a.is_large_list(held) or is_a.is_fixed_size_list(held)
        return is_list and (is_a.is_null(held.value_type) or _alike(held.value_type, wanted.value_type))
    if is_a.is_struct(wanted):
        names = [wanted.field(i).name for i in range(wanted.num_fields)]
        return is_a.is_struct(held) and [held.field(i).name for i in range(held.num_fields)] == names and all(
            _alike(held.field(i).type, wanted.field(i).type) for i in range(wanted.num_fields))
    if is_a.is_binary(wanted):
        return is_a.is_binary(held) or is_a.is_large_binary(held) or is_a.is_string(held) or is_a.is_large_string(held)
    if is_a.is_string(wanted):
        return is_a.is_string(held) or is_a.is_large_string(held)
    if is_a.is_floating(wanted):
        return is_a.is_floating(held) or is_a.is_integer(held)
    if is_a.is_timestamp(wanted):
        return is_a.is_timestamp(held) and held.tz is not None
    return is_a.is_integer(held) if is_a.is_integer(wanted) else held == wanted

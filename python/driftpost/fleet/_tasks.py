"""A task applied to a table: rows in, rows of results out, the same wherever it runs. What Ray and Spark are given."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from datetime import datetime

import pyarrow as pa

from .. import _driftpost
from .._errors import DriftpostError
from . import _layout as layout
from . import _rows as rows


@dataclass(frozen=True)
class Task:
    """What is done with each row of a table."""

    name: str
    required: dict[str, pa.DataType]
    optional: dict[str, pa.DataType]
    results: pa.Schema
    work: Callable[[dict], dict]
    """Row as a dict to the task's columns of its result; raises DriftpostError where there is none."""
    about: Callable[[dict], dict]
    """What of the row the result repeats, refused or not."""

    def key(self, row: dict) -> str:
        """SHA-256 of driftpost's version, the task and all that the row holds: rows of one key have one result, for ever."""
        whole = hashlib.sha256()
        _feed(whole, [_driftpost.__version__, self.name, [row[name] for name in (*self.required, *self.optional)]])
        return whole.hexdigest()


COMPENSATE = Task(
    "compensate", layout.PROGRAMS, layout.PROGRAMS_OPTIONAL, layout.COMPENSATED, rows.compensated,
    lambda row: {"program_name": row["program_name"], "program_hash": rows.modules_hash(row["modules"]), "model_hash": row["model_hash"]})
DIAGNOSE = Task(
    "diagnose", layout.SETS, layout.SETS_OPTIONAL, layout.DIAGNOSED, rows.diagnosed,
    lambda row: {name: row[name] for name in ("set_id", "measured_at", "time_base", "sensor")} | {"measured_model_hash": row["model_hash"]})
WATCH = Task(
    "watch", layout.PAIRS, layout.PAIRS_OPTIONAL, layout.WATCHED, rows.compared,
    lambda row: {"before_set": row["before_set_id"], "after_set": row["after_set_id"], "before_at": row["before_measured_at"],
                 "after_at": row["after_measured_at"]})


def apply(task: Task, table: pa.Table | pa.RecordBatch, done: frozenset[str] = frozenset(), place: str = "table") -> pa.Table:
    """The results of a table's rows, in their order; rows whose key is in ``done`` are left out.

    A row that is refused is a row of results with ``status`` ``refused``, its code, file and line; one that ends in any other way than
    by a message has ``failed`` and ``fleet::failed``. Only a table of another layout raises (``fleet::column``, ``fleet::type``,
    ``fleet::layout-version``). How many threads work on a row says ``RAYON_NUM_THREADS``; the bytes are the same with any.
    """
    if isinstance(table, pa.RecordBatch):
        table = pa.Table.from_batches([table])
    table = layout.conform(table, task.required, task.optional, place)
    made = []
    for row in (row for part in table.to_batches(max_chunksize=64) for row in part.to_pylist()):
        key = task.key(row)
        if key not in done:
            made.append(_result(task, row, key))
    return pa.Table.from_pylist(made, task.results)


def batches(task: Task, given: Iterable[pa.RecordBatch]) -> Iterator[pa.RecordBatch]:
    """The same for one record batch after another: with the task bound, what Spark's ``mapInArrow`` is given."""
    for batch in given:
        yield from apply(task, batch).to_batches()


def refused(task: Task, row: dict, key: str, error: DriftpostError, status: str = "refused") -> dict:
    """The row of results of a row that has none."""
    return _row(task, row, key) | {"status": status, "code": error.code, "message": error.text, "help": error.help, "file": error.file,
                                   "line": error.line, "messages": [message._asdict() for message in error.messages]}


def _result(task: Task, row: dict, key: str) -> dict:
    try:
        made = {"messages": [], **task.work(row)}
        # Here, so that a value that its column cannot hold is a failure of this row, not of all.
        return pa.Table.from_pylist([_row(task, row, key) | {"status": "done"} | made], task.results).to_pylist()[0]
    except DriftpostError as error:
        return refused(task, row, key, error)
    except (KeyboardInterrupt, SystemExit, GeneratorExit, MemoryError):
        raise
    except BaseException as error:  # a panic of the compiled half is no Exception
        told = DriftpostError(f"{type(error).__name__}: {error}", "fleet::failed", "This is a fault of driftpost: please report it with the row.")
        return refused(task, row, key, told, "failed")


def _row(task: Task, row: dict, key: str) -> dict:
    return {"layout_version": layout.LAYOUT_VERSION, "key": key, "driftpost_version": _driftpost.__version__,
            "robot_serial": row["robot_serial"], **task.about(row)}


def _feed(whole, value) -> None:
    """Hashes a value so that no two different values give the same bytes: kind, length, content."""
    if isinstance(value, (list, tuple, dict)):
        items = [part for pair in sorted(value.items()) for part in pair] if isinstance(value, dict) else value
        whole.update(f"[{len(items)} ".encode())
        for item in items:
            _feed(whole, item)
        return
    if isinstance(value, float):
        value = value.hex()
    elif isinstance(value, datetime):
        value = value.isoformat()
    content = value if isinstance(value, bytes) else str(value).encode("utf-8", "surrogateescape")
    whole.update(f"{type(value).__name__[0]}{len(content)} ".encode() + content)

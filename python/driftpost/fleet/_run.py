"""Runs a task over a table in Parquet: on Ray, or in this process. What is done already is not done again."""

from __future__ import annotations

import os
import time
from collections.abc import Iterator
from dataclasses import dataclass

import pyarrow as pa
import pyarrow.dataset as dataset
from pyarrow import fs, parquet

from .. import _driftpost
from .._errors import DriftpostError
from . import _layout as layout
from ._store import Store
from ._tasks import Task, apply, refused

WORKER_DIED = DriftpostError("the worker died each time it came to this row", "fleet::worker-died",
                             "Run it alone with driftpost: memory is the usual cause. The row is tried again at the next run.")


@dataclass(frozen=True)
class Summary:
    """How a run ended."""

    rows: int
    """Different rows of the input, each with a row of results."""
    skipped: int
    """Of these, done by an earlier run."""
    refused: int
    """Rows with a code in place of a result."""
    wall_s: float
    cpu_s: float
    """Processor time in the tasks' own work, all workers together."""
    workers: int
    """Different processes that did it: more than were asked for where one died."""
    files: dict[str, str]
    """SHA-256 of each file of results."""


class Input:
    """A table of rows in Parquet: a file, or a folder of files in the order of their names."""

    def __init__(self, task: Task, place: str):
        self.task, self.place = task, place
        try:
            self.fs, root = fs.FileSystem.from_uri(place if "://" in place else os.path.abspath(place))
            info = self.fs.get_file_info(root)
            if info.type == fs.FileType.NotFound:
                raise DriftpostError(f"{place} is not there", "input::missing")
            found = [info] if info.is_file else self.fs.get_file_info(fs.FileSelector(root, recursive=True))
            self.paths = sorted(i.path for i in found if i.is_file and (info.is_file or i.path.endswith(".parquet")))
            if not self.paths:
                raise DriftpostError(f"{place} holds no file *.parquet", "input::missing")
            for path in self.paths:
                layout.check_schema(parquet.read_schema(path, filesystem=self.fs), task.required, task.optional, path)
            self.tables = [dataset.dataset(path, format="parquet", filesystem=self.fs) for path in self.paths]
        except (pa.ArrowException, OSError) as error:
            raise DriftpostError(f"{place}: {error}", "input::unreadable") from None
        self.columns = [name for name in (*task.required, *task.optional) if name in self.tables[0].schema.names]
        for path, table in zip(self.paths, self.tables):
            if odd := sorted(set(self.columns) ^ {*task.required, *task.optional}.intersection(table.schema.names)):
                raise DriftpostError(f"{path}: column {odd[0]} is in this file or in {self.paths[0]}, not in both", "fleet::column")

    def batches(self) -> Iterator[tuple[str, pa.Table]]:
        """The rows in their order, in the layout's columns and types."""
        for place, table in zip(self.paths, self.tables):
            try:
                for batch in table.to_batches(columns=self.columns, batch_size=256):
                    yield place, layout.conform(pa.Table.from_batches([batch]), self.task.required, self.task.optional, place)
            except (pa.ArrowException, OSError) as error:
                raise DriftpostError(f"{place}: {error}", "input::unreadable") from None

    def keys(self) -> list[str]:
        """The keys of all rows, in order, each once."""
        return list(dict.fromkeys(self.task.key(row) for _, table in self.batches() for row in table.to_pylist()))

    def rows(self, wanted: set[str]) -> Iterator[tuple[str, pa.Table]]:
        """Key and row, a table of its own, of the rows wanted."""
        for _, table in self.batches():
            for number, row in enumerate(table.to_pylist()):
                if (key := self.task.key(row)) in wanted:
                    wanted = wanted - {key}
                    yield key, table.slice(number, 1)


def run(task: Task, given: str, to: str, *, ray: bool = True, workers: int | None = None, address: str | None = None,
        rows_a_task: int = 16) -> Summary:
    """Runs a task over all rows of ``given`` and writes the results to the folder ``to``.

    ray=False works in this process. workers: cores of a Ray started here; address: a Ray that runs already. Every result is written
    as soon as ``rows_a_task`` rows are done, so that a run that was cut off goes on where it was. Raises DriftpostError where the input
    is of another layout or nothing can be written; rows that are refused raise nothing.
    """
    began = time.perf_counter()
    source, store = Input(task, given), Store(to)
    keys = source.keys()
    store.prepare()
    before = store.index()
    done = frozenset(before).intersection(keys)
    spent: list[dict] = []
    if len(done) < len(keys):
        if ray:
            from ._ray import on_ray
            spent = on_ray(task, source, store, keys, done, workers, address, rows_a_task)
        else:
            spent = [work(task, table.slice(start, rows_a_task), store, done, _driftpost.__version__)
                     for _, table in source.batches() for start in range(0, len(table), rows_a_task)]
    index = store.index()
    lost = {key: table for key, table in source.rows(set(keys) - index.keys())} if len(index.keys() & set(keys)) < len(keys) else {}
    statuses: dict[str, int] = {}

    def count(table: pa.Table) -> None:
        for status in table["status"].to_pylist():
            statuses[status] = statuses.get(status, 0) + 1

    files = store.collect(keys, index, lambda key: refused(task, lost[key].to_pylist()[0], key, WORKER_DIED, "failed"), task.results, count)
    store.finish({"layout_version": layout.LAYOUT_VERSION, "task": task.name, "driftpost_version": _driftpost.__version__,
                  "rows": len(keys), "statuses": dict(sorted(statuses.items())), "files": files})
    return Summary(len(keys), len(done), len(keys) - statuses.get("done", 0), time.perf_counter() - began,
                   sum(part["cpu_s"] for part in spent), len({part["process"] for part in spent}), files)


def work(task: Task, table: pa.Table, store: Store, done: frozenset[str], version: str) -> dict:
    """Does the rows that are not done and writes them as a part; how long that took."""
    if _driftpost.__version__ != version:
        raise DriftpostError(f"this worker has driftpost {_driftpost.__version__}, the run was started with {version}", "fleet::version",
                             "Install one version on all nodes.")
    cpu = time.process_time()
    made = apply(task, table, done)
    if len(made):
        store.write_part(made)
    return {"process": f"{os.uname().nodename}:{os.getpid()}", "rows": len(made), "cpu_s": time.process_time() - cpu}

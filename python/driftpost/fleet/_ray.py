"""A run on Ray: its Data reads the rows, cuts them into tasks and runs them on its workers. Nothing is scheduled here."""

from __future__ import annotations

import logging
import os
import warnings

import pyarrow as pa

from .. import _driftpost
from .._errors import DriftpostError
from ._run import Input, work
from ._store import Store
from ._tasks import Task

TRIES = 3
"""How often Ray starts a task anew whose worker died."""

SPENT = pa.schema([("process", pa.string()), ("rows", pa.int64()), ("cpu_s", pa.float64()), ("code", pa.string()), ("text", pa.string()),
                   ("help", pa.string())])


def on_ray(task: Task, source: Input, store: Store, keys: list[str], done: frozenset[str], workers: int | None, address: str | None,
           rows_a_task: int) -> list[dict]:
    """Does all rows that are not done; how long each task took.

    A task whose worker dies is begun anew by Ray, on another. Where its workers die again and again its rows are tried once more, one
    row a task, so that one row that kills its worker takes no other with it.
    """
    try:
        import ray
    except ImportError:
        raise DriftpostError("ray is not installed", "fleet::no-ray",
                             "pip install 'driftpost[fleet]', or run on one machine with --serial.") from None
    is_ours = not ray.is_initialized()
    if is_ours:
        # Ray reports its use to its makers unless it is told not to; what a plant does is the plant's.
        os.environ.setdefault("RAY_USAGE_STATS_ENABLED", "0")
        # A core for each task: threads of a task would only take turns with those of the others.
        try:
            ray.init(address=address, num_cpus=None if address else workers, include_dashboard=False if address is None else None,
                     log_to_driver=False, logging_level=logging.WARNING, runtime_env={"env_vars": {"RAYON_NUM_THREADS": "1"}})
        except (ConnectionError, ImportError, RuntimeError, ValueError) as error:
            where = "a Ray of this machine's own" if address is None else address
            raise DriftpostError(f"{where} cannot be had: {error}", "fleet::ray-unreachable",
                                 "Is it running, and the address right? ray://HOST:PORT needs pip install 'ray[client]'.") from None
    try:
        context = ray.data.DataContext.get_current()
        context.enable_progress_bars = False
        context.max_errored_blocks = -1
        rows = ray.data.read_parquet(source.paths, filesystem=source.fs, partitioning=None).select_columns(source.columns)
        # Ray has set this up by now. What it would tell of a dead worker at length stands in the row's result.
        logging.getLogger("ray.data").setLevel(logging.CRITICAL)
        spent = _map(ray, rows.repartition(target_num_rows_per_block=rows_a_task), task, store, done)
        if left := set(keys) - store.index().keys():
            alone = [row for _, row in source.rows(left)]
            spent += _map(ray, ray.data.from_arrow(alone), task, store, frozenset())
    finally:
        if is_ours:
            ray.shutdown()
    for part in spent:
        if part["code"] is not None:
            raise DriftpostError(part["text"], part["code"], part["help"])
    return spent


def _map(ray, rows, task: Task, store: Store, done: frozenset[str]) -> list[dict]:
    """Applies the task to each block of rows; what is written is written by the workers, only times come back."""
    held, place, version = ray.put(done), store.place, _driftpost.__version__

    def one(table: pa.Table) -> pa.Table:
        # Not a row's fault, and no worker's death: told to the caller at the end, as what else there is to do can be done.
        told = {"code": None, "text": None, "help": None}
        try:
            spent = work(task, table, Store(place), ray.get(held), version)
        except DriftpostError as error:
            spent = {"process": "", "rows": 0, "cpu_s": 0.0}
            told = {"code": error.code, "text": error.text, "help": error.help}
        return pa.Table.from_pylist([spent | told], SPENT)

    with warnings.catch_warnings():
        # Ray 2.60 has no other way yet to say how often a task is begun anew; by itself it would try for ever.
        warnings.filterwarnings("ignore", message=".*ray_remote_args.*")
        made = rows.map_batches(one, batch_size=None, batch_format="pyarrow", num_cpus=1, max_retries=TRIES)
    return made.take_all()

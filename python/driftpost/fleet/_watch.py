"""Which robots have changed: each robot's last set of measurements beside the one of a week before."""

from __future__ import annotations

import datetime

import pyarrow as pa
import pyarrow.parquet as pq

from . import _layout as layout
from ._page import Ranked, page
from ._run import Input, Summary, run
from ._store import Store
from ._tasks import DIAGNOSE, WATCH


def watch(given: str, to: str, *, days: float = 7, **how) -> tuple[Summary, Ranked]:
    """Compares each robot's last set with the one nearest to ``days`` before it, and writes ``page.html`` beside the results.

    given: sets of measurements, of all weeks. how: as for ``run``. The results are in the order of the robots' serials.
    """
    # A path that the workers see, as they read the pairs.
    store = Store(to)
    store.prepare()
    sets = [table for _, table in Input(DIAGNOSE, given).batches()]
    paired = pairs(pa.concat_tables(sets) if sets else pa.schema({**layout.SETS, **layout.SETS_OPTIONAL}).empty_table(), days)
    store.write("pairs.parquet", lambda file: pq.write_table(paired, file, compression="zstd"))
    summary = run(WATCH, f"{to.rstrip('/')}/pairs.parquet", to, **how)
    ranked = Ranked()
    for table in store.results():
        ranked.add(table)
    store.write_text("page.html", page(ranked, days))
    return summary, ranked


def pairs(sets: pa.Table, days: float = 7) -> pa.Table:
    """A row for each robot, by serial: its last set, and beside it the earlier one whose time is nearest to ``days`` before.

    A robot of one set has nothing beside it. sets: the layout's columns and types (``conform``).
    """
    times: dict[str, list[tuple[datetime.datetime, str, int]]] = {}
    for row, (serial, at, name) in enumerate(zip(*(sets[column].to_pylist() for column in ("robot_serial", "measured_at", "set_id")))):
        times.setdefault(serial, []).append((at, name, row))
    span = datetime.timedelta(days=days)
    last, earlier = [], []
    for _, found in sorted(times.items()):
        *before, (at, _, row) = sorted(found)
        last.append(row)
        before = [one for one in before if one[0] < at]
        earlier.append(min(before, key=lambda one: (abs(at - one[0] - span), one[0], one[1]))[2] if before else None)
    columns = {}
    for week, rows in (("before", pa.array(earlier, pa.int64())), ("after", pa.array(last, pa.int64()))):
        taken = sets.take(rows)
        for name in taken.column_names:
            kept = name in ("layout_version", "robot_serial", "robot")
            if not kept or week == "after":
                columns[name if kept else f"{week}_{name}"] = taken[name]
    return pa.table({name: columns[name] for name in (*layout.PAIRS, *layout.PAIRS_OPTIONAL)})

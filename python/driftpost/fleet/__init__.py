"""A plant's robots at once: ``python -m driftpost.fleet compensate|diagnose|watch INPUT OUTPUT``, on Ray over Parquet (docs/FLEET.md).

A row is a program of a robot, or a set of measurements; each gives one row of results, also where it is refused. What a row becomes
depends on the row and on driftpost's version alone, so that ``apply`` gives the same under Ray, under Spark and in a loop.
"""

from ._layout import LAYOUT_VERSION
from ._run import Summary, run
from ._tasks import COMPENSATE, DIAGNOSE, WATCH, Task, apply, batches
from ._page import Ranked, page
from ._watch import pairs, watch

__all__ = ["COMPENSATE", "DIAGNOSE", "LAYOUT_VERSION", "Ranked", "Summary", "Task", "WATCH", "apply", "batches", "page", "pairs", "run", "watch"]

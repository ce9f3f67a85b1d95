"""Workers that die: killed from outside while they work, and by a row that no worker survives."""

from __future__ import annotations

import dataclasses
import os
import pathlib
import signal
import threading
import time

import psutil

from driftpost.fleet import DIAGNOSE

POISON = "140-000003"


def deadly(row: dict) -> dict:
    """A diagnosis whose process is gone when it comes to one robot, as after a fault in compiled code."""
    if row["robot_serial"] == POISON:
        os.kill(os.getpid(), signal.SIGKILL)
    return DIAGNOSE.work(row)


POISONED = dataclasses.replace(DIAGNOSE, work=deadly)


class Killer(threading.Thread):
    """Kills one worker of the Ray that this process has started, in the middle of a task, once ``after`` parts are written."""

    def __init__(self, parts: pathlib.Path, after: int):
        super().__init__(daemon=True)
        self.parts, self.after, self.killed, self.ended = parts, after, None, threading.Event()

    def run(self):
        while not self.ended.is_set() and self.killed is None:
            if self.parts.is_dir() and len(list(self.parts.glob("part-*"))) >= self.after:
                self.killed = self._kill()
            time.sleep(0.02)

    def _kill(self) -> str | None:
        """Ray writes into a worker's title what it is at."""
        for process in psutil.Process().children(recursive=True):
            try:
                title = " ".join(process.cmdline()).strip()
                if title.startswith("ray::") and "MapBatches" in title:
                    process.kill()
                    return title
            except psutil.Error:
                pass
        return None

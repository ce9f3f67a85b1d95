"""Plants of several sizes, each in one process and on a Ray of two workers: the same bytes, and what it takes (docs/FLEET.md).

``python python/tests/fleet_proof.py FOLDER --robots 10,100,1000``. In each run on Ray a worker is killed once parts begin to come.
"""

from __future__ import annotations

import argparse
import os
import pathlib
import sys
import time

os.environ["RAYON_NUM_THREADS"] = "1"

import fleet_faults  # noqa: E402
import fleet_plant  # noqa: E402

from driftpost import fleet  # noqa: E402

FIXTURES = pathlib.Path(__file__).resolve().parents[2] / "fixtures"
HEAD = "| robots | task | one process, s of processor | on Ray, s of processor | on Ray, s | rows/s on Ray | ms of processor a row | killed | bytes |"


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--robots", default="10,100,1000")
    args = parser.parse_args()
    print(f"{HEAD}\n| ---: | --- | ---: | ---: | ---: | ---: | ---: | --- | --- |", flush=True)
    is_same = True
    for robots in map(int, args.robots.split(",")):
        folder = args.folder / str(robots)
        folder.mkdir(parents=True)
        fleet_plant.weeks(folder, robots)
        is_same &= _both("diagnose", folder, robots, folder / "weeks" / "second.parquet")
        fleet_plant.programs(folder, robots, folder / "diagnose-one" / "results", FIXTURES)
        is_same &= _both("compensate", folder, robots, folder / "programs.parquet")
        is_same &= _both("watch", folder, robots, folder / "weeks")
    return 0 if is_same else 1


def _both(task: str, folder: pathlib.Path, robots: int, given: pathlib.Path) -> bool:
    one, many = folder / f"{task}-one", folder / f"{task}-ray"
    # A worker can only be killed in the middle where there are several tasks for it.
    rows_a_task = min(16, max(1, robots // 8))
    alone = _run(task, given, one, ray=False)
    killer = fleet_faults.Killer(many / "parts", after=2)
    killer.start()
    start = time.perf_counter()
    spread = _run(task, given, many, workers=2, rows_a_task=rows_a_task)
    wall = time.perf_counter() - start
    killer.ended.set()
    is_same = alone.files == spread.files and all(
        (one / "results" / name).read_bytes() == (many / "results" / name).read_bytes() for name in alone.files)
    killed = f"{killer.killed}, {spread.workers} processes" if killer.killed else "none was at work"
    print(f"| {robots} | {task} | {alone.cpu_s:.1f} | {spread.cpu_s:.1f} | {wall:.1f} | {robots / wall:.1f} | {1000 * alone.cpu_s / robots:.0f} "
          f"| {killed} | {'the same' if is_same else 'DIFFERENT'} |", flush=True)
    return is_same


def _run(task: str, given: pathlib.Path, to: pathlib.Path, **how) -> fleet.Summary:
    if task == "watch":
        return fleet.watch(str(given), str(to), **how)[0]
    return fleet.run({"diagnose": fleet.DIAGNOSE, "compensate": fleet.COMPENSATE}[task], str(given), str(to), **how)


if __name__ == "__main__":
    sys.exit(main())

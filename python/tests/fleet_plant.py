"""A plant of synthetic robots: two weeks of measurements by ``driftpost synth``, and a program for each robot."""

from __future__ import annotations

import csv
import datetime
import json
import pathlib

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq

from driftpost import _driftpost
from driftpost.fleet import _layout as layout

JOINTS = (2, 3, 4, 5)
SIGMA_MM = 0.02
FIRST_WEEK = datetime.datetime(2026, 11, 9, 6, tzinfo=datetime.timezone.utc)


def weeks(folder: pathlib.Path, robots: int, changed_every: int = 5) -> None:
    """Writes ``weeks/first.parquet`` and ``weeks/second.parquet``: a set of 30 poses for each robot and week, a row each.

    ``synth`` makes two plants with one seed, so that poses, instrument and tool are the same: one whose offset of a joint is hardly
    there, one where it moves the TCP by 0.2 mm rms. In the second week every ``changed_every``-th robot is of the latter. Noise is added here,
    anew in each week: synth's own would be the same in both.
    """
    rows = {"first": [], "second": []}
    for group, joint in enumerate(JOINTS):
        serials = range(group, robots, len(JOINTS))
        if not serials:
            continue
        plants = {}
        for name, rho in (("still", 0.01), ("moved", 200.0)):
            made = folder / f"synth-{joint}-{name}"
            words = ["synth", made, "--effects", f"joint_offset:{joint}", "--rho", rho, "--sigma-mm", 0.001, "--n", 30, "--seed", 100 + joint,
                     "--sets", len(serials)]
            code, _, said = _driftpost.command([str(word) for word in words])
            assert code == 0, said
            plants[name] = made
        for number, serial in enumerate(serials):
            is_changed = serial % changed_every == 0
            for week, name in (("first", "still"), ("second", "moved" if is_changed else "still")):
                file = plants[name] / f"set_{number:04d}" / "measurements.csv"
                rows[week].append((serial, set_of(file, serial, week)))
    (folder / "weeks").mkdir()
    for week, found in rows.items():
        table = [row for _, row in sorted(found, key=lambda pair: pair[0])]
        pq.write_table(pa.Table.from_pylist(table, pa.schema({**layout.SETS, **layout.SETS_OPTIONAL})), folder / "weeks" / f"{week}.parquet")


def set_of(file: pathlib.Path, serial: int, week: str) -> dict:
    """A set of measurements as a row, with noise of its own."""
    noise = np.random.default_rng([serial, week == "second"])
    with open(file, newline="") as text:
        found = list(csv.DictReader(text))
    columns = {name: [float(row[name]) for row in found] for name in found[0] if name in layout.NUMBERS}
    columns |= {name: [float(row[f"{name}_mm"]) + SIGMA_MM * noise.standard_normal() for row in found] for name in "xyz"}
    at = FIRST_WEEK + datetime.timedelta(days=7 * (week == "second"), minutes=serial)
    return {"layout_version": layout.LAYOUT_VERSION, "robot_serial": f"140-{serial:06d}", "robot": "irb140", "set_id": f"{at:%G-W%V}",
            "measured_at": at, "time_base": "cold_start", "sensor": "laser tracker, synthetic", "unit": "mm", "sigma_mm": SIGMA_MM, **columns}


def programs(folder: pathlib.Path, robots: int, diagnosis: pathlib.Path, fixtures: pathlib.Path) -> None:
    """Writes ``programs.parquet``: a module for each robot, to be corrected for a drift of its own and for what its diagnosis found.

    Every 25th module is cut off in the middle.
    """
    found = {row["robot_serial"]: row for file in sorted(diagnosis.glob("results-*.parquet"))
             for row in pq.read_table(file, columns=["robot_serial", "verdict", "model", "model_hash"]).to_pylist()}
    module = (fixtures / "robodk" / "irc5" / "Cube45.mod").read_bytes()
    drift = list(csv.reader((fixtures / "paper" / "table2_deformation.csv").read_text().splitlines()))
    rows = []
    for serial in range(robots):
        name, share = f"140-{serial:06d}", 0.5 + (serial % 11) / 20
        own = [drift[0], *([repr(float(cell) * share) for cell in row] for row in drift[1:])]
        model = found[name] if found[name]["verdict"] == "explained" else {"model": None, "model_hash": None}
        rows.append({"layout_version": layout.LAYOUT_VERSION, "robot_serial": name, "robot": "irb140", "program_name": "cube",
                     "modules": [{"name": "Cube45.mod", "text": module[: len(module) // 2] if serial % 25 == 24 else module}],
                     "model": model["model"], "model_hash": model["model_hash"], "deformation": "".join(",".join(row) + "\n" for row in own),
                     "options": json.dumps({"tolerance_mm": 0.02, "growth": "two-stage:46"})})
    pq.write_table(pa.Table.from_pylist(rows, pa.schema({**layout.PROGRAMS, **layout.PROGRAMS_OPTIONAL})), folder / "programs.parquet")

"""A plant of 20 robots: what a row becomes, what is refused and how, and that a run goes on where it was cut off."""

import datetime
import hashlib
import html.parser
import json
import math
import os
import subprocess
import sys
import time

import fleet_plant
import pytest

import driftpost

pa = pytest.importorskip("pyarrow")
pq = pytest.importorskip("pyarrow.parquet")
fleet = pytest.importorskip("driftpost.fleet")

ROBOTS = 20


def results(folder):
    return pq.read_table(folder / "results").to_pylist()


def as_table(task, rows):
    return pa.Table.from_pylist(rows, pa.schema({**task.required, **task.optional}))


def test_the_diagnoses(plant):
    rows = results(plant / "diagnosed")
    assert [row["robot_serial"] for row in rows] == [f"140-{n:06d}" for n in range(ROBOTS)]
    changed = [n for n, row in enumerate(rows) if row["verdict"] == "explained"]
    assert changed == [0, 5, 10, 15]
    # Robot n has its offset in joint 2 + n mod 4 (fleet_plant), 0.2 mm rms of each coordinate: the distance is 0.2 sqrt(3).
    for n in changed:
        best = max(rows[n]["causes"], key=lambda cause: cause["posterior"])
        assert (best["effect"], best["joint"]) == ("joint_offset", fleet_plant.JOINTS[n % 4])
        assert rows[n]["after_rms_mm"] < 0.06 < 0.2 < rows[n]["before_rms_mm"]
    assert all(row["model_hash"] == hashlib.sha256(row["model"].encode()).hexdigest() for row in rows)


def test_a_corrected_program_is_that_of_compensate(plant):
    row = pq.read_table(plant / "programs.parquet").to_pylist()[5]
    made = results(plant / "compensated")[5]
    alone = driftpost.compensate({"Cube45.mod": row["modules"][0]["text"]}, model=row["model"], deformation=row["deformation"],
                                 tolerance_mm=0.02, growth="two-stage:46")
    assert made["files"] == [{"name": "Cube45.mod", "text": alone.files["Cube45.mod"]}]
    assert made["worst_after_mm"] == alone.summary["worst_after_mm"] <= 0.02 < made["worst_before_mm"]
    text = alone.files["Cube45.mod"]
    assert made["result_hash"] == hashlib.sha256(f"10 {len(text)} Cube45.mod".encode() + text).hexdigest()
    assert len(made["motions"]) == 46 and all(motion["max_correction_mm"] is not None for motion in made["motions"])


def test_what_is_refused_is_a_row_with_its_code(plant):
    rows = pq.read_table(plant / "programs.parquet").to_pylist()
    spoilt = [
        ({"robot": "/home/cell/robot.toml"}, "fleet::robot"),
        ({"robot": "irb9"}, "robot::unknown"),
        ({"robot": "not a robot\n"}, "robot::"),
        ({"model": "model.toml", "model_hash": None}, "fleet::column"),
        ({"model_hash": "00"}, "fleet::model-hash"),
        ({"options": "{"}, "fleet::options"),
        ({"options": '{"output": "/tmp/x"}'}, "fleet::options"),
        ({"options": '{"tolerance_mm": -1}'}, ""),
        ({"options": '{"tolerance_mm": {"a": 1}}'}, "option::usage"),
        ({"modules": []}, "input::no-modules"),
        ({"modules": [{"name": "A.mod", "text": b"MODULE A\nENDMODULE\n"}] * 2}, "fleet::column"),
        ({"modules": [{"name": "../A.mod", "text": b"no module"}]}, "input::"),
        ({"modules": [{"name": "A.mod", "text": b"\xff\x00"}]}, "input::"),
    ]
    table = as_table(fleet.COMPENSATE, [rows[0], *({**rows[0], **change} for change, _ in spoilt), rows[1]])
    made = fleet.apply(fleet.COMPENSATE, table).to_pylist()
    assert made[0]["status"] == made[-1]["status"] == "done"
    for row, (change, code) in zip(made[1:-1], spoilt, strict=True):
        assert row["status"] == "refused" and row["message"] and row["files"] is None, (change, row)
        assert row["code"].startswith(code), (change, row["code"], row["message"])
    cut = fleet.apply(fleet.COMPENSATE, as_table(fleet.COMPENSATE, [{**rows[0], "modules": [{"name": "A.mod", "text": b"MODULE A\n PROC main()\n"}]}]))
    assert [cut[name][0].as_py() for name in ("code", "file", "line")] == ["input::truncated", "A.mod", 1]


def test_sets_that_cannot_be_read(plant):
    row = pq.read_table(plant / "weeks" / "second.parquet").slice(0, 1).to_pylist()[0]
    spoilt = [
        ({"unit": "cm"}, "fleet::unit"),
        ({"time_base": "utc"}, "fleet::time-base"),
        ({"x": row["x"][:-1]}, "fleet::length"),
        ({name: None for name in fleet.DIAGNOSE.optional}, "fleet::length"),
        ({"q3_deg": None}, "measure::"),
        ({"x": [math.nan] * 30}, "measure::"),
        ({"q1_deg": [None] * 30}, "measure::"),
    ]
    made = fleet.apply(fleet.DIAGNOSE, as_table(fleet.DIAGNOSE, [{**row, **change} for change, _ in spoilt])).to_pylist()
    for one, (change, code) in zip(made, spoilt, strict=True):
        assert one["status"] == "refused" and one["code"].startswith(code), (change, one["code"], one["message"])


@pytest.mark.parametrize("unit, mm", [("m", 1000.0), ("inch", 25.4)])
def test_lengths_are_in_the_unit_that_the_row_names(plant, unit, mm):
    row = pq.read_table(plant / "weeks" / "second.parquet").slice(5, 1).to_pylist()[0]
    other = {**row, "unit": unit, **{name: [value / mm for value in row[name]] for name in "xyz"}}
    first, second = fleet.apply(fleet.DIAGNOSE, as_table(fleet.DIAGNOSE, [row, other])).to_pylist()
    assert second["before_rms_mm"] == pytest.approx(first["before_rms_mm"], rel=1e-6) and second["verdict"] == first["verdict"] == "explained"


def test_a_fault_of_ours_is_a_row_too(plant):
    import dataclasses

    def work(row):
        raise RuntimeError("no such thing") if row["robot_serial"].endswith("1") else driftpost.DriftpostError("refused", "x::y")

    row, = fleet.apply(dataclasses.replace(fleet.DIAGNOSE, work=work), pq.read_table(plant / "weeks" / "second.parquet").slice(1, 1)).to_pylist()
    assert (row["status"], row["code"], row["message"]) == ("failed", "fleet::failed", "RuntimeError: no such thing")


@pytest.mark.parametrize("change, code, told", [
    (lambda table: table.drop_columns("robot_serial"), "fleet::column", "robot_serial"),
    (lambda table: table.drop_columns("layout_version"), "fleet::column", "layout_version"),
    (lambda table: table.set_column(0, "layout_version", pa.array([2] * ROBOTS)), "fleet::layout-version", "layout_version holds 2"),
    (lambda table: table.set_column(0, "layout_version", pa.array([1] * (ROBOTS - 1) + [None])), "fleet::column", "layout_version has 1 rows"),
    (lambda table: table.set_column(0, "layout_version", pa.array(["1"] * ROBOTS)), "fleet::type", "layout_version holds string"),
    (lambda table: table.append_column("robot", table["robot"]), "fleet::column", "robot is there 2 times"),
    (lambda table: table.drop_columns("sigma_mm").append_column("sigma_mm", pa.array(["0.02"] * ROBOTS)), "fleet::type", "sigma_mm holds string"),
    (lambda table: table.drop_columns("x").append_column("x", pa.array([1.0] * ROBOTS)), "fleet::type", "x holds double"),
    (lambda table: table.drop_columns("measured_at").append_column("measured_at", pa.array(["2026"] * ROBOTS)), "fleet::type", "measured_at"),
])
def test_a_table_of_another_layout_is_refused_with_the_column(plant, tmp_path, change, code, told):
    file = tmp_path / "sets.parquet"
    pq.write_table(change(pq.read_table(plant / "weeks" / "second.parquet")), file)
    with pytest.raises(driftpost.DriftpostError) as caught:
        fleet.run(fleet.DIAGNOSE, str(file), str(tmp_path / "out"), ray=False)
    assert caught.value.code == code and told in str(caught.value) and "sets.parquet" in str(caught.value)


def test_files_that_cannot_be_read_or_written(plant, tmp_path):
    (tmp_path / "text.parquet").write_text("no Parquet")
    (tmp_path / "empty").mkdir()
    good = str(plant / "weeks" / "second.parquet")
    for given, to, code in ((tmp_path / "nowhere", "out", "input::missing"), (tmp_path / "empty", "out", "input::missing"),
                            (tmp_path / "text.parquet", "out", "input::unreadable"), (good, "text.parquet", "output::unwritable")):
        with pytest.raises(driftpost.DriftpostError) as caught:
            fleet.run(fleet.DIAGNOSE, str(given), str(tmp_path / to), ray=False)
        assert caught.value.code == code, caught.value


def test_a_run_that_was_cut_off_goes_on_where_it_was(plant, tmp_path):
    import dataclasses
    seen = []

    def until(n):
        def work(row):
            if len(seen) == n:
                raise KeyboardInterrupt
            seen.append(row["robot_serial"])
            return fleet.DIAGNOSE.work(row)
        return dataclasses.replace(fleet.DIAGNOSE, work=work)

    weeks = tmp_path / "weeks"
    weeks.mkdir()
    table = pq.read_table(plant / "weeks" / "second.parquet")
    for part in range(2):
        pq.write_table(table.slice(10 * part, 10), weeks / f"{part}.parquet")
    out = tmp_path / "out"
    with pytest.raises(KeyboardInterrupt):
        fleet.run(until(12), str(weeks), str(out), ray=False, rows_a_task=5)
    parts = sorted((out / "parts").iterdir(), key=lambda part: pq.read_table(part)["robot_serial"][0].as_py())
    assert len(parts) == 2 and not (out / "run.json").exists()
    # What a machine that went down in the middle may leave: a file unfinished, and one that lost its end.
    left, written_to = (out / "parts" / f"unfinished-{n}-part-2.parquet" for n in (1, 2))
    for path, age_s in ((left, 4000), (written_to, 5)):
        path.write_bytes(parts[0].read_bytes())
        os.utime(path, (time.time() - age_s,) * 2)
    parts[1].write_bytes(parts[1].read_bytes()[:-100])
    seen.clear()
    summary = fleet.run(until(99), str(weeks), str(out), ray=False)
    assert summary.skipped == 5 and seen == [f"140-{n:06d}" for n in range(5, 20)]
    assert (out / "results" / "results-00000.parquet").read_bytes() == (plant / "diagnosed" / "results" / "results-00000.parquet").read_bytes()
    # What was written to just now is another run's.
    assert list((out / "parts").glob("unfinished-*")) == [written_to]
    assert json.loads((out / "run.json").read_text())["files"] == summary.files
    again = fleet.run(until(99), str(weeks), str(out), ray=False)
    assert again.skipped == 20 and again.files == summary.files and len(seen) == 15


def test_a_key_is_of_all_that_a_row_holds(plant):
    row = pq.read_table(plant / "programs.parquet").to_pylist()[0]
    other = [{**row, "robot_serial": "x"}, {**row, "model": None}, {**row, "options": None}, {**row, "program_name": "y"},
             {**row, "modules": [{"name": "Cube45.mod", "text": row["modules"][0]["text"] + b" "}]}]
    assert len({fleet.COMPENSATE.key(one) for one in [row, *other]}) == 6


def test_one_thread_or_two_give_the_same_bytes(plant, tmp_path):
    made = []
    for threads in "12":
        words = [sys.executable, "-m", "driftpost.fleet", "compensate", str(plant / "programs.parquet"), str(tmp_path / threads), "--serial", "--json", "-"]
        done = subprocess.run(words, env={**os.environ, "RAYON_NUM_THREADS": threads}, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        made.append(json.loads(done.stdout)["files"])
    assert made[0] == made[1] == fleet.run(fleet.COMPENSATE, str(plant / "programs.parquet"), str(plant / "compensated"), ray=False).files


def test_exit_codes_and_what_is_said(plant, tmp_path, capsys):
    from driftpost.fleet.__main__ import main
    out = str(tmp_path / "out")
    assert main(["diagnose", str(tmp_path), out, "--serial"]) == 2
    assert "[input::missing]" in capsys.readouterr().err
    assert main(["watch", str(plant / "weeks"), out, "--serial"]) == 1
    said = capsys.readouterr().out.splitlines()
    assert len(said) == 5 and said[-1].startswith("4 changed, 16 as they were, 0 not compared")
    assert sorted(line.split(":")[0] for line in said[:4]) == [f"140-{n:06d}" for n in (0, 5, 10, 15)]
    rows = results(tmp_path / "out")
    assert [row["changed"] for row in rows] == [n % 5 == 0 for n in range(ROBOTS)]
    # Twice the noise of one week by two weeks, three coordinates: sqrt(6) * 0.02, of which base and tool take a part.
    assert all(0.02 < row["rms_mm"] < 0.06 for row in rows if not row["changed"])


def test_the_set_of_a_week_before_is_the_nearest_one():
    def one(serial, day, name):
        at = datetime.datetime(2026, 11, day, tzinfo=datetime.timezone.utc)
        return {"layout_version": 1, "robot_serial": serial, "robot": "irb140", "set_id": name, "measured_at": at, "time_base": "none", "sensor": "s", "unit": "mm"}

    sets = [one("b", 20, "now"), one("b", 14, "six"), one("b", 1, "long ago"), one("b", 19, "yesterday"), one("a", 20, "alone"),
            one("c", 20, "now"), one("c", 20, "now too")]
    made = fleet.pairs(as_table(fleet.DIAGNOSE, sets)).select(["robot_serial", "before_set_id", "after_set_id"]).to_pylist()
    assert [tuple(row.values()) for row in made] == [("a", None, "alone"), ("b", "six", "now"), ("c", None, "now too")]
    told = fleet.apply(fleet.WATCH, fleet.pairs(as_table(fleet.DIAGNOSE, sets)).slice(0, 1)).to_pylist()[0]
    assert (told["status"], told["code"]) == ("refused", "fleet::one-set")


def test_the_page_holds_no_address_and_no_markup_of_others():
    bad = '<script src="https://example.org/x.js">alert(1)</script>'
    row = {"robot_serial": bad, "status": "done", "changed": True, "verdict": bad, "rms_mm": 0.5, "noise_rms_mm": 0.1, "ratio": 5.0, "before_set": bad,
           "after_set": bad, "causes": [{"effect": bad, "joint": 2, "posterior": 0.9, "slot": 1}], "sensor_changed": True, "model_changed": False}
    lost = {"robot_serial": bad, "status": "refused", "code": bad, "message": bad}
    ranked = fleet.Ranked()
    ranked.add(pa.Table.from_pylist([row, {**row, "robot_serial": "second", "ratio": 4.0}, lost], fleet.WATCH.results))
    text = fleet.page(ranked, 7)
    tags, attributes, open_tags = set(), set(), []

    class Reader(html.parser.HTMLParser):
        def handle_starttag(self, tag, attrs):
            tags.add(tag)
            attributes.update(name for name, _ in attrs)
            if tag != "meta":
                open_tags.append(tag)

        def handle_endtag(self, tag):
            assert open_tags.pop() == tag

    Reader().feed(text)
    assert not open_tags and not tags & {"script", "link", "img", "iframe", "a"} and not attributes & {"src", "href", "onclick"}
    assert text.count("&lt;script src=") == 10 and text.index("&lt;script") < text.index(">second<")


def test_a_page_of_many_robots_holds_the_most_changed():
    rows = [{"robot_serial": f"{n:05d}", "status": "done", "changed": True, "rms_mm": 1.0, "ratio": float(n), "causes": []} for n in range(1500)]
    ranked = fleet.Ranked()
    for start in range(0, 1500, 500):
        ranked.add(pa.Table.from_pylist(rows[start:start + 500], fleet.WATCH.results))
    text = fleet.page(ranked, 7)
    assert "500 more stand in the table alone" in text and ">01499<" in text and ">00500<" in text and ">00499<" not in text


def test_the_page_of_the_documentation(fixtures, tmp_path, monkeypatch, capsys):
    import re

    from driftpost.fleet.__main__ import main
    (tmp_path / "fixtures").symlink_to(fixtures)
    monkeypatch.chdir(tmp_path)
    writes, reads = re.findall(r"```python\n(.*?)```", (fixtures.parent / "docs" / "FLEET.md").read_text(), re.DOTALL)
    names = {}
    exec(writes, names)
    assert main(["compensate", "programs.parquet", "compensated", "--serial"]) == 0
    told = [[message["code"] for message in row["messages"]] for row in results(tmp_path / "compensated")]
    assert all("fleet::default-table" in codes for codes in told), told
    exec(reads, names)
    said = [line.split() for line in capsys.readouterr().out.splitlines()]
    assert [line[:3] for line in said] == [["140-1", "done", "None"], ["140-2", "done", "None"]] and all(float(line[3]) <= 0.02 for line in said)


def test_a_set_without_a_model_has_its_verdict(plant, tmp_path):
    """Five poses are too few, and that is an answer: the row is done, and holds no model."""
    table = pq.read_table(plant / "weeks" / "second.parquet").slice(0, 1).to_pylist()
    row = {name: value[:5] if isinstance(value, list) and len(value or []) > 20 else value for name, value in table[0].items()}
    given = tmp_path / "few.parquet"
    pq.write_table(pa.Table.from_pylist([row], pq.read_schema(plant / "weeks" / "second.parquet")), given)
    fleet.run(fleet.DIAGNOSE, str(given), str(tmp_path / "out"), ray=False)
    found, = pq.read_table(tmp_path / "out" / "results").to_pylist()
    assert (found["status"], found["verdict"], found["model"]) == ("done", "insufficient_data", None), found


def test_a_part_that_is_damaged_is_named(plant, tmp_path):
    out = tmp_path / "out"
    given = str(plant / "weeks" / "second.parquet")
    fleet.run(fleet.DIAGNOSE, given, str(out), ray=False)
    part = next((out / "parts").iterdir())
    whole = part.read_bytes()
    middle = len(whole) // 2
    part.write_bytes(whole[:middle] + bytes(byte ^ 85 for byte in whole[middle:middle + 400]) + whole[middle + 400:])
    with pytest.raises(driftpost.DriftpostError) as caught:
        fleet.run(fleet.DIAGNOSE, given, str(out), ray=False)
    assert caught.value.code == "fleet::damaged-part" and part.name in str(caught.value)
    part.unlink()
    assert fleet.run(fleet.DIAGNOSE, given, str(out), ray=False).refused == 0


@pytest.mark.parametrize("days", ["nan", "inf", "-1", "0", "1e12", "soon"])
def test_days_that_are_none(days, tmp_path):
    from driftpost.fleet.__main__ import main

    with pytest.raises(SystemExit) as caught:
        main(["watch", str(tmp_path), str(tmp_path / "out"), "--days", days])
    assert caught.value.code == 2

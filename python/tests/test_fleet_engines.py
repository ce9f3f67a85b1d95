"""A fleet on Ray and on Spark: the bytes of one process, a worker killed in the middle, a row that no worker survives."""

import sys
from functools import partial

import fleet_faults
import pytest

import driftpost

pa = pytest.importorskip("pyarrow")
pq = pytest.importorskip("pyarrow.parquet")
fleet = pytest.importorskip("driftpost.fleet")


@pytest.fixture(scope="module")
def ray():
    found = pytest.importorskip("ray")
    found.cloudpickle.register_pickle_by_value(fleet_faults)
    return found


def test_a_worker_killed_in_the_middle_changes_no_byte(ray, plant, tmp_path):
    killer = fleet_faults.Killer(tmp_path / "out" / "parts", after=2)
    killer.start()
    summary = fleet.run(fleet.DIAGNOSE, str(plant / "weeks" / "second.parquet"), str(tmp_path / "out"), workers=2, rows_a_task=3)
    killer.ended.set()
    assert killer.killed and summary.skipped == summary.refused == 0
    assert _bytes(tmp_path / "out") == _bytes(plant / "diagnosed")


def test_a_row_that_kills_its_worker_takes_no_other_with_it(ray, plant, tmp_path):
    out = tmp_path / "out"
    summary = fleet.run(fleet_faults.POISONED, str(plant / "weeks" / "second.parquet"), str(out), workers=2, rows_a_task=5)
    expected = pq.read_table(plant / "diagnosed" / "results").to_pylist()
    made = pq.read_table(out / "results").to_pylist()
    assert summary.refused == 1 and (made[3]["robot_serial"], made[3]["status"], made[3]["code"]) == (fleet_faults.POISON, "failed", "fleet::worker-died")
    assert made[:3] + made[4:] == expected[:3] + expected[4:]
    # It is no result: the next run comes to it again, and to it alone.
    again = fleet.run(fleet.DIAGNOSE, str(plant / "weeks" / "second.parquet"), str(out), ray=False)
    assert again.skipped == 19 and _bytes(out) == _bytes(plant / "diagnosed")


def test_workers_that_cannot_write_say_so(ray, plant, tmp_path, monkeypatch):
    (tmp_path / "out" / "parts").mkdir(parents=True)
    monkeypatch.setattr("driftpost.fleet._store.Store.prepare", lambda store: (tmp_path / "out" / "parts").rmdir())
    with pytest.raises(driftpost.DriftpostError) as caught:
        fleet.run(fleet.COMPENSATE, str(plant / "programs.parquet"), str(tmp_path / "out"), workers=2)
    assert caught.value.code == "output::unwritable"


def test_record_batches_as_spark_hands_them_over(plant):
    table = pq.read_table(plant / "programs.parquet")
    made = pa.Table.from_batches(fleet.batches(fleet.COMPENSATE, table.to_batches(max_chunksize=7)))
    assert made == pq.read_table(plant / "compensated" / "results")


def test_spark(plant, monkeypatch):
    """Only where pyspark and a Java are installed; the tests do not bring them."""
    types = pytest.importorskip("pyspark.sql.pandas.types")
    from pyspark.sql import SparkSession
    monkeypatch.setenv("PYSPARK_PYTHON", sys.executable)
    spark = SparkSession.builder.master("local[2]").config("spark.ui.enabled", "false").config("spark.driver.bindAddress", "127.0.0.1").config(
        "spark.sql.session.timeZone", "UTC").config("spark.executorEnv.RAYON_NUM_THREADS", "1").getOrCreate()
    try:
        rows = spark.read.parquet(str(plant / "programs.parquet")).repartition(4)
        rows.mapInArrow(partial(fleet.batches, fleet.COMPENSATE), types.from_arrow_schema(fleet.COMPENSATE.results)).write.parquet(str(plant / "spark"))
    finally:
        spark.stop()
    made = pq.read_table(plant / "spark").select(fleet.COMPENSATE.results.names).to_pylist()
    made.sort(key=lambda row: row["robot_serial"])
    assert made == pq.read_table(plant / "compensated" / "results").to_pylist()


def _bytes(out):
    return [path.read_bytes() for path in sorted((out / "results").iterdir())]

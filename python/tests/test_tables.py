"""Tables from and to pandas, polars, pyarrow and DuckDB, none of which is needed."""

import subprocess
import sys

import numpy as np
import pytest

import driftpost

duckdb = pytest.importorskip("duckdb")
pandas = pytest.importorskip("pandas")
polars = pytest.importorskip("polars")
pyarrow = pytest.importorskip("pyarrow")

READERS = {
    "pandas": lambda path: pandas.read_csv(path),
    "polars": lambda path: polars.read_csv(path, infer_schema_length=None),
    "pyarrow": lambda path: pyarrow.Table.from_pandas(pandas.read_csv(path)),
    "duckdb": lambda path: duckdb.read_csv(str(path)),
}


@pytest.fixture(scope="module")
def measured(pytestconfig):
    return pytestconfig.rootpath / "fixtures" / "measurements" / "r2000ic"


@pytest.fixture(scope="module")
def expected(measured):
    return driftpost.diagnose(measured / "measurements.csv", robot=measured / "robot.toml")


def test_a_diagnosis(expected, measured):
    assert len(expected.causes) >= 1 and expected.causes.column_names[0] == "effect"
    # The report that the library's own test compares word by word, numbers to 2 %.
    wanted = (measured / "expected.txt").read_text().split()
    said = expected.report().split()
    assert len(said) >= len(wanted) - 5 and said[:8] == wanted[:8]
    assert len(expected.residuals) == len((measured / "measurements.csv").read_text().splitlines()) - 1


@pytest.mark.parametrize("rows, verdict", [(5, "insufficient_data"), (60, "data_fault")])
def test_a_diagnosis_without_a_model(measured, rows, verdict):
    """What the command line says with exit 0 is no exception: the verdict and the data are there, and no model."""
    table = (measured / "measurements.csv").read_text().splitlines()[: rows + 1]
    if verdict == "data_fault":
        columns = table[0].split(",")
        x = columns.index("x_mm")
        cells = [line.split(",") for line in table[1:]]
        for row in cells:
            row[x] = repr(float(row[x]) / 25.4)
        table[1:] = [",".join(row) for row in cells]
    found = driftpost.diagnose("\n".join(table) + "\n", robot=measured / "robot.toml")
    assert (found.verdict, found.model, found.data["verdict"]) == (verdict, None, verdict), found.report()
    assert found.report() and len(found.residuals) in (0, rows)


def test_ids_come_back_as_they_were_written(measured):
    rows = pandas.read_csv(measured / "measurements.csv")
    names = ["3_4", "34", "007", "7", "1e3", "nan", "+5", *(f"p{k}" for k in range(len(rows) - 7))]
    text = rows.assign(id=names, pose_id=range(len(rows))).to_csv(index=False)
    found = driftpost.diagnose(text, robot=measured / "robot.toml")
    residuals = pyarrow.table(found.residuals).to_pydict()
    assert residuals["id"] == names
    assert all(isinstance(number, float) for number in residuals["before_x_mm"])


@pytest.mark.parametrize("library", READERS)
def test_every_library_gives_the_same_diagnosis(library, measured, expected):
    table = READERS[library](measured / "measurements.csv")
    found = driftpost.diagnose(table, robot=str(measured / "robot.toml"))
    assert found.verdict == expected.verdict
    assert pyarrow.table(found.causes).column("effect").to_pylist() == pyarrow.table(expected.causes).column("effect").to_pylist()
    ratio = found.data["shrink"]["after_rms_mm"] / expected.data["shrink"]["after_rms_mm"]
    assert ratio == pytest.approx(1, abs=1e-6)


def test_every_library_reads_what_comes_out(cube):
    motions = driftpost.compensate(cube, tolerance_mm=0.02).motions
    frame = pandas.DataFrame.from_arrow(motions) if hasattr(pandas.DataFrame, "from_arrow") else pyarrow.table(motions).to_pandas()
    assert len(frame) == 46 and frame["max_correction_mm"].max() > 0.1
    assert polars.DataFrame(motions)["max_correction_mm"].max() == frame["max_correction_mm"].max()
    arrow = pyarrow.table(motions)
    assert arrow.schema.field("line").type == pyarrow.int64() and arrow.num_rows == 46
    assert duckdb.sql("select max(max_correction_mm) from motions").fetchall()[0][0] == frame["max_correction_mm"].max()


def test_a_fit_goes_into_a_compensation(fixtures, cube):
    touches = fixtures / "first_day" / "touches.csv"
    fit = driftpost.fit(touches, tool=(0, 0, 100))
    assert {"t_min", "joint", "dx_mm"} <= set(fit.table.column_names)
    by_table = driftpost.compensate(cube, deformation=fit.table, tau_cool=fit.data["tau_cool_min"], tolerance_mm=0.02)
    assert 0.02 < by_table.summary["worst_before_mm"] < 0.5
    assert driftpost.compensate(cube, model=fit.model, tolerance_mm=0.02).text


def test_a_model_is_validated(measured, expected):
    figures = driftpost.validate(measured / "measurements.csv", expected.model, robot=measured / "robot.toml")
    assert figures["n"] == 24 and figures["rms_mm"] < figures["nominal"]["rms_mm"]


def test_a_plan():
    plan = driftpost.plan(n=24, seed=3)
    assert len(plan.poses) == 24 and "MODULE" in plan.rapid and plan.template.count("\n") >= 24
    assert {f"q{j}_deg" for j in range(1, 7)} <= set(plan.poses.column_names)


@pytest.mark.parametrize("table, code", [
    (pandas.DataFrame({"q1_deg": [0.0]}), "measure::"),
    (pandas.DataFrame(), "measure::"),
    (polars.DataFrame({"q1_deg": [[1, 2]]}), "table::type"),
    (pyarrow.table({f"q{i}_deg": [float("nan")] for i in range(1, 7)} | {"x_mm": [1.0], "y_mm": [1.0], "z_mm": [1.0]}), "measure::"),
    ({"q1_deg": [1]}, "option::usage"),
    (None, "option::usage"),
    (np.zeros((3, 6)), "option::usage"),
    ("nowhere.csv", "input::missing"),
])
def test_bad_tables(table, code):
    with pytest.raises(driftpost.DriftpostError) as caught:
        driftpost.diagnose(table)
    assert caught.value.code.startswith(code), caught.value


def test_none_of_them_is_needed():
    """The package works where numpy is all there is."""
    program = (
        "import sys\n"
        "class Gone:\n"
        "    def find_spec(self, name, path=None, target=None):\n"
        "        if name.split('.')[0] in ('pandas', 'polars', 'pyarrow', 'duckdb'): raise ImportError(name)\n"
        "sys.meta_path.insert(0, Gone())\n"
        "import driftpost\n"
        "print(len(driftpost.plan(n=24).poses), driftpost.Robot.load('irb120').name)\n"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert done.returncode == 0 and done.stdout.startswith("24 "), done.stderr

"""Programs through the library as users give them, and what is refused."""

import os
import pickle
import subprocess
import sys
import sysconfig
import threading

import numpy as np
import pytest

import driftpost

# Of the reference paper's robot and the cube of 45, as the library's own documentation says: 0.19 mm become 0.005.
FAST = {"tolerance_mm": 0.02}


def test_a_program_is_compensated(cube):
    result = driftpost.compensate(cube, robot="irb140")
    assert 0.19 < result.summary["worst_before_mm"] < 0.20
    assert result.summary["worst_after_mm"] < 0.0051
    assert result.text.count("{tcK()}") == 46
    assert result.diff.startswith("--- ") and "46 motions: 46 compensated" in result.report()
    assert len(result.motions) == 46 and {"file", "line", "kind", "status", "max_correction_mm"} <= set(result.motions.column_names)
    assert len(result.buckets) > 5
    assert not [message for message in result.messages if message.severity == "error"]


def test_paths_texts_dicts_and_folders_are_the_same_program(cube, tmp_path):
    text = cube.read_bytes()
    (tmp_path / "cell").mkdir()
    (tmp_path / "cell" / "Cube45.mod").write_bytes(text)
    given = [str(cube), [cube], {"a/Cube45.mod": text}, {"Cube45.mod": text.decode()}, tmp_path / "cell"]
    made = {driftpost.compensate(program, **FAST).text for program in given}
    assert len(made) == 1

    def code(result):
        return [line for line in result.splitlines() if not line.lstrip().startswith("!")]

    for nameless in (text, text.decode()):
        # The comment block names the file, and holds a digest of all lines.
        assert code(driftpost.compensate(nameless, **FAST).text) == code(next(iter(made)))
    assert sorted(os.listdir(tmp_path / "cell")) == ["Cube45.mod"], "nothing is written"


def test_options_have_their_names_of_the_command_line(cube):
    result = driftpost.compensate(cube, form="ramp", growth="two-stage:46", start_joints=(0, 0, 0, 0, 30, 0), keep_moveabsj=True,
                                  strict=False, until=None, robot=driftpost.Robot.load("irb140"), tool=["t1=[TRUE,[[0,0,1],[1,0,0,0]],[1,[0,0,1],[1,0,0,0],0,0,0]]"])
    assert "tcAt(" in result.text
    import pyarrow
    rows = pyarrow.table(result.motions).to_pylist()
    assert [row["reason"] is not None for row in rows].count(True) == 1, "the joint move is kept"


def test_numbers_and_arrays_of_numpy_are_options_and_tuples_are_lists_of_names(cube):
    joints = (0, 0, 0, 0, 30, 0)
    plain = driftpost.compensate(cube, form="ramp", start_joints=joints, tolerance_mm=0.0625)
    for start in (np.array(joints), tuple(np.array(joints, float)), tuple(np.array(joints)), list(joints), list(np.array(joints))):
        made = driftpost.compensate(cube, form="ramp", start_joints=start, tolerance_mm=np.float32(0.0625))
        assert made.text.splitlines()[-40:] == plain.text.splitlines()[-40:]
    assert driftpost.plan(n=np.int64(24)).poses.column_names
    with pytest.raises(driftpost.DriftpostError, match="p1"):
        driftpost.compensate(cube, keep=("p1", "p2"))


def test_the_corrected_program_stands_where_it_should(cube):
    result = driftpost.compensate(cube, **FAST)
    found = driftpost.simulate(result.text, cube, minutes=[0, 30, 600], tolerance_mm=0.025)
    assert found.within and len(found.passes) == 3 and "mm" in found.report()
    original = driftpost.simulate(cube, cube, minutes=600, deformation=None)
    assert not original.within
    assert 0.18 < original.data["worst"]["mm"] < 0.20


def test_several_modules(fixtures):
    cell = fixtures / "golden" / "two_tools_loop" / "source"
    result = driftpost.compensate(cell, core="separate", tolerance_mm=0.05)
    assert any(path.endswith("tcCore.mod") for path in result.files)
    with pytest.raises(driftpost.DriftpostError, match="take them from files"):
        result.text


@pytest.mark.parametrize("program, code", [
    ("hello\nworld", "input::no-module"),
    (b"", "input::empty"),
    (b"M\0O\0D\0", "input::binary"),
    ("MODULE A\n PROC main()\n", "input::truncated"),
    ("MODULE A\nENDMODULE\n", "compensate::no-motion"),
    ("no/such/file.mod", "input::missing"),
    ({}, "input::no-modules"),
    ({"a.mod": 7}, "option::usage"),
    ({"a.mod": "MODULE A\nENDMODULE\n", "b.mod": "MODULE A\nENDMODULE\n"}, "input::module-twice"),
    (None, "option::usage"),
    (3.5, "option::usage"),
    ([1, 2], "option::usage"),
    ([], "input::no-modules"),
])
def test_bad_programs(program, code):
    with pytest.raises(driftpost.DriftpostError) as caught:
        driftpost.compensate(program)
    assert caught.value.code.startswith(code), caught.value


def test_the_place_is_told():
    text = "MODULE A\n\n PROC main()\n"
    with pytest.raises(driftpost.DriftpostError) as caught:
        driftpost.compensate({"cell/A.mod": text})
    error = caught.value
    assert (error.code, error.file) == ("input::truncated", "cell/A.mod")
    assert error.line in (1, 3) and error.help
    again = pickle.loads(pickle.dumps(error))
    assert (again.code, again.file, again.line, str(again)) == (error.code, error.file, error.line, str(error))


@pytest.mark.parametrize("options, code", [
    ({"tolerance_mm": float("nan")}, ""),
    ({"tolerance_mm": -1}, ""),
    ({"tolerance_mm": "much"}, "option::usage"),
    ({"tolerence_mm": 1}, "option::usage"),
    ({"form": "spiral"}, "option::usage"),
    ({"task": ["TASK1=irb140"]}, "option::usage"),
    ({"robot": "irb2400"}, "robot::coupled"),
    ({"robot": 140}, "robot::"),
    ({"deformation": 5}, "option::usage"),
    ({"deformation": "a,b\n1,2\n", "growth": "none"}, "deform::"),
    ({"model": "no model\n"}, "model::"),
    ({"output": "x"}, "option::usage"),
    ({"json": "-"}, "option::usage"),
    ({"keep": {"a": 1}}, "option::usage"),
    ({"max_correction_mm": 0.01}, "refuse::"),
])
def test_bad_options(cube, options, code):
    with pytest.raises(driftpost.DriftpostError) as caught:
        driftpost.compensate(cube, **{**FAST, **options} if "tolerance_mm" not in options else options)
    assert caught.value.code.startswith(code) and "::" in caught.value.code, caught.value


def test_progress_is_called_and_what_it_raises_ends_the_work(fixtures):
    cell = fixtures / "golden" / "pages" / "source"
    seen = []
    driftpost.compensate(cell, progress=lambda done, files: seen.append((done, files)), tolerance_mm=0.05)
    assert [done for done, _ in seen] == list(range(1, len(seen) + 1)) and len(seen) >= 2
    assert all(done <= files for done, files in seen)

    def stop(done, files):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        driftpost.compensate(cell, progress=stop, tolerance_mm=0.05)


def test_threads_do_not_disturb_each_other(cube):
    made = []
    threads = [threading.Thread(target=lambda: made.append(driftpost.compensate(cube, **FAST).text)) for _ in range(4)]
    [thread.start() for thread in threads]
    [thread.join() for thread in threads]
    assert len(made) == 4 and len(set(made)) == 1


def test_the_command_line_comes_with_it(cube, tmp_path):
    program = os.path.join(sysconfig.get_path("scripts"), "driftpost")
    for start in ([program], [sys.executable, "-m", "driftpost"]):
        done = subprocess.run([*start, "--version"], capture_output=True, text=True)
        assert (done.returncode, done.stdout.strip()) == (0, f"driftpost {driftpost.__version__}")
        out = tmp_path / f"{len(start)}.mod"
        done = subprocess.run([*start, "compensate", str(cube), "-o", str(out), "--tolerance-mm", "0.02"], capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        assert out.read_text() == driftpost.compensate(cube, **FAST).text
        assert subprocess.run([*start, "compensate", "nothing.mod"], capture_output=True).returncode == 2

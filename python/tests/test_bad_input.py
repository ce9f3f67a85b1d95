"""Whatever is given: a result, or DriftpostError with a code and the place; never another exception, never an abort."""

import subprocess
import sys

import numpy as np
import pytest

import driftpost

MODULE = "MODULE A\n PROC main()\n  MoveJ [[400,0,500],[0.5,0,0.8660254,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0;\n ENDPROC\nENDMODULE\n"
LONE = "a\ud800b"  # half of a pair: text in Python, but of no file and no command line


class NoStream:
    def __init__(self, given):
        self.given = given

    def __arrow_c_stream__(self, requested_schema=None):
        if isinstance(self.given, Exception):
            raise self.given
        return self.given


def numbers(**changed):
    """A table of measurements as CSV text, 12 rows of an arm at rest but for what is changed."""
    names = [*(f"q{j}_deg" for j in range(1, 7)), "x_mm", "y_mm", "z_mm"]
    row = [0, 0, 0, 0, 30, 0, 515, 0, 712]
    lines = [",".join(str(changed.get(name, value)) for name, value in zip(names, row))] * 12
    return "\n".join([",".join(names), *lines]) + "\n"


@pytest.mark.parametrize("call, code, place", [
    # programs
    (lambda: driftpost.compensate(MODULE.replace("MODULE", "MODUL")), "input::no-module", "program.mod"),
    (lambda: driftpost.compensate({7: MODULE}), "option::usage", "int"),
    (lambda: driftpost.compensate({"a.mod": LONE + MODULE}), "option::usage", "a.mod"),
    (lambda: driftpost.compensate({LONE: MODULE}), "option::usage", "name"),
    (lambda: driftpost.compensate("a\0b.mod"), "option::usage", "a\\x00b.mod"),
    (lambda: driftpost.compensate(LONE), "option::usage", "program"),
    (lambda: driftpost.compensate(bytearray(MODULE, "ascii")), "option::usage", "bytearray"),
    (lambda: driftpost.compensate(np.zeros((3, 6))), "option::usage", "ndarray"),
    (lambda: driftpost.compensate(MODULE, progress=3), "option::usage", "progress"),
    (lambda: driftpost.compensate(MODULE, keep=LONE), "option::usage", "keep"),
    # What a diagnosis gives that could make no model; not the reference paper's arm in its place.
    (lambda: driftpost.compensate(MODULE, model=None), "model::none", "no deformation"),
    (lambda: driftpost.compensate(MODULE, payload_kg=5), "option::usage", "--model <FILE>"),
    (lambda: driftpost.compensate(MODULE, form="Ramp"), "option::usage", "possible values: schedule, ramp, live, auto"),
    (lambda: driftpost.validate(numbers(), None), "option::usage", "--model <FILE>"),
    (lambda: driftpost.compensate(MODULE, start_joints=(0, 0, float("nan"), 0, 30, 0)), "", ""),
    (lambda: driftpost.simulate({"a\0.mod": MODULE}), "option::usage", "a\\x00.mod"),
    (lambda: driftpost.simulate({7: MODULE}), "option::usage", "int"),
    (lambda: driftpost.simulate({"../../out.mod": MODULE}), "input::unreadable", "../../out.mod"),
    (lambda: driftpost.simulate(MODULE, minutes=["soon"]), "option::usage", "minutes"),
    (lambda: driftpost.simulate(MODULE, minutes=[None]), "option::usage", "minutes"),
    (lambda: driftpost.simulate(MODULE, minutes=[float("nan")]), "", ""),
    (lambda: driftpost.simulate("no module\nat all\n"), "simulate::load", "] program.mod does not load"),
    # measurements
    (lambda: driftpost.diagnose(numbers(q3_deg="nan")), "measure::", "] measurements.csv: no row has both joints and a reading; the first that lacks one is line 2, column q3_deg"),
    (lambda: driftpost.diagnose(numbers(x_mm="much")), "measure::", "x_mm"),
    (lambda: driftpost.diagnose(numbers(z_mm="1e400")), "measure::", "z_mm"),
    (lambda: driftpost.diagnose(numbers(), tool="long"), "option::usage", "tool"),
    (lambda: driftpost.diagnose(numbers(), tool=80), "option::usage", "tool"),
    (lambda: driftpost.diagnose(numbers(), tool=(0, 0, float("inf"))), "", ""),
    (lambda: driftpost.diagnose(numbers(), tool=(0, 0)), "", ""),
    (lambda: driftpost.diagnose(numbers(), sigma_mm=-1), "", ""),
    (lambda: driftpost.diagnose(LONE + "\n"), "option::usage", "measurements.csv"),
    (lambda: driftpost.diagnose(NoStream(5)), "table::type", "measurements.csv"),
    (lambda: driftpost.diagnose(NoStream(RuntimeError("the disk is gone"))), "table::type", "the disk is gone"),
    (lambda: driftpost.fit("hello\nworld\n", tool=(0, 0, 100)), "measure::", ""),
    (lambda: driftpost.validate(numbers(), None), "", ""),
    (lambda: driftpost.validate(numbers(), "no model\n"), "model::", ""),
    (lambda: driftpost.plan(n=-3), "option::usage", ""),
    (lambda: driftpost.plan(n=float("nan")), "option::usage", ""),
    # robots
    (lambda: driftpost.Robot.load(5), "option::usage", "int"),
    (lambda: driftpost.Robot.load(LONE), "option::usage", "robot"),
    (lambda: driftpost.Robot.load("irb140").fk_deformed(np.zeros(6), 1, deformation=5, growth="none"), "option::usage", "deformation"),
    (lambda: driftpost.Robot.load("irb140").fk_deformed(np.zeros(6), 1, growth=5), "option::usage", "growth"),
    (lambda: driftpost.Robot.load("irb140").fk_deformed(np.zeros(6), "soon"), "array::shape", "t_min"),
    (lambda: driftpost.Robot.load("irb140").fk_deformed(np.zeros(6), 1, deformation="a,b\n1,2\n", growth="none"), "deform::", ""),
])
def test_bad_input(call, code, place):
    with pytest.raises(driftpost.DriftpostError) as caught:
        call()
    error = caught.value
    assert "::" in error.code and error.code.startswith(code) and error.code != "run::failed", error
    assert place in str(error), error


def test_a_process_goes_on_after_bad_input():
    """In a process of its own: an abort would take the tests along. Random bytes as programs, tables, models and robots."""
    program = (
        "import random, driftpost\n"
        "draw, robot = random.Random(7), driftpost.Robot.load('irb140')\n"
        "words = [b'MODULE A', b'PROC main()', b'MoveL p1,v100,fine,tool0;', b'ENDPROC', b'ENDMODULE', b'q1_deg,x_mm', b'[[', b'9E9', b'\\xff\\x00', b'nan,inf', b'name = 1', b'[[joint]]', b'\\n', b'\"']\n"
        "def text(): return b' '.join(draw.choice(words) if draw.random() < 0.9 else draw.randbytes(9) for _ in range(draw.randrange(1, 40))) + b'\\n'\n"
        "jobs = [driftpost.compensate, driftpost.diagnose, driftpost.fit, lambda t: driftpost.simulate(t, t), lambda t: driftpost.validate(t, t),\n"
        "        lambda t: driftpost.compensate('MODULE A\\nENDMODULE\\n', deformation=t, growth='none'), lambda t: robot.fk_deformed([0] * 6, 1, deformation=t.decode('latin-1'), growth='none')]\n"
        "refused = 0\n"
        "for _ in range(300):\n"
        "    for job in jobs:\n"
        "        try: job(text())\n"
        "        except driftpost.DriftpostError as error:\n"
        "            assert '::' in error.code\n"
        "            refused += 1\n"
        "print('alive', refused)\n"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert done.returncode == 0 and done.stdout.startswith("alive"), (done.returncode, done.stderr[-2000:])


def test_the_built_in_table_of_another_arm_is_said_to_be_one():
    with pytest.warns(UserWarning, match="IRB 140"):
        driftpost.Robot.load("irb1200").fk_deformed(np.zeros(6), 1)

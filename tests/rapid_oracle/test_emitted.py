"""Corrected programs, executed by the Python interpreter: the clock's arithmetic and the targets that the functions give.

The corrected program holds the clock (dates, seconds, logarithms), functions and tables that `driftpost compensate` wrote. What it makes of a
minute or of a share of the drift must be the same in both interpreters.
"""

import datetime
import os
import pathlib
import subprocess
import tempfile
import unittest

from judged import simulated, verdict
from machine import Machine

ROOT = pathlib.Path(__file__).resolve().parents[2]
CUBE = ROOT / "fixtures" / "robodk" / "irc5" / "Cube45.mod"
FEW = """MODULE Few
  PERS tooldata tGun:=[TRUE,[[0,0,120],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]];
  CONST jointtarget jHome:=[[0,10,20,0,50,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget pFirst:=[[430,40,220],[0,0,1,0],[0,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget pTurned:=[[470,40,220],[0,0.1736482,0.9848078,0],[0,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  VAR robtarget pPick;
  PROC main()
    MoveAbsJ jHome,v500,z10,tGun;
    FOR i FROM 0 TO 7 DO
      FOR j FROM 0 TO 3 DO
        MoveL Offs(pFirst,i*6,j*9,0),v100,z1,tGun;
      ENDFOR
    ENDFOR
    pPick:=pTurned;
    IF pPick.trans.x>500 pPick:=pFirst;
    MoveL pPick,v100,fine,tGun;
  ENDPROC
ENDMODULE
"""
FIXTURES = {  # the repository's own programs that need neither signals nor the arm's position, with where they start
    "cell/conf_off.mod": "main",
    "cell/counting.mod": "main",
    "cell/quadrants.mod": "main",
    "cell/set_on_the_pendant.mod": "main",
    "first_day/Pins.mod": "rpins",
    "golden/arrays_offs/expected/Pallet.mod": "pick",
    "golden/cube4/expected/Cube4.mod": "cube45",
    "golden/cube4_ramp/expected/Cube4.mod": "cube45",
    "golden/named_targets/expected/Schweissen.mod": "main",
    "golden/stationary_tool/expected/Grind.mod": "grind",
}
MINUTES = (0, 0.25, 1, 7.5, 40, 62.5, 120, 240, 600)


def emitted(form, program=CUBE):
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / program.name
        subprocess.run([os.environ["DRIFTPOST"], "compensate", program, "--form", form, "-o", out, "--quiet"], check=True, capture_output=True)
        return out.read_text(encoding="latin-1")


def running_since(text, minute):
    """The corrected program's machine, so many minutes after a cold start, having asked every four."""
    machine = Machine(text)
    start = machine.now
    machine.started("tccoldstart")
    for past in [*range(4, int(minute), 4), minute]:
        machine.now = start + datetime.timedelta(minutes=past)
        machine.started("tcupdate")
    return machine


@unittest.skipUnless("DRIFTPOST" in os.environ, "DRIFTPOST does not name the program under test")
class Emitted(unittest.TestCase):
    def test_the_clock_is_the_same_to_the_last_bit(self):
        """From half past ten in the evening of 27 February, so over midnight and over the end of a month."""
        text = emitted("ramp")
        for minute in MINUTES:
            with self.subTest(minute):
                machine = running_since(text, minute)
                _, found, complaints = simulated([text], machine.started("cube45"), entry="Cube45", minute=minute)
                self.assertIsNotNone(found, complaints)
                self.assertEqual(machine.globals["tcminute"].value, found["program_min"])
                # Both against the true minute: series and roots of single precision lose some of its digits.
                self.assertAlmostEqual(found["program_min"], minute, delta=1e-5 * minute + 1e-4)

    def test_a_share_of_the_drift(self):
        text = emitted("ramp")
        for share in (0, 12.5, 50, 100):
            with self.subTest(share):
                machine = Machine(text)
                machine.globals["tcmode"].value = float(share)
                motions = machine.started("cube45")
                self.assertEqual(len(motions), 46)
                self.assertIsNone(verdict([text], motions, "--set", f"tcMode={share}", entry="Cube45"))

    def test_one_of_a_few_targets(self):
        """A hash of the pose says which one: whole parts of a sum, a remainder, an index."""
        with tempfile.TemporaryDirectory() as folder:
            source = pathlib.Path(folder) / "Few.mod"
            source.write_text(FEW)
            text = emitted("ramp", source)
        self.assertEqual(text.count("MoveL tcAtOne("), 2)
        machine, plain = Machine(text), Machine(FEW)
        machine.globals["tcmode"].value = 70.0
        motions, plainly = machine.started("main"), plain.started("main")
        self.assertEqual((len(motions), len(plainly)), (34, 34))
        self.assertIsNone(verdict([text], motions, "--set", "tcMode=70"))
        self.assertIn("off by", verdict([text], plainly, "--set", "tcMode=70"))

    def test_a_bucket_by_the_clock(self):
        text = emitted("schedule")
        for minute in (5, 40, 62.5, 300):
            with self.subTest(minute):
                motions = running_since(text, minute).started("cube45")
                self.assertEqual(len(motions), 46)
                self.assertIsNone(verdict([text], motions, entry="Cube45", minute=minute))

    def test_programs_of_the_fixtures(self):
        """Corrected ones with tcMode 1: bucket 1, or one per cent of the drift."""
        for name, entry in FIXTURES.items():
            with self.subTest(name):
                text = (ROOT / "fixtures" / name).read_text(encoding="latin-1")
                machine, options = Machine(text), []
                if "tcmode" in machine.globals:
                    machine.globals["tcmode"].value = 1.0
                    options = ["--set", "tcMode=1"]
                motions = machine.started(entry)
                self.assertGreater(len(motions), 1)
                self.assertIsNone(verdict([text], motions, *options, entry=entry))

    def test_another_share_is_noticed(self):
        """The comparison can fail: half the drift is not the whole."""
        text = emitted("ramp")
        machine = Machine(text)
        machine.globals["tcmode"].value = 50.0
        self.assertIn("off by", verdict([text], machine.started("cube45"), "--set", "tcMode=100", entry="Cube45"))


if __name__ == "__main__":
    unittest.main()

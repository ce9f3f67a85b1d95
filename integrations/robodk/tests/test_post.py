"""The post-processor without RoboDK: programs as RoboDK hands them over, replayed through an installed post and ours on top.

Run from anywhere with `python -m unittest discover -s integrations/robodk/tests`; DRIFTPOST names the program under test.
"""

import contextlib
import importlib
import importlib.util
import io
import os
import pathlib
import re
import shutil
import sys
import tempfile
import unittest
import unittest.mock
import warnings

HERE = pathlib.Path(__file__).resolve().parent
POST = HERE.parent / "ABB_RAPID_IRC5_driftpost.py"
EXPORT = HERE.parents[2] / "fixtures" / "robodk" / "irc5" / "Cube45.mod"
CUBE = (HERE / "cube45.py").read_text()


def installed(folder):
    """The post of a folder, as RoboDK has it in its folder Posts; the tests' robodk.py serves both."""
    for name in ("ABB_RAPID_IRC5", "ABB_RAPID_IRC5_driftpost"):
        sys.modules.pop(name, None)
    sys.path[:] = [path for path in sys.path if not path.startswith(str(HERE))]
    sys.path.insert(0, str(HERE / "posts_2017"))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # backslashes of 2017
        sys.modules["posts_2017_robodk"] = importlib.import_module("robodk")
        sys.path.insert(0, str(HERE / folder))
        return importlib.import_module("ABB_RAPID_IRC5")


class Replay(unittest.TestCase):
    def setUp(self):
        self.assertIn("DRIFTPOST", os.environ, "DRIFTPOST must name the program under test")
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        shutil.copy(POST, self.folder)
        self.settings('tolerance-mm = 0.02\n')

    def settings(self, text):
        (pathlib.Path(self.folder) / "ABB_RAPID_IRC5_driftpost.toml").write_text(text)

    def post(self, folder):
        """Ours, as a copy in its own folder with its settings beside it."""
        installed(folder)
        spec = importlib.util.spec_from_file_location("post", os.path.join(self.folder, POST.name))
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        return module

    def replay(self, folder, program=CUBE, **options):
        module = self.post(folder)
        robot = module.RobotPost("ABB_RAPID_IRC5_driftpost", "ABB IRB 140-6/0.8", 6, **options)
        exec(program, {**vars(module), "robot": robot})
        robot.ProgSave(self.folder, "Cube45")
        return robot

    def text(self, name):
        return (pathlib.Path(self.folder) / name).read_text(encoding="latin-1")

    def test_the_corrected_file_takes_the_place_of_the_original(self):
        robot = self.replay("posts_2017")
        self.assertEqual(robot.PROG_FILES, [os.path.join(self.folder, "Cube45_tc", "Cube45.mod")])
        self.assertIn("46 motions: 46 compensated", robot.LOG)
        self.assertEqual(self.text("Cube45_tc/Cube45.mod").count("{tcK()}"), 46)
        # What the installed post writes is what RoboDK exports, and stays.
        self.assertEqual(self.text("Cube45.mod"), EXPORT.read_text(encoding="latin-1"))

    def test_a_newer_posts_style(self):
        robot = self.replay("newer_post")
        self.assertEqual(robot.PROG_FILES, [os.path.join(self.folder, "Cube45_tc", "Cube45.modx")])
        original, made = self.text("Cube45.modx"), self.text("Cube45_tc/Cube45.modx")
        self.assertTrue(original.startswith("%%%\n  VERSION:1\n  LANGUAGE:ENGLISH\n%%%\nMODULE MOD_Cube45\n"))
        self.assertEqual(made.count("{tcK()},v250,z1,Tool1 \\WObj:=Frame2;"), 46)

    def test_a_style_of_its_own_changes_no_corrected_number(self):
        self.replay("posts_2017")
        first = self.corrected("Cube45_tc/Cube45.mod")[1:]  # its joint move comes first
        self.replay("newer_post")
        second = self.corrected("Cube45_tc/Cube45.modx")[1:]
        self.assertEqual((len(first), len(second)), (45, 45))
        far = [abs(float(a) - float(b)) for p, q in zip(first, second) for a, b in zip(p.split(","), q.split(","))]
        self.assertLess(max(far), 0.001)  # quaternions of 6 decimals

    def test_the_joints_make_the_branch_certain(self):
        # Without configurations and without a joint move first the text does not tell the branch: cfx 0 is the wrong one.
        lines = [line.replace("[0.0, 0.0, 1.0])", "None)") for line in CUBE.splitlines()]
        program = "\n".join(line for line in lines if not line.startswith("robot.MoveJ"))
        self.settings('tolerance-mm = 0.02\njson-is-no-setting = 1\n')
        robot = self.replay("posts_2017", program)
        self.assertEqual(robot.PROG_FILES, [])
        self.assertIn("settings::unknown", robot.LOG)

        self.settings('tolerance-mm = 0.02\n')
        self.replay("posts_2017")
        known = self.corrected("Cube45_tc/Cube45.mod")[1:]  # without the joint move
        robot = self.replay("posts_2017", program)
        self.assertIn("45 motions: 45 compensated", robot.LOG)
        self.assertNotIn("conf::unchecked", robot.LOG)
        hinted = self.corrected("Cube45_tc/Cube45.mod")
        self.assertEqual(len(hinted), 45)
        self.assertEqual(hinted, known[-45:])

    def corrected(self, name):
        """The last element's position of each array of targets."""
        arrays = re.split(r"LOCAL CONST (?:rob|joint)target tc", self.text(name))[1:]
        return [re.findall(r"\[\[(-?[\d.]+,-?[\d.]+,-?[\d.]+)", array.split("];")[0])[-1] for array in arrays]

    def test_pages_go_together(self):
        robot = self.replay("newer_post", lines_x_prog=20)
        names = [os.path.basename(path) for path in robot.PROG_FILES]
        self.assertEqual(names, ["Cube45.modx", "Cube451.modx", "Cube452.modx", "tcCore.modx"])
        self.assertTrue(all(os.path.isfile(path) for path in robot.PROG_FILES))

    def test_an_arc_has_two_rows(self):
        def arc(line):
            pose, joints = line.split("MoveL(")[1].split("), [")[0] + ")", "[" + line.split("), [")[1].split("], ")[0] + "]"
            return pose, joints

        lines = CUBE.splitlines()
        first = next(i for i, line in enumerate(lines) if "MoveL" in line)
        (p1, j1), (p2, j2) = arc(lines[first + 1]), arc(lines[first + 6])
        lines[first + 1:-1] = [f"robot.MoveC({p1}, {j1}, {p2}, {j2})"]
        robot = self.replay("posts_2017", "\n".join(lines))
        self.assertEqual(len(robot.PROG_FILES), 1, robot.LOG)
        self.assertIn("3 motions: 3 compensated", robot.LOG)

    def test_joints_that_are_not_known_leave_a_row_empty_and_too_few_are_not_used(self):
        lines = CUBE.splitlines()
        some = next(i for i, line in enumerate(lines) if "MoveL" in line) + 3
        lines[some] = re.sub(r"\), \[.*?\], \[0", "), [], [0", lines[some])
        robot = self.replay("posts_2017", "\n".join(lines))
        self.assertIn("46 motions: 46 compensated", robot.LOG)
        self.assertNotIn("hint::", robot.LOG)

        module = self.post("posts_2017")
        robot = module.RobotPost("ABB_RAPID_IRC5_driftpost", "ABB IRB 140-6/0.8", 6)
        exec(CUBE, {**vars(module), "robot": robot})
        robot._joints.pop()  # as after a post that writes a move that it was not told
        robot.ProgSave(self.folder, "Cube45")
        self.assertIn("warning[hint::order]", robot.LOG)
        self.assertIn("46 motions: 46 compensated", robot.LOG)
        self.assertEqual(len(robot.PROG_FILES), 1)

    def test_a_refusal_leaves_nothing_to_send(self):
        self.settings('max-correction-mm = 0.01\n')
        robot = self.replay("posts_2017")
        self.assertEqual(robot.PROG_FILES, [])
        self.assertIn("nothing was written", robot.LOG)
        self.assertIn("refuse", robot.LOG)
        self.assertTrue(os.path.isfile(os.path.join(self.folder, "Cube45.mod")))
        self.assertFalse(os.path.exists(os.path.join(self.folder, "Cube45_tc", "Cube45.mod")))
        sent = []
        robot.ProgSendRobot.__globals__["InstalledPost"].ProgSendRobot = lambda *args: sent.append(args)
        robot.ProgSendRobot("192.0.2.1", "/", "", "")
        self.assertEqual(sent, [])
        robot.PROG_FILES = ["x"]
        robot.ProgSendRobot("192.0.2.1", "/", "", "")
        self.assertEqual(len(sent), 1)

    def test_joints_of_another_robot_are_refused(self):
        self.settings('robot = "irb120"\nallow-other-robot = true\ntolerance-mm = 0.02\n')
        robot = self.replay("posts_2017")
        self.assertEqual(robot.PROG_FILES, [])
        self.assertIn("hint::pose", robot.LOG)

    def test_without_the_program_nothing_is_sent(self):
        module = self.post("posts_2017")
        module.driftpost = lambda: None
        robot = module.RobotPost("x", "y", 6)
        exec(CUBE, {**vars(module), "robot": robot})
        robot.ProgSave(self.folder, "Cube45")
        self.assertEqual(robot.PROG_FILES, [])
        self.assertIn("neither beside this post nor on the PATH", robot.LOG)

    def test_a_program_that_cannot_be_run_leaves_nothing_to_send(self):
        for path in (os.path.join(self.folder, "none"), self.folder):
            with unittest.mock.patch.dict(os.environ, {"DRIFTPOST": path}):
                robot = self.replay("posts_2017")
            self.assertEqual(robot.PROG_FILES, [])
            self.assertIn("cannot be run", robot.LOG)

    def test_that_there_are_no_settings_is_said(self):
        (pathlib.Path(self.folder) / "ABB_RAPID_IRC5_driftpost.toml").unlink()
        self.assertIn("those of the reference paper", self.replay("posts_2017").LOG)

    def test_the_corrected_file_alone_is_named_as_saved(self):
        def saved():
            printed = io.StringIO()
            with contextlib.redirect_stdout(printed):
                self.replay("posts_2017")
            return re.findall(r"^SAVED: (.*)$", printed.getvalue(), re.M)

        self.assertEqual(saved(), [os.path.join(self.folder, "Cube45_tc", "Cube45.mod")])
        self.settings('max-correction-mm = 0.01\n')
        self.assertEqual(saved(), [])


if __name__ == "__main__":
    unittest.main()

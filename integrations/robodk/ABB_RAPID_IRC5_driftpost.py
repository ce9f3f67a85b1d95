"""RoboDK post-processor: what the installed ABB post writes, corrected for thermal drift by driftpost.

Put this file and ABB_RAPID_IRC5_driftpost.toml into RoboDK's folder Posts, and choose it for the robot. The program driftpost is
found beside this file, on the PATH, or where the environment variable DRIFTPOST says. Options of `driftpost compensate` stand in the
TOML file. Where driftpost refuses, the originals stay on disk, nothing is left to be sent to the robot, and the log says why.
"""

import contextlib
import io
import os
import shutil
import subprocess

from ABB_RAPID_IRC5 import *  # what RoboDK's programs use of a post: Pose, Mat, ...
from ABB_RAPID_IRC5 import RobotPost as InstalledPost

HERE = os.path.dirname(os.path.abspath(__file__))
SETTINGS = os.path.join(HERE, "ABB_RAPID_IRC5_driftpost.toml")


def driftpost():
    """Path of the program, or None."""
    beside = os.path.join(HERE, "driftpost.exe" if os.name == "nt" else "driftpost")
    return os.environ.get("DRIFTPOST") or (beside if os.path.isfile(beside) else shutil.which("driftpost"))


class RobotPost(InstalledPost):
    """The installed post; the joints of all targets are kept, as the text of linear moves has none."""

    def __init__(self, *args, **kwargs):
        super().__init__(*args, **kwargs)
        self.PROG_FILES, self._joints = [], []

    def MoveJ(self, pose, joints, *args, **kwargs):
        self._joints.append(joints)
        super().MoveJ(pose, joints, *args, **kwargs)

    def MoveL(self, pose, joints, *args, **kwargs):
        self._joints.append(joints)
        super().MoveL(pose, joints, *args, **kwargs)

    def MoveC(self, pose1, joints1, pose2, joints2, *args, **kwargs):
        self._joints += [joints1, joints2]
        super().MoveC(pose1, joints1, pose2, joints2, *args, **kwargs)

    def ProgSave(self, folder, progname, ask_user=False, show_result=False, *args, **kwargs):
        said = io.StringIO()
        try:
            with contextlib.redirect_stdout(said):
                super().ProgSave(folder, progname, ask_user, False, *args, **kwargs)
        finally:
            # RoboDK goes on with the files that are named so: with the corrected ones.
            lines = said.getvalue().splitlines(keepends=True)
            print("".join(line for line in lines if not line.startswith("SAVED:")), end="")
        if self.PROG_FILES:  # else the user has cancelled
            originals, self.PROG_FILES = list(self.PROG_FILES), []
            self.PROG_FILES = self._compensated(originals, progname)
        for path in self.PROG_FILES:
            print("SAVED: %s\n" % path, flush=True)
        for path in self.PROG_FILES if show_result else []:
            if isinstance(show_result, (str, list)):
                subprocess.Popen(([show_result] if isinstance(show_result, str) else show_result) + [path])
            elif os.name == "nt":
                os.startfile(path)
        if show_result and self.LOG:
            mbox("Program generation LOG:\n\n" + self.LOG)

    def ProgSendRobot(self, *args, **kwargs):
        if self.PROG_FILES:
            super().ProgSendRobot(*args, **kwargs)
        else:
            self._say("driftpost: nothing was sent to the robot")

    def _compensated(self, files, progname):
        """The corrected files in place of the originals; none where driftpost refuses."""
        if driftpost() is None:
            self._say("driftpost: the program is neither beside this post nor on the PATH; nothing will be sent")
            return []
        output = os.path.join(os.path.dirname(os.path.abspath(files[0])), progname + "_tc")
        made = [os.path.join(output, os.path.basename(path)) for path in files]
        where = made[0] if len(made) == 1 else os.path.join(output, "")
        command = [driftpost(), "compensate", *files, "-o", where, "--diff", "none", "--joints-hint", "-"]
        if os.path.isfile(SETTINGS):
            command += ["--settings", SETTINGS]
        else:
            self._say("driftpost: %s is not there: robot and deformation are those of the reference paper" % SETTINGS)
        targets = [list(joints)[:6] if joints else [""] * 6 for joints in self._joints]
        rows = [["q%i_deg" % axis for axis in range(1, 7)], *targets]
        hint = "".join(",".join(map(str, row)) + "\n" for row in rows)
        try:
            done = subprocess.run(command, input=hint.encode(), stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                  creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0))
        except OSError as error:
            self._say("driftpost: %s cannot be run (%s); nothing will be sent" % (driftpost(), error))
            return []
        self._say(done.stdout.decode("utf-8", "replace"))
        if done.returncode != 0:
            self._say("driftpost: refused; the originals stay, and nothing will be sent")
            return []
        # Programs of several pages share one clock; what else lies there is of another day.
        core = os.path.join(output, "tcCore" + os.path.splitext(made[0])[1])
        return made + [core] if len(made) > 1 and os.path.isfile(core) else made

    def _say(self, text):
        print(text)
        self.LOG += text.rstrip() + "\n"

"""A stand-in for the ABB post of newer RoboDK versions, which is compiled: written anew, with the documented methods, and writing
what exports of version 5.9 look like: no blank line behind the header, tabs, CR LF, station names, the frame in oframe, .modx.
"""

import math
import os

from posts_2017_robodk import Mat, Pose_2_ABB

EXT = "[9E+09,9E+09,9E+09,9E+09,9E+09,9E+09]"


def numbers(values, decimals):
    return "[" + ",".join("%.*f" % (decimals, value) for value in values) + "]"


def pose_text(pose):
    values = Pose_2_ABB(pose)
    return numbers(values[:3], 3) + "," + numbers(values[3:], 6)


class RobotPost:
    MAX_LINES_X_PROG = 20000
    PROG_EXT = "modx"

    def __init__(self, robotpost=None, robotname=None, robot_axes=6, **kwargs):
        self.PROG_FILES, self.LOG, self.data, self.moves = [], "", [], []
        self.MAX_LINES_X_PROG = kwargs.get("lines_x_prog", self.MAX_LINES_X_PROG)

    def ProgStart(self, progname):
        self.name = progname

    def ProgFinish(self, progname):
        pass

    def ProgSave(self, folder, progname, ask_user=False, show_result=False):
        pages = [self.moves[i:i + self.MAX_LINES_X_PROG] for i in range(0, len(self.moves), self.MAX_LINES_X_PROG)]
        for k, moves in enumerate(pages):
            name = progname if k == 0 else "%s%i" % (progname, k)
            lines = ["%%%", "  VERSION:1", "  LANGUAGE:ENGLISH", "%%%", "MODULE MOD_" + name]
            lines += self.data if k == 0 else []
            lines += ["\tPROC %s()" % name, "\t\tConfJ \\On;", "\t\tConfL \\Off;", *moves, "\tENDPROC", "ENDMODULE"]
            path = os.path.join(folder, name + "." + self.PROG_EXT)
            with open(path, "w", newline="") as out:
                out.write("\r\n".join(lines) + "\r\n")
            self.PROG_FILES.append(path)

    def MoveJ(self, pose, joints, conf_RLF=None):
        self.moves.append("\t\tMoveAbsJ [%s,%s],v250,z1,Tool1 \\WObj:=Frame2;" % (numbers(joints, 6), EXT))

    def MoveL(self, pose, joints, conf_RLF=None):
        self.moves.append("\t\tMoveL %s,v250,z1,Tool1 \\WObj:=Frame2;" % self.target(pose, joints, conf_RLF))

    def MoveC(self, pose1, joints1, pose2, joints2, conf_RLF_1=None, conf_RLF_2=None):
        targets = self.target(pose1, joints1, conf_RLF_1) + "," + self.target(pose2, joints2, conf_RLF_2)
        self.moves.append("\t\tMoveC %s,v250,z1,Tool1 \\WObj:=Frame2;" % targets)

    def target(self, pose, joints, conf):
        rear, lower, flip = conf or [0, 0, 0]
        quadrants = [math.floor(joints[j] / 90) for j in (0, 3, 5)] + [int(4 * rear + 2 * lower + flip)]
        return "[%s,[%i,%i,%i,%i],%s]" % (pose_text(pose), *quadrants, EXT)

    def setFrame(self, pose, frame_id=None, frame_name=None):
        self.data.append('\tPERS wobjdata Frame2:=[FALSE,TRUE,"",[[0,0,0],[1,0,0,0]],[%s]];' % pose_text(pose))

    def setTool(self, pose, tool_id=None, tool_name=None):
        self.data.append("\tPERS tooldata Tool1:=[TRUE,[%s],[1,[0,0,50],[1,0,0,0],0,0,0]];" % pose_text(pose))

    def setSpeed(self, speed_mms):
        pass

    def RunMessage(self, message, iscomment=False):
        self.moves.append("\t\t! " + message)


def Pose(xyzrpw):
    x, y, z = xyzrpw[:3]
    (ca, sa), (cb, sb), (cc, sc) = [(math.cos(math.radians(a)), math.sin(math.radians(a))) for a in xyzrpw[3:]]
    return Mat([[cb * ca, ca * sc * sb - cc * sa, sc * sa + cc * ca * sb, x],
                [cb * sa, cc * ca + sc * sb * sa, cc * sb * sa - ca * sc, y], [-sb, cb * sc, cc * cb, z], [0, 0, 0, 1]])

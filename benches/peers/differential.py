"""Holds what `peers poses ROBOT COUNT` writes on standard input against pinocchio's forward kinematics and Jacobians.

The arm is put together from the lengths of RobotComponents, or else of a Denavit-Hartenberg table of others (fixtures/oracle); nothing of
driftpost's is in it.
Prints the largest differences: position (m), rotation (rad), the Jacobian's linear (m/rad) and angular rows.
"""

import csv
import pathlib
import sys

import numpy as np
import pinocchio as pin

NUMBERS = 54  # 6 joints, 9 of the rotation, 3 of the position, 36 of the Jacobian
AT_ONCE = 50_000


def row(table, robot):
    """A robot's first row in a table of fixtures/oracle, metres, where it stands there."""
    path = pathlib.Path(__file__).parents[2] / "fixtures/oracle" / table
    with path.open() as file:
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            if row.pop("robot") == robot:
                return {key[:-3]: float(value) / 1000 for key, value in row.items() if key.endswith("_mm")}
    return None


def lengths(robot):
    """Of Brandstötter's basis, with a3, the offset of axis 6 from axis 5."""
    if at := row("robotcomponents.csv", robot):
        return {**at, "a3": 0}
    if at := row("denavit_hartenberg.csv", robot):
        names = {"a1": at["a1"], "a2": -at["a3"], "a3": 0, "b": 0}
        return {**names, "c1": at["d1"], "c2": at["a2"], "c3": at["d4"], "c4": at["d6"]}
    if at := row("robotcomponents_offset_wrist.csv", robot):
        return at
    raise SystemExit(f"no robot {robot}")


def arm(robot):
    """Brandstötter's basis with the forearm level at zero; the flange looks along it."""
    at = lengths(robot)
    joints = [
        (pin.JointModelRZ(), [0, 0, at["c1"]]),
        (pin.JointModelRY(), [at["a1"], at["b"], 0]),
        (pin.JointModelRY(), [0, 0, at["c2"]]),
        (pin.JointModelRX(), [0, 0, -at["a2"]]),
        (pin.JointModelRY(), [at["c3"], 0, 0]),
        (pin.JointModelRX(), [0, 0, -at["a3"]]),
    ]
    model, last = pin.Model(), 0
    for i, (joint, place) in enumerate(joints):
        last = model.addJoint(last, joint, pin.SE3(np.eye(3), np.array(place, float)), f"joint{i + 1}")
    turned = np.array([[0.0, 0, 1], [0, 1, 0], [-1, 0, 0]])  # z of the flange along x of the forearm
    flange = pin.Frame("flange", last, 0, pin.SE3(turned, np.array([at["c4"], 0, 0])), pin.OP_FRAME)
    return model, model.addFrame(flange)


def main(robot):
    model, flange = arm(robot)
    data = model.createData()
    worst, count = np.zeros(4), 0
    while raw := sys.stdin.buffer.read(AT_ONCE * NUMBERS * 8):
        ours = np.frombuffer(raw, "<f8").reshape(-1, NUMBERS)
        theirs = np.empty((len(ours), NUMBERS - 6))
        for row, q in zip(theirs, np.ascontiguousarray(ours[:, :6])):
            pin.computeJointJacobians(model, data, q)
            pose = pin.updateFramePlacement(model, data, flange)
            row[:9] = pose.rotation.ravel()
            row[9:12] = pose.translation
            row[12:] = pin.getFrameJacobian(model, data, flange, pin.LOCAL_WORLD_ALIGNED).ravel()
        off = ours[:, 6:] - theirs
        # Of a rotation that is off by little: the Frobenius norm of the difference is the square root of two of the angle.
        found = [
            np.linalg.norm(off[:, 9:12], axis=1),
            np.linalg.norm(off[:, :9], axis=1) / np.sqrt(2),
            np.abs(off[:, 12:30]).max(axis=1),
            np.abs(off[:, 30:]).max(axis=1),
        ]
        assert all(np.isfinite(values).all() for values in found), "a number is missing"
        worst = np.maximum(worst, [values.max() for values in found])
        count += len(ours)
    print(robot, count, *(f"{value:.1e}" for value in worst))
    return count > 0 and (worst < [1e-13, 1e-13, 1e-13, 1e-13]).all()


if __name__ == "__main__":
    sys.exit(0 if main(sys.argv[1]) else 1)

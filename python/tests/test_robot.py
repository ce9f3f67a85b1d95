"""Kinematics against a forward kinematics of our own, written from the data sheet, and against RoboDK's joints."""

import csv
import pickle
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import driftpost

RNG = np.random.default_rng(7)


def rotation(axis, angle_deg):
    c, s = np.cos(np.radians(angle_deg)), np.sin(np.radians(angle_deg))
    turns = {"x": [[1, 0, 0], [0, c, -s], [0, s, c]], "y": [[c, 0, s], [0, 1, 0], [-s, 0, c]], "z": [[c, -s, 0], [s, c, 0], [0, 0, 1]]}
    pose = np.eye(4)
    pose[:3, :3] = turns[axis]
    return pose


def shift(x, y, z):
    pose = np.eye(4)
    pose[:3, 3] = x, y, z
    return pose


def irb140(q):
    """The IRB 140-6/0.8 of the data sheet: 352 up, 70 out, 360 upper arm, 380 forearm, 65 to the flange."""
    parts = [rotation("z", q[0]), shift(70, 0, 352), rotation("y", q[1]), shift(0, 0, 360), rotation("y", q[2]),
             rotation("x", q[3]), shift(380, 0, 0), rotation("y", q[4]), rotation("x", q[5]), shift(65, 0, 0), rotation("y", 90)]
    return np.linalg.multi_dot(parts)


@pytest.fixture
def robot():
    return driftpost.Robot.load("irb140")


@pytest.fixture
def q(robot):
    low, high = robot.ranges.T
    return RNG.uniform(low, high, (500, 6))


def test_forward(robot, q):
    expected = np.array([irb140(row) for row in q])
    np.testing.assert_allclose(robot.fk(q), expected, atol=1e-9)
    np.testing.assert_allclose(robot.fk(q[3]), expected[3], atol=1e-9)
    assert robot.fk(list(map(list, q[:2]))).shape == (2, 4, 4)
    assert robot.fk(np.empty((0, 6))).shape == (0, 4, 4)
    np.testing.assert_allclose(robot.fk(np.asfortranarray(q)[::-1]), expected[::-1], atol=1e-9)
    np.testing.assert_allclose(robot.fk(q.astype(np.float32)), expected, atol=1e-3)


def test_jacobian_is_the_derivative(robot, q):
    step = 1e-4
    for row in q[:20]:
        jacobian = robot.jacobian(row)
        for j in range(6):
            ahead, behind = row.copy(), row.copy()
            ahead[j], behind[j] = row[j] + step, row[j] - step
            a, b = irb140(ahead), irb140(behind)
            turn = (a[:3, :3] - b[:3, :3]) @ irb140(row)[:3, :3].T
            spin = np.array([turn[2, 1], turn[0, 2], turn[1, 0]])
            expected = np.concatenate([a[:3, 3] - b[:3, 3], spin]) / np.radians(2 * step)
            np.testing.assert_allclose(jacobian[:, j], expected, atol=1e-4)


def test_all_branches_reach_the_pose_and_one_is_the_joints(robot, q):
    poses = np.array([irb140(row) for row in q])
    branches = robot.ik(poses)
    assert branches.shape == (500, 8, 6)
    for pose, row, found in zip(poses, q, branches):
        reached = found[~np.isnan(found[:, 0])]
        for other in reached:
            np.testing.assert_allclose(irb140(other), pose, atol=1e-6)
        apart = np.abs((reached - row + 180) % 360 - 180).max(axis=1)
        assert apart.min() < 1e-6
    assert np.isnan(robot.ik(shift(3000, 0, 0))).all()


def test_near(robot, q):
    np.testing.assert_allclose(robot.ik(robot.fk(q), near=q), q, atol=1e-6)
    np.testing.assert_allclose(robot.ik(robot.fk(q[0]), near=q[0]), q[0], atol=1e-6)


def test_the_papers_joints(robot, fixtures):
    with open(fixtures / "paper" / "table3_nominal_joints.csv") as file:
        for row in csv.DictReader(file):
            pose = shift(*(float(row[c]) for c in ("x_mm", "y_mm", "z_mm"))) @ rotation("y", 90)
            joints = [float(row[f"j{j}_deg"]) for j in range(1, 7)]
            np.testing.assert_allclose(robot.ik(pose, near=joints), joints, atol=0.006)  # two decimals are printed


def test_the_deformed_arm(robot, q, tmp_path):
    table = tmp_path / "lift.csv"
    lines = ["Dx [mm],Dy[mm],Dz[mm],DOx[deg],DOy[deg],DOz[deg]", "0,0,0.3,0,0,0"] + ["0,0,0,0,0,0"] * 5
    table.write_text("\n".join(lines) + "\n")
    minutes = np.linspace(0, 200, len(q))
    # Joint 1 rises by 0.3 mm (1 - exp(-t/40)), and everything with it.
    lifted = robot.fk_deformed(q, minutes, deformation=table, growth="exp:40") - robot.fk(q)
    np.testing.assert_allclose(lifted[:, 2, 3], 0.3 * (1 - np.exp(-minutes / 40)), atol=1e-9)
    np.testing.assert_allclose(lifted[:, :2], 0, atol=1e-9)
    one = robot.fk_deformed(q[0], 40.0, deformation=table, growth="exp:40")
    assert one[2, 3] == pytest.approx(irb140(q[0])[2, 3] + 0.3 * (1 - np.exp(-1)), abs=1e-9)
    np.testing.assert_allclose(robot.fk_deformed(q, 0), robot.fk(q), atol=1e-9)


def test_calibration(robot, q):
    """Frames that are off, put into the data sheet's own chain; held-out poses; noise."""
    def shaken(row):
        parts = [shift(0.2, -0.4, 0.3), rotation("z", row[0] + 0.02), shift(70, 0, 352), rotation("x", 0.03), rotation("y", row[1] - 0.05), shift(0, 0, 360.4),
                 rotation("y", row[2] + 0.04), rotation("x", row[3]), shift(380, 0.25, 0), rotation("y", row[4] + 0.03), rotation("x", row[5]), shift(65, 0, 0), rotation("y", 90)]
        return np.linalg.multi_dot(parts)

    truth = np.array([shaken(row) for row in q])
    noisy = truth.copy()
    noisy[:, :3, 3] += RNG.normal(0, 0.02, (len(q), 3))
    off = lambda poses, rows: np.sqrt(((poses - truth[rows])[:, :3, 3] ** 2).sum(axis=1).mean())
    half, rest = slice(0, 250), slice(250, 500)
    assert off(robot.fk(q[rest]), rest) > 0.4
    for sigma_deg in (0.0057, None):
        found = robot.calibrate(q[half], noisy[half], sigma_deg=sigma_deg)
        assert found.offsets.shape == (6, 6) and (found.rms_deg is None) == (sigma_deg is None)
        # Three coordinates of noise, less what 26 parameters of 750 or 1,500 numbers take
        assert found.rms_mm == pytest.approx(0.02 * np.sqrt(3), rel=0.06)
        left = off(robot.fk_deformed(q[rest], 0, deformation=found.table, growth="none"), rest)
        assert left < 0.02, left
    with pytest.raises(driftpost.DriftpostError) as caught:
        robot.calibrate(q, truth * np.nan)
    assert caught.value.code == "array::not-finite" and "row 0" in str(caught.value)


@pytest.mark.parametrize("call, code, place", [
    (lambda r: r.fk([[0, 0, np.nan, 0, 0, 0]]), "array::not-finite", "row 0, number 2"),
    (lambda r: r.fk(np.full((3, 6), np.inf)), "array::not-finite", "row 0, number 0"),
    (lambda r: r.fk(np.zeros((3, 7))), "array::shape", "(3, 7)"),
    (lambda r: r.fk(np.zeros((2, 3, 6))), "array::shape", "(2, 3, 6)"),
    (lambda r: r.fk("irb140"), "array::shape", "no array of numbers"),
    (lambda r: r.fk([[1, 2, 3, 4, 5, 6], [1, 2]]), "array::shape", "no array of numbers"),
    (lambda r: r.fk(None), "array::shape", "object"),
    (lambda r: r.fk(np.zeros(6) + 1j), "array::shape", ""),
    (lambda r: r.fk(np.zeros((1, 6), bool)), "array::shape", "bool"),
    (lambda r: r.jacobian({"q": 1}), "array::shape", ""),
    (lambda r: r.ik(np.zeros((4, 4))), "array::pose", "row 0"),
    (lambda r: r.ik(np.full((4, 4), np.nan)), "array::not-finite", "row 0"),
    (lambda r: r.ik(np.stack([np.eye(4)] * 2), near=np.zeros((3, 6))), "array::shape", "3 rows"),
    (lambda r: r.calibrate(np.zeros((3, 6)), [np.eye(4)] * 2), "array::shape", "3 rows"),
    (lambda r: r.calibrate(np.empty((0, 6)), np.empty((0, 4, 4))), "array::shape", "no row"),
    (lambda r: r.calibrate(np.zeros(6), np.zeros((4, 4))), "array::pose", "row 0"),
    (lambda r: r.calibrate(np.zeros(6), np.eye(4), sigma_mm=-1), "option::usage", "sigma_mm"),
    (lambda r: r.calibrate(np.zeros(6), np.eye(4), sigma_deg="fine"), "option::usage", "sigma_deg is str"),
    (lambda r: r.fk_deformed(np.zeros((3, 6)), [0, 1]), "array::shape", "2 values"),
    (lambda r: r.fk_deformed(np.zeros(6), np.nan), "array::not-finite", "t_min"),
    (lambda r: r.fk_deformed(np.zeros(6), 1, growth="exp:-1"), "deform::", ""),
    (lambda r: r.fk_deformed(np.zeros(6), 1, deformation="nowhere.csv", growth="none"), "input::missing", "nowhere.csv"),
])
def test_bad_arrays(robot, call, code, place):
    with pytest.raises(driftpost.DriftpostError) as caught:
        call(robot)
    assert caught.value.code.startswith(code)
    assert place in str(caught.value)


def test_masked_rows_are_no_numbers(robot):
    q = np.ma.masked_array(np.zeros((3, 6)), mask=[[False] * 6, [False, True] * 3, [False] * 6])
    with pytest.raises(driftpost.DriftpostError, match="row 1") as caught:
        robot.fk(q)
    assert caught.value.code == "array::not-finite"
    assert np.array_equal(robot.fk(np.ma.masked_array(np.zeros((2, 6)), mask=False)), robot.fk(np.zeros((2, 6))))


def test_a_robot_is_what_it_was_when_it_was_loaded(fixtures, tmp_path):
    path = tmp_path / "arm.toml"
    text = (fixtures / "measurements" / "r2000ic" / "robot.toml").read_text()
    path.write_text(text)
    arm = driftpost.Robot.load(path)
    copied = pickle.loads(pickle.dumps(arm))
    assert np.array_equal(copied.fk(np.zeros(6)), arm.fk(np.zeros(6)))
    assert driftpost.plan(robot=arm, n=30).poses
    path.write_text(text.replace("1075.0", "1076.0"))
    assert path.read_text() != text
    with pytest.raises(driftpost.DriftpostError) as caught:
        driftpost.plan(robot=arm, n=30)
    assert caught.value.code == "robot::changed"
    path.unlink()
    with pytest.raises(driftpost.DriftpostError) as caught:
        driftpost.plan(robot=arm, n=30)
    assert caught.value.code == "input::missing"


def test_names_that_are_no_robots():
    for name, code in [("irb2400", "robot::coupled"), ("irb9999", "robot::unknown"), ("no/such.toml", "input::missing")]:
        with pytest.raises(driftpost.DriftpostError) as caught:
            driftpost.Robot.load(name)
        assert caught.value.code == code, caught.value


def test_a_forked_process_has_threads_of_its_own():
    program = (
        "import driftpost, multiprocessing, numpy as np\n"
        "robot = driftpost.Robot.load('irb140')\n"
        "q = np.random.default_rng(0).uniform(-60, 60, (20000, 6))\n"
        "def work(_): return robot.fk(q)[:, :3, 3].sum()\n"
        "alone = work(0)\n"
        "with multiprocessing.get_context('fork').Pool(2) as pool:\n"
        "    assert pool.map_async(work, range(4)).get(timeout=60) == [alone] * 4\n"
        "print('alive')\n"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=120)
    assert done.returncode == 0 and done.stdout.startswith("alive"), done.stderr[-2000:]


def test_other_threads_go_on_meanwhile(robot):
    counted, done = [0], threading.Event()

    def count():
        while not done.is_set():
            counted[0] += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    many = RNG.uniform(-60, 60, (400_000, 6))
    thread.start()
    start = time.perf_counter()
    before = counted[0]
    robot.ik(robot.fk(many))
    during, seconds = counted[0] - before, time.perf_counter() - start
    done.set()
    thread.join()
    assert during > 20 * seconds, f"{during} in {seconds} s"

//! Kinematics against others: a numpy script, rs-opw-kinematics, the reference paper's Table 3, RoboDK's exports.

use nalgebra::{Isometry3, Matrix3, Quaternion, Translation3, UnitQuaternion, Vector3};
use robot_model::kinematics::{Chain, ClosedForm, Configuration, FrameOffsets};
use robot_model::robot::Robot;
use rs_opw_kinematics::kinematic_traits::Kinematics;
use rs_opw_kinematics::kinematics_impl::OPWKinematics;
use rs_opw_kinematics::parameters::opw_kinematics::Parameters;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

fn robot(name: &str) -> Robot {
    Robot::built_in(name).unwrap()
}

fn rpy_pose(x_mm: f64, y_mm: f64, z_mm: f64, rpy_deg: [f64; 3]) -> Isometry3<f64> {
    let [r, p, y] = rpy_deg.map(f64::to_radians);
    let position = Translation3::from(Vector3::new(x_mm, y_mm, z_mm) / 1000.0);
    Isometry3::from_parts(position, UnitQuaternion::from_euler_angles(r, p, y))
}

fn gap(a: &Isometry3<f64>, b: &Isometry3<f64>) -> (f64, f64) {
    ((a.translation.vector - b.translation.vector).norm(), a.rotation.angle_to(&b.rotation))
}

/// Numbers in -1..1, the same on every machine (xorshift, Marsaglia 2003).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    fn joints(&mut self, within_rad: f64) -> [f64; 6] {
        std::array::from_fn(|_| self.next() * within_rad)
    }
}

/// Rows of a CSV fixture as text, without comment lines and header.
fn rows(text: &str) -> Vec<Vec<&str>> {
    let lines = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    lines.map(|line| line.split(',').collect()).collect()
}

fn numbers(fields: &[&str]) -> Vec<f64> {
    fields.iter().map(|field| field.parse().unwrap()).collect()
}

#[test]
fn forward_is_numpys_on_deformed_arms() {
    let rows = rows(include_str!("../../fixtures/oracle/forward.csv"));
    assert_eq!(rows.len(), 24);
    for row in rows {
        let n = numbers(&row[1..]);
        let q_rad: [f64; 6] = std::array::from_fn(|i| n[i].to_radians());
        let offsets = FrameOffsets(std::array::from_fn(|i| {
            std::array::from_fn(|k| {
                let written = n[6 + 6 * i + k];
                if k < 3 { written / 1000.0 } else { written.to_radians() }
            })
        }));
        let flange = Chain::with_offsets(&robot(row[0]), &offsets).forward(&q_rad);
        let position = Vector3::new(n[48], n[49], n[50]) / 1000.0;
        assert!((flange.translation.vector - position).norm() < 1e-14);
        let rotation = Matrix3::from_row_slice(&n[51..60]);
        assert!((flange.rotation.to_rotation_matrix().matrix() - rotation).norm() < 1e-14);
    }
}

fn opw(robot: &Robot) -> OPWKinematics {
    let x = |i: usize| robot.joints[i].previous_from_joint.translation.vector.x;
    let z = |i: usize| robot.joints[i].previous_from_joint.translation.vector.z;
    OPWKinematics::new(Parameters {
        a1: x(1),
        a2: -z(3),
        b: 0.0,
        c1: z(1),
        c2: z(2),
        c3: x(4),
        c4: robot.joint6_from_flange.translation.vector.x,
        offsets: [0.0, 0.0, -FRAC_PI_2, 0.0, 0.0, 0.0],
        sign_corrections: [1; 6],
        dof: 6,
    })
}

/// Built-in robots by what RobotComponents says of them: lengths of Brandstötter's ortho-parallel basis, mm.
fn others() -> Vec<(&'static str, [f64; 7])> {
    let rows = rows(include_str!("../../fixtures/oracle/robotcomponents.csv"));
    rows.iter().map(|row| (row[0], numbers(&row[1..]).try_into().unwrap())).collect()
}

/// Built-in robots by what other collections say of them: name, collection, d1, a1, a2, a3, d4 and d6 of Denavit and Hartenberg, mm.
fn by_denavit_hartenberg() -> Vec<(&'static str, &'static str, [f64; 6])> {
    let rows = rows(include_str!("../../fixtures/oracle/denavit_hartenberg.csv"));
    rows.iter().map(|row| (row[0], row[1], numbers(&row[2..]).try_into().unwrap())).collect()
}

#[test]
fn built_in_robots_are_the_arms_that_others_describe() {
    let mut random = Random(7);
    for (name, mm) in others() {
        let [a1, a2, b, c1, c2, c3, c4] = mm.map(|mm| mm / 1000.0);
        let offsets = [0.0, 0.0, -FRAC_PI_2, 0.0, 0.0, 0.0];
        let parameters = Parameters { a1, a2, b, c1, c2, c3, c4, offsets, sign_corrections: [1; 6], dof: 6 };
        let (theirs, ours) = (OPWKinematics::new(parameters), Chain::nominal(&robot(name)));
        for _ in 0..200 {
            let q_rad = random.joints(PI);
            let pose = theirs.forward(&q_rad);
            let (t, r) = (pose.translation, pose.rotation);
            let rotation = UnitQuaternion::from_quaternion(Quaternion::new(r.w, r.x, r.y, r.z));
            let goal = Isometry3::from_parts(Translation3::new(t.x, t.y, t.z), rotation);
            let (distance_m, angle_rad) = gap(&ours.forward(&q_rad), &goal);
            assert!(distance_m < 1e-12 && angle_rad < 1e-7, "{name}: {distance_m} {angle_rad}");
        }
    }
}

/// Both conventions, as products of rotations and shifts about and along z and x (Paul 1981; Craig 1986): nothing of the robot files' frames is in them.
#[test]
fn built_in_robots_are_the_arms_of_denavit_and_hartenbergs_lengths() {
    let turn = |axis: Vector3<f64>, rad: f64| Isometry3::rotation(axis * rad);
    let shift = |axis: Vector3<f64>, mm: f64| Isometry3::from(Translation3::from(axis * mm / 1000.0));
    let (x, z) = (Vector3::x(), Vector3::z());
    let mut random = Random(17);
    for (name, collection, [d1, a1, a2, a3, d4, d6]) in by_denavit_hartenberg() {
        let (a, d) = ([a1, a2, a3, 0.0, 0.0, 0.0], [d1, 0.0, 0.0, d4, 0.0, d6]);
        let alpha_rad = [-FRAC_PI_2, 0.0, -FRAC_PI_2, FRAC_PI_2, -FRAC_PI_2, 0.0];
        let offset_rad = [0.0, -FRAC_PI_2, 0.0, 0.0, 0.0, PI];
        let ours = Chain::nominal(&robot(name));
        for _ in 0..200 {
            let q_rad = random.joints(PI);
            let about_z = |j: usize| turn(z, q_rad[j] + offset_rad[j]) * shift(z, d[j]);
            let about_x = |j: usize| shift(x, a[j]) * turn(x, alpha_rad[j]);
            let joint = |j: usize| match (collection, j) {
                ("ARTE", _) => about_z(j) * about_x(j),
                (_, 0) => about_z(0),
                (_, _) => about_x(j - 1) * about_z(j),
            };
            let theirs = (0..6).map(joint).fold(Isometry3::identity(), |all, one| all * one);
            let (distance_m, angle_rad) = gap(&ours.forward(&q_rad), &theirs);
            assert!(distance_m < 1e-12 && angle_rad < 1e-7, "{name}, {collection}: {distance_m} {angle_rad}");
        }
    }
}

/// Two public descriptions agree on an arm, or it is known as one of which only one is to be had.
#[test]
fn every_built_in_robot_stands_in_two_descriptions_or_says_that_it_does_not() {
    let (others, by_dh) = (others(), by_denavit_hartenberg());
    let known = |name: &str| Robot::built_in_names().contains(&name);
    assert!(others.iter().all(|(name, _)| known(name)) && by_dh.iter().all(|(name, ..)| known(name)));
    for name in Robot::built_in_names() {
        let arm = robot(name);
        // What says otherwise stands behind a semicolon.
        let from_ros = usize::from(arm.source.split(';').next().is_some_and(|agreed| agreed.contains("ROS")));
        let elsewhere = others.iter().filter(|(other, _)| other == name).count()
            + by_dh.iter().filter(|(other, ..)| other == name).count();
        assert!(elsewhere > 0, "{name} is checked against nothing");
        assert_eq!(arm.is_of_one_description(), from_ros + elsewhere < 2, "{name}: {}", arm.source);
    }
}

/// Of two descriptions' ranges the narrower one stands, so that nothing is told to be in reach that one of them has out of it. RobotComponents' of the two
/// reaches of the IRB 1600 stand each with the other (docs/ROBOTS.md).
#[test]
fn ranges_lie_within_those_that_others_give() {
    let rows = rows(include_str!("../../fixtures/oracle/robotcomponents_ranges.csv"));
    let of_all =
        Robot::built_in_with_offset_wrist().iter().all(|name| rows.iter().any(|row| row[0] == *name));
    assert!(of_all && rows.len() > 50);
    for row in rows.iter().filter(|row| row[0] != "irb1600-1.45") {
        let theirs = numbers(&row[1..]);
        for (j, (joint, theirs)) in robot(row[0]).joints.iter().zip(theirs.chunks(2)).enumerate() {
            let [low, high] = joint.range_rad.unwrap().map(f64::to_degrees);
            // Some of theirs are rounded to whole degrees.
            assert!(
                low > theirs[0] - 0.3 && high < theirs[1] + 0.3,
                "{} joint {}: {low} {high}",
                row[0],
                j + 1
            );
        }
    }
}

/// A product of exponentials (Brockett 1984): each axis as a line of the zero pose in the base, the flange's pose there behind them. Nothing
/// goes from frame to frame, as the robot files do.
#[test]
fn gofa_is_the_arm_that_others_describe_and_has_no_closed_form() {
    let rows = rows(include_str!("../../fixtures/oracle/robotcomponents_offset_wrist.csv"));
    assert_eq!(Robot::built_in_with_offset_wrist(), rows.iter().map(|row| row[0]).collect::<Vec<_>>());
    let mut random = Random(15);
    for row in rows {
        let [a1, a2, a3, b, c1, c2, c3, c4]: [f64; 8] = numbers(&row[1..]).try_into().unwrap();
        let [upper, wrist, hand] = [c1 + c2, c1 + c2 - a2, c1 + c2 - a2 - a3];
        let lines = [
            (Vector3::z(), Vector3::zeros()),
            (Vector3::y(), Vector3::new(a1, b, c1)),
            (Vector3::y(), Vector3::new(a1, b, upper)),
            (Vector3::x(), Vector3::new(a1, b, wrist)),
            (Vector3::y(), Vector3::new(a1 + c3, b, wrist)),
            (Vector3::x(), Vector3::new(a1 + c3, b, hand)),
        ];
        let home = Isometry3::from_parts(
            (Vector3::new(a1 + c3 + c4, b, hand) / 1000.0).into(),
            UnitQuaternion::from_axis_angle(&Vector3::y_axis(), FRAC_PI_2),
        );
        let arm = Robot::by_name(row[0]).unwrap();
        let ours = Chain::nominal(&arm);
        for _ in 0..200 {
            let q_rad = random.joints(PI);
            let about = |(j, (axis, through_mm)): (usize, &(Vector3<f64>, Vector3<f64>))| {
                let turn = UnitQuaternion::from_scaled_axis(axis * q_rad[j]);
                let through_m = through_mm / 1000.0;
                Isometry3::from_parts((through_m - turn * through_m).into(), turn)
            };
            let theirs =
                lines.iter().enumerate().map(about).fold(Isometry3::identity(), |all, one| all * one) * home;
            let (distance_m, angle_rad) = gap(&ours.forward(&q_rad), &theirs);
            assert!(distance_m < 1e-12 && angle_rad < 1e-7, "{}: {distance_m} {angle_rad}", row[0]);
        }
        let refused = ClosedForm::new(&arm).unwrap_err().to_string();
        assert!(refused.contains("axes 4, 5 and 6 do not meet in one point"), "{refused}");
    }
}

/// Largest difference of two joint vectors, whole turns apart being the same.
fn apart_rad(a: &[f64; 6], b: &[f64; 6]) -> f64 {
    let wrapped = |x: f64| (x - TAU * (x / TAU).round()).abs();
    a.iter().zip(b).map(|(a, b)| wrapped(a - b)).fold(0.0, f64::max)
}

#[test]
fn all_branches_are_rs_opw_kinematics_for_every_built_in_robot() {
    let mut random = Random(140);
    for name in Robot::built_in_names() {
        let robot = robot(name);
        let (closed, chain, opw) = (ClosedForm::new(&robot).unwrap(), Chain::nominal(&robot), opw(&robot));
        let (mut compared, mut theirs_only) = (0, 0);
        for _ in 0..500 {
            let q_rad = random.joints(PI);
            let pose = opw.forward(&q_rad);
            let (t, r) = (pose.translation, pose.rotation);
            let rotation = UnitQuaternion::from_quaternion(Quaternion::new(r.w, r.x, r.y, r.z));
            let goal = Isometry3::from_parts(Translation3::new(t.x, t.y, t.z), rotation);
            let (distance_m, angle_rad) = gap(&chain.forward(&q_rad), &goal);
            assert!(distance_m < 1e-13 && angle_rad < 1e-7, "{name}: {distance_m} {angle_rad}");

            let ours: Vec<[f64; 6]> = closed.branches(&goal).into_iter().flatten().collect();
            let theirs = opw.inverse(&pose);
            assert!(ours.iter().any(|ours| apart_rad(ours, &q_rad) < 1e-6), "{name}: {q_rad:?} is not found");
            for theirs in &theirs {
                if ours.iter().any(|ours| apart_rad(ours, theirs) < 1e-6) {
                    compared += 1;
                } else {
                    theirs_only += 1;
                }
            }
            for ours in &ours {
                let (distance_m, angle_rad) = gap(&chain.forward(ours), &goal);
                assert!(distance_m < 1e-12 && angle_rad < 1e-7);
                assert!(
                    theirs.iter().any(|theirs| apart_rad(ours, theirs) < 1e-6),
                    "{name}: only ours {ours:?}"
                );
            }
        }
        assert_eq!(theirs_only, 0, "{name}");
        assert!(compared > 1000, "{name}: {compared}");
    }
}

#[test]
fn table_3_is_met_on_the_branch_with_joint_5_negative() {
    let robot = robot("irb140");
    let closed = ClosedForm::new(&robot).unwrap();
    let rows = rows(include_str!("../../fixtures/paper/table3_nominal_joints.csv"));
    assert_eq!(rows.len(), 3);
    for row in rows {
        let n = numbers(&row[1..]);
        let goal = rpy_pose(n[0], n[1], n[2], [n[3], n[4], n[5]]);
        let published_rad: [f64; 6] = std::array::from_fn(|i| n[6 + i].to_radians());
        let found = closed.nearest(&goal, &published_rad).unwrap();
        for (found, published) in found.q_rad.iter().zip(published_rad) {
            assert!((found - published).to_degrees().abs() < 0.005, "{}: {found} {published}", row[0]);
        }
        assert_eq!(found.configuration.cfx, 1);
    }
}

#[test]
fn solutions_stand_within_the_ranges_and_turn_as_far_as_they_allow() {
    let robot = robot("irb140");
    let closed = ClosedForm::new(&robot).unwrap();
    let q_rad = [20.0, 10.0, -15.0, 35.0, -40.0, 50.0].map(f64::to_radians);
    let goal = Chain::nominal(&robot).forward(&q_rad);
    let solutions = closed.solutions(&goal);
    for solution in &solutions {
        assert_eq!(robot.within_range(&solution.q_rad), Ok(()));
        assert!(gap(&Chain::nominal(&robot).forward(&solution.q_rad), &goal).0 < 1e-12);
    }
    // This branch: J4 at 35 (range ±200: -325 is outside), J6 at 50 and -310 (range ±400).
    let same: Vec<f64> = solutions
        .iter()
        .filter(|s| (s.q_rad[4] - q_rad[4]).abs() < 1e-9 && (s.q_rad[1] - q_rad[1]).abs() < 1e-9)
        .map(|s| s.q_rad[5].to_degrees().round())
        .collect();
    assert_eq!(same, [-310.0, 50.0]);
    // The wrist flipped: J4 at -145, J6 at -130 and 230.
    let flipped: Vec<f64> = solutions
        .iter()
        .filter(|s| (s.q_rad[4] + q_rad[4]).abs() < 1e-9 && (s.q_rad[1] - q_rad[1]).abs() < 1e-9)
        .map(|s| s.q_rad[5].to_degrees().round())
        .collect();
    assert_eq!(flipped, [-130.0, 230.0]);
}

#[test]
fn poses_on_singularities_are_solved_and_poses_out_of_reach_are_not() {
    let robot = robot("irb120");
    let closed = ClosedForm::new(&robot).unwrap();
    let chain = Chain::nominal(&robot);
    let stretched = -(302.0_f64).atan2(70.0);
    for q_deg in [[0.0; 6], [30.0, 20.0, 10.0, 40.0, 0.0, 50.0], [30.0, 20.0, 10.0, 40.0, 1e-7, 50.0]] {
        let goal = chain.forward(&q_deg.map(f64::to_radians));
        let found = closed.branches(&goal);
        assert!(found.iter().flatten().count() >= 2, "{q_deg:?}: {found:?}");
        for q_rad in found.iter().flatten() {
            assert!(gap(&chain.forward(q_rad), &goal).0 < 1e-12);
        }
    }
    let goal = chain.forward(&[0.3, 0.4, stretched, 0.2, 0.7, 0.1]);
    assert!(closed.branches(&goal).iter().flatten().count() >= 1, "stretched to the limit");
    let beyond = rpy_pose(2000.0, 0.0, 500.0, [0.0, 90.0, 0.0]);
    assert!(closed.branches(&beyond).iter().all(Option::is_none));
    assert!(closed.solutions(&beyond).is_empty());
}

#[test]
fn frames_and_signs_of_a_file_do_not_matter_only_its_axes() {
    // The IRB 140 with joint 3 and 4 turning the other way, the forearm's frames turned, and the flange to match.
    let text = r#"
name = "the same arm, written otherwise"
[[joint]]
origin_mm = [0, 0, 100]
axis = [0, 0, 2]
[[joint]]
origin_mm = [70, 0, 252]
rpy_deg = [0, 0, 90]
axis = [1, 0, 0]
[[joint]]
origin_mm = [0, 0, 360]
axis = [-1, 0, 0]
[[joint]]
origin_mm = [0, -100, 0]
axis = [0, 1, 0]
[[joint]]
origin_mm = [0, -280, 0]
rpy_deg = [0, 0, -90]
axis = [0, 1, 0]
[[joint]]
origin_mm = [0, 0, 0]
rpy_deg = [0, 90, 0]
axis = [0, 0, 1]
[flange]
origin_mm = [0, 0, 65]
"#;
    let other = Robot::from_toml(text).unwrap();
    let q_rad = [0.3, -0.2, 0.4, 0.5, -0.6, 0.7];
    // J2 turns about -y... of the base: x of a frame turned by 90 degrees is y.
    let written =
        Chain::nominal(&other).forward(&[q_rad[0], q_rad[1], -q_rad[2], -q_rad[3], q_rad[4], q_rad[5]]);
    let plain = Chain::nominal(&robot("irb140")).forward(&q_rad);
    assert!(gap(&written, &plain).0 < 1e-14 && gap(&written, &plain).1 < 1e-7);
    let found = ClosedForm::new(&other).unwrap().branches(&plain);
    let expected = [q_rad[0], q_rad[1], -q_rad[2], -q_rad[3], q_rad[4], q_rad[5]];
    assert!(found.iter().flatten().any(|found| apart_rad(found, &expected) < 1e-12), "{found:?}");
}

#[test]
fn an_arm_of_another_structure_is_refused_with_the_reason() {
    let text = include_str!("../../crates/robot-model/src/robot/built_in/irb140.toml");
    for (from, to, expected) in [
        (
            "origin_mm = [380, 0, 0]\naxis = [0, 1, 0]",
            "origin_mm = [380, 0, 0]\naxis = [0.2, 1, 0]",
            "axis 5 is not at a right",
        ),
        (
            "origin_mm = [0, 0, 360]\naxis = [0, 1, 0]",
            "origin_mm = [0, 0, 360]\naxis = [1, 0, 0]",
            "axis 3 is not parallel",
        ),
    ] {
        let text = text.replacen(from, to, 1);
        let robot = Robot::from_toml(&text).unwrap();
        let error = ClosedForm::new(&robot).unwrap_err();
        assert!(error.to_string().contains(expected), "{error}");
    }
    let offset_wrist = text.replacen("origin_mm = [380, 0, 0]", "origin_mm = [380, 0, 10]", 1);
    let error = ClosedForm::new(&Robot::from_toml(&offset_wrist).unwrap()).unwrap_err();
    assert!(error.to_string().contains("do not meet in one point"), "{error}");
}

/// A RoboDK program's own MoveAbsJ joints stand over the robtarget that follows, in the same tool and work object.
#[test]
fn robodks_joints_stand_where_robodk_says() {
    // irc5/RichProg.mod: MoveAbsJ to the approach, 150 mm over the work object's origin; uframe and tframe from there.
    let q_rad = [-14.036243, 5.773011, 30.566126, 0.0, 53.660862, -59.872867].map(f64::to_radians);
    let quaternion = |w, x, y, z| UnitQuaternion::from_quaternion(Quaternion::new(w, x, y, z));
    let base_from_wobj = Isometry3::from_parts(
        Translation3::new(0.400, -0.100, 0.150),
        quaternion(0.98877108, 0.0, 0.0, 0.14943813),
    );
    let flange_from_tool = Isometry3::from_parts(
        Translation3::new(0.0, 0.0, 0.120),
        quaternion(0.96891242, 0.0, 0.0, 0.24740396),
    );
    let robot = robot("irb140");
    let base_from_flange = Chain::nominal(&robot).forward(&q_rad);
    let wobj_from_tool = base_from_wobj.inverse() * base_from_flange * flange_from_tool;
    assert!(wobj_from_tool.translation.vector.xy().norm() < 1e-6, "{wobj_from_tool}");
    assert!(wobj_from_tool.rotation.angle_to(&quaternion(0.0, 0.0, 1.0, 0.0)) < 1e-7, "{wobj_from_tool}");

    // The robtargets under it, with the configuration that RoboDK wrote.
    let closed = ClosedForm::new(&robot).unwrap();
    let written = Configuration { cf1: -1, cf4: 0, cf6: -1, cfx: 0 };
    let down = quaternion(0.0, 0.0, 1.0, 0.0);
    for [x, y, z] in [[0.0, 0.0, 0.050], [0.0, 0.0, 0.020], [0.0, 0.050, 0.020], [0.030, 0.080, 0.020]] {
        let wobj_from_tool = Isometry3::from_parts(Translation3::new(x, y, z), down);
        let goal = base_from_wobj * wobj_from_tool * flange_from_tool.inverse();
        let found = closed.nearest(&goal, &q_rad).unwrap();
        assert!(closed.agrees(&written, &found.q_rad), "{:?}", found.configuration);
    }
}

#[test]
fn the_cubes_configurations_are_robodks() {
    // irc5/Cube45.mod, first plane: y, z in mm and the four numbers RoboDK wrote, all with orientation 0, 90, 0.
    let robot = robot("irb140");
    let closed = ClosedForm::new(&robot).unwrap();
    let first = [41.845157, 44.625236, 25.881200, 43.530476, -75.605869, -13.287258].map(f64::to_radians);
    let written = [
        ([400.0, 300.0, 250.0], [0, 0, -1, 1]),
        ([400.0, 150.0, 250.0], [0, 0, -1, 1]),
        ([400.0, 0.0, 250.0], [0, 0, 0, 1]),
        ([400.0, -150.0, 250.0], [-1, -1, 0, 1]),
        ([400.0, -300.0, 250.0], [-1, -1, 0, 1]),
        ([550.0, -300.0, 550.0], [-1, -1, 0, 1]),
        ([550.0, 300.0, 400.0], [0, 0, -1, 1]),
    ];
    for (i, ([x, y, z], [cf1, cf4, cf6, cfx])) in written.into_iter().enumerate() {
        let goal = rpy_pose(x, y, z, [0.0, 90.0, 0.0]);
        let written = Configuration { cf1, cf4, cf6, cfx };
        let agreeing: Vec<_> =
            closed.solutions(&goal).into_iter().filter(|s| closed.agrees(&written, &s.q_rad)).collect();
        assert_eq!(agreeing.len(), 1, "{written:?}");
        assert_eq!(agreeing[0].configuration, written);
        if i == 0 {
            assert!(apart_rad(&agreeing[0].q_rad, &first) < 1e-8, "{:?}", agreeing[0]);
        }
    }
}

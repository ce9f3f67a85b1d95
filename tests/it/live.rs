//! Motions that ask for their target: the emitted model, executed in single precision, against the deformed arm.
//!
//! What is expected comes from the deformed arm's own forward kinematics: at the nominal joints of the answer it must stand
//! where the program says.

mod cell;
mod identified;

use cell::{Cell, Off, at, cap, table};
use nalgebra::{Isometry3, Translation3, Unit, UnitQuaternion, Vector3};
use rapid_compensation::emit::live::{Function, LiveModel, TestTarget};
use robot_model::deform::{Deformation, DeformedArm};
use robot_model::kinematics::{ClosedForm, FrameOffsets};
use robot_model::robot::Robot;
use virtual_controller::{Outcome, Value};

/// Tool and work object away from the axes.
const TOOL: &str =
    "[TRUE,[[31.5,-12,140],[0.92387953,0.22094238,0.22094238,0.22094238]],[1.5,[0,10,60],[1,0,0,0],0,0,0]]";
const WOBJ: &str =
    "[FALSE,TRUE,\"\",[[120,-60,35],[0.96592583,0,0,0.25881905]],[[5,7,-9],[0.98480775,0.17364818,0,0]]]";

fn paper(times: f64) -> FrameOffsets {
    let settled = Deformation::paper().offsets_at(f64::INFINITY);
    FrameOffsets(settled.0.map(|row| row.map(|x| x * times)))
}

fn worst(cell: &mut Cell, share: f64, offsets: &FrameOffsets) -> Off {
    cell.set("tcF1", share as f32);
    let share = f64::from(share as f32);
    let arm = DeformedArm::of_table(&cell.robot, &FrameOffsets(offsets.0.map(|row| row.map(|x| x * share))));
    cell.worst(&arm)
}

#[test]
fn the_cube_stands_where_it_is_programmed() {
    for (times, most_mm, most_deg) in [(1.0, 0.0003, 0.00005), (3.0, 0.002, 0.0005)] {
        let offsets = paper(times);
        let model =
            LiveModel::new(&Robot::built_in("irb140").unwrap(), &table(&offsets), None, cap()).unwrap();
        let mut cell = Cell::cube(&model, "irb140");
        let mut all = Off::default();
        for share in [0.01, 0.1, 0.3, 0.5, 0.77, 1.0] {
            all = all.max(worst(&mut cell, share, &offsets));
        }
        println!("{times} x table: {all:?}");
        assert!(all.mm <= most_mm && all.deg <= most_deg, "{times} x table: {all:?}");
        assert!(cell.controller.take_messages().is_empty());
    }
}

#[test]
fn off_and_cold_are_the_original_to_the_bit() {
    let offsets = paper(1.0);
    let model = LiveModel::new(&Robot::built_in("irb140").unwrap(), &table(&offsets), None, cap()).unwrap();
    let mut cell = Cell::cube(&model, "irb140");
    for (on, share) in [(true, 0.0), (false, 0.0), (false, 1.0)] {
        cell.controller.set("tcOn", Value::Bool(on)).unwrap();
        cell.set("tcF1", share);
        cell.call("run");
        assert_eq!(cell.answers(), cell.asked());
        assert!(cell.controller.take_messages().is_empty());
    }
}

#[test]
fn tools_and_work_objects_away_from_the_axes() {
    let offsets = paper(1.0);
    let robot = Robot::built_in("irb140").unwrap();
    let model = LiveModel::new(&robot, &table(&offsets), None, cap()).unwrap();
    for wobj in [None, Some(WOBJ)] {
        let targets = at(&robot, 40, TOOL, wobj, 1);
        let mut cell = Cell::new(&model, &robot, &targets, TOOL, wobj);
        for share in [0.4, 1.0] {
            let off = worst(&mut cell, share, &offsets);
            println!("{}: {off:?}", wobj.is_some());
            assert!(off.mm <= 0.0005 && off.deg <= 0.0001, "{off:?}");
        }
    }
}

/// The same arm, described in frames that are turned any way.
fn turned(robot: &Robot) -> Robot {
    let turn = |i: usize| match i {
        0 => UnitQuaternion::identity(),
        i => UnitQuaternion::from_euler_angles(0.3 * i as f64, -0.7 + 0.2 * i as f64, 1.1 * i as f64),
    };
    let mut odd = robot.clone();
    for (i, joint) in odd.joints.iter_mut().enumerate() {
        let was = robot.joints[i].previous_from_joint;
        joint.previous_from_joint = Isometry3::from_parts(
            Translation3::from(turn(i).inverse() * was.translation.vector),
            turn(i).inverse() * was.rotation * turn(i + 1),
        );
        joint.axis = Unit::new_normalize(turn(i + 1).inverse() * joint.axis.into_inner());
    }
    let was = robot.joint6_from_flange;
    odd.joint6_from_flange = Isometry3::from_parts(
        Translation3::from(turn(6).inverse() * was.translation.vector),
        turn(6).inverse() * was.rotation,
    );
    if let Some(links) = &mut odd.links {
        for (k, link) in links.iter_mut().enumerate() {
            link.com_m = (turn(k + 1).inverse() * Vector3::from(link.com_m)).into();
        }
    }
    odd
}

/// Every offset of every frame, up to 0.1 mm and 0.005 degrees.
fn all_offsets() -> FrameOffsets {
    FrameOffsets(std::array::from_fn(|i| {
        std::array::from_fn(|k| {
            let of_one = ((i * 6 + k) as f64 * 2.399 + 0.4).sin();
            if k < 3 { 1e-4 * of_one } else { 0.005_f64.to_radians() * of_one }
        })
    }))
}

#[test]
fn every_robot_and_frames_turned_any_way() {
    let toml = include_str!("../../crates/robot-model/src/robot/built_in/irb140.toml").to_owned();
    let robots = Robot::built_in_names().iter().map(|name| Robot::built_in(name).unwrap());
    let mut robots: Vec<Robot> = robots.collect();
    robots.push(turned(&robots[0]));
    robots.push(turned(&Robot::built_in("irb4600").unwrap()));
    // The base turned by a quarter, so that the arm bends about its x.
    let rpy = toml.replacen("axis = [0, 0, 1]", "rpy_deg = [0, 0, 90]\naxis = [0, 0, 1]", 1);
    assert_ne!(rpy, toml);
    robots.push(Robot::from_toml(&rpy).unwrap());
    for robot in &robots {
        // What a correction of first order leaves grows with the square of shift over length: a shorter arm than the IRB 120 is given shifts
        // as much smaller.
        let reach_m = |robot: &Robot| -> f64 {
            robot.joints.iter().skip(2).map(|joint| joint.previous_from_joint.translation.vector.norm()).sum()
        };
        let share = (reach_m(robot) / reach_m(&Robot::built_in("irb120").unwrap())).min(1.0);
        let mut offsets = all_offsets();
        offsets.0.iter_mut().flat_map(|row| &mut row[..3]).for_each(|shift_m| *shift_m *= share);
        let model = LiveModel::new(robot, &table(&offsets), None, cap()).unwrap();
        let targets = at(robot, 30, TOOL, Some(WOBJ), 2);
        let mut cell = Cell::new(&model, robot, &targets, TOOL, Some(WOBJ));
        let off = worst(&mut cell, 1.0, &offsets);
        println!("{}: {off:?}", robot.name);
        assert!(off.mm <= 0.001 && off.deg <= 0.0001, "{}: {off:?}", robot.name);
    }
}

#[test]
fn several_functions_of_time_add_up() {
    let robot = Robot::built_in("irb140").unwrap();
    let (one, two) = (paper(1.0), all_offsets());
    let function = |offsets: &FrameOffsets| Function { offsets: *offsets, shape: None };
    let model = LiveModel::new(&robot, &[function(&one), function(&two)], None, cap()).unwrap();
    let targets = at(&robot, 20, TOOL, None, 3);
    let mut cell = Cell::new(&model, &robot, &targets, TOOL, None);
    for (f1, f2) in [(0.0, 0.0), (0.5, 0.0), (0.0, 0.75), (0.25, -0.5)] {
        cell.set("tcF1", f1 as f32);
        cell.set("tcF2", f2 as f32);
        let sum = FrameOffsets(std::array::from_fn(|i| {
            std::array::from_fn(|k| f1 * one.0[i][k] + f2 * two.0[i][k])
        }));
        let arm = DeformedArm::of_table(&robot, &sum);
        let off = cell.worst(&arm);
        assert!(off.mm <= 0.0005 && off.deg <= 0.0001, "{f1} {f2}: {off:?}");
        if f1 == 0.0 && f2 == 0.0 {
            assert_eq!(cell.answers(), cell.asked());
        }
    }
}

/// `by` times the twist with which `offsets` move the TCP at these joints, to first order: a central difference of the deformed arm's
/// forward kinematics, in the axes of the TCP.
fn first_order(
    robot: &Robot,
    offsets: &FrameOffsets,
    q_rad: &[f64; 6],
    flange_from_tcp: &Isometry3<f64>,
    by: f64,
) -> Isometry3<f64> {
    const STEP: f64 = 1e-3;
    let at = |share: f64| {
        let offsets = FrameOffsets(offsets.0.map(|row| row.map(|x| share * x)));
        let arm = DeformedArm::of_table(robot, &offsets);
        arm.under(&Default::default()).forward(q_rad) * flange_from_tcp
    };
    let tcp_from_base = at(0.0).inverse();
    let [ahead, behind] = [STEP, -STEP].map(|share| tcp_from_base * at(share));
    let scale = by / (2.0 * STEP);
    let shift_m = (ahead.translation.vector - behind.translation.vector) * scale;
    let turn_rad = (ahead.rotation.scaled_axis() - behind.rotation.scaled_axis()) * scale;
    Isometry3::from_parts(Translation3::from(shift_m), UnitQuaternion::from_scaled_axis(turn_rad))
}

#[test]
fn a_target_is_moved_back_by_the_deformed_arms_derivative() {
    let robot = Robot::built_in("irb2600").unwrap();
    let offsets = all_offsets();
    let model = LiveModel::new(&robot, &table(&offsets), None, cap()).unwrap();
    let targets = at(&robot, 20, TOOL, None, 4);
    let mut cell = Cell::new(&model, &robot, &targets, TOOL, None);
    cell.set("tcF1", 0.5);
    cell.call("run");
    let tool = cell.tool;
    let joints = cell.joints("j");
    for ((asked, answer), joints) in cell.asked().iter().zip(cell.answers()).zip(joints) {
        let (asked, answer) = (cell::pose(asked), cell::pose(&answer));
        let q_rad = cell::q_rad(&joints);
        let expected = asked * first_order(&robot, &offsets, &q_rad, &tool, -0.5);
        let off = Off::between(&expected, &answer);
        assert!(off.mm < 0.0001 && off.deg < 0.00003, "{off:?}");
    }
}

#[test]
fn a_joint_target_puts_the_warm_flange_where_the_cold_one_was() {
    let robot = Robot::built_in("irb140").unwrap();
    let offsets = paper(1.0);
    let model = LiveModel::new(&robot, &table(&offsets), None, cap()).unwrap();
    let targets = at(&robot, 40, TOOL, Some(WOBJ), 5);
    let mut cell = Cell::new(&model, &robot, &targets, TOOL, Some(WOBJ));
    cell.set("tcF1", 1.0);
    cell.call("runJ");
    let arm = DeformedArm::of_table(&robot, &offsets);
    let mut all = Off::default();
    for (was, is) in cell.joints("j").iter().zip(cell.joints("js")) {
        let nominal = robot_model::kinematics::Chain::nominal(&robot).forward(&cell::q_rad(was));
        let warm = arm.under(&Default::default()).forward(&cell::q_rad(&is));
        all = all.max(Off::between(&nominal, &warm));
        assert_eq!(was[6..], is[6..], "external axes");
        assert_ne!(was[..6], is[..6]);
    }
    println!("{all:?}");
    assert!(all.mm <= 0.0006 && all.deg <= 0.0001, "{all:?}");
    assert!(cell.controller.take_messages().is_empty());
}

#[test]
fn a_joint_target_that_is_no_pose_or_near_a_singularity_stays() {
    let robot = Robot::built_in("irb140").unwrap();
    let model = LiveModel::new(&robot, &table(&paper(1.0)), None, cap()).unwrap();
    let mut cell = Cell::cube(&model, "irb140");
    cell.set("tcF1", 1.0);
    cell.call("oneJ");
    assert_eq!(cell.joints_of("unused"), cell.joints_of("unusedIs"));
    assert!(cell.controller.take_messages().is_empty());
    assert_eq!(cell.joints_of("straight"), cell.joints_of("straightIs"));
    // So near that there are no joints of the same configuration, and near enough that one would turn far.
    for (name, routine, says) in
        [("singular", "singularJ", "No joints"), ("flipped", "flippedJ", "singularity")]
    {
        cell.controller.set("tcSaid", Value::Bool(false)).unwrap();
        cell.call(routine);
        assert_eq!(cell.joints_of(name), cell.joints_of(&format!("{name}Is")));
        let shown = cell.controller.take_messages();
        assert_eq!(shown.len(), 1, "{name}: {shown:?}");
        assert!(shown[0].text.contains(says), "{name}: {shown:?}");
    }
}

#[test]
fn what_cannot_be_corrected_is_the_original_and_one_message() {
    let robot = Robot::built_in("irb140").unwrap();
    let model = LiveModel::new(&robot, &table(&paper(1.0)), None, cap()).unwrap();
    for (routine, message) in [
        ("tooFar", "No joints"),
        ("wrongConf", "No joints"),
        // What is reached as programmed and not, or by another turn of a joint, as corrected.
        ("atSingular", "No joints"),
        ("atFlipped", "singularity"),
        ("atStretched", "No joints"),
        ("atAtLimit", "No joints"),
        ("atHalfRound", "No joints"),
        ("displaced", "displacement"),
        ("displacedOn", "displacement"),
        ("axisOffset", "displacement"),
        ("stationary", "stationary"),
        ("objectHeld", "work object"),
        ("objectMoved", "work object"),
    ] {
        let mut cell = Cell::cube(&model, "irb140");
        cell.set("tcF1", 1.0);
        cell.call(routine);
        assert_eq!(cell.target("is"), cell.target("given"), "{routine}");
        let shown = cell.controller.take_messages();
        assert_eq!(shown.len(), 1, "{routine}: {shown:?}");
        assert!(
            shown[0].text.contains(message) && shown[0].text.contains("original"),
            "{routine}: {shown:?}"
        );
        // The same is corrected, or said to be out of reach, once nothing stands in the way.
        cell.call("plain");
        assert_ne!(cell.target("is"), cell.target("given"), "{routine}");
    }
}

#[test]
fn any_other_error_is_the_programs_to_handle() {
    let robot = Robot::built_in("irb140").unwrap();
    let model = LiveModel::new(&robot, &table(&paper(1.0)), None, cap()).unwrap();
    let mut cell = Cell::cube(&model, "irb140");
    cell.set("tcF1", 1.0);
    let outcome = cell.controller.call("notNormalised", 1).unwrap();
    assert!(matches!(outcome, Outcome::Failed { error: Some("err_orient_value"), .. }), "{outcome:?}");
    assert!(cell.controller.take_messages().is_empty());
}

#[test]
fn a_correction_over_the_cap_is_the_original() {
    let robot = Robot::built_in("irb140").unwrap();
    for (times, shown) in [(1.0, 0), (40.0, 1)] {
        let model = LiveModel::new(&robot, &table(&paper(times)), None, cap()).unwrap();
        let mut cell = Cell::cube(&model, "irb140");
        cell.set("tcF1", 1.0);
        cell.call("run");
        assert_eq!(cell.answers() == cell.asked(), shown > 0);
        let messages = cell.controller.take_messages();
        assert_eq!(messages.len(), shown, "{messages:?}");
        assert!(messages.iter().all(|m| m.text.contains("1 mm or 0.5 deg") && m.text.len() <= 80));
    }
}

#[test]
fn the_second_point_of_an_arc_sees_the_same_moment() {
    let robot = Robot::built_in("irb140").unwrap();
    let model = LiveModel::new(&robot, &table(&paper(1.0)), None, cap()).unwrap();
    let mut cell = Cell::cube(&model, "irb140");
    cell.set("tcF1", 1.0);
    cell.call("plain");
    assert_eq!(cell.controller.number("tcUpdates").unwrap(), 1.0);
    let once = cell.target("is");
    cell.call("same");
    assert_eq!(cell.controller.number("tcUpdates").unwrap(), 1.0);
    assert_eq!(cell.target("is"), once);
}

#[test]
fn the_controllers_own_tool_and_object_may_be_named() {
    let robot = Robot::built_in("irb140").unwrap();
    let model = LiveModel::new(&robot, &table(&paper(1.0)), None, cap()).unwrap();
    let mut cell = Cell::cube(&model, "irb140");
    cell.set("tcF1", 1.0);
    cell.call("plain");
    let as_declared = cell.target("is");
    for routine in ["ownTool", "ownToolAndObject"] {
        cell.call(routine);
        assert_eq!(cell.target("is"), as_declared, "{routine}");
    }
}

#[test]
fn what_is_taught_warm_is_gone_back_to() {
    let robot = Robot::built_in("irb140").unwrap();
    let offsets = paper(1.0);
    let model = LiveModel::new(&robot, &table(&offsets), None, cap()).unwrap();
    let arm = DeformedArm::of_table(&robot, &offsets);
    let targets = at(&robot, 10, TOOL, Some(WOBJ), 6);
    let mut cell = Cell::new(&model, &robot, &targets, TOOL, Some(WOBJ));
    let mut all = Off::default();
    for (k, joints) in cell.joints("j").into_iter().enumerate() {
        cell.set("k", k as f32 + 1.0);
        cell.set("tcF1", 1.0);
        cell.controller.set("tcOn", Value::Bool(true)).unwrap();
        cell.call("teach");
        let stood = arm.under(&Default::default()).forward(&cell::q_rad(&joints)) * cell.tool;
        // The cold target is where the TCP really was ...
        let taught = cell.object * cell::pose(&cell.target("given"));
        assert!(Off::between(&stood, &taught).mm < 0.0005, "{:?}", Off::between(&stood, &taught));
        // ... and asking for it brings the arm back there.
        let is = cell.target("is");
        let q_rad = cell.joints_for(&is, &cell::q_rad(&joints));
        let back = arm.under(&Default::default()).forward(&q_rad) * cell.tool;
        all = all.max(Off::between(&stood, &back));
        // Without correction it is plain CRobT.
        cell.controller.set("tcOn", Value::Bool(false)).unwrap();
        cell.call("teach");
        assert_eq!(cell.target("given"), cell.target("plainly"));
    }
    println!("{all:?}");
    assert!(all.mm <= 0.0005 && all.deg <= 0.0001, "{all:?}");
}

#[test]
fn the_self_test_tells_the_robot_from_another() {
    let robot = Robot::built_in("irb140").unwrap();
    let model = LiveModel::new(&robot, &table(&paper(1.0)), None, cap()).unwrap();
    let tests = |add_rad: f64| -> Vec<TestTarget> {
        let closed = ClosedForm::new(&robot).unwrap();
        let target = |text: &String| {
            let numbers = cell::numbers(text);
            let mut q_rad = closed.nearest(&cell::pose(&numbers), &[0.0; 6]).unwrap().q_rad;
            let found = closed.solutions(&cell::pose(&numbers));
            if let Some(same) = found.iter().find(|s| closed.agrees(&cell::configuration(&numbers), &s.q_rad))
            {
                q_rad = same.q_rad;
            }
            q_rad[2] += add_rad;
            let (tool, wobj) = ("tT".into(), Some("wW".into()));
            TestTarget { robtarget: text.clone(), tool, wobj, frames: [Isometry3::identity(); 2], q_rad }
        };
        cell::cube_targets().iter().take(7).map(target).collect()
    };
    let shown = |tests: &[TestTarget], prepare: &dyn Fn(&mut Cell)| -> Vec<String> {
        let mut cell = Cell::cube_with(&model, "irb140", tests);
        cell.set("tcF1", 1.0);
        cell.controller.calendar_mut().step_s = 1e-6;
        prepare(&mut cell);
        cell.call("tcSelfTest");
        let shown: Vec<String> = cell.controller.take_messages().into_iter().map(|m| m.text).collect();
        assert!(shown.iter().all(|text| text.len() <= 80), "{shown:?}");
        assert_eq!(cell.controller.arm().unwrap().q_rad(), None, "nothing moves");
        // One conclusion, whatever happens.
        let concludes = |text: &&String| {
            ["are those assumed", "NOT the kinematics", "tcSelfTest: not measured"]
                .iter()
                .any(|part| text.contains(part))
        };
        assert_eq!(shown.iter().filter(concludes).count(), 1, "{shown:?}");
        shown
    };
    let says = |shown: &[String], text: &str| shown.iter().any(|line| line.contains(text));
    for (add_rad, conclusion) in [(0.0, "are those assumed"), (1e-3, "NOT the kinematics assumed")] {
        let shown = shown(&tests(add_rad), &|_| {});
        assert!(says(&shown, conclusion) && says(&shown, "tcSelfTest: ms for a correction 0"), "{shown:?}");
    }
    let run = |text: &'static str| {
        move |cell: &mut Cell| {
            let module = format!("MODULE P\n  PROC prepare()\n    {text}\n  ENDPROC\nENDMODULE\n");
            cell.controller.load("p.mod", module.as_bytes()).unwrap();
            cell.call("prepare");
        }
    };
    let good = tests(0.0);
    // The program has not set its tool yet, or the work object has been moved: the joints are for another one.
    for change in ["tT.tframe.trans.z:=0.02;", "wW.oframe.rot:=OrientZYX(0.2,0,0);", "wW.uframe.trans.x:=-5;"]
    {
        let shown = shown(&good, &run(change));
        assert!(says(&shown, "not measured, a tool or work object is not as in its motion"), "{shown:?}");
    }
    let displaced = shown(&good, &run("PDispSet [[0,0,1],[1,0,0,0]];"));
    assert!(says(&displaced, "not measured, a program displacement is on"), "{displaced:?}");
    // A target that the robot does not reach, and an error of another kind.
    let far = |text: &str| {
        let mut tests = good.clone();
        tests[1].robtarget = text.to_owned();
        tests
    };
    let beyond = shown(&far("[[4000,0,0],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]"), &|_| {});
    assert!(says(&beyond, "a target has no joints"), "{beyond:?}");
    let broken = shown(&good, &run("tT.tframe.rot.q2:=1;"));
    assert!(says(&broken, "tcSelfTest: not measured, error "), "{broken:?}");
    let off = shown(&good, &|cell| cell.controller.set("tcOn", Value::Bool(false)).unwrap());
    assert!(says(&off, "are those assumed") && says(&off, "no time of a correction, original"), "{off:?}");
}

#[test]
fn the_text_is_ascii_short_and_names_begin_with_tc() {
    let robot = turned(&Robot::built_in("irb140").unwrap());
    let functions: Vec<Function> =
        (0..30).map(|_| Function { offsets: all_offsets(), shape: None }).collect();
    let model = LiveModel::new(&robot, &functions, None, cap()).unwrap();
    let tests = [TestTarget {
        robtarget: cell::cube_targets()[0].clone(),
        tool: "tT".into(),
        wobj: None,
        frames: [Isometry3::identity(); 2],
        q_rad: [0.1; 6],
    }];
    for line in model.data(&tests).iter().chain(&model.routines(&tests)) {
        assert!(line.is_ascii() && line.len() <= 200 && !line.contains(['@', '#', '\t']), "{line}");
        assert!(line.split('"').skip(1).step_by(2).all(|string| string.len() <= 80), "{line}");
        let words: Vec<&str> = line.split([' ', '(', '{', ':']).filter(|w| !w.is_empty()).collect();
        let types = ["PROC", "num", "pose", "robtarget", "jointtarget", "robjoint", "bool", "clock"];
        if let (Some(at), false) = (words.iter().position(|w| types.contains(w)), line.contains('!')) {
            assert!(words[at + 1].starts_with("tc") || words[at] != "PROC", "{line}");
        }
    }
}

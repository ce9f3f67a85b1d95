//! Which of the arm's solutions is meant, and what is left alone.

use super::*;
use robot_model::deform::GrowthLaw;
use robot_model::kinematics::{Chain, FrameOffsets};
use robot_model::units::deg_from_rad;

fn planned(program: &Program) -> Plan {
    plan(program, &irb140(), &Deformation::paper(), &Options::default()).unwrap()
}

/// Table 3 of the paper: RoboDK's joints for P19, P20, P21.
#[test]
fn the_papers_joints_are_found_with_and_without_configurations() {
    let table = include_str!("../../../../../fixtures/paper/table3_nominal_joints.csv");
    for configured in [true, false] {
        let plan = planned(&cube45(configured));
        for (line, i) in table.lines().skip(1).zip([19, 20, 21]) {
            let expected: Vec<f64> =
                line.split(',').map(|n| n.trim()).filter_map(|n| n.parse().ok()).rev().take(6).collect();
            for (joint, expected) in expected.iter().rev().enumerate() {
                let found = deg_from_rad(plan.motions[i].targets[0].nominal_q_rad[joint]);
                assert!((found - expected).abs() < 0.005, "P{i} axis {}: {found} for {expected}", joint + 1);
            }
        }
    }
}

#[test]
fn missing_configurations_are_said_once() {
    let plan = planned(&cube45(false));
    assert_eq!(codes(&plan), [("conf::disagrees", Severity::Warning)]);
    // 45 moves disagree: the first is named, 44 more are counted. It stands in line 2.
    let message = &plan.diagnostics[0].message;
    assert!(message.starts_with("line 2:") && message.contains("(44 more"), "{message}");
    assert!(plan.motions.iter().all(|motion| motion.status == Status::Compensated));
}

#[test]
fn without_history_confdata_decides() {
    let mut program = cube45(true);
    program.motions.remove(0);
    program.motions.truncate(5);
    for (i, motion) in program.motions.iter_mut().enumerate() {
        motion.previous = i.checked_sub(1).map(MotionId::new);
    }
    let plan = planned(&program);
    assert_eq!(
        codes(&plan),
        [("conf::unchecked", Severity::Warning)],
        "the first move alone comes from nowhere"
    );
    assert!(plan.motions.iter().all(|m| m.targets[0].nominal_q_rad[4] < 0.0));

    // [0,0,0,0] without anything before it. The cube's first target has q4 = -136.5 deg with joint 5 positive,
    // so no solution of cfx 0 has cf4 = 0.
    let mut unset = cube45(false);
    unset.motions.drain(..1);
    unset.motions.truncate(1);
    unset.motions[0].previous = None;
    let Err(CompensateError::NothingToCompensate { first, .. }) = plan_of(&unset) else { panic!() };
    assert_eq!(first.code, "keep::configuration");
    // Straight above a table the wrist is not twisted: joints 1, 4 and 6 all stand in the first quadrant.
    let down = pose([450.0, 100.0, 300.0], [0.0, 0.0, 1.0, 0.0], [0; 4]);
    let believed = planned(&super::program(vec![motion(Path::Linear, &[down])]));
    assert_eq!(codes(&believed), [("conf::unset", Severity::Warning)]);
    assert!(believed.motions[0].targets[0].nominal_q_rad[4] > 0.0);
}

fn plan_of(program: &Program) -> Result<Plan, CompensateError> {
    plan(program, &irb140(), &Deformation::paper(), &Options::default())
}

#[test]
fn a_joint_move_follows_confdata_or_the_nearest_joints() {
    // The approach's pose on both wrist branches: turning joint 4 and 6 by half a turn and joint 5 over.
    let nominal = Chain::nominal(&irb140());
    let q_rad = APPROACH_DEG.map(rad_from_deg);
    let there = nominal.forward(&q_rad);
    let t = there.translation.vector;
    let q = there.rotation.quaternion();
    let value = |conf| pose([t.x * 1e3, t.y * 1e3, t.z * 1e3], [q.w, q.i, q.j, q.k], conf);
    // Other branch: q4 = 43.53 - 180 = -136.47 (quadrant -2), q5 = 75.61, q6 = -13.29 + 180 = 166.71 (1).
    let other = value([0, -2, 1, 0]);
    let joint = |conf_monitored, value| {
        let mut joint = motion(Path::Joint, &[value]);
        Arc::make_mut(&mut joint.setup).conf_monitored = conf_monitored;
        joint
    };
    let approach = || motion(Path::AbsJoint, &[joints(APPROACH_DEG)]);

    let displaced = planned(&program(vec![approach(), joint(Some(true), other)]));
    let q_deg = displaced.motions[1].targets[0].nominal_q_rad.map(deg_from_rad);
    assert!((q_deg[3] + 136.469_524).abs() < 1e-6 && (q_deg[4] - 75.605_869).abs() < 1e-6);
    assert!((q_deg[5] - 166.712_742).abs() < 1e-6);

    let near = planned(&program(vec![approach(), joint(Some(false), other)]));
    assert!((deg_from_rad(near.motions[1].targets[0].nominal_q_rad[4]) + 75.605_869).abs() < 1e-6);

    // cfx names the branch, whatever the quadrants say.
    let amiss = planned(&program(vec![approach(), joint(Some(true), value([1, 1, 1, 0]))]));
    let q_deg = amiss.motions[1].targets[0].nominal_q_rad.map(deg_from_rad);
    assert!((q_deg[3] + 136.469_524).abs() < 1e-6 && (q_deg[4] - 75.605_869).abs() < 1e-6);
    assert_eq!(codes(&amiss), [("conf::disagrees", Severity::Warning)]);
}

#[test]
fn a_monitored_line_keeps_its_branch_and_says_that_the_controller_will_stop() {
    let mut program = cube45(false);
    program.motions.truncate(2);
    Arc::make_mut(&mut program.motions[1].setup).conf_monitored = Some(true);
    let plan = planned(&program);
    assert_eq!(codes(&plan), [("conf::disagrees", Severity::Warning)]);
    assert!(plan.diagnostics[0].help.as_ref().unwrap().contains("stops"));
    assert!(plan.motions[1].targets[0].nominal_q_rad[4] < 0.0);
}

#[test]
fn what_cannot_be_corrected_is_kept_with_its_reason() {
    let home = motion(Path::AbsJoint, &[joints([0.0; 6])]);
    let far = motion(Path::Linear, &[pose([2000.0, 0.0, 500.0], [0.5, 0.5, 0.5, 0.5], [0; 4])]);
    let beyond = motion(Path::AbsJoint, &[joints([190.0, 0.0, 0.0, 0.0, 30.0, 0.0])]);
    let mut unused = motion(Path::AbsJoint, &[joints(APPROACH_DEG)]);
    let Some(TargetValue::Joint(mut target)) = unused.targets[0].value() else { panic!() };
    target.q_rad[2] = None;
    unused.targets[0] = unused.targets[0].clone().with_value(&TargetValue::Joint(target));
    let mut displaced = motion(Path::AbsJoint, &[joints(APPROACH_DEG)]);
    displaced.skip_reason =
        Some(Arc::new(placement::skip("keep::displaced", "a program displacement may be in force")));
    let mut homeless = motion(Path::Linear, &[pose([500.0, 0.0, 500.0], [0.0, 0.0, 1.0, 0.0], [0; 4])]);
    Arc::make_mut(&mut homeless.setup).tool = None;
    let good = motion(Path::AbsJoint, &[joints(APPROACH_DEG)]);
    let plan = planned(&program(vec![home, far, beyond, unused, displaced, homeless, good]));
    let found: Vec<_> = plan.motions.iter().map(|m| skip_code(&m.status)).collect();
    assert_eq!(
        found,
        [
            "singular::wrist",
            "reach::none",
            "reach::range",
            "keep::axis-unused",
            "keep::displaced",
            "keep::tool-unknown",
            "compensated"
        ]
    );
    assert_eq!(plan.diagnostics.len(), 6);
    assert!(plan.diagnostics.iter().all(|d| d.severity == Severity::Warning && d.span.is_some()));

    let strict = Options { strict: true, ..Options::default() };
    let mut with_home = cube45(true);
    with_home.motions[0] = motion(Path::AbsJoint, &[joints([0.0; 6])]);
    let refused = super::plan(&with_home, &irb140(), &Deformation::paper(), &strict).unwrap();
    assert!(matches!(refused.motions[0].status, Status::Refused(_)));
    assert!(codes(&refused).contains(&("singular::wrist", Severity::Error)));
}

#[test]
fn nothing_to_do_is_an_error() {
    let home = program(vec![motion(Path::AbsJoint, &[joints([0.0; 6])])]);
    let Err(CompensateError::NothingToCompensate {
        motions: 1,
        line: 1,
        first,
        diagnostics,
        kept,
        for_run_time: 0,
    }) = plan_of(&home)
    else {
        panic!()
    };
    assert_eq!((first.code, diagnostics.len()), ("singular::wrist", 1));
    assert_eq!(kept, [first]);
    assert!(matches!(plan_of(&program(vec![])), Err(CompensateError::NoMotion)));
}

#[test]
fn joint_moves_stay_when_asked() {
    for (options, code) in [
        (Options { keep_moveabsj: true, ..Options::default() }, "keep::moveabsj"),
        (Options { absolute_accuracy: true, ..Options::default() }, "keep::absolute-accuracy"),
    ] {
        let plan = plan(&cube45(true), &irb140(), &Deformation::paper(), &options).unwrap();
        assert_eq!(skip_code(&plan.motions[0].status), code);
        assert_eq!(plan.motions[1].status, Status::Compensated);
    }
}

#[test]
fn a_correction_into_a_joint_limit_is_refused() {
    // Joint 1 turned by -0.05° before its own rotation: at its upper limit of 180° it must go on to 180.05°.
    let mut offsets = FrameOffsets::default();
    offsets.0[0][5] = rad_from_deg(-0.05);
    let turned = Deformation::from_static(offsets, GrowthLaw::None);
    let program = program(vec![
        motion(Path::AbsJoint, &[joints([180.0, 10.0, 10.0, 10.0, 30.0, 10.0])]),
        motion(Path::AbsJoint, &[joints([10.0, 10.0, 10.0, 10.0, 30.0, 10.0])]),
    ]);
    let options = Options { max_correction_m: 0.01, ..Options::default() };
    let plan = plan(&program, &irb140(), &turned, &options).unwrap();
    let Status::Refused(why) = &plan.motions[0].status else { panic!("{:?}", plan.motions[0].status) };
    assert_eq!(why.code, "reach::limit");
    assert!(why.reason.contains("180.050"), "{}", why.reason);
    let message = plan.diagnostics.iter().find(|one| one.code == "reach::limit").unwrap();
    let help = message.help.as_deref().unwrap_or_default();
    assert!(help.contains("--keep ") && help.contains("--robot"), "{message:?}");
    assert_eq!(plan.motions[1].status, Status::Compensated);
    let plan::Corrected::Joints { q_rad } = plan.motions[1].corrected(0).unwrap()[0] else { panic!() };
    assert!((deg_from_rad(q_rad[0]) - 10.05).abs() < 1e-9);
    // The base turned under everything: a turn of 0.05° for every pose.
    assert!((deg_from_rad(plan.motions[1].max_correction_rad) - 0.05).abs() < 1e-9);
}

/// Joint 1 turned by -0.8 deg before its own rotation: from 89.9 it must go on to 90.7, more than half a degree into the next quadrant.
#[test]
fn a_correction_into_another_quadrant_is_refused_with_its_joint_and_the_way_out() {
    let mut offsets = FrameOffsets::default();
    offsets.0[0][5] = rad_from_deg(-0.8);
    let turned = Deformation::from_static(offsets, GrowthLaw::None);
    let program = program(vec![motion(Path::AbsJoint, &[joints([89.9, 10.0, 10.0, 10.0, 30.0, 10.0])])]);
    let options = Options { max_correction_m: 0.1, max_correction_rad: 0.1, ..Options::default() };
    let plan = plan(&program, &irb140(), &turned, &options).unwrap();
    let Status::Refused(why) = &plan.motions[0].status else { panic!("{:?}", plan.motions[0].status) };
    assert_eq!(why.code, "refuse::configuration");
    assert!(
        why.reason.ends_with("joint 1 from 89.9000 to 90.7000 deg, quadrant 0 to 1 (cf1)"),
        "{}",
        why.reason
    );
    let message = plan.diagnostics.iter().find(|one| one.code == "refuse::configuration").unwrap();
    assert!(message.help.as_ref().is_some_and(|help| help.contains("--keep ")), "{message:?}");
}

#[test]
fn a_pose_given_by_joints_becomes_a_robtarget() {
    let TargetValue::Joint(target) = joints(APPROACH_DEG) else { panic!() };
    let program = program(vec![motion(Path::Linear, &[TargetValue::FromJoints(target)])]);
    let plan = planned(&program);
    let pose = plan.motions[0].targets[0].pose.as_deref().unwrap();
    // 41.8, 43.5 and -13.3 deg lie in quadrants 0, 0, -1; joint 5 is negative.
    assert_eq!(pose.conf, ConfData { cf1: 0, cf4: 0, cf6: -1, cfx: 1 });
    // RoboDK wrote this joint move for the cube's first target.
    let t = pose.object_from_tcp.translation.vector;
    assert!((t - nalgebra::Vector3::new(0.4, 0.3, 0.25)).norm() < 1e-8, "{t}");
}

#[test]
fn an_arc_is_one_motion_with_two_corrected_points() {
    let wxyz = [0.0, 0.0, 1.0, 0.0];
    let at = |x, y| pose([x, y, 300.0], wxyz, [0; 4]);
    let mut start = motion(Path::Joint, &[at(450.0, 100.0)]);
    Arc::make_mut(&mut start.setup).conf_monitored = Some(true);
    let arc = motion(Path::Circular, &[at(500.0, 150.0), at(550.0, 100.0)]);
    let over = motion(Path::Circular, &[at(2500.0, 150.0), at(550.0, 100.0)]);
    let plan = planned(&program(vec![start, arc, over]));
    assert_eq!(plan.motions[1].targets.len(), 2);
    assert!(plan.motions[1].mid_path.metres().unwrap() < m_from_mm(0.01));
    assert_eq!(skip_code(&plan.motions[2].status), "reach::none");
    assert!(plan.motions[2].targets.is_empty());
}

/// Start, circle point and end lie 670 to 730 mm from axis 1; between them the arc comes to 950, and the wrist goes to 810 at this height.
#[test]
fn an_arc_that_leaves_the_arms_reach_between_its_targets_is_named() {
    let at = |x, y| pose([x, y, 300.0], [0.0, 0.0, 1.0, 0.0], [0; 4]);
    let start = motion(Path::Joint, &[at(500.0, 450.0)]);
    let around = motion(Path::Circular, &[at(578.14, 443.16), at(500.0, -450.0)]);
    let plan = planned(&program(vec![start, around]));
    assert_eq!(plan.motions[1].status, Status::Compensated);
    assert_eq!(plan.motions[1].mid_path, PathDeviation::OutOfReach);
    let named: Vec<&str> = plan.diagnostics.iter().map(|message| message.code).collect();
    assert!(named.contains(&"path::out-of-reach"), "{named:?}");
}

/// Targets all over the workspace, on each branch of theirs and with confdata of that branch and of others, come from near, from
/// another branch and from nowhere: where the written branch alone is answered for, all branches have the same answer.
#[test]
fn the_written_branch_alone_answers_as_all_branches_do() {
    use super::super::branch::{Branch, StartPosture, branch_as_written, branch_of};
    let robot = irb140();
    let rigid = Deformation::from_static(FrameOffsets::default(), GrowthLaw::None);
    let model = model::Model::new(&robot, std::borrow::Cow::Owned(rigid), &Options::default(), None).unwrap();
    let (mut answered, mut left) = (0, 0);
    for n in 0..400_usize {
        let q_rad: [f64; 6] = std::array::from_fn(|j| {
            let [low, high] = robot.joints[j].range_rad.unwrap_or([-3.0, 3.0]);
            low + (high - low) * (0.5 + 0.5 * ((n * 6 + j) as f64 * 12.9898).sin())
        });
        let goal = model.nominal.forward(&q_rad);
        let branches = model.closed.branches(&goal);
        for (cfx, on_branch) in branches.iter().enumerate() {
            let Some(on_branch) = on_branch else { continue };
            for written in model.closed.solutions(&goal) {
                let c = written.configuration;
                // Of one in three the first quadrant is wrong.
                let conf =
                    ConfData { cf1: c.cf1 + i32::from(n % 3 == 2), cf4: c.cf4, cf6: c.cf6, cfx: c.cfx };
                let near = StartPosture::Joints(q_rad.map(|q_rad| q_rad + 1e-3));
                let elsewhere = StartPosture::Joints(written.q_rad);
                for from in [near, elsewhere, StartPosture::Anywhere, StartPosture::UnknownBranch] {
                    for (path, checked) in [
                        (Path::Linear, false),
                        (Path::Linear, true),
                        (Path::Joint, true),
                        (Path::Joint, false),
                    ] {
                        let mut asked = motion(path, &[]);
                        Arc::make_mut(&mut asked.setup).conf_monitored = Some(checked);
                        if usize::try_from(conf.cfx) != Ok(cfx) {
                            continue;
                        }
                        let found = branch_as_written(&asked, on_branch, &conf, &[from], &model);
                        let Some(Branch { q_rad, others, note }) = found else {
                            left += 1;
                            continue;
                        };
                        answered += 1;
                        let all = branch_of(&asked, &goal, &conf, &[from], &model).unwrap();
                        assert_eq!((q_rad, others, note), (all.q_rad, all.others, all.note), "{n} {cfx}");
                    }
                }
            }
        }
    }
    assert!(answered > 2000 && left > 2000, "{answered} {left}");
}

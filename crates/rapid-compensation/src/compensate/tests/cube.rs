//! The reference paper's case, end to end without text.

use super::*;
use crate::schedule::{Until, Width};
use nalgebra::Vector3;
use plan::Corrected;
use robot_model::deform::GrowthLaw;
use robot_model::kinematics::{Chain, ClosedForm};
use robot_model::units::mm_from_m;

/// Where the deformed flange stands when the nominal controller is given a corrected target, by its own
/// route: closed-form inverse of the pose, then forward kinematics of the deformed chain.
struct Controller {
    closed: ClosedForm,
}

impl Controller {
    fn joints(&self, corrected: &Corrected, near: &[f64; 6]) -> [f64; 6] {
        match *corrected {
            Corrected::Joints { q_rad } => q_rad,
            Corrected::Pose { position_m: [x, y, z], orientation_wxyz: [w, i, j, k] } => {
                let rotation = UnitQuaternion::from_quaternion(Quaternion::new(w, i, j, k));
                let pose = Isometry3::from_parts(Translation3::new(x, y, z), rotation);
                self.closed.nearest(&pose, near).unwrap().q_rad
            }
        }
    }
}

fn meant(program: &Program, i: usize, nominal: &Chain, q_rad: &[f64; 6]) -> Vector3<f64> {
    match program.motions[i].targets[0].value().unwrap() {
        TargetValue::Rob(pose) => pose.object_from_tcp.translation.vector,
        TargetValue::Joint(_) | TargetValue::FromJoints(_) => nominal.forward(q_rad).translation.vector,
    }
}

/// The worst distance `[before, after]` over all motions at a minute, metres.
fn worst_at(
    program: &Program,
    plan: &Plan,
    robot: &Robot,
    deformation: &Deformation,
    t_min: f64,
) -> [f64; 2] {
    let controller = Controller { closed: ClosedForm::new(robot).unwrap() };
    let nominal = Chain::nominal(robot);
    let warm = Chain::with_offsets(robot, &deformation.offsets_at(t_min));
    let k = plan.schedule.buckets.iter().rposition(|bucket| bucket.from_min <= t_min).unwrap();
    let mut worst = [0.0_f64; 2];
    for (i, planned) in plan.motions.iter().enumerate() {
        let target = &planned.targets[0];
        let meant = meant(program, i, &nominal, &target.nominal_q_rad);
        let q_rad = controller.joints(&planned.corrected(k).unwrap()[0], &target.nominal_q_rad);
        let far = |q: &[f64; 6]| (warm.forward(q).translation.vector - meant).norm();
        worst = [worst[0].max(far(&target.nominal_q_rad)), worst[1].max(far(&q_rad))];
    }
    worst
}

#[test]
fn the_whole_warm_up_stays_within_the_tolerance() {
    let (program, robot, deformation) = (cube45(true), irb140(), Deformation::paper());
    let plan = plan(&program, &robot, &deformation, &Options::default()).unwrap();
    assert_eq!(plan.diagnostics, []);
    let mut worst = [0.0_f64; 2];
    for k in 0..=2400 {
        let t_min = 0.25 * f64::from(k);
        let [before, after] = worst_at(&program, &plan, &robot, &deformation, t_min);
        worst = [worst[0].max(before), worst[1].max(after)];
        if t_min == 180.0 {
            assert!((mm_from_m(before) - 0.174).abs() < 0.0005, "{before}");
        }
    }
    assert!(mm_from_m(worst[1]) <= 0.005 + 1e-9, "{}", mm_from_m(worst[1]));
    assert!((mm_from_m(worst[0]) - 0.193).abs() < 0.0005);
    // What the plan says of itself is what was found from outside.
    assert!((plan.summary.worst_before_m / worst[0] - 1.0).abs() < 1e-3);
    assert!(plan.summary.worst_after_m >= worst[1] - 1e-14);
    assert!(mm_from_m(plan.summary.worst_after_m) <= 0.005);
}

#[test]
fn buckets_are_the_fewest_or_one_more() {
    // The largest drift, 0.193 mm, in pieces of 0.010 mm.
    let plan = plan(&cube45(true), &irb140(), &Deformation::paper(), &Options::default()).unwrap();
    let fewest = (plan.summary.worst_before_m / 1e-5).ceil() as usize;
    assert_eq!(fewest, 20);
    assert!((fewest..=fewest + 1).contains(&plan.schedule.buckets.len()));
}

#[test]
fn a_settled_deformation_is_taken_out_to_rounding() {
    let (program, robot) = (cube45(true), irb140());
    let settled = Deformation::from_static(Deformation::paper().settled(), GrowthLaw::None);
    let plan = plan(&program, &robot, &settled, &Options::default()).unwrap();
    assert_eq!(plan.schedule.buckets.len(), 1);
    let [before, after] = worst_at(&program, &plan, &robot, &settled, 0.0);
    assert!((mm_from_m(before) - 0.193).abs() < 0.0005);
    assert!(mm_from_m(after) < 1e-8, "{}", mm_from_m(after));
    assert!(mm_from_m(plan.summary.worst_after_m) < 1e-9);
    // The paper's mean over the 45 linear moves.
    let mean = plan.motions[1..].iter().map(|m| m.error_m.unwrap()[0]).sum::<f64>() / 45.0;
    assert!((mm_from_m(mean) - 0.118).abs() < 0.0005);
}

#[test]
fn lines_stay_lines() {
    let plan = plan(&cube45(true), &irb140(), &Deformation::paper(), &Options::default()).unwrap();
    for planned in &plan.motions[1..] {
        let far_mm = mm_from_m(planned.mid_path.metres().unwrap());
        assert!(far_mm < 0.01, "{far_mm}");
    }
    assert_eq!(plan.motions[0].mid_path, PathDeviation::Unknown);
}

#[test]
fn neighbouring_buckets_are_at_most_two_tolerances_apart() {
    let summary = plan(&cube45(true), &irb140(), &Deformation::paper(), &Options::default()).unwrap().summary;
    assert!(summary.worst_switch_jump_m <= 2.0 * 5e-6);
    assert!(summary.worst_switch_jump_m > 8e-6);
    // A shift cannot take out what differs from target to target, but it takes out some.
    assert!(summary.rigid_shift_worst_m > summary.worst_after_m);
    assert!(summary.rigid_shift_worst_m < summary.worst_before_m);
}

#[test]
fn quaternions_keep_their_sign() {
    let mut program = cube45(true);
    for motion in &mut program.motions[20..] {
        let target = &mut motion.targets[0];
        let Some(TargetValue::Rob(mut pose)) = target.value() else { panic!() };
        pose.object_from_tcp.rotation =
            UnitQuaternion::new_unchecked(-pose.object_from_tcp.rotation.into_inner());
        *target = target.clone().with_value(&TargetValue::Rob(pose));
    }
    let plan = plan(&program, &irb140(), &Deformation::paper(), &Options::default()).unwrap();
    for i in 1..plan.motions.len() {
        for k in 0..plan.schedule.buckets.len() {
            let Corrected::Pose { orientation_wxyz, .. } = plan.motions[i].corrected(k).unwrap()[0] else {
                panic!()
            };
            assert_eq!(orientation_wxyz[0] > 0.0, i < 20);
            let norm = orientation_wxyz.iter().map(|x| x * x).sum::<f64>();
            assert!((norm - 1.0).abs() < 1e-14);
        }
    }
}

#[test]
fn corrections_over_the_cap_are_refused_by_line() {
    let options = Options { max_correction_m: m_from_mm(0.1), ..Options::default() };
    let plan = plan(&cube45(true), &irb140(), &Deformation::paper(), &options).unwrap();
    assert!(plan.diagnostics.iter().any(|d| {
        d.severity == Severity::Error && d.code == "refuse::correction" && d.message.starts_with("line 1:")
    }));
    let refused = plan.motions.iter().filter(|m| matches!(m.status, Status::Refused(_))).count();
    assert!(refused > 10 && refused < 46, "{refused}");
    let turned = Options { max_correction_rad: rad_from_deg(0.01), ..Options::default() };
    let plan = super::plan(&cube45(true), &irb140(), &Deformation::paper(), &turned).unwrap();
    assert!(plan.motions.iter().any(|m| matches!(m.status, Status::Refused(_))));
}

#[test]
fn an_early_end_is_said_to_leave_more_than_the_tolerance() {
    let options = Options { until: Until::Minutes(100.0), ..Options::default() };
    let early = plan(&cube45(true), &irb140(), &Deformation::paper(), &options).unwrap();
    assert!(early.schedule.buckets.last().unwrap().from_min <= 100.0);
    assert_eq!(codes(&early), [("schedule::over-tolerance", Severity::Warning)]);
    let wide = Options { width: Width::Fixed { width_min: 30.0 }, ..Options::default() };
    let wide = plan(&cube45(true), &irb140(), &Deformation::paper(), &wide).unwrap();
    assert_eq!(codes(&wide), [("schedule::over-tolerance", Severity::Warning)]);
    assert_eq!(wide.schedule.buckets[1].from_min, 30.0);
}

#[test]
fn every_minute_of_the_papers_three_hours_is_reached() {
    let (program, robot, deformation) = (cube45(true), irb140(), Deformation::paper());
    let options = Options { until: Until::Minutes(180.0), ..Options::default() };
    let plan = plan(&program, &robot, &deformation, &options).unwrap();
    let rows: Vec<_> =
        joints_every_minute(&program, &plan, &robot, &deformation, &options).unwrap().collect();
    assert_eq!(rows.len(), 46 * 181);
    assert_eq!((rows[181].motion.index(), rows[181].t_min, rows[361].t_min), (1, 0.0, 180.0));
    assert!(rows.iter().all(|row| mm_from_m(row.residual_m) < 1e-9));
    // Cold, nothing is corrected: the first linear target's own coordinates.
    let expected = [0.4, 0.3, 0.25];
    assert!(rows[181].position_m.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12));
}

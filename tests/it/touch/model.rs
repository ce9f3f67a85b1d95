//! Touches of a robot that an identified model describes: off already when it is cold, and drifting by one law.

use super::refusals::as_the_table;
use super::shift::{largest_mm, shift_in, with_start_routine};
use super::{Cell, SOURCE, TABLE_TAU_MIN, Truth, job, run, search};
use driftpost::application::Named;
use driftpost::{Compensation, Deformation, ProgramFiles, Robot};
use nalgebra::{Isometry3, UnitQuaternion, Vector3};
use rapid_compensation::compensate::FormChoice;
use robot_model::deform::identified::{Estimate, Growth, Identified, Term, ThermalState};
use robot_model::deform::{Conditions, DeformedArm, EffectKind, GrowthLaw};
use robot_model::kinematics::{ClosedForm, FrameOffsets};
use robot_model::robot::Axis;
use std::sync::Arc;
use virtual_controller::TrueRobot;

const LAW: GrowthLaw = GrowthLaw::TwoStage { tau_min: TABLE_TAU_MIN };

fn term(kind: EffectKind, joint: Option<usize>, growth: Growth, values: &[f64]) -> Term {
    let values = values.iter().map(|&value| Estimate { value, sigma: None }).collect();
    Term { growth, ..Term::plain(kind, joint.map(Axis::at), values) }
}

/// Zeros, geometry and gravity that are there cold, and links and a joint that drift so many times as far as they should.
fn model(drift: f64, [links, joint]: [GrowthLaw; 2]) -> Identified {
    let terms = vec![
        term(EffectKind::JointOffset, Some(1), Growth::Always, &[3e-4]),
        term(EffectKind::LinkGeometry, Some(2), Growth::Always, &[1e-4, 2e-4, -1e-4, 1e-4, 3e-4, -2e-4]),
        term(EffectKind::JointCompliance, Some(1), Growth::Always, &[4e-6]),
        term(EffectKind::ThermalLinkGrowth, None, Growth::Law(links), &[5e-4 * drift, 4e-5]),
        term(EffectKind::ThermalJointDrift, Some(1), Growth::Law(joint), &[4e-4 * drift, -5e-5]),
        term(EffectKind::BaseDrift, None, Growth::Law(joint), &[0.0, 5e-5 * drift, 1e-4 * drift]),
    ];
    Identified { terms, ..Identified::default() }
}

fn compensation(model: Identified, form: FormChoice, touches: bool) -> Compensation {
    let identified = Named::new(model, "model.toml", b"model");
    let mut made = Compensation::with_model(Robot::built_in("irb140").unwrap(), identified).in_form(form);
    made.touch = touches.then(|| job(form, LAW, Some((search(), 0.02))).touch.unwrap());
    made
}

/// A cell with a robot of a model's kind that drifts and cools as it likes.
fn cell(program: &[u8], truth: &Truth) -> Cell {
    let mut cell = Cell::new(program, truth);
    let arm = Robot::built_in("irb140").unwrap();
    let none = Deformation::from_static(FrameOffsets::default(), truth.law);
    cell.robot = TrueRobot::new(arm, none).with_model(&model(truth.amount, [truth.law; 2]), None);
    cell
}

fn worst(cell: &mut Cell) -> f64 {
    cell.work().into_iter().fold(0.0, f64::max)
}

#[test]
fn what_is_off_cold_is_expected_and_only_the_drift_scales() {
    for form in [FormChoice::Ramp, FormChoice::Schedule, FormChoice::Auto] {
        let program = run(&compensation(model(1.0, [LAW; 2]), form, true)).remove(0);
        // A robot as the model says: the cold one is off by tenths of a millimetre, and no touch takes that for warmth.
        let mut same = cell(&program, &as_the_table());
        assert!(worst(&mut same) > 0.3, "the cold arm is off before anything is corrected");
        same.call("tcColdStart");
        assert!(worst(&mut same) < 0.006, "{form:?} {}", worst(&mut same));
        for _ in 0..2 {
            same.call("tcTouch");
            assert_eq!(same.touch_message(), "Touch taken", "{form:?}");
        }
        assert!(same.number("tcHas") < 0.02 && worst(&mut same) < 0.006, "{form:?} {}", same.number("tcHas"));
        // Warm all through, by a third more or less than the model says, and told to be cold.
        for amount in [0.7, 1.3] {
            let mut other = cell(&program, &Truth { worked_min: 600.0, amount, ..as_the_table() });
            other.call("tcColdStart");
            assert!(worst(&mut other) > 0.15, "{form:?} {amount} {}", worst(&mut other));
            for _ in 0..2 {
                other.call("tcTouch");
                other.pass_min(1.0, true);
            }
            let (has, left) = (other.number("tcHas"), worst(&mut other));
            assert!(
                (has - amount).abs() < 0.05 && left < 0.02,
                "{form:?} {amount} {has} {left} {}",
                other.touch_message()
            );
        }
    }
}

#[test]
fn a_few_shifts_are_better_with_touches_than_without() {
    let figures = |every_min: Option<u32>| {
        let job = compensation(model(1.0, [LAW; 2]), FormChoice::Ramp, every_min.is_some());
        let program = with_start_routine(run(&job).remove(0));
        let came = (0..3).map(|seed| {
            let truth = Truth::drawn(seed, 0.02);
            shift_in(&mut cell(&program, &truth), &program, &truth, every_min).rms
        });
        (came.sum::<f64>() / 3.0, every_min.map(|_| largest_mm(&program)))
    };
    let [(with, largest), (without, _)] = [figures(Some(30)), figures(None)];
    // The drift of a program's target alone, by the model's own arms: what the cold arm is off is none of it.
    let largest = largest.unwrap();
    assert!((largest / largest_drift_mm() - 1.0).abs() < 0.02, "{largest} {}", largest_drift_mm());
    println!("model: rms {with} mm with touches, {without} without; drift {largest} mm");
    // Beside the drift as with the paper's table, where 0.018 mm are asked for and 0.193 mm are the largest.
    assert!(with < 0.018 / 0.193 * largest && without > 1.5 * with, "{with} {without}");
}

/// By how much the tip of the settled arm is further off than that of the cold one, at the target where it is most, mm.
fn largest_drift_mm() -> f64 {
    let robot = Arc::new(Robot::built_in("irb140").unwrap());
    let (closed, model) = (ClosedForm::new(&robot).unwrap(), Arc::new(model(1.0, [LAW; 2])));
    let arm = |t_min: f64| {
        let when = ThermalState { t_min, joint_temperature_c: None };
        DeformedArm::of_model(&robot, &FrameOffsets::default(), &model, when)
    };
    let (cold, settled, conditions) = (arm(0.0), arm(f64::INFINITY), Conditions::default());
    let targets = [
        [400.0, 300.0, 250.0],
        [400.0, -300.0, 250.0],
        [400.0, 300.0, 550.0],
        [400.0, -300.0, 550.0],
        [550.0, 150.0, 400.0],
        [550.0, -150.0, 400.0],
        [700.0, 150.0, 400.0],
        [700.0, -150.0, 550.0],
    ];
    let off = |at_mm: [f64; 3]| {
        let turn = UnitQuaternion::from_euler_angles(0.0, std::f64::consts::FRAC_PI_2, 0.0);
        let there = Isometry3::from_parts(Vector3::from(at_mm).scale(1e-3).into(), turn);
        let q_rad = closed.nearest(&there, &[0.0, 0.3, 0.3, 0.0, -0.5, 0.0]).unwrap().q_rad;
        let at = |arm: &DeformedArm| arm.under(&conditions).forward(&q_rad).translation.vector;
        (at(&settled) - at(&cold)).norm() * 1e3
    };
    targets.map(off).into_iter().fold(0.0, f64::max)
}

#[test]
fn more_laws_than_one_and_a_model_that_stays_cold_are_refused_by_name() {
    let refused = |model: Identified| {
        let program = ProgramFiles::one("Cell.mod", SOURCE.as_bytes().to_vec());
        let refusal = compensation(model, FormChoice::Ramp, true).run(&program).err().expect("it is refused");
        let message = &refusal.messages.last().unwrap().diagnostic;
        (message.code, message.message.clone())
    };
    let (code, output_text) = refused(model(1.0, [LAW, GrowthLaw::Exp { tau_min: 20.0 }]));
    assert_eq!(code, "touch::clock");
    assert!(output_text.contains("more laws than") && output_text.contains("exp:20"), "{output_text}");
    let (code, output_text) = refused(model(0.0, [LAW; 2]));
    assert!(code == "touch::clock" && output_text.contains("nothing of the model grows"), "{output_text}");
}

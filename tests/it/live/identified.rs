//! Identified models on top of a table: each effect that RAPID holds, against the deformed arm with the same model.

use super::cell::{Cell, Off, at, cap, table};
use super::{TOOL, WOBJ, paper, turned};
use rapid_program::emit::live::{Function, LiveModel};
use robot_model::deform::identified::{Growth, Identified, Term, ThermalState, Value};
use robot_model::deform::{Conditions, DeformedArm, Payload};
use robot_model::deform::{EffectKind, GrowthLaw};
use robot_model::kinematics::FrameOffsets;
use robot_model::robot::Robot;
use std::sync::Arc;

fn term(kind: EffectKind, joint: Option<usize>, values: &[f64]) -> Term {
    let values = values.iter().map(|&value| Value { value, sigma: None }).collect();
    Term::plain(kind, joint, values)
}

/// How far the corrected arm stands from the program with an identified model on top of the paper's table, settled half.
fn with_model(robot: &Robot, terms: Vec<Term>, functions: &[Function], values: &[f32], t_min: f64) -> Off {
    let model = Identified { terms, ..Identified::default() };
    let live = LiveModel::new(robot, functions, Some(&model), cap()).unwrap();
    let targets = at(robot, 25, TOOL, Some(WOBJ), 8);
    let mut cell = Cell::new(&live, robot, &targets, TOOL, Some(WOBJ));
    for (r, value) in values.iter().enumerate() {
        cell.set(&format!("tcF{}", r + 1), *value);
    }
    let mut offsets = FrameOffsets::default();
    for (function, value) in functions.iter().zip(values) {
        for (to, by) in offsets.0.iter_mut().flatten().zip(function.offsets.0.iter().flatten()) {
            *to += by * f64::from(*value);
        }
    }
    let when = ThermalState { t_min, joint_temperature_c: None };
    let arm = DeformedArm::of_model(&Arc::new(robot.clone()), &offsets, &Arc::new(model), when);
    let payload = Payload { mass_kg: 1.5, cog_m: [0.0, 0.010, 0.060] };
    let conditions = Conditions { payload, ..Conditions::default() };
    cell.controller.set("tcOn", virtual_controller::Value::Bool(false)).unwrap();
    let uncorrected = cell.worst_under(&arm, &conditions);
    assert!(uncorrected.mm > 0.05, "nothing to correct: {uncorrected:?}");
    cell.controller.set("tcOn", virtual_controller::Value::Bool(true)).unwrap();
    cell.worst_under(&arm, &conditions)
}

#[test]
fn what_an_identified_model_found_is_corrected_too() {
    let rad = |deg: f64| deg.to_radians();
    let gear = |n: u32, joint: usize| Term {
        n: Some(n),
        ..term(EffectKind::GearMesh, Some(joint), &[rad(0.004), rad(-0.002)])
    };
    let coupled = Term { joint_b: Some(5), ..term(EffectKind::JointCoupling, Some(4), &[2e-4]) };
    let softness = |joint: usize, links: [f64; 6]| {
        let [a, b, c, d, e, f] = links;
        term(EffectKind::JointCompliance, Some(joint), &[3e-6, a, b, c, d, e, f])
    };
    let uneven = [0.0, 1e-6, -5e-7, 3e-7, 0.0, 2e-7];
    let cases: Vec<(&str, Vec<Term>)> = vec![
        (
            "offset",
            (0..6).map(|j| term(EffectKind::JointOffset, Some(j), &[rad(0.01 - 0.003 * j as f64)])).collect(),
        ),
        ("geometry", vec![term(EffectKind::LinkGeometry, Some(1), &[1e-4, -5e-5, 8e-5, 1e-4, -5e-5, 7e-5])]),
        ("compliance", vec![softness(1, [0.0; 6]), softness(2, [0.0; 6]), softness(4, [0.0; 6])]),
        ("uneven compliance", vec![softness(1, uneven), softness(2, [0.0; 6]), softness(3, uneven)]),
        ("gain", vec![term(EffectKind::JointGain, Some(0), &[2e-4]), coupled]),
        ("once a turn", vec![term(EffectKind::GearEccentricity, Some(2), &[rad(0.01), rad(0.005)])]),
        ("gear", vec![gear(2, 1), gear(40, 2), gear(100, 0)]),
        (
            "steps",
            vec![
                term(EffectKind::BaseStep, None, &[1e-4, 0.0, -1e-4, 1e-4, 0.0, 0.0]),
                term(EffectKind::ToolStep, None, &[1e-4, 5e-5, -1e-4]),
            ],
        ),
    ];
    let built_in = Robot::built_in("irb140").unwrap();
    for robot in [turned(&built_in), built_in] {
        for (what, terms) in &cases {
            let off = with_model(&robot, terms.clone(), &table(&paper(1.0)), &[0.5], 0.0);
            println!("{what}: {off:?}");
            assert!(off.mm <= 0.0015 && off.deg <= 0.0002, "{what}: {off:?}");
            // Without a table there is no function of time at all.
            let alone = with_model(&robot, terms.clone(), &[], &[], 0.0);
            assert!(alone.mm <= 0.0015 && alone.deg <= 0.0002, "{what}: {alone:?}");
        }
    }
}

#[test]
fn terms_grow_by_the_function_that_is_their_growth() {
    let slow = Growth::Law(GrowthLaw::Exp { tau_min: 60.0 });
    let fast = Growth::Law(GrowthLaw::TwoStage { tau_min: 15.0 });
    let terms = vec![
        Term { growth: slow, ..term(EffectKind::ThermalLinkGrowth, None, &[2e-4, 3e-5]) },
        Term { growth: fast, ..term(EffectKind::ThermalJointDrift, Some(1), &[1e-4, -2e-5]) },
        Term { growth: slow, ..term(EffectKind::BaseDrift, None, &[1e-4, 2e-5, 0.0, 0.0, 1e-4, 0.0]) },
        Term { growth: fast, ..term(EffectKind::ToolDrift, None, &[0.0, 5e-5, 5e-5]) },
    ];
    let functions = [
        Function { offsets: paper(0.5), shape: Some(fast) },
        Function { offsets: FrameOffsets::default(), shape: Some(slow) },
    ];
    let robot = Robot::built_in("irb140").unwrap();
    let t_min = 30.0_f64;
    let values = [1.0 - 3.0 * (-2.0_f64).exp(), 1.0 - (-t_min / 60.0).exp()].map(|x| x as f32);
    let off = with_model(&robot, terms, &functions, &values, t_min);
    assert!(off.mm <= 0.001 && off.deg <= 0.0001, "{off:?}");
}

#[test]
fn what_rapid_cannot_hold_is_named() {
    let robot = Robot::built_in("irb140").unwrap();
    let by_temperature = Growth::Temperature { from_c: [20.0; 6].into(), to_c: [40.0; 6].into() };
    let of_its_own = Growth::Law(GrowthLaw::Exp { tau_min: 7.0 });
    for (terms, names) in [
        (
            vec![term(EffectKind::Backlash, Some(0), &[1e-4]), term(EffectKind::Backlash, Some(1), &[1e-4])],
            vec!["backlash"],
        ),
        (
            vec![term(EffectKind::LinkBending, Some(1), &[1e-6]), term(EffectKind::BaseTilt, None, &[1e-6])],
            vec!["link_bending", "base_tilt"],
        ),
        (vec![term(EffectKind::PayloadMass, None, &[1.0])], vec!["payload_mass"]),
        (vec![term(EffectKind::GearSpectrum, Some(0), &[1e-4, 0.0])], vec!["gear_spectrum"]),
        (
            vec![Term { growth: by_temperature, ..term(EffectKind::BaseDrift, None, &[1e-4]) }],
            vec!["base_drift by temperature"],
        ),
        (
            vec![Term { growth: of_its_own, ..term(EffectKind::BaseDrift, None, &[1e-4]) }],
            vec!["base_drift with a growth of its own"],
        ),
        (vec![term(EffectKind::InstrumentScale, None, &[1e-4])], vec![]),
    ] {
        let model = Identified { terms, ..Identified::default() };
        let made = LiveModel::new(&robot, &table(&paper(1.0)), Some(&model), cap());
        assert_eq!(made.err().unwrap_or_default(), names);
    }
}

#[test]
fn gravity_and_gears_take_some_hundred_operations() {
    let robot = Robot::built_in("irb140").unwrap();
    let gear = Term { n: Some(40), ..term(EffectKind::GearMesh, Some(1), &[1e-4, 1e-4]) };
    let softness: Vec<Term> = (0..6)
        .map(|j| term(EffectKind::JointCompliance, Some(j), &[3e-6, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]))
        .collect();
    for (terms, most, twice) in [(softness, 500, false), (vec![gear], 250, true)] {
        let model = Identified { terms, ..Identified::default() };
        let live = LiveModel::new(&robot, &table(&paper(1.0)), Some(&model), cap()).unwrap();
        assert_eq!(live.evaluates_twice(), twice);
        let text = live.routines(&[]).join("\n");
        let (operations, trigonometric) =
            super::cell::operations(&text, &["tcLive", "tcLiveSame", "tcFits", "tcCorrect"]);
        println!("{operations} operations, {trigonometric} sines and cosines");
        assert!(operations <= most, "{operations}");
    }
}

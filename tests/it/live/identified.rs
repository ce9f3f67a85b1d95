//! Identified models on top of a table: each effect that RAPID holds, against the deformed arm with the same model.

use super::cell::{Cell, Off, at, cap, table};
use super::{TOOL, WOBJ, paper, turned};
use rapid_compensation::emit::live::{Function, LiveModel};
use robot_model::deform::identified::{Estimate, Growth, Identified, Term, ThermalState};
use robot_model::deform::{Conditions, DeformedArm, Payload};
use robot_model::deform::{EffectKind, GrowthLaw};
use robot_model::kinematics::FrameOffsets;
use robot_model::robot::{Axis, Robot};
use std::sync::Arc;

fn term(kind: EffectKind, joint: Option<usize>, values: &[f64]) -> Term {
    let values = values.iter().map(|&value| Estimate { value, sigma: None }).collect();
    Term::plain(kind, joint.map(Axis::at), values)
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
    assert!(uncorrected.mm > 0.01, "nothing to correct: {uncorrected:?}");
    cell.controller.set("tcOn", virtual_controller::Value::Bool(true)).unwrap();
    cell.worst_under(&arm, &conditions)
}

fn gear(n: u32, joint: usize) -> Term {
    Term { n: Some(n), ..term(EffectKind::GearMesh, Some(joint), &[rad(0.004), rad(-0.002)]) }
}

fn softness(joint: usize, links: [f64; 6]) -> Term {
    let [a, b, c, d, e, f] = links;
    term(EffectKind::JointCompliance, Some(joint), &[3e-6, a, b, c, d, e, f])
}

/// Links that count for more or less, in another way at each joint.
fn uneven(joint: usize) -> [f64; 6] {
    let more = 1.0 + 0.25 * joint as f64;
    [0.0, 1e-6, -5e-7, 3e-7, 0.0, 2e-7].map(|x| x * more)
}

fn rad(deg: f64) -> f64 {
    deg.to_radians()
}

fn offsets() -> Vec<Term> {
    (0..6).map(|j| term(EffectKind::JointOffset, Some(j), &[rad(0.01 - 0.003 * j as f64)])).collect()
}

fn gains() -> Vec<Term> {
    let coupled = Term { joint_b: Some(Axis::at(5)), ..term(EffectKind::JointCoupling, Some(4), &[2e-4]) };
    vec![term(EffectKind::JointGain, Some(0), &[2e-4]), coupled]
}

fn geometry(joint: usize) -> Term {
    term(EffectKind::LinkGeometry, Some(joint), &[1e-4, -5e-5, 8e-5, 1e-4, -5e-5, 7e-5])
}

#[test]
fn what_an_identified_model_found_is_corrected_too() {
    let cases: Vec<(&str, Vec<Term>)> = vec![
        ("offset", offsets()),
        ("geometry", vec![geometry(1)]),
        ("compliance", vec![softness(1, [0.0; 6]), softness(2, [0.0; 6]), softness(4, [0.0; 6])]),
        ("uneven compliance", vec![softness(1, uneven(0)), softness(2, [0.0; 6]), softness(3, uneven(2))]),
        ("gain", gains()),
        ("once a turn", vec![term(EffectKind::GearEccentricity, Some(2), &[rad(0.01), rad(0.005)])]),
        ("gear", vec![gear(2, 1), gear(40, 2), gear(100, 0)]),
        ("gears and a gain", [gains(), vec![gear(1, 1), gear(3, 1), gear(7, 1), gear(80, 4)]].concat()),
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

/// One frame off in one direction: in straight-line RAPID most of the twist is then zero on the way, and what was something and is zero again
/// has to be zero where the tool's lever reads it.
#[test]
fn each_frame_alone_is_corrected_in_each_direction() {
    let built_in = Robot::built_in("irb140").unwrap();
    for robot in [turned(&built_in), built_in] {
        for (joint, direction) in (0..6).flat_map(|joint| (0..6).map(move |direction| (joint, direction))) {
            let mut values = [0.0; 6];
            values[direction] = if direction < 3 { 1e-4 } else { 4e-4 };
            let terms = vec![term(EffectKind::LinkGeometry, Some(joint), &values)];
            let off = with_model(&robot, terms, &[], &[], 0.0);
            assert!(off.mm <= 0.0015 && off.deg <= 0.0002, "joint {joint}, direction {direction}: {off:?}");
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

/// Of a model on top of a table of so many laws: arithmetic and trigonometric operations of the dearest call, as executed.
fn effort(terms: Vec<Term>, laws: usize) -> (u64, u64) {
    let robot = Robot::built_in("irb140").unwrap();
    let shape = Growth::Law(GrowthLaw::TwoStage { tau_min: 15.0 });
    let functions: Vec<Function> = (0..laws)
        .map(|r| match r {
            0 => Function { offsets: paper(1.0), shape: Some(shape) },
            _ => Function {
                offsets: FrameOffsets(super::all_offsets().0.map(|f| f.map(|x| 0.1 * x))),
                shape: None,
            },
        })
        .collect();
    let model = Identified { terms, ..Identified::default() };
    let live = LiveModel::new(&robot, &functions, Some(&model), cap()).unwrap();
    let targets = at(&robot, 10, TOOL, Some(WOBJ), 8);
    let mut cell = Cell::new(&live, &robot, &targets, TOOL, Some(WOBJ));
    (0..laws).for_each(|r| cell.set(&format!("tcF{}", r + 1), 0.1));
    let effort = cell.effort();
    (effort.arithmetic, effort.trigonometric)
}

/// What a call takes with each kind of model: 12 sines and cosines at most, and no more operations than docs/FORMS.md says, 700 at most.
#[test]
fn every_kind_of_model_is_within_what_a_controller_has_time_for() {
    let gears = |lines: &[u32]| -> Vec<Term> {
        (0..6).flat_map(|joint| lines.iter().map(move |n| gear(*n, joint))).collect()
    };
    let soft = || (0..6).map(|j| softness(j, [0.0; 6])).collect::<Vec<Term>>();
    let softer = || (0..6).map(|j| softness(j, uneven(j))).collect::<Vec<Term>>();
    let frames = || (0..5).map(geometry).collect::<Vec<Term>>();
    let many = || (0..8).map(|k| gear([40, 80, 36, 100][k % 4], k % 6)).collect::<Vec<Term>>();
    let fast = Growth::Law(GrowthLaw::TwoStage { tau_min: 15.0 });
    let growing = || {
        let drift = |j| Term { growth: fast, ..term(EffectKind::ThermalJointDrift, Some(j), &[1e-4, -2e-5]) };
        (0..6).map(drift).collect::<Vec<Term>>()
    };
    let mut over = Vec::new();
    for (what, terms, laws, most) in [
        ("a table of one law", vec![], 1, 144),
        ("a table of six laws", vec![], 6, 169),
        ("zeros", offsets(), 1, 145),
        ("zeros that drift", growing(), 2, 175),
        ("geometry of all links", frames(), 1, 159),
        ("gains and a coupling", gains(), 1, 143),
        ("three gear lines", vec![gear(2, 1), gear(40, 2), gear(100, 0)], 1, 373),
        ("eight gear lines", many(), 1, 621),
        ("once and twice a turn on every joint", gears(&[1, 2]), 1, 382),
        ("compliance of all joints", soft(), 1, 332),
        ("compliance, each link for itself", softer(), 1, 404),
        (
            "compliance and three gear lines, six laws",
            [soft(), vec![gear(2, 1), gear(40, 2), gear(100, 0)]].concat(),
            6,
            596,
        ),
        (
            "all of it, once and twice a turn, six laws",
            [offsets(), frames(), gains(), softer(), gears(&[1, 2])].concat(),
            6,
            693,
        ),
    ] {
        let (arithmetic, trigonometric) = effort(terms, laws);
        println!("{what}: {arithmetic} operations, {trigonometric} sines and cosines");
        if arithmetic > most || trigonometric > 12 {
            over.push((what, arithmetic, trigonometric));
        }
    }
    assert_eq!(over, []);
}

//! Planned measurements: what is planned can be driven, is what the sheet says, and tells more than chance.

use assert_cmd::Command;
use driftpost::application::Planning;
use exam::effect::Effect;
use exam::generate::{data_set, planned_set};
use exam::harmonics::Harmonics;
use exam::poses::CommandedRow;
use exam::recipe::Recipe;
use exam::rng::Rng;
use inference::signature::{PlannedMeasurement, signatures};
use measurements::Measurements;
use metrology::admissible::Space;
use metrology::diagnose::{DiagnosisOptions, Findings, diagnose};
use metrology::plan::{
    MeasurementPlan, MeasurementStep, PlanOptions, Sweeps, plan, plan_from, rapid, template_csv,
};
use nalgebra::{DMatrix, DVector, Vector3};
use rayon::prelude::*;
use robot_model::kinematics::SerialChain;
use robot_model::robot::{Axis, SerialArm};
use virtual_controller::Controller;

fn options(n: usize, repeats: usize) -> PlanOptions {
    PlanOptions {
        tool_m: Vector3::new(0.08, 0.06, 0.1),
        n,
        repeats,
        sweeps: Sweeps::default(),
        payloads_kg: vec![0.0, 5.0],
        nests: 0,
        sigma_m: 2e-5,
        each_min: 1.5,
        space: Space { floor_m: 0.1, reach_m: None, box_m: None },
        seed: 7,
    }
}

fn arm_steps(plan: &MeasurementPlan) -> Vec<CommandedRow> {
    plan.steps
        .iter()
        .filter_map(|step| match *step {
            MeasurementStep::Pose { pose, q_rad, direction, payload_kg, .. } => {
                Some(CommandedRow { pose, q_rad, direction, payload_kg })
            }
            MeasurementStep::Nest { .. } => None,
        })
        .collect()
}

#[test]
fn what_is_planned_keeps_to_its_room_and_runs_as_the_sheet_says() {
    let robot = SerialArm::built_in("irb140").unwrap();
    let options = PlanOptions {
        nests: 2,
        space: Space { floor_m: 0.2, reach_m: Some(0.7), box_m: Some([[0.0, -0.6, 0.2], [0.8, 0.6, 1.0]]) },
        ..options(24, 4)
    };
    let planned = plan_from(&robot, &options, 120, 1).unwrap();
    let robot_under_test = plan_from(&robot, &options, 120, 1).unwrap();
    assert_eq!(planned.steps, robot_under_test.steps);
    let rows = arm_steps(&planned);
    assert_eq!(rows.len(), 24);
    assert_eq!(rows.iter().map(|r| r.pose).collect::<std::collections::BTreeSet<_>>().len(), 20);
    let nests = planned.steps.len() - rows.len();
    // Before rows 1, 11 and 21, and at the end.
    assert_eq!(nests, 2 * 4);
    let chain = SerialChain::nominal(&robot);
    for step in &planned.steps {
        let MeasurementStep::Pose { q_rad, approach_rad, direction, .. } = step else { continue };
        assert!(robot.is_within_range(q_rad) && robot.is_within_range(approach_rad));
        for j in 0..6 {
            let moved = q_rad[j] - approach_rad[j];
            assert!((moved - f64::from(direction[j]) * 3.0_f64.to_radians()).abs() < 1e-12);
        }
        let flange = chain.forward(q_rad);
        let point = flange.translation.vector + flange.rotation * options.tool_m;
        assert!(point.z >= 0.2 && flange.translation.z >= 0.2, "{point}");
        assert!(
            point.xy().norm() <= 0.7 && point.x >= 0.0 && point.y.abs() <= 0.6 && point.z <= 1.0,
            "{point}"
        );
        assert!(q_rad[4].abs() >= 10.0_f64.to_radians());
    }

    // The sheet, filled in with what a perfect robot would show.
    let sheet = template_csv(&planned, &robot);
    let mut filled = String::new();
    for (k, line) in sheet.lines().enumerate() {
        let cells: Vec<&str> = line.split(',').collect();
        assert_eq!(cells.len(), 21, "{line}");
        match k {
            0 => filled.push_str(line),
            _ => {
                let head = cells[..4].join(",");
                filled.push_str(&format!("{head},{k},{},1,2,3", cells[5..18].join(",")));
            }
        }
        filled.push('\n');
    }
    let read = Measurements::from_csv(filled.as_bytes()).unwrap();
    assert!(read.warnings.is_empty(), "{:?}", read.warnings);
    assert_eq!(read.fixed_points, ["N1", "N2"]);
    let sheet_rows: Vec<_> = read.rows.iter().filter(|r| r.reading.involves_arm()).collect();

    // The module on the virtual controller: every second move ends at a row's joints, come to from its side.
    let six = robot.six_axis().unwrap();
    let text = rapid(&planned, &six, "DriftpostPlan");
    assert!(text.is_ascii() && text.lines().all(|l| l.len() <= 255), "{text}");
    let mut controller = Controller::with_robot(&six).unwrap();
    controller.load("DriftpostPlan.mod", text.as_bytes()).unwrap();
    controller.call("dpMeasure", 1).unwrap();
    let moves = controller.arm_mut().unwrap().take_moves();
    assert_eq!(moves.len(), 2 * sheet_rows.len());
    for (row, made) in sheet_rows.iter().zip(moves.iter().skip(1).step_by(2)) {
        let q_rad = made.q_rad.unwrap();
        // RAPID's numbers are single precision.
        assert!(q_rad.iter().zip(&row.q_rad).all(|(a, b)| (a - b).abs() < 1e-6), "line {}", row.line);
        assert_eq!(Some(made.direction.into()), row.direction, "line {}", row.line);
    }
}

#[test]
fn separation_is_what_a_regression_leaves() {
    let robot = SerialArm::built_in("irb140").unwrap();
    let tool_m = Vector3::new(0.08, 0.06, 0.1);
    let planned = plan_from(&robot, &options(30, 0), 60, 0).unwrap();
    let sigma_m = 2e-5;
    let run: Vec<PlannedMeasurement> = arm_steps(&planned)
        .iter()
        .enumerate()
        .map(|(k, r)| PlannedMeasurement {
            q_rad: r.q_rad,
            direction: r.direction,
            payload_kg: r.payload_kg,
            t_min: 1.5 * k as f64,
            nest: None,
        })
        .collect();
    let s = signatures(&robot, tool_m, &run);
    let rows = s.rows.len() / s.width;
    let whole = DMatrix::from_row_slice(rows, s.width, &s.rows) / sigma_m;
    // Generalised least squares by its normal equations over the registration and geometry with prior 1, densely.
    let n = s.registration + s.geometry;
    let mut padded = DMatrix::zeros(rows + s.geometry, n);
    padded.view_mut((0, 0), (rows, n)).copy_from(&whole.columns(0, n));
    for g in 0..s.geometry {
        padded[(rows + g, s.registration + g)] = 1.0;
    }
    let svd = padded.clone().svd(true, true);
    for parameter in planned.outlook.parameters.iter().filter(|p| p.of.effect.name() == "joint_compliance") {
        let effect = s
            .effects
            .iter()
            .find(|e| e.effect.name() == "joint_compliance" && e.joint == parameter.of.joint)
            .unwrap();
        let mut column = DVector::zeros(rows + s.geometry);
        column.rows_mut(0, rows).copy_from(&whole.column(effect.first));
        let fitted = &padded * svd.solve(&column, 1e-12).unwrap();
        let left = (column - fitted).norm_squared();
        let sigma = effect.usual / left.sqrt();
        assert!((parameter.sigma / sigma - 1.0).abs() < 1e-3, "{parameter:?}: {sigma}");
    }
}

/// Sweeps of two joints: equal steps of one joint, the others still, and its lines better known than without.
#[test]
fn a_sweep_moves_one_joint_in_small_steps_and_tells_its_lines() {
    let robot = SerialArm::built_in("irb140").unwrap();
    let plain = plan_from(&robot, &options(24, 0), 120, 0).unwrap();
    let sweeps = Sweeps { joints: vec![Axis::at(1), Axis::at(2)], n: 40, step_rad: 0.5_f64.to_radians() };
    let swept = plan_from(&robot, &PlanOptions { sweeps, ..options(24, 0) }, 120, 0).unwrap();
    let (before, after) = (arm_steps(&plain), arm_steps(&swept));
    assert_eq!(before[..], after[..24]);
    assert_eq!(after.len(), 24 + 80);
    for (joint, rows) in [(1, &after[24..64]), (2, &after[64..])] {
        for pair in rows.windows(2) {
            for j in 0..6 {
                let step = if j == joint { 0.5_f64.to_radians() } else { 0.0 };
                assert!((pair[1].q_rad[j] - pair[0].q_rad[j] - step).abs() < 1e-12);
            }
            assert_eq!(pair[0].direction, [1; 6]);
            assert_ne!(pair[0].pose, pair[1].pose);
        }
        assert!(rows.iter().all(|row| robot.is_within_range(&row.q_rad)));
    }
    // Each joint keeps 5 deg from its ends, in all poses of all seeds, swept ones too.
    let robot = SerialArm::built_in("irb2600").unwrap();
    for seed in 0..4 {
        let sweeps = Sweeps { joints: vec![Axis::at(1), Axis::at(2)], n: 20, step_rad: 0.5_f64.to_radians() };
        let options = PlanOptions { seed, sweeps, ..options(24, 0) };
        for row in arm_steps(&plan_from(&robot, &options, 120, 0).unwrap()) {
            for (joint, q_rad) in robot.joints.iter().zip(&row.q_rad) {
                let [low, high] = joint.range_rad.unwrap().map(f64::to_degrees);
                let q_deg = q_rad.to_degrees();
                assert!(
                    (low + 5.0 - 1e-9..=high - 5.0 + 1e-9).contains(&q_deg),
                    "{q_deg} of {low} to {high}"
                );
            }
        }
    }
    let robot = SerialArm::built_in("irb140").unwrap();
    let lines = |plan: &MeasurementPlan, joint: usize| {
        plan.outlook.lines.iter().find(|l| Some(l.joint) == Axis::numbered(joint)).cloned().unwrap()
    };
    for joint in [2, 3] {
        let (without, with) = (lines(&plain, joint), lines(&swept, joint));
        assert_eq!(without.of, 318);
        assert!(with.sigma < 0.8 * without.sigma, "{} {}", with.sigma, without.sigma);
        assert!(with.told_apart >= without.told_apart, "{} {}", with.told_apart, without.told_apart);
    }
    let far = Sweeps { joints: vec![Axis::at(4)], n: 500, step_rad: 1.0 };
    let refused = plan_from(&robot, &PlanOptions { sweeps: far, ..options(24, 0) }, 60, 0);
    assert_eq!(refused.unwrap_err().to_string().split(" cannot").next(), Some("joint 5"));
}

#[test]
fn a_robot_without_room_is_told_so() {
    let output =
        Command::cargo_bin("driftpost").unwrap().args(["plan", "--floor-mm", "900"]).output().unwrap();
    let answer = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2));
    assert!(answer.contains("plan::no-room") && answer.contains("floor"), "{answer}");
}

/// What is asked of both: an effect of the given joint, its poses' number.
fn recipe(effect: Effect, rho: f64, n: usize) -> Recipe {
    Recipe {
        repeats: n / 6,
        geometry: 0.5,
        payloads_kg: [0.0, 5.0],
        ..crate::recipe::planted(vec![(effect, rho)], n)
    }
}

fn right(found: &Findings, effect: &Effect) -> bool {
    found.causes.first().is_some_and(|c| {
        Some(c.effect.name()) == effect.name()
            && (effect.joint().is_none() || c.joint == effect.joint().and_then(Axis::numbered))
    })
}

/// First answers right of random and of planned poses, of how many: the same effects at the same true sizes.
fn contest(planned: &MeasurementPlan, tool_m: Vector3<f64>, rho: f64, seeds: u64) -> [usize; 3] {
    let robot = SerialArm::built_in("irb140").unwrap();
    let rows = arm_steps(planned);
    let effects: Vec<Effect> = (2..=5)
        .flat_map(|joint| {
            [
                Effect::JointOffset { joint },
                Effect::JointCompliance { joint },
                Effect::GearEccentricity { joint, phase_rad: 0.7, harmonics: Harmonics::NONE },
                Effect::GearSecondHarmonic { joint, phase_rad: 0.7, harmonics: Harmonics::NONE },
                Effect::JointGain { joint },
                Effect::Backlash { joint, holding_n_m: 1e3 },
            ]
        })
        .collect();
    let cases: Vec<(Effect, u64)> = effects.iter().flat_map(|e| (0..seeds).map(|s| (*e, s))).collect();
    let scores: Vec<[usize; 3]> = cases
        .par_iter()
        .map(|(effect, seed)| {
            let recipe = recipe(*effect, rho, rows.len());
            let Some(random) = data_set(&robot, "irb140", &recipe, &mut Rng::new(*seed, 0)) else {
                return [0; 3];
            };
            let size = random.truth.effects[0].amplitude;
            // The random poses with the same tool and the same true effect: only the poses differ.
            let driven = Measurements::from_csv(random.csv.as_bytes()).unwrap();
            let driven: Vec<CommandedRow> = driven
                .rows
                .iter()
                .map(|row| CommandedRow {
                    pose: row.pose,
                    q_rad: row.q_rad,
                    direction: row.direction.unwrap(),
                    payload_kg: row.payload_kg.unwrap(),
                })
                .collect();
            let measured = |rows: &[CommandedRow]| {
                let mut rng = Rng::new(*seed, 1);
                planned_set(&robot, "irb140", &recipe, tool_m, rows, &[size], &mut rng).unwrap()
            };
            let (random, chosen) = (measured(&driven), measured(&rows));
            let score = |csv: &str| {
                let read = Measurements::from_csv(csv.as_bytes()).unwrap();
                let found = diagnose(&read, &robot, &DiagnosisOptions { tool_m: None, sigma_m: Some(2e-5) });
                usize::from(right(&found, effect))
            };
            [score(&random.csv), score(&chosen.csv), 1]
        })
        .collect();
    scores.iter().fold([0; 3], |sum, s| std::array::from_fn(|k| sum[k] + s[k]))
}

#[test]
#[ignore = "minutes; run with --release: docs/PLAN.md has its figures"]
fn sixty_planned_poses_beat_sixty_random_ones() {
    let robot = SerialArm::built_in("irb140").unwrap();
    let options = options(60, 10);
    let planned = plan(&robot, &options).unwrap();
    let mut all = [0; 3];
    for rho in [0.5, 1.0] {
        let [random, chosen, n] = contest(&planned, options.tool_m, rho, 4);
        println!("rho {rho}: first answers right of {n}: random {random}, planned {chosen}");
        all = [all[0] + random, all[1] + chosen, all[2] + n];
    }
    println!("all: random {} planned {} of {}", all[0], all[1], all[2]);
    assert!(all[1] > all[0], "{all:?}");
}

#[test]
fn planned_poses_tell_more_than_random_ones() {
    let robot = SerialArm::built_in("irb140").unwrap();
    let options = options(24, 0);
    let chance = plan_from(&robot, &options, 200, 0).unwrap();
    let planned = plan_from(&robot, &options, 200, 1).unwrap();
    assert!(planned.exchanges > 10, "{}", planned.exchanges);
    // Pairs whose first effect is seen at its usual size (20 times the noise, squared) and told from the second.
    let told_apart = |p: &MeasurementPlan| {
        let all = &p.outlook.parameters;
        let seen = all.iter().filter(|p| (p.usual / p.sigma).powi(2) >= 20.0).count();
        seen * (all.len() - 1) - p.outlook.confounded.len()
    };
    let (of_plan, of_chance) = (told_apart(&planned), told_apart(&chance));
    println!("pairs told apart: planned {of_plan}, random {of_chance}");
    assert!(of_plan > of_chance, "{of_plan} {of_chance}");
    let sigma = |p: &MeasurementPlan| {
        let logs: Vec<f64> = p
            .outlook
            .parameters
            .iter()
            .filter(|p| {
                ["joint_offset", "joint_compliance", "gear_eccentricity", "joint_gain"]
                    .contains(&p.of.effect.name())
            })
            .map(|p| (p.sigma / p.usual).ln())
            .collect();
        (logs.iter().sum::<f64>() / logs.len() as f64).exp()
    };
    assert!(sigma(&planned) < 0.95 * sigma(&chance), "{} {}", sigma(&planned), sigma(&chance));
}

/// An IRB 140-6/0.8 carries 6 kg.
#[test]
fn a_payload_that_the_arm_may_not_carry_is_named() {
    let robot = SerialArm::built_in("irb140").unwrap();
    let warned = |payloads_kg: Vec<f64>| {
        let mut job = Planning::new(robot.clone());
        job.options.payloads_kg = payloads_kg;
        job.warnings().into_iter().map(|warning| warning.message).collect::<Vec<_>>()
    };
    assert_eq!(warned(vec![0.0, 6.0]), [""; 0]);
    assert_eq!(warned(vec![0.0, 5000.0]), ["--payloads-kg 5000: ABB IRB 140-6/0.8 carries 6 kg by its name"]);
}

//! Every figure of `docs/PAPER.md`: what is printed here stands there, line by line.

use assert_cmd::Command;
use nalgebra::{DMatrix, DVector, Isometry3, Translation3, UnitQuaternion};
use robot_model::deform::{Deformation, GrowthLaw};
use robot_model::kinematics::{Chain, FrameOffsets, solve};
use robot_model::robot::Robot;
use std::f64::consts::FRAC_PI_2;

/// Prints a line and wants it in the page.
fn stands(line: &str) {
    println!("{line}");
    let page = std::fs::read_to_string("docs/PAPER.md").unwrap();
    assert!(page.lines().any(|l| l.trim() == line.trim()), "docs/PAPER.md does not have this line: {line}");
}

fn driftpost(args: &[&str]) -> String {
    let output = Command::cargo_bin("driftpost").unwrap().args(args).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

fn mm(m: f64) -> f64 {
    robot_model::units::mm_from_m(m)
}

/// Rows of a fixture: name, numbers.
fn rows(file: &str) -> Vec<(String, Vec<f64>)> {
    let text = std::fs::read_to_string(format!("fixtures/paper/{file}")).unwrap();
    text.lines()
        .skip(1)
        .map(|line| {
            let mut cells = line.split(',');
            (cells.next().unwrap().to_owned(), cells.map(|c| c.trim().parse().unwrap()).collect())
        })
        .collect()
}

fn flange_at(numbers: &[f64]) -> Isometry3<f64> {
    let [x, y, z] = [0, 1, 2].map(|k| robot_model::units::m_from_mm(numbers[k]));
    Isometry3::from_parts(Translation3::new(x, y, z), UnitQuaternion::from_euler_angles(0.0, FRAC_PI_2, 0.0))
}

#[test]
fn static_case() {
    let message =
        driftpost(&["tabulate", "fixtures/paper/targets45.csv", "--growth", "none", "--minutes", "0"]);
    message.lines().filter(|l| !l.starts_with("after")).for_each(stands);
    let after = message.lines().find(|l| l.starts_with("after")).unwrap();
    let numbers: Vec<f64> = after.split_whitespace().filter_map(|w| w.parse().ok()).collect();
    assert!(numbers[0] < 1e-6 && numbers[1] < 1e-6, "{after}");
}

#[test]
fn variable_case() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("joints.csv");
    let json = dir.path().join("summary.json");
    let message = driftpost(&[
        "tabulate",
        "fixtures/paper/targets45.csv",
        "--minutes",
        "0:180:1",
        "--joints-csv",
        out.to_str().unwrap(),
        "--json",
        json.to_str().unwrap(),
    ]);
    message.lines().filter(|l| !l.starts_with("after")).for_each(stands);
    assert_eq!(std::fs::read_to_string(out).unwrap().lines().count(), 1 + 8145);
    let report: serde_json::Value = serde_json::from_slice(&std::fs::read(json).unwrap()).unwrap();
    for (hour, claimed) in [(1, 0.03), (2, 0.06), (3, 0.073)] {
        let of_hour: Vec<&serde_json::Value> = report["minutes"]
            .as_array()
            .unwrap()
            .iter()
            .filter(|m| {
                (f64::from(hour - 1) * 60.0..=f64::from(hour) * 60.0).contains(&m["t_min"].as_f64().unwrap())
            })
            .collect();
        let worst = |when: &str, what: &str| {
            of_hour.iter().map(|m| m[when][what].as_f64().unwrap()).fold(0.0, f64::max)
        };
        assert!(worst("after", "max_mm") < 1e-6 && worst("after", "max_deg") < 1e-6);
        stands(&format!(
            "| {hour} | {claimed} mm | {:.3} mm | under 0.000001 mm |",
            worst("before", "max_mm")
        ));
    }
}

#[test]
fn as_a_program() {
    let dir = tempfile::tempdir().unwrap();
    let at = |name: &str| dir.path().join(name).to_string_lossy().into_owned();
    driftpost(&[
        "compensate",
        "fixtures/robodk/irc5/Cube45.mod",
        "-o",
        &at("cube.mod"),
        "--diff",
        "none",
        "--json",
        &at("c.json"),
    ]);
    let c: serde_json::Value = serde_json::from_slice(&std::fs::read(at("c.json")).unwrap()).unwrap();
    stands(&format!(
        "{} buckets; {:.3} mm at worst before, {:.3} mm after, over all minutes; one work-object shift per bucket would leave {:.3} mm",
        c["buckets"].as_array().unwrap().len(),
        c["worst_before_mm"].as_f64().unwrap(),
        c["worst_after_mm"].as_f64().unwrap(),
        c["rigid_shift_worst_mm"].as_f64().unwrap()
    ));
}

#[test]
fn table_4_on_the_deformed_robot() {
    let robot = Robot::built_in("irb140").unwrap();
    let (nominal, deformed) =
        (Chain::nominal(&robot), Chain::with_offsets(&robot, &Deformation::paper().settled()));
    let off = |chain: &Chain, q_rad: &[f64; 6], goal: &Isometry3<f64>| mm(chain.distance(q_rad, goal).0);
    let (mut seen, mut asked) = (Vec::new(), Vec::new());
    let mut frames: [Vec<f64>; 2] = [Vec::new(), Vec::new()];
    for ((name, published), (_, target)) in
        rows("table4_published_joints.csv").iter().zip(rows("table3_nominal_joints.csv"))
    {
        let q_rad: [f64; 6] = std::array::from_fn(|j| published[6 + j].to_radians());
        let goal = flange_at(&target);
        let own = solve(&nominal, &goal, &q_rad).unwrap().q_rad;
        let right = solve(&deformed, &goal, &own).unwrap().q_rad;
        stands(&format!(
            "| {name} | {:.3} mm | {:.3} mm | {:.3} mm | {:.3} mm |",
            off(&deformed, &own, &goal),
            off(&deformed, &q_rad, &goal),
            off(&nominal, &q_rad, &goal),
            off(&nominal, &right, &goal)
        ));
        let moved = |frame: usize| {
            let mut offsets = FrameOffsets::default();
            offsets.0[frame][0] = 1e-5;
            solve(&Chain::with_offsets(&robot, &offsets), &goal, &own).unwrap().q_rad
        };
        for j in 0..6 {
            seen.push(q_rad[j] - own[j]);
            asked.push(right[j] - own[j]);
        }
        for (to, frame) in frames.iter_mut().zip([4, 6]) {
            to.extend(moved(frame).iter().zip(own).map(|(a, b)| a - b));
        }
    }
    let share = |columns: &[&[f64]]| {
        let x = DMatrix::from_fn(seen.len(), columns.len(), |r, c| columns[c][r]);
        let y = DVector::from_column_slice(&seen);
        let covariance = (x.transpose() * &x).try_inverse().unwrap();
        let fitted = &covariance * x.transpose() * &y;
        let left = &y - &x * &fitted;
        let variance = left.norm_squared() / (seen.len() - columns.len()) as f64;
        (
            fitted[0],
            (variance * covariance[(0, 0)]).sqrt(),
            (left.norm_squared() / seen.len() as f64).sqrt().to_degrees(),
        )
    };
    let (alone, sigma, left) = share(&[&asked]);
    stands(&format!("share of Table 2 in the 18 angles: {alone:.2} +- {sigma:.2}, {left:.4} deg rms left"));
    let (with, sigma, left) = share(&[&asked, &frames[0], &frames[1]]);
    stands(&format!(
        "with the x of joint 5 and of the flange free as well: {:.2} +- {sigma:.2}, {left:.4} deg rms left",
        with + 0.0
    ));
    assert!(alone < 0.2 && (with / sigma).abs() < 2.0);
}

#[test]
fn the_residual_that_rises_in_steps() {
    let law = GrowthLaw::TwoStage { tau_min: 46.0 };
    let mut amplitudes = Vec::new();
    for (hour, claimed) in [(1.0, 0.03), (2.0, 0.06), (3.0, 0.073)] {
        let grown = law.at(60.0 * hour);
        amplitudes.push(claimed / grown);
        stands(&format!("| {hour} | {claimed} mm | {grown:.3} | {:.4} mm |", claimed / grown));
    }
    let spread =
        amplitudes.iter().fold(0.0_f64, |a, b| a.max(*b)) / amplitudes.iter().fold(1.0_f64, |a, b| a.min(*b));
    assert!(spread < 1.03, "{spread}");
    // What each part of Table 2 alone does at worst over the 45 targets, when the solver does not see it.
    let robot = Robot::built_in("irb140").unwrap();
    let nominal = Chain::nominal(&robot);
    let poses: Vec<[f64; 6]> = {
        let mut last = [0.0, 0.3, 0.0, 0.0, -0.6, 0.0];
        let closed = robot_model::kinematics::ClosedForm::new(&robot).unwrap();
        rows("targets45.csv")
            .iter()
            .map(|(_, numbers)| {
                last = closed.nearest(&flange_at(numbers), &last).unwrap().q_rad;
                last
            })
            .collect()
    };
    let worst = |keep: &dyn Fn(usize, usize) -> bool| {
        let mut offsets = Deformation::paper().settled();
        for (i, row) in offsets.0.iter_mut().enumerate() {
            for (k, value) in row.iter_mut().enumerate() {
                *value *= f64::from(u8::from(keep(i, k)));
            }
        }
        let chain = Chain::with_offsets(&robot, &offsets);
        let far = |q: &[f64; 6]| {
            (chain.forward(q).translation.vector - nominal.forward(q).translation.vector).norm()
        };
        mm(poses.iter().map(far).fold(0.0, f64::max))
    };
    stands(&format!("| all of it | {:.3} mm |", worst(&|_, _| true)));
    stands(&format!("| shifts alone | {:.3} mm |", worst(&|_, k| k < 3)));
    stands(&format!("| turns alone | {:.3} mm |", worst(&|_, k| k >= 3)));
    for row in [0, 1, 2, 3, 5] {
        stands(&format!("| row {} alone | {:.3} mm |", row + 1, worst(&|i, _| i == row)));
    }
    stands(&format!("| turns of row 3 alone | {:.3} mm |", worst(&|i, k| i == 2 && k >= 3)));
    stands(&format!("| Dx of all rows alone | {:.3} mm |", worst(&|_, k| k == 0)));
    stands(&format!("| Dz of all rows alone | {:.3} mm |", worst(&|_, k| k == 2)));
}

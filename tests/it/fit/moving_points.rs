//! Touched points that move themselves, and tips that are elsewhere than `--tool` says.

use super::recipe;
use driftpost::application::{Fit, Fitted};
use exam::rng::Rng;
use exam::touch::touches;
use measurements::{Touch, Touches};
use nalgebra::{Matrix3, Vector3};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::Deformation;
use robot_model::kinematics::{Chain, FrameOffsets};
use robot_model::robot::Robot;
use warm_up::FitOptions;

pub(super) fn robot() -> Robot {
    Robot::built_in("irb140").unwrap()
}

/// Five points touched on the virtual arm: two lags of 46 minutes, noise of 0.02 mm.
pub(super) fn sound(seed: u64) -> Touches {
    let csv =
        touches(&robot(), &recipe(0.02, Deformation::paper().settled().0), &mut Rng::new(seed, 0)).unwrap();
    Touches::from_csv(csv.as_bytes()).unwrap()
}

pub(super) fn fitted(touches: &Touches, tool_mm: f64) -> Fitted {
    job(tool_mm).run(touches).unwrap()
}

fn job(tool_mm: f64) -> Fit {
    let options = FitOptions { tool_m: Vector3::new(0.0, 0.0, tool_mm * 1e-3), stops: None };
    Fit { options, ..Fit::new(robot()) }
}

pub(super) fn of_code<'w>(found: &'w Fitted, code: &str) -> Vec<&'w Diagnostic> {
    found.warnings().iter().filter(|warning| warning.code == code).collect()
}

/// Joint 1 turns to pins that move round the base, so many degrees a minute: 0.0001 are 0.2 mm over the file at half a metre.
fn creeping(touches: &Touches, creeps: impl Fn(&str) -> bool, deg_per_min: f64) -> Touches {
    let mut moved = touches.clone();
    let of_creeping = |touch: &&mut Touch| creeps(&touches.points[touch.point]);
    moved.touches.iter_mut().filter(of_creeping).for_each(|touch| {
        touch.q_rad[0] += (deg_per_min * touch.t_min).to_radians();
    });
    moved
}

/// Joints at which the tip of the arm `chain` is at `goal_m`, joints 4 to 6 where they are: Newton's method on the other three.
pub(super) fn led_to(
    chain: &Chain,
    q_rad: [f64; 6],
    tool_m: &Vector3<f64>,
    goal_m: &Vector3<f64>,
) -> [f64; 6] {
    let tip_m = |q: &[f64; 6]| (chain.forward(q) * nalgebra::Point3::from(*tool_m)).coords;
    let mut q = q_rad;
    for _ in 0..8 {
        let here_m = tip_m(&q);
        let slope = Matrix3::from_columns(&[0, 1, 2].map(|j: usize| {
            let mut turned = q;
            turned[j] += 1e-7;
            (tip_m(&turned) - here_m) / 1e-7
        }));
        let step = slope.try_inverse().unwrap() * (goal_m - here_m);
        (0..3).for_each(|j| q[j] += step[j]);
    }
    q
}

/// Joints at which five pins are touched first, radians.
pub(super) fn starts_rad() -> [[f64; 6]; 5] {
    [
        [-30.0, 20.0, -10.0, 20.0, 50.0, 10.0],
        [10.0, 40.0, -30.0, -40.0, 60.0, 50.0],
        [35.0, 10.0, 5.0, 30.0, 40.0, -60.0],
        [0.0, 30.0, -20.0, -10.0, 70.0, 90.0],
        [20.0, -5.0, 15.0, 60.0, 45.0, 0.0],
    ]
    .map(|q_deg: [f64; 6]| q_deg.map(f64::to_radians))
}

/// Four points touched every six minutes over two hours with a tip 100 mm out, the wrist turned by up to 0.55 degrees either way each
/// time; one lag of 40 minutes takes up the paper's table.
fn turned_about(turn_rad: f64) -> Touches {
    let (robot, tool_m) = (robot(), Vector3::new(0.0, 0.0, 0.1));
    let [starts @ .., _] = starts_rad();
    let pins_m = starts.map(|q| (Chain::nominal(&robot).forward(&q) * nalgebra::Point3::from(tool_m)).coords);
    let settled = Deformation::paper().settled();
    let mut rng = Rng::new(8, 0);
    let mut all =
        Touches { points: ["P1", "P2", "P3", "P4"].map(str::to_owned).to_vec(), ..Touches::default() };
    for k in 0..21 {
        let t_min = 6.0 * f64::from(k);
        let share = 1.0 - (-t_min / 40.0).exp();
        let mut offsets = FrameOffsets::default();
        for (now, row) in offsets.0.iter_mut().zip(settled.0) {
            *now = row.map(|value| value * share);
        }
        let warm = Chain::with_offsets(&robot, &offsets);
        for (point, (start, pin_m)) in starts.iter().zip(&pins_m).enumerate() {
            let mut q_rad = *start;
            (3..6).for_each(|j| q_rad[j] += rng.uniform(-turn_rad, turn_rad));
            let goal_m = pin_m + Vector3::from(rng.normal3()) * 1e-5;
            let q_rad = led_to(&warm, q_rad, &tool_m, &goal_m);
            all.touches.push(Touch {
                line: all.touches.len() as u64 + 2,
                point,
                t_min,
                q_rad,
                measured_m: None,
            });
        }
    }
    all
}

#[test]
fn touches_in_other_orientations_tell_the_tip_and_others_do_not() {
    let touches = turned_about(0.55_f64.to_radians());
    let found = fitted(&touches, 100.0);
    assert_eq!(found.tip.unwrap().directions, 3);
    assert!(of_code(&found, "fit::tool").is_empty(), "{:?}", found.warnings());
    assert!(found.text().contains("(--tool) is checked:"), "{}", found.text());
    for wrong_mm in [50.0, 150.0, 400.0] {
        let message = match job(wrong_mm).run(&touches) {
            Ok(found) => of_code(&found, "fit::tool")[0].message.clone(),
            Err(error) => error.to_string(),
        };
        let z_mm: f64 = message.split(')').next().unwrap().split(", ").last().unwrap().parse().unwrap();
        assert!(message.contains("say that the tip is at (") && (z_mm - 100.0).abs() < 2.0, "{message}");
    }
    // In one orientation any tip goes with the touches.
    let found = fitted(&turned_about(1e-5), 150.0);
    assert_eq!(found.tip.unwrap().directions, 0);
    assert!(found.text().contains("(--tool) is not checked"), "{}", found.text());
    assert_eq!(found.json()["tip"]["directions"], 0);
}

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
mod long {
    use super::*;

    #[test]
    #[ignore = "long"]
    fn one_point_that_creeps_is_named_with_the_time_constant_of_the_others() {
        for seed in [3, 12, 20] {
            let touches = sound(seed);
            let found = fitted(&touches, 100.0);
            assert_eq!(of_code(&found, "fit::moving-point"), Vec::<&Diagnostic>::new(), "seed {seed}");
            let creeps = fitted(&creeping(&touches, |point| point == "P2", 1e-4), 100.0);
            let named = of_code(&creeps, "fit::moving-point");
            let [one] = named[..] else { panic!("seed {seed}: {:?}", creeps.warnings()) };
            assert!(one.message.starts_with("point P2 moves otherwise than the other 4 points"), "{one:?}");
            let minutes: Vec<f64> = one
                .message
                .split(" is ")
                .skip(1)
                .flat_map(|part| part.split(' '))
                .filter_map(|word| word.parse().ok())
                .collect();
            // How far off, the time constant without it and with it: 46 minutes were drawn.
            let [_, rest_min] = minutes[..2] else { panic!("{one:?}") };
            let with_min = creeps.warm_up.growth.tau_min().unwrap();
            assert!((rest_min - 46.0).abs() < 0.5 * (with_min - 46.0).abs(), "{one:?}");
        }
    }

    #[test]
    #[ignore = "long"]
    fn what_one_or_two_points_cannot_tell_is_named() {
        let touches = sound(3);
        let only = |points: &[&str]| {
            let mut few = creeping(&touches, |point| point == "P2", 2.5e-4);
            few.touches.retain(|touch| points.contains(&touches.points[touch.point].as_str()));
            few
        };
        let alone = fitted(&only(&["P2"]), 100.0);
        let named = of_code(&alone, "fit::few-points");
        assert!(
            named[0].message.contains("(P2)") && named[0].message.contains("creeps cannot be told"),
            "{named:?}"
        );
        let two = fitted(&only(&["P2", "P3"]), 100.0);
        let named = of_code(&two, "fit::moving-point");
        assert!(named[0].message.contains("P2 and P3 do not move together"), "{named:?}");
        assert!(of_code(&two, "fit::few-points").is_empty());
        let still = sound(3).touches.into_iter().filter(|touch| touch.point < 2).collect();
        let still = fitted(&Touches { touches: still, ..touches }, 100.0);
        assert!(of_code(&still, "fit::few-points")[0].message.starts_with("two of the points alone"));
    }
}

//! Fixed points touched over a warm-up and one stop, on the virtual arm: its seats move as a table says, in proportion to
//! two lags (or one) that are followed step by step.

use super::arm::{Disturbance, ScrewArm};
use super::rng::Rng;
use nalgebra::{Matrix3, Matrix3xX, Point3, UnitQuaternion, Vector3};
use robot_model::robot::Robot;
use robot_model::units::{deg_from_rad, m_from_mm, rad_from_deg};
use serde::Serialize;
use std::f64::consts::FRAC_PI_2;
use std::fmt::Write as _;

/// What is touched, and on what robot.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct TouchRecipe {
    /// Number of fixed points to touch.
    pub points: usize,
    /// Number of touches of each point.
    pub times: usize,
    /// Between two touches, minutes.
    pub every_min: f64,
    /// The robot stands from one minute to another; no touches then.
    pub stop_min: [f64; 2],
    /// Noise of each coordinate of a touch, mm.
    pub sigma_mm: f64,
    /// Time constants of warming and cooling, minutes.
    pub tau_min: [f64; 2],
    /// Two lags in a row, else one.
    pub two_stage: bool,
    /// Settled shift and turn of each joint's seat, metres and radians.
    pub table: [[f64; 6]; 7],
    /// The points lie in this box: lowest and highest corner in the base, metres.
    pub within_m: [[f64; 3]; 2],
    /// The tip in the flange's frame, metres.
    pub tool_m: [f64; 3],
}

/// Step of the lags, minutes.
const STEP_MIN: f64 = 0.02;
/// A point is touched this nearly as the arm works.
const AS_WORKING_RAD: f64 = 0.5;
/// Tries for a pose in its place.
const TRIES: usize = 2_000_000;

/// The file of touches; `None` where the arm does not reach into the box.
#[must_use]
pub fn touches(robot: &Robot, recipe: &TouchRecipe, rng: &mut Rng) -> Option<String> {
    let arm = ScrewArm::new(&robot.into());
    let tool = Point3::from(Vector3::from(recipe.tool_m));
    let still = Disturbance::default();
    let mut points = Vec::new();
    for k in 0..recipe.points {
        let q_rad = pose(robot, &arm, recipe, k, rng)?;
        points.push((q_rad, (arm.flange(&q_rad, &still) * tool).coords));
    }
    let mut out = String::from("fixed_id,t_min,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\n");
    let mut lags = [0.0; 2];
    let mut now_min = 0.0;
    for i in 0..recipe.times {
        let running_min = i as f64 * recipe.every_min;
        let [stop, go] = recipe.stop_min;
        let t_min = if running_min > stop { running_min + go - stop } else { running_min };
        while now_min < t_min - 1e-9 {
            let step_min = STEP_MIN.min(t_min - now_min);
            let stands = now_min >= stop && now_min < go;
            let (u, tau_min) = if stands { (0.0, recipe.tau_min[1]) } else { (1.0, recipe.tau_min[0]) };
            // Heun's step of x1' = (u - x1)/tau, x2' = (x1 - x2)/tau.
            let slope = |x: [f64; 2]| [(u - x[0]) / tau_min, (x[0] - x[1]) / tau_min];
            let a = slope(lags);
            let b = slope([lags[0] + step_min * a[0], lags[1] + step_min * a[1]]);
            for k in 0..2 {
                lags[k] += 0.5 * step_min * (a[k] + b[k]);
            }
            now_min += step_min;
        }
        let grown = lags[usize::from(recipe.two_stage)];
        let mut warm = Disturbance::default();
        for (k, row) in recipe.table.iter().enumerate() {
            warm.seat_m[k] = Vector3::new(row[0], row[1], row[2]) * grown;
            warm.seat_rad[k] = Vector3::new(row[3], row[4], row[5]) * grown;
        }
        for (k, (q_rad, at_m)) in points.iter().enumerate() {
            let goal = at_m + Vector3::from(rng.normal3()) * m_from_mm(recipe.sigma_mm);
            let touched = jogged(&arm, &warm, q_rad, &tool, &goal)?;
            // writing to a String cannot fail
            let _ = write!(out, "P{},{t_min}", k + 1);
            for q in touched {
                let _ = write!(out, ",{:.6}", deg_from_rad(q));
            }
            out.push('\n');
        }
    }
    Some(out)
}

/// Joints at which the disturbed arm's tip is at `goal`, with the least turn from `q_rad`.
fn jogged(
    arm: &ScrewArm,
    warm: &Disturbance,
    q_rad: &[f64; 6],
    tool: &Point3<f64>,
    goal: &Vector3<f64>,
) -> Option<[f64; 6]> {
    const TURN_RAD: f64 = 1e-6;
    let mut q = *q_rad;
    for _ in 0..4 {
        let here = (arm.flange(&q, warm) * tool).coords;
        let mut slope = Matrix3xX::zeros(6);
        for j in 0..6 {
            let mut turned = q;
            turned[j] += TURN_RAD;
            slope.set_column(j, &(((arm.flange(&turned, warm) * tool).coords - here) / TURN_RAD));
        }
        let normal: Matrix3<f64> = (&slope * slope.transpose()).fixed_view::<3, 3>(0, 0).into();
        let step = slope.transpose() * (normal.try_inverse()? * (goal - here));
        for (q, by) in q.iter_mut().zip(step.iter()) {
            *q += by;
        }
    }
    Some(q)
}

/// A pose whose tip is in the box: the first four near its alternate corners, the fifth in the middle, more anywhere.
fn pose(robot: &Robot, arm: &ScrewArm, recipe: &TouchRecipe, k: usize, rng: &mut Rng) -> Option<[f64; 6]> {
    const CORNERS: [[f64; 3]; 5] =
        [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 1.0], [1.0, 0.0, 1.0], [0.5, 0.5, 0.5]];
    const NEAR: f64 = 0.12;
    let [low, high] = recipe.within_m;
    let tool = Point3::from(Vector3::from(recipe.tool_m));
    let still = Disturbance::default();
    for _ in 0..TRIES {
        let degrees = [
            rng.uniform(-50.0, 50.0),
            rng.uniform(-20.0, 80.0),
            rng.uniform(-70.0, 40.0),
            rng.uniform(-60.0, 60.0),
            rng.uniform(-110.0, -20.0),
            rng.uniform(-90.0, 90.0),
        ];
        let q_rad = degrees.map(rad_from_deg);
        let tip = arm.flange(&q_rad, &still) * tool;
        let share: [f64; 3] = std::array::from_fn(|i| (tip[i] - low[i]) / (high[i] - low[i]));
        let near = CORNERS.get(k).is_none_or(|c| share.iter().zip(c).all(|(s, c)| (s - c).abs() < NEAR));
        let inside = share.iter().all(|s| (-NEAR..=1.0 + NEAR).contains(s));
        // Touched about as the arm works there: the flange looks forward, within half a radian.
        let turn = arm.flange(&q_rad, &still).rotation;
        let square = turn.angle_to(&UnitQuaternion::from_euler_angles(0.0, FRAC_PI_2, 0.0)) < AS_WORKING_RAD;
        if near && inside && square && robot.within_range(&q_rad).is_ok() {
            return Some(q_rad);
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cold_touch_is_where_it_was_and_a_warm_one_elsewhere_by_the_table() {
        let robot = Robot::built_in("irb140").unwrap();
        let mut table = [[0.0; 6]; 7];
        table[0][2] = 1e-4;
        let recipe = TouchRecipe {
            points: 2,
            times: 3,
            every_min: 200.0,
            stop_min: [1e9, 1e9],
            sigma_mm: 1e-9,
            tau_min: [20.0, 20.0],
            two_stage: true,
            table,
            within_m: [[0.4, -0.3, 0.25], [0.7, 0.3, 0.55]],
            tool_m: [0.0, 0.0, 0.1],
        };
        let csv = touches(&robot, &recipe, &mut Rng::new(1, 0)).unwrap();
        let rows: Vec<Vec<f64>> =
            csv.lines().skip(1).map(|l| l.split(',').skip(1).map(|v| v.parse().unwrap()).collect()).collect();
        let arm = ScrewArm::new(&(&robot).into());
        let tip = |row: &[f64]| {
            let q_rad: [f64; 6] = std::array::from_fn(|j| rad_from_deg(row[j + 1]));
            (arm.flange(&q_rad, &Disturbance::default()) * Point3::new(0.0, 0.0, 0.1)).coords
        };
        // A base lifted by 0.1 mm, settled after ten time constants: the nominal arm believes the point 0.1 mm lower.
        let sunk = tip(&rows[4]) - tip(&rows[0]);
        assert!((sunk - Vector3::new(0.0, 0.0, -1e-4)).norm() < 1e-7, "{sunk}");
    }
}

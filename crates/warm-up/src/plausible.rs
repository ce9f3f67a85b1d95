//! Touches that contradict themselves, the robot or their units: a fit of them would be a table for another arm.

use super::doubtful::SLOWEST_TAU_MIN;
use super::fitted::WarmUp;
use super::parameters::tip_m;
use measurements::{
    Fault, FaultKind, OUT_OF_RANGE_SHARE, Station, Touch, Touches, find_fault, find_in_stamps, out_of_range,
    register, tool_apart,
};
use nalgebra::{Isometry3, Vector3};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::kinematics::{Chain, SerialChain};
use robot_model::robot::{Robot, SerialArm};
use robot_model::units::{deg_from_rad, mm_from_m, rad_from_deg};
use statistics::median;
use std::collections::BTreeSet;
use std::f64::consts::TAU as TURN;

/// Poses of two points are apart where a joint is by more than this, degrees: poses in radians are, and no two points are touched in the
/// zero pose.
const APART_DEG: f64 = 0.5;
/// Angles are written to one of these, degrees; finer ones move no tip that could be seen.
const DECIMALS_DEG: [f64; 6] = [1.0, 0.5, 0.1, 0.05, 0.02, 0.01];
/// The same with those that move it by a few micrometres.
const FINE_DECIMALS_DEG: [f64; 9] = [1.0, 0.5, 0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001];
/// Rounding that makes so large a part of the noise is what the fit sees.
const MOST_ROUNDING: f64 = 0.5;
/// Joints that change between the touches of a point, beside one that does not.
const FEWEST_MOVING: usize = 3;

/// Whether a first reading lies so far behind the cold start, against the time constant, that how the arm warmed before is extrapolated.
#[must_use]
pub fn is_late_start(first_min: f64, tau_min: f64) -> bool {
    first_min > 0.5 * tau_min
}

/// What no arm could have done, by joints and minutes alone.
pub(super) fn find_in_joints(touches: &Touches, robot: &Robot) -> Option<Fault> {
    let all = &touches.touches;
    let largest = all.iter().flat_map(|touch| touch.q_rad).map(|q| deg_from_rad(q).abs()).fold(0.0, f64::max);
    let are_apart = all.iter().any(|touch| {
        let first = &all[0];
        let apart = |(a, b): (&f64, f64)| deg_from_rad(a - b).abs() > APART_DEG;
        touch.point != first.point && touch.q_rad.iter().zip(first.q_rad).any(apart)
    });
    if largest > APART_DEG && largest < 1.001 * TURN && are_apart {
        let reason = format!(
            "columns q1_deg to q6_deg are in radians: no joint is beyond {largest:.2} in any touch of any point"
        );
        return Some(Fault::of_all(FaultKind::JointUnits, Some("q1_deg to q6_deg"), reason));
    }
    let arm = SerialArm::from(robot);
    let is_beyond = |touch: &&Touch| out_of_range(&touch.q_rad.into(), &arm).is_some();
    let beyond: Vec<u64> = all.iter().filter(is_beyond).map(|touch| touch.line).collect();
    if beyond.len() as f64 > OUT_OF_RANGE_SHARE * all.len() as f64 {
        return Some(Fault::in_rows(
            FaultKind::JointsOutOfRange,
            "q1_deg to q6_deg",
            beyond,
            |count, which| {
                format!("in {count} touches ({which}) joints are outside the range of {}", robot.name)
            },
        ));
    }
    find_in_stamps(&all.iter().map(|touch| (touch.t_min, touch.line)).collect::<Vec<_>>())
}

/// What the points of a tracker contradict, and where the tip is by them if that is elsewhere than named.
pub(super) fn check_points(
    stations: &[Station],
    robot: &SerialArm,
    tool_m: Vector3<f64>,
) -> Result<Option<Diagnostic>, Fault> {
    let chain = SerialChain::nominal(robot);
    let flange: Vec<Isometry3<f64>> = stations.iter().map(|s| s.pose(&chain)).collect();
    let Ok(registration) = register(stations, &flange, 1, None) else { return Ok(None) };
    if let Some(fault) = find_fault(robot, stations, 1, &registration, None) {
        return Err(fault);
    }
    let apart = tool_apart(&registration, 1, Some(tool_m), stations.len());
    Ok(apart.map(|apart| {
        let [x, y, z] = [apart.fitted_m.x, apart.fitted_m.y, apart.fitted_m.z].map(mm_from_m);
        Diagnostic::warning(
            "fit::tool",
            format!(
                "the points say that the tip is at ({x:.1}, {y:.1}, {z:.1}) mm from the flange, {:.1} mm from where it is taken to be",
                mm_from_m(apart.apart_m)
            ),
        )
        .help("--tool X,Y,Z names it; turns of the wrist move it by as much more")
    }))
}

/// What a person should look at in touches that have been fitted.
pub(super) fn warnings(
    touches: &Touches,
    robot: &Robot,
    warm_up: &WarmUp,
    tool_m: Vector3<f64>,
) -> Vec<Diagnostic> {
    let tau_min = warm_up.growth.tau_min().unwrap_or_default();
    let first_min = warm_up.span_min[0];
    let mut all = Vec::new();
    let is_late = is_late_start(first_min, tau_min.min(SLOWEST_TAU_MIN));
    if tau_min > SLOWEST_TAU_MIN && !is_late {
        all.push(
            Diagnostic::warning(
                "fit::minutes",
                format!(
                    "the drift settles with a time constant of {tau_min:.0} min, of an arm it is 30 to 120"
                ),
            )
            .help("t_min counts minutes, not seconds, from the cold start"),
        );
    } else if is_late {
        all.push(
            Diagnostic::warning(
                "fit::minutes",
                format!(
                    "the first touch is at minute {first_min:.0}: what the arm did before is taken from the growth law alone, and the settled \
                     drift with it"
                ),
            )
            .help("t_min counts from the cold start; take the first touch then"),
        );
    }
    all.extend(rounded(touches, robot, warm_up, tool_m));
    all.extend((0..3).filter_map(|j| frozen(touches, j)));
    all
}

/// What a person should look at in touches that a robot's state is followed by, of an arm that settles with `tau_min`.
pub(super) fn state_warnings(touches: &Touches, tau_min: f64) -> Vec<Diagnostic> {
    let mut minutes: Vec<f64> = touches.touches.iter().map(|touch| touch.t_min).collect();
    sorting::numbers(&mut minutes);
    minutes.dedup();
    let Some(&first_min) = minutes.first() else { return Vec::new() };
    let mut gaps_min: Vec<f64> = minutes.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let mut all = Vec::new();
    if is_late_start(first_min, tau_min) {
        let message = format!(
            "the first touch is at minute {first_min:.0}, and is taken for the cold arm's; this arm settles with a time constant of \
             {tau_min:.0} min"
        );
        all.push(
            Diagnostic::warning("state::minutes", message)
                .help("t_min counts from the cold start; take the first touch then"),
        );
    }
    if gaps_min.len() > 1 && median(&mut gaps_min) > tau_min {
        let message = format!(
            "touches are {:.0} min apart in the middle, longer than the arm takes to settle ({tau_min:.0} min): they hardly tell how it warms",
            median(&mut gaps_min)
        );
        all.push(Diagnostic::warning("state::minutes", message).help("t_min counts minutes, not seconds"));
    }
    all
}

/// Joints that are written so coarsely that their rounding is much of the noise.
fn rounded(touches: &Touches, robot: &Robot, warm_up: &WarmUp, tool_m: Vector3<f64>) -> Option<Diagnostic> {
    let steps = written_steps_deg(touches, &DECIMALS_DEG);
    let coarsest_deg = steps.iter().map(|(_, step_deg)| *step_deg).reduce(f64::max)?;
    let rounding_m = rounding_m(touches, robot, tool_m, &steps);
    let noise_m = 3.0_f64.sqrt() * warm_up.sigma_m;
    (rounding_m > MOST_ROUNDING * noise_m).then(|| {
        let columns: Vec<String> = steps.iter().map(|(j, _)| format!("q{}_deg", j + 1)).collect();
        Diagnostic::warning(
            "fit::rounded",
            format!(
                "{} rounded to {coarsest_deg} deg, which moves the tip by {:.3} mm rms; the noise is {:.3} mm",
                are_columns(&columns),
                mm_from_m(rounding_m),
                mm_from_m(noise_m)
            ),
        )
        .help("take the joints from the controller with all their digits, 3 decimals at least")
    })
}

/// One standard deviation of a coordinate of the tip by how joints are written, metres; 0 where no step shows.
pub(super) fn rounding_sigma_m(touches: &Touches, robot: &Robot, tool_m: Vector3<f64>) -> f64 {
    let steps = written_steps_deg(touches, &FINE_DECIMALS_DEG);
    rounding_m(touches, robot, tool_m, &steps) / 3.0_f64.sqrt()
}

/// By how much steps of joints, degrees, move the tip: rms in space, metres.
fn rounding_m(touches: &Touches, robot: &Robot, tool_m: Vector3<f64>, steps: &[(usize, f64)]) -> f64 {
    let chain = Chain::nominal(robot);
    let square_m2 = |touch: &Touch| {
        let of_joint = |(j, step_deg): &(usize, f64)| {
            let mut moved = touch.q_rad;
            moved[*j] += rad_from_deg(*step_deg);
            // Even over a step: the variance is a twelfth of its square.
            (tip_m(&chain, &moved, &tool_m) - tip_m(&chain, &touch.q_rad, &tool_m)).norm_squared() / 12.0
        };
        steps.iter().map(of_joint).sum::<f64>()
    };
    (touches.touches.iter().map(square_m2).sum::<f64>() / touches.touches.len() as f64).sqrt()
}

/// Joints that are written on steps, and these.
fn written_steps_deg(touches: &Touches, decimals_deg: &[f64]) -> Vec<(usize, f64)> {
    (0..6).filter_map(|j| Some((j, written_step_deg(touches, j, decimals_deg)?))).collect()
}

fn are_columns(columns: &[String]) -> String {
    match columns {
        [one] => format!("column {one} is"),
        all => format!("columns {} are", all.join(", ")),
    }
}

/// The step that all angles of a joint are written on, degrees; `None` of a fine one, and of a joint that only stands at the angles of the
/// poses.
fn written_step_deg(touches: &Touches, joint: usize, decimals_deg: &[f64]) -> Option<f64> {
    let angles_deg = || touches.touches.iter().map(|touch| deg_from_rad(touch.q_rad[joint]));
    let is_on = |step_deg: &f64| {
        angles_deg().all(|angle_deg| (angle_deg / step_deg - (angle_deg / step_deg).round()).abs() < 1e-6)
    };
    let different: BTreeSet<u64> = angles_deg().map(f64::to_bits).collect();
    decimals_deg.iter().copied().find(is_on).filter(|_| different.len() > touches.points.len())
}

/// A joint of the first three, which no lead to a point leaves alone, that is the same to the last digit at all touches of each point where
/// others are not.
fn frozen(touches: &Touches, joint: usize) -> Option<Diagnostic> {
    let changes = |j: usize| {
        (0..touches.points.len()).any(|point| {
            let mut of_point =
                touches.touches.iter().filter(|touch| touch.point == point).map(|t| t.q_rad[j]);
            let first = of_point.next();
            of_point.any(|q_rad| Some(q_rad) != first)
        })
    };
    // A tracker sees commanded poses: there all joints are the same.
    (!changes(joint) && (0..6).filter(|&j| changes(j)).count() >= FEWEST_MOVING).then(|| {
        Diagnostic::warning(
            "fit::frozen",
            format!(
                "column q{}_deg is the same to the last digit at all touches of each point, though others change",
                joint + 1
            ),
        )
        .help("a tip that is led to a point moves all joints a little: is the column what the controller showed at each touch?")
    })
}

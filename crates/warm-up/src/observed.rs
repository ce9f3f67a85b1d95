//! What touches, or the points of a tracker, show of the arm: how far each is from where the nominal arm has it, point by point, as one stand
//! of the instrument and one place of the tip see it.

use super::common_motion::{CommonStep, MovedBody};
use super::common_step::{self, FoundStep, MOST_STEPS};
use super::course::FEWEST_TOUCHES;
use super::fit_error::FitError;
use super::history::Standstill;
use super::parameters::{signature, tip_m};
use super::plausible;
use super::point::Point;
use measurements::{
    PartFault, PosedRow, Reading, Registration, Station, Touch, Touches, describe_move, find_in_rows,
    register,
};
use nalgebra::{Isometry3, Point3, Vector3};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::kinematics::{Chain, SerialChain};
use robot_model::robot::{Robot, SerialArm};
use robot_model::units::{deg_from_rad, mm_from_m};

/// A pose that moved by more than this between two touches of one point is another pose, radians.
const SAME_POSE_RAD: f64 = 0.02;

/// What touches show of the arm's drift, and of what moved beside it.
pub(super) struct Observed {
    /// Each with its touches: how far the real tool is from where the nominal arm believes it, up to a constant of each place, metres.
    pub(super) points: Vec<Point>,
    /// When all points moved together; each has a place of its own from then on.
    pub(super) moved: Vec<CommonStep>,
    /// What a person should look at: instrument, tip, a step that may be one.
    pub(super) warnings: Vec<Diagnostic>,
}

/// What the touches of `robot` show, which stood in `stops`.
pub(super) fn observed(
    touches: &Touches,
    robot: &Robot,
    tool_m: Vector3<f64>,
    stops: &[Standstill],
) -> Result<Observed, FitError> {
    let chain = Chain::nominal(robot);
    let rounding_m = plausible::rounding_sigma_m(touches, robot, tool_m);
    if touches.touches.iter().all(|touch| touch.measured_m.is_none()) {
        // The point stands still: what the arm believes has moved is what it really moved by, the other way round.
        let moved_m: Vec<_> =
            touches.touches.iter().map(|touch| -tip_m(&chain, &touch.q_rad, &tool_m)).collect();
        let mut points = grouped(touches, &chain, &moved_m, &tool_m)?;
        let steps = common_step::find(&points, &chain, stops, rounding_m);
        level(&mut points, &steps);
        let warnings = steps.iter().map(|found| warning(found, false)).collect();
        return Ok(Observed { points, moved: sure(steps), warnings });
    }
    of_tracker(touches, robot, tool_m, stops)
}

/// The same of a tracker's points.
fn of_tracker(
    touches: &Touches,
    robot: &Robot,
    tool_m: Vector3<f64>,
    stops: &[Standstill],
) -> Result<Observed, FitError> {
    let (arm, chain) = (SerialArm::from(robot), Chain::nominal(robot));
    let mut seen = Seen::new(touches, &arm);
    seen.bring_into_one_frame(&arm, tool_m);
    let check = seen.check(&arm, tool_m);
    let registration = match (seen.register(tool_m), &check) {
        (Ok(registration), _) => registration,
        (Err(_), Err(fault)) => return Err(fault.clone()),
        (Err(error), Ok(_)) => return Err(error),
    };
    let mut points = grouped(touches, &chain, &seen.moved_m(&registration), &tool_m)?;
    let rounding_m = plausible::rounding_sigma_m(touches, robot, tool_m);
    let steps = common_step::find(&points, &chain, stops, rounding_m);
    let later_min: Vec<f64> =
        steps.iter().filter(|found| found.is_sure).map(|found| found.step.between_min[1]).collect();
    let of_tool = if later_min.is_empty() {
        check?
    } else {
        seen.level(&points, &steps, &registration);
        points = grouped(touches, &chain, &seen.moved_m(&seen.register(tool_m)?), &tool_m)?;
        seen.check(&arm, tool_m)?
    };
    // By how far an instrument was moved that shows by far is in its own message.
    let is_new = |found: &&FoundStep| !seen.moves_min.contains(&found.step.between_min[1]);
    let of_steps: Vec<Diagnostic> = steps.iter().filter(is_new).map(|found| warning(found, true)).collect();
    for minute in seen.moves_min.iter().chain(&later_min) {
        points.iter_mut().for_each(|point| point.moves_at(*minute));
    }
    let warnings = of_tool.into_iter().chain(seen.warnings).chain(of_steps).collect();
    Ok(Observed { points, moved: sure(steps), warnings })
}

fn sure(steps: Vec<FoundStep>) -> Vec<CommonStep> {
    steps.into_iter().filter(|found| found.is_sure).map(|found| found.step).collect()
}

/// Takes what each point moved by in steps that are sure off its later touches, which are of a place of their own.
fn level(points: &mut [Point], steps: &[FoundStep]) {
    for found in steps.iter().filter(|found| found.is_sure) {
        let from_min = found.step.between_min[1];
        for (point, by_m) in points.iter_mut().zip(&found.each_m) {
            let first = point.t_min.partition_point(|t_min| *t_min < from_min);
            point.observed_m.iter_mut().skip(first).for_each(|at_m| *at_m -= by_m);
            point.moves_at(from_min);
        }
    }
}

/// What a person should know of a step that all points made together.
fn warning(found: &FoundStep, by_tracker: bool) -> Diagnostic {
    let CommonStep { between_min: [from_min, to_min], body, shift_m, turn_rad } = found.step;
    let by = format!("{:.3} mm", mm_from_m(shift_m));
    if !found.is_sure {
        return Diagnostic::warning(
            "fit::moved-together",
            format!(
                "between minutes {from_min:.0} and {to_min:.0} all points may have moved together by {by}, as an instrument or a tip that was moved \
                 has them: the touches do not tell that from the arm's own warming, and table and time constants hold it"
            ),
        )
        .help("was something moved or hit then? Touch again without it, or take the rows behind it out");
    }
    let turned = format!("{:.3} deg", deg_from_rad(turn_rad));
    match (body, by_tracker) {
        (MovedBody::Points, true) => Diagnostic::warning(
            "measure::instrument-moved",
            format!(
                "between minutes {from_min:.0} and {to_min:.0} the instrument was moved: it sees all poses {by} elsewhere, turned by {turned}; the \
                 base is registered in each stand on its own"
            ),
        )
        .help("how far the arm drifted meanwhile is not told by these rows; a nest that stands still shows what moved"),
        (MovedBody::Points, false) => Diagnostic::warning(
            "fit::moved-together",
            format!(
                "between minutes {from_min:.0} and {to_min:.0} all points moved together by {by}, turned by {turned}: what they are fixed to was \
                 moved, or the robot's base; their touches from then on count from there"
            ),
        )
        .help("how far the arm drifted meanwhile is not told by these touches"),
        (MovedBody::Tip, _) => Diagnostic::warning(
            "fit::moved-together",
            format!(
                "between minutes {from_min:.0} and {to_min:.0} the {} moved on the flange by {by}: touches from then on count from there",
                if by_tracker { "reflector" } else { "tip" }
            ),
        )
        .help("was it bent, hit or mounted anew? --tool is its place to a millimetre; how far the arm drifted meanwhile is not told by these rows"),
    }
}

/// The points of a tracker, and the stands of the instrument that show by far.
struct Seen {
    stations: Vec<Station>,
    poses: Vec<Isometry3<f64>>,
    /// The first minutes of stands behind the first.
    moves_min: Vec<f64>,
    warnings: Vec<Diagnostic>,
}

impl Seen {
    fn new(touches: &Touches, arm: &SerialArm) -> Self {
        let station = |(row, touch): (usize, &Touch)| {
            let reading =
                touch.measured_m.map_or(Reading::Touch { fixed_point: touch.point }, |position_m| {
                    Reading::Point { position_m }
                });
            Station {
                t_min: Some(touch.t_min),
                rows: vec![row],
                line: touch.line,
                ..Station::bare(touch.point, touch.q_rad.into(), reading)
            }
        };
        let stations: Vec<Station> = touches.touches.iter().enumerate().map(station).collect();
        let chain = SerialChain::nominal(arm);
        let poses = stations.iter().map(|station| station.pose(&chain)).collect();
        Self { stations, poses, moves_min: Vec::new(), warnings: Vec::new() }
    }

    /// Readings of stands that are further apart than an arm errs, in the frame of the first.
    fn bring_into_one_frame(&mut self, arm: &SerialArm, tool_m: Vector3<f64>) {
        for _ in 0..MOST_STEPS {
            let row = |(station, pose): (&Station, &Isometry3<f64>)| PosedRow {
                station: station.clone(),
                pose: *pose,
            };
            let rows: Vec<PosedRow> = self.stations.iter().zip(&self.poses).map(row).collect();
            let Some(PartFault::Moved { rows, first_from_second }) =
                find_in_rows(arm, &rows, 1, Some(tool_m))
            else {
                break;
            };
            let line = |at: usize| self.stations.get(at).map_or(0, |station| station.line);
            let to = (rows.end < self.stations.len()).then(|| line(rows.end - 1));
            let text = describe_move(&first_from_second, line(rows.start), to);
            self.warnings.push(Diagnostic::warning("measure::instrument-moved", text));
            let moves = [rows.start, rows.end];
            self.moves_min.extend(moves.iter().filter_map(|&at| self.stations.get(at)?.t_min));
            for station in self.stations.iter_mut().take(rows.end).skip(rows.start) {
                let Some(position_m) = station.reading.position_m() else { continue };
                let there_m = (first_from_second * Point3::from(position_m)).coords;
                station.reading = station.reading.with_coordinates_m(there_m);
            }
        }
    }

    fn check(&self, arm: &SerialArm, tool_m: Vector3<f64>) -> Result<Option<Diagnostic>, FitError> {
        plausible::check_points(&self.stations, arm, tool_m).map_err(|fault| FitError::Fault(Box::new(fault)))
    }

    fn register(&self, tool_m: Vector3<f64>) -> Result<Registration, FitError> {
        Ok(register(&self.stations, &self.poses, 1, Some(tool_m))?)
    }

    /// How far each reading is from where the nominal arm has it, base axes, metres.
    fn moved_m(&self, registration: &Registration) -> Vec<Vector3<f64>> {
        let pairs = self.stations.iter().zip(&self.poses);
        pairs.map(|(station, pose)| registration.residual_m(station, pose)).collect()
    }

    /// Readings behind steps that are sure where they would be without these.
    fn level(&mut self, points: &[Point], steps: &[FoundStep], registration: &Registration) {
        for found in steps.iter().filter(|found| found.is_sure) {
            let later = |station: &&mut Station| station.t_min >= Some(found.step.between_min[1]);
            for station in self.stations.iter_mut().filter(later) {
                let point = points.iter().position(|point| point.index == station.pose);
                let (Some(at), Some(position_m)) = (point, station.reading.position_m()) else { continue };
                let by_m = registration.instrument_from_base.rotation * found.each_m[at];
                station.reading = station.reading.with_coordinates_m(position_m - by_m);
            }
        }
    }
}

/// The touches by point, those that are touched often enough.
fn grouped(
    touches: &Touches,
    chain: &Chain,
    observed: &[Vector3<f64>],
    tool_m: &Vector3<f64>,
) -> Result<Vec<Point>, FitError> {
    let mut points: Vec<Point> = Vec::new();
    for (touch, observed) in touches.touches.iter().zip(observed) {
        match points.iter_mut().find(|p| p.index == touch.point) {
            Some(point) => {
                let moved = point.q_rad.iter().zip(touch.q_rad).any(|(a, b)| (a - b).abs() > SAME_POSE_RAD);
                if moved {
                    return Err(FitError::OtherPose {
                        line: touch.line,
                        point: touches.points.get(touch.point).cloned().unwrap_or_default(),
                    });
                }
                point.lines.push(touch.line);
                point.t_min.push(touch.t_min);
                point.observed_m.push(*observed);
            }
            None => points.push(Point {
                index: touch.point,
                q_rad: touch.q_rad,
                signature: signature(chain, &touch.q_rad, tool_m),
                lines: vec![touch.line],
                t_min: vec![touch.t_min],
                observed_m: vec![*observed],
                moved_min: Vec::new(),
            }),
        }
    }
    let all = points.len();
    points.retain(|p| p.t_min.len() >= FEWEST_TOUCHES);
    if points.is_empty() {
        return Err(FitError::TooFew { touches: touches.touches.len(), points: all });
    }
    Ok(points)
}

//! Where the touching tip is by the touches: to lead a tip to one point in different orientations puts the flange to different places,
//! which a wrong tool makes different points. Touches in one orientation say nothing of it.

use super::course::{FEWEST_TOUCHES, PointCourse, histories};
use super::history::{Standstill, ThermalHistory, warmth};
use measurements::{Touch, Touches};
use nalgebra::{Matrix3, Vector3};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::kinematics::Chain;
use robot_model::robot::Robot;
use robot_model::units::{m_from_mm, mm_from_m};

/// Orientations that differ by less, rms in radians, may be no more than how exactly joints are read, which moves the tip as well.
const LEAST_TURN_RAD: f64 = 2e-3;
/// A tip that is further from where it is taken to be is no matter of how exactly it is known, mm.
const MOST_APART_MM: f64 = 5.0;
/// And it is further by so many standard deviations.
const SURE: f64 = 5.0;

/// What the touches tell of the tip's place on the flange.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TipCheck {
    /// Of the three directions on the flange, how many the touches tell the tip's place in.
    pub directions: usize,
    /// From where it is taken to be to where the touches have it, in the directions that are told, flange axes, metres.
    pub apart_m: Vector3<f64>,
    /// Largest standard deviation of these directions, metres.
    pub sigma_m: f64,
    /// Where it is taken to be, metres.
    tool_m: Vector3<f64>,
}

impl TipCheck {
    /// What says that the tip is elsewhere, if it is.
    #[must_use]
    pub fn warning(&self) -> Option<Diagnostic> {
        let apart_m = self.apart_m.norm();
        if apart_m < m_from_mm(MOST_APART_MM) || apart_m < SURE * self.sigma_m {
            return None;
        }
        let coordinates = |of: Vector3<f64>| {
            let [x, y, z] = <[f64; 3]>::from(of).map(mm_from_m);
            format!("({x:.1}, {y:.1}, {z:.1})")
        };
        let place = if self.directions == 3 {
            format!("at {} mm from the flange", coordinates(self.tool_m + self.apart_m))
        } else {
            format!("off by {} mm at least", coordinates(self.apart_m))
        };
        Some(
            Diagnostic::warning(
                "fit::tool",
                format!(
                    "the touches, whose orientations differ, say that the tip is {place}, {:.1} +- {:.1} mm from where it is taken to be",
                    mm_from_m(apart_m),
                    mm_from_m(self.sigma_m)
                ),
            )
            .help("--tool X,Y,Z names it; turns of the wrist move it by as much more"),
        )
    }
}

/// Where fixed points that are touched say the tip is; `None` of a tracker's points, which tell it otherwise.
#[must_use]
pub fn check_tip(
    touches: &Touches,
    robot: &Robot,
    tool_m: Vector3<f64>,
    stops: &[Standstill],
) -> Option<TipCheck> {
    if touches.touches.iter().any(|touch| touch.measured_m.is_some()) {
        return None;
    }
    let chain = Chain::nominal(robot);
    let of_point = |point: usize| {
        let own: Vec<&Touch> = touches.touches.iter().filter(|touch| touch.point == point).collect();
        (own.len() >= FEWEST_TOUCHES).then(|| TouchedPoses::new(&own, &chain, tool_m))
    };
    let points: Vec<TouchedPoses> = (0..touches.points.len()).filter_map(of_point).collect();
    let courses = histories(!stops.is_empty());
    let solved = courses.iter().map(|course| Solved::new(&points, course, stops));
    let best = solved.min_by(|a, b| a.left_m2.total_cmp(&b.left_m2))?;
    Some(best.check(tool_m))
}

/// The touches of one point: by how much the arm believes its tip to have moved, and what a shift of the tip adds.
struct TouchedPoses {
    tip: PointCourse,
    /// The same of each axis of the flange.
    axes: [PointCourse; 3],
}

impl TouchedPoses {
    fn new(touches: &[&Touch], chain: &Chain, tool_m: Vector3<f64>) -> Self {
        let poses: Vec<_> = touches.iter().map(|touch| chain.forward(&touch.q_rad)).collect();
        let course = |moved_m: Vec<Vector3<f64>>| PointCourse {
            name: String::new(),
            t_min: touches.iter().map(|touch| touch.t_min).collect(),
            moved_m,
        };
        Self {
            tip: course(poses.iter().map(|pose| pose.translation.vector + pose.rotation * tool_m).collect()),
            axes: [Vector3::x(), Vector3::y(), Vector3::z()]
                .map(|axis| course(poses.iter().map(|pose| pose.rotation * axis).collect())),
        }
    }
}

/// The tip's shift under one course of warmth: normal equations of three unknowns.
struct Solved {
    squares: Matrix3<f64>,
    right: Vector3<f64>,
    left_m2: f64,
    touches: f64,
    freedom: f64,
}

impl Solved {
    fn new(points: &[TouchedPoses], course: &ThermalHistory, stops: &[Standstill]) -> Self {
        let mut solved = Self {
            squares: Matrix3::zeros(),
            right: Vector3::zeros(),
            left_m2: 0.0,
            touches: 0.0,
            freedom: -3.0,
        };
        for point in points {
            let shares = warmth(course, stops, &point.tip.t_min);
            let tip_m = point.tip.left_m(&shares);
            let axes = point.axes.each_ref().map(|axis| axis.left_m(&shares));
            for (k, at_m) in tip_m.iter().enumerate() {
                let turned = Matrix3::from_columns(&axes.each_ref().map(|axis| axis[k]));
                solved.squares += turned.transpose() * turned;
                solved.right -= turned.transpose() * at_m;
                solved.left_m2 += at_m.norm_squared();
            }
            solved.touches += tip_m.len() as f64;
            solved.freedom += point.tip.freedom();
        }
        let told = solved.squares.symmetric_eigen();
        for (k, square) in told.eigenvalues.iter().enumerate().filter(|(_, square)| **square > 0.0) {
            solved.left_m2 -= told.eigenvectors.column(k).dot(&solved.right).powi(2) / square;
        }
        solved
    }

    fn check(&self, tool_m: Vector3<f64>) -> TipCheck {
        let variance_m2 = self.left_m2.max(0.0) / self.freedom.max(1.0);
        let told = self.squares.symmetric_eigen();
        let mut check = TipCheck { directions: 0, apart_m: Vector3::zeros(), sigma_m: 0.0, tool_m };
        for (k, &square) in told.eigenvalues.iter().enumerate() {
            let sigma_m = (variance_m2 / square).sqrt();
            let is_told =
                square > self.touches * LEAST_TURN_RAD.powi(2) && sigma_m < m_from_mm(MOST_APART_MM);
            if is_told {
                let direction = told.eigenvectors.column(k).into_owned();
                check.directions += 1;
                check.apart_m += direction * (direction.dot(&self.right) / square);
                check.sigma_m = check.sigma_m.max(sigma_m);
            }
        }
        check
    }
}

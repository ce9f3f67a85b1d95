//! A fitted warm-up, and its forms for other commands: a deformation, an identified model.

use super::common_motion::CommonStep;
use super::history::Standstill;
use super::parameters::PARAMETERS;
use super::touch_residuals::TouchResidual;
use nalgebra::{DMatrix, Vector3};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::identified::{
    Estimate, FoundBy, Growth, Identified, MeasuredRange, PayloadScaling, Term,
};
use robot_model::deform::{Deformation, EffectKind, GrowthLaw};
use robot_model::kinematics::FrameOffsets;
use robot_model::robot::{Axis, Robot, RobotDigest};

/// A settled deformation with its growth, fitted to touches.
#[derive(Clone, Debug)]
pub struct WarmUp {
    /// Law of growth with its τ.
    pub growth: GrowthLaw,
    /// Standard deviation of τ, minutes.
    pub tau_sigma_min: f64,
    /// Probability of the other law.
    pub other_law: f64,
    /// Time constant of cooling and its standard deviation, minutes; `None` without a stop.
    pub tau_cool_min: Option<[f64; 2]>,
    /// The standstills that the fit assumed.
    pub stops: Vec<Standstill>,
    /// Whether they were named; otherwise they are long pauses between touches.
    pub stops_are_named: bool,
    /// Noise of one coordinate of a touch, metres.
    pub sigma_m: f64,
    /// Settled deformation, in the order of a table's rows: metres and radians.
    pub settled: [f64; PARAMETERS],
    /// Covariance of `settled`, 36 x 36, SI.
    pub covariance: DMatrix<f64>,
    /// Size of the prior of shifts and turns that the touches ask for, metres and radians.
    pub prior: [f64; 2],
    /// Each point: name, joints, and how far it moves when settled, as touched, metres.
    pub points: Vec<TouchedPoint>,
    /// Those that were knocked: their later touches count from another place.
    pub knocked: Vec<KnockedPoint>,
    /// When all points moved together: their later touches count from places of their own.
    pub moved: Vec<CommonStep>,
    /// Every touch that took part, in the order of time.
    pub residuals: Vec<TouchResidual>,
    /// Minutes of the first and last touch.
    pub span_min: [f64; 2],
    /// Number of touches used.
    pub touches: usize,
    /// What a person should look at in the touches.
    pub warnings: Vec<Diagnostic>,
}

/// A point of the touches.
#[derive(Clone, Debug, PartialEq)]
pub struct TouchedPoint {
    /// Name of the touched point.
    pub name: String,
    /// Joints at the first touch.
    pub q_rad: [f64; 6],
    /// Displacement of the tool when settled, as these touches alone say it, base axes, metres.
    pub settled_m: Vector3<f64>,
}

/// A point that was elsewhere from one touch to the next.
#[derive(Clone, Debug, PartialEq)]
pub struct KnockedPoint {
    /// Name of the touched point.
    pub name: String,
    /// The last touch before and the first after it, minutes since the cold start.
    pub between_min: [f64; 2],
    /// How far the touches after it are from where those before it would be, base axes, metres.
    pub step_m: Vector3<f64>,
}

impl WarmUp {
    /// Leaves the time constant of cooling out where all points moved in each stop and it is known no better than by a quarter: that of warming,
    /// which stands in for it then, is as good.
    pub(super) fn drop_vague_cooling(&mut self) {
        const KNOWN_TO: f64 = 0.25;
        let moved_in = |stop: &Standstill| {
            self.moved.iter().any(|m| m.between_min[0] < stop.to_min && stop.from_min < m.between_min[1])
        };
        let is_vague = self.tau_cool_min.is_some_and(|[tau_min, sigma_min]| sigma_min > KNOWN_TO * tau_min);
        if is_vague && self.stops.iter().all(moved_in) {
            self.tau_cool_min = None;
        }
    }

    /// The settled deformation as frame offsets.
    #[must_use]
    pub fn offsets(&self) -> FrameOffsets {
        let mut offsets = FrameOffsets::default();
        for (row, values) in offsets.0.iter_mut().zip(self.settled.chunks_exact(6)) {
            row.copy_from_slice(values);
        }
        offsets
    }

    /// The deformation with its growth law.
    #[must_use]
    pub fn deformation(&self) -> Deformation {
        Deformation::from_static(self.offsets(), self.growth)
    }

    /// One standard deviation of a parameter, metres or radians.
    #[must_use]
    pub fn sigma(&self, i: usize) -> f64 {
        self.covariance[(i, i)].max(0.0).sqrt()
    }

    /// How much of a parameter the touches tell: 0 nothing beyond the prior, 1 all.
    #[must_use]
    pub fn share_from_data(&self, i: usize) -> f64 {
        (1.0 - self.covariance[(i, i)] / self.prior[usize::from(i % 6 >= 3)].powi(2)).clamp(0.0, 1.0)
    }

    /// The same as an identified model: joint 1's frame as base drift, the others as links.
    #[must_use]
    pub fn identified(&self, robot: &Robot) -> Identified {
        let growth = Growth::from(self.growth);
        let terms = (0..6).map(|i| Term {
            kind: if i == 0 { EffectKind::BaseDrift } else { EffectKind::LinkGeometry },
            joint: (i > 0).then(|| Axis::at(i - 1)),
            joint_b: None,
            n: None,
            growth,
            held_above_n_m: None,
            payload_scaling: PayloadScaling::default(),
            cause: true,
            values: (6 * i..6 * i + 6)
                .map(|k| Estimate { value: self.settled[k], sigma: Some(self.sigma(k)) })
                .collect(),
        });
        let mut q_rad = [[f64::INFINITY, f64::NEG_INFINITY]; 6];
        for point in &self.points {
            for (range, q) in q_rad.iter_mut().zip(point.q_rad) {
                *range = [range[0].min(q), range[1].max(q)];
            }
        }
        Identified {
            robot: robot.name.clone(),
            robot_digest: Some(RobotDigest::of(&robot.geometry())),
            found_by: Some(FoundBy::WarmUp),
            sigma_m: Some(self.sigma_m),
            // To a tenth of a minute: no fit knows it better.
            tau_cool_min: self.tau_cool_min.map(|[tau_min, _]| (10.0 * tau_min).round() / 10.0),
            measured_range: MeasuredRange {
                rows: self.touches,
                q_rad: Some(q_rad.into()),
                t_min: Some(self.span_min),
                ..MeasuredRange::default()
            },
            terms: terms.collect(),
            ..Identified::default()
        }
    }
}

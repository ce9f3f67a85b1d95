//! Where a deformation table comes from: fixed points touched over a warm-up and one stop.
//!
//! Every touch says how far the tool is from where the nominal arm believes it is. All touches together are a settled
//! deformation (six numbers per joint, size priors) times how warm the robot was: r = p_k + A_k x g(t) + noise, with an
//! unknown constant p_k for each point. Growth law, its time constant, that of cooling and the sizes of the priors are
//! weighed by their evidence on a grid. Knows no RAPID and no files.

mod history;
mod posterior;
mod targets;

pub use history::Standstill;
pub use targets::{SuggestedPoint, TargetForecast, WorkTarget, forecast_at_targets};

use crate::measure::{self, RegisterError, Station, Touches, register};
use history::{cool_taus_min, taus_min, warmth};
use nalgebra::{DMatrix, Matrix3xX, Vector3};
use posterior::{Posterior, Sums, log_evidence, posterior};
use rayon::prelude::*;
use robot_model::deform::EffectKind;
use robot_model::deform::identified::{Growth, Identified, MeasuredRange, PayloadScaling, Term, Value};
use robot_model::deform::{Deformation, GrowthLaw};
use robot_model::kinematics::{Chain, FrameOffsets};
use robot_model::robot::Robot;

/// Parameters: six for each of the six joint frames.
pub const PARAMETERS: usize = 36;
/// A pose that moved by more than this between two touches of one point is another pose, radians.
const SAME_POSE_RAD: f64 = 0.02;

/// Histories this much less likely than the likeliest do not count.
const NEGLIGIBLE_NATS: f64 = 14.0;

/// Why there is no fit.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FitError {
    /// Too few touches.
    #[error(
        "{touches} touches of {points} points say too little: at least 6 touches of one point are needed"
    )]
    TooFew {
        /// How many.
        touches: usize,
        /// Of how many points.
        points: usize,
    },
    /// One point, two poses.
    #[error(
        "line {line}: point {point} is touched in another pose than before; give each pose a name of its own"
    )]
    OtherPose {
        /// Line in the file.
        line: u64,
        /// Its name.
        point: String,
    },
    /// All at one time.
    #[error("all touches lie within {span_min:.0} minutes: touch again while the robot warms up")]
    NoTime {
        /// How long.
        span_min: f64,
    },
    /// The instrument cannot be registered.
    #[error(transparent)]
    Register(#[from] RegisterError),
}

/// What the caller knows beside the touches.
#[derive(Clone, Debug, Default)]
pub struct FitOptions {
    /// Place of the touching point in the flange's frame, metres, to about a millimetre.
    pub tool_m: Vector3<f64>,
    /// When the robot stood; `None` = the longest pause between touches.
    pub stops: Option<Vec<Standstill>>,
}

/// A fitted warm-up.
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
    /// The stops used.
    pub stops: Vec<Standstill>,
    /// Noise of one coordinate of a touch, metres.
    pub sigma_m: f64,
    /// Settled deformation, in the order of a table's rows: metres and radians.
    pub settled: [f64; PARAMETERS],
    /// Covariance of it.
    pub covariance: DMatrix<f64>,
    /// Size of the prior of shifts and turns that the touches ask for, metres and radians.
    pub prior: [f64; 2],
    /// Each point: name, joints, and how far it moves when settled, as touched, metres.
    pub points: Vec<TouchedPoint>,
    /// Minutes of the first and last touch.
    pub span_min: [f64; 2],
    /// Touches used.
    pub touches: usize,
}

/// A point of the touches.
#[derive(Clone, Debug, PartialEq)]
pub struct TouchedPoint {
    /// Its name.
    pub name: String,
    /// Joints at the first touch.
    pub q_rad: [f64; 6],
    /// Displacement of the tool when settled, as these touches alone say it, base axes, metres.
    pub settled_m: Vector3<f64>,
}

/// The point's motion per unit of each parameter, base axes: 3 x 36.
#[must_use]
pub fn signature(chain: &Chain, q_rad: &[f64; 6], tool_m: &Vector3<f64>) -> Matrix3xX<f64> {
    let frames = chain.frames(q_rad);
    let flange = &frames[6];
    let point_m = flange.translation.vector + flange.rotation * tool_m;
    let mut signature = Matrix3xX::zeros(PARAMETERS);
    for i in 0..6 {
        let axes = if i == 0 { None } else { Some(frames[i - 1].rotation) };
        let lever = point_m - frames[i].translation.vector;
        for k in 0..3 {
            let mut axis = Vector3::zeros();
            axis[k] = 1.0;
            let axis = axes.map_or(axis, |turn| turn * axis);
            signature.set_column(6 * i + k, &axis);
            signature.set_column(6 * i + k + 3, &axis.cross(&lever));
        }
    }
    signature
}

/// A history of warmth, by law and cooling, and what the touches say under it.
type Fitted = (GrowthLaw, Option<f64>, Posterior);

/// Fits a warm-up.
///
/// # Errors
/// [`FitError`]
pub fn fit(touches: &Touches, robot: &Robot, options: &FitOptions) -> Result<WarmUp, FitError> {
    let chain = Chain::nominal(robot);
    let observed = observed_m(touches, robot, &chain, options)?;
    let points = grouped(touches, &chain, &observed, &options.tool_m)?;
    let first_min = touches.touches.first().map_or(0.0, |t| t.t_min);
    let last_min = touches.touches.last().map_or(0.0, |t| t.t_min);
    if last_min - first_min < 20.0 {
        return Err(FitError::NoTime { span_min: last_min - first_min });
    }
    let stops = options.stops.clone().unwrap_or_else(|| history::longest_pause(touches));
    let mut grid = Vec::new();
    for law in [GrowthLaw::Exp { tau_min: 1.0 }, GrowthLaw::TwoStage { tau_min: 1.0 }] {
        for tau_min in taus_min() {
            let law = match law {
                GrowthLaw::Exp { .. } => GrowthLaw::Exp { tau_min },
                _ => GrowthLaw::TwoStage { tau_min },
            };
            if stops.is_empty() {
                grid.push((law, None));
            } else {
                grid.extend(cool_taus_min(tau_min).map(|cool| (law, Some(cool))));
            }
        }
    }
    let sums = |law, cool| points.iter().map(|p| p.sums(law, cool, &stops)).collect::<Vec<Sums>>();
    let weigh = |grid: Vec<(GrowthLaw, Option<f64>)>| -> Vec<(GrowthLaw, Option<f64>, f64)> {
        grid.into_par_iter()
            .filter_map(|(law, cool)| Some((law, cool, log_evidence(&sums(law, cool))?)))
            .collect()
    };
    let coarse = weigh(grid);
    let Some(likeliest) = coarse.iter().max_by(|a, b| a.2.total_cmp(&b.2)) else {
        return Err(FitError::TooFew { touches: touches.touches.len(), points: points.len() });
    };
    let other_law = share_of_other_law(&coarse, likeliest);
    // Round the likeliest, as wide as the evidence is and fine enough for it.
    let weighed = weigh(history::round(&coarse, likeliest));
    let most = weighed.iter().map(|w| w.2).fold(f64::NEG_INFINITY, f64::max);
    let fits: Vec<Fitted> = weighed
        .into_par_iter()
        .filter(|w| w.2 > most - NEGLIGIBLE_NATS)
        .filter_map(|(law, cool, _)| Some((law, cool, posterior(&sums(law, cool))?)))
        .collect();
    let most = fits.iter().map(|f| f.2.log_evidence).fold(f64::NEG_INFINITY, f64::max);
    let weights: Vec<f64> = fits.iter().map(|f| (f.2.log_evidence - most).exp()).collect();
    let total: f64 = weights.iter().sum();
    let weights: Vec<f64> = weights.into_iter().map(|w| w / total).collect();
    let best = weights.iter().enumerate().max_by(|a, b| a.1.total_cmp(b.1)).map_or(0, |(i, _)| i);
    let Some((growth, cool, chosen)) = fits.get(best).cloned() else {
        return Err(FitError::TooFew { touches: touches.touches.len(), points: points.len() });
    };
    let spread = |of: fn(&Fitted) -> Option<f64>, about: f64| -> f64 {
        fits.iter()
            .zip(&weights)
            .map(|(f, w)| w * of(f).map_or(0.0, |v| (v - about).powi(2)))
            .sum::<f64>()
            .sqrt()
    };
    // The values belong to the likeliest law; how well they are known takes in all of them.
    let mut covariance = DMatrix::zeros(PARAMETERS, PARAMETERS);
    for ((_, _, one), weight) in fits.iter().zip(&weights).filter(|(_, w)| **w > 1e-6) {
        let away = &one.mean - &chosen.mean;
        covariance += (&one.covariance + &away * away.transpose()) * *weight;
    }
    let mut settled = [0.0; PARAMETERS];
    settled.copy_from_slice(chosen.mean.as_slice());
    let touched = points
        .iter()
        .map(|p| TouchedPoint {
            name: touches.points.get(p.index).cloned().unwrap_or_default(),
            q_rad: p.q_rad,
            settled_m: p.sums(growth, cool, &stops).settled_m(),
        })
        .collect();
    Ok(WarmUp {
        growth,
        tau_sigma_min: spread(|f| f.0.tau_min(), growth.tau_min().unwrap_or(0.0)),
        other_law,
        tau_cool_min: cool.map(|cool| [cool, spread(|f| f.1, cool)]),
        stops,
        sigma_m: chosen.sigma_m,
        settled,
        covariance,
        prior: chosen.prior,
        points: touched,
        span_min: [first_min, last_min],
        touches: touches.touches.len(),
    })
}

/// Probability of the law that is not the likeliest's.
fn share_of_other_law(
    weighed: &[(GrowthLaw, Option<f64>, f64)],
    likeliest: &(GrowthLaw, Option<f64>, f64),
) -> f64 {
    let [mut all, mut other] = [0.0; 2];
    for one in weighed {
        let weight = (one.2 - likeliest.2).exp();
        all += weight;
        if !same_law(&one.0, &likeliest.0) {
            other += weight;
        }
    }
    other / all
}

/// Of one kind, whatever their τ.
fn same_law(a: &GrowthLaw, b: &GrowthLaw) -> bool {
    std::mem::discriminant(a) == std::mem::discriminant(b)
}

/// How far each touch says the real tool is from where the nominal arm believes it, up to a constant of its point.
fn observed_m(
    touches: &Touches,
    robot: &Robot,
    chain: &Chain,
    options: &FitOptions,
) -> Result<Vec<Vector3<f64>>, FitError> {
    let believed = |q_rad: &[f64; 6], tool_m: &Vector3<f64>| {
        let flange = chain.forward(q_rad);
        flange.translation.vector + flange.rotation * tool_m
    };
    if touches.touches.iter().all(|t| t.measured_m.is_none()) {
        // The point stands still: what the arm believes has moved is what it really moved by, the other way round.
        return Ok(touches.touches.iter().map(|t| -believed(&t.q_rad, &options.tool_m)).collect());
    }
    let stations: Vec<Station> = touches
        .touches
        .iter()
        .enumerate()
        .map(|(i, t)| Station {
            pose: t.point,
            target: 0,
            t_min: Some(t.t_min),
            q_rad: t.q_rad,
            reading: t.measured_m.map_or(measure::Reading::Touch { fixed_point: t.point }, |position_m| {
                measure::Reading::Point { position_m }
            }),
            orientation: None,
            direction: None,
            payload_kg: None,
            joint_temperature_c: None,
            air_temperature_c: None,
            rows: vec![i],
        })
        .collect();
    let poses: Vec<_> = stations.iter().map(|s| s.pose(&Chain::nominal(robot))).collect();
    let registration = register(&stations, &poses, 1, Some(options.tool_m))?;
    Ok(stations.iter().zip(&poses).map(|(s, pose)| registration.residual_m(s, pose)).collect())
}

/// One point's touches.
pub(super) struct Point {
    index: usize,
    q_rad: [f64; 6],
    signature: Matrix3xX<f64>,
    t_min: Vec<f64>,
    observed_m: Vec<Vector3<f64>>,
}

impl Point {
    fn sums(&self, law: GrowthLaw, cool_min: Option<f64>, stops: &[Standstill]) -> Sums {
        let grown = warmth(law, cool_min, stops, &self.t_min);
        Sums::new(&self.signature, &grown, &self.observed_m)
    }
}

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
                point.t_min.push(touch.t_min);
                point.observed_m.push(*observed);
            }
            None => points.push(Point {
                index: touch.point,
                q_rad: touch.q_rad,
                signature: signature(chain, &touch.q_rad, tool_m),
                t_min: vec![touch.t_min],
                observed_m: vec![*observed],
            }),
        }
    }
    let all = points.len();
    points.retain(|p| p.t_min.len() >= 6);
    if points.is_empty() {
        return Err(FitError::TooFew { touches: touches.touches.len(), points: all });
    }
    Ok(points)
}

impl WarmUp {
    /// The settled offsets.
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
            joint: (i > 0).then(|| i - 1),
            joint_b: None,
            n: None,
            growth,
            held_above_n_m: None,
            payload_scaling: PayloadScaling::default(),
            cause: true,
            values: (6 * i..6 * i + 6)
                .map(|k| Value { value: self.settled[k], sigma: Some(self.sigma(k)) })
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
            verdict: "warm-up".to_owned(),
            sigma_m: Some(self.sigma_m),
            measured_range: MeasuredRange {
                rows: self.touches,
                q_rad,
                t_min: Some(self.span_min),
                ..MeasuredRange::default()
            },
            terms: terms.collect(),
            ..Identified::default()
        }
    }
}

//! Calibration: the six offsets of each joint frame from measured flange poses.
//!
//! Weighted least squares with a prior for the size of each offset, because no measurement tells all 36 apart: a shift along a joint's
//! axis and one of the frame behind it along the same line move the flange alike (Mooring, Roth and Driels, Fundamentals of Manipulator
//! Calibration, 1991, chapter 2). Gauss and Newton's steps, halved until the cost falls. EightPoses poses side by side.

use super::chain::{Chain, FrameOffsets};
use super::chains::eight_poses;
use super::dispatch::on_widest;
use super::lanes::{self, LANES, Lanes};
use super::offset_columns::{AllColumns, AllProducts, Axes, Columns, EightPoses, LaneSums, UNKNOWNS};
use crate::robot::Robot;
use nalgebra::{DMatrix, DVector, Isometry3};

const MOST_STEPS: usize = 50;
const MOST_HALVINGS: usize = 20;
/// A step that lowers the cost by less than this share of it is the last.
const SETTLED: f64 = 1e-12;
/// A cost under this, squares of sigmas, is rounding: its share says nothing.
const LEAST_COST: f64 = 1e-6;

/// A pose of the flange, measured at joints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeasuredPose {
    /// Joints as the controller reads them, radians.
    pub q_rad: [f64; 6],
    /// Flange in the base, metres.
    pub base_from_flange: Isometry3<f64>,
}

/// What is known before a calibration: how well poses are measured, and how large offsets are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CalibrationOptions {
    /// One standard deviation of a coordinate of a measured position, metres.
    pub sigma_m: f64,
    /// The same of a measured orientation about each axis, radians; infinite where none was measured.
    pub sigma_rad: f64,
    /// Usual size (one standard deviation about zero) of a frame's shift along each axis, metres.
    pub prior_shift_m: f64,
    /// The same of a frame's turn about each axis, radians.
    pub prior_turn_rad: f64,
}

impl Default for CalibrationOptions {
    /// A laser tracker on an industrial arm: 0.02 mm and 0.1 mrad, offsets of a millimetre and two milliradians.
    fn default() -> Self {
        Self { sigma_m: 2e-5, sigma_rad: 1e-4, prior_shift_m: 1e-3, prior_turn_rad: 2e-3 }
    }
}

/// The offsets that explain measured poses best.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Calibration {
    /// Rows 0 to 5 are fitted; row 6, the flange's, is zero: it is the same as the tool's.
    pub offsets: FrameOffsets,
    /// Squares of all residuals and offsets, each in its standard deviations.
    pub cost: f64,
    /// Root of the mean square of the distance between measured and calibrated position, metres.
    pub rms_m: f64,
    /// The same of the angle, radians.
    pub rms_rad: f64,
    /// Steps that were taken.
    pub steps: usize,
}

/// Why there is no calibration.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum CalibrateError {
    /// A standard deviation in [`CalibrationOptions`] is not positive, or infinite where only that of the turns may be.
    #[error("standard deviations must be positive")]
    Options,
    /// Rows are counted from 0.
    #[error("pose {0} holds a number that is none")]
    NotFinite(usize),
    /// There is nothing to fit.
    #[error("no pose was measured")]
    NoPoses,
    /// The poses are too far from the robot's for steps along tangents.
    #[error("the fit does not settle: are these poses of this robot, in its base frame?")]
    NotSettled,
}

/// The offsets of the six joint frames of `robot` that explain `measured` best.
///
/// Of directions that the poses do not tell apart the smallest offsets are taken: use them all together, not one by one.
///
/// ```
/// use robot_model::kinematics::{CalibrationOptions, Chain, FrameOffsets, MeasuredPose, calibrate};
/// use robot_model::robot::Robot;
///
/// let robot = Robot::built_in("irb140").expect("it is one of the library's");
/// // Joint 3 stands a tenth of a millimetre too high.
/// let mut truth = FrameOffsets::default();
/// truth.0[2][2] = 1e-4;
/// let measured: Vec<MeasuredPose> = (0..40)
///     .map(|i| {
///         let q_rad = std::array::from_fn(|j| ((7 * i + 3 * j) as f64).sin());
///         let base_from_flange = Chain::with_offsets(&robot, &truth).forward(&q_rad);
///         MeasuredPose { q_rad, base_from_flange }
///     })
///     .collect();
/// let found = calibrate(&robot, &measured, &CalibrationOptions::default()).expect("the poses are its own");
/// assert!(found.rms_m < 1e-6);
/// ```
///
/// # Errors
/// [`CalibrateError`].
pub fn calibrate(
    robot: &Robot,
    measured: &[MeasuredPose],
    options: &CalibrationOptions,
) -> Result<Calibration, CalibrateError> {
    let CalibrationOptions { sigma_m, sigma_rad, prior_shift_m, prior_turn_rad } = *options;
    let positive = |sigma: f64| sigma > 0.0;
    let finite = [sigma_m, prior_shift_m, prior_turn_rad].iter().all(|sigma| sigma.is_finite());
    if !finite || ![sigma_m, sigma_rad, prior_shift_m, prior_turn_rad].into_iter().all(positive) {
        return Err(CalibrateError::Options);
    }
    if measured.is_empty() {
        return Err(CalibrateError::NoPoses);
    }
    let is_finite = |pose: &MeasuredPose| {
        let numbers = pose.base_from_flange.to_homogeneous();
        pose.q_rad.iter().chain(&numbers).all(|number| number.is_finite())
    };
    if let Some(row) = measured.iter().position(|pose| !is_finite(pose)) {
        return Err(CalibrateError::NotFinite(row));
    }
    let eights: Vec<EightPoses> = measured.chunks(LANES).map(eight_of).collect();
    let residuals = |offsets: &FrameOffsets| Residuals::of(robot, offsets, &eights, options);
    let mut here = residuals(&FrameOffsets::default());
    for steps in 0..MOST_STEPS {
        let normal = Normal::of(&here, options);
        let step = normal.step().ok_or(CalibrateError::NotSettled)?;
        let there = (0..MOST_HALVINGS).find_map(|halvings| {
            let share = 0.5_f64.powi(halvings as i32);
            let there = residuals(&moved(&here.offsets, &step, share));
            (there.cost <= here.cost).then_some(there)
        });
        // Not even a millionth of a step lowers the cost: rounding is all that is left of it, or it leads nowhere.
        let Some(there) = there else {
            let is_rounding = normal.promised(&step) <= 1e-9 * here.cost.max(1.0);
            return if is_rounding {
                Ok(here.done(steps, measured.len()))
            } else {
                Err(CalibrateError::NotSettled)
            };
        };
        let gained = here.cost - there.cost;
        here = there;
        if gained <= SETTLED * here.cost.max(LEAST_COST) {
            return Ok(here.done(steps + 1, measured.len()));
        }
    }
    Err(CalibrateError::NotSettled)
}

fn moved(offsets: &FrameOffsets, step: &DVector<f64>, share: f64) -> FrameOffsets {
    let mut moved = *offsets;
    for (i, step) in step.iter().enumerate() {
        moved.0[i / 6][i % 6] += share * step;
    }
    moved
}

fn eight_of(some: &[MeasuredPose]) -> EightPoses {
    let poses: Vec<Isometry3<f64>> = some.iter().map(|pose| pose.base_from_flange).collect();
    EightPoses {
        q_rad: std::array::from_fn(|j| lanes::gather(some, |pose| pose.q_rad[j])),
        pose: eight_poses(&poses),
        is_there: Lanes(std::array::from_fn(|k| if k < some.len() { 1.0 } else { 0.0 })),
    }
}

/// Residuals and their squares at some offsets.
struct Residuals {
    /// Of each eight poses, with the columns of the unknowns.
    eights: Vec<Columns>,
    offsets: FrameOffsets,
    cost: f64,
    squares_m: f64,
    squares_rad: f64,
}

/// Lane by lane in their order: the same bits whatever the machine's vectors are.
fn of_lanes(lanes: &Lanes) -> f64 {
    lanes.0.iter().sum()
}

impl Residuals {
    fn of(
        robot: &Robot,
        offsets: &FrameOffsets,
        eights: &[EightPoses],
        options: &CalibrationOptions,
    ) -> Self {
        let arm = Axes::of(Chain::with_offsets(robot, offsets), offsets);
        let weights = [options.sigma_m.recip(), options.sigma_rad.recip()];
        let mut columns = Vec::with_capacity(eights.len());
        let squares = on_widest(AllColumns { arm: &arm, eights, weights, columns: &mut columns });
        let [squares_m, squares_rad] = squares.each_ref().map(of_lanes);
        let mut cost = squares_m + squares_rad;
        for (offset, size) in prior(offsets, options) {
            cost += (offset / size).powi(2);
        }
        Self {
            eights: columns,
            offsets: *offsets,
            cost,
            squares_m: squares_m * options.sigma_m.powi(2),
            squares_rad: if options.sigma_rad.is_finite() {
                squares_rad * options.sigma_rad.powi(2)
            } else {
                0.0
            },
        }
    }

    fn done(&self, steps: usize, poses: usize) -> Calibration {
        let rms = |squares: f64| (squares / poses as f64).sqrt();
        let [rms_m, rms_rad] = [rms(self.squares_m), rms(self.squares_rad)];
        Calibration { offsets: self.offsets, cost: self.cost, rms_m, rms_rad, steps }
    }
}

/// Each offset with its usual size.
fn prior<'a>(
    offsets: &'a FrameOffsets,
    options: &'a CalibrationOptions,
) -> impl Iterator<Item = (f64, f64)> + 'a {
    (0..UNKNOWNS).map(|i| {
        let size = if i % 6 < 3 { options.prior_shift_m } else { options.prior_turn_rad };
        (offsets.0[i / 6][i % 6], size)
    })
}

/// The normal equations at some offsets.
struct Normal {
    products: DMatrix<f64>,
    /// Of each unknown's column with the residual.
    right: DVector<f64>,
}

impl Normal {
    fn of(here: &Residuals, options: &CalibrationOptions) -> Self {
        let mut sums = LaneSums::nothing();
        on_widest(AllProducts { eights: &here.eights, sums: &mut sums });
        let at = |i: usize, j: usize| of_lanes(sums.product(i.max(j), i.min(j)));
        let mut all = Self {
            products: DMatrix::from_fn(UNKNOWNS, UNKNOWNS, at),
            right: DVector::from_fn(UNKNOWNS, |i, _| of_lanes(&sums.right[i])),
        };
        for (i, (offset, size)) in prior(&here.offsets, options).enumerate() {
            all.products[(i, i)] += size.powi(-2);
            all.right[i] -= offset * size.powi(-2);
        }
        all
    }

    /// The step to where the cost would be least, were it a parabola; `None` where rounding has eaten the matrix.
    fn step(&self) -> Option<DVector<f64>> {
        Some(self.products.clone().cholesky()?.solve(&self.right))
    }

    /// By how much a step would lower the cost, were it a parabola.
    fn promised(&self, step: &DVector<f64>) -> f64 {
        step.iter().zip(&self.right).map(|(step, right)| step * right).sum()
    }
}

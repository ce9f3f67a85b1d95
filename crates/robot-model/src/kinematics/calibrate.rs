//! Calibration: the six offsets of each joint frame from measured flange poses.
//!
//! Weighted least squares with a prior for the size of each offset, because no measurement tells all 36 apart: a shift along a joint's
//! axis and one of the frame behind it along the same line move the flange alike (Mooring, Roth and Driels, Fundamentals of Manipulator
//! Calibration, 1991, chapter 2). Gauss and Newton's steps, halved until the cost falls. Eight poses side by side.

use super::chain::{Chain, FrameOffsets, Frames, Pose, Walk, sin_cos};
use super::dispatch::{Kernel, on_widest};
use super::lanes::{self, LANES, Lanes, Wide};
use super::matrix::{self, Mat3, Vec3, apply, cross, dot, mul, sub, transpose};
use crate::robot::Robot;
use nalgebra::{DMatrix, DVector, Isometry3};

/// Six for each of six joints.
const UNKNOWNS: usize = 36;
/// Of the lower triangle of a symmetric matrix of [`UNKNOWNS`].
const PRODUCTS: usize = UNKNOWNS * (UNKNOWNS + 1) / 2;
const MOST_STEPS: usize = 50;
const MOST_HALVINGS: usize = 20;
/// A step that lowers the cost by less than this share of it is the last.
const SETTLED: f64 = 1e-12;

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
    let eights: Vec<Eight> = measured.chunks(LANES).map(Eight::of).collect();
    let weigh = |offsets: &FrameOffsets| Sums::of(robot, offsets, &eights, options);
    let mut offsets = FrameOffsets::default();
    let mut here = weigh(&offsets);
    for steps in 0..MOST_STEPS {
        let step = here.step().ok_or(CalibrateError::NotSettled)?;
        let there = (0..MOST_HALVINGS).find_map(|halvings| {
            let share = 0.5_f64.powi(halvings as i32);
            let at = moved(&offsets, &step, share);
            let sums = weigh(&at);
            (sums.cost <= here.cost).then_some((at, sums))
        });
        // Not even a millionth of a step lowers the cost: rounding is all that is left of it, or it leads nowhere.
        let Some((at, sums)) = there else {
            let is_rounding = here.promised(&step) <= 1e-9 * here.cost.max(1.0);
            return if is_rounding {
                Ok(here.done(offsets, steps, measured.len()))
            } else {
                Err(CalibrateError::NotSettled)
            };
        };
        let gained = here.cost - sums.cost;
        (offsets, here) = (at, sums);
        if gained <= SETTLED * here.cost {
            return Ok(here.done(offsets, steps + 1, measured.len()));
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

/// Eight measured poses.
struct Eight {
    q_rad: [Lanes; 6],
    poses: [Pose; LANES],
    /// One; zero in lanes that hold no pose.
    is_there: Lanes,
}

impl Eight {
    fn of(some: &[MeasuredPose]) -> Self {
        let pose = |k: usize| some.get(k).or(some.first()).map(|pose| Pose::of(&pose.base_from_flange));
        let nothing = Pose { rotation: Mat3::default(), position_m: Vec3::default() };
        Self {
            q_rad: std::array::from_fn(|j| lanes::gather(some, |pose| pose.q_rad[j])),
            poses: std::array::from_fn(|k| pose(k).unwrap_or(nothing)),
            is_there: Lanes(std::array::from_fn(|k| if k < some.len() { 1.0 } else { 0.0 })),
        }
    }
}

/// The normal equations at some offsets.
struct Sums {
    /// Products of the unknowns' columns, row by row of the lower triangle.
    products: Vec<f64>,
    /// Of each column with the residual.
    right: [f64; UNKNOWNS],
    cost: f64,
    squares_m: f64,
    squares_rad: f64,
}

/// The same, a sum for each lane.
struct LaneSums {
    products: [Lanes; PRODUCTS],
    right: [Lanes; UNKNOWNS],
    squares: [Lanes; 2],
}

impl Sums {
    fn of(robot: &Robot, offsets: &FrameOffsets, eights: &[Eight], options: &CalibrationOptions) -> Self {
        let arm = Axes::of(robot, offsets);
        let zero = Lanes([0.0; LANES]);
        let mut sums =
            Box::new(LaneSums { products: [zero; PRODUCTS], right: [zero; UNKNOWNS], squares: [zero; 2] });
        let weights = [options.sigma_m.recip(), options.sigma_rad.recip()];
        on_widest(AddAll { arm: &arm, eights, weights, sums: &mut sums });
        // Lane by lane in their order: the same bits whatever the machine's vectors are.
        let of_lanes = |lanes: &Lanes| lanes.0.iter().sum::<f64>();
        let [squares_m, squares_rad] = [of_lanes(&sums.squares[0]), of_lanes(&sums.squares[1])];
        let mut all = Self {
            products: sums.products.iter().map(of_lanes).collect(),
            right: sums.right.each_ref().map(of_lanes),
            cost: squares_m + squares_rad,
            squares_m: squares_m * options.sigma_m.powi(2),
            squares_rad: if options.sigma_rad.is_finite() {
                squares_rad * options.sigma_rad.powi(2)
            } else {
                0.0
            },
        };
        for i in 0..UNKNOWNS {
            let size = if i % 6 < 3 { options.prior_shift_m } else { options.prior_turn_rad };
            let offset = offsets.0[i / 6][i % 6];
            all.products[i * (i + 3) / 2] += size.powi(-2);
            all.right[i] -= offset * size.powi(-2);
            all.cost += (offset / size).powi(2);
        }
        all
    }

    /// The step to where the cost would be least, were it a parabola; `None` where rounding has eaten the matrix.
    fn step(&self) -> Option<DVector<f64>> {
        let at = |i: usize, j: usize| self.products[i.max(j) * (i.max(j) + 1) / 2 + i.min(j)];
        let normal = DMatrix::from_fn(UNKNOWNS, UNKNOWNS, at);
        Some(normal.cholesky()?.solve(&DVector::from_row_slice(&self.right)))
    }

    /// By how much a step would lower the cost, were it a parabola.
    fn promised(&self, step: &DVector<f64>) -> f64 {
        step.iter().zip(&self.right).map(|(step, right)| step * right).sum()
    }

    fn done(&self, offsets: FrameOffsets, steps: usize, poses: usize) -> Calibration {
        let rms = |squares: f64| (squares / poses as f64).sqrt();
        let [rms_m, rms_rad] = [rms(self.squares_m), rms(self.squares_rad)];
        Calibration { offsets, cost: self.cost, rms_m, rms_rad, steps }
    }
}

/// An arm, and along and about which axes its frames' offsets move them.
struct Axes {
    chain: Chain,
    /// For each joint the axes of its three shifts, then of its three turns, in the turned frame before it.
    of_joints: [[Vec3; 6]; 6],
}

impl Axes {
    fn of(robot: &Robot, offsets: &FrameOffsets) -> Self {
        let chain = Chain::with_offsets(robot, offsets);
        let of_joints = std::array::from_fn(|i| {
            let before = i.checked_sub(1).map_or(matrix::IDENTITY, |i| chain.turned_from_joint[i]);
            let [_, _, _, x_rad, y_rad, _] = offsets.0[i];
            let about_x = mul(&before, &matrix::rx_ry_rz(x_rad, 0.0, 0.0));
            let about_xy = mul(&before, &matrix::rx_ry_rz(x_rad, y_rad, 0.0));
            let [x, y, z] = transpose(&before);
            [x, y, z, x, matrix::column(&about_x, 1), matrix::column(&about_xy, 2)]
        });
        Self { chain, of_joints }
    }
}

struct AddAll<'a> {
    arm: &'a Axes,
    eights: &'a [Eight],
    /// Of positions, 1/m, and of orientations, 1/rad.
    weights: [f64; 2],
    sums: &'a mut LaneSums,
}

impl Kernel for AddAll<'_> {
    type Output = ();

    #[inline(always)]
    fn run<V: Wide>(self) {
        for eight in self.eights {
            add_eight::<V>(self.arm, eight, self.weights, self.sums);
        }
    }
}

/// Columns and residuals of eight poses, in standard deviations, and their products.
#[inline(always)]
fn add_eight<V: Wide>(arm: &Axes, eight: &Eight, weights: [f64; 2], sums: &mut LaneSums) {
    let is_there = V::load(&eight.is_there);
    let [weight_m, weight_rad] = [is_there * V::splat(weights[0]), is_there * V::splat(weights[1])];
    let sin_cos = sin_cos(&lanes::load6::<V>(&eight.q_rad));
    let mut at =
        Walk(Pose { rotation: matrix::splat_rows(&matrix::IDENTITY), position_m: matrix::splat(&[0.0; 3]) });
    let none = [V::splat(0.0); 3];
    let mut axes = [[none; 6]; 6];
    let mut origins_m = [none; 6];
    for i in 0..6 {
        for (axis, of_joint) in axes[i].iter_mut().zip(&arm.of_joints[i]) {
            *axis = apply(&at.0.rotation, &matrix::splat(of_joint));
        }
        at.advance(&Frames::<V>::step(&arm.chain, i));
        origins_m[i] = at.0.position_m;
        at.turn(&sin_cos[i]);
    }
    at.advance(&Frames::<V>::step(&arm.chain, 6));
    let flange_m = at.0.position_m;
    // Shifts move the flange along their axis; turns turn it about theirs, and move it.
    let (mut moves, mut turns) = ([none; UNKNOWNS], [none; UNKNOWNS]);
    for i in 0..6 {
        let lever_m = sub(&flange_m, &origins_m[i]);
        for k in 0..3 {
            moves[6 * i + k] = matrix::scale(&axes[i][k], weight_m);
            moves[6 * i + 3 + k] = matrix::scale(&cross(&axes[i][3 + k], &lever_m), weight_m);
            turns[6 * i + 3 + k] = matrix::scale(&axes[i][3 + k], weight_rad);
        }
    }
    let (missing_m, missing_rad) =
        missing(&lanes::store3(&flange_m), &lanes::store_rows(&at.0.rotation), &eight.poses);
    let missing_m = matrix::scale(&lanes::load::<V>(&missing_m), weight_m);
    let missing_rad = matrix::scale(&lanes::load::<V>(&missing_rad), weight_rad);
    let add = |sum: &mut Lanes, value: V| *sum = (V::load(sum) + value).store();
    let mut products = sums.products.iter_mut();
    for a in 0..UNKNOWNS {
        for (b, sum) in (0..=a).zip(&mut products) {
            let moved = dot(&moves[a], &moves[b]);
            let both_turn = a % 6 > 2 && b % 6 > 2;
            add(sum, if both_turn { moved + dot(&turns[a], &turns[b]) } else { moved });
        }
        add(&mut sums.right[a], dot(&moves[a], &missing_m) + dot(&turns[a], &missing_rad));
    }
    add(&mut sums.squares[0], dot(&missing_m, &missing_m));
    add(&mut sums.squares[1], dot(&missing_rad, &missing_rad));
}

/// What takes the flanges to where they were measured: metres, and rotation vectors in radians.
#[inline]
fn missing(
    flange_m: &Vec3<Lanes>,
    rotation: &Mat3<Lanes>,
    poses: &[Pose; LANES],
) -> (Vec3<Lanes>, Vec3<Lanes>) {
    let (mut m, mut rad) = ([Lanes([0.0; LANES]); 3], [Lanes([0.0; LANES]); 3]);
    for (lane, pose) in poses.iter().enumerate() {
        let rotation: Mat3 = rotation.each_ref().map(|row| row.each_ref().map(|number| number.0[lane]));
        let turn_rad = matrix::rotation_vector(&pose.rotation, &rotation);
        for k in 0..3 {
            m[k].0[lane] = pose.position_m[k] - flange_m[k].0[lane];
            rad[k].0[lane] = turn_rad[k];
        }
    }
    (m, rad)
}

#[cfg(test)]
mod tests {
    use super::super::dispatch::{Width, on};
    use super::*;

    #[test]
    fn the_sums_have_the_same_bits_on_vectors_of_every_width() {
        let robot = Robot::built_in("irb120").unwrap();
        let offsets =
            FrameOffsets(std::array::from_fn(|i| std::array::from_fn(|j| 1e-3 * ((7 * i + j) as f64).sin())));
        let measured: Vec<MeasuredPose> = (0..11)
            .map(|i| {
                let q_rad = std::array::from_fn(|j| ((5 * i + 2 * j) as f64).cos());
                MeasuredPose { q_rad, base_from_flange: Chain::nominal(&robot).forward(&q_rad) }
            })
            .collect();
        let eights: Vec<Eight> = measured.chunks(LANES).map(Eight::of).collect();
        let arm = Axes::of(&robot, &offsets);
        let zero = Lanes([0.0; LANES]);
        let of_width = |width| {
            let mut sums =
                LaneSums { products: [zero; PRODUCTS], right: [zero; UNKNOWNS], squares: [zero; 2] };
            on(width, AddAll { arm: &arm, eights: &eights, weights: [5e4, 1e4], sums: &mut sums });
            let all = sums.products.iter().chain(&sums.right).chain(&sums.squares);
            all.flat_map(|lanes| lanes.0).map(f64::to_bits).collect::<Vec<_>>()
        };
        let plain = of_width(Width::Portable);
        assert!(plain.iter().any(|bits| *bits != 0));
        Width::all().for_each(|width| assert!(of_width(width) == plain, "{width:?}"));
    }
}

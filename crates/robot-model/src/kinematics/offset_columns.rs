//! What the offsets of an arm's frames do to its flange, for eight measured poses side by side, and the sums of products of it that the
//! normal equations of a calibration are made of.

use super::chain::{Chain, FrameOffsets};
use super::dispatch::Kernel;
use super::lanes::{self, LANES, Lanes, Wide};
use super::matrix::{self, Mat3, Vec3, apply, cross, dot, mul, sub, transpose};
use super::steps::{Frames, Pose, Walk, sin_cos};

/// Six for each of six joints.
pub(super) const UNKNOWNS: usize = 36;

/// EightPoses measured poses side by side.
pub(super) struct EightPoses {
    pub(super) q_rad: [Lanes; 6],
    pub(super) pose: Pose<Lanes>,
    /// One; zero in lanes that hold no pose.
    pub(super) is_there: Lanes,
}

/// An arm, and along and about which axes its frames' offsets move them.
pub(super) struct Axes {
    chain: Chain,
    /// For each joint the axes of its three shifts, then of its three turns, in the turned frame before it.
    of_joints: [[Vec3; 6]; 6],
}

impl Axes {
    /// Of an arm that has these offsets already.
    pub(super) fn of(chain: Chain, offsets: &FrameOffsets) -> Self {
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

/// What offsets and residuals of eight poses do, in standard deviations.
pub(super) struct Columns {
    /// How far an offset's unit moves the flange, three shifts and three turns a joint.
    moves: [[Vec3<Lanes>; 6]; 6],
    /// How far the unit of a turn turns it.
    turns: [[Vec3<Lanes>; 3]; 6],
    /// What takes the flange to where it was measured.
    missing_m: Vec3<Lanes>,
    missing_rad: Vec3<Lanes>,
}

pub(super) struct AllColumns<'a> {
    pub(super) arm: &'a Axes,
    pub(super) eights: &'a [EightPoses],
    /// Of positions, 1/m, and of orientations, 1/rad.
    pub(super) weights: [f64; 2],
    pub(super) columns: &'a mut Vec<Columns>,
}

impl Kernel for AllColumns<'_> {
    /// Squares of the residuals of positions and orientations, a sum for each lane.
    type Output = [Lanes; 2];

    #[inline(always)]
    fn run<V: Wide>(self) -> [Lanes; 2] {
        let mut squares = [V::splat(0.0); 2];
        for eight in self.eights {
            let columns = columns_of::<V>(self.arm, eight, self.weights);
            let [m, rad] = [lanes::load::<V>(&columns.missing_m), lanes::load::<V>(&columns.missing_rad)];
            squares = [squares[0] + dot(&m, &m), squares[1] + dot(&rad, &rad)];
            self.columns.push(columns);
        }
        [squares[0].store(), squares[1].store()]
    }
}

#[inline(always)]
fn columns_of<V: Wide>(arm: &Axes, eight: &EightPoses, weights: [f64; 2]) -> Columns {
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
    let nothing = [Lanes([0.0; LANES]); 3];
    let (mut moves, mut turns) = ([[nothing; 6]; 6], [[nothing; 3]; 6]);
    for i in 0..6 {
        let lever_m = sub(&flange_m, &origins_m[i]);
        for k in 0..3 {
            moves[i][k] = lanes::store3(&matrix::scale(&axes[i][k], weight_m));
            moves[i][3 + k] = lanes::store3(&matrix::scale(&cross(&axes[i][3 + k], &lever_m), weight_m));
            turns[i][k] = lanes::store3(&matrix::scale(&axes[i][3 + k], weight_rad));
        }
    }
    let measured_m: Vec3<V> = lanes::load(&eight.pose.position_m);
    let missing_m = matrix::scale(&sub(&measured_m, &flange_m), weight_m);
    let missing_rad = matrix::scale(&turn_rad(&eight.pose.rotation, &at.0.rotation), weight_rad);
    Columns { moves, turns, missing_m: lanes::store3(&missing_m), missing_rad: lanes::store3(&missing_rad) }
}

/// The rotation vectors of `to fromᵀ`, radians: where all of them are small side by side, to the bits of one at a time.
#[inline(always)]
fn turn_rad<V: Wide>(to: &Mat3<Lanes>, from: &Mat3<V>) -> Vec3<V> {
    let (small, cosine) = matrix::small_rotation(&lanes::load_rows::<V>(to), from);
    let one = V::splat(1.0);
    let is_back = cosine.at_most(V::splat(0.0));
    let is_short = dot(&small, &small).at_most(V::splat(SMALL_ENOUGH));
    if !(is_back + (one - is_short)).any() {
        return small;
    }
    lanes::load(&turns_one_by_one(to, &lanes::store_rows(from)))
}

/// Squares up to the number before that of [`matrix::SMALL_RAD`].
const SMALL_ENOUGH: f64 = (matrix::SMALL_RAD * matrix::SMALL_RAD).next_down();

#[inline(never)]
fn turns_one_by_one(to: &Mat3<Lanes>, from: &Mat3<Lanes>) -> Vec3<Lanes> {
    let lane = |rows: &Mat3<Lanes>, k: usize| rows.map(|row| row.map(|number| number.0[k]));
    let mut turns_rad = [Lanes([0.0; LANES]); 3];
    for k in 0..LANES {
        let turn_rad = matrix::rotation_vector(&lane(to, k), &lane(from, k));
        (0..3).for_each(|axis| turns_rad[axis].0[k] = turn_rad[axis]);
    }
    turns_rad
}

/// Sums of products, one for each lane.
pub(super) struct LaneSums {
    /// Of the columns of joints i and j, j at most i, at `i (i + 1) / 2 + j`.
    pub(super) products: [[[Lanes; 6]; 6]; 21],
    /// Of each column with the residual.
    pub(super) right: [Lanes; UNKNOWNS],
}

impl LaneSums {
    pub(super) fn nothing() -> Box<Self> {
        let zero = Lanes([0.0; LANES]);
        Box::new(Self { products: [[[zero; 6]; 6]; 21], right: [zero; UNKNOWNS] })
    }

    /// Of columns `a` and `b`, `b` the same or one before.
    pub(super) fn product(&self, a: usize, b: usize) -> &Lanes {
        let (i, j) = (a / 6, b / 6);
        &self.products[i * (i + 1) / 2 + j][a % 6][b % 6]
    }
}

/// As many eights at a time as stay in the processor's second cache while all products are made of them.
const BLOCK: usize = 32;

pub(super) struct AllProducts<'a> {
    pub(super) eights: &'a [Columns],
    pub(super) sums: &'a mut LaneSums,
}

impl Kernel for AllProducts<'_> {
    type Output = ();

    #[inline(always)]
    fn run<V: Wide>(self) {
        for eights in self.eights.chunks(BLOCK) {
            let mut of_joints = self.sums.products.iter_mut();
            for i in 0..6 {
                for (j, sums) in (0..=i).zip(&mut of_joints) {
                    add_products::<V>(eights, [i, j], sums);
                }
                add_right::<V>(eights, i, &mut self.sums.right);
            }
        }
    }
}

/// Of all columns of two joints. Nine sums at a time stay in registers.
#[inline(always)]
fn add_products<V: Wide>(eights: &[Columns], [i, j]: [usize; 2], sums: &mut [[Lanes; 6]; 6]) {
    for [rows, columns] in [[0, 0], [0, 3], [3, 0], [3, 3]] {
        // Of one joint, a shift and a turn are the same as the turn and the shift.
        if i == j && rows < columns {
            continue;
        }
        let both_turn = rows + columns == 6;
        let mut nine = [[V::splat(0.0); 3]; 3];
        for r in 0..3 {
            for c in 0..3 {
                nine[r][c] = V::load(&sums[rows + r][columns + c]);
            }
        }
        for eight in eights {
            for (r, row) in nine.iter_mut().enumerate() {
                let of_row: Vec3<V> = lanes::load(&eight.moves[i][rows + r]);
                for (c, sum) in row.iter_mut().enumerate() {
                    let moved = dot(&of_row, &lanes::load(&eight.moves[j][columns + c]));
                    let product = if both_turn {
                        moved + dot(&lanes::load::<V>(&eight.turns[i][r]), &lanes::load(&eight.turns[j][c]))
                    } else {
                        moved
                    };
                    *sum = *sum + product;
                }
            }
        }
        for r in 0..3 {
            for c in 0..3 {
                sums[rows + r][columns + c] = nine[r][c].store();
            }
        }
    }
}

/// Of a joint's columns with the residuals.
#[inline(always)]
fn add_right<V: Wide>(eights: &[Columns], i: usize, right: &mut [Lanes; UNKNOWNS]) {
    for eight in eights {
        let missing_m: Vec3<V> = lanes::load(&eight.missing_m);
        let missing_rad: Vec3<V> = lanes::load(&eight.missing_rad);
        for k in 0..6 {
            let moved = dot(&lanes::load::<V>(&eight.moves[i][k]), &missing_m);
            let product = match k.checked_sub(3) {
                Some(turn) => moved + dot(&lanes::load::<V>(&eight.turns[i][turn]), &missing_rad),
                None => moved,
            };
            let sum = &mut right[6 * i + k];
            *sum = (V::load(sum) + product).store();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::chains::eight_poses;
    use super::super::dispatch::{Width, on};
    use super::*;
    use crate::robot::Robot;
    use nalgebra::Isometry3;

    #[test]
    fn the_sums_have_the_same_bits_on_vectors_of_every_width() {
        let robot = Robot::built_in("irb120").unwrap();
        let offsets =
            FrameOffsets(std::array::from_fn(|i| std::array::from_fn(|j| 1e-3 * ((7 * i + j) as f64).sin())));
        let nominal = Chain::nominal(&robot);
        let joints: Vec<[f64; 6]> =
            (0..11).map(|i| std::array::from_fn(|j| ((5 * i + 2 * j) as f64).cos())).collect();
        // One pose is far from where its joints say.
        let poses: Vec<Isometry3<f64>> =
            (0..11).map(|i| nominal.forward(&joints[if i == 9 { 3 } else { i }])).collect();
        let eight = |(joints, poses): (&[[f64; 6]], &[Isometry3<f64>])| EightPoses {
            q_rad: std::array::from_fn(|j| lanes::gather(joints, |q_rad| q_rad[j])),
            pose: eight_poses(poses),
            is_there: Lanes(std::array::from_fn(|k| if k < joints.len() { 1.0 } else { 0.0 })),
        };
        let eights: Vec<EightPoses> = joints.chunks(LANES).zip(poses.chunks(LANES)).map(eight).collect();
        let arm = Axes::of(Chain::with_offsets(&robot, &offsets), &offsets);
        let of_width = |width| {
            let (mut columns, mut sums) = (Vec::new(), LaneSums::nothing());
            let all = AllColumns { arm: &arm, eights: &eights, weights: [5e4, 1e4], columns: &mut columns };
            let squares = on(width, all);
            on(width, AllProducts { eights: &columns, sums: &mut sums });
            let all = sums.products.iter().flatten().flatten().chain(&sums.right).chain(&squares);
            all.flat_map(|lanes| lanes.0).map(f64::to_bits).collect::<Vec<_>>()
        };
        let plain = of_width(Width::Portable);
        assert!(plain.iter().any(|bits| *bits != 0));
        Width::all().for_each(|width| assert!(of_width(width) == plain, "{width:?}"));
    }
}

//! The grid that joint angles are written on: the decimals of a file, the counts of an encoder.

use measurements::Measurements;
use robot_model::robot::{Axis, Joints, SerialArm};
use robot_model::units::deg_from_rad;
use std::collections::BTreeSet;
use std::ops::Range;

/// Steps that joints come rounded to lie between these, degrees: finer ones are no fault, coarser ones are postures.
const STEPS_DEG: [f64; 2] = [0.01, 1.0];
/// Angles nearer to each other than this are one: what reading decimals, or radians, leaves, degrees.
const SAME_DEG: f64 = 1e-6;
/// Neighbours among the angles are at most so many steps apart, where a step is looked for between them.
const MOST_COUNTS: u32 = 12;
/// Decimals alone are one of the last, or a few where six leave no room for what reading them leaves.
const MOST_DECIMALS: f64 = 4.0;
/// Steps that a part of a file comes rounded to, degrees, the coarsest first.
const PART_STEPS_DEG: [f64; 5] = [0.5, 0.1, 0.05, 0.02, 0.01];
/// A part of a file has so many rows, and so has the rest.
const FEWEST_OF_PART: usize = 12;
/// Share of the rest's angles that lie on a part's step.
const MOST_ON_STEP: f64 = 0.4;
/// A joint that takes fewer angles, or each of them in more poses in the mean, is moved to postures unless most of its poses differ.
const FEWEST_ANGLES: usize = 12;
const MOST_POSES_AN_ANGLE: usize = 8;
/// So unlikely it must be that angles lie on multiples of a step by chance, nats.
const BY_CHANCE_NATS: f64 = -20.0;

/// Joints that are written on the multiples of one step.
pub(super) struct AngleGrid {
    pub(super) step_deg: f64,
    /// Their indices, counted from 0.
    pub(super) joints: Vec<usize>,
    /// The rows of the file in which they are, as indices; `None`: in all.
    pub(super) rows: Option<Range<usize>>,
}

impl AngleGrid {
    /// The coarsest step on which every joint stands, however many decimals it is written with and wherever its zero is; where there is
    /// none, the coarsest on which some do that take as many angles as no list of postures has.
    pub(super) fn of(measurements: &Measurements) -> Option<Self> {
        let rows = || measurements.rows.iter().filter(|row| row.reading.involves_arm());
        let kinds = measurements.joint_kinds.iter().enumerate();
        let turning: Vec<usize> = kinds.filter(|(_, kind)| !kind.slides()).map(|(j, _)| j).collect();
        // Repeats, and several targets, are rows of one pose.
        let poses: BTreeSet<Joints<u64>> = rows().map(|row| row.q_rad.map(f64::to_bits)).collect();
        let moves = |j: usize| {
            let angles: BTreeSet<u64> = rows().map(|row| row.q_rad[j].to_bits()).collect();
            2 * angles.len() > poses.len()
                || angles.len() >= FEWEST_ANGLES.max(poses.len() / MOST_POSES_AN_ANGLE)
        };
        let of_joint = |j: usize| JointAngles::of(rows().map(|row| deg_from_rad(row.q_rad[j])).collect());
        let own: Vec<(usize, JointAngles)> = turning.iter().map(|&j| (j, of_joint(j))).collect();
        let all = own.iter().fold(0.0, |step_deg, (_, own)| common_divisor(step_deg, own.step_deg));
        if let Some(step_deg) = rounding_step(all) {
            return Some(Self { step_deg, joints: turning, rows: None });
        }
        let own = || own.iter().filter(|(j, _)| moves(*j));
        let steps = own().filter_map(|(_, own)| Some((rounding_step(own.step_deg)?, own.step_deg)));
        let (coarsest, exact) = steps.reduce(|best, next| if next.0 > best.0 { next } else { best })?;
        let joints = own().filter(|(_, own)| own.stand_on(coarsest) || own.lie_on(exact));
        Some(Self { step_deg: coarsest, joints: joints.map(|(j, _)| *j).collect(), rows: None })
    }

    /// The coarsest step on which some joints stand from one row on, or up to one, and not in the rest of the file.
    pub(super) fn in_part(measurements: &Measurements) -> Option<Self> {
        let kinds = measurements.joint_kinds.iter().enumerate();
        let turning: Vec<usize> = kinds.filter(|(_, kind)| !kind.slides()).map(|(j, _)| j).collect();
        // A nest on the base has no joints.
        let of_arm: Vec<usize> =
            (0..measurements.rows.len()).filter(|&i| measurements.rows[i].reading.involves_arm()).collect();
        let angles_deg = |j: usize| -> Vec<f64> {
            of_arm.iter().map(|&i| deg_from_rad(measurements.rows[i].q_rad[j])).collect()
        };
        let columns: Vec<(usize, Vec<f64>)> = turning.into_iter().map(|j| (j, angles_deg(j))).collect();
        PART_STEPS_DEG.into_iter().find_map(|step_deg| {
            let parts = columns.iter().filter_map(|(j, angles)| Some((*j, part_on(angles, step_deg)?)));
            let parts: Vec<(usize, Range<usize>)> = parts.collect();
            let (_, rows) = parts.iter().max_by_key(|(_, rows)| rows.len())?.clone();
            let joints = parts.iter().filter(|(_, part)| (part.start == 0) == (rows.start == 0));
            let start = if rows.start == 0 { 0 } else { of_arm[rows.start] };
            let end = of_arm.get(rows.end).copied().unwrap_or(measurements.rows.len());
            Some(Self { step_deg, joints: joints.map(|(j, _)| *j).collect(), rows: Some(start..end) })
        })
    }

    pub(super) fn columns(&self, robot: &SerialArm) -> String {
        let all = robot.joints.iter().filter(|joint| !joint.kind.slides()).count();
        if self.joints.len() == all && all == robot.joints.len() {
            return robot.columns();
        }
        let columns: Vec<String> = self.joints.iter().map(|&j| robot.column(Axis::at(j))).collect();
        columns.join(", ")
    }
}

/// The rows from one on, or up to one, whose angles are multiples of `step_deg` and differ, where those of the others are none.
fn part_on(angles_deg: &[f64], step_deg: f64) -> Option<Range<usize>> {
    let n = angles_deg.len();
    let on_step = |angle_deg: &f64| (angle_deg / step_deg - (angle_deg / step_deg).round()).abs() < 1e-6;
    let first = angles_deg.iter().take_while(|angle_deg| on_step(angle_deg)).count();
    let last = n - angles_deg.iter().rev().take_while(|angle_deg| on_step(angle_deg)).count();
    [(0..first, first..n), (last..n, 0..last)].into_iter().find_map(|(part, rest)| {
        let angles = &angles_deg[part.clone()];
        let different: BTreeSet<u64> = angles.iter().map(|angle_deg| angle_deg.to_bits()).collect();
        let others = angles_deg[rest.clone()].iter().filter(|angle_deg| on_step(angle_deg)).count();
        let is_part = part.len() >= FEWEST_OF_PART
            && rest.len() >= FEWEST_OF_PART
            && 2 * different.len() > part.len().min(FEWEST_OF_PART)
            && (others as f64) < MOST_ON_STEP * rest.len() as f64;
        is_part.then_some(part)
    })
}

/// The angles of one joint, degrees.
struct JointAngles {
    angles_deg: Vec<f64>,
    /// The step that they stand on by themselves.
    step_deg: f64,
}

impl JointAngles {
    fn of(angles_deg: Vec<f64>) -> Self {
        let own_deg = common_step_deg(angles_deg.iter().copied());
        let step_deg = step_of_counts(angles_deg.clone(), own_deg).unwrap_or(own_deg);
        Self { angles_deg, step_deg }
    }

    /// Whether their own step is a multiple of `step_deg`.
    fn stand_on(&self, step_deg: f64) -> bool {
        common_divisor(step_deg, self.step_deg) > step_deg - SAME_DEG
    }

    /// Whether they lie on multiples of another joint's step.
    fn lie_on(&self, step_deg: f64) -> bool {
        last_decimal_deg(&self.angles_deg)
            .is_some_and(|written_deg| lie_on(&self.angles_deg, step_deg, written_deg))
    }
}

/// Whether angles lie on multiples of a step, as nearly as two angles and the step are told by what is written, and as no such angles do by
/// chance.
fn lie_on(angles_deg: &[f64], step_deg: f64, written_deg: f64) -> bool {
    let Some(first_deg) = angles_deg.first() else { return false };
    let off_deg = |apart_deg: f64| (apart_deg - step_deg * (apart_deg / step_deg).round()).abs();
    let near_deg = 2.02 * written_deg;
    angles_deg.iter().all(|angle_deg| off_deg(angle_deg - first_deg) < near_deg)
        && (2.0 * near_deg / step_deg).ln() * (angles_deg.len() as f64 - 3.0) < BY_CHANCE_NATS
}

/// The step of which the differences of all `angles_deg` are multiples; 0 of angles that are all the same.
fn common_step_deg(mut angles_deg: impl Iterator<Item = f64>) -> f64 {
    let first = angles_deg.next().unwrap_or(0.0);
    angles_deg.fold(0.0, |step_deg, angle_deg| common_divisor(step_deg, (angle_deg - first).abs()))
}

/// Euclid's algorithm on numbers that are known to [`SAME_DEG`]; the divisor of 0 and another number is that number.
fn common_divisor(a: f64, b: f64) -> f64 {
    let largest = a.max(b);
    let (mut a, mut b) = (a, b);
    while b > SAME_DEG {
        // The nearest multiple: a rest just under the divisor is none.
        (a, b) = (b, (a - b * (a / b).round()).abs());
    }
    // Rests have lost digits: the largest number tells the divisor best.
    if a > SAME_DEG { largest / (largest / a).round() } else { a }
}

/// The step of angles that are whole counts of an encoder, or decimals of a radian, written in degrees with so few decimals that nothing but the
/// last of them, `own_deg`, divides them: by what lies between neighbours, the nearest first, each of which tells the step more exactly.
fn step_of_counts(mut angles_deg: Vec<f64>, own_deg: f64) -> Option<f64> {
    // What stands on a step of its own beside the decimals is no rounding of another.
    let written_deg = last_decimal_deg(&angles_deg).filter(|decimal| own_deg < MOST_DECIMALS * decimal)?;
    let [finest_deg, coarsest_deg] = STEPS_DEG;
    sorting::numbers(&mut angles_deg);
    angles_deg.dedup_by(|a, b| (*a - *b).abs() < SAME_DEG);
    let first_deg = *angles_deg.first()?;
    let mut apart_deg: Vec<f64> = angles_deg.windows(2).map(|pair| pair[1] - pair[0]).collect();
    sorting::numbers(&mut apart_deg);
    let nearest_deg = *apart_deg.first()?;
    apart_deg.extend(angles_deg.iter().map(|angle_deg| angle_deg - first_deg).filter(|apart| *apart > 0.0));
    let tried = (1..=MOST_COUNTS).map(|counts| (counts, nearest_deg / f64::from(counts)));
    let in_range = tried.filter(|(_, step_deg)| (finest_deg..=coarsest_deg).contains(step_deg));
    in_range.map(|(counts, step_deg)| Counted { step_deg, counts: f64::from(counts), written_deg }).find_map(
        |start| {
            let counted = apart_deg.iter().try_fold(start, |counted, apart_deg| counted.with(*apart_deg))?;
            let step_deg = counted.step_of_an_encoder();
            lie_on(&angles_deg, step_deg, written_deg).then_some(step_deg)
        },
    )
}

/// A step, the largest number of steps that it was taken from, and what one angle is written to.
#[derive(Clone, Copy)]
struct Counted {
    step_deg: f64,
    counts: f64,
    written_deg: f64,
}

impl Counted {
    /// With two angles that lie so far apart; `None` where they lie between two numbers of steps.
    fn with(self, apart_deg: f64) -> Option<Self> {
        let Self { step_deg, counts: known, written_deg } = self;
        let counts = (apart_deg / step_deg).round();
        // Each of two angles is off by half of what it is written to, and so are those that the step is from.
        let allowed_deg = 1.01 * written_deg * (1.0 + counts / known);
        if (apart_deg - counts * step_deg).abs() > allowed_deg || allowed_deg > 0.5 * step_deg {
            return None;
        }
        let further = counts > known;
        Some(if further { Self { step_deg: apart_deg / counts, counts, ..self } } else { self })
    }

    /// That of the encoder, or of decimals of a radian, that it is, to the last digit.
    fn step_of_an_encoder(self) -> f64 {
        let encoders = (9..16).map(|bits| 360.0 / f64::from(1 << bits));
        let radians = [1e-2, 1e-3].map(deg_from_rad);
        let near = |step: &f64| (step - self.step_deg).abs() < self.written_deg / self.counts;
        encoders.chain(radians).find(near).unwrap_or(self.step_deg)
    }
}

/// The last decimal that angles are written with, of two to six; `None` of more.
fn last_decimal_deg(angles_deg: &[f64]) -> Option<f64> {
    let ends = |decimal: f64| {
        let rest = |angle_deg: &f64| (angle_deg / decimal - (angle_deg / decimal).round()).abs();
        angles_deg.iter().all(|angle_deg| rest(angle_deg) < 1e-4)
    };
    [1e-2, 1e-3, 1e-4, 1e-5, 1e-6].into_iter().find(|decimal| ends(*decimal))
}

/// The step that joints are rounded to whose angles are multiples of `common_deg`, to the last digit that counts: itself, or of a coarse one the
/// coarsest part that can be; `None` of a fine one, or of joints that stand still.
fn rounding_step(common_deg: f64) -> Option<f64> {
    let [finest, coarsest] = STEPS_DEG;
    let step_deg = common_deg / (common_deg / coarsest - SAME_DEG).ceil().max(1.0);
    let written = (step_deg / SAME_DEG).round() * SAME_DEG;
    (common_deg > SAME_DEG && step_deg > finest - SAME_DEG).then(|| (written * 1e6).round() / 1e6)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(cells: impl Fn(usize, usize) -> f64) -> Measurements {
        let mut text = "q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n".to_owned();
        for k in 0..40 {
            let row: Vec<String> = (0..6).map(|j| format!("{:.5}", cells(k, j))).collect();
            text.push_str(&format!("{},1,2,{k}\n", row.join(",")));
        }
        Measurements::from_csv(text.as_bytes()).unwrap()
    }

    /// Multiples all over a joint's range: of the fractions of the golden section's powers.
    fn multiple(k: usize, j: usize) -> f64 {
        ((1.0 + k as f64 * 0.618_034_f64.powi(j as i32 + 1)).fract() * 9000.0).round() - 4500.0
    }

    #[test]
    fn a_step_is_that_of_the_differences_wherever_its_zero_lies() {
        for (step, offset) in
            [(0.1, 0.0), (0.03, 0.0), (0.1, 0.037), (0.05, 0.01), (0.02, 0.0), (0.01, 0.0045)]
        {
            let grid = AngleGrid::of(&file(|k, j| multiple(k, j) * step + offset * (j + 1) as f64)).unwrap();
            assert_eq!((grid.step_deg, grid.joints.len()), (step, 6), "{step} from {offset} on");
        }
        assert!(AngleGrid::of(&file(|k, j| multiple(k, j) * 0.00317)).is_none(), "fine enough");
    }

    #[test]
    fn counts_of_an_encoder_are_seen_through_the_decimals_that_they_are_written_with() {
        // 12, 13 and 14 bits a turn, and three decimals of a radian.
        for step_deg in [360.0 / 4096.0, 360.0 / 8192.0, 360.0 / 16384.0, 0.18 / std::f64::consts::PI] {
            for decimal in [1e-3, 1e-4, 1e-5] {
                let written = |k: usize, j: usize| {
                    let anywhere = ((k as f64 + 1.0).powi(2) * 0.618_034_f64.powi(j as i32 + 1)).fract();
                    let angle_deg = ((180.0 * anywhere - 90.0) / step_deg).round() * step_deg;
                    (angle_deg / decimal).round() * decimal
                };
                let grid = AngleGrid::of(&file(written)).unwrap();
                assert!(
                    (grid.step_deg - step_deg).abs() < 1e-6,
                    "{step_deg} to {decimal}: {}",
                    grid.step_deg
                );
                assert_eq!(grid.joints.len(), 6);
            }
        }
        assert!(AngleGrid::of(&file(|k, j| multiple(k, j) * 0.0123)).is_some(), "a step of its own");
        let fine = |k: usize, j: usize| (multiple(k, j) * 0.00317 * 1000.0).round() / 1000.0;
        assert!(AngleGrid::of(&file(fine)).is_none(), "three decimals and nothing more");
    }

    #[test]
    fn joints_rounded_alone_are_told_from_those_that_are_not() {
        let grid = AngleGrid::of(&file(|k, j| multiple(k, j) * if j == 4 { 0.06 } else { 0.00317 })).unwrap();
        assert_eq!((grid.step_deg, grid.joints), (0.06, vec![4]));
    }

    /// Over a few degrees a rounded joint has few angles: 13 of 40 here; a joint that only stands at eight postures is none.
    #[test]
    fn a_joint_of_a_small_range_is_rounded_and_one_of_few_postures_is_not() {
        let one = |angles: usize| {
            AngleGrid::of(&file(move |k, j| {
                if j == 3 { ((7 * k) % angles) as f64 * 0.3 } else { multiple(k, j) * 0.00317 }
            }))
        };
        let grid = one(13).unwrap();
        assert_eq!((grid.step_deg, grid.joints), (0.3, vec![3]));
        assert!(one(8).is_none());
    }

    #[test]
    fn of_postures_the_step_is_a_part_of_theirs() {
        assert_eq!(rounding_step(5.0), Some(1.0));
        assert_eq!(rounding_step(1.5), Some(0.75));
        assert_eq!(rounding_step(0.0), None);
    }
}

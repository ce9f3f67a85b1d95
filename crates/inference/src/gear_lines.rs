//! Lines of one gear over the angles at which its joint stood: which of them are one and the same there. Knows nothing of evidence.

use crate::cause::Cause;
use crate::dataset::Dataset;
use robot_model::deform::EffectKind;
use robot_model::robot::Axis;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// Less than so many periods apart over all of a joint's range, two lines are one bend of about the same period, not two lines.
const ONE_BEND: f64 = 0.6;
/// Lines that are so alike at the angles measured differ between them by more than they do there.
const ALIKE: f64 = 0.9;

/// Whether lines of `n` and `m` periods per turn of `axis` are about the same over its whole range, measured angles or not.
#[must_use]
pub fn is_one_bend(dataset: &Dataset, axis: Axis, n: u32, m: u32) -> bool {
    is_one_bend_over(span_rad(dataset, axis), n, m)
}

fn is_one_bend_over(span_rad: f64, n: u32, m: u32) -> bool {
    f64::from(n.abs_diff(m)) * span_rad < ONE_BEND * TAU
}

/// Largest less smallest angle measured.
fn span_rad(dataset: &Dataset, axis: Axis) -> f64 {
    let angles = || dataset.of_arm().map(|o| o.q_rad[axis.index()]);
    angles().fold(f64::NEG_INFINITY, f64::max) - angles().fold(f64::INFINITY, f64::min)
}

/// What the measured angles q of each joint say of lines: |mean exp(i k q)| by order k and the span, each worked out once, for every line
/// is held against every other.
#[derive(Default)]
pub struct AngleSpectra {
    means: BTreeMap<(Axis, u32), f64>,
    spans_rad: BTreeMap<Axis, f64>,
}

impl AngleSpectra {
    /// How alike lines of `n` and `m` periods per turn of `axis` are at the measured angles q: 1 where they are the same numbers, as 8
    /// and 28 are on a grid of 10 deg (aliases), and about 0 where the angles part them. The larger of |mean exp(i (n - m) q)| and |mean exp(i (n + m) q)|.
    #[must_use]
    pub fn likeness(&mut self, dataset: &Dataset, axis: Axis, n: u32, m: u32) -> f64 {
        self.mean(dataset, axis, n.abs_diff(m)).max(self.mean(dataset, axis, n + m))
    }

    fn mean(&mut self, dataset: &Dataset, axis: Axis, order: u32) -> f64 {
        *self.means.entry((axis, order)).or_insert_with(|| {
            let [mut cos, mut sin] = [0.0; 2];
            let mut count = 0_usize;
            for observation in dataset.of_arm() {
                count += 1;
                let at = (f64::from(order) * observation.q_rad[axis.index()]).sin_cos();
                (sin, cos) = (sin + at.0, cos + at.1);
            }
            f64::hypot(sin, cos) / count.max(1) as f64
        })
    }

    /// Whether lines of `n` and `m` periods are nearly the same at the measured angles of `axis`, and not between them.
    #[must_use]
    pub fn are_aliases(&mut self, dataset: &Dataset, axis: Axis, n: u32, m: u32) -> bool {
        let span_rad = *self.spans_rad.entry(axis).or_insert_with(|| span_rad(dataset, axis));
        n != m && !is_one_bend_over(span_rad, n, m) && self.likeness(dataset, axis, n, m) > ALIKE
    }
}

/// The same of two lines alone.
#[must_use]
pub fn are_aliases(dataset: &Dataset, axis: Axis, n: u32, m: u32) -> bool {
    AngleSpectra::default().are_aliases(dataset, axis, n, m)
}

/// A line of a gear that may be any of several, which the angles measured do not tell apart.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AliasedLine {
    /// The joint whose gear it is.
    pub joint: Axis,
    /// Periods per turn, the likeliest first.
    pub periods: Vec<u32>,
    /// The place of the model in which they are alternatives.
    pub slot: usize,
}

/// The first line among `causes` that stands in one place with its aliases.
#[must_use]
pub fn aliased_line(dataset: &Dataset, causes: &[Cause]) -> Option<AliasedLine> {
    let line = |c: &Cause| c.joint.zip(c.n).filter(|_| is_of_gear(c.effect));
    causes.iter().find_map(|cause| {
        let (joint, n) = line(cause)?;
        let others = causes.iter().filter(|other| other.slot == cause.slot).filter_map(line);
        let aliases = others.filter(|&(of, m)| of == joint && are_aliases(dataset, joint, n, m));
        let periods: Vec<u32> = std::iter::once(n).chain(aliases.map(|(_, m)| m)).collect();
        (periods.len() > 1).then_some(AliasedLine { joint, periods, slot: cause.slot })
    })
}

/// Whether an effect is an error so many times per turn.
#[must_use]
pub fn is_of_gear(kind: EffectKind) -> bool {
    matches!(kind, EffectKind::GearEccentricity | EffectKind::GearSecondHarmonic | EffectKind::GearMesh)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dataset::evenly_spread;

    /// On a grid of 10 deg, 36 steps a turn, n periods are the same numbers as 36 - n and 36 + n; at other angles they are not.
    #[test]
    fn on_a_grid_of_angles_lines_of_other_periods_are_the_same_numbers() {
        let free = evenly_spread(80);
        let mut grid = free.clone();
        let step_rad = 10.0_f64.to_radians();
        for observation in &mut grid.observations {
            observation.q_rad[1] = (observation.q_rad[1] / step_rad).round() * step_rad;
        }
        let joint = Axis::at(1);
        let of = |dataset: &Dataset| -> Vec<u32> {
            (3..=100).filter(|&m| are_aliases(dataset, joint, 8, m)).collect()
        };
        assert_eq!(of(&grid), [28, 44, 64, 80, 100]);
        assert_eq!(of(&free), [0; 0]);
        assert!((AngleSpectra::default().likeness(&grid, joint, 8, 28) - 1.0).abs() < 1e-12);
    }

    /// Over a fifth of a turn 17 and 19 periods differ by 0.4 of one, 17 and 21 by 0.8.
    #[test]
    fn near_periods_over_a_short_range_are_one_bend() {
        let mut dataset = evenly_spread(40);
        for (i, observation) in dataset.observations.iter_mut().enumerate() {
            observation.q_rad[2] = TAU / 5.0 * i as f64 / 39.0;
        }
        assert!(is_one_bend(&dataset, Axis::at(2), 17, 19));
        assert!(!is_one_bend(&dataset, Axis::at(2), 17, 21));
    }
}

//! The instrument, or the target on the flange, that was elsewhere in a part of the rows.

use super::far_rows::{FarRows, PartFault, PosedRow};
use crate::rows::SAME_POSE;
use crate::{FreeParameters, Reading, Station, register_with};
use nalgebra::{Isometry3, Vector3};
use robot_model::robot::Joints;
use robot_model::units::{deg_from_rad, mm_from_m};
use statistics::median;
use std::ops::Range;

/// Fewer poses register no second stand of the instrument, of 6 unknowns.
const FEWEST_OF_STAND: usize = 6;
/// Share of the rows of a stand that are far off the registration of another.
const FAR_SHARE: f64 = 0.9;
/// A row that is near weighs so many that are far where the stretch of a stand is looked for.
const NEAR_IN_STRETCH: isize = 3;
/// What a stand's own registration leaves, as a share of what is far.
const OWN_SHARE: f64 = 0.5;
/// Rounds of re-weighting of a target's place.
const ROUNDS: usize = 8;

/// What was elsewhere, and what the rows' distances are in the middle once that is known, metres.
struct Elsewhere {
    what: PartFault,
    median_m: f64,
}

impl FarRows<'_> {
    /// The longest stretch of the file in which nearly all rows are far.
    pub(super) fn stretch(&self) -> Range<usize> {
        let (mut best, mut best_sum) = (0..0, 0);
        let (mut start, mut sum) = (0, 0);
        let mut far = self.far.iter().peekable();
        for i in 0..self.rows.len() {
            sum += if far.next_if(|next| **next == i).is_some() { 1 } else { -NEAR_IN_STRETCH };
            if sum <= 0 {
                (start, sum) = (i + 1, 0);
            } else if sum > best_sum {
                (best, best_sum) = (start..i + 1, sum);
            }
        }
        best
    }

    /// Rows of points in `stretch` that are nearly all far, the whole of it and then parts of it beside the near rows: there may be several
    /// stands in it.
    fn parts_of(&self, stretch: &Range<usize>) -> Vec<Vec<usize>> {
        // Of rows that are all far none says where the others stood.
        if stretch.len() == self.rows.len() {
            return Vec::new();
        }
        let is_point = |i: &usize| matches!(self.rows[*i].station.reading, Reading::Point { .. });
        let points: Vec<usize> = stretch.clone().filter(is_point).collect();
        let count = points.len();
        let part = |size: usize| match stretch.start {
            0 => points[count - size..].to_vec(),
            _ => points[..size].to_vec(),
        };
        let is_stand = |part: &Vec<usize>| {
            let far = part.iter().filter(|i| self.is_far(**i)).count();
            far as f64 >= FAR_SHARE * part.len() as f64 && self.has_poses(part)
        };
        let sizes = std::iter::successors(Some(count), |size| Some(size / 2));
        sizes.take_while(|size| *size >= FEWEST_OF_STAND).map(part).filter(is_stand).collect()
    }

    /// Whether enough poses are among these rows, some of which may repeat others.
    fn has_poses(&self, which: &[usize]) -> bool {
        let kinds = self.robot.kinds();
        let mut poses: Vec<&Joints> = Vec::new();
        for &i in which {
            let here = &self.rows[i].station.q_rad;
            let is_known = poses.iter().any(|q_rad| SAME_POSE.holds(&kinds, here, q_rad));
            if !is_known {
                poses.push(here);
            }
            if poses.len() >= FEWEST_OF_STAND {
                return true;
            }
        }
        false
    }

    /// In a stretch of the file the instrument, or the one target on the flange, is elsewhere: what fits better of the two.
    pub(super) fn elsewhere(&self, targets: usize) -> Option<PartFault> {
        let stretch = self.stretch();
        let whole = self.parts_of(&stretch).into_iter().next()?;
        let found = [self.moved(&stretch, &whole, targets), self.remounted(&stretch, &whole, targets)];
        let found = found.into_iter().flatten();
        found
            .reduce(|best, next| if next.median_m < best.median_m { next } else { best })
            .map(|found| found.what)
    }

    /// The same in a part of the stretch beside the near rows, where there is more than one stand in it.
    pub(super) fn moved_in_part(&self, targets: usize) -> Option<PartFault> {
        let stretch = self.stretch();
        let parts = self.parts_of(&stretch);
        parts.iter().find_map(|part| self.moved(&stretch, part, targets)).map(|found| found.what)
    }

    /// In the stretch, or all over the file but there, all is elsewhere, rigidly, as `part` of the stretch says.
    fn moved(&self, stretch: &Range<usize>, part: &[usize], targets: usize) -> Option<Elsewhere> {
        let tools = self.registration.tools_m.get(..targets)?;
        let stations: Vec<Station> = part.iter().map(|&i| self.rows[i].station.clone()).collect();
        let poses: Vec<Isometry3<f64>> = part.iter().map(|&i| self.rows[i].pose).collect();
        let second = register_with(&stations, &poses, tools, FreeParameters::Base)
            .ok()
            .filter(|fit| fit.median_m <= OWN_SHARE * self.limit_m)?;
        let there = self.registration.instrument_from_base * second.instrument_from_base.inverse();
        let what = match stretch.start {
            0 => PartFault::Moved { rows: stretch.end..self.rows.len(), first_from_second: there.inverse() },
            _ => PartFault::Moved { rows: stretch.clone(), first_from_second: there },
        };
        Some(Elsewhere { what, median_m: second.median_m })
    }

    /// In a stretch of the file the one target sits elsewhere on the flange.
    fn remounted(&self, stretch: &Range<usize>, part: &[usize], targets: usize) -> Option<Elsewhere> {
        let tool_m = *self.registration.tools_m.first().filter(|_| targets == 1)?;
        let seen: Vec<Vector3<f64>> =
            part.iter().map(|&i| self.on_flange_m(&self.rows[i])).collect::<Option<_>>()?;
        let there_m = middle(&seen);
        let mut off_m: Vec<f64> = seen.iter().map(|at_m| (at_m - there_m).norm()).collect();
        let median_m = median(&mut off_m);
        let near = off_m.iter().filter(|off_m| **off_m < self.limit_m).count();
        let fits = near as f64 >= FAR_SHARE * seen.len() as f64 && median_m <= OWN_SHARE * self.limit_m;
        let what = PartFault::Remounted { rows: stretch.clone(), by_m: (there_m - tool_m).norm() };
        fits.then_some(Elsewhere { what, median_m })
    }

    /// Where on the flange the point of `row` lies, metres.
    fn on_flange_m(&self, row: &PosedRow) -> Option<Vector3<f64>> {
        self.registration.seen_on_flange_m(&row.station, &row.pose)
    }
}

/// The middle of points, of which some may be false (Weiszfeld 1937).
fn middle(points_m: &[Vector3<f64>]) -> Vector3<f64> {
    let mut at_m = points_m.iter().sum::<Vector3<f64>>() / points_m.len().max(1) as f64;
    for _ in 0..ROUNDS {
        let weighed = points_m.iter().map(|point_m| (point_m, 1.0 / (point_m - at_m).norm().max(1e-6)));
        let (sum, weights) = weighed.fold((Vector3::zeros(), 0.0), |(sum, weights), (point_m, weight)| {
            (sum + point_m * weight, weights + weight)
        });
        at_m = sum / weights;
    }
    at_m
}

/// By how much the instrument has moved, in words; `to` is the last line where it has, unless that is the file's.
#[must_use]
pub fn describe_move(first_from_second: &Isometry3<f64>, from: u64, to: Option<u64>) -> String {
    let rows = to.map_or_else(|| format!("from line {from} on"), |to| format!("from line {from} to {to}"));
    format!(
        "{rows} the instrument stands elsewhere (its frame has moved by {:.0} mm and turned by {:.2} deg): the base is registered in each stand on its own",
        mm_from_m(first_from_second.translation.vector.norm()),
        deg_from_rad(first_from_second.rotation.angle())
    )
}

/// By how much the target sits elsewhere, in words; `lines` are the first and the last where it does.
#[must_use]
pub fn describe_remounting(by_m: f64, lines: [u64; 2]) -> String {
    let [first, last] = lines;
    format!(
        "in lines {first} to {last} the target sits {:.1} mm from where it sits in the others: it is taken as another target there",
        mm_from_m(by_m)
    )
}

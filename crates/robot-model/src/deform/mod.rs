//! How the model deforms with time, temperature, load and direction: deformation tables, growth laws, identified
//! models, and the arm that all of them together make at one moment.
//!
//! Knows nothing of RAPID.

mod arm;
mod effect_kind;
mod error;
pub mod gravity;
mod growth;
pub mod identified;
mod moments;
mod paper;
mod serial_arm;
mod table;
pub mod thermal_filter;
mod warm_up_law;
mod warmth;

pub use arm::{ArmDeviation, ArmUnder, Conditions, DeformedArm, Payload};
pub use effect_kind::{EffectKind, UnknownEffect};
pub use error::DeformError;
pub use growth::{GrowthError, GrowthLaw, TIMES_MIN};
pub use moments::DeformedArms;
pub use serial_arm::DeformedSerialArm;
pub use warm_up_law::FittedLaw;
pub use warmth::Warmth;

use crate::kinematics::FrameOffsets;

/// What a deformation depends on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TableIndex {
    /// Minutes of warm-up since cold.
    WarmUpTime,
    /// A temperature in degrees Celsius.
    Temperature,
}

/// How the frames of the constructive model move, by warm-up time or by temperature.
#[derive(Clone, Debug, PartialEq)]
pub struct Deformation(Tabulation);

#[derive(Clone, Debug, PartialEq)]
enum Tabulation {
    /// One table that grows with warm-up time.
    Static { offsets: FrameOffsets, growth: GrowthLaw },
    /// For each row of [`FrameOffsets`] its knots, index ascending; linear between, held outside.
    Scheduled { index: TableIndex, knots: [Vec<Knot>; 7] },
}

/// A row of offsets at one minute or temperature.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Knot {
    at: f64,
    offsets: [f64; 6],
}

impl Deformation {
    /// The reference paper's Table 2 on the IRB 140, growing as two equal lags of 46 minutes.
    #[must_use]
    pub fn paper() -> Self {
        Self::from_static(paper::table_2(), GrowthLaw::TwoStage { tau_min: 46.0 })
    }

    /// A table of settled offsets and how they grow there.
    #[must_use]
    pub fn from_static(offsets: FrameOffsets, growth: GrowthLaw) -> Self {
        Self(Tabulation::Static { offsets, growth })
    }

    /// The same where a static table's offsets, or those of every row, are so many times as large.
    #[must_use]
    pub fn scaled(&self, by: f64) -> Self {
        let times = |row: [f64; 6]| row.map(|value| value * by);
        Self(match &self.0 {
            Tabulation::Static { offsets, growth } => {
                Tabulation::Static { offsets: FrameOffsets(offsets.0.map(times)), growth: *growth }
            }
            Tabulation::Scheduled { index, knots } => {
                let knot = |k: &Knot| Knot { at: k.at, offsets: times(k.offsets) };
                let knots = knots.each_ref().map(|row| row.iter().map(knot).collect::<Vec<_>>());
                Tabulation::Scheduled { index: *index, knots }
            }
        })
    }

    /// What [`offsets_at`](Self::offsets_at) takes: minutes or degrees Celsius.
    #[must_use]
    pub fn index(&self) -> TableIndex {
        match &self.0 {
            Tabulation::Static { .. } => TableIndex::WarmUpTime,
            Tabulation::Scheduled { index, .. } => *index,
        }
    }

    /// For a table by temperature: its lowest and highest one, degrees Celsius, and the same table by degrees
    /// above the lowest, in place of minutes.
    #[must_use]
    pub fn above_lowest(&self) -> Option<([f64; 2], Self)> {
        let Tabulation::Scheduled { index: TableIndex::Temperature, knots } = &self.0 else { return None };
        let all = self.knots();
        let (low, high) = (*all.first()?, *all.last()?);
        let knots = knots.each_ref().map(|row| {
            row.iter().map(|knot| Knot { at: knot.at - low, offsets: knot.offsets }).collect::<Vec<_>>()
        });
        Some(([low, high], Self(Tabulation::Scheduled { index: TableIndex::WarmUpTime, knots })))
    }

    /// The offsets at a warm-up minute, or at a temperature in degrees Celsius where that is the
    /// [`index`](Self::index).
    #[must_use]
    pub fn offsets_at(&self, t_min: f64) -> FrameOffsets {
        match &self.0 {
            Tabulation::Static { offsets, growth } => {
                let grown = growth.at(t_min);
                FrameOffsets(offsets.0.map(|row| row.map(|value| value * grown)))
            }
            Tabulation::Scheduled { knots, .. } => {
                FrameOffsets(std::array::from_fn(|i| interpolated(&knots[i], t_min)))
            }
        }
    }

    /// The offsets after any length of warm-up; at the highest temperature of the table where that is the index.
    #[must_use]
    pub fn settled(&self) -> FrameOffsets {
        match &self.0 {
            Tabulation::Static { offsets, .. } => *offsets,
            Tabulation::Scheduled { .. } => self.offsets_at(f64::INFINITY),
        }
    }

    /// How a static table grows; `None` for a scheduled one.
    #[must_use]
    pub fn growth(&self) -> Option<&GrowthLaw> {
        match &self.0 {
            Tabulation::Static { growth, .. } => Some(growth),
            Tabulation::Scheduled { .. } => None,
        }
    }

    /// The first frame, counted from 1 as a table's column `joint` counts, whose rows by warm-up time begin after minute 0 and not with zeros, and that
    /// minute: before it the frame is held as it is there.
    #[must_use]
    pub fn late_start(&self) -> Option<(usize, f64)> {
        let Tabulation::Scheduled { index: TableIndex::WarmUpTime, knots } = &self.0 else { return None };
        let late = |row: &Vec<Knot>| {
            let first = row.first()?;
            (first.at > 0.0 && first.offsets.iter().any(|offset| *offset != 0.0)).then_some(first.at)
        };
        (1..).zip(knots).find_map(|(number, row)| Some((number, late(row)?)))
    }

    /// The joints, counted from 1, that lack the last of the times (or temperatures) that all others have, and have all before it, and which that
    /// is: the file seems to be cut off there. Number 7 is the tool, which a table need not have.
    #[must_use]
    pub fn cut_off(&self) -> Option<(Vec<usize>, f64)> {
        /// Fewer rows of a joint show no grid of times.
        const FEWEST: usize = 3;
        let Tabulation::Scheduled { knots, .. } = &self.0 else { return None };
        let longest = knots.iter().max_by_key(|knots| knots.len()).filter(|knots| knots.len() >= FEWEST)?;
        let (last, before) = longest.split_last()?;
        let has = |own: &[Knot], wanted: &[Knot]| {
            own.len() == wanted.len() && own.iter().zip(wanted).all(|(own, wanted)| own.at == wanted.at)
        };
        let there = || (1..).zip(knots).filter(|(_, own)| !own.is_empty());
        let short: Vec<usize> = there().filter(|(_, own)| has(own, before)).map(|(joint, _)| joint).collect();
        let is_grid = there().all(|(_, own)| has(own, longest) || has(own, before));
        (is_grid && !short.is_empty()).then_some((short, last.at))
    }

    /// The minutes (or temperatures) at which a scheduled table has a row, ascending; empty for a static one.
    #[must_use]
    pub fn knots(&self) -> Vec<f64> {
        let Tabulation::Scheduled { knots, .. } = &self.0 else { return Vec::new() };
        let mut all: Vec<f64> = knots.iter().flatten().map(|knot| knot.at).collect();
        sorting::numbers(&mut all);
        all.dedup();
        all
    }
}

/// Linear between knots, held before the first and after the last; zero without knots.
fn interpolated(knots: &[Knot], at: f64) -> [f64; 6] {
    let after = knots.partition_point(|knot| knot.at <= at);
    match (after.checked_sub(1).and_then(|i| knots.get(i)), knots.get(after)) {
        (Some(a), Some(b)) => {
            let share = (at - a.at) / (b.at - a.at);
            std::array::from_fn(|k| a.offsets[k] + (b.offsets[k] - a.offsets[k]) * share)
        }
        (Some(only), None) | (None, Some(only)) => only.offsets,
        (None, None) => [0.0; 6],
    }
}

//! Two files of one arm beside each other: what one of them records and the other does not, whether they are one file, and why poses of the
//! one have none in the other.

use super::pose_pairs::SAME_RAD;
use measurements::direction_columns;
use measurements::{MeasurementRow, Measurements};
use rapid_syntax::diagnostic::{Diagnostic, counted};
use robot_model::units::deg_from_rad;
use statistics::upper_median;
use std::collections::BTreeSet;

/// Poses so near in all joints were meant as one: read from the encoders in one file and commanded in the other, or rounded, radians.
const MEANT_RAD: f64 = 0.02;
/// The same readings in so large a part of the rows are no chance, nor rows that an instrument read twice.
const COPIED_SHARE: f64 = 0.5;

/// What a person should know of `after` beside `before`, whatever has changed.
#[must_use]
pub fn beside_each_other(before: &Measurements, after: &Measurements) -> Vec<Diagnostic> {
    same_readings(before, after).into_iter().chain(columns_of_one(before, after)).collect()
}

/// That rows of both files hold the same readings to the last digit.
fn same_readings(before: &Measurements, after: &Measurements) -> Option<Diagnostic> {
    let (same, all) = (copied_rows(before, after), of_arm(after).count());
    if !is_no_chance(same, all) {
        return None;
    }
    let text = if same == all && all == of_arm(before).count() {
        "the two files hold the same readings to the last digit: that nothing has changed says nothing of the arm".to_owned()
    } else {
        format!("{same} of {} after are readings from before to the last digit", counted(all, "row"))
    };
    Some(
        Diagnostic::warning("changed::same-readings", text)
            .help("was the one file given twice, or copied into the other?"),
    )
}

/// Whether what `after` reads was, for the most part, read `before`: nothing can be said of the arm then, as where two files are one.
pub(super) fn are_mostly_copies(before: &Measurements, after: &Measurements) -> bool {
    is_no_chance(copied_rows(before, after), of_arm(after).count())
}

fn is_no_chance(same: usize, all: usize) -> bool {
    same as f64 > COPIED_SHARE * all as f64
}

/// How many rows of `after` stand in `before` to the last digit.
fn copied_rows(before: &Measurements, after: &Measurements) -> usize {
    let of_before: BTreeSet<Vec<u64>> = before.rows.iter().filter_map(written).collect();
    after.rows.iter().filter_map(written).filter(|row| of_before.contains(row)).count()
}

/// The rows in which the arm has a pose: a nest on the base has none.
fn of_arm(file: &Measurements) -> impl Iterator<Item = &MeasurementRow> {
    file.rows.iter().filter(|row| row.reading.involves_arm())
}

/// Joints and point of a row, to the last digit; `None` of what is no point of the arm.
fn written(row: &MeasurementRow) -> Option<Vec<u64>> {
    let position_m = row.reading.position_m().filter(|_| row.reading.involves_arm())?;
    Some(row.q_rad.iter().chain(position_m.iter()).map(|value| value.to_bits()).collect())
}

/// Columns that one file has and the other has not: poses are paired without them.
fn columns_of_one(before: &Measurements, after: &Measurements) -> Option<Diagnostic> {
    let [was, is] = [before.channels, after.channels];
    let all = [("payload_kg", was.payload, is.payload), ("dir1, ...", was.direction, is.direction)];
    let only: Vec<String> = all
        .into_iter()
        .filter(|(_, was, is)| was != is)
        .map(|(name, was, _)| format!("{name} {} alone", if was { "before" } else { "after" }))
        .collect();
    (!only.is_empty()).then(|| {
        Diagnostic::warning(
            "changed::columns",
            format!(
                "one file records what the other does not ({}): poses are paired without it, and a load or a side of approach that was another \
                 one is taken for a change of the arm",
                only.join("; ")
            ),
        )
        .help("record the column both times, or make sure that it would be the same")
    })
}

/// Why so few poses of one file have one in the other, as half a sentence; `None` where nothing that is recorded keeps them apart.
#[must_use]
pub fn why_unpaired(before: &Measurements, after: &Measurements) -> Option<String> {
    let (fewer, other) =
        if of_arm(before).count() <= of_arm(after).count() { (before, after) } else { (after, before) };
    let pairs: Vec<(&MeasurementRow, &MeasurementRow)> =
        of_arm(fewer).filter_map(|row| Some((row, nearest(row, other)?))).collect();
    let apart_rad = |(a, b): &(&MeasurementRow, &MeasurementRow)| apart_rad(a, b);
    let same: Vec<_> = pairs.iter().filter(|pair| apart_rad(pair) < SAME_RAD).collect();
    if 2 * same.len() < pairs.len() {
        return joints_differ(&pairs.iter().map(apart_rad).collect::<Vec<f64>>());
    }
    let names = |file: &Measurements| {
        let named: Vec<&str> =
            file.targets.iter().map(String::as_str).filter(|name| !name.is_empty()).collect();
        if named.is_empty() { "no name".to_owned() } else { named.join(", ") }
    };
    if !before.targets.iter().any(|name| after.targets.contains(name)) {
        return Some(format!(
            "the joints go together and target does not: {} before, {} after",
            names(before),
            names(after)
        ));
    }
    let differ = |column: &str, is_other: fn(&MeasurementRow, &MeasurementRow) -> bool| {
        let count = same.iter().filter(|(a, b)| is_other(a, b)).count();
        (2 * count > same.len()).then(|| {
            format!(
                "the joints go together and {column} does not: it is another one in {}",
                counted(count, "row")
            )
        })
    };
    differ("payload_kg", |a, b| {
        a.payload_kg.is_some() && b.payload_kg.is_some() && a.payload_kg != b.payload_kg
    })
    .or_else(|| {
        let joints = same.first().map_or(0, |(a, _)| a.q_rad.len());
        differ(&direction_columns(joints), |a, b| {
            a.direction.is_some() && b.direction.is_some() && a.direction != b.direction
        })
    })
}

/// By how much the joint differs most that does.
fn apart_rad(a: &MeasurementRow, b: &MeasurementRow) -> f64 {
    a.q_rad.iter().zip(&b.q_rad).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

fn nearest<'a>(row: &MeasurementRow, file: &'a Measurements) -> Option<&'a MeasurementRow> {
    let is_as_long = |other: &&MeasurementRow| other.q_rad.iter().count() == row.q_rad.iter().count();
    let others = of_arm(file).filter(is_as_long);
    others.min_by(|a, b| apart_rad(row, a).total_cmp(&apart_rad(row, b)))
}

fn joints_differ(apart_rad: &[f64]) -> Option<String> {
    let middle_rad = upper_median(&mut apart_rad.to_vec())?;
    let by = format!("{:.3} deg", deg_from_rad(middle_rad));
    Some(if middle_rad < MEANT_RAD {
        format!(
            "their joints differ by {by} in the middle, {:.2} deg make one pose: read in one file and commanded, or rounded, in the other",
            deg_from_rad(SAME_RAD)
        )
    } else {
        format!(
            "no pose of one stands at the joints of a pose of the other: the nearest differ by {by} in the middle"
        )
    })
}

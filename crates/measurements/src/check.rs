//! Checks of the rows before any geometry: duplicates, order in time, joint ranges, number.

use super::codes::codes;
use super::copies::DistinctRows;
use super::fault::{Fault, FaultKind};
use super::rounded_points::rounded_points;
use super::rows::JointTolerance;
use super::time_unit::{TimedStop, time_unit};
use super::{MeasurementRow, Measurements};
use rapid_syntax::diagnostic::{Diagnostic, Severity, counted};
use robot_model::robot::{Axis, Joint, JointKind, Joints, SerialArm};
use std::collections::BTreeSet;
use std::f64::consts::TAU;
use std::ops::Range;

/// More rows than this say no more; a part of the poses is taken.
const MOST_ROWS: usize = 20_000;
/// Beyond a joint's range by more than this is no reading of this robot.
const RANGE_SLACK: JointTolerance = JointTolerance { rad: 0.02, m: 1e-3 };
/// A joint is written at most so many turns from where it is within its range.
const MOST_TURNS: i32 = 2;
/// Share of rows out of range from which on the whole file is doubted.
pub const OUT_OF_RANGE_SHARE: f64 = 0.1;
/// Share of directions that are not known, of which nobody would write so many beside 1 alone.
const UNKNOWN_SHARE: Range<f64> = 0.2..0.8;
/// Share of steps back from which on the time column is doubted.
const BACK_SHARE: f64 = 0.1;

/// More rows than this are not all measured in the same minute.
const FEWEST_AT_ONE_TIME: usize = 9;

/// What the rows alone say.
#[derive(Clone, Debug, Default)]
pub struct RowCheck {
    /// Rows to use, as indices.
    pub used: Vec<usize>,
    /// Rows that are left out because the robot cannot have their joints, as indices.
    pub out_of_range: Vec<usize>,
    /// Each row is a cycle of its own: poses that are commanded again and again.
    pub are_cycles: bool,
    /// Whether the time column can be trusted.
    pub time_usable: bool,
    /// What makes the whole file useless.
    pub fault: Option<Fault>,
    /// What a person should look at.
    pub warnings: Vec<Diagnostic>,
}

/// Checks the rows of `measurements` against each other and the robot's ranges.
#[must_use]
pub fn check_rows(measurements: &Measurements, robot: &SerialArm) -> RowCheck {
    let rows = &measurements.rows;
    let DistinctRows { used, copies } = DistinctRows::of(rows);
    let mut checked = checked(measurements, robot, used, copied_rows(&copies));
    if let Some(warning) = one_time(rows, &checked.used) {
        checked.time_usable = false;
        checked.warnings.push(warning);
    }
    checked.thin_out(rows);
    checked
}

/// As [`check_rows`], where each row is a cycle of its own: an instrument that reads in steps gives equal readings of one pose, and no
/// part of the poses says how the others perform.
#[must_use]
pub fn check_cycles(measurements: &Measurements, robot: &SerialArm) -> RowCheck {
    let rows = &measurements.rows;
    let all = (0..rows.len()).collect();
    let of_arm: Vec<MeasurementRow> = rows.iter().filter(|row| row.reading.involves_arm()).cloned().collect();
    let checked = checked(measurements, robot, all, equal_cycles(&DistinctRows::of(&of_arm).copies));
    RowCheck { are_cycles: true, ..checked }
}

/// The rows that `used` names without those that the robot cannot be at.
fn checked(
    measurements: &Measurements,
    robot: &SerialArm,
    used: Vec<usize>,
    equal_rows: Option<Diagnostic>,
) -> RowCheck {
    let rows = &measurements.rows;
    let mut checked = RowCheck { time_usable: true, ..RowCheck::default() };
    if measurements.joint_kinds != robot.kinds() {
        let reason = format!(
            "the file has {}, the joints of {} are {}: another robot, or a column that is missing or one too many",
            written_as(&measurements.joint_kinds),
            robot.name,
            robot.columns()
        );
        checked.fault = Some(Fault::of_all(FaultKind::JointColumns, None, reason));
        return checked;
    }
    (checked.used, checked.warnings) = (used, equal_rows.into_iter().collect());
    checked.leave_out_codes(measurements);
    checked.leave_out_of_range(rows, robot);
    checked.check_time_order(rows);
    let stops = checked.used.iter().filter_map(|&i| rows.get(i));
    checked.warnings.extend(time_unit(stops.filter_map(|row| {
        Some(TimedStop { t_min: row.t_min?, clock_min: row.clock_min()?, stand: row.pose })
    })));
    checked.warnings.extend(directions_without_back(rows));
    checked.warnings.extend(rounded_points(rows, &checked.used));
    checked
}

/// The joint columns of a file, as words.
fn written_as(kinds: &Joints<JointKind>) -> String {
    let all = kinds.iter().enumerate();
    let all: Vec<String> =
        all.map(|(j, kind)| format!("q{}_{}", j + 1, if kind.slides() { "mm" } else { "deg" })).collect();
    all.join(", ")
}

/// The first joint, counted from 0, that `robot` cannot have where `q_rad` says.
pub fn out_of_range(q_rad: &Joints, robot: &SerialArm) -> Option<usize> {
    robot.joints.iter().zip(q_rad).position(|(joint, q_rad)| !is_in_range(*q_rad, joint))
}

fn is_in_range(q_rad: f64, joint: &Joint) -> bool {
    let slack = RANGE_SLACK.of(joint.kind);
    joint.range_rad.is_none_or(|[low, high]| (low - slack..=high + slack).contains(&q_rad))
}

/// Whether each joint of `q_rad` is in its range, or would be some whole turns on or back: a range need not lie about 0.
fn is_whole_turns_off(q_rad: &Joints, robot: &SerialArm) -> bool {
    robot.joints.iter().zip(q_rad).all(|(joint, q_rad)| {
        let most = if joint.kind.slides() { 0 } else { MOST_TURNS };
        (-most..=most).any(|turns| is_in_range(q_rad + TAU * f64::from(turns), joint))
    })
}

/// Directions of which none is -1 though many are 0: 0 is "not known" here, elsewhere it is "back".
fn directions_without_back(rows: &[MeasurementRow]) -> Option<Diagnostic> {
    let signs =
        || rows.iter().filter_map(|row| row.direction.as_ref()).flat_map(|signs| signs.iter().copied());
    let (all, unknown) = (signs().count(), signs().filter(|sign| *sign == 0).count());
    let is_odd =
        signs().all(|sign| sign >= 0) && UNKNOWN_SHARE.contains(&(unknown as f64 / all.max(1) as f64));
    let joints = rows.first().map_or(0, |row| row.q_rad.len());
    is_odd.then(|| {
        Diagnostic::warning(
            "measure::directions",
            format!(
                "the columns dir1 to dir{joints} hold 0 and 1 and no -1: 0 says that a direction is not known"
            ),
        )
        .help("write -1 where a joint came from above; play shows by that alone")
    })
}

/// What is said of rows that are left out as copies.
pub(super) fn copied_rows(copies: &[u64]) -> Option<Diagnostic> {
    Some(
        Diagnostic::warning("measure::duplicates", repeated(copies)?)
            .help("they are left out: a copied row is no measurement and would make the noise look smaller"),
    )
}

/// What is said of rows that are equal and count.
fn equal_cycles(equal: &[u64]) -> Option<Diagnostic> {
    Some(
        Diagnostic::new(Severity::Note, "measure::equal-cycles", repeated(equal)?)
            .help("each counts as a cycle of its own: an instrument that reads in steps gives equal readings; remove rows that were copied"),
    )
}

fn repeated(lines: &[u64]) -> Option<String> {
    let (line, n) = (lines.first()?, lines.len());
    let verb = if n == 1 { "repeats" } else { "repeat" };
    Some(format!(
        "{} {verb} to the last digit what an earlier row says (first: line {line})",
        counted(n, "row")
    ))
}

impl RowCheck {
    /// Keeps a part of the arm's poses where the rows are more than say anything new, and all nests.
    fn thin_out(&mut self, rows: &[MeasurementRow]) {
        if self.used.len() <= MOST_ROWS {
            return;
        }
        let step = self.used.len().div_ceil(MOST_ROWS);
        let before = self.used.len();
        let of_arm = self.used.iter().filter_map(|&i| rows.get(i)).filter(|row| row.reading.involves_arm());
        let poses: BTreeSet<usize> = of_arm.map(|row| row.pose).collect();
        // Scattered: every n-th of poses that are visited in turn could be one side or one direction alone.
        let is_kept = |rank: usize| {
            ((rank as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 32).is_multiple_of(step as u64)
        };
        let kept: BTreeSet<usize> =
            poses.iter().enumerate().filter(|(rank, _)| is_kept(*rank)).map(|(_, pose)| *pose).collect();
        let counts = |row: &MeasurementRow| !row.reading.involves_arm() || kept.contains(&row.pose);
        self.used.retain(|&i| rows.get(i).is_some_and(counts));
        if self.used.len() < before {
            let evaluated = format!(
                "of {before} rows {} are evaluated: {} of {}",
                self.used.len(),
                kept.len(),
                poses.len()
            );
            self.warnings.push(Diagnostic::warning("measure::many-rows", evaluated + " poses"));
        }
    }

    /// Leaves out rows that hold a code where the instrument had no reading.
    fn leave_out_codes(&mut self, measurements: &Measurements) {
        let (coded, warnings) = codes(&measurements.rows, &self.used, &measurements.joint_kinds);
        self.used.retain(|i| !coded.contains(i));
        self.warnings.extend(warnings);
    }

    /// Leaves out rows with joints that the robot cannot take; where they are many, the file is at fault.
    fn leave_out_of_range(&mut self, rows: &[MeasurementRow], robot: &SerialArm) {
        let beyond = |row: &MeasurementRow| out_of_range(&row.q_rad, robot);
        let out: Vec<(usize, usize)> = self
            .used
            .iter()
            .filter_map(|&i| {
                rows.get(i).filter(|row| row.reading.involves_arm()).and_then(beyond).map(|j| (i, j))
            })
            .collect();
        let Some(&(row, joint)) = out.first() else { return };
        let (line, q) = rows.get(row).map_or((0, 0.0), |r| (r.line, robot.in_deg_or_mm(&r.q_rad)[joint]));
        let unit = if robot.joints[joint].kind.slides() { "mm" } else { "deg" };
        let what = format!(
            "{} of {} rows have a joint outside the robot's range (first: line {line}, joint {} at {q:.2} {unit})",
            out.len(),
            self.used.len(),
            Axis::at(joint)
        );
        let whole_turns =
            out.iter().filter_map(|(i, _)| rows.get(*i)).all(|row| is_whole_turns_off(&row.q_rad, robot));
        if out.len() as f64 > OUT_OF_RANGE_SHARE * self.used.len() as f64 {
            let columns: BTreeSet<usize> = out.iter().map(|(_, joint)| *joint).collect();
            let columns: Vec<String> =
                columns.into_iter().map(|joint| robot.column(Axis::at(joint))).collect();
            let lines = out.iter().filter_map(|(i, _)| rows.get(*i)).map(|row| row.line).collect();
            self.fault = Some(Fault::in_rows(
                FaultKind::JointsOutOfRange,
                &columns.join(", "),
                lines,
                |_, _| match whole_turns {
                    true => format!(
                        "{what}: a whole turn on or back all of them are in it; write them as the controller does, between its ends"
                    ),
                    false => format!(
                        "{what}: another robot, another joint convention, or columns in another order"
                    ),
                },
            ));
            return;
        }
        self.out_of_range = out.iter().map(|(i, _)| *i).collect();
        let dropped: BTreeSet<usize> = self.out_of_range.iter().copied().collect();
        self.used.retain(|i| !dropped.contains(i));
        self.warnings.push(
            Diagnostic::warning("measure::joint-range", what)
                .help("these rows are left out; check their joints"),
        );
    }

    /// Warns of stamps that run back and of sessions one after the other, and decides whether the stamps count: not where what warms says that the
    /// order of the rows is right and they are not. The rows stay in the file's order.
    fn check_time_order(&mut self, rows: &[MeasurementRow]) {
        let stamped: Vec<(usize, f64)> = self
            .used
            .iter()
            .filter_map(|&i| rows.get(i).and_then(MeasurementRow::clock_min).map(|clock_min| (i, clock_min)))
            .collect();
        self.warnings.extend(sessions(self.used.iter().filter_map(|&i| rows.get(i))));
        let back: Vec<u64> = stamped
            .windows(2)
            .filter(|pair| pair[1].1 < pair[0].1 - 1e-9)
            .filter_map(|pair| rows.get(pair[1].0))
            .map(|row| row.line)
            .collect();
        let Some(line) = back.first() else { return };
        if back.len() as f64 <= BACK_SHARE * stamped.len() as f64 {
            self.warnings.push(
                Diagnostic::warning(
                    "measure::time-step-back",
                    format!("t_min steps back at {} (first: line {line})", counted(back.len(), "row")),
                )
                .help("check the clock; the stamps are used as they stand"),
            );
            return;
        }
        let mut sorted = stamped.clone();
        sorting::by(&mut sorted, |a, b| a.1.total_cmp(&b.1));
        let shuffled = format!(
            "t_min runs back at {} of {} rows: the rows are not in order of time",
            back.len(),
            stamped.len()
        );
        let roughness = |order: &[(usize, f64)]| {
            let warmth: Option<Vec<f64>> = order
                .iter()
                .map(|(i, _)| {
                    rows.get(*i).and_then(|row| row.joint_temperature_c).map(|t| t.iter().sum::<f64>())
                })
                .collect();
            warmth.map(|warmth| warmth.windows(2).map(|pair| (pair[1] - pair[0]).powi(2)).sum::<f64>())
        };
        let wrong = roughness(&stamped)
            .zip(roughness(&sorted))
            .is_some_and(|(as_read, by_stamp)| 2.0 * as_read < by_stamp);
        let warning = Diagnostic::warning("measure::time-order", shuffled);
        self.warnings.push(if wrong {
        self.time_usable = false;
        warning.help("joint temperatures change smoothly from row to row but not by t_min: the column t_min is not used, the order of the rows is")
    } else {
        warning.help("they are taken in the order of t_min; where the stamps are wrong, leave the column out")
    });
    }
}

/// That all rows are of one minute, which tells no time.
fn one_time(rows: &[MeasurementRow], used: &[usize]) -> Option<Diagnostic> {
    let mut clocks_min = used.iter().filter_map(|&i| rows.get(i)?.clock_min());
    let first = clocks_min.next()?;
    let count = 1 + clocks_min.clone().count();
    if count <= FEWEST_AT_ONE_TIME || clocks_min.any(|clock_min| clock_min != first) {
        return None;
    }
    let rows = counted(count, "row");
    let text = format!("t_min is {first} in all {rows}: it tells no time and is not used");
    Some(
        Diagnostic::warning("measure::one-time", text)
            .help("write the minute of each row, or leave the column out"),
    )
}

/// That minutes begin anew in the file.
fn sessions<'a>(rows: impl Iterator<Item = &'a MeasurementRow> + Clone) -> Option<Diagnostic> {
    let firsts = rows.clone().zip(rows.skip(1)).filter(|(before, row)| before.earlier_min != row.earlier_min);
    let lines: Vec<String> = firsts.map(|(_, row)| row.line.to_string()).collect();
    (!lines.is_empty()).then(|| {
        let text = format!("t_min begins anew at line {}: sessions one after the other", lines.join(", "));
        Diagnostic::warning("measure::cold-starts", text).help(
            "steps go by the order of rows, drifts by the minutes since each cold start; where it was one measurement, sort the rows by t_min",
        )
    })
}

#[cfg(test)]
mod tests;

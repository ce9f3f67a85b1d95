//! Checks of the rows before any geometry: duplicates, order in time, joint ranges, number.

use super::codes::codes;
use super::fault::{Fault, FaultKind};
use super::{MeasurementRow, Measurements};
use rapid_syntax::diagnostic::{Diagnostic, Severity, counted};
use robot_model::robot::{Axis, JointKind, Joints, SerialArm};
use std::collections::BTreeSet;
use std::f64::consts::TAU;
use std::ops::Range;

/// More rows than this say no more; a part of the poses is taken.
const MOST_ROWS: usize = 20_000;
/// Beyond a joint's range by more than this is no reading of this robot, radians.
const RANGE_SLACK_RAD: f64 = 0.02;
/// Share of rows out of range from which on the whole file is doubted.
pub const OUT_OF_RANGE_SHARE: f64 = 0.1;
/// Share of directions that are not known, of which nobody would write so many beside 1 alone.
const UNKNOWN_SHARE: Range<f64> = 0.2..0.8;
/// Share of steps back from which on the time column is doubted.
const BACK_SHARE: f64 = 0.1;

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
    let DistinctRows { used, copies } = distinct(rows);
    let mut checked = checked(measurements, robot, used, copied_rows(&copies));
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
    let checked = checked(measurements, robot, all, equal_cycles(&distinct(&of_arm).copies));
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
    checked.leave_out_codes(rows);
    checked.leave_out_of_range(rows, robot);
    checked.check_time_order(rows);
    checked.warnings.extend(directions_without_back(rows));
    checked
}

/// The joint columns of a file, as words.
fn written_as(kinds: &Joints<JointKind>) -> String {
    let all = kinds.iter().enumerate();
    let all: Vec<String> =
        all.map(|(j, kind)| format!("q{}_{}", j + 1, if kind.slides() { "mm" } else { "deg" })).collect();
    all.join(", ")
}

/// Rows by whether an earlier one says the same to the last digit.
struct DistinctRows {
    /// Indices of the rows that say something else.
    used: Vec<usize>,
    /// Lines of the others.
    copies: Vec<u64>,
}

fn distinct(rows: &[MeasurementRow]) -> DistinctRows {
    let mut seen = BTreeSet::new();
    let mut found = DistinctRows { used: Vec::with_capacity(rows.len()), copies: Vec::new() };
    for (index, row) in rows.iter().enumerate() {
        if seen.insert(recorded(row)) {
            found.used.push(index);
        } else {
            found.copies.push(row.line);
        }
    }
    found
}

/// All that a row records but its names, to the last digit.
fn recorded(row: &MeasurementRow) -> Vec<u64> {
    let coordinates_m = row.reading.coordinates().map(|read| read.value_m).unwrap_or_default();
    let mut key: Vec<u64> = row.q_rad.iter().chain(coordinates_m.iter()).map(|v| v.to_bits()).collect();
    key.push(row.reading.fixed_point().map_or(u64::MAX, |fixed_point| fixed_point as u64));
    key.push(u64::from(row.reading.involves_arm()));
    key.push(row.t_min.map_or(0, f64::to_bits));
    key.push(row.payload_kg.map_or(0, f64::to_bits));
    key.push(row.target as u64);
    // Each of these is recorded in all rows of a file or in none.
    key.extend(row.orientation.iter().flat_map(|turn| turn.coords.iter().map(|v| v.to_bits())));
    key.extend(row.direction.iter().flat_map(|signs| signs.iter().map(|sign| u64::from(*sign as u8))));
    key.extend(row.joint_temperature_c.iter().flat_map(|all| all.iter().map(|v| v.to_bits())));
    key
}

/// The first joint, counted from 0, that `robot` cannot have where `q_rad` says.
pub fn out_of_range(q_rad: &Joints, robot: &SerialArm) -> Option<usize> {
    robot.joints.iter().zip(q_rad).position(|(joint, q_rad)| {
        joint
            .range_rad
            .is_some_and(|[low, high]| *q_rad < low - RANGE_SLACK_RAD || *q_rad > high + RANGE_SLACK_RAD)
    })
}

/// `row` with each joint that turns a whole turn back where that takes it nearer to 0.
fn less_whole_turns(row: &MeasurementRow, robot: &SerialArm) -> MeasurementRow {
    let mut less = row.clone();
    for (q_rad, joint) in less.q_rad.iter_mut().zip(&robot.joints).filter(|(_, joint)| !joint.kind.slides()) {
        let is_beyond = joint.range_rad.is_some_and(|[low, high]| *q_rad < low || *q_rad > high);
        if is_beyond {
            *q_rad -= TAU * (*q_rad / TAU).round();
        }
    }
    less
}

/// Directions of which none is -1 though many are 0: 0 is "not known" here, elsewhere it is "back".
fn directions_without_back(rows: &[MeasurementRow]) -> Option<Diagnostic> {
    let signs =
        || rows.iter().filter_map(|row| row.direction.as_ref()).flat_map(|signs| signs.iter().copied());
    let (all, unknown) = (signs().count(), signs().filter(|sign| *sign == 0).count());
    let is_odd =
        signs().all(|sign| sign >= 0) && UNKNOWN_SHARE.contains(&(unknown as f64 / all.max(1) as f64));
    is_odd.then(|| {
        Diagnostic::warning(
            "measure::directions",
            "the columns dir1 to dir6 hold 0 and 1 and no -1: 0 says that a direction is not known",
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
    /// Keeps a part of the poses where the rows are more than say anything new.
    fn thin_out(&mut self, rows: &[MeasurementRow]) {
        if self.used.len() <= MOST_ROWS {
            return;
        }
        let step = self.used.len().div_ceil(MOST_ROWS);
        let before = self.used.len();
        // Scattered: every n-th of poses that are visited in turn could be one side or one direction alone.
        let scattered = |pose: usize| (pose as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 32;
        self.used.retain(|&i| rows.get(i).is_some_and(|row| scattered(row.pose) % step as u64 == 0));
        self.warnings.push(Diagnostic::warning(
            "measure::many-rows",
            format!("of {before} rows {} are evaluated: one pose in {step}", self.used.len()),
        ));
    }

    /// Leaves out rows that hold a code where the instrument had no reading.
    fn leave_out_codes(&mut self, rows: &[MeasurementRow]) {
        let (coded, warnings) = codes(rows, &self.used);
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
        let whole_turns = out
            .iter()
            .filter_map(|(i, _)| rows.get(*i))
            .all(|row| beyond(&less_whole_turns(row, robot)).is_none());
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
                        "{what}: less a whole turn all of them are in it; write them as the controller does, between its ends"
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

    /// Rows out of order are sorted by their stamps, unless what warms says that the rows are right and the stamps are not.
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
        sorted.sort_by(|a, b| a.1.total_cmp(&b.1));
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
mod tests {
    use super::*;

    fn file(rows: &[(f64, f64, f64)]) -> Measurements {
        let mut text = "t_min,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n".to_owned();
        for (t_min, q2_deg, x_mm) in rows {
            text.push_str(&format!("{t_min},0,{q2_deg},0,0,0,0,{x_mm},0,0\n"));
        }
        Measurements::from_csv(text.as_bytes()).unwrap()
    }

    fn codes(checked: &RowCheck) -> Vec<&'static str> {
        checked.warnings.iter().map(|w| w.code).collect()
    }

    #[test]
    fn one_step_back_is_a_warning_and_shuffled_time_is_not_used() {
        let robot = SerialArm::built_in("irb140").unwrap();
        let mut rows: Vec<(f64, f64, f64)> = (0..20).map(|i| (f64::from(i), 0.0, f64::from(i))).collect();
        rows[10].0 = 5.5;
        let checked = check_rows(&file(&rows), &robot);
        assert_eq!(codes(&checked), ["measure::time-step-back"]);
        assert!(checked.time_usable);
        for (i, row) in rows.iter_mut().enumerate() {
            row.0 = ((i * 7) % 20) as f64;
        }
        let checked = check_rows(&file(&rows), &robot);
        assert_eq!(codes(&checked), ["measure::time-order"]);
        assert!(checked.time_usable, "sorted");
    }

    /// 20 poses a degree and a millimetre apart: three of -9999 are a code; two are false readings, what lies among the others is a
    /// coordinate, and at one pose the same is a repeat.
    #[test]
    fn a_number_far_out_that_poses_share_is_a_code() {
        let robot = SerialArm::built_in("irb140").unwrap();
        let poses: Vec<(f64, f64, f64)> = (0..20).map(f64::from).map(|i| (i, i, i)).collect();
        let checked_with = |changed: &[(usize, f64, f64)]| {
            let mut rows = poses.clone();
            for (row, q2_deg, x_mm) in changed {
                (rows[*row].1, rows[*row].2) = (*q2_deg, *x_mm);
            }
            check_rows(&file(&rows), &robot)
        };
        let coded = checked_with(&[(2, 2.0, -9999.0), (9, 9.0, -9999.0), (19, 19.0, -9999.0)]);
        assert_eq!(codes(&coded), ["measure::code-for-none"]);
        assert_eq!(coded.used, (0..19).filter(|i| ![2, 9].contains(i)).collect::<Vec<_>>());
        assert!(
            coded.warnings[0].message.contains("x_mm is -9999 to the last digit in 3 rows: lines 4, 11, 21")
        );
        for kept in [
            [(2, 2.0, -9999.0), (9, 9.0, -9999.0), (19, 19.0, 19.0)],
            [(2, 2.0, 25.0), (9, 9.0, 25.0), (19, 19.0, 25.0)],
            [(2, 2.0, -9999.0), (9, 2.0, -9999.0), (19, 2.0, -9999.0)],
        ] {
            let checked = checked_with(&kept);
            assert_eq!((checked.used.len(), codes(&checked)), (20, vec![]), "{kept:?}");
        }
    }

    /// 200 and 340 deg are -160 and -20 deg less a turn, of which the second alone is in the 110 deg of the irb140's joint 2.
    #[test]
    fn joints_a_whole_turn_out_of_range_are_told_as_that() {
        let robot = SerialArm::built_in("irb140").unwrap();
        let reason = |q2_deg: f64| {
            let rows: Vec<(f64, f64, f64)> = (0..20).map(|i| (f64::from(i), q2_deg, f64::from(i))).collect();
            check_rows(&file(&rows), &robot).fault.unwrap().reason
        };
        assert!(reason(340.0).contains("less a whole turn"), "{}", reason(340.0));
        assert!(reason(200.0).contains("another robot"), "{}", reason(200.0));
    }

    #[test]
    fn copies_and_joints_out_of_range_are_left_out_and_many_of_those_are_a_fault() {
        let robot = SerialArm::built_in("irb140").unwrap();
        let mut rows: Vec<(f64, f64, f64)> = (0..20).map(|i| (f64::from(i), 0.0, f64::from(i))).collect();
        rows.push(rows[3]);
        rows[8].1 = 170.0;
        let checked = check_rows(&file(&rows), &robot);
        assert!(codes(&checked).contains(&"measure::duplicates"));
        assert!(codes(&checked).contains(&"measure::joint-range"));
        assert_eq!(checked.used.len(), 19);
        for row in &mut rows {
            row.1 = 170.0;
        }
        let fault = check_rows(&file(&rows), &robot).fault.unwrap();
        assert_eq!(fault.kind, FaultKind::JointsOutOfRange);
    }

    /// One point three times: with another quaternion, and from the other side with the first one's.
    #[test]
    fn rows_of_another_orientation_or_direction_are_no_copies() {
        let robot = SerialArm::built_in("irb140").unwrap();
        let header = "q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm,qw,qx,qy,qz,dir1,dir2,dir3,dir4,dir5,dir6";
        let at = "0,0,0,0,0,0,500,0,600";
        let text = format!(
            "{header}\n{at},1,0,0,0,1,1,1,1,1,1\n{at},0.8,0.6,0,0,1,1,1,1,1,1\n{at},1,0,0,0,-1,1,1,1,1,1\n"
        );
        let checked = check_rows(&Measurements::from_csv(text.as_bytes()).unwrap(), &robot);
        assert_eq!((codes(&checked), checked.used), (vec![], vec![0, 1, 2]));
    }

    /// 24,000 cycles of three poses, all of a pose equal: none is left out.
    #[test]
    fn each_row_is_a_cycle_however_many_and_equal_they_are() {
        let robot = SerialArm::built_in("irb140").unwrap();
        let rows: Vec<(f64, f64, f64)> =
            (0..24_000).map(|i| (0.0, f64::from(i % 3), f64::from(i % 3))).collect();
        let checked = check_cycles(&file(&rows), &robot);
        assert_eq!((checked.used.len(), codes(&checked)), (24_000, vec!["measure::equal-cycles"]));
    }
}

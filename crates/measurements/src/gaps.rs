//! Empty cells of columns that a file need not have: their rows are left out, or, where most are empty, the column.

use super::column_names::{FIXED, QUATERNION, TEMPERATURES};
use super::row_cells::ColumnIndex;
use super::{Channels, MeasurementRow, Reading};
use rapid_syntax::diagnostic::{Diagnostic, counted, first_few, is_or_are, plural};
use robot_model::robot::Joints;
use std::collections::BTreeMap;

/// Lines that a warning lists at most.
pub(super) const MOST_LINES: usize = 8;
/// With more than this share of its cells empty a column counts as absent.
const MOSTLY_EMPTY: f64 = 0.5;

/// Lines, by the column that is empty there.
pub(super) type EmptyCells = BTreeMap<&'static str, Vec<u64>>;

/// What is recorded beside points and joints, in one column or in several that count together.
struct Quantity<'a> {
    names: &'a [&'static str],
    is_needed: fn(&MeasurementRow) -> bool,
    is_there: fn(&MeasurementRow) -> bool,
}

/// Which optional quantities the file has. A row in which one of them is empty is taken out of `rows`; one that most rows lack is
/// absent. Either is told in `warnings`.
pub(super) fn complete_channels(
    columns: &ColumnIndex,
    rows: &mut Vec<MeasurementRow>,
    empty: &EmptyCells,
    warnings: &mut Vec<Diagnostic>,
) -> Channels {
    let any = |_: &MeasurementRow| true;
    let arm = |row: &MeasurementRow| row.reading.involves_arm();
    let point = |row: &MeasurementRow| matches!(row.reading, Reading::Point { .. });
    let has_points = rows.iter().any(point);
    let mut keep = |names: &[&'static str], is_needed, is_there| {
        columns.has(names.first().copied().unwrap_or_default())
            && Quantity { names, is_needed, is_there }.keep(rows, empty, warnings)
    };
    let channels = Channels {
        pose_id: false,
        time: keep(&["t_min"], any, |r| r.t_min.is_some()),
        orientation: has_points && keep(&QUATERNION, point, |r| r.orientation.is_some()),
        direction: keep(columns.directions, arm, |r| r.direction.is_some()),
        payload: keep(&["payload_kg"], arm, |r| r.payload_kg.is_some()),
        joint_temperature: keep(columns.temperatures, arm, |r| r.joint_temperature_c.is_some()),
    };
    for row in rows.iter_mut() {
        row.t_min = row.t_min.filter(|_| channels.time);
        row.orientation = row.orientation.filter(|_| channels.orientation);
        row.direction = row.direction.filter(|_| channels.direction);
        row.payload_kg = row.payload_kg.filter(|_| channels.payload);
        row.joint_temperature_c = row.joint_temperature_c.filter(|_| channels.joint_temperature);
    }
    channels
}

impl Quantity<'_> {
    /// Whether the rows that are left all have it.
    fn keep(
        &self,
        rows: &mut Vec<MeasurementRow>,
        empty: &EmptyCells,
        warnings: &mut Vec<Diagnostic>,
    ) -> bool {
        let lacks = |row: &MeasurementRow| (self.is_needed)(row) && !(self.is_there)(row);
        let without: Vec<u64> = rows.iter().filter(|row| lacks(row)).map(|row| row.line).collect();
        if without.is_empty() {
            return true;
        }
        let needed = rows.iter().filter(|row| (self.is_needed)(row)).count();
        let is_empty =
            |name: &&str| empty.get(name).is_some_and(|lines| without.iter().any(|l| lines.contains(l)));
        let named: Vec<&str> = self.names.iter().copied().filter(is_empty).collect();
        let nothing = if self.names == QUATERNION {
            "empty, all 0 or no number"
        } else if self.names.first() == TEMPERATURES.first() {
            "empty, no temperature or no number"
        } else {
            "empty or no number"
        };
        let what = format!("{} {} {nothing}", named.join(", "), is_or_are(named.len()));
        let is_absent = without.len() as f64 > MOSTLY_EMPTY * needed as f64;
        warnings.push(if is_absent {
            let columns = if self.names.len() > 1 { self.names.join(", ") } else { "the column".to_owned() };
            let text = format!(
                "{what} in {} of {} rows: {columns} {} as absent",
                without.len(),
                needed,
                if self.names.len() > 1 { "count" } else { "counts" }
            );
            Diagnostic::warning("measure::gaps", text).help("fill the cells, or leave the column out")
        } else {
            Diagnostic::warning("measure::gaps", format!("{what} in {}", at_lines(&without)))
                .help("these rows are left out; without the column they count")
        });
        if !is_absent {
            rows.retain(|row| !lacks(row));
        }
        !is_absent
    }
}

/// Rows as a count, with the first few of their lines.
pub(super) fn at_lines(lines: &[u64]) -> String {
    let shown = first_few(lines, MOST_LINES);
    format!("{}: {} {shown}", counted(lines.len(), "row"), plural(lines.len(), "line"))
}

/// The warning of rows without a reading in a column that has to be there.
pub(super) fn no_reading(column: &str, lines: &[u64]) -> Diagnostic {
    let nothing = if column == FIXED { "empty" } else { "empty or no number" };
    let text = format!("column {column} is {nothing} in {}", at_lines(lines));
    Diagnostic::warning("measure::no-reading", text).help("these rows are left out")
}

/// Numbers the poses of `rows` by their names, those without a name by their joints, beside named rows of the same joints; whether the
/// file names any.
pub(super) fn name_poses(
    rows: &mut [MeasurementRow],
    names: &[Option<String>],
    has_column: bool,
    warnings: &mut Vec<Diagnostic>,
) -> bool {
    let is_named = names.iter().any(Option::is_some);
    // A nest has a name of its own: it repeats no pose of the arm.
    let lacks_name = |(row, name): &(&MeasurementRow, &Option<String>)| {
        name.is_none() && (!is_named || row.reading.involves_arm())
    };
    let unnamed: Vec<u64> = rows.iter().zip(names).filter(lacks_name).map(|(row, _)| row.line).collect();
    if has_column && !unnamed.is_empty() {
        let text = match is_named {
            true => format!("pose_id is empty in {}", at_lines(&unnamed)),
            false => "pose_id is empty in all rows: it counts as absent".to_owned(),
        };
        warnings.push(
            Diagnostic::warning("measure::gaps", text).help(
                "rows without a pose_id repeat a pose where their joints are the same to the last digit",
            ),
        );
    }
    // Where the arm stood is a pose; a nest on the base is another one, of its own.
    let stands = |row: &MeasurementRow| -> (Option<usize>, Joints<u64>) {
        let nest = matches!(row.reading, Reading::Nest { .. });
        (row.reading.fixed_point().filter(|_| nest), row.q_rad.map(f64::to_bits))
    };
    let mut by_name: BTreeMap<&str, usize> = BTreeMap::new();
    let mut by_joints = BTreeMap::new();
    let mut next = 0;
    for (row, name) in rows.iter_mut().zip(names) {
        let Some(name) = name else { continue };
        row.pose = *by_name.entry(name).or_insert(next);
        next = next.max(row.pose + 1);
        by_joints.entry(stands(row)).or_insert(row.pose);
    }
    for (row, _) in rows.iter_mut().zip(names).filter(|(_, name)| name.is_none()) {
        row.pose = *by_joints.entry(stands(row)).or_insert(next);
        next = next.max(row.pose + 1);
    }
    has_column && is_named
}

#[cfg(test)]
mod tests {
    use crate::{Measurements, Reading};

    /// Rows of one pose each, their optional cells after the point.
    fn read(columns: &str, cells: &[&str]) -> Measurements {
        let header = format!("q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm,{columns}\n");
        let row = |(k, cells): (usize, &&str)| format!("{k},0,0,0,0,0,1,2,3,{cells}\n");
        Measurements::from_csv((header + &cells.iter().enumerate().map(row).collect::<String>()).as_bytes())
            .unwrap()
    }

    fn lines_and_warnings(m: &Measurements) -> (Vec<u64>, Vec<&str>) {
        (m.rows.iter().map(|row| row.line).collect(), m.warnings.iter().map(|w| w.message.as_str()).collect())
    }

    #[test]
    fn a_row_with_an_empty_cell_is_left_out_and_not_its_column() {
        let m = read("t_min,payload_kg", &["0,2", "1,NaN", "2,2", ",2", "4,2"]);
        let warnings = [
            "t_min is empty or no number in 1 row: line 5",
            "payload_kg is empty or no number in 1 row: line 3",
        ];
        assert_eq!(lines_and_warnings(&m), (vec![2, 4, 6], warnings.to_vec()));
        assert!(m.channels.time && m.channels.payload);
        assert_eq!(m.rows[2].t_min, Some(4.0));
    }

    #[test]
    fn what_a_spreadsheet_could_not_compute_is_an_empty_cell() {
        let m = read("t_min", &["0", "#REF!", "2", "#DIV/0!", "4", "#NAME?", "6", "7", "8"]);
        let warning = "t_min is empty or no number in 3 rows: lines 3, 5, 7";
        assert_eq!(lines_and_warnings(&m), (vec![2, 4, 6, 8, 9, 10], vec![warning]));
    }

    #[test]
    fn of_columns_that_count_together_those_that_are_empty_are_named() {
        let columns: Vec<String> = (1..=6).map(|j| format!("temp_j{j}_c")).collect();
        let m = read(&columns.join(","), &["20,20,20,20,20,20", "20,,20,20,,20", "21,21,21,21,21,21"]);
        let warning = "temp_j2_c, temp_j5_c are empty, no temperature or no number in 1 row: line 3";
        assert_eq!(lines_and_warnings(&m), (vec![2, 4], vec![warning]));
        assert!(m.channels.joint_temperature);
    }

    #[test]
    fn a_column_that_is_mostly_empty_is_absent_and_its_rows_count() {
        let m = read("payload_kg", &["", "2", ""]);
        let warning = "payload_kg is empty or no number in 2 of 3 rows: the column counts as absent";
        assert_eq!(lines_and_warnings(&m), (vec![2, 3, 4], vec![warning]));
        assert!(!m.channels.payload && m.rows.iter().all(|row| row.payload_kg.is_none()));
    }

    #[test]
    fn rows_without_a_pose_id_are_of_the_pose_with_their_joints() {
        let joints = "q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm,target,pose_id\n";
        let rows = |ids: [&str; 4]| {
            let row =
                |(k, id): (usize, &str)| format!("{},0,0,0,0,0,1,2,{k},{},{id}\n", k / 2, ["A", "B"][k % 2]);
            let text = joints.to_owned() + &ids.into_iter().enumerate().map(row).collect::<String>();
            Measurements::from_csv(text.as_bytes()).unwrap()
        };
        let poses = |m: &Measurements| m.rows.iter().map(|row| row.pose).collect::<Vec<usize>>();
        let none = rows([""; 4]);
        assert_eq!((poses(&none), none.channels.pose_id), (vec![0, 0, 1, 1], false));
        assert_eq!(none.warnings[0].message, "pose_id is empty in all rows: it counts as absent");
        let some = rows(["P", "", "", ""]);
        assert_eq!((poses(&some), some.channels.pose_id), (vec![0, 0, 1, 1], true));
        assert_eq!(some.warnings[0].message, "pose_id is empty in 3 rows: lines 3, 4, 5");
    }

    /// A dash, NaN or what a spreadsheet could not compute is as empty as an empty cell, in whatever column.
    #[test]
    fn what_says_that_there_is_nothing_is_no_name_and_no_reading() {
        let m = read("target", &["A", "-", "B", "n/a"]);
        assert_eq!((m.targets.len(), m.rows[1].target), (3, m.rows[3].target));
        assert_eq!(lines_and_warnings(&m).1, ["target is empty in 2 rows: lines 3, 5"]);
        let joints = "q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg";
        let row = |(k, cells): (usize, &&str)| format!("{k},0,0,0,0,0,{cells}\n");
        let file = |columns: &str, cells: &[&str]| {
            let rows: String = cells.iter().enumerate().map(row).collect();
            Measurements::from_csv(format!("{joints},{columns}\n{rows}").as_bytes()).unwrap()
        };
        let touches = file("fixed_id", &["pin", "n/a", "-", "pin", ""]);
        assert_eq!(touches.fixed_points, ["pin"]);
        let warning = "column fixed_id is empty in 3 rows: lines 3, 4, 6";
        assert_eq!(lines_and_warnings(&touches), (vec![2, 5], vec![warning]));
        let lengths = file("length_mm,x_mm,y_mm,z_mm", &["500,NaN,NaN,NaN", "510,,-,", "NaN,NaN,NaN,NaN"]);
        let warning = "column x_mm is empty or no number in 1 row: line 4";
        assert_eq!(lines_and_warnings(&lengths), (vec![2, 3], vec![warning]));
        assert!(matches!(lengths.rows[1].reading, Reading::Length { length_m: 0.51, .. }));
    }

    #[test]
    fn a_target_without_a_name_among_named_ones_is_told() {
        let m = read("target", &["A", "", "B"]);
        assert_eq!(lines_and_warnings(&m).1, ["target is empty in 1 row: line 3"]);
        assert!(read("target", &["", "", ""]).warnings.is_empty());
    }
}

//! Reading the measurement table: columns by name, in any order, checked cell by cell.

use super::column_names::{FIXED, SLIDES};
use super::error::missing_column;
use super::gaps::{EmptyCells, at_lines, complete_channels, name_poses, no_reading};
use super::midnight::pass_midnight;
use super::row_cells::{ColumnIndex, RowCells};
use super::sessions::number_sessions;
use super::table::Table;
use super::time_unit::{TimedStop, time_unit};
use super::touch_times::{self, StampedRow};
use super::{Channels, MeasureError, MeasurementRow, Measurements, Reading, Touch, Touches};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::robot::{JointKind, Joints};
use std::collections::{BTreeMap, BTreeSet};

/// So many nests that are seen once each are rows of the arm, or of one nest.
const FEWEST_SEEN_ONCE: usize = 3;

impl Measurements {
    /// Reads a measurement file: CSV with columns by name (mm, degrees, minutes), in any order.
    ///
    /// # Errors
    /// A column that is missing, a cell that is no number, a file without rows, with line and column.
    pub fn from_csv(bytes: &[u8]) -> Result<Self, MeasureError> {
        Self::from_table(&Table::from_csv(bytes)?)
    }

    /// As [`Measurements::from_csv`], of a table that a column map made or that was put together.
    ///
    /// # Errors
    /// As of [`Measurements::from_csv`].
    pub fn from_table(table: &Table) -> Result<Self, MeasureError> {
        from_table(table)
    }
}

impl Touches {
    /// Reads touches of fixed points, or of poses (`pose_id`) with measured points.
    ///
    /// # Errors
    /// A column or cell that is missing or wrong; a row without time, or with one beyond a year.
    pub fn from_csv(bytes: &[u8]) -> Result<Self, MeasureError> {
        Self::from_table(&Table::from_csv(bytes)?)
    }

    /// As [`Touches::from_csv`], of a table.
    ///
    /// # Errors
    /// As of [`Touches::from_csv`].
    pub fn from_table(table: &Table) -> Result<Self, MeasureError> {
        let mut found = touches(table)?;
        found.leave_out_copies();
        let stamped = |touch: &Touch| StampedRow { line: touch.line, point: touch.point, t_min: touch.t_min };
        let mut stamped: Vec<StampedRow> = found.touches.iter().map(stamped).collect();
        sorting::by_key(&mut stamped, |row| row.line);
        found.warnings.extend(touch_times::check(&stamped)?);
        found.warnings.extend(time_unit(stamped.iter().map(|row| TimedStop {
            t_min: row.t_min,
            clock_min: row.t_min,
            stand: row.point,
        })));
        Ok(found)
    }
}

fn from_table(table: &Table) -> Result<Measurements, MeasureError> {
    let columns = ColumnIndex::new(&table.header)?;
    let mut warnings = columns.warnings.clone();
    let mut rows = Vec::new();
    let mut pose_names: Vec<Option<String>> = Vec::new();
    let mut targets: BTreeMap<String, usize> = BTreeMap::new();
    let mut fixed_points: BTreeMap<(&'static str, String), usize> = BTreeMap::new();
    let mut empty = EmptyCells::new();
    let mut without = EmptyCells::new();
    for line in &table.lines {
        let cells = RowCells { columns: &columns, line };
        if let Some(column) = cells.absent() {
            without.entry(column).or_default().push(line.number);
            continue;
        }
        let reading = cells.reading(&mut |kind, name| {
            let next = fixed_points.len();
            *fixed_points.entry((kind, name.to_owned())).or_insert(next)
        })?;
        let mut target = 0;
        if reading.involves_arm() {
            let next = targets.len();
            let name = cells.text("target").unwrap_or_default().to_owned();
            target = *targets.entry(name).or_insert(next);
        }
        for name in cells.empty_among_optional() {
            empty.entry(name).or_default().push(line.number);
        }
        pose_names.push(cells.text("pose_id").map(str::to_owned));
        rows.push(cells.row(target, reading)?);
    }
    if !rows.iter().any(|row: &MeasurementRow| row.reading.involves_arm()) {
        if let Some((column, lines)) = without.first_key_value() {
            let line = lines.first().copied().unwrap_or_default();
            return Err(MeasureError::NothingMeasured { line, column });
        }
        return Err(MeasureError::NoRows);
    }
    for (column, lines) in without {
        warnings.push(no_reading(column, &lines));
    }
    warnings.extend(unnamed_targets(&rows, &targets));
    warnings.extend(unnamed_nests(&rows, &fixed_points).or_else(|| nests_seen_once(&rows)));
    warnings.extend(alike("target", targets.keys().map(String::as_str)));
    warnings.extend(alike(FIXED, fixed_points.keys().map(|(_, name)| name.as_str())));
    let pose_id = name_poses(&mut rows, &pose_names, columns.has("pose_id"), &mut warnings);
    let channels = complete_channels(&columns, &mut rows, &empty, &mut warnings);
    let joint_kinds = kinds(&columns);
    warnings.extend(pass_midnight(&mut rows));
    number_sessions(&mut rows, &joint_kinds);
    Ok(Measurements {
        rows,
        channels: Channels { pose_id, ..channels },
        targets: in_order(targets),
        fixed_points: in_order(fixed_points.into_iter().map(|((_, name), index)| (name, index))),
        joint_kinds,
        warnings,
    })
}

/// The warning of rows that do not say which of several targets they saw.
fn unnamed_targets(rows: &[MeasurementRow], targets: &BTreeMap<String, usize>) -> Option<Diagnostic> {
    let unnamed = *targets.get("").filter(|_| targets.len() > 1)?;
    let of_it = rows.iter().filter(|row| row.reading.involves_arm() && row.target == unnamed);
    let lines: Vec<u64> = of_it.map(|row| row.line).collect();
    let text = format!("target is empty in {}", at_lines(&lines));
    Some(
        Diagnostic::warning("measure::gaps", text)
            .help("they count as rows of one more target, whose place is fitted"),
    )
}

/// The warning of nests that have no name: they count as one.
fn unnamed_nests(
    rows: &[MeasurementRow],
    fixed_points: &BTreeMap<(&'static str, String), usize>,
) -> Option<Diagnostic> {
    let unnamed = *fixed_points.get(&("nest", String::new()))?;
    let is_unnamed = |row: &&MeasurementRow| matches!(row.reading, Reading::Nest { fixed_point, .. } if fixed_point == unnamed);
    let lines: Vec<u64> = rows.iter().filter(is_unnamed).map(|row| row.line).collect();
    let text = format!("kind is base, and nothing names the nest, in {}", at_lines(&lines));
    Some(
        Diagnostic::warning("measure::gaps", text)
            .help("they count as readings of one nest on the base, and tell nothing of the arm: fixed_id names it; rows of the arm have the kind pose"),
    )
}

/// The warning of nests of which each is seen once, which tells nothing: rows of the arm, as a rule, whose kind is wrong.
fn nests_seen_once(rows: &[MeasurementRow]) -> Option<Diagnostic> {
    let mut lines_of: BTreeMap<usize, Vec<u64>> = BTreeMap::new();
    for row in rows {
        if let Reading::Nest { fixed_point, .. } = row.reading {
            lines_of.entry(fixed_point).or_default().push(row.line);
        }
    }
    let once: Vec<u64> = lines_of.into_values().filter(|lines| lines.len() == 1).flatten().collect();
    if once.len() < FEWEST_SEEN_ONCE {
        return None;
    }
    let text = format!("kind is base, and each row is of another nest, in {}", at_lines(&once));
    Some(
        Diagnostic::warning("measure::gaps", text)
            .help("a nest that is seen once tells nothing: fixed_id names those that are one; rows of the arm have the kind pose"),
    )
}

/// The warning of names of one column that differ by capital letters alone.
fn alike<'a>(column: &str, names: impl Iterator<Item = &'a str>) -> Option<Diagnostic> {
    let mut written: BTreeMap<String, BTreeSet<&str>> = BTreeMap::new();
    for name in names {
        written.entry(name.to_lowercase()).or_default().insert(name);
    }
    let several = written.into_values().find(|all| all.len() > 1)?;
    let names: Vec<&str> = several.into_iter().collect();
    let text = format!("{column} has {}, which differ by capital letters alone", names.join(" and "));
    Some(
        Diagnostic::warning("measure::names-alike", text)
            .help("they count as different ones; where they are one, write it alike in all rows"),
    )
}

/// How each joint moves, by the unit of its column.
fn kinds(columns: &ColumnIndex) -> Joints<JointKind> {
    let kind = |name: &&str| if SLIDES.contains(name) { JointKind::Prismatic } else { JointKind::Revolute };
    columns.joints.iter().map(kind).collect()
}

/// Names at their indices.
fn in_order(names: impl IntoIterator<Item = (String, usize)>) -> Vec<String> {
    let mut by_index: Vec<(usize, String)> = names.into_iter().map(|(name, index)| (index, name)).collect();
    sorting::ascending(&mut by_index);
    by_index.into_iter().map(|(_, name)| name).collect()
}

/// Touches of fixed points, or, in a file without `fixed_id`, of poses with measured points; in order of time.
fn touches(table: &Table) -> Result<Touches, MeasureError> {
    let measurements = from_table(table)?;
    let no_time = || missing_column("t_min", &table.header);
    // A nest has a name of its kind, too.
    let is_touch = |row: &MeasurementRow| matches!(row.reading, Reading::Touch { .. });
    if !measurements.rows.iter().any(is_touch) {
        let found = Touches::of_poses(&measurements).ok_or_else(no_time)?;
        return if found.touches.is_empty() && table.column(FIXED).is_some() {
            Err(MeasureError::NoRows)
        } else {
            Ok(found)
        };
    }
    let mut touches = Vec::new();
    for row in &measurements.rows {
        let Reading::Touch { fixed_point } = row.reading else { continue };
        let t_min = row.t_min.ok_or_else(no_time)?;
        let q_rad = row.q_rad.array().ok_or_else(|| missing_column("q6_deg", &table.header))?;
        touches.push(Touch { line: row.line, point: fixed_point, t_min, q_rad, measured_m: None });
    }
    sorting::by(&mut touches, |a, b| a.t_min.total_cmp(&b.t_min).then(a.line.cmp(&b.line)));
    Ok(Touches { touches, points: measurements.fixed_points, warnings: measurements.warnings })
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector3;

    const HEADER: &str = "q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm";

    fn read(text: &str) -> Result<Measurements, MeasureError> {
        from_table(&Table::from_csv(text.as_bytes())?)
    }

    fn said(measurements: &Measurements) -> String {
        measurements.warnings.iter().map(|w| format!("{} {}; ", w.code, w.message)).collect()
    }

    #[test]
    fn names_that_differ_by_case_and_nests_without_one_are_told() {
        let file = |cells: [&str; 3]| {
            let rows = cells.map(|cells| format!("0,0,0,0,0,0,1,2,3,{cells}\n")).concat();
            read(&format!("{HEADER},target,kind,fixed_id\n{rows}")).unwrap()
        };
        let two = file(["A,pose,", "a,pose,", "A,pose,"]);
        assert_eq!(two.targets, ["A", "a"]);
        assert!(said(&two).contains("measure::names-alike target has A and a"), "{}", said(&two));
        let nests = file(["A,pose,", ",base,", "A,base,"]);
        assert!(
            said(&nests).contains("kind is base, and nothing names the nest, in 1 row: line 3"),
            "{}",
            said(&nests)
        );
        let rows: String = (0..4)
            .map(|k| format!("0,0,0,0,0,0,1,2,3,{k},{}\n", if k > 0 { "base" } else { "pose" }))
            .collect();
        let once = read(&format!("{HEADER},id,kind\n{rows}")).unwrap();
        assert!(
            said(&once).contains("each row is of another nest, in 3 rows: lines 3, 4, 5"),
            "{}",
            said(&once)
        );
        let sound = file(["A,pose,", "B,pose,", "A,base,N1"]);
        assert_eq!(said(&sound), "");
    }

    #[test]
    fn a_code_for_no_temperature_is_no_reading() {
        let temperatures: String = (1..=6).map(|j| format!(",temp_j{j}_c")).collect();
        let row = |cells: &str| format!("0,0,0,0,0,0,1,2,3,{cells}\n");
        for code in ["-999", "999", "999.9", "9999.00"] {
            let (warm, coded) = (row("20,20,20,20,20,20"), row(&format!("20,20,{code},20,20,20")));
            let found = read(&format!("{HEADER}{temperatures}\n{warm}{coded}{warm}")).unwrap();
            assert_eq!(found.rows.iter().map(|row| row.line).collect::<Vec<_>>(), [2, 4], "{code}");
            let warning = "temp_j3_c is empty, no temperature or no number in 1 row: line 3";
            assert!(said(&found).contains(warning), "{}", said(&found));
        }
        let warm =
            ["99.9", "99", "293.15", "990"].map(|warm| row(&format!("20,20,{warm},20,20,20"))).concat();
        assert_eq!(read(&format!("{HEADER}{temperatures}\n{warm}")).unwrap().rows.len(), 4);
    }

    #[test]
    fn a_trackers_poses_are_called_as_the_file_calls_them() {
        let rows: String = (0..6).map(|k| format!("0,0,0,0,0,{},1,2,3,P{},{k}\n", k % 2, k % 2)).collect();
        let touches = Touches::from_csv(format!("{HEADER},pose_id,t_min\n{rows}").as_bytes()).unwrap();
        assert_eq!(touches.points, ["P0", "P1"]);
    }

    /// What a hand-held probe, or the pose before, has written beside a nest is no orientation of the arm; nor is a nest without one left out.
    #[test]
    fn nests_have_no_orientation() {
        let rows = ["pose,1,0,0,0", "base,1,0,0,0", "base,,,,", "pose,0,1,0,0"]
            .map(|cells| format!("0,0,0,0,0,0,1,2,3,N,{cells}\n"))
            .concat();
        let found = read(&format!("{HEADER},fixed_id,kind,qw,qx,qy,qz\n{rows}")).unwrap();
        assert_eq!(said(&found), "");
        let oriented: Vec<bool> = found.rows.iter().map(|row| row.orientation.is_some()).collect();
        assert!(found.channels.orientation);
        assert_eq!(oriented, [true, false, false, true]);
    }

    /// Of three rows one has four zeros: it is left out as one whose cells are empty; with two such rows there are no orientations.
    #[test]
    fn four_zeros_are_no_orientation() {
        let with = |turns: [&str; 3]| {
            let rows = turns.map(|turn| format!("0,0,0,0,0,0,1,2,3,{turn}\n")).concat();
            read(&format!("{HEADER},qw,qx,qy,qz\n{rows}")).unwrap()
        };
        let one = with(["1,0,0,0", "0,0,0,0", "1,0,0,0"]);
        assert_eq!(one.rows.iter().map(|row| row.line).collect::<Vec<_>>(), [2, 4]);
        assert!(one.channels.orientation);
        let text = one.warnings.iter().map(|w| w.message.as_str()).collect::<Vec<_>>().join(" ");
        assert!(text.contains("qw, qx, qy, qz are empty, all 0 or no number"), "{text}");
        let two = with(["0,0,0,0", "0.0,0.0,0.0,0.0", "1,0,0,0"]);
        assert!(two.rows.len() == 3 && !two.channels.orientation);
    }

    #[test]
    fn columns_stand_in_any_order_and_become_si() {
        let text = "z_mm,x_mm,y_mm,dir1,dir2,dir3,dir4,dir5,dir6,q6_deg,q5_deg,q4_deg,q3_deg,q2_deg,q1_deg,t_min\n\
                    3000,1000,-2000,1,-1,0,1,1,1,0,0,0,0,90,180.25,5\n";
        let m = read(text).unwrap();
        let row = &m.rows[0];
        assert_eq!(row.reading, Reading::Point { position_m: Vector3::new(1.0, -2.0, 3.0) });
        assert_eq!(row.q_rad[1], std::f64::consts::FRAC_PI_2);
        assert_eq!(row.direction.unwrap(), [1, -1, 0, 1, 1, 1]);
        assert_eq!((row.t_min, row.line), (Some(5.0), 2));
        assert!(m.channels.time && m.channels.direction && !m.channels.payload);
    }

    #[test]
    fn what_cannot_be_read_names_line_and_column() {
        let row = |cells: &str| read(&format!("{HEADER}\n{cells}\n")).unwrap_err().to_string();
        assert_eq!(row("0,0,0,0,0,0,1,two,3"), "line 2, column y_mm: 'two' is not a number");
        assert_eq!(row("0,0,0,0,0,0,1,2"), "line 2 has 8 cells, the header 9");
        assert_eq!(read(HEADER).unwrap_err(), MeasureError::NoRows);
        assert_eq!(read("").unwrap_err(), MeasureError::NoHeader);
        let eight = read(&format!("{HEADER},q7_deg,q8_deg\n")).unwrap_err();
        assert_eq!(eight, MeasureError::TooManyJoints { column: "q8_deg".to_owned() });
        let slides = read(&format!("{HEADER},q8_mm\n")).unwrap_err();
        assert_eq!(slides, MeasureError::TooManyJoints { column: "q8_mm".to_owned() });
        let gap = read("q1_deg,q2_deg,q4_mm,x_mm,y_mm,z_mm\n").unwrap_err().to_string();
        assert!(gap.starts_with("column q3_deg is missing"), "{gap}");
        let without = read("q1_deg,q2_deg\n1,2\n").unwrap_err().to_string();
        assert!(without.starts_with("column q3_deg is missing"), "{without}");
        let semicolons = read("q1_deg;q2_deg\n1;2\n").unwrap_err().to_string();
        assert!(semicolons.contains("separated by ';'"), "{semicolons}");
    }

    #[test]
    fn four_to_seven_joints_are_read_and_those_that_slide_in_mm() {
        let scara = read(
            "q1_deg,q2_deg,q3_mm,q4_deg,dir1,dir2,dir3,dir4,temp_j1_c,temp_j2_c,temp_j3_c,temp_j4_c,x_mm,y_mm,z_mm\n\
             90,0,-120.5,180,1,-1,0,1,20,21,22,23,1,2,3\n",
        )
        .unwrap();
        assert_eq!(scara.rows[0].q_rad, [std::f64::consts::FRAC_PI_2, 0.0, -0.1205, std::f64::consts::PI]);
        assert_eq!(scara.rows[0].direction.unwrap(), [1, -1, 0, 1]);
        assert_eq!(scara.rows[0].joint_temperature_c.unwrap(), [20.0, 21.0, 22.0, 23.0]);
        let names: Vec<&str> = scara.joint_kinds.iter().map(|kind| kind.name()).collect();
        assert_eq!(names, ["revolute", "revolute", "prismatic", "revolute"]);
        let seven = read(&format!("q7_deg,{HEADER}\n7,1,2,3,4,5,6,1,2,3\n")).unwrap();
        assert_eq!(seven.rows[0].q_rad.len(), 7);
        assert!((seven.rows[0].q_rad[6] - 7.0_f64.to_radians()).abs() < 1e-15);
        assert!(seven.warnings.is_empty() && !seven.channels.direction);
    }

    #[test]
    fn columns_of_which_nothing_is_made_are_named() {
        let m = read(&format!("{HEADER},operator,temp_j7_c,temp_air_c\n0,0,0,0,0,0,1,2,3,me,30,\n")).unwrap();
        let warnings: Vec<(&str, &str)> = m.warnings.iter().map(|w| (w.code, w.message.as_str())).collect();
        assert_eq!(
            warnings,
            [
                ("measure::unknown-column", "column 'operator' is not known and is ignored"),
                (
                    "measure::unused-column",
                    "column 'temp_j7_c' is of no joint of the 6 that the file has and is not used"
                ),
                ("measure::unused-column", "column 'temp_air_c' drives no effect and is not used"),
            ]
        );
        assert_eq!(m.rows.len(), 1);
    }

    #[test]
    fn rows_without_a_point_or_a_joint_are_left_out_with_their_lines_and_column() {
        let m =
            read(&format!("{HEADER}\n0,0,0,0,0,0,1,,3\n0,0,NaN,0,0,0,1,2,3\n0,0,0,0,0,0,1,2,3\n")).unwrap();
        assert_eq!(m.rows.iter().map(|row| row.line).collect::<Vec<u64>>(), [4]);
        let messages: Vec<&str> = m.warnings.iter().map(|w| w.message.as_str()).collect();
        assert_eq!(
            messages,
            [
                "column q3_deg is empty or no number in 1 row: line 3",
                "column y_mm is empty or no number in 1 row: line 2",
            ]
        );
        let none = read(&format!("{HEADER}\n0,0,0,0,0,,1,2,3\n")).unwrap_err();
        assert_eq!(none, MeasureError::NothingMeasured { line: 2, column: "q6_deg" });
    }

    /// A nest is where it is wherever the arm stood: a spreadsheet's empty joint costs no file, and no nest.
    #[test]
    fn a_nest_without_one_of_the_joints_is_one_without_the_arm() {
        let rows = "0,0,0,0,0,10,1,2,3,pose,\n0,0,0,0,0,NaN,4,5,6,base,N\n0,0,0,0,0,10,4,5,6,base,N\n";
        let m = read(&format!("{HEADER},kind,fixed_id\n{rows}")).unwrap();
        let with_arm = |row: &MeasurementRow| match row.reading {
            Reading::Nest { with_joints, .. } => Some(with_joints),
            _ => None,
        };
        assert_eq!(m.rows.iter().map(with_arm).collect::<Vec<_>>(), [None, Some(false), Some(true)]);
        let text = "0,0,0,0,0,10,1,2,3,pose,\n0,0,0,0,abc,NaN,4,5,6,base,N\n";
        let error = read(&format!("{HEADER},kind,fixed_id\n{text}")).unwrap_err();
        assert!(matches!(error, MeasureError::NotANumber { line: 3, .. }), "{error:?}");
    }

    #[test]
    fn rows_with_one_pose_id_repeat_one_pose() {
        let m = read(&format!(
            "pose_id,{HEADER}\nA,0,0,0,0,0,0,1,2,3\nB,0,0,0,0,0,0,1,2,3\nA,0,0,0,0,0,0,1,2,3\n"
        ))
        .unwrap();
        let poses: Vec<usize> = m.rows.iter().map(|r| r.pose).collect();
        assert_eq!(poses, [0, 1, 0]);
    }
}

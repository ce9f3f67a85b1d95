//! Reading the measurement table: columns by name, in any order, checked cell by cell.

use super::table::{Line, Table};
use super::{Channels, MeasureError, MeasurementRow, Measurements, Reading, Touch, Touches};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::units::{m_from_mm, rad_from_deg};
use std::collections::BTreeMap;

pub(super) const JOINTS: [&str; 6] = ["q1_deg", "q2_deg", "q3_deg", "q4_deg", "q5_deg", "q6_deg"];
pub(super) const POINT: [&str; 3] = ["x_mm", "y_mm", "z_mm"];
pub(super) const QUATERNION: [&str; 4] = ["qw", "qx", "qy", "qz"];
const DIRECTIONS: [&str; 6] = ["dir1", "dir2", "dir3", "dir4", "dir5", "dir6"];
const TEMPERATURES: [&str; 6] =
    ["temp_j1_c", "temp_j2_c", "temp_j3_c", "temp_j4_c", "temp_j5_c", "temp_j6_c"];
const OTHERS: [&str; 7] = ["id", "pose_id", "t_min", "target", "kind", "payload_kg", "temp_air_c"];
/// Instead of a point.
const FIXED: &str = "fixed_id";
const LENGTH: &str = "length_mm";
/// A quaternion whose length is further from 1 than this is no orientation.
const QUATERNION_LENGTH: f64 = 0.02;

/// Every column that a measurement table may have.
pub(super) fn known() -> Vec<&'static str> {
    [&JOINTS[..], &POINT, &QUATERNION, &DIRECTIONS, &TEMPERATURES, &OTHERS, &[FIXED, LENGTH]].concat()
}

pub(super) fn from_table(table: &Table) -> Result<Measurements, MeasureError> {
    let columns = ColumnIndex::new(&table.header)?;
    let mut warnings = columns.warnings.clone();
    let mut rows = Vec::new();
    let mut poses: BTreeMap<String, usize> = BTreeMap::new();
    let mut targets: BTreeMap<String, usize> = BTreeMap::new();
    let mut fixed_points: BTreeMap<(&'static str, String), usize> = BTreeMap::new();
    let mut decimals = 0;
    for line in &table.lines {
        let cells = RowCells { columns: &columns, line };
        let pose = cells.text("pose_id").unwrap_or_default();
        let pose = if pose.is_empty() { format!("\u{0}{}", line.number) } else { pose.to_owned() };
        let next = poses.len();
        let pose = *poses.entry(pose).or_insert(next);
        let reading = cells.reading(&mut |kind, name| {
            let next = fixed_points.len();
            *fixed_points.entry((kind, name.to_owned())).or_insert(next)
        })?;
        let mut target = 0;
        if reading.involves_arm() {
            let next = targets.len();
            let name = cells.text("target").unwrap_or_default().to_owned();
            target = *targets.entry(name).or_insert(next);
            for name in JOINTS {
                decimals = decimals.max(cells.text(name).map_or(0, decimals_of));
            }
        }
        rows.push(cells.row(pose, target, reading)?);
    }
    if !rows.iter().any(|row: &MeasurementRow| row.reading.involves_arm()) {
        return Err(MeasureError::NoRows);
    }
    let channels = complete_channels(&columns, &mut rows, &mut warnings);
    Ok(Measurements {
        rows,
        channels,
        targets: in_order(targets),
        fixed_points: in_order(fixed_points.into_iter().map(|((_, name), index)| (name, index))),
        joint_decimals: decimals,
        warnings,
    })
}

/// Names at their indices.
fn in_order(names: impl IntoIterator<Item = (String, usize)>) -> Vec<String> {
    let mut by_index: Vec<(usize, String)> = names.into_iter().map(|(name, index)| (index, name)).collect();
    by_index.sort_unstable();
    by_index.into_iter().map(|(_, name)| name).collect()
}

/// Touches of fixed points, or, in a file without `fixed_id`, of poses with measured points; in order of time.
pub(super) fn touches(table: &Table) -> Result<Touches, MeasureError> {
    let measurements = from_table(table)?;
    let no_time = || missing("t_min", &table.header);
    if table.column(FIXED).is_none() {
        return Touches::of_poses(&measurements).ok_or_else(no_time);
    }
    let mut touches = Vec::new();
    for row in &measurements.rows {
        let Reading::Touch { fixed_point } = row.reading else { continue };
        let t_min = row.t_min.ok_or_else(no_time)?;
        touches.push(Touch { line: row.line, point: fixed_point, t_min, q_rad: row.q_rad, measured_m: None });
    }
    if touches.is_empty() {
        return Err(MeasureError::NoRows);
    }
    touches.sort_by(|a, b| a.t_min.total_cmp(&b.t_min).then(a.line.cmp(&b.line)));
    Ok(Touches { touches, points: measurements.fixed_points })
}

/// Where each known column stands.
struct ColumnIndex {
    at: BTreeMap<String, usize>,
    warnings: Vec<Diagnostic>,
}

impl ColumnIndex {
    fn new(header: &[String]) -> Result<Self, MeasureError> {
        let known = known();
        let mut at = BTreeMap::new();
        let mut warnings = Vec::new();
        for (index, name) in header.iter().enumerate() {
            let name = name.to_ascii_lowercase();
            let joint = name.strip_prefix('q').and_then(|rest| rest.strip_suffix("_deg"));
            if joint.and_then(|n| n.parse::<u32>().ok()).is_some_and(|n| n > 6) {
                return Err(MeasureError::TooManyJoints { column: name });
            }
            if !known.contains(&name.as_str()) {
                warnings.push(
                    Diagnostic::warning(
                        "measure::unknown-column",
                        format!("column '{name}' is not known and is ignored"),
                    )
                    .help("rename it if it holds one of the known quantities"),
                );
                continue;
            }
            if at.insert(name.clone(), index).is_some() {
                return Err(MeasureError::DoubledColumn { column: name });
            }
        }
        let without_points = at.contains_key(FIXED) || at.contains_key(LENGTH);
        let points = POINT.iter().filter(|_| !without_points || POINT.iter().any(|p| at.contains_key(*p)));
        for column in JOINTS.iter().chain(points) {
            if !at.contains_key(*column) {
                return Err(missing(column, header));
            }
        }
        let groups = [&QUATERNION[..], &DIRECTIONS, &TEMPERATURES];
        for group in groups {
            let there = group.iter().filter(|name| at.contains_key(**name)).count();
            if there > 0 && there < group.len() {
                warnings.push(Diagnostic::warning(
                    "measure::incomplete-columns",
                    format!("of {} only {there} columns are there; they are ignored", group.join(", ")),
                ));
                for name in group {
                    at.remove(*name);
                }
            }
        }
        Ok(Self { at, warnings })
    }

    fn has(&self, name: &str) -> bool {
        self.at.contains_key(name)
    }
}

pub(super) fn missing(column: &str, header: &[String]) -> MeasureError {
    let found: Vec<&str> = header.iter().map(String::as_str).collect();
    let hint = if found.len() == 1 && found[0].contains(';') {
        "; the columns seem to be separated by ';', commas are needed"
    } else if found.len() == 1 && found[0].contains('\t') {
        "; the columns seem to be separated by tabs, commas are needed"
    } else if found.iter().any(|n| n.ends_with("_rad")) {
        "; joints are given in degrees"
    } else {
        ""
    };
    let mut found = found.join(", ");
    if let Some((cut, _)) = found.char_indices().nth(200) {
        found.truncate(cut);
        found.push_str(", ...");
    }
    MeasureError::MissingColumn { column: column.to_owned(), found, hint }
}

struct RowCells<'a> {
    columns: &'a ColumnIndex,
    line: &'a Line,
}

impl RowCells<'_> {
    fn text(&self, name: &str) -> Option<&str> {
        self.columns.at.get(name).and_then(|&index| self.line.cells.get(index)).map(String::as_str)
    }

    fn number(&self, name: &str) -> Result<f64, MeasureError> {
        let text = self.text(name).unwrap_or_default();
        match text.parse::<f64>() {
            Ok(value) if value.is_finite() => Ok(value),
            _ => Err(MeasureError::NotANumber {
                line: self.line.number,
                column: name.to_owned(),
                text: text.chars().take(40).collect(),
                hint: if text.is_empty() {
                    ": the cell is empty"
                } else if text.contains(',') {
                    ": write decimals with a point"
                } else {
                    ""
                },
            }),
        }
    }

    /// `None` where the column or the cell is absent.
    fn optional(&self, name: &str) -> Result<Option<f64>, MeasureError> {
        match self.text(name) {
            None | Some("") => Ok(None),
            Some(_) => self.number(name).map(Some),
        }
    }

    fn optional_all<const K: usize>(&self, names: [&str; K]) -> Result<Option<[f64; K]>, MeasureError> {
        let mut values = [0.0; K];
        for (value, name) in values.iter_mut().zip(names) {
            match self.optional(name)? {
                Some(number) => *value = number,
                None => return Ok(None),
            }
        }
        Ok(Some(values))
    }

    fn impossible(&self, column: &str, why: &'static str) -> MeasureError {
        MeasureError::Impossible {
            line: self.line.number,
            column: column.to_owned(),
            text: self.text(column).unwrap_or_default().to_owned(),
            why,
        }
    }

    fn joints(&self) -> Result<[f64; 6], MeasureError> {
        let mut q_rad = [0.0; 6];
        for (q, name) in q_rad.iter_mut().zip(JOINTS) {
            let deg = self.number(name)?;
            if deg.abs() > 1e5 {
                return Err(self.impossible(name, "no joint turns that far"));
            }
            *q = rad_from_deg(deg);
        }
        Ok(q_rad)
    }

    fn empty(&self, name: &str) -> bool {
        self.text(name).unwrap_or_default().is_empty()
    }

    fn length_m(&self, name: &str) -> Result<f64, MeasureError> {
        let mm = self.number(name)?;
        if mm.abs() > 1e8 {
            return Err(self.impossible(name, "no instrument reaches that far"));
        }
        Ok(m_from_mm(mm))
    }

    fn position_m(&self) -> Result<Vector3<f64>, MeasureError> {
        let [x, y, z] = POINT;
        Ok(Vector3::new(self.length_m(x)?, self.length_m(y)?, self.length_m(z)?))
    }

    /// What the row saw; `fixed_point` numbers fixed places by kind and name.
    fn reading(
        &self,
        fixed_point: &mut dyn FnMut(&'static str, &str) -> usize,
    ) -> Result<Reading, MeasureError> {
        let kind = self.text("kind").unwrap_or_default();
        let first_of = |names: &[&str]| {
            names.iter().filter_map(|n| self.text(n)).find(|t| !t.is_empty()).unwrap_or_default().to_owned()
        };
        if kind.eq_ignore_ascii_case("base") {
            let name = first_of(&[FIXED, "target", "pose_id", "id"]);
            return Ok(Reading::Nest {
                fixed_point: fixed_point("nest", &name),
                position_m: self.position_m()?,
            });
        }
        if !kind.is_empty() && !kind.eq_ignore_ascii_case("pose") {
            return Err(self.impossible("kind", "a kind is pose or base"));
        }
        if !POINT.iter().all(|name| self.empty(name)) {
            return Ok(Reading::Point { position_m: self.position_m()? });
        }
        if !self.empty(LENGTH) {
            let length_m = self.length_m(LENGTH)?;
            if length_m <= 0.0 {
                return Err(self.impossible(LENGTH, "a length is more than 0"));
            }
            return Ok(Reading::Length { fixed_point: fixed_point("wire", &first_of(&[FIXED])), length_m });
        }
        if !self.empty(FIXED) {
            return Ok(Reading::Touch { fixed_point: fixed_point("touched", &first_of(&[FIXED])) });
        }
        let column = [POINT[0], LENGTH, FIXED].into_iter().find(|c| self.columns.has(c)).unwrap_or(POINT[0]);
        self.number(column).and(Err(self.impossible(column, "nothing was measured")))
    }

    fn row(&self, pose: usize, target: usize, reading: Reading) -> Result<MeasurementRow, MeasureError> {
        let q_rad = if reading.involves_arm() || JOINTS.iter().all(|name| !self.empty(name)) {
            self.joints()?
        } else {
            [0.0; 6]
        };
        let orientation = match self.optional_all(QUATERNION)? {
            None => None,
            Some([w, x, y, z]) => {
                let quaternion = Quaternion::new(w, x, y, z);
                if (quaternion.norm() - 1.0).abs() > QUATERNION_LENGTH {
                    return Err(self.impossible("qw", "the four numbers are not of length 1"));
                }
                Some(UnitQuaternion::from_quaternion(quaternion))
            }
        };
        let direction = match self.optional_all(DIRECTIONS)? {
            None => None,
            Some(signs) => {
                let mut direction = [0_i8; 6];
                for ((to, from), name) in direction.iter_mut().zip(signs).zip(DIRECTIONS) {
                    *to = match from {
                        1.0 => 1,
                        0.0 => 0,
                        -1.0 => -1,
                        _ => return Err(self.impossible(name, "a direction is -1, 0 or 1")),
                    };
                }
                Some(direction)
            }
        };
        let payload_kg = self.optional("payload_kg")?;
        if payload_kg.is_some_and(|kg| !(0.0..1e5).contains(&kg)) {
            return Err(self.impossible("payload_kg", "a payload weighs 0 kg or more"));
        }
        Ok(MeasurementRow {
            line: self.line.number,
            id: self.text("id").map(str::to_owned),
            pose,
            target,
            t_min: self.optional("t_min")?,
            q_rad,
            reading,
            orientation,
            direction,
            payload_kg,
            joint_temperature_c: self.optional_all(TEMPERATURES)?,
            air_temperature_c: self.optional("temp_air_c")?,
        })
    }
}

/// A channel counts only when every row has it; one with gaps is left out, with a warning.
fn complete_channels(
    columns: &ColumnIndex,
    rows: &mut [MeasurementRow],
    warnings: &mut Vec<Diagnostic>,
) -> Channels {
    let mut keep = |name: &'static str, there: bool, has: fn(&MeasurementRow) -> bool| {
        let gaps = rows.iter().filter(|row| !has(row)).count();
        if there && gaps > 0 {
            warnings.push(
                Diagnostic::warning(
                    "measure::gaps",
                    format!("{name} is empty in {gaps} of {} rows; it is left out altogether", rows.len()),
                )
                .help("fill the cells, or remove the rows"),
            );
        }
        there && gaps == 0
    };
    let channels = Channels {
        pose_id: columns.has("pose_id"),
        time: keep("t_min", columns.has("t_min"), |r| r.t_min.is_some()),
        orientation: keep("qw", columns.has("qw"), |r| r.orientation.is_some() || !r.reading.involves_arm()),
        direction: keep("dir1", columns.has("dir1"), |r| r.direction.is_some() || !r.reading.involves_arm()),
        payload: keep("payload_kg", columns.has("payload_kg"), |r| {
            r.payload_kg.is_some() || !r.reading.involves_arm()
        }),
        joint_temperature: keep("temp_j1_c", columns.has("temp_j1_c"), |r| {
            r.joint_temperature_c.is_some() || !r.reading.involves_arm()
        }),
        air_temperature: keep("temp_air_c", columns.has("temp_air_c"), |r| r.air_temperature_c.is_some()),
    };
    for row in rows {
        row.t_min = row.t_min.filter(|_| channels.time);
        row.orientation = row.orientation.filter(|_| channels.orientation);
        row.direction = row.direction.filter(|_| channels.direction);
        row.payload_kg = row.payload_kg.filter(|_| channels.payload);
        row.joint_temperature_c = row.joint_temperature_c.filter(|_| channels.joint_temperature);
        row.air_temperature_c = row.air_temperature_c.filter(|_| channels.air_temperature);
    }
    channels
}

fn decimals_of(text: &str) -> usize {
    if text.contains(['e', 'E']) {
        return 9;
    }
    text.split_once('.').map_or(0, |(_, decimals)| decimals.trim_end_matches('0').len())
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEADER: &str = "q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm";

    fn read(text: &str) -> Result<Measurements, MeasureError> {
        from_table(&Table::from_csv(text.as_bytes())?)
    }

    #[test]
    fn columns_stand_in_any_order_and_become_si() {
        let text = "z_mm,x_mm,y_mm,dir1,dir2,dir3,dir4,dir5,dir6,q6_deg,q5_deg,q4_deg,q3_deg,q2_deg,q1_deg,t_min\n\
                    3000,1000,-2000,1,-1,0,1,1,1,0,0,0,0,90,180.25,5\n";
        let m = read(text).unwrap();
        let row = &m.rows[0];
        assert_eq!(row.reading, Reading::Point { position_m: Vector3::new(1.0, -2.0, 3.0) });
        assert_eq!(row.q_rad[1], std::f64::consts::FRAC_PI_2);
        assert_eq!(row.direction, Some([1, -1, 0, 1, 1, 1]));
        assert_eq!((row.t_min, row.line), (Some(5.0), 2));
        assert!(m.channels.time && m.channels.direction && !m.channels.payload);
        assert_eq!(m.joint_decimals, 2);
    }

    #[test]
    fn what_cannot_be_read_names_line_and_column() {
        let row = |cells: &str| read(&format!("{HEADER}\n{cells}\n")).unwrap_err().to_string();
        assert_eq!(row("0,0,0,0,0,0,1,two,3"), "line 2, column y_mm: 'two' is not a number");
        assert_eq!(row("0,0,NaN,0,0,0,1,2,3"), "line 2, column q3_deg: 'NaN' is not a number");
        assert_eq!(row("0,0,0,0,0,,1,2,3"), "line 2, column q6_deg: '' is not a number: the cell is empty");
        assert_eq!(row("0,0,0,0,0,0,1,2"), "line 2 has 8 cells, the header 9");
        assert_eq!(read(HEADER).unwrap_err(), MeasureError::NoRows);
        assert_eq!(read("").unwrap_err(), MeasureError::NoHeader);
        let seven = read(&format!("{HEADER},q7_deg\n")).unwrap_err();
        assert_eq!(seven, MeasureError::TooManyJoints { column: "q7_deg".to_owned() });
        let without = read("q1_deg,q2_deg\n1,2\n").unwrap_err().to_string();
        assert!(without.starts_with("column q3_deg is missing"), "{without}");
        let semicolons = read("q1_deg;q2_deg\n1;2\n").unwrap_err().to_string();
        assert!(semicolons.contains("separated by ';'"), "{semicolons}");
    }

    #[test]
    fn an_unknown_column_and_a_channel_with_gaps_are_warned_about_and_ignored() {
        let m = read(&format!("{HEADER},t_min,operator\n0,0,0,0,0,0,1,2,3,,me\n0,0,0,0,0,0,1,2,3,4,me\n"))
            .unwrap();
        let codes: Vec<&str> = m.warnings.iter().map(|w| w.code).collect();
        assert_eq!(codes, ["measure::unknown-column", "measure::gaps"]);
        assert!(!m.channels.time);
        assert_eq!(m.rows[1].t_min, None);
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

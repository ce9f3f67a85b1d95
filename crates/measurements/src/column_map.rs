//! Column maps: other programs' layouts as tables with our column names and units.
//!
//! A map says which of their columns is which of ours, how cells are divided, and in what units and conventions the
//! numbers are.

use super::column_names::{JOINTS, POINT, QUATERNION, SLIDES, known};
use super::error::missing_column;
use super::table::{Line, Table, is_nothing, names_separator};
use super::timestamp::{NoTime, TimestampFormat, over_midnight};
use super::{MeasureError, OwnNames, Rotation, own_names};
use csv::{ReaderBuilder, Trim};
use robot_model::units::{
    deg_from_rad, m_from_inch, m_from_mm, min_from_days, min_from_h, min_from_s, mm_from_m, rad_from_deg,
};
use serde::Deserialize;
use std::collections::BTreeMap;

/// A layout of a measurement table as other programs write it.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ColumnMap {
    /// What divides cells: one character, `tab`, or `blanks` (any number of blanks and tabs).
    #[serde(default = "comma")]
    delimiter: String,
    /// Numbers are written 1,5.
    #[serde(default)]
    decimal_comma: bool,
    /// The first line that counts names the columns.
    #[serde(default = "yes")]
    header: bool,
    /// Lines at the top that do not count.
    #[serde(default)]
    skip_lines: usize,
    /// Lines that begin so do not count.
    #[serde(default = "hash")]
    comment: String,
    /// Unit of lengths: mm, m, inch.
    #[serde(default)]
    length_unit: LengthUnit,
    /// Unit of joints: deg, rad.
    #[serde(default)]
    joint_unit: AngleUnit,
    /// Unit of time: min, s, h, d.
    #[serde(default)]
    time_unit: TimeUnit,
    /// Instead: how a date and time is written; minutes are then counted from the first row.
    time_format: Option<String>,
    /// Our names and theirs (or their numbers, from 1).
    columns: BTreeMap<String, SourceColumn>,
    /// Cells that are the same in every row.
    #[serde(default)]
    constant: BTreeMap<String, String>,
    /// A measured pose in six columns.
    pose: Option<PoseColumns>,
    /// Rows that are nests on base or floor.
    base_rows: Option<RowFilter>,
    /// Only rows like these count.
    only: Option<RowFilter>,
}

/// A table as another program wrote it.
struct SourceTable {
    /// Names of the columns, where the first line has them.
    header: Option<Vec<String>>,
    lines: Vec<Line>,
}

/// A column of theirs.
#[derive(Clone, Debug, Deserialize)]
#[serde(untagged)]
enum SourceColumn {
    Number(usize),
    Name(String),
}

impl SourceColumn {
    /// As messages name it.
    fn shown(&self) -> String {
        match self {
            Self::Number(n) => format!("number {n}"),
            Self::Name(name) => name.clone(),
        }
    }
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct PoseColumns {
    /// x, y, z and three angles.
    columns: [SourceColumn; 6],
    /// What the angles are.
    rotation: Rotation,
    /// Unit of the angles.
    #[serde(default)]
    angle_unit: AngleUnit,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct RowFilter {
    column: SourceColumn,
    is: Vec<String>,
}

#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq)]
#[serde(rename_all = "lowercase")]
enum LengthUnit {
    #[default]
    Mm,
    M,
    Inch,
}

#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq)]
#[serde(rename_all = "lowercase")]
enum AngleUnit {
    #[default]
    Deg,
    Rad,
}

#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq)]
#[serde(rename_all = "lowercase")]
enum TimeUnit {
    #[default]
    Min,
    S,
    H,
    D,
}

fn comma() -> String {
    ",".to_owned()
}

fn hash() -> String {
    "#".to_owned()
}

fn yes() -> bool {
    true
}

impl LengthUnit {
    fn m(self, value: f64) -> f64 {
        match self {
            Self::Mm => m_from_mm(value),
            Self::M => value,
            Self::Inch => m_from_inch(value),
        }
    }
}

impl AngleUnit {
    fn rad(self, value: f64) -> f64 {
        match self {
            Self::Deg => rad_from_deg(value),
            Self::Rad => value,
        }
    }
}

impl ColumnMap {
    /// Reads a map (TOML).
    ///
    /// # Errors
    /// What is wrong in it.
    pub fn from_toml(text: &str) -> Result<Self, MeasureError> {
        let map: Self = toml::from_str(text).map_err(|e| wrong(e.to_string()))?;
        let known = known();
        for name in map.columns.keys().chain(map.constant.keys()) {
            if !known.contains(&name.as_str()) {
                return Err(wrong(format!("{name} is no column of a measurement table")));
            }
        }
        if map.delimiter.len() != 1 && !["tab", "blanks"].contains(&map.delimiter.as_str()) {
            return Err(wrong("the delimiter is one character, \"tab\" or \"blanks\"".to_owned()));
        }
        if map.decimal_comma && map.delimiter == "," {
            return Err(wrong("commas cannot divide both cells and decimals".to_owned()));
        }
        Ok(map)
    }

    /// The table that `bytes` hold, with our names and units.
    ///
    /// # Errors
    /// A column that is not there, a cell that is no number.
    pub fn table(&self, bytes: &[u8]) -> Result<Table, MeasureError> {
        let SourceTable { header, lines } = self.cells(bytes)?;
        let find = |source: &SourceColumn| self.find(source, &header);
        let mut mapped = Vec::new();
        for (our_name, source) in &self.columns {
            mapped.push((our_name.as_str(), find(source)?));
        }
        let pose = match &self.pose {
            Some(pose) => Some((pose, self.pose_columns(pose, &header)?)),
            None => None,
        };
        let base = self.base_rows.as_ref().map(|w| Ok((find(&w.column)?, &w.is))).transpose()?;
        let only = self.only.as_ref().map(|w| Ok((find(&w.column)?, &w.is))).transpose()?;
        let timestamp = self.time_format.as_deref().map(TimestampFormat::new).transpose().map_err(wrong)?;

        let mut table = Table {
            header: mapped.iter().map(|(our_name, _)| (*our_name).to_owned()).collect(),
            lines: Vec::new(),
            own_names: self.own_names(),
        };
        table.header.extend(self.constant.keys().cloned());
        if pose.is_some() {
            table.header.extend(POINT.iter().chain(&QUATERNION).map(|&name| name.to_owned()));
        }
        if base.is_some() {
            table.header.push("kind".to_owned());
        }
        let mut start_min = None;
        let is_one = |line: &Line, (at, words): &(usize, &Vec<String>)| {
            line.cells.get(*at).is_some_and(|cell| words.iter().any(|w| w == cell))
        };
        for line in lines {
            if only.as_ref().is_some_and(|only| !is_one(&line, only)) {
                continue;
            }
            let mut cells = Vec::with_capacity(table.header.len());
            for (our_name, at) in &mapped {
                let cell = line.cells.get(*at).map_or("", String::as_str);
                cells.push(self.converted(
                    our_name,
                    cell,
                    line.number,
                    timestamp.as_ref(),
                    &mut start_min,
                )?);
            }
            cells.extend(self.constant.values().cloned());
            if let Some((pose, at)) = &pose {
                cells.extend(self.posed(pose, at, &line)?);
            }
            if let Some(base) = &base {
                cells.push(if is_one(&line, base) { "base" } else { "pose" }.to_owned());
            }
            table.lines.push(Line { number: line.number, cells });
        }
        if timestamp.is_some_and(|format| !format.has_date()) {
            count_days(&mut table);
        }
        Ok(table)
    }

    /// What the file calls our columns.
    fn own_names(&self) -> OwnNames {
        let columns = self.columns.iter().map(|(ours, source)| (ours.clone(), source.shown()));
        let Some(pose) = &self.pose else { return OwnNames::new(columns, None) };
        let (points, angles) = own_names::of_pose(pose.columns.each_ref().map(SourceColumn::shown));
        OwnNames::new(columns.chain(points), Some(angles))
    }

    /// Positions of the six columns of a pose.
    fn pose_columns(
        &self,
        pose: &PoseColumns,
        header: &Option<Vec<String>>,
    ) -> Result<[usize; 6], MeasureError> {
        let mut at = [0; 6];
        for (to, source) in at.iter_mut().zip(&pose.columns) {
            *to = self.find(source, header)?;
        }
        Ok(at)
    }

    /// Their names and cells.
    fn cells(&self, bytes: &[u8]) -> Result<SourceTable, MeasureError> {
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        let text = String::from_utf8_lossy(bytes);
        let mut header = None;
        let mut lines = Vec::new();
        for (index, text) in text.lines().enumerate().skip(self.skip_lines) {
            let is_comment = !self.comment.is_empty() && text.trim_start().starts_with(&self.comment);
            let is_first = index == self.skip_lines;
            if is_comment || text.trim().is_empty() || is_first && names_separator(text) {
                continue;
            }
            let cells = self.split(text, index as u64 + 1)?;
            if self.header && header.is_none() {
                header = Some(cells);
            } else {
                lines.push(Line { number: index as u64 + 1, cells });
            }
        }
        if self.header && header.is_none() {
            return Err(MeasureError::NoHeader);
        }
        Ok(SourceTable { header, lines })
    }

    fn split(&self, text: &str, line: u64) -> Result<Vec<String>, MeasureError> {
        let delimiter = match self.delimiter.as_str() {
            "blanks" => return Ok(text.split_whitespace().map(str::to_owned).collect()),
            "tab" => b'\t',
            one => one.bytes().next().unwrap_or(b','),
        };
        let mut reader = ReaderBuilder::new()
            .delimiter(delimiter)
            .has_headers(false)
            .flexible(true)
            .trim(Trim::All)
            .from_reader(text.as_bytes());
        let record = reader.records().next().transpose();
        let record = record
            .map_err(|error| MeasureError::NotCsv { line, problem: error.to_string() })?
            .unwrap_or_default();
        Ok(record.iter().map(str::to_owned).collect())
    }

    fn find(&self, source: &SourceColumn, header: &Option<Vec<String>>) -> Result<usize, MeasureError> {
        match (source, header) {
            (SourceColumn::Number(0), _) => Err(wrong("columns count from 1".to_owned())),
            (SourceColumn::Number(n), _) => Ok(n - 1),
            (SourceColumn::Name(name), None) => {
                Err(wrong(format!("without a header columns are numbers, not '{name}'")))
            }
            (SourceColumn::Name(name), Some(header)) => {
                let plain = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ").to_lowercase();
                header
                    .iter()
                    .position(|n| plain(n) == plain(name))
                    .ok_or_else(|| missing_column(name, header))
            }
        }
    }

    fn number(&self, column: &str, cell: &str, line: u64) -> Result<f64, MeasureError> {
        let text = if self.decimal_comma { cell.replace(',', ".") } else { cell.to_owned() };
        text.parse::<f64>().ok().filter(|v| v.is_finite()).ok_or_else(|| MeasureError::NotANumber {
            line,
            column: self.own_names().rename(column),
            text: cell.chars().take(40).collect(),
            hint: match (cell.contains(','), self.decimal_comma) {
                (true, false) => ": decimal_comma = true?",
                (true, true) => ": write it without separators of thousands",
                (false, _) => "",
            },
        })
    }

    /// A cell in our units; the text as it stands where nothing is to be done, and where it says that nothing was measured.
    fn converted(
        &self,
        our_name: &str,
        cell: &str,
        line: u64,
        timestamp: Option<&TimestampFormat>,
        start_min: &mut Option<f64>,
    ) -> Result<String, MeasureError> {
        let is_length = POINT.contains(&our_name) || SLIDES.contains(&our_name) || our_name == "length_mm";
        let is_text = ["id", "pose_id", "target", "kind", "fixed_id"].contains(&our_name);
        if is_text || is_nothing(cell) {
            return Ok(cell.to_owned());
        }
        if let (true, Some(timestamp)) = (our_name == "t_min", timestamp) {
            let text = || cell.chars().take(40).collect();
            let at_min = timestamp.parse_min(cell).map_err(|why| match why {
                NoTime::NotWrittenSo => {
                    MeasureError::NotATime { line, text: text(), format: timestamp.format().to_owned() }
                }
                NoTime::DoesNotExist => MeasureError::NoSuchTime { line, text: text() },
            })?;
            return Ok(format!("{}", at_min - *start_min.get_or_insert(at_min)));
        }
        let unchanged = match our_name {
            _ if is_length => self.length_unit == LengthUnit::Mm,
            "t_min" => self.time_unit == TimeUnit::Min,
            _ if JOINTS.contains(&our_name) => self.joint_unit == AngleUnit::Deg,
            _ => true,
        };
        if unchanged && !self.decimal_comma {
            return Ok(cell.to_owned());
        }
        let value = self.number(our_name, cell, line)?;
        if unchanged {
            return Ok(cell.replace(',', "."));
        }
        let value = match our_name {
            _ if is_length => mm_from_m(self.length_unit.m(value)),
            "t_min" => match self.time_unit {
                TimeUnit::Min => value,
                TimeUnit::S => min_from_s(value),
                TimeUnit::H => min_from_h(value),
                TimeUnit::D => min_from_days(value),
            },
            _ => deg_from_rad(self.joint_unit.rad(value)),
        };
        Ok(format!("{value}"))
    }

    /// x, y, z and a quaternion; empty where a cell says that there is nothing.
    fn posed(&self, pose: &PoseColumns, at: &[usize; 6], line: &Line) -> Result<Vec<String>, MeasureError> {
        let mut values = [0.0; 6];
        for (k, ((value, column), source)) in values.iter_mut().zip(at).zip(&pose.columns).enumerate() {
            let Some(cell) = line.cell(*column) else { return Ok(vec![String::new(); 7]) };
            let number = self.number(&source.shown(), cell, line.number)?;
            *value = if k < 3 { mm_from_m(self.length_unit.m(number)) } else { pose.angle_unit.rad(number) };
        }
        let [x, y, z, a, b, c] = values;
        let turn = pose.rotation.quaternion([a, b, c]);
        Ok([x, y, z, turn.w, turn.i, turn.j, turn.k].map(|v| format!("{v}")).to_vec())
    }
}

/// Counts the minutes of times of day on over midnight.
fn count_days(table: &mut Table) {
    let Some(column) = table.column("t_min") else { return };
    let mut cells: Vec<&mut String> = table
        .lines
        .iter_mut()
        .filter_map(|line| line.cells.get_mut(column))
        .filter(|cell| !is_nothing(cell))
        .collect();
    // They were written as numbers just before.
    let since_first_min: Vec<f64> = cells.iter().filter_map(|cell| cell.parse().ok()).collect();
    for (cell, t_min) in cells.iter_mut().zip(over_midnight(&since_first_min)) {
        **cell = format!("{t_min}");
    }
}

fn wrong(problem: String) -> MeasureError {
    MeasureError::Map { problem }
}

#[cfg(test)]
mod tests;

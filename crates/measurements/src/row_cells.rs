//! One line of a measurement table: its cells by column, checked one by one, as a row in SI units.

use super::column_names::{
    self, AIR, DIRECTIONS, FIXED, JOINTS, LENGTH, POINT, QUATERNION, SLIDES, TEMPERATURES, known,
};
use super::error::{missing_column, number_hint};
use super::table::Line;
use super::{MeasureError, MeasurementRow, Reading};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::robot::{Joints, MOST_JOINTS};
use robot_model::units::{celsius_from_kelvin, m_from_mm, rad_from_deg};
use std::collections::BTreeMap;

/// A quaternion whose length is further from 1 than this is no orientation.
const QUATERNION_LENGTH: f64 = 0.02;

/// A joint further from its zero than this, degrees or millimetres, is none.
const FURTHEST_JOINT: f64 = 1e5;
/// A coordinate or a length of more than this is none, millimetres.
const FURTHEST_MM: f64 = 1e8;

/// Where each known column stands.
pub(super) struct ColumnIndex {
    pub(super) at: BTreeMap<String, usize>,
    /// The joints' columns, joint 1 first.
    pub(super) joints: Vec<&'static str>,
    /// Columns of their directions and temperatures, as many, there or not.
    pub(super) directions: &'static [&'static str],
    pub(super) temperatures: &'static [&'static str],
    pub(super) warnings: Vec<Diagnostic>,
}

impl ColumnIndex {
    pub(super) fn new(header: &[String]) -> Result<Self, MeasureError> {
        let known = known();
        let mut at: BTreeMap<String, usize> = BTreeMap::new();
        let mut warnings = Vec::new();
        for (index, name) in header.iter().enumerate() {
            let name = name.to_ascii_lowercase();
            let of_joint = name.strip_prefix('q');
            let joint = of_joint.and_then(|rest| rest.strip_suffix("_deg").or(rest.strip_suffix("_mm")));
            if joint.and_then(|n| n.parse::<u32>().ok()).is_some_and(|n| n > MOST_JOINTS as u32) {
                return Err(MeasureError::TooManyJoints { column: name });
            }
            if !known.contains(&name.as_str()) {
                let shown: String = name.chars().take(40).collect();
                warnings.push(
                    Diagnostic::warning(
                        "measure::unknown-column",
                        format!("column '{shown}' is not known and is ignored"),
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
        let joints = column_names::joints(|name| at.contains_key(name));
        let joints = joints.map_err(|column| missing_column(column, header))?;
        for column in points {
            if !at.contains_key(*column) {
                return Err(missing_column(column, header));
            }
        }
        let (directions, temperatures) = (&DIRECTIONS[..joints.len()], &TEMPERATURES[..joints.len()]);
        let groups = [&QUATERNION[..], directions, temperatures];
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
        warnings.extend(unused(&at, &joints, directions, temperatures));
        Ok(Self { at, joints, directions, temperatures, warnings })
    }

    pub(super) fn has(&self, name: &str) -> bool {
        self.at.contains_key(name)
    }
}

/// The warnings of columns that are known and that nothing is made of.
fn unused(
    at: &BTreeMap<String, usize>,
    joints: &[&'static str],
    directions: &[&'static str],
    temperatures: &[&'static str],
) -> Vec<Diagnostic> {
    let of_joints = [joints, directions, temperatures].concat();
    let per_joint = [&JOINTS[..], &SLIDES, &DIRECTIONS, &TEMPERATURES].concat();
    let without_joint = |name: &&str| !of_joints.contains(name);
    let mut columns: Vec<(&str, String)> = per_joint
        .into_iter()
        .filter(without_joint)
        .map(|name| (name, format!("is of no joint of the {} that the file has", joints.len())))
        .collect();
    columns.push((AIR, "drives no effect".to_owned()));
    let there = columns.into_iter().filter(|(name, _)| at.contains_key(*name));
    there
        .map(|(name, why)| {
            let text = format!("column '{name}' {why} and is not used");
            Diagnostic::warning("measure::unused-column", text)
                .help("none is needed: the answer is the same without it")
        })
        .collect()
}

/// The cells of one line, by the names of their columns.
pub(super) struct RowCells<'a> {
    pub(super) columns: &'a ColumnIndex,
    pub(super) line: &'a Line,
}

impl RowCells<'_> {
    /// What a cell holds; `None` where its column is absent or it says that there is nothing.
    pub(super) fn text(&self, name: &str) -> Option<&str> {
        self.columns.at.get(name).and_then(|&index| self.line.cell(index))
    }

    /// As it stands in the file.
    fn as_written(&self, name: &str) -> &str {
        self.columns.at.get(name).and_then(|&index| self.line.cells.get(index)).map_or("", String::as_str)
    }

    /// Whether the column is there and its cell says that there is nothing.
    fn is_empty(&self, name: &str) -> bool {
        self.columns.has(name) && self.text(name).is_none()
    }

    fn is_base(&self) -> bool {
        self.text("kind").is_some_and(|kind| kind.eq_ignore_ascii_case("base"))
    }

    /// The first cell that the row cannot do without and that says that there is nothing.
    pub(super) fn absent(&self) -> Option<&'static str> {
        let first_empty = |names: &[&'static str]| names.iter().copied().find(|name| self.is_empty(name));
        let has_any = |names: &[&str]| names.iter().any(|name| self.text(name).is_some());
        if self.is_base() {
            return first_empty(&POINT);
        }
        let reading = match (has_any(&POINT), has_any(&[LENGTH, FIXED])) {
            (true, _) => first_empty(&POINT),
            (false, true) => None,
            (false, false) => first_empty(&POINT).or_else(|| first_empty(&[LENGTH, FIXED])),
        };
        first_empty(&self.columns.joints).or(reading)
    }

    /// Columns of what need not be there whose cell is empty.
    pub(super) fn empty_among_optional(&self) -> impl Iterator<Item = &'static str> {
        let single = ["t_min", "payload_kg"];
        let all = {
            let per_joint = self.columns.directions.iter().chain(self.columns.temperatures).copied();
            single.into_iter().chain(QUATERNION).chain(per_joint)
        };
        let no_turn = self.has_no_turn();
        all.filter(move |name| {
            self.is_empty(name) || no_turn && QUATERNION.contains(name) || self.is_no_temperature(name)
        })
    }

    /// Whether the column is one of temperatures, and its cell holds one that nothing has, -999 or 999.9 where a probe saw none.
    fn is_no_temperature(&self, name: &str) -> bool {
        let below = |text: &str| text.parse().is_ok_and(|value: f64| value < celsius_from_kelvin(0.0));
        let is_none = |text: &str| below(text) || is_all_nines(text);
        self.columns.temperatures.contains(&name) && self.text(name).is_some_and(is_none)
    }

    /// Four zeros are what an instrument writes that saw no orientation.
    fn has_no_turn(&self) -> bool {
        QUATERNION.iter().all(|name| self.text(name).is_some_and(|text| text.parse() == Ok(0.0)))
    }

    fn number(&self, name: &str) -> Result<f64, MeasureError> {
        let text = self.as_written(name);
        match text.parse::<f64>() {
            Ok(value) if value.is_finite() => Ok(value),
            _ => Err(MeasureError::NotANumber {
                line: self.line.number,
                column: name.to_owned(),
                text: text.chars().take(40).collect(),
                hint: number_hint(text),
            }),
        }
    }

    /// `None` where the column or the cell is absent.
    fn optional(&self, name: &str) -> Result<Option<f64>, MeasureError> {
        self.text(name).map(|_| self.number(name)).transpose()
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

    /// Numbers of one column for each joint; `None` where one is empty.
    fn per_joint(&self, names: &[&str]) -> Result<Option<Joints>, MeasureError> {
        names
            .iter()
            .map(|name| self.optional(name))
            .collect::<Result<Option<Vec<f64>>, _>>()
            .map(|values| values.filter(|values| !values.is_empty()).map(Joints::from_iter))
    }

    fn impossible(&self, column: &str, why: &'static str) -> MeasureError {
        MeasureError::Impossible {
            line: self.line.number,
            column: column.to_owned(),
            text: self.as_written(column).to_owned(),
            why,
        }
    }

    fn joints(&self) -> Result<Joints, MeasureError> {
        let joint = |name: &&'static str| {
            let written = self.number(name)?;
            if written.abs() > FURTHEST_JOINT {
                return Err(self.impossible(name, "no joint moves that far"));
            }
            Ok(if SLIDES.contains(name) { m_from_mm(written) } else { rad_from_deg(written) })
        };
        self.columns.joints.iter().map(joint).collect::<Result<Vec<f64>, _>>().map(Joints::from_iter)
    }

    fn length_m(&self, name: &str) -> Result<f64, MeasureError> {
        let mm = self.number(name)?;
        if mm.abs() > FURTHEST_MM {
            return Err(self.impossible(name, "no instrument reaches that far"));
        }
        Ok(m_from_mm(mm))
    }

    fn position_m(&self) -> Result<Vector3<f64>, MeasureError> {
        let [x, y, z] = POINT;
        Ok(Vector3::new(self.length_m(x)?, self.length_m(y)?, self.length_m(z)?))
    }

    /// Whether all joints are there; a nest is read without them, and without what is no number among them not.
    fn has_joints(&self) -> Result<bool, MeasureError> {
        let there: Vec<bool> = self
            .columns
            .joints
            .iter()
            .map(|name| self.optional(name).map(|value| value.is_some()))
            .collect::<Result<_, _>>()?;
        Ok(there.into_iter().all(|there| there))
    }

    /// What the row saw; `fixed_point` numbers fixed points by kind and name.
    pub(super) fn reading(
        &self,
        fixed_point: &mut dyn FnMut(&'static str, &str) -> usize,
    ) -> Result<Reading, MeasureError> {
        let kind = self.text("kind").unwrap_or_default();
        if self.is_base() {
            let name = [FIXED, "target", "pose_id", "id"].into_iter().find_map(|name| self.text(name));
            return Ok(Reading::Nest {
                fixed_point: fixed_point("nest", name.unwrap_or_default()),
                position_m: self.position_m()?,
                with_joints: self.has_joints()?,
            });
        }
        if !kind.is_empty() && !kind.eq_ignore_ascii_case("pose") {
            return Err(self.impossible("kind", "a kind is pose or base"));
        }
        if POINT.iter().any(|name| self.text(name).is_some()) {
            return Ok(Reading::Point { position_m: self.position_m()? });
        }
        if self.text(LENGTH).is_some() {
            let length_m = self.length_m(LENGTH)?;
            if length_m <= 0.0 {
                return Err(self.impossible(LENGTH, "a length is more than 0"));
            }
            return Ok(Reading::Length {
                fixed_point: fixed_point("wire", self.text(FIXED).unwrap_or_default()),
                length_m,
            });
        }
        if let Some(name) = self.text(FIXED) {
            return Ok(Reading::Touch { fixed_point: fixed_point("touched", name) });
        }
        let column = [POINT[0], LENGTH, FIXED].into_iter().find(|c| self.columns.has(c)).unwrap_or(POINT[0]);
        self.number(column).and(Err(self.impossible(column, "nothing was measured")))
    }

    /// The measured orientation, where the file has one; an instrument that saw none writes four zeros.
    fn orientation(&self) -> Result<Option<UnitQuaternion<f64>>, MeasureError> {
        let Some([w, x, y, z]) = self.optional_all(QUATERNION)?.filter(|_| !self.has_no_turn()) else {
            return Ok(None);
        };
        let quaternion = Quaternion::new(w, x, y, z);
        if (quaternion.norm() - 1.0).abs() > QUATERNION_LENGTH {
            return Err(self.impossible("qw", "the four numbers are not of length 1"));
        }
        Ok(Some(UnitQuaternion::from_quaternion(quaternion)))
    }

    /// The row, its pose not numbered yet.
    pub(super) fn row(&self, target: usize, reading: Reading) -> Result<MeasurementRow, MeasureError> {
        let q_rad = if reading.involves_arm() || self.has_joints()? {
            self.joints()?
        } else {
            Joints::all(self.columns.joints.len(), 0.0)
        };
        // A nest, a touch and a length turn nothing: what stands there is of the pose before, or of the hand that held the probe.
        let orientation = match reading {
            Reading::Point { .. } => self.orientation()?,
            Reading::Nest { .. } | Reading::Touch { .. } | Reading::Length { .. } => None,
        };
        let direction = match self.per_joint(self.columns.directions)? {
            None => None,
            Some(signs) => {
                let mut direction = signs.map(|_| 0_i8);
                for ((to, from), name) in direction.iter_mut().zip(signs).zip(self.columns.directions) {
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
        // A payload of a tonne in grams is a fault of the column, which is told as that.
        if payload_kg.is_some_and(|kg| !(0.0..1e7).contains(&kg)) {
            return Err(
                self.impossible("payload_kg", "a payload weighs 0 kg or more, and less than 10,000 t")
            );
        }
        Ok(MeasurementRow {
            line: self.line.number,
            // A name that comes back as it was written, whatever word it is.
            id: self.columns.has("id").then(|| self.as_written("id").to_owned()),
            pose_id: self.text("pose_id").map(str::to_owned),
            pose: 0,
            target,
            stand: 0,
            t_min: self.optional("t_min")?,
            earlier_min: 0.0,
            q_rad,
            reading,
            orientation,
            direction,
            payload_kg,
            joint_temperature_c: self
                .per_joint(self.columns.temperatures)?
                .filter(|_| !self.columns.temperatures.iter().any(|name| self.is_no_temperature(name))),
        })
    }
}

/// Whether a number of three digits before the point and more has no other digit than 9 but zeros behind the point.
fn is_all_nines(text: &str) -> bool {
    let (whole, behind) = text.split_once('.').unwrap_or((text, ""));
    let nines = |text: &str| text.bytes().all(|digit| digit == b'9');
    whole.len() >= 3 && nines(whole) && nines(behind.trim_end_matches('0'))
}

//! A TOML table whose keys are taken one by one, with messages that name the place.

use super::error::ModelError;
use crate::robot::{Axis, Joints, MOST_JOINTS};

/// A table whose keys are taken one by one; what is left at the end is not known.
pub(super) struct TableReader {
    place: String,
    left: toml::Table,
}

impl TableReader {
    /// The keys of the table that `place` names.
    pub(super) fn new(place: impl Into<String>, left: toml::Table) -> Self {
        Self { place: place.into(), left }
    }

    /// An error at `key`.
    pub(super) fn wrong(&self, key: &str, problem: String) -> ModelError {
        ModelError::Value { place: format!("{}, {key}", self.place), problem }
    }

    /// The text of `key`; `None` where it is missing.
    pub(super) fn text(&mut self, key: &str) -> Result<Option<String>, ModelError> {
        match self.left.remove(key) {
            None => Ok(None),
            Some(toml::Value::String(text)) => Ok(Some(text)),
            Some(_) => Err(self.wrong(key, "must be a text".to_owned())),
        }
    }

    /// The value of `key`, true or false.
    pub(super) fn boolean(&mut self, key: &str) -> Result<Option<bool>, ModelError> {
        match self.left.remove(key) {
            None => Ok(None),
            Some(toml::Value::Boolean(value)) => Ok(Some(value)),
            Some(_) => Err(self.wrong(key, "must be true or false".to_owned())),
        }
    }

    /// The whole number of `key`; `None` where it is missing.
    pub(super) fn integer(&mut self, key: &str) -> Result<Option<i64>, ModelError> {
        match self.left.remove(key) {
            None => Ok(None),
            Some(toml::Value::Integer(value)) => Ok(Some(value)),
            Some(_) => Err(self.wrong(key, "must be a whole number".to_owned())),
        }
    }

    /// One of `joints` joints.
    pub(super) fn joint(&mut self, key: &str, joints: usize) -> Result<Option<Axis>, ModelError> {
        let Some(number) = self.integer(key)? else { return Ok(None) };
        let axis = usize::try_from(number).ok().and_then(Axis::numbered);
        match axis.filter(|axis| axis.index() < joints) {
            Some(axis) => Ok(Some(axis)),
            None => Err(self.wrong(key, format!("{number} is not 1 to {joints}"))),
        }
    }

    fn float(&self, key: &str, value: &toml::Value) -> Result<f64, ModelError> {
        let value = match value {
            toml::Value::Float(value) => *value,
            toml::Value::Integer(value) => *value as f64,
            _ => return Err(self.wrong(key, "must be a number".to_owned())),
        };
        if value.is_finite() { Ok(value) } else { Err(self.wrong(key, "must be finite".to_owned())) }
    }

    /// The finite number of `key`; `None` where it is missing.
    pub(super) fn number(&mut self, key: &str) -> Result<Option<f64>, ModelError> {
        self.left.remove(key).map(|value| self.float(key, &value)).transpose()
    }

    /// Numbers; none where the key is missing.
    pub(super) fn list(&mut self, key: &str) -> Result<Vec<f64>, ModelError> {
        match self.left.remove(key) {
            None => Ok(Vec::new()),
            Some(toml::Value::Array(values)) => values.iter().map(|v| self.float(key, v)).collect(),
            Some(_) => Err(self.wrong(key, "must be a list of numbers".to_owned())),
        }
    }

    /// The `N` numbers of `key`; `None` where it is missing.
    pub(super) fn numbers<const N: usize>(&mut self, key: &str) -> Result<Option<[f64; N]>, ModelError> {
        let there = self.left.contains_key(key);
        let values = self.list(key)?;
        match <[f64; N]>::try_from(values) {
            Ok(values) => Ok(Some(values)),
            Err(_) if !there => Ok(None),
            Err(values) => {
                Err(self.wrong(key, format!("{N} numbers are needed, there are {}", values.len())))
            }
        }
    }

    /// `N` numbers that must be there.
    pub(super) fn required<const N: usize>(&mut self, key: &str) -> Result<[f64; N], ModelError> {
        self.numbers(key)?.ok_or_else(|| self.wrong(key, "missing".to_owned()))
    }

    /// One number for each of `joints` joints, which must be there.
    pub(super) fn per_joint(&mut self, key: &str, joints: usize) -> Result<Joints, ModelError> {
        let values = self.list(key)?;
        if values.len() != joints.min(MOST_JOINTS) {
            return Err(self.wrong(key, format!("{joints} numbers are needed, there are {}", values.len())));
        }
        Ok(values.into_iter().collect())
    }

    /// Texts; `None` where the key is missing.
    pub(super) fn texts(&mut self, key: &str) -> Result<Option<Vec<String>>, ModelError> {
        let wrong = || self.wrong(key, "must be a list of texts".to_owned());
        match self.left.get(key) {
            None => return Ok(None),
            Some(toml::Value::Array(all)) if all.iter().all(toml::Value::is_str) => {}
            Some(_) => return Err(wrong()),
        }
        let Some(toml::Value::Array(all)) = self.left.remove(key) else { return Ok(None) };
        Ok(Some(all.iter().filter_map(|text| text.as_str().map(str::to_owned)).collect()))
    }

    /// Ranges [low, high], one for each of `joints` joints.
    pub(super) fn ranges(
        &mut self,
        key: &str,
        joints: usize,
    ) -> Result<Option<Joints<[f64; 2]>>, ModelError> {
        let Some(value) = self.left.remove(key) else { return Ok(None) };
        let wrong = || self.wrong(key, format!("{joints} ranges [low, high] are needed"));
        let rows = value.as_array().filter(|rows| rows.len() == joints).ok_or_else(wrong)?;
        let mut ranges = Joints::all(joints, [0.0; 2]);
        for (range, row) in ranges.iter_mut().zip(rows) {
            let [low, high] = row.as_array().map(Vec::as_slice).unwrap_or_default() else {
                return Err(wrong());
            };
            *range = [self.float(key, low)?, self.float(key, high)?];
        }
        Ok(Some(ranges))
    }

    /// The table of `key`; `None` where it is missing.
    pub(super) fn table(&mut self, key: &str) -> Result<Option<Self>, ModelError> {
        match self.left.remove(key) {
            None => Ok(None),
            Some(toml::Value::Table(table)) => Ok(Some(Self::new(format!("[{key}]"), table))),
            Some(_) => Err(self.wrong(key, "must be a table".to_owned())),
        }
    }

    /// The tables `[[key]]`; none where there are none.
    pub(super) fn tables(&mut self, key: &str) -> Result<Vec<toml::Table>, ModelError> {
        let wrong = || self.wrong(key, "must be tables, [[effect]]".to_owned());
        match self.left.get(key) {
            None => return Ok(Vec::new()),
            Some(toml::Value::Array(all)) if all.iter().all(toml::Value::is_table) => {}
            Some(_) => return Err(wrong()),
        }
        let Some(toml::Value::Array(all)) = self.left.remove(key) else { return Ok(Vec::new()) };
        Ok(all
            .into_iter()
            .filter_map(|v| if let toml::Value::Table(t) = v { Some(t) } else { None })
            .collect())
    }

    /// Everything must have been taken.
    pub(super) fn finish(self) -> Result<(), ModelError> {
        match self.left.keys().next() {
            None => Ok(()),
            Some(key) => Err(self.wrong(key, "is not known here".to_owned())),
        }
    }
}

//! What goes wrong when a measurement file is put together: cells as they are written in place of those that were meant.

use super::effect::{Effect, SizedEffect};
use super::row_fault::RowFault;
use nalgebra::Point3;
use robot_model::units::{deg_from_rad, fahrenheit_from_celsius, g_from_kg, inch_from_m, mm_from_m};

/// The joint that is in radians, counted from 0.
const RADIANS: usize = 2;
/// The beam is lost for one in so many rows.
const FROZEN: usize = 8;
/// A controller's screen shows joints in steps of one in so many of a degree.
const STEPS_A_DEGREE: f64 = 20.0;

/// The faults of one file.
pub(super) struct FileFaults {
    rounded: bool,
    swapped: bool,
    /// A fault of rows or columns, with the first row that has it.
    of_rows: Option<(RowFault, usize)>,
    rows: usize,
}

impl FileFaults {
    pub(super) fn of(effects: &[SizedEffect], rows: usize) -> Self {
        let has = |wanted: fn(&Effect) -> bool| effects.iter().any(|sized| wanted(&sized.effect));
        Self {
            rounded: has(|e| matches!(e, Effect::JointRounding)),
            swapped: has(|e| matches!(e, Effect::SwappedAxes)),
            of_rows: effects.iter().find_map(|sized| match sized.effect {
                Effect::RowFault { fault, from } => Some((fault, (from * rows as f64) as usize)),
                _ => None,
            }),
            rows,
        }
    }

    fn has(&self, wanted: RowFault) -> bool {
        self.of_rows.is_some_and(|(fault, _)| fault == wanted)
    }

    /// The row whose point stands in row `k`; `None`: no row's.
    pub(super) fn point_of(&self, k: usize) -> Option<usize> {
        match self.of_rows {
            Some((RowFault::Frozen, from)) if (from..from + self.rows / FROZEN).contains(&k) => Some(from),
            Some((RowFault::OneLate, from)) if k > from => Some(k - 1),
            Some((RowFault::OneEarly, from)) if k >= from => (k + 1 < self.rows).then_some(k + 1),
            _ => Some(k),
        }
    }

    /// The three cells of a point in row `k`, each after a comma; empty cells of no point.
    pub(super) fn point_cells(&self, k: usize, point_m: Option<&Point3<f64>>) -> String {
        let Some(point_m) = point_m else { return ",,,".to_owned() };
        let [x, y, z] = [point_m.x, point_m.y, point_m.z];
        let [x, y, z] = match self.of_rows {
            Some((RowFault::Metres, from)) if k >= from => [x, y, z],
            Some((RowFault::RowsInInches, from)) if k >= from => [x, y, z].map(inch_from_m),
            Some((RowFault::Inches, _)) => [inch_from_m(x), mm_from_m(y), mm_from_m(z)],
            _ => [x, y, z].map(mm_from_m),
        };
        if self.swapped { format!(",{y:.4},{x:.4},{z:.4}") } else { format!(",{x:.4},{y:.4},{z:.4}") }
    }

    /// The cell of joint `j`, counted from 0.
    pub(super) fn joint_cell(&self, j: usize, q_rad: f64, slides: bool) -> String {
        let cell = match slides {
            true => mm_from_m(q_rad),
            false if j == RADIANS && self.has(RowFault::Radians) => q_rad,
            false => deg_from_rad(q_rad),
        };
        if self.has(RowFault::FineRounding) {
            return format!("{:.2}", (cell * STEPS_A_DEGREE).round() / STEPS_A_DEGREE);
        }
        if self.rounded { format!("{cell:.1}") } else { format!("{cell:.6}") }
    }

    /// The number in `pose_id` of a row at this pose.
    pub(super) fn pose(&self, pose: usize) -> usize {
        if self.has(RowFault::OnePose) { 0 } else { pose }
    }

    /// What stands in the column of a payload of so many kilograms.
    pub(super) fn payload(&self, payload_kg: f64) -> f64 {
        if self.has(RowFault::Grams) { g_from_kg(payload_kg) } else { payload_kg }
    }

    /// What stands in a thermometer's column at so many degrees Celsius.
    pub(super) fn temperature(&self, celsius: f64) -> f64 {
        if self.has(RowFault::Fahrenheit) { fahrenheit_from_celsius(celsius) } else { celsius }
    }
}

//! Few points measured again and again while a robot warms up: fixed points touched (`fixed_id`), or poses seen by a tracker.

use super::check::copied_rows;
use super::{Measurements, Reading};
use nalgebra::Vector3;
use rapid_syntax::diagnostic::{Diagnostic, counted, is_or_are};

/// One touch of a point, in SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct Touch {
    /// Line in the file, from 1.
    pub line: u64,
    /// Which point, index into [`Touches::points`].
    pub point: usize,
    /// Minutes since the cold start.
    pub t_min: f64,
    /// Joint angles, joint 1 first, radians.
    pub q_rad: [f64; 6],
    /// The measured point in the instrument's frame; `None` where a fixed point was touched.
    pub measured_m: Option<Vector3<f64>>,
}

/// A file of touches.
#[derive(Clone, Debug, Default)]
pub struct Touches {
    /// In order of time.
    pub touches: Vec<Touch>,
    /// Names of the points.
    pub points: Vec<String>,
    /// What a person should look at: rows without a reading, minutes that do not fit among the others.
    pub warnings: Vec<Diagnostic>,
}

impl Touches {
    /// The touches of a whole measurement file, pose by pose.
    #[must_use]
    pub fn of_poses(measurements: &Measurements) -> Option<Self> {
        let mut touches = Vec::with_capacity(measurements.rows.len());
        let mut last = 0;
        let nests = measurements.rows.iter().filter(|row| matches!(row.reading, Reading::Nest { .. }));
        let nests: Vec<u64> = nests.map(|row| row.line).collect();
        for row in &measurements.rows {
            let Reading::Point { position_m } = row.reading else { continue };
            last = last.max(row.pose);
            touches.push(Touch {
                line: row.line,
                point: row.pose,
                t_min: row.t_min?,
                q_rad: row.q_rad.array()?,
                measured_m: Some(position_m),
            });
        }
        sorting::by(&mut touches, |a, b| a.t_min.total_cmp(&b.t_min).then(a.line.cmp(&b.line)));
        let mut points: Vec<String> = (0..=last).map(|k| format!("pose {}", k + 1)).collect();
        for row in measurements.rows.iter().rev() {
            if let (Some(name), Some(point)) = (&row.pose_id, points.get_mut(row.pose)) {
                point.clone_from(name);
            }
        }
        let warnings = measurements.warnings.iter().cloned().chain(without_nests(&nests)).collect();
        Some(Self { touches, points, warnings })
    }

    /// Minutes of the first and the last touch.
    pub fn span_min(&self) -> [f64; 2] {
        [self.touches.first(), self.touches.last()].map(|touch| touch.map_or(0.0, |touch| touch.t_min))
    }

    /// Leaves out touches that repeat an earlier one to the last digit: a copied row makes the noise look smaller.
    pub(super) fn leave_out_copies(&mut self) {
        let mut copies: Vec<u64> = Vec::new();
        let mut distinct: Vec<Touch> = Vec::with_capacity(self.touches.len());
        for touch in std::mem::take(&mut self.touches) {
            // In order of time: what repeats a touch stands among those of its minute.
            let same_minute = distinct.iter().rev().take_while(|earlier| earlier.t_min == touch.t_min);
            if same_minute.into_iter().any(|earlier| Touch { line: touch.line, ..earlier.clone() } == touch) {
                copies.push(touch.line);
            } else {
                distinct.push(touch);
            }
        }
        self.touches = distinct;
        sorting::ascending(&mut copies);
        self.warnings.extend(copied_rows(&copies));
    }
}

/// That nests are no matter of how an arm drifts.
fn without_nests(lines: &[u64]) -> Option<Diagnostic> {
    (!lines.is_empty()).then(|| {
        let text = format!("{} of nests (kind = base) {} left out", counted(lines.len(), "row"), is_or_are(lines.len()));
        Diagnostic::warning("measure::no-reading", text)
            .help("a warm-up is fitted to what the arm carries; `driftpost diagnose` tells by nests whether the base or the instrument moved")
    })
}

//! What a diagnosis says, in the units of its files: mm, degrees, minutes. The JSON contract.

use inference::cause::Cause;
use inference::missing_channel::MissingChannel;
use inference::size_unit::SizeUnit;
use inference::time_course::TimeCourse;
use measurements::{Fault, FaultKind};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::EffectKind;
pub use robot_model::deform::identified::Verdict;
use robot_model::robot::{Axis, Joints};
use serde::Serialize;

/// Where the gap lies.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Location {
    /// Joint or link where it lies; `None` where it is of no single one.
    pub joint: Option<Axis>,
    /// How it shows over time; `None` where there is no gap.
    pub time: Option<TimeCourse>,
    /// Where in the workspace (robot's base) it is largest.
    pub region: Region,
}

/// A ball in the robot's base.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Region {
    /// Centre of the ball, mm.
    pub center_mm: [f64; 3],
    /// Radius of the ball, mm.
    pub radius_mm: f64,
}

/// How far the gap shrinks on poses that were held out.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct ErrorReduction {
    /// rms with registration only, mm.
    pub before_rms_mm: Option<f64>,
    /// With all that the model holds: causes, and the geometry behind them.
    pub after_rms_mm: Option<f64>,
    /// With the named causes alone.
    pub causes_only_rms_mm: Option<f64>,
    /// rms that noise alone leaves, mm.
    pub floor_rms_mm: Option<f64>,
    /// rms after over rms before.
    pub ratio: Option<f64>,
    /// 90 % interval of the ratio.
    pub ci90: Option<[f64; 2]>,
    /// The same with the last part of the time held out.
    pub time_block: Option<HeldOutBlock>,
    /// The same with a region of the workspace held out.
    pub region_block: Option<HeldOutBlock>,
}

/// One block held out.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct HeldOutBlock {
    /// Number of stations in the block.
    pub n: usize,
    /// rms with registration only, mm.
    pub before_rms_mm: f64,
    /// With all that the model holds.
    pub after_rms_mm: f64,
    /// With the named causes alone.
    pub causes_only_rms_mm: f64,
}

/// A pose worth measuring.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct NextMeasurement {
    /// Joints, joint 1 first, degrees; mm where one slides.
    pub q_deg: Joints,
    /// Mass of the payload as declared, kg.
    pub payload_kg: f64,
    /// Sign of each joint's last motion.
    pub dir: Joints<i8>,
}

/// What the next measurements are good for.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct NextStep {
    /// What they decide, as a phrase.
    pub reason: String,
    /// The slot whose causes they part; `None`: no cause was found.
    pub slot: Option<usize>,
    /// Rows in all, 0 where further poses cannot tell.
    pub rows: usize,
    /// Readings of each pose.
    pub readings_per_pose: usize,
    /// Nests on the base that are read at each pose, with the arm's joints in their rows; 0: none.
    pub base_nests: usize,
    /// To be measured on a new warm-up, from a cold start.
    pub from_cold: bool,
    /// By how much the ln odds of the right cause over the nearest wrong one are expected to grow.
    pub log_odds_gained: f64,
    /// Whether that is expected to decide.
    pub decides: bool,
    /// What can tell besides, or in place of, further poses.
    pub other_means: Option<String>,
}

/// An effect, or some of its joints, that these data cannot show.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Untestable {
    /// Kind of the effect, which names it.
    pub effect: EffectKind,
    /// Joints; empty = the whole effect.
    pub joints: Vec<Axis>,
    /// Why these data cannot show it.
    pub reason: String,
    /// Whether the file lacks the column that drives it: no pose would show it.
    #[serde(skip)]
    pub lacks_channel: bool,
}

/// What size of an effect would have been seen.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Detectable {
    /// Kind of the effect, which names it.
    pub effect: EffectKind,
    /// Joint that it sits in, or link; `None` for effects of the whole arm, its base or its target.
    pub joint: Option<Axis>,
    /// Smallest size that would have passed the alarm.
    pub size: f64,
    /// Unit of that size.
    pub unit: SizeUnit,
}

/// The noise, as found.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct NoiseEstimate {
    /// One coordinate, from repeats or as stated; `None` where neither is there.
    pub repeats_sigma_mm: Option<f64>,
    /// Degrees of freedom of the repeats.
    pub repeats_freedom: usize,
    /// One coordinate, as the best model leaves it.
    pub model_sigma_mm: Option<f64>,
    /// One coordinate of what the targets of a pose share: the arm did not stand there as it usually does. `None` where
    /// no pose was seen with several targets, or nothing is shared.
    pub shared_sigma_mm: Option<f64>,
    /// Scatter left over scatter expected, squared.
    pub reduced_chi_square: Option<f64>,
    /// Size of all joints' geometry errors together, in tolerances (0.15 mm, 0.25 mrad).
    pub geometry_tolerances: Option<f64>,
}

/// Residuals of one row's station.
#[derive(Clone, Debug, PartialEq)]
pub struct RowResidual {
    /// Line in the file.
    pub line: u64,
    /// `id` of the row.
    pub id: Option<String>,
    /// Joints, joint 1 first, degrees; mm where one slides.
    pub q_deg: Joints,
    /// Minutes since cold start.
    pub t_min: Option<f64>,
    /// The measured point in the base, as the nominal arm predicts it with the target at `tool_mm`.
    pub point_mm: [f64; 3],
    /// Measured minus predicted in the base, registration only.
    pub before_mm: [f64; 3],
    /// With causes and geometry.
    pub after_mm: [f64; 3],
    /// Whether the row was set aside as false.
    pub outlier: bool,
}

/// A joint's zero, where zeros were all that is wrong.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct JointZero {
    /// The joint whose zero it is.
    pub joint: Axis,
    /// By how much it would be off.
    pub offset_rad: f64,
}

/// What the joints' zeros alone would take of the gap.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct JointZeros {
    /// With base and target alone.
    pub before_rms_mm: f64,
    /// With the zeros beside them.
    pub after_rms_mm: f64,
    /// Those that these data can show.
    pub joints: Vec<JointZero>,
}

/// A row set aside as false.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FalseRow {
    /// Line in the file.
    pub line: u64,
    /// `id` of the row.
    pub id: Option<String>,
    /// Distance from the best model; none where it disagrees with its own repeats.
    pub off_mm: Option<f64>,
    /// That distance over the middle one of all rows.
    pub times_middle: Option<f64>,
    /// What would make it so, where one thing would.
    pub looks_like: Option<String>,
}

/// All that a diagnosis says of a data set.
#[derive(Clone, Debug, Serialize)]
pub struct Findings {
    /// The verdict in one word.
    pub verdict: Verdict,
    /// The verdict in one sentence.
    pub reason: String,
    /// Of a file that contradicts itself or the robot: kind, columns and lines.
    pub fault: Option<Fault>,
    /// Causes in order of probability, the likeliest first.
    pub causes: Vec<Cause>,
    /// Where the gap lies: joint, time, region.
    #[serde(rename = "where")]
    pub location: Location,
    /// The column that is not in the file and would tell what the gap follows, where that is known.
    pub missing_channel: Option<MissingChannel>,
    /// How far the gap shrinks on held-out poses.
    pub shrink: ErrorReduction,
    /// Effects that these data cannot show.
    pub untestable: Vec<EffectKind>,
    /// Why, and which joints.
    pub untestable_detail: Vec<Untestable>,
    /// What to measure next.
    pub next_measurements: Vec<NextMeasurement>,
    /// What they are good for, as a phrase.
    pub next_reason: String,
    /// How many rows, and what they would decide.
    pub next_step: NextStep,
    /// The noise as known and as found.
    pub noise: NoiseEstimate,
    /// Rows read.
    pub rows: usize,
    /// Number of stations used.
    pub stations: usize,
    /// Likeliest other explanations, that were found wanting.
    #[serde(rename = "rivals")]
    pub alternatives: Vec<Cause>,
    /// What size would have been seen.
    pub detectable: Vec<Detectable>,
    /// Lines set aside as false.
    pub false_lines: Vec<u64>,
    /// The same rows with their names, how far off, and what that looks like.
    pub false_rows: Vec<FalseRow>,
    /// Of an arm that was never calibrated: what its joints' zeros alone would take.
    pub zeros_alone: Option<JointZeros>,
    /// Place of the target on the flange, as fitted.
    pub tool_mm: Option<[f64; 3]>,
    /// Warnings of reading and judging the data.
    pub warnings: Vec<Warning>,
    /// Why no model is made of what was found, where one was asked for and that is so; or why one would not be, where that shows without.
    pub no_model: Option<String>,
    /// Residuals of every row, before and after; not in the JSON.
    #[serde(skip)]
    pub residuals: Vec<RowResidual>,
}

/// A warning in JSON.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Warning {
    /// Stable code, listed in docs/MESSAGES.md.
    pub code: &'static str,
    /// The message as a sentence.
    pub message: String,
}

impl From<&Diagnostic> for Warning {
    fn from(d: &Diagnostic) -> Self {
        let help = d.help.as_ref().map_or_else(String::new, |h| format!("; {h}"));
        Self { code: d.code, message: format!("{}{help}", d.message) }
    }
}

impl Findings {
    /// What is said of a file that contradicts itself or the robot.
    #[must_use]
    pub(super) fn of_fault(fault: Fault) -> Self {
        let kind = match fault.kind {
            FaultKind::SwappedAxes => Some(EffectKind::SwappedAxes),
            FaultKind::RoundedJoints => Some(EffectKind::JointRounding),
            _ => None,
        };
        Self {
            causes: kind.map(|kind| Cause::of(kind, 1.0)).into_iter().collect(),
            fault: Some(fault.clone()),
            ..Self::without_causes(Verdict::DataFault, fault.reason)
        }
    }

    /// Hands each sentence and phrase for people to `visit`, which may change it.
    pub fn visit_texts(&mut self, mut visit: impl FnMut(&mut String)) {
        let Self { reason, fault, no_model, next_reason, next_step, .. } = self;
        let Self { untestable_detail, false_rows, warnings, .. } = self;
        let NextStep { reason: next_step_reason, other_means, .. } = next_step;
        let fault = fault.iter_mut().flat_map(|fault| fault.column.iter_mut().chain([&mut fault.reason]));
        let one_by_one =
            [reason, next_reason, next_step_reason].into_iter().chain(no_model).chain(other_means);
        let untestable = untestable_detail.iter_mut().map(|entry| &mut entry.reason);
        let false_rows = false_rows.iter_mut().filter_map(|row| row.looks_like.as_mut());
        let warnings = warnings.iter_mut().map(|warning| &mut warning.message);
        one_by_one.chain(fault).chain(untestable).chain(false_rows).chain(warnings).for_each(&mut visit);
    }

    /// An answer without causes.
    #[must_use]
    pub fn without_causes(verdict: Verdict, reason: impl Into<String>) -> Self {
        Self {
            verdict,
            reason: reason.into(),
            fault: None,
            causes: Vec::new(),
            location: Location::default(),
            missing_channel: None,
            shrink: ErrorReduction::default(),
            untestable: Vec::new(),
            untestable_detail: Vec::new(),
            next_measurements: Vec::new(),
            next_reason: String::new(),
            next_step: NextStep::default(),
            noise: NoiseEstimate::default(),
            rows: 0,
            stations: 0,
            alternatives: Vec::new(),
            detectable: Vec::new(),
            false_lines: Vec::new(),
            false_rows: Vec::new(),
            zeros_alone: None,
            tool_mm: None,
            warnings: Vec::new(),
            no_model: None,
            residuals: Vec::new(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_text_for_people_is_kept_from_who_visits_them() {
        let text = || "t_min".to_owned();
        let mut found = Findings {
            no_model: Some(text()),
            next_reason: text(),
            next_step: NextStep { reason: text(), other_means: Some(text()), ..NextStep::default() },
            untestable_detail: vec![Untestable {
                effect: EffectKind::Backlash,
                joints: Vec::new(),
                reason: text(),
                lacks_channel: true,
            }],
            false_rows: vec![FalseRow {
                line: 2,
                id: None,
                off_mm: None,
                times_middle: None,
                looks_like: Some(text()),
            }],
            warnings: vec![Warning { code: "measure::gaps", message: text() }],
            ..Findings::of_fault(Fault::of_all(FaultKind::ColumnUnits, Some("t_min"), "t_min"))
        };
        found.visit_texts(|text| *text = text.replace("t_min", "clock"));
        let all = format!("{found:?}");
        assert!(!all.contains("\"t_min\"") && all.matches("\"clock\"").count() == 10, "{all}");
    }
}

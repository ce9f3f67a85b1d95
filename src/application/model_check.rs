//! An identified model on measurements that it has not seen.

use super::other_robot::model_of_another_robot;
use crate::report::{notes, validation as report};
use measurements::{
    Channels, Fault, FaultKind, MeasurementRow, Measurements, OneStand, check_rows, find_pose_names,
    from_sound_file,
};
use metrology::diagnose::{RefitScope, ValidateError, Validation, validate, warming};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::identified::Identified;
use robot_model::robot::SerialArm;
use std::borrow::Cow;
use warm_up::{Standstill, TimedReading, is_late_start, long_gaps, pauses};

/// Checks an identified model against measurements that took no part in its fit.
#[derive(Clone, Debug)]
pub struct ModelCheck {
    /// The robot as its nominal model says.
    pub robot: SerialArm,
    /// The model that is put to the test.
    pub model: Identified,
    /// What of base and tool is fitted again; the rest is the model's.
    pub refit: RefitScope,
    /// The largest rms distance that passes, mm.
    pub limit_mm: Option<f64>,
    /// When the robot stood; `None`: in the long pauses between rows, where the model leaves less so.
    pub stops: Option<Vec<Standstill>>,
}

impl ModelCheck {
    /// A test without a limit, base and tool fitted again.
    #[must_use]
    pub fn new(robot: impl Into<SerialArm>, model: Identified) -> Self {
        Self { robot: robot.into(), model, refit: RefitScope::BaseAndTool, limit_mm: None, stops: None }
    }

    /// What says that the model is of another robot.
    #[must_use]
    pub fn warning(&self) -> Option<Diagnostic> {
        model_of_another_robot(&self.model, &self.robot.name, &self.robot.geometry())
    }

    /// What says that a file of this SHA-256 is the one that the model was fitted to.
    #[must_use]
    pub fn seen_before(&self, sha256: &str) -> Option<Diagnostic> {
        let text = format!(
            "these are the measurements that the model was fitted to ({}): what it leaves of them says nothing of others",
            self.model.data
        );
        let help = "validate it on poses that took no part in the fit, or on another day's";
        (self.model.data_sha256 == sha256).then(|| Diagnostic::warning("model::same-data", text).help(help))
    }

    /// What model and nominal robot leave of the measured distances.
    ///
    /// # Errors
    /// [`ValidateError`]
    pub fn run(&self, measurements: &Measurements) -> Result<ModelChecked, ValidateError> {
        let checked = check_rows(measurements, &self.robot);
        // What would speak against any model is no fault of this one.
        let (seen, used, of_stand) = match from_sound_file(measurements, &self.robot, &checked) {
            Ok(OneStand { measurements, used, warnings, .. }) => (measurements, used, warnings),
            Err(fault) if is_no_reading_of(&fault) => {
                let warning = Diagnostic::warning("measure::fault", fault.reason);
                (Cow::Borrowed(measurements), checked.used.clone(), vec![warning])
            }
            Err(fault) => return Err(ValidateError::Joints { reason: fault.reason }),
        };
        if let Some(fault) = find_pose_names(measurements, &checked.used) {
            return Err(ValidateError::Joints { reason: fault.reason });
        }
        let WithStops { validation, stops, warning } = self.with_stops((&seen, &used))?;
        let left_out = validation.left_out.clone();
        let of_rows = checked.warnings.into_iter().chain(of_stand).chain(left_out).chain(warning);
        let missing = missing_columns(&self.model, measurements.channels);
        let warnings = measurements.warnings.iter().cloned().chain(of_rows).chain(missing).collect();
        let stops_are_named = self.stops.is_some();
        Ok(ModelChecked { validation, stops, stops_are_named, warnings, limit_mm: self.limit_mm })
    }

    /// What the model leaves where the robot stood as is named, or in the long pauses between rows, as far as its drift follows the robot's
    /// warmth.
    fn with_stops(&self, seen: (&Measurements, &[usize])) -> Result<WithStops, ValidateError> {
        let check = |stops: &[Standstill]| validate(seen, &self.robot, &self.model, self.refit, stops);
        let Some((law, _)) = warming(&self.model) else {
            let has_no_use = self.stops.as_ref().is_some_and(|stops| !stops.is_empty()).then(no_law);
            return Ok(WithStops { validation: check(&[])?, stops: Vec::new(), warning: has_no_use });
        };
        let has_sessions = seen.0.rows.iter().any(|row| row.earlier_min > 0.0);
        if let Some(named) = &self.stops {
            let stops = Standstill::merged(named.clone());
            let warning = (has_sessions && !stops.is_empty()).then(in_each_session);
            return Ok(WithStops { validation: check(&stops)?, stops, warning });
        }
        // What one day measures fills the pause of another.
        if has_sessions {
            return Ok(WithStops { validation: check(&[])?, stops: Vec::new(), warning: None });
        }
        let readings = readings(seen.0);
        let worked = check(&[])?;
        let t_min: Vec<f64> = readings.iter().map(|reading| reading.0).collect();
        let mut histories = vec![pauses(&readings)];
        // Poses that are measured once have no rounds that tell a stop.
        histories.extend(Some(long_gaps(&t_min)).filter(|gaps| gaps.len() > histories[0].len()));
        histories.retain(|stops| !stops.is_empty());
        if histories.is_empty() {
            let first_min = readings.first().map_or(0.0, |reading| reading.0);
            let is_late = law.tau_min().is_some_and(|tau_min| is_late_start(first_min, tau_min));
            let warning = is_late.then(|| late(first_min));
            return Ok(WithStops { validation: worked, stops: Vec::new(), warning });
        }
        let mut checked = Vec::new();
        for stops in histories {
            checked.push((check(&stops)?, stops));
        }
        let least =
            |a: &(Validation, _), b: &(Validation, _)| a.0.all.model.rms_mm.total_cmp(&b.0.all.model.rms_mm);
        let Some((with_stops, stops)) = checked.into_iter().min_by(least) else {
            return Ok(WithStops { validation: worked, stops: Vec::new(), warning: None });
        };
        let longest = Standstill::longest(&stops);
        let [left_mm, left_worked_mm] = [&with_stops, &worked].map(|one| one.all.model.rms_mm);
        let warning = longest.and_then(|longest| pause(longest, left_mm, left_worked_mm));
        Ok(if left_mm <= left_worked_mm {
            WithStops { validation: with_stops, stops, warning }
        } else {
            WithStops { validation: worked, stops: Vec::new(), warning }
        })
    }
}

/// What a model leaves, and when the robot was taken to have stood.
struct WithStops {
    validation: Validation,
    stops: Vec<Standstill>,
    warning: Option<Diagnostic>,
}

/// Where one history leaves less than this much more than the other, the rows do not tell which is right: the rms of 100 readings is known to a
/// twentieth.
const UNDECIDED: f64 = 1.05;

/// The rows that have a time, in its order.
fn readings(measurements: &Measurements) -> Vec<TimedReading> {
    let rows = measurements.rows.iter().filter(|row| row.reading.involves_arm());
    let reading = |row: &MeasurementRow| Some((row.t_min?, row.reading.fixed_point().unwrap_or(row.pose)));
    let mut all: Vec<TimedReading> = rows.filter_map(reading).collect();
    sorting::by(&mut all, |a, b| a.0.total_cmp(&b.0));
    all
}

fn no_law() -> Diagnostic {
    let text = "--stop has no effect: the model's drift follows no one growth law with a time constant";
    Diagnostic::warning("model::pause", text)
        .help("only the warmth of a robot follows its stops; the clock does not")
}

fn in_each_session() -> Diagnostic {
    let text =
        "the minutes of the file begin anew, and --stop is taken to name minutes of each of its sessions";
    Diagnostic::warning("model::pause", text)
        .help("validate on one session at a time where they stopped at other times")
}

fn late(first_min: f64) -> Diagnostic {
    let text = format!(
        "the first row is at minute {first_min:.0}: the robot is taken to have worked from minute 0 until then"
    );
    Diagnostic::warning("model::pause", text)
        .help("--stop FROM:TO says when it stood, --stop none that it did not")
}

/// That rows do not tell whether the robot stood, where they do not.
fn pause(longest: Standstill, left_mm: f64, left_worked_mm: f64) -> Option<Diagnostic> {
    let [least, most] = [left_mm.min(left_worked_mm), left_mm.max(left_worked_mm)];
    let history = if left_mm <= left_worked_mm { "stood" } else { "worked" };
    (most < UNDECIDED * least).then(|| {
        let text = format!(
            "nothing was measured for {:.0} minutes from minute {:.0} on, and the rows do not tell whether the robot worked or stood: it is taken \
             to have {history}; the model leaves {left_mm:.4} mm rms where it stood, {left_worked_mm:.4} where it worked",
            longest.length_min(),
            longest.from_min
        );
        Diagnostic::warning("model::pause", text).help("--stop FROM:TO says when it stood, --stop none that it worked")
    })
}

/// Whether all that a fault says is that the arm is another one: the model is put to the test all the same, and fails it.
fn is_no_reading_of(fault: &Fault) -> bool {
    fault.column.is_none() && matches!(fault.kind, FaultKind::WrongRobot | FaultKind::NothingFits)
}

/// What says that the model asks for what the file does not record: where it misses then, that is not the model's fault.
fn missing_columns(model: &Identified, channels: Channels) -> Option<Diagnostic> {
    let seen = &model.measured_range;
    let loaded = seen.payload_kg.is_some_and(|[_, most]| most > 0.0);
    let missing: Vec<&str> = [
        (
            model.needs_direction() && !channels.direction,
            "play asks from which side a joint came (dir1, ...): it is taken at the middle",
        ),
        (
            model.needs_load() && loaded && !channels.payload,
            "what gives way under load asks for payload_kg: the arm is taken as unloaded",
        ),
        (
            model.moves_with_time() && seen.t_min.is_some() && !channels.time,
            "what moves with time asks for t_min: all rows are taken at minute 0",
        ),
        (
            model.needs_temperature() && !channels.joint_temperature,
            "what moves with temperature asks for temp_j1_c, ...: the joints are taken as cold",
        ),
    ]
    .into_iter()
    .filter_map(|(is_missing, what)| is_missing.then_some(what))
    .collect();
    let text = format!("the file lacks columns that the model asks for; {}", missing.join("; "));
    let help = "record them, or take what is left for more than the model's own error";
    (!missing.is_empty()).then(|| Diagnostic::warning("model::columns", text).help(help))
}

/// No model of an arm misses its points by so much, however bad it is, mm.
const OTHER_ROBOT_MM: f64 = 25.0;

/// What a model leaves of measurements that it has not seen.
#[derive(Clone, Debug)]
pub struct ModelChecked {
    /// Distances that model and nominal robot leave, where the model was found and elsewhere.
    pub validation: Validation,
    /// What a person should look at in the measurements: rows and columns that were left out.
    pub warnings: Vec<Diagnostic>,
    /// When the robot is taken to have stood.
    pub stops: Vec<Standstill>,
    /// Whether that was named; otherwise it is by the long pauses between rows.
    pub stops_are_named: bool,
    limit_mm: Option<f64>,
}

impl ModelChecked {
    /// Whether the rms distance is within the limit, if there is one.
    #[must_use]
    pub fn is_within(&self) -> bool {
        self.limit_mm.is_none_or(|limit_mm| self.validation.all.model.rms_mm <= limit_mm)
    }

    /// Whether the model leaves no more than the nominal robot does.
    #[must_use]
    pub fn is_better(&self) -> bool {
        self.validation.all.model.rms_mm <= self.validation.all.nominal.rms_mm
    }

    /// Whether the measurements may be of this robot at all.
    #[must_use]
    pub fn is_of_robot(&self) -> bool {
        self.validation.all.model.rms_mm < OTHER_ROBOT_MM
    }

    /// Whether the model holds: for this robot's measurements, better than none, and within the limit.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.is_within() && self.is_better() && self.is_of_robot()
    }

    /// The distances, and what speaks against the model, for people.
    #[must_use]
    pub fn text(&self) -> String {
        let mut text = report::text(&self.validation);
        text += &report::stops(&self.stops, self.stops_are_named);
        if let (false, Some(limit_mm)) = (self.is_within(), self.limit_mm) {
            text += &format!("NOT within {limit_mm} mm\n");
        }
        if !self.is_better() {
            text += "WORSE than the nominal robot: the model does not hold for these measurements\n";
        }
        if !self.is_of_robot() {
            text += "NOT this robot's measurements, or not in its units and columns: driftpost diagnose names what is wrong with them\n";
        }
        text
    }

    /// The JSON of the contract.
    #[must_use]
    pub fn json(&self) -> serde_json::Value {
        let mut data = report::json(&self.validation, &self.stops);
        data["notes"] = notes(&self.text()).into();
        data
    }
}

//! The options of `driftpost compensate`, and what they say to the library.

#![allow(
    rustdoc::broken_intra_doc_links,
    reason = "doc comments of options are their help texts: brackets are brackets"
)]

use super::touch::TouchArgs;
use crate::cli::model;
use crate::cli::number::{minutes, positive};
use crate::cli::other_tasks::{OfTask, TaskRobot, given_for, joints_of_task, name_of_task, task_robot};
use crate::cli::shared::{JointAngles, RobotName, name_and_value};
use crate::cli::suggest;
use clap::ValueEnum;
use driftpost::application::{Compensation, Named};
use rapid_program::compensate::{FormChoice, JointsHint, Options, Selection};
use rapid_program::emit::{Clock, Core, EmitOptions, Sensor};
use rapid_program::program::Overrides;
use rapid_program::schedule::{Until, Width};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::Deformation;
use robot_model::deform::identified::Identified;
use robot_model::robot::Robot;
use robot_model::units::{m_from_mm, rad_from_deg};
use std::path::PathBuf;
use std::sync::Arc;

/// Command line of `driftpost compensate`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// RAPID modules, a folder of them, a .pgf, or - for standard input; names are resolved across all of them.
    #[arg(required = true, value_name = "PROGRAM")]
    pub program: Vec<PathBuf>,

    /// The robot that runs the program.
    #[command(flatten)]
    pub robot: RobotName,

    /// Of a backup with several robots: the robot of a motion task (folder TASKn), and its deformation table; once for each.
    #[arg(
        long,
        value_name = "TASK=ROBOT[,DEFORMATION]",
        value_parser = task_robot,
        conflicts_with_all = ["robot", "deformation", "model", "touch", "in_place"],
        help_heading = "Robot and deformation"
    )]
    pub task: Vec<TaskRobot>,

    /// Deformation table (CSV), static or scheduled [default: the reference paper's Table 2, built in].
    #[arg(long, value_name = "FILE", help_heading = "Robot and deformation")]
    pub deformation: Option<PathBuf>,

    /// An identified model (TOML) of diagnose --model-out, instead of a deformation table or on top of one.
    #[arg(long, value_name = "FILE", help_heading = "Robot and deformation")]
    pub model: Option<PathBuf>,

    /// With --model: the whole load on the flange, kg [default: what the tools' load data say].
    #[arg(long, value_name = "KG", requires = "model", help_heading = "Robot and deformation")]
    pub payload_kg: Option<f64>,

    /// With --model: temperature of the joints, one value or six, where the model has terms in temperature.
    #[arg(long, value_name = "C|C1,..,C6", requires = "model", value_parser = temperatures, allow_hyphen_values = true, help_heading = "Robot and deformation")]
    pub temperature_c: Option<Temperatures>,

    /// How a static table grows with the warm-up minute: none, exp:TAU or two-stage:TAU
    /// [default: two-stage:46 for the built-in table; required with a static table of yours].
    #[arg(long, value_name = "LAW", allow_hyphen_values = true, help_heading = "Robot and deformation")]
    pub growth: Option<String>,

    /// End of the schedule in minutes, or auto: where what is still to come is under the tolerance.
    #[arg(long, value_name = "MIN|auto", default_value = "auto", value_parser = until, allow_negative_numbers = true, help_heading = "Corrections")]
    pub until: Until,

    /// No target is further off than this anywhere in its bucket.
    #[arg(
        long,
        value_name = "MM",
        default_value_t = 0.005,
        allow_negative_numbers = true,
        help_heading = "Corrections"
    )]
    pub tolerance_mm: f64,

    /// Buckets of this fixed width instead of a tolerance.
    #[arg(
        long,
        value_name = "MIN",
        conflicts_with = "tolerance_mm",
        allow_negative_numbers = true,
        help_heading = "Corrections"
    )]
    pub bucket_min: Option<f64>,

    /// What a motion asks instead of its target.
    #[arg(long, value_enum, default_value_t = FormName::Schedule, help_heading = "Corrections")]
    pub form: FormName,

    /// What the bucket follows: the robot's warm-up minute (warmth), minutes since tcColdStart (elapsed), or a
    /// temperature that the cell measures (signal:NAME, an analog input; pers:NAME, written from outside) for a
    /// deformation table with temp_c.
    #[arg(long, value_name = "warmth|elapsed|signal:NAME|pers:NAME", default_value = "warmth", value_parser = clock, help_heading = "Clock in the program")]
    pub clock: ClockName,

    /// Without a good reading of the temperature the last one is used for so long, minutes; then the originals.
    #[arg(
        long,
        value_name = "MIN",
        default_value_t = 10.0,
        allow_negative_numbers = true,
        help_heading = "Clock in the program"
    )]
    pub hold_min: f64,

    /// A temperature that has not changed for so long is no good reading any more, minutes.
    #[arg(
        long,
        value_name = "MIN",
        default_value_t = 60.0,
        allow_negative_numbers = true,
        help_heading = "Clock in the program"
    )]
    pub stale_min: f64,

    /// Time constant of cooling while the program stands, minutes [default: the growth law's].
    #[arg(long, value_name = "MIN", allow_negative_numbers = true, help_heading = "Clock in the program")]
    pub tau_cool: Option<f64>,

    /// A pause longer than this counts as standing, minutes.
    #[arg(
        long,
        value_name = "MIN",
        default_value_t = 5.0,
        allow_negative_numbers = true,
        help_heading = "Clock in the program"
    )]
    pub gap_min: f64,

    /// Where clock and index live: in the module, or once in tcCore.mod
    /// [default: embedded for one module, separate for more].
    #[arg(long, value_enum, help_heading = "Clock in the program")]
    pub core: Option<CoreName>,

    /// Value of a tool that no given module declares, e.g. 'tGrip=[TRUE,[[0,0,120],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]]'.
    #[arg(long, value_name = "NAME=DATA", value_parser = name_and_value, allow_hyphen_values = true, help_heading = "What is accepted")]
    pub tool: Vec<(String, String)>,

    /// Value of a work object that no given module declares.
    #[arg(long, value_name = "NAME=DATA", value_parser = name_and_value, allow_hyphen_values = true, help_heading = "What is accepted")]
    pub wobj: Vec<(String, String)>,

    /// Joints with which the arm stands when the entry is called, degrees: makes branches certain that the text leaves open; of
    /// several tasks once for each.
    #[arg(long, value_name = "[TASK=]Q1,..,Q6", value_parser = joints_of_task, allow_hyphen_values = true, conflicts_with = "home", help_heading = "What is accepted")]
    pub start_joints: Vec<OfTask<JointAngles>>,

    /// The same as a jointtarget of the program, or of the task.
    #[arg(long, value_name = "[TASK=]NAME", value_parser = name_of_task, help_heading = "What is accepted")]
    pub home: Vec<OfTask<String>>,

    /// Joints that motions end with (CSV: file,line,q1_deg,..,q6_deg, or a row q1_deg,..,q6_deg for each target in order), as a post-processor knows them: makes branches certain.
    #[arg(long, value_name = "FILE", help_heading = "What is accepted")]
    pub joints_hint: Option<PathBuf>,

    /// Leave the motions of this target, routine or module alone; * and ? stand for any letters. Repeatable.
    #[arg(long, value_name = "GLOB", help_heading = "What is accepted")]
    pub keep: Vec<String>,

    /// Correct the motions of this target, routine or module alone. Repeatable.
    #[arg(long, value_name = "GLOB", help_heading = "What is accepted")]
    pub only: Vec<String>,

    /// External axes (a to f) that move neither the robot's base nor a work object.
    #[arg(long, value_name = "AXIS,..", value_delimiter = ',', value_parser = external_axis, help_heading = "What is accepted")]
    pub base_fixed: Vec<ExternalAxis>,

    /// A larger correction than this is refused [default: 0.5; with --model 3].
    #[arg(long, value_name = "MM", allow_negative_numbers = true, help_heading = "Corrections")]
    pub max_correction_mm: Option<f64>,

    /// A larger correction than this is refused [default: 0.1; with --model 0.5].
    #[arg(long, value_name = "DEG", allow_negative_numbers = true, help_heading = "Corrections")]
    pub max_correction_deg: Option<f64>,

    /// A linear move that leaves its line by more than this at mid-path is warned about.
    #[arg(
        long,
        value_name = "MM",
        default_value_t = 0.01,
        allow_negative_numbers = true,
        help_heading = "Corrections"
    )]
    pub path_tolerance_mm: f64,

    /// Leave MoveAbsJ as it is (RoboDK writes MoveJ so; it is corrected otherwise).
    #[arg(long, help_heading = "Corrections")]
    pub keep_moveabsj: bool,

    /// Accept a program that RoboDK says was not made with nominal kinematics.
    #[arg(long, help_heading = "What is accepted")]
    pub allow_non_nominal: bool,

    /// Accept a program, a model or a table that is another robot's.
    #[arg(long, help_heading = "What is accepted")]
    pub allow_other_robot: bool,

    /// The controller's own Absolute Accuracy is on: MoveAbsJ is kept.
    #[arg(long, help_heading = "Corrections")]
    pub absolute_accuracy: bool,

    /// With --form live or auto: add tcSelfTest, which compares the controller's kinematics with those that the corrections
    /// were made for and times the calls, before anything moves.
    #[arg(long, help_heading = "Clock in the program")]
    pub self_test: bool,

    /// How tcTouch measures the thermal state.
    #[command(flatten)]
    pub touch: TouchArgs,

    /// Refuse the program where a motion would be kept.
    #[arg(long, help_heading = "What is accepted")]
    pub strict: bool,

    /// Where the result goes, - being standard output [default: STEM_tc.EXT beside one file, folder NAME_tc/ for more].
    #[arg(short, long, value_name = "PATH", help_heading = "Results")]
    pub output: Option<PathBuf>,

    /// Overwrite the input.
    #[arg(long, conflicts_with = "output", help_heading = "Results")]
    pub in_place: bool,

    /// Overwrite a result of ours that was changed since it was written (touched up, saved back by a controller).
    #[arg(long, help_heading = "Results")]
    pub force: bool,

    /// Run again whenever a file of the program is written anew, until interrupted.
    #[arg(long, conflicts_with = "in_place", help_heading = "Results")]
    pub watch: bool,

    /// What is shown of the difference: short (changed motions and the first targets, at most 60 lines), none, - (the whole
    /// on standard output), or a file for the whole as a unified diff.
    #[arg(long, value_name = "short|none|-|FILE", default_value = "short", help_heading = "Results")]
    pub diff: PathBuf,

    /// Joints solved at every minute, as CSV.
    #[arg(long, value_name = "FILE", help_heading = "Results")]
    pub joints_csv: Option<PathBuf>,

    /// One HTML page to look at: the arm, the drift, every correction and changed line; opens in any browser, offline.
    #[arg(long, value_name = "FILE.html", help_heading = "Results")]
    pub report: Option<PathBuf>,

    /// A recording of the warm-up for Foxglove and Rerun (MCAP), and the arm as URDF beside it.
    #[cfg(feature = "mcap")]
    #[arg(long, value_name = "FILE.mcap", conflicts_with = "task", help_heading = "Results")]
    pub mcap: Option<PathBuf>,

    /// Show every motion and every message, however many there are.
    #[arg(long, help_heading = "Results")]
    pub all: bool,

    /// Everything a script needs, as JSON; - is standard output.
    #[arg(long, value_name = "FILE|-", help_heading = "Results")]
    pub json: Option<PathBuf>,
}

/// What the options name.
#[derive(Clone, Debug)]
pub struct Models {
    /// The robot and the name it was asked for by.
    pub robot: Named<Robot>,
    /// Its deformation; none of its own beside a model.
    pub deformation: Named<Deformation>,
    /// The identified model and its file.
    pub identified: Option<Named<Identified>>,
}

/// Temperatures of the joints, degrees Celsius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Temperatures(pub [f64; 6]);

/// An external axis by its number from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ExternalAxis(pub usize);

/// What a motion asks instead of its target.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum FormName {
    /// One of an array of targets, an element for each stretch of warm-up time: every corrected target is to be seen.
    Schedule,
    /// The original and one correction, scaled by the share of the drift that has come: no steps, a fraction of the text.
    Ramp,
    /// The deformed model itself, at run time: for targets that only the running program knows.
    Live,
    /// Motion by motion the plainest: ramp where the target is known, live where it is not.
    Auto,
}

impl From<FormName> for FormChoice {
    fn from(name: FormName) -> Self {
        match name {
            FormName::Schedule => Self::Schedule,
            FormName::Ramp => Self::Ramp,
            FormName::Live => Self::Live,
            FormName::Auto => Self::Auto,
        }
    }
}

/// What the bucket follows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ClockName {
    /// The robot's own warm-up minute: runs while the program runs, falls back while it stands.
    Warmth,
    /// Minutes since tcColdStart.
    Elapsed,
    /// A temperature that the cell measures.
    Measured(Sensor),
}

/// Where clock and index live.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum CoreName {
    /// In the module.
    Embedded,
    /// Once in tcCore.mod.
    Separate,
}

impl Args {
    /// What is asked of the compensation.
    ///
    /// # Errors
    /// What is wrong with the joints hint.
    pub fn options(&self, identified: Option<&Named<Identified>>) -> Result<Options, Diagnostic> {
        let [max_m, max_rad] = Compensation::largest_correction(identified.is_some());
        Ok(Options {
            form: self.form.into(),
            model: identified.map(|named| Arc::new(named.model.clone())),
            payload_kg: self.payload_kg,
            joint_temperature_c: self.temperature_c.map(|t| t.0),
            tolerance_m: m_from_mm(self.tolerance_mm),
            until: self.until,
            width: self.bucket_min.map_or(Width::Tolerance, |width_min| Width::Fixed { width_min }),
            max_correction_m: self.max_correction_mm.map_or(max_m, m_from_mm),
            max_correction_rad: self.max_correction_deg.map_or(max_rad, rad_from_deg),
            path_tolerance_m: m_from_mm(self.path_tolerance_mm),
            keep_moveabsj: self.keep_moveabsj,
            absolute_accuracy: self.absolute_accuracy,
            strict: self.strict,
            start_rad: None,
            joints_hint: self.joints_hint.as_deref().map(model::joints_hint).transpose()?.map(Arc::new),
            selection: Selection { keep: self.keep.clone(), only: self.only.clone() },
            gap_min: matches!(self.clock, ClockName::Warmth).then_some(self.gap_min),
        })
    }

    /// The robot, its deformation and its model.
    ///
    /// # Errors
    /// What is wrong with a name or a file.
    pub fn models(&self, of_task: Option<&TaskRobot>) -> Result<Models, Diagnostic> {
        let name = of_task.map_or(&self.robot.name, |task| &task.robot);
        model::robot_of_program(name)?;
        let robot = model::robot_with_source(name)?;
        let backup = model::backup(name).transpose()?;
        if backup.is_some_and(|backup| backup.absolute_accuracy) && !self.absolute_accuracy {
            let text = format!("{name}: the controller corrects this robot by a calibration of its own");
            return Err(Diagnostic::error("robot::absolute-accuracy", text).help(
                "--absolute-accuracy says that it is in use, and leaves alone what would be corrected twice; give the robot's name where it is switched off",
            ));
        }
        let identified = self.model.as_deref().map(model::identified).transpose()?;
        let table = match of_task {
            Some(task) => task.deformation.as_deref(),
            None => self.deformation.as_deref(),
        };
        let growth = self.growth.as_deref();
        let deformation = match &identified {
            Some(identified) => model::deformation_beside(identified, table, growth)?,
            None => model::deformation_with_source(table, growth)?,
        };
        Ok(Models { robot, deformation, identified })
    }

    /// The jobs, all names resolved: one for each task that is named, or the one for all that is given.
    ///
    /// # Errors
    /// What is wrong with a robot or a deformation; a task that is named twice.
    pub fn jobs(&self) -> Result<Vec<Compensation>, Diagnostic> {
        if self.task.is_empty() {
            return self.compensation(None).map(|job| vec![job]);
        }
        for (k, task) in self.task.iter().enumerate() {
            if self.task[..k].iter().any(|other| other.task.eq_ignore_ascii_case(&task.task)) {
                let text = format!("--task {} is given twice", task.task);
                return Err(Diagnostic::error("task::twice", text).help("one robot for each task"));
            }
        }
        self.task.iter().map(|task| self.compensation(Some(task))).collect()
    }

    /// A job, all names resolved: that of a task, or the one for all that is given.
    ///
    /// # Errors
    /// What is wrong with the robot or the deformation.
    pub fn compensation(&self, of_task: Option<&TaskRobot>) -> Result<Compensation, Diagnostic> {
        let Models { robot, deformation, identified } = self.models(of_task)?;
        let start = given_for("--start-joints", &self.start_joints, &self.task, of_task)?;
        let home = given_for("--home", &self.home, &self.task, of_task)?.cloned();
        if let Some(joints) = start {
            joints.check(&robot.model)?;
        }
        let start_rad = start.map(|joints| joints.0);
        let mut options = Options { start_rad, ..self.options(identified.as_ref())? };
        if let (Some(of), Some(hint)) = (of_task, &mut options.joints_hint) {
            let others = self.task.iter().filter(|other| *other != of).map(|other| other.task.clone());
            *hint = Arc::new(JointsHint::clone(hint).without_tasks(others.collect()));
        }
        Ok(Compensation {
            options,
            emit: self.emit_options(&robot, &deformation, identified.as_ref())?,
            overrides: Overrides { task: of_task.map(|of| of.task.clone()), home, ..self.overrides() },
            allow_non_nominal: self.allow_non_nominal,
            allow_other_robot: self.allow_other_robot,
            default_table: match of_task {
                Some(task) => task.deformation.is_none(),
                None => self.deformation.is_none() && self.model.is_none(),
            },
            touch: self.touch.request()?,
            robot,
            deformation,
        })
    }

    /// How the program is emitted.
    ///
    /// # Errors
    /// What is wrong with the deformation table.
    pub fn emit_options(
        &self,
        robot: &Named<Robot>,
        deformation: &Named<Deformation>,
        model: Option<&Named<Identified>>,
    ) -> Result<EmitOptions, Diagnostic> {
        let clock = match &self.clock {
            ClockName::Elapsed => Clock::Elapsed,
            ClockName::Measured(source) => {
                Clock::Sensor { source: source.clone(), hold_min: self.hold_min, stale_min: self.stale_min }
            }
            ClockName::Warmth => Clock::Warmth {
                growth: deformation.model.growth().copied(),
                tau_cool_min: self.tau_cool,
                gap_min: self.gap_min,
            },
        };
        // Beside a model the deformation is that of both.
        let table = match (model, self.deformation.as_deref()) {
            (None, _) => Some(deformation.source.clone()),
            (Some(_), None) => None,
            (Some(_), table) => Some(model::deformation_with_source(table, self.growth.as_deref())?.source),
        };
        Ok(EmitOptions {
            form: self.form.into(),
            clock,
            growth: deformation.model.one_law(model.map(|model| &model.model)),
            core: self.core.map(|core| match core {
                CoreName::Embedded => Core::Embedded,
                CoreName::Separate => Core::Separate,
            }),
            robot: robot.source.clone(),
            deformation: table,
            model: model.map(|model| model.source.clone()),
            settings: Vec::new(),
            absolute_accuracy: self.absolute_accuracy,
            self_test: self.self_test,
            touch: None,
        })
    }

    /// Tools and work objects given as options.
    #[must_use]
    pub fn overrides(&self) -> Overrides {
        let mut base_fixed = [false; 6];
        for axis in &self.base_fixed {
            base_fixed[axis.0] = true;
        }
        Overrides {
            task: None,
            tools: self.tool.clone(),
            wobjs: self.wobj.clone(),
            home: None,
            base_fixed,
            other_tasks: Vec::new(),
        }
    }

    /// Refuses numbers that make no sense before any work is done.
    ///
    /// # Errors
    /// `option::number`, naming the option.
    pub fn check(&self) -> Result<(), Diagnostic> {
        positive(&[
            ("--max-correction-mm", self.max_correction_mm),
            ("--max-correction-deg", self.max_correction_deg),
            ("--payload-kg", self.payload_kg.filter(|kg| *kg != 0.0)),
            ("--path-tolerance-mm", Some(self.path_tolerance_mm)),
        ])?;
        let until = match self.until {
            Until::Minutes(minutes) if minutes > 0.0 => Some(minutes),
            _ => None,
        };
        minutes(&[
            ("--gap-min", Some(self.gap_min)),
            ("--hold-min", Some(self.hold_min)),
            ("--stale-min", Some(self.stale_min)),
            ("--tau-cool", self.tau_cool),
            ("--until", until),
            ("--bucket-min", self.bucket_min.filter(|minutes| *minutes > 0.0)),
        ])
    }
}

fn clock(text: &str) -> Result<ClockName, String> {
    match text.split_once(':') {
        None if text == "warmth" => Ok(ClockName::Warmth),
        None if text == "elapsed" => Ok(ClockName::Elapsed),
        Some(("signal", name)) => Ok(ClockName::Measured(Sensor::Signal(name.to_owned()))),
        Some(("pers", name)) => Ok(ClockName::Measured(Sensor::Pers(name.to_owned()))),
        _ => {
            let near = suggest::nearest(text, ["warmth", "elapsed"]);
            let near = near.map_or_else(String::new, |near| format!("; did you mean '{near}'?"));
            Err(format!("write warmth, elapsed, signal:NAME or pers:NAME{near}"))
        }
    }
}

fn until(text: &str) -> Result<Until, String> {
    if text == "auto" {
        return Ok(Until::Auto);
    }
    let minutes = text.parse().map_err(|_| "write minutes, e.g. 180, or auto".to_owned())?;
    Ok(Until::Minutes(minutes))
}

/// One temperature for all joints, or six.
pub(in crate::cli) fn temperatures(text: &str) -> Result<Temperatures, String> {
    let all: Vec<f64> = text
        .split(',')
        .map(|t| t.trim().parse::<f64>().ok().filter(|t| t.is_finite()))
        .collect::<Option<_>>()
        .ok_or_else(|| "write one temperature in degrees Celsius, or six with commas".to_owned())?;
    match all[..] {
        [one] => Ok(Temperatures([one; 6])),
        [a, b, c, d, e, f] => Ok(Temperatures([a, b, c, d, e, f])),
        _ => Err(format!("one temperature or six are needed, there are {}", all.len())),
    }
}

fn external_axis(text: &str) -> Result<ExternalAxis, String> {
    let letters = ["a", "b", "c", "d", "e", "f"];
    let found = letters.iter().position(|letter| text.trim().eq_ignore_ascii_case(letter));
    found.map(ExternalAxis).ok_or_else(|| "external axes are called a, b, c, d, e and f".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_forms_of_small_values() {
        assert_eq!(until("auto"), Ok(Until::Auto));
        assert_eq!(until("37.5"), Ok(Until::Minutes(37.5)));
        assert!(until("autto").is_err());
        assert_eq!(clock("signal:aiT2"), Ok(ClockName::Measured(Sensor::Signal("aiT2".into()))));
        assert!(clock("sensor:aiT2").is_err() && clock("warm").is_err());
        let given = ("tGrip".to_owned(), "[TRUE,[[-1,0,0]]]".to_owned());
        assert_eq!(name_and_value("tGrip=[TRUE,[[-1,0,0]]]"), Ok(given.clone()));
        assert_eq!(name_and_value("tGrip := [TRUE,[[-1,0,0]]]"), Ok(given));
        assert!(name_and_value("tGrip").is_err());
    }
}

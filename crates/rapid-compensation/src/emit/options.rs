//! What a program is emitted with, and why it could not be.

use std::path::PathBuf;

use super::touch::Touch;
use crate::compensate::FormChoice;
use rapid_program::AddedRoutine;
use rapid_syntax::diagnostic::FileId;
use rapid_syntax::{Edit, EditError, Replaced, edits_of};
use robot_model::deform::identified::Identified;
use robot_model::deform::{Deformation, GrowthLaw, TIMES_MIN};

/// How the drift grows while the robot runs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DriftGrowth {
    /// By a law of its own, which says how it cools, too.
    Law(GrowthLaw),
    /// As a scheduled table has it; with the law that is nearest to its rows, by which what is there falls back while the robot stands.
    Table(Option<GrowthLaw>),
}

impl DriftGrowth {
    /// Of a deformation and of a model besides: the law by which all of it grows, or the one that is nearest to it all.
    #[must_use]
    pub fn of(deformation: &Deformation, model: Option<&Identified>) -> Self {
        let nearest = deformation.warm_up_law(model).map(|fitted| fitted.law);
        match deformation.growth() {
            Some(own) => Self::Law(nearest.unwrap_or(*own)),
            None => Self::Table(nearest),
        }
    }
}

/// How the emitted program knows how warm the robot is.
#[derive(Clone, Debug, PartialEq)]
pub enum Clock {
    /// The warm-up minute of the robot: it runs while the program runs, and falls back while it stands.
    Warmth {
        /// How the drift grows.
        growth: DriftGrowth,
        /// Time constant of cooling; `None` = that of the law, which a scheduled table does not say.
        tau_cool_min: Option<f64>,
        /// A pause longer than this counts as standing.
        gap_min: f64,
    },
    /// Minutes since the cold start was called, standing or not.
    Elapsed,
    /// A temperature that the cell measures.
    Sensor {
        /// Where it is read.
        source: Sensor,
        /// A last good reading is used for so long, minutes.
        hold_min: f64,
        /// A reading that has not changed for so long is none any more, minutes.
        stale_min: f64,
    },
}

/// Where a program reads a temperature, degrees Celsius.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Sensor {
    /// An analog input, by its name.
    Signal(String),
    /// A persistent `num` that is written from outside.
    Pers(String),
}

/// Where clock and functions live.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Core {
    /// In the one module that is changed.
    Embedded,
    /// In a module of their own, `tcCore`.
    Separate,
}

/// An input, as the header names it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Provenance {
    /// Its name: a file or a built-in.
    pub name: String,
    /// SHA-256 in hexadecimal digits.
    pub sha256: String,
}

impl std::fmt::Display for Provenance {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "SHA-256 {} {}", self.sha256, self.name)
    }
}

impl Provenance {
    /// Reads what is written of one.
    #[must_use]
    pub fn parse(text: &str) -> Option<Self> {
        let (sha256, name) = text.strip_prefix("SHA-256 ")?.split_once(' ')?;
        Some(Self { name: name.to_owned(), sha256: sha256.to_owned() })
    }
}

/// The procedures that an emitted program is given and that it may call: those of a clock, and where a fixed point is touched the one that
/// does it, which moves the arm. They set nothing but their own data.
#[must_use]
pub fn routines_to_call(clock: &Clock, touches: bool) -> Vec<AddedRoutine> {
    let starts: &[&'static str] = match clock {
        Clock::Warmth { .. } | Clock::Elapsed => &["tcColdStart", "tcWarmStart", "tcStartAt"],
        Clock::Sensor { .. } => &[],
    };
    let clock = starts.iter().chain(&["tcUpdate"]).map(|&name| AddedRoutine { name, moves_arm: false });
    let touch = AddedRoutine { name: "tcTouch", moves_arm: true };
    clock.chain(touches.then_some(touch)).collect()
}

/// How a program is emitted.
#[derive(Clone, Debug, PartialEq)]
pub struct EmitOptions {
    /// What was asked for, as the comment block names it.
    pub form: FormChoice,
    /// What the emitted program tells the warmth by.
    pub clock: Clock,
    /// The law of the drift's growth, where all of it follows one.
    pub growth: Option<GrowthLaw>,
    /// Where clock and functions live; `None` = in the module if only one is changed, else separate.
    pub core: Option<Core>,
    /// The robot that the targets are made for.
    pub robot: Provenance,
    /// The deformation table; `None` where a model alone says how the arm deforms.
    pub deformation: Option<Provenance>,
    /// Identified model that the program was corrected with.
    pub model: Option<Provenance>,
    /// What else a reviewer's tools need: options of the command line by their names, without the dashes.
    pub settings: Vec<(String, String)>,
    /// The user says that the controller's Absolute Accuracy is on.
    pub absolute_accuracy: bool,
    /// A routine is added that compares the controller's kinematics with those that the corrections were made for.
    pub self_test: bool,
    /// A routine is added that measures the thermal state at a fixed point.
    pub touch: Option<Touch>,
}

impl EmitOptions {
    /// All that a program is made with, by the names of options: files with their SHA-256, then [`settings`](Self::settings).
    #[must_use]
    pub fn made_with(&self) -> Vec<(String, String)> {
        let files = [
            ("robot", Some(&self.robot)),
            ("deformation", self.deformation.as_ref()),
            ("model", self.model.as_ref()),
        ];
        let files = files.into_iter().filter_map(|(name, file)| Some((name.to_owned(), file?.to_string())));
        let thermometer = match &self.clock {
            Clock::Sensor { source: Sensor::Signal(name) | Sensor::Pers(name), .. } => Some(name.clone()),
            Clock::Warmth { .. } | Clock::Elapsed => None,
        };
        let thermometer = thermometer.map(|name| ("thermometer".to_owned(), name));
        files.chain(thermometer).chain(self.settings.iter().cloned()).collect()
    }
}

/// One file of the emitted program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EmittedFile {
    /// The file it comes from; `None` for one that is new.
    pub source: Option<FileId>,
    /// The source's path, or that of a new file beside it; `/` between folders.
    pub path: String,
    /// The file that is concerned.
    pub bytes: Vec<u8>,
    /// What was changed of the source, in source order; empty for a new file.
    pub replaced: Vec<Replaced>,
}

impl EmittedFile {
    /// The edits that made it of its source, in source order; none for a new file.
    #[must_use]
    pub fn edits(&self) -> Vec<Edit<&[u8]>> {
        edits_of(&self.bytes, &self.replaced)
    }
}

/// Why a program could not be emitted.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum EmitError {
    /// A given file is an emitted one.
    #[error(
        "{}:{line}: this module is already compensated; take the original, or get it back with `driftpost restore`",
        path.display()
    )]
    AlreadyCompensated {
        /// The file that is concerned.
        path: PathBuf,
        /// The line of its header.
        line: u32,
    },
    /// The warmth clock does not know how fast the robot cools.
    #[error(
        "the warmth clock needs to know how fast the robot cools, and a scheduled table does not say so: give --tau-cool MIN, or --clock elapsed"
    )]
    CoolingUnknown,
    /// A table by temperature and a clock by time, or the other way.
    #[error(
        "{}",
        if *by_temperature {
            "the deformation goes by temperature, which a clock cannot know: give --clock signal:NAME or pers:NAME"
        } else {
            "a measured temperature indexes a deformation table with temp_c, and this one goes by time"
        }
    )]
    ClockOfOtherKind {
        /// The deformation goes by temperature.
        by_temperature: bool,
    },
    /// A signal's or persistent's name that cannot be used.
    #[error("{name} cannot be the clock's temperature: {why}")]
    BadSensor {
        /// As it was given.
        name: String,
        /// Why it cannot be used.
        why: &'static str,
    },
    /// A time that no robot has.
    #[error("{name} must be from {} to {} minutes, not {minutes:?}", TIMES_MIN.start(), TIMES_MIN.end())]
    BadTime {
        /// Which of the times it is.
        name: &'static str,
        /// As it was given.
        minutes: f64,
    },
    /// The core cannot be embedded in several modules.
    #[error("{modules} modules hold compensated motion and share one clock: use --core separate")]
    EmbeddedInSeveral {
        /// How many modules are changed.
        modules: usize,
    },
    /// A touch tells nothing of what the clock or the drift goes by.
    #[error("--touch: {0}")]
    CannotTouch(String),
    /// Motion of several tasks, which are several robots.
    #[error(
        "several tasks hold motion ({}), and each moves a robot of its own: say which, --task {}=ROBOT[,DEFORMATION] and so on \
         for each, or compensate one task's folder at a time",
        tasks.join(", "),
        tasks.first().map_or("TASK1", String::as_str)
    )]
    SeveralTasks {
        /// The folders of the tasks.
        tasks: Vec<String>,
    },
    /// Motion of tasks beside motion in modules that stand in no task's folder, and may be any robot's.
    #[error(
        "{} and modules in no task's folder hold motion, and each task moves a robot of its own: compensate one task's folder at a time, \
         and those modules by themselves, or put them into the folder of the task that runs them",
        tasks.join(", ")
    )]
    BesideTasks {
        /// The folders of the tasks.
        tasks: Vec<String>,
    },
    /// There is no place for data and routines.
    #[error("{}:{line}: no MODULE ... ENDMODULE round this motion, so there is no place for its targets", path.display())]
    NoModule {
        /// The file that is concerned.
        path: PathBuf,
        /// The motion's or module's line.
        line: u32,
    },
    /// What was emitted does not give its original back.
    #[error("{}: the original cannot be got back from the result, so it is not written: {what}", path.display())]
    NotRestored {
        /// The file that is concerned.
        path: PathBuf,
        /// What is wrong with it.
        what: String,
    },
    /// No name of 32 characters is free.
    #[error("{}:{line}: no free name of at most 32 characters for the target", path.display())]
    NoName {
        /// The file that is concerned.
        path: PathBuf,
        /// The line of the motion.
        line: u32,
    },
    /// A given module declares what clock and functions ask the controller for.
    #[error(
        "{}:{line}: {name} is declared here and hides the controller's own, which the added clock, data and functions name: rename it{instead}",
        path.display()
    )]
    HiddenName {
        /// The file that is concerned.
        path: PathBuf,
        /// The line of the declaration.
        line: u32,
        /// As it is declared.
        name: String,
        /// What else can be done.
        instead: &'static str,
    },
    /// The plan was made for another program or is not whole.
    #[error("the plan does not fit the program: {0}")]
    PlanMismatch(String),
    /// Two changes at one place.
    #[error("{}: {error}", path.display())]
    Edit {
        /// The file that is concerned.
        path: PathBuf,
        /// What is wrong with it.
        error: EditError,
    },
}

impl EmitError {
    /// The stable code of the message, listed in `docs/MESSAGES.md`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::AlreadyCompensated { .. } => "refuse::already-compensated",
            Self::CoolingUnknown => "emit::cooling-unknown",
            Self::ClockOfOtherKind { .. } => "emit::clock-kind",
            Self::BadSensor { .. } => "emit::bad-sensor",
            Self::BadTime { .. } => "emit::bad-time",
            Self::EmbeddedInSeveral { .. } => "emit::embedded-in-several",
            Self::CannotTouch(_) => "touch::clock",
            Self::SeveralTasks { .. } | Self::BesideTasks { .. } => "emit::several-tasks",
            Self::NoModule { .. } => "emit::no-module",
            Self::NotRestored { .. } => "emit::not-restored",
            Self::NoName { .. } => "emit::no-name",
            Self::HiddenName { .. } => "emit::hidden-name",
            Self::PlanMismatch(_) => "emit::plan-mismatch",
            Self::Edit { .. } => "emit::edit",
        }
    }
}

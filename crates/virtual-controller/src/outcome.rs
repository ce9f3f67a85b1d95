//! How a run ends, what a controller shows, and what it refuses.

/// What a controller refuses, or cannot do.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SimulateError {
    /// The module does not load.
    #[error("{path} does not load: {why}")]
    Load {
        /// Path of the file as it was given.
        path: String,
        /// The reason as a sentence without full stop.
        why: String,
    },
    /// There is no routine of this name.
    #[error("there is no routine {0} in the modules that are loaded")]
    NoRoutine(String),
    /// There is no main, and not just one routine that nothing calls.
    #[error("where to start is not clear: there is no main, and what nothing calls is: {0}")]
    NoEntry(String),
    /// There are no data of this name.
    #[error("there are no data {0} in the modules that are loaded")]
    NoData(String),
    /// The value is not of the data's type, or cannot be found.
    #[error("{name}: {why}")]
    Value {
        /// Name of the data as it was given.
        name: String,
        /// The reason as a sentence without full stop.
        why: String,
    },
    /// A loop waits for what nothing in the program brings about.
    #[error("{}", endless(at, names))]
    Endless {
        /// Where the loop stands.
        at: SourceLine,
        /// What its conditions ask for.
        names: Vec<String>,
    },
    /// A program goes on without a motion, and no loop of it is seen to wait.
    #[error("{}:{}: here the program was after ten million statements without a motion: it does not come to an end", .0.file, .0.line)]
    Idle(SourceLine),
    /// A program needs more than this controller holds.
    #[error("{}", over_limit(at, what))]
    OverLimit {
        /// Where in the program.
        at: SourceLine,
        /// What there is more of, as a sentence without full stop.
        what: String,
    },
    /// The arm has no closed-form inverse kinematics.
    #[error("the controller's kinematics of this arm is not known: {0}")]
    Arm(String),
    /// A scenario that cannot be read or carried out.
    #[error("scenario: {0}")]
    Scenario(String),
}

impl SimulateError {
    /// Stable code of the message, listed in `docs/MESSAGES.md`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Load { .. } => "simulate::load",
            Self::NoRoutine(_) => "simulate::no-routine",
            Self::NoEntry(_) => "simulate::no-entry",
            Self::NoData(_) => "simulate::no-data",
            Self::Value { .. } => "simulate::value",
            Self::Endless { .. } | Self::Idle(_) => "simulate::endless",
            Self::OverLimit { .. } => "simulate::limit",
            Self::Arm(_) => "robot::structure",
            Self::Scenario(_) => "simulate::scenario",
        }
    }
}

/// A loop that waits in vain, as a sentence without full stop.
pub(super) fn endless(at: &SourceLine, names: &[String]) -> String {
    let SourceLine { file, line } = at;
    match names {
        [] => format!("{file}:{line}: this loop never ends"),
        names => format!(
            "{file}:{line}: this loop waits for {}, which nothing in the program changes",
            names.join(", ")
        ),
    }
}

/// What there is more of than this controller holds, and where, as a sentence without full stop.
pub(super) fn over_limit(at: &SourceLine, what: &str) -> String {
    format!("{}:{}: {what}, and the virtual controller holds no more", at.file, at.line)
}

/// Where in the program something happened.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct SourceLine {
    /// The file as the user knows it.
    pub file: String,
    /// Line of the file, from 1.
    pub line: u32,
}

/// How a run ended.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcome {
    /// The routine came to its end.
    Finished,
    /// The outermost endless loop was passed as often as asked for.
    Passes,
    /// `EXIT`
    Exited,
    /// Stopped in the middle, where it can go on.
    Stopped,
    /// More steps than allowed: the program does not end.
    OutOfSteps {
        /// The statement at which it was stopped.
        at: SourceLine,
        /// Whether the arm was moved in those steps.
        moving: bool,
    },
    /// A loop that waits for what nothing in the program brings about.
    Endless {
        /// Where the loop stands.
        at: SourceLine,
        /// What its conditions ask for.
        names: Vec<String>,
    },
    /// More moves, or more data, than this controller holds.
    OverLimit {
        /// The statement at which it was stopped.
        at: SourceLine,
        /// What there is more of, as a sentence without full stop.
        what: String,
    },
    /// An error that no handler took, or text no controller would run.
    Failed {
        /// RAPID's name of the error, where it has one.
        error: Option<&'static str>,
        /// What is the matter.
        message: String,
        /// The statement at which it failed.
        at: SourceLine,
    },
}

impl Outcome {
    /// Ended as programs should.
    #[must_use]
    pub fn is_good(&self) -> bool {
        matches!(self, Self::Finished | Self::Passes | Self::Exited | Self::Stopped)
    }
}

/// Something the controller shows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Message {
    /// `TPWrite`, `ErrWrite`, `Stop` ... or `controller` for the controller's own.
    pub source: &'static str,
    /// The text that is shown.
    pub text: String,
    /// The statement that shows it.
    pub at: SourceLine,
}

/// Why an operation did not do what it should.
#[derive(Clone, Debug)]
pub(super) enum Fault {
    /// An error that an ERROR handler can take.
    Raised { number: f32, text: String, at: Option<SourceLine> },
    /// Nothing a program could go on from.
    Fatal(String),
    /// The run is over.
    Ended(Outcome),
}

/// An error a handler can take.
pub(super) fn raise<T>(name: &str, text: impl Into<String>) -> Result<T, Fault> {
    let number = super::predefined::error_number(name).unwrap_or(0.0);
    Err(Fault::Raised { number, text: text.into(), at: None })
}

/// An error nothing can take.
pub(super) fn fatal<T>(text: impl Into<String>) -> Result<T, Fault> {
    Err(Fault::Fatal(text.into()))
}

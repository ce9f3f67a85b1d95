//! What is found in an emitted module that somebody has worked on, and why there is no original.

/// A target that was touched up in the emitted module.
#[derive(Clone, Debug, PartialEq)]
pub struct ModifiedTarget {
    /// Its array; `None` where the original itself was touched up.
    pub array: Option<String>,
    /// What stands in the motion of the original.
    pub target: String,
    /// The new value of the original.
    pub value: String,
    /// Where the original stands in the emitted module, or the first line that names its array, from 1.
    pub line: u32,
    /// Where the new value stands in the result.
    pub into: ModifiedIn,
    /// How far the original has moved.
    pub moved: f64,
    /// In `mm`, or in `deg` for joints and for a turn alone.
    pub unit: &'static str,
    /// Lines, from 1, where the module names the target too, whose new value is in its declaration: what stood there before goes with it.
    pub others: Vec<u32>,
}

/// Where a touched-up value went.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModifiedIn {
    /// Into the argument of the motion.
    Motion,
    /// Into the target's declaration.
    Declaration,
    /// In the target's declaration alone: the array, by which the motions went, is as it was made.
    DeclarationAlone,
}

/// Why there is no original.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum RestoreError {
    /// No module of the file was made by this program.
    #[error("no module of this file is a compensated one: there is no `! driftpost` comment after MODULE")]
    NotEmitted,
    /// The module is the common one, which has no original.
    #[error(
        "this module belongs to a compensated program and has no original: remove it when that is removed"
    )]
    IsCore,
    /// Two touched-up elements of one target do not mean the same original.
    #[error(
        "line {line}: two elements of {array} were touched up and mean different originals: {first} and {second}; undo one of them"
    )]
    Disagree {
        /// The name of the array.
        array: String,
        /// Its first line, from 1.
        line: u32,
        /// What the first means.
        first: String,
        /// What the other means.
        second: String,
    },
    /// The declaration of a target and its array were changed, and mean different originals.
    #[error(
        "line {line}: {target} is declared as {declared} now, and its array {array} was touched up and means {meant}; undo one of them"
    )]
    DeclaredOtherwise {
        /// Name of the target, as the program declares it.
        target: String,
        /// The name of its array.
        array: String,
        /// The line of the declaration, from 1.
        line: u32,
        /// What the declaration says.
        declared: String,
        /// What the array means.
        meant: String,
    },
    /// What was put in by hand is called as what was added is, another of which was changed: which is which cannot be told.
    #[error(
        "line {line}: whether {name} is one of the {what} that were added cannot be told, as one of those was changed or lost; move what \
         was put in by hand above {first}, or take the original file"
    )]
    Mixed {
        /// The line, from 1.
        line: u32,
        /// The first that may be the one or the other.
        name: String,
        /// `data` or `routines`.
        what: &'static str,
        /// The first that was added for certain.
        first: String,
    },
    /// The module was edited where it must not be.
    #[error("line {line}: {what}; take the original file, or undo that edit")]
    Damaged {
        /// The line, from 1.
        line: u32,
        /// What is the matter.
        what: String,
    },
}

impl RestoreError {
    /// The stable code of the message, listed in `docs/MESSAGES.md`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::NotEmitted => "restore::not-emitted",
            Self::IsCore => "restore::core",
            Self::Disagree { .. } | Self::DeclaredOtherwise { .. } => "restore::disagree",
            Self::Mixed { .. } | Self::Damaged { .. } => "restore::damaged",
        }
    }
}

/// A change of what was added to a module, which its original knows nothing of.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Altered {
    /// Lines of the comment block, so that nothing else can be told.
    #[error(
        "lines of the comment block were changed or lost: what was changed in the module, touched-up points among it, \
         cannot be told; named targets are as in the original"
    )]
    Header {
        /// The block's first line, from 1.
        line: u32,
    },
    /// A correction, or data or a routine of the clock.
    #[error("{name}, which was added, is not as it was made")]
    Code {
        /// The name of the data or routine.
        name: String,
        /// Its first line, from 1.
        line: u32,
    },
    /// A motion asks with an original that was none of its module's: touched up, or put there by hand.
    #[error(
        "{target} is none of the originals that motions had: touched up, or put in by hand, where other motions were taken out or \
         put in too, so that what it was cannot be told; it stays as it is"
    )]
    Original {
        /// What stands in the motion.
        target: String,
        /// The line of its value, from 1.
        line: u32,
    },
    /// What a motion's target says beside the values that it names, a number in it or a constant, is another than it was.
    #[error(
        "{target} is not as it was made: a number in it, or a constant that it names, was changed by hand; it stays as it is, and the \
         correction was made for what it was"
    )]
    Expression {
        /// What stands in the motion.
        target: String,
        /// The motion's line, from 1.
        line: u32,
    },
    /// An array was touched up, and no motion goes by it any more, so that the new value has no place in the original.
    #[error(
        "{target} was touched up on the controller ({array}) and means {meant} now, but the motion that went by it is not there any \
         more: the new value is nowhere in the original"
    )]
    Gone {
        /// What stood in the motion.
        target: String,
        /// The name of the array.
        array: String,
        /// The original that the array means.
        meant: String,
        /// The array's first line, from 1.
        line: u32,
    },
    /// What the program calls or shows of the clock is named by hand, where the source did not name it.
    #[error(
        "{name}, which was added, is named there and was not in the source: the original names what it does not declare, and a \
         controller that has no {name} does not load it"
    )]
    Named {
        /// The name as it stands there.
        name: String,
        /// Its line, from 1.
        line: u32,
    },
    /// A motion names a target that the module declared and declares no more.
    #[error(
        "the motion goes to {target}, whose declaration in this module was taken out or renamed: the original names what nobody declares, \
         or goes to another module's of that name"
    )]
    Lost {
        /// What stands in the motion of the original.
        target: String,
        /// The motion's line, from 1.
        line: u32,
    },
    /// Motions go by an array that was made for one of them.
    #[error(
        "{array} was made for one motion, and several go by it, {}: one was copied, and goes to {target} wherever it came from",
        listed(lines)
    )]
    Copied {
        /// The name of the array.
        array: String,
        /// The target as the original has it in its motion.
        target: String,
        /// The motions' lines, from 1.
        lines: Vec<u32>,
    },
    /// A motion that asked for a target names it as it is.
    #[error(
        "the correction of {target} was taken out of a motion: it goes to {target} as it is, {}",
        listed(lines)
    )]
    Uncorrected {
        /// Name of the target as its declaration has it.
        target: String,
        /// Where it is named as it is, from 1.
        lines: Vec<u32>,
    },
    /// What named a target as it is asks for it corrected.
    #[error(
        "the correction of {target} was put in by hand where {target} stood as it is, {}: what is called there may correct it once more",
        listed(lines)
    )]
    CorrectedByHand {
        /// Name of the target as its declaration has it.
        target: String,
        /// Where it is asked for, from 1.
        lines: Vec<u32>,
    },
    /// A motion asks as only the other point of an arc may.
    #[error(
        "the motion does not ask as it was made: the first target asks the clock (tcK(), tcAt, tcLive), and the second of an arc alone takes \
         the same moment (tcI, tcAtSame, tcLiveSame)"
    )]
    Moment {
        /// The motion's line, from 1.
        line: u32,
    },
    /// What corrects the target is not what it was given, or what the model is asked for not what the motion goes with.
    #[error(
        "the motion asks with another correction than it was given, or the model with another tool or work object than the motion goes with"
    )]
    Arguments {
        /// The motion's line, from 1.
        line: u32,
    },
}

impl Altered {
    /// Where, a line of the emitted module, from 1.
    #[must_use]
    pub fn line(&self) -> u32 {
        match self {
            Self::Header { line }
            | Self::Code { line, .. }
            | Self::Original { line, .. }
            | Self::Expression { line, .. }
            | Self::Gone { line, .. }
            | Self::Named { line, .. }
            | Self::Lost { line, .. }
            | Self::Moment { line }
            | Self::Arguments { line } => *line,
            Self::Copied { lines, .. }
            | Self::Uncorrected { lines, .. }
            | Self::CorrectedByHand { lines, .. } => lines.first().copied().unwrap_or(1),
        }
    }

    /// The stable code of the message, listed in `docs/MESSAGES.md`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Header { .. } => "restore::header",
            Self::Code { .. } => "restore::code",
            Self::Original { .. } => "restore::original",
            Self::Expression { .. } => "restore::expression",
            Self::Gone { .. } => "restore::gone",
            Self::Named { .. } => "restore::named",
            Self::Lost { .. } => "restore::lost",
            Self::Copied { .. } => "restore::copied",
            Self::Uncorrected { .. } => "restore::uncorrected",
            Self::CorrectedByHand { .. } => "restore::corrected",
            Self::Arguments { .. } | Self::Moment { .. } => "restore::arguments",
        }
    }
}

/// Lines one after another: `lines 12, 14`.
fn listed(lines: &[u32]) -> String {
    let all = lines.iter().map(u32::to_string).collect::<Vec<_>>().join(", ");
    format!("{} {all}", if lines.len() == 1 { "line" } else { "lines" })
}

//! What can go wrong, as sentences.

use crate::abb::Refusal;
use std::fmt;

/// Why something could not be had from the controller.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum LinkError {
    /// What was given as a host is none.
    #[error("{0} is no host: write NAME, NAME:PORT, http://NAME or https://NAME")]
    Host(String),
    /// The network does not reach the host.
    #[error("{host} cannot be reached: {cause}")]
    Unreachable {
        /// Host and port, as given.
        host: String,
        /// What the network says.
        cause: String,
    },
    /// No answer, or only a part of one, in time.
    #[error("no complete answer to the {request} ({cause})")]
    NoAnswer {
        /// The request, by what it asks of the controller.
        request: &'static str,
        /// What was seen of it.
        cause: String,
    },
    /// A write without an answer.
    #[error(
        "no complete answer to the {request} ({cause}): whether it took effect is not known; it is not repeated"
    )]
    Uncertain {
        /// The request, by what it asks of the controller.
        request: &'static str,
        /// What was seen of it.
        cause: String,
    },
    /// What answers is no robot controller.
    #[error("what answers there is not Robot Web Services: {0}")]
    NoController(String),
    /// A RobotWare that is not known.
    #[error("the controller says RobotWare {0}; known are 6, 7 and 8")]
    Version(String),
    /// Wrong user or password.
    #[error("the controller refuses the login of user {user}")]
    Login {
        /// Name of the user.
        user: String,
    },
    /// A password would go over the line in the clear.
    #[error("the controller asks for the password in the clear, without TLS: it is not sent")]
    InTheClear,
    /// The certificate is another than at first.
    #[error("the certificate of {host} is not the one seen first: sha256:{now}, and it was sha256:{first}")]
    Certificate {
        /// Host and port, as given.
        host: String,
        /// Digest of the certificate that was pinned, hexadecimal.
        first: String,
        /// Digest of the certificate shown now, hexadecimal.
        now: String,
    },
    /// Another controller answers at the address.
    #[error("another controller answers at {host}: system {now}, and it was {first}")]
    OtherController {
        /// Host and port, as given.
        host: String,
        /// Identity of the controller that was pinned.
        first: String,
        /// The one that answers.
        now: String,
    },
    /// The file of known controllers cannot be read or written.
    #[error("{path}: {cause}")]
    Pins {
        /// The file of known controllers.
        path: String,
        /// What the file system says.
        cause: String,
    },
    /// All sessions of the controller are taken.
    #[error("the controller has no session left for another client")]
    Full,
    /// The controller says no.
    #[error("{request}: {refusal}")]
    Refused {
        /// The request, by what it asks of the controller.
        request: &'static str,
        /// The controller's answer, with its code.
        refusal: Refusal,
    },
    /// Something that is needed is missing from an answer.
    #[error("the answer to the {request} has no {what}")]
    Incomplete {
        /// The request, by what it asks of the controller.
        request: &'static str,
        /// The part that is missing.
        what: String,
    },
    /// This RobotWare has no such request.
    #[error("{dialect} offers no {request}")]
    NotOffered {
        /// Dialect of the controller.
        dialect: String,
        /// The request, by what it asks of the controller.
        request: &'static str,
    },
    /// A name that could mean another resource.
    #[error("{name} is no {what}")]
    Name {
        /// The name as it was given.
        name: String,
        /// What it should have been.
        what: &'static str,
    },
    /// A value that is refused before it is sent.
    #[error("{0}")]
    Value(String),
    /// What was read back is not what was written.
    #[error("{what} is not what was written: {found}")]
    Different {
        /// Which file or data.
        what: String,
        /// What was read back.
        found: String,
    },
    /// RAPID has to stand still, and does not.
    #[error("RAPID is not stopped: {0}")]
    Running(String),
    /// The operator did not say yes.
    #[error("the operator has not allowed it on the pendant ({0})")]
    Operator(String),
    /// The right to write may still be held.
    #[error("the right to write may still be held by this session: {cause}{}", after(.first))]
    RightRemains {
        /// Why the release is not certain.
        cause: String,
        /// What had failed before that.
        first: Option<Box<LinkError>>,
    },
    /// RAPID does not accept the module.
    #[error("{module} holds RAPID errors ({code}); {then}")]
    ModuleErrors {
        /// Name of the module.
        module: String,
        /// 299008 syntax, 299009 semantics.
        code: i64,
        /// What was done about it.
        then: String,
    },
    /// A module went to make room for another one, which did not come.
    #[error("{module} was taken out of {task}, and what should take its place is not loaded ({cause})")]
    TakenOut {
        /// Name of the module, of the one that went and of the one that did not come.
        module: String,
        /// The task that has neither.
        task: String,
        /// What became of the load.
        cause: Box<LinkError>,
    },
    /// The mode changed while something was written.
    #[error("the operating mode changed from {before} to {after} meanwhile: {what}")]
    ModeChanged {
        /// The value before the write.
        before: String,
        /// The value after it.
        after: String,
        /// What that leaves open.
        what: String,
    },
    /// The user interrupted the command (Ctrl-C).
    #[error("interrupted")]
    Interrupted,
}

fn after(first: &Option<Box<LinkError>>) -> String {
    first.as_ref().map_or_else(String::new, |first| format!("; before that: {first}"))
}

impl LinkError {
    /// Its stable code, `link::what`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Host(_) => "link::host",
            Self::Unreachable { .. } => "link::unreachable",
            Self::NoAnswer { .. } => "link::no-answer",
            Self::Uncertain { .. } => "link::uncertain",
            Self::NoController(_) => "link::no-controller",
            Self::Version(_) => "link::version",
            Self::Login { .. } => "link::login",
            Self::InTheClear => "link::in-the-clear",
            Self::Certificate { .. } => "link::certificate",
            Self::OtherController { .. } => "link::other-controller",
            Self::Pins { .. } => "link::known-controllers",
            Self::Full => "link::sessions-full",
            Self::Refused { refusal, .. } => refusal.code(),
            Self::Incomplete { .. } => "link::incomplete",
            Self::NotOffered { .. } => "link::not-offered",
            Self::Name { .. } => "link::name",
            Self::Value(_) => "link::value",
            Self::Different { .. } => "link::different",
            Self::Running(_) => "link::running",
            Self::Operator(_) => "link::operator",
            Self::RightRemains { .. } => "link::right-remains",
            Self::ModuleErrors { .. } => "link::module-errors",
            Self::TakenOut { .. } => "link::taken-out",
            Self::ModeChanged { .. } => "link::mode-changed",
            Self::Interrupted => "link::interrupted",
        }
    }

    /// What to do next.
    #[must_use]
    pub fn help(&self) -> &'static str {
        match self {
            Self::Host(_) => "the address of the controller, as in a browser",
            Self::Unreachable { .. } => {
                "is the controller on, the cable in the right port, the port right? RobotStudio's virtual controller answers other computers \
                 only when they are on its list"
            }
            Self::NoAnswer { .. } | Self::Incomplete { .. } => "nothing was changed by it; run again",
            Self::Uncertain { .. } => {
                "read back what is there (`link get`, or `link push` without --yes) before anything else"
            }
            Self::NoController(_) => {
                "give the address and port of Robot Web Services: 80 on IRC5, 443 on OmniCore"
            }
            Self::Version(_) => "please report it",
            Self::Login { .. } => "give --user, and the password in DRIFTPOST_LINK_PASSWORD or at the prompt",
            Self::InTheClear => "use https://",
            Self::Certificate { .. } | Self::OtherController { .. } => {
                "is it the robot that you mean? If the controller was installed anew, take its line out of the file of known controllers"
            }
            Self::Pins { .. } => "--known FILE names another file",
            Self::Full => "wait five minutes, or close other clients",
            Self::Refused { refusal, .. } => refusal.help(),
            Self::NotOffered { .. } => "nothing to do: this controller does not have it",
            Self::Name { .. } => "give the name as RAPID has it",
            Self::Value(_) => "give a value of the data's own type",
            Self::Different { .. } => "do not load or use it; run again, and compare",
            Self::Running(_) => "stop the program on the pendant, then run again",
            Self::Operator(_) => {
                "in manual mode the pendant asks whether this computer may write: answer it there"
            }
            Self::RightRemains { .. } => {
                "it ends with the session, after five minutes at most; the pendant shows who holds it"
            }
            Self::ModuleErrors { .. } => {
                "are its routines or data loaded under another module's name, the original's? unload that on the pendant; else check the \
                 program in RobotStudio; the file in HOME is as it was sent"
            }
            Self::TakenOut { .. } => {
                "the file is in HOME as it was sent: load it on the pendant, or run again, which puts it in as a new module"
            }
            Self::ModeChanged { .. } => "look at what is there, then run again",
            Self::Interrupted => "the right to write was given back and the session ended",
        }
    }

    /// Whether the controller merely does not have what was asked for.
    #[must_use]
    pub fn is_not_there(&self) -> bool {
        matches!(self, Self::Refused { refusal, .. } if refusal.is_not_there())
    }
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.sentence())?;
        match self.number {
            Some(number) => write!(f, " ({number}, HTTP {})", self.status),
            None => write!(f, " (HTTP {})", self.status),
        }
    }
}

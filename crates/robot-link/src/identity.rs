//! What a controller is and how it stands: reads alone.

use crate::answer::Answer;
use crate::form::Filling;
use crate::requests;
use crate::rights::Holder;
use crate::{Dialect, Execution, LinkError, Mode, Session};
use std::collections::BTreeSet;

/// A list with more pages is rather one that never ends.
const MOST_PAGES: usize = 500;

/// A task of RAPID.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Task {
    /// Its name, such as `T_ROB1`.
    pub name: String,
    /// Whether it moves an arm.
    pub moves: bool,
    /// Whether it is switched on.
    pub is_active: bool,
    /// `ready`, `started` or `stopped`.
    pub state: String,
}

/// What a controller says of itself.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Identity {
    /// Which Robot Web Services.
    pub dialect: Dialect,
    /// RobotWare as it is written, `7.21.0+229`.
    pub version: String,
    /// Name of the controller's system.
    pub system: String,
    /// The controller's own name.
    pub controller: Option<String>,
    /// It is RobotStudio's virtual controller.
    pub is_virtual: bool,
    /// Type of the robot, such as `IRB 140-6/0.8`.
    pub robot: Option<String>,
    /// Options of RobotWare, as the controller names them.
    pub options: Vec<String>,
    /// Operating mode: automatic, or manual at reduced or full speed.
    pub mode: Mode,
    /// `motoron`, `motoroff`, `guardstop`, ...
    pub motors: String,
    /// Whether a program runs.
    pub execution: Execution,
    /// Absolute Accuracy corrects targets; `None` where the controller does not say.
    pub absolute_accuracy: Option<bool>,
    /// Who holds the right to write, if anyone.
    pub writer: Option<String>,
    /// The tasks of RAPID, motion tasks and others.
    pub tasks: Vec<Task>,
}

impl Session {
    /// All that `link info` shows of the controller itself.
    ///
    /// # Errors
    /// No or an incomplete answer.
    pub fn identity(&mut self) -> Result<Identity, LinkError> {
        let system = match &self.system {
            Some(answer) => std::sync::Arc::clone(answer),
            None => std::sync::Arc::new(self.ask(requests::SYSTEM, &[])?),
        };
        let entry = system.one("sys-system")?;
        let options = self.pages(requests::OPTIONS, &[])?;
        let options = options
            .iter()
            .flat_map(|page| page.all("sys-option").filter_map(|o| o.optional("option")))
            .map(str::to_owned);
        let options = options.collect();
        let robot = self.optional(requests::ROBOT_TYPE, &[])?;
        let robot = robot.and_then(|r| Some(r.one("sys-robottype").ok()?.optional("robot-type")?.to_owned()));
        let controller = self.optional(requests::CONTROLLER, &[])?;
        let named = |field: &str| {
            Some(controller.as_ref()?.one("ctrl-identity-info").ok()?.optional(field)?.to_owned())
        };
        let motion = self.optional(requests::MOTION, &[])?;
        let accuracy = motion
            .and_then(|m| m.contents.states.iter().find_map(|s| s.fields.get("absacc-active").cloned()));
        let writer = match self.holder() {
            Ok(Holder::Nobody) => None,
            Ok(Holder::This) => Some("this session".to_owned()),
            Ok(Holder::Remote(name)) => Some(format!("a remote computer ({name})")),
            Ok(Holder::Pendant(name)) => Some(if name.is_empty() { "the pendant".to_owned() } else { name }),
            Err(error) if is_missing(&error) => None,
            Err(error) => return Err(error),
        };
        Ok(Identity {
            dialect: self.dialect,
            version: entry.text("rwversion")?.to_owned(),
            system: entry.text("name")?.to_owned(),
            is_virtual: named("ctrl-type").is_some_and(|kind| kind.to_ascii_uppercase().contains("VIRTUAL")),
            controller: named("ctrl-name"),
            robot,
            options,
            mode: self.mode()?,
            motors: self.ask(requests::MOTORS, &[])?.one("pnl-ctrlstate")?.text("ctrlstate")?.to_owned(),
            execution: self.execution()?,
            absolute_accuracy: accuracy.map(|on| on.trim().eq_ignore_ascii_case("on")),
            writer,
            tasks: self.tasks()?,
        })
    }

    /// Operating mode: automatic, or manual at reduced or full speed.
    ///
    /// # Errors
    /// No or an incomplete answer; a mode that is not known.
    pub fn mode(&mut self) -> Result<Mode, LinkError> {
        let answer = self.ask(requests::MODE, &[])?;
        match answer.one("pnl-opmode")?.text("opmode")?.to_ascii_uppercase().as_str() {
            "AUTO" => Ok(Mode::Auto),
            "MANR" => Ok(Mode::ManualReduced),
            "MANF" => Ok(Mode::ManualFull),
            "INIT" | "AUTO_CH" | "MANF_CH" | "UNDEF" => Ok(Mode::Changing),
            other => Err(answer.without(format!("mode that is known: {other}"))),
        }
    }

    /// Whether a program runs.
    ///
    /// # Errors
    /// No or an incomplete answer.
    pub fn execution(&mut self) -> Result<Execution, LinkError> {
        let answer = self.ask(requests::EXECUTION, &[])?;
        Ok(match answer.one("rap-execution")?.text("ctrlexecstate")? {
            "running" => Execution::Running,
            "stopped" => Execution::Stopped,
            other => Execution::Other(other.to_owned()),
        })
    }

    /// Tasks of RAPID; none while the controller starts.
    ///
    /// # Errors
    /// No or an incomplete answer.
    pub fn tasks(&mut self) -> Result<Vec<Task>, LinkError> {
        let mut tasks = Vec::new();
        for page in self.pages(requests::TASKS, &[])? {
            for task in page.all("rap-task") {
                tasks.push(Task {
                    name: task.text("name")?.to_owned(),
                    moves: task.flag("motiontask")?,
                    is_active: task.flag("active")?,
                    state: task.text("excstate")?.to_owned(),
                });
            }
        }
        Ok(tasks)
    }

    /// All pages of a list, by what each names as the next; a list that leads back to itself is refused.
    pub(crate) fn pages(
        &mut self,
        request: &'static requests::Request,
        arguments: &[(&'static str, &str)],
    ) -> Result<Vec<Answer>, LinkError> {
        let mut found = vec![self.ask(request, arguments)?];
        let mut seen = BTreeSet::new();
        while let Some(page) =
            found.last().and_then(|answer| answer.contents.next.as_deref()).and_then(page_of)
        {
            if seen.len() == MOST_PAGES || !seen.insert(page.clone()) {
                return Err(LinkError::Incomplete { request: request.name, what: "end".to_owned() });
            }
            found.push(self.send(request, Filling { arguments, page: Some(&page), file: None })?);
        }
        Ok(found)
    }

    /// What may be missing on this controller.
    pub(crate) fn optional(
        &mut self,
        request: &'static requests::Request,
        arguments: &[(&'static str, &str)],
    ) -> Result<Option<Answer>, LinkError> {
        match self.ask(request, arguments) {
            Ok(answer) => Ok(Some(answer)),
            Err(error) if is_missing(&error) => Ok(None),
            Err(error) => Err(error),
        }
    }
}

/// The page that a link leads to: of all that it says, `start` and `limit` alone are followed.
fn page_of(next: &str) -> Option<String> {
    let (_, query) = next.split_once('?')?;
    let is_number = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
    let pairs = query.split('&').filter_map(|pair| pair.split_once('='));
    let kept = pairs.filter(|(name, value)| ["start", "limit"].contains(name) && is_number(value));
    let kept: Vec<String> = kept.map(|(name, value)| format!("{name}={value}")).collect();
    (!kept.is_empty()).then(|| kept.join("&"))
}

fn is_missing(error: &LinkError) -> bool {
    matches!(error, LinkError::NotOffered { .. } | LinkError::Refused { .. })
}

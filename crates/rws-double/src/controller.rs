//! How the double stands: mode, execution, tasks, files, rights. A test reads and changes it as an operator would.

use crate::Personality;
use crate::rapid::{self, Data};
use std::collections::BTreeMap;
use std::time::Instant;

/// Who holds the right to write.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Holder {
    /// Nobody holds it now.
    Nobody,
    /// A session, by its number, on a connection.
    Session(u64, u64),
    /// The FlexPendant holds it.
    Pendant,
}

/// What the operator does when asked on the pendant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operator {
    /// Says yes at the second question.
    Grants,
    /// Denies what the pendant asks.
    Denies,
    /// Does not answer the pendant.
    Silent,
}

/// A module in a task.
#[derive(Clone, Debug, PartialEq)]
pub struct Module {
    /// Name of the module.
    pub name: String,
    /// As it was loaded.
    pub text: String,
    /// `ProgMod` (program) or `SysMod` (system).
    pub kind: &'static str,
    pub(crate) data: Vec<Data>,
}

/// A request of a session to the operator.
#[derive(Clone, Debug)]
pub(crate) struct Asking {
    pub session: u64,
    pub polls: u32,
    pub last: Instant,
    pub granted: bool,
}

/// All of the controller's state.
#[derive(Debug)]
pub struct Controller {
    pub(crate) personality: Personality,
    /// `AUTO`, `MANR`, `MANF`, ...
    pub mode: &'static str,
    /// State of RAPID, `running` or `stopped`.
    pub execution: &'static str,
    /// The program pointer stands where a module cannot be taken out.
    pub pointer_is_not_reset: bool,
    /// What the operator does.
    pub operator: Operator,
    /// The user's grants let it write.
    pub has_grants: bool,
    /// The arm has Absolute Accuracy.
    pub has_absolute_accuracy: bool,
    /// It calculates kinematics for others.
    pub offers_kinematics: bool,
    /// The tree of devices tells what is left of RAPID's memory.
    pub tells_memory: bool,
    /// The controller offers subscriptions.
    pub offers_subscriptions: bool,
    /// RAPID finds errors in every module that is loaded.
    pub finds_errors: bool,
    /// Write access ends with each write (seen on RobotWare 8).
    pub write_clears_right: bool,
    /// The logout is refused (seen on RobotWare 6).
    pub refuses_logout: bool,
    /// Remote Access is off (RobotWare 8).
    pub remote_access_is_off: bool,
    /// `Location` leads to a foreign host.
    pub foreign_location: bool,
    /// The system's own name.
    pub system_id: String,
    /// Joints with which the arm stands, degrees.
    pub joints_deg: [f64; 6],
    /// The modules loaded in `T_ROB1`.
    pub modules: Vec<Module>,
    /// Files in HOME, by path.
    pub files: BTreeMap<String, Vec<u8>>,
    /// Who holds the right to write.
    pub holder: Holder,
    /// Stations of RobotWare 8: session, with the name and the id that it registered.
    pub(crate) stations: BTreeMap<u64, (String, String)>,
    /// Station that holds write access.
    pub(crate) holding: Option<String>,
    pub(crate) asking: Option<Asking>,
    /// Names of modules in files that clients have written.
    pub(crate) written: Vec<String>,
    /// Counts changes of data.
    pub(crate) changes: u64,
}

/// The task of the arm.
pub(crate) const TASK: &str = "T_ROB1";
/// Name of its mechanical unit.
pub(crate) const UNIT: &str = "ROB_1";

const BASE: &str = "MODULE BASE(SYSMODULE)\n  PERS num baseCount:=0;\n  PERS string baseText:=\"\";\n  CONST num baseConst:=1;\n\
                    VAR num baseVar:=2;\nENDMODULE\n";

impl Controller {
    pub(crate) fn new(personality: Personality) -> Self {
        let mut controller = Self {
            personality,
            mode: "AUTO",
            execution: "stopped",
            pointer_is_not_reset: false,
            operator: Operator::Grants,
            has_grants: true,
            has_absolute_accuracy: false,
            offers_kinematics: true,
            tells_memory: true,
            offers_subscriptions: true,
            finds_errors: false,
            write_clears_right: false,
            refuses_logout: false,
            remote_access_is_off: false,
            foreign_location: false,
            system_id: "{6D0A4E2C-0000-4000-8000-00000000D0B1}".to_owned(),
            joints_deg: [10.0, 20.0, -10.0, 30.0, 40.0, 50.0],
            modules: Vec::new(),
            files: BTreeMap::new(),
            holder: Holder::Nobody,
            stations: BTreeMap::new(),
            holding: None,
            asking: None,
            written: Vec::new(),
            changes: 0,
        };
        controller.load(BASE, "SysMod");
        controller
    }

    /// Puts a module into the task, as someone at the controller would.
    pub fn load(&mut self, text: &str, kind: &'static str) {
        let name = rapid::module_name(text).unwrap_or_default();
        self.modules.push(Module { name, text: text.to_owned(), kind, data: rapid::data(text) });
        self.changes += 1;
    }

    /// The module of a name.
    #[must_use]
    pub fn module(&self, name: &str) -> Option<&Module> {
        self.modules.iter().find(|module| module.name.eq_ignore_ascii_case(name))
    }

    /// The value of data as RAPID writes it.
    #[must_use]
    pub fn value(&self, module: &str, name: &str) -> Option<String> {
        self.data(module, name).map(|data| data.value.clone())
    }

    /// Changes data as the running program would.
    pub fn run_sets(&mut self, module: &str, name: &str, value: &str) {
        if let Some(data) = self.data_mut(module, name) {
            value.clone_into(&mut data.value);
            self.changes += 1;
        }
    }

    pub(crate) fn data(&self, module: &str, name: &str) -> Option<&Data> {
        self.module(module)?.data.iter().find(|data| data.name.eq_ignore_ascii_case(name))
    }

    pub(crate) fn data_mut(&mut self, module: &str, name: &str) -> Option<&mut Data> {
        let module = self.modules.iter_mut().find(|m| m.name.eq_ignore_ascii_case(module))?;
        module.data.iter_mut().find(|data| data.name.eq_ignore_ascii_case(name))
    }

    /// Whether a client may take a module out: one that it has written, or that holds our own data.
    pub(crate) fn is_clients(&self, name: &str) -> bool {
        let is_written = self.written.iter().any(|written| written.eq_ignore_ascii_case(name));
        is_written || self.module(name).is_some_and(|module| module.text.contains("! driftpost "))
    }
}

//! The controller: program memory, call stack, clock, signals and arm, and what an operator can do to it.

use super::calendar::Calendar;
use super::effort::{Effort, EffortRange};
use super::ir::{Code, Name};
use super::memory::{Memory, State};
use super::motion::Arm;
use super::outcome::{Fault, Message, Outcome, Place, SimulateError};
use super::predefined::Types;
use super::value::{Type, Value};
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::{FileId, TextRange};
use rapid_syntax::tree::DataKind;
use robot_model::deform::Payload;
use robot_model::robot::Robot;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

/// A parameter, local or hidden value of a routine in execution.
#[derive(Clone, Debug)]
pub(super) struct Slot {
    pub ty: Type,
    pub constant: bool,
    pub bound: Bound,
}

#[derive(Clone, Debug)]
pub(super) enum Bound {
    Own(Value),
    Ref(super::place::Place),
    Signal(Name),
    Absent,
}

/// A routine in execution.
#[derive(Debug)]
pub(super) struct Frame {
    pub routine: usize,
    pub module: usize,
    pub code: Rc<Code>,
    pub base: usize,
    pub pc: usize,
    /// The operation in work.
    pub current: usize,
    /// In its ERROR handler: the operation that failed.
    pub failed: Option<usize>,
    pub trap: bool,
    /// What had been executed when it was entered: what a trap does is not part of what it interrupts.
    pub effort: Effort,
    /// Passes of each endless loop, by the operation that jumps back.
    pub passes: BTreeMap<usize, u64>,
}

/// An interrupt.
#[derive(Debug)]
pub(super) struct Interrupt {
    pub number: f32,
    pub trap: usize,
    /// Period and next time in steady seconds, for a timer.
    pub timer: Option<(f64, f64)>,
    pub single: bool,
    pub asleep: bool,
}

/// A virtual controller with one task.
#[derive(Debug)]
pub struct Controller {
    pub(super) memory: Memory,
    pub(super) types: Types,
    pub(super) frames: Vec<Frame>,
    pub(super) stack: Vec<Slot>,
    /// Module and first slot that names are looked up in.
    pub(super) scope: (usize, usize),
    pub(super) returned: Option<Value>,
    pub(super) nesting: usize,
    pub(super) errno: f32,
    pub(super) intno: f32,
    pub(super) booked: u32,
    pub(super) interrupts: Vec<Interrupt>,
    pub(super) calendar: Calendar,
    pub(super) signals: BTreeMap<Name, f32>,
    pub(super) units_down: BTreeSet<Name>,
    /// What the last GripLoad said, in the tool's frame.
    pub(super) gripped: Payload,
    pub(super) disk: BTreeMap<String, Vec<u8>>,
    /// Files of StartLoad that WaitLoad has not yet asked for.
    pub(super) sessions: Vec<Option<String>>,
    pub(super) pinned: BTreeMap<usize, Value>,
    pub(super) arm: Option<Arm>,
    pub(super) messages: Vec<Message>,
    /// Names that were taken from another module, and said to be.
    pub(super) from_elsewhere: BTreeSet<String>,
    pub(super) unknown: BTreeSet<String>,
    pub(super) steps_left: u64,
    pub(super) passes: u64,
    /// All that was executed so far; what a function takes is a difference of it.
    pub(super) effort: Effort,
    /// What functions in arguments of motions took, by routine.
    pub(super) efforts: BTreeMap<usize, EffortRange>,
    /// Arguments of a motion are being evaluated.
    pub(super) is_metered: bool,
    /// Stop after so many more moves.
    pub(super) moves_to_stop: Option<u64>,
    files: u32,
    /// Steps one call may take before it counts as endless.
    pub step_limit: u64,
}

impl Default for Controller {
    fn default() -> Self {
        Self::new()
    }
}

impl Controller {
    /// A controller without arm: it computes, keeps time and lists moves, but knows no joints.
    #[must_use]
    pub fn new() -> Self {
        Self {
            memory: Memory::new(),
            types: Types::new(),
            frames: Vec::new(),
            stack: Vec::new(),
            scope: (usize::MAX, 0),
            returned: None,
            nesting: 0,
            errno: 0.0,
            intno: 0.0,
            booked: 0,
            interrupts: Vec::new(),
            calendar: Calendar::default(),
            signals: BTreeMap::new(),
            units_down: BTreeSet::new(),
            gripped: Payload::default(),
            disk: BTreeMap::new(),
            sessions: Vec::new(),
            pinned: BTreeMap::new(),
            arm: None,
            messages: Vec::new(),
            from_elsewhere: BTreeSet::new(),
            unknown: BTreeSet::new(),
            steps_left: 0,
            passes: 1,
            effort: Effort::default(),
            efforts: BTreeMap::new(),
            is_metered: false,
            moves_to_stop: None,
            files: 0,
            step_limit: 50_000_000,
        }
    }

    /// A controller with the nominal kinematics of `robot`.
    ///
    /// # Errors
    /// [`SimulateError::Arm`] where the robot has no closed-form inverse kinematics.
    pub fn with_robot(robot: &Robot) -> Result<Self, SimulateError> {
        let arm = Arm::new(robot).map_err(SimulateError::Arm)?;
        Ok(Self { arm: Some(arm), ..Self::new() })
    }

    /// Load the modules of a file.
    ///
    /// # Errors
    /// [`SimulateError::Load`] where a controller would refuse, e.g. a name that is there already.
    pub fn load(&mut self, path: &str, bytes: &[u8]) -> Result<(), SimulateError> {
        self.load_as(path, bytes, None)
            .map(drop)
            .map_err(|why| SimulateError::Load { path: path.to_owned(), why })
    }

    pub(super) fn load_as(
        &mut self,
        path: &str,
        bytes: &[u8],
        dynamic: Option<&str>,
    ) -> Result<Vec<usize>, String> {
        let id = FileId(self.files);
        self.files += 1;
        let file = SourceFile::read(id, path, bytes.to_vec());
        self.memory.load(&Rc::new(file), dynamic)
    }

    /// Put a file on the controller's disk, for `Load`; a name matches by its last part.
    pub fn put_file(&mut self, path: &str, bytes: &[u8]) {
        self.disk.insert(super::builtin::modules::file_name(path), bytes.to_vec());
    }

    /// Whether a routine of this name is loaded, LOCAL ones included.
    #[must_use]
    pub fn has_routine(&self, name: &str) -> bool {
        self.memory.routine_anywhere(&name.to_lowercase()).is_some()
    }

    /// Whether data of this name are loaded, LOCAL ones included.
    #[must_use]
    pub fn has_data(&self, name: &str) -> bool {
        self.memory.datum_anywhere(&name.to_lowercase()).is_some()
    }

    /// Call a procedure without arguments; endless loops end after `passes` passes of the outermost.
    ///
    /// # Errors
    /// [`SimulateError::NoRoutine`]
    pub fn call(&mut self, name: &str, passes: u64) -> Result<Outcome, SimulateError> {
        let routine = self
            .memory
            .routine_anywhere(&name.to_lowercase())
            .ok_or_else(|| SimulateError::NoRoutine(name.to_owned()))?;
        self.steps_left = self.step_limit;
        self.passes = passes.max(1);
        Ok(self.run_routine(routine))
    }

    /// The value of data by name, LOCAL ones included.
    ///
    /// # Errors
    /// [`SimulateError::NoData`], or [`SimulateError::Value`] where its initial value cannot be found.
    pub fn value(&mut self, name: &str) -> Result<Value, SimulateError> {
        let datum = self.datum(name)?;
        self.read(&super::place::Place::data(datum)).map_err(|f| Self::value_error(name, &f))
    }

    /// The value of a `num` or `dnum` by name.
    ///
    /// # Errors
    /// As [`Controller::value`], and where it is no number.
    pub fn number(&mut self, name: &str) -> Result<f64, SimulateError> {
        let value = self.value(name)?;
        value.number().ok_or_else(|| SimulateError::Value {
            name: name.to_owned(),
            why: format!("is a {}, not a number", value.type_name()),
        })
    }

    /// The type of data by name, LOCAL ones included.
    ///
    /// # Errors
    /// [`SimulateError::NoData`]
    pub fn type_of(&self, name: &str) -> Result<Type, SimulateError> {
        let datum = self.datum(name)?;
        Ok(self.memory.data.get(datum).map_or(Type::Num, |d| d.ty.clone()))
    }

    /// Give data a value from outside, as an operator does on the teach pendant.
    ///
    /// # Errors
    /// [`SimulateError::NoData`], or [`SimulateError::Value`] where the value is of another type.
    pub fn set(&mut self, name: &str, value: Value) -> Result<(), SimulateError> {
        let datum = self.datum(name)?;
        self.write(&super::place::Place::data(datum), value).map_err(|f| Self::value_error(name, &f))
    }

    /// Hold data at a value whatever the program assigns.
    ///
    /// # Errors
    /// As [`Controller::set`].
    pub fn pin(&mut self, name: &str, value: Value) -> Result<(), SimulateError> {
        let datum = self.datum(name)?;
        self.set(name, value)?;
        let value = self.value(name)?;
        self.pinned.insert(datum, value);
        Ok(())
    }

    fn datum(&self, name: &str) -> Result<usize, SimulateError> {
        let found = self.memory.datum_anywhere(&name.to_lowercase());
        found.ok_or_else(|| SimulateError::NoData(name.to_owned()))
    }

    fn value_error(name: &str, fault: &Fault) -> SimulateError {
        let why = match fault {
            Fault::Raised { text, .. } | Fault::Fatal(text) => text.clone(),
            Fault::Ended(_) => "its initial value does not come to an end".to_owned(),
        };
        SimulateError::Value { name: name.to_owned(), why }
    }

    /// Program pointer to main: VAR start again, modules loaded by the program vanish, interrupts and
    /// ConfL/ConfJ are reset; PERS stay.
    pub fn pp_to_main(&mut self) {
        self.frames.clear();
        self.stack.clear();
        self.scope = (usize::MAX, 0);
        self.interrupts.clear();
        self.gripped = Payload::default();
        self.nesting = 0;
        for id in 0..self.memory.modules.len() {
            if self.memory.modules[id].loaded && self.memory.modules[id].dynamic.is_some() {
                self.memory.unload(id);
            }
        }
        for datum in &mut self.memory.data {
            if datum.kind != DataKind::Pers {
                datum.state = State::Untouched;
            }
        }
        if let Some(arm) = &mut self.arm {
            arm.restart();
        }
    }

    /// All PERS with their present values, as a backup holds them.
    #[must_use]
    pub fn backup(&self) -> Backup {
        let values = self
            .memory
            .data
            .iter()
            .enumerate()
            .filter(|(_, d)| d.kind == DataKind::Pers)
            .map(|(i, d)| match &d.state {
                State::Known(value) => (i, Some(value.clone())),
                _ => (i, None),
            })
            .collect();
        Backup { values }
    }

    /// Restore a backup of this controller and set the program pointer to main.
    pub fn restore(&mut self, backup: &Backup) {
        self.pp_to_main();
        for (datum, value) in &backup.values {
            if let Some(datum) = self.memory.data.get_mut(*datum) {
                datum.state = value.clone().map_or(State::Untouched, State::Known);
            }
        }
    }

    /// Set a signal.
    pub fn set_signal(&mut self, name: &str, value: f32) {
        self.signals.insert(name.to_lowercase().into(), value);
    }

    /// Let the unit of a signal fail, or come back.
    pub fn set_unit_down(&mut self, signal: &str, down: bool) {
        let name: Name = signal.to_lowercase().into();
        if down {
            self.units_down.insert(name);
        } else {
            self.units_down.remove(&name);
        }
    }

    /// What signals stand at.
    #[must_use]
    pub fn signal(&self, name: &str) -> Option<f32> {
        self.signals.get(name.to_lowercase().as_str()).copied()
    }

    /// Date, time and steady clock.
    #[must_use]
    pub fn calendar(&self) -> &Calendar {
        &self.calendar
    }

    /// Date, time and steady clock, to be set.
    pub fn calendar_mut(&mut self) -> &mut Calendar {
        &mut self.calendar
    }

    /// The arm, if there is one.
    #[must_use]
    pub fn arm(&self) -> Option<&Arm> {
        self.arm.as_ref()
    }

    /// The arm, if there is one, to be set.
    pub fn arm_mut(&mut self) -> Option<&mut Arm> {
        self.arm.as_mut()
    }

    /// What was shown since the last time this was asked for.
    pub fn take_messages(&mut self) -> Vec<Message> {
        std::mem::take(&mut self.messages)
    }

    /// Instructions, functions and text that this controller does not know, met in execution.
    #[must_use]
    pub fn unknown_instructions(&self) -> Vec<String> {
        self.unknown.iter().cloned().collect()
    }

    /// The operation in work: file and line.
    pub(super) fn here(&self) -> Place {
        let Some(frame) = self.frames.last() else { return Place::default() };
        let range = frame.code.steps.get(frame.current).map(|s| s.range);
        self.place_of(frame.module, range.unwrap_or(TextRange::empty(0)))
    }

    pub(super) fn place_of(&self, module: usize, range: TextRange) -> Place {
        match self.memory.modules.get(module) {
            Some(m) => Place { file: m.file.path.clone(), line: m.file.line(range) },
            None => Place::default(),
        }
    }

    /// Show a message at the operation in work; the same one at the same place only once.
    pub(super) fn tell(&mut self, source: &'static str, text: impl Into<String>) {
        let message = Message { source, text: text.into(), at: self.here() };
        if self.messages.len() < 100_000 && (source != "controller" || !self.messages.contains(&message)) {
            self.messages.push(message);
        }
    }
}

/// The PERS of a controller at one time.
#[derive(Clone, Debug)]
pub struct Backup {
    values: Vec<(usize, Option<Value>)>,
}

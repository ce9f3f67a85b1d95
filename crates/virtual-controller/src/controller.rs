//! The controller as an operator has it: what can be loaded, called, set, stopped and asked.

use super::arm::ControllerArm;
use super::backwards::BackStep;
use super::builtin::{Tables, moves, parse as parse_value};
use super::calendar::Calendar;
use super::code::{Callee, Op};
use super::effort::EffortRange;
use super::entry;
use super::ids::{ModuleId, RoutineId};
use super::interpreter::Interpreter;
use super::loaded::LoadedProgram;
use super::machine::StepLimit;
use super::machine::{DataRef, DataState, Disk, Machine};
use super::outcome::{Fault, Message, Outcome, SimulateError};
use super::sphere::Sphere;
use super::value::{Type, Value};
use rapid_syntax::tree::DataKind;
use robot_model::deform::{DeformedArm, Payload};
use robot_model::robot::Robot;
use std::collections::{BTreeMap, BTreeSet};

/// Steps that one call may take before it counts as endless, where nothing else is said.
const STEP_LIMIT: StepLimit = StepLimit::new(50_000_000);

/// A virtual controller with one task: the program that is loaded, the state of the machine, and an arm.
#[derive(Debug)]
pub struct Controller {
    program: LoadedProgram,
    machine: Machine,
    arm: Option<ControllerArm>,
    /// Steps one call may take before it counts as endless.
    pub step_limit: StepLimit,
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
        Self { program: LoadedProgram::new(), machine: Machine::default(), arm: None, step_limit: STEP_LIMIT }
    }

    /// A controller with the nominal kinematics of `robot`.
    ///
    /// # Errors
    /// [`SimulateError::Arm`] where the robot has no closed-form inverse kinematics.
    pub fn with_robot(robot: &Robot) -> Result<Self, SimulateError> {
        let arm = ControllerArm::new(robot).map_err(SimulateError::Arm)?;
        Ok(Self { arm: Some(arm), ..Self::new() })
    }

    /// What executes: program, state and arm for as long as something runs.
    fn interpreter(&mut self) -> Interpreter<'_> {
        Interpreter {
            program: &mut self.program,
            machine: &mut self.machine,
            arm: self.arm.as_mut(),
            built_ins: &Tables,
        }
    }

    /// Load the modules of a file.
    ///
    /// # Errors
    /// [`SimulateError::Load`] where a controller would refuse, e.g. a name that is there already.
    pub fn load(&mut self, path: &str, bytes: &[u8]) -> Result<(), SimulateError> {
        self.program.load(path, bytes, None).map_err(|why| SimulateError::Load { path: path.to_owned(), why })
    }

    /// Put a file on the controller's disk, for `Load`; a name matches by its last part.
    pub fn put_file(&mut self, path: &str, bytes: &[u8]) {
        self.machine.disk.files.insert(Disk::file_name(path), bytes.to_vec());
    }

    /// The files on the controller's disk by name in lower case, those that a program wrote among them.
    #[must_use]
    pub fn files(&self) -> &BTreeMap<String, Vec<u8>> {
        &self.machine.disk.files
    }

    /// Whether the disk refuses to be written to from now on, as a full one does.
    pub fn protect_disk(&mut self, protected: bool) {
        self.machine.disk.protected = protected;
    }

    /// Whether a routine of this name is loaded, LOCAL ones included.
    #[must_use]
    pub fn has_routine(&self, name: &str) -> bool {
        self.program.routine_anywhere(&name.to_lowercase()).is_some()
    }

    /// Whether data of this name are loaded, LOCAL ones included.
    #[must_use]
    pub fn has_data(&self, name: &str) -> bool {
        self.program.datum_anywhere(&name.to_lowercase()).is_some()
    }

    /// The routine to start at: main, else the only procedure without parameters that nothing calls. The
    /// operator's routines of an emitted module (`tc...`) do not count.
    ///
    /// # Errors
    /// [`SimulateError::NoEntry`] names the candidates.
    pub fn entry(&self) -> Result<String, SimulateError> {
        entry::entry(&self.program)
    }

    /// How many motion instructions the program's modules hold, but for routines of these names.
    #[must_use]
    pub fn motion_count_except(&self, names: &[&str]) -> usize {
        let counts = |name: &str| !names.iter().any(|other| other.eq_ignore_ascii_case(name));
        // A module that comes and goes is one of the program, however often it came.
        let modules = self.program.modules.iter().enumerate();
        let last: BTreeMap<_, ModuleId> =
            modules.map(|(id, m)| ((&*m.file.path, &*m.name), ModuleId::new(id))).collect();
        let last: BTreeSet<ModuleId> = last.into_values().collect();
        let routines = self
            .program
            .routines
            .iter()
            .enumerate()
            .filter(|(_, r)| last.contains(&r.module) && counts(&r.name));
        let motions = routines.filter_map(|(id, routine)| {
            let code = self.program.code(RoutineId::new(id))?;
            let is_motion = |op: &Op| match op {
                Op::Call(call) => match &call.callee {
                    Callee::Name(name, _) => {
                        moves::form(name).is_some()
                            && self.program.routine(Some(routine.module), name).is_none()
                    }
                    Callee::Late(_) => false,
                },
                _ => false,
            };
            Some(code.instructions.iter().filter(|instruction| is_motion(&instruction.op)).count())
        });
        motions.sum()
    }

    /// Call a procedure without arguments; endless loops end after `passes` passes of the outermost.
    ///
    /// # Errors
    /// [`SimulateError::NoRoutine`]
    pub fn call(&mut self, name: &str, passes: u64) -> Result<Outcome, SimulateError> {
        self.call_with(name, &[], passes)
    }

    /// Call a procedure with values for its required parameters, as text; it fails where they are not as many.
    ///
    /// # Errors
    /// [`SimulateError::NoRoutine`], [`SimulateError::Value`] where a text is no value of a parameter's type.
    pub fn call_with(
        &mut self,
        name: &str,
        values: &[String],
        passes: u64,
    ) -> Result<Outcome, SimulateError> {
        let routine = self
            .program
            .routine_anywhere(&name.to_lowercase())
            .ok_or_else(|| SimulateError::NoRoutine(name.to_owned()))?;
        let parameters = self.interpreter().required_parameters(routine).unwrap_or_default();
        // More values than parameters are told by the call.
        let types =
            parameters.iter().map(|(name, ty)| (&**name, ty)).chain(std::iter::repeat(("", &Type::Num)));
        let values = values.iter().zip(types).map(|(text, (parameter, ty))| {
            parse_value(text, ty).ok_or_else(|| SimulateError::Value {
                name: format!("{name}, {parameter}"),
                why: format!("`{text}` is no {}", ty.name()),
            })
        });
        let values = values.collect::<Result<_, _>>()?;
        self.machine.limits.begin(self.step_limit);
        self.machine.limits.passes = passes.max(1);
        Ok(self.interpreter().run_routine(routine, values))
    }

    /// Call a procedure without arguments from the beginning and stop it behind so many of its moves.
    ///
    /// # Errors
    /// [`SimulateError::NoRoutine`]
    pub fn call_until(&mut self, name: &str, moves: u64) -> Result<Outcome, SimulateError> {
        self.machine.stack.clear();
        self.machine.limits.moves_left = Some(moves);
        let outcome = self.call(name, 1);
        self.machine.limits.moves_left = None;
        outcome
    }

    /// Go on from where the program was stopped, to its end or for so many moves more.
    pub fn resume(&mut self, moves: Option<u64>) -> Outcome {
        self.machine.limits.begin(self.step_limit);
        self.machine.limits.moves_left = moves;
        let outcome = self.interpreter().resume_run();
        self.machine.limits.moves_left = None;
        outcome
    }

    /// Go through the statement before the one at which the program is stopped, backwards.
    pub fn step_back(&mut self) -> BackStep {
        self.machine.limits.begin(self.step_limit);
        self.interpreter().step_back()
    }

    /// The value of data by name, LOCAL ones included.
    ///
    /// # Errors
    /// [`SimulateError::NoData`], or [`SimulateError::Value`] where its initial value cannot be found.
    pub fn value(&mut self, name: &str) -> Result<Value, SimulateError> {
        let datum = self.datum(name)?;
        self.interpreter().read(&DataRef::data(datum)).map_err(|f| Self::value_error(name, &f))
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
        Ok(self.program.data.get(datum).map_or(Type::Num, |d| d.ty.clone()))
    }

    /// Give data a value from outside, as an operator does on the teach pendant.
    ///
    /// # Errors
    /// [`SimulateError::NoData`], or [`SimulateError::Value`] where the value is of another type.
    pub fn set(&mut self, name: &str, value: Value) -> Result<(), SimulateError> {
        let datum = self.datum(name)?;
        self.interpreter().write(&DataRef::data(datum), value).map_err(|f| Self::value_error(name, &f))
    }

    /// Hold data at a value whatever the program assigns.
    ///
    /// # Errors
    /// As [`Controller::set`].
    pub fn pin(&mut self, name: &str, value: Value) -> Result<(), SimulateError> {
        let datum = self.datum(name)?;
        self.set(name, value)?;
        let value = self.value(name)?;
        self.machine.data.pinned.insert(datum, value);
        Ok(())
    }

    fn datum(&self, name: &str) -> Result<usize, SimulateError> {
        let found = self.program.datum_anywhere(&name.to_lowercase());
        found.ok_or_else(|| SimulateError::NoData(name.to_owned()))
    }

    fn value_error(name: &str, fault: &Fault) -> SimulateError {
        let why = match fault {
            Fault::Raised { text, .. } | Fault::Fatal(text) => text.clone(),
            Fault::Ended(Outcome::OverLimit { what, .. }) => what.clone(),
            Fault::Ended(_) => "its initial value does not come to an end".to_owned(),
        };
        SimulateError::Value { name: name.to_owned(), why }
    }

    /// So much hangs on the flange, kg, whatever tool and GripLoad say; `None` = what they say.
    pub fn carry(&mut self, payload_kg: Option<f64>) {
        self.machine.payload_kg = payload_kg;
    }

    /// Program pointer to main: VAR start again, modules loaded by the program vanish, interrupts and
    /// ConfL/ConfJ are reset; PERS stay.
    pub fn pp_to_main(&mut self) {
        self.machine.stack.clear();
        self.machine.interrupts.list.clear();
        self.machine.gripped = Payload::default();
        for datum in self.program.unload_dynamic() {
            self.machine.data.forget(datum);
        }
        for (id, datum) in self.program.data.iter().enumerate() {
            if datum.kind == DataKind::Var {
                self.machine.data.forget(id);
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
            .program
            .data
            .iter()
            .enumerate()
            .filter(|(_, d)| d.kind == DataKind::Pers)
            .map(|(id, _)| (id, self.machine.data.known(id).cloned()))
            .collect();
        Backup { values }
    }

    /// Restore a backup of this controller and set the program pointer to main.
    pub fn restore(&mut self, backup: &Backup) {
        self.pp_to_main();
        for (datum, value) in &backup.values {
            *self.machine.data.state_mut(*datum) =
                value.clone().map_or(DataState::Untouched, DataState::Known);
        }
    }

    /// Set the level of a signal; its name in any case.
    pub fn set_signal(&mut self, name: &str, value: f32) {
        self.machine.signals.levels.insert(name.to_lowercase().into(), value);
    }

    /// Let the unit of a signal fail, or come back.
    pub fn set_unit_down(&mut self, signal: &str, down: bool) {
        let name = signal.to_lowercase();
        if down {
            self.machine.signals.units_down.insert(name.into());
        } else {
            self.machine.signals.units_down.remove(name.as_str());
        }
    }

    /// Puts a sphere into the cell, which searches by its signal find with the true arm.
    pub fn put_sphere(&mut self, sphere: Sphere) {
        self.machine.spheres.add(sphere);
    }

    /// The arm as it truly is from now on: what searches meet spheres with.
    pub fn set_true_arm(&mut self, arm: DeformedArm) {
        self.machine.spheres.arm = Some(arm);
    }

    /// What signals stand at.
    #[must_use]
    pub fn signal(&self, name: &str) -> Option<f32> {
        self.machine.signals.levels.get(name.to_lowercase().as_str()).copied()
    }

    /// Date, time and steady clock.
    #[must_use]
    pub fn calendar(&self) -> &Calendar {
        &self.machine.calendar
    }

    /// Date, time and steady clock, to be set.
    pub fn calendar_mut(&mut self) -> &mut Calendar {
        &mut self.machine.calendar
    }

    /// The arm, if there is one.
    #[must_use]
    pub fn arm(&self) -> Option<&ControllerArm> {
        self.arm.as_ref()
    }

    /// The arm, if there is one, to be set.
    pub fn arm_mut(&mut self) -> Option<&mut ControllerArm> {
        self.arm.as_mut()
    }

    /// What was shown since the last time this was asked for.
    pub fn take_messages(&mut self) -> Vec<Message> {
        self.machine.log.take_messages()
    }

    /// Instructions, functions and text that this controller does not know, met in execution.
    #[must_use]
    pub fn unknown_instructions(&self) -> Vec<String> {
        self.machine.log.unknown.iter().cloned().collect()
    }

    /// What the program's functions took that motions call in their arguments, or that were called from
    /// outside, by name as declared, since the last time this was asked for. What such a function calls
    /// itself is part of it; what stands in its own arguments is not.
    pub fn take_efforts(&mut self) -> BTreeMap<String, EffortRange> {
        let name =
            |routine: RoutineId| self.program.routines.get(routine.index()).map(|r| r.name.to_string());
        let efforts = self.machine.meter.take_ranges().into_iter();
        efforts.filter_map(|(routine, range)| Some((name(routine)?, range))).collect()
    }
}

/// The PERS of a controller at one time.
#[derive(Clone, Debug)]
pub struct Backup {
    values: Vec<(usize, Option<Value>)>,
}

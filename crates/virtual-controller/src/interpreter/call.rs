//! Calls: arguments to parameters by mode, interrupts to traps.

use super::Interpreter;
use crate::code::{Call, Expr, ExprKind, Name, Param};
use crate::ids::RoutineId;
use crate::loaded::RoutineKind;
use crate::machine::{Access, Binding, DataRef, MOST_INTERRUPTS, Slot};
use crate::outcome::{Fault, fatal, raise};
use crate::value::{Type, Value};
use rapid_syntax::tree::ParamMode;

impl Interpreter<'_> {
    /// A statement that calls: a procedure of the program, else an instruction of the controller.
    pub(crate) fn call_procedure(&mut self, name: &Name, spelt: &str, call: &Call) -> Result<(), Fault> {
        let Some(routine) = self.program.routine(self.machine.stack.scope.0, name) else {
            return self.built_ins.instruction(self, name, spelt, call);
        };
        match self.program.kind(routine) {
            Some(RoutineKind::Proc) => {
                let slots = self.bind(routine, call)?;
                self.enter(routine, slots, false)
            }
            _ => fatal(format!("{spelt} is no procedure")),
        }
    }

    /// A function call in an expression.
    pub(crate) fn call_function(
        &mut self,
        name: &Name,
        spelt: &str,
        call: &Call,
        want: Option<&Type>,
    ) -> Result<Value, Fault> {
        let Some(routine) = self.program.routine(self.machine.stack.scope.0, name) else {
            return self.built_ins.function(self, name, spelt, call, want);
        };
        match self.program.kind(routine) {
            Some(RoutineKind::Func(_)) => {
                let slots = self.bind(routine, call)?;
                self.run_function(routine, slots)
            }
            _ => fatal(format!("{spelt} is no function")),
        }
    }

    /// The slots of a routine's parameters for a call.
    pub(crate) fn bind(&mut self, routine: RoutineId, call: &Call) -> Result<Vec<Slot>, Fault> {
        let code = self.code(routine)?;
        let module = self.program.module_of(routine);
        let args = self.args("", call);
        let mut positional = args.positional.iter();
        let mut slots = Vec::with_capacity(code.slots);
        for param in &code.params {
            let ty = self.program.type_named(module, &param.type_name).array_of(param.dims);
            let binding = if param.optional {
                match args.named(&param.name) {
                    Some(expr) => self.bind_argument(param, &ty, expr)?,
                    None if args.has(&param.name) => Binding::Own(Value::Bool(true)),
                    None => Binding::Absent,
                }
            } else {
                match positional.next() {
                    Some(expr) => self.bind_argument(param, &ty, expr)?,
                    None => return fatal(format!("the argument for {} is missing", param.name)),
                }
            };
            slots.push(Slot { ty, constant: false, binding });
        }
        if positional.next().is_some() {
            return fatal("more arguments than parameters");
        }
        let is_unknown = |name: &&Name| !code.params.iter().any(|p| p.optional && p.name == **name);
        if let Some(name) = args.names().find(is_unknown) {
            return fatal(format!("there is no optional parameter {name}"));
        }
        Ok(slots)
    }

    fn bind_argument(&mut self, param: &Param, ty: &Type, expr: &Expr) -> Result<Binding, Fault> {
        if let Type::Other(_) = ty {
            return self.bind_device(expr);
        }
        if param.mode == ParamMode::In {
            return self.eval_as(expr, ty).map(Binding::Own);
        }
        let Some((place, given)) = self.data_ref_or_own(expr)? else {
            return fatal(format!("the argument for {} must be data", param.name));
        };
        if given != *ty {
            return fatal(format!("{} is a {}, not a {}", param.name, ty.name(), given.name()));
        }
        match (param.mode, self.access(&place)) {
            (ParamMode::Var, Access::Variable)
            | (ParamMode::Pers, Access::Persistent)
            | (ParamMode::InOut, Access::Variable | Access::Persistent) => Ok(Binding::Ref(place)),
            (mode, _) => fatal(format!("the argument for {} ({mode:?}) is of another kind", param.name)),
        }
    }

    /// A place, or the controller's own tool0, wobj0 and load0, which are PERS that no module declares.
    fn data_ref_or_own(&mut self, expr: &Expr) -> Result<Option<(DataRef, Type)>, Fault> {
        let place = self.data_ref(expr)?;
        let (None, ExprKind::Name(named)) = (&place, &expr.kind) else { return Ok(place) };
        Ok(self.program.own_datum(&named.name).map(|(datum, ty)| (DataRef::data(datum), ty)))
    }

    /// Signals, devices and data of unknown types are handed on by what they are.
    fn bind_device(&mut self, expr: &Expr) -> Result<Binding, Fault> {
        if let Some((place, _)) = self.data_ref(expr)? {
            return Ok(Binding::Ref(place));
        }
        match &expr.kind {
            ExprKind::Name(named) => Ok(Binding::Signal(named.name.clone())),
            ExprKind::Local(slot) => match self.machine.stack.local(*slot).cloned() {
                Some(bound) => Ok(bound),
                None => fatal("no such local"),
            },
            _ => self.eval(expr, None).map(Binding::Own),
        }
    }

    /// The name of the signal an argument means.
    pub(crate) fn signal_name(&mut self, expr: &Expr) -> Result<Name, Fault> {
        match &expr.kind {
            ExprKind::Name(named) => Ok(named.name.clone()),
            ExprKind::Local(slot) => match self.machine.stack.local(*slot) {
                Some(Binding::Signal(name)) => Ok(name.clone()),
                _ => fatal("a signal is asked for"),
            },
            _ => fatal("a signal is asked for"),
        }
    }

    /// CONNECT: a new interrupt for a trap.
    pub(crate) fn connect(&mut self, interrupt: &Expr, trap: &Name) -> Result<(), Fault> {
        let Some(routine) = self.program.routine(self.machine.stack.scope.0, trap) else {
            return raise("err_refunkprc", format!("there is no trap {trap}"));
        };
        let Some((place, _)) = self.data_ref(interrupt)? else {
            return fatal("CONNECT expects a variable");
        };
        let old = self.read(&place)?.number().unwrap_or(0.0) as f32;
        if self.machine.interrupts.list.iter().any(|i| i.number == old) {
            return raise("err_alrdycnt", "the interrupt is connected already");
        }
        if self.machine.interrupts.list.len() >= MOST_INTERRUPTS {
            return raise("err_inomax", format!("{MOST_INTERRUPTS} interrupts are connected already"));
        }
        let number = self.machine.interrupts.next_number();
        self.write(&place, Value::Num(number))?;
        self.machine.interrupts.connect(number, routine);
        Ok(())
    }

    /// Whether an interrupt would be served: traps do not interrupt traps.
    fn is_interruptible(&self) -> bool {
        !self.machine.interrupts.list.is_empty() && !self.machine.stack.frames.iter().any(|f| f.trap)
    }

    /// Waits; traps run when their timers are due, and what they take is part of the wait.
    pub(crate) fn wait(&mut self, seconds: f64) -> Result<(), Fault> {
        let end_s = self.machine.calendar.steady_s() + seconds;
        let left_s = |vm: &Self, until_s: f64| (until_s - vm.machine.calendar.steady_s()).max(0.0);
        let depth = self.machine.stack.frames.len();
        while self.is_interruptible()
            && let Some(due_s) = self.machine.interrupts.next_due_s().filter(|due_s| *due_s <= end_s)
        {
            let left_s = left_s(self, due_s);
            self.machine.calendar.advance_s(left_s);
            self.interrupt()?;
            self.run(depth)?;
        }
        let left_s = left_s(self, end_s);
        self.machine.calendar.advance_s(left_s);
        Ok(())
    }

    /// Runs the traps whose timers were due during a move, at its end, each as often as it was due.
    pub(crate) fn serve_missed(&mut self) -> Result<(), Fault> {
        let end_s = self.machine.calendar.steady_s();
        let depth = self.machine.stack.frames.len();
        while self.is_interruptible()
            && let Some(trap) = self.machine.interrupts.take_first(end_s)
        {
            self.enter(trap, Vec::new(), true)?;
            self.run(depth)?;
        }
        Ok(())
    }

    /// Start the trap of an interrupt that is due.
    pub(crate) fn interrupt(&mut self) -> Result<(), Fault> {
        if !self.is_interruptible() {
            return Ok(());
        }
        match self.machine.interrupts.take_due(self.machine.calendar.steady_s()) {
            Some(trap) => self.enter(trap, Vec::new(), true),
            None => Ok(()),
        }
    }
}

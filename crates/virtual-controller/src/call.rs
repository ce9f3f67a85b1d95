//! Calls: arguments to parameters by mode, interrupts to traps.

use super::controller::{Bound, Controller, Interrupt, Slot};
use super::ir::{Arg, Call, Expr, ExprKind, Name, Param};
use super::memory::Kind;
use super::outcome::{Fault, fatal, raise};
use super::place::{Access, Place};
use super::predefined;
use super::value::{Type, Value};
use rapid_syntax::tree::ParamMode;

/// The arguments of a call, those by position apart from those by name.
pub(super) struct Args<'c> {
    pub positional: Vec<&'c Expr>,
    named: Vec<(&'c Name, Option<&'c Expr>)>,
}

impl<'c> Args<'c> {
    /// The argument at a position.
    pub fn at(&self, index: usize) -> Result<&'c Expr, Fault> {
        match self.positional.get(index) {
            Some(e) => Ok(e),
            None => fatal(format!("argument {} is missing", index + 1)),
        }
    }

    /// Whether a switch or named argument is given.
    pub fn has(&self, name: &str) -> bool {
        self.named.iter().any(|(n, _)| ***n == *name)
    }

    /// The value given by name.
    pub fn named(&self, name: &str) -> Option<&'c Expr> {
        self.named.iter().find(|(n, _)| ***n == *name).and_then(|(_, e)| *e)
    }
}

impl Controller {
    /// Sort the arguments of a call; `\x?y` counts where `y` is present.
    pub(super) fn args<'c>(&self, call: &'c Call) -> Args<'c> {
        let mut args = Args { positional: Vec::new(), named: Vec::new() };
        for arg in &call.args {
            match arg {
                Arg::Positional(e) => args.positional.push(e),
                Arg::Switch(name) => args.named.push((name, None)),
                Arg::Named(name, e) => args.named.push((name, Some(e))),
                Arg::Conditional(name, e) => {
                    if self.present(e) {
                        args.named.push((name, Some(e)));
                    }
                }
            }
        }
        args
    }

    /// Whether an optional parameter was given.
    pub(super) fn present(&self, expr: &Expr) -> bool {
        match expr.kind {
            ExprKind::Local(slot) => {
                !matches!(self.stack.get(self.scope.1 + slot).map(|s| &s.bound), Some(Bound::Absent) | None)
            }
            _ => true,
        }
    }

    /// A statement that calls: a procedure of the program, else an instruction of the controller.
    pub(super) fn call_procedure(&mut self, name: &Name, spelt: &str, call: &Call) -> Result<(), Fault> {
        let Some(routine) = self.memory.routine(self.scope.0, name) else {
            return self.instruction(name, spelt, call);
        };
        match self.memory.routines.get(routine).map(|r| &r.kind) {
            Some(Kind::Proc) => {
                let slots = self.bind(routine, call)?;
                self.enter(routine, slots, false)
            }
            _ => fatal(format!("{spelt} is no procedure")),
        }
    }

    /// A function call in an expression.
    pub(super) fn call_function(
        &mut self,
        name: &Name,
        spelt: &str,
        call: &Call,
        want: Option<&Type>,
    ) -> Result<Value, Fault> {
        let Some(routine) = self.memory.routine(self.scope.0, name) else {
            return self.function(name, spelt, call, want);
        };
        match self.memory.routines.get(routine).map(|r| &r.kind) {
            Some(Kind::Func(_)) => {
                let slots = self.bind(routine, call)?;
                self.run_function(routine, slots)
            }
            _ => fatal(format!("{spelt} is no function")),
        }
    }

    /// The slots of a routine's parameters for a call.
    pub(super) fn bind(&mut self, routine: usize, call: &Call) -> Result<Vec<Slot>, Fault> {
        let code = self.code(routine)?;
        let module = self.memory.routines.get(routine).map_or(usize::MAX, |r| r.module);
        let args = self.args(call);
        let mut positional = args.positional.iter();
        let mut slots = Vec::with_capacity(code.slots);
        for param in &code.params {
            let ty = self.memory.type_named(module, &param.type_name).array_of(param.dims);
            let bound = if param.optional {
                match args.named(&param.name) {
                    Some(expr) => self.bind_one(param, &ty, expr)?,
                    None if args.has(&param.name) => Bound::Own(Value::Bool(true)),
                    None => Bound::Absent,
                }
            } else {
                match positional.next() {
                    Some(expr) => self.bind_one(param, &ty, expr)?,
                    None => return fatal(format!("the argument for {} is missing", param.name)),
                }
            };
            slots.push(Slot { ty, constant: false, bound });
        }
        if positional.next().is_some() {
            return fatal("more arguments than parameters");
        }
        for (name, _) in &args.named {
            if !code.params.iter().any(|p| p.optional && p.name == **name) {
                return fatal(format!("there is no optional parameter {name}"));
            }
        }
        Ok(slots)
    }

    fn bind_one(&mut self, param: &Param, ty: &Type, expr: &Expr) -> Result<Bound, Fault> {
        if let Type::Other(_) = ty {
            return self.bind_device(expr);
        }
        if param.mode == ParamMode::In {
            return self.eval_as(expr, ty).map(Bound::Own);
        }
        let Some((place, given)) = self.place_or_own(expr)? else {
            return fatal(format!("the argument for {} must be data", param.name));
        };
        if given != *ty {
            return fatal(format!("{} is a {}, not a {}", param.name, ty.name(), given.name()));
        }
        match (param.mode, self.access(&place)) {
            (ParamMode::Var, Access::Variable)
            | (ParamMode::Pers, Access::Persistent)
            | (ParamMode::InOut, Access::Variable | Access::Persistent) => Ok(Bound::Ref(place)),
            (mode, _) => fatal(format!("the argument for {} ({mode:?}) is of another kind", param.name)),
        }
    }

    /// A place, or the controller's own tool0, wobj0 and load0, which are PERS that no module declares.
    fn place_or_own(&mut self, expr: &Expr) -> Result<Option<(Place, Type)>, Fault> {
        let place = self.place(expr)?;
        let (None, ExprKind::Name(name, _)) = (&place, &expr.kind) else { return Ok(place) };
        let ty = match &**name {
            "tool0" => &self.types.tooldata,
            "wobj0" => &self.types.wobjdata,
            "load0" => &self.types.loaddata,
            _ => return Ok(None),
        };
        let ty = ty.clone();
        let Some(value) = predefined::constant(&self.types, name) else { return Ok(None) };
        Ok(Some((Place::data(self.memory.own_datum(name, ty.clone(), value)), ty)))
    }

    /// Signals, devices and data of unknown types are handed on by what they are.
    fn bind_device(&mut self, expr: &Expr) -> Result<Bound, Fault> {
        if let Some((place, _)) = self.place(expr)? {
            return Ok(Bound::Ref(place));
        }
        match &expr.kind {
            ExprKind::Name(name, _) => Ok(Bound::Signal(name.clone())),
            ExprKind::Local(slot) => match self.stack.get(self.scope.1 + slot).map(|s| s.bound.clone()) {
                Some(bound) => Ok(bound),
                None => fatal("no such local"),
            },
            _ => self.eval(expr, None).map(Bound::Own),
        }
    }

    /// The name of the signal an argument means.
    pub(super) fn signal_name(&mut self, expr: &Expr) -> Result<Name, Fault> {
        match &expr.kind {
            ExprKind::Name(name, _) => Ok(name.clone()),
            ExprKind::Local(slot) => match self.stack.get(self.scope.1 + slot).map(|s| &s.bound) {
                Some(Bound::Signal(name)) => Ok(name.clone()),
                _ => fatal("a signal is asked for"),
            },
            _ => fatal("a signal is asked for"),
        }
    }

    /// CONNECT: a new interrupt for a trap.
    pub(super) fn connect(&mut self, interrupt: &Expr, trap: &Name) -> Result<(), Fault> {
        let Some(routine) = self.memory.routine(self.scope.0, trap) else {
            return raise("err_refunkprc", format!("there is no trap {trap}"));
        };
        let Some((place, _)) = self.place(interrupt)? else {
            return fatal("CONNECT wants a variable");
        };
        let old = self.read(&place)?.number().unwrap_or(0.0) as f32;
        if self.interrupts.iter().any(|i| i.number == old) {
            return raise("err_alrdycnt", "the interrupt is connected already");
        }
        let number = self.interrupts.iter().map(|i| i.number).fold(0.0, f32::max) + 1.0;
        self.write(&place, Value::Num(number))?;
        self.interrupts.push(Interrupt { number, trap: routine, timer: None, single: false, asleep: false });
        Ok(())
    }

    /// Start the trap of an interrupt that is due; traps do not interrupt traps.
    pub(super) fn interrupt(&mut self) -> Result<(), Fault> {
        if self.interrupts.is_empty() || self.frames.iter().any(|f| f.trap) {
            return Ok(());
        }
        let now = self.calendar.steady_s();
        let due = |i: &&mut Interrupt| !i.asleep && i.timer.is_some_and(|(_, at)| at <= now);
        let Some(interrupt) = self.interrupts.iter_mut().find(due) else { return Ok(()) };
        let (number, trap) = (interrupt.number, interrupt.trap);
        interrupt.timer = match interrupt.timer {
            // What fell due while something else went on is served once.
            Some((period, at)) if !interrupt.single => {
                let missed = ((now - at) / period).floor().max(0.0);
                Some((period, at + (missed + 1.0) * period))
            }
            _ => None,
        };
        self.intno = number;
        self.enter(trap, Vec::new(), true)
    }
}

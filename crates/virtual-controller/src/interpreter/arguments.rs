//! The arguments of a call as they are written, sorted by position and name.

use super::Interpreter;
use crate::code::{Arg, Call, Expr, ExprKind, Name};
use crate::machine::Binding;
use crate::outcome::{Fault, fatal};

/// The arguments of a call, those by position apart from those by name.
pub(crate) struct Args<'c> {
    /// What is called, in lower case.
    pub callee: &'c str,
    pub positional: Vec<&'c Expr>,
    named: Vec<(&'c Name, Option<&'c Expr>)>,
}

impl<'c> Args<'c> {
    /// The argument at a position.
    pub(crate) fn at(&self, index: usize) -> Result<&'c Expr, Fault> {
        match self.positional.get(index) {
            Some(e) => Ok(e),
            None => fatal(format!("argument {} is missing", index + 1)),
        }
    }

    /// Whether a switch or named argument is given.
    pub(crate) fn has(&self, name: &str) -> bool {
        self.named.iter().any(|(n, _)| ***n == *name)
    }

    /// The names of switches and named arguments that are given.
    pub(crate) fn names(&self) -> impl Iterator<Item = &'c Name> + '_ {
        self.named.iter().map(|(name, _)| *name)
    }

    /// The value given by name.
    pub(crate) fn named(&self, name: &str) -> Option<&'c Expr> {
        self.named.iter().find(|(n, _)| ***n == *name).and_then(|(_, e)| *e)
    }
}

impl Interpreter<'_> {
    /// Sorts the arguments of a call; `\x?y` counts where `y` is present.
    pub(crate) fn args<'c>(&self, callee: &'c str, call: &'c Call) -> Args<'c> {
        let mut args = Args { callee, positional: Vec::new(), named: Vec::new() };
        for arg in &call.args {
            match arg {
                Arg::Positional(e) => args.positional.push(e),
                Arg::Switch(name) => args.named.push((name, None)),
                Arg::Named(name, e) => args.named.push((name, Some(e))),
                Arg::Conditional(name, e) => {
                    if self.is_given(e) {
                        args.named.push((name, Some(e)));
                    }
                }
            }
        }
        args
    }

    /// Whether an optional parameter was given.
    pub(crate) fn is_given(&self, expr: &Expr) -> bool {
        match expr.kind {
            ExprKind::Local(slot) => !matches!(self.machine.stack.local(slot), Some(Binding::Absent) | None),
            _ => true,
        }
    }
}

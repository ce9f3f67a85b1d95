//! Targets that are read from where the robot stands, or that a search has found: they hold the drift already.

use super::expressions::{every_call, expressions_of};
use super::index::{Ctx, DatumId, Index, Resolved, every_statement};
use super::names::lower_case;
use super::tracked::{names_in, sources};
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree::{ArgKind, Callee, Expr, StmtKind};
use std::collections::BTreeSet;

/// Functions of the controller that read where the robot stands.
const READINGS: [&str; 3] = ["crobt", "cjointt", "cpos"];

/// Data and functions of a program whose values come from where the robot stands.
#[derive(Debug, Default)]
pub(super) struct OwnPositions {
    data: BTreeSet<DatumId>,
    routines: BTreeSet<usize>,
    /// Functions of the controller that give such values.
    readings: &'static [&'static str],
}

impl OwnPositions {
    /// Those of a program: by assignment, by declaration, as an argument, through functions.
    pub(super) fn new(index: &Index<'_>) -> Self {
        let found = Self { readings: &READINGS, ..Self::default() };
        let reads = index.routines.iter().any(|routine| found.reads(index, routine.ctx, &routine.tree.body));
        if reads { found.closed(index) } else { found }
    }

    /// The same of points that searches have found.
    pub(super) fn of_searches(index: &Index<'_>) -> Self {
        let mut found = Self::default();
        for routine in &index.routines {
            every_statement(&routine.tree.body, &mut |stmt| {
                let StmtKind::Call(call) = &stmt.kind else { return };
                let Callee::Name(name) = call.callee else { return };
                let is_search = lower_case(index.text(routine.ctx.file, name)).starts_with("search");
                let mut positional = call.args.iter().filter_map(|arg| match &arg.kind {
                    ArgKind::Positional(expr) => Some(expr),
                    _ => None,
                });
                if let Some(point) = positional.nth(1).filter(|_| is_search) {
                    names_in(index, routine.ctx, point, &mut |datum| {
                        found.data.insert(datum);
                    });
                }
            });
        }
        if found.data.is_empty() { found } else { found.closed(index) }
    }

    /// With all that their values go into.
    fn closed(self, index: &Index<'_>) -> Self {
        let mut found = self;
        let sources = sources(index);
        loop {
            let before = (found.data.len(), found.routines.len());
            for (id, routine) in index.routines.iter().enumerate() {
                let ctx = routine.ctx;
                let (mut data, mut returns) = (Vec::new(), false);
                every_statement(&routine.tree.body, &mut |stmt| match &stmt.kind {
                    StmtKind::Assign(assign) if found.is_read(index, ctx, &assign.value) => {
                        // Only what is assigned itself: `p.robconf` of a reading is no reading.
                        names_in(index, ctx, &assign.target, &mut |datum| data.push(datum));
                    }
                    StmtKind::Return(Some(value)) if found.is_read(index, ctx, value) => returns = true,
                    _ => {}
                });
                found.data.extend(data);
                if returns {
                    found.routines.insert(id);
                }
            }
            let more: Vec<DatumId> =
                sources.iter().filter(|(_, from)| found.data.contains(from)).map(|(to, _)| *to).collect();
            found.data.extend(more);
            if before == (found.data.len(), found.routines.len()) {
                return found;
            }
        }
    }

    /// Whether an expression holds a reading.
    pub(super) fn is_read(&self, index: &Index<'_>, ctx: Ctx, expr: &Expr) -> bool {
        let mut read = false;
        every_call(expr, &mut |name, _| read |= self.is_reading(index, ctx, name));
        names_in(index, ctx, expr, &mut |datum| read |= self.data.contains(&datum));
        read
    }

    fn is_reading(&self, index: &Index<'_>, ctx: Ctx, name: TextRange) -> bool {
        let own = index.name_at(ctx.file, name).map(|name| index.routine(name, ctx));
        match own {
            Some(Resolved::Here(routine) | Resolved::Elsewhere(routine)) => self.routines.contains(&routine),
            _ => self.readings.contains(&&*lower_case(index.text(ctx.file, name))),
        }
    }

    fn reads(&self, index: &Index<'_>, ctx: Ctx, body: &[rapid_syntax::tree::Stmt]) -> bool {
        let mut read = false;
        every_statement(body, &mut |stmt| {
            for expr in expressions_of(stmt) {
                every_call(expr, &mut |name, _| read |= self.is_reading(index, ctx, name));
            }
        });
        read
    }
}

//! Data that are worth what the file says of a PERS, or of a VAR that what is not given sets, or are made of them: a controller may hold
//! another value than the file.
//!
//! Knows nothing of ways through the program. What is tracked [`state`](super::state) follows; of all other data any way counts.

use super::ids::{DatumId, IdSet};
use super::index::{Ctx, DatumKind, Index};
use super::loop_bounds::loop_bounds;
use super::names::ByNumber;
use super::parameter_flow::ParameterFlow;
use super::tracked::{names_in, names_in_where, sources};
use super::value_flow::ValueFlow;
use super::writes::Writes;
use rapid_syntax::tree::{DataKind, Expr};

/// For each datum the PERS of whose value in the file it is made.
#[derive(Debug, Default)]
pub(super) struct FileValues(ByNumber<DatumId, DatumId>);

impl FileValues {
    /// By all PERS that the program leaves as they are.
    pub(super) fn new(index: &Index<'_>, writes: &Writes) -> Self {
        let is_from_file = |&id: &DatumId| differs_on_controllers(index, id) && writes.first(id).is_none();
        let from_file: Vec<DatumId> = index.data.ids().filter(is_from_file).collect();
        if from_file.is_empty() {
            return Self::default();
        }
        let mut goes_into: ByNumber<DatumId, Vec<DatumId>> = ByNumber::default();
        let late = ParameterFlow::new(index);
        let declared = of_declarations(index);
        for flow in sources(index).as_slice().iter().chain(&late.into).chain(&late.out_of).chain(&declared) {
            goes_into.entry(flow.from).or_default().push(flow.to);
        }
        let mut of = ByNumber::default();
        for pers in from_file {
            let mut new = vec![pers];
            while let Some(datum) = new.pop() {
                if of.insert(datum, pers).is_none() {
                    new.extend(goes_into.get(&datum).into_iter().flatten().filter(|to| !of.contains_key(to)));
                }
            }
        }
        Self(of)
    }

    /// The PERS of whose value in the file a datum is made that is not tracked.
    pub(super) fn of_untracked(&self, datum: DatumId) -> Option<DatumId> {
        self.0.get(&datum).copied()
    }
}

/// Whether a controller may hold another value of a datum than the file: a pendant, an operator panel or another task sets a PERS, and what is
/// not given some VAR.
pub(super) fn is_set_elsewhere(index: &Index<'_>, datum: DatumId) -> bool {
    index.data[datum].kind == DatumKind::Declared(DataKind::Pers) || index.open_variables.contains(datum)
}

/// The same of data whose value tells where a motion goes. Tools, work objects and loads are PERS as a rule, and taken as the
/// files have them.
pub(super) fn differs_on_controllers(index: &Index<'_>, datum: DatumId) -> bool {
    is_set_elsewhere(index, datum)
        && !matches!(index.type_text(index.data[datum].type_name), "tooldata" | "wobjdata" | "loaddata")
}

/// Whether a PERS goes into an expression, or another datum that is set elsewhere.
pub(super) fn can_be_set(index: &Index<'_>, ctx: Ctx, expr: &Expr) -> bool {
    first_pers(index, ctx, expr).is_some()
}

/// The first PERS that goes into an expression, by declarations, too.
pub(super) fn first_pers(index: &Index<'_>, ctx: Ctx, expr: &Expr) -> Option<DatumId> {
    let mut found = None;
    every_pers(index, ctx, expr, &|_, _| true, &mut |pers| found = found.or(Some(pers)));
    found
}

/// Calls `visit` with each PERS that goes into those parts of an expression that `counts` says count, by declarations, too.
pub(super) fn every_pers(
    index: &Index<'_>,
    ctx: Ctx,
    expr: &Expr,
    counts: &dyn Fn(Ctx, &Expr) -> bool,
    visit: &mut dyn FnMut(DatumId),
) {
    let (mut seen, mut new) = (IdSet::default(), Vec::new());
    names_in_where(index, ctx, expr, counts, &mut |datum| new.push(datum));
    while let Some(datum) = new.pop() {
        let entry = &index.data[datum];
        if !seen.insert(datum) {
            continue;
        }
        if is_set_elsewhere(index, datum) {
            visit(datum);
        } else if let Some(init) = entry.init {
            names_in(index, entry.ctx, init, &mut |datum| new.push(datum));
        }
    }
}

/// What goes into data by their declarations, and into the variables of FOR loops by the bounds of these.
fn of_declarations(index: &Index<'_>) -> Vec<ValueFlow> {
    let mut flows = Vec::new();
    for (to, datum) in index.data.numbered() {
        if let Some(init) = datum.init {
            names_in(index, datum.ctx, init, &mut |from| flows.push(ValueFlow { to, from }));
        }
    }
    for (ctx, to, bound) in loop_bounds(index) {
        names_in(index, ctx, bound, &mut |from| flows.push(ValueFlow { to, from }));
    }
    flows
}

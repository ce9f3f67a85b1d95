//! Targets that are read from where the robot stands, or that a search has found: they hold the drift already.
//!
//! Whatever such a value can go into at some time counts. Where it matters which value it is at one place, the walk along the ways
//! narrows that down (`state`).

use super::call_arguments::{MatchedArgument, match_arguments};
use super::expressions::{every_call, every_call_where, expressions_of, root_of, value_of};
use super::ids::{DatumId, IdSet, RoutineIndex};
use super::index::{Ctx, DatumKind, Index, Resolved, RoutineEntry};
use super::late_bound::reached;
use super::loop_bounds::loop_bounds;
use super::names::{ByNumber, lower_case};
use super::parameter_flow::ParameterFlow;
use super::repeated_moves::every_naming_statement;
use super::statements::bodies;
use super::tracked::{names_in, names_in_where, sources_where};
use super::value::string;
use super::value_flow::ValueFlow;
use super::value_type::{can_be_set_to, type_of_value};
use super::written_by::{written_by_function, written_by_instruction};
use rapid_syntax::diagnostic::{Span, TextRange};
use rapid_syntax::tree::{Arg, ArgKind, Callee, Expr, ExprKind, ParamMode, Stmt, StmtKind};

/// Functions of the controller that read where the robot stands.
const READINGS: [&str; 4] = ["crobt", "cjointt", "cpos", "readmotor"];

/// Types of data that say where something stands.
const PLACES: [&str; 7] = ["robtarget", "jointtarget", "robjoint", "pos", "pose", "tooldata", "wobjdata"];

/// Whether what an instruction or function of the controller's own writes is made of its other arguments; others ask the operator, a signal or
/// a file, whatever they are told beside.
fn hands_on(name: &str) -> bool {
    matches!(
        name,
        "add"
            | "copyrawbytes"
            | "fitcircle"
            | "matrixsolve"
            | "matrixsolveqr"
            | "matrixsvd"
            | "packrawbytes"
            | "strtoval"
            | "unpackrawbytes"
    )
}

/// Data and functions of a program whose values come from where the robot stands.
#[derive(Debug, Default)]
pub(super) struct OwnPositions {
    /// Each datum with a reading whose value comes to it.
    data: ByNumber<DatumId, Span>,
    /// Each function with a reading whose value it gives.
    routines: ByNumber<RoutineIndex, Span>,
    /// Those of the functions that make such a value of their own arguments alone: what they are given tells whether they do.
    of_arguments: IdSet<RoutineIndex>,
    /// Whether the program asks for such a value anywhere.
    pub(super) are_asked_for: bool,
    /// Functions of the controller that give such values.
    readings: &'static [&'static str],
}

impl OwnPositions {
    /// Those of a program: by assignment, by declaration, as an argument, through functions.
    pub(super) fn new(index: &Index<'_>) -> Self {
        let mut found = Self { readings: &READINGS, ..Self::default() };
        found.read_by_instruction(index);
        let reads =
            !found.data.is_empty() || index.routines.iter().any(|routine| found.reads(index, routine));
        if reads { Self { are_asked_for: true, ..found }.closed(index) } else { found }
    }

    /// `GetJointData 1\Position:=angle;`: an axis' angle where the arm stands.
    fn read_by_instruction(&mut self, index: &Index<'_>) {
        for routine in &index.routines {
            let ctx = routine.ctx;
            let is = |name: TextRange, wanted: &str| lower_case(index.text(ctx.file, name)) == wanted;
            in_all(index, routine, &mut |stmt| {
                let StmtKind::Call(call) = &stmt.kind else { return };
                let Callee::Name(name) = call.callee else { return };
                if !is(name, "getjointdata") || index.declares_routine(name, ctx) {
                    return;
                }
                if is_of_other_unit(index, ctx, &call.args) {
                    return;
                }
                for arg in &call.args {
                    if let ArgKind::Named { name, value: Some(value) } = &arg.kind
                        && is(*name, "position")
                    {
                        let at = Span { file: ctx.file, range: stmt.range };
                        names_in(index, ctx, value, &mut |datum| self.add([(datum, at)]));
                    }
                }
            });
        }
    }

    /// The same of points that searches have found.
    pub(super) fn of_searches(index: &Index<'_>) -> Self {
        let mut found = Self::default();
        for routine in &index.routines {
            in_all(index, routine, &mut |stmt| {
                let StmtKind::Call(call) = &stmt.kind else { return };
                let Callee::Name(name) = call.callee else { return };
                let ctx = routine.ctx;
                let written = lower_case(index.text(ctx.file, name));
                if !is_search(&written) || index.declares_routine(name, ctx) {
                    return;
                }
                for point in written_by_instruction(index, ctx, &written, &call.args) {
                    names_in(index, ctx, point, &mut |datum| {
                        found.data.entry(datum).or_insert(Span { file: ctx.file, range: stmt.range });
                    });
                }
            });
        }
        if found.data.is_empty() { found } else { found.closed(index) }
    }

    /// With all that their values go into.
    fn closed(self, index: &Index<'_>) -> Self {
        let mut found = self;
        let late = ParameterFlow::new(index);
        let sources = sources_where(index, &|ctx, expr| tells_the_pose(index, ctx, expr)).with(late.into);
        let handed_back = handed_back(index);
        let worked_out = [worked_out_arguments(index), loop_bounds(index)].concat();
        // What statements set to such a value: a parameter that only is handed one gives no other argument of its calls any.
        let mut set: IdSet<DatumId> = found.data.keys().copied().collect();
        loop {
            let before = (found.data.len(), found.routines.len(), set.len());
            for (id, routine) in index.routines.numbered() {
                let ctx = routine.ctx;
                let (mut data, mut returns) = (Vec::new(), None);
                in_all(index, routine, &mut |stmt| {
                    found.written_by_built_ins(index, ctx, stmt, &mut data);
                    match &stmt.kind {
                        StmtKind::Assign(assign) => {
                            if let Some(at) = found.read_at(index, ctx, &assign.value) {
                                // Only what is assigned itself: `p.robconf` of a reading is no reading.
                                names_in(index, ctx, &assign.target, &mut |datum| data.push((datum, at)));
                            }
                        }
                        StmtKind::Return(Some(value)) => {
                            returns = returns.or(found.read_at(index, ctx, value));
                        }
                        _ => {}
                    }
                });
                set.extend(data.iter().map(|(datum, _)| *datum));
                found.add(data);
                if let Some(at) = returns {
                    found.routines.entry(id).or_insert(at);
                }
            }
            let back: Vec<ValueFlow> =
                handed_back.iter().filter(|flow| set.contains(flow.from)).copied().collect();
            set.extend(back.iter().map(|flow| flow.to));
            found.add_from(&back);
            let handed = worked_out
                .iter()
                .filter_map(|&(ctx, param, value)| Some((param, found.read_at(index, ctx, value)?)));
            let handed: Vec<(DatumId, Span)> = handed.collect();
            found.add(handed);
            found.add_from(sources.as_slice());
            if before == (found.data.len(), found.routines.len(), set.len()) {
                let of_arguments = found.routines.keys().filter(|&&id| found.is_of_arguments(index, id));
                found.of_arguments = of_arguments.copied().collect();
                return found;
            }
        }
    }

    /// What instructions and functions of the controller write, in a statement, of a reading that they are handed: `StrToVal(text, p)`.
    fn written_by_built_ins(
        &self,
        index: &Index<'_>,
        ctx: Ctx,
        stmt: &Stmt,
        data: &mut Vec<(DatumId, Span)>,
    ) {
        if let StmtKind::Call(call) = &stmt.kind
            && let Callee::Name(name) = call.callee
            && !index.declares_routine(name, ctx)
        {
            self.exchanged_by_name(index, (ctx, name), &call.args, data);
        }
        let mut enter = |name: TextRange, args: &[Arg], written: &[&Expr]| {
            if !hands_on(&lower_case(index.text(ctx.file, name))) || index.declares_routine(name, ctx) {
                return;
            }
            let reading = args.iter().filter_map(value_of).find_map(|arg| self.read_at(index, ctx, arg));
            let Some(at) = reading else { return };
            for target in written {
                names_in(index, ctx, target, &mut |datum| data.push((datum, at)));
            }
        };
        if let StmtKind::Call(call) = &stmt.kind
            && let Callee::Name(name) = call.callee
        {
            let written = lower_case(index.text(ctx.file, name));
            enter(name, &call.args, &written_by_instruction(index, ctx, &written, &call.args));
        }
        for expr in expressions_of(stmt) {
            every_call(expr, &mut |name, args| {
                let written = lower_case(index.text(ctx.file, name));
                enter(name, args, &written_by_function(index, ctx, &written, args));
            });
        }
    }

    /// What SetDataVal, SetAllDataVal and GetDataVal hand on by a datum's name: of that name, and where it is worked out or only a type is
    /// named, of any.
    fn exchanged_by_name(
        &self,
        index: &Index<'_>,
        (ctx, instruction): (Ctx, TextRange),
        args: &[Arg],
        data: &mut Vec<(DatumId, Span)>,
    ) {
        let mut values =
            args.iter().filter(|arg| matches!(arg.kind, ArgKind::Positional(_))).filter_map(value_of);
        let (Some(name), Some(value)) = (values.next(), values.next()) else { return };
        let instruction = lower_case(index.text(ctx.file, instruction));
        let by_type = instruction == "setalldataval";
        let written =
            (name.kind == ExprKind::String && !by_type).then(|| string(index.text(ctx.file, name.range)));
        let is_meant = |datum: DatumId| {
            let meant = written
                .as_ref()
                .is_none_or(|written| index.names.find(written) == Some(index.data[datum].name));
            meant && index.data[datum].ctx.routine.is_none()
        };
        let set_to = type_of_value(index, ctx, value);
        match &*instruction {
            "setdataval" | "setalldataval" => {
                let Some(at) = self.read_at(index, ctx, value) else { return };
                // Whatever stands somewhere may be set by a name that is worked out.
                let is_place = |datum: DatumId| {
                    written.is_some()
                        || can_be_set_to(index, datum, set_to)
                            && PLACES.contains(&index.type_text(index.data[datum].type_name))
                };
                let set = index.data.ids().filter(|&datum| is_meant(datum) && is_place(datum));
                data.extend(set.map(|datum| (datum, at)));
            }
            "getdataval" => {
                let held = self.data.iter().filter(|(datum, _)| is_meant(**datum)).map(|(_, at)| *at).min();
                let Some(at) = held else { return };
                names_in(index, ctx, value, &mut |datum| data.push((datum, at)));
            }
            _ => {}
        }
    }

    fn add(&mut self, data: impl IntoIterator<Item = (DatumId, Span)>) {
        for (datum, at) in data {
            self.data.entry(datum).or_insert(at);
        }
    }

    /// Adds data to which the value of another comes.
    fn add_from(&mut self, flows: &[ValueFlow]) {
        for flow in flows {
            self.add(self.data.get(&flow.from).map(|at| (flow.to, *at)));
        }
    }

    /// Whether a function works with its own data alone and asks no other routine.
    fn is_of_arguments(&self, index: &Index<'_>, id: RoutineIndex) -> bool {
        let routine = &index.routines[id];
        let ctx = routine.ctx;
        // What is handed on if it is present (`\P?q`) no argument shows.
        let optional = |&&p: &&DatumId| matches!(index.data[p].kind, DatumKind::Param { optional: true, .. });
        let mut calls = routine.params.iter().any(|p| optional(&p));
        let mut foreign = false;
        in_all(index, routine, &mut |stmt| {
            if let StmtKind::Call(call) = &stmt.kind {
                // Of the controller's own few give such a value: a search, an axis' angle, a datum by its name.
                calls |= match call.callee {
                    Callee::Name(name) => {
                        let written = lower_case(index.text(ctx.file, name));
                        index.declares_routine(name, ctx)
                            || is_search(&written)
                            || matches!(&*written, "getjointdata" | "getdataval")
                    }
                    Callee::Late(_) => true,
                };
            }
            for expr in expressions_of(stmt) {
                every_call(expr, &mut |name, args| {
                    calls |=
                        index.declares_routine(name, ctx) || self.reading(index, ctx, (name, args)).is_some();
                });
                names_in(index, ctx, expr, &mut |datum| {
                    foreign |= self.holds(datum) && index.data[datum].ctx.routine != Some(id);
                });
            }
        });
        !calls && !foreign
    }

    /// Whether an expression holds a reading.
    pub(super) fn is_read(&self, index: &Index<'_>, ctx: Ctx, expr: &Expr) -> bool {
        self.read_at(index, ctx, expr).is_some()
    }

    /// The reading that an expression holds.
    pub(super) fn read_at(&self, index: &Index<'_>, ctx: Ctx, expr: &Expr) -> Option<Span> {
        self.read_where(index, ctx, expr, &|_| true)
    }

    /// The same at a place where of the data that can hold a reading those alone do of which `holds` says so.
    pub(super) fn read_where(
        &self,
        index: &Index<'_>,
        ctx: Ctx,
        expr: &Expr,
        holds: &dyn Fn(DatumId) -> bool,
    ) -> Option<Span> {
        let mut read = None;
        let counts = |ctx, part: &Expr| tells_the_pose(index, ctx, part);
        every_call_where(expr, &|part| counts(ctx, part), &mut |name, args| {
            read = read.or(self.reading(index, ctx, (name, args)));
        });
        names_in_where(index, ctx, expr, &counts, &mut |datum| {
            read = read.or(self.data.get(&datum).filter(|_| holds(datum)).copied());
        });
        read
    }

    /// Whether a datum can hold a reading at some time.
    pub(super) fn holds(&self, datum: DatumId) -> bool {
        self.data.contains_key(&datum)
    }

    /// Whether there is any.
    pub(super) fn is_empty(&self) -> bool {
        self.data.is_empty() && self.routines.is_empty()
    }

    /// The reading that a call of a function gives.
    fn reading(&self, index: &Index<'_>, ctx: Ctx, (name, args): (TextRange, &[Arg])) -> Option<Span> {
        let own = index.name_at(ctx.file, name).map(|name| index.routine(name, ctx));
        match own {
            Some(Resolved::Here(routine) | Resolved::Elsewhere(routine)) => {
                self.routines.get(&routine).filter(|_| !self.of_arguments.contains(routine)).copied()
            }
            _ => {
                let read = self.readings.contains(&&*lower_case(index.text(ctx.file, name)));
                let is_own = read && !is_of_other_unit(index, ctx, args);
                is_own.then_some(Span { file: ctx.file, range: name })
            }
        }
    }

    fn reads(&self, index: &Index<'_>, routine: &RoutineEntry<'_>) -> bool {
        let mut read = false;
        in_all(index, routine, &mut |stmt| {
            for expr in expressions_of(stmt) {
                every_call(expr, &mut |name, args| {
                    read |= self.reading(index, routine.ctx, (name, args)).is_some();
                });
            }
        });
        read
    }
}

/// Beginnings of the names that ABB gives positioners, tracks, motors and conveyors.
const BESIDE_THE_ROBOT: [&str; 7] = ["stn", "irbp", "irbt", "track", "interch", "m7dm", "cnv"];

/// Whether what is read is an axis of a mechanical unit beside the robot, by a name that the controller's configuration gives it:
/// `ReadMotor(\MecUnit:=STN_1,1)`. Any other name may be a robot's.
fn is_of_other_unit(index: &Index<'_>, ctx: Ctx, args: &[Arg]) -> bool {
    args.iter().any(|arg| match &arg.kind {
        ArgKind::Named { name, value: Some(unit) } => {
            let option = lower_case(index.text(ctx.file, *name));
            let unit_name = lower_case(index.text(ctx.file, unit.range));
            let is_beside = BESIDE_THE_ROBOT.iter().any(|beside| unit_name.starts_with(beside));
            matches!(&*option, "mecunit" | "mechunit")
                && unit.kind == ExprKind::Name
                && matches!(index.datum(unit.range, ctx), Resolved::Nowhere)
                && is_beside
        }
        _ => false,
    })
}

/// Whether a part of an expression tells of the arm's pose: external axes and configurations that are taken of a reading hold no drift.
fn tells_the_pose(index: &Index<'_>, ctx: Ctx, expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Field(field) => {
            !matches!(&*lower_case(index.text(ctx.file, field.name)), "extax" | "robconf")
        }
        _ => true,
    }
}

/// Whether an instruction of the controller's searches, by its name in lower case.
fn is_search(name: &str) -> bool {
    name.starts_with("search")
}

/// Calls `visit` with every statement of a routine that may name something new, its handlers' included.
fn in_all<'a>(index: &Index<'_>, routine: &RoutineEntry<'a>, visit: &mut dyn FnMut(&'a Stmt)) {
    bodies(routine.tree).for_each(|body| every_naming_statement(index, routine.ctx, body, visit));
}

/// What a routine's parameter by reference has become goes into what was handed over.
fn handed_back(index: &Index<'_>) -> Vec<ValueFlow> {
    let mut out = Vec::new();
    every_argument(index, &mut |ctx, MatchedArgument { param, value, handed_on }| {
        let by_value = matches!(index.data[param].kind, DatumKind::Param { mode: ParamMode::In, .. });
        let root = value.and_then(root_of).map(|(root, _)| root).or(handed_on);
        if let Some(root) = root.filter(|_| !by_value)
            && let Resolved::Here(datum) | Resolved::Elsewhere(datum) = index.datum(root, ctx)
        {
            out.push(ValueFlow { to: datum, from: param });
        }
    });
    out
}

/// The arguments that functions have a part in, `Offs(CRobT(), 0, 0, z)`, with the parameters that take them: what a function gives comes
/// from no datum.
fn worked_out_arguments<'a>(index: &Index<'a>) -> Vec<(Ctx, DatumId, &'a Expr)> {
    let mut out = Vec::new();
    every_argument(index, &mut |ctx, MatchedArgument { param, value, .. }| {
        let Some(value) = value else { return };
        let mut is_worked_out = false;
        every_call(value, &mut |_, _| is_worked_out = true);
        if is_worked_out {
            out.push((ctx, param, value));
        }
    });
    out
}

/// Calls `visit` with every argument that a routine of the program is handed, by its name or by one that is worked out.
fn every_argument<'a>(index: &Index<'a>, visit: &mut dyn FnMut(Ctx, MatchedArgument<'a>)) {
    for routine in &index.routines {
        let ctx = routine.ctx;
        let mut enter = |callees: Vec<RoutineIndex>, args: &'a [Arg]| {
            let arguments = callees.into_iter().flat_map(|callee| match_arguments(index, ctx, callee, args));
            arguments.for_each(|argument| visit(ctx, argument));
        };
        let named = |callee: TextRange| match index.routine(index.name_at(ctx.file, callee)?, ctx) {
            Resolved::Here(callee) | Resolved::Elsewhere(callee) => Some(callee),
            Resolved::Twice(..) | Resolved::Nowhere => None,
        };
        in_all(index, routine, &mut |stmt| {
            if let StmtKind::Call(call) = &stmt.kind {
                match &call.callee {
                    Callee::Name(name) => enter(named(*name).into_iter().collect(), &call.args),
                    Callee::Late(name) => enter(reached(index, ctx, name, &call.args), &call.args),
                }
            }
            for expr in expressions_of(stmt) {
                every_call(expr, &mut |name, args| enter(named(name).into_iter().collect(), args));
            }
        });
    }
}

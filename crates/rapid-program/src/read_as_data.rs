//! Targets that the program reads as data as well: there the original value counts, while the arm stands at the corrected one.

use super::expressions::{every_call, expressions_of, value_of};
use super::ids::{DatumId, IdSet};
use super::index::{Ctx, Index};
use super::motion::SkipReason;
use super::move_instructions::move_form;
use super::names::{ByNumber, as_text, lower_case};
use super::parameter_flow::ParameterFlow;
use super::repeated_moves::every_naming_statement;
use super::statements::bodies;
use super::tracked::{names_in, sources};
use rapid_syntax::diagnostic::{Diagnostic, Span};
use rapid_syntax::tree::{Callee, Expr, RoutineKind, Stmt, StmtKind};
use std::rc::Rc;

/// What makes a tool, a frame or a zone out of targets: the arm must stand where those say.
const CALIBRATIONS: [&str; 17] = [
    "calcrotaxframez",
    "calcrotaxisframe",
    "defaccframe",
    "defdframe",
    "defframe",
    "fitcircle",
    "mtcpzcalib",
    "mtoolrotcalib",
    "mtooltcpcalib",
    "stoolrotcalib",
    "stooltcpcalib",
    "stooltcpzcalib",
    "wzboxdef",
    "wzcyldef",
    "wzhomejointdef",
    "wzlimjointdef",
    "wzsphdef",
];

/// A place where a datum is read.
#[derive(Clone, Debug)]
pub(super) struct Reading {
    at: Span,
    /// What reads it: an instruction, a function, or a word such as IF.
    by: Rc<str>,
    /// It makes a tool, a frame or a zone of it.
    calibrates: bool,
}

/// For each target that is read as data, where.
#[derive(Debug, Default)]
pub(super) struct ReadAsData(ByNumber<DatumId, Reading>);

impl ReadAsData {
    /// Where the targets of a program are read, by themselves or through what they are assigned to.
    pub(super) fn new(index: &Index<'_>) -> Self {
        let mut direct = ByNumber::default();
        for routine in &index.routines {
            for body in bodies(routine.tree) {
                let mut visit = |stmt| statement(index, routine.ctx, stmt, &mut direct);
                every_naming_statement(index, routine.ctx, body, &mut visit);
            }
        }
        if direct.is_empty() {
            return Self::default();
        }
        // What a target's value goes into counts as the target.
        let mut goes_into: ByNumber<DatumId, Vec<DatumId>> = ByNumber::default();
        let late = ParameterFlow::new(index);
        for flow in sources(index).as_slice().iter().chain(&late.into).chain(&late.out_of) {
            goes_into.entry(flow.from).or_default().push(flow.to);
        }
        let mut found = ByNumber::default();
        for (datum, entry) in index.data.numbered() {
            if !matches!(index.type_text(entry.type_name), "robtarget" | "jointtarget") {
                continue;
            }
            let mut seen = IdSet::from_iter([datum]);
            let mut new = vec![datum];
            let mut reading: Option<&Reading> = None;
            while let Some(at) = new.pop() {
                if let Some(more) = direct.get(&at).filter(|more| reading.is_none_or(|r| more.outweighs(r))) {
                    reading = Some(more);
                }
                new.extend(goes_into.get(&at).into_iter().flatten().filter(|&&to| seen.insert(to)));
            }
            if let Some(reading) = reading {
                found.insert(datum, reading.clone());
            }
        }
        Self(found)
    }

    /// The datum that a motion's target is made of and that is read elsewhere too; of several the one whose reading weighs most.
    pub(super) fn of_target(
        &self,
        index: &Index<'_>,
        ctx: Ctx,
        target: &Expr,
    ) -> Option<(DatumId, &Reading)> {
        if self.0.is_empty() {
            return None;
        }
        let mut found: Option<(DatumId, &Reading)> = None;
        names_in(index, ctx, target, &mut |datum| {
            if let Some(reading) = self.0.get(&datum)
                && found.is_none_or(|(_, known)| reading.outweighs(known))
            {
                found = Some((datum, reading));
            }
        });
        found
    }
}

impl ReadAsData {
    /// Why a motion to a target that comes from a datum is kept, where what reads the datum forbids to correct it.
    pub(super) fn skip_reason(&self, index: &Index<'_>, datum: DatumId) -> Option<SkipReason> {
        self.0.get(&datum)?.skip_reason(index)
    }
}

impl Reading {
    /// A calibration counts more than another reading, an earlier one more than a later.
    fn outweighs(&self, other: &Self) -> bool {
        (self.calibrates, other.at) > (other.calibrates, self.at)
    }

    /// Why a motion to the target stays as it is, where it must.
    pub(super) fn skip_reason(&self, index: &Index<'_>) -> Option<SkipReason> {
        let reason =
            format!("{} makes a tool, frame or zone of its target: {}", self.by, index.place(self.at));
        let because = Some(self.at);
        self.calibrates.then_some(SkipReason { code: "keep::calibration", reason, because })
    }

    /// What a reader should know of a target that is corrected.
    pub(super) fn warning(&self, index: &Index<'_>, datum: DatumId) -> Diagnostic {
        let entry = &index.data[datum];
        let name = as_text(index.text(entry.ctx.file, entry.name_range));
        let line = index.file(self.at.file).line(self.at.range);
        let text = format!(
            "{name} is corrected in motions and read as data by {} in line {line}: there its original value counts",
            self.by
        );
        let help =
            format!("the arm stands a correction apart from it; --keep {name} leaves the motions alone");
        Diagnostic::warning("target::read-as-data", text)
            .at(self.at)
            .label(index.declaration(datum), "declared here")
            .help(help)
    }
}

/// Enters what a statement reads, motions and assignments aside.
fn statement(index: &Index<'_>, ctx: Ctx, stmt: &Stmt, direct: &mut ByNumber<DatumId, Reading>) {
    let returns_target = ctx.routine.and_then(|id| index.routines.get(id)).is_some_and(|routine| {
        let RoutineKind::Func(of) = routine.tree.kind else { return false };
        let of = lower_case(index.text(ctx.file, of));
        matches!(&*of, "robtarget" | "jointtarget" | "pose" | "pos")
    });
    let at = Span { file: ctx.file, range: stmt.range };
    let by: Rc<str> = match &stmt.kind {
        StmtKind::Call(call) => {
            let Callee::Name(name) = call.callee else { return };
            let written = index.text(ctx.file, name);
            if index.declares_routine(name, ctx) || move_form(&lower_case(written)).is_some() {
                return calibrating_functions(index, ctx, stmt, at, direct);
            }
            as_text(written).into()
        }
        StmtKind::If(_) | StmtKind::CompactIf(_) => "IF".into(),
        StmtKind::While(_) => "WHILE".into(),
        StmtKind::Test(_) => "TEST".into(),
        StmtKind::For(_) => "FOR".into(),
        // A target that is handed back is one of a motion's.
        StmtKind::Return(_) if !returns_target => "RETURN".into(),
        _ => return calibrating_functions(index, ctx, stmt, at, direct),
    };
    let calibrates = is_calibration(&by);
    for expr in expressions_of(stmt) {
        names_in(index, ctx, expr, &mut |datum| {
            enter(direct, datum, &Reading { at, by: Rc::clone(&by), calibrates });
        });
    }
    calibrating_functions(index, ctx, stmt, at, direct);
}

/// `w.uframe := DefFrame(p1,p2,p3)`: a frame made of targets, whatever becomes of it.
fn calibrating_functions(
    index: &Index<'_>,
    ctx: Ctx,
    stmt: &Stmt,
    at: Span,
    direct: &mut ByNumber<DatumId, Reading>,
) {
    for expr in expressions_of(stmt) {
        every_call(expr, &mut |name, args| {
            let written = index.text(ctx.file, name);
            if !is_calibration(&as_text(written)) || index.declares_routine(name, ctx) {
                return;
            }
            let by: Rc<str> = as_text(written).into();
            for value in args.iter().filter_map(value_of) {
                names_in(index, ctx, value, &mut |datum| {
                    enter(direct, datum, &Reading { at, by: Rc::clone(&by), calibrates: true });
                });
            }
        });
    }
}

fn is_calibration(name: &str) -> bool {
    CALIBRATIONS.binary_search(&&*lower_case(name.as_bytes())).is_ok()
}

fn enter(direct: &mut ByNumber<DatumId, Reading>, datum: DatumId, reading: &Reading) {
    direct
        .entry(datum)
        .and_modify(|known| {
            if reading.outweighs(known) {
                *known = reading.clone();
            }
        })
        .or_insert_with(|| reading.clone());
}

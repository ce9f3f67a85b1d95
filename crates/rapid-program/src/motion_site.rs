//! Where motions, loops and routines stand in the text, before anything is known of their values.

use super::const_eval::{ConstEvaluator, Constant};
use super::expressions::words;
use super::ids::RoutineIndex;
use super::index::{Ctx, Index};
use super::is_of_task;
use super::motion::{self, Loop, MotionId, RoutineInfo};
use super::move_instructions::{MoveForm, NOT_GIVEN, Special, move_form};
use super::names::{as_text, lower_case};
use super::repeated_moves::name_the_same;
use super::statements::{bodies, every_statement, inner_bodies};
use super::unknown_moves::seems_to_move;
use super::value::Value;
use rapid_syntax::diagnostic::FileId;
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree::{Arg, ArgKind, CallStmt, Callee, Expr, Routine, Stmt, StmtKind};
use std::borrow::Cow;

/// A motion as it stands in the text.
#[derive(Debug)]
pub(super) struct MotionSite<'a> {
    pub(super) stmt: &'a Stmt,
    pub(super) form: &'static MoveForm,
    /// The routine it stands in, among all.
    routine: RoutineIndex,
    /// The same among those that hold motion.
    pub(super) info: motion::RoutineId,
    /// The loops round it: position in [`MotionSites::nests`].
    pub(super) nest: u32,
    /// Text that was not understood: the statement itself, or one right before or behind it.
    pub(super) not_read: Option<TextRange>,
}

impl<'a> MotionSite<'a> {
    /// From where its names are looked up.
    pub(super) fn ctx(&self, index: &Index<'_>) -> Ctx {
        index.routines[self.routine].ctx
    }

    /// What moves, in its usual spelling, or as the call has it where that is not known.
    pub(super) fn kind(&self, index: &Index<'_>) -> Cow<'static, str> {
        match &self.stmt.kind {
            StmtKind::Call(CallStmt { callee: Callee::Name(name), .. })
                if self.form.special == Special::NotGiven =>
            {
                as_text(index.text(self.ctx(index).file, *name)).into()
            }
            _ => self.form.name.into(),
        }
    }

    /// Its arguments by what they are.
    pub(super) fn args(&self, index: &Index<'_>) -> MoveArgs<'a> {
        match &self.stmt.kind {
            StmtKind::Call(call) => move_args(index, self.ctx(index), self.form, &call.args),
            _ => MoveArgs::default(),
        }
    }
}

/// The arguments of a motion.
#[derive(Debug, Default)]
pub(super) struct MoveArgs<'a> {
    pub(super) targets: Vec<&'a Expr>,
    pub(super) speed: Option<&'a Expr>,
    pub(super) zone: Option<&'a Expr>,
    pub(super) tool: Option<&'a Expr>,
    pub(super) wobj: Option<&'a Expr>,
    /// Options, by name in lower case, with their values.
    pub(super) options: Vec<(String, Option<&'a Expr>)>,
    /// `\Name?parameter`: name in lower case, and the parameter.
    pub(super) conditional: Vec<(String, TextRange)>,
}

impl MoveArgs<'_> {
    /// The parameter that is handed on as an option, if present.
    pub(super) fn conditional(&self, option: &str) -> Option<TextRange> {
        self.conditional.iter().find(|(name, _)| name == option).map(|(_, parameter)| *parameter)
    }

    /// Whether an option is there.
    pub(super) fn has(&self, option: &str) -> bool {
        self.options.iter().any(|(name, _)| name == option) || self.conditional(option).is_some()
    }
}

/// All motions, loops and routines of a program, in file order.
#[derive(Debug, Default)]
pub(super) struct MotionSites<'a> {
    pub(super) motions: Vec<MotionSite<'a>>,
    pub(super) loops: Vec<Loop>,
    /// Loops round motions, outermost first, each combination once in a row.
    pub(super) nests: Vec<Vec<usize>>,
    pub(super) routines: Vec<RoutineInfo>,
}

impl<'a> MotionSites<'a> {
    /// The motion that a statement is.
    pub(super) fn motion_at(&self, file: FileId, stmt: &Stmt) -> Option<MotionId> {
        let of = |site: &MotionSite<'_>| {
            (self.routines.get(site.info.index()).map(|info| info.file), site.stmt.range.start)
        };
        let wanted = (Some(file), stmt.range.start);
        self.motions.binary_search_by(|site| of(site).cmp(&wanted)).ok().map(MotionId::new)
    }

    /// The first of each row of neighbouring motions that name the same.
    pub(super) fn naming<'s>(&'s self, index: &'s Index<'_>) -> impl Iterator<Item = &'s MotionSite<'a>> {
        let mut last: Option<&MotionSite<'_>> = None;
        self.motions.iter().filter(move |site| {
            let ctx = site.ctx(index);
            // In another loop a name may be another variable.
            let same = |last: &&MotionSite<'_>| {
                last.nest == site.nest
                    && last.ctx(index) == ctx
                    && name_the_same(index, ctx, last.stmt, site.stmt)
            };
            let is_new = last.filter(same).is_none();
            if is_new {
                last = Some(site);
            }
            is_new
        })
    }

    /// What stands in all files, or in those of one task.
    pub(super) fn new(evaluator: &mut ConstEvaluator<'a>, task: Option<&str>) -> Self {
        let index = evaluator.index;
        let mut sites = Self::default();
        for (id, routine) in index.routines.numbered() {
            if !is_of_task(&index.file(routine.ctx.file).path, task) {
                continue;
            }
            let gotos = gotos(routine.tree);
            let (sites, open) = (&mut sites, Vec::new());
            let mut walk = SiteCollector { sites, evaluator: &mut *evaluator, id, gotos, open, info: None };
            walk.body(&routine.tree.body);
            for handler in &routine.tree.handlers {
                walk.open.clear();
                walk.body(&handler.body);
            }
        }
        sites
    }
}

/// A loop round what is being read; it is counted as soon as it turns out to hold a motion.
struct Open {
    end: u32,
    made: Loop,
    counted: Option<usize>,
}

struct SiteCollector<'d, 'a> {
    sites: &'d mut MotionSites<'a>,
    evaluator: &'d mut ConstEvaluator<'a>,
    id: RoutineIndex,
    gotos: Vec<(TextRange, u32)>,
    open: Vec<Open>,
    info: Option<motion::RoutineId>,
}

impl<'a> SiteCollector<'_, 'a> {
    fn ctx(&self) -> Ctx {
        self.evaluator.index.routines[self.id].ctx
    }

    fn body(&mut self, body: &'a [Stmt]) {
        for (position, stmt) in body.iter().enumerate() {
            self.open.retain(|open| open.end > stmt.range.start);
            match &stmt.kind {
                StmtKind::Call(call) => {
                    if let Callee::Name(name) = &call.callee {
                        self.call(stmt, *name, not_read_beside(body, position));
                    }
                }
                StmtKind::Opaque => self.not_read(stmt),
                StmtKind::While(looped) => {
                    let ctx = self.ctx();
                    let cond = self.evaluator.fold(&looped.cond, ctx, &Constant).map(|t| t.value);
                    let unconditional = matches!(cond, Ok(Value::Bool(true)));
                    self.inside(stmt.range.end, unconditional, None);
                    self.body(&looped.body);
                }
                StmtKind::For(looped) => {
                    let passes = self.passes(&looped.from, &looped.to, looped.step.as_ref());
                    self.inside(stmt.range.end, false, passes);
                    self.body(&looped.body);
                }
                StmtKind::Label(name) => {
                    let rest = body.get(position + 1..).unwrap_or_default();
                    self.label(*name, rest);
                }
                _ => {
                    for inner in inner_bodies(stmt) {
                        self.body(inner);
                    }
                }
            }
        }
    }

    fn inside(&mut self, end: u32, unconditional: bool, passes: Option<u64>) {
        let made = Loop { file: self.ctx().file, routine: motion::RoutineId(0), unconditional, passes };
        self.open.push(Open { end, made, counted: None });
    }

    /// A label begins a loop where a GOTO behind it, in the same body or deeper, jumps back to it.
    fn label(&mut self, name: TextRange, rest: &'a [Stmt]) {
        let (Some(first), Some(last)) = (rest.first(), rest.last()) else { return };
        let body = TextRange::new(first.range.start, last.range.end);
        let file = self.ctx().file;
        let label = lower_case(self.evaluator.index.text(file, name));
        let index = self.evaluator.index;
        let back = |(to, at): &(TextRange, u32)| {
            body.contains(TextRange::empty(*at)) && lower_case(index.text(file, *to)) == label
        };
        let jumps: Vec<u32> = self.gotos.iter().filter(|g| back(g)).map(|(_, at)| *at).collect();
        let Some(&last) = jumps.last() else { return };
        let straight = |s: &Stmt| matches!(s.kind, StmtKind::Goto(_)) && jumps.contains(&s.range.start);
        let unconditional = rest.iter().any(straight);
        let end = rest.iter().map(|s| s.range.end).find(|&end| end > last).unwrap_or(last);
        self.inside(end, unconditional, None);
    }

    /// How often a FOR runs, where its bounds are constant.
    fn passes(&mut self, from: &Expr, to: &Expr, step: Option<&Expr>) -> Option<u64> {
        let ctx = self.ctx();
        let mut number = |expr| match self.evaluator.fold_held(expr, ctx, &Constant).ok()?.value {
            Value::Num(n) => Some(n),
            _ => None,
        };
        let (from, to) = (number(from)?, number(to)?);
        let step = match step {
            Some(step) => number(step)?,
            None => (to - from).signum(), // without STEP it counts towards the end, by one
        };
        let passes = (((to - from) / step).floor() + 1.0).max(0.0);
        (step != 0.0 && passes < 1e15).then(|| counted_in_single([from, to, step], passes as u64))
    }

    /// Text that was not understood but names a move: a motion that must be accounted for.
    fn not_read(&mut self, stmt: &'a Stmt) {
        let (index, file) = (self.evaluator.index, self.ctx().file);
        let text = index.text(file, stmt.range);
        let is_move = |word: &TextRange| move_form(&lower_case(index.text(file, *word))).is_some();
        if let Some(name) = words(text, stmt.range.start).into_iter().find(is_move) {
            self.call(stmt, name, Some(stmt.range));
        }
    }

    fn call(&mut self, stmt: &'a Stmt, name: TextRange, not_read: Option<TextRange>) {
        let ctx = self.ctx();
        let index = self.evaluator.index;
        let written = index.text(ctx.file, name);
        if index.declares_routine(name, ctx) {
            return; // a routine of the program, which may bear an instruction's name
        }
        let form = match (move_form(&lower_case(written)), &stmt.kind) {
            (Some(form), _) => form,
            (None, StmtKind::Call(call)) if seems_to_move(index, ctx, name, &call.args) => &NOT_GIVEN,
            (None, _) => return,
        };
        let info = self.routine();
        let mut loops = Vec::with_capacity(self.open.len());
        for open in &mut self.open {
            let id = *open.counted.get_or_insert_with(|| {
                self.sites.loops.push(Loop { routine: info, ..open.made.clone() });
                self.sites.loops.len() - 1
            });
            loops.push(id);
        }
        if self.sites.nests.last() != Some(&loops) {
            self.sites.nests.push(loops);
        }
        let nest = self.sites.nests.len() as u32 - 1;
        self.sites.motions.push(MotionSite { stmt, form, routine: self.id, info, nest, not_read });
    }

    /// The routine's entry among those with motion, made with its first motion.
    fn routine(&mut self) -> motion::RoutineId {
        if let Some(info) = self.info {
            return info;
        }
        let entry = &self.evaluator.index.routines[self.id];
        let index = self.evaluator.index;
        let module = index.modules.get(entry.ctx.module).map(|m| m.tree.name);
        self.sites.routines.push(RoutineInfo {
            file: entry.ctx.file,
            module: module.map_or(String::new(), |m| as_text(index.text(entry.ctx.file, m))),
            name: as_text(index.text(entry.ctx.file, entry.tree.name)),
            range: entry.tree.range,
        });
        let info = motion::RoutineId(self.sites.routines.len() as u32 - 1);
        self.info = Some(info);
        info
    }
}

/// The statement that was not understood right before or behind the one at `position`, comments aside.
fn not_read_beside(body: &[Stmt], position: usize) -> Option<TextRange> {
    let is_executable = |stmt: &&Stmt| !matches!(stmt.kind, StmtKind::Comment | StmtKind::Empty);
    let before = body.get(..position)?.iter().rev().find(is_executable);
    let behind = body.get(position + 1..)?.iter().find(is_executable);
    before.into_iter().chain(behind).find(|stmt| matches!(stmt.kind, StmtKind::Opaque)).map(|stmt| stmt.range)
}

fn gotos(tree: &Routine) -> Vec<(TextRange, u32)> {
    let mut out = Vec::new();
    for body in bodies(tree) {
        every_statement(body, &mut |stmt| {
            if let StmtKind::Goto(name) = stmt.kind {
                out.push((name, stmt.range.start));
            }
        });
    }
    out
}

fn move_args<'a>(index: &Index<'_>, ctx: Ctx, form: &MoveForm, args: &'a [Arg]) -> MoveArgs<'a> {
    let mut out = MoveArgs::default();
    let mut positional = Vec::new();
    for arg in args {
        match &arg.kind {
            ArgKind::Positional(expr) => positional.push(expr),
            ArgKind::Named { name, value } => {
                let name = lower_case(index.text(ctx.file, *name));
                if name == "wobj" {
                    out.wobj = value.as_ref();
                }
                out.options.push((name, value.as_ref()));
            }
            ArgKind::Conditional { name, param } => {
                out.conditional.push((lower_case(index.text(ctx.file, *name)), *param));
            }
        }
    }
    let at = |position: usize| positional.get(position).copied();
    // Older arc instructions have Weave as one more argument before the zone.
    let weave = usize::from(form.has_seam() && form.tool.is_some_and(|tool| positional.len() == tool + 2));
    out.targets = form.targets.iter().filter_map(|&p| at(p)).collect();
    out.speed = at(form.speed);
    out.zone = form.zone.and_then(|zone| at(zone + weave));
    out.tool = form.tool.and_then(|tool| at(tool + weave));
    out
}
/// More passes than these are as many as the division says.
const COUNTED_ONE_BY_ONE: u64 = 100_000;

/// How often a FOR runs as the controller counts, adding in single precision, where exact numbers give `passes`.
fn counted_in_single([from, to, step]: [f64; 3], passes: u64) -> u64 {
    let ([mut at, to, step], mut n) = ([from, to, step].map(|n| n as f32), 0);
    while passes <= COUNTED_ONE_BY_ONE && n <= passes && (if step > 0.0 { at <= to } else { at >= to }) {
        at += step;
        n += 1;
    }
    if passes <= COUNTED_ONE_BY_ONE { n } else { passes }
}

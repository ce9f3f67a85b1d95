//! Motions, loops and routines as they stand in the text, before anything is known of their values.

use super::fold::{Constant, Folder};
use super::index::{Ctx, Index, Resolved, RoutineId, every_statement, inner_bodies};
use super::instructions::{MoveForm, move_form};
use super::motion::{Loop, Motion, RoutineInfo, Wait};
use super::names::{as_text, lower_case};
use super::value::Value;
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree::{Arg, ArgKind, Callee, Expr, Routine, Stmt, StmtKind};
use std::collections::HashMap;
use std::sync::Arc;

/// A motion and the expressions it is made of.
#[derive(Debug)]
pub(super) struct Draft<'a> {
    pub(super) motion: Motion,
    pub(super) ctx: Ctx,
    pub(super) form: &'static MoveForm,
    /// As they stand in the text; [`args`](Self::args) says which is what.
    pub(super) written: &'a [Arg],
}

impl<'a> Draft<'a> {
    /// Its arguments by what they are.
    pub(super) fn args(&self, index: &Index<'_>) -> MoveArgs<'a> {
        move_args(index, self.ctx, self.form, self.written)
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
    /// `\Name?parameter`, by name in lower case.
    pub(super) conditional: Vec<String>,
}

impl MoveArgs<'_> {
    /// Whether an option is there.
    pub(super) fn has(&self, option: &str) -> bool {
        self.options.iter().any(|(name, _)| name == option) || self.conditional.iter().any(|n| n == option)
    }
}

/// All motions, loops and routines of a program, in file order.
#[derive(Debug, Default)]
pub(super) struct Drafts<'a> {
    pub(super) motions: Vec<Draft<'a>>,
    pub(super) loops: Vec<Loop>,
    pub(super) routines: Vec<RoutineInfo>,
    /// The motion that a statement (file, first byte) is.
    pub(super) at: HashMap<(u32, u32), usize>,
}

impl<'a> Drafts<'a> {
    /// What stands in all files.
    pub(super) fn new(folder: &mut Folder<'a>) -> Self {
        let index = folder.index;
        // Room for all at once: drafts are many, and a list that grows holds them twice.
        let mut statements = 0;
        for tree in index.routines.iter().map(|routine| routine.tree) {
            let handlers = tree.handlers.iter().map(|handler| &handler.body);
            std::iter::once(&tree.body)
                .chain(handlers)
                .for_each(|body| every_statement(body, &mut |_| statements += 1));
        }
        let mut drafts = Self { motions: Vec::with_capacity(statements), ..Self::default() };
        for (id, routine) in index.routines.iter().enumerate() {
            let gotos = gotos(routine.tree);
            let (drafts, open) = (&mut drafts, Vec::new());
            let mut walk =
                Walk { drafts, folder: &mut *folder, id, gotos, open, info: None, last_names: [None, None] };
            walk.body(&routine.tree.body);
            for handler in &routine.tree.handlers {
                walk.open.clear();
                walk.body(&handler.body);
            }
        }
        drafts
    }
}

/// A loop round what is being read; it is counted as soon as it turns out to hold a motion.
struct Open {
    end: u32,
    made: Loop,
    counted: Option<usize>,
}

struct Walk<'d, 'a> {
    drafts: &'d mut Drafts<'a>,
    folder: &'d mut Folder<'a>,
    id: RoutineId,
    gotos: Vec<(TextRange, u32)>,
    open: Vec<Open>,
    info: Option<usize>,
    /// The last names of a tool and of a work object: most motions share them.
    last_names: [Option<Arc<str>>; 2],
}

impl<'a> Walk<'_, 'a> {
    fn ctx(&self) -> Ctx {
        self.folder.index.routines[self.id].ctx
    }

    fn body(&mut self, body: &'a [Stmt]) {
        for (position, stmt) in body.iter().enumerate() {
            self.open.retain(|open| open.end > stmt.range.start);
            match &stmt.kind {
                StmtKind::Call(call) => {
                    if let Callee::Name(name) = &call.callee {
                        self.call(stmt, *name, &call.args);
                    }
                }
                StmtKind::While { cond, body } => {
                    let ctx = self.ctx();
                    let cond = self.folder.fold(cond, ctx, &Constant).map(|t| t.value);
                    let unconditional = matches!(cond, Ok(Value::Bool(true)));
                    self.inside(stmt.range.end, unconditional, None);
                    self.body(body);
                }
                StmtKind::For { from, to, step, body, .. } => {
                    let passes = self.passes(from, to, step.as_deref());
                    self.inside(stmt.range.end, false, passes);
                    self.body(body);
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
        let made = Loop { file: self.ctx().file, routine: 0, unconditional, passes };
        self.open.push(Open { end, made, counted: None });
    }

    /// A label begins a loop where a GOTO behind it, in the same body or deeper, jumps back to it.
    fn label(&mut self, name: TextRange, rest: &'a [Stmt]) {
        let (Some(first), Some(last)) = (rest.first(), rest.last()) else { return };
        let body = TextRange::new(first.range.start, last.range.end);
        let file = self.ctx().file;
        let label = lower_case(self.folder.index.text(file, name));
        let index = self.folder.index;
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
        let mut number = |expr| match self.folder.fold(expr, ctx, &Constant).ok()?.value {
            Value::Num(n) => Some(n),
            _ => None,
        };
        let (from, to) = (number(from)?, number(to)?);
        let step = match step {
            Some(step) => number(step)?,
            None => (to - from).signum(), // without STEP it counts towards the end, by one
        };
        let passes = ((to - from) / step).floor() + 1.0;
        (step != 0.0 && passes < 1e15).then_some(passes.max(0.0) as u64)
    }

    fn call(&mut self, stmt: &'a Stmt, name: TextRange, args: &'a [Arg]) {
        let ctx = self.ctx();
        let index = self.folder.index;
        let written = index.text(ctx.file, name);
        let Some(form) = move_form(&lower_case(written)) else { return };
        let own = index.names.find(written).map(|name| index.routine(name, ctx));
        if own.is_some_and(|r| r != Resolved::Nowhere) {
            return; // a routine of the program bears the instruction's name
        }
        let routine = self.routine();
        let mut loops = Vec::with_capacity(self.open.len());
        for open in &mut self.open {
            let id = *open.counted.get_or_insert_with(|| {
                self.drafts.loops.push(Loop { routine, ..open.made.clone() });
                self.drafts.loops.len() - 1
            });
            loops.push(id);
        }
        let by_role = move_args(index, ctx, form, args);
        let name = |last: &mut Option<Arc<str>>, expr: Option<&Expr>| {
            let name = as_text(index.text(ctx.file, expr?.range));
            let kept = last.take().filter(|last| **last == *name);
            Some(Arc::clone(last.insert(kept.unwrap_or_else(|| name.into()))))
        };
        let [last_tool, last_wobj] = &mut self.last_names;
        let (tool_name, wobj_name) = (name(last_tool, by_role.tool), name(last_wobj, by_role.wobj));
        let motion = Motion {
            file: ctx.file,
            line: index.file(ctx.file).line(stmt.range),
            routine,
            loops,
            range: stmt.range,
            kind: form.name,
            path: form.path,
            targets: Vec::new(),
            tool_name,
            tool: None,
            wobj_name,
            wobj: None,
            speed: None,
            zone: None,
            conf_monitored: None,
            grip: None,
            previous: None,
            wait_before: Wait::None,
            wait_since_entry: None,
            keep: None,
            run_time: false,
            from_search: false,
            tool_range: by_role.tool.map(|expr| expr.range),
            wobj_range: by_role.wobj.map(|expr| expr.range),
        };
        self.drafts.at.insert((ctx.file.0, stmt.range.start), self.drafts.motions.len());
        self.drafts.motions.push(Draft { motion, ctx, form, written: args });
    }

    /// The routine's entry among those with motion, made with its first motion.
    fn routine(&mut self) -> usize {
        if let Some(info) = self.info {
            return info;
        }
        let entry = &self.folder.index.routines[self.id];
        let index = self.folder.index;
        let module = index.modules.get(entry.ctx.module).map(|m| m.tree.name);
        self.drafts.routines.push(RoutineInfo {
            file: entry.ctx.file,
            module: module.map_or(String::new(), |m| as_text(index.text(entry.ctx.file, m))),
            name: as_text(index.text(entry.ctx.file, entry.tree.name)),
            range: entry.tree.range,
        });
        let info = self.drafts.routines.len() - 1;
        self.info = Some(info);
        info
    }
}

fn gotos(tree: &Routine) -> Vec<(TextRange, u32)> {
    let mut out = Vec::new();
    let handlers = tree.handlers.iter().map(|h| &h.body);
    for body in std::iter::once(&tree.body).chain(handlers) {
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
            ArgKind::Conditional { name, .. } => {
                out.conditional.push(lower_case(index.text(ctx.file, *name)));
            }
        }
    }
    let at = |position: usize| positional.get(position).copied();
    out.targets = form.targets.iter().filter_map(|&p| at(p)).collect();
    out.speed = at(form.speed);
    out.zone = form.zone.and_then(at);
    out.tool = form.tool.and_then(at);
    out
}

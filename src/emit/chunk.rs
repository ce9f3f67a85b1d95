//! Runs of statements that can stand in another module: what a bucket's module holds of a routine.
//!
//! A run leaves its routine only at its end, calls no routine in which the clock may be asked, and whatever it names
//! that the other module does not see can be handed over as a parameter of the same name.

use std::collections::{BTreeMap, BTreeSet};

use super::place;
use crate::diagnostic::TextRange;
use crate::program::Program;
use crate::syntax::SourceFile;
use crate::syntax::tree::{
    ArgKind, Callee, DataDecl, DataKind, Expr, ExprKind, FileItem, Module, ModuleItem, ParamMode, Routine,
    RoutineKind, Scope, Stmt, StmtKind,
};

/// Fewer compensated motions than this are not worth a call of another module.
const FEWEST: usize = 4;

/// A run of statements.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Chunk {
    /// From its first statement to the end of its last.
    pub range: TextRange,
    /// The line it begins on.
    pub line: u32,
    /// What is handed over.
    pub passed: Vec<Passed>,
    /// The routine's name.
    pub routine: String,
}

/// A name of the routine or of its module that the run uses.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Passed {
    /// The name.
    pub name: String,
    /// `PERS `, `VAR `, `INOUT ` or nothing.
    pub mode: &'static str,
    /// Name of its type.
    pub type_name: String,
    /// Number of dimensions.
    pub dims: usize,
}

/// What all modules together declare that matters here, names in lower case.
#[derive(Debug, Default)]
pub struct Declared {
    routines: BTreeSet<String>,
    hidden: BTreeMap<String, Option<Passed>>,
    global: BTreeSet<String>,
    local_types: BTreeSet<String>,
}

impl Declared {
    /// Of all files of a program.
    #[must_use]
    pub fn new(program: &Program) -> Self {
        let mut declared = Self::default();
        for file in &program.files {
            for item in modules(file).flat_map(|module| &module.items) {
                match item {
                    ModuleItem::Routine(routine) => {
                        declared.routines.insert(lower(file, routine.name));
                    }
                    ModuleItem::Data(data) if data.scope == Scope::Local => {
                        declared.hidden.insert(lower(file, data.name), passed(file, data));
                    }
                    ModuleItem::Data(data) => {
                        declared.global.insert(lower(file, data.name));
                    }
                    ModuleItem::Record(record) if record.scope == Scope::Local => {
                        declared.local_types.insert(lower(file, record.name));
                    }
                    ModuleItem::Alias(alias) if alias.scope == Scope::Local => {
                        declared.local_types.insert(lower(file, alias.name));
                    }
                    _ => {}
                }
            }
        }
        declared
    }
}

fn modules(file: &SourceFile) -> impl Iterator<Item = &Module> {
    file.tree.items.iter().filter_map(|item| match item {
        FileItem::Module(module) => Some(module),
        _ => None,
    })
}

fn lower(file: &SourceFile, range: TextRange) -> String {
    String::from_utf8_lossy(file.text(range)).to_ascii_lowercase()
}

fn text(file: &SourceFile, range: TextRange) -> String {
    String::from_utf8_lossy(file.text(range)).into_owned()
}

/// How data are handed over; `None` where their name is not ASCII.
fn passed(file: &SourceFile, data: &DataDecl) -> Option<Passed> {
    let mode = match data.kind {
        DataKind::Pers => "PERS ",
        DataKind::Var => "VAR ",
        DataKind::Const => "",
    };
    let made = Passed {
        name: text(file, data.name),
        mode,
        type_name: text(file, data.type_name),
        dims: data.dims.len(),
    };
    (made.name.is_ascii() && made.type_name.is_ascii()).then_some(made)
}

/// The runs of a module, in order; `starts` are where its compensated motions begin, `ticks` the statements before which the
/// clock must be asked.
#[must_use]
pub fn chunks(
    declared: &Declared,
    file: &SourceFile,
    module: &Module,
    starts: &BTreeSet<u32>,
    ticks: &BTreeSet<u32>,
) -> Vec<Chunk> {
    let mut found = Vec::new();
    for item in &module.items {
        let ModuleItem::Routine(routine) = item else { continue };
        let fits = routine.kind == RoutineKind::Proc && routine.handlers.is_empty() && routine.end.is_some();
        if fits && starts.range(routine.range.start..routine.range.end).next().is_some() {
            let (found, loops) = (&mut found, Vec::new());
            let mut work = Work { declared, file, module, routine, starts, ticks, found, loops };
            work.list(&routine.body);
        }
    }
    found
}

struct Work<'w> {
    declared: &'w Declared,
    file: &'w SourceFile,
    module: &'w Module,
    routine: &'w Routine,
    starts: &'w BTreeSet<u32>,
    ticks: &'w BTreeSet<u32>,
    found: &'w mut Vec<Chunk>,
    /// Variables of the loops round the statements at hand, in lower case.
    loops: Vec<String>,
}

impl Work<'_> {
    fn list(&mut self, body: &[Stmt]) {
        let mut run: Option<TextRange> = None;
        for stmt in body {
            let range = stmt.range;
            if matches!(stmt.kind, StmtKind::Comment | StmtKind::Empty) {
                continue;
            }
            if self.ticks.contains(&range.start) {
                self.close(run.take());
            }
            let tick_inside =
                self.ticks.range(range.start + 1..range.end.max(range.start + 1)).next().is_some();
            if !tick_inside && self.is_portable(stmt) {
                run = Some(run.map_or(range, |run| run.cover(range)));
                continue;
            }
            self.close(run.take());
            self.inside(stmt);
        }
        self.close(run);
    }

    fn inside(&mut self, stmt: &Stmt) {
        match &stmt.kind {
            StmtKind::If { arms, otherwise } => {
                arms.iter().for_each(|(_, body)| self.list(body));
                self.list(otherwise.as_deref().unwrap_or_default());
            }
            StmtKind::While { body, .. } => self.list(body),
            StmtKind::For { var, body, .. } => {
                self.loops.push(lower(self.file, *var));
                self.list(body);
                self.loops.pop();
            }
            StmtKind::Test { cases, default, .. } => {
                cases.iter().for_each(|(_, body)| self.list(body));
                self.list(default.as_deref().unwrap_or_default());
            }
            _ => {}
        }
    }

    /// Whether a statement does the same in another routine.
    fn is_portable(&self, stmt: &Stmt) -> bool {
        let all = |body: &[Stmt]| body.iter().all(|stmt| self.is_portable(stmt));
        match &stmt.kind {
            StmtKind::Assign { .. } | StmtKind::Empty | StmtKind::Comment | StmtKind::Exit => true,
            StmtKind::Call(call) => match call.callee {
                Callee::Name(name) => {
                    call.terminated
                        && !self.declared.routines.contains(&lower(self.file, name))
                        && !call.args.iter().any(|arg| matches!(arg.kind, ArgKind::Conditional { .. }))
                }
                Callee::Late(_) => false,
            },
            StmtKind::If { arms, otherwise } => {
                arms.iter().all(|(_, body)| all(body)) && otherwise.as_deref().is_none_or(all)
            }
            StmtKind::CompactIf { then, .. } => self.is_portable(then),
            StmtKind::For { body, .. } | StmtKind::While { body, .. } => all(body),
            StmtKind::Test { cases, default, .. } => {
                cases.iter().all(|(_, body)| all(body)) && default.as_deref().is_none_or(all)
            }
            _ => false,
        }
    }

    fn close(&mut self, run: Option<TextRange>) {
        let Some(range) = run else { return };
        if self.starts.range(range.start..range.end).take(FEWEST).count() < FEWEST {
            return;
        }
        if let Some(passed) = self.passed(range) {
            let routine = text(self.file, self.routine.name);
            let line = self.file.line(range);
            self.found.push(Chunk { range, line, passed, routine });
        }
    }

    /// What must be handed over; `None` where something cannot be.
    fn passed(&self, range: TextRange) -> Option<Vec<Passed>> {
        let mut found = Vec::new();
        let assigned = |name: &str| {
            place::statements(self.routine).iter().any(|stmt| match &stmt.kind {
                StmtKind::Assign { target, .. } => {
                    range.start <= stmt.range.start
                        && stmt.range.end <= range.end
                        && lower(self.file, root(target)) == name
                }
                _ => false,
            })
        };
        for word in code_words(self.file.text(range)) {
            if let Some(param) = self.routine.params.iter().find(|p| lower(self.file, p.name) == word) {
                let mode = match param.mode {
                    ParamMode::In if !param.optional && !assigned(&word) => "",
                    ParamMode::Var => "VAR ",
                    ParamMode::Pers => "PERS ",
                    ParamMode::InOut => "INOUT ",
                    ParamMode::In => return None,
                };
                found.push(Passed {
                    name: text(self.file, param.name),
                    mode,
                    type_name: text(self.file, param.type_name),
                    dims: usize::from(param.dims),
                });
            } else if self.loops.contains(&word) {
                found.push(Passed { name: word, mode: "", type_name: "num".to_owned(), dims: 0 });
            } else if let Some(data) = self.local_data(&word) {
                found.push(passed(self.file, data)?);
            } else if self.is_local_routine(&word) {
                return None;
            } else if let Some(data) = self.module_data(&word) {
                if data.scope == Scope::Local {
                    found.push(passed(self.file, data)?);
                }
            } else if let Some(hidden) = self.declared.hidden.get(&word)
                && !self.declared.global.contains(&word)
            {
                found.push(hidden.clone()?);
            }
        }
        let sees = |p: &Passed| !self.declared.local_types.contains(&p.type_name.to_ascii_lowercase());
        found.iter().all(sees).then_some(found)
    }

    fn local_data(&self, word: &str) -> Option<&DataDecl> {
        self.routine.body.iter().find_map(|stmt| match &stmt.kind {
            StmtKind::Data(data) if lower(self.file, data.name) == word => Some(data.as_ref()),
            _ => None,
        })
    }

    fn module_data(&self, word: &str) -> Option<&DataDecl> {
        self.module.items.iter().find_map(|item| match item {
            ModuleItem::Data(data) if lower(self.file, data.name) == word => Some(data),
            _ => None,
        })
    }

    fn is_local_routine(&self, word: &str) -> bool {
        self.module.items.iter().any(|item| match item {
            ModuleItem::Routine(r) => r.scope == Scope::Local && lower(self.file, r.name) == word,
            _ => false,
        })
    }
}

/// The name that an assignment's target begins with.
fn root(target: &Expr) -> TextRange {
    match &target.kind {
        ExprKind::Field { base, .. } | ExprKind::Index { base, .. } | ExprKind::Paren(base) => root(base),
        _ => target.range,
    }
}

/// The words of RAPID text in lower case, those in comments and strings left out.
fn code_words(code: &[u8]) -> BTreeSet<String> {
    let mut plain = Vec::with_capacity(code.len());
    let (mut string, mut comment) = (false, false);
    for &byte in code {
        match byte {
            b'\n' | b'\r' => (string, comment) = (false, false),
            b'"' if !comment => string = !string,
            b'!' if !string => comment = true,
            _ => {}
        }
        plain.push(if string || comment { b' ' } else { byte });
    }
    let mut words = BTreeSet::new();
    super::names::words(&plain, |word| {
        words.insert(String::from_utf8_lossy(word).to_ascii_lowercase());
    });
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_of_comments_and_strings_are_none() {
        let code = b"MoveL p1,v100; ! rdkTool is \"mine\"\nTPWrite \"a ! b\"+s1; x:=1;";
        let words: Vec<String> = code_words(code).into_iter().collect();
        assert_eq!(words, ["movel", "p1", "s1", "tpwrite", "v100", "x"]);
    }
}

//! Facts about files beside their motion: which modules there are, what RoboDK says of the kinematics it used, which robot a
//! program was made for, and whether a module is already compensated.

use super::ids::{RoutineIndex, Table};
use super::index::Index;
use super::made_for::{self, RobotRemark};
use super::names::{as_text, lower_case};
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::{FileId, Span, TextRange};
use rapid_syntax::tree::{FileItem, Module, ModuleItem, Stmt, StmtKind};

/// The first words of the header of a module that this program has emitted.
pub const EMITTED_MARK: &str = "! driftpost";

/// What is known of the files beside their motion.
#[derive(Clone, Debug, Default)]
pub struct Facts {
    /// All modules, in file order.
    pub modules: Vec<ModuleFacts>,
    /// `! Using X kinematics.`, in file order.
    pub kinematics: Vec<KinematicsRemark>,
    /// The robots that programs say they were made for, file by file.
    pub made_for: Vec<RobotRemark>,
    /// Routines that nothing in the given files calls: a program can begin there. In file order.
    pub entries: Vec<Entry>,
}

impl Facts {
    /// Keeps those of some files.
    pub(super) fn retain(&mut self, of: impl Fn(FileId) -> bool) {
        self.modules.retain(|module| of(module.file));
        self.kinematics.retain(|remark| of(remark.span.file));
        self.made_for.retain(|remark| of(remark.span.file));
        self.entries.retain(|entry| of(entry.file));
    }
}

/// What is known of a module.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ModuleFacts {
    /// The file it stands in.
    pub file: FileId,
    /// Its name as written.
    pub name: String,
    /// What shows that this program has already compensated it.
    pub compensated: Option<TextRange>,
}

/// RoboDK's remark on the kinematics a program was made with.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct KinematicsRemark {
    /// The word between `Using` and `kinematics`.
    pub word: String,
    /// Where the comment stands.
    pub span: Span,
}

impl KinematicsRemark {
    /// Whether the program was made for the nominal robot.
    #[must_use]
    pub fn is_nominal(&self) -> bool {
        self.word.eq_ignore_ascii_case("nominal")
    }
}

/// A routine that nothing calls.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// The file it stands in.
    pub file: FileId,
    /// Its module's name as written.
    pub module: String,
    /// Its name as written.
    pub name: String,
    /// The whole routine, head and end included.
    pub range: TextRange,
}

/// The facts of all files; `called`: for each routine of the index, whether anything calls it.
pub(super) fn facts(index: &Index<'_>, called: &Table<RoutineIndex, bool>) -> Facts {
    let mut facts = Facts::default();
    for file in index.files {
        facts.made_for.extend(made_for::in_heads(file));
        for item in &file.tree.items {
            match item {
                FileItem::Module(module) => {
                    facts.modules.push(module_facts(file, module));
                    for_each_comment(module, &mut |range| {
                        facts.kinematics.extend(remark(file, range));
                        facts.made_for.extend(made_for::remark(file, range));
                    });
                }
                FileItem::Comment(range) => {
                    facts.kinematics.extend(remark(file, *range));
                    facts.made_for.extend(made_for::remark(file, *range));
                }
                FileItem::Opaque(_) => {}
            }
        }
    }
    for (routine, called) in index.routines.iter().zip(called) {
        let callable = routine.tree.kind == rapid_syntax::tree::RoutineKind::Proc;
        if *called || !callable {
            continue;
        }
        let file = routine.ctx.file;
        let module = index.modules.get(routine.ctx.module).map(|m| m.tree.name);
        facts.entries.push(Entry {
            file,
            module: module.map_or(String::new(), |m| as_text(index.text(file, m))),
            name: as_text(index.text(file, routine.tree.name)),
            range: routine.tree.range,
        });
    }
    facts
}

fn module_facts(file: &SourceFile, module: &Module) -> ModuleFacts {
    let (mut in_head, mut mark) = (true, None);
    let (mut state, mut update) = (None, None);
    for item in &module.items {
        match item {
            ModuleItem::Data(data) => {
                if lower_case(file.text(data.name)) == "tcstate" {
                    state = state.or(Some(data.range));
                }
            }
            ModuleItem::Routine(routine) => {
                in_head = false;
                if lower_case(file.text(routine.name)) == "tcupdate" {
                    update = update.or(Some(routine.head));
                }
            }
            ModuleItem::Comment(range) => {
                let text = as_text(file.text(*range));
                if in_head && text.trim_end().to_lowercase().starts_with(EMITTED_MARK) {
                    mark = mark.or(Some(*range));
                }
            }
            ModuleItem::Record(_) | ModuleItem::Alias(_) | ModuleItem::Opaque(_) => {}
        }
    }
    ModuleFacts {
        file: file.id,
        name: as_text(file.text(module.name)),
        // The names alone may be the user's own: both together are not by chance.
        compensated: mark.or(state.filter(|_| update.is_some())),
    }
}

fn for_each_comment(module: &Module, visit: &mut dyn FnMut(TextRange)) {
    let in_body = |body: &[Stmt], visit: &mut dyn FnMut(TextRange)| {
        super::statements::every_statement(body, &mut |stmt| {
            if matches!(stmt.kind, StmtKind::Comment) {
                visit(stmt.range);
            }
        });
    };
    for item in &module.items {
        match item {
            ModuleItem::Comment(range) => visit(*range),
            ModuleItem::Routine(routine) => {
                in_body(&routine.body, visit);
                routine.handlers.iter().for_each(|h| in_body(&h.body, visit));
            }
            _ => {}
        }
    }
}

/// `! Using nominal kinematics.`, whatever its case and blanks.
fn remark(file: &SourceFile, range: TextRange) -> Option<KinematicsRemark> {
    let text = as_text(file.text(range));
    let text = text.trim_start_matches('!').trim_end_matches(|c: char| c == '.' || c.is_whitespace());
    let words: Vec<&str> = text.split_whitespace().collect();
    match words.as_slice() {
        [using, word @ .., kinematics]
            if !word.is_empty()
                && using.eq_ignore_ascii_case("using")
                && kinematics.eq_ignore_ascii_case("kinematics") =>
        {
            Some(KinematicsRemark { word: word.join(" "), span: file.span(range) })
        }
        _ => None,
    }
}

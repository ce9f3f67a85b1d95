//! A target that is named from outside, with a tool and a work object: where a fixed point is touched.

use super::const_eval::ConstEvaluator;
use super::convert::{self, ConversionError};
use super::data::{RobTarget, ToolData, WobjData};
use super::index::{Ctx, Datum, Index, RoutineEntry};
use super::motion::MotionSetup;
use super::names::lower_case;
use super::predefined::predefined;
use super::value::Value;
use super::writes::Writes;
use super::{Overrides, Program};
use rapid_syntax::diagnostic::{Diagnostic, FileId};
use rapid_syntax::tree::{FileItem, RoutineKind, Scope};

/// A target, its tool and its work object, as the program has them.
#[derive(Clone, Debug, PartialEq)]
pub struct FixedPoint {
    /// The target whose point is touched.
    pub target: RobTarget,
    /// The tool that touches.
    pub tool: ToolData,
    /// The work object that the target stands in.
    pub wobj: WobjData,
    /// Those of the three that are LOCAL to their module.
    pub local: Vec<LocalName>,
}

/// A name that only modules of their own see.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LocalName {
    /// The name as the program spells it.
    pub name: String,
    /// The modules that declare it: their files, and which of a file's modules it is.
    pub modules: Vec<(FileId, usize)>,
}

impl Program {
    /// The point of a target, tool and work object by their names. A tool or work object that the program assigns has
    /// the value with which a motion uses it first.
    ///
    /// # Errors
    /// `touch::point`, saying which name is not known and why.
    pub fn fixed_point(
        &self,
        overrides: &Overrides,
        [target, tool, wobj]: [&str; 3],
    ) -> Result<FixedPoint, Diagnostic> {
        let given = super::overrides::given(overrides, &mut Vec::new());
        let index = Index::new(&self.files);
        let writes = Writes::new(&index);
        let mut evaluator = ConstEvaluator::new(&index, &writes);
        let mut local = Vec::new();
        let mut initial = |name: &str| -> Result<Value, String> {
            let sym = index.names.find(name.as_bytes());
            let declared = |d: &&Datum<'_>| Some(d.name) == sym && d.ctx.routine.is_none();
            let global = index.data.numbered().find(|(_, d)| declared(d) && !d.local);
            if let Some((datum, entry)) = global.or_else(|| index.data.numbered().find(|(_, d)| declared(d)))
            {
                if entry.local {
                    let modules = index.data.iter().filter(declared).map(|d| module_at(&index, d.ctx));
                    local.push(LocalName { name: name.to_owned(), modules: modules.collect() });
                }
                return evaluator.initial(datum).map_err(|why| why.reason.clone());
            }
            let lower = lower_case(name.as_bytes());
            let known = given.get(&lower).cloned().or_else(|| predefined(&lower));
            known.map(|(_, value)| value).ok_or_else(|| "is not declared in the given files".to_owned())
        };
        let used = |is: &dyn Fn(&MotionSetup) -> bool| self.motions.iter().map(|m| &m.setup).find(|s| is(s));
        let same = |of: &Option<String>, name: &str| {
            of.as_deref().is_some_and(|of| of.trim().eq_ignore_ascii_case(name))
        };
        let (at, held, on) = (initial(target), initial(tool), initial(wobj));
        let in_use = used(&|s| s.tool.is_some() && same(&s.tool_name, tool)).and_then(|s| s.tool.clone());
        let stands = used(&|s| s.wobj.is_some() && same(&s.wobj_name, wobj)).and_then(|s| s.wobj.clone());
        Ok(FixedPoint {
            target: at.and_then(|v| read(&v, convert::robtarget)).map_err(|why| unknown(target, &why))?,
            tool: match in_use {
                Some(tool) => tool,
                None => held.and_then(|v| read(&v, convert::tooldata)).map_err(|why| unknown(tool, &why))?,
            },
            wobj: match stands {
                Some(wobj) => wobj,
                None => on.and_then(|v| read(&v, convert::wobjdata)).map_err(|why| unknown(wobj, &why))?,
            },
            local,
        })
    }

    /// A procedure that is called from outside by its name, where none but LOCAL ones have it.
    #[must_use]
    pub fn local_procedure(&self, name: &str) -> Option<LocalName> {
        let index = Index::new(&self.files);
        let sym = index.names.find(name.as_bytes())?;
        let is_named =
            |routine: &&RoutineEntry<'_>| routine.name == sym && routine.tree.kind == RoutineKind::Proc;
        let named: Vec<&RoutineEntry<'_>> = index.routines.iter().filter(is_named).collect();
        let all_local = !named.is_empty() && named.iter().all(|routine| routine.tree.scope == Scope::Local);
        all_local.then(|| LocalName {
            name: name.to_owned(),
            modules: named.iter().map(|routine| module_at(&index, routine.ctx)).collect(),
        })
    }
}

/// The file of a module, and its position among the file's items: comments before it are items too.
fn module_at(index: &Index<'_>, ctx: Ctx) -> (FileId, usize) {
    let name = index.modules.get(ctx.module).map(|module| module.tree.name);
    let is_this = |item: &FileItem| matches!(item, FileItem::Module(module) if Some(module.name) == name);
    let items = &index.file(ctx.file).tree.items;
    (ctx.file, items.iter().position(is_this).unwrap_or(items.len()))
}

fn read<T>(value: &Value, convert: fn(&Value) -> Result<T, ConversionError>) -> Result<T, String> {
    convert(value).map_err(|(_, reason)| reason)
}

fn unknown(name: &str, why: &str) -> Diagnostic {
    Diagnostic::error("touch::point", format!("--touch: {name} {why}"))
        .help("name a robtarget, a tooldata and a wobjdata of the given files: NAME=TARGET,TOOL,WOBJ")
}

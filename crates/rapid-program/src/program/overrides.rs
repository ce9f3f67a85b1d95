//! Tools and work objects given from outside for names that no given module declares.

use super::Overrides;
use super::const_eval::{ConstEvaluator, Constant};
use super::convert;
use super::index::Index;
use super::names::lower_case;
use super::value::Value;
use super::writes::Writes;
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::{Diagnostic, FileId};
use std::collections::BTreeMap;

/// The values by name in lower case; what cannot be read becomes an error.
pub(super) fn given(
    overrides: &Overrides,
    diagnostics: &mut Vec<Diagnostic>,
) -> BTreeMap<String, (&'static str, Value)> {
    let mut out = BTreeMap::new();
    let tools = overrides.tools.iter().map(|given| ("tooldata", "tool", given));
    let wobjs = overrides.wobjs.iter().map(|given| ("wobjdata", "work object", given));
    for (type_name, what, (name, text)) in tools.chain(wobjs) {
        match value(type_name, name, text) {
            Ok(value) => {
                out.insert(lower_case(name.as_bytes()), (type_name, value));
            }
            Err(reason) => {
                let message = format!("the value given for the {what} {name} cannot be read: {reason}");
                let like = match type_name {
                    "tooldata" => "[TRUE,[[0,0,100],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]]",
                    _ => "[FALSE,TRUE,\"\",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]]",
                };
                let help = format!("write it as RAPID does: {name}={like}");
                diagnostics.push(Diagnostic::error("override::not-read", message).help(help));
            }
        }
    }
    out
}

/// Warns about values for names that the files declare themselves: those are not used.
pub(super) fn unused(
    evaluator: &ConstEvaluator<'_>,
    overrides: &Overrides,
    diagnostics: &mut Vec<Diagnostic>,
) {
    let index = evaluator.index;
    for (name, _) in overrides.tools.iter().chain(&overrides.wobjs) {
        let Some(sym) = index.names.find(name.as_bytes()) else { continue };
        let declared = index.data.iter().position(|d| d.name == sym && d.ctx.routine.is_none());
        if let Some(datum) = declared {
            diagnostics.push(
                Diagnostic::warning("override::declared", format!("{name} is declared in the given files"))
                    .at(index.declaration(datum))
                    .help("the declaration counts wherever it is seen; the value given for it does not"),
            );
        }
    }
}

fn value(type_name: &str, name: &str, text: &str) -> Result<Value, String> {
    let source = format!("MODULE given\nPERS {type_name} {name}:={text};\nENDMODULE\n");
    let files = [SourceFile::read(FileId(0), "given", source.into_bytes())];
    let index = Index::new(&files);
    let writes = Writes::new(&index);
    let mut evaluator = ConstEvaluator::new(&index, &writes);
    let sym = index.names.find(name.as_bytes());
    match index.data.as_slice() {
        [declared] if Some(declared.name) == sym && files[0].warnings.is_empty() => {}
        _ => return Err("it is no RAPID value".into()),
    }
    let value = evaluator.datum(0, &Constant).map_err(|why| why.reason.clone())?;
    match type_name {
        "tooldata" => convert::tooldata(&value).map(|_| ()),
        _ => convert::wobjdata(&value).map(|_| ()),
    }
    .map_err(|(_, reason)| reason)?;
    Ok(value)
}

//! What is said from outside about a program: tools and work objects that no given module declares, and where the arm stands
//! at the entry.

use super::Overrides;
use super::const_eval::{ConstEvaluator, Constant};
use super::convert;
use super::index::{Datum, Index};
use super::is_of_task;
use super::names::{as_text, lower_case};
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
        let declared = index.data.numbered().find(|(_, d)| d.name == sym && d.ctx.routine.is_none());
        if let Some((datum, _)) = declared {
            diagnostics.push(
                Diagnostic::warning("override::declared", format!("{name} is declared in the given files"))
                    .at(index.declaration(datum))
                    .help("the declaration counts wherever it is seen; the value given for it does not"),
            );
        }
    }
}

/// The joints of the jointtarget that `--home` names, radians; what is wrong with it becomes an error.
pub(super) fn home(
    evaluator: &mut ConstEvaluator<'_>,
    overrides: &Overrides,
    diagnostics: &mut Vec<Diagnostic>,
) -> Option<[f64; 6]> {
    let name = overrides.home.as_deref()?;
    let index = evaluator.index;
    let sym = index.names.find(name.as_bytes());
    let declared = |d: &Datum<'_>| {
        let of_task = || is_of_task(&index.file(d.ctx.file).path, overrides.task.as_deref());
        Some(d.name) == sym && d.ctx.routine.is_none() && (overrides.task.is_none() || of_task())
    };
    let joints = match index.data.numbered().find(|(_, d)| declared(d)) {
        None => Err("is not declared in the given files".to_owned()),
        Some((_, d)) if index.type_text(d.type_name) != "jointtarget" => {
            Err("is no jointtarget, and a pose alone does not tell the joints".to_owned())
        }
        Some((datum, _)) => {
            evaluator.datum(datum, &Constant).map_err(|why| format!("is not known: {}", why.reason))
        }
    };
    let joints = joints.and_then(|value| {
        let joints =
            convert::jointtarget(&value).map_err(|(_, reason)| format!("cannot be read: {reason}"))?;
        let all: Option<Vec<f64>> = joints.q_rad.into_iter().collect();
        let all: Option<[f64; 6]> = all.and_then(|all| all.try_into().ok());
        all.ok_or_else(|| "leaves an axis of the arm where it is (9E9)".to_owned())
    });
    joints
        .map_err(|reason| {
            let text = format!("--home {name} {reason}");
            let is_jointtarget =
                |d: &&Datum<'_>| d.ctx.routine.is_none() && index.type_text(d.type_name) == "jointtarget";
            let there = index.data.iter().filter(is_jointtarget).take(8);
            let there: Vec<String> = there.map(|d| as_text(index.text(d.ctx.file, d.name_range))).collect();
            let those = if there.is_empty() { String::new() } else { format!(" ({})", there.join(", ")) };
            let help = format!(
                "name a jointtarget of the program{those}, or give the six angles with --start-joints"
            );
            diagnostics.push(Diagnostic::error("override::home", text).help(help));
        })
        .ok()
}

fn value(type_name: &str, name: &str, text: &str) -> Result<Value, String> {
    let source = format!("MODULE given\nPERS {type_name} {name}:={text};\nENDMODULE\n");
    let files = [SourceFile::read(FileId(0), "given", source.into_bytes())];
    let index = Index::new(&files);
    let writes = Writes::new(&index);
    let mut evaluator = ConstEvaluator::new(&index, &writes);
    let sym = index.names.find(name.as_bytes());
    let mut declared = index.data.numbered();
    let datum = match (declared.next(), declared.next()) {
        (Some((datum, entry)), None) if Some(entry.name) == sym && files[0].warnings.is_empty() => datum,
        _ => return Err("it is no RAPID value".into()),
    };
    let value = evaluator.datum(datum, &Constant).map_err(|why| why.reason.clone())?;
    match type_name {
        "tooldata" => convert::tooldata(&value).map(|_| ()),
        _ => convert::wobjdata(&value).map(|_| ()),
    }
    .map_err(|(_, reason)| reason)?;
    Ok(value)
}

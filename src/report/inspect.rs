//! What a program's motions are, as far as its text tells, and which can be compensated.

use super::json::messages;
use super::message::LocatedDiagnostic;
use super::{Align, Table, counted, notes, rounded};
use rapid_program::Program;
use rapid_program::motion::{Motion, Origin, Target, TargetValue};
use rapid_syntax::diagnostic::first_few;
use robot_model::units::{deg_from_rad, mm_from_m};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::io::{self, Write};

/// A longer list is cut for people.
const SHORT: usize = 200;

/// Writes the summary and the list of motions for people.
///
/// # Errors
/// Those of writing to `out`.
pub fn write_inspection(out: &mut dyn Write, program: &Program, all: bool) -> io::Result<()> {
    write_modules(out, program)?;
    write_setups(out, program)?;
    write_verdict(out, program)?;
    let mut table = Table::new(&[
        ("line", Align::Left),
        ("routine", Align::Left),
        ("move", Align::Left),
        ("target", Align::Left),
        ("tool", Align::Left),
        ("work object", Align::Left),
        ("x, y, z mm or joints deg", Align::Left),
        ("kept because", Align::Left),
    ]);
    let several = program.files.len() > 1;
    let shown = if all { usize::MAX } else { SHORT };
    for motion in program.motions.iter().take(shown) {
        let line = if several {
            format!("{}:{}", program.file(motion.file).path, motion.line)
        } else {
            motion.line.to_string()
        };
        table.row([
            line,
            routine(program, motion).to_owned(),
            motion.setup.kind.to_string(),
            motion.targets.iter().map(spelling).collect::<Vec<_>>().join(" "),
            motion.setup.tool_name.as_deref().unwrap_or_default().to_owned(),
            motion.setup.wobj_name.as_deref().unwrap_or_default().to_owned(),
            motion.targets.last().and_then(|t| t.value()).map_or_else(String::new, |value| numbers(&value)),
            motion
                .skip_reason
                .as_ref()
                .map_or_else(String::new, |why| format!("{} ({})", why.reason, why.code)),
        ]);
    }
    table.write(out, "")?;
    if program.motions.len() > shown {
        writeln!(out, "... and {} more motions; --all shows every one", program.motions.len() - shown)?;
    }
    Ok(())
}

/// The modules with their files, and the routines that nobody calls.
fn write_modules(out: &mut dyn Write, program: &Program) -> io::Result<()> {
    for module in &program.facts.modules {
        writeln!(out, "module {} in {}", module.name, program.file(module.file).path)?;
    }
    for entry in &program.facts.entries {
        writeln!(out, "entry {} of {}", entry.name, entry.module)?;
    }
    Ok(())
}

/// How many motions have which move, tool and work object.
fn write_setups(out: &mut dyn Write, program: &Program) -> io::Result<()> {
    write_counts(out, "moves", program.motions.iter().map(|m| &*m.setup.kind))?;
    write_counts(out, "tools", program.motions.iter().filter_map(|m| m.setup.tool_name.as_deref()))?;
    write_counts(
        out,
        "work objects",
        program.motions.iter().map(|m| m.setup.wobj_name.as_deref().unwrap_or("wobj0")),
    )
}

/// What is said beside modules and motions, the verdict first.
fn in_sentences(program: &Program) -> Vec<String> {
    let mut text = Vec::new();
    // writing to memory cannot fail
    let _ = write_verdict(&mut text, program).and_then(|()| write_setups(&mut text, program));
    notes(&String::from_utf8_lossy(&text))
}

/// Modules that an earlier run has made, by their names.
fn compensated_modules(program: &Program) -> Vec<&str> {
    let made = program.facts.modules.iter().filter(|module| module.compensated.is_some());
    made.map(|module| module.name.as_str()).collect()
}

/// Whether all of them have their comment blocks, by which they are told else than by the names in them.
fn has_headers(program: &Program) -> bool {
    let mut made = program.facts.modules.iter().filter_map(|module| Some((module.file, module.compensated?)));
    made.all(|(file, range)| program.file(file).text(range).first() == Some(&b'!'))
}

/// How many motions can be compensated, and in which form; of a program that is corrected already, that it is.
fn write_verdict(out: &mut dyn Write, program: &Program) -> io::Result<()> {
    let motions = counted(program.motions.len(), "motion");
    let made = compensated_modules(program);
    if !made.is_empty() {
        let back = if has_headers(program) {
            "`driftpost restore` gets the original back"
        } else {
            "a comment block after MODULE is gone, without which `driftpost restore` cannot get the original back: take the original file"
        };
        return writeln!(
            out,
            "{motions}, already compensated in {}: compensate refuses it as it is\n  {back}\n",
            first_few(&made, 6),
        );
    }
    let kept = program.motions.iter().filter(|m| m.skip_reason.is_some()).count();
    writeln!(
        out,
        "{motions}, {} can be compensated as far as the text tells, {kept} cannot; form: {}\n  {}\n",
        program.motions.len() - kept,
        form(program).0,
        form(program).1
    )
}

/// Why a motion stays as it is: code and reason.
fn obstacle(motion: &Motion, is_made: bool) -> Option<(&'static str, &str)> {
    if is_made {
        return Some(("refuse::already-compensated", "the program is already compensated"));
    }
    motion.skip_reason.as_ref().map(|why| (why.code, why.reason.as_ref()))
}

/// Writes the list of motions as CSV.
///
/// # Errors
/// Those of writing to `out`.
pub fn write_inspection_csv(out: &mut dyn Write, program: &Program) -> io::Result<()> {
    let mut csv = csv::Writer::from_writer(out);
    csv.write_record([
        "file", "line", "routine", "index", "kind", "target", "tool", "wobj", "can", "code", "reason",
    ])?;
    let is_made = !compensated_modules(program).is_empty();
    for (index, motion) in program.motions.iter().enumerate() {
        let keep = obstacle(motion, is_made);
        csv.write_record([
            program.file(motion.file).path.as_str(),
            &motion.line.to_string(),
            routine(program, motion),
            &index.to_string(),
            &motion.setup.kind,
            &motion.targets.iter().map(spelling).collect::<Vec<_>>().join(" "),
            motion.setup.tool_name.as_deref().unwrap_or(""),
            motion.setup.wobj_name.as_deref().unwrap_or(""),
            if keep.is_none() { "compensate" } else { "keep" },
            keep.map_or("", |(code, _)| code),
            keep.map_or("", |(_, reason)| reason),
        ])?;
    }
    csv.flush()
}

/// The same for scripts.
#[must_use]
pub fn inspection(program: &Program, warnings: &[LocatedDiagnostic]) -> Value {
    let is_made = !compensated_modules(program).is_empty();
    let motions: Vec<Value> = program
        .motions
        .iter()
        .enumerate()
        .map(|(index, motion)| {
            let targets: Vec<Value> = motion.targets.iter().map(target).collect();
            let keep = obstacle(motion, is_made);
            json!({
                "file": program.file(motion.file).path,
                "line": motion.line,
                "routine": routine(program, motion),
                "index": index,
                "kind": motion.setup.kind,
                "targets": targets,
                "tool": motion.setup.tool_name.as_deref(),
                "wobj": motion.setup.wobj_name.as_deref(),
                "can": keep.is_none(),
                "code": keep.map(|(code, _)| code),
                "reason": keep.map(|(_, reason)| reason),
            })
        })
        .collect();
    let modules: Vec<Value> = program
        .facts
        .modules
        .iter()
        .map(|m| json!({"file": program.file(m.file).path, "name": m.name, "compensated": m.compensated.is_some()}))
        .collect();
    json!({
        "notes": in_sentences(program),
        "modules": modules,
        "entries": program.facts.entries.iter().map(|e| &e.name).collect::<Vec<_>>(),
        "entries_of": program.facts.entries.iter().map(|e| json!({"name": e.name, "module": e.module})).collect::<Vec<_>>(),
        "motions": motions,
        "form": form(program).0,
        "form_because": form(program).1,
        "warnings": messages(warnings),
    })
}

/// The form that suits, and why.
fn form(program: &Program) -> (&'static str, String) {
    /// Targets of which every bucket is still looked at in one file.
    const FEW: usize = 2000;
    let can = program.motions.iter().filter(|m| m.skip_reason.is_none());
    let targets: usize = can.map(|m| m.targets.len()).sum();
    let run_time = program.motions.iter().filter(|m| m.run_time).count();
    if run_time > 0 {
        return (
            "auto",
            format!("{run_time} of the motions have targets that only the running program knows"),
        );
    }
    if targets > FEW {
        return (
            "ramp",
            format!("arrays of {} are large, one correction each is not", counted(targets, "target")),
        );
    }
    (
        "schedule",
        format!(
            "arrays of {} are small, and every bucket is to be seen in one file",
            counted(targets, "target")
        ),
    )
}

fn routine<'p>(program: &'p Program, motion: &Motion) -> &'p str {
    program.routine_of(motion).map_or("", |r| &r.name)
}

fn spelling(target: &Target) -> String {
    match target.origin() {
        Origin::Named { name, .. } => name.clone(),
        Origin::Inline => "[...]".to_owned(),
        Origin::Expression(_) => "expression".to_owned(),
    }
}

fn target(target: &Target) -> Value {
    let name = match target.origin() {
        Origin::Named { name, .. } => Some(name),
        Origin::Inline | Origin::Expression(_) => None,
    };
    let (position_mm, joints_deg) = match &target.value() {
        Some(TargetValue::Rob(rob)) => (
            Some(
                rob.object_from_tcp
                    .translation
                    .vector
                    .iter()
                    .map(|m| rounded(mm_from_m(*m)))
                    .collect::<Vec<_>>(),
            ),
            None,
        ),
        Some(TargetValue::Joint(joint) | TargetValue::FromJoints(joint)) => {
            (None, Some(joint.q_rad.map(|q| q.map(|q| rounded(deg_from_rad(q))))))
        }
        None => (None, None),
    };
    json!({"name": name, "position_mm": position_mm, "joints_deg": joints_deg})
}

fn numbers(value: &TargetValue) -> String {
    let list = |numbers: &mut dyn Iterator<Item = String>| numbers.collect::<Vec<_>>().join(", ");
    match value {
        TargetValue::Rob(rob) => {
            list(&mut rob.object_from_tcp.translation.vector.iter().map(|m| format!("{:.3}", mm_from_m(*m))))
        }
        TargetValue::Joint(joint) | TargetValue::FromJoints(joint) => list(
            &mut joint
                .q_rad
                .iter()
                .map(|q| q.map_or_else(|| "9E9".to_owned(), |q| format!("{:.3}", deg_from_rad(q)))),
        ),
    }
}

fn write_counts<'a>(out: &mut dyn Write, what: &str, names: impl Iterator<Item = &'a str>) -> io::Result<()> {
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    for name in names {
        *counts.entry(name).or_default() += 1;
    }
    let list: Vec<String> = counts.iter().map(|(name, count)| format!("{name} {count}")).collect();
    writeln!(out, "{what}: {}", if list.is_empty() { "none".to_owned() } else { list.join(", ") })
}

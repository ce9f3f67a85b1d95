//! What an executed program did, as JSON, CSV and words.

use super::counted;
use robot_model::units::{deg_from_rad, mm_from_m};
use serde_json::{Value, json};
use std::io::{self, Write};
use virtual_controller::session::{ErrorStatistics, Pass, ScenarioMark, WorstMove};
use virtual_controller::{EffortRange, Message, Report};

fn statistics_json(s: &ErrorStatistics) -> Value {
    json!({ "max_mm": mm_from_m(s.max_m), "rms_mm": mm_from_m(s.rms_m), "max_deg": deg_from_rad(s.max_rad) })
}

fn worst_json(w: &WorstMove) -> Value {
    json!({ "t_min": w.t_min, "file": w.file, "line": w.line, "target": w.target, "mm": mm_from_m(w.error_m) })
}

fn message_json(m: &Message) -> Value {
    json!({ "source": m.source, "text": m.text, "file": m.at.file, "line": m.at.line })
}

fn mark_json(m: &ScenarioMark) -> Value {
    json!({ "from_min": m.from_min, "to_min": m.to_min, "standing": m.is_standing, "words": m.words })
}

/// What a function takes that motions call: each count as `[least, most]`.
fn effort_json(name: &str, e: &EffortRange) -> Value {
    json!({
        "name": name, "calls": e.calls,
        "statements": [e.fewest.statements, e.most.statements],
        "arithmetic": [e.fewest.arithmetic, e.most.arithmetic],
        "trigonometric": [e.fewest.trigonometric, e.most.trigonometric],
    })
}

/// What was found, as the JSON of the contract.
#[must_use]
pub fn json(report: &Report) -> Value {
    let pass = |p: &Pass| {
        json!({
            "t_min": p.t_min, "n": p.n, "before": statistics_json(&p.before), "after": statistics_json(&p.after),
            "corrected": statistics_json(&p.corrected), "path_after_mm": p.path_after_m.map(mm_from_m), "at_min": p.at_min, "index": p.index,
            "program_min": p.program_min, "unreached": p.unreached, "failure": p.failure,
            "mismatch": p.mismatch.as_ref().map(ToString::to_string),
        })
    };
    json!({
        "minutes": report.passes.iter().map(pass).collect::<Vec<_>>(),
        "marks": report.marks.iter().map(mark_json).collect::<Vec<_>>(),
        "worst": report.worst.as_ref().map(worst_json),
        "switches": report.switches.iter()
            .map(|s| json!({ "t_min": s.t_min, "jump_mm": mm_from_m(s.jump_m) })).collect::<Vec<_>>(),
        "unchanged": report.unchanged.iter()
            .map(|((file, line), m)| json!({ "file": file, "line": line, "mm": mm_from_m(*m) })).collect::<Vec<_>>(),
        "executed": { "motions": report.executed[0], "of": report.executed[1] },
        "unknown_instructions": report.unknown_instructions,
        "messages": report.messages.iter().map(message_json).collect::<Vec<_>>(),
        "messages_dropped": report.messages_dropped,
        "functions": report.efforts.iter().map(|(name, e)| effort_json(name, e)).collect::<Vec<_>>(),
    })
}

/// Pass by pass, as CSV.
///
/// # Errors
/// Those of the `csv` library.
pub fn csv(report: &Report) -> io::Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record([
        "t_min",
        "at_min",
        "n",
        "before_max_mm",
        "before_rms_mm",
        "before_max_deg",
        "after_max_mm",
        "after_rms_mm",
        "after_max_deg",
        "path_after_mm",
        "index",
        "program_min",
    ])?;
    let number = |x: Option<f64>| x.map_or_else(String::new, |x| x.to_string());
    for p in &report.passes {
        let mut record = vec![p.t_min.to_string(), p.at_min.to_string(), p.n.to_string()];
        for s in [&p.before, &p.after] {
            record.extend([mm_from_m(s.max_m), mm_from_m(s.rms_m)].map(|mm| format!("{mm:.7}")));
            record.push(format!("{:.8}", deg_from_rad(s.max_rad)));
        }
        record.push(number(p.path_after_m.map(mm_from_m)));
        record.extend([number(p.index), number(p.program_min)]);
        writer.write_record(record)?;
    }
    writer.into_inner().map_err(|error| error.into_error())
}

/// The passes in words; the last line says whether all stand within `tolerance_mm`.
///
/// # Errors
/// Those of writing to `to`.
pub fn write_summary(to: &mut dyn Write, report: &Report, tolerance_mm: f64, within: bool) -> io::Result<()> {
    let most = |of: fn(&Pass) -> f64| report.passes.iter().map(of).fold(0.0, f64::max);
    let (passes, moves) = (counted(report.passes.len(), "pass"), counted(report.judged(), "move"));
    let [executed, motions] = report.executed;
    let share = 100.0 * executed as f64 / motions.max(1) as f64;
    let motions = counted(motions, "motion");
    writeln!(to, "{passes}, {moves} executed: {executed} of the program's {motions} ({share:.0} %)")?;
    if report.judged() == 0 {
        return write_nothing(to, report);
    }
    writeln!(
        to,
        "before: up to {:.4} mm and {:.4} deg; after: up to {:.4} mm and {:.4} deg; way up to {:.4} mm",
        mm_from_m(most(|p| p.before.max_m)),
        deg_from_rad(most(|p| p.before.max_rad)),
        mm_from_m(most(|p| p.after.max_m)),
        deg_from_rad(most(|p| p.after.max_rad)),
        mm_from_m(most(|p| p.path_after_m.unwrap_or(0.0))),
    )?;
    if let Some(w) = &report.worst {
        let (mm, when) = (mm_from_m(w.error_m), minute(w.t_min));
        let when = if w.t_min.is_finite() { format!("at warm-up {when}") } else { when };
        writeln!(to, "worst: {}:{} {} {mm:.4} mm {when}", w.file, w.line, w.target)?;
    }
    if !report.switches.is_empty() {
        let jump = report.switches.iter().map(|s| s.jump_m).fold(0.0, f64::max);
        let changes = counted(report.switches.len(), "change");
        writeln!(to, "{changes} of bucket, jump up to {:.4} mm", mm_from_m(jump))?;
    }
    for ((file, line), error_m) in report.unchanged.iter().take(20) {
        writeln!(to, "{file}:{line} is as in the original, off by up to {:.4} mm", mm_from_m(*error_m))?;
    }
    write_trouble(to, report)?;
    let verdict = if within { "within" } else { "NOT within" };
    writeln!(to, "{verdict} {tolerance_mm} mm of what was meant")
}

/// When, on the way from cold to fully warm, which is at no minute.
fn minute(t_min: f64) -> String {
    if t_min.is_finite() { format!("minute {t_min:.1}") } else { "fully warm".to_owned() }
}

/// What went wrong, what is not known, what the controller showed.
fn write_trouble(to: &mut dyn Write, report: &Report) -> io::Result<()> {
    for p in &report.passes {
        let mismatch = p.mismatch.as_ref().map(ToString::to_string);
        for why in p.failure.iter().chain(&mismatch) {
            writeln!(to, "{}: {why}", minute(p.t_min))?;
        }
        if p.unreached > 0 {
            let moves = counted(p.unreached, "move");
            let verb = if p.unreached == 1 { "is" } else { "are" };
            writeln!(to, "{}: {moves} {verb} not made", minute(p.t_min))?;
        }
    }
    if !report.unknown_instructions.is_empty() {
        writeln!(to, "not known and passed over: {}", report.unknown_instructions.join(", "))?;
    }
    for m in report.messages.iter().take(20) {
        writeln!(to, "{} ({}:{}): {}", m.source, m.at.file, m.at.line, m.text)?;
    }
    let unseen = report.messages.len().saturating_sub(20) + report.messages_dropped;
    if unseen > 0 {
        writeln!(to, "... and {} more", counted(unseen, "message"))?;
    }
    Ok(())
}

/// The words for a program of which no move could be compared with the original's.
fn write_nothing(to: &mut dyn Write, report: &Report) -> io::Result<()> {
    write_trouble(to, report)?;
    writeln!(to, "NOTHING was judged: no move was executed that the original makes too")
}

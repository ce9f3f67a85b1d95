//! The JSON that scripts rely on; its keys and units are part of the contract, more may be added.

use super::message::LocatedDiagnostic;
use super::motion_rows::target_name;
use rapid_compensation::compensate::plan::{Plan, PlannedMotion, Status};
use rapid_program::Program;
use rapid_program::motion::{Motion, MotionId, SkipReason};
use rapid_syntax::diagnostic::Severity;
use robot_model::units::{deg_from_rad, mm_from_m};
use serde::ser::{Serialize, SerializeMap, Serializer};
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::io::{self, Write};
use std::sync::Arc;

/// A number as JSON shows it: nine decimals at most, so that 0.1 + 0.2 is 0.3.
#[must_use]
pub fn rounded(value: f64) -> f64 {
    const PARTS: f64 = 1e9;
    let rounded = (value * PARTS).round() / PARTS;
    if rounded == 0.0 { 0.0 } else { rounded }
}

/// An object of the contract as a value: what is written of it has texts as keys, so that there is one.
#[must_use]
pub fn value(object: &impl Serialize) -> Value {
    serde_json::to_value(object).unwrap_or_default()
}

/// An object of the contract as its file holds it, with a line end.
///
/// # Errors
/// Those of writing to `out`.
pub fn write_pretty(out: &mut dyn Write, object: &impl Serialize) -> io::Result<()> {
    serde_json::to_writer_pretty(&mut *out, object)?;
    out.write_all(b"\n")
}

/// What `compensate` found and did.
///
/// Is made row by row while it is written: a program may have many motions.
pub struct CompensationJson<'a> {
    /// The program as it was read.
    pub program: &'a Program,
    /// What becomes of its motions.
    pub plan: &'a Plan,
    /// What there is to be said of both.
    pub messages: &'a [LocatedDiagnostic],
    /// The motions that have a row, by their index; `None` = all.
    pub shown: Option<&'a BTreeSet<MotionId>>,
    /// Rows leave out what is null, as on a page that holds many.
    pub without_nulls: bool,
}

impl Serialize for CompensationJson<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self { plan, messages, .. } = self;
        let Plan { schedule, temperature_c, summary: s, .. } = plan;
        let mm = |m: f64| rounded(mm_from_m(m));
        let buckets: Vec<Value> = schedule
            .buckets
            .iter()
            .enumerate()
            .map(|(index, b)| {
                json!({
                    "index": index,
                    "from_min": rounded(b.from_min),
                    "to_min": b.to_min.map(rounded),
                    "at_min": rounded(b.at_min),
                    "from_c": temperature_c.map(|[low_c, _]| rounded(low_c + b.from_min)),
                })
            })
            .collect();
        let others: Vec<Value> = s
            .other_tolerances
            .iter()
            .map(|(tolerance_m, buckets)| json!({"tolerance_mm": mm(*tolerance_m), "buckets": buckets}))
            .collect();
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("motions", &Motions(self))?;
        map.serialize_entry("buckets", &buckets)?;
        map.serialize_entry("worst_before_mm", &mm(s.worst_before_m))?;
        map.serialize_entry("worst_after_mm", &mm(s.worst_after_m))?;
        map.serialize_entry("worst_switch_jump_mm", &mm(s.worst_switch_jump_m))?;
        map.serialize_entry("rigid_shift_worst_mm", &mm(s.rigid_shift_worst_m))?;
        map.serialize_entry("until_min", &rounded(s.until_min))?;
        map.serialize_entry("other_tolerances", &others)?;
        map.serialize_entry("warnings", &of_severity(messages, |s| s != Severity::Error))?;
        map.serialize_entry("errors", &of_severity(messages, |s| s == Severity::Error))?;
        map.end()
    }
}

/// Its rows of motions.
struct Motions<'m>(&'m CompensationJson<'m>);

impl Serialize for Motions<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let CompensationJson { program, plan, shown, .. } = self.0;
        let rows = program.motions.iter().zip(&plan.motions).enumerate();
        let rows = rows.filter(|(i, _)| shown.is_none_or(|shown| shown.contains(&MotionId::new(*i))));
        serializer.collect_seq(rows.map(|(i, (motion, planned))| {
            let mut row = planned_row(program, i, motion, planned);
            if let Value::Object(keys) = &mut row
                && self.0.without_nulls
            {
                keys.retain(|_, value| !value.is_null());
            }
            row
        }))
    }
}

fn planned_row(program: &Program, index: usize, motion: &Motion, planned: &PlannedMotion) -> Value {
    let mm = |m: f64| rounded(mm_from_m(m));
    let (status, why) = match &planned.status {
        Status::Compensated => ("compensated", None),
        Status::Kept(why) => ("kept", Some(&**why)),
        Status::Refused(why) => ("refused", Some(&**why)),
    };
    let correction = [mm(planned.max_correction_m), rounded(deg_from_rad(planned.max_correction_rad))];
    let form = (planned.status == Status::Compensated).then(|| planned.form.name());
    let mut row =
        motion_row(program, index, motion, (status, why), correction, planned.mid_path.metres().map(mm));
    row["form"] = json!(form);
    let error_mm = planned.error_m.map(|error_m| error_m.map(mm));
    row["before_mm"] = json!(error_mm.map(|[before, _]| before));
    row["after_mm"] = json!(error_mm.map(|[_, after]| after));
    row
}

/// A row of `motions`; `correction` in mm and deg.
fn motion_row(
    program: &Program,
    index: usize,
    motion: &Motion,
    (status, why): (&str, Option<&SkipReason>),
    [correction_mm, correction_deg]: [f64; 2],
    mid_path_mm: Option<f64>,
) -> Value {
    json!({
        "file": program.file(motion.file).path,
        "line": motion.line,
        "routine": program.routine_of(motion).map(|r| &r.name),
        "index": index,
        "kind": motion.setup.kind,
        "target": target_name(motion),
        "status": status,
        "form": null,
        "reason": why.map(|w| &w.reason),
        "code": why.map(|w| w.code),
        "max_correction_mm": correction_mm,
        "max_correction_deg": correction_deg,
        "mid_path_mm": mid_path_mm,
        "before_mm": null,
        "after_mm": null,
    })
}

/// The same keys for a program for which there is no plan; `kept` says why each motion is kept, where all
/// are.
#[must_use]
pub fn refusal(program: &Program, kept: &[Arc<SkipReason>], list: &[LocatedDiagnostic]) -> Value {
    let row = |(index, (motion, why)): (usize, (&Motion, &Arc<SkipReason>))| {
        motion_row(program, index, motion, ("kept", Some(why)), [0.0; 2], None)
    };
    json!({
        "motions": program.motions.iter().zip(kept).enumerate().map(row).collect::<Vec<_>>(),
        "buckets": [],
        "worst_before_mm": null,
        "worst_after_mm": null,
        "worst_switch_jump_mm": null,
        "rigid_shift_worst_mm": null,
        "until_min": null,
        "other_tolerances": [],
        "warnings": of_severity(list, |s| s != Severity::Error),
        "errors": of_severity(list, |s| s == Severity::Error),
    })
}

/// Messages as `{"code","file","line","message","help"}`; `file` and `line` are null where a message is
/// about the whole run.
#[must_use]
pub fn messages(list: &[LocatedDiagnostic]) -> Value {
    of_severity(list, |_| true)
}

fn of_severity(list: &[LocatedDiagnostic], is: fn(Severity) -> bool) -> Value {
    let one = |located: &LocatedDiagnostic| {
        let message = &located.diagnostic;
        json!({
            "code": message.code,
            "file": located.place().map(|(path, _)| path),
            "line": located.place().map(|(_, line)| line),
            "message": message.message,
            "help": message.help,
        })
    };
    list.iter().filter(|located| is(located.diagnostic.severity)).map(one).collect()
}

/// Which cases of a folder came out as expected, by the path of each, with a line end; `is_updated`: what comes out is what is
/// expected from now on.
#[must_use]
#[cfg(feature = "cli")]
pub fn golden_json(cases: &[(String, Vec<String>)], is_updated: bool) -> String {
    let list: Vec<Value> = cases
        .iter()
        .map(|(case, files)| json!({"case": case, "same": files.is_empty(), "different_files": files}))
        .collect();
    format!("{:#}\n", json!({"cases": list, "updated": is_updated}))
}

#[cfg(test)]
mod tests {
    use super::*;
    use rapid_syntax::diagnostic::Diagnostic;

    #[test]
    fn numbers_are_rounded_and_never_minus_zero() {
        assert_eq!(rounded(0.1 + 0.2), 0.3);
        assert_eq!(rounded(-1e-12).to_string(), "0");
    }

    #[test]
    fn a_message_without_a_place_has_null_for_it() {
        let list = [Diagnostic::warning("a::b", "w"), Diagnostic::error("c::d", "e").help("h")];
        let list = LocatedDiagnostic::all(list, &[]);
        let value = refusal(&Program::default(), &[], &list);
        assert_eq!(
            value["warnings"][0],
            json!({"code":"a::b","file":null,"line":null,"message":"w","help":null})
        );
        assert_eq!(value["errors"][0]["help"], "h");
    }
}

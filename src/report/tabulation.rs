//! Joints of a list of targets at every minute of warm-up, as CSV, for people and as JSON.

use super::joints::{JointRow, JointTable};
use super::{counted, notes};
use rapid_compensation::compensate::tabulate::{MinuteErrors, MinuteTable, TargetErrors};
use rapid_compensation::compensate::targets::NamedPose;
use robot_model::kinematics::Solution;
use robot_model::units::{deg_from_rad, mm_from_m};
use serde_json::{Value, json};
use std::io::{self, Write};

/// A row for each target and minute; `file` is that of the targets.
///
/// # Errors
/// Those of writing to `out`.
pub fn write_joints(
    out: &mut dyn Write,
    file: &str,
    targets: &[NamedPose],
    table: &MinuteTable,
) -> io::Result<()> {
    let mut written = JointTable::new(out)?;
    for row in &table.rows {
        let Some(target) = targets.get(row.target) else { continue };
        written.add(JointRow {
            target: target.name.as_str().into(),
            file,
            line: target.line,
            t_min: row.t_min,
            q_rad: row.q_rad,
            position_m: row.position_m,
            residual_m: row.residual_m,
        })?;
    }
    written.finish()
}

/// How much there is, and the worst of all minutes, for people.
#[must_use]
pub fn text(targets: &[NamedPose], table: &MinuteTable, errors: &[MinuteErrors]) -> String {
    let [targets, minutes, rows] =
        [(targets.len(), "target"), (errors.len(), "minute"), (table.rows.len(), "row")]
            .map(|(n, noun)| counted(n, noun));
    let mut text = format!("{targets} x {minutes} = {rows}\n");
    let worst = |of: fn(&MinuteErrors) -> &TargetErrors| {
        errors.iter().max_by(|a, b| of(a).max_m.total_cmp(&of(b).max_m))
    };
    if let Some(worst) = worst(|minute| &minute.before) {
        let TargetErrors { max_m, rms_m, max_rad } = worst.before;
        text += &format!(
            "before: missed by up to {:.3} mm (rms {:.3} mm) and {:.3} deg, at minute {}\n",
            mm_from_m(max_m),
            mm_from_m(rms_m),
            deg_from_rad(max_rad),
            worst.t_min
        );
    }
    if let Some(worst) = worst(|minute| &minute.after) {
        let TargetErrors { max_m, max_rad, .. } = worst.after;
        let (mm, deg) = (mm_from_m(max_m), deg_from_rad(max_rad));
        text += &format!("after: missed by up to {mm:.1e} mm and {deg:.1e} deg\n");
    }
    text
}

/// The result as the contract's JSON.
#[must_use]
pub fn json(targets: &[NamedPose], table: &MinuteTable, errors: &[MinuteErrors]) -> Value {
    let all_targets = |of: &TargetErrors| json!({ "max_mm": mm_from_m(of.max_m), "rms_mm": mm_from_m(of.rms_m), "max_deg": deg_from_rad(of.max_rad) });
    let minute = |minute: &MinuteErrors| {
        json!({
            "t_min": minute.t_min, "n": targets.len(), "before": all_targets(&minute.before), "after": all_targets(&minute.after),
        })
    };
    let target = |(target, nominal): (&NamedPose, &Solution)| {
        let c = nominal.configuration;
        json!({
            "target": target.name, "line": target.line, "q_deg": nominal.q_rad.map(deg_from_rad),
            "confdata": [c.cf1, c.cf4, c.cf6, c.cfx],
        })
    };
    json!({
        "notes": notes(&text(targets, table, errors)),
        "rows": table.rows.len(),
        "targets": targets.iter().zip(&table.nominal).map(target).collect::<Vec<_>>(),
        "minutes": errors.iter().map(minute).collect::<Vec<_>>(),
    })
}

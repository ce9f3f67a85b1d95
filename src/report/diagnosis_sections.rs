//! Sections of a diagnosis for people: the noise, the causes, what was set aside, what cannot be told. Computes nothing.

use super::cause_rows::{number, percent, rows};
use metrology::diagnose::{FalseRow, Findings, Verdict, describe};
use robot_model::deform::EffectKind;
use robot_model::robot::Axis;
use robot_model::units::deg_from_rad;

/// More causes than this are counted, not listed: a gear has dozens of lines.
const MOST_LISTED: usize = 12;
/// More false rows than this are counted.
const MOST_FALSE: usize = 12;

pub(super) fn noise(page: &mut String, d: &Findings) {
    let Some(model) = d.noise.model_sigma_mm else { return };
    match d.noise.repeats_sigma_mm {
        Some(known) => {
            let source = if d.noise.repeats_freedom == 0 { "as stated" } else { "in repeats" };
            line(
                page,
                &format!(
                    "Noise of one coordinate: {known:.4} mm {source}, {model:.4} mm about the best model."
                ),
            );
        }
        None => line(
            page,
            &format!(
                "Noise of one coordinate: {model:.4} mm about the best model. Nothing was repeated, so this cannot be checked."
            ),
        ),
    }
    if let Some(shared) = d.noise.shared_sigma_mm {
        line(
            page,
            &format!(
                "The targets of a pose share {shared:.4} mm of it: where the arm stood. A pose tells once, however many targets it has."
            ),
        );
    }
}

/// Rows to look at again, the furthest first.
pub(super) fn false_rows(page: &mut String, d: &Findings) {
    if d.false_rows.is_empty() {
        return;
    }
    line(page, "");
    line(page, "Set aside as false readings");
    let mut rows: Vec<&FalseRow> = d.false_rows.iter().collect();
    // A row that disagrees with its repeats has no distance from the model: it comes first.
    let off = |row: &FalseRow| row.off_mm.unwrap_or(f64::INFINITY);
    sorting::by(&mut rows, |a, b| off(b).total_cmp(&off(a)).then(a.line.cmp(&b.line)));
    for row in rows.iter().take(MOST_FALSE) {
        let name = row.id.as_ref().map_or_else(String::new, |id| format!(" (id {id})"));
        let off = match (row.off_mm, row.times_middle) {
            (Some(off_mm), Some(times)) => {
                format!(", {off_mm:.3} mm off the model, {times:.0} times the middle row")
            }
            _ => String::new(),
        };
        let like = row.looks_like.as_ref().map_or_else(String::new, |like| format!("; {like}"));
        line(page, &format!("  line {}{name}{off}{like}", row.line));
    }
    if rows.len() > MOST_FALSE {
        line(page, &format!("  and {} more, nearer: see the JSON", rows.len() - MOST_FALSE));
    }
}

/// First of all, of an arm that was never calibrated.
pub(super) fn zeros(page: &mut String, d: &Findings) {
    let Some(zeros) = &d.zeros_alone else { return };
    let all: Vec<String> = zeros
        .joints
        .iter()
        .map(|zero| format!("joint {} {:+.3} deg", zero.joint, deg_from_rad(zero.offset_rad)))
        .collect();
    let named = d.causes.iter().any(|cause| cause.effect == EffectKind::JointOffset);
    let apart = if named { "" } else { "; beside geometry as wide as this arm's they are not told from it" };
    let (before, after) = (zeros.before_rms_mm, zeros.after_rms_mm);
    let all = all.join(", ");
    line(
        page,
        &format!("  joint offsets alone would take the gap from {before:.3} to {after:.3} mm: {all}{apart}"),
    );
}

pub(super) fn evidence(page: &mut String, d: &Findings) {
    if d.causes.is_empty() {
        return;
    }
    let named = d.verdict.names_causes() || d.verdict == Verdict::DataFault;
    line(page, "");
    // Under the other verdicts the odds that a candidate is right are even at best, and each probability is halved.
    let title = match d.verdict {
        _ if named => "What it is",
        Verdict::UnexplainedStructure | Verdict::UnexplainedScatter => {
            "Nearest candidates, none of them the answer (so none is likelier than 50 %)"
        }
        _ => "Nearest candidates, none of them the answer",
    };
    line(page, title);
    zeros(page, d);
    let rows = rows(&d.causes, named, d.shrink.before_rms_mm);
    for row in rows.iter().take(MOST_LISTED) {
        line(page, &format!("  {row}"));
    }
    if rows.len() > MOST_LISTED {
        line(page, &format!("  and {} more: see the JSON", rows.len() - MOST_LISTED));
    }
    let wanting: Vec<String> = d
        .alternatives
        .iter()
        .take(4)
        .map(|c| format!("{} ({})", describe(c), percent(c.posterior)))
        .collect();
    if !wanting.is_empty() && named {
        line(page, "");
        line(page, "What it is not");
        line(page, &format!("  {}", wanting.join("; ")));
    }
}

pub(super) fn limits(page: &mut String, d: &Findings) {
    if d.untestable_detail.is_empty() {
        return;
    }
    line(page, "");
    line(page, "What these data cannot tell");
    for entry in &d.untestable_detail {
        let joints: Vec<String> = entry.joints.iter().map(Axis::to_string).collect();
        let of = if joints.is_empty() {
            String::new()
        } else {
            let what = if entry.effect.is_of_link() { "link" } else { "joint" };
            let many = if joints.len() > 1 { "s" } else { "" };
            format!(" of {what}{many} {}", joints.join(", "))
        };
        line(page, &format!("  {}{of}: {}", entry.effect, entry.reason));
    }
    if d.verdict == Verdict::NothingAboveNoise && !d.detectable.is_empty() {
        line(page, "");
        line(page, "What would have been seen, from this size on");
        for seen in &d.detectable {
            let of = seen.joint.map_or_else(String::new, |j| format!(" {j}"));
            line(page, &format!("  {}{of}: {} {}", seen.effect, number(seen.size), seen.unit));
        }
    }
}

/// Adds a line to the page.
pub(super) fn line(page: &mut String, text: &str) {
    page.push_str(text);
    page.push('\n');
}

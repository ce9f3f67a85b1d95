//! A diagnosis as a page for people, and its residuals as CSV. Computes nothing.

use super::cause_rows::plainly;
use super::diagnosis_sections::{evidence, false_rows, limits, line, noise, zeros};
use super::{counted, notes};
use measurements::{OwnNames, direction_columns};
use metrology::diagnose::{
    Findings, Headline, LeadingCandidate, MissingChannel, NextAction, PosesFor, Verdict, describe,
};
use robot_model::robot::SerialArm;

/// A difference under this is not worth a line.
const WORTH_A_LINE_MM: f64 = 5e-4;
/// The page in the terminal; `names` are what the file calls its columns, which the findings' own texts have already.
#[must_use]
pub fn text(d: &Findings, arm: &SerialArm, names: &OwnNames) -> String {
    let mut page = opening(d, arm, names);
    evidence(&mut page, d);
    false_rows(&mut page, d);
    limits(&mut page, d);
    gain(&mut page, d);
    next(&mut page, d, arm);
    page
}

/// What the text says beside its lists, sentence by sentence.
#[must_use]
pub fn in_sentences(d: &Findings, arm: &SerialArm, names: &OwnNames) -> Vec<String> {
    let mut page = opening(d, arm, names);
    zeros(&mut page, d);
    notes(&page)
}

/// The verdict, what is left, what to do next, and how good the data are.
fn opening(d: &Findings, arm: &SerialArm, names: &OwnNames) -> String {
    let robot = &arm.name;
    let mut page = String::new();
    if let Some(summary) = summary(d) {
        line(&mut page, &summary);
    }
    line(&mut page, &format!("{}: {}{}.", heading(d.verdict), d.reason, in_short_plainly(d)));
    left(&mut page, d);
    line(&mut page, &format!("Next: {}.", next_step(d, arm, names)));
    line(&mut page, "");
    line(&mut page, &format!("{robot}, {}, {}.", counted(d.rows, "row"), counted(d.stations, "station")));
    noise(&mut page, d);
    page
}

/// A first line where the verdict's own does not say where most of the gap lies.
pub(super) fn summary(d: &Findings) -> Option<String> {
    Some(match d.headline()? {
        Headline::MostlyExplained { share, leading } => {
            let leading: Vec<String> = leading.iter().map(leading_in_words).collect();
            let by = match leading.is_empty() {
                true => "small errors of all joints' geometry and the nearest candidates together".to_owned(),
                false => format!("likeliest in it {}", leading.join(", ")),
            };
            format!("Mostly explained: the model takes {:.0} % of the gap's square; {by}.", 100.0 * share)
        }
        Headline::MostlyGeometry { share } => {
            let share = match 100.0 * share {
                most if most >= 99.5 => "nearly all".to_owned(),
                share => format!("{share:.0} %"),
            };
            let causes = match d.causes.len() {
                1 => "the cause below is there, but",
                _ => "the causes below are there, but",
            };
            format!(
                "Mostly geometry: small errors of all joints' geometry take {share} of the gap's square; {causes} small beside them."
            )
        }
    })
}

fn leading_in_words(candidate: &LeadingCandidate<'_>) -> String {
    let what = if candidate.is_taken_back { "of the gap" } else { "beside base and target" };
    format!("{} ({:.3} mm {what})", describe(candidate.cause), candidate.in_gap_mm)
}

/// What is left, in one line.
fn left(page: &mut String, d: &Findings) {
    let s = &d.shrink;
    if let (Some(before), Some(after), Some(floor)) = (s.before_rms_mm, s.after_rms_mm, s.floor_rms_mm) {
        let causes = s.causes_only_rms_mm.filter(|_| d.verdict.names_causes());
        let causes =
            causes.map_or_else(String::new, |causes| format!(", {causes:.3} mm with the named causes alone"));
        line(
            page,
            &format!(
                "Gap: {before:.3} mm, {after:.3} mm with the model on poses held out{causes}, of which noise {floor:.3} mm (rms, 3-D)."
            ),
        );
    }
}

/// How many rows where, what they decide, and what else can tell.
fn poses_below(d: &Findings, names: &OwnNames) -> String {
    let step = &d.next_step;
    let other = step.other_means.as_deref();
    let n = d.next_measurements.len();
    if n == 0 {
        return other.map_or_else(String::new, |other| format!("further poses cannot tell; {other}"));
    }
    let times = match step.readings_per_pose {
        0 | 1 => String::new(),
        times => format!(" {times} times each ({} rows)", step.rows),
    };
    let cold = if step.from_cold { ", on a new warm-up from a cold start" } else { "" };
    let nests = match step.base_nests {
        0 => String::new(),
        n => names.rename(&format!(
            ", and at each of them {n} nests on the base, as far from its axis as can be (rows with kind = base, their fixed_id and the arm's joints and payload)"
        )),
    };
    let decides = match d.verdict {
        Verdict::Ambiguous if step.decides => ": that is expected to decide",
        Verdict::Ambiguous => ": that may not be enough",
        _ => "",
    };
    let other = match other {
        Some(other) if d.verdict == Verdict::Ambiguous => format!("; or {other}"),
        _ => String::new(),
    };
    format!("measure the {n} poses below{times}{cold}{nests}, {}{decides}{other}", step.reason)
}

/// What to do with this verdict.
pub(super) fn next_step(d: &Findings, arm: &SerialArm, names: &OwnNames) -> String {
    let poses = d.proposes_poses().then(|| poses_below(d, names));
    let and = |first: &str, poses_are_for: &str| match &poses {
        Some(poses) => format!("{first}; {poses_are_for}{poses}"),
        None => first.to_owned(),
    };
    match d.next_action() {
        NextAction::NoteChannel(channel) => names.rename(&note(channel, arm)),
        NextAction::UseModel(poses_are_for) => {
            let poses_are_for = match poses_are_for {
                PosesFor::Surer => "to be surer ",
                PosesFor::More => "to see more ",
                PosesFor::Rest => "for what is left ",
            };
            and(&use_model(d, arm), poses_are_for)
        }
        NextAction::NoteDirections => names.rename(&format!(
            "measure again with the directions of approach ({}): play follows them, a spring does not",
            direction_columns(arm.joints.len())
        )),
        NextAction::CorrectFile => "correct the file or measure again; nothing can be said before".to_owned(),
        NextAction::Nothing => and("nothing to correct", ""),
        NextAction::NoteMissingColumns if poses.is_some() => {
            and("measure again with the columns that are missing (below)", "")
        }
        NextAction::NoteMissingColumns => {
            "measure more poses, with the columns that are missing (below)".to_owned()
        }
        NextAction::MeasurePoses => poses.unwrap_or_else(|| "measure more poses".to_owned()),
    }
}

/// What to do with the model, or why there is none.
fn use_model(d: &Findings, arm: &SerialArm) -> String {
    match &d.no_model {
        Some(why) => format!("no model can be written: {why}"),
        None if arm.clone().six_axis().is_ok() => {
            "write the model (--model-out), validate it on other poses, compensate with it".to_owned()
        }
        None => "write the model (--model-out), validate it on other poses".to_owned(),
    }
}

/// What to note, where one column would tell what the gap follows.
fn note(channel: MissingChannel, arm: &SerialArm) -> String {
    match channel {
        MissingChannel::Direction => {
            format!(
                "measure again and note from which side each joint came ({}), some poses from both sides",
                direction_columns(arm.joints.len())
            )
        }
        MissingChannel::Payload => {
            "note what hung at the tool at each row (payload_kg), here if it is known, or measure again with it"
                .to_owned()
        }
        MissingChannel::Time => {
            "note when each row was measured (t_min), here if it is known, or measure again with it".to_owned()
        }
    }
}

/// What the one cause means, in brackets.
fn in_short_plainly(d: &Findings) -> String {
    match d.causes.first() {
        Some(cause) if d.verdict == Verdict::Explained => format!(" ({})", plainly(cause.effect)),
        _ => String::new(),
    }
}

fn heading(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Explained => "Explained",
        Verdict::Ambiguous => "Ambiguous",
        Verdict::Several => "Several causes",
        Verdict::Geometry => "Geometry",
        Verdict::UnexplainedStructure => "Unexplained structure",
        Verdict::UnexplainedScatter => "Unexplained scatter",
        Verdict::NothingAboveNoise => "Nothing above the noise",
        Verdict::InsufficientData => "Not enough data",
        Verdict::DataFault => "The data are faulty",
    }
}

fn gain(page: &mut String, d: &Findings) {
    let s = &d.shrink;
    let (Some(before), Some(after), Some(floor)) = (s.before_rms_mm, s.after_rms_mm, s.floor_rms_mm) else {
        return;
    };
    line(page, "");
    line(page, "How much better the robot gets, on poses held out");
    line(
        page,
        &format!("  {before:.3} mm before, {after:.3} mm with the model, {floor:.3} mm is noise (rms, 3-D)"),
    );
    if let (Some(ratio), Some([low, high])) = (s.ratio, s.ci90) {
        line(
            page,
            &format!(
                "  {} {:.0} % of what it is, between {:.0} % and {:.0} % nine times in ten",
                if ratio < 1.0 { "to" } else { "no better: to" },
                100.0 * ratio,
                100.0 * low,
                100.0 * high
            ),
        );
    }
    if let Some(causes) = s
        .causes_only_rms_mm
        .filter(|causes| d.verdict.names_causes() && (causes - after).abs() > WORTH_A_LINE_MM)
    {
        line(
            page,
            &format!("  {causes:.3} mm with the causes alone, without small geometry errors of all joints"),
        );
    }
    for (name, block) in
        [("last part of the time", &s.time_block), ("region of the workspace", &s.region_block)]
    {
        if let Some(b) = block {
            line(
                page,
                &format!(
                    "  a {name} held out whole: {:.3} mm before, {:.3} mm after",
                    b.before_rms_mm, b.after_rms_mm
                ),
            );
        }
    }
}

fn next(page: &mut String, d: &Findings, arm: &SerialArm) {
    if d.next_measurements.is_empty() {
        return;
    }
    line(page, "");
    line(page, "What to measure next");
    let joints = d.next_measurements.first().map_or(0, |pose| pose.q_deg.len());
    line(page, &format!("  approach: the way in which joints 1 to {joints} turned last, + or -"));
    let slides = arm.joints.iter().any(|joint| joint.kind.slides());
    let unit = if slides { "deg or, where a joint slides, mm" } else { "deg" };
    for pose in &d.next_measurements {
        let joints: Vec<String> = pose.q_deg.iter().map(|q| format!("{q:7.1}")).collect();
        let signs: Vec<&str> = pose.dir.iter().map(|d| if *d < 0 { "-" } else { "+" }).collect();
        line(
            page,
            &format!("  q {} {unit}, {} kg, approach {}", joints.join(" "), pose.payload_kg, signs.join("")),
        );
    }
}

/// Residuals of every row, mm in the robot's base.
#[must_use]
pub fn residuals_csv(d: &Findings) -> String {
    let mut text =
        "line,id,before_x_mm,before_y_mm,before_z_mm,after_x_mm,after_y_mm,after_z_mm,false\n".to_owned();
    for row in &d.residuals {
        let id = row.id.as_deref().unwrap_or_default();
        let id = if id.contains([',', '"', '\n']) {
            format!("\"{}\"", id.replace('"', "\"\""))
        } else {
            id.to_owned()
        };
        let numbers: Vec<String> =
            row.before_mm.iter().chain(&row.after_mm).map(|v| format!("{v:.5}")).collect();
        line(&mut text, &format!("{},{id},{},{}", row.line, numbers.join(","), u8::from(row.outlier)));
    }
    text
}

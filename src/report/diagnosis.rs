//! A diagnosis as a page for people, and its residuals as CSV. Computes nothing.

use super::cause_rows::plainly;
use super::diagnosis_sections::{evidence, false_rows, limits, line, noise, zeros};
use super::{counted, notes};
use measurements::{OwnNames, direction_columns};
use metrology::diagnose::{Cause, Findings, MissingChannel, Verdict, describe};
use robot_model::deform::EffectKind;
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

/// A model that takes this share of the gap's square explains most of it, whatever the verdict says of the rest.
const MOST: f64 = 0.9;
/// A candidate that is named as what explains it.
const LIKELY_CANDIDATE: f64 = 0.4;

/// The share of the gap's square that the model takes, where that is most of it although the verdict is that something is not
/// explained.
fn share_explained(d: &Findings) -> Option<f64> {
    let unexplained = matches!(d.verdict, Verdict::UnexplainedStructure | Verdict::UnexplainedScatter);
    let share = 1.0 - d.shrink.ratio?.powi(2);
    (unexplained && share >= MOST).then_some(share)
}

/// A first line where the verdict's own does not say where most of the gap lies.
pub(super) fn summary(d: &Findings) -> Option<String> {
    mostly_explained(d).or_else(|| mostly_geometry(d))
}

/// Most of the gap is taken by the geometry behind the named causes: they are there, and are not what it is made of.
fn mostly_geometry(d: &Findings) -> Option<String> {
    let s = &d.shrink;
    let (before, after) = (s.before_rms_mm?, s.after_rms_mm?);
    let causes = s.causes_only_rms_mm.filter(|_| d.verdict.names_causes())?;
    let taken = |left: f64| 1.0 - (left / before).powi(2);
    let geometry = taken(after) - taken(causes).max(0.0);
    (taken(after) >= 0.5 && geometry > taken(causes)).then(|| {
        let what = if d.causes.len() == 1 { "the cause below is there, but" } else { "the causes below are there, but" };
        let share = match 100.0 * geometry {
            most if most >= 99.5 => "nearly all".to_owned(),
            share => format!("{share:.0} %"),
        };
        format!("Mostly geometry: small errors of all joints' geometry take {share} of the gap's square; {what} small beside them.")
    })
}

/// What is explained although the verdict is that something is not: the model's share, and the candidates that lead in it by
/// what they move the tool by beside base and target, or, where others take that back, by what of the gap rests on them.
fn mostly_explained(d: &Findings) -> Option<String> {
    let percent = 100.0 * share_explained(d)?;
    // A candidate's probability is at most one half under these verdicts.
    let mut likely: Vec<&Cause> = d.causes.iter().filter(|c| c.posterior >= LIKELY_CANDIDATE).collect();
    let gap_mm = d.shrink.before_rms_mm.unwrap_or(f64::INFINITY);
    // What others take back is no part of the gap.
    let is_taken_back = |cause: &Cause| cause.seen_mm() > gap_mm;
    let in_gap_mm = |cause: &Cause| if is_taken_back(cause) { cause.of_gap_mm() } else { cause.seen_mm() };
    sorting::by(&mut likely, |a, b| in_gap_mm(b).total_cmp(&in_gap_mm(a)));
    let leading: Vec<String> = likely
        .iter()
        .take(3)
        .map(|cause| {
            let what = if is_taken_back(cause) { "of the gap" } else { "beside base and target" };
            format!("{} ({:.3} mm {what})", describe(cause), in_gap_mm(cause))
        })
        .collect();
    let by = match leading.is_empty() {
        true => "small errors of all joints' geometry and the nearest candidates together".to_owned(),
        false => format!("likeliest in it {}", leading.join(", ")),
    };
    Some(format!("Mostly explained: the model takes {percent:.0} % of the gap's square; {by}."))
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
    if let Some(channel) = d.missing_channel {
        return names.rename(&note(channel, arm));
    }
    let poses = poses_below(d, names);
    let write = match &d.no_model {
        Some(why) => format!("no model can be written: {why}"),
        None if arm.clone().six_axis().is_ok() => {
            "write the model (--model-out), validate it on other poses, compensate with it".to_owned()
        }
        None => "write the model (--model-out), validate it on other poses".to_owned(),
    };
    match d.verdict {
        Verdict::Explained | Verdict::Several if poses.is_empty() => write,
        Verdict::Explained | Verdict::Several => format!("{write}; to be surer {poses}"),
        Verdict::Ambiguous if play_or_spring(d) => names.rename(&format!(
            "measure again with the directions of approach ({}): play follows them, a spring does not",
            direction_columns(arm.joints.len())
        )),
        Verdict::DataFault => "correct the file or measure again; nothing can be said before".to_owned(),
        Verdict::NothingAboveNoise if poses.is_empty() => "nothing to correct".to_owned(),
        Verdict::NothingAboveNoise => format!("nothing to correct; {poses}"),
        Verdict::Geometry if d.shrink.ratio.is_some_and(|ratio| ratio < 1.0) && d.no_model.is_none() => {
            format!("{write}; to see more {poses}")
        }
        _ if share_explained(d).is_some() && d.no_model.is_none() => match poses.is_empty() {
            true => write,
            false => format!("{write}; for what is left {poses}"),
        },
        Verdict::UnexplainedScatter if !poses.is_empty() && misses_a_channel(d) => {
            format!("measure again with the columns that are missing (below); {poses}")
        }
        _ if poses.is_empty() && misses_a_channel(d) => {
            "measure more poses, with the columns that are missing (below)".to_owned()
        }
        _ if poses.is_empty() => "measure more poses".to_owned(),
        _ => poses,
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

/// Whether an effect cannot be tested at all, for the file lacks what drives it.
fn misses_a_channel(d: &Findings) -> bool {
    d.untestable_detail.iter().any(|entry| entry.lacks_channel)
}

/// Whether play is named in a file that has no directions.
fn play_or_spring(d: &Findings) -> bool {
    d.causes.iter().any(|c| c.effect == EffectKind::Backlash)
        && d.untestable_detail.iter().any(|u| u.effect == EffectKind::Backlash && u.lacks_channel)
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

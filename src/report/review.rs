//! The review: what an integrator checks before a corrected program runs.

use super::motion_rows::{MotionRows, mm};
use super::{Align, Table, counted, rounded};
use rapid_compensation::compensate::plan::{Summary, Totals};
use rapid_compensation::schedule::{Course, Schedule, TimeFunctions};
use robot_model::units::mm_from_m;
use std::io::{self, Write};

/// What a reviewer is shown.
#[derive(Clone, Copy, Debug)]
pub struct Review<'a> {
    /// When which bucket is in use; without buckets where `functions` are.
    pub schedule: &'a Schedule,
    /// What scales the corrections of the forms `ramp` and `live`.
    pub functions: Option<&'a TimeFunctions>,
    /// For a deformation by temperature its range, degrees Celsius, as in [`Plan`](rapid_compensation::compensate::plan::Plan).
    pub temperature_c: Option<[f64; 2]>,
    /// Figures over the whole program.
    pub summary: &'a Summary,
    /// How many motions there are, and what becomes of them.
    pub totals: &'a Totals,
    /// The motions to be shown.
    pub rows: &'a MotionRows,
    /// What was asked for and with what, each with its name: robot, deformation, files and their SHA-256.
    pub provenance: &'a [(&'static str, String)],
}

/// Writes what it was made with, the buckets, the motions and what they come to; the verdict follows.
///
/// # Errors
/// Those of writing to `out`.
pub fn write_review(out: &mut dyn Write, review: &Review<'_>) -> io::Result<()> {
    write_provenance(out, review)?;
    write_buckets(out, review)?;
    review.rows.write(out)?;
    write_figures(out, review)
}

/// Writes what a reviewer reads first: how many motions, and how far they are off before and after; of those that are
/// kept how many run time could correct. Two or three lines.
///
/// # Errors
/// Those of writing to `out`.
pub fn write_verdict(out: &mut dyn Write, review: &Review<'_>) -> io::Result<()> {
    let (s, totals) = (review.summary, review.totals);
    let held = match review.functions {
        None => counted(review.schedule.buckets.len(), "bucket"),
        Some(_) => {
            let [_, ramp, live] = totals.by_form;
            format!("{ramp} by their scaled correction, {live} by the model at run time")
        }
    };
    writeln!(
        out,
        "{}: {} compensated, {} kept, {} refused; {held}",
        counted(totals.motions, "motion"),
        totals.compensated,
        totals.kept,
        totals.refused,
    )?;
    if s.kept_for_run_time > 0 {
        writeln!(out, "{}", auto_corrects(s.kept_for_run_time, totals.kept))?;
    }
    if !has_known_targets(review) {
        return writeln!(
            out,
            "no target is known before the program runs, so no TCP error is worked out here; `driftpost simulate` executes the program"
        );
    }
    let known = if totals.by_form[2] > 0 { " whose targets are known" } else { "" };
    let after = match review.functions {
        None => format!("{} mm", mm(s.worst_after_m)),
        Some(_) => format!("{:.6} mm", mm_from_m(s.worst_after_m)),
    };
    let rounding = if review.functions.is_some() { ", the controller's rounding apart" } else { "" };
    writeln!(
        out,
        "worst TCP error of the compensated motions{known} over all minutes: {} mm before, {after} after{rounding}",
        mm(s.worst_before_m)
    )
}

/// That run time could correct so many `of` the motions that are kept, and how.
#[must_use]
pub(crate) fn auto_corrects(count: usize, of: usize) -> String {
    let which = match (count == of, count) {
        (true, 1) => "the one kept goes".to_owned(),
        (true, _) => format!("all {count} kept go"),
        (false, 1) => "1 of those kept goes".to_owned(),
        (false, _) => format!("{count} of those kept go"),
    };
    format!(
        "{which} to what only the running program knows: --form auto corrects {}",
        if count == 1 { "it" } else { "them" }
    )
}

/// Whether there is a compensated motion whose target is known, so that figures say something.
fn has_known_targets(review: &Review<'_>) -> bool {
    // One that asks the model is known too where its drift was worked out.
    review.totals.by_form[2] < review.totals.compensated || review.summary.worst_before_m > 0.0
}

fn write_provenance(out: &mut dyn Write, review: &Review<'_>) -> io::Result<()> {
    let width = review.provenance.iter().map(|(name, _)| name.len()).max().unwrap_or(0);
    for (name, value) in review.provenance {
        writeln!(out, "{name:width$}  {value}")?;
    }
    writeln!(out)
}

fn write_figures(out: &mut dyn Write, review: &Review<'_>) -> io::Result<()> {
    let s = review.summary;
    let rigid = mm(s.rigid_shift_worst_m);
    match review.functions {
        None => {
            writeln!(out, "one work-object shift per bucket instead would leave {rigid} mm")?;
            let jump = mm(s.worst_switch_jump_m);
            writeln!(out, "largest step of the TCP from one bucket to the next: {jump} mm")?;
        }
        Some(functions) => {
            if has_known_targets(review) {
                writeln!(out, "one scaled work-object shift instead would leave {rigid} mm")?;
            }
            writeln!(out, "corrections are scaled by {}", scale(functions))?;
        }
    }
    let others: Vec<String> = s
        .other_tolerances
        .iter()
        .map(|(tolerance_m, buckets)| format!("{} mm {buckets}", mm_from_m(*tolerance_m)))
        .collect();
    if !others.is_empty() {
        writeln!(out, "buckets that other tolerances would take: {}", others.join(", "))?;
    }
    writeln!(out)
}

/// What corrections are scaled by.
fn scale(functions: &TimeFunctions) -> String {
    match (&functions.course, functions.count()) {
        (Course::Share, _) => "the share of the drift that has come".to_owned(),
        (Course::ShareSquared, _) => "the share of the drift that has come and its square".to_owned(),
        (Course::FromCold, _) => {
            "the share of the drift that has come, from what the cold arm is off".to_owned()
        }
        (Course::FromColdSquared, _) => {
            "the share of the drift that has come and its square, from what the cold arm is off".to_owned()
        }
        (Course::Knots { at_min, .. }, 1) => {
            format!("one function of time, straight between {} knots", at_min.len())
        }
        (Course::Knots { at_min, .. }, n) => {
            format!("{n} functions of time, straight between {} knots", at_min.len())
        }
    }
}

fn write_buckets(out: &mut dyn Write, review: &Review<'_>) -> io::Result<()> {
    if review.schedule.buckets.is_empty() {
        return Ok(());
    }
    let by_temperature = review.temperature_c.is_some();
    let zero = review.temperature_c.map_or(0.0, |[low_c, _]| low_c);
    let mut table = Table::new(&[
        ("bucket", Align::Right),
        (if by_temperature { "from deg C" } else { "from min" }, Align::Right),
        (if by_temperature { "to deg C" } else { "to min" }, Align::Right),
        ("right at", Align::Right),
        ("before mm", Align::Right),
        ("after mm", Align::Right),
    ]);
    for (index, bucket) in review.schedule.buckets.iter().enumerate() {
        let worst = |side: usize| {
            review.summary.bucket_error_m.get(index).map_or_else(String::new, |error_m| mm(error_m[side]))
        };
        table.row([
            index.to_string(),
            minutes(zero + bucket.from_min),
            bucket.to_min.map_or_else(|| "on".to_owned(), |to_min| minutes(zero + to_min)),
            format!("{:.2}", zero + bucket.at_min),
            worst(0),
            worst(1),
        ]);
    }
    table.write(out, "")?;
    writeln!(out)
}

/// Minutes or degrees as a person writes them: 7 or 7.5.
fn minutes(t: f64) -> String {
    rounded(t).to_string()
}

//! The table of motions: what an integrator checks before a corrected program runs.

use super::{Align, Table, rounded};
use crate::compensate::plan::{Plan, PlannedMotion, Status};
use crate::program::Program;
use crate::program::motion::{Motion, Origin};
use crate::units::{deg_from_rad, mm_from_m};
use std::io::{self, Write};

/// A program of more motions is shown by its worst ones.
const SHORT: usize = 60;
/// So many of them.
const WORST: usize = 20;

/// What is reviewed.
#[derive(Clone, Copy, Debug)]
pub struct Review<'a> {
    /// The program.
    pub program: &'a Program,
    /// What becomes of it.
    pub plan: &'a Plan,
    /// What was asked for and with what, each with its name: robot, deformation, files and their SHA-256.
    pub provenance: &'a [(&'static str, String)],
    /// Show every motion.
    pub all: bool,
}

/// Writes the summary, the buckets and the motions.
///
/// # Errors
/// Those of `out`.
pub fn write_review(out: &mut dyn Write, review: &Review<'_>) -> io::Result<()> {
    write_provenance(out, review)?;
    write_summary(out, review.plan)?;
    write_buckets(out, review.plan)?;
    write_motions(out, review)
}

fn write_provenance(out: &mut dyn Write, review: &Review<'_>) -> io::Result<()> {
    let width = review.provenance.iter().map(|(name, _)| name.len()).max().unwrap_or(0);
    for (name, value) in review.provenance {
        writeln!(out, "{name:width$}  {value}")?;
    }
    writeln!(out)
}

fn write_summary(out: &mut dyn Write, plan: &Plan) -> io::Result<()> {
    let count = |is: fn(&Status) -> bool| plan.motions.iter().filter(|m| is(&m.status)).count();
    let s = &plan.summary;
    writeln!(
        out,
        "{} motions: {} compensated, {} kept, {} refused; {} buckets",
        plan.motions.len(),
        count(|s| *s == Status::Compensated),
        count(|s| matches!(s, Status::Kept(_))),
        count(|s| matches!(s, Status::Refused(_))),
        plan.schedule.buckets.len()
    )?;
    writeln!(out, "worst TCP error of the compensated motions over all minutes:")?;
    writeln!(out, "  {:>9} mm before", mm(s.worst_before_m))?;
    writeln!(out, "  {:>9} mm after", mm(s.worst_after_m))?;
    writeln!(out, "  {:>9} mm with one work-object shift per bucket instead", mm(s.rigid_shift_worst_m))?;
    writeln!(out, "largest step of the TCP from one bucket to the next: {} mm", mm(s.worst_switch_jump_m))?;
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

fn write_buckets(out: &mut dyn Write, plan: &Plan) -> io::Result<()> {
    let by_temperature = plan.temperature_c.is_some();
    let zero = plan.temperature_c.map_or(0.0, |[low_c, _]| low_c);
    let mut table = Table::new(&[
        ("bucket", Align::Right),
        (if by_temperature { "from deg C" } else { "from min" }, Align::Right),
        (if by_temperature { "to deg C" } else { "to min" }, Align::Right),
        ("right at", Align::Right),
        ("before mm", Align::Right),
        ("after mm", Align::Right),
    ]);
    for (index, bucket) in plan.schedule.buckets.iter().enumerate() {
        let worst = |side: usize| {
            plan.summary.bucket_error_m.get(index).map_or_else(String::new, |error_m| mm(error_m[side]))
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

fn write_motions(out: &mut dyn Write, review: &Review<'_>) -> io::Result<()> {
    let pairs: Vec<(&Motion, &PlannedMotion)> =
        review.program.motions.iter().zip(&review.plan.motions).collect();
    let cut = !review.all && pairs.len() > SHORT;
    let mut shown: Vec<usize> = (0..pairs.len()).collect();
    if cut {
        let size = |i: usize| pairs[i].1.max_correction_m;
        shown.sort_by(|a, b| size(*b).total_cmp(&size(*a)).then(a.cmp(b)));
        shown.truncate(WORST);
    }
    let several = review.program.files.len() > 1;
    let mut table = Table::new(&[
        ("line", Align::Left),
        ("routine", Align::Left),
        ("move", Align::Left),
        ("target", Align::Left),
        ("correction mm", Align::Right),
        ("deg", Align::Right),
        ("mid-path mm", Align::Right),
        ("before mm", Align::Right),
        ("after mm", Align::Right),
        ("", Align::Left),
    ]);
    for (motion, planned) in shown.iter().map(|i| pairs[*i]) {
        let file = &review.program.file(motion.file).path;
        let worst = |side: usize| planned.error_m.map_or_else(String::new, |error_m| mm(error_m[side]));
        let figures = planned.status == Status::Compensated || !planned.targets.is_empty();
        let figure = |text: String| if figures { text } else { String::new() };
        table.row([
            if several { format!("{file}:{}", motion.line) } else { motion.line.to_string() },
            review.program.routines.get(motion.routine).map_or_else(String::new, |r| r.name.clone()),
            motion.kind.to_owned(),
            target_name(motion).unwrap_or_default().to_owned(),
            figure(mm(planned.max_correction_m)),
            figure(format!("{:.5}", deg_from_rad(planned.max_correction_rad))),
            planned.mid_path_m.map_or_else(String::new, mm),
            worst(0),
            worst(1),
            match &planned.status {
                Status::Compensated => String::new(),
                Status::Kept(why) => format!("kept: {}", why.code),
                Status::Refused(why) => format!("refused: {}", why.code),
            },
        ]);
    }
    if cut {
        writeln!(out, "the {WORST} motions that are corrected most:")?;
    }
    table.write(out, "")?;
    if cut {
        writeln!(out, "... and {} more motions; --all shows every one", pairs.len() - WORST)?;
    }
    writeln!(out)
}

/// The name of a motion's end point, where it is written as a name.
pub(super) fn target_name(motion: &Motion) -> Option<&str> {
    match &motion.targets.last()?.origin {
        Origin::Named { name, .. } => Some(name),
        Origin::Inline | Origin::Expression => None,
    }
}

fn mm(length_m: f64) -> String {
    format!("{:.4}", mm_from_m(length_m))
}

/// Minutes or degrees as a person writes them: 7 or 7.5.
fn minutes(t: f64) -> String {
    rounded(t).to_string()
}

//! A measurement plan for people and as JSON.

use super::notes;
use super::table::{Align, Table};
use metrology::plan::{Confounded, EffectName, GearLines, MeasurementPlan, MeasurementStep, Parameter};
use robot_model::deform::EffectKind;
use robot_model::robot::SerialArm;
use serde_json::{Value, json};
use std::io::{self, Write};

/// Confounded pairs that are shown.
const SHOWN: usize = 6;
/// Joints of an effect that are not told at its usual size and are shown.
const SHOWN_WEAK: usize = 4;
/// Confounded lines that are shown of a joint.
const SHOWN_LINES: usize = 3;

/// For people.
///
/// # Errors
/// Those of writing to `out`.
pub fn write(out: &mut dyn Write, plan: &MeasurementPlan, robot: &str) -> io::Result<()> {
    opening(out, plan, robot)?;
    writeln!(out, "\nExpected, each effect being the only cause beside the arm's tolerances")?;
    expected(out, &plan.outlook.parameters)?;
    lines(out, &plan.outlook.lines)?;
    never_seen(out, plan)?;
    let open = open_pairs(plan);
    if open == 0 {
        writeln!(out, "\n{}", all_apart(plan))?;
    } else {
        writeln!(
            out,
            "\nPairs that stay confounded at usual size: true one, taken for, share of its signal that is taken"
        )?;
    }
    for Confounded { a, b, r2, .. } in plan.outlook.confounded.iter().take(open.min(SHOWN)) {
        writeln!(out, "  {}, {}: {:.1} %", name(a), name(b), 100.0 * r2)?;
    }
    let more = open.saturating_sub(SHOWN);
    if more > 0 {
        writeln!(out, "  and {more} more (--json)")?;
    }
    pairs_beside(out, plan)
}

/// What is said where no pair stays confounded: an effect that is never seen is told apart from none.
fn all_apart(plan: &MeasurementPlan) -> &'static str {
    match plan.outlook.hidden.is_empty() {
        true => "Every pair of effects of usual size will be told apart",
        false => {
            "Every pair of the effects that are seen at their usual size will be told apart; those never seen are told from nothing"
        }
    }
}

/// How much is to be measured, and how it was chosen.
fn opening(out: &mut dyn Write, plan: &MeasurementPlan, robot: &str) -> io::Result<()> {
    let poses: Vec<usize> = plan
        .steps
        .iter()
        .filter_map(|s| if let MeasurementStep::Pose { pose, .. } = s { Some(*pose) } else { None })
        .collect();
    let distinct = poses.iter().collect::<std::collections::BTreeSet<_>>().len();
    writeln!(
        out,
        "{robot}: {} measurements of {distinct} poses, {} of nests; chosen from {} by {} exchanges",
        poses.len(),
        plan.steps.len() - poses.len(),
        plan.pool,
        plan.exchanges
    )
}

/// Effects that these poses never show at their usual size.
fn never_seen(out: &mut dyn Write, plan: &MeasurementPlan) -> io::Result<()> {
    let hidden: Vec<String> = plan.outlook.hidden.iter().map(name).collect();
    if !hidden.is_empty() {
        writeln!(
            out,
            "\nNever seen at their usual size, inside base, target and the arm's tolerances: {}",
            hidden.join(", ")
        )?;
    }
    Ok(())
}

/// Pairs that stay confounded and have to be told apart otherwise.
fn open_pairs(plan: &MeasurementPlan) -> usize {
    plan.outlook.confounded.iter().filter(|pair| !pair.contained).count()
}

/// Pairs of which the simpler is named anyway.
fn pairs_beside(out: &mut dyn Write, plan: &MeasurementPlan) -> io::Result<()> {
    let contained = plan.outlook.confounded.len() - open_pairs(plan);
    if contained > 0 {
        writeln!(
            out,
            "{contained} pairs beside, where the second has more parameters and contains the first: the simpler is named"
        )?;
    }
    Ok(())
}

/// One line for each effect: its joints from the best told to the worst.
fn expected(out: &mut dyn Write, parameters: &[Parameter]) -> io::Result<()> {
    let mut table = Table::new(&[
        ("effect", Align::Left),
        ("of", Align::Right),
        ("usual", Align::Right),
        ("named from, best", Align::Left),
        ("named from, worst", Align::Left),
        ("unit", Align::Left),
        ("not at its usual size", Align::Left),
    ]);
    let mut effects: Vec<EffectKind> = Vec::new();
    for p in parameters {
        if !effects.contains(&p.of.effect) {
            effects.push(p.of.effect);
        }
    }
    for effect in effects {
        let mut own: Vec<&Parameter> = parameters.iter().filter(|p| p.of.effect == effect).collect();
        sorting::by(&mut own, |a, b| (a.seen_from / a.usual).total_cmp(&(b.seen_from / b.usual)));
        let (Some(best), Some(worst)) = (own.first(), own.last()) else { continue };
        let from = |p: &Parameter| match joints(&p.of) {
            joints if joints.is_empty() => format!("{:.1e}", p.seen_from),
            joints => format!("{:.1e} ({joints})", p.seen_from),
        };
        let weak = own.iter().filter(|p| p.seen_from > p.usual);
        let weak: Vec<String> = weak
            .clone()
            .take(SHOWN_WEAK)
            .map(|p| joints(&p.of))
            .chain((weak.count() > SHOWN_WEAK).then(|| "...".to_owned()))
            .collect();
        table.row([
            effect.to_string(),
            own.len().to_string(),
            format!("{:.1e}", best.usual),
            from(best),
            if own.len() > 1 { from(worst) } else { String::new() },
            best.unit.to_string(),
            weak.join(", "),
        ]);
    }
    table.write(out, "  ")?;
    writeln!(out, "  usual: of the joint that is told best; every joint's numbers are in --json")
}

/// Gear lines, joint by joint.
fn lines(out: &mut dyn Write, lines: &[GearLines]) -> io::Result<()> {
    let Some(first) = lines.first() else { return Ok(()) };
    writeln!(out, "\nLines of the gears, 3 to 320 per turn; usual size {:.0e} rad", first.usual)?;
    let mut table = Table::new(&[
        ("joint", Align::Left),
        ("sigma", Align::Right),
        ("named from", Align::Right),
        ("told from all others", Align::Right),
        ("most easily taken for another", Align::Left),
    ]);
    for l in lines {
        let pairs: Vec<String> =
            l.confounded.iter().take(SHOWN_LINES).map(|[n, other]| format!("{n} for {other}")).collect();
        let numbers = [l.sigma, l.seen_from].map(|v| format!("{v:.2e}"));
        let [sigma, from] = numbers;
        let joints_apart = format!("{} of {}", l.told_apart, l.of);
        table.row([l.joint.to_string(), sigma, from, joints_apart, pairs.join(", ")]);
    }
    table.write(out, "  ")
}

fn name(of: &EffectName) -> String {
    format!("{} {}", of.effect, joints(of)).trim_end().to_owned()
}

fn joints(of: &EffectName) -> String {
    match (of.joint, of.joint_b) {
        (Some(j), Some(b)) => format!("{j} to {b}"),
        (Some(j), None) => j.to_string(),
        _ => String::new(),
    }
}

/// What the plan says beside its tables.
fn in_sentences(plan: &MeasurementPlan, robot: &str) -> io::Result<Vec<String>> {
    let mut text = Vec::new();
    opening(&mut text, plan, robot)?;
    match open_pairs(plan) {
        0 => writeln!(text, "{}", all_apart(plan))?,
        n => writeln!(text, "{n} pairs of effects stay confounded at usual size")?,
    }
    pairs_beside(&mut text, plan)?;
    never_seen(&mut text, plan)?;
    Ok(notes(&String::from_utf8_lossy(&text)))
}

/// The plan as the contract's JSON.
#[must_use]
pub fn json(plan: &MeasurementPlan, robot: &SerialArm) -> Value {
    let steps: Vec<Value> = plan
        .steps
        .iter()
        .enumerate()
        .map(|(k, step)| match step {
            MeasurementStep::Nest { nest } => json!({ "id": k + 1, "nest": nest + 1 }),
            MeasurementStep::Pose { pose, q_rad, direction, payload_kg, .. } => json!({
                "id": k + 1, "pose_id": pose + 1, "q_deg": robot.in_deg_or_mm(q_rad), "dir": direction, "payload_kg": payload_kg,
            }),
        })
        .collect();
    json!({
        "notes": in_sentences(plan, &robot.name).unwrap_or_default(), "steps": steps, "parameters": plan.outlook.parameters, "confounded": plan.outlook.confounded,
        "hidden": plan.outlook.hidden, "lines": plan.outlook.lines, "exchanges": plan.exchanges,
    })
}

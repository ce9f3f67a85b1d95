//! A fitted warm-up for people, as table and as JSON.

use super::{counted, notes};
use nalgebra::Vector3;
use robot_model::deform::Deformation;
use robot_model::robot::Axis;
use robot_model::units::{deg_from_rad, mm_from_m};
use serde_json::{Value, json};
use std::fmt::Write as _;
use warm_up::TipCheck;
use warm_up::{PARAMETERS, TargetForecast, WarmUp};

const NAMES: [&str; 6] = ["dx", "dy", "dz", "rx", "ry", "rz"];
/// A parameter of which the touches tell less than this stands at its prior.
const TOLD: f64 = 0.2;

fn unit(i: usize) -> (&'static str, fn(f64) -> f64) {
    if i % 6 < 3 { ("mm", mm_from_m) } else { ("deg", deg_from_rad) }
}

/// The fit as text.
#[must_use]
pub fn text(w: &WarmUp, tip: Option<&TipCheck>, there: Option<&TargetForecast>) -> String {
    let mut out = opening(w, tip);
    out.push_str("\nHow far each point moves when settled (its own touches), mm\n");
    for point in &w.points {
        let [x, y, z] = [point.settled_m.x, point.settled_m.y, point.settled_m.z].map(mm_from_m);
        let _ = writeln!(out, "  {:12} {x:8.4} {y:8.4} {z:8.4}", point.name);
    }
    out.push_str("\nWhat these points can tell of the settled deformation\n");
    for i in (0..PARAMETERS).filter(|&i| w.share_from_data(i) >= TOLD) {
        let (unit, of) = unit(i);
        let _ = writeln!(
            out,
            "  joint {} {} {:9.5} +- {:.5} {unit}, {:.0} % told",
            i / 6 + 1,
            NAMES[i % 6],
            of(w.settled[i]),
            of(w.sigma(i)),
            100.0 * w.share_from_data(i)
        );
    }
    out.push_str(&closing(w, there));
    out
}

/// How it grows, when it stood, and what speaks against the touches.
fn opening(w: &WarmUp, tip: Option<&TipCheck>) -> String {
    let mut out = String::new();
    let _ = writeln!(
        out,
        "{} of {}, minutes {:.0} to {:.0}; noise of one coordinate {:.4} mm",
        counted(w.touches, "touch"),
        counted(w.points.len(), "point"),
        w.span_min[0],
        w.span_min[1],
        mm_from_m(w.sigma_m)
    );
    for stop in &w.stops {
        let by_pause =
            if w.stops_are_named { "" } else { ", by the pause between touches (--stop FROM:TO says when)" };
        let _ =
            writeln!(out, "the robot stood from minute {:.0} to {:.0}{by_pause}", stop.from_min, stop.to_min);
    }
    let tau = w.growth.tau_min().unwrap_or(0.0);
    let law = w.growth.to_string();
    let law = law.split(':').next().unwrap_or_default();
    let _ = writeln!(
        out,
        "growth {law}, tau {tau:.1} +- {:.1} min (the other law has {:.1} %)",
        w.tau_sigma_min,
        100.0 * w.other_law
    );
    let _ = match w.tau_cool_min {
        Some([cool, sigma]) => writeln!(out, "cooling tau {cool:.1} +- {sigma:.1} min"),
        None if !w.stops.is_empty() => {
            writeln!(out, "all points moved in the stop: how fast it cools is not known")
        }
        None => writeln!(out, "no stop: how fast it cools is not known"),
    };
    for moved in &w.moved {
        let _ = writeln!(
            out,
            "all points moved together between minutes {:.0} and {:.0}, by {:.3} mm: touches from then on count from there",
            moved.between_min[0],
            moved.between_min[1],
            mm_from_m(moved.shift_m)
        );
    }
    false_touches(&mut out, w);
    if let Some(tip) = tip {
        out.push_str(tip_is_told(tip));
    }
    out
}

/// What the touches do not tell, and what that means at the targets.
fn closing(w: &WarmUp, there: Option<&TargetForecast>) -> String {
    let mut out = String::new();
    let silent = (0..PARAMETERS).filter(|&i| w.share_from_data(i) < TOLD).count();
    let _ = writeln!(out, "  {silent} of {PARAMETERS} parameters are told less than {:.0} %", 100.0 * TOLD);
    if let Some(there) = there {
        forecast_at_targets(&mut out, there);
    }
    out
}

/// How far the touches check the tip's place.
fn tip_is_told(tip: &TipCheck) -> &'static str {
    match tip.directions {
        3 => "the tip's place (--tool) is checked: points are touched in orientations that differ\n",
        0 => {
            "the tip's place (--tool) is not checked: each point is touched in one orientation, in which any tip goes with the touches\n"
        }
        _ => {
            "the tip's place (--tool) is checked in part: the orientations in which a point is touched hardly differ\n"
        }
    }
}

fn false_touches(out: &mut String, w: &WarmUp) {
    for counts in [false, true] {
        let all = w.residuals.iter().filter(|one| one.looks_false && one.counts == counts);
        let lines: Vec<String> = all.map(|one| one.line.to_string()).collect();
        if lines.is_empty() {
            continue;
        }
        let some = counted(lines.len(), "touch");
        let (verb, word) = if lines.len() == 1 { ("looks", "line") } else { ("look", "lines") };
        let what = match (counts, lines.len()) {
            (true, 1) => {
                "it counts, as it is no accident of a single touch: does the arm drift as this law says, is the tip's place right?"
            }
            (true, _) => {
                "they count, as they are no accidents of single touches: does the arm drift as this law says, is the tip's place right?"
            }
            (false, 1) => "it is set aside",
            (false, _) => "they are set aside",
        };
        let _ = writeln!(
            out,
            "{some} {verb} false, further off than noise takes one: {word} {}; {what}",
            lines.join(", ")
        );
    }
}

fn forecast_at_targets(out: &mut String, there: &TargetForecast) {
    let _ = writeln!(out, "\nAt {} targets, settled, rms in space", there.targets.len());
    let share = |m: f64| 100.0 * m / there.drift_rms_m.max(1e-12);
    for (what, rms_m) in [
        ("without correction", there.drift_rms_m),
        ("one shift of the work object would leave", there.shift_left_rms_m),
        ("this table is expected to leave", there.left_rms_m),
    ] {
        let _ = writeln!(out, "  {what:42} {:.4} mm, {:.0} %", mm_from_m(rms_m), share(rms_m));
    }
    let worst = there.targets.iter().max_by(|a, b| a.sigma_m.norm().total_cmp(&b.sigma_m.norm()));
    if let Some(worst) = worst {
        let _ =
            writeln!(out, "  least is known at {}: +- {:.4} mm", worst.name, mm_from_m(worst.sigma_m.norm()));
    }
    if let Some(next) = &there.next {
        let [x, y, z] = [next.at_m.x, next.at_m.y, next.at_m.z].map(mm_from_m);
        let q: Vec<String> = next.q_rad.iter().map(|q| format!("{:.1}", deg_from_rad(*q))).collect();
        let _ = writeln!(
            out,
            "  the next point helps most near {x:.0}, {y:.0}, {z:.0} mm, joints {} deg: {:.4} mm are then left",
            q.join(", "),
            mm_from_m(next.rms_m)
        );
    }
}

/// For scripts: mm, degrees, minutes.
#[must_use]
pub fn json(w: &WarmUp, tip: Option<&TipCheck>, there: Option<&TargetForecast>) -> Value {
    let mm = |v: &Vector3<f64>| [v.x, v.y, v.z].map(mm_from_m);
    let parameters: Vec<Value> = (0..PARAMETERS)
        .map(|i| {
            let (unit, of) = unit(i);
            json!({
                "joint": i / 6 + 1, "parameter": NAMES[i % 6], "unit": unit, "value": of(w.settled[i]),
                "sigma": of(w.sigma(i)), "told": w.share_from_data(i),
            })
        })
        .collect();
    json!({
        "notes": notes(&(opening(w, tip) + &closing(w, there))), "touches": w.touches, "growth": w.growth.to_string(), "tau_sigma_min": w.tau_sigma_min, "other_law": w.other_law,
        "tau_cool_min": w.tau_cool_min.map(|c| c[0]), "tau_cool_sigma_min": w.tau_cool_min.map(|c| c[1]),
        "stops": w.stops.iter().map(|s| [s.from_min, s.to_min]).collect::<Vec<_>>(),
        "sigma_mm": mm_from_m(w.sigma_m),
        "tip": tip.map(|tip| json!({
            "directions": tip.directions, "apart_mm": mm(&tip.apart_m), "sigma_mm": mm_from_m(tip.sigma_m),
        })),
        "prior_mm": mm_from_m(w.prior[0]), "prior_deg": deg_from_rad(w.prior[1]),
        "points": w.points.iter().map(|p| json!({ "point": p.name, "settled_mm": mm(&p.settled_m) })).collect::<Vec<_>>(),
        "knocked": w.knocked.iter().map(|p| json!({
            "point": p.name, "from_min": p.between_min[0], "to_min": p.between_min[1], "step_mm": mm(&p.step_m),
        })).collect::<Vec<_>>(),
        "moved": w.moved.iter().map(|one| json!({
            "from_min": one.between_min[0], "to_min": one.between_min[1], "body": one.body.name(),
            "shift_mm": mm_from_m(one.shift_m), "turn_deg": deg_from_rad(one.turn_rad),
        })).collect::<Vec<_>>(),
        "parameters": parameters,
        "residuals": w.residuals.iter().map(|one| json!({
            "line": one.line, "point": one.point, "t_min": one.t_min, "before_mm": mm(&one.before_m), "after_mm": mm(&one.after_m),
            "looks_false": one.looks_false, "counts": one.counts,
        })).collect::<Vec<_>>(),
        "targets": there.map(|t| json!({
            "drift_rms_mm": mm_from_m(t.drift_rms_m), "left_rms_mm": mm_from_m(t.left_rms_m),
            "shift_left_rms_mm": mm_from_m(t.shift_left_rms_m),
            "each": t.targets.iter().map(|one| json!({
                "target": one.name, "drift_mm": mm(&one.drift_m), "sigma_mm": mm(&one.sigma_m),
            })).collect::<Vec<_>>(),
            "next": t.next.as_ref().map(|n| json!({
                "q_deg": n.q_rad.map(deg_from_rad), "at_mm": mm(&n.at_m), "left_rms_mm": mm_from_m(n.rms_m),
            })),
        })),
    })
}

/// Minutes of the scheduled table: every minute at first, then as the drift flattens.
fn minutes(w: &WarmUp) -> Vec<f64> {
    let tau_min = w.growth.tau_min().unwrap_or(1.0);
    let mut all = vec![0.0];
    let mut step_min = (tau_min / 40.0).max(0.25);
    while let Some(&last) = all.last()
        && last < 12.0 * tau_min
    {
        all.push(last + step_min);
        if last > 2.0 * tau_min {
            step_min *= 1.15;
        }
    }
    all
}

/// The first line of a deformation table by warm-up time.
pub const TABLE_HEADER: &str = "t_min,joint,dx_mm,dy_mm,dz_mm,rx_deg,ry_deg,rz_deg";
/// Decimals of its minutes.
pub const TIME_DECIMALS: usize = 3;
/// Decimals of its millimetres and degrees.
pub const VALUE_DECIMALS: usize = 8;

/// The deformation table in the scheduled long form.
#[must_use]
pub fn table_csv(w: &WarmUp) -> String {
    let deformation: Deformation = w.deformation();
    let mut out = format!("{TABLE_HEADER}\n");
    for t_min in minutes(w) {
        for (joint, row) in deformation.offsets_at(t_min).0.iter().take(6).enumerate() {
            let _ = write!(out, "{t_min:.TIME_DECIMALS$},{}", Axis::at(joint));
            for (k, value) in row.iter().enumerate() {
                let _ = write!(out, ",{:.VALUE_DECIMALS$}", unit(k).1(*value));
            }
            out.push('\n');
        }
    }
    out
}

//! What a model leaves of measurements that it has not seen, for people and as JSON.

use super::counted;
use metrology::diagnose::{PoseSubset, Validation};
use serde_json::{Value, json};
use std::fmt::Write as _;
use warm_up::Standstill;

/// Distances for people, mm.
#[must_use]
pub fn text(found: &Validation) -> String {
    let mut out = String::new();
    // writing to a String cannot fail
    for (name, part) in [("all", &found.all), ("inside", &found.inside), ("outside", &found.outside)] {
        if part.n == 0 {
            continue;
        }
        let _ = writeln!(
            out,
            "{name:>7}: {:5} poses, model rms {:.4} mean {:.4} max {:.4} mm; nominal rms {:.4} mean {:.4} max {:.4} mm",
            part.n,
            part.model.rms_mm,
            part.model.mean_mm,
            part.model.max_mm,
            part.nominal.rms_mm,
            part.nominal.mean_mm,
            part.nominal.max_mm
        );
    }
    if found.all.readings > found.all.n {
        let _ = writeln!(
            out,
            "readings of one pose within 10 min, of which there are {}, count as one, their mean",
            found.all.readings
        );
    }
    for (joint, n) in &found.joints_outside {
        let poses = counted(*n, "pose");
        let _ = writeln!(out, "joint {joint} leaves the range the model was found in at {poses}");
    }
    out
}

/// When the robot is taken to have stood, for people.
#[must_use]
pub fn stops(stops: &[Standstill], are_named: bool) -> String {
    let by_pause = if are_named { "" } else { ", by the pause between rows (--stop FROM:TO says when)" };
    let line = |stop: &Standstill| {
        format!("the robot stood from minute {:.0} to {:.0}{by_pause}\n", stop.from_min, stop.to_min)
    };
    stops.iter().map(line).collect()
}

/// The result as the contract's JSON; the robot stood in `stops`.
#[must_use]
pub fn json(found: &Validation, stops: &[Standstill]) -> Value {
    let PoseSubset { n, readings, model, nominal } = found.all;
    json!({
        "n": n, "readings": readings, "rms_mm": model.rms_mm, "mean_mm": model.mean_mm, "max_mm": model.max_mm, "nominal": nominal,
        "inside": found.inside, "outside": found.outside, "joints_outside": found.joints_outside,
        "stops": stops.iter().map(|stop| [stop.from_min, stop.to_min]).collect::<Vec<_>>(),
        "worst": found.worst.iter().map(|(line, mm)| json!({ "line": line, "mm": mm })).collect::<Vec<_>>(),
    })
}

//! What a model leaves of measurements that it has not seen, for people and as JSON.

use super::counted;
use metrology::diagnose::{PoseSubset, Validation};
use serde_json::{Value, json};
use std::fmt::Write as _;

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
    for (joint, n) in &found.joints_outside {
        let poses = counted(*n, "pose");
        let _ = writeln!(out, "joint {joint} leaves the range the model was found in at {poses}");
    }
    out
}

/// The result as the contract's JSON.
#[must_use]
pub fn json(found: &Validation) -> Value {
    let PoseSubset { n, model, nominal } = found.all;
    json!({
        "n": n, "rms_mm": model.rms_mm, "mean_mm": model.mean_mm, "max_mm": model.max_mm, "nominal": nominal,
        "inside": found.inside, "outside": found.outside, "joints_outside": found.joints_outside,
        "worst": found.worst.iter().map(|(line, mm)| json!({ "line": line, "mm": mm })).collect::<Vec<_>>(),
    })
}

//! What has changed between two measurements, for people and as JSON.

use super::{counted, notes};
use metrology::diagnose::{MeasurementComparison, MovedPoint, describe};
use robot_model::units::{deg_from_rad, mm_from_m, ppm_from_ratio};
use serde_json::{Value, json};
use std::io::{self, Write};

/// For people.
///
/// # Errors
/// Those of writing to `out`.
pub fn write(out: &mut dyn Write, found: &MeasurementComparison, is_changed: bool) -> io::Result<()> {
    opening(out, found, is_changed)?;
    for cause in &found.diagnosis.causes {
        let size = cause.size.map_or_else(String::new, |size| format!(", {size:.3e} {}", cause.unit));
        writeln!(out, "  {}{size}, probability {:.1} %", describe(cause), 100.0 * cause.posterior)?;
    }
    writeln!(out, "largest changes")?;
    for moved in &found.worst {
        let [before, after] = moved.lines;
        writeln!(out, "  line {before} before, line {after} after: {:.4} mm", mm_from_m(moved.by_m))?;
    }
    Ok(())
}

/// The verdict, and what has moved by how much.
fn opening(out: &mut dyn Write, found: &MeasurementComparison, is_changed: bool) -> io::Result<()> {
    writeln!(out, "{}{}", verdict(found, is_changed), other_targets(found))?;
    let [before, after] = found.alone;
    let poses = counted(found.pairs, "pose");
    writeln!(out, "{poses} measured both times; {before} only before, {after} only after")?;
    let noise =
        found.noise_rms_m.map_or_else(String::new, |m| format!("; noise alone would be {:.4}", mm_from_m(m)));
    writeln!(
        out,
        "the points have moved by {:.4} mm rms, base and tool refitted{noise}",
        mm_from_m(found.rms_m)
    )?;
    for (k, (by, sigma)) in found.tools_moved_m.iter().enumerate() {
        let [x, y, z] = [by.x, by.y, by.z].map(mm_from_m);
        let exactly = match found.arm_is_changed {
            true => PART_OF_ARM.to_owned(),
            false => format!(" (+- {:.4})", mm_from_m(*sigma)),
        };
        writeln!(
            out,
            "{} on the flange: {x:+.4}, {y:+.4}, {z:+.4} mm{exactly}, {:.4} mm in all",
            target_name(found, k),
            mm_from_m(by.norm())
        )?;
    }
    base(out, found)?;
    writeln!(out, "the arm itself: {}", found.diagnosis.reason)?;
    if found.beyond.poses > 0 {
        let (poses, verb) =
            (counted(found.beyond.poses, "pose"), if found.beyond.poses == 1 { "has" } else { "have" });
        writeln!(
            out,
            "{poses} {verb} moved by more than noise moves one, see the largest changes: where no cause of all is named, measure them again"
        )?;
    }
    if found.beyond.is_scattered {
        writeln!(out, "all points together have moved by more than noise alone would move them")?;
    }
    Ok(())
}

/// In the place of a standard deviation, where the arm has changed.
const PART_OF_ARM: &str = " (how exactly is not told: the arm's change may be a part of it)";

/// Where the base is now, with one standard deviation.
fn base(out: &mut dyn Write, found: &MeasurementComparison) -> io::Result<()> {
    let [x, y, z] = <[f64; 3]>::from(found.base_moved.translation.vector).map(mm_from_m);
    let untold = || [PART_OF_ARM.to_owned(), String::new()];
    let [shift, turn] = found.base_sigma.map_or_else(untold, |sigma| {
        let [x, y, z] = sigma.shift_m.map(mm_from_m);
        [format!(" (+- {x:.3}, {y:.3}, {z:.3})"), format!(" (+- {:.4})", deg_from_rad(sigma.turn_rad))]
    });
    writeln!(
        out,
        "base, if the instrument stood still: {x:+.3}, {y:+.3}, {z:+.3} mm{shift}, turned by {:.4} deg{turn}",
        deg_from_rad(found.base_moved.rotation.angle())
    )
}

/// The first line, which says how far the verdict goes.
fn verdict(found: &MeasurementComparison, is_changed: bool) -> &'static str {
    match (is_changed, found.beyond.base_is_moved, found.noise_rms_m) {
        (true, ..) => "CHANGED",
        (false, true, _) => {
            "not changed, if the instrument was moved in between; if it stood still, the base has moved or the zero of axis 1 has"
        }
        (false, false, None) => {
            "not changed, as far as that can be told: nothing says how large the noise is (--sigma-mm, or poses that are repeated within ten minutes)"
        }
        (false, false, Some(_)) => "not changed",
    }
}

/// A target that was measured both times, by its number among these and, where the file has one, its name.
fn target_name(found: &MeasurementComparison, target: usize) -> String {
    match found.targets.get(target).map_or("", String::as_str) {
        "" => format!("target {}", target + 1),
        name => format!("target {} ({name})", target + 1),
    }
}

/// That a target sits where no wear takes it, as what follows the verdict; empty where none does.
fn other_targets(found: &MeasurementComparison) -> String {
    let all = found
        .other_targets()
        .into_iter()
        .filter_map(|target| Some((target, found.tools_moved_m.get(target)?)));
    let all: Vec<String> = all
        .map(|(target, (by, _))| format!("{} by {:.3} mm", target_name(found, target), mm_from_m(by.norm())))
        .collect();
    if all.is_empty() {
        return String::new();
    }
    format!(
        ": the tool point differs, {}: another target or tool than before, or one put on anew, no drift or wear",
        all.join(", ")
    )
}

/// The change of all lengths, its nests and whose it is, in ppm; null where that is not what has changed.
fn scale(found: &MeasurementComparison) -> Value {
    let Some(scale) = &found.scale else { return Value::Null };
    let nests = scale.nests.map(|nests| {
        json!({ "ppm": ppm_from_ratio(nests.ratio), "sigma_ppm": ppm_from_ratio(nests.sigma), "n": nests.nests })
    });
    let parted = scale.parted();
    json!({
        "ppm": ppm_from_ratio(scale.ratio), "sigma_ppm": ppm_from_ratio(scale.sigma), "nests": nests,
        "instrument_ppm": parted.map(|parted| ppm_from_ratio(parted.instrument)),
        "links_ppm": parted.map(|parted| ppm_from_ratio(parted.links)),
    })
}

/// The result as the contract's JSON.
#[must_use]
pub fn json(found: &MeasurementComparison, is_changed: bool) -> Value {
    let other = found.other_targets();
    let tools: Vec<Value> = found
        .tools_moved_m
        .iter()
        .enumerate()
        .map(|(target, (by, sigma))| {
            json!({ "target": found.targets.get(target), "by_mm": <[f64; 3]>::from(*by).map(mm_from_m), "sigma_mm": mm_from_m(*sigma),
                    "is_other": other.contains(&target) })
        })
        .collect();
    let apart_mm = found.tool_apart.map(|apart| apart.map(|apart| mm_from_m(apart.apart_m)));
    let worst: Vec<Value> = found
        .worst
        .iter()
        .map(|MovedPoint { lines: [before, after], by_m }| {
            json!({ "line_before": before, "line_after": after, "mm": mm_from_m(*by_m) })
        })
        .collect();
    let mut text = Vec::new();
    let _ = opening(&mut text, found, is_changed); // writing to memory cannot fail
    json!({
        "notes": notes(&String::from_utf8_lossy(&text)), "changed": is_changed, "pairs": found.pairs, "alone": found.alone, "rms_mm": mm_from_m(found.rms_m),
        "noise_rms_mm": found.noise_rms_m.map(mm_from_m), "tools": tools,
        "tool_apart_mm": apart_mm, "scale": scale(found),
        "base": { "by_mm": <[f64; 3]>::from(found.base_moved.translation.vector).map(mm_from_m),
                  "turned_deg": deg_from_rad(found.base_moved.rotation.angle()), "moved": found.beyond.base_is_moved,
                  "sigma_mm": found.base_sigma.map(|sigma| sigma.shift_m.map(mm_from_m)),
                  "turned_sigma_deg": found.base_sigma.map(|sigma| deg_from_rad(sigma.turn_rad)) },
        "beyond_noise": found.beyond.poses, "scattered": found.beyond.is_scattered,
        "verdict": found.diagnosis.verdict, "causes": found.diagnosis.causes, "worst": worst,
    })
}

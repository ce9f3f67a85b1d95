//! Performance after ISO 9283 for people and as JSON.

use super::table::{Align, Table};
use super::{counted, notes};
use measurements::{Performance, PosePerformance, Repeatability};
use robot_model::robot::SerialArm;
use robot_model::units::{deg_from_rad, mm_from_m};
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::io::{self, Write};

/// For people.
///
/// # Errors
/// Those of writing to `out`.
pub fn write(out: &mut dyn Write, found: &Performance) -> io::Result<()> {
    writeln!(out, "ISO 9283, mm; the commanded poses are the nominal arm's")?;
    let mut table = Table::new(&[
        ("line", Align::Right),
        ("id", Align::Left),
        ("n", Align::Right),
        ("AP", Align::Right),
        ("AP x", Align::Right),
        ("AP y", Align::Right),
        ("AP z", Align::Right),
        ("RP", Align::Right),
        ("dAP", Align::Right),
        ("dRP", Align::Right),
    ]);
    let mm = |m: f64| format!("{:.4}", mm_from_m(m));
    let maybe = |m: Option<f64>| m.map_or_else(|| "-".to_owned(), mm);
    for p in &found.poses {
        let [x, y, z] = [0, 1, 2].map(|k| maybe(p.accuracy.map(|a| a.of_axes_m[k])));
        let n = p.repeatability.map_or(1, |r| r.n);
        table.row([
            p.line.to_string(),
            p.name().unwrap_or_default().to_owned(),
            n.to_string(),
            maybe(p.accuracy.map(|a| a.ap_m)),
            x,
            y,
            z,
            maybe(p.repeatability.map(|r| r.rp_m)),
            maybe(p.drift_of_accuracy_m()),
            maybe(p.drift_of_repeatability_m()),
        ]);
    }
    table.write(out, "")?;
    write_rest(out, found)
}

/// The worst, and what is to be known of it.
fn write_rest(out: &mut dyn Write, found: &Performance) -> io::Result<()> {
    let mm = |m: f64| format!("{:.4}", mm_from_m(m));
    let maybe = |m: Option<f64>| m.map_or_else(|| "-".to_owned(), mm);
    let all = found.worst();
    // Commanded poses: one that was seen by several reflectors, from several sides or with several loads, is one.
    let poses = |counts: &dyn Fn(&PosePerformance) -> bool| {
        found.poses.iter().filter(|p| counts(p)).map(|p| p.pose).collect::<BTreeSet<usize>>().len()
    };
    let commanded = poses(&|_| true);
    writeln!(
        out,
        "worst of {}: accuracy AP {}, repeatability RP {}, drift of accuracy dAP {}",
        counted(commanded, "pose"),
        maybe(all.ap_m),
        maybe(all.rp_m),
        maybe(all.drift_m)
    )?;
    if found.registration.is_none() {
        writeln!(out, "so few poses do not place the robot's base: repeatability is told, accuracy is not")?;
    }
    let read_back = poses(&|p| p.joints_differ);
    if read_back > 0 {
        writeln!(
            out,
            "joints differ from row to row in {}: AP is from where each row's own joints put the target, RP of the points as attained",
            counted(read_back, "pose")
        )?;
    }
    if let Some(apart_m) = found.multi_directional_m {
        writeln!(out, "from several sides vAP {}", mm(apart_m))?;
    }
    if commanded < 5 {
        let verb = if commanded == 1 { "is" } else { "are" };
        writeln!(out, "{} {verb} fewer than the 5 that the standard asks for", counted(commanded, "pose"))?;
    }
    let few = poses(&|p| p.repeatability.is_none_or(|r| r.n < 30));
    if few > 0 {
        let verb = if few == 1 { "has" } else { "have" };
        writeln!(out, "{} {verb} fewer than the 30 cycles that the standard asks for", counted(few, "pose"))?;
    }
    Ok(())
}

/// The result as the contract's JSON.
#[must_use]
pub fn json(found: &Performance, within: Option<bool>, robot: &SerialArm) -> Value {
    let rp = |r: Repeatability| json!({ "n": r.n, "mean_mm": mm_from_m(r.mean_m), "s_mm": mm_from_m(r.s_m), "rp_mm": mm_from_m(r.rp_m) });
    let poses: Vec<Value> = found
        .poses
        .iter()
        .map(|p| {
            let times: Vec<Value> = p
                .times
                .iter()
                .map(|t| {
                    json!({ "t_min": t.t_min, "ap_mm": t.accuracy.map(|a| mm_from_m(a.ap_m)),
                            "rp_mm": t.repeatability.map(|r| mm_from_m(r.rp_m)) })
                })
                .collect();
            json!({
                "line": p.line, "id": p.id, "pose_id": p.pose_id, "q_deg": robot.in_deg_or_mm(&p.q_rad),
                "ap_mm": p.accuracy.map(|a| mm_from_m(a.ap_m)), "ap_xyz_mm": p.accuracy.map(|a| a.of_axes_m.map(mm_from_m)),
                "repeatability": p.repeatability.map(rp),
                "ap_abc_deg": p.orientation.map(|o| o.ap_rad.map(deg_from_rad)),
                "rp_abc_deg": p.orientation.and_then(|o| o.rp_rad).map(|rp| rp.map(deg_from_rad)),
                "drift_ap_mm": p.drift_of_accuracy_m().map(mm_from_m),
                "drift_rp_mm": p.drift_of_repeatability_m().map(mm_from_m), "times": times,
            })
        })
        .collect();
    let all = found.worst();
    let mut text = Vec::new();
    let _ = write_rest(&mut text, found); // writing to memory cannot fail
    json!({
        "notes": notes(&String::from_utf8_lossy(&text)), "poses": poses, "within": within,
        "worst": { "ap_mm": all.ap_m.map(mm_from_m), "rp_mm": all.rp_m.map(mm_from_m), "drift_ap_mm": all.drift_m.map(mm_from_m) },
        "multi_directional_mm": found.multi_directional_m.map(mm_from_m),
        "lines_left_out": found.lines_left_out,
    })
}

//! Two programs compared, for scripts: JSON, and CSV with a row for each motion and bucket.

use super::comparison::Compared;
use super::comparison_figures::{Figures, bucket, held, sentence};
use super::motion_rows::target_name;
use super::rounded;
use rapid_compensation::compensate::compare::TargetChange;
use rapid_program::Program;
use rapid_program::motion::MotionId;
use robot_model::units::{deg_from_rad, mm_from_m};
use serde::ser::{Serialize, SerializeMap, Serializer};
use serde_json::{Value, json};
use std::io::{self, Write};

impl Compared<'_> {
    /// Writes one row for each motion and bucket.
    ///
    /// # Errors
    /// Those of writing to `out`.
    pub fn write_csv(&self, out: &mut dyn Write) -> io::Result<()> {
        let mut csv = csv::Writer::from_writer(out);
        csv.write_record([
            "file",
            "line",
            "line_after",
            "routine",
            "kind",
            "target",
            "bucket",
            "dp_mm",
            "angle_deg",
            "joint",
            "joint_deg",
            "limit_margin_deg",
            "wrist_margin_deg",
            "elbow_margin_deg",
            "shoulder_margin_mm",
            "same_configuration",
            "same_branch",
            "same_frames",
        ])?;
        for compared in &self.comparison.motions {
            let (before, after) = self.motions(compared);
            for (k, step) in compared.steps.iter().chain(&compared.asked).enumerate() {
                let arm = |f: &dyn Fn(&rapid_compensation::compensate::compare::ArmChange) -> f64| {
                    step.arm.as_ref().map_or_else(String::new, |a| rounded(f(a)).to_string())
                };
                csv.write_record([
                    self.before.file(before.file).path.clone(),
                    before.line.to_string(),
                    after.line.to_string(),
                    self.before.routine_of(before).map_or_else(String::new, |r| r.name.clone()),
                    after.setup.kind.to_string(),
                    target_name(before).unwrap_or_default().to_owned(),
                    bucket(compared, k).map_or_else(String::new, |k| k.to_string()),
                    rounded(mm_from_m(step.distance_m)).to_string(),
                    rounded(deg_from_rad(step.angle_rad)).to_string(),
                    step.arm.map_or_else(String::new, |a| a.joint.to_string()),
                    arm(&|a| deg_from_rad(a.joint_rad)),
                    step.arm
                        .and_then(|a| a.limit_rad)
                        .map_or_else(String::new, |r| rounded(deg_from_rad(r)).to_string()),
                    arm(&|a| deg_from_rad(a.wrist_rad)),
                    arm(&|a| deg_from_rad(a.elbow_rad)),
                    arm(&|a| mm_from_m(a.shoulder_m)),
                    step.same_configuration.to_string(),
                    step.arm.map_or_else(String::new, |a| a.same_branch.to_string()),
                    compared.same_frames.to_string(),
                ])?;
            }
        }
        csv.flush()
    }
}

/// The same for scripts; is made motion by motion while it is written.
impl Serialize for Compared<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let place = |program: &Program, id: &MotionId| {
            let motion = program.motion(*id)?;
            Some(
                json!({"file": program.file(motion.file).path, "line": motion.line, "kind": motion.setup.kind}),
            )
        };
        let places = |program: &Program, list: &[MotionId]| -> Vec<Value> {
            list.iter().filter_map(|id| place(program, id)).collect()
        };
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("same", &self.is_same())?;
        map.serialize_entry("same_elsewhere", &self.is_same_elsewhere())?;
        map.serialize_entry("notes", &self.notes())?;
        map.serialize_entry("worst", &Figures::of(self.comparison).json())?;
        let elsewhere = self.elsewhere.iter().map(sentence).chain(self.other_files.iter().cloned());
        map.serialize_entry("elsewhere", &elsewhere.collect::<Vec<_>>())?;
        map.serialize_entry("held_modes", &self.modes.iter().map(held).collect::<Vec<_>>())?;
        map.serialize_entry("motions", &Motions(self))?;
        map.serialize_entry("only_before", &places(self.before, &self.comparison.only_before))?;
        map.serialize_entry("only_after", &places(self.after, &self.comparison.only_after))?;
        map.end()
    }
}

struct Motions<'a>(&'a Compared<'a>);

impl Serialize for Motions<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Compared { before, after, comparison, .. } = self.0;
        serializer.collect_seq(comparison.motions.iter().map(|compared| {
            let (old, new) = self.0.motions(compared);
            let steps = compared.steps.iter().enumerate();
            let buckets: Vec<Value> = steps.map(|(k, step)| step_json(bucket(compared, k), step)).collect();
            let asked = compared.asked.as_ref().map(|step| step_json(None, step));
            json!({
                "file": before.file(old.file).path,
                "line": old.line,
                "file_after": after.file(new.file).path,
                "line_after": new.line,
                "routine": before.routine_of(old).map(|r| &r.name),
                "kind": new.setup.kind,
                "target": target_name(old),
                "same_frames": compared.same_frames,
                "settled_mm": self.0.settled(compared).map(|[m, _]| rounded(mm_from_m(m))),
                "settled_deg": self.0.settled(compared).map(|[_, rad]| rounded(deg_from_rad(rad))),
                "asked": asked,
                "buckets": buckets,
            })
        }))
    }
}

fn step_json(bucket: Option<usize>, step: &TargetChange) -> Value {
    let mm = |m: f64| rounded(mm_from_m(m));
    let deg = |rad: f64| rounded(deg_from_rad(rad));
    json!({
        "index": bucket,
        "dp_mm": mm(step.distance_m),
        "angle_deg": deg(step.angle_rad),
        "joint": step.arm.map(|a| a.joint),
        "joint_deg": step.arm.map(|a| deg(a.joint_rad)),
        "limit_margin_deg": step.arm.and_then(|a| a.limit_rad).map(deg),
        "wrist_margin_deg": step.arm.map(|a| deg(a.wrist_rad)),
        "elbow_margin_deg": step.arm.map(|a| deg(a.elbow_rad)),
        "shoulder_margin_mm": step.arm.map(|a| mm(a.shoulder_m)),
        "same_configuration": step.same_configuration,
        "same_branch": step.arm.map(|a| a.same_branch),
    })
}

//! The model's file: TOML in mm, degrees and ppm, twelve digits, so that what is read and written again is the same.

mod effect;
mod text;

use super::error::ModelError;
use super::table_reader::TableReader;
use super::{FoundBy, Identified, MeasuredRange, Mounting};
use crate::deform::TIMES_MIN;
use crate::robot::{FEWEST_JOINTS, JointKind, Joints, MOST_JOINTS, RobotDigest};
use crate::units::{deg_from_rad, m_from_mm, mm_from_m, rad_from_deg};
use effect::{read_term, write_term};
use nalgebra::{Isometry3, Quaternion, Translation3, UnitQuaternion, Vector3};
use std::fmt::Write as _;
use text::{list, number, quoted, ranges};

/// The layout that is written.
const FORMAT: i64 = 1;

impl Identified {
    /// Reads a model file; see `docs/MODEL.md`.
    ///
    /// # Errors
    /// [`ModelError`] with line, or table and key.
    pub fn from_toml(text: &str) -> Result<Self, ModelError> {
        let table: toml::Table = toml::from_str(text).map_err(|e| ModelError::Toml {
            line: text.get(..e.span().map_or(0, |s| s.start)).unwrap_or(text).matches('\n').count() + 1,
            message: e.message().to_owned(),
        })?;
        let mut top = TableReader::new("top", table);
        match top.integer("format")? {
            Some(FORMAT) => {}
            Some(other) => return Err(top.wrong("format", format!("{other} is not known, {FORMAT} is"))),
            None => return Err(top.wrong("format", "missing: is this an identified model?".to_owned())),
        }
        let joint_kinds = match top.texts("joints")? {
            None => Self::default().joint_kinds,
            Some(names) => read_kinds(&top, &names)?,
        };
        let mut model = Self {
            robot: top.text("robot")?.unwrap_or_default(),
            robot_digest: read_digest(&mut top)?,
            joint_kinds,
            found_by: read_found_by(&mut top)?,
            tau_cool_min: read_tau_cool_min(&mut top)?,
            ..Self::default()
        };
        if let Some(mut data) = top.table("data")? {
            model.data = data.text("file")?.unwrap_or_default();
            model.data_sha256 = data.text("sha256")?.unwrap_or_default();
            model.measured_range.rows =
                data.integer("rows")?.and_then(|n| usize::try_from(n).ok()).unwrap_or(0);
            model.sigma_m = data.number("sigma_mm")?.map(m_from_mm);
            data.finish()?;
        }
        if let Some(range) = top.table("seen")? {
            read_measured_range(range, &joint_kinds, &mut model.measured_range)?;
        }
        if let Some(mut held_out) = top.table("held_out")? {
            let region_mm: Option<[f64; 2]> = held_out.numbers("region_mm")?;
            model.region_held_out_m = region_mm.map(|both| both.map(m_from_mm));
            held_out.finish()?;
        }
        if let Some(mounting) = top.table("mounting")? {
            model.mounting = Some(read_mounting(mounting)?);
        }
        let effects = top.tables("effect")?;
        for (i, effect) in effects.iter().enumerate() {
            let reader = TableReader::new(format!("[[effect]] {}", i + 1), effect.clone());
            if let Some(first) = effects[..i].iter().position(|earlier| earlier == effect) {
                let problem =
                    format!("is [[effect]] {} once more, and the arm would be corrected for both", first + 1);
                return Err(reader.wrong("effect", problem));
            }
            model.terms.push(read_term(reader, &joint_kinds)?);
        }
        top.finish()?;
        Ok(model)
    }

    /// The model as a file.
    #[must_use]
    pub fn to_toml(&self) -> String {
        let mut out =
            String::from("# An identified robot: docs/MODEL.md describes this file. mm, degrees, minutes.\n");
        let _ = writeln!(out, "format = {FORMAT}\nrobot = {}", quoted(&self.robot));
        if let Some(digest) = self.robot_digest {
            let _ = writeln!(out, "robot_digest = {}", quoted(&digest.to_string()));
        }
        if !self.is_six_axis() {
            let kinds: Vec<String> = self.joint_kinds.iter().map(|kind| quoted(kind.name())).collect();
            let _ = writeln!(out, "joints = [{}]", kinds.join(", "));
        }
        if let Some(found_by) = self.found_by {
            let _ = writeln!(out, "verdict = {}", quoted(found_by.name()));
        }
        if let Some(tau_min) = self.tau_cool_min {
            let _ = writeln!(out, "tau_cool_min = {}", number(tau_min));
        }
        let _ =
            writeln!(out, "\n[data]\nfile = {}\nsha256 = {}", quoted(&self.data), quoted(&self.data_sha256));
        let _ = writeln!(out, "rows = {}", self.measured_range.rows);
        if let Some(sigma_m) = self.sigma_m {
            let _ = writeln!(out, "sigma_mm = {}", number(mm_from_m(sigma_m)));
        }
        out += "\n[seen]  # ranges of the measurement; outside of them the model is a guess\n";
        let in_file = |(kind, range): (&JointKind, &[f64; 2])| range.map(|q| from_si(*kind, q));
        if let Some(q_rad) = &self.measured_range.q_rad {
            let seen: Joints<[f64; 2]> = self.joint_kinds.iter().zip(q_rad).map(in_file).collect();
            let _ = writeln!(out, "q_deg = {}", ranges(&seen));
        }
        if let Some(range) = self.measured_range.t_min {
            let _ = writeln!(out, "t_min = {}", list(&range));
        }
        if let Some(all) = &self.measured_range.joint_temperature_c {
            let _ = writeln!(out, "joint_temperature_c = {}", ranges(all));
        }
        if let Some(range) = self.measured_range.payload_kg {
            let _ = writeln!(out, "payload_kg = {}", list(&range));
        }
        if let Some(region_m) = self.region_held_out_m {
            out += "\n[held_out]  # rms before and after in a region that took no part\n";
            let _ = writeln!(out, "region_mm = {}", list(&region_m.map(mm_from_m)));
            if self.gains_nothing_elsewhere().is_some() {
                out += "# the model gained nothing there: do not carry it to places that were not measured\n";
            }
        }
        if let Some(mounting) = &self.mounting {
            write_mounting(&mut out, mounting);
        }
        for term in &self.terms {
            write_term(&mut out, term, &self.joint_kinds);
        }
        out
    }

    /// The model with the numbers that its file holds: what is written and read again is this.
    ///
    /// # Errors
    /// Where a value is not finite.
    pub fn as_written(&self) -> Result<Self, ModelError> {
        Self::from_toml(&self.to_toml())
    }
}

/// A joint's coordinate as the file has it: degrees, or mm where it slides.
fn from_si(kind: JointKind, q_rad: f64) -> f64 {
    if kind.slides() { mm_from_m(q_rad) } else { deg_from_rad(q_rad) }
}

fn read_found_by(top: &mut TableReader) -> Result<Option<FoundBy>, ModelError> {
    let Some(name) = top.text("verdict")?.filter(|name| !name.is_empty()) else { return Ok(None) };
    let known = FoundBy::named(&name);
    known.map(Some).ok_or_else(|| top.wrong("verdict", format!("`{name}` is no verdict")))
}

fn read_digest(top: &mut TableReader) -> Result<Option<RobotDigest>, ModelError> {
    let Some(text) = top.text("robot_digest")? else { return Ok(None) };
    let read =
        text.parse().map_err(|_| top.wrong("robot_digest", format!("`{text}` is no digest of a robot")));
    read.map(Some)
}

fn read_tau_cool_min(top: &mut TableReader) -> Result<Option<f64>, ModelError> {
    let tau_min = top.number("tau_cool_min")?;
    if let Some(tau_min) = tau_min.filter(|tau_min| !TIMES_MIN.contains(tau_min)) {
        let [least, most] = [TIMES_MIN.start(), TIMES_MIN.end()];
        return Err(top.wrong("tau_cool_min", format!("{tau_min} is none of {least} to {most} minutes")));
    }
    Ok(tau_min)
}

fn read_kinds(top: &TableReader, names: &[String]) -> Result<Joints<JointKind>, ModelError> {
    if !(FEWEST_JOINTS..=MOST_JOINTS).contains(&names.len()) {
        let problem = format!("{} joints are none of {FEWEST_JOINTS} to {MOST_JOINTS}", names.len());
        return Err(top.wrong("joints", problem));
    }
    let kind = |name: &String| {
        let known = [JointKind::Revolute, JointKind::Prismatic].into_iter().find(|kind| kind.name() == name);
        known.ok_or_else(|| top.wrong("joints", format!("`{name}` is neither revolute nor prismatic")))
    };
    names.iter().map(kind).collect::<Result<Vec<_>, _>>().map(|kinds| kinds.into_iter().collect())
}

fn read_measured_range(
    mut keys: TableReader,
    kinds: &Joints<JointKind>,
    range: &mut MeasuredRange,
) -> Result<(), ModelError> {
    if let Some(seen) = keys.ranges("q_deg", kinds.len())? {
        let si = |(kind, range): (&JointKind, [f64; 2])| {
            range.map(if kind.slides() { m_from_mm } else { rad_from_deg })
        };
        range.q_rad = Some(kinds.iter().zip(seen).map(si).collect());
    }
    range.t_min = keys.numbers("t_min")?;
    range.joint_temperature_c = keys.ranges("joint_temperature_c", kinds.len())?;
    range.payload_kg = keys.numbers("payload_kg")?;
    keys.finish()
}

fn read_mounting(mut keys: TableReader) -> Result<Mounting, ModelError> {
    let base_mm: [f64; 3] = keys.required("base_mm")?;
    let [w, x, y, z] = keys.required("base_wxyz")?;
    let turn = UnitQuaternion::try_new(Quaternion::new(w, x, y, z), 1e-6)
        .ok_or_else(|| keys.wrong("base_wxyz", "has no length".to_owned()))?;
    let tools: Vec<f64> = keys.list("tools_mm")?;
    if tools.is_empty() || !tools.len().is_multiple_of(3) {
        return Err(keys.wrong("tools_mm", "three numbers for each target are needed".to_owned()));
    }
    let tools_m = tools.chunks_exact(3).map(|t| Vector3::from_column_slice(t).map(m_from_mm)).collect();
    let payload_m = keys.numbers("payload_mm")?.map(|mm: [f64; 3]| Vector3::from(mm).map(m_from_mm));
    keys.finish()?;
    let at = Translation3::from(Vector3::from(base_mm).map(m_from_mm));
    Ok(Mounting { instrument_from_base: Isometry3::from_parts(at, turn), tools_m, payload_m })
}

fn write_mounting(out: &mut String, mounting: &Mounting) {
    let base = &mounting.instrument_from_base;
    let at: Vec<f64> = base.translation.vector.iter().map(|m| mm_from_m(*m)).collect();
    let q = base.rotation.quaternion();
    let tools: Vec<f64> = mounting.tools_m.iter().flat_map(|t| t.iter().map(|m| mm_from_m(*m))).collect();
    out.push_str(
        "\n[mounting]  # how the robot stood in the instrument's frame, and the targets on its flange\n",
    );
    let _ = writeln!(
        out,
        "base_mm = {}\nbase_wxyz = {}\ntools_mm = {}",
        list(&at),
        list(&[q.w, q.i, q.j, q.k]),
        list(&tools)
    );
    if let Some(payload_m) = mounting.payload_m {
        let _ = writeln!(out, "payload_mm = {}", list(payload_m.map(mm_from_m).as_slice()));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::deform::EffectKind;
    use crate::deform::identified::{Estimate, Verdict};

    const TEXT: &str = include_str!("../../../../../fixtures/model/every_effect.toml");

    #[test]
    fn every_effect_is_read_and_written_without_loss() {
        let model = Identified::from_toml(TEXT).unwrap();
        assert_eq!(
            model.terms.len(),
            EffectKind::ALL.into_iter().filter(|kind| kind.is_model_term()).count()
        );
        let written = model.to_toml();
        let again = Identified::from_toml(&written).unwrap();
        assert_eq!(again, model);
        assert_eq!(again.to_toml(), written);
        assert_eq!(model.found_by, Some(FoundBy::Diagnosis(Verdict::Several)));
        // By hand: 0.057 deg, 4.1e-6 rad/(N.m), 120 ppm.
        assert_eq!(model.terms[0].values[0].value, 0.057_f64.to_radians());
        assert_eq!(model.terms[2].values[0].value, 4.1e-6);
        assert!((model.terms[11].values[0].value - 1.2e-4).abs() < 1e-18);
    }

    #[test]
    fn an_effect_that_was_pasted_twice_is_refused() {
        let effect = "\n[[effect]]\neffect = \"joint_offset\"\njoint = 3\noffset_deg = 0.05\n";
        let model = |effects: &str| Identified::from_toml(&format!("format = 1\n{effects}"));
        let error = model(&format!("{effect}{effect}")).unwrap_err().to_string();
        assert!(error.contains("[[effect]] 2") && error.contains("[[effect]] 1 once more"), "{error}");
        // Another joint's, or another size of the same, is another effect.
        for other in [effect.replace('3', "2"), effect.replace("0.05", "0.06")] {
            assert_eq!(model(&format!("{effect}{other}")).unwrap().terms.len(), 2, "{other}");
        }
    }

    #[test]
    fn what_a_model_was_written_of_is_read_from_the_word_it_writes() {
        for found_by in Verdict::ALL.into_iter().map(FoundBy::Diagnosis).chain([FoundBy::WarmUp]) {
            let model = Identified { found_by: Some(found_by), ..Identified::default() };
            let text = model.to_toml();
            assert!(text.contains(&format!("\nverdict = \"{}\"\n", found_by.name())), "{text}");
            assert_eq!(Identified::from_toml(&text).unwrap().found_by, Some(found_by));
        }
        assert!(!Identified::default().to_toml().contains("verdict"));
    }

    #[test]
    fn what_a_model_gained_in_a_region_that_it_never_saw_goes_with_it() {
        let of = |region: &str| {
            Identified::from_toml(&format!("format = 1\nrobot = \"x\"\n[held_out]\nregion_mm = {region}\n"))
        };
        let [gained, lost] = ["[0.4, 0.1]", "[0.1, 0.4]"].map(|region| of(region).unwrap());
        assert_eq!(gained.gains_nothing_elsewhere(), None);
        let [before_m, after_m] = lost.gains_nothing_elsewhere().unwrap();
        assert!((before_m - 1e-4).abs() < 1e-15 && (after_m - 4e-4).abs() < 1e-15);
        assert!(
            lost.to_toml().contains("gained nothing there") && !gained.to_toml().contains("gained nothing")
        );
        assert_eq!(Identified::from_toml(&lost.to_toml()).unwrap(), lost);
        assert!(of("[0.1]").is_err());
    }

    #[test]
    fn of_an_arm_with_a_joint_that_slides_lengths_are_mm() {
        let text = "format = 1\nrobot = \"x\"\njoints = [\"revolute\", \"revolute\", \"prismatic\", \"revolute\"]\n\
                    [seen]\nq_deg = [[-90, 90], [0, 45], [-180, 0], [0, 0]]\n\
                    [[effect]]\neffect = \"joint_offset\"\njoint = 3\noffset_mm = 0.2\nsigma_offset_mm = 0.01\n\
                    [[effect]]\neffect = \"joint_offset\"\njoint = 4\noffset_deg = 0.1\n";
        let model = Identified::from_toml(text).unwrap();
        let q_rad = model.measured_range.q_rad.unwrap();
        assert_eq!((q_rad[2], q_rad[0][1]), ([-0.18, 0.0], std::f64::consts::FRAC_PI_2));
        assert_eq!(model.terms[0].values[0], Estimate { value: 2e-4, sigma: Some(1e-5) });
        assert_eq!(model.terms[1].values[0].value, 0.1_f64.to_radians());
        assert!(!model.is_six_axis());
        assert_eq!(Identified::from_toml(&model.to_toml()).unwrap(), model);
        let error_text = |text: &str| Identified::from_toml(text).unwrap_err().to_string();
        assert_eq!(
            error_text(&text.replace("offset_deg = 0.1", "offset_mm = 0.1")),
            "model, [[effect]] 2, offset_mm: is not known here"
        );
        assert_eq!(
            error_text(&text.replace("joint = 4", "joint = 5")),
            "model, [[effect]] 2, joint: 5 is not 1 to 4"
        );
        assert!(error_text(&text.replace("\"prismatic\"", "\"linear\"")).contains("`linear` is neither"));
    }

    #[test]
    fn what_is_wrong_is_named_with_its_place() {
        let error = |from: &str, to: &str| {
            assert!(TEXT.contains(from), "{from}");
            Identified::from_toml(&TEXT.replacen(from, to, 1)).unwrap_err().to_string()
        };
        assert_eq!(error("format = 1", "format = 2"), "model, top, format: 2 is not known, 1 is");
        assert_eq!(
            error("offset_deg = 0.057", "offset_mm = 0.057"),
            "model, [[effect]] 1, offset_mm: is not known here"
        );
        assert_eq!(error("joint = 3", "joint = 7"), "model, [[effect]] 1, joint: 7 is not 1 to 6");
        assert!(error("format = 1", "format =").starts_with("model, line "));
        let bent = "effect = \"link_bending\"\njoint = 2";
        let last = error(bent, "effect = \"link_bending\"\njoint = 6");
        assert!(last.ends_with("joint: link_bending needs a joint behind the link, 1 to 5"), "{last}");
        let itself = error("joint_b = 6", "joint_b = 5");
        assert!(itself.ends_with("joint_b: a joint is not coupled to itself"), "{itself}");
        assert_eq!(
            error("verdict = \"several\"", "verdict = \"severel\""),
            "model, top, verdict: `severel` is no verdict"
        );
        let unknown = error("effect = \"joint_offset\"", "effect = \"joint_ofset\"");
        assert_eq!(unknown, "model, [[effect]] 1, effect: `joint_ofset` is not known");
    }
}

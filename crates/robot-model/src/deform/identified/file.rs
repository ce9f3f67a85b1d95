//! The model's file: TOML in mm, degrees and ppm, twelve digits, so that what is read and written again is the same.

use super::error::ModelError;
use super::table_reader::TableReader;
use super::{Growth, Identified, MeasuredRange, Mounting, PayloadScaling, Term, Value};
use crate::deform::{EffectKind, GrowthLaw};
use crate::robot::{Axis, FEWEST_JOINTS, JointKind, Joints, MOST_JOINTS};
use crate::units::{deg_from_rad, m_from_mm, mm_from_m, rad_from_deg};
use nalgebra::{Isometry3, Quaternion, Translation3, UnitQuaternion, Vector3};
use std::fmt::Write as _;

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
            joint_kinds,
            measured_range: MeasuredRange {
                q_rad: joint_kinds.map(|_| [0.0; 2]),
                ..MeasuredRange::default()
            },
            verdict: top.text("verdict")?.unwrap_or_default(),
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
        for (i, effect) in top.tables("effect")?.into_iter().enumerate() {
            model
                .terms
                .push(read_term(TableReader::new(format!("[[effect]] {}", i + 1), effect), &joint_kinds)?);
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
        if !self.is_six_axis() {
            let kinds: Vec<String> = self.joint_kinds.iter().map(|kind| quoted(kind.name())).collect();
            let _ = writeln!(out, "joints = [{}]", kinds.join(", "));
        }
        if !self.verdict.is_empty() {
            let _ = writeln!(out, "verdict = {}", quoted(&self.verdict));
        }
        let _ =
            writeln!(out, "\n[data]\nfile = {}\nsha256 = {}", quoted(&self.data), quoted(&self.data_sha256));
        let _ = writeln!(out, "rows = {}", self.measured_range.rows);
        if let Some(sigma_m) = self.sigma_m {
            let _ = writeln!(out, "sigma_mm = {}", number(mm_from_m(sigma_m)));
        }
        out += "\n[seen]  # ranges of the measurement; outside of them the model is a guess\n";
        let in_file = |(kind, range): (&JointKind, &[f64; 2])| range.map(|q| from_si(*kind, q));
        let seen: Joints<[f64; 2]> =
            self.joint_kinds.iter().zip(&self.measured_range.q_rad).map(in_file).collect();
        let _ = writeln!(out, "q_deg = {}", ranges(&seen));
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
        range.q_rad = kinds.iter().zip(seen).map(si).collect();
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

/// More teeth than this has no gear.
const MOST_PERIODS: u32 = 1000;

fn read_term(mut keys: TableReader, kinds: &Joints<JointKind>) -> Result<Term, ModelError> {
    let name = keys.text("effect")?.ok_or_else(|| keys.wrong("effect", "missing".to_owned()))?;
    let kind = name.parse().ok().filter(|kind: &EffectKind| kind.is_model_term());
    let kind = kind.ok_or_else(|| keys.wrong("effect", format!("`{name}` is not known")))?;
    let joint = keys.joint("joint", kinds.len())?;
    if kind.takes_joint() && joint.is_none() && !kind.may_be_of_all() {
        return Err(keys.wrong("joint", format!("{name} needs one, 1 to {}", kinds.len())));
    }
    let joint_b = keys.joint("joint_b", kinds.len())?;
    if (kind == EffectKind::JointCoupling) != joint_b.is_some() {
        return Err(keys.wrong("joint_b", "joint_coupling needs it, no other effect takes it".to_owned()));
    }
    let n = keys.integer("n")?.and_then(|n| u32::try_from(n).ok());
    let n = match (kind, n) {
        (EffectKind::GearEccentricity, _) => Some(1),
        (EffectKind::GearSecondHarmonic, _) => Some(2),
        (EffectKind::GearMesh, None) => {
            return Err(keys.wrong("n", "gear_mesh needs periods per turn".to_owned()));
        }
        (EffectKind::GearMesh, Some(n)) if !(1..=MOST_PERIODS).contains(&n) => {
            return Err(keys.wrong("n", format!("{n} periods per turn are no gear: 1 to {MOST_PERIODS}")));
        }
        (_, n) => n,
    };
    let mut values = Vec::new();
    for (key, unit) in kind.parameters(kind_of(joint, kinds)) {
        let number = keys.number(key)?.unwrap_or(0.0);
        if kind == EffectKind::Backlash && number < 0.0 {
            return Err(keys.wrong(key, format!("{number} is no play: 0 or more is asked for")));
        }
        let value = unit.si(number);
        let sigma = keys.number(&format!("sigma_{key}"))?.map(|s| unit.si(s));
        values.push(Value { value, sigma });
    }
    if kind == EffectKind::GearSpectrum {
        values = read_spectrum(&mut keys)?;
    }
    let cause = keys.boolean("cause")?.unwrap_or(true);
    let held_above_n_m = keys.number("held_above_n_m")?;
    let payload_scaling = read_payload_scaling(&mut keys)?;
    let growth = read_growth(&mut keys, kinds.len())?;
    keys.finish()?;
    Ok(Term { kind, joint, joint_b, n, growth, held_above_n_m, payload_scaling, cause, values })
}

/// Lists of sines and cosines, sigmas beside them or not.
fn read_spectrum(keys: &mut TableReader) -> Result<Vec<Value>, ModelError> {
    let parts = SPECTRUM.map(|key| (key, format!("sigma_{key}")));
    let mut lists = Vec::new();
    for (key, sigma_key) in &parts {
        lists.push((keys.list(key)?, keys.list(sigma_key)?));
    }
    let n = lists.first().map_or(0, |(values, _)| values.len());
    for ((values, sigmas), (key, sigma_key)) in lists.iter().zip(&parts) {
        if values.len() != n || n == 0 {
            return Err(keys.wrong(key, "sines and cosines are needed, as many of each".to_owned()));
        }
        if !sigmas.is_empty() && sigmas.len() != n {
            return Err(keys.wrong(sigma_key, format!("{n} numbers are needed, there are {}", sigmas.len())));
        }
    }
    let value = |k: usize, (values, sigmas): &(Vec<f64>, Vec<f64>)| Value {
        value: rad_from_deg(values[k]),
        sigma: sigmas.get(k).map(|s| rad_from_deg(*s)),
    };
    Ok((0..n).flat_map(|k| lists.iter().map(move |list| value(k, list))).collect())
}

fn write_spectrum(out: &mut String, values: &[Value]) {
    for (first, key) in SPECTRUM.iter().enumerate() {
        let part: Vec<Value> = values.iter().skip(first).step_by(2).copied().collect();
        let degrees: Vec<f64> = part.iter().map(|v| deg_from_rad(v.value)).collect();
        let _ = writeln!(out, "{key} = {}", list(&degrees));
        let sigmas: Option<Vec<f64>> = part.iter().map(|v| v.sigma.map(deg_from_rad)).collect();
        if let Some(sigmas) = sigmas {
            let _ = writeln!(out, "sigma_{key} = {}", list(&sigmas));
        }
    }
}

/// Keys of a spectrum's values.
const SPECTRUM: [&str; 2] = ["sin_deg", "cos_deg"];
/// Names of [`PayloadScaling`] in the file.
const PAYLOAD_SCALINGS: [(&str, PayloadScaling); 3] = [
    ("where-loaded", PayloadScaling::WhereLoaded),
    ("always", PayloadScaling::Always),
    ("per-kilogram", PayloadScaling::PerKilogram),
];

fn read_payload_scaling(keys: &mut TableReader) -> Result<PayloadScaling, ModelError> {
    let Some(name) = keys.text("hangs")? else { return Ok(PayloadScaling::default()) };
    let known = PAYLOAD_SCALINGS
        .iter()
        .find(|(known, _)| *known == name)
        .map(|(_, payload_scaling)| *payload_scaling);
    known
        .ok_or_else(|| keys.wrong("hangs", format!("`{name}` is none of where-loaded, always, per-kilogram")))
}

fn read_growth(keys: &mut TableReader, joints: usize) -> Result<Growth, ModelError> {
    let Some(name) = keys.text("growth")? else { return Ok(Growth::Always) };
    let positive = |keys: &mut TableReader, key: &str| match keys.number(key)? {
        Some(value) if value > 0.0 => Ok(value),
        _ => Err(keys.wrong(key, format!("growth `{name}` needs it, more than 0"))),
    };
    match name.as_str() {
        "exp" => Ok(Growth::Law(GrowthLaw::Exp { tau_min: positive(keys, "tau_min")? })),
        "two-stage" => Ok(Growth::Law(GrowthLaw::TwoStage { tau_min: positive(keys, "tau_min")? })),
        "linear" => {
            let from_min = keys.number("from_min")?.unwrap_or(0.0);
            let to_min = keys.number("to_min")?.unwrap_or(0.0);
            if to_min <= from_min {
                return Err(keys.wrong("to_min", "must come after from_min".to_owned()));
            }
            Ok(Growth::Linear { from_min, to_min })
        }
        "step" => {
            let t0_min = keys.number("t0_min")?;
            let t0_min = t0_min.ok_or_else(|| keys.wrong("t0_min", "growth `step` needs it".to_owned()))?;
            Ok(Growth::Step { t0_min })
        }
        "temperature" => {
            let from_c = keys.per_joint("from_c", joints)?;
            Ok(Growth::Temperature { from_c, to_c: keys.per_joint("to_c", joints)? })
        }
        _ => {
            Err(keys
                .wrong("growth", format!("`{name}` is none of exp, two-stage, linear, step, temperature")))
        }
    }
}

/// How the joint of a term moves.
fn kind_of(joint: Option<Axis>, kinds: &Joints<JointKind>) -> JointKind {
    joint.and_then(|joint| kinds.get(joint.index())).copied().unwrap_or_default()
}

fn write_term(out: &mut String, term: &Term, kinds: &Joints<JointKind>) {
    let _ = writeln!(out, "\n[[effect]]\neffect = {}", quoted(term.kind.name()));
    if !term.cause {
        out.push_str("cause = false\n");
    }
    for (key, joint) in [("joint", term.joint), ("joint_b", term.joint_b)] {
        if let Some(joint) = joint {
            let _ = writeln!(out, "{key} = {joint}");
        }
    }
    if let (EffectKind::GearMesh, Some(n)) = (term.kind, term.n) {
        let _ = writeln!(out, "n = {n}");
    }
    for ((key, unit), value) in term.kind.parameters(kind_of(term.joint, kinds)).iter().zip(&term.values) {
        let optional = ["link", "joint", "uneven", "force", "hardening", "softening"]
            .iter()
            .any(|correction| key.starts_with(correction));
        if optional && value.value == 0.0 && value.sigma.is_none() {
            continue;
        }
        let _ = writeln!(out, "{key} = {}", number(unit.file(value.value)));
        if let Some(sigma) = value.sigma {
            let _ = writeln!(out, "sigma_{key} = {}", number(unit.file(sigma)));
        }
    }
    if term.kind == EffectKind::GearSpectrum {
        write_spectrum(out, &term.values);
    }
    if let Some(limit) = term.held_above_n_m {
        let _ = writeln!(out, "held_above_n_m = {}", number(limit));
    }
    if let Some((name, _)) =
        PAYLOAD_SCALINGS.iter().skip(1).find(|(_, payload_scaling)| *payload_scaling == term.payload_scaling)
    {
        let _ = writeln!(out, "hangs = {}", quoted(name));
    }
    let _ = match term.growth {
        Growth::Always | Growth::Law(GrowthLaw::None) => Ok(()),
        Growth::Law(GrowthLaw::Exp { tau_min }) => {
            writeln!(out, "growth = \"exp\"\ntau_min = {}", number(tau_min))
        }
        Growth::Law(GrowthLaw::TwoStage { tau_min }) => {
            writeln!(out, "growth = \"two-stage\"\ntau_min = {}", number(tau_min))
        }
        Growth::Linear { from_min, to_min } => {
            writeln!(out, "growth = \"linear\"\nfrom_min = {}\nto_min = {}", number(from_min), number(to_min))
        }
        Growth::Step { t0_min } => writeln!(out, "growth = \"step\"\nt0_min = {}", number(t0_min)),
        Growth::Temperature { from_c, to_c } => {
            writeln!(out, "growth = \"temperature\"\nfrom_c = {}\nto_c = {}", list(&from_c), list(&to_c))
        }
    };
}

/// Twelve digits and always a number that TOML reads as a float.
fn number(value: f64) -> String {
    let rounded: f64 = format!("{value:.11e}").parse().unwrap_or(value);
    let rounded = if rounded == 0.0 { 0.0 } else { rounded };
    if rounded != 0.0 && !(1e-4..1e9).contains(&rounded.abs()) {
        format!("{rounded:e}")
    } else {
        format!("{rounded:?}")
    }
}

fn list(values: &[f64]) -> String {
    format!("[{}]", values.iter().map(|v| number(*v)).collect::<Vec<_>>().join(", "))
}

fn ranges(all: &[[f64; 2]]) -> String {
    format!("[{}]", all.iter().map(|r| list(r)).collect::<Vec<_>>().join(", "))
}

fn quoted(text: &str) -> String {
    toml::Value::String(text.to_owned()).to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

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
        // By hand: 0.057 deg, 4.1e-6 rad/(N.m), 120 ppm.
        assert_eq!(model.terms[0].values[0].value, 0.057_f64.to_radians());
        assert_eq!(model.terms[2].values[0].value, 4.1e-6);
        assert!((model.terms[11].values[0].value - 1.2e-4).abs() < 1e-18);
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
        assert_eq!(model.measured_range.q_rad[2], [-0.18, 0.0]);
        assert_eq!(model.measured_range.q_rad[0][1], std::f64::consts::FRAC_PI_2);
        assert_eq!(model.terms[0].values[0], Value { value: 2e-4, sigma: Some(1e-5) });
        assert_eq!(model.terms[1].values[0].value, 0.1_f64.to_radians());
        assert!(!model.is_six_axis());
        assert_eq!(Identified::from_toml(&model.to_toml()).unwrap(), model);
        let said = |text: &str| Identified::from_toml(text).unwrap_err().to_string();
        assert_eq!(
            said(&text.replace("offset_deg = 0.1", "offset_mm = 0.1")),
            "model, [[effect]] 2, offset_mm: is not known here"
        );
        assert_eq!(
            said(&text.replace("joint = 4", "joint = 5")),
            "model, [[effect]] 2, joint: 5 is not 1 to 4"
        );
        assert!(said(&text.replace("\"prismatic\"", "\"linear\"")).contains("`linear` is neither"));
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
        let unknown = error("effect = \"joint_offset\"", "effect = \"joint_ofset\"");
        assert_eq!(unknown, "model, [[effect]] 1, effect: `joint_ofset` is not known");
    }
}

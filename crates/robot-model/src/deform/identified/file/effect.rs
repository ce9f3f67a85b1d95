//! One `[[effect]]` of the file: which effect of which joint, its values with their sigmas, and how it grows.
//!
//! Knows nothing of the rest of the file.

use super::text::{list, number, quoted};
use crate::deform::identified::error::ModelError;
use crate::deform::identified::table_reader::TableReader;
use crate::deform::identified::{Estimate, Growth, PayloadScaling, Term};
use crate::deform::{EffectKind, GrowthLaw};
use crate::robot::{Axis, JointKind, Joints};
use crate::units::{deg_from_rad, rad_from_deg};
use std::fmt::Write as _;

/// More teeth than this has no gear.
const MOST_PERIODS: u32 = 1000;

/// Keys of a spectrum's values.
const SPECTRUM: [&str; 2] = ["sin_deg", "cos_deg"];

/// Names of [`PayloadScaling`] in the file.
const PAYLOAD_SCALINGS: [(&str, PayloadScaling); 3] = [
    ("where-loaded", PayloadScaling::WhereLoaded),
    ("always", PayloadScaling::Always),
    ("per-kilogram", PayloadScaling::PerKilogram),
];

/// # Errors
/// [`ModelError`] with the key that is wrong.
pub(super) fn read_term(mut keys: TableReader, kinds: &Joints<JointKind>) -> Result<Term, ModelError> {
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
    if kind == EffectKind::JointCoupling && joint == joint_b {
        return Err(keys.wrong("joint_b", "a joint is not coupled to itself".to_owned()));
    }
    // What is loaded there stands at the next joint; beyond the last one there is none.
    let most = kinds.len() - 1;
    if kind == EffectKind::LinkBending && joint.is_some_and(|joint| joint.index() >= most) {
        return Err(keys.wrong("joint", format!("link_bending needs a joint behind the link, 1 to {most}")));
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
        let value = unit.si(keys.number(key)?.unwrap_or(0.0));
        let sigma = keys.number(&format!("sigma_{key}"))?.map(|s| unit.si(s));
        values.push(Estimate { value, sigma });
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

pub(super) fn write_term(out: &mut String, term: &Term, kinds: &Joints<JointKind>) {
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

/// How the joint of a term moves.
fn kind_of(joint: Option<Axis>, kinds: &Joints<JointKind>) -> JointKind {
    joint.and_then(|joint| kinds.get(joint.index())).copied().unwrap_or_default()
}

/// Lists of sines and cosines, sigmas beside them or not.
fn read_spectrum(keys: &mut TableReader) -> Result<Vec<Estimate>, ModelError> {
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
    let value = |k: usize, (values, sigmas): &(Vec<f64>, Vec<f64>)| Estimate {
        value: rad_from_deg(values[k]),
        sigma: sigmas.get(k).map(|s| rad_from_deg(*s)),
    };
    Ok((0..n).flat_map(|k| lists.iter().map(move |list| value(k, list))).collect())
}

fn write_spectrum(out: &mut String, values: &[Estimate]) {
    for (first, key) in SPECTRUM.iter().enumerate() {
        let part: Vec<Estimate> = values.iter().skip(first).step_by(2).copied().collect();
        let degrees: Vec<f64> = part.iter().map(|v| deg_from_rad(v.value)).collect();
        let _ = writeln!(out, "{key} = {}", list(&degrees));
        let sigmas: Option<Vec<f64>> = part.iter().map(|v| v.sigma.map(deg_from_rad)).collect();
        if let Some(sigmas) = sigmas {
            let _ = writeln!(out, "sigma_{key} = {}", list(&sigmas));
        }
    }
}

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

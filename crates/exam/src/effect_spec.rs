//! Effects as a user names them: `joint_compliance:2`, `gear_mesh:3:20`, `joint_coupling:5:6`.

use super::effect::Effect;
use super::rng::Rng;
use super::smooth::SmoothFunction;
use std::f64::consts::TAU;

/// A random function of time is drawn as for a run this long, minutes.
const USUAL_RUN_MIN: f64 = 100.0;

/// Names that can be asked for, with what may follow them.
pub const SYNTAX: [(&str, &str); 27] = [
    ("joint_offset", "JOINT"),
    ("link_geometry", "JOINT"),
    ("joint_compliance", "JOINT"),
    ("link_bending", "LINK"),
    ("base_tilt", ""),
    ("gear_eccentricity", "JOINT"),
    ("gear_second_harmonic", "JOINT"),
    ("gear_mesh", "JOINT:N"),
    ("joint_gain", "JOINT"),
    ("joint_coupling", "JOINT:DRIVEN_JOINT"),
    ("backlash", "JOINT"),
    ("thermal_link_growth", "LINK"),
    ("thermal_joint_drift", "JOINT"),
    ("base_drift", ""),
    ("base_step", "MINUTE"),
    ("tool_drift", ""),
    ("tool_step", "MINUTE"),
    ("joint_step", "JOINT:MINUTE"),
    ("instrument_scale", ""),
    ("payload_mass", ""),
    ("joint_rounding", ""),
    ("swapped_axes", ""),
    ("square_wave", "JOINT:N"),
    ("cable_pull", ""),
    ("local_bump", ""),
    ("cross_term", "JOINT"),
    ("smooth_function", ""),
];

/// What is wrong with an effect as it was named.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum EffectSpecError {
    /// No effect has this name.
    #[error("there is no effect named {0}")]
    Unknown(String),
    /// A number is missing, is none or lies outside what it may be.
    #[error("{name} is written {name}:{syntax}, with joints from 1 to 6; {given} is not")]
    Syntax {
        /// Name of the effect.
        name: &'static str,
        /// What follows its name.
        syntax: &'static str,
        /// The specification as written.
        given: String,
    },
}

/// The effect that `text` names; what it leaves open (phases, directions) is drawn.
///
/// # Errors
/// [`EffectSpecError`], naming what was written and what would be right.
pub fn parse(text: &str, rng: &mut Rng) -> Result<Effect, EffectSpecError> {
    let mut parts = text.split(':');
    let wanted = parts.next().unwrap_or_default().trim();
    let (name, syntax) = SYNTAX
        .into_iter()
        .find(|(name, _)| *name == wanted)
        .ok_or_else(|| EffectSpecError::Unknown(wanted.to_owned()))?;
    let wrong = || EffectSpecError::Syntax { name, syntax, given: text.to_owned() };
    let numbers: Vec<u32> = parts.map(|p| p.trim().parse().map_err(|_| wrong())).collect::<Result<_, _>>()?;
    let expected = if syntax.is_empty() { 0 } else { syntax.split(':').count() };
    if numbers.len() != expected {
        return Err(wrong());
    }
    let joint =
        |k: usize| numbers.get(k).filter(|j| (1..=6).contains(*j)).map(|j| *j as usize).ok_or_else(wrong);
    let n = |k: usize| numbers.get(k).filter(|n| (1..=320).contains(*n)).copied().ok_or_else(wrong);
    let phase_rad = rng.uniform(0.0, TAU);
    let raw: [f64; 6] = std::array::from_fn(|_| rng.normal());
    let norm = raw.iter().map(|x| x * x).sum::<f64>().sqrt();
    let direction = raw.map(|x| x / norm);
    let across = [0.6, 0.48, 0.64];
    Ok(match name {
        "joint_offset" => Effect::JointOffset { joint: joint(0)? },
        "link_geometry" => Effect::LinkGeometry { joint: joint(0)?, direction },
        "joint_compliance" => Effect::JointCompliance { joint: joint(0)? },
        "link_bending" if joint(0)? == 6 => return Err(wrong()),
        "link_bending" => Effect::LinkBending { joint: joint(0)? },
        "base_tilt" => Effect::BaseTilt,
        "gear_eccentricity" => Effect::GearEccentricity { joint: joint(0)?, phase_rad },
        "gear_second_harmonic" => Effect::GearSecondHarmonic { joint: joint(0)?, phase_rad },
        "gear_mesh" => Effect::GearMesh { joint: joint(0)?, n: n(1)?, phase_rad },
        "joint_gain" => Effect::JointGain { joint: joint(0)? },
        "joint_coupling" => Effect::JointCoupling { joint: joint(0)?, joint_b: joint(1)? },
        "backlash" => Effect::Backlash { joint: joint(0)?, holding_n_m: rng.log_uniform(2.0, 200.0) },
        "thermal_link_growth" => Effect::ThermalLinkGrowth { joint: joint(0)? },
        "thermal_joint_drift" => Effect::ThermalJointDrift { joint: joint(0)? },
        "base_drift" => Effect::BaseDrift { direction },
        "base_step" => Effect::BaseStep { t0_min: f64::from(numbers[0]), direction },
        "tool_drift" => Effect::ToolDrift { direction },
        "tool_step" => Effect::ToolStep { t0_min: f64::from(numbers[0]), direction },
        "joint_step" => Effect::JointStep {
            joint: joint(0)?,
            t0_min: numbers.get(1).copied().map_or_else(|| Err(wrong()), |minute| Ok(f64::from(minute)))?,
        },
        "instrument_scale" => Effect::InstrumentScale,
        "payload_mass" => Effect::PayloadMass,
        "joint_rounding" => Effect::JointRounding,
        "swapped_axes" => Effect::SwappedAxes,
        "square_wave" => Effect::SquareWave { joint: joint(0)?, n: n(1)?, phase_rad },
        "cable_pull" => Effect::CablePull { direction: across },
        "local_bump" => Effect::LocalBump { center_m: [0.5, 0.1, 0.4], radius_m: 0.18, direction: across },
        "cross_term" => Effect::CrossTerm { joint: joint(0)?, a: 2, b: 3 },
        _ => Effect::SmoothFunction(SmoothFunction::draw(rng, USUAL_RUN_MIN)),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_is_understood_with_its_numbers_and_no_other() {
        let mut rng = Rng::new(0, 0);
        for (name, syntax) in SYNTAX {
            let numbers: String = syntax.split(':').filter(|f| !f.is_empty()).map(|_| ":3").collect();
            let chosen = parse(&format!("{name}{numbers}"), &mut rng).unwrap();
            if let Some(official) = chosen.name() {
                assert_eq!(official, name);
            }
            assert!(matches!(
                parse(&format!("{name}{numbers}:1"), &mut rng),
                Err(EffectSpecError::Syntax { .. })
            ));
        }
        assert!(matches!(parse("joint_ofset:2", &mut rng), Err(EffectSpecError::Unknown(_))));
        assert!(matches!(parse("joint_offset:7", &mut rng), Err(EffectSpecError::Syntax { .. })));
        assert!(matches!(parse("joint_offset:two", &mut rng), Err(EffectSpecError::Syntax { .. })));
    }
}

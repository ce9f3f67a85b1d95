//! Effects as a user names them: `joint_compliance:2`, `gear_mesh:3:20`, `joint_coupling:5:6`.

use super::effect::Effect;
use super::harmonics::Harmonics;
use super::rng::Rng;
use super::smooth::{Domain, MovedPart, SmoothFunction};
use std::f64::consts::TAU;

/// A random function of time is drawn as for a run this long, minutes.
const USUAL_RUN_MIN: f64 = 100.0;

/// Direction of a shift that has parts along all three axes.
const ACROSS: [f64; 3] = [0.6, 0.48, 0.64];

/// Lines of gears that are asked for are pure sines.
const PURE: Harmonics = Harmonics::NONE;

/// Effects that can be asked for, with what may follow their names; what is written or drawn takes the place of their values.
const TEMPLATES: [(Effect, &str); 27] = [
    (Effect::JointOffset { joint: 1 }, "JOINT"),
    (Effect::LinkGeometry { joint: 1, direction: [0.0; 6] }, "JOINT"),
    (Effect::JointCompliance { joint: 1 }, "JOINT"),
    (Effect::LinkBending { joint: 1 }, "LINK"),
    (Effect::BaseTilt, ""),
    (Effect::GearEccentricity { joint: 1, phase_rad: 0.0, harmonics: PURE }, "JOINT"),
    (Effect::GearSecondHarmonic { joint: 1, phase_rad: 0.0, harmonics: PURE }, "JOINT"),
    (Effect::GearMesh { joint: 1, n: 1, phase_rad: 0.0, harmonics: PURE }, "JOINT:N"),
    (Effect::JointGain { joint: 1 }, "JOINT"),
    (Effect::JointCoupling { joint: 1, joint_b: 2 }, "JOINT:DRIVEN_JOINT"),
    (Effect::Backlash { joint: 1, holding_n_m: 0.0 }, "JOINT"),
    (Effect::ThermalLinkGrowth { joint: 1 }, "LINK"),
    (Effect::ThermalJointDrift { joint: 1 }, "JOINT"),
    (Effect::BaseDrift { direction: [0.0; 6] }, ""),
    (Effect::BaseStep { t0_min: 0.0, direction: [0.0; 6] }, "MINUTE"),
    (Effect::ToolDrift { direction: [0.0; 6] }, ""),
    (Effect::ToolStep { t0_min: 0.0, direction: [0.0; 6] }, "MINUTE"),
    (Effect::JointStep { joint: 1, t0_min: 0.0 }, "JOINT:MINUTE"),
    (Effect::InstrumentScale, ""),
    (Effect::PayloadMass, ""),
    (Effect::JointRounding, ""),
    (Effect::SwappedAxes, ""),
    (Effect::SquareWave { joint: 1, n: 1, phase_rad: 0.0 }, "JOINT:N"),
    (Effect::CablePull { direction: ACROSS }, ""),
    (Effect::LocalBump { center_m: [0.5, 0.1, 0.4], radius_m: 0.18, direction: ACROSS }, ""),
    (Effect::CrossTerm { joint: 1, a: 2, b: 3 }, "JOINT"),
    (Effect::SmoothFunction(FUNCTION), ""),
];

/// Stands for the function that is drawn.
const FUNCTION: SmoothFunction =
    SmoothFunction { domain: Domain::Time, moves: MovedPart::Point, length: 1.0, seed: 0 };

/// Names that can be asked for, with what may follow them.
pub const SYNTAX: [(&str, &str); TEMPLATES.len()] = {
    let mut all = [("", ""); TEMPLATES.len()];
    let mut i = 0;
    while i < all.len() {
        all[i] = (TEMPLATES[i].0.spec_name(), TEMPLATES[i].1);
        i += 1;
    }
    all
};

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
    let (template, syntax) = TEMPLATES
        .into_iter()
        .find(|(template, _)| template.spec_name() == wanted)
        .ok_or_else(|| EffectSpecError::Unknown(wanted.to_owned()))?;
    let name = template.spec_name();
    let wrong = || EffectSpecError::Syntax { name, syntax, given: text.to_owned() };
    let numbers: Vec<u32> = parts.map(|p| p.trim().parse().map_err(|_| wrong())).collect::<Result<_, _>>()?;
    let expected = if syntax.is_empty() { 0 } else { syntax.split(':').count() };
    if numbers.len() != expected {
        return Err(wrong());
    }
    let joint =
        |k: usize| numbers.get(k).filter(|j| (1..=6).contains(*j)).map(|j| *j as usize).ok_or_else(wrong);
    let n = |k: usize| numbers.get(k).filter(|n| (1..=320).contains(*n)).copied().ok_or_else(wrong);
    let (phase_rad, harmonics) = (rng.uniform(0.0, TAU), PURE);
    let raw: [f64; 6] = std::array::from_fn(|_| rng.normal());
    let norm = raw.iter().map(|x| x * x).sum::<f64>().sqrt();
    let direction = raw.map(|x| x / norm);
    let minute = |k: usize| numbers.get(k).copied().map(f64::from).ok_or_else(wrong);
    Ok(match template {
        Effect::JointOffset { .. } => Effect::JointOffset { joint: joint(0)? },
        Effect::LinkGeometry { .. } => Effect::LinkGeometry { joint: joint(0)?, direction },
        Effect::JointCompliance { .. } => Effect::JointCompliance { joint: joint(0)? },
        Effect::LinkBending { .. } if joint(0)? == 6 => return Err(wrong()),
        Effect::LinkBending { .. } => Effect::LinkBending { joint: joint(0)? },
        Effect::GearEccentricity { .. } => {
            Effect::GearEccentricity { joint: joint(0)?, phase_rad, harmonics }
        }
        Effect::GearSecondHarmonic { .. } => {
            Effect::GearSecondHarmonic { joint: joint(0)?, phase_rad, harmonics }
        }
        Effect::GearMesh { .. } => Effect::GearMesh { joint: joint(0)?, n: n(1)?, phase_rad, harmonics },
        Effect::JointGain { .. } => Effect::JointGain { joint: joint(0)? },
        Effect::JointCoupling { .. } => Effect::JointCoupling { joint: joint(0)?, joint_b: joint(1)? },
        Effect::Backlash { .. } => {
            Effect::Backlash { joint: joint(0)?, holding_n_m: rng.log_uniform(2.0, 200.0) }
        }
        Effect::ThermalLinkGrowth { .. } => Effect::ThermalLinkGrowth { joint: joint(0)? },
        Effect::ThermalJointDrift { .. } => Effect::ThermalJointDrift { joint: joint(0)? },
        Effect::BaseDrift { .. } => Effect::BaseDrift { direction },
        Effect::BaseStep { .. } => Effect::BaseStep { t0_min: minute(0)?, direction },
        Effect::ToolDrift { .. } => Effect::ToolDrift { direction },
        Effect::ToolStep { .. } => Effect::ToolStep { t0_min: minute(0)?, direction },
        Effect::JointStep { .. } => Effect::JointStep { joint: joint(0)?, t0_min: minute(1)? },
        Effect::SquareWave { .. } => Effect::SquareWave { joint: joint(0)?, n: n(1)?, phase_rad },
        Effect::CrossTerm { a, b, .. } => Effect::CrossTerm { joint: joint(0)?, a, b },
        Effect::SmoothFunction(_) => Effect::SmoothFunction(SmoothFunction::draw(rng, USUAL_RUN_MIN)),
        Effect::BaseTilt
        | Effect::InstrumentScale
        | Effect::PayloadMass
        | Effect::JointRounding
        | Effect::SwappedAxes
        | Effect::RowFault { .. }
        | Effect::CablePull { .. }
        | Effect::LocalBump { .. } => template,
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
            assert_eq!(chosen.spec_name(), name);
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

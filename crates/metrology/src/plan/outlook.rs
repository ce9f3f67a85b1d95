//! What can be expected of a plan: how exactly each effect will be known, and which pairs stay confounded.

use super::information::{APART, Information, Reduced};
use super::lines::GearLines;
use crate::diagnose::SizeUnit;
use inference::search::NAMED_NATS;
use inference::signature::{Signature, Signatures};
use robot_model::deform::EffectKind;
use robot_model::robot::Axis;

/// Squared signal over noise under which nothing will ever be seen of an effect of usual size.
const HIDDEN: f64 = 0.01;

/// Share of an effect's signal from which on another with more parameters contains it.
const CONTAINED: f64 = 0.97;

/// An effect by name.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
pub struct EffectName {
    /// Kind of the effect, which names it.
    pub effect: EffectKind,
    /// Joint that it sits in, or link; `None` for effects of the whole arm, its base or its target.
    pub joint: Option<Axis>,
    /// The joint that is driven.
    pub joint_b: Option<Axis>,
}

/// How exactly an effect will be known.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Parameter {
    /// The effect and its joint.
    #[serde(flatten)]
    pub of: EffectName,
    /// Unit of the sizes.
    pub unit: SizeUnit,
    /// Size that the effect usually has.
    pub usual: f64,
    /// Expected standard deviation, it being the only cause; of an effect with a phase that of the phase that is told least.
    pub sigma: f64,
    /// From this size on it will be named.
    pub seen_from: f64,
}

/// Two effects that these measurements will not tell apart at their usual size.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Confounded {
    /// The effect that is at work.
    pub a: EffectName,
    /// The one it is taken for.
    pub b: EffectName,
    /// Squared signal over noise that is left between them; 20 tell them apart.
    pub separation: f64,
    /// Share of the first's signal that the second takes.
    pub r2: f64,
    /// The second has more parameters and can do all that the first does: the simpler one is named.
    pub contained: bool,
}

/// What can be expected.
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize)]
pub struct Outlook {
    /// One for each effect and joint that leaves a signal.
    pub parameters: Vec<Parameter>,
    /// Pairs that stay confounded, hardest first.
    pub confounded: Vec<Confounded>,
    /// Effects of which nothing will be seen: they lie inside base, target and the arm's tolerances.
    pub hidden: Vec<EffectName>,
    /// Lines of the gears, joint by joint.
    pub lines: Vec<GearLines>,
}

/// The outlook of measurements with these signatures at noise `sigma_m`.
#[must_use]
pub(super) fn outlook(signatures: &Signatures, sigma_m: f64) -> Outlook {
    let information = Information::of(&signatures.rows, signatures.width, sigma_m);
    let Some(reduced) = information.reduced(signatures) else { return Outlook::default() };
    let effects = &signatures.effects;
    let mut out = Outlook::default();
    let mut seen = Vec::new();
    for (a, effect) in effects.iter().enumerate() {
        let alone = reduced.separation(a, None);
        if alone < HIDDEN {
            out.hidden.push(named(effect));
            continue;
        }
        seen.push(a);
        let told = if has_phase(effect) { reduced.least_separation(a).max(HIDDEN) } else { alone };
        let sigma = effect.usual.abs() / told.sqrt();
        out.parameters.push(Parameter {
            of: named(effect),
            unit: effect.unit,
            usual: effect.usual.abs(),
            sigma,
            seen_from: sigma * (2.0 * NAMED_NATS).sqrt(),
        });
    }
    for &a in &seen {
        for &b in seen.iter().filter(|b| **b != a) {
            out.confounded.extend(confounded(&reduced, effects, a, b));
        }
    }
    let hardest =
        |x: &Confounded, y: &Confounded| y.r2.total_cmp(&x.r2).then(x.separation.total_cmp(&y.separation));
    sorting::by(&mut out.confounded, |x, y| x.contained.cmp(&y.contained).then(hardest(x, y)));
    out
}

fn confounded(reduced: &Reduced<'_>, effects: &[Signature], a: usize, b: usize) -> Option<Confounded> {
    let alone = reduced.separation(a, None);
    let separation = reduced.separation(a, Some(b));
    // What is too small to be seen at all is not confounded with anything.
    let r2 = 1.0 - separation / alone;
    (alone >= APART && separation < APART).then(|| Confounded {
        contained: effects[b].width > effects[a].width && r2 > CONTAINED,
        a: named(&effects[a]),
        b: named(&effects[b]),
        separation,
        r2,
    })
}

/// Whether it is a sine and a cosine.
fn has_phase(effect: &Signature) -> bool {
    let is_line = matches!(effect.effect, EffectKind::GearEccentricity | EffectKind::GearSecondHarmonic);
    is_line && effect.width == 2
}

fn named(effect: &Signature) -> EffectName {
    EffectName { effect: effect.effect, joint: effect.joint, joint_b: effect.joint_b }
}

//! What stands in one place of the model, cause by cause: all forms of one effect in one joint together.

use crate::diagnose::effects::{self, Candidate};
use crate::diagnose::evidence::Background;
use crate::diagnose::model::Model;
use crate::diagnose::search::{Chosen, Hypothesis, Slot, flat};

/// A rival this likely, against the likeliest, cannot be told apart.
const RIVAL: f64 = 0.03;
/// Candidates that together are this likely among the causes make up the set that cannot be told apart.
const CREDIBLE: f64 = 0.95;

/// A cause over all its forms in one slot.
pub struct Group {
    /// Its likeliest form.
    pub best: usize,
    /// Of all its forms.
    pub probability: f64,
    /// ln evidence of that form over nothing.
    pub gain_nats: f64,
}

/// The causes of a slot, likeliest first.
#[must_use]
pub fn groups(model: &Model<'_>, slot: &Slot) -> Vec<Group> {
    let mut found: Vec<(Key, Group)> = Vec::new();
    for (hypothesis, probability, reached) in &slot.ranked {
        let Hypothesis::Effect(c) = hypothesis else { continue };
        let this = key(&model.library.candidates[*c]);
        match found.iter_mut().find(|(k, _)| *k == this) {
            Some((_, group)) => group.probability += probability,
            None => found.push((
                this,
                Group {
                    best: *c,
                    probability: *probability,
                    gain_nats: reached.log_evidence - slot.null.log_evidence,
                },
            )),
        }
    }
    let mut groups: Vec<Group> = found.into_iter().map(|(_, g)| g).collect();
    groups.sort_by(|a, b| b.probability.total_cmp(&a.probability));
    groups
}

/// Joins to the likeliest cause the rival that holds it as a special case: what the rival adds is not needed, and
/// the simpler of two nested explanations is the one to name.
pub fn join_nested(model: &Model<'_>, groups: &mut Vec<Group>) {
    let Some(first) = groups.first() else { return };
    let simple = key(&model.library.candidates[first.best]);
    let nests = |g: &Group| {
        let rich = key(&model.library.candidates[g.best]);
        let name = |effect: usize| effects::LIBRARY[effect].name();
        (name(simple.0), name(rich.0)) == ("joint_offset", "thermal_joint_drift") && simple.1 == rich.1
    };
    let more: f64 = groups.iter().filter(|g| nests(g)).map(|g| g.probability).sum();
    groups.retain(|g| !nests(g));
    groups[0].probability += more;
}

/// The likeliest groups that together make up nearly all of the causes' probability.
#[must_use]
pub fn credible(groups: &[Group]) -> Vec<&Group> {
    let total: f64 = groups.iter().map(|g| g.probability).sum();
    let first = groups.first().map_or(0.0, |g| g.probability);
    let mut sum = 0.0;
    groups
        .iter()
        .take_while(|g| {
            let more = sum < CREDIBLE * total && g.probability >= RIVAL * first;
            sum += g.probability;
            more
        })
        .collect()
}

/// Every hypothesis in the place `without` of the model (none: beside it), and how much geometry is needed there.
#[must_use]
pub fn scan(model: &Model<'_>, chosen: &[Chosen], without: Option<usize>) -> (Slot, f64) {
    let atoms: Vec<usize> = (0..model.design.atoms()).collect();
    let background = Background::new(&model.design, &atoms, &flat(chosen, without), model.noise);
    let taken: Vec<usize> =
        chosen.iter().enumerate().filter(|(i, _)| Some(*i) != without).map(|(_, c)| c.candidate).collect();
    (model.library.scan(&background, &atoms, &taken), background.geometry_gain())
}

/// What forms of one cause share.
type Key = (usize, Option<usize>, Option<usize>);

fn key(c: &Candidate) -> Key {
    (c.effect, c.form.joint, c.form.joint_b)
}

//! From which size on an effect would have been seen in these data, and which effects would have to be larger than they ever are.

use super::model::FittedModel;
use super::outcome::{Detectable, Untestable};
use super::visible::INVISIBLE;
use inference::design::Products;
use inference::effects::Candidate;
use inference::evidence::NuisanceModel;
use inference::search::{NAMED_NATS, cause_columns};
use robot_model::deform::EffectKind;
use robot_model::robot::Axis;

/// What of each effect and joint would have been seen.
pub(super) struct DetectionLimits {
    /// The size that would have passed the alarm.
    pub detectable: Vec<Detectable>,
    /// What would have passed it far beyond its usual size only: these poses hardly move the tool by it beside base and target.
    pub untestable: Vec<Untestable>,
}

/// From when on one variant of an effect is seen.
enum Limit {
    /// From this size on.
    Size(Detectable),
    /// Not beside the causes that were found, which it is a rival of: the poses do show it.
    Rival,
    /// From a size on that the effect does not have.
    FarBeyond(Detectable),
}

impl DetectionLimits {
    /// Of each effect and joint beside the causes that were found.
    #[must_use]
    pub(super) fn of(fitted: &FittedModel<'_>) -> Self {
        let sight = DetectionProblem::new(fitted);
        let mut detectable: Vec<Detectable> = Vec::new();
        let mut shown: Vec<Asked> = Vec::new();
        let mut far: Vec<(Detectable, &str)> = Vec::new();
        let library = &fitted.workspace.library;
        for (candidate, products) in library.candidates.iter().zip(&library.products) {
            let asked = (candidate.kind, candidate.variant.joint);
            let is_rival_alone = candidate.kind == EffectKind::JointCompliance && candidate.of_all_joints();
            if is_rival_alone || candidate.variant.joint_b.is_some() || shown.contains(&asked) {
                continue;
            }
            match sight.limit(candidate, products) {
                Some(Limit::Size(from)) => {
                    detectable.push(from);
                    shown.push(asked);
                }
                Some(Limit::Rival) => shown.push(asked),
                Some(Limit::FarBeyond(from)) => far.push((from, candidate.effect().usual_size())),
                None => {}
            }
        }
        // What one variant hides another may show.
        far.retain(|(hidden, _)| !shown.contains(&(hidden.effect, hidden.joint)));
        Self { detectable, untestable: untestable(&far, &shown) }
    }
}

/// An effect and where it sits.
type Asked = (EffectKind, Option<Axis>);

/// What the poses show of an effect beside base and target, with the causes that were found and without.
struct DetectionProblem<'a> {
    fitted: &'a FittedModel<'a>,
    groups: Vec<usize>,
    beside_causes: NuisanceModel,
    alone: Option<NuisanceModel>,
}

impl<'a> DetectionProblem<'a> {
    fn new(fitted: &'a FittedModel<'a>) -> Self {
        let FittedModel { model, workspace, .. } = fitted;
        let groups = workspace.design.all_groups();
        let also = cause_columns(&model.chosen, None);
        let beside = |causes: &[usize]| NuisanceModel::new(&workspace.design, &groups, causes, model.noise);
        let (beside_causes, alone) = (beside(&also), (!also.is_empty()).then(|| beside(&[])));
        Self { fitted, groups, beside_causes, alone }
    }

    /// From when on a variant is seen; `None` where it leaves no signal beside base and target.
    fn limit(&self, candidate: &Candidate, products: &Products) -> Option<Limit> {
        let peak = &self.fitted.model.peak;
        // Half the squared signal over noise must pass the alarm and the price of its parameters.
        let needed = (2.0 * NAMED_NATS).sqrt() * peak.sigma_m;
        let sums = products.sum(&self.groups);
        let sigmas_beside = |nuisance: &NuisanceModel| {
            let strength = nuisance.strength(&nuisance.project(&sums), peak.geometry_ratio);
            // Less is what rounding leaves of a signal that lies wholly in base and target.
            (strength * strength > INVISIBLE * sums.own[(0, 0)]).then(|| needed / strength)
        };
        let prior_sigma = candidate.prior_sigma.first().copied().unwrap_or(0.0);
        let of_size = |sigmas: f64| Detectable {
            effect: candidate.kind,
            joint: candidate.variant.joint,
            size: sigmas * prior_sigma * candidate.display_scale,
            unit: candidate.unit(),
        };
        let furthest = candidate.effect().furthest_sigmas();
        let sigmas = sigmas_beside(&self.beside_causes)?;
        if sigmas <= furthest {
            return Some(Limit::Size(of_size(sigmas)));
        }
        let sigmas = self.alone.as_ref().map_or(Some(sigmas), sigmas_beside)?;
        Some(if sigmas > furthest { Limit::FarBeyond(of_size(sigmas)) } else { Limit::Rival })
    }
}

/// One entry for each effect, with the least of its sizes: of some of its joints where others are shown, of all of it otherwise.
fn untestable(far: &[(Detectable, &str)], shown: &[Asked]) -> Vec<Untestable> {
    let mut entries: Vec<Untestable> = Vec::new();
    for (Detectable { effect, unit, .. }, usual) in far {
        if entries.iter().any(|entry| entry.effect == *effect) {
            continue;
        }
        let alike = || far.iter().map(|(from, _)| from).filter(|from| from.effect == *effect);
        let least = alike().map(|from| from.size).fold(f64::INFINITY, f64::min);
        let is_shown_elsewhere = shown.iter().any(|(kind, _)| kind == effect);
        let mut joints: Vec<Axis> =
            alike().filter_map(|from| from.joint).filter(|_| is_shown_elsewhere).collect();
        sorting::ascending(&mut joints);
        joints.dedup();
        let reason = format!("these poses would show it from {least:.1e} {unit} on only; usual is {usual}");
        entries.push(Untestable { effect: *effect, joints, reason, lacks_channel: false });
    }
    entries
}

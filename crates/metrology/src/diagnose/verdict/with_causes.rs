//! The verdict on a model that has causes: which stand in each of its places, and whether structure of no cause overrules them.

use super::cause_group::{
    CauseGroup, OpenSlot, cause_groups, credible, doubt_shapes, join_nested, line_among_many, scan,
};
use super::doubt::{Doubt, EVEN, LIKELIER_THAN_NOT, beam, share_beam};
use super::hidden_load::{HiddenLoad, in_place_of_steps};
use super::judgement::{Decision, Judgement};
use super::listing::{listed, rejected};
use super::noise::{MAX_RESIDUAL_SHARE, Scatter, Slowness, slowness};
use super::overtones::overtones;
use super::size::{cause, cause_unfitted, moved_m, rms, total_rms_m};
use super::slip::share_slip;
use super::springs_together::share_springs;
use super::structure::{
    MANY_CAUSES, NEGLIGIBLE_STRUCTURE_RATIO, alternative_share, gp_alternative_share, left_over_m,
    likeliest_structure, loaded_play, location_of_gp, odds_over_causes, over_time, region_of, shape_of_lines,
    structure_odds, varying_cause,
};
use super::twins::{fit_beam, fit_links_scale};
use super::wording::{
    OR_BALANCING, OR_LOAD, describe, in_short, one_beam_reason, only_missing, structure_reason,
    switched_reason,
};
use crate::diagnose::model::{FittedModel, Workspace};
use crate::diagnose::outcome::{Location, Verdict};
use inference::cause::Cause;
use inference::evidence::NuisanceModel;
use inference::gear_lines::AngleSpectra;
use inference::gp_alternative::GpAlternative;
use inference::missing_channel::MissingChannel;
use inference::search::{ChosenCause, Hypothesis, HypothesisRanking};
use robot_model::deform::EffectKind;
use robot_model::robot::Axis;
use statistics::ALARM_NATS;

/// Structure of no cause that is this likely beside the causes makes them uncertain; likelier than they, it wins.
const GP_ALTERNATIVE_SHARE: f64 = 0.2;
/// A set larger than this, with structure of no cause as likely, is no set.
const LARGE_SET: usize = 6;
/// More moments than this at which something jumped are no knocks: something was switched.
const MOST_STEPS: usize = 2;

/// The judgement on a model of `chosen` causes, beside which `rest` of the hypotheses stand.
pub(super) fn with_causes(
    fitted: &mut FittedModel<'_>,
    chosen: &[ChosenCause],
    rest: &HypothesisRanking,
    scatter: Scatter,
) -> Judgement {
    let mut found = CausesFound::default();
    let overtones = overtones(fitted, chosen);
    for slot in (0..chosen.len()).filter(|slot| !overtones.contains(slot)) {
        found.add_slot(fitted, chosen, slot);
    }
    let load = in_place_of_steps(fitted, chosen);
    if let Some(load) = &load {
        load.doubt(&mut found.causes);
        found.has_open_slot |= load.is_in_doubt();
    }
    let structure = StructureBeside::of(fitted, chosen, rest, &found);
    if !structure.overrules {
        found.share_with_structure();
    }
    let mut causes = listed(std::mem::take(&mut found.causes));
    fit_links_scale(fitted.linear, &mut causes);
    let alternatives = rejected(std::mem::take(&mut found.alternatives), &causes);
    let moved_m = moved_m(fitted, chosen);
    let of_causes = Location {
        joint: causes.first().and_then(|c| c.joint),
        time: causes.first().map(|c| c.time),
        region: region_of(fitted.linear, &moved_m),
    };
    let slowness = slowness(fitted, chosen);
    let outcome = load
        .as_ref()
        .and_then(|load| load.outcome(fitted, structure.log_odds))
        .or_else(|| structure.outcome(fitted, &of_causes))
        .or_else(|| slow_structure(fitted, chosen, slowness, &structure, &moved_m))
        .or_else(|| switched(fitted, chosen))
        .or_else(|| comparable_scatter(fitted, scatter, slowness, &structure, &of_causes))
        .or_else(|| wandering(fitted, slowness, &causes));
    let Decision { verdict, reason, location, missing_channel } =
        outcome.unwrap_or_else(|| found.decision(&causes, load.as_ref(), of_causes));
    Judgement {
        verdict,
        reason,
        causes,
        alternatives,
        location,
        missing_channel,
        open: found.open,
        reduced_chi_square: None,
    }
}

/// The causes of all slots, as they are found slot by slot.
#[derive(Default)]
struct CausesFound {
    causes: Vec<Cause>,
    /// Causes that were rejected in their slots.
    alternatives: Vec<Cause>,
    open: Vec<OpenSlot>,
    /// Slots that are needed beside the others.
    needed: usize,
    /// Of these, slots with one cause that stands clear of all else.
    clear: usize,
    /// Whether one of these has no cause that is likelier than not, or two of one shape.
    has_open_slot: bool,
    /// Slots whose causes structure of no cause could replace.
    replaceable: Vec<usize>,
    /// The likeliest structure in the last of these.
    replacement: Option<usize>,
    /// The candidates that are named already.
    named: Vec<usize>,
    /// Links that are one beam, of which either is named.
    beams: Vec<[Axis; 2]>,
    /// What the angles measured say of lines.
    spectra: AngleSpectra,
}

impl CausesFound {
    /// What may stand in slot `i` of the model.
    fn add_slot(&mut self, fitted: &mut FittedModel<'_>, chosen: &[ChosenCause], i: usize) {
        let candidates = &fitted.workspace.library.candidates;
        if chosen.len() > MANY_CAUSES && candidates[chosen[i].candidate].variant.n.is_some() {
            let line = line_among_many(fitted, chosen, i, &mut self.spectra);
            if line.probability < LIKELIER_THAN_NOT {
                return;
            }
            let lines = self.add_lines(fitted, chosen, i, &line);
            self.needed += 1;
            self.clear += usize::from(lines == 1);
            if lines > 1 {
                self.open.push(OpenSlot::new(Some(i), &[line], 1));
            }
            return;
        }
        let ranking = scan(fitted, chosen, Some(i)).ranking;
        let cause_groups = groups_of_slot(fitted, chosen, i, &ranking);
        let Some(first) = cause_groups.first() else { return };
        let near = credible(&cause_groups);
        let nothing =
            ranking.ranked.iter().find(|r| r.hypothesis == Hypothesis::Null).map_or(0.0, |r| r.probability);
        if nothing > first.probability.max(gp_alternative_share(&ranking)) {
            // Beside the others it is no longer needed.
            return;
        }
        if is_named(&fitted.workspace, first, &self.named) {
            // The same cause once more, in another variant: what the first leaves of it.
            return;
        }
        self.named.push(first.best);
        self.needed += 1;
        let causes_share: f64 = near.iter().map(|g| g.probability).sum();
        let gp_alternatives = alternative_share(&fitted.workspace, &ranking, first.best, causes_share);
        if gp_alternatives > causes_share || near.len() > LARGE_SET && gp_alternatives > first.probability {
            self.replacement = likeliest_structure(&fitted.workspace, &ranking).map(|s| s.gp_alternative);
            self.replaceable.push(i);
        }
        let doubt = Doubt::of(fitted, first.best);
        self.has_open_slot |= first.probability < LIKELIER_THAN_NOT;
        let mut lines = 0;
        for cause_group in &near {
            lines += self.add_lines(fitted, chosen, i, cause_group);
        }
        self.clear += usize::from(
            lines == 1
                && doubt.is_none()
                && first.probability >= LIKELIER_THAN_NOT
                && gp_alternatives < GP_ALTERNATIVE_SHARE * causes_share,
        );
        let or_balancing = doubt.is_of_balancing();
        self.open.push(OpenSlot { or_balancing, ..OpenSlot::new(Some(i), &cause_groups, near.len()) });
        self.has_open_slot |= doubt.share(&mut self.causes, i + 1);
        self.share_beams(fitted, chosen, i, &near);
        for cause_group in cause_groups.iter().skip(near.len()).take(3) {
            self.alternatives.push(cause_unfitted(&fitted.workspace, cause_group));
        }
    }

    /// Where structure of no cause could stand in the place of causes that stay in the model, it and they are as likely as each other: a list
    /// without them would not say what the model holds.
    fn share_with_structure(&mut self) {
        for slot in self.replaceable.iter().map(|i| i + 1) {
            let mut of_slot: Vec<&mut Cause> = self.causes.iter_mut().filter(|c| c.slot == slot).collect();
            let sum: f64 = of_slot.iter().map(|cause| cause.posterior).sum();
            if sum < EVEN {
                let each = EVEN / of_slot.len() as f64;
                // Probabilities that a double does not hold tell none of them from the others.
                let share = |own: f64| if sum > f64::MIN_POSITIVE { own * (EVEN / sum) } else { each };
                of_slot.iter_mut().for_each(|cause| cause.posterior = share(cause.posterior));
                self.has_open_slot = true;
            }
        }
    }

    /// Names beside each link of slot `i` that bends the one that is one beam with it.
    fn share_beams(
        &mut self,
        fitted: &mut FittedModel<'_>,
        chosen: &[ChosenCause],
        i: usize,
        near: &[&CauseGroup],
    ) {
        for group in near {
            let Some(beam) = beam(fitted, group.best) else { continue };
            share_beam(&mut self.causes, i + 1, beam);
            fit_beam(fitted, chosen, i, group, &mut self.causes);
            self.has_open_slot = true;
            self.beams.push(beam);
        }
    }

    /// Names a cause of slot `i`, a gear's as each of the lines that it may be; their number.
    fn add_lines(
        &mut self,
        fitted: &mut FittedModel<'_>,
        chosen: &[ChosenCause],
        i: usize,
        cause_group: &CauseGroup,
    ) -> usize {
        let lines = cause_group.by_line();
        self.has_open_slot |= lines.len() > 1 && lines[0].probability < LIKELIER_THAN_NOT;
        for line in &lines {
            let found = cause(fitted, chosen, Some(i), line);
            self.causes.push(Cause { slot: i + 1, ..found });
        }
        lines.len()
    }

    /// The verdict that the causes listed are there, where nothing overrules them.
    fn decision(&self, causes: &[Cause], load: Option<&HiddenLoad>, location: Location) -> Decision {
        let has_scale = causes.iter().any(|c| c.effect == EffectKind::InstrumentScale);
        let (verdict, reason) = if causes.is_empty() {
            (Verdict::NothingAboveNoise, "what stood out of the noise did not bear a second look".to_owned())
        } else if self.clear < self.needed.min(2) || has_scale || self.has_open_slot {
            let or_load = load.filter(|load| load.is_in_doubt()).map_or("", |_| OR_LOAD);
            let or_balancing = self.open.iter().find(|slot| slot.or_balancing).map_or("", |_| OR_BALANCING);
            let beams: String = self.beams.iter().map(one_beam_reason).collect();
            let choice = in_short(causes);
            (Verdict::Ambiguous, format!("these data leave a choice: {choice}{or_load}{or_balancing}{beams}"))
        } else if self.needed > 1 {
            (Verdict::Several, format!("{} causes, each needed: {}", self.needed, in_short(causes)))
        } else {
            (Verdict::Explained, causes.first().map(describe).unwrap_or_default())
        };
        Decision { verdict, reason, location, missing_channel: None }
    }
}

/// The causes that may stand in slot `i`, with what those of one shape leave each other.
fn groups_of_slot(
    fitted: &mut FittedModel<'_>,
    chosen: &[ChosenCause],
    i: usize,
    ranking: &HypothesisRanking,
) -> Vec<CauseGroup> {
    let mut groups = cause_groups(&fitted.workspace, ranking);
    join_nested(&fitted.workspace, &mut groups);
    doubt_shapes(&fitted.workspace, &mut groups);
    share_slip(&fitted.workspace, ranking, &mut groups);
    share_springs(fitted, chosen, i, &mut groups);
    groups
}

/// Structure of no cause beside all causes, and whether it overrules them.
struct StructureBeside {
    /// What all causes take together, 3-D rms, metres.
    cause_rms_m: f64,
    /// The structure that is likeliest, in place of causes or beside them.
    gp_alternative: Option<usize>,
    overrules: bool,
    /// ln odds of structure alone over all causes.
    log_odds: f64,
}

impl StructureBeside {
    fn of(
        fitted: &FittedModel<'_>,
        chosen: &[ChosenCause],
        rest: &HypothesisRanking,
        found: &CausesFound,
    ) -> Self {
        let FittedModel { linear, model, workspace } = fitted;
        let cause_rms_m = total_rms_m(fitted, chosen);
        let likeliest = likeliest_structure(workspace, rest);
        let left = likeliest.filter(|s| s.gain_nats > ALARM_NATS);
        let spread = model.visit_spread(&linear.dataset).sqrt();
        let left_rms_m = left.map_or(0.0, |left| spread * left_over_m(rest, left.gp_alternative));
        let odds = odds_over_causes(fitted, chosen);
        let together = chosen.len() > 1 && odds > 0.0;
        // Structure alone that is likelier than the causes with structure beside them; one cause was held against it in its own place,
        // with all that it could be.
        let all = chosen.len() > 1 && odds > likeliest.map_or(0.0, |s| structure_odds(s.gain_nats).max(0.0));
        let shape = shape_of_lines(fitted, chosen)
            .or(varying_cause(workspace, rest))
            .or_else(|| loaded_play(fitted, chosen, rest));
        // Structure that stays small beside the causes does not make them wrong.
        let beside = left.is_some() && left_rms_m < NEGLIGIBLE_STRUCTURE_RATIO * cause_rms_m;
        // Causes that most of them structure could replace are no causes but its parts.
        let lost = &found.replaceable;
        let parts = lost.len() > 1 && 2 * lost.len() > found.needed && left.is_some();
        // Nor does structure that stands where a small one of them would.
        let kept: Vec<ChosenCause> =
            (0..chosen.len()).filter(|i| !lost.contains(i)).map(|i| chosen[i].clone()).collect();
        let kept_rms_m = if lost.is_empty() { cause_rms_m } else { total_rms_m(fitted, &kept) };
        let lost_rms_m = (cause_rms_m.powi(2) - kept_rms_m.powi(2)).max(0.0).sqrt();
        let is_small = lost_rms_m < MAX_RESIDUAL_SHARE * cause_rms_m;
        let replacement = shape.or(found.replacement).filter(|_| !is_small);
        let alone = (replacement.is_some() || together) && !beside || all || parts || shape.is_some();
        Self {
            cause_rms_m,
            gp_alternative: replacement.or(left.map(|left| left.gp_alternative)),
            log_odds: odds,
            overrules: alone || left_rms_m > MAX_RESIDUAL_SHARE * cause_rms_m,
        }
    }

    /// The verdict of structure, where it overrules the causes.
    fn outcome(&self, fitted: &FittedModel<'_>, of_causes: &Location) -> Option<Decision> {
        let FittedModel { linear, model, workspace } = fitted;
        if !self.overrules {
            return None;
        }
        let gp_alternative = self.gp_alternative.or_else(|| {
            let groups = workspace.design.all_groups();
            let bare = NuisanceModel::new(&workspace.design, &groups, &[], model.noise);
            let ranking = workspace.library.rank_gp_alternatives(&bare);
            likeliest_structure(workspace, &ranking).map(|s| s.gp_alternative)
        });
        let timed = linear.dataset.time_min.is_some();
        Some(match gp_alternative {
            Some(k) => {
                let kind = workspace.library.gp_alternatives[k].gp_alternative;
                Decision::structure(structure_reason(kind, timed), location_of_gp(fitted, &[], k))
                    .without(MissingChannel::of(kind, timed))
            }
            None => Decision::structure(String::new(), of_causes.clone()),
        })
    }
}

/// Slow noise that is structure over time, and large against the causes.
fn slow_structure(
    fitted: &FittedModel<'_>,
    chosen: &[ChosenCause],
    slowness: Slowness,
    structure: &StructureBeside,
    moved_m: &[f64],
) -> Option<Decision> {
    let Slowness::Structure { rms_m, noise_known } = slowness else { return None };
    // Where nothing says how much noise there is, slow scatter as large as all that the causes move may be noise.
    let largest_m = match noise_known {
        false => structure.cause_rms_m.max(rms(moved_m)),
        true => MAX_RESIDUAL_SHARE * structure.cause_rms_m,
    };
    (rms_m > largest_m).then(|| wanders(fitted, chosen))
}

/// Scatter that is not slow, and not small against the causes.
fn comparable_scatter(
    fitted: &FittedModel<'_>,
    scatter: Scatter,
    slowness: Slowness,
    structure: &StructureBeside,
    of_causes: &Location,
) -> Option<Decision> {
    let is_slow = matches!(slowness, Slowness::Structure { .. });
    (!is_slow && scatter.is_comparable(fitted, structure.cause_rms_m)).then(|| Decision {
        verdict: Verdict::UnexplainedScatter,
        reason: scatter.reason(&fitted.linear.dataset),
        location: Location { joint: scatter.along.map(|a| a.joint), ..of_causes.clone() },
        missing_channel: only_missing(&fitted.linear.dataset),
    })
}

/// Steps at more moments than knocks come.
fn switched(fitted: &FittedModel<'_>, chosen: &[ChosenCause]) -> Option<Decision> {
    let dataset = &fitted.linear.dataset;
    let mut lines: Vec<u64> = chosen
        .iter()
        .filter_map(|c| fitted.workspace.library.candidates[c.candidate].variant.t0_min())
        // Between two days of measuring instruments are set up anew, however often.
        .filter(|t0| !dataset.is_in_pause(*t0))
        .filter_map(|t0| dataset.line_from(t0))
        .collect();
    sorting::ascending(&mut lines);
    lines.dedup();
    (lines.len() > MOST_STEPS).then(|| {
        Decision::structure(switched_reason(&lines, dataset), over_time(fitted, &[]))
            .without((!dataset.channels.payload).then_some(MissingChannel::Payload))
    })
}

/// Slow structure where no cause is left.
fn wandering(fitted: &FittedModel<'_>, slowness: Slowness, causes: &[Cause]) -> Option<Decision> {
    let is_slow = matches!(slowness, Slowness::Structure { .. });
    (causes.is_empty() && is_slow).then(|| wanders(fitted, &[]))
}

fn wanders(fitted: &FittedModel<'_>, chosen: &[ChosenCause]) -> Decision {
    let timed = fitted.linear.dataset.time_min.is_some();
    Decision::structure(structure_reason(GpAlternative::Time, timed), over_time(fitted, chosen))
        .without(MissingChannel::of(GpAlternative::Time, timed))
}

/// Whether one of the candidates `named` is the same cause as the first of another place: not of steps, which are many, nor of lines.
fn is_named(workspace: &Workspace<'_>, first: &CauseGroup, named: &[usize]) -> bool {
    let this = &workspace.library.candidates[first.best];
    let alone = this.variant.t0_min().is_none() && this.kind != EffectKind::GearMesh;
    alone
        && named.iter().map(|&c| &workspace.library.candidates[c]).any(|other| {
            other.kind == this.kind
                && other.variant.joint == this.variant.joint
                && other.variant.joint_b == this.variant.joint_b
        })
}

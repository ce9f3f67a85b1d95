//! How far a drift's settled size is open because the law by which it settles is: the data weigh its time constants, and each has a size of
//! its own.

use super::fitted_size::size_of;
use crate::diagnose::model::{FittedModel, Workspace};
use inference::evidence::NuisanceModel;
use inference::linear_fit::solve;
use inference::search::{ChosenCause, cause_columns};
use statistics::log_sum;

/// Laws that are less likely do not count.
const NEGLIGIBLE: f64 = 0.003;

/// The standard deviation of the size of cause `at` of `all`, which is `size` under its own law, over all laws and between two time constants;
/// 0 of what is no warm-up over time.
pub(super) fn law_spread(fitted: &mut FittedModel<'_>, all: &[ChosenCause], at: usize, size: f64) -> f64 {
    let own = all[at].candidate;
    let among = among_laws(fitted, all, at);
    let mut square = 0.0;
    for (candidate, share) in among.likely {
        if candidate != own {
            square += share * (size_under(fitted, all, at, candidate) - size).powi(2);
        }
    }
    let [below, above] = among.next.map(|next| next.map(|next| size_under(fitted, all, at, next)));
    // Anywhere between half way to the next and half way to the one before, all as likely.
    let width = (above.unwrap_or(size) - below.unwrap_or(size)) / 2.0;
    (square + width * width / 12.0).sqrt()
}

/// The size of cause `at` of `all` were it `candidate`.
fn size_under(fitted: &mut FittedModel<'_>, all: &[ChosenCause], at: usize, candidate: usize) -> f64 {
    let FittedModel { model, workspace, .. } = fitted;
    let Workspace { design, library, column_index } = workspace;
    let columns = library.columns_in_design(design, column_index, &[candidate]).concat();
    let mut under = all.to_vec();
    under[at] = ChosenCause { candidate, columns: columns.clone(), ..under[at].clone() };
    let fit = solve(design, &design.all_groups(), &under, Some(model.peak.geometry_ratio));
    size_of(&library.candidates[candidate], &columns, &fit, model.peak.sigma_m).0
}

/// The laws beside which one stands, as indices of candidates.
#[derive(Default)]
struct AmongLaws {
    /// Those that are likely, with their shares.
    likely: Vec<(usize, f64)>,
    /// The same law with the next smaller time constant and with the next larger one.
    next: [Option<usize>; 2],
}

/// The laws under which cause `at` of `all` may settle; none of what does not warm up over time.
fn among_laws(fitted: &FittedModel<'_>, all: &[ChosenCause], at: usize) -> AmongLaws {
    let FittedModel { model, workspace, .. } = fitted;
    let Workspace { design, library, .. } = workspace;
    let best = &library.candidates[all[at].candidate];
    let Some(law) = best.warm_up_law() else { return AmongLaws::default() };
    let groups = design.all_groups();
    let nuisance = NuisanceModel::new(design, &groups, &cause_columns(all, Some(at)), model.noise);
    let numbered = || library.candidates.iter().enumerate();
    let of_cause =
        || numbered().filter(|(_, c)| c.warm_up_law().is_some() && c.cause_key() == best.cause_key());
    let weighed: Vec<(usize, f64)> =
        of_cause().map(|(c, _)| (c, library.gain(&nuisance, &groups, c) + library.log_prior[c])).collect();
    let total = log_sum(weighed.iter().map(|(_, weight)| *weight));
    let shares = weighed.into_iter().map(|(c, weight)| (c, (weight - total).exp()));
    let tau_min = law.tau_min().unwrap_or_default();
    let alike = of_cause().filter(|(_, c)| {
        c.variant.refined == best.variant.refined
            && c.warm_up_law().is_some_and(|other| other.is_same_kind(&law))
    });
    let taus: Vec<(usize, f64)> =
        alike.filter_map(|(c, other)| Some((c, other.warm_up_law()?.tau_min()?))).collect();
    let below = taus.iter().filter(|(_, tau)| *tau < tau_min).max_by(|a, b| a.1.total_cmp(&b.1));
    let above = taus.iter().filter(|(_, tau)| *tau > tau_min).min_by(|a, b| a.1.total_cmp(&b.1));
    AmongLaws {
        likely: shares.filter(|(_, share)| *share > NEGLIGIBLE).collect(),
        next: [below, above].map(|next| next.map(|(c, _)| *c)),
    }
}

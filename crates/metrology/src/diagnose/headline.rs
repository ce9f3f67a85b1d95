//! Where most of the gap lies, of findings whose verdict does not say it: a model may take nearly all of a gap that something is left
//! of, and causes that are there may be small beside the geometry.

use super::outcome::{Findings, Verdict};
use inference::cause::Cause;

/// A model that takes this share of the gap's square explains most of it, whatever the verdict says of the rest.
const MOSTLY_EXPLAINED: f64 = 0.9;
/// From this share of the gap's square on a model takes enough of it to say what in it does.
const MOSTLY_TAKEN: f64 = 0.5;
/// A candidate of an unexplained gap leads from this probability on; it is at most one half.
const LEADS: f64 = 0.4;
/// Leading candidates that are named.
const MOST_LEADING: usize = 3;

/// Where most of the gap lies.
#[derive(Clone, Debug, PartialEq)]
pub enum Headline<'a> {
    /// The model takes most of it, although the verdict is that something is not explained.
    MostlyExplained {
        /// Of the gap's square.
        share: f64,
        /// What leads in it, by how much of the gap it is.
        leading: Vec<LeadingCandidate<'a>>,
    },
    /// Small errors of all joints' geometry are more of it than the causes that are named.
    MostlyGeometry {
        /// Of the gap's square.
        share: f64,
    },
}

/// A candidate that leads in what the model explains.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeadingCandidate<'a> {
    /// As it is listed among the causes.
    pub cause: &'a Cause,
    /// What it moves the measured point by beside base and target, mm; where others take some of that back, what of the gap rests on it.
    pub in_gap_mm: f64,
    /// Whether others take some of it back.
    pub is_taken_back: bool,
}

impl Findings {
    /// Where most of the gap lies; `None` where the verdict says it, or nothing can.
    #[must_use]
    pub fn headline(&self) -> Option<Headline<'_>> {
        self.mostly_explained().or_else(|| self.mostly_geometry())
    }

    /// The share of the gap's square that the model takes, where that is most of it although the verdict is that something is not
    /// explained.
    pub(super) fn share_explained(&self) -> Option<f64> {
        let unexplained = matches!(self.verdict, Verdict::UnexplainedStructure | Verdict::UnexplainedScatter);
        let share = 1.0 - self.shrink.ratio?.powi(2);
        (unexplained && share >= MOSTLY_EXPLAINED).then_some(share)
    }

    fn mostly_explained(&self) -> Option<Headline<'_>> {
        let share = self.share_explained()?;
        let gap_mm = self.shrink.before_rms_mm.unwrap_or(f64::INFINITY);
        let leads = self.causes.iter().filter(|cause| cause.posterior >= LEADS);
        let mut leading: Vec<LeadingCandidate<'_>> = leads
            .map(|cause| {
                // What others take back is no part of the gap.
                let is_taken_back = cause.seen_mm() > gap_mm;
                let in_gap_mm = if is_taken_back { cause.of_gap_mm() } else { cause.seen_mm() };
                LeadingCandidate { cause, in_gap_mm, is_taken_back }
            })
            .collect();
        sorting::by(&mut leading, |a, b| b.in_gap_mm.total_cmp(&a.in_gap_mm));
        leading.truncate(MOST_LEADING);
        Some(Headline::MostlyExplained { share, leading })
    }

    fn mostly_geometry(&self) -> Option<Headline<'_>> {
        let s = &self.shrink;
        let (before, after) = (s.before_rms_mm?, s.after_rms_mm?);
        let causes = s.causes_only_rms_mm.filter(|_| self.verdict.names_causes())?;
        let taken = |left: f64| 1.0 - (left / before).powi(2);
        let share = taken(after) - taken(causes).max(0.0);
        (taken(after) >= MOSTLY_TAKEN && share > taken(causes)).then_some(Headline::MostlyGeometry { share })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnose::outcome::ErrorReduction;
    use robot_model::deform::EffectKind;

    fn findings(verdict: Verdict, causes: Vec<Cause>, shrink: ErrorReduction) -> Findings {
        Findings { causes, shrink, ..Findings::without_causes(verdict, "") }
    }

    /// By hand: of a gap of 1 mm .3 are left, 1 - .09 = .91 of its square; a candidate that moves the tool by 3 mm is more than the gap, and
    /// what rests on it counts.
    #[test]
    fn what_leads_is_ranked_by_what_it_is_of_the_gap() {
        let cause = |posterior, rms_mm, of_gap_mm| Cause {
            rms_mm: Some(rms_mm),
            rms_of_gap_mm: Some(of_gap_mm),
            ..Cause::of(EffectKind::Backlash, posterior)
        };
        let causes = vec![cause(0.45, 3.0, 0.2), cause(0.5, 0.4, 0.1), cause(0.3, 0.9, 0.9)];
        let shrink =
            ErrorReduction { ratio: Some(0.3), before_rms_mm: Some(1.0), ..ErrorReduction::default() };
        let unexplained = findings(Verdict::UnexplainedStructure, causes, shrink);
        let Some(Headline::MostlyExplained { share, leading }) = unexplained.headline() else {
            panic!("nine tenths are explained")
        };
        assert!((share - 0.91).abs() < 1e-12);
        let named: Vec<_> = leading.iter().map(|one| (one.in_gap_mm, one.is_taken_back)).collect();
        assert_eq!(named, [(0.4, false), (0.2, true)]);
        let explained = Findings { verdict: Verdict::Explained, ..unexplained };
        assert_eq!(explained.headline(), None);
    }

    /// By hand: 1 mm becomes .2 with the model and .9 with the causes alone: 1 - .04 - (1 - .81) = .77 is geometry.
    #[test]
    fn causes_that_are_small_beside_geometry_are_not_the_headline() {
        let shrink = ErrorReduction {
            before_rms_mm: Some(1.0),
            after_rms_mm: Some(0.2),
            causes_only_rms_mm: Some(0.9),
            ..ErrorReduction::default()
        };
        let found = findings(Verdict::Explained, vec![Cause::of(EffectKind::Backlash, 1.0)], shrink);
        let Some(Headline::MostlyGeometry { share }) = found.headline() else { panic!("it is geometry") };
        assert!((share - 0.77).abs() < 1e-12);
    }
}

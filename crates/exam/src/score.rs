//! The score of a diagnosis against the sealed truth: rates with intervals, as a table of measures.
//!
//! Reads the diagnosis's JSON as any script would; a missing or misspelt field counts as a wrong answer.

use super::answer::Answer;
use super::marking::{
    any_right, confident_and_wrong, false_alarm, finds_a_cause, first_right, gives_a_set, is_harmonic,
    is_weak, marked, names_a_cause, names_effect, rho, says_outside, shrink_share,
};
use super::measure::{Criterion, Measure, wilson90};
use super::truth::{QuestionKind, Truth};

/// A data set's truth, and what was answered.
#[derive(Clone, Debug)]
pub struct AnsweredSet {
    /// What was withheld from the diagnosis.
    pub truth: Truth,
    /// What the diagnosis said.
    pub answer: Answer,
}

/// Counts over all sets.
struct Grader<'a>(&'a [AnsweredSet]);

impl Grader<'_> {
    /// The share of `hit` among the sets that are `asked`.
    fn rate(
        &self,
        criterion: &Criterion,
        asked: impl Fn(&Truth, &Answer) -> bool,
        hit: impl Fn(&Truth, &Answer) -> bool,
    ) -> Measure {
        let asked: Vec<&AnsweredSet> = self.0.iter().filter(|set| asked(&set.truth, &set.answer)).collect();
        let hits = asked.iter().filter(|set| hit(&set.truth, &set.answer)).count();
        let sets = asked.len();
        let value = (sets > 0).then(|| hits as f64 / sets as f64);
        criterion.measure(value, wilson90(hits, sets), sets)
    }

    /// Sets of one effect that was named first.
    fn named_right(&self) -> impl Iterator<Item = &AnsweredSet> {
        self.0
            .iter()
            .filter(|set| set.truth.kind == QuestionKind::One && first_right(&set.truth, &set.answer))
    }

    /// A quantile of the share that the diagnosis takes off of what an oracle takes off.
    fn shrink_quantile(&self, criterion: &Criterion, level: f64) -> Measure {
        let mut shares: Vec<f64> =
            self.named_right().filter_map(|set| shrink_share(&set.truth, &set.answer)).collect();
        sorting::numbers(&mut shares);
        let value = shares.get((level * shares.len().saturating_sub(1) as f64).round() as usize).copied();
        criterion.measure(value, None, shares.len())
    }

    /// How often the interval of the shrink holds what an oracle that knows the effect reaches at other poses: at those measured
    /// the same noise stands in both, and any interval would hold it.
    fn shrink_interval(&self, criterion: &Criterion, asked: impl Fn(&Truth) -> bool) -> Measure {
        self.rate(
            criterion,
            |t, a| {
                let has_interval = a.shrink.is_some_and(|s| s.ci90.is_some());
                let has_oracle = t.oracle_ratio_elsewhere.is_some();
                t.kind == QuestionKind::One
                    && asked(t)
                    && finds_a_cause(a)
                    && first_right(t, a)
                    && has_interval
                    && has_oracle
            },
            |t, a| {
                let interval = a.shrink.and_then(|s| s.ci90).zip(t.oracle_ratio_elsewhere);
                interval.is_some_and(|([low, high], ratio)| (low..=high).contains(&ratio))
            },
        )
    }

    /// Expected calibration error of the first cause's probability, ten bins (Naeini et al. 2015).
    fn calibration(&self) -> Measure {
        let stated: Vec<(f64, bool)> = self
            .0
            .iter()
            .filter(|set| set.truth.kind == QuestionKind::One && names_a_cause(&set.answer))
            .filter_map(|set| {
                let cause = marked(&set.truth, &set.answer).next()?;
                Some((cause.posterior?.clamp(0.0, 1.0), names_effect(&set.truth, 0, cause)))
            })
            .collect();
        let sets = stated.len();
        let error: f64 = (0..10)
            .map(|bin| {
                let inside: Vec<_> =
                    stated.iter().filter(|(p, _)| ((p * 10.0) as usize).min(9) == bin).collect();
                let mean: f64 = inside.iter().map(|(p, _)| p).sum();
                let right = inside.iter().filter(|(_, hit)| *hit).count() as f64;
                (mean - right).abs()
            })
            .sum();
        Criterion::low("calibration error of the stated probability", 0.10, 0.04).measure(
            (sets > 0).then(|| error / sets as f64),
            None,
            sets,
        )
    }

    /// How many causes the sets of causes hold that cannot be told apart.
    fn ambiguity_size(&self) -> Measure {
        let sizes: Vec<usize> = self
            .0
            .iter()
            .filter(|set| gives_a_set(&set.truth, &set.answer))
            .map(|set| marked(&set.truth, &set.answer).count())
            .collect();
        let mean = (!sizes.is_empty()).then(|| sizes.iter().sum::<usize>() as f64 / sizes.len() as f64);
        Criterion::low("mean size of that set", 3.0, 1.5).measure(mean, None, sizes.len())
    }

    /// Whether the right effect is named, where one is at work.
    fn recognition(&self) -> Vec<Measure> {
        vec![
            self.rate(
                &Criterion::high("first answer right, rho >= 1, N >= 60", 0.85, 0.95),
                |t, _| t.kind == QuestionKind::One && rho(t) >= 1.0 && t.n >= 60,
                first_right,
            ),
            self.rate(
                &Criterion::high("first answer right, rho = .5, N = 30", 0.50, 0.62),
                |t, _| is_weak(t),
                first_right,
            ),
            self.rate(
                &Criterion::high("one of the first two right, rho = .5, N = 30", 0.75, 0.86),
                |t, _| is_weak(t),
                |t, a| marked(t, a).take(2).any(|c| names_effect(t, 0, c)),
            ),
        ]
    }

    /// Causes that are named and not there.
    fn false_answers(&self) -> Vec<Measure> {
        vec![
            self.rate(
                &Criterion::low("false alarms without effect", 0.10, 0.05),
                |t, _| t.kind == QuestionKind::None,
                false_alarm,
            ),
            self.rate(
                &Criterion::low("confident and wrong, overall", 0.05, 0.02),
                |t, _| t.kind != QuestionKind::MissingChannel,
                confident_and_wrong,
            ),
            self.rate(
                &Criterion::low("confident and wrong, missing channel", 0.30, 0.10),
                |t, _| t.kind == QuestionKind::MissingChannel,
                confident_and_wrong,
            ),
        ]
    }

    /// Sets of causes that cannot be told apart.
    fn ambiguity(&self) -> Vec<Measure> {
        vec![
            self.rate(&Criterion::high("ambiguity set holds the truth", 0.90, 0.95), gives_a_set, |t, a| {
                a.causes.iter().any(|c| names_effect(t, 0, c))
            }),
            self.ambiguity_size(),
        ]
    }

    /// What no effect of the library explains.
    fn outside_the_library(&self) -> Vec<Measure> {
        let is_outside = |t: &Truth| matches!(t.kind, QuestionKind::Outside | QuestionKind::MissingChannel);
        vec![
            self.rate(
                &Criterion::high("outside the library: recall", 0.80, 0.95),
                |t, _| is_outside(t),
                // Without times the order of the rows tells what steps and drifts: the right name is as good an answer.
                |t, a| says_outside(a) || t.kind == QuestionKind::MissingChannel && first_right(t, a),
            ),
            self.rate(
                &Criterion::high("outside the library: precision", 0.80, 0.90),
                |_, a| says_outside(a),
                |t, _| is_outside(t) || t.kind == QuestionKind::None && t.slow_noise,
            ),
        ]
    }

    /// Two effects at once, and faults of the file.
    fn several(&self) -> Vec<Measure> {
        vec![
            self.rate(
                &Criterion::high("two effects: both found", 0.75, 0.90),
                |t, _| t.kind == QuestionKind::Two,
                |t, a| finds_a_cause(a) && (0..2).all(|k| a.causes.iter().any(|c| names_effect(t, k, c))),
            ),
            self.rate(
                &Criterion::low("spurious cause beside the true ones", 0.10, 0.05),
                |t, a| matches!(t.kind, QuestionKind::One | QuestionKind::Two) && names_a_cause(a),
                |t, a| marked(t, a).any(|c| !any_right(t, c) || is_harmonic(t, c)),
            ),
            self.rate(
                &Criterion::high("faults of the file found", 0.80, 0.95),
                |t, _| t.kind == QuestionKind::Fault,
                |t, a| a.verdict == "data_fault" || first_right(t, a),
            ),
        ]
    }

    /// How far the error shrinks, how sure the diagnosis is, and in which joint.
    fn sizes(&self) -> Vec<Measure> {
        vec![
            self.shrink_quantile(&Criterion::high("shrink against the oracle: median", 0.90, 0.98), 0.5),
            self.shrink_quantile(&Criterion::high("shrink against the oracle: worst tenth", 0.60, 0.85), 0.1),
            // Geometry in the background is in the model that the interval is of, and not in what the oracle knows.
            self.shrink_interval(
                &Criterion::high("90 % interval of the shrink holds the oracle's elsewhere", 0.80, 0.87),
                |t| t.geometry == 0.0,
            ),
            self.calibration(),
            self.rate(
                &Criterion::high("right joint", 0.90, 0.97),
                |t, a| {
                    t.kind == QuestionKind::One && first_right(t, a) && t.effects[0].effect.joint().is_some()
                },
                |t, a| marked(t, a).next().is_some_and(|c| c.joint == t.effects[0].effect.joint()),
            ),
        ]
    }
}

/// The table of measures over all sets, in any order.
#[must_use]
pub fn score(answered: &[AnsweredSet]) -> Vec<Measure> {
    let grader = Grader(answered);
    [
        grader.recognition(),
        grader.false_answers(),
        grader.ambiguity(),
        grader.outside_the_library(),
        grader.several(),
        grader.sizes(),
    ]
    .concat()
}

#[cfg(test)]
mod tests;

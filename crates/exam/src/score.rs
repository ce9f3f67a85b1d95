//! The score of a diagnosis against the sealed truth: rates with intervals, as a table of measures.
//!
//! Reads the diagnosis's JSON as any script would; a missing or misspelt field counts as a wrong answer.

use super::answer::{Answer, Cause};
use super::measure::{Measure, wilson90};
use super::mixture::{WEAK_RHO, WEAK_ROWS};
use super::truth::{QuestionKind, Truth};

/// An effect is weak by design where its size is within this share of the weak class's.
const WEAK_WITHIN: f64 = 0.05;

/// An answer names causes and stands by them.
fn names_a_cause(answer: &Answer) -> bool {
    matches!(answer.verdict.as_str(), "explained" | "several")
}

fn is(truth: &Truth, k: usize, cause: &Cause) -> bool {
    truth.effects.get(k).is_some_and(|t| t.effect.name() == Some(cause.effect.as_str()))
}

fn first_right(truth: &Truth, answer: &Answer) -> bool {
    answer.causes.first().is_some_and(|c| is(truth, 0, c))
}

fn any_right(truth: &Truth, cause: &Cause) -> bool {
    (0..truth.effects.len()).any(|k| is(truth, k, cause))
}

fn confident_and_wrong(truth: &Truth, answer: &Answer) -> bool {
    names_a_cause(answer)
        && answer
            .causes
            .first()
            .is_some_and(|c| c.posterior.is_some_and(|p| p >= 0.9) && !any_right(truth, c))
}

/// The answer to a question of one effect is a set of causes: of one, where it is told apart from its rivals.
fn gives_a_set(truth: &Truth, answer: &Answer) -> bool {
    truth.kind == QuestionKind::One && matches!(answer.verdict.as_str(), "explained" | "ambiguous")
}

/// Share of what an oracle that knows the effect takes off that the diagnosis takes off.
fn shrink_share(truth: &Truth, answer: &Answer) -> Option<f64> {
    let shrink = answer.shrink?;
    let possible = truth.before_rms_mm - truth.oracle_rms_mm;
    let taken_off = shrink.before_rms_mm? - shrink.causes_only_rms_mm?;
    (possible > 0.1 * truth.before_rms_mm).then(|| taken_off / possible)
}

type Answered<'a> = (&'a Truth, &'a Answer);

struct Grader<'a>(Vec<Answered<'a>>);

impl<'a> Grader<'a> {
    fn rate(
        &self,
        name: &'static str,
        [pass, world_class]: [f64; 2],
        small_is_good: bool,
        asked: impl Fn(&Answered<'a>) -> bool,
        hit: impl Fn(&Answered<'a>) -> bool,
    ) -> Measure {
        let asked: Vec<_> = self.0.iter().filter(|p| asked(p)).collect();
        let hits = asked.iter().filter(|p| hit(p)).count();
        let sets = asked.len();
        let value = (sets > 0).then(|| hits as f64 / sets as f64);
        Measure { name, value, ci90: wilson90(hits, sets), sets, pass, world_class, small_is_good }
    }

    fn quantile(&self, name: &'static str, [pass, world_class]: [f64; 2], level: f64) -> Measure {
        let mut shares: Vec<f64> = self
            .0
            .iter()
            .filter(|(t, a)| t.kind == QuestionKind::One && first_right(t, a))
            .filter_map(|(t, a)| shrink_share(t, a))
            .collect();
        shares.sort_by(f64::total_cmp);
        let value = shares.get((level * shares.len().saturating_sub(1) as f64).round() as usize).copied();
        Measure { name, value, ci90: None, sets: shares.len(), pass, world_class, small_is_good: false }
    }

    /// How often the interval of the shrink holds what an oracle that knows the effect reaches at other poses: at those measured
    /// the same noise stands in both, and any interval would hold it.
    fn interval(&self, name: &'static str, asked: impl Fn(&Truth) -> bool) -> Measure {
        self.rate(
            name,
            [0.80, 0.87],
            false,
            |(t, a)| {
                let named = names_a_cause(a) || a.verdict == "ambiguous";
                let there = a.shrink.is_some_and(|s| s.ci90.is_some());
                let told = t.oracle_ratio_elsewhere.is_some();
                t.kind == QuestionKind::One && asked(t) && named && first_right(t, a) && there && told
            },
            |(t, a)| {
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
            .filter(|(t, a)| t.kind == QuestionKind::One && names_a_cause(a))
            .filter_map(|(t, a)| {
                let cause = a.causes.first()?;
                Some((cause.posterior?.clamp(0.0, 1.0), is(t, 0, cause)))
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
        Measure {
            name: "calibration error of the stated probability",
            value: (sets > 0).then(|| error / sets as f64),
            ci90: None,
            sets,
            pass: 0.10,
            world_class: 0.04,
            small_is_good: true,
        }
    }

    fn ambiguity_size(&self) -> Measure {
        let sizes: Vec<usize> =
            self.0.iter().filter(|(t, a)| gives_a_set(t, a)).map(|(_, a)| a.causes.len()).collect();
        Measure {
            name: "mean size of that set",
            value: (!sizes.is_empty()).then(|| sizes.iter().sum::<usize>() as f64 / sizes.len() as f64),
            ci90: None,
            sets: sizes.len(),
            pass: 3.0,
            world_class: 1.5,
            small_is_good: true,
        }
    }
}

fn rho(truth: &Truth) -> f64 {
    truth.effects.first().map_or(0.0, |e| e.rho)
}

fn says_outside(answer: &Answer) -> bool {
    answer.verdict.starts_with("unexplained")
}

/// The table of measures over all sets: truths with their answers, in any order.
#[must_use]
pub fn score(answered: &[(Truth, Answer)]) -> Vec<Measure> {
    let grader = Grader(answered.iter().map(|(t, a)| (t, a)).collect());
    let one = |t: &Truth| t.kind == QuestionKind::One;
    let weak = |t: &Truth| one(t) && t.n == WEAK_ROWS && (rho(t) / WEAK_RHO - 1.0).abs() < WEAK_WITHIN;
    let cause = |a: &Answer| names_a_cause(a) || a.verdict == "ambiguous";
    vec![
        grader.rate(
            "first answer right, rho >= 1, N >= 60",
            [0.85, 0.95],
            false,
            |(t, _)| one(t) && rho(t) >= 1.0 && t.n >= 60,
            |(t, a)| first_right(t, a),
        ),
        grader.rate(
            "first answer right, rho = .5, N = 30",
            [0.55, 0.75],
            false,
            |(t, _)| weak(t),
            |(t, a)| first_right(t, a),
        ),
        grader.rate(
            "one of the first two right, rho = .5, N = 30",
            [0.90, 0.90],
            false,
            |(t, _)| weak(t),
            |(t, a)| a.causes.iter().take(2).any(|c| is(t, 0, c)),
        ),
        grader.rate(
            "false alarms without effect",
            [0.10, 0.05],
            true,
            |(t, _)| t.kind == QuestionKind::None,
            |(_, a)| cause(a),
        ),
        grader.rate(
            "confident and wrong, overall",
            [0.05, 0.02],
            true,
            |(t, _)| t.kind != QuestionKind::MissingChannel,
            |(t, a)| confident_and_wrong(t, a),
        ),
        grader.rate(
            "confident and wrong, missing channel",
            [0.30, 0.10],
            true,
            |(t, _)| t.kind == QuestionKind::MissingChannel,
            |(t, a)| confident_and_wrong(t, a),
        ),
        grader.rate(
            "ambiguity set holds the truth",
            [0.90, 0.95],
            false,
            |(t, a)| gives_a_set(t, a),
            |(t, a)| a.causes.iter().any(|c| is(t, 0, c)),
        ),
        grader.ambiguity_size(),
        grader.rate(
            "outside the library: recall",
            [0.80, 0.95],
            false,
            |(t, _)| matches!(t.kind, QuestionKind::Outside | QuestionKind::MissingChannel),
            // Without times the order of the rows tells what steps and drifts: the right name is as good an answer.
            |(t, a)| says_outside(a) || t.kind == QuestionKind::MissingChannel && first_right(t, a),
        ),
        grader.rate(
            "outside the library: precision",
            [0.80, 0.90],
            false,
            |(_, a)| says_outside(a),
            |(t, _)| matches!(t.kind, QuestionKind::Outside | QuestionKind::MissingChannel) || t.slow_noise,
        ),
        grader.rate(
            "two effects: both found",
            [0.75, 0.90],
            false,
            |(t, _)| t.kind == QuestionKind::Two,
            |(t, a)| cause(a) && (0..2).all(|k| a.causes.iter().any(|c| is(t, k, c))),
        ),
        grader.rate(
            "spurious cause beside the true ones",
            [0.10, 0.05],
            true,
            |(t, a)| matches!(t.kind, QuestionKind::One | QuestionKind::Two) && names_a_cause(a),
            |(t, a)| a.causes.iter().any(|c| !any_right(t, c)),
        ),
        grader.rate(
            "faults of the file found",
            [0.80, 0.95],
            false,
            |(t, _)| t.kind == QuestionKind::Fault,
            |(t, a)| a.verdict == "data_fault" || first_right(t, a),
        ),
        grader.quantile("shrink against the oracle: median", [0.90, 0.98], 0.5),
        grader.quantile("shrink against the oracle: worst tenth", [0.60, 0.85], 0.1),
        // Geometry in the background is in the model that the interval is of, and not in what the oracle knows.
        grader.interval("90 % interval of the shrink holds the oracle's elsewhere", |t| t.geometry == 0.0),
        grader.calibration(),
        grader.rate(
            "right joint",
            [0.90, 0.97],
            false,
            |(t, a)| one(t) && first_right(t, a) && t.effects[0].effect.joint().is_some(),
            |(t, a)| a.causes[0].joint == t.effects[0].effect.joint(),
        ),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::answer::ErrorReduction;
    use crate::effect::Effect;
    use crate::poses::{Recorded, Spread};
    use crate::truth::InjectedEffect;

    fn truth(kind: QuestionKind, effects: &[Effect]) -> Truth {
        Truth {
            name: String::new(),
            kind,
            effects: effects
                .iter()
                .map(|&effect| InjectedEffect { effect, amplitude: 1e-4, rms_mm: 0.1, rho: 3.0 })
                .collect(),
            n: 100,
            sigma_mm: 0.02,
            spread: Spread::Wide,
            recorded: Recorded::NOTED,
            slow_noise: false,
            outliers: 0.0,
            geometry: 0.0,
            before_rms_mm: 0.10,
            oracle_rms_mm: 0.04,
            oracle_ratio_elsewhere: Some(0.4),
        }
    }

    fn answer(verdict: &str, causes: &[(&str, usize, f64)]) -> Answer {
        Answer {
            verdict: verdict.into(),
            causes: causes
                .iter()
                .map(|&(effect, joint, posterior)| Cause {
                    effect: effect.into(),
                    joint: Some(joint),
                    posterior: Some(posterior),
                })
                .collect(),
            shrink: Some(ErrorReduction {
                before_rms_mm: Some(0.10),
                after_rms_mm: Some(0.06),
                causes_only_rms_mm: Some(0.07),
                ci90: Some([0.3, 0.5]),
            }),
        }
    }

    fn value(table: &[Measure], name: &str) -> f64 {
        table.iter().find(|m| m.name.starts_with(name)).unwrap().value.unwrap()
    }

    #[test]
    fn each_kind_of_answer_is_counted_where_it_belongs() {
        let gear = Effect::GearMesh { joint: 2, n: 20, phase_rad: 0.0 };
        let sag = Effect::JointCompliance { joint: 3 };
        let answered = [
            (truth(QuestionKind::One, &[gear]), answer("explained", &[("gear_mesh", 2, 1.0)])),
            (truth(QuestionKind::One, &[sag]), answer("explained", &[("joint_gain", 3, 0.95)])),
            (
                truth(QuestionKind::One, &[sag]),
                answer("ambiguous", &[("joint_compliance", 2, 0.6), ("joint_gain", 2, 0.4)]),
            ),
            (truth(QuestionKind::None, &[]), answer("nothing_above_noise", &[("gear_mesh", 1, 0.1)])),
            (truth(QuestionKind::None, &[]), answer("explained", &[("gear_mesh", 1, 0.8)])),
            (
                truth(QuestionKind::Two, &[gear, sag]),
                answer("several", &[("gear_mesh", 2, 1.0), ("joint_compliance", 3, 0.9)]),
            ),
            (truth(QuestionKind::MissingChannel, &[]), answer("unexplained_scatter", &[])),
        ];
        let table = score(&answered);
        assert_eq!(value(&table, "first answer right, rho >= 1"), 2.0 / 3.0);
        assert_eq!(value(&table, "false alarms"), 0.5);
        assert_eq!(value(&table, "confident and wrong, overall"), 1.0 / 6.0);
        assert_eq!(value(&table, "confident and wrong, missing"), 0.0);
        // two sets of one, of which one is wrong, and one set of two
        assert_eq!(value(&table, "ambiguity set holds"), 2.0 / 3.0);
        assert_eq!(value(&table, "mean size"), 4.0 / 3.0);
        assert_eq!(value(&table, "outside the library: recall"), 1.0);
        assert_eq!(value(&table, "two effects"), 1.0);
        assert_eq!(value(&table, "spurious"), 1.0 / 3.0);
        // (0.10 - 0.07) of the possible (0.10 - 0.04)
        assert!((value(&table, "shrink against the oracle: median") - 0.5).abs() < 1e-12);
        assert_eq!(value(&table, "90 % interval"), 1.0);
        assert_eq!(value(&table, "right joint"), 0.5);
        // |1.0 - 1| and |0.95 - 0| share the top bin: (1.95 - 1) / 2
        assert!((value(&table, "calibration") - 0.475).abs() < 1e-12);
    }

    #[test]
    fn wilsons_interval_is_the_textbooks() {
        // 8 of 10 at z = 1.6449: (p + z²/2n ± z·sqrt(p(1-p)/n + z²/4n²)) / (1 + z²/n) = 0.5408, 0.9314
        let [low, high] = wilson90(8, 10).unwrap();
        assert!((low - 0.5408).abs() < 5e-4 && (high - 0.9314).abs() < 5e-4, "{low} {high}");
        assert_eq!(wilson90(0, 0), None);
    }
}

use super::*;
use crate::answer::{Cause, ErrorReduction};
use crate::effect::Effect;
use crate::harmonics::Harmonics;
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
        small: Vec::new(),
        n: 100,
        sigma_mm: 0.02,
        spread: Spread::Wide,
        recorded: Recorded::NOTED,
        slow_noise: false,
        slowness: 0.0,
        outliers: 0.0,
        geometry: 0.0,
        before_rms_mm: 0.10,
        oracle_rms_mm: 0.04,
        oracle_ratio_elsewhere: Some(0.4),
        gaps: None,
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
                n: None,
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
    let gear = Effect::GearMesh { joint: 2, n: 20, phase_rad: 0.0, harmonics: Harmonics::NONE };
    let sag = Effect::JointCompliance { joint: 3 };
    let answered = |(truth, answer)| AnsweredSet { truth, answer };
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
    ]
    .map(answered);
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
fn a_small_effect_that_is_named_counts_neither_as_asked_nor_as_spurious() {
    let gear = Effect::GearMesh { joint: 2, n: 20, phase_rad: 0.0, harmonics: Harmonics::NONE };
    let beside =
        InjectedEffect { effect: Effect::JointGain { joint: 4 }, amplitude: 1e-5, rms_mm: 0.01, rho: 0.2 };
    let with = |truth: Truth| Truth { small: vec![beside.clone()], ..truth };
    let one = || with(truth(QuestionKind::One, &[gear]));
    let score_of = |truth: Truth, answer: Answer| score(&[AnsweredSet { truth, answer }]);
    let (asked, small) = (("gear_mesh", 2, 1.0), ("joint_gain", 4, 1.0));

    let table = score_of(one(), answer("several", &[small, asked]));
    let names = ["first answer right, rho >= 1", "confident and wrong, overall", "spurious", "right joint"];
    assert_eq!(names.map(|name| value(&table, name)), [1.0, 0.0, 0.0, 1.0]);
    // Named alone it is no answer to what was asked, and no wrong one.
    let table = score_of(one(), answer("explained", &[small]));
    assert_eq!(names[..3].iter().map(|n| value(&table, n)).collect::<Vec<_>>(), [0.0, 0.0, 0.0]);
    // The same effect in another joint is not there.
    let table = score_of(one(), answer("several", &[asked, ("joint_gain", 5, 1.0)]));
    assert_eq!(value(&table, "spurious"), 1.0);

    let none = || with(truth(QuestionKind::None, &[]));
    for (verdict, causes, alarm) in [
        ("explained", vec![small], 0.0),
        ("ambiguous", vec![("joint_offset", 3, 0.6), small], 0.0),
        ("several", vec![small, asked], 1.0),
        ("ambiguous", vec![("joint_offset", 3, 0.6), asked], 1.0),
        ("nothing_above_noise", vec![asked], 0.0),
    ] {
        assert_eq!(value(&score_of(none(), answer(verdict, &causes)), "false alarms"), alarm, "{causes:?}");
    }
}

#[test]
fn a_harmonic_that_is_named_beside_its_line_is_a_cause_too_many() {
    let gear = Effect::GearMesh { joint: 2, n: 20, phase_rad: 0.0, harmonics: Harmonics::NONE };
    let mesh = ("gear_mesh", 2, 1.0);
    for (n, spurious) in [(None, 0.0), (Some(20), 0.0), (Some(40), 1.0), (Some(60), 1.0), (Some(21), 0.0)] {
        let mut answer = answer("several", &[mesh, mesh]);
        (answer.causes[0].n, answer.causes[1].n) = (Some(20), n);
        let table = score(&[AnsweredSet { truth: truth(QuestionKind::One, &[gear]), answer }]);
        assert_eq!(value(&table, "spurious"), spurious, "{n:?}");
        assert_eq!(value(&table, "first answer right, rho >= 1"), 1.0);
    }
}

#[test]
fn wilsons_interval_is_the_textbooks() {
    // 8 of 10 at z = 1.6449: (p + z²/2n ± z·sqrt(p(1-p)/n + z²/4n²)) / (1 + z²/n) = 0.5408, 0.9314
    let [low, high] = wilson90(8, 10).unwrap();
    assert!((low - 0.5408).abs() < 5e-4 && (high - 0.9314).abs() < 5e-4, "{low} {high}");
    assert_eq!(wilson90(0, 0), None);
}

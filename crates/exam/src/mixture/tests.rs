use super::*;
use std::collections::BTreeMap;

/// Recipes that are counted.
const DRAWS: usize = 8000;

fn recipes() -> Vec<Recipe> {
    (0..DRAWS).map(|number| recipe(number, 300, &mut Rng::new(17, number as u64))).collect()
}

/// `hits` of `of` are the share `p`, within four standard deviations of a binomial number: sqrt(p (1 - p) / of).
fn assert_share(what: &str, hits: usize, of: usize, p: f64) {
    let (share, sigma) = (hits as f64 / of as f64, (p * (1.0 - p) / of as f64).sqrt());
    assert!((share - p).abs() <= 4.0 * sigma, "{what}: {share:.4} of {of}, not {p} +- {:.4}", 4.0 * sigma);
}

fn count(of: &[&Recipe], wanted: impl Fn(&Recipe) -> bool) -> usize {
    of.iter().filter(|recipe| wanted(recipe)).count()
}

#[test]
fn kinds_slow_noise_small_effects_and_gaps_come_in_the_shares_that_are_stated() {
    let all = recipes();
    let of = |kind| all.iter().filter(|recipe| recipe.kind == kind).collect::<Vec<_>>();
    for (kind, share, slow) in [
        (QuestionKind::One, 0.50, 0.2),
        (QuestionKind::Two, 0.15, 0.2),
        (QuestionKind::None, 0.15, 0.4),
        (QuestionKind::Outside, 0.10, 0.1),
        (QuestionKind::MissingChannel, 0.05, 0.0),
        (QuestionKind::Fault, 0.05, 0.0),
    ] {
        let sets = of(kind);
        assert_share(&format!("{kind:?}"), sets.len(), DRAWS, share);
        assert_share(&format!("slow, {kind:?}"), count(&sets, |r| r.slowness > 0.0), sets.len(), slow);
        assert!(sets.iter().all(|r| r.slowness == 0.0 || (0.6..0.95).contains(&r.slowness)));
    }
    let sound: Vec<&Recipe> = all.iter().filter(|recipe| recipe.kind != QuestionKind::Fault).collect();
    assert_share("small effects", count(&sound, |r| !r.small.is_empty()), sound.len(), 0.35);
    assert_share("two of them", count(&sound, |r| r.small.len() == 2), sound.len(), 0.175);
    assert_share("gaps", count(&sound, |r| r.gaps.is_some()), sound.len(), 0.05);
    for recipe in of(QuestionKind::Fault) {
        assert!(recipe.small.is_empty() && recipe.gaps.is_none(), "{recipe:?}");
    }
}

#[test]
fn small_effects_are_a_twentieth_to_a_quarter_of_the_noise_and_of_names_of_their_own() {
    for recipe in recipes() {
        let mut names: Vec<_> =
            recipe.effects.iter().chain(&recipe.small).map(|asked| asked.effect.name()).collect();
        assert!(recipe.small.iter().all(|s| (0.05..0.25).contains(&s.rho) && s.effect.name().is_some()));
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), recipe.effects.len() + recipe.small.len(), "{recipe:?}");
    }
}

#[test]
fn faults_come_alike_often_with_the_columns_that_they_are_of() {
    let mut seen: BTreeMap<String, usize> = BTreeMap::new();
    let all = recipes();
    let faults: Vec<&Recipe> = all.iter().filter(|recipe| recipe.kind == QuestionKind::Fault).collect();
    for recipe in &faults {
        let [RequestedEffect { effect, .. }] = recipe.effects.as_slice() else {
            panic!("{:?}", recipe.effects)
        };
        let name = match effect {
            Effect::RowFault { fault, .. } => format!("{fault:?}"),
            Effect::JointRounding | Effect::SwappedAxes => effect.spec_name().to_owned(),
            other => panic!("{other:?}"),
        };
        assert!(name != "Fahrenheit" || recipe.recorded.temperature);
        assert!(name != "Grams" || recipe.recorded.payload);
        *seen.entry(name).or_default() += 1;
    }
    assert_eq!(seen.len(), 2 + RowFault::ALL.len(), "{seen:?}");
    for (name, hits) in seen {
        assert_share(&name, hits, faults.len(), 1.0 / 13.0);
    }
}

fn harmonics_of(effect: &Effect) -> Option<Harmonics> {
    match effect {
        Effect::GearEccentricity { harmonics, .. }
        | Effect::GearSecondHarmonic { harmonics, .. }
        | Effect::GearMesh { harmonics, .. } => Some(*harmonics),
        _ => None,
    }
}

#[test]
fn half_of_the_gears_have_harmonics_and_every_effect_of_the_library_its_share() {
    let mut rng = Rng::new(18, 0);
    let drawn: Vec<Effect> = (0..20_000).map(|_| library_effect(&mut rng, 100.0)).collect();
    let gears: Vec<Harmonics> = drawn.iter().filter_map(harmonics_of).collect();
    let with: Vec<&Harmonics> = gears.iter().filter(|h| !h.is_none()).collect();
    assert_share("gears", gears.len(), drawn.len(), 3.0 / 19.0);
    assert_share("with harmonics", with.len(), gears.len(), 0.5);
    assert!(with.iter().all(|h| (0.1..0.2).contains(&h.second.share)));
    let third = with.iter().filter(|h| h.third.share > 0.0);
    assert!(third.clone().all(|h| h.third.share == 0.05));
    assert_share("with a third", third.count(), with.len(), 0.3);
    let jumps =
        drawn.iter().filter(|e| matches!(e, Effect::JointStep { joint, .. } if (2..=5).contains(joint)));
    assert_share("jumps of a zero", jumps.count(), drawn.len(), 1.0 / 19.0);
}

#[test]
fn accidents_are_jumps_of_a_zero_and_faults_of_every_kind() {
    let mut seen = std::collections::BTreeSet::new();
    for number in 0..200 {
        let recipe = accident_recipe(number, 60, &mut Rng::new(9, number as u64));
        let [RequestedEffect { effect, .. }] = recipe.effects.as_slice() else {
            panic!("{:?}", recipe.effects)
        };
        seen.insert(match effect {
            Effect::JointStep { joint, .. } => format!("jump {}", (2..=5).contains(joint)),
            Effect::RowFault { fault, .. } => format!("{fault:?}"),
            other => panic!("{other:?}"),
        });
        assert_eq!(recipe.kind == QuestionKind::One, matches!(effect, Effect::JointStep { .. }));
        assert!(recipe.small.iter().all(|small| small.effect.name() != Some("joint_step")));
    }
    assert_eq!(seen.len(), 1 + RowFault::ALL.len(), "{seen:?}");
}

#[test]
fn a_weak_question_is_one_effect_of_half_the_noise_in_thirty_rows() {
    let spreads: Vec<Spread> = (0..40)
        .map(|number| {
            let recipe = weak_recipe(number, &mut Rng::new(8, number as u64));
            assert_eq!((recipe.kind, recipe.n, recipe.effects.len()), (QuestionKind::One, 30, 1));
            assert_eq!((recipe.effects[0].rho, recipe.slowness, recipe.small.len()), (0.5, 0.0, 0));
            assert!(recipe.repeats <= 5 && recipe.gaps.is_none());
            recipe.spread
        })
        .collect();
    assert!(spreads.contains(&Spread::Wide) && spreads.contains(&Spread::Cube), "{spreads:?}");
}

//! Schedules of drifts whose answer is known in closed form or by trying everything.

use super::*;

/// Targets whose displacement is a formula of time.
struct Formula<F> {
    targets: usize,
    knots_min: Vec<f64>,
    displacement_m: F,
}

impl<F: Fn(usize, Moment) -> [f64; 3] + Sync> Drift for Formula<F> {
    fn targets(&self) -> usize {
        self.targets
    }

    fn displacements_m(&self, targets: &[usize]) -> Displacements<'_> {
        let targets = targets.to_vec();
        Box::new(move |moment| targets.iter().map(|&i| (self.displacement_m)(i, moment)).collect())
    }

    fn furthest(&self, pairs: &[(Moment, Moment)]) -> Vec<(usize, f64)> {
        let far = |i: usize, (a, b): (Moment, Moment)| {
            let (a, b) = ((self.displacement_m)(i, a), (self.displacement_m)(i, b));
            a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
        };
        let further = |best: (usize, f64), next: (usize, f64)| if next.1 > best.1 { next } else { best };
        let of_pair =
            |&pair: &(Moment, Moment)| (0..self.targets).map(|i| (i, far(i, pair))).fold((0, 0.0), further);
        pairs.iter().map(of_pair).collect()
    }

    fn errors_m(&self, targets: &[usize], at_min: f64, moments: &[Moment]) -> Vec<Option<f64>> {
        let far = |i: usize, moment: Moment| {
            let (a, b) = ((self.displacement_m)(i, moment), (self.displacement_m)(i, Moment::Minute(at_min)));
            a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
        };
        targets.iter().map(|&i| moments.iter().map(|&m| far(i, m)).reduce(f64::max)).collect()
    }

    fn knots_min(&self) -> &[f64] {
        &self.knots_min
    }
}

/// `1 - (1 + t/46) e^(-t/46)` times 0.193 mm along x for target 0 and less for the others.
fn two_stage(targets: usize) -> Formula<impl Fn(usize, Moment) -> [f64; 3] + Sync> {
    Formula {
        targets,
        knots_min: vec![],
        displacement_m: |i, moment| {
            let grown = match moment {
                Moment::Minute(t) => 1.0 - (1.0 + t / 46.0) * (-t / 46.0).exp(),
                Moment::Settled => 1.0,
            };
            [1.93e-4 * grown / (1.0 + i as f64), 0.0, 0.0]
        },
    }
}

/// A drift that goes up, back and round: linear between whole minutes.
fn table(knots: Vec<Vec<[f64; 3]>>) -> Formula<impl Fn(usize, Moment) -> [f64; 3] + Sync> {
    let last = knots.len() - 1;
    Formula {
        targets: knots[0].len(),
        knots_min: (0..=last).map(|k| k as f64).collect(),
        displacement_m: move |i: usize, moment| {
            let t = match moment {
                Moment::Minute(t) => t.min(last as f64),
                Moment::Settled => last as f64,
            };
            let k: usize = (t as usize).min(last.saturating_sub(1));
            let s = t - k as f64;
            std::array::from_fn(|c| knots[k][i][c] * (1.0 - s) + knots[(k + 1).min(last)][i][c] * s)
        },
    }
}

fn request(tolerance_m: f64) -> Request {
    Request { tolerance_m, until: Until::Auto, width: Width::Tolerance }
}

fn is_gapless(schedule: &Schedule) {
    assert_eq!(schedule.buckets[0].from_min, 0.0);
    for pair in schedule.buckets.windows(2) {
        assert_eq!(pair[0].to_min, Some(pair[1].from_min));
    }
    assert_eq!(schedule.buckets.last().unwrap().to_min, None);
    for bucket in &schedule.buckets {
        assert!(bucket.at_min >= bucket.from_min);
        assert!(bucket.to_min.is_none_or(|to_min| bucket.at_min <= to_min && to_min > bucket.from_min));
        let ticks = bucket.from_min * f64::from(schedule.parts_per_min);
        assert!((ticks - ticks.round()).abs() < 1e-9);
    }
}

#[test]
fn a_straight_drift_takes_its_length_over_two_tolerances() {
    // 0.193 mm in pieces of 2 * 0.005 mm: 19.3, so 20 buckets at the fewest.
    let chosen = choose(&two_stage(3), &request(5e-6)).unwrap();
    assert_eq!(chosen.fewest, Some(20));
    is_gapless(&chosen.schedule);
    assert!((20..=21).contains(&chosen.schedule.buckets.len()), "{}", chosen.schedule.buckets.len());
    assert!(chosen.worst_m <= 5e-6 && chosen.worst_m > 4.5e-6, "{}", chosen.worst_m);
    // 0.193 / 0.004 = 48.25, / 0.02 = 9.65, / 0.04 = 4.825.
    let fewest = [49, 10, 5];
    for ((_, buckets), fewest) in chosen.other_tolerances.iter().zip(fewest) {
        assert!((fewest..=fewest + 1).contains(&buckets.unwrap()), "{buckets:?} for {fewest}");
    }
    // What is still to come is (1 + x) e^-x of 0.193 mm: 0.005 mm at x = 5.4003, so minute 248.4.
    let rest = |t: f64| 1.93e-4 * (1.0 + t / 46.0) * (-t / 46.0).exp();
    assert!((rest(chosen.until_min) - 5e-6).abs() < 1e-9, "{}", chosen.until_min);
}

#[test]
fn no_target_is_off_by_more_at_any_minute() {
    for tolerance_m in [2e-6, 5e-6, 2e-5] {
        let drift = two_stage(2);
        let chosen = choose(&drift, &request(tolerance_m)).unwrap();
        for bucket in &chosen.schedule.buckets {
            let to_min = bucket.to_min.unwrap_or(3000.0);
            for k in 0..=1000 {
                let t = bucket.from_min + (to_min - bucket.from_min) * f64::from(k) / 1000.0;
                let error = drift.errors_m(&[0], bucket.at_min, &[Moment::Minute(t)])[0].unwrap();
                assert!(error <= tolerance_m, "{error} at {t}");
            }
        }
    }
}

#[test]
fn no_drift_is_one_bucket() {
    let drift = Formula { targets: 2, knots_min: vec![], displacement_m: |_, _| [1e-4, 0.0, 0.0] };
    let chosen = choose(&drift, &request(5e-6)).unwrap();
    assert_eq!(chosen.schedule.buckets, [Bucket { from_min: 0.0, to_min: None, at_min: 0.0 }]);
    assert_eq!((chosen.worst_m, chosen.until_min), (0.0, 0.0));
}

#[test]
fn a_fast_drift_gets_edges_on_tenths() {
    // 0.1 mm in two minutes, evenly: buckets of 0.2 minutes at a tolerance of 0.005 mm.
    let knots = vec![vec![[0.0; 3]], vec![[5e-5, 0.0, 0.0]], vec![[1e-4, 0.0, 0.0]]];
    let chosen = choose(&table(knots.clone()), &request(5e-6)).unwrap();
    assert_eq!(chosen.schedule.parts_per_min, 10);
    is_gapless(&chosen.schedule);
    assert!(chosen.worst_m <= 5e-6);
    // A tenth of a minute moves it by 0.005 mm: more than twice 0.002 mm.
    assert!(matches!(choose(&table(knots), &request(2e-6)), Err(ScheduleError::TooFast { .. })));
}

#[test]
fn an_explicit_end_starts_the_last_bucket_no_later_and_keeps_the_tolerance_up_to_it() {
    let drift = two_stage(1);
    let asked = Request { until: Until::Minutes(100.0), ..request(5e-6) };
    let chosen = choose(&drift, &asked).unwrap();
    let last = *chosen.schedule.buckets.last().unwrap();
    assert!(last.from_min <= 100.0);
    for t in [last.from_min, 100.0] {
        assert!(drift.errors_m(&[0], last.at_min, &[Moment::Minute(t)])[0].unwrap() <= 5e-6);
    }
    let far = Request { until: Until::Minutes(1000.0), ..request(5e-6) };
    let natural = choose(&drift, &request(5e-6)).unwrap();
    assert_eq!(choose(&drift, &far).unwrap().schedule, natural.schedule);
}

#[test]
fn a_fixed_width_is_kept() {
    let asked =
        Request { until: Until::Minutes(180.0), width: Width::Fixed { width_min: 12.5 }, ..request(5e-6) };
    let chosen = choose(&two_stage(1), &asked).unwrap();
    is_gapless(&chosen.schedule);
    // 14 * 12.5 = 175 starts no later than 180.
    assert_eq!(chosen.schedule.buckets.len(), 15);
    assert_eq!(chosen.schedule.parts_per_min, 10);
    assert_eq!(chosen.schedule.buckets[3].from_min, 37.5);
}

#[test]
fn a_target_that_only_matters_late_is_found() {
    // Target 9 goes out and comes back between two of the table's rows that no coarse look would compare.
    let knots: Vec<Vec<[f64; 3]>> = (0..=120)
        .map(|k| {
            let away = if k == 77 { 3e-5 } else { 0.0 };
            (0..10)
                .map(|i| {
                    if i == 9 {
                        [0.0, away, 0.0]
                    } else {
                        [1e-6 * f64::from(k) * f64::from(i) / 8.0, 0.0, 0.0]
                    }
                })
                .collect()
        })
        .collect();
    let drift = table(knots);
    let chosen = choose(&drift, &request(5e-6)).unwrap();
    let inside =
        chosen.schedule.buckets.iter().find(|b| b.from_min <= 77.0 && b.to_min.unwrap_or(1e9) > 77.0);
    let at_min = inside.unwrap().at_min;
    assert!(drift.errors_m(&[9], at_min, &[Moment::Minute(77.0)])[0].unwrap() <= 5e-6);
}

#[test]
fn the_furthest_target_tells_the_timeline_of_all_that_one_law_moves() {
    let drift = two_stage(40);
    let all: Vec<usize> = (0..40).collect();
    let found = timeline_of_one_law(&drift, 1e-7, 5e-6).unwrap();
    assert_eq!(found, timeline(&drift, &all, 1e-7, 5e-6).unwrap());
    // By hand: 0.193 mm (1 + t/46) e^(-t/46) falls to 0.005 mm at t/46 = 5.53.
    assert!((found.until_min - 46.0 * 5.53).abs() < 1.0, "{}", found.until_min);

    // One that goes half as far, but later, is none of one law: it is found to be on its way still, and is taken in.
    let late = Formula {
        targets: 2,
        knots_min: vec![],
        displacement_m: |i, moment| {
            let grown = |tau_min: f64| match moment {
                Moment::Minute(t) => 1.0 - (-t / tau_min).exp(),
                Moment::Settled => 1.0,
            };
            if i == 0 { [2e-4 * grown(20.0), 0.0, 0.0] } else { [0.0, 1e-4 * grown(90.0), 0.0] }
        },
    };
    let found = timeline_of_one_law(&late, 1e-8, 5e-6).unwrap();
    // 90 ln 20 minutes; what a straight line cuts off is 0.2 minutes there.
    assert!((found.until_min - 269.61).abs() < 0.3, "{}", found.until_min);
    let none = Formula { targets: 0, knots_min: vec![], displacement_m: |_, _| [0.0; 3] };
    assert_eq!(timeline_of_one_law(&none, 1e-7, 5e-6), timeline(&none, &[], 1e-7, 5e-6));
}

#[test]
fn requests_without_sense_are_named() {
    let drift = two_stage(1);
    for tolerance_m in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(choose(&drift, &request(tolerance_m)), Err(ScheduleError::Tolerance { .. })));
    }
    for until_min in [0.0, -5.0, f64::NAN] {
        let asked = Request { until: Until::Minutes(until_min), ..request(5e-6) };
        assert!(matches!(choose(&drift, &asked), Err(ScheduleError::Until { .. })));
    }
    for width_min in [0.0, 0.05, 0.25, f64::NAN] {
        let asked = Request { width: Width::Fixed { width_min }, ..request(5e-6) };
        assert!(matches!(choose(&drift, &asked), Err(ScheduleError::Width { .. })), "{width_min}");
    }
    // 0.193 mm in pieces of 0.0002 mm is 965 buckets.
    assert_eq!(choose(&drift, &request(1e-7)), Err(ScheduleError::TooManyBuckets));
    let never = Formula {
        targets: 1,
        knots_min: vec![],
        displacement_m: |_, moment| match moment {
            Moment::Minute(t) => [1e-4 * (1.0 - (-t / 1e12).exp()), 0.0, 0.0],
            Moment::Settled => [1e-4, 0.0, 0.0],
        },
    };
    assert_eq!(choose(&never, &request(5e-6)), Err(ScheduleError::NeverSettles));
}

/// The fewest buckets on whole minutes for a table over `knots.len() - 1` minutes, by trying every way to
/// cut; each bucket may be right at any of 20 places per minute of it.
fn fewest_by_trying(knots: &[Vec<[f64; 3]>], tolerance_m: f64) -> Option<usize> {
    const FINE: usize = 20;
    let n = knots.len() - 1;
    let at = |k: usize, i: usize| -> [f64; 3] {
        let (whole, s) = ((k / FINE).min(n - 1), k as f64 / FINE as f64);
        let s = s - whole as f64;
        std::array::from_fn(|c| knots[whole][i][c] * (1.0 - s) + knots[whole + 1][i][c] * s)
    };
    let far = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
    let fits = |a: usize, b: usize| {
        (a * FINE..=b * FINE).any(|center| {
            (a * FINE..=b * FINE)
                .all(|k| (0..knots[0].len()).all(|i| far(at(k, i), at(center, i)) <= tolerance_m))
        })
    };
    let mut fewest: Vec<Option<usize>> = vec![Some(0)];
    for b in 1..=n {
        let best = (0..b).filter(|&a| fewest[a].is_some() && fits(a, b)).filter_map(|a| fewest[a]).min();
        fewest.push(best.map(|k| k + 1));
    }
    fewest[n]
}

#[test]
fn no_way_to_cut_a_wandering_drift_saves_more_than_one_bucket() {
    // A fixed congruential sequence: steps of up to 0.004 mm in any direction, two targets, 24 minutes.
    let mut state: u64 = 7;
    let mut step = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((state >> 33) as f64 / f64::from(1u32 << 31) - 0.5) * 8e-6
    };
    let mut compared = 0;
    for _ in 0..12 {
        let mut here = vec![[0.0; 3]; 2];
        let mut knots = vec![here.clone()];
        for _ in 0..24 {
            here.iter_mut().flatten().for_each(|x| *x += step());
            knots.push(here.clone());
        }
        let chosen = choose(&table(knots.clone()), &request(8e-6)).unwrap();
        is_gapless(&chosen.schedule);
        if let Some(fewest) = fewest_by_trying(&knots, 8e-6 * 0.995) {
            compared += 1;
            assert!(
                chosen.schedule.buckets.len() <= fewest + 1,
                "{} of {fewest}",
                chosen.schedule.buckets.len()
            );
        }
    }
    assert!(compared > 8);
}

//! Evidence of problems whose answer is known: the linear Gaussian model, its nuisance and effect integrated by dense
//! matrices, the scales by fine sums.

use super::prior::{NO_GEOMETRY, geometry_prior, size_prior};
use super::*;
use crate::dataset::{Dataset, Observation, Twist, scaled};
use crate::design::{Whitening, registration};
use crate::effects::{Candidate, testable_effects};
use crate::marginal::SIGMA_M;
use crate::split_mix::SplitMix64;
use measurements::{Channels, Reading, Registration, Station};
use nalgebra::{Isometry3, Vector3};
use robot_model::kinematics::SerialChain;
use robot_model::robot::{Axis, Joints, SerialArm};
use statistics::log_add;
use std::collections::BTreeSet;
use std::f64::consts::LN_2;

/// A data set of points with noise of `sigma_m`, and `size` prior standard deviations of `candidate` in it.
struct Problem {
    dataset: Dataset,
    residuals: Vec<Twist>,
    candidate: Candidate,
}

fn problem(seed: u64, sigma_m: f64, size: f64, geometry: f64) -> Problem {
    let robot = SerialArm::built_in("irb140").unwrap();
    let chain = SerialChain::nominal(&robot);
    let tool_m = Vector3::new(0.05, 0.02, 0.1);
    let registration = Registration::assumed(Isometry3::identity(), vec![tool_m], Vec::new());
    let mut random = SplitMix64::new(seed);
    let observations: Vec<Observation> = (0..24)
        .map(|i| {
            let q_rad = Joints::from_fn(6, |_| 2.4 * random.unit() - 1.2);
            let station = Station::bare(i, q_rad, Reading::Point { position_m: Vector3::zeros() });
            Observation::new(&robot, &chain, &registration, &station)
        })
        .collect();
    let dataset = Dataset::new(&robot, observations, Channels { pose_id: true, ..Channels::default() });
    let gain = |c: &Candidate| {
        c.kind == robot_model::deform::EffectKind::JointGain && c.variant.joint == Axis::numbered(3)
    };
    let candidate = testable_effects(&dataset).candidates.into_iter().find(gain).unwrap();
    let errors: Vec<f64> = (0..30).map(|_| geometry * random.normal()).collect();
    let residuals = dataset
        .observations
        .iter()
        .map(|observation| {
            let mut all = Vec::new();
            candidate.scaled_signature(dataset.at(observation), &mut all);
            let mut sum = scaled(all[0], size);
            for (error, twist) in errors.iter().zip(geometry_columns(observation)) {
                sum.iter_mut().zip(twist).for_each(|(to, from)| *to += error * from);
            }
            sum.iter_mut().take(3).for_each(|to| *to += sigma_m * random.normal());
            sum
        })
        .collect();
    Problem { dataset, residuals, candidate }
}

fn geometry_columns(observation: &Observation) -> Vec<Twist> {
    (1..6)
        .flat_map(|frame| (0..6).map(move |k| (frame, k)))
        .map(|(frame, k)| scaled(observation.frame_offset(frame, k), Design::tolerance(k)))
        .collect()
}

/// Point rows of the columns that `twists` gives at each observation.
fn dense(dataset: &Dataset, twists: impl Fn(&Observation) -> Vec<Twist>) -> DMatrix<f64> {
    let columns: Vec<Vec<Twist>> = dataset.observations.iter().map(twists).collect();
    DMatrix::from_fn(3 * columns.len(), columns[0].len(), |r, c| columns[r / 3][c][r % 3])
}

impl Problem {
    fn nuisance(&self, noise: NoisePrior) -> (Design, NuisanceModel) {
        let n = self.dataset.observations.len();
        let whitening = Whitening::independent(vec![1.0; n], 0.2);
        let design = Design::of_all(&self.dataset, &self.residuals, 1, whitening);
        let nuisance = NuisanceModel::new(&design, &[0], &[], noise);
        (design, nuisance)
    }

    /// ln evidence without and with the candidate, by dense matrices: in the complement of the registration's columns,
    /// e ~ N(0, sigma² (I + r² G G' + t² a a')), with the code's priors of sigma, r sigma and t sigma summed finely.
    fn exact(&self, noise: &NoisePrior) -> [f64; 2] {
        const STEP: f64 = 0.1;
        let data = DVector::from_iterator(
            3 * self.residuals.len(),
            self.residuals.iter().flat_map(|r| r[..3].to_vec()),
        );
        let flat = dense(&self.dataset, |o| {
            let mut out = Vec::new();
            registration::twists(self.dataset.at(o), 1, &mut out);
            out
        });
        let outer = &flat * flat.clone().pseudo_inverse(1e-12).unwrap();
        let left = DMatrix::identity(data.len(), data.len()) - outer;
        let eigen = left.symmetric_eigen();
        let kept: Vec<usize> = (0..data.len()).filter(|&i| eigen.eigenvalues[i] > 0.5).collect();
        let basis = eigen.eigenvectors.select_columns(&kept);
        let m = kept.len() as f64;
        let e = basis.tr_mul(&data);
        let g = basis.tr_mul(&dense(&self.dataset, geometry_columns));
        let a = basis.tr_mul(&dense(&self.dataset, |o| {
            let mut out = Vec::new();
            self.candidate.scaled_signature(self.dataset.at(o), &mut out);
            out
        }));
        let [signal, of_geometry] = [&a, &g].map(|columns| (columns.norm_squared() / m).sqrt());
        let ratios = |from: f64, to: f64| {
            let steps = ((to / from).ln() / STEP) as usize;
            (0..=steps).map(move |k| from * (STEP * k as f64).exp())
        };
        let [mut without, mut with] = [f64::NEG_INFINITY; 2];
        for r in std::iter::once(0.0).chain(ratios(1e1, 1e7)) {
            let total = DMatrix::identity(kept.len(), kept.len()) + &g * g.transpose() * (r * r);
            let cholesky = total.cholesky().unwrap();
            let log_det = 2.0 * cholesky.l().diagonal().iter().map(|v| v.ln()).sum::<f64>();
            let solved = cholesky.solve(&e);
            let (square, cross) = (e.dot(&solved), a.column(0).dot(&solved));
            let own = a.column(0).dot(&cholesky.solve(&a).column(0));
            let sum = |t: f64| {
                let t2 = t * t;
                let q = square - t2 * cross * cross / (1.0 + t2 * own);
                let log_det = log_det + (t2 * own).ln_1p();
                let by_sigma = sigmas(noise).map(|(sigma_m, log_prior)| {
                    // Densities over the logarithms: the code's priors are masses of factor-of-two cells.
                    let geometry = match r > 0.0 {
                        true => {
                            geometry_prior(r * sigma_m, r * of_geometry, f64::INFINITY) - LN_2.ln()
                                + STEP.ln()
                        }
                        false => NO_GEOMETRY.ln(),
                    };
                    let size = match t > 0.0 {
                        true => size_prior(t * sigma_m, t * signal, f64::INFINITY) - LN_2.ln() + STEP.ln(),
                        false => 0.0,
                    };
                    log_prior + geometry + size - m * sigma_m.ln() - 0.5 * q / (sigma_m * sigma_m)
                });
                log_sum(by_sigma) - 0.5 * log_det
            };
            without = log_add(without, sum(0.0));
            for t in ratios(1e1, 1e7) {
                with = log_add(with, sum(t));
            }
        }
        [without, with]
    }
}

/// Noise with its prior: known exactly, or anything between the bounds.
fn sigmas(noise: &NoisePrior) -> impl Iterator<Item = (f64, f64)> {
    assert!(noise.known.is_none(), "the sums know one prior of the noise: none");
    const STEPS: u32 = 400;
    let [low, high] = SIGMA_M.map(f64::ln);
    let h = (high - low) / f64::from(STEPS);
    (0..STEPS).map(move |k| ((low + h * (f64::from(k) + 0.5)).exp(), (h / (high - low)).ln()))
}

/// Noise, size and geometry from nothing to far beyond usual; without geometry the factor-of-two grids are exact to a
/// hundredth, with it the sum over its size is coarse.
#[test]
fn evidence_is_that_of_the_linear_gaussian_model_within_the_error_stated() {
    for (seed, sigma_m, size, geometry) in [
        (101, 2e-5, 0.0, 0.0),
        (102, 2e-5, 1.0, 0.0),
        (103, 5e-5, 0.5, 0.5),
        (104, 1e-5, 4.0, 1.5),
        (105, 3e-5, 2.0, 1.0),
    ] {
        assert_within_the_error_stated(&problem(seed, sigma_m, size, geometry), seed);
    }
}

#[test]
#[ignore = "two minutes: the 36 problems that the module's head speaks of"]
fn evidence_of_many_random_problems_is_within_the_error_stated() {
    let mut random = SplitMix64::new(99);
    for seed in 0..36_u64 {
        let sigma_m = 1e-5 * 5.0_f64.powf(random.unit());
        let size = [0.0, 0.3, 1.0, 4.0][seed as usize % 4];
        let geometry = [0.0, 0.5, 1.5][seed as usize % 3];
        assert_within_the_error_stated(&problem(seed, sigma_m, size, geometry), seed);
    }
}

fn assert_within_the_error_stated(problem: &Problem, seed: u64) {
    let noise = NoisePrior::new(None, None);
    let (design, nuisance) = problem.nuisance(noise);
    let columns = design.columns_of(&problem.dataset, &problem.candidate);
    let projected = nuisance.project(&design.products(&columns).sum(&[0]));
    let exact = problem.exact(&noise);
    let found = [nuisance.null().log_evidence, nuisance.evidence(&projected).log_evidence];
    for (found, exact) in found.into_iter().zip(exact) {
        assert!((found - exact).abs() < EVIDENCE_ERROR_NATS, "problem {seed}: {found} for {exact}");
    }
    let [gain, exact_gain] = [found, exact].map(|[without, with]| with - without);
    assert!((gain - exact_gain).abs() < GAIN_ERROR_NATS, "problem {seed}: {gain} for {exact_gain}");
}

/// Products less what registration and geometry take, against the inverse of the data's covariance under geometry, in the
/// complement of the registration's columns.
#[test]
fn what_the_nuisance_takes_of_a_candidate_is_what_dense_matrices_say() {
    const RATIO: f64 = 2e4;
    let problem = problem(5, 2e-5, 1.0, 0.5);
    let noise = NoisePrior { known: None, from_repeats: false, stated_more_m: None };
    let (design, nuisance) = problem.nuisance(noise);
    let sums = design.products(&design.columns_of(&problem.dataset, &problem.candidate)).sum(&[0]);
    let absorbed = nuisance.absorbed(&nuisance.project(&sums), &sums, RATIO);
    let of_data = nuisance.absorbed_of_data(RATIO);
    let own = sums.own[(0, 0)] - absorbed.column(0).norm_squared();
    let with_data = sums.cross[(0, 0)] - absorbed.column(0).dot(&of_data);

    let flat = dense(&problem.dataset, |o| {
        let mut out = Vec::new();
        registration::twists(problem.dataset.at(o), 1, &mut out);
        out
    });
    let geometry = dense(&problem.dataset, geometry_columns);
    let a = dense(&problem.dataset, |o| {
        let mut out = Vec::new();
        problem.candidate.scaled_signature(problem.dataset.at(o), &mut out);
        out
    });
    let data = DVector::from_iterator(a.nrows(), problem.residuals.iter().flat_map(|r| r[..3].to_vec()));
    let outer = &flat * flat.clone().pseudo_inverse(1e-12).unwrap();
    let left = |m: &DMatrix<f64>| m - &outer * m;
    let geometry = left(&geometry);
    let covariance =
        DMatrix::identity(a.nrows(), a.nrows()) + &geometry * geometry.transpose() * RATIO.powi(2);
    let weighted = covariance.try_inverse().unwrap() * left(&a);
    let exact = [left(&a).dot(&weighted), data.dot(&weighted.column(0))];
    assert!((own - exact[0]).abs() < 1e-6 * exact[0], "{own} {exact:?}");
    assert!((with_data - exact[1]).abs() < 1e-6 * exact[1].abs(), "{with_data} {exact:?}");
}

/// Candidates of one to six parameters at once, with slow noise among what is projected out and without: what is left of each is what is
/// left of it by itself.
#[test]
fn candidates_at_once_are_what_each_is_by_itself() {
    let problem = problem(7, 2e-5, 1.0, 0.5);
    let noise = NoisePrior { known: None, from_repeats: false, stated_more_m: None };
    let (mut design, _) = problem.nuisance(noise);
    let testable = testable_effects(&problem.dataset).candidates;
    let cause: Vec<usize> = design.append(&design.columns_of(&problem.dataset, &problem.candidate)).collect();
    let slow =
        design.append(&DMatrix::from_fn(72, 3, |r, c| ((r % 3 == c) as u8 as f64) * (r as f64 / 9.0).cos()));
    let sums: Vec<_> = testable
        .iter()
        .map(|candidate| design.products(&design.columns_of(&problem.dataset, candidate)).sum(&[0]))
        .collect();
    let widths: BTreeSet<usize> = sums.iter().map(|sums| sums.own.nrows()).collect();
    assert!(widths.len() > 2, "{widths:?}");
    let near = |a: &DMatrix<f64>, b: &DMatrix<f64>, scale: f64| (a - b).amax() <= 1e-11 * scale;
    for ratio in [0.0, 1.5] {
        design.set_slow(SlowColumns { columns: slow.clone(), size_ratio: ratio });
        let nuisance = NuisanceModel::new(&design, &[0], &cause, noise);
        let together = nuisance.project_together(&sums.iter().collect::<Vec<_>>());
        assert_eq!(together.len(), sums.len());
        for (sums, together) in sums.iter().zip(&together) {
            let alone = nuisance.project(sums);
            assert!(near(&alone.own, &together.own, sums.own.amax()));
            assert!(near(&alone.geometry, &together.geometry, sums.cross.amax()));
            assert!((&alone.with_y - &together.with_y).amax() <= 1e-11 * sums.cross.amax());
        }
        assert!(nuisance.project_together(&[]).is_empty());
    }
}

/// Two of three causes taken out of a nuisance model, with slow noise and without, against one that was made of the third alone;
/// and one of the two put in again.
#[test]
fn causes_taken_out_leave_the_nuisance_model_of_the_others() {
    let problem = problem(6, 2e-5, 1.0, 0.5);
    let noise = NoisePrior::new(None, None);
    let (mut design, _) = problem.nuisance(noise);
    let library = testable_effects(&problem.dataset).candidates;
    let column = |design: &mut Design, kind, joint| {
        let wanted = |c: &&Candidate| c.kind == kind && c.variant.joint == Some(Axis::at(joint));
        let candidate = library.iter().find(wanted).unwrap();
        design.append(&design.columns_of(&problem.dataset, candidate)).collect::<Vec<usize>>()
    };
    use robot_model::deform::EffectKind::{GearEccentricity, JointCompliance, JointOffset};
    let [kept, first, second] = [(JointOffset, 1), (GearEccentricity, 2), (JointCompliance, 1)]
        .map(|(k, j)| column(&mut design, k, j));
    let slow =
        design.append(&DMatrix::from_fn(72, 3, |r, c| ((r % 3 == c) as u8 as f64) * (r as f64 / 9.0).cos()));
    let sums = design.products(&design.columns_of(&problem.dataset, &problem.candidate)).sum(&[0]);
    for ratio in [0.0, 1.5] {
        design.set_slow(SlowColumns { columns: slow.clone(), size_ratio: ratio });
        let of = |also: &[&Vec<usize>]| {
            let also: Vec<usize> = also.iter().flat_map(|columns| columns.iter().copied()).collect();
            NuisanceModel::new(&design, &[0], &also, noise)
        };
        let agree = |found: &NuisanceModel, expected: &NuisanceModel| {
            let [found, expected] = [found, expected].map(|nuisance| {
                let gain = nuisance.evidence(&nuisance.project(&sums));
                [nuisance.null().log_evidence, gain.log_evidence, nuisance.freedom(), nuisance.yy]
            });
            for (found, expected) in found.iter().zip(expected) {
                assert!((found - expected).abs() < 1e-7 * expected.abs(), "{ratio}: {found} {expected}");
            }
        };
        let both = [first.clone(), second.clone()].concat();
        let mut left = of(&[&kept, &first, &second]).without(&design, &[0], &both).unwrap();
        agree(&left, &of(&[&kept]));
        left.grow(&design, &[0], &first);
        agree(&left, &of(&[&kept, &first]));
    }
    // A column again: the first tells all of it, another cause does not.
    let again =
        design.append(&design.columns_from(kept[0]).columns(0, 1).into_owned()).collect::<Vec<usize>>();
    let twice = NuisanceModel::new(&design, &[0], &[&kept[..], &first, &again].concat(), noise);
    assert!(twice.without(&design, &[0], &kept).is_none());
    assert!(twice.without(&design, &[0], &first).is_some());
}

/// Two causes of one and of two parameters with sizes of their own, in geometry: against the determinant and the inverse of the data's
/// whole covariance, summed over the same sizes. From whatever sizes the search for the best begins.
#[test]
fn two_causes_together_are_as_likely_as_dense_matrices_say() {
    const NEAR: [f64; 2] = [4e4, 2e4];
    let problem = problem(7, 2e-5, 3.0, 0.5);
    let (mut design, nuisance) = problem.nuisance(NoisePrior::new(None, None));
    let library = testable_effects(&problem.dataset).candidates;
    let gear = library.iter().find(|c| {
        c.kind == robot_model::deform::EffectKind::GearEccentricity && c.variant.joint == Some(Axis::at(1))
    });
    let columns = [&problem.candidate, gear.unwrap()].map(|c| design.columns_of(&problem.dataset, c));
    let at: Vec<usize> = design.append(&columns[0]).collect();
    let [first, second] = [0, 1].map(|k| design.products(&columns[k]).sum(&[0]));
    let both = nuisance.project(&joined(&first, &second, &at));
    let found = nuisance.evidence_about(&both, 1, NEAR);

    let flat = dense(&problem.dataset, |o| {
        let mut out = Vec::new();
        registration::twists(problem.dataset.at(o), 1, &mut out);
        out
    });
    let outer = &flat * flat.clone().pseudo_inverse(1e-12).unwrap();
    let left = DMatrix::identity(flat.nrows(), flat.nrows()) - outer;
    let eigen = left.symmetric_eigen();
    let kept: Vec<usize> = (0..flat.nrows()).filter(|&i| eigen.eigenvalues[i] > 0.5).collect();
    let basis = eigen.eigenvectors.select_columns(&kept);
    let data = DVector::from_iterator(flat.nrows(), problem.residuals.iter().flat_map(|r| r[..3].to_vec()));
    let e = basis.tr_mul(&data);
    let geometry = basis.tr_mul(&dense(&problem.dataset, geometry_columns));
    let [a, b] = [&problem.candidate, gear.unwrap()].map(|c| {
        basis.tr_mul(&dense(&problem.dataset, |o| {
            let mut out = Vec::new();
            c.scaled_signature(problem.dataset.at(o), &mut out);
            out
        }))
    });
    let signal = |m: &DMatrix<f64>| (m.norm_squared() / kept.len() as f64).sqrt();
    let mut exact = f64::NEG_INFINITY;
    let of_geometry = signal(&geometry);
    for r in nuisance.geometry_terms.iter().map(|geometry| geometry.ratio) {
        for (i, k) in (0..25).map(|cell| (cell / 5 - 2, cell % 5 - 2)) {
            let [s, t] = [NEAR[0] * f64::from(i).exp2(), NEAR[1] * f64::from(k).exp2()];
            let covariance = DMatrix::identity(kept.len(), kept.len())
                + &geometry * geometry.transpose() * (r * r)
                + &a * a.transpose() * (s * s)
                + &b * b.transpose() * (t * t);
            let cholesky = covariance.cholesky().unwrap();
            let half_log_det: f64 = cholesky.l().diagonal().iter().map(|v| v.ln()).sum();
            let NoiseIntegral { log, sigma_m } = nuisance.marginal.at(e.dot(&cholesky.solve(&e)));
            let sizes = size_prior(s * sigma_m, s * signal(&a), f64::INFINITY)
                + size_prior(t * sigma_m, t * signal(&b), f64::INFINITY);
            exact = log_add(
                exact,
                log - half_log_det + geometry_prior(r * sigma_m, r * of_geometry, f64::INFINITY) + sizes,
            );
        }
    }
    assert!((found.log_evidence - exact).abs() < 1e-6, "{} {exact}", found.log_evidence);

    let from_afar = [0.125, 8.0].map(|off| nuisance.evidence_of_two(&both, 1, NEAR.map(|near| near * off)));
    for peak in from_afar {
        assert!((peak.log_evidence - exact).abs() < GAIN_ERROR_NATS, "{} {exact}", peak.log_evidence);
        assert!(peak.signs[0] > 3.0, "{:?}", peak.signs);
    }
}

/// Two causes that differ by a ten-thousandth of their length, beside a third. What the second tells beyond the first is less than the
/// rounding of factors (6e-8 of the length) would leave of a fourth one after it; the evidence of the third is that without the
/// second, however the second is rounded.
#[test]
fn a_cause_that_only_rounding_tells_from_another_takes_nothing_of_the_data() {
    let problem = problem(5, 3e-5, 1.0, 0.2);
    let n = problem.dataset.observations.len();
    let whitening = Whitening::independent(vec![1.0; n], 0.2);
    let mut design = Design::of_all(&problem.dataset, &problem.residuals, 1, whitening);
    let noise = NoisePrior::new(None, Some(3e-5));
    let third = design.sums(&design.columns_of(&problem.dataset, &problem.candidate));
    let mut random = SplitMix64::new(11);
    let mut like = |of: &DMatrix<f64>, share: f64| {
        let length = of.norm() / (of.len() as f64).sqrt();
        of + DMatrix::from_fn(of.nrows(), 1, |_, _| share * length * random.normal())
    };
    let first = DMatrix::from_fn(3 * n, 1, |r, _| ((r * 7) % 13) as f64 / 4.0 - 1.5);
    let second = like(&first, 1e-4);
    let mut gain = |columns: &[&DMatrix<f64>]| {
        let width = design.width();
        let at: Vec<usize> = columns.iter().flat_map(|columns| design.append(columns)).collect();
        let nuisance = NuisanceModel::new(&design, &[0], &at, noise);
        design.truncate(width);
        nuisance.evidence(&nuisance.project(&third)).log_evidence - nuisance.null().log_evidence
    };
    let alone = gain(&[&first]);
    let rounded =
        |seed: usize| second.map_with_location(|r, _, v| v * (1.0 + 6e-8 * ((r * seed) as f64).sin()));
    for seed in 1..5 {
        let beside = gain(&[&first, &rounded(seed)]);
        assert!((beside - alone).abs() < 1e-9, "{beside} {alone}");
    }
    // One that differs by a hundredth takes a direction of its own.
    let other = like(&first, 1e-2);
    assert!((gain(&[&first, &other]) - alone).abs() > 1e-6);
}

//! How far the causes found turn each joint, and whether so far that the arm is no longer linear in them.

use super::model::FittedModel;
use inference::dataset::Dataset;
use inference::effects::Motion;
use inference::linearise::shift_m;
use robot_model::robot::Joints;

/// Terms of second order that move a point by more than this share of the noise are seen over many rows.
const SHARE: f64 = 0.2;

/// By how much the causes of a model that turn one joint have turned it at each observation, radians; metres of one that slides.
#[must_use]
pub(super) fn joint_turns(fitted: &FittedModel<'_>) -> Vec<Joints> {
    let FittedModel { linear, model, workspace } = fitted;
    let dataset = &linear.dataset;
    let fit = fitted.fit(&model.chosen);
    let mut factors = Vec::new();
    let mut turns = vec![Joints::all(dataset.joints(), 0.0); dataset.observations.len()];
    for cause in &model.chosen {
        let candidate = &workspace.library.candidates[cause.candidate];
        let Some(Motion::Joint(joint)) = candidate.effect().motion(&candidate.variant) else { continue };
        for (turn, observation) in turns.iter_mut().zip(&dataset.observations) {
            factors.clear();
            candidate.effect().factors(&candidate.variant, dataset.at(observation), &mut factors);
            let sizes = cause.columns.iter().zip(&candidate.prior_sigma);
            turn[joint.index()] += factors
                .iter()
                .zip(sizes)
                .map(|(factor, (&column, sigma))| factor * fit.coefficients[column - 1] * sigma)
                .sum::<f64>();
        }
    }
    turns
}

/// Whether `turns` are so far from the ones that the arm is linear about that what is of second order in them is seen beside the noise.
#[must_use]
pub(super) fn are_curved(turns: &[Joints], about: &[Joints], dataset: &Dataset, noise_m: f64) -> bool {
    let none = Joints::all(dataset.joints(), 0.0);
    dataset.observations.iter().zip(turns).enumerate().any(|(i, (observation, turn))| {
        let about = about.get(i).unwrap_or(&none);
        dataset.turning().any(|j| {
            let arm_m = shift_m(&observation.jacobian_column(j));
            0.5 * arm_m * (turn[j] - about[j]).abs() * (turn[j].abs() + about[j].abs()) > SHARE * noise_m
        })
    })
}

//! Whether a drawn shape is outside the library: no effect of it takes half of what the shape does over these poses.

use super::arm::Disturbance;
use super::effect::{Effect, SizedEffect};
use super::harmonics::Harmonics;
use super::registration::left_by_registration;
use super::rng::Rng;
use super::run::MeasuredRun;
use super::smooth::SmoothFunction;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::FRAC_PI_2;

/// An effect that takes more than this fraction of a shape's square explains it.
const LARGEST_EXPLAINED_FRACTION: f64 = 0.5;
/// Functions drawn before a run is given up.
const TRIES: usize = 20;
/// Gear lines that are compared, per turn.
const LINES: std::ops::RangeInclusive<u32> = 1..=12;

/// `function`, or another of its family (another seed), that no effect of the library explains over the run; `None` where
/// hardly any is.
pub(super) fn sample_outside_library(
    run: &MeasuredRun<'_>,
    function: SmoothFunction,
    rng: &mut Rng,
) -> Option<SmoothFunction> {
    let library = library(run);
    let mut function = function;
    for _ in 0..TRIES {
        let shape = field(run, Effect::SmoothFunction(function));
        if shape.norm() > 0.0
            && library.iter().all(|effect| explained_fraction(effect, &shape) < LARGEST_EXPLAINED_FRACTION)
        {
            return Some(function);
        }
        function = function.reseeded(rng);
    }
    None
}

/// What an effect of usual size does to the points, beside base and tool; all coordinates.
fn field(run: &MeasuredRun<'_>, effect: Effect) -> DVector<f64> {
    let [low, high] = effect.usual();
    let off_m = run.off_m(&[SizedEffect { effect, amplitude: (low * high).sqrt() }], &Disturbance::default());
    left_by_registration(&run.flanges, &run.nominal_m, &off_m)
}

/// The fraction of the square of `shape` that the best mixture of `columns` takes.
fn explained_fraction(columns: &DMatrix<f64>, shape: &DVector<f64>) -> f64 {
    let svd = columns.clone().svd(true, true);
    let Ok(solved) = svd.solve(shape, 1e-9 * svd.singular_values.max().max(1e-300)) else { return 0.0 };
    1.0 - (shape - columns * solved).norm_squared() / shape.norm_squared()
}

/// Every effect of the library with all that it leaves open (phases, directions), as columns.
fn library(run: &MeasuredRun<'_>) -> Vec<DMatrix<f64>> {
    let units: Vec<[f64; 6]> = (0..6).map(|k| std::array::from_fn(|i| f64::from(u8::from(i == k)))).collect();
    let phases = [0.0, FRAC_PI_2];
    let last_min = run.states.last().map_or(0.0, |state| state.t_min);
    let mut all: Vec<Vec<Effect>> = vec![
        vec![Effect::BaseTilt],
        vec![Effect::InstrumentScale],
        vec![Effect::PayloadMass],
        units.iter().map(|&direction| Effect::BaseDrift { direction }).collect(),
        units.iter().map(|&direction| Effect::ToolDrift { direction }).collect(),
    ];
    for k in 1..8 {
        let t0_min = last_min * f64::from(k) / 8.0;
        all.push(units.iter().map(|&direction| Effect::BaseStep { t0_min, direction }).collect());
        all.push(units.iter().map(|&direction| Effect::ToolStep { t0_min, direction }).collect());
    }
    let joints = run.arm.joints();
    for joint in 1..=joints {
        all.push(vec![Effect::JointOffset { joint }]);
        all.push(units.iter().map(|&direction| Effect::LinkGeometry { joint, direction }).collect());
        all.push(vec![Effect::JointCompliance { joint }]);
        all.push(vec![Effect::JointGain { joint }]);
        all.push(vec![Effect::Backlash { joint, holding_n_m: f64::INFINITY }]);
        all.push(vec![Effect::ThermalLinkGrowth { joint }]);
        all.push(vec![Effect::ThermalJointDrift { joint }]);
        all.extend(
            (1..joints).filter(|link| *link == joint).map(|joint| vec![Effect::LinkBending { joint }]),
        );
        for joint_b in (1..=joints).filter(|b| *b != joint) {
            all.push(vec![Effect::JointCoupling { joint, joint_b }]);
        }
        all.extend((1..8).map(|k| vec![Effect::JointStep { joint, t0_min: last_min * f64::from(k) / 8.0 }]));
        let pure = Harmonics::NONE;
        let line = |n, phase_rad| Effect::GearMesh { joint, n, phase_rad, harmonics: pure };
        all.extend(LINES.map(|n| phases.map(|phase_rad| line(n, phase_rad)).to_vec()));
    }
    all.into_iter()
        .map(|effects| effects.into_iter().map(|effect| field(run, effect)).collect::<Vec<DVector<f64>>>())
        // A link without length has no direction to bend in.
        .filter(|columns| columns.iter().flatten().all(|v| v.is_finite()))
        .map(|columns| DMatrix::from_columns(&columns))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arm::ScrewArm;
    use crate::poses::{RunSpec, Spread, states};
    use crate::smooth::{Domain, MovedPart};
    use nalgebra::{Point3, Vector3};
    use robot_model::robot::SerialArm;

    /// A joint's function that is so long that it is a line is its gain, and is never let through; a short one is.
    #[test]
    fn a_function_that_is_a_line_is_the_librarys_and_one_that_winds_is_not() {
        let robot = SerialArm::built_in("irb140").unwrap();
        let arm = ScrewArm::new(&robot);
        let tool_m = Vector3::new(0.05, 0.02, 0.1);
        let spec = RunSpec { spread: Spread::Wide, n: 60, repeats: 0, tool_m, payloads_kg: [0.0, 0.0] };
        let states = states(&robot, &arm, &mut Rng::new(7, 0), &spec);
        let flanges: Vec<_> = states.iter().map(|s| arm.flange(&s.q_rad, &Disturbance::default())).collect();
        let nominal_m = flanges.iter().map(|f| (f * Point3::from(tool_m)).coords).collect();
        let run = MeasuredRun { arm: &arm, tool_m, states, flanges, nominal_m };
        let of = |length| SmoothFunction {
            domain: Domain::JointAngle(3),
            moves: MovedPart::Joint(3),
            length,
            seed: 5,
        };
        assert_eq!(sample_outside_library(&run, of(60.0), &mut Rng::new(1, 0)), None);
        let found = sample_outside_library(&run, of(0.3), &mut Rng::new(1, 0)).unwrap();
        assert_eq!((found.domain, found.length), (Domain::JointAngle(3), 0.3));
    }
}

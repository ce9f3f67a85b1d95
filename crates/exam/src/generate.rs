//! One data set: a virtual robot that is measured while its effects are at work.

use super::arm::{Disturbance, ScrewArm};
use super::csv::RunRecord;
use super::effect::{ArmState, Effect, SizedEffect};
use super::noise::RowNoise;
use super::outside;
use super::poses::{CommandedRow, MoreRows, RunSpec, elsewhere, states_and_more, states_of};
use super::recipe::{Recipe, RequestedEffect};
use super::rng::Rng;
use super::run::MeasuredRun;
use super::truth::{InjectedEffect, Truth};
use nalgebra::Vector3;
use robot_model::robot::SerialArm;
use robot_model::units::{m_from_mm, mm_from_m};
use serde::{Deserialize, Serialize};

/// What the diagnosis is given beside the measurements.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Task {
    /// A built-in robot's name.
    pub robot: String,
    /// The tool, known to about a millimetre.
    pub tool_mm: Option<[f64; 3]>,
    /// The noise as stated.
    pub sigma_mm: Option<f64>,
}

/// A data set: what is seen and what is withheld.
#[derive(Clone, Debug)]
pub struct DataSet {
    /// Text of the measurement file (CSV).
    pub csv: String,
    /// What goes with it.
    pub task: Task,
    /// What was put in.
    pub truth: Truth,
}

/// Makes a data set; `None` where an effect of the recipe leaves no signal over its poses, or would have to
/// be out of all proportion to be as large as asked.
#[must_use]
pub fn data_set(robot: &SerialArm, robot_name: &str, recipe: &Recipe, rng: &mut Rng) -> Option<DataSet> {
    continued_set(robot, robot_name, recipe, MoreRows::NONE, rng)
}

/// The data set that [`data_set`] makes of the same draws, and after its rows those of `more`, measured on the same robot.
#[must_use]
pub fn continued_set(
    robot: &SerialArm,
    robot_name: &str,
    recipe: &Recipe,
    more: MoreRows<'_>,
    rng: &mut Rng,
) -> Option<DataSet> {
    let arm = ScrewArm::new(robot);
    let tool_m = Vector3::new(rng.uniform(0.03, 0.12), rng.uniform(-0.08, 0.08), rng.uniform(0.05, 0.15));
    let run = RunSpec {
        spread: recipe.spread,
        n: recipe.n,
        repeats: recipe.repeats,
        tool_m,
        payloads_kg: recipe.payloads_kg,
    };
    let states = states_and_more(robot, &arm, rng, &run, more);
    let distinct = recipe.n - recipe.repeats.min(recipe.n / 2);
    let poses = (0..recipe.n).map(|k| if k >= distinct { k - distinct } else { k });
    let poses = poses.chain(more.rows.iter().map(|row| distinct + row.pose)).collect();
    let own = states[..recipe.n].to_vec();
    let rows =
        RunRows { tool_m, states, poses, later: more.seed, with_nests: more.with_nests, amplitudes: None };
    let mut set = measured(&arm, robot_name, recipe, rows, rng)?;
    let others = (0..OTHER_ROWS.div_ceil(recipe.n)).flat_map(|_| elsewhere(robot, &arm, rng, &run, &own));
    let others = MeasuredRun::new(&arm, tool_m, others.collect());
    set.truth.oracle_ratio_elsewhere = Some(oracle_ratio(&others, &set.truth));
    Some(set)
}

/// Rows at other poses that a shrink is held against: the registration's nine parameters are then nothing.
const OTHER_ROWS: usize = 1000;

/// What is left at the rows of `run` without the effects that `truth` is asked about, over what is there with them, rms; noise and
/// small effects with both.
fn oracle_ratio(run: &MeasuredRun<'_>, truth: &Truth) -> f64 {
    let noise_rms_m = m_from_mm(truth.sigma_mm) * 3.0_f64.sqrt();
    let with_noise =
        |effects: &[SizedEffect]| noise_rms_m.hypot(run.rms_m(&run.off_m(effects, &Disturbance::default())));
    let all = truth.sized();
    with_noise(&all[truth.effects.len()..]) / with_noise(&all)
}

/// A data set over poses that others planned, with a tool of theirs and the recipe's effects at these `amplitudes`; the
/// recipe's own poses and sizes are not used.
#[must_use]
pub fn planned_set(
    robot: &SerialArm,
    robot_name: &str,
    recipe: &Recipe,
    tool_m: Vector3<f64>,
    rows: &[CommandedRow],
    amplitudes: &[f64],
    rng: &mut Rng,
) -> Option<DataSet> {
    let arm = ScrewArm::new(robot);
    let recipe = Recipe { n: rows.len(), ..recipe.clone() };
    let rows = RunRows {
        tool_m,
        states: states_of(&arm, rng, tool_m, rows),
        poses: rows.iter().map(|row| row.pose).collect(),
        later: 0,
        with_nests: false,
        amplitudes: Some(amplitudes),
    };
    measured(&arm, robot_name, &recipe, rows, rng)
}

/// The rows of a run, drawn or planned; those past the recipe's number are more of another day and leave its draws alone.
struct RunRows<'a> {
    tool_m: Vector3<f64>,
    states: Vec<ArmState>,
    poses: Vec<usize>,
    /// Seed of the noise in rows past the recipe's number.
    later: u64,
    /// Whether nests on the base are read at those.
    with_nests: bool,
    /// Sizes of the effects; `None`: as large as the recipe asks.
    amplitudes: Option<&'a [f64]>,
}

/// Measures the rows and says what is true of them.
fn measured(
    arm: &ScrewArm,
    robot_name: &str,
    recipe: &Recipe,
    rows: RunRows<'_>,
    rng: &mut Rng,
) -> Option<DataSet> {
    let RunRows { tool_m, mut states, poses, later, with_nests, amplitudes } = rows;
    let more = states.split_off(recipe.n.min(states.len()));
    let mut run = MeasuredRun::new(arm, tool_m, states);
    let injected = injected(&run, recipe, amplitudes, rng)?;
    let small = small(&run, recipe);
    let sized = |effects: &[InjectedEffect]| effects.iter().map(InjectedEffect::sized).collect::<Vec<_>>();
    let effects = [sized(&injected), sized(&small)].concat();
    let background = background(arm, recipe, rng);
    let mut noise = RowNoise::draw(recipe, rng);
    let mut later = Rng::new(later, LATER);
    if !more.is_empty() {
        noise.extend(RowNoise::draw(&Recipe { n: more.len(), ..recipe.clone() }, &mut later));
        run = MeasuredRun::new(arm, tool_m, run.states.into_iter().chain(more).collect());
    }
    let with = noise.added_to(run.off_m(&effects, &background));
    let without = noise.added_to(run.off_m(&sized(&small), &background));
    let truth = Truth {
        name: recipe.name.clone(),
        kind: recipe.kind,
        effects: injected,
        small,
        n: run.states.len(),
        sigma_mm: recipe.sigma_mm,
        spread: recipe.spread,
        recorded: recipe.recorded,
        slow_noise: recipe.slowness > 0.0,
        slowness: recipe.slowness,
        outliers: recipe.outliers,
        geometry: recipe.geometry,
        before_rms_mm: mm_from_m(run.sound_rms_m(&with, &noise.is_outlier)),
        oracle_rms_mm: mm_from_m(run.sound_rms_m(&without, &noise.is_outlier)),
        oracle_ratio_elsewhere: None,
        gaps: recipe.gaps.clone(),
    };
    let record = RunRecord {
        run: &run,
        recipe,
        poses: &poses,
        effects: &effects,
        background: &background,
        off_m: &with,
        with_nests,
    };
    let csv = record.csv(rng, &mut later);
    let stated = tool_m.map(|c| mm_from_m(c) + 0.5 * rng.normal());
    let task = Task {
        robot: robot_name.to_owned(),
        tool_mm: rng.chance(0.7).then_some([stated.x, stated.y, stated.z]),
        sigma_mm: recipe.stated_sigma_mm,
    };
    Some(DataSet { csv, task, truth })
}

/// The recipe's effects, as large as asked or at these `amplitudes`; `None` where one leaves no signal or is out of all proportion.
fn injected(
    run: &MeasuredRun<'_>,
    recipe: &Recipe,
    amplitudes: Option<&[f64]>,
    rng: &mut Rng,
) -> Option<Vec<InjectedEffect>> {
    let noise_rms_m = m_from_mm(recipe.sigma_mm) * 3.0_f64.sqrt();
    let mut injected = Vec::new();
    for (k, RequestedEffect { effect, rho }) in recipe.effects.iter().enumerate() {
        if !effect.fits(run.arm.joints()) {
            return None;
        }
        let unscaled =
            matches!(effect, Effect::JointRounding | Effect::SwappedAxes | Effect::RowFault { .. });
        let effect = match effect {
            Effect::SmoothFunction(function) => {
                Effect::SmoothFunction(outside::sample_outside_library(run, *function, rng)?)
            }
            other => *other,
        };
        let amplitude = match amplitudes.and_then(|a| a.get(k)) {
            Some(given) => *given,
            None if unscaled => 1.0,
            None => run.amplitude(effect, rho * noise_rms_m)?,
        };
        if amplitude > 4.0 * effect.usual()[1] {
            return None;
        }
        injected.push(measured_effect(run, SizedEffect { effect, amplitude }, noise_rms_m));
    }
    Some(injected)
}

/// The recipe's small effects, those left out that show nothing over these poses.
fn small(run: &MeasuredRun<'_>, recipe: &Recipe) -> Vec<InjectedEffect> {
    let noise_rms_m = m_from_mm(recipe.sigma_mm) * 3.0_f64.sqrt();
    let made = |RequestedEffect { effect, rho }: &RequestedEffect| {
        let amplitude = effect
            .fits(run.arm.joints())
            .then(|| run.amplitude(*effect, rho * noise_rms_m))
            .flatten()
            .filter(|amplitude| *amplitude <= 4.0 * effect.usual()[1])?;
        Some(measured_effect(run, SizedEffect { effect: *effect, amplitude }, noise_rms_m))
    };
    recipe.small.iter().filter_map(made).collect()
}

/// An effect with what shows of it.
fn measured_effect(run: &MeasuredRun<'_>, sized: SizedEffect, noise_rms_m: f64) -> InjectedEffect {
    let rms_m = run.rms_m(&run.off_m(&[sized], &Disturbance::default()));
    let SizedEffect { effect, amplitude } = sized;
    InjectedEffect { effect, amplitude, rms_mm: mm_from_m(rms_m), rho: rms_m / noise_rms_m }
}

/// Geometry errors of all joints, in parts of the manufacturing tolerance.
fn background(arm: &ScrewArm, recipe: &Recipe, rng: &mut Rng) -> Disturbance {
    let mut background = Disturbance::default();
    for i in 0..arm.joints() {
        background.seat_m[i] = Vector3::from(rng.normal3()) * (1.5e-4 * recipe.geometry);
        background.seat_rad[i] = Vector3::from(rng.normal3()) * (2.5e-4 * recipe.geometry);
    }
    background
}

/// The stream of noise in rows that are measured later.
const LATER: u64 = 0x1a7e;

#[cfg(test)]
mod tests;

//! One data set: a virtual robot that is measured while its effects are at work.

use super::arm::{Disturbance, ScrewArm};
use super::csv::RunRecord;
use super::effect::{ArmState, Effect, SizedEffect};
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
    let rows = RunRows { tool_m, states, poses, later: more.seed, amplitudes: None };
    let mut set = measured(&arm, robot_name, recipe, rows, rng)?;
    let others = (0..OTHER_ROWS.div_ceil(recipe.n)).flat_map(|_| elsewhere(robot, &arm, rng, &run, &own));
    let others = MeasuredRun::new(&arm, tool_m, others.collect());
    set.truth.oracle_ratio_elsewhere = Some(oracle_ratio(&others, &set.truth));
    Some(set)
}

/// Rows at other poses that a shrink is held against: the registration's nine parameters are then nothing.
const OTHER_ROWS: usize = 1000;

/// What is left at the rows of `run` without the effects of `truth`, over what is there with them, rms, noise with both.
fn oracle_ratio(run: &MeasuredRun<'_>, truth: &Truth) -> f64 {
    let effects: Vec<SizedEffect> = truth.effects.iter().map(InjectedEffect::sized).collect();
    let noise_rms_m = m_from_mm(truth.sigma_mm) * 3.0_f64.sqrt();
    let effect_rms_m = run.rms_m(&run.off_m(&effects, &Disturbance::default()));
    noise_rms_m / noise_rms_m.hypot(effect_rms_m)
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
    let RunRows { tool_m, mut states, poses, later, amplitudes } = rows;
    let more = states.split_off(recipe.n.min(states.len()));
    let mut run = MeasuredRun::new(arm, tool_m, states);
    let injected = injected(&run, recipe, amplitudes, rng)?;
    let effects: Vec<SizedEffect> = injected.iter().map(InjectedEffect::sized).collect();
    let background = background(arm, recipe, rng);
    let mut noise = RowNoise::draw(recipe, rng);
    let mut later = Rng::new(later, LATER);
    if !more.is_empty() {
        noise.extend(RowNoise::draw(&Recipe { n: more.len(), ..recipe.clone() }, &mut later));
        run = MeasuredRun::new(arm, tool_m, run.states.into_iter().chain(more).collect());
    }
    let with = noise.added_to(run.off_m(&effects, &background));
    let without = noise.added_to(run.off_m(&[], &background));
    let truth = Truth {
        name: recipe.name.clone(),
        kind: recipe.kind,
        effects: injected,
        n: run.states.len(),
        sigma_mm: recipe.sigma_mm,
        spread: recipe.spread,
        recorded: recipe.recorded,
        slow_noise: recipe.slowness > 0.0,
        outliers: recipe.outliers,
        geometry: recipe.geometry,
        before_rms_mm: mm_from_m(run.sound_rms_m(&with, &noise.is_outlier)),
        oracle_rms_mm: mm_from_m(run.sound_rms_m(&without, &noise.is_outlier)),
        oracle_ratio_elsewhere: None,
    };
    let record = RunRecord {
        run: &run,
        recipe,
        poses: &poses,
        effects: &effects,
        background: &background,
        off_m: &with,
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
        let rms_m = run.rms_m(&run.off_m(&[SizedEffect { effect, amplitude }], &Disturbance::default()));
        let (rms_mm, rho) = (mm_from_m(rms_m), rms_m / noise_rms_m);
        injected.push(InjectedEffect { effect, amplitude, rms_mm, rho });
    }
    Some(injected)
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

/// The noise of each row, and which rows are grossly wrong.
struct RowNoise {
    noise_m: Vec<Vector3<f64>>,
    is_outlier: Vec<bool>,
}

impl RowNoise {
    fn draw(recipe: &Recipe, rng: &mut Rng) -> Self {
        let sigma_m = m_from_mm(recipe.sigma_mm);
        let fresh = (1.0 - recipe.slowness * recipe.slowness).sqrt();
        let mut last = Vector3::from(rng.normal3());
        let row = |_| {
            last = last * recipe.slowness + Vector3::from(rng.normal3()) * fresh;
            let is_outlier = rng.chance(recipe.outliers);
            let factor = if is_outlier { rng.uniform(8.0, 30.0) } else { 1.0 };
            (last * (sigma_m * factor), is_outlier)
        };
        let (noise_m, is_outlier) = (0..recipe.n).map(row).unzip();
        Self { noise_m, is_outlier }
    }

    /// Puts the noise of later rows behind.
    fn extend(&mut self, later: Self) {
        self.noise_m.extend(later.noise_m);
        self.is_outlier.extend(later.is_outlier);
    }

    fn added_to(&self, off_m: Vec<Vector3<f64>>) -> Vec<Vector3<f64>> {
        off_m.iter().zip(&self.noise_m).map(|(off, noise)| off + noise).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::poses::{Recorded, Spread};
    use crate::truth::QuestionKind;

    fn recipe(effect: Effect, rho: f64) -> Recipe {
        Recipe {
            name: "one".into(),
            kind: QuestionKind::One,
            effects: vec![RequestedEffect { effect, rho }],
            n: 60,
            repeats: 10,
            sigma_mm: 0.02,
            stated_sigma_mm: Some(0.02),
            spread: Spread::Wide,
            recorded: Recorded { temperature: true, orientation: true, ..Recorded::NOTED },
            slowness: 0.0,
            outliers: 0.0,
            geometry: 0.0,
            payloads_kg: [0.0, 3.0],
        }
    }

    #[test]
    fn the_effect_is_as_large_as_asked_and_the_oracle_is_left_with_the_noise() {
        let robot = SerialArm::built_in("irb140").unwrap();
        for seed in 0..5 {
            let wanted = 3.0;
            let recipe = recipe(Effect::JointCompliance { joint: 2 }, wanted);
            let set = data_set(&robot, "irb140", &recipe, &mut Rng::new(seed, 0)).unwrap();
            assert!((set.truth.effects[0].rho - wanted).abs() < 0.01, "{:?}", set.truth.effects);
            let noise_mm = 0.02 * 3.0_f64.sqrt();
            // rms of 180 numbers: a relative standard error of 1/sqrt(2*171) = 5.4 %; four of them
            assert!((set.truth.oracle_rms_mm / noise_mm - 1.0).abs() < 0.22, "{}", set.truth.oracle_rms_mm);
            let whole = (wanted * wanted + 1.0).sqrt() * noise_mm;
            assert!((set.truth.before_rms_mm / whole - 1.0).abs() < 0.15, "{}", set.truth.before_rms_mm);
            // Noise over all, as everywhere: an effect of the same rms at other poses drawn alike.
            let elsewhere = set.truth.oracle_ratio_elsewhere.unwrap() * (wanted * wanted + 1.0).sqrt();
            assert!((elsewhere - 1.0).abs() < 0.2, "{elsewhere}");
        }
    }

    #[test]
    fn an_offset_of_joint_1_leaves_no_signal() {
        let robot = SerialArm::built_in("irb140").unwrap();
        let recipe = recipe(Effect::JointOffset { joint: 1 }, 2.0);
        assert!(data_set(&robot, "irb140", &recipe, &mut Rng::new(3, 0)).is_none());
    }

    #[test]
    fn every_row_has_every_column_and_the_same_seed_the_same_bytes() {
        let robot = SerialArm::built_in("irb140").unwrap();
        let make = || {
            let recipe = recipe(Effect::GearMesh { joint: 2, n: 20, phase_rad: 0.3 }, 1.0);
            data_set(&robot, "irb140", &recipe, &mut Rng::new(11, 2)).unwrap().csv
        };
        let csv = make();
        assert_eq!(csv, make());
        let columns = csv.lines().next().unwrap().split(',').count();
        assert_eq!(columns, 2 + 1 + 6 + 3 + 4 + 6 + 1 + 7);
        assert!(csv.lines().all(|line| line.split(',').count() == columns));
        assert_eq!(csv.lines().count(), 61);
    }
}

//! One data set: a virtual robot that is measured while its effects are at work.

use super::arm::{Arm, Disturbance};
use super::effect::{ArmState, Effect};
use super::poses::{CommandedRow, Recorded, RunSpec, Spread, states, states_of};
use super::registration::rms_after_registration_m;
use super::rng::Rng;
use super::truth::{InjectedEffect, QuestionKind, Truth};
use nalgebra::{Isometry3, Point3, UnitQuaternion, Vector3};
use robot_model::robot::Robot;
use robot_model::units::{deg_from_rad, m_from_mm, mm_from_m};
use serde::{Deserialize, Serialize};
use std::fmt::Write as _;

/// What a data set is to be.
#[derive(Clone, Debug, PartialEq)]
pub struct Recipe {
    /// Its name.
    pub name: String,
    /// What kind of question it is.
    pub kind: QuestionKind,
    /// Effects, each with the size it is to have: its rms at the point over the noise's rms.
    pub effects: Vec<(Effect, f64)>,
    /// Rows.
    pub n: usize,
    /// Of these, rows that come back to the first poses.
    pub repeats: usize,
    /// Noise of each coordinate, mm.
    pub sigma_mm: f64,
    /// What is told to be the noise; `None` = nothing is told.
    pub stated_sigma_mm: Option<f64>,
    /// How the poses are spread.
    pub spread: Spread,
    /// What is recorded.
    pub recorded: Recorded,
    /// Share of each row's noise that is the row's before; 0 is white.
    pub slowness: f64,
    /// Share of rows that are grossly wrong.
    pub outliers: f64,
    /// Geometry errors in the background, in parts of the manufacturing tolerance (0.15 mm, 0.25 mrad).
    pub geometry: f64,
    /// Payloads in turn, kg.
    pub payloads_kg: [f64; 2],
}

/// What the diagnosis is told besides the measurements.
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
    /// The measurement file.
    pub csv: String,
    /// What goes with it.
    pub task: Task,
    /// What was put in.
    pub truth: Truth,
}

struct MeasuredRun<'a> {
    arm: &'a Arm,
    tool_m: Vector3<f64>,
    states: Vec<ArmState>,
    flanges: Vec<Isometry3<f64>>,
    nominal_m: Vec<Vector3<f64>>,
}

impl MeasuredRun<'_> {
    fn flange(
        &self,
        k: usize,
        effects: &[(Effect, f64)],
        background: &Disturbance,
    ) -> (Isometry3<f64>, Disturbance) {
        let mut disturbance = *background;
        for (effect, amplitude) in effects {
            effect.disturb(self.arm, *amplitude, &self.states[k], &mut disturbance);
        }
        (self.arm.flange(&self.states[k].q_rad, &disturbance), disturbance)
    }

    /// Where the measured point stands, in the base frame.
    fn point_m(&self, k: usize, effects: &[(Effect, f64)], background: &Disturbance) -> Vector3<f64> {
        let (flange, disturbance) = self.flange(k, effects, background);
        let point = (flange * Point3::from(self.tool_m)).coords + disturbance.point_m;
        // an instrument that reads long does so from where it stands, two metres before the robot
        let from_instrument = point - INSTRUMENT_M;
        point + from_instrument * disturbance.instrument_scale
    }

    fn off_m(&self, effects: &[(Effect, f64)], background: &Disturbance) -> Vec<Vector3<f64>> {
        (0..self.states.len()).map(|k| self.point_m(k, effects, background) - self.nominal_m[k]).collect()
    }

    fn rms_m(&self, off_m: &[Vector3<f64>]) -> f64 {
        rms_after_registration_m(&self.flanges, &self.nominal_m, off_m)
    }

    /// The same over the rows that are not grossly wrong.
    fn sound_rms_m(&self, off_m: &[Vector3<f64>], is_outlier: &[bool]) -> f64 {
        let sound: Vec<usize> = (0..off_m.len()).filter(|&k| !is_outlier[k]).collect();
        let flanges: Vec<_> = sound.iter().map(|&k| self.flanges[k]).collect();
        let nominal_m: Vec<_> = sound.iter().map(|&k| self.nominal_m[k]).collect();
        let off_m: Vec<_> = sound.iter().map(|&k| off_m[k]).collect();
        rms_after_registration_m(&flanges, &nominal_m, &off_m)
    }
}

/// Where the instrument stands in the base frame, metres.
const INSTRUMENT_M: Vector3<f64> = Vector3::new(2.1, -0.6, 0.4);

/// The amplitude at which an effect has the wanted rms, found by proportion (the effects are small and so
/// nearly linear); `None` where it leaves no signal at all over these poses.
fn amplitude(run: &MeasuredRun<'_>, effect: Effect, wanted_rms_m: f64) -> Option<f64> {
    let [low, high] = effect.usual();
    let trial = (low * high).sqrt();
    let rms = run.rms_m(&run.off_m(&[(effect, trial)], &Disturbance::default()));
    (rms > 1e-9).then(|| trial * wanted_rms_m / rms)
}

/// Makes a data set; `None` where an effect of the recipe leaves no signal over its poses, or would have to
/// be out of all proportion to be as large as asked.
#[must_use]
pub fn data_set(robot: &Robot, robot_name: &str, recipe: &Recipe, rng: &mut Rng) -> Option<DataSet> {
    let arm = Arm::new(robot);
    let tool_m = Vector3::new(rng.uniform(0.03, 0.12), rng.uniform(-0.08, 0.08), rng.uniform(0.05, 0.15));
    let run = RunSpec {
        spread: recipe.spread,
        n: recipe.n,
        repeats: recipe.repeats,
        tool_m,
        payloads_kg: recipe.payloads_kg,
    };
    let states = states(robot, &arm, rng, &run);
    let distinct = recipe.n - recipe.repeats.min(recipe.n / 2);
    let poses = (0..recipe.n).map(|k| if k >= distinct { k - distinct } else { k }).collect();
    measured(&arm, robot_name, recipe, RunRows { tool_m, states, poses, amplitudes: None }, rng)
}

/// A data set over poses that others planned, with a tool of theirs and the recipe's effects at these `amplitudes`; the
/// recipe's own poses and sizes are not used.
#[must_use]
pub fn planned_set(
    robot: &Robot,
    robot_name: &str,
    recipe: &Recipe,
    tool_m: Vector3<f64>,
    rows: &[CommandedRow],
    amplitudes: &[f64],
    rng: &mut Rng,
) -> Option<DataSet> {
    let arm = Arm::new(robot);
    let recipe = Recipe { n: rows.len(), ..recipe.clone() };
    let rows = RunRows {
        tool_m,
        states: states_of(&arm, rng, tool_m, rows),
        poses: rows.iter().map(|row| row.pose).collect(),
        amplitudes: Some(amplitudes),
    };
    measured(&arm, robot_name, &recipe, rows, rng)
}

/// What is measured.
struct RunRows<'a> {
    tool_m: Vector3<f64>,
    states: Vec<ArmState>,
    poses: Vec<usize>,
    /// Sizes of the effects; `None`: as large as the recipe asks.
    amplitudes: Option<&'a [f64]>,
}

fn measured(
    arm: &Arm,
    robot_name: &str,
    recipe: &Recipe,
    rows: RunRows<'_>,
    rng: &mut Rng,
) -> Option<DataSet> {
    let RunRows { tool_m, states, poses, amplitudes } = rows;
    let flanges: Vec<_> = states.iter().map(|m| arm.flange(&m.q_rad, &Disturbance::default())).collect();
    let nominal_m = flanges.iter().map(|f| (f * Point3::from(tool_m)).coords).collect();
    let run = MeasuredRun { arm, tool_m, states, flanges, nominal_m };

    let noise_rms_m = m_from_mm(recipe.sigma_mm) * 3.0_f64.sqrt();
    let mut injected = Vec::new();
    let mut effects = Vec::new();
    for (k, (effect, rho)) in recipe.effects.iter().enumerate() {
        let unscaled = matches!(effect, Effect::JointRounding | Effect::SwappedAxes);
        let amplitude = match amplitudes.and_then(|a| a.get(k)) {
            Some(given) => *given,
            None if unscaled => 1.0,
            None => amplitude(&run, *effect, rho * noise_rms_m)?,
        };
        if amplitude > 4.0 * effect.usual()[1] {
            return None;
        }
        effects.push((*effect, amplitude));
        let rms_m = run.rms_m(&run.off_m(&[(*effect, amplitude)], &Disturbance::default()));
        injected.push(InjectedEffect {
            effect: *effect,
            amplitude,
            rms_mm: mm_from_m(rms_m),
            rho: rms_m / noise_rms_m,
        });
    }
    let mut background = Disturbance::default();
    for i in 0..6 {
        background.seat_m[i] = Vector3::from(rng.normal3()) * (1.5e-4 * recipe.geometry);
        background.seat_rad[i] = Vector3::from(rng.normal3()) * (2.5e-4 * recipe.geometry);
    }
    let (noise_m, is_outlier) = noise(recipe, rng);
    let clean = run.off_m(&effects, &background);
    let with: Vec<_> = clean.iter().zip(&noise_m).map(|(a, b)| a + b).collect();
    let without: Vec<_> = run.off_m(&[], &background).iter().zip(&noise_m).map(|(a, b)| a + b).collect();
    let truth = Truth {
        name: recipe.name.clone(),
        kind: recipe.kind,
        effects: injected,
        n: recipe.n,
        sigma_mm: recipe.sigma_mm,
        spread: recipe.spread,
        recorded: recipe.recorded,
        slow_noise: recipe.slowness > 0.0,
        outliers: recipe.outliers,
        geometry: recipe.geometry,
        before_rms_mm: mm_from_m(run.sound_rms_m(&with, &is_outlier)),
        oracle_rms_mm: mm_from_m(run.sound_rms_m(&without, &is_outlier)),
    };
    let csv = csv(&run, recipe, &poses, &effects, &background, &with, rng);
    let stated = tool_m.map(|c| mm_from_m(c) + 0.5 * rng.normal());
    let task = Task {
        robot: robot_name.to_owned(),
        tool_mm: rng.chance(0.7).then_some([stated.x, stated.y, stated.z]),
        sigma_mm: recipe.stated_sigma_mm,
    };
    Some(DataSet { csv, task, truth })
}

/// The noise of each row, and which rows are grossly wrong.
fn noise(recipe: &Recipe, rng: &mut Rng) -> (Vec<Vector3<f64>>, Vec<bool>) {
    let sigma_m = m_from_mm(recipe.sigma_mm);
    let fresh = (1.0 - recipe.slowness * recipe.slowness).sqrt();
    let mut last = Vector3::from(rng.normal3());
    (0..recipe.n)
        .map(|_| {
            last = last * recipe.slowness + Vector3::from(rng.normal3()) * fresh;
            let is_outlier = rng.chance(recipe.outliers);
            let factor = if is_outlier { rng.uniform(8.0, 30.0) } else { 1.0 };
            (last * (sigma_m * factor), is_outlier)
        })
        .unzip()
}

fn csv(
    run: &MeasuredRun<'_>,
    recipe: &Recipe,
    poses: &[usize],
    effects: &[(Effect, f64)],
    background: &Disturbance,
    off_m: &[Vector3<f64>],
    rng: &mut Rng,
) -> String {
    let recorded = recipe.recorded;
    let turn = Vector3::new(rng.uniform(-0.3, 0.3), rng.uniform(-0.3, 0.3), rng.uniform(-3.0, 3.0));
    let instrument_from_base = Isometry3::new(
        Vector3::new(rng.uniform(-3.0, 3.0), rng.uniform(-3.0, 3.0), rng.uniform(-1.0, 1.0)),
        turn,
    );
    let reflector = UnitQuaternion::from_scaled_axis(Vector3::from(rng.normal3()));
    let has = |wanted: fn(&Effect) -> bool| effects.iter().any(|(e, _)| wanted(e));
    let rounded = has(|e| matches!(e, Effect::JointRounding));
    let swapped = has(|e| matches!(e, Effect::SwappedAxes));
    let mut out = String::from("id,pose_id");
    if recorded.time {
        out += ",t_min";
    }
    out += ",q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm";
    if recorded.orientation {
        out += ",qw,qx,qy,qz";
    }
    if recorded.direction {
        out += ",dir1,dir2,dir3,dir4,dir5,dir6";
    }
    if recorded.payload {
        out += ",payload_kg";
    }
    if recorded.temperature {
        out += ",temp_j1_c,temp_j2_c,temp_j3_c,temp_j4_c,temp_j5_c,temp_j6_c,temp_air_c";
    }
    out.push('\n');
    for ((k, now), pose) in run.states.iter().enumerate().zip(poses) {
        // writing to a String cannot fail
        let _ = write!(out, "{k},{pose}");
        if recorded.time {
            let _ = write!(out, ",{:.2}", now.t_min);
        }
        for q in now.q_rad {
            let deg = deg_from_rad(q);
            let _ = if rounded { write!(out, ",{deg:.1}") } else { write!(out, ",{deg:.6}") };
        }
        let p = instrument_from_base * Point3::from(run.nominal_m[k] + off_m[k]);
        let [x, y, z] = [p.x, p.y, p.z].map(mm_from_m);
        let _ =
            if swapped { write!(out, ",{y:.4},{x:.4},{z:.4}") } else { write!(out, ",{x:.4},{y:.4},{z:.4}") };
        if recorded.orientation {
            // an orientation from three reflectors 0.1 m apart is as good as the points over that distance
            let blur = Vector3::from(rng.normal3()) * (m_from_mm(recipe.sigma_mm) / 0.1);
            let flange = run.flange(k, effects, background).0;
            let r = UnitQuaternion::from_scaled_axis(blur)
                * instrument_from_base.rotation
                * flange.rotation
                * reflector;
            let _ = write!(out, ",{:.8},{:.8},{:.8},{:.8}", r.w, r.i, r.j, r.k);
        }
        if recorded.direction {
            for d in now.direction {
                let _ = write!(out, ",{d}");
            }
        }
        if recorded.payload {
            let _ = write!(out, ",{:.2}", now.payload_kg);
        }
        if recorded.temperature {
            for warmer in now.warmer_k {
                let _ = write!(out, ",{:.2}", 21.0 + warmer + 0.1 * rng.normal());
            }
            let _ = write!(out, ",{:.2}", 21.0 + 0.1 * rng.normal());
        }
        out.push('\n');
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn recipe(effects: Vec<(Effect, f64)>) -> Recipe {
        Recipe {
            name: "one".into(),
            kind: QuestionKind::One,
            effects,
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
        let robot = Robot::built_in("irb140").unwrap();
        for seed in 0..5 {
            let wanted = 3.0;
            let recipe = recipe(vec![(Effect::JointCompliance { joint: 2 }, wanted)]);
            let set = data_set(&robot, "irb140", &recipe, &mut Rng::new(seed, 0)).unwrap();
            assert!((set.truth.effects[0].rho - wanted).abs() < 0.01, "{:?}", set.truth.effects);
            let noise_mm = 0.02 * 3.0_f64.sqrt();
            // rms of 180 numbers: a relative standard error of 1/sqrt(2*171) = 5.4 %; four of them
            assert!((set.truth.oracle_rms_mm / noise_mm - 1.0).abs() < 0.22, "{}", set.truth.oracle_rms_mm);
            let whole = (wanted * wanted + 1.0).sqrt() * noise_mm;
            assert!((set.truth.before_rms_mm / whole - 1.0).abs() < 0.15, "{}", set.truth.before_rms_mm);
        }
    }

    #[test]
    fn an_offset_of_joint_1_leaves_no_signal() {
        let robot = Robot::built_in("irb140").unwrap();
        let recipe = recipe(vec![(Effect::JointOffset { joint: 1 }, 2.0)]);
        assert!(data_set(&robot, "irb140", &recipe, &mut Rng::new(3, 0)).is_none());
    }

    #[test]
    fn every_row_has_every_column_and_the_same_seed_the_same_bytes() {
        let robot = Robot::built_in("irb140").unwrap();
        let make = || {
            let recipe = recipe(vec![(Effect::GearMesh { joint: 2, n: 20, phase_rad: 0.3 }, 1.0)]);
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

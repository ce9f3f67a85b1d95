//! An identified model: what a diagnosis found of one robot, as terms that move its joints and frames.
//!
//! A term is an effect of the library with its values in SI. The file (TOML, in mm and degrees) is read and written
//! by [`Identified::from_toml`] and [`Identified::to_toml`]; its layout is described in `docs/MODEL.md`. Knows
//! nothing of how a model is found, nor of RAPID.

mod drift;
mod error;
mod file;
mod parameters;
mod table_reader;
mod term;
mod verdict;

pub use error::ModelError;
pub use parameters::{Parameter, Unit};
pub(in crate::deform) use term::{ArmDelta, PoseState};
pub use term::{Estimate, Growth, PayloadScaling, TILT_ABOUT_AXIS_1, TILT_SHIFT, Term, compliance_of_link};

pub use verdict::{FoundBy, Verdict};

use super::EffectKind;
use crate::robot::{JointKind, Joints, RobotDigest};
use nalgebra::{Isometry3, Vector3};

/// When, and how warm: what the terms of a model depend on besides the joints and the load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThermalState {
    /// Minutes since the cold start; infinite when everything has settled.
    pub t_min: f64,
    /// Temperature of each joint, degrees Celsius, where it is known.
    pub joint_temperature_c: Option<Joints>,
}

/// The ranges in which the model was found.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct MeasuredRange {
    /// Rows of the measurement.
    pub rows: usize,
    /// Lowest and highest angle of each joint, radians; of those that slide metres. `None` where the file does not say.
    pub q_rad: Option<Joints<[f64; 2]>>,
    /// Minutes since the cold start.
    pub t_min: Option<[f64; 2]>,
    /// Temperature of each joint, degrees Celsius.
    pub joint_temperature_c: Option<Joints<[f64; 2]>>,
    /// Lowest and highest payload that was declared, kg.
    pub payload_kg: Option<[f64; 2]>,
}

/// How the measurement hung on the robot: nothing that a program needs, but what an exact comparison does.
#[derive(Clone, Debug, PartialEq)]
pub struct Mounting {
    /// The robot's base in the instrument's frame. Metres.
    pub instrument_from_base: Isometry3<f64>,
    /// Each target's place in the flange's frame, metres.
    pub tools_m: Vec<Vector3<f64>>,
    /// Centre of gravity of the payload that was carried, flange frame, metres, where it was found from what gave under it.
    pub payload_m: Option<Vector3<f64>>,
}

/// A model of one robot, as found.
#[derive(Clone, Debug, PartialEq)]
pub struct Identified {
    /// Name of the robot in its file.
    pub robot: String,
    /// What the robot's file said when the model was found; `None` of an older model.
    pub robot_digest: Option<RobotDigest>,
    /// How each joint of the robot moves.
    pub joint_kinds: Joints<JointKind>,
    /// File or set it was found from.
    pub data: String,
    /// SHA-256 of the data, hexadecimal.
    pub data_sha256: String,
    /// What it was written of, the key `verdict` of its file; `None` where nothing says so.
    pub found_by: Option<FoundBy>,
    /// Noise of one coordinate, metres.
    pub sigma_m: Option<f64>,
    /// Time constant with which the robot cools while it stands, minutes; `None` where nothing is known of it.
    pub tau_cool_min: Option<f64>,
    /// Where it was found.
    pub measured_range: MeasuredRange,
    /// rms of a region of the workspace held out whole, registration only and with a model that never saw it, metres.
    pub region_held_out_m: Option<[f64; 2]>,
    /// How it was measured.
    pub mounting: Option<Mounting>,
    /// Effects with their values, causes first.
    pub terms: Vec<Term>,
}

impl Identified {
    /// Where the model gained nothing in a region of the workspace that was held out whole: rms before and after, metres.
    #[must_use]
    pub fn gains_nothing_elsewhere(&self) -> Option<[f64; 2]> {
        self.region_held_out_m.filter(|[before_m, after_m]| after_m >= before_m)
    }
}

/// An empty model of a robot with six turning joints.
impl Default for Identified {
    fn default() -> Self {
        Self {
            robot: String::new(),
            robot_digest: None,
            joint_kinds: Joints::all(SIX, JointKind::Revolute),
            data: String::new(),
            data_sha256: String::new(),
            found_by: None,
            sigma_m: None,
            tau_cool_min: None,
            measured_range: MeasuredRange::default(),
            region_held_out_m: None,
            mounting: None,
            terms: Vec::new(),
        }
    }
}

/// Joints of a robot where nothing else is said.
const SIX: usize = 6;

impl Identified {
    /// Whether it is of a robot with six turning joints, as compensation needs.
    #[must_use]
    pub fn is_six_axis(&self) -> bool {
        self.joint_kinds == [JointKind::Revolute; SIX]
    }

    /// The model as far as a program can use it: without the instrument's own errors, steps as having happened.
    ///
    /// The second value names what was left out or taken so, for a warning.
    #[must_use]
    pub fn for_programs(&self) -> (Self, Vec<String>) {
        let mut model = self.clone();
        let mut warnings = Vec::new();
        model.terms.retain(|term| {
            let instrument = term.kind == EffectKind::InstrumentScale;
            if instrument {
                warnings.push(format!(
                    "{} is the instrument's, not the robot's: it is left out",
                    term.kind.name()
                ));
            }
            !instrument
        });
        for term in &mut model.terms {
            if let Growth::Step { t0_min } = term.growth {
                term.growth = Growth::Always;
                warnings.push(format!("{} at minute {t0_min} is taken as having happened", term.kind.name()));
            }
        }
        (model, warnings)
    }

    /// What of the model a program that asks at run time cannot hold, each once: it does not know from which side a joint came,
    /// has no bending of links and no growth beside the table's.
    #[must_use]
    pub fn beyond_run_time(&self) -> Vec<String> {
        let mut names: Vec<String> = Vec::new();
        for term in &self.terms {
            let name = term.kind.name();
            let why = match (term.growth, term.kind) {
                (Growth::Temperature { .. }, _) => format!("{name} by temperature"),
                (Growth::Always, EffectKind::JointCompliance)
                    if term.value(7) != 0.0 || term.value(8) != 0.0 =>
                {
                    format!("{name} that hardens or softens")
                }
                (Growth::Always, kind) if kind.is_known_at_run_time() => continue,
                (Growth::Always, _) => name.to_owned(),
                _ => format!("{name} with a growth of its own"),
            };
            if !names.contains(&why) {
                names.push(why);
            }
        }
        names
    }

    /// Whether any term depends on the time.
    #[must_use]
    pub fn moves_with_time(&self) -> bool {
        self.terms.iter().any(|t| !matches!(t.growth, Growth::Always | Growth::Temperature { .. }))
    }

    /// Whether any term depends on joint temperatures.
    #[must_use]
    pub fn needs_temperature(&self) -> bool {
        self.terms.iter().any(|t| matches!(t.growth, Growth::Temperature { .. }))
    }

    /// Whether any term depends on the load; play does where gravity holds it.
    #[must_use]
    pub fn needs_load(&self) -> bool {
        self.terms.iter().any(|t| t.kind.needs_load() || t.held_above_n_m.is_some())
    }

    /// Whether any term depends on the direction from which a joint came.
    #[must_use]
    pub fn needs_direction(&self) -> bool {
        self.terms.iter().any(|t| t.kind == EffectKind::Backlash)
    }

    /// Minutes at which a term's growth may bend, ascending.
    #[must_use]
    pub fn knots_min(&self) -> Vec<f64> {
        let mut all: Vec<f64> = self
            .terms
            .iter()
            .flat_map(|t| match t.growth {
                Growth::Linear { from_min, to_min } => vec![from_min, to_min],
                Growth::Step { t0_min } => vec![t0_min],
                _ => Vec::new(),
            })
            .filter(|t_min| t_min.is_finite() && *t_min > 0.0)
            .collect();
        sorting::numbers(&mut all);
        all.dedup();
        all
    }
}

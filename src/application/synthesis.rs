//! Measurement sets of a virtual robot, and touches of fixed points, each with its truth.

use exam::effect_spec::{self, EffectSpecError};
use exam::generate::{DataSet, data_set};
use exam::mixture;
use exam::poses::{Recorded, Spread};
use exam::recipe::{Recipe, RequestedEffect};
use exam::rng::Rng;
use exam::touch::{TouchRecipe, touches};
use exam::truth::{QuestionKind, Sealed, seal};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::{Deformation, GrowthLaw};
use robot_model::robot::{Robot, SerialArm};
use robot_model::units::m_from_mm;
use serde::Serialize;

/// A draw that leaves no signal is drawn again, so often.
const TRIES: usize = 50;

/// Measurement sets that wait to be made.
#[derive(Clone, Debug)]
pub struct Synthesis {
    /// The robot that is measured.
    pub robot: SerialArm,
    /// What the sets call it.
    pub robot_name: String,
    /// What the sets are of.
    pub kind: SetKind,
    /// The same seed gives the same bytes.
    pub seed: u64,
    /// How many sets.
    pub sets: u32,
}

/// What measurement sets are of.
#[derive(Clone, Debug, PartialEq)]
pub enum SetKind {
    /// The exam's mixture of questions, of at most so many rows.
    Mixture(usize),
    /// The mixture's questions of one effect, at half the noise in 30 rows.
    Weak,
    /// A joint's zero that jumps, or a fault of rows or of a column, of at most so many rows.
    Accidents(usize),
    /// Effects of one's choice.
    Chosen(ChosenEffects),
}

/// A set with effects of one's choice.
#[derive(Clone, Debug, PartialEq)]
pub struct ChosenEffects {
    /// The effects as [`effect_spec`] has them, separated by commas; `none`.
    pub effects: String,
    /// How many rows are made.
    pub n: usize,
    /// Noise of each coordinate, mm.
    pub sigma_mm: f64,
    /// Each effect's rms over the noise's.
    pub rho: f64,
    /// How the poses are spread.
    pub spread: Spread,
}

impl Synthesis {
    /// Rows of a set of the mixture at most, unless told otherwise.
    pub const MOST_ROWS: usize = 300;
    /// The seed unless another is given.
    pub const SEED: u64 = 1;

    /// One set of the exam's mixture, of at most 300 rows.
    pub fn new(robot: impl Into<SerialArm>, robot_name: impl Into<String>) -> Self {
        let (robot, robot_name) = (robot.into(), robot_name.into());
        Self { robot, robot_name, kind: SetKind::Mixture(Self::MOST_ROWS), seed: Self::SEED, sets: 1 }
    }

    /// The sets, with the truth of all.
    ///
    /// # Errors
    /// [`SynthesisError`]
    pub fn run(&self) -> Result<Synthesized, SynthesisError> {
        let sets = (0..self.sets).map(|number| self.one(number)).collect::<Result<Vec<_>, _>>()?;
        let sealed = Sealed { seed: self.seed, sets: sets.iter().map(|set| set.truth.clone()).collect() };
        Ok(Synthesized { sets, sealed })
    }

    /// One data set. It is drawn again, from the same stream, where what was drawn leaves no signal.
    fn one(&self, number: u32) -> Result<DataSet, SynthesisError> {
        let (mut rng, index) = (Rng::new(self.seed, u64::from(number)), number as usize);
        for _ in 0..TRIES {
            let recipe = match &self.kind {
                SetKind::Mixture(most_rows) => mixture::recipe(index, *most_rows, &mut rng),
                SetKind::Weak => mixture::weak_recipe(index, &mut rng),
                SetKind::Accidents(most_rows) => mixture::accident_recipe(index, *most_rows, &mut rng),
                SetKind::Chosen(chosen) => chosen.recipe(format!("set_{number:04}"), &mut rng)?,
            };
            if let Some(set) = data_set(&self.robot, &self.robot_name, &recipe, &mut rng) {
                return Ok(set);
            }
        }
        Err(SynthesisError::NoSignal { effects: self.kind.name().to_owned() })
    }
}

impl SetKind {
    fn name(&self) -> &str {
        match self {
            Self::Mixture(_) => "mix",
            Self::Weak => "weak",
            Self::Accidents(_) => "accidents",
            Self::Chosen(chosen) => &chosen.effects,
        }
    }
}

impl ChosenEffects {
    /// How many rows are made unless told otherwise.
    pub const N: usize = 100;
    /// Noise of each coordinate unless told otherwise, mm.
    pub const SIGMA_MM: f64 = 0.02;
    /// Each effect's rms over the noise's unless told otherwise.
    pub const RHO: f64 = 3.0;

    /// The recipe of a set called `name`.
    ///
    /// # Errors
    /// [`SynthesisError::Effect`]
    pub fn recipe(&self, name: String, rng: &mut Rng) -> Result<Recipe, SynthesisError> {
        let mut effects = Vec::new();
        for text in self.effects.split(',').filter(|text| *text != "none") {
            let effect = effect_spec::parse(text, rng)
                .map_err(|error| SynthesisError::Effect { text: text.to_owned(), error })?;
            effects.push(RequestedEffect { effect, rho: self.rho });
        }
        let kind = match effects.as_slice() {
            [] => QuestionKind::None,
            [asked] if asked.effect.name().is_none() => QuestionKind::Outside,
            [_] => QuestionKind::One,
            _ => QuestionKind::Two,
        };
        Ok(Recipe {
            repeats: self.n / 6,
            sigma_mm: self.sigma_mm,
            stated_sigma_mm: Some(self.sigma_mm),
            spread: self.spread,
            recorded: Recorded { temperature: true, ..Recorded::NOTED },
            ..Recipe::plain(name, kind, effects, self.n)
        })
    }
}

/// Measurement sets of a virtual robot.
#[derive(Clone, Debug)]
pub struct Synthesized {
    /// The sets, each with what is told of it and its truth.
    pub sets: Vec<DataSet>,
    sealed: Sealed,
}

impl Synthesized {
    /// The truth of all sets as its file holds it, and the seal of that.
    ///
    /// # Errors
    /// A number that JSON cannot hold.
    pub fn sealed_truth(&self) -> serde_json::Result<(Vec<u8>, String)> {
        sealed(&self.sealed)
    }

    /// What was made, as JSON; `folder` is where it goes.
    #[must_use]
    pub fn json(&self, folder: &str) -> serde_json::Value {
        serde_json::json!({ "out_dir": folder, "seed": self.sealed.seed, "sets": self.sets.len() })
    }
}

/// A truth as its file holds it, and the seal of that.
fn sealed(truth: &impl Serialize) -> serde_json::Result<(Vec<u8>, String)> {
    let truth = serde_json::to_vec_pretty(truth)?;
    let seal = seal(&truth);
    Ok((truth, seal))
}

/// Touches of fixed points over a warm-up and one stop, which wait to be made.
#[derive(Clone, Debug)]
pub struct TouchSynthesis {
    /// The robot that is touched.
    pub robot: Robot,
    /// How it deforms.
    pub deformation: Deformation,
    /// How many points.
    pub points: usize,
    /// How often each of them is touched.
    pub times: usize,
    /// Between two touches while the robot runs, minutes.
    pub every_min: f64,
    /// The robot stands from one minute to another.
    pub stop_min: [f64; 2],
    /// Noise of each coordinate, mm.
    pub sigma_mm: f64,
    /// Time constant of cooling, minutes.
    pub tau_cool_min: f64,
    /// The same seed gives the same bytes.
    pub seed: u64,
}

impl TouchSynthesis {
    /// Touches of each point unless told otherwise.
    pub const TIMES: usize = 37;
    /// Between two touches while the robot runs, unless told otherwise, minutes.
    pub const EVERY_MIN: f64 = 5.0;
    /// When the robot stands unless told otherwise, minutes.
    pub const STOP_MIN: [f64; 2] = [120.0, 165.0];
    /// Time constant of cooling unless told otherwise, minutes.
    pub const TAU_COOL_MIN: f64 = 60.0;

    /// Four points touched every five minutes over three hours, with a stop from minute 120 to 165.
    #[must_use]
    pub fn new(robot: Robot, deformation: Deformation) -> Self {
        Self {
            robot,
            deformation,
            points: 4,
            times: Self::TIMES,
            every_min: Self::EVERY_MIN,
            stop_min: Self::STOP_MIN,
            sigma_mm: ChosenEffects::SIGMA_MM,
            tau_cool_min: Self::TAU_COOL_MIN,
            seed: Synthesis::SEED,
        }
    }

    /// The touches, with what they were made by.
    ///
    /// # Errors
    /// [`SynthesisError`]
    pub fn run(&self) -> Result<TouchesSynthesized, SynthesisError> {
        let law = self.deformation.growth();
        let tau_min = law.and_then(GrowthLaw::tau_min).ok_or(SynthesisError::NoTimeConstant)?;
        let recipe = TouchRecipe {
            points: self.points,
            times: self.times,
            every_min: self.every_min,
            stop_min: self.stop_min,
            sigma_mm: self.sigma_mm,
            tau_min: [tau_min, self.tau_cool_min],
            two_stage: matches!(law, Some(GrowthLaw::TwoStage { .. })),
            table: self.deformation.settled().0,
            within_m: [[400.0, -300.0, 250.0], [700.0, 300.0, 550.0]].map(|corner| corner.map(m_from_mm)),
            tool_m: [0.0, 0.0, m_from_mm(100.0)],
        };
        let csv = touches(&self.robot, &recipe, &mut Rng::new(self.seed, 0));
        Ok(TouchesSynthesized { csv: csv.ok_or(SynthesisError::OutOfReach)?, recipe, seed: self.seed })
    }
}

/// Touches of fixed points.
#[derive(Clone, Debug)]
pub struct TouchesSynthesized {
    /// The touches as a file holds them.
    pub csv: String,
    recipe: TouchRecipe,
    seed: u64,
}

impl TouchesSynthesized {
    /// What they were made by as its file holds it, and the seal of that.
    ///
    /// # Errors
    /// A number that JSON cannot hold.
    pub fn sealed_truth(&self) -> serde_json::Result<(Vec<u8>, String)> {
        sealed(&self.recipe)
    }

    /// What was made, as JSON; `folder` is where it goes.
    #[must_use]
    pub fn json(&self, folder: &str) -> serde_json::Value {
        let TouchRecipe { points, times, .. } = &self.recipe;
        serde_json::json!({ "out_dir": folder, "seed": self.seed, "points": points, "times": times })
    }
}

/// Why no measurements are made.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SynthesisError {
    /// An effect is not known, or not written as it must be.
    #[error("{error}")]
    Effect {
        /// The effect as it was given.
        text: String,
        /// What is wrong with it.
        error: EffectSpecError,
    },
    /// The effects lie inside the registration, or are asked for too large.
    #[error("{effects} cannot be made as large as asked over these poses")]
    NoSignal {
        /// The effects as they were given.
        effects: String,
    },
    /// The deformation's growth has no time constant.
    #[error("the growth has no time constant")]
    NoTimeConstant,
    /// The points to be touched are out of the arm's reach.
    #[error("the arm does not reach into the box where the points would be")]
    OutOfReach,
}

impl SynthesisError {
    /// Stable code of the message, listed in `docs/MESSAGES.md`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Effect { .. } => "option::effect",
            Self::NoSignal { .. } | Self::OutOfReach => "synth::no-signal",
            Self::NoTimeConstant => "option::range",
        }
    }
}

impl From<SynthesisError> for Diagnostic {
    fn from(error: SynthesisError) -> Self {
        let message = Self::error(error.code(), error.to_string());
        match error {
            SynthesisError::Effect { .. } => message,
            SynthesisError::NoSignal { .. } => {
                message.help("it lies inside the registration of base and tool, or --rho is too large for it")
            }
            SynthesisError::NoTimeConstant => message.help("write exp:TAU or two-stage:TAU"),
            SynthesisError::OutOfReach => message
                .help("the points are put into the cube of the reference paper: use an arm of its size"),
        }
    }
}

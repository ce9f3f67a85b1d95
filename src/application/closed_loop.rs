//! The whole loop on a virtual robot: an effect is injected, the robot measured, the measurements diagnosed, a program
//! compensated for what was found, and its targets measured again on the same robot.

use super::compensation::Compensation;
use super::diagnosis::Diagnosis;
use super::named::Named;
use super::program_files::ProgramFiles;
use crate::report::notes;
use exam::generate::{DataSet, data_set};
use exam::recipe::{Recipe, RequestedEffect};
use exam::rng::Rng;
use exam::virtual_robot::{Commanded, VirtualRobot, is_lasting, measured_rms_m};
use measurements::Measurements;
use metrology::diagnose::{self, DiagnosisOptions};
use nalgebra::{Isometry3, Vector3};
use rapid_compensation::emit::{Clock, renamed};
use rapid_syntax::diagnostic::{Diagnostic, Severity, counted};
use robot_model::deform::identified::Identified;
use robot_model::robot::Robot;
use robot_model::units::{m_from_mm, mm_from_m};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use virtual_controller::compare::MoveComparator;
use virtual_controller::{Controller, Move};

/// Simulates measuring, diagnosing and compensating with what was found, on a robot whose truth is known.
#[derive(Clone, Debug)]
pub struct ClosedLoop {
    /// The robot as its model says.
    pub robot: Named<Robot>,
    /// How the virtual robot differs from it, and how it is measured.
    pub recipe: Recipe,
    /// The injected effects in words, for messages.
    pub injected: String,
}

impl ClosedLoop {
    /// A virtual robot that differs from `robot` as `recipe` says, which `injected` says in words.
    pub fn new(robot: impl Into<Named<Robot>>, recipe: Recipe, injected: impl Into<String>) -> Self {
        Self { robot: robot.into(), recipe, injected: injected.into() }
    }

    /// Measures the virtual robot, diagnoses it, compensates `program` for what is found, and measures again at its targets.
    ///
    /// # Errors
    /// `rehearse::effect` for an effect that does not last, `synth::no-signal` for one that cannot be made, `model::none` where
    /// nothing is found that a model could hold; a program that cannot be compensated or executed, for its reason, with the model.
    pub fn run(&self, program: &ProgramFiles, rng: &mut Rng) -> Result<LoopClosed, LoopFailure> {
        let Identification { findings, model, set } = self.identify(rng)?;
        match self.measure_again(&model, &set, program, rng) {
            Ok(MeasuredAgain { before, after, kept }) => {
                let (injected, n) = (self.injected.clone(), self.recipe.n);
                let floor_mm = self.recipe.sigma_mm * 3.0_f64.sqrt();
                Ok(LoopClosed { injected, n, floor_mm, findings, model, before, after, kept })
            }
            Err(why) => Err(LoopFailure { why, model: Some(Box::new(model)) }),
        }
    }

    fn identify(&self, rng: &mut Rng) -> Result<Identification, Diagnostic> {
        let robot = &self.robot.model;
        if let Some(RequestedEffect { effect, .. }) =
            self.recipe.effects.iter().find(|asked| !is_lasting(&asked.effect))
        {
            let name = effect.name().unwrap_or("this effect");
            return Err(Diagnostic::error(
                "rehearse::effect",
                format!("{name} changes with time or is the instrument's"),
            )
            .help("inject effects of the arm that stay; drift over a warm-up is `fit`'s"));
        }
        let set = data_set(&robot.into(), &self.robot.source.name, &self.recipe, rng).ok_or_else(|| {
            Diagnostic::error(
                "synth::no-signal",
                format!("{} cannot be made as large as asked", self.injected),
            )
            .help("it lies inside the registration of base and tool, or --rho is too large for it")
        })?;
        let measurements = Measurements::from_csv(set.csv.as_bytes())?;
        let mut diagnosis = Diagnosis::new(robot.clone()).and_identify();
        diagnosis.options = DiagnosisOptions {
            tool_m: set.task.tool_mm.map(|mm| Vector3::from(mm).map(m_from_mm)),
            sigma_m: set.task.sigma_mm.map(m_from_mm),
        };
        let found = diagnosis.run(&measurements)?;
        let Some(model) = found.model else {
            let text = format!("no model can be made of these data: {}", found.findings.reason);
            return Err(Diagnostic::error("model::none", text));
        };
        Ok(Identification { findings: found.findings, model, set })
    }

    /// What is left at a program's targets before it is compensated for what was found, and after.
    fn measure_again(
        &self,
        found: &Identified,
        set: &DataSet,
        program: &ProgramFiles,
        rng: &mut Rng,
    ) -> Result<MeasuredAgain, Diagnostic> {
        let robot = &self.robot.model;
        let model = Named::new(found.clone(), "what was found", &[]);
        let mut compensation = Compensation::with_model(self.robot.clone(), model);
        compensation.emit.clock = Clock::Elapsed;
        let made = compensation.run(program).map_err(|refusal| {
            let error = refusal.messages.iter().find(|m| m.diagnostic.severity == Severity::Error);
            error.map_or_else(
                || Diagnostic::error("compensate::nothing", "the program cannot be compensated"),
                |error| error.diagnostic.clone(),
            )
        })?;
        let plain: Vec<(&str, &[u8])> = program.iter().collect();
        let meant = moves(robot, &plain)?;
        let done = moves(robot, &made.loaded())?;
        MoveComparator::same_moves(&meant, &done)
            .map_err(|mismatch| Diagnostic::error("rehearse::moves", mismatch.to_string()))?;
        let under_test = VirtualRobot::from_truth(&robot.into(), &set.truth);
        let sigma_mm = self.recipe.sigma_mm;
        let [before, after] =
            [&meant, &done].map(|done| left_at_targets(&under_test, &meant, done, sigma_mm, rng));
        let fewest = before.n.min(after.n);
        if fewest < FEWEST_TARGETS {
            let text =
                format!("{} measured again: base and tool alone take 9 numbers", counted(fewest, "target"));
            return Err(Diagnostic::error("rehearse::targets", text)
                .help(format!("a program with {FEWEST_TARGETS} moves or more that are made")));
        }
        Ok(MeasuredAgain { before, after, kept: made.totals.kept })
    }
}

/// Of fewer targets base and tool, 9 numbers that are fitted, leave nothing to be judged.
const FEWEST_TARGETS: usize = 4;

/// What was found in the measurements of a virtual robot.
struct Identification {
    findings: diagnose::Findings,
    model: Identified,
    set: DataSet,
}

/// What is left at a program's targets.
struct MeasuredAgain {
    before: LeftAtTargets,
    after: LeftAtTargets,
    /// Motions that are not corrected.
    kept: usize,
}

/// A loop that was closed.
#[derive(Clone, Debug)]
pub struct LoopClosed {
    /// The injected effects in words.
    pub injected: String,
    /// How many poses were measured.
    pub n: usize,
    /// Root mean square in space of what the instrument's noise alone leaves, mm.
    pub floor_mm: f64,
    /// The diagnosis, which was not told what was injected.
    pub findings: diagnose::Findings,
    /// The model of what it found.
    pub model: Identified,
    /// What is left at the program's targets as it is.
    pub before: LeftAtTargets,
    /// What is left once it is compensated.
    pub after: LeftAtTargets,
    /// How many of the program's motions were kept as they are: what is left at their targets is no fault of the model.
    pub kept: usize,
}

impl LoopClosed {
    /// Whether what is measured again is at most `times` the noise floor.
    #[must_use]
    pub fn is_within(&self, times: f64) -> bool {
        self.after.measured_mm <= times * self.floor_mm
    }

    /// What happened, and whether it ended within `times` the noise floor, for people.
    #[must_use]
    pub fn text(&self, times: f64) -> String {
        let verdict = if self.is_within(times) { "within" } else { "NOT within" };
        self.found_and_left() + &format!("{verdict} {times} times the noise floor\n")
    }

    /// What was found of what was injected, and what is left at the targets.
    fn found_and_left(&self) -> String {
        let Self { injected, n, floor_mm, findings, .. } = self;
        let mut text = format!("injected: {injected}\nfound in {n} poses: {}\n", findings.reason);
        text += &format!("noise floor {floor_mm:.4} mm, rms in space\n");
        for (when, left) in [("before", &self.before), ("after", &self.after)] {
            text += &format!(
                "{when:>6}: {} targets measured, rms {:.4} mm with base and tool fitted; truly {:.4} mm rms, {:.4} mm at worst\n",
                left.n, left.measured_mm, left.true_mm, left.max_mm
            );
        }
        if self.kept > 0 {
            let kept = counted(self.kept, "motion");
            text += &format!(
                "{kept} kept uncorrected: `driftpost compensate --model` with --model-out's file says why\n"
            );
        }
        text
    }

    /// The JSON of the contract.
    #[must_use]
    pub fn json(&self) -> Value {
        json!({
            "notes": notes(&self.found_and_left()), "withheld": self.injected, "verdict": self.findings.verdict,
            "causes": self.findings.causes.iter().map(diagnose::describe).collect::<Vec<_>>(),
            "targets": self.before.n, "kept": self.kept, "floor_rms_mm": self.floor_mm,
            "before": self.before.json(), "after": self.after.json(),
        })
    }
}

/// Why a loop was not closed.
#[derive(Clone, Debug, thiserror::Error)]
#[error("{why}")]
pub struct LoopFailure {
    /// The reason.
    pub why: Diagnostic,
    /// The model of what was found, where it came so far.
    pub model: Option<Box<Identified>>,
}

impl LoopFailure {
    /// Stable code of the message, listed in `docs/MESSAGES.md`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        self.why.code
    }
}

impl From<LoopFailure> for Diagnostic {
    fn from(failure: LoopFailure) -> Self {
        failure.why
    }
}

impl From<Diagnostic> for LoopFailure {
    fn from(why: Diagnostic) -> Self {
        Self { why, model: None }
    }
}

/// The moves that a controller makes of a program: called cold first, where it has a clock.
fn moves(robot: &Robot, program: &[(&str, &[u8])]) -> Result<Vec<Move>, Diagnostic> {
    let refused =
        |error: virtual_controller::SimulateError| Diagnostic::error(error.code(), error.to_string());
    let mut controller = Controller::with_robot(robot).map_err(refused)?;
    for (path, bytes) in program {
        controller.load(path, bytes).map_err(refused)?;
        controller.put_file(path, bytes);
    }
    let renamed: BTreeMap<String, String> = program.iter().flat_map(|(_, bytes)| renamed(bytes)).collect();
    for name in ["tcColdStart", "tcUpdate"] {
        let name = renamed.get(name).map_or(name, String::as_str);
        if controller.has_routine(name) {
            controller.call(name, 1).map_err(refused)?;
        }
    }
    let entry = controller.entry().map_err(refused)?;
    controller.call(&entry, 1).map_err(refused)?;
    Ok(controller.arm_mut().map(virtual_controller::ControllerArm::take_moves).unwrap_or_default())
}

/// What is left at a program's targets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeftAtTargets {
    /// How many targets were judged.
    pub n: usize,
    /// Root mean square of the measured errors, base and tool fitted, mm.
    pub measured_mm: f64,
    /// Root mean square of the true errors, mm.
    pub true_mm: f64,
    /// Largest true error, mm.
    pub max_mm: f64,
}

impl LeftAtTargets {
    fn json(&self) -> Value {
        json!({ "measured_rms_mm": self.measured_mm, "true_rms_mm": self.true_mm, "true_max_mm": self.max_mm })
    }
}

/// The moves of `done` on the true robot, against where `meant` goes on a perfect one.
fn left_at_targets(
    robot_under_test: &VirtualRobot,
    meant: &[Move],
    done: &[Move],
    sigma_mm: f64,
    rng: &mut Rng,
) -> LeftAtTargets {
    let mut flanges: Vec<Isometry3<f64>> = Vec::new();
    let mut off_m: Vec<Vector3<f64>> = Vec::new();
    for (a, b) in meant.iter().zip(done) {
        let (Some(meant_rad), Some(q_rad)) = (a.q_rad, b.q_rad) else { continue };
        let payload = b.setup.payload;
        let at = Commanded {
            q_rad: q_rad.into(),
            direction: b.direction.into(),
            payload_kg: payload.mass_kg,
            payload_at_m: payload.cog_m,
        };
        let perfect = robot_under_test.nominal(&meant_rad);
        let tip = |flange: &Isometry3<f64>| {
            let on_flange =
                if b.setup.tool_held { b.setup.frame_from_tcp } else { b.setup.frame_from_object };
            (flange * on_flange).translation.vector
        };
        off_m.push(tip(&robot_under_test.flange(&at)) - tip(&perfect));
        flanges.push(perfect);
    }
    let n = off_m.len();
    let true_m = (off_m.iter().map(Vector3::norm_squared).sum::<f64>() / n.max(1) as f64).sqrt();
    LeftAtTargets {
        n,
        measured_mm: mm_from_m(measured_rms_m(&flanges, &off_m, sigma_mm, rng)),
        true_mm: mm_from_m(true_m),
        max_mm: mm_from_m(off_m.iter().map(Vector3::norm).fold(0.0, f64::max)),
    }
}

//! What all motions and buckets of a comparison come to.

use super::rounded;
use rapid_compensation::compensate::compare::{ComparedMotion, Comparison};
use rapid_compensation::emit::{Difference, HeldMode, Undeclared};
use robot_model::units::{deg_from_rad, mm_from_m};
use serde_json::{Value, json};

/// The worst of something over all motions and buckets.
pub(super) struct Worst<'c> {
    pub value: f64,
    pub motion: &'c ComparedMotion,
    pub bucket: Option<usize>,
}

/// What all motions and buckets come to, metres and radians.
#[derive(Default)]
pub(super) struct Figures<'c> {
    pub distance: Option<Worst<'c>>,
    pub angle: Option<Worst<'c>>,
    pub joint: Option<Worst<'c>>,
    pub jump: Option<Worst<'c>>,
    pub limit: Option<Worst<'c>>,
    pub singular: Option<Worst<'c>>,
    pub same_configuration: bool,
}

impl<'c> Figures<'c> {
    pub fn of(comparison: &'c Comparison) -> Self {
        let mut figures = Self { same_configuration: true, ..Self::default() };
        for motion in &comparison.motions {
            for (k, step) in motion.steps.iter().chain(&motion.asked).enumerate() {
                let bucket = bucket(motion, k);
                let update = |worst: &mut Option<Worst<'c>>, value: Option<f64>, sign: f64| {
                    let Some(value) = value else { return };
                    if worst.as_ref().is_none_or(|worst| sign * value > sign * worst.value) {
                        *worst = Some(Worst { value, motion, bucket });
                    }
                };
                update(&mut figures.distance, Some(step.distance_m), 1.0);
                update(&mut figures.angle, Some(step.angle_rad), 1.0);
                update(&mut figures.joint, step.arm.map(|a| a.joint_rad), 1.0);
                update(&mut figures.limit, step.arm.and_then(|a| a.limit_rad), -1.0);
                update(&mut figures.singular, step.arm.map(|a| a.wrist_rad.min(a.elbow_rad)), -1.0);
                // From bucket to bucket; element 1 is the original, which follows none.
                let before = k.checked_sub(1).filter(|k| *k > 0).and_then(|k| motion.steps.get(k));
                let jump = before.map(|before| {
                    let apart = before.position_m.iter().zip(step.position_m).map(|(a, b)| (a - b).powi(2));
                    apart.sum::<f64>().sqrt()
                });
                update(&mut figures.jump, jump, 1.0);
                figures.same_configuration &=
                    step.same_configuration && step.arm.is_none_or(|arm| arm.same_branch);
            }
        }
        figures
    }

    pub fn json(&self) -> Value {
        let of = |worst: &Option<Worst>, unit: fn(f64) -> f64| worst.as_ref().map(|w| rounded(unit(w.value)));
        json!({
            "dp_mm": of(&self.distance, mm_from_m),
            "angle_deg": of(&self.angle, deg_from_rad),
            "joint_deg": of(&self.joint, deg_from_rad),
            "bucket_step_mm": of(&self.jump, mm_from_m),
            "limit_margin_deg": of(&self.limit, deg_from_rad),
            "singular_margin_deg": of(&self.singular, deg_from_rad),
            "same_configuration": self.same_configuration,
        })
    }
}

/// The bucket of the k-th step; `None` for the original of a scheduled target, and where it is not scheduled.
pub(super) fn bucket(compared: &ComparedMotion, k: usize) -> Option<usize> {
    if compared.steps.len() > 1 { k.checked_sub(1) } else { None }
}

/// A difference beside the targets, for people.
pub(super) fn sentence(difference: &Difference) -> String {
    match difference {
        Difference::Text { before: (a, line_a), after: (b, line_b) } => format!(
            "Beside the targets the text differs, first at {a}:{line_a} and line {line_b} of {b} without what \
             compensation added."
        ),
        Difference::Missing(module) => format!("Module {module} is only in the first program."),
        Difference::Added(module) => format!("Module {module} is only in the second program."),
        Difference::MadeOtherwise { before, after, what } => {
            let shown = |(name, [a, b]): &(String, [String; 2])| format!(", {name} {a} and {b}");
            let what: String = what.iter().map(shown).collect();
            format!("{before} and {after} were not made alike: their clocks or corrections differ{what}.")
        }
        Difference::Altered { file, what } => format!("{file}:{}: {what}", what.line()),
        Difference::Damaged { file, error } => format!("{file} was edited where it must not be: {error}"),
    }
}

/// Why targets that differ are a change that nobody declares, for people.
pub(super) fn not_declared(why: &Undeclared) -> String {
    match why {
        Undeclared::NoneCompensated => {
            "NOT declared: neither program holds a compensated module, and no target of theirs may differ."
                .to_owned()
        }
        Undeclared::BothCompensated => {
            "NOT declared: both programs hold compensated modules, and neither is the other's original."
                .to_owned()
        }
        Undeclared::Elsewhere => "NOT declared: more than targets differs.".to_owned(),
        Undeclared::Touched { file, line, target, more } => {
            let others = if *more == 0 { String::new() } else { format!(", and {more} more") };
            format!(
                "NOT declared: {file}:{line}: {target}{others}: the original, or the correction that its motion asks with, is not the one that the \
                 module was made with."
            )
        }
        Undeclared::OtherOriginal { file, line } => format!(
            "NOT declared: the compensated module was made of another original: its text is another one from {file}:{line} on."
        ),
    }
}

/// What a program does whose clock does not follow the warm-up, for people.
pub(super) fn held(mode: &HeldMode) -> String {
    let HeldMode { file, line, name, value } = mode;
    let motions = if value == "-2" { "go to the original targets" } else { "do not follow the warm-up" };
    format!("{file}:{line}: {name} is {value}: its motions {motions} until it is set to -1.")
}

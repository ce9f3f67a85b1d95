//! The blind exam: sets of measurements whose truth is sealed, put to the diagnosis and scored.

use super::diagnosis::{Diagnosis, DiagnosisError};
use crate::report::value;
use exam::answer::Answer;
use exam::generate::Task;
use exam::measure::Measure;
use exam::score::{AnsweredSet, score};
use exam::truth::{Sealed, Truth, seal};
use measurements::Measurements;
use metrology::diagnose::DiagnosisOptions;
use nalgebra::Vector3;
use rapid_syntax::diagnostic::{Diagnostic, counted};
use robot_model::robot::SerialArm;
use robot_model::units::m_from_mm;
use std::fmt::Write as _;

/// One set of measurements, and what is told of it.
#[derive(Clone, Debug)]
pub struct Question {
    /// What the one who measures knows: the target's place, the noise.
    pub task: Task,
    /// The robot as its model says.
    pub robot: SerialArm,
    /// The rows of the set, as its file holds them.
    pub measurements: Measurements,
}

impl Question {
    /// What the diagnosis says, by way of the JSON that any script reads.
    ///
    /// # Errors
    /// Another robot than the one of its rows, or an answer that is not that of the contract.
    pub fn answer(&self) -> Result<Answer, QuestionError> {
        let mut diagnosis = Diagnosis::new(self.robot.clone());
        diagnosis.options = DiagnosisOptions {
            tool_m: self.task.tool_mm.map(|mm| Vector3::from(mm).map(m_from_mm)),
            sigma_m: self.task.sigma_mm.map(m_from_mm),
        };
        Ok(serde_json::from_value(diagnosis.run(&self.measurements)?.json())?)
    }
}

/// Questions with their truth, which is not looked at before all are answered.
#[derive(Clone, Debug)]
pub struct Exam {
    sets: Vec<(Truth, Question)>,
}

impl Exam {
    /// An exam of questions with their truth, which is not looked at before all are answered.
    #[must_use]
    pub fn new(sets: Vec<(Truth, Question)>) -> Self {
        Self { sets }
    }

    /// The exam of a sealed truth (bytes of its file), with the question of each set as `read` finds it by the set's name.
    ///
    /// # Errors
    /// `exam::seal` where the truth is not the one that `stated` seals, `exam::truth` where it cannot be read, and what
    /// `read` says.
    pub fn open<E: From<Diagnostic>>(
        truth: &[u8],
        stated: &str,
        mut read: impl FnMut(&str) -> Result<Question, E>,
    ) -> Result<Self, E> {
        const AGAIN: &str = "make the sets again with `driftpost synth`";
        if stated.trim() != seal(truth) {
            let text = "the sealed truth is not the one that was sealed";
            return Err(Diagnostic::error("exam::seal", text).help(AGAIN).into());
        }
        let sealed: Sealed = serde_json::from_slice(truth).map_err(|cause| {
            let text = format!("the sealed truth cannot be read: {cause}");
            Diagnostic::error("exam::truth", text).help(AGAIN)
        })?;
        let with_question = |truth: Truth| read(&truth.name).map(|question| (truth, question));
        Ok(Self::new(sealed.sets.into_iter().map(with_question).collect::<Result<_, E>>()?))
    }

    /// Diagnoses every set, then scores the answers.
    ///
    /// # Errors
    /// A set that is not answered, by its name.
    pub fn run(&self) -> Result<Scored, ExamError> {
        let answer = |(truth, question): &(Truth, Question)| {
            let unanswered = |cause| ExamError { set: truth.name.clone(), cause };
            Ok(AnsweredSet { truth: truth.clone(), answer: question.answer().map_err(unanswered)? })
        };
        let answered: Vec<AnsweredSet> = parallel::map(self.sets.len(), &|at| answer(&self.sets[at]))
            .into_iter()
            .collect::<Result<_, _>>()?;
        Ok(Scored { measures: score(&answered), answered })
    }
}

/// Why a question is not answered.
#[derive(Debug, thiserror::Error)]
pub enum QuestionError {
    /// The set is of another robot.
    #[error(transparent)]
    Diagnosis(#[from] DiagnosisError),
    /// The answer is not that of the contract.
    #[error(transparent)]
    Answer(#[from] serde_json::Error),
}

/// Why an exam is not scored: one of its sets is not answered.
#[derive(Debug, thiserror::Error)]
#[error("{set}: {cause}")]
pub struct ExamError {
    /// Name of the set, that of its folder.
    pub set: String,
    /// Why it is not answered.
    #[source]
    pub cause: QuestionError,
}

impl ExamError {
    /// Stable code of the message, listed in `docs/MESSAGES.md`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match &self.cause {
            QuestionError::Diagnosis(error) => error.code(),
            QuestionError::Answer(_) => "exam::answer",
        }
    }
}

impl From<ExamError> for Diagnostic {
    fn from(error: ExamError) -> Self {
        Self::error(error.code(), error.to_string())
    }
}

/// What an exam came to.
#[derive(Clone, Debug)]
pub struct Scored {
    /// Every measure with its value, and what passes.
    pub measures: Vec<Measure>,
    /// Each set's truth and answer.
    pub answered: Vec<AnsweredSet>,
}

impl Scored {
    /// The table that `driftpost exam` prints.
    #[must_use]
    pub fn text(&self) -> String {
        let mut out = format!("{}\n\n", counted(self.answered.len(), "set"));
        for measure in &self.measures {
            let _ = writeln!(out, "{}", row(measure));
        }
        out
    }

    /// Table, truths and answers as `driftpost exam --json` writes them.
    #[must_use]
    pub fn json(&self) -> serde_json::Value {
        let set = |set: &AnsweredSet| serde_json::json!({ "truth": set.truth, "answer": set.answer });
        let sets: Vec<_> = self.answered.iter().map(set).collect();
        let measure = |measure: &Measure| {
            let mut row = value(measure);
            row["judgement"] = judgement(measure).into();
            row
        };
        let measures: Vec<_> = self.measures.iter().map(measure).collect();
        serde_json::json!({ "measures": measures, "sets": sets })
    }
}

/// How good a value is, in a word.
fn judgement(measure: &Measure) -> &'static str {
    match measure.value {
        None => "not asked",
        Some(_) if measure.reaches(measure.world_class) => "world-class",
        Some(_) if measure.reaches(measure.pass) => "passes",
        Some(_) => "falls short",
    }
}

/// A row of the table: measure, value with interval, number of sets, what passes, what is world-class.
fn row(measure: &Measure) -> String {
    let value = measure.value.map_or_else(|| "-".to_owned(), |v| format!("{v:.3}"));
    let interval = measure.ci90.map_or_else(String::new, |[low, high]| format!("[{low:.2}, {high:.2}]"));
    let mark = judgement(measure);
    format!(
        "{:<48} {value:>6} {interval:<13} {:>4} sets   pass {:<4} world-class {:<4}  {mark}",
        measure.name, measure.sets, measure.pass, measure.world_class
    )
}

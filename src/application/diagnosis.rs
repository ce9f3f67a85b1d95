//! Diagnosis of a robot from measured poses.

use crate::report::{ControllerData, DiagnosisPage, diagnosis, plots, rapid_data, value, write_pretty};
use measurements::{FaultKind, Measurements, OwnNames, check_rows};
use metrology::diagnose::{self, DiagnosisOptions, diagnose, diagnose_and_identify, gear_spectra};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::identified::Identified;
use robot_model::robot::SerialArm;
use std::io::{self, Write};

/// Robot and options with which measurements are diagnosed: what explains the residuals, and how surely.
///
/// ```
/// use driftpost::{Diagnosis, Measurements, Robot};
///
/// let robot = Robot::built_in("irb140").expect("it is one of the library's");
/// let one_row = b"q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n0,0,0,0,30,0,515,0,712\n";
/// let found = Diagnosis::new(robot).run(&Measurements::from_csv(one_row)?)?;
/// assert_eq!(found.json()["verdict"], "insufficient_data", "one row says nothing");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Diagnosis {
    /// The robot as its model says, of four to seven joints.
    pub robot: SerialArm,
    /// What is known of the measurement: the target's place on the flange, the noise.
    pub options: DiagnosisOptions,
    /// What is found is made into a model as well, for [`Compensation::with_model`](super::Compensation::with_model).
    pub identify: bool,
}

/// What a diagnosis found.
#[derive(Clone, Debug)]
pub struct Diagnosed {
    /// Verdict, causes, shrink and what to measure next.
    pub findings: diagnose::Findings,
    /// The model, where one was asked for and can be made.
    pub model: Option<Identified>,
    robot: SerialArm,
    /// What the file calls its columns.
    names: OwnNames,
}

impl Diagnosis {
    /// A diagnosis with nothing known of the measurement.
    #[must_use]
    pub fn new(robot: impl Into<SerialArm>) -> Self {
        Self { robot: robot.into(), options: DiagnosisOptions::default(), identify: false }
    }

    /// The same, and a model of what is found.
    #[must_use]
    pub fn and_identify(self) -> Self {
        Self { identify: true, ..self }
    }

    /// Finds which unmodelled effects explain the measurements, and when that cannot be said.
    ///
    /// # Errors
    /// Measurements of another arm. Others that contradict themselves are a finding.
    pub fn run(&self, measurements: &Measurements) -> Result<Diagnosed, DiagnosisError> {
        let fault = check_rows(measurements, &self.robot).fault;
        if let Some(fault) = fault.filter(|fault| fault.kind == FaultKind::JointColumns) {
            return Err(DiagnosisError::Joints { reason: fault.reason });
        }
        let (findings, model) = if self.identify {
            diagnose_and_identify(measurements, &self.robot, &self.options)
        } else {
            (diagnose(measurements, &self.robot, &self.options), None)
        };
        Ok(Diagnosed { findings, model, robot: self.robot.clone(), names: OwnNames::default() })
    }
}

/// What was found, and what the report says of it beside its lists.
#[derive(serde::Serialize)]
struct DiagnosisJson<'d> {
    #[serde(flatten)]
    findings: &'d diagnose::Findings,
    notes: Vec<String>,
}

impl Diagnosed {
    /// The same with the file's own names of its columns, where a column map has given it ours.
    #[must_use]
    pub fn in_columns(mut self, names: &OwnNames) -> Self {
        self.findings.visit_texts(|text| *text = names.rename(text));
        self.names.clone_from(names);
        self
    }

    /// The report as people read it.
    #[must_use]
    pub fn text(&self) -> String {
        diagnosis::text(&self.findings, &self.robot, &self.names)
    }

    /// The JSON of the contract.
    #[must_use]
    pub fn json(&self) -> serde_json::Value {
        value(&self.with_notes())
    }

    /// The same as its file holds it, verdict first.
    ///
    /// # Errors
    /// Those of writing to `out`.
    pub fn write_json(&self, out: &mut dyn Write) -> io::Result<()> {
        write_pretty(out, &self.with_notes())
    }

    fn with_notes(&self) -> DiagnosisJson<'_> {
        DiagnosisJson {
            findings: &self.findings,
            notes: diagnosis::in_sentences(&self.findings, &self.robot, &self.names),
        }
    }

    /// The model of what was found; `name` and `sha256` are those of the measurements. `None` where none was asked for, or none can
    /// be made: then [`no_model`](Self::no_model) says why.
    #[must_use]
    pub fn model_of(&self, name: &str, sha256: &str) -> Option<Identified> {
        let (data, data_sha256) = (name.to_owned(), sha256.to_owned());
        self.model.clone().map(|model| Identified { data, data_sha256, ..model })
    }

    /// What was found as RAPID to paste, put into copies of what stands `on_controller`; `name` and `sha256` are those of the
    /// measurements. `None` as of [`model_of`](Self::model_of), or where the model does not say how it was measured.
    #[must_use]
    pub fn rapid_of(&self, name: &str, sha256: &str, on_controller: &ControllerData) -> Option<String> {
        rapid_data::rapid(&self.model_of(name, sha256)?, on_controller)
    }

    /// By how much each axis stands further than the controller shows, with what to know before anybody types that into it; empty
    /// where no offset was found. `None` where there is no model.
    #[must_use]
    pub fn axis_table(&self) -> Option<String> {
        self.model.as_ref().map(rapid_data::axis_table)
    }

    /// Why there is no model.
    #[must_use]
    pub fn no_model(&self) -> Diagnostic {
        let why = self.findings.no_model.as_ref().unwrap_or(&self.findings.reason);
        Diagnostic::error("model::none", format!("no model can be made of these data: {why}"))
    }

    /// The measurement file without its false lines, byte for byte.
    #[must_use]
    pub fn cleaned(&self, measurements: &[u8]) -> Vec<u8> {
        let lines = measurements.split_inclusive(|byte| *byte == b'\n').zip(1_u64..);
        let kept = lines.filter(|(_, number)| self.findings.false_lines.binary_search(number).is_err());
        kept.flat_map(|(line, _)| line.iter().copied()).collect()
    }

    /// Pictures (SVG) of the residuals by joint angle, over time and in the workspace, each with a name for its file.
    #[must_use]
    pub fn pictures(&self) -> Vec<(&'static str, String)> {
        plots::pictures(&self.findings, &self.robot)
    }

    /// Writes the page; `name` and `sha256` are those of the measurements. Gears have their whole spectra on it where a model was
    /// asked for ([`Diagnosis::and_identify`]).
    ///
    /// # Errors
    /// What writing to `out` fails with.
    pub fn write_page(&self, name: &str, sha256: &str, out: &mut dyn Write) -> io::Result<()> {
        let provenance = [("measurements", format!("{name}, SHA-256 {sha256}"))];
        let Self { findings, robot, model, names } = self;
        let spectra =
            model.as_ref().map(|model| gear_spectra(model, &findings.causes, robot, &findings.residuals));
        DiagnosisPage {
            title: name,
            findings,
            robot,
            names,
            spectra: &spectra.unwrap_or_default(),
            text: &self.text(),
            provenance: &provenance,
        }
        .write(out)
    }

    /// Residuals of every row before and after, as CSV.
    #[must_use]
    pub fn residuals_csv(&self) -> String {
        diagnosis::residuals_csv(&self.findings)
    }
}

/// Why measurements are not diagnosed.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum DiagnosisError {
    /// The file's joints are not the arm's.
    #[error("{reason}")]
    Joints {
        /// Which the file has and which the arm.
        reason: String,
    },
}

impl DiagnosisError {
    /// Stable code of the message, listed in `docs/MESSAGES.md`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Joints { .. } => "measure::fault",
        }
    }
}

impl From<DiagnosisError> for Diagnostic {
    fn from(error: DiagnosisError) -> Self {
        Self::error(error.code(), error.to_string())
    }
}

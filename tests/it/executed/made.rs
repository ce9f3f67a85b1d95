//! Emitted programs for the tests: read, planned and emitted as the command line does.

use rapid_compensation::compensate::plan::Status;
use rapid_compensation::compensate::{self, FormChoice, Options};
use rapid_compensation::emit::{Clock, DriftGrowth, EmitOptions, Provenance, emit};
use rapid_program::{Overrides, Program};
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::FileId;
use robot_model::deform::{Deformation, GrowthLaw};
use robot_model::robot::Robot;
use std::path::{Path, PathBuf};
use virtual_controller::session::{self, ProgramFile};
use virtual_controller::{Session, TrueRobot};

/// A program as files.
pub type Files = Vec<(String, Vec<u8>)>;

pub fn warmth() -> Clock {
    Clock::Warmth {
        growth: DriftGrowth::Law(GrowthLaw::TwoStage { tau_min: 46.0 }),
        tau_cool_min: None,
        gap_min: 5.0,
    }
}

pub fn fixtures() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures")
}

pub fn read(paths: &[PathBuf]) -> Files {
    paths
        .iter()
        .map(|p| (p.file_name().unwrap().to_string_lossy().into_owned(), std::fs::read(p).unwrap()))
        .collect()
}

pub fn fixture(name: &str) -> Files {
    read(&[fixtures().join(name)])
}

/// The program compensated.
pub fn compensated(source: &Files, deformation: &Deformation, clock: &Clock) -> Option<Files> {
    made(source, deformation, clock).map(|(files, _)| files)
}

/// The program compensated, and how many of its motions are kept; `None` where all are.
pub fn made(source: &Files, deformation: &Deformation, clock: &Clock) -> Option<(Files, usize)> {
    made_as(FormChoice::Schedule, source, deformation, clock)
}

/// The same in a form.
pub fn made_as(
    form: FormChoice,
    source: &Files,
    deformation: &Deformation,
    clock: &Clock,
) -> Option<(Files, usize)> {
    made_within(form, source, deformation, clock, Options::default().max_correction_m)
}

/// The same with another limit of a correction, metres.
pub fn made_within(
    form: FormChoice,
    source: &Files,
    deformation: &Deformation,
    clock: &Clock,
    max_correction_m: f64,
) -> Option<(Files, usize)> {
    let files = source
        .iter()
        .enumerate()
        .map(|(i, (path, bytes))| SourceFile::read(FileId(i as u32), path.clone(), bytes.clone()));
    let program = Program::read(files.collect(), &Overrides::default());
    let robot = Robot::built_in("irb140").unwrap();
    let plan = compensate::plan(
        &program,
        &robot,
        deformation,
        &Options { form, max_correction_m, ..Options::default() },
    )
    .ok()?;
    let options = EmitOptions {
        form,
        clock: clock.clone(),
        growth: deformation.growth().copied(),
        core: None,
        robot: Provenance { name: "irb140".into(), sha256: "11".repeat(32) },
        deformation: Some(Provenance { name: "Table 2".into(), sha256: "22".repeat(32) }),
        model: None,
        settings: Vec::new(),
        absolute_accuracy: false,
        self_test: false,
        touch: None,
    };
    let mut out = source.clone();
    for emitted in emit(&program, &plan, &options).unwrap() {
        match emitted.source {
            Some(id) => out[id.0 as usize].1 = emitted.bytes,
            None => out.push((emitted.path, emitted.bytes)),
        }
    }
    let kept = plan.motions.iter().filter(|m| m.status != Status::Compensated).count();
    Some((out, kept))
}

pub fn borrowed(files: &Files) -> Vec<ProgramFile<'_>> {
    files.iter().map(|(path, bytes)| (path.as_str(), bytes.as_slice())).collect()
}

/// Program and original on the robot that deforms as `deformation` says.
pub fn session(program: &Files, original: &Files, deformation: &Deformation, paths: bool) -> Session {
    let options = session::SessionOptions { paths, ..session::SessionOptions::default() };
    session_with(program, original, deformation, options)
}

/// The same from another routine than main.
pub fn session_at(program: &Files, original: &Files, deformation: &Deformation, entry: &str) -> Session {
    let options =
        session::SessionOptions { entry: Some(entry.to_owned()), ..session::SessionOptions::default() };
    session_with(program, original, deformation, options)
}

fn session_with(
    program: &Files,
    original: &Files,
    deformation: &Deformation,
    options: session::SessionOptions,
) -> Session {
    let truth = TrueRobot::new(Robot::built_in("irb140").unwrap(), deformation.clone());
    Session::new(&borrowed(program), Some(&borrowed(original)), truth, options).unwrap()
}

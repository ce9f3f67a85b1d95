//! `driftpost closed-loop`: the whole loop on a virtual robot. An effect is injected, the robot measured, the measurements
//! diagnosed, a program compensated for what was found, and its targets measured again on the same robot.

use super::number::positive;
use super::page::{ReportArgs, hashes};
use super::program_input::ProgramInput;
use super::results::Results;
use super::sealed::{Language, Sealed, TomlKind};
use super::shared::RobotName;
use super::{Console, Outcome, files, synth};
use driftpost::application::{ChosenEffects, ClosedLoop, Synthesis};
use exam::rng::Rng;
use rapid_syntax::diagnostic::Diagnostic;
use std::path::PathBuf;

/// Command line of `driftpost closed-loop`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// The program: a module, several, a folder, or a .pgf.
    #[arg(value_name = "PROGRAM", required = true)]
    pub program: Vec<PathBuf>,

    /// Effects of the virtual robot, which the diagnosis is not told, e.g. joint_compliance:2,gear_mesh:3:20.
    #[arg(long, value_name = "LIST", alias = "withhold")]
    pub inject: String,

    /// The robot that the program is for.
    #[command(flatten)]
    pub robot: RobotName,

    /// How many poses are measured.
    #[arg(long, default_value_t = 150, value_parser = clap::value_parser!(u32).range(12..=100_000))]
    pub n: u32,

    /// Noise of each coordinate.
    #[arg(long, value_name = "MM", default_value_t = ChosenEffects::SIGMA_MM)]
    pub sigma_mm: f64,

    /// Each effect's rms over the noise's rms, where it is measured.
    #[arg(long, default_value_t = 5.0)]
    pub rho: f64,

    /// Seed: the same seed gives the same bytes.
    #[arg(long, default_value_t = Synthesis::SEED)]
    pub seed: u64,

    /// What was found, as a model (TOML).
    #[arg(long, value_name = "FILE")]
    pub model_out: Option<PathBuf>,

    /// Overwrite a model that was changed by hand since it was written.
    #[arg(long, requires = "model_out")]
    pub force: bool,

    /// Exit 1 where what is measured again is more than this times the noise floor.
    #[arg(long, value_name = "TIMES", default_value_t = 1.5)]
    pub limit: f64,

    /// Everything a script needs, as JSON; - is standard output.
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<PathBuf>,

    /// Where the page for the browser goes, if one is asked for.
    #[command(flatten)]
    pub page: ReportArgs,
}

/// Runs `closed-loop`.
///
/// # Errors
/// A file that cannot be read, an effect that a program cannot meet, a program that cannot be compensated.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    positive(&[
        ("--sigma-mm", Some(args.sigma_mm)),
        ("--rho", Some(args.rho)),
        ("--limit", Some(args.limit)),
    ])?;
    let robot = args.robot.load()?;
    let given = ProgramInput::read(&args.program)?;
    let json = files::Output::new(args.json.as_deref())?;
    let page = args.page.open()?;
    let sealed = |path| Sealed::new(path, Language::Toml(TomlKind::Model), args.force);
    let model_out = args.model_out.as_deref().map(sealed).transpose()?;
    let mut rng = Rng::new(args.seed, 0);
    let chosen = ChosenEffects {
        effects: args.inject.clone(),
        n: args.n as usize,
        sigma_mm: args.sigma_mm,
        rho: args.rho,
        spread: exam::poses::Spread::Wide,
    };
    let recipe = chosen.recipe("rehearsal".to_owned(), &mut rng).map_err(synth::diagnostic_of)?;
    let job = ClosedLoop::new(robot, recipe, args.inject.as_str());
    let closed = job.run(&given.program(), &mut rng);
    let model = match &closed {
        Ok(closed) => Some(&closed.model),
        Err(failure) => failure.model.as_deref(),
    };
    if let (Some(file), Some(model)) = (model_out, model) {
        file.write(&model.to_toml())?;
    }
    let closed = closed.map_err(Diagnostic::from)?;
    let (mut answer, text) = (closed.json(), closed.text(args.limit));
    answer["within"] = closed.is_within(args.limit).into();
    answer["limit_of_floor"] = args.limit.into();
    let results = Results::new(answer, text);
    page.write("closed-loop", &hashes(&given.program()), &results)?;
    results.write(json, console)?;
    Ok(if closed.is_within(args.limit) { Outcome::Done } else { Outcome::Difference })
}

//! `driftpost rehearse`: the whole loop on a virtual robot. An effect is withheld, the robot measured, the measurements
//! diagnosed, a program compensated for what was found, and its targets measured again on the same robot.

use super::given::Given;
use super::shared::RobotName;
use super::{Console, Outcome, files, synth};
use exam::generate::{DataSet, data_set};
use exam::rng::Rng;
use exam::virtual_robot::{Commanded, VirtualRobot, is_lasting, measured_rms_m};
use metrology::diagnose::{Diagnosis, Options, describe, diagnose_and_identify};
use metrology::measure::Measurements;
use nalgebra::{Isometry3, Vector3};
use rapid_program::compensate::{self, FormChoice, plan};
use rapid_program::emit::{Clock, EmitOptions, Provenance, emit};
use rapid_program::program::{Overrides, Program};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::{Deformation, GrowthLaw};
use robot_model::kinematics::FrameOffsets;
use robot_model::robot::Robot;
use robot_model::units::{m_from_mm, mm_from_m, rad_from_deg};
use serde_json::json;
use std::io::Write;
use std::path::PathBuf;
use std::sync::Arc;
use virtual_controller::{Controller, Move};

/// Options of `rehearse`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// The program: a module, several, a folder, or a .pgf.
    #[arg(value_name = "PROGRAM", required = true)]
    pub program: Vec<PathBuf>,

    /// Effects of the virtual robot, which the diagnosis is not told, e.g. joint_compliance:2,gear_mesh:3:20.
    #[arg(long, value_name = "LIST")]
    pub withhold: String,

    /// The robot.
    #[command(flatten)]
    pub robot: RobotName,

    /// Poses measured.
    #[arg(long, default_value_t = 150, value_parser = clap::value_parser!(u32).range(12..=100_000))]
    pub n: u32,

    /// Noise of each coordinate.
    #[arg(long, value_name = "MM", default_value_t = 0.02)]
    pub sigma_mm: f64,

    /// Each effect's rms over the noise's rms, where it is measured.
    #[arg(long, default_value_t = 5.0)]
    pub rho: f64,

    /// Seed: the same seed gives the same bytes.
    #[arg(long, default_value_t = 1)]
    pub seed: u64,

    /// What was found, as a model (TOML).
    #[arg(long, value_name = "FILE")]
    pub model_out: Option<PathBuf>,

    /// Exit 1 where what is measured again is more than this times the noise floor.
    #[arg(long, value_name = "TIMES", default_value_t = 1.5)]
    pub limit: f64,

    /// Everything a script needs, as JSON; - is standard output.
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<PathBuf>,
}

/// Runs `rehearse`.
///
/// # Errors
/// A file that cannot be read, an effect that a program cannot meet, a program that cannot be compensated.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    let robot = args.robot.load()?;
    let given = Given::read(&args.program)?;
    let json = files::Output::new(args.json.as_deref())?;
    let model_out = args.model_out.as_deref().map(files::Pending::new).transpose()?;
    let mut rng = Rng::new(args.seed, 0);
    let set = measured(args, &robot, &mut rng)?;
    let (diagnosis, identified) = found(&set, &robot)?;
    let identified = identified.ok_or_else(|| {
        Diagnostic::error("model::none", format!("no model can be made of these data: {}", diagnosis.reason))
    })?;
    if let Some(file) = model_out {
        file.write(identified.to_toml().as_bytes())?;
    }
    let emitted = compensated(&given, &robot, identified)?;
    let plain: Vec<(String, Vec<u8>)> =
        given.sources().into_iter().map(|f| (f.path, f.bytes.to_vec())).collect();
    let meant = moves(&robot, &plain)?;
    let done = moves(&robot, &emitted)?;
    let robot_under_test = VirtualRobot::from_truth(&robot, &set.truth);
    let before = judged(&robot_under_test, &meant, &meant, args.sigma_mm, &mut rng);
    let after = judged(&robot_under_test, &meant, &done, args.sigma_mm, &mut rng);
    let floor_mm = args.sigma_mm * 3.0_f64.sqrt();
    let good = after.measured_mm <= args.limit * floor_mm;
    let answer = json!({
        "withheld": args.withhold, "verdict": diagnosis.verdict,
        "causes": diagnosis.causes.iter().map(describe).collect::<Vec<_>>(),
        "targets": before.n, "floor_rms_mm": floor_mm,
        "before": { "measured_rms_mm": before.measured_mm, "true_rms_mm": before.true_mm, "true_max_mm": before.max_mm },
        "after": { "measured_rms_mm": after.measured_mm, "true_rms_mm": after.true_mm, "true_max_mm": after.max_mm },
    });
    let takes_standard_output = json.is_standard();
    json.write(console, || Ok(format!("{answer:#}\n").into_bytes()))?;
    let to: &mut dyn Write = if takes_standard_output { console.err() } else { console.out() };
    writeln!(to, "withheld: {}", args.withhold)?;
    writeln!(to, "found in {} poses: {}", args.n, diagnosis.reason)?;
    writeln!(to, "noise floor {floor_mm:.4} mm, rms in space")?;
    for (when, j) in [("before", &before), ("after", &after)] {
        writeln!(
            to,
            "{when:>6}: {} targets measured, rms {:.4} mm with base and tool fitted; truly {:.4} mm rms, {:.4} mm at worst",
            j.n, j.measured_mm, j.true_mm, j.max_mm
        )?;
    }
    writeln!(to, "{} {} times the noise floor", if good { "within" } else { "NOT within" }, args.limit)?;
    Ok(if good { Outcome::Done } else { Outcome::Difference })
}

/// The virtual robot, measured.
fn measured(args: &Args, robot: &Robot, rng: &mut Rng) -> Result<DataSet, Diagnostic> {
    let recipe = synth::recipe(
        &synth::Ask {
            effects: &args.withhold,
            name: "rehearsal".to_owned(),
            n: args.n as usize,
            sigma_mm: args.sigma_mm,
            rho: args.rho,
            spread: exam::poses::Spread::Wide,
        },
        rng,
    )?;
    if let Some((effect, _)) = recipe.effects.iter().find(|(effect, _)| !is_lasting(effect)) {
        let name = effect.name().unwrap_or("this effect");
        return Err(Diagnostic::error(
            "rehearse::effect",
            format!("{name} changes with time or is the instrument's"),
        )
        .help("withhold effects of the arm that stay; drift over a warm-up is `fit`'s"));
    }
    data_set(robot, &args.robot.name, &recipe, rng).ok_or_else(|| {
        Diagnostic::error("synth::no-signal", format!("{} cannot be made as large as asked", args.withhold))
            .help("it lies inside the registration of base and tool, or --rho is too large for it")
    })
}

fn found(
    set: &DataSet,
    robot: &Robot,
) -> Result<(Diagnosis, Option<robot_model::deform::identified::Identified>), Diagnostic> {
    let measurements = Measurements::from_csv(set.csv.as_bytes())
        .map_err(|error| Diagnostic::error("measure::file", error.to_string()))?;
    let options = Options {
        tool_m: set.task.tool_mm.map(|mm| Vector3::from(mm).map(m_from_mm)),
        sigma_m: set.task.sigma_mm.map(m_from_mm),
    };
    Ok(diagnose_and_identify(&measurements, robot, &options))
}

/// The program's files, compensated for what was found.
fn compensated(
    given: &Given,
    robot: &Robot,
    identified: robot_model::deform::identified::Identified,
) -> Result<Vec<(String, Vec<u8>)>, Diagnostic> {
    let growth = identified.growth().unwrap_or(GrowthLaw::None);
    let rigid = Deformation::from_static(FrameOffsets::default(), growth);
    let options = compensate::Options {
        max_correction_m: m_from_mm(3.0),
        max_correction_rad: rad_from_deg(0.5),
        model: Some(Arc::new(identified)),
        ..compensate::Options::default()
    };
    let program = Program::read(given.sources(), &Overrides::default());
    let plan = plan(&program, robot, &rigid, &options)
        .map_err(|error| Diagnostic::error(error.code(), error.to_string()))?;
    if let Some(error) =
        plan.diagnostics.iter().find(|d| d.severity == rapid_syntax::diagnostic::Severity::Error)
    {
        return Err(error.clone());
    }
    let how = EmitOptions {
        clock: Clock::Elapsed,
        core: None,
        form: FormChoice::Schedule,
        growth: None,
        robot: Provenance::default(),
        deformation: Provenance::default(),
        absolute_accuracy: false,
        self_test: false,
    };
    let emitted =
        emit(&program, &plan, &how).map_err(|error| Diagnostic::error(error.code(), error.to_string()))?;
    let mut all: Vec<(String, Vec<u8>)> = program
        .files
        .iter()
        .enumerate()
        .filter(|(i, _)| !emitted.iter().any(|e| e.source.is_some_and(|id| id.0 as usize == *i)))
        .map(|(_, file)| (file.path.clone(), file.bytes.to_vec()))
        .collect();
    all.extend(emitted.into_iter().map(|e| (e.path, e.bytes)));
    Ok(all)
}

/// The moves that a controller makes of a program: called cold first, where it has a clock.
fn moves(robot: &Robot, program: &[(String, Vec<u8>)]) -> Result<Vec<Move>, Diagnostic> {
    let refused =
        |error: virtual_controller::SimulateError| Diagnostic::error(error.code(), error.to_string());
    let mut controller = Controller::with_robot(robot).map_err(refused)?;
    for (path, bytes) in program {
        controller.load(path, bytes).map_err(refused)?;
        controller.put_file(path, bytes);
    }
    for name in ["tcColdStart", "tcUpdate"] {
        if controller.has_routine(name) {
            controller.call(name, 1).map_err(refused)?;
        }
    }
    let entry = controller.entry().map_err(refused)?;
    controller.call(&entry, 1).map_err(refused)?;
    Ok(controller.arm_mut().map(virtual_controller::Arm::take_moves).unwrap_or_default())
}

/// What is left at a program's targets.
struct Judged {
    n: usize,
    measured_mm: f64,
    true_mm: f64,
    max_mm: f64,
}

/// The moves of `done` on the true robot, against where `meant` goes on a perfect one.
fn judged(
    robot_under_test: &VirtualRobot,
    meant: &[Move],
    done: &[Move],
    sigma_mm: f64,
    rng: &mut Rng,
) -> Judged {
    let mut flanges: Vec<Isometry3<f64>> = Vec::new();
    let mut off_m: Vec<Vector3<f64>> = Vec::new();
    for (a, b) in meant.iter().zip(done) {
        let (Some(meant_rad), Some(q_rad)) = (a.q_rad, b.q_rad) else { continue };
        let payload = b.setup.payload;
        let at = Commanded {
            q_rad,
            direction: b.direction,
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
    Judged {
        n,
        measured_mm: mm_from_m(measured_rms_m(&flanges, &off_m, sigma_mm, rng)),
        true_mm: mm_from_m(true_m),
        max_mm: mm_from_m(off_m.iter().map(Vector3::norm).fold(0.0, f64::max)),
    }
}

//! `driftpost tabulate`: joints of a list of targets at every minute of warm-up.

#![allow(
    rustdoc::broken_intra_doc_links,
    reason = "doc comments of options are their help texts: brackets are brackets"
)]

use super::files::{self, Output};
use super::minutes::Minutes;
use super::shared::RobotName;
use super::{Console, Outcome, model};
use anyhow::Context;
use driftpost::report::{JointRow, JointTable, counted};
use nalgebra::UnitQuaternion;
use rapid_program::compensate::tabulate::{MinuteMiss, Miss, Table, tabulate};
use rapid_program::compensate::targets::{self, Target};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::kinematics::Configuration;
use robot_model::units::{deg_from_rad, mm_from_m, rad_from_deg};
use serde_json::{Value, json};
use std::io::Write;
use std::path::PathBuf;

/// Command line of `driftpost tabulate`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// Targets (CSV): name,x_mm,y_mm,z_mm[,rx_deg,ry_deg,rz_deg], or RoboDK's No. point,X[mm],Y[mm],Z[mm][,Ox[deg],Oy[deg],Oz[deg]].
    #[arg(value_name = "TARGETS.csv")]
    pub targets: PathBuf,

    /// The robot that is tabulated.
    #[command(flatten)]
    pub robot: RobotName,

    /// Roll, pitch, yaw of the flange about fixed axes, where the targets have positions only.
    #[arg(long, value_name = "RX,RY,RZ", value_parser = three, allow_hyphen_values = true)]
    pub orient_deg: Option<[f64; 3]>,

    /// The branch for all targets: cfx, and the whole turns nearest to the quadrants [default: nearest to the previous
    /// target's joints, the first nearest to zero].
    #[arg(long, value_name = "CF1,CF4,CF6,CFX", value_parser = confdata, allow_hyphen_values = true)]
    pub confdata: Option<Configuration>,

    /// Deformation table (CSV), static or scheduled [default: the reference paper's Table 2, built in].
    #[arg(long, value_name = "FILE")]
    pub deformation: Option<PathBuf>,

    /// How a static table grows with the warm-up minute: none, exp:TAU or two-stage:TAU
    /// [default: two-stage:46 for the built-in table; required with a static table of yours].
    #[arg(long, value_name = "LAW", allow_hyphen_values = true)]
    pub growth: Option<String>,

    /// Warm-up minutes: FROM:TO:STEP, or a list such as 0,5,37.5.
    #[arg(long, value_name = "MINUTES", default_value = "0:180:1", allow_hyphen_values = true)]
    pub minutes: Minutes,

    /// The joints, as CSV; - is standard output.
    #[arg(long, value_name = "FILE|-")]
    pub joints_csv: Option<PathBuf>,

    /// How far the targets are missed before and after, as JSON; - is standard output.
    #[arg(long, value_name = "FILE|-")]
    pub json: Option<PathBuf>,
}

/// Runs `tabulate`.
///
/// # Errors
/// A file that cannot be read or written, or a target that the arm cannot stand on; nothing is written then.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    let file = args.targets.display().to_string();
    let robot = args.robot.load()?;
    let deformation = model::deformation(args.deformation.as_deref(), args.growth.as_deref())?;
    let orientation = args.orient_deg.map(|rpy_deg| {
        let [roll, pitch, yaw] = rpy_deg.map(rad_from_deg);
        UnitQuaternion::from_euler_angles(roll, pitch, yaw)
    });
    let bytes = files::read(&args.targets, "file of targets")?;
    let targets = targets::read(&bytes, orientation.as_ref())
        .map_err(|error| model::in_file(&file, Diagnostic::from(error)))?;
    let joints_csv = Output::new(args.joints_csv.as_deref())?;
    let json = Output::new(args.json.as_deref())?;

    let table = tabulate(&robot, &deformation, &targets, args.confdata.as_ref(), &args.minutes.0)
        .map_err(|error| model::in_file(&file, Diagnostic::from(error)))?;
    let misses = table.misses();

    let takes_standard_output = [&joints_csv, &json].into_iter().any(Output::is_standard);
    joints_csv.write(console, || joints_text(&file, &targets, &table))?;
    json.write(console, || Ok(format!("{:#}\n", summary_json(&targets, &table, &misses)).into_bytes()))?;
    let to: &mut dyn Write = if takes_standard_output { console.err() } else { console.out() };
    summarise(to, &targets, &table, &misses)?;
    Ok(Outcome::Done)
}

fn joints_text(file: &str, targets: &[Target], table: &Table) -> anyhow::Result<Vec<u8>> {
    let mut rows = table.rows.iter().filter_map(|row| {
        let target = targets.get(row.target)?;
        Some(JointRow {
            target: target.name.as_str().into(),
            file,
            line: target.line,
            t_min: row.t_min,
            q_rad: row.q_rad,
            position_m: row.position_m,
            residual_m: row.residual_m,
        })
    });
    let mut text = Vec::new();
    let written = JointTable::new(&mut text).and_then(|mut table| {
        rows.try_for_each(|row| table.add(row))?;
        table.finish()
    });
    written.context("the table of joints")?;
    Ok(text)
}

fn summary_json(targets: &[Target], table: &Table, misses: &[MinuteMiss]) -> Value {
    let miss = |miss: &Miss| json!({ "max_mm": mm_from_m(miss.max_m), "rms_mm": mm_from_m(miss.rms_m), "max_deg": deg_from_rad(miss.max_rad) });
    let minute = |minute: &MinuteMiss| {
        json!({
            "t_min": minute.t_min, "n": targets.len(), "before": miss(&minute.before), "after": miss(&minute.after),
        })
    };
    let target = |(target, nominal): (&Target, &robot_model::kinematics::Solution)| {
        let c = nominal.configuration;
        json!({
            "target": target.name, "line": target.line, "q_deg": nominal.q_rad.map(deg_from_rad),
            "confdata": [c.cf1, c.cf4, c.cf6, c.cfx],
        })
    };
    json!({
        "rows": table.rows.len(),
        "targets": targets.iter().zip(&table.nominal).map(target).collect::<Vec<_>>(),
        "minutes": misses.iter().map(minute).collect::<Vec<_>>(),
    })
}

fn summarise(
    to: &mut dyn Write,
    targets: &[Target],
    table: &Table,
    misses: &[MinuteMiss],
) -> std::io::Result<()> {
    let [targets, minutes, rows] =
        [(targets.len(), "target"), (misses.len(), "minute"), (table.rows.len(), "row")]
            .map(|(n, noun)| counted(n, noun));
    writeln!(to, "{targets} x {minutes} = {rows}")?;
    let worst =
        |of: fn(&MinuteMiss) -> &Miss| misses.iter().max_by(|a, b| of(a).max_m.total_cmp(&of(b).max_m));
    if let Some(worst) = worst(|minute| &minute.before) {
        let Miss { max_m, rms_m, max_rad } = worst.before;
        writeln!(
            to,
            "before: missed by up to {:.3} mm (rms {:.3} mm) and {:.3} deg, at minute {}",
            mm_from_m(max_m),
            mm_from_m(rms_m),
            deg_from_rad(max_rad),
            worst.t_min
        )?;
    }
    if let Some(worst) = worst(|minute| &minute.after) {
        let Miss { max_m, max_rad, .. } = worst.after;
        writeln!(
            to,
            "after: missed by up to {:.1e} mm and {:.1e} deg",
            mm_from_m(max_m),
            deg_from_rad(max_rad)
        )?;
    }
    Ok(())
}

fn three(text: &str) -> Result<[f64; 3], String> {
    let fields: Vec<f64> = numbers(text)?;
    if fields.iter().any(|v| !v.is_finite()) {
        return Err("angles are finite numbers".to_owned());
    }
    fields
        .try_into()
        .map_err(|fields: Vec<f64>| format!("three angles are needed, there are {}", fields.len()))
}

fn confdata(text: &str) -> Result<Configuration, String> {
    match numbers::<i32>(text)?[..] {
        [cf1, cf4, cf6, cfx] if (0..8).contains(&cfx) => Ok(Configuration { cf1, cf4, cf6, cfx }),
        [_, _, _, cfx] => Err(format!("cfx is 0 to 7, not {cfx}")),
        ref other => Err(format!("four whole numbers are needed, there are {}", other.len())),
    }
}

fn numbers<T: std::str::FromStr>(text: &str) -> Result<Vec<T>, String> {
    let number = |field: &str| {
        field.trim().parse().map_err(|_| format!("`{}` is not a number of this kind", field.trim()))
    };
    text.split(',').map(number).collect()
}

//! The options of `driftpost compensate`.

#![allow(
    rustdoc::broken_intra_doc_links,
    reason = "doc comments of options are their help texts: brackets are brackets"
)]

use super::option_values::{
    ClockName, CoreName, ExternalAxis, FormName, Temperatures, clock, external_axis, temperatures, until,
};
use super::touch::TouchArgs;
use crate::cli::other_tasks::{OfTask, TaskRobot, joints_of_task, name_of_task, task_robot};
use crate::cli::shared::{JointAngles, RobotName, name_and_value};
use rapid_compensation::compensate::Options;
use rapid_compensation::schedule::Until;
use std::path::PathBuf;

/// So long the last temperature is used where `--hold-min` says nothing else, minutes.
pub(super) const HOLD_MIN: f64 = 10.0;
/// So long a temperature may stand still where `--stale-min` says nothing else, minutes.
pub(super) const STALE_MIN: f64 = 60.0;

/// Command line of `driftpost compensate`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// RAPID modules, a folder of them, a .pgf, or - for standard input; names are resolved across all of them.
    #[arg(required = true, value_name = "PROGRAM")]
    pub program: Vec<PathBuf>,

    /// The robot that runs the program.
    #[command(flatten)]
    pub robot: RobotName,

    /// Of a backup with several robots: the robot of a motion task (folder TASKn or T_ROBn), and its deformation table; once for each.
    #[arg(
        long,
        value_name = "TASK=ROBOT[,DEFORMATION]",
        value_parser = task_robot,
        conflicts_with_all = ["robot", "deformation", "model", "touch", "in_place"],
        help_heading = "Robot and deformation"
    )]
    pub task: Vec<TaskRobot>,

    /// Deformation table (CSV), static or scheduled [default: the reference paper's Table 2, built in].
    #[arg(long, value_name = "FILE", help_heading = "Robot and deformation")]
    pub deformation: Option<PathBuf>,

    /// An identified model (TOML) of diagnose --model-out, instead of a deformation table or on top of one.
    #[arg(long, value_name = "FILE", help_heading = "Robot and deformation")]
    pub model: Option<PathBuf>,

    /// With --model: the whole load on the flange, kg [default: what the tools' load data say].
    #[arg(long, value_name = "KG", requires = "model", help_heading = "Robot and deformation")]
    pub payload_kg: Option<f64>,

    /// With --model: temperature of the joints, one value or six, where the model has terms in temperature.
    #[arg(long, value_name = "C|C1,..,C6", requires = "model", value_parser = temperatures, allow_hyphen_values = true, help_heading = "Robot and deformation")]
    pub temperature_c: Option<Temperatures>,

    /// How a static table grows with the warm-up minute: none, exp:TAU or two-stage:TAU
    /// [default: two-stage:46 for the built-in table; required with a static table of yours].
    #[arg(long, value_name = "LAW", allow_hyphen_values = true, help_heading = "Robot and deformation")]
    pub growth: Option<String>,

    /// End of the schedule in minutes, or auto: where what is still to come is under the tolerance.
    #[arg(long, value_name = "MIN|auto", default_value = "auto", value_parser = until, allow_negative_numbers = true, help_heading = "Corrections")]
    pub until: Until,

    /// No target is further off than this anywhere in its bucket.
    #[arg(
        long,
        value_name = "MM",
        default_value_t = Options::TOLERANCE_MM,
        allow_negative_numbers = true,
        help_heading = "Corrections"
    )]
    pub tolerance_mm: f64,

    /// Buckets of this fixed width instead of a tolerance.
    #[arg(
        long,
        value_name = "MIN",
        conflicts_with = "tolerance_mm",
        allow_negative_numbers = true,
        help_heading = "Corrections"
    )]
    pub bucket_min: Option<f64>,

    /// What a motion asks instead of its target.
    #[arg(long, value_enum, default_value_t = FormName::Schedule, help_heading = "Corrections")]
    pub form: FormName,

    /// What the bucket follows: the robot's warm-up minute (warmth), minutes since tcColdStart (elapsed), or a
    /// temperature that the cell measures (signal:NAME, an analog input; pers:NAME, written from outside) for a
    /// deformation table with temp_c.
    #[arg(long, value_name = "warmth|elapsed|signal:NAME|pers:NAME", default_value = "warmth", value_parser = clock, help_heading = "Clock in the program")]
    pub clock: ClockName,

    /// Without a good reading of the temperature the last one is used for so long, minutes; then the originals.
    #[arg(
        long,
        value_name = "MIN",
        default_value_t = HOLD_MIN,
        allow_negative_numbers = true,
        help_heading = "Clock in the program"
    )]
    pub hold_min: f64,

    /// A temperature that has not changed for so long is no good reading any more, minutes.
    #[arg(
        long,
        value_name = "MIN",
        default_value_t = STALE_MIN,
        allow_negative_numbers = true,
        help_heading = "Clock in the program"
    )]
    pub stale_min: f64,

    /// Time constant of cooling while the program stands, minutes [default: the model's, or the growth law's].
    #[arg(long, value_name = "MIN", allow_negative_numbers = true, help_heading = "Clock in the program")]
    pub tau_cool: Option<f64>,

    /// A pause longer than this counts as standing, minutes.
    #[arg(
        long,
        value_name = "MIN",
        default_value_t = Options::GAP_MIN,
        allow_negative_numbers = true,
        help_heading = "Clock in the program"
    )]
    pub gap_min: f64,

    /// Where clock and index live: in the module, or once in tcCore.mod
    /// [default: embedded for one module, separate for more].
    #[arg(long, value_enum, help_heading = "Clock in the program")]
    pub core: Option<CoreName>,

    /// Value of a tool that no given module declares, e.g. 'tGrip=[TRUE,[[0,0,120],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]]'.
    #[arg(long, value_name = "NAME=DATA", value_parser = name_and_value, allow_hyphen_values = true, help_heading = "What is accepted")]
    pub tool: Vec<(String, String)>,

    /// Value of a work object that no given module declares.
    #[arg(long, value_name = "NAME=DATA", value_parser = name_and_value, allow_hyphen_values = true, help_heading = "What is accepted")]
    pub wobj: Vec<(String, String)>,

    /// Joints with which the arm stands when the entry is called, degrees: makes branches certain that the text leaves open; of
    /// several tasks once for each.
    #[arg(long, value_name = "[TASK=]Q1,..,Q6", value_parser = joints_of_task, allow_hyphen_values = true, conflicts_with = "home", help_heading = "What is accepted")]
    pub start_joints: Vec<OfTask<JointAngles>>,

    /// The same as a jointtarget of the program, or of the task.
    #[arg(long, value_name = "[TASK=]NAME", value_parser = name_of_task, help_heading = "What is accepted")]
    pub home: Vec<OfTask<String>>,

    /// Joints that motions end with (CSV: file,line,q1_deg,..,q6_deg, or a row q1_deg,..,q6_deg for each target in order), as a post-processor knows them: makes branches certain.
    #[arg(long, value_name = "FILE", help_heading = "What is accepted")]
    pub joints_hint: Option<PathBuf>,

    /// Leave the motions of this target, routine or module alone; * and ? stand for any letters. Repeatable.
    #[arg(long, value_name = "GLOB", help_heading = "What is accepted")]
    pub keep: Vec<String>,

    /// Correct the motions of this target, routine or module alone. Repeatable.
    #[arg(long, value_name = "GLOB", help_heading = "What is accepted")]
    pub only: Vec<String>,

    /// External axes (a to f) that move neither the robot's base nor a work object.
    #[arg(long, value_name = "AXIS,..", value_delimiter = ',', value_parser = external_axis, help_heading = "What is accepted")]
    pub base_fixed: Vec<ExternalAxis>,

    /// A larger correction than this is refused [default: 0.5; with --model 3].
    #[arg(long, value_name = "MM", allow_negative_numbers = true, help_heading = "Corrections")]
    pub max_correction_mm: Option<f64>,

    /// A larger correction than this is refused [default: 0.1; with --model 0.5].
    #[arg(long, value_name = "DEG", allow_negative_numbers = true, help_heading = "Corrections")]
    pub max_correction_deg: Option<f64>,

    /// A linear move that leaves its line by more than this at mid-path is warned about.
    #[arg(
        long,
        value_name = "MM",
        default_value_t = Options::PATH_TOLERANCE_MM,
        allow_negative_numbers = true,
        help_heading = "Corrections"
    )]
    pub path_tolerance_mm: f64,

    /// Leave MoveAbsJ as it is (RoboDK writes MoveJ so; it is corrected otherwise).
    #[arg(long, help_heading = "Corrections")]
    pub keep_moveabsj: bool,

    /// Accept a program that RoboDK says was not made with nominal kinematics.
    #[arg(long, help_heading = "What is accepted")]
    pub allow_non_nominal: bool,

    /// Accept a program, a model or a table that is another robot's.
    #[arg(long, help_heading = "What is accepted")]
    pub allow_other_robot: bool,

    /// The controller's own Absolute Accuracy is on: MoveAbsJ is kept.
    #[arg(long, help_heading = "Corrections")]
    pub absolute_accuracy: bool,

    /// With --form live or auto: add tcSelfTest, which compares the controller's kinematics with those that the corrections
    /// were made for and times the calls, before anything moves.
    #[arg(long, help_heading = "Clock in the program")]
    pub self_test: bool,

    /// How tcTouch measures the thermal state.
    #[command(flatten)]
    pub touch: TouchArgs,

    /// Refuse the program where a motion would be kept.
    #[arg(long, help_heading = "What is accepted")]
    pub strict: bool,

    /// Where the result goes, - being standard output [default: STEM_tc.EXT beside one file, folder NAME_tc/ for more].
    #[arg(short, long, value_name = "PATH", help_heading = "Results")]
    pub output: Option<PathBuf>,

    /// Overwrite the input.
    #[arg(long, conflicts_with = "output", help_heading = "Results")]
    pub in_place: bool,

    /// Overwrite a result of ours that was changed since it was written (touched up, saved back by a controller).
    #[arg(long, help_heading = "Results")]
    pub force: bool,

    /// Run again whenever a file of the program is written anew, until interrupted.
    #[arg(long, conflicts_with = "in_place", help_heading = "Results")]
    pub watch: bool,

    /// What is shown of the difference: short (changed motions and the first targets, at most 60 lines), none, - (the whole
    /// on standard output), or a file for the whole as a unified diff.
    #[arg(long, value_name = "short|none|-|FILE", default_value = "short", help_heading = "Results")]
    pub diff: PathBuf,

    /// Joints solved at every minute, as CSV.
    #[arg(long, value_name = "FILE", help_heading = "Results")]
    pub joints_csv: Option<PathBuf>,

    /// One HTML page to look at: the arm, the drift, every correction and changed line; opens in any browser, offline.
    #[arg(long, value_name = "FILE.html", help_heading = "Results")]
    pub report: Option<PathBuf>,

    /// A recording of the warm-up for Foxglove and Rerun (MCAP), and the arm as URDF beside it.
    #[cfg(feature = "mcap")]
    #[arg(long, value_name = "FILE.mcap", conflicts_with = "task", help_heading = "Results")]
    pub mcap: Option<PathBuf>,

    /// Show every motion and every message, however many there are.
    #[arg(long, help_heading = "Results")]
    pub all: bool,

    /// Everything a script needs, as JSON; - is standard output.
    #[arg(long, value_name = "FILE|-", help_heading = "Results")]
    pub json: Option<PathBuf>,
}

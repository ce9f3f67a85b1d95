//! Move instructions: arguments by position, tool and work object as they are at that moment.

use super::data::call_by_name;
use super::parameter::{ExtJoint, Instruction, Parameter, RobTarget, Unevaluated, instruction, string};
use super::signals::put;
use super::tools::{setup, setup_of, tool_and_object, total_load};
use crate::arm::{ControllerArm, Move, SolvedMove, SpeedOverride};
use crate::code::{Arg, Expr, ExprKind, Name, NameRef};
use crate::frame::{self, Setup};
use crate::ids::ModuleId;
use crate::interpreter::{Args, Interpreter};
use crate::outcome::{Fault, fatal, raise};
use crate::path::PathKind;
use crate::predefined;
use crate::value::{Type, Value};
use nalgebra::{Isometry3, Translation3};
use robot_model::units::{deg_from_rad, m_from_mm, rad_from_deg};

/// What a move counts towards the steps of one call: its record stays in memory, so that a million of them is the end.
const STEPS_OF_A_MOVE: u64 = 50;

/// Where the arguments of a move stand.
pub(crate) struct MoveForm {
    path: PathKind,
    /// First target; an arc's circle point, its end point follows.
    target: usize,
    speed: usize,
    tool: usize,
    /// A procedure's name, called at the target.
    procedure: Option<usize>,
    /// A signal that is set at the target; its value follows, in order or by name.
    output: Option<usize>,
}

impl MoveForm {
    /// The move to where this one ends, on the way back from `later`: straight where that one came straight or on
    /// an arc.
    pub(crate) fn back_from(self, later: &Self) -> Self {
        let path = match (self.path, later.path) {
            (PathKind::AbsJoint, _) => PathKind::AbsJoint,
            (_, PathKind::Linear | PathKind::Circular) => PathKind::Linear,
            (_, PathKind::Joint | PathKind::AbsJoint) => PathKind::Joint,
        };
        Self { path, target: self.speed - 1, procedure: None, output: None, ..self }
    }
}

/// The form of a move instruction by its name in lower case.
pub(crate) fn form(name: &str) -> Option<MoveForm> {
    use PathKind::{AbsJoint, Circular, Joint, Linear};
    let (path, target, tool) = match name {
        "movel" | "moveldo" | "movelao" | "movelgo" | "movelsync" | "arcmovel" => (Linear, 0, 3),
        "movej" | "movejdo" | "movejao" | "movejgo" | "movejsync" | "arcmovej" => (Joint, 0, 3),
        "moveabsj" | "arcmoveabsj" => (AbsJoint, 0, 3),
        "movec" | "movecdo" | "movecao" | "movecgo" | "movecsync" | "arcmovec" => (Circular, 0, 4),
        "triggl" => (Linear, 0, 4),
        "triggj" => (Joint, 0, 4),
        "triggc" => (Circular, 0, 5),
        "arcl" | "arclstart" | "arclend" => (Linear, 0, 5),
        "arcc" | "arccstart" | "arccend" => (Circular, 0, 6),
        "searchl" => (Linear, 2, 4),
        "searchc" => (Circular, 2, 5),
        _ => return None,
    };
    let targets = if path == Circular { 2 } else { 1 };
    let procedure = name.ends_with("sync").then_some(tool + 1);
    let sets_output = name.starts_with("move") && ["do", "ao", "go"].iter().any(|kind| name.ends_with(kind));
    let output = sets_output.then_some(tool + 1);
    Some(MoveForm { path, target, speed: target + targets, tool, procedure, output })
}

/// Fastest joint, for the time a joint move takes, deg/s: data sheets give 200 and more.
const JOINT_SPEED_DEG_S: f64 = 200.0;

pub(super) const INSTRUCTIONS: &[Instruction] = &[
    instruction!("confl", (), |vm, args| with_arm(vm, |arm| arm.conf_l = !args.has("off"))),
    instruction!("confj", (), |vm, args| with_arm(vm, |arm| arm.conf_j = !args.has("off"))),
    instruction!("velset", (percent: f32, max_mm_s: f32), |vm, args| with_arm(vm, |arm| {
        arm.speed = SpeedOverride { of_program: share(percent), max_mm_s: max_mm_s.into(), ..arm.speed };
    })),
    instruction!("speedrefresh", (percent: f32), |vm, args| with_arm(vm, |arm| {
        arm.speed = SpeedOverride { of_operator: share(percent), ..arm.speed };
    })),
    instruction!("pdispset", (displacement: Isometry3<f64>), |vm, args| {
        with_arm(vm, |arm| arm.displacement = displacement)
    }),
    instruction!("pdispon", (target: RobTarget, tool: Unevaluated), |vm, args| {
        displace_from(vm, args, &target)
    }),
    instruction!("pdispoff", (), |vm, args| with_arm(vm, |arm| arm.displacement = Isometry3::identity())),
    instruction!("eoffsset", (offsets: ExtJoint), |vm, args| {
        let offsets = std::array::from_fn(|i| offsets.0.get(i).copied().unwrap_or(0.0));
        with_arm(vm, |arm| arm.axis_offsets = offsets)
    }),
    instruction!("eoffsoff", (), |vm, args| with_arm(vm, |arm| arm.axis_offsets = [0.0; 6])),
];

/// A share of the written speed; at 0 % an arm would never get there.
fn share(percent: f32) -> f64 {
    f64::from(percent).clamp(1.0, 100.0) / 100.0
}

fn with_arm(vm: &mut Interpreter<'_>, change: impl FnOnce(&mut ControllerArm)) -> Result<(), Fault> {
    if let Some(arm) = vm.arm.as_deref_mut() {
        change(arm);
    }
    Ok(())
}

/// Makes a move, and calls the procedure of a `...Sync` at its end.
pub(super) fn make(vm: &mut Interpreter<'_>, form: &MoveForm, args: &Args<'_>) -> Result<(), Fault> {
    let procedure = vm.metered(|vm| execute(vm, form, args))?;
    vm.serve_missed()?;
    match procedure {
        Some(procedure) => call_by_name(vm, &procedure),
        None => Ok(()),
    }
}

/// PDispOn: the displacement that takes the target given to where the arm stands, or to `\ExeP`; with `\Rot` its
/// orientation too.
fn displace_from(vm: &mut Interpreter<'_>, args: &Args<'_>, target: &RobTarget) -> Result<(), Fault> {
    let target = frame::isometry_of(&target.0)?;
    let setup = setup_of(vm, args.at(1)?, args.named("wobj"))?;
    let given = match args.named("exep") {
        Some(e) => {
            let ty = vm.program.types.robtarget.clone();
            Some(frame::isometry_of(&vm.eval_as(e, &ty)?.numbers())?)
        }
        None => None,
    };
    with_arm(vm, |arm| {
        let reached = given.unwrap_or_else(|| arm.object_from_tcp(&setup));
        arm.displacement = if args.has("rot") {
            reached * target.inverse()
        } else {
            Translation3::from(reached.translation.vector - target.translation.vector).into()
        };
    })
}

/// C_PROGDISP: what PDispSet, PDispOn and EOffsSet have left.
pub(crate) fn program_displacement(vm: &Interpreter<'_>) -> Value {
    let arm = vm.arm.as_ref();
    let displacement = arm.map_or_else(Isometry3::identity, |arm| arm.displacement);
    let mut numbers = frame::pose_numbers(&displacement).to_vec();
    numbers.extend(arm.map_or([0.0; 6], |arm| arm.axis_offsets));
    frame::value(&vm.program.types.progdisp, &numbers)
}

/// Makes a move; the procedure to be called at its end.
pub(crate) fn execute(
    vm: &mut Interpreter<'_>,
    form: &MoveForm,
    args: &Args<'_>,
) -> Result<Option<String>, Fault> {
    let targets = targets_of(vm, form, args)?;
    let (tool, object) = tool_and_object(vm, args.at(form.tool)?, args.named("wobj"))?;
    let total_load = total_load(vm, args)?;
    let setup = setup((&tool, total_load), &object, vm.machine)?;
    let output = form.output.map(|at| output_at(vm, args, at)).transpose()?;
    let start_q_rad = vm.arm.as_ref().and_then(|arm| arm.q_rad());
    let began_s = vm.machine.calendar.steady_s();
    let search = Search::of(vm, args, &targets, &setup)?;
    let solved = match &search {
        Some(Search { stops: Some(at), .. }) => Some(at.clone()),
        _ => solve(vm, form, &targets, &setup)?,
    };
    if let Some(solved) = &solved {
        let time_s = move_time_s(vm, args, form, solved, start_q_rad)?;
        vm.machine.calendar.advance_s(time_s);
        if let Some(complaint) = &solved.complaint {
            vm.report("controller", complaint.clone());
        }
    }
    let done = Move {
        at: vm.here(),
        offset: vm.position().start,
        routine: routine_in_work(vm),
        instruction: args.callee.to_owned(),
        target: name_of_target(args.at(form.speed - 1)?),
        path: form.path,
        setup,
        start_q_rad,
        via_q_rad: solved.as_ref().and_then(|s| s.via_q_rad),
        before_end_q_rad: solved.as_ref().and_then(|s| s.before_end_q_rad),
        q_rad: solved.as_ref().map(|s| s.q_rad),
        began_s,
        steady_s: vm.machine.calendar.steady_s(),
        direction: [0; 6],
        via_direction: [0; 6],
    };
    if let Some(arm) = vm.arm.as_deref_mut() {
        arm.record(done, tool, object);
        vm.machine.limits.steps.spend(STEPS_OF_A_MOVE);
    }
    if args.callee.starts_with("search") {
        store_search(vm, args, search)?;
    }
    vm.machine.limits.count_move();
    if let Some((signal, value)) = output {
        put(vm, signal, value)?;
    }
    match form.procedure {
        Some(at) => string(vm, args.at(at)?).map(Some),
        None => Ok(None),
    }
}

/// The numbers of a move's target; of an arc's circle point and of its end.
fn targets_of(vm: &mut Interpreter<'_>, form: &MoveForm, args: &Args<'_>) -> Result<Vec<Vec<f64>>, Fault> {
    let ty = match form.path {
        PathKind::AbsJoint => vm.program.types.jointtarget.clone(),
        _ => vm.program.types.robtarget.clone(),
    };
    (form.target..form.speed).map(|at| Ok(vm.eval_as(args.at(at)?, &ty)?.numbers())).collect()
}

/// The signal of a `MoveLDO`, `MoveLAO` or `MoveLGO` that stands at `at`, and what it is set to at the target.
fn output_at(vm: &mut Interpreter<'_>, args: &Args<'_>, at: usize) -> Result<(Name, f32), Fault> {
    let signal = vm.signal_name(args.at(at)?)?;
    let value = match (args.named("value"), args.named("dvalue")) {
        (Some(value), _) => vm.eval_num(value)?,
        (None, Some(value)) => vm.eval_as(value, &Type::Dnum)?.number().unwrap_or(0.0) as f32,
        (None, None) => vm.eval_num(args.at(at + 1)?)?,
    };
    Ok((signal, value))
}

/// Stores what a search has found, or raises the error of one that came to its end.
fn store_search(vm: &mut Interpreter<'_>, args: &Args<'_>, search: Option<Search>) -> Result<(), Fault> {
    let found_q_rad = match search {
        Some(Search { found_q_rad: None, .. }) => {
            return raise("err_whlsearch", "the search came to its end and found nothing");
        }
        Some(search) => search.found_q_rad,
        None => None,
    };
    store_found(vm, args, found_q_rad)
}

/// A straight search for something that stands in the cell.
struct Search {
    /// Joints at which it was found, radians.
    found_q_rad: Option<[f64; 6]>,
    /// The move up to there, where it stops.
    stops: Option<SolvedMove>,
}

impl Search {
    /// `None` for what is no straight search, or by a signal that nothing in the cell sets.
    fn of(
        vm: &mut Interpreter<'_>,
        args: &Args<'_>,
        targets: &[Vec<f64>],
        setup: &Setup,
    ) -> Result<Option<Self>, Fault> {
        if args.callee != "searchl" {
            return Ok(None);
        }
        let ExprKind::Name(NameRef { spelt: signal, .. }) = &args.at(0)?.kind else { return Ok(None) };
        let (Some(arm), Some(target)) = (vm.arm.as_deref(), targets.last()) else { return Ok(None) };
        let Some(feeler) = vm.machine.spheres.feeler(signal, setup) else { return Ok(None) };
        if arm.q_rad().is_some_and(|q_rad| feeler.gap_m(&q_rad) <= 0.0) {
            return raise("err_sigsupsearch", "the signal of a search is set before it begins");
        }
        let found = arm.search(target, setup, |q_rad| feeler.gap_m(q_rad))?;
        let stops = ["stop", "pstop", "sstop"].iter().any(|switch| args.has(switch));
        Ok(Some(Self {
            found_q_rad: found.as_ref().map(|found| found.q_rad),
            stops: found.filter(|_| stops),
        }))
    }
}

/// The joints of a move; `None` without arm, or where the controller cannot go there, which it reports.
fn solve(
    vm: &mut Interpreter<'_>,
    form: &MoveForm,
    targets: &[Vec<f64>],
    setup: &Setup,
) -> Result<Option<SolvedMove>, Fault> {
    let Some(arm) = vm.arm.as_deref_mut() else { return Ok(None) };
    match arm.solve_cached(form.path, targets, setup)? {
        Ok(solved) => Ok(Some(solved)),
        Err(why) => {
            vm.report("controller", format!("the move is not made: {why}"));
            Ok(None)
        }
    }
}

/// The routine that a move counts as one of: for a module that the program loaded, the one that called it.
fn routine_in_work(vm: &Interpreter<'_>) -> String {
    let is_dynamic =
        |module: ModuleId| vm.program.modules.get(module.index()).is_some_and(|m| m.dynamic.is_some());
    let frames = &vm.machine.stack.frames;
    let frame = frames.iter().rev().find(|f| !is_dynamic(f.module)).or(frames.last());
    let routine = frame.and_then(|f| vm.program.routines.get(f.routine.index()));
    routine.map_or_else(String::new, |r| r.name.to_string())
}

/// Stores what a search found: where the controller took the arm to be, or its end where nothing stands in the cell that
/// sets its signal.
fn store_found(
    vm: &mut Interpreter<'_>,
    args: &Args<'_>,
    found_q_rad: Option<[f64; 6]>,
) -> Result<(), Fault> {
    let Some(arm) = vm.arm.as_deref() else { return Ok(()) };
    let mut joints = arm.present_joints();
    for (deg, q_rad) in joints.iter_mut().zip(found_q_rad.into_iter().flatten()) {
        *deg = deg_from_rad(q_rad);
    }
    let found = arm.robtarget_of(&joints, &arm.last_setup(), &vm.program.types.robtarget)?;
    match vm.data_ref(args.at(1)?)? {
        Some((place, _)) => vm.write(&place, found),
        None => fatal("a search expects a variable for the point that it finds"),
    }
}

/// A target as it stands in the program: its name, that of the first argument of a function, or nothing where it
/// is an aggregate.
fn name_of_target(expr: &Expr) -> String {
    match &expr.kind {
        ExprKind::Call(call) => match call.args.first() {
            Some(Arg::Positional(first)) => name_of_target(first),
            _ => String::new(),
        },
        ExprKind::Name(name) => name.spelt.to_string(),
        ExprKind::Index(base, _) | ExprKind::Field(base, _) => name_of_target(base),
        _ => String::new(),
    }
}

/// How long a move takes: `\T`, else distance over speed, else what the joints can do.
fn move_time_s(
    vm: &mut Interpreter<'_>,
    args: &Args<'_>,
    form: &MoveForm,
    solved: &SolvedMove,
    start: Option<[f64; 6]>,
) -> Result<f64, Fault> {
    let slowed = vm.arm.as_deref().map(|arm| arm.speed).unwrap_or_default();
    if let Some(e) = args.named("t") {
        return vm.eval_num(e).map(|t| (f64::from(t) / slowed.share()).clamp(0.0, 3600.0));
    }
    let (mut v_mm_s, ori_deg_s) = speed(vm, args.at(form.speed)?)?;
    if let Some(e) = args.named("v") {
        v_mm_s = f64::from(vm.eval_num(e)?);
    }
    let v_mm_s = (v_mm_s * slowed.share()).min(slowed.max_mm_s);
    let line = solved.length_m / m_from_mm(v_mm_s.max(0.1));
    let turn = solved.turn_rad / rad_from_deg((ori_deg_s * slowed.share()).max(0.1));
    let joints = start.map_or(0.0, |start| {
        let far = start.iter().zip(&solved.q_rad).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        far / rad_from_deg(JOINT_SPEED_DEG_S)
    });
    Ok(line.max(turn).max(joints).min(3600.0))
}

/// TCP speed (mm/s) and reorientation speed (deg/s); a name like v83 that is declared nowhere says
/// its own.
fn speed(vm: &mut Interpreter<'_>, expr: &Expr) -> Result<(f64, f64), Fault> {
    if let ExprKind::Name(named) = &expr.kind
        && let NameRef { name, spelt, .. } = named
        && vm.resolve_datum(named).is_none()
        && predefined::constant(&vm.program.types, name).is_none()
    {
        vm.report("controller", format!("speed {spelt} is declared nowhere"));
        let v = name.strip_prefix('v').and_then(|v| v.parse().ok()).unwrap_or(100.0);
        return Ok((v, 500.0));
    }
    let ty = vm.program.types.speeddata.clone();
    let numbers = vm.eval_as(expr, &ty)?.numbers();
    Ok((numbers.first().copied().unwrap_or(100.0), numbers.get(1).copied().unwrap_or(500.0)))
}

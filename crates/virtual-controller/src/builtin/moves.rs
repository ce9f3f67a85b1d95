//! Move instructions: arguments by position, tool and work object as they are at that moment.

use super::Known;
use crate::call::Args;
use crate::controller::Controller;
use crate::frame::{self, Setup};
use crate::ir::{Arg, Expr, ExprKind};
use crate::motion::{Move, Solved};
use crate::outcome::{Fault, fatal};
use crate::path::PathKind;
use crate::value::{Type, Value};
use nalgebra::{Isometry3, Point3, Translation3, Vector3};
use robot_model::deform::Payload;
use robot_model::units::{m_from_mm, rad_from_deg};

/// What a move counts towards the steps of one call: its record stays in memory, so that a million of them is the end.
const STEPS_OF_A_MOVE: u64 = 50;

/// Where the arguments of a move stand.
pub(crate) struct Form {
    path: PathKind,
    /// First target; an arc's circle point, its end point follows.
    target: usize,
    speed: usize,
    tool: usize,
    /// A procedure's name, called at the target.
    procedure: Option<usize>,
}

impl Form {
    /// The move to where this one ends, on the way back from `later`: straight where that one came straight or on
    /// an arc.
    pub(crate) fn back_from(self, later: &Self) -> Self {
        let path = match (self.path, later.path) {
            (PathKind::AbsJoint, _) => PathKind::AbsJoint,
            (_, PathKind::Linear | PathKind::Circular) => PathKind::Linear,
            (_, PathKind::Joint | PathKind::AbsJoint) => PathKind::Joint,
        };
        Self { path, target: self.speed - 1, procedure: None, ..self }
    }
}

/// The form of a move instruction by its name in lower case.
pub(crate) fn form(name: &str) -> Option<Form> {
    use PathKind::{AbsJoint, Circular, Joint, Linear};
    let (path, target, tool) = match name {
        "movel" | "moveldo" | "movelao" | "movelgo" | "movelsync" => (Linear, 0, 3),
        "movej" | "movejdo" | "movejao" | "movejgo" | "movejsync" => (Joint, 0, 3),
        "moveabsj" => (AbsJoint, 0, 3),
        "movec" | "movecdo" | "movecao" | "movecgo" | "movecsync" => (Circular, 0, 4),
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
    Some(Form { path, target, speed: target + targets, tool, procedure })
}

/// Fastest joint, for the time a joint move takes, deg/s: data sheets give 200 and more.
const JOINT_SPEED_DEG_S: f64 = 200.0;

impl Controller {
    pub(crate) fn move_instruction(&mut self, name: &str, args: &Args<'_>) -> Known<()> {
        if let Some(form) = form(name) {
            if let Some(procedure) = self.metered(|c| c.execute_move(name, &form, args))? {
                self.call_by_name(&procedure)?;
            }
            return Ok(Some(()));
        }
        match name {
            "confl" | "confj" => {
                let on = !args.has("off");
                if let Some(arm) = &mut self.arm {
                    *(if name == "confl" { &mut arm.conf_l } else { &mut arm.conf_j }) = on;
                }
            }
            "pdispset" => {
                let ty = self.types.pose.clone();
                let pose = frame::isometry(&self.eval_as(args.at(0)?, &ty)?)?;
                if let Some(arm) = &mut self.arm {
                    arm.displacement = pose;
                }
            }
            "pdispon" => self.displace_from(args)?,
            "pdispoff" => {
                if let Some(arm) = &mut self.arm {
                    arm.displacement = Isometry3::identity();
                }
            }
            "eoffsset" => {
                let ty = self.types.extjoint.clone();
                let offsets = self.eval_as(args.at(0)?, &ty)?.numbers();
                self.offset_axes(&offsets);
            }
            "eoffsoff" => self.offset_axes(&[]),
            _ => return Ok(None),
        }
        Ok(Some(()))
    }

    /// PDispOn: the displacement that takes the target given to where the arm stands, or to `\ExeP`; with `\Rot` its
    /// orientation too.
    fn displace_from(&mut self, args: &Args<'_>) -> Result<(), Fault> {
        let ty = self.types.robtarget.clone();
        let target = frame::isometry_of(&self.eval_as(args.at(0)?, &ty)?.numbers())?;
        let setup = self.setup_of(args.at(1)?, args.named("wobj"))?;
        let given = match args.named("exep") {
            Some(e) => Some(frame::isometry_of(&self.eval_as(e, &ty)?.numbers())?),
            None => None,
        };
        if let Some(arm) = &mut self.arm {
            let stands = given.unwrap_or_else(|| arm.stands(&setup));
            arm.displacement = if args.has("rot") {
                stands * target.inverse()
            } else {
                Translation3::from(stands.translation.vector - target.translation.vector).into()
            };
        }
        Ok(())
    }

    fn offset_axes(&mut self, offsets: &[f64]) {
        if let Some(arm) = &mut self.arm {
            arm.axis_offsets = std::array::from_fn(|i| offsets.get(i).copied().unwrap_or(0.0));
        }
    }

    /// C_PROGDISP: what PDispSet, PDispOn and EOffsSet have left.
    pub(crate) fn progdisp(&self) -> Value {
        let arm = self.arm.as_ref();
        let displacement = arm.map_or_else(Isometry3::identity, |arm| arm.displacement);
        let mut numbers = frame::pose_numbers(&displacement).to_vec();
        numbers.extend(arm.map_or([0.0; 6], |arm| arm.axis_offsets));
        frame::value(&self.types.progdisp, &numbers)
    }

    /// Make a move; what comes back is the procedure to be called at its end.
    pub(crate) fn execute_move(
        &mut self,
        name: &str,
        form: &Form,
        args: &Args<'_>,
    ) -> Result<Option<String>, Fault> {
        let ty = match form.path {
            PathKind::AbsJoint => self.types.jointtarget.clone(),
            _ => self.types.robtarget.clone(),
        };
        let mut targets = Vec::with_capacity(2);
        for at in form.target..form.speed {
            targets.push(self.eval_as(args.at(at)?, &ty)?.numbers());
        }
        let (tool, wobj) = self.tool_and_object(args.at(form.tool)?, args.named("wobj"))?;
        let setup = setup(&tool, &wobj, self.gripped)?;
        let start = self.arm.as_ref().and_then(|arm| arm.q_rad());
        let began_s = self.calendar.steady_s();
        let solved = match &mut self.arm {
            Some(arm) => match arm.solve_again(form.path, &targets, &setup)? {
                Ok(solved) => Some(solved),
                Err(why) => {
                    self.tell("controller", format!("the move is not made: {why}"));
                    None
                }
            },
            None => None,
        };
        if let Some(solved) = &solved {
            let time_s = self.move_time_s(args, form, solved, start)?;
            self.calendar.advance_s(time_s);
            if let Some(complaint) = &solved.complaint {
                self.tell("controller", complaint.clone());
            }
        }
        let at = self.here();
        // A module that the program loaded stands in for the routine that called it.
        let dynamic = |module: usize| self.memory.modules.get(module).is_some_and(|m| m.dynamic.is_some());
        let frame = self.frames.iter().rev().find(|f| !dynamic(f.module)).or(self.frames.last());
        let routine = frame.and_then(|f| self.memory.routines.get(f.routine));
        let done = Move {
            at,
            routine: routine.map_or_else(String::new, |r| r.name.to_string()),
            instruction: name.to_owned(),
            target: self.spelt(args.at(form.speed - 1)?),
            path: form.path,
            setup,
            start_q_rad: start,
            via_q_rad: solved.as_ref().and_then(|s| s.via_q_rad),
            q_rad: solved.as_ref().map(|s| s.q_rad),
            began_s,
            steady_s: self.calendar.steady_s(),
            direction: [0; 6],
        };
        if let Some(arm) = &mut self.arm {
            arm.record(done, tool, wobj);
            self.steps_left = self.steps_left.saturating_sub(STEPS_OF_A_MOVE);
        }
        if name.starts_with("search") {
            self.store_found(args)?;
        }
        if let Some(moves) = &mut self.moves_to_stop {
            *moves = moves.saturating_sub(1);
        }
        let Some(procedure) = form.procedure else { return Ok(None) };
        let procedure = self.eval_as(args.at(procedure)?, &Type::Str)?;
        Ok(procedure.string().map(str::to_owned))
    }

    /// Where a search stops: nothing is found here before its end.
    fn store_found(&mut self, args: &Args<'_>) -> Result<(), Fault> {
        let Some(arm) = &self.arm else { return Ok(()) };
        let found = arm.robtarget_of(&arm.present_joints(), &arm.last_setup(), &self.types.robtarget)?;
        match self.place(args.at(1)?)? {
            Some((place, _)) => self.write(&place, found),
            None => fatal("a search wants a variable for the point that it finds"),
        }
    }

    /// A target as it stands in the program: its name, that of the first argument of a function, or nothing where it
    /// is an aggregate.
    fn spelt(&self, expr: &Expr) -> String {
        match &expr.kind {
            ExprKind::Call(call) => match call.args.first() {
                Some(Arg::Positional(first)) => self.spelt(first),
                _ => String::new(),
            },
            ExprKind::Name(_, spelt) => spelt.to_string(),
            ExprKind::Index(base, _) | ExprKind::Field(base, _) => self.spelt(base),
            _ => String::new(),
        }
    }

    /// How long a move takes: `\T`, else distance over speed, else what the joints can do.
    fn move_time_s(
        &mut self,
        args: &Args<'_>,
        form: &Form,
        solved: &Solved,
        start: Option<[f64; 6]>,
    ) -> Result<f64, Fault> {
        if let Some(e) = args.named("t") {
            return self.eval_num(e).map(|t| f64::from(t).clamp(0.0, 3600.0));
        }
        let (mut v_mm_s, ori_deg_s) = self.speed(args.at(form.speed)?)?;
        if let Some(e) = args.named("v") {
            v_mm_s = f64::from(self.eval_num(e)?);
        }
        let line = solved.length_m / m_from_mm(v_mm_s.max(0.1));
        let turn = solved.turn_rad / rad_from_deg(ori_deg_s.max(0.1));
        let joints = start.map_or(0.0, |start| {
            let far = start.iter().zip(&solved.q_rad).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            far / rad_from_deg(JOINT_SPEED_DEG_S)
        });
        Ok(line.max(turn).max(joints).min(3600.0))
    }

    /// TCP speed (mm/s) and reorientation speed (deg/s); a name like v83 that is declared nowhere says
    /// its own.
    fn speed(&mut self, expr: &Expr) -> Result<(f64, f64), Fault> {
        if let ExprKind::Name(name, spelt) = &expr.kind
            && self.visible(name, spelt).is_none()
            && crate::predefined::constant(&self.types, name).is_none()
        {
            self.tell("controller", format!("speed {spelt} is declared nowhere"));
            let v = name.strip_prefix('v').and_then(|v| v.parse().ok()).unwrap_or(100.0);
            return Ok((v, 500.0));
        }
        let ty = self.types.speeddata.clone();
        let numbers = self.eval_as(expr, &ty)?.numbers();
        Ok((numbers.first().copied().unwrap_or(100.0), numbers.get(1).copied().unwrap_or(500.0)))
    }

    /// Tool and work object as values; both must be persistent data.
    fn tool_and_object(&mut self, tool: &Expr, wobj: Option<&Expr>) -> Result<(Value, Value), Fault> {
        let tool = self.frame_data(tool, "tool0")?;
        let wobj = match wobj {
            Some(e) => self.frame_data(e, "wobj0")?,
            None => self.plain("wobj0"),
        };
        Ok((tool, wobj))
    }

    fn plain(&self, name: &str) -> Value {
        crate::predefined::constant(&self.types, name).unwrap_or(Value::Num(0.0))
    }

    fn frame_data(&mut self, expr: &Expr, plain: &str) -> Result<Value, Fault> {
        let ty = match plain {
            "tool0" => self.types.tooldata.clone(),
            _ => self.types.wobjdata.clone(),
        };
        if let ExprKind::Name(name, spelt) = &expr.kind
            && self.visible(name, spelt).is_none()
            && crate::predefined::constant(&self.types, name).is_none()
        {
            self.tell("controller", format!("{spelt} is declared nowhere; taken as {plain}"));
            return Ok(self.plain(plain));
        }
        let value = self.eval_as(expr, &ty)?;
        if let Some((place, _)) = self.place(expr)?
            && self.access(&place) != crate::place::Access::Persistent
            && matches!(place.root, crate::place::Root::Data(_))
        {
            return fatal("a tool or work object must be PERS");
        }
        Ok(value)
    }

    /// Who holds what for a tool and a work object argument.
    pub(super) fn setup_of(&mut self, tool: &Expr, wobj: Option<&Expr>) -> Result<Setup, Fault> {
        let (tool, wobj) = self.tool_and_object(tool, wobj)?;
        setup(&tool, &wobj, self.gripped)
    }
}

fn setup(tool: &Value, wobj: &Value, gripped: Payload) -> Result<Setup, Fault> {
    let object = wobj.numbers();
    let held = tool.numbers();
    let mut setup = Setup {
        payload: payload(held.get(7..11).unwrap_or_default()),
        tool_held: tool.parts().first().and_then(Value::boolean).unwrap_or(true),
        frame_from_tcp: frame::isometry_of(&held)?,
        frame_from_object: frame::isometry_of(&object)?
            * frame::isometry_of(object.get(7..14).unwrap_or_default())?,
    };
    if setup.tool_held {
        setup.payload = both(setup.payload, gripped, &setup.frame_from_tcp);
    }
    Ok(setup)
}

/// A tool of a gram, as tool0, or less is none.
const NO_LOAD_KG: f64 = 0.001_001;

/// A tool's own load with what is gripped, whose centre stands in the tool's frame.
fn both(own: Payload, gripped: Payload, flange_from_tcp: &Isometry3<f64>) -> Payload {
    if gripped.mass_kg <= 0.0 {
        return own;
    }
    let at_m = (flange_from_tcp * Point3::from(gripped.cog_m)).coords;
    let mass_kg = own.mass_kg + gripped.mass_kg;
    let cog_m = (Vector3::from(own.cog_m) * own.mass_kg + at_m * gripped.mass_kg) / mass_kg;
    Payload { mass_kg, cog_m: cog_m.into() }
}

/// Load data's mass and centre of gravity.
pub(super) fn payload(load: &[f64]) -> Payload {
    match *load {
        [mass_kg, x, y, z] if mass_kg > NO_LOAD_KG => Payload { mass_kg, cog_m: [x, y, z].map(m_from_mm) },
        _ => Payload::default(),
    }
}

//! The arm as the controller knows it: nominal kinematics, where it stands, and every move it made.
//!
//! Knows nothing of deformation: where the TCP really is, is found from the joints of the moves (`truth`).

use super::frame::{self, Setup};
use super::outcome::{Fault, SourceLine, raise};
use super::path::PathKind;
use super::value::{Type, Value};
use nalgebra::Isometry3;
use robot_model::deform::Conditions;
use robot_model::kinematics::{Chain, ClosedForm};
use robot_model::robot::Robot;
use robot_model::units::{deg_from_rad, rad_from_deg};
use std::collections::HashMap;

mod solving;

pub(super) use solving::SolvedMove;
use solving::configuration;

/// Numbers from here on mean "not used" in RAPID (9E9).
const NOT_USED: f64 = 8.9e9;
/// Joints that turn by less have not moved, radians: what targets are rounded to moves those that stand still by up to 1e-6.
const MIN_MOTION_RAD: f64 = 1e-5;

/// A move that was executed.
#[derive(Clone, Debug)]
pub struct Move {
    /// Where in the program.
    pub at: SourceLine,
    /// Where the statement begins in its file, bytes.
    pub offset: u32,
    /// The routine it stands in; for a module that the program loaded itself, the one that called it.
    pub routine: String,
    /// The instruction, lower case.
    pub instruction: String,
    /// The target as written.
    pub target: String,
    /// How the TCP goes.
    pub path: PathKind,
    /// Tool and work object.
    pub setup: Setup,
    /// Joints before it, radians, where they are known.
    pub start_q_rad: Option<[f64; 6]>,
    /// Joints at the circle point of an arc, radians.
    pub via_q_rad: Option<[f64; 6]>,
    /// Joints shortly before the end of a line or an arc, radians.
    pub before_end_q_rad: Option<[f64; 6]>,
    /// Joints at its end, radians; `None` where the controller could not go there.
    pub q_rad: Option<[f64; 6]>,
    /// The steady clock at its beginning, seconds.
    pub began_s: f64,
    /// The steady clock at its end, seconds.
    pub steady_s: f64,
    /// Sign of each joint's last motion up to its end; 0 = not known.
    pub direction: [i8; 6],
    /// The same up to its circle point.
    pub via_direction: [i8; 6],
}

impl Move {
    /// Load and direction at its end.
    #[must_use]
    pub fn conditions(&self) -> Conditions {
        Conditions { payload: self.setup.payload, direction: self.direction }
    }

    /// Load and direction at its circle point.
    #[must_use]
    pub fn via_conditions(&self) -> Conditions {
        Conditions { payload: self.setup.payload, direction: self.via_direction }
    }
}

/// Joints turn round on a line or an arc where they turn by more than this over its last part, or from or to its circle point, radians: those
/// that stand still at both ends are moved a little in between.
const MIN_LAST_RAD: f64 = 2e-4;

/// The sign of each joint's last motion after it went on from one place to another, radians; less than `min_rad` is none.
fn turned(mut direction: [i8; 6], from: Option<[f64; 6]>, to: &[f64; 6], min_rad: f64) -> [i8; 6] {
    for (sign, (to, from)) in direction.iter_mut().zip(to.iter().zip(from.unwrap_or(*to))) {
        if (to - from).abs() > min_rad {
            *sign = if *to > from { 1 } else { -1 };
        }
    }
    direction
}

/// How much slower than written the arm moves.
#[derive(Clone, Copy, Debug)]
pub(super) struct SpeedOverride {
    /// What VelSet says, and what SpeedRefresh does, each above 0 and up to 1.
    pub of_program: f64,
    pub of_operator: f64,
    /// Fastest speed of the TCP, mm/s.
    pub max_mm_s: f64,
}

impl SpeedOverride {
    /// Share of the written speed.
    pub(super) fn share(&self) -> f64 {
        self.of_program * self.of_operator
    }
}

impl Default for SpeedOverride {
    fn default() -> Self {
        Self { of_program: 1.0, of_operator: 1.0, max_mm_s: f64::INFINITY }
    }
}

/// The arm of a controller.
#[derive(Debug)]
pub struct ControllerArm {
    robot: Robot,
    closed: ClosedForm,
    chain: Chain,
    q_rad: Option<[f64; 6]>,
    pub(super) conf_l: bool,
    pub(super) conf_j: bool,
    pub(super) speed: SpeedOverride,
    pub(super) displacement: Isometry3<f64>,
    /// Offsets of the external axes, mm or degrees: shown, but no axis of this arm.
    pub(super) axis_offsets: [f64; 6],
    last: Option<(Setup, Value, Value)>,
    moves: Vec<Move>,
    direction: [i8; 6],
    cache: HashMap<Vec<u64>, SolvedMove>,
}

impl ControllerArm {
    pub(super) fn new(robot: &Robot) -> Result<Self, String> {
        let closed = ClosedForm::new(robot).map_err(|e| e.to_string())?;
        Ok(Self {
            robot: robot.clone(),
            closed,
            chain: Chain::nominal(robot),
            q_rad: None,
            conf_l: true,
            conf_j: true,
            speed: SpeedOverride::default(),
            displacement: Isometry3::identity(),
            axis_offsets: [0.0; 6],
            last: None,
            moves: Vec::new(),
            direction: [0; 6],
            cache: HashMap::new(),
        })
    }

    /// What PP to main resets.
    pub(super) fn restart(&mut self) {
        self.conf_l = true;
        self.conf_j = true;
        self.speed = SpeedOverride::default();
        self.displacement = Isometry3::identity();
        self.axis_offsets = [0.0; 6];
    }

    /// The joints it stands at, radians, once it has moved.
    #[must_use]
    pub fn q_rad(&self) -> Option<[f64; 6]> {
        self.q_rad
    }

    /// Lets the arm stand somewhere before its first move; joints in radians.
    pub fn stand_at(&mut self, q_rad: [f64; 6]) {
        self.q_rad = Some(q_rad);
    }

    /// The moves since they were last taken.
    pub(super) fn moves(&self) -> &[Move] {
        &self.moves
    }

    /// The moves since the last time this was asked for.
    pub fn take_moves(&mut self) -> Vec<Move> {
        std::mem::take(&mut self.moves)
    }

    pub(super) fn record(&mut self, mut done: Move, tool: Value, wobj: Value) {
        if let Some(q) = done.q_rad {
            if let Some(via) = done.via_q_rad {
                self.direction = turned(self.direction, self.q_rad, &via, MIN_LAST_RAD);
                done.via_direction = self.direction;
            }
            let min_rad = if done.via_q_rad.is_some() { MIN_LAST_RAD } else { MIN_MOTION_RAD };
            self.direction = turned(self.direction, done.via_q_rad.or(self.q_rad), &q, min_rad);
            self.direction = turned(self.direction, done.before_end_q_rad, &q, MIN_LAST_RAD);
            self.q_rad = Some(q);
        }
        done.direction = self.direction;
        self.last = Some((done.setup.clone(), tool, wobj));
        self.moves.push(done);
    }

    pub(super) fn last_setup(&self) -> Setup {
        self.last.as_ref().map_or_else(Setup::plain, |l| l.0.clone())
    }

    /// The tool of the last move, as its data stood.
    pub(super) fn last_tool(&self) -> Option<Value> {
        self.last.as_ref().map(|(_, tool, _)| tool.clone())
    }

    /// The work object of the last move, as its data stood.
    pub(super) fn last_object(&self) -> Option<Value> {
        self.last.as_ref().map(|(_, _, object)| object.clone())
    }

    /// The present joints as the numbers of a jointtarget.
    pub(super) fn present_joints(&self) -> Vec<f64> {
        let mut numbers: Vec<f64> = self.q_rad.unwrap_or_default().iter().map(|&q| deg_from_rad(q)).collect();
        numbers.extend([9e9; 6]);
        numbers
    }

    fn forward(&self, q_rad: &[f64; 6]) -> Isometry3<f64> {
        self.chain.forward(q_rad)
    }

    /// Where the TCP stands in the object, whatever displacement is on; metres.
    pub(super) fn object_from_tcp(&self, setup: &Setup) -> Isometry3<f64> {
        setup.object_from_tcp(&self.forward(&self.q_rad.unwrap_or_default()))
    }

    /// CalcRobT: the numbers of a jointtarget as robtarget.
    pub(super) fn robtarget_of(&self, joints: &[f64], setup: &Setup, ty: &Type) -> Result<Value, Fault> {
        let q_rad = self.joints_rad(joints);
        let pose = self.displacement.inverse() * setup.object_from_tcp(&self.forward(&q_rad));
        let c = self.closed.configuration(&q_rad);
        let mut numbers = frame::pose_numbers(&pose).to_vec();
        numbers.extend([c.cf1, c.cf4, c.cf6, c.cfx].map(f64::from));
        numbers.extend(joints.iter().skip(6));
        Ok(frame::value(ty, &numbers))
    }

    /// CalcJointT: joints of a robtarget, by confdata.
    pub(super) fn joints_of(&self, target: &[f64], setup: &Setup) -> Result<[f64; 6], Fault> {
        let base_from_flange = setup.base_from_flange(&(self.displacement * frame::isometry_of(target)?));
        let solutions = self.closed.solutions(&base_from_flange);
        let conf = configuration(target);
        let found = solutions.iter().find(|s| self.closed.agrees(&conf, &s.q_rad));
        match found {
            Some(s) => Ok(s.q_rad),
            None if solutions.is_empty() && self.is_reachable(&base_from_flange) => {
                raise("err_roblimit", "a joint outside its range")
            }
            None if solutions.is_empty() => raise("err_outside_reach", "the pose cannot be reached"),
            None => raise("err_roblimit", "the pose cannot be reached with this configuration"),
        }
    }

    /// Joints in radians of a jointtarget's numbers; an axis written 9E9 stays where it is.
    fn joints_rad(&self, numbers: &[f64]) -> [f64; 6] {
        let here = self.q_rad.unwrap_or_default();
        std::array::from_fn(|i| match numbers.get(i) {
            Some(&deg) if deg.abs() < NOT_USED => rad_from_deg(deg),
            _ => here[i],
        })
    }
}

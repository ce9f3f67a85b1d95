//! Plans for programs built by hand; expected values come from the paper, closed form or hand arithmetic.

mod branches;
mod cube;
mod hints;
mod pages;

use super::*;
use nalgebra::{Isometry3, Quaternion, Translation3, UnitQuaternion};
use plan::{PathDeviation, Plan, Status};
use rapid_program::Program;
use rapid_program::data::{ConfData, JointTarget, RobTarget, SpeedData, ToolData, WobjData, ZoneData};
use rapid_program::motion::{
    Motion, MotionId, MotionSetup, Origin, Path, RoutineId, RoutineInfo, Target, TargetValue,
};
use rapid_syntax::diagnostic::{FileId, Severity, TextRange};
use robot_model::deform::Deformation;
use robot_model::robot::Robot;
use robot_model::units::{m_from_mm, rad_from_deg};
use std::sync::Arc;

const NO_EXT: [Option<f64>; 6] = [None; 6];
/// Joints of the cube's approach as RoboDK writes them, degrees.
const APPROACH_DEG: [f64; 6] = [41.845157, 44.625236, 25.881200, 43.530476, -75.605869, -13.287258];

fn irb140() -> Robot {
    Robot::built_in("irb140").unwrap()
}

fn joints(q_deg: [f64; 6]) -> TargetValue {
    TargetValue::Joint(JointTarget { q_rad: q_deg.map(|q| Some(rad_from_deg(q))), ext: NO_EXT })
}

/// A robtarget with RAPID's numbers: mm, quaternion w first.
fn pose(position_mm: [f64; 3], wxyz: [f64; 4], conf: [i32; 4]) -> TargetValue {
    let [x, y, z] = position_mm.map(m_from_mm);
    let [w, i, j, k] = wxyz;
    let rotation = UnitQuaternion::from_quaternion(Quaternion::new(w, i, j, k));
    let [cf1, cf4, cf6, cfx] = conf;
    TargetValue::Rob(RobTarget {
        object_from_tcp: Isometry3::from_parts(Translation3::new(x, y, z), rotation),
        conf: ConfData { cf1, cf4, cf6, cfx },
        ext: NO_EXT,
    })
}

fn motion(path: Path, values: &[TargetValue]) -> Motion {
    let kind = match path {
        Path::Linear => "MoveL",
        Path::Joint => "MoveJ",
        Path::Circular => "MoveC",
        Path::AbsJoint => "MoveAbsJ",
    };
    let target = |value: &TargetValue| Target::new(TextRange::new(0, 0), Origin::Inline).with_value(value);
    let setup = MotionSetup {
        routine: RoutineId(0),
        loops: vec![],
        kind: kind.into(),
        path,
        tool_name: Some("tool0".into()),
        tool: Some(ToolData::tool0()),
        wobj_name: None,
        wobj: Some(WobjData::wobj0()),
        later_frames: vec![],
        tool_argument: None,
        wobj_argument: None,
        speed: Some(SpeedData { v_tcp_m_s: 0.25, v_ori_rad_s: rad_from_deg(500.0) }),
        zone: Some(ZoneData { finep: false, pzone_tcp_m: 0.001 }),
        time_s: None,
        conf_monitored: Some(false),
        grip: None,
        has_total_load: false,
        uneven_turn: None,
    };
    Motion {
        file: FileId(0),
        line: 0,
        range: TextRange::new(0, 0),
        setup: Arc::new(setup),
        targets: values.iter().map(target).collect(),
        previous: None,
        from_start: false,
        skip_reason: None,
        run_time: false,
        from_search: false,
    }
}

/// A program of one routine whose motions follow each other.
fn program(motions: Vec<Motion>) -> Program {
    let routine = RoutineInfo {
        file: FileId(0),
        module: "MOD".to_owned(),
        name: "main".to_owned(),
        range: TextRange::new(0, 0),
    };
    let mut program = Program { routines: vec![routine], motions, ..Program::default() };
    for (i, motion) in program.motions.iter_mut().enumerate() {
        motion.line = i as u32 + 1;
        motion.range = TextRange::new(10 * i as u32, 10 * i as u32 + 9);
        motion.previous = i.checked_sub(1).map(MotionId::new);
        motion.from_start = i == 0;
    }
    program
}

/// The cube of 45 as RoboDK exports it: a joint move to the first target, then 45 linear moves.
fn cube45(configured: bool) -> Program {
    let mut motions = vec![motion(Path::AbsJoint, &[joints(APPROACH_DEG)])];
    let table = include_str!("../../../../../fixtures/paper/targets45.csv");
    for line in table.lines().skip(1) {
        let numbers: Vec<f64> = line.split(',').skip(1).map(|n| n.trim().parse().unwrap()).collect();
        let y = numbers[1];
        // RoboDK's numbers: cf1 and cf4 follow the sign of y, cf6 the other one; joint 5 is negative.
        let conf = match y {
            _ if !configured => [0, 0, 0, 0],
            y if y > 0.0 => [0, 0, -1, 1],
            y if y < 0.0 => [-1, -1, 0, 1],
            _ => [0, 0, 0, 1],
        };
        let wxyz = ["0.70710678", "0.00000000", "0.70710678", "0.00000001"].map(|w| w.parse().unwrap());
        motions.push(motion(Path::Linear, &[pose([numbers[0], y, numbers[2]], wxyz, conf)]));
    }
    program(motions)
}

fn codes(plan: &Plan) -> Vec<(&'static str, Severity)> {
    plan.diagnostics.iter().map(|d| (d.code, d.severity)).collect()
}

fn skip_code(status: &Status) -> &'static str {
    match status {
        Status::Kept(why) => why.code,
        Status::Compensated => "compensated",
        Status::Refused(_) => "refused",
    }
}

//! Kinematics on request: it calculates, nothing moves. Metres and radians.

use crate::Personality;
use crate::arm::{Frame, Quadrants, Solver};
use crate::controller::Controller;
use crate::http::{Incoming, Reply};
use crate::page::{self, MediaType, entry};
use crate::rapid::{elements, number};
use crate::resources::{NOT_KNOWN, Rejection, known_unit};

/// What a request asks the kinematics for.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Calculation {
    Forward,
    Inverse,
    All,
}

const INVALID: Rejection = (400, -1_073_445_879, "invalid argument");

pub(crate) fn calculate(
    c: &Controller,
    solver: &Solver,
    request: &Incoming,
    media: MediaType,
) -> Result<Reply, Rejection> {
    let parts = request.parts();
    let (unit, wanted) = asked(c, request, &parts)?;
    if !c.offers_kinematics {
        return Err((400, -1_073_435_901, "option missing"));
    }
    known_unit(unit)?;
    let list = |name: &str| -> Result<Vec<f64>, Rejection> {
        let text = request.field(name).ok_or(INVALID)?;
        elements(&text).ok_or(INVALID)?.iter().map(|x| x.parse().map_err(|_| INVALID)).collect()
    };
    let fixed = |name: &str| {
        request.field(name).filter(|v| ["TRUE", "FALSE"].contains(&v.as_str())).map(drop).ok_or(INVALID)
    };
    let frame = |position: &str, orientation: &str| -> Result<Frame, Rejection> {
        let (p, q) = (array(list(position)?)?, array::<4>(list(orientation)?)?);
        let norm = q.iter().map(|x| x * x).sum::<f64>().sqrt();
        if (norm - 1.0).abs() > 1e-3 { Err(INVALID) } else { Ok((p, q)) }
    };
    let tool = frame("tool_frame_position", "tool_frame_orientation")?;
    fixed("robot_fixed_object")?;
    if wanted == Calculation::Forward {
        let joints: [f64; 6] = array(list("rob_joints")?)?;
        array::<6>(list("ext_joints")?)?;
        fixed("elog_at_error")?;
        return Ok(page::page(media, &[pose(solver.forward(&joints, tool))], page::OK, None));
    }
    let at = frame("curr_position", "curr_orientation")?;
    array::<6>(list("curr_ext_joints")?)?;
    let wanted_quadrants = array::<4>(list("robot_configuration")?)?.map(|x| x as i32);
    if wanted == Calculation::All {
        let all: Vec<_> = solver.all(at, tool).iter().map(|q| joints("all-joint-solutions", q)).collect();
        return if all.is_empty() {
            Err((400, -1_073_436_654, "out of reach"))
        } else {
            Ok(page::page(media, &all, page::OK, None))
        };
    }
    array::<6>(list("old_rob_joints")?)?;
    array::<6>(list("old_ext_joints")?)?;
    fixed("elog_at_error")?;
    let q = solver.inverse(at, tool, wanted_quadrants).map_err(|is_reached_otherwise| {
        if is_reached_otherwise {
            (400, -1_073_436_653, "configuration impossible")
        } else {
            (400, -1_073_436_654, "out of reach")
        }
    })?;
    Ok(page::page(media, &[joints("joints-from-cartesian", &q)], page::OK, None))
}

/// The mechanical unit that a request names, and what is to be calculated for it.
fn asked<'r>(
    c: &Controller,
    request: &'r Incoming,
    parts: &[&'r str],
) -> Result<(&'r str, Calculation), Rejection> {
    let (unit, action) = match (c.personality, parts) {
        (Personality::Rw6, ["rw", "motionsystem", "mechunits", unit]) => {
            (*unit, request.query("action").unwrap_or_default())
        }
        (Personality::Rw7 | Personality::Rw8, ["rw", "motionsystem", "mechunits", unit, action]) => {
            (*unit, *action)
        }
        _ => return Err(NOT_KNOWN),
    };
    let wanted = match action {
        "CalcPoseFromJoints" | "pose-from-joints" => Calculation::Forward,
        "JointsFromCartesian" | "joints-from-cartesian" => Calculation::Inverse,
        "AllJointSolutions" | "all-joints-solution" => Calculation::All,
        _ => return Err(NOT_KNOWN),
    };
    Ok((unit, wanted))
}

fn array<const N: usize>(list: Vec<f64>) -> Result<[f64; N], Rejection> {
    list.try_into().map_err(|_| INVALID)
}

fn pose(((p, q), quadrants): (Frame, Quadrants)) -> page::Entry {
    let texts: Vec<String> =
        p.iter().chain(&q).map(|x| number(*x)).chain(quadrants.iter().map(i32::to_string)).collect();
    let names = [
        "position-x",
        "position-y",
        "position-z",
        "robtargetorientation-u0",
        "robtargetorientation-u1",
        "robtargetorientation-u2",
        "robtargetorientation-u3",
        "quarter-rev-j1",
        "quarter-rev-j4",
        "quarter-rev-j6",
        "quarter-rev-jx",
    ];
    let fields: Vec<(&'static str, &str)> = names.into_iter().zip(texts.iter().map(String::as_str)).collect();
    entry("position-from-joint", "pose", &fields)
}

fn joints(class: &'static str, q: &[f64; 6]) -> page::Entry {
    let texts = q.map(number);
    let names = ["robotjoint1", "robotjoint2", "robotjoint3", "robotjoint4", "robotjoint5", "robotjoint6"];
    let fields: Vec<(&'static str, &str)> = names.into_iter().zip(texts.iter().map(String::as_str)).collect();
    entry(class, "joints", &fields)
}

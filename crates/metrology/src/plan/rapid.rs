//! A plan as a RAPID module: drives to each pose from its planned side, stops, and goes on when the point is taken.

use super::{MeasurementPlan, MeasurementStep};
use rapid_syntax::{num, write_list};
use robot_model::robot::{Joints, Robot};
use robot_model::units::deg_from_rad;
use std::fmt::Write as _;

const NO_AXES: &str = "[9E9,9E9,9E9,9E9,9E9,9E9]";

/// The text of the RAPID module of that name.
#[must_use]
pub fn rapid(plan: &MeasurementPlan, robot: &Robot, module: &str) -> String {
    let Run { data, moves } = Run::of(plan);
    format!(
        "MODULE {module}\n\
         \x20 ! Measurement run for {}: {} rows, planned by driftpost {}.\n\
         \x20 ! Nothing here knows your cell: run it slowly without the reflector first.\n\
         \x20 ! Row numbers are the ids of the sheet to fill in. Each pose is come to from its own side.\n\
         \x20 ! FALSE: do not stop at each row, wait dpWait seconds instead.\n\
         \x20 LOCAL PERS bool dpStop:=TRUE;\n\
         \x20 LOCAL PERS num dpWait:=3;\n\
         \x20 LOCAL CONST speeddata dpFast:=[200,30,200,30];\n\
         \x20 LOCAL CONST speeddata dpSlow:=[50,10,50,10];\n\
         {data}\n\
         \x20 PROC dpMeasure()\n{moves}\x20   TPWrite \"all rows are measured\";\n\x20 ENDPROC\n\n\
         \x20 LOCAL PROC dpTake(num row)\n\
         \x20   WaitTime\\InPos,dpWait;\n\
         \x20   TPWrite \"measure row \"\\Num:=row;\n\
         \x20   IF dpStop Stop;\n\
         \x20 ENDPROC\n\n\
         \x20 LOCAL PROC dpNest(num row,num nest)\n\
         \x20   TPWrite \"row \"\\Num:=row;\n\
         \x20   TPWrite \"measure nest \"\\Num:=nest;\n\
         \x20   Stop;\n\
         \x20 ENDPROC\n\n\
         \x20 LOCAL PROC dpPayload(num kg)\n\
         \x20   TPWrite \"mount this payload, kg: \"\\Num:=kg;\n\
         \x20   Stop;\n\
         \x20 ENDPROC\nENDMODULE\n",
        ascii(&robot.name),
        plan.steps.len(),
        env!("CARGO_PKG_VERSION"),
    )
}

/// What of the module differs from plan to plan.
struct Run {
    /// Declarations of poses and payloads.
    data: String,
    /// The statements that drive to the poses.
    moves: String,
}

impl Run {
    fn of(plan: &MeasurementPlan) -> Self {
        let mut data = String::new();
        let mut moves = String::new();
        let mut loads: Vec<f64> = Vec::new();
        let mut load = None;
        let mut known = std::collections::BTreeSet::new();
        for (k, step) in plan.steps.iter().enumerate() {
            let row = k + 1;
            let MeasurementStep::Pose { pose, q_rad, approach_rad, payload_kg, .. } = step else {
                if let MeasurementStep::Nest { nest } = step {
                    let _ = writeln!(moves, "    dpNest {row},{};", nest + 1); // a String takes everything
                }
                continue;
            };
            if load != Some(*payload_kg) {
                load = Some(*payload_kg);
                let name = if *payload_kg > 0.0 {
                    let which = loads.iter().position(|l| l == payload_kg).unwrap_or_else(|| {
                        loads.push(*payload_kg);
                        loads.len() - 1
                    });
                    format!("dpLoad{}", which + 1)
                } else {
                    "load0".to_owned()
                };
                let _ = writeln!(moves, "    dpPayload {};\n    GripLoad {name};", num(*payload_kg));
            }
            if known.insert(*pose) {
                for (name, q) in [("dpA", approach_rad), ("dpP", q_rad)] {
                    let _ = writeln!(
                        data,
                        "  LOCAL CONST jointtarget {name}{}:=[{},{NO_AXES}];",
                        pose + 1,
                        joints(q)
                    );
                }
            }
            let _ = writeln!(moves, "    MoveAbsJ dpA{}\\NoEOffs,dpFast,fine,tool0;", pose + 1);
            let _ = writeln!(moves, "    MoveAbsJ dpP{}\\NoEOffs,dpSlow,fine,tool0;", pose + 1);
            let _ = writeln!(moves, "    dpTake {row};");
        }
        for (k, kg) in loads.iter().enumerate() {
            let _ = writeln!(
                data,
                "  ! Put in this payload's real centre of gravity.\n  LOCAL PERS loaddata dpLoad{}:=[{},[0,0,50],[1,0,0,0],0,0,0];",
                k + 1,
                num(*kg)
            );
        }
        Self { data, moves }
    }
}

fn ascii(text: &str) -> String {
    text.chars().map(|c| if c.is_ascii_graphic() || c == ' ' { c } else { '?' }).collect()
}

/// With the four decimals of the sheet: what is written there is what is driven.
fn joints(q_rad: &Joints) -> String {
    let mut out = Vec::new();
    let six: [f64; 6] = std::array::from_fn(|j| q_rad.get(j).copied().unwrap_or(0.0));
    write_list(&mut out, six.map(|q| (deg_from_rad(q) * 1e4).round() / 1e4));
    String::from_utf8_lossy(&out).into_owned()
}

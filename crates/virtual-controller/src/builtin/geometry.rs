//! Poses, orientations, targets and where the robot is.

use super::parameter::{Function, JointTarget, Parameter, RobTarget, Unevaluated, function};
use super::tools::setup_of;
use crate::arm::ControllerArm;
use crate::frame;
use crate::interpreter::{Args, Interpreter};
use crate::outcome::{Fault, fatal, raise};
use crate::predefined;
use crate::value::Value;
use nalgebra::{Isometry3, Point3, Translation3, UnitQuaternion, Vector3};
use robot_model::units::{deg_from_rad, m_from_mm, mm_from_m, rad_from_deg};

pub(super) const FUNCTIONS: &[Function] = &[
    function!("offs", Arithmetic, (target: RobTarget, x: f32, y: f32, z: f32), |vm, args| {
        let mut numbers = target.0;
        for (n, offset) in numbers.iter_mut().zip([x, y, z]) {
            *n = f64::from(*n as f32 + offset);
        }
        Ok(frame::value(&vm.program.types.robtarget, &numbers))
    }),
    function!("orobt", Arithmetic, (target: RobTarget), |vm, args| {
        if args.has("inpdisp") {
            return Ok(frame::value(&vm.program.types.robtarget, &target.0));
        }
        let mut numbers = target.0;
        let displaced = arm(vm)?.displacement * frame::isometry_of(&numbers)?;
        for (n, x) in numbers.iter_mut().zip(frame::pose_numbers(&displaced)) {
            *n = x;
        }
        Ok(frame::value(&vm.program.types.robtarget, &numbers))
    }),
    function!("reltool", Arithmetic, (target: RobTarget, dx: f32, dy: f32, dz: f32), |vm, args| {
        let displacement_m = Vector3::from([dx, dy, dz].map(|mm| m_from_mm(f64::from(mm))));
        in_tool(vm, args, target, displacement_m)
    }),
    function!("posemult", Arithmetic, (a: Isometry3<f64>, b: Isometry3<f64>), |vm, args| {
        Ok(pose(vm, &(a * b)))
    }),
    function!("poseinv", Arithmetic, (a: Isometry3<f64>), |vm, args| Ok(pose(vm, &a.inverse()))),
    function!("posevect", Arithmetic, (a: Isometry3<f64>, v: Vector3<f64>), |vm, args| {
        let p = a * Point3::from(v);
        Ok(frame::value(&vm.program.types.pos, &[mm_from_m(p.x), mm_from_m(p.y), mm_from_m(p.z)]))
    }),
    function!("orientzyx", Arithmetic, (z: f32, y: f32, x: f32), |vm, args| {
        let [z, y, x] = [z, y, x].map(|deg| rad_from_deg(f64::from(deg)));
        Ok(orient(vm, &UnitQuaternion::from_euler_angles(x, y, z)))
    }),
    function!("eulerzyx", Arithmetic, (rotation: UnitQuaternion<f64>), |vm, args| {
        let (x, y, z) = rotation.euler_angles();
        match (args.has("x"), args.has("y"), args.has("z")) {
            (true, _, _) => Ok(Value::num(deg_from_rad(x))),
            (_, true, _) => Ok(Value::num(deg_from_rad(y))),
            (_, _, true) => Ok(Value::num(deg_from_rad(z))),
            _ => fatal("EulerZYX without \\X, \\Y or \\Z"),
        }
    }),
    function!("norient", Arithmetic, (rotation: UnitQuaternion<f64>), |vm, args| Ok(orient(vm, &rotation))),
    function!("distance", Arithmetic, (a: Vector3<f64>, b: Vector3<f64>), |vm, args| {
        Ok(Value::num(mm_from_m((a - b).norm())))
    }),
    function!("vectmagn", Arithmetic, (a: Vector3<f64>), |vm, args| Ok(Value::num(mm_from_m(a.norm())))),
    function!("dotprod", Arithmetic, (a: Vector3<f64>, b: Vector3<f64>), |vm, args| {
        Ok(Value::num(mm_from_m(mm_from_m(a.dot(&b)))))
    }),
    function!("calcrobt", Arithmetic, (joints: JointTarget, tool: Unevaluated), |vm, args| {
        let setup = setup_of(vm, args.at(1)?, args.named("wobj"))?;
        arm(vm)?.robtarget_of(&joints.0, &setup, &vm.program.types.robtarget)
    }),
    function!("calcjointt", Arithmetic, (target: RobTarget, tool: Unevaluated), |vm, args| {
        let setup = setup_of(vm, args.at(1)?, args.named("wobj"))?;
        let joints = arm(vm)?.joints_of(&target.0, &setup)?;
        let mut numbers: Vec<f64> = joints.iter().map(|&q| deg_from_rad(q)).collect();
        numbers.extend(target.0.iter().skip(11));
        Ok(frame::value(&vm.program.types.jointtarget, &numbers))
    }),
    function!("crobt", Arithmetic, (), |vm, args| present_target(vm, args)),
    function!("cpos", Arithmetic, (), |vm, args| {
        let target = present_target(vm, args)?;
        Ok(target.parts().first().cloned().unwrap_or(target))
    }),
    function!("cjointt", Arithmetic, (), |vm, args| {
        let joints = arm(vm)?.present_joints();
        Ok(frame::value(&vm.program.types.jointtarget, &joints))
    }),
    function!("ctool", Arithmetic, (), |vm, args| {
        Ok(arm(vm)?.last_tool().unwrap_or_else(|| predefined::known(&vm.program.types, "tool0")))
    }),
    function!("cwobj", Arithmetic, (), |vm, args| {
        Ok(arm(vm)?.last_object().unwrap_or_else(|| predefined::known(&vm.program.types, "wobj0")))
    }),
];

fn pose(vm: &Interpreter<'_>, pose: &Isometry3<f64>) -> Value {
    frame::value(&vm.program.types.pose, &frame::pose_numbers(pose))
}

fn orient(vm: &Interpreter<'_>, q: &UnitQuaternion<f64>) -> Value {
    frame::value(&vm.program.types.orient, &[q.w, q.i, q.j, q.k])
}

/// The angle of an option in radians, 0 where it is left out.
fn option_rad(vm: &mut Interpreter<'_>, args: &Args<'_>, name: &str) -> Result<f64, Fault> {
    match args.named(name) {
        Some(e) => vm.eval_num(e).map(|deg| rad_from_deg(f64::from(deg))),
        None => Ok(0.0),
    }
}

/// RelTool: a target displaced and turned in its own tool frame.
fn in_tool(
    vm: &mut Interpreter<'_>,
    args: &Args<'_>,
    target: RobTarget,
    displacement_m: Vector3<f64>,
) -> Result<Value, Fault> {
    let mut numbers = target.0;
    let object_from_tcp = frame::isometry_of(&numbers)?;
    let rx = option_rad(vm, args, "rx")?;
    let ry = option_rad(vm, args, "ry")?;
    let rz = option_rad(vm, args, "rz")?;
    // About x first, then about the new y, then about the new z.
    let turn = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), rx)
        * UnitQuaternion::from_axis_angle(&Vector3::y_axis(), ry)
        * UnitQuaternion::from_axis_angle(&Vector3::z_axis(), rz);
    let moved = object_from_tcp * Isometry3::from_parts(Translation3::from(displacement_m), turn);
    for (n, x) in numbers.iter_mut().zip(frame::pose_numbers(&moved)) {
        *n = x;
    }
    Ok(frame::value(&vm.program.types.robtarget, &numbers))
}

/// Where the arm stands, by the tool given or that of the last move.
fn present_target(vm: &mut Interpreter<'_>, args: &Args<'_>) -> Result<Value, Fault> {
    let setup = match args.named("tool") {
        Some(tool) => setup_of(vm, tool, args.named("wobj"))?,
        None => arm(vm)?.last_setup(),
    };
    let arm = arm(vm)?;
    arm.robtarget_of(&arm.present_joints(), &setup, &vm.program.types.robtarget)
}

fn arm<'v>(vm: &'v Interpreter<'_>) -> Result<&'v ControllerArm, Fault> {
    match vm.arm.as_deref() {
        Some(arm) => Ok(arm),
        None => raise("err_norununit", "this controller has no arm"),
    }
}

//! Poses, orientations, targets and where the robot is.

use super::Known;
use crate::call::Args;
use crate::controller::Controller;
use crate::frame;
use crate::ir::Expr;
use crate::outcome::{Fault, fatal, raise};
use crate::value::{Type, Value};
use nalgebra::{Isometry3, Translation3, UnitQuaternion, Vector3};
use robot_model::units::{deg_from_rad, m_from_mm, mm_from_m, rad_from_deg};

impl Controller {
    fn typed(&mut self, expr: &Expr, ty: &Type) -> Result<Value, Fault> {
        self.eval_as(expr, ty)
    }

    fn pose(&mut self, expr: &Expr) -> Result<Isometry3<f64>, Fault> {
        let ty = self.types.pose.clone();
        frame::isometry(&self.typed(expr, &ty)?)
    }

    fn vector(&mut self, expr: &Expr) -> Result<Vector3<f64>, Fault> {
        let ty = self.types.pos.clone();
        let n = self.typed(expr, &ty)?.numbers();
        Ok(Vector3::new(m_from_mm(n[0]), m_from_mm(n[1]), m_from_mm(n[2])))
    }

    fn orientation(&mut self, expr: &Expr) -> Result<UnitQuaternion<f64>, Fault> {
        let ty = self.types.orient.clone();
        frame::quaternion(&self.typed(expr, &ty)?.numbers())
    }

    fn option_num(&mut self, args: &Args<'_>, name: &str) -> Result<f64, Fault> {
        match args.named(name) {
            Some(e) => self.eval_num(e).map(f64::from),
            None => Ok(0.0),
        }
    }

    fn new_pose(&self, pose: &Isometry3<f64>) -> Value {
        frame::value(&self.types.pose, &frame::pose_numbers(pose))
    }

    #[allow(clippy::too_many_lines)]
    pub(crate) fn geometry_function(&mut self, name: &str, args: &Args<'_>) -> Known<Value> {
        Ok(Some(match name {
            "offs" => {
                let ty = self.types.robtarget.clone();
                let target = self.typed(args.at(0)?, &ty)?;
                let mut numbers: Vec<f32> = target.numbers().iter().map(|&x| x as f32).collect();
                for (i, n) in numbers.iter_mut().take(3).enumerate() {
                    *n += self.eval_num(args.at(i + 1)?)?;
                }
                frame::value(&ty, &numbers.iter().map(|&x| f64::from(x)).collect::<Vec<_>>())
            }
            "reltool" => {
                let ty = self.types.robtarget.clone();
                let mut numbers = self.typed(args.at(0)?, &ty)?.numbers();
                let object_from_tcp = frame::isometry_of(&numbers)?;
                let mut d = Vector3::zeros();
                for i in 0..3 {
                    d[i] = m_from_mm(f64::from(self.eval_num(args.at(i + 1)?)?));
                }
                let [rx, ry, rz] = [
                    self.option_num(args, "rx")?,
                    self.option_num(args, "ry")?,
                    self.option_num(args, "rz")?,
                ]
                .map(rad_from_deg);
                // About x first, then about the new y, then about the new z.
                let turn = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), rx)
                    * UnitQuaternion::from_axis_angle(&Vector3::y_axis(), ry)
                    * UnitQuaternion::from_axis_angle(&Vector3::z_axis(), rz);
                let moved = object_from_tcp * Isometry3::from_parts(Translation3::from(d), turn);
                for (n, x) in numbers.iter_mut().zip(frame::pose_numbers(&moved)) {
                    *n = x;
                }
                frame::value(&ty, &numbers)
            }
            "posemult" => {
                let pose = self.pose(args.at(0)?)? * self.pose(args.at(1)?)?;
                self.new_pose(&pose)
            }
            "poseinv" => {
                let pose = self.pose(args.at(0)?)?.inverse();
                self.new_pose(&pose)
            }
            "posevect" => {
                let p = self.pose(args.at(0)?)? * nalgebra::Point3::from(self.vector(args.at(1)?)?);
                frame::value(&self.types.pos, &[mm_from_m(p.x), mm_from_m(p.y), mm_from_m(p.z)])
            }
            "orientzyx" => {
                let mut a = [0.0; 3];
                for (i, a) in a.iter_mut().enumerate() {
                    *a = rad_from_deg(f64::from(self.eval_num(args.at(i)?)?));
                }
                let q = UnitQuaternion::from_euler_angles(a[2], a[1], a[0]);
                frame::value(&self.types.orient, &[q.w, q.i, q.j, q.k])
            }
            "eulerzyx" => {
                let (x, y, z) = self.orientation(args.at(0)?)?.euler_angles();
                let angle = match (args.has("x"), args.has("y"), args.has("z")) {
                    (true, _, _) => x,
                    (_, true, _) => y,
                    (_, _, true) => z,
                    _ => return fatal("EulerZYX without \\X, \\Y or \\Z"),
                };
                Value::num(deg_from_rad(angle))
            }
            "norient" => {
                let q = self.orientation(args.at(0)?)?;
                frame::value(&self.types.orient, &[q.w, q.i, q.j, q.k])
            }
            "distance" => {
                Value::num(mm_from_m((self.vector(args.at(0)?)? - self.vector(args.at(1)?)?).norm()))
            }
            "vectmagn" => Value::num(mm_from_m(self.vector(args.at(0)?)?.norm())),
            "dotprod" => {
                let (a, b) = (self.vector(args.at(0)?)?, self.vector(args.at(1)?)?);
                Value::num(mm_from_m(mm_from_m(a.dot(&b))))
            }
            "calcrobt" => {
                let ty = self.types.jointtarget.clone();
                let joints = self.typed(args.at(0)?, &ty)?;
                let setup = self.setup_of(args.at(1)?, args.named("wobj"))?;
                self.arm_needed()?.robtarget_of(&joints.numbers(), &setup, &self.types.robtarget)?
            }
            "calcjointt" => {
                let ty = self.types.robtarget.clone();
                let target = self.typed(args.at(0)?, &ty)?;
                let setup = self.setup_of(args.at(1)?, args.named("wobj"))?;
                let joints = self.arm_needed()?.joints_of(&target.numbers(), &setup)?;
                let mut numbers: Vec<f64> = joints.iter().map(|&q| deg_from_rad(q)).collect();
                numbers.extend(target.numbers().iter().skip(11));
                frame::value(&self.types.jointtarget, &numbers)
            }
            "crobt" | "cpos" => {
                let setup = match args.named("tool") {
                    Some(tool) => self.setup_of(tool, args.named("wobj"))?,
                    None => self.arm_needed()?.last_setup(),
                };
                let joints = self.arm_needed()?.present_joints();
                let target = self.arm_needed()?.robtarget_of(&joints, &setup, &self.types.robtarget)?;
                match target.parts().first() {
                    Some(trans) if name == "cpos" => trans.clone(),
                    _ => target,
                }
            }
            "cjointt" => {
                let joints = self.arm_needed()?.present_joints();
                frame::value(&self.types.jointtarget, &joints)
            }
            "ctool" | "cwobj" => {
                let last = self.arm_needed()?.last_data(name == "ctool");
                match last {
                    Some(value) => value,
                    None => self.constant_of(if name == "ctool" { "tool0" } else { "wobj0" }),
                }
            }
            _ => return Ok(None),
        }))
    }

    fn constant_of(&self, name: &str) -> Value {
        crate::predefined::constant(&self.types, name).unwrap_or(Value::Num(0.0))
    }

    fn arm_needed(&self) -> Result<&crate::motion::Arm, Fault> {
        match &self.arm {
            Some(arm) => Ok(arm),
            None => raise("err_norununit", "this controller has no arm"),
        }
    }
}

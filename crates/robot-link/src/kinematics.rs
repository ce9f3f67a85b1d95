//! The controller's own kinematics, without motion: it calculates, the arm stands.

use crate::answer::Entry;
use crate::requests;
use crate::{LinkError, Session, names};

/// A mechanical unit whose kinematics is asked for, `ROB_1`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unit(String);

impl Unit {
    /// By its name.
    ///
    /// # Errors
    /// [`LinkError::Name`].
    pub fn new(name: &str) -> Result<Self, LinkError> {
        Ok(Self(names::rapid(name)?.to_owned()))
    }
}

/// A frame: metres, and a unit quaternion with its real part first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// Origin in the reference frame, metres.
    pub position_m: [f64; 3],
    /// Unit quaternion, real part first.
    pub orientation: [f64; 4],
}

impl Frame {
    /// No tool: the frame of the flange itself.
    pub const IDENTITY: Self = Self { position_m: [0.0; 3], orientation: [1.0, 0.0, 0.0, 0.0] };
}

/// `confdata`: quadrants of axes 1, 4 and 6, and the branch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Configuration(pub [i32; 4]);

/// Where the arm's TCP is for given joints, and in which configuration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArmPose {
    /// Of the TCP in the base frame.
    pub frame: Frame,
    /// As the controller writes it.
    pub configuration: Configuration,
}

/// Joints for a pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solution {
    /// Joint angles of the controller's answer, radians.
    pub q_rad: [f64; 6],
}

/// External axes that there are none of.
const NO_EXTERNAL: &str = "[9E+09,9E+09,9E+09,9E+09,9E+09,9E+09]";

impl Session {
    /// Where the TCP of a tool is at joints `q_rad` (radians).
    ///
    /// # Errors
    /// [`LinkError::NotOffered`] where the controller does not calculate it; a refusal; an incomplete answer.
    pub fn forward(&mut self, unit: &Unit, q_rad: &[f64; 6], tool: &Frame) -> Result<ArmPose, LinkError> {
        let (joints, position, orientation) = (list(q_rad), list(&tool.position_m), list(&tool.orientation));
        let answer = self.calculate(
            requests::FORWARD,
            &[
                ("unit", unit.0.as_str()),
                ("joints", &joints),
                ("external", NO_EXTERNAL),
                ("tool_position", &position),
                ("tool_orientation", &orientation),
            ],
        )?;
        let entry = answer.one("position-from-joint")?;
        let quarter = |field: &str| Ok(entry.number(field)?.round() as i32);
        Ok(ArmPose {
            frame: Frame {
                position_m: numbers(entry, ["position-x", "position-y", "position-z"])?,
                orientation: numbers(
                    entry,
                    [
                        "robtargetorientation-u0",
                        "robtargetorientation-u1",
                        "robtargetorientation-u2",
                        "robtargetorientation-u3",
                    ],
                )?,
            },
            configuration: Configuration([
                quarter("quarter-rev-j1")?,
                quarter("quarter-rev-j4")?,
                quarter("quarter-rev-j6")?,
                quarter("quarter-rev-jx")?,
            ]),
        })
    }

    /// Joints that bring the TCP of a tool to `pose` (in the base frame) in a configuration, coming from `near_rad`.
    ///
    /// # Errors
    /// As [`Session::forward`]; out of reach is a refusal, `link::reach`.
    pub fn inverse(
        &mut self,
        unit: &Unit,
        pose: &Frame,
        configuration: Configuration,
        near_rad: &[f64; 6],
        tool: &Frame,
    ) -> Result<Solution, LinkError> {
        let (position, orientation, near) = (list(&pose.position_m), list(&pose.orientation), list(near_rad));
        let (tool_position, tool_orientation) = (list(&tool.position_m), list(&tool.orientation));
        let configuration = format!("{:?}", configuration.0).replace(' ', "");
        let answer = self.calculate(
            requests::INVERSE,
            &[
                ("unit", unit.0.as_str()),
                ("position", &position),
                ("orientation", &orientation),
                ("external", NO_EXTERNAL),
                ("near", &near),
                ("configuration", &configuration),
                ("tool_position", &tool_position),
                ("tool_orientation", &tool_orientation),
            ],
        )?;
        solution(answer.one("joints-from-cartesian")?)
    }

    /// All joints that bring the TCP of a tool to `pose`.
    ///
    /// # Errors
    /// As [`Session::inverse`].
    pub fn solutions(
        &mut self,
        unit: &Unit,
        pose: &Frame,
        configuration: Configuration,
        tool: &Frame,
    ) -> Result<Vec<Solution>, LinkError> {
        let (position, orientation) = (list(&pose.position_m), list(&pose.orientation));
        let (tool_position, tool_orientation) = (list(&tool.position_m), list(&tool.orientation));
        let configuration = format!("{:?}", configuration.0).replace(' ', "");
        let answer = self.calculate(
            requests::SOLUTIONS,
            &[
                ("unit", unit.0.as_str()),
                ("position", &position),
                ("orientation", &orientation),
                ("external", NO_EXTERNAL),
                ("configuration", &configuration),
                ("tool_position", &tool_position),
                ("tool_orientation", &tool_orientation),
            ],
        )?;
        answer.all("all-joint-solutions").map(solution).collect()
    }

    /// Joints with which the arm stands, **degrees**, as the controller shows them.
    ///
    /// # Errors
    /// A refusal; an incomplete answer.
    pub fn joints_now_deg(&mut self, unit: &Unit) -> Result<[f64; 6], LinkError> {
        let answer = self.ask(requests::JOINTS_NOW, &[("unit", unit.0.as_str())])?;
        numbers(answer.one("ms-jointtarget")?, ["rax_1", "rax_2", "rax_3", "rax_4", "rax_5", "rax_6"])
    }

    /// Where the flange stands by the controller's own reckoning, in the base frame: **millimetres**, and the orientation.
    ///
    /// # Errors
    /// A refusal; an incomplete answer.
    pub fn flange_now_mm(&mut self, unit: &Unit) -> Result<([f64; 3], [f64; 4]), LinkError> {
        let answer = self.ask(requests::POSE_NOW, &[("unit", unit.0.as_str())])?;
        let entry = answer.one("ms-robtargets")?;
        Ok((numbers(entry, ["x", "y", "z"])?, numbers(entry, ["q1", "q2", "q3", "q4"])?))
    }

    fn calculate(
        &mut self,
        request: &'static requests::Request,
        arguments: &[(&'static str, &str)],
    ) -> Result<crate::answer::Answer, LinkError> {
        match self.ask(request, arguments) {
            Err(LinkError::Refused { refusal, .. }) if refusal.is_not_offered() => {
                Err(LinkError::NotOffered { dialect: self.dialect.to_string(), request: request.name })
            }
            other => other,
        }
    }
}

fn solution(entry: Entry<'_>) -> Result<Solution, LinkError> {
    let fields = ["robotjoint1", "robotjoint2", "robotjoint3", "robotjoint4", "robotjoint5", "robotjoint6"];
    Ok(Solution { q_rad: numbers(entry, fields)? })
}

fn numbers<const N: usize>(entry: Entry<'_>, fields: [&str; N]) -> Result<[f64; N], LinkError> {
    let mut out = [0.0; N];
    for (out, field) in out.iter_mut().zip(fields) {
        *out = entry.number(field)?;
    }
    Ok(out)
}

/// The numbers as `[a,b,c]`, in the shortest text that reads back equal.
fn list(numbers: &[f64]) -> String {
    let texts: Vec<String> = numbers.iter().map(f64::to_string).collect();
    format!("[{}]", texts.join(","))
}

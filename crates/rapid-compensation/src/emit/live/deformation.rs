//! What is put into RAPID: offsets of the frames by functions of time, turns of the joints.

use super::frames::{FixedFrame, steps};
use super::turns::{Compliance, Turn};
use nalgebra::{Matrix3, Vector3};
use robot_model::deform::EffectKind;
use robot_model::deform::identified::{Growth, Identified, Term};
use robot_model::kinematics::FrameOffsets;
use robot_model::robot::{Axis, Robot};

/// Turns that change by more than this with the joint (rad/rad) are looked at once more at the corrected joints: the
/// offsets of a drifting arm change by some ten thousandths.
const STEEP: f64 = 1e-3;

/// A function of time: what grows with it.
#[derive(Clone, Debug, PartialEq)]
pub struct Function {
    /// The table's offsets where the function is 1, SI.
    pub offsets: FrameOffsets,
    /// The growth of an identified model's terms that is this function.
    pub shape: Option<Growth>,
}

/// What a correction may be; beyond it the original target is used.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cap {
    /// Shift of the TCP, metres.
    pub shift_m: f64,
    /// Turn of the tool, radians.
    pub turn_rad: f64,
    /// Change of any joint of a joint target, radians.
    pub joint_rad: f64,
}

/// The deformed model of one robot, to be written as RAPID.
#[derive(Clone, Debug)]
pub struct LiveModel {
    pub(super) robot: Robot,
    pub(super) steps: [FixedFrame; 7],
    /// Offsets of each function where it is 1, and those that are always there; metres and radians.
    pub(super) growing: Vec<FrameOffsets>,
    pub(super) always: FrameOffsets,
    /// Turns of each joint.
    pub(super) turns: [Vec<Turn>; 6],
    /// Turn of each joint under load.
    pub(super) compliance: [Option<Compliance>; 6],
    pub(super) cap: Cap,
    /// The whole load on the flange, kg, in place of the tool's own.
    pub(super) payload_kg: Option<f64>,
    /// Turns are looked at a second time, at the corrected joints.
    pub(super) steep: bool,
}

impl LiveModel {
    /// The model of `robot` whose frames have the offsets `sum of tcFr * functions[r - 1].offsets`, and `model` on top, where
    /// steps are taken as having happened ([`Identified::for_programs`]).
    ///
    /// # Errors
    /// The effects of `model` that RAPID cannot hold, each once.
    pub fn new(
        robot: &Robot,
        functions: &[Function],
        model: Option<&Identified>,
        cap: Cap,
    ) -> Result<Self, Vec<String>> {
        let mut live = Self {
            robot: robot.clone(),
            steps: steps(robot),
            growing: functions.iter().map(|f| f.offsets).collect(),
            always: FrameOffsets::default(),
            turns: std::array::from_fn(|_| Vec::new()),
            compliance: [None; 6],
            cap,
            payload_kg: None,
            steep: false,
        };
        let mut cannot: Vec<String> = Vec::new();
        for term in model.iter().flat_map(|m| &m.terms) {
            if let Err(why) = live.add(term, functions)
                && !cannot.contains(&why)
            {
                cannot.push(why);
            }
        }
        live.steep = live.turns.iter().flatten().map(Turn::steepness).sum::<f64>() > STEEP;
        if cannot.is_empty() { Ok(live) } else { Err(cannot) }
    }

    /// The same with so much on the flange, kg, in place of the tool's own load, where that is given.
    #[must_use]
    pub fn with_payload_kg(self, payload_kg: Option<f64>) -> Self {
        Self { payload_kg, ..self }
    }

    /// How many functions of time there are.
    #[must_use]
    pub fn functions(&self) -> usize {
        self.growing.len()
    }

    /// Whether RAPID looks at the joints' own turns a second time, at the joints of the corrected target: where gear lines or
    /// gains change fast with the joints.
    #[must_use]
    pub fn looks_again(&self) -> bool {
        self.steep
    }

    /// Whether anything is there whatever the functions of time are.
    pub(super) fn has_constant(&self) -> bool {
        self.always != FrameOffsets::default()
            || self.compliance.iter().any(Option::is_some)
            || self.turns.iter().flatten().any(|turn| turn.function().is_none())
    }

    /// One function and nothing else: the twist is the settled one times the function.
    pub(super) fn is_scaled(&self) -> bool {
        self.functions() == 1 && !self.has_constant() && self.turns.iter().all(Vec::is_empty)
    }

    /// The offsets of frame `i` by one function, or those always there, in the axes that are used.
    pub(super) fn row(&self, function: Option<usize>, i: usize) -> [Vector3<f64>; 2] {
        let offsets = function.and_then(|r| self.growing.get(r)).unwrap_or(&self.always);
        let [dx, dy, dz, rx, ry, rz] = offsets.0[i];
        let used = &self.steps[i].used_from_filed;
        [used * Vector3::new(dx, dy, dz), used * Vector3::new(rx, ry, rz)]
    }

    /// The links' masses (kg) and centres (metres) in the frames that are used.
    pub(super) fn links(&self) -> [(f64, Vector3<f64>); 6] {
        let links = robot_model::deform::gravity::links(self.robot.geometry());
        std::array::from_fn(|k| (links[k].mass_kg, self.turned(k) * Vector3::from(links[k].com_m)))
    }

    fn turned(&self, k: usize) -> &Matrix3<f64> {
        &self.steps[k].turned
    }

    fn add(&mut self, term: &Term, functions: &[Function]) -> Result<(), String> {
        let name = || term.kind.name().to_owned();
        let function = match term.growth {
            Growth::Always => None,
            Growth::Temperature { .. } => return Err(format!("{} by temperature", name())),
            shape => match functions.iter().position(|f| f.shape == Some(shape)) {
                Some(r) => Some(r),
                None => return Err(format!("{} with a growth of its own", name())),
            },
        };
        let v = |i: usize| term.value(i);
        let joint = term.joint.map_or(0, Axis::index).min(5);
        let mut turn = |joint: usize, turn: Turn| self.turns[joint].push(turn);
        match term.kind {
            EffectKind::JointOffset => turn(joint, Turn::Constant { function: None, rad: v(0) }),
            EffectKind::ThermalJointDrift | EffectKind::JointStep => {
                turn(joint, Turn::Constant { function, rad: v(0) });
                turn(joint, Turn::Constant { function: None, rad: v(1) });
            }
            EffectKind::JointGain => turn(joint, Turn::Gain { by: joint, gain: v(0) }),
            EffectKind::JointCoupling => {
                turn(term.joint_b.map_or(0, Axis::index).min(5), Turn::Gain { by: joint, gain: v(0) });
            }
            EffectKind::GearEccentricity | EffectKind::GearSecondHarmonic | EffectKind::GearMesh => {
                turn(joint, Turn::Gear { n: term.n.unwrap_or(1), sin_rad: v(0), cos_rad: v(1) });
            }
            EffectKind::LinkGeometry => self.offset(function, joint + 1, std::array::from_fn(v)),
            EffectKind::BaseDrift | EffectKind::BaseStep => self.offset(function, 0, std::array::from_fn(v)),
            EffectKind::ThermalLinkGrowth => {
                for i in (0..6).filter(|i| term.joint.is_none_or(|link| link.index() == *i)) {
                    let next = self.robot.joints.get(i + 1).map(|j| j.previous_from_joint);
                    let [x, y, z] = next.unwrap_or(self.robot.joint6_from_flange).translation.vector.into();
                    let along = [x, y, z, 0.0, 0.0, 0.0];
                    self.offset(function, i + 1, along.map(|x| x * v(0)));
                    self.offset(None, i + 1, along.map(|x| x * v(1)));
                }
            }
            EffectKind::ToolDrift | EffectKind::ToolStep => {
                let shift = self.robot.joint6_from_flange.rotation * Vector3::new(v(0), v(1), v(2));
                self.offset(function, 6, [shift.x, shift.y, shift.z, 0.0, 0.0, 0.0]);
            }
            EffectKind::JointCompliance if v(7) != 0.0 || v(8) != 0.0 => {
                return Err(format!("{} that hardens or softens", name()));
            }
            EffectKind::JointCompliance => {
                let own = self.compliance[joint].get_or_insert_default();
                own.add(v(0), std::array::from_fn(|k| v(k + 1)));
            }
            EffectKind::InstrumentScale | EffectKind::JointRounding | EffectKind::SwappedAxes => {}
            EffectKind::Backlash
            | EffectKind::LinkBending
            | EffectKind::BaseTilt
            | EffectKind::PayloadMass
            | EffectKind::GearSpectrum => {
                debug_assert!(!term.kind.is_known_at_run_time());
                return Err(name());
            }
        }
        Ok(())
    }

    fn offset(&mut self, function: Option<usize>, frame: usize, by: [f64; 6]) {
        let offsets = function.and_then(|r| self.growing.get_mut(r)).unwrap_or(&mut self.always);
        if let Some(row) = offsets.0.get_mut(frame) {
            for (to, by) in row.iter_mut().zip(by) {
                *to += by;
            }
        }
    }
}

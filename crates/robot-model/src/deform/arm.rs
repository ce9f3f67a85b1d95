//! The deformed arm at one moment: a table's offsets and an identified model's terms, under the conditions of one pose.

use super::gravity::loads_at;
use super::identified::{ArmDelta, Identified, PoseState, Term, ThermalState};
use crate::kinematics::{ArmKinematics, Chain, FrameOffsets, NominalFrames, PoseAndJacobian, SerialOffsets};
use crate::robot::Robot;
use nalgebra::{Isometry3, Point3, Vector3};
use std::sync::Arc;

/// What hangs on the flange.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Payload {
    /// Mass of the payload, kg.
    pub mass_kg: f64,
    /// Centre of gravity in the flange's frame, metres.
    pub cog_m: [f64; 3],
}

/// What a pose brings with it besides its joints.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Conditions {
    /// Load on the flange.
    pub payload: Payload,
    /// Sign of each joint's last motion; 0 = not known.
    pub direction: [i8; 6],
}

/// An arm at one moment.
#[derive(Clone, Debug)]
pub struct DeformedArm {
    table: Chain,
    terms: Option<Arc<Terms>>,
    when: ThermalState,
    offsets: FrameOffsets,
}

#[derive(Debug)]
struct Terms {
    robot: Arc<Robot>,
    frames: NominalFrames,
    nominal: Chain,
    model: Arc<Identified>,
    needs_load: bool,
    /// Every term that moves frames leaves them where the joints do not matter.
    fixed_frames: bool,
}

impl DeformedArm {
    /// The arm with a table's offsets alone.
    #[must_use]
    pub fn of_table(robot: &Robot, offsets: &FrameOffsets) -> Self {
        Self::of_frames(&NominalFrames::of(robot), offsets)
    }

    /// The same, where many moments of one robot are asked for.
    #[must_use]
    pub fn of_frames(frames: &NominalFrames, offsets: &FrameOffsets) -> Self {
        let when = ThermalState { t_min: f64::INFINITY, joint_temperature_c: None };
        Self { table: frames.chain(offsets), terms: None, when, offsets: *offsets }
    }

    /// The arm with a table's offsets and an identified model on top.
    #[must_use]
    pub fn of_model(
        robot: &Arc<Robot>,
        offsets: &FrameOffsets,
        model: &Arc<Identified>,
        when: ThermalState,
    ) -> Self {
        let frames = NominalFrames::of(robot);
        let table = Self::of_frames(&frames, offsets);
        let terms = Terms {
            nominal: frames.chain(&FrameOffsets::default()),
            frames,
            needs_load: model.needs_load(),
            fixed_frames: model.terms.iter().all(|t| t.kind.only_turns() || !t.kind.needs_load()),
            robot: Arc::clone(robot),
            model: Arc::clone(model),
        };
        let mut arm = Self { terms: Some(Arc::new(terms)), when, ..table };
        arm.fix_frames();
        arm
    }

    /// The same model at another moment.
    #[must_use]
    pub fn at(&self, when: ThermalState) -> Self {
        let mut arm = Self { when, ..self.clone() };
        arm.fix_frames();
        arm
    }

    /// Frames that do not depend on the joints are set once.
    fn fix_frames(&mut self) {
        let Some(terms) = self.terms.as_deref().filter(|terms| terms.fixed_frames) else { return };
        let mut delta = ArmDelta { offsets: serial(&self.offsets), ..ArmDelta::default() };
        let at = PoseState {
            arm: terms.robot.geometry(),
            when: &self.when,
            q_rad: &[0.0; 6],
            direction: &[0; 6],
            loads: None,
            payload_kg: 0.0,
        };
        for term in terms.model.terms.iter().filter(|t| !t.kind.only_turns()) {
            term.add(&at, &mut delta);
        }
        self.table = terms.frames.chain(&of_six(&delta.offsets));
    }

    /// The arm's frames, where neither joints nor load move them.
    pub(super) fn constant(&self) -> Option<&Chain> {
        self.terms.is_none().then_some(&self.table)
    }

    /// The arm under the conditions of one pose.
    #[must_use]
    pub fn under<'a>(&'a self, conditions: &'a Conditions) -> ArmUnder<'a> {
        ArmUnder { arm: self, conditions }
    }
}

/// What the arm at one pose differs by from the nominal one: the same as a table's offsets and joints that are turned.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ArmDeviation {
    /// Added to the commanded joints, radians.
    pub turns_rad: [f64; 6],
    /// Added to the frames of the joints and of the flange.
    pub offsets: FrameOffsets,
}

/// The offsets of six joints and the flange.
fn serial(offsets: &FrameOffsets) -> SerialOffsets {
    let mut all = SerialOffsets::default();
    for (to, row) in all.0.iter_mut().zip(&offsets.0) {
        *to = *row;
    }
    all
}

fn of_six(offsets: &SerialOffsets) -> FrameOffsets {
    FrameOffsets(std::array::from_fn(|i| offsets.0[i]))
}

/// A [`DeformedArm`] under the conditions of one pose.
#[derive(Clone, Copy, Debug)]
pub struct ArmUnder<'a> {
    arm: &'a DeformedArm,
    conditions: &'a Conditions,
}

impl ArmUnder<'_> {
    /// `base_from_flange` when the controller commands `q_rad`.
    #[must_use]
    pub fn forward(&self, q_rad: &[f64; 6]) -> Isometry3<f64> {
        self.on_chain(q_rad, |chain, q_rad, _| chain.forward(q_rad))
    }

    /// Where a point of the flange's frame stands in the base, metres.
    #[inline]
    #[must_use]
    pub fn point_m(&self, q_rad: &[f64; 6], on_flange_m: &Vector3<f64>) -> Vector3<f64> {
        self.on_chain(q_rad, |chain, q_rad, _| chain.point_m(q_rad, on_flange_m))
    }

    /// How the arm differs from the nominal one when the controller commands `q_rad`.
    #[must_use]
    pub fn deviation(&self, q_rad: &[f64; 6]) -> ArmDeviation {
        let Some(terms) = self.arm.terms.as_deref() else {
            return ArmDeviation { turns_rad: [0.0; 6], offsets: self.arm.offsets };
        };
        let delta = self.delta(terms, q_rad, |_| true);
        ArmDeviation {
            turns_rad: std::array::from_fn(|i| delta.turns_rad[i]),
            offsets: of_six(&delta.offsets),
        }
    }

    /// `work` with the chain and the joints at which it really stands.
    #[inline]
    fn on_chain<T>(
        &self,
        q_rad: &[f64; 6],
        work: impl FnOnce(&Chain, &[f64; 6], Option<&ArmDelta>) -> T,
    ) -> T {
        let Some(terms) = self.arm.terms.as_deref() else { return work(&self.arm.table, q_rad, None) };
        // frames that stay as they are wherever the arm stands are in the chain already
        let delta = self.delta(terms, q_rad, |term| !terms.fixed_frames || term.kind.only_turns());
        let really_rad = std::array::from_fn(|i| q_rad[i] + delta.turns_rad[i]);
        if terms.fixed_frames {
            return work(&self.arm.table, &really_rad, Some(&delta));
        }
        work(&terms.frames.chain(&of_six(&delta.offsets)), &really_rad, Some(&delta))
    }

    /// What the wanted terms do, on top of the table.
    fn delta(&self, terms: &Terms, q_rad: &[f64; 6], is_wanted: impl Fn(&Term) -> bool) -> ArmDelta {
        let mut delta = ArmDelta { offsets: serial(&self.arm.offsets), ..ArmDelta::default() };
        let payload = &self.conditions.payload;
        let gravity = terms.needs_load.then(|| {
            let frames = terms.nominal.frames(q_rad);
            let axes: [_; 6] =
                std::array::from_fn(|j| frames[j].rotation * terms.robot.joints[j].axis.into_inner());
            let at_m = frames[6] * Point3::from(Vector3::from(payload.cog_m));
            (loads_at(terms.robot.geometry(), &frames, &axes, at_m.coords, payload.mass_kg), frames)
        });
        let at = PoseState {
            arm: terms.robot.geometry(),
            when: &self.arm.when,
            q_rad,
            direction: &self.conditions.direction,
            loads: gravity.as_ref().map(|(loads, frames)| (loads, frames.as_slice())),
            payload_kg: payload.mass_kg,
        };
        terms.model.terms.iter().filter(|term| is_wanted(term)).for_each(|term| term.add(&at, &mut delta));
        delta
    }
}

impl ArmKinematics for ArmUnder<'_> {
    #[inline]
    fn pose_and_jacobian(&self, q_rad: &[f64; 6]) -> PoseAndJacobian {
        self.on_chain(q_rad, |chain, q_rad, delta| {
            let mut there = chain.pose_and_jacobian(q_rad);
            if let Some(delta) = delta {
                // J (1 + d turns / d q): gear lines change fast with the joints; what gravity adds is left out.
                let plain = there.jacobian;
                for (row, plain) in there.jacobian.iter_mut().zip(&plain) {
                    for (to, j) in row.iter_mut().zip(0..6) {
                        *to += (0..6).map(|i| plain[i] * delta.slopes[i][j]).sum::<f64>();
                    }
                }
            }
            there
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::deform::identified::{Estimate, Growth, TILT_ABOUT_AXIS_1, TILT_SHIFT};
    use crate::deform::{EffectKind, GrowthLaw};
    use crate::kinematics::solve;
    use crate::robot::Axis;

    fn term(kind: EffectKind, joint: Option<usize>, values: &[f64]) -> Term {
        Term::plain(
            kind,
            joint.map(Axis::at),
            values.iter().map(|&value| Estimate { value, sigma: None }).collect(),
        )
    }

    fn arm(terms: Vec<Term>, t_min: f64) -> DeformedArm {
        let robot = Arc::new(Robot::built_in("irb140").unwrap());
        let model = Arc::new(Identified { terms, ..Identified::default() });
        let when = ThermalState { t_min, joint_temperature_c: None };
        DeformedArm::of_model(&robot, &FrameOffsets::default(), &model, when)
    }

    const Q_RAD: [f64; 6] = [0.3, 0.4, -0.2, 0.7, -0.9, 1.1];

    #[test]
    fn a_joint_offset_is_a_turn_of_the_joint_and_play_half_its_gap() {
        let nominal = Chain::nominal(&Robot::built_in("irb140").unwrap());
        let mut turned = Q_RAD;
        turned[2] += 1e-3;
        let plain = Conditions::default();
        let offset = arm(vec![term(EffectKind::JointOffset, Some(2), &[1e-3])], 0.0);
        assert!(
            (offset.under(&plain).forward(&Q_RAD).to_matrix() - nominal.forward(&turned).to_matrix()).norm()
                < 1e-15
        );
        let play = arm(vec![term(EffectKind::Backlash, Some(2), &[2e-3])], 0.0);
        let from_below = Conditions { direction: [0, 0, 1, 0, 0, 0], ..plain };
        assert_eq!(play.under(&from_below).forward(&Q_RAD), offset.under(&plain).forward(&Q_RAD));
        assert_eq!(play.under(&plain).forward(&Q_RAD), nominal.forward(&Q_RAD));
    }

    #[test]
    fn a_stretched_arm_sags_at_joint_2_by_its_torque() {
        // Stretched out level: the flange is 0.36 + 0.38 + 0.065 m from joint 2; a payload of 2 kg at the flange turns it by
        // c * 2 g * that lever, plus the links' own part, which is had by leaving the payload out.
        let q_rad = [0.0, std::f64::consts::FRAC_PI_2, -std::f64::consts::FRAC_PI_2, 0.0, 0.0, 0.0];
        let c = 5e-6;
        let soft = arm(vec![term(EffectKind::JointCompliance, Some(1), &[c])], 0.0);
        let empty = Conditions::default();
        let loaded = Conditions { payload: Payload { mass_kg: 2.0, cog_m: [0.0; 3] }, ..empty };
        let sunk = soft.under(&loaded).forward(&q_rad).translation.vector
            - soft.under(&empty).forward(&q_rad).translation.vector;
        let lever = 0.36 + 0.38 + 0.065;
        assert!((sunk.z + c * 2.0 * 9.80665 * lever * lever).abs() < 1e-8, "{sunk}");
    }

    #[test]
    fn links_grow_with_time() {
        let growth = Term {
            growth: Growth::Law(GrowthLaw::Exp { tau_min: 30.0 }),
            ..term(EffectKind::ThermalLinkGrowth, Some(1), &[1e-4, 0.0])
        };
        let grown = arm(vec![growth], 30.0);
        // Link 2 is 360 mm; after one time constant 1 - 1/e of 100 ppm of it, along the upper arm.
        let delta = grown.under(&Conditions::default()).forward(&[0.0; 6]).translation.vector
            - Chain::nominal(&Robot::built_in("irb140").unwrap()).forward(&[0.0; 6]).translation.vector;
        let expected = 0.36e-4 * (1.0 - (-1.0_f64).exp());
        assert!((delta - Vector3::new(0.0, 0.0, expected)).norm() < 1e-12, "{delta}");
    }

    /// A stand that gives at its foot, half a metre below joint 1: what the flange does is a turn about that foot, to the square of the turn.
    #[test]
    fn a_tilt_with_its_shifts_turns_about_what_lies_below() {
        let (give, below_m) = (1e-6, 0.5);
        let mut values = [0.0; 11];
        values[..2].fill(give);
        TILT_SHIFT.iter().for_each(|&k| values[k] = below_m * give);
        let tilted = arm(vec![term(EffectKind::BaseTilt, None, &values)], 0.0);
        let there = tilted.under(&Conditions::default()).forward(&Q_RAD);
        let nominal = Chain::nominal(&Robot::built_in("irb140").unwrap()).forward(&Q_RAD);
        let turn_rad = (there.rotation * nominal.rotation.inverse()).scaled_axis();
        let foot_m = Vector3::new(0.0, 0.0, -below_m);
        let about_foot_m = turn_rad.cross(&(nominal.translation.vector - foot_m));
        let moved_m = there.translation.vector - nominal.translation.vector;
        assert!(turn_rad.norm() > 1e-5, "{turn_rad}");
        assert!((moved_m - about_foot_m).norm() < 2.0 * turn_rad.norm_squared(), "{moved_m} {about_foot_m}");
    }

    /// Springs in a mounting face that is inclined by 30 degrees: a payload turns the base about the axis down the slope by that part of its moment, and
    /// about the level one by the other, and not about joint 1's axis.
    #[test]
    fn springs_in_an_inclined_face_turn_the_base_about_axes_in_it() {
        let upright = Robot::built_in_file("irb140").unwrap();
        let inclined = upright.replacen("[[joint]]", "[[joint]]\nrpy_deg = [0, 30, 0]", 1);
        let robot = Arc::new(Robot::from_toml(&inclined).unwrap());
        let gives = [2e-6, 3e-6];
        let mut values = [0.0; 12];
        values[..2].copy_from_slice(&gives);
        values[TILT_ABOUT_AXIS_1] = -gives[0];
        let model =
            Identified { terms: vec![term(EffectKind::BaseTilt, None, &values)], ..Default::default() };
        let when = ThermalState { t_min: 0.0, joint_temperature_c: None };
        let arm = DeformedArm::of_model(&robot, &FrameOffsets::default(), &Arc::new(model), when);
        let at = |mass_kg: f64| {
            let payload = Payload { mass_kg, cog_m: [0.0; 3] };
            arm.under(&Conditions { payload, ..Conditions::default() }).forward(&Q_RAD)
        };
        let flange_m = Chain::nominal(&robot).forward(&Q_RAD).translation.vector;
        let moment = flange_m.cross(&Vector3::new(0.0, 0.0, -5.0 * 9.80665));
        let (sin, cos) = 30.0_f64.to_radians().sin_cos();
        let (down, level) = (Vector3::new(cos, 0.0, -sin), Vector3::y());
        let expected = down * gives[0] * moment.dot(&down) + level * gives[1] * moment.dot(&level);
        let turn_rad = (at(5.0).rotation * at(0.0).rotation.inverse()).scaled_axis();
        assert!((turn_rad - expected).norm() < 1e-3 * expected.norm(), "{turn_rad} {expected}");
    }

    #[test]
    fn joints_are_found_and_proved_with_every_kind_at_once() {
        let gear = Term { n: Some(40), ..term(EffectKind::GearMesh, Some(1), &[2e-4, -1e-4]) };
        let coupling =
            Term { joint_b: Some(Axis::at(5)), ..term(EffectKind::JointCoupling, Some(4), &[1e-3]) };
        let terms = vec![
            term(EffectKind::JointOffset, Some(2), &[1e-3]),
            term(EffectKind::LinkGeometry, Some(1), &[1e-4, 2e-4, -1e-4, 1e-4, 3e-4, -2e-4]),
            term(EffectKind::JointCompliance, Some(1), &[5e-6]),
            term(EffectKind::LinkBending, Some(1), &[1e-6, 2e-7]),
            term(EffectKind::BaseTilt, None, &[1e-6, -1e-6]),
            term(EffectKind::JointGain, Some(0), &[1e-4]),
            gear,
            coupling,
        ];
        let arm = arm(terms, 10.0);
        let conditions =
            Conditions { payload: Payload { mass_kg: 3.0, cog_m: [0.0, 0.0, 0.1] }, direction: [1; 6] };
        let goal = Chain::nominal(&Robot::built_in("irb140").unwrap()).forward(&Q_RAD);
        let solved = solve(&arm.under(&conditions), &goal, &Q_RAD).unwrap();
        let there = arm.under(&conditions).forward(&solved.q_rad);
        assert!((there.translation.vector - goal.translation.vector).norm() < 1e-11);
        assert!(solved.iterations <= 6, "{solved:?}");
        assert!((solved.q_rad[2] - Q_RAD[2]).abs() > 5e-4);
    }

    /// The nominal chain with the deviation put in by hand is the deformed arm: with frames that depend on the joints, and with
    /// frames that do not.
    #[test]
    fn a_deviation_is_all_that_the_arm_differs_by() {
        let robot = Robot::built_in("irb140").unwrap();
        let conditions =
            Conditions { payload: Payload { mass_kg: 3.0, cog_m: [0.0, 0.0, 0.1] }, direction: [1; 6] };
        let growth = Term {
            growth: Growth::Law(GrowthLaw::Exp { tau_min: 30.0 }),
            ..term(EffectKind::ThermalLinkGrowth, Some(1), &[1e-4, 0.0])
        };
        let fixed = vec![
            growth,
            term(EffectKind::LinkGeometry, Some(1), &[1e-4, 2e-4, -1e-4, 1e-4, 3e-4, -2e-4]),
            term(EffectKind::JointCompliance, Some(1), &[5e-6]),
            Term { n: Some(40), ..term(EffectKind::GearMesh, Some(1), &[2e-4, -1e-4]) },
        ];
        let bending = term(EffectKind::LinkBending, Some(1), &[1e-6, 2e-7]);
        for terms in [fixed.clone(), [fixed, vec![bending]].concat()] {
            let arm = arm(terms, 20.0);
            let under = arm.under(&conditions);
            let ArmDeviation { turns_rad, offsets } = under.deviation(&Q_RAD);
            let turned: [f64; 6] = std::array::from_fn(|i| Q_RAD[i] + turns_rad[i]);
            let by_hand = Chain::with_offsets(&robot, &offsets).forward(&turned);
            assert!((by_hand.to_matrix() - under.forward(&Q_RAD).to_matrix()).norm() < 1e-14);
            assert!(turns_rad[1].abs() > 1e-5 && offsets.0[2].iter().any(|v| v.abs() > 1e-5));
        }
    }

    #[test]
    fn the_jacobian_agrees_with_differences_but_for_gravity() {
        let gear = Term { n: Some(40), ..term(EffectKind::GearMesh, Some(1), &[2e-4, -1e-4]) };
        let coupling =
            Term { joint_b: Some(Axis::at(5)), ..term(EffectKind::JointCoupling, Some(4), &[1e-3]) };
        let arm = arm(vec![gear, coupling, term(EffectKind::JointGain, Some(0), &[1e-4])], 0.0);
        let conditions = Conditions::default();
        let under = arm.under(&conditions);
        let jacobian = under.pose_and_jacobian(&Q_RAD).jacobian;
        for j in 0..6 {
            let at = |h: f64| {
                let mut q_rad = Q_RAD;
                q_rad[j] += h;
                under.forward(&q_rad).translation.vector
            };
            let slope = (at(1e-6) - at(-1e-6)) / 2e-6;
            for k in 0..3 {
                assert!((slope[k] - jacobian[k][j]).abs() < 1e-8, "{k} {j}");
            }
        }
    }
}

//! The library of effects: what an unmodelled cause does to the measured point, one file each.
//!
//! An effect knows its parameters, unit, usual size and signature; nothing of evidence.

mod backlash;
mod base_drift;
mod base_step;
mod base_tilt;
mod gear_eccentricity;
mod gear_mesh;
mod gear_second_harmonic;
mod instrument_scale;
mod joint_compliance;
mod joint_coupling;
mod joint_gain;
mod joint_offset;
mod joint_rounding;
mod link_bending;
mod link_geometry;
mod payload_mass;
mod swapped_axes;
mod thermal;
mod thermal_joint_drift;
mod thermal_link_growth;
mod tool_drift;
mod tool_step;

pub(in crate::diagnose) use backlash::{held_above_n_m, torque_limits_n_m};
pub(in crate::diagnose) use payload_mass::{COMPLIANCE, SOFT};

use super::scene::{Driver, Motion, Scene, Site};

/// An effect that can open a gap between model and robot.
pub trait Effect: Sync {
    /// Name in every output.
    fn name(&self) -> &'static str;
    /// Unit of its size: mm, rad, rad/(N.m), 1, ppm, kg.
    fn unit(&self) -> &'static str;
    /// Usual size, for people.
    fn usual(&self) -> &'static str;
    /// Where size and signature come from.
    fn source(&self) -> &'static str;
    /// How it shows over time: constant, drift, step.
    fn time(&self) -> &'static str {
        "constant"
    }
    /// Why these data cannot show it.
    fn untestable(&self, _scene: &Scene) -> Option<String> {
        None
    }
    /// Its forms to try: joints, harmonics, times.
    fn candidates(&self, scene: &Scene) -> Vec<Candidate>;
    /// The angles per unit of each parameter, where turning `form.joint` is all that the effect does and
    /// there are many forms of it: their products are then cheap.
    fn angles(&self, _form: &Form, _site: &Site) -> Option<[f64; 2]> {
        None
    }
    /// The point's motion at `site` per unit of each parameter, pushed onto `out`.
    fn motions(&self, form: &Form, scene: &Scene, site: &Site, out: &mut Vec<Motion>);
}

/// Which form of an effect.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Form {
    /// Joint or link, counted from 0.
    pub joint: Option<usize>,
    /// The joint that is driven, counted from 0.
    pub joint_b: Option<usize>,
    /// Periods per turn.
    pub n: Option<u32>,
    /// Shape in time.
    pub driver: Driver,
    /// Another number that is scanned; what it means is the effect's own.
    pub variant: usize,
}

impl Form {
    /// The form without joint, period or shape.
    pub const PLAIN: Self = Self { joint: None, joint_b: None, n: None, driver: Driver::None, variant: 0 };

    /// The form of joint `j`, counted from 0.
    #[must_use]
    pub fn of_joint(j: usize) -> Self {
        Self { joint: Some(j), ..Self::PLAIN }
    }

    /// When a step happens.
    #[must_use]
    pub fn t0_min(&self) -> Option<f64> {
        match self.driver {
            Driver::Step { t0_min } => Some(t0_min),
            _ => None,
        }
    }
}

/// One form of one effect, with the size its parameters usually have.
#[derive(Clone, Debug, PartialEq)]
pub struct Candidate {
    /// Which effect: index into [`LIBRARY`].
    pub effect: usize,
    /// Which form.
    pub form: Form,
    /// Usual standard deviation of each parameter, SI.
    pub usual: Vec<f64>,
    /// The first so many parameters are the effect's size.
    pub counted: usize,
    /// Factor from SI to the effect's unit.
    pub factor: f64,
    /// Prior weight within the effect; normalised later.
    pub weight: f64,
    /// Physics gives its first parameter a sign: a gear gives way to gravity, a warm link grows.
    pub positive: bool,
}

impl Candidate {
    /// A candidate of equal weight, all parameters counted, unit SI. The library fills in `effect`.
    #[must_use]
    pub fn new(form: Form, usual: Vec<f64>) -> Self {
        Self { effect: 0, form, counted: usual.len(), usual, factor: 1.0, weight: 1.0, positive: false }
    }

    /// The effect itself.
    #[must_use]
    pub fn effect(&self) -> &'static dyn Effect {
        LIBRARY[self.effect]
    }
}

/// Every effect, in the order of the documentation.
pub static LIBRARY: [&dyn Effect; 21] = [
    &joint_offset::JointOffset,
    &link_geometry::LinkGeometry,
    &joint_compliance::JointCompliance,
    &link_bending::LinkBending,
    &base_tilt::BaseTilt,
    &gear_eccentricity::GearEccentricity,
    &gear_second_harmonic::GearSecondHarmonic,
    &gear_mesh::GearMesh,
    &joint_gain::JointGain,
    &joint_coupling::JointCoupling,
    &backlash::Backlash,
    &thermal_link_growth::ThermalLinkGrowth,
    &thermal_joint_drift::ThermalJointDrift,
    &base_drift::BaseDrift,
    &base_step::BaseStep,
    &instrument_scale::InstrumentScale,
    &tool_drift::ToolDrift,
    &tool_step::ToolStep,
    &payload_mass::PayloadMass,
    &joint_rounding::JointRounding,
    &swapped_axes::SwappedAxes,
];

/// All candidates that these data can show, weights normalised within each effect; and what they cannot.
#[must_use]
pub fn candidates(scene: &Scene) -> (Vec<Candidate>, Vec<(&'static str, String)>) {
    let mut all = Vec::new();
    let mut untestable = Vec::new();
    for (index, effect) in LIBRARY.iter().enumerate() {
        if let Some(reason) = effect.untestable(scene) {
            untestable.push((effect.name(), reason));
            continue;
        }
        let mut forms = effect.candidates(scene);
        let total: f64 = forms.iter().map(|c| c.weight).sum();
        for candidate in &mut forms {
            candidate.effect = index;
            candidate.weight /= total;
        }
        all.extend(forms);
    }
    (all, untestable)
}

/// J_j times a number: what every effect that only turns a joint does.
fn turn_joint(site: &Site, joint: Option<usize>, angle: f64, out: &mut Vec<Motion>) {
    out.push(super::scene::scaled(site.joint(joint.unwrap_or(0).min(5)), angle));
}

/// How far from the measured point a payload's centre usually lies, metres: the file does not say.
const LEVER_M: f64 = 0.08;
/// How wrong a link's mass in the robot file may be.
const MASS_ERROR: f64 = 0.3;

/// A rigid motion of the base: three shifts, three turns about its origin, times `factor`.
fn move_base(site: &Site, factor: f64, out: &mut Vec<Motion>) {
    for k in 0..6 {
        out.push(super::scene::scaled(site.offset(0, k), factor));
    }
}

/// A rigid motion of the target on the flange: three shifts in the flange's axes and, where the orientation
/// is measured, three turns (without it a turn of the target is a shift), times `factor`.
fn move_tool(scene: &Scene, site: &Site, factor: f64, out: &mut Vec<Motion>) {
    for k in 0..3 {
        let axis = site.flange.column(k);
        out.push(super::scene::scaled([axis[0], axis[1], axis[2], 0.0, 0.0, 0.0], factor));
    }
    if scene.rows_per_site == 6 {
        for k in 0..3 {
            // About the measured point itself: its shift stands above.
            let axis = site.flange.column(k);
            out.push(super::scene::scaled([0.0, 0.0, 0.0, axis[0], axis[1], axis[2]], factor));
        }
    }
}

/// So many stations lie on each side of a step, and between two of them: of fewer one false reading or two could be taken
/// along by the motion's six numbers.
const STEP_ASIDE: usize = 6;

/// Whether steps at two times are so near to each other that what lies between them may be false readings instead.
pub fn steps_too_near(scene: &Scene, t0_min: f64, other_t0_min: f64) -> bool {
    let (low, high) = (t0_min.min(other_t0_min), t0_min.max(other_t0_min));
    let between = scene.sites.iter().filter_map(|s| s.t_min).filter(|t| low < *t && *t < high).count();
    0 < between && between < STEP_ASIDE
}

/// Times at which a step may lie.
fn step_times(scene: &Scene) -> Vec<f64> {
    let times: Vec<f64> = scene.sites.iter().filter_map(|s| s.t_min).collect();
    let most = if times.len() > LARGE_SET { MOST_STEP_TIMES / 3 } else { MOST_STEP_TIMES };
    gaps(times, most, STEP_ASIDE)
}

/// As many as there are gaps in an ordinary set: a step that is put into the wrong gap leaves rows behind that look like
/// a second step.
const MOST_STEP_TIMES: usize = 240;
/// In a set of more stations than this every step tried costs too much memory and time.
const LARGE_SET: usize = 2000;

/// Middle times between stations, at most `most`, with `aside` stations or more on each side.
fn gaps(mut times: Vec<f64>, most: usize, aside: usize) -> Vec<f64> {
    times.sort_by(f64::total_cmp);
    if times.len() < 2 * aside {
        return Vec::new();
    }
    let middles: Vec<f64> = times
        .windows(2)
        .skip(aside - 1)
        .take(times.len() + 1 - 2 * aside)
        .filter(|w| w[1] > w[0])
        .map(|w| 0.5 * (w[0] + w[1]))
        .collect();
    let step = middles.len().div_ceil(most).max(1);
    middles.into_iter().step_by(step).collect()
}

/// Hours between the first and the last station.
fn hours(scene: &Scene) -> f64 {
    scene.time_min.map_or(0.0, |[low, high]| (high - low) / 60.0)
}

const NO_TIME: &str = "the file has no usable time (t_min)";

#[cfg(test)]
mod tests {
    use super::{MOST_STEP_TIMES, gaps};

    /// 150 stations a minute apart, in any order: every gap but the outer three.
    #[test]
    fn a_step_is_looked_for_in_every_gap_of_an_ordinary_set() {
        let times: Vec<f64> = (0..150).rev().map(f64::from).collect();
        let expected: Vec<f64> = (3..146).map(|minute| f64::from(minute) + 0.5).collect();
        assert_eq!(gaps(times.clone(), MOST_STEP_TIMES, 4), expected);
        assert_eq!(gaps(times, 50, 4).len(), 48, "every third of 143");
        assert_eq!(gaps(vec![1.0; 9], 50, 4), Vec::<f64>::new(), "all at once");
    }
}

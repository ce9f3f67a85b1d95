//! What an effect is: parameters, unit, usual size and linear signature; nothing of evidence.

use super::rigid::Motion;
use crate::dataset::{DataPoint, Dataset, Twist};
use crate::size_unit::SizeUnit;
use crate::time_course::TimeCourse;
use robot_model::deform::identified::{Growth, PayloadScaling};
use robot_model::deform::{EffectKind, GrowthLaw};
use robot_model::robot::Axis;
use robot_model::units::mm_from_m;

/// An effect that can open a gap between model and robot.
pub trait Effect: Sync {
    /// The effect's kind, which gives it its name in every output.
    fn kind(&self) -> EffectKind;
    /// Unit of its size: mm, rad, rad/(N.m), mm/N, 1, ppm, kg.
    fn unit(&self) -> SizeUnit;
    /// The size it usually has, in words for people.
    fn usual_size(&self) -> &'static str;
    /// The literature that signature and usual size come from.
    fn source(&self) -> &'static str;
    /// Beyond so many prior standard deviations it is something else: of the prior's sizes a hundredth lies there.
    fn furthest_sigmas(&self) -> f64 {
        30.0
    }
    /// How it shows over time: constant, drift, step.
    fn time(&self) -> TimeCourse {
        TimeCourse::Constant
    }
    /// Why these data cannot show it; `None` where they can.
    fn untestable(&self, _dataset: &Dataset) -> Option<String> {
        None
    }
    /// Its variants to try: joints, harmonics, times, growths.
    fn candidates(&self, dataset: &Dataset) -> Vec<Candidate>;
    /// The motion that is all that the effect does, but for its size at each observation: the products of such variants are
    /// cheap.
    fn motion(&self, _variant: &EffectVariant) -> Option<Motion> {
        None
    }
    /// By how much [`Self::motion`] goes at the observation, pushed onto `out`: of a joint's motion per unit of each parameter, of a
    /// body's one number for all.
    fn factors(&self, _variant: &EffectVariant, _at: DataPoint<'_>, _out: &mut Vec<f64>) {}
    /// The effect's linear signature: the measured point's twist at the observation per unit of each parameter (SI),
    /// pushed onto `out` in the order of [`Candidate::prior_sigma`].
    fn signature(&self, variant: &EffectVariant, at: DataPoint<'_>, out: &mut Vec<Twist>) {
        if let Some(motion) = self.motion(variant) {
            let mut factors = Vec::new();
            self.factors(variant, at, &mut factors);
            motion.signature(at, &factors, out);
        }
    }
}

/// Which variant of an effect: all that is scanned and not fitted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EffectVariant {
    /// Joint or link; link i follows joint i.
    pub joint: Option<Axis>,
    /// The joint that is driven by a coupling.
    pub joint_b: Option<Axis>,
    /// Periods per turn of a gear line.
    pub n: Option<u32>,
    /// Growth in time or temperature.
    pub growth: Growth,
    /// Backlash: when gravity holds the teeth.
    pub gravity_hold: GravityHold,
    /// Payload mass: where the excess hangs.
    pub payload_scaling: PayloadScaling,
    /// With its own departures from the plain shape: a gear's even harmonic, a spring that hardens or softens, a link that bends by
    /// the moment alone, a gain about a zero of its own, a change over time beside a constant; or a link that is off in its length alone.
    pub refined: bool,
}

/// When gravity, not the last motion, decides on which side the teeth of a gear with play lie.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum GravityHold {
    /// The last motion always decides.
    #[default]
    Never,
    /// Gravity decides where its torque is above one of [`Dataset::torque_limit_n_m`].
    Above {
        /// Index of the limit.
        limit: usize,
        /// The file counts directions so that gravity's side has the sign of its torque; usually it is the opposite,
        /// for a driven joint lags behind its motor while its load pulls it ahead.
        same_sign: bool,
    },
}

impl EffectVariant {
    /// The variant without joint, period or growth.
    pub const PLAIN: Self = Self {
        joint: None,
        joint_b: None,
        n: None,
        growth: Growth::Always,
        gravity_hold: GravityHold::Never,
        payload_scaling: PayloadScaling::WhereLoaded,
        refined: false,
    };

    /// The plain variant of joint `j`, counted from 0.
    #[must_use]
    pub fn of_joint(j: usize) -> Self {
        Self { joint: Some(Axis::at(j)), ..Self::PLAIN }
    }

    /// The minute at which a step happens.
    #[must_use]
    pub fn t0_min(&self) -> Option<f64> {
        match self.growth {
            Growth::Step { t0_min } => Some(t0_min),
            _ => None,
        }
    }
}

/// One variant of one effect, with the prior of its parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct Candidate {
    /// The effect that it is a variant of.
    pub kind: EffectKind,
    /// Joint, period, growth: what is scanned.
    pub variant: EffectVariant,
    /// Prior standard deviation of each parameter, SI.
    pub prior_sigma: Vec<f64>,
    /// The first so many parameters make up the size that is reported.
    pub n_reported: usize,
    /// Factor from SI to its unit.
    pub display_scale: f64,
    /// Its unit where that is not the effect's: of a joint that slides.
    pub own_unit: Option<SizeUnit>,
    /// Prior weight within the effect, normalised by the library.
    pub weight: f64,
    /// Physics gives its first parameter a sign: a gear gives way to gravity, a warm link grows.
    pub sign_constrained: bool,
    /// Its second parameter is the first times how far off its zero lies, which usually is the ratio of their prior sigmas.
    pub about_own_zero: bool,
}

/// What two variants of one cause have in common.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct CauseKey {
    /// What kind of effect.
    pub kind: EffectKind,
    /// The joint or link at which it is, where it is one of them alone.
    pub joint: Option<Axis>,
    /// The joint that a coupling drives.
    pub joint_b: Option<Axis>,
}

impl Candidate {
    /// The cause that it is a variant of.
    #[must_use]
    pub fn cause_key(&self) -> CauseKey {
        let EffectVariant { joint, joint_b, .. } = self.variant;
        CauseKey { kind: self.kind, joint, joint_b }
    }

    /// The law by which it settles over time, whatever settles; `None` of what follows temperatures, steps or stands.
    #[must_use]
    pub fn settling_law(&self) -> Option<GrowthLaw> {
        match self.variant.growth {
            Growth::Law(law) => Some(law),
            _ => None,
        }
    }

    /// The same of joints and links alone.
    #[must_use]
    pub fn warm_up_law(&self) -> Option<GrowthLaw> {
        let is_of_arm = matches!(self.kind, EffectKind::ThermalJointDrift | EffectKind::ThermalLinkGrowth);
        self.settling_law().filter(|_| is_of_arm)
    }

    /// Whether it stands for one effect in all joints at once: what the search looks at together, and never names so.
    #[must_use]
    pub fn of_all_joints(&self) -> bool {
        matches!(self.kind, EffectKind::JointOffset | EffectKind::JointCompliance)
            && self.variant.joint.is_none()
    }

    /// A candidate of `kind` of weight 1, all parameters reported, unit SI.
    #[must_use]
    pub fn new(kind: EffectKind, variant: EffectVariant, prior_sigma: Vec<f64>) -> Self {
        Self {
            kind,
            variant,
            n_reported: prior_sigma.len(),
            prior_sigma,
            display_scale: 1.0,
            own_unit: None,
            weight: 1.0,
            sign_constrained: false,
            about_own_zero: false,
        }
    }

    /// A candidate of a signal and a constant of its own, of these usual sizes; the signal alone makes up the size that is reported. Without the
    /// constant where the model's zero is the signal's, and with it (refined) where it is not: at even odds, for nobody noted which.
    #[must_use]
    pub(super) fn without_and_with_constant(
        kind: EffectKind,
        plain: EffectVariant,
        [signal, constant]: [f64; 2],
    ) -> [Self; 2] {
        [(false, vec![signal]), (true, vec![signal, constant])].map(|(refined, sizes)| Self {
            n_reported: 1,
            weight: 0.5,
            ..Self::new(kind, EffectVariant { refined, ..plain }, sizes)
        })
    }

    /// The same of a joint that slides: sizes in mm, or in `unit` that has mm in it.
    #[must_use]
    pub fn of_slide(self, unit: SizeUnit) -> Self {
        Self { display_scale: mm_from_m(1.0), own_unit: Some(unit), ..self }
    }
}

//! Turns of a joint by its own angle, another's, time or load: identified effects.

use super::text::Summand;
use robot_model::units::rad_from_deg;

/// A turn of a joint, radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Turn {
    /// By a function of time, or always.
    Constant { function: Option<usize>, rad: f64 },
    /// In proportion to a joint's angle.
    Gain { by: usize, gain: f64 },
    /// `sin_rad Sin(n q) + cos_rad Cos(n q)` of the joint's own angle.
    Gear { n: u32, sin_rad: f64, cos_rad: f64 },
}

impl Turn {
    /// How much it may change with a joint, rad/rad.
    pub(super) fn steepness(&self) -> f64 {
        match *self {
            Self::Constant { .. } => 0.0,
            Self::Gain { gain, .. } => gain.abs(),
            Self::Gear { n, sin_rad, cos_rad } => f64::from(n) * sin_rad.hypot(cos_rad),
        }
    }

    /// In proportion to a joint.
    pub(super) fn is_gain(&self) -> bool {
        matches!(self, Self::Gain { .. })
    }

    /// The function of time that it follows.
    pub(super) fn function(&self) -> Option<usize> {
        match *self {
            Self::Constant { function, .. } => function,
            _ => None,
        }
    }

    /// As RAPID, where `tcQ` holds the joints in degrees; gear lines take more than a summand ([`super::gears`]).
    pub(super) fn summand(&self, sign: f64) -> Option<Summand> {
        match *self {
            Self::Constant { function, rad } => {
                Some((sign * rad, function.map_or_else(String::new, |r| format!("tcF{}", r + 1))))
            }
            Self::Gain { by, gain } => Some((sign * gain * rad_from_deg(1.0), format!("tcQ.rax_{}", by + 1))),
            Self::Gear { .. } => None,
        }
    }
}

#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Compliance {
    /// On the whole torque.
    pub whole: f64,
    /// More on each link's part.
    pub link: [f64; 6],
}

impl Compliance {
    /// Takes in another turn on top.
    pub(super) fn add(&mut self, whole: f64, link: [f64; 6]) {
        self.whole += whole;
        for (to, by) in self.link.iter_mut().zip(link) {
            *to += by;
        }
    }

    /// Shares of the links in it, as multiples of `scale`.
    pub(super) fn shares(&self, scale: f64) -> [f64; 7] {
        std::array::from_fn(|k| self.link.get(k).map_or(self.whole, |c| self.whole + c) / scale)
    }

    /// What its shares are multiples of: 0 where nothing gives.
    pub(super) fn scale(&self) -> f64 {
        if self.whole != 0.0 {
            return self.whole;
        }
        self.link.iter().copied().fold(0.0, |a: f64, b| if b.abs() > a.abs() { b } else { a })
    }
}

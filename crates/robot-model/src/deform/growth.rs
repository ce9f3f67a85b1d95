//! Growth laws: which share of the settled deformation is there after how many minutes of warm-up.

use crate::units::YEAR_MIN;
use std::fmt;
use std::ops::RangeInclusive;
use std::str::FromStr;
use thiserror::Error;

/// Time constants and pauses that a robot can have, minutes: from 0.6 seconds to a year. Beyond them the numbers of an emitted
/// clock no longer fit a line of RAPID.
pub const TIMES_MIN: RangeInclusive<f64> = 0.01..=YEAR_MIN;

/// How a deformation grows from 0 (cold) to 1 (settled) with warm-up time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum GrowthLaw {
    /// All of it from the first minute on.
    None,
    /// One lag: 1 - e^(-t/τ).
    Exp {
        /// Time constant τ, minutes.
        tau_min: f64,
    },
    /// Two equal lags in a row: 1 - (1 + t/τ) e^(-t/τ).
    TwoStage {
        /// Time constant τ, minutes.
        tau_min: f64,
    },
}

/// A growth law that cannot be read.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error(
    "`{text}` is no growth law: {problem}; write `none`, `exp:TAU` or `two-stage:TAU` with TAU in minutes, e.g. `two-stage:46`"
)]
pub struct GrowthError {
    /// The law as given.
    pub text: String,
    /// What is wrong with it.
    pub problem: String,
}

impl GrowthLaw {
    /// The share, 0 to 1, that is there at warm-up minute `t_min`; before minute 0 as at 0.
    #[must_use]
    pub fn at(&self, t_min: f64) -> f64 {
        1.0 - self.remaining(t_min)
    }

    /// The share that is still to come at `t_min`, exact to rounding however small.
    #[must_use]
    pub fn remaining(&self, t_min: f64) -> f64 {
        let lag = |tau_min: f64| t_min.max(0.0) / tau_min;
        match *self {
            Self::None => 0.0,
            _ if t_min == f64::INFINITY => 0.0,
            Self::Exp { tau_min } => (-lag(tau_min)).exp(),
            Self::TwoStage { tau_min } => (1.0 + lag(tau_min)) * (-lag(tau_min)).exp(),
        }
    }

    /// τ, minutes; `None` for a law without one.
    #[must_use]
    pub fn tau_min(&self) -> Option<f64> {
        match *self {
            Self::None => None,
            Self::Exp { tau_min } | Self::TwoStage { tau_min } => Some(tau_min),
        }
    }

    /// The same law with another time constant, minutes; a law without one stays as it is.
    #[must_use]
    pub fn with_tau_min(self, tau_min: f64) -> Self {
        match self {
            Self::None => Self::None,
            Self::Exp { .. } => Self::Exp { tau_min },
            Self::TwoStage { .. } => Self::TwoStage { tau_min },
        }
    }

    /// Whether both are the same kind of law, whatever their time constants.
    #[must_use]
    pub fn is_same_kind(&self, other: &Self) -> bool {
        std::mem::discriminant(self) == std::mem::discriminant(other)
    }

    /// The minute at which the share `growth` is reached: 0 for `growth` ≤ 0, `None` for `growth` ≥ 1, which a lag
    /// never reaches.
    #[must_use]
    pub fn minute_of(&self, growth: f64) -> Option<f64> {
        self.minute_of_remaining(1.0 - growth)
    }

    /// The minute from which on no more than the share `remaining` is still to come; `None` where it never comes to
    /// that (`remaining` ≤ 0 and a lag, or NaN).
    #[must_use]
    pub fn minute_of_remaining(&self, remaining: f64) -> Option<f64> {
        if remaining >= 1.0 {
            return Some(0.0);
        }
        match *self {
            Self::None => (remaining >= 0.0).then_some(0.0),
            _ if remaining.is_nan() || remaining <= 0.0 => None,
            Self::Exp { tau_min } => Some(-tau_min * remaining.ln()),
            Self::TwoStage { tau_min } => Some(tau_min * two_stage_lag(remaining)),
        }
    }
}

/// x ≥ 0 with (1 + x) e^-x = r, 0 < r < 1: Newton on ln(1 + x) - x - ln r, which is concave and falls, so that from the
/// right of the root every step stays there.
fn two_stage_lag(r: f64) -> f64 {
    let goal = r.ln();
    // Right of the root: x - ln(1 + x) ≥ x²/(2 + 2x), so x ≤ l + sqrt(l² + 2l) with l = -ln r.
    let mut x = -goal + (goal * goal - 2.0 * goal).sqrt();
    for _ in 0..60 {
        let step = (x.ln_1p() - x - goal) * (1.0 + x) / -x;
        let next = x - step;
        if next.is_nan() || next <= 0.0 || step.abs() <= 1e-15 * x {
            break;
        }
        x = next;
    }
    x
}

impl FromStr for GrowthLaw {
    type Err = GrowthError;

    fn from_str(text: &str) -> Result<Self, GrowthError> {
        let problem = |problem: &str| GrowthError { text: text.to_owned(), problem: problem.to_owned() };
        let (name, tau) = match text.trim().split_once(':') {
            None => (text.trim(), None),
            Some((name, tau)) => (name.trim(), Some(tau.trim())),
        };
        let tau_min = || match tau {
            None => Err(problem("TAU is missing")),
            Some(tau) => match tau.parse::<f64>() {
                Ok(tau_min) if TIMES_MIN.contains(&tau_min) => Ok(tau_min),
                Ok(_) => Err(problem(&format!(
                    "TAU must be from {} to {} minutes, which is a year",
                    TIMES_MIN.start(),
                    TIMES_MIN.end()
                ))),
                Err(_) => Err(problem("TAU is not a number")),
            },
        };
        match name.to_ascii_lowercase().as_str() {
            "none" if tau.is_none() => Ok(Self::None),
            "none" => Err(problem("`none` takes no TAU")),
            "exp" => Ok(Self::Exp { tau_min: tau_min()? }),
            "two-stage" => Ok(Self::TwoStage { tau_min: tau_min()? }),
            _ => Err(problem("no law of that name")),
        }
    }
}

impl fmt::Display for GrowthLaw {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::None => f.write_str("none"),
            Self::Exp { tau_min } => write!(f, "exp:{tau_min}"),
            Self::TwoStage { tau_min } => write!(f, "two-stage:{tau_min}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn laws_at_one_tau_by_hand() {
        let e = std::f64::consts::E;
        assert_eq!(GrowthLaw::None.at(0.0), 1.0);
        assert!((GrowthLaw::Exp { tau_min: 30.0 }.at(30.0) - (1.0 - 1.0 / e)).abs() < 1e-15);
        assert!((GrowthLaw::TwoStage { tau_min: 46.0 }.at(46.0) - (1.0 - 2.0 / e)).abs() < 1e-15);
        assert_eq!(GrowthLaw::TwoStage { tau_min: 46.0 }.at(0.0), 0.0);
        assert_eq!(GrowthLaw::TwoStage { tau_min: 46.0 }.at(-5.0), 0.0);
        assert_eq!(GrowthLaw::TwoStage { tau_min: 46.0 }.at(f64::INFINITY), 1.0);
    }

    #[test]
    fn the_minute_of_a_share_is_the_inverse() {
        for law in [GrowthLaw::Exp { tau_min: 20.0 }, GrowthLaw::TwoStage { tau_min: 46.0 }] {
            for growth in [1e-6, 0.01, 0.5, 0.9, 0.999, 1.0 - 1e-9] {
                let minute = law.minute_of(growth).unwrap();
                assert!((law.at(minute) - growth).abs() < 1e-13, "{law} {growth} {minute}");
            }
            let minute = law.minute_of_remaining(1e-30).unwrap();
            assert!((law.remaining(minute) / 1e-30 - 1.0).abs() < 1e-12);
            assert_eq!(law.minute_of(0.0), Some(0.0));
            assert_eq!(law.minute_of(1.0), None);
        }
        assert_eq!(GrowthLaw::None.minute_of(1.0), Some(0.0));
    }

    #[test]
    fn laws_are_read_as_written() {
        assert_eq!("none".parse(), Ok(GrowthLaw::None));
        assert_eq!("exp:12.5".parse(), Ok(GrowthLaw::Exp { tau_min: 12.5 }));
        assert_eq!("two-stage:46".parse(), Ok(GrowthLaw::TwoStage { tau_min: 46.0 }));
        assert_eq!(GrowthLaw::TwoStage { tau_min: 46.0 }.to_string(), "two-stage:46");
    }

    #[test]
    fn time_constants_that_no_robot_has_are_refused_with_the_range() {
        for tau in ["1e-300", "0.009", "-3", "0", "525601", "1e300", "inf"] {
            let error_text = format!("exp:{tau}").parse::<GrowthLaw>().unwrap_err().to_string();
            assert!(error_text.contains(&format!("`exp:{tau}` is no growth law")), "{error_text}");
            assert!(error_text.contains("from 0.01 to 525600 minutes"), "{error_text}");
        }
        assert_eq!("exp:0.01".parse(), Ok(GrowthLaw::Exp { tau_min: 0.01 }));
        assert_eq!("two-stage:525600".parse(), Ok(GrowthLaw::TwoStage { tau_min: 525_600.0 }));
    }

    #[test]
    fn what_is_no_law_names_the_accepted_forms() {
        for text in
            ["", "exp", "exp:", "exp:0", "exp:-3", "exp:nan", "exp:inf", "two-stage:x", "none:4", "linear:3"]
        {
            let error_text = text.parse::<GrowthLaw>().unwrap_err().to_string();
            assert!(error_text.contains("`none`, `exp:TAU` or `two-stage:TAU`"), "{text}: {error_text}");
        }
    }
}

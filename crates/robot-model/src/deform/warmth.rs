//! How warm a robot is, running and standing.

use super::GrowthLaw;

/// How warm a robot is: the lags of its growth law, 0 cold to 1 settled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Warmth {
    law: GrowthLaw,
    tau_cool_min: f64,
    first: f64,
    second: f64,
}

/// Two equal first-order lags in a row that run towards `u` for `s` time constants from the values x1, x2: with
/// y1 = x1 - u, y2 = x2 - u and e = exp(-s), x1 becomes u + y1 e and x2 becomes u + (y2 + y1 s) e.
#[must_use]
pub(super) fn two_lags([x1, x2]: [f64; 2], u: f64, s: f64) -> [f64; 2] {
    let e = (-s).exp();
    let (y1, y2) = (x1 - u, x2 - u);
    [u + y1 * e, u + (y2 + y1 * s) * e]
}

impl Warmth {
    /// A cold robot that warms by `law` and cools with `tau_cool_min`.
    #[must_use]
    pub fn cold(law: GrowthLaw, tau_cool_min: f64) -> Self {
        Self { law, tau_cool_min, first: 0.0, second: 0.0 }
    }

    /// Let it run or stand for a time.
    pub fn advance(&mut self, dt_min: f64, running: bool) {
        let Some(tau_min) = self.law.tau_min() else { return };
        let (u, tau_min) = if running { (1.0, tau_min) } else { (0.0, self.tau_cool_min) };
        [self.first, self.second] = two_lags([self.first, self.second], u, dt_min.max(0.0) / tau_min);
    }

    /// The share of the settled deformation that is there.
    #[must_use]
    pub fn share(&self) -> f64 {
        match self.law {
            GrowthLaw::None => 1.0,
            GrowthLaw::Exp { .. } => self.first,
            GrowthLaw::TwoStage { .. } => self.second,
        }
    }

    /// The minute after a cold start at which as much is there; `None` where it never is.
    #[must_use]
    pub fn minute(&self) -> Option<f64> {
        self.law.minute_of(self.share())
    }

    /// Fully warm at once.
    pub fn settle(&mut self) {
        self.first = 1.0;
        self.second = 1.0;
    }
}

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

impl Warmth {
    /// A cold robot that warms by `law` and cools with `tau_cool_min`.
    #[must_use]
    pub fn cold(law: GrowthLaw, tau_cool_min: f64) -> Self {
        Self { law, tau_cool_min, first: 0.0, second: 0.0 }
    }

    /// Let it run or stand for a time.
    ///
    /// For two equal lags in a row, with y1 = x1 - u, y2 = x2 - u and e = exp(-dt/τ):
    /// x1 = u + y1 e, x2 = u + (y2 + y1 dt/τ) e; u = 1 running, 0 standing.
    pub fn advance(&mut self, dt_min: f64, running: bool) {
        let Some(tau_min) = self.law.tau_min() else { return };
        let (u, tau_min) = if running { (1.0, tau_min) } else { (0.0, self.tau_cool_min) };
        let lag = dt_min.max(0.0) / tau_min;
        let e = (-lag).exp();
        let (y1, y2) = (self.first - u, self.second - u);
        self.first = u + y1 * e;
        self.second = u + (y2 + y1 * lag) * e;
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

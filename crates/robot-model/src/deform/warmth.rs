//! How warm a robot is, running and standing.

use super::GrowthLaw;

/// How warm a robot is: what of each lag of its growth law is still to come, 1 cold to 0 settled, which tells minutes long after what has come is 1 to
/// the last digit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Warmth {
    law: GrowthLaw,
    tau_cool_min: f64,
    first_to_come: f64,
    second_to_come: f64,
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
        Self { law, tau_cool_min, first_to_come: 1.0, second_to_come: 1.0 }
    }

    /// Let it run or stand for a time.
    pub fn advance(&mut self, dt_min: f64, running: bool) {
        let Some(tau_min) = self.law.tau_min() else { return };
        let (to_come, tau_min) = if running { (0.0, tau_min) } else { (1.0, self.tau_cool_min) };
        let lags = [self.first_to_come, self.second_to_come];
        [self.first_to_come, self.second_to_come] = two_lags(lags, to_come, dt_min.max(0.0) / tau_min);
    }

    /// The share of the settled deformation that is there.
    #[must_use]
    pub fn share(&self) -> f64 {
        1.0 - self.still_to_come()
    }

    /// The share that is still to come.
    fn still_to_come(&self) -> f64 {
        match self.law {
            GrowthLaw::None => 0.0,
            GrowthLaw::Exp { .. } => self.first_to_come,
            GrowthLaw::TwoStage { .. } => self.second_to_come,
        }
    }

    /// The minute after a cold start at which as much is there; `None` where it never is.
    #[must_use]
    pub fn minute(&self) -> Option<f64> {
        self.law.minute_of_remaining(self.still_to_come())
    }

    /// Fully warm at once.
    pub fn settle(&mut self) {
        self.first_to_come = 0.0;
        self.second_to_come = 0.0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 600 minutes of work are minute 600 by a lag of eight minutes, 75 of them, and by one of eighty; an hour's pause goes back by the lag: what has come
    /// is e^(-60/8) of it.
    #[test]
    fn minutes_are_told_long_after_all_has_come() {
        for law in [
            GrowthLaw::Exp { tau_min: 8.0 },
            GrowthLaw::TwoStage { tau_min: 8.0 },
            GrowthLaw::Exp { tau_min: 80.0 },
        ] {
            let mut warmth = Warmth::cold(law, 8.0);
            (0..600).for_each(|_| warmth.advance(1.0, true));
            assert!((warmth.minute().unwrap() - 600.0).abs() < 1e-9, "{law}: {:?}", warmth.minute());
        }
        let mut warmth = Warmth::cold(GrowthLaw::Exp { tau_min: 8.0 }, 8.0);
        warmth.advance(600.0, true);
        warmth.advance(60.0, false);
        assert!((warmth.share() - (-7.5_f64).exp()).abs() < 1e-12, "{}", warmth.share());
    }
}

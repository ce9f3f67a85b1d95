//! How warm one robot is, as touches of a fixed point tell it: an extended Kalman filter over the growth law's lags.
//!
//! The state is `[x1, x2, a, ln tau, ln tau_cool]`: both lags times the amount, the amount (settled drift of this robot over that
//! of its table), and the logarithms of the time constants, minutes. Working, the lags go towards `a`, standing towards 0, as
//! [`Warmth`](super::Warmth) does; what is added to the covariance stands for what the law does not hold. One lag leaves `x2`
//! unused. A touch sees the last lag: the share of the table's settled drift that is there.

use super::GrowthLaw;
use super::warmth::two_lags;
use nalgebra::{SMatrix, SVector};

/// Numbers of the state.
pub const STATES: usize = 5;
/// Estimated state: lags, amount, logarithms of the time constants.
pub type StateVector = SVector<f64, STATES>;
/// Covariance of a [`StateVector`], in the order of its elements.
pub type Covariance = SMatrix<f64, STATES, STATES>;

/// One standard deviation of the state where nothing is known yet but the table: lags, amount, logarithms.
pub const FIRST_SIGMA: [f64; STATES] = [0.35, 0.30, 0.30, 0.35, 0.60];
/// How the two lags' first deviations go together.
pub const FIRST_CORRELATION: f64 = 0.9;
/// What an hour adds, standard deviations.
pub const HOUR_SIGMA: [f64; STATES] = [0.02, 0.01, 0.01, 0.02, 0.02];
/// What [`HOUR_SIGMA`] is for, minutes.
const HOUR_MIN: f64 = 60.0;
/// An innovation beyond so many standard deviations is not taken.
pub const GATE: f64 = 3.0;
/// The same across the drift's line, where two coordinates are left: the squared distance over the variance of one that is
/// exceeded as seldom (chi-squared, two degrees of freedom: -2 ln 0.0027).
pub const GATE_ACROSS: f64 = 11.83;
/// Two refused touches in a row that agree within so many standard deviations of their difference say that the state was wrong.
pub const AGREE: f64 = 4.0;
/// Lags and amount stay under this, time constants within this factor of the table's.
pub const MOST_SHARE: f64 = 2.0;
/// Least amount, as a share of the table's.
pub const LEAST_AMOUNT: f64 = 0.2;
/// Time constants stay within this factor of the table's.
pub const MOST_TAU: f64 = 4.0;

/// What a touch came to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TouchOutcome {
    /// The filter took the touch.
    Taken,
    /// It agrees with the one that was refused before it: the state was wrong, and begins anew with it.
    Reset,
    /// It is too far from what was expected.
    Refused,
}

/// The thermal state of one robot.
#[derive(Clone, Debug, PartialEq)]
pub struct ThermalFilter {
    seen: usize,
    table: [f64; 2],
    /// Lags, amount, logarithms of the time constants in minutes.
    pub state: StateVector,
    /// Covariance of the state, rows and columns in its order.
    pub covariance: Covariance,
    refused: Option<f64>,
}

/// One step of working or standing: the derivative of the state after it by the state before it.
pub type Transition = Covariance;

impl ThermalFilter {
    /// A robot of which only the table's law is known, its lags guessed; `None` for a law without lags.
    #[must_use]
    pub fn new(law: GrowthLaw, tau_cool_min: f64, lags: [f64; 2]) -> Option<Self> {
        let tau_min = law.tau_min()?;
        let seen = usize::from(matches!(law, GrowthLaw::TwoStage { .. }));
        let mut covariance = Covariance::from_diagonal(&StateVector::from(FIRST_SIGMA.map(|s| s * s)));
        let both = FIRST_CORRELATION * FIRST_SIGMA[0] * FIRST_SIGMA[1];
        (covariance[(0, 1)], covariance[(1, 0)]) = (both, both);
        let state = StateVector::new(lags[0], lags[1], 1.0, tau_min.ln(), tau_cool_min.ln());
        Some(Self { seen, table: [tau_min, tau_cool_min], state, covariance, refused: None })
    }

    /// The share of the table's settled drift that is there.
    #[must_use]
    pub fn share(&self) -> f64 {
        self.state[self.seen]
    }

    /// Standard deviation of the estimated share of settled drift.
    #[must_use]
    pub fn sigma(&self) -> f64 {
        self.covariance[(self.seen, self.seen)].max(0.0).sqrt()
    }

    /// Which number of the state a touch sees.
    #[must_use]
    pub fn seen(&self) -> usize {
        self.seen
    }

    /// Lets the robot work or stand.
    pub fn advance(&mut self, dt_min: f64, working: bool) -> Transition {
        let (to, by) = if working { (self.state[2], 3) } else { (0.0, 4) };
        let s = dt_min.max(0.0) / self.state[by].exp();
        let e = (-s).exp();
        let [y1, y2] = [self.state[0] - to, self.state[1] - to];
        let mut f = Transition::identity();
        (f[(0, 0)], f[(1, 0)], f[(1, 1)]) = (e, s * e, e);
        if working {
            (f[(0, 2)], f[(1, 2)]) = (1.0 - e, 1.0 - (1.0 + s) * e);
        }
        // d e / d ln tau = s e.
        (f[(0, by)], f[(1, by)]) = (s * e * y1, s * e * (y2 + y1 * (s - 1.0)));
        [self.state[0], self.state[1]] = two_lags([self.state[0], self.state[1]], to, s);
        self.covariance = f * self.covariance * f.transpose();
        for (i, sigma) in HOUR_SIGMA.iter().enumerate() {
            self.covariance[(i, i)] += sigma * sigma * dt_min.max(0.0) / HOUR_MIN;
        }
        f
    }

    /// Takes in a touch: the share that it saw, and its variance.
    pub fn touch(&mut self, share: f64, variance: f64) -> TouchOutcome {
        let off = share - self.share();
        let mut outcome = TouchOutcome::Taken;
        let k = self.seen;
        if off * off > GATE * GATE * (self.covariance[(k, k)] + variance) {
            let agree = |last: f64| (off - last).powi(2) < AGREE * AGREE * 2.0 * variance;
            if !self.refused.is_some_and(agree) {
                self.refused = Some(off);
                return TouchOutcome::Refused;
            }
            outcome = TouchOutcome::Reset;
            let square = off * off;
            self.covariance[(0, 0)] += square;
            self.covariance[(1, 1)] += square;
            self.covariance[(0, 1)] += FIRST_CORRELATION * square;
            self.covariance[(1, 0)] = self.covariance[(0, 1)];
        }
        self.refused = None;
        let column: StateVector = self.covariance.column(k).into();
        let gain = column / (column[k] + variance);
        self.state += gain * off;
        self.covariance -= gain * column.transpose();
        self.hold();
        outcome
    }

    /// Keeps the state within what can be.
    fn hold(&mut self) {
        for lag in 0..2 {
            self.state[lag] = self.state[lag].clamp(0.0, MOST_SHARE);
        }
        self.state[2] = self.state[2].clamp(LEAST_AMOUNT, MOST_SHARE);
        for (i, table_min) in self.table.iter().enumerate() {
            let (ln, room) = (table_min.ln(), MOST_TAU.ln());
            self.state[3 + i] = self.state[3 + i].clamp(ln - room, ln + room);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::Warmth;
    use super::*;

    fn filter() -> ThermalFilter {
        ThermalFilter::new(GrowthLaw::TwoStage { tau_min: 46.0 }, 60.0, [0.3, 0.2]).unwrap()
    }

    #[test]
    fn it_goes_as_the_law_does() {
        let mut warmth = Warmth::cold(GrowthLaw::TwoStage { tau_min: 46.0 }, 60.0);
        let mut filter = ThermalFilter::new(GrowthLaw::TwoStage { tau_min: 46.0 }, 60.0, [0.0; 2]).unwrap();
        for (minutes, working) in [(50.0, true), (20.0, false), (7.0, true)] {
            warmth.advance(minutes, working);
            filter.advance(minutes, working);
        }
        assert!((warmth.share() - filter.share()).abs() < 1e-14);
        assert_eq!(ThermalFilter::new(GrowthLaw::None, 1.0, [0.0; 2]), None);
    }

    #[test]
    fn the_transition_is_the_derivative() {
        for working in [true, false] {
            let f = filter().advance(25.0, working);
            for j in 0..STATES {
                let moved = |h: f64| {
                    let mut other = filter();
                    other.state[j] += h;
                    other.advance(25.0, working);
                    other.state
                };
                let slope = (moved(1e-6) - moved(-1e-6)) / 2e-6;
                for i in 0..STATES {
                    assert!((slope[i] - f[(i, j)]).abs() < 1e-9, "{i} {j} {working}");
                }
            }
        }
    }

    #[test]
    fn one_touch_weighs_as_bayes_says_and_false_ones_are_refused_once() {
        let mut f = filter();
        // Prior variance 0.09 at the seen lag, touch 0.01: nine tenths of the way.
        assert_eq!(f.touch(0.3, 0.01), TouchOutcome::Taken);
        assert!(
            (f.share() - (0.2 + 0.9 * 0.1)).abs() < 1e-12
                && (f.sigma() - (0.09_f64 * 0.1).sqrt()).abs() < 1e-12
        );
        let before = f.clone();
        assert_eq!(f.touch(1.5, 0.01), TouchOutcome::Refused);
        assert_eq!((f.state, f.covariance), (before.state, before.covariance));
        assert_eq!(f.touch(1.45, 0.01), TouchOutcome::Reset);
        assert!((f.share() - 1.45).abs() < 0.02);
    }
}

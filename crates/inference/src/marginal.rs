//! Noise whose size is not known: sigma integrated out in closed form against what the repeats say of it
//! (MacKay 1992; Gelman et al. 2013, ch. 3).

use measurements::{FEWEST_FREEDOM, Repeats, STATED_FREEDOM};
use statistics::{ln_gamma, log_add, normal_cdf};

/// Share of the prior on noise as the repeats say; the rest is noise that they do not show.
const REPEATS_HOLD: f64 = 0.8;
/// Repeats are never trusted beyond so many degrees of freedom: they are near in time and place.
const MOST_FREEDOM: f64 = 60.0;
/// Noise can lie between these, metres.
pub const SIGMA_M: [f64; 2] = [1e-6, 3e-3];

/// The degrees of freedom that a stated sigma is worth.
const STATED: f64 = STATED_FREEDOM as f64;
/// A variance that is so many of its standard deviations less than another is another one.
const CLEARLY_LESS: f64 = 3.0;

/// The noise of a row of weight 1, from repeats or as stated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KnownNoise {
    /// Standard deviation of one coordinate, metres.
    pub sigma_m: f64,
    /// Degrees of freedom that it is worth.
    pub freedom: f64,
}

/// What is known of the noise before the fit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NoisePrior {
    /// Size of the noise, where repeats or a statement say one.
    pub known: Option<KnownNoise>,
    /// Whether repeats stand behind it; a statement alone can be wrong.
    pub from_repeats: bool,
    /// What was stated, where repeats show less: readings of a pose at about one time do not show noise that is slow.
    pub stated_more_m: Option<f64>,
}

impl NoisePrior {
    /// From the repeats; from `stated_m` where there are none, or where both agree.
    #[must_use]
    pub fn new(repeats: Option<&Repeats>, stated_m: Option<f64>) -> Self {
        let seen = repeats.filter(|r| r.degrees_of_freedom >= FEWEST_FREEDOM);
        let none = Self { known: None, from_repeats: false, stated_more_m: None };
        match (seen, stated_m) {
            // Both say the same: what they say together is worth what each is worth alone.
            (Some(r), Some(stated_m)) if is_consistent(r, stated_m) => {
                let seen = r.degrees_of_freedom as f64;
                let freedom = STATED + seen;
                let squares = STATED * stated_m * stated_m + seen * r.sigma_m * r.sigma_m;
                Self {
                    known: Some(KnownNoise {
                        sigma_m: (squares / freedom).sqrt(),
                        freedom: freedom.min(MOST_FREEDOM),
                    }),
                    from_repeats: true,
                    ..none
                }
            }
            (Some(r), _) => {
                let freedom = (r.degrees_of_freedom as f64).min(MOST_FREEDOM);
                Self {
                    known: Some(KnownNoise { sigma_m: r.sigma_m, freedom }),
                    from_repeats: true,
                    stated_more_m: stated_m.filter(|stated_m| *stated_m > r.sigma_m),
                }
            }
            (None, Some(sigma_m)) => Self { known: Some(KnownNoise { sigma_m, freedom: STATED }), ..none },
            (None, None) => none,
        }
    }

    /// With what visits show of the instrument's own noise: a variance `own_m2` of a row of weight 1, of so many degrees of freedom. Where that is
    /// less than is known, the latter has in it what the targets of a visit share.
    #[must_use]
    pub fn beside_visits(self, own_m2: f64, freedom: usize) -> Self {
        let Some(known) = self.known else { return self };
        let (known_m2, freedom) = (known.sigma_m.powi(2), freedom as f64);
        let ratio = own_m2 / known_m2;
        if freedom < STATED || ratio >= 1.0 {
            return self;
        }
        if ratio < 1.0 - CLEARLY_LESS * (2.0 / freedom).sqrt() {
            let known = KnownNoise { sigma_m: own_m2.sqrt(), freedom: freedom.min(MOST_FREEDOM) };
            return Self { known: Some(known), from_repeats: true, ..self };
        }
        if self.from_repeats {
            return self;
        }
        let sigma_m = ((STATED * known_m2 + freedom * own_m2) / (STATED + freedom)).sqrt();
        Self { known: Some(KnownNoise { sigma_m, ..known }), ..self }
    }

    /// Whether the repeats speak against the stated sigma.
    #[must_use]
    pub fn contradicted(repeats: Option<&Repeats>, stated_m: Option<f64>) -> bool {
        match (repeats.filter(|r| r.degrees_of_freedom >= FEWEST_FREEDOM), stated_m) {
            (Some(r), Some(sigma_m)) => !is_consistent(r, sigma_m),
            _ => false,
        }
    }

    /// The integral over sigma for `m` rows.
    #[must_use]
    pub fn marginal_over(&self, m: f64) -> Marginal {
        let (low_m, high_m, share) = match self.known {
            None => (SIGMA_M[0], SIGMA_M[1], 1.0),
            Some(KnownNoise { sigma_m, .. }) => {
                (sigma_m, (30.0 * sigma_m).max(SIGMA_M[1]), 1.0 - REPEATS_HOLD)
            }
        };
        let width = 1.0 / (2.0 * m).sqrt();
        let (low, high) = (low_m.ln(), high_m.ln());
        let log_uniform =
            share.ln() + (width * std::f64::consts::TAU.sqrt()).ln() - (high - low).ln() - 0.5 * m;
        let repeatability = self.known.map(|KnownNoise { sigma_m, freedom }| {
            let scatter = freedom * sigma_m * sigma_m;
            let constant = REPEATS_HOLD.ln() + 0.5 * freedom * (0.5 * scatter).ln() - ln_gamma(0.5 * freedom)
                + ln_gamma(0.5 * (m + freedom));
            Repeatability { scatter, freedom, constant }
        });
        Marginal { m, low, high, width, log_uniform, repeatability }
    }
}

/// Whether the repeats allow the stated sigma: both ends of the 99 % interval of their chi-square
/// (Wilson and Hilferty 1931).
fn is_consistent(repeats: &Repeats, stated_m: f64) -> bool {
    let v = repeats.degrees_of_freedom as f64;
    let end = |z: f64| {
        let c = 2.0 / (9.0 * v);
        (1.0 - c + z * c.sqrt()).powi(3)
    };
    let ratio = (repeats.sigma_m / stated_m).powi(2);
    (end(-2.576)..end(2.576)).contains(&ratio)
}

/// ln of the integral over ln sigma of prior times sigma^-m exp(-q / 2 sigma^2), prepared for many q.
#[derive(Clone, Copy, Debug)]
pub struct Marginal {
    m: f64,
    low: f64,
    high: f64,
    width: f64,
    log_uniform: f64,
    repeatability: Option<Repeatability>,
}

#[derive(Clone, Copy, Debug)]
struct Repeatability {
    scatter: f64,
    freedom: f64,
    constant: f64,
}

/// An integral over the noise.
#[derive(Clone, Copy, Debug)]
pub struct NoiseIntegral {
    /// Natural logarithm of the integral.
    pub log: f64,
    /// The sigma that carries it, metres.
    pub sigma_m: f64,
}

impl Marginal {
    /// The integral at sum of squares `q`.
    #[must_use]
    pub fn at(&self, q: f64) -> NoiseIntegral {
        let q = q.max(1e-300);
        let m = self.m;
        // Log-uniform between bounds; the mass within them by the normal shape of ln sigma.
        let at = 0.5 * (q / m).ln();
        let mass = normal_cdf((self.high - at) / self.width) - normal_cdf((self.low - at) / self.width);
        let log_uniform = self.log_uniform - m * at + mass.max(1e-300).ln();
        let Some(h) = self.repeatability else {
            return NoiseIntegral { log: log_uniform, sigma_m: at.exp() };
        };
        // ln of the integral of sigma^-m e^(-q/2s^2) over the repeats' own posterior.
        let repeatability = h.constant - 0.5 * (m + h.freedom) * (0.5 * (q + h.scatter)).ln();
        let sigma_m =
            if repeatability > log_uniform { ((q + h.scatter) / (m + h.freedom)).sqrt() } else { at.exp() };
        NoiseIntegral { log: log_add(repeatability, log_uniform), sigma_m }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use statistics::log_sum;

    #[test]
    fn sigma_is_integrated_as_a_fine_sum_does() {
        let (m, q) = (120.0, 120.0 * 2.5e-5_f64.powi(2));
        for known in [None, Some(KnownNoise { sigma_m: 2e-5, freedom: 30.0 })] {
            let noise = NoisePrior { known, from_repeats: known.is_some(), stated_more_m: None };
            let steps = 40_000;
            let (low, high) = (SIGMA_M[0].ln(), 3e-3_f64.ln());
            let h = (high - low) / f64::from(steps);
            let sum = log_sum((0..steps).map(|i| {
                let x = low + h * (f64::from(i) + 0.5);
                let likelihood = -m * x - 0.5 * q * (-2.0 * x).exp();
                let flat = |from: f64| if x > from { 1.0 / (high - from) } else { 0.0 };
                let prior = match known {
                    None => flat(low),
                    Some(KnownNoise { sigma_m: s, freedom: v }) => {
                        let c = 0.5 * v * s * s;
                        let repeatability = (2.0_f64.ln() + 0.5 * v * c.ln()
                            - ln_gamma(0.5 * v)
                            - v * x
                            - c * (-2.0 * x).exp())
                        .exp();
                        REPEATS_HOLD * repeatability + (1.0 - REPEATS_HOLD) * flat(s.ln())
                    }
                };
                likelihood + (prior * h).ln()
            }));
            let NoiseIntegral { log, .. } = noise.marginal_over(m).at(q);
            assert!((log - sum).abs() < 0.05, "{known:?}: {log} {sum}");
        }
    }
    #[test]
    fn a_statement_and_repeats_that_agree_are_taken_together() {
        let repeats = Repeats { sigma_m: 4e-5, degrees_of_freedom: 6 };
        let NoisePrior { known: Some(KnownNoise { sigma_m, freedom }), from_repeats: true, .. } =
            NoisePrior::new(Some(&repeats), Some(3e-5))
        else {
            panic!()
        };
        // (20 · 9 + 6 · 16) / 26 of 1e-10 m²
        assert!((sigma_m - 3.258_12e-5).abs() < 1e-10 && freedom == 26.0, "{sigma_m} {freedom}");
        // Three times the statement in 60 degrees of freedom contradict it.
        let repeats = Repeats { sigma_m: 9e-5, degrees_of_freedom: 60 };
        assert!(NoisePrior::contradicted(Some(&repeats), Some(3e-5)));
        assert_eq!(
            NoisePrior::new(Some(&repeats), Some(3e-5)).known,
            Some(KnownNoise { sigma_m: 9e-5, freedom: 60.0 })
        );
    }

    /// Of nothing, of one term, of two that are the same, and of one so far below that it is less than rounding.
    #[test]
    fn sums_of_exponentials_are_those_of_the_terms() {
        let none = f64::NEG_INFINITY;
        assert_eq!(log_sum([]), none);
        assert_eq!(log_sum([none, none]), none);
        assert_eq!(log_sum([none, -3.0, none]), -3.0);
        assert!((log_sum([5.0, 5.0]) - (5.0 + std::f64::consts::LN_2)).abs() < 1e-15);
        assert_eq!(log_sum([1.0, -50.0]), 1.0);
        assert!((log_sum([1.0, -20.0]) - 1.0 - (-21.0_f64).exp()).abs() < 1e-15);
    }
}

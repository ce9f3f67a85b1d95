//! Functions of the normal, gamma and F distributions.

/// Density of the normal distribution.
#[must_use]
#[inline]
pub fn normal_pdf(x: f64, mean: f64, sigma: f64) -> f64 {
    let z = (x - mean) / sigma;
    (-0.5 * z * z).exp() / (sigma * std::f64::consts::TAU.sqrt())
}

/// Standard normal distribution function (Abramowitz and Stegun 1964, 26.2.17), error below 1e-7.
#[must_use]
#[inline]
pub fn normal_cdf(z: f64) -> f64 {
    if z.abs() > 8.0 {
        return f64::from(u8::from(z > 0.0));
    }
    let t = 1.0 / (1.0 + 0.231_641_9 * z.abs());
    let poly = t
        * (0.319_381_530
            + t * (-0.356_563_782 + t * (1.781_477_937 + t * (-1.821_255_978 + t * 1.330_274_429))));
    let tail = normal_pdf(z.abs(), 0.0, 1.0) * poly;
    if z > 0.0 { 1.0 - tail } else { tail }
}

/// ln of the gamma function (Lanczos 1964, g = 7).
#[must_use]
pub fn ln_gamma(x: f64) -> f64 {
    const C: [f64; 9] = [
        0.999_999_999_999_809_9,
        676.520_368_121_885_1,
        -1_259.139_216_722_402_8,
        771.323_428_777_653_1,
        -176.615_029_162_140_6,
        12.507_343_278_686_905,
        -0.138_571_095_265_720_12,
        9.984_369_578_019_572e-6,
        1.505_632_735_149_311_6e-7,
    ];
    let x = x - 1.0;
    let t = x + 7.5;
    let sum = C[0] + C[1..].iter().zip(1..).map(|(c, i)| c / (x + f64::from(i))).sum::<f64>();
    0.5 * std::f64::consts::TAU.ln() + (x + 0.5) * t.ln() - t + sum.ln()
}

/// The ratio of two estimates of one variance, of `above` and `below` degrees of freedom, that is exceeded as often as a
/// normal variate exceeds `z` (Paulson 1942, An approximate normalization of the analysis of variance distribution).
#[must_use]
pub fn variance_ratio(z: f64, above: f64, below: f64) -> f64 {
    let (a, b) = (2.0 / (9.0 * above), 2.0 / (9.0 * below));
    let square = (1.0 - b).powi(2) - z * z * b;
    if square <= 0.0 {
        return f64::INFINITY; // so few repeats tell nothing of the noise
    }
    let middle = (1.0 - a) * (1.0 - b);
    let root = (middle * middle - square * ((1.0 - a).powi(2) - z * z * a)).max(0.0).sqrt();
    ((middle + root) / square).powi(3)
}

#[cfg(test)]
mod tests {
    use super::*;
    #[test]
    fn special_functions_match_tables() {
        // ln Gamma(0.5) = ln sqrt(pi); Gamma(10) = 9!; Phi(1.96) = 0.975002 (Abramowitz and Stegun).
        assert!((ln_gamma(0.5) - 0.5 * std::f64::consts::PI.ln()).abs() < 1e-12);
        assert!((ln_gamma(10.0) - 362_880.0_f64.ln()).abs() < 1e-10);
        assert!((normal_cdf(1.96) - 0.975_002).abs() < 1e-6);
        assert!((normal_cdf(-1.96) - 0.024_998).abs() < 1e-6);
    }

    /// Upper 1 % and 5 % points of F as tables of the distribution give them.
    #[test]
    fn ratios_are_those_of_the_f_tables() {
        for (z, above, below, table) in [
            (2.326_348, 120.0, 20.0, 2.52),
            (2.326_348, 10.0, 10.0, 4.85),
            (2.326_348, 60.0, 120.0, 1.66),
            (1.644_854, 20.0, 30.0, 1.93),
        ] {
            let found = variance_ratio(z, above, below);
            assert!((found / table - 1.0).abs() < 0.015, "{above} {below}: {found}");
        }
        assert_eq!(variance_ratio(2.878, 100.0, 1.0), f64::INFINITY);
    }
}

//! Sums of numbers that are held as their logarithms.

/// A term so far below another, nats, is less than 1e-18 of it.
const NOTHING_NATS: f64 = 42.0;

/// ln(e^a + e^b) without overflow.
#[must_use]
#[inline]
pub fn log_add(a: f64, b: f64) -> f64 {
    let (high, low) = if a > b { (a, b) } else { (b, a) };
    // What is so far below is less than rounding wherever the larger is not itself nearly 0.
    let is_nothing = low == f64::NEG_INFINITY || low - high < -NOTHING_NATS;
    if is_nothing { high } else { high + (low - high).exp().ln_1p() }
}

/// ln of the sum of exponentials.
#[must_use]
pub fn log_sum(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(f64::NEG_INFINITY, log_add)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_are_those_of_the_exponentials() {
        assert!(
            (log_sum([1.0, 2.0, 3.0]) - (1.0_f64.exp() + 2.0_f64.exp() + 3.0_f64.exp()).ln()).abs() < 1e-14
        );
        // Beyond what a double holds: e^1000 + e^1000.
        assert!((log_add(1000.0, 1000.0) - 1000.0 - 2.0_f64.ln()).abs() < 1e-12);
        assert_eq!((log_add(3.0, -100.0), log_add(f64::NEG_INFINITY, -7.0)), (3.0, -7.0));
        assert_eq!(log_sum([]), f64::NEG_INFINITY);
    }
}

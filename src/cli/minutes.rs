//! Warm-up minutes as an option: `0,5,37.5` or `FROM:TO:STEP`.

use std::str::FromStr;
use thiserror::Error;

/// Warm-up minutes, as listed; never empty.
#[derive(Clone, Debug, PartialEq)]
pub struct Minutes(pub Vec<f64>);

/// Minutes that cannot be read.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{0}; write a list such as 0,5,37.5 or FROM:TO:STEP such as 0:180:1")]
pub struct MinutesError(String);

/// Longest list: a year of minutes.
const MOST: f64 = 525_600.0;

impl FromStr for Minutes {
    type Err = MinutesError;

    fn from_str(text: &str) -> Result<Self, MinutesError> {
        let number = |field: &str| match field.trim().parse::<f64>() {
            Ok(value) if value.is_finite() => Ok(value),
            _ => Err(MinutesError(format!("`{}` is not a number", field.trim()))),
        };
        let minutes = if text.contains(':') {
            let fields = text.split(':').map(number).collect::<Result<Vec<f64>, _>>()?;
            let (from, to, step) = match fields[..] {
                [from, to] => (from, to, 1.0),
                [from, to, step] => (from, to, step),
                _ => return Err(MinutesError(format!("`{text}` is no range"))),
            };
            if step <= 0.0 || to < from {
                return Err(MinutesError(format!("`{text}` does not run forward")));
            }
            // A step such as 0.1 that ends on TO but for rounding ends on it.
            let steps = ((to - from) / step + 1e-9).floor();
            if steps > MOST {
                return Err(MinutesError(format!("`{text}` is more than {MOST} minutes")));
            }
            (0..=steps as u32).map(|i| from + f64::from(i) * step).collect()
        } else {
            text.split(',').map(number).collect::<Result<Vec<f64>, _>>()?
        };
        match minutes.iter().find(|minute| !(0.0..=MOST).contains(*minute)) {
            Some(minute) if *minute < 0.0 => {
                Err(MinutesError(format!("minute {minute} is before the cold start, which is minute 0")))
            }
            Some(minute) => {
                Err(MinutesError(format!("minute {minute:e} is later than a year, {MOST} minutes")))
            }
            None => Ok(Self(minutes)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Vec<f64> {
        text.parse::<Minutes>().unwrap().0
    }

    #[test]
    fn lists_and_ranges_are_read() {
        assert_eq!(read("0,5, 37.5"), [0.0, 5.0, 37.5]);
        assert_eq!(read("7"), [7.0]);
        assert_eq!(read("0:180:1").len(), 181);
        assert_eq!(read("0:180"), read("0:180:1"));
        assert_eq!(read("0:1:0.1").len(), 11);
        assert_eq!(read("10:16:4"), [10.0, 14.0]);
    }

    #[test]
    fn what_is_no_list_is_refused() {
        for text in [
            "", "a", "0:", "1:0:1", "0:10:0", "0:10:-1", "-5", "0,-1", "nan", "0:inf:1", "1:2:3:4",
            "0:1e9:1", "1e300", "0,525601",
        ] {
            assert!(text.parse::<Minutes>().is_err(), "{text}");
        }
    }
}

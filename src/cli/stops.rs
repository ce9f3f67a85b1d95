//! `--stop`: when a robot stood while it was touched or measured.

use rapid_syntax::diagnostic::Diagnostic;
use warm_up::Standstill;

/// The option that names stops.
#[derive(Clone, Debug, clap::Args)]
pub struct StopArgs {
    /// The robot stood from one minute to another; repeatable, or none [default: in the long pauses between readings].
    #[arg(long, value_name = "FROM:TO|none", allow_hyphen_values = true)]
    pub stop: Vec<String>,
}

/// The word for a robot that never stood.
const NONE: &str = "none";

impl StopArgs {
    /// The stops that are named, minutes; `None` where nothing is said of them.
    ///
    /// # Errors
    /// `fit::stop` of what is no time, and of `none` beside a stop.
    pub fn stops(&self) -> Result<Option<Vec<Standstill>>, Diagnostic> {
        let named: Vec<&String> = self.stop.iter().filter(|text| *text != NONE).collect();
        if let Some(first) = named.first().filter(|_| named.len() < self.stop.len()) {
            return Err(refused(first, "goes with no --stop none: the robot stood, or it did not")
                .help("leave one of them out"));
        }
        if self.stop.is_empty() {
            return Ok(None);
        }
        named.into_iter().map(|text| stop(text)).collect::<Result<_, _>>().map(Some)
    }

    /// Refuses a stop of which no reading can tell, as none comes after it began.
    ///
    /// # Errors
    /// `fit::stop`, with the minute of the last reading.
    pub fn check_before(&self, last_min: f64) -> Result<(), Diagnostic> {
        for text in self.stop.iter().filter(|text| *text != NONE) {
            if stop(text)?.from_min >= last_min {
                let why = format!("begins after the last reading, at minute {last_min:.0}: it says nothing");
                return Err(refused(text, &why)
                    .help("FROM:TO are minutes from the cold start, as t_min is, not seconds"));
            }
        }
        Ok(())
    }
}

/// Reads a standstill written `FROM:TO`, minutes.
fn stop(text: &str) -> Result<Standstill, Diagnostic> {
    let number = |t: &str| t.trim().parse::<f64>().ok().filter(|t| t.is_finite());
    let wrong =
        |why: &str| refused(text, why).help("write FROM:TO in minutes, the earlier one first, e.g. 120:165");
    let (from, to) = text.split_once(':').ok_or_else(|| wrong("cannot be read"))?;
    let (Some(from_min), Some(to_min)) = (number(from), number(to)) else {
        return Err(wrong("cannot be read"));
    };
    if from_min < 0.0 {
        return Err(wrong("begins before the cold start, which is minute 0"));
    }
    if to_min <= from_min {
        return Err(wrong("takes no time"));
    }
    Ok(Standstill { from_min, to_min })
}

/// The same for an option that is one stop alone.
pub fn one_stop(text: &str) -> Result<Standstill, String> {
    stop(text).map_err(|refusal| {
        [Some(refusal.message), refusal.help].into_iter().flatten().collect::<Vec<_>>().join("; ")
    })
}

fn refused(text: &str, why: &str) -> Diagnostic {
    Diagnostic::error("fit::stop", format!("--stop {text} {why}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(texts: &[&str]) -> StopArgs {
        StopArgs { stop: texts.iter().map(|text| (*text).to_owned()).collect() }
    }

    #[test]
    fn stops_are_minutes_that_readings_follow_or_none_alone() {
        let stop = |from_min, to_min| Standstill { from_min, to_min };
        assert_eq!(of(&[]).stops(), Ok(None));
        assert_eq!(of(&["none"]).stops(), Ok(Some(Vec::new())));
        assert_eq!(
            of(&["120:165", "200:210"]).stops(),
            Ok(Some(vec![stop(120.0, 165.0), stop(200.0, 210.0)]))
        );
        for (texts, why) in [
            (vec!["120:165", "none"], "goes with no --stop none"),
            (vec!["-10:20"], "begins before the cold start"),
            (vec!["165:120"], "takes no time"),
            (vec!["120"], "cannot be read"),
            (vec!["a:b"], "cannot be read"),
        ] {
            let refusal = of(&texts).stops().unwrap_err();
            assert!(refusal.code == "fit::stop" && refusal.message.contains(why), "{refusal:?}");
        }
        let seconds = of(&["7200:9900"]);
        assert!(seconds.check_before(9000.0).is_ok());
        let refusal = seconds.check_before(225.0).unwrap_err();
        assert!(refusal.message.contains("after the last reading, at minute 225"), "{refusal:?}");
    }
}

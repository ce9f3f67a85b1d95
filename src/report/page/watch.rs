//! The page of `link watch`: what a controller's corrected programs have shown so far, written anew while it goes on.

use super::{Page, write_page};
use serde_json::{Value, json};
use std::io::{self, Write};

/// Observations that a page holds; of more every second of the older ones goes.
const MOST_OBSERVATIONS: usize = 4_000;
/// The last observations are never thinned out.
const LATEST: usize = 500;
/// As many warnings, the latest.
const MOST_WARNINGS: usize = 50;

/// What was seen so far; the caller says when.
#[derive(Clone, Debug, Default)]
pub struct WatchPage {
    /// The controller's address as it was given.
    pub host: String,
    /// What one observation after the other found: the lines of `--json`, those of one together.
    observations: Vec<Vec<Value>>,
    /// How many there were.
    seen: usize,
    /// Seconds since the start, and what went wrong.
    warnings: Vec<(f64, String)>,
    /// Why nothing follows; `None` while it goes on.
    pub ended: Option<String>,
}

impl WatchPage {
    /// Nothing seen yet of `host`.
    #[must_use]
    pub fn new(host: String) -> Self {
        Self { host, ..Self::default() }
    }

    /// Adds an observation; whether it shows something other than the time to be gone on: another mode, bucket or message.
    pub fn add(&mut self, observation: Vec<Value>) -> bool {
        let is_news = self.observations.last().is_none_or(|before| {
            before.len() != observation.len()
                || before.iter().zip(&observation).any(|(a, b)| state(a) != state(b))
        });
        self.seen += 1;
        self.observations.push(observation);
        if self.observations.len() > MOST_OBSERVATIONS {
            let older = self.observations.len() - LATEST;
            let mut i = 0;
            self.observations.retain(|_| {
                i += 1;
                i > older || i % 2 == 1
            });
        }
        is_news
    }

    /// Adds a warning, at so many seconds since the start.
    pub fn warn(&mut self, t_s: f64, text: String) {
        self.warnings.push((t_s, text));
        let many = self.warnings.len().saturating_sub(MOST_WARNINGS);
        self.warnings.drain(..many);
    }

    /// Writes the page; `written_s` is the time of day in seconds since 1970, `every_s` how often it is written.
    ///
    /// # Errors
    /// What writing to `out` fails with.
    pub fn write(&self, written_s: f64, every_s: f64, out: &mut dyn Write) -> io::Result<()> {
        let data = json!({
            "records": self.observations.iter().flatten().collect::<Vec<_>>(),
            "seen": self.seen, "shown": self.observations.len(),
            "warnings": self.warnings.iter().map(|(t_s, text)| json!({ "t_s": t_s, "text": text })).collect::<Vec<_>>(),
            "ended": self.ended, "written_s": written_s, "every_s": every_s,
        });
        write_page(out, &Page { command: "link watch", title: self.host.clone(), data, view: json!({}) })
    }
}

/// What of a record is no measure of time.
fn state(record: &Value) -> [&Value; 4] {
    let values = &record["values"];
    [&record["module"], &record["said"], &values["tcMode"], &values["tcBucket"]]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn observation(i: usize, bucket: usize) -> Vec<Value> {
        vec![
            json!({ "module": "A", "said": null, "t_s": i, "values": { "tcMode": -1, "tcBucket": bucket, "tcMinute": i } }),
        ]
    }

    #[test]
    fn another_bucket_is_news_and_another_minute_is_not() {
        let mut page = WatchPage::new("cell3".to_owned());
        let news: Vec<bool> =
            [(0, 1), (1, 1), (2, 2), (3, 2)].map(|(i, b)| page.add(observation(i, b))).into();
        assert_eq!(news, [true, false, true, false]);
    }

    /// A week of observations a second apart: the page stays small, has the first and all of the latest in their order.
    #[test]
    fn a_long_watch_is_thinned_out_from_its_older_end() {
        let mut page = WatchPage::new("cell3".to_owned());
        let news = (0..100_000).filter(|&i| page.add(observation(i, 1))).count();
        assert_eq!(news, 1, "only the first");
        (0..100).for_each(|i| page.warn(f64::from(i), "no answer".to_owned()));
        let times: Vec<u64> =
            page.observations.iter().map(|observation| observation[0]["t_s"].as_u64().unwrap()).collect();
        assert!(
            times.len() <= MOST_OBSERVATIONS && times.len() > MOST_OBSERVATIONS / 2 - LATEST,
            "{}",
            times.len()
        );
        assert!(times.is_sorted_by(|a, b| a < b) && times[0] == 0);
        assert!(times.ends_with(&Vec::from_iter(99_500..100_000)));
        assert_eq!((page.seen, page.warnings.len(), page.warnings[0].0), (100_000, MOST_WARNINGS, 50.0));
    }
}

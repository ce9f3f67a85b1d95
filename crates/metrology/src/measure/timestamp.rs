//! Dates and times of day as instruments write them.

use robot_model::units::min_from_s;

/// How a date and time is written: YYYY, MM, DD, hh, mm, ss stand for numbers, all else for itself.
#[derive(Clone, Debug)]
pub struct TimestampFormat {
    format: String,
    parts: Vec<Part>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Part {
    Year,
    Month,
    Day,
    Hour,
    Minute,
    Second,
    Literal(char),
}

impl TimestampFormat {
    /// Reads a format such as `DD.MM.YYYY hh:mm:ss`.
    ///
    /// # Errors
    /// Without day or minute no time can be told.
    pub fn new(format: &str) -> Result<Self, String> {
        let words = [
            ("YYYY", Part::Year),
            ("MM", Part::Month),
            ("DD", Part::Day),
            ("hh", Part::Hour),
            ("mm", Part::Minute),
            ("ss", Part::Second),
        ];
        let mut parts = Vec::new();
        let mut rest = format;
        while let Some(first) = rest.chars().next() {
            let word = words.iter().find(|(word, _)| rest.starts_with(word));
            parts.push(word.map_or(Part::Literal(first), |(_, part)| *part));
            rest = &rest[word.map_or(first.len_utf8(), |(word, _)| word.len())..];
        }
        let has = |part| parts.contains(&part);
        if !(has(Part::Hour) && has(Part::Minute)) || has(Part::Day) != (has(Part::Month) && has(Part::Year))
        {
            return Err(format!("time_format {format}: hh and mm are needed, and YYYY, MM, DD all or none"));
        }
        Ok(Self { format: format.to_owned(), parts })
    }

    /// As it was given.
    #[must_use]
    pub fn format(&self) -> &str {
        &self.format
    }

    /// Minutes since some moment that is the same for all stamps.
    #[must_use]
    pub fn parse_min(&self, text: &str) -> Option<f64> {
        // Spreadsheets mark text by an apostrophe.
        let mut rest = text.trim().trim_start_matches('\'');
        let (mut year, mut month, mut day, mut hour, mut minute, mut second_s) = (1970, 1, 1, 0, 0, 0.0);
        for part in &self.parts {
            if let Part::Literal(c) = part {
                rest = rest.strip_prefix(*c)?;
                continue;
            }
            let digits = rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len());
            let (number, after) = rest.split_at(digits);
            let value: i64 = number.parse().ok()?;
            rest = after;
            match part {
                Part::Year => year = value,
                Part::Month => month = value,
                Part::Day => day = value,
                Part::Hour => hour = value,
                Part::Minute => minute = value,
                Part::Second | Part::Literal(_) => {
                    second_s = value as f64;
                    if let Some(fraction) = rest.strip_prefix(['.', ',']) {
                        let digits = fraction.find(|c: char| !c.is_ascii_digit()).unwrap_or(fraction.len());
                        second_s += format!("0.{}", &fraction[..digits]).parse::<f64>().ok()?;
                        rest = &fraction[digits..];
                    }
                }
            }
        }
        let sane = rest.is_empty()
            && (1..=12).contains(&month)
            && (1..=31).contains(&day)
            && hour < 24
            && minute < 60
            && second_s < 61.0
            && (1..100_000).contains(&year);
        sane.then(|| (days(year, month, day) * 1440 + hour * 60 + minute) as f64 + min_from_s(second_s))
    }
}

/// Days since 1970-01-01 (Hinnant 2013, days_from_civil).
fn days(year: i64, month: i64, day: i64) -> i64 {
    let year = if month <= 2 { year - 1 } else { year };
    let era = year.div_euclid(400);
    let of_era = year.rem_euclid(400);
    let of_year = (153 * ((month + 9) % 12) + 2) / 5 + day - 1;
    era * 146_097 + of_era * 365 + of_era / 4 - of_era / 100 + of_year - 719_468
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stamps_count_minutes_over_midnight_months_and_leap_days() {
        let timestamp = TimestampFormat::new("DD.MM.YYYY hh:mm:ss").unwrap();
        let from = timestamp.parse_min("'28.02.2024 23:59:30.500").unwrap();
        let to = timestamp.parse_min("1.03.2024 00:00:30").unwrap();
        // 2024 has a 29 February: a day and 59.5 s between.
        assert!((to - from - 1440.0 - 59.5 / 60.0).abs() < 1e-6, "{}", to - from);
        assert_eq!(
            TimestampFormat::new("YYYY-MM-DDThh:mm").unwrap().parse_min("1970-01-02T01:30"),
            Some(1530.0)
        );
        assert_eq!(timestamp.parse_min("30.13.2024 00:00:00"), None);
        assert_eq!(timestamp.parse_min("30.12.2024 00:00"), None);
        assert!(TimestampFormat::new("DD hh:mm").is_err());
    }
}

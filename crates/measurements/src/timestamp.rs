//! Dates and times of day as instruments write them.

use robot_model::units::{min_from_days, min_from_h, min_from_s};

/// Of times of day without a date a step back by more than this is midnight, hours.
const MIDNIGHT_H: f64 = 12.0;

/// How a date and time is written: YYYY, MM, DD, hh, mm, ss stand for numbers, all else for itself.
#[derive(Clone, Debug)]
pub(super) struct TimestampFormat {
    format: String,
    parts: Vec<Part>,
}

/// Why a text is no time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum NoTime {
    /// It is written otherwise.
    NotWrittenSo,
    /// It is written so, and no calendar or clock has it: a 30 February, an hour 25.
    DoesNotExist,
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

/// A date and a time of day, whether any calendar has it or not.
struct CivilTime {
    year: i64,
    month: i64,
    day: i64,
    hour: i64,
    minute: i64,
    second_s: f64,
}

impl TimestampFormat {
    /// Reads a format such as `DD.MM.YYYY hh:mm:ss`.
    ///
    /// # Errors
    /// A format without hour or minute, or with a part of a date.
    pub(super) fn new(format: &str) -> Result<Self, String> {
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
        let of_date = [Part::Year, Part::Month, Part::Day].into_iter().filter(|part| has(*part)).count();
        if !(has(Part::Hour) && has(Part::Minute) && [0, 3].contains(&of_date)) {
            return Err(format!("time_format {format}: hh and mm are needed, and YYYY, MM, DD all or none"));
        }
        Ok(Self { format: format.to_owned(), parts })
    }

    /// As it was given.
    #[must_use]
    pub(super) fn format(&self) -> &str {
        &self.format
    }

    /// Whether it says the day, too.
    pub(super) fn has_date(&self) -> bool {
        self.parts.contains(&Part::Day)
    }

    /// Minutes since some moment that is the same for all stamps.
    ///
    /// # Errors
    /// Text that is written otherwise, and a date or a time of day that does not exist.
    pub(super) fn parse_min(&self, text: &str) -> Result<f64, NoTime> {
        let written = self.numbers(text).ok_or(NoTime::NotWrittenSo)?;
        let CivilTime { year, month, day, hour, minute, second_s } = written;
        let exists = (1..100_000).contains(&year)
            && (1..=12).contains(&month)
            && (1..=days_of_month(year, month)).contains(&day)
            && hour < 24
            && minute < 60
            && second_s < 61.0;
        let whole_min = |days: i64| min_from_days(days as f64) + min_from_h(hour as f64) + minute as f64;
        let at_min = || whole_min(days(year, month, day)) + min_from_s(second_s);
        exists.then(at_min).ok_or(NoTime::DoesNotExist)
    }

    /// The date and the time of day as they are written.
    fn numbers(&self, text: &str) -> Option<CivilTime> {
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
        rest.is_empty().then_some(CivilTime { year, month, day, hour, minute, second_s })
    }
}

/// Minutes of times of day, `clock_min`, with the days that they leave out: a step back by more than half a day is midnight, where all
/// other steps go forward by less. Rows in any other order, or with a mistyped stamp, stay as they are and are warned about as such.
pub(super) fn over_midnight(clock_min: &[f64]) -> Vec<f64> {
    let midnight_min = min_from_h(MIDNIGHT_H);
    let mut day_min = 0.0;
    let mut all = Vec::with_capacity(clock_min.len());
    for (k, &at_min) in clock_min.iter().enumerate() {
        let step_min = at_min - clock_min[k.saturating_sub(1)];
        if step_min < -midnight_min {
            day_min += min_from_days(1.0);
        } else if !(0.0..=midnight_min).contains(&step_min) {
            return clock_min.to_vec();
        }
        all.push(day_min + at_min);
    }
    all
}

/// Days of a month of the Gregorian calendar, from 1.
fn days_of_month(year: i64, month: i64) -> i64 {
    let next = if month == 12 { days(year + 1, 1, 1) } else { days(year, month + 1, 1) };
    next - days(year, month, 1)
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
            Ok(1530.0)
        );
        for missing in
            ["30.13.2024 00:00:00", "30.02.2024 00:00:00", "29.02.2023 00:00:00", "29.02.1900 00:00:00"]
        {
            assert_eq!(timestamp.parse_min(missing), Err(NoTime::DoesNotExist), "{missing}");
        }
        for missing in
            ["31.04.2024 00:00:00", "00.04.2024 00:00:00", "01.04.2024 24:00:00", "01.04.2024 00:60:00"]
        {
            assert_eq!(timestamp.parse_min(missing), Err(NoTime::DoesNotExist), "{missing}");
        }
        assert_eq!(timestamp.parse_min("01.01.9223372036854775807 00:00:00"), Err(NoTime::DoesNotExist));
        for there in ["29.02.2024 00:00:00", "29.02.2000 23:59:60", "31.12.2024 00:00:00"] {
            assert!(timestamp.parse_min(there).is_ok(), "{there}");
        }
        assert_eq!(timestamp.parse_min("30.12.2024 00:00"), Err(NoTime::NotWrittenSo));
        for part_of_a_date in
            ["DD hh:mm", "MM hh:mm", "YYYY hh:mm", "MM.YYYY hh:mm", "DD.MM hh:mm", "YYYY DD hh:mm"]
        {
            assert!(TimestampFormat::new(part_of_a_date).is_err(), "{part_of_a_date}");
        }
    }

    /// 23:30, 23:50, 0:10, 0:30: minutes 1410, 1430, and 10, 30 of the next day, which has 1440 more.
    #[test]
    fn times_of_day_in_order_go_on_over_midnight() {
        assert_eq!(over_midnight(&[1410.0, 1430.0, 10.0, 30.0]), [1410.0, 1430.0, 1450.0, 1470.0]);
        assert_eq!(over_midnight(&[1300.0, 100.0, 800.0, 20.0]), [1300.0, 1540.0, 2240.0, 2900.0]);
        // Not in order, newest first, and one stamp among others that is mistyped.
        for other in
            [&[1410.0, 10.0, 1430.0, 30.0][..], &[30.0, 10.0, 1430.0, 1410.0], &[1300.0, 180.0, 1320.0]]
        {
            assert_eq!(over_midnight(other), other);
        }
        assert_eq!(over_midnight(&[]), [0.0; 0]);
    }
}

//! Date, time of day and a steady clock; all advance only when told to.

use robot_model::units::{DAY_S, HOUR_S, MINUTE_S, min_from_h, seconds_from_min};

/// Date, time of day and steady clock of a controller.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Calendar {
    /// Seconds since the controller's first start: never set back.
    steady_s: f64,
    /// What of it date and time have gone on by.
    shown_s: f64,
    /// Date and time shown, in seconds since 1970-01-01 00:00:00, where `shown_s` is 0.
    zero_s: f64,
    /// What every operation takes, so that midnight can fall between two of them.
    pub step_s: f64,
    /// Date and time stand still (moves and waits do not advance them).
    pub held: bool,
}

impl Default for Calendar {
    /// 2026-06-15 (a Monday) 08:00:00; operations take no time.
    fn default() -> Self {
        let zero_s = (days_from_civil(2026, 6, 15) * DAY_S + 8 * HOUR_S) as f64;
        Self { steady_s: 0.0, shown_s: 0.0, zero_s, step_s: 0.0, held: false }
    }
}

/// Days since 1970-01-01 of a date of the Gregorian calendar (Hinnant 2014, `days_from_civil`).
fn days_from_civil(year: i64, month: u32, day: u32) -> i64 {
    let y = if month <= 2 { year - 1 } else { year };
    let era = y.div_euclid(400);
    let yoe = y - era * 400;
    let doy = (153 * (i64::from(month) + if month > 2 { -3 } else { 9 }) + 2) / 5 + i64::from(day) - 1;
    let doe = yoe * 365 + yoe / 4 - yoe / 100 + doy;
    era * 146_097 + doe - 719_468
}

/// The date of days since 1970-01-01: year, month, day (Hinnant 2014, `civil_from_days`).
fn civil_from_days(days: i64) -> (i64, u32, u32) {
    let z = days + 719_468;
    let era = z.div_euclid(146_097);
    let doe = z - era * 146_097;
    let yoe = (doe - doe / 1460 + doe / 36_524 - doe / 146_096) / 365;
    let doy = doe - (365 * yoe + yoe / 4 - yoe / 100);
    let mp = (5 * doy + 2) / 153;
    let day = (doy - (153 * mp + 2) / 5 + 1) as u32;
    let month = (if mp < 10 { mp + 3 } else { mp - 9 }) as u32;
    (yoe + era * 400 + i64::from(month <= 2), month, day)
}

impl Calendar {
    /// Set date and time; the steady clock goes on.
    pub fn set(&mut self, date: (i64, u32, u32), time: (u32, u32, f64)) {
        let day_s = days_from_civil(date.0, date.1.clamp(1, 12), date.2.clamp(1, 31)) * DAY_S;
        let seconds = seconds_from_min(min_from_h(f64::from(time.0)) + f64::from(time.1)) + time.2;
        self.zero_s = day_s as f64 + seconds - self.shown_s;
    }

    /// Move date and time by minutes (back where negative); the steady clock goes on.
    pub fn shift_min(&mut self, minutes_min: f64) {
        self.zero_s += seconds_from_min(minutes_min);
    }

    /// Let seconds pass; date and time of day go on unless they are held.
    pub fn advance_s(&mut self, seconds_s: f64) {
        if seconds_s.is_finite() && seconds_s > 0.0 {
            self.steady_s += seconds_s;
            if !self.held {
                self.shown_s += seconds_s;
            }
        }
    }

    /// Let minutes pass, also where date and time are held against moves and waits.
    pub fn advance_min(&mut self, minutes_min: f64) {
        let held = std::mem::replace(&mut self.held, false);
        self.advance_s(seconds_from_min(minutes_min));
        self.held = held;
    }

    /// The steady clock, seconds.
    #[must_use]
    pub fn steady_s(&self) -> f64 {
        self.steady_s
    }

    /// Date and time shown, in whole seconds since 1970-01-01.
    fn whole_s(&self) -> i64 {
        // A microsecond keeps a sum of minutes from falling short of its second.
        (self.zero_s + self.shown_s + 1e-6).floor() as i64
    }

    /// The date shown: year, month, day.
    #[must_use]
    pub fn date(&self) -> (i64, u32, u32) {
        civil_from_days(self.whole_s().div_euclid(DAY_S))
    }

    /// The time of day shown: hour, minute, second.
    #[must_use]
    pub fn time(&self) -> (u32, u32, u32) {
        let s = self.whole_s().rem_euclid(DAY_S);
        ((s / HOUR_S) as u32, (s % HOUR_S / MINUTE_S) as u32, (s % MINUTE_S) as u32)
    }

    /// 1 Monday ... 7 Sunday.
    #[must_use]
    pub fn weekday(&self) -> u32 {
        (self.whole_s().div_euclid(DAY_S) + 3).rem_euclid(7) as u32 + 1
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dates_are_those_of_the_calendar() {
        let mut c = Calendar::default();
        assert_eq!((c.date(), c.time(), c.weekday()), ((2026, 6, 15), (8, 0, 0), 1));
        c.set((2023, 12, 31), (23, 59, 59.0)); // a Sunday
        assert_eq!(c.weekday(), 7);
        c.advance_s(1.0);
        assert_eq!((c.date(), c.time(), c.weekday()), ((2024, 1, 1), (0, 0, 0), 1));
        c.set((2024, 2, 28), (12, 0, 0.0));
        c.advance_min(24.0 * 60.0);
        assert_eq!(c.date(), (2024, 2, 29));
        c.shift_min(-60.0);
        assert_eq!(c.time(), (11, 0, 0));
        assert_eq!(c.steady_s(), 86_401.0);
    }

    #[test]
    fn held_time_stands_but_the_steady_clock_runs() {
        let mut c = Calendar { held: true, ..Calendar::default() };
        c.advance_s(30.0);
        assert_eq!((c.time(), c.steady_s()), ((8, 0, 0), 30.0));
        c.advance_min(1.0);
        assert_eq!(c.time(), (8, 1, 0));
        // However many the moves: a second that is shown never comes back.
        for _ in 0..100_000 {
            c.advance_s(0.005);
            assert_eq!(c.time(), (8, 1, 0));
        }
        assert!((c.steady_s() - 590.0).abs() < 1e-3);
    }
}

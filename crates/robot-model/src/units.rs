//! Conversion between the units people write (mm, degrees, minutes) and SI.
//!
//! The only place in the program with a conversion factor. Inside, lengths are metres, angles radians;
//! mm and degrees exist only where RAPID, CSV or TOML is read and written.

/// Metres from millimetres.
#[inline]
#[must_use]
pub fn m_from_mm(mm: f64) -> f64 {
    mm / 1000.0
}

/// Millimetres from metres.
#[inline]
#[must_use]
pub fn mm_from_m(m: f64) -> f64 {
    m * 1000.0
}

/// Radians from degrees.
#[inline]
#[must_use]
pub fn rad_from_deg(deg: f64) -> f64 {
    deg.to_radians()
}

/// Degrees from radians.
#[inline]
#[must_use]
pub fn deg_from_rad(rad: f64) -> f64 {
    rad.to_degrees()
}

/// Milliradians from radians.
#[inline]
#[must_use]
pub fn mrad_from_rad(rad: f64) -> f64 {
    rad * 1000.0
}

/// Milliseconds, as RAPID's clocks count, from seconds.
#[inline]
#[must_use]
pub fn ms_from_s(s: f64) -> f64 {
    s * 1000.0
}

/// Seconds from milliseconds, as scenarios and RAPID's clocks give them.
#[inline]
#[must_use]
pub fn seconds_from_ms(ms: f64) -> f64 {
    ms / 1000.0
}

/// Kilograms from grams.
#[inline]
#[must_use]
pub fn kg_from_g(g: f64) -> f64 {
    g / 1000.0
}

/// Grams of a mass in kilograms, as a thousand make one.
#[inline]
#[must_use]
pub fn g_from_kg(kg: f64) -> f64 {
    kg * 1000.0
}

/// Degrees Fahrenheit from degrees Celsius.
#[inline]
#[must_use]
pub fn fahrenheit_from_celsius(celsius: f64) -> f64 {
    celsius * 1.8 + 32.0
}

/// Degrees Celsius from degrees Fahrenheit.
#[inline]
#[must_use]
pub fn celsius_from_fahrenheit(fahrenheit: f64) -> f64 {
    (fahrenheit - 32.0) / 1.8
}

/// Degrees Celsius from kelvin.
#[inline]
#[must_use]
pub fn celsius_from_kelvin(kelvin: f64) -> f64 {
    kelvin - 273.15
}

/// Seconds from minutes.
#[inline]
#[must_use]
pub fn seconds_from_min(min: f64) -> f64 {
    min * 60.0
}

/// Metres from inches (exact since 1959).
#[inline]
#[must_use]
pub fn m_from_inch(inch: f64) -> f64 {
    m_from_mm(inch * 25.4)
}

/// Inches of a length in metres: an inch is 25.4 mm.
#[inline]
#[must_use]
pub fn inch_from_m(m: f64) -> f64 {
    mm_from_m(m) / 25.4
}

/// Minutes from seconds.
#[inline]
#[must_use]
pub fn min_from_s(seconds_s: f64) -> f64 {
    seconds_s / 60.0
}

/// Minutes from hours.
#[inline]
#[must_use]
pub fn min_from_h(h: f64) -> f64 {
    h * 60.0
}

/// Hours from minutes.
#[inline]
#[must_use]
pub fn h_from_min(min: f64) -> f64 {
    min / 60.0
}

/// Minutes from days.
#[inline]
#[must_use]
pub fn min_from_days(days: f64) -> f64 {
    days * 1440.0
}

/// Minutes of a year of 365 days.
pub const YEAR_MIN: f64 = 525_600.0;
/// Seconds of a day, as calendars without leap seconds count them.
pub const DAY_S: i64 = 86_400;
/// Seconds of an hour.
pub const HOUR_S: i64 = 3_600;
/// Seconds of a minute.
pub const MINUTE_S: i64 = 60;

/// A ratio from parts per million.
#[inline]
#[must_use]
pub fn ratio_from_ppm(ppm: f64) -> f64 {
    ppm * 1e-6
}

/// Parts per million from a ratio.
#[inline]
#[must_use]
pub fn ppm_from_ratio(ratio: f64) -> f64 {
    ratio * 1e6
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn conversions_are_exact_where_the_numbers_are() {
        assert_eq!(m_from_mm(352.0), 0.352);
        assert_eq!(m_from_inch(10.0), 0.254);
        assert_eq!(inch_from_m(0.254), 10.0);
        assert_eq!(fahrenheit_from_celsius(20.0), 68.0);
        assert_eq!(g_from_kg(1.5), 1500.0);
        assert_eq!(min_from_s(90.0), 1.5);
        assert_eq!(min_from_h(1.5), 90.0);
        assert_eq!(h_from_min(90.0), 1.5);
        assert_eq!(min_from_days(2.0), 2880.0);
        assert_eq!(ratio_from_ppm(250_000.0), 0.25);
        assert_eq!(ppm_from_ratio(0.25), 250_000.0);
        assert_eq!(mm_from_m(0.25), 250.0);
        assert_eq!(rad_from_deg(180.0), std::f64::consts::PI);
        assert_eq!(deg_from_rad(std::f64::consts::FRAC_PI_2), 90.0);
    }
}

//! Minutes that look like hours or seconds: by how far they go on from one stop of the arm to the next.

use rapid_syntax::diagnostic::Diagnostic;
use robot_model::units::min_from_days;

/// Fewer gaps tell no unit.
const FEWEST_GAPS: usize = 8;
/// No arm goes to another pose, settles and is measured in less, minutes: three seconds.
const QUICKEST_MIN: f64 = 0.05;
/// A usual gap between two poses that is shorter is none of seconds, minutes: whoever measures takes five of them.
const LEAST_SECONDS: f64 = 5.0;
/// A rest that people make at night, minutes.
const NIGHT_MIN: f64 = 360.0;

/// Where the arm stood, and when.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct TimedStop {
    /// Minute, as written.
    pub t_min: f64,
    /// Minute of a clock that goes on over all sessions.
    pub clock_min: f64,
    /// Which pose or point: rows of one follow each other as quickly as an instrument reads.
    pub stand: usize,
}

/// The warning of times of `stops`, in any order, that are of another unit than minutes, or before the cold start.
pub(super) fn time_unit(stops: impl Iterator<Item = TimedStop>) -> Option<Diagnostic> {
    let mut stops: Vec<TimedStop> = stops.collect();
    sorting::by(&mut stops, |a, b| a.clock_min.total_cmp(&b.clock_min));
    let first_min = stops.iter().map(|stop| stop.t_min).min_by(f64::total_cmp)?;
    let text = other_unit(&stops).or_else(|| {
        (first_min < 0.0).then(|| {
            format!(
                "t_min begins at {first_min}: before the cold start nothing is known of how warm the arm is"
            )
        })
    })?;
    Some(Diagnostic::warning("measure::time-unit", text).help("write minutes since the cold start; --columns MAP.toml with time_unit = \"s\", \"h\" or \"d\" converts them"))
}

/// What speaks for hours, days or seconds in `stops`, which are in order of time.
fn other_unit(stops: &[TimedStop]) -> Option<String> {
    let changes = stops.windows(2).filter(|pair| pair[0].stand != pair[1].stand);
    let all_min: Vec<f64> = changes.map(|pair| pair[1].clock_min - pair[0].clock_min).collect();
    // Rounds of several points are often written with one minute.
    let mut gaps_min: Vec<f64> = all_min.iter().copied().filter(|gap_min| *gap_min > 0.0).collect();
    if gaps_min.len() < FEWEST_GAPS {
        return None;
    }
    let each_min = all_min.iter().sum::<f64>() / all_min.len() as f64;
    let nights = gaps_min.iter().filter(|gap_min| **gap_min >= NIGHT_MIN).count() as f64;
    let usual_min = statistics::median(&mut gaps_min);
    let span_min = stops.last()?.clock_min - stops.first()?.clock_min;
    let days = span_min / min_from_days(1.0);
    if let Some(quick_min) = [usual_min, each_min].into_iter().find(|between| *between < QUICKEST_MIN) {
        let usual_s = 60.0 * quick_min;
        return Some(format!(
            "t_min goes on by {usual_s:.2} seconds from one pose to the next, and by {span_min:.2} minutes in all: are these hours or days?"
        ));
    }
    (usual_min >= LEAST_SECONDS && days >= 1.0 && 2.0 * nights < days.floor()).then(|| {
        format!(
            "t_min goes on by {usual_min:.0} minutes from one pose to the next, and over {days:.1} days without a night's rest: are these seconds?"
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn said(minutes: impl Iterator<Item = f64>) -> Option<String> {
        let stops = minutes.enumerate().map(|(stand, t_min)| TimedStop { t_min, clock_min: t_min, stand });
        time_unit(stops).map(|warning| warning.message)
    }

    /// A hundred poses in three hours, 108 s apart.
    fn three_hours() -> impl Iterator<Item = f64> {
        (0..100).map(|k| 1.8 * f64::from(k))
    }

    #[test]
    fn minutes_say_nothing() {
        assert_eq!(said(three_hours()), None);
        // Three shifts with nights between them, a pose every ten minutes.
        let shifts = (0..144).map(|k| 10.0 * f64::from(k) + 960.0 * f64::from(k / 48));
        assert_eq!(said(shifts), None);
        // Four days of a pose every six hours.
        assert_eq!(said((0..16).map(|k| 360.0 * f64::from(k))), None);
        // A night run, and a camera that takes a pose every four seconds.
        assert_eq!(said((0..90).map(|k| 15.0 * f64::from(k))), None);
        assert_eq!(said((0..90).map(|k| f64::from(k) / 15.0)), None);
    }

    #[test]
    fn hours_days_and_seconds_are_asked_about() {
        let hours = said(three_hours().map(|t_min| t_min / 60.0)).unwrap();
        assert!(hours.contains("by 1.80 seconds from one pose to the next, and by 2.97 minutes"), "{hours}");
        let days = said(three_hours().map(|t_min| t_min / 1440.0)).unwrap();
        assert!(days.contains("by 0.08 seconds") && days.contains("hours or days"), "{days}");
        let seconds = said(three_hours().map(|t_min| t_min * 60.0)).unwrap();
        assert!(seconds.contains("by 108 minutes from") && seconds.contains("over 7.4 days"), "{seconds}");
        // With a coffee break of a quarter of an hour.
        let with_break = three_hours().map(|t_min| 60.0 * (t_min + if t_min > 90.0 { 15.0 } else { 0.0 }));
        assert!(said(with_break).unwrap().contains("seconds?"));
    }

    #[test]
    fn rows_of_one_pose_may_follow_each_other_quickly() {
        let rows = three_hours().enumerate().flat_map(|(stand, t_min)| {
            let reading = move |k| t_min + 0.001 * f64::from(k);
            (0..5).map(move |k| TimedStop { t_min: reading(k), clock_min: reading(k), stand })
        });
        assert_eq!(time_unit(rows), None);
    }

    #[test]
    fn points_of_one_round_may_have_one_minute() {
        let rounds = (0..20).flat_map(|round| (0..8).map(move |stand| (5.0 * f64::from(round), stand)));
        let stops = rounds.map(|(t_min, stand)| TimedStop { t_min, clock_min: t_min, stand });
        assert_eq!(time_unit(stops), None);
    }

    #[test]
    fn rounds_of_several_points_are_no_quicker_than_their_points() {
        let rounds =
            (0..20).flat_map(|round| (0..8).map(move |stand| (5.0 / 60.0 * f64::from(round), stand)));
        let stops = rounds.map(|(t_min, stand)| TimedStop { t_min, clock_min: t_min, stand });
        // 95 minutes in hours are 1.58, over 159 changes of the point.
        let said = time_unit(stops).unwrap().message;
        assert!(said.contains("by 0.60 seconds") && said.contains("1.58 minutes in all"), "{said}");
    }

    #[test]
    fn minutes_before_the_cold_start_are_told() {
        let early = said(three_hours().map(|t_min| t_min - 20.0)).unwrap();
        assert_eq!(
            early,
            "t_min begins at -20: before the cold start nothing is known of how warm the arm is"
        );
    }
}

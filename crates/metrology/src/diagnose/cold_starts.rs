//! Nights that a file's clock goes on over, and hours before its first row: an arm that has stood still for hours is cold again, and what warms
//! up begins anew.
//!
//! Whether it did the data say.

use super::clock_reading::{ClockReading, MOST_STATIONS};
use super::outcome::Warning;
use measurements::{Station, Stations};
use robot_model::units::h_from_min;

/// A gap this long may be a cold start: an arm is settled in as long, and cools about as slowly (docs/PAPER.md).
const LONG_MIN: f64 = 240.0;
/// In fewer stations behind it nothing warms up that could be told.
const FEWEST_BEHIND: usize = 12;

/// The stations of a file whose clock goes on over pauses of hours, or begins hours after a cold start, with minutes since the cold start before
/// each; `None` of another, or where minutes begin anew already.
#[must_use]
pub(super) fn cold_starts(stations: &Stations) -> Option<ClockReading> {
    let all = &stations.stations;
    if !stations.channels.time || all.len() > MOST_STATIONS || all.iter().any(|s| s.earlier_min != 0.0) {
        return None;
    }
    let mut order: Vec<(f64, &Station)> = all.iter().filter_map(|s| Some((s.t_min?, s))).collect();
    sorting::by(&mut order, |a, b| a.0.total_cmp(&b.0));
    let is_long = |pair: &[(f64, &Station)]| pair[1].0 - pair[0].0 >= LONG_MIN;
    // A clock that begins hours late may be that of the day.
    let first = order.first().filter(|(t_min, _)| *t_min >= LONG_MIN).map(|_| 0);
    let later = (1..order.len()).filter(|&at| is_long(&order[at - 1..=at]));
    let behind: Vec<usize> = first.into_iter().chain(later).collect();
    let ends = behind.iter().skip(1).copied().chain([order.len()]);
    if behind.is_empty() || behind.iter().zip(ends).any(|(from, to)| to - from < FEWEST_BEHIND) {
        return None;
    }
    let starts: Vec<f64> = behind.iter().map(|&at| order[at].0).collect();
    let before_min = |at: usize| at.checked_sub(1).map_or(0.0, |before| order[before].0);
    let pauses: Vec<(u64, f64)> =
        behind.iter().map(|&at| (order[at].1.line, order[at].0 - before_min(at))).collect();
    let last = *starts.last()?;
    let anew = |station: &Station| {
        let start = starts.iter().rev().find(|start| station.t_min.is_some_and(|t_min| t_min >= **start));
        let start = start.copied().unwrap_or(0.0);
        let t_min = station.t_min.map(|t_min| t_min - start);
        Station { t_min, earlier_min: last - start, ..station.clone() }
    };
    Some(ClockReading {
        stations: Stations { stations: all.iter().map(anew).collect(), ..stations.clone() },
        warning: warning(&pauses),
    })
}

/// `pauses`: line of the first row behind each, and how long it was, minutes.
fn warning(pauses: &[(u64, f64)]) -> Warning {
    let pauses: Vec<String> =
        pauses.iter().map(|(line, min)| format!("{:.1} h before line {line}", h_from_min(*min))).collect();
    Warning {
        code: "diagnose::cold-start",
        message: format!(
            "t_min goes on over hours in which nothing was measured ({}), and behind it something warms up anew: minutes were counted from there. Write t_min since the cold start \
             before each row: a model of it is validated by the minutes as they stand in a file",
            pauses.join(", ")
        ),
    }
}

//! Pauses in which the robot stood and cooled: behind one it is less warm than the minutes since its cold start say.
//!
//! How fast it cools nobody knows beforehand: as fast as it warms, at one of a few time constants.

use super::clock_reading::{ClockReading, MOST_STATIONS};
use super::outcome::Warning;
use measurements::{Station, Stations};
use robot_model::deform::GrowthLaw;
use warm_up::{Standstill, long_gaps, warm_minutes};

/// Fewer stations before or behind a pause do not tell how the arm went on.
const FEWEST_BESIDE: usize = 12;
/// Time constants of warming and cooling that are tried, the usual one first, minutes.
const TAUS_MIN: [f64; 3] = [45.0, 20.0, 90.0];

/// The stations of a file with pauses at minutes at which the arm was as warm, running but for these; none of a file without.
#[must_use]
pub(super) fn standstills(stations: &Stations) -> Vec<ClockReading> {
    let stops = stops(stations);
    let all = &stations.stations;
    if stops.is_empty() {
        return Vec::new();
    }
    let t_min: Vec<f64> = all.iter().map(|station| station.t_min.unwrap_or_default()).collect();
    let with = |tau_min: f64| {
        let warm_min = warm_minutes(GrowthLaw::Exp { tau_min }, tau_min, &stops, &t_min);
        let as_warm = |(station, warm_min): (&Station, f64)| Station {
            t_min: station.t_min.map(|_| warm_min),
            // Steps go by the clock, which goes on.
            earlier_min: station.t_min.map_or(0.0, |t_min| warm_min - t_min),
            ..station.clone()
        };
        let at_warm_minutes = all.iter().zip(warm_min).map(as_warm).collect();
        ClockReading {
            stations: Stations { stations: at_warm_minutes, ..stations.clone() },
            warning: warning(&stops),
        }
    };
    TAUS_MIN.map(with).into()
}

/// The pauses of a file that are long beside its usual gaps, with enough stations before and behind each. Those of touches are told by the
/// rounds of a point ([`warm_up::pauses`]); poses that are measured once have none.
fn stops(stations: &Stations) -> Vec<Standstill> {
    let all = &stations.stations;
    if !stations.channels.time || all.len() > MOST_STATIONS || all.iter().any(|s| s.earlier_min != 0.0) {
        return Vec::new();
    }
    let mut times: Vec<f64> = all.iter().filter_map(|station| station.t_min).collect();
    sorting::numbers(&mut times);
    let has_enough = |stop: &Standstill| {
        let behind = times.partition_point(|t_min| *t_min < stop.to_min);
        (FEWEST_BESIDE..=times.len().saturating_sub(FEWEST_BESIDE)).contains(&behind)
    };
    long_gaps(&times).into_iter().filter(has_enough).collect()
}

fn warning(stops: &[Standstill]) -> Warning {
    let pauses: Vec<String> = stops.iter().map(ToString::to_string).collect();
    Warning {
        code: "diagnose::standstill",
        message: format!(
            "nothing was measured in minutes {}, and it is likelier that the robot stood and cooled then: behind it minutes count as many as it \
             would take a robot that runs to be as warm",
            pauses.join(", ")
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use measurements::{Measurements, gather};

    /// Stations a minute apart, at these minutes.
    fn stations(minutes: impl Iterator<Item = u32>) -> Stations {
        let mut text = "t_min,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n".to_owned();
        let mut rows = 0;
        for (k, t_min) in minutes.enumerate() {
            text.push_str(&format!("{t_min},{k},0,0,0,0,0,1,2,3\n"));
            rows = k + 1;
        }
        gather(&Measurements::from_csv(text.as_bytes()).unwrap(), &(0..rows).collect::<Vec<_>>(), None)
    }

    /// After minute 59 the robot stands for 41: by hand, exp(-59 / 45) is left to warm, and exp(-41 / 45) of what is warm stays.
    #[test]
    fn behind_a_pause_the_arm_is_as_warm_as_earlier() {
        let readings = standstills(&stations((0..60).chain(100..130)));
        assert_eq!(readings.len(), 3);
        let all = &readings[0].stations.stations;
        let left = (1.0 - (-59.0_f64 / 45.0).exp()) * (-41.0_f64 / 45.0).exp();
        let minute = -45.0 * (1.0 - left).ln();
        assert!((all[60].t_min.unwrap() - minute).abs() < 1e-9, "{:?} {minute}", all[60].t_min);
        assert_eq!((all[59].t_min, all[60].clock_min().map(f64::round)), (Some(59.0), Some(100.0)));
        assert!(readings[0].warning.message.contains("minutes 59:100"), "{}", readings[0].warning.message);
    }

    #[test]
    fn files_without_a_pause_have_no_such_reading() {
        assert!(standstills(&stations(0..90)).is_empty());
        assert!(standstills(&stations((0..60).chain(70..100))).is_empty(), "ten minutes");
        assert!(standstills(&stations((0..10).chain(100..190))).is_empty(), "ten stations before it");
        assert!(standstills(&stations((0..60).map(|k| 20 * k))).is_empty(), "as between all");
    }
}

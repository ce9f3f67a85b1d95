//! What a false row looks like: one number typed wrong, a joint that stood elsewhere, an arm that was still on its way.
//!
//! Of the distance that the model leaves, one direction is tried after the other; what leaves a tenth or less of it is
//! said, as a likeness and not as a finding: chance alone does as much once in twenty rows.

use super::measured_robot::MeasuredRobot;
use super::model::FittedModel;
use super::outcome::FalseRow;
use inference::dataset::{ObservationKind, Twist};
use inference::linearise::{Linearised, shift_m, turn_rad};
use measurements::{Reading, Stations};
use nalgebra::Vector3;
use robot_model::robot::Axis;
use robot_model::units::{deg_from_rad, mm_from_m};
use statistics::upper_median;

/// A likeness leaves at most this share of the distance.
const LEFT: f64 = 0.1;
/// What turns a flange moves its target by more than the turn at this distance, metres: a smaller shift is that of a turn misread.
const LEVER_M: f64 = 0.01;
const AXES: [&str; 3] = ["x", "y", "z"];

/// Every row set aside, in the file's order.
#[must_use]
pub(super) fn false_rows(measured: MeasuredRobot<'_>, fitted: &FittedModel<'_>) -> Vec<FalseRow> {
    let MeasuredRobot { measurements, stations, .. } = measured;
    let FittedModel { linear, model, .. } = fitted;
    let mut all = Vec::new();
    let middle_m =
        upper_median(&mut model.residuals.iter().map(shift_m).collect::<Vec<f64>>()).unwrap_or(0.0);
    for (i, station) in stations.stations.iter().enumerate().filter(|(i, _)| model.outliers[*i]) {
        let off_m = shift_m(&model.residuals[i]);
        for row in station.rows.iter().filter_map(|&r| measurements.rows.get(r)) {
            all.push(FalseRow {
                line: row.line,
                id: row.id.clone(),
                off_mm: Some(mm_from_m(off_m)),
                times_middle: Some(off_m / middle_m.max(1e-12)),
                looks_like: repeats_agree(station.rows.len())
                    .or_else(|| likeness(stations, linear, &model.residuals[i], i)),
            });
        }
    }
    for row in stations.false_rows.iter().filter_map(|&r| measurements.rows.get(r)) {
        let looks_like = Some("it does not agree with the other readings of its pose".to_owned());
        all.push(FalseRow {
            line: row.line,
            id: row.id.clone(),
            off_mm: None,
            times_middle: None,
            looks_like,
        });
    }
    sorting::by_key(&mut all, |row| row.line);
    all
}

/// What is said of a pose whose `readings` were taken together as they agree.
fn repeats_agree(readings: usize) -> Option<String> {
    (readings > 1).then(|| {
        format!(
            "{readings} readings of this pose agree with each other: not the reading is wrong, but the joints as written, or the arm here"
        )
    })
}

fn shift(twist: &Twist) -> Vector3<f64> {
    Vector3::new(twist[0], twist[1], twist[2])
}

/// As the instrument saw it.
fn measured_m(stations: &Stations, i: usize) -> Option<Vector3<f64>> {
    match stations.stations.get(i)?.reading {
        Reading::Point { position_m } => Some(position_m),
        _ => None,
    }
}

/// What would make a station be off by `left`, base axes.
fn likeness(stations: &Stations, linear: &Linearised, left: &Twist, i: usize) -> Option<String> {
    let observation = &linear.dataset.observations[i];
    if observation.kind != ObservationKind::Instrument {
        return None;
    }
    let place = shift(left);
    if place.norm() < LEVER_M * turn_rad(left) {
        return Some(format!(
            "its orientation is off by {:.2} deg, its point is not: the sensor read wrongly?",
            deg_from_rad(turn_rad(left))
        ));
    }
    let limit_m = LEFT * place.norm();
    // Before this row in the file: an arm that is still coming lies on the way from there.
    let observations = &linear.dataset.observations;
    let before = (0..observations.len()).filter(|&k| {
        observations[k].row < observation.row && observations[k].kind == ObservationKind::Instrument
    });
    if let Some(before) = before.reduce(|a, b| if observations[b].row > observations[a].row { b } else { a })
    {
        let (from, here) = (measured_m(stations, before)?, measured_m(stations, i)?);
        let into_base = linear.registration.instrument_from_base.rotation.inverse();
        let way = into_base * (from - here) + place;
        let along = way.dot(&place) / way.norm().max(1e-9);
        let aside = (place - way * (along / way.norm().max(1e-9))).norm();
        if aside < limit_m && (way - place).norm() < limit_m {
            return Some(
                "it is where the row before was measured: read before the arm had moved?".to_owned(),
            );
        }
        if along > 0.0 && along < way.norm() && aside < limit_m {
            let short = format!("it lies towards the row before, {:.3} mm short", mm_from_m(along));
            return Some(format!("{short}: read before the arm had arrived?"));
        }
    }
    let turned = linear.dataset.rows_per_observation == 6 && turn_rad(left) > 1e-3;
    let seen = linear.registration.instrument_from_base.rotation * place;
    let single = (0..3).find(|&k| {
        let others = Vector3::from_fn(|r, _| if r == k { 0.0 } else { seen[r] });
        !turned && others.norm() < limit_m
    });
    if let Some(k) = single {
        return Some(format!(
            "only its {} is off, by {:+.3} mm: a number typed wrong?",
            AXES[k],
            mm_from_m(seen[k])
        ));
    }
    (0..observation.joints()).find_map(|j| {
        let turn = observation.jacobian_column(j);
        let v = Vector3::new(turn[0], turn[1], turn[2]);
        let angle = v.dot(&place) / v.norm_squared().max(1e-12);
        let fits = (place - v * angle).norm() < limit_m && angle.abs() < 0.5;
        fits.then(|| {
            let elsewhere =
                format!("as if joint {} had stood {:+.4} deg elsewhere", Axis::at(j), deg_from_rad(angle));
            format!("{elsewhere}: an angle typed wrong?")
        })
    })
}

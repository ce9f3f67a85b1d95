//! What was solved for, as the terms of a model: from scaled columns to the file's values.

use super::payload_centre::centre_at;
use inference::dataset::Dataset;
use inference::design::Design;
use inference::effects::{Candidate, EffectVariant, along_link, held_above_n_m, soft, usual_compliance};
use inference::normal_equations::{JointLines, LINE_RAD, ModelColumns};
use inference::search::ChosenCause;
use nalgebra::DVector;
use robot_model::deform::EffectKind;
use robot_model::deform::identified::{
    Estimate, PayloadScaling, TILT_ABOUT_AXIS_1, TILT_SHIFT, Term, compliance_of_link,
};
use robot_model::robot::Axis;

/// What was solved for as terms: causes, the lines that were `named`, geometry, and the rest of the spectra.
#[must_use]
pub(super) fn terms(
    columns: &ModelColumns<'_>,
    named: &[&ChosenCause],
    candidates: &[Candidate],
    solved: &DVector<f64>,
    sigmas: Option<&[f64]>,
) -> Vec<Term> {
    let value = |column: usize, unit: f64| Estimate {
        value: solved[column] * unit,
        sigma: sigmas.and_then(|s| s.get(column)).map(|s| s * unit),
    };
    let mut terms = Vec::new();
    for (candidate, range) in columns.causes.iter().zip(columns.of_causes()) {
        let values = range
            .zip(&candidate.prior_sigma)
            .map(|(column, prior_sigma)| value(column, *prior_sigma))
            .collect();
        terms.extend(terms_of(columns.dataset, candidate, values));
    }
    let mut spectra: Vec<Vec<Estimate>> = Vec::new();
    let mut lines = Vec::new();
    for (JointLines { joint, periods }, range) in columns.lines.iter().zip(columns.of_lines()) {
        let last = periods.iter().max().map_or(0, |n| *n as usize);
        let none = Estimate { value: 0.0, sigma: sigmas.map(|_| 0.0) };
        let mut spectrum = vec![none; 2 * last];
        for (n, column) in periods.iter().zip(range.step_by(2)) {
            let pair = [value(column, LINE_RAD), value(column + 1, LINE_RAD)];
            let is_this = |variant: &EffectVariant| variant.joint == Some(*joint) && variant.n == Some(*n);
            let name = named.iter().position(|c| is_this(&candidates[c.candidate].variant));
            match name {
                Some(rank) => lines.push((rank, pair.to_vec())),
                None => spectrum[2 * *n as usize - 2..2 * *n as usize].copy_from_slice(&pair),
            }
        }
        spectra.push(spectrum);
    }
    sorting::by_key(&mut lines, |(rank, _)| *rank);
    for (rank, values) in lines {
        terms.extend(term(columns.dataset, &candidates[named[rank].candidate], values));
    }
    let geometry: Vec<usize> = columns.geometry().collect();
    if geometry.iter().any(|&column| solved[column].abs() > LEAST_TOLERANCES) {
        for (link, row) in geometry.chunks(6).enumerate() {
            let values = row.iter().enumerate().map(|(k, &column)| value(column, Design::tolerance(k)));
            let term = Term::plain(EffectKind::LinkGeometry, Some(Axis::at(link)), values.collect());
            terms.push(Term { cause: false, ..term });
        }
    }
    for (JointLines { joint, .. }, values) in columns.lines.iter().zip(spectra) {
        // A line that is named stands on its own; so does one beyond the spectrum's end.
        let end = values.iter().rposition(|v| v.value != 0.0).map_or(0, |last| last / 2 * 2 + 2);
        let values = values.into_iter().take(end).collect();
        terms.push(Term { cause: false, ..Term::plain(EffectKind::GearSpectrum, Some(*joint), values) });
    }
    terms
}

/// Geometry under so many tolerances is not there.
const LEAST_TOLERANCES: f64 = 1e-9;

/// The first `plain` values, then those of the links from `first` on, in a list of `all`.
fn by_link(values: Vec<Estimate>, plain: usize, first: usize, all: usize) -> Vec<Estimate> {
    let mut out = vec![Estimate::default(); all];
    for (k, value) in values.into_iter().enumerate() {
        if let Some(to) = out.get_mut(if k < plain { k } else { first + k }) {
            *to = value;
        }
    }
    out
}

/// Values of a compliance in the model's order: plain, of links, hardening and softening.
fn compliance(dataset: &Dataset, variant: &EffectVariant, values: &[Estimate]) -> Option<Vec<Estimate>> {
    let joint = variant.joint?.index();
    let mut out = vec![Estimate::default(); 10];
    out[0] = values.first().copied()?;
    for link in joint..dataset.joints() {
        *out.get_mut(compliance_of_link(link))? = values.get(1 + link - joint).copied().unwrap_or_default();
    }
    if variant.refined {
        let first = 1 + dataset.joints() - joint;
        let largest = dataset.large_torque_n_m(joint);
        // Both were as large as the linear one at the largest torque.
        for (k, unit) in [1.0 / largest, largest.sqrt()].into_iter().enumerate() {
            let value = values.get(first + k)?;
            out[7 + k] = Estimate { value: value.value * unit, sigma: value.sigma.map(|sigma| sigma * unit) };
        }
    }
    Some(out)
}

/// Values of a base that tilts in the model's order: both turns, of seven links, both shifts where it tilts about something else than joint 1's origin,
/// the turn about joint 1's axis where its face is inclined.
fn base_tilt(joints: usize, refined: bool, mut values: Vec<Estimate>) -> Vec<Estimate> {
    let mut beyond = values.split_off((2 + joints).min(values.len()));
    let shifts = beyond.split_off(beyond.len().saturating_sub(if refined { 2 } else { 0 }));
    if shifts.is_empty() && beyond.is_empty() {
        return values;
    }
    values.resize(TILT_SHIFT[0], Estimate::default());
    values.extend(shifts);
    if !beyond.is_empty() {
        values.resize(TILT_ABOUT_AXIS_1, Estimate::default());
        values.extend(beyond);
    }
    values
}

/// Values of a payload that is wrong in the model's order: kilograms, and how each joint gives under them.
fn payload_mass(dataset: &Dataset, scaling: PayloadScaling, values: &[Estimate]) -> Option<Vec<Estimate>> {
    let share = if scaling == PayloadScaling::PerKilogram { 1.0 / dataset.largest_payload_kg } else { 1.0 };
    let kg = *values.first()?;
    let soft = soft(dataset.joints());
    let gives = usual_compliance(&dataset.slides).into_iter().enumerate().map(|(j, give)| {
        let extra = soft.clone().position(|x| x == j).and_then(|k| values.get(k + 1));
        Estimate { value: share * give * (kg.value + extra.map_or(0.0, |e| e.value)), sigma: None }
    });
    let mass = Estimate { value: share * kg.value, sigma: kg.sigma.map(|sigma| share * sigma) };
    Some(std::iter::once(mass).chain(gives).collect())
}

/// A candidate's parameters as terms: its own, and the double frequency of a gear or the constant of a gain, which are no causes of
/// their own.
fn terms_of(dataset: &Dataset, candidate: &Candidate, mut values: Vec<Estimate>) -> Vec<Term> {
    if candidate.kind == EffectKind::JointOffset && candidate.variant.joint.is_none() {
        let of_joint = |(j, value)| Term::plain(candidate.kind, Some(Axis::at(j)), vec![value]);
        return values.into_iter().enumerate().map(of_joint).collect();
    }
    if candidate.kind == EffectKind::JointGain && candidate.variant.refined {
        let constant = Term::plain(EffectKind::JointOffset, candidate.variant.joint, values.split_off(1));
        let constant = Term { cause: false, ..constant };
        return term(dataset, candidate, values).into_iter().chain([constant]).collect();
    }
    let gear = matches!(candidate.kind, EffectKind::GearEccentricity | EffectKind::GearSecondHarmonic);
    let overtone = if gear && candidate.variant.refined { values.split_off(2) } else { Vec::new() };
    let double = candidate.variant.n.map(|n| 2 * n).filter(|_| !overtone.is_empty()).map(|n| {
        let kind = if n == 2 { EffectKind::GearSecondHarmonic } else { EffectKind::GearMesh };
        Term { n: Some(n), cause: false, ..Term::plain(kind, candidate.variant.joint, overtone) }
    });
    term(dataset, candidate, values).into_iter().chain(double).collect()
}

/// A candidate's parameters, in the order of its motions, as a term.
fn term(dataset: &Dataset, candidate: &Candidate, mut values: Vec<Estimate>) -> Option<Term> {
    let kind = candidate.kind;
    let variant = &candidate.variant;
    // Where the payload's centre lies is no part of the robot.
    values.truncate(centre_at(candidate, dataset.joints()).map_or(values.len(), |centre| centre.start));
    let payload_scaling = variant.payload_scaling;
    let values = match kind {
        EffectKind::JointCompliance => compliance(dataset, variant, &values)?,
        EffectKind::LinkBending => {
            let mut all = by_link(values, 2, variant.joint?.index() + 2, 10);
            if variant.refined {
                // By the moment alone: without the end force's part.
                all[2] = Estimate { value: -all[0].value, ..all[0] };
            }
            all
        }
        EffectKind::BaseTilt => base_tilt(dataset.joints(), variant.refined, values),
        EffectKind::PayloadMass => payload_mass(dataset, payload_scaling, &values)?,
        EffectKind::LinkGeometry if variant.refined => {
            let along = along_link(dataset.of_arm().next()?, variant.joint?.index())?;
            let length = values.first().copied()?;
            let part = |k: usize| Estimate {
                value: length.value * along[k],
                sigma: length.sigma.map(|sigma| sigma * along[k].abs()),
            };
            (0..3).map(part).chain(std::iter::repeat_n(Estimate::default(), 3)).collect()
        }
        // As calibrated before it changed.
        EffectKind::JointStep | EffectKind::ThermalJointDrift | EffectKind::ThermalLinkGrowth
            if !variant.refined =>
        {
            values.into_iter().chain([Estimate::default()]).collect()
        }
        // The model has a shift of the target, not its turn: the point is all that the model places.
        EffectKind::ToolDrift | EffectKind::ToolStep => values.into_iter().take(3).collect(),
        _ => values,
    };
    Some(Term {
        joint_b: variant.joint_b,
        n: variant.n,
        growth: variant.growth,
        held_above_n_m: held_above_n_m(variant, dataset),
        payload_scaling,
        ..Term::plain(kind, variant.joint, values)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnose::identify::{PredictedStations, predicted};
    use inference::dataset::{Observation, Twist};
    use inference::effects::testable_effects;
    use measurements::{Channels, Reading, Registration, Station};
    use nalgebra::{Isometry3, UnitQuaternion, Vector3};
    use robot_model::deform::identified::Identified;
    use robot_model::kinematics::SerialChain;
    use robot_model::robot::{Joints, SerialArm};
    use std::collections::BTreeSet;
    use std::sync::Arc;

    const TOOL_M: [f64; 3] = [0.04, -0.03, 0.11];

    /// Sixteen postures all over the ranges, times, payloads, directions and temperatures as different.
    fn stations(robot: &SerialArm, registration: &Registration) -> Vec<Station> {
        let chain = SerialChain::nominal(robot);
        let joints = robot.joints.len();
        (0..16_usize)
            .map(|k| {
                // Equidistributed by the golden section and its powers.
                let share = |j: usize| (0.5 + k as f64 * 0.618_034_f64.powi(j as i32 + 1)).fract();
                let mut station = Station {
                    pose: k,
                    target: 0,
                    stand: 0,
                    t_min: Some(7.0 * k as f64 + 3.0),
                    earlier_min: 0.0,
                    q_rad: Joints::from_fn(joints, |j| {
                        if robot.joints[j].kind.slides() { -0.2 * share(j) } else { 2.4 * share(j) - 1.2 }
                    }),
                    reading: Reading::Point { position_m: Vector3::zeros() },
                    orientation: Some(UnitQuaternion::identity()),
                    direction: Some(Joints::from_fn(joints, |j| if share(j + 1) < 0.5 { -1 } else { 1 })),
                    payload_kg: Some([0.0, 2.0, 3.5][k % 3]),
                    joint_temperature_c: Some(Joints::from_fn(joints, |j| 20.0 + 9.0 * share(j + 2))),
                    line: 0,
                    rows: vec![k],
                };
                let position_m = registration.predicted_m(&station, &station.pose(&chain));
                station.reading = Reading::Point { position_m };
                station
            })
            .collect()
    }

    /// Where a model puts the measured point against a true reading of it, and the flange.
    fn model_of(
        robot: &Arc<SerialArm>,
        stations: &[Station],
        registration: &Registration,
        terms: Vec<Term>,
    ) -> Vec<(Vector3<f64>, UnitQuaternion<f64>)> {
        let model = Arc::new(Identified { terms, ..Identified::default() });
        let PredictedStations { stations: scaled, poses } =
            predicted(robot, stations, &model, registration.payload_m());
        let apart = |(station, pose): (&Station, &Isometry3<f64>)| {
            let reading_m = station.reading.position_m().unwrap();
            (registration.predicted_m(station, pose) - reading_m, pose.rotation)
        };
        scaled.iter().zip(&poses).map(apart).collect()
    }

    /// The parameters that a model's term holds: not where the payload's centre lies, nor how a target turns.
    fn held(candidate: &Candidate, joints: usize) -> usize {
        match candidate.kind {
            EffectKind::ToolDrift | EffectKind::ToolStep => 3,
            _ => centre_at(candidate, joints).map_or(candidate.prior_sigma.len(), |centre| centre.start),
        }
    }

    /// Central differences of the exact arm under a model of one term, against the linear signature that the search works
    /// on: for every effect, joint and growth, every parameter, point and orientation.
    #[test]
    fn every_signature_is_the_derivative_of_the_same_effect_in_a_model() {
        check_signatures(SerialArm::built_in("irb140").unwrap());
    }

    #[test]
    fn so_it_is_for_arms_of_four_five_and_seven_joints_and_one_that_slides() {
        for text in [
            include_str!("../../../../fixtures/robots/scara.toml"),
            include_str!("../../../../fixtures/robots/palletiser.toml"),
            include_str!("../../../../fixtures/robots/five_axes.toml"),
            include_str!("../../../../fixtures/robots/seven_axes.toml"),
        ] {
            check_signatures(SerialArm::from_toml(text).unwrap());
        }
    }

    fn check_signatures(robot: SerialArm) {
        let robot = Arc::new(robot);
        let chain = SerialChain::nominal(&robot);
        let registration =
            Registration::assumed(Isometry3::identity(), vec![Vector3::from(TOOL_M)], Vec::new());
        let stations = stations(&robot, &registration);
        let observations: Vec<Observation> =
            stations.iter().map(|s| Observation::new(&robot, &chain, &registration, s)).collect();
        let channels = Channels {
            pose_id: true,
            time: true,
            orientation: true,
            direction: true,
            payload: true,
            joint_temperature: true,
        };
        let dataset = Dataset::new(&robot, observations, channels);
        let mut tried: BTreeSet<EffectKind> = BTreeSet::new();
        for candidate in testable_effects(&dataset).candidates {
            // Offsets of all joints at once are taken apart by the search; gear lines are all alike.
            if candidate.variant.n.is_some_and(|n| n > 3 && n != 40) {
                continue;
            }
            // Springs of all joints at once are held against causes, and stand in no model.
            if candidate.kind == EffectKind::JointCompliance && candidate.of_all_joints() {
                continue;
            }
            tried.insert(candidate.kind);
            let mut signatures: Vec<Vec<Twist>> = Vec::new();
            for observation in &dataset.observations {
                let mut out = Vec::new();
                candidate.effect().signature(&candidate.variant, dataset.at(observation), &mut out);
                signatures.push(out);
            }
            for k in 0..held(&candidate, dataset.joints()) {
                let step = candidate.prior_sigma[k];
                let at = |sign: f64| {
                    let value =
                        |i: usize| Estimate { value: if i == k { sign * step } else { 0.0 }, sigma: None };
                    let values = (0..candidate.prior_sigma.len()).map(value).collect();
                    let terms = terms_of(&dataset, &candidate, values);
                    model_of(&robot, &stations, &registration, terms)
                };
                let largest = signatures
                    .iter()
                    .flat_map(|all| all[k])
                    .fold(0.0, |most: f64, value| most.max(value.abs()));
                for (((p1, r1), (p0, r0)), all) in at(1.0).iter().zip(&at(-1.0)).zip(&signatures) {
                    let shift = (p1 - p0) / (2.0 * step);
                    let turn = (r1 * r0.inverse()).scaled_axis() / (2.0 * step);
                    let difference = [shift.x, shift.y, shift.z, turn.x, turn.y, turn.z];
                    for (difference, signature) in difference.iter().zip(&all[k]) {
                        assert!(
                            (difference - signature).abs() < 1e-6 * largest + 1e-9,
                            "{}, {:?} parameter {k}: {difference} by differences, {signature} by the signature",
                            robot.name,
                            (candidate.kind, &candidate.variant)
                        );
                    }
                }
            }
        }
        // All of the library but the faults of data and the spectrum, which is its lines.
        let not_tried: Vec<EffectKind> =
            EffectKind::ALL.into_iter().filter(|kind| !tried.contains(kind)).collect();
        assert_eq!(not_tried, [EffectKind::GearSpectrum, EffectKind::JointRounding, EffectKind::SwappedAxes]);
    }
}

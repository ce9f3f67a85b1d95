//! Repeats of a pose that stand all over a file: where it has no times the order of its rows is the clock, and a pose that was come back to in a
//! later round is another station; where it has, rounds that follow each other quickly are told apart where something changed between them.

use super::MeasurementRow;
use super::repeats::centre;
use nalgebra::{UnitQuaternion, Vector3};
use std::collections::BTreeMap;

/// Rows of one pose with more than this share of the file between them are of different rounds.
pub const ROUND_SHARE: f64 = 0.1;
/// What rows near each other in the file share, beyond chance: once in a thousand files (normal quantile).
const BEYOND_CHANCE: f64 = 3.090;

/// The rounds of a file in which poses are come back to.
pub(super) struct Rounds {
    /// Place of each row among those that are used.
    place: BTreeMap<usize, usize>,
    /// Whether repeats of different rounds differ as something that changed meanwhile makes them: they are no noise then.
    pub changed: bool,
}

/// How an instrument's axes stand to a row's flange, `flange_from_instrument`; `None` of a row without an arm's point.
pub(super) type FlangeTurn<'a> = &'a dyn Fn(&MeasurementRow) -> Option<UnitQuaternion<f64>>;

impl Rounds {
    /// Of a file; `None` where nothing was come back to, where its rows have times and nothing changed meanwhile, or where most poses were
    /// come back to, as often as need be for their mean, and nothing changed. What changes moves all poses alike in the instrument's axes, as
    /// a base does, or, where `flange` tells these, in the flange's, as a target does.
    pub(super) fn of(
        rows: &[MeasurementRow],
        groups: &[Vec<usize>],
        flange: Option<FlangeTurn<'_>>,
    ) -> Option<Self> {
        let mut used: Vec<usize> = groups.iter().flatten().copied().collect();
        sorting::ascending(&mut used);
        let is_timed = used.iter().filter_map(|&row| rows.get(row)).any(|row| row.t_min.is_some());
        let place = used.into_iter().enumerate().map(|(place, row)| (row, place)).collect();
        let rounds = Self { place, changed: false };
        let parts: Vec<Vec<Vec<usize>>> = groups.iter().map(|group| rounds.parts(group)).collect();
        let come_back_to = parts.iter().filter(|parts| parts.len() > 1).count();
        if come_back_to == 0 || is_timed && flange.is_none() {
            return None;
        }
        let in_instrument = |_: &MeasurementRow| Some(UnitQuaternion::identity());
        let changed = has_changed(rows, groups, &parts, &in_instrument)
            || flange.is_some_and(|flange| has_changed(rows, groups, &parts, flange));
        let mostly_once = 2 * come_back_to <= groups.len() && !is_timed;
        (changed || mostly_once).then_some(Self { changed, ..rounds })
    }

    /// Each group's rows of each round, in the order of their first rows.
    pub(super) fn apart(&self, groups: &[Vec<usize>]) -> Vec<Vec<usize>> {
        let mut apart: Vec<Vec<usize>> = groups.iter().flat_map(|group| self.parts(group)).collect();
        sorting::by_key(&mut apart, |group| group.first().copied());
        apart
    }

    /// A group's rows of each round.
    fn parts(&self, group: &[usize]) -> Vec<Vec<usize>> {
        let most = ROUND_SHARE * self.place.len() as f64;
        let place = |row: &usize| self.place.get(row).map_or(0.0, |&place| place as f64);
        group.chunk_by(|a, b| place(b) - place(a) <= most).map(<[usize]>::to_vec).collect()
    }
}

/// Whether the rounds' deviations from their poses' means, in axes that `turn` gives, point the same way in rows near each other.
fn has_changed(
    rows: &[MeasurementRow],
    groups: &[Vec<usize>],
    parts: &[Vec<Vec<usize>>],
    turn: FlangeTurn<'_>,
) -> bool {
    let mut deviations: Vec<(usize, usize, Vector3<f64>)> = Vec::new();
    let mut coordinates = 0;
    for (pose, (group, parts)) in
        groups.iter().zip(parts).enumerate().filter(|(_, (_, parts))| parts.len() > 1)
    {
        let middle = centre(rows, group);
        for part in parts {
            let Some((&first, row)) = part.first().and_then(|first| Some((first, rows.get(*first)?))) else {
                continue;
            };
            coordinates = coordinates.max(row.reading.coordinates().map_or(0, |read| read.count));
            // Directions alone: one false reading says no more than another row.
            let off = (centre(rows, part) - middle).try_normalize(0.0);
            deviations.extend(off.zip(turn(row)).map(|(off, turn)| (first, pose, turn * off)));
        }
    }
    sorting::by_key(&mut deviations, |(first, ..)| *first);
    let neighbours = deviations.windows(2).filter(|pair| pair[0].1 != pair[1].1);
    let cosines: Vec<f64> = neighbours.map(|pair| pair[0].2.dot(&pair[1].2)).collect();
    // The cosine of two directions by chance has the mean 0 and the variance 1 / dimensions.
    let sum: f64 = cosines.iter().sum();
    sum > BEYOND_CHANCE * (cosines.len() as f64 / coordinates.max(1) as f64).sqrt() && !cosines.is_empty()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Measurements, gather, gather_about};
    use nalgebra::Point3;
    use robot_model::kinematics::SerialChain;
    use robot_model::robot::{Joints, SerialArm};

    /// Poses in two rounds, the second `step_mm` further along x; scatter without a pattern.
    fn two_rounds(poses: usize, again: usize, step_mm: f64, times: bool) -> Measurements {
        let mut text = "pose_id,t_min,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n".to_owned();
        for k in 0..poses + again {
            let (pose, round) = if k < poses { (k, 0.0) } else { (k - poses, 1.0) };
            let at = |axis: usize| 0.02 * (((3 * k + axis + 1) as f64 * 12.9898).sin() * 43_758.547).fract();
            let t_min = if times { (30 * k).to_string() } else { String::new() };
            let x_mm = at(0) + round * step_mm;
            text.push_str(&format!("{pose},{t_min},{pose},0,0,0,0,0,{x_mm},{},{}\n", at(1), at(2)));
        }
        Measurements::from_csv(text.as_bytes()).unwrap()
    }

    fn stations_and_freedom(measurements: &Measurements) -> (usize, Option<usize>) {
        let used: Vec<usize> = (0..measurements.rows.len()).collect();
        let gathered = gather(measurements, &used, None);
        (gathered.stations.len(), gathered.repeats.map(|repeats| repeats.degrees_of_freedom))
    }

    /// 20 poses twice: the mean of both where nothing changed, 40 stations without a word of the noise where the second round is off.
    #[test]
    fn a_round_that_is_off_is_other_stations() {
        assert_eq!(stations_and_freedom(&two_rounds(20, 20, 0.0, false)), (20, Some(60)));
        assert_eq!(stations_and_freedom(&two_rounds(20, 20, 0.1, false)), (40, None));
    }

    /// Five of 40 poses again: stations of their own, and their scatter is the noise.
    #[test]
    fn a_few_poses_come_back_to_are_stations_and_noise() {
        assert_eq!(stations_and_freedom(&two_rounds(40, 5, 0.0, false)), (45, Some(15)));
    }

    /// As many poses again, and one read twice on the spot, 1 mm apart: one of the two is false, and both stand alone.
    #[test]
    fn repeats_that_contradict_each_other_stay_apart_in_their_round() {
        let mut all = two_rounds(40, 5, 0.0, false);
        let mut wrong = all.rows[39].clone();
        let position_m = wrong.reading.position_m().unwrap();
        wrong.reading = wrong.reading.with_coordinates_m(position_m + Vector3::new(1e-3, 0.0, 0.0));
        all.rows.insert(40, wrong);
        assert_eq!(stations_and_freedom(&all), (46, Some(15)));
    }

    /// With times these decide.
    #[test]
    fn times_decide_where_there_are_any() {
        let timed = two_rounds(20, 20, 0.0, true);
        let groups: Vec<Vec<usize>> = (0..20).map(|pose| vec![pose, pose + 20]).collect();
        assert!(Rounds::of(&timed.rows, &groups, None).is_none());
        assert_eq!(stations_and_freedom(&timed), (40, None));
    }

    /// Sixteen poses of an IRB 140 in two rounds, between which a target moves by 0.1 mm along x of the flange: anywhere in the instrument's axes.
    #[test]
    fn what_turns_with_the_flange_is_told_in_its_axes() {
        let chain = SerialChain::nominal(&SerialArm::built_in("irb140").unwrap());
        let mut text = "t_min,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n".to_owned();
        for k in 0..32 {
            let (pose, moved_mm) = (f64::from(k % 16), if k < 16 { 0.0 } else { 0.1 });
            let q_deg = [11.0, -7.0, 5.0, 83.0, 37.0, 61.0].map(|step: f64| (step * pose) % 90.0 - 20.0);
            let flange = chain.forward(&Joints::from(q_deg.map(f64::to_radians)));
            let noise = |axis: i32| 0.01 * (f64::from(7 * k + axis) * 12.9898).sin();
            let at = flange * Point3::new(0.05 + 1e-3 * moved_mm, 0.02, 0.1);
            let xyz = [at.x, at.y, at.z].map(|m| 1e3 * m);
            let cells: Vec<String> = q_deg.iter().map(f64::to_string).collect();
            let [x, y, z] = [0, 1, 2].map(|axis: i32| xyz[axis as usize] + noise(axis));
            text.push_str(&format!("{},{},{x},{y},{z}\n", 0.3 * f64::from(k), cells.join(",")));
        }
        let measured = Measurements::from_csv(text.as_bytes()).unwrap();
        let used: Vec<usize> = (0..32).collect();
        let axes = UnitQuaternion::identity();
        assert_eq!(gather(&measured, &used, None).stations.len(), 16);
        assert_eq!(gather_about(&measured, &used, None, (&chain, &axes)).stations.len(), 32);
    }
}

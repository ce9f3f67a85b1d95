//! Repeats of a pose that stand all over a file without times: the order of its rows is the clock, and a pose that was come back to in a
//! later round is another station.

use super::MeasurementRow;
use super::repeats::centre;
use nalgebra::Vector3;
use std::collections::BTreeMap;

/// Rows of one pose with more than this share of the file between them are of different rounds.
pub(crate) const ROUND_SHARE: f64 = 0.1;
/// What rows near each other in the file share, beyond chance: once in a thousand files (normal quantile).
const BEYOND_CHANCE: f64 = 3.090;

/// Groups of repeats, taken apart by rounds.
pub(super) struct Rounds {
    /// The groups of each round, in the order of their first rows.
    pub groups: Vec<Vec<usize>>,
    /// Whether repeats of different rounds differ as something that changed meanwhile makes them: they are no noise then.
    pub changed: bool,
}

/// The rounds of a file; `None` where its rows have times, where nothing was come back to, or where most poses were, as often as need be
/// for their mean, and nothing changed meanwhile.
pub(super) fn rounds(rows: &[MeasurementRow], groups: &[Vec<usize>]) -> Option<Rounds> {
    let place: BTreeMap<usize, usize> = {
        let mut used: Vec<usize> = groups.iter().flatten().copied().collect();
        used.sort_unstable();
        used.into_iter().enumerate().map(|(place, row)| (row, place)).collect()
    };
    if place.keys().filter_map(|&row| rows.get(row)).any(|row| row.t_min.is_some()) {
        return None;
    }
    let most = ROUND_SHARE * place.len() as f64;
    let parts: Vec<Vec<Vec<usize>>> = groups
        .iter()
        .map(|group| {
            let mut parts: Vec<Vec<usize>> = Vec::new();
            for &row in group {
                match parts.last_mut() {
                    Some(part)
                        if part.last().is_some_and(|last| (place[&row] - place[last]) as f64 <= most) =>
                    {
                        part.push(row);
                    }
                    _ => parts.push(vec![row]),
                }
            }
            parts
        })
        .collect();
    let come_back_to = parts.iter().filter(|parts| parts.len() > 1).count();
    let changed = has_changed(rows, groups, &parts);
    let mostly_once = 2 * come_back_to <= groups.len();
    (come_back_to > 0 && (changed || mostly_once)).then(|| {
        let mut groups: Vec<Vec<usize>> = parts.into_iter().flatten().collect();
        groups.sort_by_key(|group| group.first().copied());
        Rounds { groups, changed }
    })
}

/// Whether the rounds' deviations from their poses' means point the same way in rows near each other.
fn has_changed(rows: &[MeasurementRow], groups: &[Vec<usize>], parts: &[Vec<Vec<usize>>]) -> bool {
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
            deviations.extend(off.map(|off| (first, pose, off)));
        }
    }
    deviations.sort_by_key(|(first, ..)| *first);
    let neighbours = deviations.windows(2).filter(|pair| pair[0].1 != pair[1].1);
    let cosines: Vec<f64> = neighbours.map(|pair| pair[0].2.dot(&pair[1].2)).collect();
    // The cosine of two directions by chance has the mean 0 and the variance 1 / dimensions.
    let sum: f64 = cosines.iter().sum();
    sum > BEYOND_CHANCE * (cosines.len() as f64 / coordinates.max(1) as f64).sqrt() && !cosines.is_empty()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::{Measurements, gather};

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

    /// With times these decide.
    #[test]
    fn times_decide_where_there_are_any() {
        let timed = two_rounds(20, 20, 0.0, true);
        let groups: Vec<Vec<usize>> = (0..20).map(|pose| vec![pose, pose + 20]).collect();
        assert!(rounds(&timed.rows, &groups).is_none());
        assert_eq!(stations_and_freedom(&timed), (40, None));
    }
}

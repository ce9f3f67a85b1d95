//! Repeats of a pose: their scatter is the noise of one row, and which of them are false.

use super::MeasurementRow;
use nalgebra::Vector3;
use statistics::{UPPER_QUARTILE_NORM_3D, median, variance_ratio};

/// A repeat this many sigmas from its fellows is false and takes no part in the mean.
const FALSE_REPEAT: f64 = 7.0;
/// Repeats scatter by more than the others allow where that happens once in a thousand pairs (normal quantile).
const NO_REPEAT: f64 = 3.090;
/// Repeats with fewer degrees of freedom than this say nothing of the noise.
pub const FEWEST_FREEDOM: usize = 6;
/// A sigma that is only stated is worth so many degrees of freedom: statements are 1.4 times off.
pub const STATED_FREEDOM: usize = 20;

/// What the repeats say about the noise of one row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Repeats {
    /// Standard deviation of one coordinate of one row, metres.
    pub sigma_m: f64,
    /// Degrees of freedom behind it.
    pub degrees_of_freedom: usize,
}

/// Rows far from their fellows, sorted; only groups of three and more can tell which row is false.
pub(super) fn false_repeats(rows: &[MeasurementRow], groups: &[Vec<usize>]) -> Vec<usize> {
    let mut distances: Vec<(usize, f64)> = Vec::new();
    let mut pool: Vec<f64> = Vec::new();
    for group in groups.iter().filter(|g| g.len() >= 2) {
        let mut middle = Vector3::zeros();
        for k in 0..3 {
            let mut values: Vec<f64> =
                group.iter().filter_map(|&i| rows.get(i)).map(|r| coordinates_m(r)[k]).collect();
            middle[k] = median(&mut values);
        }
        for &index in group {
            let Some(row) = rows.get(index) else { continue };
            let distance = (coordinates_m(row) - middle).norm();
            pool.push(distance);
            if group.len() >= 3 {
                distances.push((index, distance));
            }
        }
    }
    // The middle value itself often lies at distance 0 in one coordinate: the 75 % quantile is steadier.
    sorting::numbers(&mut pool);
    let Some(&scale) = pool.get(pool.len() * 3 / 4) else { return Vec::new() };
    let limit = FALSE_REPEAT * scale / UPPER_QUARTILE_NORM_3D * 3.0_f64.sqrt();
    let mut false_rows: Vec<usize> =
        distances.into_iter().filter(|(_, d)| scale > 0.0 && *d > limit).map(|(i, _)| i).collect();
    sorting::ascending(&mut false_rows);
    false_rows
}

/// Two repeats that contradict each other by far more than those of other poses do that lie as far apart in time: one of them is
/// false, nobody can say which before there is a model, and their scatter is not the noise. Each stands alone. The groups are looked at
/// from the quietest half up, so that several false ones do not hide each other.
///
/// What is stated of the noise, `stated_m`, metres, counts as so many repeats that agree as in the evidence.
pub(super) fn apart_where_contradictory(
    rows: &[MeasurementRow],
    groups: Vec<Vec<usize>>,
    stated_m: Option<f64>,
) -> Vec<Vec<usize>> {
    let scatter: Vec<GroupScatter> = groups.iter().map(|group| scatter(rows, group)).collect();
    let span_min: Vec<f64> = groups.iter().map(|group| span_min(rows, group)).collect();
    let variance = |&g: &usize| scatter[g].squares_m2 / scatter[g].freedom as f64;
    let mut repeated: Vec<usize> = (0..groups.len()).filter(|&g| scatter[g].freedom > 0).collect();
    sorting::by(&mut repeated, |a, b| variance(a).total_cmp(&variance(b)));
    let (mut agree, mut split): (Vec<usize>, Vec<usize>) = (Vec::new(), Vec::new());
    for (rank, &g) in repeated.iter().enumerate() {
        // Noise that is slow lets readings differ the more the longer between them.
        let as_far = agree.iter().filter(|&&other| 2.0 * span_min[other] >= span_min[g]);
        let (mut squares, mut freedom) = as_far.fold((0.0, 0), |(squares, freedom), &h| {
            (squares + scatter[h].squares_m2, freedom + scatter[h].freedom)
        });
        if let Some(sigma_m) = stated_m.filter(|_| freedom < FEWEST_FREEDOM) {
            // Where enough others repeat, they say it alone: what is stated may be wrong.
            squares += STATED_FREEDOM as f64 * sigma_m * sigma_m;
            freedom += STATED_FREEDOM;
        }
        let is_tried = groups[g].len() == 2 && 2 * rank >= repeated.len() && freedom >= FEWEST_FREEDOM;
        let limit = || variance_ratio(NO_REPEAT, scatter[g].freedom as f64, freedom as f64);
        if is_tried && variance(&g) > limit() * squares / freedom as f64 {
            split.push(g);
        } else {
            agree.push(g);
        }
    }
    let parts = groups.into_iter().enumerate().flat_map(|(g, group)| match split.contains(&g) {
        true => group.into_iter().map(|row| vec![row]).collect(),
        false => vec![group],
    });
    let mut parts: Vec<Vec<usize>> = parts.collect();
    sorting::by_key(&mut parts, |group| group.first().copied());
    parts
}

/// Minutes from the first to the last of a group's rows; 0 without times.
fn span_min(rows: &[MeasurementRow], group: &[usize]) -> f64 {
    let times = || group.iter().filter_map(|&i| rows.get(i)).filter_map(|row| row.t_min);
    (times().fold(f64::NEG_INFINITY, f64::max) - times().fold(f64::INFINITY, f64::min)).max(0.0)
}

/// How a group's rows scatter about their mean.
struct GroupScatter {
    /// Sum of squares over all coordinates.
    squares_m2: f64,
    /// Degrees of freedom behind it.
    freedom: usize,
}

/// The scatter of the rows of one group.
fn scatter(rows: &[MeasurementRow], group: &[usize]) -> GroupScatter {
    let centre = centre(rows, group);
    let members = || group.iter().filter_map(|&i| rows.get(i));
    let numbers = members().next().and_then(|row| row.reading.coordinates()).map_or(0, |read| read.count);
    let squares = members().map(|row| (coordinates_m(row) - centre).norm_squared()).sum();
    GroupScatter { squares_m2: squares, freedom: numbers * group.len().saturating_sub(1) }
}

/// The noise that the repeats show; `None` where nothing was repeated.
pub(super) fn repeats(rows: &[MeasurementRow], groups: &[Vec<usize>]) -> Option<Repeats> {
    let mut squares = 0.0;
    let mut freedom = 0;
    for group in groups.iter().filter(|g| g.len() >= 2) {
        let of_group = scatter(rows, group);
        squares += of_group.squares_m2;
        freedom += of_group.freedom;
    }
    if freedom == 0 || squares <= 0.0 {
        return None;
    }
    Some(Repeats { sigma_m: (squares / freedom as f64).sqrt(), degrees_of_freedom: freedom })
}

/// Mean of a group's coordinates, metres.
pub(super) fn centre(rows: &[MeasurementRow], group: &[usize]) -> Vector3<f64> {
    let sum: Vector3<f64> = group.iter().filter_map(|&i| rows.get(i)).map(coordinates_m).sum();
    sum / group.len().max(1) as f64
}

/// What a row measured, metres; zero of a touch.
pub(super) fn coordinates_m(row: &MeasurementRow) -> Vector3<f64> {
    row.reading.coordinates().map_or_else(Vector3::zeros, |read| read.value_m)
}

#[cfg(test)]
mod tests {
    use crate::{Measurements, gather};
    use robot_model::units::m_from_mm;

    /// Pairs of one pose whose x differs by twice 0.01, 0.02 or 0.03 mm, and in one by 1 mm.
    fn pairs(false_mm: &[f64]) -> Measurements {
        let mut text = "pose_id,t_min,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n".to_owned();
        for pose in 0..9 {
            let off_mm = false_mm.get(pose).copied().unwrap_or(0.02 * (1 + pose % 3) as f64);
            text.push_str(&format!("{pose},{pose}.0,{pose},0,0,0,0,0,0,0,0\n"));
            text.push_str(&format!("{pose},{pose}.5,{pose},0,0,0,0,0,{off_mm},{off_mm},0\n"));
        }
        Measurements::from_csv(text.as_bytes()).unwrap()
    }

    /// Noise that is slow: pairs seven minutes apart differ by ten times as much as those that follow each other.
    #[test]
    fn repeats_that_lie_further_apart_in_time_may_differ_by_more() {
        let mut text = "pose_id,t_min,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n".to_owned();
        for pose in 0..12 {
            let (gap_min, off_mm) = if pose < 9 { (0.5, 0.02) } else { (7.0, 0.2) };
            text.push_str(&format!("{pose},{pose}.0,{pose},0,0,0,0,0,0,0,0\n"));
            let t_min = f64::from(pose) + gap_min;
            text.push_str(&format!("{pose},{t_min},{pose},0,0,0,0,0,{off_mm},{off_mm},0\n"));
        }
        let s = gather(&Measurements::from_csv(text.as_bytes()).unwrap(), &(0..24).collect::<Vec<_>>(), None);
        assert_eq!((s.stations.len(), s.repeats.unwrap().degrees_of_freedom), (12, 36));
    }

    #[test]
    fn two_repeats_of_which_one_is_false_are_no_noise_and_stand_alone() {
        let quiet = gather(&pairs(&[]), &(0..18).collect::<Vec<_>>(), None);
        assert_eq!((quiet.stations.len(), quiet.repeats.unwrap().degrees_of_freedom), (9, 27));
        for wrong in [&[1.0][..], &[0.8, 1.0, 2.0]] {
            let s = gather(&pairs(wrong), &(0..18).collect::<Vec<_>>(), None);
            assert_eq!(s.stations.len(), 9 + wrong.len());
            let repeats = s.repeats.unwrap();
            assert_eq!(repeats.degrees_of_freedom, 27 - 3 * wrong.len());
            // The largest pair that is left differs by 0.06 mm in two coordinates.
            assert!(repeats.sigma_m < 0.06e-3, "{repeats:?}");
        }
    }

    /// Two pairs, one of them off by 1 mm: nobody can say which is the noise, unless 0.02 mm is stated. Were 1 mm stated, both agree.
    #[test]
    fn what_is_stated_tells_which_of_two_repeats_is_false() {
        let two = pairs(&[1.0]);
        let freedom = |stated_mm: Option<f64>| {
            let stations = gather(&two, &[0, 1, 2, 3], stated_mm.map(m_from_mm));
            (stations.stations.len(), stations.repeats.map(|repeats| repeats.degrees_of_freedom))
        };
        assert_eq!(freedom(None), (2, Some(6)));
        assert_eq!(freedom(Some(0.02)), (3, Some(3)));
        assert_eq!(freedom(Some(1.0)), (2, Some(6)));
    }
}

//! By how much the distances between nests have changed: the scale of the instrument, for no arm carries them.

use measurements::{Measurements, Reading};
use nalgebra::Vector3;
use statistics::{MEDIAN_SCATTER, median};
use std::collections::BTreeMap;

/// Degrees of freedom without which nests do not tell their own noise.
const FEWEST_DEGREES: usize = 9;

/// The scale of the instrument after, with that before as 1, as nests show it that were measured both times.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NestScale {
    /// Distances after over distances before, less 1.
    pub ratio: f64,
    /// Standard deviation of that.
    pub sigma: f64,
    /// How many nests were measured both times.
    pub nests: usize,
}

/// Where one nest was seen, in the instrument's frame, metres.
type Readings = Vec<Vector3<f64>>;

/// The scale of nests of one name in the used rows of both files; `reading_m` is the noise of a coordinate where they do not tell their own,
/// metres. `None` of fewer than two nests, or of nests in one place.
pub(super) fn nest_scale(files: [(&Measurements, &[usize]); 2], reading_m: f64) -> Option<NestScale> {
    let [before, after] = files.map(|(file, used)| nests(file, used));
    let pairs: Vec<(&Readings, &Readings)> =
        before.iter().filter_map(|(name, was)| Some((was, after.get(name)?))).collect();
    if pairs.len() < 2 {
        return None;
    }
    let sides: [Vec<&Readings>; 2] =
        [pairs.iter().map(|(was, _)| *was).collect(), pairs.iter().map(|(_, is)| *is).collect()];
    let own_m = own_noise_m(sides.iter().flatten().copied());
    let sigma_m = own_m.unwrap_or(reading_m);
    let [was, is] = sides.map(|of_nests| Constellation::new(&of_nests, sigma_m));
    // The scale that does not depend on how the two are turned: Horn 1987, section 2E.
    (was.squares_m2 > 0.0).then(|| NestScale {
        ratio: (is.squares_m2 / was.squares_m2).sqrt() - 1.0,
        sigma: ((was.variance_m2 + is.variance_m2) / was.squares_m2).sqrt(),
        nests: pairs.len(),
    })
}

/// The readings of each nest by its name, in the instrument's frame, metres.
fn nests<'a>(file: &'a Measurements, used: &[usize]) -> BTreeMap<&'a str, Readings> {
    let mut by_name: BTreeMap<&str, Readings> = BTreeMap::new();
    for row in used.iter().filter_map(|&row| file.rows.get(row)) {
        let Reading::Nest { fixed_point, position_m, .. } = row.reading else { continue };
        let Some(name) = file.fixed_points.get(fixed_point) else { continue };
        by_name.entry(name).or_default().push(position_m);
    }
    by_name
}

/// The nests of one file about their centre.
struct Constellation {
    /// Sum of the squared distances from the centre, square metres.
    squares_m2: f64,
    /// Of one coordinate of a nest's place, on average, square metres.
    variance_m2: f64,
}

impl Constellation {
    fn new(of_nests: &[&Readings], sigma_m: f64) -> Self {
        let n = of_nests.len() as f64;
        let places_m: Vec<Vector3<f64>> = of_nests.iter().map(|readings| middle_m(readings)).collect();
        let centre_m = places_m.iter().sum::<Vector3<f64>>() / n;
        let variance_m2 = |readings: &&Readings| {
            let loss = if readings.len() > 2 { MEDIAN_SCATTER } else { 1.0 };
            (loss * sigma_m).powi(2) / readings.len() as f64
        };
        Self {
            squares_m2: places_m.iter().map(|place_m| (place_m - centre_m).norm_squared()).sum(),
            variance_m2: of_nests.iter().map(variance_m2).sum::<f64>() / n,
        }
    }
}

/// The middle of each coordinate: one false reading does not move it far.
fn middle_m(readings: &[Vector3<f64>]) -> Vector3<f64> {
    Vector3::from_fn(|k, _| median(&mut readings.iter().map(|at| at[k]).collect::<Vec<f64>>()))
}

/// The scatter of one coordinate about each nest's middle, metres; `None` where too few are repeated.
fn own_noise_m<'a>(of_nests: impl Iterator<Item = &'a Readings>) -> Option<f64> {
    let (mut squares_m2, mut degrees) = (0.0, 0);
    for readings in of_nests {
        let middle_m = middle_m(readings);
        squares_m2 += readings.iter().map(|at| (at - middle_m).norm_squared()).sum::<f64>();
        degrees += 3 * (readings.len() - 1);
    }
    (degrees >= FEWEST_DEGREES).then(|| (squares_m2 / degrees as f64).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(rows: &[(&str, [f64; 3])]) -> Measurements {
        let mut text = "q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm,kind,fixed_id\n".to_owned();
        text += "0,0,0,0,0,0,1,2,3,pose,\n";
        for (name, [x, y, z]) in rows {
            text += &format!(",,,,,,{x},{y},{z},base,{name}\n");
        }
        Measurements::from_csv(text.as_bytes()).unwrap()
    }

    /// Two nests 1,000 mm apart, then 1,000.5 mm along another axis and in another order: 500 ppm. From their middle each is 500 mm away, the
    /// squares sum to 0.5 square metres; of 0.02 mm on each coordinate both times, sqrt(2 * 0.02^2 / 500000) = 40 ppm.
    #[test]
    fn two_nests_show_the_scale_of_the_instrument() {
        let before = file(&[("A", [0.0, 0.0, 0.0]), ("B", [1000.0, 0.0, 0.0]), ("C", [1.0, 1.0, 1.0])]);
        let after = file(&[("B", [7.0, 1005.5, 9.0]), ("A", [7.0, 5.0, 9.0])]);
        let scale = nest_scale([(&before, &[0, 1, 2, 3]), (&after, &[0, 1, 2])], 2e-5).unwrap();
        assert_eq!(scale.nests, 2);
        assert!((scale.ratio - 5e-4).abs() < 1e-12, "{scale:?}");
        assert!((scale.sigma - 4e-5).abs() < 1e-12, "{scale:?}");
        assert_eq!(nest_scale([(&before, &[0, 1, 2, 3]), (&after, &[0, 1])], 2e-5), None);
    }
}

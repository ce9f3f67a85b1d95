//! Which row of a choice a target is, by one look-up: a hash of its pose that no two rows share (perfect hashing by trial,
//! Fredman, Komlos and Szemeredi, 1984).

use super::checksum;
use super::insertion::LayoutStyle;
use super::target::MAX_LINE;
use nalgebra::Isometry3;
use rapid_syntax::num;
use robot_model::units::mm_from_m;
use std::ops::Range;

/// A target that was touched up by less is still the one that it is, mm: its correction is as good there.
pub(super) const NEAR_MM: f64 = 5.0;
/// Scalar product of the quaternions of a target and the row that the hash says, at least.
pub(super) const SAME_TURN: f64 = 0.9999;
/// The scalar product of rows that both may be within [`SAME_TURN`] of one and within 0.999 of a target: 7 deg.
const ALIKE: f64 = 0.998;
/// A sum so near to a whole number is not taken: rounding could bring it to the other side.
const MARGIN: f64 = 0.05;
/// Weights that are tried for each number of cells and each of these scales, of places (per mm) and of quaternions; with larger ones
/// single precision, and quaternions of a length of not quite 1, would not leave the margin. Odd ones: whole millimetres are not to
/// become whole sums.
const TRIALS: u32 = 3000;
const SCALES: [[f64; 2]; 2] = [[0.0113, 0.217], [0.107, 1.03]];

/// Where a row is found: cell `trunc(|weights . (x, y, z)| + |weights . (q1, q2, q3, q4)|) mod cells` holds its number. A quaternion and
/// its opposite are one.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct RowHash {
    /// A target this near to the row is nearer to no other, mm.
    within_mm: f64,
    /// Per mm in x, y, z, and of the parts of the quaternion, w first.
    weights: [f64; 7],
    /// Numbers of rows, the first is 1; where no row is, 1 stands.
    cells: Vec<usize>,
}

impl RowHash {
    /// Of the poses of all rows. Where no weights tell all of them apart (rows less than some 0.1 mm and 7 deg apart), the one cell of
    /// row 1 is left: all others are then searched for.
    #[must_use]
    pub(super) fn of(poses: &[Isometry3<f64>]) -> Self {
        let keys: Vec<[f64; 7]> = poses.iter().map(key).collect();
        let mut random = 0_u32;
        let mut weight = |scale: f64| {
            // Numerical Recipes' linear congruential generator.
            random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (f64::from((random >> 16) % 199) - 99.0) * scale
        };
        let within_mm = within_mm(poses);
        for cells in [2, 3, 4, 6, 8, 12, 16, 24].map(|times| times * poses.len()) {
            for [place, turn] in SCALES.iter().flat_map(|scale| (0..TRIALS).map(move |_| *scale)) {
                let weights = [place, place, place, turn, turn, turn, turn].map(&mut weight);
                if let Some(cells) = filled(&keys, &weights, cells) {
                    return Self { within_mm, weights, cells };
                }
            }
        }
        Self { within_mm, weights: [0.0; 7], cells: vec![1] }
    }

    /// Appends the declaration; gives what it is recognised by.
    #[must_use]
    pub(super) fn write(&self, name: &str, out: &mut Vec<u8>, style: &LayoutStyle) -> Vec<u8> {
        let numbers = std::iter::once(self.within_mm).chain(self.weights).map(num);
        let all: Vec<String> = numbers.chain(self.cells.iter().map(usize::to_string)).collect();
        let value = format!("[{}]", all.join(","));
        let mut column = style.indent.len();
        out.extend_from_slice(&style.indent);
        for part in format!("LOCAL CONST num {name}{{{}}}:={value};", all.len()).split_inclusive(',') {
            style.push_part(out, &mut column, part.as_bytes(), MAX_LINE - 1);
        }
        out.extend_from_slice(style.eol);
        checksum::of_numbers(value.as_bytes()).to_vec()
    }

    /// The row's number as a RAPID expression of target `tcP` and hash `tcRow`.
    #[must_use]
    pub(super) fn expression() -> String {
        let sum = |from: usize, parts: &[&str]| {
            let part = |(k, part): (usize, &&str)| format!("tcRow{{{}}}*tcP.{part}", from + k);
            parts.iter().enumerate().map(part).collect::<Vec<_>>().join("+")
        };
        let place = sum(2, &["trans.x", "trans.y", "trans.z"]);
        let turn = sum(5, &["rot.q1", "rot.q2", "rot.q3", "rot.q4"]);
        format!("tcRow{{9+Trunc(Abs({place})\n        +Abs({turn})) MOD (Dim(tcRow,1)-8)}}")
    }
}

fn key(pose: &Isometry3<f64>) -> [f64; 7] {
    let at = pose.translation.vector.map(mm_from_m);
    let q = pose.rotation.quaternion();
    [at.x, at.y, at.z, q.w, q.i, q.j, q.k]
}

/// The sum whose whole part says the cell.
fn sum(key: &[f64; 7], weights: &[f64; 7]) -> f64 {
    let part = |range: Range<usize>| range.map(|k| weights[k] * key[k]).sum::<f64>().abs();
    part(0..3) + part(3..7)
}

/// The numbers of the rows by cell, where each has a cell of its own.
fn filled(keys: &[[f64; 7]], weights: &[f64; 7], cells: usize) -> Option<Vec<usize>> {
    let mut numbers: Vec<Option<usize>> = vec![None; cells];
    for (row, key) in keys.iter().enumerate() {
        let sum = sum(key, weights);
        if !(MARGIN..1.0 - MARGIN).contains(&sum.fract()) {
            return None;
        }
        if numbers[sum as usize % cells].replace(row + 1).is_some() {
            return None;
        }
    }
    Some(numbers.into_iter().map(|row| row.unwrap_or(1)).collect())
}

/// Half of what the nearest two rows are apart that are turned alike, or what a target may be touched up by.
fn within_mm(poses: &[Isometry3<f64>]) -> f64 {
    let pairs = poses.iter().enumerate().flat_map(|(k, a)| poses[..k].iter().map(move |b| (a, b)));
    let alike = pairs.filter(|(a, b)| a.rotation.coords.dot(&b.rotation.coords).abs() > ALIKE);
    let halves = alike.map(|(a, b)| mm_from_m((a.translation.vector - b.translation.vector).norm()) / 2.0);
    halves.fold(NEAR_MM, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Translation3, UnitQuaternion, Vector3};
    use robot_model::units::{m_from_mm, rad_from_deg};

    fn at(x_mm: f64, y_mm: f64, turn_deg: f64) -> Isometry3<f64> {
        let down = UnitQuaternion::from_axis_angle(&Vector3::y_axis(), rad_from_deg(180.0));
        let turn = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), rad_from_deg(turn_deg));
        Isometry3::from_parts(Translation3::new(m_from_mm(x_mm), m_from_mm(y_mm), 0.25), turn * down)
    }

    fn cell_of(hash: &RowHash, pose: &Isometry3<f64>) -> usize {
        hash.cells[sum(&key(pose), &hash.weights) as usize % hash.cells.len()]
    }

    #[test]
    fn each_row_has_a_cell_of_its_own() {
        let raster: Vec<_> =
            (0..32).map(|k| at(12.0 * f64::from(k / 4), 10.0 * f64::from(k % 4), 0.0)).collect();
        let turned: Vec<_> = (0..16).map(|k| at(400.0, -20.0, 11.0 * f64::from(k))).collect();
        let close: Vec<_> = (0..5).map(|k| at(0.3 * f64::from(k), 0.0, 0.0)).collect();
        for (poses, within_mm) in [(raster, 5.0), (turned, 5.0), (close[..1].to_vec(), 5.0), (close, 0.15)] {
            let hash = RowHash::of(&poses);
            assert!((hash.within_mm - within_mm).abs() < 1e-9, "{hash:?}");
            for (row, pose) in poses.iter().enumerate() {
                assert_eq!(cell_of(&hash, pose), row + 1, "{hash:?}");
                let mut opposite = *pose;
                opposite.rotation = UnitQuaternion::new_unchecked(-pose.rotation.into_inner());
                assert_eq!(cell_of(&hash, &opposite), row + 1);
            }
            assert!(hash.cells.len() <= 24 * poses.len());
        }
    }

    #[test]
    fn rows_that_nothing_tells_apart_are_left_to_the_search() {
        let hash = RowHash::of(&[at(1.0, 2.0, 0.0), at(1.0, 2.0, 0.0)]);
        assert_eq!(hash, RowHash { within_mm: 0.0, weights: [0.0; 7], cells: vec![1] });
    }

    #[test]
    fn it_is_one_array_of_numbers() {
        let hash = RowHash {
            within_mm: 5.0,
            weights: [0.25, -0.5, 0.01, 3.2, 1.0, 0.0, -2.0],
            cells: vec![1, 2, 1, 3],
        };
        let style = LayoutStyle { eol: b"\n", indent: b"  ".to_vec(), unit: b"  ".to_vec() };
        let mut out = Vec::new();
        let checksums = hash.write("tcPRow", &mut out, &style);
        let text = "  LOCAL CONST num tcPRow{12}:=[5,0.25,-0.5,0.01,3.2,1,0,-2,1,2,1,3];\n";
        assert_eq!(String::from_utf8(out).unwrap(), text);
        assert_eq!(checksums, checksum::of_numbers(b"[5,0.25,-0.5,0.01,3.2,1,0,-2,1,2,1,3]"));
        let long = RowHash { cells: vec![31; 300], ..hash };
        let mut out = Vec::new();
        let _ = long.write("tcPRow", &mut out, &style);
        assert!(String::from_utf8(out).unwrap().lines().all(|line| line.len() < MAX_LINE));
    }
}

//! Points in the order of their files' names, 1, 10, 11, 2, beside joints in the order in which they were measured.

use super::trials::most_left_m;
use super::whole::{SOUND_M, explains};
use super::{Fault, FaultKind};
use crate::Station;
use crate::column_names::POINT;
use nalgebra::Isometry3;

/// Fewer rows are numbered with one digit and stand in the same order either way.
const FEWEST: usize = 12;

/// Every row with the point of the row that would stand there were rows sorted by the letters of their numbers, or the other way round.
#[must_use]
pub(super) fn sorted_by_name(
    stations: &[Station],
    poses: &[Isometry3<f64>],
    targets: usize,
) -> Option<Fault> {
    if stations.len() < FEWEST || targets > 1 {
        return None;
    }
    let as_read_m = most_left_m(stations, poses, targets).filter(|left_m| *left_m > SOUND_M)?;
    let left_m = |pose_of: &[usize]| {
        let poses: Vec<Isometry3<f64>> = pose_of.iter().map(|&i| poses[i]).collect();
        most_left_m(stations, &poses, targets)
    };
    let is_it = [0, 1].into_iter().any(|first| {
        let sorted = by_letters(stations.len(), first);
        let mut back = vec![0; sorted.len()];
        sorted.iter().enumerate().for_each(|(place, &i)| back[i] = place);
        explains(left_m(&sorted), as_read_m) || explains(left_m(&back), as_read_m)
    });
    is_it.then(|| {
        let reason = "points and joints are in another order: one of them is sorted by the letters of its number (1, 10, 11, 2), the other by the \
                      number";
        Fault::of_all(FaultKind::RowsShifted, Some(&POINT.join(", ")), reason)
    })
}

/// So many rows, numbered from `first`, in the order of the letters of their numbers.
fn by_letters(count: usize, first: usize) -> Vec<usize> {
    let mut rows: Vec<usize> = (0..count).collect();
    sorting::by_key(&mut rows, |row| (row + first).to_string());
    rows
}

#[cfg(test)]
mod tests {
    use super::by_letters;

    #[test]
    fn eleven_comes_before_two() {
        assert_eq!(by_letters(12, 1), [0, 9, 10, 11, 1, 2, 3, 4, 5, 6, 7, 8]);
        assert_eq!(by_letters(12, 0), [0, 1, 10, 11, 2, 3, 4, 5, 6, 7, 8, 9]);
    }
}

//! Sums of columns, four at a time: each number is read and written once for four, and comes out as if they had been added one
//! after the other.

/// Adds to `to` the columns `from`, each times its number of `by`, in their order; what is beyond the shorter of both is left out.
pub(super) fn add_columns<'c>(to: &mut [f64], by: &[f64], from: impl IntoIterator<Item = &'c [f64]>) {
    let n = to.len();
    let mut from = from.into_iter();
    let mut four = by.chunks_exact(4);
    for by in &mut four {
        let (Some(a), Some(b), Some(c), Some(d)) = (from.next(), from.next(), from.next(), from.next())
        else {
            return;
        };
        let (a, b, c, d) = (&a[..n], &b[..n], &c[..n], &d[..n]);
        for i in 0..n {
            to[i] = to[i] + by[0] * a[i] + by[1] * b[i] + by[2] * c[i] + by[3] * d[i];
        }
    }
    for (by, from) in four.remainder().iter().zip(from) {
        to.iter_mut().zip(from).for_each(|(to, from)| *to += by * from);
    }
}

#[cfg(test)]
mod tests {
    use super::add_columns;

    /// To the last bit as one column after the other, for every count of them.
    #[test]
    fn four_at_a_time_come_to_the_same_bits() {
        let columns: Vec<Vec<f64>> =
            (0..11).map(|c| (0..7).map(|r| 1.0 / f64::from(3 + 5 * r + 7 * c)).collect()).collect();
        let by: Vec<f64> = (0..11).map(|c| 1.0 / f64::from(2 + c) - 0.3).collect();
        for count in 0..=11 {
            let mut one_by_one = vec![0.1; 7];
            for (by, column) in by.iter().zip(&columns).take(count) {
                one_by_one.iter_mut().zip(column).for_each(|(to, from)| *to += by * from);
            }
            let mut together = vec![0.1; 7];
            add_columns(&mut together, &by[..count], columns.iter().map(Vec::as_slice));
            assert_eq!(together, one_by_one, "{count}");
        }
    }
}

//! What the elements of an array that nobody touched say of the others: neighbouring buckets are corrected alike, whatever the drift is made of.

use super::target_pose::TargetPose;

/// Shares nearer to each other than this are one.
const ONE_SHARE: f64 = 1e-6;
/// Beyond the outermost element by no more than so many times the step before it.
const MOST_STEPS: f64 = 4.0;

/// The elements of one row of an array that are as they were made.
pub(super) struct UntouchedElements<'s> {
    /// Element 1, the original.
    original: Option<TargetPose>,
    /// The corrected ones by their position in the row, ascending.
    corrected: Vec<(usize, TargetPose)>,
    /// How much of the drift each bucket corrects: of the target that is corrected most, in proportion to its largest correction.
    shares: &'s [f64],
    /// What a single bucket is corrected by.
    correction: Option<&'s [f64; 6]>,
}

impl<'s> UntouchedElements<'s> {
    /// Of a row of `count` elements, a single one of which is corrected by `correction`; `place` gives their places, those at `changed` are left out.
    pub(super) fn new(
        (count, correction): (usize, Option<&'s [f64; 6]>),
        changed: &[usize],
        shares: &'s [f64],
        place: &dyn Fn(usize) -> Option<TargetPose>,
    ) -> Self {
        let untouched = |k: &usize| !changed.contains(k);
        let corrected = (1..count).filter(untouched).filter_map(|k| Some((k, place(k)?))).collect();
        Self { original: untouched(&0).then(|| place(0)).flatten(), corrected, shares, correction }
    }

    /// Element 1 as it was made. Where it was touched: what the two corrected ones that are furthest apart in the drift leave without it, which is
    /// right where all of the correction grows by one law.
    pub(super) fn original(&self) -> Option<TargetPose> {
        if self.original.is_some() {
            return self.original.clone();
        }
        if let ([(_, one)], Some(correction)) = (self.corrected.as_slice(), self.correction) {
            return Some(one.moved_by(correction, -1.0));
        }
        let by_share = |a: &&(usize, TargetPose), b: &&(usize, TargetPose)| {
            self.share(a.0).unwrap_or(0.0).total_cmp(&self.share(b.0).unwrap_or(0.0))
        };
        let (from, a) = self.corrected.iter().min_by(by_share)?;
        let (to, b) = self.corrected.iter().max_by(by_share)?;
        let (from, to) = (self.share(*from)?, self.share(*to)?);
        (to - from > ONE_SHARE).then(|| a.without(from / (to - from), a, b)).flatten()
    }

    /// The corrected element nearest to position `k`.
    pub(super) fn nearest(&self, k: usize) -> Option<TargetPose> {
        self.corrected.iter().min_by_key(|(other, _)| other.abs_diff(k)).map(|(_, place)| place.clone())
    }

    /// The corrected element at position `k` as it was made: between its neighbours, or as far beyond the last two as the drift goes on. Buckets lie
    /// as near to each other as the tolerance asks, and what they differ by in shape is a small part of that.
    pub(super) fn expected(&self, k: usize) -> Option<TargetPose> {
        let split = self.corrected.partition_point(|(other, _)| *other < k);
        let (below, above) = self.corrected.split_at(split);
        match (below, above) {
            ([.., a], [b, ..]) => Self::along(a, b, self.times(k, [a.0, b.0], [0.0, 1.0])),
            ([.., a, b], []) => Self::along(a, b, self.times(k, [a.0, b.0], [1.0, MOST_STEPS])),
            ([], [a, b, ..]) => Self::along(b, a, self.times(k, [b.0, a.0], [1.0, MOST_STEPS])),
            ([one], []) | ([], [one]) => {
                let original = self.original.as_ref()?;
                let (whole, part) = (self.share(one.0)?, self.share(k)?);
                (whole > ONE_SHARE).then(|| original.without(-part / whole, original, &one.1)).flatten()
            }
            _ => Some(self.original.as_ref()?.moved_by(self.correction?, 1.0)),
        }
    }

    /// The place so many `times` of the way from one element to another.
    fn along(a: &(usize, TargetPose), b: &(usize, TargetPose), times: f64) -> Option<TargetPose> {
        a.1.without(-times, &a.1, &b.1)
    }

    /// How many times the way from element `a` to element `b` leads to element `k`: by the shares of the drift, or by the buckets' number where the
    /// shares, which are one target's, do not lie as the buckets do.
    fn times(&self, k: usize, [a, b]: [usize; 2], [least, most]: [f64; 2]) -> f64 {
        let by_share = || {
            let (from, to, at) = (self.share(a)?, self.share(b)?, self.share(k)?);
            let times = (at - from) / (to - from);
            ((to - from).abs() > ONE_SHARE && (least..=most).contains(&times)).then_some(times)
        };
        let position = |k: usize| k as f64;
        by_share().unwrap_or((position(k) - position(a)) / (position(b) - position(a)))
    }

    fn share(&self, k: usize) -> Option<f64> {
        self.shares.get(k.checked_sub(1)?).copied()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn joint(deg: f64) -> TargetPose {
        TargetPose::Joints([deg, 0.0, 0.0, 0.0, 0.0, 0.0])
    }

    fn deg(pose: Option<TargetPose>) -> f64 {
        match pose {
            Some(TargetPose::Joints(joints)) => joints[0],
            other => panic!("{other:?}"),
        }
    }

    /// A zero that is off by 0.03 from the first minute on and a drift of 0.02 that comes as 1 - e^-t, at t = 0.1, 0.3, 0.6, 1 and 2: each element
    /// from its neighbours and, of one correction beside the constant, to the last digit.
    #[test]
    fn a_constant_beside_a_drift_is_told_from_the_neighbours() {
        let drift = [0.1_f64, 0.3, 0.6, 1.0, 2.0].map(|t| 1.0 - (-t).exp());
        let elements: Vec<f64> = std::iter::once(10.0).chain(drift.map(|d| 10.03 + 0.02 * d)).collect();
        let shares = drift.map(|d| (0.03 + 0.02 * d) / (0.03 + 0.02 * drift[4]));
        for k in 1..6 {
            let untouched = UntouchedElements::new((6, None), &[k], &shares, &|k| Some(joint(elements[k])));
            assert!((deg(untouched.expected(k)) - elements[k]).abs() < 1e-12, "{k}");
        }
        let two = UntouchedElements::new((6, None), &[2, 3], &shares, &|k| Some(joint(elements[k])));
        assert!((deg(two.expected(2)) - elements[2]).abs() < 1e-12);
    }

    /// One bucket: what the comment block holds tells. Two by one law: the other one does, in proportion.
    #[test]
    fn few_elements_tell_what_they_can() {
        let one = UntouchedElements::new((2, None), &[1], &[1.0], &|_| Some(joint(10.0)));
        assert!(one.expected(1).is_none());
        let correction = [0.02, 0.0, 0.0, 0.0, 0.0, 0.0];
        let one = UntouchedElements::new((2, Some(&correction)), &[1], &[1.0], &|_| Some(joint(10.0)));
        assert!((deg(one.expected(1)) - 10.02).abs() < 1e-12);
        let first = UntouchedElements::new((2, Some(&correction)), &[0], &[1.0], &|_| Some(joint(10.02)));
        assert!((deg(first.original()) - 10.0).abs() < 1e-12);
        let elements = [10.0, 10.01, 10.04];
        let two = UntouchedElements::new((3, None), &[1], &[0.25, 1.0], &|k| Some(joint(elements[k])));
        assert!((deg(two.expected(1)) - 10.01).abs() < 1e-12);
        // The original touched: what both leave without the drift.
        let first = UntouchedElements::new((3, None), &[0], &[0.25, 1.0], &|k| Some(joint(elements[k])));
        assert!((deg(first.original()) - 10.0).abs() < 1e-12);
    }
}

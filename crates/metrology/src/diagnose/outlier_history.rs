//! Stations that are set aside as false from round to round, so that none goes to and fro; knows nothing of why one is false.

use inference::robust_weights::RobustWeights;

/// Which stations have wavered. A reading that draws the model towards it looks less false with the model that it has drawn, and a
/// search that ends in such a round ends with it: what came back and was set aside once more stays aside.
pub(super) struct OutlierHistory {
    returned: Vec<bool>,
    for_good: Vec<bool>,
}

impl OutlierHistory {
    /// Of so many stations none has wavered.
    #[must_use]
    pub(super) fn new(stations: usize) -> Self {
        Self { returned: vec![false; stations], for_good: vec![false; stations] }
    }

    /// Takes note of what a round would set aside after the `last`, and gives it back with what has wavered kept aside.
    #[must_use]
    pub(super) fn settled(&mut self, last: &RobustWeights, mut next: RobustWeights) -> RobustWeights {
        for i in 0..next.outliers.len() {
            match (last.outliers[i], next.outliers[i]) {
                (true, false) if self.for_good[i] => {
                    (next.weights[i], next.outliers[i]) = (last.weights[i], true);
                }
                (true, false) => self.returned[i] = true,
                (false, true) => self.for_good[i] = self.returned[i],
                _ => {}
            }
        }
        next
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One station goes to and fro, one comes back once, one is aside from the second round on.
    #[test]
    fn what_comes_back_and_goes_again_stays_aside() {
        let rounds = [[true, true, false], [false, false, true], [true, false, true], [false, false, true]];
        let mut history = OutlierHistory::new(3);
        let mut last = RobustWeights { weights: vec![0.2, 0.5, 1.0], outliers: rounds[0].to_vec() };
        for (round, seen) in rounds.iter().enumerate().skip(1) {
            let weights = seen.iter().map(|&aside| if aside { 0.1 } else { 1.0 }).collect();
            let next = history.settled(&last, RobustWeights { weights, outliers: seen.to_vec() });
            assert_eq!(next.outliers, [round > 1, false, true], "round {round}");
            last = next;
        }
        assert_eq!(last.weights, [0.1, 1.0, 0.1]);
    }
}

//! Stations that are set aside as false from round to round, so that none goes to and fro.

/// Which stations have wavered. A reading that draws the model towards it looks less false with the model that it has drawn, and a
/// search that ends in such a round ends with it: what came back and was set aside once more stays aside.
pub struct SetAside {
    returned: Vec<bool>,
    for_good: Vec<bool>,
}

impl SetAside {
    /// Of so many stations none has wavered.
    pub fn new(stations: usize) -> Self {
        Self { returned: vec![false; stations], for_good: vec![false; stations] }
    }

    /// Takes note of what a round `next` would set aside after the `last`, each as weights and as who is aside, and keeps aside in
    /// `next` what has wavered.
    pub fn settle(&mut self, last: (&[f64], &[bool]), next: (&mut [f64], &mut [bool])) {
        let (weights, aside) = next;
        for i in 0..aside.len() {
            match (last.1[i], aside[i]) {
                (true, false) if self.for_good[i] => (weights[i], aside[i]) = (last.0[i], true),
                (true, false) => self.returned[i] = true,
                (false, true) => self.for_good[i] = self.returned[i],
                _ => {}
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::SetAside;

    /// One station goes to and fro, one comes back once, one is aside from the second round on.
    #[test]
    fn what_comes_back_and_goes_again_stays_aside() {
        let rounds = [[true, true, false], [false, false, true], [true, false, true], [false, false, true]];
        let mut set_aside = SetAside::new(3);
        let mut last = ([0.2, 0.5, 1.0], rounds[0]);
        for (round, seen) in rounds.iter().enumerate().skip(1) {
            let mut next = (seen.map(|aside| if aside { 0.1 } else { 1.0 }), *seen);
            set_aside.settle((&last.0, &last.1), (&mut next.0, &mut next.1));
            let expected = [round > 1, false, true];
            assert_eq!(next.1, expected, "round {round}");
            last = next;
        }
        assert_eq!(last.0, [0.1, 1.0, 0.1]);
    }
}

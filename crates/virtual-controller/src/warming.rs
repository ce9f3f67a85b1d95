//! Working and standing: how warm the true robot is as its motions come and go.
//!
//! A robot warms by moving. Between two motions of a cycle it is held, its drives stay warm: such a pause is
//! work. In a longer one it cools, whether the program stands, waits or asks a signal again and again. Which it
//! was is known when the pause is over, or has lasted too long.

use robot_model::deform::Warmth;
use robot_model::units::min_from_s;

/// What warms the true robot.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Warming {
    /// Its motions, and pauses between them that are no longer than a gap.
    #[default]
    Moving,
    /// A program that runs, whether it moves the robot or not.
    Running,
}

/// The longest pause between two motions that still counts as work, minutes, where nothing else is said.
pub const GAP_MIN: f64 = 5.0;
/// Sums of seconds come to a whole minute only so closely, minutes.
const ROUNDING_MIN: f64 = 1e-6;

/// The warmth of a robot from motion to motion, by the steady clock.
#[derive(Clone, Debug)]
pub(super) struct WarmthHistory {
    /// Up to the end of the last motion; where the pause since is longer than the gap, up to now.
    warmth: Warmth,
    /// `None` where the robot warms by running.
    gap_min: Option<f64>,
    /// How far it has come, seconds of the steady clock.
    now_s: f64,
    /// Minutes since the end of the last motion.
    pause_min: f64,
    /// Parts of a pause of which it is not yet known whether they are work: minutes, and whether the program
    /// stood. Neighbours of one kind are one, so that a program that asks a signal for hours takes no memory.
    open: Vec<(f64, bool)>,
}

impl WarmthHistory {
    pub(crate) fn new(warmth: Warmth, warming: Warming, gap_min: f64, now_s: f64) -> Self {
        let gap_min = (warming == Warming::Moving).then_some(gap_min);
        Self { warmth, gap_min, now_s, pause_min: 0.0, open: Vec::new() }
    }

    fn is_long(&self, pause_min: f64) -> bool {
        self.gap_min.is_some_and(|gap_min| pause_min > gap_min + ROUNDING_MIN)
    }

    /// No motion up to a time; `standing` where the program does not run either.
    pub(crate) fn rest_until(&mut self, until_s: f64, standing: bool) {
        let dt_min = min_from_s((until_s - self.now_s).max(0.0));
        if dt_min == 0.0 {
            return;
        }
        self.now_s = until_s;
        if self.gap_min.is_none() {
            return self.warmth.advance(dt_min, !standing);
        }
        self.pause_min += dt_min;
        if self.is_long(self.pause_min) {
            let open_min: f64 = self.open.drain(..).map(|(minutes, _)| minutes).sum();
            return self.warmth.advance(open_min + dt_min, false);
        }
        match self.open.last_mut() {
            Some((minutes, stood)) if *stood == standing => *minutes += dt_min,
            _ => self.open.push((dt_min, standing)),
        }
    }

    /// A motion, and the rest before it.
    pub(crate) fn move_until(&mut self, began_s: f64, ended_s: f64) {
        self.rest_until(began_s, false);
        self.warmth = self.warmth_if_resting_until(began_s);
        self.open.clear();
        self.pause_min = 0.0;
        let dt_min = min_from_s((ended_s - self.now_s).max(0.0));
        self.warmth.advance(dt_min, true);
        self.now_s = self.now_s.max(ended_s);
    }

    /// The warmth now, where there is no motion before `until_s`: that decides what the pause so far is.
    pub(crate) fn warmth_if_resting_until(&self, until_s: f64) -> Warmth {
        let ahead_min = min_from_s((until_s - self.now_s).max(0.0));
        let is_long = self.is_long(self.pause_min + ahead_min);
        let mut warmth = self.warmth;
        for (minutes, stood) in &self.open {
            warmth.advance(*minutes, !(is_long || *stood));
        }
        warmth
    }

    /// The warmth now, the pause so far taken for all of it.
    pub(crate) fn warmth(&self) -> Warmth {
        self.warmth_if_resting_until(self.now_s)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robot_model::deform::GrowthLaw;

    fn cold() -> Warmth {
        Warmth::cold(GrowthLaw::TwoStage { tau_min: 46.0 }, 60.0)
    }

    fn share_after(parts: &[(f64, bool)]) -> f64 {
        let mut warmth = cold();
        parts.iter().for_each(|&(minutes, works)| warmth.advance(minutes, works));
        warmth.share()
    }

    /// Half an hour of motion, pauses as `(minutes, standing)`, and ten minutes of motion.
    fn share_with(warming: Warming, pauses: &[(f64, bool)]) -> f64 {
        let mut history = WarmthHistory::new(cold(), warming, GAP_MIN, 0.0);
        history.move_until(0.0, 1800.0);
        let mut now_s = 1800.0;
        for (minutes, standing) in pauses {
            now_s += minutes * 60.0;
            history.rest_until(now_s, *standing);
        }
        history.move_until(now_s, now_s + 600.0);
        history.warmth().share()
    }

    #[test]
    fn a_pause_longer_than_the_gap_is_standing_however_it_is_made_up() {
        let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-12, "{a} {b}");
        let stood = |minutes: f64| share_after(&[(30.0, true), (minutes, false), (10.0, true)]);
        close(share_with(Warming::Moving, &[(5.0, false)]), share_after(&[(45.0, true)]));
        close(share_with(Warming::Moving, &[(5.1, false)]), stood(5.1));
        // Three minutes of waiting at the end of a pass, three at the beginning of the next.
        close(share_with(Warming::Moving, &[(3.0, false), (3.0, false)]), stood(6.0));
        close(share_with(Warming::Moving, &[(3.0, false), (45.0, true), (4.0, false)]), stood(52.0));
        // Standing is standing, however short; what is waited beside it is work as long as it all is short.
        let short = [(30.0, true), (1.0, true), (2.0, false), (11.0, true)];
        close(share_with(Warming::Moving, &[(1.0, false), (2.0, true), (1.0, false)]), share_after(&short));
        let polls = vec![(1.0 / 60.0, false); 8 * 3600];
        close(share_with(Warming::Moving, &polls), stood(480.0));
        let running = share_after(&[(30.0, true), (480.0, true), (10.0, true)]);
        close(share_with(Warming::Running, &[(480.0, false)]), running);
        close(share_with(Warming::Running, &[(45.0, true)]), stood(45.0));
    }

    #[test]
    fn the_pause_so_far_is_what_the_whole_pause_is() {
        let mut history = WarmthHistory::new(cold(), Warming::Moving, GAP_MIN, 0.0);
        history.move_until(0.0, 1800.0);
        history.rest_until(2040.0, false);
        let at = |until_s: f64| history.warmth_if_resting_until(until_s).share();
        assert!((at(2100.0) - share_after(&[(34.0, true)])).abs() < 1e-12);
        assert!((at(2101.0) - share_after(&[(30.0, true), (4.0, false)])).abs() < 1e-12);
    }
}

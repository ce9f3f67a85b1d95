//! Options of `compensate` that change nothing in what is asked for.

use super::args::{Args, HOLD_MIN, STALE_MIN};
use super::option_values::{ClockName, FormName};
use crate::cli::idle::{self, IdleOption};
use rapid_compensation::compensate::Options;
use rapid_compensation::schedule::Until;
use rapid_syntax::diagnostic::Diagnostic;

impl Args {
    /// A warning for each option that has no effect beside the others.
    pub(super) fn idle_options(&self) -> Vec<Diagnostic> {
        let scheduled = matches!(self.form, FormName::Schedule);
        let warmth = matches!(self.clock, ClockName::Warmth);
        let no_buckets = "the correction follows the drift in every minute; --form schedule has buckets";
        let no_cooling = "only --clock warmth lets the robot cool while it stands";
        let measured = matches!(self.clock, ClockName::Measured(_));
        let no_reading = "only --clock signal:NAME and pers:NAME have readings of a temperature";
        let no_touch = "it says how --touch finds its point: radius and margin with --touch-signal alone";
        let of_touch = self.touch.idle().map(|(option, is_idle)| (option, is_idle, no_touch));
        let own: [IdleOption; 6] = [
            ("--until", matches!(self.until, Until::Minutes(_)) && !scheduled, no_buckets),
            ("--bucket-min", self.bucket_min.is_some() && !scheduled, no_buckets),
            ("--tau-cool", self.tau_cool.is_some() && !warmth, no_cooling),
            ("--gap-min", self.gap_min != Options::GAP_MIN && !warmth, no_cooling),
            ("--hold-min", self.hold_min != HOLD_MIN && !measured, no_reading),
            ("--stale-min", self.stale_min != STALE_MIN && !measured, no_reading),
        ];
        idle::warnings(own.into_iter().chain(of_touch))
    }
}

#[cfg(test)]
mod tests {
    use crate::cli::compensate::Args;
    use crate::cli::idle::arguments;

    fn idle(options: &str) -> Vec<String> {
        let line = format!("compensate a.mod --robot irb140 {options}");
        let found = arguments::<Args>(&line).idle_options();
        found.iter().filter_map(|said| said.message.split(' ').next()).map(str::to_owned).collect()
    }

    #[test]
    fn what_has_no_effect_is_named() {
        assert_eq!(idle("--form ramp --until 60 --bucket-min 5"), ["--until", "--bucket-min"]);
        assert_eq!(idle("--clock elapsed --tau-cool 20 --gap-min 8"), ["--tau-cool", "--gap-min"]);
        assert_eq!(idle("--hold-min 5 --stale-min 30"), ["--hold-min", "--stale-min"]);
        assert_eq!(
            idle("--touch-radius-mm 10 --touch-margin-mm 3 --touch-sigma-mm 0.05"),
            ["--touch-radius-mm", "--touch-margin-mm", "--touch-sigma-mm"]
        );
        let by_routine =
            "--touch pin=pPin,tGun,wobj0 --touch-routine rFind --touch-margin-mm 3 --touch-sigma-mm 0.05";
        assert_eq!(idle(by_routine), ["--touch-margin-mm"]);
        for useful in [
            "--until 60 --bucket-min 5 --tau-cool 20 --growth exp:30",
            "--form ramp --until auto --tau-cool 20",
            "--model m.toml --growth exp:30",
            "--clock signal:aiTemp --hold-min 5 --stale-min 30",
            "--gap-min 8",
            "--touch pin=pPin,tGun,wobj0 --touch-signal diPin --touch-radius-mm 10 --touch-margin-mm 3",
        ] {
            assert_eq!(idle(useful), [""; 0], "{useful}");
        }
    }
}

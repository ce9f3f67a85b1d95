//! Options that change nothing in what is asked for: said, and nothing else comes of them.

use super::args::Args;
use super::option_values::{ClockName, FormName};
use rapid_compensation::schedule::Until;
use rapid_syntax::diagnostic::Diagnostic;

impl Args {
    /// A warning for each option that has no effect beside the others.
    pub(super) fn idle_options(&self) -> Vec<Diagnostic> {
        let scheduled = matches!(self.form, FormName::Schedule);
        let warmth = matches!(self.clock, ClockName::Warmth);
        let no_buckets = "the correction follows the drift in every minute; --form schedule has buckets";
        let no_cooling = "only --clock warmth lets the robot cool while it stands";
        [
            ("--until", matches!(self.until, Until::Minutes(_)) && !scheduled, no_buckets),
            ("--bucket-min", self.bucket_min.is_some() && !scheduled, no_buckets),
            ("--tau-cool", self.tau_cool.is_some() && !warmth, no_cooling),
        ]
        .into_iter()
        .filter_map(|(option, is_idle, why)| {
            let warning =
                || Diagnostic::warning("option::idle", format!("{option} changes nothing here")).help(why);
            is_idle.then(warning)
        })
        .collect()
    }
}

#[cfg(test)]
mod tests {
    use crate::cli::compensate::Args;
    use clap::Parser;

    #[derive(Parser)]
    struct Line {
        #[command(flatten)]
        args: Args,
    }

    fn idle(options: &str) -> Vec<String> {
        let line = format!("compensate a.mod --robot irb140 {options}");
        let found = Line::parse_from(line.split_whitespace()).args.idle_options();
        found.iter().filter_map(|said| said.message.split(' ').next()).map(str::to_owned).collect()
    }

    #[test]
    fn what_has_no_effect_is_named() {
        assert_eq!(idle("--form ramp --until 60 --bucket-min 5"), ["--until", "--bucket-min"]);
        assert_eq!(idle("--clock elapsed --tau-cool 20"), ["--tau-cool"]);
        for useful in [
            "--until 60 --bucket-min 5 --tau-cool 20 --growth exp:30",
            "--form ramp --until auto --tau-cool 20",
            "--model m.toml --growth exp:30",
        ] {
            assert_eq!(idle(useful), [""; 0], "{useful}");
        }
    }
}

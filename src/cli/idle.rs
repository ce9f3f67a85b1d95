//! Options that change nothing beside the others: said, and nothing else comes of them.

use super::Console;
use rapid_syntax::diagnostic::Diagnostic;

/// An option as it is written, whether it is given and changes nothing, and why that is.
pub type IdleOption = (&'static str, bool, &'static str);

/// Tells each of `options` that is idle.
pub fn tell(options: impl IntoIterator<Item = IdleOption>, console: &mut Console) {
    console.report(warnings(options));
}

/// A warning for each of `options` that is idle.
pub fn warnings(options: impl IntoIterator<Item = IdleOption>) -> Vec<Diagnostic> {
    let idle = options.into_iter().filter(|(_, is_idle, _)| *is_idle);
    idle.map(|(option, _, why)| {
        Diagnostic::warning("option::idle", format!("{option} changes nothing here")).help(why)
    })
    .collect()
}

/// The arguments of a command as its words give them, for tests.
#[cfg(test)]
pub fn arguments<A: clap::Args>(words: &str) -> A {
    #[derive(clap::Parser)]
    struct Line<A: clap::Args> {
        #[command(flatten)]
        args: A,
    }
    <Line<A> as clap::Parser>::parse_from(words.split_whitespace()).args
}

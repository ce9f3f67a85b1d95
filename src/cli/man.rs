//! `driftpost man`: the manual pages, made of the same texts as `--help`.

use super::files::Pending;
use super::{Cli, Console, Outcome};
use clap::CommandFactory;
use clap_mangen::Man;
use std::path::PathBuf;

/// Command line of `driftpost man`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// The folder for the pages: driftpost.1, driftpost-compensate.1 and so on.
    #[arg(short, long, value_name = "FOLDER")]
    pub output: PathBuf,
}

/// Runs `man`.
///
/// # Errors
/// A folder that cannot be written.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    let mut command = Cli::command();
    command.build();
    let mut all = Vec::new();
    named("driftpost", &command, &mut all);
    let mut pages = Vec::with_capacity(all.len());
    for (name, command) in all {
        let mut text = Vec::new();
        Man::new(command.display_name(name.clone())).render(&mut text)?;
        let mut page = Pending::new(&args.output.join(format!("{name}.1")))?;
        page.fill(&text)?;
        pages.push(page);
    }
    let count = pages.len();
    pages.into_iter().try_for_each(Pending::place)?;
    console.note(format_args!("wrote {count} pages to {}", args.output.display()));
    Ok(Outcome::Done)
}

/// A command and those below it, each with the name of its page; `help` of the program alone.
fn named(name: &str, command: &clap::Command, all: &mut Vec<(String, clap::Command)>) {
    all.push((name.to_owned(), command.clone()));
    for below in command.get_subcommands().filter(|below| !below.is_hide_set()) {
        let page = format!("{name}-{}", below.get_name());
        match (below.get_name(), name) {
            ("help", "driftpost") => all.push((page, below.clone())),
            ("help", _) => {}
            _ => named(&page, below, all),
        }
    }
}

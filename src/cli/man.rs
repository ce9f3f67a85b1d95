//! `driftpost man`: the manual pages, made of the same texts as `--help`.

use super::files::Pending;
use super::{Cli, Console, Outcome};
use clap::CommandFactory;
use clap_mangen::Man;
use std::path::PathBuf;

/// Options of `man`.
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
    let below = command.get_subcommands().filter(|command| !command.is_hide_set()).cloned();
    let named = below.map(|command| (format!("driftpost-{}", command.get_name()), command));
    let all: Vec<_> = std::iter::once(("driftpost".to_owned(), command.clone())).chain(named).collect();
    let mut pages = Vec::with_capacity(all.len());
    for (name, command) in all {
        let mut text = Vec::new();
        Man::new(command.display_name(name.clone())).render(&mut text)?;
        let mut page = Pending::new(&args.output.join(format!("{name}.1")))?;
        page.fill(&mut text.as_slice())?;
        pages.push(page);
    }
    let count = pages.len();
    pages.into_iter().try_for_each(Pending::place)?;
    console.say(format_args!("wrote {count} pages to {}", args.output.display()));
    Ok(Outcome::Done)
}

//! `driftpost report`: a page of a result's JSON.

use super::{Console, Outcome, files, overwriting};
use crate::report::{Page, write_page};
use std::io::{BufWriter, Write};
use std::path::PathBuf;

/// Command line of `driftpost report`.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// What a command wrote with --json; - is standard input.
    #[arg(value_name = "JSON")]
    pub result: PathBuf,

    /// The page [default: the result's name with .html].
    #[arg(short, long, value_name = "FILE.html")]
    pub output: Option<PathBuf>,
}

/// Runs `report`.
///
/// # Errors
/// A file that cannot be read or written, or that is no result of ours.
pub fn run(args: &Args, console: &mut Console) -> anyhow::Result<Outcome> {
    let path = args.output.clone().unwrap_or_else(|| match files::is_standard(&args.result) {
        true => PathBuf::from("report.html"),
        false => args.result.with_extension("html"),
    });
    files::keep_apart(&[&args.result], &[&path])?;
    overwriting::check_page(&path)?;
    let mut page = files::Pending::new(&path)?;
    let bytes = files::read(&args.result, "result")?;
    let title = args.result.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    let result = Page::from_json(&bytes, &args.result.display().to_string(), title)?;
    let mut out = BufWriter::with_capacity(1 << 16, page.out());
    write_page(&mut out, &result)?;
    out.flush()?;
    drop(out);
    page.place()?;
    console.note(format_args!("wrote {}", path.display()));
    Ok(Outcome::Done)
}

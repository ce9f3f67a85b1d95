//! Files: read with a message that says what to do, written whole or not at all.

use super::Console;
use super::pending::folder_of;
pub use super::pending::{PENDING, Pending, place_all, unwritable};
use super::program_at::check_no_program;
use rapid_syntax::diagnostic::Diagnostic;
use std::fs;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::sync::mpsc;
use std::time::Duration;

/// More does not come out of a pipe, and a larger file is no input of ours: the largest real program has 170 MB.
const MOST_BYTES: u64 = 1 << 30;
/// So long is waited for the other end of a pipe.
const PIPE: Duration = Duration::from_secs(5);

/// The bytes of `path`, `-` being standard input; `what` names the file's part in the work ("program", "deformation table").
///
/// # Errors
/// `input::missing`, `input::unreadable` or `input::too-large`, naming the file.
pub fn read(path: &Path, what: &str) -> Result<Vec<u8>, Diagnostic> {
    if is_standard(path) {
        return limited(&mut io::stdin().lock(), path, what);
    }
    let metadata = fs::metadata(path).map_err(|cause| cannot_read(path, what, &cause))?;
    let kind = metadata.file_type();
    if is_device(kind) {
        let text = format!("{} is a device, not a {what}", path.display());
        return Err(Diagnostic::error("input::unreadable", text).help("name a file"));
    }
    if is_pipe(kind) {
        return read_pipe(path, what);
    }
    if metadata.len() > MOST_BYTES && kind.is_file() {
        return Err(too_large(path));
    }
    let mut file = fs::File::open(path).map_err(|cause| cannot_read(path, what, &cause))?;
    limited(&mut file, path, what)
}

/// Whether a path stands for standard input or output.
pub fn is_standard(path: &Path) -> bool {
    ["-", "/dev/stdin", "/dev/fd/0", "/proc/self/fd/0"].iter().any(|name| path == Path::new(name))
}

fn limited(from: &mut dyn Read, path: &Path, what: &str) -> Result<Vec<u8>, Diagnostic> {
    let mut bytes = Vec::new();
    from.take(MOST_BYTES + 1).read_to_end(&mut bytes).map_err(|cause| cannot_read(path, what, &cause))?;
    if bytes.len() as u64 > MOST_BYTES {
        return Err(too_large(path));
    }
    Ok(bytes)
}

/// Refuses a result that no command would read again: neither `restore` nor `diff`.
///
/// # Errors
/// `output::too-large`, naming the file `shown`.
pub fn check_size(shown: &str, bytes: &[u8]) -> Result<(), Diagnostic> {
    if bytes.len() as u64 <= MOST_BYTES {
        return Ok(());
    }
    let text = format!("{shown} would be larger than 1 GB, and `driftpost restore` would not read it");
    Err(Diagnostic::error("output::too-large", text).help("split the program, or take another `--form`"))
}

fn too_large(path: &Path) -> Diagnostic {
    let text = format!("{} is larger than 1 GB", path.display());
    Diagnostic::error("input::too-large", text).help("split the program")
}

/// Reads a named pipe, which is opened only when somebody writes to it.
fn read_pipe(path: &Path, what: &str) -> Result<Vec<u8>, Diagnostic> {
    let (opened, open) = mpsc::channel();
    let own = path.to_path_buf();
    std::thread::spawn(move || opened.send(fs::File::open(own)));
    match open.recv_timeout(PIPE) {
        Ok(file) => limited(&mut file.map_err(|cause| cannot_read(path, what, &cause))?, path, what),
        Err(_) => {
            let text = format!("nothing is written to the pipe {}", path.display());
            Err(Diagnostic::error("input::unreadable", text).help("name a file, or write to the pipe"))
        }
    }
}

#[cfg(unix)]
fn is_device(kind: fs::FileType) -> bool {
    use std::os::unix::fs::FileTypeExt;
    kind.is_char_device() || kind.is_block_device() || kind.is_socket()
}

#[cfg(unix)]
fn is_pipe(kind: fs::FileType) -> bool {
    std::os::unix::fs::FileTypeExt::is_fifo(&kind)
}

#[cfg(not(unix))]
fn is_device(_: fs::FileType) -> bool {
    false
}

#[cfg(not(unix))]
fn is_pipe(_: fs::FileType) -> bool {
    false
}

/// The message for a file that cannot be read; `what` begins with "folder" where a folder is asked for.
pub fn cannot_read(path: &Path, what: &str, cause: &io::Error) -> Diagnostic {
    let shown = path.display();
    if cause.kind() == io::ErrorKind::NotFound {
        if let Ok(to) = fs::read_link(path) {
            let text = format!("the {what} {shown} is a link to {}, which does not exist", to.display());
            return Diagnostic::error("input::missing", text).help("name the file itself");
        }
        let mut refusal = Diagnostic::error("input::missing", format!("the {what} {shown} does not exist"));
        refusal.help = Some(match similar_neighbour(path) {
            Some(near) => format!("did you mean {}?", near.display()),
            None => "check the path".to_owned(),
        });
        return refusal;
    }
    if path.is_dir() && !what.starts_with("folder") {
        return Diagnostic::error("input::unreadable", format!("{shown} is a folder, not a {what}"))
            .help("name a file");
    }
    if path.is_file() && what.starts_with("folder") {
        return Diagnostic::error("input::unreadable", format!("{shown} is a file, not a {what}"))
            .help("name a folder");
    }
    Diagnostic::error("input::unreadable", format!("the {what} {shown} cannot be read: {cause}"))
        .help("check its permissions")
}

/// A file beside `path` whose name is much like it.
fn similar_neighbour(path: &Path) -> Option<PathBuf> {
    let wanted = path.file_name()?.to_string_lossy().into_owned();
    let folder = folder_of(path);
    let mut names: Vec<String> = fs::read_dir(folder)
        .ok()?
        .filter_map(|entry| Some(entry.ok()?.file_name().to_string_lossy().into_owned()))
        .collect();
    sorting::ascending(&mut names);
    let near = super::suggest::nearest(&wanted, names.iter().map(String::as_str))?;
    Some(path.with_file_name(near))
}

/// Where a result goes: nowhere, to standard output, or to a file.
pub enum Output {
    /// It was not asked for.
    Nowhere,
    /// Standard output, written `-`.
    Standard,
    /// A file that appears when it is whole.
    File(Pending),
}

impl Output {
    /// The output that an option names, of what is no program; a file is made sure of.
    ///
    /// # Errors
    /// `output::changed` where a program stands there; a place where no file can be put, as [`Pending::new`] says.
    pub fn new(path: Option<&Path>) -> Result<Self, Diagnostic> {
        path.map_or(Ok(()), check_no_program)?;
        Self::of_program(path)
    }

    /// The same of a program.
    ///
    /// # Errors
    /// A place where no file can be put, as [`Pending::new`] says.
    pub fn of_program(path: Option<&Path>) -> Result<Self, Diagnostic> {
        match path {
            None => Ok(Self::Nowhere),
            Some(path) if path == Path::new("-") => Ok(Self::Standard),
            Some(path) => Pending::new(path).map(Self::File),
        }
    }

    /// Whether it is standard output.
    #[must_use]
    pub fn is_standard(&self) -> bool {
        matches!(self, Self::Standard)
    }

    /// Whether somebody has asked for it.
    #[must_use]
    pub fn is_wanted(&self) -> bool {
        !matches!(self, Self::Nowhere)
    }

    /// Path of the file, or what else it is, for people and scripts.
    #[must_use]
    pub fn name(&self) -> String {
        match self {
            Self::Nowhere => "nowhere".to_owned(),
            Self::Standard => "standard output".to_owned(),
            Self::File(pending) => pending.path().display().to_string(),
        }
    }

    /// Writes what `bytes` gives, which is not called where nothing is wanted.
    ///
    /// # Errors
    /// Those of `bytes`, and whatever keeps the result from being written.
    pub fn write(
        self,
        console: &mut Console,
        bytes: impl FnOnce() -> anyhow::Result<Vec<u8>>,
    ) -> anyhow::Result<()> {
        match self {
            Self::Nowhere => Ok(()),
            Self::Standard => Ok(console.out().write_all(&bytes()?)?),
            Self::File(pending) => Ok(pending.write(&bytes()?)?),
        }
    }

    /// Writes `data` as JSON, indented, with a line's end behind it.
    ///
    /// # Errors
    /// Whatever keeps the result from being written.
    pub fn write_json(self, console: &mut Console, data: &serde_json::Value) -> anyhow::Result<()> {
        self.write(console, || Ok(format!("{data:#}\n").into_bytes()))
    }

    /// Has a file written bit by bit (it may be large) beside its place; what goes to standard output, or nowhere, is left.
    ///
    /// # Errors
    /// Those of `write`, and whatever keeps the result from being written.
    pub fn fill(
        &mut self,
        write: impl FnOnce(&mut dyn io::Write) -> anyhow::Result<()>,
    ) -> anyhow::Result<()> {
        let Self::File(pending) = self else { return Ok(()) };
        let path = pending.path().to_path_buf();
        let mut out = io::BufWriter::with_capacity(1 << 16, pending.out());
        let written = write(&mut out).and_then(|()| Ok(io::Write::flush(&mut out)?));
        // What is written there fails for the file's own reasons.
        written.map_err(|error| match error.downcast::<io::Error>() {
            Ok(cause) => unwritable(&path, cause).into(),
            Err(other) => other,
        })
    }

    /// The file that is to be put in its place, of which nothing is left here; what goes to standard output stays.
    pub fn take_file(&mut self) -> Option<Pending> {
        match self {
            Self::File(_) => std::mem::replace(self, Self::Nowhere).into_pending(),
            Self::Nowhere | Self::Standard => None,
        }
    }

    /// The file that is to be put in its place.
    #[must_use]
    pub fn into_pending(self) -> Option<Pending> {
        match self {
            Self::File(pending) => Some(pending),
            Self::Nowhere | Self::Standard => None,
        }
    }

    /// Has the result written bit by bit: it may be large.
    ///
    /// # Errors
    /// Those of `write`, and whatever keeps the result from being written.
    pub fn stream(
        mut self,
        console: &mut Console,
        write: impl FnOnce(&mut dyn io::Write) -> anyhow::Result<()>,
    ) -> anyhow::Result<()> {
        match self {
            Self::Nowhere => Ok(()),
            Self::Standard => write(console.out()),
            Self::File(_) => {
                self.fill(write)?;
                Ok(self.into_pending().map_or(Ok(()), Pending::place)?)
            }
        }
    }
}

/// Refuses outputs that are an input or, where one stands in for a folder, a file of it, and two outputs at
/// one place.
///
/// # Errors
/// `output::is-input` or `output::twice`, naming the path.
pub fn keep_apart(inputs: &[&Path], outputs: &[&Path]) -> Result<(), Diagnostic> {
    let inputs: Vec<PathBuf> = inputs.iter().map(|path| identity(path)).collect();
    let mut seen: Vec<PathBuf> = Vec::new();
    if outputs.iter().filter(|path| **path == Path::new("-")).count() > 1 {
        let text = "two results would be written to standard output";
        return Err(Diagnostic::error("output::twice", text).help("give one of them a file"));
    }
    for output in outputs.iter().filter(|path| **path != Path::new("-")) {
        if fs::metadata(output).is_ok_and(|m| !m.is_file()) {
            continue; // a folder, or a device
        }
        let own = identity(output);
        if inputs.iter().any(|input| own == *input || own.exists() && own.starts_with(input)) {
            let text = format!("{} is an input and would be overwritten", output.display());
            return Err(Diagnostic::error("output::is-input", text)
                .help("name another place; only compensate --in-place overwrites its own modules"));
        }
        if seen.contains(&own) {
            let text = format!("two results would be written to {}", output.display());
            return Err(Diagnostic::error("output::twice", text).help("give each a place of its own"));
        }
        seen.push(own);
    }
    Ok(())
}

/// A path by which two names of one file are the same, also of a file that is not there yet.
pub fn identity(path: &Path) -> PathBuf {
    if let Ok(path) = fs::canonicalize(path) {
        return path;
    }
    match (path.parent(), path.file_name()) {
        (Some(parent), Some(name)) if !parent.as_os_str().is_empty() => identity(parent).join(name),
        (_, Some(name)) => fs::canonicalize(".").unwrap_or_default().join(name),
        (Some(parent), None) => identity(parent).parent().map(Path::to_path_buf).unwrap_or_default(),
        (None, None) => path.to_path_buf(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_folder_that_may_not_be_read_is_said_to_be_unreadable() {
        let folder = tempfile::tempdir().unwrap();
        let denied = io::Error::from(io::ErrorKind::PermissionDenied);
        let message = |what| cannot_read(folder.path(), what, &denied).message;
        let shown = folder.path().display();
        assert_eq!(message("folder"), format!("the folder {shown} cannot be read: permission denied"));
        assert_eq!(message("program"), format!("{shown} is a folder, not a program"));
    }

    #[test]
    fn a_result_is_as_large_as_what_is_read_and_no_larger() {
        // Zeroed pages that nobody touches take no memory.
        let bytes = vec![0; (1 << 30) + 1];
        assert_eq!(check_size("out.mod", &bytes[..1 << 30]), Ok(()));
        let refusal = check_size("out.mod", &bytes).unwrap_err();
        assert!(
            refusal.code == "output::too-large" && refusal.message.contains("out.mod would be larger"),
            "{refusal:?}"
        );
    }
}

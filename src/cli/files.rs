//! Files: read with a message that says what to do, written whole or not at all.

use super::Console;
use rapid_syntax::diagnostic::Diagnostic;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// What the names of files begin with that wait beside their places.
pub const PENDING: &str = ".driftpost-";

/// The bytes of `path`; `what` names the file's part in the work ("program", "deformation table").
///
/// # Errors
/// `input::missing` or `input::unreadable`, naming the file.
pub fn read(path: &Path, what: &str) -> Result<Vec<u8>, Diagnostic> {
    fs::read(path).map_err(|cause| cannot_read(path, what, &cause))
}

/// The message for a file that cannot be read.
pub fn cannot_read(path: &Path, what: &str, cause: &io::Error) -> Diagnostic {
    let shown = path.display();
    if cause.kind() == io::ErrorKind::NotFound {
        let mut said = Diagnostic::error("input::missing", format!("the {what} {shown} does not exist"));
        said.help = Some(match similar_neighbour(path) {
            Some(near) => format!("did you mean {}?", near.display()),
            None => "check the path".to_owned(),
        });
        return said;
    }
    if path.is_dir() {
        return Diagnostic::error("input::unreadable", format!("{shown} is a folder, not a {what}"))
            .help("name a file");
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
    names.sort();
    let near = super::suggest::nearest(&wanted, names.iter().map(String::as_str))?;
    Some(path.with_file_name(near))
}

/// A file that will be written: opened beside its place before the long work begins, so that a folder
/// that cannot be written to is found at once, and renamed into its place when it is whole.
///
/// What is no regular file (a device, a pipe) is written to, not replaced; a symbolic link stays one.
pub struct Pending {
    path: PathBuf,
    file: tempfile::NamedTempFile,
    /// The path is no regular file.
    through: bool,
}

impl Pending {
    /// Makes sure that `path` can be written.
    ///
    /// # Errors
    /// `output::unwritable`, naming the path.
    pub fn new(path: &Path) -> Result<Self, Diagnostic> {
        if path.is_dir() {
            return Err(unwritable(path, "it is a folder"));
        }
        if fs::metadata(path).is_ok_and(|m| m.permissions().readonly()) {
            return Err(unwritable(path, "it is write-protected"));
        }
        let path = &followed(path);
        let through = fs::metadata(path).is_ok_and(|m| !m.is_file());
        if through {
            let file = builder().tempfile().map_err(|cause| unwritable(path, cause))?;
            return Ok(Self { path: path.clone(), file, through });
        }
        let folder = folder_of(path);
        let there = folder.ancestors().find(|f| f.exists() || f.as_os_str().is_empty()).unwrap_or(folder);
        let there = if there.as_os_str().is_empty() { Path::new(".") } else { there };
        let file = builder().tempfile_in(there).map_err(|cause| unwritable(path, cause))?;
        Ok(Self { path: path.clone(), file, through })
    }

    /// Its path.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Writes the whole file, or its next piece, still beside its place.
    ///
    /// # Errors
    /// `output::unwritable`; the file at the path is then as it was.
    pub fn fill(&mut self, from: &mut dyn io::Read) -> Result<(), Diagnostic> {
        let failed = |cause| unwritable(&self.path, cause);
        io::copy(from, &mut self.file).map_err(failed)?;
        if self.through {
            return Ok(());
        }
        fs::create_dir_all(folder_of(&self.path)).map_err(failed)
    }

    /// The file, still beside its place, to be written to.
    pub fn out(&mut self) -> &mut dyn io::Write {
        &mut self.file
    }

    /// Puts the file in its place.
    ///
    /// # Errors
    /// `output::unwritable`; the file at the path is then as it was.
    pub fn place(self) -> Result<(), Diagnostic> {
        let path = self.path;
        if self.through {
            let failed = |cause| unwritable(&path, cause);
            let mut whole = self.file.reopen().map_err(failed)?;
            let mut to = fs::OpenOptions::new().write(true).open(&path).map_err(failed)?;
            return io::copy(&mut whole, &mut to).map(drop).map_err(failed);
        }
        self.file.persist(&path).map_err(|cause| unwritable(&path, cause.error))?;
        Ok(())
    }

    /// Writes the whole file and puts it in its place.
    ///
    /// # Errors
    /// `output::unwritable`; the file at the path is then as it was.
    pub fn write(mut self, mut bytes: &[u8]) -> Result<(), Diagnostic> {
        self.fill(&mut bytes)?;
        self.place()
    }
}

/// Where a result goes: nowhere, to standard output, or to a file.
pub enum Output {
    /// It was not asked for.
    Nowhere,
    /// `-`
    Standard,
    /// A file.
    File(Pending),
}

impl Output {
    /// The output that an option names; a file is made sure of.
    ///
    /// # Errors
    /// As [`Pending::new`].
    pub fn new(path: Option<&Path>) -> Result<Self, Diagnostic> {
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

    /// Has the result written bit by bit: it may be large.
    ///
    /// # Errors
    /// Those of `write`, and whatever keeps the result from being written.
    pub fn stream(
        self,
        console: &mut Console,
        write: impl FnOnce(&mut dyn io::Write) -> anyhow::Result<()>,
    ) -> anyhow::Result<()> {
        match self {
            Self::Nowhere => Ok(()),
            Self::Standard => write(console.out()),
            Self::File(mut pending) => {
                let mut out = io::BufWriter::with_capacity(1 << 16, pending.out());
                write(&mut out)?;
                let flushed = io::Write::flush(&mut out);
                drop(out);
                flushed.map_err(|cause| unwritable(&pending.path, cause))?;
                Ok(pending.write(&[])?)
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

/// Where a symbolic link leads, also where nothing is there yet.
fn followed(path: &Path) -> PathBuf {
    if fs::read_link(path).is_err() {
        return path.to_path_buf();
    }
    if let Ok(to) = fs::canonicalize(path) {
        return to;
    }
    match fs::read_link(path) {
        Ok(to) => folder_of(path).join(to),
        Err(_) => path.to_path_buf(),
    }
}

/// The folder a path stands in.
fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Temporary files get the permissions that any new file of the user's has.
fn builder() -> tempfile::Builder<'static, 'static> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(PENDING);
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder
}

fn unwritable(path: &Path, cause: impl std::fmt::Display) -> Diagnostic {
    Diagnostic::error("output::unwritable", format!("{} cannot be written: {cause}", path.display()))
        .help("name another place for it, or give write permission; nothing was written")
}

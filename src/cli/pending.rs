//! Files that are written beside their places and put there when they are whole.

use super::interrupt::{WaitingFile, create_folder, placing};
use rapid_syntax::diagnostic::Diagnostic;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use std::time::Duration;
use tempfile::NamedTempFile;

/// What the names of files begin with that wait beside their places.
pub const PENDING: &str = ".driftpost-";
/// So many bytes go to the system in one call: more it may put into larger pages of its cache, and where no memory lies ready in such
/// pieces, the copy takes up to ten times as long.
const PIECE: usize = 256 * 1024;
/// An abandoned file that says nothing of its run is taken for one after so long.
const ABANDONED: Duration = Duration::from_secs(60);

/// A file that will be written: opened beside its place before the long work begins, so that a folder
/// that cannot be written to is found at once, and renamed into its place when it is whole.
///
/// What is no regular file (a device, a pipe) is written to, not replaced; a symbolic link stays one.
pub struct Pending {
    path: PathBuf,
    file: NamedTempFile,
    /// Taken away if the program is interrupted.
    _waiting: WaitingFile,
    /// The path is no regular file.
    through: bool,
}

impl Pending {
    /// Makes sure that `path` can be written.
    ///
    /// # Errors
    /// `output::unwritable`, naming the path.
    pub fn new(path: &Path) -> Result<Self, Diagnostic> {
        // Where standard output is meant and allowed, no file is asked for.
        if path == Path::new("-") {
            return Err(unwritable(
                path,
                "this goes to a file, not to standard output; a file of that name is ./-",
            ));
        }
        if path.is_dir() {
            return Err(unwritable(path, "it is a folder"));
        }
        if fs::metadata(path).is_ok_and(|m| m.permissions().readonly()) {
            return Err(unwritable(path, "it is write-protected"));
        }
        let path = &followed(path);
        let through = fs::metadata(path).is_ok_and(|m| !m.is_file());
        if through {
            return Self::waiting(path, through, || builder().tempfile());
        }
        let folder = folder_of(path);
        let there = folder.ancestors().find(|f| f.exists() || f.as_os_str().is_empty()).unwrap_or(folder);
        let there = if there.as_os_str().is_empty() { Path::new(".") } else { there };
        remove_stale(there);
        Self::waiting(path, through, || builder().tempfile_in(there))
    }

    fn waiting(
        path: &Path,
        through: bool,
        create: impl FnOnce() -> io::Result<NamedTempFile>,
    ) -> Result<Self, Diagnostic> {
        let (file, _waiting) = WaitingFile::create(create).map_err(|cause| unwritable(path, cause))?;
        // Whoever can lock it knows that nobody writes to it any more.
        let _ = file.as_file().try_lock();
        Ok(Self { path: path.to_path_buf(), file, _waiting, through })
    }

    /// Whether it is written to a device or a pipe.
    #[must_use]
    pub fn is_through(&self) -> bool {
        self.through
    }

    /// Path that the file will have.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Writes the whole file, or its next part, still beside its place.
    ///
    /// # Errors
    /// `output::unwritable`; the file at the path is then as it was.
    pub fn fill(&mut self, bytes: &[u8]) -> Result<(), Diagnostic> {
        let written = bytes.chunks(PIECE).try_for_each(|piece| io::Write::write_all(&mut self.file, piece));
        written.map_err(|cause| unwritable(&self.path, cause))
    }

    /// The file, still beside its place, to be written to.
    pub fn out(&mut self) -> &mut dyn io::Write {
        &mut self.file
    }

    /// Has what was written reach the disk, so that a place that is taken is never an empty file after the power has gone.
    fn sync(&self) -> Result<(), Diagnostic> {
        self.file.as_file().sync_all().map_err(|cause| unwritable(&self.path, cause))
    }

    /// Puts the file in its place; folders are made now, so that what is refused until then leaves none.
    ///
    /// # Errors
    /// `output::unwritable`; the file at the path is then as it was.
    pub fn place(self) -> Result<(), Diagnostic> {
        let path = self.path;
        if self.through {
            let failed = |cause| unwritable(&path, cause);
            let mut whole = self.file.reopen().map_err(failed)?;
            let mut to = fs::OpenOptions::new().write(true).open(&path).map_err(failed)?;
            io::copy(&mut whole, &mut to).map_err(failed)?;
            return io::Write::flush(&mut to).map_err(failed);
        }
        create_folder(folder_of(&path)).map_err(|cause| unwritable(&path, cause))?;
        self.file.persist(&path).map_err(|cause| unwritable(&path, cause.error))?;
        Ok(())
    }

    /// Writes the whole file and puts it in its place.
    ///
    /// # Errors
    /// `output::unwritable`; the file at the path is then as it was.
    pub fn write(mut self, bytes: &[u8]) -> Result<(), Diagnostic> {
        self.fill(bytes)?;
        self.place()
    }
}

/// Puts files in their places, in the order given but for what goes through a device or a pipe: that comes first, as it is what
/// fails. All are on the disk before the first is put there; `withdrawn` are taken away just before it.
///
/// # Errors
/// `output::unwritable`, which says what was written until then.
pub fn place_all(mut files: Vec<Pending>, withdrawn: &[PathBuf]) -> Result<(), Diagnostic> {
    sorting::by_key(&mut files, |file| !file.is_through());
    files.iter().filter(|file| !file.is_through()).try_for_each(Pending::sync)?;
    // A pipe may wait for its reader for ever; until a file is in its place an interruption leaves nothing.
    let mut uninterrupted = None;
    let mut written: Vec<String> = Vec::new();
    for file in files {
        if !file.is_through() && uninterrupted.is_none() {
            uninterrupted = Some(placing());
            for path in withdrawn {
                fs::remove_file(path).map_err(|cause| unwritable(path, cause))?;
            }
        }
        let path = file.path().display().to_string();
        if let Err(mut refusal) = file.place() {
            let mut help = match written.as_slice() {
                [] => "name another place for it, or give write permission; nothing was written".to_owned(),
                list => format!("written are {}, and nothing else", list.join(", ")),
            };
            if uninterrupted.is_some() {
                help.extend(withdrawn.iter().map(|path| format!("; {} was taken away", path.display())));
            }
            refusal.help = Some(help);
            return Err(refusal);
        }
        written.push(path);
    }
    Ok(())
}

/// The folder a path stands in.
pub fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Takes away what a run left that was killed.
fn remove_stale(folder: &Path) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    for entry in entries.flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        let Some(rest) = name.strip_prefix(PENDING) else { continue };
        let run = rest.split('-').next().and_then(|id| id.parse::<u32>().ok());
        let is_gone = run.is_some_and(|id| {
            Path::new("/proc/self").exists() && !Path::new(&format!("/proc/{id}")).exists()
        });
        let is_old = || {
            let modified = entry.metadata().and_then(|metadata| metadata.modified()).ok();
            modified.and_then(|at| at.elapsed().ok()).is_some_and(|age| age > ABANDONED)
        };
        let is_free = || fs::File::open(entry.path()).is_ok_and(|file| file.try_lock().is_ok());
        if (is_gone || is_old()) && is_free() {
            let _ = fs::remove_file(entry.path()); // another run may have been faster
        }
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

/// Temporary files get the permissions that any new file of the user's has.
fn builder() -> tempfile::Builder<'static, 'static> {
    static PREFIX: LazyLock<String> = LazyLock::new(|| format!("{PENDING}{}-", std::process::id()));
    let mut builder = tempfile::Builder::new();
    builder.prefix(PREFIX.as_str());
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder
}

/// The message for a file that cannot be written.
pub fn unwritable(path: &Path, cause: impl std::fmt::Display) -> Diagnostic {
    Diagnostic::error("output::unwritable", format!("{} cannot be written: {cause}", path.display()))
        .help("name another place for it, or give write permission")
}

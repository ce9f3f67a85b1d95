//! Ctrl-C and termination: what waits beside its place is taken away; what is just being put in its place is finished.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use tempfile::NamedTempFile;

/// What a shell reports of a program that was interrupted.
const INTERRUPTED: i32 = 130;

/// Files that wait beside their places, and folders that were made for them.
static WAITING: Mutex<(Vec<PathBuf>, Vec<PathBuf>)> = Mutex::new((Vec::new(), Vec::new()));
/// Held while results are put in their places.
static PLACING: Mutex<()> = Mutex::new(());
/// Set by an interruption, where what is at work has asked for that.
static STOP: Mutex<Option<Arc<AtomicBool>>> = Mutex::new(None);

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// From here on an interrupted run leaves nothing behind.
pub fn install() {
    // Where there are no signals there is nothing to do.
    let _ = ctrlc::set_handler(|| {
        if let Some(stop) = &*lock(&STOP) {
            // What is at work gives back what it holds, and then ends by `leave`.
            stop.store(true, Ordering::Relaxed);
            return;
        }
        leave();
    });
}

/// Ends the program as an interrupted one.
pub fn leave() -> ! {
    let _placing = lock(&PLACING);
    // Held to the end: what is still at work makes no file or folder that nobody takes away.
    let waiting = lock(&WAITING);
    let (files, folders) = &*waiting;
    files.iter().for_each(|file| drop(fs::remove_file(file)));
    // The inner ones first; one that holds something stays.
    folders.iter().rev().for_each(|folder| drop(fs::remove_dir(folder)));
    std::process::exit(INTERRUPTED);
}

/// From here on an interruption sets `stop` and no more; who handed it over calls [`leave`].
#[cfg(feature = "link")]
pub fn hand_over(stop: &Arc<AtomicBool>) {
    *lock(&STOP) = Some(Arc::clone(stop));
}

/// Nothing is interrupted until this is dropped.
pub fn placing() -> MutexGuard<'static, ()> {
    lock(&PLACING)
}

/// A file that is taken away if the program is interrupted before this is dropped.
pub struct WaitingFile(PathBuf);

impl WaitingFile {
    /// Makes a file; there is no moment at which it is there and an interruption does not know of it.
    ///
    /// # Errors
    /// What `create` cannot do, for its reason.
    pub fn create(create: impl FnOnce() -> io::Result<NamedTempFile>) -> io::Result<(NamedTempFile, Self)> {
        let mut waiting = lock(&WAITING);
        let file = create()?;
        let path = file.path().to_path_buf();
        waiting.0.push(path.clone());
        Ok((file, Self(path)))
    }
}

impl Drop for WaitingFile {
    fn drop(&mut self) {
        lock(&WAITING).0.retain(|path| *path != self.0);
    }
}

/// Makes a folder with those above it; those that are new are taken away if the program is interrupted while they are empty.
///
/// # Errors
/// Those of the file system.
pub fn create_folder(folder: &Path) -> io::Result<()> {
    let new: Vec<PathBuf> = folder
        .ancestors()
        .take_while(|f| !f.as_os_str().is_empty() && !f.exists())
        .map(Path::to_path_buf)
        .collect();
    lock(&WAITING).1.extend(new.into_iter().rev());
    fs::create_dir_all(folder)
}

//! What stands round the controller: signals of the cell, and files on its disk.

use crate::code::Name;
use std::collections::{BTreeMap, BTreeSet};

/// Signals by name in lower case.
#[derive(Debug, Default)]
pub(crate) struct Signals {
    pub levels: BTreeMap<Name, f32>,
    /// Signals whose unit has failed.
    pub units_down: BTreeSet<Name>,
}

/// Files by name in lower case; this disk has no folders.
#[derive(Debug, Default)]
pub(crate) struct Disk {
    pub files: BTreeMap<String, Vec<u8>>,
    /// Files of StartLoad that WaitLoad has not yet asked for.
    pub load_sessions: Vec<Option<String>>,
    /// Files that a program writes to, by the channel's number less one; `None` where it is closed.
    pub channels: Vec<Option<String>>,
    /// Bytes that programs have written.
    pub written: usize,
    /// Nothing can be written: the disk is full, or read only.
    pub protected: bool,
}

impl Disk {
    /// The name of a file: the last part of its path, in lower case.
    pub(crate) fn file_name(path: &str) -> String {
        path.rsplit(['/', '\\', ':']).next().unwrap_or(path).to_lowercase()
    }
}

//! Numbers of what a program holds, each kind a type of its own.

/// A module, by its position among all that were ever loaded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct ModuleId(usize);

/// A routine, by its position among those of all modules that were ever loaded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct RoutineId(usize);

impl ModuleId {
    /// The module at a position of the loaded program's list.
    pub(crate) fn new(index: usize) -> Self {
        Self(index)
    }

    /// Its position in the loaded program's list.
    pub(crate) fn index(self) -> usize {
        self.0
    }
}

impl RoutineId {
    /// The routine at a position of the loaded program's list.
    pub(crate) fn new(index: usize) -> Self {
        Self(index)
    }

    /// Its position in the loaded program's list.
    pub(crate) fn index(self) -> usize {
        self.0
    }
}

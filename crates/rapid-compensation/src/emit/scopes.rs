//! What names mean at the places of a module.

use super::declarations::Declarations;
use rapid_syntax::tree::{Module, Routine};

/// A module's data and routines.
pub(super) struct Scopes<'t> {
    pub(super) declarations: Declarations<'t>,
    /// In the order in which they stand.
    routines: Vec<&'t Routine>,
}

impl<'t> Scopes<'t> {
    /// Of a module in `bytes`.
    #[must_use]
    pub(super) fn new(bytes: &'t [u8], module: &'t Module) -> Self {
        Self { declarations: Declarations::new(bytes, module), routines: module.routines().collect() }
    }

    /// The routine in which a byte of the file stands.
    #[must_use]
    pub(super) fn routine_at(&self, at: u32) -> Option<&'t Routine> {
        let after = self.routines.partition_point(|routine| routine.range.start <= at);
        after.checked_sub(1).and_then(|at| self.routines.get(at)).copied()
    }

    /// Whether a name is the own one of the routine in which a byte of the file stands.
    #[must_use]
    pub(super) fn is_local_at(&self, name: &[u8], at: u32) -> bool {
        self.routine_at(at).is_some_and(|routine| self.declarations.is_local(name, routine))
    }
}

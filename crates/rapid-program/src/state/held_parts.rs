//! Which components of a datum hold what was read from where the robot stands: of a robtarget whose position and orientation were set
//! anew nothing is left of it but configuration and external axes, which hold no drift.

use crate::ids::DatumId;
use crate::index::Index;
use crate::names::Sym;

/// Components of a datum by their position in its type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct HeldParts(u32);

impl HeldParts {
    /// No component holds any of it.
    pub(super) const NONE: Self = Self(0);
    /// All of them, or of a datum without components the whole.
    pub(super) const ALL: Self = Self(u32::MAX);

    /// The components that hold it on either of two ways.
    #[must_use]
    pub(super) fn or(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// What they are once the part of a datum that `path` names is set to what holds `new` ones.
    #[must_use]
    pub(super) fn with_part(self, index: &Index<'_>, datum: DatumId, path: &[Sym], new: Self) -> Self {
        let Some((first, inner)) = path.split_first() else { return new };
        let holds = new != Self::NONE;
        let components = index.components(index.data[datum].type_name).unwrap_or_default();
        let bit = components.iter().position(|(name, _)| name == first).and_then(bit_at);
        match (bit, holds) {
            (_, true) if path.iter().any(|&name| tells_no_pose(index, name)) => self,
            (Some(bit), true) => Self(self.0 | bit),
            (None, true) => Self::ALL,
            (Some(bit), false) if inner.is_empty() => Self(self.0 & !bit),
            (_, false) => self,
        }
    }

    /// Whether a component is among them that tells of the arm's pose.
    pub(super) fn tell_the_pose(self, index: &Index<'_>, datum: DatumId) -> bool {
        let Some(components) = index.components(index.data[datum].type_name) else {
            return self != Self::NONE;
        };
        let of_pose = components.iter().enumerate().filter(|(_, (name, _))| !tells_no_pose(index, *name));
        let bits = of_pose.map(|(at, _)| bit_at(at).unwrap_or(u32::MAX));
        self.0 & bits.fold(0, |all, bit| all | bit) != 0
    }
}

/// The bit of a component; `None` where there are too many of them.
fn bit_at(at: usize) -> Option<u32> {
    u32::try_from(at).ok().and_then(|at| 1_u32.checked_shl(at))
}

/// Whether a component is a configuration or the places of external axes.
fn tells_no_pose(index: &Index<'_>, component: Sym) -> bool {
    matches!(index.names.text(component), "extax" | "robconf")
}

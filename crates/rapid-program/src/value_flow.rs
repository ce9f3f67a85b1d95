//! Which datum's value goes into which: by assignment, by declaration, as an argument.

use super::ids::DatumId;

/// The value of one datum comes to another.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct ValueFlow {
    pub(super) to: DatumId,
    pub(super) from: DatumId,
}

/// All of a program, by where they go to, then by where they come from, each once.
#[derive(Debug, Default)]
pub(super) struct ValueFlows(Vec<ValueFlow>);

impl ValueFlows {
    /// From flows in any order.
    pub(super) fn new(mut flows: Vec<ValueFlow>) -> Self {
        sorting::ascending(&mut flows);
        flows.dedup();
        Self(flows)
    }

    /// All of them, sorted.
    pub(super) fn as_slice(&self) -> &[ValueFlow] {
        &self.0
    }

    /// The same with more of them.
    pub(super) fn with(mut self, more: Vec<ValueFlow>) -> Self {
        self.0.extend(more);
        Self::new(self.0)
    }

    /// The data whose values come to a datum.
    pub(super) fn sources_of(&self, datum: DatumId) -> impl Iterator<Item = DatumId> {
        let first = self.0.partition_point(|flow| flow.to < datum);
        self.0[first..].iter().take_while(move |flow| flow.to == datum).map(|flow| flow.from)
    }
}

//! What a call was found to leave when the routines around it were walked the last time. Where routines call each other in circles, each
//! is walked until it covers its own inner calls; begun from nothing in every walk of the one around it, that doubles with each routine of
//! the circle. What was found before holds again, as what is taken for granted of the outer ones only grows: beginning with it, a walk
//! ends where it would have ended, and most often at once.
//!
//! Knows nothing of steps and ways.

use super::in_force::same;
use super::{After, State};
use crate::ids::RoutineIndex;
use crate::names::ByNumber;
use std::rc::Rc;

/// A call, told from others by its routine, by what it was entered with and by the call around it: the position in [`EarlierRounds`].
pub(super) type CallPath = usize;

/// The calls that were followed since the outermost one began.
#[derive(Default)]
pub(super) struct EarlierRounds {
    calls: Vec<FollowedCall>,
    of_routine: ByNumber<RoutineIndex, Vec<CallPath>>,
}

struct FollowedCall {
    within: Option<CallPath>,
    asked: Rc<State>,
    /// What it was entered with in the end, by the calls of itself further down too, and what it left; `None` where it calls itself nowhere.
    found: Option<(State, After)>,
}

impl EarlierRounds {
    /// The call of a routine with `asked`, within another.
    pub(super) fn path(
        &mut self,
        within: Option<CallPath>,
        routine: RoutineIndex,
        asked: &Rc<State>,
    ) -> CallPath {
        let known = self.of_routine.entry(routine).or_default();
        let is_it = |&&path: &&CallPath| {
            self.calls.get(path).is_some_and(|call| call.within == within && same(&call.asked, asked))
        };
        if let Some(&path) = known.iter().find(is_it) {
            return path;
        }
        let path = self.calls.len();
        known.push(path);
        self.calls.push(FollowedCall { within, asked: Rc::clone(asked), found: None });
        path
    }

    /// What a call was entered with and left in an earlier round.
    pub(super) fn found(&self, path: CallPath) -> Option<(State, After)> {
        self.calls.get(path)?.found.clone()
    }

    /// Notes what a call was entered with and left.
    pub(super) fn note(&mut self, path: CallPath, entry: &State, after: &After) {
        if let Some(call) = self.calls.get_mut(path) {
            call.found = Some((entry.clone(), after.clone()));
        }
    }

    /// Forgets all of them: the outermost call has ended.
    pub(super) fn clear(&mut self) {
        self.calls.clear();
        self.of_routine.clear();
    }
}

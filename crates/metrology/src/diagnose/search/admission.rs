//! Which candidates may join those that are chosen.

use super::chosen::ChosenCause;
use super::library::Library;
use crate::diagnose::design::Design;
use crate::diagnose::effects::{Candidate, steps_too_near};
use robot_model::deform::EffectKind;
use std::collections::BTreeMap;

/// Most causes that are not gear lines, and most gear lines.
pub(super) const MOST_CAUSES: usize = 4;
const MOST_LINES: usize = 80;

impl Library<'_> {
    /// Whether `candidate` is the offsets of all joints at once.
    pub(super) fn all_offsets(&self, candidate: usize) -> bool {
        let this = &self.candidates[candidate];
        this.kind == EffectKind::JointOffset && this.variant.joint.is_none()
    }

    /// The offsets of single joints.
    pub(super) fn single_offsets(&self) -> Vec<usize> {
        let offset = |c: &usize| self.candidates[*c].kind == EffectKind::JointOffset;
        (0..self.candidates.len()).filter(|c| offset(c) && !self.all_offsets(*c)).collect()
    }

    /// Whether `candidate` may join: not twice the same, not too many.
    pub(super) fn allowed(&self, candidate: usize, chosen: &[ChosenCause]) -> bool {
        let this = &self.candidates[candidate];
        let line = |c: &Candidate| c.kind == EffectKind::GearMesh;
        let offset = |c: &Candidate| c.kind == EffectKind::JointOffset;
        let count = |of: &dyn Fn(&Candidate) -> bool| {
            chosen.iter().filter(|c| of(&self.candidates[c.candidate])).count()
        };
        let lines = count(&line);
        let room = if line(this) {
            lines < MOST_LINES
        } else {
            offset(this) || chosen.len() - lines - count(&offset) < MOST_CAUSES
        };
        room && chosen.iter().all(|c| {
            let other = &self.candidates[c.candidate];
            let same = other.kind == this.kind
                && other.variant.joint == this.variant.joint
                && other.variant.joint_b == this.variant.joint_b
                && other.variant.n == this.variant.n;
            let steps = this.variant.t0_min().zip(other.variant.t0_min());
            if steps.is_some_and(|(t0_min, other)| steps_too_near(self.dataset, t0_min, other)) {
                return false;
            }
            !same || steps.is_some_and(|(t0_min, other)| t0_min != other)
        })
    }

    /// The candidate's columns in the design, appended when new; [`Self::extend`] has to follow.
    pub fn columns_in_design(
        &mut self,
        design: &mut Design,
        column_index: &mut BTreeMap<usize, Vec<usize>>,
        candidate: usize,
    ) -> Vec<usize> {
        if let Some(columns) = column_index.get(&candidate) {
            return columns.clone();
        }
        let columns = design.columns_of(self.dataset, &self.candidates[candidate]);
        let at: Vec<usize> = design.append(columns).collect();
        column_index.insert(candidate, at.clone());
        at
    }
}

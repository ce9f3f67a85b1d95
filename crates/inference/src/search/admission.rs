//! Which candidates may join those that are chosen.

use super::chosen::ChosenCause;
use super::library::Library;
use crate::design::Design;
use crate::effects::{Candidate, steps_too_near};
use crate::gear_lines::AngleSpectra;
use robot_model::deform::EffectKind;
use std::collections::BTreeMap;

/// Most causes that are not gear lines: an arm has a dozen gears, links and bearings that each give a little, and what is left
/// out is taken by others. Most gear lines.
const MOST_CAUSES: usize = 10;
const MOST_LINES: usize = 80;
/// Different angles of a joint that each line of its gear needs.
const ANGLES_PER_LINE: usize = 3;

impl Library<'_> {
    /// Whether `candidate` is the offsets of all joints at once.
    pub(super) fn all_offsets(&self, candidate: usize) -> bool {
        let this = &self.candidates[candidate];
        this.kind == EffectKind::JointOffset && this.of_all_joints()
    }

    /// Whether `candidate` is the compliance of all joints at once.
    pub fn all_springs(&self, candidate: usize) -> bool {
        let this = &self.candidates[candidate];
        this.kind == EffectKind::JointCompliance && this.of_all_joints()
    }

    /// Whether `candidate` stands for all joints at once.
    pub(super) fn of_all_joints(&self, candidate: usize) -> bool {
        self.candidates[candidate].of_all_joints()
    }

    /// The linear springs of those joints of which none is among the candidates `taken`.
    pub fn single_springs(&self, taken: &[usize]) -> Vec<usize> {
        let spring = |c: &Candidate| c.kind == EffectKind::JointCompliance;
        let joint = |c: &usize| self.candidates[*c].variant.joint;
        let is_taken = |c: &usize| {
            taken.iter().any(|other| spring(&self.candidates[*other]) && joint(other) == joint(c))
        };
        (0..self.candidates.len())
            .filter(|c| spring(&self.candidates[*c]) && joint(c).is_some())
            .filter(|c| !self.candidates[*c].variant.refined && !is_taken(c))
            .collect()
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
        let is_distinct = this.variant.n.is_none() || self.angles_tell_another_line(this, chosen);
        room && is_distinct
            && chosen.iter().all(|c| {
                let other = &self.candidates[c.candidate];
                let same = other.kind == this.kind
                    && other.variant.joint == this.variant.joint
                    && other.variant.joint_b == this.variant.joint_b
                    && other.variant.n == this.variant.n;
                let steps = this.variant.t0_min().zip(other.variant.t0_min());
                if steps.is_some_and(|(t0_min, other)| steps_too_near(&self.stops, t0_min, other)) {
                    return false;
                }
                !same || steps.is_some_and(|(t0_min, other)| t0_min != other)
            })
    }

    /// Whether the joint of `line` stood at angles enough for it beside the lines chosen: on a grid of few angles lines of
    /// other periods are the same numbers.
    fn angles_tell_another_line(&self, line: &Candidate, chosen: &[ChosenCause]) -> bool {
        let Some(joint) = line.variant.joint else { return true };
        let of_joint = |c: &&ChosenCause| {
            let variant = &self.candidates[c.candidate].variant;
            variant.joint == Some(joint) && variant.n.is_some()
        };
        let others = chosen
            .iter()
            .filter(of_joint)
            .filter(|c| self.candidates[c.candidate].variant.n != line.variant.n);
        self.angles.get(joint.index()).is_some_and(|angles| *angles >= ANGLES_PER_LINE * (1 + others.count()))
    }

    /// Lines of the same gear that are nearly the same numbers as `candidate` at the angles measured, and other ones between them.
    pub fn aliases(&self, candidate: usize, spectra: &mut AngleSpectra) -> Vec<usize> {
        let this = &self.candidates[candidate];
        let (EffectKind::GearMesh, Some(joint), Some(n)) = (this.kind, this.variant.joint, this.variant.n)
        else {
            return Vec::new();
        };
        let mut is_alias = |other: &Candidate| {
            other.kind == EffectKind::GearMesh
                && other.variant.joint == Some(joint)
                && other.variant.n.is_some_and(|m| spectra.are_aliases(self.dataset, joint, n, m))
        };
        (0..self.candidates.len()).filter(|&c| is_alias(&self.candidates[c])).collect()
    }

    /// The candidates' columns in the design, appended when new; [`Self::extend`] has to follow.
    pub fn columns_in_design(
        &self,
        design: &mut Design,
        column_index: &mut BTreeMap<usize, Vec<usize>>,
        candidates: &[usize],
    ) -> Vec<Vec<usize>> {
        let mut new: Vec<usize> = Vec::new();
        for candidate in candidates {
            if !column_index.contains_key(candidate) && !new.contains(candidate) {
                new.push(*candidate);
            }
        }
        if !new.is_empty() {
            let width_of = |c: usize| self.candidates[c].prior_sigma.len();
            let width = new.iter().map(|&c| width_of(c)).sum();
            let mut at =
                design.append_parts(width, new.len(), |design, number| self.columns_at(design, new[number]));
            for candidate in new {
                column_index.insert(candidate, at.by_ref().take(width_of(candidate)).collect());
            }
        }
        candidates.iter().map(|candidate| column_index[candidate].clone()).collect()
    }
}

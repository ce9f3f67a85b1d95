//! Motions that are corrected only where the settled arm says that one correction serves all that the text leaves open.

use super::model::Model;
use super::nominal::Resolved;
use crate::program::Program;
use crate::program::motion::{Motion, SkipReason};
use crate::schedule::Moment;
use rayon::prelude::*;
use robot_model::deform::DeformedArm;
use std::sync::Arc;

/// Leaves each motion as it is for which `why` has a reason, asked with the motion's position and the settled arm, where drift is
/// largest.
pub(super) fn keep_where(
    program: &Program,
    model: &Model<'_>,
    resolved: &mut [Resolved],
    why: impl Fn(usize, &Motion, &Resolved, &DeformedArm) -> Option<SkipReason> + Sync,
) {
    let settled = model.arm(Moment::Settled);
    program.motions.par_iter().zip(resolved).enumerate().for_each(|(at, (motion, resolved))| {
        if resolved.kept().is_none()
            && let Some(why) = why(at, motion, resolved, &settled)
        {
            resolved.keep(Arc::new(why));
        }
    });
}

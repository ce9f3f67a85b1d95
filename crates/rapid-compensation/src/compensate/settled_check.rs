//! Motions that are corrected only where the settled arm says that one correction serves all that the text leaves open.

use super::model::Model;
use super::resolved::Resolved;
use crate::schedule::Moment;
use rapid_program::Program;
use rapid_program::motion::{Motion, MotionId, SkipReason};
use robot_model::deform::DeformedArm;
use std::sync::Arc;

/// So many motions are looked at one after the other by one thread.
const AT_ONE_GO: usize = 256;

/// Leaves each motion as it is for which `why` has a reason, asked with the motion's number and the settled arm, where drift is
/// largest.
pub(super) fn skip_where(
    program: &Program,
    model: &Model<'_>,
    resolved: &mut [Resolved],
    why: &(dyn Fn(MotionId, &Motion, &Resolved, &DeformedArm) -> Option<SkipReason> + Sync),
) {
    let settled = model.arm(Moment::Settled);
    parallel::for_each_chunk_mut(resolved, AT_ONE_GO, &|first, resolved| {
        for (at, resolved) in (first..).zip(resolved) {
            if resolved.skip_reason().is_none()
                && let Some(why) = why(MotionId::new(at), &program.motions[at], resolved, &settled)
            {
                resolved.skip(Arc::new(why));
            }
        }
    });
}

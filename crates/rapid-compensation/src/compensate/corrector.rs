//! Each motion's plan: its targets' corrections, solved once, in the form that it takes.

use super::at_run_time::NOT_ASKED;
use super::correct::{Moments, MotionCorrection, correct, skipped};
use super::figures::Tally;
use super::follow_paths::follow_paths;
use super::later_frames::later_error_m;
use super::live;
use super::live_basis::LiveBasis;
use super::model::Model;
use super::options::{FormChoice, Options};
use super::plan::{Form, PlannedMotion};
use super::quadrant_border::Crossing;
use super::ramp_errors::add_errors_of_ramp;
use super::resolved::{Point, Resolved};
use super::shared_corrections::share_corrections;
use super::warm_joints::{CommandedOrSkipped, commanded_joints_of_each};
use crate::schedule::Chosen;
use rapid_program::Program;
use rapid_program::motion::{Motion, MotionId, SkipReason, Target};
use rapid_program::one_or_many::OneOrMany;
use robot_model::deform::DeformedArm;
use std::sync::Arc;

/// Motions that are corrected at one go: enough to share among cores, few enough for their figures to stay small.
const AT_ONE_GO: usize = 4096;
/// The points of so many motions are solved side by side.
pub(super) const SIDE_BY_SIDE: usize = 128;
/// Where tools or work objects of later passes leave more of the tolerance than this share, `auto` asks the model at run time.
const LATER_SHARE: f64 = 0.1;

/// Corrects one motion after the other.
pub(super) struct Corrector<'a> {
    pub(super) program: &'a Program,
    pub(super) model: &'a Model<'a>,
    pub(super) options: &'a Options,
    pub(super) at: &'a Moments,
    /// What `live` needs, where motions may take that form.
    pub(super) live: Option<&'a LiveBasis>,
    /// The arm where drift is largest.
    pub(super) settled: DeformedArm,
}

/// All motions of a program, corrected.
pub(super) struct CorrectedMotions {
    /// The plan of each motion.
    pub(super) motions: Vec<PlannedMotion>,
    /// The program's worst cases.
    pub(super) tally: Tally,
    /// The motions whose joints leave the quadrants that confdata name.
    pub(super) crossings: Vec<(MotionId, Crossing)>,
}

impl Corrector<'_> {
    /// The plans of all motions, with the figures of each.
    pub(super) fn correct_all(&self, resolved: &[Resolved], chosen: &Chosen) -> CorrectedMotions {
        let program = self.program;
        let mut tally = Tally::new(chosen);
        let mut motions: Vec<PlannedMotion> = Vec::with_capacity(resolved.len());
        let mut worst_bucket = Vec::with_capacity(resolved.len());
        let mut crossings = Vec::new();
        for (some, resolved) in program.motions.chunks(AT_ONE_GO).zip(resolved.chunks(AT_ONE_GO)) {
            let made: Vec<Vec<MotionCorrection>> =
                parallel::map_chunks(some, SIDE_BY_SIDE, &|first, some| {
                    self.correct_some(some, &resolved[first..first + some.len()])
                });
            for made in made.into_iter().flatten() {
                let motion = MotionId::new(motions.len());
                tally.add(motion, &made);
                worst_bucket.push(made.worst_bucket as u32);
                crossings.extend(made.crossing.map(|crossing| (motion, crossing)));
                motions.push(made.planned);
            }
        }
        follow_paths((program, resolved), self.at.arms(), self.model, &worst_bucket, &mut motions);
        CorrectedMotions { motions, tally, crossings }
    }

    /// The plans of some motions, their points solved side by side.
    fn correct_some(&self, motions: &[Motion], resolved: &[Resolved]) -> Vec<MotionCorrection> {
        let placed = motions.iter().zip(resolved);
        let points: Vec<OneOrMany<Point<'_>>> =
            placed.map(|(motion, resolved)| resolved.points(motion, self.model).collect()).collect();
        let all: Vec<&Point<'_>> = points.iter().flatten().collect();
        let arms = self.at.arms().as_slice().iter();
        let warm: Vec<Vec<CommandedOrSkipped>> =
            arms.map(|arm| commanded_joints_of_each(&all, arm, self.model)).collect();
        let (mut at, mut own_warm) = (0, Vec::with_capacity(warm.len()));
        let one = |((motion, resolved), points): ((&Motion, &Resolved), &OneOrMany<Point<'_>>)| {
            let own = at..at + points.len();
            at = own.end;
            own_warm.clear();
            own_warm.extend(warm.iter().map(|all| all.get(own.clone()).unwrap_or_default()));
            self.correct((motion, resolved), points, &own_warm)
        };
        let mut made: Vec<MotionCorrection> = motions.iter().zip(resolved).zip(&points).map(one).collect();
        if let Some(ramp) = self.at.ramp() {
            share_corrections(motions, &mut made);
            add_errors_of_ramp(&mut made, &points, ramp, self.model);
        }
        for (made, placed) in made.iter_mut().zip(motions.iter().zip(resolved)) {
            // What is asked at run time knows the frames that are in use.
            let later_m = self.later_m(placed).filter(|_| made.planned.form != Form::Live);
            if let (Some(later_m), Some(_), Some(last)) =
                (later_m, made.planned.error_m, made.error_m.last_mut())
            {
                last[1] = last[1].max(later_m);
                made.planned.error_m = Some(made.worst_error_m());
            }
        }
        made
    }

    /// What is left from the second pass on where tool or work object are others then, metres.
    fn later_m(&self, placed: (&Motion, &Resolved)) -> Option<f64> {
        later_error_m(placed, &self.settled, self.model)
    }

    fn correct(
        &self,
        (motion, resolved): (&Motion, &Resolved),
        points: &[Point<'_>],
        warm: &[&[CommandedOrSkipped]],
    ) -> MotionCorrection {
        if let Some(why) = resolved.skip_reason() {
            return self.at_run_time(motion, why);
        }
        // The model asked at run time takes values that the text does not hold, too: a point touched up, another module's. What is
        // written must then be the configuration that is reached.
        let can_ask = |live| live::form_of_known(self.program, (motion, resolved.q_rad()), live, self.model);
        if is_one_of_several(motion)
            && self.live.is_some_and(|live| can_ask(live) == Form::Live)
            && let Some(Ok(planned)) = self.asked_at_run_time(motion)
        {
            return MotionCorrection::without_figures(planned);
        }
        let mut made = correct((motion, points), warm, self.at, self.model, self.options);
        made.planned.form = self.settled_form(motion, resolved, made.planned.form);
        made
    }

    /// The plan of a motion that is not known well enough: what can be asked at run time is.
    fn at_run_time(&self, motion: &Motion, why: &Arc<SkipReason>) -> MotionCorrection {
        match self.asked_at_run_time(motion) {
            _ if NOT_ASKED.contains(&why.code) => skipped(Arc::clone(why)),
            Some(Ok(planned)) => MotionCorrection::without_figures(planned),
            Some(Err(why)) => skipped(Arc::new(why)),
            None => skipped(Arc::clone(why)),
        }
    }

    /// The plan of a motion that asks the model at run time; `None` where it cannot.
    fn asked_at_run_time(&self, motion: &Motion) -> Option<Result<PlannedMotion, SkipReason>> {
        let live = self.live.filter(|_| self.options.form.corrects_run_time())?;
        live::run_time(self.program, motion, live)
    }

    /// In the form `live` known targets that cannot take it take `ramp`; in `auto` those ask the model whose tool or work object is
    /// another one from the second pass on.
    fn settled_form(&self, motion: &Motion, resolved: &Resolved, form: Form) -> Form {
        let asks = match self.options.form {
            FormChoice::Schedule | FormChoice::Ramp => false,
            FormChoice::Live => true,
            FormChoice::Auto => {
                let later_m = self.later_m((motion, resolved)).unwrap_or(0.0);
                later_m > LATER_SHARE * self.options.tolerance_m
            }
        };
        match self.live.filter(|_| asks) {
            // What is asked at run time knows the point as it is written.
            Some(_) if resolved.turns_on_an_arc() => Form::Ramp,
            Some(live) => live::form_of_known(self.program, (motion, resolved.q_rad()), live, self.model),
            None => form,
        }
    }
}

/// Whether run time tells which of a few values the target is, and no index does.
fn is_one_of_several(motion: &Motion) -> bool {
    motion.targets.iter().any(Target::is_one_of)
}

//! Planning part by part: what must be known of the whole program first, then the plan of one part after the other.
//!
//! Where the motions end that other parts start from is found by going over the parts until nothing changes; the schedule is
//! chosen from the targets of all parts that drift most, time functions from targets all over them. Nothing is held that
//! grows with the number of motions.

use super::conditions;
use super::correct::{Made, Moments, compensated, correct, kept};
use super::corrector::WarmArms;
use super::exits::Exits;
use super::figures::{self, Tally};
use super::live::{self, LiveBasis};
use super::messages::Messages;
use super::model::Model;
use super::nominal::{Point, Resolved};
use super::plan::{Corrector, Form, Plan, PlannedMotion, Status, Summary};
use super::ramp::Ramp;
use super::rigid::{Supports, worst_of_parts_m};
use super::survey::{Exceptions, Nothing, Survey, own_points, resolved_to_follow};
use super::{CompensateError, FormChoice, Options, silence};
use crate::program::motion::{Keep, Motion};
use crate::program::{Part, Parts, Program};
use crate::schedule::{Chosen, Schedule, TimeFunctions, choose};
use rapid_syntax::diagnostic::Diagnostic;
use rayon::prelude::*;
use robot_model::deform::Deformation;
use robot_model::robot::Robot;
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::sync::Arc;

/// Motions that are corrected at one go: enough to share among cores, few enough for their figures to stay small.
const AT_ONE_GO: usize = 4096;

/// What became of a part's motions.
struct Fate {
    /// Of motions, by their number in the part's program, that have targets to be corrected and are not compensated.
    exceptions: BTreeMap<usize, Status>,
}

/// What is known of a program as a whole, and with it the plan of each part.
pub struct Planner<'a> {
    model: Model<'a>,
    options: &'a Options,
    temperature_c: Option<[f64; 2]>,
    exits: Exits,
    chosen: Chosen,
    at: Moments,
    /// What `live` needs, where motions may take that form.
    live: Option<Arc<LiveBasis>>,
    corrector: Arc<dyn Corrector>,
    /// What the motions of the only part come to, where there is one.
    only: Option<(Vec<Resolved>, Messages)>,
    /// The plan of the only part, once it was made.
    plan_of_only: Option<Plan>,
    /// For each part what the settled arm cannot follow.
    unfollowable: BTreeMap<usize, Exceptions>,
    /// What was found of the motions of each part that was planned.
    fates: Vec<Fate>,
    summary: Summary,
    /// What holds the shifts of the cheap rival in place, of all parts that were planned.
    supports: Supports,
    /// Some motion was found that does not stay as it is.
    corrected_any: bool,
    /// There is one part.
    single: bool,
    /// Why nothing of the only part can be compensated.
    nothing: Option<CompensateError>,
}

impl<'a> Planner<'a> {
    /// Goes over all parts as often as it takes to know what they have in common.
    ///
    /// # Errors
    /// [`CompensateError`] where no motion can be compensated or no schedule meets the request, or a part cannot be read.
    pub fn survey(
        parts: &mut dyn Parts,
        robot: &'a Robot,
        deformation: &'a Deformation,
        options: &'a Options,
    ) -> Result<Self, CompensateError> {
        let (temperature_c, deformation) = match deformation.above_lowest() {
            Some((range_c, above)) => (Some(range_c), Cow::Owned(above)),
            None => (None, Cow::Borrowed(deformation)),
        };
        let model = Model::new(robot, deformation, options, temperature_c.map(|range_c| range_c[0]))?;
        let mut survey = Survey::new(&model, options, parts);
        survey.settle()?;
        if survey.is_empty() {
            return Err(survey.nothing());
        }
        let ramp = match options.form {
            FormChoice::Schedule => None,
            FormChoice::Ramp | FormChoice::Live | FormChoice::Auto => {
                Some(Ramp::choose(&model, survey.samples(), options)?)
            }
        };
        let chosen = match &ramp {
            Some(ramp) => Ok(Chosen::without_buckets(ramp.until_min)),
            None => choose(&mut survey, &options.request()),
        };
        let Survey { exits, only, failed, unfollowable, .. } = survey;
        if let Some(failed) = failed {
            return Err(CompensateError::Part(Box::new(failed)));
        }
        let chosen = chosen?;
        let at = match ramp {
            Some(ramp) => Moments::Nodes(ramp),
            None => Moments::Buckets(model.warm(&chosen.schedule)),
        };
        let live = at.ramp().map(|ramp| Arc::new(LiveBasis::new(&model, &ramp.functions, options)));
        Ok(Self {
            corrector: Arc::new(WarmArms::new(&model, at.warm())),
            supports: vec![Vec::new(); chosen.schedule.buckets.len().max(1)],
            live,
            summary: figures::none_yet(&chosen),
            corrected_any: false,
            single: parts.count() == 1,
            nothing: None,
            unfollowable,
            fates: Vec::new(),
            plan_of_only: None,
            model,
            options,
            temperature_c,
            exits,
            chosen,
            at,
            only,
        })
    }

    /// Shows each part with its plan, in order.
    ///
    /// # Errors
    /// Those of reading a part.
    pub fn each(
        &mut self,
        parts: &mut dyn Parts,
        see: &mut dyn FnMut(Part<'_>, &Plan),
    ) -> Result<(), Diagnostic> {
        for part in 0..parts.count() {
            self.show(parts, part, &mut |_, part, plan| see(part, plan))?;
        }
        Ok(())
    }

    /// Shows a part with its plan.
    ///
    /// # Errors
    /// Those of reading it.
    pub fn show(
        &mut self,
        parts: &mut dyn Parts,
        part: usize,
        see: &mut dyn FnMut(&Self, Part<'_>, &Plan),
    ) -> Result<(), Diagnostic> {
        parts.visit(part, &mut |part| {
            let plan = self.plan_of_only.take().unwrap_or_else(|| self.plan(part));
            see(self, part, &plan);
            self.plan_of_only = self.single.then_some(plan);
        })
    }

    /// Shows each part once more with its plan, as it was found before but for the figures, which are left out.
    ///
    /// # Errors
    /// Those of reading a part.
    pub fn each_again(
        &mut self,
        parts: &mut dyn Parts,
        see: &mut dyn FnMut(Part<'_>, &Plan),
    ) -> Result<(), Diagnostic> {
        for number in 0..parts.count() {
            parts.visit(number, &mut |part| match (&self.plan_of_only, self.fates.get(number)) {
                (Some(plan), _) => see(part, plan),
                (None, Some(fate)) => see(part, &self.plan_again(part, fate)),
                (None, None) => {}
            })?;
        }
        Ok(())
    }

    fn plan_again(&self, part: Part<'_>, fate: &Fate) -> Plan {
        let resolved = self.resolved(part, &mut Messages::default());
        let planned = |(i, (motion, resolved)): (usize, (&Motion, &Resolved))| {
            let mut planned = match &resolved.points {
                Ok(points) => compensated(motion, points, (&self.at, &self.model), self.options),
                Err(why) => self.at_run_time(part.program, motion, why).planned,
            };
            if let Some(status) = fate.exceptions.get(&i) {
                planned.status = status.clone();
            }
            planned
        };
        let motions = part.program.motions.iter().zip(&resolved).enumerate().map(planned).collect();
        let mut motions: Vec<PlannedMotion> = motions;
        for (i, planned) in motions.iter_mut().enumerate() {
            let (motion, resolved) = (&part.program.motions[i], &resolved[i]);
            planned.form = self.settled_form(part.program, motion, resolved, planned.form);
        }
        self.plan_of(motions, self.summary.clone(), Vec::new())
    }

    /// The plan of a motion that is not known well enough: what can be asked at run time is.
    fn at_run_time(&self, program: &Program, motion: &Motion, why: &Keep) -> Made {
        let live = self.live.as_deref().filter(|_| self.options.form.corrects_run_time());
        match live.map(|live| live::run_time(program, motion, live)) {
            Some(Some(Ok(planned))) => Made::without_figures(planned),
            Some(Some(Err(why))) => kept(why),
            Some(None) | None => kept(why.clone()),
        }
    }

    /// In the form `live` known targets that cannot take it take `ramp`.
    fn settled_form(&self, program: &Program, motion: &Motion, resolved: &Resolved, form: Form) -> Form {
        let live = self.live.as_deref().filter(|_| self.options.form == FormChoice::Live);
        match (live, &resolved.points) {
            (Some(live), Ok(points)) => live::form_of_known(program, (motion, points), live, &self.model),
            _ => form,
        }
    }

    /// A known motion's correction in its form.
    fn correct(&self, program: &Program, motion: &Motion, resolved: &Resolved, points: &[Point]) -> Made {
        let mut made = correct(motion, points, &self.at, &self.model, self.options);
        made.planned.form = self.settled_form(program, motion, resolved, made.planned.form);
        if let Some(ramp) = self.at.ramp().filter(|_| made.planned.form == Form::Live) {
            let worst = points.iter().map(|point| ramp.errors_of_model_m(point, &self.model));
            let worst = worst
                .fold([0.0; 2], |most: [f64; 2], [before, after]| [most[0].max(before), most[1].max(after)]);
            made.planned.error_m = made.planned.error_m.map(|_| worst);
            made.error_m.iter_mut().for_each(|error_m| *error_m = worst);
        }
        made
    }

    fn plan_of(&self, motions: Vec<PlannedMotion>, summary: Summary, diagnostics: Vec<Diagnostic>) -> Plan {
        Plan {
            schedule: self.chosen.schedule.clone(),
            temperature_c: self.temperature_c,
            motions,
            functions: self.functions().cloned(),
            live: self.live.clone(),
            corrector: Arc::clone(&self.corrector),
            summary,
            diagnostics,
        }
    }

    /// When which bucket is in use.
    #[must_use]
    pub fn schedule(&self) -> &Schedule {
        &self.chosen.schedule
    }

    /// What scales the corrections of the forms `ramp` and `live`.
    #[must_use]
    pub fn functions(&self) -> Option<&TimeFunctions> {
        self.at.ramp().map(|ramp| &ramp.functions)
    }

    /// For a deformation by temperature its range, degrees Celsius.
    #[must_use]
    pub fn temperature_c(&self) -> Option<[f64; 2]> {
        self.temperature_c
    }

    /// The plan of a program in one part, once it was made.
    #[must_use]
    pub fn plan_of_only(&self) -> Option<&Plan> {
        self.plan_of_only.as_ref()
    }

    /// The plan of a part: its summary and its diagnostics are of the part's own motions.
    fn plan(&mut self, part: Part<'_>) -> Plan {
        let program = part.program;
        let (resolved, mut messages) = self.only.take().unwrap_or_else(|| {
            let mut messages = Messages::default();
            (self.resolved(part, &mut messages), messages)
        });
        let Self { model, options, at, chosen, .. } = &*self;
        conditions::check(program, model, &resolved, &mut messages);
        let mut tally = Tally::new(chosen);
        let mut motions: Vec<PlannedMotion> = Vec::with_capacity(resolved.len());
        let mut worst_bucket = Vec::with_capacity(resolved.len());
        for (some, resolved) in program.motions.chunks(AT_ONE_GO).zip(resolved.chunks(AT_ONE_GO)) {
            let one = |(motion, resolved): (&Motion, &Resolved)| match &resolved.points {
                Ok(points) => self.correct(program, motion, resolved, points),
                Err(why) => self.at_run_time(program, motion, why),
            };
            let made: Vec<Made> = some.par_iter().zip(resolved).map(one).collect();
            for ((motion, resolved), made) in some.iter().zip(resolved).zip(made) {
                if program.is_own(motion) {
                    tally.add(resolved, &made);
                }
                worst_bucket.push(made.worst_bucket);
                // Copied: what stays lies together, not among what the threads worked with.
                motions.push(made.planned.clone());
            }
        }
        let warm = at.warm();
        figures::follow_paths(program, &resolved, warm, model, &worst_bucket, &mut motions);
        let compensated = own_points(program, &resolved)
            .filter(|(i, _)| motions[*i].status == Status::Compensated)
            .flat_map(|(_, points)| points);
        let (summary, supports) = tally.summary(model, compensated.collect(), &chosen.schedule);
        let own = program.motions.iter().zip(&motions).filter(|(motion, _)| program.is_own(motion));
        let corrected_any = own.into_iter().any(|(_, planned)| !matches!(planned.status, Status::Kept(_)));
        if options.strict && (corrected_any || !self.single) {
            motions.iter_mut().for_each(refuse_kept);
        }
        let nothing = (self.single && !corrected_any).then(|| {
            let (mut nothing, mut said) = (Nothing::default(), messages.clone());
            conditions::check_model(model, None, &mut said);
            let reason = |i: usize| match &motions.get(i)?.status {
                Status::Kept(why) => Some(&**why),
                Status::Compensated | Status::Refused(_) => None,
            };
            nothing.add(program, reason, said);
            nothing.into()
        });
        messages.add_statuses(program, &motions);
        messages.add_paths(program, &motions, options);
        messages.add_search_results(program, &motions);
        messages.add_long_gaps(program, &silence::too_long(program, &resolved, &motions, options.gap_min));
        self.corrected_any |= corrected_any;
        self.nothing = nothing;
        if part.number == self.fates.len() {
            let exception = |(i, planned): (usize, &PlannedMotion)| {
                let is_one = planned.status != Status::Compensated && resolved[i].points.is_ok();
                is_one.then(|| (i, planned.status.clone()))
            };
            let exceptions = motions.iter().enumerate().filter_map(exception).collect();
            self.fates.push(Fate { exceptions });
            self.summary.add(&summary);
            self.supports.iter_mut().zip(supports).for_each(|(all, own)| all.extend(own));
        }
        self.plan_of(motions, summary, messages.finish())
    }

    /// Whether the schedule goes by minutes, so that joints can be given at each.
    ///
    /// # Errors
    /// [`CompensateError::Temperature`].
    pub fn check_minutes(&self) -> Result<(), CompensateError> {
        self.model().map(drop)
    }

    /// The arms.
    pub(super) fn model(&self) -> Result<&Model<'a>, CompensateError> {
        // Degrees are no minutes.
        if self.temperature_c.is_some() { Err(CompensateError::Temperature) } else { Ok(&self.model) }
    }

    /// The motions of a part's program.
    pub(super) fn resolved(&self, part: Part<'_>, messages: &mut Messages) -> Vec<Resolved> {
        let known = self.unfollowable.get(&part.number);
        resolved_to_follow(part.program, (&self.model, self.options, &self.exits), known, messages)
    }

    /// Figures over all parts, once each was planned, and what there is to be said of the program as a whole.
    ///
    /// # Errors
    /// [`CompensateError::NothingToCompensate`] where all motions stay as they are.
    pub fn conclude(&self) -> Result<(Summary, Vec<Diagnostic>), CompensateError> {
        if !self.corrected_any {
            return Err(self.nothing.clone().unwrap_or(CompensateError::NoMotion));
        }
        let mut summary = self.summary.clone();
        if self.fates.len() > 1 {
            summary.rigid_shift_worst_m = worst_of_parts_m(&self.supports);
        }
        let mut messages = Messages::default();
        messages.add_schedule(&self.chosen, &summary, self.options);
        conditions::check_model(&self.model, Some(&self.chosen.schedule), &mut messages);
        Ok((summary, messages.finish()))
    }
}

fn refuse_kept(motion: &mut PlannedMotion) {
    if let Status::Kept(why) = &motion.status {
        motion.status = Status::Refused(why.clone());
    }
}

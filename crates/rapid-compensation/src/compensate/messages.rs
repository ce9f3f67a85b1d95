//! Messages, each said once per routine however often it applies.

use super::options::Options;
use super::plan::{Form, PathDeviation, PlannedMotion, Status, Summary};
use crate::schedule::{Chosen, Width};
use rapid_program::Program;
use rapid_program::motion::{
    Motion, MotionId, Origin, Path, PersTarget, PersUse, RoutineId, SkipReason, Target,
};
use rapid_syntax::diagnostic::{Diagnostic, Span};
use robot_model::units::mm_from_m;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

/// Messages by routine and code.
#[derive(Clone, Default)]
pub(super) struct Messages(BTreeMap<(Option<RoutineId>, &'static str), (Diagnostic, usize)>);

impl Messages {
    /// Adds one; of several with the same code in the same routine the first in the file is told, with
    /// their number.
    pub(super) fn add(&mut self, routine: Option<RoutineId>, message: Diagnostic) {
        self.add_with(routine, message.code, message.span, || message);
    }

    /// The same of one with this code and place, which is made where it is the first.
    pub(super) fn add_with(
        &mut self,
        routine: Option<RoutineId>,
        code: &'static str,
        span: Option<Span>,
        message: impl FnOnce() -> Diagnostic,
    ) {
        match self.0.entry((routine, code)) {
            Entry::Vacant(free) => {
                free.insert((message(), 0));
            }
            Entry::Occupied(mut taken) => {
                let (first, more) = taken.get_mut();
                *more += 1;
                if span < first.span {
                    *first = message();
                }
            }
        }
    }

    /// Why a motion stays as it is.
    pub(super) fn add_skipped(&mut self, motion: &Motion, why: &SkipReason) {
        let message =
            format!("line {}: this {} stays as it is: {}", motion.line, motion.setup.kind, why.reason);
        let mut message = Diagnostic::warning(why.code, message).at(span_of(motion));
        if let Some(because) = why.because {
            message = message.label(because, "because of this");
        }
        self.add(Some(motion.setup.routine), message);
    }

    /// What there is to be said of planned motions; `long_gaps` are those from which on the arm may move for longer than the
    /// clock's gap without asking.
    pub(super) fn add_motions(
        &mut self,
        program: &Program,
        planned: &[PlannedMotion],
        options: &Options,
        long_gaps: &[MotionId],
    ) {
        self.add_statuses(program, planned);
        self.add_paths(program, planned, options);
        self.add_search_results(program, planned);
        self.add_values_of_the_file(program, planned);
        self.add_long_gaps(program, long_gaps);
    }

    /// What was kept and refused, and why.
    fn add_statuses(&mut self, program: &Program, planned: &[PlannedMotion]) {
        for (motion, planned) in program.motions.iter().zip(planned) {
            match &planned.status {
                Status::Compensated => {}
                Status::Kept(why) => self.add_skipped(motion, why),
                Status::Refused(why) => {
                    let message =
                        format!("line {}: {} is refused: {}", motion.line, described(motion), why.reason);
                    let mut message = Diagnostic::error(why.code, message).at(span_of(motion));
                    if let Some(because) = why.because {
                        message = message.label(because, "because of this");
                    }
                    if let Some(help) = way_out(why.code, motion, program) {
                        message = message.help(help);
                    }
                    self.add(Some(motion.setup.routine), message);
                }
            }
        }
    }

    /// Linear and circular moves that leave their way.
    fn add_paths(&mut self, program: &Program, planned: &[PlannedMotion], options: &Options) {
        let mut worst: BTreeMap<RoutineId, (f64, &Motion, usize)> = BTreeMap::new();
        for (motion, planned) in program.motions.iter().zip(planned) {
            if planned.mid_path == PathDeviation::OutOfReach {
                self.add(Some(motion.setup.routine), out_of_reach(motion));
            }
            let Some(far_m) = planned.mid_path.metres() else { continue };
            if matches!(motion.setup.path, Path::Linear | Path::Circular) && far_m > options.path_tolerance_m
            {
                let entry = worst.entry(motion.setup.routine).or_insert((far_m, motion, 0));
                entry.2 += 1;
                if far_m > entry.0 {
                    (entry.0, entry.1) = (far_m, motion);
                }
            }
        }
        for (routine, (far_m, motion, moves)) in worst {
            let message = format!(
                "line {}: {} leaves its {} by {:.4} mm between its targets ({moves} such in this routine, this is \
                 the worst)",
                motion.line,
                described(motion),
                if motion.setup.path == Path::Linear { "straight line" } else { "arc" },
                mm_from_m(far_m)
            );
            let help = "more points on the way bring it down; after a kept motion the way starts uncorrected";
            self.add(Some(routine), Diagnostic::warning("path::mid", message).at(span_of(motion)).help(help));
        }
    }

    /// What the schedule leaves where the request overrules the tolerance.
    pub(super) fn add_schedule(&mut self, chosen: &Chosen, summary: &Summary, options: &Options) {
        if summary.worst_after_m <= options.tolerance_m {
            return;
        }
        let left_mm = mm_from_m(summary.worst_after_m);
        let message = match options.width {
            Width::Fixed { width_min } => {
                format!("buckets of {width_min} minutes leave up to {left_mm:.4} mm, more than the tolerance")
            }
            Width::Tolerance => format!(
                "the drift goes on after minute {}: the last bucket leaves up to {left_mm:.4} mm",
                chosen.until_min
            ),
        };
        let help = "leave the schedule's end and width to the tolerance, or accept what is left";
        self.add(None, Diagnostic::warning("schedule::over-tolerance", message).help(help));
    }

    /// Points that searches have found and that are corrected as other targets are.
    fn add_search_results(&mut self, program: &Program, planned: &[PlannedMotion]) {
        let live =
            |planned: &PlannedMotion| planned.status == Status::Compensated && planned.form == Form::Live;
        for (motion, _) in program.motions.iter().zip(planned).filter(|(m, p)| m.from_search && live(p)) {
            let message = format!(
                "line {}: this target, or its frame, is what a search has found, and is corrected as a point of the cold model is",
                motion.line
            );
            let help = "the warm arm found it with its drift: leave the motion as it is where it must meet what was found";
            self.add(
                Some(motion.setup.routine),
                Diagnostic::warning("live::search-result", message).at(span_of(motion)).help(help),
            );
        }
    }

    /// Targets and frames made of a PERS: in `schedule` the file's value of a target stands there, else the correction of that value.
    fn add_values_of_the_file(&mut self, program: &Program, planned: &[PlannedMotion]) {
        for PersTarget { motion, name, is_variable, declaration, goes_into } in &program.made_of_pers {
            let compensated = |planned: &&PlannedMotion| planned.status == Status::Compensated;
            let (Some(motion), Some(planned)) =
                (program.motion(*motion), planned.get(motion.index()).filter(compensated))
            else {
                continue;
            };
            let code = match planned.form {
                Form::Live => continue,
                Form::Schedule => "schedule::pers-value",
                _ => "ramp::pers-value",
            };
            let one_of = motion.targets.iter().any(Target::is_one_of);
            let (what, mut help) = of_the_file(planned.form, *goes_into, one_of);
            if *is_variable {
                help = "give the file too that sets it, and the motion is corrected, or kept, by what it is set to";
            }
            let kind = match is_variable {
                false => "is a PERS",
                true => {
                    "is a VAR that nothing among the given files sets, while main or something that is called is not among them"
                }
            };
            let message = format!("line {}: {name} {kind}: {what}", motion.line);
            self.add(
                Some(motion.setup.routine),
                Diagnostic::warning(code, message)
                    .at(span_of(motion))
                    .label(*declaration, "declared here")
                    .help(help),
            );
        }
    }

    /// Ways on which the arm moves for longer than the clock's gap without asking.
    fn add_long_gaps(&mut self, program: &Program, long_gaps: &[MotionId]) {
        for motion in long_gaps.iter().filter_map(|&id| program.motion(id)) {
            let message = format!(
                "line {}: from here on the arm may move for longer without asking than the gap that the clock takes for a \
                 pause",
                motion.line
            );
            let help =
                "it would then take the arm for cooling: call tcUpdate there, or give a longer --gap-min";
            self.add(
                Some(motion.setup.routine),
                Diagnostic::warning("clock::long-motion", message).at(span_of(motion)).help(help),
            );
        }
    }

    /// All messages, in the order of their places.
    pub(super) fn finish(self) -> Vec<Diagnostic> {
        let mut all: Vec<Diagnostic> = self
            .0
            .into_values()
            .map(|(mut first, more)| {
                if more > 0 {
                    first.message.push_str(&format!(" ({more} more like this in the same routine)"));
                }
                first
            })
            .collect();
        sorting::by(&mut all, |a, b| (a.span, a.code).cmp(&(b.span, b.code)));
        all
    }
}

/// What becomes of a motion that a PERS goes into, and what to do; `one_of`: its target is one of a few that the text knows.
fn of_the_file(form: Form, goes_into: PersUse, one_of: bool) -> (&'static str, &'static str) {
    match (form, goes_into) {
        (_, PersUse::Frames) => (
            "the work object or tool of this motion is made of it, and has its value of the moment, with the correction that belongs to \
             the value that the file has",
            "right within some millimetres of the frame; where it is set elsewhere compensate anew, or --form live asks for its \
             correction too",
        ),
        (Form::Schedule, PersUse::Target) => (
            "in the form schedule this motion goes by the value that the file has, and no longer by what is set on the controller",
            "--form ramp and --form auto go by its value of the moment; else check it against the controller, and compensate anew when it is changed",
        ),
        (_, PersUse::Target) if one_of => (
            "this motion is corrected where it goes by the value that the file has, and goes uncorrected by another",
            "where it is set elsewhere compensate anew, or --form live asks for its correction too",
        ),
        (_, PersUse::Target) => (
            "this motion goes by its value of the moment, with the correction that belongs to the value that the file has",
            "right within some millimetres, as of a point that is touched up; where it is set elsewhere compensate anew, or --form live asks for its correction too",
        ),
    }
}

/// A line or an arc on which no joints lead from one target to the next.
fn out_of_reach(motion: &Motion) -> Diagnostic {
    let message = format!(
        "line {}: between its targets {} leads where the arm does not get in the configuration of its end: the controller stops there, \
         and how far the way is off is not known",
        motion.line,
        described(motion)
    );
    let help =
        "go there by a joint move, or by a point between that the arm reaches; `simulate` shows the place";
    Diagnostic::warning("path::out-of-reach", message).at(span_of(motion)).help(help)
}

/// What to do about a motion for which the program is refused: by itself it would do no harm as it is.
fn way_out(code: &str, motion: &Motion, program: &Program) -> Option<String> {
    let named = motion.targets.iter().find_map(|target| match target.origin() {
        Origin::Named { name, .. } => Some(name),
        Origin::Inline | Origin::Expression(_) => None,
    });
    let (whose, name) = match named {
        Some(target) => ("the motions to it", target),
        None => ("the motions of its routine", &program.routine_of(motion)?.name),
    };
    let keep = format!("--keep {name} writes the program with {whose} as they are");
    match code {
        "reach::limit" => Some(format!(
            "move the target away from the limit; {keep}; where many are told of, look whether --robot is the program's robot"
        )),
        "refuse::configuration" => Some(format!("move the target away from the border; {keep}")),
        _ => None,
    }
}

/// A motion by the name of its target, where it has one.
fn described(motion: &Motion) -> String {
    match motion.targets.last().map(Target::origin) {
        Some(Origin::Named { name, .. }) => format!("{} to {name}", motion.setup.kind),
        _ => motion.setup.kind.to_string(),
    }
}

/// Where a motion stands.
pub(super) fn span_of(motion: &Motion) -> Span {
    Span { file: motion.file, range: motion.range }
}

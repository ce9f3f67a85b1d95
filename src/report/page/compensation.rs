//! The page of a compensation, or of the reasons why there is none.

use super::model_view::ModelView;
use super::scene::{Course, Points, robot};
use super::source_review::SourceReview;
use super::{Page, write_page};
use crate::report::json::{CompensationJson, refusal};
use crate::report::message::LocatedDiagnostic;
use rapid_compensation::compensate::plan::{Plan, PlannedMotion, Status, Totals};
use rapid_compensation::compensate::{DriftPoint, TcpDrift};
use rapid_program::Program;
use rapid_program::motion::{Motion, MotionId, SkipReason};
use robot_model::robot::Robot;
use robot_model::units::mm_from_m;
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::io::{self, Write};
use std::sync::Arc;

/// A page of more motions shows those that are kept or refused and, of the others, the worst.
const MOST_MOTIONS: usize = 25_000;
/// Of those that are kept or refused no more than so many.
const MOST_NOT_CORRECTED: usize = 10_000;

/// What the page of a compensation is made of.
pub struct CompensationPage<'a> {
    /// What a review calls the program.
    pub title: &'a str,
    /// The program as far as it was read.
    pub program: &'a Program,
    /// The plan as far as it was made.
    pub plan: Option<&'a Plan>,
    /// Why each motion is kept, where there is no plan.
    pub kept: &'a [Arc<SkipReason>],
    /// What there is to be said.
    pub messages: &'a [LocatedDiagnostic],
    /// The arm, and how its targets drift.
    pub arm: Option<(&'a Robot, &'a TcpDrift)>,
    /// It is the reference paper's robot with its table and law: its published figures can stand beside ours.
    pub is_papers_case: bool,
    /// What was asked for and with what: names and values.
    pub provenance: &'a [(&'static str, String)],
    /// Options that a reviewer needs to know.
    pub settings: &'a [(String, String)],
    /// The changes of each file.
    pub source: SourceReview,
}

impl CompensationPage<'_> {
    /// Writes the page.
    ///
    /// # Errors
    /// What writing to `out` fails with.
    pub fn write(mut self, out: &mut dyn Write) -> io::Result<()> {
        let shown = self.choose_shown();
        let Self { program, plan, messages, kept, .. } = self;
        let title = self.title.to_owned();
        let view = self.view(shown.as_ref());
        match plan {
            Some(plan) => {
                let data =
                    CompensationJson { program, plan, messages, shown: shown.as_ref(), without_nulls: true };
                write_page(out, &Page { command: "compensate", title, data, view })
            }
            None => {
                let data = refusal(program, kept, messages);
                write_page(out, &Page { command: "compensate", title, data, view })
            }
        }
    }

    /// Writes one page of several tasks, each with its name: their JSON and what a picture needs as lists under `tasks`.
    ///
    /// # Errors
    /// What writing to `out` fails with.
    pub fn write_tasks(title: &str, tasks: Vec<(&str, Self)>, out: &mut dyn Write) -> io::Result<()> {
        let (mut all_data, mut all_views) = (Vec::new(), Vec::new());
        for (task, mut page) in tasks {
            let shown = page.choose_shown();
            let Self { program, plan, messages, kept, .. } = page;
            let mut data = match plan {
                Some(plan) => {
                    let shown = shown.as_ref();
                    serde_json::to_value(CompensationJson {
                        program,
                        plan,
                        messages,
                        shown,
                        without_nulls: true,
                    })?
                }
                None => serde_json::to_value(refusal(program, kept, messages))?,
            };
            data["task"] = task.into();
            all_data.push(data);
            all_views.push(page.view(shown.as_ref()));
        }
        let (data, view) = (json!({ "tasks": all_data }), json!({ "tasks": all_views }));
        write_page(out, &Page { command: "compensate", title: title.to_owned(), data, view })
    }

    /// Chooses the motions that are shown (`None` = all), and adds the lines of those that stay as they are.
    fn choose_shown(&mut self) -> Option<BTreeSet<MotionId>> {
        let shown = self.shown();
        self.add_unchanged(shown.as_ref());
        shown
    }

    /// The motions that are shown; `None` = all.
    fn shown(&self) -> Option<BTreeSet<MotionId>> {
        let plan = self.plan.filter(|plan| plan.motions.len() > MOST_MOTIONS)?;
        let planned = |id: &MotionId| &plan.motions[id.index()];
        let is_corrected = |id: &MotionId| planned(id).status == Status::Compensated;
        let ids = || (0..plan.motions.len()).map(MotionId::new);
        let others = ids().filter(|id| !is_corrected(id));
        let mut shown: BTreeSet<MotionId> = others.take(MOST_NOT_CORRECTED).collect();
        let mut corrected: Vec<MotionId> = ids().filter(is_corrected).collect();
        let size = |id: &MotionId| planned(id).max_correction_m;
        sorting::by(&mut corrected, |a, b| size(b).total_cmp(&size(a)).then(a.cmp(b)));
        shown.extend(corrected.into_iter().take(MOST_MOTIONS - shown.len()));
        Some(shown)
    }

    /// The lines of motions that stay as they are.
    fn add_unchanged(&mut self, shown: Option<&BTreeSet<MotionId>>) {
        let stays = |i: usize| self.plan.is_none_or(|plan| plan.motions[i].status != Status::Compensated);
        let mut lines: BTreeMap<u32, BTreeSet<usize>> = BTreeMap::new();
        for (i, motion) in self.program.motions.iter().enumerate() {
            if stays(i) && shown.is_none_or(|shown| shown.contains(&MotionId::new(i))) {
                lines.entry(motion.file.0).or_default().insert(motion.line as usize);
            }
        }
        for (file, numbers) in lines {
            if let Some(file) = self.program.files.get(file as usize) {
                self.source.add_unchanged(&file.path, &file.bytes, numbers.into_iter());
            }
        }
    }

    fn view(&self, shown: Option<&BTreeSet<MotionId>>) -> Value {
        let totals = self.plan.map(|plan| Totals::of(self.program, plan));
        let is_shown = |id: MotionId| shown.is_none_or(|shown| shown.contains(&id));
        let from_c = self.plan.and_then(|plan| plan.temperature_c).map(|[low_c, _]| low_c);
        let points: Vec<&DriftPoint> = self
            .arm
            .iter()
            .flat_map(|(_, drift)| &drift.points)
            .filter(|point| is_shown(point.motion))
            .collect();
        let worst = |side: usize| {
            let plan = self.plan?;
            Some(
                plan.summary
                    .bucket_error_m
                    .iter()
                    .map(|error_m| mm_from_m(error_m[side]))
                    .collect::<Vec<_>>(),
            )
        };
        json!({
            "totals": totals.map(|t| json!({
                "motions": t.motions, "compensated": t.compensated, "kept": t.kept, "refused": t.refused,
                "by_form": { "schedule": t.by_form[0], "ramp": t.by_form[1], "live": t.by_form[2] },
                "max_correction_mm": mm_from_m(t.max_correction_m),
            })),
            "shown": shown.map(BTreeSet::len),
            "routines": shown.map(|_| self.routines()),
            "bucket_error_mm": { "before": worst(0), "after": worst(1) },
            "robot": self.arm.map(|(arm, _)| robot(&arm.into())),
            "course": self.arm.map(|(_, drift)| Course::new(drift, from_c)),
            "points": self.arm.map(|_| Points::new(&points)),
            "model": self.arm.and_then(|(_, drift)| ModelView::new(drift, &points)),
            // what the paper's own method leaves at the ends of its three hours (docs/PAPER.md)
            "claims": self.is_papers_case.then(|| json!({
                "text": "left by the reference paper's method", "points": [[60, 0.03], [120, 0.06], [180, 0.073]],
            })),
            "provenance": self.provenance,
            "settings": self.settings,
            "source": self.source,
        })
    }

    /// Sums over all motions of each routine, where not every motion is shown.
    fn routines(&self) -> Vec<Value> {
        #[derive(Default)]
        struct Sum {
            motions: usize,
            compensated: usize,
            correction_m: f64,
            error_m: [f64; 2],
        }
        let Some(plan) = self.plan else { return Vec::new() };
        let mut sums: BTreeMap<(u32, usize), Sum> = BTreeMap::new();
        let add = |(motion, planned): (&Motion, &PlannedMotion)| {
            let sum = sums.entry((motion.file.0, motion.setup.routine.index())).or_default();
            sum.motions += 1;
            sum.compensated += usize::from(planned.status == Status::Compensated);
            sum.correction_m = sum.correction_m.max(planned.max_correction_m);
            let [before, after] = planned.error_m.unwrap_or_default();
            sum.error_m = [sum.error_m[0].max(before), sum.error_m[1].max(after)];
        };
        self.program.motions.iter().zip(&plan.motions).for_each(add);
        let row = |((file, routine), sum): (&(u32, usize), &Sum)| {
            json!({
                "file": self.program.files.get(*file as usize).map(|file| &file.path),
                "routine": self.program.routines.get(*routine).map(|routine| &routine.name),
                "motions": sum.motions, "compensated": sum.compensated,
                "max_correction_mm": mm_from_m(sum.correction_m),
                "before_mm": mm_from_m(sum.error_m[0]), "after_mm": mm_from_m(sum.error_m[1]),
            })
        };
        sums.iter().map(row).collect()
    }
}

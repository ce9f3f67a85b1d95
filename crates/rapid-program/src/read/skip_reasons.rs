//! Why a motion must stay as it is, as far as its statement and what is in force there tell.

use crate::data::{ToolData, WobjData, external_axis_letters};
use crate::flow::{BLOCKERS, Blocker};
use crate::index::{Ctx, Index};
use crate::motion::{Path, SkipReason};
use crate::motion_site::{MotionSite, MoveArgs};
use crate::move_instructions::Special;
use crate::state::State;
use crate::unknown_moves::target_named;
use rapid_syntax::diagnostic::Span;
use rapid_syntax::tree::StmtKind;

/// Reasons that a function asked at run time has not: it sees the values.
const KNOWN_AT_RUN_TIME: [&str; 8] = [
    "keep::runtime-target",
    "keep::parameter",
    "keep::loop-variable",
    "keep::function-result",
    "keep::no-value",
    "keep::not-declared",
    "keep::tool-unknown",
    "keep::wobj-unknown",
];

/// The reasons of one motion. One is told: the first that holds in every form, else the first.
pub(super) struct SkipReasons {
    /// The first that a function asked at run time has not.
    known_at_run_time: Option<SkipReason>,
    /// The first that holds in every form.
    lasting: Option<SkipReason>,
}

impl SkipReasons {
    /// Those of the statement itself.
    pub(super) fn of_statement(
        index: &Index<'_>,
        site: &MotionSite<'_>,
        ctx: Ctx,
        args: &MoveArgs<'_>,
    ) -> Self {
        let mut reasons = Self { known_at_run_time: None, lasting: None };
        if index.is_measurement_run(ctx) {
            let text = "it drives to a pose that is to be measured (driftpost plan): the sheet's joints are those of the plan";
            reasons.add(skip("keep::measurement-run", text.into()));
        }
        let form = site.form;
        reasons.extend(match (form.special, &site.stmt.kind) {
            (Special::NotGiven, StmtKind::Call(call)) => {
                Some(not_given(&site.kind(index), target_named(index, ctx, call)))
            }
            _ => special(form.special, form.name),
        });
        if let Some(not_read) = site.not_read {
            let reason = if not_read == site.stmt.range {
                "it was not understood"
            } else {
                "text that was not understood stands right beside it"
            };
            let because = Some(Span { file: ctx.file, range: not_read });
            reasons.add(SkipReason { code: "keep::not-read", reason: reason.into(), because });
        } else if args.targets.len() < form.targets.len() {
            reasons.add(skip("keep::not-read", format!("{} has too few arguments", form.name)));
        }
        if args.has("corr") {
            reasons.add(skip("keep::path-correction", "its path is corrected at run time (\\Corr)".into()));
        }
        reasons
    }

    /// Those of what is in force there; `None`: no way leads there.
    pub(super) fn add_state(
        &mut self,
        state: Option<&State>,
        (args, path): (&MoveArgs<'_>, Path),
        leaves_axes: [bool; 6],
    ) {
        let Some(state) = state else {
            return self.add(skip("keep::unreachable", "no way through the program leads here".into()));
        };
        if args.has("id") {
            self.add(skip("keep::multimove", "it moves together with another robot (\\ID)".into()));
        }
        // MoveAbsJ\NoEOffs goes to its joints whatever offset is in force.
        let no_offsets = args.options.iter().any(|(name, _)| name == "noeoffs");
        let does_not_hold = |hold: &Blocker| match hold {
            Blocker::ExternalOffset => no_offsets,
            Blocker::PlacedAxis(axis) => !leaves_axes[usize::from(*axis)],
            Blocker::WristOnArcs => path != Path::Circular,
            // Whether the tool turns on an arc is seen where its ends are placed.
            Blocker::CirclePointOrientation => true,
            _ => false,
        };
        let placed: Vec<u8> = BLOCKERS
            .iter()
            .zip(&state.blockers)
            .filter_map(|(hold, held)| match hold {
                Blocker::PlacedAxis(axis) if held.is_some() && !does_not_hold(hold) => Some(*axis),
                _ => None,
            })
            .collect();
        for (hold, held) in BLOCKERS.iter().zip(&state.blockers).filter(|(hold, _)| !does_not_hold(hold)) {
            if let Some(why) = held {
                let code = match hold {
                    Blocker::Displacement => "keep::displacement",
                    Blocker::ExternalOffset => "keep::external-offset",
                    Blocker::SoftServo | Blocker::ForceControl => "keep::soft-servo",
                    Blocker::LockedAxis => "keep::locked-axis",
                    Blocker::MultiMove => "keep::multimove",
                    Blocker::CirclePointOrientation | Blocker::WristOnArcs => "keep::circle-orientation",
                    Blocker::PlacedAxis(_) => "keep::external-base",
                };
                let reason = match hold {
                    Blocker::PlacedAxis(_) => format!("{}{}", why.reason, others_placed(&placed, *hold)),
                    _ => why.reason.clone(),
                };
                self.add(SkipReason { code, reason, because: why.because });
            }
        }
    }

    /// Those of a tool and a work object that do not go together, or that stand nowhere certain.
    pub(super) fn add_frames(&mut self, tool: &ToolData, wobj: &WobjData) {
        if tool.robhold == wobj.robhold {
            let text = if tool.robhold {
                "the robot is said to hold both the tool and the work object"
            } else {
                "the robot is said to hold neither the tool nor the work object"
            };
            self.add(skip("keep::robhold", text.into()));
        }
        if !wobj.ufprog || !wobj.ufmec.is_empty() {
            let unit = if wobj.ufmec.is_empty() { "another unit" } else { &wobj.ufmec };
            self.add(skip("keep::wobj-moved", format!("{unit} moves the work object")));
        }
    }

    /// That of a `CalcRobT` that is made for other frames.
    pub(super) fn add_other_frames(&mut self) {
        let text = "CalcRobT names another tool or work object than its motion";
        self.add(skip("keep::calc-frame", text.into()));
    }

    /// Adds a reason to those of the motion.
    pub(super) fn add(&mut self, reason: SkipReason) {
        let first_of_its_kind = match is_known_at_run_time(&reason) {
            true => &mut self.known_at_run_time,
            false => &mut self.lasting,
        };
        first_of_its_kind.get_or_insert(reason);
    }

    /// The reason to report, and whether a function that is asked at run time has none of them; `(None, false)` where there are none.
    pub(super) fn reported(self) -> (Option<SkipReason>, bool) {
        let known_at_run_time = self.lasting.is_none() && self.known_at_run_time.is_some();
        (self.lasting.or(self.known_at_run_time), known_at_run_time)
    }
}

impl Extend<SkipReason> for SkipReasons {
    fn extend<T: IntoIterator<Item = SkipReason>>(&mut self, reasons: T) {
        reasons.into_iter().for_each(|reason| self.add(reason));
    }
}

/// What is to be said of external axes that were placed before beside the one that a reason names: all of `placed` are to be fixed.
fn others_placed(placed: &[u8], named: Blocker) -> String {
    let is_other = |axis: u8| placed.contains(&axis) && named != Blocker::PlacedAxis(axis);
    let others = external_axis_letters((0..6).map(is_other));
    if others.is_empty() {
        return String::new();
    }
    let all = external_axis_letters((0..6).map(|axis| placed.contains(&axis)));
    format!("; so it is with {} (--base-fixed {all})", others.replace(',', ", "))
}

/// Whether a function that is asked at run time sees what the text does not tell.
pub(super) fn is_known_at_run_time(reason: &SkipReason) -> bool {
    KNOWN_AT_RUN_TIME.contains(&reason.code)
}

fn special(special: Special, name: &str) -> Option<SkipReason> {
    match special {
        // What a call of something that is not given hands over is looked at by itself.
        Special::Plain | Special::NotGiven => None,
        Special::Search => Some(skip(
            "keep::search",
            format!("{name} searches: where it stops is what the program wants to know"),
        )),
        Special::External => Some(skip("keep::external-axes", format!("{name} moves external axes only"))),
        Special::Sensor => Some(skip(
            "keep::instruction",
            format!("{name} follows a sensor: only run time tells where it moves the arm"),
        )),
        Special::Unsupported => Some(skip(
            "keep::instruction",
            format!("{name} is not among the instructions that are understood"),
        )),
    }
}

/// Why a call of what is not among the files stays as it is; `target`: what it is handed of targets.
fn not_given(name: &str, target: Option<String>) -> SkipReason {
    let with = target.map_or_else(String::new, |target| format!(" with {target}"));
    let text = format!(
        "{name} is neither an instruction that is known nor among the given files: nobody knows where it moves the arm{with}"
    );
    skip("keep::instruction", text)
}

/// A reason without a place of its own.
pub(super) fn skip(code: &'static str, reason: String) -> SkipReason {
    SkipReason { code, reason, because: None }
}

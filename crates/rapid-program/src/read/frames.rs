//! Tool and work object of a motion, in the first pass of its program and in later ones.

use super::MotionReader;
use super::skip_reasons::{SkipReasons, skip};
use crate::const_eval::{Constant, TrackedValues};
use crate::convert;
use crate::data::{ToolData, WobjData};
use crate::ids::DatumId;
use crate::index::{Ctx, DatumKind};
use crate::motion::{LaterFrames, Path, SkipReason};
use crate::motion_site::MoveArgs;
use crate::names::as_text;
use crate::other_tasks;
use crate::state::{LeftBehind, State, View};
use crate::value::{DataName, Value, Why, why};
use rapid_syntax::diagnostic::{Diagnostic, Span};
use rapid_syntax::tree::{DataKind, Expr};

/// More pairs of tool and work object are not looked at.
const MOST_LATER: usize = 16;

impl<'f, 'a> MotionReader<'f, 'a> {
    /// Tool and work object in force. A MoveAbsJ needs neither: what is not known of them is no reason there.
    pub(super) fn frames(
        &mut self,
        args: &MoveArgs<'a>,
        (ctx, path): (Ctx, Path),
        seen: &Seen<'_>,
        reasons: &mut SkipReasons,
    ) -> Frames {
        let (mut tool, mut wobj) = (self.tool(args, ctx, seen), self.wobj(args, ctx, seen));
        if path == Path::AbsJoint {
            // Where it goes hangs on neither: the first pass tells its figures.
            let first = Seen { any: seen.first, ..*seen };
            tool = tool.or_else(|_| self.tool(args, ctx, &first));
            wobj = wobj.or_else(|_| self.wobj(args, ctx, &first));
        } else if let (Ok(tool), Ok(wobj)) = (&tool, &wobj) {
            reasons.add_frames(&tool.first, &wobj.first);
        }
        let known = tool.as_ref().ok().zip(wobj.as_ref().ok());
        let later = match known.map(|(tool, wobj)| later_frames(tool, wobj)) {
            Some(Ok(later)) => later,
            Some(Err(why)) => {
                reasons.extend((path != Path::AbsJoint).then_some(why));
                Vec::new()
            }
            None => Vec::new(),
        };
        let mut known = |why| reasons.extend((path != Path::AbsJoint).then_some(why));
        Frames {
            tool: tool.map(|tool| tool.first).map_err(&mut known).ok(),
            wobj: wobj.map(|wobj| wobj.first).map_err(&mut known).ok(),
            later,
        }
    }

    fn tool(
        &mut self,
        args: &MoveArgs<'a>,
        ctx: Ctx,
        seen: &Seen<'_>,
    ) -> Result<Passes<ToolData>, SkipReason> {
        let Some(expr) = args.tool else {
            return Err(skip("keep::tool-unknown", "it names no tool".into()));
        };
        let written = || as_text(self.evaluator.index.text(ctx.file, expr.range));
        let tool = self.by_passes(expr, ctx, seen, convert::tooldata);
        tool.map_err(|why| {
            self.made_of_reading("tool", expr, ctx)
                .unwrap_or_else(|| unknown_data("keep::tool-unknown", "tool", &written(), &why))
        })
    }

    fn wobj(
        &mut self,
        args: &MoveArgs<'a>,
        ctx: Ctx,
        seen: &Seen<'_>,
    ) -> Result<Passes<WobjData>, SkipReason> {
        if args.conditional("wobj").is_some() {
            let text = "its work object is handed to the routine, if present".into();
            return Err(skip("keep::wobj-unknown", text));
        }
        let Some(expr) = args.wobj else { return Ok(Passes { first: WobjData::wobj0(), later: Vec::new() }) };
        let written = || as_text(self.evaluator.index.text(ctx.file, expr.range));
        let wobj = self.by_passes(expr, ctx, seen, convert::wobjdata);
        wobj.map_err(|why| {
            self.made_of_reading("work object", expr, ctx)
                .unwrap_or_else(|| unknown_data("keep::wobj-unknown", "work object", &written(), &why))
        })
    }

    /// That what is not known of a tool or work object may come from where the robot stands: such a frame stands where the warm arm said, and
    /// a target in it is off by the drift that is in it already.
    fn made_of_reading(&self, what: &str, expr: &Expr, ctx: Ctx) -> Option<SkipReason> {
        let index = self.evaluator.index;
        let at = self.own_positions.read_at(index, ctx, expr)?;
        let (function, place) = (as_text(index.text(at.file, at.range)), index.place(at));
        let reason = format!(
            "its {what} is made of where the robot stands ({function}), so that it holds the drift already: {place}"
        );
        Some(SkipReason { code: "keep::own-position", reason, because: Some(at) })
    }

    /// A tool or work object in the first pass and, where it is still what the program was entered with, in later ones.
    fn by_passes<T: PartialEq>(
        &mut self,
        expr: &'a Expr,
        ctx: Ctx,
        seen: &Seen<'_>,
        convert: fn(&Value) -> Result<T, convert::ConversionError>,
    ) -> Result<Passes<T>, Why> {
        let mut in_state = |state: Option<&State>| {
            let known: &dyn TrackedValues = match state {
                Some(state) => &View { state, tracked: self.tracked },
                None => &Constant,
            };
            self.evaluator.fold(expr, ctx, known).and_then(|typed| whole(&typed.value, convert))
        };
        let first = in_state(seen.first)?;
        let Err(why) = in_state(seen.any) else { return Ok(Passes { first, later: Vec::new() }) };
        let datum = match self.evaluator.data_name(expr, ctx) {
            Some(DataName::Declared(datum)) => Some(datum),
            Some(DataName::Predefined(_)) | None => None,
        };
        let later = match datum.and_then(|datum| self.at_entry(datum, seen)) {
            Some(left) if left.unknown.is_none() => {
                let all = left.values.iter().map(|(value, at)| Ok((whole(value, convert)?, *at)));
                let all: Vec<(T, Span)> = all.collect::<Result<_, Why>>()?;
                all.into_iter().filter(|(value, _)| *value != first).collect()
            }
            _ => return Err(why),
        };
        Ok(Passes { first, later })
    }

    /// What the program leaves in a datum that is, on some way, still what the program was entered with.
    fn at_entry(&self, datum: DatumId, seen: &Seen<'_>) -> Option<&'f LeftBehind> {
        let slot = self.tracked.slot(datum)?;
        seen.any?.slots.get(slot)?.at_entry.then(|| self.left.get(slot))?
    }

    /// Whether a datum that is tracked is known in every part.
    fn is_known(&self, datum: DatumId, state: Option<&State>) -> bool {
        let slot = state.zip(self.tracked.slot(datum)).and_then(|(state, slot)| state.slots.get(slot));
        slot.is_some_and(|slot| slot.value.unknown().is_none())
    }

    /// Notes which tools and work objects other modules can set, and warns, of a motion that may be corrected, of one that is used
    /// before the program sets it, as it keeps its value from pass to pass.
    pub(super) fn note_frames(
        &mut self,
        (seen, may_be_corrected): (&Seen<'_>, bool),
        args: &MoveArgs<'a>,
        ctx: Ctx,
        at: Span,
    ) {
        for expr in [args.tool, args.wobj].into_iter().flatten() {
            let Some(DataName::Declared(datum)) = self.evaluator.data_name(expr, ctx) else { continue };
            let entry = &self.evaluator.index.data[datum];
            if !entry.local && entry.kind == DatumKind::Declared(DataKind::Pers) {
                self.settable.insert(datum);
            }
            let is_reported = !may_be_corrected || self.kept_over.contains_key(&datum);
            let Some(left) =
                self.at_entry(datum, seen).filter(|_| !is_reported && self.is_known(datum, seen.first))
            else {
                continue;
            };
            let name = self.evaluator.name_of(datum);
            let declared = self.evaluator.initial(datum).ok();
            let differs = |value: &Value| declared.as_ref().is_none_or(|declared| !declared.same(value));
            let other = left.values.iter().find(|(value, _)| differs(value)).map(|(_, at)| *at);
            let warning = match (left.unknown.or(other), left.by_hand) {
                (Some(set_at), _) => Diagnostic::warning(
                    "state::pers-kept",
                    format!("{name} is used here before the program sets it: from the second pass on it has the value set last"),
                )
                .at(at)
                .help(
                    "the figures hold for its declared value; the motion is corrected where every value that the program sets needs the \
                     same correction within the tolerance, else it is kept: set it before its first motion",
                )
                .label(set_at, "set here"),
                (None, Some(set_at)) => Diagnostic::warning(
                    "state::set-by-hand",
                    format!("{name}, which is used here, is set by a routine that nothing calls, to what only run time tells"),
                )
                .at(at)
                .help("the corrections hold for its declared value: after that routine has run, save the program and correct it anew")
                .label(set_at, "set here"),
                (None, None) => continue,
            };
            self.kept_over.insert(datum, warning);
        }
    }
}

/// What a motion sees: in the first pass of its program, and in whatever pass.
#[derive(Clone, Copy)]
pub(super) struct Seen<'s> {
    pub(super) first: Option<&'s State>,
    pub(super) any: Option<&'s State>,
}

/// Tool and work object of a motion.
pub(super) struct Frames {
    pub(super) tool: Option<ToolData>,
    pub(super) wobj: Option<WobjData>,
    pub(super) later: Vec<LaterFrames>,
}

/// A datum in the first pass, and each other value that it may have in later ones, with the place that sets it.
struct Passes<T> {
    first: T,
    later: Vec<(T, Span)>,
}

/// Each pair that a motion may have in later passes.
fn later_frames(tool: &Passes<ToolData>, wobj: &Passes<WobjData>) -> Result<Vec<LaterFrames>, SkipReason> {
    let tools =
        || std::iter::once((&tool.first, None)).chain(tool.later.iter().map(|(t, at)| (t, Some(*at))));
    let wobjs =
        || std::iter::once((&wobj.first, None)).chain(wobj.later.iter().map(|(w, at)| (w, Some(*at))));
    let mut later = Vec::new();
    for (tool, tool_at) in tools() {
        for (wobj, wobj_at) in wobjs() {
            let Some(set_at) = tool_at.or(wobj_at) else { continue };
            if later.len() == MOST_LATER {
                let reason = format!(
                    "tool and work object are used before they are set, as the program has left them: in more than {MOST_LATER} pairs"
                );
                return Err(SkipReason { code: "keep::tool-unknown", reason, because: Some(set_at) });
            }
            later.push(LaterFrames { tool: tool.clone(), wobj: wobj.clone(), set_at });
        }
    }
    Ok(later)
}

/// A value converted; the reason of a part that is not known keeps its place.
fn whole<T>(value: &Value, convert: fn(&Value) -> Result<T, convert::ConversionError>) -> Result<T, Why> {
    match value.unknown() {
        Some(why) => Err(why.clone()),
        None => convert(value).map_err(|(code, reason)| why(code, reason)),
    }
}
fn unknown_data(code: &'static str, what: &str, name: &str, why: &Why) -> SkipReason {
    // What is no tool is none at run time either.
    let code = if [other_tasks::CODE, "keep::wrong-type"].contains(&why.code) { why.code } else { code };
    let reason = format!("the {what} {name} is not known: {}", why.reason);
    SkipReason { code, reason, because: why.because }
}

//! Tool, work object, speed and zone of a motion, as far as they are known there.

use super::MotionReader;
use super::skip_reasons::{SkipReasons, keep};
use crate::program::const_eval::TrackedValues;
use crate::program::convert;
use crate::program::data::{LoadData, SpeedData, ToolData, WobjData, ZoneData};
use crate::program::index::Ctx;
use crate::program::motion::{Path, SkipReason};
use crate::program::motion_site::MoveArgs;
use crate::program::names::{as_text, lower_case};
use crate::program::other_tasks;
use crate::program::predefined::guessed;
use crate::program::state::State;
use crate::program::value::{DataName, Value, Why, why};
use rapid_syntax::diagnostic::{Diagnostic, Span};
use rapid_syntax::tree::{Expr, ExprKind};

impl<'a> MotionReader<'_, 'a> {
    /// Tool and work object in force. A MoveAbsJ needs neither: what is not known of them is no reason there.
    pub(super) fn frames(
        &mut self,
        args: &MoveArgs<'a>,
        (ctx, path): (Ctx, Path),
        known: &dyn TrackedValues,
        reasons: &mut SkipReasons,
    ) -> (Option<ToolData>, Option<WobjData>) {
        let (tool, wobj) = (self.tool(args, ctx, known), self.wobj(args, ctx, known));
        if path == Path::AbsJoint {
            return (tool.ok(), wobj.ok());
        }
        if let (Ok(tool), Ok(wobj)) = (&tool, &wobj) {
            reasons.add_frames(tool, wobj);
        }
        (tool.map_err(|why| reasons.add(why)).ok(), wobj.map_err(|why| reasons.add(why)).ok())
    }

    fn tool(
        &mut self,
        args: &MoveArgs<'a>,
        ctx: Ctx,
        known: &dyn TrackedValues,
    ) -> Result<ToolData, SkipReason> {
        let Some(expr) = args.tool else {
            return Err(keep("keep::tool-unknown", "it names no tool".into()));
        };
        let written = || as_text(self.evaluator.index.text(ctx.file, expr.range));
        let folded = self.evaluator.fold(expr, ctx, known);
        let tool = folded.and_then(|t| whole(&t.value, convert::tooldata));
        tool.map_err(|why| unknown_data("keep::tool-unknown", "tool", &written(), &why))
    }

    fn wobj(
        &mut self,
        args: &MoveArgs<'a>,
        ctx: Ctx,
        known: &dyn TrackedValues,
    ) -> Result<WobjData, SkipReason> {
        if args.conditional.iter().any(|name| name == "wobj") {
            let text = "its work object is handed to the routine, if present".into();
            return Err(keep("keep::wobj-unknown", text));
        }
        let Some(expr) = args.wobj else { return Ok(WobjData::wobj0()) };
        let written = || as_text(self.evaluator.index.text(ctx.file, expr.range));
        let folded = self.evaluator.fold(expr, ctx, known);
        let wobj = folded.and_then(|t| whole(&t.value, convert::wobjdata));
        wobj.map_err(|why| unknown_data("keep::wobj-unknown", "work object", &written(), &why))
    }

    /// What `\TLoad` says of the load of one motion: in place of the tool's own and of what is gripped; `load0` says nothing.
    pub(super) fn total_load(
        &mut self,
        args: &MoveArgs<'a>,
        ctx: Ctx,
        known: &dyn TrackedValues,
        (tool, grip): (Option<ToolData>, Option<LoadData>),
    ) -> (Option<ToolData>, Option<LoadData>) {
        const NO_LOAD_KG: f64 = 0.001;
        if !args.has("tload") {
            return (tool, grip);
        }
        let given = args.options.iter().find(|(name, _)| name == "tload").and_then(|(_, value)| *value);
        let load = given.and_then(|expr| self.evaluator.fold(expr, ctx, known).ok());
        match load.and_then(|load| convert::loaddata(&load.value).ok()) {
            Some(load) if load.mass_kg <= NO_LOAD_KG => (tool, grip),
            Some(load) => (tool.map(|tool| ToolData { load, ..tool }), Some(LoadData::default())),
            None => (tool, None),
        }
    }

    pub(super) fn speed(
        &mut self,
        args: &MoveArgs<'a>,
        ctx: Ctx,
        known: &dyn TrackedValues,
    ) -> Option<SpeedData> {
        if args.has("t") {
            return None; // the time is given, not the speed
        }
        let value = self.guess(args.speed?, ctx, known, "speeddata")?;
        let mut speed = convert::speeddata(&value).ok()?;
        if let Some((_, Some(expr))) = args.options.iter().find(|(name, _)| name == "v") {
            let Value::Num(v) = self.evaluator.fold(expr, ctx, known).ok()?.value else { return None };
            speed.v_tcp_m_s = robot_model::units::m_from_mm(v);
        }
        Some(speed)
    }

    pub(super) fn zone(
        &mut self,
        args: &MoveArgs<'a>,
        ctx: Ctx,
        known: &dyn TrackedValues,
    ) -> Option<ZoneData> {
        let value = self.guess(args.zone?, ctx, known, "zonedata")?;
        let mut zone = convert::zonedata(&value).ok()?;
        if let Some((_, Some(expr))) = args.options.iter().find(|(name, _)| name == "z") {
            let Value::Num(z) = self.evaluator.fold(expr, ctx, known).ok()?.value else { return None };
            zone.pzone_tcp_m = robot_model::units::m_from_mm(z);
        }
        Some(zone)
    }

    /// A speed or zone; one such as RoboDK's `v83`, which nobody declares, is guessed from its name.
    fn guess(&mut self, expr: &Expr, ctx: Ctx, known: &dyn TrackedValues, type_name: &str) -> Option<Value> {
        let why = match self.evaluator.fold(expr, ctx, known) {
            Ok(typed) => return Some(typed.value),
            Err(why) => why,
        };
        if why.code != "keep::not-declared" || !matches!(expr.kind, ExprKind::Name) {
            return None;
        }
        let name = lower_case(self.evaluator.index.text(ctx.file, expr.range));
        let (_, value) = guessed(&name).filter(|(guessed, _)| *guessed == type_name)?;
        let at = Span { file: ctx.file, range: expr.range };
        self.guesses.entry(name.clone()).or_insert_with(|| {
            let text = format!("{name} is neither predefined nor declared in the given files");
            Diagnostic::warning("resolve::not-predefined", text)
                .at(at)
                .help("its value is taken from its name; a controller does not load the module like this")
        });
        Some(value)
    }

    /// A PERS that is used before the program sets it keeps its value from run to run.
    pub(super) fn note_kept_over(&mut self, state: &State, args: &MoveArgs<'a>, ctx: Ctx, at: Span) {
        for expr in [args.tool, args.wobj].into_iter().flatten() {
            let Some(DataName::Declared(datum)) = self.evaluator.data_name(expr, ctx) else { continue };
            let Some(slot) = self.tracked.slot(datum).and_then(|slot| state.slots.get(slot)) else {
                continue;
            };
            if !slot.declared || slot.value.unknown().is_some() || self.kept_over.contains_key(&datum) {
                continue;
            }
            let name = self.evaluator.name_of(datum);
            let text = format!(
                "{name} is used here before the program sets it: from the second pass on it has the value set last"
            );
            let mut warning = Diagnostic::warning("state::pers-kept", text).at(at).help(
                "the figures hold for its declared value, in the first pass alone; set it before its first motion",
            );
            if let Some(write) = self.evaluator.writes.first(datum) {
                warning = warning.label(write.at, "set here");
            }
            self.kept_over.insert(datum, warning);
        }
    }
}

/// A value converted; the reason of a part that is not known keeps its place.
fn whole<T>(value: &Value, convert: fn(&Value) -> Result<T, convert::NotThat>) -> Result<T, Why> {
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

//! Load, speed and zone of a motion, as far as they are known there.

use super::MotionReader;
use crate::const_eval::TrackedValues;
use crate::convert;
use crate::data::{LoadData, SpeedData, ToolData, ZoneData};
use crate::index::Ctx;
use crate::motion::LaterFrames;
use crate::motion_site::MoveArgs;
use crate::names::lower_case;
use crate::predefined::guessed;
use crate::value::Value;
use rapid_syntax::diagnostic::{Diagnostic, Span};
use rapid_syntax::tree::{Expr, ExprKind};

impl<'a> MotionReader<'_, 'a> {
    /// What `\TLoad` says of the load of one motion: in place of the tool's own and of what is gripped; `load0` says nothing. At the end stands
    /// whether it says anything, as far as the text tells.
    pub(super) fn total_load(
        &mut self,
        args: &MoveArgs<'a>,
        ctx: Ctx,
        known: &dyn TrackedValues,
        (tool, later, grip): (Option<ToolData>, Vec<LaterFrames>, Option<LoadData>),
    ) -> (Option<ToolData>, Vec<LaterFrames>, Option<LoadData>, bool) {
        if !args.has("tload") {
            return (tool, later, grip, false);
        }
        let given = args.options.iter().find(|(name, _)| name == "tload").and_then(|(_, value)| *value);
        let load = given.and_then(|expr| self.evaluator.fold(expr, ctx, known).ok());
        match load.and_then(|load| convert::loaddata(&load.value).ok()) {
            Some(load) if load.weighs_nothing() => (tool, later, grip, false),
            Some(load) => {
                let under = |tool| ToolData { load, ..tool };
                let later = later.into_iter().map(|l| LaterFrames { tool: under(l.tool), ..l }).collect();
                (tool.map(under), later, Some(LoadData::default()), true)
            }
            None => (tool, later, None, true),
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

    /// The time that `\T` gives the motion, seconds.
    pub(super) fn time_s(&mut self, args: &MoveArgs<'a>, ctx: Ctx, known: &dyn TrackedValues) -> Option<f64> {
        let (_, expr) = args.options.iter().find(|(name, _)| name == "t")?;
        match self.evaluator.fold((*expr)?, ctx, known).ok()?.value {
            Value::Num(time_s) => Some(time_s),
            _ => None,
        }
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
}

//! [`Program::read`]: from files to motions with all that the text says of them.

use super::cfg::ControlFlow;
use super::const_eval::{ConstEvaluator, Constant, Found, TrackedValues};
use super::convert;
use super::data::{ToolData, WobjData};
use super::flow::BLOCKERS;
use super::index::{Ctx, Index};
use super::instructions::Special;
use super::module_facts::facts;
use super::motion::{Motion, MotionId, MotionSetup, Origin, Path, SkipReason, Target, TargetValue};
use super::motion_site::{MotionSite, MotionSites, MoveArgs};
use super::names::{as_text, lower_case};
use super::order::{Before, order};
use super::other_tasks;
use super::own_position::OwnPositions;
use super::predefined::guessed;
use super::read_as_data::ReadAsData;
use super::state::{State, View, states_at_motions};
use super::tracked::TrackedData;
use super::value::{DataName, Value, Why, why};
use super::writes::Writes;
use super::{Overrides, Program};
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::{Diagnostic, Span, TextRange};
use rapid_syntax::tree::{Arg, ArgKind, Expr, ExprKind, UnaryOp};
use std::collections::{BTreeMap, VecDeque};
use std::rc::Rc;
use std::sync::Arc;

impl Program {
    /// Reads files together: resolves names across them, follows tools and work objects, and says for
    /// each motion whether it can be compensated as far as the text tells.
    ///
    /// The files' ids must be their positions. Never fails: what cannot be understood stands in
    /// [`Motion::skip_reason`] and in the diagnostics.
    #[must_use]
    pub fn read(mut files: Vec<SourceFile>, overrides: &Overrides) -> Self {
        let mut diagnostics = Vec::new();
        let given = super::overrides::given(overrides, &mut diagnostics);
        let index = Index::new(&files);
        let writes = Writes::new(&index);
        let mut evaluator = ConstEvaluator::new(&index, &writes);
        evaluator.given = given;
        super::overrides::unused(&evaluator, overrides, &mut diagnostics);
        let home_rad = super::overrides::home(&mut evaluator, overrides, &mut diagnostics);
        let sites = MotionSites::new(&mut evaluator);
        let tracked = TrackedData::new(&index, &writes, &sites);
        let mut control_flow = ControlFlow::new(&mut evaluator, &sites, &tracked, overrides.base_fixed);
        let states = states_at_motions(&mut evaluator, sites.motions.len(), &control_flow, &tracked);
        let order = order(&index, &sites, &control_flow);
        let facts = facts(&index, &control_flow.called());
        let not_given = std::mem::take(&mut control_flow.not_given);
        drop(control_flow); // of many motions it is as much again
        let MotionSites { motions: sites, loops, nests, routines } = sites;
        let mut finish = MotionReader {
            evaluator,
            tracked: &tracked,
            own_positions: OwnPositions::new(&index),
            found_positions: OwnPositions::of_searches(&index),
            read_as_data: ReadAsData::new(&index),
            base_fixed: overrides.base_fixed,
            nests,
            recent_setups: VecDeque::new(),
            last_skip: None,
            kept_over: BTreeMap::new(),
            guesses: BTreeMap::new(),
            read_elsewhere: BTreeMap::new(),
        };
        let mut motions: Vec<Motion> = Vec::with_capacity(sites.len());
        let mut junctions = BTreeMap::new();
        for ((site, state), before) in sites.into_iter().zip(states).zip(order) {
            let (previous, from_start) = match before {
                Before::Motion(previous) => (Some(previous), false),
                Before::Start => (None, true),
                Before::OneOf { start, motions: before } => {
                    junctions.insert(MotionId::new(motions.len()), before);
                    (None, start)
                }
                Before::Unknown => (None, false),
            };
            motions.push(Motion { previous, from_start, ..finish.motion(&site, state.as_deref()) });
        }
        diagnostics.extend(finish.evaluator.elsewhere_warnings());
        diagnostics.extend(finish.kept_over.into_values());
        diagnostics.extend(finish.guesses.into_values());
        diagnostics.extend(finish.read_elsewhere.into_values());
        diagnostics.extend(other_tasks::not_given(&index));
        for (name, at) in &not_given {
            let text = format!("{name} is not among the given files");
            diagnostics.push(
                Diagnostic::warning("resolve::routine-not-given", text)
                    .at(*at)
                    .help("it is taken to leave tools, work objects and displacements as they are"),
            );
        }
        diagnostics.sort_by(|a, b| (a.span, a.code).cmp(&(b.span, b.code)));
        files.iter_mut().for_each(SourceFile::forget_bodies);
        Self { files, routines, loops, motions, junctions, facts, home_rad, diagnostics }
    }
}

struct MotionReader<'f, 'a> {
    evaluator: ConstEvaluator<'a>,
    tracked: &'f TrackedData,
    own_positions: OwnPositions,
    found_positions: OwnPositions,
    /// The combinations of loops that stand round motions.
    nests: Vec<Vec<usize>>,
    /// The last setups, the last one first: most motions share one of them.
    recent_setups: VecDeque<Arc<MotionSetup>>,
    /// The last reason for which a motion stays as it is.
    last_skip: Option<Arc<SkipReason>>,
    /// PERS that motions use before the program sets them, once each.
    kept_over: BTreeMap<usize, Diagnostic>,
    read_as_data: ReadAsData,
    /// External axes that move neither the robot's base nor a work object.
    base_fixed: [bool; 6],
    /// Targets that are read as data elsewhere, once each.
    read_elsewhere: BTreeMap<usize, Diagnostic>,
    /// Speeds and zones that are not predefined, once each.
    guesses: BTreeMap<String, Diagnostic>,
}

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

/// A program goes to and fro between so many setups, as a rule.
const RECENT_SETUPS: usize = 16;

impl<'a> MotionReader<'_, 'a> {
    fn motion(&mut self, site: &MotionSite<'a>, state: Option<&State>) -> Motion {
        let index = self.evaluator.index;
        let (args, ctx, form) = (site.args(index), site.ctx(index), site.form);
        let range = site.stmt.range;
        let at = Span { file: ctx.file, range };
        let mut first: Option<SkipReason> = None;
        let mut run_time = true;
        let mut fail = |keep: SkipReason| {
            run_time &= KNOWN_AT_RUN_TIME.contains(&keep.code);
            first.get_or_insert(keep);
        };
        if let Some(keep) = special(form.special, form.name) {
            fail(keep);
        }
        if let Some(not_read) = site.not_read {
            let reason = if not_read == range {
                "it was not understood"
            } else {
                "text that was not understood stands right beside it"
            };
            let because = Some(Span { file: ctx.file, range: not_read });
            fail(SkipReason { code: "keep::not-read", reason: reason.into(), because });
        } else if args.targets.len() < form.targets.len() {
            fail(keep("keep::not-read", format!("{} has too few arguments", form.name)));
        }
        match state {
            None => fail(keep("keep::unreachable", "no way through the program leads here".into())),
            Some(state) => {
                if args.has("id") {
                    fail(keep("keep::multimove", "it moves together with another robot (\\ID)".into()));
                }
                for (hold, held) in BLOCKERS.iter().zip(&state.blockers) {
                    if let Some(why) = held {
                        let code = match hold {
                            super::flow::Blocker::Displacement => "keep::displacement",
                            super::flow::Blocker::ExternalOffset => "keep::external-offset",
                            super::flow::Blocker::SoftServo => "keep::soft-servo",
                            super::flow::Blocker::MultiMove => "keep::multimove",
                        };
                        fail(SkipReason { code, reason: why.reason.clone(), because: why.because });
                    }
                }
            }
        }
        if args.has("corr") {
            fail(keep("keep::path-correction", "its path is corrected at run time (\\Corr)".into()));
        }
        let known: &dyn TrackedValues = match state {
            Some(state) => &View { state, tracked: self.tracked },
            None => &Constant,
        };
        let joints_wanted = form.path == Path::AbsJoint;
        let mut reached = Vec::new();
        let mut read_elsewhere = Vec::new();
        let from_search = args.targets.iter().any(|expr| self.found_positions.is_read(index, ctx, expr));
        let mut targets = Vec::with_capacity(args.targets.len());
        for expr in &args.targets {
            let (target, failed, calc) = self.target(expr, ctx, joints_wanted);
            let own_position = self.own_positions.is_read(index, ctx, expr);
            if let Some((datum, reading)) = self.read_as_data.of_target(index, ctx, expr) {
                match reading.why_kept(index) {
                    Some(why) => fail(why),
                    None => read_elsewhere.push((datum, reading.warning(index, datum))),
                }
            }
            if !joints_wanted && let Some(axis) = moving_axis(&target, self.base_fixed) {
                fail(keep(
                    "keep::external-base",
                    format!(
                        "it places external axis {axis}, which may carry the robot's base or the work object (--base-fixed {axis} \
                         says that it does not)"
                    ),
                ));
            }
            // One of an array's elements is known well enough where all of them are.
            let indexed = args.targets.len() == 1 && !target.elements().is_empty();
            targets.push(target);
            reached.extend(calc);
            match failed {
                _ if own_position => {
                    let reason =
                        "its target is read from where the robot stands, so that it holds the drift already";
                    let because = failed.and_then(|keep| keep.because);
                    fail(SkipReason { code: "keep::own-position", reason: reason.into(), because });
                }
                Some(keep) if indexed && KNOWN_AT_RUN_TIME.contains(&keep.code) => {}
                Some(keep) => fail(keep),
                None => {}
            }
        }
        let conf_monitored = state.and_then(|state| match form.path {
            Path::Linear | Path::Circular => state.conf_l,
            Path::Joint => state.conf_j,
            Path::AbsJoint => Some(false),
        });
        let speed = self.speed(&args, ctx, known);
        let zone = self.zone(&args, ctx, known);
        let is_joint = joints_wanted;
        let tool = self
            .tool(&args, ctx, known)
            .map_err(|keep| {
                if !is_joint {
                    fail(keep);
                }
            })
            .ok();
        let wobj = self
            .wobj(&args, ctx, known)
            .map_err(|keep| {
                if !is_joint {
                    fail(keep);
                }
            })
            .ok();
        if !is_joint && let (Some(tool), Some(wobj)) = (&tool, &wobj) {
            if tool.robhold == wobj.robhold {
                let text = if tool.robhold {
                    "the robot is said to hold both the tool and the work object"
                } else {
                    "the robot is said to hold neither the tool nor the work object"
                };
                fail(keep("keep::robhold", text.into()));
            }
            if !wobj.ufprog || !wobj.ufmec.is_empty() {
                let unit = if wobj.ufmec.is_empty() { "another unit" } else { &wobj.ufmec };
                fail(keep("keep::wobj-moved", format!("{unit} moves the work object")));
            }
        }
        if !reached.is_empty() {
            let own_tool = args.tool.and_then(|t| self.evaluator.data_name(t, ctx));
            let own_wobj = match args.wobj {
                Some(wobj) => self.evaluator.data_name(wobj, ctx),
                None => Some(DataName::Predefined("wobj0".into())),
            };
            let same = |(tool, wobj)| Some(tool) == own_tool.as_ref() && Some(wobj) == own_wobj.as_ref();
            if !reached.iter().all(|r| same((&r.tool, &r.wobj))) {
                let text = "CalcRobT names another tool or work object than its motion";
                fail(keep("keep::calc-frame", text.into()));
            }
        }
        if let Some(state) = state {
            self.note_kept_over(state, &args, ctx, at);
        }
        if first.is_none() {
            for (datum, warning) in read_elsewhere {
                self.read_elsewhere.entry(datum).or_insert(warning);
            }
        }
        let text = |expr: Option<&Expr>| expr.map(|expr| index.text(ctx.file, expr.range));
        let frame_arguments = [text(args.tool), text(args.wobj)];
        let [tool_name, wobj_name] = frame_arguments.map(|text| text.map(as_text));
        let setup = MotionSetup {
            routine: site.info,
            loops: self.nests.get(site.nest as usize).cloned().unwrap_or_default(),
            kind: form.name,
            path: form.path,
            tool_name,
            tool,
            wobj_name,
            wobj,
            frame_arguments: frame_arguments.map(|text| text.map(Into::into)),
            speed,
            zone,
            conf_monitored,
            grip: state.and_then(|state| state.grip),
        };
        Motion {
            file: ctx.file,
            line: index.file(ctx.file).line(range),
            range,
            setup: self.shared_setup(setup),
            targets: targets.into_iter().collect(),
            previous: None,
            from_start: false,
            run_time: first.is_some() && run_time && args.tool.is_some() && args.conditional.is_empty(),
            skip_reason: first.map(|keep| self.shared_skip(keep)),
            from_search,
        }
    }

    /// A setup that is one of the last ones stands once.
    fn shared_setup(&mut self, setup: MotionSetup) -> Arc<MotionSetup> {
        let known = self.recent_setups.iter().position(|known| **known == setup);
        let shared = match known.and_then(|at| self.recent_setups.remove(at)) {
            Some(known) => known,
            None => Arc::new(setup),
        };
        self.recent_setups.truncate(RECENT_SETUPS - 1);
        self.recent_setups.push_front(Arc::clone(&shared));
        shared
    }

    fn shared_skip(&mut self, keep: SkipReason) -> Arc<SkipReason> {
        let known = self.last_skip.take().filter(|known| **known == keep);
        Arc::clone(self.last_skip.insert(known.unwrap_or_else(|| Arc::new(keep))))
    }

    fn target(
        &mut self,
        expr: &'a Expr,
        ctx: Ctx,
        joints_wanted: bool,
    ) -> (Target, Option<SkipReason>, Option<Rc<super::value::Reached>>) {
        let (origin, literal) = self.origin(expr, ctx);
        let mut calc = None;
        let folded = self.evaluator.fold(expr, ctx, &Constant).and_then(|typed| {
            let value = typed.value;
            let converted = match (&value, joints_wanted) {
                (Value::Reached(reached), false) => {
                    calc = Some(reached.clone());
                    convert::jointtarget(&reached.joints).map(TargetValue::FromJoints)
                }
                (_, true) => convert::jointtarget(&value).map(TargetValue::Joint),
                (_, false) => convert::robtarget(&value).map(TargetValue::Rob),
            };
            converted.map_err(|(code, reason)| {
                let because = match &origin {
                    Origin::Named { declaration, .. } => Some(*declaration),
                    Origin::Inline | Origin::Expression => None,
                };
                Rc::new(SkipReason { code, reason, because })
            })
        });
        let unused_axis = |v: &TargetValue| match v {
            TargetValue::Joint(j) | TargetValue::FromJoints(j) => j.q_rad.contains(&None),
            TargetValue::Rob(_) => false,
        };
        let target = Target::new(expr.range, origin);
        let value = match folded {
            Ok(value) => value,
            Err(why) => {
                let elements = self.elements(expr, ctx, joints_wanted);
                return (target.with_elements(elements), Some((*why).clone()), calc);
            }
        };
        let failed = unused_axis(&value).then(|| {
            keep("keep::axis-unused", "an axis of the arm is written 9E9: it stays where it is".into())
        });
        let target = target.with_value(&value);
        match literal {
            Some(literal) => (target.with_literal(literal), failed, calc),
            None => (target, failed, calc),
        }
    }

    /// All elements of the constant array that `NAME{index}` names; of a target that is handed to a function that scales its
    /// correction (`tcAt`, as this program emits it) the original and what it is when all has settled; none where it is
    /// something else.
    fn elements(&mut self, expr: &'a Expr, ctx: Ctx, joints_wanted: bool) -> Vec<TargetValue> {
        if let ExprKind::Call(call) = &expr.kind {
            return self.scaled(call.name, &call.args, ctx, joints_wanted).unwrap_or_default();
        }
        let ExprKind::Index(element_of) = &expr.kind else { return Vec::new() };
        let base = &element_of.base;
        let ([_], ExprKind::Name) = (&*element_of.indices, &base.kind) else { return Vec::new() };
        let Ok(Value::Parts(parts)) = self.evaluator.fold(base, ctx, &Constant).map(|typed| typed.value)
        else {
            return Vec::new();
        };
        let element = |part: &Value| match joints_wanted {
            true => convert::jointtarget(part).map(TargetValue::Joint).ok(),
            false => convert::robtarget(part).map(TargetValue::Rob).ok(),
        };
        parts.iter().map(element).collect::<Option<_>>().unwrap_or_default()
    }

    /// The original of a target with a correction, and the settled target: the sum of all corrections where there are several
    /// is none that the arm needs, so that only the original is told.
    fn scaled(
        &mut self,
        name: TextRange,
        args: &'a [Arg],
        ctx: Ctx,
        joints_wanted: bool,
    ) -> Option<Vec<TargetValue>> {
        let name = lower_case(self.evaluator.index.text(ctx.file, name));
        if !name.starts_with("tcat") {
            return None;
        }
        let mut positional = args.iter().filter_map(|arg| match &arg.kind {
            ArgKind::Positional(expr) => Some(expr),
            _ => None,
        });
        let original = self.evaluator.fold(positional.next()?, ctx, &Constant).ok()?.value;
        let original = match (&original, joints_wanted) {
            (Value::Reached(reached), false) => {
                convert::jointtarget(&reached.joints).map(TargetValue::FromJoints)
            }
            (_, true) => convert::jointtarget(&original).map(TargetValue::Joint),
            (_, false) => convert::robtarget(&original).map(TargetValue::Rob),
        };
        let original = original.ok()?;
        let (correction, more) = (positional.next()?, positional.next());
        let correction = self.evaluator.fold(correction, ctx, &Constant).ok()?.value;
        let settled = convert::corrected(&original, &correction).filter(|_| more.is_none());
        Some(std::iter::once(original).chain(settled).collect())
    }

    fn origin(&mut self, expr: &'a Expr, ctx: Ctx) -> (Origin, Option<Span>) {
        let literal =
            |expr: &Expr, ctx: Ctx| is_literal(expr).then_some(Span { file: ctx.file, range: expr.range });
        match &expr.kind {
            ExprKind::Aggregate(_) | ExprKind::Numbers => (Origin::Inline, literal(expr, ctx)),
            ExprKind::Name => {
                let name = as_text(self.evaluator.index.text(ctx.file, expr.range));
                let here = Span { file: ctx.file, range: expr.range };
                match self.evaluator.resolve(expr.range, ctx) {
                    Ok(Found::Datum(datum)) => {
                        let entry = &self.evaluator.index.data[datum];
                        let literal = entry.init.and_then(|init| literal(init, entry.ctx));
                        let declaration = self.evaluator.index.declaration(datum);
                        (Origin::Named { name, declaration }, literal)
                    }
                    Ok(Found::Predefined(_)) | Err(_) => (Origin::Named { name, declaration: here }, None),
                }
            }
            _ => (Origin::Expression, None),
        }
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
        let written = as_text(self.evaluator.index.text(ctx.file, expr.range));
        let folded = self.evaluator.fold(expr, ctx, known);
        let tool = folded.and_then(|t| whole(&t.value, convert::tooldata));
        tool.map_err(|why| unknown_data("keep::tool-unknown", "tool", &written, &why))
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
        let written = as_text(self.evaluator.index.text(ctx.file, expr.range));
        let folded = self.evaluator.fold(expr, ctx, known);
        let wobj = folded.and_then(|t| whole(&t.value, convert::wobjdata));
        wobj.map_err(|why| unknown_data("keep::wobj-unknown", "work object", &written, &why))
    }

    fn speed(
        &mut self,
        args: &MoveArgs<'a>,
        ctx: Ctx,
        known: &dyn TrackedValues,
    ) -> Option<super::data::SpeedData> {
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

    fn zone(
        &mut self,
        args: &MoveArgs<'a>,
        ctx: Ctx,
        known: &dyn TrackedValues,
    ) -> Option<super::data::ZoneData> {
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
    fn note_kept_over(&mut self, state: &State, args: &MoveArgs<'a>, ctx: Ctx, at: Span) {
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

/// The letter of an external axis that a target places away from 0 and that may move the base.
fn moving_axis(target: &Target, base_fixed: [bool; 6]) -> Option<char> {
    target.values().find_map(|value| {
        let ext = match value {
            TargetValue::Rob(target) => target.ext,
            TargetValue::Joint(joints) | TargetValue::FromJoints(joints) => joints.ext,
        };
        let moves = |(place, fixed): (Option<f64>, bool)| place.is_some_and(|place| place != 0.0) && !fixed;
        let axis = ext.into_iter().zip(base_fixed).position(moves)?;
        Some(char::from(b"abcdef"[axis]))
    })
}

fn special(special: Special, name: &str) -> Option<SkipReason> {
    match special {
        Special::Plain => None,
        Special::Search => Some(keep(
            "keep::search",
            format!("{name} searches: where it stops is what the program wants to know"),
        )),
        Special::External => Some(keep("keep::external-axes", format!("{name} moves external axes only"))),
        Special::Unsupported => Some(keep(
            "keep::instruction",
            format!("{name} is not among the instructions that are understood"),
        )),
    }
}

fn keep(code: &'static str, reason: String) -> SkipReason {
    SkipReason { code, reason, because: None }
}

/// A value converted; the reason of a part that is not known keeps its place.
fn whole<T>(value: &Value, convert: fn(&Value) -> Result<T, convert::NotThat>) -> Result<T, Why> {
    match value.unknown() {
        Some(why) => Err(why.clone()),
        None => convert(value).map_err(|(code, reason)| why(code, reason)),
    }
}

fn unknown_data(code: &'static str, what: &str, name: &str, why: &Why) -> SkipReason {
    let code = if why.code == other_tasks::CODE { why.code } else { code };
    let reason = format!("the {what} {name} is not known: {}", why.reason);
    SkipReason { code, reason, because: why.because }
}

/// Whether an expression is made of literals alone.
fn is_literal(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Number | ExprKind::Numbers | ExprKind::String | ExprKind::Bool(_) => true,
        ExprKind::Aggregate(parts) => parts.iter().all(is_literal),
        ExprKind::Unary { op: UnaryOp::Neg | UnaryOp::Plus, operand } => {
            matches!(operand.kind, ExprKind::Number)
        }
        _ => false,
    }
}

//! [`Program::read`]: from files to motions with all that the text says of them.

mod frames;
mod like_the_last;
mod motion_data;
mod motion_target;
mod runtime_target;
mod skip_reasons;

use super::cfg::ControlFlow;
use super::const_eval::{ConstEvaluator, Constant, TrackedValues};
use super::finite_set::{FiniteSet, FiniteSets};
use super::ids::{DatumId, IdSet, Slot, Table};
use super::index::Index;
use super::module_facts::facts;
use super::motion::{Motion, MotionId, MotionSetup, Path, PersTarget, SkipReason, Target, WobjArgument};
use super::motion_site::{MotionSite, MotionSites};
use super::names::{ByNumber, as_text};
use super::order::{Before, order};
use super::other_tasks;
use super::own_position::OwnPositions;
use super::read_as_data::ReadAsData;
use super::speed_override::speed_override;
use super::state::{LeftBehind, StatesAtMotions, TargetsOnWays, View, states_at_motions, targets_on_ways};
use super::tracked::TrackedData;
use super::writes::Writes;
use super::{Overrides, Program, is_of_task};
use frames::{Frames, Seen};
use like_the_last::Last;
use motion_target::MotionTargets;
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::{Diagnostic, Span};
use rapid_syntax::tree::Expr;
use runtime_target::is_asked_once;
use skip_reasons::SkipReasons;
use std::collections::{BTreeMap, BTreeSet, VecDeque};
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
        let task = overrides.task.as_deref();
        let sites = MotionSites::new(&mut evaluator, task);
        let tracked = TrackedData::new(&index, &writes, &sites);
        let mut control_flow = ControlFlow::new(&mut evaluator, &sites, &tracked, overrides.base_fixed);
        let StatesAtMotions { first, any, left } =
            states_at_motions(&mut evaluator, sites.motions.len(), &control_flow, &tracked);
        let found = OwnPositions::of_searches(&index);
        let of_targets = TrackedData::of_targets(&index, &writes, &sites, &|datum| found.holds(datum));
        let on_ways = if of_targets.data.is_empty() && found.is_empty() {
            TargetsOnWays::default()
        } else {
            let ways = ControlFlow::new(&mut evaluator, &sites, &of_targets, overrides.base_fixed);
            targets_on_ways(&mut evaluator, &sites, &ways, &of_targets, &found)
        };
        let speed_override = speed_override(&mut evaluator);
        let order = order(&index, &sites, &control_flow);
        let mut facts = facts(&index, &control_flow.called());
        facts.retain(|file| is_of_task(&index.file(file).path, task));
        let not_given = std::mem::take(&mut control_flow.not_given);
        drop(control_flow); // of many motions it is as much again
        let MotionSites { motions: sites, loops, nests, routines } = sites;
        let mut finish = MotionReader {
            evaluator,
            tracked: &tracked,
            left: &left,
            own_positions: OwnPositions::new(&index),
            read_as_data: ReadAsData::new(&index),
            finite_sets: FiniteSets::new(&index),
            on_ways: on_ways.values,
            from_search: on_ways.found,
            base_fixed: overrides.base_fixed,
            nests,
            last: None,
            recent_setups: VecDeque::new(),
            last_skip: None,
            kept_over: BTreeMap::new(),
            settable: IdSet::default(),
            guesses: BTreeMap::new(),
            read_elsewhere: BTreeMap::new(),
            made_of_pers: Vec::new(),
        };
        let mut motions: Vec<Motion> = Vec::with_capacity(sites.len());
        let (mut junctions, mut also_anywhere) = (BTreeMap::new(), BTreeSet::new());
        for ((site, (first, any)), before) in sites.into_iter().zip(first.into_iter().zip(any)).zip(order) {
            let (previous, from_start) = match before {
                Before::Motion(previous) => (Some(previous), false),
                Before::Start => (None, true),
                Before::OneOf { start, anywhere, motions: before } => {
                    if anywhere {
                        also_anywhere.insert(MotionId::new(motions.len()));
                    }
                    junctions.insert(MotionId::new(motions.len()), before);
                    (None, start)
                }
                Before::Unknown => (None, false),
            };
            let seen = Seen { first: first.as_deref(), any: any.as_deref() };
            let motion = finish.motion(&site, MotionId::new(motions.len()), &seen);
            motions.push(Motion { previous, from_start, ..motion });
        }
        let made_of_pers = std::mem::take(&mut finish.made_of_pers);
        let settable: Vec<String> =
            finish.settable.iter().map(|datum| finish.evaluator.name_of(datum)).collect();
        diagnostics.extend(finish.evaluator.elsewhere_warnings());
        diagnostics.extend(finish.kept_over.into_values());
        diagnostics.extend(finish.guesses.into_values());
        diagnostics.extend(finish.read_elsewhere.into_values());
        diagnostics.extend(other_tasks::not_given(&index, &overrides.other_tasks));
        diagnostics.extend(super::loads::warnings(&index));
        diagnostics.extend(not_given.iter().map(|(name, at)| not_among_the_files(name, *at, &settable)));
        diagnostics.retain(|found| found.span.is_none_or(|at| is_of_task(&index.file(at.file).path, task)));
        diagnostics.sort_by(|a, b| (a.span, a.code).cmp(&(b.span, b.code)));
        files.iter_mut().for_each(SourceFile::keep_declarations);
        Self {
            files,
            routines,
            loops,
            motions,
            junctions,
            also_anywhere,
            made_of_pers,
            facts,
            speed_override,
            home_rad,
            diagnostics,
        }
    }
}

/// So many names are listed; behind them stands how many more there are.
const MOST_LISTED: usize = 4;

/// The warning of a routine that is called and not given; `settable`: the tools and work objects of motions that it can set.
fn not_among_the_files(name: &str, at: Span, settable: &[String]) -> Diagnostic {
    let text = format!("{name} is not among the given files");
    let listed = match settable {
        [] => None,
        [one] => Some(one.clone()),
        [others @ .., last] if others.len() < MOST_LISTED => {
            Some(format!("{} and {last}", others.join(", ")))
        }
        all => Some(format!("{} and {} more", all[..MOST_LISTED].join(", "), all.len() - MOST_LISTED)),
    };
    let help = match listed {
        None => "it is taken to leave tools, work objects and displacements as they are".to_owned(),
        Some(listed) => format!(
            "it could set {listed}, used by motions here: it is taken to leave tools, work objects and displacements as they are"
        ),
    };
    Diagnostic::warning("resolve::routine-not-given", text).at(at).help(help)
}

struct MotionReader<'f, 'a> {
    evaluator: ConstEvaluator<'a>,
    tracked: &'f TrackedData,
    /// What the program leaves in them.
    left: &'f Table<Slot, LeftBehind>,
    own_positions: OwnPositions,
    /// The combinations of loops that stand round motions.
    nests: Vec<Vec<usize>>,
    /// The last motion, where the next one may be like it.
    last: Option<Last<'a>>,
    /// The last setups, the last one first: most motions share one of them.
    recent_setups: VecDeque<Arc<MotionSetup>>,
    /// The last reason for which a motion stays as it is.
    last_skip: Option<Arc<SkipReason>>,
    /// Tools and work objects that motions use before the program sets them, once each.
    kept_over: BTreeMap<DatumId, Diagnostic>,
    /// Tools and work objects of motions that other modules, given or not, can set.
    settable: IdSet<DatumId>,
    read_as_data: ReadAsData,
    /// The values that data can have, where they are a few.
    finite_sets: FiniteSets<'a>,
    /// The values that targets can have by the ways that lead to them.
    on_ways: ByNumber<MotionId, FiniteSet>,
    /// The motions with a target that can be what a search has found.
    from_search: BTreeSet<MotionId>,
    /// External axes that move neither the robot's base nor a work object.
    base_fixed: [bool; 6],
    /// Targets that are read as data elsewhere, once each.
    read_elsewhere: BTreeMap<DatumId, Diagnostic>,
    /// The first PERS of each motion's targets.
    made_of_pers: Vec<PersTarget>,
    /// Speeds and zones that are not predefined, once each.
    guesses: BTreeMap<String, Diagnostic>,
}

/// A program goes to and fro between so many setups, as a rule.
const RECENT_SETUPS: usize = 16;

impl<'a> MotionReader<'_, 'a> {
    fn motion(&mut self, site: &MotionSite<'a>, at: MotionId, seen: &Seen<'_>) -> Motion {
        if let Some(motion) = self.like_the_last(site, at, seen) {
            return motion;
        }
        let state = seen.first;
        let index = self.evaluator.index;
        let (args, ctx, form) = (site.args(index), site.ctx(index), site.form);
        let range = site.stmt.range;
        let mut reasons = SkipReasons::of_statement(site, ctx, &args);
        // Motion settings may be other ones in a later pass than in the first.
        reasons.add_state(seen.any, &args);
        let MotionTargets { targets, reached, read_elsewhere } =
            self.targets(&args, (ctx, form.path, at), &mut reasons);
        let known: &dyn TrackedValues = match state {
            Some(state) => &View { state, tracked: self.tracked },
            None => &Constant,
        };
        let (speed, zone) = (self.speed(&args, ctx, known), self.zone(&args, ctx, known));
        let time_s = self.time_s(&args, ctx, known);
        let Frames { tool, wobj, later } = self.frames(&args, (ctx, form.path), seen, &mut reasons);
        let (tool, later_frames, grip) =
            self.total_load(&args, ctx, known, (tool, later, seen.any.and_then(|state| state.grip)));
        if !self.same_frames(&args, ctx, &reached) {
            reasons.add_other_frames();
        }
        let text = |expr: Option<&Expr>| expr.map(|expr| index.text(ctx.file, expr.range));
        let handed_on = args.conditional("wobj").map(|parameter| index.text(ctx.file, parameter));
        let given = text(args.wobj).map(|wobj| WobjArgument::Given(wobj.into()));
        let wobj_argument = given.or_else(|| handed_on.map(|wobj| WobjArgument::IfPresent(wobj.into())));
        let setup = MotionSetup {
            routine: site.info,
            loops: self.nests.get(site.nest as usize).cloned().unwrap_or_default(),
            kind: form.name,
            path: form.path,
            tool_name: text(args.tool).map(as_text),
            tool,
            wobj_name: text(args.wobj).map(as_text),
            wobj,
            later_frames,
            tool_argument: text(args.tool).map(Into::into),
            wobj_argument,
            speed,
            time_s,
            zone,
            conf_monitored: seen.any.and_then(|state| match form.path {
                Path::Linear | Path::Circular => state.conf_l,
                Path::Joint => state.conf_j,
                Path::AbsJoint => Some(false),
            }),
            grip,
        };
        let (skip_reason, known_at_run_time) = reasons.told();
        self.note_frames((seen, skip_reason.is_none()), &args, ctx, Span { file: ctx.file, range });
        let one_of = skip_reason.is_none() && targets.iter().any(Target::is_one_of);
        if skip_reason.is_none() {
            for (datum, warning) in read_elsewhere {
                self.read_elsewhere.entry(datum).or_insert(warning);
            }
            self.made_of_pers.extend(self.first_pers(at, &args, ctx));
        }
        let has_later = !setup.later_frames.is_empty();
        let motion = Motion {
            file: ctx.file,
            line: index.file(ctx.file).line(range),
            range,
            setup: self.shared_setup(setup),
            targets: targets.into_iter().collect(),
            previous: None,
            from_start: false,
            run_time: (known_at_run_time || one_of || has_later)
                && args.tool.is_some()
                // Tool and work object are named twice then: in the question and in the motion.
                && ![args.tool, args.wobj].into_iter().flatten().any(|expr| is_asked_once(index, ctx, expr)),
            skip_reason: skip_reason.map(|keep| self.shared_skip(keep)),
            from_search: self.from_search.contains(&at),
        };
        self.keep_as_last(site, &args, seen, &motion);
        motion
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
}

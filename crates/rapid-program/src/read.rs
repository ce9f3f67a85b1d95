//! [`Program::read`]: from files to motions with all that the text says of them.

mod frames;
mod like_the_last;
mod motion_data;
mod motion_target;
mod runtime_target;
mod skip_reasons;

use super::cfg::ControlFlow;
use super::const_eval::{ConstEvaluator, Constant, TrackedValues};
use super::file_values::FileValues;
use super::finite_set::{FiniteSet, FiniteSets};
use super::flow::Blocker;
use super::ids::{DatumId, IdSet, Slot, Table};
use super::index::{Ctx, Index};
use super::interrupting::called_by_moves;
use super::module_facts::facts;
use super::motion::{Motion, MotionId, MotionSetup, Path, PersTarget, SkipReason, Target, WobjArgument};
use super::motion_site::{MotionSite, MotionSites, MoveArgs};
use super::names::{ByNumber, as_text};
use super::open_variables::open_variables;
use super::order::{MotionOrder, Predecessors, order};
use super::other_tasks;
use super::own_position::OwnPositions;
use super::read_as_data::ReadAsData;
use super::speed_override::speed_override;
use super::state::{
    LeftBehind, State, StatesAtMotions, TargetsOnWays, View, states_at_motions, targets_on_ways,
};
use super::tracked::TrackedData;
use super::writes::Writes;
use super::{Overrides, Program, is_of_task};
use frames::{Frames, Seen};
use like_the_last::Last;
use motion_target::{MotionTargets, leaves_axes};
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::{Diagnostic, Span};
use rapid_syntax::tree::Expr;
use runtime_target::is_asked_once;
use skip_reasons::SkipReasons;
use std::collections::{BTreeMap, BTreeSet, VecDeque};
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
        let (index, writes) = indexed(&files, overrides);
        let mut evaluator = ConstEvaluator::new(&index, &writes);
        evaluator.given = given;
        super::overrides::unused(&evaluator, overrides, &mut diagnostics);
        let home_rad = super::overrides::home(&mut evaluator, overrides, &mut diagnostics);
        let task = overrides.task.as_deref();
        let sites = MotionSites::new(&mut evaluator, task);
        let tracked = TrackedData::new(&index, &writes, &sites);
        let mut control_flow = ControlFlow::new(&mut evaluator, &sites, &tracked, overrides.base_fixed);
        let file_values = FileValues::new(&index, &writes);
        let StatesAtMotions { first, any, left } =
            states_at_motions(&mut evaluator, sites.motions.len(), &control_flow, (&tracked, &file_values));
        let own_positions = OwnPositions::new(&index);
        let by_ways = ByWays { sites: &sites, file_values: &file_values, own_positions: &own_positions };
        let on_ways = by_ways.targets(&mut evaluator, (&index, &writes), overrides.base_fixed);
        diagnostics.extend(super::shared_values::warnings(&mut evaluator, &sites, &writes));
        diagnostics.extend(super::seam_tracking::warning(&index, &sites));
        let speed_override = speed_override(&mut evaluator);
        let MotionOrder { before, after_traps } = order(&index, &sites, &control_flow);
        let mut facts = facts(&index, &control_flow.called());
        facts.retain(|file| is_of_task(&index.file(file).path, task));
        let not_given = std::mem::take(&mut control_flow.not_given);
        drop(control_flow); // of many motions it is as much again
        let MotionSites { motions: sites, loops, nests, routines } = sites;
        let known = (&tracked, &left, &file_values);
        let targets = (own_positions, on_ways);
        let mut reader = MotionReader::new(evaluator, known, targets, nests, overrides.base_fixed);
        let seen = first.into_iter().zip(any);
        let MotionsInOrder { motions, merge_points, also_anywhere } =
            reader.motions(sites.into_iter().zip(seen).zip(before));
        let made_of_pers = std::mem::take(&mut reader.made_of_pers);
        let settable = reader.settable_names();
        diagnostics.extend(super::position_tests::warning(&index, &reader.own_positions));
        diagnostics.extend(reader.into_warnings());
        diagnostics.extend(about_what_is_given(&index, overrides));
        diagnostics
            .extend(not_given.iter().map(|(name, at)| not_among_the_files(&index, name, *at, &settable)));
        diagnostics.retain(|found| found.span.is_none_or(|at| is_of_task(&index.file(at.file).path, task)));
        sorting::by(&mut diagnostics, |a, b| (a.span, a.code).cmp(&(b.span, b.code)));
        files.iter_mut().for_each(SourceFile::keep_declarations);
        Self {
            files,
            routines,
            loops,
            motions,
            merge_points,
            also_anywhere,
            after_traps,
            made_of_pers,
            facts,
            speed_override,
            home_rad,
            diagnostics,
        }
    }
}

/// What the files declare, and what they change of it.
fn indexed<'a>(files: &'a [SourceFile], overrides: &'a Overrides) -> (Index<'a>, Writes) {
    let mut index = Index::new(files);
    index.added_routines = &overrides.added_routines;
    index.called_by_moves = called_by_moves(&index);
    let writes = Writes::new(&index);
    index.open_variables = open_variables(&index, &writes);
    (index, writes)
}

/// Targets that a program assigns, by the ways on which their motions are come to.
struct ByWays<'w, 'a> {
    sites: &'w MotionSites<'a>,
    file_values: &'w FileValues,
    own_positions: &'w OwnPositions,
}

impl<'a> ByWays<'_, 'a> {
    /// What is known of the targets of all motions.
    fn targets(
        &self,
        evaluator: &mut ConstEvaluator<'a>,
        (index, writes): (&'a Index<'a>, &'a Writes),
        base_fixed: [bool; 6],
    ) -> TargetsOnWays {
        let (found, read) = (OwnPositions::of_searches(index), self.own_positions);
        let is_position = |datum| found.holds(datum) || read.holds(datum);
        let of_targets = TrackedData::of_targets(index, writes, self.sites, &is_position);
        if of_targets.data.is_empty() && found.is_empty() {
            return TargetsOnWays::default();
        }
        let ways = ControlFlow::new(evaluator, self.sites, &of_targets, base_fixed);
        let known = (&of_targets, self.file_values);
        targets_on_ways(evaluator, self.sites, &ways, known, (&found, read))
    }
}

/// Warnings about what is given and what is not, whatever motions make of it.
fn about_what_is_given(index: &Index<'_>, overrides: &Overrides) -> Vec<Diagnostic> {
    let mut warnings = other_tasks::not_given(index, &overrides.other_tasks);
    warnings.extend(super::loads::warnings(index));
    warnings.extend(super::set_all_data::warnings(index));
    warnings
}

/// So many names are listed; behind them stands how many more there are.
const MOST_LISTED: usize = 4;

/// The warning of a routine that is called and not given; `settable`: what motions go by and it can set.
fn not_among_the_files(index: &Index<'_>, name: &str, at: Span, settable: &[String]) -> Diagnostic {
    let written = as_text(index.text(at.file, at.range));
    let name = if written.eq_ignore_ascii_case(name) { &written } else { name };
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

/// Whether the controller watches the configuration on a path in this state; `None` where that is not known.
fn conf_monitored(state: &State, path: Path) -> Option<bool> {
    match path {
        Path::Linear | Path::Circular => state.conf_l,
        Path::Joint => state.conf_j,
        Path::AbsJoint => Some(false),
    }
}

/// Why an arc on which the tool turns stays as it is in this state.
fn uneven_turn(state: &State, path: Path) -> Option<Arc<SkipReason>> {
    let why = state.held(Blocker::CirclePointOrientation).filter(|_| path == Path::Circular)?;
    Some(Arc::new(SkipReason { code: "keep::circle-orientation", ..(**why).clone() }))
}

/// What is in force at a motion; `None` where no way leads to it.
type StateSeen = Option<Rc<State>>;

struct MotionReader<'f, 'a> {
    evaluator: ConstEvaluator<'a>,
    tracked: &'f TrackedData,
    /// What the program leaves in them.
    left: &'f Table<Slot, LeftBehind>,
    file_values: &'f FileValues,
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
    /// Tools, work objects and variables of motions that other modules, given or not, can set.
    settable: IdSet<DatumId>,
    read_as_data: ReadAsData,
    /// The values that data can have, where they are a few.
    finite_sets: FiniteSets<'a>,
    /// The values that targets can have by the ways that lead to them.
    on_ways: ByNumber<MotionId, FiniteSet>,
    /// The motions with a target that can be what a search has found.
    from_search: BTreeSet<MotionId>,
    /// The motions with a target that is not read from where the robot stands on any way that leads to them, if it is at other times.
    not_read: BTreeSet<MotionId>,
    /// The PERS of whose value in the file targets are made, by the ways that lead to them.
    of_file: ByNumber<MotionId, Option<DatumId>>,
    /// External axes that move neither the robot's base nor a work object.
    base_fixed: [bool; 6],
    /// Targets that are read as data elsewhere, once each.
    read_elsewhere: BTreeMap<DatumId, Diagnostic>,
    /// The first PERS of each motion's targets, else of its frames.
    made_of_pers: Vec<PersTarget>,
    /// Speeds and zones that are not predefined, once each.
    guesses: BTreeMap<String, Diagnostic>,
}

/// A program goes to and fro between so many setups, as a rule.
const RECENT_SETUPS: usize = 16;

/// All motions in file order, and what runs before those that several others, or others unknown, may run before.
#[derive(Default)]
struct MotionsInOrder {
    motions: Vec<Motion>,
    merge_points: BTreeMap<MotionId, Vec<MotionId>>,
    also_anywhere: BTreeSet<MotionId>,
}

impl MotionsInOrder {
    fn push(&mut self, motion: Motion, before: Predecessors) {
        let id = MotionId::new(self.motions.len());
        let (previous, from_start) = match before {
            Predecessors::Motion(previous) => (Some(previous), false),
            Predecessors::Start => (None, true),
            Predecessors::OneOf { start, anywhere, motions: before } => {
                if anywhere {
                    self.also_anywhere.insert(id);
                }
                self.merge_points.insert(id, before);
                (None, start)
            }
            Predecessors::Unknown => (None, false),
        };
        self.motions.push(Motion { previous, from_start, ..motion });
    }
}

impl<'f, 'a> MotionReader<'f, 'a> {
    fn new(
        evaluator: ConstEvaluator<'a>,
        (tracked, left, file_values): (&'f TrackedData, &'f Table<Slot, LeftBehind>, &'f FileValues),
        (own_positions, on_ways): (OwnPositions, TargetsOnWays),
        nests: Vec<Vec<usize>>,
        base_fixed: [bool; 6],
    ) -> Self {
        let index = evaluator.index;
        Self {
            evaluator,
            tracked,
            left,
            file_values,
            own_positions,
            read_as_data: ReadAsData::new(index),
            finite_sets: FiniteSets::new(index),
            on_ways: on_ways.values,
            from_search: on_ways.found,
            not_read: on_ways.not_read,
            of_file: on_ways.of_file,
            base_fixed,
            nests,
            last: None,
            recent_setups: VecDeque::new(),
            last_skip: None,
            kept_over: BTreeMap::new(),
            settable: IdSet::default(),
            guesses: BTreeMap::new(),
            read_elsewhere: BTreeMap::new(),
            made_of_pers: Vec::new(),
        }
    }

    /// The motions at their sites, each with what it sees in the first pass and in any, and with what runs before it.
    fn motions(
        &mut self,
        sites: impl ExactSizeIterator<Item = ((MotionSite<'a>, (StateSeen, StateSeen)), Predecessors)>,
    ) -> MotionsInOrder {
        let mut out =
            MotionsInOrder { motions: Vec::with_capacity(sites.len()), ..MotionsInOrder::default() };
        for ((site, (first, any)), before) in sites {
            let seen = Seen { first: first.as_deref(), any: any.as_deref() };
            let motion = self.motion(&site, MotionId::new(out.motions.len()), &seen);
            out.push(motion, before);
        }
        out
    }

    /// Names of what motions go by and other modules can set.
    fn settable_names(&self) -> Vec<String> {
        self.settable.iter().map(|datum| self.evaluator.name_of(datum)).collect()
    }

    fn into_warnings(self) -> impl Iterator<Item = Diagnostic> {
        let warnings = self.evaluator.elsewhere_warnings().into_iter().chain(self.kept_over.into_values());
        warnings.chain(self.guesses.into_values()).chain(self.read_elsewhere.into_values())
    }

    fn motion(&mut self, site: &MotionSite<'a>, at: MotionId, seen: &Seen<'_>) -> Motion {
        if let Some(motion) = self.like_the_last(site, at, seen) {
            return motion;
        }
        let index = self.evaluator.index;
        let (args, ctx, form) = (site.args(index), site.ctx(index), site.form);
        let range = site.stmt.range;
        let mut reasons = SkipReasons::of_statement(index, site, ctx, &args);
        let MotionTargets { targets, reached, read_elsewhere } =
            self.targets(&args, (ctx, form.path, at), &mut reasons);
        // Motion settings may be other ones in a later pass than in the first.
        reasons.add_state(seen.any, (&args, form.path), leaves_axes(&targets, form.path));
        let known: &dyn TrackedValues = match seen.first {
            Some(state) => &View { state, tracked: self.tracked },
            None => &Constant,
        };
        let (speed, zone) = (self.speed(&args, ctx, known), self.zone(&args, ctx, known));
        let time_s = self.time_s(&args, ctx, known);
        let Frames { tool, wobj, later } = self.frames(&args, (ctx, form.path), seen, &mut reasons);
        let (tool, later_frames, grip, has_total_load) =
            self.total_load(&args, ctx, known, (tool, later, seen.any.and_then(|state| state.grip)));
        if !self.same_frames(&args, ctx, &reached) {
            reasons.add_other_frames();
        }
        let setup = MotionSetup {
            tool,
            wobj,
            later_frames,
            speed,
            time_s,
            zone,
            grip,
            has_total_load,
            ..self.setup_as_written(site, &args, (ctx, seen.any))
        };
        let (skip_reason, known_at_run_time) = reasons.reported();
        self.note_frames((seen, skip_reason.is_none()), &args, ctx, Span { file: ctx.file, range });
        let is_several = !setup.later_frames.is_empty() || targets.iter().any(Target::is_one_of);
        if skip_reason.is_none() {
            self.note_targets((at, &args, (ctx, form.path)), (&targets, seen), read_elsewhere);
        }
        // Where a function asks at run time, tool and work object are named in the question and in the motion.
        let mut asked_twice = [args.tool, args.wobj].into_iter().flatten();
        let motion = Motion {
            file: ctx.file,
            line: index.file(ctx.file).line(range),
            range,
            targets: targets.into_iter().collect(),
            previous: None,
            from_start: false,
            run_time: (known_at_run_time || is_several && skip_reason.is_none())
                && args.tool.is_some()
                && !asked_twice.any(|expr| is_asked_once(index, ctx, expr)),
            setup: self.shared_setup(setup),
            skip_reason: skip_reason.map(|skip| self.shared_skip(skip)),
            from_search: self.from_search.contains(&at),
        };
        self.keep_as_last((site, at), &args, seen, &motion);
        motion
    }

    /// Keeps what is to be said of the targets of a motion that may be corrected.
    fn note_targets(
        &mut self,
        (motion, args, (ctx, path)): (MotionId, &MoveArgs<'a>, (Ctx, Path)),
        (targets, seen): (&[Target], &Seen<'_>),
        read_elsewhere: Vec<(DatumId, Diagnostic)>,
    ) {
        for (datum, warning) in read_elsewhere {
            self.read_elsewhere.entry(datum).or_insert(warning);
        }
        // Where joints lead hangs on neither tool nor work object.
        let frames_in = seen.any.filter(|_| path != Path::AbsJoint);
        let made_of = self.first_pers(motion, (args, targets), frames_in, ctx);
        if let Some((_, datum)) = made_of.as_ref().filter(|(made_of, _)| made_of.is_variable) {
            self.settable.insert(*datum);
        }
        self.made_of_pers.extend(made_of.map(|(made_of, _)| made_of));
    }

    /// What the text of a motion says of its setup: which kind it is, in which loops it stands, the names of its frames, and which settings
    /// of its path are in force there.
    fn setup_as_written(
        &self,
        site: &MotionSite<'a>,
        args: &MoveArgs<'a>,
        (ctx, state): (Ctx, Option<&State>),
    ) -> MotionSetup {
        let index = self.evaluator.index;
        let text = |expr: Option<&Expr>| expr.map(|expr| index.text(ctx.file, expr.range));
        let handed_on = args.conditional("wobj").map(|parameter| index.text(ctx.file, parameter));
        let given = text(args.wobj).map(|wobj| WobjArgument::Given(wobj.into()));
        MotionSetup {
            routine: site.info,
            loops: self.nests.get(site.nest as usize).cloned().unwrap_or_default(),
            kind: site.kind(index),
            path: site.form.path,
            tool_name: text(args.tool).map(as_text),
            tool: None,
            wobj_name: text(args.wobj).map(as_text),
            wobj: None,
            later_frames: Vec::new(),
            tool_argument: text(args.tool).map(Into::into),
            wobj_argument: given.or_else(|| handed_on.map(|wobj| WobjArgument::IfPresent(wobj.into()))),
            speed: None,
            time_s: None,
            zone: None,
            conf_monitored: state.and_then(|state| conf_monitored(state, site.form.path)),
            grip: None,
            has_total_load: false,
            uneven_turn: state.and_then(|state| uneven_turn(state, site.form.path)),
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

    fn shared_skip(&mut self, skip: SkipReason) -> Arc<SkipReason> {
        let known = self.last_skip.take().filter(|known| **known == skip);
        Arc::clone(self.last_skip.insert(known.unwrap_or_else(|| Arc::new(skip))))
    }
}

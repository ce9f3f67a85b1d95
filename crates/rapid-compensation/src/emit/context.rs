//! What all modules of an emitted program have in common: names, clock and functions, what the comment block says.

use std::collections::BTreeMap;

use super::clock::{Choice, CoreText, Law};
use super::header_text::header_text;
use super::live::{self, Cap, Function, LiveModel};
use super::names::Names;
use super::options::{Core, EmitError, EmitOptions};
use super::scale::Scaled;
use super::touch::MAX_AMOUNT;
use crate::compensate::LiveBasis;
use crate::compensate::plan::{Corrected, Corrections, Form, Plan, PlannedTarget, Status, Totals};
use crate::schedule::{Bucket, Moment};
use nalgebra::Vector3;
use rapid_program::motion::{MotionId, Target};
use rapid_program::{LocalName, Program};
use rapid_syntax::diagnostic::FileId;
use robot_model::deform::GrowthLaw;
use robot_model::kinematics::FrameOffsets;
use robot_model::units::rad_from_deg;

/// The self-test asks for so many targets.
const SELF_TESTS: usize = 5;
/// Beyond this turn a quaternion is normalised again: half its square is what single precision can tell.
const NORMALISE_DEG: f64 = 0.05;

/// The compensated motions of each changed module, by its file and its position among the file's items.
pub(super) type Changes = BTreeMap<(FileId, usize), Vec<MotionId>>;

/// What modules are emitted from, and what they have in common.
pub(super) struct EmitContext<'e> {
    /// The program as it was read.
    pub program: &'e Program,
    /// What becomes of its motions.
    pub plan: &'e Plan,
    /// Names in use for what is added.
    pub names: Names,
    /// Where clock and functions live.
    pub core: Core,
    /// The comment block's lines for people.
    pub header: Vec<String>,
    /// What the program is made with, as the comment block names it.
    pub settings: Vec<(String, String)>,
    /// The core's data, one a line.
    pub data: Vec<String>,
    /// The core's routines, line by line.
    pub routines: Vec<String>,
}

impl<'e> EmitContext<'e> {
    /// For the modules that are changed.
    ///
    /// # Errors
    /// [`EmitError::PlanMismatch`] where a motion asks for a model that RAPID cannot hold.
    pub(super) fn new(
        (program, plan): (&'e Program, &'e Plan),
        options: &'e EmitOptions,
        (law, core): (&'e Law, Core),
        changes: &Changes,
    ) -> Result<Self, EmitError> {
        let totals = Totals::of(program, plan);
        let sees =
            |local: &LocalName| core == Core::Embedded && changes.keys().all(|at| local.modules.contains(at));
        let mut local = options.touch.iter().flat_map(|touch| &touch.local);
        if let Some(LocalName { name, .. }) = local.find(|local| !sees(local)) {
            let whose = if core == Core::Separate { "tcCore" } else { "the module that gets tcTouch" };
            let why =
                format!("{name} is LOCAL to its module, and {whose} cannot see it: declare it without LOCAL");
            return Err(EmitError::CannotTouch(why));
        }
        let text = core_text((program, plan), options, (law, core), (&totals, changes))?;
        let unnamed = Names::default();
        let (mut data, mut routines) = (text.data(&unnamed), text.routines(&unnamed));
        let lines = [data.join("\n"), routines.join("\n")].join("\n");
        let names = Names::new(program, [lines.as_str(), "tcCore"].into_iter());
        if !names.renamed().is_empty() {
            (data, routines) = (text.data(&names), text.routines(&names));
        }
        let header = header_text((&names, core, &text), options, plan, &totals);
        Ok(Self { program, plan, names, core, header, settings: options.made_with(), data, routines })
    }
}

/// Clock and functions for what the motions ask.
fn core_text<'e>(
    (program, plan): (&'e Program, &'e Plan),
    options: &'e EmitOptions,
    (law, core): (&'e Law, Core),
    (totals, changes): (&Totals, &Changes),
) -> Result<CoreText<'e>, EmitError> {
    let path = |id: &FileId| program.file(*id).path.to_ascii_lowercase();
    let s4c = changes.keys().any(|(id, _)| path(id).ends_with(".prg"));
    let asked = totals.by_form[Form::Live as usize] > 0;
    let teach = !s4c && options.form.corrects_run_time();
    let tests =
        || live::test_targets(program, plan, core).take(if options.self_test { SELF_TESTS } else { 0 });
    let live = match plan.live.as_deref().filter(|_| asked || teach).map(live_model) {
        Some(Ok(live)) => Some((live, tests().collect())),
        Some(Err(names)) if asked => return Err(EmitError::PlanMismatch(names.join(", "))),
        Some(Err(_)) | None => None,
    };
    let ramps = totals.by_form[Form::Ramp as usize] > 0;
    let choice = match &plan.functions {
        None => Choice::Bucket(&plan.schedule),
        Some(functions) => Choice::Scale(Box::new(Scaled {
            functions,
            poses: ramps && totals.targets[0] > 0,
            one_of: ramps && one_of(program, plan),
            joints: ramps && totals.targets[1] > 0,
            normalise: totals.max_correction_rad > rad_from_deg(NORMALISE_DEG),
            live,
        })),
    };
    let largest_m = || largest_drift_m(plan, options.growth).unwrap_or(totals.max_correction_m);
    let touch = options.touch.as_ref().map(|touch| (touch, largest_m()));
    if touch.is_some() {
        can_touch((law, options), &choice, s4c).map_err(|why| EmitError::CannotTouch(why.to_owned()))?;
    }
    Ok(CoreText { law, growth: options.growth, choice, task_data: !s4c, touch })
}

/// By how much the table's drift moves the target that it moves most, metres; `None` where no robtarget is corrected by numbers.
///
/// What the cold arm is off already is no drift, and the buckets of a program that touches go up to [`MAX_AMOUNT`] times the drift.
fn largest_drift_m(plan: &Plan, growth: Option<GrowthLaw>) -> Option<f64> {
    let cold = plan.functions.as_ref().and_then(|functions| {
        functions.nodes.iter().position(|node| matches!(node, Moment::Minute(t_min) if *t_min == 0.0))
    });
    let share = |bucket: Option<&Bucket>| Some(growth?.at(bucket?.at_min));
    let buckets = &plan.schedule.buckets;
    let of_target = |target: &PlannedTarget| match &target.corrections {
        Corrections::AtNodes(nodes) => {
            let settled = Vector3::from(nodes.first()?.shift_m()?);
            let cold = match cold {
                Some(cold) => Vector3::from(nodes.get(cold)?.shift_m()?),
                None => Vector3::zeros(),
            };
            Some((settled - cold).norm())
        }
        Corrections::InBuckets(corrected) => {
            let at_m = |corrected: Option<&Corrected>| Some(Vector3::from(corrected?.position_m()?));
            let moved_m = (at_m(corrected.last())? - at_m(corrected.first())?).norm();
            let shares = MAX_AMOUNT * (share(buckets.last())? - share(buckets.first())?);
            (shares > 0.0).then_some(moved_m / shares)
        }
    };
    let compensated = plan.motions.iter().filter(|planned| planned.status == Status::Compensated);
    compensated.flat_map(|planned| &planned.targets).filter_map(of_target).reduce(f64::max)
}

/// Whether some motion asks for one of a few targets.
fn one_of(program: &Program, plan: &Plan) -> bool {
    let mut motions = program.motions.iter().zip(&plan.motions);
    motions.any(|(motion, planned)| {
        let ramps = planned.form == Form::Ramp && planned.status == Status::Compensated;
        ramps && motion.targets.iter().any(Target::is_one_of)
    })
}

/// Why a touch would tell the clock nothing, where it would not.
fn can_touch(
    (law, options): (&Law, &EmitOptions),
    choice: &Choice<'_>,
    s4c: bool,
) -> Result<(), &'static str> {
    if s4c && options.touch.as_ref().is_some_and(|touch| touch.log) {
        return Err(
            "an S4C controller has no CalcJointT, from which the joints of a log come: leave --touch-log out",
        );
    }
    if !matches!(law, Law::TwoStage { .. } | Law::OneLag { .. }) {
        return Err(
            "a touch tells the lags of a growth law, which the clock must follow: use --clock warmth",
        );
    }
    if options.growth.is_none() {
        return Err(
            "the rows of a scheduled table have courses of their own, and a touch tells one share: give a static table with --growth \
             (`fit` makes one of touches), or a model whose terms grow by one law",
        );
    }
    match choice {
        Choice::Scale(scaled) if !scaled.functions.course.is_of_share() => {
            Err("the drift follows no one growth law, whose share a touch could tell")
        }
        Choice::Scale(_) | Choice::Bucket(_) => Ok(()),
    }
}

/// The deformed model that motions ask at run time.
fn live_model(basis: &LiveBasis) -> Result<LiveModel, Vec<String>> {
    let function = |offsets: &FrameOffsets| Function { offsets: *offsets, shape: None };
    let functions: Vec<Function> = basis.offsets.iter().map(function).collect();
    let cap = Cap {
        shift_m: basis.max_correction_m,
        turn_rad: basis.max_correction_rad,
        joint_rad: basis.max_joint_change_rad,
    };
    let live = LiveModel::new(&basis.robot, &functions, basis.identified.as_deref(), cap)?;
    Ok(live.with_payload_kg(basis.payload_kg))
}

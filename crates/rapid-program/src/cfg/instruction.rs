//! What an instruction does to what is tracked: what it writes, and what it puts in force.

use super::CfgBuilder;
use crate::call_arguments::NotGiven;
use crate::const_eval::Constant;
use crate::convert;
use crate::data::LoadData;
use crate::expressions::{every_index, root_of, words};
use crate::flow::{Blocker, DISPLACE, FlowStep, Node, OFFSET_EXTERNAL};
use crate::ids::DatumId;
use crate::index::Resolved;
use crate::motion::MotionId;
use crate::names::{as_text, lower_case};
use crate::other_instructions::{harmless, moves_arm};
use crate::written_by::written_by_instruction;
use nalgebra::Isometry3;
use rapid_syntax::diagnostic::{Span, TextRange};
use rapid_syntax::tree::{ArgKind, CallStmt, Callee, Expr, ExprKind, StmtKind};

impl<'a> CfgBuilder<'_, 'a> {
    /// Tracked data that an instruction writes.
    pub(super) fn written(&self, call: &'a CallStmt, at: Span, out: &mut Vec<Node<'a>>) {
        let Callee::Name(name) = &call.callee else { return };
        let lower = lower_case(self.text(*name));
        for expr in written_by_instruction(self.index(), self.ctx, &lower, &call.args) {
            if let Some((root, _)) = root_of(expr) {
                self.invalidate(root, &format!("{} writes it", as_text(self.text(*name))), at, out);
            }
        }
    }

    pub(super) fn instruction(
        &mut self,
        name: TextRange,
        call: &'a CallStmt,
        at: Span,
        out: &mut Vec<Node<'a>>,
    ) {
        let written = as_text(self.text(name));
        let lower = lower_case(self.text(name));
        let conditional = call.args.iter().any(|a| matches!(a.kind, ArgKind::Conditional { .. }));
        let on = if conditional { None } else { Some(!self.has_option(call, "off")) };
        let locks = conditional || self.has_option(call, "lockaxis4");
        let displaces_nothing = lower == "pdispset" && self.is_no_displacement(call);
        let offsets_nothing = lower == "eoffsset" && self.offsets_nothing(call);
        let active = |what: &str| Some(self.why(at, format!("{what} ({written})")));
        let added = self.index().added_routine(&lower);
        let step = match lower.as_str() {
            "confl" => FlowStep::ConfL(on),
            "confj" => FlowStep::ConfJ(on),
            "gripload" => FlowStep::Grip(self.gripped(call)),
            "pdispset" if displaces_nothing => FlowStep::Blocker(Blocker::Displacement, None),
            displaces if DISPLACE.contains(&displaces) => {
                FlowStep::Blocker(Blocker::Displacement, active(self.displacement(&lower, call)))
            }
            "pdispoff" => FlowStep::Blocker(Blocker::Displacement, None),
            "eoffsset" if offsets_nothing => FlowStep::Blocker(Blocker::ExternalOffset, None),
            offsets if OFFSET_EXTERNAL.contains(&offsets) => {
                FlowStep::Blocker(Blocker::ExternalOffset, active("an offset of external axes is in force"))
            }
            "eoffsoff" => FlowStep::Blocker(Blocker::ExternalOffset, None),
            "softact" | "cssact" => FlowStep::Blocker(Blocker::SoftServo, active("the soft servo is active")),
            "softdeact" | "cssdeact" => FlowStep::Blocker(Blocker::SoftServo, None),
            "fcact" => FlowStep::Blocker(Blocker::ForceControl, active("force control is active")),
            "fcdeact" => FlowStep::Blocker(Blocker::ForceControl, None),
            "singarea" if locks => {
                FlowStep::Blocker(Blocker::LockedAxis, active("axis 4 is locked, whatever a target needs"))
            }
            "singarea" => FlowStep::Blocker(Blocker::LockedAxis, None),
            "syncmoveon" => {
                FlowStep::Blocker(Blocker::MultiMove, active("the robot moves together with others"))
            }
            "syncmoveoff" | "syncmoveundo" => FlowStep::Blocker(Blocker::MultiMove, None),
            "cirpathmode" => return self.circle_path_mode(call, at, out),
            "callbyvar" => {
                self.call_by_number(call, out);
                FlowStep::UnknownPosition
            }
            "exitcycle" => FlowStep::ExitCycle,
            _ if moves_arm(&lower) || added.is_some_and(|added| added.moves_arm) => FlowStep::UnknownPosition,
            _ if harmless(&lower) || added.is_some() => return,
            _ => {
                let callee = NotGiven::instruction(&lower);
                self.doubtful(name, &call.args, callee, at, out);
                self.not_given(lower, name);
                FlowStep::UnknownPosition
            }
        };
        out.push(Node::Step(step));
    }

    /// What a motion leaves in force of force control, which the first one of such motions switches on and the last one off, and of the soft servo,
    /// which one ends.
    pub(super) fn force_control(&self, motion: MotionId, at: Span, out: &mut Vec<Node<'a>>) {
        let step = match self.sites.motions.get(motion.index()).map(|site| site.form.name) {
            Some("FCPress1LStart") => {
                let why = self.why(at, "force control is active (FCPress1LStart)".to_owned());
                FlowStep::Blocker(Blocker::ForceControl, Some(why))
            }
            Some("FCPressEnd") => FlowStep::Blocker(Blocker::ForceControl, None),
            Some("CSSDeactMoveL") => FlowStep::Blocker(Blocker::SoftServo, None),
            _ => return,
        };
        out.push(Node::Step(step));
    }

    /// `CirPathMode`: an option that only run time tells is taken to be given.
    fn circle_path_mode(&self, call: &CallStmt, at: Span, out: &mut Vec<Node<'a>>) {
        let options = call.args.iter().filter_map(|arg| match &arg.kind {
            ArgKind::Named { name, .. } | ArgKind::Conditional { name, .. } => Some(self.text(*name)),
            ArgKind::Positional(_) => None,
        });
        let (mut circle_point, mut wrist) = (None, None);
        for option in options {
            let written = as_text(option);
            match lower_case(option).as_str() {
                "pathframe" | "objectframe" => {}
                "cirpointori" => {
                    let what = "the tool passes circle points as they are written, and turns unevenly";
                    circle_point = Some(self.why(at, format!("{what} (CirPathMode\\{written})")));
                }
                _ => {
                    let what = "two axes of the wrist alone turn the tool on arcs, not to what is written";
                    wrist = Some(self.why(at, format!("{what} (CirPathMode\\{written})")));
                }
            }
        }
        out.push(Node::Step(FlowStep::Blocker(Blocker::CirclePointOrientation, circle_point)));
        out.push(Node::Step(FlowStep::Blocker(Blocker::WristOnArcs, wrist)));
    }

    /// What a program displacement that is set by `instruction` is.
    fn displacement(&self, instruction: &str, call: &'a CallStmt) -> &'static str {
        // Without \ExeP it is measured where the arm stands.
        match instruction == "pdispon" && !self.has_option(call, "exep") {
            true => "a program displacement is in force, which holds the correction of the motion before it",
            false if instruction == "pdispset" && self.is_by_pers(call) => {
                "a program displacement is in force that a controller may hold otherwise than the file"
            }
            false => "a program displacement is in force",
        }
    }

    fn has_option(&self, call: &CallStmt, option: &str) -> bool {
        call.args.iter().any(|arg| match &arg.kind {
            ArgKind::Named { name, .. } => lower_case(self.text(*name)) == option,
            _ => false,
        })
    }

    /// Whether a PERS goes into the pose that is given to PDispSet.
    fn is_by_pers(&self, call: &'a CallStmt) -> bool {
        self.given_pose(call).is_some_and(|given| self.can_be_set(given))
    }

    /// The pose given to PDispSet; of a name that the statement just above assigns, the value that it assigns.
    fn given_pose(&self, call: &'a CallStmt) -> Option<&'a Expr> {
        let Some(ArgKind::Positional(given)) = call.args.first().map(|arg| &arg.kind) else { return None };
        let index = self.index();
        let named = |expr: &Expr| match (&expr.kind, index.datum(expr.range, self.ctx)) {
            (ExprKind::Name, Resolved::Here(datum) | Resolved::Elsewhere(datum)) => Some(datum),
            _ => None,
        };
        let writes = self.evaluator.writes;
        let by_statements =
            |datum: &DatumId| writes.orderly(*datum) && writes.by_computed_name(index, *datum).is_none();
        match (named(given).filter(by_statements), self.before.map(|stmt| &stmt.kind)) {
            (Some(datum), Some(StmtKind::Assign(assign))) if named(&assign.target) == Some(datum) => {
                Some(&assign.value)
            }
            _ => Some(given),
        }
    }

    /// Whether the pose given to PDispSet is a constant that displaces nothing.
    fn is_no_displacement(&mut self, call: &'a CallStmt) -> bool {
        let Some(pose) = self.given_pose(call) else { return false };
        if self.can_be_set(pose) {
            return false;
        }
        let ctx = self.ctx;
        let pose = self.evaluator.fold(pose, ctx, &Constant).map(|typed| convert::pose(&typed.value));
        matches!(pose, Ok(Ok(pose)) if pose == Isometry3::identity())
    }

    /// Whether the offsets given to EOffsSet are constant and of axes alone that move no robot.
    fn offsets_nothing(&mut self, call: &CallStmt) -> bool {
        let Some(ArgKind::Positional(offsets)) = call.args.first().map(|arg| &arg.kind) else { return false };
        if self.can_be_set(offsets) {
            return false;
        }
        let ctx = self.ctx;
        let Ok(offsets) = self.evaluator.fold(offsets, ctx, &Constant) else { return false };
        let Ok(offsets) = convert::extjoint(&offsets.value) else { return false };
        offsets.iter().zip(self.base_fixed).all(|(by, fixed)| fixed || by.is_none_or(|by| by == 0.0))
    }

    /// The load of a GripLoad, where it is constant.
    fn gripped(&mut self, call: &CallStmt) -> Option<LoadData> {
        let load = call.args.iter().find_map(|arg| match &arg.kind {
            ArgKind::Positional(load) => Some(load),
            _ => None,
        })?;
        // A load is a PERS as a rule; which of several it is may be set on the pendant.
        let mut is_chosen_there = false;
        every_index(load, &mut |_, element_of| {
            is_chosen_there |= element_of.indices.iter().any(|index| self.can_be_set(index));
        });
        if is_chosen_there {
            return None;
        }
        let ctx = self.ctx;
        let load = self.evaluator.fold(load, ctx, &Constant).ok()?;
        convert::loaddata(&load.value).ok()
    }

    /// Text that was not understood: what it names is no longer known, nor where the arm is.
    pub(super) fn opaque(&self, range: TextRange, out: &mut Vec<Node<'a>>) {
        let at = Span { file: self.ctx.file, range };
        for word in words(self.text(range), range.start) {
            let lower = lower_case(self.text(word));
            let named = || Some(self.why(at, format!("text that was not understood names {lower}")));
            out.push(Node::Step(match lower.as_str() {
                "confl" => FlowStep::ConfL(None),
                "confj" => FlowStep::ConfJ(None),
                "gripload" => FlowStep::Grip(None),
                "pdispon" | "pdispset" | "pdispadd" | "pdispoff" => {
                    FlowStep::Blocker(Blocker::Displacement, named())
                }
                "eoffson" | "eoffsset" | "eoffsoff" => FlowStep::Blocker(Blocker::ExternalOffset, named()),
                "softact" | "softdeact" | "cssact" | "cssdeact" => {
                    FlowStep::Blocker(Blocker::SoftServo, named())
                }
                "fcact" | "fcdeact" | "fcpress1lstart" => FlowStep::Blocker(Blocker::ForceControl, named()),
                "singarea" => FlowStep::Blocker(Blocker::LockedAxis, named()),
                "syncmoveon" | "syncmoveoff" => FlowStep::Blocker(Blocker::MultiMove, named()),
                "cirpathmode" => FlowStep::Blocker(Blocker::WristOnArcs, named()),
                _ => {
                    self.invalidate(word, "text that was not understood names it", at, out);
                    continue;
                }
            }));
        }
        out.push(Node::Step(FlowStep::UnknownPosition));
    }
}

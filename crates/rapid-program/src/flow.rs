//! The ways through a routine: its statements reduced to what matters for motion, and the walk that
//! carries a state along all of them, joining where ways meet, until nothing changes any more.

use super::data::{LoadData, external_axis_letter, meant_as_unused};
use super::errors::Recovery;
use super::ids::{DatumId, RoutineIndex, Slot};
use super::index::{Ctx, Index};
use super::motion::{MotionId, SkipReason};
use super::names::{ByNumber, Sym};
use super::value::Why;
use rapid_syntax::diagnostic::Span;
use rapid_syntax::tree::Expr;
use std::rc::Rc;

/// A routine reduced to what matters.
#[derive(Debug, Default)]
pub(super) struct RoutineCfg<'a> {
    pub(super) body: Vec<Node<'a>>,
    pub(super) handlers: Vec<Vec<Node<'a>>>,
    pub(super) recovery: Recovery,
}

/// A step, or a place where ways part.
#[derive(Debug)]
pub(super) enum Node<'a> {
    /// Something that changes the state.
    Step(FlowStep<'a>),
    /// One of several; `otherwise`: there is also the way past all of them.
    Branch {
        arms: Vec<Vec<Node<'a>>>,
        otherwise: bool,
    },
    Loop {
        body: Vec<Node<'a>>,
        at_least_once: bool,
        endless: bool,
    },
    /// A place to jump to.
    Label(Sym),
    Goto(Sym),
    /// The routine ends here.
    Return,
    /// The program or the way ends here: EXIT, RETRY, TRYNEXT, RAISE where no handler goes on behind it.
    Stop,
}

/// What changes the state.
#[derive(Debug)]
pub(super) enum FlowStep<'a> {
    /// So many motions that follow one another, from this one on.
    Motions { first: MotionId, count: u32 },
    /// A tracked datum is set: `slot.path := value`.
    Assign { slot: Slot, path: Vec<Sym>, value: &'a Expr, ctx: Ctx, at: Span },
    /// A datum becomes unknown.
    Invalidate { slot: Slot, why: Why, at: Span },
    /// `ConfL`: on, off, or not known.
    ConfL(Option<bool>),
    /// `ConfJ`: on, off, or not known.
    ConfJ(Option<bool>),
    /// `GripLoad`; `None`: of a load that is not known.
    Grip(Option<LoadData>),
    /// A displacement and the like comes into force, or goes.
    Blocker(Blocker, Option<Why>),
    /// Routines of the program, one of which is called; `maybe`: or none. `recovery`: what becomes of an
    /// error in one of them.
    Call {
        routines: Vec<RoutineIndex>,
        bindings: Vec<Binding<'a>>,
        maybe: bool,
        recovery: Recovery,
        ctx: Ctx,
    },
    /// An error may come here; what becomes of it.
    MayFail(Recovery),
    /// A routine that is not given, or text that was not understood: where the arm stands after it is
    /// not known.
    UnknownPosition,
    /// `ExitCycle`: the program begins anew, with what is in force.
    ExitCycle,
}

/// What a parameter that is tracked is worth in a call.
#[derive(Debug)]
pub(super) struct Binding<'a> {
    pub(super) slot: Slot,
    pub(super) param: DatumId,
    pub(super) value: Option<&'a Expr>,
}

/// Instructions that put a program displacement in force.
pub(super) const DISPLACE: [&str; 3] = ["pdispadd", "pdispon", "pdispset"];
/// Instructions that put offsets of external axes in force.
pub(super) const OFFSET_EXTERNAL: [&str; 2] = ["eoffson", "eoffsset"];

/// What, once in force, shifts, softens or binds all motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Blocker {
    /// Program displacement: PDispOn, PDispSet.
    Displacement,
    /// Offsets of external axes: EOffsOn, EOffsSet.
    ExternalOffset,
    /// The soft servo: SoftAct, CSSAct.
    SoftServo,
    /// Force control: FCAct, FCPress1LStart.
    ForceControl,
    /// Axis 4 is locked: SingArea\LockAxis4.
    LockedAxis,
    /// Motion together with others: SyncMoveOn.
    MultiMove,
    /// On arcs the tool passes the circle point as that is written: CirPathMode\CirPointOri.
    CirclePointOrientation,
    /// On arcs two axes of the wrist alone turn the tool: CirPathMode\Wrist45 and its kin.
    WristOnArcs,
    /// An external axis, counted from 0, that may carry the robot's base has been placed away from 0, and stays there where a target names no
    /// place for it.
    PlacedAxis(u8),
}

/// Why an external axis, counted from 0, keeps motion that names no place for it, where a motion `at` some place has put it at `place`, or,
/// where what its target says is not known, may have put it somewhere.
pub(super) fn placed_axis(index: &Index<'_>, axis: u8, (at, place): (Span, Option<f64>)) -> Why {
    let axis = external_axis_letter(usize::from(axis));
    let was_placed = if place.is_some() { "was placed" } else { "may have been placed" };
    let meant = place.and_then(meant_as_unused).unwrap_or_default();
    let reason = format!(
        "external axis {axis}, which may carry the robot's base or the work object, {was_placed} before and stays there (--base-fixed {axis} says \
         that it carries neither{meant}): {}",
        index.place(at)
    );
    Rc::new(SkipReason { code: "keep::external-base", reason, because: Some(at) })
}

/// All blockers, in the order in which a state has them.
pub(super) const BLOCKERS: [Blocker; 14] = [
    Blocker::Displacement,
    Blocker::ExternalOffset,
    Blocker::SoftServo,
    Blocker::ForceControl,
    Blocker::LockedAxis,
    Blocker::MultiMove,
    Blocker::CirclePointOrientation,
    Blocker::WristOnArcs,
    Blocker::PlacedAxis(0),
    Blocker::PlacedAxis(1),
    Blocker::PlacedAxis(2),
    Blocker::PlacedAxis(3),
    Blocker::PlacedAxis(4),
    Blocker::PlacedAxis(5),
];

/// What is carried along the ways.
pub(super) trait ForwardAnalysis<'a> {
    /// What is known at one place.
    type State: Clone;
    /// Makes `into` hold for both; whether that changed it.
    fn join(&mut self, into: &mut Self::State, other: &Self::State) -> bool;
    /// The state after a step; `None`: the way does not go on.
    fn step(&mut self, step: &FlowStep<'a>, state: Self::State) -> Option<Self::State>;
}

/// The state at the end of a body that is entered with `entry`; `None` where its end is never reached.
pub(super) fn walk<'a, C: ForwardAnalysis<'a>>(
    analysis: &mut C,
    body: &[Node<'a>],
    entry: &C::State,
) -> Option<C::State> {
    let mut walk = FlowWalk { analysis, labels: ByNumber::default(), again: false, end: None };
    loop {
        walk.again = false;
        walk.labels.values_mut().for_each(|label| label.seen = false);
        let end = walk.block(body, Some(entry.clone()));
        walk.leave(end);
        if !walk.again {
            return walk.end;
        }
    }
}

struct FlowWalk<'c, 'a, C: ForwardAnalysis<'a>> {
    analysis: &'c mut C,
    labels: ByNumber<Sym, LabelState<C::State>>,
    again: bool,
    end: Option<C::State>,
}

/// What is known of a label of the routine that is being walked.
struct LabelState<S> {
    /// With what jumps come to it.
    jumped: Option<S>,
    /// It was come by since the walk began from above.
    seen: bool,
}

impl<'a, C: ForwardAnalysis<'a>> FlowWalk<'_, 'a, C> {
    fn block(&mut self, nodes: &[Node<'a>], mut state: Option<C::State>) -> Option<C::State> {
        for node in nodes {
            state = self.node(node, state);
        }
        state
    }

    fn node(&mut self, node: &Node<'a>, state: Option<C::State>) -> Option<C::State> {
        if let Node::Label(label) = node {
            let label = self.labels.entry(*label).or_insert(LabelState { jumped: None, seen: true });
            label.seen = true;
            let jumped = label.jumped.clone();
            return self.either(state, jumped);
        }
        match (node, state) {
            (Node::Step(step), Some(state)) => self.analysis.step(step, state),
            (Node::Branch { arms, otherwise }, state) => {
                let mut out = if *otherwise { state.clone() } else { None };
                for arm in arms {
                    let end = self.block(arm, state.clone());
                    out = self.either(out, end);
                }
                out
            }
            (Node::Loop { body, at_least_once, endless }, Some(entry)) => {
                let mut head = entry;
                let end = loop {
                    let end = self.block(body, Some(head.clone()));
                    match &end {
                        Some(state) if self.analysis.join(&mut head, state) => {}
                        _ => break end,
                    }
                };
                match (endless, at_least_once) {
                    (true, _) => None,
                    (false, true) => end,
                    (false, false) => Some(head),
                }
            }
            // Nothing comes in from above, but a label may stand inside.
            (Node::Loop { body, endless, .. }, None) => self.block(body, None).filter(|_| !endless),
            (Node::Goto(label), Some(state)) => {
                let label = self.labels.entry(*label).or_insert(LabelState { jumped: None, seen: false });
                let changed = match &mut label.jumped {
                    Some(known) => self.analysis.join(known, &state),
                    none => {
                        *none = Some(state);
                        true
                    }
                };
                self.again |= changed && label.seen;
                None
            }
            (Node::Return, state) => {
                self.leave(state);
                None
            }
            (Node::Stop, _) | (_, None) | (Node::Label(_), _) => None,
        }
    }

    fn leave(&mut self, state: Option<C::State>) {
        let end = self.end.take();
        self.end = self.either(end, state);
    }

    fn either(&mut self, a: Option<C::State>, b: Option<C::State>) -> Option<C::State> {
        match (a, b) {
            (Some(mut a), Some(b)) => {
                self.analysis.join(&mut a, &b);
                Some(a)
            }
            (a, b) => a.or(b),
        }
    }
}

/// Calls `visit` with every step, inner ones included, in order.
pub(super) fn every_step<'n, 'a>(nodes: &'n [Node<'a>], visit: &mut dyn FnMut(&'n FlowStep<'a>)) {
    for node in nodes {
        match node {
            Node::Step(step) => visit(step),
            Node::Branch { arms, .. } => arms.iter().for_each(|arm| every_step(arm, visit)),
            Node::Loop { body, .. } => every_step(body, visit),
            Node::Label(_) | Node::Goto(_) | Node::Return | Node::Stop => {}
        }
    }
}

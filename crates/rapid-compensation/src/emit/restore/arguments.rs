//! What the arguments of an emitted module's motions are: elements of arrays that were added, and functions that stand round a target.

use crate::emit::asks;
use crate::emit::declarations::Declarations;
use crate::emit::header::Record;
use crate::emit::names::word_length;
use rapid_syntax::diagnostic::TextRange;
use rapid_syntax::tree::{Arg, ArgKind, Expr, ExprKind, Routine};

/// Functions that stand round a target and correct it by what is beside it.
const BY_POSE: [&str; 4] = ["tcAt", "tcAtSame", "tcAtOne", "tcAtJ"];
/// Functions that stand round a target and ask the model, with the motion's tool and work object.
const BY_MODEL: [&str; 3] = ["tcLive", "tcLiveSame", "tcLiveJ"];

/// Those of them that take what a motion's first target asked for: they are for the second point of an arc.
const AGAIN: [&str; 2] = ["tcAtSame", "tcLiveSame"];
/// What stands round the first point and round the second.
const IN_EITHER: &str = "tcAtOne";

/// A place among a motion's targets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    /// The first, which asks the clock.
    First,
    /// One behind it, which sees the same moment.
    Behind,
}

impl Place {
    /// Of a target behind `count` others.
    pub(super) fn behind(count: usize) -> Self {
        if count == 0 { Self::First } else { Self::Behind }
    }
}

/// A motion's argument that is an array's element: `name{tcK()}`, `name{tcI}` or `name{index,tcK()}`.
pub(super) struct Element {
    /// The array's name.
    pub(super) name: TextRange,
    /// The source's own index, where the array is one of many targets.
    pub(super) index: Option<TextRange>,
    /// The place among a motion's targets that it is written for.
    pub(super) place: Place,
}

/// What a function of ours stands round.
pub(super) struct Inside<'e> {
    /// The target that it corrects.
    pub(super) target: TextRange,
    /// The place among a motion's targets that it belongs to; `None` of one for any.
    pub(super) place: Option<Place>,
    /// The tool and work object that a model is asked with.
    asked_with: &'e [Arg],
    /// What corrects it where no model is asked.
    corrections: &'e [Arg],
}

impl Inside<'_> {
    /// The name of the first correction; empty where a model is asked.
    pub(super) fn corrected_by<'b>(&self, bytes: &'b [u8]) -> &'b [u8] {
        let first = match self.corrections.first().map(|arg| &arg.kind) {
            Some(ArgKind::Positional(expr)) => expr.range.of(bytes),
            _ => b"",
        };
        first.split_at(word_length(first)).0
    }
}

/// Reads the arguments of a module's motions.
#[derive(Clone, Copy)]
pub(super) struct Arguments<'a> {
    pub(super) bytes: &'a [u8],
    pub(super) record: &'a Record,
}

/// A call, and what names mean in it.
#[derive(Clone, Copy)]
pub(super) struct Called<'a, 'w> {
    pub(super) args: &'w [Arg],
    pub(super) routine: &'w Routine,
    pub(super) declarations: &'a Declarations<'w>,
}

impl Arguments<'_> {
    fn is_core(&self, range: TextRange, name: &str) -> bool {
        range.of(self.bytes).eq_ignore_ascii_case(self.record.core(name).as_bytes())
    }

    /// Whether a name is that of a function of ours which stands round a target.
    pub(super) fn stands_round(&self, name: &[u8]) -> bool {
        let is = |function: &&str| name.eq_ignore_ascii_case(self.record.core(function).as_bytes());
        BY_POSE.iter().chain(&BY_MODEL).any(is)
    }

    /// Whether a text is the last index of an element of ours: `tcI`, or `tcK()` with or without blanks.
    pub(super) fn is_asking(&self, index: &[u8]) -> bool {
        let (name, behind) = index.split_at(word_length(index));
        let is = |asked: &str| name.eq_ignore_ascii_case(self.record.core(asked).as_bytes());
        match behind.trim_ascii() {
            [] => is("tcI"),
            [b'(', blanks @ .., b')'] => blanks.trim_ascii().is_empty() && is("tcK"),
            _ => false,
        }
    }

    /// An argument as the element of an array of ours.
    pub(super) fn element(&self, expr: &Expr) -> Option<Element> {
        let ExprKind::Index(element) = &expr.kind else { return None };
        let base = &element.base;
        if !matches!(base.kind, ExprKind::Name) {
            return None;
        }
        let (last, own) = element.indices.split_last()?;
        let place = match &last.kind {
            ExprKind::Name if self.is_core(last.range, "tcI") => Place::Behind,
            ExprKind::Call(call) if call.args.is_empty() && self.is_core(call.name, "tcK") => Place::First,
            _ => return None,
        };
        let index = match (own.first(), own.last()) {
            (Some(first), Some(last)) => Some(first.range.cover(last.range)),
            _ => None,
        };
        Some(Element { name: base.range, index, place })
    }

    /// What a function of ours stands round.
    pub(super) fn inside<'e>(&self, expr: &'e Expr) -> Option<Inside<'e>> {
        let ExprKind::Call(call) = &expr.kind else { return None };
        let is_any = |functions: &[&str]| functions.iter().any(|function| self.is_core(call.name, function));
        let (target, rest) = call.args.split_first()?;
        let (asked_with, corrections): (&[Arg], &[Arg]) = match (is_any(&BY_MODEL), is_any(&BY_POSE)) {
            (true, _) => (rest, &[]),
            (false, true) => (&[], rest),
            (false, false) => return None,
        };
        let place = if is_any(&AGAIN) { Place::Behind } else { Place::First };
        let place = (!is_any(&[IN_EITHER])).then_some(place);
        match &target.kind {
            ArgKind::Positional(inner) => {
                Some(Inside { target: inner.range, place, asked_with, corrections })
            }
            _ => None,
        }
    }

    /// Whether what corrects a target did when the module was made, and a model is asked with what the motion goes with.
    pub(super) fn is_as_made(&self, argument: &Expr, inside: &Inside<'_>, motion: Called<'_, '_>) -> bool {
        self.goes_with(motion.args, inside.asked_with) && self.was_asked(argument, inside, motion)
    }

    /// Whether what corrects a target did when the module was made.
    fn was_asked(&self, argument: &Expr, inside: &Inside<'_>, motion: Called<'_, '_>) -> bool {
        let ExprKind::Call(call) = &argument.kind else { return true };
        if inside.corrections.is_empty() {
            return true;
        }
        let behind = TextRange::new(inside.target.end, argument.range.end).of(self.bytes);
        let arguments = behind.strip_suffix(b")").unwrap_or(behind);
        let target = inside.target.of(self.bytes);
        // An older module does not tell a routine's own name from the module's.
        let is_own = !self.record.mentions.is_empty()
            && motion.declarations.is_local(target.trim_ascii(), motion.routine);
        let ask = asks::ask(call.name.of(self.bytes), (target, is_own), arguments);
        ask.is_none_or(|ask| asks::was_asked(&self.record.asks, ask))
    }

    /// Whether a model is asked with the motion's own tool and work object; true where none is asked.
    fn goes_with(&self, motion: &[Arg], asked_with: &[Arg]) -> bool {
        let text = |range: TextRange| range.of(self.bytes).to_ascii_lowercase();
        let tool = |arg: &Arg| match &arg.kind {
            ArgKind::Positional(expr) => Some(text(expr.range)),
            _ => None,
        };
        let wobj = |arg: &Arg| match &arg.kind {
            ArgKind::Named { name, value } if text(*name) == b"wobj" => {
                value.as_ref().map(|value| text(value.range))
            }
            ArgKind::Conditional { name, param } if text(*name) == b"wobj" => Some(text(*param)),
            _ => None,
        };
        let Some(asked) = asked_with.first().and_then(tool) else { return asked_with.is_empty() };
        motion.iter().filter_map(tool).any(|own| own == asked)
            && motion.iter().find_map(wobj) == asked_with.iter().find_map(wobj)
    }
}

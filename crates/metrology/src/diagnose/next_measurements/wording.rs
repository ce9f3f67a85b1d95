//! What the next measurements are for, in words.

use crate::diagnose::outcome::Verdict;

/// To tell the first of `names` from the others.
#[must_use]
pub(super) fn question(names: &[String]) -> String {
    match names {
        [] => String::new(),
        [one] => format!("to be sure of {one}"),
        [one, rivals @ ..] => format!("to tell {one} from {}", rivals.join(" and from ")),
    }
}

/// Why the poses are worth measuring, from the names of the causes of each slot that they are for, the likeliest cause first.
#[must_use]
pub(super) fn reason(verdict: Verdict, slots: &[Vec<String>]) -> String {
    let first = slots.first().map_or(&[][..], Vec::as_slice);
    match (verdict, first) {
        (Verdict::Ambiguous, _) => {
            let questions: Vec<String> = slots.iter().map(|names| question(names)).collect();
            questions.join(", and ")
        }
        (Verdict::Explained | Verdict::Several, [one, rival, ..]) => {
            format!("to confirm {one} against its nearest rival, {rival}")
        }
        (Verdict::UnexplainedStructure | Verdict::UnexplainedScatter, [one, ..]) => {
            format!("to test the nearest candidate, {one}")
        }
        (_, [one, ..]) => format!("to see effects as small as the noise; most of all {one}"),
        _ => String::new(),
    }
}

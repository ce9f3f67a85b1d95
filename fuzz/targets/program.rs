//! Any program is compensated and restored, or refused.

#![allow(clippy::expect_used, reason = "a target stops where its promise is broken")]

use crate::tree_check::check;
use driftpost::{Compensation, Deformation, ProgramFiles, Robot};
use rapid_compensation::compensate::FormChoice;
use rapid_compensation::emit::restore;
use rapid_syntax::parse;
use std::sync::LazyLock;

static ROBOT: LazyLock<Robot> = LazyLock::new(|| Robot::built_in("irb140").expect("it is built in"));
static PAPER: LazyLock<Deformation> = LazyLock::new(Deformation::paper);

/// Refusals that no program brings about: only a fault of ours does.
const FAULTS: [&str; 3] = ["emit::not-restored", "emit::plan-mismatch", "emit::edit"];

/// Compensated, in the form that the first byte names: what is emitted is read without a word more, and gives the source back.
pub fn program(data: &[u8]) {
    let Some((&form, source)) = data.split_first() else { return };
    let forms = [FormChoice::Schedule, FormChoice::Ramp, FormChoice::Live, FormChoice::Auto];
    let form = forms[usize::from(form) % forms.len()];
    let files = ProgramFiles::one("Fuzzed.mod", source);
    let compensation = Compensation::new(ROBOT.clone(), PAPER.clone()).in_form(form);
    let result = match compensation.run(&files) {
        Ok(result) => result,
        Err(refusal) => {
            let mut codes = refusal.messages.iter().map(|message| message.diagnostic.code);
            assert!(
                !codes.any(|code| FAULTS.contains(&code)),
                "refused for a fault of ours: {:?}",
                refusal.messages
            );
            return;
        }
    };
    let Some(emitted) = result.text() else { return };
    let (before, after) = (parse(source).1.len(), parse(emitted).1.len());
    assert!(after <= before, "{after} problems in what was emitted, {before} in the source");
    check(emitted).expect("what was emitted is a tree");
    let restored = restore(emitted).expect("what was emitted is restored");
    assert!(restored.exact && restored.bytes == source, "restored to other bytes");
}

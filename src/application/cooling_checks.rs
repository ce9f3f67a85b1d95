//! What a clock that falls back while the robot stands gets wrong of a table or a model.

use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::identified::{Identified, Term};
use robot_model::deform::{Deformation, EffectKind};
use robot_model::units::mm_from_m;
use std::collections::BTreeMap;

/// All warnings of `deformation`, of the file `name`, and of the `model` beside it.
pub(super) fn all(name: &str, deformation: &Deformation, model: Option<&Identified>) -> Vec<Diagnostic> {
    let found = [no_single_law(name, deformation, model), few_rows(name, deformation, model)];
    found.into_iter().flatten().chain(model.and_then(|model| creep(deformation, model))).collect()
}

/// A table or a model that follows no single law, by which what there is of it falls back while the robot stands.
fn no_single_law(name: &str, deformation: &Deformation, model: Option<&Identified>) -> Option<Diagnostic> {
    let fitted = deformation.warm_up_law(model).filter(|fitted| !fitted.is_followed())?;
    let text = format!(
        "{name}: what grows follows no single law ({} is nearest, and leaves {:.0} % of the change): while the robot works all is as the table or model has \
         it; after a pause all of it has fallen back by that law, in the program as in `simulate`",
        fitted.law,
        100.0 * fitted.left
    );
    let help = "joints that warm at rates of their own cool so, too: after a stop of an hour let the robot warm up again before it is relied upon, or \
                let it get cold and call tcColdStart";
    Some(Diagnostic::warning("deform::no-single-law", text).help(help))
}

/// A table whose rows are too few to tell a law: one lag or two, and how long.
fn few_rows(name: &str, deformation: &Deformation, model: Option<&Identified>) -> Option<Diagnostic> {
    let rows = deformation.few_rows()?;
    let fitted = deformation.warm_up_law(model)?;
    let text = format!(
        "{name}: rows at {rows} different minutes, minute 0 counted, do not tell by which law the robot warms up ({} is taken): while it works all is as the table has \
         it; what has gone back after a pause is a guess",
        fitted.law
    );
    let help =
        "write rows at more minutes of the warm-up, or give the settled deformation alone and --growth";
    Some(Diagnostic::warning("deform::few-rows", text).help(help))
}

/// Base or target that creep on whatever the robot does, beside what cools: one clock serves both.
fn creep(deformation: &Deformation, model: &Identified) -> Option<Diagnostic> {
    let law = deformation.warm_up_law(Some(model))?.law;
    law.tau_min()?;
    let mut largest_mm: BTreeMap<EffectKind, f64> = BTreeMap::new();
    for term in model.creeping() {
        let size_mm = largest_mm.entry(term.kind).or_default();
        *size_mm = size_mm.max(mm_from_m(shift_m(term)));
    }
    let named: Vec<String> =
        largest_mm.iter().map(|(kind, size_mm)| format!("{} ({size_mm:.3} mm)", kind.name())).collect();
    (!named.is_empty()).then(|| {
        let text = format!(
            "of the model {} creeps on while the robot stands, and the warm-up minute falls back: after a pause the program takes it back as if it had cooled, \
             in `simulate` too, and is off by as much as that",
            named.join(" and ")
        );
        let help = "take the term out of the model where the robot stops for long; or --clock elapsed, by which it creeps on and nothing cools";
        Diagnostic::warning("deform::creep-falls-back", text).help(help)
    })
}

/// How far what creeps shifts when it has come, metres.
fn shift_m(term: &Term) -> f64 {
    term.values.iter().take(3).map(|shift| shift.value * shift.value).sum::<f64>().sqrt()
}

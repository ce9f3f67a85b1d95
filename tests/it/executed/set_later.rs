//! A program that sets its tools and work objects behind the motions that use them first, in its first pass and in later ones.

use super::made::{Files, fixture, made_as, session, warmth};
use rapid_compensation::compensate::{self, FormChoice, Options};
use rapid_program::{Overrides, Program};
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::FileId;
use robot_model::deform::Deformation;
use robot_model::robot::Robot;
use robot_model::units::mm_from_m;

/// Worst distance of the corrected motions in passes at minutes 600, the first one apart, mm.
fn later_passes(form: FormChoice, original: &Files) -> f64 {
    let paper = Deformation::paper();
    let (program, _) = made_as(form, original, &paper, &warmth()).unwrap();
    let mut s = session(&program, original, &paper, false);
    s.at_minutes(&[600.0; 3]).unwrap();
    let passes = s.into_report().passes;
    passes.iter().skip(1).map(|pass| mm_from_m(pass.corrected.max_m)).fold(0.0, f64::max)
}

/// The tool of this program is another one from the second pass on, and its corrections are off then by less than the tolerance: that
/// much is among the figures. Where the controller can be asked, `auto` asks for the tool in use.
#[test]
fn what_later_passes_are_off_is_among_the_figures() {
    let original = fixture("robodk/s4c/RichProg.prg");
    let robot = Robot::built_in("irb140").unwrap();
    let reported = |form: FormChoice, original: &Files| {
        let file = SourceFile::read(FileId(0), original[0].0.clone(), original[0].1.clone());
        let program = Program::read(vec![file], &Overrides::default());
        let options = Options { form, ..Options::default() };
        let plan = compensate::plan(&program, &robot, &Deformation::paper(), &options).unwrap();
        mm_from_m(plan.summary.worst_after_m)
    };
    let [told_mm, off_mm] =
        [reported(FormChoice::Ramp, &original), later_passes(FormChoice::Ramp, &original)];
    assert!(off_mm > 0.002 && (told_mm - off_mm).abs() < 1e-4, "{told_mm} {off_mm}");
    let newer: Files = vec![("RichProg.mod".to_owned(), original[0].1.clone())];
    let [told_mm, off_mm] = [reported(FormChoice::Auto, &newer), later_passes(FormChoice::Auto, &newer)];
    assert!(off_mm < 5e-4 && told_mm < 5e-4, "{told_mm} {off_mm}");
}

#[test]
fn what_is_corrected_holds_in_every_pass() {
    let (paper, original) = (Deformation::paper(), fixture("cell/set_later.mod"));
    // In tables the motions stay whose first and later tools need other corrections than the tolerance allows.
    for (form, same, within_mm) in [
        (FormChoice::Schedule, 4, 0.0105),
        (FormChoice::Ramp, 4, 0.0055),
        (FormChoice::Live, 0, 0.0055),
        (FormChoice::Auto, 0, 0.0055),
    ] {
        let (program, kept) = made_as(form, &original, &paper, &warmth()).unwrap();
        assert_eq!(kept, same, "{form:?}");
        let mut s = session(&program, &original, &paper, false);
        s.at_minutes(&[180.0, 180.0, 300.0, 600.0]).unwrap();
        let report = s.into_report();
        assert_eq!(report.unchanged.len(), same, "{form:?}: {:?}", report.unchanged);
        for (k, pass) in report.passes.iter().enumerate() {
            assert_eq!((&pass.failure, &pass.mismatch, pass.n), (&None, &None, 9), "{form:?} {k}");
            let off_mm = mm_from_m(pass.corrected.max_m);
            assert!(off_mm < within_mm, "{form:?}, pass {k}: {off_mm} mm");
        }
    }
}

//! A program that sets its tools and work objects behind the motions that use them first, in its first pass and in later ones.

use super::made::{fixture, made_as, session, warmth};
use rapid_program::compensate::FormChoice;
use robot_model::deform::Deformation;
use robot_model::units::mm_from_m;

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

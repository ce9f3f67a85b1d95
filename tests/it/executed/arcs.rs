//! Arcs on which the tool turns.

use super::made::{fixture, made_as, session, warmth};
use rapid_program::compensate::FormChoice;
use robot_model::deform::Deformation;
use robot_model::units::{deg_from_rad, mm_from_m};

#[test]
fn a_circle_point_is_corrected_as_the_tool_is_turned_there() {
    let (paper, original) = (Deformation::paper(), fixture("cell/turning_arc.mod"));
    for (form, within_mm, within_deg) in [
        (FormChoice::Schedule, 0.0055, 0.002),
        (FormChoice::Ramp, 0.0005, 0.0001),
        (FormChoice::Live, 0.0005, 0.0001),
        (FormChoice::Auto, 0.0005, 0.0001),
    ] {
        let (program, kept) = made_as(form, &original, &paper, &warmth()).unwrap();
        assert_eq!(kept, 0, "{form:?}");
        let mut s = session(&program, &original, &paper, false);
        s.at_minutes(&[46.0, 180.0, 600.0]).unwrap();
        for pass in s.into_report().passes {
            assert_eq!((&pass.failure, &pass.mismatch, pass.n), (&None, &None, 3), "{form:?}");
            let (off_mm, off_deg) = (mm_from_m(pass.after.max_m), deg_from_rad(pass.after.max_rad));
            assert!(off_mm < within_mm && off_deg < within_deg, "{form:?}: {off_mm} mm, {off_deg} deg");
        }
    }
}

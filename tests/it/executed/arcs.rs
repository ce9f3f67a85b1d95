//! Arcs on which the tool turns.

use super::made::{Files, fixture, fixtures, made_as, session, warmth};
use rapid_compensation::compensate::FormChoice;
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

/// The arc on which the tool turns, with a way of turning in force, and another end of it.
fn arc(mode: &str, change: [&str; 2]) -> Files {
    let text = std::fs::read_to_string(fixtures().join("cell/turning_arc.mod")).unwrap();
    let text = text.replace("MoveL pFrom", &format!("CirPathMode{mode};\n    MoveL pFrom"));
    assert!(text.contains(change[0]));
    vec![("arc.mod".to_owned(), text.replace(change[0], change[1]).into_bytes())]
}

/// ABB's reference manual, CirPathMode: with `CirPointOri` the tool is turned at the circle point as that is written, and the wrist's two
/// axes turn it to nothing that is. Arcs on which it does not turn are passed alike with all but those.
#[test]
fn an_arc_that_turns_the_tool_unevenly_is_kept() {
    let paper = Deformation::paper();
    let turning = [""; 2];
    let straight = ["[0,0,0.9396926,0.3420201]", "[0,0,1,0]"];
    let late = ["MoveC pVia", "MoveC RelTool(pVia,0,0,0\\Rz:=AInput(ai1))"];
    for form in [FormChoice::Schedule, FormChoice::Ramp, FormChoice::Live, FormChoice::Auto] {
        let kept = |mode, change| made_as(form, &arc(mode, change), &paper, &warmth()).unwrap().1;
        for (mode, of_turning, of_straight) in [
            ("", 0, 0),
            ("\\PathFrame", 0, 0),
            ("\\ObjectFrame", 0, 0),
            ("\\CirPointOri", 1, 0),
            ("\\Wrist45", 1, 1),
        ] {
            assert_eq!(kept(mode, turning), of_turning, "{form:?} {mode}");
            assert_eq!(kept(mode, straight), of_straight, "{form:?} {mode}");
        }
        assert_eq!(kept("\\CirPointOri", late), 1, "{form:?}: it may turn");
    }
}

#[test]
fn a_way_of_turning_that_is_not_followed_is_named() {
    let paper = Deformation::paper();
    for (mode, named) in [
        ("\\PathFrame", vec![]),
        ("\\CirPointOri", vec!["CirPathMode\\cirpointori (arcs turn the tool evenly)"]),
    ] {
        let text = arc(mode, [""; 2]);
        let mut s = session(&text, &text, &paper, false);
        s.at_minutes(&[46.0]).unwrap();
        assert_eq!(s.into_report().unknown_instructions, named);
    }
}

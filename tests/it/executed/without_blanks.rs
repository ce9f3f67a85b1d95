//! Instructions without a blank before their target, executed: `MoveL[[...` and `MoveL(p10)` are RAPID as any, and what stands in the target's
//! place must not become a part of the instruction's name.

use super::MINUTES;
use super::made::{Files, made_as, session, warmth};
use rapid_compensation::compensate::FormChoice;
use rapid_compensation::emit::restore;
use robot_model::deform::Deformation;
use robot_model::units::mm_from_m;

const EXT: &str = "[9E9,9E9,9E9,9E9,9E9,9E9]";

/// A module with each kind of argument behind a name, a blank apart and not.
fn source() -> Files {
    let at = |x: f64, y: f64| format!("[[{x},{y},300],[0.0871557,0,0.9961947,0],[0,-1,0,0],{EXT}]");
    let text = format!(
        "MODULE Tight\n  PERS tooldata t:=[TRUE,[[0,0,120],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]];\n  \
         CONST robtarget p10:={};\n  VAR num n:=0;\n  PROC main()\n    \
         MoveAbsJ[[5,10,20,5,50,5],{EXT}],v500,fine,t;\n    MoveL{},v100,fine,t;\n    \
         MoveC{},{},v100,z1,t;\n    MoveL(p10),v100,fine,t;\n    MoveL (p10),v100,fine,t;\n    MoveJ\tp10,v100,fine,t;\n    \
         n:=n+1;\n    MoveL(Offs(p10,0,0,n)),v100,fine,t;\n    IF n>9 MoveL{},v100,fine,t;\n    n:=0;\n  ENDPROC\nENDMODULE\n",
        at(430.0, 60.0),
        at(430.0, 90.0),
        at(440.0, 105.0),
        at(430.0, 120.0),
        at(420.0, 60.0),
    );
    vec![("Tight.mod".to_owned(), text.into_bytes())]
}

#[test]
fn a_target_may_stand_right_behind_its_instruction() {
    let (paper, original) = (Deformation::paper(), source());
    for form in [FormChoice::Schedule, FormChoice::Ramp, FormChoice::Live, FormChoice::Auto] {
        let (program, kept) = made_as(form, &original, &paper, &warmth()).unwrap();
        let asks = matches!(form, FormChoice::Live | FormChoice::Auto);
        assert_eq!(kept, usize::from(!asks), "{form:?}");
        let mut s = session(&program, &original, &paper, false);
        s.at_minutes(&MINUTES).unwrap();
        let report = s.into_report();
        for pass in &report.passes {
            assert_eq!((&pass.failure, &pass.mismatch), (&None, &None), "{form:?}");
            assert!(
                mm_from_m(pass.corrected.max_m) <= 0.0055,
                "{form:?}: {}",
                mm_from_m(pass.corrected.max_m)
            );
        }
        let restored = restore(&program[0].1).unwrap();
        assert!(restored.exact && restored.bytes == original[0].1, "{form:?}");
        let made = String::from_utf8_lossy(&program[0].1).into_owned();
        let parted = match form {
            FormChoice::Schedule => "    MoveAbsJ tc6{ tcK()},v500,fine,t;\n",
            FormChoice::Live => "    MoveAbsJ tcLiveJ( [[5,10,20,5,50,5]",
            FormChoice::Ramp | FormChoice::Auto => "    MoveAbsJ tcAtJ( [[5,10,20,5,50,5]",
        };
        assert!(made.contains(parted), "{form:?}: {made}");
    }
}

/// Who formats the corrected module puts blanks where he likes: of a target that is a name none is taken from before it.
#[test]
fn a_blank_that_others_put_into_the_bracket_takes_none_away() {
    let (program, _) = made_as(FormChoice::Ramp, &source(), &Deformation::paper(), &warmth()).unwrap();
    let made = String::from_utf8_lossy(&program[0].1).into_owned();
    let formatted = made.replace("MoveJ\ttcAt(p10", "MoveJ tcAt( p10");
    assert_ne!(made, formatted);
    let restored = restore(formatted.as_bytes()).unwrap();
    let text = String::from_utf8_lossy(&restored.bytes).into_owned();
    assert!(text.contains("MoveJ p10,v100"), "{text}");
}

//! A controller's `num` has single precision: which whole number, which element and how many passes that gives is what is corrected.

use super::made::{Files, made_as, session, warmth};
use rapid_compensation::compensate::FormChoice;
use robot_model::deform::Deformation;
use robot_model::units::mm_from_m;

const DATA: &str = "MODULE Cell
  PERS tooldata tA:=[TRUE,[[0,0,120],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]];
  PERS tooldata tTab{3}:=[[TRUE,[[0,0,120],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]],
    [TRUE,[[30,0,100],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]],
    [TRUE,[[0,40,90],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]]];
  PERS wobjdata wT:=[FALSE,TRUE,\"\",[[430,0,180],[0.99619470,0,0,0.08715574]],[[10,20,5],[1,0,0,0]]];
  CONST jointtarget jHome:=[[0,10,20,0,50,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST num nWidth:=37.8;
  CONST num nPitch:=12.6;
  VAR num nSum:=0;
  VAR dnum dSum:=0;
  CONST robtarget p1:=[[0,10,60],[0,0,1,0],[0,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget p2:=[[60,40,20],[0,0,1,0],[0,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget p3:=[[20,60,50],[0,0,1,0],[0,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget pA{3}:=[p1,p2,p3];
  PROC main()
    ConfL\\Off; ConfJ\\Off;
    MoveAbsJ jHome,v500,fine,tTab{1};
";

/// The largest error of a program before and behind its correction, over what it does when settled, mm.
fn errors_mm(body: &str, form: FormChoice) -> (f64, f64) {
    let original: Files =
        vec![("Cell.mod".to_owned(), format!("{DATA}{body}\n  ENDPROC\nENDMODULE\n").into_bytes())];
    let paper = Deformation::paper();
    let made = made_as(form, &original, &paper, &warmth()).unwrap().0;
    let mut s = session(&made, &original, &paper, false);
    s.at_minutes(&[0.0, 600.0]).unwrap();
    let passes = &s.report().passes;
    (mm_from_m(passes[1].before.max_m), passes.iter().map(|p| mm_from_m(p.after.max_m)).fold(0.0, f64::max))
}

/// In single precision 37.8 / 12.6 is 2.9999998, 29.4 / 4.2 is 7, 0.6 / 0.2 is 3 and 7.4 three times 22.2; in double precision 3, 6.999...,
/// 2.999... and 22.200000000000003 (each worked out by hand with IEEE's rounding, and so in numpy).
#[test]
fn whole_numbers_elements_and_passes_are_the_controllers() {
    let bodies = [
        "MoveL Offs(p1,nPitch*Trunc(nWidth/nPitch),0,0),v100,fine,tTab{1}\\WObj:=wT;",
        "MoveL Offs(p1,0,0,4.2*(29.4 DIV 4.2)),v100,fine,tTab{1}\\WObj:=wT;",
        "MoveL pA{Trunc(0.6/0.2)},v100,fine,tTab{1}\\WObj:=wT;",
        "MoveL p1,v100,fine,tTab{Trunc(0.6/0.2)}\\WObj:=wT;",
        "wT.oframe.trans.y:=20*Trunc(nWidth/nPitch); MoveL p1,v100,fine,tTab{1}\\WObj:=wT;",
        // A value that was worked out and kept.
        "nSum:=0.3; nSum:=nSum+0.3; wT.oframe.trans.y:=20*Trunc(nSum/0.2); MoveL p1,v100,fine,tTab{1}\\WObj:=wT;",
        // dnum are held in double precision: 0.6 / 0.2 is under 3, and 3 as a num again.
        "dSum:=0.6; wT.oframe.trans.y:=20*Trunc(DnumToNum(dSum/0.2)); MoveL p1,v100,fine,tTab{1}\\WObj:=wT;",
        "dSum:=0.6; wT.oframe.trans.y:=20*DnumToNum(dSum*2 DIV 0.4); MoveL p1,v100,fine,tTab{1}\\WObj:=wT;",
    ];
    for body in bodies {
        for form in [FormChoice::Schedule, FormChoice::Ramp, FormChoice::Auto, FormChoice::Live] {
            let (before, after) = errors_mm(body, form);
            let within = if form == FormChoice::Schedule { 5.5e-3 } else { 1e-3 };
            assert!(before > 0.1 && after < within, "{form:?} {body}: {before} {after}");
        }
    }
    let passes = "FOR y FROM 0 TO 22.2 STEP 7.4 DO MoveL Offs(p1,0,y,0),v100,fine,tA\\WObj:=wT; ENDFOR";
    for form in [FormChoice::Ramp, FormChoice::Auto] {
        let (before, after) = errors_mm(passes, form);
        assert!(before > 0.1 && after < 1e-3, "{form:?}: {before} {after}");
    }
}

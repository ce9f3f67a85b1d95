//! What an operator sets on the pendant goes into frames and chooses targets, too.

use super::{compensation, messages, statuses};
use driftpost::ProgramFiles;
use rapid_compensation::compensate::FormChoice;

const PROGRAM: &str = "MODULE Cell
  PERS tooldata tGun:=[TRUE,[[0,0,120],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]];
  PERS wobjdata wC:=[FALSE,TRUE,\"\",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];
  CONST jointtarget jHome:=[[5,10,20,5,50,5],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget pA:=[[430,60,300],[0.0871557,0,0.9961947,0],[0,-1,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget pRow{2}:=[[[430,60,300],[0.0871557,0,0.9961947,0],[0,-1,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],
    [[430,90,300],[0.0871557,0,0.9961947,0],[0,-1,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]];
  PERS num nShift:=0;
  PERS num nRow:=2;
  VAR robtarget pV;
  PROC main()
    MoveAbsJ jHome,v500,fine,tGun;
    shifted;
    chosen;
  ENDPROC
  PROC shifted()
    wC.uframe.trans.y:=nShift;
    MoveJ pA,v100,fine,tGun\\WObj:=wC;
    MoveJ pA,v100,fine,tGun\\WObj:=wC;
  ENDPROC
  PROC chosen()
    pV:=pRow{nRow};
    MoveJ pV,v100,fine,tGun;
  ENDPROC
ENDMODULE
";

#[test]
fn a_pers_in_a_frame_and_one_that_chooses_a_target_are_named() {
    let files = ProgramFiles::one("Cell.mod", PROGRAM.as_bytes().to_vec());
    let of_frames = "line 18: nShift is a PERS: the work object or tool of this motion is made of it";
    let of_target =
        "line 23: nRow is a PERS: this motion is corrected where it goes by the value that the file has";
    for (form, in_schedule, in_ramp) in [
        (FormChoice::Schedule, vec![of_frames], vec![]),
        (FormChoice::Ramp, vec![], vec![of_frames, of_target]),
        (FormChoice::Auto, vec![], vec![of_frames]),
        (FormChoice::Live, vec![], vec![]),
    ] {
        let compensation = compensation().in_form(form);
        let made = compensation.run(&files).unwrap();
        for (code, expected) in [("schedule::pers-value", in_schedule), ("ramp::pers-value", in_ramp)] {
            let found = messages(&made, code);
            let as_expected =
                found.iter().zip(&expected).all(|(found, expected)| found.starts_with(expected));
            assert!(found.len() == expected.len() && as_expected, "{form:?}, {code}: {found:?}");
            let both = found.iter().find(|found| found.contains("nShift"));
            assert!(
                both.is_none_or(|both| both.ends_with("(1 more like this in the same routine)")),
                "{found:?}"
            );
        }
        assert!(
            form == FormChoice::Schedule
                || statuses(&made).iter().all(|(_, status)| *status == "compensated")
        );
    }
}

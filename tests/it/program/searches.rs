//! Which motions can go to what a search has found, by the ways that lead to them.

use super::{at, main_of, module};
use rapid_program::Program;

/// The lines (from 1) of the motions whose target can be what a search has found.
fn from_search(program: &Program) -> Vec<u32> {
    program.motions.iter().filter(|motion| motion.from_search).map(|motion| motion.line).collect()
}

/// `data` stands from line 2 on.
fn data() -> String {
    format!("CONST robtarget p10:={};\nVAR robtarget hit;\nVAR robtarget other;", at(10, 0, 0))
}

#[test]
fn a_point_that_is_set_anew_is_no_longer_what_a_search_has_found() {
    let program = main_of(
        &data(),
        "SearchL di1,hit,p10,v100,tool0;
MoveL hit,v100,fine,tool0;
MoveL Offs(hit,0,0,10),v100,fine,tool0;
other:=hit;
hit:=p10;
MoveL hit,v100,fine,tool0;
MoveL other,v100,fine,tool0;
other.trans.z:=50;
MoveL other,v100,fine,tool0;
other:=Offs(hit,0,0,5);
MoveL other,v100,fine,tool0;",
    );
    assert_eq!(from_search(&program), [7, 8, 12, 14]);
}

#[test]
fn one_way_that_leads_from_a_search_is_enough() {
    let program = main_of(
        &data(),
        "MoveL hit,v100,fine,tool0;
hit:=p10;
MoveL hit,v100,fine,tool0;
IF DInput(di1)=1 THEN
SearchL di1,hit,p10,v100,tool0;
ENDIF
MoveL hit,v100,fine,tool0;
WHILE DInput(di2)=0 DO
MoveL other,v100,fine,tool0;
hit:=p10;
SearchL di1,other,p10,v100,tool0;
ENDWHILE
MoveL hit,v100,fine,tool0;
other:=p10;
MoveC hit,other,v100,fine,tool0;
hit:=p10;
MoveC hit,other,v100,fine,tool0;",
    );
    // The first goes to what the cycle before has left.
    assert_eq!(from_search(&program), [6, 12, 14, 18, 20]);
}

#[test]
fn a_found_point_is_followed_into_the_routines_that_are_handed_it() {
    let program = module(&format!(
        "{}
PROC main()
SearchL di1,hit,p10,v100,tool0;
go hit;
stay p10;
MoveL above(hit),v100,fine,tool0;
hit:=p10;
stay hit;
MoveL above(hit),v100,fine,tool0;
MoveL last(),v100,fine,tool0;
ENDPROC
PROC go(robtarget p)
MoveL p,v100,fine,tool0;
ENDPROC
PROC stay(robtarget p)
MoveL p,v100,fine,tool0;
ENDPROC
FUNC robtarget above(robtarget p)
VAR robtarget q;
q:=Offs(p,0,0,10);
RETURN q;
ENDFUNC
FUNC robtarget last()
RETURN Offs(other,0,0,10);
ENDFUNC
PROC again()
SearchL di1,other,p10,v100,tool0;
ENDPROC",
        data()
    ));
    assert_eq!(from_search(&program), [9, 13, 16]);
}

#[test]
fn a_routine_of_the_users_own_that_is_named_like_a_search_is_none() {
    let text = "PROC SearchPart(num n,robtarget p)\nMoveL p,v100,fine,tool0;\nENDPROC";
    let program = module(&format!("{}\nPROC main()\nSearchPart 1,p10;\nENDPROC\n{text}", data()));
    assert!(from_search(&program).is_empty());
}

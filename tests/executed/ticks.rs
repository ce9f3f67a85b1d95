//! Where the clock is asked, executed: a tick that belongs to a move in a compact IF stands before the IF.

use crate::made::{Files, compensated, session};
use driftpost::deform::Deformation;
use driftpost::emit::Clock;
use driftpost::simulate::Scenario;

const PROGRAM: &str = "MODULE Cell
  PERS tooldata tGun:=[TRUE,[[0,0,120],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]];
  PERS num nParts:=0;
  PROC main()
    ConfL\\Off;
    MoveAbsJ [[0,10,20,0,50,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v500,fine,tGun;
    WaitTime 2400;
    IF nParts>5 MoveL [[410,40,250],[0,0,1,0],[0,-1,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tGun;
    WaitTime 2400;
    IF nParts=0 MoveL [[430,40,250],[0,0,1,0],[0,-1,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tGun;
    IF nParts=0 IF nParts<1 MoveL [[440,40,250],[0,0,1,0],[0,-1,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tGun;
  ENDPROC
ENDMODULE
";

#[test]
fn a_tick_before_a_compact_if_runs_whether_the_move_does_or_not() {
    let original: Files = vec![("cell.mod".into(), PROGRAM.into())];
    let paper = Deformation::paper();
    let program = compensated(&original, &paper, &Clock::Elapsed).unwrap();
    let text = String::from_utf8(program[0].1.clone()).unwrap();
    assert!(text.contains("    tcTick;\n    IF nParts>5 MoveL tc"), "{text}");
    assert!(text.contains("    tcTick;\n    IF nParts=0 MoveL tc"), "{text}");
    let mut s = session(&program, &original, &paper, false);
    // Eighty minutes pass inside of the program: without its tick the last moves would be as at minute 0,
    // 0.1 mm off.
    Scenario::from_toml("warming = \"running\"\nsteps = [\"call tcColdStart\", \"pass\"]")
        .unwrap()
        .play(&mut s)
        .unwrap();
    let report = s.into_report();
    assert!(report.is_within(5.5e-6), "{:?}", report.worst);
    let pass = &report.passes[0];
    assert_eq!((pass.n, pass.program_min.unwrap().round()), (3, 80.0));
    assert!(pass.before.max_m > 5e-5, "{:?}", pass.before);
}

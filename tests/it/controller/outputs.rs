//! What happens while the arm moves or the program waits: outputs of moves, and timers.

use super::{controller, ran};

/// `MoveLDO` and its kin set their signal at the target, and the program's next statements see it.
#[test]
fn moves_with_an_output_set_it() {
    let mut c = controller(
        r"  PERS num seen{5}:=[9,9,9,9,9];
  VAR dnum code:=6;
  PROC main()
    MoveAbsJ jHome,v500,fine,tool0;
    seen{1}:=DOutput(doGrip);
    MoveJDO p{1},v500,fine,tool0,doGrip,1;
    seen{2}:=DOutput(doGrip);
    MoveLGO p{2},v500,fine,tool0,goPart\Value:=7;
    seen{3}:=GOutput(goPart);
    MoveLGO p{3},v500,fine,tool0\WObj:=wobj0,goPart\DValue:=code;
    seen{4}:=GOutput(goPart);
    MoveCAO p{2},p{1},v500,fine,tool0,aoGlue,2.5;
    seen{5}:=AOutput(aoGlue);
  ENDPROC",
    );
    ran(&mut c, "main");
    let seen: Vec<Option<f64>> = c.value("seen").unwrap().parts().iter().map(|v| v.number()).collect();
    assert_eq!(seen, [0.0, 1.0, 7.0, 6.0, 2.5].map(Some));
    assert_eq!(c.unknown_instructions(), [""; 0]);
    assert_eq!(c.arm_mut().unwrap().take_moves().len(), 5);
}

/// A timer of 0.4 s is due four times in 1.9 s, one of 1.5 s six times in a move of ten; what they count is known at the next
/// statement. What a trap takes is part of the wait that it interrupts, which ends when the last one that it let begin has ended.
#[test]
fn a_timer_is_served_as_often_as_it_was_due_in_a_wait_or_a_move() {
    let mut c = controller(
        r"  VAR intnum timer;
  VAR clock watch;
  PERS num ticks:=0;
  PERS num seen{3}:=[0,0,0];
  PERS num seconds:=0;
  TRAP tick
    ticks:=ticks+1;
  ENDTRAP
  TRAP slow
    ticks:=ticks+1;
    WaitTime 3;
  ENDTRAP
  PROC main()
    MoveAbsJ jHome,v500,fine,tool0;
    CONNECT timer WITH tick;
    ITimer 0.4,timer;
    WaitTime 1.9;
    seen{1}:=ticks;
    IDelete timer;
    ticks:=0;
    CONNECT timer WITH tick;
    ITimer 1.5,timer;
    MoveL p{1},v500\T:=10,fine,tool0;
    seen{2}:=ticks;
    IDelete timer;
    ticks:=0;
    CONNECT timer WITH slow;
    ITimer 4,timer;
    ClkStart watch;
    WaitTime 9.5;
    ClkStop watch;
    seen{3}:=ticks;
    seconds:=ClkRead(watch);
  ENDPROC",
    );
    ran(&mut c, "main");
    let seen: Vec<Option<f64>> = c.value("seen").unwrap().parts().iter().map(|v| v.number()).collect();
    // The slow one begins at 4 and at 8 s and ends at 11.
    assert_eq!(seen, [4.0, 6.0, 2.0].map(Some));
    assert!((c.number("seconds").unwrap() - 11.0).abs() < 1e-3, "{}", c.number("seconds").unwrap());
}

//! Functions in arguments of motions: what they take, counted by hand, and what interrupts them.

use super::{controller, ran};
use virtual_controller::{Effort, EffortRange};

const COUNTED: &str = r"
  VAR num n:=0;
  VAR pose frame:=[[0,0,0],[1,0,0,0]];
  PROC bump(num by)
    FOR i FROM 1 TO by DO       ! looked at by + 1 times
      n:=n*Cos(0);              ! one statement, one operation, one cosine
    ENDFOR
  ENDPROC
  FUNC num tcK()
    VAR num half:=1/2;          ! no statement, one operation
    n:=n+1;                     ! 1, 1
    IF n>1 THEN                 ! 1
      bump 2;                   ! 1, and 3 looks, 2 statements with 2 operations and 2 cosines
    ELSEIF n<-5 THEN            ! 1, with a sign
      n:=0;
    ENDIF
    RETURN 1;                   ! 1
  ENDFUNC
  FUNC robtarget tcAt(robtarget t,num up)
    TEST up                     ! 1
    CASE 1,2:
      frame:=PoseMult(frame,frame);                        ! 1, 1
    DEFAULT:
      t.trans.z:=t.trans.z+(p{1}.trans.y+40)*Abs(up)/2;    ! 1, and 5: a sign in data costs nothing
      GOTO out;                                            ! 1
    ENDTEST
  out:
    RETURN t;                   ! 1
  ENDFUNC
  PROC main()
    MoveAbsJ jHome,v500,fine,tool0;
    MoveL p{tcK()},v500,fine,tool0;
    MoveL tcAt(p{1+tcK()},0-1),v500,fine,tool0;
    MoveL tcAt(p{2},1),v500,fine,tool0;
    n:=tcK();
  ENDPROC";

#[test]
fn what_functions_in_arguments_take_is_as_counted_by_hand() {
    let mut c = controller(COUNTED);
    ran(&mut c, "main");
    let effort = |statements, arithmetic, trigonometric| Effort { statements, arithmetic, trigonometric };
    let efforts = c.take_efforts();
    // In order: without and with the call of bump; the last call of tcK belongs to no motion.
    let tc_k = EffortRange { calls: 2, fewest: effort(4, 3, 0), most: effort(9, 4, 2) };
    let tc_at = EffortRange { calls: 2, fewest: effort(3, 1, 0), most: effort(4, 5, 0) };
    assert_eq!(efforts.into_iter().collect::<Vec<_>>(), [("tcAt".into(), tc_at), ("tcK".into(), tc_k)]);
    assert!(c.take_efforts().is_empty());
    // Called from outside.
    ran(&mut c, "tck");
    assert_eq!(c.take_efforts()["tcK"].most, effort(9, 4, 2));
}

const INTERRUPTED: &str = r"
  VAR intnum timer;
  VAR num inside:=0;
  PERS num seen:=0;
  PERS num other:=0;
  TRAP tick
    IF inside=1 seen:=seen+1;
    IF inside=0 other:=other+1;
    StopMove;
    StorePath;
    MoveL p{answer()},v500,fine,tool0;
    RestoPath;
    StartMove;
  ENDTRAP
  FUNC num answer()
    RETURN 2;
  ENDFUNC
  FUNC num tcK()
    inside:=1;
    FOR i FROM 1 TO 20 DO
      inside:=i/i;
    ENDFOR
    inside:=0;
    RETURN 1;
  ENDFUNC
  PROC main()
    CONNECT timer WITH tick;
    MoveAbsJ jHome,v500,fine,tool0;
    ITimer 0.25,timer;
    MoveL p{tcK()},v500,fine,tool0;
    IDelete timer;
  ENDPROC";

#[test]
fn a_timer_interrupts_a_function_in_a_motions_argument() {
    let mut c = controller(INTERRUPTED);
    c.calendar_mut().step_s = 0.02;
    ran(&mut c, "main");
    // 44 statements and 21 jumps of 0.02 s: more than a second inside of tcK; a trap takes as long as the timer
    // or longer, so that it may be due again at the next statement.
    assert!((3.0..=65.0).contains(&c.number("seen").unwrap()), "{}", c.number("seen").unwrap());
    assert_eq!(c.unknown_instructions(), [""; 0]);
    let moves = c.arm_mut().unwrap().take_moves();
    let routines: Vec<&str> = moves.iter().map(|m| m.routine.as_str()).collect();
    // Its traps move the arm before the motion that asked for tcK does.
    let last_of_main = routines.iter().rposition(|r| *r == "main").unwrap();
    assert_eq!((routines[0], routines[1]), ("main", "tick"));
    assert!(last_of_main > 3, "{routines:?}");
    // What the trap does is no part of what it interrupts.
    let efforts = c.take_efforts();
    assert_eq!(efforts["tcK"].most, Effort { statements: 44, arithmetic: 20, trigonometric: 0 });
    assert_eq!(efforts["answer"].most.statements, 1);
}

const COUNTING_TOOL: &str = r"
  PERS tooldata tTab{2}:=[[TRUE,[[0,0,120],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]],
    [TRUE,[[0,0,150],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]]];
  PERS num calls:=0;
  FUNC num next()
    calls:=calls+1;
    RETURN 1;
  ENDFUNC
  PROC main()
    MoveAbsJ jHome,v500,fine,tool0;
    MoveJ p{next()},v500,fine,tTab{next()};
  ENDPROC";

#[test]
fn each_argument_of_a_motion_is_worked_out_once() {
    let mut c = controller(COUNTING_TOOL);
    ran(&mut c, "main");
    assert_eq!(c.number("calls").unwrap(), 2.0);
}

//! Stopping in the middle and stepping back, as on a pendant.

use super::controller;
use virtual_controller::{BackStep, Controller, Outcome};

const GRIP: &str = r"
  VAR num bucket:=1;
  PERS num asked:=0;
  FUNC num tcK()
    asked:=asked+1;
    RETURN bucket;
  ENDFUNC
  PROC grip()
    Set doGrip;
    WaitTime 0.5;
  BACKWARD
    Reset doGrip;
  ENDPROC
  PROC count()
    asked:=asked+100;
  ENDPROC
  PROC main()
    MoveAbsJ jHome,v500,fine,tool0;
    MoveL p{tcK()},v100,fine,tool0;
    grip;
    MoveL p{2},v100,fine,tool0;
    SetDO doLamp,1;
    MoveJ p{3},v100,fine,tool0;
    count;
    IF asked>0 MoveL p{1},v100,fine,tool0;
    MoveAbsJ jHome,v500,fine,tool0;
  ENDPROC";

fn joints(c: &Controller) -> [f64; 6] {
    c.arm().unwrap().q_rad().unwrap()
}

fn close(a: [f64; 6], b: [f64; 6]) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9)
}

#[test]
fn a_step_back_over_a_move_asks_for_the_target_before_it_anew() {
    let mut c = controller(GRIP);
    let mut at = Vec::new();
    for moves in 1..=4 {
        assert_eq!(c.call_until("main", moves).unwrap(), Outcome::Stopped);
        at.push(joints(&c));
    }
    assert_eq!((c.signal("dogrip"), c.number("asked").unwrap()), (Some(1.0), 3.0));
    // Back over MoveJ, SetDO (which stays done), MoveL, and grip by its BACKWARD section.
    assert_eq!(c.step_back(), BackStep::Moved);
    assert!(close(joints(&c), at[2]));
    assert_eq!((c.step_back(), c.signal("dolamp")), (BackStep::Passed, Some(1.0)));
    assert_eq!(c.step_back(), BackStep::Moved);
    assert!(close(joints(&c), at[1]));
    assert_eq!(c.number("asked").unwrap(), 4.0);
    assert_eq!((c.step_back(), c.signal("dogrip")), (BackStep::Passed, Some(0.0)));
    assert_eq!(c.step_back(), BackStep::Moved);
    assert!(close(joints(&c), at[0]));
    assert_eq!(c.step_back(), BackStep::Refused("no move of this routine stands before it".into()));
    // Forward again from where it stands: the last stop once more, by the same targets.
    assert_eq!(c.resume(Some(3)), Outcome::Stopped);
    assert!(close(joints(&c), at[3]));
    assert_eq!(c.signal("dogrip"), Some(1.0));
    assert_eq!(c.resume(None), Outcome::Finished);
    assert_eq!(c.step_back(), BackStep::Refused("no program is stopped".into()));
}

#[test]
fn a_bucket_that_changed_meanwhile_is_the_one_gone_back_to() {
    let mut c = controller(GRIP);
    c.call_until("main", 3).unwrap();
    c.set("bucket", virtual_controller::Value::Num(3.0)).unwrap();
    assert_eq!(c.step_back(), BackStep::Moved);
    let back = joints(&c);
    c.call_until("main", 4).unwrap();
    // p{3} straight from p{2}, and by a joint move: one place, one branch.
    assert!(close(joints(&c), back));
}

#[test]
fn what_cannot_be_gone_through_backwards_stops_it() {
    let mut c = controller(GRIP);
    c.call_until("main", 6).unwrap();
    let here = joints(&c);
    let refused = |step: BackStep, why: &str| {
        assert!(matches!(&step, BackStep::Refused(text) if text.contains(why)), "{step:?}");
    };
    refused(c.step_back(), "depends on an IF");
    c.call_until("main", 5).unwrap();
    refused(c.step_back(), "IF, FOR, WHILE");
    assert!(!close(joints(&c), here));
    let plain = GRIP.replace("IF asked>0 ", "");
    let mut c = controller(&plain);
    c.call_until("main", 5).unwrap();
    // No motion in count: the move behind it goes back; count itself has no BACKWARD section.
    assert_eq!(c.step_back(), BackStep::Moved);
    refused(c.step_back(), "count has no BACKWARD section");
    assert_eq!(c.resume(None), Outcome::Finished);
}

//! Data that outlive the program pointer, and stop watches.

use super::{controller, ran};

#[test]
fn task_persistents_are_persistents() {
    let mut c = controller(
        "TASK PERS num kept:=1;\nTASK VAR num fresh:=1;\nPROC twice(PERS num x)\nx:=2*x;\nENDPROC\n\
         PROC main()\ntwice kept;\nfresh:=fresh+1;\nENDPROC",
    );
    c.load("other.mod", b"MODULE Other\nPROC more()\nkept:=kept+1;\nENDPROC\nENDMODULE").unwrap();
    ran(&mut c, "main");
    ran(&mut c, "more");
    let backup = c.backup();
    c.pp_to_main();
    assert_eq!((c.number("kept").unwrap(), c.number("fresh").unwrap()), (3.0, 1.0));
    ran(&mut c, "main");
    c.restore(&backup);
    assert_eq!(c.number("kept").unwrap(), 3.0);
    let twice = b"MODULE Third\nTASK PERS num kept:=5;\nENDMODULE";
    assert!(c.load("third.mod", twice).is_err(), "one task has it once");
}

#[test]
fn a_clock_runs_on_while_the_power_is_off_and_starts_again_with_the_pointer() {
    let mut c = controller(
        "VAR clock watch;\nPERS num seconds:=0;\nPROC begin()\nClkStart watch;\nENDPROC\n\
         PROC look()\nseconds:=ClkRead(watch\\HighRes);\nENDPROC\n\
         PROC restart()\nClkStop watch;\nClkReset watch;\nClkStart watch;\nENDPROC",
    );
    let seconds = |c: &mut virtual_controller::Controller| {
        ran(c, "look");
        c.number("seconds").unwrap()
    };
    ran(&mut c, "begin");
    // Power off for half an hour, the program pointer stays: nothing but time has passed.
    c.calendar_mut().advance_min(30.0);
    assert_eq!(seconds(&mut c), 1800.0);
    ran(&mut c, "restart");
    c.calendar_mut().advance_min(1.0);
    // Date and time may be set: a clock does not notice.
    c.calendar_mut().shift_min(-600.0);
    assert_eq!(seconds(&mut c), 60.0);
    c.pp_to_main();
    c.calendar_mut().advance_min(1.0);
    assert_eq!(seconds(&mut c), 0.0);
}

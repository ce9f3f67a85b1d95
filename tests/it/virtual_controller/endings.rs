//! How programs end that would not: steps, calls and moves without end, loops that wait in vain, passes of the outermost loop.

use super::controller;
use virtual_controller::{Controller, Outcome, StepLimit};
#[test]
fn hostile_programs_come_to_an_end() {
    let mut c = controller(
        "MODULE M\nVAR num n;\nCONST num a:=b;\nCONST num b:=a;\n\
         PROC forever()\nWHILE TRUE DO\nn:=n+1;\nENDWHILE\nENDPROC\n\
         PROC spin()\nWHILE n=n DO\nn:=n+1;\nENDWHILE\nENDPROC\n\
         PROC deeper()\ndeeper;\nENDPROC\n\
         FUNC num deep(num x)\nRETURN deep(x)+1;\nENDFUNC\n\
         PROC calls()\nn:=deep(1);\nENDPROC\n\
         PROC circle()\nn:=a;\nENDPROC\n\
         PROC outside()\nVAR num v{3};\nn:=v{4};\nENDPROC\n\
         PROC typed()\nn:=\"text\";\nENDPROC\nENDMODULE",
    );
    c.step_limit = StepLimit::new(100_000);
    assert_eq!(c.call("forever", 7).unwrap(), Outcome::Passes);
    assert_eq!(c.number("n").unwrap(), 7.0);
    assert!(matches!(c.call("spin", 1).unwrap(), Outcome::OutOfSteps { moving: true, .. }));
    for name in ["deeper", "calls", "circle", "outside", "typed"] {
        assert!(matches!(c.call(name, 1).unwrap(), Outcome::Failed { .. }), "{name}");
    }
    assert!(c.call("nowhere", 1).is_err());
}

/// Moves are kept until they are asked for: a loop that never ends must not fill the memory with them.
#[test]
fn a_loop_of_moves_that_never_ends_is_cut_off_early() {
    let robot = robot_model::robot::Robot::built_in("irb140").unwrap();
    let mut c = Controller::with_robot(&robot).unwrap();
    let text = "MODULE M\nVAR num n;\nPROC main()\nWHILE n>=0 DO\nn:=n+1;\n\
                MoveAbsJ [[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0;\nENDWHILE\nENDPROC\nENDMODULE";
    c.load("m.mod", text.as_bytes()).unwrap();
    c.step_limit = StepLimit::new(100_000);
    assert!(matches!(c.call("main", 1).unwrap(), Outcome::OutOfSteps { moving: true, .. }));
    let moves = c.arm_mut().unwrap().take_moves().len();
    assert!((1_000..3_000).contains(&moves), "{moves}");
}

/// How a program ends that calls `main`; `body` stands in it behind two numbers, a flag and a clock.
fn end_of(body: &str) -> Outcome {
    let mut c = Controller::new();
    let text = format!(
        "MODULE M\nVAR num n;\nVAR num m;\nVAR bool done;\nVAR clock k;\nPROC count()\nm:=m+1;\nIF m=5000 done:=TRUE;\n\
         ENDPROC\nPROC main()\n{body}\nENDPROC\nENDMODULE"
    );
    c.load("m.mod", text.as_bytes()).unwrap();
    c.call("main", 1).unwrap()
}

#[test]
fn a_loop_that_waits_in_vain_is_named_and_one_that_works_is_not() {
    let start = std::time::Instant::now();
    for (body, line, names) in [
        ("WHILE DInput(diStart)=0 DO\nWaitTime 0.1;\nENDWHILE", 11, "diStart"),
        ("n:=1;\nWHILE NOT done DO\nm:=m+1;\nENDWHILE", 12, "done"),
        ("again:\nIF diGo=0 GOTO again;", 12, "diGo"),
        ("WHILE TRUE DO\nWHILE TRUE DO\nIF diGo=1 n:=2;\nENDWHILE\nENDWHILE", 12, "diGo"),
        ("WHILE ClkRead(k)<5 DO\nENDWHILE", 11, "k"),
    ] {
        let Outcome::Endless { at, names: found } = end_of(body) else { panic!("{body}") };
        assert_eq!((at.line, found.join(",").as_str()), (line, names), "{body}");
    }
    assert!(start.elapsed().as_secs() < 2);
    for body in [
        "WHILE n<20000 DO\nn:=n+1;\nENDWHILE",
        "WHILE NOT done DO\ncount;\nENDWHILE",
        "ClkStart k;\nWHILE ClkRead(k)<5 DO\nWaitTime 0.01;\nENDWHILE",
        "again:\nn:=n+1;\nIF n<300 GOTO again;",
        "WHILE TRUE DO\nn:=n+1;\nIF n>400 RETURN;\nENDWHILE",
    ] {
        assert!(matches!(end_of(body), Outcome::Finished | Outcome::Passes), "{body}");
    }
}

/// What a condition asks for changes in every pass, and no motion comes: the line is named before anybody grows impatient.
#[test]
fn a_program_that_only_counts_is_ended_where_it_is() {
    for (body, lines) in [
        ("WHILE n<2 DO\nm:=m+1;\nn:=1/m;\nENDWHILE", 11..=13),
        ("again:\nn:=n+1;\nIF n>0 GOTO again;", 12..=13),
    ] {
        let outcome = end_of(body);
        let Outcome::OutOfSteps { at, moving: false } = &outcome else { panic!("{body}: {outcome:?}") };
        assert!(lines.contains(&at.line), "{body}: {at:?}");
    }
}

#[test]
fn passes_are_counted_of_the_outermost_loop() {
    let mut c = controller(
        "MODULE M\nPERS num outer:=0;\nPERS num inner:=0;\nPROC wait_for()\nVAR num n:=0;\nWHILE TRUE DO\nn:=n+1;\n\
         inner:=inner+1;\nIF n=5 RETURN;\nENDWHILE\nENDPROC\n\
         PROC main()\nWHILE TRUE DO\nouter:=outer+1;\nwait_for;\nENDWHILE\nENDPROC\nENDMODULE",
    );
    assert_eq!(c.call("main", 3).unwrap(), Outcome::Passes);
    assert_eq!((c.number("outer").unwrap(), c.number("inner").unwrap()), (3.0, 15.0));
}

#[test]
fn a_loop_that_is_left_from_inside_goes_on_behind_it() {
    for (body, n) in [
        ("WHILE TRUE DO\nn:=n+1;\nIF n>5 GOTO out;\nENDWHILE\nout:\nn:=n+100;", 106.0),
        (
            "WHILE (TRUE) DO\nn:=n+1;\nIF n>5 THEN\nFOR i FROM 1 TO 3 DO\nIF i=2 GOTO out;\nENDFOR\nENDIF\nENDWHILE\nout:\nn:=n+100;",
            106.0,
        ),
        (
            "again:\nn:=n+1;\nTEST n\nCASE 5:\nGOTO out;\nDEFAULT:\nm:=m+1;\nENDTEST\nGOTO again;\nout:\nn:=n+100;",
            105.0,
        ),
        ("WHILE TRUE DO\nn:=n+1;\nIF n>5 RETURN;\nENDWHILE\nn:=0;", 6.0),
        ("WHILE TRUE DO\nn:=n+1;\nIF n>5 EXIT;\nENDWHILE\nn:=0;", 6.0),
        (
            "WHILE TRUE DO\nn:=n+1;\nIF n>5 RAISE ERR_ARGVALERR;\nENDWHILE\nn:=0;\nERROR\nn:=n+100;\nRETURN;",
            106.0,
        ),
        // A GOTO within the loop leaves nothing, and what stays as it is ends nothing.
        ("WHILE TRUE DO\nn:=n+1;\nIF n>5 GOTO more;\nmore:\nENDWHILE\nn:=0;", 1.0),
        ("WHILE TRUE DO\nn:=n+1;\nIF diStop=1 OR m>5 RETURN;\nENDWHILE\nn:=0;", 1.0),
        ("n:=7;\nagain:\nn:=n+1;\nIF diStop=1 GOTO out;\nGOTO again;\nout:\nn:=0;", 8.0),
        // Entered anew from a loop round it.
        (
            "FOR i FROM 1 TO 3 DO\nm:=0;\nWHILE TRUE DO\nm:=m+1;\nn:=n+1;\nIF m>2 GOTO next;\nENDWHILE\nnext:\nENDFOR",
            9.0,
        ),
    ] {
        let text =
            format!("MODULE M\nPERS num n:=0;\nPERS num m:=0;\nPROC main()\n{body}\nENDPROC\nENDMODULE");
        let mut c = controller(&text);
        c.call("main", 1).unwrap();
        assert_eq!(c.number("n").unwrap(), n, "{body}");
    }
}

#[test]
fn a_loop_that_a_called_routine_leaves_goes_on_until_it_does() {
    for (body, step, n) in [
        ("WHILE TRUE DO\nonce;\nENDWHILE\nn:=0;", "n:=n+1;\nIF n>5 EXIT;", 6.0),
        // Two calls deep, and the way there decides as well.
        ("WHILE TRUE DO\nn:=n+1;\nIF n>5 deeper;\nENDWHILE\nn:=0;", "EXIT;", 6.0),
        // The loop's routine handles what the called one raises.
        (
            "WHILE TRUE DO\nonce;\nENDWHILE\nn:=0;\nERROR\nn:=n+100;\nRETURN;",
            "n:=n+1;\nIF n>5 RAISE ERR_ARGVALERR;",
            106.0,
        ),
        // What decides is handed over.
        ("VAR num k:=0;\nWHILE TRUE DO\nk:=k+1;\nn:=k;\ncheck k;\nENDWHILE\nn:=0;", "EXIT;", 6.0),
        ("again:\nonce;\nGOTO again;", "n:=n+1;\nIF n>5 EXIT;", 6.0),
        // What stays as it is ends nothing, and a RETURN leaves the called routine alone.
        ("WHILE TRUE DO\nonce;\nENDWHILE\nn:=0;", "n:=n+1;\nIF diStop=1 OR m>5 EXIT;", 1.0),
        ("WHILE TRUE DO\nonce;\nENDWHILE\nn:=0;", "n:=n+1;\nIF n>5 RETURN;", 1.0),
        // Routines that call each other.
        ("WHILE TRUE DO\ncircle;\nENDWHILE\nn:=0;", "n:=n+1;\nIF n>5 EXIT;\nIF m>0 circle;", 6.0),
    ] {
        let text = format!(
            "MODULE M\nPERS num n:=0;\nPERS num m:=0;\nPROC main()\n{body}\nENDPROC\nPROC once()\n{step}\nENDPROC\n\
             PROC deeper()\nonce;\nENDPROC\nPROC circle()\nonce;\nENDPROC\nPROC check(num k)\nIF k>5 once;\nENDPROC\nENDMODULE"
        );
        let mut c = controller(&text);
        c.call("main", 1).unwrap();
        assert_eq!(c.number("n").unwrap(), n, "{body} {step}");
    }
}

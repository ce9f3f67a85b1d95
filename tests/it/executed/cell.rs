//! What a real cell does with a program whose motions ask: polling for hours, lunch, night, traps, stepping backwards.

use super::made::{Files, made_as, session, warmth};
use rapid_compensation::compensate::FormChoice;
use robot_model::deform::Deformation;
use robot_model::robot::Robot;
use robot_model::units::mm_from_m;
use virtual_controller::{BackStep, Controller, Report, Scenario};

const FORMS: [FormChoice; 4] = [FormChoice::Schedule, FormChoice::Ramp, FormChoice::Live, FormChoice::Auto];

/// A cell that polls for parts, with a grip and a trap that takes the tool away for service.
const CELL: &str = "MODULE Cell
  PERS tooldata tGrip:=[TRUE,[[0,0,120],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]];
  CONST jointtarget jHome:=[[0,10,20,0,50,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget pAbove:=[[450,40,260],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget pPart:=[[450,40,220],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget pService:=[[400,120,300],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  VAR robtarget pBack;
  VAR intnum iService;
  VAR num nServed:=0;

  PROC main()
    WHILE TRUE DO
      IF DInput(diPart)=1 THEN
        rPart;
      ELSE
        WaitTime 2;
      ENDIF
    ENDWHILE
  ENDPROC

  PROC rPart()
    MoveAbsJ jHome,v500,fine,tGrip;
    MoveJ pAbove,v300,fine,tGrip;
    MoveL pPart,v50,fine,tGrip;
    SetDO doGrip,1;
    WaitTime 0.5;
    MoveL pAbove,v50,fine,tGrip;
    MoveL pService,v100,fine,tGrip;
  ENDPROC

  PROC rServed()
    CONNECT iService WITH tService;
    ITimer \\Single,3,iService;
    rPart;
    rPart;
    IDelete iService;
  ENDPROC

  TRAP tService
    nServed:=nServed+1;
    StopMove;
    StorePath;
    pBack:=CRobT(\\Tool:=tGrip);
    MoveL pService,v100,fine,tGrip;
    MoveL pBack,v100,fine,tGrip;
    RestoPath;
    StartMove;
  ENDTRAP
ENDMODULE
";

fn cell() -> Files {
    vec![("Cell.mod".to_owned(), CELL.as_bytes().to_vec())]
}

fn made(form: FormChoice) -> (Files, Files) {
    let original = cell();
    (made_as(form, &original, &Deformation::paper(), &warmth()).unwrap().0, original)
}

/// What a form leaves, mm: a bucket's tolerance, or single precision's; and what the drift grows by while a motion lasts.
fn within_mm(form: FormChoice) -> f64 {
    if form == FormChoice::Schedule { 6.4e-3 } else { 1.4e-3 }
}

fn played(files: &(Files, Files), entry: Option<&str>, steps: &[&str]) -> Report {
    let mut s = session(&files.0, &files.1, &Deformation::paper(), false);
    if let Some(entry) = entry {
        s = super::made::session_at(&files.0, &files.1, &Deformation::paper(), entry);
    }
    let steps = steps.iter().map(|s| (*s).to_owned()).collect();
    Scenario { steps, ..Scenario::default() }.play(&mut s).unwrap();
    s.into_report()
}

#[test]
fn a_grip_is_stepped_through_backwards_as_in_the_original() {
    for form in FORMS {
        let (program, original) = made(form);
        let stepped = |files: &Files| {
            let mut c = Controller::with_robot(&Robot::built_in("irb140").unwrap()).unwrap();
            for (path, bytes) in files {
                c.load(path, bytes).unwrap();
            }
            if c.has_routine("tcWarmStart") {
                c.call("tcWarmStart", 1).unwrap();
            }
            c.call_until("rPart", 4).unwrap();
            let steps: Vec<&str> = (0..7)
                .map(|_| match c.step_back() {
                    BackStep::Moved => "moved",
                    BackStep::Passed => "passed",
                    BackStep::Refused(_) => "refused",
                })
                .collect();
            (steps, c.arm().unwrap().q_rad().unwrap())
        };
        let (of_original, stood) = stepped(&original);
        let (of_program, stands) = stepped(&program);
        assert_eq!(of_program, of_original, "{form:?}");
        assert!(of_original.iter().filter(|step| **step == "moved").count() >= 3, "{of_original:?}");
        // Back where the routine began, at joints that are corrected by less than 0.05 deg.
        for (a, b) in stood.iter().zip(stands) {
            assert!((a - b).abs() < 9e-4, "{form:?}: {stood:?} {stands:?}");
        }
    }
}

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
mod long {
    use super::*;

    #[test]
    #[ignore = "long"]
    fn eight_hours_of_polling_are_no_work() {
        let steps = [
            "signal diPart 1",
            "call tcColdStart",
            "run 180",
            "signal diPart 0",
            "run 480",
            "signal diPart 1",
            "run 60",
        ];
        for form in FORMS {
            let report = played(&made(form), None, &steps);
            for p in &report.passes {
                assert_eq!((&p.failure, &p.mismatch, p.unreached), (&None, &None, 0), "{form:?}");
                assert!(
                    mm_from_m(p.after.max_m) <= within_mm(form),
                    "{form:?} at {}: {:?}",
                    p.at_min,
                    p.after
                );
            }
            // After the night the arm has cooled: x1 and x2 of 180 minutes, 480 minutes of standing leave 0.0003 of the drift.
            let first = report.passes.iter().find(|p| p.at_min > 660.0).unwrap();
            assert!(mm_from_m(first.before.max_m) < 2e-3, "{:?}", first.before);
            let last = report.passes.last().unwrap();
            assert!(mm_from_m(last.before.max_m) > 0.05, "{:?}", last.before);
        }
    }

    #[test]
    #[ignore = "long"]
    fn lunch_and_night_are_pauses_in_every_form() {
        let steps = [
            "signal diPart 1",
            "call tcColdStart",
            "run 120",
            "stand 45",
            "run 30",
            "power_off 840",
            "run 30",
            "pp_to_main",
            "run 5",
        ];
        for form in FORMS {
            let report = played(&made(form), None, &steps);
            assert!(
                report.passes.iter().all(|p| mm_from_m(p.after.max_m) <= within_mm(form)),
                "{form:?}: {:?}",
                report.worst
            );
            assert!(report.messages.iter().all(|m| m.source != "TPWrite"), "{form:?}: {:?}", report.messages);
        }
    }

    #[test]
    #[ignore = "long"]
    fn a_trap_goes_away_and_comes_back_to_where_the_arm_stood() {
        let steps = ["call tcColdStart", "set tcMode -1", "run 40", "pass", "stand 1", "pass"];
        for form in FORMS {
            let files = made(form);
            let text = String::from_utf8_lossy(&files.0[0].1).into_owned();
            // Where the warm arm stood is a reading, and holds the drift already.
            assert!(text.contains("    MoveL pBack,v100,fine,tGrip;"), "{form:?}: {text}");
            let report = played(&files, Some("rServed"), &steps);
            for p in &report.passes {
                assert_eq!((&p.failure, &p.mismatch, p.unreached), (&None, &None, 0), "{form:?}");
                // Five moves a part, and the two of the trap.
                assert_eq!(p.n, 2 * 5 + 2, "{form:?}");
                assert!(
                    mm_from_m(p.corrected.max_m) <= within_mm(form),
                    "{form:?} at {}: {:?}",
                    p.at_min,
                    p.worst
                );
            }
        }
    }

    #[test]
    #[ignore = "long"]
    fn a_minute_that_the_operator_knows_is_a_start_too() {
        for form in FORMS {
            let report = played(&made(form), None, &["signal diPart 1", "call tcColdStart", "run 60"]);
            let known = report.passes.last().unwrap().program_min.unwrap();
            let files = made(form);
            let text = String::from_utf8_lossy(&files.0[0].1).into_owned();
            let with = text.replacen(
                "  PROC rServed()",
                "  PROC rKnown()\n    tcStartAt 60;\n  ENDPROC\n\n  PROC rServed()",
                1,
            );
            let files = (vec![("Cell.mod".to_owned(), with.into_bytes())], files.1);
            let report = played(&files, None, &["signal diPart 1", "call rKnown", "pass"]);
            let started = report.passes.last().unwrap().program_min.unwrap();
            assert!((started - known).abs() < 1.5, "{form:?}: {started} {known}");
        }
    }
}

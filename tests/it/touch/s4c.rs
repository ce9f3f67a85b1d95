//! Touches on an S4C controller, whose RAPID has neither `CalcJointT` nor data of a task's own.

use super::refusals::{as_the_table, settled_mm};
use super::{Cell, SOURCE, TABLE_TAU_MIN, Truth, job, search};
use driftpost::ProgramFiles;
use rapid_compensation::compensate::FormChoice;
use rapid_compensation::emit::TouchBy;
use robot_model::deform::GrowthLaw;

const LAW: GrowthLaw = GrowthLaw::TwoStage { tau_min: TABLE_TAU_MIN };

/// The program of an S4C, which its file's name tells.
fn program(form: FormChoice, by: TouchBy, log: bool) -> Result<Vec<u8>, String> {
    let mut job = job(form, LAW, Some((by, 0.02)));
    job.touch.as_mut().unwrap().log = log;
    let given = ProgramFiles::one("Cell.prg", SOURCE.as_bytes().to_vec());
    let output_text = match job.run(&given) {
        Ok(mut made) => return Ok(made.files.remove(0).bytes),
        Err(refusal) => refusal.messages.last().unwrap().diagnostic.message.clone(),
    };
    Err(output_text)
}

#[test]
fn what_an_s4c_lacks_is_not_emitted_and_two_touches_make_a_wrong_state_right() {
    for form in [FormChoice::Ramp, FormChoice::Schedule] {
        let text = program(form, search(), false).unwrap();
        let output_text = String::from_utf8_lossy(&text);
        for lacks in ["CalcJointT", "CalcRobT", "TASK PERS", "iodev"] {
            assert!(!output_text.contains(lacks), "{form:?}: {lacks}");
        }
        assert!(output_text.contains("PROC tcTouch()"));
        let mut cell = Cell::new(&text, &Truth { worked_min: 600.0, amount: 1.3, ..as_the_table() });
        cell.call("tcColdStart");
        for _ in 0..2 {
            cell.call("tcTouch");
            cell.pass_min(1.0, true);
        }
        let worst = cell.work().into_iter().fold(0.0, f64::max);
        assert!(worst < 0.02, "{form:?} {worst} {}", cell.touch_message());
    }
}

#[test]
fn a_point_a_tool_and_a_displacement_that_are_others_are_refused() {
    let text = program(FormChoice::Ramp, TouchBy::Routine("probe".into()), false).unwrap();
    let mut cell = Cell::new(&text, &as_the_table());
    cell.call("tcColdStart");
    cell.seen([0.0; 3]);
    assert_eq!(cell.touch_message(), "Touch taken");
    cell.seen([0.0, 200.0, 0.0]);
    assert!(cell.touch_message().contains("the arm is not where it should be"), "{}", cell.touch_message());
    let settled = settled_mm().map(|x| 0.1 * x);
    let shift = "MODULE Shift\n  PROC shifted()\n    PDispSet [[1,0,0],[1,0,0,0]];\n  ENDPROC\n  PROC back()\n    PDispOff;\n  \
                 ENDPROC\nENDMODULE\n";
    cell.controller.load("Shift.mod", shift.as_bytes()).unwrap();
    for (routine, output_text) in [("shifted", "the arm is not where it should be"), ("back", "Touch taken")]
    {
        cell.call(routine);
        cell.seen(settled);
        assert!(cell.touch_message().contains(output_text), "{routine}: {}", cell.touch_message());
    }
}

#[test]
fn a_log_of_joints_is_refused_with_what_is_missing() {
    let output_text = program(FormChoice::Ramp, search(), true).unwrap_err();
    assert!(output_text.contains("--touch-log") && output_text.contains("CalcJointT"), "{output_text}");
}

//! What is refused leaves the state as it is.

use super::{Cell, SOURCE, TABLE_TAU_MIN, Truth, emitted, job, search};
use crate::emit::tokens::doubled_signs;
use driftpost::ProgramFiles;
use rapid_compensation::compensate::FormChoice;
use rapid_compensation::emit::{Core, TouchBy};
use robot_model::deform::GrowthLaw;

const LAW: GrowthLaw = GrowthLaw::TwoStage { tau_min: TABLE_TAU_MIN };

pub fn as_the_table() -> Truth {
    Truth {
        amount: 1.0,
        law: LAW,
        tau_cool_min: 46.0,
        worked_min: 0.0,
        noise_mm: 0.0,
        false_share: 0.0,
        seed: 1,
    }
}

#[test]
fn never_called_it_changes_no_motion_and_without_it_nothing_is_added() {
    for form in [FormChoice::Ramp, FormChoice::Live] {
        let plain = emitted(form, LAW, None);
        assert!(!String::from_utf8(plain.clone()).unwrap().contains("tcTouch"));
        let touching = emitted(form, LAW, Some((search(), 0.02)));
        let [mut a, mut b] = [plain, touching].map(|text| Cell::new(&text, &as_the_table()));
        for cell in [&mut a, &mut b] {
            cell.call("tcColdStart");
        }
        for minutes in [0.0, 4.0, 3.0, 45.0, 4.0, 2.0, 100.0, 1.0] {
            let [mut one, mut other] = [Vec::new(), Vec::new()];
            for (cell, errors) in [(&mut a, &mut one), (&mut b, &mut other)] {
                cell.pass_min(minutes, minutes <= 5.0);
                *errors = cell.work();
            }
            assert_eq!(one, other, "{form:?}");
            assert_eq!(a.number("tcMinute"), b.number("tcMinute"));
        }
        assert_eq!((b.number("tcTouchAge"), b.number("tcTouchSigma")), (-1.0, -1.0));
    }
}

#[test]
fn a_wrong_first_state_is_right_after_two_touches() {
    // Fully warm and a third more than the table says, and told to be cold; and cold, told to be warm.
    for (worked_min, amount, start) in
        [(600.0, 1.3, "tcColdStart"), (0.0, 1.0, "tcWarmStart"), (600.0, 0.7, "")]
    {
        for form in [FormChoice::Ramp, FormChoice::Schedule, FormChoice::Live] {
            let text = emitted(form, LAW, Some((search(), 0.02)));
            let mut cell = Cell::new(&text, &Truth { worked_min, amount, ..as_the_table() });
            if !start.is_empty() {
                cell.call(start);
            }
            for _ in 0..2 {
                cell.call("tcTouch");
                cell.pass_min(1.0, true);
            }
            let worst = cell.work().into_iter().fold(0.0, f64::max);
            let (output_text, age) = (cell.touch_message(), cell.number("tcTouchAge"));
            assert!(worst < 0.02 && (age - 1.0).abs() < 0.1, "{form:?} {start} {worst} {output_text} {age}");
        }
    }
}

/// What the module with `tcTouch` cannot see is not called there: a controller would refuse to run it.
#[test]
fn a_routine_that_is_local_to_another_module_is_refused() {
    let (head, tail) = SOURCE.split_once("  PROC probe(").unwrap();
    let (probe, end) = tail.split_once("ENDPROC\n").unwrap();
    let refused = |scope: &str, own: bool, core: Core| {
        let probe = format!("  {scope}PROC probe({probe}ENDPROC\n");
        let (cell, tools) = match own {
            true => (format!("{head}{probe}{end}"), "MODULE Tools\nENDMODULE\n".to_owned()),
            false => (format!("{head}{end}"), format!("MODULE Tools\n{probe}ENDMODULE\n")),
        };
        let program = ProgramFiles::new(
            [("Cell.mod", cell), ("Tools.mod", tools)]
                .map(|(name, text)| (name.to_owned(), text.into_bytes())),
        );
        let mut job = job(FormChoice::Ramp, LAW, Some((TouchBy::Routine("Probe".into()), 0.02)));
        job.emit.core = Some(core);
        let refusal = job.run(&program).err()?;
        let message = &refusal.messages.last().unwrap().diagnostic;
        assert_eq!(message.code, "touch::clock");
        Some(message.message.clone())
    };
    assert_eq!(refused("", false, Core::Embedded), None);
    assert_eq!(refused("", false, Core::Separate), None);
    assert_eq!(refused("LOCAL ", true, Core::Embedded), None);
    let output_text = refused("LOCAL ", false, Core::Embedded).unwrap();
    assert!(
        output_text.contains("Probe is LOCAL to its module, and the module that gets tcTouch"),
        "{output_text}"
    );
    let output_text = refused("LOCAL ", true, Core::Separate).unwrap();
    assert!(output_text.contains("and tcCore cannot see it"), "{output_text}");
}

/// A cell whose program finds the point by a routine of its own, which says what `pSeen` holds.
fn with_routine() -> Cell {
    let text = emitted(FormChoice::Ramp, LAW, Some((TouchBy::Routine("probe".into()), 0.02)));
    Cell::new(&text, &as_the_table())
}

impl Cell {
    pub fn seen(&mut self, off_mm: [f64; 3]) {
        let at: Vec<f64> = super::CENTRE_MM.iter().zip(off_mm).map(|(c, off)| c + off).collect();
        let text = format!("[{},{},{}]", at[0], at[1], at[2]);
        let value =
            virtual_controller::parse_value(&text, &self.controller.type_of("pSeen").unwrap()).unwrap();
        self.controller.set("pSeen", value).unwrap();
        self.call("tcTouch");
    }

    fn state(&mut self) -> Vec<f64> {
        let names = ["tcState", "tcKnown", "tcBy"];
        let mut all: Vec<f64> =
            names.iter().flat_map(|n| self.controller.value(n).unwrap().numbers()).collect();
        all.extend(["tcAmount", "tcTau", "tcTauCool", "tcTouchAge"].map(|name| self.number(name)));
        all
    }
}

#[test]
fn what_cannot_be_is_refused_and_leaves_the_state() {
    let mut cell = with_routine();
    cell.call("tcColdStart");
    cell.seen([0.0; 3]);
    assert!(cell.touch_message().contains("Touch taken"), "{}", cell.touch_message());
    let before = cell.state();
    for (off_mm, why) in [
        ([0.0, 0.2, 0.2], "not where warmth could have brought it"),
        ([-5.0, 0.0, 0.0], "not where warmth could have brought it"),
        ([0.0, 200.0, 0.0], "the arm is not where it should be"),
    ] {
        cell.seen(off_mm);
        assert!(cell.touch_message().contains(why), "{off_mm:?}: {}", cell.touch_message());
        assert_eq!(cell.state(), before, "{off_mm:?}");
    }
    // Along the drift: all of the settled one at once, on an arm that was cold a moment ago.
    let settled = settled_mm();
    cell.seen(settled);
    assert!(cell.touch_message().contains("over three sigma"), "{}", cell.touch_message());
    assert_eq!(cell.state(), before);
    // Once more the same: then it is the state that was wrong.
    cell.seen(settled);
    assert!(cell.touch_message().contains("Touch taken"), "{}", cell.touch_message());
    assert!((cell.number("tcShare") - 1.0).abs() < 0.05, "{}", cell.number("tcShare"));
}

/// By how much the settled arm is told to go elsewhere at the sphere, mm: of the arm's own kinematics.
pub fn settled_mm() -> [f64; 3] {
    use robot_model::deform::{Conditions, DeformedArm};
    use robot_model::kinematics::{Chain, ClosedForm, solve};
    let arm = driftpost::Robot::built_in("irb140").unwrap();
    let there = nalgebra::Isometry3::from_parts(
        nalgebra::Vector3::from(super::CENTRE_MM).scale(1e-3).into(),
        nalgebra::UnitQuaternion::from_euler_angles(0.0, std::f64::consts::FRAC_PI_2, 0.0),
    );
    let closed = ClosedForm::new(&arm).unwrap();
    let near = closed.solutions(&there).into_iter().find(|s| s.configuration.cfx == 1).unwrap();
    let warm = DeformedArm::of_table(&arm, &driftpost::Deformation::paper().settled());
    let solved = solve(&warm.under(&Conditions::default()), &there, &near.q_rad).unwrap();
    let shift_m = Chain::nominal(&arm).forward(&solved.q_rad).translation.vector - there.translation.vector;
    [shift_m.x * 1e3, shift_m.y * 1e3, shift_m.z * 1e3]
}

#[test]
fn a_point_that_is_not_found_and_a_displacement_are_refused() {
    let text = emitted(FormChoice::Ramp, LAW, Some((search(), 0.02)));
    let mut cell = Cell::new(&text, &as_the_table());
    cell.call("tcColdStart");
    cell.call("tcTouch");
    assert!(cell.touch_message().contains("Touch taken"), "{}", cell.touch_message());
    let before = cell.state();
    // The whole cell has moved by 20 mm.
    let away = Truth { seed: 2, ..as_the_table() };
    let mut moved = Cell::new(&text, &away);
    moved.controller = {
        let mut c =
            virtual_controller::Controller::with_robot(&driftpost::Robot::built_in("irb140").unwrap())
                .unwrap();
        c.load("Cell.mod", &text).unwrap();
        c.put_sphere(virtual_controller::Sphere {
            signal: "diTouch".into(),
            centre_mm: [400.0, 330.0, 160.0],
            radius_mm: super::RADIUS_MM,
            noise_mm: 0.0,
            false_share: 0.0,
            false_mm: [0.0; 2],
            seed: 1,
        });
        c
    };
    moved.call("tcColdStart");
    moved.call("tcTouch");
    assert!(moved.touch_message().contains("the point was not found"), "{}", moved.touch_message());
    assert_eq!(moved.number("tcTouchAge"), -1.0);
    let shift = "MODULE Shift\n  PROC shifted()\n    PDispSet [[1,0,0],[1,0,0,0]];\n  ENDPROC\nENDMODULE\n";
    cell.controller.load("Shift.mod", shift.as_bytes()).unwrap();
    cell.call("shifted");
    cell.call("tcTouch");
    assert!(cell.touch_message().contains("the arm is not where it should be"), "{}", cell.touch_message());
    assert_eq!(cell.state(), before);
}

#[test]
fn it_is_taken_out_again_and_nothing_else_differs() {
    let folder = tempfile::tempdir().unwrap();
    let cell = folder.path().join("Cell.mod");
    std::fs::write(&cell, SOURCE).unwrap();
    for (form, by) in [("schedule", "signal"), ("ramp", "routine"), ("live", "signal"), ("auto", "routine")] {
        let out = folder.path().join(format!("{form}.mod"));
        let driftpost = |args: &[&str]| {
            let mut command = assert_cmd::Command::cargo_bin("driftpost").unwrap();
            command.current_dir(folder.path()).args(args).assert().success();
        };
        let out = out.display().to_string();
        let how = [format!("--touch-{by}"), if by == "signal" { "diTouch" } else { "probe" }.to_owned()];
        let options = ["--touch", "S1=pSphere,tool0,wobj0", &how[0], &how[1], "--form", form, "-o", &out];
        driftpost(&[&["compensate", "Cell.mod", "--diff", "none"], &options[..]].concat());
        let mut diff = assert_cmd::Command::cargo_bin("driftpost").unwrap();
        let args = ["diff", "Cell.mod", &out, "--format", "json"];
        let run = diff.current_dir(folder.path()).args(args).assert().code(0);
        let json: serde_json::Value = serde_json::from_slice(&run.get_output().stdout).unwrap();
        assert_eq!(json["same_elsewhere"], true, "{form}");
        assert_eq!(json["only_after"], serde_json::json!([]), "{form}");
        let back = format!("back_{form}.mod");
        driftpost(&["restore", &out, "-o", &back]);
        let restored = std::fs::read(folder.path().join(&back)).unwrap();
        assert_eq!(restored, SOURCE.as_bytes(), "{form}");
    }
}

#[test]
fn a_motion_asks_no_more_of_the_controller_than_without_touches() {
    let text = emitted(FormChoice::Ramp, LAW, Some((search(), 0.02)));
    let mut cell = Cell::new(&text, &as_the_table());
    cell.call("tcColdStart");
    cell.call("tcTouch");
    cell.controller.take_efforts();
    // Work, a pause, work: an update after a pause carries two steps of the lags' dependence on.
    for minutes in [4.0, 30.0, 4.0] {
        cell.pass_min(minutes, minutes < 5.0);
        cell.work();
    }
    let most = cell.controller.take_efforts()["tcAt"].most;
    println!("an update with touches: {most:?}");
    assert!(most.statements <= 200, "{most:?}");
}

/// The drift at the sphere is negative along one axis at least; so written it would be the second summand.
#[test]
fn no_sign_follows_an_operator() {
    let settled_mm = settled_mm();
    assert!(settled_mm[1] < 0.0 || settled_mm[2] < 0.0, "{settled_mm:?}");
    for form in [FormChoice::Schedule, FormChoice::Ramp, FormChoice::Live] {
        let doubled = doubled_signs(&emitted(form, LAW, Some((search(), 0.02))));
        assert!(doubled.is_empty(), "{form:?}: {doubled:?}");
    }
}

//! The form `ramp` executed: one correction a target, scaled by the share of the drift, at any minute and in any hour.

use super::made::{Files, fixture, made_as, session, warmth};
use rapid_compensation::compensate::FormChoice;
use rapid_compensation::emit::{Clock, DriftGrowth, restore};
use robot_model::deform::{Deformation, GrowthLaw};
use robot_model::robot::Robot;
use robot_model::units::{deg_from_rad, mm_from_m};
use virtual_controller::{Controller, Report};

fn ramp(name: &str, deformation: &Deformation, clock: &Clock) -> (Files, Files) {
    let original = fixture(name);
    (made_as(FormChoice::Ramp, &original, deformation, clock).unwrap().0, original)
}

fn at_minutes(files: &(Files, Files), deformation: &Deformation, minutes: &[f64]) -> Report {
    let mut s = session(&files.0, &files.1, deformation, false);
    s.at_minutes(minutes).unwrap();
    s.into_report()
}

fn quarter_minutes(to_min: u32) -> Vec<f64> {
    (0..=4 * to_min).map(|k| f64::from(k) * 0.25).collect()
}

/// Worst distance, mm, and angle, degrees, of the moves that are corrected.
fn worst(report: &Report) -> (f64, f64) {
    assert!(
        report.passes.iter().skip(1).all(|p| p.corrected.max_m > 0.0),
        "something is corrected in each pass"
    );
    let passes = || report.passes.iter().map(|p| &p.corrected);
    let most = |of: &dyn Fn(&virtual_controller::session::ErrorStatistics) -> f64| {
        passes().map(of).fold(0.0, f64::max)
    };
    (mm_from_m(most(&|s| s.max_m)), deg_from_rad(most(&|s| s.max_rad)))
}

#[test]
fn from_one_second_to_the_next_the_target_moves_by_what_the_arm_drifts() {
    let (program, _) = ramp("robodk/irc5/Cube45.mod", &Deformation::paper(), &warmth());
    let asks = "MODULE Asks\n  VAR robtarget tgt;\n  PROC ask()\n    tgt:=tcAt([[1,2,3],[1,0,0,0],[0,0,0,0],\
                [9E9,9E9,9E9,9E9,9E9,9E9]],[[0.193,0,0],[1,0,0,0]]);\n  ENDPROC\nENDMODULE\n";
    let mut c = Controller::new();
    c.load(&program[0].0, &program[0].1).unwrap();
    c.load("asks.mod", asks.as_bytes()).unwrap();
    c.call("tcColdStart", 1).unwrap();
    let mut last = 1.0;
    let mut most = 0.0_f64;
    for _ in 0..4 * 3600 {
        c.calendar_mut().advance_s(1.0);
        assert!(c.call("ask", 1).unwrap().is_good());
        let now = c.value("tgt").unwrap().numbers()[0];
        most = most.max((now - last).abs());
        last = now;
    }
    // The law's steepest is 0.193 mm / 46 min / e a minute, 0.0000257 mm a second.
    assert!(most <= 2e-4 && most > 2e-5, "{most}");
    // Four hours are 0.9669 of the drift: 1 - (1 + 240/46) e^(-240/46).
    let s = 240.0_f64 / 46.0;
    let share = 1.0 - (1.0 + s) * (-s).exp();
    assert!((last - 1.0 - 0.193 * share).abs() < 2e-6, "{last}");
}

#[test]
fn asking_again_costs_little_and_an_update_not_much() {
    for form in [FormChoice::Schedule, FormChoice::Ramp, FormChoice::Live] {
        for clock in [warmth(), Clock::Elapsed] {
            let original = fixture("robodk/irc5/Cube45.mod");
            let (program, _) = made_as(form, &original, &Deformation::paper(), &clock).unwrap();
            let mut c = Controller::with_robot(&Robot::built_in("irb140").unwrap()).unwrap();
            c.load(&program[0].0, &program[0].1).unwrap();
            c.call("tcColdStart", 1).unwrap();
            // After a night, so that what cooled is worked out as well.
            c.calendar_mut().advance_min(900.0);
            c.call("Cube45", 1).unwrap();
            c.calendar_mut().advance_min(30.0);
            c.take_efforts();
            c.call("Cube45", 1).unwrap();
            for (name, efforts) in c.take_efforts() {
                let update = efforts.most.statements - efforts.fewest.statements;
                assert!(update <= 200, "{form:?} {name}: {efforts:?}");
                if name == "tcLive" {
                    let within = efforts.most.arithmetic <= 700 && efforts.most.trigonometric <= 12;
                    assert!(within, "{efforts:?}");
                }
            }
            // In the same second: to know that nothing is to be done, and to give the target.
            c.calendar_mut().held = true;
            c.call("Cube45", 1).unwrap();
            c.take_efforts();
            c.call("Cube45", 1).unwrap();
            let again = c.take_efforts();
            for (name, most) in [("tcK", 3), ("tcAt", 6), ("tcAtJ", 5)] {
                let asked = again.get(name).map(|efforts| efforts.most.statements);
                assert_eq!(
                    asked.is_some(),
                    (name == "tcK") == (form == FormChoice::Schedule) && form != FormChoice::Live
                );
                assert!(asked.is_none_or(|asked| asked == most), "{form:?} {name}: {asked:?}");
            }
        }
    }
}

#[test]
fn three_times_the_table_is_met_by_a_second_correction() {
    let paper = Deformation::paper();
    let three = robot_model::kinematics::FrameOffsets(paper.settled().0.map(|row| row.map(|x| 3.0 * x)));
    let three = Deformation::from_static(three, GrowthLaw::TwoStage { tau_min: 46.0 });
    let original = fixture("robodk/irc5/Cube45.mod");
    let options = rapid_compensation::compensate::Options {
        form: FormChoice::Ramp,
        max_correction_m: 2e-3,
        ..Default::default()
    };
    let program = rapid_program::Program::read(
        vec![rapid_syntax::SourceFile::read(
            rapid_syntax::diagnostic::FileId(0),
            "c.mod",
            original[0].1.clone(),
        )],
        &rapid_program::Overrides::default(),
    );
    let robot = Robot::built_in("irb140").unwrap();
    let plan = rapid_compensation::compensate::plan(&program, &robot, &three, &options).unwrap();
    assert!(plan.summary.worst_after_m <= 0.6e-6, "{:?}", plan.summary);
}

#[test]
fn originals_come_back_to_the_byte_and_touched_up_ones_as_they_are() {
    for name in
        ["robodk/irc5/Cube45.mod", "robodk/irc5/RichProg.mod", "robodk/s4c/RichProg.prg", "simulate/cell.mod"]
    {
        let (program, original) = ramp(name, &Deformation::paper(), &warmth());
        let restored = restore(&program[0].1).unwrap();
        assert!(restored.exact && restored.bytes == original[0].1, "{name}");
        let task_data = program[0].1.windows(9).any(|w| w == b"TASK PERS");
        assert_eq!(task_data, !name.ends_with(".prg"), "{name}");
    }
    let (program, original) = ramp("robodk/irc5/Cube45.mod", &Deformation::paper(), &warmth());
    let text = String::from_utf8(program[0].1.clone()).unwrap();
    let touched = text.replacen("[[400.000, 150.000, 250.000]", "[[400.300, 150.400, 250.000]", 1);
    let restored = restore(touched.as_bytes()).unwrap();
    let [one] = restored.touched.as_slice() else { panic!("{:?}", restored.touched) };
    assert!((one.moved - 0.5).abs() < 2e-3 && one.unit == "mm", "{one:?}");
    assert_eq!(one.line as usize, 1 + touched[..touched.find("[[400.300").unwrap()].matches('\n').count());
    let expected =
        String::from_utf8_lossy(&original[0].1).replacen("[[400.000, 150.000,", "[[400.300, 150.400,", 1);
    assert_eq!(String::from_utf8_lossy(&restored.bytes), expected);
}

/// A milling program: an arc of so many inline targets 0.3 mm apart, as RoboDK writes them.
fn milling(targets: usize) -> Files {
    let mut text = String::from("MODULE Mill\n    PROC Mill()\n        ConfJ \\On;\n        ConfL \\Off;\n");
    for k in 0..targets {
        let (sin, cos) = (0.3 / 80.0 * k as f64).sin_cos();
        let [x, y] = [420.0 + 80.0 * cos, 60.0 + 80.0 * sin];
        text.push_str(&format!(
            "        MoveL [[{x:.3}, {y:.3}, 350.000],[0.00000000, 0.00000000, 1.00000000, 0.00000000],[0,0,0,0],\
             [9E+09,9E+09,9E+09,9E+09,9E+09,9E+09]],v100,z1,tool0,\\WObj:=wobj0;\n"
        ));
    }
    text.push_str("    ENDPROC\nENDMODULE\n");
    vec![("Mill.mod".to_owned(), text.into_bytes())]
}

#[test]
fn targets_with_names_keep_corrections_of_their_own() {
    let target = |x: f64| format!("[[{x},60,350],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]");
    let text = format!(
        "MODULE Two\n  CONST robtarget pA:={};\n  CONST robtarget pB:={};\n  PROC Two()\n    MoveJ pA,v100,fine,tool0;\n    \
         MoveL pB,v100,fine,tool0;\n  ENDPROC\nENDMODULE\n",
        target(450.0),
        target(450.1)
    );
    let original = vec![("Two.mod".to_owned(), text.into_bytes())];
    let made = made_as(FormChoice::Ramp, &original, &Deformation::paper(), &warmth()).unwrap().0;
    let text = String::from_utf8_lossy(&made[0].1);
    assert!(text.contains("MoveJ tcAt(pA,tcPA),") && text.contains("MoveL tcAt(pB,tcPB),"), "{text}");
}

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
mod long {
    use super::*;

    #[test]
    #[ignore = "long"]
    fn cube45_stands_on_its_targets_at_every_quarter_minute() {
        let paper = Deformation::paper();
        for clock in [warmth(), Clock::Elapsed] {
            let files = ramp("robodk/irc5/Cube45.mod", &paper, &clock);
            let report = at_minutes(&files, &paper, &quarter_minutes(600));
            assert!(report.passes.iter().all(|p| p.n == 46 && p.failure.is_none()));
            let (mm, deg) = worst(&report);
            assert!(mm <= 2e-4 && deg <= 5e-5, "{clock:?}: {mm} mm, {deg} deg");
            // The reference paper's table, nothing compensated: 0.193 mm in the end.
            let before = mm_from_m(report.passes.last().unwrap().before.max_m);
            assert!((before - 0.193).abs() < 5e-4, "{before}");
        }
    }

    #[test]
    #[ignore = "long"]
    fn a_scheduled_table_of_two_laws_takes_as_many_functions() {
        // Joint 2's frame rises with one lag of 20 minutes, joint 5's turns with one of 90.
        let lag = |t: f64, tau: f64| 1.0 - (-t / tau).exp();
        let mut text = "t_min,joint,dx_mm,dy_mm,dz_mm,rx_deg,ry_deg,rz_deg\n".to_owned();
        for k in 0..=60 {
            let t = 10.0 * f64::from(k);
            text += &format!(
                "{t},2,0,0,{},0,0,0\n{t},5,0,0,0,{},0,{}\n",
                0.1 * lag(t, 20.0),
                0.02 * lag(t, 90.0),
                0.01 * lag(t, 90.0)
            );
        }
        let table = Deformation::from_csv(text.as_bytes(), None).unwrap();
        let clock =
            Clock::Warmth { growth: DriftGrowth::of(&table, None), tau_cool_min: Some(40.0), gap_min: 5.0 };
        let files = ramp("robodk/irc5/Cube45.mod", &table, &clock);
        let text = String::from_utf8_lossy(&files.0[0].1).into_owned();
        assert!(text.contains("FUNC robtarget tcAt(robtarget tcP,pose tcC1,pose tcC2)"), "{text}");
        let report = at_minutes(&files, &table, &quarter_minutes(620));
        let (mm, deg) = worst(&report);
        assert!(mm <= 5e-4 && deg <= 1e-4, "{mm} mm, {deg} deg");
        let before = report.passes.iter().map(|p| mm_from_m(p.before.max_m)).fold(0.0, f64::max);
        assert!(before > 0.1, "{before}");
    }

    #[test]
    #[ignore = "long"]
    fn neighbours_without_a_name_share_a_correction_and_stand_on_their_targets() {
        let paper = Deformation::paper();
        let original = milling(1000);
        let made = made_as(FormChoice::Ramp, &original, &paper, &warmth()).unwrap().0;
        let text = String::from_utf8_lossy(&made[0].1);
        assert_eq!(text.matches("MoveL tcAt([[").count(), 1000);
        let corrections = text.matches("LOCAL CONST pose tc").count();
        assert!((50..300).contains(&corrections), "{corrections}");
        let core = made_as(FormChoice::Ramp, &milling(1), &paper, &warmth()).unwrap().0[0].1.len();
        let grown = (made[0].1.len() - core) as f64 / original[0].1.len() as f64;
        assert!(grown < 1.3, "{grown}");

        let files = (made, original);
        let minutes: Vec<f64> = (0..=60).map(|k| 10.0 * f64::from(k)).collect();
        let report = at_minutes(&files, &paper, &minutes);
        assert!(report.passes.iter().all(|p| p.n == 1000 && p.failure.is_none()));
        let (mm, deg) = worst(&report);
        assert!(mm <= 5e-4 && deg <= 1e-4, "{mm} mm, {deg} deg");
        let restored = restore(&files.0[0].1).unwrap();
        assert_eq!(restored.bytes, files.1[0].1);
    }
}

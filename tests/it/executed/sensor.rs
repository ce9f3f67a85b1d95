//! A measured temperature as the index: in range, out of it, no longer changing, and with its unit down.

use super::made::{Files, borrowed, compensated, fixture, fixtures};
use crate::emit::tokens::doubled_signs;
use rapid_compensation::emit::{Clock, Sensor};
use robot_model::deform::Deformation;
use robot_model::robot::Robot;
use virtual_controller::session::{Pass, SessionOptions};
use virtual_controller::{Report, Scenario, Session, TrueRobot};

const NAME: &str = "aiTemp";

/// The reference paper's Table 2 at 45 degrees, nothing at 20.
fn by_temperature() -> Deformation {
    let table = std::fs::read_to_string(fixtures().join("paper/table2_deformation.csv")).unwrap();
    let mut text = "temp_c,joint,dx_mm,dy_mm,dz_mm,rx_deg,ry_deg,rz_deg\n".to_owned();
    for (joint, row) in (1..).zip(table.lines().skip(1)) {
        text += &format!("20,{joint},0,0,0,0,0,0\n45,{joint},{row}\n");
    }
    Deformation::from_csv(text.as_bytes(), None).unwrap()
}

fn clock(source: Sensor) -> Clock {
    Clock::Sensor { source, hold_min: 10.0, stale_min: 60.0 }
}

/// The cube with a persistent of the sensor's name, or without.
fn cube(source: Sensor) -> (Files, Files) {
    let mut original = fixture("robodk/irc5/Cube45.mod");
    if let Sensor::Pers(name) = &source {
        let text = String::from_utf8(original[0].1.clone()).unwrap();
        let declared = format!("MODULE MOD_Cube45\n  PERS num {name}:=-40;\n");
        original[0].1 = text.replacen("MODULE MOD_Cube45\n", &declared, 1).into_bytes();
    }
    (compensated(&original, &by_temperature(), &clock(source)).unwrap(), original)
}

fn session((program, original): &(Files, Files)) -> Session {
    let truth = TrueRobot::new(Robot::built_in("irb140").unwrap(), by_temperature());
    let options =
        SessionOptions { paths: false, thermometer: Some(NAME.into()), ..SessionOptions::default() };
    Session::new(&borrowed(program), Some(&borrowed(original)), truth, options).unwrap()
}

fn played(files: &(Files, Files), steps: &[&str]) -> Report {
    let mut s = session(files);
    let steps = steps.iter().map(|s| (*s).to_owned()).collect();
    Scenario { steps, ..Scenario::default() }.play(&mut s).unwrap();
    s.into_report()
}

fn is_original(pass: &Pass) -> bool {
    pass.index == Some(1.0) && pass.after == pass.before
}

fn shown(report: &Report) -> Vec<&str> {
    report.messages.iter().filter(|m| m.source == "TPWrite").map(|m| m.text.as_str()).collect()
}

/// Passes that began after so many minutes and ended before so many.
fn between(report: &Report, from_min: f64, to_min: f64) -> Vec<&Pass> {
    let found: Vec<&Pass> =
        report.passes.iter().filter(|p| p.at_min > from_min + 1.0 && p.at_min < to_min).collect();
    assert!(!found.is_empty());
    found
}

#[test]
fn every_temperature_of_the_table_has_its_bucket() {
    for source in [Sensor::Signal(NAME.into()), Sensor::Pers(NAME.into())] {
        let files = cube(source);
        let mut s = session(&files);
        let mut degrees: Vec<f64> = (0..=100).map(|k| 20.0 + 0.25 * f64::from(k)).collect();
        // A little beyond the table's ends it is held there, as the deformation is.
        degrees.extend([19.0, 47.0]);
        s.at_minutes(&degrees).unwrap();
        let report = s.into_report();
        assert!(report.is_within(5.5e-6), "{:?}", report.worst);
        assert_eq!(shown(&report), [""; 0]);
        assert!(report.switches.len() > 10);
    }
}

#[test]
fn a_sensor_that_is_lost_is_believed_for_ten_minutes() {
    for source in [Sensor::Signal(NAME.into()), Sensor::Pers(NAME.into())] {
        let signal = matches!(source, Sensor::Signal(_));
        let files = cube(source);
        let faults = match signal {
            true => vec![
                ["unit_down aiTemp", "unit_up aiTemp"],
                ["signal aiTemp 200", "signal aiTemp 35.1"],
                ["signal aiTemp -3", "signal aiTemp 35.1"],
            ],
            false => vec![["set aiTemp 200", "set aiTemp 35.1"], ["set aiTemp 0", "set aiTemp 35.1"]],
        };
        for [fault, repair] in faults {
            let steps = ["temperature 35", "run 5", fault, "run 25", repair, "run 5"];
            let report = played(&files, &steps);
            for pass in between(&report, 0.0, 14.0).into_iter().chain(between(&report, 30.0, 99.0)) {
                assert!(pass.after.max_m < 6.5e-6 && pass.index != Some(1.0), "{fault}: {pass:?}");
            }
            assert!(between(&report, 15.5, 30.0).into_iter().all(is_original), "{fault}");
            assert_eq!(shown(&report), ["Temperature lost, out of range or stale: original targets"]);
        }
    }
}

#[test]
fn a_temperature_that_never_changes_is_none() {
    let files = cube(Sensor::Signal(NAME.into()));
    let report = played(&files, &["temperature 35", "run 90", "temperature 35.2", "run 5"]);
    assert!(between(&report, 0.0, 69.0).iter().all(|p| p.after.max_m < 5.5e-6));
    assert!(between(&report, 71.0, 90.0).into_iter().all(is_original));
    assert!(between(&report, 90.0, 99.0).iter().all(|p| p.after.max_m < 5.5e-6));
}

#[test]
fn without_any_reading_the_originals_run_and_it_is_said_once() {
    for source in [Sensor::Signal(NAME.into()), Sensor::Pers(NAME.into())] {
        let report = played(&cube(source), &["run 20", "pp_to_main", "run 5"]);
        assert!(report.passes.iter().all(is_original));
        assert_eq!(shown(&report)[0], "No temperature yet: original targets");
    }
}

#[test]
fn power_off_midnight_and_a_clock_set_back_keep_the_reading_honest() {
    let files = cube(Sensor::Signal(NAME.into()));
    let steps = [
        "set_date 2026-12-31 23:50:00",
        "temperature 35",
        "run 15",
        "temperature 36",
        "set_clock_back 600",
        "run 5",
        "unit_down aiTemp",
        "run 8",
        "power_off 480",
        "run 2",
        "unit_up aiTemp",
        "temperature 21",
        "run 5",
    ];
    let report = played(&files, &steps);
    assert!(between(&report, 0.0, 28.0).iter().all(|p| p.after.max_m < 6.5e-6), "{:?}", report.worst);
    // After the night the last reading is that of the evening: too old to be used.
    assert!(between(&report, 507.0, 510.0).into_iter().all(is_original));
    let morning = between(&report, 511.0, 999.0);
    assert!(morning.iter().all(|p| p.after.max_m < 5.5e-6), "{morning:?}");
}

/// A table from 10 degrees below zero on: its corrections come, and no sign follows an operator.
#[test]
fn a_table_that_begins_below_zero_is_one() {
    let table = std::fs::read_to_string(fixtures().join("paper/table2_deformation.csv")).unwrap();
    let mut text = "temp_c,joint,dx_mm,dy_mm,dz_mm,rx_deg,ry_deg,rz_deg\n".to_owned();
    for (joint, row) in (1..).zip(table.lines().skip(1)) {
        text += &format!("-10,{joint},0,0,0,0,0,0\n45,{joint},{row}\n");
    }
    let cold = Deformation::from_csv(text.as_bytes(), None).unwrap();
    let original = fixture("robodk/irc5/Cube45.mod");
    let program = compensated(&original, &cold, &clock(Sensor::Signal(NAME.into()))).unwrap();
    for (name, bytes) in &program {
        let doubled = doubled_signs(bytes);
        assert!(doubled.is_empty(), "{name}: {doubled:?}");
    }
    let truth = TrueRobot::new(Robot::built_in("irb140").unwrap(), cold);
    let options =
        SessionOptions { paths: false, thermometer: Some(NAME.into()), ..SessionOptions::default() };
    let mut s = Session::new(&borrowed(&program), Some(&borrowed(&original)), truth, options).unwrap();
    let steps = ["temperature -5", "run 1", "temperature 17.5", "run 1"].map(str::to_owned).to_vec();
    Scenario { steps, ..Scenario::default() }.play(&mut s).unwrap();
    let last = s.into_report().passes.pop().unwrap();
    assert!(last.before.max_m > 5e-5 && last.after.max_m < 5.1e-6, "{last:?}");
}

//! The true robot warms by its motions: a program that only asks a signal lets it cool.

use super::module;
use robot_model::deform::{Deformation, GrowthLaw, Warmth};
use robot_model::robot::Robot;
use std::time::{Duration, Instant};
use virtual_controller::session::SessionOptions;
use virtual_controller::{Report, Scenario, Session, TrueRobot, Warming};

const POLLS: &str = r"
  PERS num polls:=0;
  PROC work()
    MoveAbsJ jHome,v500,fine,tool0;
    MoveL p{1},v100,fine,tool0;
    WaitTime 20;
    MoveL p{2},v100,fine,tool0;
  ENDPROC
  PROC main()
    WHILE TRUE DO
      IF DInput(di1)=1 THEN
        work;
      ELSE
        polls:=polls+1;
        WaitTime 1;
      ENDIF
    ENDWHILE
  ENDPROC";

fn played(body: &str, options: SessionOptions, head: &str, steps: &[&str]) -> Report {
    let text = module(body);
    let files = [("cell.mod", text.as_bytes())];
    let truth = TrueRobot::new(Robot::built_in("irb140").unwrap(), Deformation::paper());
    let mut session = Session::new(&files, Some(&files), truth, options).unwrap();
    let steps: Vec<String> = steps.iter().map(|s| format!("{s:?}")).collect();
    let text = format!("{head}\nsteps = [{}]", steps.join(", "));
    Scenario::from_toml(&text).unwrap().play(&mut session).unwrap();
    session.into_report()
}

/// The warm-up minute after these minutes of work (`true`) and standing.
fn minute_after(parts: &[(f64, bool)]) -> f64 {
    let mut warmth = Warmth::cold(GrowthLaw::TwoStage { tau_min: 46.0 }, 46.0);
    parts.iter().for_each(|&(minutes, works)| warmth.advance(minutes, works));
    warmth.minute().unwrap()
}

const DAY: [&str; 6] = ["signal di1 1", "run 180", "signal di1 0", "run 480", "signal di1 1", "run 60"];

#[test]
fn a_program_that_only_asks_a_signal_lets_the_robot_cool() {
    let begun = Instant::now();
    let report = played(POLLS, SessionOptions::default(), "", &DAY);
    // 28,800 passes without a motion are executed, not listed, and take no time to speak of.
    assert!(begun.elapsed() < Duration::from_secs(10), "{:?}", begun.elapsed());
    assert!(report.passes.len() < 2_000 && report.passes.iter().all(|p| p.n == 3));
    let at = |from_min: f64| report.passes.iter().find(|p| p.at_min > from_min).unwrap();
    assert!((at(100.0).t_min - 100.0).abs() < 1.0, "{}", at(100.0).t_min);
    let cooled = minute_after(&[(180.3, true), (480.0, false)]);
    assert!((at(660.0).t_min - cooled).abs() < 0.5, "{} {cooled}", at(660.0).t_min);
    let warm = report.passes.iter().filter(|p| p.at_min < 181.0).map(|p| p.before.max_m).fold(0.0, f64::max);
    assert!(at(660.0).before.max_m < warm / 100.0);
    // Warm while it runs, as the option says or the scenario.
    for (options, head) in [
        (
            SessionOptions { warming: Some(Warming::Running), ..SessionOptions::default() },
            "warming = \"moving\"",
        ),
        (SessionOptions::default(), "warming = \"running\""),
        (SessionOptions { gap_min: Some(1000.0), ..SessionOptions::default() }, "gap_min = 3"),
    ] {
        let report = played(POLLS, options, head, &DAY);
        let after = report.passes.iter().find(|p| p.at_min > 660.0).unwrap();
        assert!((after.t_min - 660.0).abs() < 1.0, "{head} {}", after.t_min);
    }
}

const WAITS: &str = r"
  PERS num minutes:=0;
  PROC main()
    MoveAbsJ jHome,v500,fine,tool0;
    MoveL p{1},v100,fine,tool0\WObj:=wobj0;
    WaitTime 60*minutes;
    MoveL p{2},v100,fine,tool0;
  ENDPROC";

/// Each move is judged with the arm of its own time: what a pause in the middle of a pass was counts behind it.
#[test]
fn a_pause_inside_of_a_pass_is_what_its_length_says() {
    let after = |wait: &str| {
        let steps = ["run 120", &format!("set minutes {wait}"), "pass", "set minutes 0", "pass"];
        played(WAITS, SessionOptions::default(), "", &steps).passes.last().unwrap().t_min
    };
    let working = after("4.9");
    assert!((working - 124.9).abs() < 0.2, "{working}");
    let stood = minute_after(&[(120.0, true), (45.0, false)]);
    assert!((after("45") - stood).abs() < 0.2, "{} {stood}", after("45"));
    // Ten hours of waiting in the first pass: what comes behind them meets a cold robot, or a warm one.
    let drift_m = |warming: Warming| {
        let options = SessionOptions { warming: Some(warming), ..SessionOptions::default() };
        played(WAITS, options, "", &["set minutes 600", "pass"]).passes[0].before.max_m
    };
    let (moving, running) = (drift_m(Warming::Moving), drift_m(Warming::Running));
    assert!(moving < 1e-6 && running > 5e-5, "{moving} {running}");
    // In two halves, at the end of a pass and beside a stop: one pause.
    let split = WAITS.replace("    MoveL p{2},v100,fine,tool0;\n", "");
    let steps = ["run 120", "set minutes 3", "pass", "stand 3", "set minutes 0", "pass"];
    let report = played(&split, SessionOptions::default(), "", &steps);
    let stood = minute_after(&[(120.0, true), (6.0, false)]);
    let t_min = report.passes.last().unwrap().t_min;
    assert!((t_min - stood).abs() < 0.2, "{t_min} {stood}");
}

#[test]
fn a_gap_that_is_no_time_is_refused() {
    let text = module(WAITS);
    let files = [("cell.mod", text.as_bytes())];
    let truth = TrueRobot::new(Robot::built_in("irb140").unwrap(), Deformation::paper());
    let mut session = Session::new(&files, None, truth, SessionOptions::default()).unwrap();
    for head in ["gap_min = -1.0", "gap_min = nan"] {
        assert!(Scenario::from_toml(&format!("{head}\nsteps = []")).unwrap().play(&mut session).is_err());
    }
    assert!(Scenario::from_toml("warming = \"resting\"\nsteps = []").is_err());
}

/// What was meant without an original: the mode of the originals, where a program has one.
#[test]
fn without_an_original_the_mode_says_what_was_meant() {
    let body = "PERS num tcMode:=-1;\nFUNC num tcK()\nIF tcMode=-2 RETURN 1;\nRETURN 2;\nENDFUNC\n\
                PROC main()\nMoveAbsJ jHome,v500,fine,tool0;\nMoveL p{tcK()},v100,fine,tool0;\nENDPROC";
    let text = module(body);
    let files = [("cell.mod", text.as_bytes())];
    let truth = TrueRobot::new(Robot::built_in("irb140").unwrap(), Deformation::paper());
    let mut session = Session::new(&files, None, truth, SessionOptions::default()).unwrap();
    session.at_minutes(&[0.0]).unwrap();
    let report = session.into_report();
    // The program goes to the second element, 30 mm beside the first.
    assert!((report.passes[0].after.max_m - 0.03).abs() < 1e-6, "{:?}", report.passes[0].after);
    assert!(report.passes[0].before.max_m < 1e-6 && report.passes[0].index.is_none());
    assert_eq!(report.efforts["tcK"].calls, 1);
}

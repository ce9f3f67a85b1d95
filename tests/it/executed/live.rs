//! The forms `live` and `auto` executed: targets that only the running program knows, and those that are known too.

use super::MINUTES;
use super::made::{Files, fixture, made_as, session, warmth};
use rapid_compensation::compensate::FormChoice;
use rapid_compensation::emit::restore;
use robot_model::deform::{Deformation, GrowthLaw};
use robot_model::units::{deg_from_rad, mm_from_m};
use virtual_controller::Report;

fn executed(form: FormChoice, original: &Files, deformation: &Deformation) -> (Files, usize, Report) {
    let (program, kept) = made_as(form, original, deformation, &warmth()).unwrap();
    let mut s = session(&program, original, deformation, false);
    s.at_minutes(&MINUTES).unwrap();
    (program, kept, s.into_report())
}

/// Worst distance, mm, and angle, degrees, of the corrected moves; every pass went as the original's.
fn worst(name: &str, report: &Report) -> (f64, f64) {
    assert_eq!(report.passes.len(), MINUTES.len());
    let (mut mm, mut deg) = (0.0_f64, 0.0_f64);
    for p in &report.passes {
        assert_eq!((&p.failure, &p.mismatch, p.unreached), (&None, &None, 0), "{name} at {}", p.t_min);
        mm = mm.max(mm_from_m(p.corrected.max_m));
        deg = deg.max(deg_from_rad(p.corrected.max_rad));
    }
    assert!(
        report.unknown_instructions.iter().all(|known| !known.to_lowercase().starts_with("tc")),
        "{name}"
    );
    (mm, deg)
}

#[test]
fn targets_that_only_the_running_program_knows_are_met() {
    let paper = Deformation::paper();
    let original = fixture("simulate/runtime.mod");
    for form in [FormChoice::Live, FormChoice::Auto] {
        let (program, kept, report) = executed(form, &original, &paper);
        let (mm, deg) = worst("runtime", &report);
        assert!(mm <= 5e-4 && deg <= 1e-4, "{form:?}: {mm} mm, {deg} deg");
        // The search alone stays as it is, and its move to where nothing is found is the one that is not corrected.
        assert_eq!(kept, 1, "{form:?}");
        assert_eq!(report.unchanged.len(), 1, "{:?}", report.unchanged);
        // The fixture stands on a quadrant's border with axis 4, where configurations are checked.
        let others =
            report.messages.iter().filter(|m| !m.text.contains("over the border of the quadrant that cf4"));
        assert_eq!(others.count(), 0, "{:?}", report.messages);
        let before = report.passes.last().unwrap().before.max_m;
        assert!(mm_from_m(before) > 0.1, "{before}");
        let text = String::from_utf8_lossy(&program[0].1).into_owned();
        for asked in [
            "MoveJ tcLive(Offs(pStart,20*i,15*j,20),tGun\\WObj:=wTable),v300",
            "MoveC tcLive(Offs(pStart,20,10+nPass,20),tGun\\WObj:=wTable),tcLiveSame(",
            "MoveAbsJ tcLiveJ(jTurn,tGun),v500",
            "MoveL tcLive(pCorner,tGun\\WObj:=wPart),v100",
        ] {
            assert!(text.contains(asked), "{form:?}: {asked}");
        }
        let row =
            if form == FormChoice::Auto { "MoveL tcAt(pRow{k},tcPRow{k})," } else { "MoveL tcLive(pRow{k}," };
        assert!(text.contains(row), "{form:?}: {row}");
        let restored = restore(&program[0].1).unwrap();
        assert!(restored.exact && restored.bytes == original[0].1, "{form:?}");
    }
}

#[test]
fn an_array_that_is_indexed_at_run_time_has_a_row_for_each_element() {
    let paper = Deformation::paper();
    let original = fixture("simulate/runtime.mod");
    for (form, asked) in [
        (FormChoice::Schedule, "MoveL tcpRow{k,tcK()},v100,z1,tGun\\WObj:=wTable;"),
        (FormChoice::Ramp, "MoveL tcAt(pRow{k},tcPRow{k}),v100,z1,tGun\\WObj:=wTable;"),
    ] {
        let (program, _, report) = executed(form, &original, &paper);
        let text = String::from_utf8_lossy(&program[0].1).into_owned();
        assert!(text.contains(asked), "{form:?}: {text}");
        let (mm, _) = worst("array", &report);
        assert!(mm <= if form == FormChoice::Schedule { 5.5e-3 } else { 5e-4 }, "{form:?}: {mm}");
        let restored = restore(&program[0].1).unwrap();
        assert!(restored.exact && restored.bytes == original[0].1, "{form:?}");
    }
}

#[test]
fn known_targets_are_met_by_the_model_too() {
    let paper = Deformation::paper();
    let three = robot_model::kinematics::FrameOffsets(paper.settled().0.map(|row| row.map(|x| 3.0 * x)));
    let three = Deformation::from_static(three, GrowthLaw::TwoStage { tau_min: 46.0 });
    for name in [
        "robodk/irc5/Cube45.mod",
        "robodk/irc5/Cube45_noconf.mod",
        "robodk/irc5/RichProg.mod",
        "simulate/cell.mod",
    ] {
        let original = fixture(name);
        let (_, _, report) = executed(FormChoice::Live, &original, &paper);
        let (mm, deg) = worst(name, &report);
        assert!(mm <= 5e-4 && deg <= 1e-4, "{name}: {mm} mm, {deg} deg");
    }
    let original = fixture("robodk/irc5/Cube45.mod");
    let (program, kept) =
        super::made::made_within(FormChoice::Live, &original, &three, &warmth(), 2e-3).unwrap();
    assert_eq!(kept, 0);
    let mut s = session(&program, &original, &three, false);
    s.at_minutes(&MINUTES).unwrap();
    let (mm, deg) = worst("three times", &s.into_report());
    assert!(mm <= 2e-3 && deg <= 5e-4, "{mm} mm, {deg} deg");
}

#[test]
fn an_old_controller_is_not_asked_for_what_it_lacks() {
    let mut original = fixture("simulate/runtime.mod");
    original[0].0 = "RUNTIME.PRG".to_owned();
    let (program, kept, _) = executed(FormChoice::Auto, &original, &Deformation::paper());
    let text = String::from_utf8_lossy(&program[0].1).into_owned();
    assert!(
        kept > 5 && !text.contains("CalcJointT") && !text.contains("tcLive") && !text.contains("TASK PERS")
    );
}

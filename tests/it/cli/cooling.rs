//! What is said of tables and models whose state after a pause no single clock can tell.

use super::changed_by_hand::module;
use super::{Bench, driftpost, err};

fn creep_beside(tau_min: u32, to_min: u32) -> String {
    format!(
        "format = 1\nrobot = \"ABB IRB 140-6/0.8\"\n\
         [[effect]]\neffect = \"base_drift\"\ngrowth = \"linear\"\nfrom_min = 0\nto_min = {to_min}\ndx_mm = 0.12\ndy_mm = 0.09\n\
         [[effect]]\neffect = \"thermal_joint_drift\"\njoint = 3\ngrowth = \"exp\"\ntau_min = {tau_min}\ndrift_deg = 0.02\n"
    )
}

/// All that is said of a program that is compensated so; its text is `o.mod`.
fn said(bench: &Bench, options: &[&str]) -> String {
    let source = module("CONST robtarget p20:=[[430,60,300],@;", "MoveL p20,v100,fine,tGun;");
    let (from, to) = (bench.file("a.mod", source), bench.path("o.mod").display().to_string());
    let given = ["compensate", &from, "-o", &to, "--form", "ramp", "--diff", "none", "--force"];
    let made = driftpost(&[&given, options].concat());
    assert_eq!(made.status.code(), Some(0), "{}", err(&made));
    err(&made)
}

/// The arm cools in a pause and a base that creeps does not come back: by one clock both do. 0.12 and 0.09 mm are 0.15 mm.
#[test]
fn a_creep_that_a_pause_would_take_back_is_told_with_its_size() {
    let bench = Bench::default();
    let model = bench.file("model.toml", creep_beside(46, 300));
    let warmth = said(&bench, &["--model", &model]);
    assert!(
        warmth.contains("warning[deform::creep-falls-back]: of the model base_drift (0.150 mm) creeps on"),
        "{warmth}"
    );
    let elapsed = said(&bench, &["--model", &model, "--clock", "elapsed"]);
    assert!(!elapsed.contains("creep-falls-back"), "{elapsed}");
}

/// A clock by a lag of three minutes would stand still after 228: what creeps to minute 600 stayed where it was then, 0.09 mm short.
#[test]
fn a_clock_lasts_as_long_as_what_creeps() {
    let bench = Bench::default();
    let model = bench.file("model.toml", creep_beside(3, 600));
    let text = said(&bench, &["--model", &model]);
    assert!(text.contains("warning[deform::no-single-law]"), "{text}");
    let [from, to] = ["a.mod", "o.mod"].map(|name| bench.path(name).display().to_string());
    let run = driftpost(&["simulate", &to, "--original", &from, "--minutes", "0:600:100", "--model", &model]);
    assert_eq!(run.status.code(), Some(0), "{}", super::out(&run));
}

/// Three rows that one lag of 30 minutes and two of 19 go through alike.
#[test]
fn rows_that_tell_no_law_are_told() {
    let bench = Bench::default();
    let rows = |minutes: &[f64]| -> String {
        let row = |t: &f64| format!("{t},2,0,0,0,0,{:.9},0\n", 0.03 * (1.0 - (-t / 30.0).exp()));
        "t_min,joint,dx_mm,dy_mm,dz_mm,rx_deg,ry_deg,rz_deg\n".to_owned()
            + &minutes.iter().map(row).collect::<String>()
    };
    let few = bench.file("few.csv", rows(&[0.0, 60.0, 120.0]));
    let text = said(&bench, &["--deformation", &few, "--tau-cool", "40"]);
    assert!(text.contains("warning[deform::few-rows]: few.csv: rows at 3 different minutes"), "{text}");
    let more = bench.file("more.csv", rows(&[0.0, 20.0, 60.0, 120.0]));
    let text = said(&bench, &["--deformation", &more, "--tau-cool", "40"]);
    assert!(!text.contains("few-rows"), "{text}");
}

/// A table that is there from the cold start on drifts beside nothing; and a law of one's own is called what it is.
#[test]
fn what_is_said_of_a_table_beside_a_model_is_true() {
    let bench = Bench::default();
    let model = bench.file("model.toml", creep_beside(46, 300));
    let table = "Dx [mm],Dy[mm],Dz[mm],DOx[deg],DOy[deg],DOz[deg]\n0,0,0,0,0,0\n0.05,0,0,0,0,0\n".to_owned();
    let table = bench.file("t.csv", table + &"0,0,0,0,0,0\n".repeat(4));
    let held = said(&bench, &["--model", &model, "--deformation", &table, "--growth", "none"]);
    assert!(!held.contains("model::drift-beside-table"), "{held}");
    let grown = said(&bench, &["--model", &model, "--deformation", &table, "--growth", "exp:46"]);
    assert!(grown.contains("model::drift-beside-table"), "{grown}");
}

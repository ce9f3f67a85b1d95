//! Files that `fit` reads and writes, and its model on the touches that it was fitted to.

use super::moved_together::{day, seen};
use assert_cmd::Command;
use measurements::Touches;

/// The same touches as a file.
fn written(touches: &Touches) -> String {
    let mut out =
        "pose_id,kind,fixed_id,t_min,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n".to_owned();
    for touch in &touches.touches {
        let joints = touch.q_rad.map(|q| format!("{:.6}", q.to_degrees())).join(",");
        let at_mm = touch.measured_m.unwrap() * 1e3;
        let place = <[f64; 3]>::from(at_mm).map(|mm| format!("{mm:.5}")).join(",");
        out += &format!("{},pose,,{},{joints},{place}\n", touch.point + 1, touch.t_min);
    }
    out
}

fn driftpost(args: &[&str]) -> (Option<i32>, String) {
    let output = Command::cargo_bin("driftpost").unwrap().args(args).output().unwrap();
    let answer =
        [output.stdout, output.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned()).concat();
    (output.status.code(), answer)
}

/// Nests among a tracker's poses are left out with their number; the fit is the same to the last digit.
#[test]
fn nests_among_the_poses_are_left_out_and_said_to_be() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).display().to_string();
    let text = written(&seen(&day(), 6, |_, at_m, _| at_m));
    let nests: String =
        (0..10).map(|k| format!("N1,base,N1,{},,,,,,,900.1,-1200.2,100.3\n", 20 * k)).collect();
    std::fs::write(at("poses.csv"), &text).unwrap();
    std::fs::write(at("both.csv"), text + &nests).unwrap();
    let fit = |name: &str| driftpost(&["fit", &at(name), "--tool", "30,-20,100"]);
    let (alone, both) = (fit("poses.csv"), fit("both.csv"));
    assert_eq!((alone.0, both.0), (Some(0), Some(0)), "{}", both.1);
    assert!(both.1.contains("10 rows of nests (kind = base) are left out"), "{}", both.1);
    assert!(both.1.contains(&alone.1), "{}{}", alone.1, both.1);
}

/// A model of a warm-up, on the touches that it was fitted to and on those behind the stop: as warm as the robot was then.
#[test]
fn a_model_is_put_to_the_test_with_the_stops_that_it_was_fitted_with() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).display().to_string();
    let rounds: Vec<f64> = day().into_iter().filter(|t_min| t_min % 10.0 == 0.0).collect();
    let text = written(&seen(&rounds, 8, |_, at_m, _| at_m));
    std::fs::write(at("all.csv"), &text).unwrap();
    let is_later =
        |row: &&str| row.split(',').nth(3).and_then(|t| t.parse::<f64>().ok()).is_none_or(|t| t > 150.0);
    std::fs::write(at("later.csv"), text.lines().filter(is_later).collect::<Vec<_>>().join("\n")).unwrap();
    let (code, answer) =
        driftpost(&["fit", &at("all.csv"), "--tool", "30,-20,100", "--model-out", &at("m.toml")]);
    assert_eq!(code, Some(0), "{answer}");
    let (model, json) = (at("m.toml"), at("v.json"));
    let rms_mm = |more: &[&str]| {
        let file = at(more[0]);
        let args = [&["validate", &file, "--model", &model, "--json", &json], &more[1..]].concat();
        let (code, answer) = driftpost(&args);
        let json: serde_json::Value = serde_json::from_slice(&std::fs::read(&json).unwrap()).unwrap();
        (code, json["rms_mm"].as_f64().unwrap(), json["nominal"]["rms_mm"].as_f64().unwrap(), answer)
    };
    // Noise of 0.01 mm a coordinate is 0.0173 in space.
    let (code, left_mm, nominal_mm, answer) = rms_mm(&["all.csv"]);
    assert!(
        code == Some(0) && left_mm < 0.02 && left_mm < 0.7 * nominal_mm,
        "{left_mm} {nominal_mm} {answer}"
    );
    assert!(answer.contains("the robot stood from minute 120 to 160, by the pause between rows"), "{answer}");
    let (_, named_mm, _, _) = rms_mm(&["all.csv", "--stop", "120:165"]);
    let (_, worked_mm, _, _) = rms_mm(&["all.csv", "--stop", "none"]);
    assert!(
        (named_mm - left_mm).abs() < 2e-3 && worked_mm > 1.2 * left_mm,
        "{named_mm} {left_mm} {worked_mm}"
    );
    let (_, _, _, late) = rms_mm(&["later.csv"]);
    assert!(late.contains("model::pause") && late.contains("the first row is at minute 170"), "{late}");
    let (code, left_mm, _, answer) = rms_mm(&["later.csv", "--stop", "120:165"]);
    assert!(code == Some(0) && left_mm < 0.02 && !answer.contains("model::pause"), "{left_mm} {answer}");
}

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
mod long {
    use super::*;

    /// What was edited by hand, and what is somebody else's, stays; the table that was written is read again.
    #[test]
    #[ignore = "long"]
    fn no_output_takes_the_place_of_what_it_did_not_write() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name).display().to_string();
        std::fs::write(at("poses.csv"), written(&seen(&day(), 7, |_, at_m, _| at_m))).unwrap();
        let fit =
            |more: &[&str]| driftpost(&[&["fit", &at("poses.csv"), "--tool", "30,-20,100"], more].concat());
        for (option, name) in
            [("--table-out", "drift.csv"), ("--model-out", "drift.toml"), ("--report", "page.html")]
        {
            let file = at(name);
            for _ in 0..2 {
                let (code, answer) = fit(&[option, &file]);
                assert_eq!(code, Some(0), "{option}: {answer}");
            }
            let other = "MODULE Somebody\nENDMODULE\n";
            let mut kept = vec![other.to_owned()];
            if name == "drift.csv" {
                let table = ["--deformation", &file, "--orient-deg", "0,90,0", "--minutes", "60"];
                let (code, answer) =
                    driftpost(&[&["tabulate", "fixtures/paper/targets45.csv"], &table[..]].concat());
                assert_eq!(code, Some(0), "{answer}");
            }
            let written = std::fs::read_to_string(&file).unwrap();
            match name {
                // A number typed in a table, and any line of a model.
                "drift.csv" => {
                    kept.push(format!("{},0.02\n", written.trim_end().rsplit_once(',').unwrap().0));
                }
                "drift.toml" => kept.push(written.replacen("0.0", "0.1", 1)),
                _ => {}
            }
            for text in kept {
                std::fs::write(&file, &text).unwrap();
                let (code, answer) = fit(&[option, &file]);
                assert!(code == Some(2) && answer.contains("output::changed"), "{option}: {answer}");
                assert_eq!(std::fs::read_to_string(&file).unwrap(), text, "{option}");
            }
            if name != "page.html" {
                assert_eq!(fit(&[option, &file, "--force"]).0, Some(0), "{option}");
            }
        }
        std::fs::write(at("measured.csv"), "id,x_mm\n1,2\n").unwrap();
        let (code, answer) = driftpost(&["plan", "--n", "20", "--csv", &at("measured.csv")]);
        assert!(code == Some(2) && answer.contains("output::changed"), "{answer}");
    }
}

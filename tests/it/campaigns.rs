//! Campaigns over a day or two, measured on virtual arms by another hand: what grows with the load, sways, or happens overnight.

use assert_cmd::Command;
use serde_json::Value;

fn diagnose(file: &str, robot: &str, sigma_mm: &str) -> Value {
    diagnose_with(file, robot, &["--sigma-mm", sigma_mm])
}

fn diagnose_with(file: &str, robot: &str, options: &[&str]) -> Value {
    let file = format!("{}/fixtures/measuring/campaigns/{file}", env!("CARGO_MANIFEST_DIR"));
    let arguments = ["diagnose", &file, "--robot", robot, "--json", "-"];
    let output = Command::cargo_bin("driftpost").unwrap().args(arguments).args(options).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

/// Drift over the night, or a step in it: from sixty rows of which none was measured then nothing can tell.
#[test]
fn what_happens_overnight_is_a_step_or_a_drift() {
    let found = diagnose("step_overnight.csv", "irb140", "0.04");
    assert_eq!(found["verdict"], "ambiguous", "{}", found["reason"]);
    let posterior = |effect: &str| {
        let causes = found["causes"].as_array().unwrap();
        let of = causes.iter().find(|cause| cause["effect"] == effect && cause["joint"] == 2);
        of.map_or(0.0, |cause| cause["posterior"].as_f64().unwrap())
    };
    let (step, drift) = (posterior("joint_step"), posterior("thermal_joint_drift"));
    assert!(step > 0.1 && drift > 0.1 && step + drift > 0.9, "{step} {drift}");
}

/// Errors of the geometry take most of the gap; the sway is on top of the noise that is stated.
#[test]
fn what_sways_is_structure_beside_geometry() {
    let found = diagnose("sway.csv", "irb2600", "0.03");
    assert_eq!(found["verdict"], "unexplained_structure", "{}", found["reason"]);
    assert_eq!(found["where"]["time"], "drift", "{}", found["where"]);
}

/// Joint 3 of an IRB 140 warms up with 40 minutes, and cools with 60 in a pause of 40 minutes: without a law of cooling it was nothing above
/// the noise, with a gap of three times the noise.
#[test]
fn an_arm_that_stood_in_a_pause_has_cooled() {
    let found = diagnose("standstill.csv", "irb140", "0.03");
    assert_eq!(found["verdict"], "explained", "{}", found["reason"]);
    let first = &found["causes"][0];
    assert_eq!((&first["effect"], &first["joint"]), (&"thermal_joint_drift".into(), &3.into()));
    let warnings = found["warnings"].as_array().unwrap();
    assert!(warnings.iter().any(|w| w["code"] == "diagnose::standstill"), "{warnings:?}");
}

/// Twelve poses in six rounds without times; from line 33 on the target sits 3 mm elsewhere on the flange. Its turn with the flange hid that, and
/// the repeats were taken for noise of 0.9 mm.
#[test]
fn a_target_that_was_moved_between_rounds_is_no_noise() {
    let found = diagnose("tool_moved.csv", "irb1600-1.45", "0.03");
    assert_eq!(found["verdict"], "explained", "{}", found["reason"]);
    let first = &found["causes"][0];
    assert_eq!((&first["effect"], &first["from_line"]), (&"tool_step".into(), &33.into()));
}

/// A shape of no cause with corners: gear lines that are fitted to it make a region that is held out worse by half.
#[test]
fn what_makes_a_region_worse_is_no_model() {
    let folder = tempfile::tempdir().unwrap();
    let model = folder.path().join("model.toml");
    let file = format!("{}/fixtures/measuring/campaigns/corners.csv", env!("CARGO_MANIFEST_DIR"));
    let arguments = ["diagnose", &file, "--robot", "crb15000-5", "--json", "-", "--model-out"];
    let output = Command::cargo_bin("driftpost").unwrap().args(arguments).arg(&model).output().unwrap();
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(found["verdict"], "unexplained_structure", "{}", found["reason"]);
    let why = found["no_model"].as_str().unwrap_or_default();
    assert!(why.contains("at poses held out it leaves 0.524 mm of 0.340 mm"), "{why}");
    assert!(output.status.code() == Some(2) && !model.exists());
}

/// A joint that gives, and a target that creeps, by more than one law has it: beside the nearest time constant of those that are looked at first structure over
/// time is likelier than the creep by more than a double holds, and the creep was in the model and in no list.
#[test]
fn what_the_model_holds_is_listed() {
    let found = diagnose_with("creep_and_spring.csv", "irb2600", &["--tool", "-133,-36,55"]);
    assert_eq!(found["verdict"], "several", "{}", found["reason"]);
    let causes = found["causes"].as_array().unwrap();
    let named: Vec<(&str, f64)> = causes
        .iter()
        .map(|cause| (cause["effect"].as_str().unwrap(), cause["posterior"].as_f64().unwrap()))
        .collect();
    assert!(named.iter().all(|(_, posterior)| *posterior > 0.9), "{named:?}");
    assert_eq!([named[0].0, named[1].0], ["tool_drift", "joint_compliance"]);
    assert_eq!(named.len(), 2);
}

/// A synthetic set's rows with these minutes in the place of its own, in their order, and without temperatures, which go by themselves.
fn at_minutes(effects: &str, seed: &str, minutes: impl Fn(usize, f64) -> f64) -> String {
    let folder = tempfile::tempdir().unwrap();
    let sets = folder.path().join("sets");
    let arguments = ["--effects", effects, "--n", "140", "--seed", seed];
    Command::cargo_bin("driftpost").unwrap().arg("synth").arg(&sets).args(arguments).assert().success();
    let text = std::fs::read_to_string(sets.join("set_0000/measurements.csv")).unwrap();
    let (header, rows) = text.split_once('\n').unwrap();
    let names: Vec<&str> = header.split(',').collect();
    let kept = |cells: &[&str]| -> Vec<String> {
        let kept = cells.iter().zip(&names).filter(|(_, name)| !name.starts_with("temp"));
        kept.map(|(cell, _)| (*cell).to_owned()).collect()
    };
    let header = kept(&names);
    let at = header.iter().position(|name| name == "t_min").unwrap();
    let moved = rows.lines().enumerate().map(|(k, line)| {
        let mut cells = kept(&line.split(',').collect::<Vec<_>>());
        let t_min = minutes(k, cells[at].parse().unwrap());
        cells[at] = format!("{t_min:.3}");
        (t_min, cells.join(","))
    });
    let mut moved: Vec<(f64, String)> = moved.collect();
    moved.sort_by(|a, b| a.0.total_cmp(&b.0));
    let rows: String = moved.into_iter().map(|(_, row)| row + "\n").collect();
    format!("{}\n{rows}", header.join(","))
}

/// The minutes of a file's rows.
fn minutes_of(text: &str) -> impl Iterator<Item = f64> {
    let at = text.lines().next().unwrap().split(',').position(|name| name == "t_min").unwrap();
    text.lines().skip(1).map(move |line| line.split(',').nth(at).unwrap().parse().unwrap())
}

/// A file with its points shifted along x and y, mm, as each row's minute has it.
fn shifted(text: &str, by_mm: impl Fn(f64) -> [f64; 2]) -> String {
    let (header, rows) = text.split_once('\n').unwrap();
    let at = |name: &str| header.split(',').position(|other| other == name).unwrap();
    let rows = rows.lines().zip(minutes_of(text)).map(|(line, t_min)| {
        let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
        for (name, by_mm) in ["x_mm", "y_mm"].into_iter().zip(by_mm(t_min)) {
            let there_mm: f64 = cells[at(name)].parse().unwrap();
            cells[at(name)] = format!("{:.4}", there_mm + by_mm);
        }
        cells.join(",") + "\n"
    });
    format!("{header}\n{}", rows.collect::<String>())
}

/// Of 700 gaps the search tries every third at first: the row from which the target stands elsewhere is the first all the same, and no good row is
/// set aside.
#[test]
fn a_step_in_a_long_file_is_in_its_own_gap() {
    let folder = tempfile::tempdir().unwrap();
    let sets = folder.path().join("sets");
    let arguments = ["--effects", "joint_offset:3", "--n", "700", "--seed", "11"];
    Command::cargo_bin("driftpost").unwrap().arg("synth").arg(&sets).args(arguments).assert().success();
    let text = std::fs::read_to_string(sets.join("set_0000/measurements.csv")).unwrap();
    for line in [302, 303, 304] {
        // Line 1 is the header.
        let from_min = minutes_of(&text).nth(line - 2).unwrap();
        let text = shifted(&text, |t_min| if t_min >= from_min { [0.4, -0.2] } else { [0.0, 0.0] });
        let found = crate::sound_file::diagnose(text.as_bytes(), &[]);
        let answer = found.json.as_ref().unwrap();
        let step = answer["causes"].as_array().unwrap().iter().find(|cause| cause["effect"] == "base_step");
        assert_eq!(step.unwrap()["from_line"], line, "{}", answer["reason"]);
        assert_eq!(answer["false_rows"], serde_json::json!([]), "{}", answer["reason"]);
    }
}

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
mod long {
    use super::*;

    /// Friction grows with the load, play does not.
    #[test]
    #[ignore = "long"]
    fn friction_is_no_play() {
        let found = diagnose("friction.csv", "irb2600", "0.05");
        assert_eq!(found["verdict"], "unexplained_structure", "{}", found["reason"]);
        assert_eq!(found["where"]["joint"], 2);
        assert!(found["reason"].as_str().unwrap().contains("gravity's torque"), "{}", found["reason"]);
        // Orientation says little of it, and halves what a sigma over all six numbers says.
        let found = diagnose("friction_with_orientation.csv", "irb6700", "0.04");
        assert_eq!(found["verdict"], "unexplained_structure", "{}", found["reason"]);
        assert!(found["reason"].as_str().unwrap().contains("gravity's torque"), "{}", found["reason"]);
        let found = diagnose("play.csv", "irb140", "0.05");
        assert_eq!(found["verdict"], "explained", "{}", found["reason"]);
        let first = &found["causes"][0];
        assert_eq!((&first["effect"], &first["joint"]), (&"backlash".into(), &2.into()));
    }

    /// Every other row on the next day, as long behind a cold start as it was: the file's clock goes on over the night, the arm is cold
    /// again.
    #[test]
    #[ignore = "long"]
    fn an_arm_that_is_cold_again_after_a_night_warms_up_anew() {
        for seed in ["3", "4"] {
            let next_day = |k: usize, t_min: f64| t_min + if k.is_multiple_of(2) { 0.0 } else { 1500.0 };
            let text = at_minutes("thermal_joint_drift:2", seed, next_day);
            let found = crate::sound_file::diagnose(text.as_bytes(), &[]);
            let answer = found.json.as_ref().unwrap();
            let first = &answer["causes"][0];
            assert_eq!(
                (&first["effect"], &first["joint"]),
                (&"thermal_joint_drift".into(), &2.into()),
                "{answer}"
            );
            assert_eq!(answer["verdict"], "explained", "{}", answer["reason"]);
            let warnings = answer["warnings"].as_array().unwrap();
            assert!(warnings.iter().any(|w| w["code"] == "diagnose::cold-start"), "{warnings:?}");
            // All in one day nothing begins anew.
            let found = crate::sound_file::diagnose(
                at_minutes("thermal_joint_drift:2", seed, |_, t| t).as_bytes(),
                &[],
            );
            assert!(!found.json.unwrap()["warnings"].to_string().contains("cold-start"));
        }
    }

    /// A base that creeps with 45 min while the arm works and goes back with 45 while it stands for an hour: a pause with a drift, and neither a step nor
    /// structure.
    #[test]
    #[ignore = "long"]
    fn a_base_that_goes_back_in_a_pause_has_drifted() {
        const TAU_MIN: f64 = 45.0;
        let pause_min = [55.0, 115.0];
        let later = |_, t_min: f64| if t_min > pause_min[0] { t_min + 60.0 } else { t_min };
        let grown = |t_min: f64| {
            let before = 1.0 - (-t_min.min(pause_min[0]) / TAU_MIN).exp();
            if t_min < pause_min[1] {
                return before;
            }
            let cooled = before * (-60.0_f64 / TAU_MIN).exp();
            1.0 - (1.0 - cooled) * (-(t_min - pause_min[1]) / TAU_MIN).exp()
        };
        let text = shifted(&at_minutes("joint_compliance:2", "5", later), |t_min| {
            [0.5, -0.3].map(|most_mm| most_mm * grown(t_min))
        });
        let found = crate::sound_file::diagnose(text.as_bytes(), &[]);
        let causes = found.causes();
        assert!(causes.contains(&"base_drift") && causes.contains(&"joint_compliance"), "{causes:?}");
        assert!(!causes.contains(&"base_step") && !causes.contains(&"tool_step"), "{causes:?}");
        let warnings = found.json.as_ref().unwrap()["warnings"].to_string();
        assert!(warnings.contains("diagnose::standstill"), "{warnings}");
    }

    /// A base that settles within a thirtieth of the measurement, by a millimetre: what time constants too far from its own leave is no step.
    #[test]
    #[ignore = "long"]
    fn a_base_that_settles_soon_has_not_stepped() {
        for seed in ["5", "6"] {
            let text = at_minutes("joint_compliance:2", seed, |_, t_min| t_min);
            let last_min = minutes_of(&text).fold(0.0, f64::max);
            let text = shifted(&text, |t_min| {
                [0.9, -0.5].map(|most_mm| most_mm * (1.0 - (-t_min / (0.035 * last_min)).exp()))
            });
            let found = crate::sound_file::diagnose(text.as_bytes(), &[]);
            let causes = found.causes();
            assert_eq!(causes[0], "base_drift", "{causes:?}");
            assert!(!causes.contains(&"base_step") && !causes.contains(&"tool_step"), "{causes:?}");
        }
    }
}

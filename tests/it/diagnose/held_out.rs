//! What is left of poses held out is what the model leaves of poses that it was not fitted to.

use super::{diagnose, synth, verdict};

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
mod long {
    use super::*;

    /// A base, a joint's zero or a target that jumps by some tenths of a millimetre after a quarter of the rows. The poses held out next to the jump
    /// say nothing of others: what is left is the noise.
    #[test]
    #[ignore = "long"]
    fn a_step_leaves_the_noise_of_poses_held_out() {
        for effect in ["base_step:40", "joint_step:2:40", "tool_step:40"] {
            let folder = tempfile::tempdir().unwrap();
            let csv = synth(folder.path(), &["--effects", effect, "--n", "100", "--rho", "4", "--seed", "3"]);
            let (_, text, found) = diagnose(csv.as_bytes(), &["--sigma-mm", "0.02"]);
            assert_eq!(verdict(&found), "explained", "{effect}: {text}");
            let shrink = &found.unwrap()["shrink"];
            let [before, after, floor] =
                ["before_rms_mm", "after_rms_mm", "floor_rms_mm"].map(|key| shrink[key].as_f64().unwrap());
            // One row of 100 on the wrong side would leave 0.04 mm of all and more.
            assert!(
                before > 0.12 && after < 1.1 * floor,
                "{effect}: {before} mm before, {after} after, noise {floor}"
            );
        }
    }

    /// A gear off centre and two lines of its teeth, and no other: the model of every other row leaves of the others little more than the noise,
    /// as it says of poses held out. A spectrum of eighty lines in their place left twice and three times as much.
    #[test]
    #[ignore = "long"]
    fn a_gear_of_three_lines_is_written_as_these() {
        for seed in ["1", "2"] {
            let folder = tempfile::tempdir().unwrap();
            let effects = "gear_eccentricity:1,gear_mesh:1:11,gear_mesh:1:24";
            let csv = synth(folder.path(), &["--effects", effects, "--n", "400", "--seed", seed]);
            let rows: Vec<&str> = csv.lines().skip(1).collect();
            let part = |odd: usize| {
                let rows = rows.iter().skip(odd).step_by(2).map(|row| format!("{row}\n"));
                format!("{}\n{}", csv.lines().next().unwrap(), rows.collect::<String>())
            };
            let path = |name: &str| folder.path().join(name).display().to_string();
            let (fitted, others, model, json) =
                (path("fitted.csv"), path("others.csv"), path("model.toml"), path("result.json"));
            std::fs::write(&fitted, part(0)).unwrap();
            std::fs::write(&others, part(1)).unwrap();
            let run = |arguments: &[&str]| -> serde_json::Value {
                let mut command = assert_cmd::Command::cargo_bin("driftpost").unwrap();
                command.args(arguments).args(["--robot", "irb140", "--json", &json]).assert().success();
                serde_json::from_slice(&std::fs::read(&json).unwrap()).unwrap()
            };
            let found = run(&["diagnose", &fitted, "--sigma-mm", "0.02", "--model-out", &model]);
            let lines = found["causes"].as_array().unwrap().iter().filter(|cause| !cause["n"].is_null());
            assert!(lines.count() >= 3, "{seed}: {found:#}");
            let held_out_mm = found["shrink"]["after_rms_mm"].as_f64().unwrap();
            let validated = run(&["validate", &others, "--model", &model]);
            let left_mm = validated["rms_mm"].as_f64().unwrap();
            // The root mean square of 3-D noise of 0.02 mm is 0.0346 mm.
            assert!(left_mm < 1.2 * 0.0346 && left_mm < 1.2 * held_out_mm, "{seed}: {left_mm} {held_out_mm}");
        }
    }
}

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
}

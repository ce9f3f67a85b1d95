//! Joints written with too few decimals.

use super::{Candidate, Effect, Form, Motion, Scene, Site};

/// Joints in the file are rounded: uniform errors of each joint, looked for by the data checks.
pub struct JointRounding;

impl Effect for JointRounding {
    fn name(&self) -> &'static str {
        "joint_rounding"
    }
    fn unit(&self) -> &'static str {
        "rad"
    }
    fn usual(&self) -> &'static str {
        "0.1 deg gives about 0.5 mm"
    }
    fn source(&self) -> &'static str {
        "uniform rounding error, variance step^2 / 12"
    }
    /// None: it is a fault of the file, looked for before any effect.
    fn candidates(&self, _scene: &Scene) -> Vec<Candidate> {
        Vec::new()
    }
    fn motions(&self, _form: &Form, _scene: &Scene, _site: &Site, _out: &mut Vec<Motion>) {}
}

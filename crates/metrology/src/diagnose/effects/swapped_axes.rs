//! Two measured axes swapped, or one mirrored.

use super::{Candidate, Effect, Form, Motion, Scene, Site};

/// Measured points are mirrored, looked for by the data checks.
pub struct SwappedAxes;

impl Effect for SwappedAxes {
    fn name(&self) -> &'static str {
        "swapped_axes"
    }
    fn unit(&self) -> &'static str {
        "1"
    }
    fn usual(&self) -> &'static str {
        "hundreds of mm"
    }
    fn source(&self) -> &'static str {
        "a mirror is no rigid motion"
    }
    /// None: it is a fault of the file, looked for before any effect.
    fn candidates(&self, _scene: &Scene) -> Vec<Candidate> {
        Vec::new()
    }
    fn motions(&self, _form: &Form, _scene: &Scene, _site: &Site, _out: &mut Vec<Motion>) {}
}

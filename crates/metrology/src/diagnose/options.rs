//! What a diagnosis is given beside the measurements.

use nalgebra::Vector3;

/// What the caller knows beside the file.
#[derive(Clone, Copy, Debug, Default)]
pub struct DiagnosisOptions {
    /// Place of the target in the flange's frame, to about 1 mm.
    pub tool_m: Option<Vector3<f64>>,
    /// Noise of one coordinate as stated; repeats in the file count beside it.
    pub sigma_m: Option<f64>,
}

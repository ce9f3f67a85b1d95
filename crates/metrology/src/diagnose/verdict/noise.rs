//! Scatter that the model does not know, and noise that is only slow.

use super::size::rms;
use crate::diagnose::evidence::Background;
use crate::diagnose::kernel::Kernel;
use crate::diagnose::linearise::{Linear, norm3};
use crate::diagnose::model::{Model, solve};
use crate::diagnose::scatter::{self, JointScatter};
use crate::diagnose::search::{Chosen, flat};

/// A reduced chi-square above this against the repeats is scatter that the model does not know.
const SCATTER: f64 = 1.5;
/// Scatter beyond a noise that is only stated, not seen in repeats, counts from this reduced chi-square on.
const STATED_SCATTER: f64 = 2.8;
/// Few repeats may by chance show less noise than there is: scatter counts from where that happens two times in a
/// thousand (normal quantile).
const BY_CHANCE: f64 = 2.878;
/// Structure left that is larger than this share of the causes makes them doubtful.
pub const LEFT_OVER: f64 = 0.5;
/// [`slow_noise`] in words.
pub const SLOW_NOISE: &str = "no effect of the library stands out of the noise; rows measured one after the other share \
     part of it, but together they scatter no more than the noise allows";

/// Scatter that the model does not know.
#[derive(Clone, Copy, Debug)]
pub struct Scatter {
    /// Reduced chi-square against the noise, where it is too large.
    pub chi: Option<f64>,
    /// Along a joint.
    pub along: Option<JointScatter>,
}

impl Scatter {
    /// Whether it is not small against what the causes take.
    #[must_use]
    pub fn rivals(&self, model: &Model<'_>, linear: &Linear, cause_rms_m: f64) -> bool {
        self.along.is_some_and(|a| a.rms_m > LEFT_OVER * cause_rms_m)
            || self.chi.is_some() && excess_m(model, linear) > LEFT_OVER * cause_rms_m
    }

    /// In words.
    #[must_use]
    pub fn reason(&self) -> String {
        let what = match (self.along, self.chi) {
            (Some(a), _) => format!("poses scatter along joint {}", a.joint + 1),
            (None, Some(chi)) => format!("poses scatter {:.1} times as much as the noise allows", chi.sqrt()),
            (None, None) => "poses scatter".to_owned(),
        };
        format!("{what}, and nothing that is recorded explains it: a channel is missing")
    }
}

/// Scatter of the residuals along a joint.
#[must_use]
pub fn joint_scatter(model: &Model<'_>, linear: &Linear) -> Option<JointScatter> {
    let atoms: Vec<usize> = (0..model.design.atoms()).collect();
    let background = Background::new(&model.design, &atoms, &flat(&model.chosen, None), model.noise);
    // Orientation has rows of its own; half of the parameters are then the points'.
    let share = 3.0 / linear.scene.rows_per_site as f64;
    let used = share * background.parameters(model.reached.geometry_ratio);
    scatter::along_joints(
        &linear.scene,
        &model.residuals,
        &model.base_weights,
        &model.outliers,
        &model.noise,
        used,
    )
}

/// Scatter beyond the noise as known, 3-D rms, metres.
fn excess_m(model: &Model<'_>, linear: &Linear) -> f64 {
    let Some((sigma_m, _)) = model.noise.known else { return 0.0 };
    let kept: Vec<f64> = model
        .residuals
        .iter()
        .zip(&model.outliers)
        .filter(|(_, out)| !**out)
        .map(|(m, _)| norm3(m))
        .collect();
    let expected = linear.scene.sites.iter().map(|s| 3.0 * sigma_m.powi(2) / s.repeats as f64).sum::<f64>()
        / linear.scene.sites.len() as f64;
    (rms(&kept).powi(2) - expected).max(0.0).sqrt()
}

/// Scatter about a model of `chosen` over what the repeats allow, and the limit for as many repeats as there are.
#[must_use]
pub fn reduced_chi_square(model: &Model<'_>, linear: &Linear, chosen: &[Chosen]) -> Option<(f64, f64)> {
    let (sigma_m, freedom) = model.noise.known?;
    let atoms: Vec<usize> = (0..model.design.atoms()).collect();
    let background = Background::new(&model.design, &atoms, &flat(chosen, None), model.noise);
    let ratio = background.null().geometry_ratio;
    let fit = solve(&model.design, &atoms, chosen, Some(ratio));
    let mut sum = 0.0;
    let mut rows = 0.0;
    let residuals = model.design.residuals(&fit.coefficients);
    for ((m, site), out) in residuals.iter().zip(&linear.scene.sites).zip(&model.outliers) {
        if !*out {
            sum += norm3(m).powi(2) * site.repeats as f64;
            rows += site.rows(3) as f64;
        }
    }
    let free: f64 = (rows - background.parameters(ratio)).max(6.0);
    let spread = 1.5 * (2.0 / freedom + 2.0 / free).sqrt();
    let limit = if model.noise.seen {
        (SCATTER + spread).max(variance_ratio(BY_CHANCE, free, freedom))
    } else {
        STATED_SCATTER + spread
    };
    Some((sum / (sigma_m * sigma_m) / free, limit))
}

/// The ratio of two estimates of one variance, of `above` and `below` degrees of freedom, that is exceeded as often as a
/// normal variate exceeds `z` (Paulson 1942, An approximate normalization of the analysis of variance distribution).
fn variance_ratio(z: f64, above: f64, below: f64) -> f64 {
    let (a, b) = (2.0 / (9.0 * above), 2.0 / (9.0 * below));
    let square = (1.0 - b).powi(2) - z * z * b;
    if square <= 0.0 {
        return f64::INFINITY; // so few repeats tell nothing of the noise
    }
    let middle = (1.0 - a) * (1.0 - b);
    let root = (middle * middle - square * ((1.0 - a).powi(2) - z * z * a)).max(0.0).sqrt();
    ((middle + root) / square).powi(3)
}

/// Whether `kernel` is only noise that is slow: the same for neighbouring rows, but all in all, with no cause
/// in the model, no larger than the repeats or the statement say.
#[must_use]
pub fn slow_noise(model: &Model<'_>, linear: &Linear, kernel: usize) -> bool {
    let over_time =
        matches!(model.library.kernels[kernel].kernel, Kernel::Time | Kernel::TimeFine | Kernel::ToolTime);
    over_time
        && linear.scene.time_min.is_some()
        && reduced_chi_square(model, linear, &[]).is_some_and(|(value, limit)| value <= limit)
}

#[cfg(test)]
mod tests {
    use super::variance_ratio;

    /// Upper 1 % and 5 % points of F as tables of the distribution give them.
    #[test]
    fn ratios_are_those_of_the_f_tables() {
        for (z, above, below, table) in [
            (2.326_348, 120.0, 20.0, 2.52),
            (2.326_348, 10.0, 10.0, 4.85),
            (2.326_348, 60.0, 120.0, 1.66),
            (1.644_854, 20.0, 30.0, 1.93),
        ] {
            let found = variance_ratio(z, above, below);
            assert!((found / table - 1.0).abs() < 0.015, "{above} {below}: {found}");
        }
        assert_eq!(variance_ratio(2.878, 100.0, 1.0), f64::INFINITY);
    }
}

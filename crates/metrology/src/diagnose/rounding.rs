//! Joints written with too few decimals: their rounding error seen in the scatter.

use super::angle_grid::AngleGrid;
use super::dataset::{Dataset, Observation, Twist};
use super::evidence::NuisanceModel;
use super::linear_fit::solve;
use super::measured_robot::MeasuredRobot;
use super::model::FittedModel;
use measurements::{Fault, FaultKind};
use nalgebra::{Matrix3, Vector3};
use rapid_syntax::diagnostic::is_or_are;
use robot_model::units::{mm_from_m, rad_from_deg};
use std::collections::BTreeMap;

/// Steps that people command poses in: their being common to all joints proves nothing.
const COMMANDED_DEG: [f64; 4] = [1.0, 0.5, 0.1, 0.01];
/// A step that nobody commands in need not show so clearly, nats.
const ODD_NATS: f64 = 1.0;
/// A joint's value in more than this share of the stations is a posture.
const OFTEN: f64 = 0.2;
/// Rounding must be likelier than plain noise by so much, nats.
const CLEAR_NATS: f64 = 8.0;
/// Where the scatter is so many times what is stated or repeated, and as large as the rounding would make it within a factor of two
/// either way, the size speaks for rounding as well: plain noise could have any.
const MORE_SCATTER: f64 = 3.0;
const BY_SIZE_NATS: f64 = 2.5;
/// Scatter without any cause that is what rounding makes, as a variance, within this factor, is as large.
const SAME_SIZE: f64 = 1.6;
/// Without any cause rounding is the whole of what is left, as a variance: more than so many times what it makes beside the noise, and other
/// things are in it.
const MOST_SCATTER: f64 = 9.0;

/// What else is known of the file, which decides how clearly rounding has to show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FaultPrior {
    /// Nothing else speaks against the file.
    NoOtherFault,
    /// What the model follows at the poses measured it does not follow at poses held out.
    FollowedHereAlone,
    /// The file is wrong; the question is in which column.
    KnownFault,
}

/// Whether the joints' decimals explain the scatter better than plain noise.
///
/// Joints commanded at round angles carry no rounding error: coarse decimals alone prove nothing.
#[must_use]
pub(super) fn find(
    measured: MeasuredRobot<'_>,
    fitted: &FittedModel<'_>,
    prior: FaultPrior,
) -> Option<Fault> {
    let all_seen = fitted.linear.dataset.observations.iter().all(|s| s.rows(3) == 3);
    if !all_seen {
        return None;
    }
    let of_grid = |grid: AngleGrid| on_grid(measured, fitted, prior, &grid);
    AngleGrid::of(measured.measurements)
        .and_then(of_grid)
        .or_else(|| AngleGrid::in_part(measured.measurements).and_then(of_grid))
}

/// The same of the joints and rows of `grid`.
fn on_grid(
    measured: MeasuredRobot<'_>,
    fitted: &FittedModel<'_>,
    prior: FaultPrior,
    grid: &AngleGrid,
) -> Option<Fault> {
    let FittedModel { linear, model, workspace } = fitted;
    let in_rounded_rows = in_rounded_rows(measured, grid);
    // Nobody commands one joint in round steps and the others to the last decimal.
    let all_joints = grid.rows.is_none() && grid.joints.len() == linear.dataset.turning().count();
    let proves_nothing =
        all_joints && COMMANDED_DEG.contains(&grid.step_deg) && prior != FaultPrior::KnownFault;
    let clear_nats = if proves_nothing { CLEAR_NATS } else { ODD_NATS };
    let known_m2 = model.noise.known.map(|known| known.sigma_m.powi(2));
    // One false reading would decide by where it happens to lie; in a part of the rows what is rounded there is what seems false.
    let of_part = |i: usize| grid.rows.is_some() && in_rounded_rows[i];
    let left_out: Vec<bool> =
        model.outliers.iter().enumerate().map(|(i, is_outlier)| *is_outlier && !of_part(i)).collect();
    let scatter = RoundedScatter::of(&linear.dataset, &left_out, (grid, &in_rounded_rows), known_m2);
    let points = |twists: &[Twist]| -> Vec<Vector3<f64>> {
        let kept = twists.iter().zip(&left_out).filter(|(_, is_left_out)| !**is_left_out);
        kept.map(|(m, _)| Vector3::new(m[0], m[1], m[2])).collect()
    };
    // Rounding looks like many gear lines to joints moved one at a time: it is tried without any cause, too.
    let groups = workspace.design.all_groups();
    let ratio = NuisanceModel::new(&workspace.design, &groups, &[], model.noise).null().geometry_ratio;
    let bare = points(
        &workspace.design.residuals(&solve(&workspace.design, &groups, &[], Some(ratio)).coefficients),
    );
    let best = points(&model.residuals);
    let expected_m2 = scatter.expected_m2();
    // Lines of a gear follow the rounding of joints that stood at few angles: what they take is weighed with their price.
    let gain_nats = scatter.rounded(&bare) - scatter.plain(&bare);
    let best_m2 = scatter.mean_square(&best);
    let as_large = best_m2 < 4.0 * expected_m2 && 4.0 * best_m2 > expected_m2;
    let contradicted =
        model.noise.known.is_some_and(|known| best_m2 > (MORE_SCATTER * known.sigma_m).powi(2));
    let clear_nats = if as_large && contradicted { clear_nats.min(BY_SIZE_NATS) } else { clear_nats };
    let plain_m2 = scatter.mean_square(&bare);
    let without_causes = gain_nats > clear_nats
        && gain_nats > fitted.log_odds()
        && plain_m2 < MOST_SCATTER * (expected_m2 + known_m2.unwrap_or(0.0));
    // Many lines of a gear follow some dozens of rounded angles as closely as one likes: the size of the scatter, which nothing was fitted
    // to, speaks louder where one column alone has so few decimals.
    let one_column = prior == FaultPrior::FollowedHereAlone
        && !all_joints
        && gain_nats > CLEAR_NATS
        && (1.0 / SAME_SIZE..SAME_SIZE).contains(&(plain_m2 / (expected_m2 + known_m2.unwrap_or(0.0))));
    let beside_causes =
        best_m2 > 0.3 * expected_m2 && scatter.rounded(&best) > scatter.plain(&best) + clear_nats;
    if plain_m2 < 0.3 * expected_m2 {
        return None;
    }
    (without_causes || one_column || beside_causes)
        .then(|| rounded_joints(grid, measured, [expected_m2, plain_m2]))
}

/// Whether each station has all its rows where the joints of `grid` are on it.
fn in_rounded_rows(measured: MeasuredRobot<'_>, grid: &AngleGrid) -> Vec<bool> {
    let stations = measured.stations.stations.iter();
    stations
        .map(|station| {
            grid.rows.as_ref().is_none_or(|rows| station.rows.iter().all(|row| rows.contains(row)))
        })
        .collect()
}

/// The fault itself; by what the rounding moves a coordinate, and by what it scatters, m^2.
fn rounded_joints(grid: &AngleGrid, measured: MeasuredRobot<'_>, squares_m2: [f64; 2]) -> Fault {
    let MeasuredRobot { robot, measurements, .. } = measured;
    let [rounding_mm, scatter_mm] = squares_m2.map(|m2| mm_from_m((3.0 * m2).sqrt()));
    let step_deg = grid.step_deg;
    let columns = grid.columns(robot);
    let all_joints = grid.joints.len() == robot.joints.iter().filter(|joint| !joint.kind.slides()).count();
    let rounded = match all_joints {
        true => "the joints are".to_owned(),
        false => format!("{columns} alone {}", is_or_are(grid.joints.len())),
    };
    let so = format!(
        "rounded to {step_deg} deg, which moves the points by {rounding_mm:.3} mm rms, and they scatter ({scatter_mm:.3} mm) as that rounding \
         makes them: take them from the controller with all their digits, 3 decimals at least"
    );
    let Some(rows) = &grid.rows else {
        return Fault::of_all(FaultKind::RoundedJoints, Some(&columns), format!("{rounded} {so}"));
    };
    let lines = measurements.rows.get(rows.clone()).unwrap_or_default().iter().map(|row| row.line).collect();
    Fault::in_rows(FaultKind::RoundedJoints, &columns, lines, |count, which| {
        format!("in {count} rows ({which}) {rounded} {so}")
    })
}

/// What rounding joints does to the measured points, and how likely residuals are with it and without.
struct RoundedScatter {
    /// Covariance of each observation's point that is not set aside, m^2.
    shapes: Vec<Matrix3<f64>>,
    /// The variance of one coordinate's noise where it is known, m^2.
    known_m2: Option<f64>,
}

impl RoundedScatter {
    /// Of the observations that are not `left_out`, those of which `rounded` says so on a grid.
    fn of(
        dataset: &Dataset,
        left_out: &[bool],
        (grid, rounded): (&AngleGrid, &[bool]),
        known_m2: Option<f64>,
    ) -> Self {
        // Uniform over one step.
        let variance = rad_from_deg(grid.step_deg).powi(2) / 12.0;
        // A value that comes again and again is rounded the same way each time: that is structure, not scatter.
        let mut times: BTreeMap<(usize, u64), usize> = BTreeMap::new();
        for observation in &dataset.observations {
            for (j, q) in observation.q_rad.iter().enumerate() {
                *times.entry((j, q.to_bits())).or_default() += 1;
            }
        }
        let often = (OFTEN * dataset.observations.len() as f64).max(4.0) as usize;
        let shape = |observation: &Observation| {
            dataset
                .turning()
                .filter(|j| grid.joints.contains(j))
                .filter(|&j| times.get(&(j, observation.q_rad[j].to_bits())).is_none_or(|&t| t <= often))
                .map(|j| {
                    let v = observation.jacobian_column(j);
                    let v = Vector3::new(v[0], v[1], v[2]);
                    v * v.transpose() * variance
                })
                .sum()
        };
        let all = dataset.observations.iter().zip(left_out).zip(rounded);
        let kept = all.filter(|((_, is_left_out), _)| !**is_left_out);
        let shapes = kept.map(|((observation, _), is_rounded)| match is_rounded {
            true => shape(observation),
            false => Matrix3::zeros(),
        });
        Self { shapes: shapes.collect(), known_m2 }
    }

    /// Square of one coordinate that this rounding leads one to expect.
    fn expected_m2(&self) -> f64 {
        self.shapes.iter().map(Matrix3::trace).sum::<f64>() / (3.0 * self.shapes.len() as f64)
    }

    /// Mean square of one coordinate of `residuals`.
    fn mean_square(&self, residuals: &[Vector3<f64>]) -> f64 {
        residuals.iter().map(Vector3::norm_squared).sum::<f64>() / (3.0 * self.shapes.len() as f64)
    }

    /// ln likelihood of residuals that are plain noise.
    fn plain(&self, residuals: &[Vector3<f64>]) -> f64 {
        self.log_likelihood(residuals, 0.0, self.mean_square(residuals))
    }

    /// The same where joints are rounded, with the likeliest of some sizes of noise beside that.
    fn rounded(&self, residuals: &[Vector3<f64>]) -> f64 {
        let plain_m2 = self.mean_square(residuals);
        let known_m2 = self.known_m2.unwrap_or(1e-10);
        [0.05, 0.15, 0.4, 0.7]
            .into_iter()
            .map(|k| self.log_likelihood(residuals, 0.9, k * plain_m2))
            .chain([self.log_likelihood(residuals, 0.9, known_m2)])
            .fold(f64::NEG_INFINITY, f64::max)
    }

    /// With a share of the rounding's covariance beside noise of one variance.
    fn log_likelihood(&self, residuals: &[Vector3<f64>], share: f64, noise_m2: f64) -> f64 {
        self.shapes
            .iter()
            .zip(residuals)
            .map(|(shape, e)| {
                let c = shape * share + Matrix3::identity() * noise_m2.max(1e-14);
                c.cholesky()
                    .map_or(f64::NEG_INFINITY, |l| -0.5 * e.dot(&l.solve(e)) - 0.5 * l.determinant().ln())
            })
            .sum()
    }
}

//! Joints written with too few decimals: their rounding error seen in the scatter.

use super::dataset::{Dataset, Observation, Twist};
use super::evidence::NuisanceModel;
use super::linear_fit::solve;
use super::measured_robot::MeasuredRobot;
use super::model::FittedModel;
use crate::measure::{Fault, FaultKind, Measurements};
use nalgebra::{Matrix3, Vector3};
use rapid_syntax::diagnostic::is_or_are;
use robot_model::robot::{Axis, SerialArm};
use robot_model::units::{deg_from_rad, mm_from_m, rad_from_deg};
use std::collections::{BTreeMap, BTreeSet};

/// Steps that joints come rounded to lie between these, degrees: finer ones are no fault, coarser ones are postures.
const STEPS_DEG: [f64; 2] = [0.01, 1.0];
/// Angles nearer to each other than this are one: what reading decimals, or radians, leaves, degrees.
const SAME_DEG: f64 = 1e-6;
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
/// Without any cause rounding is the whole of what is left, as a variance: more than so many times what it makes beside the noise, and other
/// things are in it.
const MOST_SCATTER: f64 = 9.0;

/// What else is known of the file, which decides how clearly rounding has to show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FaultPrior {
    /// Nothing else speaks against the file.
    NoOtherFault,
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
    let MeasuredRobot { measurements, robot, .. } = measured;
    let FittedModel { linear, model, workspace } = fitted;
    let all_seen = linear.dataset.observations.iter().all(|s| s.rows(3) == 3);
    if !all_seen {
        return None;
    }
    let grid = Grid::of(measurements)?;
    let proves_nothing = COMMANDED_DEG.contains(&grid.step_deg) && prior == FaultPrior::NoOtherFault;
    let clear_nats = if proves_nothing { CLEAR_NATS } else { ODD_NATS };
    let known_m2 = model.noise.known.map(|known| known.sigma_m.powi(2));
    let scatter = RoundedScatter::of(&linear.dataset, &model.outliers, &grid, known_m2);
    // One false reading would decide by where it happens to lie.
    let points = |twists: &[Twist]| -> Vec<Vector3<f64>> {
        let kept = twists.iter().zip(&model.outliers).filter(|(_, is_outlier)| !**is_outlier);
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
    let beside_causes =
        best_m2 > 0.3 * expected_m2 && scatter.rounded(&best) > scatter.plain(&best) + clear_nats;
    if plain_m2 < 0.3 * expected_m2 {
        return None;
    }
    (without_causes || beside_causes).then(|| {
        let all_joints = grid.joints.len() == linear.dataset.turning().count();
        rounded_joints(&grid, robot, all_joints, mm_from_m((3.0 * plain_m2).sqrt()))
    })
}

/// The fault itself; `scatter_mm`: rms of the points.
fn rounded_joints(grid: &Grid, robot: &SerialArm, all_joints: bool, scatter_mm: f64) -> Fault {
    let step_deg = grid.step_deg;
    let columns = grid.columns(robot);
    let rounded = match all_joints {
        true => "the joints are".to_owned(),
        false => format!("{columns} alone {}", is_or_are(grid.joints.len())),
    };
    Fault::of_all(
        FaultKind::RoundedJoints,
        Some(&columns),
        format!(
            "{rounded} rounded to {step_deg} deg, and the points scatter just as that rounding would make them \
             ({scatter_mm:.2} mm rms): export the joints with at least 3 decimals"
        ),
    )
}

/// What rounding joints does to the measured points, and how likely residuals are with it and without.
struct RoundedScatter {
    /// Covariance of each observation's point that is not set aside, m^2.
    shapes: Vec<Matrix3<f64>>,
    /// The variance of one coordinate's noise where it is known, m^2.
    known_m2: Option<f64>,
}

impl RoundedScatter {
    fn of(dataset: &Dataset, outliers: &[bool], grid: &Grid, known_m2: Option<f64>) -> Self {
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
        let kept = dataset.observations.iter().zip(outliers).filter(|(_, is_outlier)| !**is_outlier);
        Self { shapes: kept.map(|(observation, _)| shape(observation)).collect(), known_m2 }
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

/// Joints that are written on the multiples of one step.
struct Grid {
    step_deg: f64,
    /// Their indices, counted from 0.
    joints: Vec<usize>,
}

impl Grid {
    /// The coarsest step on which every joint stands, however many decimals it is written with and wherever its zero is; where there is
    /// none, the coarsest on which some do, most of whose rows have an angle of their own.
    fn of(measurements: &Measurements) -> Option<Self> {
        let rows = || measurements.rows.iter().filter(|row| row.reading.involves_arm());
        let kinds = measurements.joint_kinds.iter().enumerate();
        let turning: Vec<usize> = kinds.filter(|(_, kind)| !kind.slides()).map(|(j, _)| j).collect();
        let moves = |j: usize| {
            let angles: BTreeSet<u64> = rows().map(|row| row.q_rad[j].to_bits()).collect();
            2 * angles.len() > rows().count()
        };
        let of_joint = |j: usize| common_step_deg(rows().map(|row| deg_from_rad(row.q_rad[j])));
        let own: Vec<(usize, f64)> = turning.iter().map(|&j| (j, of_joint(j))).collect();
        let all = own.iter().fold(0.0, |step_deg, (_, own_deg)| common_divisor(step_deg, *own_deg));
        if let Some(step_deg) = rounding_step(all) {
            return Some(Self { step_deg, joints: turning });
        }
        let own = || own.iter().filter(|(j, _)| moves(*j));
        let coarsest = own().filter_map(|(_, own_deg)| rounding_step(*own_deg)).reduce(f64::max)?;
        let stands = |own_deg: f64| common_divisor(coarsest, own_deg) > coarsest - SAME_DEG;
        let joints = own().filter(|(_, own_deg)| stands(*own_deg)).map(|(j, _)| *j).collect();
        Some(Self { step_deg: coarsest, joints })
    }

    fn columns(&self, robot: &SerialArm) -> String {
        let all = robot.joints.iter().filter(|joint| !joint.kind.slides()).count();
        if self.joints.len() == all && all == robot.joints.len() {
            return robot.columns();
        }
        let columns: Vec<String> = self.joints.iter().map(|&j| robot.column(Axis::at(j))).collect();
        columns.join(", ")
    }
}

/// The step of which the differences of all `angles_deg` are multiples; 0 of angles that are all the same.
fn common_step_deg(mut angles_deg: impl Iterator<Item = f64>) -> f64 {
    let first = angles_deg.next().unwrap_or(0.0);
    angles_deg.fold(0.0, |step_deg, angle_deg| common_divisor(step_deg, (angle_deg - first).abs()))
}

/// Euclid's algorithm on numbers that are known to [`SAME_DEG`]; the divisor of 0 and another number is that number.
fn common_divisor(a: f64, b: f64) -> f64 {
    let largest = a.max(b);
    let (mut a, mut b) = (a, b);
    while b > SAME_DEG {
        // The nearest multiple: a rest just under the divisor is none.
        (a, b) = (b, (a - b * (a / b).round()).abs());
    }
    // Rests have lost digits: the largest number tells the divisor best.
    if a > SAME_DEG { largest / (largest / a).round() } else { a }
}

/// The step that joints are rounded to whose angles are multiples of `common_deg`, to the last digit that counts: itself, or of a coarse one the
/// coarsest part that can be; `None` of a fine one, or of joints that stand still.
fn rounding_step(common_deg: f64) -> Option<f64> {
    let [finest, coarsest] = STEPS_DEG;
    let step_deg = common_deg / (common_deg / coarsest - SAME_DEG).ceil().max(1.0);
    let written = (step_deg / SAME_DEG).round() * SAME_DEG;
    (common_deg > SAME_DEG && step_deg > finest - SAME_DEG).then(|| (written * 1e6).round() / 1e6)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(cells: impl Fn(usize, usize) -> f64) -> Measurements {
        let mut text = "q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n".to_owned();
        for k in 0..40 {
            let row: Vec<String> = (0..6).map(|j| format!("{:.5}", cells(k, j))).collect();
            text.push_str(&format!("{},1,2,{k}\n", row.join(",")));
        }
        Measurements::from_csv(text.as_bytes()).unwrap()
    }

    /// Multiples all over a joint's range: of the fractions of the golden section's powers.
    fn multiple(k: usize, j: usize) -> f64 {
        ((1.0 + k as f64 * 0.618_034_f64.powi(j as i32 + 1)).fract() * 9000.0).round() - 4500.0
    }

    #[test]
    fn a_step_is_that_of_the_differences_wherever_its_zero_lies() {
        for (step, offset) in
            [(0.1, 0.0), (0.03, 0.0), (0.1, 0.037), (0.05, 0.01), (0.02, 0.0), (0.01, 0.0045)]
        {
            let grid = Grid::of(&file(|k, j| multiple(k, j) * step + offset * (j + 1) as f64)).unwrap();
            assert_eq!((grid.step_deg, grid.joints.len()), (step, 6), "{step} from {offset} on");
        }
        assert!(Grid::of(&file(|k, j| multiple(k, j) * 0.00317)).is_none(), "fine enough");
    }

    #[test]
    fn joints_rounded_alone_are_told_from_those_that_are_not() {
        let grid = Grid::of(&file(|k, j| multiple(k, j) * if j == 4 { 0.06 } else { 0.00317 })).unwrap();
        assert_eq!((grid.step_deg, grid.joints), (0.06, vec![4]));
    }

    #[test]
    fn of_postures_the_step_is_a_part_of_theirs() {
        assert_eq!(rounding_step(5.0), Some(1.0));
        assert_eq!(rounding_step(1.5), Some(0.75));
        assert_eq!(rounding_step(0.0), None);
    }
}

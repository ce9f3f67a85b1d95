//! Joints written with too few decimals: their rounding error seen in the scatter.

use super::angle_grid::AngleGrid;
use super::measured_robot::MeasuredRobot;
use super::model::FittedModel;
use super::rounded_scatter::RoundedScatter;
use inference::dataset::Twist;
use inference::design::Design;
use inference::evidence::NuisanceModel;
use inference::linear_fit::solve;
use measurements::{Fault, FaultKind};
use nalgebra::{DMatrix, DVector, Vector3};
use rapid_syntax::diagnostic::is_or_are;
use robot_model::units::mm_from_m;

/// Steps that people command poses in: their being common to all joints proves nothing.
const COMMANDED_DEG: [f64; 4] = [1.0, 0.5, 0.1, 0.01];
/// A step that nobody commands in need not show so clearly, nats.
const ODD_NATS: f64 = 1.0;
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
/// By how much rounding, which they are fitted to, usually shifts base and target, metres.
const USUAL_SHIFT_M: f64 = 1e-3;

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
    if plain_m2 < 0.3 * expected_m2 {
        return None;
    }
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
    (without_causes || one_column || beside_causes || among_postures(&scatter, &points, clear_nats, fitted))
        .then(|| rounded_joints(grid, measured, [scatter.expected_with_shared_m2(), plain_m2]))
}

/// Whether rounding is the likeliest where joints come back to a few values again and again: what these leave in the residuals is no scatter,
/// and what is left beside it still has to be, and all of it together to be likelier than the model. `points`: of the stations that count.
fn among_postures(
    scatter: &RoundedScatter,
    points: &dyn Fn(&[Twist]) -> Vec<Vector3<f64>>,
    clear_nats: f64,
    fitted: &FittedModel<'_>,
) -> bool {
    let FittedModel { model, workspace, .. } = fitted;
    if !scatter.has_shared() {
        return false;
    }
    let design = &workspace.design;
    let registered = solve(design, &design.all_groups(), &[], None).coefficients;
    let bare = points(&design.residuals(&registered));
    let beside = scatter.beside_shared(&bare);
    let known_m2 = model.noise.known.map_or(0.0, |known| known.sigma_m.powi(2));
    let most_m2 = MOST_SCATTER * (scatter.expected_with_shared_m2() + known_m2);
    scatter.mean_square(&bare) < most_m2
        && scatter.rounded(&beside) - scatter.plain(&beside) > clear_nats
        && scatter.gain_with_shared(&bare, &placed(design, points, registered.len())) > fitted.log_odds()
}

/// How the points move with each number of base and target, by [`USUAL_SHIFT_M`] rms, three rows for each; of the design's `coefficients`.
fn placed(
    design: &Design,
    points: &dyn Fn(&[Twist]) -> Vec<Vector3<f64>>,
    coefficients: usize,
) -> DMatrix<f64> {
    let at = |number: Option<usize>| -> Vec<Vector3<f64>> {
        let mut moved = vec![0.0; coefficients];
        number.into_iter().for_each(|number| moved[number - 1] = 1.0);
        points(&design.residuals(&moved))
    };
    let still = at(None);
    let columns: Vec<DVector<f64>> = design
        .registration
        .clone()
        .map(|number| {
            let moved = at(Some(number));
            let apart =
                still.iter().zip(&moved).flat_map(|(a, b)| (b - a).iter().copied().collect::<Vec<_>>());
            let column = DVector::from_iterator(3 * still.len(), apart);
            let rms = column.norm() / (column.len().max(1) as f64).sqrt();
            if rms > 0.0 { column * (USUAL_SHIFT_M / rms) } else { column }
        })
        .collect();
    if columns.is_empty() { DMatrix::zeros(3 * still.len(), 0) } else { DMatrix::from_columns(&columns) }
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

//! The reference paper's offline method: the joints of every target at every minute of warm-up.

use super::targets::NamedPose;
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::{Deformation, TableIndex};
use robot_model::kinematics::{
    Chain, Chains, ClosedForm, Configuration, NominalFrames, Solution, SolveError, Solved, StructureError,
};
use robot_model::robot::{OutOfRange, Robot};
use thiserror::Error;

/// Joints of all targets at all minutes.
#[derive(Clone, Debug, PartialEq)]
pub struct MinuteTable {
    /// For each target the nominal arm's joints.
    pub nominal: Vec<Solution>,
    /// Minute by minute; within a minute the targets in their order.
    pub rows: Vec<MinuteTableRow>,
}

/// A target at a minute.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MinuteTableRow {
    /// TableIndex of the target.
    pub target: usize,
    /// The warm-up minute, from 0.
    pub t_min: f64,
    /// Joints at which the deformed arm stands on the target, radians.
    pub q_rad: [f64; 6],
    /// Where the deformed arm's flange then is, metres.
    pub position_m: [f64; 3],
    /// How far that is from the target, metres.
    pub residual_m: f64,
    /// And by what angle, radians.
    pub residual_rad: f64,
    /// How far from the target the deformed arm stands with the nominal joints, metres.
    pub uncompensated_m: f64,
    /// And by what angle, radians.
    pub uncompensated_rad: f64,
}

/// How far the targets are missed at a minute.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MinuteErrors {
    /// The warm-up minute, from 0.
    pub t_min: f64,
    /// With the nominal joints.
    pub before: TargetErrors,
    /// With the joints of the table.
    pub after: TargetErrors,
}

/// How far all targets are missed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TargetErrors {
    /// Largest distance of any target, metres.
    pub max_m: f64,
    /// Root of the mean square of the distances, metres.
    pub rms_m: f64,
    /// Largest angle of any target, radians.
    pub max_rad: f64,
}

impl TargetErrors {
    fn of(distances: impl Iterator<Item = (f64, f64)>) -> Self {
        let (mut errors, mut sum, mut n) = (Self::default(), 0.0, 0.0);
        for (m, rad) in distances {
            errors.max_m = errors.max_m.max(m);
            errors.max_rad = errors.max_rad.max(rad);
            sum += m * m;
            n += 1.0;
        }
        Self { rms_m: if n > 0.0 { (sum / n).sqrt() } else { 0.0 }, ..errors }
    }
}

impl MinuteTable {
    /// For each minute how far the targets are missed.
    #[must_use]
    pub fn errors_by_minute(&self) -> Vec<MinuteErrors> {
        let minutes = self.rows.chunk_by(|a, b| a.target < b.target);
        let errors = |rows: &[MinuteTableRow]| MinuteErrors {
            t_min: rows.first().map_or(0.0, |row| row.t_min),
            before: TargetErrors::of(rows.iter().map(|row| (row.uncompensated_m, row.uncompensated_rad))),
            after: TargetErrors::of(rows.iter().map(|row| (row.residual_m, row.residual_rad))),
        };
        minutes.map(errors).collect()
    }
}

/// Why there is no table.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum TabulateError {
    /// The robot has no closed-form inverse.
    #[error(transparent)]
    Structure(#[from] StructureError),
    /// The table's index is not the minute.
    #[error(
        "the deformation table is indexed by temperature, and a table of minutes needs one indexed by time (`t_min`)"
    )]
    Temperature,
    /// The nominal arm cannot stand on a target.
    #[error("target {name} (line {line}): {problem}")]
    Target {
        /// The name of the target.
        name: String,
        /// Its line, from 1.
        line: u64,
        /// Why it has no joints.
        problem: NoJoints,
    },
    /// The deformed arm cannot stand on a target.
    #[error("target {name} (line {line}) at minute {t_min}: {problem}")]
    Minute {
        /// The name of the target.
        name: String,
        /// Its line, from 1.
        line: u64,
        /// The warm-up minute, from 0.
        t_min: f64,
        /// Why it has no joints.
        problem: NoJoints,
    },
}

/// Why no joints are given for a target.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum NoJoints {
    /// It is out of the arm's reach.
    #[error("the arm does not reach it")]
    OutOfReach,
    /// In reach, but not within the joints' ranges.
    #[error("every way to reach it leaves a joint's range")]
    Ranges,
    /// In reach, but not on the branch that was asked for.
    #[error("it is not reached on the branch cfx = {0}")]
    Branch(i32),
    /// The numeric inverse found nothing.
    #[error(transparent)]
    Solve(#[from] SolveError),
    /// The correction leaves a joint's range.
    #[error(transparent)]
    OutOfRange(#[from] OutOfRange),
}

impl From<TabulateError> for Diagnostic {
    fn from(error: TabulateError) -> Self {
        let code = match &error {
            TabulateError::Structure(error) => return (*error).into(),
            TabulateError::Temperature => "tabulate::temperature",
            TabulateError::Target { problem, .. } | TabulateError::Minute { problem, .. } => match problem {
                NoJoints::OutOfReach => "reach::none",
                NoJoints::Ranges | NoJoints::OutOfRange(_) => "reach::range",
                NoJoints::Branch(_) => "reach::branch",
                NoJoints::Solve(_) => "reach::deformed",
            },
        };
        Self::error(code, error.to_string())
    }
}

/// Solves every target at every minute on the deformed arm.
///
/// The branch of `configuration`, where it is given: its cfx, and the whole turns nearest to its quadrants. Otherwise, and
/// among equals, the joints nearest to the previous target's, the first target's nearest to zero.
///
/// # Errors
/// The first target, in their order, that cannot be reached; then the first minute at which one cannot.
pub fn tabulate(
    robot: &Robot,
    deformation: &Deformation,
    targets: &[NamedPose],
    configuration: Option<&Configuration>,
    minutes: &[f64],
) -> Result<MinuteTable, TabulateError> {
    let closed = ClosedForm::new(robot)?;
    if deformation.index() != TableIndex::WarmUpTime {
        return Err(TabulateError::Temperature);
    }
    let nominal = nominal_solutions(&closed, targets, configuration)?;
    let frames = NominalFrames::of(robot);
    let chains: Vec<Chain> =
        minutes.iter().map(|&t_min| frames.chain(&deformation.offsets_at(t_min))).collect();
    let all_minutes = Chains::new(chains.clone());
    let of_target = |i: usize| -> Vec<Result<MinuteTableRow, NoJoints>> {
        let (goal, nominal_rad) = (&targets[i].base_from_flange, &nominal[i].q_rad);
        let mut rows = Vec::with_capacity(minutes.len());
        let mut moments = minutes.iter().zip(&chains);
        all_minutes.solve(goal, nominal_rad, |solved| {
            let Some((&t_min, chain)) = moments.next() else { return };
            rows.push(solved.map_err(NoJoints::from).and_then(
                |Solved { q_rad, residual_m, residual_rad, .. }| {
                    robot.within_range(&q_rad)?;
                    let (uncompensated_m, uncompensated_rad) = chain.distance(nominal_rad, goal);
                    Ok(MinuteTableRow {
                        target: i,
                        t_min,
                        q_rad,
                        position_m: chain.forward(&q_rad).translation.vector.into(),
                        residual_m,
                        residual_rad,
                        uncompensated_m,
                        uncompensated_rad,
                    })
                },
            ));
        });
        rows
    };
    let found: Vec<Vec<Result<MinuteTableRow, NoJoints>>> = parallel::map(targets.len(), &of_target);
    let mut rows = Vec::with_capacity(minutes.len() * targets.len());
    for (k, &t_min) in minutes.iter().enumerate() {
        for (target, found) in targets.iter().zip(&found) {
            let row = found[k].map_err(|problem| TabulateError::Minute {
                name: target.name.clone(),
                line: target.line,
                t_min,
                problem,
            });
            rows.push(row?);
        }
    }
    Ok(MinuteTable { nominal, rows })
}

/// For each target the nominal joints, nearest to those of the target before.
fn nominal_solutions(
    closed: &ClosedForm,
    targets: &[NamedPose],
    configuration: Option<&Configuration>,
) -> Result<Vec<Solution>, TabulateError> {
    let mut nominal: Vec<Solution> = Vec::with_capacity(targets.len());
    for target in targets {
        let previous = nominal.last().map_or([0.0; 6], |last| last.q_rad);
        let solution = choose(closed, target, configuration, &previous).map_err(|problem| {
            TabulateError::Target { name: target.name.clone(), line: target.line, problem }
        })?;
        nominal.push(solution);
    }
    Ok(nominal)
}

fn choose(
    closed: &ClosedForm,
    target: &NamedPose,
    configuration: Option<&Configuration>,
    previous_rad: &[f64; 6],
) -> Result<Solution, NoJoints> {
    let solutions = closed.solutions(&target.base_from_flange);
    if solutions.is_empty() {
        let in_reach = closed.branches(&target.base_from_flange).iter().any(Option::is_some);
        return Err(if in_reach { NoJoints::Ranges } else { NoJoints::OutOfReach });
    }
    let nearest = |solutions: Vec<Solution>| {
        let distance = |s: &Solution| s.squared_distance(previous_rad);
        solutions.into_iter().min_by(|a, b| distance(a).total_cmp(&distance(b)))
    };
    let Some(wanted) = configuration else { return nearest(solutions).ok_or(NoJoints::OutOfReach) };
    let branch: Vec<Solution> = solutions.into_iter().filter(|s| s.configuration.cfx == wanted.cfx).collect();
    // What agrees is 0 quadrants away, on either side of a border.
    let quadrants_away = |s: &Solution| {
        let own = closed.kept(wanted, &s.q_rad);
        (own.cf1 - wanted.cf1).abs() + (own.cf4 - wanted.cf4).abs() + (own.cf6 - wanted.cf6).abs()
    };
    let least = branch.iter().map(quadrants_away).min();
    let branch = branch.into_iter().filter(|s| Some(quadrants_away(s)) == least).collect();
    nearest(branch).ok_or(NoJoints::Branch(wanted.cfx))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compensate::targets;
    use robot_model::units::{deg_from_rad, mm_from_m};

    fn irb140() -> Robot {
        Robot::built_in("irb140").unwrap()
    }

    fn cube() -> Vec<NamedPose> {
        targets::read(include_bytes!("../../../../fixtures/paper/targets45.csv"), None).unwrap()
    }

    fn minutes() -> Vec<f64> {
        (0..=180).map(f64::from).collect()
    }

    #[test]
    fn the_papers_table_has_8145_rows_all_on_target() {
        let table = tabulate(&irb140(), &Deformation::paper(), &cube(), None, &minutes()).unwrap();
        assert_eq!(table.rows.len(), 8145);
        for (n, row) in table.rows.iter().enumerate() {
            assert_eq!((row.target, row.t_min), (n % 45, (n / 45) as f64));
            assert!(mm_from_m(row.residual_m) <= 1e-9 && deg_from_rad(row.residual_rad) <= 1e-9);
        }
        // At minute 0 nothing has moved: P19 of Table 3, to its rounding.
        let published = [17.19, 14.3, 9.09, 37.92, -28.74, -34.34];
        for (q_rad, published) in table.rows[18].q_rad.iter().zip(published) {
            assert!((deg_from_rad(*q_rad) - published).abs() < 0.005);
        }
        assert!(table.nominal.iter().all(|s| s.configuration.cfx == 1));
        let errors = table.errors_by_minute();
        assert_eq!((errors.len(), errors[0].before, errors[180].t_min), (181, errors[0].after, 180.0));
        // Two equal lags of 46 minutes: at 180 minutes 1 - (1 + x) e^-x of 0.193 mm, x = 180/46.
        let worst_mm =
            table.rows[8100..].iter().map(|row| mm_from_m(row.uncompensated_m)).fold(0.0, f64::max);
        assert!((worst_mm - 0.193 * 0.901_84).abs() < 0.0006, "{worst_mm}");
    }

    #[test]
    fn confdata_chooses_the_branch_for_all_targets() {
        for cfx in [0, 1] {
            let wanted = Configuration { cf1: 0, cf4: 0, cf6: 0, cfx };
            let table = tabulate(&irb140(), &Deformation::paper(), &cube(), Some(&wanted), &[90.0]).unwrap();
            assert!(table.nominal.iter().all(|s| s.configuration.cfx == cfx));
        }
        let behind = Configuration { cf1: 0, cf4: 0, cf6: 0, cfx: 5 };
        let error = tabulate(&irb140(), &Deformation::paper(), &cube(), Some(&behind), &[0.0]).unwrap_err();
        assert_eq!(error.to_string(), "target P1 (line 2): it is not reached on the branch cfx = 5");
    }

    #[test]
    fn a_target_out_of_reach_is_named() {
        let far = b"name,x_mm,y_mm,z_mm,rx_deg,ry_deg,rz_deg\nnear,550,0,550,0,90,0\nfar,900,0,550,0,90,0\n";
        let targets = targets::read(far, None).unwrap();
        let error = tabulate(&irb140(), &Deformation::paper(), &targets, None, &[0.0]).unwrap_err();
        assert_eq!(error.to_string(), "target far (line 3): the arm does not reach it");
    }

    #[test]
    fn a_table_by_temperature_is_refused() {
        let text = b"temp_c,joint,dx_mm,dy_mm,dz_mm,rx_deg,ry_deg,rz_deg\n20,1,0,0,0,0,0,0\n";
        let deformation = Deformation::from_csv(text, None).unwrap();
        let error = tabulate(&irb140(), &deformation, &cube(), None, &[0.0]).unwrap_err();
        assert_eq!(error, TabulateError::Temperature);
    }
}

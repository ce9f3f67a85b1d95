//! Measurements as one stand of the instrument sees them, with one target in each row and no codes in the place of readings.

use super::{
    Fault, FaultKind, Measurements, PartFault, PosedRow, RegisterError, Registration, RowCheck, Station,
    Stations, alone, describe_code, describe_knock, describe_move, describe_remounting, find_apart,
    find_fault, find_in_cells, find_in_columns, find_in_one_target, find_in_orientations, find_in_rows,
    find_moved_target, gather, register,
};
use nalgebra::{Isometry3, Point3, Vector3};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::kinematics::SerialChain;
use robot_model::robot::{Joints, SerialArm};
use std::borrow::Cow;
use std::collections::BTreeSet;
use std::ops::Range;

/// Changes of one file that are undone one after the other: an instrument that is moved more often is none that was set up.
const MOST_CHANGES: usize = 8;

/// Measurements as one stand of the instrument sees them.
pub struct OneStand<'a> {
    /// The file, each reading in the frame of the first stand.
    pub measurements: Cow<'a, Measurements>,
    /// Rows to use, as indices.
    pub used: Vec<usize>,
    /// That the instrument was moved in between, or the target, and what was left out.
    pub warnings: Vec<Diagnostic>,
    /// That one joint stands elsewhere in a part of the rows.
    pub elsewhere: Option<JointElsewhere>,
    /// The rows from which on the instrument stood elsewhere than before, as indices into the file's.
    first_of_stands: BTreeSet<usize>,
}

impl<'a> OneStand<'a> {
    /// The rows that `used` names, as the file has them.
    pub(super) fn as_it_is(measurements: &'a Measurements, used: Vec<usize>) -> Self {
        Self {
            measurements: Cow::Borrowed(measurements),
            used,
            warnings: Vec::new(),
            elsewhere: None,
            first_of_stands: BTreeSet::new(),
        }
    }
}

impl OneStand<'_> {
    /// The same with the temperatures of `file`, whose rows these are.
    fn with_temperatures_of(self, file: &Measurements) -> OneStand<'static> {
        let mut measurements = self.measurements.into_owned();
        for (row, of_file) in measurements.rows.iter_mut().zip(&file.rows) {
            row.joint_temperature_c = of_file.joint_temperature_c;
        }
        let Self { used, warnings, elsewhere, first_of_stands, .. } = self;
        OneStand { measurements: Cow::Owned(measurements), used, warnings, elsewhere, first_of_stands }
    }

    fn targets(&self) -> usize {
        self.measurements.targets.len().max(1)
    }

    fn rows(&self, robot: &SerialArm) -> Vec<PosedRow> {
        each_row(&self.measurements, &self.used, robot)
    }

    fn line(&self, of_used: usize) -> u64 {
        let row = self.used.get(of_used).and_then(|&row| self.measurements.rows.get(row));
        row.map_or(0, |row| row.line)
    }

    /// Base and targets as `standing` has them, whose joints are where they stood; they are of these rows.
    ///
    /// # Errors
    /// A contradiction with the robot, with the rows that do not go with the others if they are some; poses that register nothing.
    pub fn registered(
        &self,
        standing: &[Station],
        targets: usize,
        robot: &SerialArm,
        tool_m: Option<Vector3<f64>>,
    ) -> Result<Registration, StandError> {
        let chain = SerialChain::nominal(robot);
        let flange: Vec<Isometry3<f64>> = standing.iter().map(|s| s.pose(&chain)).collect();
        if let Some(fault) = find_in_orientations(standing, &flange, targets, tool_m) {
            return Err(StandError::Fault(Box::new(fault)));
        }
        let registration = register(standing, &flange, targets, tool_m)?;
        match find_fault(robot, standing, targets, &registration, tool_m) {
            None => Ok(registration),
            Some(fault) if fault.kind == FaultKind::NothingFits && fault.column.is_none() => {
                let rows = self.rows(robot);
                let found = find_in_one_target(robot, &rows, &self.measurements.targets)
                    .or_else(|| find_apart(robot, &rows, self.targets(), tool_m));
                Err(StandError::Fault(Box::new(found.unwrap_or(fault))))
            }
            Some(fault) => Err(StandError::Fault(Box::new(fault))),
        }
    }

    /// What contradicts the robot in these rows; `None` too where they are too few to say so.
    fn fault(&self, robot: &SerialArm, tool_m: Option<Vector3<f64>>) -> Option<Fault> {
        let Stations { stations, targets, .. } = gather(&self.measurements, &self.used, None);
        let turns = self.elsewhere.as_ref().map(|found| found.turns(&stations, robot.joints.len()));
        let standing = turned(&stations, &turns.unwrap_or_default());
        match self.registered(&standing, targets, robot, tool_m) {
            Err(StandError::Fault(fault)) => Some(*fault),
            Err(StandError::Register(_)) | Ok(_) => None,
        }
    }

    fn warn(&mut self, code: &'static str, message: String) {
        self.warnings.push(Diagnostic::warning(code, message));
    }

    /// In `rows` of the used ones the instrument was elsewhere: their readings in the frame of the others.
    fn moved(&mut self, rows: Range<usize>, first_from_second: &Isometry3<f64>) {
        let to = (rows.end < self.used.len()).then(|| self.line(rows.end - 1));
        self.warn("measure::instrument-moved", describe_move(first_from_second, self.line(rows.start), to));
        let measurements = self.measurements.to_mut();
        for &index in self.used.get(rows.clone()).unwrap_or_default() {
            let Some(row) = measurements.rows.get_mut(index) else { continue };
            let Some(position_m) = row.reading.position_m() else { continue };
            row.reading =
                row.reading.with_coordinates_m((first_from_second * Point3::from(position_m)).coords);
            row.orientation = row.orientation.map(|turn| first_from_second.rotation * turn);
        }
        // Where it was put back it is a stand of its own again.
        self.first_of_stands.extend([rows.start, rows.end].iter().filter_map(|&k| self.used.get(k)));
    }

    /// Numbers the stands of the instrument.
    fn number_stands(&mut self) {
        if self.first_of_stands.is_empty() {
            return;
        }
        for (index, row) in self.measurements.to_mut().rows.iter_mut().enumerate() {
            row.stand = self.first_of_stands.range(..=index).count();
        }
    }

    /// In some rows of the used ones the target sat elsewhere by `by_m`: there it is one of its own.
    fn remounted(&mut self, rows: Range<usize>, by_m: f64) {
        let lines = [self.line(rows.start), self.line(rows.end.saturating_sub(1))];
        self.warn("measure::target-moved", describe_remounting(by_m, lines));
        let rows = self.used.get(rows).unwrap_or_default().to_vec();
        self.name_anew(&rows, format!("from line {}", lines[0]));
    }

    /// One of several targets was knocked, as often as that shows: from there on it is one of its own.
    fn take_knocks_apart(&mut self, robot: &SerialArm) {
        let as_named: Vec<usize> =
            self.used.iter().filter_map(|&i| Some(self.measurements.rows.get(i)?.target)).collect();
        for _ in 0..MOST_CHANGES {
            let Some(moved) = find_moved_target(&self.rows(robot), &as_named, self.targets()) else { break };
            let names = self.measurements.targets.clone();
            let name = |t: usize| names.get(t).map_or("", String::as_str);
            let (moving, what) = match moved.target {
                Some(target) => (vec![target], format!("target {}", name(target))),
                None => (vec![0, 1], format!("one of the targets {} and {}", name(0), name(1))),
            };
            let line = self.line(moved.from);
            self.warn("measure::target-moved", describe_knock(&what, moved.by_m, line));
            for target in moving {
                let rows = self.used.iter().zip(&as_named).skip(moved.from);
                let rows: Vec<usize> =
                    rows.filter(|(_, named)| **named == target).map(|(row, _)| *row).collect();
                self.name_anew(&rows, format!("{} from line {line}", name(target)));
            }
        }
    }

    /// Takes `rows` as those of a target of their own.
    fn name_anew(&mut self, rows: &[usize], name: String) {
        let measurements = self.measurements.to_mut();
        let target = measurements.targets.len().max(1);
        measurements.targets.resize(target, String::new());
        measurements.targets.push(name);
        for &index in rows {
            if let Some(row) = measurements.rows.get_mut(index) {
                row.target = target;
            }
        }
    }

    /// Some of the used rows hold a code where a reading should be.
    fn leave_out(&mut self, rows: &[usize], column: &str, value: f64) {
        let lines: Vec<u64> = rows.iter().map(|&i| self.line(i)).collect();
        self.warn("measure::code-for-none", describe_code(column, value, &lines));
        let coded: BTreeSet<usize> = rows.iter().filter_map(|&i| self.used.get(i)).copied().collect();
        self.used.retain(|row| !coded.contains(row));
    }
}

/// Why the rows of one stand are not registered.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum StandError {
    /// They contradict themselves or the robot.
    #[error("{}", .0.reason)]
    Fault(Box<Fault>),
    /// Too few poses, or too alike ones.
    #[error(transparent)]
    Register(#[from] RegisterError),
}

/// One joint that stands elsewhere than the file says in some rows, further than a registration bears.
pub struct JointElsewhere {
    /// The joint, counted from 0.
    joint: usize,
    /// The rows, as indices into the file's.
    rows: BTreeSet<usize>,
    /// Where it stands less where the file says, radians.
    by_rad: f64,
}

impl JointElsewhere {
    /// By how much each joint stands elsewhere at each station, radians.
    #[must_use]
    pub fn turns(&self, stations: &[Station], joints: usize) -> Vec<Joints> {
        let at = |station: &Station| {
            let has = station.rows.iter().all(|row| self.rows.contains(row));
            Joints::from_fn(joints, |j| if has && j == self.joint { self.by_rad } else { 0.0 })
        };
        stations.iter().map(at).collect()
    }
}

/// Looks for what the rows alone can tell, and takes those of a moved instrument into one frame; `tool_m` is where the target is, in the
/// flange's frame, where that is known.
///
/// # Errors
/// A file whose rows or columns contradict themselves or the robot.
pub fn from_one_stand<'a>(
    measurements: &'a Measurements,
    robot: &SerialArm,
    checked: &RowCheck,
    tool_m: Option<Vector3<f64>>,
) -> Result<OneStand<'a>, Box<Fault>> {
    let targets = measurements.targets.len().max(1);
    let rows = || each_row(measurements, &checked.used, robot);
    let of_some_rows = || match find_in_rows(robot, &rows(), targets, tool_m) {
        Some(PartFault::Fault(fault)) => Some(fault),
        _ => None,
    };
    // What is behind a fault that shows in the cells.
    let meant = |fault: Fault| match fault.kind {
        FaultKind::JointsOutOfRange => {
            let stations: Vec<Station> = rows().iter().map(|row| row.station.clone()).collect();
            find_in_columns(robot, &stations, targets).or_else(of_some_rows).unwrap_or(fault)
        }
        // Points that are late lie apart at the joints of repeats.
        FaultKind::FrozenJoints => {
            of_some_rows().filter(|found| found.kind == FaultKind::RowsShifted).unwrap_or(fault)
        }
        _ => fault,
    };
    // Joints that were commanded are the same each time, wherever the arm has gone.
    let in_cells = || {
        find_in_cells(measurements, &checked.used, robot)
            .filter(|fault| !(checked.are_cycles && fault.kind == FaultKind::FrozenJoints))
    };
    let fault = checked.fault.clone().or_else(in_cells);
    if let Some(fault) = fault.map(meant) {
        return Err(Box::new(fault));
    }
    let mut seen = OneStand::as_it_is(measurements, checked.used.clone());
    seen.take_knocks_apart(robot);
    for _ in 0..MOST_CHANGES {
        match find_in_rows(robot, &seen.rows(robot), seen.targets(), tool_m) {
            None => break,
            Some(PartFault::Fault(fault)) => return Err(Box::new(fault)),
            Some(PartFault::Moved { rows, first_from_second }) => seen.moved(rows, &first_from_second),
            Some(PartFault::Remounted { rows, by_m }) => seen.remounted(rows, by_m),
            Some(PartFault::Coded { rows, column, value }) => seen.leave_out(&rows, &column, value),
            Some(PartFault::JointElsewhere { joint, rows, by_rad }) => {
                let rows = seen.used.get(rows).unwrap_or_default().iter().copied().collect();
                seen.elsewhere = Some(JointElsewhere { joint, rows, by_rad });
                break;
            }
        }
    }
    seen.number_stands();
    Ok(seen)
}

/// The rows of one stand of a file that contradicts neither itself nor the robot. Temperatures are not asked: neither performance nor change
/// rests on them.
///
/// # Errors
/// The first contradiction that is found in it, of rows, columns or robot.
pub fn from_sound_file(
    measurements: &Measurements,
    robot: &SerialArm,
    checked: &RowCheck,
) -> Result<OneStand<'static>, Fault> {
    let mut plain = measurements.clone();
    plain.rows.iter_mut().for_each(|row| row.joint_temperature_c = None);
    let seen = from_one_stand(&plain, robot, checked, None).map_err(|fault| *fault)?;
    // Where the tool is, is what is judged.
    match seen.fault(robot, None) {
        Some(fault) => Err(fault),
        None => Ok(seen.with_temperatures_of(measurements)),
    }
}

/// Each row on its own, with the nominal arm's flange pose.
fn each_row(measurements: &Measurements, used: &[usize], robot: &SerialArm) -> Vec<PosedRow> {
    let chain = SerialChain::nominal(robot);
    alone(measurements, used)
        .into_iter()
        .map(|station| PosedRow { pose: station.pose(&chain), station })
        .collect()
}

/// The stations with their joints where causes, or the file, have taken them; without `joint_turns` as they are.
pub fn turned<'s>(stations: &'s [Station], joint_turns: &[Joints]) -> Cow<'s, [Station]> {
    if joint_turns.is_empty() {
        return Cow::Borrowed(stations);
    }
    let mut turned = stations.to_vec();
    for (station, turn) in turned.iter_mut().zip(joint_turns) {
        station.q_rad.iter_mut().zip(turn).for_each(|(q, turn)| *q += turn);
    }
    Cow::Owned(turned)
}

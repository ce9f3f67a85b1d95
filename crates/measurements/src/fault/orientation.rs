//! Orientations that contradict points and joints: parts of the quaternion in another order, the inverse, a row late, angles of
//! another convention.
//!
//! Points and joints alone say how the base stands in the instrument's frame. From there each measured orientation says how the
//! sensor sits on the flange; it sits in one way, so that all must say the same.

use super::whole::SOUND_M;
use super::{Fault, FaultKind};
use crate::{Registration, Rotation, Station, register};
use nalgebra::{Isometry3, Quaternion, UnitQuaternion, Vector3};
use robot_model::units::deg_from_rad;
use statistics::upper_median;

/// Points spread less than this about every line do not say how the base is turned, metres.
const SPREAD_M: f64 = 0.03;
/// Orientations within this of each other are one: instruments and arms err by less, radians.
const NEAR_RAD: f64 = 0.1;
/// Orientations that lie apart by less in the middle may be those of a poor sensor, radians.
const SCATTER_RAD: f64 = 0.4;
/// Orientations nearer to each other than this are one, radians: what sensors scatter by where nothing moves.
const STILL_RAD: f64 = 2e-3;
/// A flange that has turned by more stands elsewhere, radians: joints read back at one pose differ by less.
const TURNED_RAD: f64 = 0.02;
/// Rows further off than so many times the middle one are far.
const FAR_TIMES: f64 = 12.0;
/// Rows that may carry the sensor's orientation, spread over the file.
const MOST_TRIED: usize = 60;
/// Fewer rows, and a smaller share of them, are single false readings.
const FEWEST: usize = 3;
const FEWEST_SHARE: f64 = 0.05;
/// As many rows that are so much closer speak for another explanation.
const CLOSER: f64 = 0.9;
/// An explanation must bring so many of the far rows near.
const MOST: f64 = 0.8;
/// Where no explanation is found and fewer rows than this are near, the orientations say nothing.
const NEAR_SHARE: f64 = 0.8;
const COLUMNS: &str = "qw, qx, qy, qz";
const PARTS: [&str; 4] = ["w", "x", "y", "z"];
const CONVENTIONS: [(Rotation, &str); 4] = [
    (Rotation::FixedXyz, "fixed-xyz"),
    (Rotation::MovingXyz, "moving-xyz"),
    (Rotation::MovingZyx, "moving-zyx"),
    (Rotation::Vector, "vector"),
];

/// Orientations that do not go with the points, of `stations` whose flanges stand at `base_from_flange`; `None` where they do, or
/// where the points do not say how the base is turned.
#[must_use]
pub fn find_in_orientations(
    stations: &[Station],
    base_from_flange: &[Isometry3<f64>],
    targets: usize,
    tool_m: Option<Vector3<f64>>,
) -> Option<Fault> {
    if stations.iter().all(|station| station.orientation.is_none()) {
        return None;
    }
    let of_points: Vec<Station> =
        stations.iter().map(|station| Station { orientation: None, ..station.clone() }).collect();
    let fit = register(&of_points, base_from_flange, targets, tool_m).ok()?;
    if fit.median_m > SOUND_M || !turn_is_known(&of_points) {
        return None;
    }
    Oriented::of(stations, base_from_flange, &fit)?.fault()
}

/// Whether points lie about no line, so that they say how the base is turned.
fn turn_is_known(stations: &[Station]) -> bool {
    let points_m: Vec<Vector3<f64>> = stations.iter().filter_map(|s| s.reading.position_m()).collect();
    let n = points_m.len() as f64;
    let middle_m = points_m.iter().sum::<Vector3<f64>>() / n.max(1.0);
    let mut spread_m2 = points_m
        .iter()
        .map(|p| (p - middle_m) * (p - middle_m).transpose())
        .sum::<nalgebra::Matrix3<f64>>()
        .symmetric_eigenvalues();
    sorting::numbers(spread_m2.as_mut_slice());
    n > 0.0 && (spread_m2[1] / n).max(0.0).sqrt() > SPREAD_M
}

/// What may have happened to an orientation, undone.
struct Change {
    /// What is wrong, as half a sentence.
    description: String,
    change: Box<dyn Fn(UnitQuaternion<f64>) -> UnitQuaternion<f64>>,
}

/// Another order of the parts, the inverse, angles of another convention; the likeliest first.
fn changes() -> Vec<Change> {
    let conjugate: fn(UnitQuaternion<f64>) -> UnitQuaternion<f64> = |turn| turn.inverse();
    let mut all = vec![Change {
        description: "the orientation is the inverse, of the instrument's frame in the sensor's".to_owned(),
        change: Box::new(conjugate),
    }];
    for order in orders().into_iter().filter(|order| *order != [0, 1, 2, 3]) {
        let written = order.map(|part| PARTS[part]).join(", ");
        for (inverse, beside) in [(false, ""), (true, " of the inverse")] {
            all.push(Change {
                description: format!("the columns {COLUMNS} hold {written}{beside}"),
                change: Box::new(move |turn| {
                    let turn = reordered(turn, order);
                    if inverse { turn.inverse() } else { turn }
                }),
            });
        }
    }
    for (meant, name) in CONVENTIONS {
        for (read, as_name) in CONVENTIONS.into_iter().filter(|(read, _)| *read != meant) {
            all.push(Change {
                description: format!(
                    "the orientation's three angles are {name} and were taken for {as_name}"
                ),
                change: Box::new(move |turn| meant.quaternion(read.angles_rad(&turn))),
            });
        }
    }
    all
}

/// All orders of four parts.
fn orders() -> Vec<[usize; 4]> {
    let parts = || 0..4;
    let mut all = Vec::new();
    for a in parts() {
        for b in parts().filter(|b| *b != a) {
            for c in parts().filter(|c| ![a, b].contains(c)) {
                all.extend(parts().filter(|d| ![a, b, c].contains(d)).map(|d| [a, b, c, d]));
            }
        }
    }
    all
}

/// The quaternion whose part `order[k]` stands in the file's column `k`.
fn reordered(turn: UnitQuaternion<f64>, order: [usize; 4]) -> UnitQuaternion<f64> {
    let cells = [turn.w, turn.i, turn.j, turn.k];
    let mut parts = [0.0; 4];
    for (cell, part) in cells.into_iter().zip(order) {
        parts[part] = cell;
    }
    let [w, x, y, z] = parts;
    UnitQuaternion::new_normalize(Quaternion::new(w, x, y, z))
}

/// A row with an orientation.
#[derive(Clone, Copy)]
struct OrientedRow {
    line: u64,
    /// How the flange is turned in the instrument's frame, by points and joints.
    instrument_from_flange: UnitQuaternion<f64>,
    /// How the sensor was seen.
    seen: UnitQuaternion<f64>,
}

impl OrientedRow {
    /// How the sensor sits on the flange if `seen` is how it was turned.
    fn flange_from_sensor(&self, seen: UnitQuaternion<f64>) -> UnitQuaternion<f64> {
        self.instrument_from_flange.inverse() * seen
    }
}

/// The rows with orientations, in the file's order.
struct Oriented {
    rows: Vec<OrientedRow>,
}

/// A way in which the sensor may sit on the flange, and how far each row is off it.
struct Sensor {
    flange_from_sensor: UnitQuaternion<f64>,
    off_rad: Vec<f64>,
    /// How many rows are near, and how far the middle one of them is off.
    near: usize,
    middle_rad: f64,
}

impl Sensor {
    fn new(flange_from_sensor: UnitQuaternion<f64>, off_rad: Vec<f64>) -> Self {
        let mut near_rad: Vec<f64> = off_rad.iter().copied().filter(|off_rad| *off_rad < NEAR_RAD).collect();
        let middle_rad = upper_median(&mut near_rad).unwrap_or(NEAR_RAD);
        let near = near_rad.len();
        Self { flange_from_sensor, off_rad, near, middle_rad }
    }

    /// Whether more rows agree with it than with `other`, or as many more closely.
    fn beats(&self, other: &Self) -> bool {
        self.near > other.near || (self.near == other.near && self.middle_rad < CLOSER * other.middle_rad)
    }
}

impl Oriented {
    fn of(
        stations: &[Station],
        base_from_flange: &[Isometry3<f64>],
        registration: &Registration,
    ) -> Option<Self> {
        let with_pose = stations.iter().zip(base_from_flange);
        let rows: Vec<OrientedRow> = with_pose
            .filter_map(|(station, pose)| {
                Some(OrientedRow {
                    line: station.line,
                    instrument_from_flange: registration.instrument_from_base.rotation * pose.rotation,
                    seen: station.orientation?,
                })
            })
            .collect();
        (rows.len() >= 2 * FEWEST).then_some(Self { rows })
    }

    /// The sensor that most rows agree with, each seen as `turns` says.
    fn sensor(&self, turns: &[UnitQuaternion<f64>]) -> Option<Sensor> {
        let each: Vec<UnitQuaternion<f64>> =
            self.rows.iter().zip(turns).map(|(row, turn)| row.flange_from_sensor(*turn)).collect();
        let tried = each.iter().step_by(each.len().div_ceil(MOST_TRIED).max(1));
        tried
            .map(|sensor| Sensor::new(*sensor, each.iter().map(|other| sensor.angle_to(other)).collect()))
            .reduce(|best, next| if next.beats(&best) { next } else { best })
    }

    fn turns(&self, change: impl Fn(UnitQuaternion<f64>) -> UnitQuaternion<f64>) -> Vec<UnitQuaternion<f64>> {
        self.rows.iter().map(|row| change(row.seen)).collect()
    }

    fn as_read(&self) -> Option<Sensor> {
        self.sensor(&self.turns(|turn| turn))
    }

    fn fault(&self) -> Option<Fault> {
        let as_read = self.as_read()?;
        if 2 * as_read.near < self.rows.len() {
            return self.of_all(&as_read);
        }
        let limit_rad = NEAR_RAD.max(FAR_TIMES * as_read.middle_rad);
        let far: Vec<usize> = (0..self.rows.len()).filter(|&i| as_read.off_rad[i] > limit_rad).collect();
        let few = far.len() < FEWEST || (far.len() as f64) < FEWEST_SHARE * self.rows.len() as f64;
        if few { None } else { self.of_some(&as_read, &far, limit_rad) }
    }

    /// What is wrong with all rows, where they agree with no sensor as they are read; `None` where they may only scatter.
    fn of_all(&self, as_read: &Sensor) -> Option<Fault> {
        let changed = changes().into_iter().filter_map(|Change { description, change }| {
            Some((self.sensor(&self.turns(change))?, description))
        });
        let late = [(1, 0, "before"), (0, 1, "after")].into_iter().filter_map(|(seen, joints, side)| {
            let sensor = self.shifted(seen, joints).as_read()?;
            Some((sensor, format!("in every row the orientation is that of the row {side}")))
        });
        let found = changed
            .chain(late)
            .reduce(|best, next| if next.0.beats(&best.0) { next } else { best })
            .filter(|(sensor, _)| sensor.near as f64 >= MOST * self.rows.len() as f64);
        let middle_rad = upper_median(&mut as_read.off_rad.clone());
        let scatters = middle_rad.is_some_and(|middle_rad| middle_rad < SCATTER_RAD);
        if found.is_none() && scatters {
            return None;
        }
        let reason = found.map_or_else(
            || {
                format!(
                    "the orientations do not go with the points and joints, in no order of their parts: leave the columns {COLUMNS} out \
                     to diagnose the points alone"
                )
            },
            |(_, what)| format!("{what}: so read they go with the points and joints, as they stand they do not"),
        );
        Some(Fault::of_all(FaultKind::Orientations, Some(COLUMNS), reason))
    }

    /// The orientation of one row beside the joints of the next.
    fn shifted(&self, seen: usize, joints: usize) -> Self {
        let rows = self.rows.iter().skip(joints).zip(self.rows.iter().skip(seen));
        Self { rows: rows.map(|(row, other)| OrientedRow { seen: other.seen, ..*row }).collect() }
    }

    /// What is wrong with the rows `far` off what the others say of the sensor.
    fn of_some(&self, sensor: &Sensor, far: &[usize], limit_rad: f64) -> Option<Fault> {
        let off_rad = |i: usize, seen: UnitQuaternion<f64>| {
            sensor.flange_from_sensor.angle_to(&self.rows[i].flange_from_sensor(seen))
        };
        let lines: Vec<u64> =
            far.iter().filter(|&&i| self.stood_still(i)).map(|&i| self.rows[i].line).collect();
        if lines.len() >= FEWEST && 2 * lines.len() > far.len() {
            return Some(Fault::in_rows(FaultKind::Orientations, COLUMNS, lines, |count, which| {
                format!(
                    "{count} rows ({which}) have the orientation of the row before, though the arm had turned: the sensor stood still"
                )
            }));
        }
        let explained = |change: &Change| -> Vec<u64> {
            let near = far.iter().filter(|&&i| off_rad(i, (change.change)(self.rows[i].seen)) < limit_rad);
            near.map(|&i| self.rows[i].line).collect()
        };
        let found = changes()
            .into_iter()
            .map(|change| (explained(&change), change))
            .reduce(|best, next| if next.0.len() > best.0.len() { next } else { best })
            .filter(|(lines, _)| lines.len() as f64 >= MOST * far.len() as f64);
        if let Some((lines, change)) = found {
            return Some(Fault::in_rows(FaultKind::Orientations, COLUMNS, lines, |count, which| {
                format!("in {count} rows ({which}) {}", change.description)
            }));
        }
        if let Some(Remounted { by_rad, lines }) = self.remounted(sensor, far) {
            // A hand that was turned on the flange, with the target: the diagnosis finds that.
            return (by_rad > SCATTER_RAD).then(|| {
                Fault::in_rows(FaultKind::Orientations, COLUMNS, lines, |count, which| {
                    format!(
                        "in {count} rows ({which}) the sensor sits on the flange turned by {:.0} deg from how it sits in the others: diagnose \
                         them apart, or leave the columns {COLUMNS} out",
                        deg_from_rad(by_rad)
                    )
                })
            });
        }
        let many = (sensor.near as f64) < NEAR_SHARE * self.rows.len() as f64;
        let lines = far.iter().map(|&i| self.rows[i].line).collect();
        many.then(|| {
            Fault::in_rows(FaultKind::Orientations, COLUMNS, lines, |count, which| {
                format!(
                    "in {count} rows ({which}) the orientation does not go with the points and joints as it does in the others: leave the \
                     columns {COLUMNS} out to diagnose the points alone"
                )
            })
        })
    }

    /// Whether row `i` has the orientation of the last row before it at which the arm was turned otherwise: repeats, and targets that are seen at
    /// one pose, share theirs.
    fn stood_still(&self, i: usize) -> bool {
        let row = &self.rows[i];
        let turned = |before: &&OrientedRow| {
            before.instrument_from_flange.angle_to(&row.instrument_from_flange) > TURNED_RAD
        };
        let before = self.rows[..i].iter().rev().find(turned);
        before.is_some_and(|before| before.seen.angle_to(&row.seen) < STILL_RAD)
    }

    /// One other way in which the sensor sits in all rows to one side of some row.
    fn remounted(&self, sensor: &Sensor, far: &[usize]) -> Option<Remounted> {
        let (first, last) = (*far.first()?, *far.last()?);
        let side = if first == 0 { 0..last + 1 } else { first..self.rows.len() };
        let rows = Self { rows: self.rows.get(side)?.to_vec() };
        let other = rows.as_read()?;
        let most = MOST * rows.rows.len() as f64;
        (far.len() as f64 >= most && other.near as f64 >= most).then(|| Remounted {
            by_rad: sensor.flange_from_sensor.angle_to(&other.flange_from_sensor),
            lines: rows.rows.iter().map(|row| row.line).collect(),
        })
    }
}

/// A sensor that sits otherwise in a part of the rows.
struct Remounted {
    by_rad: f64,
    lines: Vec<u64>,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Reading;
    use nalgebra::Point3;

    const TARGETS_M: [Vector3<f64>; 3] =
        [Vector3::new(0.06, 0.04, 0.1), Vector3::new(-0.08, 0.03, 0.06), Vector3::new(0.01, -0.09, 0.12)];

    /// 40 poses of a made-up hand at which three targets are seen, each with the orientation that `seen` makes of the pose's number and of how
    /// the sensor is turned there.
    fn visits(
        seen: impl Fn(usize, &dyn Fn(usize) -> UnitQuaternion<f64>) -> UnitQuaternion<f64>,
    ) -> (Vec<Station>, Vec<Isometry3<f64>>) {
        let base = Isometry3::new(Vector3::new(2.0, -1.0, 0.3), Vector3::new(0.4, 1.2, -2.0));
        let pose = |i: usize| {
            let a = |k: f64| (i as f64 * k).fract() - 0.5;
            let shift = Vector3::new(0.5 + a(0.618), a(0.755), 0.4 + a(0.569));
            Isometry3::new(shift, Vector3::new(2.0 * a(0.414), 2.0 * a(0.732), 2.0 * a(0.236)))
        };
        let flange = |i: usize| base.rotation * pose(i).rotation;
        let row = |k: usize| {
            let (i, target) = (k / 3, k % 3);
            let point = base * pose(i) * Point3::from(TARGETS_M[target]);
            let station = Station::bare(i, [0.0; 6].into(), Reading::Point { position_m: point.coords });
            let orientation = Some(seen(i, &flange));
            (Station { line: k as u64 + 2, target, orientation, ..station }, pose(i))
        };
        (0..120).map(row).unzip()
    }

    fn about_x(deg: f64) -> UnitQuaternion<f64> {
        UnitQuaternion::from_scaled_axis(Vector3::x() * deg.to_radians())
    }

    /// At pose 24 of 40 the sensor is mounted anew; each pose's three rows have one orientation, as they should.
    #[test]
    fn a_sensor_that_is_mounted_anew_stands_not_still_where_targets_share_a_pose() {
        let found = |deg: f64| {
            let (stations, poses) = visits(|i, flange| flange(i) * about_x(if i >= 24 { deg } else { 0.0 }));
            find_in_orientations(&stations, &poses, 3, None)
        };
        let fault = found(40.0).unwrap();
        assert!(fault.reason.contains("turned by 40 deg"), "{}", fault.reason);
        assert_eq!(fault.lines, (3 * 24 + 2..122).collect::<Vec<u64>>());
        // By less the diagnosis finds it beside the points.
        assert_eq!(found(10.0), None);
    }

    #[test]
    fn a_sensor_that_hangs_while_the_arm_turns_is_named() {
        let (stations, poses) = visits(|i, flange| flange(if (24..32).contains(&i) { 23 } else { i }));
        let fault = find_in_orientations(&stations, &poses, 3, None).unwrap();
        assert!(fault.reason.contains("the sensor stood still"), "{}", fault.reason);
        assert_eq!(fault.lines, (3 * 24 + 2..3 * 32 + 2).collect::<Vec<u64>>());
    }
}

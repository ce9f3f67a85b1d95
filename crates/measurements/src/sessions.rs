//! Sessions of a file whose minutes begin anew: each cold start opens one, and its rows come after those of the session before.
//!
//! A block that was pasted once more is none: its rows get the clock of those that they repeat.
//! Rows that are merely out of order look alike: a file that was sorted by target, by repeat or by pose. What could be that is left as it is.

use super::MeasurementRow;
use super::copies::is_pasted;
use robot_model::robot::JointKind;
use std::ops::Range;

/// Fewer rows than this are no session: a stamp that was mistyped, a few rows of another day.
const FEWEST_ROWS: usize = 6;
/// More sessions than this are rows out of order.
const MOST_SESSIONS: usize = 6;
/// A session begins within this share of the one before: the same hours of another day, and not a part of the file in the wrong place.
const BEGINS_WITHIN: f64 = 0.1;
/// Of the shorter of two sessions the other has at least this share of the minutes.
const SHARED_MINUTES: f64 = 0.5;
/// From this share of rows on that follow, by their stamps, a row of the same joints in another part, the file was sorted by repeat.
const REPEATS: f64 = 0.8;
/// The pause before a cold start, minutes: no repeat, no visit and no slow noise reaches over it.
const PAUSE_MIN: f64 = 60.0;

/// Minutes that never run back within one part of the file, with the rows that have them.
struct Session {
    rows: Range<usize>,
    from_min: f64,
    to_min: f64,
}

impl Session {
    fn minutes(&self) -> f64 {
        self.to_min - self.from_min
    }

    /// Whether the clock was set back to where `self` began, and `next` ran over the same minutes: with so many rows of both that no mistyped stamp
    /// looks like that.
    fn begins_anew_in(&self, next: &Self, stamps: &[f64]) -> bool {
        let shared = self.to_min.min(next.to_min) - self.from_min.max(next.from_min);
        let later = stamps[self.rows.clone()].iter().filter(|t_min| **t_min > next.from_min).count();
        let earlier = stamps[next.rows.clone()].iter().filter(|t_min| **t_min < self.to_min).count();
        next.from_min - self.from_min <= BEGINS_WITHIN * self.minutes()
            && shared >= SHARED_MINUTES * self.minutes().min(next.minutes())
            && later.min(earlier) >= FEWEST_ROWS - 1
    }
}

/// Tells the rows of each session by how far before the last one's clock its own began.
pub(super) fn number_sessions(rows: &mut [MeasurementRow], kinds: &[JointKind]) {
    let Some(mut sessions) = sessions(rows, kinds) else { return };
    let mut original_of: Vec<usize> = Vec::with_capacity(sessions.len());
    for at in 0..sessions.len() {
        let is_copied = |&k: &usize| {
            original_of[k] == k
                && is_pasted(&rows[sessions[k].rows.clone()], &rows[sessions[at].rows.clone()])
        };
        let original = (0..at).find(is_copied).unwrap_or(at);
        original_of.push(original);
        // Rows may have been measured behind those that were pasted.
        let to_min = sessions[original].to_min.max(sessions[at].to_min);
        sessions[original].to_min = to_min;
    }
    let mut next: Option<(f64, f64)> = None;
    let mut earlier_min = vec![0.0; sessions.len()];
    for (at, session) in sessions.iter().enumerate().rev().filter(|(at, _)| original_of[*at] == *at) {
        earlier_min[at] =
            next.map_or(0.0, |(from_min, earlier_min)| earlier_min + session.to_min + PAUSE_MIN - from_min);
        next = Some((session.from_min, earlier_min[at]));
    }
    for (session, original) in sessions.into_iter().zip(original_of) {
        rows[session.rows].iter_mut().for_each(|row| row.earlier_min = earlier_min[original]);
    }
}

/// The sessions of a file; `None` where it has one, or may have been sorted by something else than time.
fn sessions(rows: &[MeasurementRow], kinds: &[JointKind]) -> Option<Vec<Session>> {
    let stamps: Vec<f64> = rows.iter().map(|row| row.t_min).collect::<Option<_>>()?;
    let mut sessions: Vec<Session> = Vec::new();
    for part in stamps.chunk_by(|a, b| b >= a) {
        let from = sessions.last().map_or(0, |last| last.rows.end);
        let (from_min, to_min) = part.first().copied().zip(part.last().copied())?;
        sessions.push(Session { rows: from..from + part.len(), from_min, to_min });
    }
    let is_clear = (2..=MOST_SESSIONS).contains(&sessions.len())
        && sessions.iter().all(|one| one.rows.len() >= FEWEST_ROWS && moves(&rows[one.rows.clone()], kinds))
        && sessions.windows(2).all(|pair| {
            pair[0].begins_anew_in(&pair[1], &stamps)
                && !sorted_by_a_column(&rows[pair[0].rows.clone()], &rows[pair[1].rows.clone()])
        })
        && !sorted_by_repeat(rows, &sessions, kinds);
    is_clear.then_some(sessions)
}

/// Whether the arm stood at more than one pose.
fn moves(rows: &[MeasurementRow], kinds: &[JointKind]) -> bool {
    rows.windows(2).any(|pair| pair[0].is_apart_from(&pair[1], kinds))
}

/// Whether some column says one thing in all rows `before` and another in all rows `after`: target, fixed point, nests, one joint's direction.
fn sorted_by_a_column(before: &[MeasurementRow], after: &[MeasurementRow]) -> bool {
    let parts = |says: &dyn Fn(&MeasurementRow) -> Option<i64>| {
        let all = |rows: &[MeasurementRow]| {
            let first = says(rows.first()?);
            rows.iter().all(|row| says(row) == first).then_some(first)
        };
        all(before).zip(all(after)).is_some_and(|(before, after)| before != after)
    };
    let joints = before.first().map_or(0, |row| row.q_rad.len());
    parts(&|row| Some(row.target as i64))
        || parts(&|row| row.reading.fixed_point().map(|point| point as i64))
        || parts(&|row| Some(i64::from(row.reading.involves_arm())))
        || (0..joints).any(|joint| parts(&|row| row.direction.map(|signs| i64::from(signs[joint]))))
}

/// Whether nearly all rows behind the first part would follow, by their stamps, a row of the same joints in another part.
fn sorted_by_repeat(rows: &[MeasurementRow], sessions: &[Session], kinds: &[JointKind]) -> bool {
    let mut order: Vec<(f64, usize, usize)> = Vec::with_capacity(rows.len());
    for (number, session) in sessions.iter().enumerate() {
        order.extend(session.rows.clone().filter_map(|row| Some((rows[row].t_min?, number, row))));
    }
    sorting::by(&mut order, |a, b| a.0.total_cmp(&b.0).then(a.2.cmp(&b.2)));
    let repeats = order.windows(2).filter(|pair| {
        let [(before_min, first, before), (at_min, second, at)] = [pair[0], pair[1]];
        second > first && at_min > before_min && !rows[before].is_apart_from(&rows[at], kinds)
    });
    let behind = sessions.iter().skip(1).map(|session| session.rows.len()).sum::<usize>();
    repeats.count() as f64 >= REPEATS * behind as f64
}

#[cfg(test)]
mod tests {
    use crate::Measurements;

    /// How much earlier than the last session's clock that of each row's began; rows of minute, joint 1 in degrees and target.
    fn earlier_min(rows: &[(f64, f64, &str)]) -> Vec<f64> {
        // A reading of its own.
        earlier_min_reading(rows, |k| 1.0 + 1e-3 * k as f64)
    }

    /// The same of rows that read `x_mm`.
    fn earlier_min_reading(rows: &[(f64, f64, &str)], x_mm: impl Fn(usize) -> f64) -> Vec<f64> {
        let mut text = "t_min,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm,target\n".to_owned();
        for (k, (t_min, q1_deg, target)) in rows.iter().enumerate() {
            text.push_str(&format!("{t_min},{q1_deg},0,0,0,0,0,{},2,3,{target}\n", x_mm(k)));
        }
        Measurements::from_csv(text.as_bytes()).unwrap().rows.iter().map(|row| row.earlier_min).collect()
    }

    /// A day of ten rows from minute 1 to 10, and one of eight from 0.5 to 7.5. By hand: an hour after minute 10 it is minute 0.5, so the first
    /// day's clock is 69.5 minutes ahead.
    #[test]
    fn minutes_that_begin_anew_are_another_session() {
        let day = |rows: u32, first_min: f64| {
            let row = move |k: u32| (first_min + f64::from(k), f64::from(7 * k + rows), "A");
            (0..rows).map(row).collect::<Vec<_>>()
        };
        let earlier = earlier_min(&[day(10, 1.0), day(8, 0.5)].concat());
        assert_eq!(earlier, [vec![69.5; 10], vec![0.0; 8]].concat());
        let third = earlier_min(&[day(10, 1.0), day(8, 0.5), day(8, 0.5)].concat());
        assert_eq!((third[0], third[10], third[18]), (69.5 + 67.0, 67.0, 0.0));
    }

    /// Ten rows that read thousandths, pasted twice: one session, though rows were measured behind the second paste. The same pose and minute with
    /// other readings is a session, also where the instrument reads whole millimetres and all rows but one are alike; where all are, it is a paste.
    #[test]
    fn a_block_that_was_pasted_is_no_session() {
        let day = |rows: u32| (0..rows).map(|k| (f64::from(k), f64::from(7 * k), "A")).collect::<Vec<_>>();
        let pasted = [day(10), day(10), day(14)].concat();
        let at_row = |k: usize| if k < 20 { k % 10 } else { k - 20 };
        let fine = |k: usize| 1.0 + 1.234e-3 * at_row(k) as f64;
        assert_eq!(earlier_min_reading(&pasted, fine), [0.0; 34]);
        // A true second day behind them: 13 minutes and an hour later.
        let days = [pasted, day(10)].concat();
        let earlier = earlier_min_reading(&days, |k| if k < 34 { fine(k) } else { 2.0 + 1e-3 * k as f64 });
        assert_eq!(earlier, [vec![73.0; 34], vec![0.0; 10]].concat());
        let two = [day(10), day(10)].concat();
        let whole = |k: usize| f64::from(u8::from(k == 15)) + 5.0;
        assert_eq!(earlier_min_reading(&two, whole)[..10], [69.0; 10]);
        assert_eq!(earlier_min_reading(&two, |_| 5.0), [0.0; 20]);
    }

    #[test]
    fn rows_that_are_out_of_order_are_no_sessions() {
        let none = |rows: &[(f64, f64, &str)]| assert!(earlier_min(rows).iter().all(|min| *min == 0.0));
        let rows = |minutes: &mut dyn Iterator<Item = f64>, target: &'static str, turn_deg: f64| {
            minutes.map(|t_min| (t_min, turn_deg + 3.0 * t_min.floor(), target)).collect::<Vec<_>>()
        };
        let every = |from: f64| (0..20).map(move |k| from + f64::from(k));
        // One stamp that is mistyped, a part of the file in the wrong place, a few rows.
        let mut mistyped = rows(&mut every(0.0), "A", 0.0);
        mistyped[10].0 = 0.2;
        none(&mistyped);
        mistyped[10].0 = 1000.0;
        none(&mistyped);
        none(&[rows(&mut every(20.0), "A", 0.0), rows(&mut every(0.0), "A", 0.0)].concat());
        none(&[rows(&mut every(0.0), "A", 0.0), rows(&mut every(0.0).take(5), "A", 1.0)].concat());
        // Sorted by target, by repeat, by pose.
        none(&[rows(&mut every(0.0), "A", 0.0), rows(&mut every(0.4), "B", 1.0)].concat());
        none(&[rows(&mut every(0.0), "A", 0.0), rows(&mut every(0.4), "A", 0.0)].concat());
        let pose = |pose: f64| (0..20).map(|k| (pose + 2.0 * f64::from(k), pose, "A")).collect::<Vec<_>>();
        none(&[pose(0.0), pose(1.0)].concat());
        // Shuffled.
        none(&(0..40).map(|k| (f64::from((7 * k) % 40), f64::from(k), "A")).collect::<Vec<_>>());
    }
}

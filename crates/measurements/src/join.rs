//! Points and joints in two files: their rows put together.

use super::MeasureError;
use super::column_names;
use super::error::missing_column;
use super::table::{Line, Table};
use std::collections::BTreeMap;

/// What tells which joints belong to a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MatchBy {
    /// The same `id` (or, without it, `pose_id`) in both.
    Id,
    /// The first with the first, the second with the second.
    Order,
    /// The row that is nearest in `t_min`.
    Time,
}

/// A table put together, and what stayed alone.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Joined {
    /// Each point with its joints; lines count in the file of points.
    pub table: Table,
    /// Lines of points without joints.
    pub unmatched_points: Vec<u64>,
    /// Lines of joints without a point.
    pub unmatched_joints: Vec<u64>,
}

/// Puts `points` and `joints` together. Nests (`kind` base) need no joints. Several points (reflectors) may share
/// their joints, but for [`MatchBy::Order`]. `within_min` is the longest time between the two of [`MatchBy::Time`].
///
/// # Errors
/// A column that is needed and not there, an id that stands twice with the joints, a time that is none.
pub fn join(points: &Table, joints: &Table, by: MatchBy, within_min: f64) -> Result<Joined, MeasureError> {
    column_names::joints(|name| joints.column(name).is_some())
        .map_err(|name| missing_column(name, &joints.header))?;
    let kind = points.column("kind");
    let is_nest = |line: &Line| {
        kind.and_then(|k| line.cells.get(k)).is_some_and(|cell| cell.eq_ignore_ascii_case("base"))
    };
    let arm: Vec<&Line> = points.lines.iter().filter(|line| !is_nest(line)).collect();
    let found: Vec<Option<usize>> = match by {
        MatchBy::Order => (0..arm.len()).map(|k| (k < joints.lines.len()).then_some(k)).collect(),
        MatchBy::Id => by_id(points, joints, &arm)?,
        MatchBy::Time => by_time(points, joints, &arm, within_min)?,
    };
    let of_line: BTreeMap<u64, usize> =
        arm.iter().zip(&found).filter_map(|(line, k)| Some((line.number, (*k)?))).collect();
    // Of columns in both the point's are kept.
    let more: Vec<usize> =
        (0..joints.header.len()).filter(|&k| points.column(&joints.header[k]).is_none()).collect();
    let own_names = points.own_names.and(&joints.own_names);
    let mut table = Table { header: points.header.clone(), lines: Vec::new(), own_names };
    table.header.extend(more.iter().map(|&k| joints.header[k].clone()));
    let mut joined = Joined::default();
    for line in &points.lines {
        let own = of_line.get(&line.number).and_then(|&k| joints.lines.get(k));
        if own.is_none() && !is_nest(line) {
            joined.unmatched_points.push(line.number);
            continue;
        }
        let mut cells = line.cells.clone();
        cells.resize(points.header.len(), String::new());
        cells.extend(more.iter().map(|&k| own.and_then(|l| l.cells.get(k)).cloned().unwrap_or_default()));
        table.lines.push(Line { number: line.number, cells });
    }
    let taken: std::collections::BTreeSet<usize> = of_line.into_values().collect();
    joined.unmatched_joints =
        joints.lines.iter().enumerate().filter(|(k, _)| !taken.contains(k)).map(|(_, l)| l.number).collect();
    joined.table = table;
    Ok(joined)
}

fn by_id(points: &Table, joints: &Table, arm: &[&Line]) -> Result<Vec<Option<usize>>, MeasureError> {
    let name = ["id", "pose_id"]
        .into_iter()
        .find(|name| points.column(name).is_some() && joints.column(name).is_some())
        .ok_or_else(|| {
            missing_column("id", if points.column("id").is_none() { &points.header } else { &joints.header })
        })?;
    // Rows without a name belong to none of the other file.
    let cell = |table: &Table, line: &Line| -> Option<String> {
        table.column(name).and_then(|k| line.cell(k)).map(str::to_owned)
    };
    let mut known: BTreeMap<String, usize> = BTreeMap::new();
    for (k, line) in joints.lines.iter().enumerate() {
        let Some(id) = cell(joints, line) else { continue };
        if let Some(first) = known.insert(id.clone(), k) {
            let first = joints.lines.get(first).map_or(0, |l| l.number);
            return Err(MeasureError::DoubledId { id, lines: [first, line.number] });
        }
    }
    Ok(arm.iter().map(|line| cell(points, line).and_then(|id| known.get(&id).copied())).collect())
}

fn by_time(
    points: &Table,
    joints: &Table,
    arm: &[&Line],
    within_min: f64,
) -> Result<Vec<Option<usize>>, MeasureError> {
    // Rows without a time belong to none of the other file.
    let time = |table: &Table, line: &Line| -> Result<Option<f64>, MeasureError> {
        let at = table.column("t_min").ok_or_else(|| missing_column("t_min", &table.header))?;
        let Some(text) = line.cell(at) else { return Ok(None) };
        let t_min = text.parse().ok().filter(|t: &f64| t.is_finite());
        t_min.map(Some).ok_or_else(|| MeasureError::NotANumber {
            line: line.number,
            column: "t_min".to_owned(),
            text: text.chars().take(40).collect(),
            hint: "",
        })
    };
    let mut times = Vec::with_capacity(joints.lines.len());
    for (k, line) in joints.lines.iter().enumerate() {
        times.extend(time(joints, line)?.map(|t_min| (t_min, k)));
    }
    sorting::by(&mut times, |a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    arm.iter()
        .map(|line| {
            let Some(at_min) = time(points, line)? else { return Ok(None) };
            let after = times.partition_point(|t| t.0 < at_min);
            let near = [after.checked_sub(1), Some(after)].into_iter().flatten().filter_map(|i| times.get(i));
            let best = near.min_by(|a, b| (a.0 - at_min).abs().total_cmp(&(b.0 - at_min).abs()));
            Ok(best.filter(|t| (t.0 - at_min).abs() <= within_min).map(|t| t.1))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const JOINT_HEADER: &str = "q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg";

    fn table(text: &str) -> Table {
        Table::from_csv(text.as_bytes()).unwrap()
    }

    fn q1(joined: &Joined) -> Vec<&str> {
        let at = joined.table.column("q1_deg").unwrap();
        joined.table.lines.iter().map(|l| l.cells[at].as_str()).collect()
    }

    #[test]
    fn by_id_reflectors_share_joints_and_who_is_alone_is_named() {
        let points = table("id,target,x_mm,y_mm,z_mm\nP1,A,1,2,3\nP1,B,4,5,6\nP9,A,7,8,9\nP2,A,1,1,1\n");
        let joints =
            table(&format!("id,{JOINT_HEADER}\nP2,20,0,0,0,0,0\nP1,10,0,0,0,0,0\nP3,30,0,0,0,0,0\n"));
        let joined = join(&points, &joints, MatchBy::Id, 0.0).unwrap();
        assert_eq!(q1(&joined), ["10", "10", "20"]);
        assert_eq!((joined.unmatched_points, joined.unmatched_joints), (vec![4], vec![4]));
        let twice = table(&format!("id,{JOINT_HEADER}\nP1,1,0,0,0,0,0\nP1,2,0,0,0,0,0\n"));
        let error = join(&points, &twice, MatchBy::Id, 0.0).unwrap_err();
        assert_eq!(error, MeasureError::DoubledId { id: "P1".to_owned(), lines: [2, 3] });
    }

    /// One row of joints without an id, and then two: neither is that of the points without one.
    #[test]
    fn rows_without_an_id_are_matched_with_none() {
        let points = table("id,x_mm,y_mm,z_mm\n,1,2,3\nP1,4,5,6\n-,7,8,9\n");
        for (more, unmatched) in [("", vec![2]), ("n/a,30,0,0,0,0,0\n,40,0,0,0,0,0\n", vec![2, 4, 5])] {
            let joints = format!("id,{JOINT_HEADER}\n,10,0,0,0,0,0\nP1,20,0,0,0,0,0\n{more}");
            let joined = join(&points, &table(&joints), MatchBy::Id, 0.0).unwrap();
            assert_eq!(q1(&joined), ["20"]);
            assert_eq!((joined.unmatched_points, joined.unmatched_joints), (vec![2, 4], unmatched));
        }
    }

    #[test]
    fn by_order_nests_are_passed_over() {
        let points = table("kind,x_mm,y_mm,z_mm\npose,1,2,3\nbase,0,0,0\npose,4,5,6\npose,7,8,9\n");
        let joints = table(&format!("{JOINT_HEADER}\n10,0,0,0,0,0\n20,0,0,0,0,0\n"));
        let joined = join(&points, &joints, MatchBy::Order, 0.0).unwrap();
        assert_eq!(q1(&joined), ["10", "", "20"]);
        assert_eq!((joined.unmatched_points, joined.unmatched_joints), (vec![5], vec![]));
    }

    #[test]
    fn rows_without_a_time_are_matched_with_none() {
        let points = table("t_min,x_mm,y_mm,z_mm\n1,1,2,3\nNaN,4,5,6\n3,7,8,9\n");
        let joints =
            table(&format!("t_min,{JOINT_HEADER}\n1,10,0,0,0,0,0\n-,20,0,0,0,0,0\n3,30,0,0,0,0,0\n"));
        let joined = join(&points, &joints, MatchBy::Time, 0.15).unwrap();
        assert_eq!(q1(&joined), ["10", "30"]);
        assert_eq!((joined.unmatched_points, joined.unmatched_joints), (vec![3], vec![3]));
        let wrong = table("t_min,x_mm,y_mm,z_mm\nnoon,1,2,3\n");
        let error = join(&wrong, &joints, MatchBy::Time, 0.15).unwrap_err();
        assert!(matches!(error, MeasureError::NotANumber { line: 2, .. }), "{error}");
    }

    #[test]
    fn by_time_the_nearest_within_the_limit() {
        let points = table("t_min,x_mm,y_mm,z_mm\n1.02,1,2,3\n2.9,4,5,6\n9,7,8,9\n");
        let joints =
            table(&format!("t_min,{JOINT_HEADER}\n3,30,0,0,0,0,0\n1,10,0,0,0,0,0\n2,20,0,0,0,0,0\n"));
        let joined = join(&points, &joints, MatchBy::Time, 0.15).unwrap();
        assert_eq!(q1(&joined), ["10", "30"]);
        assert_eq!((joined.unmatched_points, joined.unmatched_joints), (vec![4], vec![4]));
    }
}

//! What speaks against the times of touches: one that does not fit among its neighbours in the file, a pause beyond all proportion.

use super::MeasureError;
use super::gaps::MOST_LINES;
use rapid_syntax::diagnostic::{Diagnostic, counted, first_few, is_or_are};
use robot_model::deform::TIMES_MIN;
use std::collections::BTreeSet;

/// Share of rows out of order from which on it is the order of the rows that is doubted, not single cells.
const MANY: f64 = 0.1;
/// A pause so many times as long as all other time together is looked at by a person.
const BEYOND_PROPORTION: f64 = 5.0;

/// A row's line, point and minute.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct StampedRow {
    /// Line in the file, from 1.
    pub line: u64,
    /// Which point was touched.
    pub point: usize,
    /// Minutes since the cold start, as written.
    pub t_min: f64,
}

/// Warnings about the times of `rows`, which are in the file's order.
///
/// # Errors
/// A minute that no warm-up has, naming its line.
pub(super) fn check(rows: &[StampedRow]) -> Result<Vec<Diagnostic>, MeasureError> {
    let impossible = |row: &StampedRow, why| MeasureError::Impossible {
        line: row.line,
        column: "t_min".to_owned(),
        text: format!("{:?}", row.t_min),
        why,
    };
    if let Some(row) = rows.iter().find(|row| row.t_min.abs() > *TIMES_MIN.end()) {
        return Err(impossible(row, "minutes since the cold start, and no warm-up lasts longer than a year"));
    }
    if let Some(row) = rows.iter().find(|row| row.t_min < 0.0) {
        return Err(impossible(
            row,
            "minutes count from the cold start, and before it the arm is not touched",
        ));
    }
    if let Some(error) = several_warm_ups(rows) {
        return Err(error);
    }
    Ok(out_of_order(rows).into_iter().chain(beyond_proportion(rows)).collect())
}

/// Rows of a point that make a warm-up by themselves.
const FEWEST_OF_WARM_UP: usize = 4;

/// That most points were touched in one warm-up after the other: the minutes of each run back now and then and are in order between.
fn several_warm_ups(rows: &[StampedRow]) -> Option<MeasureError> {
    let points: BTreeSet<usize> = rows.iter().map(|row| row.point).collect();
    let mut begun: Vec<Vec<u64>> = Vec::new();
    for &point in &points {
        let own: Vec<&StampedRow> = rows.iter().filter(|row| row.point == point).collect();
        let runs: Vec<&[&StampedRow]> = own.chunk_by(|a, b| a.t_min <= b.t_min).collect();
        if runs.len() > 1 && runs.iter().all(|run| run.len() >= FEWEST_OF_WARM_UP) && begin_anew(&runs) {
            begun.push(runs[1..].iter().map(|run| run[0].line).collect());
        }
    }
    let count = 1 + begun.iter().map(Vec::len).max()?;
    let line = begun.iter().filter_map(|lines| lines.first().copied()).min()?;
    (2 * begun.len() > points.len()).then_some(MeasureError::SeveralWarmUps { line, count })
}

/// Whether the minutes of each of `runs` begin before those of the one before have got to their middle, and go on from there: a mistyped minute
/// ends a run, too, and the next goes on where it was.
fn begin_anew(runs: &[&[&StampedRow]]) -> bool {
    runs.windows(2).all(|pair| match pair {
        [before, [first, second, ..]] => {
            let middle = before.get(before.len() / 2);
            middle.is_some_and(|row| first.t_min < row.t_min)
                && before.last().is_some_and(|row| second.t_min < row.t_min)
        }
        _ => false,
    })
}

/// Rows whose minute does not fit between those of the rows around them; where the file goes through its points one by one, those
/// of the same point.
fn out_of_order(rows: &[StampedRow]) -> Option<Diagnostic> {
    let is_many = |odd: &[OddRow]| odd.len() > 1 && odd.len() as f64 > MANY * rows.len() as f64;
    let mut odd = odd_rows(rows);
    if is_many(&odd) {
        let points: BTreeSet<usize> = rows.iter().map(|row| row.point).collect();
        let of = |point| rows.iter().filter(|row| row.point == point).copied().collect::<Vec<_>>();
        odd = points.into_iter().flat_map(|point| odd_rows(&of(point))).collect();
    }
    let first = odd.first()?;
    if is_many(&odd) {
        let text = format!(
            "t_min runs back: {} of {} rows are not in order of time (first: line {})",
            odd.len(),
            rows.len(),
            first.line
        );
        let help = "they are taken in the order of t_min; where the rows are in order and the stamps are not, correct them";
        return Some(Diagnostic::warning("measure::time-order", text).help(help));
    }
    let named: Vec<&str> = odd.iter().map(|row| row.text.as_str()).collect();
    let text = format!(
        "column t_min: {} {} out of order: {}",
        counted(odd.len(), "row"),
        is_or_are(odd.len()),
        first_few(&named, MOST_LINES)
    );
    let help = "correct them; they are taken in the order of t_min as it is written";
    Some(Diagnostic::warning("measure::time-step-back", text).help(help))
}

/// A row that is out of order.
struct OddRow {
    line: u64,
    /// `line 7 says 6000 between 55 and 65`.
    text: String,
}

fn odd_rows(rows: &[StampedRow]) -> Vec<OddRow> {
    let is_kept = longest_in_order(rows);
    let odd = (0..rows.len()).filter(|&k| !is_kept[k]);
    odd.map(|k| {
        let at = |k: usize| rows[k].t_min;
        let before = (0..k).rev().find(|&i| is_kept[i]).map(at);
        let after = (k + 1..rows.len()).find(|&i| is_kept[i]).map(at);
        let beside = match (before, after) {
            (Some(before), Some(after)) => format!(" between {before} and {after}"),
            (Some(before), None) => format!(" after {before}"),
            (None, Some(after)) => format!(" before {after}"),
            (None, None) => String::new(),
        };
        OddRow { line: rows[k].line, text: format!("line {} says {}{beside}", rows[k].line, at(k)) }
    })
    .collect()
}

/// Which rows belong to a longest choice whose minutes never run back.
fn longest_in_order(rows: &[StampedRow]) -> Vec<bool> {
    // The last row of the best choice of each length so far (Fredman 1975), and which row stands before each in its choice.
    let mut ends: Vec<usize> = Vec::new();
    let mut before: Vec<Option<usize>> = Vec::with_capacity(rows.len());
    for (k, row) in rows.iter().enumerate() {
        let length = ends.partition_point(|&end| rows[end].t_min <= row.t_min);
        before.push(length.checked_sub(1).map(|last| ends[last]));
        match ends.get_mut(length) {
            Some(end) => *end = k,
            None => ends.push(k),
        }
    }
    let mut is_kept = vec![false; rows.len()];
    let mut next = ends.last().copied();
    while let Some(k) = next {
        is_kept[k] = true;
        next = before[k];
    }
    is_kept
}

/// A pause that outlasts everything else by far: a robot that stood over the weekend, or a minute with a digit too many.
fn beyond_proportion(rows: &[StampedRow]) -> Option<Diagnostic> {
    let mut in_time = rows.to_vec();
    sorting::by(&mut in_time, |a, b| a.t_min.total_cmp(&b.t_min));
    let span_min = in_time.last()?.t_min - in_time.first()?.t_min;
    let pair =
        in_time.windows(2).max_by(|a, b| (a[1].t_min - a[0].t_min).total_cmp(&(b[1].t_min - b[0].t_min)))?;
    let pause_min = pair[1].t_min - pair[0].t_min;
    let rest_min = span_min - pause_min;
    if rest_min <= 0.0 || pause_min <= BEYOND_PROPORTION * rest_min {
        return None;
    }
    let text = format!(
        "column t_min: {pause_min} minutes lie between lines {} ({}) and {} ({}), and {rest_min} minutes are all the rest",
        pair[0].line, pair[0].t_min, pair[1].line, pair[1].t_min
    );
    Some(Diagnostic::warning("measure::time-gap", text).help(
        "correct the minute where it is mistyped; else it is taken for a time in which the robot stood",
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(minutes: &[f64]) -> Vec<StampedRow> {
        minutes.iter().zip(2..).map(|(&t_min, line)| StampedRow { line, point: 0, t_min }).collect()
    }

    fn warnings(minutes: &[f64]) -> Vec<(&'static str, String)> {
        check(&rows(minutes)).unwrap().into_iter().map(|w| (w.code, w.message)).collect()
    }

    fn every_five_minutes() -> Vec<f64> {
        (0..37).map(|k| 5.0 * f64::from(k)).collect()
    }

    #[test]
    fn a_mistyped_minute_is_named_with_its_neighbours() {
        assert_eq!(warnings(&every_five_minutes()), []);
        let mut minutes = every_five_minutes();
        minutes[12] = 6000.0;
        let found = warnings(&minutes);
        assert_eq!(found[0].0, "measure::time-step-back");
        assert_eq!(found[0].1, "column t_min: 1 row is out of order: line 14 says 6000 between 55 and 65");
        assert_eq!(found[1].0, "measure::time-gap");
        minutes[12] = 6.0;
        let found = warnings(&minutes);
        assert_eq!(found.len(), 1);
        assert!(found[0].1.ends_with("line 14 says 6 between 55 and 65"), "{found:?}");
    }

    #[test]
    fn a_digit_too_many_in_the_last_minute_is_named() {
        let mut minutes = every_five_minutes();
        minutes[36] = 1800.0;
        let found = warnings(&minutes);
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].0, "measure::time-gap");
        assert!(found[0].1.contains("between lines 37 (175) and 38 (1800)"), "{found:?}");
    }

    #[test]
    fn points_one_after_the_other_are_each_in_order() {
        let minutes: Vec<f64> = [every_five_minutes(), every_five_minutes(), every_five_minutes()].concat();
        let several = MeasureError::SeveralWarmUps { line: 39, count: 3 };
        assert_eq!(check(&rows(&minutes)), Err(several), "of one point");
        let mut by_point = rows(&minutes);
        by_point.iter_mut().enumerate().for_each(|(k, row)| row.point = k / 37);
        assert_eq!(check(&by_point), Ok(Vec::new()));
        by_point[40].t_min = 150.0;
        let found = check(&by_point).unwrap();
        assert!(found[0].message.ends_with("line 42 says 150 between 10 and 20"), "{found:?}");
    }

    /// Rows in no order have no warm-ups: they are told as that.
    #[test]
    fn rows_in_no_order_are_no_warm_ups() {
        let minutes: Vec<f64> = (0..37).map(|k| 5.0 * f64::from(k * 17 % 37)).collect();
        assert_eq!(warnings(&minutes)[0].0, "measure::time-order");
    }

    #[test]
    fn a_pause_for_lunch_is_no_matter_and_a_minute_beyond_a_year_is_refused() {
        let mut minutes = every_five_minutes();
        minutes.iter_mut().skip(20).for_each(|t_min| *t_min += 60.0);
        assert_eq!(warnings(&minutes), []);
        minutes[36] = 1e9;
        let error = check(&rows(&minutes)).unwrap_err().to_string();
        assert!(error.contains("line 38, column t_min") && error.contains("longer than a year"), "{error}");
        minutes[36] = -5.0;
        let error = check(&rows(&minutes)).unwrap_err().to_string();
        assert!(error.contains("line 38, column t_min") && error.contains("from the cold start"), "{error}");
    }
}

//! Minutes of the day that pass midnight: they begin at 0 again, and the measurement goes on.

use super::MeasurementRow;
use rapid_syntax::diagnostic::{Diagnostic, first_few, plural};
use robot_model::units::min_from_days;
use statistics::median;

/// Over midnight no more time passes than so many usual gaps between rows, and at least and at most so many minutes: what begins anew after longer
/// is another session.
const GAPS: f64 = 10.0;
const LONGEST_MIN: [f64; 2] = [30.0, 120.0];
/// Lines that are named.
const LISTED: usize = 5;

/// Lets the minutes of `rows`, as the file has them, go on over each midnight, and says at which lines; nothing where they run back for another
/// reason.
pub(super) fn pass_midnight(rows: &mut [MeasurementRow]) -> Option<Diagnostic> {
    let day_min = min_from_days(1.0);
    let stamped: Vec<(usize, f64)> =
        rows.iter().enumerate().filter_map(|(row, of)| Some((row, of.t_min?))).collect();
    if !stamped.iter().all(|(_, t_min)| (0.0..=day_min).contains(t_min)) {
        return None;
    }
    let steps = || stamped.windows(2).map(|pair| (pair[1].0, pair[1].1 - pair[0].1));
    let mut forward: Vec<f64> = steps().map(|(_, step)| step).filter(|step| *step > 0.0).collect();
    let [least_min, most_min] = LONGEST_MIN;
    let longest_min = (GAPS * median(&mut forward)).clamp(least_min, most_min);
    let back: Vec<(usize, f64)> = steps().filter(|(_, step)| *step < 0.0).collect();
    if back.is_empty() || back.iter().any(|(_, step)| step + day_min > longest_min) {
        return None;
    }
    let midnights: Vec<usize> = back.into_iter().map(|(row, _)| row).collect();
    for (row, _) in stamped {
        let days = midnights.partition_point(|midnight| *midnight <= row);
        rows[row].t_min = rows[row].t_min.map(|t_min| t_min + day_min * days as f64);
    }
    let lines: Vec<u64> = midnights.iter().map(|&row| rows[row].line).collect();
    let text = format!(
        "t_min passes midnight before {} {}: it is taken to go on there",
        plural(lines.len(), "line"),
        first_few(&lines, LISTED)
    );
    Some(Diagnostic::warning("measure::midnight", text).help("write the minutes since the cold start"))
}

#[cfg(test)]
mod tests {
    use crate::Measurements;

    /// Minutes, and the lines that are said to stand behind midnight, of a file of these minutes.
    fn read(minutes: &[f64]) -> (Vec<f64>, Vec<String>) {
        let rows: Vec<String> = minutes.iter().map(|t_min| format!("{t_min},1,2,3,4,5,6,7,8,9")).collect();
        let text =
            format!("t_min,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n{}\n", rows.join("\n"));
        let found = Measurements::from_csv(text.as_bytes()).unwrap();
        let said = found.warnings.iter().filter(|warning| warning.code == "measure::midnight");
        let said = said.map(|warning| warning.message.clone()).collect();
        (found.rows.iter().filter_map(|row| row.t_min).collect(), said)
    }

    #[test]
    fn minutes_go_on_over_midnight() {
        let (minutes, said) = read(&[1430.0, 1435.0, 1439.5, 2.0, 7.0, 12.0]);
        assert_eq!(minutes, [1430.0, 1435.0, 1439.5, 1442.0, 1447.0, 1452.0]);
        assert!(said.len() == 1 && said[0].contains("before line 5"), "{said:?}");
        // A warm-up that begins anew after hours, a stamp that was mistyped, and minutes of more than a day stay as they are.
        for stay in [
            &[0.0, 300.0, 600.0, 900.0, 0.0, 300.0][..],
            &[10.0, 15.0, 20.0, 2.0, 25.0, 30.0],
            &[1430.0, 1439.0, 1500.0, 2.0, 7.0, 12.0],
        ] {
            let (minutes, said) = read(stay);
            assert!(minutes == stay && said.is_empty(), "{minutes:?} {said:?}");
        }
    }
}

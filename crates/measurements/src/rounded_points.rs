//! Coordinates that were rounded on their way into the file: a spreadsheet shows whole millimetres, and saves what it shows.

use super::column_names::POINT;
use super::{MeasurementRow, Reading};
use rapid_syntax::diagnostic::{Diagnostic, is_or_are};
use robot_model::units::mm_from_m;
use std::collections::BTreeSet;

/// Fewer rows may stand at whole millimetres by chance, or as they were commanded.
const FEWEST: usize = 12;
/// Steps that a column may be rounded to, the coarsest first, millimetres. A finer one is below what moves an arm's answer.
const STEPS_MM: [f64; 2] = [1.0, 0.1];
/// Numbers this near to a step are on it, as a share of the step: they went through metres.
const ON_STEP: f64 = 1e-6;

/// The warning of coordinates that are rounded to a millimetre, or one or two of them to a tenth where another is not.
pub(super) fn rounded_points(rows: &[MeasurementRow], used: &[usize]) -> Option<Diagnostic> {
    let points_mm: Vec<[f64; 3]> = used
        .iter()
        .filter_map(|&i| match rows.get(i)?.reading {
            Reading::Point { position_m } => Some([0, 1, 2].map(|k| mm_from_m(position_m[k]))),
            _ => None,
        })
        .collect();
    if points_mm.len() < FEWEST {
        return None;
    }
    let steps_mm = [0, 1, 2].map(|k| step_mm(points_mm.iter().map(|point| point[k])));
    let is_fine = |step_mm: &Option<f64>| *step_mm == Some(0.0);
    let (coarsest, others_fine) =
        (steps_mm.iter().flatten().copied().fold(0.0, f64::max), steps_mm.iter().any(is_fine));
    let all_whole = steps_mm.iter().all(|step_mm| *step_mm == Some(STEPS_MM[0]));
    if coarsest == 0.0 || !(others_fine || all_whole) {
        return None;
    }
    let names: Vec<&str> = POINT
        .into_iter()
        .zip(steps_mm)
        .filter(|(_, step)| *step == Some(coarsest))
        .map(|(name, _)| name)
        .collect();
    let text =
        format!("{} {} rounded to {coarsest} mm in all rows", names.join(", "), is_or_are(names.len()));
    Some(
        Diagnostic::warning("measure::rounded-points", text)
            .help("what is smaller cannot be told from such a file: export it again with all decimals, past any spreadsheet that shows fewer"),
    )
}

/// The coarsest step on which all values lie, 0 where they lie on none; `None` where many are equal, so that nothing can be said.
fn step_mm(values_mm: impl Iterator<Item = f64> + Clone) -> Option<f64> {
    let distinct: BTreeSet<u64> = values_mm.clone().map(f64::to_bits).collect();
    if 2 * distinct.len() < values_mm.clone().count() {
        return None;
    }
    let is_on = |step_mm: f64| {
        values_mm.clone().all(|value_mm| {
            let steps = value_mm / step_mm;
            (steps - steps.round()).abs() < ON_STEP * steps.abs().max(1.0)
        })
    };
    Some(STEPS_MM.into_iter().find(|step_mm| is_on(*step_mm)).unwrap_or(0.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Measurements;

    /// What is said of twenty points whose coordinates have so many decimals.
    fn said(decimals: [usize; 3]) -> Option<String> {
        let mut text = "q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n".to_owned();
        for i in 0..20 {
            let point: Vec<String> = decimals
                .iter()
                .enumerate()
                .map(|(k, decimals)| {
                    format!("{:.decimals$}", 900.0 * (0.618_034 * f64::from(3 * i) + k as f64).sin())
                })
                .collect();
            text.push_str(&format!("{i},0,0,0,0,0,{}\n", point.join(",")));
        }
        let file = Measurements::from_csv(text.as_bytes()).unwrap();
        rounded_points(&file.rows, &(0..20).collect::<Vec<_>>()).map(|warning| warning.message)
    }

    #[test]
    fn a_column_that_a_spreadsheet_rounded_is_named() {
        assert_eq!(said([4, 4, 0]).unwrap(), "z_mm is rounded to 1 mm in all rows");
        assert_eq!(said([0, 0, 0]).unwrap(), "x_mm, y_mm, z_mm are rounded to 1 mm in all rows");
        assert_eq!(said([1, 3, 1]).unwrap(), "x_mm, z_mm are rounded to 0.1 mm in all rows");
        // An instrument of a tenth, and one of a hundredth.
        assert_eq!([said([1, 1, 1]), said([2, 4, 4]), said([4, 4, 4])], [None, None, None]);
    }
}

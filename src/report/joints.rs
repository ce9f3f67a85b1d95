//! The offline table of joints, as CSV.

use super::review::target_name;
use super::rounded;
use crate::compensate::MinuteJoints;
use crate::program::Program;
use crate::program::motion::Origin;
use crate::units::{deg_from_rad, mm_from_m};
use std::io::{self, Write};

const HEADER: [&str; 14] = [
    "target",
    "file",
    "line",
    "t_min",
    "q1_deg",
    "q2_deg",
    "q3_deg",
    "q4_deg",
    "q5_deg",
    "q6_deg",
    "x_mm",
    "y_mm",
    "z_mm",
    "residual_mm",
];

/// Writes one row for each target and minute. A target without a name is called by its line.
///
/// # Errors
/// Those of `out`.
pub fn write_joints(
    out: &mut dyn Write,
    program: &Program,
    rows: impl Iterator<Item = MinuteJoints>,
) -> io::Result<()> {
    let mut csv = csv::Writer::from_writer(out);
    csv.write_record(HEADER)?;
    for row in rows {
        let Some(motion) = program.motions.get(row.motion) else { continue };
        let name = match motion.targets.get(row.target).map(|t| &t.origin) {
            Some(Origin::Named { name, .. }) => name.clone(),
            _ => target_name(motion).map_or_else(|| format!("L{}", motion.line), str::to_owned),
        };
        let mut record = vec![name, program.file(motion.file).path.clone(), motion.line.to_string()];
        record.push(row.t_min.to_string());
        record.extend(row.q_rad.map(|q| format!("{:.9}", deg_from_rad(q))));
        record.extend(row.position_m.map(|p| format!("{:.6}", rounded(mm_from_m(p)))));
        record.push(format!("{:e}", mm_from_m(row.residual_m)));
        csv.write_record(&record)?;
    }
    csv.flush()
}

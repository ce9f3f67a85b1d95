//! The offline table of joints, as CSV.

use super::motion_rows::target_name;
use super::rounded;
use rapid_program::compensate::MinuteJoints;
use rapid_program::program::Program;
use rapid_program::program::motion::{Origin, Target};
use robot_model::units::{deg_from_rad, mm_from_m};
use std::borrow::Cow;
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

/// A target's joints at a minute.
#[derive(Clone, Debug)]
pub struct JointRow<'a> {
    /// Name of the target.
    pub target: Cow<'a, str>,
    /// The file it stands in.
    pub file: &'a str,
    /// Line of the target in its file.
    pub line: u64,
    /// Minutes of warm-up.
    pub t_min: f64,
    /// Joint angles that are commanded, radians.
    pub q_rad: [f64; 6],
    /// Where the arm then stands, metres.
    pub position_m: [f64; 3],
    /// How far that is from where it is meant to stand, metres.
    pub residual_m: f64,
}

impl<'a> JointRow<'a> {
    /// A row of a program's motion. A target without a name is called by its line.
    #[must_use]
    pub fn of_program(program: &'a Program, row: &MinuteJoints) -> Option<Self> {
        let motion = program.motions.get(row.motion.index())?;
        let target = match motion.targets.get(row.target).map(Target::origin) {
            Some(Origin::Named { name, .. }) => name.as_str().into(),
            _ => target_name(motion).map_or_else(|| format!("L{}", motion.line).into(), Cow::Borrowed),
        };
        let file = program.file(motion.file).path.as_str();
        let MinuteJoints { t_min, q_rad, position_m, residual_m, .. } = *row;
        Some(Self { target, file, line: motion.line.into(), t_min, q_rad, position_m, residual_m })
    }
}

/// The table, written row by row. Joints have 12 decimals, so that they alone give the residual.
pub struct JointTable<W: Write>(csv::Writer<W>);

impl<W: Write> JointTable<W> {
    /// Writes the header.
    ///
    /// # Errors
    /// Those of writing to `out`.
    pub fn new(out: W) -> io::Result<Self> {
        let mut csv = csv::Writer::from_writer(out);
        csv.write_record(HEADER)?;
        Ok(Self(csv))
    }

    /// Writes a row.
    ///
    /// # Errors
    /// Those of writing to `out`.
    pub fn add(&mut self, row: JointRow<'_>) -> io::Result<()> {
        let mut record = vec![row.target.into_owned(), row.file.to_owned(), row.line.to_string()];
        record.push(row.t_min.to_string());
        record.extend(row.q_rad.map(|q| format!("{:.12}", deg_from_rad(q))));
        record.extend(row.position_m.map(|p| format!("{:.9}", rounded(mm_from_m(p)))));
        record.push(format!("{:.3e}", mm_from_m(row.residual_m)));
        Ok(self.0.write_record(&record)?)
    }

    /// Brings out what is still to be written.
    ///
    /// # Errors
    /// Those of writing to `out`.
    pub fn finish(mut self) -> io::Result<()> {
        self.0.flush()
    }
}

//! The offline table of joints, as CSV.

use super::motion_rows::target_name;
use super::rounded;
use csv::ByteRecord;
use rapid_compensation::compensate::MinuteJoints;
use rapid_program::Program;
use rapid_program::motion::{Origin, Target};
use robot_model::units::{deg_from_rad, mm_from_m};
use std::borrow::Cow;
use std::fmt::{Arguments, Write as _};
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
pub struct JointTable<W: Write> {
    csv: csv::Writer<W>,
    // Filled anew for each row: a table has ten thousand of them and more.
    record: ByteRecord,
    cell: String,
}

impl<W: Write> JointTable<W> {
    /// Writes the header.
    ///
    /// # Errors
    /// Those of writing to `out`.
    pub fn new(out: W) -> io::Result<Self> {
        let mut csv = csv::Writer::from_writer(out);
        csv.write_record(HEADER)?;
        Ok(Self { csv, record: ByteRecord::new(), cell: String::new() })
    }

    /// Writes a row.
    ///
    /// # Errors
    /// Those of writing to `out`.
    pub fn add(&mut self, row: JointRow<'_>) -> io::Result<()> {
        self.record.clear();
        self.record.push_field(row.target.as_bytes());
        self.record.push_field(row.file.as_bytes());
        self.push(format_args!("{}", row.line));
        self.push(format_args!("{}", row.t_min));
        for q_rad in row.q_rad {
            self.push(format_args!("{:.12}", deg_from_rad(q_rad)));
        }
        for position_m in row.position_m {
            self.push(format_args!("{:.9}", rounded(mm_from_m(position_m))));
        }
        self.push(format_args!("{:.3e}", mm_from_m(row.residual_m)));
        Ok(self.csv.write_byte_record(&self.record)?)
    }

    fn push(&mut self, number: Arguments<'_>) {
        self.cell.clear();
        // Writing to a `String` gives no error.
        let _ = self.cell.write_fmt(number);
        self.record.push_field(self.cell.as_bytes());
    }

    /// Brings out what is still to be written.
    ///
    /// # Errors
    /// Those of writing to `out`.
    pub fn finish(mut self) -> io::Result<()> {
        self.csv.flush()
    }
}

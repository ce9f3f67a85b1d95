//! What can be wrong with a deformation table.

use super::GrowthError;
use rapid_syntax::diagnostic::Diagnostic;
use thiserror::Error;

/// Why there is no deformation.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum DeformError {
    /// The file is not CSV.
    #[error("deformation table, line {line}: {message}")]
    Csv {
        /// Line in the file, from 1.
        line: u64,
        /// What the CSV reader says.
        message: String,
    },
    /// The header is of neither layout.
    #[error(
        "deformation table: the header `{header}` is neither the static `Dx [mm],Dy[mm],Dz[mm],DOx[deg],DOy[deg],DOz[deg]` nor the \
         scheduled `t_min,joint,dx_mm,dy_mm,dz_mm,rx_deg,ry_deg,rz_deg` (or with `temp_c` in place of `t_min`): {problem}"
    )]
    Header {
        /// The header as it was found.
        header: String,
        /// What is missing or too much.
        problem: String,
    },
    /// A field cannot be used.
    #[error("deformation table, line {line}, column {column} (`{name}`): {problem}; {remedy}")]
    Field {
        /// Line in the file, from 1.
        line: u64,
        /// Column in the line, from 1.
        column: usize,
        /// Name of the column.
        name: String,
        /// What is wrong, as a phrase.
        problem: String,
        /// What to do about it.
        remedy: &'static str,
    },
    /// A static table must have a row for each joint.
    #[error(
        "deformation table: {rows} rows; a static table has one row for each of the six joints, and optionally a seventh for the tool"
    )]
    Rows {
        /// How many there are.
        rows: usize,
    },
    /// A static table says how far, not when.
    #[error(
        "a static deformation table says how far each frame moves, not when: add a growth law, e.g. `--growth two-stage:46`, or \
         `--growth none` if the robot is always warm"
    )]
    NoGrowth,
    /// A scheduled table has its own times.
    #[error(
        "a scheduled deformation table has its own times or temperatures and takes no growth law: leave `--growth` out"
    )]
    GrowthNotUsed,
    /// The growth law cannot be read.
    #[error(transparent)]
    Growth(#[from] GrowthError),
}

impl DeformError {
    /// Stable code, listed in `docs/MESSAGES.md`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Csv { .. } => "deform::csv",
            Self::Header { .. } => "deform::header",
            Self::Field { .. } => "deform::value",
            Self::Rows { .. } => "deform::rows",
            Self::NoGrowth => "deform::no-growth",
            Self::GrowthNotUsed => "deform::growth-not-used",
            Self::Growth(_) => "deform::growth",
        }
    }
}

impl From<DeformError> for Diagnostic {
    fn from(error: DeformError) -> Self {
        Self::error(error.code(), error.to_string())
    }
}

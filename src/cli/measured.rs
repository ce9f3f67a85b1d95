//! Measurements as the options name them: one file or two, in our layout or another.

use super::model::in_file;
use super::{Console, files, idle, model};
use clap::ValueEnum;
use measurements::{ColumnMap, Joined, MatchBy, Measurements, Table, Touches, join};
use rapid_syntax::diagnostic::Diagnostic;
use rapid_syntax::diagnostic::{counted, first_few, plural};
use std::path::{Path, PathBuf};

/// Lines that a message lists at most.
const LISTED: usize = 12;

/// Where measurements come from.
#[derive(Clone, Debug, clap::Args)]
pub struct MeasurementArgs {
    /// Measurements (CSV): joints q1_deg..q6_deg, measured points x_mm, y_mm, z_mm (or fixed_id, or length_mm), and
    /// what else is known.
    #[arg(value_name = "MEASUREMENTS", required_unless_present = "points", conflicts_with = "points")]
    pub measurements: Option<PathBuf>,

    /// Instead: the measured points alone; the joints come from --joints.
    #[arg(long, value_name = "FILE", requires = "joints")]
    pub points: Option<PathBuf>,

    /// The joints of --points.
    #[arg(long, value_name = "FILE", requires = "points", conflicts_with = "measurements")]
    pub joints: Option<PathBuf>,

    /// What tells which joints belong to a point.
    #[arg(
        long = "match",
        value_name = "BY",
        value_enum,
        default_value_t = MatchName::Id,
        conflicts_with = "measurements"
    )]
    pub match_by: MatchName,

    /// With --match time: the longest time between a point and its joints [default: 0.1].
    #[arg(long, value_name = "MIN", conflicts_with = "measurements")]
    pub match_within_min: Option<f64>,

    /// Another layout: which of its columns is which of ours (TOML, docs/MEASURING.md); of --points where there are two files.
    #[arg(long, value_name = "MAP.toml")]
    pub columns: Option<PathBuf>,

    /// The same for --joints.
    #[arg(long, value_name = "MAP.toml", requires = "joints", conflicts_with = "measurements")]
    pub joints_columns: Option<PathBuf>,
}

/// The longest time between a point and its joints unless another is given, minutes.
const MATCH_WITHIN_MIN: f64 = 0.1;

/// See [`MatchBy`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum MatchName {
    /// The same id in both files.
    Id,
    /// The first with the first, the second with the second.
    Order,
    /// The nearest t_min.
    Time,
}

/// A table and where it comes from.
pub struct MeasurementInput {
    /// The table of measurements.
    pub table: Table,
    /// Names of its files.
    pub name: String,
    /// Of all their bytes.
    pub sha256: String,
}

impl MeasurementInput {
    /// A message with the file's own names of its columns.
    pub fn named(&self, message: Diagnostic) -> Diagnostic {
        let rename = |text: &str| self.table.own_names.rename(text);
        Diagnostic { message: rename(&message.message), help: message.help.as_deref().map(rename), ..message }
    }

    /// The same with the name of the file before it: an error of these measurements.
    pub fn in_file(&self, message: impl Into<Diagnostic>) -> Diagnostic {
        in_file(&self.name, self.named(message.into()))
    }

    /// Tells what a person should look at in these measurements, with the file's own names of its columns.
    pub fn report<'w>(&self, warnings: impl IntoIterator<Item = &'w Diagnostic>, console: &mut Console) {
        console.report(warnings.into_iter().map(|warning| self.named(warning.clone())));
    }
}

impl MeasurementArgs {
    /// Reads the table.
    ///
    /// # Errors
    /// A file that cannot be read, or what is wrong in it.
    pub fn table(&self, console: &mut Console) -> Result<MeasurementInput, Diagnostic> {
        if let Some(path) = &self.measurements {
            return input(path, self.columns.as_deref());
        }
        let (Some(points), Some(joints)) = (&self.points, &self.joints) else {
            return Err(Diagnostic::error("measure::file", "no measurements are named"));
        };
        let within_min = self.match_within_min.unwrap_or(MATCH_WITHIN_MIN);
        if !(within_min.is_finite() && within_min >= 0.0) {
            return Err(Diagnostic::error("option::number", "--match-within-min is a number of minutes"));
        }
        let by_time = self.match_by == MatchName::Time;
        let why = "--match time alone goes by minutes";
        idle::tell([("--match-within-min", self.match_within_min.is_some() && !by_time, why)], console);
        let mut whole = input(points, self.columns.as_deref())?;
        let other = input(joints, self.joints_columns.as_deref())?;
        let by = match self.match_by {
            MatchName::Id => MatchBy::Id,
            MatchName::Order => MatchBy::Order,
            MatchName::Time => MatchBy::Time,
        };
        let joined = join(&whole.table, &other.table, by, within_min).map_err(|error| {
            Diagnostic::error(
                "measure::match",
                format!("{} and {}: {error}", points.display(), joints.display()),
            )
        })?;
        console.report(unmatched(&joined, points, joints));
        whole.sha256 = crate::application::sha256(format!("{}{}", whole.sha256, other.sha256).as_bytes());
        whole.name = format!("{} and {}", whole.name, other.name);
        whole.table = joined.table;
        Ok(whole)
    }

    /// Reads the measurements, with the name and SHA-256 of their files.
    ///
    /// # Errors
    /// As [`MeasurementArgs::table`].
    pub fn read(&self, console: &mut Console) -> Result<(Measurements, MeasurementInput), Diagnostic> {
        let input = self.table(console)?;
        let measurements = Measurements::from_table(&input.table).map_err(|error| input.in_file(error))?;
        Ok((measurements, input))
    }

    /// Reads touches, and tells what a person should look at in them.
    ///
    /// # Errors
    /// As [`MeasurementArgs::table`].
    pub fn touches(&self, console: &mut Console) -> Result<(Touches, MeasurementInput), Diagnostic> {
        let input = self.table(console)?;
        let touches = Touches::from_table(&input.table).map_err(|error| input.in_file(error))?;
        console.report(touches.warnings.iter().map(|warning| input.in_file(warning.clone())));
        Ok((touches, input))
    }
}

/// The measurements of one file of several, which goes by its path: another may be called as it is in another folder.
///
/// # Errors
/// A file that cannot be read, or what is wrong in it.
pub fn of_file(path: &Path, columns: Option<&Path>) -> Result<(Measurements, MeasurementInput), Diagnostic> {
    let input = MeasurementInput { name: path.display().to_string(), ..input(path, columns)? };
    let measurements = Measurements::from_table(&input.table).map_err(|error| input.in_file(error))?;
    Ok((measurements, input))
}

fn input(path: &Path, columns: Option<&Path>) -> Result<MeasurementInput, Diagnostic> {
    let bytes = files::read(path, "measurement file")?;
    let shown = path.display().to_string();
    let table = match columns {
        None => Table::from_csv(&bytes).map_err(|error| in_file(&shown, error.into()))?,
        Some(map) => {
            let text = files::read(map, "column map")?;
            let map = ColumnMap::from_toml(&String::from_utf8_lossy(&text))
                .map_err(|e| Diagnostic::error("measure::map", format!("{}: {e}", map.display())))?;
            map.table(&bytes).map_err(|error| in_file(&shown, error.into()))?
        }
    };
    Ok(MeasurementInput { table, name: model::file_name(path), sha256: crate::application::sha256(&bytes) })
}

fn unmatched(joined: &Joined, points: &Path, joints: &Path) -> Vec<Diagnostic> {
    let one = |lines: &[u64], path: &Path, what: &str| {
        (!lines.is_empty()).then(|| {
            Diagnostic::warning(
                "measure::unmatched",
                format!(
                    "{}: no {what} for {} ({} {})",
                    path.display(),
                    counted(lines.len(), "row"),
                    plural(lines.len(), "line"),
                    first_few(lines, LISTED)
                ),
            )
            .help("they are left out; check --match")
        })
    };
    [one(&joined.unmatched_points, points, "joints"), one(&joined.unmatched_joints, joints, "point")]
        .into_iter()
        .flatten()
        .collect()
}

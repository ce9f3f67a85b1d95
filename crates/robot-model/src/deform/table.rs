//! Deformation tables from CSV: the static layout of the reference paper and the scheduled long form.

use super::{DeformError, Deformation, GrowthLaw, Knot, TableIndex, Tabulation};
use crate::kinematics::FrameOffsets;
use crate::units::{YEAR_MIN, m_from_mm, rad_from_deg};
use csv::{ReaderBuilder, StringRecord, Trim};
use rapid_syntax::diagnostic::LineIndex;
use std::collections::BTreeSet;

/// Columns of the scheduled layout after its index.
const SCHEDULED: [&str; 7] = ["joint", "dx_mm", "dy_mm", "dz_mm", "rx_deg", "ry_deg", "rz_deg"];
/// Columns of the static layout without blanks, lower case. The paper prints `Dy` over the first column too.
const STATIC: [&str; 6] = ["dx[mm]", "dy[mm]", "dz[mm]", "dox[deg]", "doy[deg]", "doz[deg]"];

impl Deformation {
    /// Reads a deformation table: static with a growth law, or scheduled without.
    ///
    /// # Errors
    /// [`DeformError`] with line and column; [`DeformError::NoGrowth`] for a static table without a growth law,
    /// [`DeformError::GrowthNotUsed`] for a scheduled one with it.
    pub fn from_csv(bytes: &[u8], growth: Option<GrowthLaw>) -> Result<Self, DeformError> {
        let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
        let mut reader = ReaderBuilder::new().trim(Trim::All).from_reader(bytes);
        let lines = LineIndex::new(bytes);
        let csv_error = |error: csv::Error| {
            let (line, message) = crate::csv_lines::line_and_problem(&lines, bytes, &error, false);
            DeformError::Csv { line, message }
        };
        let names = reader.headers().map_err(csv_error)?.clone();
        let layout = Layout::of(&names)?;
        let row = |cells: StringRecord| CsvRow {
            line: crate::csv_lines::line_of_record(&lines, bytes, cells.position(), false),
            cells,
        };
        let rows = reader.into_records().map(|cells| cells.map(row)).collect::<Result<Vec<_>, _>>();
        let rows = rows.map_err(csv_error)?;
        match layout {
            Layout::Static => {
                let offsets = static_rows(&names, &rows)?;
                Ok(Self::from_static(offsets, growth.ok_or(DeformError::NoGrowth)?))
            }
            Layout::Scheduled { index, columns } => {
                let knots = scheduled_rows(&names, &rows, index, columns)?;
                match growth {
                    None => Ok(Self(Tabulation::Scheduled { index, knots })),
                    Some(_) => Err(DeformError::GrowthNotUsed),
                }
            }
        }
    }
}

/// A row of the file that the table is read from.
struct CsvRow {
    line: u64,
    cells: StringRecord,
}

enum Layout {
    Static,
    /// `columns`: where the index and the seven of [`SCHEDULED`] stand.
    Scheduled {
        index: TableIndex,
        columns: [usize; 8],
    },
}

impl Layout {
    fn of(names: &StringRecord) -> Result<Self, DeformError> {
        let plain: Vec<String> = names
            .iter()
            .map(|name| name.chars().filter(|c| !c.is_whitespace()).collect::<String>().to_ascii_lowercase())
            .collect();
        let error = |problem: String| DeformError::Header {
            header: names.iter().collect::<Vec<_>>().join(","),
            problem,
        };
        let find = |wanted: &str| plain.iter().position(|name| name == wanted);
        let index = match (find("t_min"), find("temp_c")) {
            (Some(_), Some(_)) => return Err(error("it has both `t_min` and `temp_c`".to_owned())),
            (Some(column), None) => Some((TableIndex::WarmUpTime, column)),
            (None, Some(column)) => Some((TableIndex::Temperature, column)),
            (None, None) => None,
        };
        if let Some((index, column)) = index {
            let mut columns = [column; 8];
            for (slot, wanted) in columns[1..].iter_mut().zip(SCHEDULED) {
                *slot = find(wanted).ok_or_else(|| error(format!("column `{wanted}` is missing")))?;
            }
            let used: BTreeSet<usize> = columns.into_iter().collect();
            return match (0..plain.len()).find(|column| !used.contains(column)) {
                None => Ok(Self::Scheduled { index, columns }),
                Some(extra) => Err(error(format!("column `{}` is not known", &names[extra]))),
            };
        }
        if plain.len() != STATIC.len() {
            return Err(error(format!("it has {} columns", plain.len())));
        }
        for (i, (name, wanted)) in plain.iter().zip(STATIC).enumerate() {
            let misprint = i == 0 && name == "dy[mm]";
            if name != wanted && !misprint {
                return Err(error(format!("column {} is `{}`, not `{wanted}`", i + 1, &names[i])));
            }
        }
        Ok(Self::Static)
    }
}

/// The highest temperature that a table may tell of, Celsius.
const MOST_C: f64 = 1000.0;

fn static_rows(names: &StringRecord, rows: &[CsvRow]) -> Result<FrameOffsets, DeformError> {
    let mut offsets = FrameOffsets::default();
    for (i, row) in rows.iter().enumerate() {
        let values = six(names, row, [0, 1, 2, 3, 4, 5])?;
        if let Some(slot) = offsets.0.get_mut(i) {
            *slot = values;
        }
    }
    match rows.len() {
        6 | 7 => Ok(offsets),
        rows => Err(DeformError::Rows { rows }),
    }
}

fn scheduled_rows(
    names: &StringRecord,
    rows: &[CsvRow],
    by: TableIndex,
    columns: [usize; 8],
) -> Result<[Vec<Knot>; 7], DeformError> {
    let [index, joint, value_columns @ ..] = columns;
    let mut knots: [Vec<Knot>; 7] = Default::default();
    if rows.is_empty() {
        return Err(DeformError::Rows { rows: 0 });
    }
    for row in rows {
        let at = number(names, row, index)?;
        let (most, remedy) = match by {
            TableIndex::WarmUpTime => (YEAR_MIN, "no warm-up lasts longer than a year: give minutes"),
            TableIndex::Temperature => (MOST_C, "give degrees Celsius"),
        };
        if at.abs() > most {
            return Err(field_error(names, row, index, "cannot be", remedy));
        }
        let number = number(names, row, joint)?;
        let wrong_joint =
            || field_error(names, row, joint, "is no joint", "joints are 1 to 6, 7 is the tool");
        if number.fract() != 0.0 || !(1.0..=7.0).contains(&number) {
            return Err(wrong_joint());
        }
        let offsets = six(names, row, value_columns)?;
        let knots = knots.get_mut(number as usize - 1).ok_or_else(wrong_joint)?;
        if let Some(last) = knots.last()
            && last.at >= at
        {
            let remedy = "for each joint the rows must ascend, each value once";
            return Err(field_error(names, row, index, "is not after the joint's row before it", remedy));
        }
        knots.push(Knot { at, offsets });
    }
    Ok(knots)
}

/// Three lengths and three angles, in metres and radians.
fn six(names: &StringRecord, row: &CsvRow, columns: [usize; 6]) -> Result<[f64; 6], DeformError> {
    let mut values = [0.0; 6];
    for (k, (value, column)) in values.iter_mut().zip(columns).enumerate() {
        let written = number(names, row, column)?;
        *value = if k < 3 { m_from_mm(written) } else { rad_from_deg(written) };
    }
    Ok(values)
}

fn number(names: &StringRecord, row: &CsvRow, column: usize) -> Result<f64, DeformError> {
    match row.cells.get(column).unwrap_or_default().parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        _ => Err(field_error(
            names,
            row,
            column,
            "is not a finite number",
            "write a plain number with a decimal point",
        )),
    }
}

fn field_error(
    names: &StringRecord,
    row: &CsvRow,
    column: usize,
    problem: &str,
    remedy: &'static str,
) -> DeformError {
    DeformError::Field {
        line: row.line,
        column: column + 1,
        name: names.get(column).unwrap_or_default().to_owned(),
        problem: format!("`{}` {problem}", row.cells.get(column).unwrap_or_default()),
        remedy,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TWO_STAGE: Option<GrowthLaw> = Some(GrowthLaw::TwoStage { tau_min: 46.0 });
    const PAPER: &str = include_str!("../../../../fixtures/paper/table2_deformation.csv");

    fn error_text(text: &str, growth: Option<GrowthLaw>) -> String {
        Deformation::from_csv(text.as_bytes(), growth).unwrap_err().to_string()
    }

    #[test]
    fn the_papers_file_is_the_built_in_table() {
        assert_eq!(Deformation::from_csv(PAPER.as_bytes(), TWO_STAGE), Ok(Deformation::paper()));
    }

    #[test]
    fn blanks_case_and_the_misprint_are_forgiven_and_a_seventh_row_is_the_tool() {
        let text = format!("{PAPER}0,0,1.5,0,0,90\n")
            .replace("Dx [mm],Dy[mm]", "\u{feff}Dy[MM] , dy [mm]")
            .replace('\n', "\r\n");
        let offsets = Deformation::from_csv(text.as_bytes(), TWO_STAGE).unwrap().settled();
        assert_eq!(offsets.0[6], [0.0, 0.0, 0.0015, 0.0, 0.0, std::f64::consts::FRAC_PI_2]);
        assert_eq!(offsets.0[..6], Deformation::paper().settled().0[..6]);
    }

    #[test]
    fn a_static_table_needs_a_growth_law() {
        assert_eq!(Deformation::from_csv(PAPER.as_bytes(), None), Err(DeformError::NoGrowth));
    }

    #[test]
    fn faults_are_told_with_line_and_column() {
        let five = PAPER.trim_end().rsplit_once('\n').unwrap().0;
        assert!(
            error_text(five, TWO_STAGE).contains(": 5 rows; a static table has one row for each"),
            "{}",
            error_text(five, TWO_STAGE)
        );
        let nan = PAPER.replace("0.000154", "NaN");
        assert!(error_text(&nan, TWO_STAGE).contains("line 2, column 2 (`Dy[mm]`): `NaN` is not a finite"));
        let text = PAPER.replace("0.0241", "0,0241");
        assert!(error_text(&text, TWO_STAGE).contains("line 5"), "{}", error_text(&text, TWO_STAGE));
        assert!(
            error_text(&text, TWO_STAGE).contains("7 cells, the header has 6"),
            "{}",
            error_text(&text, TWO_STAGE)
        );
        let crlf = PAPER.replace("0.000154", "NaN").replace('\n', "\r\n");
        assert!(
            error_text(&crlf, TWO_STAGE).contains("line 2, column 2"),
            "{}",
            error_text(&crlf, TWO_STAGE)
        );
        let text = PAPER.replace("0.0108", "little");
        assert!(error_text(&text, TWO_STAGE).contains("line 3, column 4 (`DOx[deg]`): `little` is not"));
        let header = PAPER.replace("DOz[deg]", "DOz[rad]");
        assert!(error_text(&header, TWO_STAGE).contains("column 6 is `DOz[rad]`, not `doz[deg]`"));
        assert!(error_text("", TWO_STAGE).contains("it has 0 columns"), "{}", error_text("", TWO_STAGE));
    }

    const SCHEDULED: &str = "t_min,joint,dx_mm,dy_mm,dz_mm,rx_deg,ry_deg,rz_deg\n\
                             10,2,0.1,0,0,0,0,0\n0,1,0,0,0,0,0,0\n30,2,0.3,0,0,0,0,0.09\n60,1,0,0,0.6,0,0,0\n";

    #[test]
    fn a_schedule_is_linear_between_its_rows_and_held_after_the_last() {
        let deformation = Deformation::from_csv(SCHEDULED.as_bytes(), None).unwrap();
        assert_eq!(deformation.index(), TableIndex::WarmUpTime);
        assert_eq!(deformation.knots(), [0.0, 10.0, 30.0, 60.0]);
        assert_eq!(deformation.late_start(), Some((2, 10.0)));
        let cold = SCHEDULED.replace("10,2,0.1,", "10,2,0,");
        assert_eq!(Deformation::from_csv(cold.as_bytes(), None).unwrap().late_start(), None);
        assert_eq!(deformation.cut_off(), None, "each joint has times of its own");
        let times = || [0, 10, 20, 30].into_iter().flat_map(|t| (1..=6).map(move |joint| (t, joint)));
        let rows: Vec<String> = times().map(|(t, joint)| format!("{t},{joint},{t}e-3,0,0,0,0,0")).collect();
        let head = SCHEDULED.lines().next().unwrap();
        let of = |rows: &[String]| {
            Deformation::from_csv(format!("{head}\n{}\n", rows.join("\n")).as_bytes(), None).unwrap()
        };
        assert_eq!(of(&rows).cut_off(), None);
        assert_eq!(of(&rows[..21]).cut_off(), Some((vec![4, 5, 6], 30.0)));
        let at = |t_min: f64| deformation.offsets_at(t_min);
        assert!((at(20.0).0[1][0] - 0.2e-3).abs() < 1e-18);
        assert!((at(20.0).0[0][2] - 0.2e-3).abs() < 1e-18);
        assert!((at(0.0).0[1][0] - 0.1e-3).abs() < 1e-18, "held before its first row");
        assert_eq!(at(1e6), deformation.settled());
        assert!((deformation.settled().0[1][5] - 0.09_f64.to_radians()).abs() < 1e-18);
        assert_eq!(at(20.0).0[2], [0.0; 6], "a joint without rows stays");
    }

    #[test]
    fn temperature_can_be_the_index_and_columns_can_stand_in_any_order() {
        let text =
            "joint,temp_c,dx_mm,dy_mm,dz_mm,rx_deg,ry_deg,rz_deg\n1,20,0,0,0,0,0,0\n1,40,2,0,0,0,0,0\n";
        let deformation = Deformation::from_csv(text.as_bytes(), None).unwrap();
        assert_eq!(deformation.index(), TableIndex::Temperature);
        assert!((deformation.offsets_at(25.0).0[0][0] - 0.5e-3).abs() < 1e-18);
    }

    #[test]
    fn a_schedule_with_faults_is_refused() {
        for (from, to, expected) in [
            ("10,2,", "10,8,", "line 2, column 2 (`joint`): `8` is no joint"),
            ("10,2,", "10,1.5,", "line 2, column 2 (`joint`): `1.5` is no joint"),
            ("30,2,", "10,2,", "line 4, column 1 (`t_min`): `10` is not after"),
            ("30,2,", "525601,2,", "line 4, column 1 (`t_min`): `525601` cannot be"),
            ("rz_deg", "rz_rad", "column `rz_deg` is missing"),
            ("rz_deg", "rz_deg,note", "column `note` is not known"),
            ("t_min", "temp_c,t_min", "both `t_min` and `temp_c`"),
        ] {
            let text = error_text(&SCHEDULED.replacen(from, to, 1), None);
            assert!(text.contains(expected), "{text}");
        }
        assert_eq!(Deformation::from_csv(SCHEDULED.as_bytes(), TWO_STAGE), Err(DeformError::GrowthNotUsed));
    }
}

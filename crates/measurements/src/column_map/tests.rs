//! Tables of strangers' layouts, in what units and decimals they have them, become ours.

use super::*;
use crate::Measurements;

const NAMES: [&str; 6] = ["q1_deg", "q2_deg", "q3_deg", "q4_deg", "q5_deg", "q6_deg"];

fn map(head: &str, columns: &[&str]) -> ColumnMap {
    let columns = columns.iter().map(|name| format!("{name} = \"{name}\"\n")).collect::<String>();
    ColumnMap::from_toml(&format!("delimiter = \";\"\n{head}\n[columns]\n{columns}")).unwrap()
}

/// Whatever is to be converted, a cell that says that there is nothing is a gap of its row alone.
#[test]
fn a_cell_without_a_number_is_a_gap_in_any_unit() {
    let columns = [&NAMES[..], &["x_mm", "y_mm", "z_mm", "t_min"]].concat();
    let text = format!(
        "{}\n0;0;0;0;0;1;1;2;3;0\n0;0;0;0;0;1;NaN;2;3;1\n0;0;#REF!;0;0;1;1;2;3;2\n0;0;0;0;0;1;1;2;-;3\n0;0;0;0;0;1;1;2;3;n/a\n",
        columns.join(";")
    );
    for head in [
        "length_unit = \"m\"\njoint_unit = \"rad\"\ntime_unit = \"s\"",
        "length_unit = \"inch\"\ndecimal_comma = true",
        "",
    ] {
        let table = map(head, &columns).table(text.as_bytes()).unwrap();
        let read = Measurements::from_table(&table).unwrap();
        assert_eq!(read.rows.iter().map(|row| row.line).collect::<Vec<u64>>(), [2], "{head}");
        assert_eq!(read.warnings.len(), 4, "{head}: {:?}", read.warnings);
    }
}

#[test]
fn a_pose_or_a_time_of_day_without_a_number_is_a_gap() {
    let names = [&NAMES[..], &["t_min"]].concat();
    let text = format!(
        "{};X;Y;Z;A;B;C\n0;0;0;0;0;1;23:50;1;2;3;0;0;0\n0;0;0;0;0;1;-;1;2;3;0;0;0\n0;0;0;0;0;1;0:10;1;2;#N/A;0;0;0\n0;0;0;0;0;1;0:20;1;2;3;0;0;0\n",
        names.join(";")
    );
    let mut map = map("time_format = \"hh:mm\"\nlength_unit = \"m\"", &names);
    let columns = ["X", "Y", "Z", "A", "B", "C"].map(|name| SourceColumn::Name(name.to_owned()));
    map.pose = Some(PoseColumns { columns, rotation: Rotation::FixedXyz, angle_unit: AngleUnit::Deg });
    let read = Measurements::from_table(&map.table(text.as_bytes()).unwrap()).unwrap();
    let minutes: Vec<(u64, f64)> = read.rows.iter().map(|row| (row.line, row.t_min.unwrap())).collect();
    assert_eq!(minutes, [(2, 0.0), (5, 30.0)]);
}

#[test]
fn a_number_that_is_not_written_as_the_map_says_is_told_how() {
    let problem = |head: &str, cell: &str| {
        let text = format!("x_mm\n\"{cell}\"\n");
        map(head, &["x_mm"]).table(text.as_bytes()).unwrap_err().to_string()
    };
    let with_comma = problem("length_unit = \"m\"", "1,5");
    assert!(with_comma.ends_with("decimal_comma = true?"), "{with_comma}");
    let with_thousands = problem("decimal_comma = true", "1.234,5");
    assert!(with_thousands.ends_with("write it without separators of thousands"), "{with_thousands}");
}

/// `sep=;` is what spreadsheets write to say what divides cells.
#[test]
fn a_line_that_names_what_divides_cells_is_no_header() {
    let columns = [&NAMES[..], &["x_mm", "y_mm", "z_mm"]].concat();
    let rows = |by: &str| format!("sep={by}\r\n{}\r\n{}\r\n", columns.join(by), ["1"; 9].join(by));
    let mapped = map("", &columns).table(rows(";").as_bytes()).unwrap();
    let plain = Table::from_csv(rows(",").as_bytes()).unwrap();
    for table in [mapped, plain] {
        assert_eq!((table.header.len(), table.lines.len(), table.lines[0].number), (9, 1, 3));
    }
    let error = Table::from_csv(rows(";").as_bytes()).unwrap_err().to_string();
    assert!(error.contains("separated by ';'"), "{error}");
}

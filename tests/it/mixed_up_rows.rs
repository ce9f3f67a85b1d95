//! Rows whose cells are another row's, another column's or counted from elsewhere, all of them or from some row on.

use super::sound_file::{as_text, cells, diagnose, fault, lines, times};

/// The sound file's cells, each row a pose of its own, and where a column stands.
struct Sheet {
    names: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Sheet {
    fn new() -> Self {
        let (names, mut rows) = cells();
        let pose = names.iter().position(|name| name == "pose_id");
        for (k, row) in rows.iter_mut().enumerate() {
            if let Some(pose) = pose {
                row[pose] = k.to_string();
            }
        }
        Self { names, rows }
    }

    fn at(&self, name: &str) -> usize {
        self.names.iter().position(|n| n == name).unwrap()
    }

    fn swapped(mut self, [a, b]: [&str; 2], from: usize) -> Self {
        let (a, b) = (self.at(a), self.at(b));
        self.rows[from..].iter_mut().for_each(|row| row.swap(a, b));
        self
    }

    fn changed(mut self, names: &[&str], from: usize, change: impl Fn(&str) -> String) -> Self {
        for name in names {
            let at = self.at(name);
            self.rows[from..].iter_mut().for_each(|row| row[at] = change(&row[at]));
        }
        self
    }

    /// Cells of `names` from the row `from` on are those of the row `by` places before.
    fn late(mut self, names: &[&str], by: usize, from: usize) -> Self {
        let was = self.rows.clone();
        for name in names {
            let at = self.at(name);
            for k in from.max(by)..was.len() {
                self.rows[k][at].clone_from(&was[k - by][at]);
            }
        }
        // Rows before the first have no cells to be late.
        if from == 0 {
            self.rows.drain(..by);
        }
        self
    }

    fn fault(&self) -> (String, String, Vec<u64>) {
        fault(&as_text(&self.names, &self.rows))
    }

    /// The kind and column of the fault, whose rows lie from `from` on and are most of them.
    fn fault_from(&self, from: usize) -> (String, String) {
        let (kind, column, found) = self.fault();
        let all = lines(from, self.rows.len());
        assert!(found.iter().all(|line| all.contains(line)), "{found:?}");
        assert!(10 * found.len() >= 7 * all.len(), "{} of {}: {kind} {column}", found.len(), all.len());
        (kind, column)
    }
}

fn named(kind: &str, column: &str) -> (String, String) {
    (kind.to_owned(), column.to_owned())
}

const POINT: [&str; 3] = ["x_mm", "y_mm", "z_mm"];
const JOINTS: [&str; 6] = ["q1_deg", "q2_deg", "q3_deg", "q4_deg", "q5_deg", "q6_deg"];

/// Each pose three times, one after the other: the z of the rows beside would be right, and what stands there is nobody's.
#[test]
fn a_false_cell_among_repeats_is_not_called_late() {
    let mut sheet = Sheet::new();
    sheet.rows = sheet.rows.iter().flat_map(|row| std::iter::repeat_n(row.clone(), 3)).collect();
    let (id, z) = (sheet.at("id"), sheet.at("z_mm"));
    for (k, row) in sheet.rows.iter_mut().enumerate() {
        row[id] = k.to_string();
        let off_mm = if k % 40 == 7 { 700.0 } else { 0.01 * f64::from(k as u8 % 3) };
        row[z] = format!("{:.4}", row[z].parse::<f64>().unwrap() + off_mm);
    }
    let answer = diagnose(as_text(&sheet.names, &sheet.rows).as_bytes(), &[]).json.unwrap();
    assert!(answer["fault"].is_null(), "{}", answer["reason"]);
    let set_aside = answer["false_rows"].as_array().unwrap();
    assert_eq!(set_aside.len(), 5, "{set_aside:?}");
}

/// Joints that the display gave with one decimal from some row on.
#[test]
fn joints_rounded_from_a_row_on_are_named_with_their_rows() {
    let one_decimal = |cell: &str| format!("{:.1}", cell.parse::<f64>().unwrap());
    for (names, column) in [(&JOINTS[..], "q1_deg to q6_deg"), (&["q2_deg"], "q2_deg")] {
        let found = Sheet::new().changed(names, 30, one_decimal).fault_from(30);
        assert_eq!(found, named("rounded_joints", column));
    }
}

/// A rack of sensors that gives tenths of a degree.
#[test]
fn temperatures_ten_times_as_high_are_named() {
    let names: Vec<String> = (1..=6).map(|j| format!("temp_j{j}_c")).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let (kind, column, found) = Sheet::new().changed(&names, 30, times(10.0)).fault();
    assert_eq!((kind, column), named("column_units", "temp_j1_c to temp_j6_c"));
    assert_eq!(found, lines(30, 60));
}

/// Four rows in sixty in which joint 3 reads 0 because nothing was read: they are left out, and the answer is that without them.
#[test]
fn a_zero_in_the_place_of_an_angle_costs_its_rows() {
    let plain = Sheet::new();
    let q3 = plain.at("q3_deg");
    let is_coded = |k: usize| k % 15 == 7;
    let mut coded = Sheet::new();
    coded
        .rows
        .iter_mut()
        .enumerate()
        .filter(|(k, _)| is_coded(*k))
        .for_each(|(_, row)| row[q3] = "0".to_owned());
    let mut without = Sheet::new();
    let mut k = 0;
    without.rows.retain(|_| {
        k += 1;
        !is_coded(k - 1)
    });
    let known = ["--sigma-mm", "0.02"];
    let [coded, without] =
        [coded, without].map(|sheet| diagnose(as_text(&sheet.names, &sheet.rows).as_bytes(), &known));
    assert_eq!((coded.verdict(), coded.causes()), (without.verdict(), without.causes()), "{}", coded.text);
    assert!(
        coded.text.contains("column q3_deg is 0 to the last digit in 4 rows: lines 9, 24, 39, 54"),
        "{}",
        coded.text
    );
}

/// What base and tool alone leave is noise and causes together: no noise is larger.
#[test]
fn a_noise_that_the_points_contradict_is_not_believed() {
    let sheet = Sheet::new();
    let text = as_text(&sheet.names, &sheet.rows);
    let [unstated, overstated] =
        [&[][..], &["--sigma-mm", "5"]].map(|known| diagnose(text.as_bytes(), known));
    assert_eq!((overstated.verdict(), overstated.causes()), (unstated.verdict(), unstated.causes()));
    assert!(
        overstated.text.contains("less than the noise of 5.0000 mm that was stated"),
        "{}",
        overstated.text
    );
    let sound = diagnose(text.as_bytes(), &["--sigma-mm", "0.02"]);
    assert!(!sound.text.contains("that was stated"), "{}", sound.text);
}

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
mod long {
    use super::*;

    #[test]
    #[ignore = "long"]
    fn points_some_rows_late_and_one_coordinate_late_are_named() {
        for by in [2, 3] {
            let part = Sheet::new().late(&POINT, by, 30);
            assert_eq!(part.fault_from(30), named("rows_shifted", "x_mm, y_mm, z_mm"), "{by}");
            let (kind, column, found) = Sheet::new().late(&POINT, by, 0).fault();
            assert_eq!((kind, column), named("rows_shifted", "x_mm, y_mm, z_mm"));
            assert!(found.is_empty(), "{by}: {found:?}");
        }
        for (names, by) in [(["z_mm"], 1), (["q3_deg"], 2)] {
            let (kind, column, _) = Sheet::new().late(&names, by, 0).fault();
            assert_eq!((kind, column), named("rows_shifted", names[0]));
        }
        let part = Sheet::new().late(&["z_mm"], 1, 30);
        assert_eq!(part.fault_from(30), named("rows_shifted", "z_mm"));
    }

    #[test]
    #[ignore = "long"]
    fn a_column_pasted_over_another_is_named_with_it() {
        for (from, to, kind) in [("x_mm", "y_mm", "nothing_fits"), ("q2_deg", "q3_deg", "joint_columns")] {
            let mut sheet = Sheet::new();
            let (from_at, to_at) = (sheet.at(from), sheet.at(to));
            sheet.rows.iter_mut().for_each(|row| row[to_at] = row[from_at].clone());
            let (kind_found, column, _) = sheet.fault();
            assert_eq!((kind_found, column), named(kind, &format!("{from}, {to}")));
        }
    }

    #[test]
    #[ignore = "long"]
    fn a_joint_counted_from_another_zero_is_named_with_its_angle() {
        for (name, by_deg) in [("q2_deg", 30.0), ("q3_deg", -90.0), ("q5_deg", 90.0)] {
            let add = |cell: &str| format!("{:.6}", cell.parse::<f64>().unwrap() + by_deg);
            let sheet = Sheet::new().changed(&[name], 0, add);
            let (kind, column, found) = sheet.fault();
            assert_eq!((kind, column), named("joint_columns", name));
            assert!(found.is_empty(), "{found:?}");
            let answer = diagnose(as_text(&sheet.names, &sheet.rows).as_bytes(), &[]);
            let reason = answer.json.as_ref().unwrap()["reason"].as_str().unwrap().to_owned();
            assert!(reason.contains(&format!("is off by {by_deg:+.1} deg in all rows")), "{reason}");
        }
    }

    #[test]
    #[ignore = "long"]
    fn a_column_sorted_by_itself_is_named() {
        let mut sheet = Sheet::new();
        let z = sheet.at("z_mm");
        let mut all: Vec<String> = sheet.rows.iter().map(|row| row[z].clone()).collect();
        all.sort_by(|a, b| a.parse::<f64>().unwrap().total_cmp(&b.parse::<f64>().unwrap()));
        sheet.rows.iter_mut().zip(all).for_each(|(row, cell)| row[z] = cell);
        let (kind, column, _) = sheet.fault();
        assert_eq!((kind, column), named("rows_shifted", "z_mm"));
    }

    #[test]
    #[ignore = "long"]
    fn columns_swapped_from_a_row_on_are_named_with_their_rows() {
        for (columns, kind) in [
            (["q2_deg", "q3_deg"], "joint_columns"),
            (["q4_deg", "q5_deg"], "joint_columns"),
            (["x_mm", "y_mm"], "swapped_axes"),
            (["y_mm", "z_mm"], "swapped_axes"),
        ] {
            let found = Sheet::new().swapped(columns, 36).fault_from(36);
            assert_eq!(found, named(kind, &columns.join(", ")));
        }
    }

    /// Points from files p1, p10, p11, p2 beside joints in the order in which they were measured, and the other way round.
    #[test]
    #[ignore = "long"]
    fn points_sorted_by_the_letters_of_their_numbers_are_named() {
        let sheet = Sheet::new();
        let mut by_letters: Vec<usize> = (0..sheet.rows.len()).collect();
        by_letters.sort_by_key(|k| format!("p{}", k + 1));
        for columns in [&POINT[..], &JOINTS] {
            let mut sheet = Sheet::new();
            let was = sheet.rows.clone();
            for name in columns {
                let at = sheet.at(name);
                for (row, from) in sheet.rows.iter_mut().zip(&by_letters) {
                    row[at].clone_from(&was[*from][at]);
                }
            }
            let answer = diagnose(as_text(&sheet.names, &sheet.rows).as_bytes(), &[]).json.unwrap();
            assert_eq!(answer["fault"]["kind"], "rows_shifted", "{}", answer["reason"]);
            assert!(answer["reason"].as_str().unwrap().contains("(1, 10, 11, 2)"), "{}", answer["reason"]);
        }
    }

    /// A sheet in which the comma of a decimal number was taken for one of thousands.
    #[test]
    #[ignore = "long"]
    fn a_column_without_its_decimal_marks_is_named() {
        for (name, decimals) in [("z_mm", 4), ("q3_deg", 2)] {
            let without =
                |cell: &str| format!("{:.decimals$}", cell.parse::<f64>().unwrap()).replace('.', "");
            let sheet = Sheet::new().changed(&[name], 0, without);
            let (kind, column, found) = sheet.fault();
            assert_eq!((kind, column), named("column_units", name));
            assert!(found.is_empty(), "{found:?}");
            let answer = diagnose(as_text(&sheet.names, &sheet.rows).as_bytes(), &[]);
            assert!(answer.json.unwrap()["reason"].as_str().unwrap().contains("decimal marks"));
        }
    }

    /// Points of twenty rows pasted over those of twenty others: the joints are of the rows that they stand in, and no unit of a column makes
    /// them fit.
    #[test]
    #[ignore = "long"]
    fn a_block_of_points_that_was_pasted_over_another_is_named() {
        let mut sheet = Sheet::new();
        let was = sheet.rows.clone();
        assert!(was.len() >= 60, "{}", was.len());
        for name in ["x_mm", "y_mm", "z_mm"] {
            let at = sheet.at(name);
            (30..50).for_each(|k| sheet.rows[k][at].clone_from(&was[k - 20][at]));
        }
        let (kind, column, found) = sheet.fault();
        assert_eq!((kind, column), named("nothing_fits", "x_mm, y_mm, z_mm"));
        assert_eq!(found, lines(30, 50));
        let answer = diagnose(as_text(&sheet.names, &sheet.rows).as_bytes(), &[]);
        let reason = answer.json.unwrap()["reason"].to_string();
        assert!(reason.contains("those of lines 12 to 31"), "{reason}");
    }

    /// 400 gon are a turn.
    #[test]
    #[ignore = "long"]
    fn gon_in_one_column_or_in_all_from_a_row_on_are_named() {
        let gon = |cell: &str| times(400.0 / 360.0)(cell);
        let (kind, column, found) = Sheet::new().changed(&["q3_deg"], 0, gon).fault();
        assert_eq!((kind, column), named("column_units", "q3_deg"));
        assert!(found.is_empty(), "{found:?}");
        let all = Sheet::new().changed(&JOINTS, 30, gon).fault_from(30);
        assert_eq!(all, named("joint_units", "q1_deg to q6_deg"));
    }

    /// Every fifth row: metres off, and no registration of the others is led astray by them.
    #[test]
    #[ignore = "long"]
    fn a_cell_pasted_over_another_in_some_rows_is_named_with_its_rows() {
        let mut sheet = Sheet::new();
        let (y, z) = (sheet.at("y_mm"), sheet.at("z_mm"));
        let pasted: Vec<usize> = (2..sheet.rows.len()).step_by(5).collect();
        for &k in &pasted {
            sheet.rows[k][z] = sheet.rows[k][y].clone();
        }
        let expected: Vec<u64> = pasted.iter().map(|k| *k as u64 + 2).collect();
        assert_eq!(sheet.fault(), ("nothing_fits".to_owned(), "y_mm, z_mm".to_owned(), expected));
    }
}

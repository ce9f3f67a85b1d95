//! Files in other units, orders and columns are refused by what judges a model or an arm as they are by the diagnosis.

use super::{TIP_M, file, poses, robot_under_test, run, somewhere, with_points, write};
use exam::effect::Effect;
use nalgebra::Vector3;
use robot_model::kinematics::Chain;
use robot_model::robot::Robot;
use std::path::Path;

/// The file with the cells of each row changed.
fn with_cells(text: &str, change: impl Fn(&mut [String])) -> String {
    let changed = text.lines().enumerate().map(|(k, line)| {
        let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
        if k > 0 {
            change(&mut cells);
        }
        cells.join(",") + "\n"
    });
    changed.collect()
}

/// The file with the flange's orientation of each pose, its four parts in this order.
fn with_orientations(text: &str, order: [usize; 4]) -> String {
    let chain = Chain::nominal(&Robot::built_in("irb140").unwrap());
    let parts = poses().into_iter().map(|q_rad| {
        let turn = (somewhere() * chain.forward(&q_rad)).rotation;
        let parts = [turn.w, turn.i, turn.j, turn.k];
        order.map(|k| format!(",{:.7}", parts[k])).concat()
    });
    let more = std::iter::once(",qw,qx,qy,qz".to_owned()).chain(parts);
    text.lines().zip(more).map(|(line, more)| format!("{line}{more}\n")).collect()
}

fn model(folder: &Path) -> String {
    let found = file(
        &robot_under_test(&[(Effect::JointOffset { joint: 3 }, 1e-3)]),
        &somewhere(),
        Vector3::from(TIP_M),
        5,
    );
    let (csv, model) =
        (write(folder, "found.csv", &found), folder.join("m.toml").to_string_lossy().into_owned());
    let (code, _, answer) = run(&["diagnose", &csv, "--sigma-mm", "0.02", "--model-out", &model]);
    assert_eq!(code, 0, "{answer}");
    model
}

#[test]
fn messages_name_the_columns_as_the_file_does() {
    let folder = tempfile::tempdir().unwrap();
    let sound = file(&robot_under_test(&[]), &somewhere(), Vector3::from(TIP_M), 6);
    let theirs = with_orientations(&sound, [1, 2, 3, 0]);
    let header = "id,J1,J2,J3,J4,J5,J6,X,Y,Z,Q1,Q2,Q3,Q4";
    let theirs = [header, theirs.split_once('\n').unwrap().1].join("\n");
    let names = header.split(',').skip(1).zip([
        "q1_deg", "q2_deg", "q3_deg", "q4_deg", "q5_deg", "q6_deg", "x_mm", "y_mm", "z_mm", "qw", "qx", "qy",
        "qz",
    ]);
    let map: String = names.map(|(own, ours)| format!("{ours} = \"{own}\"\n")).collect();
    let map = write(folder.path(), "map.toml", &format!("[columns]\n{map}"));
    let csv = write(folder.path(), "theirs.csv", &theirs);
    let model = model(folder.path());
    let json = folder.path().join("d.json").to_string_lossy().into_owned();
    let (_, out, _) = run(&["diagnose", &csv, "--columns", &map, "--json", &json]);
    assert!(out.contains("the columns Q1, Q2, Q3, Q4 hold x, y, z, w") && !out.contains("qw"), "{out}");
    let read: serde_json::Value = serde_json::from_slice(&std::fs::read(&json).unwrap()).unwrap();
    assert_eq!(read["fault"]["column"], "Q1, Q2, Q3, Q4");
    let (code, _, answer) = run(&["validate", &csv, "--columns", &map, "--model", &model]);
    assert!(code == 2 && answer.contains("the columns Q1, Q2, Q3, Q4 hold x, y, z, w"), "{answer}");
}

#[test]
fn accuracy_names_a_tool_that_is_elsewhere_than_the_points_say() {
    let folder = tempfile::tempdir().unwrap();
    let csv =
        write(folder.path(), "m.csv", &file(&robot_under_test(&[]), &somewhere(), Vector3::from(TIP_M), 6));
    let judged = |tool: &str| run(&["accuracy", &csv, "--register", "base", "--tool", tool]).2;
    assert!(!judged("60,-30,110").contains("measure::tool-apart"));
    assert!(!judged("61,-30,111").contains("measure::tool-apart"), "known to a millimetre");
    // The same in centimetres and inches.
    for tool in ["6,-3,11", "2.362,-1.181,4.331"] {
        let answer = judged(tool);
        assert!(
            answer.contains("measure::tool-apart") && answer.contains("is at (60.0, -30.0, 110.0) mm"),
            "{answer}"
        );
    }
}

#[test]
fn a_cell_that_is_no_number_is_named_by_the_column_that_the_file_has() {
    let map = "delimiter = \";\"\ndecimal_comma = true\n[columns]\nq3_deg = \"A3\"\ndir2 = \"R2\"\n\
               [pose]\ncolumns = [\"X\", \"Y\", \"Z\", \"A\", \"B\", \"C\"]\nrotation = \"moving-zyx\"\n";
    let map = measurements::ColumnMap::from_toml(map).unwrap();
    let sound = ["10,5", "1", "100,5", "2", "3", "4", "5", "6"];
    for (k, column) in ["A3", "R2", "X", "Y", "Z", "A", "B", "C"].into_iter().enumerate() {
        let mut cells = sound;
        cells[k] = "abc";
        let text = format!("A3;R2;X;Y;Z;A;B;C\n{}\n{}\n", sound.join(";"), cells.join(";"));
        let error = map.table(text.as_bytes()).unwrap_err().to_string();
        assert!(error.starts_with(&format!("line 3, column {column}: 'abc'")), "{error}");
    }
}

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
mod long {
    use super::*;

    #[test]
    #[ignore = "long"]
    fn a_model_is_not_judged_by_a_file_in_other_units_or_columns() {
        let folder = tempfile::tempdir().unwrap();
        let model = model(folder.path());
        let unseen = file(
            &robot_under_test(&[(Effect::JointOffset { joint: 3 }, 1e-3)]),
            &somewhere(),
            Vector3::from(TIP_M),
            6,
        );
        let scaled =
            |by: f64| with_points(&unseen, |_, point_mm| point_mm.iter_mut().for_each(|mm| *mm *= by));
        let radians = |cells: &mut [String]| {
            for cell in &mut cells[1..7] {
                *cell = format!("{:.9}", cell.parse::<f64>().unwrap().to_radians());
            }
        };
        let validated = |text: &str| {
            let csv = write(folder.path(), "unseen.csv", text);
            run(&["validate", &csv, "--model", &model])
        };
        let (code, out, answer) = validated(&unseen);
        assert!(code == 0 && answer.is_empty(), "{out}{answer}");
        assert_eq!(validated(&with_orientations(&unseen, [0, 1, 2, 3])).0, 0);
        let faults = [
            (scaled(1e-3), "the measured points are in metres"),
            (scaled(1.0 / 25.4), "inch"),
            (with_cells(&unseen, radians), "radians"),
            (with_cells(&unseen, |cells| cells.swap(5, 6)), "the columns of joints 5 and 6 are swapped"),
            (with_cells(&unseen, |cells| cells.swap(7, 8)), "the measured points are mirrored"),
            (with_orientations(&unseen, [1, 2, 3, 0]), "qw, qx, qy, qz hold x, y, z, w"),
        ];
        for (text, reason) in faults {
            let (code, out, answer) = validated(&text);
            assert!(
                code == 2 && answer.contains("measure::fault") && answer.contains(reason),
                "{reason}: {out}{answer}"
            );
        }
    }
}

/// All texts of a result but the names of its values.
fn texts(of: &serde_json::Value) -> Vec<String> {
    match of {
        serde_json::Value::String(text) => vec![text.clone()],
        serde_json::Value::Array(all) => all.iter().flat_map(texts).collect(),
        serde_json::Value::Object(all) => all.values().flat_map(texts).collect(),
        _ => Vec::new(),
    }
}

#[test]
fn what_cannot_be_told_and_what_to_do_next_name_the_columns_of_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let bent = robot_under_test(&[(Effect::JointCompliance { joint: 2 }, 1e-6)]);
    let ours = file(&bent, &somewhere(), Vector3::from(TIP_M), 6);
    // Columns that a form has and nobody filled in.
    let rows = ours.lines().skip(1).map(|row| format!("{row},,,,,,,,\n"));
    let theirs =
        format!("id,J1,J2,J3,J4,J5,J6,X,Y,Z,Uhr,Last,R1,R2,R3,R4,R5,R6\n{}", rows.collect::<String>());
    let names = [("q", "J", "_deg", 1..=6), ("dir", "R", "", 1..=6)].map(|(ours, own, unit, joints)| {
        joints.map(|joint| format!("{ours}{joint}{unit} = \"{own}{joint}\"\n")).collect::<String>()
    });
    let others = "x_mm = \"X\"\ny_mm = \"Y\"\nz_mm = \"Z\"\nt_min = \"Uhr\"\npayload_kg = \"Last\"\n";
    let map = write(folder.path(), "map.toml", &format!("[columns]\n{}{others}", names.concat()));
    let csv = write(folder.path(), "theirs.csv", &theirs);
    let json = folder.path().join("d.json").to_string_lossy().into_owned();
    let (code, out, answer) = run(&["diagnose", &csv, "--columns", &map, "--json", &json]);
    assert_eq!(code, 0, "{answer}");
    let read: serde_json::Value = serde_json::from_slice(&std::fs::read(&json).unwrap()).unwrap();
    let all = [texts(&read).join("\n"), out, answer].join("\n");
    for own in ["has no payload (Last)", "directions of approach (R1 to R6)", "Uhr is empty"] {
        assert!(all.contains(own), "{own}: {all}");
    }
    for ours in ["t_min", "payload_kg", "dir1", "q1_deg"] {
        assert!(!all.contains(ours), "{ours}: {all}");
    }
}

#[test]
fn what_is_wrong_with_measurements_is_told_with_the_name_of_their_file() {
    let folder = tempfile::tempdir().unwrap();
    let few = "q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n0,0,0,0,30,0,515,0,712\n";
    let few = write(folder.path(), "few.csv", few);
    let touched = "fixed_id,t_min,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\npin,0,0,0,0,0,30,0\n";
    let touched = write(folder.path(), "touched.csv", touched);
    let model = model(folder.path());
    let told = |words: &[&str], file: &str| {
        let (code, _, answer) = run(words);
        let first = answer.lines().find(|line| line.starts_with("error[")).unwrap_or_default();
        assert!(code == 2 && first.contains(&format!("]: {file}: ")), "{words:?}: {answer}");
    };
    told(&["accuracy", &few], "few.csv");
    told(&["validate", &few, "--model", &model], "few.csv");
    told(&["fit", &touched, "--tool", "0,0,100"], "touched.csv");
    told(&["state", &touched, "--tool", "0,0,100"], "touched.csv");
}

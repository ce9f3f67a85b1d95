//! A measurement file that is sound, what may be done to it, and what the program itself then says.

use assert_cmd::Command;
use serde_json::Value;
use std::fs;
use std::sync::LazyLock;
use tempfile::TempDir;

pub struct Answer {
    pub code: i32,
    pub text: String,
    pub json: Option<Value>,
}

impl Answer {
    pub fn verdict(&self) -> &str {
        self.json.as_ref().map_or("", |json| json["verdict"].as_str().unwrap())
    }

    pub fn causes(&self) -> Vec<&str> {
        let causes = self.json.as_ref().unwrap()["causes"].as_array().unwrap();
        causes.iter().map(|cause| cause["effect"].as_str().unwrap()).collect()
    }
}

pub fn diagnose(csv: &[u8], arguments: &[&str]) -> Answer {
    let folder = TempDir::new().unwrap();
    let (path, json) = (folder.path().join("m.csv"), folder.path().join("out.json"));
    fs::write(&path, csv).unwrap();
    let mut command = Command::cargo_bin("driftpost").unwrap();
    let output =
        command.arg("diagnose").arg(&path).arg("--json").arg(&json).args(arguments).output().unwrap();
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(!text.contains("panicked"), "{text}");
    let json = fs::read(&json).ok().map(|bytes| serde_json::from_slice(&bytes).unwrap());
    Answer { code: output.status.code().unwrap(), text, json }
}

/// 60 poses of a virtual arm whose second joint gives way.
pub static SOUND: LazyLock<String> = LazyLock::new(|| {
    let folder = TempDir::new().unwrap();
    let sets = folder.path().join("sets");
    let mut command = Command::cargo_bin("driftpost").unwrap();
    command.arg("synth").arg(&sets);
    command.args(["--effects", "joint_compliance:2", "--n", "60", "--seed", "5"]).assert().success();
    fs::read_to_string(sets.join("set_0000/measurements.csv")).unwrap()
});

/// The sound file with every cell of the columns whose name passes `column` rewritten.
pub fn rewritten(column: impl Fn(&str) -> bool, cell: impl Fn(&str) -> String) -> String {
    let mut lines = SOUND.lines();
    let header = lines.next().unwrap();
    let names: Vec<&str> = header.split(',').collect();
    let row = |line: &str| {
        let cells = line.split(',').zip(&names);
        let cells: Vec<String> =
            cells.map(|(c, name)| if column(name) { cell(c) } else { c.to_owned() }).collect();
        cells.join(",") + "\n"
    };
    header.to_owned() + "\n" + &lines.map(row).collect::<String>()
}

pub fn times(factor: f64) -> impl Fn(&str) -> String {
    move |cell| format!("{:.9}", cell.parse::<f64>().unwrap() * factor)
}

/// A file in which something is wrong: what the fault names.
pub fn fault(text: &str) -> (String, String, Vec<u64>) {
    fault_with(text, &[])
}

pub fn fault_with(text: &str, arguments: &[&str]) -> (String, String, Vec<u64>) {
    let answer = diagnose(text.as_bytes(), arguments);
    assert_eq!((answer.code, answer.verdict()), (0, "data_fault"), "{}", answer.text);
    let fault = &answer.json.as_ref().unwrap()["fault"];
    let lines = fault["lines"].as_array().unwrap().iter().map(|line| line.as_u64().unwrap()).collect();
    let text = |key: &str| fault[key].as_str().unwrap_or_default().to_owned();
    (text("kind"), text("column"), lines)
}

/// Cells of the sound file, line by line.
pub fn cells() -> (Vec<String>, Vec<Vec<String>>) {
    let split = |line: &str| line.split(',').map(str::to_owned).collect();
    let mut lines = SOUND.lines();
    (split(lines.next().unwrap()), lines.map(split).collect())
}

pub fn as_text(names: &[String], rows: &[Vec<String>]) -> String {
    names.join(",") + "\n" + &rows.iter().map(|row| row.join(",") + "\n").collect::<String>()
}

pub fn lines(from: usize, to: usize) -> Vec<u64> {
    (from as u64 + 2..to as u64 + 2).collect()
}

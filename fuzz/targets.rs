//! What must hold for any bytes. Called by cargo-fuzz with bytes that it finds, and by the ordinary tests with bytes made from the
//! fixtures: one list of targets, two engines.

#![allow(
    dead_code,
    clippy::expect_used,
    reason = "each binary of cargo-fuzz calls one of them, and a target stops where its promise is broken"
)]

use crate::tree_check::check;
use driftpost::report::{ResultPage, simulation, write_page};
use driftpost::{
    Compensation, Course, Deformation, Measurements, ProgramFiles, Robot, Simulation, Touches, TrueRobot,
};
use rapid_program::compensate::FormChoice;
use rapid_program::emit::restore;
use rapid_syntax::{parse, parse_by_productions};
use robot_model::deform::identified::Identified;
use std::sync::LazyLock;

static ROBOT: LazyLock<Robot> = LazyLock::new(|| Robot::built_in("irb140").expect("it is built in"));
static PAPER: LazyLock<Deformation> = LazyLock::new(Deformation::paper);

/// Read: no byte is lost, no node lies outside of the one that holds it, and the scans of common forms find what the productions
/// of the grammar find.
pub fn text(data: &[u8]) {
    assert!(parse(data) == parse_by_productions(data), "scanned to another tree than read");
    if let Err(problem) = check(data) {
        panic!("{problem}");
    }
}

/// Compensated, in the form that the first byte names: what is emitted is read without a word more, and gives the source back.
pub fn program(data: &[u8]) {
    let Some((&form, source)) = data.split_first() else { return };
    let forms = [FormChoice::Schedule, FormChoice::Ramp, FormChoice::Live, FormChoice::Auto];
    let form = forms[usize::from(form) % forms.len()];
    let files = ProgramFiles::one("Fuzzed.mod", source);
    let compensation = Compensation::new(ROBOT.clone(), PAPER.clone()).in_form(form);
    let Ok(result) = compensation.run(&files) else { return };
    let Some(emitted) = result.text() else { return };
    let (before, after) = (parse(source).1.len(), parse(emitted).1.len());
    assert!(after <= before, "{after} problems in what was emitted, {before} in the source");
    check(emitted).expect("what was emitted is a tree");
    let restored = restore(emitted).expect("what was emitted is restored");
    assert!(restored.exact && restored.bytes == source, "restored to other bytes");
}

/// Executed: a report or an error.
pub fn execution(data: &[u8]) {
    let simulation = Simulation::new(TrueRobot::new(ROBOT.clone(), PAPER.clone()));
    let files = ProgramFiles::one("Fuzzed.mod", data);
    if let Ok(report) = simulation.run(&files, None, &Course::Minutes(vec![60.0])) {
        assert!(simulation::json(&report).is_object(), "a report is JSON");
    }
}

/// Tables of every kind, robot files and models: a table or an error; what a model writes is read again.
pub fn tables(data: &[u8]) {
    drop(Measurements::from_csv(data));
    drop(Touches::from_csv(data));
    drop(Deformation::from_csv(data, None));
    let Ok(text) = std::str::from_utf8(data) else { return };
    drop(Robot::from_toml(text));
    if let Ok(model) = Identified::from_toml(text) {
        let again = Identified::from_toml(&model.to_toml()).expect("what a model writes is read");
        assert_eq!(again.terms.len(), model.terms.len());
    }
}

/// What could end an element of a page or begin another.
const MARKS: [&str; 6] = ["<script", "</script", "<!--", "<style", "<img", "<iframe"];

/// How often each mark stands in a page that shows `text` as its title, its data and its report.
fn marks(text: &str) -> [usize; 6] {
    let json = serde_json::json!({ "text": text });
    let mut out = Vec::new();
    let result = ResultPage { title: text.to_owned(), data: &json, text, provenance: &[] };
    write_page(&mut out, &result.of("diagnose")).expect("memory can be written");
    let mut page = String::from_utf8(out).expect("a page is UTF-8");
    page.make_ascii_lowercase();
    MARKS.map(|mark| memchr::memmem::find_iter(page.as_bytes(), mark).count())
}

/// In a page: what stands in the source can neither end the element that holds it nor begin another.
pub fn page(data: &[u8]) {
    static PLAIN: LazyLock<[usize; 6]> = LazyLock::new(|| marks(""));
    assert_eq!(marks(&String::from_utf8_lossy(data)), *PLAIN, "one of {MARKS:?} came in with the text");
}

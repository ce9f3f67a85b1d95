//! The form `modules` executed: one module in memory at a time, and the originals whenever loading goes wrong.

use crate::made::{Files, fixture, fixtures, made_as, read, session, warmth};
use driftpost::deform::Deformation;
use driftpost::emit::{Form, restore};
use driftpost::simulate::{Report, Scenario, Session};

const STEPS: &[&str] = &["call tcColdStart", "run 60", "pass"];

fn cube() -> (Files, Files) {
    let original = fixture("robodk/irc5/Cube45.mod");
    (made_as(Form::Modules, &original, &Deformation::paper(), &warmth()).unwrap().0, original)
}

fn play(mut s: Session, steps: &[&str]) -> Report {
    let steps = steps.iter().map(|s| (*s).to_owned()).collect();
    Scenario { steps, ..Scenario::default() }.play(&mut s).unwrap();
    s.into_report()
}

fn played(files: &(Files, Files), steps: &[&str]) -> Report {
    play(session(&files.0, &files.1, &Deformation::paper(), false), steps)
}

fn shown(report: &Report) -> Vec<&str> {
    report.messages.iter().filter(|m| m.source == "TPWrite").map(|m| m.text.as_str()).collect()
}

#[test]
fn hours_in_a_cell_with_one_module_at_a_time() {
    let files = cube();
    let steps = [
        "call tcColdStart",
        "run 90",
        "stand 45",
        "run 20",
        "pp_to_main",
        "run 20",
        "power_off 600",
        "run 30",
    ];
    let report = played(&files, &steps);
    assert!(report.is_within(6.4e-6), "{:?}", report.worst);
    assert!(shown(&report).is_empty(), "{:?}", report.messages);
    assert!(report.passes.iter().all(|p| p.index.unwrap() > 1.0));
}

#[test]
fn whatever_goes_wrong_with_loading_the_originals_run() {
    let (program, original) = cube();
    let buckets = program.iter().filter(|(path, _)| path.starts_with("HOME/")).count();
    assert!(buckets > 10);
    let broken = |change: &dyn Fn(&mut Vec<u8>)| {
        let mut files = program.clone();
        files.iter_mut().filter(|(path, _)| path.starts_with("HOME/")).for_each(|(_, bytes)| change(bytes));
        files
    };
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).unwrap();
    let missing: Files = program.iter().filter(|(path, _)| !path.starts_with("HOME/")).cloned().collect();
    let cases: [(&str, Files, &str); 4] = [
        ("no file", missing, "does not load"),
        // A module that declares what the program has already.
        (
            "a name twice",
            broken(&|b| *b = text(b).replace("PROC tcWho(", "PROC tcTick(").into_bytes()),
            "does not load",
        ),
        (
            "of another program",
            broken(&|b| *b = text(b).replace("tcMade:=", "tcMade:=1+").into_bytes()),
            "of another program",
        ),
        (
            "without its proof",
            broken(&|b| *b = text(b).replace("PROC tcWho(", "PROC tcWhose(").into_bytes()),
            "does not load",
        ),
    ];
    for (name, files, message) in cases {
        let report = played(&(files, original.clone()), STEPS);
        for pass in &report.passes {
            assert_eq!((&pass.failure, &pass.mismatch, pass.unreached), (&None, &None, 0), "{name}");
            assert!(pass.after == pass.before && pass.index == Some(1.0), "{name}");
        }
        assert_eq!(shown(&report).len(), 1, "{name}: {:?}", report.messages);
        assert!(shown(&report)[0].contains(message), "{name}: {:?}", report.messages);
    }
}

#[test]
fn one_missing_bucket_is_the_originals_until_the_next() {
    let (mut program, original) = cube();
    program.retain(|(path, _)| !path.ends_with("_b1.mod"));
    let report = played(&(program, original), STEPS);
    let on_originals: Vec<f64> =
        report.passes.iter().filter(|p| p.index == Some(1.0)).map(|p| p.t_min).collect();
    let (first, last) = (on_originals[0], on_originals[on_originals.len() - 1]);
    assert!(
        report.passes.iter().filter(|p| p.t_min < first || p.t_min > last).all(|p| p.after.max_m <= 6.4e-6)
    );
    assert!(last - first < 15.0 && report.passes.last().unwrap().t_min > last + 20.0);
    assert_eq!(shown(&report).len(), 1);
}

#[test]
fn originals_come_back_and_every_bucket_holds_the_whole_routine() {
    for name in ["robodk/irc5/Cube45.mod", "robodk/irc5/RichProg.mod", "simulate/cell.mod"] {
        let original = read(&[fixtures().join(name)]);
        let (program, _) = made_as(Form::Modules, &original, &Deformation::paper(), &warmth()).unwrap();
        let restored = restore(&program[0].1).unwrap();
        assert!(restored.exact && restored.bytes == original[0].1, "{name}");
        for (path, bytes) in &program[1..] {
            assert!(path.starts_with("HOME/tc"), "{path}");
            assert!(bytes.split(|b| *b == b'\n').all(|line| line.len() <= 255), "{path}");
        }
    }
    let (program, _) = cube();
    let text = String::from_utf8(program[5].1.clone()).unwrap();
    assert_eq!(text.matches("MoveL ").count() + text.matches("MoveAbsJ ").count(), 46);
}

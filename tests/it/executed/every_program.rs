//! Every program of the fixtures, and RoboDK's mill of 20,000 moves where it is given, executed at the minutes that count:
//! what is corrected is right, what is not is what the plan keeps.

use super::MINUTES;
use super::made::{Files, fixtures, made, made_as, read, session, warmth};
use rapid_compensation::compensate::FormChoice;
use rapid_compensation::emit::Clock;
use robot_model::deform::Deformation;
use robot_model::units::rad_from_deg;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use virtual_controller::session::ErrorStatistics;

fn modules_below(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut open = vec![folder.to_path_buf()];
    while let Some(folder) = open.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_name().unwrap().to_string_lossy().to_lowercase();
            if path.is_dir() {
                open.push(path);
            } else if [".mod", ".prg", ".modx", ".sys"].iter().any(|e| name.ends_with(e)) {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

/// What is reached at each minute, by how many moves; nothing where nothing is compensated. Panics where an executed move is
/// not where it should be.
fn reached(
    name: &str,
    form: FormChoice,
    original: &Files,
    clock: &Clock,
    minutes: &[f64],
) -> Option<Vec<(usize, ErrorStatistics)>> {
    // A staircase takes the tolerance, a ramp a tenth of it; half a micrometre is single precision's.
    let [within_m, within_rad] = match form {
        FormChoice::Schedule => [5.5e-6, f64::INFINITY],
        _ => [0.5e-6, rad_from_deg(1e-4)],
    };
    let paper = Deformation::paper();
    let (program, kept) = made_as(form, original, &paper, clock)?;
    // This one uses its tool before it sets it (`state::pers-kept`): what is told of it holds in the first pass alone. Its arc comes to the
    // end of a joint's range, in the source too.
    let is_rich = name.ends_with("s4c/RichProg.prg") || name.ends_with("golden/s4c_rich");
    let (each, not_made) = if is_rich { (1, 1) } else { (minutes.len(), 0) };
    let mut report = virtual_controller::Report::default();
    for minutes in minutes.chunks(each) {
        let mut s = session(&program, original, &paper, false);
        s.at_minutes(minutes).unwrap_or_else(|e| panic!("{name}: {e}"));
        let of_some = s.into_report();
        report.passes.extend(of_some.passes);
        report.unchanged.extend(of_some.unchanged);
    }
    assert_eq!(report.passes.len(), minutes.len());
    for p in &report.passes {
        assert_eq!((&p.failure, &p.mismatch, p.unreached), (&None, &None, not_made), "{name} at {}", p.t_min);
        let is_within = p.corrected.max_m <= within_m && p.corrected.max_rad <= within_rad;
        assert!(is_within, "{name} at {}: {:?} {:?}", p.t_min, p.corrected, p.worst);
    }
    let unchanged: BTreeSet<usize> = report.unchanged.keys().map(|(_, line)| *line as usize).collect();
    assert!(unchanged.len() <= kept, "{name}: {kept} moves are kept, these are unchanged: {unchanged:?}");
    Some(report.passes.into_iter().map(|p| (p.n, p.after)).collect())
}

/// Every program of the fixtures that runs, by its name; each case of the golden ones is one program.
///
/// Left out are `rapid/language.mod`, which is there for the grammar and calls what nobody declares, `emit/named.mod`, which
/// waits for ever in a loop of moves, and `golden/kept_reasons`, which cannot run to its end: a test of its own has that.
fn programs() -> Vec<(String, Files)> {
    let mut programs: Vec<(String, Files)> = modules_below(&fixtures().join("robodk"))
        .into_iter()
        .chain([fixtures().join("simulate/cell.mod")])
        .map(|path| (path.display().to_string(), read(&[path])))
        .collect();
    programs.push(("parts".to_owned(), read(&modules_below(&fixtures().join("parts")))));
    let mut cases: Vec<PathBuf> =
        std::fs::read_dir(fixtures().join("golden")).unwrap().map(|case| case.unwrap().path()).collect();
    cases.sort();
    for case in cases.iter().filter(|case| !case.ends_with("kept_reasons")) {
        programs.push((case.display().to_string(), read(&modules_below(&case.join("source")))));
    }
    programs
}

#[test]
fn what_cannot_run_ends_where_the_original_does() {
    let original = read(&modules_below(&fixtures().join("golden/kept_reasons/source")));
    let paper = Deformation::paper();
    let (program, _) = made_as(FormChoice::Schedule, &original, &paper, &warmth()).unwrap();
    // Behind a target out of reach the program stops at one whose orientation nobody has set.
    let [emitted, plain] = [&program, &original].map(|files| {
        let mut s = session(files, &original, &paper, false);
        s.at_minutes(&MINUTES).unwrap();
        s.into_report()
    });
    assert_eq!(emitted.passes.len(), MINUTES.len());
    for (emitted, plain) in emitted.passes.iter().zip(&plain.passes) {
        let why =
            |failure: &Option<String>| failure.as_ref().unwrap().rsplit_once(": ").unwrap().1.to_owned();
        assert_eq!(why(&emitted.failure), "the orientation [0,0,0,0] is not normalised");
        assert_eq!((why(&plain.failure), plain.n), (why(&emitted.failure), emitted.n));
        assert!(emitted.n == 2 && emitted.corrected.max_m <= 5.5e-6, "{emitted:?}");
    }
    let not_made = |report: &virtual_controller::Report| {
        report.messages.iter().filter(|m| m.text.starts_with("the move is not made")).count()
    };
    assert_eq!((not_made(&emitted), not_made(&plain)), (MINUTES.len(), MINUTES.len()));
}

#[test]
fn named_targets_arrays_offsets_and_two_tools_are_where_they_should_be() {
    let cell = read(&[fixtures().join("simulate/cell.mod")]);
    // As RobotStudio saves it on Windows, with a letter of ISO 8859-1 in a comment.
    let mut windows: Vec<u8> = Vec::new();
    for &byte in &cell[0].1 {
        match byte {
            b'\n' => windows.extend(b"\r\n"),
            b';' if !windows.contains(&0xE4) => windows.extend(b"; ! \xE4"),
            byte => windows.push(byte),
        }
    }
    for bytes in [cell[0].1.clone(), windows] {
        let original = vec![(cell[0].0.clone(), bytes)];
        let paper = Deformation::paper();
        let (program, kept) = made(&original, &paper, &warmth()).unwrap();
        assert_eq!(kept, 0);
        let mut s = session(&program, &original, &paper, true);
        s.at_minutes(&MINUTES).unwrap();
        let report = s.into_report();
        assert!(report.is_within(5.5e-6), "{:?}", report.worst);
        assert!(report.unchanged.is_empty() && report.unknown_instructions.is_empty());
        // 1 joint move, then 1 + 4 + 4 + 1 in the loop.
        assert!(report.passes.iter().all(|p| p.n == 11));
        assert!(report.passes.iter().all(|p| p.path_after_m.unwrap() < 1e-5));
        assert!(report.messages.is_empty(), "{:?}", report.messages);
    }
}

#[test]
#[ignore = "needs a folder of RoboDK exports in DRIFTPOST_CORPUS"]
fn twenty_thousand_moves_in_pages_are_where_they_should_be() {
    let folder = PathBuf::from(std::env::var_os("DRIFTPOST_CORPUS").unwrap()).join("mill20000");
    let original = read(&modules_below(&folder));
    for form in [FormChoice::Schedule, FormChoice::Ramp] {
        assert!(reached("mill20000", form, &original, &warmth(), &MINUTES).is_some());
    }
}

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
mod long {
    use super::*;

    #[test]
    #[ignore = "long"]
    fn every_program_of_the_fixtures_is_where_it_should_be_in_every_form() {
        for (name, original) in programs() {
            for clock in [warmth(), Clock::Elapsed] {
                let [schedule, ramp] = [FormChoice::Schedule, FormChoice::Ramp]
                    .map(|form| reached(&name, form, &original, &clock, &MINUTES).expect(&name));
                let moves = |reached: &[(usize, ErrorStatistics)]| {
                    reached.iter().map(|(n, _)| *n).collect::<Vec<_>>()
                };
                assert_eq!(moves(&schedule), moves(&ramp), "{name}");
            }
        }
    }
}

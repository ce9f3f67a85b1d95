//! One character of an emitted program changed: executing it shows the difference.

use super::made::{Files, borrowed, compensated, fixture, session, warmth};
use robot_model::deform::Deformation;
use virtual_controller::session::SessionOptions;
use virtual_controller::{Scenario, Session, TrueRobot};

fn text(files: &Files) -> String {
    files[0].1.iter().map(|&b| char::from(b)).collect()
}

/// Whether executing the changed program shows that something is wrong.
fn caught(changed: &str, original: &Files) -> bool {
    let files: Files = vec![("Cube45.mod".to_owned(), changed.bytes().collect())];
    let paper = Deformation::paper();
    let truth = TrueRobot::new(robot_model::robot::Robot::built_in("irb140").unwrap(), paper.clone());
    let options = SessionOptions { paths: false, ..SessionOptions::default() };
    let Ok(mut s) = Session::new(&borrowed(&files), Some(&borrowed(original)), truth, options) else {
        return true;
    };
    let minutes: Vec<f64> = (0..400).map(|k| f64::from(k) + 0.5).collect();
    if s.at_minutes(&minutes).is_err() || !s.report().is_within(5.5e-6) {
        return true;
    }
    // Dates: a night over a leap day, over the first of March, and over a year's end.
    for start in ["2028-02-28 22:00:00", "2027-02-28 22:00:00", "2026-12-31 22:00:00", "2027-04-30 22:00:00"]
    {
        let scenario = format!(
            "start = \"{start}\"\nsteps = [\"call tcColdStart\", \"run 30\", \"stand 110\", \"run 5\", \"stand 1440\", \"run 5\"]"
        );
        let mut s = session(&files, original, &paper, false);
        let played = Scenario::from_toml(&scenario).unwrap().play(&mut s);
        if played.is_err() || !s.report().is_within(6.4e-6) {
            return true;
        }
    }
    false
}

/// `text` with the first `from` after `anchor` replaced.
fn changed(text: &str, anchor: &str, from: &str, to: &str) -> String {
    let at = text.find(anchor).unwrap_or_else(|| panic!("no {anchor}"));
    let at = at + text[at..].find(from).unwrap_or_else(|| panic!("no {from} after {anchor}"));
    format!("{}{to}{}", &text[..at], &text[at + from.len()..])
}

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
mod long {
    use super::*;

    #[test]
    #[ignore = "long"]
    fn one_changed_character_is_caught() {
        let original = fixture("robodk/irc5/Cube45.mod");
        let program = compensated(&original, &Deformation::paper(), &warmth()).unwrap();
        let text = text(&program);
        assert!(!caught(&text, &original), "the program itself is right");

        // One digit of one target: a hundredth of a millimetre in the element of one bucket.
        let declaration = text.find("CONST robtarget").unwrap();
        let elements: Vec<usize> =
            text[declaration..].match_indices("[[").map(|(i, _)| declaration + i).collect();
        let at = elements[9] + 2;
        let end = at + text[at..].find(',').unwrap();
        let x: f64 = text[at..end].parse().unwrap();
        let digit = format!("{}{:.5}{}", &text[..at], x + 0.01, &text[end..]);

        // One bucket edge: a minute that belongs to no bucket any more.
        let case = text.rfind("CASE ").unwrap();
        let edge = format!("{}9{}", &text[..case + 5], &text[case + 6..]);
        // One index: an element for all buckets; one tool: a tenth of a millimetre.
        let index = changed(&text, "MoveL", "{tcK()}", "{5}");
        let tool = changed(&text, "rdkTool.tframe", "0.000, 0.000, 0.000", "0.000, 0.100, 0.000");
        let mut mutants = vec![("digit", digit), ("edge", edge), ("index", index), ("tool", tool)];
        // One sign in the arithmetic of dates.
        for (anchor, from, to) in [
            ("FUNC num tcSecond", "60*tcNumber(tcTime,4,2)+", "60*tcNumber(tcTime,4,2)-"),
            ("FUNC num tcSecond", "+60*", "-60*"),
            ("FUNC num tcDayNumber", "153*tcMonth-457", "153*tcMonth+457"),
            ("FUNC num tcDayNumber", "+365*", "-365*"),
            ("FUNC num tcDayNumber", "tcMonth:=tcMonth+12", "tcMonth:=tcMonth-12"),
            ("FUNC num tcDayNumber", "tcYear:=tcYear-1", "tcYear:=tcYear+1"),
            ("FUNC num tcSpan", "tcDay1-tcDay0", "tcDay1+tcDay0"),
            ("FUNC num tcSpan", "tcSec1-tcSec0", "tcSec1+tcSec0"),
            ("FUNC num tcSpan", "+(tcSec1", "-(tcSec1"),
        ] {
            mutants.push((from, changed(&text, anchor, from, to)));
        }
        for (name, mutant) in &mutants {
            assert_ne!(*mutant, text, "{name}");
            assert!(caught(mutant, &original), "{name} is not caught");
        }
    }
}

//! Files into HOME, modules into the task.

use crate::bench::{MODULE, double, is_left_clean, of_each, open};
use robot_link::{LinkError, Session};
use rws_double::{Double, Fault, Personality};

fn exchange(session: &mut Session, replaces: bool) -> Result<(), LinkError> {
    session.with_right(&mut |_| {}, |session| session.exchange_module("T_ROB1", "Part", "Part.mod", replaces))
}

fn newer() -> String {
    MODULE.replace("tcMinute:=64.7", "tcMinute:=0")
}

fn minute(double: &Double) -> Option<String> {
    double.with(|c| c.value("Part", "tcMinute"))
}

#[test]
fn a_file_is_written_and_read_back() {
    for personality in Personality::ALL {
        let double = double(personality);
        let mut session = open(&double);
        assert_eq!(session.file("Part.mod").unwrap(), None);
        let bytes = b"MODULE Part\r\n! caf\xe9\r\nENDMODULE\r\n";
        session.write_file("Part.mod", bytes).unwrap();
        assert_eq!(session.file("Part.mod").unwrap().unwrap(), bytes);
        let files = session.files().unwrap();
        assert_eq!((files[0].name.as_str(), files[0].size), ("Part.mod", Some(bytes.len() as u64)));
        for name in ["../Part.mod", "a/Part.mod", "Part.cfg", ".mod", "Part"] {
            assert_eq!(session.write_file(name, bytes).unwrap_err().code(), "link::name", "{name}");
        }
        session.end().unwrap();
        is_left_clean(&double);
    }
}

#[test]
fn half_a_file_is_never_accepted() {
    of_each(|personality| {
        let double = double(personality);
        let mut session = open(&double);
        for (fault, is_whole) in [
            (Fault::HalfFile, false),
            (Fault::DropBefore, false),
            (Fault::DropAfter, true),
            (Fault::Stall(1000), true),
        ] {
            double.with(|c| c.files.clear());
            let mut pending = Some(fault);
            double.plan(Box::new(move |seen, _| if seen.method == "PUT" { pending.take() } else { None }));
            let ended = session.write_file("Part.mod", MODULE.as_bytes());
            assert_eq!(ended.is_ok(), is_whole, "{fault:?} {ended:?}");
            let kept = double.with(|c| c.files.get("Part.mod").cloned());
            assert_eq!(kept.as_deref() == Some(MODULE.as_bytes()), is_whole, "{fault:?}");
        }
        session.end().unwrap();
        assert_eq!(double.requests().iter().filter(|r| r.starts_with("PUT")).count(), 4, "each once");
        is_left_clean(&double);
    });
}

#[test]
fn a_module_is_exchanged_while_rapid_stands() {
    for personality in Personality::ALL {
        let double = double(personality);
        let mut session = open(&double);
        session.write_file("Part.mod", newer().as_bytes()).unwrap();
        exchange(&mut session, true).unwrap();
        assert_eq!(minute(&double).as_deref(), Some("0"));
        // A name that is taken is refused where nothing is to be taken out.
        assert_eq!(exchange(&mut session, false).unwrap_err().code(), "link::no-symbol");
        session.end().unwrap();
        is_left_clean(&double);
    }
}

#[test]
fn nothing_is_exchanged_while_rapid_runs_or_the_pointer_stands_in_it() {
    for personality in Personality::ALL {
        let double = double(personality);
        let mut session = open(&double);
        session.write_file("Part.mod", newer().as_bytes()).unwrap();
        double.with(|c| c.execution = "running");
        assert_eq!(exchange(&mut session, true).unwrap_err().code(), "link::running");
        double.with(|c| c.execution = "a word that nobody knows");
        assert_eq!(exchange(&mut session, true).unwrap_err().code(), "link::running");
        double.with(|c| (c.execution, c.pointer_is_not_reset) = ("stopped", true));
        assert_eq!(exchange(&mut session, true).unwrap_err().code(), "link::execution");
        assert_eq!(minute(&double).as_deref(), Some("64.7"));
        session.end().unwrap();
        is_left_clean(&double);
    }
}

#[test]
fn a_module_with_errors_is_taken_out_again() {
    for personality in Personality::ALL {
        let double = double(personality);
        double.with(|c| c.modules.retain(|m| m.name != "Part"));
        let mut session = open(&double);
        // A name that BASE declares already, and a module that does not end.
        for text in
            ["MODULE Part\n  PERS num baseCount:=0;\nENDMODULE\n", "MODULE Part\n  PROC main()\nENDMODULE\n"]
        {
            session.write_file("Part.mod", text.as_bytes()).unwrap();
            let error = exchange(&mut session, false).unwrap_err();
            assert_eq!(error.code(), "link::module-errors");
            assert!(error.to_string().contains("taken out again"), "{error}");
            assert!(double.with(|c| c.module("Part").is_none()));
        }
        session.end().unwrap();
        is_left_clean(&double);
    }
}

#[test]
fn a_load_that_fails_says_that_the_module_it_replaces_is_out() {
    for personality in Personality::ALL {
        for fault in [Fault::Unavailable, Fault::DropBefore, Fault::ErrorInside] {
            let double = double(personality);
            let mut session = open(&double);
            session.write_file("Part.mod", newer().as_bytes()).unwrap();
            double.plan(Box::new(move |seen, _| {
                let is_load = seen.uri.contains("loadmod") && !seen.uri.contains("unloadmod");
                (seen.method == "POST" && is_load).then_some(fault)
            }));
            let error = exchange(&mut session, true).unwrap_err();
            assert_eq!(error.code(), "link::taken-out", "{fault:?} {error}");
            assert!(error.to_string().starts_with("Part was taken out of T_ROB1, and"), "{error}");
            assert!(double.with(|c| c.module("Part").is_none()), "{fault:?}");
            // Nothing was there before: that it is not loaded is all there is to say.
            assert_ne!(exchange(&mut session, false).unwrap_err().code(), "link::taken-out", "{fault:?}");
            session.end().unwrap();
            is_left_clean(&double);
        }
    }
}

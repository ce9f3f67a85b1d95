//! What `link push --load` meets in a task, and what it says of what it has done.

use super::{PROGRAMS, Shop, on_each_robotware, side_by_side};
use rws_double::{Fault, Personality};

const CONFIRMED_LOAD: [&str; 6] = ["push", "MODULE", "HOST", "--yes", "--load", "--confirmed"];

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
mod long {
    use super::*;

    /// The first load beside what runs in the cell already: the original, under its name and another, and a corrected program under
    /// another. It is told, and nothing is written.
    #[test]
    #[ignore = "long"]
    fn a_first_load_says_what_it_meets_before_anything_is_written() {
        let [original, corrected] =
            PROGRAMS.each_ref().map(|bytes| String::from_utf8(bytes.clone()).unwrap());
        let renamed = |text: &str| text.replacen("MODULE MOD_Cube45", "MODULE MOD_Old", 1);
        let met = [
            (original.clone(), "link::not-ours", "MOD_Cube45"),
            (renamed(&original), "link::names-taken", "MOD_Old"),
            (renamed(&corrected), "link::names-taken", "MOD_Old"),
        ];
        let cases = Personality::ALL
            .into_iter()
            .flat_map(|personality| met.iter().map(move |met| (personality, met)));
        side_by_side(cases, |(personality, (there, code, holder))| {
            let shop = Shop::new(personality);
            shop.put(Some(there));
            let (exit, out, _) = shop.run(&["push", "MODULE", "HOST"]);
            assert!(exit == 1 && out.contains("--load would be refused: ") && out.contains(holder), "{out}");
            assert!(out.contains("unload it there"), "{out}");
            let (exit, _, message) = shop.run(&CONFIRMED_LOAD);
            assert!(exit == 2 && message.contains(code) && message.contains(holder), "{message}");
            assert!(shop.double.with(|c| c.files.is_empty()));
            assert!(!shop.double.requests().iter().any(|r| r.contains("loadmod")));
            assert_eq!(shop.loaded(), [*holder]);
        });
    }

    /// A module that shares a routine alone: that only RAPID sees. Unloaded on the pendant, it goes.
    #[test]
    #[ignore = "long"]
    fn a_first_load_that_rapid_refuses_is_taken_out_again() {
        on_each_robotware(|personality| {
            let shop = Shop::new(personality);
            shop.put(Some("MODULE MOD_Old\n  PROC Cube45()\n  ENDPROC\nENDMODULE\n"));
            let (_, out, _) = shop.run(&["push", "MODULE", "HOST"]);
            assert!(out.contains("--load puts it into T_ROB1 as a new module"), "{out}");
            let (exit, _, message) = shop.run(&CONFIRMED_LOAD);
            assert!(
                exit == 2
                    && message.contains("link::module-errors")
                    && message.contains("another module's name"),
                "{message}"
            );
            assert_eq!(shop.loaded(), ["MOD_Old"]);
            // The file is in HOME all the same: a script is told.
            shop.double.with(|c| c.files.clear());
            let (exit, out, _) = shop.run(&[&CONFIRMED_LOAD[..], &["--json", "-"]].concat());
            let json: serde_json::Value = serde_json::from_str(&out).unwrap();
            let one = |key: &str| json["modules"][0][key].as_bool();
            assert_eq!((exit, one("written"), one("loaded")), (2, Some(true), Some(false)), "{out}");
            assert_eq!(json["error"]["code"], "link::module-errors", "{out}");
            shop.put(None);
            let (exit, out, _) = shop.run(&CONFIRMED_LOAD);
            assert!(exit == 0 && out.contains("MOD_Cube45: loaded into T_ROB1"), "{out}");
            let (_, out, _) = shop.run(&["push", "MODULE", "HOST"]);
            assert!(out.contains("in place of the corrected module of this name"), "{out}");
        });
    }

    #[test]
    #[ignore = "long"]
    fn what_a_push_has_done_is_told_to_scripts() {
        on_each_robotware(|personality| {
            let shop = Shop::new(personality);
            shop.put(None);
            let told = |arguments: &[&str]| {
                let (exit, out, _) = shop.run(&[arguments, &["--json", "-"]].concat());
                let json: serde_json::Value = serde_json::from_str(&out).unwrap();
                let one = |key: &str| json["modules"][0][key].clone();
                assert_eq!(
                    (one("module"), json["task"].as_str()),
                    ("MOD_Cube45".into(), Some("T_ROB1")),
                    "{out}"
                );
                (exit, one("home"), one("load"), one("written"), one("loaded"))
            };
            let push = ["push", "MODULE", "HOST"];
            assert_eq!(told(&push), (1, "new".into(), "new".into(), false.into(), false.into()));
            assert_eq!(told(&CONFIRMED_LOAD), (0, "new".into(), "new".into(), true.into(), true.into()));
            assert_eq!(told(&push), (0, "same".into(), "replaces".into(), false.into(), false.into()));
            // Nothing is written, for HOME has the file; what was in the task is out of it all the same.
            shop.double.plan(Box::new(|seen, _| {
                let is_load = seen.uri.contains("loadmod") && !seen.uri.contains("unloadmod");
                (seen.method == "POST" && is_load).then_some(Fault::Unavailable)
            }));
            let (exit, out, _) = shop.run(&[&CONFIRMED_LOAD[..], &["--json", "-"]].concat());
            let json: serde_json::Value = serde_json::from_str(&out).unwrap();
            assert_eq!((exit, json["error"]["code"].as_str()), (2, Some("link::taken-out")), "{out}");
            assert_eq!(json["modules"][0]["written"], false);
            assert_eq!(json["modules"][0]["loaded"], false);
            assert_eq!(shop.loaded(), [""; 0]);
        });
    }

    #[test]
    #[ignore = "long"]
    fn a_module_whose_name_cannot_be_loaded_is_told_before_anything_is_written() {
        on_each_robotware(|personality| {
            let shop = Shop::new(personality);
            let corrected = String::from_utf8_lossy(&PROGRAMS[1]).into_owned();
            let long = format!("MOD_{}", "x".repeat(40));
            std::fs::write(shop.module(), corrected.replace("MOD_Cube45", &long)).unwrap();
            let (_, out, _) = shop.run(&["push", "MODULE", "HOST"]);
            assert!(out.contains("--load would be refused: ") && out.contains("is no RAPID name"), "{out}");
            let (exit, _, message) = shop.run(&CONFIRMED_LOAD);
            assert!(exit == 2 && message.contains("link::name"), "{message}");
            assert!(shop.double.with(|c| c.files.is_empty()));
        });
    }
}

//! Motions to an element of an array that only run time tells: elements that are not in use, and what is said of the clock.

use super::{Bench, driftpost, err, out};
use serde_json::Value;

const REST: &str = "[0.0871557,0,0.9961947,0],[0,-1,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]";

/// A pallet of four places, of which `main` goes to one.
fn pallet(kind: &str, places: [&str; 4], main: &str) -> String {
    let places = places.map(|at| format!("[[{at}],{REST}")).join(",");
    format!(
        "MODULE A\n  PERS tooldata tGun:=[TRUE,[[0,0,120],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]];
  PERS num nPos:=1;\n  {kind} robtarget pu{{4}}:=[{places}];\n  PROC main()
    MoveAbsJ [[5,10,20,5,50,5],[9E9,9E9,9E9,9E9,9E9,9E9]],v500,fine,tGun;\n{main}  ENDPROC\nENDMODULE\n"
    )
}

const BY_PERS: &str = "    MoveL pu{nPos},v100,fine,tGun;\n";
const COUNTED: &str = "    FOR i FROM 1 TO 2 DO\n      MoveL pu{i},v100,fine,tGun;\n    ENDFOR\n";
const NOT_REACHED: &str = "of pu{nPos} the arm does not reach elements 3 and 4: they stay as they are";

/// Each motion's status, and what is said beside, of a module compensated in a form.
fn compensated(bench: &Bench, text: &str, form: &str) -> (Vec<String>, String) {
    let from = bench.file("a.mod", text);
    let [to, json] = ["o.mod", "o.json"].map(|name| bench.path(name).display().to_string());
    let made = driftpost(&[
        "compensate",
        &from,
        "-o",
        &to,
        "--form",
        form,
        "--diff",
        "none",
        "--force",
        "--json",
        &json,
    ]);
    assert_eq!(made.status.code(), Some(0), "{form}: {}", err(&made));
    let json: Value = serde_json::from_str(&bench.text("o.json")).unwrap();
    let status = |motion: &Value| motion["status"].as_str().unwrap().to_owned();
    (json["motions"].as_array().unwrap().iter().map(status).collect(), err(&made))
}

#[test]
fn elements_that_the_arm_does_not_reach_stay_and_the_others_are_corrected() {
    let bench = Bench::default();
    let places = ["430,60,300", "430,90,300", "0,0,0", "3000,0,0"];
    for (kind, main, said) in
        [("PERS", BY_PERS, NOT_REACHED), ("CONST", COUNTED, "of pu{i} the arm does not reach")]
    {
        for form in ["schedule", "ramp", "live", "auto"] {
            let text = pallet(kind, places, main);
            let (status, message) = compensated(&bench, &text, form);
            assert_eq!(status, ["compensated"; 2], "{form} {main}");
            assert!(
                message.contains("warning[reach::element]") && message.contains(said),
                "{form}: {message}"
            );
            let made = bench.text("o.mod").replace(char::is_whitespace, "");
            match form {
                "ramp" => assert!(made.contains("],[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];"), "{made}"),
                "schedule" => assert!(made.contains("[[[3000,0,0],"), "{made}"),
                _ => {}
            }
            let [from, to] = ["a.mod", "o.mod"].map(|name| bench.path(name).display().to_string());
            for place in ["1", "2"] {
                let set = format!("nPos={place}");
                let run = driftpost(&[
                    "simulate",
                    &to,
                    "--original",
                    &from,
                    "--minutes",
                    "0,37,240",
                    "--set",
                    &set,
                ]);
                assert_eq!(run.status.code(), Some(0), "{form} {place}: {}", err(&run));
            }
            let restored = driftpost(&["restore", &to, "-o", "-"]);
            assert_eq!(out(&restored), text, "{form}: {}", err(&restored));
        }
    }
}

#[test]
fn an_array_of_which_no_element_is_reached_is_kept() {
    let bench = Bench::default();
    let (status, message) = compensated(&bench, &pallet("PERS", ["3000,0,0"; 4], BY_PERS), "ramp");
    assert_eq!(status, ["compensated", "kept"]);
    assert!(message.contains("reach::none") && !message.contains("reach::element"), "{message}");
    // Where all are reached nothing is said.
    let all = ["430,60,300", "430,90,300", "430,60,250", "430,90,250"];
    let (status, message) = compensated(&bench, &pallet("PERS", all, BY_PERS), "ramp");
    assert!(status == ["compensated"; 2] && !message.contains("reach::"), "{message}");
}

/// To one of sixty elements some 130 mm away and at most 170 mm from each other: at 5 mm/s a minute, where the way through all of them takes
/// the ten minutes of a pause and more.
#[test]
fn the_way_to_an_element_is_no_way_through_all_of_them() {
    let bench = Bench::default();
    let places: Vec<String> =
        (0..60).map(|i| format!("[[{},{},{}],{REST}", 400 + i % 4, 60 + 2 * i, 300 - 20 * (i % 3))).collect();
    let array = format!("  CONST robtarget pa{{60}}:=[\n    {}];\n", places.join(",\n    "));
    let text = |speed: &str| {
        let main = BY_PERS.replace("pu{nPos},v100", &format!("pa{{nPos}},{speed}"));
        let text = pallet("PERS", ["430,60,300"; 4], &main);
        text.replacen("  PROC main", &format!("{array}  PROC main"), 1)
    };
    for (speed, is_long) in [("v5", false), ("[0.3,500,5000,1000]", true)] {
        let (status, message) = compensated(&bench, &text(speed), "schedule");
        assert_eq!(status, ["compensated"; 2]);
        assert_eq!(message.contains("clock::long-motion"), is_long, "{speed}: {message}");
    }
}

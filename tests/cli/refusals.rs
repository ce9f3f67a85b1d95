//! Bad input: one clear message with its code, exit 2, nothing written.

use crate::{Bench, CUBE, driftpost, err, out};

const GOOD: &str = "MODULE m
  CONST robtarget p:=[[450,-100,300],[0,0,1,0],[-1,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  PROC main()
    MoveL p,v100,fine,tool0;
  ENDPROC
ENDMODULE
";
const HEADER: &str = "Dx [mm],Dy[mm],Dz[mm],DOx[deg],DOy[deg],DOz[deg]\n";

/// Runs `compensate` with an output on the bench and expects the code, exit 2 and no new file.
fn refused(bench: &Bench, arguments: &[&str], code: &str) -> String {
    let before = bench.files();
    let result = bench.path("out.mod").display().to_string();
    let mut all = vec!["compensate"];
    all.extend(arguments);
    if !arguments.contains(&"-o") {
        all.extend(["-o", &result]);
    }
    let output = driftpost(&all);
    let message = err(&output);
    assert_eq!(output.status.code(), Some(2), "{arguments:?}\n{message}");
    assert!(message.contains(&format!("error[{code}]")), "{arguments:?}: {code} is not in\n{message}");
    assert_eq!(message.matches("error[").count(), 1, "{message}");
    assert_eq!(out(&output), "", "{arguments:?}");
    assert_eq!(bench.files(), before, "{arguments:?}");
    message
}

#[test]
fn a_missing_file_is_named_with_its_neighbour() {
    let bench = Bench::default();
    bench.file("Cube45.mod", GOOD);
    let wrong = bench.path("Cube54.mod").display().to_string();
    let message = refused(&bench, &[&wrong], "input::missing");
    assert!(message.contains("did you mean") && message.contains("Cube45.mod"), "{message}");
}

#[test]
fn files_that_are_no_modules_are_refused() {
    let bench = Bench::default();
    bench.file("empty_folder/readme.txt", "nothing");
    let folder = bench.path("empty_folder").display().to_string();
    refused(&bench, &[&folder], "input::no-modules");
    refused(&bench, &[&bench.file("e.mod", " \r\n")], "input::empty");
    refused(&bench, &[&bench.file("b.mod", b"\x7fELF\0\0\x01")], "input::binary");
    refused(&bench, &[&bench.file("t.mod", "hello\n")], "input::no-module");
    let cut = &GOOD[..GOOD.len() - 12];
    let message = refused(&bench, &[&bench.file("cut.mod", cut)], "input::truncated");
    assert!(message.contains("cut.mod:1:1"), "{message}");
}

#[test]
fn deformation_tables_that_cannot_be_used_are_refused() {
    let bench = Bench::default();
    let table = |rows: &[&str]| format!("{HEADER}{}\n", rows.join("\n"));
    let zero = "0,0,0,0,0,0";
    let cases = [
        ("nan.csv", table(&[zero, zero, "0,NaN,0,0,0,0", zero, zero, zero]), "deform::value"),
        ("text.csv", table(&[zero, zero, "0,abc,0,0,0,0", zero, zero, zero]), "deform::value"),
        ("five.csv", table(&[zero; 5]), "deform::rows"),
    ];
    for (name, text, code) in cases {
        let file = bench.file(name, text);
        let message = refused(&bench, &[CUBE, "--deformation", &file, "--growth", "none"], code);
        assert!(message.contains(name), "{message}");
    }
    let file = bench.file("static.csv", table(&[zero; 6]));
    refused(&bench, &[CUBE, "--deformation", &file], "deform::no-growth");
}

#[test]
fn numbers_and_names_that_make_no_sense_are_refused() {
    let bench = Bench::default();
    refused(&bench, &[CUBE, "--tolerance-mm", "0"], "schedule::tolerance");
    refused(&bench, &[CUBE, "--tolerance-mm", "-0.005"], "schedule::tolerance");
    refused(&bench, &[CUBE, "--until", "-3"], "schedule::until");
    refused(&bench, &[CUBE, "--max-correction-mm", "-1"], "option::number");
    let message = refused(&bench, &[CUBE, "--robot", "irb14"], "robot::unknown");
    assert!(message.contains("did you mean `irb140`"), "{message}");
    refused(&bench, &[CUBE, "--robot", "irb2400"], "robot::coupled");
    let message = refused(&bench, &[CUBE, "--growth", "two-stag:46"], "deform::growth");
    assert!(message.contains("did you mean `two-stage`"), "{message}");
}

#[test]
fn programs_that_must_not_be_corrected_are_refused() {
    let bench = Bench::default();
    let far = bench.file("far.mod", GOOD.replace("[450,-100,300]", "[4500,-100,300]"));
    let output = driftpost(&["compensate", &far]);
    assert_eq!(output.status.code(), Some(2));
    assert!(err(&output).contains("error[compensate::nothing]"), "{}", err(&output));
    let other = GOOD.replace("  PROC", "  ! Using calibrated kinematics.\n  PROC");
    let other = bench.file("other.mod", other);
    let message = refused(&bench, &[&other], "refuse::not-nominal");
    assert!(message.contains("other.mod:3:"), "{message}");
    let good = bench.file("good.mod", GOOD);
    assert_eq!(driftpost(&["compensate", &good]).status.code(), Some(0));
    let emitted = bench.path("good_tc.mod").display().to_string();
    refused(&bench, &[&emitted], "refuse::already-compensated");
}

#[test]
fn a_non_nominal_program_is_taken_when_the_user_says_so() {
    let bench = Bench::default();
    let file = bench.file("o.mod", GOOD.replace("  PROC", "  ! Using calibrated kinematics.\n  PROC"));
    let output = driftpost(&["compensate", &file, "--allow-non-nominal"]);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    assert!(err(&output).contains("warning[refuse::not-nominal]"));
}

#[test]
fn an_output_that_cannot_be_written_is_found_before_the_work() {
    let bench = Bench::default();
    let good = bench.file("good.mod", GOOD);
    refused(&bench, &[&good, "-o", &good], "output::is-input");
    let inside_a_file = format!("{good}/x.mod");
    refused(&bench, &[&good, "-o", &inside_a_file], "output::unwritable");
    let folder = bench.path("folder.mod");
    std::fs::create_dir(&folder).unwrap();
    let diff = folder.display().to_string();
    refused(&bench, &[&good, "--diff", &diff], "output::unwritable");
    refused(&bench, &[&good, "--joints-csv", &diff], "output::unwritable");
}

#[test]
fn strict_refuses_what_would_be_kept_and_json_says_so() {
    let bench = Bench::default();
    let kept = GOOD.replace("    MoveL p,", "    MoveL pWhere,v100,fine,tool0;\n    MoveL p,");
    let file = bench.file("k.mod", kept);
    assert_eq!(driftpost(&["compensate", &file, "-o", "/dev/null/x"]).status.code(), Some(2));
    let json = bench.path("r.json").display().to_string();
    let output = driftpost(&["compensate", &file, "--strict", "--json", &json]);
    assert_eq!(output.status.code(), Some(2), "{}", err(&output));
    assert_eq!(bench.files(), ["k.mod", "r.json"]);
    let value: serde_json::Value = serde_json::from_str(&bench.text("r.json")).unwrap();
    assert_eq!(value["motions"][0]["status"], "refused");
    assert_eq!(value["motions"][1]["status"], "compensated");
    assert!(!value["errors"].as_array().unwrap().is_empty());
    assert_eq!(driftpost(&["compensate", &file]).status.code(), Some(0));
}

#[test]
fn fifty_megabytes_of_no_module_are_refused_at_once() {
    let bench = Bench::default();
    let file = bench.file("big.mod", vec![b'('; 50_000_000]);
    let start = std::time::Instant::now();
    refused(&bench, &[&file], "input::no-module");
    assert!(start.elapsed().as_secs() < 60);
}

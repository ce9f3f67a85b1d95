//! Bad input: one clear message with its code, exit 2, nothing written.

use super::{Bench, CUBE, driftpost, err, out};

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
    let pgf = bench.file("list.pgf", "<?xml version=\"1.0\"?><Program></Program>");
    assert!(refused(&bench, &[&pgf], "input::no-modules").contains("give the modules themselves"));
    let pgf = bench.file("cell.PGF", GOOD);
    let message = refused(&bench, &[&pgf], "input::no-modules");
    assert!(message.contains("is itself a module") && message.contains(".mod"), "{message}");
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
fn a_table_that_begins_warm_is_told() {
    let bench = Bench::default();
    let result = bench.path("out.mod").display().to_string();
    let warned = |name: &str, first: &str| {
        let header = "t_min,joint,dx_mm,dy_mm,dz_mm,rx_deg,ry_deg,rz_deg";
        let table = bench.file(name, format!("{header}\n{first}60,3,0.3,0,0,0,0,0\n"));
        let output = driftpost(&[
            "compensate",
            CUBE,
            "--deformation",
            &table,
            "--tau-cool",
            "60",
            "-o",
            &result,
            "--diff",
            "none",
        ]);
        assert_eq!(output.status.code(), Some(0), "{}", err(&output));
        err(&output).contains("warning[deform::late-start]")
            && err(&output).contains("joint 3 begin at minute")
    };
    assert!(warned("late.csv", "10,3,0.1,0,0,0,0,0\n") && warned("later.csv", ""));
    assert!(!warned("cold.csv", "0,3,0,0,0,0,0,0\n"));
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
    // Motions that were copied from a corrected module ask for what is not there.
    for asked in ["tcAt(p,tcP)", "tcLive(p,tool0)", "tc12{tcK()}", "TCLIVEJ(j,tool0)"] {
        let move_name = if asked.contains('j') { "MoveAbsJ" } else { "MoveL" };
        let copied =
            GOOD.replace("  ENDPROC", &format!("    {move_name} {asked},v100,fine,tool0;\n  ENDPROC"));
        assert_ne!(copied, GOOD);
        let copied = bench.file("copied.mod", copied);
        let message = refused(&bench, &[&copied, "--form", "auto"], "refuse::already-compensated");
        assert!(message.contains("is in none of the given files"), "{message}");
    }
    // A function of one's own may bear such a name.
    let own = "  FUNC robtarget tcAt(robtarget p)\n    RETURN p;\n  ENDFUNC\nENDMODULE";
    let own =
        GOOD.replace("ENDMODULE", own).replace("  ENDPROC", "    MoveL tcAt(p),v100,fine,tool0;\n  ENDPROC");
    let own = bench.file("own.mod", own);
    assert_eq!(driftpost(&["compensate", &own]).status.code(), Some(0));
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

/// A plant's own wrapper that is not given moves where nobody knows: it counts among the motions.
#[test]
fn strict_refuses_a_call_that_moves_and_is_not_given() {
    let bench = Bench::default();
    let wrapped =
        GOOD.replace("    MoveL p,", "    MoveL_CollClr 3\\Coll_B:=4,p,v200,fine,tool0;\n    MoveL p,");
    let file = bench.file("w.mod", wrapped);
    let output = driftpost(&["compensate", &file]);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    assert!(out(&output).contains("2 motions: 1 compensated, 1 kept"), "{}", out(&output));
    assert!(
        err(&output).contains("warning[keep::instruction]: line 4: this MoveL_CollClr"),
        "{}",
        err(&output)
    );
    let json = bench.path("r.json").display().to_string();
    let output = driftpost(&["compensate", &file, "--strict", "--json", &json]);
    assert_eq!(output.status.code(), Some(2), "{}", err(&output));
    let value: serde_json::Value = serde_json::from_str(&bench.text("r.json")).unwrap();
    let motion = &value["motions"][0];
    assert_eq!([&motion["kind"], &motion["status"]], ["MoveL_CollClr", "refused"]);
    assert!(motion["reason"].as_str().unwrap().contains("nobody knows where"), "{motion}");
    let inspected = driftpost(&["inspect", &file]);
    assert!(out(&inspected).contains("2 motions, 1 can be compensated as far as the text tells, 1 cannot"));
}

#[test]
fn fifty_megabytes_of_no_module_are_refused_at_once() {
    let bench = Bench::default();
    let file = bench.file("big.mod", vec![b'('; 50_000_000]);
    let start = std::time::Instant::now();
    refused(&bench, &[&file], "input::no-module");
    assert!(start.elapsed().as_secs() < 60);
}

/// Runs a command that would write over one of its inputs, and expects them all as they were.
fn spares(bench: &Bench, arguments: &[&str], code: &str) {
    let before: Vec<(String, Vec<u8>)> = bench
        .files()
        .into_iter()
        .map(|name| (name.clone(), std::fs::read(bench.path(&name)).unwrap()))
        .collect();
    let output = driftpost(arguments);
    let message = err(&output);
    assert_eq!(output.status.code(), Some(2), "{arguments:?}\n{message}");
    assert!(message.contains(&format!("error[{code}]")), "{arguments:?}: {code} is not in\n{message}");
    for (name, bytes) in before {
        assert!(std::fs::read(bench.path(&name)).unwrap() == bytes, "{arguments:?} changed {name}");
    }
}

#[test]
fn no_result_goes_where_an_input_stands() {
    let bench = Bench::default();
    let program = bench.file("a.mod", GOOD);
    let table = bench.file("def/t.csv", format!("{HEADER}{}", "0,0,0,0,0,0.01\n".repeat(6)));
    let result = bench.path("q.mod").display().to_string();
    let folder = bench.path("def").display().to_string();
    for option in ["--json", "--diff", "--joints-csv"] {
        spares(&bench, &["compensate", &program, "-o", &result, option, &program], "output::is-input");
        spares(&bench, &["compensate", &program, "-o", &result, option, &result], "output::twice");
    }
    let with_table = ["compensate", &program, "--deformation", &table, "--growth", "none"];
    spares(&bench, &[&with_table[..], &["-o", &table]].concat(), "output::is-input");
    spares(&bench, &["inspect", &program, "--json", &program], "output::is-input");
    spares(&bench, &["diff", &program, &program, "--json", &program], "output::is-input");
    spares(&bench, &["golden", &folder, "--json", &table], "output::is-input");
    spares(&bench, &["tabulate", &table, "--joints-csv", &table], "output::is-input");
    spares(&bench, &["tabulate", &table, "--joints-csv", "-", "--json", "-"], "output::twice");
}

#[test]
fn results_stay_inside_the_folder_that_is_named() {
    let bench = Bench::default();
    let one = bench.file("d1/b.mod", GOOD.replace("MODULE m", "MODULE n").replace("main", "other"));
    bench.file("d2/a.mod", GOOD);
    let crooked = bench.path("d1/../d2/a.mod").display().to_string();
    let to = bench.path("any").display().to_string();
    assert_eq!(driftpost(&["compensate", &crooked, &one, "-o", &to]).status.code(), Some(0));
    assert_eq!(bench.text("d2/a.mod"), GOOD);
    assert!(bench.text("any/d2/a.mod").contains("! driftpost"));
    assert!(bench.text("any/d1/b.mod").contains("! driftpost"));
}

#[test]
fn a_common_module_of_another_program_stays() {
    let bench = Bench::default();
    let (a, b) = (bench.file("a.mod", GOOD), bench.file("b.mod", GOOD.replace("MODULE m", "MODULE n")));
    let separate = |path: &str, more: &[&str]| {
        let output = driftpost(&[&["compensate", path, "--core", "separate"][..], more].concat());
        (output.status.code(), err(&output))
    };
    assert_eq!(separate(&a, &[]).0, Some(0));
    // The same program anew, with other buckets, brings its own core with it.
    assert_eq!(separate(&a, &["--tolerance-mm", "0.02"]).0, Some(0));
    let core = bench.text("tcCore.mod");
    let (code, message) = separate(&b, &["--tolerance-mm", "0.05"]);
    assert!(code == Some(2) && message.contains("output::other-core"), "{message}");
    assert_eq!((bench.text("tcCore.mod"), bench.path("b_tc.mod").exists()), (core, false));
    bench.file("own/tcCore.mod", "MODULE mine ENDMODULE");
    let own = bench.file("own/c.mod", GOOD);
    assert!(separate(&own, &[]).1.contains("output::other-core"));
}

#[cfg(unix)]
#[test]
fn a_pipe_is_written_to_and_a_link_stays_one() {
    let bench = Bench::default();
    let program = bench.file("a.mod", GOOD);
    bench.file("real.json", "");
    let link = bench.path("link.json");
    std::os::unix::fs::symlink("real.json", &link).unwrap();
    let link = link.display().to_string();
    let output = driftpost(&["inspect", &program, "--json", &link]);
    assert_eq!(output.status.code(), Some(0));
    assert!(std::fs::symlink_metadata(&link).unwrap().is_symlink());
    assert!(bench.text("real.json").contains("\"motions\""));
    let output = driftpost(&["inspect", &program, "--json", "/dev/null"]);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    assert!(!std::fs::metadata("/dev/null").unwrap().is_file());
}

#[test]
fn a_case_without_its_program_is_missed() {
    let bench = Bench::default();
    bench.file("gold/a/source/a.mod", GOOD);
    bench.file("gold/b/options.toml", "");
    let folder = bench.path("gold").display().to_string();
    let output = driftpost(&["golden", &folder]);
    assert!(
        output.status.code() == Some(2) && err(&output).contains("golden::no-source"),
        "{}",
        err(&output)
    );
}

#[test]
fn a_restored_file_stays_in_its_folder() {
    let bench = Bench::default();
    let program = bench.file("p/a.mod", GOOD);
    assert_eq!(driftpost(&["compensate", &program]).status.code(), Some(0));
    let crooked = bench.text("p/a_tc.mod").replace(" a.mod\n", " ../../x.mod\n");
    let emitted = bench.file("p/q/a_tc.mod", crooked);
    // A comment block that was edited is said, and counts as a difference.
    let output = driftpost(&["restore", &emitted]);
    assert_eq!(output.status.code(), Some(1), "{}", err(&output));
    assert_eq!(bench.text("p/q/x.mod"), GOOD);
}

#[test]
fn another_robot_is_told() {
    let bench = Bench::default();
    let made_for =
        "! Program generated by RoboDK 5.6 for ABB IRB 2600-12/1.65 on 01/02/2026 10:00:00\n  PROC main";
    let program = bench.file("a.mod", GOOD.replace("PROC main", made_for));
    let to = bench.path("b.mod").display().to_string();
    let output = driftpost(&["compensate", &program, "-o", &to]);
    assert!(err(&output).contains("robot::other"), "{}", err(&output));
    let output = driftpost(&["compensate", CUBE, "--robot", "irb120", "-o", &to]);
    assert!(err(&output).contains("deform::other-robot"), "{}", err(&output));
}

#[test]
fn where_nothing_is_compensated_the_json_says_why_for_each() {
    let bench = Bench::default();
    let program = bench.file("a.mod", GOOD.replace("MoveL p", "MoveL CRobT()").replace("tool0", "unknown"));
    let output = driftpost(&["compensate", &program, "--json", "-"]);
    assert_eq!(output.status.code(), Some(2));
    let json: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let row = &json["motions"][0];
    assert_eq!((&row["status"], &row["line"]), (&"kept".into(), &4.into()));
    assert!(!row["reason"].as_str().unwrap().is_empty());
}

#[test]
fn an_effect_without_its_joint_is_shown_with_one() {
    let bench = Bench::default();
    let folder = bench.path("sets").display().to_string();
    for (given, expected) in [
        ("joint_compliance", "for example joint_compliance:2"),
        ("joint_complience:2", "did you mean joint_compliance:2?"),
        ("joint_coupling:2", "for example joint_coupling:2:3"),
        ("base_tild", "did you mean base_tilt?"),
    ] {
        let output = driftpost(&["synth", &folder, "--effects", given]);
        assert_eq!(output.status.code(), Some(2));
        assert!(err(&output).contains(expected), "{}", err(&output));
    }
    assert!(bench.files().is_empty());
}

/// What is put in before ENDMODULE would stand inside the open routine.
#[test]
fn a_routine_without_its_end_is_refused() {
    let bench = Bench::default();
    let module = bench.file("open.mod", GOOD.replace("  ENDPROC\n", ""));
    let message = refused(&bench, &[&module], "input::truncated");
    assert!(
        message.contains("routine main has no END word") && message.contains("open.mod:3:3"),
        "{message}"
    );
}

/// Lines count as an editor counts them, whatever ends them.
#[test]
fn lines_of_tables_with_cr_lf() {
    let bench = Bench::default();
    let text = "name,x_mm,y_mm,z_mm,rx_deg,ry_deg,rz_deg\r\nA,1,2,3,0,90,0\r\n\r\nB,1,two,3,0,90,0\r\n";
    let table = bench.file("targets.csv", text);
    let output = driftpost(&["tabulate", &table]);
    assert!(err(&output).contains("line 4, column 3 (`y_mm`): `two`"), "{}", err(&output));
}

#[test]
fn a_touch_that_no_clock_could_take_is_refused_with_the_reason() {
    let bench = Bench::default();
    let cell = std::fs::read_to_string("fixtures/docs/Cell.mod").unwrap();
    let touch = ["--touch", "S1=pSphere,tool0,wobj0", "--touch-signal", "diTouch"];
    let refusal_text = |program: &str, more: &[&str]| {
        refused(&bench, &[&[program], &touch[..], more].concat(), "touch::clock")
    };
    let program = bench.file("Cell.mod", &cell);
    // A model in which nothing grows; beside a table that grows it is no hindrance.
    let model = "fixtures/docs/identified.toml";
    assert!(refusal_text(&program, &["--model", model]).contains("nothing of the model grows"));
    let row = "0.01,0,0.05,0,0.002,0\n";
    let table = bench.file("static.csv", format!("{HEADER}{}", row.repeat(6)));
    let written = bench.path("both.mod").display().to_string();
    let both = ["--model", model, "--deformation", &table, "--growth", "two-stage:46", "-o", &written];
    let output = driftpost(&[&["compensate", &program], &touch[..], &both].concat());
    assert!(output.status.success() && bench.text("both.mod").contains("PROC tcTouch()"), "{}", err(&output));
    // A scheduled table grows as it was measured, by no law whose lags a touch could tell.
    let rows =
        |t_min: u32, dz_mm: f64| (1..=6).map(move |joint| format!("{t_min},{joint},0,0,{dz_mm},0,0,0\n"));
    let rows: String = rows(0, 0.0).chain(rows(60, 0.03)).chain(rows(180, 0.05)).collect();
    let scheduled =
        bench.file("scheduled.csv", format!("t_min,joint,dx_mm,dy_mm,dz_mm,rx_deg,ry_deg,rz_deg\n{rows}"));
    let by_table = refusal_text(&program, &["--deformation", &scheduled, "--tau-cool", "60"]);
    assert!(by_table.contains("a static table with --growth"), "{by_table}");
    assert!(refusal_text(&program, &["--clock", "elapsed"]).contains("use --clock warmth"));
    // RAPID of an S4C has no CalcJointT, from which the joints of a log come.
    assert!(refusal_text(&bench.file("Cell.prg", &cell), &["--touch-log"]).contains("no CalcJointT"));
}

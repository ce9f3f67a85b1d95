//! Standard output, standard error, closed pipes, folders that cannot be written to.

use super::{Bench, CUBE, driftpost, err, out};
use std::io::Read;
use std::process::{Command, Stdio};

#[test]
fn results_and_messages_do_not_mix() {
    let output = driftpost(&["inspect", CUBE]);
    assert_eq!(output.status.code(), Some(0));
    assert!(out(&output).contains("46 motions"), "{}", out(&output));
    assert!(!out(&output).contains("warning["), "{}", out(&output));
    let output = driftpost(&["inspect", "fixtures/robodk/s4c/RichProg.prg"]);
    assert!(err(&output).contains("warning["), "{}", err(&output));
    assert!(!out(&output).contains("warning["), "{}", out(&output));
}

#[test]
fn inspect_writes_json_and_csv() {
    let output = driftpost(&["inspect", CUBE, "--format", "json"]);
    let value: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(value["motions"].as_array().unwrap().len(), 46);
    let output = driftpost(&["inspect", CUBE, "--format", "csv"]);
    assert_eq!(out(&output).lines().count(), 47);
}

#[test]
fn a_robot_is_shown_as_json() {
    let output = driftpost(&["robot", "--robot", "irb140", "--json", "-"]);
    let robot: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(robot["joints"].as_array().unwrap().len(), 6);
    assert_eq!(robot["joints"][1]["range"], serde_json::json!([-90.0, 110.0]), "ABB's data sheet");
}

#[test]
fn a_corrected_module_is_inspected_as_one() {
    let bench = Bench::default();
    let made = bench.path("made.mod").display().to_string();
    assert!(driftpost(&["compensate", CUBE, "-o", &made, "--quiet"]).status.success());
    let output = driftpost(&["inspect", &made]);
    let text = out(&output);
    assert!(output.status.success() && text.contains("already compensated in MOD_Cube45"), "{text}");
    assert!(text.contains("driftpost restore") && !text.contains("can be compensated"), "{text}");
    let read: serde_json::Value =
        serde_json::from_slice(&driftpost(&["inspect", &made, "--format", "json"]).stdout).unwrap();
    let first = &read["motions"][0];
    assert_eq!(
        (&first["can"], &first["code"]),
        (&false.into(), &"refuse::already-compensated".into()),
        "{first}"
    );
    let csv = out(&driftpost(&["inspect", &made, "--format", "csv"]));
    assert_eq!(
        csv.lines().filter(|line| line.contains(",keep,refuse::already-compensated,")).count(),
        46,
        "{csv}"
    );
}

#[test]
fn a_loop_without_noise_or_limit_is_refused() {
    for (option, value) in [("--sigma-mm", "0"), ("--sigma-mm", "-1"), ("--limit", "0"), ("--limit", "-1")] {
        let output = driftpost(&["closed-loop", CUBE, "--inject", "joint_compliance:2", option, value]);
        assert_eq!(output.status.code(), Some(2), "{option} {value}");
        let text = err(&output);
        assert!(
            text.contains("option::number") && text.contains(&format!("{option} must be more than 0")),
            "{text}"
        );
    }
}

/// The fixture's own SHA-256 in a model that was fitted to something else.
#[test]
fn the_rows_that_a_model_was_fitted_to_validate_nothing() {
    let bench = Bench::default();
    let measured = "fixtures/docs/measured.csv";
    let text = std::fs::read_to_string("fixtures/docs/identified.toml").unwrap();
    let hash = driftpost::application::Named::new((), "", &std::fs::read(measured).unwrap()).source.sha256;
    let own_line = text.lines().find(|line| line.starts_with("sha256 = ")).unwrap();
    assert!(!own_line.contains(&hash));
    let same = bench.file("m.toml", text.replace(own_line, &format!("sha256 = \"{hash}\"")));
    let messages = |model: &str| err(&driftpost(&["validate", measured, "--model", model]));
    assert!(messages(&same).contains("warning[model::same-data]"), "{}", messages(&same));
    assert!(!messages("fixtures/docs/identified.toml").contains("same-data"));
}

#[test]
fn a_closed_pipe_is_not_an_error() {
    let bench = Bench::default();
    let result = bench.path("o.mod");
    let mut child = Command::new(env!("CARGO_BIN_EXE_driftpost"))
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .args(["compensate", CUBE, "-o"])
        .arg(&result)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut one = [0];
    drop(child.stdout.take().map(|mut out| out.read(&mut one)));
    let status = child.wait().unwrap();
    assert_eq!(status.code(), Some(0));
    assert!(result.exists());
}

#[cfg(target_os = "linux")]
#[test]
fn a_folder_that_cannot_be_written_to_is_found_before_the_work() {
    use std::os::unix::fs::PermissionsExt;
    let bench = Bench::default();
    let mut folder = bench.path("locked");
    std::fs::create_dir(&folder).unwrap();
    std::fs::set_permissions(&folder, std::fs::Permissions::from_mode(0o555)).unwrap();
    if std::fs::write(folder.join("probe"), "").is_ok() {
        std::fs::remove_file(folder.join("probe")).unwrap();
        // root may write everywhere but where the kernel alone does.
        folder = "/proc".into();
    }
    let result = folder.join("o.mod").display().to_string();
    let output = driftpost(&["compensate", CUBE, "-o", &result]);
    assert_eq!(output.status.code(), Some(2));
    assert!(err(&output).contains("output::unwritable"), "{}", err(&output));
}

#[test]
fn help_and_version_are_results() {
    for arguments in [["--help"].as_slice(), &["--version"], &["compensate", "--help"]] {
        let output = driftpost(arguments);
        assert_eq!(output.status.code(), Some(0));
        assert!(!out(&output).is_empty() && err(&output).is_empty());
    }
    assert_eq!(driftpost(&[]).status.code(), Some(2));
}

/// What `compensate` makes of a `.pgf` comes back as it was: the list of modules, too.
#[test]
fn a_module_is_restored_through_pipes_and_into_a_new_folder() {
    let bench = Bench::default();
    let emitted = bench.path("Cube45_tc.mod").display().to_string();
    assert!(driftpost(&["compensate", CUBE, "-o", &emitted, "--quiet"]).status.success());
    let original = std::fs::read(CUBE).unwrap();

    let output = driftpost(&["restore", &emitted, "-o", "-"]);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    assert!(output.stdout == original);
    let folder = bench.path("not/yet there/").display().to_string();
    assert_eq!(driftpost(&["restore", &emitted, "-o", &folder]).status.code(), Some(0));
    assert!(bench.text("not/yet there/Cube45.mod").as_bytes() == original);
    let output = Command::new(env!("CARGO_BIN_EXE_driftpost"))
        .args(["restore", "-"])
        .stdin(std::fs::File::open(&emitted).unwrap())
        .current_dir(bench.path(""))
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    assert!(output.stdout == original, "standard input is restored to standard output");
    let both = driftpost(&["restore", &emitted, "-o", "-", "--json", "-"]);
    assert_eq!(both.status.code(), Some(2));
    assert!(err(&both).contains("output::twice"), "{}", err(&both));
    assert!(!bench.path("-").exists());
}

#[test]
fn an_original_that_is_there_may_stay() {
    let bench = Bench::default();
    bench.file("Cube45.mod", std::fs::read(CUBE).unwrap());
    let emitted = bench.path("Cube45_tc.mod").display().to_string();
    assert!(driftpost(&["compensate", CUBE, "-o", &emitted, "--quiet"]).status.success());
    let output = driftpost(&["restore", &emitted]);
    assert_eq!(output.status.code(), Some(0), "{}", err(&output));
    bench.file("Cube45.mod", "MODULE Other\r\nENDMODULE\r\n");
    let output = driftpost(&["restore", &emitted]);
    assert_eq!(output.status.code(), Some(2));
    assert!(err(&output).contains("output::exists"), "{}", err(&output));
}

/// Where a result takes standard output, the verdict is a message.
#[test]
fn the_verdict_is_said_wherever_results_go() {
    let bench = Bench::default();
    let to = bench.path("tc.mod").display().to_string();
    for (how, quiet) in
        [(["-o", "-"].to_vec(), false), (vec!["-o", &to, "--json", "-"], false), (vec!["-o", "-"], true)]
    {
        let quiet_option: &[&str] = if quiet { &["--quiet"] } else { &[] };
        let output = driftpost(&[&["compensate", CUBE, "--diff", "none"], &how[..], quiet_option].concat());
        assert_eq!(output.status.code(), Some(0), "{}", err(&output));
        let verdict = "46 motions: 46 compensated, 0 kept, 0 refused; 21 buckets";
        assert_eq!(err(&output).contains(verdict), !quiet, "{how:?} {}", err(&output));
        assert!(!out(&output).contains(verdict));
    }
}

#[test]
fn a_restored_module_goes_over_itself_and_over_no_other_program() {
    let bench = Bench::default();
    let emitted = bench.path("Cube45_tc.mod").display().to_string();
    assert!(driftpost(&["compensate", CUBE, "-o", &emitted, "--quiet"]).status.success());
    let [other, own] = ["other.mod", "own.mod"].map(|name| bench.path(name).display().to_string());
    std::fs::write(&other, "MODULE Other\r\nENDMODULE\r\n").unwrap();
    let edited = "MODULE mod_cube45\r\nENDMODULE\r\n";
    std::fs::write(&own, edited).unwrap();
    let output = driftpost(&["restore", &emitted, "-o", &other]);
    assert_eq!(output.status.code(), Some(2));
    assert!(
        err(&output).contains("output::changed") && err(&output).contains("module other"),
        "{}",
        err(&output)
    );
    assert_eq!(bench.text("other.mod"), "MODULE Other\r\nENDMODULE\r\n");
    // Its own, which somebody has gone on with.
    let output = driftpost(&["restore", &emitted, "-o", &own]);
    assert!(
        output.status.code() == Some(2) && err(&output).contains("own.mod is not as it was"),
        "{}",
        err(&output)
    );
    assert_eq!(bench.text("own.mod"), edited);
    for to in [&own, &other] {
        assert_eq!(driftpost(&["restore", &emitted, "-o", to, "--force"]).status.code(), Some(0));
        assert!(std::fs::read(to).unwrap() == std::fs::read(CUBE).unwrap());
        // What is there is the original now.
        assert_eq!(driftpost(&["restore", &emitted, "-o", to]).status.code(), Some(0));
    }
    // What was got back of modules that were touched up goes over each other.
    let text = bench.text("Cube45_tc.mod");
    for moved in ["tcMode:=0;", "tcMode:=1;"] {
        let comment = text.replacen("tcMode:=-1;", &format!("{moved} ! held"), 1);
        assert_ne!(comment, text);
        let changed = bench.file("changed.mod", comment);
        let output = driftpost(&["restore", &changed, "-o", &own]);
        assert_eq!(output.status.code(), Some(0), "{}", err(&output));
        assert!(bench.text("own.mod").contains("! held"));
    }
    assert!(bench.text(".driftpost").lines().all(|line| line.ends_with("  own.mod")));
    // Of several the one that was gone on with keeps all from being written.
    let folder = bench.path("all/").display().to_string();
    bench.file("all/Cube45.mod", edited);
    let second = bench.file("second.mod", text.replace("Cube45.mod", "B.mod"));
    let output = driftpost(&["restore", &second, &emitted, "-o", &folder]);
    assert!(output.status.code() == Some(2) && err(&output).contains("output::changed"), "{}", err(&output));
    assert!(bench.text("all/Cube45.mod") == edited && !bench.path("all/B.mod").exists());
    let output = driftpost(&["restore", &emitted, "-o", &bench.file("notes.txt", "of the cell\n")]);
    assert!(output.status.code() == Some(2) && err(&output).contains("output::changed"), "{}", err(&output));
}

/// A header holds a name in ASCII alone; a module that kept the name of its result is called as its original was.
#[test]
fn an_original_whose_name_is_not_ascii_has_it_again() {
    let bench = Bench::default();
    let source = bench.file("Größe.mod", std::fs::read(CUBE).unwrap());
    assert!(driftpost(&["compensate", &source, "--quiet", "--diff", "none"]).status.success());
    std::fs::remove_file(&source).unwrap();
    let emitted = bench.path("Größe_tc.mod").display().to_string();
    assert_eq!(driftpost(&["restore", &emitted]).status.code(), Some(0));
    let folder = bench.path("back/").display().to_string();
    assert_eq!(driftpost(&["restore", &emitted, "-o", &folder]).status.code(), Some(0));
    assert_eq!(bench.files(), ["Größe.mod", "Größe_tc.mod", "back/Größe.mod"]);
    // Of another length it is another name.
    let renamed = bench.file("Größer_tc.mod", std::fs::read(&emitted).unwrap());
    assert_eq!(driftpost(&["restore", &renamed, "-o", &folder]).status.code(), Some(0));
    assert!(bench.path("back/Gr??e.mod").exists());
}

/// A transfer as text that takes LF for the line end writes CR LF for each, be there a CR before it or not.
#[test]
fn a_module_with_doubled_carriage_returns_is_what_it_was() {
    let bench = Bench::default();
    let to = bench.path("o.mod").display().to_string();
    let original = std::fs::read_to_string(CUBE).unwrap().replace('\n', "\r\n");
    let source = bench.file("Cube45.mod", &original);
    for form in ["schedule", "ramp"] {
        let made = driftpost(&["compensate", &source, "-o", &to, "--form", form, "--quiet", "--force"]);
        assert!(made.status.success(), "{}", err(&made));
        let sent = bench.file("sent.mod", bench.text("o.mod").replace('\n', "\r\n"));
        let output = driftpost(&["restore", &sent, "-o", "-"]);
        assert_eq!(output.status.code(), Some(0), "{form}: {}", err(&output));
        assert!(
            out(&output) == original && err(&output).contains("byte for byte"),
            "{form}: {}",
            err(&output)
        );
    }
}

/// A file whose name is a hyphen is never what was meant.
#[test]
fn what_goes_to_a_file_alone_refuses_standard_output() {
    for command in
        [["plan", "--n", "20", "--rapid-out", "-"], ["compensate", CUBE, "--quiet", "--report", "-"]]
    {
        let output = driftpost(&command);
        assert_eq!(output.status.code(), Some(2), "{command:?}");
        assert!(err(&output).contains("output::unwritable"), "{}", err(&output));
        assert!(err(&output).contains("not to standard output"), "{}", err(&output));
    }
}

#[test]
fn a_whole_program_is_restored_by_its_folder() {
    let bench = Bench::default();
    let module = |name: &str| {
        format!(
            "MODULE {name}\n  PROC p{name}()\n    MoveAbsJ [[0,10,0,0,40,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0;\n  \
             ENDPROC\nENDMODULE\n"
        )
    };
    let list = "<Program>\r\n\t<Module>a.mod</Module>\r\n\t<Module>b.mod</Module>\r\n</Program>\r\n";
    bench.file("cell/a.mod", module("A"));
    bench.file("cell/b.mod", module("B"));
    let pgf = bench.file("cell/cell.pgf", list);
    let [to, back] = ["out", "back"].map(|name| bench.path(name).display().to_string());
    let made = driftpost(&["compensate", &pgf, "-o", &to, "--diff", "none"]);
    assert_eq!(made.status.code(), Some(0), "{}", err(&made));
    assert!(bench.text("out/cell.pgf").contains("tcCore.mod"));
    assert!(
        out(&made).contains("cell.pgf lists the new module, too"),
        "what is edited is said: {}",
        out(&made)
    );
    let restored = driftpost(&["restore", &to]);
    assert_eq!(restored.status.code(), Some(2), "a place must be said");
    let restored = driftpost(&["restore", &to, "-o", &back]);
    assert_eq!(restored.status.code(), Some(0), "{}", err(&restored));
    for name in ["a.mod", "b.mod", "cell.pgf"] {
        assert_eq!(bench.text(&format!("back/{name}")), bench.text(&format!("cell/{name}")));
    }
    assert!(!bench.path("back/tcCore.mod").exists());
}

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
mod long {
    use super::*;

    #[test]
    #[ignore = "long"]
    fn a_page_is_made_of_what_any_command_wrote() {
        let bench = Bench::default();
        let measured = "fixtures/docs/measured.csv";
        let model = "fixtures/docs/identified.toml";
        let touches = "fixtures/docs/touches.csv";
        let (emitted, original) = (bench.file("emitted.mod", ""), bench.file("original.mod", ""));
        driftpost(&["compensate", CUBE, "-o", &emitted, "--quiet"]);
        let results: [&[&str]; 6] = [
            &["inspect", CUBE],
            &["diff", CUBE, CUBE],
            &["plan", "--robot", "irb140", "--n", "30"],
            &["validate", measured, "--robot", "irb140", "--model", model],
            &["state", touches, "--robot", "irb140"],
            &["restore", &emitted, "-o", &original],
        ];
        for result in results {
            let (json, page) = (bench.file("result.json", ""), bench.file("page.html", ""));
            let ran = driftpost(&[result, &["--json", &json]].concat());
            let output = driftpost(&["report", &json, "-o", &page]);
            assert_eq!(output.status.code(), Some(0), "{}{}", err(&ran), err(&output));
            let page = std::fs::read_to_string(page).unwrap();
            assert!(page.contains(&format!("\"command\":\"{}\"", result[0])), "{result:?}");
        }
    }

    #[test]
    #[ignore = "long"]
    fn measurements_of_another_robot_validate_no_model() {
        let model = ["--model", "fixtures/docs/identified.toml"];
        let measured = "fixtures/docs/measured.csv";
        let own = driftpost(&[&["validate", measured, "--robot", "irb140"], &model[..]].concat());
        assert_eq!(own.status.code(), Some(0), "{}", err(&own));
        let other = driftpost(&[&["validate", measured, "--robot", "irb120"], &model[..]].concat());
        assert_eq!(other.status.code(), Some(1), "{}", err(&other));
        assert!(out(&other).contains("NOT this robot's measurements"), "{}", out(&other));
    }
}

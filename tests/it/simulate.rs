//! `driftpost simulate` on the command line: what it writes and how it ends.

use assert_cmd::Command;
use serde_json::Value;
use std::path::Path;

const CUBE: &str = "fixtures/robodk/irc5/Cube45.mod";

fn driftpost(args: &[&str]) -> Command {
    let mut command = Command::cargo_bin("driftpost").unwrap();
    command.current_dir(env!("CARGO_MANIFEST_DIR")).args(args);
    command
}

fn compensated(folder: &Path) -> String {
    let out = folder.join("Cube45_tc.mod").display().to_string();
    driftpost(&["compensate", CUBE, "-o", &out, "--diff", "none"]).assert().success();
    out
}

#[test]
fn a_compensated_cube_is_within_and_its_original_is_not() {
    let folder = tempfile::tempdir().unwrap();
    let program = compensated(folder.path());
    let csv = folder.path().join("passes.csv").display().to_string();
    let run = driftpost(&[
        "simulate",
        &program,
        "--original",
        CUBE,
        "--minutes",
        "0,7,37.5,180",
        "--json",
        "-",
        "--csv",
        &csv,
    ])
    .assert()
    .success();
    let json: Value = serde_json::from_slice(&run.get_output().stdout).unwrap();
    let minutes = json["minutes"].as_array().unwrap();
    assert_eq!(
        minutes.iter().map(|m| m["t_min"].as_f64().unwrap()).collect::<Vec<_>>(),
        [0.0, 7.0, 37.5, 180.0]
    );
    assert!(minutes.iter().all(|m| m["n"] == 46));
    assert!(minutes[3]["after"]["max_mm"].as_f64().unwrap() < 0.0055);
    // The reference paper's table leaves 0.174 mm at 180 minutes.
    assert!((minutes[3]["before"]["max_mm"].as_f64().unwrap() - 0.174).abs() < 0.0005);
    assert!(minutes[3]["path_after_mm"].as_f64().unwrap() < 0.01);
    // Minutes 0 and 7 lie in one bucket.
    assert_eq!(json["switches"].as_array().unwrap().len(), 2);
    assert_eq!(json["unknown_instructions"].as_array().unwrap().len(), 0);
    assert_eq!(std::fs::read_to_string(csv).unwrap().lines().count(), 5);
    // Not compensated: out of tolerance.
    driftpost(&["simulate", CUBE, "--minutes", "180"]).assert().code(1);
}

/// One move that goes to two places by turns, and 1,100 lines that the program writes: the 50 mm between the places are no jump of a bucket,
/// and what the report does not keep is counted.
#[test]
fn what_the_program_does_by_turns_is_no_jump_of_its_bucket() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).display().to_string();
    let source = "MODULE Turns
  CONST robtarget c10:=[[450,100,400],[0,0,1,0],[0,-1,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget c20:=[[450,150,400],[0,0,1,0],[0,-1,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  PERS num n:=0;
  PROC main()
    n:=n+1;
    MoveL c10,v100,fine,tool0;
    IF n MOD 2=0 THEN
      MoveL c10,v100,fine,tool0;
    ELSE
      MoveL c20,v100,fine,tool0;
    ENDIF
    FOR i FROM 1 TO 220 DO
      TPWrite \"part\";
    ENDFOR
  ENDPROC
ENDMODULE
";
    std::fs::write(at("turns.mod"), source).unwrap();
    driftpost(&["compensate", &at("turns.mod"), "-o", &at("tc.mod"), "--diff", "none"]).assert().success();
    let arguments =
        ["simulate", &at("tc.mod"), "--original", &at("turns.mod"), "--minutes", "0:40:10", "--json", "-"];
    let run = driftpost(&arguments).assert().success();
    let json: Value = serde_json::from_slice(&run.get_output().stdout).unwrap();
    let jumps: Vec<f64> =
        json["switches"].as_array().unwrap().iter().map(|s| s["jump_mm"].as_f64().unwrap()).collect();
    assert!(jumps.len() >= 2 && jumps.iter().all(|jump| *jump < 0.2), "{jumps:?}");
    assert!(jumps.iter().any(|jump| *jump > 0.001), "{jumps:?}");
    assert_eq!(json["messages"].as_array().unwrap().len(), 1000);
    assert_eq!(json["messages_dropped"], 100);
}

/// RobotWare 7 writes UTF-8, RobotWare 6 ISO 8859-1: a name is shown as it is read there.
#[test]
fn a_name_with_an_umlaut_is_shown_as_it_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let source = "MODULE Door
  CONST jointtarget jÖffnen:=[[0,10,20,0,50,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  PROC main()
    MoveAbsJ jÖffnen,v100,fine,tool0;
  ENDPROC
ENDMODULE
";
    let latin1: Vec<u8> = source.chars().map(|c| u8::try_from(c).unwrap()).collect();
    for (name, bytes) in [("door.modx", source.as_bytes()), ("door.mod", &latin1)] {
        let file = folder.path().join(name);
        std::fs::write(&file, bytes).unwrap();
        let run = driftpost(&["simulate", &file.display().to_string(), "--minutes", "60"]).output().unwrap();
        let text = String::from_utf8(run.stdout).unwrap();
        assert!(text.contains(&format!("{name}:4 jÖffnen ")), "{text}");
    }
}

/// Joint 1 of an IRB 140 ends at 180 deg: a line behind the robot cannot cross there, whatever joints reach its other end.
#[test]
fn a_line_that_takes_joint_1_over_its_end_is_not_gone() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("behind.mod");
    let source = "MODULE Behind
  CONST jointtarget jBehind:=[[170,0,0,0,90,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  VAR robtarget p;
  PROC main()
    ConfL\\Off;
    ConfJ\\Off;
    MoveAbsJ jBehind,v100,fine,tool0;
    p:=CRobT(\\Tool:=tool0\\WObj:=wobj0);
    MoveL Offs(p,0,SIDE,0),v100,fine,tool0;
  ENDPROC
ENDMODULE
";
    // Seen from above the wrist is 0.4 to 0.6 m behind axis 1 at 170 deg, 0.07 to 0.1 m to the side of 180.
    for (side, crosses) in [("-30", false), ("-220", true)] {
        std::fs::write(&file, source.replace("SIDE", side)).unwrap();
        let run = driftpost(&["simulate", &file.display().to_string(), "--minutes", "0"]).output().unwrap();
        let text = String::from_utf8_lossy(&run.stdout).into_owned() + &String::from_utf8_lossy(&run.stderr);
        assert_eq!(text.contains("end of its range on the way"), crosses, "{side}: {text}");
    }
}

#[test]
fn what_a_touch_moves_is_no_motion_of_the_program() {
    let folder = tempfile::tempdir().unwrap();
    let [source, out] =
        ["Cell.mod", "Cell_tc.mod"].map(|name| folder.path().join(name).display().to_string());
    let at = |y: i32, z: i32| {
        format!("[[400,{y},{z}],[0.70710678,0,0.70710678,0],[0,0,-1,1],[9E9,9E9,9E9,9E9,9E9,9E9]]")
    };
    let text = format!(
        "MODULE Cell\n  CONST robtarget pSphere:={};\n  PROC main()\n    MoveJ {},v500,fine,tool0;\n  ENDPROC\nENDMODULE\n",
        at(330, 200),
        at(300, 250)
    );
    std::fs::write(&source, text).unwrap();
    let touch = ["--touch", "S1=pSphere,tool0,wobj0", "--touch-signal", "diTouch", "--form", "ramp"];
    driftpost(&[&["compensate", &source, "-o", &out, "--diff", "none"], &touch[..]].concat())
        .assert()
        .success();
    let run = driftpost(&["simulate", &out, "--minutes", "0,60"]).assert().success();
    let text = String::from_utf8_lossy(&run.get_output().stdout).into_owned();
    assert!(text.starts_with("2 passes, 2 moves executed: 1 of the program's 1 motion (100 %)"), "{text}");
}

/// A target whose orientation is the same and whose axis 6 is a whole turn on is no correction.
#[test]
fn a_whole_turn_of_an_axis_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let [before, after] = ["before.mod", "after.mod"].map(|name| folder.path().join(name));
    let source = "MODULE Turn
  PROC main()
    MoveAbsJ [[10,0,0,0,30,-170],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0;
  ENDPROC
ENDMODULE
";
    std::fs::write(&before, source).unwrap();
    for (axis_6, reported) in [("-169.999", false), ("190", true)] {
        std::fs::write(&after, source.replace("-170", axis_6)).unwrap();
        let [a, b] = [&after, &before].map(|path| path.display().to_string());
        let args = ["simulate", &a, "--original", &b, "--minutes", "0"];
        let run = driftpost(&args).output().unwrap();
        let text = String::from_utf8_lossy(&run.stdout).into_owned() + &String::from_utf8_lossy(&run.stderr);
        let says =
            text.contains("joint 6 of") && text.contains("ends 360.0 deg from where the original has it");
        assert_eq!((says, run.status.code() == Some(1)), (reported, reported), "{axis_6}: {text}");
    }
}

#[test]
fn a_scenario_is_played() {
    let folder = tempfile::tempdir().unwrap();
    let program = compensated(folder.path());
    let file = folder.path().join("lunch.toml");
    std::fs::write(
        &file,
        "steps = [\"call tcColdStart\", \"run 20\", \"stand 45\", \"pp_to_main\", \"run 5\"]",
    )
    .unwrap();
    let scenario = file.display().to_string();
    let args =
        ["simulate", &program, "--original", CUBE, "--scenario", &scenario, "--tolerance-mm", "0.0065"];
    driftpost(&args).assert().success();
    std::fs::write(&file, "steps = [\"sleep 5\"]").unwrap();
    driftpost(&args).assert().code(2);
}

/// A cell that works while a signal is on and asks for it while it is not.
const POLLS: &str = "MODULE Cell
  CONST jointtarget home:=[[0,10,20,0,50,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST jointtarget there:=[[10,10,20,0,50,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  FUNC jointtarget asked(jointtarget j)
    RETURN j;
  ENDFUNC
  PROC main()
    WHILE TRUE DO
      IF DInput(di1)=1 THEN
        MoveAbsJ home,v500,fine,tool0;
        WaitTime 30;
        MoveAbsJ asked(there),v500,fine,tool0;
      ELSE
        WaitTime 1;
      ENDIF
    ENDWHILE
  ENDPROC
ENDMODULE
";

#[test]
fn what_warms_the_robot_is_an_option_and_a_field_of_the_scenario() {
    let folder = tempfile::tempdir().unwrap();
    let written = |name: &str, text: &str| {
        let path = folder.path().join(name);
        std::fs::write(&path, text).unwrap();
        path.display().to_string()
    };
    let cell = written("cell.mod", POLLS);
    let night =
        "steps = [\"signal di1 1\", \"run 90\", \"signal di1 0\", \"run 60\", \"signal di1 1\", \"pass\"]";
    let [plain, running] = ["", "warming = \"running\"\n"]
        .map(|head| written(&format!("night{}.toml", head.len()), &format!("{head}{night}")));
    let last = |options: &[&str]| {
        let args = [&["simulate", &cell, "--original", &cell, "--tolerance-mm", "1", "--json", "-"], options];
        let run = driftpost(&args.concat()).assert().success();
        let json: Value = serde_json::from_slice(&run.get_output().stdout).unwrap();
        let functions = json["functions"].as_array().unwrap().clone();
        assert_eq!((functions.len(), &functions[0]["name"]), (1, &Value::from("asked")));
        assert_eq!(functions[0]["statements"], serde_json::json!([1, 1]));
        let minutes = json["minutes"].as_array().unwrap();
        // Passes that only ask the signal are not listed.
        assert!(minutes.len() < 200 && minutes.iter().all(|m| m["n"] == 2), "{}", minutes.len());
        minutes.last().unwrap()["t_min"].as_f64().unwrap()
    };
    let warm = last(&["--scenario", &running]);
    assert!((warm - 150.0).abs() < 2.0, "{warm}");
    let cooled = last(&["--scenario", &plain]);
    // x1 = 0.859 and x2 = 0.582 after 90 minutes, x2 = 0.462 an hour later: as after 72 minutes.
    assert!((cooled - 72.0).abs() < 2.0, "{cooled}");
    assert_eq!(last(&["--scenario", &plain, "--warming", "running"]), warm);
    assert_eq!(last(&["--scenario", &running, "--warming", "moving"]), cooled);
    assert!((last(&["--scenario", &plain, "--gap-min", "90"]) - warm).abs() < 1e-6);
    for wrong in [&["--warming", "resting"][..], &["--gap-min", "0"], &["--gap-min", "nan"]] {
        driftpost(&[&["simulate", &cell, "--scenario", &plain], wrong].concat()).assert().code(2);
    }
}

#[test]
fn what_cannot_be_run_is_refused() {
    for args in [
        &["simulate", "nowhere.mod"][..],
        &["simulate", CUBE, "--entry", "Nobody"],
        &["simulate", CUBE, "--tolerance-mm", "0"],
        &["simulate", CUBE, "--robot", "irb9"],
        &["simulate", CUBE, "--minutes", "-1"],
    ] {
        driftpost(args).assert().code(2);
    }
}

/// What asks for more than the virtual controller holds is refused with the line, in memory that is no matter.
#[test]
fn what_the_controller_holds_no_more_of_is_refused_with_its_line() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("big.mod");
    let text = "MODULE M\n  VAR robtarget big{1000,1000};\n  PROC main()\n    big{1,1}.trans.x:=2;\n  ENDPROC\nENDMODULE\n";
    std::fs::write(&path, text).unwrap();
    let run = driftpost(&["simulate", &path.to_string_lossy(), "--robot", "irb140"]).assert().code(2);
    let message = String::from_utf8_lossy(&run.get_output().stderr).into_owned();
    assert!(
        message.contains("error[simulate::limit]") && message.contains("big.mod:4: with big"),
        "{message}"
    );
}

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
mod long {
    use super::*;

    /// An error handler that puts nothing right and tries again: it ends by the limit of steps, with the line.
    #[test]
    #[ignore = "long"]
    fn a_handler_that_retries_for_ever_comes_to_an_end() {
        let run = driftpost(&["simulate", "fixtures/simulate/retry_for_ever.mod", "--robot", "irb140"])
            .assert()
            .code(2);
        let message = String::from_utf8_lossy(&run.get_output().stderr).into_owned();
        assert!(message.contains("error[simulate::endless]"), "{message}");
        assert!(message.contains("retry_for_ever.mod:10: "), "{message}");
        assert!(message.contains("does not come to an end"), "{message}");
    }
}

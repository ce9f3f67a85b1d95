//! What hangs on the flange, by tool, GripLoad and option, where a model gives under it.

use super::model::{done, driftpost, json, path};

/// Gravity on joint 2 alone, found with up to 6 kg.
const SAG: &str = "format = 1\nrobot = \"ABB IRB 140-6/0.8\"\n[seen]\npayload_kg = [0.0, 6.0]\n[[effect]]\n\
                   effect = \"joint_compliance\"\njoint = 2\nrad_per_n_m = 0.00001\n";

fn gripping(first: &str, second: &str) -> String {
    let tool = "[TRUE,[[0,0,50],[1,0,0,0]],[2,[0,0,50],[1,0,0,0],0,0,0]]";
    let target = |x: f64| format!("[[{x},100,500],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]");
    format!(
        "MODULE Grips\n  PERS tooldata t:={tool};\n  PERS loaddata part:=[3,[0,0,0],[1,0,0,0],0,0,0];\n\
         \x20 CONST robtarget a:={};\n  CONST robtarget b:={};\n\
         \x20 PROC main()\n{first}    MoveJ a,v100,fine,t;\n{second}    MoveJ b,v100,fine,t;\n    GripLoad load0;\n  ENDPROC\nENDMODULE\n",
        target(450.0),
        target(500.0)
    )
}

#[test]
fn what_is_gripped_hangs_there_too() {
    let dir = tempfile::tempdir().unwrap();
    let at = |name: &str| path(dir.path(), name);
    std::fs::write(at("sag.toml"), SAG).unwrap();
    let corrections = |name: &str, text: &str, more: &[&str]| -> Vec<f64> {
        let (program, json_file) = (at(name), at("c.json"));
        std::fs::write(&program, text).unwrap();
        let model = at("sag.toml");
        let out = at("out.mod");
        let args =
            ["compensate", &program, "--model", &model, "-o", &out, "--diff", "none", "--json", &json_file];
        done(&[&args[..], more].concat());
        let reported = json(&json_file);
        reported["motions"]
            .as_array()
            .unwrap()
            .iter()
            .map(|m| m["max_correction_mm"].as_f64().unwrap())
            .collect()
    };
    let plain = corrections("plain.mod", &gripping("", ""), &[]);
    let gripped = corrections("grips.mod", &gripping("", "    GripLoad part;\n"), &[]);
    // The part's centre is the TCP, where the tool's is too: 2 and 3 kg are 5 kg there.
    let heavy = corrections("heavy.mod", &gripping("", ""), &["--payload-kg", "5"]);
    assert_eq!(gripped[0], plain[0]);
    assert_eq!(gripped[1], heavy[1]);
    assert!(heavy[1] > plain[1] + 0.01, "{heavy:?} {plain:?}");
    // The virtual controller's robot sags the same way.
    let simulated = driftpost(&[
        "simulate",
        &at("out.mod"),
        "--original",
        &at("heavy.mod"),
        "--model",
        &at("sag.toml"),
        "--minutes",
        "60",
    ]);
    assert_eq!(simulated.status.code(), Some(0), "the module says that 5 kg hang there");
    corrections("grips.mod", &gripping("", "    GripLoad part;\n"), &[]);
    let simulated = driftpost(&[
        "simulate",
        &at("out.mod"),
        "--original",
        &at("grips.mod"),
        "--model",
        &at("sag.toml"),
        "--minutes",
        "60",
    ]);
    assert_eq!(simulated.status.code(), Some(0), "{}", String::from_utf8_lossy(&simulated.stdout));
    // Either gripped or not: said with the motion's line, and the tool's own load is taken.
    std::fs::write(at("maybe.mod"), gripping("", "    IF DOutput(do1)=1 GripLoad part;\n")).unwrap();
    let output = driftpost(&[
        "compensate",
        &at("maybe.mod"),
        "--model",
        &at("sag.toml"),
        "-o",
        &at("m.mod"),
        "--diff",
        "none",
    ]);
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(
        output.status.success() && message.contains("model::gripload") && message.contains("line 9"),
        "{message}"
    );
}

/// A target that only run time knows in the place of the second one.
fn asking(text: &str) -> String {
    text.replace("MoveJ b,", "MoveL Offs(a,n,0,0),")
        .replace("PROC main()", "VAR num n:=30;\n  PROC main()\n    n:=n+GInput(gi1);")
}

#[test]
fn live_asks_for_the_tools_own_load_or_for_the_one_that_is_given() {
    let dir = tempfile::tempdir().unwrap();
    let at = |name: &str| path(dir.path(), name);
    std::fs::write(at("sag.toml"), SAG).unwrap();
    let (program, out, model, json_file) = (at("p.mod"), at("out.mod"), at("sag.toml"), at("s.json"));
    let run = |text: &str, more: &[&str]| {
        std::fs::write(&program, text).unwrap();
        let args =
            ["compensate", &program, "--model", &model, "--form", "live", "-o", &out, "--diff", "none"];
        let made = driftpost(&[&args[..], more].concat());
        assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr));
        let args = ["simulate", &out, "--original", &program, "--model", &model, "--minutes", "0"];
        let simulated = driftpost(&[&args[..], &["--json", &json_file]].concat());
        assert!(simulated.status.code().is_some_and(|code| code < 2), "{simulated:?}");
        let after_mm = json(&json_file)["minutes"][0]["after"]["max_mm"].as_f64().unwrap();
        (after_mm, String::from_utf8_lossy(&made.stderr).into_owned(), std::fs::read_to_string(&out).unwrap())
    };
    // Known targets: the one under the part takes its correction from the text, the other asks.
    let (after_mm, _, text) = run(&gripping("", "    GripLoad part;\n"), &[]);
    assert!(after_mm < 0.001, "{after_mm}");
    assert!(text.contains("MoveJ tcLive(a,") && text.contains("MoveJ tcAt(b,"), "{text}");
    let (after_mm, _, text) = run(&gripping("", ""), &["--payload-kg", "5"]);
    assert!(after_mm < 0.001 && text.contains("MoveJ tcLive(b,"), "{after_mm}");
    // What run time alone knows asks for the tool's own load, and that is said where something else hangs there.
    let (after_mm, said, _) = run(&asking(&gripping("", "    GripLoad part;\n")), &[]);
    assert!(said.contains("warning[model::live-load]: line 11:") && after_mm > 0.01, "{after_mm} {said}");
    let (after_mm, said, _) = run(&asking(&gripping("", "")), &[]);
    assert!(!said.contains("model::live-load") && after_mm < 0.001, "{after_mm} {said}");
}

/// `\TLoad` says what hangs there in one motion, in place of the tool's own load and of what is gripped: the virtual controller's robot sags so.
#[test]
fn the_total_load_of_a_motion_hangs_there_in_every_form() {
    let dir = tempfile::tempdir().unwrap();
    let at = |name: &str| path(dir.path(), name);
    std::fs::write(at("sag.toml"), SAG).unwrap();
    let (program, out, model, json_file) = (at("p.mod"), at("out.mod"), at("sag.toml"), at("s.json"));
    let with = |load: &str| {
        gripping("    GripLoad part;\n", "").replace("fine,t;", &format!("fine,t\\TLoad:={load};"))
    };
    let all = "PERS loaddata all:=[6,[0,0,120],[1,0,0,0],0,0,0];\n  PROC main()";
    let with_all = with("all").replace("PROC main()", all);
    let run = |text: &str, form: &str| {
        std::fs::write(&program, text).unwrap();
        let args = ["compensate", &program, "--model", &model, "--form", form, "-o", &out, "--diff", "none"];
        let made = driftpost(&args);
        assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr));
        let args = ["simulate", &out, "--original", &program, "--model", &model, "--minutes", "0"];
        let simulated = driftpost(&[&args[..], &["--json", &json_file]].concat());
        assert!(simulated.status.code().is_some_and(|code| code < 2), "{simulated:?}");
        let minute = json(&json_file)["minutes"][0].clone();
        let mm = |which: &str| minute[which]["max_mm"].as_f64().unwrap();
        let said = String::from_utf8_lossy(&made.stderr).into_owned();
        ([mm("before"), mm("after")], said, std::fs::read_to_string(&out).unwrap())
    };
    for form in ["schedule", "ramp", "live", "auto"] {
        let ([before_mm, after_mm], said, text) = run(&with_all, form);
        assert!(after_mm < 0.001 && before_mm > 0.05, "{form}: {before_mm} {after_mm}");
        assert!(!said.contains("model::live-load"), "{form}: {said}");
        assert!(!text.contains("MoveJ tcLive"), "{form}: {text}");
        // load0 counts as not given: then the part hangs there.
        let ([gripped_mm, after_mm], ..) = run(&with("load0"), form);
        assert!(
            after_mm < 0.001 && (gripped_mm - before_mm).abs() > 0.005,
            "{form}: {gripped_mm} {after_mm}"
        );
    }
    // What run time alone knows asks for the tool's own load.
    for form in ["live", "auto"] {
        let ([_, after_mm], said, _) = run(&asking(&with_all), form);
        assert!(
            said.contains("warning[model::live-load]: line 12:") && after_mm > 0.01,
            "{form}: {after_mm} {said}"
        );
    }
}

/// With a stationary tool the robot holds the work object, and the centre of what is gripped is given in its object frame: 50 mm before
/// the flange, as the gripper's own.
#[test]
fn what_is_gripped_before_a_stationary_tool_hangs_in_the_object_frame() {
    let dir = tempfile::tempdir().unwrap();
    let at = |name: &str| path(dir.path(), name);
    std::fs::write(at("sag.toml"), SAG).unwrap();
    let program = |grip: &str| {
        format!(
            "MODULE Held\n  PERS tooldata t:=[FALSE,[[500,100,500],[0,0,1,0]],[2,[0,0,50],[1,0,0,0],0,0,0]];\n  \
             PERS wobjdata w:=[TRUE,TRUE,\"\",[[0,0,30],[1,0,0,0]],[[0,0,20],[1,0,0,0]]];\n  \
             PERS loaddata part:=[3,[0,0,0],[1,0,0,0],0,0,0];\n  \
             CONST robtarget b:=[[0,0,0],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n  \
             PROC main()\n{grip}    MoveJ b,v100,fine,t\\WObj:=w;\n    GripLoad load0;\n  ENDPROC\nENDMODULE\n"
        )
    };
    let correction = |text: &str, more: &[&str]| {
        std::fs::write(at("p.mod"), text).unwrap();
        let (program, model, out, json_file) = (at("p.mod"), at("sag.toml"), at("out.mod"), at("c.json"));
        let args =
            ["compensate", &program, "--model", &model, "-o", &out, "--diff", "none", "--json", &json_file];
        done(&[&args[..], more].concat());
        json(&json_file)["motions"][0]["max_correction_mm"].as_f64().unwrap()
    };
    let empty = correction(&program(""), &[]);
    let heavy = correction(&program(""), &["--payload-kg", "5"]);
    let gripped = correction(&program("    GripLoad part;\n"), &[]);
    assert!(heavy > empty + 0.01 && (gripped - heavy).abs() < 1e-9, "{empty} {gripped} {heavy}");
    // The virtual controller hangs it there, too.
    let args = ["simulate", &at("out.mod"), "--original", &at("p.mod"), "--model", &at("sag.toml")];
    let simulated = driftpost(&[&args[..], &["--minutes", "0"]].concat());
    assert_eq!(simulated.status.code(), Some(0), "{}", String::from_utf8_lossy(&simulated.stdout));
}

//! `diff`: what a reviewer is told of two programs.

use super::{Bench, CUBE, driftpost, err, out};
use serde_json::Value;

fn compensated(bench: &Bench) -> String {
    let to = bench.path("tc.mod").display().to_string();
    assert!(driftpost(&["compensate", CUBE, "-o", &to, "--diff", "none"]).status.success());
    to
}

/// Numbers of the first bracketed triple of a line.
fn position(line: &str) -> [f64; 3] {
    let inner = line.trim_start_matches(|c| c != '[').trim_start_matches('[').split(']').next().unwrap();
    let numbers: Vec<f64> = inner.split(',').map(|n| n.trim().parse().unwrap()).collect();
    numbers.try_into().unwrap()
}

#[test]
fn a_compensated_program_differs_in_its_targets_alone() {
    let bench = Bench::default();
    let to = compensated(&bench);
    let output = driftpost(&["diff", CUBE, &to, "--json", "-"]);
    // Exit 0: nothing differs but what the comment block declares.
    assert_eq!(output.status.code(), Some(0));
    let json: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!((&json["same"], &json["same_elsewhere"]), (&Value::Bool(false), &Value::Bool(true)));
    let motions = json["motions"].as_array().unwrap();
    assert_eq!(motions.len(), 46);
    // The distance of the second motion's last element from its first, by the text of the array.
    let text = bench.text("tc.mod");
    let mut rows = text.lines().skip_while(|l| !l.contains("robtarget tc31{"));
    let rows: Vec<[f64; 3]> = rows.by_ref().skip(1).take_while(|l| l.contains("[[")).map(position).collect();
    let (first, last) = (rows[0], rows[rows.len() - 1]);
    let far = first.iter().zip(&last).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
    let buckets = motions[1]["buckets"].as_array().unwrap();
    assert_eq!(buckets.len(), rows.len());
    assert_eq!((&buckets[0]["index"], &buckets[0]["dp_mm"]), (&Value::Null, &Value::from(0.0)));
    let reported = buckets[buckets.len() - 1]["dp_mm"].as_f64().unwrap();
    assert!(far > 0.1 && (reported - far).abs() < 2e-5, "{reported} {far}");
    let worst = |key: &str| json["worst"][key].as_f64().unwrap();
    let most = motions.iter().flat_map(|m| m["buckets"].as_array().unwrap());
    let most = most.map(|b| b["dp_mm"].as_f64().unwrap()).fold(0.0, f64::max);
    assert!((worst("dp_mm") - most).abs() < 1e-12 && worst("limit_margin_deg") > 2.0);
    // At most twice the tolerance, and single precision.
    assert!((0.008..0.0101).contains(&worst("bucket_step_mm")), "{}", worst("bucket_step_mm"));
    assert_eq!(json["worst"]["same_configuration"], Value::Bool(true));
    for bucket in motions.iter().flat_map(|m| m["buckets"].as_array().unwrap()) {
        assert_eq!(
            (&bucket["same_branch"], &bucket["same_configuration"]),
            (&Value::Bool(true), &Value::Bool(true))
        );
        assert!(bucket["limit_margin_deg"].as_f64().unwrap() > 2.0);
    }
}

/// Only run time tells which element of the source a motion goes to: the rows of its array are no moments of one target.
#[test]
fn the_elements_of_the_source_are_not_taken_for_buckets() {
    for source in ["fixtures/simulate/runtime.mod", "fixtures/simulate/elements.mod"] {
        for form in ["schedule", "ramp", "auto"] {
            let bench = Bench::default();
            let to = bench.path("tc.mod").display().to_string();
            assert!(
                driftpost(&["compensate", source, "--form", form, "-o", &to, "--diff", "none"])
                    .status
                    .success()
            );
            let output = driftpost(&["diff", source, &to, "--json", "-"]);
            let json: Value = serde_json::from_slice(&output.stdout).unwrap();
            assert_eq!(json["same_elsewhere"], Value::Bool(true), "{source} {form}");
            let worst_mm = json["worst"]["dp_mm"].as_f64().unwrap();
            assert!((0.05..0.5).contains(&worst_mm), "{source} {form}: {worst_mm}");
        }
    }
}

/// Exit 0 is for an original and what was made of it, and for nothing else: a point that was moved in either is a difference.
#[test]
fn only_declared_targets_may_differ() {
    let original = std::fs::read_to_string(CUBE).unwrap();
    let moved = original.replacen("[[400.000, 300.000,", "[[400.000, 300.010,", 1);
    assert_ne!(moved, original);
    for (form, another) in [("schedule", "ramp"), ("ramp", "live"), ("live", "schedule")] {
        let bench = Bench::default();
        let to = bench.path("tc.mod").display().to_string();
        assert!(
            driftpost(&["compensate", CUBE, "-o", &to, "--diff", "none", "--form", form]).status.success()
        );
        let [plain, held, other] =
            ["moved.mod", "held.mod", "other.mod"].map(|name| bench.path(name).display().to_string());
        std::fs::write(&plain, &moved).unwrap();
        let exit = |a: &str, b: &str| driftpost(&["diff", a, b]).status.code();
        assert_eq!((exit(CUBE, &to), exit(&to, CUBE)), (Some(0), Some(0)), "{form}");
        // A target of the original, of the compensated one, and two plain programs.
        assert_eq!((exit(&plain, &to), exit(CUBE, &plain)), (Some(1), Some(1)), "{form}");
        std::fs::write(&held, bench.text("tc.mod").replacen("tcMode:=-1", "tcMode:=-2", 1)).unwrap();
        assert_eq!(exit(CUBE, &held), Some(1), "{form}");
        // Two that were made of one original: neither is what the other declares.
        let made = driftpost(&["compensate", CUBE, "-o", &other, "--diff", "none", "--form", another]);
        assert!(made.status.success());
        assert_eq!(exit(&to, &other), Some(1), "{form} {another}");
    }
}

#[test]
fn the_same_program_has_no_difference() {
    let bench = Bench::default();
    let to = compensated(&bench);
    for path in [CUBE, &to] {
        assert_eq!(driftpost(&["diff", path, path]).status.code(), Some(0), "{path}");
    }
}

#[test]
fn a_changed_speed_tool_or_move_is_told() {
    let bench = Bench::default();
    let to = compensated(&bench);
    let text = std::fs::read_to_string(&to).unwrap();
    let reported = |from: &str, by: &str| {
        let changed = text.replacen(from, by, 1);
        assert_ne!(changed, text, "{from}");
        let output = driftpost(&["diff", CUBE, &bench.file("changed.mod", changed)]);
        assert_eq!(output.status.code(), Some(1));
        out(&output)
    };
    let speed = reported("tc40{tcK()},rdkSpeed,z1", "tc40{tcK()},rdkSpeed,z5");
    assert!(
        speed.contains("Beside the targets the text differs, first at fixtures/robodk/irc5/Cube45.mod:40"),
        "{speed}"
    );
    let tool = reported("tc40{tcK()},rdkSpeed,z1,rdkTool", "tc40{tcK()},rdkSpeed,z1,tool0");
    assert!(tool.contains("1 with another instruction, tool or work object"), "{tool}");
    let dropped = reported("        MoveL tc40{tcK()}", "        ! MoveL tc40{tcK()}");
    assert!(dropped.contains("Only in the first program"), "{dropped}");
}

#[test]
fn a_ramp_is_told_by_its_settled_correction() {
    let bench = Bench::default();
    let schedule = compensated(&bench);
    let to = bench.path("ramp.mod").display().to_string();
    let made = driftpost(&["compensate", CUBE, "-o", &to, "--form", "ramp", "--diff", "none"]);
    assert!(made.status.success());
    let figures = |to: &str| {
        let output = driftpost(&["diff", CUBE, to, "--json", "-"]);
        let json: Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(output.status.code(), Some(if json["same_elsewhere"] == true { 0 } else { 1 }));
        (json["same_elsewhere"].clone(), json["motions"].as_array().unwrap().clone())
    };
    let ((same, ramp), (_, arrays)) = (figures(&to), figures(&schedule));
    assert_eq!((same, ramp.len()), (Value::Bool(true), 46));
    for (a, b) in ramp.iter().zip(&arrays) {
        let last = |m: &Value| m["buckets"].as_array().unwrap().last().unwrap()["dp_mm"].as_f64().unwrap();
        assert_eq!(a["buckets"].as_array().unwrap().len(), 2);
        // The last bucket is right a little before all has settled.
        assert!((0.96..1.0).contains(&(last(b) / last(a))), "{} {}", last(a), last(b));
    }
    let text = std::fs::read_to_string(&to).unwrap();
    let correction = text.lines().find(|l| l.contains("pose tc40:=")).unwrap();
    for (from, by) in
        [("tc40),rdkSpeed,z1", "tc40),rdkSpeed,z5"), (correction, &correction.replacen("[[0.", "[[0.9", 1))]
    {
        let edited = text.replacen(from, by, 1);
        assert_ne!(edited, text);
        assert_eq!(figures(&bench.file("edited.mod", edited)).0, Value::Bool(false), "{by}");
    }
}

/// The same corrections as in the form `ramp`, whose text holds them.
#[test]
fn what_the_model_corrects_at_run_time_is_told_by_its_settled_correction() {
    let bench = Bench::default();
    let reported = |form: &str| {
        let to = bench.path(&format!("{form}.mod")).display().to_string();
        let made = driftpost(&["compensate", CUBE, "-o", &to, "--form", form, "--diff", "none"]);
        assert!(made.status.success(), "{}", err(&made));
        let output = driftpost(&["diff", CUBE, &to, "--json", "-"]);
        assert_eq!(output.status.code(), Some(0));
        let json: Value = serde_json::from_slice(&output.stdout).unwrap();
        (out(&driftpost(&["diff", CUBE, &to])), json["motions"].as_array().unwrap().clone())
    };
    let ((text, live), (_, ramp)) = (reported("live"), reported("ramp"));
    assert!(text.contains("46 corrected by the model at run time, up to 0.19"), "{text}");
    for (a, b) in live.iter().zip(&ramp) {
        let settled =
            b["buckets"].as_array().unwrap().iter().map(|k| k["dp_mm"].as_f64().unwrap()).fold(0.0, f64::max);
        assert!((a["settled_mm"].as_f64().unwrap() - settled).abs() < 0.001, "{a} {b}");
        assert!(b["settled_mm"].is_null() && a["buckets"].as_array().unwrap().is_empty());
    }
}

/// An external axis that was touched up moves no tool: that is what is said, and no move by 0 deg.
#[test]
fn an_external_axis_that_was_touched_up_is_told_as_that() {
    let bench = Bench::default();
    let to = bench.path("tc.mod").display().to_string();
    assert!(driftpost(&["compensate", CUBE, "-o", &to, "--form", "live", "--diff", "none"]).status.success());
    let text = bench.text("tc.mod");
    let touched = text.replacen("[-1,-1,0,1],[9E+09,", "[-1,-1,0,1],[12.5,", 1);
    assert_ne!(touched, text);
    let touched = bench.file("touched.mod", touched);
    let restored = driftpost(&["restore", &touched, "-o", &bench.path("restored.mod").display().to_string()]);
    let message = err(&restored);
    assert_eq!(restored.status.code(), Some(1), "{message}");
    assert!(message.contains("in orientation, configuration or external axes alone"), "{message}");
    assert!(bench.text("restored.mod").contains("[12.5,"));
}

/// A target that the model is asked for, elsewhere than in the source: inline, in a declaration, a joint, a circle point.
#[test]
fn a_model_that_is_asked_for_another_target_is_told() {
    let bench = Bench::default();
    let source = concat!(env!("CARGO_MANIFEST_DIR"), "/fixtures/simulate/cell.mod");
    let to = bench.path("live.mod").display().to_string();
    let made = driftpost(&["compensate", source, "-o", &to, "--form", "live", "--diff", "none"]);
    assert!(made.status.success(), "{}", err(&made));
    let text = bench.text("live.mod");
    let compared = |text: &str| -> Value {
        let edited = bench.file("edited.mod", text);
        serde_json::from_slice(&driftpost(&["diff", source, &edited, "--json", "-"]).stdout).unwrap()
    };
    let whole = compared(&text);
    assert!(whole["motions"].as_array().unwrap().iter().all(|motion| motion["asked"].is_null()), "{whole}");
    for (from, by, distance_mm) in [
        ("pStart:=[[0,0,60]", "pStart:=[[0,0,160]", Some(100.0)),
        ("tcLive([[60,30,20]", "tcLive([[60,-10,50]", Some(50.0)),
        ("Offs(pStart,0,0,nLift),", "Offs(pStart,0,0,-nLift),", Some(30.0)),
        ("jHome:=[[0,10,20", "jHome:=[[30,10,20", None),
    ] {
        let edited = text.replacen(from, by, 1);
        assert_ne!(edited, text, "{from}");
        let json = compared(&edited);
        let motions = json["motions"].as_array().unwrap();
        let asked: Vec<f64> = motions.iter().filter_map(|motion| motion["asked"]["dp_mm"].as_f64()).collect();
        let most = asked.iter().copied().fold(0.0, f64::max);
        assert!(
            !asked.is_empty() && distance_mm.is_none_or(|mm| (most - mm).abs() < 1e-6),
            "{from}: {asked:?}"
        );
        // Axis 1 alone turns, by 30 deg.
        if distance_mm.is_none() {
            assert!((json["worst"]["joint_deg"].as_f64().unwrap() - 30.0).abs() < 1e-6, "{}", json["worst"]);
        }
    }
    // The motion goes with tGun, and so must the model be asked.
    let otherwise = text.replacen("tcLive(pStart,tGun", "tcLive(pStart,tProbe", 1);
    assert_ne!(otherwise, text);
    let json = compared(&otherwise);
    assert_eq!(json["same_elsewhere"], Value::Bool(false));
    assert!(json["elsewhere"][0].as_str().unwrap().contains("another tool or work object"), "{json}");
}

#[test]
fn three_touched_up_points_go_through_restore_and_a_new_run() {
    let bench = Bench::default();
    compensated(&bench);
    // ModPos on the controller changes element 1: half a millimetre up, for three targets.
    let mut text = bench.text("tc.mod");
    for line in ["tc35{", "tc48{", "tc60{"] {
        let array = text.find(&format!("robtarget {line}")).unwrap();
        let at = array + text[array..].find("[[").unwrap();
        let end = at + text[at..].find(']').unwrap();
        let [x, y, z] = position(&text[at..=end]);
        text.replace_range(at..end, &format!("[[{x},{y},{}", z + 0.5));
    }
    let touched = bench.file("touched.mod", &text);
    let restored = bench.path("restored.mod").display().to_string();
    assert_eq!(driftpost(&["restore", &touched, "-o", &restored]).status.code(), Some(1));
    let json: Value =
        serde_json::from_slice(&driftpost(&["diff", CUBE, &restored, "--json", "-"]).stdout).unwrap();
    assert_eq!(json["same_elsewhere"], Value::Bool(true));
    let moved: Vec<(u64, f64)> = json["motions"]
        .as_array()
        .unwrap()
        .iter()
        .map(|m| (m["line"].as_u64().unwrap(), m["buckets"][0]["dp_mm"].as_f64().unwrap()))
        .filter(|(_, dp)| *dp > 0.0)
        .collect();
    assert_eq!(moved.iter().map(|(line, _)| *line).collect::<Vec<_>>(), [35, 48, 60]);
    assert!(moved.iter().all(|(_, dp)| (dp - 0.5).abs() < 1e-4), "{moved:?}");
    let again = bench.path("again.mod").display().to_string();
    assert!(driftpost(&["compensate", &restored, "-o", &again, "--diff", "none"]).status.success());
    let run = |program: &str, original: &str| {
        driftpost(&["simulate", program, "--original", original, "--minutes", "0,37.5,120"]).status.code()
    };
    assert_eq!(run(&again, &restored), Some(0));
    // Until then the touched-up program runs the buckets of the old points.
    assert_eq!(run(&touched, CUBE), Some(0));
}

/// A compensated program in both cores, and where its clock stands.
fn with_clock(bench: &Bench, core: &str) -> (String, String) {
    let to = bench.path(&format!("{core}/Cube45.mod")).display().to_string();
    let made = driftpost(&["compensate", CUBE, "-o", &to, "--core", core, "--diff", "none"]);
    assert!(made.status.success(), "{}", err(&made));
    let clock =
        if core == "separate" { bench.path("separate/tcCore.mod").display().to_string() } else { to.clone() };
    (to, clock)
}

/// A folder with the original alone.
fn original_in(bench: &Bench, folder: &str) -> String {
    bench.file(&format!("{folder}/Cube45.mod"), std::fs::read(CUBE).unwrap());
    bench.path(folder).display().to_string()
}

#[test]
fn an_edit_of_what_was_added_is_told() {
    let bench = Bench::default();
    for core in ["embedded", "separate"] {
        let (to, clock) = with_clock(&bench, core);
        let program = bench.path(core).display().to_string();
        let original = original_in(&bench, &format!("original_{core}"));
        let elsewhere = || {
            let json = driftpost(&["diff", &original, &program, "--json", "-"]).stdout;
            let json: Value = serde_json::from_slice(&json).unwrap();
            (json["same_elsewhere"].as_bool().unwrap(), json["elsewhere"].to_string())
        };
        assert!(elsewhere().0, "{core}: {}", elsewhere().1);
        let text = std::fs::read_to_string(&clock).unwrap();
        // As a controller saves it: another layout, another spelling, PERS moved on.
        let saved = text
            .replace("RETURN 3600*tcNumber(", "RETURN 3600 * TCNUMBER(")
            .replace("PERS num tcMinute:=0;", "PERS num tcMinute:=61.5;");
        assert_ne!(saved, text);
        std::fs::write(&clock, &saved).unwrap();
        assert!(elsewhere().0, "{core}: {}", elsewhere().1);
        for (from, by, name) in [
            ("tcSec1-tcSec0", "tcSec1+tcSec0", "tcSpan"),
            ("VAR num tcI:=1;", "VAR num tcI:=2;", "tcI"),
            ("tcMode<>-2", "tcMode<>-3", "tcChoose"),
        ] {
            let edited = text.replacen(from, by, 1);
            assert_ne!(edited, text, "{from}");
            std::fs::write(&clock, edited).unwrap();
            let (same, message) = elsewhere();
            assert!(
                !same && message.contains(name) && message.contains("not as it was made"),
                "{core} {from}: {message}"
            );
        }
        std::fs::write(&clock, &text).unwrap();
        let module = std::fs::read_to_string(&to).unwrap();
        std::fs::write(&to, module.replacen("{tcK()}", "{3}", 1)).unwrap();
        assert!(!elsewhere().0, "{core}: {}", elsewhere().1);
    }
}

/// The operator went back to the original targets before the program was saved: no target differs, and yet nothing is corrected.
#[test]
fn a_clock_that_was_saved_switched_off_is_told() {
    let bench = Bench::default();
    for core in ["embedded", "separate"] {
        let (_, clock) = with_clock(&bench, core);
        let program = bench.path(core).display().to_string();
        let original = original_in(&bench, &format!("original_{core}"));
        let text = std::fs::read_to_string(&clock).unwrap();
        let told = |value: &str| {
            let saved = text.replacen("PERS num tcMode:=-1;", &format!("PERS num tcMode:={value};"), 1);
            std::fs::write(&clock, &saved).unwrap();
            let line = saved.lines().position(|line| line.contains(" tcMode:=")).unwrap() + 1;
            let shown = out(&driftpost(&["diff", &original, &program]));
            let of_it: Vec<String> =
                shown.lines().filter(|line| line.contains("until it is set")).map(str::to_owned).collect();
            assert!(of_it.iter().all(|of_it| of_it.starts_with(&format!("{clock}:{line}: "))), "{of_it:?}");
            (of_it, shown.contains("Every token that is not the target of a motion is the same in both."))
        };
        assert_eq!(told("-1"), (Vec::new(), true), "{core}");
        let (off, is_same) = told("-2");
        assert!(is_same && off.len() == 1 && off[0].contains("go to the original targets"), "{off:?}");
        let (held, _) = told("5");
        assert!(held.len() == 1 && held[0].contains("do not follow the warm-up"), "{held:?}");
    }
    let made = compensated(&bench);
    let off = std::fs::read_to_string(&made).unwrap().replacen("tcMode:=-1;", "tcMode:=-2;", 1);
    let off = bench.file("off.mod", off);
    let shown = out(&driftpost(&["diff", &made, &off]));
    assert!(shown.trim_end().ends_with("or for what a clock has stored."), "{shown}");
}

#[test]
fn what_restore_does_not_take_over_is_said() {
    let bench = Bench::default();
    compensated(&bench);
    let text = bench.text("tc.mod");
    let run = |name: &str, text: &str| {
        let file = bench.file(name, text);
        let to = bench.path(&format!("{name}.restored")).display().to_string();
        let output = driftpost(&["restore", &file, "-o", &to, "--json", "-"]);
        assert_ne!(output.status.code(), Some(2), "{}", err(&output));
        let json: Value = serde_json::from_slice(&output.stdout).unwrap();
        (err(&output), json["files"][0].clone(), std::fs::read(to).unwrap())
    };
    let (message, json, bytes) = run("as_made.mod", &text);
    assert!(!message.contains("warning") && bytes == std::fs::read(CUBE).unwrap(), "{message}");
    assert_eq!(json["altered"], Value::Array(Vec::new()));

    // Elements 3 and 5 of one target, as ModPos does while a bucket is in use: both a quarter of a millimetre up.
    let array = text.find("robtarget tc35{").unwrap();
    let mut lines: Vec<String> = text[array..].lines().map(str::to_owned).collect();
    for element in [3, 5] {
        let [x, y, z] = position(&lines[element]);
        let end = lines[element].find(']').unwrap();
        lines[element] = format!("        [[{x},{y},{}{}", z + 0.25, &lines[element][end..]);
    }
    let edited = format!("{}{}\n", &text[..array], lines.join("\n"));
    let (message, json, bytes) = run("elements.mod", &edited);
    assert!(message.contains("was touched up on the controller by 0.25"), "{message}");
    assert_eq!((&json["altered"], &json["exact"]), (&Value::Array(Vec::new()), &false.into()));
    let value = json["touched"][0]["value"].as_str().unwrap().to_owned();
    let [x, y, z] = position(&value);
    // The original is [400, -300, 250].
    assert!((x - 400.0).abs() < 1e-3 && (y + 300.0).abs() < 1e-3 && (z - 250.25).abs() < 1e-3, "{value}");
    assert!(String::from_utf8_lossy(&bytes).contains(&value));
    // Each otherwise: nobody can say which is meant.
    lines[5] = lines[5].replacen("[[", "[[1", 1);
    let file = bench.file("both.mod", format!("{}{}\n", &text[..array], lines.join("\n")));
    let output = driftpost(&["restore", &file, "-o", &bench.path("none.mod").display().to_string()]);
    assert_eq!(output.status.code(), Some(2));
    assert!(
        err(&output).contains("restore::disagree") && err(&output).contains("250.25"),
        "{}",
        err(&output)
    );
    assert!(!bench.path("none.mod").exists());

    // A comment line damaged or lost is no touched-up point.
    let check = text.lines().find(|l| l.contains("! driftpost targets: ")).unwrap();
    let at = text.find(check).unwrap() + check.len() - 4;
    let damaged =
        format!("{}{}{}", &text[..at], if &text[at..=at] == "A" { "B" } else { "A" }, &text[at + 1..]);
    for edited in [damaged, text.replacen(&format!("{check}\n"), "", 1)] {
        let (message, json, bytes) = run("header.mod", &edited);
        assert!(message.contains("comment block"), "{message}");
        assert!(!message.contains("was touched up"), "{message}");
        assert!(json["touched"].as_array().unwrap().is_empty() && bytes == std::fs::read(CUBE).unwrap());
    }
}

/// A program whose text leaves the wrist's branch open: its joints on the one branch, and by half turns of axes 4 and 6 on the other.
const OPEN: &str = "MODULE Part\n  PERS tooldata tA:=[TRUE,[[0,0,100],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]];\n  PROC main()\n    \
                    ConfJ\\Off;\n    MoveJ [[520,12,560],[0.5,0,0.8660254,0],[9,9,9,9],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tA;\n  \
                    ENDPROC\nENDMODULE\n";
const ONE_DEG: [f64; 6] = [1.822612, -10.794395, 20.357372, -4.509378, 20.507798, 5.136200];
const OTHER_DEG: [f64; 6] = [1.822612, -10.794395, 20.357372, 175.490622, -20.507798, -174.863800];

#[test]
fn a_hint_that_decided_the_branch_decides_it_for_the_reviewer_too() {
    let bench = Bench::default();
    let source = bench.file("part.mod", OPEN);
    // Next to its end of the IRB 140's ranges stands on the one branch axis 3 (50 deg), on the other axis 4 (200 deg).
    for (joints_deg, margin_deg) in [(ONE_DEG, 50.0 - ONE_DEG[2]), (OTHER_DEG, 200.0 - OTHER_DEG[3])] {
        let joints = joints_deg.map(|q| q.to_string()).join(",");
        let header = "file,line,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg";
        let hint = bench.file("hint.csv", format!("{header}\npart.mod,5,{joints}\n"));
        let to = bench.path("hinted_tc.mod").display().to_string();
        let made = ["compensate", &source, "--joints-hint", &hint, "--diff", "none", "--force", "-o", &to];
        let output = driftpost(&made);
        assert_eq!(output.status.code(), Some(0), "{}", err(&output));
        let output = driftpost(&["diff", &source, &to, "--joints-hint", &hint, "--json", "-"]);
        assert_eq!(output.status.code(), Some(0), "{}", err(&output));
        let json: Value = serde_json::from_slice(&output.stdout).unwrap();
        let first = &json["motions"][0]["buckets"][0];
        let reported = first["limit_margin_deg"].as_f64().unwrap();
        assert!((reported - margin_deg).abs() < 2e-6, "{reported} deg, by hand {margin_deg}");
    }
    let strange = bench
        .file("strange.csv", "file,line,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\npart.mod,2,0,0,0,0,0,0\n");
    let output = driftpost(&["diff", &source, &source, "--joints-hint", &strange]);
    assert_eq!(output.status.code(), Some(2));
    assert!(err(&output).contains("hint::line"), "{}", err(&output));
}

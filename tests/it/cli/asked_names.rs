//! What an emitted module asks by name: nothing twice that may answer otherwise, and nothing that it does not see.

use super::{Bench, driftpost, err};

const TOOL: &str = "[TRUE,[[0,0,90],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]]";
const P1: &str = "[[450,-100,300],[0,0,1,0],[-1,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]]";

fn compensated(bench: &Bench, source: &str, options: &[&str]) -> (Option<i32>, String) {
    let source = bench.file("m.mod", source);
    let to = bench.path("out").display().to_string();
    std::fs::create_dir_all(&to).unwrap();
    let output = driftpost(&[&["compensate", &source, "-o", &to, "--diff", "none"][..], options].concat());
    (output.status.code(), err(&output))
}

/// The tool of each motion is the next one of an array: asked twice, every other one would be passed over.
#[test]
fn a_function_in_a_tool_is_asked_once() {
    let bench = Bench::default();
    let source = format!(
        "MODULE m\n  VAR num n:=0;\n  PERS tooldata aT{{2}}:=[{TOOL},{TOOL}];\n  CONST robtarget p1:={P1};\n  \
         CONST jointtarget j1:=[[10,20,-10,30,40,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n  FUNC num Next()\n    n:=n MOD 2+1;\n    RETURN n;\n  \
         ENDFUNC\n  PROC main()\n    MoveL p1,v100,fine,tool0;\n    MoveAbsJ j1,v100,fine,aT{{Next()}};\n  ENDPROC\nENDMODULE\n"
    );
    let (code, message) = compensated(&bench, &source, &["--form", "live"]);
    assert_eq!(code, Some(0), "{message}");
    let text = bench.text("out/m_tc.mod");
    let motion = text.lines().find(|line| line.contains("MoveAbsJ") && line.contains("aT{")).unwrap();
    assert!(motion.matches("Next()").count() == 1 && motion.contains("tcAtJ"), "{motion}");
}

/// The common module tests the model at targets of the program, and does not see what is LOCAL to one of its modules.
#[test]
fn the_self_test_of_a_common_module_names_no_local_data() {
    let bench = Bench::default();
    let source = format!(
        "MODULE m\n  LOCAL PERS tooldata tLoc:={TOOL};\n  PERS tooldata tAll:={TOOL};\n  CONST robtarget p1:={P1};\n  PROC main()\n    \
         MoveL p1,v100,fine,tLoc;\n    MoveL p1,v100,fine,tAll;\n  ENDPROC\nENDMODULE\n"
    );
    let options = ["--form", "live", "--core", "separate", "--self-test"];
    let (code, message) = compensated(&bench, &source, &options);
    assert_eq!(code, Some(0), "{message}");
    let core = bench.text("out/tcCore.mod");
    assert!(core.contains("tAll") && !core.contains("tLoc"), "{core}");
}

/// Parameters and data of a routine are not seen by another: with nothing else there is no test, and that is said.
#[test]
fn the_self_test_names_no_parameters() {
    let bench = Bench::default();
    let source = format!(
        "MODULE m\n  PERS tooldata tAll:={TOOL};\n  CONST robtarget p1:={P1};\n  PROC go(PERS tooldata tX)\n    MoveL p1,v100,fine,tX;\n  \
         ENDPROC\n  PROC main()\n    go tAll;\n    {{MORE}}\n  ENDPROC\nENDMODULE\n"
    );
    let (code, message) =
        compensated(&bench, &source.replace("{MORE}", ""), &["--form", "live", "--self-test"]);
    assert!(code == Some(0) && message.contains("emit::no-self-test"), "{message}");
    let more = source.replace("{MORE}", "MoveL p1,v100,fine,tAll;");
    let (code, message) = compensated(&bench, &more, &["--form", "live", "--self-test"]);
    assert_eq!(code, Some(0), "{message}");
    let text = bench.text("out/m_tc.mod");
    let tests: Vec<&str> = text.lines().filter(|line| line.trim_start().starts_with("tcTest ")).collect();
    assert!(!tests.is_empty() && tests.iter().all(|line| line.ends_with("tAll;")), "{tests:?}");
}

/// Force control and the soft servo are two, and each ends by its own; what the robot runs by is not written by EGM, and a target that makes a
/// frame is kept whatever else it is made of.
#[test]
fn what_holds_a_motion_is_ended_by_its_own_and_nothing_else() {
    let kept = |body: &str| {
        let bench = Bench::default();
        let source = format!(
            "MODULE m\n  PERS tooldata tT:={TOOL};\n  CONST robtarget pA:={P1};\n  PERS robtarget pB:={P1};\n  PERS robtarget pC:={P1};\n  \
             PERS wobjdata wA:=[FALSE,TRUE,\"\",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];\n  VAR num n:=0;\n  VAR egmident egm1;\n  PROC main()\n{}\n  \
             ENDPROC\nENDMODULE\n",
            body.split(';')
                .filter(|stmt| !stmt.is_empty())
                .map(|stmt| format!("    {stmt};\n"))
                .collect::<String>()
        );
        let file = bench.file("m.mod", source);
        let output = driftpost(&["inspect", &file, "--format", "json"]);
        let found: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        let motions = found["motions"].as_array().unwrap().iter();
        motions.map(|motion| motion["code"].as_str().unwrap_or_default().to_owned()).collect::<Vec<String>>()
    };
    let first = "MoveAbsJ [[10,20,-10,30,40,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tT;";
    let soft = "keep::soft-servo";
    let by_force = kept(&format!(
        "{first}FCAct tT;SoftAct 3,20;SoftDeact;MoveL pA,v100,fine,tT;FCDeact;MoveL pA,v100,fine,tT;"
    ));
    assert_eq!(by_force, ["", soft, ""]);
    let by_css = kept(&format!(
        "{first}CSSAct CSS_X;MoveL pA,v100,fine,tT;CSSDeactMoveL pA,v100,tT;MoveL pA,v100,fine,tT;"
    ));
    assert_eq!((&*by_css[1], &*by_css[3]), (soft, ""), "{by_css:?}");
    let by_egm = kept(&format!("{first}EGMActMove egm1,tT.tframe;MoveL pA,v100,fine,tT;"));
    assert_eq!(by_egm, ["", ""]);
    let frame = "wA.uframe:=DefFrame(pB,pA,pA);IF pC.trans.x>3 n:=1;";
    for target in ["Offs(pB,0,0,0)", "Offs(pB,pC.trans.x-450,0,0)"] {
        let by_frame = kept(&format!("{first}{frame}MoveL {target},v100,fine,tT;"));
        assert_eq!(by_frame[1], "keep::calibration", "{target}");
    }
}

/// A comment before the module is an item of its file, and no module.
#[test]
fn a_touch_with_a_local_tool_is_seen_from_its_module_whatever_stands_before_it() {
    let source = format!(
        "MODULE m\n  LOCAL PERS tooldata tLoc:={TOOL};\n  CONST robtarget p1:={P1};\n  PROC main()\n    MoveL p1,v100,fine,tLoc;\n  ENDPROC\nENDMODULE\n"
    );
    let touch = ["--touch", "S1=p1,tLoc,wobj0", "--touch-signal", "diProbe"];
    for before in ["", "! of the cell\n", "! of the cell\n! and its maker\n"] {
        let bench = Bench::default();
        let (code, message) = compensated(&bench, &format!("{before}{source}"), &touch);
        assert_eq!(code, Some(0), "{before:?}: {message}");
    }
}

/// A program that shows the bucket, and goes over to a form that has none: the module would not load.
#[test]
fn names_that_another_form_writes_are_told() {
    let bench = Bench::default();
    let source = format!(
        "MODULE m\n  PERS tooldata tAll:={TOOL};\n  CONST robtarget p1:={P1};\n  PROC main()\n    tcColdStart;\n    \
         TPWrite \"tcTau \"\\Num:=tcBucket; ! tcDegrees\n    MoveL p1,v100,fine,tAll;\n  ENDPROC\nENDMODULE\n"
    );
    for (form, asked, told) in
        [("schedule", "tcBucket", false), ("ramp", "tcBucket", true), ("schedule", "tcTouchSaid", true)]
    {
        let (code, message) =
            compensated(&bench, &source.replace("tcBucket", asked), &["--form", form, "--force"]);
        assert_eq!(code, Some(0), "{message}");
        let all: Vec<&str> =
            message.split("warning[").filter(|one| one.starts_with("emit::not-written")).collect();
        let is_told = |one: &&str| one.contains(asked) && one.contains("m.mod:6:27");
        assert!(all.len() == usize::from(told) && all.iter().all(is_told), "{form}, {asked}: {message}");
    }
}

/// A program that has our names itself, those that this form or clock does not write among them.
#[test]
fn a_program_may_have_all_names_that_others_ask_for() {
    const NAMES: &str = "tcColdStart tcWarmStart tcStartAt tcUpdate tcTeach tcSelfTest tcMode tcBucket tcShare tcMinute tcDegrees \
                         tcTouch tcTouchAge tcTouchSigma tcTouchSaid tcAmount tcTau tcTauCool tcLogFile";
    let each = |declared: &dyn Fn(&str) -> String| NAMES.split(' ').map(declared).collect::<String>();
    let variables = each(&|name| format!("  VAR num {name}:=0;\n"));
    let routines = each(&|name| format!("  PROC {name}()\n  ENDPROC\n"));
    let locals = variables.replace("VAR", "  VAR");
    for (data, local, behind) in [(&*variables, "", ""), ("", "", &*routines), ("", &*locals, "")] {
        let source = format!(
            "MODULE m\n  PERS tooldata tAll:={TOOL};\n  CONST robtarget p1:={P1};\n{data}  PROC main()\n    MoveL p1,v100,fine,tAll;\n  \
             ENDPROC\n  PROC rOwn()\n{local}    WaitTime 1;\n  ENDPROC\n{behind}ENDMODULE\n"
        );
        let by_temperature =
            ["--clock", "signal:aiTemp", "--deformation", "fixtures/first_run/temperature.csv"];
        for options in [
            &["--form", "schedule"][..],
            &["--form", "ramp"],
            &["--form", "live"],
            &["--form", "auto"],
            &["--clock", "elapsed"],
            &by_temperature,
        ] {
            let bench = Bench::default();
            let (code, message) = compensated(&bench, &source, options);
            assert_eq!(code, Some(0), "{options:?}: {message}");
            assert!(!message.contains("emit::not-written"), "{options:?}: {message}");
            let [made, back] =
                ["out/m_tc.mod", "back.mod"].map(|name| bench.path(name).display().to_string());
            let restored = driftpost(&["restore", &made, "-o", &back]);
            assert!(
                restored.status.code() == Some(0) && bench.text("back.mod") == source,
                "{options:?}: {}",
                err(&restored)
            );
        }
    }
}

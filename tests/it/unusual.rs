//! Programs of unusual but valid shapes, corrected and executed: each motion goes where it should, or is kept with its reason.

use assert_cmd::Command;
use serde_json::Value;
use std::path::Path;

const HEAD: &str = "MODULE Cell
  CONST robtarget pA:=[[400,100,400],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget pB:=[[450,-100,350],[0,0,1,0],[-1,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget pC:=[[380,50,300],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST jointtarget jh:=[[0,0,0,0,90,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n";

/// A program corrected in a form and executed.
struct Made {
    /// Of each motion: status, and why it is kept.
    motions: Vec<(String, String)>,
    /// What is left at most at the motions that are corrected, mm.
    corrected_mm: f64,
    /// Lines that the program wrote.
    messages: Vec<String>,
}

fn driftpost(folder: &Path, args: &[&str]) -> Value {
    let run = Command::cargo_bin("driftpost").unwrap().current_dir(folder).args(args).output().unwrap();
    serde_json::from_slice(&run.stdout)
        .unwrap_or_else(|_| panic!("{args:?}: {}", String::from_utf8_lossy(&run.stderr)))
}

fn made(form: &str, body: &str) -> Made {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("Cell.mod"), format!("{HEAD}{body}ENDMODULE\n")).unwrap();
    let args = ["compensate", "Cell.mod", "--form", form, "-o", "out.mod", "--json", "-"];
    let review = driftpost(folder.path(), &args);
    let motion = |m: &Value| {
        (m["status"].as_str().unwrap().to_owned(), m["reason"].as_str().unwrap_or_default().to_owned())
    };
    let args = ["simulate", "out.mod", "--original", "Cell.mod", "--minutes", "0,37,240", "--json", "-"];
    let report = driftpost(folder.path(), &args);
    let minutes = report["minutes"].as_array().unwrap();
    for minute in minutes {
        assert!(minute["failure"].is_null() && minute["mismatch"].is_null(), "{form}: {minute}");
    }
    let worst = minutes.iter().filter_map(|m| m["corrected"]["max_mm"].as_f64());
    let said = report["messages"].as_array().unwrap().iter().filter(|m| m["source"] == "TPWrite");
    Made {
        motions: review["motions"].as_array().unwrap().iter().map(motion).collect(),
        corrected_mm: worst.fold(0.0, f64::max),
        messages: said.filter_map(|m| m["text"].as_str().map(str::to_owned)).collect(),
    }
}

#[test]
fn a_clock_under_another_name_is_the_one_that_is_started() {
    let body = "  PERS num tcMode:=7;
  PROC main()
    MoveAbsJ jh,v100,fine,tool0;
    MoveL pA,v100,fine,tool0;
  ENDPROC
  PROC tcColdStart()
    TPWrite \"mine\";
  ENDPROC
  PROC tcUpdate()
    TPWrite \"mine too\";
  ENDPROC\n";
    for form in ["schedule", "ramp"] {
        let made = made(form, body);
        assert!(made.corrected_mm < 0.0055, "{form}: {}", made.corrected_mm);
        assert_eq!(made.messages, Vec::<String>::new(), "{form}");
    }
}

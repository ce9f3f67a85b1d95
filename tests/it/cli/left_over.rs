//! What an earlier run left in the folder of a result.

use super::{Bench, driftpost, err};
use std::fs;

const TOOL: &str = "[TRUE,[[0,0,90],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]]";

fn module(name: &str, tool: &str, z: i32) -> String {
    format!(
        "MODULE {name}\n  PERS tooldata {tool}:={TOOL};\n  LOCAL CONST robtarget p1:=[[450,-100,{z}],[0,0,1,0],[-1,0,-1,0],\
         [9E9,9E9,9E9,9E9,9E9,9E9]];\n  PROC r{name}()\n    MoveL p1,v100,fine,{tool};\n  ENDPROC\nENDMODULE\n"
    )
}

fn compensated(bench: &Bench) -> (Option<i32>, String) {
    let [from, to] = ["s", "c"].map(|folder| bench.path(folder).display().to_string());
    let output = driftpost(&["compensate", &from, "-o", &to, "--form", "ramp", "--diff", "none"]);
    (output.status.code(), err(&output))
}

/// How often a message is said of a file.
fn told(text: &str, file: &str) -> usize {
    let messages = text.split("warning[").filter(|message| message.starts_with("output::left-over"));
    messages.filter(|message| message.contains(&format!("{file} is left"))).count()
}

#[test]
fn a_module_that_is_in_another_file_now_is_told() {
    let bench = Bench::default();
    bench.file("s/A.mod", module("A", "tA", 300));
    bench.file("s/B.sys", module("B", "tB", 310).replace("MODULE B\n", "MODULE B(SYSMODULE)\n"));
    bench.file("s/Data.mod", "MODULE Data\n  CONST num n:=1;\nENDMODULE\n");
    let (code, text) = compensated(&bench);
    assert!(code == Some(0) && !text.contains("left-over"), "{text}");
    // Once more the same: nothing is left.
    let (code, text) = compensated(&bench);
    assert!(code == Some(0) && !text.contains("left-over"), "{text}");
    fs::rename(bench.path("s/B.sys"), bench.path("s/B.mod")).unwrap();
    bench.file("s/B.mod", module("B", "tB", 310));
    fs::rename(bench.path("s/Data.mod"), bench.path("s/Values.mod")).unwrap();
    let (code, text) = compensated(&bench);
    assert_eq!(code, Some(0), "{text}");
    for (file, times) in
        [("B.sys", 1), ("Data.mod", 1), ("tcCore.sys", 1), ("A.mod", 0), ("B.mod", 0), ("tcCore.mod", 0)]
    {
        assert_eq!(told(&text, file), times, "{file}: {text}");
    }
    for file in ["B.sys", "Data.mod", "tcCore.sys"] {
        fs::remove_file(bench.path("c").join(file)).unwrap();
    }
    let (code, text) = compensated(&bench);
    assert!(code == Some(0) && !text.contains("left-over"), "{text}");
}

/// Modules of one name in two tasks are two modules.
#[test]
fn a_file_of_somebody_elses_is_not_left_over() {
    let bench = Bench::default();
    bench.file("s/A.mod", module("A", "tA", 300));
    bench.file("s/B.mod", module("B", "tB", 310));
    bench.file("c/old/B.mod", module("B", "tB", 310));
    let (code, text) = compensated(&bench);
    assert!(code == Some(0) && !text.contains("left-over"), "{text}");
}

#[test]
fn a_module_that_left_the_program_is_to_be_deleted() {
    let bench = Bench::default();
    bench.file("s/A.mod", module("A", "tA", 300));
    bench.file("s/B.mod", module("B", "tB", 310));
    bench.file("s/C.mod", module("C", "tC", 320));
    assert_eq!(compensated(&bench).0, Some(0));
    fs::remove_file(bench.path("s/C.mod")).unwrap();
    bench.file("s/A.mod", module("A", "tA", 290));
    let (code, text) = compensated(&bench);
    assert!(
        code == Some(2) && text.contains("output::other-core") && text.contains("is to be deleted"),
        "{text}"
    );
    fs::remove_file(bench.path("c/C.mod")).unwrap();
    let (code, text) = compensated(&bench);
    assert_eq!(code, Some(0), "{text}");
}

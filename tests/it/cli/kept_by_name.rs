//! What `--keep` and `--only` name: targets, also those that an expression is made of.

use super::{Bench, driftpost, err};

/// The lines of `rPick` in the result, of a program whose first motion goes to `p0`.
fn motions(options: &[&str]) -> (Option<i32>, String, Vec<String>) {
    let bench = Bench::default();
    let p = |z: i32| format!("[[450,-100,{z}],[0,0,1,0],[-1,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]]");
    let source = bench.file(
        "m.mod",
        format!(
            "MODULE m\n  PERS tooldata tT:=[TRUE,[[0,0,90],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]];\n  CONST robtarget p0:={};\n  \
             CONST robtarget q1:={};\n  CONST robtarget pR{{2}}:=[{},{}];\n  CONST num nUp:=20;\n  PROC main()\n    \
             MoveL p0,v100,fine,tT;\n    FOR i FROM 1 TO 2 DO\n      MoveL pR{{i}},v100,fine,tT;\n      \
             MoveL Offs(pR{{ i }},0,0,20),v100,fine,tT;\n    ENDFOR\n    MoveL Offs(q1,0,0,nUp),v100,fine,tT;\n  ENDPROC\nENDMODULE\n",
            p(300),
            p(310),
            p(320),
            p(330)
        ),
    );
    let to = bench.path("m_tc.mod").display().to_string();
    let output = driftpost(
        &[&["compensate", &source, "-o", &to, "--form", "ramp", "--diff", "none"][..], options].concat(),
    );
    let text = std::fs::read_to_string(&to).unwrap_or_default();
    let moves =
        text.lines().map(str::trim).filter(|line| line.starts_with("MoveL ")).map(str::to_owned).collect();
    (output.status.code(), err(&output), moves)
}

/// Which of the four motions ask for a corrected target.
fn corrected(options: &[&str]) -> Vec<bool> {
    let (code, text, moves) = motions(options);
    assert_eq!((code, moves.len()), (Some(0), 4), "{options:?}: {text}");
    moves.iter().map(|line| line.contains("tc")).collect()
}

#[test]
fn an_array_is_named_by_its_name_by_a_pattern_and_as_it_is_written() {
    assert_eq!(corrected(&[]), [true; 4]);
    for name in ["pR", "PR", "pR*"] {
        assert_eq!(corrected(&["--keep", name]), [true, false, false, true], "{name}");
        assert_eq!(corrected(&["--only", name]), [false, true, true, false], "{name}");
    }
    assert_eq!(corrected(&["--keep", "pR{i}"]), [true, false, true, true]);
    assert_eq!(corrected(&["--keep", "p*"]), [false, false, false, true]);
}

#[test]
fn a_target_is_kept_in_expressions_too_and_what_is_no_target_names_nothing() {
    assert_eq!(corrected(&["--keep", "q1"]), [true, true, true, false]);
    for name in ["nUp", "i", "Offs", "pR{1}"] {
        let (code, text, _) = motions(&["--keep", name]);
        assert!(code == Some(2) && text.contains("option::names-nothing"), "{name}: {text}");
    }
    let (_, text, _) = motions(&["--keep", "pX"]);
    assert!(text.contains("pR"), "{text}");
}

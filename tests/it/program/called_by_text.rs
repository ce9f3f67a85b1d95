//! Procedures that are called by a text: which of them, where the text tells, and where only a running controller knows.

use super::{at, codes, module, tool, tools_mm};
use rapid_program::Program;

/// A program that sets its tool in one of two procedures, by the text of a datum.
fn program(data: &str, call: &str) -> Program {
    module(&format!(
        "{data}\nPERS tooldata t:={};\nCONST robtarget p:={};\nPROC main()\nt:={};\n{call};\nMoveL p,v100,fine,t;\nENDPROC\n\
         PROC rA1()\nt:={};\nENDPROC\nPROC rB1()\nt:={};\nENDPROC\nPROC rC()\nTPWrite \"x\";\nENDPROC",
        tool(1),
        at(5, 5, 5),
        tool(2),
        tool(3),
        tool(4)
    ))
}

#[test]
fn a_text_that_nobody_can_set_tells_which_is_called() {
    for (data, call) in [
        ("VAR string s:=\"rB1\";", "%s%"),
        ("CONST string s:=\"rB1\";", "%s%"),
        ("CONST string s:=\"rB\";", "%s+\"1\"%"),
        ("RECORD job\nstring nm;\nnum k;\nENDRECORD\nCONST job j:=[\"rB1\",1];", "%j.nm%"),
    ] {
        assert_eq!(tools_mm(&program(data, call)), [Some(4)], "{data} {call}");
    }
    // Nothing tells that there is one of that name: it is called or not.
    assert_eq!(codes(&program("CONST string s:=\"rB\";", "CallByVar s,1")), ["keep::tool-unknown"]);
    assert_eq!(tools_mm(&program("CONST string s:=\"rC\";", "CallByVar s,1")), [Some(2)]);
}

/// A pendant, an operator panel or another task may have set it since: any procedure that it can name may be called.
#[test]
fn a_pers_in_the_text_leaves_open_which_is_called() {
    let record = "RECORD job\nstring nm;\nnum k;\nENDRECORD\n";
    for (data, call) in [
        ("PERS string s:=\"rC\";", "%s%"),
        ("PERS string s:=\"rC\";", "%\"r\"+s%"),
        ("PERS string s{2}:=[\"rC\",\"rC\"];", "%s{2}%"),
        (&*format!("{record}PERS job j:=[\"rC\",1];"), "%j.nm%"),
        (&*format!("{record}PERS job j{{2}}:=[[\"rC\",1],[\"rC\",1]];"), "%j{1}.nm%"),
        ("PERS num n:=1;\nCONST string s{2}:=[\"rC\",\"rB1\"];", "%s{n}%"),
        ("PERS string s:=\"rA\";", "CallByVar s,1"),
    ] {
        assert_eq!(codes(&program(data, call)), ["keep::tool-unknown"], "{data} {call}");
    }
    // What stands before and behind it counts.
    assert_eq!(tools_mm(&program("PERS string s:=\"C\";", "%\"x\"+s%")), [Some(2)]);
    assert_eq!(tools_mm(&program("PERS string s:=\"r\";\nCONST string c:=\"C\";", "%s+c%")), [Some(2)]);
    assert_eq!(tools_mm(&program("PERS string s:=\"B\";", "CallByVar \"x\"+s,1")), [Some(2)]);
}

/// What a move calls in its corner is looked for like what a statement calls.
#[test]
fn a_procedure_that_a_move_calls_and_nobody_gives_is_named() {
    let found = |called: &str| {
        let data = format!(
            "CONST robtarget p:={};\nCONST string sStart:=\"rMis\";\nPERS string sSet:=\"rMissing\";",
            at(5, 5, 5)
        );
        let read = module(&format!(
            "{data}\nPROC main()\nMoveLSync p,v100,z10,tool0,{called};\nENDPROC\nPROC rGiven()\nENDPROC"
        ));
        super::warnings(&read).into_iter().filter(|code| *code == "resolve::routine-not-given").count()
    };
    for (called, named) in
        [("\"rMissing\"", 1), ("sStart+\"sing\"", 1), ("\"rGiven\"", 0), ("\"RGIVEN\"", 0), ("sSet", 0)]
    {
        assert_eq!(found(called), named, "{called}");
    }
}

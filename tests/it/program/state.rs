//! Tool, work object and what else is in force, followed through the program.

use super::{at, because_line, code, codes, main_of, module, program, tool, tools_mm, warnings};
use rapid_program::Program;

pub(super) fn data() -> String {
    format!(
        "PERS tooldata t:={};\nPERS wobjdata w:=[FALSE,TRUE,\"\",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];
CONST robtarget p:={};",
        tool(1),
        at(5, 5, 5)
    )
}

pub(super) const MOVE: &str = "MoveL p,v100,fine,t\\WObj:=w;\n";

#[test]
fn assignments_count_from_their_line_on() {
    let body = format!(
        "{MOVE}t:={};\n{MOVE}t.tframe:=[[3,0,0],[1,0,0,0]];\n{MOVE}t.tframe.trans.x:=4;\n{MOVE}w.uframe.trans:=[0,0,10];\n{MOVE}",
        tool(2)
    );
    let read = main_of(&data(), &body);
    assert_eq!(tools_mm(&read), [Some(1), Some(2), Some(3), Some(4), Some(4)]);
    assert_eq!(read.motions[4].setup.wobj.as_ref().unwrap().uframe.translation.z, 0.01);
    assert_eq!(read.motions[3].setup.wobj.as_ref().unwrap().uframe.translation.z, 0.0);
    // Both are used before the program sets them: a PERS remembers the last run.
    assert_eq!(warnings(&read), ["state::pers-kept"; 2]);
}

/// Nothing changes the tool: each call hands over its own.
#[test]
fn a_parameter_that_is_handed_different_tools_is_called_that() {
    let text = format!(
        "{}PERS tooldata u:={};\nPROC main()\ngo t;\ngo u;\nENDPROC\nPROC go(PERS tooldata h)\nMoveL p,v100,fine,h;\nENDPROC",
        data(),
        tool(2)
    );
    let read = module(&text);
    let why = read.motions[0].skip_reason.as_ref().unwrap();
    assert_eq!(why.code, "keep::tool-unknown");
    assert!(
        why.reason.contains("it is a parameter, and the calls hand over different ones"),
        "{}",
        why.reason
    );
}

/// x in mm of the tools that a motion may have in later passes.
fn later_mm(program: &Program, motion: usize) -> Vec<i32> {
    let later = program.motions[motion].setup.later_frames.iter();
    later.map(|frames| (frames.tool.frame_from_tcp.translation.x * 1e3).round() as i32).collect()
}

/// PERS and module VAR outlive a cycle: what a program leaves in them the next one begins with.
#[test]
fn what_a_pass_leaves_the_next_begins_with() {
    let read =
        main_of(&data(), &format!("{MOVE}t:={};\nIF DI1=1 t:={};\nt.tframe.trans.x:=4;", tool(2), tool(3)));
    assert_eq!((codes(&read), later_mm(&read, 0)), (vec!["-"], vec![2, 3, 4]));
    assert_eq!((warnings(&read), read.motions[0].run_time), (vec!["state::pers-kept"], true));
    // Set to what it is declared with: there is nothing to be said.
    let read = main_of(&data(), &format!("{MOVE}t:={};\nt.tframe.trans:=[1,0,0];", tool(1)));
    assert_eq!((codes(&read), later_mm(&read, 0), warnings(&read)), (vec!["-"], vec![], vec![]));
    // A motion before which part of it is set sees the rest as it was left.
    let read = main_of(
        &data(),
        &format!("t.tframe.trans.x:=5;\n{MOVE}t:=[TRUE,[[5,6,0],[1,0,0,0]],[1,[0,0,1],[1,0,0,0],0,0,0]];"),
    );
    assert_eq!((codes(&read), because_line(&read, 0)), (vec!["keep::tool-unknown"], 8));
    // By way of a VAR of the module, and by one of the routine, which is new in each call.
    let set = "t.tframe.trans.x:=n;\n";
    let read = main_of(&format!("{}VAR num n:=1;", data()), &format!("{set}{MOVE}n:=9;"));
    assert_eq!((codes(&read), because_line(&read, 0)), (vec!["keep::tool-unknown"], 8));
    let read = main_of(&data(), &format!("VAR num n:=1;\n{set}{MOVE}n:=9;"));
    assert_eq!((codes(&read), tools_mm(&read)), (vec!["-"], vec![Some(1)]));
    // What only run time tells.
    let read = main_of(&data(), &format!("{MOVE}t.tframe.trans.x:=AInput(ai1);"));
    assert_eq!((codes(&read), because_line(&read, 0)), (vec!["keep::tool-unknown"], 7));
    // In the course of a loop it goes on and on.
    let read = main_of(&data(), &format!("{MOVE}t.tframe.trans.x:=t.tframe.trans.x+1;"));
    assert_eq!(codes(&read), ["keep::tool-unknown"]);
}

#[test]
fn what_a_hand_calls_counts_where_it_is_known() {
    let with = |main: &str, other: &str| {
        module(&format!("{}\nPROC {main}()\n{MOVE}ENDPROC\nPROC other()\n{other}ENDPROC", data()))
    };
    let known = format!("t:={};\n", tool(2));
    for main in ["main", "part"] {
        assert_eq!(later_mm(&with(main, &known), 0), [2]);
    }
    let unknown = "t.tframe.trans.x:=AInput(ai1);\n";
    let read = with("main", unknown);
    assert_eq!((codes(&read), warnings(&read)), (vec!["-"], vec!["state::set-by-hand"]));
    // Of a library nobody knows which routine comes first.
    assert_eq!(codes(&with("part", unknown)), ["keep::tool-unknown"]);
    // What main calls it calls in each cycle.
    let read =
        module(&format!("{}\nPROC main()\n{MOVE}other;\nENDPROC\nPROC other()\n{unknown}ENDPROC", data()));
    assert_eq!(codes(&read), ["keep::tool-unknown"]);
}

/// What a procedure that is not given is handed it may be there to set, as a camera's work object or a measured tip; a call with a speed
/// is a move with its own ways, and a move sets neither.
#[test]
fn a_tool_or_work_object_that_is_handed_to_a_routine_that_is_not_given_is_not_known_behind_it() {
    let codes_behind = |call: &str| codes(&main_of(&data(), &format!("{call};\n{MOVE}"))).join(" ");
    for (call, code) in [
        ("GetFrame w", "keep::wobj-unknown"),
        ("%\"GetFrame\"% w", "keep::wobj-unknown"),
        ("MeasureTip t", "keep::tool-unknown"),
        ("MeasureTip t.tframe.trans", "keep::tool-unknown"),
        ("Measure 5\\Tip:=t", "keep::tool-unknown"),
        ("Approach t,v100.v_tcp", "keep::tool-unknown"),
    ] {
        assert_eq!(codes_behind(call), code, "{call}");
    }
    for call in [
        "GoTo p,v100,z10,t\\WObj:=w",
        "Paint v20,t",
        "ArcLStart p,v100,sm1,wd1,fine,t",
        "EGMMoveL id,p,v100,z10,t\\WObj:=w",
        "EGMMoveC id,p,p,v100,z10,t\\WObj:=w",
        "NutL p,v100,nut1,gun1,z10,t\\WObj:=w",
        "GetFrame",
        "TPWrite w.ufmec",
    ] {
        assert!(!codes_behind(call).contains("unknown"), "{call}: {}", codes_behind(call));
    }
    // Another one than the motion's.
    assert_eq!(
        codes(&main_of(
            &format!(
                "{}PERS wobjdata other:=[FALSE,TRUE,\"\",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];",
                data()
            ),
            &format!("GetFrame other;\n{MOVE}")
        )),
        ["-"]
    );
}

/// It is taken to change nothing, so what it could change is named: PERS that it sees.
#[test]
fn a_routine_that_is_not_given_is_told_with_what_it_can_set() {
    let reported = |data: &str| {
        let read = main_of(data, &format!("OpenGrip;\n{MOVE}"));
        let found = read.diagnostics.iter().find(|found| found.code == "resolve::routine-not-given");
        found.unwrap().help.clone().unwrap()
    };
    assert!(
        reported(&data()).starts_with("it could set t and w, used by motions here"),
        "{}",
        reported(&data())
    );
    let hidden = data().replace("PERS tooldata", "LOCAL PERS tooldata");
    assert!(reported(&hidden).starts_with("it could set w, used"), "{}", reported(&hidden));
    let hidden = hidden.replace("PERS wobjdata", "LOCAL PERS wobjdata");
    assert!(reported(&hidden).starts_with("it is taken to leave tools"), "{}", reported(&hidden));
}

#[test]
fn more_pairs_than_are_looked_at_are_kept() {
    let sets = |n: i32| (2..2 + n).map(|x| format!("t:={};\n", tool(x))).collect::<String>();
    let read = |n: i32| main_of(&data(), &format!("{MOVE}{}", sets(n)));
    assert_eq!((codes(&read(16)), later_mm(&read(16), 0).len()), (vec!["-"], 16));
    assert_eq!(codes(&read(17)), ["keep::tool-unknown"]);
    // Six tools at three places are eighteen pairs, one of them that of the first pass.
    let places = "w.uframe.trans:=[0,0,10];\nw.uframe.trans:=[0,0,20];\n";
    let read = |n: i32| main_of(&data(), &format!("{MOVE}{}{places}", sets(n)));
    assert_eq!((codes(&read(4)), codes(&read(5))), (vec!["-"], vec!["keep::tool-unknown"]));
}

#[test]
fn a_tool_made_of_other_values_that_the_program_sets() {
    let body = format!("VAR num len:=7;\nlen:=len+1;\nt.tframe.trans:=[len,0,0];\n{MOVE}");
    assert_eq!(tools_mm(&main_of(&data(), &body)), [Some(8)]);
}

#[test]
fn a_branch_that_changes_the_tool_leaves_it_unknown_and_the_reason_names_the_line() {
    let body =
        format!("t:={};\nIF DI1=1 THEN\nt.tframe.trans.x:=9;\nENDIF\n{MOVE}t:={};\n{MOVE}", tool(2), tool(3));
    let read = main_of(&data(), &body);
    assert_eq!(codes(&read), ["keep::tool-unknown", "-"]);
    assert_eq!(because_line(&read, 0), 8);
    assert_eq!(tools_mm(&read)[1], Some(3));
    // Both ways set the same: known.
    let body = format!("IF DI1=1 THEN\nt:={};\nELSE\nt:={};\nENDIF\n{MOVE}", tool(6), tool(6));
    assert_eq!(tools_mm(&main_of(&data(), &body)), [Some(6)]);
    // What differs is one component, and that one is set again behind the branch.
    let body = format!("IF DI1=1 t.tframe.trans.x:=9;\nt.tframe.trans:=[4,0,0];\n{MOVE}");
    assert_eq!(tools_mm(&main_of(&data(), &body)), [Some(4)]);
    let body = format!("TEST n\nCASE 1:\nt:={};\nDEFAULT:\nt:={};\nENDTEST\n{MOVE}", tool(6), tool(7));
    assert_eq!(codes(&main_of(&data(), &body)), ["keep::tool-unknown"]);
}

#[test]
fn a_loop_that_changes_the_tool_leaves_it_unknown_at_its_head() {
    let body = format!("t:={};\nWHILE TRUE DO\n{MOVE}t:={};\n{MOVE}ENDWHILE", tool(2), tool(3));
    let read = main_of(&data(), &body);
    assert_eq!(codes(&read), ["keep::tool-unknown", "-"]);
    assert_eq!(tools_mm(&read)[1], Some(3));
    let body = format!("t:={};\nFOR i FROM 1 TO 3 DO\n{MOVE}t:={};\nENDFOR\n{MOVE}", tool(2), tool(2));
    assert_eq!(tools_mm(&main_of(&data(), &body)), [Some(2), Some(2)]);
    let body = format!("t:={};\nback:\n{MOVE}t:={};\nIF DI1=1 GOTO back;\n{MOVE}", tool(2), tool(3));
    let read = main_of(&data(), &body);
    assert_eq!(codes(&read), ["keep::tool-unknown", "-"]);
    // A counter that no fixed point has: unknown, and no endless work.
    let body = format!("FOR i FROM 1 TO 3 DO\nt.tframe.trans.x:=t.tframe.trans.x+1;\n{MOVE}ENDFOR");
    assert_eq!(codes(&main_of(&data(), &body)), ["keep::tool-unknown"]);
}

#[test]
fn calls_carry_the_state_in_and_out() {
    let text = format!(
        "{}\nPROC main()\nt:={};\npage1;\nsetTool;\npage2;\nENDPROC
PROC page1()\n{MOVE}ENDPROC\nPROC page2()\n{MOVE}ENDPROC\nPROC setTool()\nt:={};\nENDPROC",
        data(),
        tool(2),
        tool(3)
    );
    let read = module(&text);
    assert_eq!(tools_mm(&read), [Some(2), Some(3)]);
    assert!(warnings(&read).is_empty(), "{:?}", read.diagnostics);
}

#[test]
fn a_routine_called_with_different_tools_does_not_know_its_tool() {
    let text = format!(
        "{}\nPROC main()\nt:={};\nsub;\nt:={};\nsub;\n{MOVE}ENDPROC\nPROC sub()\n{MOVE}ENDPROC",
        data(),
        tool(2),
        tool(3)
    );
    let read = module(&text);
    assert_eq!(codes(&read), ["-", "keep::tool-unknown"]);
    assert_eq!(tools_mm(&read)[0], Some(3));
}

#[test]
fn a_tool_handed_to_a_routine() {
    let text = |second| {
        format!(
            "{}\nPERS tooldata t2:={};\nPROC main()\npick t;\npick {second};\nENDPROC
PROC pick(PERS tooldata gun)\nMoveL p,v100,fine,gun;\nENDPROC",
            data(),
            tool(2)
        )
    };
    assert_eq!(tools_mm(&module(&text("t"))), [Some(1)]);
    assert_eq!(codes(&module(&text("t2"))), ["keep::tool-unknown"]);
}

#[test]
fn traps_and_handlers_make_what_they_set_unknown_everywhere() {
    let text =
        format!("{}\nPROC main()\nt:={};\n{MOVE}ERROR\nt:={};\nRETRY;\nENDPROC", data(), tool(2), tool(3));
    assert_eq!(codes(&module(&text)), ["keep::tool-unknown"]);
    let text = format!(
        "{}\nPROC main()\nt:={};\n{MOVE}t:={};\nENDPROC\nTRAP stop1\n{MOVE}ENDTRAP",
        data(),
        tool(2),
        tool(3)
    );
    assert_eq!(codes(&module(&text)), ["-", "keep::tool-unknown"]);
    // A handler's own motion sees what no error can have come before.
    let text = format!(
        "{}\nPROC main()\nt:={};\nsub;\nENDPROC\nPROC sub()\n{MOVE}ERROR\n{MOVE}RETURN;\nENDPROC",
        data(),
        tool(2)
    );
    assert_eq!(tools_mm(&module(&text)), [Some(2), Some(2)]);
}

#[test]
fn recursion_ends() {
    let text = format!(
        "{}\nPROC main()\nt:={};\na;\nENDPROC\nPROC a()\n{MOVE}t.tframe.trans.x:=t.tframe.trans.x+1;\nIF DI1=1 b;\nENDPROC\nPROC b()\na;\nENDPROC",
        data(),
        tool(2)
    );
    assert_eq!(codes(&module(&text)), ["keep::tool-unknown"]);
    let alone = format!("{}\nPROC a()\n{MOVE}b;\nENDPROC\nPROC b()\na;\nENDPROC", data());
    assert_eq!(tools_mm(&module(&alone)), [Some(1)]);
}

#[test]
fn late_binding_leads_into_the_routines_that_fit() {
    let text = format!(
        "{}\nPROC main()\nt:={};\n%\"sub\"+ValToStr(n)%;\n{MOVE}ENDPROC
PROC sub1()\n{MOVE}t:={};\nENDPROC\nPROC other()\nENDPROC",
        data(),
        tool(2),
        tool(3)
    );
    let read = module(&text);
    assert_eq!(codes(&read), ["keep::tool-unknown", "-"]);
    assert_eq!(tools_mm(&read)[1], Some(2), "sub1 inherits the tool of its caller");
    let text = text.replace("\"sub\"+ValToStr(n)", "\"M:Sub1\"");
    assert_eq!(tools_mm(&module(&text)), [Some(3), Some(2)]);
}

/// A function asked at run time would know the target, and not the displacement: that is the reason.
#[test]
fn of_several_reasons_that_which_holds_in_every_form_is_told() {
    let data = format!("VAR num n;\n{}", data());
    let body = format!(
        "n:=DInput(d);\nMoveL Offs(p,n,0,0),v100,fine,t;\nPDispOn p,tool0;\nMoveL Offs(p,n,0,0),v100,fine,t;\n{MOVE}PDispOff;"
    );
    let read = main_of(&data, &body);
    assert_eq!(codes(&read), ["keep::runtime-target", "keep::displacement", "keep::displacement"]);
    assert_eq!(read.motions.iter().map(|m| m.run_time).collect::<Vec<_>>(), [true, false, false]);
}

/// `MoveAbsJ jHome\NoEOffs` is not affected by an offset; where a parameter says whether it stands there, it may be.
#[test]
fn a_move_without_external_offsets_is_free_of_them() {
    let program = module(
        "CONST jointtarget j:=[[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
PROC main()
EOffsSet [10,9E9,9E9,9E9,9E9,9E9];
MoveAbsJ j\\NoEOffs,v100,fine,tool0;
MoveAbsJ j,v100,fine,tool0;
go;
ENDPROC
PROC go(\\switch free)
MoveAbsJ j\\NoEOffs?free,v100,fine,tool0;
ENDPROC",
    );
    assert_eq!(codes(&program), ["-", "keep::external-offset", "keep::external-offset"]);
}

#[test]
fn displacements_keep_motion_until_they_are_off() {
    for (on, off, expected) in [
        ("PDispOn p,tool0;", "PDispOff;", "keep::displacement"),
        ("PDispSet [[0,0,1],[1,0,0,0]];", "PDispOff;", "keep::displacement"),
        ("PDispAdd [[0,0,1],[1,0,0,0]];", "PDispOff;", "keep::displacement"),
        ("PDispSet [[0,0,1],[1,0,0,0]];", "PDispSet [[0,0,0],[1,0,0,0]];", "keep::displacement"),
        ("EOffsSet [1,0,0,0,0,0];", "EOffsOff;", "keep::external-offset"),
        ("SoftAct 1,50;", "SoftDeact;", "keep::soft-servo"),
        ("CSSAct 1\\StiffnessNonSoftDir:=50;", "CSSDeact;", "keep::soft-servo"),
        ("FCAct t;", "FCDeact;", "keep::soft-servo"),
        ("SingArea\\LockAxis4;", "SingArea \\Wrist;", "keep::locked-axis"),
        ("SyncMoveOn sync1,tasks;", "SyncMoveOff sync2;", "keep::multimove"),
    ] {
        let body = format!("{MOVE}{on}\n{MOVE}{off}\n{MOVE}");
        assert_eq!(codes(&main_of(&data(), &body)), ["-", expected, "-"], "{on}");
        let body = format!("IF DI1=1 {on}\n{MOVE}{off}");
        assert_eq!(codes(&main_of(&data(), &body)), [expected], "{on}");
    }
}

#[test]
fn confl_and_confj() {
    let body = format!(
        "{MOVE}ConfL\\Off;\n{MOVE}MoveJ p,v100,fine,t;\nConfJ \\Off;\nMoveJ p,v100,fine,t;\nConfL\\On;\n{MOVE}IF DI1=1 ConfL\\Off;\n{MOVE}ConfL\\On;\nConfJ\\On;"
    );
    let read = main_of(&data(), &body);
    let conf: Vec<_> = read.motions.iter().map(|m| m.setup.conf_monitored).collect();
    assert_eq!(conf, [Some(true), Some(false), Some(true), Some(false), Some(true), None]);
}

#[test]
fn what_is_gripped() {
    let load = "PERS loaddata part:=[4.5,[10,0,80],[1,0,0,0],0,0,0];\nPERS loaddata late:=[1,[0,0,1],[1,0,0,0],0,0,0];";
    let body = format!(
        "{MOVE}GripLoad part;\n{MOVE}hold;\n{MOVE}GripLoad load0;\n{MOVE}IF DI1=1 GripLoad part;\n{MOVE}late.mass:=n;\nGripLoad late;\n{MOVE}GripLoad load0;"
    );
    let text =
        format!("{}\n{load}\nVAR num n;\nPROC main()\n{body}\nENDPROC\nPROC hold()\n{MOVE}ENDPROC", data());
    let read = module(&text);
    let kg: Vec<_> = read.motions.iter().map(|m| m.setup.grip.map(|load| load.mass_kg)).collect();
    // load0 weighs a gram. The last motion is that of hold, called with the part in the gripper.
    assert_eq!(kg, [Some(0.0), Some(4.5), Some(4.5), Some(0.001), None, None, Some(4.5)]);
    assert_eq!(read.motions[1].setup.grip.map(|load| load.cog_m), Some([0.01, 0.0, 0.08]));
}

#[test]
fn the_total_load_of_one_motion() {
    let load = "PERS loaddata part:=[4.5,[10,0,80],[1,0,0,0],0,0,0];\nPERS loaddata all:=[7,[0,0,90],[1,0,0,0],0,0,0];";
    let with = |load: &str| MOVE.replace("w;", &format!("w\\TLoad:={load};"));
    let body = format!("GripLoad part;\n{}{}{}{MOVE}", with("all"), with("load0"), with("other"));
    let read = main_of(&format!("{}\n{load}", data()), &body);
    let own_kg = read.motions[3].setup.tool.as_ref().unwrap().load.mass_kg;
    let kg = |m: &rapid_program::motion::Motion| {
        (m.setup.tool.as_ref().unwrap().load.mass_kg, m.setup.grip.map(|grip| grip.mass_kg))
    };
    let all: Vec<_> = read.motions.iter().map(kg).collect();
    // load0 counts as not given; of what is not known the message of GripLoad tells.
    assert_eq!(all, [(7.0, Some(0.0)), (own_kg, Some(4.5)), (own_kg, None), (own_kg, Some(4.5))]);
}

#[test]
fn who_holds_what() {
    let wobj = |robhold: &str, ufprog: &str, unit: &str| {
        format!("[{robhold},{ufprog},\"{unit}\",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]]")
    };
    let held = tool(1);
    let stationary = held.replace("TRUE", "FALSE");
    for (tool, wobj, expected) in [
        (&held, wobj("FALSE", "TRUE", ""), "-"),
        (&stationary, wobj("TRUE", "TRUE", ""), "-"),
        (&held, wobj("TRUE", "TRUE", ""), "keep::robhold"),
        (&stationary, wobj("FALSE", "TRUE", ""), "keep::robhold"),
        (&held, wobj("FALSE", "FALSE", "STN1"), "keep::wobj-moved"),
        (&held, wobj("FALSE", "TRUE", "STN1"), "keep::wobj-moved"),
        (&held, wobj("FALSE", "FALSE", ""), "keep::wobj-moved"),
    ] {
        let data = format!(
            "PERS tooldata t:={tool};\nPERS wobjdata w:={wobj};\nCONST robtarget p:={};",
            at(1, 1, 1)
        );
        assert_eq!(codes(&main_of(&data, MOVE)), [expected], "{tool} {wobj}");
    }
}

#[test]
fn what_cannot_be_followed_is_unknown() {
    // An element of an array of tools, set at run time; a tool that an instruction writes.
    let data = format!("{}\nPERS tooldata ts{{2}}:=[{},{}];", data(), tool(1), tool(2));
    let body = format!("ts{{n}}:=t;\nMoveL p,v100,fine,ts{{1}};\nMToolTCPCalib j1,j2,j3,j4,t,e1,e2;\n{MOVE}");
    assert_eq!(codes(&main_of(&data, &body)), ["keep::tool-unknown"; 2]);
    // Without the assignment the element is a constant.
    assert_eq!(tools_mm(&main_of(&data, "MoveL p,v100,fine,ts{2};")), [Some(2)]);
}

#[test]
fn text_after_the_end_is_never_reached() {
    let read = main_of(&data(), &format!("RETURN;\n{MOVE}"));
    assert_eq!(codes(&read), ["keep::unreachable"]);
    let read = main_of(&data(), &format!("GOTO over;\n{MOVE}over:\n{MOVE}EXIT;"));
    assert_eq!(codes(&read), ["keep::unreachable", "-"]);
}

#[test]
fn pages_in_several_files_inherit_from_the_page_that_calls() {
    let main = "MODULE Main\nPROC main()\nPage1()\nPage2()\nENDPROC\nENDMODULE";
    let one = format!(
        "MODULE P1\nLOCAL PERS tooldata t:={};\nPROC Page1()\nt:={};\nENDPROC\nENDMODULE",
        tool(1),
        tool(2)
    );
    let two = format!("MODULE P2\nPROC Page2()\nMoveL {},v100,fine,t;\nENDPROC\nENDMODULE", at(1, 1, 1));
    let read = program(&[("Main.mod", main), ("P1.mod", &one), ("P2.mod", &two)]);
    assert_eq!(tools_mm(&read), [Some(2)]);
    assert_eq!(code(&read.motions[0]), None);
    assert_eq!(read.facts.entries.iter().map(|e| e.name.as_str()).collect::<Vec<_>>(), ["main"]);
}

/// Twenty routines, each calling the next twice with another tool: two to the twentieth ways.
#[test]
fn many_ways_take_little_time() {
    let mut text = data();
    for i in 0..20 {
        let next = if i < 19 { format!("r{}", i + 1) } else { "last".into() };
        text += &format!(
            "\nPROC r{i}()\nt.tframe.trans.x:=t.tframe.trans.x+1;\n{next};\nt.tframe.trans.y:=t.tframe.trans.y*2+1;\n{next};\nENDPROC"
        );
    }
    text += &format!("\nPROC last()\n{MOVE}ENDPROC");
    let start = std::time::Instant::now();
    assert_eq!(codes(&module(&text)), ["keep::tool-unknown"]);
    assert!(start.elapsed().as_secs() < 10);
}

/// What is switched off for good leaves everything as it is.
#[test]
fn what_stands_under_a_constant_false_never_runs() {
    for (lines, expected) in [
        ("IF FALSE PDispSet d;", "-"),
        ("IF bNo PDispSet d;", "-"),
        ("IF bNo AND bSet THEN\nPDispSet d;\nENDIF", "keep::displacement"),
        ("IF nMode=2 THEN\nPDispSet d;\nENDIF", "-"),
        ("IF nMode=2 THEN\nPDispSet d;\nELSEIF nMode=1 THEN\nPDispSet d;\nENDIF", "keep::displacement"),
        ("IF bNo THEN\nstop;\nELSE\nPDispSet d;\nENDIF", "keep::displacement"),
        ("WHILE bNo DO\nSoftAct 1,50;\nENDWHILE", "-"),
        ("IF bSet PDispSet d;", "keep::displacement"),
        ("IF bVar PDispSet d;", "keep::displacement"),
        // A GOTO leads into it.
        ("GOTO l1;\nIF bNo THEN\nl1:\nPDispSet d;\nENDIF", "keep::displacement"),
    ] {
        let data = format!(
            "{}\nCONST bool bNo:=FALSE;\nCONST num nMode:=1;\nPERS bool bSet:=FALSE;\nVAR bool bVar:=FALSE;
CONST pose d:=[[5,0,0],[1,0,0,0]];",
            data()
        );
        assert_eq!(codes(&main_of(&data, &format!("{lines}\n{MOVE}"))), [expected], "{lines}");
    }
}

//! The PERS of whose value in the file motions are made, which a controller may hold otherwise: named in a target, copied, handed on,
//! counted to, or gone into a tool or a work object.

use super::{at, codes, main_of, module, tool};
use rapid_program::Program;
use rapid_program::motion::PersUse;

/// For each motion of a program the PERS that is told of, and what it goes into.
fn made_of(read: &Program) -> Vec<(usize, &str, PersUse)> {
    read.made_of_pers.iter().map(|made| (made.motion.index(), made.name.as_str(), made.goes_into)).collect()
}

fn read(statements: &str, routines: &str) -> Program {
    let frame = "[FALSE,TRUE,\"\",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]]";
    module(&format!(
        "PERS tooldata t:={};\nPERS wobjdata w:={frame};\nPERS wobjdata wD:={frame};\nCONST robtarget p:={};\nPERS num np:=2;
PERS num nSet:=2;\nPERS pose pfx:=[[0,0,0],[1,0,0,0]];\nPERS robtarget pp:={};\nVAR robtarget pv;\nVAR num n;
CONST robtarget pa{{3}}:=[{},{},{}];\nPROC main()\n{statements}\nENDPROC\n{routines}",
        tool(1),
        at(5, 5, 5),
        at(6, 5, 5),
        at(7, 5, 5),
        at(8, 5, 5),
        at(9, 5, 5),
    ))
}

const MOVE: &str = "MoveL p,v100,fine,t\\WObj:=w;\n";

#[test]
fn a_pers_that_goes_into_a_frame_is_told_of() {
    let frames = |name| vec![(0, name, PersUse::Frames)];
    for (set, expected) in [
        ("w.uframe.trans.y:=np;", frames("np")),
        ("w.uframe:=pfx;", frames("pfx")),
        ("w.uframe.trans:=pp.trans;", frames("pp")),
        ("n:=np+1;\nw.oframe.trans.z:=2*n;", frames("np")),
        ("t.tframe.trans.x:=np;", frames("np")),
        // What the program itself has set is no value of the file.
        ("nSet:=5;\nw.uframe.trans.y:=nSet;", vec![]),
        ("w.uframe.trans.y:=np;\nw.uframe:=[[0,0,1],[1,0,0,0]];\nw:=wD;", vec![]),
        // Tools and work objects are PERS as a rule.
        ("w:=wD;", vec![]),
        ("w.uframe:=wD.uframe;", vec![]),
        ("n:=np;", vec![]),
    ] {
        let read = read(&format!("{set}\n{MOVE}"), "");
        assert_eq!((codes(&read), made_of(&read)), (vec!["-"], expected), "{set}");
    }
    let handed = read("go np;", &format!("PROC go(num z)\nw.uframe.trans.z:=z;\n{MOVE}{MOVE}ENDPROC"));
    assert_eq!(made_of(&handed), [(0, "np", PersUse::Frames), (1, "np", PersUse::Frames)]);
    // A motion to joints asks for neither tool nor work object.
    let joints = "w.uframe:=pfx;\nMoveAbsJ [[1,2,3,4,5,6],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,t\\WObj:=w;";
    assert_eq!(made_of(&read(joints, "")), []);
    // Paths of points without names: each of them.
    let inline = |x| format!("MoveL {},v100,fine,t\\WObj:=w;\n", at(x, 5, 5));
    let path = read(&format!("w.uframe:=pfx;\n{}{}{}", inline(1), inline(2), inline(3)), "");
    assert_eq!(made_of(&path).len(), 3);
}

#[test]
fn a_pers_that_chooses_among_targets_is_told_of() {
    let target = |motion, name| vec![(motion, name, PersUse::Target)];
    for (statements, expected) in [
        // All elements are corrected.
        ("MoveL pa{np},v100,fine,t;", vec![]),
        ("MoveL Offs(pa{np+1},0,0,nSet),v100,fine,t;", target(0, "nSet")),
        ("pv:=pa{np};\nMoveL pv,v100,fine,t;", target(0, "np")),
        ("pv:=pa{np};\nMoveL Offs(pv,0,0,10),v100,fine,t;", target(0, "np")),
        ("pv:=pp;\nMoveL pv,v100,fine,t;", target(0, "pp")),
        ("FOR k FROM 1 TO np DO\nMoveL Offs(p,0,15*k,0),v100,fine,t;\nENDFOR", target(0, "np")),
        ("go pa{np},1;", target(0, "np")),
        ("go p,np;", target(1, "np")),
        ("pv:=pa{np};\npv:=p;\nMoveL pv,v100,fine,t;", vec![]),
        ("FOR k FROM 1 TO 3 DO\nMoveL Offs(p,0,15*k,0),v100,fine,t;\nENDFOR", vec![]),
        // Every element is corrected, whichever is asked for.
        ("n:=AInput(ai1);\nMoveL pa{n},v100,fine,t;", vec![]),
    ] {
        let go =
            "PROC go(robtarget q,num k)\nMoveL q,v100,fine,t;\nMoveL Offs(p,0,k*10,0),v100,fine,t;\nENDPROC";
        let read = read(statements, if statements.starts_with("go") { go } else { "" });
        assert_eq!(made_of(&read), expected, "{statements}");
    }
    // The end of an arc that a PERS chooses is known on the controller alone.
    assert_eq!(codes(&read("MoveC p,pa{np},v100,z10,t;", "")), ["keep::runtime-target"]);
    assert_eq!(codes(&read("MoveC p,pa{2},v100,z10,t;", "")), ["-"]);
}

/// A pendant sets it to another displacement, or starts the loop that the file shows ended.
#[test]
fn what_a_pers_decides_or_displaces_is_open() {
    let decided = |data: &str, statements: &str| {
        let program = module(&format!(
            "PERS tooldata t:={};\nCONST robtarget p:={};\n{data}\nPROC main()\nt:={};\n{statements}\nMoveL p,v100,fine,t;\nENDPROC",
            tool(1),
            at(5, 5, 5),
            tool(1)
        ));
        codes(&program)
    };
    let set = format!("t:={};", tool(200));
    // What another value of it would run counts, and so does what it would leave out.
    for value in ["TRUE", "FALSE"] {
        let data = format!("PERS bool b:={value};");
        assert_eq!(
            decided(&data, &format!("WHILE b DO\n{set}\nENDWHILE")),
            ["keep::tool-unknown"],
            "{value}"
        );
        assert_eq!(decided(&data, &format!("IF b THEN\n{set}\nENDIF")), ["keep::tool-unknown"], "{value}");
        assert_eq!(decided(&data, &format!("IF b GOTO l1;\n{set}\nl1:")), ["keep::tool-unknown"], "{value}");
    }
    let counted = format!("FOR k FROM 1 TO n STEP 1 DO\n{set}\nENDFOR");
    assert_eq!(decided("PERS num n:=1;", &counted), ["keep::tool-unknown"]);
    assert_eq!(decided("CONST num n:=1;", &counted), ["-"]);
    for (kind, expected) in [("PERS", "keep::displacement"), ("CONST", "-")] {
        let data = format!("{kind} pose pe:=[[0,0,0],[1,0,0,0]];\nCONST pose pc:=[[0,0,0],[1,0,0,0]];");
        assert_eq!(decided(&data, "PDispSet pe;"), [expected]);
        assert_eq!(decided(&data, "PDispSet pc;"), ["-"]);
    }
    // What the statement just before sets is what is in force, whatever the file says of it.
    let (none, some) = ("[[0,0,0],[1,0,0,0]]", "[[0,0,9],[1,0,0,0]]");
    for (kind, statements, expected) in [
        ("PERS", format!("pe:={none};\nPDispSet pe;"), "-"),
        ("VAR", format!("pe:={none};\n! none\nPDispSet pe;"), "-"),
        ("PERS", format!("pe:={some};\nPDispSet pe;"), "keep::displacement"),
        ("PERS", format!("pe:={none};\npe.trans.z:=9;\nPDispSet pe;"), "keep::displacement"),
        ("PERS", format!("pe:={none};\nb:=TRUE;\nPDispSet pe;"), "keep::displacement"),
        ("PERS", format!("pe:={none};\nIF b PDispSet pe;"), "keep::displacement"),
        ("PERS", format!("pe:={none};\nagain:\nPDispSet pe;\nGOTO again;"), "keep::unreachable"),
        ("PERS", format!("pe:={none};\nPDispSet pe;\nSetDataVal \"pe\",pq;"), "keep::displacement"),
    ] {
        let data = format!("{kind} pose pe:={some};\nPERS bool b:=TRUE;\nVAR pose pq;");
        assert_eq!(decided(&data, &statements), [expected], "{statements}");
    }
    let set = module(&format!(
        "PERS pose pe:={none};\nCONST robtarget p:={};\nPROC main()\npe:={some};\nPDispSet pe;\nMoveL p,v100,fine,tool0;\nENDPROC",
        at(5, 5, 5)
    ));
    let reason = set.motions[0].skip_reason.as_ref().unwrap().reason.clone();
    assert!(reason.starts_with("a program displacement is in force (PDispSet)"), "{reason}");
    let axes = |kind: &str| decided(&format!("{kind} extjoint e:=[0,0,0,0,0,0];"), "EOffsSet e;");
    assert_eq!((axes("CONST"), axes("PERS")), (vec!["-"], vec!["keep::external-offset"]));
}

/// Loads are PERS as a rule, and taken as the file has them; which of them is gripped, a PERS may choose.
#[test]
fn the_load_that_a_pers_chooses_is_open() {
    let load = |kg: u32| format!("[{kg},[0,0,80],[1,0,0,0],0,0,0]");
    let gripped_kg = |grip: &str| {
        let program = module(&format!(
            "PERS tooldata t:={};\nCONST robtarget p:={};\nPERS num np:=1;\nPERS loaddata la{{2}}:=[{},{}];\nPROC main()
GripLoad {grip};\nMoveL p,v100,fine,t;\nENDPROC",
            tool(1),
            at(5, 5, 5),
            load(5),
            load(1)
        ));
        program.motions[0].setup.grip.as_ref().map(|load| load.mass_kg)
    };
    assert_eq!((gripped_kg("la{2}"), gripped_kg("la{np}")), (Some(1.0), None));
}

/// Its element is that of the moment and its offset the file's: such a target neither value means.
#[test]
fn a_pers_that_chooses_the_element_and_displaces_it_keeps_the_motion() {
    for (target, expected) in [
        ("Offs(pa{np},0,0,5*np)", "keep::runtime-target"),
        ("Offs(pa{np+1},0,0,nc)", "keep::runtime-target"),
        ("Offs(pa{nSet},0,0,5*np)", "-"),
        ("Offs(pa{np},0,0,5)", "-"),
        ("Offs(pa{na{np}},0,0,5)", "-"),
    ] {
        let data = format!(
            "PERS tooldata t:={};\nPERS num np:=2;\nPERS num nSet:=2;\nCONST num nc:=2*np;\nCONST num na{{3}}:=[3,2,1];
CONST robtarget pa{{3}}:=[{},{},{}];",
            tool(1),
            at(7, 5, 5),
            at(8, 5, 5),
            at(9, 5, 5)
        );
        let read = module(&format!("{data}\nPROC main()\nMoveL {target},v100,fine,t;\nENDPROC"));
        let motion = &read.motions[0];
        let is_all = motion.targets[0].indices().is_some_and(|indices| indices.occurring.is_none());
        assert_eq!((codes(&read), is_all), (vec![expected], expected == "-"), "{target}");
    }
}

/// A tool that is another one from the second pass on takes nothing of what keeps a motion in every form: asked at run time, a
/// search would stop beside its place, and a point that holds where the arm stood would be corrected twice.
#[test]
fn what_keeps_a_motion_keeps_it_with_whatever_tool() {
    let moves = [
        ("p", "", "-"),
        ("v", "", "keep::own-position"),
        ("p", "\\Corr", "keep::path-correction"),
        ("p\\ID:=10", "", "keep::multimove"),
    ];
    let of_moves: String = moves
        .iter()
        .map(|(point, after, _)| format!("MoveL {point},v100,fine,t\\WObj:=w{after};\n"))
        .collect();
    let data = format!("{}VAR robtarget v;\nVAR robtarget f;", super::state::data());
    let body = format!("v:=CRobT(\\Tool:=t\\WObj:=w);\n{of_moves}SearchL DI1,f,p,v100,t\\WObj:=w;\n");
    let by_hand = format!("{body}ENDPROC\nPROC by_hand()\nt:={};", tool(3));
    for body in [format!("{body}t:={};", tool(3)), by_hand] {
        let read = main_of(&data, &body);
        let mut expected: Vec<&str> = moves.iter().map(|(_, _, code)| *code).collect();
        expected.push("keep::search");
        assert_eq!(codes(&read), expected);
        let run_time: Vec<bool> = read.motions.iter().map(|motion| motion.run_time).collect();
        assert_eq!(run_time, [true, false, false, false, false]);
    }
}

//! Targets: how they are written, what they are worth, and why they are not known.

use super::{at, because_line, code, codes, main_of, module, program, warnings};
use rapid_program::Program;
use rapid_program::motion::{Origin, TargetValue};

/// Position of a motion's last target in mm.
fn position_mm(program: &Program, motion: usize) -> [f64; 3] {
    let target = program.motions[motion].targets.last().unwrap();
    let Some(TargetValue::Rob(p)) = target.value() else { panic!("motion {motion} has no robtarget") };
    let v = p.object_from_tcp.translation.vector * 1e3;
    [v.x, v.y, v.z].map(|n| (n * 1e6).round() / 1e6)
}

#[test]
fn every_way_to_write_a_constant_target() {
    let data = format!(
        "CONST robtarget p10:={};\nPERS robtarget p20:={};\nVAR robtarget p30:={};
CONST pos here:=[1,2,3];\nCONST orient up:=[1,0,0,0];\nCONST num h:=2*(3+4)-DUMMY;\nCONST num DUMMY:=4;
CONST robtarget ps{{2}}:=[{},{}];\nCONST robtarget grid{{2,2}}:=[[{},{}],[{},{}]];
CONST robtarget again:=p10;",
        at(10, 0, 0),
        at(20, 0, 0),
        at(30, 0, 0),
        at(1, 0, 0),
        at(2, 0, 0),
        at(11, 0, 0),
        at(12, 0, 0),
        at(21, 0, 0),
        at(22, 0, 0)
    );
    let forms = [
        ("p10", [10.0, 0.0, 0.0]),
        ("P20", [20.0, 0.0, 0.0]),
        ("p30", [30.0, 0.0, 0.0]),
        ("again", [10.0, 0.0, 0.0]),
        ("Offs(p10,1,-2,h)", [11.0, -2.0, 10.0]),
        ("RelTool(p10,0,0,5\\Rz:=90)", [10.0, 0.0, 5.0]),
        ("Offs(RelTool(p10,1,1,1),1,1,1)", [12.0, 2.0, 2.0]),
        ("ps{2}", [2.0, 0.0, 0.0]),
        ("grid{2,1}", [21.0, 0.0, 0.0]),
        ("grid{1+1,4/2}", [22.0, 0.0, 0.0]),
        ("[here,up,[0,0,0,0],[9E9,9E+09,9e9,9.0E9,9000000000,9E9]]", [1.0, 2.0, 3.0]),
        ("[[p20.trans.x,h,-1],p10.rot,p10.robconf,p10.extax]", [20.0, 10.0, -1.0]),
        ("[here+2*here,OrientZYX(0,0,0),[0,0,0,0],p10.extax]", [3.0, 6.0, 9.0]),
        ("(p10)", [10.0, 0.0, 0.0]),
    ];
    let body: String = forms.iter().map(|(form, _)| format!("MoveL {form},v100,z10,tool0;\n")).collect();
    let program = main_of(&data, &body);
    assert_eq!(program.motions.len(), forms.len());
    for (i, (form, expected)) in forms.iter().enumerate() {
        assert_eq!(code(&program.motions[i]), None, "{form}: {:?}", program.motions[i].skip_reason);
        assert_eq!(position_mm(&program, i), *expected, "{form}");
    }
    let origin = |i: usize| program.motions[i].targets[0].origin();
    assert!(matches!(origin(1), Origin::Named { name, .. } if name == "P20"));
    assert!(matches!(origin(4), Origin::Expression(_)));
    assert_eq!(*origin(10), Origin::Inline);
    // Only what is made of literals alone can be copied as text.
    let literal = |i: usize| {
        program.motions[i].targets[0]
            .literal(program.motions[i].file)
            .map(|s| program.file(s.file).text(s.range).to_vec())
    };
    assert_eq!(literal(0), Some(at(10, 0, 0).into_bytes()));
    assert_eq!(literal(3), None);
    assert_eq!(literal(10), None);
}

#[test]
fn targets_that_only_the_running_program_knows_say_why() {
    let data = format!(
        "VAR robtarget p:={};\nVAR robtarget q:={};\nVAR robtarget r:={};\nVAR robtarget none;
VAR robtarget found:={};\nVAR robtarget handed:={};\nCONST robtarget ps{{2}}:=[{},{}];\nVAR num n:=1;
VAR robtarget kept:={};\nVAR num count:=5;",
        at(0, 0, 0),
        at(0, 0, 0),
        at(0, 0, 0),
        at(0, 0, 0),
        at(0, 0, 0),
        at(1, 0, 0),
        at(2, 0, 0),
        at(7, 0, 0)
    );
    let text = format!(
        "{data}
PROC main()
  p:=CRobT(\\Tool:=tool0);
  q.trans.z:=5;
  SearchL di1,found,q,v10,tool0;
  change handed;
  look kept;
  Incr count;
  FOR i FROM 1 TO 2 DO
    MoveL ps{{i}},v100,fine,tool0;
  ENDFOR
  MoveL p,v100,fine,tool0;
  MoveL q,v100,fine,tool0;
  MoveL Offs(found,0,0,1),v100,fine,tool0;
  MoveL handed,v100,fine,tool0;
  MoveL kept,v100,fine,tool0;
  MoveL none,v100,fine,tool0;
  MoveL Offs(r,0,0,count),v100,fine,tool0;
  MoveL where(1),v100,fine,tool0;
  MoveL CRobT(),v100,fine,tool0;
  MoveAbsJ CalcJointT(r,tool0),v100,fine,tool0;
  MoveL nowhere,v100,fine,tool0;
  MoveL ps{{3}},v100,fine,tool0;
  wrapped r;
ENDPROC
PROC change(VAR robtarget x)
  x.trans.x:=1;
ENDPROC
PROC look(VAR robtarget x)
  TPWrite \"\"\\Num:=x.trans.x;
ENDPROC
PROC wrapped(robtarget goal)
  MoveL goal,v100,fine,tool0;
ENDPROC
FUNC robtarget where(num i)
  RETURN r;
ENDFUNC"
    );
    let program = module(&text);
    assert_eq!(
        codes(&program),
        [
            "keep::search",
            "-",                    // all elements of ps are known
            "keep::own-position",   // p := CRobT()
            "keep::runtime-target", // q.trans.z := 5
            "keep::runtime-target", // SearchL writes it
            "keep::runtime-target", // change writes its parameter
            "-",                    // look does not
            "keep::no-value",
            "keep::runtime-target", // Incr count
            "keep::function-result",
            "keep::own-position",
            "keep::function-result",
            "keep::not-declared",
            "keep::no-element",
            "-", // its one call hands over a constant
        ]
    );
    let line_of = |what: &str| text.lines().position(|l| l.contains(what)).unwrap() as u32 + 2;
    assert_eq!(because_line(&program, 2), line_of("p:=CRobT"));
    assert_eq!(because_line(&program, 3), line_of("q.trans.z:=5"));
    assert_eq!(because_line(&program, 4), line_of("SearchL"));
    assert_eq!(because_line(&program, 5), line_of("change handed"));
    assert_eq!(because_line(&program, 8), line_of("Incr count"));
}

#[test]
fn constants_that_lead_back_to_themselves_are_no_values() {
    let program = main_of("CONST robtarget a:=b;\nCONST robtarget b:=a;", "MoveL a,v100,fine,tool0;");
    assert_eq!(codes(&program), ["keep::cyclic"]);
    let chain: String = (0..5000).map(|i| format!("CONST robtarget p{i}:=p{};\n", i + 1)).collect();
    let program = main_of(&chain, "MoveL p0,v100,fine,tool0;");
    assert_eq!(codes(&program), ["keep::too-deep"]);
}

#[test]
fn values_no_controller_takes_are_kept() {
    let target = |trans: &str, rot: &str| format!("[{trans},{rot},[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]");
    let moves = [
        (target("[0,0,0]", "[0,0,0,0]"), "keep::bad-orientation"),
        (target("[0,0,0]", "[1,1,0,0]"), "keep::bad-orientation"),
        (target("[1e39,0,0]", "[1,0,0,0]"), "keep::bad-number"),
        (target("[1/0,0,0]", "[1,0,0,0]"), "keep::bad-number"),
        (target("[0,0]", "[1,0,0,0]"), "keep::wrong-type"),
        ("5".to_owned(), "keep::wrong-type"),
        (target("[0,0,0]", "[0.707,0,0.707,0]"), "-"),
    ];
    let body: String = moves.iter().map(|(t, _)| format!("MoveL {t},v100,z10,tool0;\n")).collect();
    assert_eq!(codes(&main_of("", &body)), moves.iter().map(|m| m.1).collect::<Vec<_>>());
}

#[test]
fn external_axes_are_copied_and_an_unused_robot_axis_keeps_the_move() {
    let program = main_of(
        "",
        "MoveAbsJ [[10,20,30,40,50,60],[100,9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0;
MoveAbsJ [[10,20,30,40,50,9E9],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0;
MoveAbsJ [[10,20,30,40,50,60],[9E9,9E9,9E9,9E9,9E9,9E9]]\\NoEOffs,v100,fine,notGiven;",
    );
    assert_eq!(codes(&program), ["-", "keep::axis-unused", "-"]);
    let Some(TargetValue::Joint(j)) = program.motions[0].targets[0].value() else { panic!("joints") };
    assert_eq!(j.ext, [Some(100.0), None, None, None, None, None]);
    assert_eq!(j.q_rad[2], Some(30_f64.to_radians()));
    assert_eq!(program.motions[2].setup.tool, None);
}

/// The controller's own functions and instructions hand a reading on, too.
#[test]
fn a_reading_written_out_and_read_in_again_is_a_reading() {
    for (lines, kept) in [
        ("s:=ValToStr(CRobT());\nok:=StrToVal(s,p);", true),
        ("IF StrToVal(ValToStr(CRobT()),p) THEN\nok:=TRUE;\nENDIF", true),
        ("PackRawBytes CRobT(),raw,1;\nUnpackRawBytes raw,1,p;", true),
        ("pG:=CRobT();\nGetDataVal \"pg\",p;", true),
        ("pG:=CRobT();\nGetDataVal s,p;", true),
        ("q:=CRobT();\nSetDataVal \"P\",q;", true),
        ("q:=CRobT();\nSetDataVal s,q;", true),
        ("PackRawBytes CRobT(),raw,1;\nCopyRawBytes raw,1,other,1;\nUnpackRawBytes other,1,p;", true),
        ("q:=CRobT();\nTPReadNum n,\"at \"+ValToStr(q);\np:=Offs(q0,0,0,n);", false),
        ("pG:=CRobT();\nGetDataVal \"other\",p;", false),
        ("ok:=StrToVal(\"[[1,2,3],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]\",p);", false),
    ] {
        let data = "VAR robtarget p;\nVAR robtarget pG;\nVAR robtarget q;\nVAR string s;\nVAR bool ok;\nVAR rawbytes raw;\nVAR rawbytes other;\nVAR num n;\nCONST robtarget q0:=[[1,2,3],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];";
        let program = main_of(data, &format!("{lines}\nMoveL p,v100,fine,tool0;"));
        let code = if kept { "keep::own-position" } else { "keep::runtime-target" };
        assert_eq!(codes(&program), [code], "{lines}");
    }
}

/// What is read in the call itself comes to the routine as it does by way of a variable.
#[test]
fn a_reading_handed_over_in_the_call_is_a_reading() {
    let routines = "ENDPROC
PROC both(robtarget a,INOUT robtarget b)
  b:=a;
ENDPROC
PROC opt(\\robtarget a)
  IF Present(a) p:=a;
ENDPROC
PROC placed(rec a)
  p:=a.place;
ENDPROC
FUNC robtarget here()
  RETURN CRobT();
ENDFUNC
FUNC bool kept(robtarget a)
  p:=a;
  RETURN TRUE;
ENDFUNC
PROC mem(robtarget a)
  p:=a;";
    for (call, kept) in [
        ("mem CRobT();", true),
        ("mem here();", true),
        ("mem Offs(here(),0,0,1);", true),
        ("%\"mem\"% CRobT();", true),
        ("both CRobT(),p;", true),
        ("opt \\a:=CRobT();", true),
        ("placed [CRobT(),3];", true),
        ("ok:=kept(CRobT());", true),
        ("both CRobT(),q;\np:=Offs(q0,0,0,n);", false),
        ("mem Offs(q0,0,0,n);", false),
    ] {
        let data = format!(
            "RECORD rec\nrobtarget place;\nnum n;\nENDRECORD\nVAR robtarget p;\nVAR robtarget q;\nVAR bool ok;\nVAR num n;\nCONST robtarget q0:={};",
            at(1, 2, 3)
        );
        let program =
            main_of(&data, &format!("{call}\nn:=GInput(gi1);\nMoveL p,v100,fine,tool0;\n{routines}"));
        let code = if kept { "keep::own-position" } else { "keep::runtime-target" };
        assert_eq!(codes(&program), [code], "{call}");
    }
}

/// External axes and a configuration that are taken of a reading hold nothing of the arm's drift.
#[test]
fn external_axes_of_a_reading_are_no_reading() {
    let program = main_of(
        "VAR extjoint ext;\nVAR robtarget here;\nVAR robtarget p;\nVAR confdata conf;",
        "here:=CRobT();
ext:=here.extax;
conf:=here.robconf;
p:=[[n,0,0],[1,0,0,0],conf,ext];
MoveL p,v100,fine,tool0;
p.trans:=here.trans;
MoveL p,v100,fine,tool0;",
    );
    assert_eq!(codes(&program)[1], "keep::own-position");
    let first = main_of(
        "VAR extjoint ext;\nVAR robtarget here;\nVAR robtarget p;",
        "here:=CRobT();\next:=here.extax;\np:=[[n,0,0],[1,0,0,0],here.robconf,ext];\nMoveL p,v100,fine,tool0;",
    );
    assert_eq!(codes(&first), ["keep::runtime-target"]);
}

#[test]
fn calcrobt_must_name_the_tool_and_frame_of_its_motion() {
    let joints = "[[0,10,20,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]]";
    let program = main_of(
        "CONST jointtarget j:=[[0,10,20,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];",
        &format!(
            "MoveL CalcRobT({joints},tool0),v100,fine,tool0;
MoveL CalcRobT(j,tool0\\WObj:=wobj0),v100,fine,TOOL0;
MoveL CalcRobT(j,tool0),v100,fine,tool0\\WObj:=wobj0;
MoveL CalcRobT(j,tool1),v100,fine,tool0;
MoveL Offs(CalcRobT(j,tool0),0,0,1),v100,fine,tool0;
MoveL CalcRobT(j,tool0),v100,fine,tool0\\WObj:=w;
MoveAbsJ CalcRobT(j,tool0),v100,fine,tool0;"
        ),
    );
    assert_eq!(
        codes(&program),
        ["-", "-", "-", "keep::calc-frame", "keep::function-result", "keep::calc-frame", "keep::wrong-type"]
    );
    let Some(TargetValue::FromJoints(j)) = program.motions[1].targets[0].value() else { panic!("joints") };
    assert_eq!(j.q_rad[1], Some(10_f64.to_radians()));
}

/// Argument orders as ABB's manual gives them; the same target everywhere, options in odd places.
#[test]
fn every_kind_of_motion_finds_its_arguments() {
    let data = format!("CONST robtarget p:={};\nCONST robtarget c:={};", at(5, 0, 0), at(4, 0, 0));
    let moves = [
        ("MoveL p,v100,z10,tool0;", "MoveL", "-"),
        ("movel\\Conc,p\\ID:=3,v100,z10,tool0;", "MoveL", "keep::multimove"),
        ("MOVEJ p , v100\\T:=3 , z10\\Inpos:=inpos20 , tool0 , \\WObj := wobj0 ;", "MoveJ", "-"),
        ("MoveC c,p,v100,z10,tool0\\WObj:=wobj0;", "MoveC", "-"),
        ("MoveLDO p,v100,z10,tool0,do1,1;", "MoveLDO", "-"),
        ("MoveJDO p,v100,z10,tool0,do1,1;", "MoveJDO", "-"),
        ("MoveCDO c,p,v100,z10,tool0,do1,1;", "MoveCDO", "-"),
        ("MoveLSync p,v100,z10,tool0,\"proc\";", "MoveLSync", "-"),
        ("MoveCSync c,p,v100,z10,tool0,\"proc\";", "MoveCSync", "-"),
        ("TriggL p,v100,trig1,z10,tool0;", "TriggL", "-"),
        ("TriggJ p,v100,trig1\\T2:=trig2,z10,tool0;", "TriggJ", "-"),
        ("TriggC c,p,v100,trig1,z10,tool0;", "TriggC", "-"),
        ("ArcL p,v100,seam1,weld1\\Weave:=wv1,z10,tool0;", "ArcL", "-"),
        ("ArcLStart p,v100,seam1,weld1,fine,tool0;", "ArcLStart", "-"),
        ("ArcLEnd p,v100,seam1,weld1,fine,tool0;", "ArcLEnd", "-"),
        ("ArcC c,p,v100,seam1,weld1,z10,tool0;", "ArcC", "-"),
        ("ArcL\\On,p,v100,seam1,weld1,weave1,z10,tool0;", "ArcL", "-"), // S4C: Weave is no option
        ("ArcC c,p,v100,seam1,weld1,weave1,z10,tool0;", "ArcC", "-"),
        ("MoveL p,v100,z10,z10;", "MoveL", "keep::wrong-type"),
        ("CSSDeactMoveL p,v100,tool0;", "CSSDeactMoveL", "keep::instruction"),
        ("SearchL di1,sp,p,v100,tool0;", "SearchL", "keep::search"),
        ("SearchC di1,sp,c,p,v100,tool0;", "SearchC", "keep::search"),
        ("MoveL\\Conc,p,v100,z10,tool0\\Corr;", "MoveL", "keep::path-correction"),
        ("SpotL p,v100,spot1,gun1,tool0;", "SpotL", "keep::instruction"),
        ("FCPress1LStart p,v100,\\Fz:=5,5,z10,tool0;", "FCPress1LStart", "keep::instruction"),
        ("FCPressEnd p,v100,tool0;", "FCPressEnd", "keep::instruction"),
        ("CalibL p,v100,gun1,tool0;", "CalibL", "keep::instruction"),
        ("CalibJ p,v100,gun1,tool0;", "CalibJ", "keep::instruction"),
        ("MeasureWearL p,v100,gun1,tool0;", "MeasureWearL", "keep::instruction"),
        ("NutL p,v100,nut1,gun1,z10,tool0;", "NutL", "keep::instruction"),
        ("NutJ p,v100,nut1,gun1,z10,tool0;", "NutJ", "keep::instruction"),
        ("ArcRepL\\Start,p,v100,seam1,weld1,z10,tool0;", "ArcRepL", "keep::instruction"),
        ("ArcMoveL p,v100,z10,tool0;", "ArcMoveL", "-"),
        ("ArcMoveJ p,v100,z10,tool0\\WObj:=wobj0;", "ArcMoveJ", "-"),
        ("ArcMoveC c,p,v100,z10,tool0;", "ArcMoveC", "-"),
        ("ArcMoveExtJ j,vrot100,fine;", "ArcMoveExtJ", "keep::external-axes"),
        ("MoveL p,v100;", "MoveL", "keep::tool-unknown"),
        ("MoveC p;", "MoveC", "keep::not-read"),
    ];
    let body: String = moves.iter().map(|m| format!("{}\n", m.0)).collect();
    let program = main_of(&data, &body);
    assert_eq!(program.motions.len(), moves.len());
    for (motion, (text, kind, expected)) in program.motions.iter().zip(moves) {
        assert_eq!((&*motion.setup.kind, code(motion).unwrap_or("-")), (kind, expected), "{text}");
        if expected == "-" {
            let Some(TargetValue::Rob(p)) = motion.targets.last().unwrap().value() else { panic!("{text}") };
            assert_eq!(p.object_from_tcp.translation.x, 0.005, "{text}");
            assert!(motion.setup.zone.is_some(), "{text}");
            assert_eq!(motion.targets.len(), if text.contains("c,p") { 2 } else { 1 });
        }
    }
    assert_eq!(program.motions[2].setup.speed, None, "a time is given, not a speed");
    assert_eq!(program.motions[0].setup.speed.unwrap().v_tcp_m_s, 0.1);
}

#[test]
fn placeholders_and_text_that_was_not_understood_keep_the_move() {
    let program = main_of("", "MoveL <EXP>,v100,fine,tool0;");
    assert_eq!(codes(&program), ["keep::placeholder"]);
}

#[test]
fn speeds_and_zones_with_their_options() {
    let data = format!("CONST robtarget p:={};\nCONST speeddata slow:=[20,10,5000,1000];", at(0, 0, 0));
    let program = main_of(
        &data,
        "MoveL p,slow,fine,tool0;
MoveL p,v100\\V:=30,z10\\Z:=3,tool0;
MoveL p,[33,500,5000,1000],z200,tool0;
MoveL p,v83,z2,tool0;
MoveL p,v83,fine,tool0;
MoveL p,other,other,tool0;",
    );
    assert!(codes(&program).iter().all(|c| *c == "-"));
    let v: Vec<_> =
        program.motions.iter().map(|m| m.setup.speed.map(|s| (s.v_tcp_m_s * 1e3).round())).collect();
    assert_eq!(v, [Some(20.0), Some(30.0), Some(33.0), Some(83.0), Some(83.0), None]);
    let z: Vec<_> =
        program.motions.iter().map(|m| m.setup.zone.map(|z| (z.pzone_tcp_m * 1e3).round())).collect();
    assert_eq!(z, [Some(0.0), Some(3.0), Some(200.0), Some(2.0), Some(0.0), None]);
    assert_eq!(warnings(&program), ["resolve::not-predefined"; 2], "v83 and z2, once each");
    assert!((program.motions[0].setup.speed.unwrap().v_ori_rad_s - 10_f64.to_radians()).abs() < 1e-15);
}

/// A frame that is not known because it is made of where the warm arm stood holds the drift; one that is known does not.
#[test]
fn a_work_object_or_tool_made_of_a_reading_is_one() {
    let data = format!(
        "CONST robtarget p10:={};\nVAR pos here;\nPERS wobjdata w:=[FALSE,TRUE,\"\",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];
PERS tooldata t:=[TRUE,[[0,0,0],[1,0,0,0]],[1,[0,0,1],[1,0,0,0],0,0,0]];\nPERS wobjdata other:=[FALSE,TRUE,\"\",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];",
        at(10, 0, 0)
    );
    let program = main_of(
        &data,
        "w.oframe.trans:=[10,20,30];
MoveL p10,v100,fine,tool0\\WObj:=w;
here:=CPos();
w.oframe.trans:=here;
MoveL p10,v100,fine,tool0\\WObj:=w;
t.tframe.trans.z:=here.z;
MoveL p10,v100,fine,t;
MoveAbsJ CalcJointT(p10,t),v100,fine,tool0;
other.oframe.trans.x:=GInput(gi1);
MoveL p10,v100,fine,tool0\\WObj:=other;",
    );
    assert_eq!(codes(&program)[0], "-");
    assert_eq!(codes(&program)[1..3], ["keep::own-position", "keep::own-position"]);
    assert_eq!(codes(&program)[4], "keep::wobj-unknown");
}

#[test]
fn what_is_to_be_measured_is_kept() {
    let text = |module: &str| {
        format!(
            "MODULE {module}\nPROC dpMeasure()\nMoveAbsJ [[1,2,3,4,50,6],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0;\nENDPROC\nENDMODULE\n"
        )
    };
    assert_eq!(codes(&program(&[("M.mod", &text("DriftpostPlan"))])), ["keep::measurement-run"]);
    assert_eq!(codes(&program(&[("M.mod", &text("OtherPlan"))])), ["-"]);
}

/// `SetDataVal` writes data of its value's type alone, and no constant.
#[test]
fn a_value_set_by_a_computed_name_goes_into_data_of_its_type_alone() {
    let data = "VAR robtarget q;\nVAR robtarget p:=[[1,2,3],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
CONST robtarget pc:=[[1,2,3],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
PERS jointtarget j:=[[1,2,3,4,5,6],[9E9,9E9,9E9,9E9,9E9,9E9]];\nVAR string s;\nVAR bool b;\nVAR num n:=0;";
    let moves = "MoveAbsJ j,v100,fine,tool0;\nMoveL pc,v100,fine,tool0;\nMoveL p,v100,fine,tool0;\nMoveL Offs(pc,0,0,n),v100,fine,tool0;";
    let (own, open) = ("keep::own-position", "keep::runtime-target");
    for (set, expected) in [
        ("b:=CPos(\\Tool:=tool0).x>5;\nSetDataVal s,b;", ["-", "-", "-", "-"]),
        ("SetDataVal s,TRUE;", ["-", "-", "-", "-"]),
        ("SetDataVal s,n;", ["-", "-", "-", open]),
        ("SetDataVal \"p\"+s,q;", ["-", "-", open, "-"]),
        ("q:=CRobT();\nSetDataVal s,q;", ["-", "-", own, "-"]),
        // A value of no type that its text tells.
        ("SetDataVal s,n+1;", [open, "-", open, open]),
        ("SetAllDataVal s,n;", [open, "-", open, open]),
    ] {
        let read = main_of(data, &format!("{set}\n{moves}"));
        let found = codes(&read);
        assert_eq!(found, expected, "{set}");
    }
}

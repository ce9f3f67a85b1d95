//! Motions to one of a few targets, executed: the correction is chosen by what the target is at run time, and what is not
//! one of those that the text knows stays as it stands.

use super::MINUTES;
use super::made::{Files, fixture, made_as, session, session_at, warmth};
use rapid_compensation::compensate::FormChoice;
use rapid_compensation::emit::{Clock, DriftGrowth, restore};
use robot_model::deform::Deformation;
use robot_model::robot::Robot;
use robot_model::units::{deg_from_rad, mm_from_m};
use virtual_controller::{Controller, Report};

fn one(name: &str, text: &str) -> (String, Vec<u8>) {
    (name.to_owned(), text.as_bytes().to_vec())
}

fn text(files: &Files) -> String {
    String::from_utf8_lossy(&files[0].1).into_owned()
}

/// Worst distance, mm, and angle, degrees, of the corrected moves.
fn worst(report: &Report) -> (f64, f64) {
    let passes = || report.passes.iter();
    for p in passes() {
        assert_eq!((&p.failure, &p.mismatch, p.unreached), (&None, &None, 0), "at {}", p.t_min);
    }
    let mm = passes().map(|p| p.corrected.max_m).fold(0.0, f64::max);
    let deg = passes().map(|p| p.corrected.max_rad).fold(0.0, f64::max);
    (mm_from_m(mm), deg_from_rad(deg))
}

#[test]
fn each_of_a_few_targets_has_its_own_correction() {
    let (paper, original) = (Deformation::paper(), fixture("simulate/one_of.mod"));
    let (program, kept) = made_as(FormChoice::Ramp, &original, &paper, &warmth()).unwrap();
    assert_eq!(kept, 0);
    let made = text(&program);
    for asked in [
        "    MoveL tcAtOne(Offs(pTo,0,0,nUp),tc",
        "    MoveL tcAtOne(pTo,tcPTo,tcPToRow),v100,fine,tGun\\WObj:=wTable;",
        "    MoveL tcAtOne(pPick,tcPPick,tcPPickRow),v100,",
        "    MoveL tcAtOne(pPlace,tcPPlace,tcPPlaceRow),v100,",
        "        MoveL tcAtOne(Offs(pFirst,i*12,j*10,0),tc",
        "  LOCAL CONST pose tcPTo{3,2}:=[",
        "  LOCAL CONST pose tcPPick{3,2}:=[",
        "  LOCAL CONST num tcPPickRow{",
    ] {
        assert!(made.contains(asked), "{asked}: {made}");
    }
    assert!(made.lines().all(|line| line.len() <= 255));
    let mut s = session(&program, &original, &paper, false);
    s.at_minutes(&MINUTES).unwrap();
    let report = s.into_report();
    let (mm, deg) = worst(&report);
    assert!(mm <= 5e-4 && deg <= 1e-4, "{mm} mm, {deg} deg");
    assert_eq!(report.unchanged.len(), 0, "{:?}", report.unchanged);
    // Home, three times two, two of the TEST, the place, and 5 x 3 of the raster.
    assert!(report.passes.iter().all(|p| p.n == 1 + 6 + 3 + 15), "{:?}", report.passes[0].n);
    assert!(mm_from_m(report.passes.last().unwrap().before.max_m) > 0.1);
    let restored = restore(&program[0].1).unwrap();
    assert!(restored.exact && restored.bytes == original[0].1);
}

/// A table of two laws has two functions of time, and each row two corrections.
#[test]
fn each_function_of_time_has_a_correction_for_each_target() {
    let original = fixture("simulate/one_of.mod");
    let lag = |t: f64, tau: f64| 1.0 - (-t / tau).exp();
    let mut table = "t_min,joint,dx_mm,dy_mm,dz_mm,rx_deg,ry_deg,rz_deg\n".to_owned();
    for t in (0..=60).map(|k| 10.0 * f64::from(k)) {
        let (quick, slow) = (0.1 * lag(t, 20.0), 0.02 * lag(t, 90.0));
        table += &format!("{t},2,0,0,{quick},0,0,0\n{t},5,0,0,0,{slow},0,{}\n", slow / 2.0);
    }
    let table = Deformation::from_csv(table.as_bytes(), None).unwrap();
    let clock =
        Clock::Warmth { growth: DriftGrowth::of(&table, None), tau_cool_min: Some(40.0), gap_min: 5.0 };
    let (program, kept) = made_as(FormChoice::Ramp, &original, &table, &clock).unwrap();
    assert_eq!(kept, 0);
    let made = text(&program);
    let asks = "tcAtSame(tcP,tcC{tcBest,2},tcC{tcBest,3})";
    assert!(made.contains("pose tcPTo{3,3}:=[") && made.contains(asks), "{made}");
    assert_eq!(again(&program, "main"), (8, 8));
    let mut s = session(&program, &original, &table, false);
    s.at_minutes(&MINUTES).unwrap();
    let report = s.into_report();
    let (mm, deg) = worst(&report);
    assert!(mm <= 5e-4 && deg <= 1e-4, "{mm} mm, {deg} deg");
    assert!(mm_from_m(report.passes.last().unwrap().before.max_m) > 0.1);
    assert!(restore(&program[0].1).unwrap().exact);
}

/// What a call of `tcAtOne` takes, in the same second of the clock: the fewest and the most statements of any.
fn again(program: &Files, entry: &str) -> (u64, u64) {
    let mut c = Controller::with_robot(&Robot::built_in("irb140").unwrap()).unwrap();
    for (name, text) in program {
        c.load(name, text).unwrap();
    }
    c.call("tcColdStart", 1).unwrap();
    c.calendar_mut().advance_min(60.0);
    c.call(entry, 1).unwrap();
    c.take_efforts();
    c.calendar_mut().held = true;
    assert!(c.call(entry, 1).unwrap().is_good());
    let one = c.take_efforts()["tcAtOne"];
    assert!(one.calls > 0);
    (one.fewest.statements, one.most.statements)
}

/// Every motion knows its row by one look, of three targets as of 32.
#[test]
fn eight_statements_find_the_target_among_those_that_it_can_be() {
    let paper = Deformation::paper();
    let original = fixture("simulate/one_of.mod");
    let (program, _) = made_as(FormChoice::Ramp, &original, &paper, &warmth()).unwrap();
    assert_eq!(again(&program, "main"), (8, 8), "{}", text(&program));
    // A target is one of 32, along both axes and turned.
    let many = format!(
        "MODULE Many\n{HEAD}\n  PROC main()\n    MoveAbsJ jHome,v500,fine,tGun;\n    FOR i FROM 0 TO 7 DO\n      \
         FOR j FROM 0 TO 3 DO\n        r RelTool(Offs(pA,6*i,-9*j,0),0,0,0\\Rz:=2*i);\n      ENDFOR\n    ENDFOR\n  \
         ENDPROC\n\n  PROC r(robtarget pX)\n    MoveL pX,v100,fine,tGun;\n  ENDPROC\nENDMODULE\n"
    );
    let (program, kept) =
        made_as(FormChoice::Ramp, &vec![one("Many.mod", &many)], &paper, &warmth()).unwrap();
    assert!(kept == 0 && text(&program).contains("pose tcPX{32,2}"), "{}", text(&program));
    assert_eq!(again(&program, "main"), (8, 8));
    // One that was touched up is looked for among all.
    let moved = text(&program).replace("r RelTool(Offs(pA,", "r RelTool(Offs(pA,2+");
    assert!(moved != text(&program));
    let (_, most) = again(&vec![one("Many.mod", &moved)], "main");
    assert!((60..=140).contains(&most), "{most}");
}

#[test]
fn auto_asks_the_model_where_its_configuration_is_reached_and_schedule_says_which_form_corrects_it() {
    let (paper, original) = (Deformation::paper(), fixture("simulate/one_of.mod"));
    let (auto, kept) = made_as(FormChoice::Auto, &original, &paper, &warmth()).unwrap();
    assert!(
        kept == 0 && text(&auto).contains("MoveL tcLive(pTo,tGun\\WObj:=wTable),v100"),
        "{}",
        text(&auto)
    );
    // Their confdata is not the one that is reached: CalcJointT would find no joints.
    for asked in
        ["MoveL tcAtOne(pPick,tcPPick,tcPPickRow),v100,", "MoveL tcAtOne(Offs(pFirst,i*12,j*10,0),tc"]
    {
        assert!(text(&auto).contains(asked), "{asked}: {}", text(&auto));
    }
    let mut s = session(&auto, &original, &paper, false);
    s.at_minutes(&MINUTES).unwrap();
    let (mm, deg) = worst(&s.into_report());
    assert!(mm <= 5e-4 && deg <= 1e-4, "{mm} mm, {deg} deg");
    let (schedule, kept) = made_as(FormChoice::Schedule, &original, &paper, &warmth()).unwrap();
    assert_eq!(kept, 6, "all but jHome");
    assert!(text(&schedule).contains("    MoveL pTo,v100,fine"), "{}", text(&schedule));
}

/// A target that comes from a module that was not given when the program was made, and one that was touched up.
#[test]
fn a_target_that_is_none_of_those_known_stays_as_it_stands() {
    let (paper, original) = (Deformation::paper(), fixture("simulate/one_of.mod"));
    let (mut program, _) = made_as(FormChoice::Ramp, &original, &paper, &warmth()).unwrap();
    let outside = one(
        "Outside.mod",
        "MODULE Outside\n  CONST robtarget pNew:=[[30,0,40],[0,0,1,0],[0,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n  \
         CONST robtarget pNear:=[[60.6,40.4,19.5],[0,0,1,0],[0,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n  \
         PROC rOther()\n    rGo pNew,100;\n  ENDPROC\n  PROC rTouched()\n    rGo pNear,20;\n  ENDPROC\nENDMODULE\n",
    );
    let mut original = original;
    original.push(outside.clone());
    program.push(outside);
    let played = |entry: &str| {
        let mut s = session_at(&program, &original, &paper, entry);
        s.at_minutes(&[180.0]).unwrap();
        s.into_report()
    };
    let other = played("rOther");
    assert_eq!(other.passes[0].after.max_m, other.passes[0].before.max_m);
    assert!(mm_from_m(other.passes[0].after.max_m) > 0.1);
    let message = other.messages.iter().filter(|m| m.text.contains("none of those that were known"));
    assert!(message.count() >= 1, "{:?}", other.messages);
    // A millimetre aside the correction is the same to a thousandth of itself.
    let touched = played("rTouched");
    assert!(mm_from_m(touched.passes[0].before.max_m) > 0.1);
    assert!(mm_from_m(touched.passes[0].after.max_m) < 1e-3, "{:?}", touched.passes[0].after);
}

/// What stands round the motions of the modules below.
const HEAD: &str = "  PERS tooldata tGun:=[TRUE,[[0,0,120],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]];
  CONST jointtarget jHome:=[[0,10,20,0,50,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget pA:=[[430,40,220],[0,0,1,0],[0,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget pB:=[[470,-40,220],[0,0,1,0],[-1,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  VAR robtarget pV;
  VAR bool bOften:=FALSE;
  VAR num n:=0;
";

/// A name, what stands in the module behind main's first motion, the routines, and whether the motion `MoveL pX` of them is
/// corrected; each is either right or left alone.
const NASTY: [(&str, &str, &str, bool); 27] = [
    (
        "assigned anew from constants",
        "r pA;",
        "PROC r(robtarget pX) IF n=0 pX:=pB; MoveL pX,v100,fine,tGun; ENDPROC",
        true,
    ),
    (
        "assigned anew from itself",
        "r pA;",
        "PROC r(robtarget pX) pX:=Offs(pX,0,0,5); MoveL pX,v100,fine,tGun; ENDPROC",
        true,
    ),
    (
        "changed in part",
        "r pA;",
        "PROC r(robtarget pX) pX.trans.z:=230; MoveL pX,v100,fine,tGun; ENDPROC",
        true,
    ),
    (
        "changed in part from what it was",
        "r;",
        "PROC r() VAR robtarget pX; pX:=pA; pX.trans.z:=pX.trans.z+12; MoveL pX,v100,fine,tGun; ENDPROC",
        true,
    ),
    (
        "moved on from call to call",
        "pV:=pA; r; pV:=Offs(pV,15,0,0); r; pV.trans.y:=pV.trans.y-20; r;",
        "PROC r() VAR robtarget pX; pX:=Offs(pV,0,0,3); MoveL pX,v100,fine,tGun; ENDPROC",
        true,
    ),
    (
        "turned about from cycle to cycle",
        "n:=1-n; r;",
        "PROC r() VAR robtarget pX; pX:=Offs(pA,0,0,10*n); MoveL pX,v100,fine,tGun; ENDPROC",
        false,
    ),
    (
        "moved on in a loop",
        "pV:=pA; WHILE n<3 DO n:=n+1; r; pV:=Offs(pV,5,0,0); ENDWHILE",
        "PROC r() VAR robtarget pX; pX:=pV; MoveL pX,v100,fine,tGun; ENDPROC",
        false,
    ),
    (
        "moved by what is read",
        "r;",
        "PROC r() VAR robtarget pX; pX:=pA; pX.trans.x:=pX.trans.x+AInput(aiX); MoveL pX,v100,fine,tGun; ENDPROC",
        false,
    ),
    (
        "known on one way, moved by a search on the other",
        "pV:=pA; IF bOften SearchL\\Stop,diX,pV,pB,v50,tGun; r;",
        "PROC r() VAR robtarget pX; pX:=pV; MoveL pX,v100,fine,tGun; ENDPROC",
        false,
    ),
    ("called by a name", "r pA; %\"r\"% pB;", "PROC r(robtarget pX) MoveL pX,v100,fine,tGun; ENDPROC", false),
    (
        "another called by a computed name",
        "r pA; %\"s\"+\"\"% pB;",
        "PROC r(robtarget pX) MoveL pX,v100,fine,tGun; ENDPROC PROC s(robtarget pY) n:=1; ENDPROC",
        false,
    ),
    (
        "recursion",
        "r pA,2;",
        "PROC r(robtarget pX,num d) MoveL pX,v100,fine,tGun; IF d>0 r Offs(pX,0,0,10),d-1; ENDPROC",
        false,
    ),
    (
        "a constant shadowed",
        "r pA; s;",
        "PROC r(robtarget pX) MoveL pX,v100,fine,tGun; ENDPROC PROC s() CONST robtarget pA:=[[400,0,260],[0,0,1,0],[0,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]]; r pA; ENDPROC",
        true,
    ),
    (
        "a parameter that shadows a constant",
        "r pB;",
        "PROC r(robtarget pA) VAR robtarget pX; pX:=pA; MoveL pX,v100,fine,tGun; ENDPROC",
        true,
    ),
    (
        "handed by reference, not written",
        "pV:=pA; r pV; pV:=pB; r pV;",
        "PROC r(INOUT robtarget pX) MoveL pX,v100,fine,tGun; ENDPROC",
        true,
    ),
    (
        "handed by reference and written",
        "pV:=pA; s pV; r pV;",
        "PROC r(robtarget pX) MoveL pX,v100,fine,tGun; ENDPROC PROC s(INOUT robtarget pY) pY:=Offs(pY,0,0,7); ENDPROC",
        false,
    ),
    (
        "handed on to one that writes",
        "pV:=pA; r pV;",
        "PROC r(INOUT robtarget pX) s pX; MoveL pX,v100,fine,tGun; ENDPROC PROC s(INOUT robtarget pY) pY.trans.x:=440; ENDPROC",
        false,
    ),
    (
        "an error handler assigns",
        "r;",
        "PROC r() VAR robtarget pX; pX:=pA; n:=1/n; MoveL pX,v100,fine,tGun; ERROR pX:=pB; n:=1; RETRY; ENDPROC",
        false,
    ),
    (
        "an error handler calls with another",
        "r pA;",
        "PROC r(robtarget pX) MoveL pX,v100,fine,tGun; ENDPROC PROC s() n:=1/n; ERROR r Offs(pV,n,0,0); TRYNEXT; ENDPROC",
        false,
    ),
    (
        "a trap assigns",
        "pV:=pA; r pV;",
        "PROC r(robtarget pX) MoveL pX,v100,fine,tGun; ENDPROC TRAP t pV:=pB; ENDTRAP",
        false,
    ),
    (
        "set by its name",
        "pV:=pA; r pV;",
        "PROC r(robtarget pX) MoveL pX,v100,fine,tGun; ENDPROC PROC s() SetDataVal \"pV\",pB; ENDPROC",
        false,
    ),
    (
        "an optional parameter",
        "r \\pX:=pA;",
        "PROC r(\\robtarget pX) MoveL pX,v100,fine,tGun; ENDPROC",
        false,
    ),
    (
        "a counter of WHILE",
        "WHILE n<3 DO n:=n+1; r Offs(pA,n,0,0); ENDWHILE",
        "PROC r(robtarget pX) MoveL pX,v100,fine,tGun; ENDPROC",
        false,
    ),
    (
        "a counter of nested FORs with one name",
        "FOR i FROM 0 TO 1 DO FOR i FROM 3 TO 4 DO r Offs(pA,10*i,0,0); ENDFOR r Offs(pB,10*i,0,0); ENDFOR",
        "PROC r(robtarget pX) MoveL pX,v100,fine,tGun; ENDPROC",
        true,
    ),
    (
        "where the arm stands",
        "pV:=CRobT(\\Tool:=tGun); r pV; r pA;",
        "PROC r(robtarget pX) MoveL pX,v100,fine,tGun; ENDPROC",
        false,
    ),
    (
        "feeds a calibration",
        "r pA; r pB;",
        "PROC r(robtarget pX) MoveL pX,v100,fine,tGun; ENDPROC PROC s() VAR wobjdata w; w.oframe:=DefFrame(pA,pB,pB); ENDPROC",
        false,
    ),
    (
        "text that was not understood names it",
        "r pA;",
        "PROC r(robtarget pX) MoveL pX,v100,fine,tGun; ENDPROC PROC s() r pB ?? 3; ENDPROC",
        false,
    ),
];

#[test]
fn nasty_programs_are_right_or_left_alone() {
    let paper = Deformation::paper();
    for (name, body, routines, corrected) in NASTY {
        let routines =
            routines.replace("; ", ";\n    ").replace(" PROC ", "\n  PROC ").replace(" TRAP ", "\n  TRAP ");
        let routines = routines.replacen(") ", ")\n    ", 1);
        let source = format!(
            "MODULE Nasty\n{HEAD}\n  PROC main()\n    MoveAbsJ jHome,v500,fine,tGun;\n    {}\n  ENDPROC\n\n  {routines}\nENDMODULE\n",
            body.replace("; ", ";\n    ")
        );
        let original = vec![one("Nasty.mod", &source)];
        let (program, _) = made_as(FormChoice::Ramp, &original, &paper, &warmth())
            .unwrap_or_else(|| panic!("{name}: {source}"));
        let made = text(&program);
        let asks = made.contains("MoveL tcAtOne(pX,");
        assert_eq!(asks, corrected, "{name}: {made}");
        assert!(asks || made.contains("MoveL pX,v100,fine,tGun;"), "{name}: {made}");
        let restored = restore(&program[0].1).unwrap();
        assert!(restored.exact && restored.bytes == original[0].1, "{name}");
        if corrected {
            let mut s = session(&program, &original, &paper, false);
            s.at_minutes(&[0.0, 45.0, 240.0]).unwrap();
            let report = s.into_report();
            let (mm, deg) = worst(&report);
            assert!(mm <= 5e-4 && deg <= 1e-4, "{name}: {mm} mm, {deg} deg");
            assert_eq!(report.unchanged.len(), 0, "{name}: {:?}", report.unchanged);
            assert!(mm_from_m(report.passes[2].before.max_m) > 0.1, "{name}");
        }
    }
}

/// Calls from another module count, those of another task do not, and what another task assigns is known at run time alone.
#[test]
fn calls_come_from_all_modules_of_the_task() {
    let paper = Deformation::paper();
    let files = |other: (&str, &str)| {
        let main = format!(
            "MODULE Main0\n{HEAD}\n  PERS robtarget pShared:=[[430,40,220],[0,0,1,0],[0,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n  \
             PROC main()\n    MoveAbsJ jHome,v500,fine,tGun;\n    r pA;\n    r pShared;\n    s;\n  ENDPROC\n  \
             PROC r(robtarget pX)\n    MoveL pX,v100,fine,tGun;\n  ENDPROC\nENDMODULE\n"
        );
        vec![one("RAPID/TASK1/PROGMOD/Main0.mod", &main), one(other.0, other.1)]
    };
    let beside = files((
        "RAPID/TASK1/PROGMOD/Other.mod",
        "MODULE Other\n  PROC s()\n    r Offs(pB,5,0,0);\n  ENDPROC\nENDMODULE\n",
    ));
    let (program, _) = made_as(FormChoice::Ramp, &beside, &paper, &warmth()).unwrap();
    assert!(text(&program).contains("LOCAL CONST pose tcPX{2,2}:=["), "{}", text(&program));
    let mut s = session(&program, &beside, &paper, false);
    s.at_minutes(&[120.0]).unwrap();
    let (mm, _) = worst(&s.into_report());
    assert!(mm <= 5e-4, "{mm}");

    let task = files((
        "RAPID/TASK2/PROGMOD/Other.mod",
        "MODULE Other\n  PERS robtarget pShared;\n  PROC main()\n    pShared.trans.x:=1;\n  ENDPROC\nENDMODULE\n",
    ));
    let (program, _) = made_as(FormChoice::Ramp, &task, &paper, &warmth()).unwrap();
    assert!(text(&program).contains("    MoveL pX,v100,fine,tGun;"), "{}", text(&program));
}

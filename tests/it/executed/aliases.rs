//! Parameters by reference, executed: who changes a datum changes each parameter that stands for it, whether the routine that has the
//! parameter assigns it or not. Motions behind such a change are kept, those that no other name can reach stay corrected.

use super::made::{Files, made_as, session, warmth};
use rapid_compensation::compensate::FormChoice;
use rapid_compensation::emit::restore;
use robot_model::deform::Deformation;
use robot_model::units::mm_from_m;

const HEAD: &str = "  PERS tooldata tGun:=[TRUE,[[0,0,120],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]];
  CONST jointtarget jHome:=[[5,10,20,5,50,5],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget pA:=[[430,60,300],[0.0871557,0,0.9961947,0],[0,-1,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget pB:=[[430,120,300],[0.0871557,0,0.9961947,0],[0,-1,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget pC:=[[380,120,250],[0.0871557,0,0.9961947,0],[0,-1,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  RECORD two
    num k;
    num l;
  ENDRECORD
  VAR num n:=0;
  VAR num m:=0;
  VAR bool ok;
  PERS num np:=0;
  VAR num na{2}:=[0,0];
  VAR two rec:=[0,0];
  VAR robtarget pV:=[[430,60,300],[0.0871557,0,0.9961947,0],[0,-1,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  PERS wobjdata wC:=[FALSE,TRUE,\"\",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];
  PERS wobjdata wD:=[FALSE,TRUE,\"\",[[0,250,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];
";

/// What is called, the routines, and how many motions stay as they are in `schedule` and in `ramp`.
type Case = (&'static str, &'static str, &'static str, [usize; 2]);

/// Stands for the work object of a number, and a motion in it.
const USE: &str = "wC.uframe.trans.y:=$; MoveJ pA,v100,fine,tGun\\WObj:=wC;";

const CHANGED: [Case; 19] = [
    ("INOUT", "r n;", "PROC r(INOUT num a) a:=0; n:=250; USE(a) ENDPROC", [1, 1]),
    ("VAR", "r n;", "PROC r(VAR num a) a:=0; n:=250; USE(a) ENDPROC", [1, 1]),
    ("PERS", "r np;", "PROC r(PERS num a) a:=0; np:=250; USE(a) ENDPROC", [1, 1]),
    (
        "in a routine",
        "r n;",
        "PROC r(INOUT num a) a:=0; s; USE(a) ENDPROC PROC s() n:=n+250; ENDPROC",
        [1, 1],
    ),
    ("by an instruction", "r n;", "PROC r(INOUT num a) a:=0; Add n,250; USE(a) ENDPROC", [1, 1]),
    ("by a function", "r n;", "PROC r(INOUT num a) a:=0; ok:=StrToVal(\"250\",n); USE(a) ENDPROC", [1, 1]),
    ("by its name", "r n;", "PROC r(INOUT num a) a:=0; SetDataVal \"n\",250; USE(a) ENDPROC", [1, 1]),
    ("an element", "r na{2};", "PROC r(INOUT num a) a:=0; na{2}:=250; USE(a) ENDPROC", [1, 1]),
    ("a component", "r rec.k;", "PROC r(INOUT num a) a:=0; rec:=[250,0]; USE(a) ENDPROC", [1, 1]),
    (
        "handed on",
        "r n;",
        "PROC r(INOUT num a) a:=0; s a; USE(a) ENDPROC PROC s(INOUT num b) n:=250; ENDPROC",
        [1, 1],
    ),
    (
        "handed anew",
        "r n;",
        "PROC r(INOUT num a) a:=0; s n; USE(a) ENDPROC PROC s(INOUT num b) b:=250; ENDPROC",
        [1, 1],
    ),
    ("two parameters", "r n,n;", "PROC r(INOUT num a,INOUT num b) b:=0; a:=250; USE(b) ENDPROC", [1, 1]),
    (
        "two that were handed two",
        "r n,n;",
        "PROC r(INOUT num a,INOUT num b) s a,b; ENDPROC PROC s(INOUT num c,INOUT num d) d:=0; c:=250; USE(d) ENDPROC",
        [1, 1],
    ),
    ("an optional one", "r \\a:=n;", "PROC r(\\INOUT num a) a:=0; n:=250; USE(a) ENDPROC", [1, 1]),
    ("called by a name", "%\"r\"% n;", "PROC r(INOUT num a) a:=0; n:=250; USE(a) ENDPROC", [1, 1]),
    (
        "a work object",
        "r wC;",
        "PROC r(PERS wobjdata w) w:=wobj0; MoveJ pA,v100,fine,tGun\\WObj:=w; s; MoveJ pA,v100,fine,tGun\\WObj:=w; ENDPROC \
         PROC s() wC.uframe.trans.y:=250; ENDPROC",
        [1, 1],
    ),
    ("a target", "r pV;", "PROC r(INOUT robtarget p) p:=pC; pV:=pB; MoveL p,v100,fine,tGun; ENDPROC", [1, 1]),
    (
        "two targets",
        "r pV,pV;",
        "PROC r(INOUT robtarget p,INOUT robtarget q) q:=pC; p:=pB; MoveL q,v100,fine,tGun; ENDPROC",
        [1, 1],
    ),
    (
        "an offset",
        "r n;",
        "PROC r(INOUT num a) a:=0; n:=60; MoveJ Offs(pA,0,a,0),v100,fine,tGun; ENDPROC",
        [1, 1],
    ),
];

const UNCHANGED: [Case; 10] = [
    ("nobody else", "r n;", "PROC r(INOUT num a) a:=250; USE(a) ENDPROC", [0, 0]),
    ("another datum", "r n;", "PROC r(INOUT num a) a:=0; m:=250; USE(a) ENDPROC", [0, 0]),
    ("before", "r n;", "PROC r(INOUT num a) n:=250; a:=0; USE(a) ENDPROC", [0, 0]),
    ("behind the call", "r n; n:=250; r n;", "PROC r(INOUT num a) a:=0; USE(a) ENDPROC", [0, 0]),
    ("two data", "r n,m; r m,n;", "PROC r(INOUT num a,INOUT num b) b:=0; a:=250; USE(b) ENDPROC", [0, 0]),
    (
        "two components",
        "r rec.k,rec.l;",
        "PROC r(INOUT num a,INOUT num b) b:=0; a:=250; USE(b) ENDPROC",
        [0, 0],
    ),
    (
        "two elements",
        "r na{1},na{2};",
        "PROC r(INOUT num a,INOUT num b) b:=0; a:=250; USE(b) ENDPROC",
        [0, 0],
    ),
    ("a copy", "r n;", "PROC r(num a) a:=0; n:=250; USE(a) ENDPROC", [0, 0]),
    (
        "another one handed on",
        "r n;",
        "PROC r(INOUT num a) a:=0; s m; USE(a) ENDPROC PROC s(INOUT num b) b:=250; ENDPROC",
        [0, 0],
    ),
    ("a target", "r pV;", "PROC r(INOUT robtarget p) p:=pC; MoveL p,v100,fine,tGun; ENDPROC", [1, 0]),
];

fn original(call: &str, routines: &str) -> Files {
    let mut routines = routines.to_owned();
    while let Some((before, (name, behind))) =
        routines.split_once("USE(").and_then(|(before, rest)| Some((before, rest.split_once(')')?)))
    {
        routines = format!("{before}{}{behind}", USE.replace('$', name));
    }
    let routines = routines.replace("; ", ";\n    ").replace(" PROC ", "\n  PROC ").replace(") ", ")\n    ");
    let main = format!("  PROC main()\n    MoveAbsJ jHome,v500,fine,tGun;\n    {call}\n  ENDPROC\n");
    vec![("Cell.mod".to_owned(), format!("MODULE Cell\n{HEAD}{main}  {routines}\nENDMODULE\n").into_bytes())]
}

/// A routine that calls itself has its own parameters back behind the call, whatever the inner call made of those of the same names.
#[test]
fn a_routine_that_calls_itself_goes_on_with_its_own_parameters() {
    let paper = Deformation::paper();
    for (name, call, routines) in [
        (
            "a copy",
            "r 0,1;",
            "PROC r(num a,num d) IF d>0 THEN a:=250; r 0,d-1; ENDIF wC.uframe.trans.y:=a; MoveJ pA,v100,fine,tGun\\WObj:=wC; ENDPROC",
        ),
        (
            "a variable of its own",
            "r 1;",
            "PROC r(num d) VAR num a:=0; IF d>0 THEN a:=250; r d-1; ENDIF wC.uframe.trans.y:=a; MoveJ pA,v100,fine,tGun\\WObj:=wC; ENDPROC",
        ),
        (
            "another between",
            "r 0,1;",
            "PROC r(num a,num d) IF d>0 THEN a:=250; s d-1; ENDIF wC.uframe.trans.y:=a; MoveJ pA,v100,fine,tGun\\WObj:=wC; ENDPROC \
             PROC s(num e) r 0,e; ENDPROC",
        ),
        (
            "by reference",
            "r n,m,1;",
            "PROC r(INOUT num a,INOUT num b,num d) a:=0; IF d>0 THEN a:=250; r b,b,d-1; ENDIF wC.uframe.trans.y:=a; \
             MoveJ pA,v100,fine,tGun\\WObj:=wC; ENDPROC",
        ),
    ] {
        let original = original(call, routines);
        for form in [FormChoice::Schedule, FormChoice::Ramp] {
            let (program, _) = made_as(form, &original, &paper, &warmth()).unwrap();
            let mut s = session(&program, &original, &paper, false);
            s.at_minutes(&[0.0, 180.0]).unwrap();
            for pass in s.into_report().passes {
                assert_eq!((&pass.failure, &pass.mismatch), (&None, &None), "{name}, {form:?}");
                let off_mm = mm_from_m(pass.corrected.max_m);
                assert!(off_mm < 0.0105, "{name}, {form:?}, minute {}: {off_mm} mm", pass.t_min);
            }
        }
    }
}

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
mod long {
    use super::*;

    #[test]
    #[ignore = "long"]
    fn a_parameter_by_reference_changes_with_all_other_names_of_its_datum() {
        let paper = Deformation::paper();
        for (name, call, routines, [in_schedule, in_ramp]) in CHANGED.into_iter().chain(UNCHANGED) {
            let original = original(call, routines);
            for (form, expected) in [
                (FormChoice::Schedule, in_schedule),
                (FormChoice::Ramp, in_ramp),
                (FormChoice::Auto, 0),
                (FormChoice::Live, 0),
            ] {
                let (program, kept) = made_as(form, &original, &paper, &warmth()).unwrap();
                assert_eq!(kept, expected, "{name}, {form:?}");
                let mut s = session(&program, &original, &paper, false);
                s.at_minutes(&[0.0, 45.0, 180.0]).unwrap();
                let report = s.into_report();
                assert_eq!(report.unchanged.len(), expected, "{name}, {form:?}: {:?}", report.unchanged);
                for pass in &report.passes {
                    assert_eq!((&pass.failure, &pass.mismatch), (&None, &None), "{name}, {form:?}");
                    let off_mm = mm_from_m(pass.corrected.max_m);
                    assert!(off_mm < 0.0105, "{name}, {form:?}, minute {}: {off_mm} mm", pass.t_min);
                }
                let restored = restore(&program[0].1).unwrap();
                assert!(restored.exact && restored.bytes == original[0].1, "{name}, {form:?}");
            }
        }
    }
}

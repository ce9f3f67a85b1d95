//! Targets that differ with the element of an array of several dimensions, alone or in an expression, executed: the correction has
//! the source's own indices.

use super::MINUTES;
use super::made::{Files, fixture, made_as, session, warmth};
use rapid_compensation::compensate::FormChoice;
use rapid_compensation::emit::restore;
use robot_model::deform::Deformation;
use robot_model::units::{deg_from_rad, mm_from_m};

fn text(files: &Files) -> String {
    String::from_utf8_lossy(&files[0].1).into_owned()
}

#[test]
fn the_correction_of_an_element_has_the_indices_of_the_source() {
    let (paper, original) = (Deformation::paper(), fixture("simulate/elements.mod"));
    let by_index = [
        "      MoveL tcAt(pGrid{r,2},tcPGrid{r,2}),v100",
        "        MoveL tcAt(pLayer{2,r,c},tcPLayer{2,r,c}),v100",
        "        MoveL tcAt(Offs(pGrid{r,c},0,0,12),tc43{r,c}),v100",
        "      MoveL tcAt(Offs(pFirst,nStep{i},0,nDepth{i}),tc47{i}),v100",
        "        MoveL tcAt(pGrid{nRow,nColumn},tcPGrid_2{nRow,nColumn}),v100",
    ];
    for form in [FormChoice::Ramp, FormChoice::Auto, FormChoice::Live] {
        let (program, kept) = made_as(form, &original, &paper, &warmth()).unwrap();
        assert_eq!(kept, 0, "{form:?}");
        let made = text(&program);
        // What nothing but its indices says asks the model in the form `live`, where the written configuration is reached.
        let asked = by_index.iter().filter(|line| made.contains(**line)).count();
        assert!(asked == if form == FormChoice::Live { 4 } else { 5 }, "{form:?}: {made}");
        assert!(made.lines().all(|line| line.len() <= 255));
        let mut s = session(&program, &original, &paper, false);
        s.at_minutes(&MINUTES).unwrap();
        let report = s.into_report();
        for pass in &report.passes {
            // Home, 3 x 4 in WHILE, three of a column, 3 x 2 of a layer and above the grid, forty steps.
            let all = 1 + 12 + 3 + 6 + 6 + 40;
            assert_eq!((&pass.failure, &pass.mismatch, pass.n), (&None, &None, all), "{form:?}");
            let (off_mm, off_deg) = (mm_from_m(pass.corrected.max_m), deg_from_rad(pass.corrected.max_rad));
            assert!(off_mm <= 5e-4 && off_deg <= 1e-4, "{form:?}: {off_mm} mm, {off_deg} deg");
        }
        assert_eq!(report.unchanged.len(), 0, "{form:?}: {:?}", report.unchanged);
        let last = report.passes.last().unwrap();
        assert!(mm_from_m(last.before.max_m) > 0.1);
        let restored = restore(&program[0].1).unwrap();
        assert!(restored.exact && restored.bytes == original[0].1, "{form:?}");
    }
}

/// The index may itself be an element of an array: the order of a path, say.
#[test]
fn an_order_of_elements_is_an_index_like_another() {
    let (paper, original) = (Deformation::paper(), fixture("simulate/elements.mod"));
    let source = text(&original).replace("MoveL pGrid{nRow,nColumn},", "MoveL pGrid{nRow,nBack{nColumn}},");
    let source = source.replace("  VAR num nRow:=1;", "  CONST num nBack{4}:=[4,3,1,2];\n  VAR num nRow:=1;");
    let original: Files = vec![("Elements.mod".to_owned(), source.into_bytes())];
    for (form, asked, within_mm) in [
        (FormChoice::Schedule, "MoveL tcpGrid_2{nRow,nBack{nColumn},tcK()},", 0.0055),
        (FormChoice::Ramp, "MoveL tcAt(pGrid{nRow,nBack{nColumn}},tcPGrid_2{nRow,nBack{nColumn}}),", 5e-4),
        (FormChoice::Auto, "MoveL tcAt(pGrid{nRow,nBack{nColumn}},tcPGrid_2{nRow,nBack{nColumn}}),", 5e-4),
    ] {
        let (program, _) = made_as(form, &original, &paper, &warmth()).unwrap();
        assert!(text(&program).contains(asked), "{form:?}: {}", text(&program));
        let mut s = session(&program, &original, &paper, false);
        s.at_minutes(&MINUTES).unwrap();
        for pass in s.into_report().passes {
            let off_mm = mm_from_m(pass.corrected.max_m);
            assert!(pass.failure.is_none() && off_mm <= within_mm, "{form:?}: {off_mm} mm at {}", pass.t_min);
        }
        assert!(restore(&program[0].1).unwrap().exact);
    }
}

/// An array has three dimensions at most, and one is the bucket's.
#[test]
fn a_schedule_takes_two_indices_beside_its_own() {
    let (paper, original) = (Deformation::paper(), fixture("simulate/elements.mod"));
    let (program, kept) = made_as(FormChoice::Schedule, &original, &paper, &warmth()).unwrap();
    assert_eq!(kept, 1, "three dimensions");
    let made = text(&program);
    for asked in [
        "MoveL tcpGrid{r,2,tcK()},",
        "MoveL tcpGrid_2{nRow,nColumn,tcK()},",
        "tcpGrid_2{3,4,",
        "        MoveL tc43{r,c,tcK()},v100",
        "      MoveL tc47{i,tcK()},v100",
    ] {
        assert!(made.contains(asked), "{asked}: {made}");
    }
    let mut s = session(&program, &original, &paper, false);
    s.at_minutes(&MINUTES).unwrap();
    for pass in s.into_report().passes {
        let off_mm = mm_from_m(pass.corrected.max_m);
        assert!(pass.failure.is_none() && off_mm <= 0.0055, "{off_mm} mm at {}", pass.t_min);
    }
    let restored = restore(&program[0].1).unwrap();
    assert!(restored.exact && restored.bytes == original[0].1);
    // What a touched-up element of an expression means has no place in the source to go to.
    let (before, array) = made.split_once("robtarget tc47{").unwrap();
    let touched = format!("{before}robtarget tc47{{{}", array.replacen("[[0,", "[[0.5,", 1));
    assert_ne!(touched, made);
    let refused = restore(touched.as_bytes()).unwrap_err().to_string();
    assert!(refused.contains("touched up"), "{refused}");
}

/// The element in force is touched up: its own correction is taken off, and what is left goes into the source's element.
#[test]
fn a_touched_up_element_of_two_dimensions_goes_back_into_its_own_element() {
    let (paper, original) = (Deformation::paper(), fixture("simulate/elements.mod"));
    let (program, _) = made_as(FormChoice::Schedule, &original, &paper, &warmth()).unwrap();
    let made = text(&program);
    let (before, array) = made.split_once("robtarget tcpGrid_2{").unwrap();
    // Element 1 of row 2, column 3, is the original.
    let touched =
        format!("{before}robtarget tcpGrid_2{{{}", array.replacen("[[40,50,20]", "[[40,50.75,20]", 1));
    assert_ne!(touched, made);
    let restored = restore(touched.as_bytes()).unwrap();
    let [one] = &restored.touched[..] else { panic!("{:?}", restored.touched) };
    // What it was is told from the other elements, which are written with five decimals.
    assert!((one.moved - 0.75).abs() < 5e-5, "{}", one.moved);
    let expected = text(&original).replacen("[[40,50,20]", "[[40,50.75,20]", 1);
    let numbers = |text: &str| text.replace(char::is_whitespace, "").replace("9E+09", "9E9");
    assert_eq!(numbers(&String::from_utf8_lossy(&restored.bytes)), numbers(&expected));
}

/// `\WObj?w`, as routines that stand round a motion have it.
#[test]
fn a_work_object_that_is_handed_on_if_present_is_asked_for_at_run_time() {
    let source = "MODULE Round\n  \
         PERS tooldata tGun:=[TRUE,[[0,0,120],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]];\n  \
         PERS wobjdata wTable:=[FALSE,TRUE,\"\",[[430,0,180],[0.99619470,0,0,0.08715574]],[[10,20,5],[1,0,0,0]]];\n  \
         CONST robtarget pIn:=[[0,40,60],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n  \
         CONST robtarget pOut:=[[450,40,250],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n  \
         VAR num n:=0;\n  \
         PROC main()\n    MoveAbsJ [[10,10,20,5,50,10],[9E9,9E9,9E9,9E9,9E9,9E9]],v500,fine,tGun;\n    n:=n+1;\n    \
         rTo Offs(pOut,n,0,0),v100;\n    rTo Offs(pIn,n,0,0),v200\\w:=wTable;\n  ENDPROC\n  \
         PROC rTo(robtarget p,speeddata v\\PERS wobjdata w)\n    MoveJ p,v,fine,tGun\\WObj?w;\n  ENDPROC\nENDMODULE\n";
    let (paper, original) =
        (Deformation::paper(), vec![("Round.mod".to_owned(), source.as_bytes().to_vec())]);
    for form in [FormChoice::Live, FormChoice::Auto] {
        let (program, kept) = made_as(form, &original, &paper, &warmth()).unwrap();
        assert_eq!(kept, 0, "{form:?}");
        let made = text(&program);
        assert!(made.contains("    MoveJ tcLive(p,tGun\\WObj?w),v,fine,tGun\\WObj?w;"), "{form:?}: {made}");
        let mut s = session(&program, &original, &paper, false);
        s.at_minutes(&MINUTES).unwrap();
        for pass in s.into_report().passes {
            assert_eq!((&pass.failure, &pass.mismatch, pass.n), (&None, &None, 3), "{form:?}");
            let off_mm = mm_from_m(pass.corrected.max_m);
            assert!(off_mm <= 5e-4, "{form:?}: {off_mm} mm at {}", pass.t_min);
        }
        assert!(restore(&program[0].1).unwrap().exact);
    }
}

/// A PERS that chooses the element is set on the pendant after the program was corrected: the arm goes where that says, corrected.
#[test]
fn an_element_that_a_pers_chooses_is_the_one_of_the_controllers_value() {
    let rest = "[0.0871557,0,0.9961947,0],[0,-1,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]";
    let source = format!(
        "MODULE Rows\n  PERS tooldata tGun:=[TRUE,[[0,0,120],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]];
  CONST robtarget pRow{{3}}:=[[[430,60,300],{rest},[[430,90,300],{rest},[[430,105,300],{rest}];\n  PERS num nRow:=2;
  PROC main()\n    MoveAbsJ [[5,10,20,5,50,5],[9E9,9E9,9E9,9E9,9E9,9E9]],v500,fine,tGun;\n    MoveJ pRow{{nRow}},v100,fine,tGun;
    MoveL Offs(pRow{{nRow}},0,0,15),v100,fine,tGun;\n  ENDPROC\nENDMODULE\n"
    );
    let (paper, original) = (Deformation::paper(), vec![("Rows.mod".to_owned(), source.into_bytes())]);
    let set_to = |files: &Files, row: u32| -> Files {
        vec![(
            files[0].0.clone(),
            text(files).replace("PERS num nRow:=2;", &format!("PERS num nRow:={row};")).into_bytes(),
        )]
    };
    for (form, within_mm) in [
        (FormChoice::Schedule, 0.0055),
        (FormChoice::Ramp, 5e-4),
        (FormChoice::Auto, 5e-4),
        (FormChoice::Live, 5e-4),
    ] {
        let (program, kept) = made_as(form, &original, &paper, &warmth()).unwrap();
        assert_eq!(kept, 0, "{form:?}");
        for row in 1..=3 {
            let mut s = session(&set_to(&program, row), &set_to(&original, row), &paper, false);
            s.at_minutes(&MINUTES).unwrap();
            for pass in s.into_report().passes {
                let off_mm = mm_from_m(pass.corrected.max_m);
                assert!(
                    pass.failure.is_none() && pass.n == 3 && off_mm <= within_mm,
                    "{form:?}, row {row}: {off_mm} mm at {}",
                    pass.t_min
                );
            }
        }
        assert!(restore(&program[0].1).unwrap().exact, "{form:?}");
    }
}

/// The file's value of a PERS says nothing of the element that a copy of it, a parameter, a loop or another dimension chooses.
#[test]
fn an_element_that_a_pers_chooses_by_a_detour_is_corrected_too() {
    let rest = "[0.0871557,0,0.9961947,0],[0,-1,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]";
    let row = |x: u32| format!("[[{x},60,300],{rest},[[{x},90,280],{rest},[[{x},105,260],{rest}");
    for (statements, routine) in [
        ("rTo nRow;", "PROC rTo(num i)\n    MoveL Offs(pRow{i},0,0,15),v100,fine,tGun;\n  ENDPROC"),
        (
            "k:=nRow;\n    MoveL Offs(pRow{k},0,0,15),v100,fine,tGun;\n    MoveL RelTool(pRow{k},0,0,-5),v100,fine,tGun;",
            "",
        ),
        ("FOR i FROM 1 TO nRow DO\n      MoveL Offs(pRow{i},0,0,15),v100,fine,tGun;\n    ENDFOR", ""),
        ("FOR i FROM 1 TO 3 STEP nRow DO\n      MoveL Offs(pRow{i},0,0,15),v100,fine,tGun;\n    ENDFOR", ""),
        ("FOR i FROM 1 TO 2 DO\n      MoveL pGrid{i,nRow},v100,fine,tGun;\n    ENDFOR", ""),
        ("rTo 2,nRow;", "PROC rTo(num i,num j)\n    MoveL pGrid{i,j},v100,fine,tGun;\n  ENDPROC"),
    ] {
        let source = format!(
            "MODULE Rows\n  PERS tooldata tGun:=[TRUE,[[0,0,120],[1,0,0,0]],[1,[0,0,50],[1,0,0,0],0,0,0]];
  CONST robtarget pRow{{3}}:=[{}];\n  CONST robtarget pGrid{{2,3}}:=[[{}],[{}]];\n  PERS num nRow:=2;\n  VAR num k;
  PROC main()\n    MoveAbsJ [[5,10,20,5,50,5],[9E9,9E9,9E9,9E9,9E9,9E9]],v500,fine,tGun;\n    {statements}\n  ENDPROC
  {routine}\nENDMODULE\n",
            row(430),
            row(430),
            row(400)
        );
        let (paper, original) = (Deformation::paper(), vec![("Rows.mod".to_owned(), source.into_bytes())]);
        for (form, within_mm) in [(FormChoice::Schedule, 0.0055), (FormChoice::Ramp, 5e-4)] {
            let (program, kept) = made_as(form, &original, &paper, &warmth()).unwrap();
            assert_eq!(kept, 0, "{form:?}: {statements}");
            for set in 1..=3 {
                let set_to = |files: &Files| -> Files {
                    let set = text(files).replace("PERS num nRow:=2;", &format!("PERS num nRow:={set};"));
                    vec![(files[0].0.clone(), set.into_bytes())]
                };
                let mut s = session(&set_to(&program), &set_to(&original), &paper, false);
                s.at_minutes(&[0.0, 240.0]).unwrap();
                for pass in s.into_report().passes {
                    let off_mm = mm_from_m(pass.corrected.max_m);
                    assert!(
                        pass.failure.is_none() && pass.mismatch.is_none() && off_mm <= within_mm,
                        "{form:?}, {set}, {statements}: {off_mm} mm at {}",
                        pass.t_min
                    );
                }
            }
        }
    }
}

//! What every emitted program keeps to, and the way back to the original.

mod line_ends;
mod long;
mod pages;
mod real;
pub mod tokens;
pub(crate) mod toy;

use crate::folders;
use rapid_compensation::compensate::FormChoice;
use rapid_compensation::compensate::plan::Plan;
use rapid_compensation::emit::{
    Clock, Core, DriftGrowth, EmitError, EmitOptions, EmittedFile, ModifiedIn, Provenance, RestoreError,
    emit, restore,
};
use rapid_program::Program;
use rapid_program::motion::Motion;
use rapid_syntax::diagnostic::FileId;
use rapid_syntax::tree::FileItem;
use rapid_syntax::{SourceFile, apply, walk};
use robot_model::deform::GrowthLaw;
use std::path::PathBuf;

const NAMED: &[u8] = include_bytes!("../../../fixtures/emit/named.mod");

fn options() -> EmitOptions {
    EmitOptions {
        form: FormChoice::Schedule,
        growth: Some(GrowthLaw::TwoStage { tau_min: 46.0 }),
        clock: Clock::Warmth {
            growth: DriftGrowth::Law(GrowthLaw::TwoStage { tau_min: 46.0 }),
            tau_cool_min: None,
            gap_min: 5.0,
        },
        core: None,
        robot: Provenance { name: "irb140".into(), sha256: "11".repeat(32) },
        deformation: Some(Provenance { name: "Table 2".into(), sha256: "22".repeat(32) }),
        model: None,
        settings: Vec::new(),
        absolute_accuracy: false,
        self_test: false,
        touch: None,
    }
}

/// With the probe a target is corrected otherwise than with the gun.
fn by_tool(program: &Program) -> impl Fn(&Motion) -> f64 {
    let files = program.files.clone();
    move |motion| {
        let text = files[motion.file.0 as usize].text(motion.range);
        if text.windows(6).any(|w| w == b"tProbe") { 0.5 } else { 0.0 }
    }
}

fn emitted(files: &[(&str, &[u8])], kept: &[usize]) -> (Program, Plan, Vec<EmittedFile>) {
    let program = toy::program(files);
    let plan = toy::plan(&program, 3, kept, by_tool(&program));
    let out = emit(&program, &plan, &options()).unwrap();
    (program, plan, out)
}

fn lone(source: &[u8]) -> Vec<u8> {
    emitted(&[("cell/named.mod", source)], &[]).2.remove(0).bytes
}

fn crlf(text: &[u8]) -> Vec<u8> {
    String::from_utf8_lossy(text).replace('\n', "\r\n").into_bytes()
}

/// The fixture with Latin-1 in comment, string and name, and other variants of layout.
fn variants() -> Vec<(String, Vec<u8>)> {
    let replace = |from: &str, to: &str| String::from_utf8_lossy(NAMED).replace(from, to).into_bytes();
    let mut latin = Vec::new();
    for part in replace("p20", "p\u{1}20").iter() {
        latin.push(if *part == 1 { 0xE4 } else { *part });
    }
    let mut all = vec![
        ("as it is".to_owned(), NAMED.to_vec()),
        ("CR LF".to_owned(), crlf(NAMED)),
        ("Latin-1".to_owned(), latin.clone()),
        ("Latin-1, CR LF".to_owned(), {
            let mut out = Vec::new();
            for b in latin {
                if b == b'\n' {
                    out.push(b'\r');
                }
                out.push(b);
            }
            out
        }),
        ("tabs".to_owned(), replace("  ", "\t")),
        ("no final newline".to_owned(), NAMED.trim_ascii_end().to_vec()),
        ("all on few lines".to_owned(), replace(";\n", "; ")),
        ("mixed line ends".to_owned(), replace("n:=n+1;\n", "n:=n+1;\r\n")),
        ("no indentation".to_owned(), replace("\n  ", "\n")),
    ];
    let one_line = b"MODULE M PROC main() MoveL [[1,2,3],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v1,fine,t; ENDPROC ENDMODULE";
    all.push(("one line".to_owned(), one_line.to_vec()));
    let no_data = b"MODULE M\n\nPROC main()\n MoveL [[1,2,3],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v1,fine,t;\nENDPROC\n\n\nENDMODULE\n";
    all.push(("no data".to_owned(), no_data.to_vec()));
    all
}

fn check_all_but_targets(name: &str, source: &[u8], program: &Program, plan: &Plan, emitted: &[u8]) {
    let targets: Vec<_> = program
        .motions
        .iter()
        .zip(&plan.motions)
        .filter(|(motion, planned)| !planned.targets.is_empty() && program.file(motion.file).path == name)
        .flat_map(|(motion, _)| motion.targets.iter().map(|t| t.range))
        .collect();
    let expected = tokens::tokens(&tokens::replaced(source, &targets, b"TARGET"));
    let got = tokens::tokens(&tokens::without_ours(source, emitted));
    let differ = expected.iter().zip(&got).position(|(a, b)| a != b);
    let show = |t: &[Vec<u8>], at: usize| {
        t[at.saturating_sub(3)..(at + 5).min(t.len())]
            .iter()
            .map(|t| String::from_utf8_lossy(t).into_owned())
            .collect::<Vec<_>>()
    };
    if let Some(at) = differ {
        panic!("{name}: {:?} became {:?}", show(&expected, at), show(&got, at));
    }
    assert_eq!(expected.len(), got.len(), "{name}");
}

#[test]
fn nothing_but_targets_changes() {
    for (name, source) in variants() {
        let (program, plan, out) = emitted(&[("cell/named.mod", &source)], &[1]);
        check_all_but_targets("cell/named.mod", &source, &program, &plan, &out[0].bytes);
        assert_eq!(apply(&source, &out[0].edits()).unwrap(), out[0].bytes, "{name}");
    }
}

#[test]
fn the_original_comes_back_byte_for_byte() {
    for (name, source) in variants() {
        let restored = restore(&lone(&source)).unwrap();
        assert_eq!(String::from_utf8_lossy(&restored.bytes), String::from_utf8_lossy(&source), "{name}");
        assert_eq!(restored.bytes, source, "{name}");
        assert!(restored.exact && restored.touched.is_empty(), "{name}");
        assert_eq!(restored.source_name, "named.mod");
    }
}

#[test]
#[ignore = "needs a folder of RAPID programs in DRIFTPOST_CORPUS"]
fn real_programs_keep_all_else_and_come_back() {
    assert!(check_files(&folders::files_below(&folders::corpus())) > 0);
}

/// Emits each file for itself; how many were compensated.
fn check_files(paths: &[PathBuf]) -> usize {
    let mut compensated = 0;
    for path in paths {
        let source = std::fs::read(path).unwrap();
        let name = path.display().to_string();
        let (program, plan, out) = emitted(&[(&name, &source)], &[]);
        let Some(file) = out.first() else { continue };
        compensated += 1;
        check_all_but_targets(&name, &source, &program, &plan, &file.bytes);
        check_lines(&name, &source, file);
        let restored = restore(&file.bytes).unwrap();
        assert!(restored.bytes == source && restored.exact, "{name}");
    }
    compensated
}

fn check_lines(name: &str, source: &[u8], file: &EmittedFile) {
    for edit in &file.edits() {
        for line in edit.text.split(|&b| b == b'\n' || b == b'\r') {
            assert!(line.len() <= 255 && line.is_ascii(), "{name}: {}", String::from_utf8_lossy(line));
        }
    }
    let before = SourceFile::read(FileId(0), name, source.to_vec());
    let after = SourceFile::read(FileId(0), name, file.bytes.clone());
    let opaque = |f: &SourceFile| walk::nodes(&f.tree).iter().filter(|n| n.what == "opaque").count();
    assert_eq!(opaque(&after), opaque(&before), "{name}");
    assert_eq!(after.warnings.len(), before.warnings.len(), "{name}");
    // Each module of a file has its own.
    let mut names = std::collections::BTreeSet::new();
    for edit in &file.edits() {
        let begins =
            |item: &&FileItem| matches!(item, FileItem::Module(m) if m.range.start <= edit.range.start);
        let module = before.tree.items.iter().filter(begins).count();
        for text in edit.text.split(|b| *b == b' ') {
            if let Some(at) = text.iter().position(|b| *b == b'{')
                && text.ends_with(b":=[") | text.windows(4).any(|w| w == b"}:=[")
            {
                let name = &text[..at];
                assert!(name.len() <= 32 && name.starts_with(b"tc"));
                let is_new = names.insert((module, name.to_ascii_lowercase()));
                assert!(is_new, "{}: {}", file.path, String::from_utf8_lossy(name));
            }
        }
    }
}

#[test]
fn lines_are_short_ascii_and_parse() {
    for (name, source) in variants() {
        let (_, _, out) = emitted(&[("cell/named.mod", &source)], &[]);
        check_lines(&name, &source, &out[0]);
        let ends = out[0].bytes.windows(2).filter(|w| w == b"\r\n").count();
        let lf = out[0].bytes.iter().filter(|b| **b == b'\n').count();
        match name.as_str() {
            "CR LF" | "Latin-1, CR LF" => assert_eq!(ends, lf, "{name}"),
            "mixed line ends" => assert_eq!(ends, 1, "{name}"),
            _ => assert_eq!(ends, 0, "{name}"),
        }
    }
}

#[test]
fn data_stand_after_data_and_routines_before_the_end() {
    let text = String::from_utf8(lone(NAMED)).unwrap();
    let at = |what: &str| text.find(what).unwrap_or_else(|| panic!("{what} is not in\n{text}"));
    assert!(text.contains("MODULE Welding ! station 3\n  ! driftpost 0"));
    assert!(text.contains("tc57\";\n  TASK PERS num tcMode:=-1;"));
    assert!(at("LOCAL CONST robtarget tcp20{4}") < at("  ! The main routine\n  PROC main()"));
    assert!(at("ENDPROC\n\n\n  FUNC num tcK()") > at("PROC weld()"));
    assert!(text.ends_with("ENDFUNC\nENDMODULE\n"));
    assert!(text.contains("    MoveAbsJ tcjHome{tcK()}\\NoEOffs,v500,z10,tGun;"));
    assert!(text.contains("    WHILE TRUE DO\n      n:=n+1;"));
    assert!(text.contains("IF n>3 MoveL tcp20{tcK()},v100,z5,tGun\\WObj:=wobj0;"));
    assert!(
        text.contains(
            "LOCAL CONST jointtarget tcjHome{4}:=[\n    [[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]],"
        )
    );
}

#[test]
fn names_are_shared_where_the_values_are() {
    let text = String::from_utf8(lone(NAMED)).unwrap();
    let weld = &text[text.find("PROC weld()").unwrap()..text.find("FUNC num tcK()").unwrap()];
    let named: Vec<&str> = weld
        .split("tc")
        .skip(1)
        .map(|part| part.split('{').next().unwrap())
        .filter(|name| !name.starts_with('K') && !name.starts_with('I'))
        .collect();
    // p10 with the gun; P10, spelled otherwise; p10 with the probe; p10 with the gun again; a name too long
    // for two letters more has its line's number, and so has the arc's inline end point
    assert_eq!(named, ["p10_2", "P10_3", "p10_4", "p10_2", "41", "p20", "42", "p20"]);
    // in main: the routine's own p10 came first, and the word tc57 in a string is left alone
    assert!(text.contains("MoveL tcp10{tcK()},v100,fine,tGun; ! the routine's own p10"));
    assert!(text.contains("MoveL tc32{tcK()},v100,z5,tGun; MoveJ tc32_2{tcK()},v100,z5,tGun;"));
}

#[test]
fn a_plan_that_compensates_nothing_emits_nothing() {
    let program = toy::program(&[("a.mod", NAMED)]);
    let all: Vec<usize> = (0..program.motions.len()).collect();
    let plan = toy::plan(&program, 2, &all, |_| 0.0);
    assert_eq!(emit(&program, &plan, &options()), Ok(Vec::new()));
}

#[test]
fn several_modules_share_one_core() {
    let second = b"MODULE Second\r\n PROC second()\r\n  MoveL p20,v100,z5,tGun;\r\n ENDPROC\r\nENDMODULE\r\n";
    let (program, plan, out) = emitted(&[("x/named.modx", NAMED), ("x/second.modx", second)], &[]);
    let paths: Vec<&str> = out.iter().map(|f| f.path.as_str()).collect();
    assert_eq!(paths, ["x/named.modx", "x/second.modx", "x/tcCore.modx"]);
    check_all_but_targets("x/named.modx", NAMED, &program, &plan, &out[0].bytes);
    check_all_but_targets("x/second.modx", second, &program, &plan, &out[1].bytes);
    let global = |bytes: &[u8]| {
        let text = String::from_utf8_lossy(bytes).into_owned();
        text.lines()
            .any(|l| ["PROC tc", "TASK PERS num tc", "VAR num tcI"].iter().any(|g| l.trim().starts_with(g)))
    };
    assert_eq!(out.iter().map(|f| global(&f.bytes)).collect::<Vec<_>>(), [false, false, true]);
    assert_eq!(restore(&out[0].bytes).unwrap().bytes, NAMED);
    assert_eq!(restore(&out[1].bytes).unwrap().bytes, second);
    assert_eq!(restore(&out[2].bytes), Err(RestoreError::IsCore));
    let embedded = EmitOptions { core: Some(Core::Embedded), ..options() };
    assert_eq!(emit(&program, &plan, &embedded), Err(EmitError::EmbeddedInSeveral { modules: 2 }));
}

#[test]
fn names_of_the_source_are_left_to_it() {
    let source = b"MODULE M\n  VAR num tcI:=5;\n  VAR num TCK;\n  VAR num tc5;\n  PROC tcColdStart() MoveL [[1,2,3],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v1,fine,t;\n  tcWarmStart;\n ENDPROC\nENDMODULE\n";
    let bytes = lone(source);
    let text = String::from_utf8_lossy(&bytes).into_owned();
    for expected in [
        "tc5_2{tcK_2()}",
        "VAR num tcI_2:=1;",
        "FUNC num tcK_2()",
        "RETURN tcI_2;",
        "PROC tcColdStart_2()",
        "PROC tcWarmStart()",
    ] {
        assert!(text.contains(expected), "{expected} is not in\n{text}");
    }
    assert!(!text.replace("tcI_2", "").contains("tcI:=tcNew"));
    let restored = restore(&bytes).unwrap();
    assert!(restored.exact && restored.bytes == source);
}

#[test]
fn an_emitted_module_is_refused() {
    let (_, _, out) = emitted(&[("x/named.mod", NAMED)], &[]);
    let program = toy::program(&[("x/named_tc.mod", &out[0].bytes)]);
    let plan = toy::plan(&program, 2, &[], |_| 0.0);
    let error = emit(&program, &plan, &options()).unwrap_err();
    assert_eq!(error.code(), "refuse::already-compensated");
    assert!(error.to_string().starts_with("x/named_tc.mod:7:"), "{error}");
}

/// Replaces the first `from` after `after`.
fn edited(text: &[u8], after: &str, from: &str, to: &str) -> Vec<u8> {
    let text = String::from_utf8_lossy(text).into_owned();
    let at = text.find(after).unwrap() + after.len();
    let (head, tail) = text.split_at(at);
    assert!(tail.contains(from));
    format!("{head}{}", tail.replacen(from, to, 1)).into_bytes()
}

#[test]
fn touched_up_targets_keep_their_new_value() {
    let bytes = lone(NAMED);
    // named in one routine's own declaration; inline; expression; shared and touched in one of its arrays only
    let bytes = edited(&bytes, "robtarget tcp10{4}:=[", "[399,", "[398.5,");
    let bytes = edited(&bytes, "robtarget tc32{4}:=[", "[401.000,", "[401.25,");
    let bytes = edited(&bytes, "robtarget tc31{4}:=[", "[[0,0,0]", "[[7,8,9]");
    let bytes = edited(&bytes, "robtarget tcp10_4{4}:=[", "[400,", "[400.75,");
    let restored = restore(&bytes).unwrap();
    assert!(!restored.exact);
    let text = String::from_utf8(restored.bytes).unwrap();
    let into: Vec<(&str, ModifiedIn)> =
        restored.touched.iter().map(|t| (t.array.as_deref().unwrap(), t.into)).collect();
    assert_eq!(
        into,
        [
            ("tcp10", ModifiedIn::Declaration),
            ("tc31", ModifiedIn::Motion),
            ("tc32", ModifiedIn::Motion),
            ("tcp10_4", ModifiedIn::Motion),
        ]
    );
    let expected = String::from_utf8_lossy(NAMED)
        .replace("[[399,", "[[398.5,")
        .replace("Offs(p20,0,0,n)", "[[7,8,9],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]")
        .replace("[[401.000,", "[[401.25,")
        .replace(
            "p10,v100,z5,tProbe",
            "[[400.75,0,350],[0.7071,0,0.7071,0],[0,0,0,1],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,z5,tProbe",
        );
    assert_eq!(text, expected);
}

/// Data without their semicolon, and text behind them that nothing understands: what is added goes behind both, and is taken out again.
#[test]
fn text_behind_the_last_data_stays_with_them() {
    let source = String::from_utf8_lossy(NAMED).replace("and tc57\";", "and tc57\"CONNECT;");
    assert!(source.contains("CONNECT;"));
    let bytes = lone(source.as_bytes());
    assert!(String::from_utf8_lossy(&bytes).contains("CONNECT;\n  TASK PERS num tcMode"));
    let restored = restore(&bytes).unwrap();
    assert!(restored.exact && restored.bytes == source.as_bytes());
}

/// An editor that writes names and keywords in capitals changes no value: an expression comes back as it stood.
#[test]
fn the_case_of_letters_in_what_was_added_says_nothing() {
    let text = String::from_utf8(lone(NAMED)).unwrap();
    let capital =
        |line: &str| if line.contains("robtarget tc") { line.to_uppercase() } else { line.to_owned() };
    let capitals: Vec<String> = text.lines().map(capital).collect();
    let capitals = capitals.join("\n") + "\n";
    assert!(capitals.contains("ROBTARGET TC31{4}:=["));
    let restored = restore(capitals.as_bytes()).unwrap();
    // A target that the array's name holds comes back in its letters.
    assert!(restored.bytes.eq_ignore_ascii_case(NAMED), "{}", String::from_utf8_lossy(&restored.bytes));
}

/// A name of the file's own that some form would add is not taken for what was left of it.
#[test]
fn data_named_as_another_form_asks_are_the_files_own() {
    for name in ["tcAt", "tcLive", "TCATJ", "tcK"] {
        let source = String::from_utf8_lossy(NAMED).replace("VAR num k;", &format!("VAR num {name};"));
        assert!(source.contains(name));
        let restored = restore(&lone(source.as_bytes())).unwrap();
        assert!(restored.exact && restored.bytes == source.as_bytes(), "{name}");
    }
}

/// In the form schedule the motions go by arrays: a target that is changed where it is declared moves none of them.
#[test]
fn a_target_changed_in_its_declaration_alone_is_told() {
    let bytes = lone(NAMED);
    let declared = edited(&bytes, "robtarget p10:=", "[400,", "[402.5,");
    let restored = restore(&declared).unwrap();
    let [reported] = restored.touched.as_slice() else { panic!("{:?}", restored.touched) };
    assert_eq!(
        (reported.into, reported.target.as_str(), reported.unit),
        (ModifiedIn::DeclarationAlone, "p10", "mm")
    );
    assert_eq!((reported.moved, reported.line), (2.5, line_of(&declared, "robtarget p10:=")));
    let text = String::from_utf8(restored.bytes).unwrap();
    assert!(text.contains("p10:=[[402.5,") && text.contains("MoveL p10,"), "{text}");
    // Its array touched up to another place: two originals.
    let both = edited(&declared, "robtarget tcp10_2{4}:=[", "[400,0,350.02]", "[401,0,350.02]");
    match restore(&both) {
        Err(error @ RestoreError::DeclaredOtherwise { .. }) => {
            assert_eq!(error.code(), "restore::disagree");
            let message = error.to_string();
            assert!(message.contains("402.5") && message.contains("[[401,"), "{message}");
        }
        what => panic!("{what:?}"),
    }
}

#[test]
fn a_touched_up_element_means_the_original_without_its_own_correction() {
    let program = toy::program(&[("cell/named.mod", NAMED)]);
    let plan = toy::plan(&program, 3, &[], |_| 0.0);
    let bytes = emit(&program, &plan, &options()).unwrap().remove(0).bytes;
    // The second bucket moves by 0.02 mm: 350.02 touched up to 351.52 means 351.5, at 401.25.
    let element = |bytes: &[u8], from: &str, to: &str| edited(bytes, "robtarget tc32{4}:=[", from, to);
    let one = element(&bytes, "[401,0,350.02]", "[401.25,0,351.52]");
    let restored = restore(&one).unwrap();
    let touched = &restored.touched[0];
    let rest = "[1,0,0,0],[0,0,0,1],[9E9,9E9,9E9,9E9,9E9,9E9]]";
    assert_eq!(touched.value, format!("[[401.25,0,351.5],{rest}"), "{touched:?}");
    assert_eq!((touched.line, touched.unit, restored.touched.len()), (line_of(&one, "MoveL tc32{"), "mm", 1));
    assert!((touched.moved - 0.25_f64.hypot(1.5)).abs() < 1e-3, "{touched:?}");
    let text = String::from_utf8(restored.bytes).unwrap();
    assert!(text.contains(&format!("MoveL [[401.25,0,351.5],{rest},v100,z5,tGun; MoveJ")), "{text}");
    // A second element that means the same is no contradiction, one that means another is.
    let same = element(&one, "[401,0,350.03]", "[401.25,0,351.53]");
    assert_eq!(restore(&same).unwrap().touched[0].value, touched.value);
    let other = element(&one, "[401,0,350.03]", "[401.25,0,351.93]");
    match restore(&other) {
        Err(RestoreError::Disagree { first, second, .. }) => {
            assert!(first.contains("351.5]") && second.contains("351.9]"), "{first} {second}");
        }
        what => panic!("{what:?}"),
    }
}

/// The line that `what` stands on, from 1.
fn line_of(text: &[u8], what: &str) -> u32 {
    let text = String::from_utf8_lossy(text).into_owned();
    text[..text.find(what).unwrap()].matches('\n').count() as u32 + 1
}

#[test]
fn a_controllers_own_layout_is_understood() {
    // the controller writes numbers and blanks its own way and lets PERS move on
    let bytes = String::from_utf8(lone(NAMED)).unwrap();
    let saved = bytes
        .replace("tcState{6}:=[0,0,0,0,0,0]", "tcState{6}:=[0.5,0.25,9000,3600,9000,7200]")
        .replace("[[401.000, 0, 350]", "[[401,0,350]")
        .replace("\n    ", "\n      ");
    let restored = restore(saved.as_bytes()).unwrap();
    assert!(!restored.exact && restored.touched.is_empty(), "{:?}", restored.touched);
    let squeezed = |text: &[u8]| tokens::tokens(text);
    let expected = String::from_utf8_lossy(NAMED).replace("[[401.000, 0, 350]", "[[401,0,350]");
    assert_eq!(squeezed(&restored.bytes), squeezed(expected.as_bytes()));
}

#[test]
fn what_is_not_ours_or_was_edited_beyond_is_said() {
    assert_eq!(restore(NAMED), Err(RestoreError::NotEmitted));
    assert_eq!(restore(b"\xFF\x00("), Err(RestoreError::NotEmitted));
    let bytes = lone(NAMED);
    let used = edited(&bytes, "PROC weld()", "MoveL tcp10_2{tcK()}", "MoveL Offs(tcp10_2{tcK()},0,0,1)");
    let no_end = edited(&bytes, "MODULE Welding", "! driftpost end", "! end");
    for (what, text) in [("used", used), ("no end", no_end)] {
        match restore(&text) {
            Err(RestoreError::Damaged { line, .. }) => assert!(line > 5, "{what}"),
            other => panic!("{what}: {other:?}"),
        }
    }
    // What a person puts in behind what was added, or among it, stays there.
    let (datum, routine) = ("  VAR num mine;\n", "  PROC mine() ENDPROC\n");
    for (at, from, put_in) in [
        ("  ! The main routine", "\n", datum),
        ("LOCAL VAR string tcSaid:=\"\";", "\n", datum),
        ("  PROC tcColdStart()", "ENDPROC\n", routine),
    ] {
        let restored = restore(&edited(&bytes, at, from, &format!("{from}{put_in}"))).unwrap();
        let text = String::from_utf8_lossy(&restored.bytes);
        assert_eq!(text.matches(put_in).count(), 1, "{at}");
        assert_eq!(text.replace(put_in, ""), String::from_utf8_lossy(NAMED), "{at}");
        assert!(!restored.exact && restored.altered.is_empty(), "{at}");
    }
    // what a person adds elsewhere stays, and the result is not called the original
    let line = edited(&bytes, "PROC weld()", "\n", "\n    TPWrite \"hello\";\n");
    let restored = restore(&line).unwrap();
    assert!(!restored.exact && restored.bytes.windows(5).any(|w| w == b"hello"));
}

#[test]
fn the_same_input_gives_the_same_bytes() {
    assert_eq!(lone(NAMED), lone(NAMED));
}

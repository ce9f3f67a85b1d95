//! A program of several files: what its modules share stands once, and each gives its source back.

use super::{NAMED, by_tool, options, toy};
use rapid_compensation::compensate::plan::Plan;
use rapid_compensation::emit::{Core, EmitError, EmitOptions, emit, restore};
use rapid_program::Program;
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::FileId;

const BUCKETS: usize = 3;

fn page(name: &str, eol: &str) -> Vec<u8> {
    let moves = |from: u32| -> String {
        let one = |n| {
            format!("    MoveL [[{n},0,350],[1,0,0,0],[0,0,0,1],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,z5,tGun;\n")
        };
        (from..from + 12).map(one).collect()
    };
    let lines = [
        format!("MODULE {name}\n  PROC {name}main(PERS tooldata tGun)\n"),
        moves(400),
        "    weld;\n".to_owned(),
        moves(420),
        "    MoveL p10,v100,z5,tGun;\n  ENDPROC\n\n  PROC go()\n    MoveL p20,v100,z5,tGun;\n".to_owned(),
        "  ENDPROC\nENDMODULE\n".to_owned(),
    ];
    lines.concat().replace('\n', eol).into_bytes()
}

fn planned(files: &[(&str, Vec<u8>)]) -> (Program, Plan) {
    let read =
        |(id, (path, bytes)): (u32, &(&str, Vec<u8>))| SourceFile::read(FileId(id), *path, bytes.as_slice());
    let program = toy::program_of((0..).zip(files).map(read).collect());
    let plan = toy::plan(&program, BUCKETS, &[], by_tool(&program));
    (program, plan)
}

#[test]
fn each_file_is_emitted_once_and_gives_its_source_back() {
    let files = [
        ("x/named.mod", NAMED.to_vec()),
        ("x/page.mod", page("Page", "\n")),
        ("x/second.mod", page("Second", "\r\n")),
        ("x/idle.mod", b"MODULE Idle\n  VAR num tcSay:=1;\nENDMODULE\n".to_vec()),
    ];
    let (program, plan) = planned(&files);
    let emitted = emit(&program, &plan, &options()).unwrap();
    let paths: Vec<&str> = emitted.iter().map(|file| file.path.as_str()).collect();
    assert_eq!(paths, ["x/named.mod", "x/page.mod", "x/second.mod", "x/tcCore.mod"]);
    for (file, (_, source)) in emitted.iter().zip(&files).take(3) {
        let restored = restore(&file.bytes).unwrap();
        assert!(restored.exact && restored.bytes == *source, "{}", file.path);
    }
    // The name that a file without motion takes is taken for all.
    let core = String::from_utf8_lossy(&emitted[3].bytes).into_owned();
    assert!(core.contains("tcSay_2") && !core.contains("tcSay(") && !core.contains("tcSay "), "{core}");
}

#[test]
fn what_concerns_all_files_is_refused_before_any_is_emitted() {
    let files = [("x/page.mod", page("Page", "\n")), ("x/second.mod", page("Second", "\n"))];
    let embedded = EmitOptions { core: Some(Core::Embedded), ..options() };
    let (program, plan) = planned(&files);
    assert_eq!(emit(&program, &plan, &embedded), Err(EmitError::EmbeddedInSeveral { modules: 2 }));
    let (program, plan) = planned(&files[..1]);
    emit(&program, &plan, &embedded).unwrap();
    let files = ["TASK1/page.mod", "TASK2/second.mod"].map(|path| (path, page("Page", "\n")));
    let (program, plan) = planned(&files);
    let several = EmitError::SeveralTasks { tasks: vec!["TASK1".to_owned(), "TASK2".to_owned()] };
    assert_eq!(emit(&program, &plan, &options()), Err(several));
}

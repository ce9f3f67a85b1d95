//! A program in several files, each of which goes on from where another has ended.

use super::*;
use rapid_program::Overrides;
use rapid_syntax::SourceFile;

/// A main page and the pages that it calls.
const PAGES: [(&str, &str); 5] = [
    ("A.mod", include_str!("../../../../../fixtures/parts/A.mod")),
    ("B.mod", include_str!("../../../../../fixtures/parts/B.mod")),
    ("C.mod", include_str!("../../../../../fixtures/parts/C.mod")),
    ("D.mod", include_str!("../../../../../fixtures/parts/D.mod")),
    ("Main.mod", include_str!("../../../../../fixtures/parts/Main.mod")),
];

#[test]
fn pages_start_from_where_the_page_before_has_ended() {
    let read =
        |(id, (path, text)): (u32, &(&str, &str))| SourceFile::read(FileId(id), *path, text.as_bytes());
    let program = Program::read((0..).zip(&PAGES).map(read).collect(), &Overrides::default());
    let options = Options { gap_min: Some(20.0), ..Options::default() };
    let plan = plan(&program, &irb140(), &Deformation::paper(), &options).unwrap();
    assert_eq!(plan.motions.len(), 57);
    // The loop of D's ten motions is entered from A's end and goes on from its own: the same way. One motion cannot be reached.
    let found = plan.motions.iter().filter(|m| m.status == Status::Compensated);
    assert_eq!(found.count(), 56);
    assert!(plan.motions.iter().any(|m| skip_code(&m.status) == "reach::none"));
    // Where a motion of another file comes before, the way between the two is known.
    let across = program.motions.iter().zip(&plan.motions).filter(|(motion, planned)| {
        let before = motion.previous.map(|before| &program.motions[before.index()]);
        before.is_some_and(|before| before.file != motion.file) && planned.mid_path.metres().is_some()
    });
    assert!(across.count() > 0);
}

//! A program planned part by part is planned as at once.

use super::*;
use crate::program::{InParts, Overrides, Part};
use rapid_syntax::SourceFile;

/// A main page and the pages that it calls, each of which goes on from where the one before has ended.
fn pages() -> Vec<(&'static str, String)> {
    let pages = [
        ("A.mod", include_str!("../../../../../fixtures/parts/A.mod")),
        ("B.mod", include_str!("../../../../../fixtures/parts/B.mod")),
        ("C.mod", include_str!("../../../../../fixtures/parts/C.mod")),
        ("D.mod", include_str!("../../../../../fixtures/parts/D.mod")),
        ("Main.mod", include_str!("../../../../../fixtures/parts/Main.mod")),
    ];
    pages.into_iter().map(|(path, text)| (path, text.to_owned())).collect()
}

struct Both {
    whole: Plan,
    told: Vec<String>,
    parts: Vec<String>,
    summary: Summary,
    said: Vec<String>,
}

/// A motion's plan, and where it stands.
fn told(program: &Program, plan: &Plan) -> Vec<String> {
    let own = program.motions.iter().zip(&plan.motions).filter(|(motion, _)| program.is_own(motion));
    own.map(|(motion, planned)| format!("{:?}:{} {planned:?}", motion.file, motion.line)).collect()
}

fn said(diagnostics: &[Diagnostic]) -> Vec<String> {
    diagnostics.iter().map(|d| format!("{} {} {:?}", d.code, d.message, d.span)).collect()
}

fn both(files: &[(&str, String)], options: &Options) -> Both {
    let read = |FileId(id): FileId| {
        let (path, text) = &files[id as usize];
        SourceFile::read(FileId(id), *path, text.as_bytes())
    };
    let (robot, deformation, overrides) = (irb140(), Deformation::paper(), Overrides::default());
    let program = Program::read((0..files.len()).map(|id| read(FileId(id as u32))).collect(), &overrides);
    let whole = plan(&program, &robot, &deformation, options).unwrap();

    let mut parts = InParts::new(files.len(), 1, &overrides, |id| Ok(read(id))).unwrap();
    let mut planner = Planner::survey(&mut parts, &robot, &deformation, options).unwrap();
    let (mut of_parts, mut heard) = (Vec::new(), Vec::new());
    planner
        .each(&mut parts, &mut |part: Part<'_>, plan| {
            assert_eq!(plan.schedule, whole.schedule);
            of_parts.extend(told(part.program, plan));
            heard.extend(plan.diagnostics.iter().cloned());
        })
        .unwrap();
    let (summary, first) = planner.conclude().unwrap();
    let all: Vec<Diagnostic> = first.into_iter().chain(heard).collect();
    let mut told = told(&program, &whole);
    told.sort();
    of_parts.sort();
    Both { told, parts: of_parts, summary, said: said(&all), whole }
}

#[test]
fn pages_that_start_from_each_other_are_planned_as_at_once() {
    let both = both(&pages(), &Options { gap_min: Some(20.0), ..Options::default() });
    // In the loop nothing says where the arm comes from.
    let compensated = both.told.iter().filter(|told| told.contains("Compensated"));
    assert_eq!(compensated.count(), 46);
    assert!(both.told.iter().any(|told| told.contains("reach::none")));
    for (found, expected) in both.parts.iter().zip(&both.told) {
        assert_eq!(found, expected);
    }
    assert_eq!(both.parts.len(), both.told.len());
    assert_eq!(both.said, said(&both.whole.diagnostics));
    let (expected, mut found) = (both.whole.summary, both.summary);
    let rival = found.rigid_shift_worst_m / expected.rigid_shift_worst_m;
    assert!((0.98..1.02).contains(&rival), "{rival}");
    found.rigid_shift_worst_m = expected.rigid_shift_worst_m;
    assert_eq!(found, expected);
}

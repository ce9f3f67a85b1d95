//! RoboDK's own exports, understood and planned as users' programs are, then emitted and read back.

use super::{check_all_but_targets, check_lines, options, toy};
use rapid_compensation::compensate::plan::{Corrected, Plan, Status};
use rapid_compensation::compensate::{Options, plan};
use rapid_compensation::emit::{EmittedFile, emit, restore};
use rapid_program::{Overrides, Program};
use rapid_syntax::diagnostic::FileId;
use rapid_syntax::tree::{ArgKind, DataDecl, Expr, ExprKind, FileItem, ModuleItem, Stmt, StmtKind};
use rapid_syntax::{SourceFile, parts_of_numbers};
use robot_model::deform::Deformation;
use robot_model::robot::Robot;
use robot_model::units::{deg_from_rad, mm_from_m};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

fn read(paths: &[PathBuf]) -> (Program, Plan) {
    let files = paths.iter().enumerate().map(|(id, path)| {
        SourceFile::read(FileId(id as u32), path.display().to_string(), std::fs::read(path).unwrap())
    });
    let program = Program::read(files.collect(), &Overrides::default());
    let robot = Robot::built_in("irb140").unwrap();
    let plan = plan(&program, &robot, &Deformation::paper(), &Options::default()).unwrap();
    (program, plan)
}

/// What stands in place of each compensated target, in the order of the text: the elements of its array.
fn arrays_in_order(emitted: &[u8]) -> Vec<Vec<Vec<f64>>> {
    let file = SourceFile::read(FileId(0), "emitted", emitted.to_vec());
    let mut declared: BTreeMap<&[u8], &DataDecl> = BTreeMap::new();
    let mut named = Vec::new();
    for item in &file.tree.items {
        let FileItem::Module(module) = item else { continue };
        for item in &module.items {
            match item {
                ModuleItem::Data(data) => {
                    declared.insert(file.text(data.name), data);
                }
                ModuleItem::Routine(routine) => in_body(&routine.body, &mut named),
                _ => {}
            }
        }
    }
    let arrays = named.iter().filter_map(|name: &&Expr| declared.get(file.text(name.range)));
    arrays
        .map(|data| match &data.init.as_ref().unwrap().kind {
            ExprKind::Aggregate(elements) => {
                elements.iter().map(|e| toy::numbers(file.text(e.range))).collect()
            }
            ExprKind::Numbers => {
                let init = data.init.as_ref().unwrap();
                let elements = parts_of_numbers(&file.bytes, init.range);
                elements.iter().map(|e| toy::numbers(file.text(e.range))).collect()
            }
            other => panic!("{other:?}"),
        })
        .collect()
}

fn in_body<'t>(body: &'t [Stmt], named: &mut Vec<&'t Expr>) {
    for stmt in body {
        match &stmt.kind {
            StmtKind::Call(call) => {
                for arg in &call.args {
                    if let ArgKind::Positional(Expr { kind: ExprKind::Index(element), .. }) = &arg.kind {
                        named.push(&element.base);
                    }
                }
            }
            StmtKind::If(branch) => {
                branch.arms.iter().for_each(|(_, body)| in_body(body, named));
                in_body(branch.otherwise.as_deref().unwrap_or_default(), named);
            }
            StmtKind::While(looped) => in_body(&looped.body, named),
            StmtKind::For(looped) => in_body(&looped.body, named),
            _ => {}
        }
    }
}

/// Every number of every bucket, read back in single precision, is the plan's.
fn check_numbers(program: &Program, plan: &Plan, file: &EmittedFile) -> usize {
    let arrays = arrays_in_order(&file.bytes);
    let planned: Vec<_> = program
        .motions
        .iter()
        .zip(&plan.motions)
        .enumerate()
        .filter(|(_, (m, p))| Some(m.file) == file.source && p.status == Status::Compensated)
        .flat_map(|(i, (m, _))| {
            let buckets = 0..plan.schedule.buckets.len();
            let each: Vec<_> = buckets.map(|k| plan.motions[i].corrected(k).unwrap()).collect();
            (0..m.targets.len()).map(move |t| each.iter().map(|of| of[t]).collect::<Vec<_>>())
        })
        .collect();
    assert_eq!(arrays.len(), planned.len(), "{}", file.path);
    for (elements, target) in arrays.iter().zip(&planned) {
        assert_eq!(elements.len(), target.len() + 1);
        for (numbers, corrected) in elements[1..].iter().zip(target) {
            let (exact, near): (Vec<f64>, Vec<f64>) = match corrected {
                Corrected::Pose { position_m, orientation_wxyz } => {
                    (position_m.map(mm_from_m).to_vec(), orientation_wxyz.to_vec())
                }
                Corrected::Joints { q_rad } => (q_rad.map(deg_from_rad).to_vec(), Vec::new()),
            };
            for (read, meant) in numbers.iter().zip(&exact) {
                let meant = if meant.abs() < 1e-10 { 0.0 } else { *meant };
                assert_eq!(*read as f32, meant as f32, "{}", file.path);
            }
            for (read, meant) in numbers[exact.len()..].iter().zip(&near) {
                assert!((read - meant).abs() <= 6.0e-8, "{}: {read} for {meant}", file.path);
            }
            // configuration and external axes are the original's
            let kept = exact.len() + near.len();
            assert_eq!(numbers[kept..], elements[0][kept..], "{}", file.path);
        }
    }
    planned.len()
}

fn check(paths: &[PathBuf]) -> usize {
    let (program, plan) = read(paths);
    let mut targets = 0;
    for file in emit(&program, &plan, &options()).unwrap() {
        let Some(id) = file.source else { continue };
        let source = &program.file(id).bytes;
        check_all_but_targets(&file.path, source, &program, &plan, &file.bytes);
        check_lines(&file.path, source, &file);
        targets += check_numbers(&program, &plan, &file);
        let restored = restore(&file.bytes).unwrap();
        assert!(
            restored.exact && *restored.bytes == **source && restored.touched.is_empty(),
            "{}",
            file.path
        );
    }
    targets
}

#[test]
fn exports_are_emitted_as_planned_and_come_back() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures/robodk");
    for (name, targets) in [
        ("irc5/Cube45.mod", 46),
        ("irc5/Cube45_noconf.mod", 46),
        ("irc5/Cube45_CalcRobT.mod", 45),
        ("irc5_simplified/Cube45.mod", 46),
        ("s4c/Cube45.prg", 46),
    ] {
        assert_eq!(check(&[folder.join(name)]), targets, "{name}");
    }
    // 8 moves, an arc counting two; the sub-program's move to all zeros is kept (wrist singularity)
    assert_eq!(check(&[folder.join("irc5/RichProg.mod")]), 8);
}

#[test]
#[ignore = "needs a folder of RoboDK exports in DRIFTPOST_CORPUS"]
fn pages_of_a_long_program_share_one_core() {
    let folder = crate::folders::corpus().join("mill20000");
    let pages = ["Main", "", "1", "2", "3", "4"].map(|page| folder.join(format!("Mill20000{page}.mod")));
    assert_eq!(check(&pages), 20_000);
}

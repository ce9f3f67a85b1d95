//! Plans for RoboDK's own exports, with the reference paper's robot and deformation.

use rapid_compensation::compensate::plan::{Plan, Status};
use rapid_compensation::compensate::{Options, plan};
use rapid_program::{Overrides, Program};
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::{FileId, Severity};
use robot_model::deform::Deformation;
use robot_model::robot::Robot;
use std::path::{Path, PathBuf};

fn read(folder: &Path, names: &[&str]) -> Program {
    let files = names.iter().enumerate().map(|(id, name)| {
        let bytes = std::fs::read(folder.join(name)).unwrap();
        SourceFile::read(FileId(id as u32), *name, bytes)
    });
    Program::read(files.collect(), &Overrides::default())
}

fn planned(program: &Program) -> Plan {
    plan(program, &Robot::built_in("irb140").unwrap(), &Deformation::paper(), &Options::default()).unwrap()
}

fn fixture(name: &str) -> (Program, Plan) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures/robodk");
    let program = read(&folder, &[name]);
    let plan = planned(&program);
    (program, plan)
}

fn kept(program: &Program, plan: &Plan) -> Vec<(u32, &'static str)> {
    program
        .motions
        .iter()
        .zip(&plan.motions)
        .filter_map(|(motion, planned)| match &planned.status {
            Status::Kept(why) => Some((motion.line, why.code)),
            Status::Compensated => None,
            Status::Refused(why) => panic!("line {}: {}", motion.line, why.reason),
        })
        .collect()
}

#[test]
fn every_cube_is_compensated_whole_and_on_one_branch() {
    for name in [
        "irc5/Cube45.mod",
        "irc5/Cube45_noconf.mod",
        "irc5/Cube45_CalcRobT.mod",
        "irc5_simplified/Cube45.mod",
        "irc5_simplified/Cube45_noconf.mod",
        "irc5_simplified/Cube45_CalcRobT.mod",
        "s4c/Cube45.prg",
        "s4c/Cube45_noconf.prg",
    ] {
        let (program, plan) = fixture(name);
        assert_eq!(kept(&program, &plan), [], "{name}");
        assert!(plan.diagnostics.iter().all(|d| d.severity < Severity::Error), "{name}");
        let noconf = name.contains("noconf");
        let disagrees = plan.diagnostics.iter().filter(|d| d.code == "conf::disagrees").count();
        assert_eq!(disagrees, usize::from(noconf), "{name}");
        for motion in &plan.motions {
            assert!(motion.targets[0].nominal_q_rad[4] < 0.0, "{name}");
            assert!(motion.mid_path.metres().unwrap_or(0.0) < 1e-5, "{name}");
        }
        assert!(plan.summary.worst_after_m <= 5e-6, "{name}: {}", plan.summary.worst_after_m);
        // 0.193 mm: what the reference paper's Table 2 makes of its targets when all of it is applied.
        assert!((plan.summary.worst_before_m - 1.93e-4).abs() < 5e-7, "{name}");
    }
}

#[test]
fn the_rich_program_keeps_its_move_to_all_zeros() {
    for name in ["irc5/RichProg.mod", "irc5_simplified/RichProg.mod"] {
        let (program, plan) = fixture(name);
        let kept = kept(&program, &plan);
        assert_eq!(kept.len(), 1, "{name}: {kept:?}");
        assert_eq!(kept[0].1, "singular::wrist", "{name}");
        assert!(plan.motions.iter().any(|m| m.targets.len() == 2), "{name}: the arc");
    }
}

#[test]
fn the_old_dialects_arc_without_its_frame_is_out_of_reach() {
    let (program, plan) = fixture("s4c/RichProg.prg");
    let kept = kept(&program, &plan);
    // Without its frame the arc is to be run inside the robot's own foot, which no joint's range allows.
    let arc = program.motions.iter().find(|m| m.targets.len() == 2).unwrap();
    let home = program.motions.last().unwrap();
    assert_eq!(kept, [(arc.line, "reach::range"), (home.line, "singular::wrist")]);
}

#[test]
#[ignore = "needs a folder of RoboDK exports in DRIFTPOST_CORPUS"]
fn twenty_thousand_moves_in_five_pages() {
    let folder = PathBuf::from(std::env::var_os("DRIFTPOST_CORPUS").unwrap()).join("mill20000");
    let names = [
        "Mill20000.mod",
        "Mill200001.mod",
        "Mill200002.mod",
        "Mill200003.mod",
        "Mill200004.mod",
        "Mill20000Main.mod",
    ];
    let program = read(&folder, &names);
    let plan = planned(&program);
    assert_eq!(kept(&program, &plan), []);
    assert!(plan.motions.len() >= 20_000);
    assert!(plan.summary.worst_after_m <= 5e-6, "{}", plan.summary.worst_after_m);
    assert!(plan.diagnostics.len() < 20, "{:?}", plan.diagnostics);
}

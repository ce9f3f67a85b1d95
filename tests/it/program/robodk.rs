//! RoboDK's own exports, as they are: every motion understood, tool and work object followed.

use rapid_program::motion::{MotionId, Origin, Path, TargetValue};
use rapid_program::{Overrides, Program};
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::FileId;
use std::path::{Path as FilePath, PathBuf};

fn read_files(folder: &FilePath, names: &[&str]) -> Program {
    let files = names.iter().enumerate().map(|(id, name)| {
        let bytes = std::fs::read(folder.join(name)).unwrap();
        SourceFile::read(FileId(id as u32), *name, bytes)
    });
    Program::read(files.collect(), &Overrides::default())
}

fn fixture(name: &str) -> Program {
    read_files(&FilePath::new(env!("CARGO_MANIFEST_DIR")).join("fixtures/robodk"), &[name])
}

fn codes(program: &Program) -> Vec<&str> {
    program.diagnostics.iter().map(|d| d.code).collect()
}

#[test]
fn the_cube_of_45_is_understood_in_every_dialect() {
    for name in ["irc5/Cube45.mod", "irc5/Cube45_noconf.mod", "irc5_simplified/Cube45.mod", "s4c/Cube45.prg"]
    {
        let program = fixture(name);
        assert_eq!(program.motions.len(), 46, "{name}");
        for (i, motion) in program.motions.iter().enumerate() {
            assert!(motion.skip_reason.is_none(), "{name}:{}", motion.line);
            assert_eq!(motion.previous.map(MotionId::index), i.checked_sub(1), "{name}:{}", motion.line);
            assert_eq!(*motion.targets[0].origin(), Origin::Inline);
            let literal = motion.targets[0].literal(motion.file).unwrap();
            assert_eq!(literal.range, motion.targets[0].range);
            assert_eq!(motion.setup.speed.unwrap().v_tcp_m_s, 0.25);
            assert!(motion.setup.wobj.is_some());
            assert_eq!(motion.setup.tool.as_ref().unwrap().load.mass_kg, 2.0);
        }
        assert_eq!(program.motions[0].setup.path, Path::AbsJoint);
        let Some(TargetValue::Rob(p)) = program.motions[1].targets[0].value() else { panic!("a robtarget") };
        let at = p.object_from_tcp.translation.vector;
        assert!((at - nalgebra::Vector3::new(0.4, 0.3, 0.25)).norm() < 1e-12, "{name}: {at}");
        assert_eq!(program.facts.entries.len(), 1);
        assert!(
            program.facts.kinematics.iter().all(|k| k.is_nominal()) && program.facts.kinematics.len() == 1
        );
    }
}

#[test]
fn calcrobt_gives_the_joints_that_reach_the_pose() {
    for name in ["irc5/Cube45_CalcRobT.mod", "irc5_simplified/Cube45_CalcRobT.mod"] {
        let program = fixture(name);
        assert_eq!(program.motions.len(), 45);
        let motion = &program.motions[1];
        assert!(motion.skip_reason.is_none());
        assert!(matches!(motion.targets[0].origin(), Origin::Expression(names) if names.is_empty()));
        let Some(TargetValue::FromJoints(j)) = motion.targets[0].value() else { panic!("joints") };
        assert!((j.q_rad[0].unwrap().to_degrees() - 24.120983).abs() < 1e-9);
    }
}

#[test]
fn the_rich_program_has_two_tools_two_frames_and_a_subroutine() {
    let program = fixture("irc5/RichProg.mod");
    let keeps: Vec<_> = program.motions.iter().filter_map(|m| m.skip_reason.as_ref()).collect();
    assert!(keeps.is_empty(), "{keeps:?}");
    assert_eq!(program.motions.len(), 8);
    let tcp_z = |i: usize| program.motions[i].setup.tool.as_ref().unwrap().frame_from_tcp.translation.z;
    let frame_x =
        |i: usize| program.motions[i].setup.wobj.as_ref().unwrap().frame_from_object().translation.x;
    for i in 0..5 {
        assert_eq!((tcp_z(i), frame_x(i)), (0.12, 0.4));
    }
    for i in 5..7 {
        assert_eq!((tcp_z(i), frame_x(i)), (0.095, 0.4));
    }
    // The subroutine inherits what its caller has set last.
    assert_eq!((tcp_z(7), frame_x(7)), (0.095, 0.0));
    assert_eq!(program.motions[7].previous, Some(MotionId::new(6)));
    let speeds: Vec<f64> = program.motions.iter().map(|m| m.setup.speed.unwrap().v_tcp_m_s).collect();
    assert_eq!(speeds[..3], [0.2; 3]);
    assert_eq!(speeds[3..], [0.08333; 5]);
    assert_eq!(program.motions[4].setup.kind, "MoveC");
    assert_eq!(program.motions[4].targets.len(), 2);
    assert!(program.motions[3].setup.zone.unwrap().pzone_tcp_m == 0.001);
    assert!(program.motions[2].setup.zone.unwrap().finep);
    assert_eq!(program.motions[1].setup.conf_monitored, Some(false));
    assert_eq!(program.facts.entries.len(), 1);
}

#[test]
fn an_undefined_speed_is_guessed_with_a_warning() {
    let program = fixture("irc5_simplified/RichProg.mod");
    assert!(program.motions.iter().all(|m| m.skip_reason.is_none()));
    assert_eq!(program.motions[3].setup.speed.unwrap().v_tcp_m_s, 0.083);
    assert_eq!(codes(&program).iter().filter(|c| **c == "resolve::not-predefined").count(), 1);
}

#[test]
fn s4c_sets_the_tool_whole_and_bakes_the_frame_in() {
    let program = fixture("s4c/RichProg.prg");
    let tcp: Vec<f64> =
        program.motions.iter().map(|m| m.setup.tool.as_ref().unwrap().frame_from_tcp.translation.z).collect();
    assert_eq!(tcp, [0.12, 0.12, 0.12, 0.12, 0.12, 0.095, 0.095, 0.095]);
    // Its PERS tool is set on the way: the next run begins with what this one left.
    assert_eq!(codes(&program).iter().filter(|c| **c == "state::pers-kept").count(), 1);
}

/// Six files, 20,000 moves: pages use what page 1 declares LOCAL, and the main page calls without
/// semicolons.
#[test]
#[ignore = "needs a folder of RoboDK exports in DRIFTPOST_CORPUS"]
fn twenty_thousand_moves_in_six_files() {
    let folder = crate::folders::corpus().join("mill20000");
    let mut names: Vec<PathBuf> =
        std::fs::read_dir(&folder).unwrap().map(|e| PathBuf::from(e.unwrap().file_name())).collect();
    names.sort();
    let names: Vec<&str> = names.iter().map(|n| n.to_str().unwrap()).collect();
    let program = read_files(&folder, &names);
    assert_eq!(program.motions.len(), 20_000);
    for motion in &program.motions {
        assert!(motion.skip_reason.is_none(), "line {}", motion.line);
        assert_eq!(motion.setup.tool.as_ref().unwrap().frame_from_tcp.translation.z, 0.15);
        assert_eq!(motion.setup.wobj.as_ref().unwrap().uframe.translation.x, 0.45);
    }
    let unlinked = program.motions.iter().filter(|m| m.previous.is_none()).count();
    assert_eq!(unlinked, 1, "one page follows the other");
    let elsewhere = codes(&program).iter().filter(|c| **c == "resolve::local-elsewhere").count();
    assert_eq!(elsewhere, 2, "tool and work object, once each");
    assert_eq!(program.facts.entries.len(), 1);
    assert_eq!(program.facts.entries[0].name, "Mill20000Main");
}

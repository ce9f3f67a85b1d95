//! Tables, models and programs that are none of this robot's.

use super::{bytes, compensation, error_codes, messages, program, refusal};
use driftpost::{Compensation, Deformation, ProgramFiles, Robot};
use robot_model::deform::GrowthLaw;

#[test]
fn a_table_that_cannot_be_a_robots_is_named_or_refused() {
    let with = |name: &str| {
        let table = Deformation::from_csv(&bytes(name), Some(GrowthLaw::TwoStage { tau_min: 46.0 })).unwrap();
        Compensation::new(Robot::built_in("irb140").unwrap(), table)
    };
    let cube =
        ProgramFiles::one("Cube45.mod", include_bytes!("../../../fixtures/robodk/irc5/Cube45.mod").to_vec());
    let metres = refusal(&with("metres.csv"), &cube);
    assert_eq!(error_codes(&metres), ["compensate::no-drift"]);
    assert!(metres.messages.iter().any(|m| m.diagnostic.code == "deform::small"), "{:?}", metres.messages);
    assert_eq!(error_codes(&refusal(&with("zero.csv"), &cube)), ["deform::nothing"]);
    let large = refusal(&with("large.csv"), &cube);
    assert!(error_codes(&large).contains(&"refuse::correction"));
    assert!(large.messages.iter().any(|m| m.diagnostic.code == "deform::large"));
    // Where nothing can be corrected with it, that is said too: 5 deg in joint 3 are no warming.
    let table = "Dx,Dy,Dz,DOx,DOy,DOz\n0,0,0,0,0,0\n0,0,0,0,0,0\n0,0,0,0,5,0\n0,0,0,0,0,0\n0,0,0,0,0,0\n0,0,0,0,0,0\n";
    let table = table.replace("Dx,Dy,Dz,DOx,DOy,DOz", "Dx [mm],Dy[mm],Dz[mm],DOx[deg],DOy[deg],DOz[deg]");
    let table = Deformation::from_csv(table.as_bytes(), Some(GrowthLaw::None)).unwrap();
    let turned = refusal(&Compensation::new(Robot::built_in("irb140").unwrap(), table), &cube);
    assert!(
        turned.messages.iter().any(|m| m.diagnostic.code == "deform::large"),
        "{:?}",
        error_codes(&turned)
    );
    assert!(
        turned.kept.iter().any(|why| why.code == "keep::joint-change" && !why.reason.contains("singular"))
    );
    // The paper's drift is 0.193 mm on this program: more than half of it is left by 0.1 mm.
    let mut loose = compensation();
    loose.options.tolerance_m = 1e-4;
    let made = loose.run(&cube).unwrap();
    assert_eq!(messages(&made, "schedule::loose-tolerance").len(), 1);
    assert_eq!(messages(&compensation().run(&cube).unwrap(), "schedule::loose-tolerance").len(), 0);
}

#[test]
fn what_belongs_to_another_robot_is_refused_unless_allowed() {
    let cube =
        ProgramFiles::one("Cube45.mod", include_bytes!("../../../fixtures/robodk/irc5/Cube45.mod").to_vec());
    // The program says it was made for an IRB 140, and the table is one's.
    let mut other = Compensation::new(Robot::built_in("irb1200").unwrap(), Deformation::paper());
    other.default_table = true;
    let refused = refusal(&other, &cube);
    assert_eq!(error_codes(&refused), ["robot::other", "deform::other-robot"]);
    assert!(refused.messages[0].diagnostic.help.as_ref().is_some_and(|h| h.contains("--allow-other-robot")));
    // By another name it is the same arm.
    let mut renamed = Robot::built_in("irb140").unwrap();
    renamed.name = "cell 7".to_owned();
    let mut same = Compensation::new(renamed, Deformation::paper());
    same.default_table = true;
    same.run(&cube).unwrap();
    other.allow_other_robot = true;
    let warned = other.run(&cube).map(|made| messages(&made, "deform::other-robot").len());
    assert!(
        warned.is_ok_and(|n| n == 1)
            || other.run(&cube).is_err_and(|r| !error_codes(&r).contains(&"robot::other"))
    );
}

/// A line at a module's head names the robot of the program; one that the program hands its part to is none of its own.
#[test]
fn a_head_that_names_another_robot_is_refused_unless_allowed() {
    let text = String::from_utf8(bytes("other_robot.mod")).unwrap();
    let with =
        |line: &str| ProgramFiles::one("a.mod", text.replace("Robot: IRB 1600-6/1.2", line).into_bytes());
    let refused = refusal(&compensation(), &program(&["other_robot.mod"]));
    assert_eq!(error_codes(&refused), ["robot::other"]);
    let output_text = &refused.messages[0].diagnostic.message;
    assert_eq!(output_text, "made for IRB 1600-6/1.2, and taken as one for ABB IRB 140-6/0.8");
    let mut allowed = compensation();
    allowed.allow_other_robot = true;
    assert_eq!(messages(&allowed.run(&program(&["other_robot.mod"])).unwrap(), "robot::other").len(), 1);
    let others = ["Program for the ABB IRB 6700-235/2.65", "IRB2600-12/1.65", "Manipulator = IRB120"];
    for line in others {
        assert_eq!(error_codes(&refusal(&compensation(), &with(line))), ["robot::other"], "{line}");
    }
    for line in [
        "Robot: IRB140",
        "Robot: r1",
        "hands over to the IRB 1600 of station 4",
        "Robot: IRB 140 or IRB 1600",
    ] {
        assert!(compensation().run(&with(line)).is_ok(), "{line}");
    }
}

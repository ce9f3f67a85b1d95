//! Serial arms of four, five and seven joints, one of them with a joint that slides: what is planted by a physics that is not
//! the diagnosis's is found, written as a model and holds on other poses; where programs are written, such arms are refused.

use assert_cmd::Command;
use exam::effect::Effect;
use exam::generate::{DataSet, data_set};
use exam::harmonics::Harmonics;
use exam::rng::Rng;
use measurements::{Measurements, check_rows};
use metrology::admissible::Space;
use metrology::diagnose::{
    DiagnosisOptions, Findings, RefitScope, Verdict, diagnose, diagnose_and_identify, validate,
};
use metrology::plan::{PlanOptions, Sweeps, plan_from, poses_csv};
use nalgebra::Vector3;
use robot_model::robot::{Axis, SerialArm};
use robot_model::units::m_from_mm;
use std::fs;

fn arm(name: &str) -> SerialArm {
    SerialArm::from_toml(&fs::read_to_string(format!("fixtures/robots/{name}.toml")).unwrap()).unwrap()
}

fn planted(arm: &SerialArm, effect: Effect, n: usize, seed: u64) -> DataSet {
    // Perfect geometry, as in the tests of six joints: on an arm of three metres a third of the usual tolerance is more than the effect.
    let recipe = crate::recipe::planted(vec![(effect, 8.0)], n);
    data_set(arm, "arm", &recipe, &mut Rng::new(seed, 0)).unwrap()
}

const TOLD: DiagnosisOptions = DiagnosisOptions { tool_m: None, sigma_m: Some(2e-5) };

fn read(set: &DataSet) -> Measurements {
    Measurements::from_csv(set.csv.as_bytes()).unwrap()
}

fn summary(found: &Findings) -> String {
    let causes: Vec<_> = found.causes.iter().map(|c| (c.effect.name(), c.joint, c.posterior)).collect();
    format!("{:?}, {}: {causes:?}", found.verdict, found.reason)
}

/// The one cause that is planted is the one that is named, and as large as it was made: `scale` is from the generator's SI
/// amplitude to the unit; `None` where the two count different things.
fn assert_named(
    name: &str,
    effect: Effect,
    joint: Option<usize>,
    (unit, scale): (&str, Option<f64>),
    seed: u64,
) {
    let arm = arm(name);
    let set = planted(&arm, effect, 60, seed);
    let found = diagnose(&read(&set), &arm, &TOLD);
    let first = found.causes.first().unwrap_or_else(|| panic!("{name}: {}", summary(&found)));
    assert_eq!(
        (Some(first.effect.name()), first.joint),
        (effect.name(), joint.and_then(Axis::numbered)),
        "{}",
        summary(&found)
    );
    assert_eq!(found.verdict, Verdict::Explained, "{name}: {}", summary(&found));
    assert_eq!(first.unit.symbol(), unit, "{name}");
    if let Some(scale) = scale {
        let (is, was) = (first.size.unwrap(), set.truth.effects[0].amplitude * scale);
        assert!((is / was - 1.0).abs() < 0.15, "{name}: {is} {unit}, made {was} {unit}");
    }
}

const RAD: (&str, Option<f64>) = ("rad", Some(1.0));
const MM: (&str, Option<f64>) = ("mm", Some(1000.0));

#[test]
fn what_is_planted_in_an_arm_of_four_joints_is_named() {
    assert_named("palletiser", Effect::JointOffset { joint: 3 }, Some(3), RAD, 1);
    assert_named(
        "palletiser",
        Effect::GearMesh { joint: 1, n: 9, phase_rad: 0.4, harmonics: Harmonics::NONE },
        Some(1),
        RAD,
        2,
    );
}

#[test]
fn what_is_planted_at_a_joint_that_slides_is_named_in_mm_with_what_looks_the_same() {
    let arm = arm("sliding_arm");
    let set = planted(&arm, Effect::JointOffset { joint: 3 }, 60, 9);
    let found = diagnose(&read(&set), &arm, &TOLD);
    let first = found.causes.first().unwrap();
    assert_eq!(
        (first.effect.name(), first.joint, first.unit.symbol()),
        ("joint_offset", Axis::numbered(3), "mm"),
        "{}",
        summary(&found)
    );
    assert!(first.posterior > 0.8, "{}", summary(&found));
    let (is, was) = (first.size.unwrap(), set.truth.effects[0].amplitude * 1000.0);
    assert!((is / was - 1.0).abs() < 0.15, "{is} mm, made {was} mm");
    // Link 2 lies along the axis: its length is the same motion to the last digit, and no pose can tell.
    let rivals: Vec<_> = found.causes.iter().skip(1).map(|c| (c.effect.name(), c.joint)).collect();
    assert!(rivals.iter().all(|r| *r == ("thermal_link_growth", Axis::numbered(2))), "{}", summary(&found));
}

#[test]
fn what_lies_in_base_and_tool_of_a_scara_is_no_finding() {
    let arm = arm("scara");
    let set = planted(&arm, Effect::JointOffset { joint: 2 }, 60, 10);
    let found = diagnose(&read(&set), &arm, &TOLD);
    // Joint 1's zero is the base's yaw, the spindle's zero its height, and the last joint's the tool.
    for joint in [1, 3, 4] {
        let of = |u: &&metrology::diagnose::Untestable| {
            u.effect.name() == "joint_offset" && u.joints.iter().any(|axis| axis.index() + 1 == joint)
        };
        assert!(
            found.untestable_detail.iter().any(|u| of(&u)),
            "joint {joint}: {:?}",
            found.untestable_detail
        );
    }
}

#[test]
fn a_model_of_an_arm_with_a_joint_that_slides_holds_on_other_poses() {
    let arm = arm("sliding_arm");
    let effect = Effect::JointOffset { joint: 3 };
    let set = planted(&arm, effect, 120, 11);
    let all = read(&set);
    let part = |odd: usize| {
        let rows = all.rows.iter().filter(|row| (row.line % 2) as usize == odd).cloned().collect();
        Measurements { rows, ..all.clone() }
    };
    let (found, model) = diagnose_and_identify(&part(0), &arm, &TOLD);
    let model = model.unwrap_or_else(|| panic!("{:?}", found.no_model));
    let text = model.to_toml();
    assert!(text.contains("joints = [\"revolute\", \"revolute\", \"prismatic\""), "{text}");
    assert!(text.contains("offset_mm = "), "{text}");
    let offset = model.terms.iter().find(|t| t.kind.name() == "joint_offset").unwrap();
    let (is, was) = (offset.value(0), set.truth.effects[0].amplitude);
    assert!((is / was - 1.0).abs() < 0.2, "{is} m, planted {was} m");
    let file = part(1);
    let used = check_rows(&file, &arm).used;
    let checked = validate((&file, &used), &arm, &model, RefitScope::BaseAndTool, &[]).unwrap();
    // Noise of 0.02 mm in each coordinate is 0.035 mm in space.
    assert!(checked.all.model.rms_mm < 0.05, "{:?}", checked.all);
    assert!(checked.all.nominal.rms_mm > 2.0 * checked.all.model.rms_mm, "{:?}", checked.all);
}

#[test]
fn a_file_of_other_joints_than_the_arms_is_told() {
    let set = planted(&arm("scara"), Effect::JointOffset { joint: 2 }, 60, 13);
    let five = arm("five_axes");
    let found = diagnose(&read(&set), &five, &TOLD);
    assert_eq!(found.verdict, Verdict::DataFault);
    assert!(found.reason.contains("q1_deg, q2_deg, q3_mm, q4_deg"), "{}", found.reason);
    let model = robot_model::deform::identified::Identified::default();
    let of_six =
        validate((&read(&set), &[]), &arm("scara"), &model, RefitScope::BaseAndTool, &[]).unwrap_err();
    assert!(of_six.to_string().contains("of an arm of 6 joints"), "{of_six}");
}

/// Of an exam it is told with the name of the set: here one of a SCARA, which its task calls an IRB 140.
#[test]
fn a_set_of_other_joints_than_its_robots_ends_the_exam_by_its_name() {
    let folder = tempfile::tempdir().unwrap();
    let (sets, scara) = (folder.path().join("sets"), "fixtures/robots/scara.toml");
    let planted = ["--robot", scara, "--effects", "joint_offset:2", "--sets", "1", "--n", "20"];
    driftpost().arg("synth").arg(&sets).args(planted).assert().success();
    let task = sets.join("set_0000/task.toml");
    let text = fs::read_to_string(&task).unwrap();
    assert!(text.contains(scara), "{text}");
    fs::write(&task, text.replace(scara, "irb140")).unwrap();
    let process_output = driftpost().arg("exam").arg(&sets).output().unwrap();
    let message = String::from_utf8(process_output.stderr).unwrap();
    assert_eq!(process_output.status.code(), Some(2), "{message}");
    assert!(message.contains("error[measure::fault]: set_0000: "), "{message}");
}

fn driftpost() -> Command {
    Command::cargo_bin("driftpost").unwrap()
}

#[test]
fn where_programs_are_written_other_arms_are_refused_by_name() {
    for arguments in [
        &["compensate", "fixtures/robodk/irc5/Cube45.mod", "-o", "never_written.mod"][..],
        &["simulate", "fixtures/robodk/irc5/Cube45.mod"],
        &["closed-loop", "fixtures/robodk/irc5/Cube45.mod", "--inject", "joint_offset:2"],
        &["plan", "--rapid-out", "never_written.mod"],
        &["fit", "fixtures/robodk/irc5/Cube45.mod"],
    ] {
        let process_output =
            driftpost().args(arguments).args(["--robot", "fixtures/robots/scara.toml"]).output().unwrap();
        let text = String::from_utf8_lossy(&process_output.stderr).into_owned();
        assert_eq!(process_output.status.code(), Some(2), "{arguments:?}: {text}");
        assert!(
            text.contains("robot::six-axis") && text.contains("joint 3 of 4 slides"),
            "{arguments:?}: {text}"
        );
    }
}

#[test]
fn poses_of_an_arm_that_slides_are_planned_in_mm_and_within_its_ranges() {
    let scara = arm("scara");
    let options = PlanOptions {
        tool_m: Vector3::new(0.05, 0.03, 0.1),
        n: 20,
        repeats: 4,
        sweeps: Sweeps { joints: Vec::new(), n: 0, step_rad: 0.0 },
        payloads_kg: vec![0.0, 2.0],
        nests: 0,
        sigma_m: 2e-5,
        each_min: 1.0,
        space: Space { floor_m: 0.0, reach_m: None, box_m: None },
        seed: 1,
    };
    let planned = plan_from(&scara, &options, 60, 0).unwrap();
    let text = poses_csv(&planned, &scara);
    let mut lines = text.lines();
    let header = lines.next().unwrap();
    assert_eq!(header, "id,pose_id,q1_deg,q2_deg,q3_mm,q4_deg,dir1,dir2,dir3,dir4,payload_kg");
    let rows: Vec<Vec<f64>> =
        lines.map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect()).collect();
    assert_eq!(rows.len(), 20);
    assert!(rows.iter().all(|row| (-200.0..=0.0).contains(&row[4]) && row[3].abs() <= 150.0), "{text}");
    let [low, high] = [f64::min, f64::max].map(|f| rows.iter().map(|row| row[4]).reduce(f).unwrap());
    assert!(high - low > 100.0, "the spindle is moved over {low} to {high} mm");
}

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
mod long {
    use super::*;

    #[test]
    #[ignore = "long"]
    fn what_is_planted_in_an_arm_of_five_joints_is_named() {
        let step = Effect::BaseStep { t0_min: 40.0, direction: [0.5, -0.6, 0.3, 0.2, -0.3, 0.4] };
        assert_named("five_axes", step, None, ("mm", None), 5);
        assert_named("five_axes", Effect::JointCompliance { joint: 2 }, Some(2), ("rad/(N.m)", Some(1.0)), 6);
    }

    #[test]
    #[ignore = "long"]
    fn gofa_is_diagnosed_by_its_name_and_its_programs_are_refused_with_the_reason() {
        let folder = tempfile::tempdir().unwrap();
        // As exported for that robot.
        let exported = fs::read_to_string("fixtures/robodk/irc5/Cube45.mod").unwrap();
        let path = folder.path().join("Cube45.mod");
        fs::write(&path, exported.replace("ABB IRB 140-6/0.8", "ABB CRB 15000-5/0.95")).unwrap();
        let cube = path.to_str().unwrap();
        let table = ["--deformation", "fixtures/docs/mine.csv", "--growth", "exp:40"];
        for arguments in [
            &[&["compensate", cube, "-o", "never_written.mod"][..], &table].concat(),
            &[&["simulate", cube][..], &table].concat(),
            &vec!["diff", cube, cube],
            &vec!["closed-loop", cube, "--inject", "joint_offset:2"],
        ] {
            let process_output =
                driftpost().args(arguments).args(["--robot", "crb15000-5"]).output().unwrap();
            let text = String::from_utf8_lossy(&process_output.stderr).into_owned();
            assert_eq!(process_output.status.code(), Some(2), "{arguments:?}: {text}");
            assert!(
                text.contains("robot::structure")
                    && text.contains("axes 4, 5 and 6 do not meet in one point"),
                "{arguments:?}: {text}"
            );
        }
        let set = folder.path().join("set");
        let named = ["--robot", "crb15000-5"];
        let made = ["--effects", "gear_mesh:3:20", "--n", "60", "--rho", "4", "--seed", "5"];
        driftpost().arg("synth").arg(&set).args(named).args(made).assert().success();
        let measured = set.join("set_0000/measurements.csv");
        let process_output =
            driftpost().arg("diagnose").arg(measured).args(named).args(["--json", "-"]).output().unwrap();
        let json: serde_json::Value = serde_json::from_slice(&process_output.stdout).unwrap();
        assert_eq!(json["verdict"], "explained");
        let cause = &json["causes"][0];
        assert_eq!(
            (&cause["effect"], &cause["joint"], &cause["n"]),
            (&"gear_mesh".into(), &3.into(), &20.into())
        );
    }

    #[test]
    #[ignore = "long"]
    fn what_is_planted_in_a_scara_is_named() {
        assert_named("scara", Effect::JointOffset { joint: 2 }, Some(2), RAD, 3);
        assert_named("scara", Effect::Backlash { joint: 3, holding_n_m: f64::INFINITY }, Some(3), MM, 4);
    }

    #[test]
    #[ignore = "long"]
    fn what_is_planted_in_an_arm_of_seven_joints_is_named() {
        assert_named("seven_axes", Effect::JointOffset { joint: 4 }, Some(4), RAD, 7);
        let link = Effect::LinkGeometry { joint: 3, direction: [0.6, -0.3, 0.5, 0.3, 0.2, -0.4] };
        assert_named("seven_axes", link, Some(3), ("mm", None), 8);
    }

    #[test]
    #[ignore = "long"]
    fn a_tool_that_is_not_the_one_given_is_a_fault_of_the_file() {
        let arm = arm("seven_axes");
        let set = planted(&arm, Effect::JointOffset { joint: 4 }, 60, 12);
        let fitted = diagnose(&read(&set), &arm, &TOLD).tool_mm.unwrap();
        let away_m = Vector3::from(fitted.map(m_from_mm)) + Vector3::new(0.0, 0.02, 0.0);
        let found = diagnose(&read(&set), &arm, &DiagnosisOptions { tool_m: Some(away_m), ..TOLD });
        assert_eq!(found.verdict, Verdict::DataFault, "{}", summary(&found));
        assert!(found.reason.contains("mm from the one given"), "{}", found.reason);
    }

    #[test]
    #[ignore = "long"]
    fn accuracy_and_changes_of_an_arm_of_seven_joints_are_told() {
        let arm = arm("seven_axes");
        let folder = tempfile::tempdir().unwrap();
        let [before, after] = ["before.csv", "after.csv"].map(|name| folder.path().join(name));
        let set = planted(&arm, Effect::JointOffset { joint: 4 }, 40, 14);
        fs::write(&before, &set.csv).unwrap();
        // The same poses, every point 0.3 mm further along the instrument's x at half of them by joint 2's side: a base that stands
        // elsewhere would move all alike.
        let mut lines: Vec<String> = set.csv.lines().map(str::to_owned).collect();
        let columns: Vec<String> = lines[0].split(',').map(str::to_owned).collect();
        let column = |name: &str| columns.iter().position(|c| c == name).unwrap();
        let (q2, x) = (column("q2_deg"), column("x_mm"));
        for line in lines.iter_mut().skip(1) {
            let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
            if cells[q2].parse::<f64>().unwrap() > 0.0 {
                cells[x] = format!("{:.4}", cells[x].parse::<f64>().unwrap() + 0.3);
            }
            *line = cells.join(",");
        }
        fs::write(&after, lines.join("\n")).unwrap();
        let robot = ["--robot", "fixtures/robots/seven_axes.toml"];
        let same =
            driftpost().arg("compare-measurements").args([&before, &before]).args(robot).output().unwrap();
        assert_eq!(same.status.code(), Some(0), "{}", String::from_utf8_lossy(&same.stderr));
        let changed = driftpost()
            .arg("compare-measurements")
            .args([&before, &after])
            .args(robot)
            .args(["--sigma-mm", "0.02"])
            .output()
            .unwrap();
        assert_eq!(changed.status.code(), Some(1), "{}", String::from_utf8_lossy(&changed.stdout));
        let accuracy =
            driftpost().arg("accuracy").arg(&before).args(robot).args(["--json", "-"]).output().unwrap();
        let reported: serde_json::Value = serde_json::from_slice(&accuracy.stdout).unwrap();
        let joints = reported["poses"][0]["q_deg"].as_array().map(Vec::len);
        assert_eq!(joints, Some(7), "{reported}");
    }
}

//! Joints known from outside: what they decide, and what contradicts the program.
//!
//! The approach's joints are RoboDK's; its pose on the other wrist branch has, by closed form, joint 4 and 6 turned by half a turn
//! and joint 5 turned over.

use super::*;
use rapid_program::motion::Motion;
use robot_model::kinematics::Chain;
use robot_model::units::deg_from_rad;

const OTHER_DEG: [f64; 6] = [41.845157, 44.625236, 25.881200, -136.469524, 75.605869, 166.712742];

/// The approach's pose, with confdata that were never set.
fn there(path: Path, conf_monitored: Option<bool>) -> Motion {
    let flange = Chain::nominal(&irb140()).forward(&APPROACH_DEG.map(rad_from_deg));
    let (t, q) = (flange.translation.vector, flange.rotation.quaternion());
    let value = pose([t.x * 1e3, t.y * 1e3, t.z * 1e3], [q.w, q.i, q.j, q.k], [0; 4]);
    let mut motion = motion(path, &[value]);
    Arc::make_mut(&mut motion.setup).conf_monitored = conf_monitored;
    motion
}

/// The program as a file of its own, as hints name its lines.
fn in_file(motions: Vec<Motion>) -> Program {
    let source = rapid_syntax::SourceFile::read(FileId(0), "cell/Part.mod", *b"MODULE Part\nENDMODULE\n");
    Program { files: vec![source], ..program(motions) }
}

fn hint(rows: &[(u32, [f64; 6])]) -> Options {
    let mut text = "file,line,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\n".to_owned();
    for (line, q_deg) in rows {
        let joints = q_deg.map(|q| q.to_string()).join(",");
        text.push_str(&format!("part.MOD,{line},{joints}\n"));
    }
    Options { joints_hint: Some(Arc::new(JointsHint::read(text.as_bytes()).unwrap())), ..Options::default() }
}

fn hinted(program: &Program, rows: &[(u32, [f64; 6])]) -> Result<Plan, CompensateError> {
    plan(program, &irb140(), &Deformation::paper(), &hint(rows))
}

fn wrist_deg(plan: &Plan, motion: usize) -> f64 {
    deg_from_rad(plan.motions[motion].targets[0].nominal_q_rad[4])
}

#[test]
fn a_line_from_nowhere_ends_where_the_hint_says() {
    for (q_deg, expected) in [(APPROACH_DEG, -75.605869), (OTHER_DEG, 75.605869)] {
        let plan = hinted(&in_file(vec![there(Path::Linear, Some(false))]), &[(1, q_deg)]).unwrap();
        assert!((wrist_deg(&plan, 0) - expected).abs() < 1e-6);
        assert_eq!(plan.motions[0].status, Status::Compensated);
    }
}

#[test]
fn the_hint_holds_for_what_comes_after_it() {
    let motions = || in_file(vec![there(Path::Joint, Some(false)), there(Path::Linear, Some(false))]);
    let without = plan(&motions(), &irb140(), &Deformation::paper(), &Options::default());
    let Err(CompensateError::NothingToCompensate { first, .. }) = without else { panic!("{without:?}") };
    assert_eq!(first.code, "keep::branch-unknown");
    let plan = hinted(&motions(), &[(1, APPROACH_DEG)]).unwrap();
    assert!((wrist_deg(&plan, 0) + 75.605869).abs() < 1e-6);
    assert!((wrist_deg(&plan, 1) + 75.605869).abs() < 1e-6);
}

#[test]
fn joints_that_lead_elsewhere_refuse_the_program() {
    let mut off = APPROACH_DEG;
    off[0] += 0.1;
    // Joint 1 carries the cube's first target, 500 mm from its axis: 0.1 deg are 0.87 mm.
    let plan = hinted(&in_file(vec![there(Path::Linear, Some(false))]), &[(1, off)]);
    let diagnostics = match plan {
        Ok(plan) => plan.diagnostics,
        Err(CompensateError::NothingToCompensate { diagnostics, .. }) => diagnostics,
        Err(error) => panic!("{error}"),
    };
    let pose = diagnostics.iter().find(|d| d.code == "hint::pose").unwrap();
    assert_eq!(pose.severity, Severity::Error);
    assert!(
        pose.message.contains("line 2 of the joints hint lead to a place 0.873 mm and 0.100 deg"),
        "{pose:?}"
    );

    let absolute = in_file(vec![motion(Path::AbsJoint, &[joints(APPROACH_DEG)])]);
    assert_eq!(codes(&hinted(&absolute, &[(1, off)]).unwrap()), [("hint::pose", Severity::Error)]);
    assert_eq!(codes(&hinted(&absolute, &[(1, OTHER_DEG)]).unwrap()), []);
}

#[test]
fn a_checked_joint_move_goes_where_its_configuration_says() {
    // cfx 0 is the branch with joint 5 positive.
    let program = || in_file(vec![there(Path::Joint, Some(true))]);
    let agreed = hinted(&program(), &[(1, OTHER_DEG)]).unwrap();
    assert!((wrist_deg(&agreed, 0) - 75.605869).abs() < 1e-6);
    let plan = hinted(&program(), &[(1, APPROACH_DEG)]).unwrap();
    assert!(codes(&plan).contains(&("hint::branch", Severity::Error)), "{:?}", codes(&plan));
}

#[test]
fn a_line_that_would_have_to_change_branch_is_told() {
    let approach = motion(Path::AbsJoint, &[joints(APPROACH_DEG)]);
    let program = in_file(vec![approach, there(Path::Linear, Some(false))]);
    let plan = hinted(&program, &[(2, OTHER_DEG)]).unwrap();
    assert_eq!(codes(&plan), [("hint::line-branch", Severity::Warning)]);
    assert!((wrist_deg(&plan, 1) - 75.605869).abs() < 1e-6);
}

#[test]
fn rows_that_belong_to_no_motion_are_refused() {
    let error_text = |rows: &[(u32, [f64; 6])]| {
        let error = hinted(&in_file(vec![there(Path::Linear, Some(false))]), rows).unwrap_err();
        assert_eq!(error.code(), "hint::line");
        error.to_string()
    };
    assert_eq!(
        error_text(&[(7, APPROACH_DEG)]),
        "joints hint, line 2: there is no motion in line 7 of cell/Part.mod"
    );
    assert!(
        error_text(&[(1, APPROACH_DEG), (1, APPROACH_DEG)])
            .contains("moves to 1 target, and the hint has 2 rows for it")
    );
    let other =
        JointsHint::read(b"file,line,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\nOther.mod,1,0,0,0,0,0,0\n");
    let options = Options { joints_hint: Some(Arc::new(other.unwrap())), ..Options::default() };
    let program = in_file(vec![there(Path::Linear, Some(false))]);
    let error = plan(&program, &irb140(), &Deformation::paper(), &options).unwrap_err();
    assert_eq!(error.to_string(), "joints hint, line 2: Other.mod is none of the program's files");
}

#[test]
fn rows_without_lines_are_of_the_targets_in_their_order() {
    let motions = || in_file(vec![there(Path::Linear, Some(false)), there(Path::Linear, Some(false))]);
    let row = |q_deg: [f64; 6]| q_deg.map(|q| q.to_string()).join(",");
    let planned = |rows: &[String]| {
        let text = format!("q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\n{}\n", rows.join("\n"));
        let hint = Some(Arc::new(JointsHint::read(text.as_bytes()).unwrap()));
        plan(
            &motions(),
            &irb140(),
            &Deformation::paper(),
            &Options { joints_hint: hint, ..Options::default() },
        )
    };
    let both = planned(&[row(APPROACH_DEG), row(OTHER_DEG)]).unwrap();
    assert!((wrist_deg(&both, 0) + 75.605869).abs() < 1e-6 && (wrist_deg(&both, 1) - 75.605869).abs() < 1e-6);
    // Of the second nothing is known: it goes on as the first ends.
    let first = planned(&[row(OTHER_DEG), ",,,,,".to_owned()]).unwrap();
    assert!((wrist_deg(&first, 1) - 75.605869).abs() < 1e-6);
    // The text has other moves than were told: none of the joints are used, and it says so.
    let diagnostics = match planned(&[row(APPROACH_DEG)]) {
        Err(CompensateError::NothingToCompensate { diagnostics, .. }) => diagnostics,
        other => panic!("{other:?}"),
    };
    let order = diagnostics.iter().find(|d| d.code == "hint::order").unwrap();
    assert_eq!(order.severity, Severity::Warning);
    assert!(order.message.contains("has 1 row, and the program moves to 2 targets; its joints are not used"));
}

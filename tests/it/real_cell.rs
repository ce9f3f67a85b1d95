//! What a robot's surroundings do to its program: each fixture of `fixtures/cell` holds one thing about which a corrected
//! program was, or would be, wrong without a word.

mod other_robots;
mod pers_values;

use driftpost::application::{Compensated, Refusal};
use driftpost::{Compensation, Course, Deformation, ProgramFiles, Robot, Simulation, TrueRobot};
use rapid_compensation::compensate::plan::Status;
use rapid_compensation::compensate::{FormChoice, Selection};
use robot_model::units::rad_from_deg;
use std::path::Path;

fn bytes(name: &str) -> Vec<u8> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures/cell").join(name);
    std::fs::read(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

fn program(names: &[&str]) -> ProgramFiles {
    ProgramFiles::new(names.iter().map(|name| (name.to_string(), bytes(name))))
}

fn compensation() -> Compensation {
    Compensation::new(Robot::built_in("irb140").unwrap(), Deformation::paper())
}

/// Lines and what becomes of their motions: `compensated`, or the code of the reason.
fn statuses(made: &Compensated<'_>) -> Vec<(u32, &'static str)> {
    let status = |status: &Status| match status {
        Status::Compensated => "compensated",
        Status::Kept(why) | Status::Refused(why) => why.code,
    };
    let motions = made.program.motions.iter().zip(&made.plan.motions);
    motions.map(|(motion, planned)| (motion.line, status(&planned.status))).collect()
}

fn reason(made: &Compensated<'_>, line: u32) -> String {
    let at = made.program.motions.iter().position(|m| m.line == line).expect("a motion stands there");
    match &made.plan.motions[at].status {
        Status::Kept(why) | Status::Refused(why) => why.reason.clone(),
        Status::Compensated => String::new(),
    }
}

/// The messages with a code.
fn messages(made: &Compensated<'_>, code: &str) -> Vec<String> {
    let all = made.messages.iter().filter(|m| m.diagnostic.code == code);
    all.map(|m| m.diagnostic.message.clone()).collect()
}

fn refusal(compensation: &Compensation, program: &ProgramFiles) -> Box<Refusal> {
    compensation.run(program).err().expect("it is refused")
}

fn error_codes(refusal: &Refusal) -> Vec<&'static str> {
    use rapid_syntax::diagnostic::Severity;
    let errors = refusal.messages.iter().filter(|m| m.diagnostic.severity == Severity::Error);
    errors.map(|m| m.diagnostic.code).collect()
}

/// Under ConfJ\Off the controller takes the solution nearest to where the arm stands.
#[test]
fn without_known_joints_a_joint_move_that_nobody_checks_has_no_branch() {
    let files = program(&["conf_off.mod"]);
    let unknown = compensation();
    let made = unknown.run(&files).unwrap();
    assert_eq!(
        statuses(&made),
        [
            (10, "keep::branch-unknown"),
            (11, "keep::branch-unknown"),
            (12, "keep::no-value"),
            (13, "keep::branch-unknown"),
            (14, "keep::branch-unknown"),
            (15, "compensated"),
            (16, "compensated"),
            (17, "compensated"),
        ]
    );
    assert!(reason(&made, 10).contains("--start-joints"), "{}", reason(&made, 10));

    // Where the arm stands at the entry is said: the first two are known, those after `MoveAbsJ jr` are not.
    let mut with_options = compensation();
    with_options.options.start_rad = Some([0.0, 0.0, 0.0, 0.0, 30.0, 0.0].map(rad_from_deg));
    let with_joints = with_options.run(&files).unwrap();
    assert_eq!(
        statuses(&with_joints)[..3].iter().map(|s| s.1).collect::<Vec<_>>(),
        ["compensated", "compensated", "keep::no-value"]
    );
    assert_eq!(statuses(&with_joints)[3].1, "keep::branch-unknown");
    // What makes it so is named.
    let why = reason(&with_joints, 13);
    assert!(
        why.starts_with("where the arm stands is not known since the MoveAbsJ in line 12 of conf_off.mod,"),
        "{why}"
    );
    let why = reason(&made, 12);
    assert!(why.starts_with("jr has no initial value: line "), "{why}");
    let mut home = compensation();
    home.overrides.home = Some("jHome".to_owned());
    assert_eq!(statuses(&home.run(&files).unwrap()), statuses(&with_joints));

    // From the other side of the wrist the same numbers are reached with axis 5 negative, in the first cycle alone: the next one
    // comes from where this one has ended.
    let mut turned = compensation();
    turned.options.start_rad = Some([0.0, 0.0, 0.0, 180.0, -30.0, -180.0].map(rad_from_deg));
    assert_eq!(statuses(&turned.run(&files).unwrap())[0].1, "keep::branch-unknown");
    let once = String::from_utf8(bytes("conf_off.mod")).unwrap().replace("  ENDPROC", "    EXIT;\n  ENDPROC");
    let made = turned.run(&ProgramFiles::one("conf_off.mod", once.into_bytes())).unwrap();
    assert!(made.plan.motions[0].targets[0].nominal_q_rad[4] < 0.0);
    assert!(with_joints.plan.motions[0].targets[0].nominal_q_rad[4] > 0.0);
}

/// What a reviewer's tools must know stands in the emitted module.
#[test]
fn what_was_said_from_outside_stands_in_the_header() {
    let mut with_options = compensation();
    with_options.overrides.home = Some("jHome".to_owned());
    with_options.overrides.base_fixed[1] = true;
    with_options.options.selection.keep.push("pB*".to_owned());
    let made = with_options.run(&program(&["conf_off.mod"])).unwrap();
    let text = String::from_utf8(made.files[0].bytes.clone()).unwrap();
    for line in ["with: start-joints 0,0,0,0,30,0", "with: base-fixed b", "with: keep pB*"] {
        assert!(text.lines().any(|l| l.trim().ends_with(line)), "{line}");
    }
}

#[test]
fn a_home_that_is_no_jointtarget_is_refused() {
    for (name, expected) in [("jHme", "not declared"), ("pA", "no jointtarget"), ("jr", "not known")] {
        let mut home = compensation();
        home.overrides.home = Some(name.to_owned());
        let refused = refusal(&home, &program(&["conf_off.mod"]));
        assert_eq!(error_codes(&refused), ["override::home"], "{name}");
        assert!(refused.messages.iter().any(|m| m.diagnostic.message.contains(expected)), "{name}");
    }
}

#[test]
fn what_another_task_changes_is_not_constant() {
    let [robot, vision] =
        ["two_tasks/RAPID/TASK1/PROGMOD/Robot.mod", "two_tasks/RAPID/TASK2/PROGMOD/Vision.mod"];
    let compensation = compensation();
    let made = compensation.run(&program(&[robot, vision])).unwrap();
    assert_eq!(
        statuses(&made),
        [
            (10, "keep::other-task"),
            (11, "compensated"), // TASK PERS: the task's own
            (12, "compensated"), // the other task only reads it
            (13, "keep::other-task"),
            (14, "keep::no-value"),
        ]
    );
    // pShared is changed in line 10 of the other task, wTable in line 12.
    assert!(
        reason(&made, 10).contains("TASK2") && reason(&made, 10).contains("line 10 of"),
        "{}",
        reason(&made, 10)
    );
    assert!(reason(&made, 13).contains("line 12 of"), "{}", reason(&made, 13));
    assert_eq!(messages(&made, "task::not-given").len(), 1);

    let alone = compensation.run(&program(&[robot])).unwrap();
    assert_eq!(messages(&alone, "task::not-given").len(), 1, "pFromElsewhere");
}

#[test]
fn a_target_that_is_read_as_data_is_kept_or_named() {
    let compensation = compensation();
    let made = compensation.run(&program(&["read_as_data.mod"])).unwrap();
    assert_eq!(
        statuses(&made),
        [
            (21, "keep::calibration"), // MToolTCPCalib
            (22, "keep::calibration"),
            (23, "keep::calibration"), // DefFrame
            (24, "keep::calibration"), // WZSphDef, by way of `corner`
            (25, "compensated"),
            (26, "compensated"),
            (27, "compensated"),
        ]
    );
    assert!(reason(&made, 21).contains("MToolTCPCalib") && reason(&made, 21).contains("line 28 of"));
    let found = messages(&made, "target::read-as-data");
    assert_eq!(found.len(), 2, "{found:?}");
    assert!(found.iter().any(|m| m.starts_with("pHome ") && m.contains("IF in line 32")), "{found:?}");
    assert!(found.iter().any(|m| m.starts_with("pCopied ") && m.contains("SetGO in line 34")), "{found:?}");
}

/// PERS and module VAR outlive a cycle: what is used before it is set has, from the second pass on, what was set last.
#[test]
fn a_tool_that_is_set_after_its_first_motion_is_no_longer_what_is_declared() {
    let files = program(&["set_later.mod"]);
    let of = |form: FormChoice, far: &'static str| {
        let compensation = compensation().in_form(form);
        let made = compensation.run(&files).unwrap();
        let [tool, wobj] =
            if far == "kept" { ["keep::tool-unknown", "keep::wobj-unknown"] } else { [far; 2] };
        let expected = [
            (19, "compensated"), // joints, whatever the tool
            (20, tool),
            (21, "compensated"), // half a millimetre needs no other correction
            (22, "compensated"), // it is set to what it is declared with
            (23, "compensated"), // what a hand calls is told
            (25, tool),          // its length is a VAR that is set later
            (26, wobj),
            (27, tool), // CalcRobT gives another target with another tool
            (33, "compensated"),
        ];
        assert_eq!(statuses(&made), expected, "{form:?}");
        let kept_over = messages(&made, "state::pers-kept");
        let is_reported =
            ["tFar", "tNear", "wMoved"].map(|name| kept_over.iter().any(|text| text.starts_with(name)));
        assert_eq!((is_reported, kept_over.len()), ([true; 3], 3), "{kept_over:?}");
        let by_hand = messages(&made, "state::set-by-hand");
        assert!(by_hand.len() == 1 && by_hand[0].starts_with("tTaught"), "{by_hand:?}");
        if far == "kept" {
            let why = [20, 25, 26, 27].map(|line| reason(&made, line));
            assert!(
                why[0].starts_with("tFar is used here before") && why[0].contains(" mm apart"),
                "{why:?}"
            );
            assert!(why[1].contains("line 32 of set_later.mod"), "{why:?}");
            assert!(why[2].starts_with("wMoved ") && why[3].contains("no one target serves both"), "{why:?}");
        }
    };
    for form in [FormChoice::Schedule, FormChoice::Ramp] {
        of(form, "kept");
    }
    for form in [FormChoice::Live, FormChoice::Auto] {
        of(form, "compensated");
    }
}

/// Whichever way a reading of the warm arm's place takes, the model must not be asked about it.
#[test]
fn where_the_arm_stands_is_not_corrected_again() {
    let compensation = compensation().in_form(FormChoice::Auto);
    let files = program(&["where_it_stands.mod"]);
    let made = compensation.run(&files).unwrap();
    assert_eq!(
        statuses(&made),
        [
            (12, "compensated"),
            (13, "compensated"),
            (15, "keep::own-position"), // through two parameters
            (18, "compensated"),        // what a routine moves to is not set by it
            (22, "keep::own-position"), // in a handler
            (23, "keep::own-position"),
            (38, "keep::own-position"), // one of its calls hands over a reading
        ]
    );
    // The reading is named, however far away it stands.
    for (line, read_in) in [(15, 34), (22, 21), (23, 21), (38, 34)] {
        let why = reason(&made, line);
        assert!(
            why.contains("(CRobT)") && why.ends_with(&format!(": line {read_in} of where_it_stands.mod")),
            "{why}"
        );
    }
}

#[test]
fn motions_are_left_alone_or_chosen_by_name() {
    let files = program(&["quadrants.mod"]);
    let selected = |keep: &[&str], only: &[&str]| {
        let own = |names: &[&str]| names.iter().map(|name| name.to_string()).collect();
        let mut compensation = compensation();
        compensation.options.selection = Selection { keep: own(keep), only: own(only) };
        compensation
    };
    let codes = |compensation: &Compensation| {
        let made = compensation.run(&files).unwrap();
        statuses(&made).into_iter().map(|(_, code)| code).take(4).collect::<Vec<_>>()
    };
    let (kept, done) = ("keep::as-asked", "compensated");
    assert_eq!(codes(&selected(&["PRIGHT"], &[])), [done, kept, done, done]);
    assert_eq!(codes(&selected(&["pB*"], &[])), [done, done, kept, kept]);
    assert_eq!(codes(&selected(&[], &["p?ff"])), [done, kept, kept, kept]);
    assert_eq!(codes(&selected(&["pOff"], &["main"])), [kept, done, done, done]);
    // A name that stands for nothing is a typing error, and that would move the arm.
    let refused = refusal(&selected(&["pBroder"], &[]), &files);
    assert_eq!(error_codes(&refused), ["option::names-nothing"]);
    let text = &refused.messages[0].diagnostic.message;
    assert!(text.starts_with("--keep pBroder names no") && text.contains("pBorder"), "{text}");
    assert_eq!(error_codes(&refusal(&selected(&["Quadrants"], &[]), &files)), ["compensate::nothing"]);
}

#[test]
fn required_arguments_may_be_given_by_name() {
    // The last goes to a parameter whose calls all hand over constants.
    for (form, last) in [(FormChoice::Schedule, "keep::one-of"), (FormChoice::Ramp, "compensated")] {
        let compensation = compensation().in_form(form);
        let made = compensation.run(&program(&["named_arguments.mod"])).unwrap();
        let expected = [(8, "compensated"), (9, "compensated"), (10, "compensated"), (15, last)];
        assert_eq!(statuses(&made), expected);
        assert!(made.messages.iter().all(|m| !m.diagnostic.code.starts_with("syntax::")));
        let text = String::from_utf8(made.files[0].bytes.clone()).unwrap();
        let line = text.lines().find(|line| line.contains("Speed:=v200")).unwrap();
        assert!(
            line.contains("ToPoint:=tc") && line.contains(",Zone:=fine,Tool:=tGrip\\WObj:=wTable;"),
            "{line}"
        );
    }
}

#[test]
fn nothing_is_edited_beside_what_was_not_understood() {
    let compensation = compensation();
    let made = compensation.run(&program(&["not_understood.mod"])).unwrap();
    assert_eq!(
        statuses(&made),
        [(6, "compensated"), (9, "keep::not-read"), (11, "keep::not-read"), (13, "compensated")]
    );
    let mut strict = compensation.clone();
    strict.options.strict = true;
    assert!(error_codes(&refusal(&strict, &program(&["not_understood.mod"]))).contains(&"keep::not-read"));
}

#[test]
fn an_axis_that_may_carry_the_robot_keeps_its_targets() {
    let files = program(&["track.mod"]);
    let unknown = compensation();
    let made = unknown.run(&files).unwrap();
    assert_eq!(
        statuses(&made),
        [
            (10, "keep::external-base"), // the track stands at 0; from the second pass on axis b stands where line 12 has placed it
            (11, "keep::external-base"),
            (12, "keep::external-base"),
            (13, "compensated"), // joints are corrected wherever the base stands
            (15, "keep::external-base"),
            (17, "keep::external-offset"),
        ]
    );
    assert!(reason(&made, 11).contains("axis a") && reason(&made, 12).contains("axis b"));
    let mut fixed = compensation();
    fixed.overrides.base_fixed[1] = true;
    let made = fixed.run(&files).unwrap();
    let codes: Vec<_> = statuses(&made).into_iter().map(|(_, code)| code).collect();
    assert_eq!(codes[..3], ["compensated", "keep::external-base", "compensated"]);
    assert_eq!(codes[4], "compensated", "offsets of nothing");
    assert_eq!(codes[5], "compensated", "EOffsSet of a positioner is no reason");
}

/// The eight branches differ in cfx; whole quadrants amiss change no correction.
#[test]
fn the_branch_is_the_one_that_cfx_names() {
    let compensation = compensation();
    let made = compensation.run(&program(&["quadrants.mod"])).unwrap();
    let codes: Vec<_> = statuses(&made).into_iter().map(|(_, code)| code).collect();
    assert_eq!(codes, ["compensated", "compensated", "compensated", "compensated", "keep::configuration"]);
    let disagrees = messages(&made, "conf::disagrees");
    assert!(disagrees.len() == 1 && disagrees[0].starts_with("line 8:"), "{disagrees:?}");
    // The source's numbers stay, corrected or not.
    let text = String::from_utf8(made.files[0].bytes.clone()).unwrap();
    let off: Vec<&str> = text.lines().filter(|line| line.contains("[1,-1,0,0]")).collect();
    assert!(off.len() > 10, "each element has them: {}", off.len());
    // With the tool straight down axis 4 stands on the border of quadrant 0, and the paper's table turns it: said of the two
    // moves that are checked (lines 9 and 10), not under ConfL\Off (line 12).
    let border = messages(&made, "conf::border");
    assert!(border.len() == 1 && border[0].starts_with("line 9:"), "{border:?}");
    assert!(
        border[0].contains("axis 4") && border[0].ends_with("(1 more like this in the same routine)"),
        "{border:?}"
    );
}

#[test]
fn what_a_handler_puts_in_force_is_named_with_its_line() {
    let compensation = compensation();
    let refused = refusal(&compensation, &program(&["displaced.mod"]));
    assert_eq!(error_codes(&refused), ["compensate::nothing"]);
    let why = &refused.kept[0];
    assert_eq!(why.code, "keep::displacement");
    assert!(why.reason.contains("PDispOn") && why.reason.contains("line 9 of"), "{}", why.reason);
}

/// Cube45 with its configurations checked: at its nine targets with y = 0 the correction takes axis 1 below 0 deg while cf1 says 0.
/// `compensate` says so beforehand and the virtual controller at the move, once the arm is warm.
/// The source itself stands on the border.
#[test]
fn a_controller_tells_of_a_joint_over_its_quadrants_border() {
    let source = include_str!("../../fixtures/robodk/irc5/Cube45.mod").replace("ConfL \\Off", "ConfL \\On");
    let checked = ProgramFiles::one("Checked.mod", source.into_bytes());
    let compensation = compensation();
    let made = compensation.run(&checked).unwrap();
    let found = messages(&made, "conf::border");
    assert!(found[0].starts_with("line 33: the correction takes axis 1 to -0.02"), "{found:?}");
    assert!(found[0].contains("(8 more like this in the same routine)"), "{found:?}");
    let robot = Robot::built_in("irb140").unwrap();
    let simulation = Simulation::new(TrueRobot::new(robot, Deformation::paper()));
    let corrected = ProgramFiles::one("Checked.mod", made.files[0].bytes.clone());
    let warm = Course::Minutes(vec![180.0]);
    let report = simulation.run(&corrected, Some(&checked), &warm).unwrap().report;
    let of_axis_1 =
        |m: &&virtual_controller::Message| m.text.contains("over the border of the quadrant that cf1 = 0");
    assert_eq!(report.messages.iter().filter(of_axis_1).count(), 9, "{:?}", report.messages);
    assert_eq!(report.messages.len(), 9);
    let original = simulation.run(&checked, Some(&checked), &warm).unwrap().report;
    assert!(original.messages.is_empty(), "{:?}", original.messages);
}

#[test]
fn a_self_test_that_cannot_be_written_is_told() {
    let cube =
        ProgramFiles::one("Cube45.mod", include_bytes!("../../fixtures/robodk/irc5/Cube45.mod").to_vec());
    let self_test = |form: FormChoice| {
        let mut compensation = compensation().in_form(form);
        compensation.emit.self_test = true;
        let made = compensation.run(&cube).unwrap();
        let has_routine = String::from_utf8_lossy(&made.files[0].bytes).contains("PROC tcSelfTest()");
        (has_routine, messages(&made, "emit::no-self-test").len())
    };
    assert_eq!(self_test(FormChoice::Schedule), (false, 1));
    assert_eq!(self_test(FormChoice::Auto), (true, 0));
}

/// A tool that nobody has declared: all is asked at run time, and no figure can be given.
#[test]
fn no_figures_are_given_where_no_target_is_known() {
    let source = "MODULE M\n  PROC main()\n    MoveL [[500,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tElsewhere;\n  \
                  ENDPROC\nENDMODULE\n";
    let compensation = compensation().in_form(FormChoice::Auto);
    let made = compensation.run(&ProgramFiles::one("m.mod", source.as_bytes().to_vec())).unwrap();
    let mut review = Vec::new();
    made.write_review(&mut review, true).unwrap();
    let text = String::from_utf8(review).unwrap();
    assert!(text.contains("no target is known before the program runs"), "{text}");
    assert!(!text.contains("worst TCP error") && !text.contains("work-object shift instead"), "{text}");
}

/// What `--keep` names is left alone, also where the model could be asked at run time.
#[test]
fn what_is_to_be_kept_is_not_asked_at_run_time_either() {
    let source = include_bytes!("../../fixtures/simulate/runtime.mod").to_vec();
    let files = ProgramFiles::one("runtime.mod", source);
    let asked = |keep: &[&str], keep_moveabsj: bool| {
        let mut compensation = compensation().in_form(FormChoice::Auto);
        let keep = keep.iter().map(|name| (*name).to_owned()).collect();
        compensation.options.selection = Selection { keep, only: Vec::new() };
        compensation.options.keep_moveabsj = keep_moveabsj;
        String::from_utf8(compensation.run(&files).unwrap().files[0].bytes.clone()).unwrap()
    };
    let plain = asked(&[], false);
    assert!(plain.contains("tcLive(pTo,") && plain.contains("tcLiveJ(jTurn,"), "{plain}");
    let kept = asked(&["rGo"], true);
    for line in
        ["MoveL Offs(pTo,0,0,nUp),v200", "MoveL pTo,v100", "MoveAbsJ jTurn,v500", "MoveAbsJ jHome,v500"]
    {
        assert!(kept.contains(line), "{line}: {kept}");
    }
    assert!(kept.contains("tcLive(Offs(pStart,20*i,15*j,0),"), "{kept}");
}

/// What a program loads comes from the controller's disk, where the originals lie.
#[test]
fn a_module_that_the_program_loads_is_named() {
    let files = program(&["loading/Main.mod", "loading/PART_A.MOD"]);
    let compensation = compensation();
    let made = compensation.run(&files).unwrap();
    assert_eq!(statuses(&made), [(7, "compensated"), (5, "compensated")]);
    assert_eq!(
        messages(&made, "load::from-disk"),
        ["Part_A is loaded by the program, from the controller's disk"]
    );
    assert_eq!(
        messages(&made, "load::not-given"),
        [
            "part_b.mod, which the program loads, is not among the given files",
            "which module is loaded here only run time tells"
        ]
    );
    assert_eq!(messages(&made, "resolve::routine-not-given"), ["rother is not among the given files"]);
}

/// What an operator sets on the pendant goes past the arrays of `schedule`; `ramp` goes by it.
#[test]
fn a_pers_in_a_target_of_a_schedule_is_named() {
    let files = program(&["set_on_the_pendant.mod"]);
    for (form, expected) in [(FormChoice::Schedule, 1), (FormChoice::Ramp, 0), (FormChoice::Auto, 0)] {
        let compensation = compensation().in_form(form);
        let made = compensation.run(&files).unwrap();
        assert!(statuses(&made).iter().all(|(_, status)| *status == "compensated"), "{form:?}");
        let messages = messages(&made, "schedule::pers-value");
        assert_eq!(messages.len(), expected, "{form:?}");
        assert!(messages.iter().all(|m| m.starts_with("line 12: nUp is a PERS")), "{messages:?}");
        // Its correction stays that of the file's value.
        let of_the_moment = crate::real_cell::messages(&made, "ramp::pers-value");
        assert_eq!(of_the_moment.len(), 1 - expected, "{form:?}");
    }
}

//! Rows of points a degree or a millimetre apart that repeat each other, run back in time, or are not the robot's.

use super::*;

fn file(rows: &[(f64, f64, f64)]) -> Measurements {
    let mut text = "t_min,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n".to_owned();
    for (t_min, q2_deg, x_mm) in rows {
        text.push_str(&format!("{t_min},0,{q2_deg},0,0,0,0,{x_mm},0,0\n"));
    }
    Measurements::from_csv(text.as_bytes()).unwrap()
}

fn codes(checked: &RowCheck) -> Vec<&'static str> {
    checked.warnings.iter().map(|w| w.code).collect()
}

#[test]
fn one_step_back_is_a_warning_and_shuffled_time_is_not_used() {
    let robot = SerialArm::built_in("irb140").unwrap();
    let mut rows: Vec<(f64, f64, f64)> = (0..20).map(|i| (f64::from(i), 0.0, f64::from(i))).collect();
    rows[10].0 = 5.5;
    let checked = check_rows(&file(&rows), &robot);
    assert_eq!(codes(&checked), ["measure::time-step-back"]);
    assert!(checked.time_usable);
    for (i, row) in rows.iter_mut().enumerate() {
        row.0 = ((i * 7) % 20) as f64;
    }
    let checked = check_rows(&file(&rows), &robot);
    assert_eq!(codes(&checked), ["measure::time-order"]);
    assert!(checked.time_usable, "sorted");
    rows.iter_mut().for_each(|row| row.0 = 45415.0);
    let checked = check_rows(&file(&rows), &robot);
    assert_eq!(codes(&checked), ["measure::one-time"]);
    assert!(!checked.time_usable);
}

/// 20 poses a degree and a millimetre apart: three of -9999 are a code; two are false readings, what lies among the others is a
/// coordinate, and at one pose the same is a repeat.
#[test]
fn a_number_far_out_that_poses_share_is_a_code() {
    let robot = SerialArm::built_in("irb140").unwrap();
    let poses: Vec<(f64, f64, f64)> = (0..20).map(f64::from).map(|i| (i, i, i)).collect();
    let checked_with = |changed: &[(usize, f64, f64)]| {
        let mut rows = poses.clone();
        for (row, q2_deg, x_mm) in changed {
            (rows[*row].1, rows[*row].2) = (*q2_deg, *x_mm);
        }
        check_rows(&file(&rows), &robot)
    };
    let coded = checked_with(&[(2, 2.0, -9999.0), (9, 9.0, -9999.0), (19, 19.0, -9999.0)]);
    assert_eq!(codes(&coded), ["measure::code-for-none"]);
    assert_eq!(coded.used, (0..19).filter(|i| ![2, 9].contains(i)).collect::<Vec<_>>());
    assert!(coded.warnings[0].message.contains("x_mm is -9999 to the last digit in 3 rows: lines 4, 11, 21"));
    for kept in [
        [(2, 2.0, -9999.0), (9, 9.0, -9999.0), (19, 19.0, 19.0)],
        [(2, 2.0, 25.0), (9, 9.0, 25.0), (19, 19.0, 25.0)],
        [(2, 2.0, -9999.0), (9, 2.0, -9999.0), (19, 2.0, -9999.0)],
    ] {
        let checked = checked_with(&kept);
        assert_eq!((checked.used.len(), codes(&checked)), (20, vec![]), "{kept:?}");
    }
}

/// Joint 3 of the irb140 ends at -230 deg and 50 deg: 160 deg is -200 deg a turn back, though 160 deg is nearer to 0; 100 deg is -260 deg.
#[test]
fn a_turn_is_looked_for_in_the_range_and_not_about_zero() {
    let robot = SerialArm::built_in("irb140").unwrap();
    let reason = |q3_deg: f64| {
        let mut measured = file(&(0..20).map(|i| (f64::from(i), 0.0, f64::from(i))).collect::<Vec<_>>());
        measured.rows.iter_mut().for_each(|row| row.q_rad[2] = q3_deg.to_radians());
        check_rows(&measured, &robot).fault.unwrap().reason
    };
    assert!(reason(160.0).contains("a whole turn on or back"), "{}", reason(160.0));
    assert!(reason(100.0).contains("another robot"), "{}", reason(100.0));
}

/// 200 and 340 deg are -160 and -20 deg less a turn, of which the second alone is in the 110 deg of the irb140's joint 2.
#[test]
fn joints_a_whole_turn_out_of_range_are_told_as_that() {
    let robot = SerialArm::built_in("irb140").unwrap();
    let reason = |q2_deg: f64| {
        let rows: Vec<(f64, f64, f64)> = (0..20).map(|i| (f64::from(i), q2_deg, f64::from(i))).collect();
        check_rows(&file(&rows), &robot).fault.unwrap().reason
    };
    assert!(reason(340.0).contains("a whole turn on or back"), "{}", reason(340.0));
    assert!(reason(200.0).contains("another robot"), "{}", reason(200.0));
}

#[test]
fn copies_and_joints_out_of_range_are_left_out_and_many_of_those_are_a_fault() {
    let robot = SerialArm::built_in("irb140").unwrap();
    let mut rows: Vec<(f64, f64, f64)> = (0..20).map(|i| (f64::from(i), 0.0, f64::from(i))).collect();
    rows.push(rows[3]);
    rows[8].1 = 170.0;
    let checked = check_rows(&file(&rows), &robot);
    assert!(codes(&checked).contains(&"measure::duplicates"));
    assert!(codes(&checked).contains(&"measure::joint-range"));
    assert_eq!(checked.used.len(), 19);
    for row in &mut rows {
        row.1 = 170.0;
    }
    let fault = check_rows(&file(&rows), &robot).fault.unwrap();
    assert_eq!(fault.kind, FaultKind::JointsOutOfRange);
}

/// One point three times: with another quaternion, and from the other side with the first one's.
#[test]
fn rows_of_another_orientation_or_direction_are_no_copies() {
    let robot = SerialArm::built_in("irb140").unwrap();
    let header =
        "q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm,qw,qx,qy,qz,dir1,dir2,dir3,dir4,dir5,dir6";
    let at = "0,0,0,0,0,0,500,0,600";
    let text = format!(
        "{header}\n{at},1,0,0,0,1,1,1,1,1,1\n{at},0.8,0.6,0,0,1,1,1,1,1,1\n{at},1,0,0,0,-1,1,1,1,1,1\n"
    );
    let checked = check_rows(&Measurements::from_csv(text.as_bytes()).unwrap(), &robot);
    assert_eq!((codes(&checked), checked.used), (vec![], vec![0, 1, 2]));
}

/// 24,000 cycles of three poses, all of a pose equal: none is left out.
#[test]
fn each_row_is_a_cycle_however_many_and_equal_they_are() {
    let robot = SerialArm::built_in("irb140").unwrap();
    let rows: Vec<(f64, f64, f64)> = (0..24_000).map(|i| (0.0, f64::from(i % 3), f64::from(i % 3))).collect();
    let checked = check_cycles(&file(&rows), &robot);
    assert_eq!((checked.used.len(), codes(&checked)), (24_000, vec!["measure::equal-cycles"]));
}

/// A slide of 0 to 0.3 m stands 5 mm beyond its end in one row of 20: that is no scatter of a read-back, as half a millimetre may be.
#[test]
fn a_joint_that_slides_is_out_of_its_range_by_millimetres() {
    let mut robot = SerialArm::built_in("irb140").unwrap();
    robot.joints[2].kind = JointKind::Prismatic;
    robot.joints[2].range_rad = Some([0.0, 0.3]);
    let mut measured = file(&(0..20).map(|i| (f64::from(i), 0.0, f64::from(i))).collect::<Vec<_>>());
    measured.joint_kinds = robot.kinds();
    measured.rows.iter_mut().for_each(|row| row.q_rad[2] = 0.1);
    measured.rows[7].q_rad[2] = 0.3005;
    assert_eq!(check_rows(&measured, &robot).out_of_range, [0; 0]);
    measured.rows[7].q_rad[2] = 0.305;
    assert_eq!(check_rows(&measured, &robot).out_of_range, [7]);
}

/// Two days, each from the home pose on, where the instrument read the same to its last digit at the same minute.
#[test]
fn the_same_minute_of_two_sessions_is_no_copy() {
    let robot = SerialArm::built_in("irb140").unwrap();
    let day = |by: f64| {
        (0..10).map(move |k| (f64::from(k), f64::from(k), f64::from(k * k) + if k == 0 { 0.0 } else { by }))
    };
    let checked = check_rows(&file(&day(0.0).chain(day(0.01)).collect::<Vec<_>>()), &robot);
    assert_eq!((codes(&checked), checked.used.len()), (vec!["measure::cold-starts"], 20));
}

/// Ten rows with minutes pasted twice below themselves: no cold starts, and each counts once.
#[test]
fn a_file_that_was_pasted_onto_itself_counts_once() {
    let robot = SerialArm::built_in("irb140").unwrap();
    let once: Vec<(f64, f64, f64)> =
        (0..10).map(|k| (f64::from(k), f64::from(k), 0.1234 * f64::from(k))).collect();
    let checked = check_rows(&file(&[once.clone(), once.clone(), once].concat()), &robot);
    assert_eq!((codes(&checked), checked.used), (vec!["measure::duplicates"], (0..10).collect()));
}

/// Two nests after each of 12,500 poses, and a file of one pose that is the second in it: of poses a part is enough, of nests none is.
#[test]
fn of_many_rows_poses_are_left_out_and_no_nests() {
    let robot = SerialArm::built_in("irb140").unwrap();
    let mut text =
        "kind,fixed_id,t_min,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n".to_owned();
    for k in 0..12_500 {
        text +=
            &format!("pose,,{k},0,{},0,0,0,0,{},0,600\n", 1e-3 * f64::from(k), 400.0 + 1e-2 * f64::from(k));
        text += &format!("base,N{},{k},,,,,,,{},900,10\n", k % 2, 1e-3 * f64::from(k));
    }
    let measured = Measurements::from_csv(text.as_bytes()).unwrap();
    let checked = check_rows(&measured, &robot);
    let is_nest = |row: &&usize| !measured.rows[**row].reading.involves_arm();
    assert_eq!(checked.used.iter().filter(is_nest).count(), 12_500);
    let poses = checked.used.len() - 12_500;
    assert!((5_500..7_000).contains(&poses), "{poses}");
    let many = checked.warnings.iter().find(|warning| warning.code == "measure::many-rows").unwrap();
    let message = format!("of 25000 rows {} are evaluated: {poses} of 12500 poses", checked.used.len());
    assert_eq!(many.message, message);
    let mut one = file(&(0..20_010).map(|k| (f64::from(k), 0.0, f64::from(k))).collect::<Vec<_>>());
    one.rows.iter_mut().for_each(|row| row.pose = 1);
    let checked = check_rows(&one, &robot);
    assert_eq!((checked.used.len(), codes(&checked)), (20_010, vec![]));
}

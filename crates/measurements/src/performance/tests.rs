//! Files of single poses, of few cycles, of sides and days, worked out by hand.

use super::*;
use nalgebra::Point3;

/// 9 numbers of 15: the square root of 6/15 is left; of 30 poses 5 %.
#[test]
fn of_few_poses_it_is_named_what_the_fit_takes() {
    let stations = |n: usize| -> Vec<Station> {
        let point = Reading::Point { position_m: Vector3::zeros() };
        (0..n).map(|pose| Station::bare(pose, Joints::all(6, 0.0), point.clone())).collect()
    };
    let five = few_poses(&stations(5), 1, ComparisonFrame::Fitted).unwrap();
    assert!(
        five.message.starts_with("base and target (9 numbers) are fitted to the 15 of 5 poses"),
        "{}",
        five.message
    );
    assert!(five.message.contains("by some 37 %"), "{}", five.message);
    assert_eq!(few_poses(&stations(30), 1, ComparisonFrame::Fitted), None);
    assert_eq!(few_poses(&stations(5), 1, ComparisonFrame::AsMeasured(Vector3::zeros())), None);
}

/// One pose seen five times places no base: repeatability is the same in the instrument's frame. By hand, distances from the
/// barycentre 1, 1, 1, 1, 0 mm: mean 0.8, S = sqrt(0.2), RP = 0.8 + 3 sqrt(0.2).
#[test]
fn a_single_repeated_pose_has_a_repeatability_and_no_accuracy() {
    let mut text = "q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n".to_owned();
    for [x, y] in [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0], [0.0, 0.0]] {
        text += &format!("10,20,5,25,45,-20,{},{},600\n", 500.0 + x, 100.0 + y);
    }
    let measurements = Measurements::from_csv(text.as_bytes()).unwrap();
    let robot = SerialArm::built_in("irb140").unwrap();
    let found = performance(&measurements, &robot, ComparisonFrame::Fitted).unwrap();
    let [pose] = found.poses.as_slice() else { panic!("{} poses", found.poses.len()) };
    let rp_mm = 1e3 * pose.repeatability.unwrap().rp_m;
    assert!((rp_mm - (0.8 + 3.0 * 0.2_f64.sqrt())).abs() < 1e-9, "{rp_mm}");
    assert!(found.registration.is_none() && pose.accuracy.is_none());
    let once = text.lines().take(2).collect::<Vec<_>>().join("\n");
    let once = Measurements::from_csv(once.as_bytes()).unwrap();
    let error = performance(&once, &robot, ComparisonFrame::Fitted).unwrap_err();
    assert!(matches!(error, PerformanceError::Register(_)));
    assert!(Diagnostic::from(error).help.iter().any(|help| help.contains("pose_id")));
}

/// A robot without any error, joint 1 turned by +-0.02 deg about 30 deg as its encoder reads: on an arc of r = |p_xy| the points of each
/// of the two lie +-r sin 0.02 deg from the chord's middle, all as far, so that RP = r sin 0.02 deg and AP = 0.
#[test]
fn joints_as_encoders_read_them_are_each_rows_own_command() {
    let robot = SerialArm::built_in("irb140").unwrap();
    let chain = SerialChain::nominal(&robot);
    let mut text = "pose_id,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n".to_owned();
    let mut radius_mm = 0.0;
    for q1_deg in [30.02, 29.98, 30.02, 29.98] {
        let q_deg = [q1_deg, 10.0, 5.0, 0.0, 40.0, 0.0];
        let at_mm = 1e3 * (chain.forward(&q_deg.map(f64::to_radians)) * Point3::new(0.0, 0.0, 0.1)).coords;
        radius_mm = at_mm.xy().norm();
        let joints = q_deg.map(|q| q.to_string()).join(",");
        text += &format!("A,{joints},{:.9},{:.9},{:.9}\n", at_mm.x, at_mm.y, at_mm.z);
    }
    let measurements = Measurements::from_csv(text.as_bytes()).unwrap();
    let tool_m = Vector3::new(0.0, 0.0, 0.1);
    let found = performance(&measurements, &robot, ComparisonFrame::AsMeasured(tool_m)).unwrap();
    let [pose] = found.poses.as_slice() else { panic!("{} poses", found.poses.len()) };
    assert!(pose.accuracy.unwrap().ap_m < 1e-9 && pose.joints_differ, "{pose:?}");
    let expected_mm = radius_mm * 0.02_f64.to_radians().sin();
    let rp_mm = 1e3 * pose.repeatability.unwrap().rp_m;
    assert!((rp_mm - expected_mm).abs() < 1e-6, "{rp_mm} {expected_mm}");
}

/// One pose in the instrument's frame: unloaded at x = 500 mm from one side and 500.3 from the other, with 5 kg at 500.1 from the first
/// side, and from the other again at 501 an hour later.
#[test]
fn sides_are_told_by_directions_under_one_payload_at_one_time() {
    let robot = SerialArm::built_in("irb140").unwrap();
    let vap_mm = |columns: &str, rows: &[(&str, f64)]| {
        let mut text = format!("{columns},q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n");
        for (cells, x_mm) in rows {
            text += &format!("{cells},10,20,5,25,45,-20,{x_mm},100,600\n").repeat(2);
        }
        let measurements = Measurements::from_csv(text.as_bytes()).unwrap();
        let found = performance(&measurements, &robot, ComparisonFrame::Fitted).unwrap();
        found.multi_directional_m.map(|m| 1e3 * m)
    };
    assert_eq!(vap_mm("payload_kg", &[("0", 500.0), ("5", 500.1)]), None, "that is sag");
    let header = "t_min,payload_kg,dir1,dir2,dir3,dir4,dir5,dir6";
    let (one, other) = ("1,1,1,1,1,1", "-1,1,1,1,1,1");
    let all = [
        (format!("0,0,{one}"), 500.0),
        (format!("1,0,{other}"), 500.3),
        (format!("2,5,{one}"), 500.1),
        (format!("63,5,{other}"), 501.0),
    ];
    let all = all.each_ref().map(|(cells, x_mm)| (cells.as_str(), *x_mm));
    assert!((vap_mm(header, &all).unwrap() - 0.3).abs() < 1e-9);
    assert_eq!(vap_mm(header, &[all[0], all[3]]), None);
    assert_eq!(vap_mm(header, &all[2..]), None, "that is drift");
}

/// Cycle `k` of poses that are all over the middle of the ranges, seen with a tool of 120 mm from beside the robot, so that each coordinate runs
/// from below 0 to above: joints in degrees, and the point in mm.
fn cycle(k: usize, tool_m: Vector3<f64>) -> ([f64; 6], [f64; 3]) {
    let chain = SerialChain::nominal(&SerialArm::built_in("irb140").unwrap());
    let q_deg: [f64; 6] = std::array::from_fn(|j| {
        let part = ((k as f64 + 1.0) * 0.618_034_f64.powi(j as i32 + 1)).fract();
        let deg = [85.0, 45.0, 40.0, 90.0, 60.0, 110.0][j] * (2.0 * part - 1.0);
        if j == 4 { deg + 15.0 } else { deg }
    });
    let point = chain.forward(&q_deg.map(f64::to_radians)) * Point3::from(tool_m);
    (q_deg, ((point.coords - Vector3::new(0.3, 0.05, 0.6)) * 1e3).into())
}

fn file(columns: &str, rows: impl Iterator<Item = (String, [f64; 6], [f64; 3])>) -> Measurements {
    let mut text = format!("{columns},q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n");
    for (cells, q_deg, [x, y, z]) in rows {
        text += &format!("{cells},{},{x:.5},{y:.5},{z:.5}\n", q_deg.map(|q| format!("{q:.6}")).join(","));
    }
    Measurements::from_csv(text.as_bytes()).unwrap()
}

/// The one target sits 25 mm elsewhere from line 38 on: where, --tool does not say.
#[test]
fn a_target_that_is_mounted_anew_is_one_whose_place_is_not_known() {
    let robot = SerialArm::built_in("irb140").unwrap();
    let tool_m = Vector3::new(0.05, -0.03, 0.12);
    let anew_m = tool_m + Vector3::new(0.0, 0.015, 0.02);
    let row = |k: usize| {
        let (q_deg, point_mm) = cycle(k, if k < 36 { tool_m } else { anew_m });
        (format!("P{k}"), q_deg, point_mm)
    };
    let measurements = file("pose_id", (0..60).map(row));
    for frame in [ComparisonFrame::BaseFitted(tool_m), ComparisonFrame::AsMeasured(tool_m)] {
        let Err(PerformanceError::SeveralTargets { targets }) = performance(&measurements, &robot, frame)
        else {
            panic!("{frame:?}")
        };
        assert_eq!(targets, ["one without a name", "from line 38"]);
    }
    // Each place fitted, nothing is left.
    let found = performance(&measurements, &robot, ComparisonFrame::Fitted).unwrap();
    assert!(found.worst().ap_m.unwrap() < 1e-5, "{:?}", found.worst());
}

/// The same minutes on two days: AP is 0.1 mm on the first and 0.4 mm on the second, and each pose is come to from one side on either.
#[test]
fn minutes_of_two_days_are_no_common_time() {
    let robot = SerialArm::built_in("irb140").unwrap();
    let tool_m = Vector3::new(0.0, 0.0, 0.1);
    let row = |k: usize| {
        let (day, minute, pose) = (k / 20, k % 20, k % 5);
        let (q_deg, [x, y, z]) = cycle(pose, tool_m);
        let off_mm = [0.1, 0.4][day];
        let side = if (day == 0) == (pose == 0) { "-1,1,1,1,1,1" } else { "1,1,1,1,1,1" };
        // The instrument shows the base's frame.
        let point_mm = [x + 300.0 + off_mm, y + 50.0, z + 600.0];
        (format!("P{pose},{},{side}", 5 * minute), q_deg, point_mm)
    };
    let columns = "pose_id,t_min,dir1,dir2,dir3,dir4,dir5,dir6";
    let frame = ComparisonFrame::AsMeasured(tool_m);
    let sides = file(columns, (0..40).map(row));
    assert!(sides.rows[0].earlier_min > 0.0, "two sessions");
    let found = performance(&sides, &robot, frame).unwrap();
    assert_eq!(found.multi_directional_m, None, "the sides were seen on different days");
    let one_side = |k: usize| {
        let (cells, q_deg, point_mm) = row(k);
        (cells.replace("-1,", "1,"), q_deg, point_mm)
    };
    let found = performance(&file(columns, (0..40).map(one_side)), &robot, frame).unwrap();
    for pose in &found.poses {
        let ap_mm: Vec<f64> = pose.times.iter().map(|time| 1e3 * time.accuracy.unwrap().ap_m).collect();
        // Each day's four cycles of the pose lie 25 min apart.
        assert_eq!(ap_mm.len(), 8, "{ap_mm:?}");
        assert!(ap_mm.iter().enumerate().all(|(k, mm)| (mm - [0.1, 0.4][k / 4]).abs() < 1e-3), "{ap_mm:?}");
        assert_eq!(pose.times[4].t_min, pose.times[0].t_min, "shown as the file has them");
    }
}

/// Of 6,400 rows 3,200 are asked whether they contradict the robot; in every 80th row x is 0, which others have near by.
#[test]
fn a_code_in_many_rows_is_not_judged_as_a_reading() {
    let robot = SerialArm::built_in("irb140").unwrap();
    let row = |k: usize| {
        let (q_deg, [x, y, z]) = cycle(k % 79, Vector3::new(0.05, -0.03, 0.12));
        let x = if k % 80 == 40 { 0.0 } else { x + 1e-3 * (k % 7) as f64 };
        (format!("P{}", k % 79), q_deg, [x, y, z])
    };
    let many = file("pose_id", (0..6400).map(row));
    let error = performance(&many, &robot, ComparisonFrame::Fitted).unwrap_err();
    let PerformanceError::Fault { reason } = &error else { panic!("{error}") };
    assert!(reason.contains("column x_mm is 0") && reason.contains("leave those cells empty"), "{reason}");
}

#[test]
fn a_fit_that_does_not_come_to_rest_is_named() {
    let at_rest = |converged: bool| Registration {
        converged,
        ..Registration::assumed(Isometry3::identity(), vec![Vector3::zeros()], Vec::new())
    };
    assert_eq!(unsettled(&at_rest(false)).unwrap().code, "measure::registration");
    assert_eq!(unsettled(&at_rest(true)), None);
}

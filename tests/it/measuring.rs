//! Measuring as people do: reflectors, nests, fixed points, lengths, two files and other layouts, each with a virtual robot
//! whose truth is known and whose physics is not the diagnosis's.

mod long;

use assert_cmd::Command;
use exam::effect::Effect;
use exam::generate::data_set;
use exam::harmonics::Harmonics;
use exam::recipe::Recipe;
use exam::rng::Rng;
use exam::virtual_robot::{Commanded, VirtualRobot};
use measurements::{ColumnMap, MatchBy, Measurements, Reading, Table, check_rows, join};
use metrology::diagnose::{
    DiagnosisOptions, Findings, RefitScope, Verdict, diagnose, diagnose_and_identify, validate,
};
use nalgebra::{Isometry3, Matrix3, Matrix3xX, Point3, UnitQuaternion, Vector3};
use robot_model::robot::{Axis, SerialArm};
use std::fmt::Write as _;
use std::fs;

const SIGMA_M: f64 = 2e-5;
/// Where the payload hangs in the generator.
const PAYLOAD_AT_M: [f64; 3] = [0.02, 0.0, 0.09];
const TIP_M: [f64; 3] = [0.06, -0.03, 0.11];
/// Three reflectors on the flange.
const REFLECTORS: [(&str, [f64; 3]); 3] =
    [("A", [0.08, 0.02, 0.05]), ("B", [-0.05, 0.07, 0.06]), ("C", [0.0, -0.09, 0.12])];

/// A virtual robot with one effect, and poses to measure it at.
struct Cell {
    robot: SerialArm,
    robot_under_test: VirtualRobot,
    at: Vec<Commanded>,
    rng: Rng,
}

impl Cell {
    fn new(effect: Effect, n: usize, seed: u64) -> Self {
        Self::with(vec![(effect, 8.0)], n, seed)
    }

    fn with(effects: Vec<(Effect, f64)>, n: usize, seed: u64) -> Self {
        let robot = SerialArm::built_in("irb140").unwrap();
        let recipe = Recipe { payloads_kg: [0.0, 5.0], ..crate::recipe::planted(effects, n) };
        let mut rng = Rng::new(seed, 0);
        let set = data_set(&robot, "irb140", &recipe, &mut rng).unwrap();
        let robot_under_test = VirtualRobot::from_truth(&robot, &set.truth);
        let read = Measurements::from_csv(set.csv.as_bytes()).unwrap();
        let at = read
            .rows
            .iter()
            .map(|row| Commanded {
                q_rad: row.q_rad,
                direction: row.direction.unwrap(),
                payload_kg: row.payload_kg.unwrap(),
                payload_at_m: PAYLOAD_AT_M,
            })
            .collect();
        Self { robot, robot_under_test, at, rng }
    }

    fn tip_m(&self, at: &Commanded, on_flange_m: [f64; 3]) -> Vector3<f64> {
        (self.robot_under_test.flange(at) * Point3::from(Vector3::from(on_flange_m))).coords
    }

    fn noise_m(&mut self) -> Vector3<f64> {
        Vector3::from(self.rng.normal3()) * SIGMA_M
    }

    /// The pose nearest to `at` whose tip is truly at `goal_m`.
    fn jogged(&self, at: &Commanded, goal_m: &Vector3<f64>) -> Option<Commanded> {
        const TURN_RAD: f64 = 1e-6;
        let mut now = *at;
        for _ in 0..40 {
            let here = self.tip_m(&now, TIP_M);
            let slope = Matrix3xX::from_fn(6, |r, j| {
                let mut turned = now;
                turned.q_rad[j] += TURN_RAD;
                (self.tip_m(&turned, TIP_M) - here)[r] / TURN_RAD
            });
            let normal: Matrix3<f64> = (&slope * slope.transpose()).fixed_view::<3, 3>(0, 0).into();
            let step = slope.transpose() * (normal.try_inverse()? * (goal_m - here));
            let shorter = (0.3 / step.norm()).min(1.0);
            for (q, by) in now.q_rad.iter_mut().zip(step.iter()) {
                *q += by * shorter;
            }
        }
        let reached = (self.tip_m(&now, TIP_M) - goal_m).norm() < 1e-7;
        (reached && self.robot.is_within_range(&now.q_rad)).then_some(now)
    }
}

const HEADER: &str = "q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,dir1,dir2,dir3,dir4,dir5,dir6,payload_kg";

fn cells(at: &Commanded) -> String {
    let joints: Vec<String> = at.q_rad.iter().map(|q| format!("{:.6}", q.to_degrees())).collect();
    let mut out = joints.join(",");
    for d in at.direction {
        write!(out, ",{d}").unwrap();
    }
    write!(out, ",{}", at.payload_kg).unwrap();
    out
}

fn mm(p: &Vector3<f64>) -> String {
    format!("{:.5},{:.5},{:.5}", p.x * 1e3, p.y * 1e3, p.z * 1e3)
}

fn answer(csv: &str) -> Findings {
    let robot = SerialArm::built_in("irb140").unwrap();
    let measurements = Measurements::from_csv(csv.as_bytes()).unwrap();
    diagnose(&measurements, &robot, &DiagnosisOptions { tool_m: None, sigma_m: Some(SIGMA_M) })
}

/// The first cause, and that nothing else is claimed.
fn assert_found(found: &Findings, effect: &str, joint: usize) {
    let first = found.causes.first().map(|c| (c.effect.name(), c.joint));
    let summary: Vec<_> = found.causes.iter().map(|c| (c.effect, c.joint, c.posterior)).collect();
    assert_eq!(
        first,
        Some((effect, Axis::numbered(joint))),
        "{:?} {} {summary:?}",
        found.verdict,
        found.reason
    );
    assert_eq!(found.verdict, Verdict::Explained, "{} {summary:?}", found.reason);
}

fn instrument_from_base() -> Isometry3<f64> {
    Isometry3::new(Vector3::new(2.0, -1.0, 0.3), Vector3::new(0.1, -0.2, 2.0))
}

#[test]
fn reflectors_under_each_others_names_are_exchanged() {
    let cell = Cell::new(Effect::JointCompliance { joint: 2 }, 30, 4);
    let mut csv = format!("pose_id,target,{HEADER},x_mm,y_mm,z_mm\n");
    for (k, at) in cell.at.iter().enumerate() {
        for (name, on_flange_m) in REFLECTORS {
            let seen = (instrument_from_base() * Point3::from(cell.tip_m(at, on_flange_m))).coords;
            let written = match name {
                "A" if k > 19 => "B",
                "B" if k > 19 => "A",
                name => name,
            };
            writeln!(csv, "{k},{written},{},{}", cells(at), mm(&seen)).unwrap();
        }
    }
    let found = answer(&csv);
    let fault = found.fault.unwrap();
    assert_eq!((fault.kind.name(), fault.column.as_deref()), ("exchanged_targets", Some("target")));
    // Lines 62 on, three a pose; the third reflector's are not among them.
    let exchanged: Vec<u64> = (62..92).filter(|line| (line - 62) % 3 != 2).collect();
    assert_eq!(fault.lines, exchanged);
}

/// An arm that stands 0.04 mm and 0.2 mrad elsewhere each time it comes, read by an instrument that is good to 0.01 mm, and what is
/// stated of the noise.
fn unsteady(mut cell: Cell, sigma_m: Option<f64>) -> Findings {
    let mut csv = format!("pose_id,target,{HEADER},x_mm,y_mm,z_mm\n");
    for (k, at) in cell.at.clone().iter().enumerate() {
        let [shift_m, turn_rad] = [4e-5, 2e-4].map(|sigma| Vector3::from(cell.rng.normal3()) * sigma);
        let targets = REFLECTORS.map(|(name, on_flange_m)| (name, cell.tip_m(at, on_flange_m)));
        let centre = targets.iter().map(|(_, tip_m)| tip_m).sum::<Vector3<f64>>() / 3.0;
        for (name, tip_m) in targets {
            let seen = tip_m + shift_m + turn_rad.cross(&(tip_m - centre)) + 0.5 * cell.noise_m();
            let seen = (instrument_from_base() * Point3::from(seen)).coords;
            writeln!(csv, "{k},{name},{},{}", cells(at), mm(&seen)).unwrap();
        }
    }
    let robot = SerialArm::built_in("irb140").unwrap();
    let options = DiagnosisOptions { tool_m: None, sigma_m };
    diagnose(&Measurements::from_csv(csv.as_bytes()).unwrap(), &robot, &options)
}

/// Touches of four fixed points, from as many of a cell's poses as reach them.
fn touched(cell: &mut Cell) -> String {
    let goals = [[0.45, -0.2, 0.3], [0.5, 0.25, 0.35], [0.35, 0.0, 0.55], [0.55, 0.05, 0.2]];
    let mut csv = format!("fixed_id,{HEADER}\n");
    let mut n = [0; 4];
    for (k, at) in cell.at.clone().iter().enumerate() {
        let which = k % goals.len();
        let goal_m = Vector3::from(goals[which]) + cell.noise_m();
        if let Some(touch) = cell.jogged(at, &goal_m) {
            n[which] += 1;
            writeln!(csv, "P{which},{}", cells(&touch)).unwrap();
        }
    }
    assert!(n.iter().all(|n| *n >= 12), "{n:?}");
    csv
}

#[test]
fn a_draw_wire_is_enough_to_see_a_gear_that_gives() {
    let mut cell = Cell::new(Effect::JointCompliance { joint: 2 }, 240, 3);
    let ends = [("W1", [1.3, 0.4, 0.05]), ("W2", [-0.2, -1.2, 1.1])];
    let mut csv = format!("fixed_id,{HEADER},length_mm\n");
    for (k, at) in cell.at.clone().iter().enumerate() {
        let (name, end) = ends[k % 2];
        let length = (cell.tip_m(at, TIP_M) - Vector3::from(end)).norm() + cell.noise_m().x;
        writeln!(csv, "{name},{},{:.5}", cells(at), length * 1e3).unwrap();
    }
    let found = answer(&csv);
    assert_found(&found, "joint_compliance", 2);
    // One number per pose: the floor is one coordinate's noise.
    let floor = found.shrink.floor_rms_mm.unwrap();
    assert!((floor / 0.02 - 1.0).abs() < 0.25, "{floor}");
}

/// A ballbar's circle: all points in a plane, so that lengths leave a way open for the fixed point, and no unit is wrong.
#[test]
fn a_ballbars_circle_is_no_fault() {
    let robot = SerialArm::built_in("irb1600-1.45").unwrap();
    let options = DiagnosisOptions { tool_m: Some(Vector3::new(0.12, 0.0, 0.0)), sigma_m: Some(2e-6) };
    let found = diagnose(&Measurements::from_csv(&fixture("ballbar_circle.csv")).unwrap(), &robot, &options);
    // An offset of a tenth of a millimetre at the tip, of which a circle shows a hundredth; the lengths leave the tip open, which stays where it is said to be.
    assert_ne!(found.verdict, Verdict::DataFault);
    let (before, after) = (found.shrink.before_rms_mm.unwrap(), found.shrink.after_rms_mm.unwrap());
    assert!((0.007..0.02).contains(&before) && after < 0.003, "{before} {after}");
}

/// What a model found in one file leaves of another, and what the nominal arm leaves, mm rms.
fn validated(learn: &str, test: &str) -> [f64; 2] {
    let robot = SerialArm::built_in("irb140").unwrap();
    let read = |csv: &str| Measurements::from_csv(csv.as_bytes()).unwrap();
    let options = DiagnosisOptions { tool_m: None, sigma_m: Some(SIGMA_M) };
    let model = diagnose_and_identify(&read(learn), &robot, &options).1.unwrap();
    let file = read(test);
    let rows = (&file, &*check_rows(&file, &robot).used);
    let found = validate(rows, &robot, &model, RefitScope::BaseAndTool, &[]).unwrap();
    let only_tool = validate(rows, &robot, &model, RefitScope::Base, &[]).unwrap();
    // The tip is the model's there: as good as it was found.
    assert!(only_tool.all.model.rms_mm < 2.0 * found.all.model.rms_mm, "{only_tool:?}");
    [found.all.model.rms_mm, found.all.nominal.rms_mm]
}

fn fixture(name: &str) -> Vec<u8> {
    fs::read(format!("fixtures/measuring/{name}")).unwrap()
}

fn mapped(file: &str, map: &str) -> Table {
    ColumnMap::from_toml(&String::from_utf8(fixture(map)).unwrap()).unwrap().table(&fixture(file)).unwrap()
}

/// Positions and joints of the poses, and minutes.
fn compare(there: &Measurements, within_m: f64) {
    let plain = Measurements::from_csv(&fixture("plain.csv")).unwrap();
    let poses: Vec<_> = there.rows.iter().filter(|r| r.reading.involves_arm()).collect();
    assert_eq!(poses.len(), plain.rows.len());
    for (a, b) in poses.iter().zip(&plain.rows) {
        let off = a.reading.position_m().unwrap() - b.reading.position_m().unwrap();
        assert!(off.amax() <= within_m, "line {}: {off}", a.line);
        assert_eq!(a.q_rad, b.q_rad, "line {}", a.line);
        assert_eq!(a.payload_kg, b.payload_kg);
        if there.channels.time {
            assert!((a.t_min.unwrap() - b.t_min.unwrap()).abs() < 1e-3, "line {}", a.line);
        }
    }
}

#[test]
fn other_programs_layouts_say_the_same() {
    let joints = mapped("robot_joints.csv", "robot_joints.toml");
    let joined = |file: &str, map: &str, by: MatchBy| {
        let joined = join(&mapped(file, map), &joints, by, 0.0).unwrap();
        assert!(joined.unmatched_points.is_empty() && joined.unmatched_joints.is_empty());
        Measurements::from_table(&joined.table).unwrap()
    };
    let sa = joined("sa_points.txt", "sa.toml", MatchBy::Id);
    compare(&sa, 1e-12);
    let nests: Vec<_> = sa.rows.iter().filter(|r| !r.reading.involves_arm()).collect();
    assert_eq!((nests.len(), &sa.fixed_points[..]), (6, &["N1", "N2", "N3"].map(String::from)[..]));
    assert_eq!(
        nests[4].reading,
        Reading::Nest {
            fixed_point: 1,
            position_m: Vector3::new(1.7000105, -0.9005, -0.7995),
            with_joints: false,
        }
    );

    let robodk = joined("robodk_tracker.csv", "robodk.toml", MatchBy::Order);
    assert!(robodk.channels.time);
    compare(&robodk, 1e-12);
    // Leica's list has three decimals.
    let leica = joined("leica.csv", "leica.toml", MatchBy::Order);
    assert!(leica.channels.time);
    compare(&leica, 0.51e-6);
}

#[test]
fn a_pose_in_six_numbers_becomes_point_and_orientation() {
    let tmac = Measurements::from_table(&mapped("tmac.csv", "tmac.toml")).unwrap();
    let plain = Measurements::from_csv(&fixture("plain.csv")).unwrap();
    assert!(tmac.channels.orientation);
    for (a, b) in tmac.rows.iter().zip(&plain.rows) {
        // Eight decimals of a radian, five of a degree.
        assert!(a.q_rad.iter().zip(&b.q_rad).all(|(a, b)| (a - b).abs() < 1e-7), "line {}", a.line);
        assert!((a.reading.position_m().unwrap() - b.reading.position_m().unwrap()).amax() < 1e-12);
    }
    // Line 2: about x, the turned y, the turned z; written out as a matrix, Craig (2005), appendix B.
    let [a, b, c] = [-41.9257_f64, 7.0767, -20.8072].map(f64::to_radians);
    let expected = Matrix3::new(
        b.cos() * c.cos(),
        -b.cos() * c.sin(),
        b.sin(),
        a.sin() * b.sin() * c.cos() + a.cos() * c.sin(),
        a.cos() * c.cos() - a.sin() * b.sin() * c.sin(),
        -a.sin() * b.cos(),
        a.sin() * c.sin() - a.cos() * b.sin() * c.cos(),
        a.cos() * b.sin() * c.sin() + a.sin() * c.cos(),
        a.cos() * b.cos(),
    );
    let seen: UnitQuaternion<f64> = tmac.rows[0].orientation.unwrap();
    assert!((seen.to_rotation_matrix().matrix() - expected).amax() < 1e-12);
}

#[test]
fn inches_metres_radians_and_hours_become_ours() {
    let map = "delimiter = \"tab\"\nlength_unit = \"inch\"\njoint_unit = \"rad\"\ntime_unit = \"h\"\n[columns]\n\
               t_min = \"hours\"\nx_mm = \"E\"\ny_mm = \"N\"\nz_mm = \"H\"\nq1_deg = 5\nq2_deg = 5\nq3_deg = 5\nq4_deg = 5\n\
               q5_deg = 5\nq6_deg = 5\n[constant]\npayload_kg = \"2.5\"\n";
    let map = ColumnMap::from_toml(map).unwrap();
    let table = map.table(b"hours\tE\tN\tH\tturn\n0.5\t10\t-20\t30\t0.5\n").unwrap();
    let row = Measurements::from_table(&table).unwrap().rows[0].clone();
    assert!((row.reading.position_m().unwrap() - Vector3::new(0.254, -0.508, 0.762)).amax() < 1e-15);
    assert_eq!((row.t_min, row.payload_kg), (Some(30.0), Some(2.5)));
    assert!(row.q_rad.iter().all(|q| (q - 0.5).abs() < 1e-15));
    let error = map.table(b"hours\tE\tN\tH\tturn\n0.5\tten\t-20\t30\t0.5\n").unwrap_err().to_string();
    assert_eq!(error, "line 2, column E: 'ten' is not a number");
    let error = map.table(b"hours\tE\tN\n1\t2\t3\n").unwrap_err().to_string();
    assert!(error.starts_with("column H is missing"), "{error}");
    let error = ColumnMap::from_toml("[columns]\nx = 1\n").unwrap_err().to_string();
    assert!(error.contains("x is no column"), "{error}");
}

#[test]
fn two_files_of_other_layouts_are_diagnosed_and_who_is_alone_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let joints = folder.path().join("joints.csv");
    // Line 5 (P4) is gone; a pose was driven that nobody measured.
    let text = String::from_utf8(fixture("robot_joints.csv")).unwrap();
    let mut lines: Vec<&str> = text.lines().collect();
    lines.remove(4);
    lines.push("P99;1,0;2,0;3,0;4,0;5,0;6,0;0,0");
    fs::write(&joints, lines.join("\n")).unwrap();
    let f = |name: &str| format!("fixtures/measuring/{name}");
    let mut command = Command::cargo_bin("driftpost").unwrap();
    command.args(["diagnose", "--points", &f("sa_points.txt"), "--columns", &f("sa.toml"), "--joints"]);
    command.arg(&joints).args(["--joints-columns", &f("robot_joints.toml"), "--json", "-"]);
    let output = command.output().unwrap();
    let answer = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{answer}");
    assert!(answer.contains("sa_points.txt: no joints for 1 row (line 10)"), "{answer}");
    assert!(answer.contains("joints.csv: no point for 1 row (line 37)"), "{answer}");
    let json: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(json["causes"][0]["effect"], "joint_compliance");
    assert_eq!(json["causes"][0]["joint"], 2);
}

//! Jobs beside those of others, timed by the processor time of this thread: `peers export FILE` and `peers export-calibration FILE` write
//! what the others are given, `peers JOB` does one round and prints nanoseconds for each answer. `peers beside-opw ROBOT COUNT` and `peers poses ROBOT
//! COUNT` are what `benches/peers/differential` looks at.

mod calibration;
mod differential;
mod numbers;
mod samples;

use nalgebra::{Isometry3, Translation3, UnitQuaternion, Vector3};
use robot_model::deform::Deformation;
use robot_model::kinematics::{CalibrationOptions, Chain, Chains, ClosedForm, calibrate, solve};
use robot_model::robot::Robot;
use rs_opw_kinematics::kinematic_traits::Kinematics;
use rs_opw_kinematics::kinematics_impl::OPWKinematics;
use rs_opw_kinematics::parameters::opw_kinematics::Parameters;
use std::f64::consts::FRAC_PI_2;
use std::fmt::Write as _;
use std::hint::black_box;
use std::time::Instant;
use std::{env, fs, io, thread};

/// The reference paper's 45 targets: flange poses in metres.
fn cube() -> Vec<Isometry3<f64>> {
    let orientation = UnitQuaternion::from_euler_angles(0.0, FRAC_PI_2, 0.0);
    let mut poses = Vec::new();
    for x in [0.400, 0.550, 0.700] {
        for z in [0.250, 0.400, 0.550] {
            for y in [0.300, 0.150, 0.0, -0.150, -0.300] {
                poses.push(Isometry3::from_parts(Translation3::new(x, y, z), orientation));
            }
        }
    }
    poses
}

const MANY: usize = 100_000;

struct Setup {
    robot: Robot,
    closed: ClosedForm,
    nominal: Chain,
    /// Minutes 0 to 180.
    minutes: Vec<Chain>,
    targets: Vec<(Isometry3<f64>, [f64; 6])>,
    opw: OPWKinematics,
}

impl Setup {
    fn new() -> Option<Self> {
        let robot = Robot::built_in("irb140")?;
        let closed = ClosedForm::new(&robot).ok()?;
        let deformation = Deformation::paper();
        let at = |t: u32| Chain::with_offsets(&robot, &deformation.offsets_at(f64::from(t)));
        let minutes = (0..=180).map(at).collect();
        let targets =
            cube().into_iter().filter_map(|pose| Some((pose, closed.branches(&pose)[1]?))).collect();
        let opw = OPWKinematics::new(Parameters {
            a1: 0.070,
            c1: 0.352,
            c2: 0.360,
            c3: 0.380,
            c4: 0.065,
            offsets: [0.0, 0.0, -FRAC_PI_2, 0.0, 0.0, 0.0],
            ..Parameters::new()
        });
        Some(Self { nominal: Chain::nominal(&robot), robot, closed, minutes, targets, opw })
    }

    /// For each minute seven placements (joint in the one before, at rest, turned so that it turns about z; the flange), each row
    /// by row and then its origin; then for each target its pose and its start.
    fn export(&self) -> String {
        let mut text = format!("{} {}\n", self.minutes.len(), self.targets.len());
        let mut write = |pose: &Isometry3<f64>| {
            let r = pose.rotation.to_rotation_matrix();
            let rows = (0..3).flat_map(|i| (0..3).map(move |j| (i, j))).map(|ij| r[ij]);
            let numbers = rows.chain(pose.translation.vector.iter().copied());
            numbers.for_each(|v| _ = write!(text, "{v:?} "));
            text.push('\n');
        };
        let turned = |i: usize| {
            let axis = self.robot.joints.get(i).map_or(Vector3::z_axis(), |joint| joint.axis);
            UnitQuaternion::rotation_between_axis(&Vector3::z_axis(), &axis)
                .unwrap_or(UnitQuaternion::from_axis_angle(&Vector3::x_axis(), std::f64::consts::PI))
        };
        for chain in &self.minutes {
            let mut before = Isometry3::identity();
            for (i, frame) in chain.frames(&[0.0; 6]).iter().enumerate() {
                let frame = frame * turned(i);
                write(&(before.inverse() * frame));
                before = frame;
            }
        }
        for (pose, _) in &self.targets {
            write(pose);
        }
        for (_, start) in &self.targets {
            start.iter().for_each(|q_rad| _ = write!(text, "{q_rad:?} "));
            text.push('\n');
        }
        text
    }
}

/// Processor time of this thread so far, ns.
fn processor_ns() -> f64 {
    let stat = fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    stat.split(' ').next().and_then(|ns| ns.parse().ok()).unwrap_or(f64::NAN)
}

/// Nanoseconds for each of `answers`, over a fifth of a second at least.
fn timed(answers: usize, mut work: impl FnMut()) -> f64 {
    work();
    let start = processor_ns();
    let mut rounds = 0;
    loop {
        work();
        rounds += 1;
        let ns = processor_ns() - start;
        if ns.is_nan() || ns > 2e8 {
            return ns / (rounds * answers) as f64;
        }
    }
}

fn main() -> io::Result<()> {
    if let [job, robot, count] = &env::args().skip(1).collect::<Vec<_>>()[..] {
        let count = count.parse().map_err(io::Error::other)?;
        match job.as_str() {
            "beside-opw" => println!("{}", differential::beside_opw(robot, count)?),
            "poses" => differential::write_poses(robot, count, io::BufWriter::new(io::stdout().lock()))?,
            _ => return Err(io::Error::other("no such job")),
        }
        return Ok(());
    }
    let Some(setup) = Setup::new() else { return Err(io::Error::other("the irb140 is not built in")) };
    let job = env::args().nth(1).unwrap_or_default();
    let joints: Vec<[f64; 6]> = setup.targets.iter().map(|(_, start)| *start).collect();
    let solves = setup.targets.len() * setup.minutes.len();
    let ns = match job.as_str() {
        "export" => {
            let file = env::args().nth(2).ok_or(io::Error::other("which file?"))?;
            return fs::write(file, setup.export());
        }
        "export-calibration" => {
            let file = env::args().nth(2).ok_or(io::Error::other("which file?"))?;
            let options = CalibrationOptions::default();
            let measured = calibration::measured(&setup.robot, &options);
            return fs::write(file, calibration::export(&setup.robot, &measured, &options));
        }
        // With the cost that is reached, to be compared with the peer's.
        "calibrate" => {
            let options = CalibrationOptions::default();
            let measured = calibration::measured(&setup.robot, &options);
            let found = calibrate(&setup.robot, &measured, &options).map_err(io::Error::other)?;
            let ns = timed(1, || {
                assert!(calibrate(black_box(&setup.robot), black_box(&measured), &options).is_ok());
            });
            println!("{ns:.0} {:.6}", found.cost);
            return Ok(());
        }
        "solve" => {
            let all = Chains::new(setup.minutes.clone());
            timed(solves, || {
                for (pose, start) in &setup.targets {
                    all.solve(pose, start, |found| assert!(black_box(found).is_ok()));
                }
            })
        }
        // 100,000 targets at all minutes on two threads: time on the wall, and the memory that the process took at most.
        "solve-many" => {
            let all = Chains::new(setup.minutes.clone());
            let start = Instant::now();
            thread::scope(|scope| {
                for half in 0..2 {
                    let (all, targets) = (&all, &setup.targets);
                    scope.spawn(move || {
                        for k in (half..MANY).step_by(2) {
                            let (mut pose, start) = targets[k % targets.len()];
                            // Another target each time: up to a millimetre beside.
                            pose.translation.vector.x += 1e-3 * (k as f64 / MANY as f64);
                            all.solve(&pose, &start, |found| assert!(black_box(found).is_ok()));
                        }
                    });
                }
            });
            let ns = start.elapsed().as_secs_f64() * 1e9 / (MANY * setup.minutes.len()) as f64;
            let status = fs::read_to_string("/proc/self/status")?;
            eprintln!("{}", status.lines().find(|line| line.starts_with("VmHWM")).unwrap_or_default());
            ns
        }
        "solve-one" => timed(solves, || {
            for (pose, start) in &setup.targets {
                for chain in &setup.minutes {
                    assert!(black_box(solve(chain, pose, start)).is_ok());
                }
            }
        }),
        "closed" => timed(100 * joints.len(), || {
            for _ in 0..100 {
                setup
                    .targets
                    .iter()
                    .for_each(|(pose, _)| _ = black_box(setup.closed.branches(black_box(pose))));
            }
        }),
        "closed-opw" => {
            let poses: Vec<_> = joints.iter().map(|q_rad| setup.opw.forward(q_rad)).collect();
            timed(100 * joints.len(), || {
                for _ in 0..100 {
                    poses.iter().for_each(|pose| _ = black_box(setup.opw.inverse(black_box(pose))));
                }
            })
        }
        "forward" => timed(100 * joints.len(), || {
            for _ in 0..100 {
                joints.iter().for_each(|q_rad| _ = black_box(setup.nominal.forward(black_box(q_rad))));
            }
        }),
        "forward-each" => timed(100 * joints.len(), || {
            for _ in 0..100 {
                setup.nominal.forward_each(black_box(&joints), |pose| _ = black_box(pose));
            }
        }),
        "forward-opw" => timed(100 * joints.len(), || {
            for _ in 0..100 {
                joints.iter().for_each(|q_rad| _ = black_box(setup.opw.forward(black_box(q_rad))));
            }
        }),
        // A number of a target's text, and the same by the standard library; both texts are the same.
        "write-num" | "write-num-std" => {
            let targets = numbers::targets();
            let (mut ours, mut by_std) = (Vec::new(), String::new());
            numbers::ours(&targets, &mut ours);
            numbers::by_std(&targets, &mut by_std);
            if ours != by_std.as_bytes() {
                return Err(io::Error::other("the two write different numbers"));
            }
            let count = targets.len() * numbers::NUMBERS;
            if job == "write-num" {
                timed(count, || {
                    ours.clear();
                    numbers::ours(black_box(&targets), black_box(&mut ours));
                })
            } else {
                timed(count, || {
                    by_std.clear();
                    numbers::by_std(black_box(&targets), black_box(&mut by_std));
                })
            }
        }
        _ => return Err(io::Error::other("no such job")),
    };
    println!("{ns:.1}");
    Ok(())
}

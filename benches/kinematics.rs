//! Speed of the kinematics: the reference paper's 8145 deformed solves, and the closed form beside rs-opw-kinematics.

#![allow(clippy::unwrap_used, missing_docs)]

use criterion::{Criterion, criterion_group, criterion_main};
use nalgebra::{Isometry3, Translation3, UnitQuaternion};
use robot_model::deform::Deformation;
use robot_model::kinematics::{Chain, ClosedForm, solve};
use robot_model::robot::Robot;
use rs_opw_kinematics::kinematic_traits::Kinematics;
use rs_opw_kinematics::kinematics_impl::OPWKinematics;
use rs_opw_kinematics::parameters::opw_kinematics::Parameters;
use std::f64::consts::FRAC_PI_2;
use std::hint::black_box;

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

/// 45 targets × 181 minutes, each solved from the nominal closed form and proved.
fn deformed(c: &mut Criterion) {
    let robot = Robot::built_in("irb140").unwrap();
    let closed = ClosedForm::new(&robot).unwrap();
    let deformation = Deformation::paper();
    let targets: Vec<_> = cube().into_iter().map(|pose| (pose, closed.branches(&pose)[1].unwrap())).collect();
    let chains: Vec<_> =
        (0..=180).map(|t| Chain::with_offsets(&robot, &deformation.offsets_at(f64::from(t)))).collect();
    c.bench_function("8145 deformed solves", |b| {
        b.iter(|| {
            for chain in &chains {
                for (target, start) in &targets {
                    black_box(solve(chain, target, start).unwrap());
                }
            }
        });
    });
}

fn closed_form(c: &mut Criterion) {
    let robot = Robot::built_in("irb140").unwrap();
    let closed = ClosedForm::new(&robot).unwrap();
    let opw = OPWKinematics::new(Parameters {
        a1: 0.070,
        c1: 0.352,
        c2: 0.360,
        c3: 0.380,
        c4: 0.065,
        offsets: [0.0, 0.0, -FRAC_PI_2, 0.0, 0.0, 0.0],
        ..Parameters::new()
    });
    let joints: Vec<[f64; 6]> = cube().iter().map(|pose| closed.branches(pose)[1].unwrap()).collect();
    let theirs: Vec<_> = joints.iter().map(|q_rad| opw.forward(q_rad)).collect();
    let chain = Chain::nominal(&robot);
    let ours: Vec<_> = joints.iter().map(|q_rad| chain.forward(q_rad)).collect();
    let mut group = c.benchmark_group("closed form, all branches of 45 poses");
    group.bench_function("driftpost", |b| {
        b.iter(|| ours.iter().for_each(|pose| _ = black_box(closed.branches(pose))));
    });
    group.bench_function("rs-opw-kinematics", |b| {
        b.iter(|| theirs.iter().for_each(|pose| _ = black_box(opw.inverse(pose))));
    });
    group.finish();
}

criterion_group!(benches, deformed, closed_form);
criterion_main!(benches);

//! The measurement file of a run: rows as an instrument in a place of its own records them.

use super::arm::Disturbance;
use super::effect::Effect;
use super::recipe::Recipe;
use super::rng::Rng;
use super::run::MeasuredRun;
use nalgebra::{Isometry3, Point3, UnitQuaternion, Vector3};
use robot_model::units::{deg_from_rad, m_from_mm, mm_from_m};
use std::fmt::Write as _;

/// The measurement file of a run whose points are off by `off_m`: what is recorded, in the order of the rows.
pub(super) fn csv(
    run: &MeasuredRun<'_>,
    recipe: &Recipe,
    poses: &[usize],
    effects: &[(Effect, f64)],
    background: &Disturbance,
    off_m: &[Vector3<f64>],
    rng: &mut Rng,
) -> String {
    let recorded = recipe.recorded;
    let turn = Vector3::new(rng.uniform(-0.3, 0.3), rng.uniform(-0.3, 0.3), rng.uniform(-3.0, 3.0));
    let instrument_from_base = Isometry3::new(
        Vector3::new(rng.uniform(-3.0, 3.0), rng.uniform(-3.0, 3.0), rng.uniform(-1.0, 1.0)),
        turn,
    );
    let reflector = UnitQuaternion::from_scaled_axis(Vector3::from(rng.normal3()));
    let has = |wanted: fn(&Effect) -> bool| effects.iter().any(|(e, _)| wanted(e));
    let rounded = has(|e| matches!(e, Effect::JointRounding));
    let swapped = has(|e| matches!(e, Effect::SwappedAxes));
    // Writing to a String cannot fail.
    let mut out = String::from("id,pose_id");
    if recorded.time {
        out += ",t_min";
    }
    let joints = run.arm.joints();
    for j in 0..joints {
        let unit = if run.arm.slides(j) { "mm" } else { "deg" };
        let _ = write!(out, ",q{}_{unit}", j + 1);
    }
    out += ",x_mm,y_mm,z_mm";
    if recorded.orientation {
        out += ",qw,qx,qy,qz";
    }
    if recorded.direction {
        for joint in 1..=joints {
            let _ = write!(out, ",dir{joint}");
        }
    }
    if recorded.payload {
        out += ",payload_kg";
    }
    if recorded.temperature {
        for joint in 1..=joints {
            let _ = write!(out, ",temp_j{joint}_c");
        }
        out += ",temp_air_c";
    }
    out.push('\n');
    for ((k, now), pose) in run.states.iter().enumerate().zip(poses) {
        // writing to a String cannot fail
        let _ = write!(out, "{k},{pose}");
        if recorded.time {
            let _ = write!(out, ",{:.2}", now.t_min);
        }
        for (j, q) in now.q_rad.into_iter().enumerate() {
            let deg = if run.arm.slides(j) { mm_from_m(q) } else { deg_from_rad(q) };
            let _ = if rounded { write!(out, ",{deg:.1}") } else { write!(out, ",{deg:.6}") };
        }
        let p = instrument_from_base * Point3::from(run.nominal_m[k] + off_m[k]);
        let [x, y, z] = [p.x, p.y, p.z].map(mm_from_m);
        let _ =
            if swapped { write!(out, ",{y:.4},{x:.4},{z:.4}") } else { write!(out, ",{x:.4},{y:.4},{z:.4}") };
        if recorded.orientation {
            // an orientation from three reflectors 0.1 m apart is as good as the points over that distance
            let blur = Vector3::from(rng.normal3()) * (m_from_mm(recipe.sigma_mm) / 0.1);
            let flange = run.flange(k, effects, background).0;
            let r = UnitQuaternion::from_scaled_axis(blur)
                * instrument_from_base.rotation
                * flange.rotation
                * reflector;
            let _ = write!(out, ",{:.8},{:.8},{:.8},{:.8}", r.w, r.i, r.j, r.k);
        }
        if recorded.direction {
            for d in now.direction {
                let _ = write!(out, ",{d}");
            }
        }
        if recorded.payload {
            let _ = write!(out, ",{:.2}", now.payload_kg);
        }
        if recorded.temperature {
            for warmer in now.warmer_k {
                let _ = write!(out, ",{:.2}", 21.0 + warmer + 0.1 * rng.normal());
            }
            let _ = write!(out, ",{:.2}", 21.0 + 0.1 * rng.normal());
        }
        out.push('\n');
    }
    out
}

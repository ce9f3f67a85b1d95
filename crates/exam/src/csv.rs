//! The measurement file of a run: rows as an instrument in a place of its own records them.

use super::arm::Disturbance;
use super::effect::{Effect, RowFault};
use super::recipe::Recipe;
use super::rng::Rng;
use super::run::MeasuredRun;
use nalgebra::{Isometry3, Point3, UnitQuaternion, Vector3};
use robot_model::units::{deg_from_rad, m_from_mm, mm_from_m};
use std::fmt::Write as _;

/// The joint that is in radians, counted from 0.
const RADIANS: usize = 2;
/// The beam is lost for one in so many rows.
const FROZEN: usize = 8;
const MM_PER_INCH: f64 = 25.4;

/// The measurement file of a run whose points are off by `off_m`: what is recorded, in the order of the rows. Those past the
/// recipe's number draw from the second stream.
pub(super) fn csv(
    run: &MeasuredRun<'_>,
    recipe: &Recipe,
    poses: &[usize],
    effects: &[(Effect, f64)],
    background: &Disturbance,
    off_m: &[Vector3<f64>],
    [rng, later]: [&mut Rng; 2],
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
    let points: Vec<Point3<f64>> = (0..run.states.len())
        .map(|k| instrument_from_base * Point3::from(run.nominal_m[k] + off_m[k]))
        .collect();
    let fault = effects.iter().find_map(|(effect, _)| match effect {
        Effect::RowFault { fault, from } => Some((*fault, (from * points.len() as f64) as usize)),
        _ => None,
    });
    for ((k, now), pose) in run.states.iter().enumerate().zip(poses) {
        let rng = if k < recipe.n { &mut *rng } else { &mut *later };
        // writing to a String cannot fail
        let _ = write!(out, "{k},{pose}");
        if recorded.time {
            let _ = write!(out, ",{:.2}", now.t_min);
        }
        for (j, q) in now.q_rad.into_iter().enumerate() {
            let in_radians = j == RADIANS && fault.is_some_and(|(fault, _)| fault == RowFault::Radians);
            let deg = match run.arm.slides(j) {
                true => mm_from_m(q),
                false if in_radians => q,
                false => deg_from_rad(q),
            };
            let _ = if rounded { write!(out, ",{deg:.1}") } else { write!(out, ",{deg:.6}") };
        }
        let p = points[match fault {
            Some((RowFault::Frozen, from)) if (from..from + points.len() / FROZEN).contains(&k) => from,
            Some((RowFault::OneLate, from)) if k > from => k - 1,
            _ => k,
        }];
        let [mut x, y, z] = match fault {
            Some((RowFault::Metres, from)) if k >= from => [p.x, p.y, p.z],
            _ => [p.x, p.y, p.z].map(mm_from_m),
        };
        if fault.is_some_and(|(fault, _)| fault == RowFault::Inches) {
            x /= MM_PER_INCH;
        }
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
